/* What a study says, against what is known by other means: quantiles of eq. 10 under an exact law, a probability,
 * theory with runs near a limit, and indices of a pull whose variance is known. */
#include "tests/study/study_fixture.h"

#include "def/limits.h"

/* Of the findings of the study at folder/study.yaml, computed into folder/DIR. */
static Findings findings_in(const char *dir, Study **s, Rows *rows)
{
    Findings f;
    hawser_error err;
    rows_of(dir, s, rows);
    assert_int_equal(findings_make(*s, rows, &f, &err), HAWSER_OK);
    return f;
}

static void clear(Study *s, Rows *rows, Findings *f)
{
    findings_free(f);
    rows_free(rows);
    study_free(s);
}

/* A number of theory's answer for the paper's tunnel with that friction. */
static double total_of_paper(const char *mu)
{
    hawser_case *c;
    hawser_error err;
    char *text;
    assert_int_equal(hawser_case_load(HAWSER_SOURCE_DIR "/cases/huangjiahu.yaml", &c, &err), HAWSER_OK);
    hawser_case_set(c, "friction.mu", mu, NULL);
    assert_int_equal(hawser_case_theory(c, HAWSER_JSON, &text, &err), HAWSER_OK);
    const double total = strtod(strstr(text, "\"paper_total_N\":") + 16, NULL);
    hawser_text_free(text);
    hawser_case_free(c);
    return total;
}

/* Eq. 10 is a straight line in the friction coefficient: its quantiles are those of the coefficient, and the
 * probability of more than any force follows. 512 Sobol points find both to about 1/512 of the range. */
TEST(eq_10_is_exact)
{
    const double at_1 = total_of_paper("0.1"), at_3 = total_of_paper("0.3"), slope = (at_3 - at_1) / 0.2;
    check_share(total_of_paper("0.2"), (at_1 + at_3) / 2, 1e-9);
    scratch_write("study.yaml", "case: " HAWSER_SOURCE_DIR "/cases/huangjiahu.yaml\n"
                                "parameters: {friction.mu: {triangular: {from: 0.1, mode: 0.15, to: 0.3}}}\n"
                                "monte-carlo: {samples: 512}\nquantities: [paper_total_N]\n");
    hawser_study *const run = study_open(scratch_path("study.yaml"));
    assert_int_equal(hawser_study_run(run, scratch_path("eq10"), NULL, NULL), HAWSER_OK);
    hawser_study_free(run);
    Study *s;
    Rows rows;
    Findings f = findings_in("eq10", &s, &rows);
    const Distribution law = {.kind = LAW_TRIANGULAR, .a = 0.1, .b = 0.3, .c = 0.15};
    const double p[5] = {0.05, 0.25, 0.5, 0.75, 0.95};
    for (int k = 0; k < 5; k++) {
        const double exact = at_1 + slope * (distribution_quantile(&law, p[k]) - 0.1);
        check_close(f.quantity[0].percentile[k], exact, 0.01 * (at_3 - at_1));
    }
    check_close(f.quantity[0].spread.mean, at_1 + slope * ((0.1 + 0.3 + 0.15) / 3 - 0.1), 1e-4 * (at_3 - at_1));
    /* P(mu > 0.25) = (0.3 - 0.25)^2 / ((0.3 - 0.1) (0.3 - 0.15)) */
    int more = 0;
    for (long i = 0; i < rows.n; i++) more += rows.value[i] > at_1 + slope * 0.15;
    check_close(more / 512.0, 0.0025 / 0.03, 2.0 / 512);
    clear(s, &rows, &f);
}

/* On a level row the pull is W L mu: with a winch for 600 N of 10 m of 20 kg/m it is not safe above mu = 600/1961.33.
 */
