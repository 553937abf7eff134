#include "theory/plan.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "theory/closed_form.h"

static int is_length(double x) { return x >= 0 && isfinite(x); }

static hawser_status check_def(const PlanDef *def, hawser_error *err)
{
    assert(def->route && def->n_stretches >= 1 && def->n_pushes >= 0);
    if (!is_length(def->reel_length) || !is_length(def->rope_length) || !is_length(def->roller_spacing)) {
        return error_set(err, HAWSER_ERR_INPUT, "reel %g m, rope %g m and roller spacing %g m must not be negative",
                         def->reel_length, def->rope_length, def->roller_spacing);
    }
    if (!is_length(def->back_tension)) {
        return error_set(err, HAWSER_ERR_INPUT, "the back tension of %g N must not be negative", def->back_tension);
    }
    for (int i = 0; i < def->n_pushes; i++) {
        const PullStep *c = &def->push[i];
        if (!isfinite(c->force) || (def->push_back && !isfinite(def->push_back[i].force))) {
            return error_set(err, HAWSER_ERR_INPUT, "push %d is not a number", i);
        }
        if (!(c->at >= 0 && c->at <= def->route->length)) {
            return error_set(err, HAWSER_ERR_INPUT, "push %d at %g m is off the route of %g m", i, c->at,
                             def->route->length);
        }
    }
    return HAWSER_OK;
}

/* What pull_solve is given: friction times the duct's weight factor (T20), pushes as negative steps (T26).
 */
typedef struct Inputs {
    PullStretch *stretch;
    PullStep *step[PLAN_WAYS];
} Inputs;

static void inputs_clear(Inputs *in)
{
    free(in->stretch);
    for (int k = 0; k < PLAN_WAYS; k++) free(in->step[k]);
}

/* The pushes of one direction; NULL without memory. */
static PullStep *steps_new(int n, const PullStep *push)
{
    PullStep *step = malloc((size_t)(n + 1) * sizeof *step);
    for (int i = 0; step && i < n; i++) step[i] = (PullStep){.at = push[i].at, .force = -push[i].force};
    return step;
}

/* With a duct the worst loaded cable's share of T/R is the duct's. */
static hawser_status inputs_set(const PlanDef *def, const DuctLoad *duct, Inputs *in, hawser_error *err)
{
    const int n = def->n_pushes;
    in->stretch = malloc((size_t)def->n_stretches * sizeof *in->stretch);
    in->step[PLAN_FORWARD] = steps_new(n, def->push);
    in->step[PLAN_BACKWARD] = steps_new(n, def->push_back ? def->push_back : def->push);
    if (!in->stretch || !in->step[PLAN_FORWARD] || !in->step[PLAN_BACKWARD]) return error_memory(err);
    for (int i = 0; i < def->n_stretches; i++) {
        in->stretch[i] = def->stretch[i];
        in->stretch[i].mu *= duct->weight_factor;
        in->stretch[i].mu_static *= duct->weight_factor;
        if (def->duct) in->stretch[i].share = duct->sidewall_factor;
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
    double T2 = 0;
    if (piece_tension(p, span->law.direction, span->t0, span->law.weight, span->law.mu, span->law.separate, &T2,
                      &why)) {
        snprintf(piece->reason, sizeof piece->reason, "%.*s", PLAN_REASON_MAX - 1, why.message);
    } else {
        piece->closed = T2;
    }
}

static void fill_pieces(const PlanDef *def, PlanWay *way)
{
    for (int i = 0; i < def->route->n; i++) {
        PlanPiece *piece = &way->piece[i];
        *piece = (PlanPiece){.t_in = NAN, .t_out = NAN, .closed = NAN};
        const PieceExtremes most = pull_piece_extremes(&way->pull, i);
        const double spacing = def->spacing ? def->spacing[i] : def->roller_spacing;
        piece->max_tension = most.tension;
        piece->sidewall = most.sidewall;
        piece->roller_load = fmax(most.down * spacing, most.aside * (def->guides ? def->guides[i] : spacing));
    }
    for (int i = 0; i < way->pull.n; i++) {
        const PullSpan *span = &way->pull.span[i];
        PlanPiece *piece = &way->piece[span->piece];
        assert(span->piece < def->route->n);
        if (isnan(piece->t_in)) {
            piece->t_in = span->t0;
            piece_closed(def->route, span, piece);
        }
        piece->t_out = span->t1;
    }
}

/* The route pulled one way: reel, pull, rope; then again from rest. */
static hawser_status solve_way(const PlanDef *def, const Inputs *in, int backward, PlanWay *way, hawser_error *err)
{
    const double first = backward ? def->route->length : 0, last = backward ? 0 : def->route->length;
    /* of what lies where the pull starts: it is what the reel pays out */
    const double weight = stretch_at(def->n_stretches, def->stretch, first)->weight;
    way->start = weight * def->reel_length + def->back_tension; /* (T24) */
    way->rope = weight * def->rope_length + def->rope_force;    /* (T25) */
    PullDef pull = {.route = def->route,
                    .from = first,
                    .to = last,
                    .start_tension = way->start,
                    .n_stretches = def->n_stretches,
                    .stretch = in->stretch,
                    .n_steps = def->n_pushes,
                    .step = in->step[backward],
                    .restart = 1};
    Pull restart;
    hawser_status status = pull_solve(&pull, &restart, err);
    if (status) return status;
    way->restart_force = restart.end_tension + way->rope;
    way->restart_max = restart.max_tension;
    way->restart_at = restart.max_at;
    pull_clear(&restart);
    pull.restart = 0;
    status = pull_solve(&pull, &way->pull, err);
    if (status) return status;
    way->force = way->pull.end_tension + way->rope;
    way->piece = calloc((size_t)def->route->n, sizeof *way->piece);
    if (!way->piece) return error_memory(err);
    fill_pieces(def, way);
    return HAWSER_OK;
}

hawser_status plan_build(const PlanDef *def, Plan *out, hawser_error *err)
{
    *out = (Plan){.duct = {.layout = DUCT_SINGLE, .weight_factor = 1, .sidewall_factor = 1}};
    Inputs in = {0};
    hawser_status status = check_def(def, err);
    if (!status && def->duct) status = duct_load(def->duct, &out->duct, err);
    if (!status) status = inputs_set(def, &out->duct, &in, err);
    for (int k = 0; k < PLAN_WAYS && !status; k++) {
        status = solve_way(def, &in, k, &out->way[k], err);
    }
    inputs_clear(&in);
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
