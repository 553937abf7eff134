#include "theory/stretches.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "theory/search.h"

/* Where the first stretch begins, m along the route: behind any lead-in. */
static const double FAR_BEHIND = -1e9;

/* A length of route whose guide rollers hold the cable sideways. */
typedef struct Guided {
    double from, to; /* m; none if from >= to */
} Guided;

/* Every place at which something changes, and the guided parts. */
typedef struct Corners {
    int n, n_guided;
    double *s;      /* [n] m */
    Guided *guided; /* [n_guided] of bends, by rising place */
} Corners;

/* The part of a bend, of pieces p to `to`, along which guides stand: from the first to the last and half their spacing
 * beyond. One that comes within its own half spacing of the bend's end reaches it. */
static Guided guided_part(const Supports *map, int p, int to)
{
    const double begin = map->route->piece[p].s0, end = map->route->piece[to].s0 + map->route->piece[to].length;
    double first = INFINITY, last = -INFINITY;
    int n = 0;
    for (int i = supports_from(map, begin); i < map->n_rollers && map->roller[i].s <= end; ++i) {
        const SupportRoller *const r = &map->roller[i];
        if (r->inner < 0 || r->kind != SUPPORT_GUIDE) continue;
        if (r->s > last) ++n; /* a pair counts once */
        first = fmin(first, r->s);
        last = fmax(last, r->s);
    }
    if (n == 0) return (Guided){0};
    const double half = n > 1 ? (last - first) / (n - 1) / 2 : end - begin;
    return (Guided){first - begin > 1.01 * half ? first - half : begin, end - last > 1.01 * half ? last + half : end};
}

static void corners_free(Corners *c)
{
    free(c->s);
    free(c->guided);
}

static hawser_status corners_find(const Supports *map, Corners *c, hawser_error *err)
{
    const BundleDef *const bundle = &map->def->bundle;
    const int pieces = map->route->n;
    c->s = malloc((size_t)(2 * map->n_along + 3 * pieces + 1) * sizeof *c->s);
    c->guided = malloc((size_t)pieces * sizeof *c->guided);
    if (!c->s || !c->guided) return error_memory(err);
    c->s[c->n++] = FAR_BEHIND;
    for (int i = 0; i < map->n_along; ++i) {
        c->s[c->n++] = map->along[i]->shape.from;
        c->s[c->n++] = map->along[i]->shape.to;
    }
    const int by_piece = bundle_present(bundle) && bundle->correction == CORRECT_STRAIGHTS;
    for (int p = 0; p < pieces && by_piece; ++p) c->s[c->n++] = map->route->piece[p].s0;
    for (int p = 0, to; p < pieces; p = to + 1) {
        to = route_turn_end(map->route, p);
        if (!route_turns_aside(&map->route->piece[p])) continue;
        const Guided part = guided_part(map, p, to);
        if (!(part.from < part.to)) continue;
        c->guided[c->n_guided++] = part;
        c->s[c->n++] = part.from;
        c->s[c->n++] = part.to;
    }
    qsort(c->s, (size_t)c->n, sizeof *c->s, compare_first);
    return HAWSER_OK;
}

/* Whether the supports at s are separate: guides, or a floor with upright sides. */
static int is_separate(const Corners *c, const SurfaceDef *surface, double s)
{
    const int begun = items_before(c->n_guided, &c->guided->from, sizeof *c->guided, s, 1);
    if (begun > 0 && s < c->guided[begun - 1].to) return 1;
    return surface && surface->shape.kind == SURFACE_FLAT && surface->shape.height > 0;
}

/* Whether something pushes the cable; by its weight alone it runs away, and what a coil would hold then is not counted
 * on. */
static int is_pushed(const SceneDef *def)
{
    int pushed = def->n_conveyors > 0 || def->theory.feed > 0;
    for (int r = 0; r < def->n_rollers; ++r) pushed |= def->rollers[r].spin.motor.kind != MOTOR_NONE;
    return pushed;
}

/* N m2, of all cables together, each as its limpest piece. */
static double stiffness_of(const SceneDef *def)
{
    double least = INFINITY;
    for (int p = 0; p < scene_def_eye(def); ++p) {
        const CableDef *const cable = &def->cables[def->pieces[p].cable];
        least = fmin(least, fmin(cable->ei_y, cable->ei_z));
    }
    return fmax(1, def->bundle.shape.cables) * least;
}

/* The stretch that begins at c->s[i]. Friction is the surface's where there is one; of several cables one bears more
 * than the others. */
static PullStretch stretch_make(const Supports *map, double weight, const Corners *c, int i)
{
    const double middle = i + 1 < c->n ? (c->s[i] + c->s[i + 1]) / 2 : c->s[i] + 1;
    const SurfaceDef *const surface = supports_surface(map, middle);
    const FrictionLaw *const law = surface ? &surface->friction : &map->def->friction;
    const int in_bend = map->route->piece[route_at(map->route, middle).piece].kind != ROUTE_STRAIGHT;
    const double mu = surface ? surface_theory_friction(map->def, surface, in_bend) : law->mu_d;
    const double mu_rope = surface ? mu / bundle_friction(map->def, surface, in_bend) : mu;
    const double at_rest = law->mu_d > 0 ? law->mu_s / law->mu_d : NAN;
    const int coils = surface && surface->shape.kind == SURFACE_DUCT && is_pushed(map->def);
    const double bore = coils && surface->bore > 0 ? surface->bore : coils ? surface->shape.radius : 0;
    return (PullStretch){.from = c->s[i],
                         .weight = weight,
                         .mu = mu,
                         .mu_rope = mu_rope,
                         .mu_rope_static = law->mu_d > 0 ? mu_rope * at_rest : law->mu_s,
                         .mu_static = law->mu_d > 0 ? mu * at_rest : law->mu_s,
                         .room = coils ? fmax(0, bore - bundle_diameter(map->def) / 2) : 0,
                         .ei = coils ? stiffness_of(map->def) : 0,
                         .separate = is_separate(c, surface, middle),
                         .share = bundle_share(map->def, surface)};
}

hawser_status stretches_find(const Supports *map, double weight, Stretches *out, hawser_error *err)
{
    Corners c = {0};
    *out = (Stretches){0};
    hawser_status status = corners_find(map, &c, err);
    if (!status) {
        out->stretch = calloc((size_t)c.n + 1, sizeof *out->stretch);
        if (!out->stretch) status = error_memory(err);
    }
    for (int i = 0; i < c.n && !status; ++i) {
        if (i + 1 < c.n && !(c.s[i + 1] > c.s[i])) continue; /* two corners in one place */
        out->stretch[out->n++] = stretch_make(map, weight, &c, i);
    }
    corners_free(&c);
    return status;
}

hawser_status stretches_copy(const Stretches *from, int more, Stretches *out, hawser_error *err)
{
    *out = (Stretches){from->n, malloc((size_t)(from->n + more) * sizeof *out->stretch)};
    if (!out->stretch) return error_memory(err);
    memcpy(out->stretch, from->stretch, (size_t)from->n * sizeof *out->stretch);
    return HAWSER_OK;
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
