/* Allowable forces by hand, each limit held and broken, what cannot be judged, and the verdict. */
#include "def/limits.h"

#include <string.h>

#include "tests/support/check.h"

static const double LBF = 4.4482216152605, INCH = 0.0254, FOOT = 0.3048; /* exact: N, m, m */

/* Area of so many circular mils, m2. */
static double cmil(double n) { return n * M_PI / 4 * (INCH / 1000) * (INCH / 1000); }

static LimitsDef given(void)
{
    LimitsDef def;
    limits_defaults(&def);
    def.present = 1;
    return def;
}

/* What is allowed of so many cables of diameter d, m, whatever was found. */
static double allowed(const LimitsDef *def, hawser_limit_kind kind, double d, int cables, char *source)
{
    const Finding none = {0};
    return limits_allowed(def, kind, d, cables, &none, source);
}

/* Eq. 11 and table 4 of the paper, the two columns of TB 889, by hand in N. */
TEST(allowable_pull)
{
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
        check_share(allowed(&def, HAWSER_LIMIT_PULL, 0, 1, source), row[i].expected, 1e-14);
        check_has(source, def.code == CODE_PAPER ? "table 4" : "TB 889");
        /* TB 889 has 50 N/mm2 of copper for three in a triangle (was 3 x 60) */
        const double each =
            def.code == CODE_TB889 && def.metal == METAL_COPPER ? 50e6 * def.area * def.cores : row[i].expected;
        check_close(allowed(&def, HAWSER_LIMIT_PULL, 0, 3, source), 3 * each, 1e-13 * each);
    }
}

/* Whatever the codes say can be said otherwise. */
TEST(overrides)
{
    char source[160];
    LimitsDef def = given();
    def.area = 500e-6, def.stress = 55e6;
    check_close(allowed(&def, HAWSER_LIMIT_PULL, 0, 1, source), 27500, 1e-8);
    check_has(source, "limits.stress");
    check_has(source, "S = 500 mm2");
    def.area = NAN;
    assert_true(isnan(allowed(&def, HAWSER_LIMIT_PULL, 0, 1, source)));
    check_has(source, "needs limits.conductor.area or limits.pull");
    def.own[HAWSER_LIMIT_PULL] = 12e3;
    check_close(allowed(&def, HAWSER_LIMIT_PULL, 0, 2, source), 24e3, 1e-9);
    assert_string_equal(source, "limits.pull");
    def.code = CODE_AEIC;
    for (int cables = 1; cables <= 3; cables++) { /* four fifths of four and more, nothing less of fewer */
        check_close(allowed(&def, HAWSER_LIMIT_PULL, 0, cables, source), cables * 12e3, 1e-9);
        assert_string_equal(source, "limits.pull");
    }
    check_close(allowed(&def, HAWSER_LIMIT_PULL, 0, 4, source), 0.8 * 4 * 12e3, 1e-9);
    check_has(source, "limits.pull; ");
    check_has(source, "80 %");
    def.cores = 5; /* what the code takes off for them is in what is said of one cable */
    check_close(allowed(&def, HAWSER_LIMIT_PULL, 0, 1, source), 12e3, 1e-9);
    assert_string_equal(source, "limits.pull");
    def.code = CODE_PAPER, def.cores = 1;
    /* by the code, Chinese, Fujikura, AEIC's least of 300 lbf/ft, rollers */
    static const double sidewall[] = {3000, 3000, 4900, 300 * LBF / FOOT, 500}, factor[] = {20, 20, 12, 20, 20};
    for (int k = 0; k < 5; k++) {
        def.practice = k;
        check_share(allowed(&def, HAWSER_LIMIT_SIDEWALL, 0, 1, source), sidewall[k], 1e-12);
        check_above(strlen(source), 0);
        check_close(allowed(&def, HAWSER_LIMIT_BEND_RADIUS, 0.1, 1, source), factor[k] * 0.1, 1e-12);
        check_has(source, factor[k] > 15 ? "20 D, D = 100 mm (" : "12 D, D = 100 mm (");
    }
    def.own[HAWSER_LIMIT_SIDEWALL] = 1234, def.bend_factor = 15;
    check_close(allowed(&def, HAWSER_LIMIT_SIDEWALL, 0, 1, source), 1234, 0);
    assert_string_equal(source, "limits.sidewall");
    check_close(allowed(&def, HAWSER_LIMIT_BEND_RADIUS, 0.1, 1, source), 1.5, 1e-12);
    assert_string_equal(source, "15 D, D = 100 mm (limits.bend_factor)");
    def.own[HAWSER_LIMIT_BEND_RADIUS] = 2.5;
    check_close(allowed(&def, HAWSER_LIMIT_BEND_RADIUS, 0.1, 1, source), 2.5, 0);
    assert_string_equal(source, "limits.bend_radius");
}

