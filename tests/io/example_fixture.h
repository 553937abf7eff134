/* Runs of the example cases through the public interface, with settings: ("key", "value", ..., NULL), or NULL. */
#ifndef HAWSER_TESTS_EXAMPLE_FIXTURE_H
#define HAWSER_TESTS_EXAMPLE_FIXTURE_H

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "hawser/hawser.h"
#include "tests/support/check.h"

/* Builds cases/NAME.yaml; the settings themselves must be right, the simulation may be refused. */
static inline hawser_status example_open(const char *name, const char *const *settings, hawser_sim **sim,
                                         hawser_error *err)
{
    char path[512];
    hawser_case *c = NULL;
    snprintf(path, sizeof path, "%s/cases/%s.yaml", HAWSER_SOURCE_DIR, name);
    if (hawser_case_load(path, &c, err)) fail_msg("%s", err->message);
    for (int i = 0; settings && settings[i]; i += 2) {
        if (hawser_case_set(c, settings[i], settings[i + 1], err)) fail_msg("%s", err->message);
    }
    const hawser_status status = hawser_sim_new(c, NULL, sim, err);
    hawser_case_free(c);
    return status;
}

/* The same where nothing is wrong. */
static inline hawser_sim *example_sim(const char *name, const char *const *settings)
{
    hawser_error err = {0};
    hawser_sim *sim = NULL;
    if (example_open(name, settings, &sim, &err)) fail_msg("%s", err.message);
    return sim;
}

/* A finished run; the summary's texts and lists are the simulation's. */
typedef struct Outcome {
    hawser_summary summary;
    hawser_sim *sim;
} Outcome;

static inline Outcome example_run(const char *name, const char *const *settings)
{
    hawser_error err = {0};
    Outcome out = {.sim = example_sim(name, settings)};
    if (hawser_sim_run(out.sim, NULL, NULL, NULL, &err)) fail_msg("%s", err.message);
    hawser_sim_summary(out.sim, &out.summary);
    return out;
}

#endif
