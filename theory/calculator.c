#include "theory/calculator.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "theory/search.h"

/* --------------------------------------------------------------------------------- cables, ducts, pushes */

/* Sets friction that the case gives for theory alone; stretches are cut at both ends of its range (PN1). */
static hawser_status friction_set(const Setup *setup, Stretches *s, hawser_error *err)
{
    const TheoryDef *const theory = &setup->def->theory;
    PullStretch *const longer = realloc(s->stretch, (size_t)(s->n + 2 * theory->n_friction + 1) * sizeof *longer);
    if (!longer) return error_memory(err);
    s->stretch = longer;
    for (int f = 0; f < theory->n_friction; ++f) {
        const TheoryFrictionDef *const def = &theory->friction[f];
        stretches_cut(s, def->from);
        stretches_cut(s, def->to);
        for (int i = 0; i < s->n; ++i) {
            if (longer[i].from < def->from || longer[i].from >= def->to) continue;
            const double middle = i + 1 < s->n ? (longer[i].from + longer[i + 1].from) / 2 : longer[i].from + 1;
            const int in_bend = setup->route->piece[route_at(setup->route, middle).piece].kind != ROUTE_STRAIGHT;
            const double correction =
                bundle_theory_friction(setup->def, supports_surface(&setup->supports, middle), in_bend);
            longer[i].mu_rope = def->mu;
            longer[i].mu_rope_static = def->mu_s;
            longer[i].mu = correction * def->mu;
            longer[i].mu_static = correction * def->mu_s;
        }
    }
    return HAWSER_OK;
}

/* The stretch in a bend at s as it would be on a straight, where the weight correction may differ. */
static PullStretch straightened(const Setup *setup, const PullStretch *bend, double s)
{
    const SurfaceDef *const on = supports_surface(&setup->supports, s);
    const double in_bend = bundle_theory_friction(setup->def, on, 1);
    const double factor = in_bend > 0 ? bundle_theory_friction(setup->def, on, 0) / in_bend : 1;
    PullStretch straight = *bend;
    straight.mu *= factor;
    straight.mu_static *= factor;
    return straight;
}

/* Extends the stretches beyond both ends of the route: a longer pull continues straight in the same duct. */
static hawser_status ends_extend(const Setup *setup, Stretches *s, hawser_error *err)
{
    const Route *const route = setup->route;
    int first = 0;
    while (s->n > 1 && s->stretch[s->n - 1].from >= route->length) --s->n;
    while (first + 1 < s->n && s->stretch[first + 1].from <= 0) ++first;
    s->n -= first;
    memmove(s->stretch, s->stretch + first, (size_t)s->n * sizeof *s->stretch);
    PullStretch *const longer = realloc(s->stretch, ((size_t)s->n + 2) * sizeof *longer);
    if (!longer) return error_memory(err);
    s->stretch = longer;
    const double inside = 1e-9 * route->length;
    const PullStretch last = straightened(setup, &longer[s->n - 1], route->length - inside),
                      before = straightened(setup, &longer[0], inside);
    if (route->piece[route->n - 1].kind != ROUTE_STRAIGHT && last.mu != longer[s->n - 1].mu) {
        longer[s->n] = last;
        longer[s->n++].from = route->length;
    }
    if (route->piece[0].kind != ROUTE_STRAIGHT && before.mu != longer[0].mu) {
        memmove(longer + 1, longer, (size_t)s->n++ * sizeof *longer);
        longer[0] = before;
        longer[1].from = 0;
        longer[0].from = fmin(longer[0].from, -1);
    }
    return HAWSER_OK;
}

/* Finds the least and largest friction of the cable, before a duct's correction and regardless of the rope's. A rope
 * that pulls chains has `rope_mu` as its own friction. */
static void frictions_find(const Setup *setup, Calculator *c)
{
    const double rope_mu = setup->def->theory.rope_mu;
    c->mu_least = INFINITY;
    for (int i = 0; i < c->stretches.n; ++i) {
        PullStretch *const s = &c->stretches.stretch[i];
        c->mu_least = fmin(c->mu_least, s->mu_rope);
        c->mu_largest = fmax(c->mu_largest, s->mu_rope);
        if (isnan(rope_mu)) continue;
        s->mu_rope = s->mu_rope_static = rope_mu;
        if (setup->def->strand.rope) s->mu = s->mu_static = rope_mu;
    }
}

