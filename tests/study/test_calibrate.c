/* Logs made of theory with noise, drop-outs and a pause give the parameters back within their intervals; what a log
 * cannot tell is said; and a calibration that was killed goes on. */
#include <jansson.h>
#include <math.h>

#include "io/api/api_handles.h"
#include "study/maths.h"
#include "tests/study/study_fixture.h"

#define CASE HAWSER_SOURCE_DIR "/cases/huangjiahu.yaml"

/* Theory's force by the head's place. */
typedef struct Truth {
    int n;
    double at[1400], force[1400], restart[1400];
} Truth;

/* A case with n settings. */
static hawser_case *case_with(const char *file, const char *const (*set)[2], int n)
{
    hawser_case *c;
    hawser_error err;
    if (hawser_case_load(file, &c, &err)) fail_msg("%s", err.message);
    for (int k = 0; k < n; k++) {
        if (hawser_case_set(c, set[k][0], set[k][1], &err)) fail_msg("%s", err.message);
    }
    return c;
}

static Truth truth_of(const char *const (*set)[2], int n)
{
    static const char *const heads[] = {"heads", NULL};
    const TheoryWish wish = {.table = heads, .no_inverse = 1};
    Truth t = {0};
    hawser_error err;
    json_t *answer, *row;
    size_t i;
    hawser_case *const c = case_with(CASE, set, n);
    if (case_theory_values(c, &wish, &answer, &err)) fail_msg("%s", err.message);
    json_array_foreach(json_object_get(answer, "heads"), i, row)
    {
        if (strcmp(json_string_value(json_object_get(row, "direction")), "forward") != 0) continue;
        t.at[t.n] = json_number_value(json_object_get(row, "head_m"));
        t.force[t.n] = json_number_value(json_object_get(row, "force_N"));
        t.restart[t.n++] = json_number_value(json_object_get(row, "restart_N"));
    }
    json_decref(answer);
    hawser_case_free(c);
    return t;
}

static double between(const Truth *t, const double *force, double at)
{
    int k = 1;
    while (k < t->n - 1 && t->at[k] < at) k++;
    const double width = t->at[k] - t->at[k - 1];
    return width > 0 ? force[k - 1] + (force[k] - force[k - 1]) * (at - t->at[k - 1]) / width : force[k];
}

static double noise(uint64_t seed, uint64_t i)
{
    const double u = random_uniform(seed, RANDOM_POINT, i, 0), v = random_uniform(seed, RANDOM_POINT, i, 1);
    return sqrt(-2 * log(u)) * cos(2 * M_PI * v);
}

/* Two readings a metre and more: noise of 150 N, one in fifty without force, one in fifty empty, a rest at 25 m. */
static void log_make(const Truth *t, uint64_t seed)
{
    FILE *const f = fopen(scratch_path("pull.csv"), "w");
    double time = 0;
    assert_non_null(f);
    fprintf(f, "time [s];winch pull [kN];length [m]\n");
    for (uint64_t i = 0; i < 580; i++) {
        const double at = 0.1 * (double)i, luck = random_uniform(seed, RANDOM_TAIL, i, 0);
        if (i == 250) {
            for (int k = 0; k < 40; k++, time++) fprintf(f, "%.0f;2.1;%.2f\n", time, at);
            fprintf(f, "%.0f;%.4f;%.2f\n", time++, between(t, t->restart, at) / 1000, at + 0.02);
        }
        const double force = luck < 0.02 ? 0 : between(t, t->force, at) / 1000 + 0.15 * noise(seed, i);
        if (luck > 0.98) fprintf(f, "%.0f;;%.2f\n", time++, at + 0.03);
        if (luck <= 0.98) fprintf(f, "%.0f;%.4f;%.2f\n", time++, force, at + 0.03);
    }
    fclose(f);
}

