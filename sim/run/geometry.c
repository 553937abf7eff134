#include "sim/run/geometry.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "sim/equipment/reel.h"
#include "sim/equipment/rod.h"
#include "sim/equipment/winch.h"

/* Corners of a circle. */
enum { SKIN_SIDES = 16 };

static void skin_begin(Skin *m, SkinPart part, int item)
{
    m->now_part = part;
    m->now_item = item;
}

/* Makes room for more points and triangles; returns 0 without memory. */
static int room_make(Skin *m, int points, int triangles)
{
    if (m->n_points + points > m->room_points) {
        const int room = 2 * (m->n_points + points);
        double *const more = realloc(m->points, 3 * sizeof *more * (size_t)room);
        if (!more) return 0;
        m->points = more;
        m->room_points = room;
    }
    if (m->n_triangles + triangles > m->room_triangles) {
        const int room = 2 * (m->n_triangles + triangles);
        int **const array[3] = {&m->triangle, &m->part, &m->item};
        for (int k = 0; k < 3; ++k) {
            int *const more = realloc(*array[k], (k ? 1 : 3) * sizeof *more * (size_t)room);
            if (!more) return 0;
            *array[k] = more;
        }
        m->room_triangles = room;
    }
    return 1;
}

static void point_add(Skin *m, Vec3 p) { v3_put(m->points + 3 * m->n_points++, p); }

/* Triangles with two corners in one place are left out. */
static void triangle_add(Skin *m, int a, int b, int c)
{
    const int corner[3] = {a, b, c};
    for (int k = 0; k < 3; ++k) {
        const double *const p = m->points + 3 * corner[k], *const q = m->points + 3 * corner[(k + 1) % 3];
        if (p[0] == q[0] && p[1] == q[1] && p[2] == q[2]) return;
    }
    memcpy(m->triangle + 3 * m->n_triangles, corner, sizeof corner);
    m->part[m->n_triangles] = (int)m->now_part;
    m->item[m->n_triangles++] = m->now_item;
}

/* Adds triangles over the last n rows of `count` points. */
static void rows_join(Skin *m, int n, int count, int closed)
{
    const int first = m->n_points - n * count;
    for (int i = 0; i + 1 < n; ++i) {
        for (int k = 0; k < count - !closed; ++k) {
            const int next = (k + 1) % count, a = first + i * count, b = a + count;
            triangle_add(m, a + k, a + next, b + k);
            triangle_add(m, b + k, a + next, b + next);
        }
    }
}

static void skin_sweep(Skin *m, int n, const SkinPlace *place, int count, const double (*section)[2], int closed)
{
    m->failed = m->failed || !room_make(m, n * count, 2 * n * count);
    if (m->failed) return;
    for (int i = 0; i < n; ++i) {
        const SkinPlace *const at = &place[i];
        for (int k = 0; k < count; ++k) {
            const Vec3 aside = v3_axpy(at->middle, at->scale * section[k][0], at->y);
            point_add(m, v3_axpy(aside, at->scale * section[k][1], at->z));
        }
    }
    rows_join(m, n, count, closed);
}

/* A solid of revolution: n points of (m along the axis from the centre, m from it). */
static void skin_turn(Skin *m, Vec3 centre, Vec3 axis, int n, const double (*profile)[2])
{
    enum { PROFILE_MAX = 32 };
    SkinPlace place[PROFILE_MAX];
    double circle[SKIN_SIDES][2];
    const Vec3 other = fabs(axis.z) < 0.9 ? v3(0, 0, 1) : v3(1, 0, 0);
    const Vec3 y = v3_unit(v3_cross(other, axis)), z = v3_cross(axis, y);
    for (int k = 0; k < SKIN_SIDES; ++k) {
        circle[k][0] = cos(2 * M_PI * k / SKIN_SIDES);
        circle[k][1] = sin(2 * M_PI * k / SKIN_SIDES);
    }
    for (int i = 0; i < n && i < PROFILE_MAX; ++i)
        place[i] = (SkinPlace){v3_axpy(centre, profile[i][0], axis), y, z, profile[i][1]};
    skin_sweep(m, n < PROFILE_MAX ? n : PROFILE_MAX, place, SKIN_SIDES, circle, 1);
}

