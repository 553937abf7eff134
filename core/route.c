#include "core/route.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"

/* ---------------------------------------------------------------------------------------------- functions of u */

/* sin(x)/x. */
static double sinc(double x) { return fabs(x) > 1e-8 ? sin(x) / x : 1; }

static double heading_at(const RouteCurve *c, double u) { return u * (c->bend + c->sharp * u / 2); }

static Vec3 cubic_slope(const RouteCurve *c, double u)
{
    return v3_axpy(v3_axpy(c->cubic[0], 2 * u, c->cubic[1]), 3 * u * u, c->cubic[2]);
}

/* Arc length per parameter: (RO6), (RO9). For grades and arcs it is known in closed form. */
static double speed_at(const RoutePiece *p, double u)
{
    if (p->kind == ROUTE_CUBIC) return v3_norm(cubic_slope(&p->curve, u));
    const double grade = p->curve.grade + p->curve.vertical * u;
    return sqrt(1 + grade * grade);
}

/* Checks whether x is an integral over u. */
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

/* Integrals since that knot (RO4), (RO6). */
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

/* ---------------------------------------------------------------------------------------------- place by arc length */

/* The knot before arc length x: guessed by even steps, then corrected step by step. */
static const RouteKnot *knot_before(const RouteKnot *knot, int n, double x)
{
    int i = (int)(n * x / knot[n].x);
    i = i < 0 ? 0 : i > n - 1 ? n - 1 : i;
    while (i > 0 && knot[i].x > x) --i;
    while (i < n - 1 && knot[i + 1].x <= x) ++i;
    return &knot[i];
}

/* u at arc length x, from a knot before it: Newton's method, which converges at once, since the speed hardly changes
 * between two knots (RO7). It starts with the speed half way there, and ends when the square of a step is rounding. */
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

/* Tangent and curvature by heading and slope, position by the plan's coordinates and the height over it:
 * (RO1)-(RO3). */
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

/* Place of x along a curve that is not a cubic: its parameter, slope and height over the start. */
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

/* NULL: no piece has knots. */
static const RouteKnot *knots_of(const Route *route, const RoutePiece *p)
{
    return route->knot ? route->knot + p->curve.first : NULL;
}

/* Point at distance x from its start, within its length. */
static RoutePoint route_curve_at(const Route *route, const RoutePiece *p, double x)
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

/* The same without the position, which requires an integral: tangent and curvature only. */
static RoutePoint route_curve_way(const Route *route, const RoutePiece *p, double x)
{
    const RouteKnot none = {0};
    if (p->kind == ROUTE_CUBIC) return route_curve_at(route, p, x);
    const CurvePlace at = curve_place(p, knots_of(route, p), x);
    return curve_point(p, at.u, at.slope, &none, 0);
}

/* ------------------------------------------------------------------------------------------------------ building */

/* Unit vector from a bend's start toward its centre: cos(plane) left + sin(plane) up, up = t x left. (R2) */
static Vec3 route_centre(Vec3 tangent, Vec3 left, double plane)
{
    const Vec3 up = v3_cross(tangent, left);
    return v3_unit(v3_reject(v3_add(v3_scale(cos(plane), left), v3_scale(sin(plane), up)), tangent));
}

/* Size of a change of grade that is only rounding. */
static const double RISE_MIN = 1e-14;

/* Change of tan(slope) along a parabola; 0: it is a straight grade, and has no knots. */
static double parabola_rise(const RouteCurve *c)
{
    const double rise = fabs(c->vertical * c->end);
    return rise > RISE_MIN * (1 + c->grade * c->grade) ? rise : 0;
}

/* Number of steps of u for the integrals: at most 0.3 rad of plan and of change of slope each; for a cubic until its
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

/* Finds largest curvature, total angle and jerk by samples along the piece; a curve's largest curvature is at its ends
 * or at a sample, refined by a parabola through three. */
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

/* Sets a curve or cubic that begins at p->start with p->tangent: `left` is the level left there; fills in the rest of p
 * except kind and name. Knots are added to the route. Errors: MEMORY. */
static hawser_status route_curve_set(Route *route, RoutePiece *p, const RoutePieceDef *def, Vec3 left,
                                     hawser_error *err)
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

/* Horizontal part of a unit tangent below which it counts as vertical; rounding leaves about 1e-15 of it. */
static const double LEVEL_MIN = 1e-9;

/* The level unit vector to the left of a tangent, e_z x t (R2); the zero vector for a vertical tangent. */
static Vec3 route_level_left(Vec3 t)
{
    const double level = hypot(t.x, t.y);
    return level > LEVEL_MIN ? v3(-t.y / level, t.x / level, 0) : v3(0, 0, 0);
}

