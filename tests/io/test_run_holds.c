/* What a run says of a pull that changes on the way: pushed for a while, its front far from where it began, belts that
 * are reached late. Each was SAFE, or trusted, where it should not have been. */
#include "tests/io/theory_fixture.h"

static const char KINDS[] =
    "cables:\n"
    "  c: {d: 80 mm, EA: 100 MN, GA: 40 MN, GJ: 10 kN m2, EI: 1 kN m2, mass: 14 kg/m, damping: 2 ms}\n"
    "  rope: {d: 20 mm, EA: 8 MN, GA: 3 MN, GJ: 100 N m2, EI: 50 N m2, mass: 0.9 kg/m, damping: 2 ms}\n"
    "friction: {mu: 0.2, v_s: 1 mm/s}\n"
    "limits: {pull: 50 kN, sidewall: 3 kN/m, rope_strength: 160 kN, winch_capacity: 100 kN, attachment_rating: 100 "
    "kN}\n";

/* A case of these kinds and of what is given; the caller's (free). */
static char *case_of(const char *rest)
{
    char *const text = malloc(sizeof KINDS + strlen(rest));
    assert_non_null(text);
    strcpy(text, KINDS);
    return strcat(text, rest);
}

/* ------------------------------------------------------------------------------------------------- pushed */

static const char SLOPE[] = "lead_in: {}\n"
                            "chain: [{cable: c, length: 60 m, segment: 500 mm}, {cable: rope, length: 12 m, segment: "
                            "500 mm, swivel: true}]\n"
                            "route: {head_at: 48 m, transition_radius: 10 m, pieces: [{straight: 10 m}, {straight: 22 "
                            "m, slope: -30 deg}, {straight: 28 m, slope: 0 deg}]}\n"
                            "surfaces: {ducts: [{name: duct, radius: 60 mm, place: resting}]}\n"
                            "drive: {winch: {speed: 0.1 m/s, to: 4 s}, tail: {tension: 1.6 kN, ramp: none}}\n"
                            "run: {duration: 45 s, steady_from: 35 s}\n";

/* A reel's brake that lets go for a quarter of a minute: the slope pushes the cable, and theory at the end of the run,
 * with the brake back, has it taut. What it was pushed with is the brake that is missing where it is so all along. */
TEST(pushed_for_a_while)
{
    char *const text = case_of(SLOPE);
    hawser_sim *sim = run_of(text, NULL);
    hawser_limit l = run_limit(sim, "run_away");
    assert_true(l.judged && l.ok);
    assert_true(l.value <= 0);
    hawser_sim_free(sim);
    const char *const lets_go[] = {
        "drive.tail", "{table: [[0 s, 1.6 kN], [10 s, 1.6 kN], [16 s, 400 N], [18 s, 400 N], [30 s, 1.6 kN]]}", NULL};
    sim = run_of(text, lets_go);
    l = run_limit(sim, "run_away");
    assert_true(l.judged && !l.ok);
    check_has(l.source, "it was in compression");
    hawser_sim_free(sim);
    const char *const held_so[] = {"drive.tail.tension", "400 N", NULL};
    sim = run_of(text, held_so);
    const hawser_limit always = run_limit(sim, "run_away");
    assert_true(always.judged && !always.ok);
    print_message("pushed with %.1f N; a brake of %.1f N is missing where it is so all along\n", l.value, always.value);
    check_share(l.value, always.value, 0.1);
    hawser_sim_free(sim);
    free(text);
}

