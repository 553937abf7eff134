/* Measures of a step: its errors by physical scales, the weights that follow from `accuracy` and a norm that does not
 * dilute a local event in a long chain, and the distance that the chain moves in it. docs/theory.md, "Integration"
 * (N10), (N11), (N14). */
#ifndef HAWSER_SIM_SOLVE_SCALES_H
#define HAWSER_SIM_SOLVE_SCALES_H

#include <math.h>

#include "core/team.h"
#include "sim/dynamics.h"
#include "sim/equipment/rollers.h"
#include "sim/scene.h"
#include "sim/solve/motion.h"
#include "sim/solve/newton.h"

/* Absolute tolerances: m, rad, m/s, rad/s (N10). */
typedef struct Tolerances {
    double position, rotation, velocity, omega;
} Tolerances;

Tolerances scales_tolerances(const Scene *scene);
/* weight [scene_state_size] = 1 / absolute tolerance of every component of the state. */
void scales_weights(const Scene *scene, double *weight);
/* Largest over windows of SCALES_WINDOW neighbouring segments of the RMS of x w over the window's 13 components
 * each. */
enum { SCALES_WINDOW = 16 };

double scales_norm(int n, const double *x, const double *weight);
/* The same for weights with one number per component, those of scales_weights, of which only the first is read: sqrt of
 * the largest square over the windows of a chain of n segments. team: NULL, or the threads for long chains. */
typedef double WindowSquare(const void *owner, int from, int to, const double *x, const double *weight);

double scales_chain_norm(Team *team, int n, WindowSquare *square, const void *owner, const double *x,
                         const double *weight);
/* Segment with the largest sum of squares of x w; the first with a NaN, if any. x and w are `components` arrays that
 * begin `pitch` apart. */
int scales_worst_segment(int n, int pitch, int components, const double *x, const double *weight);
/* Tolerance of Newton's iteration as a share of the error test's tolerances (N13), and (N16) with conveyors. */
double scales_newton_share(const Scene *scene);
/* W of (N14): largest motion of the chain in one step, m; INFINITY where there is nothing to touch. */
double stride_most(const Scene *scene);
/* Largest speed of a point of the chain, or up to sqrt(2) of it, m/s: sqrt(|v|^2 + (half |w|)^2) of n segments. v is
 * `dims` arrays `pitch` apart, w `turns` arrays. */
double stride_speed(const Chain *chain, int pitch, int dims, const double *v, int turns, const double *w);
/* Longest step, s, in which a point with this speed (m/s), growing at this rate (m/s2), moves no farther than `way` (m)
 * (N15). */
double stride_longest(double way, double speed, double growth);
/* The chain in three dimensions, 13 numbers per segment (core/state.h), as the integrator sees it. */

typedef struct Spatial {
    Motion motion; /* first: a pointer to it is one to the Spatial */
    Workspace *ws;
    Newton *newton;
} Spatial;

/* Scene, workspace and Newton matrix are borrowed. Returns &s->motion. */
Motion *spatial_init(Spatial *s, const Scene *scene, Workspace *ws, Newton *newton);
/* Error of the steps in time for an oscillating pull, and the resulting bound on their length; also the rate at which
 * the pull rises. The loss of a fall in a method of second order follows from third differences of the pull, whatever
 * oscillates and wherever it is on a ramp. docs/theory.md, "Error bars". */

enum { SWINGS_STEPS = 4 }; /* for a third difference */

typedef struct Swings {
    double t[SWINGS_STEPS], pull[SWINGS_STEPS]; /* s, N: of the last steps, the latest last */
    int steps;                                  /* number of steps recorded */
    int downward;                               /* steps in a row in which the pull has fallen */
    double top, bottom;                         /* N: at the last beginning of a fall, and of a rise */
    double risen_at;                            /* s: time when it began to rise */
    double largest;                             /* N, of all steps */
    /* N: largest loss of a fall to the method so far (EB23) */
    double fades;
    /* N/s: steepest slope of the last rise (EB26) */
    double steepest;
    /* N/s^3: third derivative, fading from its maxima; s: longest step, 0: not bounded (EB25) */
    double third;
    double bound;
} Swings;

/* Adds the pull at the end of a step, N at t. A scene without a longest step (no rows, none given) has no bound. */
void swings_step(Swings *swings, const Scene *scene, double t, double pull);
/* N: height of the last rise. */
double swings_rise(const Swings *swings);

#endif
