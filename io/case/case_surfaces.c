#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "io/case/case_parts.h"

/* A surface being read: the definition, and a duct's place (centred or resting) or a tray's section. */
typedef struct Surface {
    SurfaceDef def;
    int choice;
} Surface;

static const char *const places[] = {"centred", "resting", NULL};

static const char *const tray_sections[] = {"flat", "v", "u", NULL};

static const CaseKey occupied_keys[] = {
    {"cables", KEY_INTEGER, .fallback = "1", FROM(1, 3), AT(DuctLying, cables)},
    {"d", KEY_NUMBER, DIM_LENGTH, .required = 1, ABOVE(0, 10), AT(DuctLying, diameter)},
    {"friction_factor", KEY_NUMBER, .required = 1, ABOVE(0, 10), AT(DuctLying, friction)},
};

static SECTION(occupied, "surfaces.ducts.N.occupied", occupied_keys);

/* Stretches may leave the route here; stretch_check rejects that. */
static const CaseKey duct_keys[] = {
    {"type", KEY_ANY, .otherwise = "none", .form = "a name of the catalogue"},
    {"name", KEY_TEXT, .fallback = "", AT(Surface, def.name)},
    {"from", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, LONG), AT(Surface, def.shape.from)},
    {"to", KEY_NUMBER, DIM_LENGTH, .otherwise = "the route's end", FROM(0, LONG), AT(Surface, def.shape.to)},
    {"radius", KEY_NUMBER, DIM_LENGTH, .required = 1, ABOVE(0, 1e3), AT(Surface, def.shape.radius)},
    {"place", KEY_CHOICE, .fallback = "centred", .choices = places, AT(Surface, choice)},
    {"fade", KEY_NUMBER, DIM_LENGTH, .fallback = "500 mm", ABOVE(0, LONG), AT(Surface, def.shape.fade)},
    {"friction", KEY_MAP, .otherwise = "the case's", .section = &case_friction},
    {"occupied", KEY_MAP, .otherwise = "empty", .section = &occupied},
};

static SECTION(duct, "surfaces.ducts.N", duct_keys);

/* tray_finish checks which keys belong to which section. */
static const CaseKey tray_keys[] = {
    {"name", KEY_TEXT, .fallback = "", AT(Surface, def.name)},
    {"from", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, LONG), AT(Surface, def.shape.from)},
    {"to", KEY_NUMBER, DIM_LENGTH, .otherwise = "the route's end", FROM(0, LONG), AT(Surface, def.shape.to)},
    {"section", KEY_CHOICE, .fallback = "flat", .choices = tray_sections, AT(Surface, choice)},
    {"width", KEY_NUMBER, DIM_LENGTH, .otherwise = "400 mm", ABOVE(0, 1e3), AT(Surface, def.shape.width)},
    {"height", KEY_NUMBER, DIM_LENGTH, .otherwise = "`flat` 0 m, `v` two cable diameters, `u` the radius", FROM(0, 1e3),
     AT(Surface, def.shape.height)},
    {"angle", KEY_NUMBER, DIM_ANGLE, .otherwise = "90 deg", FROM(DEGREES(10), DEGREES(160)),
     AT(Surface, def.shape.angle)},
    {"radius", KEY_NUMBER, DIM_LENGTH, .otherwise = "none: `u` needs it", ABOVE(0, 1e3), AT(Surface, def.shape.radius)},
    {"depth", KEY_NUMBER, DIM_LENGTH, .otherwise = "the largest cable's radius", ABOVE(0, 1e3),
     AT(Surface, def.shape.depth)},
    {"fade", KEY_NUMBER, DIM_LENGTH, .fallback = "500 mm", ABOVE(0, LONG), AT(Surface, def.shape.fade)},
    {"friction", KEY_MAP, .otherwise = "the case's", .section = &case_friction},
};

static SECTION(tray, "surfaces.trays.N", tray_keys);

