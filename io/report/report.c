/* The frame of the page, whose program builds all visible parts from the data. Where no program may run, a table shows
 * the verdict and the main figures. The policy forbids every request, and every program but the included one. */
#include "io/report/report.h"

#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <zlib.h>

#include "core/error.h"
#include "io/results/results_h5.h"

enum { TITLE_MOST = 200, WORDS_MOST = 2000 };

/* Writes "'sha256-...'", by which the policy identifies the script. */
static void policy_add(Text *out)
{
    unsigned char sum[32];
    bundle_script_sum(sum);
    text_add(out, "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'sha256-");
    text_base64(out, sum, sizeof sum);
    text_add(out, "'; style-src 'unsafe-inline'; img-src data: blob:; base-uri 'none'; form-action 'none'\">\n");
}

/* Writes the name of a run, separated from the text around it in any writing direction. */
static void title_add(Text *out, const Folder *folder)
{
    text_add(out, "<bdi>");
    text_html(out, folder_title(folder), TITLE_MOST);
    text_add(out, "</bdi>");
}

static void figure_add(Text *out, const Folder *folder, const char *words, const char *path, const char *unit)
{
    const double value = folder_figure(folder, path);
    if (isfinite(value)) text_print(out, "<tr><th>%s</th><td>%.6g %s</td></tr>\n", words, value, unit);
}

static void words_add(Text *out, const char *words, const char *text)
{
    if (!*text) return;
    text_print(out, "<tr><th>%s</th><td><bdi>", words);
    text_html(out, text, WORDS_MOST);
    text_add(out, "</bdi></td></tr>\n");
}

/* Writes the results of one run, for a browser without scripts. */
static void plain_add(Text *out, const Folder *folder)
{
    text_add(out, "<h2>");
    title_add(out, folder);
    text_add(out, "</h2>\n<table>\n");
    words_add(out, "verdict", folder_text(folder, "verdict"));
    words_add(out, "ended", folder_text(folder, "outcome"));
    words_add(out, "because", folder_text(folder, "message"));
    figure_add(out, folder, "pull, mean", "pull_force.steady_mean_N", "N");
    figure_add(out, folder, "pull, peak", "pull_force.peak_N", "N");
    figure_add(out, folder, "reference theory", "theory.reference_total_N", "N");
    figure_add(out, folder, "speed", "speed.steady_m_per_s", "m/s");
    figure_add(out, folder, "simulated", "sim_time_s", "s");
    words_add(out, "case", folder_text(folder, "case"));
    words_add(out, "hawser", folder_text(folder, "version"));
    text_add(out, "</table>\n");
    for (int i = 0; i < folder->n_notes; i++) {
        text_add(out, "<p>");
        text_html(out, folder->note[i], FOLDER_NOTE_MAX);
        text_add(out, "</p>\n");
    }
}

hawser_status page_write(size_t n, const Folder *folder, const Text *data, Text *out, hawser_error *err)
{
    const Bundle script = bundle_script(), style = bundle_style();
    text_add(out, "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n");
    policy_add(out);
    text_add(out, "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n");
    text_print(out, "<meta name=\"generator\" content=\"hawser %s\">\n<title>", hawser_version());
    text_html(out, folder_title(&folder[0]), TITLE_MOST);
    if (n > 1) text_print(out, " and %zu more", n - 1);
    text_add(out, "</title>\n<style>\n");
    text_bytes(out, style.at, style.size);
    text_add(out, "</style>\n</head>\n<body>\n<main id=\"hawser\"></main>\n<noscript>\n"
                  "<p>This page draws its figures with a script, which is switched off here. The main figures:</p>\n");
    for (size_t i = 0; i < n; i++) plain_add(out, &folder[i]);
    text_add(out, "</noscript>\n<script type=\"application/json\" id=\"hawser-data\">");
    if (data->at) text_bytes(out, data->at, data->size);
    text_add(out, "</script>\n<script>");
    text_bytes(out, script.at, script.size); /* its hash is that of the element's text: not a byte more */
    text_add(out, "</script>\n</body>\n</html>\n");
    return out->failed ? error_memory(err) : HAWSER_OK;
}

