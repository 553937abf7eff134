/* The planner's side of `hawser theory`: what it needs to be told and what not, one force in header and tables,
 * friction and places by their right names, and the answers the other way round: closed forms on a straight, and put
 * back into the case they just keep its limits.
 *
 * What an engineer once found wrong on this side, and the tests that would find it again:
 * - falls freely, called safe: test_trust nothing_holds_it, test_case_limits carried_by_nothing, cli/limits
 * - runs away down a shaft, called safe: test_trust a_shaft_without_a_brake, test_case_limits shaft_needs_a_brake and
 *   run_runs_away, down_a_shaft here
 * - a run pulls one of three cables: test_case_bundle runs_as_theory_says, test_trust several_cables
 * - jamming, clearance and fill are no limits: test_trust three_cables_jam, test_answer ducts
 * - long segments in bends, no warning: test_trust coarse_in_a_duct, test_mesh long_segments_jam
 * - a bend to the side levels a grade: test_route_runs bends_keep_their_grade
 * - a conveyor grips the rope: test_grips belts_wait_for_the_cable
 * - two winch forces, "T/R", a bend's place named after the next piece: one_force_and_right_names here; of a run
 *   cli/guide
 * - the friction of nothing in the case: friction_from_to here
 * - settled as the run ends, means of nothing: test_stats, cli/run, cli/limits
 * - `bend: 5`, `sidewall: 300 lb/ft`: test_units bare_angles_are_questioned, pounds_in_place_of_pounds_of_force
 * - EA to EI and a duration for theory: what_is_needed here, test_library stiffness_is_estimated, cli/examples */
#include "tests/io/theory_fixture.h"

static const double G = 9.81;

static json_t *row(json_t *o, const char *table, size_t i)
{
    json_t *found = json_array_get(json_object_get(o, table), i);
    if (!found) fail_msg("no row %zu in '%s'", i, table);
    return found;
}

static double number(json_t *object, const char *key)
{
    json_t *value = json_object_get(object, key);
    if (!value) fail_msg("no key '%s'", key);
    return json_is_number(value) ? json_number_value(value) : NAN;
}

static const char *word(json_t *object, const char *key)
{
    const char *const text = json_string_value(json_object_get(object, key));
    if (!text) fail_msg("no text '%s'", key);
    return text;
}

/* The answer to a question that begins so. */
static json_t *answer(json_t *o, const char *direction, const char *question)
{
    json_t *a;
    size_t i;
    json_array_foreach(json_object_get(o, "answers"), i, a)
    {
        if (!strcmp(word(a, "direction"), direction) && strstr(word(a, "question"), question)) return a;
    }
    fail_msg("no answer to '%s'", question);
    return NULL;
}

static json_t *limit(json_t *o, const char *direction, const char *name)
{
    json_t *l;
    size_t i;
    json_array_foreach(json_object_get(o, "limits"), i, l)
    {
        if (!strcmp(word(l, "direction"), direction) && !strcmp(word(l, "name"), name)) return l;
    }
    fail_msg("no limit '%s'", name);
    return NULL;
}

