#include "theory/cannot.h"

#include <math.h>
#include <stdlib.h>

#include "core/base/error.h"

static const double TURNED =
    0.5 * M_PI / 180;            /* rad, that the route may turn between a head without a rope and the winch */
static const double ALONG = 0.9; /* cosine between a carrier's axis and the route */
static const double APART = 10;  /* cable diameters along the route, within which it is beside itself anyway */
enum { PLACES = 20000 };         /* of the route, at most */

/* A winch pulls at the cable's end in the direction of the route's end: round a bend that is through the wall. */
static hawser_status head_check(const Setup *s, hawser_error *err)
{
    const SceneDef *const def = s->def;
    const Route *const route = s->route;
    const double front = fmin(fmax(s->front, 0), route->length);
    if (!def->winch.present || s->has_rope || def->strand.present || def->winch.take_in) return HAWSER_OK;
    for (int p = route_at(route, front).piece; p < route->n; ++p) {
        const RoutePiece *const piece = &route->piece[p];
        const double from = fmax(front, piece->s0), ends = piece->s0 + piece->length;
        const double turns = piece->kind == ROUTE_STRAIGHT ? 0 : piece->angle * (ends - from) / piece->length;
        if (!(turns > TURNED)) continue;
        return error_set(
            err, HAWSER_ERR_INPUT,
            "key 'route.head_at': the cable's head is at %.4g m, before the bend at %.4g m, and has no rope: the "
            "winch would pull it along the route's end, through the wall; give 'chain' a rope, or put "
            "the head on the last straight, from %.4g m on",
            front, piece->s0, route->piece[route->n - 1].s0);
    }
    return HAWSER_OK;
}

/* Carriers of rows that lie along the cable, so that it has an edge to lie on, or nothing. */
static hawser_status rollers_check(const Setup *s, hawser_error *err)
{
    for (int i = 0; i < s->supports.n_rollers; ++i) {
        const SupportRoller *const r = &s->supports.roller[i];
        const RollerDef *const roller = &s->def->rollers[r->item];
        if (!r->row || r->kind != SUPPORT_ROLLER || roller->profile != SHAPE_CYLINDER) continue;
        if (!(fabs(v3_dot(v3_unit(roller->axis), route_at(s->route, r->s).tangent)) > ALONG)) continue;
        return error_set(err, HAWSER_ERR_INPUT,
                         "key 'rollers.along': the axis of roller '%s' at %.4g m lies along the route: it must lie "
                         "across",
                         roller->name, r->s);
    }
    return HAWSER_OK;
}

/* Places i and j of the route where it comes nearer to itself than the cable is thick, by chords. */
static double nearest(const Route *route, double *a, double *b)
{
    for (int k = 0; k < 40; ++k) {
        const RoutePoint p = route_at(route, *a), q = route_at(route, *b);
        const Vec3 off = v3_sub(q.position, p.position);
        const double along = v3_dot(p.tangent, q.tangent), det = 1 - along * along;
        if (!(det > 1e-6)) break;
        const double x = v3_dot(off, p.tangent), y = v3_dot(off, q.tangent);
        *a = fmin(fmax(*a + (x - along * y) / det, 0), route->length);
        *b = fmin(fmax(*b + (along * x - y) / det, 0), route->length);
    }
    return v3_norm(v3_sub(route_at(route, *b).position, route_at(route, *a).position));
}

/* Both lengths are full of cable or rope at once if the chain is as long as the way between them. */
static hawser_status crossing_check(const Setup *s, hawser_error *err)
{
    const Route *const route = s->route;
    const double thick = bundle_diameter(s->def), chain = s->head - s->tail;
    if (!(thick > 0) || s->def->strand.present || s->def->drum.present) return HAWSER_OK;
    const double step = fmax(thick, route->length / PLACES);
    const int n = (int)(route->length / step) + 1;
    Vec3 *const at = malloc((size_t)n * sizeof *at);
    if (!at) return error_memory(err);
    for (int i = 0; i < n; ++i) at[i] = route_at(route, i * step).position;
    hawser_status status = HAWSER_OK;
    for (int i = 0; i < n && !status; ++i) {
        int j = i + (int)fmax(2, ceil(APART * thick / step));
        while (j < n && !status) {
            const double away = v3_norm(v3_sub(at[j], at[i]));
            if (away > 2 * step + thick) { /* nothing nearer comes before it has gone that far */
                j += (int)fmax(1, floor((away - thick - step) / step));
                continue;
            }
            double a = i * step, b = j * step;
            if (nearest(route, &a, &b) < thick && b - a > APART * thick && b - a < chain)
                status =
                    error_set(err, HAWSER_ERR_INPUT,
                              "key 'route': the route crosses itself at one level, at %.4g m and at %.4g m, where "
                              "the cable would lie inside itself: lead one way over the other, by %.3g mm at least",
                              a, b, 1e3 * thick);
            ++j;
        }
    }
    free(at);
    return status;
}

hawser_status cannot_be_pulled(const Setup *setup, int moves, hawser_error *err)
{
    if (setup->def->rod.present) return HAWSER_OK;
    hawser_status status = moves ? head_check(setup, err) : HAWSER_OK;
    if (!status) status = rollers_check(setup, err);
    return status ? status : crossing_check(setup, err);
}
