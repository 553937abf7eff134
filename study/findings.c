/* Findings of a calibration: parameters with their intervals, and what the log cannot determine. */
#include "study/findings.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"

static void point_say(const Study *s, const Rows *rows, long i, char text[VARIANT_TEXT_MAX]);
static hawser_status responses_find(const Study *s, const Rows *rows, Findings *f, hawser_error *err);

/* Correlation from which two estimates count as inseparable; share below which a direction counts as undetermined. */
static const double TOGETHER = 0.95, UNSEEN = 1e-5;

static void warn(Findings *f, const char *format, const char *a, const char *b)
{
    if (f->n_warnings < WARNINGS_MAX) snprintf(f->warning[f->n_warnings++], WARNING_MAX, format, a, b);
}

/* Writes warnings: bounds reached, intervals as wide as the range, correlated pairs, undetermined directions. */
static void warnings_find(const Study *s, const FitResult *x, Findings *f)
{
    for (int j = 0; j < s->n_parameters; j++) {
        const Parameter *const p = &s->parameter[j];
        if (x->at_bound[j])
            warn(f, "%s is at its bound '%s': the log fits better beyond it", p->name,
                 x->at_bound[j] < 0 ? "from" : "to");
        else if (x->half[j] > (p->law.b - p->law.a) / 2)
            warn(f, "the log does not determine %s: its interval is as wide as its range%s", p->name, "");
        for (int k = 0; k < j; k++) {
            if (fabs(x->correlation[j][k]) > TOGETHER)
                warn(f, "%s and %s cannot be separated: one compensates the other", s->parameter[k].name, p->name);
        }
    }
    if (x->least_singular > UNSEEN || s->n_parameters < 2) return;
    int a = 0, b = -1; /* largest shares of the undetermined direction */
    for (int j = 1; j < s->n_parameters; j++) a = fabs(x->weakest[j]) > fabs(x->weakest[a]) ? j : a;
    for (int j = 0; j < s->n_parameters; j++) {
        if (j != a && (b < 0 || fabs(x->weakest[j]) > fabs(x->weakest[b]))) b = j;
    }
    warn(f, "the log does not determine %s and %s together", s->parameter[a].name, s->parameter[b].name);
}

/* Evaluates the fit of a calibration with the available samples. Errors: MEMORY. */
static hawser_status calibration_find(const Study *s, const Rows *rows, Findings *f, hawser_error *err)
{
    int other;
    FitResult *const x = &f->fit;
    if (!fit_samples(s, rows, NULL, NULL, &other, x)) return error_memory(err);
    f->fitted = calloc((size_t)s->n_parameters + 1, sizeof *f->fitted);
    if (!f->fitted) return error_memory(err);
    for (int j = 0; j < s->n_parameters; j++) {
        const Parameter *const p = &s->parameter[j];
        FittedRow *const row = &f->fitted[f->n_fitted++];
        *row = (FittedRow){.name = p->name, .unit = p->unit, .value = x->x[j], .half = x->half[j], .said = ""};
        row->low = x->x[j] - x->half[j];
        row->high = x->x[j] + x->half[j];
        if (x->at_bound[j]) row->said = "at its bound";
        for (int k = 0; k < s->n_parameters; k++) {
            if (k == j || isnan(x->correlation[j][k]) || fabs(x->correlation[j][k]) <= fabs(row->correlation)) continue;
            row->correlation = x->correlation[j][k];
            row->with = s->parameter[k].name;
        }
    }
    f->fit_sample = -1; /* sample of the best point: its curve is that of the fit */
    for (long i = 0; i < rows->n; i++) {
        if (rows->row[i].state == ROW_OPEN) continue;
        double at[PARAMETERS_MAX];
        int same = 1;
        row_point(s, rows, i, at);
        for (int j = 0; j < s->n_parameters; j++) same &= at[j] == x->x[j];
        if (same) f->fit_sample = i;
    }
    double mean = 0;
    for (int k = 0; k < s->measured.n; k++) mean += s->measured.point[k].force / s->measured.n;
    f->fit_rms_pct = 100 * x->rms / mean;
    if (x->done) warnings_find(s, x, f);
    return HAWSER_OK;
}

