#include "theory/closed_form.h"

#include <assert.h>
#include <math.h>

#include "core/error.h"

static const double HALF_PI = 1.57079632679489661923;

/* Vertical component of a unit vector, or angle, below which a bend counts as level or as planar. */
static const double PLANE_TOLERANCE = 1e-9;

double slope_tension(double T1, double w, double mu, double length, double slope)
{
    return T1 + w * length * (mu * cos(slope) + sin(slope));
}

double capstan_tension(double T1, double mu, double turn) { return T1 * exp(mu * turn); }

static hawser_status refuse_slack(const char *where, double T, hawser_error *err)
{
    return error_set(err, HAWSER_ERR_INPUT, "the tension %s the bend is %g N: a cable does not push", where, T);
}

/* Sets T2 if both ends are in tension. */
static hawser_status give_bend(double T1, double result, double *T2, hawser_error *err)
{
    if (!(T1 >= 0)) return refuse_slack("before", T1, err);
    if (!(result >= 0)) return refuse_slack("after", result, err);
    *T2 = result;
    return HAWSER_OK;
}

hawser_status bend_level_tension(double T1, double w, double mu, double R, double turn, double *T2, hawser_error *err)
{
    assert(w >= 0 && mu >= 0 && R > 0 && turn >= 0);
    return give_bend(T1, T1 * cosh(mu * turn) + sinh(mu * turn) * hypot(T1, w * R), T2, err);
}

hawser_status bend_separate_tension(double T1, double w, double mu, double R, double turn, double *T2,
                                    hawser_error *err)
{
    assert(w >= 0 && mu >= 0 && R > 0 && turn >= 0);
    return give_bend(T1, T1 * exp(mu * turn) + w * R * expm1(mu * turn), T2, err);
}

/* A sag's cable bears on the inner side while T > w R cos(slope). */
static hawser_status check_lifted(double T, double w, double R, double slope, hawser_error *err)
{
    const double needed = w * R * cos(slope);
    if (T >= needed) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT,
                     "at slope %.4g deg of the sag the tension %.6g N is below w R cos = %.6g N: the cable lies on the "
                     "bottom and this form does not hold",
                     slope * 90 / HALF_PI, T, needed);
}

/* (T12)-(T15) with K = mu, c = w R / (1 + mu^2), e = exp(mu turn); TB 889 eq. 10-13. */
static double vertical_form(VerticalBend kind, double T1, double c, double K, double turn)
{
    const double e = exp(K * turn), sine = sin(turn), cosine = cos(turn), q = 1 - K * K;
    switch (kind) {
    case SAG_LEVEL_UP:
        return T1 * e - c * (2 * K * sine - q * (e - cosine));
    case CREST_UP_LEVEL:
        return T1 * e + c * (2 * K * e * sine + q * (1 - e * cosine));
    case CREST_LEVEL_DOWN:
        return T1 * e + c * (2 * K * sine - q * (e - cosine));
    case SAG_DOWN_LEVEL:
        break;
    }
    return T1 * e - c * (2 * K * e * sine + q * (1 - e * cosine));
}

/* In a sag T - w R cos(slope) can only become negative while the slope is downward, (T16): checking both ends
 * is enough, since one of them is level. */
hawser_status bend_vertical_tension(VerticalBend kind, double T1, double w, double mu, double R, double turn,
                                    double *T2, hawser_error *err)
{
    assert(w >= 0 && mu >= 0 && R > 0 && turn >= 0);
    if (turn > HALF_PI) {
        return error_set(err, HAWSER_ERR_INPUT, "the bend turns by %.4g deg, past the vertical", turn * 90 / HALF_PI);
    }
    const double result = vertical_form(kind, T1, w * R / (1 + mu * mu), mu, turn);
    double checked = 0;
    hawser_status status = give_bend(T1, result, &checked, err);
    if (!status && (kind == SAG_LEVEL_UP || kind == SAG_DOWN_LEVEL)) {
        const int up = kind == SAG_LEVEL_UP;
        status = check_lifted(T1, w, R, up ? 0 : -turn, err);
        if (!status) status = check_lifted(result, w, R, up ? turn : 0, err);
    }
    if (!status) *T2 = checked;
    return status;
}

/* A bend in a vertical plane in one regime: k = 1 sag, -1 crest; side = 1: the cable bears on the inner side.
 */
typedef struct VerticalArc {
    double w, mu, R, k, side;
} VerticalArc;

