/* Which parameters matter: Morris' elementary effects and Sobol's indices, from designs of the unit cube whose point i
 * is a function of seed and i. docs/model/94-studies.md, "Sensitivity". */
#ifndef HAWSER_STUDY_MATHS_SENSITIVITY_H
#define HAWSER_STUDY_MATHS_SENSITIVITY_H

#include "study/maths/points.h"

/* ------------------------------------------------------------------------------------------------------- Morris */

enum { MORRIS_LEVELS = 8 };

/* Trajectories of d+1 points, one coordinate changed a step (SE1): point i of trajectory i/(d+1), u[d]. */
void morris_point(uint64_t seed, uint64_t i, int d, double *u);

/* Effects of one parameter on one quantity, per unit of the cube. */
typedef struct MorrisEffect {
    long n;                     /* trajectories that count: both ends of the step are known */
    double mean, mean_size, sd; /* mu, mu*, sigma of (SE2); NAN where too few count */
    double mean_size_error;     /* half of the 95 % interval of mu*, NAN likewise */
} MorrisEffect;
/* y[trajectories * (d+1)], in the order of the points; not finite: not known. Fills effect[d]; 0 without memory. */
int morris_effects(uint64_t seed, int d, int trajectories, const double *y, MorrisEffect *effect);

/* -------------------------------------------------------------------------------------------------------- Sobol */

/* Blocks of d+2 points, (SE3): A, B, and A with one coordinate after the other from B. Point i of n*(d+2), u[d]; A and
 * B are one point of 2 d dimensions. d <= SOBOL_DIMENSIONS/2. */
void sobol_design_point(uint64_t seed, uint64_t i, int d, double *u);

/* A share of the variance with its 95 % interval. */
typedef struct SobolIndex {
    double first, first_low, first_high;
    double total, total_low, total_high;
} SobolIndex;
/* y[n*(d+2)] in the order of the points; a block with an unknown value does not count. (SE4), (SE5), intervals by
 * bootstrap over blocks. Fills index[d]; returns how many blocks count, -1 without memory. With fewer than two, or
 * without variance, all are NAN. */
int sobol_indices(uint64_t seed, int d, int n, const double *y, SobolIndex *index);

#endif
