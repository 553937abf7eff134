/* How the tension along a span follows small changes: the variational equation of (T5), of which tension, friction and
 * weight are the causes. docs/model.md, "Changes along a span". */
#include "theory/plan_change.h"

#include <math.h>

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