void pack_quantize(int frames, int items, int components, double step, const float *value, int32_t *q)
{
    const size_t n = (size_t)frames * (size_t)items * (size_t)components;
    for (size_t k = 0; k < n; k++) {
        const double steps = round((double)value[k] / step);
        q[k] = !isfinite(steps) ? 0 : steps > INT32_MAX ? INT32_MAX : steps < -INT32_MAX ? -INT32_MAX : (int32_t)steps;
    }
}

/* Maps small numbers of either sign to small numbers: 0, -1, 1, -2 ... to 0, 1, 2, 3 ... */
static uint32_t zigzag(uint32_t d) { return d << 1 ^ (0U - (d >> 31)); }

void pack_planes(int frames, int items, int components, const int32_t *q, unsigned char *planes)
{
    const size_t row = (size_t)items * (size_t)components, n = (size_t)frames * row, c = (size_t)components;
    for (size_t k = 0; k < n; k++) {
        const size_t in_row = k % row;
        const uint32_t behind = in_row < c ? 0 : (uint32_t)q[k - c];
        const uint32_t before = k < row ? 0 : (uint32_t)q[k - row];
        const uint32_t behind_before = in_row < c || k < row ? 0 : (uint32_t)q[k - row - c];
        const uint32_t z = zigzag(((uint32_t)q[k] - behind) - (before - behind_before));
        for (size_t b = 0; b < 4; b++) planes[b * n + k] = (unsigned char)(z >> (8 * b));
    }
}

enum { LEVEL = 6 }; /* of zlib: 9 takes three times as long for 0.2 % */

hawser_status pack_field(int frames, int items, int components, double step, const float *value, Text *out,
                         hawser_error *err)
{
    const size_t n = (size_t)frames * (size_t)items * (size_t)components;
    uLongf size = compressBound((uLong)(4 * n));
    int32_t *const q = calloc(n + 1, sizeof *q);
    unsigned char *const planes = malloc(4 * n + 1), *const stream = malloc(size);
    int ok = q && planes && stream;
    if (ok) {
        pack_quantize(frames, items, components, step, value, q);
        pack_planes(frames, items, components, q, planes);
        ok = compress2(stream, &size, planes, (uLong)(4 * n), LEVEL) == Z_OK;
    }
    if (ok) text_base64(out, stream, size);
    free(q);
    free(planes);
    free(stream);
    return ok && !out->failed ? HAWSER_OK : error_memory(err);
}

int states_count(hid_t file)
{
    hsize_t times[1], dims[3];
    if (!door_numbers_there(file, "time", 1, times) || !door_numbers_there(file, "position", 3, dims)) return 0;
    const hsize_t n = times[0] < 10000000 ? times[0] : 0;
    return dims[0] < n ? (int)dims[0] : (int)n; /* the time is written last */
}

/* Returns the row of the file that is the i-th frame. */
static hsize_t row_of(const States *s, int i)
{
    return s->frames < 2 ? 0 : (hsize_t)((double)i * (s->there - 1) / (s->frames - 1) + 0.5);
}

/* Reads the chosen rows of a set of `items` x `width` (0: one number an item, without a dimension of its own); NULL if
 * there is no such set, or without memory. */
static float *rows_read(hid_t file, const States *s, const char *name, int items, int width)
{
    hsize_t dims[3] = {0, 0, 0};
    const int rank = width ? 3 : 2;
    const size_t frames = (size_t)s->frames;
    if (!door_numbers_there(file, name, rank, dims)) return NULL;
    if (dims[0] < (hsize_t)s->there || dims[1] != (hsize_t)items || (width && dims[2] != (hsize_t)width)) return NULL;
    hsize_t *const row = malloc((frames + 1) * sizeof *row);
    float *const values = malloc(((size_t)items * (size_t)(width ? width : 1) * frames + 1) * sizeof *values);
    for (int i = 0; row && i < s->frames; i++) row[i] = row_of(s, i);
    const int ok = row && values && rows_fill(file, name, rank, dims, s->frames, row, values);
    free(row);
    if (ok) return values;
    free(values);
    return NULL;
}

