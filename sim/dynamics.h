/* The chain's weight, and what the lead-in behind the route takes of it. docs/model.md, "Loads" (F1). */
#ifndef HAWSER_SIM_DYNAMICS_H
#define HAWSER_SIM_DYNAMICS_H

#include "core/state.h"
#include "core/team.h"
#include "sim/scene.h"

/* How many segments from the tail on have not passed the route's start by `past` m; 0 without a lead-in. p[c] are their
 * centres' coordinates. What has passed it stays so where the route turns back, behind the start. */
int weight_behind(const Scene *scene, const double *const p[3], double past);
/* The same for n of them, with `dims` coordinates; none where the lead-in holds what it has, and the tail is elsewhere.
 */
int weight_first_past(int n, int dims, const double *const p[], const double *origin, const double *direction, int held,
                      double past);
/* Adds the derivatives of that to the diagonal blocks of k and d. */
void weight_blocks(const Scene *scene, const Kinematics *kin, BlockChain *k, BlockChain *d);
/* The equations of motion of a scene: loads, right-hand side and its derivative blocks. docs/model.md, "Corridor".
 * Everything here is a pure function of (t, y), given a workspace whose contact candidates are fresh enough. */

enum { PARTS = 2 }; /* into which the work is split, whatever the number of threads: results never depend on it */

/* Contacts of one half of the rollers, and of one half of the chain with surfaces. */
typedef struct ContactPart {
    int first; /* its first roller of the scene's */
    ContactModel model;
    ContactPairs pairs;   /* contact_refresh */
    SurfacePairs surface; /* of one half of the elements; surface_refresh */
    int sticks;           /* some friction remembers, from step to step, how far it leans */
    double seconds;       /* s spent in forces, summed */
} ContactPart;

/* Who may want what takes long to end early: asked now and then, anything but 0 stops it. */
typedef struct StopCheck {
    int (*ask)(void *user); /* NULL: nobody */
    void *user;
    int firm; /* is not to be asked while a relaxation has made contacts soft */
} StopCheck;

int stop_wanted(const StopCheck *check);
/* How a head goes that is joined to another chain (sim/bunch): with that one's winch. */
typedef struct Led {
    int present;
    double travel, speed; /* m, m/s */
} Led;

/* Scratch of one evaluation, grouped by what computes it; discardable but for what rooms carry over and kin.slip. */
struct Workspace {
    const Scene *scene;    /* borrowed */
    Team *team;            /* borrowed; NULL: one thread */
    int middle;            /* segments before it are the first part's; a multiple of LANES */
    Kinematics kin;        /* body_kernels: kinematics; scene_ghosts */
    JointLoads joints;     /* bushing_kernels: loads */
    Loads loads[PARTS];    /* on segments: weight and what acts in part 0; what acts in part 1 */
    double *law[6];        /* bushing_kernels: law; [n+1] */
    void *room[ROOMS_MAX]; /* the rooms' own; and what others ask for too: */
    ContactPart contact[PARTS];
    SelfPairs self;                  /* cable on cable */
    struct EquipmentWork *equipment; /* rollers that move (sim/equipment/rollers.h); NULL without rollers */
    Vec3 *on_roller;                 /* [rollers] their room's look, N */
    SurfaceModel surfaces;           /* the scene's; the relaxation softens it */
    SurfaceTally *on_surface;        /* [surfaces] their room's look */
    double tail_at;                  /* m along the route, of the tail's end after the last step */
    double head_pull;                /* N, on the chain's head, of the last look */
    Led led;                         /* of the last look */
    /* what the last evaluation found to be done to the motion, beside the sums of the contacts */
    JointPower joint_power[PARTS];
    Push lead_in[PARTS];
    long rhs_evals, refreshes;
    int candidates_max;
    StopCheck stop; /* the caller's */
};

/* 0 if there is no memory. */
int workspace_alloc(Workspace *ws, const Scene *scene, Team *team);
void workspace_free(Workspace *ws);
/* The workspace of a scene whose chain has changed its length, with `joined` segments more behind the tail: new arrays,
 * but what is not scratch stays, and the counters. 0 if there is no memory; then nothing has changed. */
