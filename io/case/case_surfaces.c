#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "io/case/case_parts.h"
#include "io/yaml/case_error.h"

/* How far a surface may press into the cable at the start before it counts as a mistake, and how densely planes are
 * looked at for it, m. */
static const double PRESS_MAX = 1e-3, LOOK_STEP = 0.05;
/* Of a stretch beyond the route's end, and of two stretches into each other: rounding, m. */
static const double SLACK = 1e-6;

/* The law for each metre of cable; what is not given is the rollers'. */
static hawser_status line_contact_read(const CaseReader *r, const CaseNode *node)
{
    ImpactLaw *const law = &r->def->line_impact;
    LineContactRecord record = {0};
    *law = r->def->impact;
    const hawser_status status = case_section_read(r, node, &case_line_contact, &record);
    if (status) return status;
    if (!isnan(record.e)) law->e = record.e;
    if (!isnan(record.c)) law->c = record.c;
    if (!isnan(record.d)) law->d = record.d;
    return record.k ? case_stiffness_read(r, record.k, law->e, &law->k) : HAWSER_OK;
}

/* An exponent of its own makes the rollers' stiffness a number of another kind. */
static hawser_status line_exponent_check(const CaseReader *r, const CaseNode *node)
{
    if (!node || r->def->line_impact.e == r->def->impact.e || case_node_key(node, "k")) return HAWSER_OK;
    return case_key_error(r->err, node, "k",
                          "missing: an exponent that is not the rollers', %g, needs its own stiffness",
                          r->def->impact.e);
}

/* The name that was given, or a letter and a number. */
static void surface_name(SurfaceDef *out, const char *given, const char *letter, const CaseNode *node)
{
    strcpy(out->name, given);
    if (!*out->name) snprintf(out->name, sizeof out->name, "%s%d", letter, node->index + 1);
}

/* Whether a stretch lies on the route, has room for its ends' fades and is free. */
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

/* Whether all bends of the stretch are wider than the surface is on the side of their centre. */
static hawser_status bends_check(const CaseReader *r, const CaseNode *node, const SurfaceShape *s, double extent,
                                 const char *key)
{
    for (int i = 0; i < r->route.n; i++) {
        const RoutePiece *const p = &r->route.piece[i];
        if (p->kind != ROUTE_BEND || p->s0 >= s->to || p->s0 + p->length <= s->from) continue;
        if (p->radius > extent) continue;
        return case_key_error(r->err, node, key,
                              "%g m is out of range: must be below the radius of the bend at %.10g m, %g m", extent,
                              p->s0, p->radius);
    }
    return HAWSER_OK;
}

/* Level sections need a level left: nearly upright stretches have none that is steady. */
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

/* What ducts and trays share: name, stretch, friction. */
static hawser_status stretch_read(const CaseReader *r, const CaseNode *node, const StretchRecord *record,
                                  const char *letter, SurfaceDef *out)
{
    SurfaceShape *const s = &out->shape;
    surface_name(out, record->name, letter, node);
    s->from = record->from;
    s->to = isnan(record->to) ? r->route.length : record->to;
    s->fade = record->fade;
    s->cable_radius = case_largest_diameter(r->def) / 2;
    const hawser_status status = case_friction_read(r, record->friction, &r->def->friction, &out->friction);
    return status ? status : stretch_check(r, node, out);
}

static hawser_status duct_read(const CaseReader *r, const CaseNode *node, SurfaceDef *out)
{
    DuctRecord record = {0};
    hawser_status status = case_section_read(r, node, &case_duct, &record);
    if (!status) status = stretch_read(r, node, &record.at, "D", out);
    if (status) return status;
    SurfaceShape *const s = &out->shape;
    s->kind = SURFACE_DUCT;
    s->radius = record.radius;
    if (s->radius <= s->cable_radius) {
        return case_key_error(r->err, node, "radius",
                              "%g m is too small: must be above the largest cable's radius, %g m", s->radius,
                              s->cable_radius);
    }
    if (record.place) s->lift = s->radius - s->cable_radius;
    status = bends_check(r, node, s, s->radius + s->lift, "radius");
    return status || !record.place ? status : slopes_check(r, node, s);
}

/* A key that trays of this section have, or have not. */
static hawser_status tray_key(const CaseReader *r, const CaseNode *node, const char *key, int allowed)
{
    const CaseNode *given = case_node_key(node, key);
    if (allowed || !given) return HAWSER_OK;
    return case_key_error(r->err, given, NULL, "not allowed for a tray of this section");
}

/* A flat tray: its width between the sides, or over all. */
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

/* Numbers that depend on the section. */
static void tray_fill(const TrayRecord *record, SurfaceShape *s)
{
    static const SurfaceKind kinds[] = {SURFACE_FLAT, SURFACE_V, SURFACE_U};
    const double heights[] = {0, 4 * s->cable_radius, record->radius};
    s->kind = kinds[record->section];
    s->radius = record->radius;
    s->width = isnan(record->width) ? 0.4 : record->width;
    s->angle = isnan(record->angle) ? 3.14159265358979323846 / 2 : record->angle;
    s->depth = isnan(record->depth) ? s->cable_radius : record->depth;
    s->height = isnan(record->height) ? heights[record->section] : record->height;
}