/* Reads a set of joints, [n+1]: for each state those ahead of the segments, as in series.csv. */
static float *joints_read(hid_t file, const States *s, const char *name)
{
    float *const t = rows_read(file, s, name, s->segments + 1, 0);
    const size_t n = (size_t)s->segments;
    for (size_t f = 0; t && f < (size_t)s->frames; f++) memmove(t + f * n, t + f * (n + 1) + 1, n * sizeof *t);
    return t;
}

/* Computes the speed along the segment's own axis, the first column of its rotation (w x y z), from the velocity. */
static float *speeds_make(hid_t file, const States *s)
{
    float *const v = rows_read(file, s, "velocity", s->segments, 3), *const q = rows_read(file, s, "quaternion",
                                                                                          s->segments, 4);
    const size_t n = (size_t)s->segments * (size_t)s->frames;
    for (size_t i = 0; v && q && i < n; i++) {
        const float *const r = q + 4 * i, *const u = v + 3 * i;
        const float axis[3] = {1 - 2 * (r[2] * r[2] + r[3] * r[3]), 2 * (r[1] * r[2] + r[0] * r[3]),
                               2 * (r[1] * r[3] - r[0] * r[2])};
        v[i] = axis[0] * u[0] + axis[1] * u[1] + axis[2] * u[2];
    }
    free(q);
    if (q) return v;
    free(v);
    return NULL;
}

/* Reads forces on the rollers with their directions; for older results their sizes alone. */
static void rollers_read(hid_t file, States *s)
{
    Field *const f = &s->field[FIELD_ROLLERS];
    hsize_t dims[3];
    if (!door_numbers_there(file, "roller_load", 2, dims)) return;
    if (dims[1] == 0 || dims[1] > 1000000) return;
    *f = (Field){"roller_force", "N", (int)dims[1], 3, 1, rows_read(file, s, "roller_force", (int)dims[1], 3)};
    if (f->value) return;
    f->components = 1;
    f->value = rows_read(file, s, "roller_load", (int)dims[1], 0);
}

hawser_status states_read(hid_t file, int most, States *s, hawser_error *err)
{
    hsize_t dims[3];
    *s = (States){.there = states_count(file)};
    double *const time = numbers_read(file, "time", 1, dims);
    const int fits = time && door_numbers_there(file, "position", 3, dims) && s->there > 0 && dims[1] > 0 &&
                     dims[1] < 100000000 && dims[2] == 3;
    if (fits) {
        s->segments = (int)dims[1];
        s->frames = s->there < most ? s->there : most;
        s->time = malloc((size_t)s->frames * sizeof *s->time);
        for (int i = 0; s->time && i < s->frames; i++) s->time[i] = time[row_of(s, i)];
    }
    free(time);
    if (!fits) return error_set(err, HAWSER_ERR_INPUT, "results.h5 holds no states");
    if (!s->time) return error_memory(err);
    const int n = s->segments;
    Field *const f = s->field;
    f[FIELD_POSITION] = (Field){"position", "m", n, 3, 1e-3, rows_read(file, s, "position", n, 3)};
    f[FIELD_TENSION] = (Field){"tension", "N", n, 1, 1, joints_read(file, s, "tension")};
    f[FIELD_CURVATURE] = (Field){"curvature", "1/m", n, 1, 1e-4, joints_read(file, s, "curvature")};
    f[FIELD_SIDEWALL] = (Field){"sidewall", "N/m", n, 1, 10, joints_read(file, s, "sidewall")};
    f[FIELD_CONTACT] = (Field){"contact", "N/m", n, 1, 10, rows_read(file, s, "contact_line_load", n, 0)};
    f[FIELD_SPEED] = (Field){"speed", "m/s", n, 1, 1e-3, speeds_make(file, s)};
    rollers_read(file, s);
    return f[FIELD_POSITION].value ? HAWSER_OK
                                   : error_set(err, HAWSER_ERR_INPUT, "results.h5: the positions cannot be read");
}