/* Friction that a script halves. */
TEST(pushed_while_friction_fails)
{
    char *const text = case_of(SLOPE);
    hawser_sim *const sim = run_of(text, (const char *const[]){"drive.tail.tension", "1.1 kN", "drive.script",
                                                               "[{at: 10 s, do: friction, factor: 0.3, ramp: 2 s}, "
                                                               "{at: 18 s, do: friction, factor: 1, ramp: 2 s}]",
                                                               NULL});
    const hawser_limit l = run_limit(sim, "run_away");
    assert_true(l.judged && !l.ok);
    check_has(l.source, "it was in compression");
    hawser_sim_free(sim);
    hawser_sim *const all_along =
        run_of(text, (const char *const[]){"drive.tail.tension", "1.1 kN", "friction.mu", "0.06", NULL});
    const hawser_limit always = run_limit(all_along, "run_away");
    print_message("pushed with %.1f N; a brake of %.1f N is missing with that friction\n", l.value, always.value);
    check_share(l.value, always.value, 0.25); /* friction comes and goes within 2 s, of which 6 are full */
    hawser_sim_free(all_along);
    free(text);
}

/* A winch that is slow, or inches: its brake is gone for ten seconds, of which the mesh passes little. */
TEST(pushed_by_inches)
{
    char inching[3000] = "{table: [[0 s, 0 m/s]";
    for (int k = 0; k < 30; k++) {
        const size_t used = strlen(inching);
        snprintf(inching + used, sizeof inching - used,
                 ", [%.1f s, 0.03 m/s], [%.1f s, 0.03 m/s], [%.1f s, 0 m/s], [%.1f s, 0 m/s]", 2.5 * k + 0.5,
                 2.5 * k + 1, 2.5 * k + 1.5, 2.5 * k + 2.5);
    }
    strcat(inching, "]}");
    const char *const winch[] = {"{speed: 0.02 m/s, to: 2 s}", inching};
    char *const text = case_of(
        "lead_in: {}\nchain: [{cable: c, length: 80 m, segment: 1 m}]\n"
        "route: {head_at: 52 m, transition_radius: 20 m, pieces: [{straight: 5 m}, {straight: 25 m, slope: -22 deg}, "
        "{straight: 30 m, slope: 0 deg}]}\nsurfaces: {ducts: [{name: hill, radius: 60 mm, place: resting}]}\n"
        "drive: {tail: {table: [[0 s, 2 kN], [19 s, 2 kN], [20.5 s, 0 N], [32 s, 0 N], [34 s, 2 kN]]}, winch: {speed: "
        "0.02 m/s, to: 2 s}}\nrun: {duration: 60 s, steady_from: 45 s}\nsolver: {passes: 1}\n");
    for (int k = 0; k < 2; k++) {
        hawser_sim *const sim = run_of(text, (const char *const[]){"drive.winch", winch[k], NULL});
        const hawser_limit l = run_limit(sim, "run_away");
        print_message("pushed with %.1f N\n", l.value);
        assert_true(l.judged && !l.ok);
        check_share(l.value, 443, 0.15);
        hawser_sim_free(sim);
    }
    free(text);
}

/* What a belt has pushed with before it was opened does not count for what pushes then. */
TEST(pushed_beside_an_open_belt)
{
    char *const text = case_of(SLOPE);
    const char *const settings[] = {
        "drive.tail",
        "{table: [[0 s, 1.6 kN], [10 s, 1.6 kN], [16 s, 400 N], [18 s, 400 N], [30 s, 1.6 kN]]}",
        "conveyors",
        "[{name: K, from: 4 m, to: 6 m, clamp: 800 N, mu: 0.3, belt: {speed: 0.12 m/s, to: 4 s}}]",
        "drive.script",
        "[{at: 7 s, do: conveyor_clamp, of: K, clamp: 0 N, ramp: 1 s}]",
        NULL};
    hawser_sim *const sim = run_of(text, settings);
    const hawser_limit l = run_limit(sim, "run_away");
    print_message("pushed with %.1f N\n", l.value);
    assert_true(l.judged && !l.ok);
    check_share(l.value, 194, 0.1); /* as without a belt */
    hawser_sim_free(sim);
    free(text);
}

/* Friction creeps while nothing is drawn, and a cable that it holds on a slope comes to lie on its foot, also where the
 * winch starts late; with the friction of what moves it is taut again. */
