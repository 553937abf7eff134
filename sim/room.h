/* A room: one kind of thing that acts on the cable (rollers, a reel, conveyors, ...), as the corridor of a step sees
 * it.
 *
 * A kind of equipment is one file in sim/equipment/ that ends in its RoomKind: functions of which each is called at one
 * point of a scene's life or of a step, and NULL where the kind has nothing to do there. The list of kinds stands once,
 * in sim/equipment/rooms.h, and its order is the order in which they act. docs/architecture.md, "Rooms". */
#ifndef HAWSER_SIM_ROOM_H
#define HAWSER_SIM_ROOM_H

#include "core/base/error.h"
#include "core/block_chain.h"
#include "core/chain.h"
#include "core/profile.h"
#include "sim/balance_data.h"
#include "sim/command.h"
#include "sim/time_mean.h"

typedef struct Scene Scene;
typedef struct Workspace Workspace;
typedef struct RoomKind RoomKind;

enum { ROOMS_MAX = 16 };

/* A kind in one scene. */
typedef struct Room {
    const RoomKind *kind;
    int number;  /* its place in the scene's rooms and in the workspace's */
    int present; /* 0: the scene has nothing of the kind */
    int states;  /* numbers of the state that are its own, behind the chain's and those of the rooms before it */
    void *self;  /* what was built from the definition; owned */
} Room;

typedef struct Moment Moment;

/* What a run keeps of each machine of a kind. */
enum { MACHINE_KEPT_MAX = 8, MACHINE_FIGURES_MAX = 12 };
typedef struct MachineKind {
    const char *key; /* of their list in summary.json: "conveyors" */
    int (*count)(const Room *room);
    const char *(*name)(const Room *room, int i);
    /* What is looked at in every row of output, for the kinematics in the workspace; the first n_now of it are columns
     * of series.csv, NAME_KEY. */
    int n_now, n_kept;
    const char *now[MACHINE_KEPT_MAX];
    void (*keep)(const Room *room, const Moment *m, int i, double value[MACHINE_KEPT_MAX]);
    /* The figures of the run so far, from what was kept; expected: N, what theory reckons that it pushes with, or NAN.
     */
    int n_figures;
    const char *figure[MACHINE_FIGURES_MAX];
    void (*figures)(const Room *room, int i, const TimeMean *kept, double expected, double value[MACHINE_FIGURES_MAX]);
} MachineKind;

/* One evaluation of the equations of motion. */
struct Moment {
    const Scene *scene;
    Workspace *ws;
    double t;        /* s */
    double friction; /* scales every friction and drag force: 1, or 0 for the relaxation */
};

/* What a step has come to, for those who wait for something. */
enum { WATCH_PULL = 1, WATCH_FRONT = 2, WATCH_TRAVEL = 4 };
typedef struct Occasion {
    double t;      /* s, of the step that was accepted */
    double pull;   /* N, of the winch */
    double front;  /* m along the route, of the cable's front; NAN: not watched, or past the winch */
    double travel; /* m, that the winch has hauled in; NAN: not watched */
} Occasion;

/* What a step has brought about, in words that live as long as the scene; NULL: nothing more. */
typedef struct Occurrence {
    hawser_event_code code;
    const char *what;
} Occurrence;

/* What holds one thing of a room fast. It is owned by who seizes; the share changes between steps only. */
typedef struct Seizure {
    Profile share; /* of being held, over time: 0 free, 1 it stands */
    double ramp;   /* s, over which it stops and starts */
    double mu;     /* with which the cable drags over it when it stands; NAN: the usual */
} Seizure;

/* A command to jam or to release something: into the seizure that commands have, `by` being what holds it now (NULL:
 * nothing). Returns as RoomKind.command. */
int seizure_command(Seizure *told, const Seizure *by, const Command *c, double t, hawser_error *err);
/* One that commands have: saved or loaded. */
static inline void controls_seizure(ControlsVisit *visit, Seizure *told)
{
    const Profile level = profile_level(0);
    controls_bytes(visit, told, sizeof *told);
    controls_profile_mend(visit, &told->share, &level);
}

struct RoomKind {
    const char *name;

    /* ---- life. Errors: INPUT with the key to change, MEMORY. */
    /* Before anything is built: what the kind adds to the scene's definition. */
    hawser_status (*prepare)(Room *room, Scene *scene, hawser_error *err);
    /* From scene->def, whose chain has its masses and lengths but no springs yet. Sets room->self and room->present. */
    hawser_status (*build)(Room *room, Scene *scene, hawser_error *err);
    /* When the springs between segments stand: those at the chain's ends. */
    void (*join)(Room *room, Scene *scene);
    /* Last, when everything else is built. */
    hawser_status (*finish)(Room *room, Scene *scene, hawser_error *err);
    /* Has `by` hold what is called `name` from then on, before any workspace is made; returns what that is, in a word;
     * NULL: nothing here has the name. */
    const char *(*seize)(Room *room, const Scene *scene, const char *name, const Seizure *by);
    void (*clear)(Room *room);
    /* Its own part of the initial state, [room->states]. */
    void (*start)(const Room *room, double *own);
    /* Sets the chain moving in the state y, in space, in which it lies at rest as a run begins. */
    void (*launch)(const Room *room, const Scene *scene, double *y);
    /* Its scratch in ws (ws->room[number], or typed members); 0 without memory. */
    int (*work_alloc)(const Room *room, const Scene *scene, Workspace *ws);
    void (*work_free)(const Room *room, Workspace *ws);
    /* The chain's window has changed, with `joined` segments more behind the tail: what is no scratch goes over. */
    void (*carry)(const Room *room, Workspace *from, Workspace *to, int joined);

