/* What a study reads: its own file, a list of samples, a logger's readings, and the rows that its workers have left.
 * The first byte says which; the rest is the text, or changes of rows whose sums are right. */
#define _GNU_SOURCE /* memfd_create */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"
#include "hawser/study.h"
#include "io/results/results_file.h"
#include "study/evaluate.h"
#include "study/findings.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/patches.h"

static const char base[] =
    "cables: {c: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 10 kN m2, d: 90 mm, mass: 20 kg/m}}\n"
    "chain: [{cable: c, length: 10 m, segment: 1 m}]\n"
    "route: {head_at: 10 m, pieces: [{straight: 20 m}, {bend: 30 deg, radius: 10 m, plane: left}, "
    "{straight: 5 m}]}\n"
    "rollers: {along: {from: 0 m, to: 20 m, spacing: 2 m}}\n"
    "friction: {mu: 0.2}\n"
    "drive: {winch: {speed: 0.5 m/s, to: 1 s}, tail: {tension: 1 kN}}\n"
    "limits: {pull: 20 kN}\n"
    "run: {duration: 2 s}\n";
enum { SAMPLES_LOOKED_AT = 5, SAMPLES_MOST = 200, CHANGES_MAX = 8 };

/* A text as a file without a name, at path[PATH_SIZE]; the descriptor. The file that a study calls NAME beside it is
 * /proc/self/fd/NAME. */
enum { PATH_SIZE = 64 };
static int file_of(const char *text, size_t size, char path[PATH_SIZE])
{
    const int fd = memfd_create("fuzz", 0);
    FUZZ_MUST(fd >= 0 && write(fd, text, size) == (ssize_t)size);
    snprintf(path, PATH_SIZE, "/proc/self/fd/%d", fd);
    return fd;
}

/* --------------------------------------------------------------------------------------------- studies and lists */

/* The points of a study that was read are points of its laws, and cases or errors. */
static void study_look(const Study *s)
{
    double *const x = calloc((size_t)s->n_parameters + 1, sizeof *x);
    FUZZ_MUST(x && s->samples > 0);
    for (long i = 0; !study_searches(s) && i < s->samples && i < SAMPLES_LOOKED_AT; ++i) {
        hawser_error err = {HAWSER_OK, ""};
        hawser_case *c = NULL;
        study_point(s, i, x);
        for (int k = 0; k < s->n_parameters; ++k) FUZZ_MUST(isfinite(x[k]));
        const hawser_status status = study_case(s, x, &c, &err);
        FUZZ_MUST(status ? fuzz_error_is_good((int)status, err.message) : c != NULL);
        hawser_case_free(c);
    }
    free(x);
}

static void text_as_study(const char *text, size_t size)
{
    char path[PATH_SIZE], unused[PATH_SIZE];
    hawser_error err = {HAWSER_OK, ""};
    hawser_study *all = NULL;
    Study *s = NULL;
    const int below = file_of(base, sizeof base - 1, unused), fd = file_of(text, size, path);
    hawser_status status = study_read(path, &s, &err);
    FUZZ_MUST(status ? !s && fuzz_error_is_good((int)status, err.message) : s != NULL);
    if (s) study_look(s);
    study_free(s);
    status = hawser_study_load(path, &all, &err);
    FUZZ_MUST(status ? !all && fuzz_error_is_good((int)status, err.message) : all != NULL);
    hawser_study_free(all);
    close(fd);
    close(below);
}

/* The case and the list are named by their descriptors. */
static void text_as_list(const char *text, size_t size)
{
    char path[PATH_SIZE], whole[200];
    const int below = file_of(base, sizeof base - 1, path), list = file_of(text, size, path);
    snprintf(whole, sizeof whole,
             "case: \"/proc/self/fd/%d\"\nlist: {file: \"/proc/self/fd/%d\"}\nquantities: [reference_total_N]\n", below,
             list);
    text_as_study(whole, strlen(whole));
    close(list);
    close(below);
}

/* ------------------------------------------------------------------------------------------------------ readings */

static void text_as_log(const char *text, size_t size)
{
    char path[PATH_SIZE];
    hawser_error err = {HAWSER_OK, ""};
    PullLog log = {0};
    LogPoint *point = NULL;
    const int fd = file_of(text, size, path);
    hawser_status status = log_read(path, &log, &err);
    if (!status) status = log_judge(&log, 0.1, size & 1, &err);
    if (status) FUZZ_MUST(fuzz_error_is_good((int)status, err.message));
    if (!status) {
        const double *const axis = log.length ? log.length : log.time;
        const int n = log_points(&log, axis, 0, 100, 20, &point);
        FUZZ_MUST(n >= 0);
        for (int k = 0; k < n; ++k) FUZZ_MUST(isfinite(point[k].at) && isfinite(point[k].force));
    }
    free(point);
    log_free(&log);
    close(fd);
}

/* ---------------------------------------------------------------------------------------------------------- rows */