TEST(at_rest_on_a_slope)
{
    char *const text = case_of(SLOPE);
    static const char *const row[][2] = {
        {"drive.script", "[{at: 8 s, do: winch_pause, ramp: 1 s}, {at: 30 s, do: winch_restart, ramp: 2 s}]"},
        {"drive.winch.from", "12 s"}};
    for (int k = 0; k < 2; k++) {
        hawser_sim *const sim =
            run_of(text, (const char *const[]){"route.pieces.1.slope", "-8 deg", "drive.tail.tension", "100 N",
                                               "drive.winch.to", k ? "16 s" : "4 s", row[k][0], row[k][1], NULL});
        const hawser_limit l = run_limit(sim, "run_away");
        print_message("%s: pushed with %.1f N\n", row[k][0], l.value);
        assert_true(l.judged && l.ok);
        hawser_sim_free(sim);
    }
    free(text);
}

/* A winch that stops at once, and belts that push what is ahead of them, are no run-away. */
TEST(pushed_by_what_is_there)
{
    char *const text = case_of("lead_in: {}\nchain: [{cable: c, length: 12 m, segment: 500 mm}]\n"
                               "route: {head_at: 11 m, pieces: [{straight: 14 m}]}\nrollers: {along: {spacing: 1 m}}\n"
                               "drive: {winch: {speed: 0.2 m/s, to: 1 s}, tail: {tension: 100 N, ramp: none}}\n"
                               "run: {duration: 5 s, steady_from: 3 s}\n");
    static const char *const row[][2] = {
        {"drive.script", "[{at: 2 s, do: winch_pause, ramp: 2 ms}, {at: 3 s, do: winch_restart}]"},
        {"conveyors", "[{name: K, from: 4.2 m, to: 5.8 m, clamp: 2 kN, mu: 0.3, belt: {speed: 0.25 m/s, to: 1 s}}]"}};
    for (int k = 0; k < 2; k++) {
        hawser_sim *const sim = run_of(text, (const char *const[]){row[k][0], row[k][1], NULL});
        const hawser_limit l = run_limit(sim, "run_away");
        print_message("%s: %g N\n", row[k][0], l.value);
        assert_true(l.judged && l.ok);
        hawser_sim_free(sim);
    }
    free(text);
}

/* ------------------------------------------------------------------------------------- where the front came to */

/* Rollers that are braked ahead of where the front began: the overload there, 1 + (mu' - mu) w l/T, and the trip that
 * is advised are told by theory up to where the front came to. */
TEST(as_far_as_the_front_came)
{
    char *const text = case_of(
        "lead_in: {}\n"
        "chain: [{cable: c, length: 20 m, segment: 450 mm}, {cable: rope, length: 20 m, segment: 450 mm, swivel: "
        "true}]\n"
        "route: {head_at: 5 m, pieces: [{straight: 25 m}]}\n"
        "rollers: {along: [{from: 0 m, to: 10.5 m, spacing: 1 m, name: A}, {from: 11 m, to: 25 m, spacing: 1 m, name: "
        "B, friction: {mu: 0.8}}]}\n"
        "drive: {winch: {speed: 0.25 m/s, to: 4 s}, tail: {tension: 300 N, ramp: none}}\n"
        "run: {duration: 50 s, steady_from: 40 s}\n");
    hawser_sim *const sim = run_of(text, NULL);
    hawser_summary sum;
    char *json = NULL;
    const hawser_limit alpha = run_limit(sim, "alpha");
    const double w = 14 * 9.81, far = 5 + 0.25 * 48, behind = 300 + 0.2 * w * 10.5, rope = 0.2 * 0.9 * 9.81;
    assert_true(alpha.judged && !alpha.ok);
    assert_int_equal(alpha.where[0], 'B');
    const double real = behind + 0.8 * w * (far - 10.5), theory = behind + 0.2 * w * (far - 10.5);
    print_message("alpha %.3f at %s; %.3f at the front\n", alpha.value, alpha.where, real / theory);
    check_share(alpha.value, real / theory, 0.08);
    assert_int_equal(hawser_sim_summary_json(sim, &json, NULL), HAWSER_OK);
    json_t *const all = json_loads(json, 0, NULL);
    check_share(number_of(json_object_get(all, "overload"), "trip_N"), 1.5 * (theory + rope * (25 - far)), 1e-3);
    json_decref(all);
    hawser_text_free(json);
    hawser_sim_summary(sim, &sum);
    /* which is counted up to where it began, with the 20 m of rope */
    check_share(sum.reference_total_N, 300 + 0.2 * w * 5 + 20 * rope, 0.01);
    hawser_sim_free(sim);
    free(text);
}

