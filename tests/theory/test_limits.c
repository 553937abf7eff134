/* Allowable forces by hand, each limit held and broken, what cannot be judged, and the verdict. */
#include "theory/limits.h"

#include <string.h>

#include "tests/support/check.h"

static LimitsDef given(void)
{
    LimitsDef def;
    limits_defaults(&def);
    def.present = 1;
    return def;
}

/* Eq. 11 and table 4 of the paper, the two columns of TB 889, by hand in N. */
static void allowable_pull(void **state)
{
    (void)state;
    static const struct {
        int code, attachment, material, cores;
        double mm2, K, expected;
    } row[] = {
        {CODE_PAPER, ATTACH_EYE, METAL_COPPER, 1, 800, 1, 56000}, /* the paper's own figure */
        {CODE_PAPER, ATTACH_EYE, METAL_ALUMINIUM, 1, 800, 1, 32000},
        {CODE_PAPER, ATTACH_EYE, METAL_COPPER, 3, 4, 0.6, 504}, /* a control cable */
        {CODE_PAPER, ATTACH_NET, SHEATH_PE, 1, 1200, 1, 8400},
        {CODE_PAPER, ATTACH_NET, SHEATH_XLPE, 1, 1200, 1, 7200},
        {CODE_TB889, ATTACH_EYE, METAL_COPPER, 1, 800, 1, 48000},
        {CODE_TB889, ATTACH_EYE, METAL_ALUMINIUM, 1, 800, 1, 24000},
        {CODE_TB889, ATTACH_EYE, METAL_COPPER, 3, 240, 1, 36000},
        {CODE_TB889, ATTACH_EYE, METAL_ALUMINIUM, 3, 240, 1, 21600},
    };
    char source[160];
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        LimitsDef def = given();
        def.code = row[i].code, def.attachment = row[i].attachment, def.cores = row[i].cores, def.K = row[i].K;
        if (def.attachment == ATTACH_NET) {
            def.sheath = row[i].material, def.sheath_area = row[i].mm2 * 1e-6;
        } else {
            def.metal = row[i].material, def.area = row[i].mm2 * 1e-6;
        }
        check_share(limits_pull(&def, 1, source), row[i].expected, 1e-14);
        check_has(source, def.code == CODE_PAPER ? "table 4" : "TB 889");
        check_close(limits_pull(&def, 3, source), 3 * row[i].expected, 1e-13 * row[i].expected);
    }
}

/* Whatever the codes say can be said otherwise. */
static void overrides(void **state)
{
    (void)state;
    char source[160];
    LimitsDef def = given();
    def.area = 500e-6, def.stress = 55e6;
    check_close(limits_pull(&def, 1, source), 27500, 1e-8);
    check_has(source, "limits.stress");
    def.pull = 12e3;
    check_close(limits_pull(&def, 2, source), 24e3, 1e-9);
    static const double sidewall[] = {3000, 4900, 4400, 500}, factor[] = {20, 12, 20, 20};
    for (int k = 0; k < 4; k++) {
        def.practice = k;
        check_close(limits_sidewall(&def, source), sidewall[k], 0);
        check_close(limits_radius(&def, 0.1, source), factor[k] * 0.1, 1e-12);
    }
    def.sidewall = 1234, def.bend_factor = 15;
    check_close(limits_sidewall(&def, source), 1234, 0);
    check_close(limits_radius(&def, 0.1, source), 1.5, 1e-12);
    def.bend_radius = 2.5;
    check_close(limits_radius(&def, 0.1, source), 2.5, 0);
}

/* Every limit just held and just broken: bounds 100 kN/1.6, 30 kN/5 ... with nothing else in the way. */
static void held_and_broken(void **state)
{
    (void)state;
    LimitsDef def = given();
    def.area = 800e-6, def.rope_strength = 30e3;
    const double bound[LIMIT_KINDS] = {56e3, 56e3, 3000, 1.6, 62500, 100e3, 6000, 1.5, 2.6, 6.35e-3, 0.53};
    for (int broken = 0; broken < 2; broken++) {
        Finding f[LIMIT_KINDS] = {{0}};
        hawser_limit out[HAWSER_LIMITS_MAX];
        for (int k = 0; k < LIMIT_KINDS; k++) {
            const int over = k == LIMIT_BEND || k == LIMIT_CLEARANCE ? !broken : broken;
            f[k].value = bound[k] * (over ? 1.01 : 0.99);
            f[k].rating = 100e3;
            f[k].cables = 1;
            strcpy(f[k].where, "here");
        }
        assert_int_equal(limits_judge(&def, 0.08, 1, f, out), LIMIT_KINDS);
        for (int k = 0; k < LIMIT_KINDS; k++) {
            check_share(out[k].limit, bound[k], 1e-9);
            assert_true(out[k].judged);
            check_equal(out[k].ok, !broken);
            check_close(fabs(out[k].margin), 0.01, 2e-4);
            check_equal(out[k].margin < 0, broken);
            assert_string_equal(out[k].where, "here");
        }
    }
}

static void expect_verdict(int n, const hawser_limit *limit, int broken, const char *expected)
{
    char text[HAWSER_VERDICT_MAX];
    assert_int_equal(hawser_limits_verdict(n, limit, text, sizeof text), broken);
    assert_string_equal(text, expected);
}

