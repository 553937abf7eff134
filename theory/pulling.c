#include "theory/pulling.h"

#include <assert.h>
#include <stddef.h>
#include <stdlib.h>

#include "core/error.h"
#include "theory/search.h"

/* Allowed local error of a step, relative to |T| + w |s1 - s0|. */
static const double STEP_TOLERANCE = 1e-12;

/* Share of weight (and of T/R) below which a normal force, or its part out of the bend's plane, counts as
 * zero. */
static const double ZERO_FORCE = 1e-11;

/* 1/m: curvature below which a curve counts as straight. */
static const double STRAIGHT_MAX = 1e-12;

/* Returns the frame toward the centre where a curve bends, else a straight's frame (RO16). */
static SpanFrame curve_frame(const RoutePoint *at)
{
    const double k = v3_norm(at->curvature), level = hypot(at->tangent.x, at->tangent.y);
    if (!(k > STRAIGHT_MAX)) return (SpanFrame){.tz = at->tangent.z, .nz = level};
    const Vec3 n = v3_scale(1 / k, at->curvature);
    return (SpanFrame){.curvature = k, .tz = at->tangent.z, .nz = n.z, .bz = v3_cross(at->tangent, n).z};
}

/* Checks for a curve of constant curvature in plan that keeps its grade (T7a). */
static int is_helix(const RoutePiece *p)
{
    const RouteCurve *const c = &p->curve;
    return p->kind == ROUTE_CURVE && c->profile == PROFILE_GRADE && c->sharp == 0 && c->axis[2].z == 1;
}

/* A direction's vertical component, without the rounding that a level bend has. */
static double rise_of(Vec3 direction) { return fabs(direction.z) > 1e-15 ? direction.z : 0; }

SpanLine span_line(const Route *route, double s)
{
    const RoutePoint at = route_at(route, s);
    SpanLine line = {.s_ref = s, .tz = at.tangent.z, .nz = hypot(at.tangent.x, at.tangent.y)};
    const RoutePiece *const p = &route->piece[at.piece];
    if (s >= 0 && s <= route->length && p->kind >= ROUTE_CURVE) {
        if (is_helix(p)) {
            const SpanFrame same = curve_frame(&at);
            return (SpanLine){.s_ref = s, .curvature = same.curvature, .tz = same.tz, .nz = same.nz, .bz = same.bz};
        }
        line.route = route;
        line.piece = at.piece;
    } else if (v3_norm(at.curvature) > 0) {
        line.s_ref = p->s0;
        line.curvature = line.turning = 1 / p->radius;
        line.tz = rise_of(p->tangent);
        line.nz = rise_of(p->centre);
        line.bz = v3_cross(p->tangent, p->centre).z;
    }
    return line;
}

SpanFrame span_frame(const SpanLine *line, double s)
{
    if (line->route) {
        const RoutePoint at = route_way_on_piece(line->route, line->piece, s);
        return curve_frame(&at);
    }
    if (line->turning == 0 || (line->tz == 0 && line->nz == 0)) /* straights, and level bends */
        return (SpanFrame){line->curvature, line->tz, line->nz, line->bz};
    const double turn = (s - line->s_ref) * line->turning, c = cos(turn), n = sin(turn);
    return (SpanFrame){.curvature = line->curvature,
                       .tz = c * line->tz + n * line->nz,
                       .nz = c * line->nz - n * line->tz,
                       .bz = line->bz};
}

/* Squares of the ratio of push to snaking load. From the first on, a moving cable is in transition from snaking to the
 * helix (Chen, Lin and Cheatham); from the second on it is a helix (Wu and Juvkam-Wold, 2 sqrt 2 - 1). */
static const double COILS_FROM = 2, COILS = 3.3431457505076194;

double span_coils(double square, double *slope)
{
    *slope = 1;
    if (!(square < COILS)) return square;
    const double over = square - 1, snakes = 1 + 0.18 * over + 0.1 * over * over, rises = 0.18 + 0.2 * over;
    const double all = sqrt(COILS) - sqrt(COILS_FROM), part = fmax(0, (sqrt(square) - sqrt(COILS_FROM)) / all);
    const double turns = part > 0 ? (square - snakes) / (2 * sqrt(square) * all) : 0;
    *slope = (1 - part) * rises + part + turns;
    return (1 - part) * snakes + part * square;
}

