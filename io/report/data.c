#include "io/report/report.h"

#include "core/base/error.h"
#include "io/report/states.h"
#include "io/results/results_h5.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* Rows of a series on a page; frames; those of which is guessed how many fit; tries of a file that is being written. */
enum { SERIES_MOST = 4000, FRAMES_MOST = 600, FRAMES_TRIED = 24, TRIES = 8 };
/* Bytes of packed states: of one run so many for a short chain and so many more for each segment, of all together. */
static const double states_least = 500e3, states_per_segment = 2.2e3, states_most = 7.5e6;

/* A number for JSON, null if it is not finite. */
static void number_add(Text *out, double value, int digits)
{
    if (isfinite(value)) text_print(out, "%.*g", digits, value);
    if (!isfinite(value)) text_add(out, "null");
}

/* A table under its key; null if the folder has none. */
static void sheet_add(Text *out, const char *key, const Sheet *sheet)
{
    text_print(out, ",\n\"%s\":", key);
    if (sheet->columns) sheet_json(sheet, 0, NULL, out);
    if (!sheet->columns) text_add(out, "null");
}

/* The series, thinned by the pull at the winch. */
static hawser_status series_add(Text *out, const Folder *folder, hawser_error *err)
{
    const Sheet *const series = &folder->series;
    int *const row = malloc(sizeof *row * (SERIES_MOST + 4));
    if (!row) return error_memory(err);
    text_add(out, ",\n\"series\":");
    if (!series->columns) {
        text_add(out, "null");
    } else {
        const int n = sheet_thin(series, sheet_column(series, "winch_force_N"), SERIES_MOST, row);
        sheet_json(series, n, row, out);
        out->size -= !out->failed; /* the closing brace: one key more */
        text_print(out, ",\"thinned_from\":%d}", series->rows);
    }
    free(row);
    return HAWSER_OK;
}

/* Rows of objects. A value and its unit are one text here. */
static void inputs_add(Text *out, const Sheet *inputs)
{
    static const char *const keys[] = {"key", "origin", "where", "source"};
    const int value = sheet_column(inputs, "value"), unit = sheet_column(inputs, "unit");
    text_add(out, ",\n\"inputs\":");
    if (!inputs->columns || value < 0 || unit < 0) {
        text_add(out, "null");
        return;
    }
    text_add(out, "[");
    for (int i = 0; i < inputs->rows; i++) {
        Text both = {0};
        text_print(&both, "%s%s%s", sheet_cell(inputs, i, value), *sheet_cell(inputs, i, unit) ? " " : "",
                   sheet_cell(inputs, i, unit));
        text_add(out, i ? ",\n{\"value\":" : "\n{\"value\":");
        text_json(out, both.at);
        out->failed |= both.failed;
        text_clear(&both);
        for (size_t k = 0; k < sizeof keys / sizeof *keys; k++) {
            const int column = sheet_column(inputs, keys[k]);
            if (column < 0 || !*sheet_cell(inputs, i, column)) continue;
            text_print(out, ",\"%s\":", keys[k]);
            text_json(out, sheet_cell(inputs, i, column));
        }
        text_add(out, "}");
    }
    text_add(out, "]");
}

static void notes_add(Text *out, const Folder *folder)
{
    text_add(out, ",\n\"notes\":[");
    for (int i = 0; i < folder->n_notes; i++) {
        if (i) text_add(out, ",");
        text_json(out, folder->note[i]);
    }
    text_add(out, "]");
}

/* Where the cable's front was at a time: the series has a row for every state. NAN: not known. */
static double front_at(const Sheet *series, int time, int front, double t, int *from)
{
    if (front < 0 || time < 0) return NAN;
    while (*from + 1 < series->rows && sheet_number(series, *from, time) < t - 1e-6 * (1 + fabs(t))) ++*from;
    return *from < series->rows ? sheet_number(series, *from, front) : NAN;
}

