/* What a step is measured with: its errors by physical scales, the weights that follow from `accuracy` and a norm that
 * does not dilute a local event in a long chain, and the way that it takes the chain. docs/model.md, "Integration"
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
/* Largest over windows of SCALES_WINDOW neighbouring segments of the RMS of x w over the window's 13 components each.
 */
enum { SCALES_WINDOW = 16 };

double scales_norm(int n, const double *x, const double *weight);
/* The same for weights that are one number a component, those of scales_weights, of which only the first is read: sqrt
 * of the largest square over the windows of a chain of n segments. team: NULL, or who does it for long chains. */
typedef double WindowSquare(const void *owner, int from, int to, const double *x, const double *weight);

double scales_chain_norm(Team *team, int n, WindowSquare *square, const void *owner, const double *x,
                         const double *weight);
/* The segment with the largest sum of squares of x w; the first with a NaN, if any. x and w are `components` arrays
 * that begin `pitch` apart. */
int scales_worst_segment(int n, int pitch, int components, const double *x, const double *weight);
/* What Newton's iteration may leave of a correction, as a share of the tolerances (N13), and (N16) where something
 * grips. */
double scales_newton_share(const Scene *scene);
/* W of (N14): how far the chain may move in one step, m; INFINITY where there is nothing to touch. */
double stride_most(const Scene *scene);
/* Largest speed of a point of the chain, or up to sqrt(2) of it, m/s: sqrt(|v|^2 + (half |w|)^2) of n segments. v is
 * `dims` arrays `pitch` apart, w `turns` arrays. */
double stride_speed(const Chain *chain, int pitch, int dims, const double *v, int turns, const double *w);
/* The longest step, s, in which what has this speed (m/s), growing at this rate (m/s2), goes no farther than `way` (m)
 * (N15). */
double stride_longest(double way, double speed, double growth);
/* The chain in three dimensions, 13 numbers a segment (core/state.h), as the integrator sees it. */

typedef struct Spatial {
    Motion motion; /* first: a Motion is the Spatial that it begins */
    Workspace *ws;
    Newton *newton;
} Spatial;

/* Scene, workspace and Newton matrix are borrowed. Returns &s->motion. */
Motion *spatial_init(Spatial *s, const Scene *scene, Workspace *ws, Newton *newton);
/* What steps in time make of a pull that swings, and how long they may be then; and how fast it rises. A method of
 * second order takes of a fall what third differences of the pull say, whatever it swings by and wherever on a ramp.
 * docs/model.md, "Error bars". */

enum { SWINGS_STEPS = 4 }; /* whose third difference is taken */

typedef struct Swings {
    double t[SWINGS_STEPS], pull[SWINGS_STEPS]; /* s, N: of the last steps, the latest last */
    int steps;                                  /* that were seen */
    int downward;                               /* steps in a row in which the pull has fallen */
    double top, bottom;                         /* N: where it began to fall, and to rise, last */
    double risen_at;                            /* s: when it began to rise */
    double largest;                             /* N, of all steps */
    /* N: the most that the method takes of a fall so far (EB23) */
    double fades;
    /* N/s: the last rise where it was steepest (EB26) */
    double steepest;
    /* N/s^3: the third derivative, as it fades from its tops; s: the longest step, 0: none is asked for (EB25) */
    double third;
    double bound;
} Swings;

/* Takes in the pull at the end of a step, N at t. A scene without a longest step (no rows, none given) has no bound. */
void swings_step(Swings *swings, const Scene *scene, double t, double pull);
/* N: by how much the last rise went up. */
double swings_rise(const Swings *swings);

#endif
