/* Places of equipment along a route: marks of a drawing projected onto it, rollers placed by rule, and the load that
 * theory expects on each. docs/theory/18-placing.md has the equations. */
#ifndef HAWSER_THEORY_PLACE_H
#define HAWSER_THEORY_PLACE_H

#include "theory/pulling.h"

/* ---------------------------------------------------------------------------------------------------- projection */

/* Points of the route at which the search for a nearest place begins. */
typedef struct RouteGrid {
    const Route *route;
    double from, step; /* m along the route */
    int n;
    Vec3 *at; /* [n] */
} RouteGrid;

/* Builds the grid from `beyond` m before the start to `beyond` m past the end, where the route continues straight. The
 * route must stay. Errors: MEMORY. */
hawser_status route_grid_build(const Route *route, double beyond, RouteGrid *out, hawser_error *err);
void route_grid_clear(RouteGrid *grid);
/* The place of the route that is nearest to a point. */
typedef struct Nearest {
    double s;        /* m along the route */
    double distance; /* m, in plan or in space */
    double aside;    /* m, level, to the left of the route positive */
    double other_s;  /* m: the second nearest place away from s ... */
    double other;    /* m ... its distance; infinite: there is none */
} Nearest;

/* Finds the nearest place (PC1), (PC2). space: heights count; otherwise distances are in plan. */
Nearest route_nearest(const RouteGrid *grid, Vec3 point, int space);
/* -------------------------------------------------------------------------------------------------------- rules */

/* Side of the line on which a roller stands. */
typedef enum PlaceSide { PLACE_BELOW, PLACE_ABOVE, PLACE_LEFT, PLACE_RIGHT, PLACE_SIDES } PlaceSide;

/* Rule for placing rollers. */
typedef struct PlaceRule {
    double straights, bends; /* m, the largest spacing there */
    double allowed;          /* N, largest planned load of one; 0: unknown */
    double reserve;          /* hold-downs stand where the lift times this factor exceeds the weight */
    int guides, hold_downs;  /* whether to place them */
} PlaceRule;

/* The line to be supported, with its tension. */
typedef struct PlaceLine {
    const Route *route;
    const Pull *pull; /* the tension along the route */
    double weight;    /* N/m */
    double from, to;  /* m along the route: range in which rollers are placed */
} PlaceLine;

typedef struct PlacedRoller {
    double s;
    PlaceSide side;
} PlacedRoller;

/* Places rollers by the rule, (PC4)-(PC8), by rising s within each side. The caller frees the array, even after an
 * error. Errors: INPUT (more than `most`), MEMORY. */
hawser_status place_by_rule(const PlaceLine *line, const PlaceRule *rule, int most, PlacedRoller **out, int *n,
                            hawser_error *err);
/* -------------------------------------------------------------------------------------------------------- loads */

/* Forces of the supports per metre of cable, N/m, in the route's frame (PC3). */
typedef struct LineLoad {
    double up, left; /* upward and to the left */
    double size;
} LineLoad;

LineLoad line_load(const PlaceLine *line, double s);
/* A roller under load. */
typedef struct Support {
    double s; /* m along the route */
    PlaceSide side;
    int item;    /* the caller's index */
    int whole;   /* it bears the load of all sides: there are no guides */
    double load; /* N, the result */
} Support;

/* Computes the loads of n supports by (PC9): each bears the part nearer to it than to others of its kind. Sorts them by
 * s. */
void support_loads(const PlaceLine *line, int n, Support *support);

#endif
