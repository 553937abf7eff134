/* What a case says of a chain away from equipment: the air or water around it, and the speeds it begins with. Parts of
 * SceneDef (def/scene_def.h). SI; components are the world's. */
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
#include "def/output_def.h"
#include "def/reel_def.h"
#include "def/rod_def.h"
#include "hawser/hawser.h"
#include "linsolve/linsolve.h"

/* A fluid that fills all space and streams evenly. docs/model/82-medium.md (MD1)-(MD6). */
typedef struct MediumDef {
    double density;            /* kg/m3; 0: there is none */
    Vec3 velocity;             /* m/s: the current or the wind */
    double normal, tangential; /* drag coefficients across (by the diameter) and along (by the circumference), 1 */
    int buoyancy;              /* the fluid carries the weight of what the chain displaces */
} MediumDef;

/* Velocity at a place of the chain. */
typedef struct LaunchRow {
    double at;     /* m from the tail */
    double along;  /* m/s, along the chain toward the head */
    Vec3 velocity; /* m/s, added to that */
} LaunchRow;

/* How the chain moves at t = 0: the sum of all these. (MD7), (MD8) */
typedef struct LaunchDef {
    int present;
    double along;        /* m/s, of the whole chain along itself */
    Vec3 velocity, spin; /* m/s, rad/s: of the whole chain as a rigid body about `about` */
    int about_given;
    Vec3 about; /* m; if it is not given, the centre of mass */
    int n_rows;
    LaunchRow *row; /* [n_rows], owned; places rise, between two it is linear, outside as at the nearest */
} LaunchDef;

/* Where a coefficient of friction comes from: what is judged by it depends on that. */

/* The case gives it; it is typical of what is named (an entry of the catalogue, rollers); nothing is known of it. */
typedef enum FrictionSource { FRICTION_GIVEN, FRICTION_TYPICAL, FRICTION_UNKNOWN } FrictionSource;

/* All zeros: given. */
typedef struct FrictionKnown {
    FrictionSource source;
    double low, high; /* FRICTION_TYPICAL: between which the coefficient in motion usually lies */
    char of[64];      /* FRICTION_TYPICAL: of what */
    int rest_assumed; /* one coefficient stands for motion and rest */
    char key[40];     /* of the section that gives it, or would: "surfaces.ducts.0.friction"; empty: "friction" */
} FrictionKnown;

/* The languages of a calculation that is handed on; English is what the program says by itself. */

typedef enum Language { LANGUAGE_ENGLISH, LANGUAGE_CHINESE, LANGUAGE_GERMAN, LANGUAGES } Language;

/* How a case is computed: tolerances, order, relaxation, linear solver. See def/scene_def.h. */

/* Whether a scene that lies in one plane is solved there (sim/solve/planar.h): where it can be; or else it is an error;
 * never.
 */
typedef enum PlanarChoice { PLANAR_AUTO, PLANAR_ON, PLANAR_OFF } PlanarChoice;

/* Whether a whole run may be computed a second time with finer settings: where only numerical errors are left open and
 * it does not take too long; never; however long it takes. */
typedef enum PassesChoice { PASSES_AUTO, PASSES_ONE, PASSES_TWO, PASSES_THREE } PassesChoice;

/* The method of integration in time: backward differences, or Runge-Kutta steps (sim/solve/esdirk.h). */
typedef enum MethodChoice { METHOD_AUTO, METHOD_BDF, METHOD_ESDIRK } MethodChoice;

/* What moves the chain: the equations of motion; positions in steady motion wherever that may be
 * (sim/run/quasi_data.h); the same, and a scene that cannot be is an error. */
typedef enum MotionChoice { MOTION_DYNAMIC, MOTION_AUTO, MOTION_QUASI_STATIC } MotionChoice;