/* A cable whose tail has come in lies between its tail and its front alone: theory had it all along the route. */
TEST(as_far_back_as_the_tail_is)
{
    char *const text = case_of(
        "lead_in: {}\n"
        "chain: [{cable: c, length: 8 m, segment: 450 mm}, {cable: rope, length: 30 m, segment: 450 mm, swivel: "
        "true}]\n"
        "route: {head_at: 5 m, pieces: [{straight: 35 m}]}\n"
        "rollers: {along: [{from: 0 m, to: 20.5 m, spacing: 1 m, name: A}, {from: 21 m, to: 35 m, spacing: 1 m, name: "
        "B, friction: {mu: 0.8}}]}\n"
        "drive: {winch: {speed: 0.5 m/s, to: 4 s}, tail: {tension: 100 N, ramp: none}}\n"
        "run: {duration: 53 s, steady_from: 48 s}\n");
    static const char *const even[] = {"rollers", "{along: [{from: 0 m, to: 35 m, spacing: 1 m, name: A}]}", NULL};
    const double w = 14 * 9.81;
    hawser_sim *sim = run_of(text, NULL);
    const hawser_limit braked = run_limit(sim, "alpha");
    print_message("alpha %.3f at %s\n", braked.value, braked.where);
    check_share(braked.value, (100 + 0.8 * w * 8) / (100 + 0.2 * w * 8), 0.12); /* 8 m of cable on them */
    hawser_sim_free(sim);
    sim = run_of(text, even);
    const hawser_limit alpha = run_limit(sim, "alpha");
    const hawser_position *row;
    const int n = hawser_sim_positions(sim, &row);
    print_message("alpha %.3f at %s\n", alpha.value, alpha.where);
    check_below(alpha.value, 1.2);
    for (int i = 0; i < n; i++) {
        const double head = row[i].head_m, cable = fmin(head, 8);
        if (head > 9 || head < 7)
            check_share(row[i].reference_N, 100 + 0.2 * 9.81 * (14 * cable + 0.9 * fmin(35 - head, 30)), 2e-3);
    }
    hawser_sim_free(sim);
    free(text);
}

/* Without a lead-in, too, a roller's peak is told by theory of that moment, when the front or the tail was elsewhere.
 */
TEST(a_cable_that_passes_by)
{
    char *const text = case_of(
        "chain: [{cable: c, length: 4.95 m, segment: 450 mm}, {cable: rope, length: 30 m, segment: 450 mm}]\n"
        "route: {head_at: 5 m, pieces: [{straight: 35 m}]}\nrollers: {along: [{spacing: 1 m, name: A}]}\n"
        "drive: {winch: {speed: 0.3 m/s, to: 4 s}, tail: {tension: 100 N, ramp: none}}\nrun: {duration: 70 s}\n");
    hawser_sim *const sim = run_of(text, NULL);
    const hawser_limit alpha = run_limit(sim, "alpha");
    print_message("alpha %.3f at %s\n", alpha.value, alpha.where);
    check_below(alpha.value, 1.2);
    hawser_sim_free(sim);
    free(text);
}

/* 32 m of rope at 70 degrees ahead of the front take their weight, less friction, off the winch: a trip that protects
 * the cable is by that much nearer, also of a run whose front never comes to the shaft, and of one that has passed it.
 */
