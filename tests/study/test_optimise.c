/* Searches over cases: a layout of rollers whose best is known, the same bytes for any number of workers, kills in
 * between, samples that hang, and what is said of a search that makes no sense. */
#include <signal.h>
#include <sys/wait.h>
#include <time.h>

#include "tests/study/study_fixture.h"

/* Rows bear the cable one by one: each needs so many rollers that its own margin is not negative, and no more. */
static const char layout[] = "case: " HAWSER_SOURCE_DIR "/tests/data/study-layout.yaml\n"
                             "parameters:\n"
                             "  first: {key: rollers.along.0.count, whole: {from: 4, to: 40}}\n"
                             "  bend: {key: rollers.along.1.count, whole: {from: 4, to: 30}}\n"
                             "  last: {key: rollers.along.2.count, whole: {from: 4, to: 20, start: 18}}\n"
                             "optimise: {least: {first: 1, bend: 1, last: 1}, evaluations: 250, searches: 4}\n";

static void compute(const char *path, const char *dir, int jobs)
{
    hawser_error err;
    hawser_study *const s = study_open(path);
    const hawser_study_options options = {.jobs = jobs};
    if (hawser_study_run(s, scratch_path(dir), &options, &err)) fail_msg("%s", err.message);
    hawser_study_free(s);
}

/* 196.2 N/m over 30 m, 500 N a roller, 1.6 times the load: 20 rollers at least. The other rows by trying each number.
 */
TEST(planted_layout)
{
    double needed[3] = {0};
    for (int k = 0; k < 3; k++) {
        char text[600], dir[16];
        Study *s;
        Rows rows;
        snprintf(text, sizeof text,
                 "case: " HAWSER_SOURCE_DIR "/tests/data/study-layout.yaml\n"
                 "parameters: {n: {key: rollers.along.%d.count, steps: {from: 4, to: 30, count: 27}}}\ngrid: [n]\n",
                 k);
        snprintf(dir, sizeof dir, "row%d", k);
        compute(scratch_write("study.yaml", text), dir, 1);
        rows_of(dir, &s, &rows);
        for (long i = 26; i >= 0 && rows.row[i].verdict == VERDICT_SAFE; i--) needed[k] = 4 + (double)i;
        rows_free(&rows);
        study_free(s);
    }
    check_equal(needed[0], ceil(196.2 * 30 / (500 / 1.6)) + 1);
    compute(scratch_write("study.yaml", layout), "layout", 2);
    Study *s;
    Rows rows;
    Findings f;
    rows_of("layout", &s, &rows);
    assert_int_equal(findings_make(s, &rows, &f, NULL), HAWSER_OK);
    assert_int_equal(s->aim.method, SEARCH_RANDOM);
    assert_string_equal(s->aim.name, "first + bend + last");
    check_equal(f.design[0].value, needed[0] + needed[1] + needed[2]);
    check_equal(f.design[0].broken, 0);
    double x[3];
    row_point(s, &rows, f.design[0].sample, x);
    for (int k = 0; k < 3; k++) check_equal(x[k], needed[k]);
    findings_free(&f);
    rows_free(&rows);
    study_free(s);
}

TEST(workers_alike)
{
    compute(scratch_write("study.yaml", layout), "one", 1);
    compute(scratch_path("study.yaml"), "two", 2);
    compute(scratch_path("study.yaml"), "four", 4);
    expect_alike("one", "two");
    expect_alike("one", "four");
    expect_alike("one", "layout");
}

/* Bytes in the workers' files of folder/DIR; a row of the layout has a quantity of its own and two usual ones. */
TEST(killed_and_resumed)
{
    hawser_study *const s = study_open(scratch_write("study.yaml", layout));
    const hawser_study_options options = {.jobs = 2};
    for (int k = 0; k < 12; k++) {
        const pid_t pid = fork();
        if (pid == 0) _exit(hawser_study_run(s, scratch_path("killed"), &options, NULL) != HAWSER_OK);
        const struct timespec t = {.tv_nsec = (20 + 37 * k % 101) * 1000000L};
        nanosleep(&t, NULL);
        kill(pid, SIGKILL);
        waitpid(pid, NULL, 0);
        nanosleep(&(struct timespec){.tv_nsec = 2000000}, NULL); /* its workers end with it */
    }
    hawser_study_free(s);
    compute(scratch_path("study.yaml"), "killed", 2);
    expect_alike("one", "killed");
}

