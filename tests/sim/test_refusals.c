/* What a scene cannot be asked for is refused with the reason: positions and quasi-static motion of what has no steady
 * motion, derivatives of what remembers, modes of what moves, trips without a measure; and a handle that is none. */
#include <math.h>
#include <string.h>

#include "sim/run/sim.h"
#include "sim/run/tangent.h"
#include "tests/support/kinds.h"

/* ------------------------------------------------------------------------------------------------------- positions */

static void placed(SceneDef *def)
{
    reel_pull(def, &(ReelChoice){.payout = 1, .take_in = 1, .tension = 800, .cable = 9, .rope = 5, .head_at = 3});
}

static void no_winch(SceneDef *def) { def->winch.present = def->winch.take_in = 0; }
static void set_tension(SceneDef *def)
{
    def->winch.mode = WINCH_TENSION;
    def->winch.tension = (Profile){.kind = PROFILE_CONSTANT, .v1 = 1000};
    def->winch.band = 0.1;
    def->winch.drum_mass = 10;
}
static void jams(SceneDef *def)
{
    def->n_jams = 1;
    def->jams = fixture_array(1, sizeof *def->jams);
    def->jams[0] = (JamDef){"roller", 1, NAN, 2, NAN, 0.1, NAN};
}
static void script(SceneDef *def)
{
    def->n_script = 1;
    def->script = fixture_array(1, sizeof *def->script);
    def->script[0].at = 1;
    def->script[0].command = (Command){.kind = HAWSER_WINCH_BRAKE, .ramp = 1};
}
static void launched(SceneDef *def) { def->launch = (LaunchDef){.present = 1, .along = 0.1}; }
static void in_water(SceneDef *def) { def->medium = (MediumDef){.density = 1000, .normal = 1}; }
static void not_relaxed(SceneDef *def) { def->solver.relax = 0; }
static void sticks(SceneDef *def)
{
    for (int r = 0; r < def->n_rollers; ++r) def->rollers[r].friction.d_s = 1e-3;
}
static void belt(SceneDef *def)
{
    define_conveyor(def);
    def->n_jams = 0;
}
static void rod(SceneDef *def) { define_static(def); }

static const struct {
    void (*define)(SceneDef *), (*change)(SceneDef *);
    const char *says;
} unknown[] = {
    {rod, NULL, "a rod is not pulled"},
    {placed, no_winch, "it needs a winch with a speed"},
    {placed, set_tension, "it needs a winch with a speed"},
    {placed, jams, "a jam happens at a time"},
    {placed, script, "a script has changes in time"},
    {placed, launched, "the chain begins off its route"},
    {placed, in_water, "motion in air or water is not steady from the start"},
    {placed, not_relaxed, "it begins with an equilibrium"},
    {placed, sticks, "friction that sticks depends on the path"},
    {belt, NULL, "the push of a belt at the cable's speed depends on lengths"},
};

/* The definition is taken. */
static void refused(SceneDef *def, const char *key, const char *says)
{
    Sim *s = NULL;
    hawser_error err = {0};
    if (sim_new(def, 1, &s, &err) != HAWSER_ERR_INPUT) fail_msg("not refused: %s", says);
    assert_null(s);
    check_has(err.message, key);
    check_has(err.message, says);
    scene_def_clear(def);
}

TEST(test_positions_of_what)
{
    for (size_t k = 0; k < sizeof unknown / sizeof *unknown; ++k) {
        SceneDef def;
        unknown[k].define(&def);
        if (unknown[k].change) unknown[k].change(&def);
        def.analysis.kind = ANALYSIS_POSITIONS;
        refused(&def, "key 'run.analysis': positions: ", unknown[k].says);
        unknown[k].define(&def);
        if (unknown[k].change) unknown[k].change(&def);
        def.solver.motion = MOTION_QUASI_STATIC;
        refused(&def, "key 'solver.motion': quasi-static: ", def.rod.present ? "there is no motion" : unknown[k].says);
    }
}

/* Asked for where it may be, it is a motion like any other where it may not. */
TEST(test_motion_auto)
{
    for (size_t k = 1; k < sizeof unknown / sizeof *unknown; ++k) {
        SceneDef def;
        Sim *s = NULL;
        hawser_error err = {0};
        unknown[k].define(&def);
        if (unknown[k].change) unknown[k].change(&def);
        def.solver.motion = MOTION_AUTO;
        def.solver.planar = PLANAR_OFF;
        if (sim_new(&def, 1, &s, &err)) fail_msg("%s: %s", unknown[k].says, err.message);
        check_has(s->quasi.stage.why, unknown[k].says);
        sim_free(s);
        scene_def_clear(&def);
    }
    SceneDef def;
    define_chains(&def);
    def.solver.motion = MOTION_QUASI_STATIC;
    refused(&def, "quasi-static", "several chains are moved together");
}