TEST(rope_that_hangs_down_in_a_run)
{
    char *const text = case_of(
        "chain: [{cable: c, length: 8 m, segment: 500 mm}, {cable: rope, length: 52 m, segment: 500 mm, swivel: "
        "true}]\n"
        "route: {head_at: 8.5 m, transition_radius: 4 m, pieces: [{straight: 14 m}, {straight: 32 m, slope: -70 deg}, "
        "{straight: 14 m, slope: 0 deg}]}\n"
        "surfaces: {ducts: [{name: duct, radius: 60 mm, place: resting}]}\n"
        "drive: {winch: {speed: 0.1 m/s, to: 2 s, trip: {force: 1.9 kN}}, tail: {tension: 1.6 kN, ramp: none}}\n"
        "run: {duration: 8 s, steady_from: 4 s}\n");
    const char *const settings[] = {"cables.rope.mass", "4 kg/m", "friction.mu", "0.05", "limits.pull", "2 kN", NULL};
    hawser_sim *const sim = run_of(text, settings);
    const hawser_limit trip = run_limit(sim, "trip");
    print_message("the trip may be %.1f N\n", trip.limit);
    assert_true(trip.judged && !trip.ok);
    /* the transitions of 4 m have some of the fall, and rope on the level ahead brakes a little */
    check_share(2000 - trip.limit, 4 * 9.81 * 32 * (sin(70 * M_PI / 180) - 0.05 * cos(70 * M_PI / 180)), 0.06);
    hawser_sim_free(sim);
    free(text);
}

/* Positions by whole segments have joints at the same places all along: a short bend between them presses, too. */
TEST(a_bend_between_joints)
{
    static const char *const head[] = {"21.4 m", "21.6 m", "21.9 m"};
    double found[3];
    char *const text = case_of(
        "lead_in: {}\nchain: [{cable: c, length: 40 m, segment: 500 mm}, {cable: rope, length: 20 m, segment: 500 mm, "
        "swivel: true}]\n"
        "route: {head_at: 21.6 m, pieces: [{straight: 8.2 m}, {bend: 5 deg, radius: 2 m, plane: down}, {straight: 30 "
        "m}]}\n"
        "rollers: {along: [{spacing: 0.9 m, radius: 60 mm}]}\n"
        "drive: {winch: {speed: 0.1 m/s, to: 2 s}, tail: {tension: 7 kN, ramp: none}}\n"
        "run: {duration: 30 s, analysis: positions}\nsolver: {passes: 1}\n");
    for (int k = 0; k < 3; k++) {
        hawser_sim *const sim = run_of(text, (const char *const[]){"cables.c.d", "40 mm", "cables.c.EI", "0.3 kN m2",
                                                                   "route.head_at", head[k], NULL});
        const hawser_limit l = run_limit(sim, "sidewall");
        found[k] = l.value;
        assert_true(l.judged && !l.ok);
        hawser_sim_free(sim);
    }
    print_message("%.1f, %.1f, %.1f N/m\n", found[0], found[1], found[2]);
    check_share(found[0], found[1], 0.02);
    check_share(found[2], found[1], 0.02);
    free(text);
}

/* A belt that the front has not reached pushes nothing: theory by the front's position has a step there. */
TEST(belts_from_where_they_stand)
{
    char *const text =
        case_of("lead_in: {}\n"
                "chain: [{cable: c, length: 20 m, segment: 450 mm}, {cable: rope, length: 20 m, segment: 450 mm}]\n"
                "route: {head_at: 5 m, pieces: [{straight: 25 m}]}\nrollers: {along: {spacing: 1 m}}\n"
                "conveyors: [{name: K, from: 9.2 m, to: 10.8 m, clamp: 1 kN, mu: 0.2, factor: 1.1, hold: false}]\n"
                "drive: {winch: {speed: 0.25 m/s, to: 4 s}, tail: {tension: 1 kN, ramp: none}}\n"
                "run: {duration: 50 s, steady_from: 5 s}\n");
    hawser_sim *const sim = run_of(text, NULL);
    const hawser_position *row;
    const int n = hawser_sim_positions(sim, &row);
    int before = 0, behind = 0;
    for (int i = 0; i < n; i++) {
        const double head = row[i].head_m, alone = 1000 + 0.2 * 9.81 * (14 * head + 0.9 * (25 - head));
        if (head < 8) check_share(row[i].reference_N, alone, 1e-3);
        if (head > 12) check_share(row[i].reference_N, alone - 400, 1e-3);
        before += head < 8;
        behind += head > 12;
    }
    assert_true(before > 0 && behind > 0);
    hawser_sim_free(sim);
    free(text);
}

