/* Archives of cases of the tests, written into a folder that is removed when the program ends. */
#ifndef HAWSER_TESTS_FMI_FIXTURE_H
#define HAWSER_TESTS_FMI_FIXTURE_H

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "hawser/hawser.h"
#include "tests/fmi/importer.h"
#include "tests/support/check.h"
#include "tests/support/data.h"

/* A case of tests/data, or of a text with files of tests/data. */
static inline hawser_case *case_of(const char *text)
{
    hawser_case *c = NULL;
    hawser_error err = {HAWSER_OK, ""};
    if (hawser_case_parse(text, "pull.yaml", &c, &err) || hawser_case_folder(c, HAWSER_SOURCE_DIR "/tests/data", &err))
        fail_msg("%s", err.message);
    return c;
}

static inline hawser_sim *sim_of(const char *text)
{
    hawser_case *const c = case_of(text);
    hawser_sim *s = NULL;
    hawser_error err = {HAWSER_OK, ""};
    if (hawser_sim_new(c, NULL, &s, &err) || hawser_sim_relax(s, NULL, &err)) fail_msg("%s", err.message);
    hawser_case_free(c);
    return s;
}

/* The case as an archive of a version, opened. */
static inline void fmu_of(Fmu *fmu, const char *text, int version)
{
    char path[] = "/tmp/hawser-fmu-XXXXXX";
    hawser_case *const c = case_of(text);
    hawser_error err = {HAWSER_OK, ""};
    const int file = mkstemp(path);
    assert_true(file >= 0);
    close(file);
    if (hawser_fmu_write(c, (hawser_fmi)version, path, &err)) fail_msg("%s", err.message);
    hawser_case_free(c);
    fmu_open(fmu, path);
    unlink(path);
}

/* An instance at the start of its steps. */
static inline FmuInstance *instance_of(const Fmu *fmu)
{
    FmuInstance *const i = calloc(1, sizeof *i);
    instance_new(i, fmu, fmu->token, fmu->resources);
    if (!i->c || instance_begin(i, 0) || instance_settle(i)) fail_msg("%s", i->said);
    return i;
}

static inline void instance_drop(FmuInstance *i)
{
    instance_free(i);
    free(i);
}

static inline void step_to(FmuInstance *i, double t)
{
    const double now = instance_value(i, "time");
    if (instance_step(i, now, t - now)) fail_msg("%s", i->said);
}

#endif