/* Position, tangent and curvature at distance x from a piece's start; straight for x < 0. (R1), (RO1) */
static RoutePoint piece_at(const Route *route, const RoutePiece *p, double x)
{
    if (p->kind >= ROUTE_CURVE && x >= 0) return route_curve_at(route, p, x);
    RoutePoint at = {.position = v3_axpy(p->start, x, p->tangent), .tangent = p->tangent};
    if (p->kind == ROUTE_BEND && x >= 0) {
        const double turn = x / p->radius, c = cos(turn), s = sin(turn), half = sin(turn / 2);
        at.position = v3_add(
            p->start, v3_add(v3_scale(p->radius * s, p->tangent), v3_scale(p->radius * 2 * half * half, p->centre)));
        at.tangent = v3_unit(v3_add(v3_scale(c, p->tangent), v3_scale(s, p->centre)));
        at.curvature = v3_scale(1 / p->radius, v3_axpy(v3_scale(c, p->centre), -s, p->tangent));
    }
    return at;
}

/* The tangent with this slope and this level left. */
static Vec3 tangent_on(double slope, Vec3 left)
{
    return v3_axpy(v3_scale(cos(slope), v3(left.y, -left.x, 0)), sin(slope), v3(0, 0, 1));
}

/* Sets one piece to begin at s0 with the given start and tangent; left is the level left there. */
static hawser_status piece_set(Route *route, RoutePiece *p, const RoutePieceDef *def, const RoutePoint *at, Vec3 left,
                               hawser_error *err)
{
    const int bend = def->kind == ROUTE_BEND;
    *p = (RoutePiece){
        .kind = def->kind, .listed = def->listed, .s0 = route->length, .start = at->position, .tangent = at->tangent};
    memcpy(p->name, def->name, sizeof p->name);
    if (def->sloped) p->tangent = tangent_on(def->slope, left);
    if (def->kind >= ROUTE_CURVE) return route_curve_set(route, p, def, left, err);
    p->length = bend ? def->radius * def->angle : def->length;
    p->radius = bend ? def->radius : 0;
    p->angle = bend ? def->angle : 0;
    p->centre = bend ? route_centre(p->tangent, left, def->plane) : v3(0, 0, 0);
    assert(p->length > 0);
    return HAWSER_OK;
}

hawser_status route_build(Route *route, int n, const RoutePieceDef *def, Vec3 start, double heading, double slope,
                          hawser_error *err)
{
    assert(n >= 1);
    *route = (Route){.n = n, .piece = calloc((size_t)n, sizeof *route->piece)};
    if (!route->piece) {
        route->n = 0;
        return error_memory(err);
    }
    RoutePoint at = {.position = start};
    at.tangent = v3(cos(slope) * cos(heading), cos(slope) * sin(heading), sin(slope));
    route->left = route_level_left(at.tangent);
    if (v3_norm(route->left) < 0.5) route->left = v3(-sin(heading), cos(heading), 0);
    Vec3 left = route->left;
    hawser_status status = HAWSER_OK;
    for (int i = 0; i < n && !status; i++) {
        status = piece_set(route, &route->piece[i], &def[i], &at, left, err);
        if (status) break;
        at = piece_at(route, &route->piece[i], route->piece[i].length);
        route->length += route->piece[i].length;
        left = route_left(route, route->length);
    }
    if (status) route_clear(route);
    return status;
}

void route_clear(Route *route)
{
    free(route->piece);
    free(route->knot);
    *route = (Route){0};
}

