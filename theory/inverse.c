#include "theory/inverse.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "theory/mend.h"
#include "theory/plan.h"

/* Range of a search: factors up to a thousand, or down to a thousandth. */
static const double FARTHEST = 1000;

/* State of one search. */
typedef struct Question {
    const Setup *setup;
    const Calculator *base;
    const Ends *ends;
    int taken; /* assumed values count as taken, not at the ends of their ranges */
    int first; /* the end that is computed first: the last one at which a value failed */
    InverseKind kind;
    int way, bend;                    /* bend: the piece of INVERSE_BEND */
    int untouched[HAWSER_LIMITS_MAX]; /* by limit: its value does not depend on the searched one */
    double enough;                    /* N: a tension that breaks a limit for certain; 0: none known */
    hawser_status
        status; /* error that ended the search; values that cannot be computed count as not holding, without an error */
    hawser_error *err;
} Question;

static Variation variation_of(const Question *q, double x)
{
    Variation v = {.way = q->way, .friction = 1, .radius = 1, .bend = -1};
    if (q->kind == INVERSE_FRICTION) v.friction = x;
    if (q->kind == INVERSE_RADIUS || q->kind == INVERSE_BEND) v.radius = x;
    if (q->kind == INVERSE_BEND) v.bend = q->bend;
    if (q->kind == INVERSE_LENGTH) v.beyond = (x - 1) * q->base->route->length;
    return v;
}

/* Solves the varied calculator at an end; returns 0 if that fails, as friction may become too large to compute. */
static int varied(Question *q, int end, const Variation *by, Calculator *c)
{
    hawser_error local;
    const Solved *const at = &q->ends->at[end];
    const hawser_status status = calculator_vary(end ? &at->setup : q->setup, end ? &at->c : q->base, by, c, &local);
    if (status == HAWSER_ERR_MEMORY) {
        q->status = status;
        if (q->err) *q->err = local;
    }
    return !status;
}

/* Marks broken limits that do not depend on the searched value: neither half nor twice of it changes them. Limits that
 * hold may break farther on. */
static void touched_find(Question *q)
{
    int any = 0;
    for (int i = 0; i < HAWSER_LIMITS_MAX; ++i) q->untouched[i] = 0;
    for (int i = 0; i < q->base->n_limits; ++i) {
        const hawser_limit *const l = &q->base->limit[q->way][i];
        any |= q->untouched[i] = l->judged && !l->ok;
    }
    for (int k = 0; k < 2 && any; ++k) {
        Calculator c;
        const Variation by = variation_of(q, k ? 2 : 0.5);
        const int solved = varied(q, 0, &by, &c);
        any = 0;
        for (int i = 0; i < q->base->n_limits; ++i) {
            const double now = q->base->limit[q->way][i].value;
            if (!solved || fabs(c.limit[q->way][i].value - now) > 1e-12 * fabs(now)) q->untouched[i] = 0;
            any |= q->untouched[i];
        }
        calculator_free(&c);
    }
}

/* The most broken limit that depends on the searched value; NULL: none. */
static const hawser_limit *broken(const Question *q, const Calculator *c)
{
    const hawser_limit *worst = NULL;
    for (int i = 0; i < c->n_limits; ++i) {
        const hawser_limit *const l = &c->limit[q->way][i];
        if (!l->judged || l->ok || q->untouched[i]) continue;
        if (!worst || l->margin < worst->margin) worst = l;
    }
    return worst;
}

/* Checks whether everything holds, stiffness included: otherwise the verdict is NOT TRUSTED, not SAFE. */
static int keeps(const Question *q, const Calculator *c)
{
    return c->pulled[q->way].holds && !broken(q, c) && stiffened_judge(q->setup, c, q->way).holds;
}

/* Lists the broken limits that do not depend on the searched value, as far as space allows. */
static void stays_find(const Question *q, const Calculator *c, char stays[INVERSE_STAYS_MAX])
{
    size_t n = 0;
    *stays = 0;
    for (int i = 0; i < c->n_limits; ++i) {
        const hawser_limit *const l = &c->limit[q->way][i];
        if (!l->judged || l->ok || !q->untouched[i] || n + strlen(l->name) + 3 > INVERSE_STAYS_MAX) continue;
        n += (size_t)snprintf(stays + n, INVERSE_STAYS_MAX - n, "%s%s", n ? ", " : "", l->name);
    }
}

