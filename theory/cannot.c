#include "theory/cannot.h"

#include <math.h>

#include "core/base/error.h"

static const double TURNED =
    5 * M_PI / 180;              /* rad, that the route may turn between a head without a rope and the winch */
static const double ALONG = 0.9; /* cosine between a carrier's axis and the route */

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

hawser_status cannot_be_pulled(const Setup *setup, int moves, hawser_error *err)
{
    if (setup->def->rod.present) return HAWSER_OK;
    hawser_status status = moves ? head_check(setup, err) : HAWSER_OK;
    return status ? status : rollers_check(setup, err);
}