/* No chain, no duration, no drive: the route's length of the only cable. A run of it is asked how long. */
TEST(what_is_needed)
{
    const char *const text = "cables: {c: {d: 60 mm, mass: 8 kg/m}}\n"
                             "route: {pieces: [{straight: 100 m}]}\n"
                             "friction: {mu: 0.3}\n";
    json_t *o = theory_of(text, NULL);
    check_share(number(o, "reference_total_N"), 0.3 * 8 * G * 100, 1e-9);
    check_share(number(o, "friction"), 0.3, 1e-12);
    assert_null(json_object_get(o, "run")); /* nothing says that one is meant */
    json_decref(o);
    hawser_sim *sim = NULL;
    hawser_error err;
    hawser_case *const c = case_with(text, NULL);
    assert_int_equal(hawser_sim_new(c, NULL, &sim, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "key 'run.duration': missing");
    /* with a winch: 12 m to go at 0.5 m/s, and a ramp of 4 s that costs half of its time */
    assert_int_equal(hawser_case_set(c, "route.head_at", "88 m", NULL), HAWSER_OK);
    assert_int_equal(hawser_case_set(c, "drive", "{winch: {speed: 0.5 m/s, from: 0 s, to: 4 s}}", NULL), HAWSER_OK);
    assert_int_equal(hawser_sim_new(c, NULL, &sim, &err), HAWSER_OK);
    check_share(hawser_sim_end_time(sim), 12 / 0.5 + 2, 1e-9);
    hawser_sim_free(sim);
    hawser_case_free(c);
    expect_bad("cables: {c: {d: 60 mm, mass: 8 kg/m, E: 10 GPa, G: 3 GPa, A: 2000 mm2}, "
               "r: {d: 20 mm, mass: 1 kg/m, E: 10 GPa, G: 3 GPa, A: 200 mm2}}\nroute: {pieces: [{straight: 9 m}]}\n",
               NULL, NULL, "nothing says which is pulled");
}

/* The header had the stretch of a run, the tables the whole route; the friction of a case without rollers was that of
 * nothing in it; a pressure stood as T/R; a bend's end was named after the straight behind it. */
TEST(one_force_and_right_names)
{
    static const char *const run[] = {"run", "{duration: 10 s}", "drive",
                                      "{winch: {speed: 0.1 m/s, from: 0 s, to: 2 s}}", NULL};
    static const char *const tight[] = {"limits.sidewall", "500 N/m", NULL};
    json_t *o = theory_of(data_text("planner"), run);
    json_t *const there = row(o, "directions", 0), *const back = row(o, "directions", 1);
    check_equal(number(o, "reference_total_N"), number(there, "force_N"));
    check_equal(number(o, "backward_total_N"), number(back, "force_N"));
    check_equal(number(o, "start_tension_N"), number(there, "start_N"));
    check_equal(number(o, "max_sidewall_N_per_m"), number(there, "max_sidewall_N_per_m"));
    const size_t stations = json_array_size(json_object_get(o, "stations"));
    check_share(number(row(o, "stations", stations - 1), "reference_N"), number(there, "force_N"), 1e-9);
    check_share(number(o, "friction"), 0.5, 1e-12);
    assert_null(json_object_get(o, "friction_least"));
    assert_int_equal(json_array_size(json_object_get(o, "run")), 1);
    json_decref(o);
    o = theory_of(data_text("planner"), tight);
    check_has(word(o, "verdict_forward"), "(second)"); /* where it ends, and so does the largest pressure in it */
    check_has(word(o, "verdict_backward"), "(bend)");
    json_decref(o);
    char *text = NULL;
    hawser_case *const c = case_with(data_text("planner"), NULL);
    assert_int_equal(hawser_case_theory(c, HAWSER_TABLE, &text, NULL), HAWSER_OK);
    assert_null(strstr(text, "T/R"));
    hawser_text_free(text);
    hawser_case_free(c);
}

/* Ducts of two frictions: both ends of the range. */
TEST(friction_from_to)
{
    static const char *const parts[] = {"theory.stretches", "[{from: 10 m, to: 20 m, mu: 0.1, mu_s: 0.7}]", NULL};
    json_t *o = theory_of(data_text("planner"), parts);
    check_share(number(o, "friction"), 0.5, 1e-12);
    check_share(number(o, "friction_least"), 0.1, 1e-12);
    const double w = 8 * G;
    check_share(number(row(o, "pieces", 0), "forward_end_N"), w * (0.5 * 50 + 0.1 * 10), 1e-9);
    json_decref(o);
}

static const char *const STRAIGHT = "cables: {c: {d: 60 mm, mass: 8 kg/m, E: 10 GPa, G: 3 GPa, A: 2000 mm2}}\n"
                                    "route: {pieces: [{straight: 200 m}]}\n"
                                    "friction: {mu_d: 0.3, mu_s: 0.3}\n"
                                    "limits: {pull: 10 kN}\n"
                                    "theory: {machine_push: 2 kN}\n";

/* Closed forms: T = T0 + mu w L. */
TEST(a_straight_the_other_way_round)
{
    static const char *const tail[] = {"drive", "{tail: {tension: 500 N}}", NULL};
    static const char *const open[] = {"friction", "{mu: 0.3}", "drive", "{tail: {tension: 500 N}}", NULL};
    static const char *const heavy[] = {"friction", "{mu_d: 0.9, mu_s: 0.9}", "drive", "{tail: {tension: 500 N}}",
                                        NULL};
    const double w = 8 * G, free = 10e3 - 500;
    json_t *o = theory_of(STRAIGHT, tail);
    for (int k = 0; k < 2; k++) {
        const char *const way = k ? "backward" : "forward";
        check_share(number(answer(o, way, "largest friction"), "value"), free / (w * 200), 1e-9);
        check_share(number(answer(o, way, "longest length"), "value"), free / (0.3 * w), 1e-9);
        assert_string_equal(word(answer(o, way, "longest length"), "binds"), "pull");
        check_equal(number(answer(o, way, "least number"), "value"), 0);
    }
    json_decref(o);
    /* from rest up to 1.5 times as much where only one coefficient is given: the largest is the last that is SAFE; it
     * was that of the pull at speed, with which the answer is SAFE ONLY IF */
    o = theory_of(STRAIGHT, open);
    check_share(number(answer(o, "forward", "largest friction"), "value"), free / (w * 200) / 1.5, 1e-9);
    check_share(number(answer(o, "forward", "longest length"), "value"), free / (0.3 * w) / 1.5, 1e-9);
    assert_string_equal(word(answer(o, "forward", "longest length"), "binds"), "restart");
    json_decref(o);
    /* three times the friction: 500 + 14126 N for 10 kN, so three machines of 2 kN; each as soon as 2 kN arrive */
    o = theory_of(STRAIGHT, heavy);
    check_share(number(answer(o, "forward", "longest length"), "value"), free / (0.9 * w), 1e-9);
    check_equal(number(answer(o, "forward", "least number"), "value"), 3);
    for (size_t i = 0; i < 3; i++) {
        check_share(number(row(o, "machines", i), "at_m"), (1500 + 2000. * (double)i) / (0.9 * w), 1e-9);
        check_share(number(row(o, "machines", i), "takes_N"), 2000, 1e-9);
    }
    json_decref(o);
}

/* Where bending stiffness would break a limit first, the answer is not where a limit binds (T32). */
#define FLEXIBLE "cables.c.EI", "1 N m2"

/* Put back, each answer leaves the limit that binds no room, and a little more breaks it. */
TEST(put_back)
{
#define KNOWN "drive", "{tail: {tension: 0 N}}", "surfaces.ducts.0.friction"
    static const char *const roomy[] = {"limits.rope_strength",   "90 kN", FLEXIBLE, KNOWN,
                                        "{mu_d: 0.5, mu_s: 0.5}", NULL};
    json_t *o = theory_of(data_text("planner"), roomy);
    for (int k = 0; k < 2; k++) {
        const char *const way = k ? "backward" : "forward";
        json_t *const mu = answer(o, way, "largest friction"), *const radius = answer(o, way, "smallest bend radius");
        char value[64], first[64], second[64], pieces[400];
        const char *const smoother[] = {KNOWN, value, "limits.rope_strength", "90 kN", FLEXIBLE, NULL};
        const char *const wider[] = {"route.pieces",         pieces,  KNOWN,    "{mu_d: 0.5, mu_s: 0.5}",
                                     "limits.rope_strength", "90 kN", FLEXIBLE, NULL};
        snprintf(value, sizeof value, "{mu_d: %.12g, mu_s: %.12g}", number(mu, "value"), number(mu, "value"));
        json_t *again = theory_of(data_text("planner"), smoother);
        check_between(number(limit(again, way, word(mu, "binds")), "margin"), -1e-6, 1e-6);
        json_decref(again);
        const double factor = number(radius, "value") / 5;
        snprintf(first, sizeof first, "%.12g m", 5 * factor);
        snprintf(second, sizeof second, "%.12g m", 8 * factor);
        snprintf(pieces, sizeof pieces,
                 "[{name: in, straight: 60 m}, {name: bend, bend: 60 deg, radius: %s, plane: left}, "
                 "{name: between, straight: 50 m}, {name: second, bend: 30 deg, radius: %s, plane: right}, "
                 "{name: out, straight: 30 m}]",
                 first, second);
        again = theory_of(data_text("planner"), wider);
        check_between(number(limit(again, way, word(radius, "binds")), "margin"), -1e-6, 1e-6);
        json_decref(again);
    }
    /* as much longer at its end */
    json_t *const length = answer(o, "forward", "longest length");
    char out[64];
    snprintf(out, sizeof out, "%.12g m", 30 + number(length, "value") - number(o, "length_m"));
    const char *const longer[] = {"route.pieces.4.straight", out,     KNOWN,    "{mu_d: 0.5, mu_s: 0.5}",
                                  "limits.rope_strength",    "90 kN", FLEXIBLE, NULL};
    json_t *const again = theory_of(data_text("planner"), longer);
    check_between(number(limit(again, "forward", word(length, "binds")), "margin"), -1e-6, 1e-6);
    json_decref(again);
    json_decref(o);
}

/* The places that are answered, put back as machines of the case, keep all limits, and one fewer does not. */
TEST(machines_put_back)
{
    static const char *const tight[] = {"limits.pull", "7 kN", "theory.machine_push", "1.5 kN", FLEXIBLE, NULL};
    json_t *o = theory_of(data_text("planner"), tight);
    check_has(word(o, "verdict_forward"), "NOT SAFE");
    const int n = (int)number(answer(o, "forward", "least number"), "value");
    check_above(n, 0);
    for (int few = 0; few < 2; few++) {
        char list[1000] = "[";
        for (int i = 0; i < n - few; i++) {
            json_t *const m = row(o, "machines", (size_t)i);
            assert_string_equal(word(m, "direction"), "forward");
            snprintf(list + strlen(list), sizeof list - strlen(list), "%s{at: %.12g m, push: 1.5 kN}", i ? ", " : "",
                     number(m, "at_m"));
        }
        strcat(list, "]");
        const char *const set[] = {"limits.pull", "7 kN", "theory.machines", list, FLEXIBLE, NULL};
        json_t *again = theory_of(data_text("planner"), set);
        if (few) check_has(word(again, "verdict_forward"), "NOT SAFE");
        if (!few) assert_memory_equal(word(again, "verdict_forward"), "SAFE", 4);
        json_decref(again);
    }
    json_decref(o);
}

/* A duct that is too tight stays so whatever the friction: the answer is that of the other limits, and says so. */
TEST(what_stays_broken)
{
    static const char *const narrow[] = {FLEXIBLE, "surfaces.ducts.0.radius", "32 mm", NULL};
    static const char *const flexible[] = {FLEXIBLE, NULL};
    json_t *wide = theory_of(data_text("planner"), flexible), *o = theory_of(data_text("planner"), narrow);
    check_share(number(answer(o, "forward", "largest friction"), "value"),
                number(answer(wide, "forward", "largest friction"), "value"), 1e-9);
    check_has(word(answer(o, "forward", "largest friction"), "result"), "clearance, fill stay");
    json_decref(wide);
    json_decref(o);
}

/* Pits: the table of sections, and what a section's winch needs. */
TEST(by_sections)
{
    static const char *const pit[] = {"theory.pits", "[{name: manhole, at: 60 m, back: 300 N}]", NULL};
    json_t *o = theory_of(data_text("planner"), pit);
    const double w = 8 * G;
    assert_int_equal(json_array_size(json_object_get(o, "sections")), 4);
    assert_string_equal(word(row(o, "sections", 0), "ends_at"), "manhole");
    check_share(number(row(o, "sections", 0), "force_N"), 0.5 * w * 60, 1e-9);
    check_share(number(row(o, "sections", 1), "start_N"), 300, 1e-12);
    check_equal(number(row(o, "sections", 1), "force_N"), number(o, "reference_total_N"));
    /* backward the last section is the straight, from the pit */
    check_share(number(row(o, "sections", 3), "force_N"), 300 + 0.5 * w * 60, 1e-9);
    json_decref(o);
}

/* The brake is named with its place and the winch that it asks for; by its limits the other way is better. */
TEST(down_a_shaft)
{
    static const char *const down[] = {"route.slope", "-60 deg", "route.pieces", "[{name: shaft, straight: 60 m}]",
                                       NULL};
    json_t *o = theory_of(data_text("planner"), down);
    const double w = 8 * G, brake = 60 * w * (sin(M_PI / 3) - 0.5 * cos(M_PI / 3));
    assert_int_equal(json_array_size(json_object_get(o, "brakes")), 1);
    check_share(number(row(o, "brakes", 0), "brake_N"), brake, 1e-7);
    assert_string_equal(word(row(o, "brakes", 0), "piece"), "shaft");
    check_has(word(o, "verdict_forward"), "it needs a brake of 2.901 kN");
    assert_string_equal(word(o, "best_direction"), "backward");
    assert_string_equal(word(o, "better_direction"), "forward"); /* by the force alone */
    json_decref(o);
}

/* (PN10): alpha times the largest force, but never more than the cable or the rope may bear. */
TEST(trip_setting)
{
    static const char *const rope[] = {"limits.rope_strength", "40 kN", "limits.alpha", "3", NULL};
    json_t *o = theory_of(data_text("planner"), NULL);
    check_share(number(row(o, "directions", 0), "trip_N"), 1.5 * number(o, "largest_force_N"), 1e-9);
    json_decref(o);
    o = theory_of(data_text("planner"), rope);
    check_share(number(row(o, "directions", 0), "trip_N"), 8000, 1e-9);
    check_has(word(row(o, "directions", 0), "trip_by"), "rope");
    json_decref(o);
}

/* Cold is a note, not a number; what a pushed cable bears is asked for. */
TEST(notes)
{
    static const char *const cold[] = {"theory", "{temperature: -15, feed: 2 kN}", NULL};
    static const char *const weak[] = {"theory", "{feed: 2 kN, bears: 1 kN}", NULL};
    json_t *warm = theory_of(data_text("planner"), NULL), *o = theory_of(data_text("planner"), cold);
    assert_null(json_object_get(warm, "notes"));
    check_has(word(row(o, "notes", 0), "note"), "-15 C");
    check_has(word(row(o, "notes", 1), "note"), "theory.bears");
    check_share(number(o, "start_tension_N"), -2000, 1e-12);
    assert_memory_equal(word(o, "verdict_forward"), "SAFE", 4); /* pushed by what is meant to */
    json_decref(o);
    o = theory_of(data_text("planner"), weak);
    check_has(word(o, "verdict_forward"), "NOT TRUSTED");
    json_decref(o);
    json_decref(warm);
}

TEST(wrong_lists)
{
    static const struct {
        const char *key, *value, *part;
    } cases[] = {
        {"theory.pits", "[{at: 500 m}]", "below the route's length"},
        {"theory.stretches", "[{from: 9 m, to: 4 m, mu: 0.2}]", "must not end at 9 m"},
        {"theory.wear", "[{from: 9 m, factor: 2}, {from: 9 m, factor: 3}]", "above 9 m"},
        {"theory", "{wear_by: place, wear: [{from: 9 m, factor: 0.5}]}", "must not fall"},
        {"theory.machines", "[{at: 5 m}]", "'theory.machines.0.push': missing"},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++)
        expect_bad(data_text("planner"), cases[k].key, cases[k].value, cases[k].part);
}

/* The headline is the largest force that any winch of the job needs. With a pit at 400 m of 500 m it was the last
 * section's: 2.943 kN for mu w 400 m = 11.772 kN. */
TEST(headline_is_the_largest_winch)
{
    static const char text[] = "cables: {power: {d: 90 mm, mass: 10 kg/m}}\n"
                               "route: {pieces: [{straight: 500 m}]}\n"
                               "friction: {mu: 0.3}\n"
                               "theory: {pits: [{name: P, at: 400 m}]}\n"
                               "limits: {pull: 10 kN}\n";
    const double largest = 0.3 * 10 * G * 400, last = 0.3 * 10 * G * 100;
    json_t *const o = theory_of(text, NULL);
    check_share(number(o, "largest_force_N"), largest, 1e-9);
    check_share(number(o, "largest_restart_N"), largest, 1e-9);
    check_share(number(o, "backward_largest_force_N"), largest, 1e-9);
    check_close(number(o, "largest_force_head_m"), 400, 1e-6);
    check_share(number(o, "reference_total_N"), last, 1e-9); /* as documented: at the end */
    json_decref(o);
    char *out = NULL;
    hawser_case *const c = case_with(text, NULL);
    assert_int_equal(hawser_case_theory(c, HAWSER_TABLE, &out, NULL), HAWSER_OK);
    check_has(out, "pull           11.77 kN at the winch (P, the head at 400 m), 11.77 kN from rest");
    check_has(out, "pulled back    11.77 kN at the winch (the end, the head at 0 m), 11.77 kN from rest");
    hawser_text_free(out);
    hawser_case_free(c);
}

/* The shipped example: the first line said 9.765 kN, 15.84 from rest, of the last section; the first one's winch needs
 * more. */
TEST(headline_of_the_example)
{
    hawser_case *c = NULL;
    char *out = NULL;
    assert_int_equal(hawser_case_load(HAWSER_SOURCE_DIR "/cases/theory/planner.yaml", &c, NULL), HAWSER_OK);
    assert_int_equal(hawser_case_theory(c, HAWSER_JSON, &out, NULL), HAWSER_OK);
    json_t *o = json_loads(out, 0, NULL);
    hawser_text_free(out);
    check_share(number(o, "largest_force_N"), 16700.8, 1e-4);
    check_share(number(o, "largest_restart_N"), 25537.9, 1e-4);
    check_share(number(o, "reference_total_N"), 9765.2, 1e-4); /* the last section's winch */
    json_decref(o);
    assert_int_equal(hawser_case_theory(c, HAWSER_TABLE, &out, NULL), HAWSER_OK);
    check_has(out, "pull           16.7 kN at the winch (joint pit, the head at 420 m), 25.54 kN");
    hawser_text_free(out);
    assert_int_equal(hawser_case_describe(c, HAWSER_JSON, &out, NULL), HAWSER_OK); /* said 25.2 kN */
    o = json_loads(out, 0, NULL);
    check_share(number(o, "largest_force_N"), 16700.8, 1e-4);
    json_decref(o);
    hawser_text_free(out);
    hawser_case_free(c);
}

/* Values outside every usual range are questioned above the verdict; kg/km given as kg/m made 18 169 kN without a word.
 */
TEST(unusual_values_are_questioned)
{
    static const struct {
        const char *key, *value, *says;
    } row[] = {
        {"cables.power.mass", "9000 kg/m",
         "  unusual        mass over cross-section of power: 1414711 kg/m3, usually 500 to 12000: is the unit right?"},
        {"cables.power.d", "900 mm", "  unusual        diameter of power: 900 mm"},
        {"friction", "{mu: 3}", "  unusual        friction coefficient of friction: 3"},
        {"surfaces", "{ducts: [{name: D, radius: 180 mm}]}", "  unusual        inside diameter over the cable's of"},
        {"rollers", "{along: {spacing: 2 m, width: 160 mm}}",
         "  unusual        width less 30 mm over the cable's diameter of R1: 1.444, usually 1.5 to"},
        {"limits.conductor", "{material: copper, area: 9000 mm2}", "  unusual        conductors over the cable's"},
        {"route.pieces.0.straight", "5e5 m", "  unusual        length of the route of route"}};
    static const char text[] = "cables: {power: {d: 90 mm, mass: 10 kg/m}}\nroute: {pieces: [{straight: 500 m}]}\n"
                               "friction: {mu: 0.3}\nlimits: {pull: 10 kN}\n";
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        char *out = NULL;
        hawser_case *const c = case_with(text, (const char *const[]){row[k].key, row[k].value, NULL});
        assert_int_equal(hawser_case_theory(c, HAWSER_TABLE, &out, NULL), HAWSER_OK);
        check_has(out, row[k].says);
        const char *const verdict = strstr(out, "SAFE"), *const judged = strstr(out, "NOT JUDGED");
        assert_true(strstr(out, "unusual") < (verdict && (!judged || verdict < judged) ? verdict : judged));
        hawser_text_free(out);
        hawser_case_free(c);
    }
}