/* ICEA S-68-516 in makers' manuals (IEWC, Southwire), in pounds by hand: T = 0.008 n cmil of copper, 0.006 of
 * aluminium; four fifths of it above three conductors; 4712 t (D - t) for a lead sheath of thickness t, inches. IEEE
 * 1185 is the same. */
TEST(american_pulls)
{
    static const struct {
        int cables, cores, metal;
        double kcmil, lbf;
    } row[] = {
        {1, 1, METAL_COPPER, 500, 4000},  {1, 1, METAL_ALUMINIUM, 350, 2100},
        {3, 1, METAL_COPPER, 500, 12000}, {1, 3, METAL_COPPER, 133.1, 3194.4},
        {4, 1, METAL_COPPER, 500, 12800}, {1, 4, METAL_ALUMINIUM, 211.6, 4062.72},
    };
    char source[160];
    LimitsDef def = given();
    for (int name = CODE_AEIC; name <= CODE_IEEE1185; name++) {
        for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
            def = given();
            def.code = name, def.metal = row[i].metal, def.cores = row[i].cores, def.area = cmil(1000 * row[i].kcmil);
            check_share(allowed(&def, HAWSER_LIMIT_PULL, 0, row[i].cables, source), row[i].lbf * LBF, 1e-12);
            check_has(source, "ICEA");
        }
    }
    check_has(source, "80 %");
    def = given();
    def.code = CODE_AEIC, def.attachment = ATTACH_NET, def.sheath = SHEATH_LEAD;
    def.sheath_area = M_PI * 0.1 * (2 - 0.1) * INCH * INCH;
    check_share(allowed(&def, HAWSER_LIMIT_PULL, 0, 1, source), 4712 * 0.1 * (2 - 0.1) * LBF,
                1e-4); /* 1500 pi = 4712.4 */
    /* a grip over a plastic sheath: no more than the conductors either */
    def.sheath = SHEATH_PE, def.area = cmil(100e3);
    check_share(allowed(&def, HAWSER_LIMIT_PULL, 0, 1, source), 800 * LBF, 1e-12);
    check_has(source, "under a grip");
}

/* Of eyes and nets: 10 000 lbf (Southwire), 1000 lbf a grip (ICEA), 4.45 kN a grip on metal (TES-P-104.05, 4.2.2 b), or
 * the device's rating if that is less. */
TEST(attachments)
{
    char source[160];
    LimitsDef def = given();
    check_nan(allowed(&def, HAWSER_LIMIT_ATTACHMENT, 0, 1, source)); /* the paper has none */
    check_has(source, "needs limits.attachment_rating");
    def.code = CODE_IEEE1185;
    check_share(allowed(&def, HAWSER_LIMIT_ATTACHMENT, 0, 1, source), 10000 * LBF, 1e-12);
    def.attachment_rating = 60e3;
    check_share(allowed(&def, HAWSER_LIMIT_ATTACHMENT, 0, 1, source), 10000 * LBF, 1e-12);
    def.attachment_rating = 20e3;
    check_close(allowed(&def, HAWSER_LIMIT_ATTACHMENT, 0, 1, source), 20e3, 0);
    assert_string_equal(source, "limits.attachment_rating");
    def.attachment_rating = NAN, def.attachment = ATTACH_NET, def.grips = 3;
    check_share(allowed(&def, HAWSER_LIMIT_ATTACHMENT, 0, 1, source), 3000 * LBF, 1e-12);
    check_has(source, ", 3 of them");
    def.code = CODE_TES, def.grips = 1, def.sheath = SHEATH_ALUMINIUM;
    check_close(allowed(&def, HAWSER_LIMIT_ATTACHMENT, 0, 1, source), 4450, 0);
    def.sheath = SHEATH_LEAD;
    check_nan(allowed(&def, HAWSER_LIMIT_ATTACHMENT, 0, 1, source));
}

/* The swivel bears the whole pull, eyes and nets each its share; a swivel alone breaks the limit, and does not keep it.
 */
