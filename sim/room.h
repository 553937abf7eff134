/* The terms of a scene's balances of energy and momentum. docs/model.md, "Balances" (BA1)-(BA3). */
#ifndef HAWSER_SIM_ROOM_H
#define HAWSER_SIM_ROOM_H

#include <string.h>

#include "contact/law.h"
#include "core/block_chain.h"
#include "core/chain.h"
#include "core/error.h"
#include "core/profile.h"
#include "core/state.h"
#include "def/command_def.h"
#include "hawser/hawser.h"
#include "sim/time_mean.h"

/* Who works on the motion: chain, drum of the reel, rollers. */
typedef enum BalanceWork {
    BY_WINCH,     /* the winch, at its ghost or by its set tension with guide and brake */
    BY_TAIL,      /* the tail's back tension */
    BY_LEAD_IN,   /* what the lead-in takes off the weight, and its hold */
    BY_REEL,      /* brake, bearing, back tension, bending of the cable that comes off */
    BY_CONVEYORS, /* belts and holds, what slips included */
    BY_ENDS,      /* what leads or holds a rod's ends */
    BY_LOADS,     /* a rod's loads */
    BY_MOTORS,    /* of rollers, on these; what reaches the cable is the rollers' push */
    BY_MEDIUM,    /* air or water: what a current and buoyancy bring in */
    BY_EDGES,     /* surfaces, where they fade out or are twisted */
    BY_OUTSIDE,   /* forces and laws that the simulation was told */
    BALANCE_WORKS
} BalanceWork;

/* Where energy is lost. */
typedef enum BalanceLoss {
    LOST_JOINTS,          /* damping of the bushings */
    LOST_BENDING,         /* sliders of the bending law; what their springs hold is in here until the end */
    LOST_DRAG,            /* the rope's drag */
    LOST_BELTS,           /* slip in conveyors */
    LOST_ROLLERS,         /* friction on rollers, and what holds a cable's end on a wound drum */
    LOST_ROLLERS_DAMPING, /* normal damping there */
    LOST_SURFACES,        /* the same on surfaces */
    LOST_SURFACES_DAMPING,
    LOST_CABLE, /* and of cable on cable */
    LOST_CABLE_DAMPING,
    LOST_BEARINGS, /* of spinning rollers */
    LOST_MOUNTS,   /* damping of mounts */
    LOST_MEDIUM,   /* drag of air or water */
    BALANCE_LOSSES
} BalanceLoss;

/* Where energy is. */
typedef enum BalanceStore {
    IN_MOTION,  /* of the chain, the reel's and the winch's drum included */
    IN_HEIGHT,  /* -m g.p, from the origin on */
    IN_JOINTS,  /* springs of the bushings, preloads included */
    IN_BENDING, /* springs of the sliders */
    IN_ROLLERS, /* contact springs */
    IN_SURFACES,
    IN_CABLE,
    IN_EQUIPMENT, /* rollers that move: motion, and the springs of their mounts */
    BALANCE_STORES
} BalanceStore;

/* Who pushes the chain from outside: the workers first. */
enum { PUSH_DRAG = BALANCE_WORKS, PUSH_ROLLERS, PUSH_SURFACES, PUSH_WEIGHT, BALANCE_PUSHES };

/* Everything that is done at one moment. */
typedef struct BalanceRates {
    double work[BALANCE_WORKS], loss[BALANCE_LOSSES]; /* W */
    Vec3 push[BALANCE_PUSHES];                        /* N; without the weight, which is constant between events */
} BalanceRates;

/* Everything that is there at one moment. */
typedef struct BalanceStock {
    double energy[BALANCE_STORES]; /* J */
    Vec3 momentum;                 /* N s */
    Vec3 weight;                   /* N, of what is simulated */
} BalanceStock;

/* Adds what a worker does. */
static inline void balance_work(BalanceRates *out, BalanceWork who, Push by)
{
    out->work[who] += by.power;
    out->push[who] = v3_add(out->push[who], by.force);
}

