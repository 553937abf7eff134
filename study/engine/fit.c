/* A calibration over samples: the force of theory at the log's places less the log's, and a fit that goes on where it
 * was by meeting the samples that are there again. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "study/engine/engine.h"

/* Shares of the ranges: steps of differences, and steps at which the fit ends. A run's force has an error of its own,
 * of which a difference must be many times. */
static const double FOR_THEORY = 1e-3, FOR_RUNS = 2e-2, END_THEORY = 1e-7, END_RUNS = 1e-4;

typedef struct Trail {
    const Study *study;
    const Rows *known;
    SampleAsk ask; /* NULL: nothing is asked for */
    void *user;
    long n; /* the sample that it meets next */
    int other;
    double *value;
} Trail;

static int trail_try(void *user, const double *x, double *r)
{
    Trail *const t = user;
    const Study *const s = t->study;
    const size_t q = (size_t)s->n_quantities, d = (size_t)s->n_parameters;
    const long i = t->n++;
    const double *kept = t->known->value + (size_t)i * (size_t)t->known->width;
    Row row = t->known->row[i];
    if (row.state == ROW_OPEN) {
        if (!t->ask || !t->ask(t->user, i, x, &row, t->value)) return -1;
        kept = t->value;
    } else if (memcmp(kept + q, x, d * sizeof *x) != 0) {
        t->other = 1;
        return -1;
    }
    for (int k = 0; k < s->measured.n; k++)
        r[k] = (kept[q + d + (size_t)k] - s->measured.point[k].force) * s->measured.weight[k];
    return row.state == ROW_DONE;
}

int fit_samples(const Study *s, const Rows *known, SampleAsk ask, void *user, int *other, FitResult *result)
{
    double x[3 * PARAMETERS_MAX];
    unsigned char whole[PARAMETERS_MAX];
    const SearchBox box = study_box(s, x, whole);
    FitPlan plan = {box.n, s->measured.n, box.from, box.to, box.start, (int)s->aim.evaluations, FOR_THEORY, END_THEORY};
    Trail trail = {.study = s, .known = known, .ask = ask, .user = user};
    trail.value = malloc((size_t)row_width(s) * sizeof *trail.value);
    const int runs = s->fidelity == BY_RUN;
    if (runs) plan.difference = FOR_RUNS;
    if (runs) plan.small = END_RUNS;
    int ok = trail.value && fit_run(&plan, trail_try, &trail, result);
    if (ok && s->fidelity == BY_BOTH && result->done) {
        double begin[FIT_MAX]; /* off the bounds: from there the first step is not held */
        for (int j = 0; j < box.n; j++) {
            const double margin = FOR_RUNS * (box.to[j] - box.from[j]);
            begin[j] = fmin(fmax(result->x[j], box.from[j] + margin), box.to[j] - margin);
        }
        plan.start = begin;
        plan.difference = FOR_RUNS;
        plan.small = END_RUNS;
        trail.n = s->aim.evaluations;
        ok = fit_run(&plan, trail_try, &trail, result);
    }
    *other = trail.other;
    free(trail.value);
    return ok;
}
