/* Decides whether a scene can be solved in a plane, and finds that plane; converts points and attitudes to and from it.
 * docs/theory.md, "Planar chain" (PL1), (PL16), (PL17). */
#ifndef HAWSER_SIM_SOLVE_PLANAR_H
#define HAWSER_SIM_SOLVE_PLANAR_H

#include "contact/planar.h"
#include "core/machine.h"
#include "core/planar.h"
#include "core/state.h"
#include "linsolve/linsolve.h"
#include "sim/dynamics.h"
#include "sim/scene.h"
#include "sim/solve/motion.h"

enum { PLANE_WHY_MAX = 160 };

typedef struct Plane {
    Vec3 origin;           /* a point of it, m */
    Vec3 e1, e2, normal;   /* its axes, e1 x e2 = normal */
    Quat flat;             /* attitude of a segment whose axis is e1 */
    double in_y, in_z;     /* components of the segments' y and z axes along J a, the direction across a segment */
    double turn_y, turn_z; /* and along the normal */
} Plane;

/* Returns 1 if the whole scene is in *plane and the planar equations cover it; 0 if not, with the reason in `why`; -1
 * if there is no memory. Only what is known to fit is accepted: everything that is not checked here is refused. */
int plane_find(const Scene *scene, Plane *plane, char why[PLANE_WHY_MAX]);
/* Components of a vector in the plane; of a point relative to its origin. */
static inline double plane_1(const Plane *p, Vec3 v) { return v3_dot(v, p->e1); }

static inline double plane_2(const Plane *p, Vec3 v) { return v3_dot(v, p->e2); }

/* The vector x e1 + z e2. */
static inline Vec3 plane_vector(const Plane *p, double x, double z) { return v3_axpy(v3_scale(x, p->e1), z, p->e2); }

/* Projects the state in space, y [13 n] (core/state.h), onto the plane: out [PLANAR_SIZE * stride]. Angles follow each
 * other without jumps of more than half a turn. Returns the loss: the largest component off the plane of a position
 * (m), a velocity (m/s), an axis or an angular velocity (rad/s). */
double plane_press(const Plane *plane, int n, const double *y, double *out);
/* Converts back (PL17): exact up to rounding. */
void plane_lift(const Plane *plane, int n, const double *planar, double *y);
/* A planar scene: the data of sim/scene.h in the plane's coordinates, and the loads that it applies itself.
 * docs/theory.md, "Planar chain" (PL14); the laws are those of sim/dynamics.h and sim/equipment/ends.h. */

/* Gravity along the chain (F1), as Weight. */
typedef struct PlanarWeight {
    double gravity[2]; /* m/s2 */
    int lead_in;
    double lost[2];      /* gravity missing behind the start, m/s2 */
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
    int winch_slides;     /* 1: it lets the head's end slide across its direction (WI1a) */
    PlanarRoller *roller; /* [rollers] */
} PlanarScene;

/* Like weight_behind, weight_loads, and the ends' equipment (sim/equipment/ends.c). Weight is written, not added;
 * `from` is a multiple of LANES, and entries up to the next one after `to` are overwritten. tail_at: as in the
 * Workspace. */
int planar_weight_behind(const PlanarScene *ps, const double *y);
Push planar_tail(const PlanarScene *ps, const PlanarKinematics *kin, double t, double tail_at);
/* ------------------------------------------------------------------------------------------------------ kernels */

/* Loops over segments of the planar chain's motion (planar_lanes.c), once for every instruction set. */
typedef struct PlanarNewton PlanarNewton;

/* Power and force of the lead-in: W, and N along the plane's axes. */
typedef struct PlanarPower {
    double power, force[2];
} PlanarPower;

