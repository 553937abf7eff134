/* Several chains from the case to the figures: three that do nothing to each other are three runs, bit for bit; what
 * holds them together balances and closes the books; how cables lie in a duct gives the formulas' weight correction;
 * what cannot be computed is refused. */
#include <jansson.h>
#include <stdio.h>
#include <unistd.h>

#include "tests/io/case_fixture.h"

#include "def/duct.h"
#include "hawser/hawser.h"
#include "hawser/sweep.h"
#include "tests/support/scratch.h"

#define FOLDER HAWSER_SOURCE_DIR "/tests/data/"

/* A case of tests/data with settings, NULL behind the last. */
static hawser_case *load(const char *file, const char *const *settings)
{
    hawser_case *c;
    hawser_error err;
    if (hawser_case_load(file, &c, &err)) fail_msg("%s", err.message);
    for (int i = 0; settings && settings[i]; i += 2)
        if (hawser_case_set(c, settings[i], settings[i + 1], &err)) fail_msg("%s", err.message);
    return c;
}

static hawser_sim *run(hawser_case *c)
{
    hawser_sim *s;
    hawser_error err;
    if (hawser_sim_new(c, NULL, &s, &err) || hawser_sim_run(s, NULL, NULL, NULL, &err)) fail_msg("%s", err.message);
    hawser_case_free(c);
    return s;
}

/* The figure of a chain by name. */
static double figure_of(const hawser_sim *s, const char *name, const char *key)
{
    const hawser_machine *m;
    const int n = hawser_sim_machines(s, &m);
    for (int i = 0; i < n; ++i)
        if (strcmp(m[i].name, name) == 0) return hawser_machine_figure(&m[i], key);
    fail_msg("there is no chain '%s'", name);
    return NAN;
}

/* Like chains take the steps that one takes alone, and come to the same bits; shifted aside, to the same but for
 * rounding. */
TEST(test_three_runs)
{
    const char *const same_place[] = {
        "chains.one.place", "[0 m, 0 m]", "chains.two.place", "[0 m, 0 m]", "chains.three.place", "[0 m, 0 m]", NULL};
    hawser_case *alone =
        case_with("cables: {power: {d: 41 mm, mass: 3 kg/m, EA: 27 MN, GA: 9 MN, GJ: 100 N m2, EI: "
                  "200 N m2, damping: 2 ms}}\n"
                  "chain: [{cable: power, length: 4 m, segment: 250 mm}]\n"
                  "route: {head_at: 4 m, pieces: [{straight: 8 m}]}\n"
                  "surfaces: {planes: [{name: floor, point: [0 m, 0 m, -20.5 mm], normal: [0, 0, 1]}]}\n"
                  "friction: {mu: 0.3}\n"
                  "drive: {winch: {speed: 0.1 m/s, to: 1 s}, tail: {tension: 100 N}}\n"
                  "run: {duration: 2 s, steady_from: 1.5 s}\n"
                  "solver: {passes: 1, planar: off}\n",
                  NULL);
    hawser_sim *const one = run(alone);
    hawser_summary expected, found;
    hawser_sim_summary(one, &expected);
    for (int aside = 0; aside < 2; ++aside) {
        hawser_sim *const three = run(load(FOLDER "chains.yaml", aside ? NULL : same_place));
        assert_int_equal(hawser_sim_chains(three), 3);
        for (int k = 0; k < 3; ++k) {
            hawser_sim_summary(hawser_sim_chain(three, k), &found);
            if (!aside) check_equal(found.pull_mean_N, expected.pull_mean_N);
            if (!aside) check_equal(found.pull_peak_N, expected.pull_peak_N);
            check_below(fabs(found.pull_mean_N / expected.pull_mean_N - 1), 1e-9);
            check_below(fabs(found.pull_peak_N / expected.pull_peak_N - 1), 1e-9);
        }
        hawser_sim_summary(three, &found);
        assert_int_equal(found.steps, expected.steps);
        check_below(fabs(figure_of(three, "two", "share") - 1.0 / 3), 1e-9);
        hawser_sim_free(three);
    }
    hawser_sim_free(one);
}