/* By coordinates. A length or width of 0 means no end. */
static const CaseKey plane_keys[] = {
    {"name", KEY_TEXT, .fallback = "", AT(Surface, def.name)},
    {"point", KEY_POINT, DIM_LENGTH, .required = 1, FROM(-1e8, 1e8), AT(Surface, def.shape.point)},
    {"normal", KEY_POINT, .required = 1, FROM(-1e6, 1e6), AT(Surface, def.shape.normal)},
    {"along", KEY_POINT, .fallback = "[0, 0, 0]", FROM(-1e6, 1e6), AT(Surface, def.shape.along)},
    {"length", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, LONG), AT(Surface, def.shape.length)},
    {"width", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, LONG), AT(Surface, def.shape.width)},
    {"fade", KEY_NUMBER, DIM_LENGTH, .fallback = "100 mm", ABOVE(0, LONG), AT(Surface, def.shape.fade)},
    {"friction", KEY_MAP, .otherwise = "the case's", .section = &case_friction},
};

static SECTION(plane, "surfaces.planes.N", plane_keys);

/* No fallbacks: absent values are the rollers'. */
static const CaseKey line_contact_keys[] = {
    {"k", KEY_ANY, DIM_STIFFNESS, .otherwise = "the rollers'", .form = "a force per length to the power e",
     ABOVE(0, 1e18)},
    {"e", KEY_NUMBER, .otherwise = "the rollers'", FROM(1, 5), AT(ImpactLaw, e)},
    {"c", KEY_NUMBER, DIM_DASHPOT, .otherwise = "the rollers'", FROM(0, 1e12), AT(ImpactLaw, c)},
    {"d", KEY_NUMBER, DIM_LENGTH, .otherwise = "the rollers'", ABOVE(0, 1), AT(ImpactLaw, d)},
};

static SECTION(line_contact, "surfaces.contact", line_contact_keys);

/* Surfaces on which the cable lies along a length. */
static const CaseKey surfaces_keys[] = {
    {"ducts", KEY_LIST, .otherwise = "none", .form = "ducts one by one", .section = &duct},
    {"trays", KEY_LIST, .otherwise = "none", .form = "trays, troughs and floors one by one", .section = &tray},
    {"planes", KEY_LIST, .otherwise = "none", .form = "floors and walls one by one", .section = &plane},
    {"contact", KEY_MAP, .otherwise = "as section `contact`", .section = &line_contact},
};

SECTION(case_surfaces, "surfaces", surfaces_keys);

/* Largest overlap of a surface and the cable at the start that is not an error, and step at which planes are checked
 * for it, m. */
static const double PRESS_MAX = 1e-3, LOOK_STEP = 0.05;

/* Rounding, m, of a stretch beyond the route's end, and of two overlapping stretches. */
static const double SLACK = 1e-6;

/* Reads the law for each metre of cable; values that are not given are the rollers'. */
static hawser_status line_contact_read(const CaseReader *r, const CaseNode *node)
{
    ImpactLaw *const law = &r->def->line_impact;
    const CaseNode *const k = case_node_key(node, "k");
    ImpactLaw given = {0};
    *law = r->def->impact;
    const hawser_status status = case_section_read(r, node, &line_contact, &given);
    if (status) return status;
    if (!isnan(given.e)) law->e = given.e;
    if (!isnan(given.c)) law->c = given.c;
    if (!isnan(given.d)) law->d = given.d;
    return k ? case_stiffness_read(r, k, law->e, &law->k) : HAWSER_OK;
}

/* Checks the stiffness beside an exponent of its own, with which the rollers' stiffness has another unit. */
static hawser_status line_exponent_check(const CaseReader *r, const CaseNode *node)
{
    if (!node || r->def->line_impact.e == r->def->impact.e || case_node_key(node, "k")) return HAWSER_OK;
    return case_key_error(r->err, node, "k",
                          "missing: an exponent that is not the rollers', %g, needs its own stiffness",
                          r->def->impact.e);
}

