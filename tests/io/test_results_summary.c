/* summary.json: every promised key with its value, what is not known, and what is not text. */
#include "io/results/results.h"
#include "tests/support/check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <jansson.h>

static const hawser_balance books = {.carried_J = 11,
                                     .residual_J = 12,
                                     .turnover_J = 13,
                                     .turnover_of = "winch",
                                     .residual_share = 14,
                                     .numerical_J = 22,
                                     .numerical_share = 23,
                                     .impulse_residual_share = 15,
                                     .n_terms = 4,
                                     .term = {{HAWSER_BALANCE_WORK, "winch", 16, {0, 0, 0}},
                                              {HAWSER_BALANCE_LOSS, "bearings", 17, {0, 0, 0}},
                                              {HAWSER_BALANCE_STORED, "height", 18, {0, 0, 0}},
                                              {HAWSER_BALANCE_IMPULSE, "weight", NAN, {19, 20, 21}}}};
static const hawser_summary full = {.balance = &books,
                                    .segments = 370,
                                    .bushings = 370,
                                    .rollers = 32,
                                    .contact_candidates = 1795,
                                    .contact_active_max = 64,
                                    .sim_time_s = 30,
                                    .wall_time_s = 0.5,
                                    .real_time_factor = 60,
                                    .steps = 3000,
                                    .rhs_evals = 4000,
                                    .newton_iters = 3900,
                                    .jac_evals = 60,
                                    .lin_setups = 240,
                                    .error_test_fails = 5,
                                    .newton_fails = 6,
                                    .contact_refreshes = 70,
                                    .steps_per_second = 6000,
                                    .linear_solver = "block",
                                    .linear_solver_why = "a plain chain",
                                    .ordering = "natural",
                                    .threads = 2,
                                    .planar = 1,
                                    .planar_why = "all in one plane",
                                    .pull_mean_N = 13000.5,
                                    .pull_peak_N = 14000.25,
                                    .pull_ripple_N = 7.5,
                                    .pull_mean_error = {1.5, 2.5, 3.5, 7.5},
                                    .pull_peak_error = {10, 20, 30, 60},
                                    .paper_total_N = 12903.21,
                                    .reference_total_N = 13010,
                                    .error_max_pct = 4,
                                    .error_mean_pct = 2,
                                    .error_max_paper_pct = 5,
                                    .error_mean_paper_pct = 3,
                                    .steady_speed_m_per_s = 0.1,
                                    .settle_time_s = 13.25,
                                    .steady_from_s = 18,
                                    .steady_to_s = 30,
                                    .relaxation = {1, 12, 1e-3, 1e-2, 77, 0.002},
                                    .phases = {1, 2, 3, 4, 5, 6, 7, 8, 9}};

static const hawser_limit limits[] = {
    {.name = "pull",
     .unit = "N",
     .value = 49e3,
     .limit = 56e3,
     .margin = 0.125,
     .judged = 1,
     .ok = 1,
     .where = "58.5 m (E-F)",
     .source = "eq. 11"},
    {.name = "rope", .unit = "N", .value = 13e3, .limit = NAN, .margin = NAN, .source = "no strength"}};
static const Overload overloads[] = {{"P7", 12, 9e3, 6e3, 1.5}};
static const SummaryLabels labels = {.title = "A \"title\"",
                                     .case_name = "cases/x.yaml",
                                     .outcome = "finished",
                                     .message = "",
                                     .n_limits = 2,
                                     .limit = limits,
                                     .n_overloads = 1,
                                     .overload = overloads,
                                     .trip_N = 19e3};

/* The summary as JSON read back; the caller decrefs it. */
static json_t *write_and_read(const hawser_summary *s, const SummaryLabels *l)
{
    char *text = NULL;
    assert_int_equal(summary_json(s, l, &text, NULL), HAWSER_OK);
    json_t *o = json_loads(text, 0, NULL);
    free(text);
    assert_non_null(o);
    return o;
}

/* The value of "a" or "a.b". */
static json_t *value_of(json_t *o, const char *path)
{
    char outer[64];
    const char *dot = strchr(path, '.');
    if (!dot) return json_object_get(o, path);
    memcpy(outer, path, (size_t)(dot - path));
    outer[dot - path] = 0;
    return value_of(json_object_get(o, outer), dot + 1);
}