static void verdicts(void **state)
{
    (void)state;
    hawser_limit l[3] = {
        {.name = "pull", .unit = "N", .value = 28e3, .limit = 56e3, .margin = 0.5, .judged = 1, .ok = 1},
        {.name = "sidewall",
         .unit = "N/m",
         .value = 2700,
         .limit = 3000,
         .margin = 0.1,
         .judged = 1,
         .ok = 1,
         .where = "12 m"},
        {.name = "rope", .unit = "N"}};
    expect_verdict(0, NULL, -1, "NOT JUDGED: the case has no section 'limits'");
    expect_verdict(1, &l[2], -1, "NOT JUDGED: no limit could be judged");
    expect_verdict(2, l, 0, "SAFE: all 2 limits hold, smallest margin 10 % (sidewall at 12 m)");
    expect_verdict(3, l, 0, "SAFE: all 2 limits hold, smallest margin 10 % (sidewall at 12 m); 1 not judged");
    l[1].value = 3600, l[1].margin = -0.2, l[1].ok = 0;
    expect_verdict(3, l, 1, "NOT SAFE: 1 of 2 limits broken: sidewall by 20 % at 12 m; 1 not judged");
    l[0].value = 84e3, l[0].margin = -0.5, l[0].ok = 0;
    expect_verdict(2, l, 2, "NOT SAFE: 2 of 2 limits broken: pull by 50 %, sidewall by 20 % at 12 m");
    /* a short line is cut, not overrun */
    char text[12];
    hawser_limits_verdict(2, l, text, sizeof text);
    assert_string_equal(text, "NOT SAFE: 2");
}

/* What is not known is said, never passed over as safe. */
static void not_judged(void **state)
{
    (void)state;
    LimitsDef def = given();
    Finding f[LIMIT_KINDS] = {{0}};
    hawser_limit out[HAWSER_LIMITS_MAX];
    f[LIMIT_RESTART].absent = 1;
    f[LIMIT_ALPHA].value = NAN;
    strcpy(f[LIMIT_ALPHA].why, "no rollers");
    f[LIMIT_BEND].value = INFINITY; /* a straight route */
    assert_int_equal(limits_judge(&def, 0.08, 1, f, out), LIMIT_KINDS - 1);
    assert_false(out[0].judged);
    check_has(out[0].source, "limits.conductor.area");
    assert_true(out[2].judged && out[2].ok);
    check_equal(out[2].margin, 1);
    check_has(out[3].source, "no roller has a rating");
    check_has(out[5].source, "rope_strength");
    assert_string_equal(out[6].source, "no rollers");
    assert_false(out[6].judged || out[6].ok);
    def.code = CODE_TB889, def.attachment = ATTACH_NET, def.sheath_area = 1e-3;
    limits_judge(&def, 0.08, 1, f, out);
    assert_false(out[0].judged);
    check_has(out[0].source, "hauling nets");
    def.present = 0;
    assert_int_equal(limits_judge(&def, 0.08, 1, f, out), 0);
}

/* The band in which three cables jam has two ends; the worst duct counts, each limit by itself. */
static void ducts(void **state)
{
    (void)state;
    const LimitsDef def = given();
    const DuctLoad wide = {.jam_risk = JAM_SMALL, .jam_ratio = 3.7, .clearance = 0.02, .fill = 0.3},
                   high = {.jam_risk = JAM_SMALL, .jam_ratio = 3.1, .clearance = 0.03, .fill = 0.2},
                   tight = {.jam_risk = JAM_SMALL, .jam_ratio = 2.3, .clearance = 0.005, .fill = 0.45};
    Finding f[LIMIT_KINDS] = {{0}};
    hawser_limit out[HAWSER_LIMITS_MAX];
    for (int k = 0; k < LIMIT_JAM; k++) f[k].absent = 1;
    limits_duct(&def, 3, NULL, NULL, f);
    assert_int_equal(limits_judge(&def, 0.08, 3, f, out), 0);
    limits_duct(&def, 3, "wide", &wide, f);
    assert_int_equal(limits_judge(&def, 0.08, 3, f, out), 3);
    for (int k = 0; k < 3; k++) assert_true(out[k].ok);
    check_close(out[0].margin, 1 - 3.2 / 3.7, 1e-12);
    limits_duct(&def, 3, "high", &high, f);
    limits_duct(&def, 3, "tight", &tight, f);
    assert_int_equal(limits_judge(&def, 0.08, 3, f, out), 3);
    const double value[] = {3.1, 0.005, 0.45}, limit[] = {3.2, 6.35e-3, 0.4};
    const char *const where[] = {"high", "tight", "tight"};
    for (int k = 0; k < 3; k++) {
        check_close(out[k].value, value[k], 0);
        check_close(out[k].limit, limit[k], 1e-12);
        assert_string_equal(out[k].where, where[k]);
        assert_false(out[k].ok);
    }
    /* two cables do not jam */
    limits_duct(&def, 2, NULL, NULL, f);
    const DuctLoad two = {.jam_ratio = 3.7, .clearance = 0.02, .fill = 0.3};
    limits_duct(&def, 2, "wide", &two, f);
    assert_int_equal(limits_judge(&def, 0.08, 2, f, out), 2);
    check_close(out[1].limit, 0.31, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(allowable_pull),  cmocka_unit_test(ducts),    cmocka_unit_test(overrides),
        cmocka_unit_test(held_and_broken), cmocka_unit_test(verdicts), cmocka_unit_test(not_judged),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
