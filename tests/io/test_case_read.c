/* What a good case becomes, and the mistakes that only show when its parts are put together. */
#include "tests/io/case_fixture.h"

#include "io/case/case_parts.h"

static const double DEG = 3.14159265358979323846 / 180;

static void same_profile(const Profile *a, const Profile *b)
{
    assert_int_equal(a->kind, b->kind);
    check_share(a->t0, b->t0, 0);
    check_share(a->v0, b->v0, 0);
    check_share(a->t1, b->t1, 0);
    check_share(a->v1, b->v1, 0);
    assert_int_equal(a->n, b->n);
}

static void same_solver(const SolverDef *a, const SolverDef *b)
{
    const double x[] = {a->accuracy,   a->atol_position, a->atol_rotation, a->atol_velocity,
                        a->atol_omega, a->max_step,      a->first_step,    a->relax_tolerance};
    const double y[] = {b->accuracy,   b->atol_position, b->atol_rotation, b->atol_velocity,
                        b->atol_omega, b->max_step,      b->first_step,    b->relax_tolerance};
    const long i[] = {(long)a->method, a->max_order,   a->max_steps,       a->relax,         a->relax_iterations,
                      a->threads,      a->linear.kind, a->linear.ordering, a->linear.threads};
    const long j[] = {(long)b->method, b->max_order,   b->max_steps,       b->relax,         b->relax_iterations,
                      b->threads,      b->linear.kind, b->linear.ordering, b->linear.threads};
    assert_memory_equal(x, y, sizeof x);
    assert_memory_equal(i, j, sizeof i);
}

/* The defaults of the tables are those of scene_def_defaults. */
TEST(defaults_agree)
{
    SceneDef def, usual;
    scene_def_defaults(&usual);
    expect_good(data_text("smallest"), NULL, NULL, &def);
    assert_memory_equal(&def.gravity, &usual.gravity, sizeof def.gravity);
    assert_int_equal(def.frame, usual.frame);
    assert_int_equal(def.geometry, usual.geometry);
    assert_memory_equal(&def.impact, &usual.impact, sizeof def.impact);
    assert_memory_equal(&def.friction, &usual.friction, sizeof def.friction);
    check_share(def.contact_reach, usual.contact_reach, 0);
    same_solver(&def.solver, &usual.solver);
    assert_memory_equal(&def.lead_in, &usual.lead_in, sizeof def.lead_in);
    assert_int_equal(def.winch.present, 0);
    same_profile(&def.winch.speed, &usual.winch.speed);
    same_profile(&def.tail.tension, &usual.tail.tension);
    assert_memory_equal(&def.drag, &usual.drag, sizeof def.drag);
    check_share(def.output.interval, usual.output.interval, 0);
    check_share(def.output.state_interval, usual.output.state_interval, 0);
    check_share(def.output.steady_from, 5, 0);
    check_share(def.head_at, 20, 0);
    assert_int_equal(def.pieces[0].segments, 10);
    assert_int_equal(def.n_stations, 11);
    assert_int_equal(def.output.n_speed_segments, 2);
    scene_def_clear(&def);
}

TEST(ramps_default_to_one_second)
{
    SceneDef def, usual;
    scene_def_defaults(&usual);
    expect_good(data_text("smallest"), "drive", "{winch: {speed: 0.2}, tail: {tension: 7}, rope_drag: {force: 3}}",
                &def);
    usual.winch.speed.v1 = 0.2;
    usual.tail.tension.v1 = 7;
    usual.drag.force = 3;
    same_profile(&def.winch.speed, &usual.winch.speed);
    same_profile(&def.tail.tension, &usual.tail.tension);
    assert_memory_equal(&def.drag, &usual.drag, sizeof def.drag);
    scene_def_clear(&def);
}

/* An hour has 200 states, where the case names no time between them; it had 7200. */
TEST(long_runs_have_few_states)
{
    SceneDef def;
    expect_good(data_text("smallest"), "run.duration", "1 h", &def);
    check_share(def.output.state_interval, 18, 1e-15);
    scene_def_clear(&def);
}

