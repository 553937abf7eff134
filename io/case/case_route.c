#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "io/case/case_parts.h"

/* Where the route begins and what it is made of. */
static const CaseKey route_keys[] = {
    {"start", KEY_POINT, DIM_LENGTH, .fallback = "[0, 0, 0]", FROM(-LONG, LONG), AT(SceneDef, route_start)},
    {"heading", KEY_NUMBER, DIM_ANGLE, .fallback = "0 deg", FROM(DEGREES(-360), DEGREES(360)),
     AT(SceneDef, route_heading)},
    {"slope", KEY_NUMBER, DIM_ANGLE, .fallback = "0 deg", FROM(DEGREES(-89), DEGREES(89)), AT(SceneDef, route_slope)},
    {"head_at", KEY_NUMBER, DIM_LENGTH, .otherwise = "the route's end", FROM(0, LONG), AT(SceneDef, head_at)},
    {"pieces", KEY_LIST, .required = 1, .form = "straights and bends, end to end", .section = &case_route_piece},
};
SECTION(case_route, "route", route_keys);

/* Which keys belong to straights and which to bends piece_read says. */
static const CaseKey route_piece_keys[] = {
    {"straight", KEY_NUMBER, DIM_LENGTH, .otherwise = "it is a bend", ABOVE(0, LONG), AT(RoutePieceDef, length)},
    {"bend", KEY_NUMBER, DIM_ANGLE, .otherwise = "it is a straight", ABOVE(0, DEGREES(360)), AT(RoutePieceDef, angle)},
    {"radius", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: bends need it", ABOVE(0, LONG), AT(RoutePieceDef, radius)},
    {"plane", KEY_ANY, DIM_ANGLE, .otherwise = "none: bends need it",
     .form = "`up`, `down`, `left`, `right` or an angle", FROM(DEGREES(-360), DEGREES(360))},
    {"name", KEY_TEXT, .fallback = "", AT(RoutePieceDef, name)},
};
SECTION(case_route_piece, "route.pieces.N", route_piece_keys);

static const char *const weights[] = {"full", "carried", NULL};

/* The section's being there is what makes a lead-in. */
static const CaseKey lead_in_keys[] = {
    {"weight", KEY_CHOICE, .fallback = "carried", .choices = weights, AT(LeadInDef, carries_weight)},
    {"blend", KEY_NUMBER, DIM_LENGTH, .fallback = "500 mm", ABOVE(0, LONG), AT(LeadInDef, blend)},
};
SECTION(case_lead_in, "lead_in", lead_in_keys);

static const double PI = 3.14159265358979323846;

hawser_status case_plane_read(const CaseReader *r, const CaseNode *node, double *plane)
{
    static const char *const words[4] = {"left", "up", "right", "down"};
    const CaseKey *key = case_key_of(&case_route_piece, "plane");
    const int text = node->kind == NODE_TEXT;
    for (int k = 0; text && k < 4; k++) {
        *plane = k * PI / 2;
        if (strcmp(node->text, words[k]) == 0) return HAWSER_OK;
    }
    char why[UNITS_WHY_MAX] = "";
    if (!text || !units_read(r->units, node->text, DIM_ANGLE, plane, why)) {
        return case_value_error(r->err, node, "%s%s: expected up, down, left, right or an angle, such as 30 deg",
                                *why ? " " : "", why);
    }
    return case_range_check(r, node, key, *plane);
}

/* A key that a piece of this kind must have, or must not. */
static hawser_status key_expect(const CaseReader *r, const CaseNode *piece, const char *key, int wanted)
{
    const CaseNode *node = case_node_key(piece, key);
    if (wanted && !node) return case_key_error(r->err, piece, key, "missing: a bend has a radius and a plane");
    if (!wanted && node) return case_key_error(r->err, node, NULL, "not allowed in a straight piece");
    return HAWSER_OK;
}

/* Either straight or a bend, with the keys of its kind and no others. */
static hawser_status piece_read(const CaseReader *r, const CaseNode *node, void *item)
{
    RoutePieceDef *const piece = item;
    hawser_status status = case_section_read(r, node, &case_route_piece, piece);
    if (status) return status;
    const int bend = !isnan(piece->angle);
    if (bend == !isnan(piece->length)) {
        return case_key_error(r->err, node, NULL, "%s: give either 'straight' or 'bend'",
                              bend ? "straight and bent at once" : "neither straight nor bent");
    }
    status = key_expect(r, node, "radius", bend);
    if (!status) status = key_expect(r, node, "plane", bend);
    if (!status && bend) status = case_plane_read(r, case_node_key(node, "plane"), &piece->plane);
    if (status) return status;
    piece->kind = bend ? ROUTE_BEND : ROUTE_STRAIGHT;
    if (bend) piece->length = 0;
    if (!bend) piece->radius = piece->angle = 0;
    if (bend && piece->radius <= case_largest_diameter(r->def) / 2) {
        return case_value_error(r->err, case_node_key(node, "radius"),
                                " is too small: must be above the cable's own radius, %g m",
                                case_largest_diameter(r->def) / 2);
    }
    return HAWSER_OK;
}

/* Where the cable's front is at the start: on the route. */
static hawser_status head_check(const CaseReader *r, const CaseNode *node)
{
    double *const head = &r->def->head_at;
    if (isnan(*head)) *head = r->route.length;
    if (*head <= r->route.length + 1e-6) return HAWSER_OK;
    return case_value_error(r->err, case_node_key(node, "head_at"),
                            " is out of range: must be on the route, at most %.10g m", r->route.length);
}

/* Built here already: rollers and stations are placed along it. */
hawser_status case_route_read(CaseReader *r, const CaseNode *node)
{
    SceneDef *const def = r->def;
    if (def->rod.present) return HAWSER_OK;
    if (!node) return case_key_error(r->err, r->root, "route", "missing: give it, or a 'rod'");
    hawser_status status = case_section_read(r, node, &case_route, def);
    const CaseNode *const list = case_node_key(node, "pieces");
    if (!status && list->count == 0) return case_value_error(r->err, list, " without a piece: the route is empty");
    if (!status) status = case_list_read(r, list, sizeof *def->route, piece_read, &def->route, &def->n_route);
    if (status) return status;
    status = route_build(&r->route, def->n_route, def->route, def->route_start, def->route_heading, def->route_slope,
                         r->err);
    return status ? status : head_check(r, node);
}

/* Its defaults are read even where there is none, so that the definition is complete. */
hawser_status case_lead_in_read(CaseReader *r, const CaseNode *node)
{
    r->def->lead_in.present = node != NULL;
    return case_section_read(r, node, &case_lead_in, &r->def->lead_in);
}
