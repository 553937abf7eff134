/* Whether the cable sags too far where nothing carries it: it would press on its supports with other angles than the
 * route has, or fall. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "sim/expected/calculator.h"

static const double SPAN = 5;   /* m without anything that carries, from which on it is asked how far the cable sags */
static const double SAG = 0.1;  /* of that length */
static const double LEVEL = .7; /* of a floor's normal, upward */
enum { PLACES = 8 };            /* at which a span is compared with its chord */

typedef struct Span {
    double from, to; /* m along the route */
} Span;

/* What covers a length of the route: ducts and trays, and what pushes, from where it begins to as far behind its
 * middle. Returns 0 where there are no more. */
static int cover(const SceneDef *def, const Calculator *c, int k, Span *out)
{
    if (k >= def->n_surfaces + c->n_pushers) return 0;
    *out = (Span){NAN, NAN};
    if (k >= def->n_surfaces) {
        const Pusher *const by = &c->pusher[k - def->n_surfaces];
        if (by->holds) *out = (Span){by->from, 2 * by->at - by->from};
    } else if (surface_along_route(&def->surfaces[k])) {
        *out = (Span){def->surfaces[k].shape.from, def->surfaces[k].shape.to};
    }
    return 1;
}

/* From s on (m), the end of what is covered without a gap. */
static double covered_to(const SceneDef *def, const Calculator *c, double s)
{
    Span on;
    for (int k = 0; cover(def, c, k, &on); ++k) {
        if (!(on.from <= s + 1e-6) || on.to <= s) continue;
        s = on.to;
        k = -1; /* another may go on from there */
    }
    return s;
}

/* Where the next thing that carries begins after s, m; `turner`: the first that is not behind it. */
static double next_carried(const SceneDef *def, const Calculator *c, double s, int *turner)
{
    double next = c->route->length;
    Span on;
    for (; *turner < c->n_turners; ++*turner) {
        const Turner *const t = &c->turner[*turner];
        if (t->s > s && t->carries && !(t->off.z > 0)) break;
    }
    if (*turner < c->n_turners) next = fmin(next, c->turner[*turner].s);
    for (int k = 0; cover(def, c, k, &on); ++k)
        if (on.from > s) next = fmin(next, on.from);
    return next;
}

/* Whether the cable comes to lie on a floor before it has left the route by more than its size and half a metre. */
static int has_floor(const SceneDef *def, const Route *route, Span span)
{
    const Vec3 at = route_at(route, (span.from + span.to) / 2).position;
    for (int k = 0; k < def->n_surfaces; ++k) {
        const SurfaceDef *const s = &def->surfaces[k];
        if (surface_along_route(s)) continue;
        const Vec3 normal = v3_unit(s->shape.normal);
        const double above = v3_dot(v3_sub(at, s->shape.point), normal);
        if (normal.z > LEVEL && above > -bundle_diameter(def) && above < SAG * SPAN + bundle_diameter(def)) return 1;
    }
    return 0;
}

/* How far the route leaves the straight line between both ends of a span, m; 0 where a roller holds its bend. */
static double off_chord(const Calculator *c, Span span)
{
    const Route *const route = c->route;
    for (int i = 0; i < c->n_turners; ++i)
        if (c->turner[i].inner > 0 && c->turner[i].s > span.from && c->turner[i].s < span.to) return 0;
    const Vec3 a = route_at(route, span.from).position, along = v3_unit(v3_sub(route_at(route, span.to).position, a));
    double most = 0;
    for (int k = 1; k < PLACES; ++k) {
        const Vec3 p = route_at(route, span.from + (span.to - span.from) * k / PLACES).position;
        most = fmax(most, v3_norm(v3_reject(v3_sub(p, a), along)));
    }
    return most;
}

/* As a string and a beam on two supports, m: (T29). */
static double sag_of(const Scene *scene, const Route *route, const Pull *pull, Span span)
{
    const SceneDef *const def = &scene->def;
    const double length = span.to - span.from, middle = (span.from + span.to) / 2;
    const double rise = route_at(route, middle).tangent.z, across = sqrt(fmax(0, 1 - rise * rise));
    double stiff = INFINITY;
    for (int p = 0; p < scene_def_eye(def); ++p) stiff = fmin(stiff, def->cables[def->pieces[p].cable].ei_z);
    const double held = fmax(0, pull_at(pull, middle).tension) + 9.6 * fmax(0, stiff) / (length * length);
    return scene->cable_weight * across * length * length / (8 * held);
}

/* The spans of one way, with the least tension that it has; without the script's friction if it takes some away. */
static hawser_status way_judge(const Scene *scene, const Calculator *c, int way, hawser_condition *out,
                               hawser_error *err)
{
    const SceneDef *const def = &scene->def;
    const PlanPullDef whole = {.way = way, .whole = 1};
    PlanDef loose;
    PullStretch *own;
    Pull pull;
    int turner = 0;
    hawser_status status = calculator_loosen(scene, c, &loose, &own, err);
    const PlanDef slack = plan_slack(&loose);
    if (!status) status = plan_pull(&slack, &c->plan.duct, &whole, &pull, err);
    free(own);
    if (status) return status;
    for (double from = covered_to(def, c, 0), to; from < c->route->length; from = covered_to(def, c, to)) {
        to = next_carried(def, c, from, &turner);
        const Span span = {from, to};
        if (!(to - from > SPAN) || has_floor(def, c->route, span)) continue;
        const double sag = fmax(sag_of(scene, c->route, &pull, span), off_chord(c, span)) / (to - from);
        if (!(sag > out->value)) continue;
        out->value = sag;
        out->holds = sag <= SAG;
        snprintf(out->remedy, sizeof out->remedy,
                 "nothing carries the cable between %.1f and %.1f m, where it would be %.3g m off the route, or fall: "
                 "give what carries it, or leave out 'run' and 'drive'",
                 from, to, sag * (to - from));
    }
    pull_clear(&pull);
    return HAWSER_OK;
}

/* Whether there is a span of that length at all. */
static int has_span(const SceneDef *def, const Calculator *c)
{
    int turner = 0;
    for (double from = covered_to(def, c, 0), to; from < c->route->length; from = covered_to(def, c, to)) {
        to = next_carried(def, c, from, &turner);
        if (to - from > SPAN) return 1;
    }
    return 0;
}

hawser_status gaps_judge(const Scene *scene, const Calculator *c, hawser_condition *out, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    out->allowed = SAG;
    for (int k = 0; k < PLAN_WAYS && !status && has_span(&scene->def, c); ++k)
        if (!c->def.skip[k]) status = way_judge(scene, c, k, out, err);
    return status;
}
