#include "theory/pulling.h"

#include <assert.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "theory/search.h"

/* Everything a user can get wrong in one pull, each with its reason. */
static hawser_status check_def(const PullDef *def, hawser_error *err)
{
    assert(def->route && def->route->n >= 1 && def->n_stretches >= 1 && def->n_steps >= 0);
    if (!isfinite(def->from) || !isfinite(def->to) || def->from == def->to) {
        return error_set(err, HAWSER_ERR_INPUT, "a pull from %g m to %g m has no length", def->from, def->to);
    }
    if (!isfinite(def->start_tension)) {
        return error_set(err, HAWSER_ERR_INPUT, "the tension at the start of the pull is not a number");
    }
    for (int i = 0; i < def->n_stretches; i++) {
        const PullStretch *a = &def->stretch[i];
        if (!(a->weight >= 0 && isfinite(a->weight)) || !(a->mu >= 0 && isfinite(a->mu)) || !isfinite(a->mu_static)) {
            return error_set(err, HAWSER_ERR_INPUT, "stretch %d: weight %g N/m and friction %g must be >= 0", i,
                             a->weight, a->mu);
        }
        if (i > 0 && !(a->from > def->stretch[i - 1].from)) {
            return error_set(err, HAWSER_ERR_INPUT, "stretch %d begins at %g m, not beyond the one before it", i,
                             a->from);
        }
    }
    for (int i = 0; i < def->n_steps; i++) {
        if (!isfinite(def->step[i].at) || !isfinite(def->step[i].force)) {
            return error_set(err, HAWSER_ERR_INPUT, "tension step %d is not a number", i);
        }
    }
    return HAWSER_OK;
}

/* Corners of the data strictly inside the pull, and its ends: cut[0] < ... < cut[n-1]; returns n. cut must
 * hold n_pieces + 1 + n_stretches + n_steps + 2. */
static int collect_cuts(const PullDef *def, double *cut)
{
    const double low = fmin(def->from, def->to), high = fmax(def->from, def->to);
    int n = 0;
    cut[n++] = low;
    cut[n++] = high;
    for (int i = 0; i < def->route->n; i++) cut[n++] = def->route->piece[i].s0;
    cut[n++] = def->route->length;
    for (int i = 0; i < def->n_stretches; i++) cut[n++] = def->stretch[i].from;
    for (int i = 0; i < def->n_steps; i++) cut[n++] = def->step[i].at;
    qsort(cut, (size_t)n, sizeof *cut, compare_first);
    int kept = 0;
    for (int i = 0; i < n; i++) {
        const int inside = cut[i] >= low && cut[i] <= high;
        if (inside && (kept == 0 || cut[i] > cut[kept - 1])) cut[kept++] = cut[i];
    }
    return kept;
}

const PullStretch *stretch_at(int n, const PullStretch *stretch, double s)
{
    const int begun = items_before(n, &stretch->from, sizeof *stretch, s, 1);
    return &stretch[begun > 0 ? begun - 1 : 0];
}

/* The law that holds on stretch a around `middle`, between two neighbouring cuts. */
static SpanLaw law_between(const PullDef *def, const PullStretch *a, double middle)
{
    SpanLaw law = {.law = def->law,
                   .direction = def->to > def->from ? 1 : -1,
                   .weight = a->weight,
                   .mu = def->restart ? fmax(a->mu, a->mu_static) : a->mu,
                   .lightest = a->lightest,
                   .least = def->least,
                   .room = a->room,
                   .ei = a->ei,
                   .separate = a->separate,
                   .line = span_line(def->route, middle)};
    law.counts = span_counts(&law);
    return law;
}

/* The steps of a pull in its order; those of one place in the order in which they are listed. */
typedef struct StepAt {
    double at; /* m along the pull: times its direction */
    int i;     /* of def->step */
} StepAt;

static int compare_steps(const void *a, const void *b)
{
    const StepAt *const x = a, *const y = b;
    return x->at != y->at ? (x->at > y->at) - (x->at < y->at) : x->i - y->i;
}

static void steps_sort(const PullDef *def, StepAt *step)
{
    const int sign = def->to > def->from ? 1 : -1;
    int sorted = 1;
    for (int i = 0; i < def->n_steps; i++) {
        step[i] = (StepAt){sign * def->step[i].at, i};
        sorted &= i == 0 || step[i].at >= step[i - 1].at;
    }
    if (!sorted) qsort(step, (size_t)def->n_steps, sizeof *step, compare_steps);
}