int workspace_renew(Workspace *ws, const Scene *scene, int joined);
/* What a step leaves in the workspace and in the rooms for the next one. */
void workspace_checkpoint(Checkpoint *c, Workspace *ws);
/* kin from (t, y), and the rooms' poses. */
void dynamics_kinematics(const Scene *scene, Workspace *ws, double t, const double *y);
/* ydot [scene_state_size] from (t, y); friction scales every friction and drag force (1, or 0 for the relaxation). */
void dynamics_rates(const Scene *scene, Workspace *ws, double t, const double *y, double friction, double *ydot);
/* Its three strides, for chains that act on each other: where everything is; what acts on the chain, into ws->loads,
 * to which others may add; and the rates. */
void dynamics_pose(const Scene *scene, Workspace *ws, double t, const double *y, double friction);
void dynamics_loads(const Scene *scene, Workspace *ws, double t, double friction);
void dynamics_motion(const Scene *scene, Workspace *ws, double t, const double *y, double friction, double *ydot);
/* k and d (6x6 blocks, and those off their diagonals in ws->self.extras) at (t, y): the derivatives of force and moment
 * minus inertia times ydot, see body_blocks. Leaves the kinematics of y in the workspace. */
void dynamics_blocks(const Scene *scene, Workspace *ws, double t, const double *y, const double *ydot, double friction,
                     BlockChain *k, BlockChain *d);
/* What the ground before the tail (joint 0) or behind the head (joint n) does through that joint (BA2), for the
 * kinematics and joint loads in the workspace. */
Push dynamics_ghost_push(const Moment *m, int joint);
/* Force of the cable ahead on segment 0, into ws->joints of joint 1, for the kinematics in the workspace. */
void dynamics_tail_pull(const Scene *scene, Workspace *ws);
/* Gives contacts `share` of their stiffness, for the relaxation; 1: the scene's again. */
void dynamics_soften(const Scene *scene, Workspace *ws, double share);
/* Puts what a sample of (t, y) reads into the workspace: kinematics, the joints' law, what rooms look at; the forces of
 * all contacts, and nothing else, into ws->loads. Returns how many contacts carry force. */
int dynamics_look(const Scene *scene, Workspace *ws, double t, const double *y);
/* Wall time spent in contact forces so far, s. */
double dynamics_contact_seconds(const Workspace *ws);
/* Candidate pairs in the workspace now. */
int dynamics_candidates(const Workspace *ws);
/* A step to (t, y) has been accepted: the sliders of bending follow (bushing_slip), and so does the friction that
 * sticks. What they keep is not scratch but part of the state, beside y. Leaves the kinematics of y in the workspace if
 * there is any of that. */
void dynamics_accept(const Scene *scene, Workspace *ws, double t, const double *y);
/* New candidate pairs for the position y if `always`, or if something has moved too far since the last ones by the
 * kinematics in the workspace, which must be of y or of an iterate close to it. Errors: MEMORY. */
hawser_status dynamics_refresh(const Scene *scene, Workspace *ws, double t, const double *y, int always,
                               hawser_error *err);
/* New candidate pairs for the kinematics in the workspace. Errors: MEMORY. */
hawser_status dynamics_find_candidates(const Scene *scene, Workspace *ws, hawser_error *err);
/* ---- The terms of the balances at one state, from what the equations of motion have computed there
 * (sim/run/balance.c). docs/model.md, "Balances" (BA1)-(BA8). */
/* Adds what the last evaluation of the equations of motion has summed on its way, rooms aside: joints, lead-in. */
void balance_gather(const Workspace *ws, BalanceRates *out);
/* All rates of a chain in space: those just named at the last evaluation, the others at (t, y), for which the
 * kinematics of the chain's first and last segments are brought up to date. Overwrites out. */
void balance_spatial(const Scene *scene, Workspace *ws, double t, const double *y, BalanceRates *out);
/* What is stored at the kinematics in the workspace, and in its rooms by the last evaluation, which must have been
 * there; own: the rooms' part of that state (NULL: there is none). */
void balance_stock(const Scene *scene, Workspace *ws, const double *own, BalanceStock *out);

#endif
