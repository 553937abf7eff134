/* A route: pieces end to end in three dimensions, with continuous tangents: straights, bends in a plane, and curves
 * (clothoids, helices, plan and profile together, cubics). It is the intended line of the cable's centre. s is the arc
 * length from the start, m. docs/theory.md, "Routes". Lists of pieces from points, plans and profiles are made by
 * functions further down. */
#ifndef HAWSER_CORE_ROUTE_H
#define HAWSER_CORE_ROUTE_H

#include "core/vec3.h"
#include "hawser/hawser.h"

typedef enum RoutePieceKind { ROUTE_STRAIGHT, ROUTE_BEND, ROUTE_CURVE, ROUTE_CUBIC } RoutePieceKind;

/* Rise of a curve over its plan: slope's angle linear in s (constant, or a circular arc), or height a parabola. */
typedef enum RouteProfileKind { PROFILE_GRADE, PROFILE_ARC, PROFILE_PARABOLA } RouteProfileKind;

enum { ROUTE_NAME_MAX = 48 };

/* One piece as the user describes it; plane is the angle of the bend's centre about the tangent: 0 the centre lies to
 * the left and level, pi/2 above (the route turns upward), pi to the right, 3pi/2 below. A curve is a plan, whose
 * curvature is linear along its own length, with a profile over it. Upright: the plan is horizontal, curvature counts
 * to the left, and the profile begins on the slope that the route has there. Not upright: the plan is in the plane of
 * the tangent and of the centre given by `plane`, toward which curvature counts; it has no profile. */
typedef struct RoutePieceDef {
    RoutePieceKind kind;
    char name[ROUTE_NAME_MAX];
    double length;            /* straight: m, > 0; curve: of its plan */
    double radius;            /* bend: m, > 0 */
    double angle;             /* bend: rad, > 0 */
    double plane;             /* bend, curve that is not upright: rad */
    int sloped;               /* 1: it begins on a slope of its own, on the heading of the piece before: a corner
                               * (route_round_slopes) */
    double slope;             /* rad, that slope */
    int upright;              /* curve */
    double curvature[2];      /* curve: of the plan, at its start and end, 1/m; not both 0 unless the profile bends */
    RouteProfileKind profile; /* curve that is upright */
    double slope_end;         /* curve with an arc or a parabola: slope at its end, rad, within +-pi/2 */
    Vec3 cubic[3];            /* cubic: position from its start is c0 u + c1 u^2 + c2 u^3, 0 <= u <= 1, m; c0 != 0 */
    int listed; /* number among the listed pieces, from 1 on; 0: none, it was made from points or lies between two */
} RoutePieceDef;

/* Node of the integrals along a curve: its parameter u, arc length and plan up to there, m. */
typedef struct RouteKnot {
    double u, x;
    double along, aside;
} RouteKnot;

/* A curve that is built (RO1)-(RO9). The parameter u is the plan's length, m, or a cubic's 0..1. */
typedef struct RouteCurve {
    Vec3 axis[3];       /* unit: along the plan's first tangent, toward positive curvature, up */
    double bend, sharp; /* plan curvature at its start, 1/m, and its growth per metre, 1/m2 */
    RouteProfileKind profile;
    double slope;    /* rad, at its start, over the plan */
    double grade;    /* its tangent */
    double vertical; /* arc: 1/m, curvature of the profile; parabola: growth of tan(slope) per metre of plan */
    Vec3 cubic[3];
    double end;   /* u there */
    int first, n; /* among the route's knots: n + 1 of them at even steps of u; n = 0: closed form */
    double jerk;  /* 1/m2, largest |dkappa/ds| normal to the tangent */
    int sideways; /* 1: its plan is not straight */
} RouteCurve;

typedef struct RoutePiece {
    RoutePieceKind kind;
    char name[ROUTE_NAME_MAX];
    int listed;        /* as in its definition */
    double s0, length; /* m */
    double radius,
        angle;        /* m, rad; of curves the least radius in space and the total angle of the tangent; straights: 0 */
    Vec3 start;       /* m */
    Vec3 tangent;     /* unit, at the piece's start */
    Vec3 centre;      /* bends: unit vector from the start toward the centre */
    RouteCurve curve; /* curves and cubics */
} RoutePiece;

typedef struct Route {
    int n;
    RoutePiece *piece; /* [n] */
    double length;     /* m */
    Vec3 left;         /* level, unit: to the left of the first heading */
    int n_knots;
    RouteKnot *knot; /* [n_knots] of the curves */
} Route;

/* The route at arc length s: position (m), unit tangent, curvature vector (1/m, toward the centre). */
typedef struct RoutePoint {
    Vec3 position, tangent, curvature;
    int piece;
} RoutePoint;