/* Forces between chains cancel, and what a pull of three by one rope does goes where the books say. */
TEST(test_books)
{
    /* rows that miss nothing of the rope's pull (of 50 ms: 487 N for 494.5 N, in its bar by (EB33)) */
    hawser_sim *const s = run(load(FOLDER "chains-rope.yaml", (const char *const[]){"output.interval", "10 ms", NULL}));
    hawser_summary sum;
    hawser_sim_summary(s, &sum);
    assert_non_null(sum.balance);
    print_message("energy %.1e of %.3g J, momentum %.1e\n", sum.balance->residual_share, sum.balance->turnover_J,
                  sum.balance->impulse_residual_share);
    check_below(sum.balance->residual_share, 1e-3);
    check_below(sum.balance->impulse_residual_share, 4e-4);
    /* the rope pulls with what the three hold it back by, and its own weight's friction; shares add up */
    const double three =
        figure_of(s, "one", "pull_mean_N") + figure_of(s, "two", "pull_mean_N") + figure_of(s, "three", "pull_mean_N");
    check_between(figure_of(s, "rope", "pull_mean_N") - three, -2, 8);
    check_below(fabs(figure_of(s, "all", "pull_mean_N") / three - 1), 1e-9);
    check_below(fabs(figure_of(s, "one", "share") + figure_of(s, "two", "share") + figure_of(s, "three", "share") - 1),
                1e-9);
    /* what the cables' meshes make of it is in the rope's bar (SC17), and books are everybody's (EB2) */
    double meshes = 0, time = sum.pull_mean_error.time / sum.pull_mean_N;
    const double own = sum.pull_mean_error.mesh;
    for (int k = 1; k < 4; ++k) {
        hawser_sim_summary(hawser_sim_chain(s, k), &sum);
        meshes += sum.pull_mean_error.mesh;
        check_at_least(sum.pull_mean_error.time / sum.pull_mean_N, 0.999 * time);
    }
    check_above(own, meshes);
    check_below(own, 2 * meshes);
    /* theory of the three with the triangle's weight factor beside it */
    const double x = 41.0 / (90 - 41);
    check_below(fabs(figure_of(s, "one", "weight_factor") - 1 / sqrt(1 - x * x)), 1e-9);
    check_below(fabs(figure_of(s, "all", "pull_mean_N") / figure_of(s, "all", "reference_N") - 1), 0.03);
    hawser_sim_free(s);
}

/* walls/weight of three that lie at rest in a duct of D/d, at `k` times the usual stiffness of the contacts. */
static double lying(const char *pattern, double ratio, const char *k)
{
    char radius[32];
    snprintf(radius, sizeof radius, "%.6f mm", 41 * ratio / 2);
    const char *const settings[] = {"lay.pattern",
                                    pattern,
                                    "surfaces.ducts.0.radius",
                                    radius,
                                    "contact.k",
                                    k,
                                    "friction.mu",
                                    "0",
                                    "run.duration",
                                    "20 ms",
                                    "run.steady_from",
                                    "0 s",
                                    "chains",
                                    "{one: {still: true}, two: {still: true}, three: {still: true}}",
                                    "solver.relax_iterations",
                                    "1000",
                                    "chain.0.length",
                                    "2 m",
                                    NULL};
    hawser_sim *const s = run(load(FOLDER "chains-rope.yaml", settings));
    const double found = figure_of(s, "all", "weight_correction");
    hawser_sim_free(s);
    return found;
}

/* (T20): the factors are the geometry of the section, and contacts that give way less come nearer to it: by the power
 * 2/3 of their stiffness, ten times as stiff 4.6 times as near. */
TEST(test_weight_correction)
{
    const struct {
        const char *pattern;
        double ratio;
    } cases[] = {{"triangular", 2.2}, {"triangular", 2.5}, {"cradled", 3}};
    for (int i = 0; i < 3; ++i) {
        const double x = 1 / (cases[i].ratio - 1);
        const double formula = strcmp(cases[i].pattern, "cradled") ? 1 / sqrt(1 - x * x) : 1 + 4.0 / 3 * x * x;
        const double soft = lying(cases[i].pattern, cases[i].ratio, "3.4e8 N/m^1.5") / formula - 1;
        const double stiff = lying(cases[i].pattern, cases[i].ratio, "3.4e9 N/m^1.5") / formula - 1;
        print_message("%s %.1f: %.2g, %.2g\n", cases[i].pattern, cases[i].ratio, soft, stiff);
        check_below(fabs(soft), 5e-3);
        check_between(fabs(soft) / fabs(stiff), 3.5, 6);
    }
}

