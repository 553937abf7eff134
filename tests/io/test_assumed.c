/* Values that a case does not give: their ranges, the unfavourable end, the bound up to which all limits hold. The old
 * verdict stands beside each: a silent default decided it. */
#include <stdio.h>

#include "tests/io/theory_fixture.h"

/* A duct of 400 m: T = T0 + mu w L, so that every bound has a closed form. 10 kg/m; 8 kN are allowed, no rope. */
static const char CASE[] = "cables: {c: {EA: 10 MN, GA: 4 MN, GJ: 100 N m2, EI: 50 N m2, d: 50 mm, mass: 10 kg/m}}\n"
                           "chain: [{cable: c, length: 400 m}]\nroute: {pieces: [{straight: 400 m}]}\n"
                           "surfaces: {ducts: [{radius: 80 mm}]}\nlimits: {pull: 8 kN, sidewall: 3 kN/m}\n";
static const double W = 10 * 9.81, LENGTH = 400;

static json_t *with(const char *lines)
{
    char text[2000];
    snprintf(text, sizeof text, "%s%s", CASE, lines);
    return theory_of(text, NULL);
}

static const json_t *limit_in(const json_t *answer, const char *name)
{
    const json_t *limit;
    size_t i;
    json_array_foreach(json_object_get(answer, "limits"), i,
                       limit) if (!strcmp(json_string_value(json_object_get(limit, "name")), name)) return limit;
    fail_msg("no limit %s", name);
    return NULL;
}

static const char *code_of(const json_t *answer) { return json_string_value(json_object_get(answer, "verdict_code")); }

/* Once 0.2 was taken without a word and the pull was SAFE with 1.9 % left. */
TEST(friction_of_nobody)
{
    char bound[80];
    json_t *const o = with("drive: {tail: {tension: 0 N}}\n");
    assert_string_equal(code_of(o), "not_judged");
    snprintf(bound, sizeof bound, "NOT JUDGED: pull: friction is not given (friction.mu): up to %.3g would do",
             floor(1e3 * 8000 / (W * LENGTH)) / 1e3);
    verdict_has(o, bound);
    assert_false(json_is_true(json_object_get(limit_in(o, "pull"), "ok")));
    json_decref(o);
    /* with a millionth of the friction it is broken too: that does not depend on what is assumed */
    json_t *const broken = with("drive: {tail: {tension: 9 kN}}\n");
    assert_string_equal(code_of(broken), "not_safe");
    json_decref(broken);
}

/* Once the restart was judged with the friction in motion: SAFE. */
TEST(friction_at_rest)
{
    json_t *o = with("friction: {mu: 0.15}\ndrive: {tail: {tension: 0 N}}\n");
    const double most = 8000 / (W * LENGTH);
    assert_string_equal(code_of(o), "safe_if");
    verdict_has(o, "SAFE ONLY IF friction at rest <= 0.203 (restart): all ");
    check_share(number_of(limit_in(o, "restart"), "friction_at_rest_most"), most, 1e-3);
    check_share(number_of(limit_in(o, "restart"), "worst"), 1.5 * 0.15 * W * LENGTH, 1e-9);
    check_share(number_of(limit_in(o, "restart"), "value"), 0.15 * W * LENGTH, 1e-9);
    check_share(number_of(limit_in(o, "pull"), "worst"), 0.15 * W * LENGTH, 1e-9);
    json_decref(o);
    o = with("friction: {mu: 0.15, mu_s: 0.15}\ndrive: {tail: {tension: 0 N}}\n");
    assert_string_equal(code_of(o), "safe");
    json_decref(o);
    o = with("friction: {mu: 0.13}\ndrive: {tail: {tension: 0 N}}\n"); /* 1.5 times as much holds */
    assert_string_equal(code_of(o), "safe");
    json_decref(o);
}

/* Once no tail meant 0 N: SAFE. */
TEST(back_tension)
{
    json_t *o = with("friction: {mu: 0.2, mu_s: 0.2}\n");
    const double left = 8000 - 0.2 * W * LENGTH;
    assert_string_equal(code_of(o), "safe_if");
    verdict_has(o, "SAFE ONLY IF back tension <= 151 N (");
    check_close(number_of(limit_in(o, "pull"), "back_tension_most_N"), left, 0.5);
    check_share(number_of(limit_in(o, "pull"), "worst"), 15 * W + 0.2 * W * LENGTH, 1e-9);
    json_decref(o);
    o = with("friction: {mu: 0.2, mu_s: 0.2}\ndrive: {tail: {tension: 0 N}}\n");
    assert_string_equal(code_of(o), "safe");
    json_decref(o);
}

