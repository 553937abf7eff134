/* Clearance of cable and rope from the environment. docs/theory/98-environment.md. */
#ifndef HAWSER_THEORY_ENVIRONMENT_H
#define HAWSER_THEORY_ENVIRONMENT_H

#include "def/limits.h"
#include "theory/setup.h"

/* m: clearances beyond it are not looked for. */
#define ENVIRONMENT_REACH 5.0

/* Where cable or rope are nearest to a layer. */
typedef struct LayerNear {
    double distance; /* m, between the surfaces, below 0 where they overlap; INFINITY: farther than ENVIRONMENT_REACH */
    double s;        /* m along the route */
    double t;        /* s, of a run */
} LayerNear;

/* Least distances so far from the layers that are to be kept clear of; with `least` only the least of all is sure, and
 * costs less. Zeroed: there are no such layers. */
typedef struct Clearances {
    const EnvironmentDef *of; /* borrowed */
    LayerNear *near;          /* [layers]; NULL: there are none */
    double bound;             /* m, farther is not looked for: the largest of them so far, or with `least` the least */
    bool least;
} Clearances;

/* The definition must stay. Errors: MEMORY; clearances_free follows either way. */
hawser_status clearances_new(const EnvironmentDef *def, bool least, Clearances *out, hawser_error *err);
void clearances_free(Clearances *c);
/* Takes in a straight piece of cable or rope from a to b (m, world) of that radius, at s0 to s1 along the route, at t
 * (EN4). */
void clearances_add(Clearances *c, Vec3 a, Vec3 b, double radius, double s0, double s1, double t);
/* Finds the next unsupported span at or beyond s, m along the route; 0: there is none. */
int supports_span(const Supports *map, double s, double *from, double *to);
/* Sag of a span half way, m (T29); 0: a floor carries the cable, or it sags by more than theory accepts. */
double span_hangs(const Setup *setup, const Route *route, const Pull *pull, double from, double to);
/* Clearances of a cable on its route, and hanging in its spans with the least tension of a direction (EN5). *near:
 * [layers], the caller's; NULL: there are none. Errors: as plan_pull, MEMORY. */
hawser_status clearances_of_way(const Setup *setup, const PlanDef *plan, int way, LayerNear **near, hawser_error *err);
/* The limit's finding: the least of all layers. near: [n_layers]; timed: of a run. */
Finding clearances_finding(const EnvironmentDef *def, const LayerNear *near, bool timed);

#endif
