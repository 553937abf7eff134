/* The ducts, trays, floors and walls of a scene. */
#ifndef HAWSER_SIM_EQUIPMENT_SURFACES_H
#define HAWSER_SIM_EQUIPMENT_SURFACES_H

#include "contact/surface/surface.h"
#include "sim/def/scene_def.h"

/* What a scene's surface model borrows. All zeros if there is no surface. */
typedef struct Surfaces {
    SurfaceModel model;
    SurfacePatch *patch;
    FrictionLaw *friction; /* [surfaces] */
    SurfacePoints points;
} Surfaces;

/* Builds them along the route for the chain, which must have its lengths and radii. Errors: MEMORY. */
hawser_status surfaces_fill(Surfaces *s, const SceneDef *def, const Route *route, const Chain *chain,
                            hawser_error *err);
void surfaces_clear(Surfaces *s);

/* Whether a surface runs along the route, and its friction as theory sees it: a V grips by its two sides. */
int surface_along_route(const SurfaceDef *surface);
double surface_theory_friction(const SurfaceDef *surface);

#endif