/* Findings of a search: the best designs, and how each search ended. */

/* Value of a row in the search: objective and (SR1). broken [constraints]: scratch. */
static DesignRow design_of(const Study *s, const Rows *rows, long i, double *broken)
{
    double x[PARAMETERS_MAX];
    const Row *const row = &rows->row[i];
    DesignRow d = {.sample = i, .search = i / s->aim.evaluations, .value = NAN, .broken = NAN};
    if (row->state == ROW_OPEN) return d;
    row_point(s, rows, i, x);
    d.value = aim_value(s, row, rows->value + i * rows->width, x, broken);
    d.broken = search_broken(d.value, broken, aim_constraints(s));
    d.verdict = row_verdict(row->verdict);
    d.limited_by = row->limited_by < 0 ? "" : limits_name((hawser_limit_kind)row->limited_by);
    d.margin = row->limited_by < 0 ? NAN : row->margin[row->limited_by];
    return d;
}

/* Checks whether two points of a search are alike: within a hundredth of every side of the box, with equal whole
 * numbers. */
static int points_alike(const Study *s, const Rows *rows, long i, long k)
{
    double a[PARAMETERS_MAX], b[PARAMETERS_MAX];
    row_point(s, rows, i, a);
    row_point(s, rows, k, b);
    for (int j = 0; j < s->n_parameters; j++) {
        const Parameter *const p = &s->parameter[j];
        const double near = p->whole ? 0 : 0.01 * (p->law.b - p->law.a);
        if (fabs(a[j] - b[j]) > near) return 0;
    }
    return 1;
}

/* Inserts a design among the n best so far, unless it is like a better one; of equals the earlier one stays first.
 * Returns the new number. */
static int design_place(const Study *s, const Rows *rows, DesignRow *best, int n, const DesignRow *d)
{
    int at = n;
    while (at > 0 && search_better(d->value, d->broken, best[at - 1].value, best[at - 1].broken)) at--;
    for (int k = 0; k < at; k++) {
        if (points_alike(s, rows, best[k].sample, d->sample)) return n;
    }
    if (at == DESIGNS_MAX) return n;
    int kept = at; /* designs after it that are not like it */
    DesignRow after[DESIGNS_MAX];
    for (int k = at; k < n; k++) {
        if (!points_alike(s, rows, best[k].sample, d->sample)) after[kept++ - at] = best[k];
    }
    if (kept == DESIGNS_MAX) kept--;
    best[at] = *d;
    for (int k = at; k < kept; k++) best[k + 1] = after[k - at];
    return kept + 1;
}

const char *aim_unit(const Study *s)
{
    return s->aim.n_terms == 1 && fabs(s->aim.term[0].weight) == 1 ? unit_of_key(s->aim.name) : "";
}

/* Finds the designs. A search with fewer points than allowed has ended by itself, or was stopped with the study, which
 * is unknown until the study is complete. */
static hawser_status designs_find(const Study *s, const Rows *rows, Findings *f, hawser_error *err)
{
    double *const broken = malloc((size_t)aim_constraints(s) * sizeof *broken + 1);
    f->search = broken ? calloc((size_t)s->blocks + 1, sizeof *f->search) : NULL;
    if (!f->search) {
        free(broken);
        return error_memory(err);
    }
    for (long c = 0; c < s->blocks; c++) {
        SearchRow *const row = &f->search[f->n_searches++];
        *row = (SearchRow){.search = c, .value = NAN, .broken = NAN, .best = -1};
        for (long i = c * s->aim.evaluations; i < (c + 1) * s->aim.evaluations; i++) {
            const DesignRow d = design_of(s, rows, i, broken);
            if (rows->row[i].state == ROW_OPEN) break;
            row->evaluations++;
            if (isnan(d.value)) continue;
            f->n_designs = design_place(s, rows, f->design, f->n_designs, &d);
            if (row->best >= 0 && !search_better(d.value, d.broken, row->value, row->broken)) continue;
            row->value = d.value;
            row->broken = d.broken;
            row->best = i;
        }
        if (s->aim.most) row->value = -row->value;
        row->ended = row->evaluations == s->aim.evaluations ? "evaluations used up" : "found no better";
    }
    for (int k = 0; k < f->n_designs; k++) {
        DesignRow *const d = &f->design[k];
        if (s->aim.most) d->value = -d->value;
        point_say(s, rows, d->sample, d->values);
        d->unit = aim_unit(s);
        d->keeps = d->broken == 0 ? "yes" : "no";
    }
    free(broken);
    return HAWSER_OK;
}

