/* Whether its tension lifts the cable, or rope ahead of it, off what carries it, where the route turns upward: a run in
 * which it leaves its route so far is not trusted, and theory has it lying there. docs/model.md, "Pulling theory"
 * (T31). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "theory/calculator.h"

static const double STEP = 0.5;       /* m between places */
static const double STEEP = M_PI / 3; /* rad, of a slope over whose plan no string is looked at */
enum { MOST = 20000, FRONTS = 8 };    /* places; of the cable's front that rope is looked at with */

/* A place of the route. */
typedef struct Place {
    double s, x; /* m along the route, in plan */
    double f;    /* m, its height over a parabola that bends as the cable would */
    int held;    /* something is above it */
    int steep;
} Place;

typedef struct Places {
    const Setup *setup;
    const Calculator *c;
    Drawn drawn;
    double from;   /* m along the route: it lies ahead of that */
    double weight; /* N/m, of the lightest piece; or the rope's */
    int n;
    double step;           /* m */
    Place *place;          /* [n], each a step farther along the route */
    int *hull;             /* [n] */
    struct Places *closer; /* of rope: with the front at one place; NULL: the cable */
} Places;

typedef struct Lift {
    double by, at; /* m; m along the route */
} Lift;

static void lift_take(double by, double at, Lift *most)
{
    if (by > most->by) *most = (Lift){by, at};
}

/* ---------------------------------------------------------------------------------------------- what holds it down */

static void hold(Places *p, double from, double to)
{
    const int first = (int)fmax(0, round(from / p->step)), last = (int)fmin(p->n - 1, round(to / p->step));
    for (int i = first; i <= last; ++i) p->place[i].held = 1;
}

/* Where the cable would meet a ceiling before it is too far off. */
static void ceiling_hold(Places *p, const SurfaceShape *on)
{
    if (on->normal.z > -SUPPORT_LEVEL) return;
    for (int i = 0; i < p->n; ++i) {
        const Vec3 at = route_at(p->c->route, p->place[i].s).position;
        const double below = v3_dot(v3_sub(at, on->point), on->normal) / -on->normal.z;
        p->place[i].held |= below > 0 && below < SUPPORT_OFF_ROUTE && plane_reaches(on, at);
    }
}

/* What is above it: ducts, belts, rollers, ceilings; of rope, the cable behind it. */
static void places_hold(Places *p)
{
    const Supports *const map = &p->setup->supports;
    if (p->from > 0) hold(p, 0, p->from);
    for (int k = 0; k < map->n_planes; ++k) ceiling_hold(p, &map->plane[k]->shape);
    for (int k = 0; k < map->n_lengths; ++k)
        if (map->length[k].above) hold(p, map->length[k].from, map->length[k].to);
    for (int i = 0; i < map->n_rollers; ++i) {
        const SupportRoller *const r = &map->roller[i];
        if (r->kind == SUPPORT_HOLD_DOWN || r->off.z > 0.5) hold(p, r->s, r->s);
    }
}

/* ----------------------------------------------------------------------------------------------------- the string */

/* Heights over the plan, and over a parabola that bends by w/T, from place `first` to `last`. */
static void places_fill(Places *p, int first, int last)
{
    const Route *const route = p->c->route;
    double slope = 0, sunk = 0, x = 0;
    for (int i = first; i <= last; ++i) {
        const double s = p->step * i, before = i > first ? p->place[i - 1].s : s, middle = (s + before) / 2;
        const RoutePoint at = route_at(route, s), half = route_at(route, middle);
        const double level = fmax(hypot(half.tangent.x, half.tangent.y), 1e-3), dx = (s - before) * level;
        const double bends = p->weight / (fmax(1, drawn_at(&p->drawn, middle)) * level * level);
        sunk += (slope + bends * dx / 2) * dx;
        slope += bends * dx;
        x += dx;
        p->place[i] = (Place){s, x, at.position.z - sunk, 0, hypot(at.tangent.x, at.tangent.y) < cos(STEEP)};
    }
}

/* Twice the area of a triangle, positive if c is above the way from a to b. */
static double above(const Place *a, const Place *b, const Place *c)
{
    return (b->x - a->x) * (c->f - a->f) - (b->f - a->f) * (c->x - a->x);
}

/* From place `first` to `last`, at which it lies on the route: the string is the least that is nowhere below the route
 * and bends upward by no more than w/T, the parabola and over it the upper hull of the rest. Returns how many places it
 * lies on it at. */