/* An entry of the catalogue is typical, not measured: its range counts. */
TEST(friction_of_the_catalogue)
{
    json_t *const o =
        with("friction: {type: pe-jacket/pe-duct/lubricated, mu_s: 0.25}\ndrive: {tail: {tension: 0 N}}\n");
    const json_t *const pull = limit_in(o, "pull"), *row;
    size_t i;
    double high = NAN;
    json_array_foreach(json_object_get(o, "assumed"), i,
                       row) if (!strcmp(json_string_value(json_object_get(row, "name")), "friction")) high =
        number_of(row, "high");
    check_share(number_of(pull, "worst"), high * W * LENGTH, 1e-9);
    assert_string_equal(json_string_value(json_object_get(pull, "assumed")), "friction");
    json_decref(o);
}

/* Rows of rollers are known to roll; what else the case gives leaves nothing open. */
TEST(nothing_is_open)
{
    json_t *const o = with("friction: {mu: 0.1, mu_s: 0.12}\ndrive: {tail: {tension: 1 kN}}\n");
    assert_string_equal(code_of(o), "safe");
    assert_null(json_object_get(o, "assumed"));
    assert_string_equal(json_string_value(json_object_get(limit_in(o, "pull"), "assumed")), "");
    json_decref(o);
}

/* Each alone the bounds are 0.203 and 936 N, and both together broke the restart by 12 %: they share what is left. */
TEST(two_of_them)
{
    double rest, back;
    json_t *o = with("friction: {mu: 0.18}\n");
    const char *const verdict = json_string_value(json_object_get(o, "verdict_forward"));
    assert_int_equal(
        sscanf(verdict, "SAFE ONLY IF friction at rest <= %lf (restart) and back tension <= %lf N (", &rest, &back), 2);
    assert_string_equal(code_of(o), "safe_if");
    json_decref(o);
    check_between(back + rest * W * LENGTH, 0.995 * 8000, 8000); /* in a straight duct they add up; 3 digits */
    check_share((rest - 0.18) / (8000 / (W * LENGTH) - 0.18), back / (8000 - 0.18 * W * LENGTH), 0.1);
    for (int k = 0; k < 2; k++) {
        char lines[120];
        snprintf(lines, sizeof lines, "friction: {mu_d: 0.18, mu_s: %g}\ndrive: {tail: {tension: %g N}}\n",
                 rest + 0.002 * k, back);
        o = with(lines);
        assert_string_equal(code_of(o), k ? "not_safe" : "safe");
        json_decref(o);
    }
}

/* Once a pit that says nothing of what holds back there had 0 N without a word: SAFE. */
TEST(back_tension_of_a_pit)
{
    json_t *o =
        theory_of(CASE, (const char *const[]){"friction.mu", "0.19", "friction.mu_s", "0.19", "drive.tail.tension",
                                              "0 N", "theory.pits", "[{at: 10 m}]", NULL});
    verdict_has(o, "SAFE ONLY IF back tension <= 7");
    check_close(number_of(limit_in(o, "pull"), "back_tension_most_N"), 8000 - 0.19 * W * (LENGTH - 10), 1);
    assert_string_equal(json_string_value(json_object_get(json_array_get(json_object_get(o, "assumed"), 0), "key")),
                        "theory.pits.0.back");
    json_decref(o);
    o = theory_of(CASE, (const char *const[]){"friction.mu", "0.19", "friction.mu_s", "0.19", "drive.tail.tension",
                                              "0 N", "theory.pits", "[{at: 10 m, back: 500 N}]", NULL});
    assert_string_equal(code_of(o), "safe");
    assert_null(json_object_get(o, "assumed"));
    json_decref(o);
}

static const char ROLLERS[] =
    "cables: {c: {EA: 10 MN, GA: 4 MN, GJ: 100 N m2, EI: 50 N m2, d: 50 mm, mass: 10 kg/m}}\n"
    "route: {pieces: [{straight: 400 m}]}\nrollers: {along: [{from: 0 m, to: 400 m, spacing: 2 m, radius: 100 mm}]}\n"
    "drive: {tail: {tension: 0 N}}\nlimits: {pull: 8 kN, sidewall: 3 kN/m}\n";

/* On rollers alone: their friction is the pull's, given or typical. Once a second line said that it is not known, and
 * nothing was judged. */