static Findings calibrate(const char *lines, const char *dir, Study **s, Rows *rows)
{
    char text[2000];
    hawser_error err;
    Findings f;
    snprintf(text, sizeof text, "case: " CASE "\n%s", lines);
    hawser_study *const study = study_open(scratch_write("study.yaml", text));
    const hawser_study_options options = {.jobs = 1, .fresh = 1};
    if (hawser_study_run(study, scratch_path(dir), &options, &err)) fail_msg("%s", err.message);
    hawser_study_free(study);
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

/* 40 logs: each interval of friction and back tension has the truth inside as often as 95 % may miss. */
TEST(intervals_cover)
{
    static const char *const set[][2] = {{"friction.mu", "0.17"}, {"drive.tail.tension", "6.2 kN"}};
    const Truth t = truth_of(set, 2);
    int inside[2] = {0};
    for (uint64_t seed = 1; seed <= 20; seed++) {
        Study *s;
        Rows rows;
        log_make(&t, seed);
        Findings f = calibrate("parameters:\n  friction.mu: {range: {from: 0.05, to: 0.5}}\n"
                               "  tail: {key: drive.tail.tension, range: {from: 2 kN, to: 12 kN}}\n"
                               "calibrate: {log: pull.csv, head: -0.03 m, from: 0 m}\n",
                               "cover", &s, &rows);
        assert_true(f.fit.done);
        assert_int_equal(f.n_warnings, 0);
        char answer[ANSWER_MAX];
        findings_answer(s, &f, answer);
        check_has(answer, "\n  log      Force from column 'winch pull [kN]'\n");
        check_at_most(f.fit.half[0], 0.006);
        check_at_most(f.fit.half[1], 0.1);
        inside[0] += fabs(f.fit.x[0] - 0.17) <= f.fit.half[0];
        inside[1] += fabs(f.fit.x[1] - 6.2) <= f.fit.half[1];
        clear(s, &rows, &f);
    }
    for (int j = 0; j < 2; j++) check_at_least(inside[j], 17); /* fewer once in 60 */
}

/* Friction on two stretches, each its own, and what it takes to break away. */
TEST(stretches_and_dry_start)
{
    static const char *const set[][2] = {
        {"theory.stretches", "[{from: 0 m, to: 30 m, mu: 0.12, mu_s: 0.21}, {from: 30 m, to: 58.5 m, mu: 0.2}]"}};
    const Truth t = truth_of(set, 1);
    Study *s;
    Rows rows;
    log_make(&t, 3);
    Findings f =
        calibrate("set: {theory.stretches: \"[{from: 0 m, to: 30 m, mu: 0.1, mu_s: 0.1}, {from: 30 m, to: 58.5 m, "
                  "mu: 0.1}]\"}\n"
                  "parameters:\n"
                  "  first: {key: theory.stretches.0.mu, range: {from: 0.05, to: 0.5}}\n"
                  "  dry: {key: theory.stretches.0.mu_s, range: {from: 0.05, to: 0.6}}\n"
                  "  second: {key: theory.stretches.1.mu, range: {from: 0.05, to: 0.5}}\n"
                  "calibrate: {log: pull.csv, head: -0.03 m, from: 0 m, starts: true}\n",
                  "stretches", &s, &rows);
    const double truth[3] = {0.12, 0.21, 0.2};
    assert_true(f.fit.done);
    for (int j = 0; j < 3; j++) check_at_most(fabs(f.fit.x[j] - truth[j]), f.fit.half[j]);
    check_at_most(f.fit.half[0], 0.01);
    check_at_most(f.fit.half[2], 0.02);
    clear(s, &rows, &f);
}

/* The drag of the rope adds the same force everywhere as... nothing else does quite; rope weight and its friction are
 * one product. */
TEST(not_told_apart)
{
    static const char *const set[][2] = {{"theory.rope_mass", "6 kg/m"}, {"theory.rope_mu", "0.3"}};
    const Truth t = truth_of(set, 2);
    Study *s;
    Rows rows;
    log_make(&t, 5);
    Findings f = calibrate("set: {theory.rope_mass: 4 kg/m, theory.rope_mu: 0.2}\n"
                           "parameters:\n"
                           "  rope: {key: theory.rope_mass, range: {from: 0.5 kg/m, to: 20 kg/m}}\n"
                           "  drag: {key: drive.rope_drag.force, range: {from: 0 N, to: 6000 N}}\n"
                           "  tail: {key: drive.tail.tension, range: {from: 2 kN, to: 12 kN}}\n"
                           "  reel: {key: theory.feed, range: {from: 0 N, to: 3000 N}}\n"
                           "calibrate: {log: pull.csv, head: -0.03 m, from: 0 m}\n",
                           "twins", &s, &rows);
    assert_true(f.fit.done);
    int said = 0;
    for (int k = 0; k < f.n_warnings; k++) said |= strstr(f.warning[k], "tail and reel cannot be separated") != NULL;
    assert_true(said);
    clear(s, &rows, &f);
}

/* Twice the same, by one worker or four, whole or from the samples of a start before. */
TEST(goes_on)
{
    static const char *const set[][2] = {{"friction.mu", "0.17"}};
    const Truth t = truth_of(set, 1);
    const char *const text = "case: " CASE "\nparameters: {friction.mu: {range: {from: 0.05, to: 0.5}}}\n"
                             "calibrate: {log: pull.csv}\n";
    hawser_error err;
    log_make(&t, 8);
    for (int k = 0; k < 3; k++) {
        hawser_study *const s = study_open(scratch_write("study.yaml", text));
        const hawser_study_options options = {.jobs = k == 1 ? 4 : 1};
        const char *const dir = k == 0 ? "whole" : "again";
        if (hawser_study_run(s, scratch_path(dir), &options, &err)) fail_msg("%s", err.message);
        hawser_study_free(s);
        expect_alike("whole", dir);
        char path[200];
        snprintf(path, sizeof path, "%s/workers/worker-0.rows", scratch_path(dir));
        if (k == 1) assert_int_equal(truncate(path, 3000), 0);
    }
}

/* ------------------------------------------------------------------------------------------------------- by runs */

#define HILL_CASE HAWSER_SOURCE_DIR "/tests/data/cli-pull.yaml"

/* A short pull from the level up a hill: friction and mass each do something else along it. */
static const char HILL[] = "[{straight: 30 m, name: row}, {bend: 35 deg, radius: 9 m, plane: up}, {straight: 12 m}]",
                  LEVEL[] = "[{straight: 48 m, name: row}]";
static const char *const pull[][2] = {{"drive.winch.speed", "30 m/min"},
                                      {"run.duration", "13 s"},
                                      {"run.steady_from", "2 s"},
                                      {"route.head_at", "36 m"},
                                      {"chain", "[{cable: power, length: 20 m, segment: 500 mm}]"}};
enum { PULL = sizeof pull / sizeof *pull };

/* The run's force with these values, every 10 ms, by the place of the cable's head. */
static Truth run_truth(const char *route, const char *mu, const char *mass)
{
    const char *set[PULL + 3][2] = {{"route.pieces", route}, {"friction.mu", mu}, {"cables.power.mass", mass}};
    memcpy(&set[3], pull, sizeof pull);
    Truth t = {0};
    hawser_sim *sim;
    hawser_error err;
    hawser_case *const c = case_with(HILL_CASE, set, PULL + 3);
    if (hawser_sim_new(c, NULL, &sim, &err) || hawser_sim_relax(sim, NULL, &err)) fail_msg("%s", err.message);
    for (double time = 0.01; time < 12.99; time += 0.01) {
        if (hawser_sim_advance(sim, time, 0, &err)) fail_msg("%s", err.message);
        const hawser_sample *const now = hawser_sim_sample(sim);
        t.at[t.n] = 36 + now->winch_travel;
        t.force[t.n++] = now->winch_force;
    }
    hawser_sim_free(sim);
    hawser_case_free(c);
    return t;
}

/* Readings every 2 cm from a metre on, with noise of 1 %, drop-outs, gaps and a rest. */
static void run_log(const Truth *t, uint64_t seed)
{
    FILE *const f = fopen(scratch_path("pull.csv"), "w");
    double time = 0;
    assert_non_null(f);
    fprintf(f, "time [s],force [N],length [m]\n");
    for (uint64_t i = 0; i < 220; i++) {
        const double length = 1.2 + 0.02 * (double)i, luck = random_uniform(seed, RANDOM_TAIL, i, 0);
        for (int k = 0; i == 100 && k < 40; k++, time++) fprintf(f, "%.0f,120,%.3f\n", time, length);
        const double force = luck < 0.02 ? 0 : between(t, t->force, 36 + length) * (1 + 0.01 * noise(seed, i));
        if (luck <= 0.98) fprintf(f, "%.0f,%.3f,%.3f\n", time, force, length);
        time++;
    }
    fclose(f);
}

static Findings calibrate_runs(const char *route, const char *lines, const char *dir, Study **s, Rows *rows)
{
    char text[2000];
    hawser_error err;
    Findings f;
    int n = snprintf(text, sizeof text, "case: " HILL_CASE "\nset:\n  route.pieces: \"%s\"\n", route);
    for (int i = 0; i < PULL; i++)
        n += snprintf(text + n, sizeof text - (size_t)n, "  %s: \"%s\"\n", pull[i][0], pull[i][1]);
    snprintf(text + n, sizeof text - (size_t)n, "%s", lines);
    hawser_study *const study = study_open(scratch_write("study.yaml", text));
    const hawser_study_options options = {.jobs = 1, .fresh = 1};
    if (hawser_study_run(study, scratch_path(dir), &options, &err)) fail_msg("%s", err.message);
    hawser_study_free(study);
    rows_of(dir, s, rows);
    assert_int_equal(findings_make(*s, rows, &f, &err), HAWSER_OK);
    return f;
}

static Findings fit_hill(const char *fidelity, Study **s, Rows *rows)
{
    char text[500];
    snprintf(text, sizeof text,
             "fidelity: %s\nparameters:\n  friction.mu: {range: {from: 0.1, to: 0.5}}\n"
             "  mass: {key: cables.power.mass, range: {from: 10 kg/m, to: 40 kg/m}}\n"
             "calibrate: {log: pull.csv, head: 36 m, parts: 40}\n",
             fidelity);
    return calibrate_runs(HILL, text, fidelity, s, rows);
}

/* Logs that a run has made, with noise, drop-outs and a rest, give friction and mass back within their intervals, as
 * often as 95 % may miss; and to the same from where theory's fit has ended. */
TEST(runs_give_them_back)
{
    const Truth t = run_truth(HILL, "0.23", "21 kg/m");
    int inside[2] = {0};
    Study *s;
    Rows rows;
    for (uint64_t seed = 4; seed < 7; seed++) {
        run_log(&t, seed);
        Findings f = fit_hill("run", &s, &rows);
        assert_true(f.fit.done);
        assert_int_equal(f.n_warnings, 0);
        check_at_most(f.fit.half[0], 0.006);
        check_at_most(f.fit.half[1], 0.25);
        inside[0] += fabs(f.fit.x[0] - 0.23) <= f.fit.half[0];
        inside[1] += fabs(f.fit.x[1] - 21) <= f.fit.half[1];
        if (seed == 6) {
            Study *both;
            Rows others;
            Findings g = fit_hill("both", &both, &others);
            for (int j = 0; j < 2; j++) check_at_most(fabs(g.fit.x[j] - f.fit.x[j]), f.fit.half[j] / 2);
            assert_int_equal(others.row[0].answered, BY_THEORY);
            assert_int_equal(others.row[g.fit_sample].answered, BY_RUN);
            clear(both, &others, &g);
        }
        clear(s, &rows, &f);
    }
    for (int j = 0; j < 2; j++) check_at_least(inside[j], 2); /* fewer once in 140 */
}

/* Friction and back tension on a level: one makes up for the other. And a run that does not come as far as the log. */
TEST(runs_cannot_tell)
{
    const Truth t = run_truth(LEVEL, "0.23", "21 kg/m");
    Study *s;
    Rows rows;
    run_log(&t, 5);
    Findings f = calibrate_runs(LEVEL,
                                "fidelity: run\nparameters:\n"
                                "  reel: {key: drive.tail.tension, range: {from: 1 N, to: 900 N}}\n"
                                "  drag: {key: drive.rope_drag.force, range: {from: 1 N, to: 900 N}}\n"
                                "calibrate: {log: pull.csv, head: 36 m, parts: 20}\n",
                                "twins", &s, &rows);
    int said = 0;
    for (int k = 0; k < f.n_warnings; k++) said |= strstr(f.warning[k], "reel") && strstr(f.warning[k], "drag");
    assert_true(said);
    clear(s, &rows, &f);
    f = calibrate_runs(LEVEL,
                       "fidelity: run\nparameters: {friction.mu: {range: {from: 0.1, to: 0.5}}}\n"
                       "calibrate: {log: pull.csv, head: 30 m}\n",
                       "beyond", &s, &rows);
    assert_false(f.fit.done);
    assert_int_equal(rows.row[0].state, ROW_FAILED);
    check_has(rows.row[0].reason, "along the route, the log at 31.");
    clear(s, &rows, &f);
}

TEST(refused)
{
    static const char *const wrong[][2] = {
        {"calibrate: {log: nowhere.csv}\n", "nowhere.csv"},
        {"fidelity: run\ncalibrate: {log: pull.csv, starts: true}\n", "a run does not rest where the log does"},
        {"fidelity: auto\ncalibrate: {log: pull.csv}\n", "a search has no pilots"},
        {"calibrate: {log: pull.csv, from: 500 m}\n", "the log has no lengths within 'from' and 'to'"},
    };
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        char text[600];
        hawser_study *s;
        hawser_error err = {HAWSER_OK, ""};
        snprintf(text, sizeof text, "case: " CASE "\nparameters: {friction.mu: {range: {from: 0.1, to: 0.4}}}\n%s",
                 wrong[k][0]);
        assert_int_equal(hawser_study_load(scratch_write("study.yaml", text), &s, &err), HAWSER_ERR_INPUT);
        check_has(err.message, wrong[k][1]);
    }
}