/* Positions that the winch never reaches, or not at its speed. */
TEST(test_positions_where)
{
    const struct {
        PositionsDef at;
        const char *says;
    } row[] = {
        {{.from = 3.5, .to = 90, .step = 0.5}, "5 m is never reached: at the end, 10 s, the front is at 4.7 m"},
        {{.from = 3.01, .to = 4, .step = 0.5}, "the winch is not at its speed with the front at 3.01 m"},
        {{.from = 4, .to = 3.5, .step = 0.5}, "nothing lies between 'from', 4 m, and 'to', 3.5 m"},
    };
    SceneDef def;
    for (size_t k = 0; k < sizeof row / sizeof *row; ++k) {
        placed(&def);
        def.analysis.kind = ANALYSIS_POSITIONS;
        def.analysis.positions = row[k].at;
        refused(&def, "key 'run.positions': ", row[k].says);
    }
    placed(&def);
    def.analysis.kind = ANALYSIS_POSITIONS;
    def.analysis.positions = (PositionsDef){.from = NAN, .to = NAN, .step = NAN};
    def.duration = 2; /* its ramp lasts three */
    refused(&def, "key 'run.analysis': positions: ", "the winch has no constant speed within 2 s");

    /* those that were listed come in their order, the others evenly from the first to the last that there is */
    placed(&def);
    def.analysis.kind = ANALYSIS_POSITIONS;
    def.analysis.positions = (PositionsDef){.n = 3, .at = fixture_array(3, sizeof(double))};
    const double at[] = {4.25, 3.5, 4};
    memcpy(def.analysis.positions.at, at, sizeof at);
    Sim *s = sim_made(&def, 1);
    assert_int_equal(s->positions.n, 3);
    /* 0.3 m lie behind the ramp's end, 3 s; then 0.2 m/s */
    for (int k = 0; k < 3; ++k) check_close(s->positions.time[k], 3 + ((double[]){3.5, 4, 4.25}[k] - 3.3) / 0.2, 1e-9);
    check_close(hawser_sim_end_time(s), s->positions.time[2], 1e-12);
    sim_free(s);
    placed(&def);
    def.analysis.kind = ANALYSIS_POSITIONS;
    def.analysis.positions = (PositionsDef){.from = NAN, .to = NAN, .step = NAN};
    s = sim_made(&def, 1);
    assert_int_equal(s->positions.n, 4); /* 1.4 m in parts of a segment, half a metre, at most */
    check_close(s->positions.time[0], 3, 1e-9);
    check_close(s->positions.time[3], 10, 1e-9);
    sim_free(s);
}

/* ----------------------------------------------------------------------------------------------------- derivatives */

static void reeled(SceneDef *def) { placed(def); }
static void pulled(SceneDef *def) { fixture_pull(def, &(FixtureChoice){0}); }
static void trips(SceneDef *def) { def->winch.trip = (TripDef){.force = 1e4, .brake = 1}; }
static void trips_by_factor(SceneDef *def) { def->winch.trip = (TripDef){.factor = 2, .brake = 1}; }
static void touches_itself(SceneDef *def)
{
    def->cable_on_cable = 1;
    def->cable_friction = def->friction;
}
static void jams_later(SceneDef *def)
{
    jams(def);
    strcpy(def->rollers[0].name, "roller");
}
static void by_position(SceneDef *def)
{
    def->analysis.kind = ANALYSIS_POSITIONS;
    def->analysis.positions = (PositionsDef){.from = 9.08, .to = 9.1, .step = 1};
}

TEST(test_derivatives_of_what)
{
    const struct {
        void (*define)(SceneDef *), (*change)(SceneDef *);
        const char *says;
    } row[] = {
        {pulled, by_position, "with positions are"},
        {rod, NULL, "with a rod are"},
        {reeled, NULL, "with a reel or a winch that takes in are"},
        {pulled, set_tension, "with a winch of set tension are"},
        {pulled, trips, "with a winch that trips are"},
        {pulled, trips_by_factor, "with a winch that trips are"},
        {pulled, jams_later, "with jams are"},
        {pulled, script, "with a script are"},
        {pulled, touches_itself, "with cable on cable are"},
        {define_sticky, NULL, "with friction that sticks are"},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; ++k) {
        SceneDef def, less, more;
        SceneDef *const of[] = {&def, &less, &more};
        for (int i = 0; i < 3; ++i) {
            row[k].define(of[i]);
            if (row[k].change) row[k].change(of[i]);
        }
        const double half = 1e-3;
        Tangent *g = NULL;
        hawser_error err = {0};
        if (tangent_new(&def, 1, &less, &more, &half, 0, &g, &err) != HAWSER_ERR_INPUT)
            fail_msg("not refused: %s, %s", row[k].says, err.message);
        assert_null(g);
        check_has(err.message, row[k].says);
        check_has(err.message, "not known");
        for (int i = 0; i < 3; ++i) scene_def_clear(of[i]);
    }
}

