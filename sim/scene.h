/* The scene: what is simulated, built once from a SceneDef and immutable while a run lasts, but for what changes
 * between steps: what rooms have seen happen (the winch's phase), and which segments of the chain are simulated.
 * Everything that acts on the cable is a room of it (sim/room.h). */
#ifndef HAWSER_SIM_SCENE_H
#define HAWSER_SIM_SCENE_H

#include "contact/roller.h"
#include "contact/self.h"
#include "contact/surface.h"
#include "core/body.h"
#include "sim/room.h"
#include "theory/buckling.h"
#include "theory/setup.h"

/* Gravity along the chain: the whole weight from the route's start on; behind it what the lead-in leaves, and the
 * lead-in's hold on the cable across its line (F1). */
typedef struct Weight {
    Vec3 gravity;        /* m/s2 */
    int lead_in;         /* 0: full gravity everywhere */
    Vec3 behind;         /* gravity that acts behind the start, m/s2: none, or its part along the lead-in */
    Vec3 origin;         /* the route's start, m */
    Vec3 direction;      /* the route's first tangent */
    double blend;        /* m, over which the weight comes in */
    double hold;         /* 1/s2: the lead-in's stiffness across its line over the mass it holds */
    double hold_damping; /* 1/s: its damping over mass */
    double weightless;   /* kg of the last segment's mass that has inertia alone: a winch's drum */
} Weight;

/* The rope's drag on the first segment behind the eye (F3). */
typedef struct Drag {
    int segment;     /* of those simulated; -1: none */
    double force;    /* N */
    FrictionLaw law; /* mu_s = 1 */
} Drag;

/* What the surface model borrows. All zeros if there is no surface. */
typedef struct Surfaces {
    SurfaceModel model;
    SurfacePatch *patch;
    FrictionLaw *friction; /* [2 surfaces] on straights, then in bends */
    int told;              /* commands have changed it: */
    Profile *factor;       /* [surfaces] friction over the case's (K6) */
    SurfacePoints points;
} Surfaces;

/* What each of several chains does to the others, as it is looked at: filled by sim/bunch, read by the room of their
 * figures. docs/model.md, "Several chains" (SC11)-(SC15). */
typedef struct ChainLook {
    double pull;      /* N, at its head: of its winch, or what joins it to its rope */
    double share;     /* of the pull of all that are no ropes */
    double between;   /* N/m, the most with which another chain presses on it */
    double walls;     /* N, normal forces of rollers and surfaces on it, their sizes summed */
    double weight;    /* N, of what the route bears of it: behind the start the lead-in does */
    double crossings; /* how often others pass from one side of it to the other along its length */
    double reference; /* N, what theory says of the pull now, with the weight correction of ducts */
    double factor;    /* w_c of the duct in which that is largest; 1 without ducts */
    double twist;     /* rad, by which the others turn about it from tail to head, their mean */
} ChainLook;

typedef struct ChainsLook {
    int n; /* 0: nothing has been looked at */
    ChainLook chain[STRANDS_MAX],
        all; /* all: sums, the largest, the mean of twists; ropes count with what bears them */
} ChainsLook;

/* Numbers: segments and joints of the whole chain are 0..total from the tail. What is simulated may be a part of it
 * (sim/run/stage.h): chain holds segments first..first+chain.n-1 and counts its own from 0. */
struct Scene {
    Chain chain;
    int first, total;     /* 0 and chain.n if nothing is on a reel or past the winch */
    int *piece;           /* [total] the chain piece of each segment */
    double *joint_s;      /* [total+1] route coordinate of each joint at t = 0, if all the chain lay there, m */
    int eye;              /* joint of the pulling eye: first joint of the rope, total if there is none */
    double largest_speed; /* m/s, of the winch; 0.1 if it never moves or has no limit */
    double beside_way;    /* m, that a step may move it by for the sake of chains beside it; INFINITY: any */
    double grip_speed;    /* m/s, over which the sharpest grip of a conveyor comes in; INFINITY: none grips */
    Route route;
    Weight weight;
    /* where the chain begins, if not on the route; borrowed from the room that says so */
    const double *start;     /* [13 total] the state at t = 0; NULL: along the route */
    const Vec3 *joint_start; /* [joints_off] the first joints' places, m */
    int joints_off;
    int n_rooms;
    Room room[ROOMS_MAX]; /* in the order in which they act */
    /* what is asked for by others than the rooms to which it belongs; never NULL once the scene is built */
    struct Winch *winch;         /* sim/equipment/winch.h */
    struct Reel *reel;           /* sim/equipment/reel.h */
    struct Drum *drum;           /* sim/equipment/reel.h: with the cable wound on it */
    struct Rod *rod;             /* sim/equipment/rod.h: a chain without a route */
    struct Equipment *equipment; /* sim/equipment/rollers.h */
    Profile tail;                /* N; nothing where a reel brings the back tension */
    double tail_held;            /* N, what holds the tail before the start instead (BK11); NAN: nothing does */
    Drag drag;
    ContactRoller *rollers; /* owned by their room; the contact model borrows them */
    ContactModel contact;
    Surfaces surfaces;
    SelfModel self;    /* cable on cable */
    ChainsLook chains; /* of the first of several chains: what they do to each other, as of the last look */
    SceneDef def;      /* a deep copy of what this was built from */
    Buckling pushed;   /* where theory has it pushed nearest to the load at which it buckles */
    int bowed;         /* its joints rest bent to the side for that (BK10) */
    Setup setup;       /* the same as theory computes it: supports, ends, what pushes */
};

/* Builds the scene. Errors: INPUT with the key to change, MEMORY. */
hawser_status scene_build(const SceneDef *def, Scene *scene, hawser_error *err);
void scene_clear(Scene *scene);

/* The point of that line at s, m. */
Vec3 scene_line_at(const Scene *scene, double s);

/* Entries of the state: 13 a segment, then the rooms' own. */
int scene_state_size(const Scene *scene);
/* Writes the initial state of the whole chain, 13 total numbers (core/state.h): it lies on the route at rest, its
 * joints closed, but for what begins elsewhere. */
void scene_initial_chain(const Scene *scene, double *y);
/* Lays segments first..first+n-1 along the route, at rest and with their joints closed, where they are when the chain
 * has moved on by `travel` (m) since t = 0, into y [13 n]. */
void scene_lay(const Scene *scene, double travel, int first, int n, double *y);
/* The initial state of the whole chain, set moving if the case says so, and the rooms' own part behind it. */
void scene_initial_state(const Scene *scene, double *y);
/* Sets the simulated chain, at rest in the state y in space, moving as the case says that it does at t = 0. */
void scene_launch(const Scene *scene, double *y);

/* The first time after t (s) at which a room is not smooth, a corner of a table say, or `stop` if that comes first. */
double scene_next_stop(const Scene *scene, double t, double stop);

/* How far a point of the cable may go at once, m; INFINITY where there is nothing to pass through. Contacts are looked
 * at where a step ends, so that a longer one could carry the cable through a roller, a wall or itself without either
 * having been noticed: W of (N14) but for the reach. */
double scene_way(const Scene *scene);

/* Sets the ghosts of kin (segments -1 and n) to what the ground does at time t. */
void scene_ghosts(const Scene *scene, double t, Kinematics *kin);

#endif
