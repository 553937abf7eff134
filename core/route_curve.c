#include "core/route.h"

#include <assert.h>
#include <stdlib.h>

#include "core/base/error.h"

/* ---------------------------------------------------------------------------------------------- the laws in u */

/* sin(x)/x. */
static double sinc(double x) { return fabs(x) > 1e-8 ? sin(x) / x : 1; }

static double heading_at(const RouteCurve *c, double u) { return u * (c->bend + c->sharp * u / 2); }

static Vec3 cubic_slope(const RouteCurve *c, double u)
{
    return v3_axpy(v3_axpy(c->cubic[0], 2 * u, c->cubic[1]), 3 * u * u, c->cubic[2]);
}

/* Arc length per parameter: (RO6), (RO9). Of grades and arcs it is known without. */
static double speed_at(const RoutePiece *p, double u)
{
    if (p->kind == ROUTE_CUBIC) return v3_norm(cubic_slope(&p->curve, u));
    const double grade = p->curve.grade + p->curve.vertical * u;
    return sqrt(1 + grade * grade);
}

/* Whether x is an integral over u. */
static int is_timed(const RoutePiece *p) { return p->kind == ROUTE_CUBIC || p->curve.profile == PROFILE_PARABOLA; }

/* ------------------------------------------------------------------------------------------------- quadrature */

enum { GAUSS = 8 };
/* Gauss and Legendre's rule of 8 points on [-1, 1], its positive half. */
static const double gauss_at[GAUSS / 2] = {0.18343464249564980494, 0.52553240991632898582, 0.79666647741362673959,
                                           0.96028985649753623168};
static const double gauss_by[GAUSS / 2] = {0.36268378337836198297, 0.31370664587788728734, 0.22238103445337447054,
                                           0.10122853629037625915};

static double gauss_place(double u0, double u, int i)
{
    const double middle = (u0 + u) / 2, half = (u - u0) / 2;
    return middle + (i % 2 ? half : -half) * gauss_at[i / 2];
}

/* The arc length since the knot at u0. */
static double integrate_length(const RoutePiece *p, double u0, double u)
{
    const double half = (u - u0) / 2;
    double sum = 0;
    for (int i = 0; i < GAUSS; ++i) sum += half * gauss_by[i / 2] * speed_at(p, gauss_place(u0, u, i));
    return sum;
}

/* What has been gone through since then (RO4), (RO6). */
static RouteKnot integrate(const RoutePiece *p, double u0, double u)
{
    const double half = (u - u0) / 2;
    RouteKnot sum = {.u = u, .x = is_timed(p) ? integrate_length(p, u0, u) : 0};
    for (int i = 0; i < GAUSS && p->kind == ROUTE_CURVE; ++i) {
        const double heading = heading_at(&p->curve, gauss_place(u0, u, i)), by = half * gauss_by[i / 2];
        sum.along += by * cos(heading);
        sum.aside += by * sin(heading);
    }
    return sum;
}

static RouteKnot knot_after(const RouteKnot *from, RouteKnot way)
{
    return (RouteKnot){way.u, from->x + way.x, from->along + way.along, from->aside + way.aside};
}

/* ------------------------------------------------------------------------------------------------ place by arc length
 */

/* The knot before arc length x: guessed by even steps, then walked to. */
static const RouteKnot *knot_before(const RouteKnot *knot, int n, double x)
{
    int i = (int)(n * x / knot[n].x);
    i = i < 0 ? 0 : i > n - 1 ? n - 1 : i;
    while (i > 0 && knot[i].x > x) --i;
    while (i < n - 1 && knot[i + 1].x <= x) ++i;
    return &knot[i];
}

/* u where the arc length is x, from a knot before it: Newton's method, which converges at once, since the speed hardly
 * changes between two knots (RO7). It is begun with the speed half way there, and ended where the square of a step is
 * rounding. */
