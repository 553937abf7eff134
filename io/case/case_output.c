#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "def/cost.h"
#include "io/case/case_parts.h"
#include "theory/paper.h"

/* Both keys are needed. */
static const CaseKey station_keys[] = {
    {"name", KEY_TEXT, .required = 1, AT(StationDef, name)},
    {"at", KEY_NUMBER, DIM_LENGTH, .required = 1, FROM(0, LONG), AT(StationDef, s)},
};
static SECTION(station, "output.stations.list.N", station_keys);

/* Where stations are wanted. Both at once are allowed. */
static const CaseKey stations_keys[] = {
    {"spacing", KEY_NUMBER, DIM_LENGTH, .otherwise = "those of the list alone", ABOVE(0, LONG), .size = sizeof(double)},
    {"list", KEY_LIST, .otherwise = "none", .form = "stations one by one", .section = &station},
};
static SECTION(stations, "output.stations", stations_keys);

static const CaseKey output_keys[] = {
    {"interval", KEY_NUMBER, DIM_TIME, .fallback = "50 ms", ABOVE(0, LATE), AT(OutputDef, interval)},
    {"states", KEY_NUMBER, DIM_TIME, .fallback = "500 ms", FROM(0, LATE), AT(OutputDef, state_interval)},
    {"stations", KEY_ANY, .otherwise = "every 2 m", .form = "section `output.stations`, or its list alone",
     .section = &stations},
    {"speeds_of", KEY_LIST, .otherwise = "the first segment, the one behind the eye, the last",
     .form = "numbers of segments, from 0 at the tail"},
    {"probes", KEY_LIST, .otherwise = "none", .form = "places one by one", .section = &case_probe},
    {"rollers_of", KEY_LIST, .otherwise = "none", .form = "names of rollers, as in `rollers.csv`"},
};
SECTION(case_output, "output", output_keys);

/* NAN: not given. */
typedef struct TermRecord {
    char name[PAPER_NAME_MAX];
    double slope, length, arc, from, to;
} TermRecord;

/* Which keys belong to slopes and which to arcs term_keys_check says. */
static const CaseKey paper_term_keys[] = {
    {"name", KEY_TEXT, .fallback = "", AT(TermRecord, name)},
    {"slope", KEY_NUMBER, DIM_ANGLE, .otherwise = "it is an arc", FROM(DEGREES(-89), DEGREES(89)),
     AT(TermRecord, slope)},
    {"length", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: slopes need it", ABOVE(0, LONG), AT(TermRecord, length)},
    {"arc", KEY_NUMBER, DIM_LENGTH, .otherwise = "it is a slope", ABOVE(0, LONG), AT(TermRecord, arc)},
    {"from", KEY_NUMBER, DIM_ANGLE, .otherwise = "none: arcs need it", FROM(DEGREES(-89), DEGREES(89)),
     AT(TermRecord, from)},
    {"to", KEY_NUMBER, DIM_ANGLE, .otherwise = "none: arcs need it", FROM(DEGREES(-89), DEGREES(89)),
     AT(TermRecord, to)},
};
static SECTION(paper_term, "paper.terms.N", paper_term_keys);

/* Lengths of cable, m, that the paper adds to the path. */
typedef struct PaperRecord {
    double reel, rope;
} PaperRecord;

static const CaseKey paper_keys[] = {
    {"reel", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, LONG), AT(PaperRecord, reel)},
    {"rope", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, LONG), AT(PaperRecord, rope)},
    {"terms", KEY_LIST, .required = 1, .form = "the path's slopes and arcs, end to end", .section = &paper_term},
};
SECTION(case_paper, "paper", paper_keys);

/* Stations nearer to each other than this are one, m. */
static const double SAME_PLACE = 1e-6, USUAL_SPACING = 2;

/* For qsort: by place along the route. */
static int station_order(const void *a, const void *b)
{
    const double sa = ((const StationDef *)a)->s, sb = ((const StationDef *)b)->s;
    return (sa > sb) - (sa < sb);
}

/* A station must be on the route: beyond its end there is no theory to compare with. */
static hawser_status station_read(const CaseReader *r, const CaseNode *node, StationDef *out)
{
    const hawser_status status = case_section_read(r, node, &station, out);
    if (status || out->s <= r->route.length + SAME_PLACE) return status;
    return case_value_error(r->err, case_node_key(node, "at"),
                            " is out of range: must be on the route, at most %.10g m", r->route.length);
}

/* Adds a station at each multiple of the spacing where none is yet; they are named by their place. */
static void stations_space(SceneDef *def, double length, double spacing)
{
    const int named = def->n_stations;
    for (int i = 0; i * spacing <= length + SAME_PLACE; i++) {
        const double s = i * spacing;
        int taken = 0;
        for (int k = 0; k < named; k++) taken = taken || fabs(def->stations[k].s - s) < SAME_PLACE;
        if (taken) continue;
        StationDef *const next = &def->stations[def->n_stations++];
        next->s = s;
        snprintf(next->name, sizeof next->name, "%.6g m", s);
    }
}

