/* The environment of a case: models of the tunnel and of what stands in it. Part of SceneDef (def/scene_def.h). */
#ifndef HAWSER_DEF_ENVIRONMENT_DEF_H
#define HAWSER_DEF_ENVIRONMENT_DEF_H

#include <stdatomic.h>
#include <stdbool.h>

#include "contact/triangles.h"
#include "core/error.h"

typedef struct EnvironmentDef {
    Mesh mesh;        /* all models of the case, placed and in m; no triangles: there is none */
    double *friction; /* [mesh.n_layers], mu of each layer; NAN: the cable does not touch it */
    bool *clear;      /* [mesh.n_layers]: the cable is to keep clear of it */
    bool touched;     /* the cable can touch some layer */
    /* since environment_share: nothing changes any more */
    Mesh *kept;         /* triangles and layers of what is to be kept clear of; vertices and names are the mesh's */
    TriangleTree *tree; /* of `kept`; NULL: there are none */
    atomic_int *users;  /* number of definitions that have these arrays */
} EnvironmentDef;

/* Prepares the filled-in environment for sharing; one without layers stays as it is. Errors: MEMORY. */
hawser_status environment_share(EnvironmentDef *e, hawser_error *err);
/* A copy that has the same arrays; `e` must be shared, or have no layers. */
EnvironmentDef environment_copy(const EnvironmentDef *e);
/* Frees the arrays if no other definition has them, and empties it. */
void environment_clear(EnvironmentDef *e);

#endif