/* walls/weight of three in a duct of D/d, of which two lie at the ends of its level diameter and the third on them like
 * the keystone of an arch, 1.5 s after they were let go. */
static double arch(double ratio, double mu)
{
    const double d = 41, rho = d * (ratio - 1) / 2, apart = 1.0005 * d;
    const double up = rho < apart ? sqrt(apart * apart - rho * rho) : 0.02 * d;
    char text[1200];
    snprintf(
        text, sizeof text,
        "cables: {power: {d: 41 mm, mass: 3 kg/m, EA: 27 MN, GA: 9 MN, GJ: 100 N m2, EI: 60 N m2, damping: 2 ms}}\n"
        "chain: [{cable: power, length: 600 mm, segment: 200 mm}]\n"
        "chains:\n"
        "  left: {still: true, place: [%.6f mm, 0 mm]}\n"
        "  right: {still: true, place: [-%.6f mm, 0 mm]}\n"
        "  middle: {still: true, place: [0 mm, %.6f mm]}\n"
        "route: {head_at: 700 mm, pieces: [{straight: 1 m}]}\n"
        "surfaces: {ducts: [{name: duct, radius: %.6f mm}]}\n"
        "friction: {mu: %g}\n"
        "solver: {relax: false}\n"
        "run: {duration: 2 s, steady_from: 1.5 s}\n",
        rho - 0.01, rho - 0.01, up, d * ratio / 2, mu);
    hawser_sim *const s = run(case_with(text, NULL));
    const double found = figure_of(s, "all", "weight_correction");
    hawser_sim_free(s);
    return found;
}

/* The smallest D/d at which such an arch stands (SC16). */
static double arch_stands(double mu)
{
    double low = 0, high = M_PI / 2; /* 3 sin a = mu (1 + 3 cos a) */
    while (high - low > 1e-12) {
        const double a = (low + high) / 2;
        *(3 * sin(a) < mu * (1 + 3 * cos(a)) ? &low : &high) = a;
    }
    return 1 + 2 * cos(low);
}

/* Jamming: without friction the arch becomes a triangle below D/d = 3 and a cradle above it, and presses as their
 * formulas say; with friction it stands from where (SC16) says on up to 3 and beyond, and presses on the duct several
 * times as hard. */
TEST(test_jam)
{
    double most = 0;
    const double limp[] = {2.7, 2.95, 3.2};
    for (int i = 0; i < 3; ++i) {
        const double x = 1 / (limp[i] - 1), formula = limp[i] < 3 ? 1 / sqrt(1 - x * x) : 1 + 4.0 / 3 * x * x;
        check_below(fabs(arch(limp[i], 0) / formula - 1), 2e-3);
    }
    const double mu[] = {0.2, 0.3};
    for (int i = 0; i < 2; ++i) {
        const double edge = arch_stands(mu[i]);
        for (int beyond = 0; beyond < 2; ++beyond) {
            const double ratio = edge + (beyond ? 0.03 : -0.04), x = 1 / (ratio - 1);
            const double pressed = arch(ratio, mu[i]) * sqrt(1 - x * x);
            print_message("mu %.1f: stands from %.3f; at %.3f %.3f times the triangle\n", mu[i], edge, ratio, pressed);
            if (beyond) check_between(pressed, 1.4, 4);
            if (!beyond) check_below(fabs(pressed - 1), 2e-3);
        }
        most = fmax(most, arch(3, mu[i]));
    }
    check_above(most, 5); /* of three in one line */
}

/* The row of a theory's limits that is of this name and pulled forward; NULL: there is none. */
static const json_t *forward_limit(const json_t *limits, const char *name)
{
    const json_t *row;
    size_t i;
    json_array_foreach(limits, i, row)
    {
        const int it = !strcmp(json_string_value(json_object_get(row, "name")), name);
        if (it && !strcmp(json_string_value(json_object_get(row, "direction")), "forward")) return row;
    }
    return NULL;
}

