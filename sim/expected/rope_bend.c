/* What the rope is bent round. docs/model/62-limits.md */
#include <math.h>
#include <stdio.h>

#include "sim/expected/findings.h"
#include "sim/expected/stretches.h"

/* Rollers that turn the rope by this much each are sheaves to it (our choice: less is no wrap), rad. */
static const double WRAPPED = 30 * M_PI / 180;
static const double REACH = 5; /* m: farther from a bend in which no roller stands something else bears the rope */
enum { LOOKS = 64 };           /* along a bend and REACH to both sides, for a roller's place */

/* What may bend the rope in one bend, or beside it. */
typedef struct Round {
    int n[2];           /* carriers, guides in the bend */
    double smallest[2]; /* m, their diameter */
    double nearest[2];  /* m along the route, of the rollers before and behind a bend that has none; */
    double beside[2];   /* m, their diameters; INFINITY: there is none */
} Round;

/* Where a roller that is listed by coordinates stands, m along the route: where it is nearest to it from `begin` to
 * `end`; NAN: it does not stand there, or is no roller. */
static double place_of(const SceneDef *def, const Route *route, const RollerDef *roller, double begin, double end)
{
    if (roller->profile == SHAPE_BOX || roller->profile == SHAPE_BELL) return NAN;
    if (!isnan(roller->s)) return roller->s >= begin && roller->s <= end ? roller->s : NAN;
    const double at_cable = roller->radius + 2 * bundle_diameter(def), middle = (begin + end) / 2;
    double least = INFINITY, place = NAN;
    if (v3_norm(v3_sub(roller->centre, route_at(route, middle).position)) > at_cable + (end - begin) / 2) return NAN;
    for (int i = 0; i <= LOOKS; ++i) {
        const double s = begin + i * (end - begin) / LOOKS;
        const double away = v3_norm(v3_sub(roller->centre, route_at(route, s).position));
        if (away >= least) continue;
        least = away;
        place = s;
    }
    return least <= at_cable + (end - begin) / LOOKS ? place : NAN;
}

static void round_take(Round *round, const RollerDef *roller, double s, double begin, double end, int guide)
{
    const double across = 2 * roller->radius;
    if (s >= begin && s <= end) {
        round->smallest[guide] = fmin(round->smallest[guide], across);
        round->n[guide]++;
        return;
    }
    const int behind = s > end;
    if (behind ? s >= round->nearest[1] : s <= round->nearest[0]) return;
    round->nearest[behind] = s;
    round->beside[behind] = across;
}

/* m, around what a bend of pieces p to `to` bends the rope: its own diameter, or that of its smallest roller where few
 * share the turn. In a bend with guides it is these, in one without rollers and without a duct those to both sides. */
static double bent_round(const Scene *scene, const Route *route, int p, int to)
{
    Round round = {{0, 0}, {INFINITY, INFINITY}, {-INFINITY, INFINITY}, {INFINITY, INFINITY}};
    double turn = 0, radius = INFINITY;
    const double begin = route->piece[p].s0, end = route->piece[to].s0 + route->piece[to].length;
    for (int k = p; k <= to; ++k) {
        turn += route->piece[k].angle;
        radius = fmin(radius, route->piece[k].radius);
    }
    for (int r = 0; r < scene->def.n_rollers; ++r) {
        const RollerDef *const roller = &scene->def.rollers[r];
        const double s = roller->hold_down ? NAN
                                           : place_of(&scene->def, route, roller, fmax(0, begin - REACH),
                                                      fmin(end + REACH, route->length));
        if (!isnan(s)) round_take(&round, roller, s, begin, end, roller_guides_at(route, roller, s));
    }
    const int by = round.n[1] > 0, n = round.n[by];
    if (n > 0) return turn / n >= WRAPPED ? round.smallest[by] : 2 * radius;
    const double beside = fmin(round.beside[0], round.beside[1]);
    const int bears =
        isfinite(round.beside[0]) && isfinite(round.beside[1]) && !surface_at(&scene->def, (begin + end) / 2);
    return bears && turn / 2 >= WRAPPED ? fmin(beside, 2 * radius) : 2 * radius;
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
    for (int p = 0, to; p < route->n; p = to + 1) {
        to = route_turn_end(route, p);
        const RoutePiece *const last = &route->piece[to];
        if (last->kind == ROUTE_STRAIGHT || last->s0 + last->length <= head) continue;
        const double round = bent_round(scene, route, p, to);
        if (round < f.value) f = finding_at(route, round, route->piece[p].s0);
    }
    if (scene->def.limits.sheave < f.value) {
        f = (Finding){.value = scene->def.limits.sheave};
        snprintf(f.where, sizeof f.where, "the smallest sheave");
    }
    f.absent = isinf(f.value);
    f.value /= rope_diameter(scene);
    snprintf(f.why, sizeof f.why, "needs limits.rope_diameter, or a rope in chain");
    return f;
}
