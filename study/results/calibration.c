/* What a calibration has found: parameters with their intervals, and what the log cannot tell. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "study/results/results.h"

/* Beyond which two estimates cannot be told apart, and below which a direction is not seen at all. */
static const double TOGETHER = 0.95, UNSEEN = 1e-5;

static void warn(Findings *f, const char *format, const char *a, const char *b)
{
    if (f->n_warnings < WARNINGS_MAX) snprintf(f->warning[f->n_warnings++], WARNING_MAX, format, a, b);
}

/* Bounds that were met, intervals as wide as the range, pairs, and what is not seen. */
static void warnings_find(const Study *s, const FitResult *x, Findings *f)
{
    for (int j = 0; j < s->n_parameters; j++) {
        const Parameter *const p = &s->parameter[j];
        if (x->at_bound[j])
            warn(f, "%s lies at its bound '%s': the log wants it beyond", p->name, x->at_bound[j] < 0 ? "from" : "to");
        else if (x->half[j] > (p->law.b - p->law.a) / 2)
            warn(f, "the log says nothing of %s: its interval is as wide as its range%s", p->name, "");
        for (int k = 0; k < j; k++) {
            if (fabs(x->correlation[j][k]) > TOGETHER)
                warn(f, "%s and %s cannot be told apart: one makes up for the other", s->parameter[k].name, p->name);
        }
    }
    if (x->least_singular > UNSEEN || s->n_parameters < 2) return;
    int a = 0, b = -1; /* the largest shares of what is not seen */
    for (int j = 1; j < s->n_parameters; j++) a = fabs(x->weakest[j]) > fabs(x->weakest[a]) ? j : a;
    for (int j = 0; j < s->n_parameters; j++) {
        if (j != a && (b < 0 || fabs(x->weakest[j]) > fabs(x->weakest[b]))) b = j;
    }
    warn(f, "the log does not see %s and %s together at all", s->parameter[a].name, s->parameter[b].name);
}

hawser_status calibration_find(const Study *s, const Rows *rows, Findings *f, hawser_error *err)
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
    f->fit_sample = -1; /* the sample of the best point: its curve is that of the fit */
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
