#include "theory/plan.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "theory/closed_form.h"
#include "theory/plan_pull.h"
#include "theory/search.h"

/* What lies along the route may stand beyond it; all else the case's keys have checked. */
static hawser_status check_def(const PlanDef *def, hawser_error *err)
{
    assert(def->route && def->n_stretches >= 1 && def->reel_length >= 0 && def->rope_length >= 0);
    assert(def->back_tension >= 0 && def->rope_weight >= 0 && def->feed >= 0);
    assert(def->route->length + def->beyond > 0);
    for (int i = 0; i < def->n_pushes; i++) {
        const PullStep *c = &def->push[i];
        if (!isfinite(c->force) || (def->push_back && !isfinite(def->push_back[i].force)))
            return error_set(err, HAWSER_ERR_INPUT, "push %d is not a number", i);
        if (!(c->at >= 0 && c->at <= def->route->length))
            return error_set(err, HAWSER_ERR_INPUT, "push %d at %g m is off the route of %g m", i, c->at,
                             def->route->length);
    }
    return HAWSER_OK;
}

/* One span's outcome by the closed form, where the piece is a single span. */
static void piece_closed(const Route *route, const PullSpan *span, PlanPiece *piece)
{
    const RoutePiece *p = &route->piece[span->piece];
    hawser_error why = {.message = ""};
    if (fabs(fabs(span->s1 - span->s0) - p->length) > 1e-9 * p->length) {
        snprintf(piece->reason, sizeof piece->reason, "friction, weight or a push changes on the piece");
        return;
    }
    if (span_straight(&span->law, span->s0, span->t0) < span_normal(&span->law, span->s0, span->t0) ||
        span_straight(&span->law, span->s1, span->t1) < span_normal(&span->law, span->s1, span->t1)) {
        snprintf(piece->reason, sizeof piece->reason, "the cable is pushed, and snakes or coils on the piece");
        return;
    }
    double T2 = 0;
    if (piece_tension(p, span->law.direction, span->t0, span->law.weight, span->law.mu, span->law.separate, &T2,
                      &why)) {
        snprintf(piece->reason, sizeof piece->reason, "%.*s", PLAN_REASON_MAX - 1, why.message);
    } else {
        piece->closed = T2;
    }
}

/* By how much the route turns from its start up to s, rad; turned[k]: up to piece k. */
static double turned_at(const Route *route, const double *turned, double s)
{
    const int begun = items_before(route->n, &route->piece->s0, sizeof *route->piece, s, 1),
              k = begun > 0 ? begun - 1 : 0;
    const RoutePiece *const p = &route->piece[k];
    return turned[k] + p->angle * fmin(fmax((s - p->s0) / p->length, 0), 1);
}

/* What is largest on the piece of which span i is the first: a piece's spans follow each other. A support bears no more
 * than what turns the cable as far as its neighbours are, and the weight up to them (T18). */
static void piece_loads(const PlanDef *def, const double *turned, PlanWay *way, int i)
{
    const int p = way->pull.span[i].piece;
    const RoutePiece *const on = &def->route->piece[p];
    PlanPiece *const piece = &way->piece[p];
    const PieceExtremes most = pull_extremes_from(&way->pull, i);
    const double spacing = def->spacing ? def->spacing[p] : def->roller_spacing;
    const double beside = def->guides ? def->guides[p] : spacing;
    piece->max_tension = most.tension;
    piece->sidewall = most.sidewall;
    piece->guided = most.aside > 0 ? most.aside * fmin(beside, piece->turn) : 0;
    if (!(spacing > 0)) return; /* no supports that share the load between them */
    const double turn =
        turned_at(def->route, turned, on->s0 + on->length + spacing) - turned_at(def->route, turned, on->s0 - spacing);
    const double all = most.either * turn + way->pull.span[i].law.weight * spacing;
    piece->carried = fmin(most.down * spacing, all);
}

/* How long the bends are of which the pieces are parts. */
static void fill_turns(const Route *route, PlanPiece *piece)
{
    for (int p = 0, last; p < route->n; p = last + 1) {
        last = route_turn_end(route, p);
        const double length = route->piece[last].s0 + route->piece[last].length - route->piece[p].s0;
        const double turn = route->piece[p].kind == ROUTE_STRAIGHT ? INFINITY : length;
        for (int k = p; k <= last; k++) piece[k].turn = turn;
    }
}

/* The rollers of a bend bear what any part of it has. */
static void share_loads(const Route *route, PlanPiece *piece)
{
    for (int p = 0, last; p < route->n; p = last + 1) {
        double carried = 0, guided = 0;
        last = route_turn_end(route, p);
        for (int k = p; k <= last; k++) {
            carried = fmax(carried, piece[k].carried);
            guided = fmax(guided, piece[k].guided);
        }
        for (int k = p; k <= last; k++) {
            piece[k].carried = carried;
            piece[k].guided = guided;
            piece[k].roller_load = fmax(carried, guided);
        }
    }
}

