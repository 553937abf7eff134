/* Numerical quality of a run (hawser/hawser.h): error bounds, passes, balances, and causes of short steps. Strings stay
 * the library's. */
#ifndef HAWSER_NUMERICS_H
#define HAWSER_NUMERICS_H

#ifdef __cplusplus
extern "C" {
#endif

/* Numerical error bound of a figure, in its own unit (docs/theory.md, "Error bars"). */
typedef struct hawser_error_bar {
    double time;     /* part of the steps in time */
    double mesh;     /* part of the mesh: segments are not a continuous line */
    double friction; /* part of friction that vanishes at rest */
    double total;    /* the bound that is shown: "12.83 kN +- 0.02 %"; NAN: not known */
} hawser_error_bar;

/* One pass of a run: its settings and its own results. */
typedef struct hawser_pass {
    double accuracy;                         /* solver.accuracy, a share */
    int segments;                            /* number in the whole chain */
    double friction;                         /* v_s over the case's */
    double pull_mean_N, pull_peak_N;         /* as in hawser_summary */
    double pull_mean_bar_N, pull_peak_bar_N; /* their error bounds from this pass alone */
    long steps;
    double wall_time_s;
} hawser_pass;

/* Finer passes of a run: the reason for them, or for their absence (docs/guide/simulate.md, "Passes"). */
typedef struct hawser_passes {
    /* "replaced": figures are the last pass's; "compared": the first's, with the case's own settings and error bounds
     * from all passes; "failed", "declined": the first's alone */
    const char *outcome;
    char why[256];           /* what the first pass left undecided */
    char says[512];          /* their outcome, in a sentence */
    int n;                   /* passes that have figures, 1 to 3 */
    const hawser_pass *pass; /* [n] */
} hawser_passes;

/* One term of the balances of a run: the work, loss, change or impulse since t = 0. */
typedef enum hawser_balance_kind {
    HAWSER_BALANCE_WORK,   /* done on cable, drums and rollers, J */
    HAWSER_BALANCE_LOSS,   /* turned into heat, J */
    HAWSER_BALANCE_STORED, /* change since t = 0, J */
    HAWSER_BALANCE_IMPULSE /* on the cable, N s */
} hawser_balance_kind;
typedef struct hawser_balance_term {
    hawser_balance_kind kind;
    const char *name; /* lives for ever */
    double J;         /* in J; NAN of an impulse */
    double N_s[3];    /* 0 but of an impulse */
} hawser_balance_term;

/* Balances of energy and momentum over a run (docs/theory.md, "Balances"): the change of stored energy since t = 0
 * against the work done less the losses, and the change of the cable's momentum against the impulses on it; `carried`
 * is what joining segments brought less what leaving segments took along. */
enum { HAWSER_BALANCE_TERMS = 48 };
typedef struct hawser_balance {
    double work_J, lost_J, stored_J, carried_J;
    double numerical_J;     /* energy that the steps in time took out of the motion: a loss that nature does not have */
    double residual_J;      /* stored - carried - (work - lost - numerical) */
    double turnover_J;      /* scale of the balance: the largest term, or the largest kinetic energy */
    double residual_share;  /* size of the residual over the turnover */
    double numerical_share; /* size of the numerical loss over the same; 0 where the motion is below its tolerances */
    const char *turnover_of;
    double impulse_N_s[3], momentum_N_s[3], carried_N_s[3], residual_N_s[3];
    double impulse_residual_share; /* size of the residual over that of the largest impulse */
    int n_terms;
    hawser_balance_term term[HAWSER_BALANCE_TERMS]; /* [n_terms] */
} hawser_balance;

enum { HAWSER_WHERE_MAX = 64, HAWSER_HOLD_MAX = 448 };
/* Cause and place of the shortest steps of a run, over some steps in a row. */
typedef struct hawser_hold {
    double from_s, to_s, step_s;                    /* simulated time; the mean step */
    long steps, error_fails, newton_fails, strides; /* strides: steps cut so that nothing moves too far in one */
    char cause[16];                                 /* "newton", "error test", "stride", "longest step", "accuracy" */
    int segment;                                    /* where the local error is largest; for "stride": the fastest */
    char where[HAWSER_WHERE_MAX];                   /* the contact there that carries force; "": none */
    char says[HAWSER_HOLD_MAX];                     /* all of this in a sentence */
    char chain[HAWSER_WHERE_MAX];                   /* for several chains: the chain of the segment; "": there is one */
} hawser_hold;

/* Part of a run that was moved by positions in steady motion, without inertia (solver.motion). */
typedef struct hawser_quasi_static {
    long positions, iterations; /* number of positions; Newton iterations for them */
    long stretches, refused; /* how often they began; how often they did not, because the pull differed from theirs */
    double first_s, time_s;  /* when they first began; how long they moved the run */
    double apart;    /* largest difference of a stretch's first position from the mean pull before it, a share */
    double swing;    /* largest swing of the pull as positions began, a share of its mean: what peaks lack */
    const char *why; /* reason why positions are not possible; NULL: they are */
} hawser_quasi_static;

#ifdef __cplusplus
}
#endif

#endif