/* Checks whether everything holds. For friction and length, whose maximum is searched, it must also hold at the ends of
 * the assumed ranges. *c: of the first end computed at which it does not, or of the last; calculator_free must follow.
 * *solved: whether that has a result. */
static int holds_at(Question *q, const Variation *by, Calculator *c, int *solved)
{
    const int most = q->kind == INVERSE_FRICTION || q->kind == INVERSE_LENGTH,
              ends = most && !q->taken ? q->ends->n : 1;
    int holds = 1, any = 0, first = q->first < ends ? q->first : 0;
    for (int i = 0; i < ends && holds; ++i) {
        const int end = (first + i) % ends;
        if (by->friction != 1 && q->ends->of_friction[end]) continue;
        if (any++) calculator_free(c);
        *solved = varied(q, end, by, c);
        holds = *solved && keeps(q, c);
        if (!holds) q->first = end;
    }
    return holds;
}

/* The same for the case's own value. */
static int holds_now(const Question *q)
{
    const int most = q->kind == INVERSE_FRICTION || q->kind == INVERSE_LENGTH;
    int holds = keeps(q, q->base);
    for (int k = 1; most && !q->taken && k < q->ends->n; ++k) holds = holds && keeps(q, &q->ends->at[k].c);
    return holds;
}

static int question_holds(void *what, double x)
{
    Question *const q = what;
    Calculator c;
    int solved;
    Variation by = variation_of(q, x);
    by.enough = q->enough;
    if (q->status) return 0;
    if (x == 1) return holds_now(q);
    const int holds = holds_at(q, &by, &c, &solved);
    calculator_free(&c);
    return holds;
}

/* Writes the most broken limit and its place; c: of holds_at, 0 for one without a result. */
static void binding_say(const Question *q, const Calculator *c, char binds[24], char where[80])
{
    *binds = *where = 0;
    if (!c) {
        snprintf(binds, 24, "%s", "pull");
    } else if (!c->pulled[q->way].holds) {
        const Pushed worst = c->pushed[q->way];
        snprintf(binds, 24, "%s", "pulled");
        memcpy(where, finding_on(c->route, 0, worst.at, worst.piece).where, 80);
    } else {
        const hawser_limit *const worst = broken(q, c);
        if (!worst) snprintf(binds, 24, "%s", "stiffness");
        if (worst) snprintf(binds, 24, "%.23s", worst->name);
        if (worst) snprintf(where, 80, "%.79s", worst->where);
    }
}

static void binding_find(Question *q, const Variation *by, char binds[24], char where[80])
{
    Calculator c;
    int solved = 0;
    q->first = 0;
    holds_at(q, by, &c, &solved);
    binding_say(q, solved ? &c : NULL, binds, where);
    calculator_free(&c);
}

/* The bend with the largest sidewall pressure; -1 without bends. */
static int critical_bend(const Calculator *c, int way)
{
    const Plan *const plan = &c->plan;
    int worst = -1;
    for (int p = 0; p < plan->n; ++p) {
        if (c->route->piece[p].kind == ROUTE_STRAIGHT) continue;
        if (worst < 0 || exceeds(plan->way[way].piece[p].sidewall, plan->way[way].piece[worst].sidewall)) worst = p;
    }
    return worst;
}

/* The case's own value: the largest friction on the route, the smallest radius, the route's length. */
static double now_of(const Question *q)
{
    const Calculator *const c = q->base;
    double radius = INFINITY;
    if (q->kind == INVERSE_LENGTH) return c->route->length;
    if (q->kind == INVERSE_BEND) return c->route->piece[q->bend].radius;
    if (q->kind == INVERSE_FRICTION) return c->mu_largest;
    for (int p = 0; p < c->route->n; ++p) {
        if (c->route->piece[p].kind != ROUTE_STRAIGHT) radius = fmin(radius, c->route->piece[p].radius);
    }
    return radius;
}

