#include "sim/expected/calculator.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"

/* --------------------------------------------------------------------------------- cables, ducts, pushes */

/* Stretches in which the case gives friction for theory alone: what lies there is cut at both ends (PN1). */
static hawser_status friction_set(const Scene *scene, Stretches *s, hawser_error *err)
{
    const TheoryDef *const theory = &scene->def.theory;
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
            const int in_bend = scene->route.piece[route_at(&scene->route, middle).piece].kind != ROUTE_STRAIGHT;
            const double correction = bundle_theory_friction(&scene->def, surface_at(&scene->def, middle), in_bend);
            longer[i].mu_rope = def->mu;
            longer[i].mu_rope_static = def->mu_s;
            longer[i].mu = correction * def->mu;
            longer[i].mu_static = correction * def->mu_s;
        }
    }
    return HAWSER_OK;
}

/* A stretch in a bend, which holds s, as it is on a straight beyond the route's end, where the weight correction may be
 * another.
 */
static PullStretch straightened(const Scene *scene, const PullStretch *bend, double s)
{
    const SurfaceDef *const on = surface_at(&scene->def, s);
    const double in_bend = bundle_theory_friction(&scene->def, on, 1);
    const double factor = in_bend > 0 ? bundle_theory_friction(&scene->def, on, 0) / in_bend : 1;
    PullStretch straight = *bend;
    straight.mu *= factor;
    straight.mu_static *= factor;
    return straight;
}

/* Beyond either end of the route things are as they are at the end: a longer pull goes on in the same duct, straight.
 */
