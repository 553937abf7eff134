/* The environment of a case: models of the tunnel and of what stands in it. Part of SceneDef (def/scene_def.h). */
#ifndef HAWSER_DEF_ENVIRONMENT_DEF_H
#define HAWSER_DEF_ENVIRONMENT_DEF_H

#include <stdbool.h>

#include "core/mesh.h"

typedef struct EnvironmentDef {
    Mesh mesh;        /* all models of the case, placed and in m; no triangles: there is none */
    double *friction; /* [mesh.n_layers], mu of each layer; NAN: the cable does not touch it */
    bool touched;     /* the cable can touch some layer */
    double clearance; /* m, required; 0: not judged */
} EnvironmentDef;

#endif