TEST(cable_shorthand)
{
    SceneDef def;
    expect_good(data_text("full-ramps"), NULL, NULL, &def);
    const CableDef *c = &def.cables[0];
    const double d = 87.3e-3, A = 5982.7e-6, J = 3.14159265358979323846 * d * d * d * d / 32;
    assert_string_equal(c->name, "power");
    check_share(c->ea, 115e9 * A, 1e-15);
    check_share(c->ga, 41.5e9 * A, 1e-15);
    check_share(c->gj, 41.5e9 * J, 1e-15);
    check_share(c->ei_y, 115e9 * J / 2, 1e-15);
    check_share(c->ei_z, 115e9 * J / 2, 1e-15);
    check_share(c->mass, 7801 * A, 1e-15);
    check_share(c->diameter, d, 1e-15);
    check_share(c->damping, 1e-3, 1e-15);
    const double factor[6] = {1, 2, 2, 10, 3, 3};
    assert_memory_equal(c->damping_factor, factor, sizeof factor);
    const double preload[6] = {5, 0.5, -0.5, 1, 2, -3};
    assert_memory_equal(c->preload, preload, sizeof preload);
    const CableDef *rope = &def.cables[1];
    const double direct[6] = {15.7e6, 6.05e6, 263, 300, 301, 0.676};
    const double read[6] = {rope->ea, rope->ga, rope->gj, rope->ei_y, rope->ei_z, rope->mass};
    for (int k = 0; k < 6; k++) check_share(read[k], direct[k], 1e-15);
    scene_def_clear(&def);
}

/* What is given directly wins, item by item; EI stands for both directions. */
TEST(direct_wins_over_shorthand)
{
    SceneDef def;
    expect_good(data_text("smallest"), "cables.c.EI", "12 kN m2", &def);
    check_share(def.cables[0].ei_y, 12e3, 0);
    check_share(def.cables[0].ei_z, 12e3, 0);
    check_share(def.cables[0].ea, 115e9 * 5982.7e-6, 1e-15);
    scene_def_clear(&def);
    expect_good(data_text("smallest"), "cables.c.EI_z", "7", &def);
    check_share(def.cables[0].ei_z, 7, 0);
    check_share(def.cables[0].ei_y, 327887.39, 1e-7);
    scene_def_clear(&def);
    /* whoever changes E beside EA and EI would change nothing */
    expect_bad(data_text("smallest"), "cables.c", "{E: 1, EA: 1, GA: 1, GJ: 1, EI: 1, d: 1 mm, mass: 1}",
               "key 'cables.c.E': has no effect beside 'EA' and 'EI': leave it out, or change these");
    expect_bad(data_text("smallest"), "cables.c", "{EA: 1, GA: 1, GJ: 1, EI: 1, EI_y: 1, EI_z: 1, d: 1 mm, mass: 1}",
               "key 'cables.c.EI': has no effect beside 'EI_y' and 'EI_z'");
    expect_bad(data_text("smallest"), "cables.c", "{EA: 1, GA: 1, GJ: 1, EI: 1, d: 1 mm, mass: 1, density: 7801}",
               "key 'cables.c.density': has no effect beside 'mass'");
    expect_bad(data_text("smallest"), "friction", "{mu: 0.3, mu_s: 0.2, mu_d: 0.1}",
               "key 'friction.mu': has no effect beside 'mu_s' and 'mu_d'");
    expect_good(data_text("smallest"), "friction", "{mu: 0.3, mu_d: 0.1}", &def);
    check_share(def.friction.mu_s, 0.3, 0);
    scene_def_clear(&def);
    expect_bad(data_text("smallest"), "cables.c", "{G: 41.5 GPa, d: 87.3 mm, A: 5982.7 mm2, density: 7801}",
               "key 'cables.c.EA': missing: give it, or E and A");
    expect_bad(data_text("smallest"), "cables.c", "{E: 1, d: 1, A: 1, density: 1}", "key 'cables.c.GA': missing");
    expect_bad(data_text("smallest"), "cables.c", "{E: 1, G: 1, d: 1, A: 1}",
               "key 'cables.c.mass': missing: give it, or density and A");
    expect_bad(data_text("smallest"), "cables.c", "{EA: 1, G: 1, GJ: 1, d: 1, mass: 1}",
               "key 'cables.c.GA': missing: give it, or G and A");
    expect_bad(data_text("smallest"), "cables.c", "{EA: 1, GA: 1, GJ: 1, d: 1}",
               "key 'cables.c.mass': missing: give it, or density and A");
    expect_good(data_text("smallest"), "cables.c", "{EA: 1, GA: 1, GJ: 1, EI: 1, d: 1 mm, mass: 1}", &def);
    scene_def_clear(&def);
}