/* Support force per length of a cable in compression, N/m, (BK6). straight: that of a straight cable; tension < 0. */
static double coiled(const SpanLaw *p, double straight, double tension)
{
    const double helix = p->room * tension * tension / (4 * p->ei);
    double slope;
    if (!(helix > straight)) return straight;
    return helix < COILS * straight ? straight * span_coils(helix / straight, &slope) : helix;
}

/* (T6): the support balances T k n plus the weight's normal part, -w (nz n + bz b). */
static double straight_force(const SpanLaw *p, SpanFrame f, double tension)
{
    const double pull = p->law == PULL_REFERENCE ? tension * f.curvature : 0;
    return hypot(pull - p->weight * f.nz, p->weight * f.bz);
}

static double normal_force(const SpanLaw *p, SpanFrame f, double tension)
{
    const double straight = straight_force(p, f, tension);
    return tension < 0 && p->room > 0 && p->law == PULL_REFERENCE ? coiled(p, straight, tension) : straight;
}

double span_straight(const SpanLaw *p, double s, double tension)
{
    SpanLaw held = *p;
    held.room = 0;
    return span_normal(&held, s, tension);
}

/* (LI1), by the frame's vertical components. The slope's cosine c is the length of (nz, bz). */
static SpanParts support_parts(const SpanLaw *p, SpanFrame f, double tension)
{
    const double c = hypot(f.nz, f.bz);
    const double pull = p->law == PULL_REFERENCE ? tension * f.curvature : 0;
    if (!(c > 0)) return (SpanParts){.aside = pull}; /* vertical: the weight rests on nothing */
    return (SpanParts){.down = p->weight * c - pull * f.nz / c, .aside = pull * f.bz / c};
}

static double sum_of_supports(const SpanLaw *p, SpanFrame f, double tension)
{
    if (!p->separate) return normal_force(p, f, tension);
    const SpanParts parts = support_parts(p, f, tension);
    return fabs(parts.down) + fabs(parts.aside);
}

static SpanLaw with_weight(const SpanLaw *p, double weight)
{
    SpanLaw one = *p;
    one.weight = weight;
    one.lightest = 0;
    return one;
}

/* Returns the law with the weight that presses most in this frame. */
static SpanLaw pressing(const SpanLaw *p, SpanFrame f, double tension)
{
    if (!(p->lightest > 0)) return *p;
    const SpanLaw heavy = with_weight(p, p->weight), light = with_weight(p, p->lightest);
    return sum_of_supports(&light, f, tension) > sum_of_supports(&heavy, f, tension) ? light : heavy;
}

SpanLaw span_pressing(const SpanLaw *p, double s, double tension)
{
    return pressing(p, span_frame(&p->line, s), tension);
}

double span_normal(const SpanLaw *p, double s, double tension)
{
    const SpanFrame f = span_frame(&p->line, s);
    const SpanLaw one = pressing(p, f, tension);
    return sum_of_supports(&one, f, tension);
}

SpanParts span_parts(const SpanLaw *p, double s, double tension)
{
    const SpanFrame f = span_frame(&p->line, s);
    const SpanLaw one = pressing(p, f, tension);
    return p->separate ? support_parts(&one, f, tension) : (SpanParts){.down = normal_force(&one, f, tension)};
}

double span_support(const SpanLaw *p, double s, double tension)
{
    const SpanParts parts = span_parts(p, s, tension);
    return fmax(fabs(parts.down), fabs(parts.aside));
}

/* (T5) with one weight. */
static double rate_of(const SpanLaw *p, SpanFrame f, double tension)
{
    return p->mu * sum_of_supports(p, f, tension) + p->direction * p->weight * f.tz;
}

/* Weight between the bounds for which the rate, a convex function of the weight, is least: (T28a). NAN: it is least at
 * a bound. */
static double least_weight(const SpanLaw *p, SpanFrame f, double tension)
{
    const double c2 = f.nz * f.nz + f.bz * f.bz, pull = p->law == PULL_REFERENCE ? tension * f.curvature : 0;
    const double room = p->mu * p->mu * c2 - f.tz * f.tz;
    if (!(c2 > 0) || !(room > 0)) return NAN;
    const double aside = p->separate ? 0 : fabs(pull * f.bz);
    return (pull * f.nz - p->direction * f.tz * aside / sqrt(room)) / c2;
}

