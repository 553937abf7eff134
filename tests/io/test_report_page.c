/* The page about a run: what stands in it is what the results say, whatever the run is called. */
#define _GNU_SOURCE /* memmem */
#include "hawser/hawser.h"
#include "tests/io/case_fixture.h"
#include "tests/support/check.h"
#include "tests/support/data.h"
#include "tests/support/scratch.h"

#include <jansson.h>
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* A title that would end the script, the page and the line, turn the text around and fill the page. */
static const char evil[] = "</script><script>alert(1)</script><!-- ' &amp; end";

/* Runs the short pull under a title into the folder. stop: after so many calls; 0: never. */
static int calls_left;
static int stop_after(void *user, const hawser_sample *sample, double wall, double end)
{
    (void)user, (void)sample, (void)wall, (void)end;
    return calls_left > 0 && --calls_left == 0;
}

static void run_pull(const char *title, const char *into, int stop)
{
    hawser_sim *s = NULL;
    hawser_error err = {0};
    hawser_case *const c = case_with(data_text("cli-pull"), NULL);
    if (title && hawser_case_set(c, "title", title, &err)) fail_msg("%s", err.message);
    if (hawser_sim_new(c, NULL, &s, &err)) fail_msg("%s", err.message);
    calls_left = stop;
    assert_int_equal(hawser_sim_run(s, into, stop_after, NULL, &err), stop ? HAWSER_STOPPED : HAWSER_OK);
    hawser_sim_free(s);
    hawser_case_free(c);
}

/* The page's data: what stands in the element, as a browser would take it out. */
static json_t *page_data(const char *page)
{
    static const char begin[] = "<script type=\"application/json\" id=\"hawser-data\">";
    const char *const from = strstr(page, begin), *const data = from + strlen(begin),
                      *const to = strstr(data, "</script>");
    assert_non_null(from);
    assert_non_null(to);
    json_error_t why;
    json_t *const all = json_loadb(data, (size_t)(to - data), 0, &why);
    if (!all) fail_msg("%s", why.text);
    return all;
}

static json_t *report_on(const char *folder)
{
    hawser_error err = {0};
    if (hawser_report_write(&folder, 1, scratch_path("page.html"), &err)) fail_msg("%s", err.message);
    char *const page = file_text(scratch_path("page.html"));
    json_t *const all = page_data(page);
    free(page);
    return all;
}

static json_t *first_run(json_t *all) { return json_array_get(json_object_get(all, "runs"), 0); }

/* A column of the page's table is a column of the file, number for number and letter for letter. */
static void compare_table(const json_t *table, const char *file)
{
    char *const text = file_text(scratch_path(file)), *save, *rest = text;
    char *names[200], *head = strtok_r(text, "\n", &rest);
    int n = 0, row = 0;
    for (char *name = strtok_r(head, ",", &save); name; name = strtok_r(NULL, ",", &save)) names[n++] = name;
    assert_int_equal(json_object_size(table), n + (json_object_get(table, "thinned_from") != NULL));
    for (char *line = strtok_r(NULL, "\n", &rest); line; line = strtok_r(NULL, "\n", &rest), row++) {
        for (int k = 0; k < n; k++) {
            const char *const cell = strsep(&line, ",");
            const json_t *const value = json_array_get(json_object_get(table, names[k]), (size_t)row);
            if (json_is_string(value)) assert_string_equal(json_string_value(value), cell);
            if (json_is_number(value)) check_equal(json_number_value(value), strtod(cell, NULL));
            if (json_is_null(value)) assert_string_equal(cell, "");
            assert_non_null(value);
        }
    }
    assert_true(row > 0);
    assert_int_equal(json_array_size(json_object_get(table, names[0])), row);
    free(text);
}

TEST_WITH(figures_are_the_results, scratch_make, scratch_remove)
{
    run_pull(NULL, scratch_folder(), 0);
    json_t *const all = report_on(scratch_folder()), *const run = first_run(all);
    char *const text = file_text(scratch_path("summary.json"));
    json_t *const summary = json_loads(text, 0, NULL);
    assert_int_equal(json_integer_value(json_object_get(all, "format")), 1);
    assert_string_equal(json_string_value(json_object_get(all, "hawser")), hawser_version());
    assert_true(json_equal(json_object_get(run, "summary"), summary));
    compare_table(json_object_get(run, "stations"), "stations.csv");
    compare_table(json_object_get(run, "rollers"), "rollers.csv");
    compare_table(json_object_get(run, "series"), "series.csv");
    compare_table(json_object_get(run, "theory_along"), "route.csv");
    const json_t *const states = json_object_get(run, "states");
    assert_int_equal(json_integer_value(json_object_get(states, "frames")), 5); /* 2 s, each half a second */
    assert_int_equal(json_integer_value(json_object_get(states, "segments")), 20);
    assert_true(json_object_size(json_object_get(states, "packed")) >= 5);
    assert_int_equal(json_array_size(json_object_get(run, "notes")), 0);
    assert_int_equal(json_array_size(json_object_get(json_object_get(run, "geometry"), "rollers")), 21);
    json_decref(summary);
    json_decref(all);
    free(text);
}

