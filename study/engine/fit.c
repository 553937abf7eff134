/* A calibration over samples: the force of theory at the log's places less the log's, and a fit that goes on where it
 * was by meeting the samples that are there again. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "study/engine/engine.h"

typedef struct Trail {
    const Study *study;
    const Rows *known;
    SampleAsk ask; /* NULL: nothing is asked for */
    void *user;
    long n; /* samples that it has met */
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
    const FitPlan plan = {box.n, s->measured.n, box.from, box.to, box.start, (int)s->samples};
    Trail trail = {.study = s, .known = known, .ask = ask, .user = user};
    trail.value = malloc((size_t)row_width(s) * sizeof *trail.value);
    const int ok = trail.value && fit_run(&plan, trail_try, &trail, result);
    *other = trail.other;
    free(trail.value);
    return ok;
}
