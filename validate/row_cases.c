/* Straight rows of rollers, level and on slopes: what it takes to pull a cable over them is known exactly, and so is
 * what the rollers bear. The cable's ends are free across. */
#include <math.h>

#include "sim/watch/stats.h"
#include "theory/closed_form.h"
#include "validate/build.h"
#include "validate/validate.h"

static const double MASS = 20, DIAMETER = 0.08, G = 9.81;  /* kg/m, m, m/s2: a cable of 800 mm2 */
static const double PITCH = 1, SEGMENT = 0.5, LENGTH = 30; /* m */

typedef struct Row {
    double slope, mu; /* rad, 1 */
    double tail;      /* N, back tension: what keeps a cable stretched that slides down by itself */
} Row;

static const Row level = {.mu = 0.2}, uphill = {.slope = 0.2, .mu = 0.15},
                 downhill = {.slope = -0.2, .mu = 0.15, .tail = 2000};

/* Rollers from before the tail to 6 m past the head; 2 m of travel at 0.1 m/s after a start of 2 s. */
static hawser_status row_build(const Row *row, SceneDef *def, hawser_error *err)
{
    Route route;
    const CableDef cable = build_cable(MASS, DIAMETER, 5e7, 12e3);
    hawser_status status = build_line(def, cable, LENGTH, (int)(LENGTH / SEGMENT), err);
    if (status) return status;
    def->route_slope = row->slope;
    def->friction = (FrictionLaw){.mu_s = row->mu, .mu_d = row->mu, .v_s = 1e-3, .v_d = 2e-3};
    build_pull(def, 0.1, 1, 1);
    def->tail.tension = (Profile){.kind = PROFILE_CONSTANT, .v1 = row->tail};
    def->solver.accuracy = 3e-4; /* the ripple of the smooth line is finer than what 1e-3 resolves */
    def->output.steady_from = 2;
    def->duration = 22;
    status = build_route(def, &route, err);
    if (status) {
        scene_def_clear(def);
        return status;
    }
    const int rollers = (int)ceil((LENGTH + 6) / PITCH + 0.5);
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
    log_share(log, "pull", "N", slope_tension(row->tail, MASS * G, row->mu, LENGTH, row->slope), sum.pull_mean_N, 0.5);
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
    log_share(log, "hold", "N", MASS * G * LENGTH * sin(row.slope), hawser_sim_sample(sim)->winch_force, 0.01);
    sim_free(sim);
    return HAWSER_OK;
}

/* Every roller under the middle of a long cable bears the weight of one pitch, at rest and, in the mean, while the
 * cable's segments pass over it; then its friction, square to that, counts too: w p sqrt(1 + mu^2). */
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
    log_share(log, "load at rest", "N", MASS * G * PITCH, roller[middle].initial_N, 0.5);
    log_share(log, "load while the cable moves", "N", MASS * G * PITCH * hypot(1, row->mu), roller[middle].steady_N,
              0.5);
    sim_free(sim);
    return HAWSER_OK;
}

static const ValidationCase cases[] = {
    {"straight", "friction alone: mu w L", "CIGRE TB 194; closed form (T9)", 1, &level, row_run},
    {"slope-up", "weight and friction add up", "closed form (T9)", 1, &uphill, row_run},
    {"slope-down", "weight pulls, friction holds", "closed form (T9)", 1, &downhill, row_run},
    {"slope-at-rest", "weight along a slope without friction", "statics", 1, NULL, rest_run},
    {"moving-roller-load", "a roller bears the weight of a pitch while the cable moves over it", "statics", 1, &level,
     load_run},
};
const ValidationGroup row_group = VALIDATION_GROUP(cases);