/* Sets the positions of cables in the ducts; friction and weight that follow from them are part of the stretches. */
static hawser_status cables_set(const Setup *setup, Calculator *c, hawser_error *err)
{
    const SceneDef *const def = setup->def;
    c->duct = calloc((size_t)def->n_surfaces + 1, sizeof *c->duct);
    hawser_status status = c->duct ? stretches_copy(&setup->stretches, 0, &c->stretches, err) : error_memory(err);
    if (!status) status = friction_set(setup, &c->stretches, err);
    if (!status) status = ends_extend(setup, &c->stretches, err);
    if (!status) frictions_find(setup, c);
    for (int i = 0; i < def->n_surfaces && !status; ++i) {
        if (def->surfaces[i].shape.kind != SURFACE_DUCT) continue;
        c->duct[c->n_ducts].surface = &def->surfaces[i];
        status = bundle_in(def, &def->surfaces[i], &c->duct[c->n_ducts++].load, err);
    }
    return status;
}

/* Place on another route that corresponds to s on this one: the same share of the same piece. */
static double place_on(const Route *other, const Route *route, double s)
{
    if (other == route || !(s > 0)) return s;
    if (s >= route->length) return s - route->length + other->length;
    const int p = route_at(route, s).piece;
    const RoutePiece *const here = &route->piece[p], *const there = &other->piece[p];
    return there->s0 + (s - here->s0) * there->length / here->length;
}

/* Places the map's rollers on this route. */
static hawser_status rollers_place(const Setup *setup, Calculator *c, hawser_error *err)
{
    const Supports *const map = &setup->supports;
    c->roller = malloc(((size_t)map->n_rollers + 1) * sizeof *c->roller);
    if (!c->roller) return error_memory(err);
    for (int i = 0; i < map->n_rollers; ++i) {
        c->roller[i] = map->roller[i];
        c->roller[i].s = place_on(c->route, setup->route, map->roller[i].s);
    }
    return HAWSER_OK;
}

/* Pushes of the setup's pushers in one direction. */
typedef struct Pushing {
    const Setup *setup;
    PullStep *push; /* [setup->n_pushers] */
} Pushing;

static double pusher_push(void *of, int i, double arriving)
{
    const Pushing *const p = of;
    return p->push[i].force = setup_push(p->setup, i, arriving, INFINITY);
}

/* Finds all pushes in one pull with cable in all pushers; each depends on the tension that the earlier ones leave. A
 * pusher that the pull does not reach uses the tension at the pull's end. */
