#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "io/case/case_parts.h"
#include "io/yaml/case_error.h"

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
    char why[UNITS_WHY_MAX];
    if (!text || !units_read(r->units, node->text, DIM_ANGLE, plane, why)) {
        return case_value_error(r->err, node, ": expected up, down, left, right or an angle, such as 30 deg");
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
static hawser_status piece_read(const CaseReader *r, const CaseNode *node, RoutePieceDef *piece)
{
    RoutePieceRecord record = {0};
    hawser_status status = case_section_read(r, node, &case_route_piece, &record);
    if (status) return status;
    const int bend = !isnan(record.bend);
    if (bend == !isnan(record.straight)) {
        return case_key_error(r->err, node, NULL, "%s: give either 'straight' or 'bend'",
                              bend ? "straight and bent at once" : "neither straight nor bent");
    }
    status = key_expect(r, node, "radius", bend);
    if (!status) status = key_expect(r, node, "plane", bend);
    if (!status && bend) status = case_plane_read(r, record.plane, &piece->plane);
    if (status) return status;
    piece->kind = bend ? ROUTE_BEND : ROUTE_STRAIGHT;
    piece->length = bend ? 0 : record.straight;
    piece->radius = bend ? record.radius : 0;
    piece->angle = bend ? record.bend : 0;
    strcpy(piece->name, record.name);
    if (bend && record.radius <= case_largest_diameter(r->def) / 2) {
        return case_value_error(r->err, case_node_key(node, "radius"),
                                " is too small: must be above the cable's own radius, %g m",
                                case_largest_diameter(r->def) / 2);
    }
    return HAWSER_OK;
}

/* An empty list is an empty route. */
static hawser_status pieces_read(const CaseReader *r, const CaseNode *node)
{
    SceneDef *def = r->def;
    if (node->count == 0) return case_value_error(r->err, node, " without a piece: the route is empty");
    def->route = calloc((size_t)node->count, sizeof *def->route);
    if (!def->route) return error_memory(r->err);
    def->n_route = node->count;
    for (const CaseNode *child = node->first; child; child = child->next) {
        const hawser_status status = piece_read(r, child, &def->route[child->index]);
        if (status) return status;
    }
    return HAWSER_OK;
}

/* Where the cable's front is at the start: on the route. */
static hawser_status head_place(const CaseReader *r, const CaseNode *node, double head_at)
{
    const CaseNode *value = case_node_key(node, "head_at");
    r->def->head_at = value ? head_at : r->route.length;
    if (r->def->head_at <= r->route.length + 1e-6) return HAWSER_OK;
    return case_value_error(r->err, value, " is out of range: must be on the route, at most %.10g m", r->route.length);
}

/* Built here already: rollers and stations are placed along it. */
hawser_status case_route_read(CaseReader *r, const CaseNode *node)
{
    SceneDef *def = r->def;
    RouteRecord record = {0};
    hawser_status status = case_section_read(r, node, &case_route, &record);
    if (!status) status = pieces_read(r, record.pieces);
    if (status) return status;
    def->route_start = record.start;
    def->route_heading = record.heading;
    def->route_slope = record.slope;
    status = route_build(&r->route, def->n_route, def->route, record.start, record.heading, record.slope, r->err);
    if (!status) status = head_place(r, node, record.head_at);
    return status;
}

/* Its defaults are read even where there is none, so that the definition is complete. */
hawser_status case_lead_in_read(const CaseReader *r, const CaseNode *node)
{
    LeadInRecord record = {0};
    const hawser_status status = case_section_read(r, node, &case_lead_in, &record);
    r->def->lead_in = (LeadInDef){.present = node != NULL, .carries_weight = record.weight, .blend = record.blend};
    return status;
}
