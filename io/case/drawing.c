#include "io/case/drawing.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "survey/read.h"

/* Returns the child of a map, which may be changed. */
static CaseNode *find(CaseNode *map, const char *key)
{
    CaseNode *child = map->first;
    while (child && strcmp(child->key, key) != 0) child = child->next;
    return child;
}

/* Puts the child under the key, in place of an existing one. It is freed if there is no memory. */
static int put(CaseNode *map, const char *key, CaseNode *child)
{
    CaseNode *const old = child && map ? find(map, key) : NULL;
    if (!child || !map) return node_free(child), 0;
    if (old) return node_replace(old, child), 1;
    child->key = strdup(key);
    if (!child->key) return node_free(child), 0;
    node_append(map, child);
    return 1;
}

/* Returns the map or list `key` of a map, made if it is not there; NULL: no memory, or no map. A map in place of a list
 * becomes its only item. */
static CaseNode *tree_child(CaseNode *map, const char *key, NodeKind kind)
{
    CaseNode *const old = map ? find(map, key) : NULL;
    if (!map || (old && old->kind == kind)) return old;
    CaseNode *const child = node_new(kind, old ? old->origin : map->origin, old ? old->line : map->line);
    CaseNode *const item = old && old->kind == NODE_MAP && kind == NODE_LIST ? node_clone(old, old->entry) : NULL;
    if (child && item) node_append(child, item);
    return put(map, key, child) ? child : NULL;
}

/* Puts a printed text under a map's key, with the place of `like`. 0: no memory. */
static int tree_put(CaseNode *map, const CaseNode *like, const char *key, const char *format, ...)
{
    char text[CASE_PATH_MAX];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    CaseNode *const node = node_new(NODE_TEXT, like->origin, like->line);
    if (!node) return 0;
    node->text = strdup(text);
    if (!node->text) return node_free(node), 0;
    return put(map, key, node);
}

/* Puts a length, m, in digits that give the same number when read. 0: no memory. */
static int tree_put_length(CaseNode *map, const CaseNode *like, const char *key, double metres)
{
    return tree_put(map, like, key, "%.17g m", metres);
}

enum { FILE_MAX = 1000, NAME_ROOM = 32 };

const char *const case_fars[] = {"error", "skip", NULL};

enum { FAR_ERROR, FAR_SKIP };

typedef struct DrawingRecord {
    char file[FILE_MAX];
    double unit;
    MarksRule rule;
} DrawingRecord;

static const CaseKey drawing_keys[] = {
    {"file", KEY_TEXT, .otherwise = "none: or `marks`", AT(DrawingRecord, file)},
    {"marks", KEY_LIST, .otherwise = "none", .form = "marks one by one", .section = &case_drawn_mark},
    {"unit", KEY_NUMBER, DIM_LENGTH, .otherwise = "as the file says", ABOVE(0, 1e4), AT(DrawingRecord, unit)},
    MARKS_KEYS(DrawingRecord, rule),
    {"layers", KEY_MAP, .required = 1, .form = "what the marks of each layer are", .section = &case_drawn_layer},
};

SECTION(case_drawing, "drawing", drawing_keys);

typedef struct MarkRecord {
    char name[SURVEY_NAME_MAX], layer[SURVEY_NAME_MAX];
    Vec3 at;
    double station, heading;
} MarkRecord;

static const CaseKey mark_keys[] = {
    {"layer", KEY_TEXT, .required = 1, AT(MarkRecord, layer)},
    {"name", KEY_TEXT, .fallback = "", AT(MarkRecord, name)},
    {"point", KEY_POINT, DIM_LENGTH, .otherwise = "by `station`", FROM(-1e8, 1e8), AT(MarkRecord, at)},
    {"station", KEY_NUMBER, DIM_LENGTH, .otherwise = "by `point`", FROM(-LONG, LONG), AT(MarkRecord, station)},
    {"heading", KEY_NUMBER, DIM_ANGLE, .otherwise = "none", FROM(DEGREES(-360), DEGREES(360)), AT(MarkRecord, heading)},
};