TEST(swivel)
{
    char source[160];
    LimitsDef def = given();
    Finding f = {.value = 14e3};
    def.swivel_rating = 15e3;
    check_nan(limits_allowed(&def, HAWSER_LIMIT_ATTACHMENT, 0, 1, &f, source));
    check_has(source, "needs limits.attachment_rating");
    f.value = 16e3;
    check_close(limits_allowed(&def, HAWSER_LIMIT_ATTACHMENT, 0, 1, &f, source), 15e3, 0);
    assert_string_equal(source, "limits.swivel_rating");
    def.attachment_rating = 9e3, def.grips = 2, def.device = DEVICE_STOCKING, def.attachment = ATTACH_NET;
    check_close(allowed(&def, HAWSER_LIMIT_ATTACHMENT, 0, 1, source), 15e3, 0);
    def.swivel_rating = 20e3;
    check_close(allowed(&def, HAWSER_LIMIT_ATTACHMENT, 0, 1, source), 18e3, 0);
    assert_string_equal(source, "limits.attachment_rating of the stocking, 2 of them");
}

/* VDE as Nexans quotes it: 50 and 30 N/mm2 under eye and stocking, three single cables as two. TES-P-104.05, 4.2.2 a:
 * 10.342 N/mm2 of lead. */
TEST(other_codes)
{
    char source[160];
    LimitsDef def = given();
    def.code = CODE_IEC, def.area = 240e-6;
    for (int net = 0; net < 2; net++) {
        static const double counted[] = {1, 2, 2, 2};
        def.attachment = net ? ATTACH_NET : ATTACH_EYE;
        for (int n = 1; n <= 4; n++)
            check_share(allowed(&def, HAWSER_LIMIT_PULL, 0, n, source), counted[n - 1] * 50 * 240, 1e-12);
    }
    def.own[HAWSER_LIMIT_PULL] = 10e3; /* the maker's word is of one cable: several share a rope no better for it */
    check_share(allowed(&def, HAWSER_LIMIT_PULL, 0, 3, source), 20e3, 1e-12);
    check_has(source, "limits.pull; 3 single cables count as 2");
    def.code = CODE_AEIC, def.cores = 4; /* has the share of its own conductors in it already */
    check_share(allowed(&def, HAWSER_LIMIT_PULL, 0, 3, source), 30e3, 1e-12);
    def.cores = 3;
    check_share(allowed(&def, HAWSER_LIMIT_PULL, 0, 3, source), 24e3, 1e-12);
    check_share(allowed(&def, HAWSER_LIMIT_PULL, 0, 1, source), 10e3, 1e-12);
    def.own[HAWSER_LIMIT_PULL] = NAN, def.code = CODE_IEC, def.cores = 1;
    def.metal = METAL_ALUMINIUM;
    check_share(allowed(&def, HAWSER_LIMIT_PULL, 0, 1, source), 30 * 240, 1e-12);
    def.code = CODE_TES, def.attachment = ATTACH_NET, def.sheath = SHEATH_LEAD, def.sheath_area = 500e-6;
    check_share(allowed(&def, HAWSER_LIMIT_PULL, 0, 1, source), 10.342 * 500, 1e-12);
    def.attachment = ATTACH_EYE; /* of its conductors no public source was found */
    check_nan(allowed(&def, HAWSER_LIMIT_PULL, 0, 1, source));
    check_has(source, "code tes has no stress for this conductor: needs limits.stress or limits.pull");
    def.code = CODE_PAPER, def.attachment = ATTACH_NET, def.sheath = SHEATH_COPPER;
    check_nan(allowed(&def, HAWSER_LIMIT_PULL, 0, 1, source));
    check_has(source, "code paper has no stress for this sheath");
}

/* General Cable's sidewall pressures by type, lbf/ft, and ICEA's radii; only where a type is given the pressure is more
 * than the least of all. */
TEST(cable_types)
{
    static const double lbf_per_foot[] = {300, 500, 1000, 1000, 300}, diameters[] = {20, 20, 8, 12, 20};
    char source[160];
    LimitsDef def = given();
    def.code = CODE_AEIC;
    for (int type = TYPE_UNKNOWN; type <= TYPE_ARMOURED; type++) {
        def.cable_type = type;
        check_share(allowed(&def, HAWSER_LIMIT_SIDEWALL, 0, 1, source), lbf_per_foot[type] * LBF / FOOT, 1e-12);
        check_share(allowed(&def, HAWSER_LIMIT_BEND_RADIUS, 0.05, 1, source), diameters[type] * 0.05, 1e-12);
    }
    def.code = CODE_TB889; /* types are of American practice alone */
    check_close(allowed(&def, HAWSER_LIMIT_SIDEWALL, 0, 1, source), 3000, 0);
}

static const hawser_limit *named(int n, const hawser_limit *limit, const char *name)
{
    for (int i = 0; i < n; i++) {
        if (!strcmp(limit[i].name, name)) return &limit[i];
    }
    fail_msg("no limit %s", name);
    return NULL;
}

