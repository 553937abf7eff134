/* What a refinement says of a figure's error: two or three values of it, each computed `ratio` times finer than the one
 * before. docs/model.md, "Certificates". */
#ifndef HAWSER_CORE_BASE_REFINEMENT_H
#define HAWSER_CORE_BASE_REFINEMENT_H

#include <math.h>

/* Below this share of the order that was assumed, three values do not converge. */
static const double ORDER_LEAST = 0.25;

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

/* coarse: NAN where there is none; then the order is taken to be `assumed`. It is never taken to be higher: what was
 * observed of three values may be luck. (CE2)-(CE4) */
static inline Refinement refinement_of(double coarse, double value, double fine, double ratio, double assumed)
{
    const double before = coarse - value, after = value - fine;
    Refinement out = {.error = fabs(after) * refinement_factor(ratio, assumed), .order = NAN};
    if (isnan(coarse) || isnan(after) || after == 0) return out;
    if (before / after > 0) out.order = log(before / after) / log(ratio);
    out.diverges = !(fabs(before) > pow(ratio, ORDER_LEAST * assumed) * fabs(after));
    if (out.diverges) {
        out.error = fmax(fabs(before), fabs(after)) * refinement_factor(ratio, assumed);
    } else if (out.order < assumed) {
        out.error = fabs(after) * refinement_factor(ratio, out.order);
    }
    return out;
}

#endif
