/* A cable over single rollers: how friction changes with the angle, and the sag between rollers. */
#include <math.h>

#include "sim/run/stats.h"
#include "theory/closed_form.h"
#include "validate/validate.h"

/* One roller deflects a weightless limp cable downward by 20 deg; the cable is free in the air on both sides. */
static hawser_status turn_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    static const double SIDE = 3, TURN = M_PI / 9, MU = 0.2, TAIL = 2000, RADIUS = 0.1, HALF = 0.03;
    SceneDef def;
    Sim *sim;
    Route route;
    hawser_summary sum;
    double expected = NAN;
    hawser_status status = build_start(&def, err);
    if (status) return status;
    const double bend = (RADIUS + HALF) * TURN;
    build_chain(&def, build_cable(10, 2 * HALF, 5e7, 20), 2 * SIDE + bend - 1, 100);
    build_straight(&def, SIDE);
    build_bend(&def, RADIUS + HALF, TURN, 1.5 * M_PI);
    build_straight(&def, SIDE);
    def.head_at = 2 * SIDE + bend - 0.5;
    def.gravity = v3(0, 0, 0);
    def.friction = (FrictionLaw){.mu_s = MU, .mu_d = MU, .v_s = 1e-3, .v_d = 2e-3};
    build_pull(&def, 0.1, 1, 0);
    def.tail.tension = (Profile){.kind = PROFILE_CONSTANT, .v1 = TAIL};
    def.output.steady_from = 2;
    def.duration = 5;
    status = build_route(&def, &route, err);
    if (!status) {
        build_roller(&def, &route, RADIUS, 2 * HALF, SIDE + bend / 2);
        route_clear(&route);
        status = pull_run(&def, &sim, err);
    } else {
        scene_def_clear(&def);
    }
    if (!status) status = roller_tension(TAIL, MU, TURN, &expected, err);
    if (status) return status;
    hawser_sim_summary(sim, &sum);
    log_share(log, "pull", "N", expected, sum.pull_mean_N, 0.5);
    sim_free(sim);
    return HAWSER_OK;
}

/* A row of spans. */
typedef struct Spans {
    int n;              /* spans */
    double mass;        /* kg/m */
    double overhang;    /* m, of cable past the first and the last roller */
    double coefficient; /* sag over w l^4 / EI */
} Spans;

/* The overhang l/sqrt 6 has the moment of a continuous row, w l^2/12, so that all its spans are alike. */
static const Spans continuous = {.n = 9, .mass = 20, .overhang = 1.625, .coefficient = 1.0 / 384},
                   single = {.n = 1, .mass = 5, .overhang = 0.025, .coefficient = 5.0 / 384};

/* At rest without friction. Rollers are under middles of segments, and so is the middle of the span. */
static hawser_status sag_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    static const double SPAN = 4, SEGMENT = 0.05, EI = 12e3, G = 9.81;
    const Spans *const s = setup;
    const double length = s->n * SPAN + 2 * s->overhang;
    SceneDef def;
    Sim *sim;
    Route route;
    CableDef cable = build_cable(s->mass, 0.08, 5e7, EI);
    cable.ga = 1e10; /* shear would add w l^2 / 8 GA */
    hawser_status status = build_line(&def, cable, length, (int)lround(length / SEGMENT), err);
    if (status) return status;
    build_pull(&def, 0, 1, 1);
    status = build_route(&def, &route, err);
    for (int k = 0; k <= s->n && !status; ++k) build_roller(&def, &route, 0.02, 0.08, s->overhang + k * SPAN);
    if (!status) route_clear(&route);
    if (!status) status = pull_start(&def, &sim, err);
    if (status) return status;
    const double *const p = hawser_sim_sample(sim)->position;
    const int half = s->n / 2, roller = (int)floor((s->overhang + SPAN * half) / SEGMENT),
              span = (int)lround(SPAN / SEGMENT);
    const double sag = (p[3 * roller + 2] + p[3 * (roller + span) + 2]) / 2 - p[3 * (roller + span / 2) + 2];
    log_share(log, "sag", "m", s->coefficient * s->mass * G * pow(SPAN, 4) / EI, sag, 0.5);
    sim_free(sim);
    return HAWSER_OK;
}

static const ValidationCase roller_cases[] = {
    {"roller-turn", "one roller with a turn of 20 deg", "force triangle (T17)", 1, NULL, turn_run},
    {"sag-continuous", "sag in a long row of rollers", "beam theory: w l^4/384 EI", 1, &continuous, sag_run},
    {"sag-single", "sag between two rollers", "beam theory: 5 w l^4/384 EI", 1, &single, sag_run},
};

const ValidationGroup roller_group = VALIDATION_GROUP(roller_cases);

/* Straight rows of rollers, level and on slopes: the pull of a cable over them is known exactly, and so are the loads
 * of the rollers. The cable's ends are free across. */