/* From rows to findings. Sums run over samples in order, so that they do not depend on which process computed them. */

/* ------------------------------------------------------------------------------------------------- verdicts, limits */

/* Share with an interval for random samples; chosen variants are the whole population and have none. */
static Share share_in(const Study *s, long hits, long n)
{
    const Share share = share_of(hits, n);
    return s->kind == STUDY_MONTE_CARLO ? share : (Share){share.value, NAN, NAN};
}

/* Checks for a row without a broken limit that is not judged as a whole, or safe only with assumptions. If such rows
 * did not count, mostly broken ones would remain. */
static int holds_open(const Row *row)
{
    const int open = row->verdict == VERDICT_NOT_JUDGED || row->verdict == VERDICT_SAFE_ONLY_IF;
    return row->state == ROW_DONE && open && row->limited_by >= 0;
}

static void verdicts_count(const Study *s, const Rows *rows, Findings *f)
{
    for (int k = 0; k < LIMIT_KINDS; k++) f->off[k] = NAN;
    for (long i = 0; i < rows->n; i++) {
        const Row *const row = &rows->row[i];
        f->by_state[row->state]++;
        if (row->state != ROW_DONE) continue;
        f->by_verdict[row->verdict]++;
        if (s->fidelity != BY_BOTH || row->answered != BY_RUN) continue;
        f->runs++;
        for (int k = 0; k < LIMIT_KINDS; k++) {
            const double off = fabs(row->margin[k] - row->theory[k]);
            if (!isnan(off)) f->off[k] = isnan(f->off[k]) ? off : fmax(f->off[k], off);
        }
        f->changed += row->verdict != row->theory_verdict;
    }
    for (long i = 0; i < rows->n; i++) f->held += holds_open(&rows->row[i]);
    const long bad = f->by_verdict[VERDICT_NOT_SAFE], judged = bad + f->by_verdict[VERDICT_SAFE] + f->held;
    const double there = (double)(rows->n - f->by_state[ROW_OPEN]);
    f->not_safe = share_in(s, bad, judged);
    f->least_share = (double)bad / there;
    f->most_share = (there - (double)f->by_verdict[VERDICT_SAFE]) / there;
}

static int is_pilot(const Study *s, long i) { return s->pilot > 0 && study_is_pilot(s, i); }

/* Checks whether some samples have no run, so that runs are those near a limit. */
static int runs_are_chosen(const Study *s, const Rows *rows)
{
    long by_theory = 0;
    for (long i = 0; i < rows->n; i++)
        by_theory += rows->row[i].state == ROW_DONE && rows->row[i].answered == BY_THEORY;
    return s->fidelity == BY_BOTH && !study_searches(s) && by_theory > 0;
}

/* Checks whether theory never judges this limit. */
static int by_runs_alone(const Rows *rows, int limit)
{
    for (long i = 0; i < rows->n; i++) {
        const Row *const row = &rows->row[i];
        if (row->state == ROW_DONE && row->answered == BY_THEORY && !isnan(row->margin[limit])) return 0;
    }
    return 1;
}

