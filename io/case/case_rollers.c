#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "io/case/case_parts.h"
#include "io/place/place.h"

static const char *const profiles[] = {"flat", "v", "u", NULL};
static const char *const guides[] = {"none", "inside", "both", "left", "right", NULL};

/* A row of rollers being laid: what all of them have, and where they stand. */
typedef struct Row {
    RollerDef roller; /* without name and place */
    GrooveRecord groove;
    char name[NAME_MAX_LENGTH / 2];
    RowPlaces places;
    double gap;     /* m, of guides and hold-downs */
    double heading; /* rad, of the pull across its rollers; NAN: the route's */
    int alone;      /* its only roller is called as the row is */
    const CaseNode *node;
    int hold;
} Row;

/* A count of 0 means that the spacing decides. */
static const CaseKey roller_row_keys[] = {
    {"type", KEY_ANY, .otherwise = "none", .form = "a name of the catalogue"},
    {"from", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(-LONG, LONG), AT(Row, places.from)},
    {"to", KEY_NUMBER, DIM_LENGTH, .otherwise = "the route's end", FROM(-LONG, LONG), AT(Row, places.to)},
    {"count", KEY_INTEGER, .fallback = "0", FROM(0, 100000), AT(Row, places.count)},
    {"spacing", KEY_NUMBER, DIM_LENGTH, .otherwise = "from `count`", ABOVE(0, LONG), AT(Row, places.spacing)},
    {"at", KEY_LIST, DIM_LENGTH, .otherwise = "none", .form = "places one by one", FROM(-LONG, LONG)},
    {"rule", KEY_MAP, .otherwise = "none", .section = &case_place_rule},
    {"heading", KEY_NUMBER, DIM_ANGLE, .otherwise = "the route's", FROM(DEGREES(-360), DEGREES(360)), AT(Row, heading)},
    {"radius", KEY_NUMBER, DIM_LENGTH, .fallback = "100 mm", ABOVE(0, 100), AT(Row, roller.radius)},
    {"width", KEY_NUMBER, DIM_LENGTH, .fallback = "400 mm", ABOVE(0, 1e3), AT(Row, roller.width)},
    {"where", KEY_ANY, DIM_LENGTH, .otherwise = "`all`", .form = "`all`, `bends`, `straights` or a list of [from, to]",
     FROM(-LONG, LONG)},
    {"profile", KEY_CHOICE, .fallback = "flat", .choices = profiles, AT(Row, roller.profile)},
    {"groove", KEY_SECTION, .otherwise = "its defaults", .section = &case_groove, AT(Row, groove)},
    {"guide", KEY_CHOICE, .fallback = "none", .choices = guides, AT(Row, places.guide)},
    {"gap", KEY_NUMBER, DIM_LENGTH, .fallback = "0 mm", FROM(0, 1e3), AT(Row, gap)},
    {"rating", KEY_NUMBER, DIM_FORCE, .fallback = "0 N", FROM(0, STRONG), AT(Row, roller.rating)},
    {"hold_down", KEY_ANY, DIM_LENGTH, .otherwise = "`none`", .form = "`none`, `sag` or a list of [from, to]",
     FROM(-LONG, LONG)},
    {"friction", KEY_MAP, .otherwise = "the case's", .section = &case_friction},
    {"spin", KEY_MAP, .otherwise = "does not spin", .section = &case_spin},
    {"mount", KEY_MAP, .otherwise = "fixed", .section = &case_mount},
    {"name", KEY_TEXT, .fallback = "R", AT(Row, name)},
};
SECTION(case_roller_row, "rollers.along", roller_row_keys);