TEST(everything_has_its_place)
{
    SceneDef def;
    expect_good(data_text("full-ramps"), NULL, NULL, &def);
    assert_string_equal(def.title, "a pull");
    check_share(def.gravity.z, -9.8, 0);
    assert_int_equal(def.frame, FRAME_ADAMS);
    assert_int_equal(def.n_pieces, 2);
    assert_int_equal(def.pieces[0].segments, 80);
    assert_int_equal(def.pieces[1].segments, 10);
    assert_int_equal(def.pieces[1].cable, 1);
    assert_int_equal(def.pieces[1].swivel, 1);
    assert_int_equal(def.n_route, 2);
    assert_int_equal(def.route[1].kind, ROUTE_BEND);
    check_share(def.route[1].angle, 15 * DEG, 1e-15);
    check_share(def.route[1].plane, 90 * DEG, 1e-15);
    check_share(def.route_start.y, 2, 0);
    check_share(def.route_heading, 30 * DEG, 1e-15);
    check_share(def.route_slope, -5 * DEG, 1e-15);
    check_share(def.head_at, 25, 0);
    assert_int_equal(def.lead_in.present, 1);
    assert_int_equal(def.lead_in.carries_weight, 0);
    check_share(def.lead_in.blend, 0.4, 1e-15);
    assert_int_equal(def.geometry, GEOMETRY_CYLINDER);
    const ImpactLaw impact = {.k = 1e8, .e = 1.4, .c = 5e3, .d = 0.2e-3};
    assert_memory_equal(&def.impact, &impact, sizeof impact);
    check_share(def.contact_reach, 2, 0);
    check_share(def.friction.mu_s, 0.12, 0);
    check_share(def.friction.mu_d, 0.11, 0);
    check_share(def.friction.v_d, 7e-3, 1e-15);
    scene_def_clear(&def);
}

TEST(drive_and_solver_have_their_places)
{
    SceneDef def;
    expect_good(data_text("full-ramps"), NULL, NULL, &def);
    const Profile speed = {.kind = PROFILE_STEP5, .t0 = 1, .t1 = 13, .v1 = 0.1};
    assert_int_equal(def.winch.speed.kind, speed.kind);
    check_share(profile_value(&def.winch.speed, 7), profile_value(&speed, 7), 1e-15);
    assert_int_equal(def.winch.axial_only, 1);
    assert_int_equal(def.tail.tension.kind, PROFILE_CONSTANT);
    check_share(profile_value(&def.tail.tension, 0), 6800, 0);
    check_share(def.drag.force, 2200, 0);
    check_share(def.drag.ratio, 0.9, 0);
    check_share(def.duration, 30, 0);
    check_share(def.output.steady_from, 18, 0);
    check_share(def.solver.accuracy, 1e-4, 0);
    check_share(def.solver.atol_position, 1e-3, 0);
    check_share(def.solver.atol_rotation, DEG, 1e-15);
    check_share(def.solver.atol_velocity, 1e-3, 0);
    check_share(def.solver.atol_omega, DEG, 1e-15);
    assert_int_equal(def.solver.max_order, 3);
    check_share(def.solver.max_step, 0.1, 1e-15);
    check_share(def.solver.first_step, 1e-3, 1e-15);
    check_equal(def.solver.max_steps, 3000000000L);
    assert_int_equal(def.solver.linear.kind, LIN_KLU);
    assert_int_equal(def.solver.linear.ordering, ORDER_METIS);
    assert_int_equal(def.solver.linear.threads, 2);
    assert_int_equal(def.solver.relax, 0);
    assert_int_equal(def.solver.relax_iterations, 50);
    check_share(def.output.interval, 0.1, 1e-15);
    check_share(def.output.state_interval, 1, 0);
    assert_int_equal(def.output.n_speed_segments, 3);
    assert_int_equal(def.output.speed_segments[2], 89);
    assert_int_equal(def.output.n_load_rollers, 2);
    assert_string_equal(def.rollers[def.output.load_rollers[0]].name, "P3");
    assert_string_equal(def.rollers[def.output.load_rollers[1]].name, "far");
    scene_def_clear(&def);
}

