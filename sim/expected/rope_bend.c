/* What the rope is bent round. docs/model/62-limits.md */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "sim/expected/findings.h"
#include "sim/expected/stretches.h"
#include "theory/place/place.h"

/* Rollers that turn the rope by this much each are sheaves to it (our choice: less is no wrap), rad. */
static const double WRAPPED = 30 * M_PI / 180;
static const double REACH = 5; /* m: farther from a bend in which no roller stands something else bears the rope */
static const double INWARD =
    0.3; /* cosine: a roller that stands so far on the inner side of a bend can turn the rope */

/* A roller that can bend the rope. */
typedef struct Turner {
    double s, across; /* m along the route; its diameter, m */
    int guide;        /* upright */
} Turner;

/* Where the route is nearest to a roller that is listed by coordinates; NAN: the cable does not reach it there, or a
 * duct or tray has it. */
static double place_listed(const SceneDef *def, const RouteGrid *grid, const RollerDef *roller)
{
    const Nearest there = route_nearest(grid, roller->centre, 1);
    const int near = there.distance <= roller->radius + 2 * bundle_diameter(def);
    return near && !surface_at(def, there.s) ? there.s : NAN;
}

/* Whether it stands where a bend presses the rope on it; a carrier of a row that lies level carries it anyway. */
static int is_inside(const Route *route, const RollerDef *roller, double s, int guide)
{
    const RoutePoint at = route_at(route, s);
    const Vec3 off = v3_sub(roller->centre, at.position);
    if (!isnan(roller->s) && !guide) return 1;
    return !(v3_norm(at.curvature) > 0) || v3_dot(off, at.curvature) > INWARD * v3_norm(off) * v3_norm(at.curvature);
}

/* All of them into out [rollers], returns how many; -1 without memory. */
static int turners_find(const Scene *scene, const Route *route, Turner *out)
{
    const SceneDef *const def = &scene->def;
    RouteGrid grid = {0};
    int n = 0;
    for (int r = 0; r < def->n_rollers; ++r) {
        const RollerDef *const roller = &def->rollers[r];
        const int listed = isnan(roller->s);
        if (roller->hold_down || (listed && (roller->profile == SHAPE_BOX || roller->profile == SHAPE_BELL))) continue;
        if (listed && !grid.at && route_grid_build(route, 0, &grid, NULL)) return -1;
        const double s = listed ? place_listed(def, &grid, roller) : roller->s;
        if (isnan(s)) continue;
        const int guide = roller_guides_at(route, roller, s);
        if (is_inside(route, roller, s, guide)) out[n++] = (Turner){s, 2 * roller->radius, guide};
    }
    route_grid_clear(&grid);
    return n;
}

/* The diameter of the nearest one from `begin` to `end`, seen from `from`; INFINITY: there is none. */
static double nearest_turner(int n, const Turner *turner, double begin, double end, double from)
{
    double least = INFINITY, across = INFINITY;
    for (int i = 0; i < n; ++i) {
        const double away = fabs(turner[i].s - from);
        if (turner[i].s < begin || turner[i].s > end || away >= least) continue;
        least = away;
        across = turner[i].across;
    }
    return across;
}

/* m, around what a bend of pieces p to `to` bends the rope: its own diameter, or that of its smallest roller where few
 * share the turn. In a bend with guides it is these, in one without rollers and without a duct those to both sides. */
static double bent_round(const SceneDef *def, const Route *route, int p, int to, int n, const Turner *turner)
{
    int count[2] = {0, 0}; /* carriers, guides */
    double smallest[2] = {INFINITY, INFINITY}, turn = 0, radius = INFINITY;
    const double begin = route->piece[p].s0, end = route->piece[to].s0 + route->piece[to].length;
    for (int k = p; k <= to; ++k) {
        turn += route->piece[k].angle;
        radius = fmin(radius, route->piece[k].radius);
    }
    for (int i = 0; i < n; ++i) {
        if (!(turner[i].s >= begin && turner[i].s <= end)) continue;
        smallest[turner[i].guide] = fmin(smallest[turner[i].guide], turner[i].across);
        count[turner[i].guide]++;
    }
    const int by = count[1] > 0;
    if (count[by] > 0) return turn / count[by] >= WRAPPED ? smallest[by] : 2 * radius;
    const double before = nearest_turner(n, turner, begin - REACH, begin, begin),
                 ahead = nearest_turner(n, turner, end, end + REACH, end);
    const int bare = isfinite(before) && isfinite(ahead) && !surface_at(def, (begin + end) / 2);
    return bare && turn / 2 >= WRAPPED ? fmin(fmin(before, ahead), 2 * radius) : 2 * radius;
}

/* The rope's diameter, m: as the case says, or of the thickest rope in the chain; NAN: nobody knows. */
static double rope_diameter(const Scene *scene)
{
    const SceneDef *const def = &scene->def;
    if (!isnan(def->limits.rope_diameter)) return def->limits.rope_diameter;
    double most = NAN;
    for (int p = scene_def_eye(def); p < def->n_pieces; ++p)
        most = fmax(most, def->cables[def->pieces[p].cable].diameter);
    return most;
}

Finding rope_bend(const Scene *scene, const Route *route, double head)
{
    Finding f = {.value = INFINITY};
    Turner *const turner = malloc(((size_t)scene->def.n_rollers + 1) * sizeof *turner);
    const int n = turner ? turners_find(scene, route, turner) : -1;
    for (int p = 0, to; p < route->n; p = to + 1) {
        to = route_turn_end(route, p);
        const RoutePiece *const last = &route->piece[to];
        if (last->kind == ROUTE_STRAIGHT || last->s0 + last->length <= head) continue;
        const double round = n < 0 ? NAN : bent_round(&scene->def, route, p, to, n, turner);
        if (!(round >= f.value)) f = finding_at(route, round, route->piece[p].s0);
        if (n < 0) break;
    }
    free(turner);
    if (n >= 0 && scene->def.limits.sheave < f.value) {
        f = (Finding){.value = scene->def.limits.sheave};
        snprintf(f.where, sizeof f.where, "the smallest sheave");
    }
    f.absent = isinf(f.value);
    f.value /= rope_diameter(scene);
    snprintf(f.why, sizeof f.why, "%s", n < 0 ? "no memory" : "needs limits.rope_diameter, or a rope in chain");
    return f;
}
