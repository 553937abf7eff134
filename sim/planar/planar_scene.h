/* A planar scene: what sim/scene.h holds, in the plane's coordinates; and the loads that it applies by itself.
 * docs/model.md, "Planar chain" (PL14); the laws are those of sim/weight.h and sim/equipment/ends.h. */
#ifndef HAWSER_SIM_PLANAR_PLANAR_SCENE_H
#define HAWSER_SIM_PLANAR_PLANAR_SCENE_H

#include "contact/planar/planar_contact.h"
#include "core/base/isa.h"
#include "core/push.h"
#include "sim/planar/plane.h"

/* Gravity along the chain (F1), as Weight. */
typedef struct PlanarWeight {
    double gravity[2]; /* m/s2 */
    int lead_in;
    double lost[2];      /* what of gravity is missing behind the start, m/s2 */
    double origin[2];    /* m */
    double direction[2]; /* unit */
    double blend, hold, hold_damping;
} PlanarWeight;

typedef struct PlanarScene {
    const Scene *scene; /* borrowed */
    Plane plane;
    PlanarChain chain;
    PlanarWeight weight;
    double winch_origin[2], winch_direction[2], winch_angle; /* m, unit, rad */
    int winch_slides;     /* it lets the head's end slide across its direction (WI1a) */
    PlanarRoller *roller; /* [rollers] */
} PlanarScene;

/* 0 if there is no memory (then nothing is allocated). */
int planar_scene_new(PlanarScene *ps, const Scene *scene, const Plane *plane);
void planar_scene_free(PlanarScene *ps);

/* Turns the winch's angle by whole turns to the one nearest to the last segment's, rad. */
void planar_scene_unwind(PlanarScene *ps, double last_angle);
/* Sets the head's ghost to what the winch does at time t. */
void planar_scene_ghosts(const PlanarScene *ps, double t, PlanarKinematics *kin);

/* As weight_behind_of, weight_loads, and the ends' room (sim/equipment/ends.c). Weight is written, not added; `from`
 * is a multiple of LANES, and entries up to the next one after `to` are overwritten. tail_at: as in the Workspace. */
int planar_weight_behind(const PlanarScene *ps, const double *y);
Push planar_weight(const PlanarScene *ps, const PlanarKinematics *kin, int from, int to, int behind,
                   PlanarLoads *loads);
Push planar_tail(const PlanarScene *ps, const PlanarKinematics *kin, double t, double tail_at);
Push planar_drag(const PlanarScene *ps, const PlanarKinematics *kin);
/* Where the tail is in the state y. */
double planar_tail_place(const PlanarScene *ps, const double *y, double t, double tail_at, int anew);
void planar_ends(const PlanarScene *ps, const PlanarKinematics *kin, double t, double friction, double tail_at,
                 PlanarLoads *loads);
void planar_applied_blocks(const PlanarScene *ps, const PlanarKinematics *kin, double t, double friction,
                           double tail_at, PlanarBlocks *k, PlanarBlocks *d);

/* ------------------------------------------------------------------------------------------------------ kernels */

/* Loops over segments of the planar chain's motion (planar_lanes.c), once for every instruction set. */
typedef struct PlanarNewton PlanarNewton;

/* What the lead-in does to the motion: W, and N along the plane's axes. */
typedef struct PlanarPower {
    double power, force[2];
} PlanarPower;

typedef struct PlanarSimKernels {
    /* planar_weight */
    PlanarPower (*weight)(const PlanarWeight *weight, const PlanarChain *chain, const PlanarKinematics *kin, int from,
                          int to, int behind, PlanarLoads *loads);
    /* z = gamma b_x of segments from..to-1; from is a multiple of LANES, as below */
    void (*eliminate)(PlanarNewton *nw, const double *b, int from, int to);
    /* x = M b_u + K z, rows from..to-1 and what fills their last lane */
    void (*couple)(PlanarNewton *nw, const double *b, int from, int to);
    /* b from the velocities in x, segments from..to-1 */
    void (*expand)(const PlanarNewton *nw, double *b, int from, int to);
    /* Block rows from..to-1 of A. */
    void (*form)(PlanarNewton *nw, int from, int to);
    /* Largest over the windows of 16 segments in from..to-1 (from: a window's first) of the sum of (x w)^2 over the
     * window's six entries each, divided by 13 times the window's segments (PL18); w is one number an array, of which
     * the first is read. A NaN in x gives a NaN. */
    double (*window_square)(const PlanarChain *chain, int from, int to, const double *x, const double *w);
    /* Kinematics in space of all segments and the head's ghost (PL17). */
    void (*lift)(const Plane *plane, const PlanarChain *chain, const PlanarKinematics *from, Kinematics *to);
    /* As BodyKernels.method_loss, for the whole chain; past [9 stride]: x z phi, their velocities, force and moment. */
    MethodLoss (*method_loss)(const PlanarChain *chain, const double *y, const double *rates, double scale,
                              double *past);
} PlanarSimKernels;

ISA_KERNELS(PlanarSimKernels, planar_sim_kernels)

#endif