/* The last piece that begins at or before s, among those that are built; 0 before the first. */
static int piece_find(const Route *route, double s)
{
    int low = 0, high = route->n;
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        const RoutePiece *p = &route->piece[middle];
        if (p->length > 0 && p->s0 <= s) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

RoutePoint route_at(const Route *route, double s)
{
    const int i = piece_find(route, s);
    const RoutePiece *p = &route->piece[i];
    const double beyond = s - route->length;
    RoutePoint at = piece_at(route, p, beyond > 0 ? p->length : s - p->s0);
    at.piece = i;
    if (beyond > 0) {
        at.position = v3_axpy(at.position, beyond, at.tangent);
        at.curvature = v3(0, 0, 0);
    }
    return at;
}

RoutePoint route_on_piece(const Route *route, int piece, double s)
{
    const RoutePiece *const p = &route->piece[piece];
    RoutePoint at = piece_at(route, p, fmin(fmax(s - p->s0, 0), p->length));
    at.piece = piece;
    return at;
}

RoutePoint route_way_on_piece(const Route *route, int piece, double s)
{
    const RoutePiece *const p = &route->piece[piece];
    assert(p->kind >= ROUTE_CURVE);
    RoutePoint at = route_curve_way(route, p, fmin(fmax(s - p->s0, 0), p->length));
    at.piece = piece;
    return at;
}

double route_turn(const Route *route, double s)
{
    const RoutePiece *const p = &route->piece[piece_find(route, s)];
    if (p->kind == ROUTE_STRAIGHT || s > route->length || s < p->s0) return 0;
    return p->kind == ROUTE_BEND ? 1 / p->radius : v3_norm(route_at(route, s).curvature);
}

double route_way(const RoutePoint *at, Vec3 p) { return fmax(1 - v3_dot(v3_sub(p, at->position), at->curvature), 0.1); }

/* Checks whether a step of Newton's iteration leaves less than 1e-10 m: on one piece it leaves the curvature times its
 * square. */
static int foot_found(const RoutePoint *before, const RoutePoint *there, double step)
{
    const double bend2 = fmax(v3_dot(before->curvature, before->curvature), v3_dot(there->curvature, there->curvature));
    if (before->piece != there->piece) return !(fabs(step) > 1e-8);
    return !(step * step * step * step * bend2 > 1e-20);
}

/* Newton's iteration for the foot, on any pieces. */
static double foot_search(const Route *route, Vec3 p, double s)
{
    RoutePoint there = route_at(route, s);
    for (int it = 0, found = 0; it < 8 && !found; ++it) {
        const RoutePoint before = there;
        const double step = v3_dot(v3_sub(p, there.position), there.tangent) / route_way(&there, p);
        s += step;
        there = route_at(route, s);
        found = foot_found(&before, &there, step);
    }
    return s;
}

/* Foot of a point on a straight or a bend's whole circle, m from the piece's start; a circle has one each turn, and the
 * one nearest to `near` counts. (R4) */
static double foot_on(const RoutePiece *p, Vec3 at, double near)
{
    const Vec3 off = v3_sub(at, p->start);
    const double along = v3_dot(off, p->tangent);
    if (p->kind == ROUTE_STRAIGHT) return along;
    const double turn = atan2(along, p->radius - v3_dot(off, p->centre));
    return p->radius * (turn + 2 * M_PI * round((near / p->radius - turn) / (2 * M_PI)));
}

/* Place of the foot: the search begins on the piece at s and goes to the neighbour on whose side the foot
 * lies. A foot that each of two neighbours places on the other one is the corner between them. (R4) */
static double foot_of(const Route *route, Vec3 p, double s)
{
    const int last = route->n - 1;
    for (int i = piece_find(route, s), came = 0;; i += came) {
        const RoutePiece *const piece = &route->piece[i];
        if (piece->kind >= ROUTE_CURVE) return foot_search(route, p, s);
        const double x = foot_on(piece, p, s - piece->s0);
        if (x < 0 && i == 0) return piece->s0 + fmin(v3_dot(v3_sub(p, piece->start), piece->tangent), 0);
        if (x > piece->length && i == last) {
            const RoutePoint end = piece_at(route, piece, piece->length);
            return route->length + fmax(v3_dot(v3_sub(p, end.position), end.tangent), 0);
        }
        const int side = x < 0 ? -1 : x > piece->length;
        if (!side) return piece->s0 + x;
        s = side < 0 ? piece->s0 : piece->s0 + piece->length;
        if (came == -side) return s;
        came = side;
    }
}

double route_foot(const Route *route, Vec3 p, double s, RoutePoint *at)
{
    s = foot_of(route, p, s);
    if (at) *at = route_at(route, s);
    return s;
}

double route_slope(const Route *route, double s)
{
    const Vec3 t = route_at(route, s).tangent;
    return atan2(t.z, hypot(t.x, t.y));
}

int route_grade_lost(const Route *route, double least, double *before, double *after)
{
    for (int i = 0; i < route->n; ++i) {
        const RoutePiece *const p = &route->piece[i];
        if (p->kind != ROUTE_BEND || fabs(p->centre.z) > 1e-9) continue;
        *before = route_slope(route, p->s0);
        *after = route_slope(route, p->s0 + p->length);
        if (fabs(*after - *before) > least) return i;
    }
    return -1;
}

int route_turns_aside(const RoutePiece *piece)
{
    if (piece->kind == ROUTE_BEND) return fabs(v3_cross(piece->tangent, piece->centre).z) > 1e-9;
    return piece->kind != ROUTE_STRAIGHT && piece->curve.sideways;
}

/* Checks whether piece p + 1 bends in the same way as p does at its end. */
static int turns_on(const Route *route, int p)
{
    const RoutePiece *const one = &route->piece[p], *const next = &route->piece[p + 1];
    if (one->kind == ROUTE_STRAIGHT || one->kind != next->kind) return 0;
    const Vec3 turn = route_on_piece(route, p, next->s0).curvature;
    const Vec3 jump = v3_sub(route_on_piece(route, p + 1, next->s0).curvature, turn);
    return v3_norm(jump) < 1e-6 * v3_norm(turn);
}

int route_turn_end(const Route *route, int first)
{
    int last = first;
    while (last + 1 < route->n && turns_on(route, last)) ++last;
    return last;
}

const char *route_piece_word(const RoutePiece *piece)
{
    static const char *const words[] = {"straight", "bend", "curve", "cubic"};
    const RouteCurve *const c = &piece->curve;
    if (piece->kind != ROUTE_CURVE) return words[piece->kind];
    if (fabs(c->sharp) > 0) return c->profile == PROFILE_GRADE ? "clothoid" : "curve";
    if (!(fabs(c->bend) > 0)) {
        static const char *const names[] = {
            [PROFILE_GRADE] = "straight", [PROFILE_ARC] = "vertical arc", [PROFILE_PARABOLA] = "parabola"};
        return names[c->profile];
    }
    return c->profile == PROFILE_GRADE ? "helix" : "curve";
}

/* If the tangent is vertical inside a bend, the tangent just before it is t - ds c with the level vector c toward the
 * centre; if a piece begins vertically, the piece before it decides. (R3) */
Vec3 route_left(const Route *route, double s)
{
    const RoutePoint at = route_at(route, s);
    Vec3 left = route_level_left(at.tangent);
    for (int i = at.piece; v3_norm(left) < 0.5 && i >= 0; i--) {
        const RoutePiece *p = &route->piece[i];
        const double x = s < p->s0 + p->length ? s - p->s0 : p->length;
        const RoutePoint before = piece_at(route, p, x);
        left = route_level_left(before.tangent);
        if (v3_norm(left) < 0.5 && x > 0) left = route_level_left(v3_scale(-1, before.curvature));
    }
    return v3_norm(left) < 0.5 ? route->left : v3_unit(left);
}

/* Pieces from straights with slopes, and from points. */

/* Lengths and angles below these are rounding, m and rad. */
static const double LENGTH_MIN = 1e-9, ANGLE_MIN = 1e-10;

/* A line with room for so many pieces. Errors: MEMORY. */
static hawser_status line_new(RouteLine *out, int room, Vec3 start, double heading, double slope, hawser_error *err)
{
    *out = (RouteLine){.start = start, .heading = heading, .slope = slope};
    out->piece = calloc((size_t)room, sizeof *out->piece);
    return out->piece ? HAWSER_OK : error_memory(err);
}

static hawser_status line_drop(RouteLine *line, hawser_status status)
{
    if (!status) return status;
    free(line->piece);
    *line = (RouteLine){0};
    return status;
}

/* ------------------------------------------------------------------------------------------- changes of slope */

/* Length that the corners take off each straight, and the slopes at its start. */
typedef struct Corner {
    double change;        /* rad, of slope at the piece's beginning */
    double ahead, behind; /* m off this piece at its start; off the one before at its end */
} Corner;

/* Finds the corners of the present line by building it. Errors: MEMORY. */
static hawser_status corners_find(int n, const RoutePieceDef *def, const RouteLine *line, double radius, Corner *corner,
                                  hawser_error *err)
{
    Route route;
    const hawser_status status = route_build(&route, n, def, V3_ZERO, line->heading, line->slope, err);
    if (status) return status;
    for (int i = 1; i < n; ++i) {
        if (!def[i].sloped || def[i].kind != ROUTE_STRAIGHT) continue;
        const Vec3 before = route_on_piece(&route, i - 1, route.length).tangent;
        corner[i].change = def[i].slope - atan2(before.z, hypot(before.x, before.y));
        if (fabs(corner[i].change) < ANGLE_MIN) continue;
        const double off = radius * tan(fabs(corner[i].change) / 2);
        const int shared = def[i - 1].kind == ROUTE_STRAIGHT;
        corner[i].ahead = shared ? off : 2 * off;
        corner[i].behind = shared ? off : 0;
    }
    route_clear(&route);
    return HAWSER_OK;
}

hawser_status route_round_slopes(int n, const RoutePieceDef *def, double heading, double slope, double radius,
                                 RouteLine *out, hawser_error *err)
{
    assert(n >= 1 && radius > 0);
    hawser_status status = line_new(out, 2 * n, V3_ZERO, heading, def[0].sloped ? def[0].slope : slope, err);
    Corner *const corner = calloc((size_t)n + 1, sizeof *corner);
    if (!status && !corner) status = error_memory(err);
    if (!status) status = corners_find(n, def, out, radius, corner, err);
    for (int i = 0; i < n && !status; ++i) {
        if (fabs(corner[i].change) >= ANGLE_MIN) {
            out->piece[out->n++] = (RoutePieceDef){.kind = ROUTE_BEND,
                                                   .name = "change of slope",
                                                   .radius = radius,
                                                   .angle = fabs(corner[i].change),
                                                   .plane = corner[i].change > 0 ? M_PI / 2 : 3 * M_PI / 2};
        }
        RoutePieceDef piece = def[i];
        const double off = corner[i].ahead + corner[i + 1].behind;
        if (piece.kind == ROUTE_STRAIGHT) piece.length -= off;
        if (piece.kind == ROUTE_STRAIGHT && piece.length < -LENGTH_MIN) {
            status = error_set(err, HAWSER_ERR_INPUT,
                               "piece %d ('%s'), %g m long, is too short for the changes of slope at its ends: with a "
                               "transition radius of %g m they take %.4g m",
                               i, piece.name, def[i].length, radius, off);
        }
        if (piece.kind != ROUTE_STRAIGHT || piece.length > LENGTH_MIN) out->piece[out->n++] = piece;
    }
    free(corner);
    return line_drop(out, status);
}

/* ------------------------------------------------------------------------------------------------------ polylines */

/* Progress along a polyline. */
typedef struct Walk {
    Vec3 tangent, left;
    double taken; /* m of the next leg that the last corner used */
} Walk;

/* The level left after a turn from w->tangent to `ahead`, as in route_left (R3). */
static Vec3 left_behind(const Walk *w, Vec3 ahead, Vec3 centre, double turn)
{
    Vec3 left = route_level_left(ahead);
    if (v3_norm(left) > 0.5) return left;
    left = route_level_left(v3_axpy(v3_scale(-cos(turn), centre), sin(turn), w->tangent));
    return v3_norm(left) > 0.5 ? left : w->left;
}

/* Corner i: the straight before it and its bend. */
static hawser_status corner_take(const RouteCorner *corner, int i, Walk *w, RouteLine *out, hawser_error *err)
{
    const Vec3 back = v3_sub(corner[i].point, corner[i - 1].point), on = v3_sub(corner[i + 1].point, corner[i].point);
    const Vec3 ahead = v3_unit(on), centre = v3_unit(v3_reject(ahead, w->tangent));
    const double sine = v3_norm(v3_cross(w->tangent, ahead)), turn = atan2(sine, v3_dot(w->tangent, ahead));
    if (turn > M_PI - 1e-3)
        return error_set(err, HAWSER_ERR_INPUT, "the points %d to %d turn back on themselves", i, i + 2);
    const double off = turn > ANGLE_MIN ? corner[i].radius * tan(turn / 2) : 0;
    const double straight = v3_norm(back) - w->taken - off;
    if (straight < -LENGTH_MIN || off > v3_norm(on) + LENGTH_MIN) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "the points beside point %d are too near for a radius of %g m, which takes %.4g m on either "
                         "side: the legs are %.4g m (%.4g m of it taken) and %.4g m long",
                         i + 1, corner[i].radius, off, v3_norm(back), w->taken, v3_norm(on));
    }
    RoutePieceDef *const at = out->piece;
    if (straight > LENGTH_MIN) at[out->n++] = (RoutePieceDef){.kind = ROUTE_STRAIGHT, .length = straight};
    w->taken = off;
    if (!(off > 0)) return HAWSER_OK;
    const Vec3 up = v3_cross(w->tangent, w->left);
    at[out->n] = (RoutePieceDef){.kind = ROUTE_BEND,
                                 .radius = corner[i].radius,
                                 .angle = turn,
                                 .plane = atan2(v3_dot(centre, up), v3_dot(centre, w->left))};
    snprintf(at[out->n++].name, ROUTE_NAME_MAX, "point %d", i + 1);
    w->left = left_behind(w, ahead, centre, turn);
    w->tangent = ahead;
    return HAWSER_OK;
}