/* A box with three half sizes, m, along three unit vectors. */
static void skin_box(Skin *m, Vec3 centre, const Vec3 axis[3], const double half[3])
{
    const double section[4][2] = {{-half[1], -half[2]}, {half[1], -half[2]}, {half[1], half[2]}, {-half[1], half[2]}};
    const Vec3 from = v3_axpy(centre, -half[0], axis[0]), to = v3_axpy(centre, half[0], axis[0]);
    /* a lid is a section of size 0 */
    const SkinPlace place[4] = {
        {from, axis[1], axis[2], 0}, {from, axis[1], axis[2], 1}, {to, axis[1], axis[2], 1}, {to, axis[1], axis[2], 0}};
    skin_sweep(m, 4, place, 4, section, 1);
}

static void skin_free(Skin *m)
{
    free(m->points);
    free(m->triangle);
    free(m->part);
    free(m->item);
    *m = (Skin){0};
}

/* Visible bodies: rollers with their grooves, ducts and trays without thickness, belts and the drum as simple
 * bodies. */

/* Corners of a whole circle; points of a half groove's arc. */
enum { TUBE_SIDES = 16, ARC_POINTS = 3 };

/* Half of a groove's profile from the middle out, (along the axis, radius): (GR1). Returns the number of points. */
static int groove_half(const RollerDef *r, double (*profile)[2])
{
    const Groove *const g = &r->groove;
    int n = 0;
    profile[n][0] = 0;
    profile[n++][1] = r->radius;
    for (int k = 1; k < ARC_POINTS && r->profile == SHAPE_U_GROOVE; ++k) {
        const double x = g->radius * g->sine * k / ARC_POINTS;
        profile[n][0] = x;
        profile[n++][1] = r->radius + g->radius - sqrt(g->radius * g->radius - x * x);
    }
    profile[n][0] = g->lip;
    profile[n++][1] = r->radius + g->depth;
    return n;
}

/* A roller from end to end, with its lids. */
static void roller_skin(Skin *m, const RollerDef *r)
{
    enum { HALF_MAX = ARC_POINTS + 4 };
    double half[HALF_MAX][2], profile[2 * HALF_MAX][2];
    const int grooved = r->profile == SHAPE_V_GROOVE || r->profile == SHAPE_U_GROOVE;
    int n = grooved ? groove_half(r, half) : 0;
    half[n][0] = half[n + 1][0] = r->width / 2;
    half[n][1] = r->radius + (grooved ? r->groove.depth : 0);
    half[n + 1][1] = 0;
    n += 2;
    /* the other half, which shares the middle point */
    int count = 0;
    for (int k = n - 1; k >= grooved; --k, ++count) {
        profile[count][0] = -half[k][0];
        profile[count][1] = half[k][1];
    }
    for (int k = 0; k < n; ++k, ++count) {
        profile[count][0] = half[k][0];
        profile[count][1] = half[k][1];
    }
    skin_turn(m, r->centre, r->axis, count, (const double(*)[2])profile);
}

/* The inner half of a ring of round section (OB4). */
static void bell_skin(Skin *m, const RollerDef *r)
{
    enum { POINTS = 9 };
    double profile[POINTS][2];
    for (int k = 0; k < POINTS; ++k) {
        const double angle = M_PI * ((double)k / (POINTS - 1) - 0.5);
        profile[k][0] = r->radius * sin(angle);
        profile[k][1] = r->bell.ring - r->radius * cos(angle);
    }
    skin_turn(m, r->centre, r->axis, POINTS, (const double(*)[2])profile);
}

static void box_skin(Skin *m, const RollerDef *r)
{
    const Vec3 axis[3] = {r->axis, r->box.side, v3_cross(r->axis, r->box.side)};
    skin_box(m, r->centre, axis, (const double[3]){r->width / 2, r->box.half[0], r->box.half[1]});
}

static void rollers_skin(Skin *m, const SceneDef *def)
{
    for (int i = 0; i < def->n_rollers; ++i) {
        const RollerDef *const r = &def->rollers[i];
        skin_begin(m, SKIN_ROLLER, i);
        if (r->profile == SHAPE_BOX) {
            box_skin(m, r);
        } else if (r->profile == SHAPE_BELL) {
            bell_skin(m, r);
        } else {
            roller_skin(m, r);
        }
    }
}