/* Checks that a stretch is on the route, long enough for its ends' fades, and free. */
static hawser_status stretch_check(const CaseReader *r, const CaseNode *node, const SurfaceDef *surface)
{
    const SurfaceShape *const s = &surface->shape;
    if (s->to > r->route.length + SLACK) {
        return case_key_error(r->err, node, case_node_key(node, "to") ? "to" : "from",
                              "%g m is out of range: must be on the route, at most %.10g m", s->to, r->route.length);
    }
    if (!(s->to - s->from >= s->fade - SLACK)) {
        return case_key_error(r->err, node, "to", "%g m is out of range: must be at least 'from' plus 'fade', %g m",
                              s->to, s->from + s->fade);
    }
    for (int i = 0; i < r->def->n_surfaces; i++) {
        const SurfaceDef *const other = &r->def->surfaces[i];
        if (s->from >= other->shape.to - SLACK || s->to <= other->shape.from + SLACK) continue;
        return case_key_error(r->err, node, "from", "%g m to %g m overlaps '%s', which lies from %g m to %g m", s->from,
                              s->to, other->name, other->shape.from, other->shape.to);
    }
    return HAWSER_OK;
}

/* Checks that all bends of the stretch are wider than the surface on the side of their centre. */
static hawser_status bends_check(const CaseReader *r, const CaseNode *node, const SurfaceShape *s, double extent,
                                 const char *key)
{
    for (int i = 0; i < r->route.n; i++) {
        const RoutePiece *const p = &r->route.piece[i];
        if (p->kind == ROUTE_STRAIGHT || p->s0 >= s->to || p->s0 + p->length <= s->from) continue;
        if (p->radius > extent) continue;
        return case_key_error(r->err, node, key,
                              "%g m is out of range: must be below the radius of the bend at %.10g m, %g m", extent,
                              p->s0, p->radius);
    }
    return HAWSER_OK;
}

/* Rejects level sections on stretches that are nearly upright: no steady level direction exists there. */
static hawser_status slopes_check(const CaseReader *r, const CaseNode *node, const SurfaceShape *s)
{
    const double steepest = 80 * 3.14159265358979323846 / 180;
    for (int k = 0; s->from + k * LOOK_STEP < s->to; k++) {
        const double at = s->from + k * LOOK_STEP;
        if (fabs(route_slope(&r->route, at)) <= steepest) continue;
        return case_key_error(r->err, node, "from",
                              "the route is steeper than 80 deg at %g m: only a centred duct can be", at);
    }
    return HAWSER_OK;
}

/* Sets the clearance of the equivalent cable's duct: the play of the bundle's middle (BU8). */
static hawser_status bundle_room(const CaseReader *r, const CaseNode *node, SurfaceDef *out)
{
    hawser_error why = {.message = ""};
    DuctLoad load;
    out->bore = out->shape.radius;
    if (bundle_in(r->def, out, &load, &why)) {
        if (why.status == HAWSER_ERR_MEMORY) return error_memory(r->err);
        return case_key_error(r->err, node, "radius", "duct '%s': %s", out->name, why.message);
    }
    out->shape.radius = r->def->bundle.shape.touch / 2 + load.room;
    return HAWSER_OK;
}

/* Reads the cables that lie in the duct already. */
static hawser_status occupied_read(const CaseReader *r, const CaseNode *node, SurfaceDef *out)
{
    DuctLoad load;
    hawser_error why = {.message = ""};
    if (!node) return HAWSER_OK;
    const hawser_status status = case_section_read(r, node, &occupied, &out->lying);
    if (status || !bundle_in(r->def, out, &load, &why)) return status;
    return case_key_error(r->err, node, NULL, "duct '%s': %s", out->name, why.message);
}

