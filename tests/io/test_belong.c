/* Files of two runs in one folder: none of them is taken for another's, and who reads the folder says which is not. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "hawser/hawser.h"
#include "tests/support/check.h"
#include "tests/support/data.h"
#include "tests/support/scratch.h"

static int stop_first(void *user, const hawser_sample *sample, double wall, double end)
{
    (void)user, (void)sample, (void)wall, (void)end;
    return 1;
}

/* The short pull with a setting (key NULL: none). stop: at once. */
static void run_into(const char *folder, const char *key, const char *value, int stop)
{
    hawser_case *c = NULL;
    hawser_sim *s = NULL;
    hawser_error err = {0};
    if (hawser_case_parse(data_text("cli-pull"), "pull.yaml", &c, &err)) fail_msg("%s", err.message);
    if (key && hawser_case_set(c, key, value, &err)) fail_msg("%s", err.message);
    if (hawser_sim_new(c, NULL, &s, &err)) fail_msg("%s", err.message);
    assert_int_equal(hawser_sim_run(s, scratch_path(folder), stop ? stop_first : NULL, NULL, &err),
                     stop ? HAWSER_STOPPED : HAWSER_OK);
    hawser_sim_free(s);
    hawser_case_free(c);
}

static void copy(const char *from, const char *to)
{
    static char bytes[1 << 22];
    FILE *const a = fopen(from, "rb"), *const b = fopen(to, "wb");
    assert_true(a && b);
    const size_t n = fread(bytes, 1, sizeof bytes, a);
    assert_true(n > 0 && n < sizeof bytes);
    assert_int_equal(fwrite(bytes, 1, n, b), n);
    fclose(a);
    assert_int_equal(fclose(b), 0);
}

static void run_of(const char *folder, char run[17])
{
    char text[1024];
    FILE *const f = fopen(scratch_path_in(folder, "summary.json"), "r");
    assert_non_null(f);
    text[fread(text, 1, sizeof text - 1, f)] = 0;
    fclose(f);
    const char *const at = strstr(text, "\"run\": \"");
    assert_non_null(at);
    assert_int_equal(sscanf(at + 8, "%16[0-9a-f]", run), 1);
    assert_int_equal(strlen(run), 16);
}

static void expect_refused(const char *file)
{
    hawser_error err = {0};
    char path[256];
    snprintf(path, sizeof path, "%s' does not belong to the summary beside it", file);
    assert_int_equal(hawser_results_check(scratch_path("a"), &err), HAWSER_ERR_INPUT);
    check_has(err.message, path);
    const char *const folder = scratch_path("a");
    int drawn = 0;
    assert_int_equal(hawser_report_write(&folder, 1, scratch_path("page.html"), &err), HAWSER_ERR_INPUT);
    check_has(err.message, path);
    assert_int_equal(access(scratch_path("page.html"), F_OK), -1);
    assert_int_equal(hawser_plot_write(scratch_path("a"), scratch_path("plots"), 0, NULL, HAWSER_SI, &drawn, &err),
                     HAWSER_ERR_INPUT);
    check_has(err.message, path);
}

/* Two runs with another friction: each file of the one in the folder of the other. */
TEST_WITH(a_file_of_another_run_is_refused, scratch_make, scratch_remove)
{
    static const char *const files[] = {"series.csv", "stations.csv", "rollers.csv",
                                        "inputs.csv", "route.csv",    "results.h5"};
    hawser_error err = {0};
    char one[17], other[17];
    run_into("a", NULL, NULL, 0);
    run_into("b", "friction.mu", "0.31", 0);
    run_of("a", one);
    run_of("b", other);
    assert_string_not_equal(one, other);
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        copy(scratch_path_in("a", files[k]), scratch_path("kept"));
        copy(scratch_path_in("b", files[k]), scratch_path_in("a", files[k]));
        expect_refused(files[k]);
        copy(scratch_path("kept"), scratch_path_in("a", files[k]));
        if (hawser_results_check(scratch_path("a"), &err)) fail_msg("%s", err.message);
    }
    copy(scratch_path_in("b", "summary.json"), scratch_path_in("a", "summary.json"));
    expect_refused("series.csv");
}