static hawser_status pushes_find(const Setup *setup, Calculator *c, int way, hawser_error *err)
{
    const PlanPullDef whole = {.way = way, .whole = 1};
    PullStep *const push = c->push[way];
    Pushing pushing = {setup, push};
    const PushLaw law = {pusher_push, &pushing};
    PlanDef def = c->def;
    Pull pull;
    if (setup->n_pushers == 0) return HAWSER_OK;
    for (int i = 0; i < setup->n_pushers; ++i)
        push[i] = (PullStep){.at = place_on(c->route, setup->route, setup->pusher[i].at), .force = NAN};
    def.push = def.push_back = push;
    def.pushes = &law;
    def.enough = 0; /* later pushes may reduce the tension again */
    const hawser_status status = plan_pull(&def, &whole, &pull, err);
    if (status) return status;
    for (int i = 0; i < setup->n_pushers; ++i)
        if (isnan(push[i].force)) pusher_push(&pushing, i, pull_at(&pull, push[i].at).tension);
    pull_clear(&pull);
    return HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------ rollers, rules */

/* A length of the route: one piece, or a bend of several pieces. */
typedef struct Part {
    double from, to; /* m */
} Part;

static Part part_of(const Route *route, int first, int last)
{
    return (Part){route->piece[first].s0, route->piece[last].s0 + route->piece[last].length};
}

int guide_stands_outside(const Route *route, const RollerDef *guide)
{
    const RoutePoint at = route_at(route, guide->s);
    return bend_side(v3_sub(guide->centre, at.position), at.curvature) < 0;
}

/* Lists the places, rising, of the rows' carriers or of the loaded guides on the part; returns their number. */
static int places_on(const Supports *map, SupportKind kind, Part on, double *s)
{
    int n = 0;
    for (int i = supports_from(map, on.from); i < map->n_rollers && map->roller[i].s <= on.to; ++i) {
        const SupportRoller *const r = &map->roller[i];
        if (r->row && r->kind == kind && !(kind == SUPPORT_GUIDE && r->inner < 0)) s[n++] = r->s;
    }
    return n;
}

/* Largest gap between neighbours of the rising places s[n] that reaches into the part and holds no duct or tray. *first
 * is where the search begins; it advances to the last place before the part. A single place counts with the whole part.
 */
static double gap_on(const Supports *map, Part part, int n, const double *s, int *first)
{
    double gap = 0;
    while (*first + 1 < n && !(s[*first + 1] > part.from)) ++*first;
    for (int i = *first; i + 1 < n && s[i] < part.to; ++i)
        if (!supports_surface(map, (s[i] + s[i + 1]) / 2)) gap = fmax(gap, s[i + 1] - s[i]);
    const int alone = n > 0 && !(s[n - 1] > s[0]) && s[0] >= part.from && s[0] <= part.to;
    return alone && !supports_surface(map, s[0]) ? part.to - part.from : gap;
}

/* Adds the nearest carrier on either side of a bend without carriers. */
static void bearers_add(const Supports *map, Part bend, int piece, Calculator *c)
{
    int beyond = supports_from(map, bend.to), before = beyond, nearest = -1;
    while (beyond < map->n_rollers && !(map->roller[beyond].s > bend.to)) before = ++beyond;
    while (beyond < map->n_rollers && (!map->roller[beyond].row || map->roller[beyond].kind == SUPPORT_GUIDE)) ++beyond;
    while (--before >= 0) { /* of carriers at one place the first in the list counts */
        const SupportRoller *const r = &map->roller[before];
        if (nearest >= 0 && r->s < map->roller[nearest].s) break;
        if (r->row && r->kind != SUPPORT_GUIDE) nearest = before;
    }
    if (nearest >= 0) c->bearer[c->n_bearers++] = (Bearer){piece, map->roller[nearest].item};
    if (beyond < map->n_rollers) c->bearer[c->n_bearers++] = (Bearer){piece, map->roller[beyond].item};
}

/* Finds the neighbours of the carrier at s among place[n] (rising), the ends of ducts and trays, and the route's ends,
 * where something else holds the cable. Returns how many of the two are ends; -1: s is at or beyond an end. */
static int neighbours_of(const Supports *map, double s, int n, const double *place, double near[2])
{
    const int low = items_before(n, place, sizeof *place, s, 0), high = items_before(n, place, sizeof *place, s, 1);
    near[0] = low > 0 ? place[low - 1] : 0;
    near[1] = high < n ? place[high] : map->route->length;
    int ends = (low == 0) + (high == n);
    const int k = supports_along(map, s);
    if (k > 0 && map->along[k - 1]->shape.to >= s) return -1;
    if (k > 0 && map->along[k - 1]->shape.to > near[0]) near[0] = map->along[k - 1]->shape.to, ++ends;
    if (k < map->n_along && map->along[k]->shape.from < near[1]) near[1] = map->along[k]->shape.from, ++ends;
    return s > near[0] && s < near[1] ? ends : -1;
}

/* Finds the rated carriers on straights beside bends and next to an end (T18a). Guides bear the lateral force. */
static void beside_find(const Supports *map, int n, const double *place, Calculator *c)
{
    const Route *const route = map->route;
    for (int i = 0; i < map->n_rollers; ++i) {
        const SupportRoller *const r = &map->roller[i];
        const double s = r->s;
        double near[2];
        if (!r->row || r->kind != SUPPORT_ROLLER || !(map->def->rollers[r->item].rating > 0)) continue;
        const RoutePoint at = route_at(route, s);
        const int ends = neighbours_of(map, s, n, place, near);
        if (ends < 0 || (route->piece[at.piece].kind != ROUTE_STRAIGHT && ends == 0)) continue;
        Vec3 turn = V3_ZERO;
        int bend = route->piece[at.piece].kind != ROUTE_STRAIGHT ? at.piece : -1, bare = 1;
        for (int k = 0; k < 2; ++k) {
            const RoutePoint next = route_at(route, near[k]);
            if (route->piece[next.piece].kind != ROUTE_STRAIGHT) bend = next.piece;
            bare &= !supports_surface(map, (s + near[k]) / 2);
            turn = v3_add(turn, v3_unit(v3_sub(next.position, at.position)));
        }
        if ((bend < 0 && ends == 0) || !bare) continue;
        const Vec3 left = route_left(route, s), up = v3_cross(at.tangent, left);
        const double aside = bend >= 0 && c->guides[bend] > 0 ? 0 : v3_dot(turn, left);
        c->beside[c->n_beside++] = (Beside){r->item, s, -v3_dot(turn, up), aside, (near[1] - near[0]) / 2 * up.z};
    }
}

/* Finds the gaps between carriers along the whole route; those between guides for each bend, since there are none
 * between bends. */
static hawser_status spacings_find(const Setup *setup, Calculator *c, hawser_error *err)
{
    const Supports *const map = &setup->supports;
    const Route *const route = setup->route;
    double *const s = malloc(2 * ((size_t)map->n_rollers + 1) * sizeof *s), *const guide = s + map->n_rollers + 1;
    c->spacing = calloc((size_t)route->n, sizeof *c->spacing);
    c->guides = calloc((size_t)route->n, sizeof *c->guides);
    c->bearer = calloc(2 * (size_t)route->n, sizeof *c->bearer);
    c->beside = calloc((size_t)map->n_rollers + 1, sizeof *c->beside);
    if (!s || !c->spacing || !c->guides || !c->bearer || !c->beside) {
        free(s);
        return error_memory(err);
    }
    const int carriers = places_on(map, SUPPORT_ROLLER, (Part){-INFINITY, INFINITY}, s);
    for (int k = 0, first = 0; k < route->n; ++k)
        c->spacing[k] = gap_on(map, part_of(route, k, k), carriers, s, &first);
    for (int p = 0, to; p < route->n; p = to + 1) {
        to = route_turn_end(route, p);
        const Part bend = part_of(route, p, to);
        const int guides = places_on(map, SUPPORT_GUIDE, bend, guide), turns = route->piece[p].kind != ROUTE_STRAIGHT;
        int first = 0;
        const int alone = guides > 0 && !(guide[guides - 1] > guide[0]) && turns;
        const double gap = alone ? INFINITY : gap_on(map, bend, guides, guide, &first);
        for (int k = p; k <= to; ++k) c->guides[k] = gap;
        if (turns && guides == 0 && places_on(map, SUPPORT_ROLLER, bend, guide) == 0) bearers_add(map, bend, p, c);
    }
    beside_find(map, carriers, s, c);
    free(s);
    return HAWSER_OK;
}

/* Finds the friction rule of each piece from the spans of the pull, which do not cross pieces. */
static hawser_status rules_find(const Setup *setup, Calculator *c, hawser_error *err)
{
    c->rule = calloc((size_t)setup->route->n, sizeof *c->rule);
    if (!c->rule) return error_memory(err);
    const Pull *const pull = &c->plan.way[PLAN_FORWARD].pull; /* spans of one piece are adjacent */
    for (int i = 0; i < pull->n; ++i) {
        const int p = pull->span[i].piece, first = i == 0 || pull->span[i - 1].piece != p;
        const SupportRule rule = pull->span[i].law.separate ? SUPPORT_SEPARATE : SUPPORT_RESULTANT;
        c->rule[p] = first || c->rule[p] == rule ? rule : SUPPORT_MIXED;
    }
    return HAWSER_OK;
}

/* ---------------------------------------------------------------------------------------------- the whole */

/* Sets machines and pits, with space for `more` of them. */
static hawser_status steps_set(const TheoryDef *theory, int more, Calculator *c, hawser_error *err)
{
    c->step = calloc((size_t)(theory->n_machines + theory->n_pits + more + 1), sizeof *c->step);
    if (!c->step) return error_memory(err);
    for (int i = 0; i < theory->n_machines; ++i)
        c->step[c->def.n_steps++] = (PullStep){theory->machines[i].at, theory->machines[i].force, STEP_TAKE};
    for (int i = 0; i < theory->n_pits; ++i)
        c->step[c->def.n_steps++] = (PullStep){theory->pits[i].at, theory->pits[i].force, STEP_ANEW};
    return HAWSER_OK;
}

/* Weight of the rope ahead, N/m: as given, or of the chain's heaviest rope piece. */
static double rope_weight(const SceneDef *def)
{
    const double given = def->theory.rope_mass, g = v3_norm(def->gravity);
    if (!isnan(given)) return given * g;
    double most = 0;
    for (int p = scene_def_eye(def); p < def->n_pieces; ++p)
        most = fmax(most, def->cables[def->pieces[p].cable].mass * g);
    return most;
}

/* Weight of the cable's lightest piece, N/m; 0: all weigh the same. */
static double lightest_of(const Setup *setup)
{
    const SceneDef *const def = setup->def;
    double least = INFINITY;
    for (int p = 0; p < scene_def_eye(def); ++p)
        least = fmin(least, def->cables[def->pieces[p].cable].mass * v3_norm(def->gravity));
    return least < setup->cable_weight * (1 - 1e-9) ? least : 0;
}

/* Sets the start tension, the reel's and the rope's allowances, and friction that depends on the length pulled. */
static void plan_set(const Setup *setup, const Expected *expected, Calculator *c)
{
    const TheoryDef *const theory = &setup->def->theory;
    c->def.reel_length = theory->reel;
    c->def.rope_length = theory->rope;
    c->def.back_tension = fmax(0, expected->largest_start);
    c->def.back_fall = fmin(expected->start_fall, c->def.back_tension);
    const Behind behind = starts_behind(setup);
    c->def.behind = behind.first;
    c->def.behind_least = behind.last;
    c->def.behind_slides = behind.slides;
    c->def.lightest = lightest_of(setup);
    c->def.feed = theory->feed;
    c->def.rope_force = setup->def->drag.force;
    memcpy(c->def.drawn, setup->company.drawn, sizeof c->def.drawn);
    c->def.rope_weight = rope_weight(setup->def);
    c->def.n_wear = theory->n_wear;
    c->def.wear = theory->wear;
    c->def.wear_by = (WearKind)theory->wear_by;
}

/* Lends the plan the arrays in their present state. */
static void plan_borrow(const Setup *setup, Calculator *c)
{
    c->def.route = c->route;
    c->def.n_stretches = c->stretches.n;
    c->def.stretch = c->stretches.stretch;
    c->def.spacing = c->spacing;
    c->def.guides = c->guides;
    c->def.n_pushes = setup->n_pushers;
    c->def.push = c->push[PLAN_FORWARD];
    c->def.push_back = c->push[PLAN_BACKWARD];
    c->def.step = c->step;
}

/* Computes pushes, plan, the winch force at places of the head and the limits. apart: largest distance between the
 * places, m; INFINITY: only their peaks, NAN: none of them. */
static hawser_status solve(const Setup *setup, double apart, Calculator *c, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < PLAN_WAYS && !status; ++k) {
        c->push[k] = calloc((size_t)setup->n_pushers + 1, sizeof *c->push[k]);
        if (!c->push[k]) status = error_memory(err);
        plan_borrow(setup, c);
        if (!status && !c->def.skip[k]) status = pushes_find(setup, c, k, err);
    }
    if (!status) status = plan_build(&c->def, &c->plan, err);
    for (int k = 0; k < PLAN_WAYS && !status; ++k) {
        if (c->def.skip[k] || isnan(apart)) continue;
        const Pull *const like[2] = {&c->plan.way[k].pull, &c->plan.way[k].rest};
        status = apart < INFINITY ? plan_heads(&c->def, k, apart, &c->heads[k], err)
                                  : plan_peaks(&c->def, k, like, &c->heads[k], err);
    }
    for (int k = 0; k < PLAN_WAYS && !status; ++k)
        if (!c->def.skip[k] && !c->base) status = clearances_of_way(setup, &c->def, k, &c->near[k], err);
    for (int k = 0; k < PLAN_WAYS && !status; ++k) {
        double relief = 0;
        if (!c->def.skip[k] && !isnan(apart)) status = plan_relief(&c->def, k, &relief, err);
        c->beyond[k] = c->plan.way[k].rope - c->def.drawn[k] - relief;
    }
    return status ? status : calculator_judge(setup, c, err);
}

