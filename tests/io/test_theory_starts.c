/* Where the pull begins: theory is about the whole of it, with whatever holds the cable back at any time. */
#include "tests/io/theory_fixture.h"

/* One number of the answer. */
static double figure(const char *text, const char *const *settings, const char *key)
{
    json_t *const all = theory_of(text, settings);
    const double value = number_of(all, key);
    json_decref(all);
    return value;
}

/* The forward verdict must begin so. */
static void verdict_is(const char *text, const char *const *settings, const char *begins)
{
    json_t *const all = theory_of(text, settings);
    const char *const says = json_string_value(json_object_get(all, "verdict_forward"));
    if (strncmp(says, begins, strlen(begins)) != 0) fail_msg("not %s: %s", begins, says);
    json_decref(all);
}

/* ------------------------------------------------------------------------------------------------ the reel */

/* 125 m of 150 are off the drum with the front at the end, 120 m: 25 m are left on it. */
static const char on_a_reel[] =
    "cables: {c: {d: 80 mm, mass: 20 kg/m, EA: 57 MN, GA: 20 MN, GJ: 10 kN m2, EI: 2 kN m2}}\n"
    "chain: [{cable: c, length: 150 m}]\n"
    "route: {pieces: [{straight: 120 m}], head_at: 5 m}\n"
    "friction: {mu: 0.2}\n"
    "rollers: {along: {spacing: 1 m, rating: 20 kN}}\n"
    "drive: {winch: {speed: 0.5 m/s, ramp: step, to: 2 s}}\n"
    "reel: {distance: 5 m, barrel: 0.8 m, flange: 3 m, width: 0.35 m, inertia: 90 kg m2, brake: {law: constant, "
    "torque: 6 kN m}}\n"
    "run: {duration: 20 s}\n"
    "limits: {pull: 14.5 kN, sidewall: 3 kN/m, bend_radius: 1 m, speed: 1 m/s}\n";

/* Behind 70 m on the level a slope that friction does not hold on. */
static const char slope[] =
    "{pieces: [{straight: 70 m}, {straight: 50 m, slope: -60 deg}], transition_radius: 5 m, head_at: 5 m}";

/* Four turns in a layer, of 0.44 m, 0.52 m, ...: layers end at 11.06 and 24.13 m, so that 25 m are just on the third,
 * which the cable climbs to in its first turn. Friction is 0.2 x 20 x 9.81 x 120. */
TEST(the_drum_at_its_smallest)
{
    const double turn = 2 * M_PI * 0.6, below = 2 * M_PI * 4 * (2 * 0.4 + 2 * 0.08),
                 radius = 0.52 + 0.08 * (25 - below) / turn;
    const double start = 6000 / radius, pull = start + 0.2 * 20 * 9.81 * 120;
    static const char *const duration[] = {"20 s", "60 s", "400 s"}; /* how long it is run is nothing to theory */
    for (int k = 0; k < 3; k++) {
        const char *const settings[] = {"run.duration", duration[k], NULL};
        check_share(figure(on_a_reel, settings, "start_tension_N"), start, 1e-6);
        check_share(figure(on_a_reel, settings, "reference_total_N"), pull, 1e-6);
        verdict_is(on_a_reel, settings, "NOT SAFE: 2 of 7 limits broken: pull by");
    }
}

/* A cable that leaves the drum on the way was held by the bare barrel just before, and by nothing after that. */
TEST(a_cable_that_leaves_the_drum)
{
    const char *const level[] = {"chain.0.length", "60 m", "run.duration", "400 s", NULL};
    check_share(figure(on_a_reel, level, "start_tension_N"), 6000 / 0.44, 1e-6);
    verdict_is(on_a_reel, (const char *const[]){"route", slope, "chain.0.length", "60 m", NULL},
               "NOT TRUSTED: the cable would run away");
    verdict_is(on_a_reel,
               (const char *const[]){"route", slope, "limits",
                                     "{pull: 50 kN, sidewall: 9 kN/m, bend_radius: 1 m, speed: 1 m/s}", NULL},
               "SAFE");
}

/* What the crew sets the brake to counts as well: the most for the tension, the least for what it holds. */
TEST(a_brake_by_the_script)
{
    const char *const more[] = {"drive.script", "[{at: 8 s, do: reel_brake, torque: 12 kN m, ramp: 3 s}]", NULL};
    const char *const less[] = {"drive.script", "[{at: 8 s, do: reel_brake, torque: 1 kN m, ramp: 3 s}]", NULL};
    const double usual = figure(on_a_reel, NULL, "start_tension_N");
    check_share(figure(on_a_reel, more, "start_tension_N"), 2 * usual, 1e-9);
    check_share(figure(on_a_reel, less, "start_tension_N"), usual, 1e-9);
    verdict_is(on_a_reel, (const char *const[]){"route", slope, less[0], less[1], NULL},
               "NOT TRUSTED: the cable would run away");
}

/* ---------------------------------------------------------------------------------------- cable behind the start */

static const char behind[] = "cables: {c: {d: 80 mm, mass: 20 kg/m, E: 11.5 GPa, G: 4.15 GPa, A: 5000 mm2}}\n"
                             "chain: [{cable: c, length: 150 m}]\n"
                             "route: {pieces: [{straight: 60 m}], head_at: 50 m}\n"
                             "friction: {mu: 0.2, mu_s: 0.3}\n"
                             "rollers: {along: [{from: -120 m, to: 60 m, spacing: 1 m}]}\n"
                             "run: {duration: 15 s}\n"
                             "drive: {winch: {speed: 0.1 m/s, ramp: step, to: 2 s}}\n"
                             "limits: {pull: 9 kN, sidewall: 30 kN/m, bend_radius: 1 m, speed: 1 m/s}\n";

