#include "validate/validate.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/bushing.h"
#include "core/error.h"

static const ValidationGroup *const groups[] = {
    &paper_group, &row_group,      &duct_group, &roller_group, &wave_group,      &motion_group,    &flight_group,
    &slip_group,  &buckling_group, &rod_group,  &frame_group,  &stability_group, &frequency_group, &convergence_group};

enum { GROUPS = sizeof groups / sizeof *groups };

/* Makes room for one more row. A lack of memory is remembered. A quantity with a NAN is not ok. */
static void row_add(ValidationLog *log, const char *quantity, ValidationRow row)
{
    if (log->n == log->room) {
        const int room = 2 * log->room + 64;
        ValidationRow *const grown = realloc(log->row, (size_t)room * sizeof *grown);
        log->no_memory = log->no_memory || !grown;
        if (!grown) return;
        log->row = grown;
        log->room = room;
    }
    row.of = log->now;
    row.ok = fabs(row.error) <= row.tolerance;
    snprintf(row.quantity, sizeof row.quantity, "%s", quantity);
    log->row[log->n++] = row;
}

void log_share(ValidationLog *log, const char *quantity, const char *unit, double expected, double found,
               double percent)
{
    const double error = 100 * (found / expected - 1);
    row_add(log, quantity, (ValidationRow){NULL, "", unit, WITHIN_SHARE, expected, found, percent, error, 0});
}

void log_near(ValidationLog *log, const char *quantity, const char *unit, double expected, double found,
              double tolerance)
{
    row_add(log, quantity, (ValidationRow){NULL, "", unit, WITHIN, expected, found, tolerance, found - expected, 0});
}

void log_limit(ValidationLog *log, const char *quantity, const char *unit, double found, double limit)
{
    row_add(log, quantity, (ValidationRow){NULL, "", unit, AT_MOST, 0, found, limit, found, 0});
}

