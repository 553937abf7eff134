/* The curves of a route: position, tangent and curvature by arc length, exact up to rounding. Equation numbers:
 * docs/model.md, "Routes". Used by route.c; callers want core/route.h. */
#ifndef HAWSER_CORE_ROUTE_CURVE_H
#define HAWSER_CORE_ROUTE_CURVE_H

#include "core/route.h"

/* Sets a curve or cubic that begins at p->start with p->tangent: `left` is the level left there, the rest of p but kind
 * and name is filled in. Knots are added to the route. Errors: MEMORY. */
hawser_status route_curve_set(Route *route, RoutePiece *p, const RoutePieceDef *def, Vec3 left, hawser_error *err);
/* At distance x from its start, within its length. */
RoutePoint route_curve_at(const Route *route, const RoutePiece *p, double x);

/* The level unit vector to the left of a tangent, e_z x t (R2); the zero vector for a vertical tangent. */
Vec3 route_level_left(Vec3 tangent);
/* Unit vector from a bend's start toward its centre: cos(plane) left + sin(plane) up, up = t x left. (R2) */
Vec3 route_centre(Vec3 tangent, Vec3 left, double plane);

#endif
