#include "theory/environment.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/error.h"
#include "def/bundle_def.h"

hawser_status clearances_new(const EnvironmentDef *def, bool least, Clearances *out, hawser_error *err)
{
    *out = (Clearances){.of = def, .bound = ENVIRONMENT_REACH, .least = least};
    if (!def->tree) return HAWSER_OK;
    out->near = malloc((size_t)def->mesh.n_layers * sizeof *out->near);
    if (!out->near) return error_memory(err);
    for (int k = 0; k < def->mesh.n_layers; ++k) out->near[k] = (LayerNear){INFINITY, NAN, NAN};
    return HAWSER_OK;
}

void clearances_free(Clearances *c)
{
    free(c->near);
    *c = (Clearances){0};
}

/* Nothing that is farther lowers any distance, m. */
static double farthest_of(const Clearances *c)
{
    double most = -INFINITY;
    for (int k = 0; k < c->of->mesh.n_layers; ++k)
        if (c->of->clear[k]) most = fmax(most, c->near[k].distance);
    return most;
}

/* (EN4) */
void clearances_add(Clearances *c, Vec3 a, Vec3 b, double radius, double s0, double s1, double t)
{
    const double from[3] = {a.x, a.y, a.z}, to[3] = {b.x, b.y, b.z};
    double foot[3];
    int triangle = -1;
    const double d = triangle_tree_distance(c->of->tree, from, to, c->bound + radius, &triangle, foot) - radius;
    if (triangle < 0) return;
    LayerNear *const near = &c->near[c->of->kept->layer[triangle]];
    if (!(d < near->distance)) return;
    const Vec3 along = v3_sub(b, a), arm = v3_sub(v3(foot[0], foot[1], foot[2]), a);
    const double length2 = v3_dot(along, along), share = length2 > 0 ? v3_dot(arm, along) / length2 : 0;
    *near = (LayerNear){d, s0 + fmin(fmax(share, 0), 1) * (s1 - s0), t};
    c->bound = c->least ? d : fmin(ENVIRONMENT_REACH, farthest_of(c));
}

/* Longest piece of a line of that curvature whose chord is within 0.1 mm of it, and which finds its own nearest layer,
 * m. */
static double chord_of(double curvature)
{
    static const double OFF = 1e-4, LONGEST = 0.5;
    return fmin(LONGEST, sqrt(8 * OFF / fmax(curvature, 1e-9)));
}

/* The cable's line from s0 to s1, sagging between a and b by `sag` half way, in n straight parts. */
static void line_add(Clearances *c, const Setup *setup, double s0, double s1, int n, double sag, double radius)
{
    Vec3 last = V3_ZERO;
    for (int k = 0; k <= n; ++k) {
        const double x = (double)k / n, s = s0 + x * (s1 - s0);
        const Vec3 here = v3_axpy(setup_line_at(setup->def, setup->route, s), -4 * x * (1 - x) * sag, v3(0, 0, 1));
        if (k > 0) clearances_add(c, last, here, radius, s - (s1 - s0) / n, s, NAN);
        last = here;
    }
}

/* The curvature of the route's piece at s, 1/m. */
static double bent_at(const Route *route, double s) { return v3_norm(route_at(route, s).curvature); }

/* (EN5) */
static void spans_add(Clearances *c, const Setup *setup, const Pull *pull, double radius)
{
    double from, to;
    for (double s = 0; supports_span(&setup->supports, s, &from, &to); s = to) {
        const double sag = span_hangs(setup, setup->route, pull, from, to), length = to - from;
        if (!(sag > 0)) continue;
        const double bent = fmax(bent_at(setup->route, from), bent_at(setup->route, to));
        line_add(c, setup, from, to, 2 + (int)(length / chord_of(bent + 8 * sag / (length * length))), sag, radius);
    }
}

/* Whatever supports the cable holds it on the route. */
static void route_add(Clearances *c, const Setup *setup, double radius)
{
    for (int p = 0; p < setup->route->n; ++p) {
        const RoutePiece *const piece = &setup->route->piece[p];
        const double bent = piece->kind == ROUTE_STRAIGHT ? 0 : 1 / piece->radius;
        line_add(c, setup, piece->s0, piece->s0 + piece->length, 1 + (int)(piece->length / chord_of(bent)), 0, radius);
    }
}

hawser_status clearances_of_way(const Setup *setup, const PlanDef *plan, int way, LayerNear **near, hawser_error *err)
{
    const PlanPullDef whole = {.way = way, .whole = 1};
    const PlanDef slack = plan_slack(plan);
    const double radius = bundle_diameter(setup->def) / 2;
    Clearances c;
    Pull pull;
    hawser_status status = clearances_new(&setup->def->environment, false, &c, err);
    if (!status && c.near && setup->def->theory.simulated) { /* first, so that it bounds the search for the rest */
        status = plan_pull(&slack, &whole, &pull, err);
        if (!status) spans_add(&c, setup, &pull, radius);
        if (!status) pull_clear(&pull);
    }
    if (!status && c.near) route_add(&c, setup, radius);
    *near = c.near;
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