static int hull_find(const Places *p, int first, int last)
{
    int n = 0;
    for (int i = first; i <= last; ++i) {
        while (n > 1 && above(&p->place[p->hull[n - 2]], &p->place[p->hull[n - 1]], &p->place[i]) >= 0) --n;
        p->hull[n++] = i;
    }
    return n;
}

/* Chord k of the hull. */
static void chord_lift(const Places *p, int k, Lift *most)
{
    const Place *const a = &p->place[p->hull[k]], *const b = &p->place[p->hull[k + 1]];
    for (const Place *at = a + 1; at < b; ++at)
        lift_take(a->f + (b->f - a->f) * (at->x - a->x) / (b->x - a->x) - at->f, at->s, most);
}

/* Rope with the front at that place. */
static void front_lift(const Places *p, int front, int last, Lift *most)
{
    Places *const closer = p->closer;
    const RopeSeries *const rope = p->drawn.rope;
    memcpy(closer->drawn.rope->tension, rope->tension, (size_t)rope->n * sizeof *rope->tension);
    plan_rope_ahead(&p->c->def, rope, p->place[front].s, p->place[last].s, closer->drawn.rope->tension);
    places_fill(closer, front, last);
    for (int k = 0, n = hull_find(closer, front, last); k + 1 < n; ++k) chord_lift(closer, k, most);
}

/* A chord of rope, which has been drawn with the most that it is there wherever the front is, looked at with the front
 * at places before its top. */
static void chord_closer(const Places *p, int k, int last, Lift *most)
{
    Lift bound = *most;
    chord_lift(p, k, &bound);
    const int begin = p->hull[k], top = (int)round(bound.at / p->step);
    for (int i = 0; i < FRONTS && bound.by > most->by; ++i)
        front_lift(p, begin + (top - begin) * i / FRONTS, last, most);
}

static void section_lift(const Places *p, int first, int last, Lift *most)
{
    for (int k = 0, n = hull_find(p, first, last); k + 1 < n; ++k) {
        if (p->closer) {
            chord_closer(p, k, last, most);
        } else {
            chord_lift(p, k, most);
        }
    }
}

static void gentle_lift(const Places *p, Lift *most)
{
    for (int first = 0, i = 1; i < p->n; ++i) {
        if (!p->place[i].held && !p->place[i].steep && i < p->n - 1) continue;
        if (i > first + 1) section_lift(p, first, i, most);
        first = i;
    }
}

/* ------------------------------------------------------------------------------------------------------- the shafts */

static double straight_beside(const Route *route, int piece)
{
    if (piece < 0 || piece >= route->n || route->piece[piece].kind != ROUTE_STRAIGHT) return 0;
    return route->piece[piece].length;
}

/* R' of (T31) where the corner from `begin` to `end` is steep: T/w, or as far as the straights beside it reach. Of rope
 * the tension counts that it has with the front so far before the corner. */
static double corner_bends(const Places *p, double begin, double end, double radius, double reach)
{
    const double across = tan((end - begin) / radius / 2);
    double bends = 0;
    for (int i = p->closer ? 1 : FRONTS; i <= FRONTS; ++i) {
        const double before = reach * i / FRONTS, at = p->closer ? begin - before : (begin + end) / 2;
        bends = fmax(bends, fmin(drawn_at(&p->drawn, at) / p->weight, radius + before / across));
    }
    return bends;
}

static void steep_lift(const Places *p, Lift *most)
{
    const Route *const route = p->c->route;
    for (int k = 0, to; k < route->n; k = to + 1) {
        to = route_turn_end(route, k);
        if (route->piece[k].kind == ROUTE_STRAIGHT) continue;
        const double begin = route->piece[k].s0, end = route->piece[to].s0 + route->piece[to].length;
        const double a = route_slope(route, begin), b = route_slope(route, end), turn = b - a;
        if (!(turn > 0) || fmax(fabs(a), fabs(b)) < STEEP) continue;
        int held = 0;
        for (int i = (int)(begin / p->step); i < p->n && p->place[i].s <= end + p->step; ++i) held |= p->place[i].held;
        if (held) continue;
        const double radius = (end - begin) / turn;
        const double reach = fmin(straight_beside(route, k - 1), straight_beside(route, to + 1));
        const double bends = corner_bends(p, begin, end, radius, reach);
        lift_take((bends - radius) * (1 / cos(turn / 2) - 1), (begin + end) / 2, most);
    }
}

