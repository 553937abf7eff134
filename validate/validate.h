/* The validation suite: scenes made in code, run, and compared with what is known of them from other sources. A case is
 * a function that adds rows to a log; the cases of one subject are in one file and one table. */
#ifndef HAWSER_VALIDATE_VALIDATE_H
#define HAWSER_VALIDATE_VALIDATE_H

#include "core/state.h"
#include "core/vec3.h"
#include "hawser/hawser.h"
#include "sim/run/sim.h"
#include "sim/run/stage.h"

enum { VALIDATION_QUANTITY_MAX = 64 };

/* Allowed difference of `found` from `expected`: a share of it, in its unit, or `expected` is an upper limit. */
typedef enum ValidationKind { WITHIN_SHARE, WITHIN, AT_MOST } ValidationKind;

typedef struct ValidationCase ValidationCase;

/* One quantity of a case. */
typedef struct ValidationRow {
    const ValidationCase *of;
    char quantity[VALIDATION_QUANTITY_MAX];
    const char *unit;
    ValidationKind kind;
    double expected, found;
    double tolerance; /* %, or the quantity's unit */
    double error;     /* likewise, with its sign */
    int ok;
} ValidationRow;

typedef struct ValidationLog {
    int n, room;
    ValidationRow *row;                                         /* [n], owned */
    const ValidationCase *now;                                  /* the case that is running */
    char failure[VALIDATION_QUANTITY_MAX + HAWSER_MESSAGE_MAX]; /* of the last case that could not be run */
    int no_memory;
} ValidationLog;

struct ValidationCase {
    const char *name;   /* lower case, words joined by dashes */
    const char *proves; /* in a few words */
    const char *source; /* of the expected value */
    int fast;           /* 1: takes a moment: part of the default tests */
    const void *setup;  /* argument of `run`, for cases that share it */
    /* Adds the case's rows. An error is that of a scene that could not be built or run. */
    hawser_status (*run)(const void *setup, ValidationLog *log, hawser_error *err);
};

/* The tables of cases, one per subject. */
typedef struct ValidationGroup {
    int n;
    const ValidationCase *cases; /* [n] */
} ValidationGroup;

/* A group of all the cases of an array. */
#define VALIDATION_GROUP(array)                                                                                        \
    {                                                                                                                  \
        .n = (int)(sizeof(array) / sizeof(array)[0]), .cases = (array)                                                 \
    }
extern const ValidationGroup rod_group, stability_group, frequency_group, paper_group, row_group, duct_group,
    roller_group, wave_group, motion_group, flight_group, frame_group, slip_group, buckling_group, convergence_group;

/* Adds a quantity of the running case. Tolerance: per cent of `expected`. */
void log_share(ValidationLog *log, const char *quantity, const char *unit, double expected, double found,
               double percent);
/* Tolerance in the quantity's unit. */
void log_near(ValidationLog *log, const char *quantity, const char *unit, double expected, double found,
              double tolerance);
/* Adds a quantity that should be small: at most `limit`. */
void log_limit(ValidationLog *log, const char *quantity, const char *unit, double found, double limit);
/* Adds the relative errors of n refinements, without limits, and their order over x (`of`: name of x), which should be
 * near `expected`. */
void order_log(ValidationLog *log, int n, const double *x, const double *error, const char *of, double expected,
               double tolerance);
/* Case number i of the suite, in its order; NULL behind the last. */
const ValidationCase *validation_case(int i);
/* Runs the cases whose names contain `filter` (NULL: all), only the fast ones if `fast`, in the suite's order. A case
 * that fails adds a row that is not ok. Returns the number run in *ran. Errors: MEMORY. */
hawser_status validation_run(const char *filter, int fast, ValidationLog *log, int *ran, hawser_error *err);
void validation_clear(ValidationLog *log);
/* Number of quantities that are not ok. */
int validation_outside(const ValidationLog *log);
/* Definitions of scenes for the suite, and pulls that are run from them. */

/* Largest numbers of pieces of route, rollers, surfaces, stations, terms of the paper. */
enum { ROUTE_MOST = 8, ROLLERS_MOST = 256, SURFACES_MOST = 1, STATIONS_MOST = 40, PAPER_MOST = 8 };

/* Defaults, two empty kinds of cable and pieces of chain, and empty arrays of those lengths. Errors: MEMORY (then
 * nothing is left allocated). */