/* The words of the file are in the order of the enumerations. */
TEST(words_mean_what_they_say)
{
    static const struct {
        const char *word;
        LinKind kind;
    } kinds[] = {{"auto", LIN_AUTO},    {"block", LIN_BLOCK}, {"bordered", LIN_BORDERED}, {"klu", LIN_KLU},
                 {"klu-full", LIN_KLU}, {"band", LIN_KLU},    {"dense", LIN_KLU}};
    static const struct {
        const char *word;
        LinOrdering ordering;
    } orderings[] = {{"auto", ORDER_AUTO}, {"amd", ORDER_AMD}, {"colamd", ORDER_COLAMD}, {"metis", ORDER_METIS}};
    SceneDef def;
    for (int k = 0; k < 7; k++) {
        expect_good(data_text("smallest"), "solver.linear_solver", kinds[k].word, &def);
        assert_int_equal(def.solver.linear.kind, kinds[k].kind);
        scene_def_clear(&def);
    }
    for (int k = 0; k < 4; k++) {
        expect_good(data_text("smallest"), "solver.ordering", orderings[k].word, &def);
        assert_int_equal(def.solver.linear.ordering, orderings[k].ordering);
        scene_def_clear(&def);
    }
}

TEST(planes_of_bends)
{
    static const struct {
        const char *word;
        double degrees;
    } planes[] = {{"left", 0}, {"up", 90}, {"right", 180}, {"down", 270}, {"30 deg", 30}, {"-90 deg", -90}};
    for (size_t k = 0; k < sizeof planes / sizeof *planes; k++) {
        SceneDef def;
        char piece[80];
        snprintf(piece, sizeof piece, "[{bend: 10 deg, radius: 10 m, plane: %s}]", planes[k].word);
        expect_good(data_text("smallest"), "route.pieces", piece, &def);
        check_share(def.route[0].plane, planes[k].degrees * DEG, 1e-15);
        scene_def_clear(&def);
    }
}

/* No segment is longer than asked for, and round numbers stay what they are. */
TEST(segments_are_counted)
{
    static const struct {
        const char *length, *segment;
        int segments;
    } cases[] = {{"152.5 m", "500 mm", 305}, {"152.5 m", "0.25", 610}, {"152.6 m", "500 mm", 306},
                 {"0.1 m", "500 mm", 1},     {"0.3 m", "0.1 m", 3},    {"185 m", "125 mm", 1480}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        SceneDef def;
        char chain[100];
        snprintf(chain, sizeof chain, "[{cable: c, length: %s, segment: %s}]", cases[k].length, cases[k].segment);
        expect_good(data_text("smallest"), "chain", chain, &def);
        assert_int_equal(def.pieces[0].segments, cases[k].segments);
        scene_def_clear(&def);
    }
}