/* A length that is wrong once is no place: the parts are those of the others. */
TEST(wrong_length)
{
    static const char *const set[][2] = {{"friction.mu", "0.17"}};
    const Truth t = truth_of(set, 1);
    FILE *const f = fopen(scratch_path("pull.csv"), "w");
    assert_non_null(f);
    fprintf(f, "time [s];pull [kN];length [m]\n");
    for (int i = 0; i < 580; i++)
        fprintf(f, "%d;%.4f;%.2f\n", i, between(&t, t.force, 0.1 * i) / 1000, 0.1 * i + (i == 300 ? 5000 : 0));
    fclose(f);
    Study *s;
    Rows rows;
    Findings found = calibrate("parameters:\n  friction.mu: {range: {from: 0.05, to: 0.5}}\n"
                               "calibrate: {log: pull.csv, from: 0 m}\n",
                               "wrong", &s, &rows);
    char *const summary = bytes_of("wrong", "summary.json", &(size_t){0});
    check_has(summary,
              "\"notes\": \"Force from column 'pull [kN]'; Single lengths far off their neighbours are lost: 1,");
    free(summary);
    assert_int_equal(s->measured.n, 100);
    assert_int_equal(s->measured.lost, 1);
    check_close(found.fit.x[0], 0.17, 1e-3);
    clear(s, &rows, &found);
}

TEST_GROUP(scratch_make, scratch_remove)