TEST(test_numbers)
{
    const struct {
        const char *path;
        double value;
    } expected[] = {{"segments", 370},
                    {"bushings", 370},
                    {"rollers", 32},
                    {"contact_candidates", 1795},
                    {"contact_active_max", 64},
                    {"sim_time_s", 30},
                    {"wall_time_s", 0.5},
                    {"real_time_factor", 60},
                    {"steps", 3000},
                    {"steps_per_second", 6000},
                    {"rhs_evals", 4000},
                    {"newton_iters", 3900},
                    {"jac_evals", 60},
                    {"lin_setups", 240},
                    {"error_test_fails", 5},
                    {"newton_fails", 6},
                    {"contact_refreshes", 70},
                    {"threads", 2},
                    {"pull_force.steady_mean_N", 13000.5},
                    {"pull_force.peak_N", 14000.25},
                    {"pull_force.steady_ripple_rms_N", 7.5},
                    {"theory.paper_total_N", 12903.21},
                    {"theory.reference_total_N", 13010},
                    {"tension_error.max_pct", 4},
                    {"tension_error.mean_pct", 2},
                    {"tension_error.max_pct_paper", 5},
                    {"tension_error.mean_pct_paper", 3},
                    {"speed.steady_m_per_s", 0.1},
                    {"speed.settle_time_s", 13.25},
                    {"steady_window.from_s", 18},
                    {"steady_window.to_s", 30},
                    {"balance.carried_J", 11},
                    {"balance.residual_J", 12},
                    {"balance.turnover_J", 13},
                    {"balance.residual_share", 14},
                    {"balance.numerical_J", 22},
                    {"balance.numerical_share", 23},
                    {"pull_force.steady_mean_error.time_N", 1.5},
                    {"pull_force.steady_mean_error.mesh_N", 2.5},
                    {"pull_force.steady_mean_error.friction_N", 3.5},
                    {"pull_force.steady_mean_error.total_N", 7.5},
                    {"pull_force.peak_error.total_N", 60},
                    {"balance.impulse_residual_share", 15},
                    {"balance.work_J.winch", 16},
                    {"balance.lost_J.bearings", 17},
                    {"balance.stored_J.height", 18},
                    {"relaxation.iterations", 12},
                    {"relaxation.residual_N", 1e-3},
                    {"relaxation.tolerance_N", 1e-2},
                    {"relaxation.segment", 77},
                    {"relaxation.moved_m", 0.002},
                    {"phases_s.relax", 1},
                    {"phases_s.rhs", 2},
                    {"phases_s.contacts", 3},
                    {"phases_s.jacobian", 4},
                    {"phases_s.factor", 5},
                    {"phases_s.solve", 6},
                    {"phases_s.vector", 7},
                    {"phases_s.output", 8},
                    {"phases_s.other", 9}};
    json_t *o = write_and_read(&full, &labels);
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        json_t *v = value_of(o, expected[i].path);
        if (!json_is_number(v)) fail_msg("%s is not a number", expected[i].path);
        if (!(fabs(json_number_value(v) - expected[i].value) <= 1e-12 * expected[i].value)) {
            fail_msg("%s is %.17g", expected[i].path, json_number_value(v));
        }
    }
    assert_true(json_is_true(value_of(o, "relaxation.reached")));
    assert_true(json_is_true(value_of(o, "planar")));
    json_decref(o);
}

TEST(test_texts)
{
    const char *const expected[][2] = {
        {"title", "A \"title\""}, {"case", "cases/x.yaml"},      {"outcome", "finished"},
        {"message", ""},          {"linear_solver", "block"},    {"linear_solver_why", "a plain chain"},
        {"ordering", "natural"},  {"version", hawser_version()}, {"planar_why", "all in one plane"}};
    json_t *o = write_and_read(&full, &labels);
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        assert_string_equal(json_string_value(json_object_get(o, expected[i][0])), expected[i][1]);
    }
    json_decref(o);
}

/* JSON has no NaN, no infinity, and no text but UTF-8: null. */
TEST(test_unknown_becomes_null)
{
    hawser_summary s = full;
    SummaryLabels l = labels;
    s.pull_mean_N = NAN;
    s.real_time_factor = INFINITY;
    s.ordering = NULL;
    l.title = "\xff\xfe";
    json_t *o = write_and_read(&s, &l);
    assert_true(json_is_null(value_of(o, "pull_force.steady_mean_N")));
    assert_true(json_is_null(json_object_get(o, "real_time_factor")));
    assert_true(json_is_null(json_object_get(o, "ordering")));
    assert_true(json_is_null(json_object_get(o, "title")));
    assert_true(json_is_number(value_of(o, "pull_force.peak_N")));
    json_decref(o);
}

/* Rollers that move have a table of their own, which others stay out of; without any there is none. */
TEST(test_moving_rollers)
{
    const hawser_roller roller[2] = {{"fixed", 0.5, 160e3, 100, 200, 320, NAN, NAN, NAN, 2, 3},
                                     {"P2", NAN, 0, 0, 0, 10, 1.5, NAN, NAN, 0, 1}};
    json_t *o = write_and_read(&full, &labels);
    assert_null(json_object_get(o, "moving_rollers"));
    json_decref(o);
    SummaryLabels with = labels;
    with.n_rollers = 2;
    with.roller = roller;
    o = write_and_read(&full, &with);
    json_t *const list = json_object_get(o, "moving_rollers"), *const row = json_array_get(list, 0);
    assert_int_equal(json_array_size(list), 1);
    assert_string_equal(json_string_value(json_object_get(row, "name")), "P2");
    check_equal(json_real_value(json_object_get(row, "steady_spin_rad_per_s")), 1.5);
    assert_true(json_is_null(json_object_get(row, "steady_shift_m")) && json_is_null(json_object_get(row, "s_m")));
    json_decref(o);
}
