#include "sim/equipment/surfaces.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"

hawser_status surfaces_fill(Surfaces *s, const SceneDef *def, const Route *route, const Chain *chain, hawser_error *err)
{
    memset(s, 0, sizeof *s);
    if (def->n_surfaces == 0) return HAWSER_OK;
    int patches = 0;
    for (int i = 0; i < def->n_surfaces; ++i) patches += surface_patch_count(&def->surfaces[i].shape, route);
    s->patch = calloc((size_t)patches + 1, sizeof *s->patch);
    s->friction = calloc((size_t)def->n_surfaces, sizeof *s->friction);
    if (!s->patch || !s->friction || !surface_points_alloc(&s->points, def->geometry, chain)) {
        surfaces_clear(s);
        return error_memory(err);
    }
    SurfacePatch *next = s->patch;
    for (int i = 0; i < def->n_surfaces; ++i) {
        surface_patches(&def->surfaces[i].shape, route, i, next);
        next += surface_patch_count(&def->surfaces[i].shape, route);
        s->friction[i] = def->surfaces[i].friction;
    }
    s->model = (SurfaceModel){.impact = def->line_impact,
                              .reach = def->contact_reach,
                              .n_surfaces = def->n_surfaces,
                              .n_patches = patches,
                              .friction = s->friction,
                              .patch = s->patch,
                              .points = &s->points};
    return HAWSER_OK;
}

void surfaces_clear(Surfaces *s)
{
    free(s->patch);
    free(s->friction);
    surface_points_free(&s->points);
    memset(s, 0, sizeof *s);
}

int surface_along_route(const SurfaceDef *surface) { return surface->shape.kind != SURFACE_PLANE; }

/* (DU15). */
double surface_theory_friction(const SurfaceDef *surface)
{
    const double mu = surface->friction.mu_d;
    return surface->shape.kind == SURFACE_V ? mu / sin(surface->shape.angle / 2) : mu;
}