/* The calculation of each, and a rope's the sum of what it draws and of its own; what is there to be built. */
TEST(test_theory)
{
    const double x = 41.0 / (90 - 41), factor = 1 / sqrt(1 - x * x);
    hawser_case *c = load(FOLDER "chains-rope.yaml", NULL);
    hawser_error err;
    char *text;
    double found[4][3];
    if (hawser_case_theory(c, HAWSER_CSV, &text, &err)) fail_msg("%s", err.message);
    const char *const starts[] = {"rope,its winch,", "one,rope,", "two,rope,", "three,rope,"};
    for (int k = 0; k < 4; ++k) {
        const char *const row = strstr(text, starts[k]);
        assert_non_null(row);
        found[k][2] = NAN;
        assert_in_range(sscanf(row + strlen(starts[k]), "%lf,%lf,%lf", &found[k][0], &found[k][1], &found[k][2]), 2, 3);
    }
    hawser_text_free(text);
    /* 9 m of 3 kg/m over the wall with the triangle's factor, behind 100 N; the rope's 0.5 kg/m without it */
    const double cable = 100 + 0.3 * factor * 3 * 9.80665 * 9, rope = 0.3 * 0.5 * 9.80665 * 9;
    for (int k = 1; k < 4; ++k) {
        check_below(fabs(found[k][0] / factor - 1), 1e-8);
        check_below(fabs(found[k][1] / cable - 1), 1e-3);
        check_below(fabs(found[k][2] - 1.0 / 3), 1e-9);
    }
    check_below(fabs(found[0][1] / (3 * cable + rope) - 1), 1e-3);
    if (hawser_case_theory(c, HAWSER_JSON, &text, &err)) fail_msg("%s", err.message);
    assert_non_null(strstr(text, "\"theory\""));
    hawser_text_free(text);
    /* the rope is judged with what it draws, and each cable by what is its own */
    hawser_case_free(c);
    const char *const rated[] = {"limits", "{pull: 300 N, rope_strength: 3 kN, rope_factor: 5}", NULL};
    c = load(FOLDER "chains-rope.yaml", rated);
    if (hawser_case_theory(c, HAWSER_JSON, &text, &err)) fail_msg("%s", err.message);
    json_t *const all = json_loads(text, 0, NULL), *const each = json_object_get(all, "theory");
    for (int k = 0; k < 4; ++k) {
        const char *const name = (const char *const[]){"rope", "one", "two", "three"}[k];
        const json_t *const limits = json_object_get(json_object_get(each, name), "limits");
        const json_t *const pull = forward_limit(limits, "pull"), *const strength = forward_limit(limits, "rope");
        assert_non_null(pull);
        check_share(json_number_value(json_object_get(pull, "value")), k ? cable : 3 * cable, 1e-3);
        check_share(json_number_value(json_object_get(pull, "limit")), k ? 300 : 900, 1e-12);
        assert_int_equal(strength != NULL, k == 0);
        if (k) continue;
        check_share(json_number_value(json_object_get(strength, "value")), found[0][1], 1e-3);
        assert_string_equal(json_string_value(json_object_get(strength, "ok")), "NO");
    }
    json_decref(all);
    hawser_text_free(text);
    if (hawser_case_theory(c, HAWSER_TABLE, &text, &err)) fail_msg("%s", err.message);
    assert_non_null(strstr(text, "What the chains pull by theory"));
    hawser_text_free(text);
    if (hawser_case_describe(c, HAWSER_TABLE, &text, &err)) fail_msg("%s", err.message);
    assert_non_null(strstr(text, "Chains that are pulled together"));
    assert_non_null(strstr(text, "three"));
    assert_non_null(strstr(text, "2.305")); /* jam ratio, 1.05 D/d of the three and not of the rope */
    hawser_text_free(text);
    hawser_case_free(c);
}

/* A rope begins with the pulls of all that it draws and takes them round its own bends (SC15): without weight the
 * capstan formula, 300 N exp(mu theta), and beyond the end of the route nothing is added. */