static double parameter_at(const RoutePiece *p, const RouteKnot *knot, double x)
{
    const double way = x - knot->x, first = speed_at(p, knot->u);
    double u = knot->u + way / speed_at(p, knot->u + way / first / 2);
    for (int i = 0; i < 20; ++i) {
        const double off = knot->x + integrate_length(p, knot->u, u) - x, step = off / speed_at(p, u);
        u -= step;
        if (fabs(step) <= 1e-9 * p->curve.end) break;
    }
    return u;
}

static RoutePoint cubic_at(const RoutePiece *p, double u)
{
    const RouteCurve *const c = &p->curve;
    const Vec3 by = cubic_slope(c, u), by2 = v3_axpy(v3_scale(2, c->cubic[1]), 6 * u, c->cubic[2]);
    RoutePoint at = {.tangent = v3_unit(by)};
    at.position = v3_axpy(p->start, u, v3_axpy(v3_axpy(c->cubic[0], u, c->cubic[1]), u * u, c->cubic[2]));
    at.curvature = v3_scale(1 / v3_dot(by, by), v3_reject(by2, at.tangent));
    return at;
}

/* Tangent and curvature by heading and slope, position by the plan's coordinates and the height over it: (RO1)-(RO3).
 */
static RoutePoint curve_point(const RoutePiece *p, double u, double slope, const RouteKnot *plan, double height)
{
    const RouteCurve *const c = &p->curve;
    const double heading = heading_at(c, u), ch = cos(heading), sh = sin(heading), cs = cos(slope), ss = sin(slope);
    const Vec3 ahead = v3_axpy(v3_scale(ch, c->axis[0]), sh, c->axis[1]);
    const Vec3 aside = v3_axpy(v3_scale(ch, c->axis[1]), -sh, c->axis[0]);
    const double turn = cs * cs * (c->bend + c->sharp * u);
    double rise = 0; /* d slope / ds */
    if (c->profile == PROFILE_ARC) rise = c->vertical;
    if (c->profile == PROFILE_PARABOLA) rise = c->vertical * cs * cs * cs;
    RoutePoint at = {.tangent = v3_unit(v3_axpy(v3_scale(cs, ahead), ss, c->axis[2]))};
    at.curvature = v3_axpy(v3_scale(turn, aside), rise, v3_axpy(v3_scale(cs, c->axis[2]), -ss, ahead));
    at.position = v3_add(
        p->start, v3_axpy(v3_axpy(v3_scale(plan->along, c->axis[0]), plan->aside, c->axis[1]), height, c->axis[2]));
    return at;
}

/* Where x is along a curve that is no cubic: its parameter, slope and height over the start. */
typedef struct CurvePlace {
    double u, slope, height;
} CurvePlace;

static CurvePlace curve_place(const RoutePiece *p, const RouteKnot *knot, double x)
{
    const RouteCurve *const c = &p->curve;
    if (c->profile == PROFILE_PARABOLA) { /* (RO5), (RO7) */
        const double u = parameter_at(p, knot_before(knot, c->n, x), x);
        return (CurvePlace){u, atan(c->grade + c->vertical * u), u * (c->grade + c->vertical * u / 2)};
    }
    const double half = (c->profile == PROFILE_ARC ? c->vertical : 0) * x / 2; /* (RO8) */
    return (CurvePlace){x * sinc(half) * cos(c->slope + half), c->slope + 2 * half,
                        x * sinc(half) * sin(c->slope + half)};
}

/* NULL: no piece is timed. */
static const RouteKnot *knots_of(const Route *route, const RoutePiece *p)
{
    return route->knot ? route->knot + p->curve.first : NULL;
}