TEST(tables_of_time)
{
    SceneDef def;
    expect_good(data_text("full-tables"), NULL, NULL, &def);
    check_share(def.gravity.y, 0.2, 0);
    assert_int_equal(def.winch.speed.kind, PROFILE_TABLE);
    assert_int_equal(def.winch.speed.n, 3);
    check_share(profile_value(&def.winch.speed, 5), 0.05, 1e-15);
    check_share(profile_value(&def.winch.speed, 15), 0.15, 1e-15);
    check_share(profile_value(&def.tail.tension, 30), 2500, 1e-15);
    scene_def_clear(&def);
    expect_bad(data_text("full-tables"), "drive.winch.table", "[[0, 0], [0, 1]]",
               "'drive.winch.table.1.0': value '0' is out of range: must be above the time before");
    expect_bad(data_text("full-tables"), "drive.winch.table", "[[0, 0]]", "expected two at least");
    expect_bad(data_text("full-tables"), "drive.winch.table", "[[0, 0], [1, 2, 3]]",
               "'drive.winch.table.1': the value is a list of 3: expected 2 numbers");
    expect_bad(data_text("full-tables"), "drive.winch.table", "[[0, 0], [1, -2]]",
               "'drive.winch.table.1.1': value '-2' is out of range");
    expect_bad(data_text("full-tables"), "drive.winch.table", "[[0, 0], [1, 5 kN]]", "not that of a speed");
    expect_bad(data_text("full-tables"), "drive.winch.table", "[[0, 0], [1, nan]]", "is not a number");
    expect_bad(data_text("full-tables"), "drive.winch.speed", "1", "'drive.winch.speed': not allowed beside 'table'");
    expect_bad(data_text("full-tables"), "drive.tail.ramp", "step", "'drive.tail.ramp': not allowed beside 'table'");
    expect_bad(data_text("full-tables"), "drive.tail", "{ramp: step}",
               "'drive.tail.tension': missing: give it, or a 'table'");
}

TEST(stations_are_sorted)
{
    SceneDef def;
    expect_good(data_text("full-ramps"), "output.stations.list.0.at", "10 m", &def);
    /* 0, 5, 10 (named A), 15, 20, 25 of 25.708 m */
    assert_int_equal(def.n_stations, 6);
    assert_string_equal(def.stations[1].name, "5 m");
    assert_string_equal(def.stations[2].name, "A");
    for (int k = 0; k < 6; k++) check_share(def.stations[k].s, 5 * k, 1e-12);
    scene_def_clear(&def);
    expect_good(data_text("full-tables"), NULL, NULL, &def);
    assert_int_equal(def.n_stations, 2);
    assert_string_equal(def.stations[0].name, "A");
    scene_def_clear(&def);
}

TEST(parts_must_fit)
{
    static const struct {
        const char *key, *value, *part;
    } cases[] = {
        {"cables", "{}", "key 'cables': the value is a map without a cable"},
        {"chain", "[]", "key 'chain': the value is a list without a piece"},
        {"chain.0.cable", "powr", "key 'chain.0.cable': value 'powr' is not one of the 2 in 'cables', such as 'power'"},
        {"chain.0.swivel", "true", "key 'chain.0.swivel': value 'true': the first piece has no eye"},
        {"chain.0.segment", "1 um", "key 'chain.0.segment': too short: the chain may have 200000 segments"},
        {"route.pieces", "[]", "key 'route.pieces': the value is a list without a piece: the route is empty"},
        {"route.pieces.0.bend", "1 deg", "key 'route.pieces.0': two kinds at once"},
        {"route.pieces.0", "{name: x}", "key 'route.pieces.0': no kind"},
        {"route.pieces.0.radius", "1 m", "key 'route.pieces.0.radius': not allowed in a 'straight' piece"},
        {"route.pieces.1", "{bend: 1 deg, plane: up}", "key 'route.pieces.1.radius': missing"},
        {"route.pieces.1", "{bend: 1 deg, radius: 1 m}", "key 'route.pieces.1.plane': missing"},
        {"route.pieces.1.radius", "40 mm",
         "key 'route.pieces.1.radius': value '40 mm' is too small: must be above the cable's own radius, 0.04365 m"},
        {"route.head_at", "25.8 m",
         "key 'route.head_at': value '25.8 m' is out of range: must be on the route, at most 25.70796"},
        {"rollers.along.to", "-1 m", "key 'rollers.along.to': out of range"},
        {"rollers.along.spacing", "1 m", "key 'rollers.along.spacing': given beside count"},
        {"rollers.along.count", "0", "key 'rollers.along.count': missing: give either"},
        {"rollers.list.0.axis", "[0, 0, 0]", "key 'rollers.list.0.axis': the value is a list: expected a direction"},
        {"friction.v_d", "3 mm/s", "key 'friction.v_d': value 0.003 m/s is out of range: must be above v_s"},
        {"friction.mu_d", "0.2", "key 'friction.mu_d': mu_d, 0.2, is out of range: must be at most mu_s, 0.12"},
        {"drive.rope_drag.v_d", "2 mm/s", "key 'drive.rope_drag.v_d': value 0.002 m/s is out of range"},
        {"drive.winch.to", "1 s", "key 'drive.winch.to': value 1 s is out of range: must be above 'from'"},
        {"run.steady_from", "30 s", "key 'run.steady_from': value '30 s' is out of range: must be below 'duration'"},
        {"output.interval", "1 ns", "key 'output.interval': interval of 1e-09 s is out of range"},
        {"output.states", "1 us", "key 'output.states'"},
        {"output.stations.spacing", "1 um", "key 'output.stations.spacing': too many stations"},
        {"output.stations.list.0.at", "26 m", "key 'output.stations.list.0.at': value '26 m' is out of range"},
        {"output.speeds_of", "[0, 90]",
         "key 'output.speeds_of.1': value '90' is out of range: must be at least 0, at most 89"},
        {"output.rollers_of", "[P1, P99]",
         "key 'output.rollers_of.1': value 'P99' is not a roller: names run from 'P1' to 'edge lip'"},
        {"output.rollers_of", "[P1, [P2]]",
         "key 'output.rollers_of.1': the value is a list: expected the name of a roller"},
        {"paper.terms.0.arc", "1 m", "key 'paper.terms.0': slope and arc at once"},
        {"paper.terms.0.from", "1 deg", "key 'paper.terms.0.from': not allowed"},
        {"paper.terms.1.length", "1 m", "key 'paper.terms.1.length': not allowed"},
        {"paper.terms.0.length", "11 m", "key 'paper.terms': lengths add up to 26.708 m: must be the route's 25.708 m"},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        expect_bad(data_text("full-ramps"), cases[k].key, cases[k].value, cases[k].part);
    }
    expect_bad(data_text("smallest"), "solver", "{max_order: 6}",
               "key 'solver.max_order': value '6' is out of range: must be at least 1, at most 5");
}

