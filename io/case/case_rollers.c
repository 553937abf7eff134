#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "io/case/case_parts.h"
#include "io/yaml/case_error.h"

/* The cable's centre line at rest lies on the route, so a roller's centre is as far away from it as the thickest cable
 * sits on the roller. */
enum { HOLD_NONE, HOLD_SAG, HOLD_RANGES };

/* A row of rollers being laid. */
typedef struct Row {
    const CaseNode *node;
    RollerRowRecord record;
    FrictionLaw friction;
    Groove groove;
    SpinDef spin;
    MountDef mount;
    int hold;
} Row;

/* Room for `more` rollers. */
static hawser_status rollers_reserve(const CaseReader *r, const CaseNode *node, int more)
{
    SceneDef *def = r->def;
    if (more > CASE_ROLLERS_MAX - def->n_rollers) {
        return case_key_error(r->err, node, NULL, "too many rollers: at most %d", CASE_ROLLERS_MAX);
    }
    RollerDef *all = realloc(def->rollers, (size_t)(def->n_rollers + more + 1) * sizeof *all);
    if (!all) return error_memory(r->err);
    def->rollers = all;
    return HAWSER_OK;
}

static hawser_status range_read(const CaseReader *r, const CaseNode *node, double range[2])
{
    return case_stretch_read(r, node, case_key_of(&case_roller_row, "hold_down"), range);
}

/* The ranges are read here for their mistakes, and again where they are used. */
static hawser_status hold_read(const CaseReader *r, Row *row)
{
    const CaseNode *node = row->record.hold_down;
    row->hold = HOLD_NONE;
    if (!node || (node->kind == NODE_TEXT && strcmp(node->text, "none") == 0)) return HAWSER_OK;
    row->hold = HOLD_SAG;
    if (node->kind == NODE_TEXT && strcmp(node->text, "sag") == 0) return HAWSER_OK;
    row->hold = HOLD_RANGES;
    if (node->kind != NODE_LIST) {
        return case_value_error(r->err, node, ": expected none, sag, or a list such as [[4 m, 20 m]]");
    }
    for (const CaseNode *range = node->first; range; range = range->next) {
        double ends[2];
        const hawser_status status = range_read(r, range, ends);
        if (status) return status;
    }
    return HAWSER_OK;
}

/* Whether the row has a roller above the line at s: where the route bends upward, or in the ranges given. */
static int held_down(const CaseReader *r, const Row *row, double s, Vec3 up)
{
    if (row->hold == HOLD_SAG) return v3_dot(route_at(&r->route, s).curvature, up) > 1e-9;
    if (row->hold == HOLD_NONE) return 0;
    for (const CaseNode *range = row->record.hold_down->first; range; range = range->next) {
        double ends[2];
        if (!range_read(r, range, ends) && s >= ends[0] && s <= ends[1]) return 1;
    }
    return 0;
}

/* Which side of the line a roller stands on. */
typedef enum Side { SIDE_BELOW, SIDE_ABOVE, SIDE_LEFT, SIDE_RIGHT } Side;

/* One roller of a row at s, beside the line; there is room for it. Carriers and hold-downs have level axes, guides
 * stand square to that and to the line. */
static hawser_status roller_lay(const CaseReader *r, const Row *row, int number, double s, Side side)
{
    static const char *const suffix[] = {"", " above", " left", " right"};
    SceneDef *def = r->def;
    RollerDef *roller = &def->rollers[def->n_rollers];
    const RoutePoint at = route_at(&r->route, s);
    const Vec3 left = route_left(&r->route, s), up = v3_cross(at.tangent, left);
    const int guide = side == SIDE_LEFT || side == SIDE_RIGHT;
    *roller = (RollerDef){.axis = guide ? up : left,
                          .s = s,
                          .radius = row->record.radius,
                          .width = row->record.width,
                          .profile = (ShapeKind)row->record.profile,
                          .groove = row->groove,
                          .spin = row->spin,
                          .mount = row->mount,
                          .rating = row->record.rating,
                          .hold_down = side == SIDE_ABOVE,
                          .friction = row->friction};
    const Shape shape = roller_def_shape(roller);
    const double away = shape_seat(&shape, case_largest_diameter(def) / 2) + (guide ? row->record.gap : 0);
    const int forward = side == SIDE_ABOVE || side == SIDE_LEFT;
    roller->centre = v3_axpy(at.position, forward ? away : -away, guide ? left : up);
    snprintf(roller->name, sizeof roller->name, "%s%d%s", row->record.name, number, suffix[side]);
    def->n_rollers++;
    return case_overlap_check(r, row->node, roller);
}