/* An arc of the section about (0, middle), its points ordered through the bottom to the left; whole: a circle. */
static int arc_section(double radius, double middle, int whole, double (*section)[2])
{
    const int n = whole ? TUBE_SIDES : TUBE_SIDES / 2 + 1;
    for (int k = 0; k < n; ++k) {
        const double angle = M_PI + 2 * M_PI * k / TUBE_SIDES;
        section[k][0] = radius * cos(angle);
        section[k][1] = middle + radius * sin(angle);
    }
    return n;
}

/* Section of a surface about the middle of its bottom (of a duct: of its bore). Returns the number of points. */
static int section_of(const GeometrySurface *s, double (*section)[2])
{
    const double half = s->width / 2, high = s->height > 0 ? s->height : 0;
    if (s->section[0] == 'd') return arc_section(s->diameter / 2, 0, 1, section);
    if (s->section[0] == 'u') { /* its sides may be extended upright, or end lower */
        const int n = arc_section(half, half, 0, section + 1);
        section[0][0] = -half;
        section[n + 1][0] = half;
        section[0][1] = section[n + 1][1] = fmax(high, half);
        return n + 2;
    }
    const double flat[4][2] = {{-half, high}, {-half, 0}, {half, 0}, {half, high}},
                 v[3][2] = {{-half, high}, {0, 0}, {half, high}};
    const int sides = s->section[0] == 'f' && high > 0, n = s->section[0] == 'v' ? 3 : sides ? 4 : 2;
    for (int k = 0; k < n; ++k) {
        const double *const from = n == 3 ? v[k] : flat[sides ? k : k + 1];
        section[k][0] = from[0];
        section[k][1] = from[1];
    }
    return n;
}

/* Sweeps a surface's section along its line; aside is normal to the line and to its upward direction. */
static void surface_skin(Skin *m, const GeometrySurface *s)
{
    double section[TUBE_SIDES + 4][2];
    const int count = section_of(s, section), closed = s->section[0] == 'd';
    SkinPlace *const place = malloc(sizeof *place * (size_t)s->n);
    if (!place) m->failed = 1;
    for (int i = 0; i < s->n && place; ++i) {
        const int before = i > 0 ? i - 1 : 0, after = i + 1 < s->n ? i + 1 : i;
        const Vec3 way = v3_sub(v3_get(s->points + 3 * after), v3_get(s->points + 3 * before));
        const Vec3 up = v3_get(s->up + 3 * i);
        place[i] = (SkinPlace){v3_get(s->points + 3 * i), v3_unit(v3_cross(up, way)), up, 1};
    }
    if (place) skin_sweep(m, s->n, place, count, (const double(*)[2])section, closed);
    free(place);
}

/* Two belts, each one diameter of the thickest cable high and three wide. */
static void conveyor_skin(Skin *m, const double points[6], double diameter)
{
    const Vec3 from = v3_get(points), to = v3_get(points + 3), way = v3_sub(to, from), along = v3_unit(way);
    const Vec3 other = fabs(along.z) < 0.9 ? v3(0, 0, 1) : v3(1, 0, 0);
    const Vec3 side = v3_unit(v3_cross(other, along)), up = v3_cross(along, side);
    const Vec3 middle = v3_axpy(from, 0.5, way), axis[3] = {along, side, up};
    const double half[3] = {v3_norm(way) / 2, 1.5 * diameter, diameter / 2};
    for (int k = -1; k <= 1; k += 2) skin_box(m, v3_axpy(middle, k * diameter, up), axis, half);
}

static void reel_skin(Skin *m, const GeometryReel *r)
{
    const double profile[6][2] = {{-r->width / 2, 0},        {-r->width / 2, r->flange}, {-r->width / 2, r->barrel},
                                  {r->width / 2, r->barrel}, {r->width / 2, r->flange},  {r->width / 2, 0}};
    skin_turn(m, v3_get(r->centre), v3_get(r->axis), 6, profile);
}