static hawser_status duct_finish(const CaseReader *r, const CaseNode *node, int resting, SurfaceDef *out)
{
    SurfaceShape *const s = &out->shape;
    s->kind = SURFACE_DUCT;
    const hawser_status beside = occupied_read(r, case_node_key(node, "occupied"), out);
    if (beside) return beside;
    if (bundle_present(&r->def->bundle)) {
        const hawser_status fits = bundle_room(r, node, out);
        if (fits) return fits;
    }
    if (s->radius <= s->cable_radius) {
        return case_key_error(r->err, node, "radius",
                              "%g m is too small: must be above the largest cable's radius, %g m", s->radius,
                              s->cable_radius);
    }
    if (resting) s->lift = s->radius - s->cable_radius;
    const hawser_status status = bends_check(r, node, s, s->radius + s->lift, "radius");
    return status || !resting ? status : slopes_check(r, node, s);
}

/* Rejects a key that trays of this section do not have. */
static hawser_status tray_key(const CaseReader *r, const CaseNode *node, const char *key, int allowed)
{
    const CaseNode *given = case_node_key(node, key);
    if (allowed || !given) return HAWSER_OK;
    return case_key_error(r->err, given, NULL, "not allowed for a tray with this cross-section");
}

/* Checks a flat tray: its width between the sides, or overall. */
static hawser_status flat_check(const CaseReader *r, const CaseNode *node, const SurfaceShape *s)
{
    if (s->height > 0 && s->width <= 2 * s->cable_radius) {
        return case_key_error(
            r->err, node, "width",
            "%g m is too small: its sides must be farther apart than the largest cable's diameter, %g m", s->width,
            2 * s->cable_radius);
    }
    return bends_check(r, node, s, s->width / 2, "width");
}

static hawser_status u_check(const CaseReader *r, const CaseNode *node, const SurfaceShape *s)
{
    if (isnan(s->radius)) return case_key_error(r->err, node, "radius", "missing: section u has a radius");
    if (s->radius <= s->cable_radius) {
        return case_key_error(r->err, node, "radius",
                              "%g m is too small: must be above the largest cable's radius, %g m", s->radius,
                              s->cable_radius);
    }
    return bends_check(r, node, s, s->radius, "radius");
}

/* Fills the numbers that were not given, by the section. */
static void tray_fill(int section, SurfaceShape *s)
{
    static const SurfaceKind kinds[] = {SURFACE_FLAT, SURFACE_V, SURFACE_U};
    const double heights[] = {0, 4 * s->cable_radius, s->radius};
    s->kind = kinds[section];
    if (isnan(s->width)) s->width = 0.4;
    if (isnan(s->angle)) s->angle = 3.14159265358979323846 / 2;
    if (isnan(s->depth)) s->depth = s->cable_radius;
    if (isnan(s->height)) s->height = heights[section];
}

static hawser_status tray_finish(const CaseReader *r, const CaseNode *node, int section, SurfaceDef *out)
{
    SurfaceShape *const s = &out->shape;
    tray_fill(section, s);
    hawser_status status = tray_key(r, node, "width", s->kind == SURFACE_FLAT);
    if (!status) status = tray_key(r, node, "angle", s->kind == SURFACE_V);
    if (!status) status = tray_key(r, node, "radius", s->kind == SURFACE_U);
    if (!status && s->kind == SURFACE_FLAT) status = flat_check(r, node, s);
    if (!status && s->kind == SURFACE_V) status = bends_check(r, node, s, s->height + s->cable_radius, "height");
    if (!status && s->kind == SURFACE_U) status = u_check(r, node, s);
    if (!status) status = slopes_check(r, node, s);
    if (!status && s->depth < s->cable_radius - PRESS_MAX) {
        status = case_key_error(r->err, node, "depth",
                                "%g m is too small: the cable lies on the route at the start and has a radius of %g m",
                                s->depth, s->cable_radius);
    }
    return status;
}

