#include <math.h>
#include <stdio.h>
#include <string.h>

#include "validate/validate.h"

static const double DEGREE = M_PI / 180;

static const double LENGTH = 58.5, CABLE = 152.5, ROPE = 32.5, SPEED = 0.1; /* m, m, m, m/s */

static double or_usual(double chosen, double usual) { return chosen > 0 ? chosen : usual; }

/* The paper's table 1 and eq. 2: a solid bar of elasticity E and G (Pa), diameter d (m), area A (m2); steel's
 * density. */
static CableDef bar(const char *name, double E, double G, double d, double A, double damping)
{
    const double J = M_PI * pow(d, 4) / 32;
    CableDef c = build_cable(7801 * A, d, E * A, E * J / 2);
    snprintf(c.name, sizeof c.name, "%s", name);
    c.ga = G * A;
    c.gj = G * J;
    c.damping = damping;
    return c;
}

static void chain_fill(const PaperChoice *choice, SceneDef *def)
{
    const double segment = or_usual(choice->segment, 0.5);
    def->n_cables = def->n_pieces = 2;
    def->cables[0] = bar("power", 115e9, 41.5e9, 0.0873, 5982.7e-6, 1e-3);
    def->cables[1] = bar("rope", 181.4e9, 69.8e9, 0.014, 86.69e-6, 20e-3);
    if (choice->ei > 0) def->cables[0].ei_y = def->cables[0].ei_z = choice->ei;
    def->pieces[0] = (ChainPieceDef){.cable = 0, .length = CABLE, .segments = (int)lround(CABLE / segment)};
    def->pieces[1] = (ChainPieceDef){.cable = 1, .length = ROPE, .segments = (int)lround(ROPE / segment), .swivel = 1};
}

/* Corners are arcs of 60 m; the case file gives the reason for these lengths. */
static void route_fill(SceneDef *def)
{
    def->route_slope = -5 * DEGREE;
    def->head_at = LENGTH;
    build_straight(def, 0.5226572);
    build_bend(def, 60, 15 * DEGREE, M_PI / 2);
    build_straight(def, 9.0551496);
    build_bend(def, 60, 10 * DEGREE, 1.5 * M_PI);
    build_straight(def, 11.8602584);
    build_bend(def, 60, 5 * DEGREE, 1.5 * M_PI);
    build_straight(def, 5.6460084);
    def->lead_in = (LeadInDef){.present = 1, .carries_weight = 1, .blend = 0.5};
}

static hawser_status rollers_fill(const PaperChoice *choice, SceneDef *def, hawser_error *err)
{
    const int n = choice->rollers > 0 ? choice->rollers : 32;
    const double pitch = LENGTH / (n - 1);
    Route route;
    const hawser_status status = build_route(def, &route, err);
    if (status) return status;
    for (int i = 0; i < n + (int)(choice->onward / pitch); ++i) {
        build_roller(def, &route, 0.1, def->cables[0].diameter, i * pitch);
        def->rollers[i].width = 0.4;
    }
    route_clear(&route);
    return HAWSER_OK;
}

static void drive_fill(const PaperChoice *choice, SceneDef *def)
{
    const double v_s = or_usual(choice->v_s, 1e-3);
    build_pull(def, SPEED, 13, 0);
    def->tail.tension = (Profile){.kind = PROFILE_STEP, .t1 = 13, .v1 = 6860.643};
    def->drag = (RopeDragDef){.force = 2286.881, .v_s = v_s, .v_d = 2 * v_s, .ratio = 1};
}

/* Every 2 m, and the paper's corners A to F. */
static void stations_fill(SceneDef *def)
{
    static const char *const name[] = {"A", "B", "C", "D", "E", "F"};
    const double place[] = {0, 4, 9.235988, 30.521758, 50.235998, LENGTH};
    for (int i = 0; i < 6; ++i) build_station(def, name[i], place[i]);
    for (int i = 1; 2 * i < LENGTH; ++i) {
        if (i != 2) build_station(def, "between", 2 * i);
    }
}

/* Eq. 3 to 9 with the lengths that the paper does not print. */
static void terms_fill(SceneDef *def)
{
    const PaperTermDef term[] = {
        {.kind = PAPER_REEL, .length = 15},
        {.kind = PAPER_SLOPE, .slope = -5 * DEGREE, .length = 4},
        {.kind = PAPER_ARC, .slope = -5 * DEGREE, .slope_end = 0, .radius = 60},
        {.kind = PAPER_SLOPE, .slope = 10 * DEGREE, .length = 21.28577},
        {.kind = PAPER_SLOPE, .slope = 0, .length = 19.71424},
        {.kind = PAPER_SLOPE, .slope = -5 * DEGREE, .length = 8.264},
        {.kind = PAPER_ROPE, .length = 5},
    };
    def->n_paper = sizeof term / sizeof *term;
    memcpy(def->paper, term, sizeof term);
}

hawser_status paper_scene(const PaperChoice *choice, SceneDef *def, hawser_error *err)
{
    const double v_s = or_usual(choice->v_s, 1e-3);
    hawser_status status = build_start(def, err);
    if (status) return status;
    def->gravity = v3(0, 0, -9.8);
    def->friction = (FrictionLaw){.mu_s = 0.1, .mu_d = 0.1, .v_s = v_s, .v_d = 2 * v_s};
    if (choice->stiffer > 0) def->impact.k *= choice->stiffer;
    if (choice->capsules) def->geometry = GEOMETRY_CYLINDER;
    def->solver.accuracy = or_usual(choice->accuracy, 1e-3);
    def->output.steady_from = 18;
    def->duration = 30;
    chain_fill(choice, def);
    route_fill(def);
    drive_fill(choice, def);
    stations_fill(def);
    terms_fill(def);
    status = rollers_fill(choice, def, err);
    if (status) scene_def_clear(def);
    return status;
}