/* (VA2) */
static double order_of(int n, const double *x, const double *y)
{
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (int i = 0; i < n; ++i) {
        const double a = log(x[i]), b = log(fabs(y[i]));
        sx += a;
        sy += b;
        sxx += a * a;
        sxy += a * b;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

void order_log(ValidationLog *log, int n, const double *x, const double *error, const char *of, double expected,
               double tolerance)
{
    char quantity[VALIDATION_QUANTITY_MAX];
    for (int i = 0; i < n; ++i) {
        snprintf(quantity, sizeof quantity, "error at %s %.3g", of, x[i]);
        log_limit(log, quantity, "%", 100 * fabs(error[i]), INFINITY);
    }
    snprintf(quantity, sizeof quantity, "order in %s", of);
    log_near(log, quantity, "1", expected, order_of(n, x, error), tolerance);
}

/* A case that cannot be run is a quantity of its own, and the suite continues; but not without memory, since that says
 * nothing about a quantity. */
static void case_run(const ValidationCase *c, ValidationLog *log)
{
    hawser_error err = {HAWSER_OK, ""};
    log->now = c;
    const hawser_status status = c->run(c->setup, log, &err);
    log->no_memory |= status == HAWSER_ERR_MEMORY;
    if (!status || log->no_memory) return;
    snprintf(log->failure, sizeof log->failure, "%s: %s", c->name, err.message);
    log_limit(log, "could not be run", "", NAN, 0);
}

const ValidationCase *validation_case(int i)
{
    for (int g = 0; g < GROUPS; i -= groups[g++]->n) {
        if (i < groups[g]->n) return &groups[g]->cases[i];
    }
    return NULL;
}

hawser_status validation_run(const char *filter, int fast, ValidationLog *log, int *ran, hawser_error *err)
{
    memset(log, 0, sizeof *log);
    *ran = 0;
    const ValidationCase *c;
    for (int i = 0; (c = validation_case(i)) && !log->no_memory; ++i) {
        if ((filter && !strstr(c->name, filter)) || (fast && !c->fast)) continue;
        case_run(c, log);
        ++*ran;
    }
    if (!log->no_memory) return HAWSER_OK;
    validation_clear(log);
    return error_memory(err);
}

void validation_clear(ValidationLog *log)
{
    free(log->row);
    memset(log, 0, sizeof *log);
}

int validation_outside(const ValidationLog *log)
{
    int outside = 0;
    for (int i = 0; i < log->n; ++i) outside += !log->row[i].ok;
    return outside;
}

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

/* Values that are not given follow from those that are: the suite's scenes do not depend on them. */
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

/* The first record is that of t = 0, from which the loads at rest are taken. */
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

/* The planar equations have another state: they are switched off. */
hawser_status motion_start(SceneDef *def, Stage *stage, hawser_error *err)
{
    memset(stage, 0, sizeof *stage);
    def->solver.planar = PLANAR_OFF;
    const hawser_status status = stage_new(stage, def, NULL, err);
    scene_def_clear(def);
    if (status) stage_free(stage);
    return status;
}

hawser_status motion_advance(Stage *stage, double t, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    while (!status && stage->t < t) status = stage_step(stage, t, err);
    return status;
}

Vec3 motion_get(const Stage *stage, int at, int i)
{
    const int n = stage->scene.chain.n;
    const double *const y = stage->y + at * n + i;
    return v3(y[0], y[n], y[2 * n]);
}

void motion_set(Stage *stage, int at, int i, Vec3 value)
{
    const int n = stage->scene.chain.n;
    double *const y = stage->y + at * n + i;
    y[0] = value.x;
    y[n] = value.y;
    y[2 * n] = value.z;
}

Quat motion_attitude(const Stage *stage, int i)
{
    const int n = stage->scene.chain.n;
    const double *const q = stage->y + STATE_Q * n + i;
    return (Quat){q[0], q[n], q[2 * n], q[3 * n]};
}

void motion_turn(Stage *stage, int i, Quat attitude)
{
    const int n = stage->scene.chain.n;
    double *const q = stage->y + STATE_Q * n + i;
    q[0] = attitude.w;
    q[n] = attitude.x;
    q[2 * n] = attitude.y;
    q[3 * n] = attitude.z;
}

/* Also for joints n and 0: the ground's ends are set with the kinematics. */
double *const *motion_law(Stage *stage)
{
    dynamics_kinematics(&stage->scene, &stage->ws, stage->t, stage->y);
    bushing_kernels()->law(&stage->scene.chain, &stage->ws.kin, 0, stage->scene.chain.n + 1, stage->ws.law);
    return stage->ws.law;
}

/* Each spring stores law^2 / 2k; a joint without stiffness stores nothing. */
static double elastic_energy(Stage *stage)
{
    const Chain *const c = &stage->scene.chain;
    double *const *const law = motion_law(stage);
    double energy = 0;
    for (int j = 0; j <= c->n; ++j) {
        for (int k = 0; k < 6; ++k) {
            if (c->stiffness[k][j] > 0) energy += law[k][j] * law[k][j] / (2 * c->stiffness[k][j]);
        }
    }
    return energy;
}

/* Two passes: the angular momentum is about the centre of mass, which the first one finds. */
Balance motion_balance(Stage *stage)
{
    const Chain *const c = &stage->scene.chain;
    Balance b = {.elastic = elastic_energy(stage)};
    for (int i = 0; i < c->n; ++i) {
        b.mass += c->mass[i];
        b.centre = v3_axpy(b.centre, c->mass[i], motion_get(stage, STATE_P, i));
        b.momentum = v3_axpy(b.momentum, c->mass[i], motion_get(stage, STATE_V, i));
    }
    b.height = -v3_dot(stage->scene.weight.gravity, b.centre);
    b.centre = v3_scale(1 / b.mass, b.centre);
    for (int i = 0; i < c->n; ++i) {
        const Vec3 v = motion_get(stage, STATE_V, i), w = motion_get(stage, STATE_W, i);
        const Vec3 own = body_inertia_times(c, &stage->ws.kin, i, w), push = v3_scale(c->mass[i], v);
        const Vec3 arm = v3_sub(motion_get(stage, STATE_P, i), b.centre);
        b.kinetic += (v3_dot(v, push) + v3_dot(w, own)) / 2;
        b.spin = v3_add(b.spin, v3_add(own, v3_cross(arm, push)));
    }
    return b;
}
