#include "theory/plan_change.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "theory/plan_pull.h"

/* ----------------------------------------------------------------------------------------------------- along a span */

/* What is integrated: the tension, and what each cause makes of it (SN4). */
enum { OF_TENSION, BY_TENSION, BY_FRICTION, BY_WEIGHT, VALUES };
/* Share of each value that a step may be off by; share of its force below which a support counts as bare. */
static const double STEP_TOLERANCE = 1e-12, ZERO_FORCE = 1e-11;

static double sign_of(double x) { return (x > 0) - (x < 0); }

/* Of a cable that is pushed so far that it snakes or coils, (SN2a). */
static SpanSlopes coiled_slopes(const SpanLaw *p, double straight, SpanSlopes by, double tension)
{
    const double helix = p->room * tension * tension / (4 * p->ei), grows = p->room * tension / (2 * p->ei);
    double slope;
    if (!(helix > straight)) return by;
    const double times = straight > 0 ? span_coils(helix / straight, &slope) : INFINITY;
    if (!(times < INFINITY)) return (SpanSlopes){grows, 0};
    const double rest = times - helix / straight * slope;
    return (SpanSlopes){rest * by.by_tension + slope * grows, rest * by.by_weight};
}

/* (SN2). A support that bears nothing bears what comes first: the weight, or a tension that begins. */
static SpanSlopes resultant_slopes(const SpanLaw *p, SpanFrame f, double tension)
{
    const double kappa = p->law == PULL_REFERENCE ? f.curvature : 0, pull = tension * kappa;
    const double g = pull - p->weight * f.nz, side = p->weight * f.bz, n = hypot(g, side), c = hypot(f.nz, f.bz);
    if (pull == 0) return (SpanSlopes){n > 0 ? kappa * g / n : kappa, c};
    if (!(n > ZERO_FORCE * (fabs(pull) + p->weight))) return (SpanSlopes){0, 0};
    return (SpanSlopes){kappa * g / n, (f.bz * side - f.nz * g) / n};
}

/* (SN3). */
static SpanSlopes separate_slopes(const SpanLaw *p, SpanFrame f, double tension)
{
    const double kappa = p->law == PULL_REFERENCE ? f.curvature : 0, c = hypot(f.nz, f.bz);
    if (!(c > 0)) return (SpanSlopes){kappa * (tension < 0 ? -1 : 1), 0};
    const double down = p->weight * c - tension * kappa * f.nz / c, aside = tension * kappa * f.bz / c;
    const double lies = down == 0 ? 1 : sign_of(down), holds = aside == 0 ? sign_of(f.bz) : sign_of(aside);
    return (SpanSlopes){kappa * (holds * f.bz - lies * f.nz) / c, lies * c};
}

SpanSlopes span_slopes(const SpanLaw *p, double s, double tension)
{
    const SpanFrame f = span_frame(&p->line, s);
    const SpanSlopes by = (p->separate ? separate_slopes : resultant_slopes)(p, f, tension);
    const int may_coil = tension < 0 && p->room > 0 && p->law == PULL_REFERENCE && !p->separate;
    return may_coil ? coiled_slopes(p, span_straight(p, s, tension), by, tension) : by;
}

/* (T5), (SN4); of unlike weights by the one that counts, which is best there, so that its own change makes none. */
static void rates(const SpanLaw *unlike, double s, const double x[VALUES], double rate[VALUES])
{
    const SpanLaw one = span_weighed(unlike, s, x[OF_TENSION]), *const p = &one;
    const SpanSlopes by = span_slopes(p, s, x[OF_TENSION]);
    const double a = p->mu * by.by_tension, sine = p->direction * span_frame(&p->line, s).tz;
    rate[OF_TENSION] = span_rate(p, s, x[OF_TENSION]);
    rate[BY_TENSION] = a * x[BY_TENSION];
    rate[BY_FRICTION] = a * x[BY_FRICTION] + span_normal(p, s, x[OF_TENSION]);
    rate[BY_WEIGHT] = a * x[BY_WEIGHT] + p->mu * by.by_weight + sine;
}

/* One step of Fehlberg's 4(5) pair over h along the pull, the fifth order taken: returns the largest error as a share
 * of what is allowed. */