static hawser_status weight_check(const SceneDef *def, hawser_error *err)
{
    const Vec3 g = def->gravity;
    if (expected_weighs(def)) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT,
                     "gravity: [%g, %g, %g] m/s2 does not point straight down, [0, 0, -g], as the pulling calculation "
                     "takes it",
                     g.x, g.y, g.z);
}

enum { HEAD_PLACES = 40 }; /* places of the head between the ends of the route, at least */

hawser_status calculator_build(const Setup *setup, const Expected *expected, int what, Calculator *out,
                               hawser_error *err)
{
    const int rows = !(what & CALCULATE_PEAKS) || heads_slacken(setup);
    const double apart = rows ? setup->route->length / HEAD_PLACES : INFINITY;
    *out = (Calculator){.cables = setup->def->bundle.shape.cables, .route = setup->route};
    out->def.skip[PLAN_BACKWARD] = what & CALCULATE_FORWARD;
    hawser_status status = weight_check(setup->def, err);
    if (!status) status = cables_set(setup, out, err);
    if (!status) status = spacings_find(setup, out, err);
    if (!status) status = steps_set(&setup->def->theory, 0, out, err);
    plan_set(setup, expected, out);
    if (!status) status = rollers_place(setup, out, err);
    if (!status) status = solve(setup, apart, out, err);
    if (!status) status = rules_find(setup, out, err);
    if (!status) status = calculator_know(setup, out, err);
    return status ? status : calculator_follow(setup, out, err);
}

