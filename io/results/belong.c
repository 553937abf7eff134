/* Whether the files of a folder are of one run. A table of CSV has no place for a run's identity that its readers would
 * pass over, so that the summary has the sums of all tables; results.h5 has the run's identity and the sum of the
 * series.
 */
#include "core/base/error.h"
#include "core/base/file.h"
#include "io/results/results_h5.h"

#include <fcntl.h>
#include <jansson.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* What HDF5 may take to open a file and read two attributes, bytes. */
enum { ROOM = 4 << 20 };

/* What the summary says of a file; NULL: nothing. */
static const json_t *said_of(const json_t *files, const char *name)
{
    size_t k;
    json_t *file;
    json_array_foreach(files, k, file)
    {
        const char *const said = json_string_value(json_object_get(file, "file"));
        if (said && !strcmp(said, name)) return file;
    }
    return NULL;
}

/* A table that is there is the one that the run has written. */
static hawser_status table_check(const OutDir *dir, const json_t *files, const char *name, hawser_error *err)
{
    FileSum sum;
    const hawser_status status = file_sum(dir, name, &sum, err);
    if (status || sum.bytes < 0) return status;
    const json_t *const said = said_of(files, name);
    const char *const wanted = json_string_value(json_object_get(said, "sum"));
    if (wanted && !strcmp(wanted, sum.sum)) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT, "'%.500s/%s' does not belong to the summary beside it: %s", dir->path, name,
                     said ? "it is of another run, or was changed after this one"
                          : "this run has written no such file");
}

int states_belong(hid_t file, const char *run, const char *series)
{
    char has_run[DOOR_TEXT_MAX], has_series[DOOR_TEXT_MAX];
    door_text(file, "run", has_run);
    door_text(file, "series", has_series);
    return (!run || !*run || !strcmp(run, has_run)) && (!series || !strcmp(series, has_series));
}

/* Of which run, and of which series, the states are. */
typedef struct Belonging {
    const OutDir *dir;
    const char *run, *series;
} Belonging;

/* Prints a word if they are of another one. A file that cannot be opened says nothing: who reads it says so. */
static hawser_status belonging_read(void *user, FILE *out, hawser_error *err)
{
    const Belonging *const b = user;
    StatesFile states;
    (void)err;
    states_open(&states, b->dir);
    if (states.file >= 0 && !states_belong(states.file, b->run, b->series)) fputs("another", out);
    states_close(&states);
    return HAWSER_OK;
}

/* The states are those of the run; those of one that has ended are those of its series, too. */
static hawser_status states_check(const OutDir *dir, const char *run, const char *series, hawser_error *err)
{
    static const char *const name = STATES_FILE;
    Belonging b = {dir, run, series};
    int broken = 0, died;
    char *said;
    size_t size;
    hawser_status status = file_broken(dir, name, &broken, err);
    if (status) return status;
    if (broken)
        return error_set(err, HAWSER_ERR_INPUT,
                         "'%.600s/%s' is damaged: its bytes are not those that the run has written", dir->path, name);
    const int fd = file_open_in(dir->at, name, O_RDONLY);
    if (fd < 0) return HAWSER_OK; /* it says nothing */
    close(fd);
    if (!memory_room(ROOM)) return error_memory(err);
    status = apart_do(belonging_read, &b, &said, &size, &died, err);
    free(said);
    if (died && !status)
        return error_set(err, HAWSER_ERR_INPUT, "'%.600s/%s' is damaged: HDF5 does not survive to read it", dir->path,
                         name);
    if (status || size == 0) return status;
    return error_set(err, HAWSER_ERR_INPUT,
                     "'%.600s/%s' does not belong to the summary beside it: it is of another run", dir->path, name);
}

/* A file of JSON; *json NULL: it is not there. Without memory jansson finds fault with some word of it, so that it is
 * asked before whether there is any, and what it finds is looked for twice. Errors: INPUT, MEMORY. */
