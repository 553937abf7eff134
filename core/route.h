/* A route: straights and circular bends end to end in three dimensions, with tangents that join smoothly.
 * It is the line on which the cable's centre is meant to lie. s is the arc length from the start, m. */
#ifndef HAWSER_CORE_ROUTE_H
#define HAWSER_CORE_ROUTE_H

#include "core/base/vec3.h"
#include "hawser/hawser.h"

typedef enum RoutePieceKind { ROUTE_STRAIGHT, ROUTE_BEND } RoutePieceKind;

enum { ROUTE_NAME_MAX = 48 };

/* One piece as the user describes it; plane is the angle of the bend's centre about the tangent: 0 the centre lies to
 * the left and level, pi/2 above (the route turns upward), pi to the right, 3pi/2 below. */
typedef struct RoutePieceDef {
    RoutePieceKind kind;
    char name[ROUTE_NAME_MAX];
    double length; /* straight: m, > 0 */
    double radius; /* bend: m, > 0 */
    double angle;  /* bend: rad, > 0 */
    double plane;  /* bend: rad */
} RoutePieceDef;

typedef struct RoutePiece {
    RoutePieceKind kind;
    char name[ROUTE_NAME_MAX];
    double s0, length; /* m */
    double radius, angle;
    Vec3 start;   /* m */
    Vec3 tangent; /* unit, at the piece's start */
    Vec3 centre;  /* bends: unit vector from the start toward the centre */
} RoutePiece;

typedef struct Route {
    int n;
    RoutePiece *piece; /* [n] */
    double length;     /* m */
} Route;

/* What the route is like at arc length s: position (m), unit tangent, curvature vector (1/m, toward the centre). */
typedef struct RoutePoint {
    Vec3 position, tangent, curvature;
    int piece;
} RoutePoint;

/* Builds a route of n >= 1 pieces from `start`; heading is the first tangent's angle from x toward y, slope its angle
 * above the horizontal (rad, |slope| < pi/2). Errors: HAWSER_ERR_MEMORY. The definitions must have been checked. */
hawser_status route_build(Route *route, int n, const RoutePieceDef *def, Vec3 start, double heading, double slope,
                          hawser_error *err);
void route_clear(Route *route);

/* The route at s; before 0 and past its length it goes on straight. */
RoutePoint route_at(const Route *route, double s);
/* Slope of the tangent above the horizontal at s, rad. */
double route_slope(const Route *route, double s);
/* A bend lies in one plane: one to the side that begins on a slope ends on another. The first of the route that begins
 * with its centre at its start's height and changes the slope by more than `least` (rad); its slopes at both ends. -1:
 * none. */
int route_grade_lost(const Route *route, double least, double *before, double *after);
/* Level unit vector to the left of the tangent at s (for a vertical tangent: of the heading before it). */
Vec3 route_left(const Route *route, double s);

#endif
