/* Every function of the public headers with nothing in place of each of its arguments: a status with the argument's
 * name, or an empty answer, and no harm done; without a place for the error too. A function that is declared and not
 * called here is a failure. */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "hawser/hawser.h"
#include "hawser/report.h"
#include "hawser/study.h"
#include "hawser/sweep.h"
#include "hawser/validate.h"
#include "tests/support/check.h"
#include "tests/support/data.h"

static hawser_case *c;
static hawser_sim *s;
static hawser_routes *r;
static hawser_error error;

/* name(arguments, err) refuses the argument that is called so. */
#define REFUSED(argument, name, ...)                                                                                   \
    do {                                                                                                               \
        error = (hawser_error){.status = HAWSER_OK};                                                                   \
        assert_int_equal(name(__VA_ARGS__, &error), HAWSER_ERR_INPUT);                                                 \
        assert_string_equal(error.key, argument);                                                                      \
        check_has(error.message, "NULL");                                                                              \
        assert_int_equal(name(__VA_ARGS__, NULL), HAWSER_ERR_INPUT);                                                   \
    } while (0)

static void cases(void)
{
    hawser_case *out = NULL;
    char *text = NULL;
    REFUSED("path", hawser_case_load, NULL, &out);
    REFUSED("out", hawser_case_load, "x", NULL);
    REFUSED("text", hawser_case_parse, NULL, "x", &out);
    REFUSED("name", hawser_case_parse, "a: b", NULL, &out);
    REFUSED("out", hawser_case_parse, "a: b", "x", NULL);
    REFUSED("text", hawser_case_parse_json, NULL, "x", &out);
    REFUSED("name", hawser_case_parse_json, "{}", NULL, &out);
    REFUSED("out", hawser_case_parse_json, "{}", "x", NULL);
    REFUSED("dir", hawser_case_resume, NULL, &out);
    REFUSED("out", hawser_case_resume, ".", NULL);
    REFUSED("c", hawser_case_set, NULL, "a", "b");
    REFUSED("key", hawser_case_set, c, NULL, "b");
    REFUSED("value", hawser_case_set, c, "a", NULL);
    REFUSED("c", hawser_case_copy, NULL, &out);
    REFUSED("out", hawser_case_copy, c, NULL);
    REFUSED("c", hawser_case_get, NULL, "title", &text);
    REFUSED("key", hawser_case_get, c, NULL, &text);
    REFUSED("text", hawser_case_get, c, "title", NULL);
    REFUSED("c", hawser_case_pack, NULL, &text);
    REFUSED("text", hawser_case_pack, c, NULL);
    REFUSED("text", hawser_case_unpack, NULL, &out);
    REFUSED("out", hawser_case_unpack, "{}", NULL);
    REFUSED("c", hawser_case_folder, NULL, ".");
    REFUSED("folder", hawser_case_folder, c, NULL);
    REFUSED("c", hawser_case_spares, NULL, "x");
    REFUSED("path", hawser_case_spares, c, NULL);
    error = (hawser_error){.status = HAWSER_OK};
    assert_int_equal(hawser_case_check(NULL, &error), HAWSER_ERR_INPUT);
    int changes;
    REFUSED("text", hawser_case_schema, NULL);
    REFUSED("text", hawser_study_schema, NULL);
    REFUSED("text", hawser_job_schema, NULL);
    REFUSED("text", hawser_summary_schema, NULL);
    assert_null(hawser_nearest(NULL, NULL, 1));
    REFUSED("path", hawser_case_upgrade, NULL, "to.yaml", &changes);
    REFUSED("changes", hawser_case_upgrade, "case.yaml", "to.yaml", NULL);
    REFUSED("c", hawser_case_describe, NULL, HAWSER_JSON, &text);
    REFUSED("text", hawser_case_describe, c, HAWSER_JSON, NULL);
    REFUSED("c", hawser_case_theory, NULL, HAWSER_JSON, &text);
    REFUSED("text", hawser_case_theory, c, HAWSER_JSON, NULL);
    REFUSED("c", hawser_case_theory_shown, NULL, HAWSER_JSON, NULL, &text, NULL);
    REFUSED("c", hawser_case_equipment, NULL, HAWSER_JSON, &text);
    REFUSED("text", hawser_case_equipment, c, HAWSER_JSON, NULL);
    REFUSED("c", hawser_fmu_write, NULL, HAWSER_FMI_3, "x");
    REFUSED("path", hawser_fmu_write, c, HAWSER_FMI_3, NULL);
    REFUSED("text", hawser_library, NULL, NULL, HAWSER_JSON, NULL);
    REFUSED("file", hawser_library_add, NULL, "ducts", "x", 1, (const char *const[]){"radius=1m"});
    REFUSED("values", hawser_library_add, "x.yaml", "ducts", "x", 1, NULL);
    hawser_case_free(NULL);
    hawser_text_free(NULL);
    assert_true(hawser_version_number() > 0 && *hawser_version());
}