static const double ROW_MASS = 20, DIAMETER = 0.08, ROW_G = 9.81; /* kg/m, m, m/s2: a cable of 800 mm2 */

static const double PITCH = 1, ROW_SEGMENT = 0.5, ROW_LENGTH = 30; /* m */

typedef struct Row {
    double slope, mu; /* rad, 1 */
    double tail;      /* N, back tension: keeps a cable stretched that slides down by itself */
} Row;

static const Row row_level = {.mu = 0.2}, uphill = {.slope = 0.2, .mu = 0.15},
                 downhill = {.slope = -0.2, .mu = 0.15, .tail = 2000};

/* Rollers from before the tail to 6 m past the head; 2 m of travel at 0.1 m/s after a start of 2 s. */
static hawser_status row_build(const Row *row, SceneDef *def, hawser_error *err)
{
    Route route;
    const CableDef cable = build_cable(ROW_MASS, DIAMETER, 5e7, 12e3);
    hawser_status status = build_line(def, cable, ROW_LENGTH, (int)(ROW_LENGTH / ROW_SEGMENT), err);
    if (status) return status;
    def->route_slope = row->slope;
    def->friction = (FrictionLaw){.mu_s = row->mu, .mu_d = row->mu, .v_s = 1e-3, .v_d = 2e-3};
    build_pull(def, 0.1, 1, 1);
    def->tail.tension = (Profile){.kind = PROFILE_CONSTANT, .v1 = row->tail};
    def->solver.accuracy = 3e-4; /* the ripple of the smooth line is finer than an accuracy of 1e-3 resolves */
    def->output.steady_from = 2;
    def->duration = 22;
    status = build_route(def, &route, err);
    if (status) {
        scene_def_clear(def);
        return status;
    }
    const int rollers = (int)ceil((ROW_LENGTH + 6) / PITCH + 0.5);
    for (int i = 0; i < rollers; ++i) build_roller(def, &route, 0.1, DIAMETER, (i - 0.5) * PITCH);
    route_clear(&route);
    return HAWSER_OK;
}

/* T = w L (mu cos + sin), at rest and while it moves. */
static hawser_status row_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    const Row *const row = setup;
    SceneDef def;
    Sim *sim;
    hawser_summary sum;
    hawser_status status = row_build(row, &def, err);
    if (!status) status = pull_run(&def, &sim, err);
    if (status) return status;
    hawser_sim_summary(sim, &sum);
    log_share(log, "pull", "N", slope_tension(row->tail, ROW_MASS * ROW_G, row->mu, ROW_LENGTH, row->slope),
              sum.pull_mean_N, 0.5);
    log_share(log, "speed", "m/s", 0.1, sum.steady_speed_m_per_s, 0.5);
    sim_free(sim);
    return HAWSER_OK;
}

/* On smooth rollers the head carries the weight's part along the slope. */
static hawser_status rest_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    const Row row = {.slope = 0.2};
    SceneDef def;
    Sim *sim;
    hawser_status status = row_build(&row, &def, err);
    if (!status) status = pull_start(&def, &sim, err);
    if (status) return status;
    log_share(log, "hold", "N", ROW_MASS * ROW_G * ROW_LENGTH * sin(row.slope), hawser_sim_sample(sim)->winch_force,
              0.01);
    sim_free(sim);
    return HAWSER_OK;
}

/* Every roller under the middle of a long cable bears the weight of one pitch, at rest and, in the mean, while the
 * cable's segments pass over it; in motion its friction, normal to that, counts too: w p sqrt(1 + mu^2). */
static hawser_status load_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    const Row *const row = setup;
    SceneDef def;
    Sim *sim;
    const hawser_roller *roller;
    hawser_status status = row_build(row, &def, err);
    if (!status) status = pull_run(&def, &sim, err);
    if (status) return status;
    const int middle = hawser_sim_rollers(sim, &roller) / 2;
    log_share(log, "load at rest", "N", ROW_MASS * ROW_G * PITCH, roller[middle].initial_N, 0.5);
    log_share(log, "load while the cable moves", "N", ROW_MASS * ROW_G * PITCH * hypot(1, row->mu),
              roller[middle].steady_N, 0.5);
    sim_free(sim);
    return HAWSER_OK;
}

static const ValidationCase row_cases[] = {
    {"straight", "friction alone: mu w L", "CIGRE TB 194; closed form (T9)", 1, &row_level, row_run},
    {"slope-up", "weight and friction add up", "closed form (T9)", 1, &uphill, row_run},
    {"slope-down", "weight pulls, friction holds", "closed form (T9)", 1, &downhill, row_run},
    {"slope-at-rest", "weight along a slope without friction", "statics", 1, NULL, rest_run},
    {"moving-roller-load", "a roller bears the weight of a pitch while the cable moves over it", "statics", 1,
     &row_level, load_run},
};

const ValidationGroup row_group = VALIDATION_GROUP(row_cases);
