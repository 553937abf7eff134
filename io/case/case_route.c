#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "core/route.h"
#include "io/case/alignment.h"
#include "io/case/case_parts.h"

/* m: largest coordinates of surveyors, and distance beyond which a line counts from an origin of its own. */
#define FAR 1e8
static const double NEAR = 1e4, ORIGIN_GRID = 1e3;
static const double PI = 3.14159265358979323846;

/* The section without its lists. */
typedef struct RouteRecord {
    Vec3 start;
    double heading, slope, north, head_at, transition, radius, station;
    int spline;
    LineRecord line; /* line of a file */
    int reverse;
    double from, to, tolerance, join, height;
} RouteRecord;

/* The profile as a map. */
typedef struct HeightRecord {
    LineRecord line;
} HeightRecord;

/* Start and pieces of the route; form_check checks which keys belong to which kind. */
static const CaseKey route_keys[] = {
    {"start", KEY_POINT, DIM_LENGTH, .fallback = "[0, 0, 0]", FROM(-FAR, FAR), AT(RouteRecord, start)},
    {"origin", KEY_ANY, DIM_LENGTH, .fallback = "auto", .form = "`auto` or [x, y, z], each a length", FROM(-FAR, FAR)},
    {"heading", KEY_NUMBER, DIM_ANGLE, .fallback = "0 deg", FROM(DEGREES(-360), DEGREES(360)),
     AT(RouteRecord, heading)},
    {"slope", KEY_NUMBER, DIM_SLOPE, .fallback = "0 deg", FROM(DEGREES(-90), DEGREES(90)), AT(RouteRecord, slope)},
    {"north", KEY_NUMBER, DIM_ANGLE, .otherwise = "the file's, if its coordinates have one; else not known",
     FROM(DEGREES(-360), DEGREES(360)), AT(RouteRecord, north)},
    {"head_at", KEY_NUMBER, DIM_LENGTH, .otherwise = "the route's end", FROM(0, LONG), AT(RouteRecord, head_at)},
    {"transition_radius", KEY_NUMBER, DIM_LENGTH,
     .otherwise = "`limits.bend_radius`, else 20 times the largest diameter", ABOVE(0, LONG),
     AT(RouteRecord, transition)},
    {"pieces", KEY_LIST, .otherwise = "none: or `points`, `plan`, `file`",
     .form = "straights, bends and curves, end to end", .section = &case_route_piece},
    {"points", KEY_LIST, DIM_LENGTH, .otherwise = "none",
     .form = "points [x, y, z] or [x, y, z, radius], from the start on", FROM(-FAR, FAR)},
    {"radius", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: corners of `points` need it", ABOVE(0, LONG),
     AT(RouteRecord, radius)},
    {"spline", KEY_FLAG, .fallback = "false", AT(RouteRecord, spline)},
    {"plan", KEY_LIST, .otherwise = "none", .form = "lines, arcs and clothoids, end to end",
     .section = &case_route_plan},
    {"profile", KEY_ANY, .otherwise = "none: level, or the file's",
     .form = "section `route.profile`, or its `corners` alone", .section = &case_route_heights},
    {"station", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(-LONG, LONG), AT(RouteRecord, station)},
    LINE_KEYS(RouteRecord, line, NULL, "none"),
    {"reverse", KEY_FLAG, .fallback = "false", AT(RouteRecord, reverse)},
    {"from", KEY_NUMBER, DIM_LENGTH, .otherwise = "where it begins", FROM(-FAR, FAR), AT(RouteRecord, from)},
    {"to", KEY_NUMBER, DIM_LENGTH, .otherwise = "where it ends", FROM(-FAR, FAR), AT(RouteRecord, to)},
    {"tolerance", KEY_NUMBER, DIM_LENGTH, .fallback = "50 mm", ABOVE(0, 1000), AT(RouteRecord, tolerance)},
    {"join", KEY_NUMBER, DIM_LENGTH, .fallback = "10 mm", ABOVE(0, 10), AT(RouteRecord, join)},
    {"height", KEY_NUMBER, DIM_LENGTH, .otherwise = "0 m", FROM(-LONG, LONG), AT(RouteRecord, height)},
};
SECTION(case_route, "route", route_keys);