/* -------------------------------------------------------------------------------------------------- shared pulls */

/* NAN: not asked. */
static double shared(const char *text, const char *const *settings, char remedy[200])
{
    hawser_summary sum;
    hawser_sim *const sim = run_of(text, settings);
    double found = NAN;
    hawser_sim_summary(sim, &sum);
    for (int i = 0; i < sum.n_conditions; i++) {
        if (strcmp(sum.conditions[i].name, "shared")) continue;
        found = sum.conditions[i].value;
        snprintf(remedy, 200, "%s", sum.conditions[i].remedy);
    }
    hawser_sim_free(sim);
    return found;
}

/* A belt of its own speed, the winch's, that the front reaches within the steady window: it does not
 * slip while there is no cable in it. One that is faster slips all through, and decides what it pushes with. */
TEST(a_belt_that_is_reached_late)
{
    char remedy[200] = "";
    char *const text =
        case_of("chain: [{cable: c, length: 12 m, segment: 450 mm}, {cable: rope, length: 8 m, segment: 450 mm}]\n"
                "route: {head_at: 12.5 m, pieces: [{straight: 24 m}]}\nrollers: {along: {spacing: 1 m}}\n"
                "drive: {winch: {speed: 0.25 m/s, to: 1 s}, tail: {tension: 300 N, ramp: none}}\n"
                "run: {duration: 12 s, steady_from: 4 s}\n");
    static const struct {
        const char *speed;
        int shares;
    } row[] = {{"0.25 m/s", 1}, {"0.29 m/s", 0}};
    for (int k = 0; k < 2; k++) {
        char belts[200];
        snprintf(belts, sizeof belts,
                 "[{name: K, from: 13.2 m, to: 14.3 m, clamp: 1 kN, hold: false, belt: {speed: %s, to: 1 s}}]",
                 row[k].speed);
        const double found = shared(text, (const char *const[]){"conveyors", belts, NULL}, remedy);
        print_message("%s: %g\n", row[k].speed, found);
        assert_int_equal(isnan(found), !row[k].shares);
        if (row[k].shares) check_has(remedy, "conveyor 'K' and the winch");
    }
    free(text);
}

/* A synchronised belt that holds back, at the wrong end of its limit, may push twice that more; and a winch that a
 * script has made faster has drawn farther. (WI23): 0.1 mm over l/EA of what lies between. */
TEST(a_belt_that_holds_back)
{
    char remedy[200] = "";
    char *const text = case_of(
        "lead_in: {}\nchain: [{cable: c, length: 45 m, segment: 450 mm}]\n"
        "route: {head_at: 38 m, pieces: [{straight: 12 m}, {bend: 60 deg, radius: 5 m, plane: left}, {straight: 25 "
        "m}]}\n"
        "surfaces: {ducts: [{name: d1, from: 0 m, to: 4 m, radius: 60 mm, place: resting}, {name: d2, from: 6.5 m, "
        "radius: 60 mm, place: resting}]}\n"
        "conveyors: [{name: K, from: 4.2 m, to: 6.2 m, clamp: 3 kN, mu: 0.3, limit: 400 N}]\n"
        "drive: {winch: {speed: 0.1 m/s, to: 2 s}, tail: {table: [[0 s, 1.9 kN], [5 s, 1.9 kN], [6 s, 1 kN]]}}\n"
        "run: {duration: 16 s, steady_from: 10 s}\nsolver: {passes: 1}\n");
    const double back = shared(text, NULL, remedy);
    const double forth = shared(text, (const char *const[]){"drive.tail", "{tension: 1 kN, ramp: none}", NULL}, remedy);
    print_message("%g, %g\n", back, forth);
    check_share(back, 1e-4 * 100e6 / (38 + 1.5 - 5.2) / 2735, 0.05);
    check_below(forth, 0.02);
    free(text);
}

