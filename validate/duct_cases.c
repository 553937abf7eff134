/* Bends in ducts: the capstan law, level and vertical bends against their closed forms, an S in three dimensions
 * against the reference theory. The theory has neither bending stiffness nor clearance in the duct: both are small
 * here. */
#include <math.h>

#include "theory/closed_form.h"
#include "validate/validate.h"

/* kg/m, m/s2; friction of a lubricated duct; N at the tail. Clearance around the cable and segment length, m: the
 * remainder of the lost angle (DU14) is below 0.1 % of the tension. */
static const double MASS = 10, G = 9.81, MU = 0.25, TAIL = 2000, ROOM = 0.0002, SEGMENT = 0.125;
/* m, of the cable: the theory's is a line; friction on the surface of a thick one has a shorter lever (VA1) */
static const double THIN = 0.01, THICK = 0.05;

typedef struct Bend {
    double radius, angle, plane; /* m, rad, rad */
    double slope;                /* rad, of the straight before it */
    int weightless;
    int thick;
    int vertical; /* a VerticalBend; -1: none */
} Bend;

static const Bend capstan_90 = {.radius = 3, .angle = M_PI / 2, .weightless = 1, .vertical = -1},
                  capstan_180 = {.radius = 3, .angle = M_PI, .weightless = 1, .vertical = -1},
                  thick = {.radius = 3, .angle = M_PI, .weightless = 1, .thick = 1, .vertical = -1},
                  level = {.radius = 5, .angle = 1.2, .vertical = -1},
                  sag_up = {.radius = 5, .angle = 0.6, .plane = M_PI / 2, .vertical = SAG_LEVEL_UP},
                  crest_up = {.radius = 5, .angle = 0.5, .plane = 1.5 * M_PI, .slope = 0.5, .vertical = CREST_UP_LEVEL},
                  crest_down = {.radius = 5, .angle = 0.5, .plane = 1.5 * M_PI, .vertical = CREST_LEVEL_DOWN},
                  sag_down = {.radius = 5, .angle = 0.6, .plane = M_PI / 2, .slope = -0.6, .vertical = SAG_DOWN_LEVEL};

/* Starts a scene without the route's pieces, which the caller adds; 1 m of route is ahead of the cable of `length`. */
static hawser_status duct_start(SceneDef *def, double length, double radius, hawser_error *err)
{
    const hawser_status status = build_start(def, err);
    if (status) return status;
    CableDef cable = build_cable(MASS, 2 * radius, 5e7, 5);
    cable.gj = 500;
    build_chain(def, cable, length, (int)ceil(length / SEGMENT - 1e-9));
    def->head_at = length + 1;
    def->friction = (FrictionLaw){.mu_s = MU, .mu_d = MU, .v_s = 1e-3, .v_d = 2e-3};
    def->n_surfaces = 1;
    def->surfaces[0] = (SurfaceDef){.name = "duct", .friction = def->friction};
    def->surfaces[0].shape = (SurfaceShape){.kind = SURFACE_DUCT,
                                            .to = length + 2,
                                            .fade = 0.5,
                                            .cable_radius = radius,
                                            .radius = radius + ROOM,
                                            .lift = ROOM};
    def->line_impact.k *= 10; /* the cable sinks in by 0.1 mm under 1 kN/m */
    build_pull(def, 0.1, 0.5, 0);
    def->tail.tension = (Profile){.kind = PROFILE_CONSTANT, .v1 = TAIL};
    def->output.steady_from = 2;
    def->duration = 6;
    return HAWSER_OK;
}

/* Tension at the bend's end, from the tension T1 at its beginning; NAN where the closed form is not valid. */
static double bend_expected(const Bend *b, double T1)
{
    const double w = b->weightless ? 0 : MASS * G;
    double T2 = NAN;
    if (b->thick) {
        T2 = capstan_tension(T1, MU * (1 - THICK / b->radius), b->angle);
    } else if (b->vertical >= 0) {
        bend_vertical_tension((VerticalBend)b->vertical, T1, w, MU, b->radius, b->angle, &T2, NULL);
    } else {
        bend_level_tension(T1, w, MU, b->radius, b->angle, &T2, NULL);
    }
    return T2;
}

/* Straight, bend, straight. From the simulated tension 1 m before the bend the closed forms of straight and bend give
 * that 1.5 m behind it; 2 m of straight before the bend are compared too. */