static void motion(void)
{
    hawser_sim *out = NULL;
    void *bytes = NULL;
    size_t size = 0;
    char *text = NULL;
    const hawser_force force = {.force_N = {1, 0, 0}};
    REFUSED("c", hawser_sim_new, NULL, NULL, &out);
    REFUSED("out", hawser_sim_new, c, NULL, NULL);
    REFUSED("c", hawser_sim_new_sized, NULL, NULL, 0, &out);
    REFUSED("s", hawser_sim_relax, NULL, NULL);
    REFUSED("s", hawser_sim_advance, NULL, 1, 0);
    REFUSED("s", hawser_sim_run, NULL, NULL, NULL, NULL);
    REFUSED("s", hawser_sim_resume, NULL, ".", NULL, NULL);
    REFUSED("dir", hawser_sim_resume, s, NULL, NULL, NULL);
    REFUSED("s", hawser_sim_save, NULL, "x");
    REFUSED("path", hawser_sim_save, s, NULL);
    REFUSED("s", hawser_sim_load, NULL, "x");
    REFUSED("path", hawser_sim_load, s, NULL);
    REFUSED("s", hawser_sim_save_memory, NULL, &bytes, &size);
    REFUSED("bytes", hawser_sim_save_memory, s, NULL, &size);
    REFUSED("size", hawser_sim_save_memory, s, &bytes, NULL);
    REFUSED("s", hawser_sim_load_memory, NULL, "x", 1);
    REFUSED("bytes", hawser_sim_load_memory, s, NULL, 1);
    REFUSED("s", hawser_sim_control, NULL, HAWSER_WINCH_PAUSE, NULL, 0, 0);
    REFUSED("what", hawser_sim_control, s, HAWSER_JAM, NULL, 0, 0);
    REFUSED("s", hawser_sim_force, NULL, 0, &force, 0);
    REFUSED("s", hawser_sim_set_law, NULL, 0, 1, NULL, 0, NULL);
    REFUSED("s", hawser_sim_summary_json, NULL, &text);
    REFUSED("text", hawser_sim_summary_json, s, NULL);
    hawser_sim_on_step(NULL, NULL, NULL);
    hawser_sim_on_event(NULL, NULL, NULL);
    hawser_sim_on_log(NULL, HAWSER_LOG_INFO, NULL, NULL);
    hawser_sim_record(NULL);
    assert_int_equal(hawser_sim_chains(NULL), 0);
    assert_null(hawser_sim_chain(NULL, 0));
    assert_string_equal(hawser_sim_chain_name(NULL), "");
    hawser_sim_free(NULL);
    hawser_bytes_free(NULL);
}

static void looks(void)
{
    const hawser_contact *contact;
    const hawser_cable_point *joint;
    const hawser_geometry *geometry;
    hawser_envelope envelope;
    hawser_route_place place;
    double length;
    int n;
    REFUSED("s", hawser_sim_contacts, NULL, &contact, &n);
    REFUSED("out", hawser_sim_contacts, s, NULL, &n);
    REFUSED("n", hawser_sim_contacts, s, &contact, NULL);
    REFUSED("s", hawser_sim_cable, NULL, &joint, &n, NULL);
    REFUSED("out", hawser_sim_cable, s, NULL, &n, NULL);
    REFUSED("n", hawser_sim_cable, s, &joint, NULL, NULL);
    REFUSED("s", hawser_sim_watch_envelope, NULL);
    REFUSED("s", hawser_sim_envelope, NULL, 0, &envelope);
    REFUSED("out", hawser_sim_envelope, s, 0, NULL);
    REFUSED("s", hawser_sim_geometry, NULL, &geometry);
    REFUSED("out", hawser_sim_geometry, s, NULL);
    REFUSED("s", hawser_sim_route_length, NULL, &length);
    REFUSED("out", hawser_sim_route_length, s, NULL);
    REFUSED("s", hawser_sim_route_at, NULL, 0, &place);
    REFUSED("out", hawser_sim_route_at, s, 0, NULL);
}