static hawser_status points_check(int n, const Vec3 *point, size_t stride, hawser_error *err)
{
    for (int i = 1; i < n; ++i) {
        const Vec3 a = *(const Vec3 *)((const char *)point + (size_t)(i - 1) * stride);
        const Vec3 b = *(const Vec3 *)((const char *)point + (size_t)i * stride);
        if (!(v3_norm(v3_sub(b, a)) > 1e-6))
            return error_set(err, HAWSER_ERR_INPUT, "the points %d and %d are the same", i, i + 1);
    }
    return HAWSER_OK;
}

hawser_status route_from_corners(int n, const RouteCorner *corner, RouteLine *out, hawser_error *err)
{
    assert(n >= 2);
    *out = (RouteLine){0};
    hawser_status status = points_check(n, &corner->point, sizeof *corner, err);
    if (status) return status;
    const Vec3 first = v3_unit(v3_sub(corner[1].point, corner[0].point));
    const double heading = hypot(first.x, first.y) > 1e-9 ? atan2(first.y, first.x) : 0;
    status = line_new(out, 2 * n, corner[0].point, heading, atan2(first.z, hypot(first.x, first.y)), err);
    Walk w = {.tangent = first, .left = v3(-sin(heading), cos(heading), 0)};
    for (int i = 1; i + 1 < n && !status; ++i) status = corner_take(corner, i, &w, out, err);
    if (status) return line_drop(out, status);
    const double last = v3_norm(v3_sub(corner[n - 1].point, corner[n - 2].point)) - w.taken;
    if (last > LENGTH_MIN) out->piece[out->n++] = (RoutePieceDef){.kind = ROUTE_STRAIGHT, .length = last};
    return HAWSER_OK;
}

