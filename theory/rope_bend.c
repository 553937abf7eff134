/* What the rope is bent round. docs/model/62-limits.md */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "theory/expected.h"
#include "theory/search.h"
#include "theory/stretches.h"

/* Rollers that turn the rope by this much each are sheaves to it (our choice: less is no wrap), rad. */
static const double WRAPPED = 30 * M_PI / 180;
static const double REACH = 5; /* m: farther from a bend in which no roller stands something else bears the rope */

/* The nearest one from `begin` to `end`, seen from `from`, that a bend with this curvature presses the rope on, or the
 * nearest carrier; NULL: there is none. */
static const SupportRoller *nearest_turner(int n, const SupportRoller *turner, double begin, double end, double from,
                                           Vec3 curvature)
{
    double least[2] = {INFINITY, INFINITY};
    const SupportRoller *nearest[2] = {NULL, NULL};
    for (int i = items_before(n, &turner->s, sizeof *turner, begin, 0); i < n && turner[i].s <= end; ++i) {
        const double away = fabs(turner[i].s - from);
        const int inner = bend_side(turner[i].off, curvature) > 0;
        if (!(inner || turner[i].kind == SUPPORT_ROLLER) || away >= least[inner]) continue;
        least[inner] = away;
        nearest[inner] = &turner[i];
    }
    return nearest[nearest[1] ? 1 : 0];
}

/* ----------------------------------------------------------------------------------- how much each of them turns it */

/* A walk along a bend: by how much the route has turned from its begin up to s, and the integral of that. */
typedef struct Walk {
    const Route *route;
    int piece, last;
    double s, turned, sum; /* m, rad, rad m */
} Walk;

enum { PARTS = 8 }; /* of a piece, in each of which the curvature counts as linear */

static double curvature_on(const Route *route, int piece, double s)
{
    const RoutePiece *const p = &route->piece[piece];
    return p->kind == ROUTE_BEND ? 1 / p->radius : v3_norm(route_way_on_piece(route, piece, s).curvature);
}

/* Up to `to`; what lies before the bend does not turn, nor what lies beyond it. */
static void walk_on(Walk *w, double to)
{
    while (w->s < to && w->piece <= w->last) {
        const RoutePiece *const p = &w->route->piece[w->piece];
        const double end = p->s0 + p->length, next = fmin(fmin(to, end), w->s + p->length / PARTS), h = next - w->s;
        const double k0 = curvature_on(w->route, w->piece, w->s), k1 = curvature_on(w->route, w->piece, next);
        w->sum += h * (w->turned + h * (2 * k0 + k1) / 6);
        w->turned += h * (k0 + k1) / 2;
        w->s = next;
        w->piece += next >= end;
    }
    if (w->s < to) w->sum += (to - w->s) * w->turned;
    w->s = fmax(w->s, to);
}

/* The rope from one roller to the next: its chord goes as the route does on the mean between them. (LI13) */
typedef struct Wrap {
    Walk walk;
    int n;              /* rollers, or groups of rollers that stand at one place */
    double s, sum;      /* of the walk at the last one */
    double way, across; /* rad, of the chord to it; its diameter, m */
    double round;       /* m, the smallest diameter that it is wrapped round */
} Wrap;

static Wrap wrap_begin(const Route *route, int p, int to)
{
    return (Wrap){.walk = {.route = route, .piece = p, .last = to, .s = route->piece[p].s0}, .round = INFINITY};
}

/* The chord ahead of the last roller goes that way. */
static void wrap_leave(Wrap *w, double way)
{
    if (w->n > 0 && way - w->way >= WRAPPED * (1 - 1e-9)) w->round = fmin(w->round, w->across);
    w->way = way;
}

static void wrap_roller(Wrap *w, const SupportRoller *roller)
{
    if (w->n > 0 && roller->s - w->s < (roller->across + w->across) / 2) { /* one above the other */
        w->across = fmin(w->across, roller->across);
        return;
    }
    walk_on(&w->walk, roller->s);
    wrap_leave(w, w->n > 0 ? (w->walk.sum - w->sum) / (roller->s - w->s) : 0);
    w->n++;
    w->s = roller->s;
    w->sum = w->walk.sum;
    w->across = roller->across;
}

static double wrap_end(Wrap *w, double end)
{
    walk_on(&w->walk, end);
    wrap_leave(w, w->walk.turned);
    return w->round;
}

/* m, around what a bend of pieces p to `to` bends the rope: its own diameter, or that of the smallest roller that it is
 * wrapped round. Rollers share the turn that stand on its inner side, or without such the carriers (grooves hold it);
 * of a bend without rollers and without a duct those to both sides. */
static double bent_round(const Setup *setup, const Route *route, int p, int to, const SupportRoller *turner)
{
    Wrap wrap[] = {wrap_begin(route, p, to), wrap_begin(route, p, to)}; /* carriers that lie level; the inner side */
    const double begin = route->piece[p].s0, end = route->piece[to].s0 + route->piece[to].length;
    const int n = setup->supports.n_rollers;
    double radius = INFINITY;
    for (int k = p; k <= to; ++k) radius = fmin(radius, route->piece[k].radius);
    for (int i = items_before(n, &turner->s, sizeof *turner, begin, 0); i < n && turner[i].s <= end; ++i) {
        const int inner = turner[i].inner > 0;
        if (inner || (turner[i].kind == SUPPORT_ROLLER && turner[i].inner == 0)) wrap_roller(&wrap[inner], &turner[i]);
    }
    const int by = wrap[1].n > 0;
    double round = wrap_end(&wrap[by], end);
    if (wrap[by].n > 0) return isfinite(round) ? round : 2 * radius;
    const double middle = (begin + end) / 2;
    const Vec3 curvature = route_at(route, middle).curvature;
    const SupportRoller *const before = nearest_turner(n, turner, begin - REACH, begin, begin, curvature),
                               *const ahead = nearest_turner(n, turner, end, end + REACH, end, curvature);
    if (!before || !ahead || supports_surface(&setup->supports, middle)) return 2 * radius;
    Wrap between = wrap_begin(route, p, to);
    wrap_roller(&between, before);
    wrap_roller(&between, ahead);
    round = wrap_end(&between, end);
    return fmin(round, 2 * radius);
}

double rope_diameter(const Setup *setup)
{
    const SceneDef *const def = setup->def;
    if (!isnan(def->limits.rope_diameter)) return def->limits.rope_diameter;
    double most = NAN;
    for (int p = strand_is_rope(&def->strand) ? 0 : scene_def_eye(def); p < def->n_pieces; ++p)
        most = fmax(most, def->cables[def->pieces[p].cable].diameter);
    return most;
}

Finding rope_bend(const Setup *setup, const Route *route, double head, const SupportRoller *roller)
{
    Finding f = {.value = INFINITY};
    for (int p = 0, to; p < route->n; p = to + 1) {
        to = route_turn_end(route, p);
        const RoutePiece *const last = &route->piece[to];
        if (last->kind == ROUTE_STRAIGHT || last->s0 + last->length <= head) continue;
        const double round = bent_round(setup, route, p, to, roller);
        if (round < f.value) f = finding_at(route, round, route->piece[p].s0);
    }
    if (setup->def->limits.sheave < f.value) {
        f = (Finding){.value = setup->def->limits.sheave};
        snprintf(f.where, sizeof f.where, "the smallest sheave");
    }
    f.absent = isinf(f.value) || setup->def->strand.joined >= 0; /* the rope of chains is said with the rope */
    f.value /= rope_diameter(setup);
    snprintf(f.why, sizeof f.why, "needs limits.rope_diameter, or a rope in chain");
    return f;
}