/* The paper's case: tensions along the tunnel against the reference theory, as in the paper's table 2; and the causes
 * of the remaining error, each changed by itself. */

/* A real cable's bending stiffness, a twentieth of the solid paper_bar's (references: 9-16 kN m2 tangent); and almost
 * none. */
#define REAL_EI 16.4e3 /* N m2 */
#define LIMP_EI 1.64e3

static const double PAPER_TOTAL = 12903.21; /* N, the paper's eq. 10 */

/* Changes of the case, and limits of the errors. */
typedef struct Experiment {
    PaperChoice choice;
    double largest, mean; /* %, limits of the stations' errors */
    int as_printed;       /* 1: the paper's own total and its corners are compared too */
} Experiment;

/* The corners A to F and the paper's total. */
static void printed_log(ValidationLog *log, const Experiment *e, const Sim *sim, const hawser_summary *sum)
{
    const hawser_station *station;
    const int n = hawser_sim_stations(sim, &station);
    for (int i = 0; i < n; ++i) {
        char quantity[VALIDATION_QUANTITY_MAX];
        if (station[i].name[0] < 'A' || station[i].name[0] > 'F') continue;
        snprintf(quantity, sizeof quantity, "tension at %s", station[i].name);
        log_share(log, quantity, "N", station[i].reference_N, station[i].mean_N, e->largest);
    }
    log_share(log, "eq. 10 by hawser", "N", PAPER_TOTAL, sum->paper_total_N, 1e-4);
    log_share(log, "winch force, paper's eq. 10", "N", PAPER_TOTAL, sum->pull_mean_N, 5);
}

/* The errors over all stations, and the pull. */
static hawser_status paper_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    const Experiment *const e = setup;
    SceneDef def;
    Sim *sim;
    hawser_summary sum;
    hawser_status status = paper_scene(&e->choice, &def, err);
    if (!status) status = pull_run(&def, &sim, err);
    if (status) return status;
    hawser_sim_summary(sim, &sum);
    if (e->as_printed) printed_log(log, e, sim, &sum);
    log_limit(log, "largest tension error", "%", sum.error_max_pct, e->largest);
    log_limit(log, "mean tension error", "%", sum.error_mean_pct, e->mean);
    log_share(log, "winch force", "N", sum.reference_total_N, sum.pull_mean_N, e->mean);
    sim_free(sim);
    return HAWSER_OK;
}

static const Experiment onward = {.choice = {.ei = LIMP_EI, .rollers = 118, .onward = 32}, .largest = 0.5, .mean = 0.1},
                        limp_close = {.choice = {.ei = LIMP_EI, .rollers = 118}, .largest = 1, .mean = 0.5},
                        paper_bar = {.largest = 5, .mean = 2.75, .as_printed = 1},
                        real = {.choice = {.ei = REAL_EI}, .largest = 2, .mean = 1},
                        limp = {.choice = {.ei = LIMP_EI}, .largest = 2, .mean = 1},
                        finer = {.choice = {.segment = 0.25}, .largest = 5, .mean = 2.75},
                        finest = {.choice = {.segment = 0.125}, .largest = 5, .mean = 2.75},
                        tighter = {.choice = {.accuracy = 1e-5}, .largest = 5, .mean = 2.75},
                        sharper = {.choice = {.v_s = 1e-4}, .largest = 5, .mean = 2.75},
                        closer = {.choice = {.rollers = 118}, .largest = 5, .mean = 2.75},
                        harder = {.choice = {.stiffer = 10}, .largest = 5, .mean = 2.75},
                        capsules = {.choice = {.capsules = 1}, .largest = 6, .mean = 2.75},
                        all = {
                            .choice = {.ei = LIMP_EI, .segment = 0.25, .accuracy = 1e-5, .v_s = 1e-4, .rollers = 118},
                            .largest = 1,
                            .mean = 0.5};

static const char reference[] = "bend ODE (T5), (T6)";

static const ValidationCase paper_cases[] = {
    {"paper", "the paper's pull, station by station", "paper eq. 10, table 2; bend ODE (T5), (T6)", 1, &paper_bar,
     paper_run},
    {"paper-real-cable", "the same with a real cable's bending stiffness", reference, 1, &real, paper_run},
    {"paper-limp", "bending switched off: a 200th of the EI", reference, 0, &limp, paper_run},
    {"paper-limp-rollers", "the same on a roller every 0.5 m", reference, 0, &limp_close, paper_run},
    {"paper-onward", "and rollers all the way to the winch", reference, 0, &onward, paper_run},
    {"paper-segments-2", "discretisation: segments of 0.25 m", reference, 0, &finer, paper_run},
    {"paper-segments-4", "discretisation: segments of 0.125 m", reference, 0, &finest, paper_run},
    {"paper-accuracy", "time integration: accuracy 1e-5", reference, 0, &tighter, paper_run},
    {"paper-friction", "friction's regularisation: full at 0.1 mm/s", reference, 0, &sharper, paper_run},
    {"paper-rollers", "supports: a roller every 0.5 m", reference, 0, &closer, paper_run},
    {"paper-contacts", "contacts ten times as stiff", reference, 0, &harder, paper_run},
    {"paper-capsules", "the contact line of straight segments", reference, 0, &capsules, paper_run},
    {"paper-all", "limp, fine, tight, sharp and on many rollers at once", reference, 0, &all, paper_run},
};

const ValidationGroup paper_group = VALIDATION_GROUP(paper_cases);
