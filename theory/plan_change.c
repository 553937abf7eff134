#include "theory/plan_change.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "theory/plan_pull.h"

/* Share of what a machine takes by which a tension may be off and still is at one of its corners. */
static const double CORNER = 1e-9;

/* A machine that could take more begins to where something arrives, and ends where more arrives than it takes. */
static int at_corner(double tension, double takes)
{
    return takes > 0 && fmin(fabs(tension), fabs(tension - takes)) <= CORNER * takes;
}

/* What a unit of cause k adds to the friction of a span, by (PN4), and to its weight. */
static double friction_by(const PlanDef *def, int way, const PullSpan *span, int k)
{
    const double middle = (span->s0 + span->s1) / 2;
    const PullStretch *const on = stretch_at(def->n_stretches, def->stretch, middle);
    const int own =
        k >= CHANGE_OTHERS && k < CHANGE_OTHERS + def->n_stretches && on == &def->stretch[k - CHANGE_OTHERS];
    return k == CHANGE_FRICTION || own ? plan_friction_factor(def, way, plan_last(def, way), middle) : 0;
}

/* What a step at s makes of all changes of the tension (SN5), in the order in which the pull takes them: pushes, then
 * machines, then pits. before: the tension there. Returns the factor on what came in. */
static double steps_change(const PlanDef *def, int way, double s, double before, double *d, PlanChange *c)
{
    const PullStep *const push = way == PLAN_BACKWARD && def->push_back ? def->push_back : def->push;
    double tension = before, factor = 1;
    for (int i = 0; i < def->n_pushes; i++) {
        if (push[i].at != s) continue;
        tension -= push[i].force;
        if (d) d[CHANGE_OTHERS + def->n_stretches + i] -= 1;
    }
    for (int i = 0; i < def->n_steps; i++) {
        const PullStep *const step = &def->step[i];
        const int anew = step->kind == STEP_ANEW && s != plan_last(def, way), all = tension <= step->force;
        if (step->at != s || step->kind == STEP_ADD || (step->kind == STEP_ANEW && !anew)) continue;
        if (step->kind == STEP_TAKE && factor > 0 && at_corner(tension, step->force)) c->one_sided = 1;
        if (anew || (all && tension > 0)) factor = 0;
        if (step->kind == STEP_TAKE) tension -= fmin(fmax(tension, 0), step->force);
    }
    for (int k = 0; d && factor == 0 && k < c->n; k++) d[k] = 0;
    return factor;
}

/* From the start to the end: (SN4) span by span, (SN5) between. */
static void go_forward(const PlanDef *def, int way, PlanChange *c)
{
    const Pull *const pull = c->pull;
    const size_t n = (size_t)c->n;
    double *const d = c->force, tension = pull->start_tension;
    memset(d, 0, n * sizeof *d);
    d[CHANGE_START] = 1;
    d[CHANGE_WEIGHT] = def->reel_length; /* (T24) */
    c->weight[CHANGE_WEIGHT] = 1;
    for (int i = 0; i < pull->n; i++) {
        const PullSpan *const span = &pull->span[i];
        steps_change(def, way, span->s0, tension, d, c);
        const SpanGain gain = span_gain(&span->law, span->s0, span->t0, span->s1);
        c->reach[i] = gain.tension;
        for (int k = 0; k < c->n; k++) {
            const double mu = friction_by(def, way, span, k);
            c->start[(size_t)i * n + (size_t)k] = d[k];
            c->inside[(size_t)i * n + (size_t)k] = mu;
            d[k] = gain.tension * d[k] + gain.friction * mu + gain.weight * c->weight[k];
        }
        tension = span->t1;
    }
    steps_change(def, way, plan_last(def, way), tension, d, c);
    d[CHANGE_WEIGHT] += def->rope_length; /* (T25) */
}

/* From the end to the start: the gains of the spans multiplied up (SN8). */
static void go_back(const PlanDef *def, int way, PlanChange *c)
{
    const Pull *const pull = c->pull;
    double reach = steps_change(def, way, plan_last(def, way), pull->span[pull->n - 1].t1, NULL, c);
    for (int i = pull->n - 1; i >= 0; i--) {
        reach = c->reach[i] *= reach;
        const double before = i > 0 ? pull->span[i - 1].t1 : pull->start_tension;
        reach *= steps_change(def, way, pull->span[i].s0, before, NULL, c);
    }
}

hawser_status plan_change(const PlanDef *def, const Plan *plan, int way, PlanChange *out, hawser_error *err)
{
    const Pull *const pull = &plan->way[way].pull;
    *out = (PlanChange){.n = CHANGE_OTHERS + def->n_stretches + def->n_pushes, .pull = pull};
    const size_t n = (size_t)out->n, spans = (size_t)pull->n;
    out->start = calloc(spans * n, sizeof *out->start);
    out->inside = calloc(spans * n, sizeof *out->inside);
    out->weight = calloc(n, sizeof *out->weight);
    out->reach = calloc(spans, sizeof *out->reach);
    out->force = calloc(n, sizeof *out->force);
    if (!out->start || !out->inside || !out->weight || !out->reach || !out->force) return error_memory(err);
    go_forward(def, way, out);
    go_back(def, way, out);
    return HAWSER_OK;
}

void plan_change_free(PlanChange *c)
{
    free(c->start);
    free(c->inside);
    free(c->weight);
    free(c->reach);
    free(c->force);
    *c = (PlanChange){0};
}

void plan_change_at(const PlanChange *c, double s, double *tension, double *support, double *reach)
{
    const Pull *const pull = c->pull;
    int i = 0;
    while (i + 1 < pull->n && pull->span[i].law.direction * (pull->span[i].s1 - s) < 0) i++;
    const PullSpan *const span = &pull->span[i];
    const double *const start = &c->start[(size_t)i * (size_t)c->n], *const inside =
                                                                         &c->inside[(size_t)i * (size_t)c->n];
    const SpanGain gain = span_gain(&span->law, span->s0, span->t0, s);
    const double now = pull_at(pull, s).tension;
    const SpanLaw pressing = span_pressing(&span->law, s, now);
    const SpanSlopes by = span_slopes(&pressing, s, now);
    *reach = c->reach[i] / gain.tension;
    for (int k = 0; k < c->n; k++) {
        tension[k] = gain.tension * start[k] + gain.friction * inside[k] + gain.weight * c->weight[k];
        support[k] = by.by_tension * tension[k] + by.by_weight * c->weight[k];
    }
}