/* Every key of the case, with its line and origin. */
TEST_WITH(inputs_are_listed, scratch_make, scratch_remove)
{
    run_pull(NULL, scratch_folder(), 0);
    json_t *const all = report_on(scratch_folder());
    const json_t *const inputs = json_object_get(first_run(all), "inputs");
    int given = 0, defaults = 0;
    for (size_t i = 0; i < json_array_size(inputs); i++) {
        const json_t *const row = json_array_get(inputs, i);
        const char *const key = json_string_value(json_object_get(row, "key")),
                          *const value = json_string_value(json_object_get(row, "value")),
                          *const origin = json_string_value(json_object_get(row, "origin")),
                          *const where = json_string_value(json_object_get(row, "where"));
        given += strcmp(key, "drive.winch.speed") == 0 && strcmp(value, "6 m/min") == 0 &&
                 strcmp(origin, "given") == 0 && where && strncmp(where, "pull.yaml:", 10) == 0;
        given += strcmp(key, "chain.0.length") == 0 && strcmp(value, "10 m") == 0;
        given += strcmp(key, "output.speeds_of") == 0 && strcmp(value, "[0, 19]") == 0;
        defaults += strcmp(key, "solver.accuracy") == 0 && strcmp(value, "auto") == 0 && strcmp(origin, "default") == 0;
        defaults += strcmp(key, "gravity") == 0 && strcmp(value, "9.81 m/s2") == 0;
        if (strcmp(origin, "default") == 0) assert_null(where);
    }
    assert_int_equal(given, 3);
    assert_int_equal(defaults, 2);
    json_decref(all);
}

/* Neither the page nor its data get another element by what a run is called. */
TEST_WITH(hostile_titles_do_no_harm, scratch_make, scratch_remove)
{
    char *const quoted = malloc(20000);
    strcpy(quoted, "\"");
    strcat(quoted, "</script><script>alert(1)</script><!-- ' &amp; end");
    strcat(quoted, "\"");
    run_pull(quoted, scratch_folder(), 0);
    json_t *const all = report_on(scratch_folder());
    assert_string_equal(json_string_value(json_object_get(json_object_get(first_run(all), "summary"), "title")), evil);
    char *const page = file_text(scratch_path("page.html"));
    int scripts = 0, ends = 0;
    for (const char *at = page; (at = strstr(at, "<script")); at++) scripts++;
    for (const char *at = page; (at = strstr(at, "</script")); at++) ends++;
    assert_int_equal(scripts, 2);
    assert_int_equal(ends, 2); /* the bundle has none either */
    const char *const bundle = strstr(page, "id=\"hawser-data\"");
    const char *const alert = strstr(page, "alert(1)");
    assert_true(!alert || strncmp(alert - 9, "&#62;alert", 5) == 0 || alert > bundle - 100000);
    assert_null(strstr(page, "<!--"));
    /* ten thousand letters, straight into the summary: only the library's own keys are short */
    char *summary = file_text(scratch_path("summary.json")), *const title = strstr(summary, "\"title\"");
    char *const longer = malloc(strlen(summary) + 11000);
    const size_t before = (size_t)(title - summary);
    memcpy(longer, summary, before);
    const int begun = sprintf(longer + before, "\"title\": \"\xe2\x80\xae\xe2\x80\xa8"); /* turns and ends lines */
    memset(longer + before + begun, 'x', 10000 - 6);
    strcpy(longer + before + begun + 10000 - 6, "\"");
    strcat(longer, strstr(title, ",\n"));
    file_write(scratch_path("summary.json"), longer);
    json_t *const again = report_on(scratch_folder());
    assert_int_equal(strlen(json_string_value(json_object_get(json_object_get(first_run(again), "summary"), "title"))),
                     10000);
    json_decref(all);
    json_decref(again);
    free(page);
    free(summary);
    free(longer);
    free(quoted);
}

