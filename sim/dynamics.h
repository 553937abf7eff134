/* The chain's weight, and the part of it that the lead-in behind the route bears. docs/theory.md, "Loads" (F1). */
#ifndef HAWSER_SIM_DYNAMICS_H
#define HAWSER_SIM_DYNAMICS_H

#include "core/state.h"
#include "core/team.h"
#include "sim/scene.h"

/* Number of segments, from the tail on, that have not passed the route's start by `past` m; 0 without a lead-in. p[c]
 * are the coordinates of their centres. A segment that has passed it stays passed where the route turns back behind the
 * start. */
int weight_behind(const Scene *scene, const double *const p[3], double past);
/* The same for n segments with `dims` coordinates; 0 if the lead-in holds the cable and the tail is off its line. */
int weight_first_past(int n, int dims, const double *const p[], const double *origin, const double *direction, int held,
                      double past);
/* Adds the derivatives of these loads to the diagonal blocks of k and d. */
void weight_blocks(const Scene *scene, const Kinematics *kin, BlockChain *k, BlockChain *d);
/* The equations of motion of a scene: loads, right-hand side and its derivative blocks. docs/theory.md, "Corridor".
 * Everything here is a pure function of (t, y), given a workspace whose contact candidates are fresh enough. */

enum { PARTS = 2 }; /* parts into which the work is split, whatever the number of threads: results never depend on it */

/* Contacts of one half of the rollers, and of one half of the chain with surfaces. */
typedef struct ContactPart {
    int first; /* first of its rollers in the scene */
    ContactModel model;
    ContactPairs pairs;   /* by contact_refresh */
    SurfacePairs surface; /* pairs of one half of the elements, by surface_refresh */
    int sticks;           /* 1 if some friction sticks: its lean is kept from step to step */
    double seconds;       /* s spent in forces, in all */
} ContactPart;

/* Lets the caller stop a long computation: the function is called now and then; any result but 0 stops. */
typedef struct StopCheck {
    int (*ask)(void *user); /* NULL: never stopped */
    void *user;
    int firm; /* not called while a relaxation has made contacts soft */
} StopCheck;

int stop_wanted(const StopCheck *check);
/* Motion of a head that is joined to another chain (sim/solve/chains.c): that of the other chain's winch. */
typedef struct Led {
    int present;
    double travel, speed; /* m, m/s */
} Led;

/* Scratch of one evaluation, grouped by what computes it. It can be discarded, except for kin.slip and what equipment
 * kinds keep from step to step. */
struct Workspace {
    const Scene *scene;    /* borrowed */
    Team *team;            /* borrowed; NULL: one thread */
    int middle;            /* the first part's segments are those before it; a multiple of LANES */
    Kinematics kin;        /* body_kernels: kinematics; scene_ghosts */
    JointLoads joints;     /* bushing_kernels: loads */
    Loads loads[PARTS];    /* on segments: [0] weight and loads of part 0, [1] loads of part 1 */
    double *law[6];        /* bushing_kernels: law; [n+1] */
    void *room[ROOMS_MAX]; /* of each equipment kind; those that others read too: */
    ContactPart contact[PARTS];
    SelfPairs self;                  /* cable on cable */
    struct EquipmentWork *equipment; /* moving rollers (sim/equipment/rollers.h); NULL without rollers */
    Vec3 *on_roller;                 /* [rollers] N, by the last dynamics_look */
    SurfaceModel surfaces;           /* the scene's; softened by the relaxation */
    SurfaceTally *on_surface;        /* [surfaces] by the last dynamics_look */
    double tail_at;                  /* m along the route, of the tail's end after the last step */
    double head_pull;                /* N, on the chain's head, by the last dynamics_look */
    Led led;                         /* by the last dynamics_look */
    /* power and force of joints and lead-in on the motion at the last evaluation; contacts have their own sums */
    JointPower joint_power[PARTS];
    Push lead_in[PARTS];
    long rhs_evals, refreshes;
    int candidates_max;
    StopCheck stop; /* set by the caller */
};

/* Returns 0 if there is no memory. */
int workspace_alloc(Workspace *ws, const Scene *scene, Team *team);
void workspace_free(Workspace *ws);
/* Replaces the workspace of a scene whose chain has changed its length, with `joined` segments more behind the tail:
 * new arrays; the counters and what is not scratch are kept. Returns 0 if there is no memory; then nothing has
 * changed. */