/* A length that takes hours is a row with its reason, and the search goes on without it. */
TEST(hanging_samples)
{
    study_compute("fidelity: run\ntime_limit: 1 s\n"
                  "parameters: {run.duration: {values: [100000 s, 300 ms, 350 ms]}, "
                  "drive.tail.tension: {values: [0 N, 100 N]}}\n"
                  "quantities: [pull_force.peak_N]\n"
                  "optimise: {least: pull_force.peak_N, limits: false, searches: 1, evaluations: 6}\n",
                  "hanging", 1);
    Study *s;
    Rows rows;
    Findings f;
    rows_of("hanging", &s, &rows);
    assert_int_equal(findings_make(s, &rows, &f, NULL), HAWSER_OK);
    assert_int_equal(f.by_state[ROW_TIME], 2);
    assert_int_equal(f.by_state[ROW_DONE], 4);
    double x[2];
    row_point(s, &rows, f.design[0].sample, x);
    check_equal(x[1], 0);
    findings_free(&f);
    rows_free(&rows);
    study_free(s);
}

/* What is sought within constraints of its own; the answer says so first. */
TEST(constraints_of_its_own)
{
    hawser_error err;
    hawser_study *const s = study_open(
        study_write("parameters:\n"
                    "  friction.mu: {range: {from: 0.1, to: 0.4, start: 0.2}}\n"
                    "  tail: {key: drive.tail.tension, range: {from: 100 N, to: 500 N}}\n"
                    "optimise: {most: tail, constraints: [{of: reference_total_N, at_most: 550}, {of: friction.mu, "
                    "at_least: 0.11}], limits: false}\n"));
    char *text;
    assert_int_equal(hawser_study_run(s, scratch_path("own"), NULL, &err), HAWSER_OK);
    assert_int_equal(hawser_study_answer(s, HAWSER_TABLE, &text, &err), HAWSER_OK);
    /* 10 m of 20 kg/m at 0.11, and what the case's tail holds: 196.2 N/m 20 m 0.11 = 431.64 N go off */
    check_has(text, "MOST tail = 118.36");
    check_has(text, "friction.mu = 0.11, tail = 118.36 N");
    check_has(text, "linear models (COBYLA)");
    hawser_text_free(text);
    hawser_study_free(s);
}

TEST(refused)
{
    static const char head[] = "parameters: {friction.mu: {range: {from: 0.1, to: 0.4}}}\n";
    const char *const wrong[][2] = {
        {"optimise: {searches: 2}\n", "give one of least, most"},
        {"optimise: {least: [friction.mu]}\n", "expected a parameter's name, a path, or a map"},
        {"optimise: {least: nowhere}\n", "is not in the answer of theory"},
        {"optimise: {least: friction.mu, method: all}\n", "there are more points than evaluations"},
        {"optimise: {least: friction.mu, constraints: [{of: friction.mu}]}\n", "give 'at_least' or 'at_most'"},
        {"optimise: {least: friction.mu, constraints: [{of: friction.mu, at_least: 2, at_most: 1}]}\n",
         "must not be above"},
        {"optimise: {least: friction.mu}\ngrid: [friction.mu]\n", "there is a second one of these"},
        {"monte-carlo: {samples: 3}\n", "give one of uniform, normal"},
    };
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        char lines[600];
        hawser_study *s;
        hawser_error err = {HAWSER_OK, ""};
        snprintf(lines, sizeof lines, "%s%s", head, wrong[k][0]);
        assert_int_equal(hawser_study_load(study_write(lines), &s, &err), HAWSER_ERR_INPUT);
        check_has(err.message, wrong[k][1]);
    }
    const char *const ranges[][2] = {
        {"{whole: {from: 0.5, to: 2}}", "expected whole numbers"},
        {"{range: {from: 2, to: 1}}", "'from' must be below 'to'"},
        {"{range: {from: 1, to: 2, start: 3}}", "is not between 'from' and 'to'"},
        {"{uniform: {from: 1, to: 2}}", "give one of range, whole, values"},
    };
    for (size_t k = 0; k < sizeof ranges / sizeof *ranges; k++) {
        char lines[600];
        hawser_study *s;
        hawser_error err = {HAWSER_OK, ""};
        snprintf(lines, sizeof lines, "parameters: {friction.mu: %s}\noptimise: {least: friction.mu}\n", ranges[k][0]);
        assert_int_equal(hawser_study_load(study_write(lines), &s, &err), HAWSER_ERR_INPUT);
        check_has(err.message, ranges[k][1]);
    }
}

TEST_GROUP(scratch_make, scratch_remove)