static const char *const grades[] = {"keep", "plane", NULL};

/* A piece with the values beside its definition. NAN: not given. */
typedef struct PieceRecord {
    RoutePieceDef def;
    double straight, clothoid, parabola, slope, start_radius, end_radius, end_slope;
} PieceRecord;

/* piece_keys_check checks which keys belong to which kind. */
static const CaseKey route_piece_keys[] = {
    {"straight", KEY_NUMBER, DIM_LENGTH, .otherwise = "another kind", ABOVE(0, LONG), AT(PieceRecord, straight)},
    {"slope", KEY_NUMBER, DIM_SLOPE, .otherwise = "the slope there", FROM(DEGREES(-90), DEGREES(90)),
     AT(PieceRecord, slope)},
    {"bend", KEY_NUMBER, DIM_ANGLE, .otherwise = "another kind", ABOVE(0, DEGREES(360)), AT(PieceRecord, def.angle)},
    {"clothoid", KEY_NUMBER, DIM_LENGTH, .otherwise = "another kind", ABOVE(0, LONG), AT(PieceRecord, clothoid)},
    {"parabola", KEY_NUMBER, DIM_LENGTH, .otherwise = "another kind", ABOVE(0, LONG), AT(PieceRecord, parabola)},
    {"end_slope", KEY_NUMBER, DIM_SLOPE, .otherwise = "none: parabolas need it", FROM(DEGREES(-80), DEGREES(80)),
     AT(PieceRecord, end_slope)},
    {"radius", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: bends need it", ABOVE(0, LONG), AT(PieceRecord, def.radius)},
    {"start_radius", KEY_NUMBER, DIM_LENGTH, .otherwise = "straight there", ABOVE(0, LONG),
     AT(PieceRecord, start_radius)},
    {"end_radius", KEY_NUMBER, DIM_LENGTH, .otherwise = "straight there", ABOVE(0, LONG), AT(PieceRecord, end_radius)},
    {"plane", KEY_ANY, DIM_ANGLE, .otherwise = "none: bends need it",
     .form = "`up`, `down`, `left`, `right` or an angle", FROM(DEGREES(-360), DEGREES(360))},
    {"grade", KEY_CHOICE, .otherwise = "`keep` for `left` and `right`, else `plane`", .choices = grades,
     AT(PieceRecord, def.upright)},
    {"name", KEY_TEXT, .fallback = "", AT(PieceRecord, def.name)},
};
SECTION(case_route_piece, "route.pieces.N", route_piece_keys);

static const char *const turns[] = {"left", "right", NULL};

typedef struct PlanRecord {
    RoutePlanElement element;
    double line, arc, clothoid, radius, start_radius, end_radius;
    int right;
} PlanRecord;

static const CaseKey plan_keys[] = {
    {"line", KEY_NUMBER, DIM_LENGTH, .otherwise = "another kind", ABOVE(0, LONG), AT(PlanRecord, line)},
    {"arc", KEY_NUMBER, DIM_LENGTH, .otherwise = "another kind", ABOVE(0, LONG), AT(PlanRecord, arc)},
    {"clothoid", KEY_NUMBER, DIM_LENGTH, .otherwise = "another kind", ABOVE(0, LONG), AT(PlanRecord, clothoid)},
    {"radius", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: arcs need it", ABOVE(0, LONG), AT(PlanRecord, radius)},
    {"start_radius", KEY_NUMBER, DIM_LENGTH, .otherwise = "straight there", ABOVE(0, LONG),
     AT(PlanRecord, start_radius)},
    {"end_radius", KEY_NUMBER, DIM_LENGTH, .otherwise = "straight there", ABOVE(0, LONG), AT(PlanRecord, end_radius)},
    {"turn", KEY_CHOICE, .fallback = "left", .choices = turns, AT(PlanRecord, right)},
    {"name", KEY_TEXT, .fallback = "", AT(PlanRecord, element.name)},
};
SECTION(case_route_plan, "route.plan.N", plan_keys);

static const CaseKey profile_keys[] = {
    {"station", KEY_NUMBER, DIM_LENGTH, .required = 1, FROM(-LONG, LONG), AT(RouteProfileCorner, station)},
    {"height", KEY_NUMBER, DIM_LENGTH, .required = 1, FROM(-LONG, LONG), AT(RouteProfileCorner, height)},
    {"radius", KEY_NUMBER, DIM_LENGTH, .otherwise = "the transition radius", ABOVE(0, LONG),
     AT(RouteProfileCorner, radius)},
    {"parabola", KEY_NUMBER, DIM_LENGTH, .otherwise = "an arc", ABOVE(0, LONG), AT(RouteProfileCorner, parabola)},
};
SECTION(case_route_profile, "route.profile.corners.N", profile_keys);

static const CaseKey heights_keys[] = {
    {"corners", KEY_LIST, .otherwise = "none", .form = "corners of a `plan`'s profile, by rising station",
     .section = &case_route_profile},
    LINE_KEYS(HeightRecord, line, NULL, "none: `corners`"),
};
SECTION(case_route_heights, "route.profile", heights_keys);

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

/* ---------------------------------------------------------------------------------------------------- pieces */

/* Rejects keys of a piece's map other than `allowed` (NULL behind the last). */
static hawser_status keys_only(const CaseReader *r, const CaseNode *node, const char *kind, const char *const *allowed)
{
    for (const CaseNode *key = node->first; key; key = key->next) {
        int known = strcmp(key->key, "name") == 0 || strcmp(key->key, kind) == 0;
        for (const char *const *word = allowed; *word; ++word) known = known || strcmp(key->key, *word) == 0;
        if (!known) return case_key_error(r->err, key, NULL, "not allowed in a '%s' piece", kind);
    }
    return HAWSER_OK;
}

static hawser_status key_needed(const CaseReader *r, const CaseNode *node, const char *key, const char *kind)
{
    if (case_node_key(node, key)) return HAWSER_OK;
    return case_key_error(r->err, node, key, "missing: a '%s' piece needs it", kind);
}

/* Returns the one of these kinds that a map has; -1 after an error. */
static int kind_of(const CaseReader *r, const CaseNode *node, const char *const *kinds, const char *list)
{
    int found = -1, n = 0;
    for (int k = 0; kinds[k]; ++k) {
        if (!case_node_key(node, kinds[k])) continue;
        found = k;
        ++n;
    }
    if (n != 1) case_key_error(r->err, node, NULL, "%s: give one of %s", n ? "two kinds at once" : "no kind", list);
    return n == 1 ? found : -1;
}

/* Checks that a radius is larger than the cable's. NAN passes: it is not given. */
static hawser_status radius_check(const CaseReader *r, const CaseNode *node, const char *key, double radius)
{
    const double least = case_largest_diameter(r->def) / 2;
    if (!(radius <= least)) return HAWSER_OK;
    return case_value_error(r->err, case_node_key(node, key),
                            " is too small: must be above the cable's own radius, %g m", least);
}

/* Reads the curvatures at a clothoid's ends, of which one may be straight. */
static hawser_status ends_read(const CaseReader *r, const CaseNode *node, double start, double end, double out[2])
{
    if (isnan(start) && isnan(end))
        return case_key_error(r->err, node, "end_radius", "missing: a clothoid has a radius at one end at least");
    const hawser_status status = radius_check(r, node, "start_radius", start);
    out[0] = isnan(start) ? 0 : 1 / start;
    out[1] = isnan(end) ? 0 : 1 / end;
    return status ? status : radius_check(r, node, "end_radius", end);
}

/* Makes a bend: an arc, or by the radii of its ends a clothoid of that angle; in its plane, or at a constant grade. */
static hawser_status bend_make(const CaseReader *r, const CaseNode *node, PieceRecord *in)
{
    RoutePieceDef *const p = &in->def;
    const char *const kind = isnan(in->clothoid) ? "bend" : "clothoid";
    const int arc = isnan(in->clothoid) && isnan(in->start_radius) && isnan(in->end_radius);
    static const char *const of_arc[] = {"radius", "plane", "grade", NULL};
    static const char *const of_clothoid[] = {"start_radius", "end_radius", "plane", "grade", NULL};
    const CaseNode *const plane = case_node_key(node, "plane"), *const grade = case_node_key(node, "grade");
    hawser_status status = keys_only(r, node, kind, arc ? of_arc : of_clothoid);
    if (!status && arc) status = key_needed(r, node, "radius", kind);
    if (!status) status = key_needed(r, node, "plane", kind);
    if (!status) status = case_plane_read(r, plane, &p->plane);
    if (!status && arc) status = radius_check(r, node, "radius", p->radius);
    if (!status && !arc) status = ends_read(r, node, in->start_radius, in->end_radius, p->curvature);
    if (status) return status;
    const int left = strcmp(plane->text, "left") == 0, right = strcmp(plane->text, "right") == 0;
    p->upright = grade ? p->upright == 0 : left || right;
    if (p->upright && !left && !right)
        return case_key_error(r->err, grade, NULL, "only bends to the left or right keep a grade");
    p->kind = arc && !p->upright ? ROUTE_BEND : ROUTE_CURVE;
    if (arc) {
        p->curvature[0] = p->curvature[1] = 1 / p->radius;
        p->length = p->radius * p->angle;
    } else {
        p->length = isnan(in->clothoid) ? 2 * p->angle / (p->curvature[0] + p->curvature[1]) : in->clothoid;
    }
    if (p->upright && right) {
        p->curvature[0] = -p->curvature[0];
        p->curvature[1] = -p->curvature[1];
    }
    return HAWSER_OK;
}

static hawser_status piece_read(const CaseReader *r, const CaseNode *node, void *item)
{
    static const char *const kinds[] = {"straight", "bend", "clothoid", "parabola", NULL};
    static const char *const of_straight[] = {"slope", NULL}, *const of_parabola[] = {"end_slope", NULL};
    PieceRecord in = {.def = {.kind = ROUTE_STRAIGHT}};
    const hawser_status status = case_section_read(r, node, &case_route_piece, &in);
    RoutePieceDef *const p = item;
    if (status) return status;
    const int kind = kind_of(r, node, kinds, "straight, bend, clothoid and parabola");
    if (kind < 0) return HAWSER_ERR_INPUT;
    if (kind == 1 || kind == 2) {
        const hawser_status bent = bend_make(r, node, &in);
        *p = in.def;
        return bent;
    }
    memcpy(p->name, in.def.name, sizeof p->name);
    if (kind == 0) {
        p->length = in.straight;
        p->sloped = !isnan(in.slope);
        p->slope = p->sloped ? in.slope : 0;
        return keys_only(r, node, kinds[kind], of_straight);
    }
    p->kind = ROUTE_CURVE;
    p->upright = 1;
    p->length = in.parabola;
    p->profile = PROFILE_PARABOLA;
    p->slope_end = in.end_slope;
    const hawser_status known = keys_only(r, node, kinds[kind], of_parabola);
    return known ? known : key_needed(r, node, "end_slope", kinds[kind]);
}

/* Computes slope and heading at the end of a piece from those at its start. */
static hawser_status piece_pass(const RoutePieceDef *p, double *heading, double *slope, hawser_error *err)
{
    Route one;
    const hawser_status status = route_build(&one, 1, p, V3_ZERO, *heading, *slope, err);
    if (status) return status;
    const Vec3 left = route_left(&one, one.length);
    *slope = route_slope(&one, one.length);
    *heading = atan2(-left.x, left.y);
    route_clear(&one);
    return HAWSER_OK;
}

/* Simplifies bends that keep their grade: on the level they are arcs in a plane, and where the route is upright no
 * other bend is possible. */
static hawser_status grades_settle(const CaseReader *r, const CaseNode *list, int n, RoutePieceDef *def,
                                   const RouteRecord *in)
{
    const double level = 1e-12, upright = DEGREES(89);
    double heading = in->heading, slope = in->slope;
    const CaseNode *node = list->first;
    for (int i = 0; i < n; ++i, node = node->next) {
        RoutePieceDef *const p = &def[i];
        const int arc = p->kind == ROUTE_CURVE && p->angle > 0 && p->radius > 0;
        const int steep = fabs(slope) > upright;
        if (steep && p->kind == ROUTE_CURVE && p->profile == PROFILE_PARABOLA)
            return case_key_error(r->err, node, "parabola", "the route is upright there: a parabola cannot begin");
        if (arc && p->upright && (fabs(slope) < level || steep)) {
            p->kind = ROUTE_BEND;
            p->upright = 0;
        } else if (p->kind == ROUTE_CURVE && p->upright && steep) {
            p->upright = 0;
            p->curvature[0] = fabs(p->curvature[0]);
            p->curvature[1] = fabs(p->curvature[1]);
        }
        if (p->sloped) slope = p->slope;
        const hawser_status status = piece_pass(p, &heading, &slope, r->err);
        if (status) return status;
    }
    return HAWSER_OK;
}

/* Makes the line of the pieces, with rounded changes of slope. */
static hawser_status pieces_line(const CaseReader *r, const CaseNode *list, const RouteRecord *in, RouteLine *out)
{
    RoutePieceDef *def = NULL;
    int n = 0, sloped = 0;
    hawser_status status = case_list_read(r, list, sizeof *def, piece_read, &def, &n);
    if (!status) status = grades_settle(r, list, n, def, in);
    for (int i = 0; i < n; ++i) sloped |= def[i].sloped, def[i].listed = i + 1;
    if (!status && sloped) {
        hawser_error why = {.message = ""};
        status = route_round_slopes(n, def, in->heading, in->slope, in->transition, out, &why);
        if (status) status = case_key_cause(r->err, list, NULL, "", &why);
        free(def);
        return status;
    }
    *out = (RouteLine){.heading = in->heading, .slope = in->slope, .n = n, .piece = def};
    return status;
}

/* --------------------------------------------------------------------------------- points; plan and profile */

static hawser_status point_read(const CaseReader *r, const CaseNode *node, void *item)
{
    const CaseKey *const at = case_key_of(&case_route, "points"), *const round = case_key_of(&case_route, "radius");
    const CaseKey *const keys[4] = {at, at, at, round};
    const int n = node->kind == NODE_LIST && node->count == 4 ? 4 : 3;
    double value[4] = {0, 0, 0, NAN};
    const hawser_status status = case_numbers_read(r, node, n, keys, value);
    *(RouteCorner *)item = (RouteCorner){v3(value[0], value[1], value[2]), value[3]};
    return status;
}

/* Makes the line of points that count from `from`. */
static hawser_status points_line(const CaseReader *r, const CaseNode *list, const RouteRecord *in, Vec3 from, int n,
                                 RouteCorner *corner, RouteLine *out)
{
    hawser_error why = {.message = ""};
    Vec3 *const point = malloc((size_t)n * sizeof *point);
    if (!point) return error_memory(r->err);
    hawser_status status = HAWSER_OK;
    for (int i = 0; i < n && !status; ++i) {
        corner[i].point = point[i] = v3_sub(corner[i].point, from);
        if (isnan(corner[i].radius)) corner[i].radius = in->radius;
        if (isnan(corner[i].radius) && !in->spline && i > 0 && i + 1 < n)
            status = case_key_error(r->err, list->parent, "radius", "missing: corners of 'points' are rounded by it");
    }
    if (!status) {
        status = in->spline ? route_from_spline(n, point, out, &why) : route_from_corners(n, corner, out, &why);
        if (status) status = case_key_cause(r->err, list, NULL, "", &why);
    }
    free(point);
    return status;
}

static hawser_status plan_read(const CaseReader *r, const CaseNode *node, void *item)
{
    static const char *const kinds[] = {"line", "arc", "clothoid", NULL};
    static const char *const of_line[] = {NULL}, *const of_arc[] = {"radius", "turn", NULL};
    static const char *const of_clothoid[] = {"start_radius", "end_radius", "turn", NULL};
    static const char *const *const allowed[] = {of_line, of_arc, of_clothoid};
    PlanRecord in = {.right = 0};
    hawser_status status = case_section_read(r, node, &case_route_plan, &in);
    if (status) return status;
    const int kind = kind_of(r, node, kinds, "line, arc and clothoid");
    if (kind < 0) return HAWSER_ERR_INPUT;
    RoutePlanElement *const e = item;
    *e = in.element;
    e->length = kind == 0 ? in.line : kind == 1 ? in.arc : in.clothoid;
    status = keys_only(r, node, kinds[kind], allowed[kind]);
    if (!status && kind == 1) status = key_needed(r, node, "radius", "arc");
    if (!status && kind == 1) status = radius_check(r, node, "radius", in.radius);
    if (!status && kind == 1) e->curvature[0] = e->curvature[1] = 1 / in.radius;
    if (!status && kind == 2) status = ends_read(r, node, in.start_radius, in.end_radius, e->curvature);
    for (int k = 0; k < 2; ++k) e->curvature[k] *= in.right ? -1 : 1;
    return status;
}

static hawser_status profile_read(const CaseReader *r, const CaseNode *node, void *item)
{
    RouteProfileCorner *const c = item;
    const hawser_status status = case_section_read(r, node, &case_route_profile, c);
    if (status) return status;
    if (!isnan(c->radius) && !isnan(c->parabola))
        return case_key_error(r->err, node, "parabola", "beside 'radius': give one of them");
    if (isnan(c->radius)) c->radius = 0;
    if (isnan(c->parabola)) c->parabola = 0;
    return HAWSER_OK;
}

static hawser_status plan_line(const CaseReader *r, const CaseNode *plan, const CaseNode *rise, const RouteRecord *in,
                               Vec3 start, RouteLine *out)
{
    RoutePlanElement *part = NULL;
    RouteProfileCorner *corner = NULL;
    RouteProfile profile = {.n = 0};
    hawser_error why = {.message = ""};
    int n = 0, n_corners = 0;
    hawser_status status = case_list_read(r, plan, sizeof *part, plan_read, &part, &n);
    if (!status) status = case_list_read(r, rise, sizeof *corner, profile_read, &corner, &n_corners);
    if (!status && rise && n_corners < 2)
        status = case_value_error(r->err, rise, " of %d points: expected two at least", n_corners);
    if (!status && rise) {
        status = route_profile_from_corners(n_corners, corner, in->transition, &profile, &why);
        if (status) status = case_key_cause(r->err, rise, NULL, "", &why);
    }
    if (!status) {
        const Vec3 from = v3(start.x, start.y, rise ? 0 : start.z);
        status =
            route_from_plan_and_profile(n, part, rise ? &profile : NULL, in->station, from, in->heading, out, &why);
        if (status) status = case_key_cause(r->err, rise ? rise : plan, NULL, "", &why);
    }
    free(part);
    free(corner);
    free(profile.element);
    return status;
}

/* Reads the origin of coordinates of results and of the definition: a point in the surveyor's coordinates. */
static hawser_status origin_read(const CaseReader *r, const CaseNode *node, Vec3 first)
{
    const CaseKey *const key = case_key_of(&case_route, "origin"), *const keys[3] = {key, key, key};
    Vec3 *const origin = &r->def->route_origin;
    *origin = V3_ZERO;
    if (node && !(node->kind == NODE_TEXT && strcmp(node->text, "auto") == 0)) {
        double value[3] = {0, 0, 0};
        if (node->kind != NODE_LIST) return case_value_error(r->err, node, ": expected %s", key->form);
        const hawser_status status = case_numbers_read(r, node, 3, keys, value);
        *origin = v3(value[0], value[1], value[2]);
        return status;
    }
    if (fmax(fabs(first.x), fabs(first.y)) > NEAR)
        *origin = v3(ORIGIN_GRID * round(first.x / ORIGIN_GRID), ORIGIN_GRID * round(first.y / ORIGIN_GRID), 0);
    return HAWSER_OK;
}

/* -------------------------------------------------------------------------------------------------- from a file */

/* Makes the line of a file, with its own heights or another file's. */
static hawser_status file_line(CaseReader *r, const CaseNode *node, const RouteRecord *in, RouteLine *out)
{
    const CaseNode *const profile = case_node_key(node, "profile");
    HeightRecord heights = {.line = {.file = ""}};
    UsedLine used = {.fitted = 0};
    hawser_error why = {.message = ""};
    LineOptions options = line_options();
    options.reverse = in->reverse;
    options.from = in->from;
    options.to = in->to;
    options.tolerance = in->tolerance;
    options.line.join = options.profile.join = in->join;
    options.corner = in->radius;
    options.rounding = in->transition;
    options.height = in->height;
    hawser_status status = HAWSER_OK;
    if (profile && profile->kind != NODE_MAP)
        return case_value_error(r->err, profile, ": with 'file' a map that names another file, {file: profile.csv}");
    if (profile) status = case_section_read(r, profile, &case_route_heights, &heights);
    if (!status && case_node_key(profile, "corners"))
        return case_key_error(r->err, profile, "corners", "not with the 'file' of a route: they belong to a 'plan'");
    if (!status) status = case_line_use(r, node, &in->line, profile, &heights.line, &options, &used);
    if (status) return status;
    status = origin_read(r, case_node_key(node, "origin"), alignment_measure(&used.line).start);
    if (!status) {
        status = line_route(&used, &options, r->def->route_origin, out, &why);
        if (status) status = case_key_cause(r->err, node, "file", in->line.file, &why);
    }
    r->def->route_north = used.mapped ? PI / 2 : NAN;
    r->route_station = used.line.station;
    r->stations = in->reverse ? -1 : 1;
    line_clear(&used);
    return status;
}

/* Finds the corners of a plan's profile: the list alone, or the map's. */
static hawser_status corners_find(const CaseReader *r, const CaseNode *profile, const CaseNode **corners)
{
    HeightRecord heights;
    *corners = profile;
    if (!profile || profile->kind != NODE_MAP) return HAWSER_OK;
    const hawser_status status = case_section_read(r, profile, &case_route_heights, &heights);
    *corners = case_node_key(profile, "corners");
    if (status || (*corners && !*heights.line.file)) return status;
    return case_key_error(r->err, profile, *corners ? "file" : "corners",
                          *corners ? "not with 'corners'" : "missing: the profile of a 'plan' is its corners");
}

/* ----------------------------------------------------------------------------------------------- the section */

/* Checks which keys go with which list. */
static hawser_status form_check(const CaseReader *r, const CaseNode *node)
{
    enum { PIECES = 1, POINTS = 2, PLAN = 4, FILE_ = 8 };
    static const char *const lists[] = {"pieces", "points", "plan", "file", NULL};
    static const struct {
        const char *key;
        int with;
    } only[] = {{"slope", PIECES},
                {"heading", PIECES | PLAN},
                {"radius", POINTS | FILE_},
                {"spline", POINTS},
                {"start", PIECES | PLAN},
                {"profile", PLAN | FILE_},
                {"station", PLAN},
                {"name", FILE_},
                {"layer", FILE_},
                {"units", FILE_},
                {"sheet", FILE_},
                {"ignore", FILE_},
                {"reverse", FILE_},
                {"from", FILE_},
                {"to", FILE_},
                {"tolerance", FILE_},
                {"join", FILE_},
                {"height", FILE_}};
    const int kind = kind_of(r, node, lists, "pieces, points, plan and file");
    if (kind < 0) return HAWSER_ERR_INPUT;
    const CaseNode *const list = case_node_key(node, lists[kind]);
    for (size_t k = 0; k < sizeof only / sizeof *only; ++k) {
        const CaseNode *const given = case_node_key(node, only[k].key);
        if (!given || only[k].with >> kind & 1) continue;
        return case_key_error(r->err, given, NULL, "not with '%s'", lists[kind]);
    }
    if (kind == 3) return HAWSER_OK;
    if (list->count == 0) return case_value_error(r->err, list, " without a piece: the route is empty");
    if (kind == 1 && list->count < 2)
        return case_value_error(r->err, list, " of %d: expected two points at least", list->count);
    return HAWSER_OK;
}

/* Sets the default radius of changes of slope: the cable's limit, or 20 of its diameters. */
static hawser_status transition_read(const CaseReader *r, RouteRecord *in)
{
    const CaseNode *const limit = case_node_key(case_node_key(r->root, "limits"), "bend_radius");
    r->def->slopes_open = isnan(in->transition);
    if (!isnan(in->transition)) return HAWSER_OK;
    in->transition = 20 * case_largest_diameter(r->def);
    return limit ? case_number_read(r, limit, case_key_of(&case_limits, "bend_radius"), &in->transition) : HAWSER_OK;
}

/* Makes the route as a line of pieces that counts from the origin. */
static hawser_status line_read(CaseReader *r, const CaseNode *node, const RouteRecord *in, RouteLine *out)
{
    const CaseNode *const points = case_node_key(node, "points"), *const plan = case_node_key(node, "plan");
    const CaseNode *profile;
    RouteCorner *corner = NULL;
    int n = 0;
    if (case_node_key(node, "file")) return file_line(r, node, in, out);
    hawser_status status = corners_find(r, case_node_key(node, "profile"), &profile);
    if (!status && points) status = case_list_read(r, points, sizeof *corner, point_read, &corner, &n);
    if (!status) status = origin_read(r, case_node_key(node, "origin"), points ? corner[0].point : in->start);
    const Vec3 start = v3_sub(in->start, r->def->route_origin);
    if (!status && points) status = points_line(r, points, in, r->def->route_origin, n, corner, out);
    if (!status && plan) {
        status = plan_line(r, plan, profile, in, start, out);
        if (profile) out->start.z -= r->def->route_origin.z;
    }
    if (!status && !points && !plan) {
        status = pieces_line(r, case_node_key(node, "pieces"), in, out);
        out->start = start;
    }
    free(corner);
    return status;
}

/* Checks that the cable's front at the start is on the route. */
static hawser_status head_check(const CaseReader *r, const CaseNode *node)
{
    double *const head = &r->def->head_at;
    if (isnan(*head)) *head = r->route.length;
    if (*head <= r->route.length + 1e-6) return HAWSER_OK;
    return case_value_error(r->err, case_node_key(node, "head_at"),
                            " is out of range: must be on the route, at most %.10g m", r->route.length);
}

/* Builds the route already here: rollers and stations are placed along it. */
hawser_status case_route_read(CaseReader *r, const CaseNode *node)
{
    SceneDef *const def = r->def;
    def->route_north = NAN;
    if (def->rod.present) return HAWSER_OK;
    if (!node) return case_key_error(r->err, r->root, "route", "missing: give it, or a 'rod'");
    RouteRecord in = {.start = V3_ZERO};
    RouteLine line = {.n = 0};
    hawser_status status = case_section_read(r, node, &case_route, &in);
    if (!status) status = form_check(r, node);
    if (!status) status = transition_read(r, &in);
    if (!status) status = line_read(r, node, &in, &line);
    def->route = line.piece;
    def->n_route = line.n;
    if (status) return status;
    def->route_start = line.start;
    def->route_heading = line.heading;
    def->route_slope = line.slope;
    def->head_at = in.head_at;
    if (!isnan(in.north)) def->route_north = in.north;
    status = route_build(&r->route, def->n_route, def->route, def->route_start, def->route_heading, def->route_slope,
                         r->err);
    if (!status && !case_node_key(r->root, "chain")) def->pieces[0].length = r->route.length;
    return status ? status : head_check(r, node);
}