SECTION(case_drawn_mark, "drawing.marks.N", mark_keys);

static const char *const meanings[] = {"winch", "reel", "head", "nothing", NULL};

enum { MARK_WINCH, MARK_REEL, MARK_HEAD, MARK_NOTHING };

static const char *const axes[] = {"route", "symbol", NULL};

enum { AXIS_ROUTE, AXIS_SYMBOL };

typedef struct LayerRecord {
    double length, turn;
    int mark, axis;
} LayerRecord;

static const CaseKey layer_keys[] = {
    {"rollers", KEY_MAP, .otherwise = "something else", .section = &case_roller_row},
    {"conveyor", KEY_MAP, .otherwise = "something else", .section = &case_conveyor},
    {"pit", KEY_MAP, .otherwise = "something else", .section = &case_theory_pit},
    {"mark", KEY_CHOICE, .otherwise = "something else", .choices = meanings, AT(LayerRecord, mark)},
    {"length", KEY_NUMBER, DIM_LENGTH, .fallback = "2 m", ABOVE(0, LONG), AT(LayerRecord, length)},
    {"axis", KEY_CHOICE, .fallback = "route", .choices = axes, AT(LayerRecord, axis)},
    {"turn", KEY_NUMBER, DIM_ANGLE, .fallback = "0 deg", FROM(DEGREES(-360), DEGREES(360)), AT(LayerRecord, turn)},
};

SECTION(case_drawn_layer, "drawing.layers.NAME", layer_keys);

/* Distance past its ends up to which the route is followed to winch and reel, m; smallest distance from the line at
 * which a guide's side is taken from the drawing, m; largest angle of a symbol with the route, as a cosine; and share
 * of the tolerance below which two distances from the route count as equal. */
static const double BEYOND = 50, ASIDE = 0.01, TURNED = 0.7071, EQUALLY = 0.05;

/* The section while it is read. */
typedef struct Drawing {
    CaseReader *r;
    const CaseNode *node, *layers; /* the section, and what the marks of each layer are */
    const MarksRule *rule;
    const char *path; /* path of the file, for messages; NULL: the marks are the case's */
    Survey *survey;
    RouteGrid grid;
} Drawing;

/* A layer, the kind of its marks, and their result. */
typedef struct Layer {
    const CaseNode *node, *what; /* what: the map of the rollers, conveyor or pit; NULL: see record.mark */
    LayerRecord record;
    DrawnDef *drawn;
} Layer;

/* A mark on the route. */
typedef struct Placed {
    const SurveyMark *mark;
    char name[NAME_ROOM];
    Nearest near;
} Placed;

/* Reports "plan.dxf:120: mark 'R7' of layer 'ROLLERS' ..."; marks of the case itself are numbered. */
static hawser_status mark_error(const Drawing *d, const SurveyMark *mark, const char *format, ...)
{
    char where[CASE_PLACE_MAX], path[CASE_PATH_MAX], why[400];
    va_list list;
    va_start(list, format);
    vsnprintf(why, sizeof why, format, list);
    va_end(list);
    case_path(case_node_key(d->layers, mark->layer), NULL, path);
    case_place(d->path ? d->path : d->node->origin, (int)mark->line, where);
    return error_set(d->r->err, HAWSER_ERR_INPUT, "%s: key '%.80s': mark '%.60s' %s", where, path, mark->name, why);
}

/* --------------------------------------------------------------------------------------------------- the marks */