static double gain_step(const SpanLaw *p, double s, const double x[VALUES], double h, double end[VALUES])
{
    enum { STAGES = 6 };
    static const double C[STAGES] = {0, 1.0 / 4, 3.0 / 8, 12.0 / 13, 1, 1.0 / 2};
    static const double A[STAGES][STAGES - 1] = {
        {0},
        {1.0 / 4},
        {3.0 / 32, 9.0 / 32},
        {1932.0 / 2197, -7200.0 / 2197, 7296.0 / 2197},
        {439.0 / 216, -8, 3680.0 / 513, -845.0 / 4104},
        {-8.0 / 27, 2, -3544.0 / 2565, 1859.0 / 4104, -11.0 / 40},
    };
    static const double B[STAGES] = {16.0 / 135, 0, 6656.0 / 12825, 28561.0 / 56430, -9.0 / 50, 2.0 / 55};
    static const double E[STAGES] = {1.0 / 360, 0, -128.0 / 4275, -2197.0 / 75240, 1.0 / 50, 2.0 / 55};
    double k[STAGES][VALUES], worst = 0;
    for (int i = 0; i < STAGES; i++) {
        double at[VALUES];
        for (int v = 0; v < VALUES; v++) {
            at[v] = x[v];
            for (int j = 0; j < i; j++) at[v] += h * A[i][j] * k[j][v];
        }
        rates(p, s + p->direction * C[i] * h, at, k[i]);
    }
    for (int v = 0; v < VALUES; v++) {
        double sum = 0, error = 0, size = 0;
        for (int i = 0; i < STAGES; i++) {
            sum += B[i] * k[i][v];
            error += E[i] * k[i][v];
            size = fmax(size, fabs(k[i][v]));
        }
        end[v] = x[v] + h * sum;
        const double allowed = STEP_TOLERANCE * (fabs(x[v]) + h * size);
        if (allowed > 0) worst = fmax(worst, h * fabs(error) / allowed);
    }
    return worst;
}

/* Which side each support bears on, of unlike weights which one counts, as one number; it changes where the law has a
 * corner. Within rounding of a corner it is that of no side. */
static int sides(const SpanLaw *p, double s, double tension)
{
    if (p->lightest > 0) return span_weighed(p, s, tension).weight < p->weight ? 2 : 1;
    if (tension < 0 && p->room > 0 &&
        p->law == PULL_REFERENCE) { /* it lies straight, snakes, is about to coil, coils */
        const double square = p->room * tension * tension / (4 * p->ei * span_straight(p, s, tension));
        if (square > 1) return 10 + (square > 2) + (square > 3.3431457505076194);
    }
    const SpanFrame f = span_frame(&p->line, s);
    const double pull = p->law == PULL_REFERENCE ? tension * f.curvature : 0, c = hypot(f.nz, f.bz);
    const double bare = ZERO_FORCE * (fabs(pull) + p->weight);
    if (!p->separate && fabs(f.bz) > ZERO_FORCE) return 0;
    const double g = p->separate && c > 0 ? p->weight * c - pull * f.nz / c : pull - p->weight * f.nz;
    const int tight = tension == 0 || !p->separate ? 0 : (tension > 0 ? 3 : -3);
    return (fabs(g) > bare ? (int)sign_of(g) : 0) + tight;
}

/* Half as long until both ends are on the same sides of the corner: the step then ends before it, within 1e-13 of the
 * span, and the next begins behind it. */
SpanGain span_gain(const SpanLaw *p, double s0, double tension, double s1)
{
    const double length = p->direction * (s1 - s0), least = 1e-13 * length;
    double x[VALUES] = {tension, 1, 0, 0}, end[VALUES], at = 0, h = length;
    while (at < length) {
        const double s = s0 + p->direction * at;
        if (h > length - at) h = length - at;
        const double worst = gain_step(p, s, x, h, end);
        const double grow = worst > 0 ? fmin(5, fmax(0.2, 0.9 * pow(worst, -0.2))) : 5;
        const int before = sides(p, s, x[OF_TENSION]), after = sides(p, s + p->direction * h, end[OF_TENSION]);
        const int corner = before != 0 && after != 0 && before != after;
        if ((worst > 1 || corner) && h > least) {
            h *= worst > 1 && !corner ? grow : 0.5;
            continue;
        }
        at = h >= length - at ? length : at + h;
        for (int v = 0; v < VALUES; v++) x[v] = end[v];
        h *= corner ? 1e6 : grow;
    }
    return (SpanGain){x[BY_TENSION], x[BY_FRICTION], x[BY_WEIGHT]};
}

/* ----------------------------------------------------------------------------------------------------- along a pull */

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