/* One finding alone, judged. */
static hawser_limit judged_alone(const LimitsDef *def, hawser_limit_kind kind, Finding found)
{
    Finding f[LIMIT_KINDS];
    hawser_limit out[HAWSER_LIMITS_MAX];
    for (int k = 0; k < LIMIT_KINDS; k++) f[k] = (Finding){.absent = 1};
    f[kind] = found;
    assert_int_equal(limits_judge(def, 0.08, 1, f, out), 1);
    return out[0];
}

/* A trip must lie above what the winch needs, 20 kN here, and below what gives first: 56 kN at the cable and 2 kN of
 * rope beyond it, a rope of 300/5 kN, a winch of 50 kN. 1.5 times 20 kN are advised. */
TEST(trips)
{
    LimitsDef def = given();
    def.area = 800e-6;
    Finding f = {.value = 30e3, .steady = 20e3, .beyond = 2e3};
    hawser_limit l = judged_alone(&def, HAWSER_LIMIT_TRIP, f);
    assert_true(l.ok);
    check_share(l.limit, 58e3, 1e-12);
    check_has(l.source, "from 20 kN, needed, to 58 kN, allowed; advised 30 kN");
    def.rope_strength = 300e3;
    def.own[HAWSER_LIMIT_WINCH] = 50e3;
    f.value = 55e3;
    l = judged_alone(&def, HAWSER_LIMIT_TRIP, f);
    assert_false(l.ok);
    check_share(l.limit, 50e3, 1e-12);
    f.value = 19e3; /* it would trip on the pull itself */
    l = judged_alone(&def, HAWSER_LIMIT_TRIP, f);
    assert_false(l.ok);
    check_share(l.limit, 20e3, 1e-12);
    f.value = NAN;
    l = judged_alone(&def, HAWSER_LIMIT_TRIP, f);
    assert_false(l.judged);
    check_has(l.source, "needs drive.winch.trip: set it to 30 kN");
    check_has(judged_alone(&def, HAWSER_LIMIT_TRIP, (Finding){.value = 30e3, .steady = NAN}).source, "see run_away");
    check_share(limits_trip(&def, 1, 40e3, 2e3).force, 50e3, 1e-12); /* 1.5 x 40 kN are more than the winch has */
    def.area = 0, def.rope_strength = def.own[HAWSER_LIMIT_WINCH] = NAN;
    f.value = 30e3;
    l = judged_alone(&def, HAWSER_LIMIT_TRIP, f);
    assert_false(l.judged);
    check_has(l.source, "needs limits.conductor or limits.pull");
    f.value = 19e3; /* too low is known all the same */
    assert_false(judged_alone(&def, HAWSER_LIMIT_TRIP, f).ok || !judged_alone(&def, HAWSER_LIMIT_TRIP, f).judged);
}

/* A brake that is missing breaks its limit whatever its size; the verdict says how large it must be. */
TEST(run_away)
{
    const LimitsDef def = given();
    char text[HAWSER_VERDICT_MAX];
    hawser_limit l = judged_alone(&def, HAWSER_LIMIT_RUN_AWAY, (Finding){.value = 0, .rating = 8e3});
    assert_true(l.judged && l.ok);
    check_close(l.margin, 1, 0);
    l = judged_alone(&def, HAWSER_LIMIT_RUN_AWAY,
                     (Finding){.value = 12e3, .rating = 16e3, .why = "a brake of 12 kN more"});
    assert_false(l.ok);
    check_close(l.margin, -0.75, 1e-12);
    assert_int_equal(hawser_limits_verdict(1, &l, text, sizeof text), 1);
    assert_string_equal(text, "NOT SAFE: 1 of 1 limits broken: a brake of 12 kN more");
}

/* An overlap breaks a clearance whose bound is 0, where a margin relative to the bound has no meaning; it was 1, held.
 */
TEST(overlap_is_broken)
{
    LimitsDef def = given();
    hawser_limit out[HAWSER_LIMITS_MAX];
    for (int k = 0; k < 3; ++k) {
        static const double value[] = {-0.03, 0, 0.03};
        Finding f[LIMIT_KINDS];
        for (int i = 0; i < LIMIT_KINDS; ++i) f[i] = (Finding){.absent = 1};
        f[HAWSER_LIMIT_CLEARANCE_ENVIRONMENT] = (Finding){.value = value[k], .where = "'pipe', 40 m"};
        assert_int_equal(limits_judge(&def, 0.08, 1, f, out), 1);
        check_equal(out[0].ok, k > 0);
        check_equal(out[0].margin, k > 0 ? 1 : -1000);
        char text[200];
        verdict_say(0, NULL, 1, out, 0, text, sizeof text);
        check_has(text, k > 0 ? "SAFE" : "clearance_environment of -0.03 m at 'pipe', 40 m");
    }
}

