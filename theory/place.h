/* Where equipment stands along a route: marks of a drawing projected onto it, rollers placed by rule, and the load that
 * theory expects on each. docs/model/18-placing.md has the equations. */
#ifndef HAWSER_THEORY_PLACE_H
#define HAWSER_THEORY_PLACE_H

#include "theory/pulling.h"

/* ---------------------------------------------------------------------------------------------------- projection */

/* Points of the route from which a nearest place is looked for. */
typedef struct RouteGrid {
    const Route *route;
    double from, step; /* m along the route */
    int n;
    Vec3 *at; /* [n] */
} RouteGrid;

/* From `beyond` m before the start to `beyond` m past the end, where the route goes on straight. The route must stay.
 * Errors: MEMORY. */
hawser_status route_grid_build(const Route *route, double beyond, RouteGrid *out, hawser_error *err);
void route_grid_clear(RouteGrid *grid);
/* The place of the route that is nearest to a point. */
typedef struct Nearest {
    double s;        /* m along the route */
    double distance; /* m, in plan or in space */
    double aside;    /* m, level, to the left of the route positive */
    double other_s;  /* m: of the next best place away from s ... */
    double other;    /* m ... its distance; infinite: there is none */
} Nearest;

/* (PC1), (PC2). space: heights count; otherwise distances are those in plan. */
Nearest route_nearest(const RouteGrid *grid, Vec3 point, int space);
/* -------------------------------------------------------------------------------------------------------- rules */

/* On which side of the line a roller stands. */
typedef enum PlaceSide { PLACE_BELOW, PLACE_ABOVE, PLACE_LEFT, PLACE_RIGHT, PLACE_SIDES } PlaceSide;

/* By what rollers are placed. */
typedef struct PlaceRule {
    double straights, bends; /* m, the largest spacing there */
    double allowed;          /* N, the largest load that is planned for one; 0: not known */
    double reserve;          /* hold-downs stand where so many times the lift is more than the weight */
    int guides, hold_downs;  /* whether there are any */
} PlaceRule;

/* What is to be carried, and by which tension. */
typedef struct PlaceLine {
    const Route *route;
    const Pull *pull; /* the tension along the route */
    double weight;    /* N/m */
    double from, to;  /* m along the route: where rollers are wanted */
} PlaceLine;

typedef struct PlacedRoller {
    double s;
    PlaceSide side;
} PlacedRoller;

/* Rollers by the rule, (PC4)-(PC8), by rising s within each side: malloc'ed, the caller's even after an error. Errors:
 * INPUT (more than `most`), MEMORY. */
hawser_status place_by_rule(const PlaceLine *line, const PlaceRule *rule, int most, PlacedRoller **out, int *n,
                            hawser_error *err);
/* -------------------------------------------------------------------------------------------------------- loads */

/* Forces that the supports exert on a metre of cable, N/m, by the route's frame (PC3). */
typedef struct LineLoad {
    double up, left; /* what pushes it up, and to the left */
    double size;
} LineLoad;

LineLoad line_load(const PlaceLine *line, double s);
/* A roller that bears. */
typedef struct Support {
    double s; /* m along the route */
    PlaceSide side;
    int item;    /* by which the caller knows it */
    int whole;   /* it bears whatever its side is: no guides share the force */
    double load; /* N, the result */
} Support;

/* Loads of n supports by (PC9): each bears what lies nearer to it than to the others of its kind. They are left in the
 * order of s. */
void support_loads(const PlaceLine *line, int n, Support *support);

#endif