/* ------------------------------------------------------------------------------------------------------- the route */

/* Whether the route bends upward by more than w/T anywhere. */
static int may_lift(const Places *p)
{
    const Route *const route = p->c->route;
    for (int k = 0; k < route->n; ++k) {
        const RoutePiece *const piece = &route->piece[k];
        for (int i = 1; piece->kind != ROUTE_STRAIGHT && i < 6; i += 2) {
            const double s = piece->s0 + piece->length * i / 6;
            const RoutePoint at = route_at(route, s);
            const double holds = p->weight * (at.tangent.x * at.tangent.x + at.tangent.y * at.tangent.y);
            if (at.curvature.z > 0 && drawn_at(&p->drawn, s) * at.curvature.z > holds) return 1;
        }
    }
    return 0;
}

static int places_make(Places *p)
{
    p->n = 2 + (int)fmin(MOST, p->c->route->length / STEP);
    p->step = p->c->route->length / (p->n - 1);
    p->place = calloc((size_t)p->n, sizeof *p->place);
    p->hull = calloc((size_t)p->n, sizeof *p->hull);
    return p->place && p->hull;
}

static void places_free(Places *p)
{
    free(p->place);
    free(p->hull);
}

static hawser_status places_lift(Places *p, Lift *most, hawser_error *err)
{
    if (!(p->weight > 0) || !may_lift(p)) return HAWSER_OK;
    const int fine = places_make(p) && (!p->closer || places_make(p->closer));
    if (fine) {
        places_fill(p, 0, p->n - 1);
        places_hold(p);
        gentle_lift(p, most);
        steep_lift(p, most);
    }
    places_free(p);
    if (p->closer) places_free(p->closer);
    return fine ? HAWSER_OK : error_memory(err);
}

/* Rope ahead, at speed. */
static hawser_status rope_lift(const Setup *setup, const Calculator *c, Lift *most, hawser_error *err)
{
    const double begins = fmax(0, setup->front), apart = fmax(STEP, c->route->length / MOST);
    RopeSeries rope;
    hawser_status status = plan_rope(&c->def, PLAN_FORWARD, 0, begins, apart, &rope, err);
    if (status) return status;
    RopeSeries ahead = rope; /* with the front at one place */
    ahead.tension = malloc(((size_t)rope.n + 1) * sizeof *ahead.tension);
    Places closer = {.setup = setup, .c = c, .weight = c->def.rope_weight, .drawn = {.rope = &ahead}};
    Places p = closer;
    p.drawn.rope = &rope;
    p.from = begins;
    p.closer = &closer;
    status = ahead.tension ? places_lift(&p, most, err) : error_memory(err);
    free(ahead.tension);
    plan_rope_free(&rope);
    return status;
}

hawser_status lifted_judge(const Setup *setup, const Calculator *c, hawser_condition *out, hawser_error *err)
{
    const int way = c->def.skip[PLAN_FORWARD] ? PLAN_BACKWARD : PLAN_FORWARD;
    Places cable = {.setup = setup,
                    .c = c,
                    .weight = c->def.lightest > 0 ? c->def.lightest : setup->cable_weight,
                    .drawn = {.pull = &c->plan.way[way].pull}};
    Lift most = {SUPPORT_OFF_ROUTE, 0};
    if (!setup->def->winch.present && setup->n_pushers == 0) return HAWSER_OK; /* nothing moves it on */
    hawser_status status = places_lift(&cable, &most, err);
    const int rope = !(most.by > SUPPORT_OFF_ROUTE);
    if (!status && rope && way == PLAN_FORWARD && c->def.rope_weight > 0) status = rope_lift(setup, c, &most, err);
    if (status || !(most.by > SUPPORT_OFF_ROUTE)) return status;
    *out = theory_condition(HAWSER_CONDITION_SUPPORTED, most.by, SUPPORT_OFF_ROUTE);
    out->unit = "m";
    snprintf(out->remedy, sizeof out->remedy,
             "taut, the %s lifts off what carries it by %.3g m at %.1f m: give hold-downs or a duct there, or leave "
             "out 'run' and 'drive'",
             rope ? "rope" : "cable", most.by, most.at);
    return HAWSER_OK;
}
