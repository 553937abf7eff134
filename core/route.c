#include "core/route.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"

/* Level part of a unit tangent below which it counts as vertical; rounding leaves about 1e-15 of it. */
static const double LEVEL_MIN = 1e-9;

Vec3 route_level_left(Vec3 t)
{
    const double level = hypot(t.x, t.y);
    return level > LEVEL_MIN ? v3(-t.y / level, t.x / level, 0) : v3(0, 0, 0);
}

/* Position, tangent and curvature at distance x from a piece's start; straight on for x < 0. (R1), (RO1) */
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

/* The tangent on this slope whose level left is known. */
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

/* Whether a step of Newton's iteration leaves less than 1e-10 m: on one piece it leaves the curvature times its square.
 */
static int foot_found(const RoutePoint *before, const RoutePoint *there, double step)
{
    const double bend2 = fmax(v3_dot(before->curvature, before->curvature), v3_dot(there->curvature, there->curvature));
    if (before->piece != there->piece) return !(fabs(step) > 1e-8);
    return !(step * step * step * step * bend2 > 1e-20);
}

double route_foot(const Route *route, Vec3 p, double s, RoutePoint *at)
{
    RoutePoint there = route_at(route, s);
    for (int it = 0, found = 0; it < 8 && !found; ++it) {
        const RoutePoint before = there;
        const double step = v3_dot(v3_sub(p, there.position), there.tangent) / route_way(&there, p);
        s += step;
        there = route_at(route, s);
        found = foot_found(&before, &there, step);
    }
    if (at) *at = there;
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

/* Whether piece p + 1 turns as p does at its end. */
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

/* Where the tangent is vertical inside a bend, the tangent just before it is t - ds c with the level vector c
 * toward the centre; where a piece begins vertically, the question goes to the piece before it. (R3) */
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
