/* The public interface: cases, simulations side by side, runs with and without a folder, stopping, errors. */
#include "results_fixture.h"
#include "tests/io/case_fixture.h"
#include "tests/support/check.h"
#include "tests/support/data.h"

#include <pthread.h>

#include <jansson.h>

static hawser_case *make_case(void)
{
    hawser_case *const c = case_with(data_text("short-pull"), NULL);
    return c;
}

/* A simulation of the case with one value changed (key NULL: none). */
static hawser_sim *make_sim(const char *key, const char *value)
{
    hawser_case *c = make_case();
    hawser_sim *s = NULL;
    hawser_error err = {HAWSER_OK, ""};
    if (key && hawser_case_set(c, key, value, &err)) fail_msg("%s", err.message);
    if (hawser_sim_new(c, NULL, &s, &err)) fail_msg("%s", err.message);
    hawser_case_free(c);
    return s;
}

static double winch_force(hawser_sim *s) { return hawser_sim_sample(s)->winch_force; }

TEST(test_wrong_cases)
{
    hawser_case *c = (hawser_case *)1;
    hawser_error err = {HAWSER_OK, ""};
    assert_int_equal(hawser_case_load("/no/such/case.yaml", &c, &err), HAWSER_ERR_INPUT);
    assert_null(c);
    check_has(err.message, "/no/such/case.yaml");
    assert_int_equal(hawser_case_parse("a: [", "text", &c, &err), HAWSER_ERR_INPUT);
    assert_null(c);
    assert_int_equal(hawser_case_parse("tille: x\n", "text", &c, NULL), HAWSER_OK);
    assert_int_equal(hawser_case_check(c, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "text:1");
    hawser_sim *s = (hawser_sim *)1;
    assert_int_equal(hawser_sim_new(c, NULL, &s, &err), HAWSER_ERR_INPUT);
    assert_null(s);
    char *text = (char *)1;
    assert_int_equal(hawser_case_theory(c, HAWSER_TABLE, &text, &err), HAWSER_ERR_INPUT);
    assert_null(text);
    text = (char *)1;
    assert_int_equal(hawser_case_describe(c, HAWSER_TABLE, &text, NULL), HAWSER_ERR_INPUT);
    assert_null(text);
    hawser_case_free(c);
    hawser_case_free(NULL);
    hawser_sim_free(NULL);
    hawser_text_free(NULL);
}

/* A wrong setting leaves the case as it was; a right one counts from the next reading on. */
TEST(test_settings)
{
    hawser_case *c = make_case();
    hawser_error err = {HAWSER_OK, ""};
    assert_int_equal(hawser_case_check(c, NULL), HAWSER_OK);
    assert_int_equal(hawser_case_set(c, "run.duration", "long", &err), HAWSER_OK);
    assert_int_equal(hawser_case_check(c, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "run.duration");
    assert_int_equal(hawser_case_set(c, "run.duration", "3 s", NULL), HAWSER_OK);
    assert_int_equal(hawser_case_check(c, NULL), HAWSER_OK);
    hawser_sim *s = NULL;
    assert_int_equal(hawser_sim_new(c, NULL, &s, NULL), HAWSER_OK);
    check_equal(hawser_sim_end_time(s), 3);
    hawser_sim_free(s);
    hawser_case_free(c);
}

TEST(test_threads)
{
    hawser_case *c = make_case();
    hawser_sim *s = NULL;
    for (int n = -1; n <= 3; n++) {
        const hawser_options options = {.threads = n};
        const int fine = n >= 0 && n <= 2;
        assert_int_equal(hawser_sim_new(c, &options, &s, NULL), fine ? HAWSER_OK : HAWSER_ERR_INPUT);
        check_equal(fine, s != NULL);
        hawser_sim_free(s);
    }
    hawser_case_free(c);
}

TEST(test_texts)
{
    hawser_case *c = make_case();
    char *text = NULL;
    assert_int_equal(hawser_case_describe(c, HAWSER_JSON, &text, NULL), HAWSER_OK);
    json_t *o = json_loads(text, 0, NULL);
    hawser_text_free(text);
    check_equal(json_number_value(json_object_get(o, "segments")), 20);
    check_close(json_number_value(json_object_get(o, "chain_mass_kg")), 200, 1e-9);
    check_close(json_number_value(json_object_get(o, "route_length_m")), 20, 1e-9);
    json_decref(o);
    assert_int_equal(hawser_case_theory(c, HAWSER_JSON, &text, NULL), HAWSER_OK);
    o = json_loads(text, 0, NULL);
    hawser_text_free(text);
    check_close(json_number_value(json_object_get(o, "reference_total_N")), 784.8, 1e-6);
    check_close(json_number_value(json_object_get(o, "paper_total_N")), 784.8, 1e-6);
    json_decref(o);
    hawser_case_free(c);
}

/* Two simulations advanced in turn do exactly what each does alone. */
TEST(test_side_by_side)
{
    double alone[2], together[2];
    for (int k = 0; k < 2; k++) {
        hawser_sim *s = make_sim("friction.mu", k ? "0.3" : "0.2");
        assert_int_equal(hawser_sim_relax(s, NULL, NULL), HAWSER_OK);
        for (int i = 1; i <= 5; i++) assert_int_equal(hawser_sim_advance(s, 0.1 * i, 0, NULL), HAWSER_OK);
        alone[k] = winch_force(s);
        hawser_sim_free(s);
    }
    hawser_sim *pair[2] = {make_sim("friction.mu", "0.2"), make_sim("friction.mu", "0.3")};
    for (int k = 0; k < 2; k++) assert_int_equal(hawser_sim_relax(pair[k], NULL, NULL), HAWSER_OK);
    for (int i = 1; i <= 5; i++) {
        for (int k = 0; k < 2; k++) assert_int_equal(hawser_sim_advance(pair[k], 0.1 * i, 0, NULL), HAWSER_OK);
    }
    for (int k = 0; k < 2; k++) {
        together[k] = winch_force(pair[k]);
        hawser_sim_free(pair[k]);
        check_equal(together[k], alone[k]);
    }
    check_differs(alone[0], alone[1]);
}

/* What one thread of the next test does: everything, from the text to the folder. */
static void *run_thread(void *dir)
{
    hawser_case *c = NULL;
    hawser_sim *s = NULL;
    hawser_error *err = calloc(1, sizeof *err);
    hawser_status status = hawser_case_parse(data_text("short-pull"), "pull.yaml", &c, err);
    if (!status) status = hawser_sim_new(c, NULL, &s, err);
    hawser_case_free(c);
    if (!status) status = hawser_sim_run(s, dir, NULL, NULL, err);
    hawser_sim_free(s);
    if (!status) memset(err, 0, sizeof *err);
    return err;
}

/* Two threads with a simulation each, at the same time, write the same results. */
TEST_WITH(test_two_threads, fixture_new, fixture_free)
{
    const Fixture *f = *state;
    pthread_t thread[2];
    char dir[2][128], *text[2];
    for (int k = 0; k < 2; k++) {
        snprintf(dir[k], sizeof dir[k], "%s/%d", f->dir, k);
        assert_int_equal(pthread_create(&thread[k], NULL, run_thread, dir[k]), 0);
    }
    for (int k = 0; k < 2; k++) {
        void *result;
        pthread_join(thread[k], &result);
        const hawser_error *err = result;
        if (err->status) fail_msg("%s", err->message);
        free(result);
        strcat(dir[k], "/series.csv");
        text[k] = read_text(dir[k]);
        assert_non_null(text[k]);
    }
    assert_string_equal(text[0], text[1]);
    free(text[0]);
    free(text[1]);
}

TEST(test_sample)
{
    hawser_sim *s = make_sim(NULL, NULL);
    hawser_relaxation relaxation;
    assert_int_equal(hawser_sim_relax(s, &relaxation, NULL), HAWSER_OK);
    assert_true(relaxation.reached);
    check_at_most(relaxation.residual_N, relaxation.tolerance_N);
    assert_int_equal(hawser_sim_advance(s, 2, 1, NULL), HAWSER_OK);
    check_between(hawser_sim_time(s), 0, 2);
    assert_int_equal(hawser_sim_advance(s, 2, 0, NULL), HAWSER_OK);
    const hawser_sample *look = hawser_sim_sample(s);
    check_equal(look->t, hawser_sim_time(s));
    assert_int_equal(look->segments, 20);
    assert_int_equal(look->joints, 21);
    check_close(look->winch_speed, 0.1, 1e-12);
    /* the ramp takes half its second */
    check_close(look->winch_travel, 0.15, 1e-9);
    double weight = 0;
    for (int r = 0; r < look->rollers; r++) weight += look->roller_load[r];
    check_close(weight, 200 * 9.81, 100);
    for (int i = 0; i < 20; i++) check_close(look->axial_speed[i], 0.1, 1e-5);
    /* it cannot be relaxed any more */
    hawser_error err = {HAWSER_OK, ""};
    assert_int_equal(hawser_sim_relax(s, NULL, &err), HAWSER_ERR_INPUT);
    hawser_sim_free(s);
}

typedef struct Watch {
    int calls, stop_at, pass;
    double last_t, last_wall, end;
} Watch;

static int watch(void *user, const hawser_sample *sample, double wall_s, double end_s)
{
    Watch *w = user;
    if (sample->pass > w->pass) w->last_t = w->last_wall = 0; /* the second pass begins anew */
    w->pass = sample->pass;
    check_at_least(sample->t, w->last_t);
    check_at_least(wall_s, w->last_wall);
    w->last_t = sample->t;
    w->last_wall = wall_s;
    w->end = end_s;
    return ++w->calls == w->stop_at;
}

TEST(test_run)
{
    hawser_sim *s = make_sim(NULL, NULL);
    Watch w = {0};
    hawser_summary sum;
    const hawser_station *station;
    const hawser_roller *roller;
    assert_int_equal(hawser_sim_run(s, NULL, watch, &w, NULL), HAWSER_OK);
    check_at_least(w.calls, 2);
    check_equal(w.last_t, 2);
    check_equal(w.end, 2);
    hawser_sim_summary(s, &sum);
    assert_int_equal(sum.segments, 20);
    check_equal(sum.sim_time_s, 2);
    check_above(sum.steps, 0);
    check_above(sum.wall_time_s, 0);
    /* mu m g, less what the winch carries of the span to the next roller */
    check_close(sum.pull_mean_N, 392.4, 8);
    check_close(sum.steady_speed_m_per_s, 0.1, 1e-6);
    assert_int_equal(hawser_sim_stations(s, &station), 1);
    assert_string_equal(station->name, "middle");
    check_close(station->mean_N, station->reference_N, 8);
    const int n = hawser_sim_rollers(s, &roller);
    assert_int_equal(n, hawser_sim_sample(s)->rollers);
    check_close(roller[0].rating_N, 5000, 1e-9);
    assert_string_equal(hawser_sim_title(s), "A short pull");
    hawser_sim_free(s);
}

/* The phases and what is left make up the wall time. */
TEST(test_phases)
{
    hawser_sim *s = make_sim(NULL, NULL);
    hawser_summary sum;
    assert_int_equal(hawser_sim_run(s, NULL, NULL, NULL, NULL), HAWSER_OK);
    hawser_sim_summary(s, &sum);
    const hawser_phases *p = &sum.phases;
    const double parts = p->relax + p->rhs + p->contacts + p->jacobian + p->factor + p->solve + p->vector + p->output;
    check_share(parts + p->other, sum.wall_time_s, 1e-3);
    hawser_sim_free(s);
}

/* What summary.json in the folder says. */
static json_t *read_summary(const Fixture *f)
{
    char *text = read_text(fixture_path(f, "summary.json"));
    json_t *o = json_loads(text, 0, NULL);
    free(text);
    assert_non_null(o);
    return o;
}

/* A row at 0, one for every interval at the first step end in it, the last one at `end`. */
static void rows_check(const char *text, double interval, double end)
{
    double t = -1;
    int rows = 0;
    for (const char *line = strchr(text, '\n'); line && line[1]; line = strchr(line + 1, '\n'), ++rows) {
        t = strtod(line + 1, NULL);
        check_at_least(t, rows * interval - 1e-9);
        check_below(t, (rows + 1) * interval);
    }
    assert_int_equal(rows, lround(end / interval) + 1);
    check_equal(t, end);
}

TEST_WITH(test_run_into_folder, fixture_new, fixture_free)
{
    const Fixture *f = *state;
    hawser_sim *s = make_sim(NULL, NULL);
    assert_int_equal(hawser_sim_run(s, f->dir, NULL, NULL, NULL), HAWSER_OK);
    char *text = NULL;
    assert_int_equal(hawser_sim_summary_json(s, &text, NULL), HAWSER_OK);
    check_has(text, "\"outcome\": \"finished\"");
    hawser_text_free(text);
    hawser_sim_free(s);
    json_t *o = read_summary(f);
    assert_string_equal(json_string_value(json_object_get(o, "outcome")), "finished");
    assert_string_equal(json_string_value(json_object_get(o, "case")), "pull.yaml");
    check_equal(json_number_value(json_object_get(o, "sim_time_s")), 2);
    json_decref(o);
    text = read_text(fixture_path(f, "series.csv"));
    rows_check(text, 0.05, 2);
    free(text);
}

/* Stopped at its first step: the state of then is the last row. */
TEST_WITH(test_stop, fixture_new, fixture_free)
{
    const Fixture *f = *state;
    hawser_sim *s = make_sim("solver.relax", "false"); /* who relaxes for long is stopped there */
    Watch w = {.stop_at = 1};
    hawser_error err = {HAWSER_OK, ""};
    assert_int_equal(hawser_sim_run(s, f->dir, watch, &w, &err), HAWSER_STOPPED);
    check_has(err.message, "stopped at t =");
    json_t *o = read_summary(f);
    assert_string_equal(json_string_value(json_object_get(o, "outcome")), "stopped");
    json_decref(o);
    /* the rest of the run may follow */
    assert_int_equal(hawser_sim_run(s, NULL, NULL, NULL, &err), HAWSER_OK);
    check_equal(hawser_sim_time(s), 2);
    hawser_sim_free(s);
}

/* Relaxing and advancing by hand, with statistics, is the same run. */
TEST(test_by_hand)
{
    hawser_sim *whole = make_sim("output.states", "0 s"), *hand = make_sim("output.states", "0 s");
    hawser_summary a, b;
    assert_int_equal(hawser_sim_run(whole, NULL, NULL, NULL, NULL), HAWSER_OK);
    assert_int_equal(hawser_sim_relax(hand, NULL, NULL), HAWSER_OK);
    hawser_sim_record(hand);
    for (long row = 1; hawser_sim_time(hand) < 2;) {
        assert_int_equal(hawser_sim_advance(hand, 2, 1, NULL), HAWSER_OK);
        const double t = hawser_sim_time(hand);
        if (t < 0.05 * (double)row - 1e-9) continue;
        hawser_sim_record(hand);
        row = (long)floor(t / 0.05 + 1e-9) + 1;
    }
    hawser_sim_summary(whole, &a);
    hawser_sim_summary(hand, &b);
    assert_int_equal(a.steps, b.steps);
    check_close(a.pull_mean_N, b.pull_mean_N, 0);
    check_equal(a.pull_peak_N, b.pull_peak_N);
    check_equal(winch_force(whole), winch_force(hand));
    hawser_sim_free(whole);
    hawser_sim_free(hand);
}

/* The integration gives up (no computer has that many digits): what it had is kept, and the summary says why.
 */
TEST_WITH(test_failed_run, fixture_new, fixture_free)
{
    const Fixture *f = *state;
    hawser_sim *s = make_sim("solver.tolerances.position", "1e-25 m");
    hawser_error err = {HAWSER_OK, ""};
    assert_int_equal(hawser_sim_run(s, f->dir, NULL, NULL, &err), HAWSER_ERR_RUN);
    json_t *o = read_summary(f);
    assert_string_equal(json_string_value(json_object_get(o, "outcome")), "failed");
    assert_string_equal(json_string_value(json_object_get(o, "message")), err.message);
    json_decref(o);
    char *text = read_text(fixture_path(f, "series.csv"));
    check_has(text, "\n0,");
    free(text);
    hawser_sim_free(s);
}

/* Nothing is simulated when the folder cannot be written. */
TEST_WITH(test_unwritable, fixture_new, fixture_free)
{
    const Fixture *f = *state;
    hawser_sim *s = make_sim(NULL, NULL);
    hawser_error err = {HAWSER_OK, ""};
    fclose(fopen(fixture_path(f, "file"), "w"));
    assert_int_equal(hawser_sim_run(s, fixture_path(f, "file"), NULL, NULL, &err), HAWSER_ERR_OUTPUT);
    check_has(err.message, "file");
    check_equal(hawser_sim_time(s), 0);
    assert_int_equal(hawser_sim_run(s, f->dir, NULL, NULL, NULL), HAWSER_OK);
    hawser_sim_free(s);
}
