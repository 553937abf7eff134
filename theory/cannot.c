#include "theory/cannot.h"

#include <math.h>
#include <stdio.h>

#include "core/base/error.h"

/* rad, by which the route may turn between a head without a rope and its end; cosine between a carrier's axis and the
 * route. */
static const double TURNED = 5 * M_PI / 180, ALONG = 0.9;

/* rad, by how much the route turns from s on, to whatever side. */
static double turn_from(const Route *route, double s)
{
    double turn = 0;
    for (int p = route_at(route, s).piece; p < route->n; ++p) {
        const RoutePiece *const piece = &route->piece[p];
        turn += piece->angle * fmin(1, (piece->s0 + piece->length - s) / piece->length);
    }
    return turn;
}

/* m along the route, from where on it turns by less than TURNED. */
static double straight_from(const Route *route)
{
    double turn = 0;
    for (int p = route->n - 1; p >= 0; --p) {
        const RoutePiece *const piece = &route->piece[p];
        turn += piece->angle;
        if (turn > TURNED) return piece->s0 + piece->length * (turn - TURNED) / piece->angle;
    }
    return 0;
}

const char *head_before_bend(const Setup *s, char says[CANNOT_SAYS])
{
    const SceneDef *const def = s->def;
    const double end = fmin(fmax(s->head, 0), s->route->length), turn = turn_from(s->route, end);
    if (!def->winch.present || def->strand.present || def->winch.take_in || turn <= TURNED) return NULL;
    const double needed = ceil(100 * straight_from(s->route)) / 100, degrees = turn * 180 / M_PI;
    if (s->has_rope)
        snprintf(says, CANNOT_SAYS,
                 "the rope ends at %.4g m, and the route turns by %.3g degrees ahead of it: the winch would pull along "
                 "the route's end, through the wall; make the rope %.4g m longer or more",
                 end, degrees, needed - end);
    else
        snprintf(says, CANNOT_SAYS,
                 "the cable's head is at %.4g m and has no rope, and the route turns by %.3g degrees ahead of it: the "
                 "winch would pull along the route's end, through the wall; give 'chain' a rope, or put the head at "
                 "%.4g m or beyond",
                 end, degrees, needed);
    return s->has_rope ? "chain" : "route.head_at";
}

static hawser_status head_check(const Setup *s, hawser_error *err)
{
    char says[CANNOT_SAYS];
    const char *const key = head_before_bend(s, says);
    return key ? error_set(err, HAWSER_ERR_INPUT, "key '%s': %s", key, says) : HAWSER_OK;
}

/* m of cable behind the start of its route that nothing has to carry. */
static const double BEHIND = 2;

/* m of rope beyond the route's end that may be slack: as far as from there to a winch. */
static const double AHEAD = 10;
/* Weight over tension of a free length that sags by half of itself. */
static const double SLACK = 4;

/* Whether something placed by coordinates may carry cable beside the route, or it falls on the route too. */
static int is_elsewhere(const Setup *s)
{
    const SceneDef *const def = s->def;
    int elsewhere = def->strand.present || def->drum.present || def->medium.density > 0 || s->supports.n_planes > 0;
    for (int i = 0; i < def->n_rollers; ++i) elsewhere |= !isfinite(def->rollers[i].s);
    return elsewhere || s->supports.n_rollers + s->supports.n_lengths == 0;
}

/* Cable behind the start that lies on nothing. */
static hawser_status tail_check(const Setup *s, hawser_error *err)
{
    if (is_elsewhere(s) || s->lead_in || !(-s->tail > BEHIND)) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT,
                     "key 'chain': it is longer than its way: %.4g m lie behind the route's start, where nothing "
                     "carries them; give 'lead_in' or a reel that pays out, or a larger 'route.head_at'",
                     -s->tail);
}

/* N, that a rope's end is held with at rest, without friction: by the back tension and what hangs back from there. */
static double held_at_end(const Setup *s)
{
    const Route *const route = s->route;
    const double rise = route_at(route, route->length).position.z - route_at(route, fmax(s->tail, 0)).position.z;
    return profile_value(&s->def->tail.tension, 0) + fmax(0, rise) * s->cable_weight;
}

/* Rope beyond the route's end that hangs to the winch, unless something placed by coordinates may be there: at rest it
 * sags by w L^2/8H, and falls if that is more than half of its length. */
static hawser_status rope_check(const Setup *s, hawser_error *err)
{
    const SceneDef *const def = s->def;
    const double beyond = s->head - s->route->length;
    if (!s->has_rope || !(beyond > AHEAD) || is_elsewhere(s) || def->winch.take_in) return HAWSER_OK;
    const double weight = def->cables[def->pieces[def->n_pieces - 1].cable].mass * v3_norm(def->gravity) * beyond;
    if (!(weight > SLACK * held_at_end(s))) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT,
                     "key 'chain': the rope is longer than its way: %.4g m lie beyond the route's end, where nothing "
                     "carries them and the back tension does not hold them; give 'drive.winch.take_in', a shorter rope "
                     "or more route",
                     beyond);
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

static hawser_status crossing_check(const Setup *s, hawser_error *err)
{
    Crossing found;
    if (!s->def->winch.present) return HAWSER_OK;
    const hawser_status status = crossing_find(s, &found, err);
    return status || !*found.says ? status : error_set(err, HAWSER_ERR_INPUT, "key 'route': %s", found.says);
}

hawser_status cannot_be_pulled(const Setup *setup, int moves, hawser_error *err)
{
    if (setup->def->rod.present) return HAWSER_OK;
    hawser_status status = moves ? head_check(setup, err) : HAWSER_OK;
    if (!status && moves) status = tail_check(setup, err);
    if (!status && moves) status = rope_check(setup, err);
    if (!status && moves) status = crossing_check(setup, err);
    return status ? status : rollers_check(setup, err);
}