/* Checks for run-away, which more friction may prevent. */
static int runs_ahead(const Question *q)
{
    const hawser_limit *const l = q->base->limit[q->way];
    int broken_by_it = !q->base->pulled[q->way].holds;
    for (int i = 0; i < q->base->n_limits; ++i)
        broken_by_it |= l[i].judged && !l[i].ok && l[i].kind == HAWSER_LIMIT_RUN_AWAY;
    return broken_by_it;
}

/* Finds the bound. If less friction does not help, it is that of the range where more friction does, which begins at
 * *from (PN9). */
static SearchBound bound_find(Question *q, double *from)
{
    const int less = q->kind == INVERSE_RADIUS || q->kind == INVERSE_BEND;
    const SearchDef search = {question_holds, q, 1, less ? 1 / FARTHEST : FARTHEST},
                    more = {question_holds, q, 1, 1 / FARTHEST};
    const SearchBound bound = search_bound(&search);
    if (bound.end != SEARCH_NOWHERE || q->kind != INVERSE_FRICTION || !runs_ahead(q)) return bound;
    const SearchBound least = search_bound(&more);
    if (least.end != SEARCH_FOUND) return bound;
    const SearchDef beyond = {question_holds, q, least.value, FARTHEST};
    *from = least.value;
    return search_bound(&beyond);
}

static InverseAnswer answer_find(Question *q)
{
    InverseAnswer a = {.kind = q->kind, .way = q->way, .now = now_of(q), .value = NAN, .from = NAN};
    touched_find(q);
    q->enough = calculator_enough(q->setup, q->base, q->way, q->untouched);
    const SearchBound bound = bound_find(q, &a.from);
    a.end = bound.end;
    a.from *= a.now;
    if (q->kind == INVERSE_BEND) snprintf(a.what, sizeof a.what, "%s", q->base->route->piece[q->bend].name);
    if (bound.end == SEARCH_FOUND) a.value = bound.value * a.now;
    Calculator c;
    const Variation at = variation_of(q, bound.value);
    if (bound.end == SEARCH_NOWHERE) {
        stays_find(q, q->base, a.stays);
    } else {
        if (varied(q, 0, &at, &c)) stays_find(q, &c, a.stays);
        calculator_free(&c);
    }
    if (bound.end == SEARCH_EVERYWHERE || q->status) return a;
    const Variation beyond = variation_of(q, bound.fails);
    binding_find(q, &beyond, a.binds, a.where);
    return a;
}

/* -------------------------------------------------------------------------------------------- machines */

/* Distance from a bend, m, that keeps a place written with ten digits outside it. */
static const double BESIDE = 1e-5;

/* Finds the ends of the uninterrupted row of bends around a piece, m. */
static void bends_around(const Route *route, int piece, double ends[2])
{
    int first = piece, last = piece;
    while (first > 0 && route->piece[first - 1].kind != ROUTE_STRAIGHT) --first;
    while (last + 1 < route->n && route->piece[last + 1].kind != ROUTE_STRAIGHT) ++last;
    ends[0] = route->piece[first].s0;
    ends[1] = route->piece[last].s0 + route->piece[last].length;
}

/* First place beyond `after` along the pull where the tension reaches `push`; NAN: none. No machine stands in a bend:
 * the place moves to the bend's end, or with `early` to its start if that is beyond `after`. */
