/* What only a program can get wrong: wrong order, numbers that are none (NULL: tests/cli/null_calls.c). A status each,
 * with the argument's name as the error's key, and no harm done. And errors as fields. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/support/check.h"
#include "tests/support/data.h"

#include "hawser/hawser.h"
#include "tests/io/case_fixture.h"

static hawser_case *case_new(void)
{
    hawser_case *const c = case_with(data_text("short-pull"), NULL);
    return c;
}

static hawser_sim *sim_new_of(const char *key, const char *value)
{
    hawser_case *const c = case_new();
    hawser_sim *s = NULL;
    hawser_error err = {0};
    if (key && hawser_case_set(c, key, value, &err)) fail_msg("%s", err.message);
    if (hawser_sim_new(c, NULL, &s, &err)) fail_msg("%s", err.message);
    hawser_case_free(c);
    return s;
}

static hawser_error error;

/* NULL: any, or none. */
static void check_key(const char *argument)
{
    if (argument) assert_string_equal(error.key, argument);
}

/* The last call was refused, naming the argument (NULL: something else). */
#define REFUSED(call, argument)                                                                                        \
    do {                                                                                                               \
        error = (hawser_error){0};                                                                                     \
        assert_int_equal(call, HAWSER_ERR_INPUT);                                                                      \
        assert_int_equal(error.status, HAWSER_ERR_INPUT);                                                              \
        check_key(argument);                                                                                           \
        check_above(strlen(error.message), 5);                                                                         \
    } while (0)
static const char *const nothing = NULL;

TEST(numbers_that_are_none)
{
    static const double bad[] = {NAN, INFINITY, -INFINITY, 1e300, -1e300};
    hawser_sim *const s = sim_new_of(NULL, NULL);
    const hawser_event *event;
    const int events = hawser_sim_events(s, &event);
    for (size_t k = 0; k < sizeof bad / sizeof *bad; ++k) {
        const hawser_force force = {.force_N = {0, bad[k], 0}}, arm = {.force_N = {1, 0, 0}, .arm_m = {bad[k], 0, 0}};
        if (bad[k] > 0 || isnan(bad[k])) REFUSED(hawser_sim_advance(s, bad[k], 0, &error), nothing);
        REFUSED(hawser_sim_control(s, HAWSER_WINCH_SPEED, NULL, bad[k], 1, &error), nothing);
        REFUSED(hawser_sim_control(s, HAWSER_WINCH_SPEED, NULL, 0.1, bad[k], &error), nothing);
        REFUSED(hawser_sim_control(s, HAWSER_FRICTION, NULL, bad[k], 1, &error), nothing);
        REFUSED(hawser_sim_force(s, 3, &force, 1, &error), nothing);
        REFUSED(hawser_sim_force(s, 3, &arm, 1, &error), nothing);
    }
    REFUSED(hawser_sim_control(s, (hawser_control)0, NULL, 0, 0, &error), nothing);
    REFUSED(hawser_sim_control(s, (hawser_control)50, NULL, 0, 0, &error), nothing);
    REFUSED(hawser_sim_control(s, (hawser_control)-3, NULL, 0, 0, &error), nothing);
    REFUSED(hawser_sim_force(s, -1, NULL, 0, &error), nothing);
    REFUSED(hawser_sim_force(s, 1 << 30, NULL, 0, &error), nothing);
    assert_int_equal(hawser_sim_events(s, &event), events);
    assert_int_equal(hawser_sim_advance(s, 0.1, 0, &error), HAWSER_OK);
    hawser_sim_free(s);
}

/* What a call-back tries. */
typedef struct Inside {
    int calls, refused, told;
    double stop_at;
} Inside;

static int inside(void *user, hawser_sim *s, double t)
{
    Inside *const in = user;
    hawser_error err = {0};
    ++in->calls;
    check_equal(hawser_sim_time(s), t);
    in->refused += hawser_sim_advance(s, t + 1, 0, &err) == HAWSER_ERR_INPUT;
    in->refused += hawser_sim_run(s, NULL, NULL, NULL, &err) == HAWSER_ERR_INPUT;
    in->refused += hawser_sim_relax(s, NULL, &err) == HAWSER_ERR_INPUT;
    if (!in->told) in->told = hawser_sim_control(s, HAWSER_WINCH_SPEED, NULL, 0.05, 0.1, &err) == HAWSER_OK;
    return t >= in->stop_at;
}

static int seen(void *user, hawser_sim *s, const hawser_event *event)
{
    (void)s;
    *(int *)user += event->code == HAWSER_EVENT_COMMAND + HAWSER_WINCH_SPEED;
    return 0;
}

static void said(void *user, hawser_log_level level, const char *text)
{
    *(int *)user += level == HAWSER_LOG_INFO && strstr(text, "winch_speed") != NULL;
}

