/* What the tests of theory's answers share: the answer to a case with settings, and what stands in it. */
#ifndef HAWSER_TESTS_THEORY_FIXTURE_H
#define HAWSER_TESTS_THEORY_FIXTURE_H

#include <jansson.h>

#include "tests/io/case_fixture.h"

/* The answer as JSON, the caller's (hawser_text_free). */
static inline char *theory_text(const char *text, const char *const *settings)
{
    char *answer = NULL;
    hawser_error err = {0};
    hawser_case *const c = case_with(text, settings);
    if (hawser_case_theory(c, HAWSER_JSON, &answer, &err)) fail_msg("%s", err.message);
    hawser_case_free(c);
    return answer;
}

/* The same taken apart, the caller's. */
static inline json_t *theory_of(const char *text, const char *const *settings)
{
    char *const answer = theory_text(text, settings);
    json_t *const all = json_loads(answer, 0, NULL);
    hawser_text_free(answer);
    assert_non_null(all);
    return all;
}

static inline double number_of(const json_t *row, const char *key)
{
    return json_number_value(json_object_get(row, key));
}

static inline void verdict_has(const json_t *answer, const char *part)
{
    const char *const verdict = json_string_value(json_object_get(answer, "verdict_forward"));
    assert_non_null(verdict);
    check_has(verdict, part);
}

/* The first row of that limit; NULL: there is none. */
static inline json_t *limit_row(const json_t *answer, const char *name)
{
    json_t *limit;
    size_t i;
    json_array_foreach(json_object_get(answer, "limits"), i, limit)
    {
        if (!strcmp(json_string_value(json_object_get(limit, "name")), name)) return limit;
    }
    return NULL;
}

/* The value of a limit, pulled forward. */
static inline double limit_of(const json_t *answer, const char *name)
{
    json_t *limit;
    size_t i;
    json_array_foreach(json_object_get(answer, "limits"), i, limit)
    {
        const char *const way = json_string_value(json_object_get(limit, "direction"));
        if (!strcmp(json_string_value(json_object_get(limit, "name")), name) && (!way || strcmp(way, "backward")))
            return number_of(limit, "value");
    }
    fail_msg("no limit %s", name);
    return NAN;
}

/* The number behind some words of the answer as text; what else it `says`, or NULL. */
static inline double number_behind(const char *text, const char *words, const char *says)
{
    char *answer = NULL;
    double number = NAN;
    hawser_case *const c = case_with(text, NULL);
    assert_int_equal(hawser_case_theory(c, HAWSER_TABLE, &answer, NULL), HAWSER_OK);
    hawser_case_free(c);
    const char *const at = strstr(answer, words);
    assert_non_null(at);
    assert_int_equal(sscanf(at + strlen(words), "%lf", &number), 1);
    if (says) check_has(answer, says);
    hawser_text_free(answer);
    return number;
}

#endif
