/* What a search has found: the best designs, and how each search ended. */
#include <math.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "study/results/results.h"

/* What the search made of a row that is there: what it sought, and (SR1). broken [constraints]: scratch. */
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

/* Whether two points of a search are alike: within a hundredth of every side of the box, and the same whole numbers. */
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

/* Puts a design into its place among the best so far, n of them, unless it is like a better one; of equals the earlier
 * one stays before. Returns how many there are then. */
static int design_place(const Study *s, const Rows *rows, DesignRow *best, int n, const DesignRow *d)
{
    int at = n;
    while (at > 0 && search_better(d->value, d->broken, best[at - 1].value, best[at - 1].broken)) at--;
    for (int k = 0; k < at; k++) {
        if (points_alike(s, rows, best[k].sample, d->sample)) return n;
    }
    if (at == DESIGNS_MAX) return n;
    int kept = at; /* what follows and is not like it */
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

/* A search that has met fewer points than it may has ended by itself, or was stopped with the study: until the study
 * has been seen to its end nobody can say. */
hawser_status designs_find(const Study *s, const Rows *rows, Findings *f, hawser_error *err)
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