RoutePoint route_curve_at(const Route *route, const RoutePiece *p, double x)
{
    const RouteCurve *const c = &p->curve;
    const RouteKnot *const knot = knots_of(route, p);
    if (p->kind == ROUTE_CUBIC) return cubic_at(p, parameter_at(p, knot_before(knot, c->n, x), x));
    const CurvePlace at = curve_place(p, knot, x);
    RouteKnot plan = {.u = at.u};
    if (c->n == 0) { /* the plan is a circle */
        const double half = c->bend * at.u / 2;
        plan.along = at.u * sinc(half) * cos(half);
        plan.aside = at.u * sinc(half) * sin(half);
    } else {
        assert(knot);
        int i = (int)(c->n * at.u / c->end);
        i = i < 0 ? 0 : i > c->n - 1 ? c->n - 1 : i;
        plan = knot_after(&knot[i], integrate(p, knot[i].u, at.u));
    }
    return curve_point(p, at.u, at.slope, &plan, at.height);
}

RoutePoint route_curve_way(const Route *route, const RoutePiece *p, double x)
{
    const RouteKnot none = {0};
    if (p->kind == ROUTE_CUBIC) return route_curve_at(route, p, x);
    const CurvePlace at = curve_place(p, knots_of(route, p), x);
    return curve_point(p, at.u, at.slope, &none, 0);
}

/* ------------------------------------------------------------------------------------------------------ building */

Vec3 route_centre(Vec3 tangent, Vec3 left, double plane)
{
    const Vec3 up = v3_cross(tangent, left);
    return v3_unit(v3_reject(v3_add(v3_scale(cos(plane), left), v3_scale(sin(plane), up)), tangent));
}

/* What rounding of a slope leaves of no change of grade. */
static const double RISE_MIN = 1e-14;

/* By how much tan(slope) changes along a parabola; 0: it is a straight grade, and has no knots. */
static double parabola_rise(const RouteCurve *c)
{
    const double rise = fabs(c->vertical * c->end);
    return rise > RISE_MIN * (1 + c->grade * c->grade) ? rise : 0;
}

/* How many steps of u the integrals need: at most 0.3 rad of plan and of change of slope each; a cubic's until its
 * length no longer changes. 0: closed form. */
static int steps_wanted(const RoutePiece *p)
{
    const RouteCurve *const c = &p->curve;
    if (p->kind == ROUTE_CUBIC) {
        double before = 0;
        for (int n = 4; n < 4096; n *= 2) {
            double sum = 0;
            for (int i = 0; i < n; ++i) sum += integrate_length(p, (double)i / n, (i + 1.0) / n);
            if (fabs(sum - before) <= 1e-14 * sum) return n;
            before = sum;
        }
        return 4096;
    }
    const double turn = c->end * fmax(fabs(c->bend), fabs(c->bend + c->sharp * c->end));
    const double rise = c->profile == PROFILE_PARABOLA ? parabola_rise(c) : 0;
    if (!(fabs(c->sharp) > 0) && !(rise > 0)) return 0;
    return (int)ceil(fmax(turn, rise) / 0.3) + 1;
}

static hawser_status knots_add(Route *route, RoutePiece *p, hawser_error *err)
{
    RouteCurve *const c = &p->curve;
    c->n = steps_wanted(p);
    c->first = route->n_knots;
    if (c->n == 0) return HAWSER_OK;
    RouteKnot *const all = realloc(route->knot, (size_t)(route->n_knots + c->n + 1) * sizeof *all);
    if (!all) return error_memory(err);
    route->knot = all;
    route->n_knots += c->n + 1;
    RouteKnot *const knot = all + c->first;
    knot[0] = (RouteKnot){0};
    for (int i = 0; i < c->n; ++i) knot[i + 1] = knot_after(&knot[i], integrate(p, knot[i].u, (i + 1) * c->end / c->n));
    return HAWSER_OK;
}

