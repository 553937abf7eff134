/* What the files of a certificate share: the figures of a simulation, and runs side by side. docs/model.md,
 * "Certificates". */
#ifndef HAWSER_IO_API_API_CERTIFY_H
#define HAWSER_IO_API_API_CERTIFY_H

#include <math.h>

#include "io/api/api_handles.h"

/* A figure as one run has it. */
typedef struct Figure {
    char name[96];
    const char *unit;
    double value; /* NAN: not known */
    double floor; /* below this size its error counts as that of one this large (CE6) */
} Figure;

typedef struct Figures {
    int n, room;
    Figure *figure; /* [n], owned */
} Figures;

/* The figures of a run that is over; two runs of a case have the same ones in the same order. Errors: MEMORY. */
hawser_status figures_take(hawser_sim *s, Figures *out, hawser_error *err);
/* Rotations of another run go on beyond half a turn where those of this one do. */
void figures_follow(const Figures *own, Figures *other);
/* One run with finer settings. */
typedef struct Companion {
    hawser_certify_run about; /* levels and what became of it */
    Figures figures;          /* empty if it failed */
    double evaluations;       /* of the rates, times segments */
    double share;             /* of its way, while it runs; 1: over */
    double seconds;           /* it has taken */
    double most;              /* of evaluations: where it needs more it is given up */
    int given_up;             /* it did */
} Companion;

/* What a round of runs needs to know. */
typedef struct CertifyRound {
    const SceneDef *def;
    int threads;
    int runs, over;             /* of the whole round; those of it that had ended before these began */
    hawser_certify_state state; /* round is set by the caller */
    hawser_certify_progress progress;
    void *user;
} CertifyRound;

/* What a refinement says of a figure's error: two or three values of it, each computed `ratio` times finer than the one
 * before. docs/model.md, "Certificates". */

/* Below this share of the order that was assumed, three values do not converge. */
static const double ORDER_LEAST = 0.25;

/* That many times the order that was assumed is believed at most: a finer value that lies nearer may do so by luck. */
static const double ORDER_MOST = 1.5;

typedef struct Refinement {
    double error; /* of the middle value, not negative, in the figure's unit; NAN if one of the values is not known */
    double order; /* observed; NAN: not enough values, or they do not come nearer from one side */
    int diverges; /* three values do not converge: the finer step changed about as much as the coarser one */
} Refinement;

/* The error that is left of a difference by a refinement of that order. (CE2) */
static inline double refinement_factor(double ratio, double order)
{
    const double gain = pow(ratio, order);
    return gain / (gain - 1);
}

/* coarse: NAN where there is none; then the order is taken to be `assumed`. A higher order is never used, a lower one
 * is. (CE2)-(CE4) */
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

/* The same where finer is not to be had: of a value that is `ratio` times finer than the coarse one. Two values show no
 * order, so that half of the assumed one is taken. (CE9) */
static inline Refinement refinement_from_coarser(double coarse, double value, double ratio, double assumed)
{
    return (Refinement){.error = fabs(coarse - value) / (pow(ratio, assumed / 2) - 1), .order = NAN};
}

#endif