/* 100 m lie there at first on the same rollers: mu w of each, more from rest. Where nothing lies that would carry them
 * they are no part of the pull. Pulled the other way it begins without them. */
TEST(cable_behind_with_friction)
{
    const double metre = 0.2 * 20 * 9.81;
    json_t *const all = theory_of(behind, NULL);
    check_share(number_of(all, "start_tension_N"), 100 * metre, 1e-9);
    check_share(number_of(all, "reference_total_N"), 160 * metre, 1e-9);
    check_share(number_of(all, "backward_total_N"), 60 * metre, 1e-9);
    json_decref(all);
    verdict_is(behind, NULL, "NOT SAFE: 1 of 6 limits broken: restart by 4.64 %");
    verdict_is(behind, (const char *const[]){"limits.pull", "9.5 kN", NULL}, "SAFE");
    const char *const hangs[] = {"rollers", "{along: [{from: 0 m, to: 60 m, spacing: 1 m}]}", NULL};
    assert_true(figure(behind, hangs, "start_tension_N") == 0);
}

/* A track without friction that leaves the cable its weight along the slope, uphill and downhill: of the 60 m that lie
 * there at first, or of the 40 m that do at the end. */
TEST(cable_behind_with_weight)
{
    static const char *const rise[] = {"20 deg", "-20 deg"}, *const weight[] = {"{weight: full}", "{weight: carried}"};
    const double metre = 20 * 9.81 * sin(20 * M_PI / 180);
    const double start[2][2] = {{60 * metre, 0}, {fmax(0, -40 * metre), 0}};
    for (int k = 0; k < 4; k++) {
        const char *const settings[] = {"chain.0.length",
                                        "100 m",
                                        "route.head_at",
                                        "40 m",
                                        "route.slope",
                                        rise[k / 2],
                                        "lead_in",
                                        weight[k % 2],
                                        "drive.tail",
                                        "{tension: 10 kN, ramp: none}",
                                        NULL};
        const double back = 10e3 + (k == 2 ? -40 * metre : start[k / 2][k % 2]);
        check_share(figure(behind, settings, "start_tension_N"), back, 1e-9);
    }
}

/* The run's own theory has it too, and the run pulls that. */
TEST(a_run_with_weight_behind)
{
    const char *const settings[] = {"chain",
                                    "[{cable: c, length: 12 m, segment: 500 mm}]",
                                    "route",
                                    "{slope: 20 deg, pieces: [{straight: 8 m}], head_at: 5 m}",
                                    "rollers",
                                    "{along: [{spacing: 500 mm}]}",
                                    "lead_in",
                                    "{weight: full}",
                                    "drive.winch",
                                    "{speed: 0.2 m/s, ramp: step, to: 1 s}",
                                    "run.duration",
                                    "6 s",
                                    NULL};
    hawser_summary sum;
    hawser_sim *const sim = run_of(behind, settings);
    hawser_sim_summary(sim, &sum);
    check_share(sum.pull_mean_N, sum.reference_total_N, 0.03);
    hawser_sim_free(sim);
}

/* ------------------------------------------------------------------------------------------------ unlike weights */

/* 50 m on the level, 40 m down at 30 degrees, 30 m on the level. What is heavy there runs ahead; it is not held by 50 m
 * of the same behind it if these are of a light cable. */
TEST(a_light_cable_holds_less)
{
    static const char text[] =
        "cables: {heavy: {d: 80 mm, mass: 30 kg/m, E: 11.5 GPa, G: 4.15 GPa, A: 5000 mm2, EI: 90 N m2}, light: {d: 80 "
        "mm, mass: "
        "3 kg/m, E: 11.5 GPa, G: 4.15 GPa, A: 5000 mm2, EI: 90 N m2}}\n"
        "chain: [{cable: light, length: 60 m}, {cable: heavy, length: 60 m, rope: false}]\n"
        "route: {head_at: 110 m, pieces: [{straight: 50 m, slope: 0 deg}, {straight: 40 m, slope: -30 deg}, {straight: "
        "30 m, slope: 0 deg}], transition_radius: 5 m}\n"
        "friction: {mu: 0.25}\n"
        "surfaces: {ducts: [{radius: 80 mm}]}\n"
        "drive: {winch: {speed: 0.1 m/s, ramp: step, to: 2 s}}\n"
        "limits: {pull: 12 kN, sidewall: 30 kN/m, bend_radius: 1 m, speed: 1 m/s}\n";
    const double held = 0.25 * 3 * 9.81 * 50, runs = 30 * 9.81 * 40 * (0.5 - 0.25 * cos(M_PI / 6));
    const char *const alike[] = {"chain.0.cable", "heavy", NULL};
    verdict_is(text, alike, "SAFE");
    verdict_is(text, NULL, "NOT TRUSTED: the cable would run away");
    json_t *const all = theory_of(text, NULL);
    const json_t *const there = json_array_get(json_object_get(all, "directions"), 0);
    check_share(number_of(there, "min_tension_N"), held - runs, 0.1); /* the changes of slope are arcs */
    json_decref(all);
    const char *const braked[] = {"drive.tail", "{tension: 3 kN, ramp: none}", NULL}; /* and a tenth more */
    verdict_is(text, braked, "SAFE");
}

/* Friction that the script raises is none that theory knows; one that it lowers only takes off. */
TEST(friction_by_the_script)
{
    const char *const more[] = {"limits.pull", "20 kN", "drive.script", "[{at: 5 s, do: friction, factor: 3}]", NULL};
    const char *const less[] = {"limits.pull", "20 kN", "drive.script", "[{at: 5 s, do: friction, factor: 0.5}]", NULL};
    verdict_is(behind, more, "NOT TRUSTED: drive.script makes friction 3 times the case's");
    verdict_is(behind, less, "SAFE");
}
