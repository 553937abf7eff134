#include "theory/supports.h"

#include <math.h>
#include <stdlib.h>

#include "core/error.h"
#include "theory/place.h"
#include "theory/search.h"

/* ------------------------------------------------------------------------------------------------------- rollers */

int roller_guides_at(const Route *route, const RollerDef *roller, double s)
{
    const Vec3 up = v3_cross(route_at(route, s).tangent, route_left(route, s));
    return fabs(v3_dot(roller->axis, up)) > SUPPORT_LEVEL;
}

int roller_is_guide(const Route *route, const RollerDef *roller)
{
    return !isnan(roller->s) && roller_guides_at(route, roller, roller->s);
}

static const double SIDE = 0.3; /* cosine */

int bend_side(Vec3 off, Vec3 curvature)
{
    const double along = v3_dot(off, curvature), least = SIDE * v3_norm(off) * v3_norm(curvature);
    return along > least ? 1 : along < -least ? -1 : 0;
}

/* Place of the route nearest to a roller that is listed by coordinates; NAN: the cable does not reach it there, or is
 * in a duct or tray. */
static double place_listed(const Supports *map, const RouteGrid *grid, const RollerDef *roller)
{
    const Nearest there = route_nearest(grid, roller->centre, 1);
    const int near = there.distance <= roller->radius + 2 * bundle_diameter(map->def);
    return near && !supports_surface(map, there.s) ? there.s : NAN;
}

static int compare_rollers(const void *a, const void *b)
{
    const SupportRoller *const x = a, *const y = b;
    return x->s != y->s ? (x->s > y->s) - (x->s < y->s) : x->item - y->item;
}

static hawser_status rollers_find(Supports *map, hawser_error *err)
{
    const SceneDef *const def = map->def;
    RouteGrid grid = {0};
    for (int r = 0; r < def->n_rollers; ++r) {
        const RollerDef *const roller = &def->rollers[r];
        const int row = !isnan(roller->s);
        if (!row && (roller->profile == SHAPE_BOX || roller->profile == SHAPE_BELL)) continue;
        if (!row && !grid.at && route_grid_build(map->route, 0, &grid, err)) return HAWSER_ERR_MEMORY;
        const double s = row ? roller->s : place_listed(map, &grid, roller);
        if (isnan(s)) continue;
        const RoutePoint at = route_at(map->route, s);
        const Vec3 off = v3_unit(v3_sub(roller->centre, at.position));
        const int upright = roller_guides_at(map->route, roller, s);
        const SupportKind kind = roller->hold_down ? SUPPORT_HOLD_DOWN : upright ? SUPPORT_GUIDE : SUPPORT_ROLLER;
        map->roller[map->n_rollers++] = (SupportRoller){.s = s,
                                                        .across = 2 * roller->radius,
                                                        .kind = kind,
                                                        .item = r,
                                                        .row = row,
                                                        .inner = bend_side(off, at.curvature),
                                                        .off = off};
    }
    route_grid_clear(&grid);
    qsort(map->roller, (size_t)map->n_rollers, sizeof *map->roller, compare_rollers);
    return HAWSER_OK;
}

int supports_from(const Supports *map, double s)
{
    return items_before(map->n_rollers, &map->roller->s, sizeof *map->roller, s, 0);
}

/* ------------------------------------------------------------------------------------------------------- lengths */

static int compare_lengths(const void *a, const void *b)
{
    const SupportLength *const x = a, *const y = b;
    if (x->from != y->from) return (x->from > y->from) - (x->from < y->from);
    return x->kind == SUPPORT_BELT && y->kind == SUPPORT_BELT ? x->item - y->item
                                                              : (x->kind == SUPPORT_BELT) - (y->kind == SUPPORT_BELT);
}

static int compare_along(const void *a, const void *b)
{
    const double x = (*(const SurfaceDef *const *)a)->shape.from, y = (*(const SurfaceDef *const *)b)->shape.from;
    return (x > y) - (x < y);
}

/* Builds the length of a surface along the route. Lateral support: a duct, a vertical side, or a flank without a limit
 * on its load. */
static SupportLength length_of(const SurfaceDef *surface, int item)
{
    const SurfaceShape *const shape = &surface->shape;
    const int duct = shape->kind == SURFACE_DUCT, sides = !(surface_flank(surface) < INFINITY);
    return (SupportLength){.from = shape->from,
                           .to = shape->to,
                           .kind = duct ? SUPPORT_DUCT : SUPPORT_TRAY,
                           .item = item,
                           .sides = sides,
                           .above = duct,
                           .half = duct                        ? shape->radius
                                   : sides && shape->width > 0 ? shape->width / 2
                                                               : INFINITY,
                           .friction = &surface->friction};
}

