#include "sim/picture/closeup.h"

#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"

static void vector_copy(double to[3], const double *from) { memcpy(to, from, 3 * sizeof *to); }

static void rollers_show(Around *a)
{
    const Geometry *const g = &a->from;
    for (int r = 0; r < g->n_rollers; ++r) {
        a->roller[r] = (hawser_roller_shape){.name = g->roller_name[r],
                                             .kind = g->roller_kind[r],
                                             .along_m = g->roller_s[r],
                                             .radius_m = g->roller_radius[r],
                                             .width_m = g->roller_width[r]};
        vector_copy(a->roller[r].centre_m, g->roller_position + 3 * r);
        vector_copy(a->roller[r].axis, g->roller_axis + 3 * r);
    }
}

static void others_show(Around *a)
{
    const Geometry *const g = &a->from;
    for (int i = 0; i < g->n_surfaces; ++i) {
        const GeometrySurface *const s = &g->surface[i];
        a->surface[i] = (hawser_surface_shape){.name = s->name,
                                               .kind = s->kind,
                                               .from_m = s->from,
                                               .to_m = s->to,
                                               .diameter_m = s->diameter,
                                               .width_m = s->width,
                                               .height_m = s->height,
                                               .n = s->n,
                                               .points_m = s->points,
                                               .up = s->up};
    }
    for (int i = 0; i < g->n_conveyors; ++i) {
        a->conveyor[i] = (hawser_conveyor_shape){
            .name = g->conveyor_name[i], .from_m = g->conveyor_from[i], .to_m = g->conveyor_to[i]};
        vector_copy(a->conveyor[i].in_m, g->conveyor_points + 6 * i);
        vector_copy(a->conveyor[i].out_m, g->conveyor_points + 6 * i + 3);
    }
}

static void ends_show(Around *a)
{
    const Geometry *const g = &a->from;
    hawser_geometry *const out = &a->shown;
    out->has_winch = g->winch.present;
    out->has_reel = g->reel.present;
    vector_copy(out->winch_m, g->winch.position);
    vector_copy(out->winch_direction, g->winch.direction);
    vector_copy(out->reel_m, g->reel.centre);
    vector_copy(out->reel_axis, g->reel.axis);
    out->reel_barrel_m = g->reel.barrel;
    out->reel_flange_m = g->reel.flange;
    out->reel_width_m = g->reel.width;
}

Around *around_new(const Scene *scene, hawser_error *err)
{
    Around *a = calloc(1, sizeof *a);
    if (!a || geometry_make(scene, &a->from, err)) {
        free(a);
        error_memory(err);
        return NULL;
    }
    const Geometry *const g = &a->from;
    a->roller = calloc((size_t)g->n_rollers + 1, sizeof *a->roller);
    a->surface = calloc((size_t)g->n_surfaces + 1, sizeof *a->surface);
    a->conveyor = calloc((size_t)g->n_conveyors + 1, sizeof *a->conveyor);
    if (!a->roller || !a->surface || !a->conveyor) {
        error_memory(err);
        return around_free(a);
    }
    rollers_show(a);
    others_show(a);
    a->shown = (hawser_geometry){.rollers = g->n_rollers,
                                 .surfaces = g->n_surfaces,
                                 .conveyors = g->n_conveyors,
                                 .segments = g->n_segments,
                                 .roller = a->roller,
                                 .surface = a->surface,
                                 .conveyor = a->conveyor,
                                 .length_m = g->length,
                                 .diameter_m = g->diameter};
    ends_show(a);
    return a;
}

Around *around_free(Around *a)
{
    if (!a) return NULL;
    geometry_free(&a->from);
    free(a->roller);
    free(a->surface);
    free(a->conveyor);
    free(a);
    return NULL;
}
