/* Contact with a mesh: lists of the triangles near each point of the line, and the feet on them.
 * docs/theory/98-environment.md, "Lists". The kernels of contact/surface_lanes.c read the feet as they read patches. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "contact/surface.h"

enum { STAND_ARRAYS = sizeof(SurfaceStand) / sizeof(double *) };

SurfaceNear *surface_near_new(int n)
{
    SurfaceNear *const near = calloc(1, sizeof *near);
    int ok = near && chain_struct_alloc(&near->stand, n);
    for (int k = 0; ok && k < FEET_MAX; ++k) ok = chain_struct_alloc(&near->foot[k], n);
    return ok ? near : surface_near_free(near);
}

SurfaceNear *surface_near_free(SurfaceNear *near)
{
    if (!near) return NULL;
    chain_struct_free(&near->stand);
    for (int k = 0; k < FEET_MAX; ++k) chain_struct_free(&near->foot[k]);
    free(near->list);
    free(near->start);
    free(near->work);
    free(near);
    return NULL;
}

/* Makes room in an array that grows; 0 without memory. */
static int room_for(void **array, int *allocated, int count, size_t each)
{
    if (count <= *allocated) return 1;
    void *const grown = realloc(*array, (size_t)count * each);
    if (!grown) return 0;
    *array = grown;
    *allocated = count;
    return 1;
}

/* Distance of the point from the mesh beyond its radius and the bulge, at most `most`. */
static double free_way(const SurfaceModel *model, Vec3 at, double radius, double most)
{
    double p[3];
    const double close = radius + model->facets->bulge;
    v3_put(p, at);
    return triangle_tree_distance(model->facets->tree, p, p, close + most, NULL, NULL) - close;
}

/* How far nothing is looked for: in a round tunnel everything around the cable is at the same distance, and a tree has
 * to visit all of it to tell which is the least. */
static const double FAR_SKINS = 4;

/* Places of all points, and how far each may move before something is near: one number for all (EN26). */
static void points_stand(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, SurfacePairs *pairs)
{
    SurfaceNear *const near = pairs->near;
    line_stand(kin, chain->n, near->stand.p, near->stand.a);
    near->usable = fmin(model->reach, FAR_SKINS * model->skin);
    for (int e = pairs->from; e < pairs->to; ++e) {
        for (int q = 0; q < SURFACE_POINTS; ++q) {
            const Vec3 at = surface_point(model, chain, kin, e, q);
            v3_store(near->stand.point[q], e, at);
            if (!(near->usable > model->skin)) continue;
            near->usable = fmax(model->skin, free_way(model, at, model->points->radius[q][e], near->usable));
        }
    }
}

/* The lists for these places. 0 without memory. */
static int lists_make(const SurfaceModel *model, SurfacePairs *pairs)
{
    SurfaceNear *const near = pairs->near;
    const int points = SURFACE_POINTS * (pairs->to - pairs->from);
    int longest = 0;
    if (!room_for((void **)&near->start, &near->starts_allocated, points + 1, sizeof *near->start)) return 0;
    near->n = 0;
    for (int k = 0; k < points; ++k) {
        const int e = pairs->from + k / SURFACE_POINTS, q = k % SURFACE_POINTS;
        const double reach = model->points->radius[q][e] + model->facets->bulge + model->skin;
        near->start[k] = near->n;
        if (near->usable > model->skin) continue; /* nothing is near any point */
        if (!triangle_tree_near(model->facets->tree, v3_load(near->stand.point[q], e), reach, &near->list, &near->n,
                                &near->list_allocated))
            return 0;
        longest = near->n - near->start[k] > longest ? near->n - near->start[k] : longest;
    }
    near->start[points] = near->n;
    return room_for((void **)&near->work, &near->work_allocated, longest, sizeof *near->work);
}