static hawser_status fill_pieces(const PlanDef *def, PlanWay *way, hawser_error *err)
{
    double *const turned = calloc((size_t)def->route->n + 1, sizeof *turned);
    if (!turned) return error_memory(err);
    for (int p = 0; p < def->route->n; p++) turned[p + 1] = turned[p] + def->route->piece[p].angle;
    for (int i = 0; i < def->route->n; i++) way->piece[i] = (PlanPiece){.t_in = NAN, .t_out = NAN, .closed = NAN};
    fill_turns(def->route, way->piece);
    for (int i = 0; i < way->pull.n; i++) {
        const PullSpan *span = &way->pull.span[i];
        if (i == 0 || span->piece != span[-1].piece) piece_loads(def, turned, way, i);
        PlanPiece *piece = &way->piece[span->piece];
        assert(span->piece < def->route->n);
        if (isnan(piece->t_in)) {
            piece->t_in = span->t0;
            piece_closed(def->route, span, piece);
        }
        piece->t_out = span->t1;
    }
    share_loads(def->route, way->piece);
    free(turned);
    return HAWSER_OK;
}

/* Each span's least is the other pull's, whose spans are parts of it, where that is less. */
static void spans_take(const Pull *low, Pull *pull)
{
    for (int k = 0, i = 0; k < low->n; k++) {
        const PullSpan *const part = &low->span[k];
        const double middle = part->s0 + (part->s1 - part->s0) / 2, sign = part->law.direction;
        while (i < pull->n - 1 && sign * (middle - pull->span[i].s1) > 0) i++;
        if (part->least >= pull->span[i].least) continue;
        pull->span[i].least = part->least;
        pull->span[i].least_at = part->least_at;
    }
}

/* The least tension is that with the least back tension. */
static hawser_status least_take(const PlanDef *def, const PlanPullDef *what, Pull *pull, hawser_error *err)
{
    const PlanDef slack = plan_slack(def);
    Pull low;
    if (!plan_slackens(def)) return HAWSER_OK;
    const hawser_status status = plan_pull(&slack, what, &low, err);
    if (status) return status;
    if (low.min_tension < pull->min_tension) {
        pull->min_tension = low.min_tension;
        pull->min_at = low.min_at;
        pull->min_piece = low.min_piece;
    }
    spans_take(&low, pull);
    pull_clear(&low);
    return HAWSER_OK;
}

/* The route pulled one way: reel, pull, rope; then again from rest. */
static hawser_status solve_way(const PlanDef *def, int k, PlanWay *way, hawser_error *err)
{
    PlanPullDef what = {.way = k, .whole = 1, .restart = 1};
    Pull restart;
    way->start = plan_section(def, k, 0).start;
    way->rope = plan_allowance(def, k);
    hawser_status status = plan_pull(def, &what, &restart, err);
    if (status) return status;
    way->restart_force = restart.end_tension + way->rope;
    way->restart_max = restart.max_tension;
    way->restart_at = restart.max_at;
    way->restart_piece = restart.max_piece;
    way->restart_sidewall = restart.max_sidewall;
    way->restart_sidewall_at = restart.sidewall_at;
    way->restart_sidewall_piece = restart.sidewall_piece;
    pull_clear(&restart);
    what.restart = 0;
    status = plan_pull(def, &what, &way->pull, err);
    if (!status) status = least_take(def, &what, &way->pull, err);
    if (status) return status;
    way->force = way->pull.end_tension + way->rope;
    way->piece = calloc((size_t)def->route->n, sizeof *way->piece);
    if (!way->piece) return error_memory(err);
    return fill_pieces(def, way, err);
}

hawser_status plan_build(const PlanDef *def, Plan *out, hawser_error *err)
{
    *out = (Plan){0};
    hawser_status status = check_def(def, err);
    for (int k = 0; k < PLAN_WAYS && !status; k++) {
        if (!def->skip[k]) status = solve_way(def, k, &out->way[k], err);
    }
    if (status) {
        plan_clear(out);
        return status;
    }
    out->n = def->route->n;
    out->better = out->way[PLAN_BACKWARD].force < out->way[PLAN_FORWARD].force ? PLAN_BACKWARD : PLAN_FORWARD;
    return HAWSER_OK;
}

void plan_clear(Plan *plan)
{
    for (int k = 0; k < PLAN_WAYS; k++) {
        pull_clear(&plan->way[k].pull);
        free(plan->way[k].piece);
    }
    *plan = (Plan){0};
}
