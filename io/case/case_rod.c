/* A rod: its shape, what must not stand beside it. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "io/case/case_parts.h"
#include "io/yaml/case_error.h"
#include "sim/def/rod_shape.h"

/* Keys that a shape needs (bit of the shape in `needs`), may have or must not have. */
static hawser_status shape_keys_check(const CaseReader *r, const CaseNode *node, int shape)
{
    static const struct {
        const char *key;
        int needs, may; /* bits 1 << RodShape */
    } keys[] = {{"radius", 1 << ROD_ARC | 1 << ROD_HELIX, 0},
                {"plane", 0, 1 << ROD_ARC | 1 << ROD_HELIX},
                {"pitch", 1 << ROD_HELIX, 0},
                {"points", 1 << ROD_POLYLINE, 0},
                {"start", 0, 1 << ROD_STRAIGHT | 1 << ROD_ARC | 1 << ROD_HELIX},
                {"heading", 0, 1 << ROD_STRAIGHT | 1 << ROD_ARC | 1 << ROD_HELIX},
                {"slope", 0, 1 << ROD_STRAIGHT | 1 << ROD_ARC | 1 << ROD_HELIX}};
    const char *const *const names = case_key_of(&case_rod, "shape")->choices;
    for (size_t k = 0; k < sizeof keys / sizeof *keys; k++) {
        const CaseNode *const given = case_node_key(node, keys[k].key);
        if (!given && keys[k].needs >> shape & 1)
            return case_key_error(r->err, node, keys[k].key, "missing: 'shape: %s' needs it", names[shape]);
        if (given && !((keys[k].needs | keys[k].may) >> shape & 1))
            return case_key_error(r->err, given, NULL, "not allowed with 'shape: %s'", names[shape]);
    }
    return HAWSER_OK;
}

/* The corners of a polyline, two at least, no two neighbours in one place; as long as the chain. */
static hawser_status points_read(const CaseReader *r, const CaseNode *list)
{
    RodDef *const rod = &r->def->rod;
    const CaseKey *const key = case_key_of(&case_rod, "start"), *const keys[3] = {key, key, key};
    if (!list) return HAWSER_OK;
    if (list->count < 2) return case_value_error(r->err, list, " of %d points: expected two at least", list->count);
    rod->points = calloc((size_t)list->count, sizeof *rod->points);
    if (!rod->points) return error_memory(r->err);
    rod->n_points = list->count;
    for (const CaseNode *point = list->first; point; point = point->next) {
        double p[3];
        const hawser_status status = case_numbers_read(r, point, 3, keys, p);
        if (status) return status;
        const int i = point->index;
        rod->points[i] = v3(p[0], p[1], p[2]);
        if (i > 0 && !(v3_norm(v3_sub(rod->points[i], rod->points[i - 1])) > 1e-9))
            return case_value_error(r->err, point, ": expected another place than that of the point before it");
    }
    const double length = rod_points_length(rod->n_points, rod->points), chain = case_chain_length(r->def);
    if (fabs(length - chain) <= 0.01 * chain) return HAWSER_OK;
    return case_value_error(r->err, list,
                            ": expected points that are %.6g m long together, within 1 %%, as the chain is, "
                            "not %.6g m",
                            chain, length);
}

/* A segment is a chord: it must not be longer than the radius. */
static hawser_status radius_check(const CaseReader *r, const CaseNode *node)
{
    const SceneDef *const def = r->def;
    const CaseNode *const value = case_node_key(node, "radius");
    double longest = 0;
    for (int p = 0; p < def->n_pieces; ++p) longest = fmax(longest, def->pieces[p].length / def->pieces[p].segments);
    if (!value || def->rod.radius >= longest) return HAWSER_OK;
    return case_value_error(r->err, value, " is out of range: must be the length of a segment at least, %g m", longest);
}

/* The rest of the scene reckons with a route: a straight of the chain's length, on which nothing stands. */
static hawser_status route_stand_in(CaseReader *r, const RodRecord *record)
{
    SceneDef *const def = r->def;
    def->route = calloc(1, sizeof *def->route);
    if (!def->route) return error_memory(r->err);
    def->n_route = 1;
    def->route[0] = (RoutePieceDef){.kind = ROUTE_STRAIGHT, .name = "rod", .length = case_chain_length(def)};
    def->route_start = record->start;
    def->route_heading = record->heading;
    def->route_slope = record->slope;
    def->head_at = def->route[0].length - (def->n_pieces > 1 ? def->pieces[def->n_pieces - 1].length : 0);
    return route_build(&r->route, 1, def->route, record->start, 0, 0, r->err);
}

hawser_status case_rod_read(CaseReader *r, const CaseNode *node)
{
    RodRecord record = {0};
    RodDef *const rod = &r->def->rod;
    hawser_status status = case_section_read(r, node, &case_rod, &record);
    if (!status) status = shape_keys_check(r, node, record.shape);
    if (status) return status;
    rod->present = 1;
    rod->shape = (RodShape)record.shape;
    rod->radius = record.radius;
    rod->pitch = record.pitch;
    rod->stress_free = record.stress_free;
    rod->roll = record.roll;
    if (!isnan(record.roll_end)) rod->roll_rate = (record.roll_end - record.roll) / case_chain_length(r->def);
    if (record.plane) status = case_plane_read(r, record.plane, &rod->plane);
    if (!status) status = radius_check(r, node);
    if (!status) status = points_read(r, record.points);
    if (!status) status = route_stand_in(r, &record);
    if (!status) status = case_rod_ends_read(r, &record);
    return status ? status : case_rod_loads_read(r, &record);
}

/* Cables of the chain that bend along a table. */
static hawser_status bending_check(const CaseReader *r)
{
    for (int p = 0; p < r->def->n_pieces; ++p) {
        const CableDef *const cable = &r->def->cables[r->def->pieces[p].cable];
        if (cable->bending.rows == 0) continue;
        const CaseNode *const given = case_node_key(case_node_key(r->root, "cables"), cable->name);
        return case_key_error(r->err, given, "bending", "not allowed in a 'rod', which bends elastically");
    }
    return HAWSER_OK;
}

hawser_status case_rod_check(const CaseReader *r)
{
    static const char *const paths[][2] = {{"route", NULL},       {"lead_in", NULL},     {"reel", NULL},
                                           {"drive", NULL},       {"conveyors", NULL},   {"paper", NULL},
                                           {"theory", NULL},      {"limits", NULL},      {"rollers", "along"},
                                           {"surfaces", "ducts"}, {"surfaces", "trays"}, {"output", "stations"}};
    for (size_t k = 0; r->def->rod.present && k < sizeof paths / sizeof *paths; k++) {
        const CaseNode *given = case_node_key(r->root, paths[k][0]);
        if (given && paths[k][1]) given = case_node_key(given, paths[k][1]);
        if (given) return case_key_error(r->err, given, NULL, "not allowed beside 'rod', which has no route");
    }
    if (r->def->rod.present) return bending_check(r);
    if (r->def->analysis.kind == ANALYSIS_DYNAMICS) return HAWSER_OK;
    return case_key_error(r->err, case_node_key(case_node_key(r->root, "run"), "analysis"), NULL,
                          "only a 'rod' can be analysed so: expected dynamics");
}