/* A table that this run has not, and one that is cut off by a row. */
TEST_WITH(a_file_too_many_or_cut_off_is_refused, scratch_make, scratch_remove)
{
    hawser_error err = {0};
    run_into("a", NULL, NULL, 0);
    copy(scratch_path_in("a", "rollers.csv"), scratch_path_in("a", "modes.csv"));
    expect_refused("modes.csv");
    unlink(scratch_path_in("a", "modes.csv"));
    struct stat info;
    assert_int_equal(stat(scratch_path_in("a", "series.csv"), &info), 0);
    assert_int_equal(truncate(scratch_path_in("a", "series.csv"), info.st_size - 1), 0);
    expect_refused("series.csv");
    unlink(scratch_path_in("a", "series.csv")); /* what is missing is none of another run */
    if (hawser_results_check(scratch_path("a"), &err)) fail_msg("%s", err.message);
}

/* The same case has the same identity; what was stopped has another series, and its states are not these. */
TEST_WITH(states_of_another_series_are_refused, scratch_make, scratch_remove)
{
    hawser_error err = {0};
    char one[17], other[17];
    run_into("a", NULL, NULL, 0);
    run_into("b", NULL, NULL, 1);
    run_of("a", one);
    run_of("b", other);
    assert_string_equal(one, other);
    if (hawser_results_check(scratch_path("b"), &err)) fail_msg("%s", err.message);
    copy(scratch_path_in("b", "results.h5"), scratch_path_in("a", "results.h5"));
    expect_refused("results.h5");
}

/* Its figures may not stand beside those of a later run that has not asked for any. */
TEST_WITH(sensitivities_go_with_their_run, scratch_make, scratch_remove)
{
    run_into("a", NULL, NULL, 0);
    copy(scratch_path_in("a", "summary.json"), scratch_path_in("a", "sensitivities.json"));
    run_into("a", "friction.mu", "0.31", 0);
    assert_int_equal(access(scratch_path_in("a", "sensitivities.json"), F_OK), -1);
}

/* What was computed of another run, or does not say of which. */
TEST_WITH(a_certificate_or_sensitivities_of_another_run_are_refused, scratch_make, scratch_remove)
{
    static const char *const files[] = {"certificate.json", "sensitivities.json"};
    hawser_error err = {0};
    char one[17], text[64];
    run_into("a", NULL, NULL, 0);
    run_of("a", one);
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        char path[512];
        snprintf(path, sizeof path, "%s", scratch_path_in("a", files[k]));
        snprintf(text, sizeof text, "{\"run\": \"%s\"}", one);
        file_write(path, text);
        if (hawser_results_check(scratch_path("a"), &err)) fail_msg("%s", err.message);
        file_write(path, "{\"run\": \"0123456789abcdef\"}");
        expect_refused(files[k]);
        file_write(path, "{}");
        expect_refused(files[k]);
        file_write(path, "{\"run\": \"012");
        assert_int_equal(hawser_results_check(scratch_path("a"), &err), HAWSER_ERR_INPUT);
        check_has(err.message, "cannot read '");
        check_has(err.message, files[k]);
        unlink(path);
    }
}

/* A bit of results.h5 anywhere, or more behind it: HDF5 is not asked what it makes of that. Without its sum, as a run
 * that was killed leaves it, the file is read as before. */
TEST_WITH(a_damaged_file_of_states_is_refused, scratch_make, scratch_remove)
{
    enum { SEAL = 32 };
    hawser_error err = {0};
    char path[512];
    struct stat info;
    run_into("a", NULL, NULL, 0);
    snprintf(path, sizeof path, "%s", scratch_path_in("a", "results.h5"));
    assert_int_equal(stat(path, &info), 0);
    FILE *const f = fopen(path, "r+b");
    assert_non_null(f);
    for (long at = 0; at < info.st_size - SEAL; at += info.st_size / 61) {
        assert_int_equal(fseek(f, at, SEEK_SET), 0);
        const int byte = fgetc(f);
        for (int back = 0; back < 2; back++) {
            assert_int_equal(fseek(f, at, SEEK_SET), 0);
            fputc(back ? byte : byte ^ 4, f);
            fflush(f);
            assert_int_equal(hawser_results_check(scratch_path("a"), &err), back ? HAWSER_OK : HAWSER_ERR_INPUT);
            if (!back)
                check_has(err.message, "results.h5' is damaged: its bytes are not those that the run has written");
        }
    }
    fclose(f);
    assert_int_equal(truncate(path, info.st_size - SEAL), 0);
    if (hawser_results_check(scratch_path("a"), &err)) fail_msg("%s", err.message);
}