/* Returns the law with the weight by (T28) in this frame. */
static SpanLaw weighed(const SpanLaw *p, SpanFrame f, double tension)
{
    SpanLaw best = with_weight(p, p->counts > 0 ? p->counts : p->weight);
    if (!(p->lightest > 0) || p->counts > 0) return best;
    const double between = p->least ? least_weight(p, f, tension) : NAN;
    const double other[2] = {p->lightest, fmin(fmax(between, p->lightest), p->weight)};
    double rate = rate_of(&best, f, tension);
    for (int i = 0; i < (isnan(between) ? 1 : 2); i++) {
        const SpanLaw one = with_weight(p, other[i]);
        const double its = rate_of(&one, f, tension);
        if (p->least ? its >= rate : its <= rate) continue;
        best = one;
        rate = its;
    }
    return best;
}

/* The one weight that counts along the whole span; 0: it varies, or there is only one weight. */
static double span_counts(const SpanLaw *p)
{
    if (!(p->lightest > 0) || p->line.route || p->line.curvature > 0) return 0;
    return weighed(p, span_frame(&p->line, p->line.s_ref), 0).weight;
}

SpanLaw span_weighed(const SpanLaw *p, double s, double tension)
{
    return weighed(p, span_frame(&p->line, s), tension);
}

double span_rate(const SpanLaw *p, double s, double tension)
{
    /* weightless rope: no frame is needed, and the result is equal to the last bit */
    if (p->weight == 0 && !p->separate && !p->line.route)
        return p->mu * fabs(p->law == PULL_REFERENCE ? tension * p->line.curvature : 0);
    const SpanFrame f = span_frame(&p->line, s);
    if (!(p->lightest > 0)) return rate_of(p, f, tension);
    const SpanLaw one = weighed(p, f, tension);
    return rate_of(&one, f, tension);
}

static void extremes_take(SpanExtremes *e, double s, double tension)
{
    if (tension > e->max_tension) {
        e->max_tension = tension;
        e->max_at = s;
    }
    if (tension < e->min_tension) {
        e->min_tension = tension;
        e->min_at = s;
    }
}

/* One step of the 5(4) pair of Dormand and Prince (1980) over h along the pull: returns the tension at its
 * end; k[0] in and k[6] out are the rates at both ends, *error the difference of the two orders. */
