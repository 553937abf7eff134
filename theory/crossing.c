/* Whether a route crosses itself at one level: the cable would lie inside itself. Two stretches of the route are halved
 * until they are too far apart for that, or as short as the cable is thick. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "theory/calculator.h"
#include "theory/cannot.h"

/* Cable diameters along the route, within which the cable is beside itself anyway. */
static const double APART = 10;

typedef struct Stretch {
    double from, to;               /* m along the route */
    double turned_from, turned_to; /* rad, at most: by how much the route has turned up to there, to whatever side */
    Vec3 middle;
} Stretch;

typedef struct Search {
    const Route *route;
    const double *turned; /* [pieces + 1] rad, up to each piece's start */
    double thick, chain;  /* m, of the cable and its length */
    double turn;          /* rad: a curve whose ends meet turns by more than that */
    double a, b, away;    /* m, what was found */
} Search;

/* end: the stretch ends there; of a curve, which does not turn evenly, it has the whole turn then, else none. */
static double turned_at(const Search *f, double s, int end)
{
    const int k = route_at(f->route, s).piece;
    const RoutePiece *const p = &f->route->piece[k];
    const double part = p->kind == ROUTE_BEND ? fmin(fmax((s - p->s0) / p->length, 0), 1) : end;
    return f->turned[k] + part * p->angle;
}

static Stretch stretch_of(const Search *f, double from, double to)
{
    return (Stretch){from, to, turned_at(f, from, 0), turned_at(f, to, 1),
                     route_at(f->route, 0.5 * (from + to)).position};
}

/* m between the places a and b of the route, which move to where it is nearest to itself. */
static double nearest(const Route *route, double *a, double *b)
{
    for (int k = 0; k < 40; ++k) {
        const RoutePoint p = route_at(route, *a), q = route_at(route, *b);
        const Vec3 off = v3_sub(q.position, p.position);
        const double along = v3_dot(p.tangent, q.tangent), det = 1 - along * along;
        const double x = v3_dot(off, p.tangent), y = v3_dot(off, q.tangent);
        if (!(det > 1e-6)) { /* beside each other */
            *b = fmin(fmax(*b - y, 0), route->length);
            break;
        }
        *a = fmin(fmax(*a + (x - along * y) / det, 0), route->length);
        *b = fmin(fmax(*b + (along * x - y) / det, 0), route->length);
    }
    return v3_norm(v3_sub(route_at(route, *b).position, route_at(route, *a).position));
}

static int is_crossing(Search *f, double a, double b)
{
    f->a = a;
    f->b = b;
    f->away = nearest(f->route, &f->a, &f->b);
    return f->away < f->thick && f->b - f->a > APART * f->thick && f->b - f->a < f->chain;
}

/* Whether a place of p meets one of q, which is the same stretch or lies behind it. */
static int stretches_meet(Search *f, const Stretch *p, const Stretch *q)
{
    const double lp = p->to - p->from, lq = q->to - q->from;
    const int together = q->to - p->from <= APART * f->thick || q->turned_to - p->turned_from <= f->turn;
    if (together || q->from - p->to >= f->chain) return 0;
    if (v3_norm(v3_sub(p->middle, q->middle)) > 0.5 * (lp + lq) + f->thick) return 0;
    if (fmax(lp, lq) <= f->thick) return is_crossing(f, p->from + 0.5 * lp, q->from + 0.5 * lq);
    const Stretch *const longer = lp > lq ? p : q;
    const double middle = 0.5 * (longer->from + longer->to);
    const Stretch first = stretch_of(f, longer->from, middle), second = stretch_of(f, middle, longer->to);
    if (p->from == q->from)
        return stretches_meet(f, &first, &first) || stretches_meet(f, &first, &second) ||
               stretches_meet(f, &second, &second);
    if (longer == p) return stretches_meet(f, &first, q) || stretches_meet(f, &second, q);
    return stretches_meet(f, p, &first) || stretches_meet(f, p, &second);
}

hawser_status crossing_find(const Setup *setup, Crossing *out, hawser_error *err)
{
    const SceneDef *const def = setup->def;
    const Route *const route = setup->route;
    /* ends a tenth of their way apart: a curve that turns by t has ends at least cos(t/2) of its length apart */
    Search f = {
        .route = route, .thick = bundle_diameter(def), .chain = setup->head - setup->tail, .turn = 2 * acos(1 / APART)};
    out->says[0] = '\0';
    if (!(f.thick > 0) || def->strand.present || def->drum.present || def->analysis.inside) return HAWSER_OK;
    double *const turned = malloc(((size_t)route->n + 1) * sizeof *turned);
    if (!turned) return error_memory(err);
    turned[0] = 0;
    for (int k = 0; k < route->n; ++k) turned[k + 1] = turned[k] + route->piece[k].angle;
    f.turned = turned;
    const Stretch whole = stretch_of(&f, 0, route->length);
    if (stretches_meet(&f, &whole, &whole)) {
        out->overlap = 1 - f.away / f.thick;
        snprintf(out->says, sizeof out->says,
                 "the route crosses itself at one level, at %.4g m and at %.4g m, where the cable would lie inside "
                 "itself: lead one way over the other, by %.3g mm at least",
                 f.a, f.b, 1e3 * f.thick);
    }
    free(turned);
    return HAWSER_OK;
}

hawser_status crossing_judge(const Setup *setup, hawser_condition *result, hawser_error *err)
{
    Crossing found;
    const hawser_status status = crossing_find(setup, &found, err);
    if (status || !*found.says) return status;
    *result = theory_condition(HAWSER_CONDITION_OVERLAP, found.overlap, 0);
    snprintf(result->remedy, sizeof result->remedy, "%s", found.says);
    return HAWSER_OK;
}
