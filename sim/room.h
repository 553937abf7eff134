/* The terms of a scene's balances of energy and momentum. docs/theory.md, "Balances" (BA1)-(BA3). */
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

/* Sources of work on the motion of chain, reel drum and rollers. */
typedef enum BalanceWork {
    BY_WINCH,     /* the winch, at its ghost or by its set tension with guide and brake */
    BY_TAIL,      /* the tail's back tension */
    BY_LEAD_IN,   /* the weight that the lead-in bears, and its hold */
    BY_REEL,      /* brake, bearing, back tension, bending of the cable that leaves the reel */
    BY_CONVEYORS, /* belts and their hold across the line, lost slip included */
    BY_ENDS,      /* prescribed motion or hold of a rod's ends */
    BY_LOADS,     /* a rod's loads */
    BY_MOTORS,    /* of rollers, on the rollers; the cable receives the rollers' push */
    BY_MEDIUM,    /* air or water: work of a current and of buoyancy */
    BY_EDGES,     /* surfaces where they fade out or are twisted */
    BY_OUTSIDE,   /* forces and laws given to the simulation by its caller */
    BALANCE_WORKS
} BalanceWork;

/* Causes of energy loss. */
typedef enum BalanceLoss {
    LOST_JOINTS,          /* damping of the bushings */
    LOST_BENDING,         /* sliders of the bending law; includes the energy in their springs until the end of the
                           * run */
    LOST_DRAG,            /* the rope's drag */
    LOST_BELTS,           /* slip in conveyors */
    LOST_ROLLERS,         /* friction on rollers, and the hold of a cable's end on a wound drum */
    LOST_ROLLERS_DAMPING, /* normal damping on rollers */
    LOST_SURFACES,        /* the same on surfaces */
    LOST_SURFACES_DAMPING,
    LOST_CABLE, /* the same of cable on cable */
    LOST_CABLE_DAMPING,
    LOST_BEARINGS, /* of spinning rollers */
    LOST_MOUNTS,   /* damping of mounts */
    LOST_MEDIUM,   /* drag of air or water */
    BALANCE_LOSSES
} BalanceLoss;

/* Stores of energy. */
typedef enum BalanceStore {
    IN_MOTION,  /* of the chain, including the drums of reel and winch */
    IN_HEIGHT,  /* -m g.p, measured from the origin */
    IN_JOINTS,  /* springs of the bushings, preloads included */
    IN_BENDING, /* springs of the sliders */
    IN_ROLLERS, /* contact springs */
    IN_SURFACES,
    IN_CABLE,
    IN_EQUIPMENT, /* moving rollers: motion, and the springs of their mounts */
    BALANCE_STORES
} BalanceStore;

/* External forces on the chain: first one for each source of work. */
enum { PUSH_DRAG = BALANCE_WORKS, PUSH_ROLLERS, PUSH_SURFACES, PUSH_WEIGHT, BALANCE_PUSHES };

/* All rates of work and loss, and all forces, at one moment. */
typedef struct BalanceRates {
    double work[BALANCE_WORKS], loss[BALANCE_LOSSES]; /* W */
    Vec3 push[BALANCE_PUSHES];                        /* N; without the weight, which is constant between events */
} BalanceRates;

/* All stored quantities at one moment. */
typedef struct BalanceStock {
    double energy[BALANCE_STORES]; /* J */
    Vec3 momentum;                 /* N s */
    Vec3 weight;                   /* N, of the simulated segments */
} BalanceStock;

/* Adds the power and force of one source. */
static inline void balance_work(BalanceRates *out, BalanceWork who, Push by)
{
    out->work[who] += by.power;
    out->push[who] = v3_add(out->push[who], by.force);
}

/* Adds the contacts of a kind: the loss by friction, the loss by damping in the row behind it, and their force. */
static inline void balance_contact(BalanceRates *out, BalanceLoss friction, int who, const ContactTally *by)
{
    out->loss[friction] += by->friction;
    out->loss[friction + 1] += by->damping;
    out->push[who] = v3_add(out->push[who], v3(by->force[0], by->force[1], by->force[2]));
}