static double dopri_step(const SpanLaw *p, double s, double tension, double h, double k[7], double *error)
{
    static const double C[7] = {0, 0.2, 0.3, 0.8, 8.0 / 9, 1, 1};
    static const double A[7][6] = {
        {0},
        {0.2},
        {3.0 / 40, 9.0 / 40},
        {44.0 / 45, -56.0 / 15, 32.0 / 9},
        {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
        {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
        {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84},
    };
    static const double E[7] = {71.0 / 57600, 0, -71.0 / 16695, 71.0 / 1920, -17253.0 / 339200, 22.0 / 525, -1.0 / 40};
    const int same = !p->line.route && p->line.curvature == 0; /* the rate depends on the sign of the tension at most */
    double end = tension;
    for (int i = 1; i < 7; i++) {
        double sum = 0;
        for (int j = 0; j < i; j++) sum += A[i][j] * k[j];
        end = tension + h * sum;
        k[i] = same && fmin(tension, end) >= 0 ? k[0] : span_rate(p, s + p->direction * C[i] * h, end);
    }
    *error = 0;
    for (int i = 0; i < 7; i++) *error += h * E[i] * k[i];
    return end;
}

/* Code of the weight that counts: 1 the heaviest, -1 the lightest, 2 one in between; 0: within rounding of two of them.
 */
static int weight_side(const SpanLaw *p, SpanFrame f, double tension)
{
    const double between = p->least ? least_weight(p, f, tension) : NAN, near = ZERO_FORCE * p->weight;
    if (!isnan(between)) {
        if (fmin(fabs(between - p->weight), fabs(between - p->lightest)) <= near) return 0;
        return between > p->weight ? 1 : between < p->lightest ? -1 : 2;
    }
    const SpanLaw heavy = with_weight(p, p->weight), light = with_weight(p, p->lightest);
    const double more = rate_of(&heavy, f, tension) - rate_of(&light, f, tension);
    if (!(fabs(more) > ZERO_FORCE * (p->mu * fabs(tension) * f.curvature + p->weight))) return 0;
    return (more > 0) != p->least ? 1 : -1;
}

/* Side of the law's corners on which a place lies. With one weight, it is the sign of the normal force toward the
 * centre where that can pass through zero: in bends in a vertical plane under the reference law, and for the downward
 * part on separate supports. With unlike weights, it is the code of the one that counts. 0: no corner is near, or
 * within rounding of it. */
static int corner_side(const SpanLaw *p, double s, double tension)
{
    const SpanFrame f = span_frame(&p->line, s);
    if (p->lightest > 0) return p->counts > 0 ? 0 : weight_side(p, f, tension);
    if (p->law != PULL_REFERENCE || f.curvature <= 0) return 0;
    if (!p->separate && fabs(f.bz) > ZERO_FORCE) return 0;
    const double pull = tension * f.curvature;
    const double g = p->separate ? support_parts(p, f, tension).down : pull - p->weight * f.nz;
    if (!(fabs(g) > ZERO_FORCE * (fabs(pull) + p->weight))) return 0;
    return g > 0 ? 1 : -1;
}

/* Takes one step of at most h that ends at a corner, found by bisection, if one lies inside. Returns its length; k,
 * *end and *error as in dopri_step. */
static double step_to_corner(const SpanLaw *p, double s, double tension, double h, double k[7], double *end,
                             double *error)
{
    *end = dopri_step(p, s, tension, h, k, error);
    const int before = corner_side(p, s, tension);
    int after = before ? corner_side(p, s + p->direction * h, *end) : 0;
    if (after == 0 || after == before) return h;
    double low = 0, high = h;
    for (int i = 0; i < 40 && after != 0;
         i++) { /* the rate has no jump there: an error of 1e-12 in the step causes 1e-24 */
        const double x = low + (high - low) / 2;
        after = corner_side(p, s + p->direction * x, dopri_step(p, s, tension, x, k, error));
        *(after == before ? &low : &high) = x;
    }
    *end = dopri_step(p, s, tension, high, k, error);
    return high;
}

/* An accepted step from (s, tension) over h along the pull to (s_end, end), with its rates k. */
typedef struct Step {
    const SpanLaw *law;
    double s, tension, h, s_end, end;
    const double *k; /* [7] */
} Step;

static double place_inside(const Step *t, double share) { return t->s + t->law->direction * share * t->h; }

/* Tension at a share of the step, by the pair's own fourth-order polynomial (T5a). */
static double tension_inside(const Step *t, double share)
{
    static const double D[7] = {-12715105075.0 / 11282082432,  0,
                                87487479700.0 / 32700410799,   -10690763975.0 / 1880347072,
                                701980252875.0 / 199316789632, -1453857185.0 / 822651844,
                                69997945.0 / 29380423};
    const double rise = t->end - t->tension, back = 1 - share;
    const double first = t->h * t->k[0] - rise, last = rise - t->h * t->k[6] - first;
    double bow = 0;
    for (int i = 0; i < 7; i++) bow += t->h * D[i] * t->k[i];
    return t->tension + share * (rise + back * (first + share * (last + back * bow)));
}

/* Takes in the extreme inside a step whose end rates differ in sign: the place where the rate is zero. */
static void extremes_take_inside(SpanExtremes *e, const Step *t)
{
    if (t->k[0] * t->k[6] >= 0) return;
    double low = 0, high = 1;
    for (int i = 0; i < 50; i++) {
        const double x = low + (high - low) / 2;
        if (t->k[0] * span_rate(t->law, place_inside(t, x), tension_inside(t, x)) > 0) {
            low = x;
        } else {
            high = x;
        }
    }
    extremes_take(e, place_inside(t, high), tension_inside(t, high));
}

/* Product of |T| and curvature at a share of the step. */
static double pressure_inside(void *what, double share)
{
    const Step *const t = what;
    return fabs(tension_inside(t, share)) * span_frame(&t->law->line, place_inside(t, share)).curvature;
}

static void pressure_widen(SpanExtremes *e, const Step *t, double share, double pressure)
{
    if (pressure <= e->max_pressure) return;
    e->max_pressure = pressure;
    e->pressure_at = place_inside(t, share);
}

/* Takes in the largest T times curvature of a step on a curve. If the pressure is nearly linear in the step, a parabola
 * through both ends and the middle shows whether a maximum lies inside; else samples along the step locate it. */
static void pressure_take(SpanExtremes *e, Step *t)
{
    enum { LOOKS = 8, CLOSER = 24 };
    static const double
        FLAT = 0.01,
        NEAR = 0.05; /* relative bow of the pressure; distance from an end within which a maximum counts as inside */
    double look[LOOKS + 1] = {pressure_inside(t, 0)};
    look[LOOKS] = pressure_inside(t, 1);
    look[LOOKS / 2] = pressure_inside(t, 0.5);
    const double bow = 2 * look[LOOKS / 2] - look[0] - look[LOOKS], tilt = look[LOOKS] - look[0];
    int best = look[LOOKS] > look[0] ? LOOKS : 0, step = LOOKS / 2;
    if (fabs(bow) > FLAT * look[best])
        for (int i = step = 1; i < LOOKS; ++i) look[i] = pressure_inside(t, (double)i / LOOKS);
    else if (!(bow > 0) || fabs(tilt) > (2 + 4 * NEAR) * bow)
        step = 0;
    for (int i = 0; i <= LOOKS && step > 0; i += step)
        if (look[i] > look[best]) best = i;
    pressure_widen(e, t, (double)best / LOOKS, look[best]);
    if (step == 0 || 2 * look[best] < e->max_pressure) return;
    const double low = fmax(best - step, 0) / LOOKS, high = fmin(best + step, LOOKS) / LOOKS;
    const SearchTop top = search_top(pressure_inside, t, low, high, CLOSER);
    pressure_widen(e, t, top.at, top.value);
}

static void extremes_take_step(SpanExtremes *e, Step *t)
{
    extremes_take(e, t->s, t->tension);
    extremes_take_inside(e, t);
    extremes_take(e, t->s_end, t->end);
    if (t->law->line.route) pressure_take(e, t);
    const SpanParts first = span_parts(t->law, t->s, t->tension), last = span_parts(t->law, t->s_end, t->end);
    e->max_down = fmax(e->max_down, fmax(fabs(first.down), fabs(last.down)));
    e->max_aside = fmax(e->max_aside, fmax(fabs(first.aside), fabs(last.aside)));
}

/* Integrates with error control, ending a step where the normal force changes sign. Steps below 1e-13 of the span are
 * accepted in any case, so that an overflow to infinity ends too. */
double span_integrate(const SpanLaw *p, double s0, double tension, double s1, SpanExtremes *extremes)
{
    const double length = p->direction * (s1 - s0), scale = p->weight * length;
    assert(length >= 0);
    double k[7] = {span_rate(p, s0, tension)}, x = 0, h = length, end, error;
    while (x < length) {
        const double s = s0 + p->direction * x;
        if (h > length - x) h = length - x;
        h = step_to_corner(p, s, tension, h, k, &end, &error);
        const double allowed = STEP_TOLERANCE * (fabs(tension) + scale);
        const int last = h >= length - x, fails = fabs(error) > allowed && h > 1e-13 * length;
        double grow = 5;
        if (fabs(error) > 0 && (fails || !last)) grow = fmin(5, fmax(0.2, 0.9 * pow(allowed / fabs(error), 0.2)));
        if (fails) {
            h *= grow;
            continue;
        }
        const double s_end = last ? s1 : s + p->direction * h;
        if (extremes) extremes_take_step(extremes, &(Step){p, s, tension, h, s_end, end, k});
        x = last ? length : fmax(x + h, nextafter(x, length));
        tension = end;
        if (extremes && extremes->enough > 0 && tension > extremes->enough) return INFINITY;
        k[0] = k[6];
        h *= grow;
    }
    if (extremes && !p->line.route) { /* constant curvature: the largest pressure is at the largest tension */
        extremes->max_pressure = fmax(extremes->max_tension, -extremes->min_tension) * p->line.curvature;
        extremes->pressure_at = extremes->max_tension >= -extremes->min_tension ? extremes->max_at : extremes->min_at;
    }
    return tension;
}

/* Checks all input of one pull that a user can get wrong. */
static hawser_status check_def(const PullDef *def, hawser_error *err)
{
    assert(def->route && def->route->n >= 1 && def->n_stretches >= 1 && def->n_steps >= 0);
    if (!isfinite(def->from) || !isfinite(def->to) || def->from == def->to) {
        return error_set(err, HAWSER_ERR_INPUT, "a pull from %g m to %g m has no length", def->from, def->to);
    }
    if (!isfinite(def->start_tension)) {
        return error_set(err, HAWSER_ERR_INPUT, "the tension at the start of the pull is not a number");
    }
    for (int i = 0; i < def->n_stretches; i++) {
        const PullStretch *a = &def->stretch[i];
        if (!(a->weight >= 0 && isfinite(a->weight)) || !(a->mu >= 0 && isfinite(a->mu)) || !isfinite(a->mu_static)) {
            return error_set(err, HAWSER_ERR_INPUT, "stretch %d: weight %g N/m and friction %g must be >= 0", i,
                             a->weight, a->mu);
        }
        if (i > 0 && !(a->from > def->stretch[i - 1].from)) {
            return error_set(err, HAWSER_ERR_INPUT, "stretch %d begins at %g m, not beyond the one before it", i,
                             a->from);
        }
    }
    for (int i = 0; i < def->n_steps; i++) {
        if (!isfinite(def->step[i].at) || !isfinite(def->step[i].force)) {
            return error_set(err, HAWSER_ERR_INPUT, "tension step %d is not a number", i);
        }
    }
    return HAWSER_OK;
}

const PullStretch *stretch_at(int n, const PullStretch *stretch, double s)
{
    const int begun = items_before(n, &stretch->from, sizeof *stretch, s, 1);
    return &stretch[begun > 0 ? begun - 1 : 0];
}

/* Returns the law of stretch a around `middle`, between two neighbouring cuts. */
static SpanLaw law_between(const PullDef *def, const PullStretch *a, double middle)
{
    SpanLaw law = {.law = def->law,
                   .direction = def->to > def->from ? 1 : -1,
                   .weight = a->weight,
                   .mu = def->restart ? fmax(a->mu, a->mu_static) : a->mu,
                   .lightest = a->lightest,
                   .least = def->least,
                   .room = a->room,
                   .ei = a->ei,
                   .separate = a->separate,
                   .line = span_line(def->route, middle)};
    law.counts = span_counts(&law);
    return law;
}

/* A step with its place in the pull's order; steps of one place keep their listed order. */
typedef struct StepAt {
    double at; /* m along the pull: the place times the direction */
    int i;     /* of def->step */
} StepAt;

static int compare_steps(const void *a, const void *b)
{
    const StepAt *const x = a, *const y = b;
    return x->at != y->at ? (x->at > y->at) - (x->at < y->at) : x->i - y->i;
}

static void steps_sort(const PullDef *def, StepAt *step)
{
    const int sign = def->to > def->from ? 1 : -1;
    int sorted = 1;
    for (int i = 0; i < def->n_steps; i++) {
        step[i] = (StepAt){sign * def->step[i].at, i};
        sorted &= i == 0 || step[i].at >= step[i - 1].at;
    }
    if (!sorted) qsort(step, (size_t)def->n_steps, sizeof *step, compare_steps);
}

/* Collects the ends of the pull and the corners of the data between them: cut[0] < ... < cut[n-1]; returns n. All three
 * lists are sorted. cut must hold n_pieces + 1 + n_stretches + n_steps + 2. */
static int collect_cuts(const PullDef *def, const StepAt *step, double *cut)
{
    const Route *const route = def->route;
    const int forward = def->to > def->from;
    const double high = fmax(def->from, def->to);
    double at = cut[0] = fmin(def->from, def->to);
    int n = 1;
    for (int p = 0, a = 0, k = 0; at < high; cut[n++] = at) {
        double next = high;
        while (p < route->n && route->piece[p].s0 <= at) p++;
        while (a < def->n_stretches && def->stretch[a].from <= at) a++;
        while (k < def->n_steps && def->step[step[forward ? k : def->n_steps - 1 - k].i].at <= at) k++;
        if (p < route->n) next = fmin(next, route->piece[p].s0);
        if (p == route->n && route->length > at) next = fmin(next, route->length);
        if (a < def->n_stretches) next = fmin(next, def->stretch[a].from);
        if (k < def->n_steps) next = fmin(next, def->step[step[forward ? k : def->n_steps - 1 - k].i].at);
        at = next;
    }
    return n;
}

/* Tension behind the steps at s, N. The steps begin at step[*next], which advances. Forces come first, then machines
 * take off the sum (PN2); where the pull begins anew, all of that is replaced (PN3). */
static double steps_pass(const PullDef *def, const StepAt *step, int *next, double s, double tension)
{
    const double at = def->to > def->from ? s : -s, arriving = tension;
    double anew = NAN;
    while (*next < def->n_steps && step[*next].at < at) ++*next;
    const int first = *next;
    for (; *next < def->n_steps && step[*next].at <= at; ++*next) {
        const PullStep *const one = &def->step[step[*next].i];
        if (one->kind == STEP_ADD) tension += one->force;
        if (one->kind == STEP_PUSH) tension -= def->pushes->push(def->pushes->of, one->item, arriving);
    }
    for (int i = first; i < *next; i++) {
        const PullStep *const one = &def->step[step[i].i];
        if (one->kind == STEP_TAKE) tension -= fmin(fmax(tension, 0), one->force);
        if (one->kind == STEP_ANEW) anew = one->force;
    }
    return isnan(anew) ? tension : anew;
}

static void take_tension(Pull *pull, int piece, double s, double tension)
{
    if (tension > pull->max_tension) {
        pull->max_tension = tension;
        pull->max_at = s;
        pull->max_piece = piece;
    }
    if (tension < pull->min_tension) {
        pull->min_tension = tension;
        pull->min_at = s;
        pull->min_piece = piece;
    }
}

/* Largest sidewall pressure on a span: a cable in compression presses outward as hard as one in tension presses inward.
 */
static double span_sidewall(const PullSpan *span)
{
    const SpanExtremes *e = &span->extremes;
    return e->max_pressure * span->share;
}

/* Takes one finished span into the pull's extremes. */
static void take_span(Pull *pull, const PullSpan *span)
{
    const SpanExtremes *e = &span->extremes;
    take_tension(pull, span->piece, e->max_at, e->max_tension);
    take_tension(pull, span->piece, e->min_at, e->min_tension);
    const double sidewall = span_sidewall(span);
    if (sidewall > pull->max_sidewall) {
        pull->max_sidewall = sidewall;
        pull->sidewall_at = e->pressure_at;
        pull->sidewall_piece = span->piece;
    }
}

/* Checks whether a span of an earlier pull is identical, so that its results can be reused. */
static int span_known(const PullDef *def, const PullStretch *a, const PullSpan *span, const PullSpan *known)
{
    const SpanLaw *const law = &known->law;
    const double mu = def->restart ? fmax(a->mu, a->mu_static) : a->mu;
    return known->s0 == span->s0 && known->s1 == span->s1 && known->t0 == span->t0 && law->law == def->law &&
           law->weight == a->weight && law->lightest == a->lightest && law->least == def->least && law->mu == mu &&
           law->room == a->room && law->ei == a->ei && law->separate == a->separate;
}

/* Integrates from cut to cut in the pull's order and applies the steps between. */
static void run_spans(const PullDef *def, int n, const double *cut, const StepAt *step, Pull *pull)
{
    const int forward = def->to > def->from;
    int next = 0, same = 0; /* same: the span with which an earlier pull begins here */
    double tension = def->start_tension;
    while (def->like && same < def->like->n && def->like->span[same].s0 != def->from) same++;
    take_tension(pull, route_at(def->route, cut[forward ? 0 : n - 1]).piece, def->from, tension);
    for (int i = 0; i < n - 1; i++) {
        const double low = cut[forward ? i : n - 2 - i], high = cut[forward ? i + 1 : n - 1 - i];
        PullSpan *span = &pull->span[i];
        *span = (PullSpan){.s0 = forward ? low : high, .s1 = forward ? high : low};
        const double middle = low + (high - low) / 2;
        const PullStretch *const a = stretch_at(def->n_stretches, def->stretch, middle);
        span->t0 = steps_pass(def, step, &next, span->s0, tension);
        const PullSpan *const known = def->like && same + i < def->like->n ? &def->like->span[same + i] : NULL;
        if (def->forces_only && known && span_known(def, a, span, known)) {
            *span = *known;
            tension = span->t1;
            continue;
        }
        span->piece = route_at(def->route, middle).piece;
        span->law = law_between(def, a, middle);
        span->share = a->share > 0 ? a->share : 1;
        span->extremes = (SpanExtremes){.max_tension = -INFINITY, .min_tension = INFINITY, .enough = def->enough};
        SpanExtremes *const extremes = def->forces_only ? NULL : &span->extremes;
        tension = span->t1 = span_integrate(&span->law, span->s0, span->t0, span->s1, extremes);
        if (!isfinite(tension)) {
            pull->end_tension = tension;
            return;
        }
        span->least = span->extremes.min_tension;
        span->least_at = span->extremes.min_at;
        if (extremes) take_span(pull, span);
    }
    pull->end_tension = steps_pass(def, step, &next, def->to, tension);
    take_tension(pull, pull->span[n - 2].piece, def->to, pull->end_tension);
}

hawser_status pull_solve(const PullDef *def, Pull *out, hawser_error *err)
{
    *out = (Pull){.start_tension = def->start_tension, .max_tension = -INFINITY, .min_tension = INFINITY};
    hawser_status status = check_def(def, err);
    if (status) return status;
    double *cut = malloc((size_t)(def->route->n + def->n_stretches + def->n_steps + 3) * sizeof *cut);
    StepAt *step = malloc((size_t)(def->n_steps + 1) * sizeof *step);
    if (!cut || !step) {
        free(cut);
        free(step);
        return error_memory(err);
    }
    steps_sort(def, step);
    const int n = collect_cuts(def, step, cut);
    out->n = n - 1;
    out->span = malloc((size_t)out->n * sizeof *out->span);
    if (out->span) {
        run_spans(def, n, cut, step, out);
        if (!isfinite(out->end_tension)) {
            status = error_set(err, HAWSER_ERR_INPUT, "the tension grows past all bounds: too much friction and turn");
        }
    } else {
        status = error_memory(err);
    }
    free(cut);
    free(step);
    if (status) pull_clear(out);
    return status;
}

void pull_clear(Pull *pull)
{
    free(pull->span);
    *pull = (Pull){0};
}

/* The span that contains s: the first, in the pull's order, that does not end before s. */
static const PullSpan *find_span(const Pull *pull, double s)
{
    int low = 0, high = pull->n - 1;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        const PullSpan *span = &pull->span[middle];
        if (span->law.direction * (span->s1 - s) >= 0) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return &pull->span[low];
}

/* Tension at s, N, integrated from the start of its span; at the ends the values of pull_solve. */
static double span_tension(const Pull *pull, const PullSpan *span, double s)
{
    if (s == pull->span[0].s0) return pull->start_tension;
    return s == span->s1 ? span->t1 : span_integrate(&span->law, span->s0, span->t0, s, NULL);
}

PullPoint pull_at(const Pull *pull, double s)
{
    assert(pull->n > 0);
    const double first = pull->span[0].s0, last = pull->span[pull->n - 1].s1;
    const double at = fmin(fmax(s, fmin(first, last)), fmax(first, last));
    const PullSpan *span = find_span(pull, at);
    PullPoint point = {.tension = span_tension(pull, span, at), .piece = span->piece};
    const SpanFrame frame = span_frame(&span->law.line, at);
    point.normal = span_normal(&span->law, at, point.tension);
    point.support = span_support(&span->law, at, point.tension);
    point.sidewall = fabs(point.tension) * frame.curvature * span->share;
    point.slope = asin(fmax(-1, fmin(1, frame.tz)));
    return point;
}

PieceExtremes pull_extremes_from(const Pull *pull, int first)
{
    PieceExtremes out = {0};
    for (int i = first; i < pull->n && pull->span[i].piece == pull->span[first].piece; i++) {
        const PullSpan *span = &pull->span[i];
        out.tension = fmax(out.tension, span->extremes.max_tension);
        out.sidewall = fmax(out.sidewall, span_sidewall(span));
        out.either = fmax(out.either, fmax(span->extremes.max_tension, -span->extremes.min_tension));
        out.down = fmax(out.down, span->extremes.max_down);
        out.aside = fmax(out.aside, span->extremes.max_aside);
    }
    return out;
}

PieceExtremes pull_piece_extremes(const Pull *pull, int piece)
{
    for (int i = 0; i < pull->n; i++) {
        if (pull->span[i].piece == piece) return pull_extremes_from(pull, i);
    }
    return (PieceExtremes){0};
}