/* --------------------------------------------------------------------------------------------------------- splines */

/* Second derivatives by chord length at the points, natural ends: the tridiagonal system of (RO15) by elimination;
 * share[n] is scratch. */
static void spline_bend(int n, const Vec3 *point, double *share, Vec3 *bend)
{
    bend[0] = bend[n - 1] = V3_ZERO;
    share[0] = 0;
    for (int i = 1; i + 1 < n; ++i) {
        const Vec3 back = v3_sub(point[i], point[i - 1]), on = v3_sub(point[i + 1], point[i]);
        const double h0 = v3_norm(back), h1 = v3_norm(on), pivot = 2 * (h0 + h1) - h0 * share[i - 1];
        const Vec3 right = v3_scale(6, v3_sub(v3_scale(1 / h1, on), v3_scale(1 / h0, back)));
        bend[i] = v3_scale(1 / pivot, v3_axpy(right, -h0, bend[i - 1]));
        share[i] = h1 / pivot;
    }
    for (int i = n - 2; i > 0; --i) bend[i] = v3_axpy(bend[i], -share[i], bend[i + 1]);
}

hawser_status route_from_spline(int n, const Vec3 *point, RouteLine *out, hawser_error *err)
{
    assert(n >= 2);
    *out = (RouteLine){0};
    hawser_status status = points_check(n, point, sizeof *point, err);
    if (status) return status;
    Vec3 *const bend = malloc((size_t)n * sizeof *bend);
    double *const share = malloc((size_t)n * sizeof *share);
    status = line_new(out, n, point[0], 0, 0, err);
    if (!status && !(bend && share)) status = error_memory(err);
    if (!status) spline_bend(n, point, share, bend);
    for (int i = 0; i + 1 < n && !status; ++i) {
        const Vec3 way = v3_sub(point[i + 1], point[i]);
        const double h2 = v3_dot(way, way);
        RoutePieceDef *const p = &out->piece[out->n++];
        p->kind = ROUTE_CUBIC;
        p->cubic[0] = v3_axpy(way, -h2 / 6, v3_add(v3_scale(2, bend[i]), bend[i + 1]));
        p->cubic[1] = v3_scale(h2 / 2, bend[i]);
        p->cubic[2] = v3_scale(h2 / 6, v3_sub(bend[i + 1], bend[i]));
        snprintf(p->name, sizeof p->name, "points %d to %d", i + 1, i + 2);
    }
    if (!status) {
        const Vec3 first = out->piece[0].cubic[0];
        out->heading = atan2(first.y, first.x);
        out->slope = atan2(first.z, hypot(first.x, first.y));
    }
    free(bend);
    free(share);
    return line_drop(out, status);
}

