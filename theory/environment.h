/* Clearance of cable and rope from the environment. docs/theory/98-environment.md. */
#ifndef HAWSER_THEORY_ENVIRONMENT_H
#define HAWSER_THEORY_ENVIRONMENT_H

#include "contact/triangles.h"
#include "def/limits.h"
#include "def/scene_def.h"

/* The layers that are to be kept clear of, and the least distance of each so far; with `least` only the least of all is
 * sure, and costs less. Zeroed: there are none. */
typedef struct Clearances {
    Mesh mesh;          /* their triangles and layers; vertices and names are the definition's */
    TriangleTree *tree; /* NULL: there are none */
    LayerNear *near;    /* [mesh.n_layers]; NULL without layers */
    double bound;       /* m, farther is not looked for; `least`: it falls with the least distance so far */
    bool least;
} Clearances;

/* The definition must stay. Errors: MEMORY; clearances_free follows either way. */
hawser_status clearances_new(const EnvironmentDef *def, bool least, Clearances *out, hawser_error *err);
void clearances_free(Clearances *c);
/* Takes in a straight piece of cable or rope from a to b (m, world) of that radius, at s0 to s1 along the route, at t
 * (EN4). */
void clearances_add(Clearances *c, Vec3 a, Vec3 b, double radius, double s0, double s1, double t);
/* Fills def->environment.near for a cable of that radius whose line is the route. Errors: MEMORY. */
hawser_status clearances_of_route(SceneDef *def, const Route *route, double radius, hawser_error *err);
/* The limit's finding: the least of all layers. near: [n_layers]; timed: of a run. */
Finding clearances_finding(const EnvironmentDef *def, const LayerNear *near, bool timed);

#endif
