/* What the tests of case files share: reading a text, and what its message must say. */
#ifndef HAWSER_TESTS_CASE_FIXTURE_H
#define HAWSER_TESTS_CASE_FIXTURE_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/case/case_read.h"
#include "tests/support/check.h"
#include "tests/support/data.h"

#define NAME "pull.yaml"

/* Reads a text as a case called NAME in tests/data, with one setting (key NULL: none). */
static inline hawser_status read_with(const char *text, const char *key, const char *value, SceneDef *def,
                                      hawser_error *err)
{
    CaseTree *tree;
    memset(err, 0, sizeof *err);
    hawser_status status = case_tree_parse(text, NAME, &tree, err);
    if (!status) tree->folder = strdup(HAWSER_SOURCE_DIR "/tests/data");
    if (!status && key) status = case_tree_set(tree, key, value, err);
    if (!status) status = case_read(tree, def, err);
    case_tree_free(tree);
    return status;
}

/* The text with one setting must be a good case; the caller clears *def. */
static inline void expect_good(const char *text, const char *key, const char *value, SceneDef *def)
{
    hawser_error err;
    const hawser_status status = read_with(text, key, value, def, &err);
    if (status) fail_msg("refused: %s", err.message);
}

/* The text with one setting must be refused with a message that holds `part`. */
static inline void expect_bad(const char *text, const char *key, const char *value, const char *part)
{
    hawser_error err;
    SceneDef def;
    const hawser_status status = read_with(text, key, value, &def, &err);
    if (!status) {
        scene_def_clear(&def);
        fail_msg("accepted: %s = %s", key ? key : "the text", key ? value : text);
    }
    assert_int_equal(status, HAWSER_ERR_INPUT);
    assert_int_equal(err.status, HAWSER_ERR_INPUT);
    assert_null(strchr(err.message, '\n'));
    if (!strstr(err.message, part)) fail_msg("'%s' is not in: %s", part, err.message);
}

/* A text read as a case called NAME, with settings ("key", "value", ..., NULL), or NULL. */
static inline hawser_case *case_with(const char *text, const char *const *settings)
{
    hawser_case *c = NULL;
    hawser_error err = {0};
    if (hawser_case_parse(text, NAME, &c, &err)) fail_msg("%s", err.message);
    for (int i = 0; settings && settings[i]; i += 2) {
        if (hawser_case_set(c, settings[i], settings[i + 1], &err)) fail_msg("%s", err.message);
    }
    return c;
}

/* Its simulation, before it begins. */
static inline hawser_sim *sim_of(const char *text, const char *const *settings)
{
    hawser_sim *sim = NULL;
    hawser_error err = {0};
    hawser_case *const c = case_with(text, settings);
    if (hawser_sim_new(c, NULL, &sim, &err)) fail_msg("%s", err.message);
    hawser_case_free(c);
    return sim;
}

/* The same at its end. */
static inline hawser_sim *run_of(const char *text, const char *const *settings)
{
    hawser_error err = {0};
    hawser_sim *const sim = sim_of(text, settings);
    if (hawser_sim_run(sim, NULL, NULL, NULL, &err)) fail_msg("%s", err.message);
    return sim;
}

/* The route of a definition. */
static inline Route route_of(const SceneDef *def)
{
    Route route;
    hawser_error err;
    assert_int_equal(
        route_build(&route, def->n_route, def->route, def->route_start, def->route_heading, def->route_slope, &err),
        HAWSER_OK);
    return route;
}

/* What a run says of the condition of trust; NULL: it is not asked. */
static inline const hawser_condition *condition_of(const hawser_summary *sum, const char *name)
{
    for (int i = 0; i < sum->n_conditions; i++)
        if (!strcmp(sum->conditions[i].name, name)) return &sum->conditions[i];
    return NULL;
}

/* A limit by its name, of n; of a run, where it is judged. */
static inline const hawser_limit *limit_named(int n, const hawser_limit *limit, const char *name)
{
    for (int i = 0; i < n; i++)
        if (!strcmp(limit[i].name, name)) return &limit[i];
    fail_msg("no limit %s", name);
    return NULL;
}

static inline hawser_limit run_limit(hawser_sim *sim, const char *name)
{
    hawser_limit limit[HAWSER_LIMITS_MAX];
    return *limit_named(hawser_sim_limits(sim, limit), limit, name);
}

#endif