/* ------------------------------------------------------------------------------------------- variations */

/* Multiplies the radius of a piece by `times`. */
static void piece_grow(RoutePieceDef *piece, double times)
{
    piece->radius *= times;
    if (piece->kind == ROUTE_CURVE) piece->length *= times;
    for (int end = 0; end < 2; ++end) piece->curvature[end] /= times;
    for (int i = 0; i < 3; ++i) piece->cubic[i] = v3_scale(times, piece->cubic[i]);
}

/* The scene's route with other radii; angles stay, lengths follow. */
static hawser_status route_vary(const Setup *setup, const Variation *by, Route *out, hawser_error *err)
{
    const SceneDef *const def = setup->def;
    RoutePieceDef *const piece = malloc((size_t)def->n_route * sizeof *piece);
    if (!piece) return error_memory(err);
    for (int p = 0, last = -1, meant = 0; p < def->n_route; ++p) {
        if (p > last) { /* a bend counts as one, however many pieces it has */
            last = route_turn_end(setup->route, p);
            meant = by->bend < 0 || (by->bend >= p && by->bend <= last);
        }
        piece[p] = def->route[p];
        if (by->radii) piece_grow(&piece[p], by->radii[p]);
        if (!by->radii && meant) piece_grow(&piece[p], by->radius);
    }
    const hawser_status status =
        route_build(out, def->n_route, piece, def->route_start, def->route_heading, def->route_slope, err);
    free(piece);
    return status;
}

