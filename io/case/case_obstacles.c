/* Things that stand in the way: boxes, edges (round bars) and the bell-mouths of ducts. They join the rollers' list,
 * where the cable touches them and their loads are kept; having no place along the route they are no rollers to theory.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "io/case/case_parts.h"

enum { OBSTACLE_BOX, OBSTACLE_EDGE, OBSTACLE_BELL, OBSTACLE_KINDS };
static const char *const kinds[OBSTACLE_KINDS] = {"box", "edge", "bell"};
static const char *const ends[] = {"entry", "exit", NULL};

/* An obstacle being read: what it will be, and how it is described. */
typedef struct Obstacle {
    RollerDef def;
    char name[OBSTACLE_KINDS][NAME_MAX_LENGTH / 2]; /* of each kind that is given */
    double at;                                      /* m along the route; NAN: by its centre */
    Vec3 offset;                                    /* m: along the route, to the left, up */
    Vec3 size;                                      /* m: along the axis, across, high */
    double round, length, radius;                   /* m */
    int end;
} Obstacle;

/* Exactly one of the first three; which keys go with which, owners_check says. */
static const CaseKey obstacle_keys[] = {
    {"box", KEY_TEXT, .fallback = "", AT(Obstacle, name[OBSTACLE_BOX])},
    {"edge", KEY_TEXT, .fallback = "", AT(Obstacle, name[OBSTACLE_EDGE])},
    {"bell", KEY_TEXT, .fallback = "", AT(Obstacle, name[OBSTACLE_BELL])},
    {"at", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: `centre` says where it is", FROM(-LONG, LONG), AT(Obstacle, at)},
    {"offset", KEY_POINT, DIM_LENGTH, .fallback = "[0, 0, 0]", FROM(-1e3, 1e3), AT(Obstacle, offset)},
    {"centre", KEY_POINT, DIM_LENGTH, .fallback = "[0, 0, 0]", FROM(-1e8, 1e8), AT(Obstacle, def.centre)},
    {"axis", KEY_POINT, .fallback = "[0, 0, 0]", FROM(-1e6, 1e6), AT(Obstacle, def.axis)},
    {"size", KEY_POINT, DIM_LENGTH, .fallback = "[0, 0, 0]", FROM(0, 1e4), AT(Obstacle, size)},
    {"round", KEY_NUMBER, DIM_LENGTH, .fallback = "5 mm", ABOVE(0, 1e3), AT(Obstacle, round)},
    {"length", KEY_NUMBER, DIM_LENGTH, .fallback = "1 m", ABOVE(0, 1e4), AT(Obstacle, length)},
    {"radius", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: edges and bell-mouths need it", ABOVE(0, 1e3),
     AT(Obstacle, radius)},
    {"end", KEY_CHOICE, .fallback = "entry", .choices = ends, AT(Obstacle, end)},
    {"rating", KEY_NUMBER, DIM_FORCE, .fallback = "0 N", FROM(0, STRONG), AT(Obstacle, def.rating)},
    {"friction", KEY_MAP, .otherwise = "the case's", .section = &case_friction},
};
SECTION(case_obstacle, "obstacles.N", obstacle_keys);

/* Which keys a kind has, and which it needs. */
enum { BOX = 1 << OBSTACLE_BOX, EDGE = 1 << OBSTACLE_EDGE, BELL = 1 << OBSTACLE_BELL };
static const struct {
    const char *key;
    int allowed, needed;
} owners[] = {
    {"at", BOX | EDGE, 0},   {"offset", BOX | EDGE, 0}, {"centre", BOX | EDGE, 0},
    {"axis", BOX | EDGE, 0}, {"size", BOX, BOX},        {"round", BOX, 0},
    {"length", EDGE, 0},     {"end", BELL, 0},          {"radius", EDGE | BELL, EDGE | BELL},
};

static hawser_status owners_check(const CaseReader *r, const CaseNode *node, int kind)
{
    for (size_t k = 0; k < sizeof owners / sizeof *owners; k++) {
        const CaseNode *const given = case_node_key(node, owners[k].key);
        if (given && !(owners[k].allowed & 1 << kind)) {
            return case_key_error(r->err, given, NULL, "not allowed for an obstacle of kind '%s'", kinds[kind]);
        }
        if (!given && owners[k].needed & 1 << kind) {
            return case_key_error(r->err, node, owners[k].key, "missing: an obstacle of kind '%s' needs it",
                                  kinds[kind]);
        }
    }
    return HAWSER_OK;
}

/* The one kind that is given. */
static hawser_status kind_find(const CaseReader *r, const CaseNode *node, int *kind)
{
    int n = 0;
    for (int k = 0; k < OBSTACLE_KINDS; k++) {
        if (!case_node_key(node, kinds[k])) continue;
        *kind = k;
        n++;
    }
    if (n == 1) return HAWSER_OK;
    return case_key_error(r->err, node, NULL, "expected one of 'box', 'edge' and 'bell'");
}

/* Centre and axis, by coordinates or from the route's line; side: level and square to the axis. An axis that is not
 * given is the route's direction for a box, and across it for an edge. */
static hawser_status place_find(const CaseReader *r, const CaseNode *node, int kind, Obstacle *o, Vec3 *side)
{
    RollerDef *const d = &o->def;
    const int along = !isnan(o->at), turned = case_node_key(node, "axis") != NULL;
    if (along == (case_node_key(node, "centre") != NULL)) {
        return case_key_error(r->err, node, "at", "%s: give either 'at' or 'centre'",
                              along ? "given beside centre" : "missing");
    }
    if (along && r->def->rod.present)
        return case_key_error(r->err, node, "at", "not with a rod, which has no route: give 'centre'");
    if (!along && case_node_key(node, "offset"))
        return case_key_error(r->err, case_node_key(node, "offset"), NULL, "only with 'at'");
    if (turned ? v3_norm(d->axis) < 1e-9 : !along) {
        return case_key_error(r->err, node, "axis",
                              turned ? "expected a direction that is not zero" : "missing: needed with 'centre'");
    }
    if (!along) d->centre = v3_sub(d->centre, r->def->route_origin);
    if (along) {
        const RoutePoint on = route_at(&r->route, o->at);
        const Vec3 left = route_left(&r->route, o->at), up = v3_cross(on.tangent, left);
        d->centre = v3_axpy(v3_axpy(v3_axpy(on.position, o->offset.x, on.tangent), o->offset.y, left), o->offset.z, up);
        if (!turned) d->axis = kind == OBSTACLE_BOX ? on.tangent : left;
    }
    d->axis = v3_unit(d->axis);
    const Vec3 level = v3_cross(v3(0, 0, 1), d->axis);
    *side = v3_norm(level) > 1e-6 ? v3_unit(level) : v3(0, 1, 0);
    if (v3_norm(level) <= 1e-6) *side = v3_unit(v3_reject(*side, d->axis));
    return HAWSER_OK;
}

/* A box by its sizes; an edge is a bar that is round all over. */
static hawser_status box_make(const CaseReader *r, const CaseNode *node, int kind, Obstacle *o)
{
    RollerDef *const d = &o->def;
    Vec3 side;
    const hawser_status status = place_find(r, node, kind, o, &side);
    if (status) return status;
    if (kind == OBSTACLE_EDGE) {
        o->size = v3(fmax(o->length, 2 * o->radius), 2 * o->radius, 2 * o->radius);
        o->round = o->radius;
    }
    const double least = fmin(o->size.x, fmin(o->size.y, o->size.z)) / 2;
    if (!(least > 0)) return case_key_error(r->err, node, "size", "out of range: every size must be above 0 m");
    if (o->round > least) {
        const CaseNode *const given = case_node_key(node, "round");
        return case_key_error(r->err, given ? given : node, given ? NULL : "round",
                              "%g m is out of range: must be at most half of the smallest size, %g m", o->round, least);
    }
    d->profile = SHAPE_BOX;
    d->radius = least;
    d->width = o->size.x;
    d->box = (BoxSection){.side = side, .half = {o->size.y / 2, o->size.z / 2}, .edge = o->round};
    return HAWSER_OK;
}

/* The duct of this name; NULL: none. */
static const SurfaceDef *duct_named(const SceneDef *def, const char *name)
{
    for (int i = 0; i < def->n_surfaces; i++) {
        const SurfaceDef *const d = &def->surfaces[i];
        if (d->shape.kind == SURFACE_DUCT && strcmp(d->name, name) == 0) return d;
    }
    return NULL;
}

/* The flare at a duct's end: its throat stands where the duct ends and has the duct's bore (OB4). Behind the throat the
 * ring falls back from the bore, and the wall, which comes in over its fade, takes over. */
static hawser_status bell_make(const CaseReader *r, const CaseNode *node, Obstacle *o)
{
    RollerDef *const d = &o->def;
    const SurfaceDef *const duct = duct_named(r->def, o->name[OBSTACLE_BELL]);
    if (!duct) {
        return case_value_error(r->err, case_node_key(node, "bell"), " is not the name of a duct in 'surfaces.ducts'");
    }
    const SurfaceShape *const s = &duct->shape;
    if (!(o->radius > s->cable_radius)) {
        return case_value_error(r->err, case_node_key(node, "radius"),
                                " is out of range: must be above the largest cable's radius, %g m", s->cable_radius);
    }
    if (s->fade > o->radius) {
        return case_value_error(
            r->err, case_node_key(node, "radius"),
            " is out of range: must be at least the duct's 'fade', %g m, over which its wall begins", s->fade);
    }
    const double at = o->end == 0 ? s->from : s->to;
    const RoutePoint on = route_at(&r->route, at);
    const Vec3 up = v3_cross(on.tangent, route_left(&r->route, at));
    d->profile = SHAPE_BELL;
    d->centre = v3_axpy(on.position, s->lift, up);
    d->axis = o->end == 0 ? v3_scale(-1, on.tangent) : on.tangent;
    d->radius = o->radius;
    d->width = 2 * o->radius;
    d->bell.ring = s->radius + o->radius;
    return HAWSER_OK;
}

static hawser_status obstacle_read(const CaseReader *r, const CaseNode *node)
{
    SceneDef *const def = r->def;
    Obstacle o = {.end = 0};
    int kind = 0;
    hawser_status status = case_section_read(r, node, &case_obstacle, &o);
    if (!status) status = kind_find(r, node, &kind);
    if (!status) status = owners_check(r, node, kind);
    if (!status) status = kind == OBSTACLE_BELL ? bell_make(r, node, &o) : box_make(r, node, kind, &o);
    if (!status) {
        status = case_friction_read(r, case_node_key(node, "friction"), &def->friction, &o.def.friction);
    }
    if (status) return status;
    /* the results' tables have rollers and obstacles together: the name says which it is */
    RollerDef *const out = &def->rollers[def->n_rollers++];
    *out = o.def;
    out->s = NAN;
    snprintf(out->name, sizeof out->name, "%s %s%s%s", kinds[kind], o.name[kind], kind == OBSTACLE_BELL ? " " : "",
             kind == OBSTACLE_BELL ? ends[o.end] : "");
    return case_overlap_check(r, node, out);
}

hawser_status case_obstacles_read(CaseReader *r, const CaseNode *list)
{
    SceneDef *const def = r->def;
    hawser_status status = HAWSER_OK;
    if (!list) return HAWSER_OK;
    if (list->count > CASE_ROLLERS_MAX - def->n_rollers) {
        return case_key_error(r->err, list, NULL, "too many rollers and obstacles: at most %d", CASE_ROLLERS_MAX);
    }
    RollerDef *const all = realloc(def->rollers, (size_t)(def->n_rollers + list->count + 1) * sizeof *all);
    if (!all) return error_memory(r->err);
    def->rollers = all;
    for (const CaseNode *item = list->first; item && !status; item = item->next) status = obstacle_read(r, item);
    return status;
}