void states_clear(States *s)
{
    for (int k = 0; k < FIELDS; k++) free(s->field[k].value);
    free(s->time);
    *s = (States){0};
}

/* The sets are those of docs/reference/columns.md, "results.h5"; the keys those of docs/formats.md. A list of things is
 * a struct of arrays in the file and an array of objects on the page. */

/* Significant digits: a millimetre on ten kilometres. */
enum { DIGITS = 8, SURFACES_MOST = 10000 };

static void number_add(Text *out, double value)
{
    if (isfinite(value)) text_print(out, "%.*g", DIGITS, value);
    if (!isfinite(value)) text_add(out, "null");
}

/* Writes "[a,b]" of width numbers; width 0: one number without brackets. */
static void numbers_add(Text *out, const double *values, int width)
{
    if (width) text_add(out, "[");
    for (int k = 0; k < width || k == 0; k++) {
        if (k) text_add(out, ",");
        number_add(out, values[k]);
    }
    if (width) text_add(out, "]");
}

/* A set and its key. width: numbers in an item, 0 a plain one; -1: names. */
typedef struct Item {
    const char *key, *set;
    int width;
} Item;

/* Writes ,"key":[...] of a whole set; null if it is missing. */
static void array_add(Text *out, hid_t parent, const Item *item, int first)
{
    hsize_t dims[2] = {0, 0};
    text_print(out, "%s\"%s\":", first ? "" : ",", item->key);
    if (item->width < 0) {
        size_t size;
        char *const names = names_read(parent, item->set, dims, &size);
        for (hsize_t i = 0; names && i < dims[0]; i++) {
            text_add(out, i ? "," : "[");
            text_json(out, names + i * size);
        }
        text_add(out, !names ? "null" : dims[0] ? "]" : "[]");
        free(names);
        return;
    }
    double *const values = numbers_read(parent, item->set, item->width ? 2 : 1, dims);
    const int fits = values && (!item->width || dims[1] == (hsize_t)item->width);
    if (fits) text_add(out, "[");
    for (hsize_t i = 0; fits && i < dims[0]; i++) {
        if (i) text_add(out, ",");
        numbers_add(out, values + i * (hsize_t)(item->width ? item->width : 1), item->width);
    }
    text_add(out, fits ? "]" : "null");
    free(values);
}

/* Writes "{...}" of parallel sets. */
static void arrays_add(Text *out, hid_t parent, int n, const Item *item)
{
    text_add(out, "{");
    for (int k = 0; k < n; k++) array_add(out, parent, &item[k], k == 0);
    text_add(out, "}");
}

/* Writes "[{...},{...}]": an object for each item of sets of equal length; those that do not fit the first are left
 * out. */
static void objects_add(Text *out, hid_t parent, int n, const Item *item)
{
    enum { ITEMS_MOST = 12 };
    double *values[ITEMS_MOST] = {0};
    char *names[ITEMS_MOST] = {0};
    size_t size[ITEMS_MOST];
    hsize_t count = 0;
    for (int k = 0; k < n; k++) {
        hsize_t dims[2] = {0, 0};
        if (item[k].width < 0) names[k] = names_read(parent, item[k].set, dims, &size[k]);
        if (item[k].width >= 0) values[k] = numbers_read(parent, item[k].set, item[k].width ? 2 : 1, dims);
        if (k == 0) count = names[k] || values[k] ? dims[0] : 0;
        const int fits = dims[0] == count && (item[k].width < 1 || dims[1] == (hsize_t)item[k].width);
        if (fits) continue;
        free(names[k]);
        free(values[k]);
        names[k] = NULL;
        values[k] = NULL;
    }
    text_add(out, "[");
    for (hsize_t i = 0; i < count; i++) {
        text_add(out, i ? ",\n{" : "{");
        for (int k = 0, some = 0; k < n; k++) {
            if (!names[k] && !values[k]) continue;
            text_print(out, "%s\"%s\":", some++ ? "," : "", item[k].key);
            if (names[k]) text_json(out, names[k] + i * size[k]);
            if (values[k])
                numbers_add(out, values[k] + i * (hsize_t)(item[k].width ? item[k].width : 1), item[k].width);
        }
        text_add(out, "}");
    }
    text_add(out, "]");
    for (int k = 0; k < n; k++) {
        free(names[k]);
        free(values[k]);
    }
}