static void *copy_of(const void *from, int n, size_t size)
{
    void *const to = malloc(((size_t)n + 1) * size);
    if (to) memcpy(to, from, (size_t)n * size);
    return to;
}

/* Copies what the base has along its route to the same places of the varied route. */
static hawser_status places_vary(const Setup *setup, const Calculator *base, const Variation *by, Calculator *c,
                                 hawser_error *err)
{
    const int n = base->plan.n;
    c->stretches = (Stretches){base->stretches.n,
                               copy_of(base->stretches.stretch, base->stretches.n, sizeof *c->stretches.stretch)};
    c->spacing = copy_of(base->spacing, n, sizeof *c->spacing);
    c->guides = copy_of(base->guides, n, sizeof *c->guides);
    c->duct = copy_of(base->duct, base->n_ducts, sizeof *c->duct);
    c->bearer = copy_of(base->bearer, base->n_bearers, sizeof *c->bearer);
    c->beside = copy_of(base->beside, base->n_beside, sizeof *c->beside);
    if (!c->stretches.stretch || !c->spacing || !c->guides || !c->duct || !c->bearer || !c->beside)
        return error_memory(err);
    c->n_bearers = base->n_bearers;
    c->n_beside = base->n_beside;
    c->n_ducts = base->n_ducts;
    for (int i = 0; i < c->stretches.n; ++i) {
        PullStretch *const s = &c->stretches.stretch[i];
        s->from = place_on(c->route, base->route, s->from);
        s->mu *= by->friction;
        s->mu_static *= by->friction;
        s->mu_rope *= by->friction;
        s->mu_rope_static *= by->friction;
    }
    for (int i = 0; i < c->n_beside; ++i) c->beside[i].s = place_on(c->route, base->route, c->beside[i].s);
    for (int i = 0; i < c->def.n_steps; ++i) c->step[i].at = place_on(c->route, base->route, c->step[i].at);
    return rollers_place(setup, c, err);
}

