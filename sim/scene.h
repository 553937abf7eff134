/* The scene: what is simulated. It is built once from a SceneDef and immutable during a run, except for what changes
 * between steps: the states of equipment (the winch's phase), and which segments of the chain are simulated. Everything
 * that acts on the cable is equipment of the scene (sim/room.h). */
#ifndef HAWSER_SIM_SCENE_H
#define HAWSER_SIM_SCENE_H

#include "contact/roller.h"
#include "contact/self.h"
#include "contact/surface.h"
#include "core/body.h"
#include "sim/room.h"
#include "theory/buckling.h"
#include "theory/setup.h"

/* Gravity along the chain: full weight from the route's start on; behind it the part that the lead-in does not bear,
 * and the lead-in's hold on the cable across its line (F1). */
typedef struct Weight {
    Vec3 gravity;        /* m/s2 */
    int lead_in;         /* 0: full gravity everywhere */
    Vec3 behind;         /* gravity that acts behind the start, m/s2: zero, or the component along the lead-in */
    Vec3 origin;         /* the route's start, m */
    Vec3 direction;      /* the route's first tangent */
    double blend;        /* m, over which the weight rises to its full value */
    double hold;         /* 1/s2: the lead-in's stiffness across its line over the mass it holds */
    double hold_damping; /* 1/s: its damping over mass */
    double weightless;   /* kg of the last segment's mass that has inertia but no weight: a winch's drum */
} Weight;

/* The rope's drag on the first segment behind the eye (F3). */
typedef struct Drag {
    int segment;     /* among those simulated; -1: none */
    double force;    /* N */
    FrictionLaw law; /* with mu_s = 1 */
} Drag;

/* Data that the surface model borrows. All zeros if there is no surface. */
typedef struct Surfaces {
    SurfaceModel model;
    SurfacePatch *patch;
    FrictionLaw *friction; /* [2 surfaces + laws] on straights, then in bends, then of the environment */
    int told;              /* 1: commands have changed the friction */
    Profile *factor;       /* [surfaces + laws] friction relative to the case's (K6) */
    SurfacePoints points;
    Facets *facets; /* of the environment; NULL: none can be touched */
    int *law;       /* [layers of the environment] friction of each, -1: not touched */
} Surfaces;

/* Interaction of several chains: written by sim/solve/chains.c, read by the equipment kind of their figures.
 * docs/theory.md, "Several chains" (SC11)-(SC15). */
typedef struct ChainLook {
    double pull;      /* N, at its head: of its winch, or of the joint to its rope */
    double share;     /* part of the pull of all chains that are not ropes */
    double between;   /* N/m, largest contact pressure from another chain */
    double walls;     /* N, sum of the sizes of the normal forces of rollers and surfaces */
    double weight;    /* N, of the part on the route; the lead-in bears what is behind the start */
    double crossings; /* number of times that others pass from one side of it to the other along its length */
    double reference; /* N, pull by theory at this moment, with the weight correction of ducts */
    double factor;    /* w_c of the duct in which it is largest; 1 without ducts */
    double twist;     /* rad, mean angle by which the others turn about it from tail to head */
} ChainLook;

typedef struct ChainsLook {
    int n; /* 0: not computed yet */
    ChainLook chain[STRANDS_MAX],
        all; /* sums, largest values, mean twist of all chains; a rope counts with the chains that it pulls */
} ChainsLook;

/* Numbering: segments and joints of the whole chain are 0..total from the tail. The simulated window may be a part of
 * it (sim/run/stage.h): chain holds segments first..first+chain.n-1 and counts its own from 0. */