#define LENGTH(array) ((int)(sizeof(array) / sizeof *(array)))

static const Item route_item[] = {{"s_m", "geometry/route/s", 0},
                                  {"position_m", "geometry/route/position", 3},
                                  {"curvature_per_m", "geometry/route/curvature", 0}};

static const Item roller_item[] = {
    {"name", "geometry/rollers/name", -1},     {"kind", "geometry/rollers/kind", -1},
    {"s_m", "geometry/rollers/s", 0},          {"position_m", "geometry/rollers/position", 3},
    {"axis", "geometry/rollers/axis", 3},      {"radius_m", "geometry/rollers/radius", 0},
    {"width_m", "geometry/rollers/width", 0},  {"groove_m", "geometry/rollers/groove", 0},
    {"rating_N", "geometry/rollers/rating", 0}};

static const Item obstacle_item[] = {{"roller", "geometry/obstacles/roller", 0},
                                     {"side", "geometry/obstacles/side", 3},
                                     {"size_m", "geometry/obstacles/size", 3},
                                     {"edge_m", "geometry/obstacles/edge", 0},
                                     {"ring_m", "geometry/obstacles/ring", 0}};

static const Item chain_item[] = {{"length_m", "chain/length", 0},
                                  {"diameter_m", "chain/diameter", 0},
                                  {"part", "chain/part", 0},
                                  {"piece", "chain/piece", 0},
                                  {"piece_names", "chain/piece_name", -1}};

static const Item surface_item[] = {{"points_m", "points", 3}, {"up", "up", 3}};

/* Writes where conveyors take the cable and release it: two points each. */
static void conveyors_add(Text *out, hid_t file)
{
    hsize_t n = 0, from[1] = {0}, to[1] = {0}, points[2] = {0, 0};
    size_t size;
    char *const name = names_read(file, "geometry/conveyors/name", &n, &size);
    double *const begins = numbers_read(file, "geometry/conveyors/from", 1, from),
                  *const ends = numbers_read(file, "geometry/conveyors/to", 1, to),
                  *const at = numbers_read(file, "geometry/conveyors/points", 2, points);
    const int fits = name && begins && ends && at && from[0] == n && to[0] == n && points[0] == n && points[1] == 6;
    text_add(out, "[");
    for (hsize_t i = 0; fits && i < n; i++) {
        text_add(out, i ? ",{\"name\":" : "{\"name\":");
        text_json(out, name + i * size);
        text_add(out, ",\"from_m\":");
        number_add(out, begins[i]);
        text_add(out, ",\"to_m\":");
        number_add(out, ends[i]);
        text_add(out, ",\"points_m\":[");
        numbers_add(out, at + 6 * i, 3);
        text_add(out, ",");
        numbers_add(out, at + 6 * i + 3, 3);
        text_add(out, "]}");
    }
    text_add(out, "]");
    free(name);
    free(begins);
    free(ends);
    free(at);
}

/* Writes a group with a name and numbers as attributes, and its path as sets. */
static void surface_add(Text *out, hid_t group)
{
    static const Item number[] = {{"from_m", "from", 0},   {"to_m", "to", 0},         {"diameter_m", "diameter", 0},
                                  {"width_m", "width", 0}, {"height_m", "height", 0}, {"endless", "endless", 0},
                                  {"normal", "normal", 3}};
    static const char *const word[] = {"name", "kind", "section"};
    text_add(out, "{");
    for (int k = 0; k < LENGTH(word); k++) {
        char text[DOOR_TEXT_MAX];
        door_text(group, word[k], text);
        text_print(out, "%s\"%s\":", k ? "," : "", word[k]);
        text_json(out, text);
    }
    for (int k = 0; k < LENGTH(number); k++) {
        double values[3];
        door_numbers(group, number[k].set, number[k].width ? 3 : 1, values);
        text_print(out, ",\"%s\":", number[k].key);
        numbers_add(out, values, number[k].width);
    }
    for (int k = 0; k < LENGTH(surface_item); k++) array_add(out, group, &surface_item[k], 0);
    text_add(out, "}");
}

