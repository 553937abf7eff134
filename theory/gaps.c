/* Whether the cable sags too far where nothing carries it: it would press on its supports with other angles than the
 * route has, or fall. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "theory/calculator.h"

static const double SPAN = 5;  /* m without anything that carries, from which on it is asked how far the cable sags */
static const double SAG = 0.1; /* of that length */
enum { PLACES = 8 };           /* at which a span is compared with its chord */

typedef struct Span {
    double from, to; /* m along the route */
} Span;

/* Whether the cable comes to lie on a floor before it has left the route by more than its size and half a metre. */
static int has_floor(const Supports *map, Span span)
{
    const Vec3 at = route_at(map->route, (span.from + span.to) / 2).position;
    const double thick = bundle_diameter(map->def);
    return supports_floor(map, at, -thick, SAG * SPAN + thick) != NULL;
}

/* How far the route leaves the straight line between both ends of a span, m; 0 where a roller holds its bend. */
static double off_chord(const Supports *map, Span span)
{
    const Route *const route = map->route;
    for (int i = supports_from(map, span.from); i < map->n_rollers && map->roller[i].s < span.to; ++i)
        if (map->roller[i].inner > 0 && map->roller[i].s > span.from) return 0;
    const Vec3 a = route_at(route, span.from).position, along = v3_unit(v3_sub(route_at(route, span.to).position, a));
    double most = 0;
    for (int k = 1; k < PLACES; ++k) {
        const Vec3 p = route_at(route, span.from + (span.to - span.from) * k / PLACES).position;
        most = fmax(most, v3_norm(v3_reject(v3_sub(p, a), along)));
    }
    return most;
}

/* The next span without anything that carries, from `from` (m) on; 0: there is none. */
static int next_span(const Supports *map, double from, Span *out)
{
    out->from = supports_covered(map, from);
    if (!(out->from < map->route->length)) return 0;
    out->to = supports_next(map, out->from);
    return 1;
}

/* As a string and a beam on two supports, m: (T29). */
static double sag_of(const Setup *setup, const Route *route, const Pull *pull, Span span)
{
    const SceneDef *const def = setup->def;
    const double length = span.to - span.from, middle = (span.from + span.to) / 2;
    const double rise = route_at(route, middle).tangent.z, across = sqrt(fmax(0, 1 - rise * rise));
    double stiff = INFINITY;
    for (int p = 0; p < scene_def_eye(def); ++p) stiff = fmin(stiff, def->cables[def->pieces[p].cable].ei_z);
    const double held = fmax(0, pull_at(pull, middle).tension) + 9.6 * fmax(0, stiff) / (length * length);
    return setup->cable_weight * across * length * length / (8 * held);
}

/* The spans of one way, with the least tension that it has; without the script's friction if it takes some away. */
static hawser_status way_judge(const Setup *setup, const Calculator *c, int way, hawser_condition *out,
                               hawser_error *err)
{
    const Supports *const map = &setup->supports;
    const PlanPullDef whole = {.way = way, .whole = 1};
    PlanDef loose;
    PullStretch *own;
    Pull pull;
    hawser_status status = calculator_loosen(setup, c, &loose, &own, err);
    const PlanDef slack = plan_slack(&loose);
    if (!status) status = plan_pull(&slack, &whole, &pull, err);
    free(own);
    if (status) return status;
    for (Span span = {0, 0}; next_span(map, span.to, &span);) {
        const double from = span.from, to = span.to;
        if (!(to - from > SPAN) || has_floor(map, span)) continue;
        const double sag = fmax(sag_of(setup, c->route, &pull, span), off_chord(map, span)) / (to - from);
        if (!(sag > out->value)) continue;
        out->value = sag;
        out->holds = sag <= SAG;
        snprintf(out->remedy, sizeof out->remedy,
                 "nothing carries the cable between %.1f and %.1f m, where it would be %.3g m off the route, or fall: "
                 "give what carries it",
                 from, to, sag * (to - from));
    }
    pull_clear(&pull);
    return HAWSER_OK;
}

/* Whether there is a span of that length at all. */
static int has_span(const Supports *map)
{
    for (Span span = {0, 0}; next_span(map, span.to, &span);)
        if (span.to - span.from > SPAN) return 1;
    return 0;
}

hawser_status gaps_judge(const Setup *setup, const Calculator *c, hawser_condition *out, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    out->allowed = SAG;
    for (int k = 0; k < PLAN_WAYS && !status && has_span(&setup->supports); ++k)
        if (!c->def.skip[k]) status = way_judge(setup, c, k, out, err);
    return status;
}