/* Computes statistics of the limits. x: scratch [rows->n]. */
static void limits_find(const Study *s, const Rows *rows, double *x, Findings *f)
{
    for (int k = 0; k < LIMIT_KINDS; k++) {
        LimitRow row = {.name = limits_name((hawser_limit_kind)k), .band = NAN, .off = f->off[k]};
        if (s->fidelity == BY_BOTH) row.band = s->close[k];
        const int pilots_alone = f->chosen && by_runs_alone(rows, k);
        int n = 0;
        for (long i = 0; i < rows->n; i++) {
            const Row *const r = &rows->row[i];
            const double margin = isnan(r->margin[k]) ? r->theory[k] : r->margin[k]; /* a run need not judge it */
            if (r->state != ROW_DONE) continue;
            row.binds += r->verdict == VERDICT_NOT_SAFE && r->limited_by == k;
            if (isnan(margin) || (pilots_alone && !is_pilot(s, i))) continue;
            row.broken += margin < 0;
            x[n++] = margin;
        }
        if (n == 0 && row.binds == 0) continue;
        row.judged = n;
        row.share = share_percent(share_in(s, row.broken, n));
        row.least = sort_finite(n, x) ? x[0] : NAN;
        row.median = quantile_of_sorted(n, x, 0.5);
        f->limit[f->n_limits++] = row;
    }
}

/* ------------------------------------------------------------------------------------------------------ quantities */

/* Value of a quantity if it belongs to a fair sample: of chosen runs only the pilots are. */
static double quantity_fair(const Study *s, const Rows *rows, const Findings *f, int q, long i)
{
    if (rows->row[i].state != ROW_DONE) return NAN;
    if (f->chosen && s->quantity[q].of == BY_RUN && !is_pilot(s, i)) return NAN;
    return rows->value[i * rows->width + q];
}

/* Copies the values of quantity q to x[rows->n]. */
static void values_of(const Study *s, const Rows *rows, const Findings *f, int q, double *x)
{
    for (long i = 0; i < rows->n; i++) x[i] = quantity_fair(s, rows, f, q, i);
}

/* Unit of the first quantity, and of the objective; "": none, or a sum of several. */
static const char *first_unit(const Study *s) { return s->n_quantities > 0 ? unit_of_key(s->quantity[0].path) : ""; }

static void quantities_find(const Study *s, const Rows *rows, double *x, Findings *f)
{
    static const double p[5] = {0.05, 0.25, 0.5, 0.75, 0.95};
    for (int q = 0; q < s->n_quantities; q++) {
        QuantityRow *const row = &f->quantity[f->n_quantities++];
        quantity_column(s, q, row->name);
        row->unit = unit_of_key(s->quantity[q].path);
        values_of(s, rows, f, q, x);
        row->spread = spread_of((int)rows->n, x);
        if (s->kind != STUDY_MONTE_CARLO) row->spread.mean_error = NAN;
        const int n = sort_finite((int)rows->n, x);
        for (int k = 0; k < 5; k++) row->percentile[k] = quantile_of_sorted(n, x, p[k]);
    }
}

/* Computes estimates by 10, 20, 50, 100 ... samples, and by all, for random points up to the first missing one. */
static void convergence_find(const Study *s, const Rows *rows, double *x, Findings *f)
{
    static const int steps[3] = {1, 2, 5};
    long bad = 0, judged = 0, at = 0, there = 0;
    if (s->kind != STUDY_MONTE_CARLO) return;
    while (there < rows->n && rows->row[there].state != ROW_OPEN) there++;
    if (s->n_quantities > 0) values_of(s, rows, f, 0, x);
    for (int k = 3; at < there; k++) {
        const double next = steps[k % 3] * pow(10, k / 3);
        const long to = next < (double)there ? (long)next : there;
        for (; at < to; at++) {
            const Row *const row = &rows->row[at];
            bad += row->state == ROW_DONE && row->verdict == VERDICT_NOT_SAFE;
            judged += row->state == ROW_DONE && (row->verdict == VERDICT_NOT_SAFE || row->verdict == VERDICT_SAFE);
            judged += holds_open(row);
        }
        const Spread spread = s->n_quantities > 0 ? spread_of((int)at, x) : spread_of(0, NULL);
        f->convergence[f->n_convergence++] =
            (ConvergenceRow){at, share_percent(share_of(bad, judged)), spread.mean, spread.mean_error, first_unit(s)};
    }
}