/* Builds a route of n >= 1 pieces from `start`; heading is the first tangent's angle from x toward y, slope its angle
 * above the horizontal (rad, |slope| <= pi/2). Errors: HAWSER_ERR_MEMORY. The definitions must have been checked. */
hawser_status route_build(Route *route, int n, const RoutePieceDef *def, Vec3 start, double heading, double slope,
                          hawser_error *err);
void route_clear(Route *route);
/* The route at s; before 0 and past its length it continues straight. */
RoutePoint route_at(const Route *route, double s);
/* The same on one piece, whose formula is valid up to both its ends. */
RoutePoint route_on_piece(const Route *route, int piece, double s);
/* The same of a curve or cubic, without the position. */
RoutePoint route_way_on_piece(const Route *route, int piece, double s);
/* Curvature at s alone, 1/m. */
double route_turn(const Route *route, double s);
/* The foot of the perpendicular from p on the route near the place s (m); *at (may be NULL) is the route there. (R4) */
double route_foot(const Route *route, Vec3 p, double s, RoutePoint *at);
/* Distance by which p moves along the tangent as its foot `at` moves by 1 m: 1 less the curvature toward it. At least
 * 0.1: at a bend's centre every place of the bend is equally near. */
double route_way(const RoutePoint *at, Vec3 p);
/* Slope of the tangent above the horizontal at s, rad. */
double route_slope(const Route *route, double s);
/* Checks whether a piece turns to a side. */
int route_turns_aside(const RoutePiece *piece);
/* The last of the pieces from `first` on that bend in the same way, each continuing with the end curvature of the one
 * before it: the last part of a bend, or a curve, that is cut into parts. */
int route_turn_end(const Route *route, int first);
/* A bend is in one plane: a bend to the side that begins on a slope ends on another one. Finds the first bend of the
 * route that begins with its centre at its start's height and changes the slope by more than `least` (rad), with its
 * slopes at both ends. -1: none. */
int route_grade_lost(const Route *route, double least, double *before, double *after);
/* Level unit vector to the left of the tangent at s (for a vertical tangent: of the heading before it). */
Vec3 route_left(const Route *route, double s);
/* Name of a piece in tables: "straight", "bend", "helix", "clothoid", "parabola", "vertical arc", "curve", "cubic". */
const char *route_piece_word(const RoutePiece *piece);
/* -------------------------------------------------- what building a route needs of its curves, for core/route*.c */

/* Lists of pieces from the data of surveyors and designers: straights with slopes, points with fillets or a spline
 * through them, plan and profile by station. Readers of tables and drawings fill the plain structs below and get a
 * RouteLine for route_build. docs/theory.md, "Routes". */

/* Arguments of route_build. */
typedef struct RouteLine {
    Vec3 start;            /* m */
    double heading, slope; /* rad */
    int n;
    RoutePieceDef *piece; /* [n] malloc'ed: the caller's; NULL after an error */
} RouteLine;

/* Rounds the corners at which straights begin on slopes of their own (RoutePieceDef.sloped): a bend in the vertical
 * plane of this radius (m), tangent to both straights, where the slope changes by more than rounding (RO13). Behind a
 * piece that is not straight the bend begins at that piece's end, and its tangent lengths come off the straight.
 * Errors: INPUT (a straight is too short), MEMORY. */
hawser_status route_round_slopes(int n, const RoutePieceDef *def, double heading, double slope, double radius,
                                 RouteLine *out, hawser_error *err);
/* A point of a polyline, and the radius of its corner; not used for the first and last. */
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
/* A line, arc or clothoid of the plan: curvature changes linearly from one end to the other, 1/m, positive to the
 * left. */
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
    double radius;          /* m; 0: by the parabola, or sharp if there is none; not used for the first and last */
    double parabola;        /* m, half of it on either side; 0: none */
} RouteProfileCorner;

typedef struct RouteProfile {
    double station, height; /* m, its beginning */
    int n;
    RouteProfileElement *element; /* [n] malloc'ed: the caller's; NULL after an error */
} RouteProfile;

/* n >= 2 corners by rising station; `radius` (m) rounds the sharp ones. Errors: INPUT (stations that do not rise,
 * roundings that overlap; corners are named by number from 1 on), MEMORY. */
hawser_status route_profile_from_corners(int n, const RouteProfileCorner *corner, double radius, RouteProfile *out,
                                         hawser_error *err);
/* Plan and profile together, cut at the elements of both (RO12). The plan begins at `station` of the profile at
 * (start.x, start.y), with this heading; the height is the profile's. profile NULL: level at start.z. Errors: INPUT
 * (the profile does not cover the plan, or has corners), MEMORY. */
hawser_status route_from_plan_and_profile(int n, const RoutePlanElement *plan, const RouteProfile *profile,
                                          double station, Vec3 start, double heading, RouteLine *out,
                                          hawser_error *err);

#endif