TEST(wrong_order)
{
    hawser_sim *const s = sim_new_of(NULL, NULL);
    Inside in = {.stop_at = 0.5};
    int events = 0, lines = 0;
    hawser_sim_on_step(s, inside, &in);
    hawser_sim_on_event(s, seen, &events);
    hawser_sim_on_log(s, HAWSER_LOG_INFO, said, &lines);
    assert_int_equal(hawser_sim_advance(s, 1, 0, &error), HAWSER_STOPPED);
    check_between(hawser_sim_time(s), 0.5 - 1e-9, 0.7);
    check_above(in.calls, 1);
    assert_int_equal(in.refused, 3 * in.calls);
    assert_int_equal(events, 1);
    assert_int_equal(lines, 1);
    REFUSED(hawser_sim_relax(s, NULL, &error), nothing);
    hawser_sim_on_step(s, NULL, NULL);
    assert_int_equal(hawser_sim_run(s, NULL, NULL, NULL, &error), HAWSER_OK);
    hawser_sim_free(s);
    hawser_sim *const resting = sim_of(data_text("rod-column"), NULL);
    REFUSED(hawser_sim_force(resting, 1, NULL, 1, &error), nothing);
    check_has(error.message, "dynamics");
    hawser_sim_free(resting);
}

/* Key, file and line of a wrong case; segment and time of a run that fails. */
TEST(errors_are_fields)
{
    hawser_case *c = case_new();
    assert_int_equal(hawser_case_set(c, "drive.winch.speed", "fast", &error), HAWSER_OK);
    assert_int_equal(hawser_case_check(c, &error), HAWSER_ERR_INPUT);
    assert_string_equal(error.key, "drive.winch.speed");
    hawser_case_free(c);
    assert_int_equal(hawser_case_parse("title: x\nrun:\n  duration: long\n", "a.yaml", &c, &error), HAWSER_OK);
    assert_int_equal(hawser_case_check(c, &error), HAWSER_ERR_INPUT);
    assert_string_equal(error.file, "a.yaml");
    check_above(error.line, 0);
    hawser_case_free(c);
    hawser_sim *const s = sim_new_of("solver.max_steps", "5");
    assert_int_equal(hawser_sim_advance(s, 2, 0, &error), HAWSER_ERR_RUN);
    check_between(error.segment, -1, 20);
    check_close(error.t_s, hawser_sim_time(s), 1e-12);
    hawser_sim_free(s);
    assert_int_equal(hawser_version_number(), HAWSER_VERSION_NUMBER);
    char version[32];
    snprintf(version, sizeof version, "%d.%d.%d", HAWSER_VERSION_MAJOR, HAWSER_VERSION_MINOR, HAWSER_VERSION_PATCH);
    assert_string_equal(version, hawser_version());
}

static const char json_pull[] =
    "{\"title\": \"A \\u0072ow \\ud83d\\ude00\",\n"
    "\t\"cables\": {\"power\": {\"EA\": 5e7, \"GA\": \"20 MN\", \"GJ\": 8e3, \"EI\": 1e4, \"d\": 0.09,\n"
    "\t\t\"mass\": 20}},\n"
    "\t\"chain\": [{\"cable\": \"power\", \"length\": 10, \"segment\": 0.5}],\n"
    "\t\"route\": {\"head_at\": 12, \"pieces\": [{\"straight\": \"20 m\"}]},\n"
    "\t\"rollers\": {\"along\": {\"spacing\": 1}},\n"
    "\t\"friction\": {\"mu\": 0.2},\n"
    "\t\"drive\": {\"winch\": {\"speed\": \"6 m\\/min\", \"to\": 1}},\n"
    "\t\"run\": {\"duration\": 2.0}}\n";

/* The same pull to the last bit, whether its case is YAML or JSON. */
TEST(a_case_is_json)
{
    double force[2];
    for (int k = 0; k < 2; ++k) {
        hawser_case *c = NULL;
        hawser_sim *s = NULL;
        error = (hawser_error){0};
        if (k ? hawser_case_parse_json(json_pull, "pull.json", &c, &error)
              : hawser_case_parse(data_text("short-pull"), "pull.yaml", &c, &error))
            fail_msg("%s", error.message);
        if (hawser_sim_new(c, NULL, &s, &error) || hawser_sim_relax(s, NULL, &error) ||
            hawser_sim_advance(s, 1, 0, &error))
            fail_msg("%s", error.message);
        force[k] = hawser_sim_sample(s)->winch_force;
        hawser_sim_free(s);
        hawser_case_free(c);
    }
    check_close(force[0], force[1], 1e-9 * force[0]);
}

TEST(json_errors)
{
    hawser_case *c = (hawser_case *)1;
    REFUSED(hawser_case_parse_json("{\"title\": \"x\",\n \"run\": }", "a.json", &c, &error), nothing);
    assert_null(c);
    assert_int_equal(error.line, 2);
    check_has(error.message, "a.json:2: not JSON");
    REFUSED(hawser_case_parse_json("title: yaml", "a.json", &c, &error), nothing);
    REFUSED(hawser_case_parse_json("{\"run\": {\"duration\": NaN}}", "a.json", &c, &error), nothing);
    REFUSED(hawser_case_parse_json("{\"run\": 1, \"run\": 2}", "a.json", &c, &error), nothing);
    assert_int_equal(
        hawser_case_parse_json("{\"title\": \"x\",\n \"run\": {\n\t\"duration\": \"long\"}}", "a.json", &c, &error),
        HAWSER_OK);
    REFUSED(hawser_case_check(c, &error), nothing);
    assert_string_equal(error.file, "a.json");
    check_above(error.line, 0);
    hawser_case_free(c);
}
