/* Common parts of the files for certificates: the figures of a simulation, and runs at the same time. docs/theory.md,
 * "Certificates". */
#ifndef HAWSER_IO_API_API_CERTIFY_H
#define HAWSER_IO_API_API_CERTIFY_H

#include <math.h>

#include "io/api/api_handles.h"

/* A figure of one run. */
typedef struct Figure {
    char name[96];
    const char *unit;
    double value; /* NAN: not known */
    double floor; /* a figure smaller than this is judged as if it had this size (CE6) */
} Figure;

typedef struct Figures {
    int n, room;
    Figure *figure; /* [n], owned */
} Figures;

/* Takes the figures of a finished run; two runs of a case have the same ones in the same order. Errors: MEMORY. */
hawser_status figures_take(hawser_sim *s, Figures *out, hawser_error *err);
/* Continues rotations of another run beyond half a turn where those of this one are. */
void figures_follow(const Figures *own, Figures *other);
/* One run with finer settings. */
typedef struct Companion {
    hawser_certify_run about; /* levels and outcome */
    Figures figures;          /* empty if it failed */
    double evaluations;       /* evaluations of the rates, times segments */
    double share;             /* progress of the run; 1: it has ended */
    double seconds;           /* time that it has taken */
    double most;              /* most evaluations: a run that needs more is stopped */
    int given_up;             /* it was stopped for that */
} Companion;

/* Data of a round of runs. */
typedef struct CertifyRound {
    const SceneDef *def;
    int threads;
    int runs, over;             /* runs of the whole round; runs that had ended before these began */
    hawser_certify_state state; /* round is set by the caller */
    hawser_certify_progress progress;
    void *user;
} CertifyRound;

/* Error of a figure from refinement: two or three values of it, each computed `ratio` times finer than the one before.
 * docs/theory.md, "Certificates". */

/* Share of the assumed order below which three values do not converge. */
static const double ORDER_LEAST = 0.25;

/* Largest accepted order, as a multiple of the assumed one: a finer value may be nearer by chance. */
static const double ORDER_MOST = 1.5;

typedef struct Refinement {
    double error; /* of the middle value, not negative, in the figure's unit; NAN if one of the values is not known */
    double order; /* observed; NAN: not enough values, or they do not approach from one side */
    int diverges; /* three values do not converge: the finer step changed about as much as the coarser one */
} Refinement;

/* Returns the remaining error as a factor on the difference by a refinement of that order. (CE2) */
static inline double refinement_factor(double ratio, double order)
{
    const double gain = pow(ratio, order);
    return gain / (gain - 1);
}

/* Estimates the error. coarse: NAN where there is none; then the order is `assumed`. An observed order is used only if
 * it is lower. (CE2)-(CE4) */
static inline Refinement refinement_of(double coarse, double value, double fine, double ratio, double assumed)
{
    const double before = coarse - value, after = value - fine, usual = refinement_factor(ratio, assumed);
    Refinement out = {.error = usual * fabs(after), .order = NAN};
    if (isnan(coarse) || isnan(after)) return out;
    if (before / after > 0) out.order = log(before / after) / log(ratio);
    out.diverges = fabs(after) > 0 && !(fabs(before) > pow(ratio, ORDER_LEAST * assumed) * fabs(after));
    if (out.diverges) {
        out.error = usual * fmax(fabs(before), fabs(after));
    } else if (out.order < assumed) {
        out.error = refinement_factor(ratio, out.order) * fabs(after);
    } else {
        out.error = usual * fmax(fabs(after), fabs(before) / pow(ratio, ORDER_MOST * assumed));
    }
    return out;
}

/* Does the same without a finer value, for a value that is `ratio` times finer than the coarse one. Two values show no
 * order, so that half of the assumed one is used. (CE9) */
static inline Refinement refinement_from_coarser(double coarse, double value, double ratio, double assumed)
{
    return (Refinement){.error = fabs(coarse - value) / (pow(ratio, assumed / 2) - 1), .order = NAN};
}

#endif