/* Every limit just held and just broken: bounds 100 kN/1.6, 30 kN/5 ... with nothing else in the way. */
TEST(held_and_broken)
{
    LimitsDef def = given();
    def.area = 800e-6, def.rope_strength = 30e3, def.attachment_rating = 50e3, def.own[HAWSER_LIMIT_WINCH] = 5e3;
    def.own[HAWSER_LIMIT_PUSH] = 8e3, def.own[HAWSER_LIMIT_SQUEEZE] = 10e3,
    def.own[HAWSER_LIMIT_WEIGHT_CORRECTION] = 1.4, def.own[HAWSER_LIMIT_CONTACT_PRESSURE] = 7e3;
    def.own[HAWSER_LIMIT_CLEARANCE_ENVIRONMENT] = 0.1;
    static const double bound[LIMIT_KINDS] = {56e3,  56e3, 50e3, 3000, 7e3, 1.6,  20,  62500,   100e3, 6000, 5e3, 8e3,
                                              100e3, 10e3, 0,    1.5,  5e3, 0.25, 2.6, 6.35e-3, 0.53,  1.4,  0.1};
    for (int broken = 0; broken < 2; broken++) {
        Finding f[LIMIT_KINDS] = {{0}};
        hawser_limit out[HAWSER_LIMITS_MAX];
        for (int k = 0; k < LIMIT_KINDS; k++) {
            const int over = k == HAWSER_LIMIT_BEND_RADIUS || k == HAWSER_LIMIT_ROPE_BEND ||
                                     k == HAWSER_LIMIT_CLEARANCE || k == HAWSER_LIMIT_CLEARANCE_ENVIRONMENT
                                 ? !broken
                                 : broken;
            f[k].value = bound[k] * (over ? 1.01 : 0.99);
            f[k].rating = 100e3;
            f[k].cables = 1;
            strcpy(f[k].where, "here");
        }
        f[HAWSER_LIMIT_RUN_AWAY].value = broken ? 1e3 : 0;
        assert_int_equal(limits_judge(&def, 0.08, 1, f, out), LIMIT_KINDS);
        for (int k = 0; k < LIMIT_KINDS; k++) {
            check_close(out[k].limit, bound[k], 1e-9 * bound[k]);
            assert_true(out[k].judged);
            check_equal(out[k].ok, !broken);
            if (k != HAWSER_LIMIT_RUN_AWAY) check_close(fabs(out[k].margin), 0.01, 2e-4);
            check_equal(out[k].margin < 0, broken);
            assert_string_equal(out[k].where, "here");
            if (k == HAWSER_LIMIT_SPEED) check_has(out[k].source, "TB 889");
            if (k == HAWSER_LIMIT_ROPE_BEND) check_has(out[k].source, "riggers' rule");
        }
    }
}

static void expect_verdict(int n, const hawser_limit *limit, int broken, const char *expected)
{
    char text[HAWSER_VERDICT_MAX];
    assert_int_equal(hawser_limits_verdict(n, limit, text, sizeof text), broken);
    assert_string_equal(text, expected);
}

