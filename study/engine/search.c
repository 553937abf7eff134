/* A search over samples: what their answers mean to it, and a search that goes on where it was by meeting the samples
 * that are there again. */
#include <math.h>
#include <string.h>

#include "study/engine/engine.h"

/* --------------------------------------------------------------------------------------------------------- meaning */

int aim_constraints(const Study *s) { return s->aim.n_constraints + (s->aim.limits ? LIMIT_KINDS : 0) + 1; }

/* NAN: not known. */
static double asked_value(const Study *s, Asked a, const double *value, const double *x)
{
    return a.parameter >= 0 ? parameter_number(&s->parameter[a.parameter], x[a.parameter]) : value[a.quantity];
}

/* By how much of the bound a value is outside; -: within. What is not known is outside. */
static double constraint_broken(const Constraint *c, double value)
{
    const double low = c->least != 0 ? fabs(c->least) : 1, high = c->most != 0 ? fabs(c->most) : 1;
    const double below = isfinite(c->least) ? (c->least - value) / low : -1,
                 above = isfinite(c->most) ? (value - c->most) / high : -1;
    return isnan(value) ? 1 : fmax(below, above);
}

/* A limit that is not judged is no constraint, but where limits must hold the last one, the verdict's, is broken unless
 * it is SAFE; an answer that is not trusted breaks it in any case. */
double aim_value(const Study *s, const Row *row, const double *value, const double *x, double *broken)
{
    const Aim *const a = &s->aim;
    double objective = 0;
    int n = 0;
    for (int k = 0; k < a->n_terms; k++) objective += a->term[k].weight * asked_value(s, a->term[k].of, value, x);
    if (row->state != ROW_DONE || isnan(objective)) return NAN;
    for (; n < a->n_constraints; n++)
        broken[n] = constraint_broken(&a->constraint[n], asked_value(s, a->constraint[n].of, value, x));
    for (int k = 0; a->limits && k < LIMIT_KINDS; k++)
        broken[n++] = isnan(row->margin[k]) ? -1 : fmin(fmax(-row->margin[k], -1e3), 1e3);
    const int wrong = a->limits && row->verdict != VERDICT_SAFE && row->verdict != VERDICT_NOT_SAFE;
    broken[n] = wrong || row->verdict == VERDICT_NOT_TRUSTED ? 1 : -1;
    return a->most ? -objective : objective;
}

/* ---------------------------------------------------------------------------------------------------------- a trail */

typedef struct Trail {
    const Study *study;
    const Rows *known;
    SampleAsk ask;
    void *user;
    long first, n; /* its samples; how many it has met */
    int other;
    double value[1 << 13];
} Trail;

static int trail_try(void *user, const double *x, double *value, double *broken)
{
    Trail *const c = user;
    const Study *const s = c->study;
    const long i = c->first + c->n++;
    const double *kept = c->known->value + (size_t)i * (size_t)c->known->width;
    Row row = c->known->row[i];
    if (row.state == ROW_OPEN) {
        if (!c->ask(c->user, i, x, &row, c->value)) return 0;
        kept = c->value;
    } else if (memcmp(kept + s->n_quantities, x, (size_t)s->n_parameters * sizeof *x) != 0) {
        c->other = 1;
        return 0;
    }
    *value = aim_value(s, &row, kept, x, broken);
    return 1;
}

int search_samples(const Study *s, long c, const Rows *known, SampleAsk ask, void *user, int *other)
{
    double x[3 * PARAMETERS_MAX];
    unsigned char whole[PARAMETERS_MAX];
    const SearchBox box = study_box(s, x, whole);
    const SearchPlan plan = {.method = s->aim.method,
                             .constraints = aim_constraints(s),
                             .number = (int)c,
                             .of = s->aim.searches,
                             .evaluations = s->aim.evaluations,
                             .seed = s->seed,
                             .tolerance = s->aim.tolerance};
    Trail trail = {.study = s, .known = known, .ask = ask, .user = user, .first = c * s->aim.evaluations};
    const int ok = search_run(&box, &plan, trail_try, &trail);
    *other = trail.other;
    return ok;
}