TEST(test_rope_theory)
{
    for (int beyond = 0; beyond < 2; ++beyond) {
        const char *const settings[] = {"gravity",
                                        "0 m/s2",
                                        "route.pieces",
                                        "[{straight: 5 m}, {bend: 60 deg, radius: 2 m, plane: left}, {straight: 1 m}]",
                                        "chains.rope.chain.0.length",
                                        beyond ? "6 m" : "3.6 m",
                                        "surfaces.ducts",
                                        "[{name: duct, radius: 45 mm}]",
                                        NULL};
        hawser_case *const c = load(FOLDER "chains-rope.yaml", settings);
        hawser_sim *s;
        hawser_error err;
        hawser_summary sum;
        if (hawser_sim_new(c, NULL, &s, &err)) fail_msg("%s", err.message);
        hawser_sim_summary(s, &sum);
        /* in mid window the winch has come 0.1 m: the rope ends 7.7 m along, behind the bend's end at 7.094 m */
        check_below(fabs(sum.reference_total_N / (300 * exp(0.3 * M_PI / 3)) - 1), 1e-6);
        for (int k = 1; k < 4; ++k) {
            hawser_sim_summary(hawser_sim_chain(s, k), &sum);
            check_below(fabs(sum.reference_total_N / 100 - 1), 1e-9);
        }
        hawser_sim_free(s);
        hawser_case_free(c);
    }
}

/* What they press on each other with is soft at first, as walls are (E5): cables that drop onto each other in a duct
 * come to rest. */
TEST(test_rest)
{
    const char *const settings[] = {"surfaces.ducts.0.radius", "48 mm", "friction.mu", "0", NULL};
    hawser_case *const c = load(FOLDER "chains-rope.yaml", settings);
    hawser_relaxation rest;
    hawser_sim *s;
    hawser_error err;
    if (hawser_sim_new(c, NULL, &s, &err) || hawser_sim_relax(s, &rest, &err)) fail_msg("%s", err.message);
    assert_true(rest.reached);
    check_at_most(rest.iterations, 300);
    hawser_sim_free(s);
    hawser_case_free(c);
}

/* What one of them has broken is said of all: here the middle one, by its tail. */
TEST(test_judged)
{
    const char *const settings[] = {"limits", "{pull: 2 kN}", "chains.two", "{drive: {tail: {tension: 3 kN}}}", NULL};
    hawser_sim *const s = run(load(FOLDER "chains.yaml", settings));
    hawser_limit limit[HAWSER_LIMITS_MAX];
    const int n = hawser_sim_limits(s, limit);
    int broken = 0;
    for (int i = 0; i < n; ++i) {
        if (strcmp(limit[i].name, "pull") != 0) continue;
        broken = limit[i].judged && !limit[i].ok;
        assert_non_null(strstr(limit[i].where, "chain 'two'"));
        check_above(limit[i].value, 3000);
    }
    assert_true(broken);
    hawser_sim_free(s);
}

/* A rope has what it draws to bear, and each of these what it may be pulled with; its own theory goes without them, so
 * that no roller is overloaded by it. */
TEST(test_rope_judged)
{
    const char *const settings[] = {
        "limits",  "{pull: 250 N, rope_strength: 6 kN}",     "lay", "{pattern: flat, spacing: 60 mm}", "surfaces", "{}",
        "rollers", "{along: {spacing: 1 m, width: 600 mm}}", NULL};
    hawser_sim *const s = run(load(FOLDER "chains-rope.yaml", settings));
    hawser_limit limit[HAWSER_LIMITS_MAX];
    int found = 0;
    for (int i = hawser_sim_limits(s, limit) - 1; i >= 0; --i) {
        const int pull = !strcmp(limit[i].name, "pull"), alpha = !strcmp(limit[i].name, "alpha");
        if (!strcmp(limit[i].name, "rope")) check_above(limit[i].value, 350);
        if (pull) check_share(limit[i].limit, limit[i].value > 250 ? 750 : 250, 1e-12);
        if (alpha) check_has(limit[i].where, "chain '");
        if (!pull && !alpha) continue;
        assert_true(limit[i].ok);
        found += pull + alpha;
    }
    assert_int_equal(found, 2);
    hawser_sim_free(s);
}

/* One lies beside the rollers and falls: the figures of all are not to be trusted, and whose fault it is stands there.
 */
TEST(test_fallen)
{
    const char *const settings[] = {"surfaces",
                                    "{}",
                                    "rollers",
                                    "{along: {from: 0.25 m, to: 7.75 m, spacing: 500 mm}}",
                                    "chains.three",
                                    "{place: [-1 m, 0 m]}",
                                    "solver.relax",
                                    "false",
                                    "run.keep_going",
                                    "true",
                                    NULL};
    hawser_sim *const s = run(load(FOLDER "chains.yaml", settings));
    hawser_summary sum;
    int told = 0;
    hawser_sim_summary(s, &sum);
    for (int i = 0; i < sum.n_conditions; ++i)
        told += !sum.conditions[i].holds && strstr(sum.conditions[i].remedy, "chain 'three'") != NULL;
    check_above(told, 0);
    hawser_sim_free(s);
}

