/* What the rope is bent round. docs/model/62-limits.md */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "sim/expected/expected.h"
#include "sim/expected/stretches.h"

/* Rollers that turn the rope by this much each are sheaves to it (our choice: less is no wrap), rad. */
static const double WRAPPED = 30 * M_PI / 180;
static const double REACH = 5; /* m: farther from a bend in which no roller stands something else bears the rope */

/* The diameter of the nearest one from `begin` to `end`, seen from `from`, that a bend with this curvature presses the
 * rope on, or of the nearest carrier; INFINITY: there is none. */
static double nearest_turner(int n, const Turner *turner, double begin, double end, double from, Vec3 curvature)
{
    double least[2] = {INFINITY, INFINITY}, across[2] = {INFINITY, INFINITY};
    for (int i = 0; i < n; ++i) {
        const double away = fabs(turner[i].s - from);
        const int inner = bend_side(turner[i].off, curvature) > 0;
        if (turner[i].s < begin || turner[i].s > end || !(inner || turner[i].carries) || away >= least[inner]) continue;
        least[inner] = away;
        across[inner] = turner[i].across;
    }
    return across[isfinite(least[1])];
}

/* m, around what a bend of pieces p to `to` bends the rope: its own diameter, or that of its smallest roller where few
 * share the turn. These are the ones on its inner side, or without such the carriers (grooves hold it); in a bend
 * without rollers and without a duct those to both sides. */
static double bent_round(const SceneDef *def, const Route *route, int p, int to, int n, const Turner *turner)
{
    int count[2] = {0, 0}; /* carriers that lie level, those on the inner side */
    double smallest[2] = {INFINITY, INFINITY}, turn = 0, radius = INFINITY;
    const double begin = route->piece[p].s0, end = route->piece[to].s0 + route->piece[to].length;
    for (int k = p; k <= to; ++k) {
        turn += route->piece[k].angle;
        radius = fmin(radius, route->piece[k].radius);
    }
    for (int i = 0; i < n; ++i) {
        const int inner = turner[i].inner > 0;
        if (!(turner[i].s >= begin && turner[i].s <= end) || !(inner || (turner[i].carries && turner[i].inner == 0)))
            continue;
        smallest[inner] = fmin(smallest[inner], turner[i].across);
        count[inner]++;
    }
    const int by = count[1] > 0;
    if (count[by] > 0) return turn / count[by] >= WRAPPED ? smallest[by] : 2 * radius;
    const double middle = (begin + end) / 2;
    const Vec3 curvature = route_at(route, middle).curvature;
    const double before = nearest_turner(n, turner, begin - REACH, begin, begin, curvature),
                 ahead = nearest_turner(n, turner, end, end + REACH, end, curvature);
    const int bare = isfinite(before) && isfinite(ahead) && !surface_at(def, middle);
    return bare && turn / 2 >= WRAPPED ? fmin(fmin(before, ahead), 2 * radius) : 2 * radius;
}

/* The rope's diameter, m: as the case says, or of the thickest rope in the chain, which may be one; NAN: nobody knows.
 */
static double rope_diameter(const Scene *scene)
{
    const SceneDef *const def = &scene->def;
    if (!isnan(def->limits.rope_diameter)) return def->limits.rope_diameter;
    double most = NAN;
    for (int p = strand_is_rope(&def->strand) ? 0 : scene_def_eye(def); p < def->n_pieces; ++p)
        most = fmax(most, def->cables[def->pieces[p].cable].diameter);
    return most;
}

Finding rope_bend(const Scene *scene, const Route *route, double head, int n, const Turner *turner)
{
    Finding f = {.value = INFINITY};
    for (int p = 0, to; p < route->n; p = to + 1) {
        to = route_turn_end(route, p);
        const RoutePiece *const last = &route->piece[to];
        if (last->kind == ROUTE_STRAIGHT || last->s0 + last->length <= head) continue;
        const double round = bent_round(&scene->def, route, p, to, n, turner);
        if (round < f.value) f = finding_at(route, round, route->piece[p].s0);
    }
    if (scene->def.limits.sheave < f.value) {
        f = (Finding){.value = scene->def.limits.sheave};
        snprintf(f.where, sizeof f.where, "the smallest sheave");
    }
    f.absent = isinf(f.value) || scene->def.strand.joined >= 0; /* the rope of chains is said with the rope */
    f.value /= rope_diameter(scene);
    snprintf(f.why, sizeof f.why, "needs limits.rope_diameter, or a rope in chain");
    return f;
}