/* Checks that the cable begins on the free side of a plane, wherever it lies over it. */
static hawser_status plane_check(const CaseReader *r, const CaseNode *node, const SurfaceDef *surface)
{
    const SceneDef *const def = r->def;
    SurfacePatch patch;
    if (def->rod.present) return HAWSER_OK; /* a rod has no route */
    surface_patches(&surface->shape, &r->route, 0, &patch);
    for (int p = 0; p < def->n_pieces; p++) {
        const double radius = def->cables[def->pieces[p].cable].diameter / 2;
        double from, to;
        case_piece_place(def, p, &from, &to);
        for (int k = 0; from + k * LOOK_STEP <= to; k++) {
            const double s = from + k * LOOK_STEP;
            const SurfaceProbe at = surface_probe(&patch, route_at(&r->route, s).position);
            if (!at.owned || at.share <= 0 || at.distance >= radius - PRESS_MAX) continue;
            if (at.distance <= -patch.depth) continue; /* the cable passes behind the plane */
            return case_key_error(
                r->err, node, "point",
                "plane '%s' is inside the cable: %.4g m along the route it is %.4g m from the line, must "
                "be at least the cable's radius, %.4g m",
                surface->name, s, at.distance, radius);
        }
    }
    return HAWSER_OK;
}

/* Returns a direction along a plane; without ends any will do. */
static Vec3 along_of(Vec3 given, Vec3 normal)
{
    const Vec3 level = fabs(normal.z) < 0.9 ? v3(0, 0, 1) : v3(1, 0, 0);
    const Vec3 wanted = v3_norm(given) > 0 ? v3_unit(given) : v3_cross(level, normal);
    return v3_unit(v3_reject(wanted, normal));
}

static hawser_status plane_finish(const CaseReader *r, const CaseNode *node, int none, SurfaceDef *out)
{
    SurfaceShape *const s = &out->shape;
    (void)none;
    if (v3_norm(s->normal) < 1e-9) {
        return case_value_error(r->err, case_node_key(node, "normal"), ": expected a direction that is not zero");
    }
    s->kind = SURFACE_PLANE;
    s->normal = v3_unit(s->normal);
    s->point = v3_sub(s->point, r->def->route_origin);
    s->along = along_of(s->along, s->normal);
    if (!(v3_norm(s->along) > 0.5)) {
        return case_value_error(r->err, case_node_key(node, "along"),
                                ": expected a direction that is not the normal's");
    }
    return plane_check(r, node, out);
}

/* Ducts, then trays, then planes: the order of the results. `finish` gets a duct's place or a tray's section. */
typedef struct SurfaceList {
    const char *key;
    const CaseSection *section;
    const char *letter; /* begins default names */
    int along;          /* it occupies a stretch of the route alone */
    hawser_status (*finish)(const CaseReader *r, const CaseNode *node, int choice, SurfaceDef *out);
} SurfaceList;

static const SurfaceList lists[] = {{"ducts", &duct, "D", 1, duct_finish},
                                    {"trays", &tray, "T", 1, tray_finish},
                                    {"planes", &plane, "P", 0, plane_finish}};

static hawser_status surface_read(const CaseReader *r, const CaseNode *node, const SurfaceList *list, SurfaceDef *out)
{
    Surface record = {0};
    hawser_status status = case_section_read(r, node, list->section, &record);
    *out = record.def;
    if (!*out->name) snprintf(out->name, sizeof out->name, "%s%d", list->letter, node->index + 1);
    out->shape.cable_radius = case_largest_diameter(r->def) / 2;
    if (isnan(out->shape.to)) out->shape.to = r->route.length;
    const CaseNode *const friction = case_node_key(node, "friction");
    out->friction_known = case_friction_known(r, friction, &r->def->friction_known);
    if (!status) status = case_friction_read(r, friction, &r->def->friction, &out->friction);
    if (!status && list->along) status = stretch_check(r, node, out);
    return status ? status : list->finish(r, node, record.choice, out);
}

