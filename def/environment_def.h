/* The environment of a case: models of the tunnel and of what stands in it. Part of SceneDef (def/scene_def.h). */
#ifndef HAWSER_DEF_ENVIRONMENT_DEF_H
#define HAWSER_DEF_ENVIRONMENT_DEF_H

#include <stdbool.h>

#include "core/mesh.h"

/* Where cable or rope are nearest to a layer. */
typedef struct LayerNear {
    double distance; /* m, between the surfaces, below 0 where they overlap; INFINITY: farther than ENVIRONMENT_REACH */
    double s;        /* m along the route */
    double t;        /* s, of a run */
} LayerNear;

/* m: clearances beyond it are not looked for. */
#define ENVIRONMENT_REACH 5.0

typedef struct EnvironmentDef {
    Mesh mesh;        /* all models of the case, placed and in m; no triangles: there is none */
    double *friction; /* [mesh.n_layers], mu of each layer; NAN: the cable does not touch it */
    bool *clear;      /* [mesh.n_layers]: the cable is to keep clear of it */
    LayerNear *near;  /* [mesh.n_layers] (EN4), of a cable that lies on the route */
    bool touched;     /* the cable can touch some layer */
} EnvironmentDef;

#endif