/* Named stations and evenly spaced ones, by rising s. */
static hawser_status stations_fill(const CaseReader *r, const CaseNode *node, const CaseNode *list, double spacing)
{
    SceneDef *def = r->def;
    const double even = isnan(spacing) ? 0 : floor(r->route.length / spacing) + 2;
    if (even > CASE_STATIONS_MAX) {
        return case_key_error(r->err, node, "spacing", "too many stations: at most %d", CASE_STATIONS_MAX);
    }
    def->stations = calloc((size_t)even + (size_t)(list ? list->count : 0) + 1, sizeof *def->stations);
    if (!def->stations) return error_memory(r->err);
    for (const CaseNode *item = list ? list->first : NULL; item; item = item->next) {
        const hawser_status status = station_read(r, item, &def->stations[item->index]);
        if (status) return status;
        def->n_stations++;
    }
    if (!isnan(spacing)) stations_space(def, r->route.length, spacing);
    qsort(def->stations, (size_t)def->n_stations, sizeof *def->stations, station_order);
    return HAWSER_OK;
}

/* Without the key there is a station every 2 m, at most about 1000 of them. */
static hawser_status stations_read(const CaseReader *r, const CaseNode *node)
{
    double spacing = USUAL_SPACING;
    if (r->def->rod.present) return HAWSER_OK; /* nothing lies along a route */
    if (!node) return stations_fill(r, NULL, NULL, fmax(USUAL_SPACING, r->route.length / 1000));
    if (node->kind == NODE_LIST) return stations_fill(r, node, node, NAN);
    const hawser_status status = case_section_read(r, node, &stations, &spacing);
    return status ? status : stations_fill(r, node, case_node_key(node, "list"), spacing);
}

/* Segments whose speeds are wanted; by default the first, the one behind the eye, the last. */
static hawser_status speeds_read(const CaseReader *r, const CaseNode *list)
{
    OutputDef *out = &r->def->output;
    const int n = case_segments(r->def), usual[3] = {0, case_eye(r->def) - 1, n - 1};
    const int count = list ? list->count : 3;
    const CaseKey key = {.name = "speeds_of", .kind = KEY_INTEGER, .max = n - 1};
    out->speed_segments = calloc((size_t)count + 1, sizeof *out->speed_segments);
    if (!out->speed_segments) return error_memory(r->err);
    for (int k = 0; k < count; k++) {
        long segment = usual[list ? 0 : k];
        hawser_status status = HAWSER_OK;
        if (list) status = case_integer_read(r, case_node_item(list, k), &key, &segment);
        if (status) return status;
        const int repeated = out->n_speed_segments > 0 && out->speed_segments[out->n_speed_segments - 1] == segment;
        if (list || !repeated) out->speed_segments[out->n_speed_segments++] = (int)segment;
    }
    return HAWSER_OK;
}

/* The roller of that name; -1: there is none. */
static int roller_named(const SceneDef *def, const char *name)
{
    for (int i = 0; i < def->n_rollers; i++) {
        if (strcmp(def->rollers[i].name, name) == 0) return i;
    }
    return -1;
}

/* Rollers whose loads are wanted over time, by their names; none unless asked for. */
static hawser_status loads_read(const CaseReader *r, const CaseNode *list)
{
    OutputDef *out = &r->def->output;
    if (!list) return HAWSER_OK;
    out->load_rollers = calloc((size_t)list->count + 1, sizeof *out->load_rollers);
    if (!out->load_rollers) return error_memory(r->err);
    for (int k = 0; k < list->count; k++) {
        const CaseNode *const item = case_node_item(list, k);
        if (item->kind != NODE_TEXT) return case_value_error(r->err, item, ": expected the name of a roller");
        if (r->def->n_rollers == 0) return case_value_error(r->err, item, ": the case has no rollers");
        const int i = roller_named(r->def, item->text);
        if (i < 0) {
            return case_value_error(r->err, item, " is not a roller: names run from '%s' to '%s'",
                                    r->def->rollers[0].name, r->def->rollers[r->def->n_rollers - 1].name);
        }
        out->load_rollers[out->n_load_rollers++] = i;
    }
    return HAWSER_OK;
}

/* How often something may be written: the run must end. */
static hawser_status interval_check(const CaseReader *r, const CaseNode *node, const char *key, double interval)
{
    if (interval <= 0 || r->def->duration <= interval * CASE_OUTPUTS_MAX) return HAWSER_OK;
    const CaseNode *given = case_node_key(node, key);
    const double n = r->def->duration / interval;
    const int states = strcmp(key, "states") == 0;
    const CostCounts counts = {
        .segments = case_segments(r->def), .rows = states ? 0 : n, .states = states ? n : 0, .duration = NAN};
    return case_key_error(
        r->err, given ? given : r->root, given ? NULL : "output",
        "%s of %g s is out of range: the run would have more than %d of them, and needs %.2g GB of disk", key, interval,
        CASE_OUTPUTS_MAX, cost_of(&counts).disk / 1e9);
}

