#include "theory/cannot.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "theory/calculator.h"

/* -------------------------------------------------------------------------------------- a route that crosses itself */

/* Two stretches of the route are halved until they are too far apart for the cable to lie inside itself, or as short as
 * it is thick. */
/* Cable diameters along the route, within which the cable is beside itself anyway. */
static const double APART = 10;

/* Where a route crosses itself at one level with cable in both places. */
typedef struct Crossing {
    double overlap; /* share of the diameter by which the cable lies inside itself */
    char says[200]; /* empty: nowhere */
} Crossing;

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

static hawser_status crossing_find(const Setup *setup, Crossing *out, hawser_error *err)
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

/* --------------------------------------------------------------------------------------------------------- the ends */

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