/* Adds the triangles of all geometry found; skin.failed reports lack of memory. */
static void geometry_skin(Geometry *g, const Scene *scene)
{
    Skin *const m = &g->skin;
    double thickest = 0;
    for (int i = 0; i < g->n_segments; ++i) thickest = fmax(thickest, g->diameter[i]);
    rollers_skin(m, &scene->def);
    for (int i = 0; i < g->n_surfaces; ++i) {
        skin_begin(m, SKIN_SURFACE, i);
        surface_skin(m, &g->surface[i]);
    }
    for (int i = 0; i < g->n_conveyors; ++i) {
        skin_begin(m, SKIN_CONVEYOR, i);
        conveyor_skin(m, g->conveyor_points + 6 * i, thickest);
    }
    skin_begin(m, SKIN_REEL, 0);
    if (g->reel.present) reel_skin(m, &g->reel);
}

/* Largest distance of points on a straight, m. */
static const double STRIDE = 5;

/* Returns n zeroed items that the geometry owns; NULL without memory. */
static void *array_new(Geometry *g, int n, size_t size)
{
    void **const owned = realloc(g->owned, ((size_t)g->n_owned + 1) * sizeof *owned);
    if (!owned) return NULL;
    g->owned = owned;
    owned[g->n_owned] = calloc((size_t)n + 1, size);
    return owned[g->n_owned++];
}

static double *numbers_new(Geometry *g, int n) { return array_new(g, n, sizeof(double)); }

static GeometryText *texts_new(Geometry *g, int n) { return array_new(g, n, sizeof(GeometryText)); }

static void say(GeometryText out, const char *text) { snprintf(out, sizeof(GeometryText), "%.63s", text); }

/* ------------------------------------------------------------------------------------------------------ the route */

/* Points of a stretch of the route, evenly on each of its pieces: a chord of length h is off a bend of radius R by
 * h^2/(8 R). `scale` makes all chords longer. Returns their number; s may be NULL. */
static int places_find(const Route *route, double from, double to, double scale, double *s)
{
    int n = 0;
    for (int p = 0; p < route->n; ++p) {
        const RoutePiece *const piece = &route->piece[p];
        const double first = p == 0 ? from : fmax(from, piece->s0);
        const double last = p == route->n - 1 ? to : fmin(to, piece->s0 + piece->length);
        if (!(last > first)) continue;
        const double bent = piece->radius > 0 ? sqrt(8 * GEOMETRY_SAGITTA * piece->radius) : STRIDE;
        const int steps = (int)fmin(ceil((last - first) / (scale * fmin(bent, STRIDE))), GEOMETRY_POINTS_MAX);
        for (int k = 0; k < steps; ++k, ++n)
            if (s) s[n] = first + (last - first) * k / steps;
    }
    if (s) s[n] = to;
    return n + 1;
}

/* Number of points, at most GEOMETRY_POINTS_MAX unless there are more pieces. *scale: the factor that this needs. */
static int places_count(const Route *route, double from, double to, double *scale)
{
    int n = 0;
    for (*scale = 1; *scale < 1e6; *scale *= 2) {
        n = places_find(route, from, to, *scale, NULL);
        if (n <= GEOMETRY_POINTS_MAX) break;
    }
    return n;
}

static int route_fill(Geometry *g, const Route *route)
{
    double scale;
    g->n_route = places_count(route, 0, route->length, &scale);
    g->route_s = numbers_new(g, g->n_route);
    g->route_position = numbers_new(g, 3 * g->n_route);
    g->route_curvature = numbers_new(g, g->n_route);
    if (!g->route_s || !g->route_position || !g->route_curvature) return 0;
    places_find(route, 0, route->length, scale, g->route_s);
    for (int i = 0; i < g->n_route; ++i) {
        const RoutePoint at = route_at(route, g->route_s[i]);
        v3_put(g->route_position + 3 * i, at.position);
        g->route_curvature[i] = v3_norm(at.curvature);
    }
    return 1;
}

/* ----------------------------------------------------------------------------------------- rollers and obstacles */

static int is_obstacle(const RollerDef *r) { return r->profile == SHAPE_BOX || r->profile == SHAPE_BELL; }