static hawser_status json_read(const OutDir *dir, const char *name, json_t **json, hawser_error *err)
{
    enum { MORE = 1 << 16, TIMES = 24, MOST = 1 << 28 };
    json_error_t where;
    OutSpot spot;
    char *text = NULL;
    size_t size;
    *json = NULL;
    hawser_status status = out_spot(&spot, dir, name, err);
    if (!status) status = file_whole_in(dir->at, name, spot.path, MOST, &text, &size, err);
    if (!text) return status;
    const int room = memory_room(MORE + TIMES * size);
    for (int twice = 0; twice < 2 && room && !*json; twice++)
        *json = json_loadb(text, size, JSON_REJECT_DUPLICATES, &where);
    if (!room)
        status = error_memory(err);
    else if (!*json)
        status = error_set(err, HAWSER_ERR_INPUT, "cannot read '%.600s': %.200s", spot.path, where.text);
    free(text);
    return status;
}

/* What was computed of a run says of which. */
static hawser_status companion_check(const OutDir *dir, const char *run, const char *name, hawser_error *err)
{
    json_t *json = NULL;
    hawser_status status = json_read(dir, name, &json, err);
    const char *const said = json_string_value(json_object_get(json, "run"));
    if (json && (!said || strcmp(said, run) != 0))
        status = error_set(err, HAWSER_ERR_INPUT, "'%.600s/%s' does not belong to the summary beside it: %s", dir->path,
                           name, said ? "it is of another run" : "it does not say of which run it is");
    json_decref(json);
    return status;
}

/* Before a run goes on: its checkpoint may have come from elsewhere. A summary that is not there says nothing. */
hawser_status summary_is_of(const OutDir *dir, const char *run, hawser_error *err)
{
    json_t *summary = NULL;
    hawser_status status = out_own(json_read(dir, "summary.json", &summary, err), err);
    const char *const there = json_string_value(json_object_get(summary, "run"));
    if (!status && run && *run && there && strcmp(run, there) != 0)
        status = error_set(err, HAWSER_ERR_OUTPUT,
                           "cannot go on in '%.600s': its results are of another run than its checkpoint", dir->path);
    json_decref(summary);
    return status;
}

/* Between a run and what is computed of it another one may have taken its folder's name. */
hawser_status companion_write(const char *dir, const char *name, const char *text, hawser_error *err)
{
    OutDir folder = {.at = -1};
    json_t *summary = NULL, *const own = json_loads(text, 0, NULL);
    const char *const run = json_string_value(json_object_get(own, "run"));
    hawser_status status = out_make_dir(dir, err);
    if (!status) status = out_enter(&folder, dir, err);
    if (!status) status = json_read(&folder, "summary.json", &summary, err);
    if (status == HAWSER_ERR_INPUT) status = HAWSER_OK; /* it says nothing */
    const char *const there = json_string_value(json_object_get(summary, "run"));
    if (!status && run && *run && there && strcmp(run, there) != 0)
        status = error_set(err, HAWSER_ERR_OUTPUT,
                           "cannot write '%.500s/%s': the results in this folder are of another run", dir, name);
    if (!status) status = out_whole_in(&folder, name, text, err);
    out_leave(&folder);
    json_decref(summary);
    json_decref(own);
    return status;
}

int is_running(const json_t *summary)
{
    const char *const outcome = json_string_value(json_object_get(summary, "outcome"));
    return outcome && !strcmp(outcome, "running");
}

hawser_status belong_check(const OutDir *dir, const json_t *summary, hawser_error *err)
{
    const json_t *const files = json_object_get(summary, "files");
    const char *const run = json_string_value(json_object_get(summary, "run"));
    const int listed = json_is_array(files) && !is_running(summary); /* its tables grow until the end */
    hawser_status status = HAWSER_OK;
    if (!run) return HAWSER_OK; /* of a hawser that did not say it yet */
    for (int k = 0; k < FILE_SUMS_MAX && !status && listed; k++) status = table_check(dir, files, sum_files[k], err);
    if (!status) status = companion_check(dir, run, "certificate.json", err);
    if (!status) status = companion_check(dir, run, "sensitivities.json", err);
    if (status) return status;
    return states_check(dir, run, json_string_value(json_object_get(said_of(files, "series.csv"), "sum")), err);
}