int workspace_renew(Workspace *ws, const Scene *scene, int joined);
/* Saves or loads what a step leaves in the workspace and in the equipment kinds for the next one. */
void workspace_checkpoint(Checkpoint *c, Workspace *ws);
/* Computes kin from (t, y), and the poses of the equipment. */
void dynamics_kinematics(const Scene *scene, Workspace *ws, double t, const double *y);
/* Computes ydot [scene_state_size] from (t, y); friction scales every friction and drag force (1, or 0 for the
 * relaxation). */
void dynamics_rates(const Scene *scene, Workspace *ws, double t, const double *y, double friction, double *ydot);
/* The three stages of dynamics_rates, for chains that act on each other: kinematics; loads on the chain, into
 * ws->loads, to which others may add; rates. */
void dynamics_pose(const Scene *scene, Workspace *ws, double t, const double *y, double friction);
void dynamics_loads(const Scene *scene, Workspace *ws, double t, double friction);
void dynamics_motion(const Scene *scene, Workspace *ws, double t, const double *y, double friction, double *ydot);
/* Computes k and d (6x6 blocks; those off their diagonals in ws->self.extras) at (t, y): the derivatives of force and
 * moment minus inertia times ydot, see body_blocks. Leaves the kinematics of y in the workspace. */
void dynamics_blocks(const Scene *scene, Workspace *ws, double t, const double *y, const double *ydot, double friction,
                     BlockChain *k, BlockChain *d);
/* Power and force of the ground before the tail (joint 0) or behind the head (joint n) through that joint (BA2), for
 * the kinematics and joint loads in the workspace. */
Push dynamics_ghost_push(const Moment *m, int joint);
/* Computes the force of the cable ahead on segment 0, into ws->joints of joint 1, for the kinematics in the
 * workspace. */
void dynamics_tail_pull(const Scene *scene, Workspace *ws);
/* Sets the stiffness of contacts to `share` of the scene's, for the relaxation; 1 restores it. */
void dynamics_soften(const Scene *scene, Workspace *ws, double share);
/* Puts into the workspace what a sample of (t, y) reads: kinematics, the joints' law, the figures of the equipment, and
 * in ws->loads the forces of all contacts, nothing else. Returns the number of contacts that carry force. */
int dynamics_look(const Scene *scene, Workspace *ws, double t, const double *y);
/* Wall time spent in contact forces so far, s. */
double dynamics_contact_seconds(const Workspace *ws);
/* Number of candidate pairs in the workspace. */
int dynamics_candidates(const Workspace *ws);
/* Accepts a step to (t, y): updates the sliders of bending (bushing_slip) and the leans of friction that sticks. Both
 * are part of the state, beside y. Leaves the kinematics of y in the workspace if there are any of them. */
void dynamics_accept(const Scene *scene, Workspace *ws, double t, const double *y);
/* Finds new candidate pairs for the position y if `always`, or if something has moved too far since the last ones by
 * the kinematics in the workspace, which must belong to y or to an iterate close to it. Errors: MEMORY. */
hawser_status dynamics_refresh(const Scene *scene, Workspace *ws, double t, const double *y, int always,
                               hawser_error *err);
/* Finds new candidate pairs for the kinematics in the workspace. Errors: MEMORY. */
hawser_status dynamics_find_candidates(const Scene *scene, Workspace *ws, hawser_error *err);
/* ---- The terms of the balances at one state, from what the equations of motion have computed there
 * (sim/run/balance.c). docs/theory.md, "Balances" (BA1)-(BA8). */
/* Adds the sums of the last evaluation of the equations of motion, without the equipment: joints, lead-in. */
void balance_gather(const Workspace *ws, BalanceRates *out);
/* Computes all rates of a chain in space: those of balance_gather at the last evaluation, the others at (t, y), for
 * which it updates the kinematics of the chain's first and last segments. Overwrites out. */
void balance_spatial(const Scene *scene, Workspace *ws, double t, const double *y, BalanceRates *out);
/* Computes the stored energy and momentum at the kinematics in the workspace, and in the equipment by the last
 * evaluation, which must have been there; own: the equipment's part of that state (NULL: there is none). */
void balance_stock(const Scene *scene, Workspace *ws, const double *own, BalanceStock *out);

#endif
