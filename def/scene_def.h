/* Conditions of a chain apart from equipment: surrounding air or water, and initial speeds. Parts of SceneDef
 * (def/scene_def.h). SI; components are the world's. */
#ifndef HAWSER_DEF_SCENE_DEF_H
#define HAWSER_DEF_SCENE_DEF_H

#include "contact/law.h"
#include "contact/shape.h"
#include "contact/surface.h"
#include "core/chain.h"
#include "core/file.h"
#include "core/profile.h"
#include "core/route.h"
#include "core/vec3.h"
#include "def/bundle_def.h"
#include "def/cable_def.h"
#include "def/command_def.h"
#include "def/environment_def.h"
#include "def/output_def.h"
#include "def/reel_def.h"
#include "def/rod_def.h"
#include "hawser/hawser.h"
#include "linsolve/linsolve.h"

/* A fluid that fills all space with a uniform current. docs/theory/82-medium.md (MD1)-(MD6). */
typedef struct MediumDef {
    double density;            /* kg/m3; 0: there is none */
    Vec3 velocity;             /* m/s: the current or the wind */
    double normal, tangential; /* drag coefficients across (by the diameter) and along (by the circumference), 1 */
    int buoyancy;              /* the fluid carries the weight of the displaced volume */
} MediumDef;

/* Velocity at a place of the chain. */
typedef struct LaunchRow {
    double at;     /* m from the tail */
    double along;  /* m/s, along the chain toward the head */
    Vec3 velocity; /* m/s, added to that */
} LaunchRow;

/* Motion of the chain at t = 0: the sum of all these. (MD7), (MD8) */
typedef struct LaunchDef {
    int present;
    double along;        /* m/s, of the whole chain along itself */
    Vec3 velocity, spin; /* m/s, rad/s: of the whole chain as a rigid body about `about` */
    int about_given;
    Vec3 about; /* m; if it is not given, the centre of mass */
    int n_rows;
    LaunchRow *row; /* [n_rows], owned; by rising place, linear between, constant outside */
} LaunchDef;

/* Origin of a friction coefficient, on which judging depends. */

/* Given by the case; typical of a named item (an entry of the catalogue, rollers); unknown. */
typedef enum FrictionSource { FRICTION_GIVEN, FRICTION_TYPICAL, FRICTION_UNKNOWN } FrictionSource;

/* Knowledge about a friction coefficient; all zeros: given. */
typedef struct FrictionKnown {
    FrictionSource source;
    double low, high; /* FRICTION_TYPICAL: usual range of the kinetic coefficient */
    char of[64];      /* FRICTION_TYPICAL: name of the item */
    int rest_assumed; /* one coefficient stands for motion and rest */
    int apart;        /* the kinetic coefficient has the key mu_d, not mu */
    char key[40];     /* of the section that gives or would give it: "surfaces.ducts.0.friction"; empty: "friction" */
} FrictionKnown;

/* Languages of a calculation's printed sheet; the program's own messages are English. */

typedef enum Language { LANGUAGE_ENGLISH, LANGUAGE_CHINESE, LANGUAGE_GERMAN, LANGUAGES } Language;

/* Numerical settings of a case: tolerances, order, relaxation, linear solver. See def/scene_def.h. */

/* Choice of solving a planar scene in its plane (sim/solve/planar.h): where possible; required, else an error; never.
 */
typedef enum PlanarChoice { PLANAR_AUTO, PLANAR_ON, PLANAR_OFF } PlanarChoice;

/* Choice of repeating a whole run with finer settings: if only numerical errors leave the verdict open and it does not
 * take too long; never; however long it takes. */
typedef enum PassesChoice { PASSES_AUTO, PASSES_ONE, PASSES_TWO, PASSES_THREE } PassesChoice;

/* Method of integration in time: backward differences, or Runge-Kutta steps (sim/solve/esdirk.h). */
typedef enum MethodChoice { METHOD_AUTO, METHOD_BDF, METHOD_ESDIRK } MethodChoice;

/* Motion of the chain: the equations of motion; positions in steady motion where possible (sim/run/quasi_data.h); the
 * same, required, else an error. */
typedef enum MotionChoice { MOTION_DYNAMIC, MOTION_AUTO, MOTION_QUASI_STATIC } MotionChoice;

typedef struct SolverDef {
    double accuracy;                                                /* one number for all tolerances */
    double atol_position, atol_rotation, atol_velocity, atol_omega; /* 0: from accuracy and the scales */
    int max_order;                                                  /* BDF, 1..5 */
    double max_step;                                                /* s, 0: none */
    double first_step;                                              /* s, 0: CVODE's choice */
    long max_steps;                                                 /* 0: none */
    double imperfection;    /* bow of a cable in compression as a share of a half wave; 0: none */
    int relax;              /* bring to equilibrium before t = 0 */
    double relax_tolerance; /* fraction of the largest segment weight or load */
    int relax_iterations;
    LinOptions linear;
    PlanarChoice planar;
    PassesChoice passes;
    MethodChoice method;
    MotionChoice motion;
    int threads;
} SolverDef;