    /* ---- in a step: functions of (t, y) alone */
    /* Sets the ghosts of kin (segments -1 and n) to what the ground does at time t. */
    void (*ghosts)(const Room *room, const Scene *scene, double t, Kinematics *kin);
    /* Sets what else follows from the state; own: its part of it. */
    void (*pose)(const Room *room, const Moment *m, const double *own);
    /* Before loads or blocks are evaluated. */
    void (*begin)(const Room *room, const Moment *m);
    /* Adds forces and moments on the chain to m->ws->loads[part]. Called for part 0 and part 1, perhaps on two threads:
     * what is not worth splitting is done in part 0. */
    void (*loads)(const Room *room, const Moment *m, int part);
    /* What needs the loads of both parts. */
    void (*after_loads)(const Room *room, const Moment *m);
    /* Rates of its own part of the state. */
    void (*rates)(const Room *room, const Moment *m, const double *own, double *rate);
    /* Adds the derivatives of loads to k and d. */
    void (*blocks)(const Room *room, const Moment *m, BlockChain *k, BlockChain *d);
    /* The same for a kind with blocks off the diagonals: after all others. */
    void (*extra_blocks)(const Room *room, const Moment *m, BlockChain *k, BlockChain *d);
    int touches; /* its loads are contacts: their time is told apart */
    int heavy;   /* its loads are worth a second thread at any length of the chain */

    /* ---- between steps */
    /* A step to y was accepted (or y is new, if `always`): what changes along the way, without any evaluation. */
    void (*follow)(const Room *room, const Moment *m, const double *y, int always);
    /* Whether candidates for contact no longer cover what can touch, by the kinematics in the workspace; and new ones,
     * for all rooms together. Errors of refresh: MEMORY. */
    int (*stale)(const Room *room, const Moment *m);
    hawser_status (*refresh)(const Room *room, const Moment *m, hawser_error *err);
    int (*candidates)(const Room *room, const Workspace *ws);
    /* Whether its laws remember the last accepted step, and that one to the kinematics of now was accepted. */
    int (*remembers)(const Room *room, const Workspace *ws);
    void (*accept)(const Room *room, const Moment *m);
    /* What of a step it waits for: of WATCH_PULL, WATCH_FRONT, WATCH_TRAVEL; 0: nothing can happen. */
    int (*watches)(const Room *room);
    /* A step was accepted: changes what the step has brought about, one event a call. */
    Occurrence (*happen)(Room *room, const Occasion *now);
    /* Is told something at time t. Everything goes on from what it is then, and comes in by STEP (K1). 1: that was for
     * it; 0: nothing of it is meant; -1: it is meant and cannot do that, err says why, nothing has changed. */
    int (*command)(Room *room, const Scene *scene, const Command *c, double t, hawser_error *err);
    /* What commands have made of it, byte by byte: saved or loaded (sim/command.h). */
    void (*controls)(Room *room, ControlsVisit *visit);
    /* The first time after t at which it is not smooth, s; INFINITY: never. */
    double (*next_stop)(const Room *room, const Scene *scene, double t);

    /* What has changed since the scene was built and does not follow from (t, y): members of its own, and what a
     * workspace keeps from step to step. core/base/checkpoint.h */
    void (*checkpoint)(Checkpoint *c, const Room *room, const Scene *scene, Workspace *ws);

    /* ---- to look at */
    /* Adds what it does to the motion at m->t, for the kinematics in the workspace, which are of now at the chain's
     * ends and of the last evaluation elsewhere. */
    void (*work)(const Room *room, const Moment *m, BalanceRates *out);
    /* Adds what it holds, by the last evaluation; own: its part of that state. */
    void (*stock)(const Room *room, const Moment *m, const double *own, BalanceStock *out);
    /* Puts what a sample reads into the workspace, for the kinematics there, and adds contact forces to ws->loads;
     * returns how many contacts carry force. */
    int (*look)(const Room *room, const Moment *m);
    const MachineKind *machines; /* NULL: no figures of its own */

    /* ---- in the plane. NULL: the planar equations know nothing of the kind, and a scene that has it is solved in
     * space because `in_space`. Otherwise why this one cannot be there, or NULL if it can (sim/planar/plane.h asks
     * where things lie). */
    const char *(*not_planar)(const Room *room, const Scene *scene);
    const char *in_space;
};

/* Every kind there is, in the order in which they act; NULL ends the list. */
extern const RoomKind *const ROOM_KINDS[];

/* The scene's room of a kind. */
Room *room_of(Scene *scene, const RoomKind *kind);

#endif