static hawser_status ends_extend(const Scene *scene, Stretches *s, hawser_error *err)
{
    const Route *const route = &scene->route;
    int first = 0;
    while (s->n > 1 && s->stretch[s->n - 1].from >= route->length) --s->n;
    while (first + 1 < s->n && s->stretch[first + 1].from <= 0) ++first;
    s->n -= first;
    memmove(s->stretch, s->stretch + first, (size_t)s->n * sizeof *s->stretch);
    PullStretch *const longer = realloc(s->stretch, ((size_t)s->n + 2) * sizeof *longer);
    if (!longer) return error_memory(err);
    s->stretch = longer;
    const double inside = 1e-9 * route->length;
    const PullStretch last = straightened(scene, &longer[s->n - 1], route->length - inside),
                      before = straightened(scene, &longer[0], inside);
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

/* The least and largest friction are the cable's, before a duct's correction, whatever the rope's is. Of a rope that
 * draws chains `rope_mu` is its own. */
static void frictions_find(const Scene *scene, Calculator *c)
{
    const double rope_mu = scene->def.theory.rope_mu;
    c->mu_least = INFINITY;
    for (int i = 0; i < c->stretches.n; ++i) {
        PullStretch *const s = &c->stretches.stretch[i];
        c->mu_least = fmin(c->mu_least, s->mu_rope);
        c->mu_largest = fmax(c->mu_largest, s->mu_rope);
        if (isnan(rope_mu)) continue;
        s->mu_rope = s->mu_rope_static = rope_mu;
        if (scene->def.strand.rope) s->mu = s->mu_static = rope_mu;
    }
}

/* How the cables lie in the ducts; what friction and weight they make is in the stretches. */
static hawser_status cables_set(const Scene *scene, Calculator *c, hawser_error *err)
{
    const SceneDef *const def = &scene->def;
    c->duct = calloc((size_t)def->n_surfaces + 1, sizeof *c->duct);
    hawser_status status = c->duct ? stretches_find(scene, &c->stretches, err) : error_memory(err);
    if (!status) status = friction_set(scene, &c->stretches, err);
    if (!status) status = ends_extend(scene, &c->stretches, err);
    if (!status) frictions_find(scene, c);
    for (int i = 0; i < def->n_surfaces && !status; ++i) {
        if (def->surfaces[i].shape.kind != SURFACE_DUCT) continue;
        c->duct[c->n_ducts].surface = &def->surfaces[i];
        status = bundle_in(def, &def->surfaces[i], &c->duct[c->n_ducts++].load, err);
    }
    return status;
}

/* The pushers of a calculator and what each pushes with, one way. */
typedef struct Pushing {
    const Scene *scene;
    const Calculator *c;
    PullStep *push; /* [c->n_pushers] */
} Pushing;

static double pusher_push(void *of, int i, double arriving)
{
    const Pushing *const p = of;
    const Pusher *const by = &p->c->pusher[i];
    return p->push[i].force = by->room->kind->push(by->room, p->scene, by->item, arriving, INFINITY);
}

/* The pushes in one pull, with cable in all of them: each takes what the ones before it leave. One that the pull does
 * not reach has what arrives at its end. */
static hawser_status pushes_find(const Scene *scene, Calculator *c, int way, hawser_error *err)
{
    const DuctLoad single = {.weight_factor = 1, .sidewall_factor = 1};
    const PlanPullDef whole = {.way = way, .whole = 1};
    PullStep *const push = c->push[way];
    Pushing pushing = {scene, c, push};
    const PushLaw law = {pusher_push, &pushing};
    PlanDef def = c->def;
    Pull pull;
    if (c->n_pushers == 0) return HAWSER_OK;
    for (int i = 0; i < c->n_pushers; ++i) push[i] = (PullStep){.at = c->pusher[i].at, .force = NAN};
    def.push = def.push_back = push;
    def.pushes = &law;
    def.enough = 0; /* the pushes to come may take it off */
    const hawser_status status = plan_pull(&def, &single, &whole, &pull, err);
    if (status) return status;
    for (int i = 0; i < c->n_pushers; ++i)
        if (isnan(push[i].force)) pusher_push(&pushing, i, pull_at(&pull, push[i].at).tension);
    pull_clear(&pull);
    return HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------ rollers, rules */

static int compare_places(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* A length of the route: of a piece, or of a bend that several make. */
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

/* The places, rising, of the carriers, or of the guides, that bear what is on the part; returns how many. */
static int places_on(const Scene *scene, int guides, Part on, double *s)
{
    int n = 0;
    for (int i = 0; i < scene->def.n_rollers; ++i) {
        const RollerDef *const r = &scene->def.rollers[i];
        if (isnan(r->s) || r->s < on.from || r->s > on.to || roller_is_guide(&scene->route, r) != guides) continue;
        if (r->hold_down || (guides && guide_stands_outside(&scene->route, r))) continue;
        s[n++] = r->s;
    }
    qsort(s, (size_t)n, sizeof *s, compare_places);
    return n;
}

/* The largest gap between neighbours that reaches into the part and holds no duct or tray; s[n] rises. One alone has
 * the whole of the part that it stands on. */
static double gap_on(const SceneDef *def, Part part, int n, const double *s)
{
    double gap = 0;
    for (int i = 0; i + 1 < n; ++i) {
        const int on = s[i + 1] > part.from && s[i] < part.to;
        if (on && !surface_at(def, (s[i] + s[i + 1]) / 2)) gap = fmax(gap, s[i + 1] - s[i]);
    }
    const int alone = n > 0 && !(s[n - 1] > s[0]) && s[0] >= part.from && s[0] <= part.to;
    return alone && !surface_at(def, s[0]) ? part.to - part.from : gap;
}

/* The nearest carrier on either side of a bend in which none stands. */
static void bearers_add(const Scene *scene, Part bend, int piece, Calculator *c)
{
    int nearest[2] = {-1, -1}; /* behind it, ahead of it */
    for (int r = 0; r < scene->def.n_rollers; ++r) {
        const RollerDef *const roller = &scene->def.rollers[r];
        if (isnan(roller->s)) continue;
        const int ahead = roller->s > bend.to, known = nearest[ahead];
        const double sign = ahead ? -1 : 1;
        const int nearer = known < 0 || sign * (roller->s - scene->def.rollers[known].s) > 0;
        if (nearer && !roller_is_guide(&scene->route, roller)) nearest[ahead] = r;
    }
    for (int k = 0; k < 2; ++k)
        if (nearest[k] >= 0) c->bearer[c->n_bearers++] = (Bearer){piece, nearest[k]};
}

/* The neighbours of the carrier at s among those at place[n], rising, the ends of ducts and trays, and the route's, at
 * which something else has the cable. Returns how many of them are ends; -1: it stands at or beyond one. */
static int neighbours_of(const SceneDef *def, double s, double length, int n, const double *place, double near[2])
{
    int low = 0, high = n; /* the first that is not before s */
    while (low < high) {
        const int middle = (low + high) / 2;
        if (place[middle] < s)
            low = middle + 1;
        else
            high = middle;
    }
    while (high < n && place[high] <= s) high++;
    near[0] = low > 0 ? place[low - 1] : 0;
    near[1] = high < n ? place[high] : length;
    int ends = (low == 0) + (high == n);
    for (int k = 0; k < def->n_surfaces; ++k) {
        const SurfaceShape *const on = &def->surfaces[k].shape;
        if (!surface_along_route(&def->surfaces[k])) continue;
        if (on->from <= s && on->to >= s) return -1;
        if (on->to < s && on->to > near[0]) near[0] = on->to, ++ends;
        if (on->from > s && on->from < near[1]) near[1] = on->from, ++ends;
    }
    return s > near[0] && s < near[1] ? ends : -1;
}

/* (T18a) of the rated carriers on straights beside bends, and of those next to an end; guides have what goes
 * aside. */
static void beside_find(const Scene *scene, int n, const double *place, Calculator *c)
{
    const Route *const route = &scene->route;
    for (int r = 0; r < scene->def.n_rollers; ++r) {
        const RollerDef *const roller = &scene->def.rollers[r];
        const double s = roller->s;
        double near[2];
        if (isnan(s) || !(roller->rating > 0) || roller->hold_down || roller_is_guide(route, roller)) continue;
        const RoutePoint at = route_at(route, s);
        const int ends = neighbours_of(&scene->def, s, route->length, n, place, near);
        if (ends < 0 || (route->piece[at.piece].kind != ROUTE_STRAIGHT && ends == 0)) continue;
        Vec3 turn = V3_ZERO;
        int bend = route->piece[at.piece].kind != ROUTE_STRAIGHT ? at.piece : -1, bare = 1;
        for (int k = 0; k < 2; ++k) {
            const RoutePoint next = route_at(route, near[k]);
            if (route->piece[next.piece].kind != ROUTE_STRAIGHT) bend = next.piece;
            bare &= !surface_at(&scene->def, (s + near[k]) / 2);
            turn = v3_add(turn, v3_unit(v3_sub(next.position, at.position)));
        }
        if ((bend < 0 && ends == 0) || !bare) continue;
        const Vec3 left = route_left(route, s), up = v3_cross(at.tangent, left);
        const double aside = bend >= 0 && c->guides[bend] > 0 ? 0 : v3_dot(turn, left);
        c->beside[c->n_beside++] = (Beside){r, s, -v3_dot(turn, up), aside, (near[1] - near[0]) / 2 * up.z};
    }
}

/* Carriers along the whole route; guides only bend by bend, since there are none between bends. */
static hawser_status spacings_find(const Scene *scene, Calculator *c, hawser_error *err)
{
    const SceneDef *const def = &scene->def;
    const Route *const route = &scene->route;
    double *const s = malloc(((size_t)def->n_rollers + 1) * sizeof *s);
    c->spacing = calloc((size_t)route->n, sizeof *c->spacing);
    c->guides = calloc((size_t)route->n, sizeof *c->guides);
    c->bearer = calloc(2 * (size_t)route->n, sizeof *c->bearer);
    c->beside = calloc((size_t)def->n_rollers + 1, sizeof *c->beside);
    if (!s || !c->spacing || !c->guides || !c->bearer || !c->beside) {
        free(s);
        return error_memory(err);
    }
    const int carriers = places_on(scene, 0, (Part){-INFINITY, INFINITY}, s);
    for (int k = 0; k < route->n; ++k) c->spacing[k] = gap_on(def, part_of(route, k, k), carriers, s);
    for (int p = 0, to; p < route->n; p = to + 1) {
        to = route_turn_end(route, p);
        const Part bend = part_of(route, p, to);
        const int guides = places_on(scene, 1, bend, s);
        const int alone = guides > 0 && !(s[guides - 1] > s[0]) && route->piece[p].kind != ROUTE_STRAIGHT;
        const double gap = alone ? INFINITY : gap_on(def, bend, guides, s);
        for (int k = p; k <= to; ++k) c->guides[k] = gap;
        if (guides == 0 && places_on(scene, 0, bend, s) == 0 && route->piece[p].kind != ROUTE_STRAIGHT)
            bearers_add(scene, bend, p, c);
    }
    beside_find(scene, places_on(scene, 0, (Part){-INFINITY, INFINITY}, s), s, c);
    free(s);
    return HAWSER_OK;
}

/* By the spans of the pull, which lie inside pieces. */
static hawser_status rules_find(const Scene *scene, Calculator *c, hawser_error *err)
{
    c->rule = calloc((size_t)scene->route.n, sizeof *c->rule);
    if (!c->rule) return error_memory(err);
    const Pull *const pull = &c->plan.way[PLAN_FORWARD].pull; /* a piece's spans follow each other */
    for (int i = 0; i < pull->n; ++i) {
        const int p = pull->span[i].piece, first = i == 0 || pull->span[i - 1].piece != p;
        const SupportRule rule = pull->span[i].law.separate ? SUPPORT_SEPARATE : SUPPORT_RESULTANT;
        c->rule[p] = first || c->rule[p] == rule ? rule : SUPPORT_MIXED;
    }
    return HAWSER_OK;
}

/* ---------------------------------------------------------------------------------------------- the whole */

/* Machines and pits, and `more` of that sort to come. */
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

/* Of the rope ahead, N/m: as given, or the chain's. */
static double rope_weight(const SceneDef *def)
{
    const double given = def->theory.rope_mass, g = v3_norm(def->gravity);
    if (!isnan(given)) return given * g;
    double most = 0;
    for (int p = scene_def_eye(def); p < def->n_pieces; ++p)
        most = fmax(most, def->cables[def->pieces[p].cable].mass * g);
    return most;
}

/* Of the cable's lightest piece, N/m; 0: all weigh the same. */
static double lightest_of(const Scene *scene)
{
    const SceneDef *const def = &scene->def;
    double least = INFINITY;
    for (int p = 0; p < scene_def_eye(def); ++p)
        least = fmin(least, def->cables[def->pieces[p].cable].mass * v3_norm(def->gravity));
    return least < scene->cable_weight * (1 - 1e-9) ? least : 0;
}

/* The tension at the start, the reel's and the rope's allowances, friction by the length pulled. */
static void plan_set(const Scene *scene, const Expected *expected, Calculator *c)
{
    const TheoryDef *const theory = &scene->def.theory;
    c->def.reel_length = theory->reel;
    c->def.rope_length = theory->rope;
    c->def.back_tension = fmax(0, expected->largest_start);
    c->def.back_fall = fmin(expected->start_fall, c->def.back_tension);
    const Behind behind = starts_behind(scene);
    c->def.behind = behind.first;
    c->def.behind_least = behind.last;
    c->def.behind_slides = behind.slides;
    c->def.lightest = lightest_of(scene);
    c->def.feed = theory->feed;
    c->def.rope_force = scene->def.drag.force;
    memcpy(c->def.drawn, theory->drawn, sizeof c->def.drawn);
    c->def.rope_weight = rope_weight(&scene->def);
    c->def.n_wear = theory->n_wear;
    c->def.wear = theory->wear;
    c->def.wear_by = (WearKind)theory->wear_by;
}

/* What the arrays are by now. */
static void plan_borrow(Calculator *c)
{
    c->def.route = c->route;
    c->def.n_stretches = c->stretches.n;
    c->def.stretch = c->stretches.stretch;
    c->def.spacing = c->spacing;
    c->def.guides = c->guides;
    c->def.n_pushes = c->n_pushers;
    c->def.push = c->push[PLAN_FORWARD];
    c->def.push_back = c->push[PLAN_BACKWARD];
    c->def.step = c->step;
}

/* Pushes, plan, the head's places no farther apart than `apart` (m; INFINITY: their peaks alone; NAN: they are not
 * asked for), limits. */
static hawser_status solve(const Scene *scene, double apart, Calculator *c, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < PLAN_WAYS && !status; ++k) {
        c->push[k] = calloc((size_t)c->n_pushers + 1, sizeof *c->push[k]);
        if (!c->push[k]) status = error_memory(err);
        plan_borrow(c);
        if (!status && !c->def.skip[k]) status = pushes_find(scene, c, k, err);
    }
    if (!status) status = plan_build(&c->def, &c->plan, err);
    for (int k = 0; k < PLAN_WAYS && !status; ++k) {
        if (c->def.skip[k] || isnan(apart)) continue;
        status = apart < INFINITY ? plan_heads(&c->def, &c->plan.duct, k, apart, &c->heads[k], err)
                                  : plan_peaks(&c->def, &c->plan.duct, k, &c->heads[k], err);
    }
    for (int k = 0; k < PLAN_WAYS && !status; ++k) {
        double relief = 0;
        if (!c->def.skip[k] && !isnan(apart)) status = plan_relief(&c->def, &c->plan.duct, k, &relief, err);
        c->beyond[k] = c->plan.way[k].rope - c->def.drawn[k] - relief;
    }
    return status ? status : calculator_judge(scene, c, err);
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

enum { HEAD_PLACES = 40 }; /* of the head between the ends of the route, at least */

hawser_status calculator_build(const Scene *scene, const Expected *expected, int forward_only, Calculator *out,
                               hawser_error *err)
{
    *out = (Calculator){.cables = scene->def.bundle.shape.cables, .route = &scene->route};
    out->def.skip[PLAN_BACKWARD] = forward_only;
    hawser_status status = weight_check(&scene->def, err);
    if (!status) status = cables_set(scene, out, err);
    if (!status) status = spacings_find(scene, out, err);
    if (!status) status = steps_set(&scene->def.theory, 0, out, err);
    if (!status) out->n_pushers = scene_pushers(scene, &out->pusher);
    if (!status && out->n_pushers < 0) status = error_memory(err);
    plan_set(scene, expected, out);
    if (!status) status = turners_find(scene, out->route, &out->n_turners, &out->turner, err);
    if (!status) status = solve(scene, scene->route.length / HEAD_PLACES, out, err);
    if (!status) status = rules_find(scene, out, err);
    if (!status) status = calculator_know(scene, out, err);
    return status ? status : calculator_follow(scene, out, err);
}

/* ------------------------------------------------------------------------------------------- variations */

/* The place of another route that s is on this one: the same share of the same piece. */
static double place_on(const Route *other, const Route *route, double s)
{
    if (!(s > 0)) return s;
    if (s >= route->length) return s - route->length + other->length;
    const int p = route_at(route, s).piece;
    const RoutePiece *const here = &route->piece[p], *const there = &other->piece[p];
    return there->s0 + (s - here->s0) * there->length / here->length;
}

/* Makes what bends so many times as large. */
static void piece_grow(RoutePieceDef *piece, double times)
{
    piece->radius *= times;
    if (piece->kind == ROUTE_CURVE) piece->length *= times;
    for (int end = 0; end < 2; ++end) piece->curvature[end] /= times;
    for (int i = 0; i < 3; ++i) piece->cubic[i] = v3_scale(times, piece->cubic[i]);
}

/* The scene's route with other radii; angles stay, lengths follow. */
static hawser_status route_vary(const Scene *scene, const Variation *by, Route *out, hawser_error *err)
{
    const SceneDef *const def = &scene->def;
    RoutePieceDef *const piece = malloc((size_t)def->n_route * sizeof *piece);
    if (!piece) return error_memory(err);
    for (int p = 0, last = -1, meant = 0; p < def->n_route; ++p) {
        if (p > last) { /* a bend is one in whatever parts it is drawn */
            last = route_turn_end(&scene->route, p);
            meant = by->bend < 0 || (by->bend >= p && by->bend <= last);
        }
        piece[p] = def->route[p];
        if (meant) piece_grow(&piece[p], by->radius);
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

/* What the base has along its route, in the same places of the other one. */
static hawser_status places_vary(const Calculator *base, const Variation *by, Calculator *c, hawser_error *err)
{
    const int n = base->plan.n;
    c->stretches = (Stretches){base->stretches.n,
                               copy_of(base->stretches.stretch, base->stretches.n, sizeof *c->stretches.stretch)};
    c->pusher = copy_of(base->pusher, base->n_pushers, sizeof *c->pusher);
    c->spacing = copy_of(base->spacing, n, sizeof *c->spacing);
    c->guides = copy_of(base->guides, n, sizeof *c->guides);
    c->duct = copy_of(base->duct, base->n_ducts, sizeof *c->duct);
    c->bearer = copy_of(base->bearer, base->n_bearers, sizeof *c->bearer);
    c->beside = copy_of(base->beside, base->n_beside, sizeof *c->beside);
    c->turner = copy_of(base->turner, base->n_turners, sizeof *c->turner);
    if (!c->stretches.stretch || !c->pusher || !c->spacing || !c->guides || !c->duct || !c->bearer || !c->beside ||
        !c->turner)
        return error_memory(err);
    c->n_turners = base->n_turners;
    c->n_bearers = base->n_bearers;
    c->n_beside = base->n_beside;
    c->n_pushers = base->n_pushers;
    c->n_ducts = base->n_ducts;
    for (int i = 0; i < c->stretches.n; ++i) {
        PullStretch *const s = &c->stretches.stretch[i];
        s->from = place_on(c->route, base->route, s->from);
        s->mu *= by->friction;
        s->mu_static *= by->friction;
        s->mu_rope *= by->friction;
        s->mu_rope_static *= by->friction;
    }
    for (int i = 0; i < c->n_turners; ++i) c->turner[i].s = place_on(c->route, base->route, c->turner[i].s);
    for (int i = 0; i < c->n_beside; ++i) c->beside[i].s = place_on(c->route, base->route, c->beside[i].s);
    for (int i = 0; i < c->n_pushers; ++i) {
        c->pusher[i].at = place_on(c->route, base->route, c->pusher[i].at);
        c->pusher[i].from = place_on(c->route, base->route, c->pusher[i].from);
    }
    for (int i = 0; i < c->def.n_steps; ++i) c->step[i].at = place_on(c->route, base->route, c->step[i].at);
    return HAWSER_OK;
}

/* Whether a limit asks for what the winch needs, wherever the head is: of rope, winch or trip. */
static int peaks_count(const Scene *scene)
{
    const LimitsDef *const limits = &scene->def.limits;
    return !isnan(limits->rope_strength) || !isnan(limits->winch_capacity) || scene->def.winch.trip.force > 0 ||
           scene->def.winch.trip.factor > 0;
}

hawser_status calculator_vary(const Scene *scene, const Calculator *base, const Variation *by, Calculator *out,
                              hawser_error *err)
{
    const double apart = peaks_count(scene) ? INFINITY : NAN;
    *out = (Calculator){.cables = base->cables, .route = base->route, .def = base->def};
    memcpy(out->known, base->known, sizeof out->known);
    out->def.n_steps = 0;
    out->def.beyond = by->beyond;
    out->def.enough = by->enough;
    out->def.skip[!by->way] = 1;
    hawser_status status = HAWSER_OK;
    if (by->radius != 1) {
        status = route_vary(scene, by, &out->own, err);
        out->route = &out->own;
    }
    if (!status) status = steps_set(&scene->def.theory, by->n_machines, out, err);
    if (!status) status = places_vary(base, by, out, err);
    for (int i = 0; i < by->n_machines && !status; ++i)
        out->step[out->def.n_steps++] = (PullStep){by->machine[i], by->push, STEP_TAKE};
    return status ? status : solve(scene, apart, out, err);
}

void calculator_free(Calculator *c)
{
    plan_clear(&c->plan);
    stretches_free(&c->stretches);
    for (int k = 0; k < PLAN_WAYS; ++k) {
        free(c->push[k]);
        plan_heads_free(&c->heads[k]);
    }
    route_clear(&c->own);
    free(c->pusher);
    free(c->step);
    free(c->spacing);
    free(c->guides);
    free(c->bearer);
    free(c->beside);
    free(c->turner);
    free(c->rule);
    free(c->duct);
    *c = (Calculator){0};
}