/* -------------------------------------------------------------------------------------------------------- effects */

/* Computes the effects on quantity q from complete blocks; returns 0 without memory. */
static int effects_of(const Study *s, int q, const double *y, EffectRow *row)
{
    const int d = s->n_parameters;
    MorrisEffect effect[PARAMETERS_MAX];
    SobolIndex index[PARAMETERS_MAX];
    int n = -1;
    if (s->kind == STUDY_SOBOL) n = sobol_indices(s->seed, d, (int)s->blocks, y, index);
    if (s->kind == STUDY_MORRIS) n = morris_effects(s->seed, d, (int)s->blocks, y, effect) - 1;
    for (int j = 0; n >= 0 && j < d; j++) {
        row[j] = (EffectRow){.parameter = s->parameter[j].name, .n = n};
        quantity_column(s, q, row[j].quantity);
        if (s->kind == STUDY_SOBOL) row[j].index = index[j];
        if (s->kind != STUDY_MORRIS) continue;
        row[j].effect = effect[j];
        row[j].n = effect[j].n;
    }
    return n >= 0;
}

static hawser_status effects_find(const Study *s, const Rows *rows, double *x, Findings *f, hawser_error *err)
{
    if (s->kind != STUDY_SOBOL && s->kind != STUDY_MORRIS) return HAWSER_OK;
    for (int q = 0; q < s->n_quantities; q++) {
        values_of(s, rows, f, q, x);
        if (!effects_of(s, q, x, &f->effect[f->n_effects])) return error_memory(err);
        f->n_effects += s->n_parameters;
    }
    return HAWSER_OK;
}

/* Writes the point of a row, "count = 18, speed = 6 m/min", as far as it fits. */
static void point_say(const Study *s, const Rows *rows, long i, char text[VARIANT_TEXT_MAX])
{
    double x[PARAMETERS_MAX];
    char value[SETTING_MAX];
    int n = 0;
    row_point(s, rows, i, x);
    for (int j = 0; j < s->n_parameters && n < VARIANT_TEXT_MAX; j++) {
        const Parameter *const p = &s->parameter[j];
        const char *to = value;
        if (p->chosen) to = parameter_text(p, x[j], value);
        if (!p->chosen) snprintf(value, sizeof value, "%.6g%s%s", x[j], *p->unit ? " " : "", p->unit);
        n += snprintf(text + n, (size_t)(VARIANT_TEXT_MAX - n), "%s%s = %s", j ? ", " : "", s->parameter[j].name,
                      to ? to : "as it is");
    }
}

/* Lists variants one by one if their number is small enough to read. */
static void variants_list(const Study *s, const Rows *rows, Findings *f)
{
    if (s->kind >= STUDY_MONTE_CARLO || rows->n > VARIANTS_MAX) return;
    for (long i = 0; i < rows->n; i++) {
        const Row *const row = &rows->row[i];
        VariantRow *const to = &f->variant[f->n_variants];
        if (row->state != ROW_DONE) continue;
        *to = (VariantRow){.sample = i,
                           .verdict = row_verdict(row->verdict),
                           .limited_by = row->limited_by < 0 ? "" : limits_name((hawser_limit_kind)row->limited_by),
                           .margin = row->limited_by < 0 ? NAN : row->margin[row->limited_by],
                           .quantity = s->n_quantities > 0 ? rows->value[i * rows->width] : NAN,
                           .unit = first_unit(s)};
        point_say(s, rows, i, to->values);
        f->n_variants++;
    }
}

static void lost_find(const Rows *rows, Findings *f)
{
    const int most = sizeof f->lost / sizeof *f->lost;
    for (long i = 0; i < rows->n && f->n_lost < most; i++) {
        const Row *const row = &rows->row[i];
        if (row->state > ROW_DONE) f->lost[f->n_lost++] = (LostRow){i, row_states[row->state], row->reason};
    }
}

