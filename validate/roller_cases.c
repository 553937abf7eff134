/* A cable over single rollers: how friction turns with it, and how it hangs between them. */
#include <math.h>

#include "theory/closed_form.h"
#include "validate/build.h"
#include "validate/validate.h"

/* One roller turns a weightless limp cable down by 20 deg; the cable is free in the air on both sides. */
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

static const ValidationCase cases[] = {
    {"roller-turn", "one roller with a turn of 20 deg", "force triangle (T17)", 1, NULL, turn_run},
    {"sag-continuous", "sag in a long row of rollers", "beam theory: w l^4/384 EI", 1, &continuous, sag_run},
    {"sag-single", "sag between two rollers", "beam theory: 5 w l^4/384 EI", 1, &single, sag_run},
};
const ValidationGroup roller_group = VALIDATION_GROUP(cases);