static void surfaces_add(Text *out, hid_t file)
{
    char path[64];
    text_add(out, "[");
    for (int i = 0; i < SURFACES_MOST; i++) {
        snprintf(path, sizeof path, "geometry/surfaces/%d", i);
        const hid_t group = door_group(file, path);
        if (group < 0) break;
        if (i) text_add(out, ",\n");
        surface_add(out, group);
        door_close(group);
    }
    text_add(out, "]");
}

/* Writes one thing: a group with attributes alone; null if there is none. */
static void machine_add(Text *out, hid_t file, const char *path, int n, const Item *item)
{
    const hid_t group = door_group(file, path);
    text_add(out, group < 0 ? "null" : "{");
    for (int k = 0; k < n && group >= 0; k++) {
        double values[3];
        door_numbers(group, item[k].set, item[k].width ? 3 : 1, values);
        text_print(out, "%s\"%s\":", k ? "," : "", item[k].key);
        numbers_add(out, values, item[k].width);
    }
    if (group < 0) return;
    text_add(out, "}");
    door_close(group);
}

static const Item reel_item[] = {{"center_m", "centre", 3},
                                 {"axis", "axis", 3},
                                 {"radius_m", "flange_radius", 0},
                                 {"barrel_radius_m", "barrel_radius", 0},
                                 {"width_m", "width", 0}};

static const Item winch_item[] = {{"position_m", "position", 3}, {"direction", "direction", 3}};

static void around_add(Text *out, hid_t file, const Folder *folder)
{
    const json_t *const origin = json_object_get(folder->summary, "origin_m");
    text_add(out, ",\n\"geometry\":{\"origin_m\":[");
    for (size_t k = 0; k < 3; k++) {
        const json_t *const x = json_array_get(origin, k);
        if (k) text_add(out, ",");
        number_add(out, json_is_number(x) ? json_number_value(x) : 0);
    }
    text_add(out, "],\"up\":[0,0,1],\n\"route\":");
    arrays_add(out, file, LENGTH(route_item), route_item);
    text_add(out, ",\n\"rollers\":");
    objects_add(out, file, LENGTH(roller_item), roller_item);
    text_add(out, ",\n\"surfaces\":");
    surfaces_add(out, file);
    text_add(out, ",\n\"conveyors\":");
    conveyors_add(out, file);
    text_add(out, ",\n\"reel\":");
    machine_add(out, file, "geometry/reel", LENGTH(reel_item), reel_item);
    text_add(out, ",\n\"winch\":");
    machine_add(out, file, "geometry/winch", LENGTH(winch_item), winch_item);
    text_add(out, ",\n\"obstacles\":");
    objects_add(out, file, LENGTH(obstacle_item), obstacle_item);
    text_add(out, "}");
}

static void chain_add(Text *out, hid_t file)
{
    hsize_t n[1] = {0};
    double *const length = numbers_read(file, "chain/length", 1, n);
    free(length);
    text_print(out, ",\n\"chain\":{\"segments\":%d,\"part_names\":[\"cable\",\"rope\"]", (int)n[0]);
    for (int k = 0; k < LENGTH(chain_item); k++) array_add(out, file, &chain_item[k], 0);
    text_add(out, "}");
}