/* Each `out` of a list that there is none of. */
#define EMPTY(name, type)                                                                                              \
    do {                                                                                                               \
        type *rows;                                                                                                    \
        assert_int_equal(name(NULL, &rows), 0);                                                                        \
        assert_int_equal(name(s, NULL), 0);                                                                            \
    } while (0)

static void tables(void)
{
    hawser_limit limit[HAWSER_LIMITS_MAX];
    char text[2 * HAWSER_SHOWN_MAX];
    hawser_summary summary = {.segments = 7};
    EMPTY(hawser_sim_machines, const hawser_machine);
    EMPTY(hawser_sim_modes, const hawser_mode);
    EMPTY(hawser_sim_events, const hawser_event);
    EMPTY(hawser_sim_positions, const hawser_position);
    EMPTY(hawser_sim_places, const hawser_place);
    EMPTY(hawser_sim_stations, const hawser_station);
    EMPTY(hawser_sim_rollers, const hawser_roller);
    EMPTY(hawser_sim_surfaces, const hawser_surface);
    EMPTY(hawser_sim_assumptions, const hawser_assumption);
    assert_int_equal(hawser_sim_limits(NULL, limit), 0);
    assert_int_equal(hawser_sim_limits(s, NULL), 0);
    hawser_sim_summary(NULL, &summary);
    hawser_sim_summary_sized(s, NULL, sizeof summary);
    assert_int_equal(summary.segments, 7);
    assert_null(hawser_sim_sample(NULL));
    check_nan(hawser_sim_time(NULL));
    check_nan(hawser_sim_end_time(NULL));
    assert_string_equal(hawser_sim_title(NULL), "");
    assert_string_equal(hawser_sim_answer(NULL, HAWSER_SI, text, sizeof text), "");
    assert_string_equal(hawser_sim_answer(s, HAWSER_SI, NULL, 0), "");
    check_nan(hawser_machine_figure(NULL, "force_N"));
    assert_int_equal(hawser_limits_verdict(1, NULL, text, sizeof text), -1);
    assert_int_equal(hawser_limits_verdict(0, limit, NULL, 0), -1);
    assert_int_equal(hawser_verdict(1, NULL, 0, limit, text, sizeof text), -1);
    assert_int_equal(hawser_verdict(0, NULL, 0, limit, NULL, 0), -1);
    assert_string_equal(hawser_word_code(hawser_verdict_word(-1)), "not_judged");
    assert_string_equal(hawser_word_text(hawser_verdict_word(-3)), "SAFE ONLY IF");
    assert_int_equal(hawser_word_of(NULL), HAWSER_WORDS);
    assert_string_equal(hawser_show(1, NULL, HAWSER_SI, text), "");
    assert_string_equal(hawser_show(1, "N", HAWSER_SI, NULL), "");
    assert_string_equal(hawser_show_figure(NULL, HAWSER_SI, text), "");
    assert_string_equal(hawser_show_text(NULL, HAWSER_US, text, sizeof text), "");
    assert_string_equal(hawser_show_text("1 N", HAWSER_US, NULL, 0), "");
}

static void routes(void)
{
    const hawser_route_options usual = hawser_route_defaults();
    hawser_routes *out = NULL;
    hawser_route_figures figures;
    hawser_route_bend *bend;
    hawser_route_place place;
    char *text;
    double length;
    int n;
    REFUSED("path", hawser_routes_read, NULL, &usual, &out);
    REFUSED("out", hawser_routes_read, "x.csv", &usual, NULL);
    REFUSED("r", hawser_routes_describe, NULL, HAWSER_JSON, &text);
    REFUSED("text", hawser_routes_describe, r, HAWSER_JSON, NULL);
    REFUSED("r", hawser_routes_figures, NULL, 0, &figures);
    REFUSED("out", hawser_routes_figures, r, 0, NULL);
    REFUSED("r", hawser_routes_bends, NULL, 0, &n, &bend);
    REFUSED("n", hawser_routes_bends, r, 0, NULL, &bend);
    REFUSED("bends", hawser_routes_bends, r, 0, &n, NULL);
    REFUSED("r", hawser_routes_length, NULL, 0, &length);
    REFUSED("length_m", hawser_routes_length, r, 0, NULL);
    REFUSED("r", hawser_routes_at, NULL, 0, 0, &place);
    REFUSED("out", hawser_routes_at, r, 0, 0, NULL);
    REFUSED("r", hawser_routes_write, NULL, 0, "x.csv");
    REFUSED("path", hawser_routes_write, r, 0, NULL);
    assert_int_equal(hawser_routes_at(r, 0, NAN, &place, &error), HAWSER_ERR_INPUT);
    assert_int_equal(hawser_routes_figures(r, -1, &figures, &error), HAWSER_ERR_INPUT);
    assert_int_equal(hawser_routes_figures(r, 1000, &figures, &error), HAWSER_ERR_INPUT);
    assert_int_equal(hawser_routes_count(NULL), 0);
    hawser_route_bends_free(NULL);
    hawser_routes_free(NULL);
}

