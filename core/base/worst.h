/* The largest and the smallest of what was found. fmax(x, NAN) is x: who accumulates an error with it loses every NAN.
 */
#ifndef HAWSER_CORE_BASE_WORST_H
#define HAWSER_CORE_BASE_WORST_H

#include <math.h>

/* The larger of the two; NAN if one of them is, so that a NAN stays to the end of a loop and every bound refuses it. */
static inline double larger_of(double a, double b) { return isnan(a) || a >= b ? a : b; }

/* The smaller; NAN likewise. */
static inline double smaller_of(double a, double b) { return isnan(a) || a <= b ? a : b; }

#endif