/* The tension behind the steps at s, from step[*next] on, which moves on behind them: forces first, then what machines
 * take of it (PN2); where the pull begins anew nothing of all that counts (PN3). */
static double steps_pass(const PullDef *def, const StepAt *step, int *next, double s, double tension)
{
    const double at = def->to > def->from ? s : -s, arriving = tension;
    double anew = NAN;
    while (*next < def->n_steps && step[*next].at < at) ++*next;
    const int first = *next;
    for (; *next < def->n_steps && step[*next].at <= at; ++*next) {
        const PullStep *const one = &def->step[step[*next].i];
        if (one->kind == STEP_ADD) tension += one->force;
        if (one->kind == STEP_PUSH) tension -= def->pushes->push(def->pushes->of, one->item, arriving);
    }
    for (int i = first; i < *next; i++) {
        const PullStep *const one = &def->step[step[i].i];
        if (one->kind == STEP_TAKE) tension -= fmin(fmax(tension, 0), one->force);
        if (one->kind == STEP_ANEW) anew = one->force;
    }
    return isnan(anew) ? tension : anew;
}

static void take_tension(Pull *pull, int piece, double s, double tension)
{
    if (tension > pull->max_tension) {
        pull->max_tension = tension;
        pull->max_at = s;
        pull->max_piece = piece;
    }
    if (tension < pull->min_tension) {
        pull->min_tension = tension;
        pull->min_at = s;
        pull->min_piece = piece;
    }
}

/* The largest of it on a span: a cable that is pushed presses outward as hard as one that is pulled presses inward. */
static double span_sidewall(const PullSpan *span)
{
    const SpanExtremes *e = &span->extremes;
    return e->max_pressure * span->share;
}

/* Takes one finished span into the pull's extremes. */
static void take_span(Pull *pull, const PullSpan *span)
{
    const SpanExtremes *e = &span->extremes;
    take_tension(pull, span->piece, e->max_at, e->max_tension);
    take_tension(pull, span->piece, e->min_at, e->min_tension);
    const double sidewall = span_sidewall(span);
    if (sidewall > pull->max_sidewall) {
        pull->max_sidewall = sidewall;
        pull->sidewall_at = e->pressure_at;
        pull->sidewall_piece = span->piece;
    }
}

/* Whether a span of a pull solved before is this one, with what follows from it. */
static int span_known(const PullDef *def, const PullStretch *a, const PullSpan *span, const PullSpan *known)
{
    const SpanLaw *const law = &known->law;
    const double mu = def->restart ? fmax(a->mu, a->mu_static) : a->mu;
    return known->s0 == span->s0 && known->s1 == span->s1 && known->t0 == span->t0 && law->law == def->law &&
           law->weight == a->weight && law->lightest == a->lightest && law->least == def->least && law->mu == mu &&
           law->room == a->room && law->ei == a->ei && law->separate == a->separate;
}

/* Integrates from cut to cut, in the pull's order, adding the steps between. */
static void run_spans(const PullDef *def, int n, const double *cut, const StepAt *step, Pull *pull)
{
    const int forward = def->to > def->from;
    int next = 0;
    double tension = def->start_tension;
    take_tension(pull, route_at(def->route, cut[forward ? 0 : n - 1]).piece, def->from, tension);
    for (int i = 0; i < n - 1; i++) {
        const double low = cut[forward ? i : n - 2 - i], high = cut[forward ? i + 1 : n - 1 - i];
        PullSpan *span = &pull->span[i];
        *span = (PullSpan){.s0 = forward ? low : high, .s1 = forward ? high : low};
        const double middle = low + (high - low) / 2;
        const PullStretch *const a = stretch_at(def->n_stretches, def->stretch, middle);
        span->t0 = steps_pass(def, step, &next, span->s0, tension);
        if (def->forces_only && def->like && i < def->like->n && span_known(def, a, span, &def->like->span[i])) {
            *span = def->like->span[i];
            tension = span->t1;
            continue;
        }
        span->piece = route_at(def->route, middle).piece;
        span->law = law_between(def, a, middle);
        span->share = a->share > 0 ? a->share : 1;
        span->extremes = (SpanExtremes){.max_tension = -INFINITY, .min_tension = INFINITY, .enough = def->enough};
        SpanExtremes *const extremes = def->forces_only ? NULL : &span->extremes;
        tension = span->t1 = span_integrate(&span->law, span->s0, span->t0, span->s1, extremes);
        if (!isfinite(tension)) {
            pull->end_tension = tension;
            return;
        }
        span->least = span->extremes.min_tension;
        span->least_at = span->extremes.min_at;
        if (extremes) take_span(pull, span);
    }
    pull->end_tension = steps_pass(def, step, &next, def->to, tension);
    take_tension(pull, pull->span[n - 2].piece, def->to, pull->end_tension);
}