/* Pieces from plan and profile. */

/* Elements shorter than this are rounding, m; so are corners of less than this, rad. */
static const double PLAN_LENGTH_MIN = 1e-6, CORNER_MAX = 1e-6;

/* ---------------------------------------------------------------------------------------------------- the profile */

/* Horizontal lengths that the rounding of a corner takes before and behind it, between two slopes. */
static void corner_off(const RouteProfileCorner *c, double radius, const double slope[2], double off[2])
{
    const double round = c->radius > 0 ? c->radius : c->parabola > 0 ? 0 : radius;
    const double tangent = round * tan(fabs(slope[1] - slope[0]) / 2);
    for (int k = 0; k < 2; ++k) off[k] = round > 0 ? tangent * cos(slope[k]) : c->parabola / 2;
}

static double slope_between(const RouteProfileCorner *a)
{
    return atan2(a[1].height - a->height, a[1].station - a->station);
}

/* Adds the grade behind corner i - 1 and the rounding of corner i; taken: length of the grade used by the corner before
 * it. */
static hawser_status corner_add(int n, const RouteProfileCorner *c, int i, double radius, double *taken,
                                RouteProfile *out, hawser_error *err)
{
    const double run = c[i].station - c[i - 1].station;
    const int last = i == n - 1;
    const double slope[2] = {slope_between(&c[i - 1]), last ? 0 : slope_between(&c[i])};
    double off[2] = {0, 0};
    if (!last) corner_off(&c[i], radius, slope, off);
    const double grade = run - *taken - off[0];
    if (grade < -PLAN_LENGTH_MIN) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "the profile between points %d and %d, %.4g m, is too short for the roundings at its ends, "
                         "which take %.4g m",
                         i, i + 1, run, *taken + off[0]);
    }
    RouteProfileElement *const e = out->element;
    if (grade > PLAN_LENGTH_MIN) e[out->n++] = (RouteProfileElement){PROFILE_GRADE, grade, {slope[0], slope[0]}};
    if (off[0] + off[1] > PLAN_LENGTH_MIN) {
        const RouteProfileKind kind = c[i].radius > 0 || !(c[i].parabola > 0) ? PROFILE_ARC : PROFILE_PARABOLA;
        e[out->n++] = (RouteProfileElement){kind, off[0] + off[1], {slope[0], slope[1]}};
    }
    *taken = off[1];
    return HAWSER_OK;
}