hawser_status findings_make(const Study *s, const Rows *rows, Findings *out, hawser_error *err)
{
    const size_t q = (size_t)s->n_quantities, d = (size_t)s->n_parameters;
    double *const x = malloc(((size_t)rows->n + 1) * sizeof *x);
    *out =
        (Findings){.quantity = calloc(q + 1, sizeof *out->quantity), .effect = calloc(q * d + 1, sizeof *out->effect)};
    hawser_status status = x && out->quantity && out->effect ? HAWSER_OK : error_memory(err);
    if (!status) {
        out->chosen = runs_are_chosen(s, rows);
        verdicts_count(s, rows, out);
        limits_find(s, rows, x, out);
        quantities_find(s, rows, x, out);
        convergence_find(s, rows, x, out);
        variants_list(s, rows, out);
        lost_find(rows, out);
        status = effects_find(s, rows, x, out, err);
        if (!status) status = responses_find(s, rows, out, err);
        if (!status && s->kind == STUDY_OPTIMISE) status = designs_find(s, rows, out, err);
        if (!status && s->kind == STUDY_CALIBRATE) status = calibration_find(s, rows, out, err);
    }
    free(x);
    if (status) findings_free(out);
    return status;
}

void findings_free(Findings *f)
{
    free(f->quantity);
    free(f->effect);
    free(f->search);
    free(f->fitted);
    free(f->tornado);
    free(f->response);
    *f = (Findings){.quantity = NULL};
}

/* Response of a quantity as one parameter goes from its low to its high values while the others vary: tornado and
 * response curves. docs/theory/94-studies.md, "Responses". */

/* A sample: value of a parameter and of the quantity. */
typedef struct Pair {
    double x, y;
    double rank_x, rank_y; /* from 0; equal values share their mean */
} Pair;

static int by_x(const void *a, const void *b)
{
    const Pair *const p = a, *const q = b;
    return (p->x > q->x) - (p->x < q->x);
}

static int by_y(const void *a, const void *b)
{
    const Pair *const p = a, *const q = b;
    return (p->y > q->y) - (p->y < q->y);
}

/* End of the items equal to pair[i] by the comparison by which they are sorted. */
static long equals_end(const Pair *pair, long n, long i, int (*by)(const void *, const void *))
{
    long end = i + 1;
    while (end < n && by(&pair[i], &pair[end]) == 0) end++;
    return end;
}

static void ranks_give(Pair *pair, long n, int of_x)
{
    int (*const by)(const void *, const void *) = of_x ? by_x : by_y;
    qsort(pair, (size_t)n, sizeof *pair, by);
    for (long i = 0, end; i < n; i = end) {
        end = equals_end(pair, n, i, by);
        for (long k = i; k < end; k++) *(of_x ? &pair[k].rank_x : &pair[k].rank_y) = (double)(i + end - 1) / 2;
    }
}

/* Collects the samples with both values, sorted by x; returns their number. */
static long pairs_find(const Study *s, const Rows *rows, const Findings *f, int j, int q, Pair *pair)
{
    double x[PARAMETERS_MAX];
    long n = 0;
    for (long i = 0; i < rows->n; i++) {
        const double y = quantity_fair(s, rows, f, q, i);
        if (isnan(y)) continue;
        row_point(s, rows, i, x);
        const double number = parameter_number(&s->parameter[j], x[j]);
        if (isfinite(number) && isfinite(y)) pair[n++] = (Pair){number, y, 0, 0};
    }
    ranks_give(pair, n, 0);
    ranks_give(pair, n, 1);
    return n;
}

/* Mean of y over the samples from..to-1 by rising x, where samples with equal x have equal weights. */
static double mean_between(const Pair *pair, long n, long from, long to)
{
    double sum = 0;
    for (long i = 0, end; i < to; i = end) {
        double group = 0;
        end = equals_end(pair, n, i, by_x);
        for (long k = i; k < end; k++) group += pair[k].y / (double)(end - i);
        const long inside = (end < to ? end : to) - (i > from ? i : from);
        if (inside > 0) sum += group * (double)inside;
    }
    return sum / (double)(to - from);
}

