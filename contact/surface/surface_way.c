/* The way in parts: straights and arcs, cut at the route's corners and every quarter of a bend; curves are laid out in
 * pairs of arcs. */
#include "contact/surface/surface_patch.h"

#include "core/route.h"

static const double PI = 3.14159265358979323846;
/* Changes of roll below this are rounding, rad. */
static const double TWIST_MIN = 1e-9;
/* 1/m: an arc that bends less is laid straight. */
static const double STRAIGHT_MAX = 1e-7;

/* The longest part, m: a quarter of a bend; of a curve, a pair of arcs that stays within SURFACE_WAY_OFF of it (RO18).
 */
static double part_length(const RoutePiece *p)
{
    const double quarter = p->radius * PI / 2;
    return p->kind == ROUTE_BEND ? quarter : fmin(quarter, cbrt(100 * SURFACE_WAY_OFF / fmax(p->curve.jerk, 1e-12)));
}

/* Where the part of the way that begins at s ends: at a corner of the route, after at most a quarter of a bend, or at
 * `last`. The route goes on straight at both ends. */
static double way_end(const Route *route, double s, double last)
{
    if (s < 0) return fmin(0, last);
    if (s >= route->length) return last;
    const int i = route_at(route, s).piece;
    const RoutePiece *const p = &route->piece[i];
    const double corner = i + 1 < route->n ? route->piece[i + 1].s0 : route->length;
    double end = corner;
    if (p->kind != ROUTE_STRAIGHT) {
        const double parts = ceil((corner - s) / part_length(p) - 1e-9);
        if (parts > 1) end = s + (corner - s) / parts;
    }
    return fmin(end, last);
}

/* Angle of the level left at s about the tangent, from `side` toward tangent x side, within half a turn of `near`. */
static double roll_at(const Route *route, double s, Vec3 side, double near)
{
    const Vec3 left = route_left(route, s), up = v3_cross(route_at(route, s).tangent, side);
    const double roll = atan2(v3_dot(left, up), v3_dot(left, side));
    return roll + 2 * PI * round((near - roll) / (2 * PI));
}

/* The roll at both ends of an arc (DU6), followed along it so that no turn is lost. */
static void way_roll(const Route *route, double from, double to, SurfacePatch *way)
{
    enum { STEPS = 16 };
    double roll = roll_at(route, from, way->side, 0);
    way->roll[0] = roll;
    for (int k = 1; k <= STEPS; ++k) {
        /* the side turns with the arc and stays in its plane; the end belongs to this arc, not to the next piece */
        const double turn = (to - from) / way->bend * k / STEPS;
        const Vec3 side = v3_axpy(v3_scale(cos(turn), way->side), -sin(turn), way->tangent);
        roll = roll_at(route, k < STEPS ? from + (to - from) * k / STEPS : to, side, roll);
    }
    way->roll[1] = roll;
    way->twisted = fabs(way->roll[1] - way->roll[0]) > TWIST_MIN;
    way->roll_cos = cos(way->roll[0]);
    way->roll_sin = sin(way->roll[0]);
}

/* The part of the way between two places, without a section. Its end is, to the last bit, where the next one starts. */
static SurfacePatch way_part(const Route *route, double from, double to, int rolls)
{
    const RoutePoint a = route_at(route, from), b = route_at(route, to);
    SurfacePatch way = {.s0 = from, .length = to - from, .start = a.position, .tangent = a.tangent};
    way.depth = SURFACE_DEPTH_MAX;
    way.end = b.position;
    way.end_tangent = b.tangent;
    way.roll_cos = 1;
    const int inside = from >= 0 && from < route->length;
    if (inside && route->piece[a.piece].kind == ROUTE_BEND) {
        way.bend = route->piece[a.piece].radius;
        way.side = v3_unit(a.curvature);
        way.centre = v3_axpy(a.position, way.bend, way.side);
        if (rolls) way_roll(route, from, to, &way);
    } else {
        way.side = route_left(route, (from + to) / 2);
    }
    way.up = v3_cross(way.tangent, way.side);
    return way;
}