/* Commands to a running simulation, and how their effects are saved. docs/theory.md, "Control". */

/* Ramp from the value that a profile has at t to another value (K1). */
static inline Profile command_ramp(const Profile *now, double t, double to, double ramp)
{
    return (Profile){.kind = PROFILE_STEP, .t0 = t, .v0 = profile_value(now, t), .t1 = t + ramp, .v1 = to};
}

static inline Profile profile_level(double value) { return (Profile){.kind = PROFILE_CONSTANT, .v1 = value}; }

/* Visits everything that commands have changed, in a fixed order: to save it from a scene, to load it into one that was
 * built from the same case, or, with `at` NULL, to count the bytes. The data must hold no pointers. */
typedef struct ControlsVisit {
    unsigned char *at; /* where the next byte goes or comes from */
    size_t size;       /* bytes so far */
    int load;
    size_t room; /* bytes available to load */
    int wrong;   /* the loaded data is invalid: loading has stopped */
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

/* Visits a number in 0 .. most: a count of items, or a value of an enumeration; a loaded value outside becomes 0. */
static inline void controls_count(ControlsVisit *visit, int *n, int most)
{
    controls_bytes(visit, n, sizeof *n);
    if (visit->load && (*n < 0 || *n > most)) visit->wrong = 1;
    if (visit->wrong) *n = 0;
}

/* Repairs a loaded profile and gives it the case's table if it has one. */
static inline void controls_profile_mend(ControlsVisit *visit, Profile *profile, const Profile *of_case)
{
    if (!visit->load) return;
    if (!profile_is_one(profile)) visit->wrong = 1;
    if (profile->kind == PROFILE_TABLE && of_case->kind != PROFILE_TABLE) visit->wrong = 1;
    if (visit->wrong || profile->kind == PROFILE_TABLE) *profile = *of_case;
}

/* Visits a profile whose table, if it has one, is the case's. */
static inline void controls_profile(ControlsVisit *visit, Profile *profile, const Profile *of_case)
{
    controls_bytes(visit, profile, sizeof *profile);
    controls_profile_mend(visit, profile, of_case);
}

/* An equipment kind: one kind of thing that acts on the cable (rollers, a reel, conveyors, ...), as the corridor of a
 * step sees it.
 *
 * Each kind is one file in sim/equipment/ that ends in its RoomKind: functions that are each called at one point of a
 * scene's life or of a step, or NULL where the kind has nothing to do there. sim/equipment/rooms.h lists the kinds in
 * the order in which they act. docs/architecture.md, "Kinds of equipment". */

typedef struct Scene Scene;

typedef struct Workspace Workspace;

typedef struct RoomKind RoomKind;

enum { ROOMS_MAX = 16 };

/* An equipment kind in one scene. */
typedef struct Room {
    const RoomKind *kind;
    int number;  /* index in the scene's and the workspace's arrays */
    int present; /* 0: the scene has nothing of the kind */
    int states;  /* number of its own entries in the state, behind those of the chain and of the kinds before it */
    void *self;  /* built from the definition; owned */
} Room;

typedef struct Moment Moment;

/* Figures that a run keeps for each machine of a kind. */
enum { MACHINE_KEPT_MAX = 8, MACHINE_FIGURES_MAX = 12 };

typedef struct MachineKind {
    const char *key; /* of their list in summary.json, e.g. "conveyors" */
    int (*count)(const Room *room);
    const char *(*name)(const Room *room, int i);
    /* Figures that are computed for every row of output, from the kinematics in the workspace; the first n_now of them
     * are columns of series.csv, NAME_KEY. */
    int n_now, n_kept;
    const char *now[MACHINE_KEPT_MAX];
    void (*keep)(const Room *room, const Moment *m, int i, double value[MACHINE_KEPT_MAX]);
    /* Figures of the run so far, from the kept means; expected: N, the push that theory computes, or NAN. */
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

/* Figures after a step that events can depend on. */
enum { WATCH_PULL = 1, WATCH_FRONT = 2, WATCH_TRAVEL = 4 };

typedef struct Occasion {
    double t;      /* s, of the accepted step */
    double pull;   /* N, of the winch */
    double front;  /* m along the route, of the cable's front; NAN: not required, or past the winch */
    double travel; /* m, hauled in by the winch; NAN: not required */
} Occasion;

/* An event caused by a step, as a text that lives as long as the scene; NULL: no further event. */
typedef struct Occurrence {
    hawser_event_code code;
    const char *what;
} Occurrence;

/* State of a piece of equipment that is held fast. The owner is the one that holds it; the share changes between steps
 * only. */
typedef struct Seizure {
    Profile share; /* share held, over time: 0 free, 1 at a standstill */
    double ramp;   /* s, over which it stops and starts */
    double mu;     /* friction coefficient with which the cable drags over it at a standstill; NAN: the usual one */
} Seizure;

/* Carries out a command to jam or release something: it sets the commands' own seizure; `by` holds the thing now (NULL:
 * nothing does). Returns as RoomKind.command. */
int seizure_command(Seizure *told, const Seizure *by, const Command *c, double t, hawser_error *err);
/* Saves or loads the commands' own seizure. */
static inline void controls_seizure(ControlsVisit *visit, Seizure *told)
{
    const Profile level = profile_level(0);
    controls_bytes(visit, told, sizeof *told);
    controls_profile_mend(visit, &told->share, &level);
}

struct RoomKind {
    const char *name;

    /* ---- life. Errors: INPUT with the key to change, MEMORY. */
    /* Adds the kind's parts to the scene's definition, before anything is built. */
    hawser_status (*prepare)(Room *room, Scene *scene, hawser_error *err);
    /* Builds the kind from scene->def; the chain has its masses and lengths but no springs yet. Sets room->self and
     * room->present. */
    hawser_status (*build)(Room *room, Scene *scene, hawser_error *err);
    /* Sets the springs at the chain's ends; those between segments are complete. */
    void (*join)(Room *room, Scene *scene);
    /* Called last, when everything else is built. */
    hawser_status (*finish)(Room *room, Scene *scene, hawser_error *err);
    /* Lets `by` hold the equipment called `name` from then on, before any workspace is made; returns the kind of the
     * equipment in a word, or NULL if none here has that name. */
    const char *(*seize)(Room *room, const Scene *scene, const char *name, const Seizure *by);
    void (*clear)(Room *room);
    /* Writes its own part of the initial state, [room->states]. */
    void (*start)(const Room *room, double *own);
    /* Sets the chain moving in the state y, in space, where it is at rest as a run begins. */
    void (*launch)(const Room *room, const Scene *scene, double *y);
    /* Allocates its scratch in ws (ws->room[number], or typed members); 0 without memory. */
    int (*work_alloc)(const Room *room, const Scene *scene, Workspace *ws);
    void (*work_free)(const Room *room, Workspace *ws);
    /* Copies what is not scratch after the chain's window has changed, with `joined` segments more behind the tail. */
    void (*carry)(const Room *room, Workspace *from, Workspace *to, int joined);

    /* ---- in a step: functions of (t, y) alone */
    /* Sets the ghosts of kin (segments -1 and n) to the motion of the ground at time t. */
    void (*ghosts)(const Room *room, const Scene *scene, double t, Kinematics *kin);
    /* Computes what else follows from the state; own: its part of it. */
    void (*pose)(const Room *room, const Moment *m, const double *own);
    /* Called before loads or blocks are evaluated. */
    void (*begin)(const Room *room, const Moment *m);
    /* Adds forces and moments on the chain to m->ws->loads[part]. Called for part 0 and part 1, perhaps on two threads;
     * small work is done in part 0 alone. */
    void (*loads)(const Room *room, const Moment *m, int part);
    /* Computes what needs the loads of both parts. */
    void (*after_loads)(const Room *room, const Moment *m);
    /* Computes the rates of its own part of the state. */
    void (*rates)(const Room *room, const Moment *m, const double *own, double *rate);
    /* Adds the derivatives of loads to k and d. */
    void (*blocks)(const Room *room, const Moment *m, BlockChain *k, BlockChain *d);
    /* The same for a kind with blocks off the diagonals; called after all others. */
    void (*extra_blocks)(const Room *room, const Moment *m, BlockChain *k, BlockChain *d);
    int touches; /* its loads are contacts, whose time is measured apart */
    int heavy;   /* its loads pay on two threads at any length of the chain */

    /* ---- between steps */
    /* Updates what changes along the way, without an evaluation: a step to y was accepted (or y is new, if
     * `always`). */
    void (*follow)(const Room *room, const Moment *m, const double *y, int always);
    /* Checks whether, by the kinematics in the workspace, something can touch that is not among the contact candidates;
     * finds new ones, for all kinds together. Errors of refresh: MEMORY. */
    int (*stale)(const Room *room, const Moment *m);
    hawser_status (*refresh)(const Room *room, const Moment *m, hawser_error *err);
    int (*candidates)(const Room *room, const Workspace *ws);
    /* Checks whether its laws depend on the last accepted step; if so, accepts the step to the kinematics in the
     * workspace. */
    int (*remembers)(const Room *room, const Workspace *ws);
    void (*accept)(const Room *room, const Moment *m);
    /* Quantities that its events depend on: a combination of WATCH_PULL, WATCH_FRONT, WATCH_TRAVEL; 0: no event is
     * possible. */
    int (*watches)(const Room *room);
    /* Updates the kind after an accepted step; returns one event per call. */
    Occurrence (*happen)(Room *room, const Occasion *now);
    /* Carries out a command at time t. All changes start from the values at t and follow STEP (K1). Returns 1 if the
     * command was for this kind; 0 if it concerns nothing here; -1 if it concerns something here and cannot be done:
     * err has the reason, nothing has changed. */
    int (*command)(Room *room, const Scene *scene, const Command *c, double t, hawser_error *err);
    /* Saves or loads the changes made by commands, byte by byte (sim/room.h). */
    void (*controls)(Room *room, ControlsVisit *visit);
    /* First time after t at which the kind is not smooth, s; INFINITY: never. */
    double (*next_stop)(const Room *room, const Scene *scene, double t);

    /* Saves or loads what has changed since the scene was built and does not follow from (t, y): its own members, and
     * what a workspace keeps from step to step. core/checkpoint.h */
    void (*checkpoint)(Checkpoint *c, const Room *room, const Scene *scene, Workspace *ws);

    /* ---- figures */
    /* Adds its power and force on the motion at m->t, for the kinematics in the workspace, which belong to m->t at the
     * chain's ends and to the last evaluation elsewhere. */
    void (*work)(const Room *room, const Moment *m, BalanceRates *out);
    /* Adds its stored energy and momentum, by the last evaluation; own: its part of that state. */
    void (*stock)(const Room *room, const Moment *m, const double *own, BalanceStock *out);
    /* Puts what a sample reads into the workspace, for the kinematics there, and adds contact forces to ws->loads;
     * returns the number of contacts that carry force. */
    int (*look)(const Room *room, const Moment *m);
    const MachineKind *machines; /* NULL: no figures of machines */

    /* ---- in the plane. NULL: the planar equations do not have this kind, and a scene that has it is solved in space;
     * `in_space` is the reason. Otherwise the reason why this scene's equipment cannot be planar, or NULL if it can
     * (sim/solve/planar.c checks the geometry). */
    const char *(*not_planar)(const Room *room, const Scene *scene);
    const char *in_space;
};

/* All equipment kinds, in the order in which they act; NULL ends the list. */
extern const RoomKind *const ROOM_KINDS[];

/* Returns the scene's equipment of a kind. */
Room *room_of(Scene *scene, const RoomKind *kind);

#endif