/* Reads the file, relative to the case's folder. */
static hawser_status file_read(const CaseReader *r, const CaseNode *section, const DrawingRecord *in, Survey *out)
{
    const CaseNode *const node = case_node_key(section, "file");
    const SurveyOptions options = {.unit = in->unit, .marks = 1};
    char where[CASE_PLACE_MAX], *path = NULL;
    hawser_error why = {HAWSER_OK, ""};
    hawser_status status = case_file_path(r, section, in->file, &path);
    if (status) return status;
    status = survey_read(path, &options, out, &why);
    if (status)
        error_set(r->err, status, "%s: %.700s", case_place(node->origin, node->line, where), why.message);
    else
        status = file_marks_add(&r->def->files, path, r->err);
    free(path);
    return status;
}

static hawser_status marks_read(const CaseReader *r, const CaseNode *list, Survey *out)
{
    for (const CaseNode *item = list->first; item; item = item->next) {
        MarkRecord in = {.at = V3_ZERO};
        const hawser_status status = case_section_read(r, item, &case_drawn_mark, &in);
        if (status) return status;
        const int placed = case_node_key(item, "point") != NULL;
        if (placed == !isnan(in.station)) {
            return case_key_error(r->err, item, placed ? "station" : "point",
                                  placed ? "beside 'point': give either" : "missing: give 'point' or 'station'");
        }
        SurveyMark *const mark = survey_add_mark(out, in.name, in.layer);
        if (!mark) return error_memory(r->err);
        mark->at = placed ? in.at : v3(NAN, NAN, NAN);
        mark->station = in.station;
        mark->heading = in.heading;
        mark->line = item->line;
    }
    return HAWSER_OK;
}

/* Makes the name: a block's attribute, which the DXF reader puts behind the block's own name; else the mark's own name
 * where it is distinct; else the layer's with a number. */
static void name_make(const Layer *layer, const SurveyMark *mark, int number, char name[NAME_ROOM])
{
    const char *const colon = strstr(mark->name, ": "), *text = colon ? colon + 2 : mark->name;
    const CaseNode *const given = case_node_key(layer->what, "name");
    const int plain = !colon && !isnan(mark->heading); /* all insertions of a block have its name */
    size_t length = strcspn(text, ",");
    while (length >= NAME_ROOM || (length > 0 && ((unsigned char)text[length] & 0xC0) == 0x80)) --length;
    if (!*text || plain)
        snprintf(name, NAME_ROOM, "%.20s%d", given && given->text ? given->text : layer->node->key, number);
    else
        snprintf(name, NAME_ROOM, "%.*s", (int)length, text);
}

/* Returns the place along the route of a station in its file's numbers: these count level lengths, from the file's
 * number at the beginning. They go on past the ends. */
static double along_of(const Drawing *d, double station)
{
    enum { STEPS_LEAST = 200, STEPS_MOST = 20000 };
    static const double STEP = 0.25; /* m */
    const CaseReader *const r = d->r;
    const double length = r->route.length, level = r->stations * (station - r->route_station);
    const int n = (int)fmin(fmax(length / STEP, STEPS_LEAST), STEPS_MOST);
    double done = 0;
    if (r->stations == 0) return station;
    if (level <= 0) return level;
    for (int k = 0; k < n; ++k) {
        const Vec3 t = route_at(&r->route, (k + 0.5) * length / n).tangent;
        const double part = hypot(t.x, t.y) * length / n;
        if (part > 0 && done + part >= level) return (k + (level - done) / part) * length / n;
        done += part;
    }
    return length + level - done;
}

/* Checks that a table's x and y agree with its station; stations may count along the route too, as in hawser's own
 * lists of equipment. */
static hawser_status station_check(const Drawing *d, const Placed *p)
{
    const double along = along_of(d, p->mark->station), s = p->near.s, tolerance = d->rule->tolerance;
    char path[CASE_PATH_MAX];
    if (fmin(fabs(s - along), fabs(s - p->mark->station)) <= tolerance) return HAWSER_OK;
    return mark_error(d, p->mark,
                      "is at %.6g m along the route by x and y, and at %.6g m by its station %.6g m: allowed are %g m "
                      "between them (%s.tolerance)",
                      s, along, p->mark->station, tolerance, case_path(d->node, NULL, path));
}

