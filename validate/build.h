/* Definitions of scenes for the suite, and pulls that are run from them. */
#ifndef HAWSER_VALIDATE_BUILD_H
#define HAWSER_VALIDATE_BUILD_H

#include "sim/run/sim.h"

/* How many there may be of pieces of route, rollers, surfaces, stations, terms of the paper. */
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
/* A roller 0.6 m wide that carries a cable of this diameter on the route at s; m. */
void build_roller(SceneDef *def, const Route *route, double radius, double diameter, double s);
/* The route of the definition so far; route_clear frees it. Errors: MEMORY. */
hawser_status build_route(const SceneDef *def, Route *route, hawser_error *err);
/* Starts the definition of one cable in n segments on a level straight of its length. Errors: as build_start. */
hawser_status build_line(SceneDef *def, CableDef cable, double length, int n, hawser_error *err);
/* Pulls at the head, which comes to `speed` (m/s) in t1 s: clamped, or (axial) held along the pull only. */
void build_pull(SceneDef *def, double speed, double t1, int axial);

/* Builds the simulation and brings it to rest. The definition is taken apart in any case; *out is NULL after an error:
 * as sim_new, and RUN if there is no equilibrium. */
hawser_status pull_start(SceneDef *def, Sim **out, hawser_error *err);
/* Starts, and runs to the definition's end with statistics every 50 ms. */
hawser_status pull_run(SceneDef *def, Sim **out, hawser_error *err);

/* ---- Rods: chains without a route, weightless and straight along x unless said otherwise (validate/rod_build.c). */

/* A rod of n segments and `length` (m) of this cable, with room for 3 loads and 1 motion of the head; its ends are
 * free. Undamped, no gravity; statics in `steps` load steps from t = 0 to 1 s. Errors: MEMORY (nothing is left
 * allocated). */
hawser_status rod_start(SceneDef *def, CableDef cable, double length, int n, int steps, hawser_error *err);

/* Every component of an end. */
void rod_clamp(RodEndDef *end);
/* The place alone: free to turn all the way round. */
void rod_pin(RodEndDef *end);

/* A value in a direction: all the time, or growing from nothing at t = 0 in proportion to time to this size at 1 s. The
 * latter owns a table. Errors: MEMORY. */
RodProfile rod_steady(Vec3 direction, double size);
hawser_status rod_growing(Vec3 direction, double size, RodProfile *out, hawser_error *err);
/* Adds a dead force (N) or moment (N m) at `at` m from the tail. */
void rod_add_load(SceneDef *def, double at, int moment, RodProfile by);

/* ---- The paper's case: cases/huangjiahu.yaml in code, which a test holds to the file (validate/paper_scene.c). */

/* What of the case may be changed; zeros: as it is. */
typedef struct PaperChoice {
    double ei;       /* N m2, of the cable */
    double segment;  /* m */
    double accuracy; /* of the integration */
    double v_s;      /* m/s, sliding speed at which friction is full, of rollers and rope drag */
    int rollers;     /* under the 58.5 m */
    double onward;   /* m past the tunnel's end over which the rollers go on, as close */
    double stiffer;  /* times the contacts' stiffness */
    int capsules;    /* the contact line of straight segments in place of the smooth one */
} PaperChoice;

/* Errors: MEMORY. */
hawser_status paper_scene(const PaperChoice *choice, SceneDef *def, hawser_error *err);

#endif
