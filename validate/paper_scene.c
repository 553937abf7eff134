#include "validate/build.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double DEGREE = M_PI / 180;
static const double LENGTH = 58.5, CABLE = 152.5, ROPE = 32.5, SPEED = 0.1; /* m, m, m, m/s */

static double or_usual(double chosen, double usual) { return chosen > 0 ? chosen : usual; }

/* The paper's table 1 and eq. 2: a solid bar of elasticity E and G (Pa), diameter d (m), area A (m2); steel's density.
 */
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

/* Corners are arcs of 60 m; why these lengths is said in the case file. */
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
