/* A small scene of every kind, for tests of what holds for all: each is taken over by who defines it. */
#ifndef HAWSER_TESTS_SUPPORT_KINDS_H
#define HAWSER_TESTS_SUPPORT_KINDS_H

#include <math.h>
#include <string.h>

#include "tests/support/scene.h"

static void stations_add(SceneDef *def)
{
    def->n_stations = 2;
    def->stations = fixture_array(2, sizeof *def->stations);
    def->stations[0] = (StationDef){"first", 2};
    def->stations[1] = (StationDef){"second", 6};
    def->output.n_speed_segments = 1;
    def->output.speed_segments = fixture_array(1, sizeof *def->output.speed_segments);
}

/* Friction that sticks, so that bristles are kept. */
static void define_sticky(SceneDef *def)
{
    fixture_pull(def, &(FixtureChoice){0});
    stations_add(def);
    for (int r = 0; r < def->n_rollers; ++r) def->rollers[r].friction.d_s = 1e-3;
    def->friction.d_s = 1e-3;
    def->output.n_probes = 1;
    def->output.probes = fixture_array(1, sizeof *def->output.probes);
    def->output.probes[0] = (ProbeDef){"probe", 3};
}

static void define_plane(SceneDef *def)
{
    fixture_planar(def, &(FixtureChoice){0});
    stations_add(def);
}

static void define_moving(SceneDef *def)
{
    fixture_pull(def, &(FixtureChoice){0});
    fixture_moving_rollers(def, 1, 1);
}

static void define_reel(SceneDef *def)
{
    reel_pull(def, &(ReelChoice){.payout = 1, .take_in = 1, .tension = 800, .cable = 9, .rope = 5, .head_at = 3});
    stations_add(def);
}

static void define_conveyor(SceneDef *def)
{
    fixture_pull(def, &(FixtureChoice){0});
    def->n_conveyors = 1;
    def->conveyors = fixture_array(1, sizeof *def->conveyors);
    def->conveyors[0] = (ConveyorDef){.name = "belts", .from = 0.5, .to = 2.5, .edge = 0.2, .sync = 1, .factor = 1};
    ConveyorDef *const c = def->conveyors;
    c->clamp = 2e3;
    c->mu = 0.4;
    c->v_s = 5e-3;
    c->v_d = 1e-2;
    c->ratio = 0.8;
    def->n_jams = 1;
    def->jams = fixture_array(1, sizeof *def->jams);
    def->jams[0] = (JamDef){"belts", 0.002, NAN, 1, NAN, 0.1, NAN};
}

/* A floor, air that streams, and the first speeds given. */
static void define_floor(SceneDef *def)
{
    fixture_pull(def, &(FixtureChoice){0});
    def->n_rollers = 0;
    def->n_surfaces = 1;
    def->surfaces = fixture_array(1, sizeof *def->surfaces);
    SurfaceDef *const floor = def->surfaces;
    *floor = (SurfaceDef){.name = "floor", .friction = def->friction};
    floor->shape =
        (SurfaceShape){.kind = SURFACE_PLANE, .point = {0, 0, -0.5}, .normal = {0, 0, 1}, .along = {1, 0, 0}};
    def->medium = (MediumDef){.density = 1.2, .velocity = {3, 1, 0}, .normal = 1, .tangential = 0.1};
    def->launch = (LaunchDef){.present = 1, .along = 0.05};
    def->solver.relax = 0;
}

static void define_self(SceneDef *def)
{
    fixture_pull(def, &(FixtureChoice){0});
    def->cable_on_cable = 1;
    def->cable_friction = def->friction;
}

static void define_drum(SceneDef *def) { wound_case(def, 30, 4, 0.2); }

static void define_rod(SceneDef *def, AnalysisKind kind)
{
    RodFixture f = {.n = 12, .length = 1, .steps = 2, .gravity = {0, 0, -9.81}};
    rod_hold(&f.rod.end[ROD_TAIL], 0);
    f.rod.loads = fixture_array(1, sizeof *f.rod.loads);
    f.rod.masses = fixture_array(1, sizeof *f.rod.masses);
    f.rod.masses[f.rod.n_masses++] = (RodMassDef){0.5, 0.2};
    rod_load(&f.rod, 1, 0, 1, v3(0, 0, -1), 100);
    rod_define(def, &f);
    def->analysis.kind = kind;
}

static void define_static(SceneDef *def) { define_rod(def, ANALYSIS_STATIC); }
static void define_modes(SceneDef *def) { define_rod(def, ANALYSIS_MODES); }
static void define_swing(SceneDef *def) { define_rod(def, ANALYSIS_DYNAMICS); }

static void define_positions(SceneDef *def)
{
    reel_pull(def, &(ReelChoice){.payout = 1, .take_in = 1, .tension = 800, .cable = 9, .rope = 5, .head_at = 3});
    def->analysis.kind = ANALYSIS_POSITIONS;
    def->analysis.positions = (PositionsDef){.from = 3.5, .to = 4.5, .step = 0.5};
}

/* Two chains side by side, each with its winch, tied together every two metres, that may touch. */
static void define_chains(SceneDef *def)
{
    fixture_pull(def, &(FixtureChoice){0});
    def->ties = (TiesDef){2, 1e5};
    def->n_beside = def->between_chains = 1;
    def->beside = fixture_array(1, sizeof *def->beside);
    SceneDef *const of[] = {def, &def->beside[0]};
    fixture_pull(of[1], &(FixtureChoice){0});
    for (int k = 0; k < 2; ++k) {
        of[k]->strand = (StrandDef){.present = 1, .name = "left", .place = {k ? -0.05 : 0.05, 0}, .joined = -1};
        of[k]->solver.planar = PLANAR_OFF;
    }
    strcpy(of[1]->strand.name, "right");
}

static void define_lone_chains(SceneDef *def)
{
    define_chains(def);
    def->ties = (TiesDef){0};
    def->between_chains = 0;
}

/* As positions in steady motion wherever that may be. */
static void define_quasi_static(SceneDef *def)
{
    reel_pull(def, &(ReelChoice){.payout = 1, .take_in = 1, .tension = 800, .cable = 9, .rope = 5, .head_at = 3});
    def->solver.motion = MOTION_QUASI_STATIC;
}

/* Another integrator, and other solvers. */
static void define_esdirk(SceneDef *def)
{
    define_sticky(def);
    def->solver.method = METHOD_ESDIRK;
}

static void define_klu(SceneDef *def)
{
    define_sticky(def);
    def->solver.linear.kind = LIN_KLU;
}

typedef struct SceneKind {
    const char *name;
    void (*define)(SceneDef *);
    int spared; /* of memory that lacks: qsort() sorts without, and other orders of the matrix do than METIS's */
} SceneKind;
static const SceneKind scenes[] = {
    {"friction that sticks", define_sticky},
    {"in the plane", define_plane},
    {"rollers that move", define_moving},
    {"reel", define_reel},
    {"conveyor", define_conveyor},
    {"floor", define_floor},
    {"cable on cable", define_self},
    {"drum", define_drum},
    {"rod, static", define_static},
    {"rod, modes", define_modes},
    {"rod that swings", define_swing},
    {"positions", define_positions},
    {"quasi-static", define_quasi_static},
    {"chains", define_chains, 1},
    {"chains that do not touch", define_lone_chains},
    {"ESDIRK", define_esdirk},
    {"KLU", define_klu, 1},
};
enum { SCENES = sizeof scenes / sizeof *scenes };

#endif