/* Finds the place of a mark by (PC1), or by its station. *far: too far away, which is no error with `far: skip`. */
static hawser_status mark_place(const Drawing *d, const Layer *layer, Placed *p, int *far)
{
    const SurveyMark *const mark = p->mark;
    const double tolerance = d->rule->tolerance, length = d->r->route.length;
    const int at_end = !layer->what && layer->record.mark != MARK_HEAD;
    char path[CASE_PATH_MAX];
    *far = 0;
    const int placed = !isnan(mark->at.x), of_file = d->path != NULL;
    if (!placed) {
        p->near = (Nearest){.s = of_file ? along_of(d, mark->station) : mark->station, .other = INFINITY};
    } else {
        p->near = route_nearest(&d->grid, v3_sub(mark->at, d->r->def->route_origin), d->rule->heights);
    }
    const Nearest *const near = &p->near;
    const double past = at_end ? 0 : fmax(0, fmax(-near->s, near->s - length));
    const double distance = fmax(near->distance, past - tolerance > 0 ? past : 0);
    if (distance > tolerance) {
        *far = 1;
        if (d->rule->far == FAR_SKIP) return HAWSER_OK;
        return mark_error(d, mark,
                          "is %.4g m from the route, nearest at %.6g m along it: allowed are %g m (%s.tolerance); "
                          "with 'far: skip' it is left out",
                          distance, near->s, tolerance, case_path(d->node, NULL, path));
    }
    if (near->other <= tolerance && near->other - near->distance < EQUALLY * tolerance) {
        return mark_error(d, mark, "is as near to %.6g m along the route as to %.6g m: %s", near->s, near->other_s,
                          d->rule->heights ? "move it" : "give it a height, with 'heights: true'");
    }
    return placed && !isnan(mark->station) ? station_check(d, p) : HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------- into the tree */

/* Writes the heading in which the pull crosses the roller: the symbol's, turned. */
static hawser_status heading_put(const Drawing *d, const Layer *layer, const Placed *p, CaseNode *row)
{
    if (layer->record.axis == AXIS_ROUTE) return HAWSER_OK;
    if (isnan(p->mark->heading)) return mark_error(d, p->mark, "has no symbol that is turned: use 'axis: route'");
    const double heading = p->mark->heading + layer->record.turn;
    const Vec3 t = route_at(&d->r->route, p->near.s).tangent;
    const double flat = hypot(t.x, t.y), along = flat > 0 ? (t.x * cos(heading) + t.y * sin(heading)) / flat : 1;
    if (fabs(along) < TURNED) {
        return mark_error(d, p->mark,
                          "is turned by %.1f deg against the route: its symbol's x-axis is to lie along the cable; "
                          "'turn: 90 deg' turns all of the layer",
                          acos(fmin(1, fabs(along))) * 180 / 3.14159265358979323846);
    }
    const double with = along < 0 ? heading + 3.14159265358979323846 : heading;
    const double reduced = remainder(with, 2 * 3.14159265358979323846);
    return tree_put(row, layer->node, "heading", "%.17g rad", reduced) ? HAWSER_OK : error_memory(d->r->err);
}

/* Writes a row of one roller, as it would be typed in `rollers.along`. */
static hawser_status roller_put(const Drawing *d, const Layer *layer, const Placed *p)
{
    CaseNode *const rollers = tree_child(d->r->own, "rollers", NODE_MAP);
    CaseNode *const along = rollers ? tree_child(rollers, "along", NODE_LIST) : NULL;
    CaseNode *const row = along ? node_clone(layer->what, NULL) : NULL;
    if (!row) return error_memory(d->r->err);
    node_append(along, row);
    const CaseNode *const guide = case_node_key(row, "guide");
    const int sided = guide && guide->text && !strcmp(guide->text, "inside") && fabs(p->near.aside) > ASIDE;
    CaseNode *const at = tree_child(row, "at", NODE_LIST);
    CaseNode *const item = at ? node_new(NODE_TEXT, layer->node->origin, layer->node->line) : NULL;
    char text[40];
    snprintf(text, sizeof text, "%.17g m", p->near.s);
    if (!item) return error_memory(d->r->err);
    node_append(at, item);
    item->text = strdup(text);
    if (!item->text || !tree_put(row, layer->node, "name", "%s", p->name) ||
        (sided && !tree_put(row, guide, "guide", p->near.aside > 0 ? "left" : "right"))) {
        return error_memory(d->r->err);
    }
    return guide ? HAWSER_OK : heading_put(d, layer, p, row);
}

/* Writes a machine with its middle at the mark. */
static hawser_status conveyor_put(const Drawing *d, const Layer *layer, const Placed *p)
{
    CaseNode *const list = tree_child(d->r->own, "conveyors", NODE_LIST);
    CaseNode *const item = list ? node_clone(layer->what, NULL) : NULL;
    const double half = layer->record.length / 2;
    if (!item) return error_memory(d->r->err);
    node_append(list, item);
    const int fine = tree_put_length(item, layer->node, "from", p->near.s - half) &&
                     tree_put_length(item, layer->node, "to", p->near.s + half) &&
                     tree_put(item, layer->node, "name", "%s", p->name);
    return fine ? HAWSER_OK : error_memory(d->r->err);
}

static hawser_status pit_put(const Drawing *d, const Layer *layer, const Placed *p)
{
    CaseNode *const theory = tree_child(d->r->own, "theory", NODE_MAP);
    CaseNode *const list = theory ? tree_child(theory, "pits", NODE_LIST) : NULL;
    CaseNode *const item = list ? node_clone(layer->what, NULL) : NULL;
    if (!item) return error_memory(d->r->err);
    node_append(list, item);
    const int fine =
        tree_put_length(item, layer->node, "at", p->near.s) && tree_put(item, layer->node, "name", "%s", p->name);
    return fine ? HAWSER_OK : error_memory(d->r->err);
}

/* Writes winch and reel, which belong to the route's ends, except a winch that takes the rope in as it comes. */
static hawser_status end_put(const Drawing *d, const Layer *layer, const Placed *p)
{
    SceneDef *const def = d->r->def;
    const double s = p->near.s, length = d->r->route.length, tolerance = d->rule->tolerance;
    const CaseNode *const winch = case_node_key(case_node_key(d->r->root, "drive"), "winch");
    const CaseNode *const take_in = case_node_key(winch, "take_in");
    const CaseNode *const reel = case_node_key(d->r->root, "reel");
    int fine = 1;
    if (layer->record.mark == MARK_HEAD) {
        def->head_at = fmin(fmax(s, 0), length);
    } else if (layer->record.mark == MARK_REEL) {
        if (s > tolerance)
            return mark_error(d, p->mark,
                              "is a reel at %.6g m along the route: it must stand at its start, or before it", s);
        if (reel && s < -1e-9)
            fine = tree_put_length(tree_child(d->r->own, "reel", NODE_MAP), layer->node, "distance", -s);
    } else if (take_in && take_in->text && !strcmp(take_in->text, "true")) {
        CaseNode *const drive = tree_child(d->r->own, "drive", NODE_MAP);
        fine = tree_put_length(tree_child(drive, "winch", NODE_MAP), layer->node, "at", s);
    } else if (s < length - tolerance) {
        return mark_error(
            d, p->mark,
            "is a winch at %.6g m along the route, which ends at %.6g m: it must stand there or behind, or "
            "take the rope in ('drive.winch.take_in')",
            s, length);
    }
    return fine ? HAWSER_OK : error_memory(d->r->err);
}

static hawser_status equipment_put(const Drawing *d, const Layer *layer, const Placed *p)
{
    const char *const kind = layer->what ? layer->what->key : "";
    if (!strcmp(kind, "rollers")) return roller_put(d, layer, p);
    if (!strcmp(kind, "conveyor")) return conveyor_put(d, layer, p);
    if (!strcmp(kind, "pit")) return pit_put(d, layer, p);
    return layer->record.mark == MARK_NOTHING ? HAWSER_OK : end_put(d, layer, p);
}

/* ------------------------------------------------------------------------------------------------------ layers */

static DrawnDef *drawn_add(const Drawing *d, const char *layer, const char *kind)
{
    SceneDef *const def = d->r->def;
    DrawnDef *const all = realloc(def->drawn, ((size_t)def->n_drawn + 1) * sizeof *all);
    if (!all) return NULL;
    def->drawn = all;
    DrawnDef *const drawn = &all[def->n_drawn++];
    *drawn = (DrawnDef){.farthest = NAN};
    snprintf(drawn->layer, sizeof drawn->layer, "%.63s", layer);
    snprintf(drawn->kind, sizeof drawn->kind, "%.63s", kind);
    return drawn;
}

/* Reads the layer's keys, of which exactly one gives the kind of its marks; values that the drawing gives are not
 * allowed there. */
static hawser_status layer_read(const Drawing *d, const CaseNode *node, Layer *layer)
{
    static const char *const kinds[] = {"rollers", "conveyor", "pit", "mark"};
    static const char *const drawn[] = {"at", "from", "to", "count", "spacing", "where", "rule", "heading"};
    *layer = (Layer){.node = node, .record = {.mark = MARK_NOTHING}};
    hawser_status status = case_section_read(d->r, node, &case_drawn_layer, &layer->record);
    const CaseNode *kind = NULL;
    for (int k = 0; k < 4 && !status; ++k) {
        const CaseNode *const given = case_node_key(node, kinds[k]);
        if (given && kind) status = case_key_error(d->r->err, given, NULL, "beside '%s': give one of them", kind->key);
        if (given) kind = given;
    }
    if (!status && !kind)
        status = case_key_error(d->r->err, node, NULL, "gives no kind: expected rollers, conveyor, pit or mark");
    if (status || !strcmp(kind->key, "mark")) return status;
    layer->what = kind;
    for (size_t k = 0; k < sizeof drawn / sizeof *drawn; ++k) {
        const CaseNode *const given = case_node_key(kind, drawn[k]);
        if (given) return case_key_error(d->r->err, given, NULL, "not here: the drawing gives the place");
    }
    return HAWSER_OK;
}

/* Places all marks of one layer; at least one is required. */
static hawser_status layer_place(const Drawing *d, const CaseNode *node)
{
    Layer layer;
    hawser_status status = layer_read(d, node, &layer);
    if (status) return status;
    layer.drawn = drawn_add(d, node->key, layer.what ? layer.what->key : meanings[layer.record.mark]);
    if (!layer.drawn) return error_memory(d->r->err);
    for (int i = 0; i < d->survey->n_marks && !status; ++i) {
        Placed p = {.mark = &d->survey->mark[i]};
        int far = 0;
        if (strcmp(p.mark->layer, node->key) != 0) continue;
        ++layer.drawn->marks;
        if (!layer.what && layer.record.mark == MARK_NOTHING) continue;
        name_make(&layer, p.mark, layer.drawn->marks, p.name);
        status = mark_place(d, &layer, &p, &far);
        if (status || far) continue;
        status = equipment_put(d, &layer, &p);
        ++layer.drawn->placed;
        layer.drawn->farthest = fmax(layer.drawn->farthest, p.near.distance);
    }
    if (status || layer.drawn->marks > 0) return status;
    const char *const some = d->survey->n_marks > 0 ? d->survey->mark[0].layer : NULL;
    return case_key_error(d->r->err, node, NULL, "there is no mark on this layer%s%.60s%s",
                          some ? ": the first is on '" : "", some ? some : "", some ? "'" : "");
}

/* Lists marks on layers that the map does not have, and everything else in the file. */
static hawser_status rest_list(const Drawing *d)
{
    for (int i = 0; i < d->survey->n_marks; ++i) {
        const char *const layer = d->survey->mark[i].layer;
        if (case_node_key(d->layers, layer)) continue;
        int k = 0;
        while (k < d->r->def->n_drawn && strcmp(d->r->def->drawn[k].layer, layer) != 0) ++k;
        if (k == d->r->def->n_drawn && !drawn_add(d, layer, "not in `layers`")) return error_memory(d->r->err);
        ++d->r->def->drawn[k].marks;
    }
    for (int i = 0; i < d->survey->n_ignored; ++i) {
        DrawnDef *const drawn = drawn_add(d, "", d->survey->ignored[i].what);
        if (!drawn) return error_memory(d->r->err);
        drawn->marks = (int)fmin(1e9, (double)d->survey->ignored[i].times);
    }
    return HAWSER_OK;
}

/* Checks the kind of the nodes that marks are added to, since adding would hide their error. */
static hawser_status targets_check(const Drawing *d)
{
    static const struct {
        const char *key, *below;
        int list, map;
    } target[] = {{"rollers", NULL, 0, 1},  {"rollers", "along", 1, 1}, {"conveyors", NULL, 1, 0},
                  {"theory", NULL, 0, 1},   {"theory", "pits", 1, 0},   {"drive", NULL, 0, 1},
                  {"drive", "winch", 0, 1}, {"reel", NULL, 0, 1}};
    for (size_t k = 0; k < sizeof target / sizeof *target; ++k) {
        const CaseNode *node = case_node_key(d->r->root, target[k].key);
        if (target[k].below) node = case_node_key(node, target[k].below);
        if (!node || (node->kind == NODE_LIST && target[k].list) || (node->kind == NODE_MAP && target[k].map)) continue;
        return case_value_error(d->r->err, node, ": expected %s", target[k].list ? "a list" : "a map");
    }
    return HAWSER_OK;
}

/* Places all marks of the drawing's layers. */
static hawser_status all_place(Drawing *d)
{
    hawser_status status = targets_check(d);
    if (!status) status = route_grid_build(&d->r->route, BEYOND, &d->grid, d->r->err);
    for (const CaseNode *layer = d->layers->first; layer && !status; layer = layer->next)
        status = layer_place(d, layer);
    route_grid_clear(&d->grid);
    return status;
}

hawser_status case_marks_place(CaseReader *r, const CaseNode *node, const CaseNode *layers, const char *path,
                               const MarksRule *rule, Survey *marks)
{
    Drawing d = {.r = r, .node = node, .layers = layers, .rule = rule, .path = path, .survey = marks};
    return all_place(&d);
}

hawser_status case_drawing_read(CaseReader *r, const CaseNode *node)
{
    const CaseNode *const marks = case_node_key(node, "marks");
    DrawingRecord in = {.unit = NAN};
    Survey survey = {0};
    Drawing d = {.r = r, .node = node, .layers = case_node_key(node, "layers"), .rule = &in.rule, .survey = &survey};
    if (!node) return HAWSER_OK;
    if (r->def->rod.present) return case_key_error(r->err, node, NULL, "needs a route: not with 'rod'");
    hawser_status status = case_section_read(r, node, &case_drawing, &in);
    if (status) return status;
    if (!*in.file && !marks) return case_key_error(r->err, node, "file", "missing: give it, or 'marks'");
    if (*in.file && marks) return case_key_error(r->err, marks, NULL, "beside 'file': give either");
    if (!marks) d.path = in.file;
    status = marks ? marks_read(r, marks, &survey) : file_read(r, node, &in, &survey);
    if (!status) status = all_place(&d);
    if (!status) status = rest_list(&d);
    survey_clear(&survey);
    return status;
}