double bend_vertical_particular(double w, double R, double k, double m, double slope)
{
    return -k * w * R / (1 + m * m) * (2 * m * sin(slope) + (1 - m * m) * cos(slope));
}

static double arc_tension(const VerticalArc *arc, double T1, double a, double b)
{
    const double m = arc->k * arc->mu * arc->side;
    const double from = bend_vertical_particular(arc->w, arc->R, arc->k, m, a);
    return bend_vertical_particular(arc->w, arc->R, arc->k, m, b) + exp(m * (b - a)) * (T1 - from);
}

/* side (T - w R cos(slope)) at slope b: negative where the regime no longer holds. */
static double arc_bearing(const VerticalArc *arc, double T1, double a, double b)
{
    return arc->side * (arc_tension(arc, T1, a, b) - arc->w * arc->R * cos(b));
}

/* The slope in (a, b] at which a sag's bearing force, not negative at a, has become negative, by bisection; b
 * if it does not. In a regime the force passes zero at most once; it is downward for slopes below 0 on the
 * inner side, upward above 0 on the outer one, so that it has its least value at clamp(0, a, b) or at b. */
static double arc_regime_end(const VerticalArc *arc, double T1, double a, double b)
{
    double good = a, bad = b;
    if (arc->side > 0) bad = fmin(fmax(0, a), b);
    if (bad <= a || arc_bearing(arc, T1, a, bad) >= 0) return b;
    while (bad - good > 1e-15 * (1 + fabs(bad))) {
        const double middle = good + (bad - good) / 2;
        if (middle <= good || middle >= bad) break;
        if (arc_bearing(arc, T1, a, middle) >= 0) {
            good = middle;
        } else {
            bad = middle;
        }
    }
    return good + (bad - good) / 2;
}

/* The side on which a sag's cable bears at slope a; at zero force the force is about to grow with the sign of the
 * slope. */
static double sag_side(double T, const VerticalArc *arc, double a)
{
    const double g = T - arc->w * arc->R * cos(a);
    if (fabs(g) <= 1e-13 * arc->w * arc->R) return a < 0 ? -1 : 1;
    return g < 0 ? -1 : 1;
}

/* A sag has at most three regimes: uplift, on the bottom, uplift again; a crest has one. */
int bend_vertical_parts(double T1, double w, double mu, double R, double a, double b, VerticalPart part[VERTICAL_PARTS])
{
    VerticalArc arc = {.w = w, .mu = mu, .R = R, .k = b > a ? 1 : -1, .side = 1};
    const int crest = !(b > a);
    int n = 0;
    do {
        if (!crest) arc.side = sag_side(T1, &arc, a);
        const double end = !crest && n + 1 < VERTICAL_PARTS ? arc_regime_end(&arc, T1, a, b) : b;
        const double out = arc_tension(&arc, T1, a, end);
        part[n++] = (VerticalPart){a, end, arc.side, T1, out};
        T1 = out;
        a = end;
    } while (!crest && n < VERTICAL_PARTS && a < b);
    return n;
}

hawser_status bend_any_vertical_tension(double T1, double w, double mu, double R, double a, double b, double *T2,
                                        hawser_error *err)
{
    assert(w >= 0 && mu >= 0 && R > 0);
    if (fmax(fabs(a), fabs(b)) > HALF_PI + PLANE_TOLERANCE) {
        return error_set(err, HAWSER_ERR_INPUT, "the bend goes past the vertical, from %.4g deg to %.4g deg",
                         a * 90 / HALF_PI, b * 90 / HALF_PI);
    }
    VerticalPart part[VERTICAL_PARTS];
    const int n = bend_vertical_parts(T1, w, mu, R, a, b, part);
    return give_bend(T1, part[n - 1].out, T2, err);
}

hawser_status roller_tension(double T1, double mu, double turn, double *T2, hawser_error *err)
{
    const double x = mu * tan(turn / 2);
    if (!(turn >= 0 && turn < 2 * HALF_PI) || x >= 1) {
        return error_set(err, HAWSER_ERR_INPUT, "a turn of %.4g deg over one roller locks at friction %g",
                         turn * 90 / HALF_PI, mu);
    }
    *T2 = T1 * (1 + x) / (1 - x);
    return HAWSER_OK;
}

double roller_load(double T1, double T2, double turn)
{
    const double half = sin(turn / 2);
    return sqrt((T1 - T2) * (T1 - T2) + 4 * T1 * T2 * half * half);
}

