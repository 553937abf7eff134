/* Worker processes: nothing lost or double after a kill, a row with its reason for a sample that cannot be, hangs, eats
 * memory or takes its process along. That neither their number nor ranks change a byte: test_workers.c. */
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>

#include "hawser/hawser.h"
#include "tests/study/study_fixture.h"

/* Bytes in the workers' files of folder/DIR. */
static long bytes_in(const char *dir)
{
    long sum = 0;
    for (int k = 0; k < 64; k++) {
        char path[200];
        struct stat info;
        snprintf(path, sizeof path, "%s/workers/worker-%d.rows", scratch_path(dir), k);
        if (!stat(path, &info)) sum += info.st_size;
    }
    return sum;
}

static long record_bytes(int n_quantities) { return (long)(sizeof(Row) + 8 * (size_t)n_quantities + 8); }

static void pause_ms(double ms)
{
    const struct timespec t = {(time_t)(ms / 1000), (long)(fmod(ms, 1000) * 1e6)};
    nanosleep(&t, NULL);
}

/* The whole study is killed at twenty moments from its start to its end, and goes on each time. In the end every row is
 * there once, and all is as if nothing had been. */
TEST(killed_and_resumed)
{
    study_compute(drawn, "whole", 2);
    hawser_study *const s = study_open(scratch_path("study.yaml"));
    const hawser_study_options options = {.jobs = 2};
    long before = 0;
    for (int k = 0; k < 20; k++) {
        const pid_t pid = fork();
        if (pid == 0) _exit(hawser_study_run(s, scratch_path("killed"), &options, NULL) != HAWSER_OK);
        pause_ms(3 + 7 * k % 61);
        kill(pid, SIGKILL);
        waitpid(pid, NULL, 0);
        pause_ms(2); /* its workers end with it */
        const long now = bytes_in("killed");
        check_at_least((double)now, (double)before); /* nothing is thrown away but a row that was cut */
        before = now - now % record_bytes(2);
    }
    hawser_study_free(s);
    study_compute(drawn, "killed", 2);
    expect_alike("whole", "killed");
    assert_int_equal(bytes_in("killed"), 200 * record_bytes(2));
}

/* A row that is cut off in its middle, and one with a wrong bit, are computed again; rows before stay. */
TEST(damaged_files)
{
    study_compute(drawn, "sound", 1);
    study_compute(drawn, "hurt", 1);
    char path[200];
    snprintf(path, sizeof path, "%s/workers/worker-0.rows", scratch_path("hurt"));
    assert_int_equal(truncate(path, 150 * record_bytes(2) + 77), 0);
    FILE *const f = fopen(path, "r+");
    fseek(f, 120 * record_bytes(2) + 100, SEEK_SET);
    fputc(0x5A, f);
    fclose(f);
    Study *s;
    Rows rows;
    rows_of("hurt", &s, &rows);
    long there = 0;
    for (long i = 0; i < rows.n; i++) there += rows.row[i].state == ROW_DONE;
    assert_int_equal(there, 149);
    rows_free(&rows);
    study_free(s);
    study_compute(drawn, "hurt", 3);
    expect_alike("sound", "hurt");
}