static const char *const studies[] = {
    "parameters: {mu: {key: friction.mu, values: [0.1, 0.2, 0.3]}, n: {key: rollers.along.spacing, values: [1 m, 2 "
    "m]}}\n"
    "grid: [mu, n]\nquantities: [reference_total_N]\n",
    "parameters: {friction.mu: {range: {from: 0.1, to: 0.3}}, rollers.along.spacing: {values: [1 m, 2 m]}}\n"
    "optimise: {least: reference_total_N, evaluations: 20}\n",
    "parameters: {friction.mu: {uniform: {from: 0.1, to: 0.3}}, drive.tail.tension: {uniform: {from: 1 kN, "
    "to: 3 kN}}}\nsensitivity: {method: morris, samples: 4}\nquantities: [reference_total_N]\n"};
enum { STUDIES = sizeof studies / sizeof *studies };

static void row_write(Draws *d, int fd, const Study *s, long i)
{
    const int width = row_width(s);
    const size_t value_size = (size_t)width * sizeof(double), size = sizeof(Row) + value_size;
    unsigned char *const record = calloc(1, size);
    double *const value = malloc(value_size + 1);
    Row row = {.sample = i, .state = ROW_DONE, .verdict = VERDICT_SAFE, .limited_by = -1};
    FUZZ_MUST(record && value);
    for (int k = 0; k < LIMIT_KINDS; ++k) row.margin[k] = row.theory[k] = NAN;
    for (int k = 0; k < width; ++k) value[k] = 1 + 0.1 * (double)(i % 7);
    memcpy(record, &row, sizeof row);
    memcpy(record + sizeof row, value, value_size);
    for (uint32_t n = draws_take(d, 1) % CHANGES_MAX; n > 4; --n)
        patch_number(d, record, size, draws_take(d, 2) % size);
    memcpy(&row, record, sizeof row);
    memcpy(value, record + sizeof row, value_size);
    FUZZ_MUST(!store_append(fd, &row, value, width));
    free(value);
    free(record);
}

/* Everything that is said of rows; the folder is removed again. */
static void rows_say(const Study *s, const char *dir)
{
    static const char *const names[] = {"workers/a-0.rows", "workers/study", "workers",
                                        "samples.csv",      "study.html",    "study.yaml"};
    hawser_error err = {HAWSER_OK, ""};
    Rows rows = {0};
    Findings findings = {0};
    char *text = NULL;
    hawser_status status = rows_make(s, &rows, &err);
    if (!status) status = store_read(s, dir, &rows, &err);
    if (!status) status = findings_make(s, &rows, &findings, &err);
    if (!status) status = findings_text(s, &findings, HAWSER_JSON, &text, &err);
    OutDir folder = {.at = -1};
    if (!status) status = out_enter(&folder, dir, &err);
    if (!status) status = table_csv(s, &rows, &folder, &err);
    if (!status) status = study_page_write(s, &rows, &findings, &folder, "study.html", &err);
    out_leave(&folder);
    if (status) FUZZ_MUST(fuzz_error_is_good((int)status, err.message));
    hawser_text_free(text);
    findings_free(&findings);
    rows_free(&rows);
    for (size_t k = 0; k < sizeof names / sizeof *names; ++k) {
        char path[200];
        snprintf(path, sizeof path, "%s/%s", dir, names[k]);
        (void)remove(path);
    }
    (void)rmdir(dir);
}

static void bytes_as_rows(const uint8_t *data, size_t size)
{
    Draws d = {data, size};
    char path[PATH_SIZE], dir[] = "/tmp/hawser-fuzz-XXXXXX";
    hawser_error err = {HAWSER_OK, ""};
    Study *s = NULL;
    const int below = file_of(base, sizeof base - 1, path);
    const char *const text = studies[draws_take(&d, 1) % STUDIES];
    FUZZ_MUST(mkdtemp(dir));
    char own[sizeof dir + sizeof "/study.yaml"];
    snprintf(own, sizeof own, "%s/study.yaml", dir);
    FILE *const file = fopen(own, "w");
    FUZZ_MUST(file && fprintf(file, "case: \"%s\"\n%s", path, text) > 0 && !fclose(file));
    if (study_read(own, &s, &err)) fuzz_failed(err.message, __FILE__, __LINE__);
    FUZZ_MUST(!store_begin(s, dir, 1, &err));
    const int rows = store_open(dir, "a", 0);
    FUZZ_MUST(rows >= 0);
    for (long i = 0; i < s->samples && i < SAMPLES_MOST; ++i) row_write(&d, rows, s, i);
    close(rows);
    rows_say(s, dir);
    study_free(s);
    close(below);
}

FUZZ_TARGET(study)
{
    if (size == 0) return 0;
    char *const text = fuzz_text(data + 1, size - 1);
    switch (data[0] % 4) {
    case 0:
        text_as_study(text, size - 1);
        break;
    case 1:
        text_as_list(text, size - 1);
        break;
    case 2:
        text_as_log(text, size - 1);
        break;
    default:
        bytes_as_rows(data + 1, size - 1);
    }
    free(text);
    return 0;
}