/* One segment more is another equation: no derivative by that. */
TEST(test_derivatives_by_what)
{
    SceneDef def, less, more;
    pulled(&def);
    pulled(&less);
    pulled(&more);
    more.pieces[0].segments += 1;
    const double half = 1e-3;
    Tangent *g = NULL;
    hawser_error err = {0};
    assert_int_equal(tangent_new(&def, 1, &less, &more, &half, 0, &g, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "changes the number of segments");
    assert_null(g);
    scene_def_clear(&def);
    scene_def_clear(&less);
    scene_def_clear(&more);
}

/* ------------------------------------------------------------------------------------------ matrices that fail */

static int singular(Motion *m)
{
    (void)m;
    return 1;
}
static int lacks(Motion *m)
{
    (void)m;
    return -1;
}
static int unsolved(Motion *m, double *b)
{
    (void)m;
    (void)b;
    return 1;
}
static int unsolved_for_lack(Motion *m, double *b)
{
    (void)m;
    (void)b;
    return -1;
}

/* What the solver says of its matrix reaches the caller, whichever way it is integrated: a step that cannot be solved
 * is none, and a lack of memory is one. */
TEST(test_matrices_that_fail)
{
    for (int k = 0; k < 8; ++k) {
        SceneDef def;
        Sim *s = NULL;
        hawser_error err = {0};
        const int lack = k % 2, solution = k / 2 % 2;
        fixture_pull(&def, &(FixtureChoice){0});
        def.solver.method = k < 4 ? METHOD_BDF : METHOD_ESDIRK;
        if (sim_new(&def, 1, &s, &err) || sim_relax(s, NULL, &err)) fail_msg("%s", err.message);
        scene_def_clear(&def);
        const MotionOps *const whole = s->stage.motion->ops;
        MotionOps ops = *whole;
        if (solution) ops.solve = lack ? unsolved_for_lack : unsolved;
        if (!solution) ops.factor = lack ? lacks : singular;
        s->stage.motion->ops = &ops;
        const hawser_status status = sim_advance(s, 0.5, 0, &err);
        s->stage.motion->ops = whole;
        if (status != (lack ? HAWSER_ERR_MEMORY : HAWSER_ERR_RUN))
            fail_msg("trial %d: status %d, '%s'", k, status, err.message);
        check_has(err.message, lack ? "out of memory" : "integration failed at t = 0 s");
        sim_free(s);
    }
}

/* ------------------------------------------------------------------------------------------------- where it begins */

TEST(test_first_window)
{
    SceneDef def;
    reel_pull(&def, &(ReelChoice){.payout = 1, .take_in = 1, .cable = 3, .rope = 5, .head_at = 3});
    def.reel.distance = 1;
    refused(&def, "", "the cable does not reach the reel: its end would lie 0 m along the route");
    reel_pull(&def, &(ReelChoice){.payout = 1, .take_in = 1, .cable = 9, .rope = 5, .head_at = 3});
    def.winch.at = -3.6;
    refused(&def, "",
            "nothing of the chain lies before the winch at the start: make 'drive.winch.at' larger than -3.6 m");
    reel_pull(&def, &(ReelChoice){.payout = 1, .cable = 9, .rope = 5, .head_at = 3});
    def.head_at = -8.6;
    refused(&def, "", "nothing of the chain is off the reel at the start");
}

/* A factor of what is expected is no measure where nothing, or less, is expected. */
TEST(test_trip_without_measure)
{
    SceneDef def;
    pulled(&def);
    def.gravity = V3_ZERO;
    def.tail.tension = (Profile){0};
    def.drag.force = 0;
    def.winch.trip = (TripDef){.factor = 2, .brake = 1};
    refused(&def, "key 'drive.winch.trip.factor'", "which is no measure for a trip: give 'force'");
}

/* In the plane by all means: what is not, and why. */
TEST(test_plane_by_all_means)
{
    SceneDef def;
    pulled(&def);
    def.solver.planar = PLANAR_ON;
    refused(&def, "solver.planar: on: ", "auto or off can be used");
}

TEST(test_no_handle)
{
    check_nan(hawser_sim_time(NULL));
    check_nan(hawser_sim_end_time(NULL));
    assert_string_equal(hawser_sim_title(NULL), "");
    assert_null(hawser_sim_sample(NULL));
    hawser_sim_record(NULL);
    const hawser_station *station;
    const hawser_roller *roller;
    const hawser_position *position;
    const hawser_place *place;
    const hawser_mode *mode;
    const hawser_event *event;
    const hawser_surface *surface;
    const hawser_machine *machine;
    hawser_limit limit[HAWSER_LIMITS_MAX];
    assert_int_equal(hawser_sim_stations(NULL, &station), 0);
    assert_int_equal(hawser_sim_rollers(NULL, &roller), 0);
    assert_int_equal(hawser_sim_positions(NULL, &position), 0);
    assert_int_equal(hawser_sim_places(NULL, &place), 0);
    assert_int_equal(hawser_sim_modes(NULL, &mode), 0);
    assert_int_equal(hawser_sim_events(NULL, &event), 0);
    assert_int_equal(hawser_sim_surfaces(NULL, &surface), 0);
    assert_int_equal(hawser_sim_machines(NULL, &machine), 0);
    assert_int_equal(hawser_sim_limits(NULL, limit), 0);
    assert_null(sim_free(NULL));
}
