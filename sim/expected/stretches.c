#include "sim/expected/stretches.h"

#include <math.h>
#include <stdlib.h>

#include "core/base/error.h"

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

/* The part of a bend, of pieces p to `to`, along which guides stand: from the first to the last and half their spacing
 * beyond. One that comes within its own half spacing of the bend's end reaches it. */
static Guided guided_part(const Scene *scene, int p, int to)
{
    const SceneDef *const def = &scene->def;
    const double begin = scene->route.piece[p].s0, end = scene->route.piece[to].s0 + scene->route.piece[to].length;
    double first = INFINITY, last = -INFINITY;
    int n = 0;
    for (int i = 0; i < def->n_rollers; ++i) {
        const RollerDef *const r = &def->rollers[i];
        if (!(r->s >= begin && r->s <= end) || !roller_is_guide(&scene->route, r)) continue;
        if (r->s > last) ++n; /* a pair counts once */
        first = fmin(first, r->s);
        last = fmax(last, r->s);
    }
    if (n == 0) return (Guided){0};
    const double half = n > 1 ? (last - first) / (n - 1) / 2 : end - begin;
    return (Guided){first - begin > 1.01 * half ? first - half : begin, end - last > 1.01 * half ? last + half : end};
}

const SurfaceDef *surface_at(const SceneDef *def, double s)
{
    for (int i = 0; i < def->n_surfaces; ++i) {
        const SurfaceDef *const d = &def->surfaces[i];
        if (surface_along_route(d) && s >= d->shape.from && s < d->shape.to) return d;
    }
    return NULL;
}

/* Every place at which something changes, and the guided parts. */
typedef struct Corners {
    int n;
    double *s;      /* [n] m */
    Guided *guided; /* [pieces] of each bend, by its first piece */
} Corners;

static void corners_free(Corners *c)
{
    free(c->s);
    free(c->guided);
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
        c->guided[p] = guided_part(scene, p, to);
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