hawser_status route_profile_from_corners(int n, const RouteProfileCorner *corner, double radius, RouteProfile *out,
                                         hawser_error *err)
{
    assert(n >= 2 && radius > 0);
    *out = (RouteProfile){0};
    for (int i = 1; i < n; ++i) { /* checked before slopes between them are used */
        if (!(corner[i].station - corner[i - 1].station > PLAN_LENGTH_MIN))
            return error_set(err, HAWSER_ERR_INPUT, "the stations of profile points %d and %d do not rise", i, i + 1);
    }
    *out = (RouteProfile){.station = corner[0].station, .height = corner[0].height};
    out->element = calloc((size_t)(2 * n), sizeof *out->element);
    hawser_status status = out->element ? HAWSER_OK : error_memory(err);
    double taken = 0;
    for (int i = 1; i < n && !status; ++i) status = corner_add(n, corner, i, radius, &taken, out, err);
    if (!status) return status;
    free(out->element);
    *out = (RouteProfile){0};
    return status;
}

/* Slope inside an element, at a horizontal distance from its start: a parabola's tangent and an arc's sine are
 * linear. */
static double slope_inside(const RouteProfileElement *e, double x)
{
    const double share = x / e->length;
    if (e->kind == PROFILE_GRADE) return e->slope[0];
    if (e->kind == PROFILE_PARABOLA) return atan((1 - share) * tan(e->slope[0]) + share * tan(e->slope[1]));
    return asin((1 - share) * sin(e->slope[0]) + share * sin(e->slope[1]));
}

/* Rise of an element up to there (RO12). */
static double rise_inside(const RouteProfileElement *e, double x)
{
    const double to = slope_inside(e, x);
    if (e->kind == PROFILE_ARC) return x * tan((e->slope[0] + to) / 2);
    return x * (tan(e->slope[0]) + tan(to)) / 2;
}

/* ---------------------------------------------------------------------------------------------- plan and profile */

/* Progress along both. */
typedef struct Both {
    const RoutePlanElement *plan;
    const RouteProfile *profile;
    int i, k;        /* indices of the elements */
    double at, rise; /* m, within them */
} Both;

/* The next piece: to the end of the nearer element. */
static RoutePieceDef piece_next(const Both *b, double *length)
{
    const RoutePlanElement *const plan = &b->plan[b->i];
    const RouteProfileElement level = {PROFILE_GRADE, INFINITY, {0, 0}};
    const RouteProfileElement *const e = b->profile ? &b->profile->element[b->k] : &level;
    double run = fmin(plan->length - b->at, e->length - b->rise);
    if (plan->length - b->at - run < PLAN_LENGTH_MIN) run = plan->length - b->at;
    *length = run;
    const double by = (plan->curvature[1] - plan->curvature[0]) / plan->length;
    const double up = slope_inside(e, b->rise), to = slope_inside(e, fmin(b->rise + run, e->length));
    RoutePieceDef p = {.kind = ROUTE_CURVE, .length = run, .sloped = 1, .slope = up, .upright = 1};
    memcpy(p.name, plan->name, sizeof p.name);
    p.curvature[0] = plan->curvature[0] + by * b->at;
    p.curvature[1] = plan->curvature[0] + by * (b->at + run);
    p.profile = fabs(to - up) > 0 ? e->kind : PROFILE_GRADE;
    p.slope_end = to;
    return p;
}

