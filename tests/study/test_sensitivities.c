/* Derivatives of a run by its linearised equations of motion, against central differences of whole runs; what has none.
 */
#include "hawser/hawser.h"
#include "tests/study/study_fixture.h"

#include <jansson.h>
#include <math.h>

#include "core/vec3.h"
#include "io/api/api_handles.h"
#include "sim/run/tangent.h"

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
TEST(central_differences)
{
    const double coarse = largest_difference("1e-5"), fine = largest_difference("1e-8");
    check_at_most(coarse, 4e-3);
    check_at_most(fine, 3e-4);
    check_at_most(fine, coarse / 4); /* 5.0 times, 4.96 as the sanitizers compile it */
}

/* A scene of which the equilibrium is known to rounding, and what it is in a case file. */
static hawser_sim *relaxed(const char *file, const char *key, double value, const char *unit, hawser_case **c)
{
    hawser_error err;
    hawser_sim *sim = NULL;
    char text[64];
    snprintf(text, sizeof text, "%.17g %s", value, unit);
    if (hawser_case_load(file, c, &err) || hawser_case_set(*c, "solver.relax_tolerance", "1e-12", &err) ||
        (strstr(file, "huangjiahu") && hawser_case_set(*c, "solver.planar", "off", &err)) ||
        (key && hawser_case_set(*c, key, text, &err)) || hawser_sim_new(*c, NULL, &sim, &err) ||
        hawser_sim_relax(sim, NULL, &err))
        fail_msg("%s", err.message);
    return sim;
}

/* dy/dp of the equilibrium by the tangents against central differences of equilibria, as a share of its largest
 * entry. */
static double start_difference(const char *file, const char *key, double value, const char *unit)
{
    const double by = 1e-3 * value, half = 1e-5 * value;
    static const double side[] = {-1, 1};
    hawser_case *c[5];
    hawser_sim *sim[5];
    hawser_error err;
    Tangent *g;
    double largest = 0, off = 0;
    sim[4] = relaxed(file, NULL, 0, "", &c[4]);
    for (int k = 0; k < 2; k++) {
        sim[k] = relaxed(file, key, value + side[k] * by, unit, &c[k]);
        sim[2 + k] = relaxed(file, key, value + side[k] * half, unit, &c[2 + k]);
    }
    if (tangent_new(c[4]->def, 1, c[2]->def, c[3]->def, &half, 0, &g, &err) ||
        tangent_step(g, 0, sim[4]->stage.y, &err))
        fail_msg("%s", err.message);
    const double *const slope = tangent_slope(g, 0);
    for (int i = 0; i < sim[4]->stage.motion->size; i++) {
        const double expected = (sim[1]->stage.y[i] - sim[0]->stage.y[i]) / (2 * by);
        off = larger_of(off, fabs(slope[i] - expected));
        largest = larger_of(largest, fabs(expected));
    }
    tangent_free(g);
    for (int k = 0; k < 5; k++) {
        hawser_sim_free(sim[k]);
        hawser_case_free(c[k]);
    }
    return off / largest;
}

/* Where the cable hangs before the pull follows from its parameters: in the plane, and in space. */
TEST(the_start_follows)
{
    static const char flat[] = HAWSER_SOURCE_DIR "/tests/data/cli-pull.yaml",
                      space[] = HAWSER_SOURCE_DIR "/cases/huangjiahu.yaml";
    check_at_most(start_difference(flat, "cables.power.mass", 20, "kg/m"), 1e-5);
    check_at_most(start_difference(flat, "cables.power.EI", 10, "kN m2"), 1e-5);
    check_at_most(start_difference(space, "cables.power.density", 7801, "kg/m3"), 4e-5);
}

TEST(refused)
{
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

/* A run of the case into a folder of the tests' own. */
static void run_into(const char *folder, const char *mu)
{
    hawser_error err;
    hawser_sim *s = NULL;
    hawser_case *const c = pull_case("1e-3", NULL, 0, "");
    if (hawser_case_set(c, "friction.mu", mu, &err)) fail_msg("%s", err.message);
    if (hawser_sim_new(c, NULL, &s, &err)) fail_msg("%s", err.message);
    if (hawser_sim_run(s, scratch_path(folder), NULL, NULL, &err)) fail_msg("%s", err.message);
    hawser_sim_free(s);
    hawser_case_free(c);
}

/* What is written of a run belongs to it, and to no other one. */
TEST(the_file_says_of_which_run_it_is)
{
    static const char *const key[] = {"friction.mu"};
    hawser_error err;
    char *text, *json;
    hawser_case *const c = pull_case("1e-3", "friction.mu", 0.2, "");
    if (hawser_case_run_sensitivities(c, 1, key, HAWSER_TABLE, NULL, NULL, &text, &json, &err))
        fail_msg("%s", err.message);
    run_into("same", "0.20000000000000001");
    run_into("other", "0.3");
    assert_int_equal(hawser_sensitivities_write(json, scratch_path("same"), &err), HAWSER_OK);
    assert_int_equal(hawser_sensitivities_write(json, scratch_path("other"), &err), HAWSER_ERR_OUTPUT);
    check_has(err.message, "sensitivities.json': the results in this folder are of another run");
    if (hawser_results_check(scratch_path("same"), &err)) fail_msg("%s", err.message);
    if (hawser_results_check(scratch_path("other"), &err)) fail_msg("%s", err.message);
    hawser_text_free(text);
    hawser_text_free(json);
    hawser_case_free(c);
}

TEST_GROUP(scratch_make, scratch_remove)