static int rollers_fill(Geometry *g, const SceneDef *def)
{
    const int n = g->n_rollers = def->n_rollers;
    g->roller_name = texts_new(g, n);
    g->roller_kind = texts_new(g, n);
    double **const number[] = {&g->roller_s, &g->roller_radius, &g->roller_width, &g->roller_groove, &g->roller_rating};
    for (size_t k = 0; k < sizeof number / sizeof *number; ++k)
        if (!(*number[k] = numbers_new(g, n))) return 0;
    g->roller_position = numbers_new(g, 3 * n);
    g->roller_axis = numbers_new(g, 3 * n);
    if (!g->roller_name || !g->roller_kind || !g->roller_position || !g->roller_axis) return 0;
    for (int i = 0; i < n; ++i) {
        const RollerDef *const r = &def->rollers[i];
        const int grooved = r->profile == SHAPE_V_GROOVE || r->profile == SHAPE_U_GROOVE;
        say(g->roller_name[i], r->name);
        say(g->roller_kind[i], r->profile == SHAPE_BOX    ? "box"
                               : r->profile == SHAPE_BELL ? "bell-mouth"
                               : r->hold_down             ? "hold-down"
                                                          : "roller");
        g->roller_s[i] = r->s;
        g->roller_radius[i] = r->radius;
        g->roller_width[i] = r->width;
        g->roller_groove[i] = grooved ? r->groove.depth : 0;
        g->roller_rating[i] = r->rating > 0 ? r->rating : NAN;
        v3_put(g->roller_position + 3 * i, r->centre);
        v3_put(g->roller_axis + 3 * i, r->axis);
    }
    return 1;
}

static int obstacles_fill(Geometry *g, const SceneDef *def)
{
    for (int i = 0; i < def->n_rollers; ++i) g->n_obstacles += is_obstacle(&def->rollers[i]);
    const int n = g->n_obstacles;
    g->obstacle_roller = array_new(g, n, sizeof(int));
    g->obstacle_side = numbers_new(g, 3 * n);
    g->obstacle_size = numbers_new(g, 3 * n);
    g->obstacle_edge = numbers_new(g, n);
    g->obstacle_ring = numbers_new(g, n);
    if (!g->obstacle_roller || !g->obstacle_side || !g->obstacle_size || !g->obstacle_edge || !g->obstacle_ring)
        return 0;
    for (int i = 0, k = 0; i < def->n_rollers; ++i) {
        const RollerDef *const r = &def->rollers[i];
        if (!is_obstacle(r)) continue;
        const int box = r->profile == SHAPE_BOX;
        const Vec3 other = fabs(r->axis.z) < 0.9 ? v3(0, 0, 1) : v3(1, 0, 0);
        const double across = box ? 0 : 2 * (r->bell.ring + r->radius);
        g->obstacle_roller[k] = i;
        v3_put(g->obstacle_side + 3 * k, box ? r->box.side : v3_unit(v3_cross(other, r->axis)));
        v3_put(g->obstacle_size + 3 * k,
               box ? v3(r->width, 2 * r->box.half[0], 2 * r->box.half[1]) : v3(r->width, across, across));
        g->obstacle_edge[k] = box ? r->box.edge : r->radius;
        g->obstacle_ring[k++] = box ? NAN : r->bell.ring;
    }
    return 1;
}

/* ----------------------------------------------------------------------------------------------------- surfaces */

/* An infinite plane is shown as far as the route is beside it, and this much farther, m. */
static const double MARGIN = 2;

/* Half the length that is shown of a plane along a unit vector; moves the middle to it. */
static double plane_half(const Geometry *g, Vec3 along, double length, Vec3 *middle)
{
    if (length > 0) return length / 2;
    double low = 0, high = 0;
    for (int i = 0; i < g->n_route; ++i) {
        const double x = v3_dot(v3_sub(v3_get(g->route_position + 3 * i), *middle), along);
        low = fmin(low, x);
        high = fmax(high, x);
    }
    *middle = v3_axpy(*middle, (low + high) / 2, along);
    return (high - low) / 2 + MARGIN;
}