#define ENVELOPE(line)                                                                                                 \
    {"s_m", "envelope/" line "/s", 0}, {"time_s", "envelope/" line "/time", 0},                                        \
        {"tension_min_N", "envelope/" line "/tension_min", 0},                                                         \
        {"tension_mean_N", "envelope/" line "/tension_mean", 0},                                                       \
        {"tension_max_N", "envelope/" line "/tension_max", 0},                                                         \
        {"sidewall_mean_N_per_m", "envelope/" line "/sidewall_mean", 0},                                               \
        {"sidewall_max_N_per_m", "envelope/" line "/sidewall_max", 0},                                                 \
        {"curvature_mean_per_m", "envelope/" line "/curvature_mean", 0},                                               \
    {                                                                                                                  \
        "curvature_max_per_m", "envelope/" line "/curvature_max", 0                                                    \
    }

static const Item place_item[] = {ENVELOPE("place")}, arc_item[] = {ENVELOPE("arc")};

/* Checks whether the file has a group. */
static int has(hid_t file, const char *path)
{
    const hid_t group = door_group(file, path);
    if (group >= 0) door_close(group);
    return group >= 0;
}

/* Writes least, mean and largest over time, by place and by arc length; null where there is no such line. */
static void envelope_add(Text *out, hid_t file)
{
    text_add(out, ",\n\"envelope\":{\"place\":");
    if (has(file, "envelope/place"))
        arrays_add(out, file, LENGTH(place_item), place_item);
    else
        text_add(out, "null");
    text_add(out, ",\n\"arc\":");
    if (has(file, "envelope/arc"))
        arrays_add(out, file, LENGTH(arc_item), arc_item);
    else
        text_add(out, "null");
    text_add(out, "}");
}

enum { SEEN_MOST = 1 << 24 };         /* numbers that a float has exactly */
static const double seen_step = 1e-3; /* m: a corner moves by half of it at most */

/* Packs a set of whole numbers or of lengths as a field of one frame: `"key":"..."`. 0: it does not fit. */
static int seen_pack(Text *out, hid_t file, const Item *item, double step, hsize_t *n)
{
    hsize_t dims[2] = {0, 1};
    hawser_error err;
    double *const values = numbers_read(file, item->set, item->width ? 2 : 1, dims);
    const hsize_t width = item->width ? dims[1] : 1, count = dims[0] * width;
    float *const small = values && count < SEEN_MOST ? malloc((count + 1) * sizeof *small) : NULL;
    int ok = small && width == (hsize_t)(item->width ? item->width : 1);
    for (hsize_t i = 0; i < count && ok; i++) small[i] = (float)values[i];
    text_print(out, ",\n\"%s\":\"", item->key);
    ok = ok && !pack_field(1, (int)dims[0], (int)width, step, small, out, &err);
    text_add(out, "\"");
    *n = dims[0];
    free(values);
    free(small);
    return ok;
}

/* Writes the environment as it is shown, or only how large it is. */
static void seen_add(Text *out, hid_t file)
{
    static const Item size[] = {{"given", "given", 0}, {"error_m", "error", 0}};
    static const Item name = {"layers", "environment/layer_name", -1};
    static const Item set[] = {{"points", "environment/points", 3},
                               {"triangles", "environment/triangles", 3},
                               {"layer", "environment/layer", 0}};
    hsize_t n[3] = {0};
    Text packed = {0};
    int ok = 1;
    const hid_t group = door_group(file, "environment");
    if (group < 0) return;
    text_add(out, ",\n\"environment\":{");
    for (int k = 0; k < LENGTH(size); k++) {
        double value;
        door_numbers(group, size[k].set, 1, &value);
        text_print(out, "\"%s\":", size[k].key);
        number_add(out, value);
        text_add(out, ",");
    }
    door_close(group);
    text_print(out, "\"step_m\":%g", seen_step);
    array_add(out, file, &name, 0);
    for (int k = 0; k < LENGTH(set) && ok; k++) ok = seen_pack(&packed, file, &set[k], k ? 1 : seen_step, &n[k]);
    text_print(out, ",\"n_points\":%d,\"n_triangles\":%d", ok ? (int)n[0] : 0, ok ? (int)n[1] : 0);
    if (ok && packed.at) text_bytes(out, packed.at, packed.size);
    text_add(out, "}");
    out->failed |= packed.failed;
    text_clear(&packed);
}