hawser_status pull_solve(const PullDef *def, Pull *out, hawser_error *err)
{
    *out = (Pull){.start_tension = def->start_tension, .max_tension = -INFINITY, .min_tension = INFINITY};
    hawser_status status = check_def(def, err);
    if (status) return status;
    double *cut = malloc((size_t)(def->route->n + def->n_stretches + def->n_steps + 3) * sizeof *cut);
    StepAt *step = malloc((size_t)(def->n_steps + 1) * sizeof *step);
    if (!cut || !step) {
        free(cut);
        free(step);
        return error_memory(err);
    }
    const int n = collect_cuts(def, cut);
    assert(n >= 2);
    out->n = n - 1;
    out->span = malloc((size_t)out->n * sizeof *out->span);
    if (out->span) {
        steps_sort(def, step);
        run_spans(def, n, cut, step, out);
        if (!isfinite(out->end_tension)) {
            status = error_set(err, HAWSER_ERR_INPUT, "the tension grows past all bounds: too much friction and turn");
        }
    } else {
        status = error_memory(err);
    }
    free(cut);
    free(step);
    if (status) pull_clear(out);
    return status;
}

void pull_clear(Pull *pull)
{
    free(pull->span);
    *pull = (Pull){0};
}

/* The span that holds s: the first one, in the pull's order, whose end is not before s. */
static const PullSpan *find_span(const Pull *pull, double s)
{
    int low = 0, high = pull->n - 1;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        const PullSpan *span = &pull->span[middle];
        if (span->law.direction * (span->s1 - s) >= 0) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return &pull->span[low];
}

/* The tension at s from the start of its span; the ends are what pull_solve found. */
static double span_tension(const Pull *pull, const PullSpan *span, double s)
{
    if (s == pull->span[0].s0) return pull->start_tension;
    return s == span->s1 ? span->t1 : span_integrate(&span->law, span->s0, span->t0, s, NULL);
}

PullPoint pull_at(const Pull *pull, double s)
{
    assert(pull->n > 0);
    const double first = pull->span[0].s0, last = pull->span[pull->n - 1].s1;
    const double at = fmin(fmax(s, fmin(first, last)), fmax(first, last));
    const PullSpan *span = find_span(pull, at);
    PullPoint point = {.tension = span_tension(pull, span, at), .piece = span->piece};
    const SpanFrame frame = span_frame(&span->law.line, at);
    point.normal = span_normal(&span->law, at, point.tension);
    point.support = span_support(&span->law, at, point.tension);
    point.sidewall = fabs(point.tension) * frame.curvature * span->share;
    point.slope = asin(fmax(-1, fmin(1, frame.tz)));
    return point;
}

PieceExtremes pull_extremes_from(const Pull *pull, int first)
{
    PieceExtremes out = {0};
    for (int i = first; i < pull->n && pull->span[i].piece == pull->span[first].piece; i++) {
        const PullSpan *span = &pull->span[i];
        out.tension = fmax(out.tension, span->extremes.max_tension);
        out.sidewall = fmax(out.sidewall, span_sidewall(span));
        out.either = fmax(out.either, fmax(span->extremes.max_tension, -span->extremes.min_tension));
        out.down = fmax(out.down, span->extremes.max_down);
        out.aside = fmax(out.aside, span->extremes.max_aside);
    }
    return out;
}

PieceExtremes pull_piece_extremes(const Pull *pull, int piece)
{
    for (int i = 0; i < pull->n; i++) {
        if (pull->span[i].piece == piece) return pull_extremes_from(pull, i);
    }
    return (PieceExtremes){0};
}