TEST(verdicts)
{
    hawser_limit l[3] = {
        {.kind = HAWSER_LIMIT_PULL,
         .name = "pull",
         .unit = "N",
         .value = 28e3,
         .limit = 56e3,
         .margin = 0.5,
         .judged = 1,
         .ok = 1},
        {.kind = HAWSER_LIMIT_SIDEWALL,
         .name = "sidewall",
         .unit = "N/m",
         .value = 2700,
         .limit = 3000,
         .margin = 0.1,
         .judged = 1,
         .ok = 1,
         .where = "12 m"},
        {.kind = HAWSER_LIMIT_ROPE, .name = "rope", .unit = "N", .source = "needs limits.rope_strength"}};
    expect_verdict(0, NULL, -1, "NOT JUDGED: the case has no section 'limits'");
    expect_verdict(1, &l[2], -1, "NOT JUDGED: no limit could be judged");
    expect_verdict(2, l, 0, "SAFE: all 2 limits hold, smallest margin 10 % (sidewall at 12 m)");
    expect_verdict(3, l, 0, "SAFE: all 2 limits hold, smallest margin 10 % (sidewall at 12 m); 1 not judged: rope");
    l[1].value = 3600, l[1].margin = -0.2, l[1].ok = 0;
    expect_verdict(3, l, 1, "NOT SAFE: 1 of 2 limits broken: sidewall by 20 % at 12 m; 1 not judged: rope");
    l[0].value = 84e3, l[0].margin = -0.5, l[0].ok = 0;
    expect_verdict(2, l, 2, "NOT SAFE: 2 of 2 limits broken: pull by 50 %, sidewall by 20 % at 12 m");
    /* without tension or sidewall pressure nothing is safe, whatever else holds; what is broken stays broken */
    l[1].value = 2700, l[1].margin = 0.1, l[1].ok = 1;
    l[0] = (hawser_limit){.name = "pull", .unit = "N", .source = "needs limits.pull"};
    expect_verdict(3, l, -1,
                   "NOT JUDGED: pull: needs limits.pull; the 1 limit that could be judged holds; 2 not judged: pull, "
                   "rope");
    l[1].margin = -0.2, l[1].value = 3600, l[1].ok = 0;
    expect_verdict(2, l, 1, "NOT SAFE: 1 of 1 limits broken: sidewall by 20 % at 12 m; 1 not judged: pull");
    l[0] = (hawser_limit){.name = "pull", .value = 84e3, .limit = 56e3, .margin = -0.5, .judged = 1};
    /* a short line is cut, not overrun */
    char text[12];
    hawser_limits_verdict(2, l, text, sizeof text);
    assert_string_equal(text, "NOT SAFE: 2");
}

/* What is not known is said, never passed over as safe. */
TEST(not_judged)
{
    LimitsDef def = given();
    Finding f[LIMIT_KINDS] = {{0}};
    hawser_limit out[HAWSER_LIMITS_MAX];
    static const struct {
        const char *name, *source;
    } unknown[] = {{"pull", "needs limits.conductor.area or limits.pull"},
                   {"attachment", "needs limits.attachment_rating"},
                   {"roller_steady", "no roller has a rating: needs rollers.along.N.rating"},
                   {"rope", "needs limits.rope_strength"},
                   {"winch", "needs limits.winch_capacity"},
                   {"push", "needs limits.push"},
                   {"squeeze", "needs limits.squeeze"},
                   {"alpha", "no rollers"},
                   {"weight_correction", "needs limits.weight_correction"}};
    f[HAWSER_LIMIT_RESTART].absent = 1;
    f[HAWSER_LIMIT_ALPHA].value = NAN;
    strcpy(f[HAWSER_LIMIT_ALPHA].why, "no rollers");
    f[HAWSER_LIMIT_BEND_RADIUS].value = INFINITY; /* a straight route */
    const int n = limits_judge(&def, 0.08, 1, f, out);
    assert_int_equal(n, LIMIT_KINDS - 2); /* from rest, and contact pressure without a bound */
    for (size_t i = 0; i < sizeof unknown / sizeof *unknown; i++) {
        const hawser_limit *const l = named(n, out, unknown[i].name);
        assert_false(l->judged || l->ok);
        check_has(l->source, unknown[i].source);
    }
    const hawser_limit *const bend = named(n, out, "bend_radius");
    assert_true(bend->judged && bend->ok);
    check_equal(bend->margin, 1);
    def.code = CODE_TB889, def.attachment = ATTACH_NET, def.sheath_area = 1e-3;
    limits_judge(&def, 0.08, 1, f, out);
    assert_false(out[0].judged);
    check_has(out[0].source, "code tb889 has no stress for this sheath");
    def.present = 0;
    assert_int_equal(limits_judge(&def, 0.08, 1, f, out), 0);
}