/* Checks whether a limit needs the winch force at all places of the head: rope, winch or trip. */
static int peaks_count(const Setup *setup)
{
    const LimitsDef *const limits = &setup->def->limits;
    return !isnan(limits->rope_strength) || !isnan(limits->own[HAWSER_LIMIT_WINCH]) ||
           setup->def->winch.trip.force > 0 || setup->def->winch.trip.factor > 0;
}

hawser_status calculator_vary(const Setup *setup, const Calculator *base, const Variation *by, Calculator *out,
                              hawser_error *err)
{
    const double apart = peaks_count(setup) ? INFINITY : NAN;
    *out = (Calculator){
        .cables = base->cables, .route = base->route, .def = base->def, .base = base->base ? base->base : base};
    memcpy(out->known, base->known, sizeof out->known);
    out->def.n_steps = 0;
    out->def.beyond = by->beyond;
    out->def.enough = by->enough;
    out->def.skip[!by->way] = 1;
    hawser_status status = HAWSER_OK;
    if (by->radius != 1 || by->radii) {
        status = route_vary(setup, by, &out->own, err);
        out->route = &out->own;
    }
    if (!status) status = steps_set(&setup->def->theory, by->n_steps, out, err);
    if (!status) status = places_vary(setup, base, by, out, err);
    for (int i = 0; i < by->n_steps && !status; ++i) out->step[out->def.n_steps++] = by->step[i];
    return status ? status : solve(setup, apart, out, err);
}

double calculator_enough(const Setup *setup, const Calculator *c, int way, const int *skip)
{
    int judged = 0;
    double most = 0;
    for (int i = 0; i < c->n_limits; ++i) {
        const hawser_limit *const l = &c->limit[way][i];
        const int tension = l->kind == HAWSER_LIMIT_PULL || l->kind == HAWSER_LIMIT_RESTART;
        if (!tension || !l->judged || (skip && skip[i])) continue;
        ++judged;
        most = fmax(most, l->limit);
    }
    return judged == 2 && !setup->def->strand.rope ? (1 + 1e-6) * most : 0;
}

void calculator_free(Calculator *c)
{
    plan_clear(&c->plan);
    stretches_free(&c->stretches);
    for (int k = 0; k < PLAN_WAYS; ++k) {
        free(c->push[k]), c->push[k] = NULL;
        free(c->near[k]), c->near[k] = NULL;
        plan_heads_free(&c->heads[k]);
    }
    route_clear(&c->own);
    free(c->step), c->step = NULL;
    free(c->spacing), c->spacing = NULL;
    free(c->guides), c->guides = NULL;
    free(c->bearer), c->bearer = NULL;
    free(c->beside), c->beside = NULL;
    free(c->roller), c->roller = NULL;
    free(c->rule), c->rule = NULL;
    free(c->duct), c->duct = NULL;
}
