/* What the tests of studies share: a folder for the test's files, a study of a short pull, and what came of it. */
#ifndef HAWSER_TESTS_STUDY_FIXTURE_H
#define HAWSER_TESTS_STUDY_FIXTURE_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "study/evaluate.h"
#include "study/findings.h"
#include "tests/support/check.h"
#include "tests/support/scratch.h"

/* folder/study.yaml: a study of tests/data/cli-pull.yaml with limits, and these lines. */
static inline const char *study_write(const char *lines)
{
    char text[8000];
    snprintf(text, sizeof text,
             "case: " HAWSER_SOURCE_DIR "/tests/data/cli-pull.yaml\n"
             "set: {run.steady_from: 200 ms, limits.winch_capacity: 600 N, limits.conductor: \"{material: copper, "
             "area: 800 mm2}\"}\n%s",
             lines);
    return scratch_write("study.yaml", text);
}

static inline hawser_study *study_open(const char *path)
{
    hawser_study *s = NULL;
    hawser_error err;
    if (hawser_study_load(path, &s, &err)) fail_msg("%s", err.message);
    return s;
}

/* The study of these lines, computed into folder/DIR. */
static inline void study_compute(const char *lines, const char *dir, int jobs)
{
    hawser_error err;
    hawser_study *const s = study_open(study_write(lines));
    const hawser_study_options options = {.jobs = jobs};
    if (hawser_study_run(s, scratch_path(dir), &options, &err)) fail_msg("%s", err.message);
    hawser_study_free(s);
}

/* All of a file; malloc'ed. */
static inline char *bytes_of(const char *dir, const char *name, size_t *size)
{
    char *text;
    hawser_error err;
    char path[200];
    snprintf(path, sizeof path, "%s/%s", scratch_path(dir), name);
    if (case_file_read(path, &text, size, &err)) fail_msg("%s", err.message);
    return text;
}

/* The results, byte by byte. */
static inline void expect_alike(const char *one, const char *other)
{
    const char *const names[] = {"samples.csv", "summary.json", "study.h5", "study.html"};
    for (int k = 0; k < 4; k++) {
        size_t n, m;
        char *const a = bytes_of(one, names[k], &n), *const b = bytes_of(other, names[k], &m);
        if (n != m || memcmp(a, b, n) != 0) fail_msg("%s/%s and %s/%s differ", one, names[k], other, names[k]);
        free(a);
        free(b);
    }
}

/* The rows in folder/DIR of the study at folder/study.yaml. */
static inline void rows_of(const char *dir, Study **s, Rows *rows)
{
    hawser_error err;
    if (study_read(scratch_path("study.yaml"), s, &err)) fail_msg("%s", err.message);
    assert_int_equal(rows_make(*s, rows, &err), HAWSER_OK);
    if (store_read(*s, scratch_path(dir), rows, &err)) fail_msg("%s", err.message);
}

/* A study of 200 samples of theory. */
static const char drawn[] = "parameters:\n"
                            "  friction.mu: {uniform: {from: 0.1, to: 0.4}}\n"
                            "  drive.tail.tension: {normal: {mean: 200 N, sd: 50 N}}\n"
                            "monte-carlo: {samples: 200, seed: 3}\n";
/* One of runs of a few milliseconds. */
static const char runs[] = "fidelity: run\n"
                           "parameters:\n"
                           "  friction.mu: {steps: {from: 0.1, to: 0.5, count: 6}}\n"
                           "  run.duration: {values: [300 ms, 350 ms]}\n"
                           "grid: [friction.mu, run.duration]\n"
                           "quantities: [pull_force.peak_N, steps, limits.winch.margin, relaxation.reached]\n";

#endif