/* A bare 1 is 1 N, where a planner may have meant 1 kN: it was SAFE without a word. */
TEST(a_back_tension_of_one_newton_is_questioned)
{
    static const char *const values[] = {"1", "0", "1 kN"};
    static const char text[] = "cables: {power: {d: 90 mm, mass: 10 kg/m}}\nroute: {pieces: [{straight: 50 m}]}\n"
                               "rollers: {along: {spacing: 2 m}}\nfriction: {mu: 0.3}\nlimits: {pull: 10 kN}\n";
    for (int k = 0; k < 3; k++) {
        char *out = NULL;
        hawser_case *const c = case_with(text, (const char *const[]){"drive.tail.tension", values[k], NULL});
        assert_int_equal(hawser_case_theory(c, HAWSER_TABLE, &out, NULL), HAWSER_OK);
        const char *const note = strstr(out, "  unusual        back tension of drive.tail: 1 N, usually 10 to");
        assert_int_equal(note != NULL, k == 0);
        if (k == 0) assert_true(note < strstr(out, "SAFE"));
        hawser_text_free(out);
        hawser_case_free(c);
    }
}

/* What theory changes by along the route, `--sensitivities`: on the level before any bend tension grows by mu w a
 * metre, and the force on the supports is that of tension and weight at right angles to each other. */