typedef struct SolverDef {
    double accuracy;                                                /* one number for all tolerances */
    double atol_position, atol_rotation, atol_velocity, atol_omega; /* 0: from accuracy and the scales */
    int max_order;                                                  /* BDF, 1..5 */
    double max_step;                                                /* s, 0: none */
    double first_step;                                              /* s, 0: CVODE's choice */
    long max_steps;                                                 /* 0: none */
    double imperfection;    /* of a cable that is pushed: its bow as a share of a half wave; 0: none */
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

/* What a case says, as plain data with defaults: the case reader fills it, scene_build() turns it into a Scene.
 * SI units. Arrays are malloc'ed and owned by the SceneDef; scene_def_clear() frees them. */

/* The drive of a roller that spins. Speeds are those of its surface; torques and speeds are with the pull. */
typedef enum MotorKind { MOTOR_NONE, MOTOR_TORQUE, MOTOR_SPEED } MotorKind;

typedef struct MotorDef {
    MotorKind kind;
    Profile set;        /* N m; m/s */
    double factor;      /* MOTOR_SPEED: runs with the winch at so many times its speed; 0: by `set` */
    double limit;       /* MOTOR_SPEED: the largest torque, either way, N m */
    double speed_limit; /* MOTOR_TORQUE: where the torque has fallen to zero, m/s; 0: nowhere */
    double droop;       /* m/s over which the torque changes (SP16) */
} MotorDef;

/* A roller that spins: inertia about its axis, bearing (sim/equipment/rollers.h), motor. */
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
    union { /* unless the profile is a cylinder's */
        Groove groove;
        BoxSection box; /* of an obstacle, which is no roller to theory: its s is NAN */
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
    double bore; /* m, a duct's inside radius where shape.radius is that of a bundle's room (BU8); 0: it is that */
    double weight_factor; /* of a duct with several chains in it: w_c, for theory alone (SC15); 0: none */
    DuctLying lying;      /* cables that lie in a duct already */
    DuctDef several;      /* how these lie in it; cables 0: one lies there, or no formula knows */
} SurfaceDef;

typedef struct LeadInDef {
    int present;
    int carries_weight; /* the lead-in carries the cable's weight along the slope too, as a reel would */
    double blend;       /* m over which the weight comes in at the route's start */
} LeadInDef;

/* What a winch does when the force is too large: brakes, and perhaps starts again. */
typedef struct TripDef {
    double force;  /* N; 0: by the factor */
    double factor; /* times the reference theory's winch force; both 0: it never trips */
    double hold;   /* s for which the force must stay above before it counts */
    double brake;  /* s from full speed to rest */
    double pause;  /* s at rest before a restart */
    double ramp;   /* s from rest back to the speed before */
    int restarts;  /* how many; after the next trip it stays */
    int ends_run;  /* a winch that stays ends the run */
} TripDef;

typedef enum WinchMode { WINCH_SPEED, WINCH_TENSION } WinchMode;

typedef struct WinchDef {
    int present;
    int axial_only; /* holds the head along the pull only; otherwise it clamps it (a rope that runs on in the air) */
    WinchMode mode;
    Profile speed;      /* m/s along the route's end direction */
    Profile tension;    /* N, WINCH_TENSION */
    double speed_limit; /* m/s, WINCH_TENSION; 0: none */
    double band;        /* share of the limit over which the force falls off */
    double drum_mass;   /* kg, WINCH_TENSION: inertia of the drum over its radius squared */
    TripDef trip;       /* WINCH_SPEED */
    int take_in;        /* segments past the winch leave the chain */
    double at;          /* m along the route: where it stands, for take_in; NAN: see scene_take_in_place */
} WinchDef;

typedef struct TailDef {
    int given;
    Profile tension; /* N, back along the route's start direction */
} TailDef;

/* A caterpillar conveyor: two belts that clamp the cable over a stretch of the route. */
typedef struct ConveyorDef {
    char name[NAME_MAX_LENGTH];
    double from, to; /* m along the route; the machine is straight */
    double edge;     /* m at both ends over which the grip rises from nothing */
    int sync;        /* the belt runs with the winch, at `factor` times its speed */
    double factor;
    Profile speed;          /* m/s, of the belt otherwise */
    double clamp;           /* N, by which each belt is pressed on the cable */
    double mu;              /* of belt on cable: the grip is 2 mu clamp */
    double limit;           /* N, of the drive; 0: none */
    double v_s, v_d, ratio; /* velocity function: v_s, v_d m/s; ratio = mu_d / mu_s */
    int hold;               /* holds the cable on the machine's line */
    int grips_rope;         /* the belts close on the rope too, not on cable alone */
} ConveyorDef;

/* A roller or machine that stops in mid-run. Times in s, places of the cable's front in m along the route: one of each
 * pair, the other NAN; no release: both. */
typedef struct JamDef {
    char what[NAME_MAX_LENGTH]; /* its name */
    double at, head_at;
    double release, release_head_at;
    double ramp;     /* s, over which it stops and starts */
    double friction; /* coefficient with which the cable drags over a roller that stands; NAN: the usual */
} JamDef;

/* What stands in the head and the foot of a calculation that is handed on. */
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
    BundleDef bundle; /* what the cable before the eye stands for */

    int n_route;
    RoutePieceDef *route;
    Vec3 route_origin; /* m, of the case's coordinates: all others here, and those of results, count from it */
    Vec3 route_start;
    double route_heading, route_slope;
    double route_north; /* rad from x toward y; NAN: not known */
    int slopes_open;    /* no radius is given for changes of slope */
    double head_at;     /* m along the route where the cable's front (the eye before the last rope piece) is at t = 0 */
    LeadInDef lead_in;

    ContactGeometry geometry;
    ImpactLaw impact;
    FrictionLaw friction; /* default of every roller, and the theory's mu (mu_d) */
    FrictionKnown friction_known;
    double contact_reach;       /* m: candidates are refreshed after this much motion */
    int cable_on_cable;         /* the cable touches itself */
    FrictionLaw cable_friction; /* there */
    int n_rollers;
    RollerDef *rollers;
    ImpactLaw line_impact; /* for each metre of cable on a surface */
    int n_surfaces;
    SurfaceDef *surfaces;

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
    ScriptDef *script; /* by time */
    LaunchDef launch;
    MediumDef medium;
    RodDef rod; /* in place of a route: n_route is then one straight of the chain's length */

    int n_stations;
    StationDef *stations;
    int n_paper;
    PaperTermDef *paper; /* 0 terms: taken from the route */
    TheoryDef theory;
    LimitsDef limits;

    AnalysisDef analysis;
    SolverDef solver;
    OutputDef output;
    double duration;   /* s */
    int keep_going;    /* though the cable has left what carries it: somebody wants to look */
    int duration_open; /* neither the case nor its winch says how long: it can be calculated, but not run */

    StrandDef strand; /* of several chains: this one, */
    TiesDef ties;     /* what ties them together, */
    int n_beside, between_chains;
    struct SceneDef *beside; /* [n_beside] the others, whose own of this are empty; they touch if between_chains */
    int n_drawn, n_assumptions, n_inputs, inputs_size;
    DrawnDef *drawn;
    hawser_assumption *assumptions; /* what the case did not say itself */
    char *inputs;                   /* [inputs_size] n_inputs times INPUT_TEXTS texts, each with a NUL */
    FileMarks files;                /* from which it was read */
} SceneDef;