/* Counts a surface only when it is complete. */
static hawser_status list_read(const CaseReader *r, const CaseNode *nodes, const SurfaceList *list)
{
    SceneDef *const def = r->def;
    if (!nodes) return HAWSER_OK;
    if (nodes->count > CASE_SURFACES_MAX - def->n_surfaces) {
        return case_key_error(r->err, nodes, NULL, "too many surfaces: at most %d", CASE_SURFACES_MAX);
    }
    SurfaceDef *const all = realloc(def->surfaces, (size_t)(def->n_surfaces + nodes->count + 1) * sizeof *all);
    if (!all) return error_memory(r->err);
    def->surfaces = all;
    for (const CaseNode *node = nodes->first; node; node = node->next, def->n_surfaces++) {
        const hawser_status status = surface_read(r, node, list, &all[def->n_surfaces]);
        if (status) return status;
    }
    return HAWSER_OK;
}

hawser_status case_surfaces_read(CaseReader *r, const CaseNode *node)
{
    const CaseNode *const contact = case_node_key(node, "contact");
    hawser_status status = case_section_read(r, node, &case_surfaces, r->def);
    if (!status) status = line_contact_read(r, contact);
    if (!status) status = line_exponent_check(r, contact);
    for (size_t k = 0; k < sizeof lists / sizeof *lists && !status; k++) {
        status = list_read(r, case_node_key(node, lists[k].key), &lists[k]);
    }
    return status;
}

/* Obstacles: boxes, edges (round bars) and the bell-mouths of ducts. They join the rollers' list, which handles their
 * contact and loads; without a place along the route theory does not treat them as rollers. */

enum { OBSTACLE_BOX, OBSTACLE_EDGE, OBSTACLE_BELL, OBSTACLE_KINDS };

static const char *const kinds[OBSTACLE_KINDS] = {"box", "edge", "bell"};

static const char *const ends[] = {"entry", "exit", NULL};

/* An obstacle being read, with its definition. */
typedef struct Obstacle {
    RollerDef def;
    char name[OBSTACLE_KINDS][NAME_MAX_LENGTH / 2]; /* one of each given kind */
    double at;                                      /* m along the route; NAN: by its centre */
    Vec3 offset;                                    /* m: along the route, to the left, up */
    Vec3 size;                                      /* m: along the axis, across, high */
    double round, length, radius;                   /* m */
    int end;
} Obstacle;

/* Exactly one of the first three is required; owners_check checks which keys go with which. */
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

/* Keys that a kind has, and keys that it requires. */
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

/* Finds the one kind that is given. */
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

/* Finds centre and axis, by coordinates or from the route's line; side: level and perpendicular to the axis. The
 * default axis is the route's direction for a box, and across it for an edge. */
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

/* Makes a box by its sizes; an edge is a bar that is round all over. */
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

/* Returns the duct of this name; NULL: none. */
static const SurfaceDef *duct_named(const SceneDef *def, const char *name)
{
    for (int i = 0; i < def->n_surfaces; i++) {
        const SurfaceDef *const d = &def->surfaces[i];
        if (d->shape.kind == SURFACE_DUCT && strcmp(d->name, name) == 0) return d;
    }
    return NULL;
}

/* Makes the flare at a duct's end: its throat stands where the duct ends and has the duct's bore (OB4). Behind the
 * throat the ring recedes from the bore, and the wall, which fades in there, takes over. */
static hawser_status bell_make(const CaseReader *r, const CaseNode *node, Obstacle *o)
{
    RollerDef *const d = &o->def;
    const SurfaceDef *const of = duct_named(r->def, o->name[OBSTACLE_BELL]);
    if (!of) {
        return case_value_error(r->err, case_node_key(node, "bell"), " is not the name of a duct in 'surfaces.ducts'");
    }
    const SurfaceShape *const s = &of->shape;
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
    /* the results list rollers and obstacles together, distinguished by their names */
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