/* Computes means of y in the first and the last tenth, at least one sample each, and the rank correlation (ES4). */
static TornadoRow tornado_of(const Pair *pair, long n)
{
    const long tenth = n >= 10 ? n / 10 : 1;
    const double middle = (double)(n - 1) / 2;
    double product = 0, squares_x = 0, squares_y = 0;
    TornadoRow row = {.n = n};
    for (long i = 0; i < n; i++) {
        const double x = pair[i].rank_x - middle, y = pair[i].rank_y - middle;
        row.mean += pair[i].y / (double)n;
        product += x * y;
        squares_x += x * x;
        squares_y += y * y;
    }
    row.low = mean_between(pair, n, 0, tenth);
    row.high = mean_between(pair, n, n - tenth, n);
    row.rank = squares_x > 0 && squares_y > 0 ? product / sqrt(squares_x * squares_y) : squares_x > 0 ? 0 : NAN;
    row.swing = fabs(row.high - row.low);
    return row;
}

/* Computes the response in ten parts of the parameter's range. scratch: [n]. */
static int responses_of(const Pair *pair, long n, double *scratch, ResponseRow *row)
{
    const double from = pair[0].x, width = (pair[n - 1].x - from) / RESPONSE_PARTS;
    int parts = 0;
    long i = 0;
    for (int k = 0; k < RESPONSE_PARTS && width > 0; k++) {
        int m = 0;
        double x = 0;
        for (; i < n && (k == RESPONSE_PARTS - 1 || pair[i].x < from + (k + 1) * width); i++) {
            scratch[m++] = pair[i].y;
            x += pair[i].x;
        }
        if (m == 0) continue;
        const Spread spread = spread_of(m, scratch);
        sort_finite(m, scratch);
        row[parts++] = (ResponseRow){.at = x / m,
                                     .mean = spread.mean,
                                     .low = quantile_of_sorted(m, scratch, 0.05),
                                     .high = quantile_of_sorted(m, scratch, 0.95),
                                     .n = m};
    }
    return parts;
}

static int larger_swing(const void *a, const void *b)
{
    const TornadoRow *const p = a, *const q = b;
    return (p->swing < q->swing) - (p->swing > q->swing);
}

/* Finds responses of the first quantity to numeric parameters, for studies whose samples do not depend on earlier
 * results. */
static hawser_status responses_find(const Study *s, const Rows *rows, Findings *f, hawser_error *err)
{
    const size_t n = (size_t)rows->n + 1, d = (size_t)s->n_parameters + 1;
    f->tornado = calloc(d, sizeof *f->tornado);
    f->response = calloc(d * RESPONSE_PARTS, sizeof *f->response);
    Pair *const pair = malloc(n * sizeof *pair);
    double *const scratch = malloc(n * sizeof *scratch);
    const int ok = f->tornado && f->response && pair && scratch;
    for (int j = 0; j < s->n_parameters && s->n_quantities > 0 && ok && !study_searches(s); j++) {
        const Parameter *const p = &s->parameter[j];
        const long there = parameter_is_number(p) ? pairs_find(s, rows, f, j, 0, pair) : 0;
        if (there < 3) continue;
        TornadoRow *const row = &f->tornado[f->n_tornado++];
        *row = tornado_of(pair, there);
        row->name = p->name;
        row->unit = first_unit(s);
        ResponseRow *const part = f->response + f->n_responses;
        const int parts = responses_of(pair, there, scratch, part);
        for (int k = 0; k < parts; k++) part[k].parameter = j, part[k].name = p->name, part[k].unit = p->unit;
        f->n_responses += parts;
    }
    if (ok) qsort(f->tornado, (size_t)f->n_tornado, sizeof *f->tornado, larger_swing);
    free(pair);
    free(scratch);
    return ok ? HAWSER_OK : error_memory(err);
}