/* By coordinates: nothing is known of the route. */
static const CaseKey roller_keys[] = {
    {"type", KEY_ANY, .otherwise = "none", .form = "a name of the catalogue"},
    {"centre", KEY_POINT, DIM_LENGTH, .required = 1, FROM(-1e8, 1e8), AT(Row, roller.centre)},
    {"axis", KEY_POINT, .required = 1, FROM(-1e6, 1e6), AT(Row, roller.axis)},
    {"radius", KEY_NUMBER, DIM_LENGTH, .fallback = "100 mm", ABOVE(0, 100), AT(Row, roller.radius)},
    {"width", KEY_NUMBER, DIM_LENGTH, .fallback = "400 mm", ABOVE(0, 1e3), AT(Row, roller.width)},
    {"profile", KEY_CHOICE, .fallback = "flat", .choices = profiles, AT(Row, roller.profile)},
    {"groove", KEY_SECTION, .otherwise = "its defaults", .section = &case_groove, AT(Row, groove)},
    {"rating", KEY_NUMBER, DIM_FORCE, .fallback = "0 N", FROM(0, STRONG), AT(Row, roller.rating)},
    {"friction", KEY_MAP, .otherwise = "the case's", .section = &case_friction},
    {"spin", KEY_MAP, .otherwise = "does not spin", .section = &case_spin},
    {"mount", KEY_MAP, .otherwise = "fixed", .section = &case_mount},
    {"name", KEY_TEXT, .fallback = "", AT(Row, roller.name)},
};
static SECTION(single_roller, "rollers.list.N", roller_keys);

/* Rows along the route, and single ones. */
static const CaseKey rollers_keys[] = {
    {"along", KEY_ANY, .otherwise = "none", .form = "a row of rollers, or a list of rows", .section = &case_roller_row},
    {"list", KEY_LIST, .otherwise = "none", .form = "rollers one by one", .section = &single_roller},
};
SECTION(case_rollers, "rollers", rollers_keys);

/* The cable's centre line at rest lies on the route, so a roller's centre is as far away from it as the thickest cable
 * sits on the roller. */
enum { HOLD_NONE, HOLD_SAG, HOLD_RANGES };

