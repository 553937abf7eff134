/* Where the pull begins: theory is about the whole of it, with whatever holds the cable back there at any time. */
#include "tests/io/case_fixture.h"

#include <jansson.h>

/* Theory's answer to a case so changed; the caller gives it back. */
static json_t *theory_of(const char *text, const char *const *settings)
{
    char *answer = NULL;
    hawser_error err = {0};
    hawser_case *const c = case_with(text, settings);
    if (hawser_case_theory(c, HAWSER_JSON, &answer, &err)) fail_msg("%s", err.message);
    hawser_case_free(c);
    json_t *const all = json_loads(answer, 0, NULL);
    assert_non_null(all);
    hawser_text_free(answer);
    return all;
}

static double number(const json_t *all, const char *key) { return json_number_value(json_object_get(all, key)); }

/* One number of the answer. */
static double figure(const char *text, const char *const *settings, const char *key)
{
    json_t *const all = theory_of(text, settings);
    const double value = number(all, key);
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
static void the_drum_at_its_smallest(void **state)
{
    (void)state;
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
static void a_cable_that_leaves_the_drum(void **state)
{
    (void)state;
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
static void a_brake_by_the_script(void **state)
{
    (void)state;
    const char *const more[] = {"drive.script", "[{at: 8 s, do: reel_brake, torque: 12 kN m, ramp: 3 s}]", NULL};
    const char *const less[] = {"drive.script", "[{at: 8 s, do: reel_brake, torque: 1 kN m, ramp: 3 s}]", NULL};
    const double usual = figure(on_a_reel, NULL, "start_tension_N");
    check_share(figure(on_a_reel, more, "start_tension_N"), 2 * usual, 1e-9);
    check_share(figure(on_a_reel, less, "start_tension_N"), usual, 1e-9);
    verdict_is(on_a_reel, (const char *const[]){"route", slope, less[0], less[1], NULL},
               "NOT TRUSTED: the cable would run away");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_drum_at_its_smallest),
        cmocka_unit_test(a_cable_that_leaves_the_drum),
        cmocka_unit_test(a_brake_by_the_script),
    };
    return cmocka_run_group_tests_name("theory_starts", tests, NULL, NULL);
}