static int plane_fill(Geometry *g, const SurfaceShape *d, GeometrySurface *out)
{
    Vec3 middle = d->point;
    const double half = plane_half(g, d->along, d->length, &middle);
    const double half_width = plane_half(g, v3_cross(d->normal, d->along), d->width, &middle);
    say(out->kind, d->normal.z > 0.5 ? "floor" : d->normal.z < -0.5 ? "ceiling" : "wall");
    out->endless = !(d->length > 0 && d->width > 0);
    out->width = 2 * half_width;
    out->n = 2;
    out->points = numbers_new(g, 6);
    out->up = numbers_new(g, 6);
    if (!out->points || !out->up) return 0;
    for (int k = 0; k < 2; ++k) {
        v3_put(out->points + 3 * k, v3_axpy(middle, k ? half : -half, d->along));
        v3_put(out->up + 3 * k, d->normal);
    }
    return 1;
}

/* Height of the middle of the bottom above the route's line, m; for a V, where its planes meet (faces_v). */
static double bottom_of(const SurfaceShape *d)
{
    const double half = sin(d->angle / 2);
    if (d->kind == SURFACE_DUCT) return d->lift;
    return d->kind == SURFACE_V ? d->cable_radius * (1 - 1 / half) - d->depth : -d->depth;
}

static int swept_fill(Geometry *g, const Route *route, const SurfaceDef *def, GeometrySurface *out)
{
    const SurfaceShape *const d = &def->shape;
    const double bottom = bottom_of(d);
    double scale;
    out->from = d->from;
    out->to = d->to;
    say(out->kind, d->kind == SURFACE_DUCT ? "duct" : "tray");
    if (d->kind == SURFACE_DUCT || d->kind == SURFACE_U) out->diameter = 2 * (def->bore > 0 ? def->bore : d->radius);
    if (d->kind == SURFACE_FLAT) out->width = d->width;
    if (d->kind == SURFACE_V) out->width = 2 * tan(d->angle / 2) * (d->height - d->depth - bottom);
    if (d->kind == SURFACE_U) out->width = 2 * d->radius;
    if (d->kind != SURFACE_DUCT) out->height = d->height - d->depth - bottom;
    out->n = places_count(route, d->from, d->to, &scale);
    double *const s = malloc(sizeof *s * (size_t)out->n);
    out->points = numbers_new(g, 3 * out->n);
    out->up = numbers_new(g, 3 * out->n);
    const int room = s && out->points && out->up;
    if (room) places_find(route, d->from, d->to, scale, s);
    for (int i = 0; i < out->n && room; ++i) {
        const RoutePoint at = route_at(route, s[i]);
        const Vec3 up = v3_cross(at.tangent, route_left(route, s[i]));
        v3_put(out->points + 3 * i, v3_axpy(at.position, bottom, up));
        v3_put(out->up + 3 * i, up);
    }
    free(s);
    return room;
}

static int surfaces_fill(Geometry *g, const Scene *scene)
{
    static const char *const sections[] = {"duct", "flat", "v", "u", "plane"};
    const SceneDef *const def = &scene->def;
    g->n_surfaces = def->n_surfaces;
    g->surface = array_new(g, def->n_surfaces, sizeof *g->surface);
    if (!g->surface) return 0;
    for (int i = 0; i < def->n_surfaces; ++i) {
        const SurfaceDef *const d = &def->surfaces[i];
        GeometrySurface *const out = &g->surface[i];
        *out = (GeometrySurface){.from = NAN, .to = NAN, .diameter = NAN, .width = NAN, .height = NAN};
        say(out->name, d->name);
        say(out->section, sections[d->shape.kind]);
        if (!(surface_along_route(d) ? swept_fill(g, &scene->route, d, out) : plane_fill(g, &d->shape, out))) return 0;
        for (int c = 0; c < 3; ++c) out->normal[c] = out->up[c];
    }
    return 1;
}

/* ------------------------------------------------------------------------------------------------------ machines */

static int conveyors_fill(Geometry *g, const Scene *scene)
{
    const int n = g->n_conveyors = scene->def.n_conveyors;
    g->conveyor_name = texts_new(g, n);
    g->conveyor_from = numbers_new(g, n);
    g->conveyor_to = numbers_new(g, n);
    g->conveyor_points = numbers_new(g, 6 * n);
    if (!g->conveyor_name || !g->conveyor_from || !g->conveyor_to || !g->conveyor_points) return 0;
    for (int i = 0; i < n; ++i) {
        const ConveyorDef *const c = &scene->def.conveyors[i];
        say(g->conveyor_name[i], c->name);
        g->conveyor_from[i] = c->from;
        g->conveyor_to[i] = c->to;
        v3_put(g->conveyor_points + 6 * i, route_at(&scene->route, c->from).position);
        v3_put(g->conveyor_points + 6 * i + 3, route_at(&scene->route, c->to).position);
    }
    return 1;
}