static double next_place(const Calculator *c, int way, double push, double after, int early)
{
    const Pull *const pull = &c->plan.way[way].pull;
    const int sign = way == PLAN_BACKWARD ? -1 : 1;
    for (int i = 0; i < pull->n; ++i) {
        const PullSpan *const span = &pull->span[i];
        if (sign * (span->s1 - after) <= 0 || fmax(span->t0, span->t1) < push) continue;
        double low = sign * (after - span->s0) > 0 ? after : span->s0, high = span->s1;
        if (c->route->piece[span->piece].kind != ROUTE_STRAIGHT) {
            double ends[2];
            bends_around(c->route, span->piece, ends);
            const double begin = ends[way == PLAN_BACKWARD] - sign * BESIDE,
                         end = ends[way == PLAN_FORWARD] + sign * BESIDE;
            const double at = early && sign * (begin - after) > 0 ? begin : end;
            return at > 0 && at < c->route->length ? at : NAN;
        }
        if (low == span->s0 && span->t0 >= push) return low;
        for (int k = 0; k < 60; ++k) {
            const double middle = low + (high - low) / 2;
            if (pull_at(pull, middle).tension < push) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return high;
    }
    return NAN;
}

/* Computes the force that each machine takes off, N. */
static void takes_find(const Calculator *c, InverseMachines *m, double push)
{
    for (int i = 0; i < m->n; ++i)
        m->takes[i] = fmin(push, fmax(0, pull_at(&c->plan.way[m->way].pull, m->at[i]).tension));
}

/* Adds machines one by one (PN11), each as soon as its whole push is usable before the place that breaks, until
 * everything holds. */
static void machines_place(Question *q, double push, int early, InverseMachines *m)
{
    PullStep step[INVERSE_MACHINES_MAX];
    Variation by = {.way = q->way, .friction = 1, .radius = 1, .bend = -1, .step = step};
    double after = q->way == PLAN_BACKWARD ? INFINITY : -INFINITY;
    *m = (InverseMachines){.way = q->way, .n = -1};
    for (int n = 0; n <= INVERSE_MACHINES_MAX; ++n) {
        Calculator c;
        int solved = 0;
        by.n_steps = n;
        q->first = 0;
        const int holds = holds_at(q, &by, &c, &solved);
        if (!holds) binding_say(q, solved ? &c : NULL, m->binds, m->where);
        if (solved && !holds && n < INVERSE_MACHINES_MAX) after = next_place(&c, q->way, push, after, early);
        calculator_free(&c);
        if (holds) {
            m->n = n;
            if (varied(q, 0, &by, &c)) takes_find(&c, m, push), stays_find(q, &c, m->stays);
            calculator_free(&c);
        }
        if (!solved || holds || isnan(after) || n == INVERSE_MACHINES_MAX) break;
        step[n] = (PullStep){m->at[n] = after, push, STEP_TAKE};
    }
}

/* Finds the better of both rules for bends; if no number holds at the ends of the assumed ranges, that with the values
 * taken. */
static void machines_find(Question *q, double push, InverseMachines *out)
{
    InverseMachines other;
    for (q->taken = 0, out->n = -1; q->taken < 2 && out->n < 0; ++q->taken) {
        machines_place(q, push, 0, out);
        machines_place(q, push, 1, &other);
        if (other.n >= 0 && (out->n < 0 || other.n < out->n)) *out = other;
    }
    q->taken = 0;
}

/* ------------------------------------------------------------------------------------------------ pits */

/* m: resolution of the places of pits, and the least length of a section. */
static const double PIT_STEP = 0.1, PIT_LEAST = 1;

/* Sections from the start on, each as long as its limits hold, but no longer than `most`. */
typedef struct Pits {
    Question *q;
    double back, most; /* N, m */
    PullStep step[INVERSE_MACHINES_MAX];
    Variation by;
} Pits;

/* Checks whether everything holds up to `far` metres from where the pull begins, with the pits placed so far. */
static int holds_up_to(Pits *p, double far)
{
    Calculator c;
    int solved;
    p->by.beyond = far - p->q->base->route->length;
    const int holds = holds_at(p->q, &p->by, &c, &solved);
    calculator_free(&c);
    return holds;
}

/* End of the section that begins at `from`, both in metres from where the pull begins: the route's end, or a round
 * value outside bends (PN13). NAN: none. */
static double section_end(Pits *p, double from)
{
    const Route *const route = p->q->base->route;
    const int back = p->q->way == PLAN_BACKWARD;
    double high = fmin(route->length, from + p->most), low = from;
    if (holds_up_to(p, high)) low = high;
    if (low == route->length) return low;
    while (high - low > PIT_STEP) {
        const double middle = low + (high - low) / 2;
        *(holds_up_to(p, middle) ? &low : &high) = middle;
    }
    const double s = back ? route->length - low : low;
    const int piece = route_at(route, s).piece;
    if (route->piece[piece].kind != ROUTE_STRAIGHT) {
        double ends[2];
        bends_around(route, piece, ends);
        low = back ? route->length - ends[1] : ends[0];
    }
    low = PIT_STEP * floor(low / PIT_STEP + 1e-6);
    return low < from + PIT_LEAST ? NAN : low;
}

/* Places at most `most` pits. */
static void pits_place(Pits *p, int most, InverseMachines *m)
{
    const double length = p->q->base->route->length;
    double at = 0;
    *m = (InverseMachines){.way = p->q->way, .n = -1};
    for (int n = 0; n <= most; ++n) {
        p->by.n_steps = n;
        at = section_end(p, at);
        if (at == length) m->n = n;
        if (isnan(at) || at == length || n == most) break;
        m->at[n] = p->q->way == PLAN_BACKWARD ? length - at : at;
        p->step[n] = (PullStep){m->at[n], p->back, STEP_ANEW};
    }
}

/* Finds the smallest number of pits, and of these solutions the one with the shortest longest section. */
static void pits_find(Question *q, double back, InverseMachines *out)
{
    Pits p = {.q = q, .back = back, .most = INFINITY};
    p.by = (Variation){.way = q->way, .friction = 1, .radius = 1, .bend = -1, .step = p.step};
    for (q->taken = 0, out->n = -1; out->n < 0 && q->taken < 2; ++q->taken)
        pits_place(&p, INVERSE_MACHINES_MAX - 1, out);
    --q->taken; /* the setting of the search that succeeded */
    if (out->n < 0) {
        p.by.beyond = 0;
        binding_find(q, &p.by, out->binds, out->where);
    }
    double high = q->base->route->length, low = high / (out->n + 1);
    Calculator c;
    p.by.n_steps = 0;
    p.by.beyond = 0;
    if (varied(q, 0, &p.by, &c)) stays_find(q, &c, out->stays);
    calculator_free(&c);
    while (out->n > 0 && high - low > PIT_STEP) {
        InverseMachines even;
        p.most = (low + high) / 2;
        pits_place(&p, out->n, &even);
        *(even.n >= 0 ? &high : &low) = p.most;
        if (even.n < 0) continue;
        out->n = even.n;
        memcpy(out->at, even.at, sizeof out->at);
    }
    q->taken = 0;
}

/* ------------------------------------------------------------------------------------------------ all of it */

/* Answers all questions for the direction q->way. */
static hawser_status way_find(Question *q, Inverse *out)
{
    const double push = q->setup->def->theory.machine_push;
    q->status = mend_find(q->setup, q->base, q->ends, q->way, 0, NULL, &out->mend[q->way], q->err);
    q->bend = critical_bend(q->base, q->way);
    for (int k = 0; k < INVERSE_KINDS && !q->status; ++k) {
        q->kind = (InverseKind)k;
        if ((k == INVERSE_RADIUS || k == INVERSE_BEND) && q->bend < 0) continue;
        out->answer[out->n++] = answer_find(q);
    }
    if (isnan(push) || q->status) return q->status;
    out->asked = 1;
    q->kind = INVERSE_FRICTION; /* machines change what friction also changes */
    touched_find(q);
    machines_find(q, push, &out->machines[q->way]);
    return q->status;
}

hawser_status inverse_find(const Setup *setup, const Calculator *base, Inverse *out, hawser_error *err)
{
    Question q = {.setup = setup, .base = base, .err = err};
    Ends *ends = NULL;
    memset(out, 0, sizeof *out);
    for (q.way = 0; q.way < PLAN_WAYS && !q.status; ++q.way) {
        if (!calculator_worst(base, q.way)) continue;
        if (!ends) q.status = ends_make(setup, setup->def, &ends, err);
        q.ends = ends;
        if (!q.status) q.status = way_find(&q, out);
    }
    ends_free(ends);
    return q.status;
}

hawser_status inverse_place(const Setup *setup, const Calculator *base, int way, int pits, double force,
                            InverseMachines *out, hawser_error *err)
{
    Question q = {.setup = setup, .base = base, .way = way, .kind = INVERSE_FRICTION, .err = err};
    Ends *ends = NULL;
    q.status = ends_make(setup, setup->def, &ends, err);
    q.ends = ends;
    if (!q.status) touched_find(&q);
    if (!q.status && pits) pits_find(&q, force, out);
    if (!q.status && !pits) machines_find(&q, force, out);
    ends_free(ends);
    return q.status;
}