static hawser_status bend_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    static const double BEFORE = 6, AFTER = 4;
    const Bend *const b = setup;
    const double out = BEFORE + b->radius * b->angle, w = b->weightless ? 0 : MASS * G;
    const double turn = b->plane > M_PI ? -b->angle : b->plane > 0 ? b->angle : 0;
    SceneDef def;
    Sim *sim;
    const hawser_station *at;
    hawser_status status = duct_start(&def, out + 2, b->thick ? THICK : THIN, err);
    if (status) return status;
    def.route_slope = b->slope;
    if (b->weightless) def.gravity = v3(0, 0, 0);
    build_straight(&def, BEFORE);
    build_bend(&def, b->radius, b->angle, b->plane);
    build_straight(&def, AFTER);
    build_station(&def, "before", BEFORE - 1);
    build_station(&def, "behind", out + 1.5);
    status = pull_run(&def, &sim, err);
    if (status) return status;
    hawser_sim_stations(sim, &at);
    const double enters = slope_tension(at[0].mean_N, w, MU, 1, b->slope);
    const double leaves = slope_tension(bend_expected(b, enters), w, MU, 1.5, b->slope + turn);
    log_share(log, "tension before the bend", "N", at[0].reference_N, at[0].mean_N, 0.5);
    log_share(log, "tension behind the bend", "N", leaves, at[1].mean_N, 0.5);
    sim_free(sim);
    return HAWSER_OK;
}

/* Up to the left, then down to the right: six stations. */
static hawser_status s_bend_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    static const double place[] = {3, 6, 8, 10.5, 13.4, 14.5};
    static const char *const name[] = {"tension at 3 m",    "tension at 6 m",    "tension at 8 m",
                                       "tension at 10.5 m", "tension at 13.4 m", "tension at 14.5 m"};
    (void)setup;
    SceneDef def;
    Sim *sim;
    const hawser_station *at;
    hawser_status status = duct_start(&def, 15, THIN, err);
    if (status) return status;
    build_straight(&def, 4);
    build_bend(&def, 5, 0.8, 0.6);
    build_bend(&def, 6, 0.9, M_PI + 0.4);
    build_straight(&def, 5);
    for (int i = 0; i < 6; ++i) build_station(&def, name[i], place[i]);
    status = pull_run(&def, &sim, err);
    if (status) return status;
    hawser_sim_stations(sim, &at);
    for (int i = 0; i < 6; ++i) log_share(log, name[i], "N", at[i].reference_N, at[i].mean_N, 0.5);
    sim_free(sim);
    return HAWSER_OK;
}

/* Pull through a level bend with 14 m of cable in n segments, in a duct with clearance for the deviation of long
 * ones. */
static hawser_status segments_pull(int n, double *pull, hawser_error *err)
{
    static const double WIDE = 0.005;
    SceneDef def;
    Sim *sim;
    hawser_summary sum;
    hawser_status status = duct_start(&def, 14, THIN, err);
    if (status) return status;
    build_straight(&def, 6);
    build_bend(&def, 5, 1.2, 0);
    build_straight(&def, 4);
    def.pieces[0].segments = n;
    def.surfaces[0].shape.radius = THIN + WIDE;
    def.surfaces[0].shape.lift = WIDE;
    def.cables[0].ei_y = def.cables[0].ei_z = 100;
    status = pull_run(&def, &sim, err);
    if (status) return status;
    hawser_sim_summary(sim, &sum);
    *pull = sum.pull_mean_N;
    sim_free(sim);
    return HAWSER_OK;
}

/* The ends of the contact are not smooth: no order is required, only that longer segments give the same pull. */
static hawser_status segments_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    static const char *const name[] = {"pull, segments of 0.125 m", "pull, segments of 0.25 m",
                                       "pull, segments of 0.5 m"};
    double fine = NAN;
    hawser_status status = segments_pull(28 << 3, &fine, err);
    for (int k = 2; k >= 0 && !status; --k) {
        double pull = NAN;
        status = segments_pull(28 << k, &pull, err);
        if (!status) log_share(log, name[2 - k], "N", fine, pull, 0.3);
    }
    return status;
}

static const char capstan_source[] = "Euler and Eytelwein: exp(mu turn) (T10)";
static const ValidationCase cases[] = {
    {"capstan-90", "friction in a bend of 90 deg without weight", capstan_source, 1, &capstan_90, bend_run},
    {"capstan-180", "friction in a bend of 180 deg without weight", capstan_source, 1, &capstan_180, bend_run},
    {"capstan-thick", "friction on the skin of a thick cable has a shorter lever", "exp(mu turn (1 - r/R)) (VA1)", 1,
     &thick, bend_run},
    {"bend-level", "weight and turning force square to each other", "CIGRE TB 889 eq. 9 (T11)", 1, &level, bend_run},
    {"bend-sag-up", "level, then up", "CIGRE TB 889 eq. 10-13 (T12)", 1, &sag_up, bend_run},
    {"bend-crest-level", "up, then level", "CIGRE TB 889 eq. 10-13 (T13)", 1, &crest_up, bend_run},
    {"bend-crest-down", "level, then down", "CIGRE TB 889 eq. 10-13 (T14)", 1, &crest_down, bend_run},
    {"bend-sag-level", "down, then level", "CIGRE TB 889 eq. 10-13 (T15)", 1, &sag_down, bend_run},
    {"duct-segments", "the pull hardly depends on the segments", "segments of 0.0625 m", 1, NULL, segments_run},
    {"duct-s-bend", "a double bend in space, station by station", "bend ODE (T5), (T6)", 1, NULL, s_bend_run},
};
const ValidationGroup duct_group = VALIDATION_GROUP(cases);
