#include "sim/expected/calculator.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/base/error.h"

static const CableDef *cable_of(const Scene *scene)
{
    return &scene->def.cables[scene->def.pieces[scene->piece[scene->eye - 1]].cable];
}

/* --------------------------------------------------------------------------------- cables, ducts, pushes */

/* How the cables lie in a duct; an error names it. */
static hawser_status duct_fill(const Scene *scene, const SurfaceDef *surface, CalculatorDuct *out, hawser_error *err)
{
    const DuctDef def = {.duct_diameter = 2 * surface->shape.radius,
                         .cable_diameter = cable_of(scene)->diameter,
                         .cables = scene->def.theory.cables,
                         .layout = (DuctLayout)scene->def.theory.layout};
    hawser_error why = {.message = ""};
    out->surface = surface;
    const hawser_status status = duct_load(&def, &out->load, &why);
    if (!status) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT, "key 'theory.cables': duct '%s': %s", surface->name, why.message);
}

static const DuctLoad *load_in(const Calculator *c, const SurfaceDef *surface)
{
    for (int i = 0; i < c->n_ducts; ++i) {
        if (c->duct[i].surface == surface) return &c->duct[i].load;
    }
    return NULL;
}

/* Several cables: all their weight; in ducts more friction and an unequal share of T/R (T20), (T21), elsewhere each
 * bears its own. */
static hawser_status cables_set(const Scene *scene, Calculator *c, hawser_error *err)
{
    const SceneDef *const def = &scene->def;
    c->duct = calloc((size_t)def->n_surfaces + 1, sizeof *c->duct);
    hawser_status status = c->duct ? stretches_find(scene, &c->stretches, err) : error_memory(err);
    for (int i = 0; i < def->n_surfaces && !status; ++i) {
        if (def->surfaces[i].shape.kind != SURFACE_DUCT) continue;
        status = duct_fill(scene, &def->surfaces[i], &c->duct[c->n_ducts++], err);
    }
    for (int i = 0; i < c->stretches.n && !status; ++i) {
        PullStretch *const s = &c->stretches.stretch[i];
        const double middle = i + 1 < c->stretches.n ? (s->from + s[1].from) / 2 : s->from + 1;
        const DuctLoad *const load = load_in(c, surface_at(def, middle));
        s->weight *= c->cables;
        s->share = load ? load->sidewall_factor : 1.0 / c->cables;
        if (!load) continue;
        s->mu *= load->weight_factor;
        s->mu_static *= load->weight_factor;
    }
    return status;
}

/* The pushes one by one along the pull: each takes what the ones before it leave. */
static hawser_status pushes_find(const Scene *scene, const PlanDef *plan, const Pusher *by, int way, PullStep *push,
                                 hawser_error *err)
{
    const int n = plan->n_pushes, back = way == PLAN_BACKWARD;
    PullStep *const step = calloc((size_t)n + 1, sizeof *step);
    if (!step) return error_memory(err);
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < n && !status; ++k) {
        const int i = back ? n - 1 - k : k;
        const double w = plan->stretch[0].weight;
        const PullDef def = {.route = plan->route,
                             .from = back ? plan->route->length : 0,
                             .to = back ? 0 : plan->route->length,
                             .start_tension = plan->back_tension + w * plan->reel_length,
                             .n_stretches = plan->n_stretches,
                             .stretch = plan->stretch,
                             .n_steps = k,
                             .step = step};
        Pull pull;
        push[i] = (PullStep){.at = by[i].at};
        status = pull_solve(&def, &pull, err);
        if (status) break;
        push[i].force = by[i].room->kind->push(by[i].room, scene, by[i].item, pull_at(&pull, push[i].at).tension);
        step[k] = (PullStep){.at = push[i].at, .force = -push[i].force};
        pull_clear(&pull);
    }
    free(step);
    return status;
}

/* ------------------------------------------------------------------------------------------ rollers, rules */