/* The band in which three cables jam has two ends; the worst duct counts, each limit by itself. */
TEST(ducts)
{
    const LimitsDef def = given();
    const DuctLoad wide = {.jam_risk = JAM_SMALL,
                           .jam_ratio = 3.7,
                           .clearance = 0.02,
                           .fill = 0.3,
                           .weight_factor = 1.5},
                   high = {.jam_risk = JAM_SMALL, .jam_ratio = 3.1, .clearance = 0.03, .fill = 0.2},
                   tight = {.jam_risk = JAM_SMALL, .jam_ratio = 2.3, .clearance = 0.005, .fill = 0.45};
    Finding f[LIMIT_KINDS] = {{0}};
    hawser_limit out[HAWSER_LIMITS_MAX];
    for (int k = 0; k < LIMIT_KINDS; k++) f[k].absent = 1;
    limits_duct(&def, 3, NULL, NULL, f);
    assert_int_equal(limits_judge(&def, 0.08, 3, f, out), 0);
    limits_duct(&def, 3, "wide", &wide, f);
    assert_int_equal(limits_judge(&def, 0.08, 3, f, out), 4);
    for (int k = 0; k < 3; k++) assert_true(out[k].ok);
    assert_false(out[3].judged); /* no code has a bound of the weight correction */
    LimitsDef bounded = def;
    bounded.own[HAWSER_LIMIT_WEIGHT_CORRECTION] = 1.4;
    limits_judge(&bounded, 0.08, 3, f, out);
    assert_false(out[3].ok);
    check_close(out[3].value, 1.5, 0);
    check_close(out[0].margin, 1 - 3.2 / 3.7, 1e-12);
    limits_duct(&def, 3, "high", &high, f);
    limits_duct(&def, 3, "tight", &tight, f);
    assert_int_equal(limits_judge(&def, 0.08, 3, f, out), 4);
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
    const DuctLoad two = {.jam_ratio = 3.7, .clearance = 0.02, .fill = 0.3, .weight_factor = 1.5};
    limits_duct(&def, 2, "wide", &two, f);
    assert_int_equal(limits_judge(&def, 0.08, 2, f, out), 3);
    check_close(out[1].limit, 0.31, 0);
}

/* A margin that is smaller than the error of what was found is none; where a limit is broken whatever the error nothing
 * is open. */
TEST(undecided)
{
    hawser_limit l[3] = {{.judged = 1, .ok = 1, .value = 90, .limit = 100, .error = 9},
                         {.judged = 1, .ok = 1, .value = 8, .limit = 10, .error = 2},
                         {.value = 7, .limit = NAN, .error = 700}};
    assert_null(limits_undecided(0, l));
    assert_null(limits_undecided(3, l));
    l[0].error = 11;
    assert_ptr_equal(limits_undecided(3, l), &l[0]);
    l[1].error = 2.2;
    assert_ptr_equal(limits_undecided(3, l), &l[1]);
    const hawser_limit nothing = {.judged = 1, .ok = 1, .limit = 0, .error = 1};
    assert_null(limits_undecided(1, &nothing)); /* no share of nothing */
    l[0].ok = 0;
    l[0].value = 112;
    assert_null(limits_undecided(3, l));
    l[0].value = 105; /* that it is broken is open, too: it was NOT SAFE */
    assert_ptr_equal(limits_undecided(3, l), &l[0]);
}

/* The verdict of a run: reasons not to trust it come first, the first in words and the others by number. */
TEST(trust_comes_first)
{
    const hawser_limit broken = {
        .name = "pull", .unit = "N", .where = "", .value = 150, .limit = 100, .margin = -0.5, .judged = 1};
    hawser_condition c[3] = {{.name = "a", .holds = 1, .remedy = "first"},
                             {.name = "b", .holds = 1, .remedy = "second"},
                             {.name = "c", .holds = 1, .remedy = "third"}};
    char text[300];
    assert_int_equal(hawser_verdict(3, c, 1, &broken, text, sizeof text), 1);
    assert_string_equal(text, "NOT SAFE: 1 of 1 limits broken: pull by 50 %");
    c[1].holds = 0;
    assert_int_equal(hawser_verdict(3, c, 1, &broken, text, sizeof text), -2);
    assert_string_equal(text, "NOT TRUSTED: second; besides, 1 of the limits would be broken");
    c[2].holds = 0;
    assert_int_equal(hawser_verdict(3, c, 0, NULL, text, sizeof text), -2);
    assert_string_equal(text, "NOT TRUSTED: second; and 1 more reason");
    c[0].holds = 0;
    assert_int_equal(hawser_verdict(3, c, 0, NULL, text, sizeof text), -2);
    assert_string_equal(text, "NOT TRUSTED: first; and 2 more reasons");
    assert_int_equal(hawser_verdict(3, c, 0, NULL, NULL, 10), -1);
    assert_int_equal(hawser_verdict(3, NULL, 0, NULL, text, sizeof text), -1);
    assert_int_equal(hawser_verdict(3, c, 0, NULL, text, 0), -1);
    assert_int_equal(hawser_limits_verdict(1, NULL, text, sizeof text), -1);
    assert_int_equal(hawser_limits_verdict(0, NULL, NULL, 9), -1);
    assert_int_equal(hawser_limits_verdict(0, NULL, text, 0), -1);
    memset(text, 'x', sizeof text);
    assert_int_equal(hawser_verdict(3, c, 0, NULL, text, 12), -2); /* cut where the room ends */
    assert_string_equal(text, "NOT TRUSTED");
    assert_int_equal(text[12], 'x');
}