/* A drum below the line (as in absent_take), or one with contacts. */
static void reel_fill(GeometryReel *out, const Scene *scene)
{
    const Reel *const r = scene->reel;
    if (scene->drum->present) {
        const RollerDef *const barrel = &scene->def.rollers[scene->drum->roller];
        *out =
            (GeometryReel){1, .barrel = barrel->radius, .flange = scene->def.drum.flange / 2, .width = barrel->width};
        v3_put(out->centre, barrel->centre);
        v3_put(out->axis, barrel->axis);
    }
    if (!r->present) return;
    const WindingPoint leaving = winding_point(&r->winding, r->wound);
    const Vec3 left = quat_rotate(r->attitude, v3(0, 1, 0)), up = quat_rotate(r->attitude, v3(0, 0, 1));
    *out = (GeometryReel){1, .barrel = r->winding.barrel, .flange = scene->def.reel.flange / 2,
                          .width = scene->def.reel.width};
    v3_put(out->centre, v3_axpy(v3_axpy(r->drum, -leaving.radius, up), -leaving.across, left));
    v3_put(out->axis, left);
}

static void winch_fill(GeometryWinch *out, const Scene *scene)
{
    const Winch *const w = scene->winch;
    out->present = w->present;
    if (!w->present) return;
    v3_put(out->position, route_at(&scene->route, winch_place(scene)).position);
    v3_put(out->direction, w->direction);
}

/* ----------------------------------------------------------------------------------------------------- the chain */

double geometry_length(const Scene *scene, int segment)
{
    const int i = segment - scene->first;
    const ChainPieceDef *const piece = &scene->def.pieces[scene->piece[segment]];
    return i >= 0 && i < scene->chain.n ? 2 * scene->chain.half[i] : piece->length / piece->segments;
}

static int chain_fill(Geometry *g, const Scene *scene)
{
    const SceneDef *const def = &scene->def;
    const int n = g->n_segments = scene->total;
    g->n_pieces = def->n_pieces;
    g->length = numbers_new(g, n);
    g->diameter = numbers_new(g, n);
    g->part = array_new(g, n, sizeof(int));
    g->piece = array_new(g, n, sizeof(int));
    g->piece_name = texts_new(g, def->n_pieces);
    if (!g->length || !g->diameter || !g->part || !g->piece || !g->piece_name) return 0;
    for (int i = 0; i < n; ++i) {
        g->length[i] = geometry_length(scene, i);
        g->piece[i] = scene->piece[i];
        g->diameter[i] = def->cables[def->pieces[scene->piece[i]].cable].diameter;
        g->part[i] = i >= scene->eye;
    }
    for (int p = 0; p < def->n_pieces; ++p) say(g->piece_name[p], def->cables[def->pieces[p].cable].name);
    return 1;
}

hawser_status geometry_make(const Scene *scene, Geometry *out, hawser_error *err)
{
    *out = (Geometry){0};
    int ok = scene->rod->present || route_fill(out, &scene->route);
    ok = ok && rollers_fill(out, &scene->def) && obstacles_fill(out, &scene->def) && surfaces_fill(out, scene) &&
         conveyors_fill(out, scene) && chain_fill(out, scene);
    if (ok) {
        reel_fill(&out->reel, scene);
        winch_fill(&out->winch, scene);
        geometry_skin(out, scene);
    }
    if (ok && !out->skin.failed) return HAWSER_OK;
    geometry_free(out);
    return error_memory(err);
}

void geometry_free(Geometry *g)
{
    for (int i = 0; i < g->n_owned; ++i) free(g->owned[i]);
    free(g->owned);
    skin_free(&g->skin);
    mesh_free(&g->seen.mesh);
    free(g->seen.layer_name);
    *g = (Geometry){0};
}
