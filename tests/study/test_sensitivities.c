/* Derivatives of a run by its linearised equations of motion, against central differences of whole runs; what has none.
 */
#include "hawser/sweep.h"
#include "tests/study/study_fixture.h"

#include <jansson.h>
#include <math.h>

#include "core/base/worst.h"

/* A short pull on rollers that begins from where it is laid, with steps so small that their errors do not count. */
static hawser_case *pull_case(const char *accuracy, const char *key, double value, const char *unit)
{
    static const char *const set[][2] = {{"solver.relax", "false"},
                                         {"drive.tail.tension", "300 N"},
                                         {"run.duration", "1500 ms"},
                                         {"run.steady_from", "1200 ms"},
                                         {"drive.winch.to", "500 ms"}};
    hawser_case *c = NULL;
    hawser_error err;
    char text[64];
    if (hawser_case_load(HAWSER_SOURCE_DIR "/tests/data/cli-pull.yaml", &c, &err)) fail_msg("%s", err.message);
    for (size_t k = 0; k < sizeof set / sizeof *set; k++) {
        if (hawser_case_set(c, set[k][0], set[k][1], &err)) fail_msg("%s", err.message);
    }
    if (hawser_case_set(c, "solver.accuracy", accuracy, &err)) fail_msg("%s", err.message);
    snprintf(text, sizeof text, "%.17g %s", value, unit);
    if (key && hawser_case_set(c, key, text, &err)) fail_msg("%s", err.message);
    return c;
}

/* The rows of a run's answer. */
static json_t *rows_by(const char *accuracy, const char *key, double value, const char *unit, size_t n,
                       const char *const *keys)
{
    hawser_error err;
    char *text, *json;
    hawser_case *const c = pull_case(accuracy, key, value, unit);
    if (hawser_case_run_sensitivities(c, n, keys, HAWSER_TABLE, NULL, NULL, &text, &json, &err))
        fail_msg("%s", err.message);
    check_has(text, "What a run's figures change by");
    json_t *const all = json_loads(json, 0, NULL), *const rows = json_incref(json_object_get(all, "sensitivities"));
    json_decref(all);
    hawser_text_free(text);
    hawser_text_free(json);
    hawser_case_free(c);
    return rows;
}

/* A figure's number by a key. */
static double number(const json_t *rows, const char *figure, const char *key, const char *what)
{
    size_t i;
    json_t *row;
    json_array_foreach((json_t *)(size_t)rows, i, row)
    {
        if (!strcmp(json_string_value(json_object_get(row, "figure")), figure) &&
            !strcmp(json_string_value(json_object_get(row, "key")), key))
            return json_number_value(json_object_get(row, what));
    }
    fail_msg("no row for %s by %s", figure, key);
    return NAN;
}

/* The largest difference between what the linearised equations say and whole runs with a little less and more of each
 * parameter, as a share of the pull: by the whole of the parameter, so that all have one measure. */
static double largest_difference(const char *accuracy)
{
    static const char *const keys[] = {"friction.mu", "drive.tail.tension", "cables.power.mass", "drive.winch.speed"};
    static const char *const units[] = {"", "N", "kg/m", "m/min"};
    static const double at[] = {0.2, 300, 20, 6};
    static const char *const figures[] = {"pull", "tension at middle", "load of roller 8"};
    json_t *const rows = rows_by(accuracy, NULL, 0, "", 4, keys);
    double largest = 0;
    for (int k = 0; k < 4; k++) {
        const double by = 1e-3 * at[k];
        json_t *const less = rows_by(accuracy, keys[k], at[k] - by, units[k], 1, &keys[k]), *const more = rows_by(
                                                                                                accuracy, keys[k],
                                                                                                at[k] + by, units[k], 1,
                                                                                                &keys[k]);
        for (int i = 0; i < 3; i++) {
            const double before = number(less, figures[i], keys[k], "value_N"),
                         after = number(more, figures[i], keys[k], "value_N"),
                         slope = number(rows, figures[i], keys[k], "slope_N_per_unit"),
                         expected = (after - before) / (2 * by), pull = number(rows, "pull", keys[k], "value_N");
            largest = larger_of(largest, fabs(slope - expected) * at[k] / pull);
        }
        json_decref(less);
        json_decref(more);
    }
    json_decref(rows);
    return largest;
}

/* Both the run and its tangents have errors of their steps, which go with the accuracy. */
static void central_differences(void **state)
{
    (void)state;
    const double coarse = largest_difference("1e-5"), fine = largest_difference("1e-8");
    check_at_most(coarse, 4e-3);
    check_at_most(fine, 3e-4);
    check_at_most(fine, coarse / 4); /* 5.0 times, 4.96 as the sanitizers compile it */
}

static void refused(void **state)
{
    (void)state;
    static const struct {
        const char *key, *by, *value, *says;
    } row[] = {{"friction.my", NULL, NULL, "the case gives no number other than 0 there"},
               {"friction.mu", "friction.mu", "0", "the case gives no number other than 0 there"},
               {"friction.mu", "drive.winch.trip", "{force: 9 kN}", "a winch that trips are not known"}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        hawser_error err;
        char *text = NULL;
        hawser_case *const c = pull_case("1e-3", NULL, 0, "");
        if (row[k].by && hawser_case_set(c, row[k].by, row[k].value, &err)) fail_msg("%s", err.message);
        assert_int_equal(hawser_case_run_sensitivities(c, 1, &row[k].key, HAWSER_TABLE, NULL, NULL, &text, NULL, &err),
                         HAWSER_ERR_INPUT);
        check_has(err.message, row[k].says);
        assert_null(text);
        hawser_case_free(c);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(central_differences), cmocka_unit_test(refused)};
    return cmocka_run_group_tests(tests, folder_make, folder_remove);
}