/* Content of a case as plain data with defaults: the case reader fills it, scene_build() turns it into a Scene.
 * SI units. Arrays are malloc'ed and owned by the SceneDef; scene_def_clear() frees them. */

/* Drive of a turning roller. Speeds are those of its surface; torques and speeds count with the pull. */
typedef enum MotorKind { MOTOR_NONE, MOTOR_TORQUE, MOTOR_SPEED } MotorKind;

typedef struct MotorDef {
    MotorKind kind;
    Profile set;        /* N m; m/s */
    double factor;      /* MOTOR_SPEED: factor on the winch's speed; 0: by `set` */
    double limit;       /* MOTOR_SPEED: largest torque in either direction, N m */
    double speed_limit; /* MOTOR_TORQUE: speed at which the torque has fallen to zero, m/s; 0: none */
    double droop;       /* m/s over which the torque changes (SP16) */
} MotorDef;

/* A turning roller: inertia about its axis, bearing (sim/equipment/rollers.h), motor. */
typedef struct SpinDef {
    double inertia;                          /* kg m2; 0: it does not spin */
    double friction, journal, torque, speed; /* 1, m, N m, rad/s */
    MotorDef motor;
} SpinDef;

/* A roller on a bushing mount; components along the roller's axis, along the route, up, then rotations about these. */
typedef struct MountDef {
    int present;
    double stiffness[6];  /* N/m, N m/rad */
    double damping;       /* s: C = damping * K */
    double mass, inertia; /* kg; kg m2 about every axis (a spinning roller's own axis: without its spin.inertia) */
} MountDef;

typedef struct RollerDef {
    char name[NAME_MAX_LENGTH];
    Vec3 centre, axis;    /* m, unit */
    double radius, width; /* m; as in Shape; width is its whole length */
    ShapeKind profile;
    union { /* unused by a cylinder */
        Groove groove;
        BoxSection box; /* of an obstacle, which theory does not treat as a roller: its s is NAN */
        BellRing bell;
    };
    double rating; /* N; 0: none given */
    double s;      /* m along the route, for tables; NAN if listed by coordinates */
    int hold_down;
    FrictionLaw friction;
    FrictionKnown friction_known;
    SpinDef spin;
    MountDef mount;
} RollerDef;

/* A duct, tray, floor or wall. Those along the route share no stretch of it. */
typedef struct SurfaceDef {
    char name[NAME_MAX_LENGTH];
    SurfaceShape shape;
    FrictionLaw friction;
    FrictionKnown friction_known;
    double bore; /* m, a duct's inside radius if shape.radius is that of a bundle's room (BU8); 0: they are equal */
    double weight_factor; /* of a duct with several chains in it: w_c, for theory alone (SC15); 0: none */
    DuctLying lying;      /* cables that lie in a duct already */
    DuctDef several;      /* their layout; cables 0: a single one, or no formula applies */
} SurfaceDef;

typedef struct LeadInDef {
    int present;
    int carries_weight; /* the lead-in carries the cable's weight component along the slope too, as a reel would */
    double blend;       /* m over which the weight sets in at the route's start */
} LeadInDef;

/* Action of a winch at too large a force: it stops, and may start again. */
typedef struct TripDef {
    double force;  /* N; 0: given by the factor */
    double factor; /* times the reference theory's winch force; both 0: it never trips */
    double hold;   /* s for which the force must stay above before it counts */
    double brake;  /* s from full speed to rest */
    double pause;  /* s at rest before a restart */
    double ramp;   /* s from rest back to the earlier speed */
    int restarts;  /* number of restarts; after one more trip the winch stays stopped */
    int ends_run;  /* a winch that stays stopped ends the run */
} TripDef;

typedef enum WinchMode { WINCH_SPEED, WINCH_TENSION } WinchMode;

typedef struct WinchDef {
    int present;
    int axial_only; /* holds the head along the pull only; otherwise it clamps it (a rope that continues in the air) */
    WinchMode mode;
    Profile speed;      /* m/s along the route's end direction */
    Profile tension;    /* N, for WINCH_TENSION */
    double speed_limit; /* m/s, for WINCH_TENSION; 0: none */
    double band;        /* share of the limit over which the force falls off */
    double drum_mass;   /* kg, for WINCH_TENSION: inertia of the drum over its radius squared */
    TripDef trip;       /* for WINCH_SPEED */
    int take_in;        /* segments past the winch leave the chain */
    double at;          /* m along the route: place of the winch for take_in; NAN: see scene_take_in_place */
} WinchDef;

