/* The sets are those of docs/results.md, "results.h5"; the keys those of docs/report.md. A list of things is a struct
 * of arrays in the file and an array of objects on the page. */
#include "io/report/report.h"
#include "io/report/states.h"

#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Significant digits: a millimetre on ten kilometres. */
enum { DIGITS = 8, SURFACES_MOST = 10000 };

static void number_add(Text *out, double value)
{
    if (isfinite(value)) text_print(out, "%.*g", DIGITS, value);
    if (!isfinite(value)) text_add(out, "null");
}

/* "[a,b]" of width numbers; width 0: one number without brackets. */
static void numbers_add(Text *out, const double *values, int width)
{
    if (width) text_add(out, "[");
    for (int k = 0; k < width || k == 0; k++) {
        if (k) text_add(out, ",");
        number_add(out, values[k]);
    }
    if (width) text_add(out, "]");
}

/* A set and the key under which it stands. width: numbers an item has, 0 a plain one; -1: names. */
typedef struct Item {
    const char *key, *set;
    int width;
} Item;

/* ,"key":[...] of a whole set; null if it is not there. */
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

/* "{...}" of sets side by side. */
static void arrays_add(Text *out, hid_t parent, int n, const Item *item)
{
    text_add(out, "{");
    for (int k = 0; k < n; k++) array_add(out, parent, &item[k], k == 0);
    text_add(out, "}");
}

/* "[{...},{...}]": an object for each item of sets of equal length; those that do not fit the first are left out. */
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

/* Where conveyors take the cable and give it back: two points each. */
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

/* A group with a name and numbers as attributes, and its way as sets. */
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

/* One thing: a group with attributes alone; null if there is none. */
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

/* Whether the file has a group. */
static int has(hid_t file, const char *path)
{
    const hid_t group = door_group(file, path);
    if (group >= 0) door_close(group);
    return group >= 0;
}

/* Least, mean and largest over time, by place and by arc length; null where there is no such line. */
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

void geometry_add(Text *out, hid_t file, Folder *folder)
{
    if (has(file, "geometry")) around_add(out, file, folder);
    if (has(file, "chain")) chain_add(out, file);
    if (has(file, "envelope")) envelope_add(out, file);
    if (!has(file, "geometry"))
        folder_say(
            folder,
            "results.h5 is of an older hawser: without the places of rollers, ducts and machines, the view shows "
            "the cable alone");
}