hawser_status build_start(SceneDef *def, hawser_error *err);
/* A cable of EI in both directions (N m2), GJ the same, GA 0.4 EA; kg/m, m, N; damped by 2 ms. */
CableDef build_cable(double mass, double diameter, double ea, double ei);
/* The whole chain: one cable in n segments. */
void build_chain(SceneDef *def, CableDef cable, double length, int n);
/* The route's next piece: m; a bend's plane as in RoutePieceDef, rad. */
void build_straight(SceneDef *def, double length);
void build_bend(SceneDef *def, double radius, double angle, double plane);
void build_station(SceneDef *def, const char *name, double s);
/* A roller 0.6 m wide under a cable of this diameter on the route at s; m. */
void build_roller(SceneDef *def, const Route *route, double radius, double diameter, double s);
/* The route of the definition so far; route_clear frees it. Errors: MEMORY. */
hawser_status build_route(const SceneDef *def, Route *route, hawser_error *err);
/* Starts the definition of one cable in n segments on a level straight of its length. Errors: as build_start. */
hawser_status build_line(SceneDef *def, CableDef cable, double length, int n, hawser_error *err);
/* Pulls at the head, up to `speed` (m/s) in t1 s: clamped, or (axial) held along the pull only. */
void build_pull(SceneDef *def, double speed, double t1, int axial);
/* Builds the simulation and brings it to equilibrium. The definition is used up in any case; *out is NULL after an
 * error: as sim_new, and RUN if there is no equilibrium. */
hawser_status pull_start(SceneDef *def, Sim **out, hawser_error *err);
/* Starts, and runs to the definition's end with statistics every 50 ms. */
hawser_status pull_run(SceneDef *def, Sim **out, hawser_error *err);
/* ---- Rods: chains without a route, weightless and straight along x unless set otherwise (validate/rod_cases.c). */

/* A rod of n segments and `length` (m) of this cable, with room for 3 loads and 1 motion of the head; its ends are
 * free. Undamped, no gravity; statics in `steps` load steps from t = 0 to 1 s. Errors: MEMORY (nothing is left
 * allocated). */
hawser_status rod_start(SceneDef *def, CableDef cable, double length, int n, int steps, hawser_error *err);
/* Holds every component of an end. */
void rod_clamp(RodEndDef *end);
/* Holds the place alone: the end is free to rotate. */
void rod_pin(RodEndDef *end);
/* A value in a direction: constant, or growing from zero at t = 0 in proportion to time to this size at 1 s. The latter
 * owns a table. Errors: MEMORY. */
RodProfile rod_steady(Vec3 direction, double size);
hawser_status rod_growing(Vec3 direction, double size, RodProfile *out, hawser_error *err);
/* Adds a dead force (N) or moment (N m) at `at` m from the tail. */
void rod_add_load(SceneDef *def, double at, int moment, RodProfile by);
/* ---- The paper's case: cases/huangjiahu.yaml in code, which a test compares with the file
 * (validate/paper_cases.c). */

/* Changes of the case; zeros: none. */
typedef struct PaperChoice {
    double ei;       /* N m2, of the cable */
    double segment;  /* m */
    double accuracy; /* of the integration */
    double v_s;      /* m/s, sliding speed of full friction, of rollers and rope drag */
    int rollers;     /* number under the 58.5 m */
    double onward;   /* m past the tunnel's end with further rollers at the same distance */
    double stiffer;  /* factor on the contacts' stiffness */
    int capsules;    /* 1: the contact line of straight segments in place of the smooth one */
} PaperChoice;

/* Errors: MEMORY. */
hawser_status paper_scene(const PaperChoice *choice, SceneDef *def, hawser_error *err);
/* A chain that moves freely: its state is set and read by the suite. Always in space, 13 numbers per segment. */

/* Builds the stage of t = 0 in space; the definition is used up. stage_free must follow if it returns OK. */
hawser_status motion_start(SceneDef *def, Stage *stage, hawser_error *err);
/* Integrates to t (s). */
hawser_status motion_advance(Stage *stage, double t, hawser_error *err);
/* Three entries of the state of segment i: at is STATE_P, STATE_V or STATE_W. */
Vec3 motion_get(const Stage *stage, int at, int i);
void motion_set(Stage *stage, int at, int i, Vec3 value);
Quat motion_attitude(const Stage *stage, int i);
void motion_turn(Stage *stage, int i, Quat attitude);
/* Quantities that undamped motion conserves, or that only gravity changes. */
typedef struct Balance {
    double mass;    /* kg */
    Vec3 centre;    /* m, of mass */
    Vec3 momentum;  /* kg m/s */
    Vec3 spin;      /* kg m2/s, about the centre of mass */
    double kinetic; /* J */
    double elastic; /* J, of all bushings */
    double height;  /* J, potential of gravity */
} Balance;

Balance motion_balance(Stage *stage);
/* Present wrenches of the bushings, law[0..5][joint] (core/bushing.h). */
double *const *motion_law(Stage *stage);

#endif