TEST(friction_of_rollers)
{
    json_t *o = theory_of(ROLLERS, NULL);
    const json_t *const list = json_object_get(o, "assumed");
    assert_int_equal(json_array_size(list), 2);
    assert_string_equal(json_string_value(json_object_get(json_array_get(list, 0), "source")), "cables on rollers");
    assert_string_equal(code_of(o), "safe_if"); /* at rest 0.3 is too much */
    check_share(number_of(o, "reference_total_N"), 0.2 * W * LENGTH, 1e-9);
    json_decref(o);
    o = theory_of(ROLLERS, (const char *const[]){"rollers.along.0.friction", "{mu: 0.1}", NULL});
    assert_string_equal(code_of(o), "safe");
    check_share(number_of(o, "reference_total_N"), 0.1 * W * LENGTH, 1e-9);
    json_decref(o);
}

/* Friction that a duct has of its own: its key is named, and the case's, which nothing touches, is not assumed. Once
 * "friction.mu_s" was named, and giving it did nothing. */
TEST(friction_of_a_duct)
{
    static const char *const set[] = {
        "surfaces.ducts.0.friction", "{mu: 0.15}", "drive.tail.tension", "0 N", NULL, NULL, NULL};
    json_t *o = theory_of(CASE, set);
    const json_t *const row = json_array_get(json_object_get(o, "assumed"), 0);
    assert_int_equal(json_array_size(json_object_get(o, "assumed")), 1);
    const char *const more[] = {set[0], set[1], set[2], set[3], json_string_value(json_object_get(row, "key")),
                                "0.15", NULL};
    assert_string_equal(more[4], "surfaces.ducts.0.friction.mu_s");
    assert_string_equal(code_of(o), "safe_if");
    json_t *const given = theory_of(CASE, more);
    assert_string_equal(code_of(given), "safe");
    json_decref(given);
    json_decref(o);
}

/* Nothing rubs, so that nothing more rubs from rest: there was 0/0. */
TEST(no_friction)
{
    json_t *const o = with("friction: {mu: 0}\n");
    assert_string_equal(code_of(o), "safe");
    check_share(number_of(limit_in(o, "restart"), "worst"), 15 * W, 1e-9);
    assert_int_equal(json_array_size(json_object_get(o, "assumed")), 1);
    json_decref(o);
}

/* A run's pull grows by the back tension, and with friction at rest not at all in motion. */
TEST(of_a_run)
{
    char text[2000];
    hawser_limit limit[HAWSER_LIMITS_MAX];
    snprintf(text, sizeof text, "%s%s", CASE,
             "friction: {mu: 0.2}\nlead_in: {}\ndrive: {winch: {speed: 0.1 m/s, to: 0.1 s}}\n"
             "run: {duration: 0.2 s, steady_from: 0.1 s}\n");
    hawser_sim *const sim =
        run_of(text, (const char *const[]){"chain.0.length", "10 m", "route.pieces.0.straight", "12 m", "route.head_at",
                                           "10 m", "chain.0.segment", "1 m", "limits.pull", "1 kN", NULL});
    const int n = hawser_sim_limits(sim, limit);
    assert_true(n > 0);
    for (int i = 0; i < n; i++) {
        if (limit[i].kind != HAWSER_LIMIT_PULL) continue;
        assert_true(limit[i].ok);
        check_close(limit[i].worst - limit[i].value, 15 * W, 1e-6);
        check_close(limit[i].back_most, 1000 - limit[i].value, 0.5);
        check_nan(limit[i].friction_most);
    }
    hawser_sim_free(sim);
}

/* A bound is the last value with which the answer is not SAFE ONLY IF but SAFE, or SAFE ONLY IF of something else: the
 * stiffness may end that before a limit is broken. It was 0.341, with which the answer is NOT TRUSTED. */
TEST(stiffness_in_bounds)
{
    static const char text[] = "cables: {power: {type: xlpe-132kv-1000-cu}}\nbundle: {cables: 3}\n"
                               "route: {pieces: [{straight: 100 m}, {bend: 90 deg, radius: 6 m, plane: left}, "
                               "{straight: 50 m}]}\nsurfaces: {ducts: [{radius: 160 mm}]}\nlimits: {code: iec}\n"
                               "drive: {tail: {tension: 0 N}}\n";
    double bound = 0;
    json_t *o = theory_of(text, (const char *const[]){"friction", "{mu: 0.25}", NULL});
    bound = number_of(limit_in(o, "sidewall"), "friction_at_rest_most");
    check_between(bound, 0.33, 0.3395);
    json_decref(o);
    for (int k = 0; k < 2; ++k) {
        char friction[80];
        snprintf(friction, sizeof friction, "{mu_d: 0.25, mu_s: %.6f}", bound + (k ? 1e-3 : -1e-3));
        o = theory_of(text, (const char *const[]){"friction", friction, NULL});
        verdict_has(o, k ? "NOT TRUSTED: the cable's bending stiffness" : "SAFE: all ");
        json_decref(o);
    }
}