/* Returns the piece as a straight or a bend in a plane if it is one: those have closed forms. */
static RoutePieceDef piece_plain(RoutePieceDef p)
{
    const int straight = !(fabs(p.curvature[0]) + fabs(p.curvature[1]) > 0);
    const int circle = fabs(p.curvature[1] - p.curvature[0]) <= 1e-14 * fabs(p.curvature[0]);
    if (straight && p.profile == PROFILE_GRADE) {
        p.kind = ROUTE_STRAIGHT;
        p.length /= cos(p.slope);
    } else if (straight && p.profile == PROFILE_ARC) {
        p.kind = ROUTE_BEND;
        p.angle = fabs(p.slope_end - p.slope);
        p.radius = p.length / fabs(sin(p.slope_end) - sin(p.slope));
        p.plane = p.slope_end > p.slope ? M_PI / 2 : 3 * M_PI / 2;
    } else if (circle && p.profile == PROFILE_GRADE && !(fabs(p.slope) > 0)) {
        p.kind = ROUTE_BEND;
        p.radius = 1 / fabs(p.curvature[0]);
        p.angle = p.length / p.radius;
        p.plane = p.curvature[0] > 0 ? 0 : M_PI;
    }
    return p;
}

/* Finds the plan's beginning in the profile, and checks that the profile covers the plan and has no corners. */
static hawser_status profile_enter(Both *b, double station, double length, double *height, hawser_error *err)
{
    const RouteProfile *const p = b->profile;
    double from = p->station, whole = p->station;
    *height = p->height;
    for (int k = 0; k < p->n; ++k) {
        const RouteProfileElement *const e = &p->element[k];
        if (k > 0 && fabs(e->slope[0] - e[-1].slope[1]) > CORNER_MAX)
            return error_set(err, HAWSER_ERR_INPUT, "the profile has a corner at station %.10g m: round it", whole);
        whole += e->length;
        if (k > b->k || station < from) continue;
        b->rise = fmin(station - from, e->length);
        if (station - from < e->length - PLAN_LENGTH_MIN || k == p->n - 1) {
            *height += rise_inside(e, b->rise);
            continue;
        }
        *height += rise_inside(e, e->length);
        from += e->length;
        b->k = k + 1;
        b->rise = 0;
    }
    if (station >= p->station - PLAN_LENGTH_MIN && whole >= station + length - 1e-3) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT,
                     "the profile reaches from station %.10g m to %.10g m, the plan from %.10g m to %.10g m",
                     p->station, whole, station, station + length);
}

hawser_status route_from_plan_and_profile(int n, const RoutePlanElement *plan, const RouteProfile *profile,
                                          double station, Vec3 start, double heading, RouteLine *out, hawser_error *err)
{
    assert(n >= 1);
    *out = (RouteLine){.start = start, .heading = heading};
    Both b = {.plan = plan, .profile = profile};
    double length = 0;
    for (int i = 0; i < n; ++i) length += plan[i].length;
    const hawser_status status = profile ? profile_enter(&b, station, length, &out->start.z, err) : HAWSER_OK;
    if (status) return status;
    out->piece = calloc((size_t)(n + (profile ? profile->n : 0) + 1), sizeof *out->piece);
    if (!out->piece) return error_memory(err);
    while (b.i < n) {
        double run;
        const RoutePieceDef piece = piece_next(&b, &run);
        if (run > PLAN_LENGTH_MIN) out->piece[out->n++] = piece_plain(piece);
        b.at += run;
        b.rise += run;
        if (b.plan[b.i].length - b.at < PLAN_LENGTH_MIN) {
            b.i++;
            b.at = 0;
        }
        /* the last grade may end a rounding error before the plan does */
        if (profile && b.k + 1 < profile->n && profile->element[b.k].length - b.rise < PLAN_LENGTH_MIN) {
            b.k++;
            b.rise = 0;
        } else if (profile && b.k + 1 == profile->n && profile->element[b.k].length - b.rise < PLAN_LENGTH_MIN) {
            break;
        }
    }
    out->slope = out->n > 0 ? out->piece[0].slope : 0;
    return HAWSER_OK;
}