void geometry_add(Text *out, hid_t file, Folder *folder)
{
    if (has(file, "geometry")) around_add(out, file, folder);
    seen_add(out, file);
    if (has(file, "chain")) chain_add(out, file);
    if (has(file, "envelope")) envelope_add(out, file);
    if (!has(file, "geometry"))
        folder_say(
            folder,
            "results.h5 is of an older hawser: without the places of rollers, ducts and machines, the view shows "
            "the cable alone");
}

/* Rows of a series on a page; frames; frames for the estimate of how many fit; tries to open a file that is being
 * written. */
enum { SERIES_MOST = 4000, FRAMES_MOST = 600, FRAMES_TRIED = 24, TRIES = 8 };

/* Bytes of packed states: for one run with a short chain, for each segment more, and for all runs together. */
static const double states_least = 500e3, states_per_segment = 2.2e3, states_most = 7.5e6;

/* Writes a number for JSON, null if it is not finite. */
static void digits_add(Text *out, double value, int digits)
{
    if (isfinite(value)) text_print(out, "%.*g", digits, value);
    if (!isfinite(value)) text_add(out, "null");
}

/* Writes a table under its key; null if the folder has none. */
static void sheet_add(Text *out, const char *key, const Sheet *sheet)
{
    text_print(out, ",\n\"%s\":", key);
    if (sheet->columns) sheet_json(sheet, 0, NULL, out);
    if (!sheet->columns) text_add(out, "null");
}

/* Writes the series, thinned by the pull at the winch. */
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
        out->size -= !out->failed; /* drops the closing brace for one more key */
        text_print(out, ",\"thinned_from\":%d}", series->rows);
    }
    free(row);
    return HAWSER_OK;
}

/* Writes rows of objects. A value and its unit are one text here. */
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

/* Returns the place of the cable's front at a time: the series has a row for every state. NAN: not known. */
static double front_at(const Sheet *series, int time, int front, double t, int *from)
{
    if (front < 0 || time < 0) return NAN;
    while (*from + 1 < series->rows && sheet_number(series, *from, time) < t - 1e-6 * (1 + fabs(t))) ++*from;
    return *from < series->rows ? sheet_number(series, *from, front) : NAN;
}

/* Writes everything except the fields themselves. */
static void states_head(Text *out, const States *s, const Sheet *series)
{
    int from = 0;
    const int time = sheet_column(series, "time_s"), front = sheet_column(series, "head_at_m");
    text_print(out, "\"frames\":%d,\"segments\":%d,\"thinned_from\":%d,\"time_s\":[", s->frames, s->segments, s->there);
    for (int i = 0; i < s->frames; i++) {
        if (i) text_add(out, ",");
        digits_add(out, s->time[i], 9);
    }
    text_add(out, "],\"head_at_m\":[");
    for (int i = 0; i < s->frames; i++) {
        if (i) text_add(out, ",");
        digits_add(out, front_at(series, time, front, s->time[i], &from), 9);
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

/* Packs the fields of the segments, then the forces on the rollers as an object of their own. */
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

/* Packs so many states of the file: `segments` the fields, `rollers` their object. Errors: INPUT, MEMORY. */
static hawser_status states_try(hid_t file, int most, States *s, Text *segments, Text *rollers, hawser_error *err)
{
    text_clear(segments);
    text_clear(rollers);
    const hawser_status status = states_read(file, most, s, err);
    return status ? status : fields_pack(s, segments, rollers, err);
}

/* Adds as many frames as fit into `goal` bytes. A few frames give the estimate: frames that are nearer to each other
 * take less, so that it is on the safe side, and a second one is rare. */
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

/* Opens the file with its states, with several tries: that of a run in progress may be found before its first flush. */
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

/* Writes the content of results.h5: geometry, envelopes, states. */
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

/* Prints the same, if the file can be read: the notes, and the text. */
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
        fwrite(text.at, text.size, 1, out); /* incomplete output has no end mark either */
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

/* Writes theory along the route, with the columns of route.csv. */
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

/* Writes the time at which a page is made, unless reproducible pages are requested (SOURCE_DATE_EPOCH). */
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