/* Adds what contacts of a kind do: friction, then damping in the row behind it; their push. */
static inline void balance_contact(BalanceRates *out, BalanceLoss friction, int who, const ContactTally *by)
{
    out->loss[friction] += by->friction;
    out->loss[friction + 1] += by->damping;
    out->push[who] = v3_add(out->push[who], v3(by->force[0], by->force[1], by->force[2]));
}

/* What a simulation is told while it runs, and how what has come of it is saved. docs/model.md, "Control". */

/* From the value that a profile has at t to another over the ramp (K1). */
static inline Profile command_ramp(const Profile *now, double t, double to, double ramp)
{
    return (Profile){.kind = PROFILE_STEP, .t0 = t, .v0 = profile_value(now, t), .t1 = t + ramp, .v1 = to};
}

static inline Profile profile_level(double value) { return (Profile){.kind = PROFILE_CONSTANT, .v1 = value}; }

/* Goes over what commands have changed, in a fixed order: to take it out of a scene, to put it into one that was built
 * from the same case, or, with `at` NULL, to count the bytes. Nothing of it may point anywhere. */
typedef struct ControlsVisit {
    unsigned char *at; /* where the next byte goes or comes from */
    size_t size;       /* bytes so far */
    int load;
    size_t room; /* bytes that there are to load */
    int wrong;   /* what was loaded cannot be: nothing more is */
} ControlsVisit;

static inline void controls_bytes(ControlsVisit *visit, void *bytes, size_t size)
{
    visit->size += size;
    if (visit->load && (visit->size > visit->room || visit->wrong)) visit->wrong = 1;
    if (!visit->at || visit->wrong) return;
    if (visit->load) {
        memcpy(bytes, visit->at, size);
    } else {
        memcpy(visit->at, bytes, size);
    }
    visit->at += size;
}

/* A number of 0 .. most: of something's items, or of an enumeration; what is loaded and is none of these is 0. */
static inline void controls_count(ControlsVisit *visit, int *n, int most)
{
    controls_bytes(visit, n, sizeof *n);
    if (visit->load && (*n < 0 || *n > most)) visit->wrong = 1;
    if (visit->wrong) *n = 0;
}

/* What was loaded as a profile, with the case's table if it has one. */
static inline void controls_profile_mend(ControlsVisit *visit, Profile *profile, const Profile *of_case)
{
    if (!visit->load) return;
    if (!profile_is_one(profile)) visit->wrong = 1;
    if (profile->kind == PROFILE_TABLE && of_case->kind != PROFILE_TABLE) visit->wrong = 1;
    if (visit->wrong || profile->kind == PROFILE_TABLE) *profile = *of_case;
}

/* A profile whose table, if it has one, is the case's. */
static inline void controls_profile(ControlsVisit *visit, Profile *profile, const Profile *of_case)
{
    controls_bytes(visit, profile, sizeof *profile);
    controls_profile_mend(visit, profile, of_case);
}

/* A room: one kind of thing that acts on the cable (rollers, a reel, conveyors, ...), as the corridor of a step sees
 * it.
 *
 * A kind of equipment is one file in sim/equipment/ that ends in its RoomKind: functions of which each is called at one
 * point of a scene's life or of a step, and NULL where the kind has nothing to do there. The list of kinds stands once,
 * in sim/equipment/rooms.h, and its order is the order in which they act. docs/architecture.md, "Rooms". */

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
    /* What commands have made of it, byte by byte: saved or loaded (sim/room.h). */
    void (*controls)(Room *room, ControlsVisit *visit);
    /* The first time after t at which it is not smooth, s; INFINITY: never. */
    double (*next_stop)(const Room *room, const Scene *scene, double t);

    /* What has changed since the scene was built and does not follow from (t, y): members of its own, and what a
     * workspace keeps from step to step. core/checkpoint.h */
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
     * space because `in_space`. Otherwise why this one cannot be there, or NULL if it can (sim/solve/planar.h asks
     * where things lie). */
    const char *(*not_planar)(const Room *room, const Scene *scene);
    const char *in_space;
};

/* Every kind there is, in the order in which they act; NULL ends the list. */
extern const RoomKind *const ROOM_KINDS[];

/* The scene's room of a kind. */
Room *room_of(Scene *scene, const RoomKind *kind);

#endif
