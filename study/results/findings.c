/* From rows to findings. Sums go over samples in their order, so that they do not depend on who computed which. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "study/results/results.h"

/* ------------------------------------------------------------------------------------------------- verdicts, limits */

/* An interval belongs to samples that are drawn: variants that somebody chose are all there are. */
static Share share_in(const Study *s, long hits, long n)
{
    const Share share = share_of(hits, n);
    return s->kind == STUDY_MONTE_CARLO ? share : (Share){share.value, NAN, NAN};
}

/* Not judged as a whole, or safe with what is assumed alone, but none of the limits that could be judged is broken:
 * left out, what is judged would be what is broken. */
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

/* Whether some samples have no run, so that runs are those near a limit. */
static int runs_are_chosen(const Study *s, const Rows *rows)
{
    long by_theory = 0;
    for (long i = 0; i < rows->n; i++)
        by_theory += rows->row[i].state == ROW_DONE && rows->row[i].answered == BY_THEORY;
    return s->fidelity == BY_BOTH && !study_searches(s) && by_theory > 0;
}

/* Whether theory never judges a limit. */
static int by_runs_alone(const Rows *rows, int limit)
{
    for (long i = 0; i < rows->n; i++) {
        const Row *const row = &rows->row[i];
        if (row->state == ROW_DONE && row->answered == BY_THEORY && !isnan(row->margin[limit])) return 0;
    }
    return 1;
}

/* x: scratch [rows->n]. */
static void limits_find(const Study *s, const Rows *rows, double *x, Findings *f)
{
    for (int k = 0; k < LIMIT_KINDS; k++) {
        LimitRow row = {.name = limits_name((hawser_limit_kind)k), .band = NAN, .off = f->off[k]};
        if (s->fidelity == BY_BOTH) row.band = s->close[k];
        const int pilots_alone = f->chosen && by_runs_alone(rows, k);
        int n = 0;
        for (long i = 0; i < rows->n; i++) {
            const Row *const r = &rows->row[i];
            const double margin = isnan(r->margin[k]) ? r->theory[k] : r->margin[k]; /* a run may not judge it */
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

/* Of runs that are chosen the pilots alone are a fair draw. */
double quantity_fair(const Study *s, const Rows *rows, const Findings *f, int q, long i)
{
    if (rows->row[i].state != ROW_DONE) return NAN;
    if (f->chosen && s->quantity[q].of == BY_RUN && !is_pilot(s, i)) return NAN;
    return rows->value[i * rows->width + q];
}

/* The values of quantity q into x[rows->n]. */
static void values_of(const Study *s, const Rows *rows, const Findings *f, int q, double *x)
{
    for (long i = 0; i < rows->n; i++) x[i] = quantity_fair(s, rows, f, q, i);
}

const char *first_unit(const Study *s) { return s->n_quantities > 0 ? unit_of_key(s->quantity[0].path) : ""; }

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

/* By 10, 20, 50, 100 ... samples, and by all: of points that are drawn, as far as all of them are there. */
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

/* Of quantity q; 0 without memory. Blocks that are not all there do not count. */
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

void point_say(const Study *s, const Rows *rows, long i, char text[VARIANT_TEXT_MAX])
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

/* One by one, where people can read them all. */
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
