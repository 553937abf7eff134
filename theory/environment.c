#include "theory/environment.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "theory/setup.h"

hawser_status clearances_new(const EnvironmentDef *def, bool least, Clearances *out, hawser_error *err)
{
    const Mesh *const all = &def->mesh;
    int n = 0;
    *out = (Clearances){.mesh = *all, .bound = ENVIRONMENT_REACH, .least = least};
    out->mesh.triangle = NULL;
    out->mesh.layer = NULL;
    out->mesh.n_triangles = 0;
    if (all->n_layers == 0) return HAWSER_OK;
    for (int t = 0; t < all->n_triangles; ++t) n += def->clear[all->layer[t]];
    out->mesh.triangle = malloc(((size_t)n + 1) * sizeof *out->mesh.triangle);
    out->mesh.layer = malloc(((size_t)n + 1) * sizeof *out->mesh.layer);
    out->near = malloc((size_t)all->n_layers * sizeof *out->near);
    if (!out->mesh.triangle || !out->mesh.layer || !out->near) return error_memory(err);
    for (int k = 0; k < all->n_layers; ++k) out->near[k] = (LayerNear){INFINITY, NAN, NAN};
    for (int t = 0; t < all->n_triangles; ++t) {
        if (!def->clear[all->layer[t]]) continue;
        memcpy(out->mesh.triangle[out->mesh.n_triangles], all->triangle[t], sizeof *all->triangle);
        out->mesh.layer[out->mesh.n_triangles++] = all->layer[t];
    }
    if (n == 0) return HAWSER_OK;
    out->tree = triangle_tree_new(&out->mesh);
    return out->tree ? HAWSER_OK : error_memory(err);
}

void clearances_free(Clearances *c)
{
    triangle_tree_free(c->tree);
    free(c->mesh.triangle);
    free(c->mesh.layer);
    free(c->near);
    *c = (Clearances){0};
}

/* (EN4) */
void clearances_add(Clearances *c, Vec3 a, Vec3 b, double radius, double s0, double s1, double t)
{
    const double from[3] = {a.x, a.y, a.z}, to[3] = {b.x, b.y, b.z};
    double foot[3];
    int triangle = -1;
    const double d = triangle_tree_distance(c->tree, from, to, c->bound + radius, &triangle, foot) - radius;
    if (triangle < 0) return;
    LayerNear *const near = &c->near[c->mesh.layer[triangle]];
    if (!(d < near->distance)) return;
    if (c->least) c->bound = d;
    const Vec3 along = v3_sub(b, a), arm = v3_sub(v3(foot[0], foot[1], foot[2]), a);
    const double length2 = v3_dot(along, along), share = length2 > 0 ? v3_dot(arm, along) / length2 : 0;
    *near = (LayerNear){d, s0 + fmin(fmax(share, 0), 1) * (s1 - s0), t};
}

/* Longest piece of a line of that curvature whose chord is within 0.1 mm of it, and which finds its own nearest layer,
 * m. */
static double chord_of(double curvature)
{
    static const double OFF = 1e-4, LONGEST = 0.5;
    return fmin(LONGEST, sqrt(8 * OFF / fmax(curvature, 1e-9)));
}

hawser_status clearances_of_route(SceneDef *def, const Route *route, double radius, hawser_error *err)
{
    Clearances c;
    hawser_status status = clearances_new(&def->environment, false, &c, err);
    for (int p = 0; c.tree && p < route->n; ++p) {
        const RoutePiece *const piece = &route->piece[p];
        const double bent = piece->kind == ROUTE_STRAIGHT ? 0 : 1 / piece->radius;
        const int n = 1 + (int)(piece->length / chord_of(bent));
        for (int k = 0; k < n; ++k) {
            const double s0 = piece->s0 + k * piece->length / n, s1 = piece->s0 + (k + 1) * piece->length / n;
            clearances_add(&c, setup_line_at(def, route, s0), setup_line_at(def, route, s1), radius, s0, s1, NAN);
        }
    }
    free(def->environment.near);
    def->environment.near = c.near;
    c.near = NULL;
    clearances_free(&c);
    return status;
}

Finding clearances_finding(const EnvironmentDef *def, const LayerNear *near, bool timed)
{
    Finding f = {.absent = 1};
    int least = -1;
    for (int k = 0; near && k < def->mesh.n_layers; ++k)
        if (def->clear[k] && (least < 0 || near[k].distance < near[least].distance)) least = k;
    if (least < 0) return f;
    const LayerNear *const at = &near[least];
    f = (Finding){.value = at->distance};
    if (isinf(at->distance)) {
        f.value = ENVIRONMENT_REACH;
        snprintf(f.where, sizeof f.where, "everywhere, and more");
    } else if (timed) {
        snprintf(f.where, sizeof f.where, "'%.40s', %.4g m, at %.4g s", def->mesh.layer_name[least], at->s, at->t);
    } else {
        snprintf(f.where, sizeof f.where, "'%.40s', %.4g m", def->mesh.layer_name[least], at->s);
    }
    return f;
}