/* No request, no foreign script: the policy says so, and names the one script by its sum. */
TEST_WITH(the_policy_is_strict, scratch_make, scratch_remove)
{
    run_pull(NULL, scratch_folder(), 0);
    json_decref(report_on(scratch_folder()));
    char *const page = file_text(scratch_path("page.html"));
    check_has(page, "content=\"default-src 'none'; script-src 'sha256-");
    const char *const policy = strstr(page, "script-src");
    assert_null(memmem(policy, (size_t)(strchr(policy, ';') - policy), "unsafe", 6));
    assert_null(strstr(page, "src=\"http"));
    assert_null(strstr(page, "<link"));
    free(page);
}

TEST_WITH(a_run_that_was_stopped_has_a_page, scratch_make, scratch_remove)
{
    run_pull(NULL, scratch_folder(), 1);
    json_t *const all = report_on(scratch_folder());
    assert_string_equal(json_string_value(json_object_get(json_object_get(first_run(all), "summary"), "outcome")),
                        "stopped");
    char *const page = file_text(scratch_path("page.html"));
    check_has(page, "<tr><th>ended</th><td><bdi>stopped</bdi></td></tr>");
    free(page);
    json_decref(all);
}

/* What is missing or broken beside the summary is said on the page. */
TEST_WITH(missing_files_are_notes, scratch_make, scratch_remove)
{
    run_pull(NULL, scratch_folder(), 0);
    unlink(scratch_path("results.h5"));
    unlink(scratch_path("inputs.csv"));
    file_write(scratch_path("stations.csv"), "name,s_m\n\"open\n");
    const char *const folder = scratch_folder();
    hawser_error err = {0};
    assert_int_equal(hawser_report_write(&folder, 1, scratch_path("page.html"), &err), HAWSER_ERR_INPUT);
    check_has(err.message, "stations.csv' does not belong to the summary");
    /* as an older hawser wrote it, which did not say what belongs together */
    char *const summary = file_text(scratch_path("summary.json")), *const run = strstr(summary, "\"run\"");
    memcpy(run, "\"ran\"", 5);
    file_write(scratch_path("summary.json"), summary);
    free(summary);
    json_t *const all = report_on(scratch_folder()), *const said = first_run(all);
    assert_true(json_is_null(json_object_get(said, "stations")));
    assert_true(json_is_null(json_object_get(said, "inputs")));
    assert_null(json_object_get(said, "states"));
    assert_int_equal(json_array_size(json_object_get(said, "notes")), 2);
    check_has(json_string_value(json_array_get(json_object_get(said, "notes"), 0)), "a quote is not closed");
    check_has(json_string_value(json_array_get(json_object_get(said, "notes"), 1)), "no 3-D view");
    json_decref(all);
}

TEST_WITH(results_h5_may_be_anything, scratch_make, scratch_remove)
{
    run_pull(NULL, scratch_folder(), 0);
    file_write(scratch_path("results.h5"), "\211HDF\r\n\032\n and then nothing that is any use");
    json_t *const all = report_on(scratch_folder());
    assert_null(json_object_get(first_run(all), "states"));
    json_decref(all);
}

/* Reel and winch stand where the case puts them. */
TEST_WITH(machines_are_drawn, scratch_make, scratch_remove)
{
    hawser_error err = {0};
    hawser_sim *const s = sim_of(data_text("reel-payout"),
                                 (const char *const[]){"run.duration", "20 ms", "run.keep_going", "true", NULL});
    assert_int_equal(hawser_sim_run(s, scratch_folder(), NULL, NULL, &err), HAWSER_OK);
    hawser_sim_free(s);
    json_t *const all = report_on(scratch_folder()), *const drawn = json_object_get(first_run(all), "geometry");
    const json_t *const reel = json_object_get(drawn, "reel"), *const winch = json_object_get(drawn, "winch");
    static const struct {
        const char *key;
        double m;
    } size[] = {{"radius_m", 1}, {"barrel_radius_m", 0.6}, {"width_m", 1}};
    for (size_t k = 0; k < sizeof size / sizeof *size; ++k) {
        check_close(json_number_value(json_object_get(reel, size[k].key)), size[k].m, 1e-12);
    }
    const json_t *const centre = json_object_get(reel, "center_m"), *const way = json_object_get(winch, "direction");
    check_close(json_number_value(json_array_get(centre, 0)), -6, 1e-9);
    check_close(json_number_value(json_array_get(way, 0)), 1, 1e-12);
    json_decref(all);
}