/* Places are as far apart as they are to be, and within what the duct leaves. */
TEST(test_places)
{
    double place[8][2];
    for (int pattern = LAY_FLAT; pattern <= LAY_TRIPLEXED; ++pattern) {
        for (int n = 2; n <= 4; ++n) {
            const LayDef lay = {.pattern = (LayPattern)pattern, .spacing = 0.04, .radius = 0.07, .seed = 5};
            assert_true(lay_places(&lay, n, place));
            double nearest = INFINITY;
            for (int i = 0; i < n; ++i) {
                check_below(hypot(place[i][0], place[i][1]), 0.07 + 1e-12);
                for (int j = 0; j < i; ++j)
                    nearest = fmin(nearest, hypot(place[i][0] - place[j][0], place[i][1] - place[j][1]));
            }
            if (pattern == LAY_RANDOM) check_at_least(nearest, 0.04 - 1e-12);
            if (pattern != LAY_RANDOM) check_below(fabs(nearest - 0.04), 1e-12);
        }
    }
    const LayDef narrow = {.pattern = LAY_CRADLED, .spacing = 0.04, .radius = 0.024};
    assert_false(lay_places(&narrow, 3, place)); /* the outer ones would lie above the middle of the duct */
}

/* What several chains cannot be beside, and what does not fit together, is said with its key. */
TEST(test_refused)
{
    const struct {
        const char *key, *value, *part;
    } bad[] = {
        {"drive.winch.take_in", "true", "several chains cannot be computed with drive.winch.take_in"},
        {"contact.cable_on_cable", "true", "a chain that touches itself"},
        {"medium", "{density: 1000 kg/m3}", "cannot be computed with medium"},
        {"solver.linear_solver", "block", "several chains cannot be computed with solver.linear_solver"},
        {"chains.one", "{join: nobody}", "is not the name of a chain"},
        {"chains.one", "{join: one}", "cannot be joined to itself"},
        {"chains.one", "{swivel: true}", "no head is joined"},
        {"chains.one", "{join: two, drive: {winch: {speed: 1 m/s}}}", "pulled by 'two'"},
        {"chains.two words", "{}", "a name of letters"},
        {"chains.all", "{}", "a name of letters"},
        {"chains", "{one: {}}", "two chains or more"},
        {"lay", "{pattern: triplexed, length: 1 m}", "needs segments of at most"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        hawser_error err;
        hawser_case *const c = load(FOLDER "chains.yaml", NULL);
        hawser_status status = hawser_case_set(c, bad[i].key, bad[i].value, &err);
        if (!status) status = hawser_case_check(c, &err);
        assert_int_equal(status, HAWSER_ERR_INPUT);
        if (!strstr(err.message, bad[i].part)) fail_msg("'%s' is not in: %s", bad[i].part, err.message);
        hawser_case_free(c);
    }
    /* chains that begin inside each other */
    const char *const inside[] = {"lay.spacing", "20 mm", "contact.between_chains", "true", NULL};
    hawser_case *const c = load(FOLDER "chains.yaml", inside);
    hawser_error err;
    hawser_sim *s;
    assert_int_equal(hawser_sim_new(c, NULL, &s, &err), HAWSER_ERR_INPUT);
    assert_non_null(strstr(err.message, "inside each other"));
    hawser_case_free(c);
}

/* What needs one chain says so, with the line at which there are several. */
TEST(test_alone)
{
    hawser_case *const c = load(FOLDER "chains.yaml", NULL);
    hawser_error err = {.status = HAWSER_OK};
    hawser_certificate *certificate;
    hawser_sim *s;
    char *text;
    assert_int_equal(hawser_sim_new(c, NULL, &s, &err), HAWSER_OK);
    assert_int_equal(hawser_certify(c, s, NULL, &certificate, &err), HAWSER_ERR_INPUT);
    assert_non_null(strstr(err.message, "chains.yaml:6: key 'chains': a certificate"));
    assert_int_equal(hawser_case_sensitivities(c, HAWSER_TABLE, &text, &err), HAWSER_ERR_INPUT);
    assert_non_null(strstr(err.message, "chains.yaml:6: key 'chains': sensitivities"));
    hawser_sim_free(s);
    hawser_case_free(c);
}

/* The simulation of one chain is looked at through the first's; it is not moved alone. */
TEST(test_handles)
{
    hawser_case *const c = load(FOLDER "chains.yaml", NULL);
    hawser_sim *s;
    hawser_error err;
    void *bytes;
    size_t size;
    if (hawser_sim_new(c, NULL, &s, &err)) fail_msg("%s", err.message);
    hawser_sim *const two = hawser_sim_chain(s, 1);
    assert_string_equal(hawser_sim_chain_name(two), "two");
    assert_null(hawser_sim_chain(s, 3));
    assert_ptr_equal(hawser_sim_chain(s, 0), s);
    assert_int_equal(hawser_sim_advance(two, 1, 0, &err), HAWSER_ERR_INPUT);
    assert_int_equal(hawser_sim_run(two, NULL, NULL, NULL, &err), HAWSER_ERR_INPUT);
    assert_int_equal(hawser_sim_save_memory(two, &bytes, &size, &err), HAWSER_ERR_INPUT);
    assert_int_equal(hawser_sim_advance(s, 0.1, 0, &err), HAWSER_OK);
    check_equal(hawser_sim_time(two), hawser_sim_time(s));
    hawser_sim_free(s);
    hawser_case_free(c);
}

static int stop_halfway(void *user, hawser_sim *s, double t)
{
    (void)user;
    return t >= hawser_sim_end_time(s) / 2;
}

/* A run that is stopped halfway and gone on with writes what one that is not writes, of every chain. */
TEST(test_resumed)
{
    static const char *const files[] = {"series.csv", "one/series.csv", "three/series.csv"};
    const char *const whole = scratch_path("whole"), *const halves = scratch_path("halves");
    /* as often as it is no burden: the first after the first step */
    const char *const settings[] = {"run.checkpoint", "1 us", NULL};
    hawser_error err;
    hawser_sim *s;
    hawser_case *c = load(FOLDER "chains-rope.yaml", settings);
    assert_int_equal(hawser_sim_new(c, NULL, &s, &err), HAWSER_OK);
    assert_int_equal(hawser_sim_run(s, whole, NULL, NULL, &err), HAWSER_OK);
    hawser_sim_free(s);
    assert_int_equal(hawser_sim_new(c, NULL, &s, &err), HAWSER_OK);
    hawser_sim_on_step(s, stop_halfway, NULL);
    assert_int_equal(hawser_sim_run(s, halves, NULL, NULL, &err), HAWSER_STOPPED);
    hawser_sim_free(s);
    hawser_case_free(c);
    if (hawser_case_resume(halves, &c, &err)) fail_msg("%s", err.message);
    assert_int_equal(hawser_sim_new(c, NULL, &s, &err), HAWSER_OK);
    if (hawser_sim_resume(s, halves, NULL, NULL, &err)) fail_msg("%s", err.message);
    hawser_sim_free(s);
    hawser_case_free(c);
    for (int k = 0; k < 3; ++k) {
        char *const one = file_text(scratch_path_in("whole", files[k]));
        char *const two = file_text(scratch_path_in("halves", files[k]));
        assert_string_equal(one, two);
        free(one);
        free(two);
    }
}

/* The page about the first's folder is about all of them. */
TEST(test_page)
{
    const char *const dir = scratch_path("page"), *const page = scratch_path("page.html");
    static const char *const labels[] = {"/page/one\"", "/page/two\"", "/page/three\""};
    hawser_error err;
    hawser_sim *s;
    hawser_case *c = load(FOLDER "chains-rope.yaml", NULL);
    assert_int_equal(hawser_sim_new(c, NULL, &s, &err), HAWSER_OK);
    assert_int_equal(hawser_sim_run(s, dir, NULL, NULL, &err), HAWSER_OK);
    if (hawser_report_write(&dir, 1, page, &err)) fail_msg("%s", err.message);
    char *const text = file_text(page);
    for (int k = 0; k < 3; ++k) check_has(text, labels[k]);
    free(text);
    hawser_sim_free(s);
    hawser_case_free(c);
}

TEST_GROUP(scratch_make, scratch_remove)