/* More samples of the same study use those that are there; another study, or another base case, is refused. */
TEST(longer_and_other)
{
    char lines[1000];
    study_compute(drawn, "longer", 2);
    const long before = bytes_in("longer");
    snprintf(lines, sizeof lines, "%.*smonte-carlo: {samples: 260, seed: 3}\n", (int)(strstr(drawn, "monte") - drawn),
             drawn);
    study_compute(lines, "longer", 2);
    assert_int_equal(bytes_in("longer") - before, 60 * record_bytes(2));
    study_compute(lines, "at-once", 1);
    expect_alike("longer", "at-once");

    snprintf(lines, sizeof lines, "%.*smonte-carlo: {samples: 200, seed: 4}\n", (int)(strstr(drawn, "monte") - drawn),
             drawn);
    hawser_study *const s = study_open(study_write(lines));
    hawser_study_options options = {.jobs = 1};
    hawser_error err;
    assert_int_equal(hawser_study_run(s, scratch_path("longer"), &options, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "holds the samples of another study");
    options.fresh = 1;
    assert_int_equal(hawser_study_run(s, scratch_path("longer"), &options, &err), HAWSER_OK);
    assert_int_equal(bytes_in("longer"), 200 * record_bytes(2));
    hawser_study_free(s);
}

static void compute_here(const char *dir)
{
    const hawser_study_options options = {.jobs = 1};
    hawser_error err;
    hawser_study *const s = study_open(scratch_path("study.yaml"));
    if (hawser_study_run(s, scratch_path(dir), &options, &err)) fail_msg("%s", err.message);
    hawser_study_free(s);
}

/* The study at folder/study.yaml is refused by folder/DIR, until `name` holds `as` again. */
static void expect_changed(const char *dir, const char *name, const char *to, const char *as)
{
    const hawser_study_options options = {.jobs = 1};
    hawser_error err;
    for (int changed = 1; changed >= 0; changed--) {
        scratch_write(name, changed ? to : as);
        hawser_study *const s = study_open(scratch_path("study.yaml"));
        assert_int_equal(hawser_study_run(s, scratch_path(dir), &options, &err),
                         changed ? HAWSER_ERR_INPUT : HAWSER_OK);
        if (changed) check_has(err.message, "or the case has changed since");
        hawser_study_free(s);
    }
}

/* Files that a variant alone reads: a route, and the catalogue of an entry that the base does not take, also by way of
 * another file. */
TEST(files_of_variants)
{
    static const char *const cable = "{d: 90 mm, mass: %d kg/m, EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 6 kN m2}";
    static const char *const rest = "drive: {winch: {speed: 6 m/min, to: 1 s}, tail: {tension: 2 kN}}\n"
                                    "run: {duration: 3 s}\nfriction: {mu: 0.2}\n";
    char own[200], text[2000], light[400], heavy[400];
    snprintf(own, sizeof own, cable, 20);
    snprintf(text, sizeof text, "cables: {power: %s}\nroute: {file: a.csv}\n%s", own, rest);
    scratch_write("base.yaml", text);
    scratch_write("a.csv", "length\n50\n");
    scratch_write("b.csv", "length\n60\n");
    scratch_write("study.yaml", "case: base.yaml\nparameters: {route.file: {values: [a.csv, b.csv]}}\n"
                                "grid: [route.file]\n");
    compute_here("routes");
    expect_changed("routes", "b.csv", "length\n90\n", "length\n60\n");

    snprintf(text, sizeof text,
             "include: [first.yaml]\ncables: {power: {type: c1}}\nroute: {pieces: [{straight: 60 m}]}\n%s", rest);
    scratch_write("base.yaml", text);
    scratch_write("first.yaml", "include: second.yaml\n");
    snprintf(light, sizeof light, "cables: {c1: %s, c2: {d: 90 mm, mass: 30 kg/m, EA: 50 MN, EI: 6 kN m2}}\n", own);
    snprintf(heavy, sizeof heavy, "cables: {c1: %s, c2: {d: 90 mm, mass: 60 kg/m, EA: 50 MN, EI: 6 kN m2}}\n", own);
    scratch_write("second.yaml", light);
    scratch_write("study.yaml", "case: base.yaml\nparameters: {cables.power.type: {values: [c1, c2]}}\n"
                                "grid: [cables.power.type]\n");
    compute_here("types");
    expect_changed("types", "second.yaml", heavy, light);
}

/* A list among the files of the workers is not written over. */
TEST(what_is_read_stays)
{
    static const char list[] = "friction.mu\n0.2\n0.3\n";
    hawser_error err;
    const hawser_study_options options = {.jobs = 1};
    scratch_write("list.csv", list);
    study_compute("fidelity: theory\nlist: {file: list.csv}\n", "own", 1);
    scratch_write("own/workers/list.csv", list);
    hawser_study *const s = study_open(study_write("fidelity: theory\nlist: {file: own/workers/list.csv}\n"));
    assert_int_equal(hawser_study_run(s, scratch_path("own"), &options, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "own/workers/list.csv', which is an input");
    hawser_study_free(s);
}

/* What cannot be a case, what takes too long: rows with a reason, and the others are as ever. */
TEST(rows_with_reasons)
{
    scratch_write("list.csv", "friction.mu,run.duration\n0.2,300 ms\n-1,300 ms\n0.2,100000 s\n0.3,300 ms\n");
    study_compute("fidelity: run\nlist: {file: list.csv}\ntime_limit: 1 s\n", "slow", 2);
    Study *s;
    Rows rows;
    rows_of("slow", &s, &rows);
    assert_int_equal(rows.row[0].state, ROW_DONE);
    assert_int_equal(rows.row[1].state, ROW_REFUSED);
    check_has(rows.row[1].reason, "key 'friction.mu': value '-1' is out of range");
    assert_int_equal(rows.row[2].state, ROW_TIME);
    assert_string_equal(rows.row[2].reason, "took longer than 1 s");
    assert_int_equal(rows.row[3].state, ROW_DONE);
    size_t size;
    char *const summary = bytes_of("slow", "summary.json", &size);
    check_has(summary, "\"over_time\": 1.0");
    check_has(summary, "\"reason\": \"took longer than 1 s\"");
    free(summary);
    rows_free(&rows);
    study_free(s);
}

/* Nearly two hundred thousand segments do not go into 400 MiB; ten do. Sanitizers take more than that for themselves.
 */
TEST(too_much_memory)
{
#ifndef __SANITIZE_ADDRESS__
    scratch_write("list.csv", "chain.0.segment,run.duration\n500 mm,300 ms\n0.06 mm,300 ms\n");
    study_compute("fidelity: run\nlist: {file: list.csv}\nmemory: 400\n", "memory", 1);
    Study *s;
    Rows rows;
    rows_of("memory", &s, &rows);
    assert_int_equal(rows.row[0].state, ROW_DONE);
    assert_int_equal(rows.row[1].state, ROW_MEMORY);
    check_has(rows.row[1].reason, "out of memory");
    rows_free(&rows);
    study_free(s);
#endif
}

/* Each call ends a worker, as the system does when there is no more memory. */
static int end_a_worker(void *user, const hawser_study_state *now)
{
    int *const ended = user;
    char path[64], text[64] = "";
    (void)now;
    snprintf(path, sizeof path, "/proc/self/task/%d/children", (int)getpid());
    FILE *const f = fopen(path, "r");
    if (f && fgets(text, sizeof text, f) && *ended < 3 && !kill((pid_t)atoi(text), SIGKILL)) ++*ended;
    if (f) fclose(f);
    return 0;
}

/* Workers that die take at most one sample each along. */
TEST(workers_that_die)
{
    char lines[2000];
    int ended = 0;
    hawser_error err;
    snprintf(lines, sizeof lines, "%s", runs);
    memcpy(strstr(lines, "300 ms, 350 ms"), "300 ms, 500 s ", 14);
    hawser_study *const s = study_open(study_write(lines));
    const hawser_study_options options = {.jobs = 2, .progress = end_a_worker, .user = &ended};
    if (hawser_study_run(s, scratch_path("dying"), &options, &err)) fail_msg("%s", err.message);
    hawser_study_free(s);
    Study *study;
    Rows rows;
    int died = 0, done = 0;
    rows_of("dying", &study, &rows);
    for (long i = 0; i < rows.n; i++) {
        died += rows.row[i].state == ROW_DIED;
        done += rows.row[i].state == ROW_DONE;
        if (rows.row[i].state == ROW_DIED) check_has(rows.row[i].reason, "signal 9");
    }
    assert_int_equal(done + died, 12);
    check_at_most(died, ended);
    check_at_least(ended, 1);
    rows_free(&rows);
    study_free(study);
}

/* Whoever asked may stop; the same call goes on. */
static int stop_at_once(void *user, const hawser_study_state *now)
{
    *(hawser_study_state *)user = *now;
    return 1;
}
TEST(stopped)
{
    hawser_study_state now = {0};
    hawser_error err;
    char lines[1000];
    snprintf(lines, sizeof lines, "%.*smonte-carlo: {samples: 100000, seed: 3}\n",
             (int)(strstr(drawn, "monte") - drawn), drawn);
    hawser_study *s = study_open(study_write(lines));
    const hawser_study_options options = {.jobs = 2, .progress = stop_at_once, .user = &now};
    assert_int_equal(hawser_study_run(s, scratch_path("stopped"), &options, &err), HAWSER_STOPPED);
    check_has(err.message, "of 100000 samples: the same command goes on");
    assert_int_equal(now.samples, 100000);
    assert_int_equal(now.jobs, 2);
    char *text;
    assert_int_equal(hawser_study_answer(s, HAWSER_TABLE, &text, &err), HAWSER_OK);
    check_has(text, "of 100000, by theory");
    hawser_text_free(text);
    hawser_study_free(s);
}

TEST_GROUP(scratch_make, scratch_remove)