/* The lists follow from the places. */
void surface_near_checkpoint(Checkpoint *c, const SurfaceModel *model, SurfacePairs *pairs, int n)
{
    int present = pairs->near != NULL;
    CHECKPOINT(c, present);
    checkpoint_check(c, !present || model->facets, "there is an environment in it, and none in the case");
    if (!present || c->status) return;
    if (!pairs->near) pairs->near = surface_near_new(n);
    SurfaceNear *const near = pairs->near;
    if (!near) {
        checkpoint_lack(c);
        return;
    }
    CHECKPOINT(c, near->usable);
    chain_struct_checkpoint(c, "near->stand", &near->stand, n);
    if (c->reading && !c->status && !lists_make(model, pairs)) checkpoint_lack(c);
}

/* Whether a list of element e has a triangle of this law. */
static int lists_have(const SurfaceModel *model, const SurfacePairs *pairs, int e, int law)
{
    const SurfaceNear *const near = pairs->near;
    const Facets *const facets = model->facets;
    const int k = SURFACE_POINTS * (e - pairs->from);
    for (int i = near->start[k]; i < near->start[k + SURFACE_POINTS]; ++i) {
        if (facets->law[facets->mesh.layer[near->list[i].triangle]] == law) return 1;
    }
    return 0;
}

int surface_near_refresh(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, SurfacePairs *pairs)
{
    if (!pairs->near) pairs->near = surface_near_new(chain->n);
    SurfaceNear *const near = pairs->near;
    if (!near) return 0;
    points_stand(model, chain, kin, pairs);
    if (!lists_make(model, pairs)) return 0;
    for (int k = 0; k < FEET_MAX; ++k) {
        for (int q = 0; q < SURFACE_POINTS; ++q) chain_array_fill(near->foot[k].distance[q], chain->n, INFINITY);
    }
    const int first = model->n_patches - SURFACE_FACES_MAX * model->n_laws;
    for (int patch = first; patch < model->n_patches && near->n > 0; ++patch) {
        const int law = model->patch[patch].law;
        for (int e = pairs->from; e < pairs->to; ++e) {
            if (lists_have(model, pairs, e, law) && !surface_candidate_add(pairs, patch, e)) return 0;
        }
    }
    return 1;
}

int surface_near_stale(const Chain *chain, const Kinematics *kin, const SurfacePairs *pairs)
{
    const SurfaceNear *const near = pairs->near;
    return near && line_moved(chain, kin, near->stand.p, near->stand.a, CONTACT_USABLE * near->usable);
}

static void foot_put(SurfaceFoot *to, int q, int e, const Foot *foot)
{
    to->distance[q][e] = foot->distance;
    to->law[q][e] = foot->law;
    v3_store(to->normal[q], e, foot->normal);
    v3_store(to->gradient[q], e, foot->gradient);
    for (int c = 0; c < 9; ++c) to->turn[q][c][e] = foot->turn.m[c];
}

void surface_feet(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, const SurfacePairs *pairs,
                  int from, int to, double beyond)
{
    SurfaceNear *const near = pairs->near;
    if (!near || near->n == 0) return;
    const int first = from > pairs->from ? from : pairs->from, end = to < pairs->to ? to : pairs->to;
    for (int e = first; e < end; ++e) {
        for (int q = 0; q < SURFACE_POINTS; ++q) {
            const int k = SURFACE_POINTS * (e - pairs->from) + q, count = near->start[k + 1] - near->start[k];
            if (count == 0) continue;
            const Vec3 p = surface_point(model, chain, kin, e, q);
            const double moved = v3_norm(v3_sub(p, v3_load(near->stand.point[q], e)));
            Foot foot[FEET_MAX];
            const int n = facets_feet(model->facets, near->list + near->start[k], count, moved, p,
                                      model->points->radius[q][e] + beyond, near->work, foot);
            for (int i = 0; i < FEET_MAX; ++i) {
                near->foot[i].distance[q][e] = INFINITY;
                if (i < n) foot_put(&near->foot[i], q, e, &foot[i]);
            }
        }
    }
}