typedef struct TailDef {
    int given;
    Profile tension; /* N, back along the route's start direction */
} TailDef;

/* A caterpillar conveyor: two belts that clamp the cable over a stretch of the route. */
typedef struct ConveyorDef {
    char name[NAME_MAX_LENGTH];
    double from, to; /* m along the route; the machine is straight */
    double edge;     /* m at both ends over which the grip rises from zero */
    int sync;        /* the belt runs with the winch, at `factor` times its speed */
    double factor;
    Profile speed;          /* m/s, of the belt otherwise */
    double clamp;           /* N, clamping force of each belt */
    double mu;              /* between belt and cable: the grip is 2 mu clamp */
    double limit;           /* N, of the drive; 0: none */
    double v_s, v_d, ratio; /* velocity function: v_s, v_d m/s; ratio = mu_d / mu_s */
    int hold;               /* keeps the cable on the machine's line */
    int grips_rope;         /* the belts grip the rope too, not only the cable */
} ConveyorDef;

/* A roller or machine that stops during the run. Times in s, places of the cable's front in m along the route: one of
 * each pair, the other is NAN; without a release both are. */
typedef struct JamDef {
    char what[NAME_MAX_LENGTH]; /* its name */
    double at, head_at;
    double release, release_head_at;
    double ramp;     /* s, duration of stopping and of starting */
    double friction; /* friction coefficient of the cable on a blocked roller; NAN: the usual one */
} JamDef;

/* Texts in the head and the foot of a calculation's printed sheet. */
typedef struct JobDef {
    Language language;
    char client[96], project[96], drawing[64], author[64], checker[64], revision[32], date[32];
} JobDef;

typedef struct SceneDef {
    char title[256];
    JobDef job;
    int format;   /* of its case */
    Vec3 gravity; /* m/s2 */
    BushingFrame frame;

    int n_cables;
    CableDef *cables;
    int n_pieces;
    ChainPieceDef *pieces;
    BundleDef bundle; /* the cables that the cable before the eye represents */

    int n_route;
    RoutePieceDef *route;
    Vec3 route_origin; /* m, in the case's coordinates: origin of all others here, and of those in results */
    Vec3 route_start;
    double route_heading, route_slope;
    double route_north; /* rad from x toward y; NAN: not known */
    int slopes_open;    /* the case gives no radius for changes of slope */
    double head_at;     /* m along the route where the cable's front (the eye before the last rope piece) is at t = 0 */
    LeadInDef lead_in;

    ContactGeometry geometry;
    ImpactLaw impact;
    FrictionLaw friction; /* default of every roller, and the theory's mu (mu_d) */
    FrictionKnown friction_known;
    double contact_reach;       /* m: contact candidates are searched again after this much motion */
    int cable_on_cable;         /* the cable touches itself */
    FrictionLaw cable_friction; /* between cables */
    int n_rollers;
    RollerDef *rollers;
    ImpactLaw line_impact; /* per metre of cable on a surface */
    int n_surfaces;
    SurfaceDef *surfaces;
    EnvironmentDef environment;

    WinchDef winch;
    TailDef tail;
    ReelDef reel;
    DrumDef drum;
    RopeDragDef drag;

    int n_conveyors;
    ConveyorDef *conveyors;
    int n_jams;
    JamDef *jams;
    int n_script;
    ScriptDef *script; /* by rising time */
    LaunchDef launch;
    MediumDef medium;
    RodDef rod; /* replaces a route: n_route is then one straight of the chain's length */

    int n_stations;
    StationDef *stations;
    int n_paper;
    PaperTermDef *paper; /* 0 terms: computed from the route */
    TheoryDef theory;
    LimitsDef limits;

    AnalysisDef analysis;
    SolverDef solver;
    OutputDef output;
    double duration;   /* s */
    int keep_going;    /* even after the cable has left its supports, for inspection */
    int duration_open; /* neither the case nor its winch gives a duration: it can be calculated, but not run */

    StrandDef strand; /* of several chains: this one, */
    TiesDef ties;     /* the ties between them, */
    int n_beside, between_chains;
    struct SceneDef *beside; /* [n_beside] the others, whose own such fields are empty; contact if between_chains */
    int n_drawn, n_assumptions, n_inputs, inputs_size;
    DrawnDef *drawn;
    hawser_assumption *assumptions; /* values that the case did not give */
    char *inputs;                   /* [inputs_size] n_inputs times INPUT_TEXTS texts, each with a NUL */
    FileMarks files;                /* files it was read from */
} SceneDef;