/* Two belts of one speed without a winch: c = l/EA of the 6 m between them. Where one is faster it slips. */
TEST(belts_among_themselves)
{
    char remedy[200] = "";
    char *const text = case_of("chain: [{cable: c, length: 14 m, segment: 450 mm}]\nlead_in: {}\n"
                               "route: {head_at: 12 m, pieces: [{straight: 16 m}]}\nrollers: {along: {spacing: 1 m}}\n"
                               "drive: {tail: {tension: 1 kN, to: 500 ms}}\nrun: {duration: 3 s, steady_from: 2 s}\n");
    static const struct {
        const char *speed;
        int shares;
    } row[] = {{"0.1 m/s", 1}, {"0.13 m/s", 0}};
    for (int k = 0; k < 2; k++) {
        char belts[400];
        snprintf(belts, sizeof belts,
                 "[{name: K, from: 3.2 m, to: 4.8 m, clamp: 2 kN, hold: false, belt: {speed: 0.1 m/s, to: 1 s}}, "
                 "{name: L, from: 9.2 m, to: 10.8 m, clamp: 2 kN, hold: false, belt: {speed: %s, to: 1 s}}]",
                 row[k].speed);
        const double found = shared(text, (const char *const[]){"conveyors", belts, NULL}, remedy);
        print_message("%s: %g\n", row[k].speed, found);
        assert_int_equal(isnan(found), !row[k].shares);
        if (row[k].shares) check_has(remedy, "conveyor 'K' and conveyor 'L'");
        if (row[k].shares) check_share(found, 1e-4 * 100e6 / 6 / 1594, 0.05); /* L pushes with 1594 N */
    }
    free(text);
}

/* Behind a bend that takes most of a belt's push a slope pushes as it does without the belt, 124 N: no push of the
 * belt's, though it has more. */
TEST(a_slope_behind_a_belt)
{
    char *const text = case_of(
        "lead_in: {}\nchain: [{cable: c, length: 95 m, segment: 500 mm}, {cable: rope, length: 12 m, segment: 500 "
        "mm}]\n"
        "route: {head_at: 82 m, transition_radius: 10 m, pieces: [{straight: 6 m}, {bend: 180 deg, radius: 5 m, plane: "
        "left}, {straight: 30 m, slope: -30 deg}, {straight: 45 m, slope: 0 deg}]}\n"
        "surfaces: {ducts: [{name: duct, radius: 60 mm, place: resting}]}\n"
        "conveyors: [{name: K, from: 2 m, to: 4 m, clamp: 8 kN, mu: 0.3, limit: 2.4 kN, belt: {speed: 0.12 m/s, to: 2 "
        "s}}]\ndrive: {winch: {speed: 0.1 m/s, to: 2 s}, tail: {tension: 100 N, ramp: none}}\n"
        "run: {duration: 4 s, steady_from: 3 s}\nsolver: {passes: 1}\n");
    for (int k = 0; k < 2; k++) {
        hawser_sim *const sim = run_of(text, (const char *const[]){"drive.tail.tension", k ? "700 N" : "100 N", NULL});
        const hawser_limit l = run_limit(sim, "run_away");
        print_message("%g N\n", l.value);
        assert_int_equal(l.ok, k);
        if (!k) check_between(l.value, 60, 200);
        hawser_sim_free(sim);
    }
    free(text);
}