PieceLie piece_lie(const RoutePiece *piece)
{
    if (piece->kind == ROUTE_STRAIGHT) return LIES_STRAIGHT;
    if (piece->kind != ROUTE_BEND) return LIES_OTHERWISE;
    if (fabs(piece->tangent.z) < PLANE_TOLERANCE && fabs(piece->centre.z) < PLANE_TOLERANCE) return LIES_LEVEL;
    return fabs(v3_cross(piece->tangent, piece->centre).z) < PLANE_TOLERANCE ? LIES_UPRIGHT : LIES_OTHERWISE;
}

void piece_slopes(const RoutePiece *p, int direction, double *a, double *b)
{
    const double start = atan2(p->tangent.z, hypot(p->tangent.x, p->tangent.y));
    const double end = start + (p->centre.z > 0 ? p->angle : -p->angle);
    *a = direction > 0 ? start : -end;
    *b = direction > 0 ? end : -start;
}

hawser_status piece_tension(const RoutePiece *piece, int direction, double T1, double w, double mu, int separate,
                            double *T2, hawser_error *err)
{
    if (piece->kind == ROUTE_STRAIGHT) {
        const double slope = atan2(piece->tangent.z, hypot(piece->tangent.x, piece->tangent.y));
        *T2 = slope_tension(T1, w, mu, piece->length, direction * slope);
        return HAWSER_OK;
    }
    if (piece->kind != ROUTE_BEND) {
        return error_set(err, HAWSER_ERR_INPUT, "a %s: no closed form", route_piece_word(piece));
    }
    const PieceLie lie = piece_lie(piece);
    if (lie == LIES_LEVEL) {
        const double R = piece->radius, turn = piece->angle;
        return separate ? bend_separate_tension(T1, w, mu, R, turn, T2, err)
                        : bend_level_tension(T1, w, mu, R, turn, T2, err);
    }
    if (lie == LIES_UPRIGHT) {
        double a, b;
        piece_slopes(piece, direction, &a, &b);
        return bend_any_vertical_tension(T1, w, mu, piece->radius, a, b, T2, err);
    }
    return error_set(err, HAWSER_ERR_INPUT, "the bend is neither level nor in a vertical plane: no closed form");
}

/* Integral of W g (mu cos phi + sin phi) ds along an arc of radius R from slope a to slope b, (T3). With a =
 * -theta1, b = 0 it is the paper's eq. 5. */
static double arc_force(double Wg, double mu, double R, double a, double b)
{
    const double sign = b >= a ? 1 : -1;
    return sign * Wg * R * (mu * (sin(b) - sin(a)) - (cos(b) - cos(a)));
}

double paper_term_path(const PaperTermDef *term)
{
    switch (term->kind) {
    case PAPER_SLOPE:
        return term->length;
    case PAPER_ARC:
        return term->radius * fabs(term->slope_end - term->slope);
    case PAPER_REEL:
    case PAPER_ROPE:
        break;
    }
    return 0;
}

/* The force of the first x metres of a slope or arc, N. (T2), (T3) */
static double path_force(const PaperTermDef *term, double Wg, double mu, double x)
{
    if (term->kind == PAPER_SLOPE) return Wg * x * (mu * cos(term->slope) + sin(term->slope));
    const double turn = copysign(x / term->radius, term->slope_end - term->slope);
    return arc_force(Wg, mu, term->radius, term->slope, term->slope + turn);
}

double paper_term_force(const PaperTermDef *term, double W, double mu, double g)
{
    switch (term->kind) {
    case PAPER_SLOPE:
        return path_force(term, W * g, mu, term->length);
    case PAPER_ARC:
        return arc_force(W * g, mu, term->radius, term->slope, term->slope_end);
    case PAPER_REEL:
    case PAPER_ROPE:
        break;
    }
    return W * g * term->length; /* (T1) */
}

double paper_total(int n, const PaperTermDef *term, double W, double mu, double g)
{
    double sum = 0;
    for (int i = 0; i < n; i++) sum += paper_term_force(&term[i], W, mu, g);
    return sum;
}

double paper_tension(int n, const PaperTermDef *term, double W, double mu, double g, double s)
{
    double tension = 0, left = s > 0 ? s : 0; /* remaining path */
    for (int i = 0; i < n; i++) {
        const double path = paper_term_path(&term[i]);
        if (term[i].kind == PAPER_REEL || (path > 0 && left >= path)) {
            tension += paper_term_force(&term[i], W, mu, g);
        } else if (path > 0) {
            tension += path_force(&term[i], W * g, mu, left);
        }
        left = left > path ? left - path : 0;
    }
    return tension;
}
