/* What is known of a run's numbers (hawser/hawser.h): error bars, passes, balances, and what kept its steps short.
 * Strings stay the library's. */
#ifndef HAWSER_NUMERICS_H
#define HAWSER_NUMERICS_H

#ifdef __cplusplus
extern "C" {
#endif

/* How far a figure may be off by the numbers alone, in its own unit (docs/model.md, "Error bars"). */
typedef struct hawser_error_bar {
    double time;     /* of the steps in time */
    double mesh;     /* of segments that are not a line */
    double friction; /* of friction that vanishes at rest */
    double total;    /* what is shown: "12.83 kN +- 0.02 %"; NAN: not known */
} hawser_error_bar;

/* One pass of a run: its settings, and what it found by itself. */
typedef struct hawser_pass {
    double accuracy;                         /* solver.accuracy, a share */
    int segments;                            /* of the whole chain */
    double friction;                         /* v_s over the case's */
    double pull_mean_N, pull_peak_N;         /* as in hawser_summary */
    double pull_mean_bar_N, pull_peak_bar_N; /* their error bars by what this pass alone shows */
    long steps;
    double wall_time_s;
} hawser_pass;

/* Why a run was computed again with finer settings, or not (docs/reference/limits.md, "Finer passes"). */
typedef struct hawser_passes {
    /* "replaced": figures are the last pass's; "compared": the first's, as the case gives settings, with error bars
     * from all; "failed", "declined": the first's alone */
    const char *outcome;
    char why[256];           /* what the first pass alone left open */
    char says[512];          /* what became of it, in a sentence */
    int n;                   /* passes that have figures, 1 to 3 */
    const hawser_pass *pass; /* [n] */
} hawser_passes;

/* One term of the balances of a run: what it has done, or how it has changed, since t = 0. */
typedef enum hawser_balance_kind {
    HAWSER_BALANCE_WORK,   /* done on cable, drums and rollers, J */
    HAWSER_BALANCE_LOSS,   /* turned into heat, J */
    HAWSER_BALANCE_STORED, /* more than at t = 0, J */
    HAWSER_BALANCE_IMPULSE /* on the cable, N s */
} hawser_balance_kind;
typedef struct hawser_balance_term {
    hawser_balance_kind kind;
    const char *name; /* lives for ever */
    double J;         /* in J; NAN of an impulse */
    double N_s[3];    /* 0 but of an impulse */
} hawser_balance_term;

/* Whether energy and momentum add up over a run (docs/model.md, "Balances"): what is stored more than at t = 0 against
 * the work done less what was lost, and the change of the cable's momentum against the impulses on it; `carried` is
 * what segments brought that joined, less what those took along that left. */
enum { HAWSER_BALANCE_TERMS = 48 };
typedef struct hawser_balance {
    double work_J, lost_J, stored_J, carried_J;
    double numerical_J;     /* what the steps in time took out of the motion: a loss that nature does not have */
    double residual_J;      /* stored - carried - (work - lost - numerical) */
    double turnover_J;      /* of what moves: the term that most went through, or the largest energy of motion */
    double residual_share;  /* size of the residual over the turnover */
    double numerical_share; /* size of the numerical loss over the same; 0 where the motion is below its tolerances */
    const char *turnover_of;
    double impulse_N_s[3], momentum_N_s[3], carried_N_s[3], residual_N_s[3];
    double impulse_residual_share; /* size of the residual over that of the largest impulse */
    int n_terms;
    hawser_balance_term term[HAWSER_BALANCE_TERMS]; /* [n_terms], those that there are */
} hawser_balance;

enum { HAWSER_WHERE_MAX = 64, HAWSER_HOLD_MAX = 448 };
/* What held a run up over some steps in a row: why they were no longer, and where. */
typedef struct hawser_hold {
    double from_s, to_s, step_s;                    /* of simulated time; the mean step */
    long steps, error_fails, newton_fails, strides; /* strides: steps cut so that nothing moves too far in one */
    char cause[16];                                 /* "newton", "error test", "stride", "longest step", "accuracy" */
    int segment;                                    /* where the local error is largest; of "stride": the fastest */
    char where[HAWSER_WHERE_MAX];                   /* the contact there that carries force; "": none */
    char says[HAWSER_HOLD_MAX];                     /* all of that in a sentence */
    char chain[HAWSER_WHERE_MAX];                   /* of several chains: whose segment it is; "": it is alone */
} hawser_hold;

/* What of a run was moved by positions in steady motion, without inertia (solver.motion). */
typedef struct hawser_quasi_static {
    long positions, iterations; /* positions; of Newton's method for them */
    long stretches, refused;    /* how often they began; how often they did not, for the pull was not theirs yet */
    double first_s, time_s;     /* when they first began; for how long they moved the run */
    double apart;    /* the largest difference of a stretch's first position from the mean pull before it, a share */
    double swing;    /* the most that the pull swung by as positions began, a share of its mean: what peaks lack */
    const char *why; /* why there were none and cannot be; NULL: there can be */
} hawser_quasi_static;

#ifdef __cplusplus
}
#endif

#endif