TEST(changes_along_the_route)
{
    static const char text[] =
        "cables: {power: {d: 90 mm, mass: 20 kg/m}}\nfriction: {mu: 0.2}\ndrive: {tail: {tension: 3 kN}}\n"
        "route: {pieces: [{straight: 20 m}, {bend: 60 deg, radius: 8 m, plane: left}]}\n"
        "output: {stations: [{name: middle, at: 7 m}]}\n";
    static const char *const by[][2] = {{"tension_by_start", "support_by_start_per_m"},
                                        {"tension_by_friction_N", "support_by_friction_N_per_m"},
                                        {"tension_by_weight_m", "support_by_weight"}};
    const double w = 20 * 9.81, mu = 0.2, reach[] = {7, 20, 20};
    hawser_error err;
    char *out = NULL;
    hawser_case *const c = case_with(text, NULL);
    if (hawser_case_sensitivities(c, HAWSER_JSON, &out, &err)) fail_msg("%s", err.message);
    json_t *const o = json_loads(out, 0, NULL);
    assert_int_equal(json_array_size(json_object_get(o, "along")), 3); /* the station, two ends of pieces */
    for (size_t i = 0; i < 3; i++) {
        json_t *const at = row(o, "along", i);
        const double k = i < 2 ? 0 : 1 / 8., t = number(at, "tension_N"), q = hypot(k * t, w);
        double change[3];
        for (int d = 0; d < 3; d++) {
            change[d] = number(at, by[d][0]);
            check_close(number(at, by[d][1]), (k * k * t * change[d] + (d == 2 ? w : 0)) / q,
                        1e-9 * fmax(1, fabs(change[d])));
        }
        if (i == 2) continue;
        check_share(change[0], 1, 1e-12);
        check_share(change[1], w * reach[i], 1e-12);
        check_share(change[2], mu * reach[i], 1e-12);
    }
    json_decref(o);
    hawser_text_free(out);
    hawser_case_free(c);
}