/* Needs the run's duration, the route and the chain to check against. In load steps every one is a row. */
hawser_status case_output_read(CaseReader *r, const CaseNode *node)
{
    SceneDef *const def = r->def;
    OutputDef *const out = &def->output;
    hawser_status status = case_section_read(r, node, &case_output, out);
    if (!status) status = interval_check(r, node, "interval", out->interval);
    if (!status) status = interval_check(r, node, "states", out->state_interval);
    if (case_load_steps(def)) {
        out->interval = fmin(out->interval, def->duration / def->analysis.load_steps);
    }
    if (!status) status = stations_read(r, case_node_key(node, "stations"));
    if (!status) status = speeds_read(r, case_node_key(node, "speeds_of"));
    if (!status) status = case_probes_read(r, case_node_key(node, "probes"));
    if (!status) status = loads_read(r, case_node_key(node, "rollers_of"));
    return status;
}

/* The keys of the other kind of term are mistakes; its own are needed. */
static hawser_status term_keys_check(const CaseReader *r, const CaseNode *node, int arc)
{
    static const char *const keys[3] = {"length", "from", "to"};
    for (int k = 0; k < 3; k++) {
        const int wanted = (k > 0) == arc;
        const CaseNode *given = case_node_key(node, keys[k]);
        if (wanted && !given) {
            return case_key_error(r->err, node, keys[k], "missing: %s",
                                  arc ? "an arc has slopes 'from' and 'to'" : "a slope has a length");
        }
        if (!wanted && given) {
            return case_key_error(r->err, given, NULL, "not allowed: %s",
                                  arc ? "an arc has slopes 'from' and 'to'" : "a slope has a length");
        }
    }
    return HAWSER_OK;
}

/* One slope or arc of the paper's path. */
static hawser_status term_read(const CaseReader *r, const CaseNode *node, PaperTermDef *term)
{
    TermRecord record = {0};
    hawser_status status = case_section_read(r, node, &paper_term, &record);
    if (status) return status;
    const int arc = !isnan(record.arc);
    if (arc == !isnan(record.slope)) {
        return case_key_error(r->err, node, NULL, "%s: give either 'slope' or 'arc'",
                              arc ? "slope and arc at once" : "neither slope nor arc");
    }
    status = term_keys_check(r, node, arc);
    if (status) return status;
    *term = (PaperTermDef){.kind = arc ? PAPER_ARC : PAPER_SLOPE,
                           .length = arc ? 0 : record.length,
                           .slope = arc ? record.from : record.slope,
                           .slope_end = arc ? record.to : 0,
                           .radius = arc ? record.arc : 0};
    strcpy(term->name, record.name);
    return HAWSER_OK;
}

/* Reel or rope, as a length of cable; none if the length is 0. */
static void allowance_add(SceneDef *def, PaperTermKind kind, const char *name, double length)
{
    if (length <= 0) return;
    PaperTermDef *term = &def->paper[def->n_paper++];
    *term = (PaperTermDef){.kind = kind, .length = length};
    strcpy(term->name, name);
}

/* The paper's path and the route stand for the same tunnel: their lengths agree within 1 %. */
static hawser_status path_check(const CaseReader *r, const CaseNode *node)
{
    double path = 0;
    for (int k = 0; k < r->def->n_paper; k++) path += paper_term_path(&r->def->paper[k]);
    if (fabs(path - r->route.length) <= 0.01 * r->route.length) return HAWSER_OK;
    return case_key_error(r->err, node, "terms", "lengths add up to %.6g m: must be the route's %.6g m within 1 %%",
                          path, r->route.length);
}

/* Reel first, then the path, then the rope: the order of the paper's eq. 10. */
hawser_status case_paper_read(CaseReader *r, const CaseNode *node)
{
    SceneDef *def = r->def;
    PaperRecord record = {0};
    if (!node) return HAWSER_OK;
    hawser_status status = case_section_read(r, node, &case_paper, &record);
    if (status) return status;
    const CaseNode *const terms = case_node_key(node, "terms");
    def->paper = calloc((size_t)terms->count + 2, sizeof *def->paper);
    if (!def->paper) return error_memory(r->err);
    allowance_add(def, PAPER_REEL, "reel", record.reel);
    for (const CaseNode *item = terms->first; !status && item; item = item->next) {
        status = term_read(r, item, &def->paper[def->n_paper++]);
    }
    allowance_add(def, PAPER_ROPE, "rope", record.rope);
    return status ? status : path_check(r, node);
}