/* Plan and profile in their own axes. */
static void curve_fill(RoutePiece *p, const RoutePieceDef *def, Vec3 left)
{
    RouteCurve *const c = &p->curve;
    c->end = def->length;
    c->bend = def->curvature[0];
    c->sharp = (def->curvature[1] - def->curvature[0]) / def->length;
    if (!def->upright) {
        c->axis[0] = p->tangent;
        c->axis[1] = route_centre(p->tangent, left, def->plane);
        c->axis[2] = v3_cross(c->axis[0], c->axis[1]);
        p->length = def->length;
        return;
    }
    c->axis[0] = v3_cross(left, v3(0, 0, 1));
    c->axis[1] = left;
    c->axis[2] = v3(0, 0, 1);
    c->slope = atan2(p->tangent.z, hypot(p->tangent.x, p->tangent.y));
    c->grade = tan(c->slope);
    c->profile = def->profile;
    if (def->profile == PROFILE_PARABOLA) c->vertical = (tan(def->slope_end) - c->grade) / def->length;
    if (!(parabola_rise(c) > 0) && def->profile == PROFILE_PARABOLA) c->profile = PROFILE_GRADE;
    if (c->profile == PROFILE_GRADE) p->length = def->length / cos(c->slope);
    if (c->profile == PROFILE_ARC) {
        c->vertical = (sin(def->slope_end) - sin(c->slope)) / def->length;
        const double half = (def->slope_end - c->slope) / 2;
        p->length = def->length / (sinc(half) * cos(c->slope + half));
    }
}

/* Largest curvature, whole turn and jerk, by looks along the piece; a curve's largest curvature is met at its ends or
 * where the looks see it, refined by a parabola through three. */
static void measure(const Route *route, RoutePiece *p)
{
    enum { LOOKS = 200 };
    const double h = p->length / LOOKS;
    double k[LOOKS + 1], most = 0, sum = 0;
    RoutePoint before = {.piece = 0};
    for (int i = 0; i <= LOOKS; ++i) {
        const RoutePoint at = route_curve_way(route, p, i * h);
        k[i] = v3_norm(at.curvature);
        most = fmax(most, k[i]);
        sum += k[i] * (i == 0 || i == LOOKS ? 1 : i % 2 ? 4 : 2) * h / 3;
        if (i > 0) {
            const Vec3 by = v3_reject(v3_sub(at.curvature, before.curvature), at.tangent);
            p->curve.jerk = fmax(p->curve.jerk, v3_norm(by) / h);
        }
        before = at;
    }
    for (int i = 1; i < LOOKS; ++i) {
        const double fall = 2 * k[i] - k[i - 1] - k[i + 1], tilt = k[i + 1] - k[i - 1];
        if (k[i] >= k[i - 1] && k[i] >= k[i + 1] && fall > 0) most = fmax(most, k[i] + tilt * tilt / (8 * fall));
    }
    p->radius = most > 0 ? 1 / most : INFINITY;
    p->angle = sum;
}

hawser_status route_curve_set(Route *route, RoutePiece *p, const RoutePieceDef *def, Vec3 left, hawser_error *err)
{
    p->curve = (RouteCurve){.profile = PROFILE_GRADE};
    if (p->kind == ROUTE_CUBIC) {
        for (int i = 0; i < 3; ++i) p->curve.cubic[i] = def->cubic[i];
        p->curve.end = 1;
        p->tangent = v3_unit(def->cubic[0]);
    } else {
        curve_fill(p, def, left);
    }
    const hawser_status status = knots_add(route, p, err);
    if (status) return status;
    if (is_timed(p)) p->length = route->knot[p->curve.first + p->curve.n].x;
    assert(p->length > 0);
    measure(route, p);
    const Vec3 plan = v3_cross(def->cubic[0], v3_add(def->cubic[1], def->cubic[2]));
    const Vec3 over = v3_cross(def->cubic[0], def->cubic[1]);
    p->curve.sideways = p->kind == ROUTE_CUBIC ? fabs(plan.z) + fabs(over.z) > 0
                        : def->upright         ? fabs(def->curvature[0]) + fabs(def->curvature[1]) > 0
                                               : fabs(p->curve.axis[2].z) > 1e-9;
    return HAWSER_OK;
}