/* The level unit vector to the left of a tangent (R2); of an upright one any that is square to it. */
static Vec3 level_left(Vec3 t)
{
    const Vec3 left = v3(-t.y, t.x, 0);
    return v3_norm(left) > 1e-9 ? v3_unit(left) : v3_unit(v3_reject(v3(0, 1, 0), t));
}

/* The roll at both ends of an arc whose tangents are its own (DU6), followed along it. */
static void arc_roll(SurfacePatch *way)
{
    enum { STEPS = 16 };
    double roll = 0;
    for (int k = 0; k <= STEPS; ++k) {
        const double turn = way->length / way->bend * k / STEPS;
        const Vec3 side = v3_axpy(v3_scale(cos(turn), way->side), -sin(turn), way->tangent);
        const Vec3 tangent = v3_axpy(v3_scale(cos(turn), way->tangent), sin(turn), way->side);
        const Vec3 left = level_left(tangent);
        const double angle = atan2(v3_dot(left, v3_cross(tangent, side)), v3_dot(left, side));
        roll = angle + 2 * PI * round((roll - angle) / (2 * PI));
        if (k == 0) way->roll[0] = roll;
    }
    way->roll[1] = roll;
    way->twisted = fabs(way->roll[1] - way->roll[0]) > TWIST_MIN;
    way->roll_cos = cos(way->roll[0]);
    way->roll_sin = sin(way->roll[0]);
}

/* One arc of a pair, which leaves `a` along its tangent and comes to b; `on` is a's place along the route. */
static SurfacePatch way_arc(const RoutePoint *a, const RoutePoint *b, double on, int rolls)
{
    SurfacePatch way = {.s0 = on, .start = a->position, .tangent = a->tangent};
    const Vec3 chord = v3_sub(b->position, a->position), toward = v3_reject(b->tangent, a->tangent);
    const double half = atan2(v3_norm(toward), v3_dot(a->tangent, b->tangent)) / 2;
    way.depth = SURFACE_DEPTH_MAX;
    way.end = b->position;
    way.end_tangent = b->tangent;
    way.roll_cos = 1;
    way.length = v3_norm(chord);
    const Vec3 left = level_left(a->tangent);
    way.side = left;
    if (half > STRAIGHT_MAX * way.length) {
        way.bend = way.length / (2 * sin(half));
        way.length = 2 * half * way.bend;
        way.side = v3_unit(toward);
        way.centre = v3_axpy(a->position, way.bend, way.side);
        if (rolls) arc_roll(&way);
    }
    way.up = v3_cross(way.tangent, way.side);
    return way;
}

/* Two arcs that have places and tangents of the curve at both ends and a tangent in common where they meet (RO17). */
static int way_pair(const Route *route, double from, double to, int rolls, SurfacePatch *way)
{
    const RoutePoint a = route_at(route, from), b = route_at(route, to);
    const Vec3 v = v3_sub(b.position, a.position), both = v3_add(a.tangent, b.tangent);
    const Vec3 turn = v3_sub(b.tangent, a.tangent);
    const double v2 = v3_dot(v, v), on = v3_dot(v, both), d = v2 / (on + sqrt(on * on + v3_dot(turn, turn) * v2));
    const Vec3 p = v3_axpy(a.position, d, a.tangent), q = v3_axpy(b.position, -d, b.tangent);
    const RoutePoint middle = {.position = v3_scale(0.5, v3_add(p, q)), .tangent = v3_unit(v3_sub(q, p))};
    way[0] = way_arc(&a, &middle, from, rolls);
    way[1] = way_arc(&middle, &b, from + way[0].length, rolls);
    return 2;
}

int surface_way(const Route *route, double *s, double last, int rolls, SurfacePatch way[SURFACE_WAY_MAX])
{
    const double from = *s, to = way_end(route, from, last);
    *s = to;
    const int inside = from >= 0 && from < route->length;
    if (inside && route->piece[route_at(route, from).piece].kind >= ROUTE_CURVE)
        return way_pair(route, from, to, rolls, way);
    way[0] = way_part(route, from, to, rolls);
    return 1;
}