TEST(probability_of_a_limit)
{
    study_compute("parameters: {friction.mu: {uniform: {from: 0.1, to: 0.4}}}\n"
                  "monte-carlo: {samples: 512}\nquantities: [reference_total_N]\n",
                  "limit", 2);
    Study *s;
    Rows rows;
    Findings f = findings_in("limit", &s, &rows);
    double value[2], mu[2];
    for (int i = 0; i < 2; i++) {
        study_point(s, i, &mu[i]);
        value[i] = rows.value[i];
    }
    const double exact = (0.4 - 600 / (value[0] / mu[0])) / 0.3;
    check_share(value[1] / mu[1], value[0] / mu[0], 1e-9);
    check_close(f.not_safe.value, exact, 2.0 / 512);
    check_between(exact, f.not_safe.low, f.not_safe.high);
    for (int k = 0; k < f.n_limits; k++) {
        const int winch = strcmp(f.limit[k].name, "winch") == 0;
        if (winch) check_close(f.limit[k].share.value, 100 * exact, 0.4);
        assert_int_equal(f.limit[k].binds, winch ? f.by_verdict[VERDICT_NOT_SAFE] : 0);
    }
    /* by more samples the interval narrows as the root of their number */
    const ConvergenceRow *const first = &f.convergence[1], *const last = &f.convergence[f.n_convergence - 1];
    assert_int_equal(last->n, 512);
    const double ratio = (first->share.high - first->share.low) / (last->share.high - last->share.low);
    check_between(ratio, 0.7 * sqrt(512.0 / (double)first->n), 1.3 * sqrt(512.0 / (double)first->n));
    hawser_study *const again = study_open(scratch_path("study.yaml"));
    char *text;
    hawser_error err;
    assert_int_equal(hawser_study_answer(again, HAWSER_TABLE, &text, &err), HAWSER_ERR_INPUT);
    assert_int_equal(hawser_study_run(again, scratch_path("limit"), NULL, &err), HAWSER_OK); /* nothing is open */
    assert_int_equal(hawser_study_answer(again, HAWSER_TABLE, &text, &err), HAWSER_OK);
    check_has(text, "P(NOT SAFE) is at least "); /* friction at rest is assumed: none of them is SAFE for certain */
    check_has(text, ", limited by winch in ");
    hawser_text_free(text);
    assert_int_equal(hawser_study_answer(again, HAWSER_CSV, &text, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "samples.csv");
    hawser_study_free(again);
    clear(s, &rows, &f);
}

/* Runs are made where theory is within a tenth of the limit, and nowhere else; their verdict counts. */
/* Where some limits cannot be judged, samples that break none of the others are no answer by themselves, but without
 * them all that is judged would be broken: the share is of both, and a least one. */
TEST(limits_that_are_not_judged)
{
    static const char text[] = "case: " HAWSER_SOURCE_DIR "/cases/huangjiahu.yaml\n"
                               "set: {limits: \"{winch_capacity: 15 kN}\"}\n"
                               "parameters: {friction.mu: {uniform: {from: 0.1, to: 0.3}}}\n"
                               "monte-carlo: {samples: 64}\n";
    hawser_study *const s = study_open(scratch_write("study.yaml", text));
    const hawser_study_options options = {.jobs = 1, .fresh = 1};
    hawser_error err;
    char *said;
    Study *read;
    Rows rows;
    if (hawser_study_run(s, scratch_path("open"), &options, &err)) fail_msg("%s", err.message);
    assert_int_equal(hawser_study_answer(s, HAWSER_TABLE, &said, &err), HAWSER_OK);
    check_has(said, "P(NOT SAFE) is at least");
    check_has(said, "break no limit that could be judged");
    hawser_text_free(said);
    hawser_study_free(s);
    rows_of("open", &read, &rows);
    Findings f;
    assert_int_equal(findings_make(read, &rows, &f, &err), HAWSER_OK);
    assert_int_equal(f.by_verdict[VERDICT_SAFE], 0);
    assert_int_equal(f.held + f.by_verdict[VERDICT_NOT_SAFE], 64);
    check_close(f.not_safe.value, (double)f.by_verdict[VERDICT_NOT_SAFE] / 64, 1e-12);
    check_between(f.not_safe.value, 0.2, 0.95);
    clear(read, &rows, &f);
}

/* A sample near the winch's limit is not safe where nothing is known of the pull: no limit of that was given; nor where
 * friction at rest and back tension are assumed, which those farther from the limit are not called safe with either. */
TEST(close_to_a_limit_and_not_judged)
{
    static const char text[] = "case: " HAWSER_SOURCE_DIR "/tests/data/cli-pull.yaml\n"
                               "fidelity: run\n"
                               "set: {limits.winch_capacity: 300 N, chain.0.segment: 250 mm, "
                               "run.steady_from: 1500 ms%s}\n"
                               "parameters: {friction.mu: {steps: {from: 0.13, to: 0.15, count: 11}}}\n"
                               "grid: [friction.mu]\n";
    const hawser_study_options options = {.jobs = 1, .fresh = 1};
    for (int judged = 0; judged < 2; judged++) {
        char filled[600];
        snprintf(filled, sizeof filled, text,
                 judged ? ", limits.conductor: \"{material: copper, area: 800 mm2}\"" : "");
        hawser_study *const s = study_open(scratch_write("study.yaml", filled));
        hawser_error err;
        Study *read;
        Rows rows;
        if (hawser_study_run(s, scratch_path("near"), &options, &err)) fail_msg("%s", err.message);
        hawser_study_free(s);
        Findings f = findings_in("near", &read, &rows);
        assert_int_equal(f.by_verdict[VERDICT_SAFE], 0);
        assert_int_equal(f.by_verdict[VERDICT_SAFE_ONLY_IF] > 0, judged);
        assert_int_equal(f.by_verdict[VERDICT_NOT_JUDGED] > 0, !judged);
        assert_true(f.by_verdict[VERDICT_NOT_SAFE] > 0);
        assert_int_equal(f.by_verdict[VERDICT_NOT_TRUSTED], 0);
        clear(read, &rows, &f);
    }
}

TEST(theory_and_runs)
{
    study_compute("fidelity: both\nclose: 0.1\n"
                  "parameters: {friction.mu: {values: [0.1, 0.145, 0.15, 0.16, 0.3]}}\ngrid: [friction.mu]\n"
                  "quantities: {theory: [reference_total_N], run: [pull_force.peak_N]}\n",
                  "both", 2);
    Study *s;
    Rows rows;
    Findings f = findings_in("both", &s, &rows);
    for (int i = 0; i < 5; i++) {
        const int near = i >= 1 && i <= 3;
        assert_int_equal(rows.row[i].answered, near ? BY_RUN : BY_THEORY);
        assert_int_equal(isfinite(rows.value[2 * i + 1]) != 0, near);
        check_finite(rows.value[2 * i]);
    }
    assert_int_equal(f.runs, 3);
    /* three runs near a limit say nothing of the five: they have no statistics, and theory has */
    assert_int_equal(f.quantity[0].spread.n, 5);
    assert_int_equal(f.quantity[1].spread.n, 0);
    check_nan(f.quantity[1].spread.mean);
    for (int k = 0; k < f.n_limits; k++) {
        const int runs_alone = strcmp(f.limit[k].name, "roller_peak") == 0 || strcmp(f.limit[k].name, "alpha") == 0;
        assert_int_equal(isnan(f.limit[k].share.value) != 0, runs_alone);
    }
    assert_int_equal(rows.row[0].verdict,
                     VERDICT_SAFE_ONLY_IF); /* with friction at rest 1.5 times as large it breaks */
    assert_int_equal(rows.row[4].verdict, VERDICT_NOT_SAFE);
    size_t size;
    char *const csv = bytes_of("both", "samples.csv", &size);
    check_has(
        csv,
        "sample,friction.mu,answered_by,verdict,limited_by,state,theory: reference_total_N,run: pull_force.peak_N,");
    check_has(csv, "\n0,0.1,theory,SAFE ONLY IF,winch,done,");
    free(csv);
    clear(s, &rows, &f);
}

/* A pull in proportion to friction, uniform from 0.1 to 0.4, with a parameter that does nothing: the tenths lie at
 * 0.115 and 0.385, ten parts at 0.115, 0.145 ...; the page shows it. */
TEST(tornado_and_responses)
{
    study_compute("parameters:\n"
                  "  cables.power.EI: {uniform: {from: 5 kN m2, to: 20 kN m2}}\n"
                  "  friction.mu: {uniform: {from: 0.1, to: 0.4}}\n"
                  "monte-carlo: {samples: 256}\nquantities: [reference_total_N]\n",
                  "swings", 2);
    Study *s;
    Rows rows;
    Findings f = findings_in("swings", &s, &rows);
    double x[2];
    row_point(s, &rows, 0, x);
    const double slope = rows.value[0] / x[1];
    assert_int_equal(f.n_tornado, 2);
    assert_string_equal(f.tornado[0].name, "friction.mu");
    check_close(f.tornado[0].low, slope * 0.115, slope * 0.001);
    check_close(f.tornado[0].high, slope * 0.385, slope * 0.001);
    check_share(f.tornado[0].rank, 1, 1e-12);
    check_at_most(fabs(f.tornado[1].rank), 0.1);
    assert_int_equal(f.n_responses, 20);
    for (int k = 0; k < 10; k++) {
        const ResponseRow *const r = &f.response[10 + k];
        check_close(r->at, 0.115 + 0.03 * k, 0.001);
        check_share(r->mean, slope * r->at, 1e-9);
        check_between(r->high - r->low, slope * 0.024, slope * 0.03);
    }
    size_t size;
    char *const page = bytes_of("swings", "study.html", &size);
    check_has(page, "<title>Tornado: mean from the lowest to the highest tenth (blue: it rises)</title>");
    check_has(page, "<title>reference_total_N over friction.mu</title>");
    check_has(page, "How the probability settles");
    free(page);
    clear(s, &rows, &f);
}

/* Pilots find the band themselves: the verdicts are those of a study that runs everything, by fewer runs. */
TEST(pilots_find_the_band)
{
    static const char lines[] = "case: " HAWSER_SOURCE_DIR "/tests/data/cli-pull.yaml\n"
                                "set: {route.pieces.row.straight: 12.2 m, run.duration: 3 s, run.steady_from: 2 s, "
                                "limits.winch_capacity: 600 N, limits.alpha: 2, limits.conductor: \"{material: copper, "
                                "area: 800 mm2}\"}\n"
                                "parameters: {friction.mu: {uniform: {from: 0.05, to: 0.6}}}\n"
                                "monte-carlo: {samples: 32}\n";
    char text[1000];
    Study *s[2];
    Rows rows[2];
    Findings f[2];
    static const char *const by[] = {"fidelity: auto\npilot: 6\n", "fidelity: run\n"}, *const dir[] = {"auto", "all"};
    for (int k = 0; k < 2; k++) {
        snprintf(text, sizeof text, "%s%s", lines, by[k]);
        hawser_study *const run = study_open(scratch_write("study.yaml", text));
        assert_int_equal(hawser_study_run(run, scratch_path(dir[k]), NULL, NULL), HAWSER_OK);
        hawser_study_free(run);
        f[k] = findings_in(dir[k], &s[k], &rows[k]);
    }
    double band[LIMIT_KINDS], most = 0;
    pilots_bands(s[0], &rows[0], band);
    for (int i = 0; i < 6; i++)
        most = fmax(most, fabs(rows[0].row[i].theory[HAWSER_LIMIT_WINCH] - rows[0].row[i].margin[HAWSER_LIMIT_WINCH]));
    check_share(band[HAWSER_LIMIT_WINCH], 1.5 * most, 1e-12);
    check_equal(band[HAWSER_LIMIT_SPEED], 0);
    for (int i = 0; i < 32; i++) assert_int_equal(rows[0].row[i].verdict, rows[1].row[i].verdict);
    check_between((double)f[0].runs, 6, 26);
    /* what runs say is told of the pilots, a fair draw, not of those near a limit */
    for (int q = 2; q < 4; q++) {
        double mean = 0;
        for (int i = 0; i < 6; i++) mean += rows[1].value[i * rows[1].width + q - 2] / 6;
        assert_int_equal(f[0].quantity[q].spread.n, 6);
        check_share(f[0].quantity[q].spread.mean, mean, 1e-9);
        assert_int_equal(f[1].quantity[q - 2].spread.n, 32);
    }
    check_at_most(f[0].off[HAWSER_LIMIT_WINCH], band[HAWSER_LIMIT_WINCH]);
    for (int i = 0; i < 6; i++) rows[0].row[i].answered = BY_THEORY;
    pilots_bands(s[0], &rows[0], band);
    check_at_least(band[HAWSER_LIMIT_PULL], 1e3); /* no pilot says anything: all are run */
    rows[0].row[2].answered = BY_RUN;
    pilots_bands(s[0], &rows[0], band);
    check_at_most(band[HAWSER_LIMIT_PULL], 1);
    rows[0].row[2].theory[HAWSER_LIMIT_ALPHA] = NAN;
    rows[0].row[2].margin[HAWSER_LIMIT_ALPHA] = -0.1; /* broken, and theory does not see it */
    pilots_bands(s[0], &rows[0], band);
    check_at_least(band[HAWSER_LIMIT_PULL], 1e3);
    for (int k = 0; k < 2; k++) clear(s[k], &rows[k], &f[k]);
}

/* Parameters of a few values: those that share one share their rank and their mean, so that one that does nothing has a
 * swing and a correlation of none, in whatever order its samples come. */
TEST(ties_in_a_grid)
{
    study_compute("parameters:\n"
                  "  friction.mu: {values: [0.1, 0.2, 0.3, 0.4]}\n"
                  "  cables.power.EI: {values: [5 kN m2, 10 kN m2]}\n"
                  "grid: [friction.mu, cables.power.EI]\nquantities: [reference_total_N]\n",
                  "ties", 2);
    Study *s;
    Rows rows;
    Findings f = findings_in("ties", &s, &rows);
    const double least = rows.value[0], most = rows.value[7];
    assert_int_equal(f.n_tornado, 2);
    assert_string_equal(f.tornado[0].name, "friction.mu");
    check_share(f.tornado[0].low, least, 1e-12);
    check_share(f.tornado[0].high, most, 1e-12);
    check_share(f.tornado[0].rank, 1, 1e-12);
    check_at_most(f.tornado[1].swing, 1e-6 * most);
    check_at_most(fabs(f.tornado[1].rank), 1e-9);
    clear(s, &rows, &f);
}

/* The pull W mu with independent factors: variances of a product. mass 18..22, mu 0.1..0.3; the third does nothing. */
TEST(indices_of_a_pull)
{
    study_compute("parameters:\n"
                  "  friction.mu: {uniform: {from: 0.1, to: 0.3}}\n"
                  "  cables.power.mass: {uniform: {from: 18 kg/m, to: 22 kg/m}}\n"
                  "  cables.power.EI: {uniform: {from: 5 kN m2, to: 20 kN m2}}\n"
                  "sensitivity: {samples: 256, seed: 2}\nquantities: [reference_total_N]\n",
                  "indices", 2);
    Study *s;
    Rows rows;
    Findings f = findings_in("indices", &s, &rows);
    const double a = 0.2 * 0.2 / 12 / 0.04, b = 4.0 * 4 / 12 / 400, all = (1 + a) * (1 + b) - 1;
    const double first[3] = {a / all, b / all, 0}, total[3] = {(a + a * b) / all, (b + a * b) / all, 0};
    assert_int_equal(f.n_effects, 3);
    for (int j = 0; j < 3; j++) {
        check_close(f.effect[j].index.first, first[j], 0.02);
        check_close(f.effect[j].index.total, total[j], 0.02);
    }
    check_equal(f.effect[2].index.total, 0);
    clear(s, &rows, &f);
}

TEST_GROUP(scratch_make, scratch_remove)
