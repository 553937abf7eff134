/* What a quantity does as one parameter goes from its low to its high values while the others vary: tornado and
 * response curves. docs/model/94-studies.md, "Responses". */
#include <math.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "study/results/results.h"

/* A sample: a parameter's value, the quantity's. */
typedef struct Pair {
    double x, y;
    double rank_x, rank_y; /* from 0; those that are equal share their mean */
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

/* The end of those that are equal to pair[i] by a comparison that they rise by. */
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

/* The samples with both, by rising x; returns how many. */
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

/* The mean of y over the samples from..to-1 by rising x, where of those with one x each counts as much as the others.
 */
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

/* Means of y in the first and the last tenth, at least one sample each, and the correlation of ranks (ES4). */
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

/* Ten parts of the parameter's range, each with what lies in it. scratch: [n]. */
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

/* Of the first quantity, over parameters that are numbers, of studies whose samples are not chosen by what came of
 * others. */
hawser_status responses_find(const Study *s, const Rows *rows, Findings *f, hawser_error *err)
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