typedef struct PlanarSimKernels {
    /* planar_weight */
    PlanarPower (*weight)(const PlanarWeight *weight, const PlanarChain *chain, const PlanarKinematics *kin, int from,
                          int to, int behind, PlanarLoads *loads);
    /* z = gamma b_x of segments from..to-1; from is a multiple of LANES, as below */
    void (*eliminate)(PlanarNewton *nw, const double *b, int from, int to);
    /* x = M b_u + K z, rows from..to-1 and the padding of their last lane */
    void (*couple)(PlanarNewton *nw, const double *b, int from, int to);
    /* b from the velocities in x, segments from..to-1 */
    void (*expand)(const PlanarNewton *nw, double *b, int from, int to);
    /* Block rows from..to-1 of A. */
    void (*form)(PlanarNewton *nw, int from, int to);
    /* Largest over the windows of 16 segments in from..to-1 (from: a window's first) of the sum of (x w)^2 over the
     * window's six entries each, divided by 13 times the window's segments (PL18); w has one number per array; its
     * first entry is read. A NaN in x gives a NaN. */
    double (*window_square)(const PlanarChain *chain, int from, int to, const double *x, const double *w);
    /* Kinematics in space of all segments and the head's ghost (PL17). */
    void (*lift)(const Plane *plane, const PlanarChain *chain, const PlanarKinematics *from, Kinematics *to);
    /* Like BodyKernels.method_loss, for the whole chain; past [9 stride]: x z phi, their velocities, force and
     * moment. */
    MethodLoss (*method_loss)(const PlanarChain *chain, const double *y, const double *rates, double scale,
                              double *past);
} PlanarSimKernels;

ISA_KERNELS(PlanarSimKernels, planar_sim_kernels)

/* Newton's matrix of the planar chain: (1 - gamma J) delta = b over the six rates of a segment, with the positions and
 * angles eliminated: 3x3 blocks. docs/theory.md, "Planar chain" (PL15). */

/* The planar chain's Newton matrix (PL15). */
struct PlanarNewton {
    const PlanarChain *chain; /* borrowed */
    int middle;               /* segments before it are the first half; a multiple of LANES */
    PlanarBlocks k, d;        /* at the linearisation point */
    BlockChain a;             /* M - gamma D - gamma^2 K */
    double *z[3];             /* gamma times the positions' residuals; chain arrays */
    double *x;                /* [3 stride] reduced right-hand side and solution, row by row */
    double gamma;             /* s, of a */
    LinSolver *solver;
    Team *team; /* borrowed; NULL: one thread */
};

/* The chain in a plane, six numbers per segment (core/planar.h), as the integrator sees it: for scenes that plane_find
 * accepts. docs/theory.md, "Planar chain". */

/* Centres (m) and axes of the segments at some time. */
typedef struct PlanarStand {
    double *p[2], *a[2];
} PlanarStand;

typedef struct Planar {
    Motion motion; /* first: a pointer to it is one to the Planar */
    PlanarScene ps;
    PlanarNewton newton;
    Workspace *ws;                   /* borrowed: candidates, counters, and the data for samples */
    int middle;                      /* segments before it are the first half's */
    PlanarKinematics kin;            /* of the last evaluation */
    PlanarJointLoads joints;         /* of the last evaluation */
    PlanarLoads loads[PARTS];        /* weight, ends, first half's contacts; second half's contacts */
    PlanarContactModel model[PARTS]; /* the rollers in two halves, as ws->contact */
    PlanarStand at;                  /* at the last refresh of the candidates */
    double (*on_roller)[2];          /* [rollers] N */
    /* indices of near candidates, by planar_accept (PL19) */
    PlanarStand near;   /* positions when they were chosen */
    double near_usable; /* m that points of the line may move from there */
    double near_moved;  /* m, at the last accepted step */
    int wide;           /* 1: all candidates count as near */
} Planar;

/* Kinematics of (t, y), ghosts included. */
void planar_place(Planar *p, double t, const double *y);
/* Computes ydot [6 stride] at (t, y); friction scales friction and drag. Returns 0, or 1 if something is not finite. */
int planar_evaluate(Planar *p, double t, const double *y, double friction, double *ydot);
/* Computes the blocks k and d of p->newton at (t, y). */
void planar_blocks(Planar *p, double t, const double *y, double friction);
/* Finds new candidates if `always`, or if the kinematics of the last evaluation are too far from those of the last
 * search. Errors: MEMORY. */
hawser_status planar_refresh(Planar *p, double t, const double *y, int always, hawser_error *err);
/* Converts the scene to `plane`, given by plane_find; scene and workspace are borrowed. *motion is the motion to use.
 * Errors: MEMORY, and those of linsolver_new; then nothing is left allocated. */
hawser_status planar_new(Planar *p, const Scene *scene, const Plane *plane, Workspace *ws, const LinOptions *options,
                         hawser_error *err);
void planar_free(Planar *p);

#endif