/* Room for `more` rollers. */
static hawser_status rollers_reserve(const CaseReader *r, const CaseNode *node, int more)
{
    SceneDef *def = r->def;
    if (more > CASE_ROLLERS_MAX - def->n_rollers) {
        char cost[160];
        case_cost_say(r, case_segments(def), (double)def->n_rollers + more, sizeof cost, cost);
        return case_key_error(r->err, node, NULL, "too many rollers: at most %d; %s", CASE_ROLLERS_MAX, cost);
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
    const CaseNode *node = case_node_key(row->node, "hold_down");
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
    for (const CaseNode *range = case_node_key(row->node, "hold_down")->first; range; range = range->next) {
        double ends[2];
        if (!range_read(r, range, ends) && s >= ends[0] && s <= ends[1]) return 1;
    }
    return 0;
}

/* One roller of a row at s, beside the line; there is room for it. Carriers and hold-downs have level axes, guides
 * stand square to that and to the line. A level axis may be turned (PC2). */
static hawser_status roller_lay(const CaseReader *r, const Row *row, int number, double s, PlaceSide side)
{
    static const char *const suffix[] = {"", " above", " left", " right"};
    SceneDef *def = r->def;
    RollerDef *roller = &def->rollers[def->n_rollers];
    const RoutePoint at = route_at(&r->route, s);
    const int turned = !isnan(row->heading);
    const Vec3 left = turned ? v3(-sin(row->heading), cos(row->heading), 0) : route_left(&r->route, s);
    const Vec3 across = v3_cross(at.tangent, left), up = turned ? v3_unit(across) : across;
    const int guide = side == PLACE_LEFT || side == PLACE_RIGHT;
    *roller = row->roller;
    roller->axis = guide ? up : left;
    roller->s = s;
    roller->hold_down = side == PLACE_ABOVE;
    const Shape shape = roller_def_shape(roller);
    const double gap = guide || side == PLACE_ABOVE ? row->gap : 0;
    const double away = shape_seat(&shape, case_largest_diameter(def) / 2) + gap;
    const int forward = side == PLACE_ABOVE || side == PLACE_LEFT;
    roller->centre = v3_axpy(at.position, forward ? away : -away, guide ? left : up);
    if (row->alone)
        snprintf(roller->name, sizeof roller->name, "%s%s", row->name, guide ? "" : suffix[side]);
    else
        snprintf(roller->name, sizeof roller->name, "%s%d%s", row->name, number, suffix[side]);
    def->n_rollers++;
    return case_overlap_check(r, row->node, roller);
}

/* What stands at s: guides on one side or both, or a carrier and perhaps a hold-down. */
static hawser_status place_fill(const CaseReader *r, const Row *row, int *laid, double s)
{
    hawser_status status = HAWSER_OK;
    if (row->places.guide == GUIDE_NONE) {
        const Vec3 left = route_left(&r->route, s), up = v3_cross(route_at(&r->route, s).tangent, left);
        status = roller_lay(r, row, ++*laid, s, PLACE_BELOW);
        if (!status && held_down(r, row, s, up)) status = roller_lay(r, row, *laid, s, PLACE_ABOVE);
        return status;
    }
    const double sideways = case_sideways(r, s);
    const int guide = row->places.guide, inside = guide == GUIDE_INSIDE;
    const int to_left = inside ? sideways > 1e-9 : guide != GUIDE_RIGHT;
    const int to_right = inside ? sideways < -1e-9 : guide != GUIDE_LEFT;
    const CaseNode *const at = case_node_key(row->node, "at");
    if (at && !to_left && !to_right) {
        return case_key_error(r->err, at, NULL,
                              "at %g m no bend to the side has an inside: give 'guide: left' or 'right'", s);
    }
    if (to_left || to_right) ++*laid;
    if (to_left) status = roller_lay(r, row, *laid, s, PLACE_LEFT);
    if (to_right && !status) status = roller_lay(r, row, *laid, s, PLACE_RIGHT);
    return status;
}

/* What a row of guides cannot have. */
static hawser_status guide_check(const CaseReader *r, const Row *row)
{
    if (row->places.guide != GUIDE_NONE && row->hold != HOLD_NONE) {
        return case_key_error(r->err, row->node, "hold_down", "not for guides: give it to a row without 'guide'");
    }
    if (row->places.guide == GUIDE_NONE && row->hold == HOLD_NONE && row->gap > 0 &&
        !case_node_key(row->node, "rule")) {
        return case_key_error(r->err, case_node_key(row->node, "gap"), NULL,
                              "only with 'guide', 'hold_down' or 'rule'");
    }
    return HAWSER_OK;
}

/* What rollers have in common, in a row or alone: friction, groove, spin, mount. */
static hawser_status roller_complete(const CaseReader *r, Row *row)
{
    RollerDef *const d = &row->roller;
    const CaseNode *const node = row->node;
    hawser_status status = case_groove_make(r, node, (int)d->profile, &row->groove, d->width, &d->groove);
    if (!status) status = case_spin_read(r, case_node_key(node, "spin"), d->radius, &d->spin);
    return status ? status : case_mount_read(r, case_node_key(node, "mount"), &d->mount);
}

static hawser_status roller_friction(const CaseReader *r, Row *row)
{
    FrictionKnown *const known = &row->roller.friction_known;
    *known = case_friction_known(r, case_node_key(row->node, "friction"), &r->def->friction_known);
    if (known->source == FRICTION_UNKNOWN) /* TES-P-104.05: rollers that turn freely */
        *known = (FrictionKnown){FRICTION_TYPICAL, 0.1, 0.2, "cables on rollers", known->rest_assumed, ""};
    return case_friction_read(r, case_node_key(row->node, "friction"), &r->def->friction, &row->roller.friction);
}

/* A row says once where its rollers stand; a heading is for level axes. */
static hawser_status form_check(const CaseReader *r, const CaseNode *node)
{
    static const char *const other[][8] = {
        {"at", "from", "to", "count", "spacing", "where", "rule", NULL},
        {"rule", "count", "spacing", "where", "guide", "hold_down", "heading", NULL}};
    for (int k = 0; k < 2; k++) {
        if (!case_node_key(node, other[k][0])) continue;
        for (int i = 1; other[k][i]; i++) {
            const CaseNode *const given = case_node_key(node, other[k][i]);
            if (given) return case_key_error(r->err, given, NULL, "not beside '%s'", other[k][0]);
        }
    }
    const CaseNode *const heading = case_node_key(node, "heading"), *const guide = case_node_key(node, "guide");
    if (!heading || !guide) return HAWSER_OK;
    return case_key_error(r->err, heading, NULL, "not for guides, whose axes are upright");
}

/* The most rollers that a row may have at a place: guides to both sides, or one above a carrier. */
static int most_at_a_place(const Row *row) { return row->places.guide == GUIDE_BOTH || row->hold != HOLD_NONE ? 2 : 1; }

/* Places one by one. */
static hawser_status row_at(const CaseReader *r, Row *row, const CaseNode *at, int *laid)
{
    row->alone = at->count == 1 && case_node_key(row->node, "name");
    hawser_status status = rollers_reserve(r, row->node, most_at_a_place(row) * at->count);
    for (const CaseNode *item = at->first; !status && item; item = item->next) {
        double s = 0;
        status = case_number_read(r, item, case_key_of(&case_roller_row, "at"), &s);
        if (!status) status = place_fill(r, row, laid, s);
    }
    return status;
}

/* Where the rule wants them, numbered from its first side on. */
static hawser_status row_by_rule(const CaseReader *r, Row *row, const CaseNode *rule, int *laid)
{
    PlacedRoller *placed = NULL;
    const RuleRow part = {row->places.from, row->places.to, row->roller.rating, CASE_ROLLERS_MAX};
    int n = 0;
    if (row->places.to < row->places.from)
        return case_key_error(r->err, row->node, "to", "out of range: must be at least 'from', %g m", row->places.from);
    hawser_status status = case_rule_place(r, rule, &part, &placed, &n);
    if (!status) status = rollers_reserve(r, row->node, n);
    for (int i = 0; !status && i < n; i++) status = roller_lay(r, row, ++*laid, placed[i].s, placed[i].side);
    free(placed);
    return status;
}

/* In a row, or in stretches of the route of one sort. */
static hawser_status row_spaced(const CaseReader *r, const Row *row, int *laid)
{
    double *place = NULL;
    int n = 0;
    hawser_status status = case_places_find(r, row->node, &row->places, &place, &n);
    if (!status) status = rollers_reserve(r, row->node, most_at_a_place(row) * n);
    for (int i = 0; !status && i < n; i++) status = place_fill(r, row, laid, place[i]);
    free(place);
    return status;
}

/* Lays one row. `laid` counts the places over all rows, for the rollers' names. */
static hawser_status row_read(const CaseReader *r, const CaseNode *node, int *laid)
{
    Row row = {.node = node};
    const CaseNode *const at = case_node_key(node, "at"), *const rule = case_node_key(node, "rule");
    hawser_status status = case_section_read(r, node, &case_roller_row, &row);
    if (isnan(row.places.to)) row.places.to = r->route.length;
    if (!status) status = form_check(r, node);
    if (!status) status = roller_friction(r, &row);
    if (!status) status = hold_read(r, &row);
    if (!status) status = guide_check(r, &row);
    if (!status) status = roller_complete(r, &row);
    if (status) return status;
    if (at) return row_at(r, &row, at, laid);
    return rule ? row_by_rule(r, &row, rule, laid) : row_spaced(r, &row, laid);
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
    Row row = {.node = node};
    RollerDef *const d = &row.roller;
    hawser_status status = case_section_read(r, node, &single_roller, &row);
    if (!status) status = roller_friction(r, &row);
    if (!status) status = roller_complete(r, &row);
    if (!status && v3_norm(d->axis) < 1e-9) {
        status = case_value_error(r->err, case_node_key(node, "axis"), ": expected a direction that is not zero");
    }
    if (status) return status;
    d->axis = v3_unit(d->axis);
    d->centre = v3_sub(d->centre, r->def->route_origin);
    d->s = NAN;
    if (!*d->name) snprintf(d->name, sizeof d->name, "L%d", node->index + 1);
    def->rollers[def->n_rollers] = *d;
    return case_overlap_check(r, node, &def->rollers[def->n_rollers++]);
}

/* Rows first, then the list: that is the order of the result tables. */
hawser_status case_rollers_read(CaseReader *r, const CaseNode *node)
{
    const CaseNode *const along = case_node_key(node, "along"), *const list = case_node_key(node, "list");
    hawser_status status = case_section_read(r, node, &case_rollers, r->def);
    if (!status && along) status = rows_read(r, along);
    if (!status && list) status = rollers_reserve(r, list, list->count);
    for (const CaseNode *item = list ? list->first : NULL; !status && item; item = item->next) {
        status = roller_read(r, item);
    }
    return status;
}