/* What stands at s: guides on one side or both, or a carrier and perhaps a hold-down. */
static hawser_status place_fill(const CaseReader *r, const Row *row, int *laid, double s)
{
    hawser_status status = HAWSER_OK;
    if (row->record.guide == GUIDE_NONE) {
        const Vec3 left = route_left(&r->route, s), up = v3_cross(route_at(&r->route, s).tangent, left);
        status = roller_lay(r, row, ++*laid, s, SIDE_BELOW);
        if (!status && held_down(r, row, s, up)) status = roller_lay(r, row, *laid, s, SIDE_ABOVE);
        return status;
    }
    const double sideways = case_sideways(r, s);
    const int both = row->record.guide == GUIDE_BOTH;
    const int to_left = both || sideways > 1e-9, to_right = both || sideways < -1e-9;
    if (to_left || to_right) ++*laid;
    if (to_left) status = roller_lay(r, row, *laid, s, SIDE_LEFT);
    if (to_right && !status) status = roller_lay(r, row, *laid, s, SIDE_RIGHT);
    return status;
}

/* What a row of guides cannot have. */
static hawser_status guide_check(const CaseReader *r, const Row *row)
{
    const RollerRowRecord *d = &row->record;
    if (d->guide != GUIDE_NONE && row->hold != HOLD_NONE) {
        return case_key_error(r->err, row->node, "hold_down", "not for guides: give it to a row without 'guide'");
    }
    if (d->guide == GUIDE_NONE && d->gap > 0) {
        return case_key_error(r->err, case_node_key(row->node, "gap"), NULL, "only for a row with 'guide'");
    }
    return HAWSER_OK;
}

/* Lays one row. `laid` counts the places over all rows, for the rollers' names. */
static hawser_status row_read(const CaseReader *r, const CaseNode *node, int *laid)
{
    Row row = {.node = node};
    double *place = NULL;
    int n = 0;
    hawser_status status = case_section_read(r, node, &case_roller_row, &row.record);
    if (isnan(row.record.to)) row.record.to = r->route.length;
    if (!status) status = case_friction_read(r, row.record.friction, &r->def->friction, &row.friction);
    if (!status) status = hold_read(r, &row);
    if (!status) status = guide_check(r, &row);
    if (!status) {
        status = case_groove_make(r, node, row.record.profile, &row.record.groove, row.record.width, &row.groove);
    }
    if (!status) status = case_spin_read(r, row.record.spin, row.record.radius, &row.spin);
    if (!status) status = case_mount_read(r, row.record.mount, &row.mount);
    if (!status) status = case_places_find(r, node, &row.record, &place, &n);
    if (!status) status = rollers_reserve(r, node, 2 * n);
    for (int i = 0; !status && i < n; i++) status = place_fill(r, &row, laid, place[i]);
    free(place);
    return status;
}

/* One row or several, numbered through. */
static hawser_status rows_read(const CaseReader *r, const CaseNode *along)
{
    int laid = 0;
    if (along->kind != NODE_LIST) return row_read(r, along, &laid);
    hawser_status status = HAWSER_OK;
    for (const CaseNode *row = along->first; !status && row; row = row->next) status = row_read(r, row, &laid);
    return status;
}

/* A roller by coordinates has no place along the route: s is NAN. */
static hawser_status roller_read(const CaseReader *r, const CaseNode *node)
{
    SceneDef *def = r->def;
    RollerRecord record = {0};
    FrictionLaw friction;
    Groove groove;
    SpinDef spin;
    MountDef mount;
    hawser_status status = case_section_read(r, node, &case_roller, &record);
    if (!status) status = case_friction_read(r, record.friction, &def->friction, &friction);
    if (!status) status = case_groove_make(r, node, record.profile, &record.groove, record.width, &groove);
    if (!status) status = case_spin_read(r, record.spin, record.radius, &spin);
    if (!status) status = case_mount_read(r, record.mount, &mount);
    if (!status && v3_norm(record.axis) < 1e-9) {
        status = case_value_error(r->err, case_node_key(node, "axis"), ": expected a direction that is not zero");
    }
    if (status) return status;
    RollerDef *roller = &def->rollers[def->n_rollers];
    *roller = (RollerDef){.centre = record.centre,
                          .axis = v3_unit(record.axis),
                          .radius = record.radius,
                          .width = record.width,
                          .profile = (ShapeKind)record.profile,
                          .groove = groove,
                          .spin = spin,
                          .mount = mount,
                          .rating = record.rating,
                          .s = NAN,
                          .friction = friction};
    strcpy(roller->name, record.name);
    if (!*roller->name) snprintf(roller->name, sizeof roller->name, "L%d", node->index + 1);
    def->n_rollers++;
    return case_overlap_check(r, node, roller);
}

/* Rows first, then the list: that is the order of the result tables. */
hawser_status case_rollers_read(const CaseReader *r, const CaseNode *node)
{
    RollersRecord record = {0};
    hawser_status status = case_section_read(r, node, &case_rollers, &record);
    if (status) return status;
    if (record.along) status = rows_read(r, record.along);
    if (!status && record.list) status = rollers_reserve(r, record.list, record.list->count);
    const CaseNode *item = record.list ? record.list->first : NULL;
    for (; !status && item; item = item->next) status = roller_read(r, item);
    return status;
}