static void others(void)
{
    static const char *const folder[] = {"nowhere", NULL}, *const key[] = {"friction.mu"};
    const hawser_certificate nothing = {.tolerance = 0.01};
    hawser_certificate *certificate;
    hawser_study *study;
    hawser_job *job;
    char *text;
    int n;
    REFUSED("c", hawser_certify, NULL, s, NULL, &certificate);
    REFUSED("run", hawser_certify, c, NULL, NULL, &certificate);
    REFUSED("out", hawser_certify, c, s, NULL, NULL);
    REFUSED("certificate", hawser_certificate_text, NULL, HAWSER_JSON, &text);
    REFUSED("text", hawser_certificate_text, &nothing, HAWSER_JSON, NULL);
    REFUSED("certificate", hawser_certificate_write, NULL, "x");
    REFUSED("dir", hawser_certificate_write, &nothing, NULL);
    hawser_certificate_free(NULL);
    REFUSED("path", hawser_job_load, NULL, &job);
    REFUSED("out", hawser_job_load, "x.yaml", NULL);
    REFUSED("job", hawser_job_answer, NULL, HAWSER_JSON, &text, NULL);
    REFUSED("job", hawser_job_page, NULL, HAWSER_SI, "x.html");
    REFUSED("job", hawser_job_crew_sheets, NULL, HAWSER_SI, "x.html");
    REFUSED("job", hawser_job_workbook, NULL, "x.xlsx");
    hawser_job_free(NULL);
    REFUSED("path", hawser_desk_write, NULL, NULL);
    REFUSED("model", hawser_model_convert, NULL, "x.glb", NULL, &text);
    REFUSED("path", hawser_model_convert, "x.ifc", NULL, NULL, &text);
    REFUSED("text", hawser_model_convert, "x.ifc", "x.glb", NULL, NULL);
    REFUSED("c", hawser_case_calculation, NULL, HAWSER_SI, "x.html", NULL);
    REFUSED("c", hawser_case_place, NULL, NULL, HAWSER_TABLE, &text, NULL);
    REFUSED("c", hawser_case_crew_sheet, NULL, HAWSER_SI, "x.html", NULL);
    REFUSED("folders", hawser_report_write, NULL, 1, "x.html");
    REFUSED("folders", hawser_report_write, folder, 2, "x.html");
    REFUSED("path", hawser_report_write, folder, 1, NULL);
    REFUSED("folder", hawser_results_check, NULL);
    REFUSED("folder", hawser_plot_write, NULL, ".", 0, NULL, HAWSER_SI, NULL);
    REFUSED("dir", hawser_plot_write, ".", NULL, 0, NULL, HAWSER_SI, NULL);
    REFUSED("names", hawser_plot_write, ".", ".", 1, NULL, HAWSER_SI, NULL);
    REFUSED("path", hawser_study_load, NULL, &study);
    REFUSED("out", hawser_study_load, "x.yaml", NULL);
    REFUSED("s", hawser_study_run, NULL, ".", NULL);
    REFUSED("s", hawser_study_answer, NULL, HAWSER_TABLE, &text);
    REFUSED("s", hawser_study_run_on, NULL, ".", NULL, NULL);
    REFUSED("s", hawser_study_task, NULL, ".", 0, NULL);
    REFUSED("dir", hawser_study_report, NULL, "x.html");
    REFUSED("page", hawser_study_report, ".", NULL);
    hawser_study_free(NULL);
    REFUSED("ranks", hawser_ranks_open, NULL);
    hawser_ranks_close(NULL);
    REFUSED("c", hawser_case_sensitivities, NULL, HAWSER_TABLE, &text);
    REFUSED("text", hawser_case_sensitivities, c, HAWSER_TABLE, NULL);
    REFUSED("c", hawser_case_run_sensitivities, NULL, 1, key, HAWSER_TABLE, NULL, NULL, &text, NULL);
    REFUSED("keys", hawser_case_run_sensitivities, c, 1, NULL, HAWSER_TABLE, NULL, NULL, &text, NULL);
    REFUSED("text", hawser_case_run_sensitivities, c, 1, key, HAWSER_TABLE, NULL, NULL, NULL, NULL);
    REFUSED("json", hawser_sensitivities_write, NULL, "x");
    REFUSED("dir", hawser_sensitivities_write, "{}", NULL);
    REFUSED("c", hawser_case_position_sensitivities, NULL, 1, key, HAWSER_TABLE, NULL, NULL, &text, NULL);
    REFUSED("keys", hawser_case_position_sensitivities, c, 1, NULL, HAWSER_TABLE, NULL, NULL, &text, NULL);
    REFUSED("text", hawser_case_position_sensitivities, c, 1, key, HAWSER_TABLE, NULL, NULL, NULL, NULL);
    REFUSED("results", hawser_compare, NULL, "x.csv", NULL, &text);
    REFUSED("log", hawser_compare, ".", NULL, NULL, &text);
    REFUSED("text", hawser_compare, ".", "x.csv", NULL, NULL);
    REFUSED("text", hawser_validate, NULL, HAWSER_JSON, NULL, &n);
    REFUSED("outside", hawser_validate, NULL, HAWSER_JSON, &text, NULL);
}