static int compare_places(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The largest gap between neighbours that reaches into the piece and holds no duct or tray; s[n] rises. */
static double gap_on(const SceneDef *def, const RoutePiece *piece, int n, const double *s)
{
    double gap = 0;
    for (int i = 0; i + 1 < n; ++i) {
        const int on = s[i + 1] > piece->s0 && s[i] < piece->s0 + piece->length;
        if (on && !surface_at(def, (s[i] + s[i + 1]) / 2)) gap = fmax(gap, s[i + 1] - s[i]);
    }
    return gap;
}

/* Carriers along the whole route; guides only piece by piece, since there are none between bends. */
static hawser_status spacings_find(const Scene *scene, Calculator *c, hawser_error *err)
{
    const SceneDef *const def = &scene->def;
    double *const s = malloc(((size_t)def->n_rollers + 1) * sizeof *s);
    c->spacing = calloc((size_t)scene->route.n, sizeof *c->spacing);
    c->guides = calloc((size_t)scene->route.n, sizeof *c->guides);
    if (!s || !c->spacing || !c->guides) {
        free(s);
        return error_memory(err);
    }
    for (int p = -1; p < scene->route.n; ++p) { /* -1: the carriers */
        int n = 0;
        for (int i = 0; i < def->n_rollers; ++i) {
            const RollerDef *const r = &def->rollers[i];
            if (isnan(r->s) || roller_is_guide(&scene->route, r) != (p >= 0)) continue;
            if (p < 0 || route_at(&scene->route, r->s).piece == p) s[n++] = r->s;
        }
        qsort(s, (size_t)n, sizeof *s, compare_places);
        if (p >= 0) c->guides[p] = gap_on(def, &scene->route.piece[p], n, s);
        for (int k = 0; p < 0 && k < scene->route.n; ++k) c->spacing[k] = gap_on(def, &scene->route.piece[k], n, s);
    }
    free(s);
    return HAWSER_OK;
}

/* By the spans of the pull, which lie inside pieces. */
static hawser_status rules_find(const Scene *scene, Calculator *c, hawser_error *err)
{
    c->rule = calloc((size_t)scene->route.n, sizeof *c->rule);
    if (!c->rule) return error_memory(err);
    for (int p = 0; p < scene->route.n; ++p) {
        int seen[2] = {0, 0};
        const Pull *const pull = &c->plan.way[PLAN_FORWARD].pull;
        for (int i = 0; i < pull->n; ++i) {
            if (pull->span[i].piece == p) seen[pull->span[i].law.separate != 0] = 1;
        }
        c->rule[p] = seen[1] ? seen[0] ? SUPPORT_MIXED : SUPPORT_SEPARATE : SUPPORT_RESULTANT;
    }
    return HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------------- limits */

/* The route's own smallest radius. */
static Finding bend_finding(const Route *route)
{
    Finding f = {.value = INFINITY};
    for (int p = 0; p < route->n; ++p) {
        const RoutePiece *const piece = &route->piece[p];
        if (piece->kind != ROUTE_STRAIGHT && piece->radius < f.value) f = finding_at(route, piece->radius, piece->s0);
    }
    return f;
}

/* The rated roller whose piece loads it most for its rating. */
static Finding roller_finding(const Scene *scene, const PlanWay *way)
{
    Finding worst = {.value = NAN};
    for (int r = 0; r < scene->def.n_rollers; ++r) {
        const RollerDef *const roller = &scene->def.rollers[r];
        if (isnan(roller->s) || !(roller->rating > 0)) continue;
        const double load = way->piece[route_at(&scene->route, roller->s).piece].roller_load;
        if (load > 0) finding_load(&worst, roller->name, load, roller->rating);
    }
    return worst;
}

static void limits_set(const Scene *scene, Calculator *c)
{
    const Route *const route = &scene->route;
    for (int k = 0; k < PLAN_WAYS; ++k) {
        const PlanWay *const way = &c->plan.way[k];
        Finding f[LIMIT_KINDS] = {[LIMIT_ROLLER_PEAK] = {.absent = 1}, [LIMIT_ALPHA] = {.absent = 1}};
        f[LIMIT_PULL] = finding_at(route, way->pull.max_tension, way->pull.max_at);
        f[LIMIT_RESTART] = finding_at(route, way->restart_max, way->restart_at);
        f[LIMIT_SIDEWALL] = finding_at(route, way->pull.max_sidewall, way->pull.sidewall_at);
        if (!(way->pull.max_sidewall > 0)) *f[LIMIT_SIDEWALL].where = 0;
        f[LIMIT_BEND] = bend_finding(route);
        f[LIMIT_ROLLER_STEADY] = roller_finding(scene, way);
        f[LIMIT_ROPE].value = fmax(way->force, way->restart_force);
        limits_duct(&scene->def.limits, c->cables, NULL, NULL, f);
        for (int i = 0; i < c->n_ducts; ++i)
            limits_duct(&scene->def.limits, c->cables, c->duct[i].surface->name, &c->duct[i].load, f);
        c->n_limits = limits_judge(&scene->def.limits, cable_of(scene)->diameter, c->cables, f, c->limit[k]);
    }
}

/* ---------------------------------------------------------------------------------------------- the whole */

/* The tension at the start, the reel's and the rope's allowances, one set of pushes for each way. */
static hawser_status plan_fill(const Scene *scene, double start_tension, Calculator *c, hawser_error *err)
{
    const SceneDef *const def = &scene->def;
    PlanDef plan = {.route = &scene->route,
                    .n_stretches = c->stretches.n,
                    .stretch = c->stretches.stretch,
                    .reel_length = def->theory.reel,
                    .rope_length = def->theory.rope,
                    .back_tension = fmax(0, c->cables * start_tension),
                    .rope_force = def->drag.force,
                    .spacing = c->spacing,
                    .guides = c->guides};
    hawser_status status = HAWSER_OK;
    c->n_pushers = plan.n_pushes = scene_pushers(scene, &c->pusher);
    if (c->n_pushers < 0) return error_memory(err);
    for (int k = 0; k < PLAN_WAYS && !status; ++k) {
        c->push[k] = calloc((size_t)c->n_pushers + 1, sizeof *c->push[k]);
        status = c->push[k] ? pushes_find(scene, &plan, c->pusher, k, c->push[k], err) : error_memory(err);
    }
    plan.push = c->push[PLAN_FORWARD];
    plan.push_back = c->push[PLAN_BACKWARD];
    return status ? status : plan_build(&plan, &c->plan, err);
}

/* A cable cannot be pushed: where theory finds compression it slackens or runs away down a slope, and no figure behind
 * that place holds. A back tension as large as the compression prevents it, wherever bends lie. */
static void pulled_set(Calculator *c)
{
    for (int k = 0; k < PLAN_WAYS; ++k) {
        const PlanWay *const way = &c->plan.way[k];
        hawser_condition *const held = &c->pulled[k];
        const double pushed = fmax(0, -way->pull.min_tension);
        double allowed =
            1e-9 * fmax(1, way->pull.max_tension); /* rounding; a machine may push a cable ahead of itself */
        for (int i = 0; i < c->n_pushers; ++i) allowed = fmax(allowed, c->push[k][i].force);
        *held = (hawser_condition){
            .name = "pulled", .unit = "N", .value = pushed, .allowed = allowed, .holds = pushed <= allowed};
        snprintf(
            held->remedy, sizeof held->remedy,
            "the cable would run away or slacken: at %.4g m it would have to be pushed with %.4g kN; it needs a brake "
            "or back tension of up to %.4g kN more where the pull begins",
            way->pull.min_at, pushed / 1e3, pushed / 1e3);
    }
}

hawser_status calculator_build(const Scene *scene, double start_tension, Calculator *out, hawser_error *err)
{
    *out = (Calculator){.cables = scene->def.theory.cables};
    hawser_status status = cables_set(scene, out, err);
    if (!status) status = spacings_find(scene, out, err);
    if (!status) status = plan_fill(scene, start_tension, out, err);
    if (!status) status = rules_find(scene, out, err);
    if (!status) limits_set(scene, out);
    if (!status) pulled_set(out);
    return status;
}

void calculator_free(Calculator *c)
{
    plan_clear(&c->plan);
    stretches_free(&c->stretches);
    for (int k = 0; k < PLAN_WAYS; ++k) free(c->push[k]);
    free(c->pusher);
    free(c->spacing);
    free(c->guides);
    free(c->rule);
    free(c->duct);
    *c = (Calculator){0};
}
