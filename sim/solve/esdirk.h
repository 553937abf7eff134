/* A one-step method: diagonally implicit Runge-Kutta steps whose first stage is explicit (ESDIRK), stiffly accurate and
 * L-stable, with an embedded estimate of their error. Only the rates at the last step's end are passed from step to
 * step, so that the method needs no restart where the motion changes. docs/theory.md, "One-step integration". The rest
 * of the program uses it through sim/solve/integrator.h. */
#ifndef HAWSER_SIM_SOLVE_ESDIRK_H
#define HAWSER_SIM_SOLVE_ESDIRK_H

#include "sim/solve/motion.h"

enum { ESDIRK_STAGES = 5, ESDIRK_ORDER = 3, ESDIRK_NODES = 3 };

/* Number of a node that is a stage of the step before. */
#define ESDIRK_BEFORE(stage) (-1 - (stage))

/* Coefficients of the method (OS4). The last row of a is b: stiffly accurate. */
typedef struct EsdirkTableau {
    double gamma;                           /* a[i][i], i > 0 */
    double c[ESDIRK_STAGES];                /* a stage's place in the step */
    double a[ESDIRK_STAGES][ESDIRK_STAGES]; /* lower triangle */
    double embedded[ESDIRK_STAGES];         /* weights of the method of order - 1 */
    int node[ESDIRK_STAGES][ESDIRK_NODES];  /* stages whose rates give the guess for a stage's rates (OS8) */
} EsdirkTableau;
const EsdirkTableau *esdirk_tableau(void);

typedef struct Esdirk Esdirk;

/* Result of a step that was tried. */
typedef enum EsdirkEnd {
    ESDIRK_DONE,
    ESDIRK_NO_RATES,   /* the equations of motion were not finite at any step length */
    ESDIRK_NO_NEWTON,  /* Newton's iteration did not converge */
    ESDIRK_NO_FACTORS, /* the matrix could not be factored */
    ESDIRK_INEXACT,    /* the error stayed too large */
    ESDIRK_NO_MEMORY,  /* for the factors */
    ESDIRK_STUCK       /* the step needed is too small to change t */
} EsdirkEnd;

/* share: tolerance of Newton's iteration over that of the error; longest: a step, s (0: unlimited). The motion, y
 * [motion->size], its weights and the counts are borrowed; it counts rates, iterations, matrices and failures. NULL if
 * there is no memory. */
Esdirk *esdirk_new(Motion *motion, double *y, const double *weight, double share, double longest,
                   IntegratorStats *stats);
Esdirk *esdirk_free(Esdirk *e);
/* Makes one step from *t, not beyond `stop` (s): y and *t hold its end, or remain unchanged if it failed. */
EsdirkEnd esdirk_step(Esdirk *e, double stop, double *t);
/* The length of the next step, s; 0 before the first one. */
double esdirk_next(const Esdirk *e);
/* [size] the latest step's error by its embedded method; and the rates at its end (OS6). */
const double *esdirk_error(const Esdirk *e);
const double *esdirk_rates(const Esdirk *e);
/* Continues with another y and other weights, of the motion's new size; see integrator_reshape. 0 if there is no
 * memory. */
int esdirk_reshape(Esdirk *e, const Reshape *reshape, const double *weight);
void esdirk_checkpoint(Checkpoint *c, Esdirk *e);

#endif
