/* Lists of pieces out of what surveyors and designers have: straights with slopes, points with fillets or a spline
 * through them, plan and profile by station. Readers of tables and drawings fill the plain structs below and get a
 * RouteLine, which route_build takes. docs/model.md, "Routes". */
#ifndef HAWSER_CORE_ROUTE_MAKE_H
#define HAWSER_CORE_ROUTE_MAKE_H

#include "core/route.h"

/* What route_build needs. */
typedef struct RouteLine {
    Vec3 start;            /* m */
    double heading, slope; /* rad */
    int n;
    RoutePieceDef *piece; /* [n] malloc'ed: the caller's; NULL after an error */
} RouteLine;

/* Rounds the corners at which straights begin on slopes of their own (RoutePieceDef.sloped): a bend in the vertical
 * plane of this radius (m), tangent to both straights, where the slope changes by more than rounding (RO13). Behind a
 * piece that is no straight the bend begins where that ends, and its tangents come off the straight. Errors: INPUT (a
 * straight is too short), MEMORY. */
hawser_status route_round_slopes(int n, const RoutePieceDef *def, double heading, double slope, double radius,
                                 RouteLine *out, hawser_error *err);

/* A point of a polyline, and the radius with which its corner is rounded; of the first and last it does not count. */
typedef struct RouteCorner {
    Vec3 point;    /* m */
    double radius; /* m, > 0 */
} RouteCorner;
/* n >= 2 points in space, corners rounded (RO14). Errors: INPUT (points that coincide, turn back or leave too little
 * room for the radius; they are named by number from 1 on), MEMORY. */
hawser_status route_from_corners(int n, const RouteCorner *corner, RouteLine *out, hawser_error *err);
/* The cubic spline through n >= 2 points, by chord lengths, without curvature at its ends (RO15). Errors: INPUT (points
 * that coincide), MEMORY. */
hawser_status route_from_spline(int n, const Vec3 *point, RouteLine *out, hawser_error *err);

/* A line, arc or clothoid of the plan: curvature goes evenly from one end to the other, 1/m, to the left positive. */
typedef struct RoutePlanElement {
    char name[ROUTE_NAME_MAX];
    double length; /* m, level */
    double curvature[2];
} RoutePlanElement;

/* A grade, circular arc or parabola of the profile. */
typedef struct RouteProfileElement {
    RouteProfileKind kind;
    double length;   /* m, level */
    double slope[2]; /* rad, at its start and end, within +-pi/2 */
} RouteProfileElement;

/* A corner of the profile: it is rounded by an arc of a radius or by a parabola of a level length. */
typedef struct RouteProfileCorner {
    double station, height; /* m */
    double radius;          /* m; 0: by the parabola, or sharp if there is none; not of the first and last */
    double parabola;        /* m, half of it on either side; 0: none */
} RouteProfileCorner;

typedef struct RouteProfile {
    double station, height; /* m, where it begins */
    int n;
    RouteProfileElement *element; /* [n] malloc'ed: the caller's; NULL after an error */
} RouteProfile;

/* n >= 2 corners by rising station; `radius` (m) rounds the sharp ones. Errors: INPUT (stations that do not rise,
 * roundings that overlap; corners are named by number from 1 on), MEMORY. */
hawser_status route_profile_from_corners(int n, const RouteProfileCorner *corner, double radius, RouteProfile *out,
                                         hawser_error *err);
/* Plan and profile together, cut at the elements of both (RO12). The plan begins at `station` of the profile at
 * (start.x, start.y), on this heading; the height is the profile's. profile NULL: level at start.z. Errors: INPUT (the
 * profile does not reach along the plan, or has corners), MEMORY. */
hawser_status route_from_plan_and_profile(int n, const RoutePlanElement *plan, const RouteProfile *profile,
                                          double station, Vec3 start, double heading, RouteLine *out,
                                          hawser_error *err);

#endif