struct Scene {
    Chain chain;
    int first, total;     /* 0 and chain.n if nothing is on a reel or past the winch */
    int *piece;           /* [total] index of each segment's chain piece */
    double *joint_s;      /* [total+1] route coordinate of each joint at t = 0 if the whole chain were on the route,
                           * m */
    int eye;              /* joint of the pulling eye: first joint of the rope, total if there is none */
    double largest_speed; /* m/s, of the winch; 0.1 if it never moves or has no limit */
    double beside_way;    /* m, largest motion per step for the contact with other chains; INFINITY: no limit */
    double grip_speed;    /* m/s, over which the force of the sharpest conveyor grip rises; INFINITY: no conveyor */
    Route route;
    Weight weight;
    /* initial state where it is not along the route; borrowed from the equipment that sets it */
    const double *start;     /* [13 total] the state at t = 0; NULL: along the route */
    const Vec3 *joint_start; /* [joints_off] places of the first joints, m */
    int joints_off;
    int n_rooms;
    Room room[ROOMS_MAX]; /* equipment kinds, in the order in which they act */
    /* equipment that other kinds use too; never NULL once the scene is built */
    struct Winch *winch;         /* sim/equipment/winch.h */
    struct Reel *reel;           /* sim/equipment/reel.h */
    struct Drum *drum;           /* sim/equipment/reel.h: the one with the cable wound on it */
    struct Rod *rod;             /* sim/equipment/rod.h: for a chain without a route */
    struct Equipment *equipment; /* sim/equipment/rollers.h */
    Profile tail;                /* N; zero where a reel brings the back tension */
    double tail_held;            /* N, force that holds the tail before the start instead (BK11); NAN: none */
    Drag drag;
    ContactRoller *rollers; /* owned by their equipment kind; borrowed by the contact model */
    ContactModel contact;
    Surfaces surfaces;
    SelfModel self;    /* cable on cable */
    ChainsLook chains; /* in the first of several chains: their interaction at the last look */
    SceneDef def;      /* deep copy of the definition that this was built from */
    Buckling pushed;   /* by theory, where compression is closest to the buckling load */
    int bowed;         /* the joints' resting shape is bent to the side because of it (BK10) */
    Setup setup;       /* data for theory: supports, ends, driving forces */
};

/* Builds the scene. Errors: INPUT with the key to change, MEMORY. */
hawser_status scene_build(const SceneDef *def, Scene *scene, hawser_error *err);
void scene_clear(Scene *scene);

/* Number of laws in surfaces.friction. */
static inline int scene_surface_laws(const Scene *scene)
{
    return 2 * scene->surfaces.model.n_surfaces + scene->surfaces.model.n_laws;
}
/* Point of that line at s, m. */
Vec3 scene_line_at(const Scene *scene, double s);

/* Number of entries of the state: 13 per segment, then those of the equipment kinds. */
int scene_state_size(const Scene *scene);
/* Writes the initial state of the whole chain, 13 total numbers (core/state.h): on the route, at rest, joints closed,
 * except where another initial state is given. */
void scene_initial_chain(const Scene *scene, double *y);
/* Places segments first..first+n-1 along the route, at rest and with closed joints, at the places where they are when
 * the chain has moved on by `travel` (m) since t = 0; into y [13 n]. */
void scene_lay(const Scene *scene, double travel, int first, int n, double *y);
/* Writes the initial state of the whole chain, with initial speeds if the case has any, and of the equipment kinds
 * behind it. */
void scene_initial_state(const Scene *scene, double *y);
/* Gives the simulated chain, at rest in the state y in space, the initial speeds of the case. */
void scene_launch(const Scene *scene, double *y);

/* First time after t (s) at which some equipment is not smooth, e.g. a corner of a table, or `stop` if that comes
 * first. */
double scene_next_stop(const Scene *scene, double t, double stop);

/* Largest motion of a point of the cable in one step, m; INFINITY where there is nothing to pass through. Contacts are
 * checked at the end of a step, so that a longer step could carry the cable through a roller, a wall or itself
 * undetected: W of (N14) without the reach. */
double scene_way(const Scene *scene);

/* Sets the ghosts of kin (segments -1 and n) to the motion of the ground at time t. */
void scene_ghosts(const Scene *scene, double t, Kinematics *kin);

#endif