/* What a definition owns: OWNED(array, n) for each; copying and clearing go over it. Tables of profiles and the chains
 * beside it are in def/scene_def.c. */
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
/* What is known of a key of the case, for those who read the results: its dotted name, its value as it was written, the
 * unit of that if it is a number, "given", "catalogue", "estimated" or "default", file and line, and where a value
 * comes from that was not given. */
enum { INPUT_KEY, INPUT_VALUE, INPUT_UNIT, INPUT_ORIGIN, INPUT_WHERE, INPUT_SOURCE, INPUT_TEXTS };

void scene_def_defaults(SceneDef *def); /* every default there is; docs/case-format.md lists them */
void scene_def_clear(SceneDef *def);
/* How many pieces of the chain are the cable, from the tail on; those behind them are the rope. */
int scene_def_eye(const SceneDef *def);
/* m/s, the largest speed that a winch is set to up to a time; of one that sets a tension its limit, 0: it has none. */
double winch_def_largest_speed(const WinchDef *winch, double until);
/* Segments of the whole chain, and the length of each from the tail on, m: length [segments]. */
int scene_def_segments(const SceneDef *def);
void scene_def_cut(const SceneDef *def, double *length);
/* What the cable touches of a roller; m of cable that roller r holds up (INFINITY: the only one; 0: not known). */
Shape roller_def_shape(const RollerDef *roller);
double roller_def_span(const SceneDef *def, int r);
/* Whether a surface runs along the route; its friction as theory sees it: a V by both sides, a duct as it is filled. */
int surface_along_route(const SurfaceDef *surface);
double surface_theory_friction(const SceneDef *def, const SurfaceDef *surface, int in_bend);
double surface_flank(const SurfaceDef *surface); /* that it bears aside for each newton down; INFINITY: has sides */
int scene_def_sticks(const SceneDef *def);       /* whether any friction does: its bristles move from step to step */
/* The name of the i-th thing that can jam, rollers first; NULL behind the last. */
const char *scene_def_can_jam(const SceneDef *def, int i);
/* A deep copy into *out. Errors: MEMORY (then *out is cleared). */
hawser_status scene_def_copy(const SceneDef *def, SceneDef *out, hawser_error *err);
/* Makes the numerical settings finer, level[s] times by source s (hawser/certify.h), coarser below 0 (CE1). */
void scene_def_refine(SceneDef *def, const int level[HAWSER_SOURCES]);
/* The same by a level of each source for a run's next pass, whose rows are those of the last; slower: v_s too. */
void scene_def_finer_pass(SceneDef *def, int slower);
/* How many times finer one level is: of time in accuracy. */
double refinement_ratio(hawser_source source);
/* v_s at that level of time over the case's; 1 where no friction fades at low speed. */
double refinement_slower(const SceneDef *def, int level);

#endif
