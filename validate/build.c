#include "validate/build.h"

#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"

hawser_status build_start(SceneDef *def, hawser_error *err)
{
    scene_def_defaults(def);
    def->cables = calloc(2, sizeof *def->cables);
    def->pieces = calloc(2, sizeof *def->pieces);
    def->route = calloc(ROUTE_MOST, sizeof *def->route);
    def->rollers = calloc(ROLLERS_MOST, sizeof *def->rollers);
    def->surfaces = calloc(SURFACES_MOST, sizeof *def->surfaces);
    def->stations = calloc(STATIONS_MOST, sizeof *def->stations);
    def->paper = calloc(PAPER_MOST, sizeof *def->paper);
    if (def->cables && def->pieces && def->route && def->rollers && def->surfaces && def->stations && def->paper) {
        return HAWSER_OK;
    }
    scene_def_clear(def);
    return error_memory(err);
}

/* What is not given follows from what is: the suite's scenes do not hang on it. */
CableDef build_cable(double mass, double diameter, double ea, double ei)
{
    return (CableDef){.name = "cable",
                      .ea = ea,
                      .ga = 0.4 * ea,
                      .gj = ei,
                      .ei_y = ei,
                      .ei_z = ei,
                      .mass = mass,
                      .diameter = diameter,
                      .damping = 2e-3,
                      .damping_factor = {1, 1, 1, 1, 1, 1}};
}

void build_chain(SceneDef *def, CableDef cable, double length, int n)
{
    def->n_cables = def->n_pieces = 1;
    def->cables[0] = cable;
    def->pieces[0] = (ChainPieceDef){.length = length, .segments = n};
}

void build_straight(SceneDef *def, double length)
{
    def->route[def->n_route++] = (RoutePieceDef){.kind = ROUTE_STRAIGHT, .name = "straight", .length = length};
}

void build_bend(SceneDef *def, double radius, double angle, double plane)
{
    def->route[def->n_route++] =
        (RoutePieceDef){.kind = ROUTE_BEND, .name = "bend", .radius = radius, .angle = angle, .plane = plane};
}

void build_station(SceneDef *def, const char *name, double s)
{
    StationDef *const station = &def->stations[def->n_stations++];
    station->s = s;
    strncpy(station->name, name, sizeof station->name - 1);
}

void build_roller(SceneDef *def, const Route *route, double radius, double diameter, double s)
{
    static const double WIDTH = 0.6;
    const RoutePoint at = route_at(route, s);
    const Vec3 left = route_left(route, s), up = v3_cross(at.tangent, left);
    def->rollers[def->n_rollers++] = (RollerDef){.name = "roller",
                                                 .centre = v3_axpy(at.position, -radius - diameter / 2, up),
                                                 .axis = left,
                                                 .radius = radius,
                                                 .width = WIDTH,
                                                 .s = s,
                                                 .friction = def->friction};
}

hawser_status build_route(const SceneDef *def, Route *route, hawser_error *err)
{
    return route_build(route, def->n_route, def->route, def->route_start, def->route_heading, def->route_slope, err);
}

hawser_status build_line(SceneDef *def, CableDef cable, double length, int n, hawser_error *err)
{
    const hawser_status status = build_start(def, err);
    if (status) return status;
    build_chain(def, cable, length, n);
    build_straight(def, length);
    def->head_at = length;
    return HAWSER_OK;
}

/* The winch stands where the route ends: NAN. */
void build_pull(SceneDef *def, double speed, double t1, int axial)
{
    def->winch = (WinchDef){
        .present = 1, .axial_only = axial, .speed = {.kind = PROFILE_STEP, .t1 = t1, .v1 = speed}, .at = NAN};
}

hawser_status pull_start(SceneDef *def, Sim **out, hawser_error *err)
{
    hawser_relaxation relaxation = {0};
    hawser_status status = sim_new(def, 1, out, err);
    scene_def_clear(def);
    if (!status) status = sim_relax(*out, &relaxation, err);
    if (!status && !relaxation.reached) {
        status = error_set(err, HAWSER_ERR_RUN, "not at rest: %g N are unbalanced", relaxation.residual_N);
    }
    if (status) *out = sim_free(*out);
    return status;
}

/* The first record is that of t = 0, which the loads at rest are taken from. */
hawser_status pull_run(SceneDef *def, Sim **out, hawser_error *err)
{
    static const double EVERY = 0.05; /* s */
    const double end = def->duration;
    hawser_status status = pull_start(def, out, err);
    if (status) return status;
    hawser_sim_record(*out);
    for (int k = 1; k * EVERY <= end + 1e-9 && !status; ++k) {
        status = sim_advance(*out, k * EVERY, 0, err);
        if (!status) hawser_sim_record(*out);
    }
    if (status) *out = sim_free(*out);
    return status;
}
