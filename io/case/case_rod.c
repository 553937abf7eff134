/* A rod: its shape, what must not stand beside it. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "def/rod_def.h"
#include "io/case/case_parts.h"

static const char *const shapes[] = {"straight", "arc", "helix", "polyline", NULL};

/* Which keys belong to which shape shape_keys_check says; roll_end becomes a rate once it is read. */
static const CaseKey rod_keys[] = {
    {"shape", KEY_CHOICE, .fallback = "straight", .choices = shapes, AT(SceneDef, rod.shape)},
    {"start", KEY_POINT, DIM_LENGTH, .fallback = "[0, 0, 0]", FROM(-LONG, LONG), AT(SceneDef, route_start)},
    {"heading", KEY_NUMBER, DIM_ANGLE, .fallback = "0 deg", FROM(DEGREES(-360), DEGREES(360)),
     AT(SceneDef, route_heading)},
    {"slope", KEY_NUMBER, DIM_SLOPE, .fallback = "0 deg", FROM(DEGREES(-90), DEGREES(90)), AT(SceneDef, route_slope)},
    {"radius", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: `arc` and `helix` need it", ABOVE(0, LONG),
     AT(SceneDef, rod.radius)},
    {"plane", KEY_ANY, DIM_ANGLE, .otherwise = "`left`", .form = "`up`, `down`, `left`, `right` or an angle",
     FROM(DEGREES(-360), DEGREES(360))},
    {"pitch", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: `helix` needs it", FROM(-LONG, LONG),
     AT(SceneDef, rod.pitch)},
    {"points", KEY_LIST, .otherwise = "none: `polyline` needs it", .form = "points [x, y, z], from the tail on"},
    {"roll", KEY_NUMBER, DIM_ANGLE, .fallback = "0 deg", FROM(DEGREES(-360), DEGREES(360)), AT(SceneDef, rod.roll)},
    {"roll_end", KEY_NUMBER, DIM_ANGLE, .otherwise = "`roll`", FROM(DEGREES(-36000), DEGREES(36000)),
     AT(SceneDef, rod.roll_rate)},
    {"stress_free", KEY_FLAG, .fallback = "true", AT(SceneDef, rod.stress_free)},
    {"tail", KEY_MAP, .otherwise = "free", .section = &case_rod_tail},
    {"head", KEY_MAP, .otherwise = "free", .section = &case_rod_head},
    {"loads", KEY_LIST, .otherwise = "none", .form = "forces and moments one by one", .section = &case_rod_load},
    {"masses", KEY_LIST, .otherwise = "none", .form = "point masses one by one", .section = &case_rod_mass},
};
SECTION(case_rod, "rod", rod_keys);

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
    for (size_t k = 0; k < sizeof keys / sizeof *keys; k++) {
        const CaseNode *const given = case_node_key(node, keys[k].key);
        if (!given && keys[k].needs >> shape & 1)
            return case_key_error(r->err, node, keys[k].key, "missing: 'shape: %s' needs it", shapes[shape]);
        if (given && !((keys[k].needs | keys[k].may) >> shape & 1))
            return case_key_error(r->err, given, NULL, "not allowed with 'shape: %s'", shapes[shape]);
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
    const double longest = case_longest_segment(def);
    if (!value || def->rod.radius >= longest) return HAWSER_OK;
    return case_value_error(r->err, value, " is out of range: must be the length of a segment at least, %g m", longest);
}

/* The rest of the scene reckons with a route: a straight of the chain's length, on which nothing stands. */
static hawser_status route_stand_in(CaseReader *r)
{
    SceneDef *const def = r->def;
    def->route = calloc(1, sizeof *def->route);
    if (!def->route) return error_memory(r->err);
    def->n_route = 1;
    def->route[0] = (RoutePieceDef){.kind = ROUTE_STRAIGHT, .name = "rod", .length = case_chain_length(def)};
    def->head_at = def->route[0].length - (def->n_pieces > 1 ? def->pieces[def->n_pieces - 1].length : 0);
    return route_build(&r->route, 1, def->route, def->route_start, 0, 0, r->err);
}

hawser_status case_rod_read(CaseReader *r, const CaseNode *node)
{
    RodDef *const rod = &r->def->rod;
    const CaseNode *const plane = case_node_key(node, "plane");
    if (!node) return HAWSER_OK;
    hawser_status status = case_section_read(r, node, &case_rod, r->def);
    if (!status) status = shape_keys_check(r, node, (int)rod->shape);
    if (status) return status;
    rod->present = 1;
    rod->roll_rate = isnan(rod->roll_rate) ? 0 : (rod->roll_rate - rod->roll) / case_chain_length(r->def);
    if (plane) status = case_plane_read(r, plane, &rod->plane);
    if (!status) status = radius_check(r, node);
    if (!status) status = points_read(r, case_node_key(node, "points"));
    if (!status) status = route_stand_in(r);
    if (!status) status = case_rod_ends_read(r, node);
    return status ? status : case_rod_loads_read(r, node);
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

hawser_status case_rod_check(CaseReader *r, const CaseNode *node)
{
    static const char *const paths[][2] = {{"route", NULL},       {"lead_in", NULL},     {"reel", NULL},
                                           {"drive", NULL},       {"conveyors", NULL},   {"paper", NULL},
                                           {"theory", NULL},      {"limits", NULL},      {"rollers", "along"},
                                           {"surfaces", "ducts"}, {"surfaces", "trays"}, {"output", "stations"}};
    for (size_t k = 0; node && k < sizeof paths / sizeof *paths; k++) {
        const CaseNode *given = case_node_key(r->root, paths[k][0]);
        if (given && paths[k][1]) given = case_node_key(given, paths[k][1]);
        if (given) return case_key_error(r->err, given, NULL, "not allowed beside 'rod', which has no route");
    }
    if (node && r->def->analysis.kind == ANALYSIS_POSITIONS)
        return case_key_error(r->err, case_node_key(case_node_key(r->root, "run"), "analysis"), NULL,
                              "a 'rod' has no positions: expected dynamics, static or modes");
    if (node) return bending_check(r);
    if (!case_load_steps(r->def)) return HAWSER_OK;
    return case_key_error(r->err, case_node_key(case_node_key(r->root, "run"), "analysis"), NULL,
                          "only a 'rod' can be analysed so: expected dynamics or positions");
}