/* What a limit says of where it comes from, letter for letter: numbers and units are the planner's only hint. */
TEST(sources_in_words)
{
    char source[160];
    LimitsDef def = given();
    Finding f = {.value = 4000, .rating = 5600, .cables = 1};
    check_share(limits_allowed(&def, HAWSER_LIMIT_ROLLER_PEAK, 0.1, 1, &f, source), 5600, 1e-15);
    assert_string_equal(source, "rated 5.6 kN");
    check_share(limits_allowed(&def, HAWSER_LIMIT_ROLLER_STEADY, 0.1, 1, &f, source), 3500, 1e-15);
    assert_string_equal(source, "rated 5.6 kN, 1.6 times the steady load");
    f.rating = 0;
    check_nan(limits_allowed(&def, HAWSER_LIMIT_ROLLER_PEAK, 0.1, 1, &f, source));
    assert_string_equal(source, "no roller has a rating: needs rollers.along.N.rating");
    static const struct {
        int cables;
        double share;
        const char *words;
    } fill[] = {{1, 0.53, "paper has none; usual: NEC, chapter 9, table 1: 53 % with 1 cable"},
                {2, 0.31, "paper has none; usual: NEC, chapter 9, table 1: 31 % with 2 cables"},
                {3, 0.4, "paper has none; usual: NEC, chapter 9, table 1: 40 % from 3 cables on"},
                {4, 0.4, "paper has none; usual: NEC, chapter 9, table 1: 40 % from 3 cables on"}};
    for (int k = 0; k < 4; k++) {
        f.cables = fill[k].cables;
        check_share(limits_allowed(&def, HAWSER_LIMIT_FILL, 0.1, 1, &f, source), fill[k].share, 1e-15);
        assert_string_equal(source, fill[k].words);
    }
    check_share(allowed(&def, HAWSER_LIMIT_BEND_RADIUS, 0.0873, 1, source), 20 * 0.0873, 1e-15);
    assert_string_equal(source, "20 D, D = 87.3 mm (paper has none; usual: 20 D at 110 kV (not verified))");
    def.bend_factor = 12;
    check_share(allowed(&def, HAWSER_LIMIT_BEND_RADIUS, 0.0873, 1, source), 12 * 0.0873, 1e-15);
    assert_string_equal(source, "12 D, D = 87.3 mm (limits.bend_factor)");
    check_nan(limits_allowed(&def, HAWSER_LIMIT_ROPE, 0.1, 1, &f, source));
    assert_string_equal(source, "needs limits.rope_strength");
    def.rope_strength = 120e3;
    check_share(limits_allowed(&def, HAWSER_LIMIT_ROPE, 0.1, 1, &f, source), 24e3, 1e-15);
    assert_string_equal(source, "strength 120 kN over a safety factor of 5");
    /* a winch's trip between what it needs and what something bears */
    def = given();
    f = (Finding){.value = NAN, .steady = 20e3};
    check_nan(limits_allowed(&def, HAWSER_LIMIT_TRIP, 0.1, 1, &f, source));
    assert_string_equal(source, "needs drive.winch.trip: set it to 30 kN");
    f.value = 25e3;
    check_nan(limits_allowed(&def, HAWSER_LIMIT_TRIP, 0.1, 1, &f, source));
    check_has(source, "or limits.pull; 20 kN are needed anyway");
    f.value = 19e3;
    check_equal(limits_allowed(&def, HAWSER_LIMIT_TRIP, 0.1, 1, &f, source), 20e3);
    f.value = 20e3; /* just what is needed: not too low */
    check_nan(limits_allowed(&def, HAWSER_LIMIT_TRIP, 0.1, 1, &f, source));
    def.own[HAWSER_LIMIT_PULL] = 50e3;
    check_equal(limits_allowed(&def, HAWSER_LIMIT_TRIP, 0.1, 1, &f, source), 50e3);
    assert_string_equal(source, "from 20 kN, needed, to 50 kN, allowed; advised 30 kN");
    f.steady = NAN;
    check_nan(limits_allowed(&def, HAWSER_LIMIT_TRIP, 0.1, 1, &f, source));
    check_has(source, "see run_away");
    def.attachment_rating = 9e3, def.grips = 2, def.code = CODE_PAPER;
    check_share(allowed(&def, HAWSER_LIMIT_ATTACHMENT, 0, 1, source), 18e3, 1e-15);
    assert_string_equal(source, "limits.attachment_rating, 2 of them");
    def.grips = 1;
    check_share(allowed(&def, HAWSER_LIMIT_ATTACHMENT, 0, 1, source), 9e3, 1e-15);
    assert_string_equal(source, "limits.attachment_rating");
}
