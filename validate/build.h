/* Definitions of scenes for the suite, and pulls that are run from them. */
#ifndef HAWSER_VALIDATE_BUILD_H
#define HAWSER_VALIDATE_BUILD_H

#include "sim/run/sim.h"

/* How many of each there may be; the arrays are made for as many. */
typedef struct SceneRoom {
    int route, rollers, surfaces, stations, paper;
} SceneRoom;

/* Defaults, two empty kinds of cable and pieces of chain, and empty arrays with room for the rest. Errors: MEMORY (then
 * nothing is left allocated). */
hawser_status build_start(SceneDef *def, SceneRoom room, hawser_error *err);

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
/* A winch that takes t1 s to come to `speed` (m/s). */
WinchDef build_winch(double speed, double t1);

/* Builds the simulation and brings it to rest. The definition is taken apart in any case; *out is NULL after an error:
 * as sim_new, and RUN if there is no equilibrium. */
hawser_status pull_start(SceneDef *def, Sim **out, hawser_error *err);
/* Starts, and runs to the definition's end with statistics every 50 ms. */
hawser_status pull_run(SceneDef *def, Sim **out, hawser_error *err);

#endif