static char *read_all(const char *path)
{
    FILE *const f = fopen(path, "rb");
    if (!f) fail_msg("cannot read %s", path);
    fseek(f, 0, SEEK_END);
    const long size = ftell(f);
    char *const text = calloc((size_t)size + 1, 1);
    rewind(f);
    assert_int_equal(fread(text, 1, (size_t)size, f), (size_t)size);
    fclose(f);
    return text;
}

/* Whether the name of `length` stands in this file as a call: followed by ( or, in the macros, by a comma; or EMPTY. */
static int is_called(const char *own, const char *name, int length)
{
    for (const char *p = own; (p = strstr(p, "hawser_")); p += 7) {
        if (!strncmp(p, name, (size_t)length) && (p[length] == '(' || p[length] == ',')) return 1;
    }
    return 0;
}

/* Names in front of a parenthesis are those of functions; types of functions stand in parentheses themselves. */
static void none_is_left_out(const char *headers)
{
    static const char *const names[] = {"certify", "checkpoint", "control", "fmu",     "hawser", "library",
                                        "limits",  "query",      "report",  "route",   "shown",  "status",
                                        "study",   "sweep",      "tables",  "validate"};
    char *const own = read_all(HAWSER_SOURCE_DIR "/tests/cli/null_calls.c");
    int found = 0;
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        char path[1024];
        snprintf(path, sizeof path, "%s/%s.h", headers, names[k]);
        char *const text = read_all(path);
        for (const char *p = text; (p = strstr(p, "hawser_")); p++) {
            int n = 0;
            while (isalnum((unsigned char)p[n]) || p[n] == '_') n++;
            if (p[n] != '(' || (p > text && (isalnum((unsigned char)p[-1]) || p[-1] == '_'))) continue;
            if (!is_called(own, p, n)) fail_msg("%.*s is declared in %s.h and not called here", n, p, names[k]);
            found++;
        }
        free(text);
    }
    check_above(found, 80);
    free(own);
}

static void every_argument(void **state)
{
    const hawser_route_options usual = hawser_route_defaults();
    (void)state;
    if (hawser_case_parse(data_text("short-pull"), "pull.yaml", &c, &error) || hawser_sim_new(c, NULL, &s, &error) ||
        hawser_routes_read(HAWSER_SOURCE_DIR "/cases/routes/tunnel.csv", &usual, &r, &error))
        fail_msg("%s", error.message);
    cases();
    motion();
    looks();
    tables();
    routes();
    others();
    none_is_left_out(HAWSER_SOURCE_DIR "/include/hawser");
    assert_int_equal(hawser_sim_advance(s, 0.1, 0, &error), HAWSER_OK); /* as if nothing had been */
    hawser_routes_free(r);
    hawser_sim_free(s);
    hawser_case_free(c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_argument)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