/* Arrays owned by a definition: OWNED(array, n) for each, used for copying and clearing. Tables of profiles and further
 * chains are handled in def/scene_def.c. */
#define SCENE_OWNED(OWNED)                                                                                             \
    OWNED(cables, n_cables)                                                                                            \
    OWNED(pieces, n_pieces)                                                                                            \
    OWNED(route, n_route)                                                                                              \
    OWNED(rollers, n_rollers)                                                                                          \
    OWNED(surfaces, n_surfaces)                                                                                        \
    OWNED(conveyors, n_conveyors)                                                                                      \
    OWNED(jams, n_jams)                                                                                                \
    OWNED(script, n_script)                                                                                            \
    OWNED(stations, n_stations)                                                                                        \
    OWNED(paper, n_paper)                                                                                              \
    OWNED(launch.row, launch.n_rows)                                                                                   \
    OWNED(output.speed_segments, output.n_speed_segments)                                                              \
    OWNED(output.load_rollers, output.n_load_rollers)                                                                  \
    OWNED(output.probes, output.n_probes)                                                                              \
    OWNED(analysis.positions.at, analysis.positions.n)                                                                 \
    OWNED(drawn, n_drawn)                                                                                              \
    OWNED(assumptions, n_assumptions)                                                                                  \
    OWNED(inputs, inputs_size)                                                                                         \
    OWNED(files.mark, files.n)                                                                                         \
    OWNED(theory.wear, theory.n_wear)                                                                                  \
    OWNED(theory.friction, theory.n_friction)                                                                          \
    OWNED(theory.machines, theory.n_machines)                                                                          \
    OWNED(theory.pits, theory.n_pits)                                                                                  \
    OWNED(rod.points, rod.n_points)                                                                                    \
    OWNED(rod.masses, rod.n_masses)                                                                                    \
    OWNED(rod.loads, rod.n_loads)                                                                                      \
    OWNED(rod.end[ROD_TAIL].motions, rod.end[ROD_TAIL].n_motions)                                                      \
    OWNED(rod.end[ROD_HEAD].motions, rod.end[ROD_HEAD].n_motions)
/* Record of a key of the case for readers of the results: its dotted name, its value as written, the unit if it is a
 * number, "given", "catalogue", "estimated" or "default", file and line, and the source of a value that was not given.
 */
enum { INPUT_KEY, INPUT_VALUE, INPUT_UNIT, INPUT_ORIGIN, INPUT_WHERE, INPUT_SOURCE, INPUT_TEXTS };

void scene_def_defaults(SceneDef *def); /* sets every default; docs/reference/case-keys.md lists them */
void scene_def_clear(SceneDef *def);
/* Number of pieces of the chain that are the cable, from the tail on; those after them are the rope. */
int scene_def_eye(const SceneDef *def);
/* Largest speed that a winch is set to up to a time, m/s; for a set tension its limit, 0: none. */
double winch_def_largest_speed(const WinchDef *winch, double until);
/* Number of segments of the whole chain, and the length of each from the tail on, m: length [segments]. */
int scene_def_segments(const SceneDef *def);
void scene_def_cut(const SceneDef *def, double *length);
/* Shape of a roller's contact surface; length of cable that roller r carries, m (INFINITY: it is the only one; 0:
 * unknown). */
Shape roller_def_shape(const RollerDef *roller);
double roller_def_span(const SceneDef *def, int r);
/* Checks whether a surface runs along the route; its friction in theory: a V with both sides, a duct as it is filled.
 */
int surface_along_route(const SurfaceDef *surface);
double surface_theory_friction(const SceneDef *def, const SurfaceDef *surface, int in_bend);
double surface_flank(
    const SurfaceDef *surface); /* lateral force that it bears per vertical force, 1; INFINITY: it has sides */
int scene_def_sticks(const SceneDef *def); /* some friction has bristles, whose state is carried from step to step */
/* Name of the i-th item that can jam, rollers first; NULL beyond the last. */
const char *scene_def_can_jam(const SceneDef *def, int i);
/* Copies deeply into *out. Errors: MEMORY (then *out is cleared). */
hawser_status scene_def_copy(const SceneDef *def, SceneDef *out, hawser_error *err);
/* Refines the numerical settings by level[s] of source s (hawser/certify.h); below 0 it coarsens (CE1). */
void scene_def_refine(SceneDef *def, const int level[HAWSER_SOURCES]);
/* Refines by one level of each source for a run's next pass, with the rows of the last pass; slower: v_s too. */
void scene_def_finer_pass(SceneDef *def, int slower);
/* Factor of one level of refinement: for time that of accuracy. */
double refinement_ratio(hawser_source source);
/* Ratio of v_s at that level of time to the case's; 1 if no friction decays at low speed. */
double refinement_slower(const SceneDef *def, int level);

#endif