TEST_WITH(folders_without_results_are_errors, scratch_make, scratch_remove)
{
    hawser_error err = {0};
    const char *folder = scratch_folder(), *const nowhere = "/nowhere/at/all",
               *many[7] = {scratch_folder(), scratch_folder(), scratch_folder(), scratch_folder(),
                           scratch_folder(), scratch_folder(), scratch_folder()};
    assert_int_equal(hawser_report_write(&folder, 1, scratch_path("page.html"), &err), HAWSER_ERR_INPUT);
    check_has(err.message, "there is no summary.json");
    assert_int_equal(hawser_report_write(&nowhere, 1, scratch_path("page.html"), &err), HAWSER_ERR_INPUT);
    check_has(err.message, "No such file");
    file_write(scratch_path("summary.json"), "{\"title\": ");
    assert_int_equal(hawser_report_write(&folder, 1, scratch_path("page.html"), &err), HAWSER_ERR_INPUT);
    check_has(err.message, "summary.json:1: not a summary");
    file_write(scratch_path("summary.json"), "[1]");
    assert_int_equal(hawser_report_write(&folder, 1, scratch_path("page.html"), &err), HAWSER_ERR_INPUT);
    assert_int_equal(hawser_report_write(many, 7, scratch_path("page.html"), &err), HAWSER_ERR_INPUT);
    check_has(err.message, "1 to 6");
    assert_int_equal(access(scratch_path("page.html"), F_OK), -1);
    file_write(scratch_path("summary.json"), "{}");
    assert_int_equal(hawser_report_write(&folder, 1, "/nowhere/page.html", &err), HAWSER_ERR_OUTPUT);
    assert_int_equal(hawser_report_write(&folder, 1, scratch_path("page.html"), &err), HAWSER_OK);
}

/* Six runs share the room for their states. */
TEST_WITH(runs_are_compared, scratch_make, scratch_remove)
{
    hawser_error err = {0};
    run_pull(NULL, scratch_path("a"), 0);
    run_pull("another", scratch_path("b"), 0);
    const char *const folders[2] = {scratch_path("a"), scratch_path("b")};
    assert_int_equal(hawser_report_write(folders, 2, scratch_path("page.html"), &err), HAWSER_OK);
    char *const page = file_text(scratch_path("page.html"));
    json_t *const all = page_data(page);
    assert_int_equal(json_array_size(json_object_get(all, "runs")), 2);
    check_has(page, "<title>A short pull and 1 more</title>");
    json_decref(all);
    free(page);
}

/* A program that writes decimal commas gets points. */
TEST_WITH(locales_change_nothing, scratch_make, scratch_remove)
{
    run_pull(NULL, scratch_folder(), 0);
    setenv("SOURCE_DATE_EPOCH", "0", 1);
    json_decref(report_on(scratch_folder()));
    char *const plain = file_text(scratch_path("page.html"));
    if (setlocale(LC_ALL, "de_DE.UTF-8")) {
        json_decref(report_on(scratch_folder()));
        char *const german = file_text(scratch_path("page.html"));
        assert_string_equal(plain, german);
        free(german);
        setlocale(LC_ALL, "C");
    }
    check_has(plain, "\"generated\":\"1970-01-01T00:00:00Z\"");
    unsetenv("SOURCE_DATE_EPOCH");
    free(plain);
}

TEST_WITH(figures_are_drawn, scratch_make, scratch_remove)
{
    hawser_error err = {0};
    int drawn = 0;
    const char *const one[] = {"tension"}, *const none[] = {"tensions"};
    run_pull(NULL, scratch_folder(), 0);
    assert_int_equal(hawser_plot_write(scratch_folder(), scratch_path("svg"), 0, NULL, HAWSER_SI, &drawn, &err),
                     HAWSER_OK);
    assert_int_equal(drawn, 4);
    char *const si = file_text(scratch_path("svg/tension.svg"));
    check_has(si, "tension, N");
    check_has(si, "</svg>");
    assert_int_equal(hawser_plot_write(scratch_folder(), scratch_path("us"), 1, one, HAWSER_US, &drawn, &err),
                     HAWSER_OK);
    assert_int_equal(drawn, 1);
    char *const us = file_text(scratch_path("us/tension.svg"));
    check_has(us, "along the route, ft");
    assert_int_equal(access(scratch_path("us/plan.svg"), F_OK), -1);
    assert_int_equal(hawser_plot_write(scratch_folder(), scratch_path("us"), 1, none, HAWSER_US, &drawn, &err),
                     HAWSER_ERR_INPUT);
    check_has(err.message, "is no figure");
    unlink(scratch_path("stations.csv"));
    assert_int_equal(hawser_plot_write(scratch_folder(), scratch_path("us"), 1, one, HAWSER_US, &drawn, &err),
                     HAWSER_ERR_INPUT);
    check_has(err.message, "it needs tension at stations");
    free(si);
    free(us);
}