static void lengths_find(Supports *map)
{
    const SceneDef *const def = map->def;
    for (int k = 0; k < def->n_surfaces; ++k) {
        const SurfaceDef *const surface = &def->surfaces[k];
        if (!surface_along_route(surface)) {
            map->plane[map->n_planes++] = surface;
            continue;
        }
        map->along[map->n_along++] = surface;
        map->length[map->n_lengths++] = length_of(surface, k);
    }
    for (int i = 0; i < def->n_conveyors; ++i) {
        const ConveyorDef *const c = &def->conveyors[i];
        if (!c->hold) continue;
        map->length[map->n_lengths++] =
            (SupportLength){.from = c->from, .to = c->to, .kind = SUPPORT_BELT, .item = i, .sides = 1, .above = 1};
    }
    qsort(map->along, (size_t)map->n_along, sizeof *map->along, compare_along);
    qsort(map->length, (size_t)map->n_lengths, sizeof *map->length, compare_lengths);
    for (int k = 0; k < map->n_lengths; ++k)
        map->reach[k] = k > 0 ? fmax(map->reach[k - 1], map->length[k].to) : map->length[k].to;
}

int supports_along(const Supports *map, double s)
{
    int low = 0;
    for (int high = map->n_along; low < high;) {
        const int middle = low + (high - low) / 2;
        if (map->along[middle]->shape.from <= s) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

const SurfaceDef *supports_surface(const Supports *map, double s)
{
    const int k = supports_along(map, s);
    return k > 0 && s < map->along[k - 1]->shape.to ? map->along[k - 1] : NULL;
}

/* Number of lengths that begin at or before s. */
static int lengths_to(const Supports *map, double s)
{
    return items_before(map->n_lengths, &map->length->from, sizeof *map->length, s, 1);
}

double supports_covered(const Supports *map, double s)
{
    for (int n = lengths_to(map, s + 1e-6); n > 0 && map->reach[n - 1] > s; n = lengths_to(map, s + 1e-6))
        s = map->reach[n - 1];
    return s;
}

double supports_next(const Supports *map, double s)
{
    const int k = lengths_to(map, s);
    double next = map->route->length;
    if (k < map->n_lengths) next = fmin(next, map->length[k].from);
    for (int i = supports_from(map, s); i < map->n_rollers && map->roller[i].s < next; ++i) {
        const SupportRoller *const r = &map->roller[i];
        if (r->s > s && r->kind == SUPPORT_ROLLER && !(r->off.z > 0)) return r->s;
    }
    return next;
}

const SupportLength *supports_sides(const Supports *map, double s, int *next)
{
    while (*next < map->n_lengths && !(map->length[*next].sides && map->length[*next].to > s)) ++*next;
    if (*next == map->n_lengths || !(map->length[*next].from < map->route->length)) return NULL;
    return &map->length[*next];
}

/* -------------------------------------------------------------------------------------------------------- planes */

int plane_reaches(const SurfaceShape *plane, Vec3 at)
{
    const Vec3 off = v3_sub(at, plane->point), across = v3_cross(plane->normal, plane->along);
    if (plane->length > 0 && fabs(v3_dot(off, plane->along)) > plane->length / 2) return 0;
    return !(plane->width > 0 && fabs(v3_dot(off, across)) > plane->width / 2);
}

const SurfaceDef *supports_floor(const Supports *map, Vec3 at, double least, double most)
{
    for (int k = 0; k < map->n_planes; ++k) {
        const SurfaceShape *const floor = &map->plane[k]->shape;
        const double above = v3_dot(v3_sub(at, floor->point), floor->normal);
        if (floor->normal.z > SUPPORT_LEVEL && above > least && above < most && plane_reaches(floor, at))
            return map->plane[k];
    }
    return NULL;
}

/* --------------------------------------------------------------------------------------------------------- build */

hawser_status supports_build(const SceneDef *def, const Route *route, Supports *out, hawser_error *err)
{
    const size_t lengths = (size_t)(def->n_surfaces + def->n_conveyors + 1);
    *out = (Supports){.def = def, .route = route};
    out->roller = malloc(((size_t)def->n_rollers + 1) * sizeof *out->roller);
    out->length = malloc(lengths * sizeof *out->length);
    out->reach = malloc(lengths * sizeof *out->reach);
    out->along = malloc(lengths * sizeof *out->along);
    out->plane = malloc(lengths * sizeof *out->plane);
    if (!out->roller || !out->length || !out->reach || !out->along || !out->plane) return error_memory(err);
    lengths_find(out);
    return rollers_find(out, err);
}

void supports_free(Supports *map)
{
    free(map->roller);
    free(map->length);
    free(map->reach);
    free(map->along);
    free(map->plane);
    *map = (Supports){0};
}