/* Everything but the fields themselves. */
static void states_head(Text *out, const States *s, const Sheet *series)
{
    int from = 0;
    const int time = sheet_column(series, "time_s"), front = sheet_column(series, "head_at_m");
    text_print(out, "\"frames\":%d,\"segments\":%d,\"thinned_from\":%d,\"time_s\":[", s->frames, s->segments, s->there);
    for (int i = 0; i < s->frames; i++) {
        if (i) text_add(out, ",");
        number_add(out, s->time[i], 9);
    }
    text_add(out, "],\"head_at_m\":[");
    for (int i = 0; i < s->frames; i++) {
        if (i) text_add(out, ",");
        number_add(out, front_at(series, time, front, s->time[i], &from), 9);
    }
    text_add(out, "],\"fields\":{");
    for (int k = 0, some = 0; k < FIELD_ROLLERS; k++) {
        const Field *const f = &s->field[k];
        if (!f->value) continue;
        text_print(out, "%s\"%s\":{\"components\":%d,\"unit\":\"%s\",\"step\":%g}", some++ ? "," : "", f->name,
                   f->components, f->unit, f->step);
    }
    text_add(out, "}");
}

/* The fields of the segments, then the forces on the rollers as an object of their own. */
static hawser_status fields_pack(const States *s, Text *segments, Text *rollers, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < FIELDS && !status; k++) {
        const Field *const f = &s->field[k];
        Text *const out = k == FIELD_ROLLERS ? rollers : segments;
        if (!f->value) continue;
        if (k == FIELD_ROLLERS)
            text_print(out, "{\"frames\":%d,\"items\":%d,\"components\":%d,\"unit\":\"%s\",\"step\":%g,\"packed\":\"",
                       s->frames, f->items, f->components, f->unit, f->step);
        else
            text_print(out, "%s\"%s\":\"", out->size ? "," : "", f->name);
        status = pack_field(s->frames, f->items, f->components, f->step, f->value, out, err);
        text_add(out, k == FIELD_ROLLERS ? "\"}" : "\"");
    }
    return status;
}

/* So many states of the file, packed: `segments` the fields, `rollers` their object. Errors: INPUT, MEMORY. */
static hawser_status states_try(hid_t file, int most, States *s, Text *segments, Text *rollers, hawser_error *err)
{
    text_clear(segments);
    text_clear(rollers);
    const hawser_status status = states_read(file, most, s, err);
    return status ? status : fields_pack(s, segments, rollers, err);
}

/* As many frames as fit into `goal` bytes. A few say how many that will be: frames that are nearer to each other take
 * less, so that the guess is on the safe side, and a second one is rare. */
static hawser_status states_add(Text *out, hid_t file, Folder *folder, double goal, hawser_error *err)
{
    hawser_error why = {HAWSER_OK, ""};
    Text segments = {0}, rollers = {0};
    States s = {0};
    hawser_status status = HAWSER_OK;
    for (int most = FRAMES_TRIED, again = 1; again && !status;) {
        states_clear(&s);
        status = states_try(file, most, &s, &segments, &rollers, &why);
        const double share = goal / (double)(segments.size + rollers.size + 1);
        const int fit = (int)fmin(FRAMES_MOST, fmax(2, 0.98 * share * s.frames));
        again = share < 1 ? fit < s.frames : s.frames < s.there && s.frames == FRAMES_TRIED && fit > s.frames;
        most = fit;
    }
    if (!status) {
        text_add(out, ",\n\"states\":{");
        states_head(out, &s, &folder->series);
        text_print(out, ",\n\"packed\":{%s}}", segments.at ? segments.at : "");
        text_print(out, ",\n\"roller_force\":%s", rollers.at ? rollers.at : "null");
    }
    out->failed |= segments.failed || rollers.failed;
    states_clear(&s);
    text_clear(&segments);
    text_clear(&rollers);
    if (status == HAWSER_ERR_INPUT) folder_say(folder, "%s: the page has no 3-D view", why.message);
    return status == HAWSER_ERR_MEMORY ? error_memory(err) : HAWSER_OK;
}

/* The file with its states. That of a run in progress may be caught before its first flush: a little later it is there.
 */
static void states_wait(StatesFile *s, const Folder *folder)
{
    const struct timespec nap = {0, 100 * 1000 * 1000};
    const int running = !strcmp(folder_text(folder, "outcome"), "running");
    states_open(s, &folder->home);
    for (int k = 0; running && k < TRIES && (s->file < 0 || states_count(s->file) == 0); k++) {
        states_close(s);
        nanosleep(&nap, NULL);
        states_open(s, &folder->home);
    }
}

