/* A simulation of every kind of scene, with each allocation failing once: while it is built, while it is relaxed and
 * makes its first steps, and while it is read from a checkpoint. A lack of memory is told as that and as nothing else,
 * and what is left can be freed. */
#define _GNU_SOURCE /* RTLD_NEXT */
#include "tests/support/lack.h"

#include <dlfcn.h>
#include <string.h>
#include <sundials/sundials_context.h>

#include "sim/run/sim.h"
#include "tests/support/scene.h"

enum { MOST = 4000 };
static const double MOMENT = 0.01; /* s that are simulated */

/* It does not look whether its logger has got memory: that is not what is tried here. */
int SUNContext_Create(void *communicator, SUNContext *context)
{
    int (*const create)(void *, SUNContext *) = (int (*)(void *, SUNContext *))dlsym(RTLD_NEXT, "SUNContext_Create");
    const long left = lack_left;
    lack_after(-1);
    const int status = create(communicator, context);
    lack_after(left);
    return status;
}

/* ------------------------------------------------------------------------------------------------------- scenes */

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

static void define_full(SceneDef *def)
{
    define_sticky(def);
    def->solver.linear.kind = LIN_KLU_FULL;
}

static void define_dense_modes(SceneDef *def)
{
    define_modes(def);
    def->solver.linear.kind = LIN_DENSE;
}

static void define_dense_esdirk(SceneDef *def)
{
    define_esdirk(def);
    def->solver.linear.kind = LIN_DENSE;
}

static void define_dense_positions(SceneDef *def)
{
    define_positions(def);
    def->solver.linear.kind = LIN_DENSE;
}

static void define_dense(SceneDef *def)
{
    define_moving(def);
    def->solver.linear.kind = LIN_DENSE;
}

static const struct {
    const char *name;
    void (*define)(SceneDef *);
    int spared; /* qsort() sorts without, and other orders of the matrix do where METIS's cannot be had */
} scenes[] = {
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
    {"unreduced", define_full, 1},
    {"dense", define_dense},
    {"rod, modes, dense", define_dense_modes},
    {"ESDIRK, dense", define_dense_esdirk},
    {"positions, dense", define_dense_positions},
};
enum { SCENES = sizeof scenes / sizeof *scenes };

/* --------------------------------------------------------------------------------------------------------- trials */

/* One attempt with the k-th allocation failing; *s is what is left of it, to be freed. */
typedef hawser_status Attempt(int scene, long k, Sim **s, hawser_error *err);

static hawser_status built(int scene, long k, Sim **s, hawser_error *err)
{
    SceneDef def;
    scenes[scene].define(&def);
    lack_after(k);
    const hawser_status status = sim_new(&def, 1, s, err);
    if (status) assert_null(*s);
    const long left = lack_left; /* of the copy of the definition nothing is left */
    lack_after(-1);
    scene_def_clear(&def);
    lack_after(left);
    return status;
}

static hawser_status moved(Sim *s, hawser_error *err)
{
    hawser_status status = sim_relax(s, NULL, err);
    const double until = fmax(MOMENT, hawser_sim_end_time(s) / 4);
    const int stepped = s->stage.scene.def.analysis.kind != ANALYSIS_DYNAMICS;
    if (!status) status = sim_advance(s, stepped ? until : MOMENT, 0, err);
    return status;
}

static hawser_status relaxed_and_moved(int scene, long k, Sim **s, hawser_error *err)
{
    hawser_status status = built(scene, -1, s, err);
    if (status) fail_msg("%s: %s", scenes[scene].name, err->message);
    lack_after(k);
    return moved(*s, err);
}

static Checkpoint written(int scene)
{
    Sim *s = NULL;
    hawser_error err = {0};
    if (built(scene, -1, &s, &err) || moved(s, &err)) fail_msg("%s: %s", scenes[scene].name, err.message);
    Checkpoint count = checkpoint_new(0);
    assert_int_equal(sim_checkpoint(&count, s, &err), HAWSER_OK);
    Checkpoint c = checkpoint_new(count.size);
    assert_int_equal(sim_checkpoint(&c, s, &err), HAWSER_OK);
    assert_int_equal(c.status, HAWSER_OK);
    sim_free(s);
    return c;
}

static Checkpoint kept; /* what is read */

static hawser_status read_back(int scene, long k, Sim **s, hawser_error *err)
{
    hawser_status status = built(scene, -1, s, err);
    if (status) fail_msg("%s: %s", scenes[scene].name, err->message);
    lack_after(k);
    Checkpoint c = checkpoint_over(kept.bytes, kept.size, &(*s)->texts);
    status = sim_checkpoint(&c, *s, err);
    if (!status && c.status) status = error_set(err, c.status, "%s", c.fault);
    return status;
}

/* Every allocation of an attempt fails once; how many were missed. */
static long every_allocation(int scene, Attempt *attempt, const char *what)
{
    long told = 0, without = 0;
    for (long k = 0, met = 1; met; ++k) {
        check_below(k, MOST);
        Sim *s = NULL;
        hawser_error err = {0};
        const hawser_status status = attempt(scene, k, &s, &err);
        met = lack_end();
        if (!met && status) fail_msg("%s: %s", scenes[scene].name, err.message);
        if (met && !status) ++without; /* qsort() and the like */
        if (status) {
            if (status != HAWSER_ERR_MEMORY || !strstr(err.message, " memory"))
                fail_msg("%s, %s, allocation %ld: status %d, '%s'", scenes[scene].name, what, k, status, err.message);
            ++told;
        }
        sim_free(s);
    }
    print_message("%s, %s: %ld allocations missed, %ld done without\n", scenes[scene].name, what, told, without);
    if (!scenes[scene].spared) check_at_most(without, told / 10);
    return told;
}

static void test_building(void **state)
{
    (void)state;
    if (!lack_works()) skip();
    for (int k = 0; k < SCENES; ++k) check_above(every_allocation(k, built, "built"), 50);
}

static void test_moving(void **state)
{
    (void)state;
    if (!lack_works()) skip();
    for (int k = 0; k < SCENES; ++k) check_above(every_allocation(k, relaxed_and_moved, "moved"), 5);
}

static void test_reading(void **state)
{
    (void)state;
    if (!lack_works()) skip();
    for (int k = 0; k < SCENES; ++k) {
        kept = written(k);
        check_above(every_allocation(k, read_back, "read"), 2);
        checkpoint_free(&kept);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_building), cmocka_unit_test(test_moving),
                                       cmocka_unit_test(test_reading)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