static hawser_status tray_read(const CaseReader *r, const CaseNode *node, SurfaceDef *out)
{
    TrayRecord record = {0};
    SurfaceShape *const s = &out->shape;
    hawser_status status = case_section_read(r, node, &case_tray, &record);
    if (!status) status = stretch_read(r, node, &record.at, "T", out);
    if (status) return status;
    tray_fill(&record, s);
    status = tray_key(r, node, "width", s->kind == SURFACE_FLAT);
    if (!status) status = tray_key(r, node, "angle", s->kind == SURFACE_V);
    if (!status) status = tray_key(r, node, "radius", s->kind == SURFACE_U);
    if (!status && s->kind == SURFACE_FLAT) status = flat_check(r, node, s);
    if (!status && s->kind == SURFACE_V) status = bends_check(r, node, s, s->height + s->cable_radius, "height");
    if (!status && s->kind == SURFACE_U) status = u_check(r, node, s);
    if (!status) status = slopes_check(r, node, s);
    if (!status && s->depth < s->cable_radius - PRESS_MAX) {
        status = case_key_error(r->err, node, "depth",
                                "%g m is too small: the cable begins on the route, %g m thick to its skin", s->depth,
                                s->cable_radius);
    }
    return status;
}

/* Whether the cable begins on the free side of a plane, wherever it lies over it. */
static hawser_status plane_check(const CaseReader *r, const CaseNode *node, const SurfaceDef *plane)
{
    const SceneDef *const def = r->def;
    SurfacePatch patch;
    if (def->rod.present) return HAWSER_OK; /* it lies on no route */
    surface_patches(&plane->shape, &r->route, 0, &patch);
    for (int p = 0; p < def->n_pieces; p++) {
        const double radius = def->cables[def->pieces[p].cable].diameter / 2;
        double from, to;
        case_piece_place(def, p, &from, &to);
        for (int k = 0; from + k * LOOK_STEP <= to; k++) {
            const double s = from + k * LOOK_STEP;
            const SurfaceProbe at = surface_probe(&patch, route_at(&r->route, s).position);
            if (!at.owned || at.share <= 0 || at.distance >= radius - PRESS_MAX) continue;
            if (at.distance <= -SURFACE_DEPTH_MAX) continue; /* it passes behind */
            return case_key_error(
                r->err, node, "point",
                "plane '%s' is inside the cable: %.4g m along the route it is %.4g m from the line, must "
                "be at least the cable's radius, %.4g m",
                plane->name, s, at.distance, radius);
        }
    }
    return HAWSER_OK;
}

/* Any direction will do for a plane without ends. */
static Vec3 along_of(Vec3 given, Vec3 normal)
{
    const Vec3 level = fabs(normal.z) < 0.9 ? v3(0, 0, 1) : v3(1, 0, 0);
    const Vec3 wanted = v3_norm(given) > 0 ? v3_unit(given) : v3_cross(level, normal);
    return v3_unit(v3_reject(wanted, normal));
}

static hawser_status plane_read(const CaseReader *r, const CaseNode *node, SurfaceDef *out)
{
    PlaneRecord record = {0};
    hawser_status status = case_section_read(r, node, &case_plane, &record);
    if (!status) status = case_friction_read(r, record.friction, &r->def->friction, &out->friction);
    if (status) return status;
    if (v3_norm(record.normal) < 1e-9) {
        return case_value_error(r->err, case_node_key(node, "normal"), ": expected a direction that is not zero");
    }
    const Vec3 normal = v3_unit(record.normal), along = along_of(record.along, normal);
    if (!(v3_norm(along) > 0.5)) {
        return case_value_error(r->err, case_node_key(node, "along"),
                                ": expected a direction that is not the normal's");
    }
    surface_name(out, record.name, "P", node);
    out->shape = (SurfaceShape){.kind = SURFACE_PLANE,
                                .fade = record.fade,
                                .cable_radius = case_largest_diameter(r->def) / 2,
                                .point = record.point,
                                .normal = normal,
                                .along = along,
                                .length = record.length,
                                .width = record.width};
    return plane_check(r, node, out);
}

/* Reads one list; `read` fills the next surface, which counts only when it is whole. */
static hawser_status list_read(const CaseReader *r, const CaseNode *list,
                               hawser_status (*read)(const CaseReader *, const CaseNode *, SurfaceDef *))
{
    SceneDef *const def = r->def;
    if (!list) return HAWSER_OK;
    if (list->count > CASE_SURFACES_MAX - def->n_surfaces) {
        return case_key_error(r->err, list, NULL, "too many surfaces: at most %d", CASE_SURFACES_MAX);
    }
    SurfaceDef *const all = realloc(def->surfaces, (size_t)(def->n_surfaces + list->count + 1) * sizeof *all);
    if (!all) return error_memory(r->err);
    def->surfaces = all;
    for (const CaseNode *node = list->first; node; node = node->next) {
        SurfaceDef *const next = &def->surfaces[def->n_surfaces];
        memset(next, 0, sizeof *next);
        const hawser_status status = read(r, node, next);
        if (status) return status;
        def->n_surfaces++;
    }
    return HAWSER_OK;
}

/* Ducts, then trays, then planes: that is the order of the results. */
hawser_status case_surfaces_read(const CaseReader *r, const CaseNode *node)
{
    SurfacesRecord record = {0};
    hawser_status status = case_section_read(r, node, &case_surfaces, &record);
    if (!status) status = line_contact_read(r, record.contact);
    if (!status) status = line_exponent_check(r, record.contact);
    if (!status) status = list_read(r, record.ducts, duct_read);
    if (!status) status = list_read(r, record.trays, tray_read);
    if (!status) status = list_read(r, record.planes, plane_read);
    return status;
}