TEST(names_too_long)
{
    char name[100], key[120];
    memset(name, 'n', sizeof name - 1);
    name[sizeof name - 1] = 0;
    expect_bad(data_text("full-ramps"), "rollers.list.0.name", name, "is too long: at most 63 characters");
    snprintf(key, sizeof key, "cables.%s", name);
    expect_bad(data_text("smallest"), key, "{d: 1}", "the name is too long: at most 63 characters");
}

/* A case is one document however it is written: file, line and key of a real file are named. */
TEST(messages_name_the_line)
{
    expect_bad(data_text("wrong-unit"), NULL, NULL,
               NAME
               ":7: key 'chain.0.segment': value '500 mn' has an unknown unit 'mn': expected a length, such as 500 mm");
}

/* Other names of keys and words are the same case; a decimal comma, an area without its unit and two names for one
 * thing are said to be that. */
TEST(as_people_type_it)
{
    SceneDef def;
    const char *const text =
        "cables: {c: {d: 1.5 in, mass: 3.2 lbs/ft}}\n"
        "route: {pieces: [{length: 500 feet, slope: -5 %}, {angle: 90\xc2\xb0, radius: 4 ft, turn: left}]}\n"
        "surfaces: {ducts: [{name: d, inner diameter: 4 in}]}\nfriction: {mu: 0.35}\n"
        "limits: {code: TB 889, conductor: {material: Cu, area: 000 AWG}}\n";
    expect_good(text, NULL, NULL, &def);
    check_close(def.surfaces[0].shape.radius, 2 * 0.0254, 1e-15); /* 4 in when it was taken for a radius */
    check_close(def.route[0].slope, -atan(0.05), 1e-15);
    check_close(def.route[1].angle, 90 * DEG, 1e-15);
    check_close(def.limits.area, awg_area(-2), 1e-18);
    scene_def_clear(&def);
    expect_bad(text, "surfaces.ducts.0.radius", "2 in",
               "key 'surfaces.ducts.0.inner diameter': 'radius' says the same: give one of the two");
    expect_bad(text, "friction", "{mu: 0,3}", "value '0,3' has a comma: decimals follow a point, '0.3'");
    expect_bad(text, "limits.conductor.area", "630", "it has no unit: write '630 mm2'");
    expect_bad(text, "limits.conductor.material", "Tin", "expected one of copper, aluminium");
}