/* What results.h5 has: geometry, envelopes, states. */
static hawser_status states_file_add(Text *out, hid_t file, Folder *folder, double share, hawser_error *err)
{
    geometry_add(out, file, folder);
    if (states_count(file) == 0) {
        folder_say(folder, "results.h5 holds no states: the page has no 3-D view");
        return HAWSER_OK;
    }
    const double segments = fmax(0, folder_figure(folder, "segments"));
    return states_add(out, file, folder, fmin(share * states_most, states_least + states_per_segment * segments), err);
}

typedef struct FilePart {
    Folder *folder;
    double share;
} FilePart;

/* The same, of the file if it can be read: the notes that there are then, and the text. */
static hawser_status file_print(void *user, FILE *out, hawser_error *err)
{
    const FilePart *const part = user;
    Folder *const folder = part->folder;
    Text text = {0};
    StatesFile s;
    hawser_status status = HAWSER_OK;
    states_wait(&s, folder);
    if (s.file < 0)
        folder_say(folder, "results.h5 is not there or cannot be read: the page has no 3-D view");
    else
        status = states_file_add(&text, s.file, folder, part->share, err);
    states_close(&s);
    if (text.failed && !status) status = error_memory(err);
    if (!status && fwrite(&folder->n_notes, sizeof folder->n_notes, 1, out) == 1 &&
        fwrite(folder->note, sizeof folder->note, 1, out) == 1 && text.size > 0)
        fwrite(text.at, text.size, 1, out); /* what does not get out is no end either */
    text_clear(&text);
    return status;
}

static hawser_status file_add(Text *out, Folder *folder, double share, hawser_error *err)
{
    const size_t head = sizeof folder->n_notes + sizeof folder->note;
    FilePart part = {folder, share};
    char *bytes;
    size_t size;
    int died, n;
    const hawser_status status = apart_do(file_print, &part, &bytes, &size, &died, err);
    if (!status && (died || size < head)) {
        folder_say(folder, "results.h5 is damaged: HDF5 does not survive to read it: the page has no 3-D view");
    } else if (!status) {
        memcpy(&n, bytes, sizeof n);
        memcpy(folder->note, bytes + sizeof n, sizeof folder->note);
        folder->n_notes = n < 0 || n > FOLDER_NOTES_MAX ? 0 : n;
        for (int k = 0; k < FOLDER_NOTES_MAX; k++) folder->note[k][FOLDER_NOTE_MAX - 1] = 0;
        text_bytes(out, bytes + head, size - head);
    }
    free(bytes);
    return status;
}

/* Theory along the route, whose columns are route.csv's. */
static void theory_add(Text *out, const Sheet *route) { sheet_add(out, "theory_along", route); }

static hawser_status run_add(Text *out, Folder *folder, double share, hawser_error *err)
{
    text_add(out, "{\"label\":");
    text_json(out, folder->dir);
    text_add(out, ",\n\"summary\":");
    text_json_whole(out, folder->summary_text, strlen(folder->summary_text));
    sheet_add(out, "stations", &folder->stations);
    sheet_add(out, "rollers", &folder->rollers);
    hawser_status status = series_add(out, folder, err);
    inputs_add(out, &folder->inputs);
    theory_add(out, &folder->route);
    if (!status) status = file_add(out, folder, share, err);
    notes_add(out, folder);
    text_add(out, "}");
    return status;
}

/* The time at which a page is made, unless pages are wanted that are the same every time (SOURCE_DATE_EPOCH). */
static void generated_add(Text *out)
{
    char text[32];
    struct tm utc;
    const char *const epoch = getenv("SOURCE_DATE_EPOCH");
    const time_t now = epoch ? (time_t)strtoll(epoch, NULL, 10) : time(NULL);
    if (!gmtime_r(&now, &utc) || strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc) == 0) return;
    text_print(out, "\"generated\":\"%s\",", text);
}

hawser_status data_write(size_t n, Folder *folder, Text *out, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    text_print(out, "{\"format\":1,\"hawser\":\"%s\",", hawser_version());
    generated_add(out);
    text_add(out, "\"runs\":[\n");
    for (size_t i = 0; i < n && !status; i++) {
        if (i) text_add(out, ",\n");
        status = run_add(out, &folder[i], 1.0 / (double)n, err);
    }
    text_add(out, "]}\n");
    return status || !out->failed ? status : error_memory(err);
}
