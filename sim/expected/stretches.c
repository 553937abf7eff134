#include "sim/expected/stretches.h"

#include <math.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "theory/place/place.h"

/* Where the first stretch begins, m along the route: behind any lead-in. */
static const double FAR_BEHIND = -1e9;

/* A length of route whose guide rollers hold the cable sideways. */
typedef struct Guided {
    double from, to; /* m; none if from >= to */
} Guided;

int roller_guides_at(const Route *route, const RollerDef *roller, double s)
{
    const Vec3 up = v3_cross(route_at(route, s).tangent, route_left(route, s));
    return fabs(v3_dot(roller->axis, up)) > 0.7;
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

const SurfaceDef *surface_at(const SceneDef *def, double s)
{
    for (int i = 0; i < def->n_surfaces; ++i) {
        const SurfaceDef *const d = &def->surfaces[i];
        if (surface_along_route(d) && s >= d->shape.from && s < d->shape.to) return d;
    }
    return NULL;
}

/* Where the route is nearest to a roller that is listed by coordinates; NAN: the cable does not reach it there, or a
 * duct or tray has it. */
static double place_listed(const SceneDef *def, const RouteGrid *grid, const RollerDef *roller)
{
    const Nearest there = route_nearest(grid, roller->centre, 1);
    const int near = there.distance <= roller->radius + 2 * bundle_diameter(def);
    return near && !surface_at(def, there.s) ? there.s : NAN;
}

static int compare_turners(const void *a, const void *b)
{
    const double x = ((const Turner *)a)->s, y = ((const Turner *)b)->s;
    return (x > y) - (x < y);
}

hawser_status turners_find(const Scene *scene, const Route *route, int *n, Turner **found, hawser_error *err)
{
    const SceneDef *const def = &scene->def;
    Turner *const out = *found = malloc(((size_t)def->n_rollers + 1) * sizeof *out);
    RouteGrid grid = {0};
    *n = 0;
    if (!out) return error_memory(err);
    for (int r = 0; r < def->n_rollers; ++r) {
        const RollerDef *const roller = &def->rollers[r];
        const int listed = isnan(roller->s);
        if (listed && (roller->profile == SHAPE_BOX || roller->profile == SHAPE_BELL)) continue;
        if (listed && !grid.at && route_grid_build(route, 0, &grid, err)) return HAWSER_ERR_MEMORY;
        const double s = listed ? place_listed(def, &grid, roller) : roller->s;
        if (isnan(s)) continue;
        const RoutePoint at = route_at(route, s);
        const Vec3 off = v3_unit(v3_sub(roller->centre, at.position));
        const int carries = !roller->hold_down && !roller_guides_at(route, roller, s);
        out[(*n)++] = (Turner){s, 2 * roller->radius, bend_side(off, at.curvature), carries, r, off};
    }
    route_grid_clear(&grid);
    qsort(out, (size_t)*n, sizeof *out, compare_turners);
    return HAWSER_OK;
}

/* Every place at which something changes, and the guided parts. */
typedef struct Corners {
    int n;
    double *s;      /* [n] m */
    Guided *guided; /* [pieces] of each bend, by its first piece */
    int n_turners;
    Turner *turner; /* [n_turners] by rising place */
} Corners;

/* The part of a bend, of pieces p to `to`, along which guides stand: from the first to the last and half their spacing
 * beyond. One that comes within its own half spacing of the bend's end reaches it. */
static Guided guided_part(const Scene *scene, const Corners *c, int p, int to)
{
    const double begin = scene->route.piece[p].s0, end = scene->route.piece[to].s0 + scene->route.piece[to].length;
    double first = INFINITY, last = -INFINITY;
    int n = 0;
    for (int i = 0; i < c->n_turners; ++i) {
        const double s = c->turner[i].s;
        const RollerDef *const r = &scene->def.rollers[c->turner[i].roller];
        if (!(s >= begin && s <= end) || c->turner[i].inner < 0 || !roller_guides_at(&scene->route, r, s)) continue;
        if (s > last) ++n; /* a pair counts once */
        first = fmin(first, s);
        last = fmax(last, s);
    }
    if (n == 0) return (Guided){0};
    const double half = n > 1 ? (last - first) / (n - 1) / 2 : end - begin;
    return (Guided){first - begin > 1.01 * half ? first - half : begin, end - last > 1.01 * half ? last + half : end};
}

static void corners_free(Corners *c)
{
    free(c->s);
    free(c->guided);
    free(c->turner);
}

static int compare_places(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static hawser_status corners_find(const Scene *scene, Corners *c, hawser_error *err)
{
    const SceneDef *const def = &scene->def;
    const int pieces = scene->route.n;
    c->s = malloc((size_t)(2 * def->n_surfaces + 3 * pieces + 1) * sizeof *c->s);
    c->guided = calloc((size_t)pieces, sizeof *c->guided);
    if (!c->s || !c->guided) return error_memory(err);
    const hawser_status status = turners_find(scene, &scene->route, &c->n_turners, &c->turner, err);
    if (status) return status;
    c->s[c->n++] = FAR_BEHIND;
    for (int i = 0; i < def->n_surfaces; ++i) {
        if (!surface_along_route(&def->surfaces[i])) continue;
        c->s[c->n++] = def->surfaces[i].shape.from;
        c->s[c->n++] = def->surfaces[i].shape.to;
    }
    const int by_piece = bundle_present(&def->bundle) && def->bundle.correction == CORRECT_STRAIGHTS;
    for (int p = 0; p < pieces && by_piece; ++p) c->s[c->n++] = scene->route.piece[p].s0;
    for (int p = 0, to; p < pieces; p = to + 1) {
        to = route_turn_end(&scene->route, p);
        if (!route_turns_aside(&scene->route.piece[p])) continue;
        c->guided[p] = guided_part(scene, c, p, to);
        if (!(c->guided[p].from < c->guided[p].to)) continue;
        c->s[c->n++] = c->guided[p].from;
        c->s[c->n++] = c->guided[p].to;
    }
    qsort(c->s, (size_t)c->n, sizeof *c->s, compare_places);
    return HAWSER_OK;
}

/* Whether the supports at s are separate: guides, or a floor with upright sides. */
static int is_separate(const Scene *scene, const Corners *c, const SurfaceDef *surface, double s)
{
    for (int p = 0; p < scene->route.n; ++p) {
        if (s >= c->guided[p].from && s < c->guided[p].to) return 1;
    }
    return surface && surface->shape.kind == SURFACE_FLAT && surface->shape.height > 0;
}

/* The stretch that begins at c->s[i]. Friction is the surface's where there is one; of several cables one bears more
 * than the others. */
static PullStretch stretch_make(const Scene *scene, const Corners *c, int i)
{
    const double middle = i + 1 < c->n ? (c->s[i] + c->s[i + 1]) / 2 : c->s[i] + 1;
    const SurfaceDef *const surface = surface_at(&scene->def, middle);
    const FrictionLaw *const law = surface ? &surface->friction : &scene->def.friction;
    const int in_bend = scene->route.piece[route_at(&scene->route, middle).piece].kind != ROUTE_STRAIGHT;
    const double mu = surface ? surface_theory_friction(&scene->def, surface, in_bend) : law->mu_d;
    const double mu_rope = surface ? mu / bundle_friction(&scene->def, surface, in_bend) : mu;
    const double at_rest = law->mu_d > 0 ? law->mu_s / law->mu_d : NAN;
    return (PullStretch){.from = c->s[i],
                         .weight = scene->cable_weight,
                         .mu = mu,
                         .mu_rope = mu_rope,
                         .mu_rope_static = law->mu_d > 0 ? mu_rope * at_rest : law->mu_s,
                         .mu_static = law->mu_d > 0 ? mu * at_rest : law->mu_s,
                         .separate = is_separate(scene, c, surface, middle),
                         .share = bundle_share(&scene->def, surface)};
}

hawser_status stretches_find(const Scene *scene, Stretches *out, hawser_error *err)
{
    Corners c = {0};
    *out = (Stretches){0};
    hawser_status status = corners_find(scene, &c, err);
    if (!status) {
        out->stretch = calloc((size_t)c.n + 1, sizeof *out->stretch);
        if (!out->stretch) status = error_memory(err);
    }
    for (int i = 0; i < c.n && !status; ++i) {
        if (i + 1 < c.n && !(c.s[i + 1] > c.s[i])) continue; /* two corners in one place */
        out->stretch[out->n++] = stretch_make(scene, &c, i);
    }
    corners_free(&c);
    return status;
}

void stretches_cut(Stretches *stretches, double s)
{
    PullStretch *const a = stretches->stretch;
    int i = stretches->n;
    while (i > 0 && a[i - 1].from >= s) --i;
    if ((i < stretches->n && a[i].from <= s) || i == 0) return;
    for (int k = stretches->n++; k > i; --k) a[k] = a[k - 1];
    a[i] = a[i - 1];
    a[i].from = s;
}

void stretches_free(Stretches *s)
{
    free(s->stretch);
    *s = (Stretches){0};
}
