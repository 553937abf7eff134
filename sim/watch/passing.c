#include "sim/watch/passing.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "sim/equipment/rod.h"
#include "sim/watch/stats.h"

enum { LOOKS = 16 };                 /* at the cable in a run, besides its start */
static const double ALONG = 0.1;     /* of sin^2 between line and axis: below it the line runs along the roller */
static const double STRAY_ALONG = 1; /* m that a segment may be from its place on the way and still be in that duct */
static const double SHARE = 0.5;     /* of a surface's weight (DU8): where it is more there than not */

hawser_status passing_new(Passing *p, const Scene *scene, hawser_error *err)
{
    const size_t rollers = (size_t)scene->contact.n_rollers, surfaces = (size_t)scene->surfaces.model.n_surfaces;
    p->side = calloc(rollers + 1, sizeof *p->side);
    p->gone = calloc(rollers + surfaces + 1, sizeof *p->gone);
    p->seen = calloc(surfaces * SURFACE_FACES_MAX * (size_t)scene->total + 1, sizeof *p->seen);
    return p->side && p->gone && p->seen ? HAWSER_OK : error_memory(err);
}

void passing_free(Passing *p)
{
    free(p->side);
    free(p->gone);
    free(p->seen);
    memset(p, 0, sizeof *p);
}

/* ------------------------------------------------------------------------------------------------- rollers */

/* The segment whose centre is nearest to a place. Centres are not farther apart than segments are long, so that what
 * cannot be nearer is passed over. */
static int nearest_segment(const Chain *chain, const Kinematics *kin, double longest, Vec3 place)
{
    int nearest = 0;
    double least = INFINITY;
    for (int i = 0; i < chain->n;) {
        const double away = v3_norm(v3_sub(v3_load(kin->p, i), place));
        if (away < least) {
            least = away;
            nearest = i;
        }
        const double skip = (away - least) / longest;
        i += skip > 1 && skip < chain->n ? (int)skip : 1;
    }
    return nearest;
}

/* Where a segment passes a roller's axis: how far from it, on which side, seen from the tail. */
typedef struct Crossing {
    double away; /* m; INFINITY: it does not */
    int side;
} Crossing;

static Crossing segment_crossing(const Chain *chain, const Kinematics *kin, int i, const Shape *roller)
{
    const Crossing none = {INFINITY, 0};
    if (i < 0 || i >= chain->n) return none;
    const Vec3 from = v3_sub(v3_load(kin->p, i), roller->centre), a = v3_load(kin->a, i);
    const Vec3 flat = v3_reject(from, roller->axis), run = v3_reject(a, roller->axis);
    const double square = v3_dot(run, run);
    if (square < ALONG) return none;
    const double u = -v3_dot(flat, run) / square;
    if (!(fabs(u) <= chain->half[i])) return none;
    const double across = v3_dot(v3_axpy(from, u, a), roller->axis);
    if (fabs(across) > roller->half_width) return none;
    const Vec3 at = v3_axpy(flat, u, run);
    return (Crossing){v3_norm(at), v3_dot(at, v3_cross(roller->axis, run)) < 0 ? -1 : 1};
}

/* The nearest of the crossings of a segment and its neighbours. */
static Crossing roller_crossing(const Chain *chain, const Kinematics *kin, double longest, const Shape *roller)
{
    const int i = nearest_segment(chain, kin, longest, roller->centre);
    Crossing nearest = {INFINITY, 0};
    for (int k = i - 1; k <= i + 1; ++k) {
        const Crossing here = segment_crossing(chain, kin, k, roller);
        if (here.away < nearest.away) nearest = here;
    }
    return nearest;
}

static int note(Passing *p, int body, const char *what, const char *name, double t)
{
    if (p->gone[body]) return 0;
    p->gone[body] = 1;
    if (++p->through > 1) return 0;
    snprintf(p->says, sizeof p->says, "the cable has got through %s '%s'%s", what, name, t > 0 ? "" : " before t = 0");
    return 1;
}

/* A roller keeps the side on which the cable was near it, within its own thickness and the cable's. */
static int rollers_look(Passing *p, const Scene *scene, const Workspace *ws, double t)
{
    const Chain *const chain = &scene->chain;
    double longest = 0, radius = 0;
    int new = 0;
    for (int i = 0; i < chain->n; ++i) {
        longest = fmax(longest, 2 * chain->half[i]);
        radius = fmax(radius, chain->radius[i]);
    }
    for (int part = 0; part < PARTS; ++part) {
        const ContactPart *const half = &ws->contact[part];
        for (int k = 0; k < half->model.n_rollers; ++k) {
            const Shape *const shape = &half->model.roller[k].shape;
            if (shape->kind == SHAPE_BOX || shape->kind == SHAPE_BELL) continue; /* no axis to be on a side of */
            const int r = half->first + k;
            const Crossing now = roller_crossing(chain, &ws->kin, longest, shape);
            if (p->side[r] && now.side && now.side != p->side[r]) {
                new |= note(p, r, "roller", scene->def.rollers[r].name, t);
            } else if (now.away < 2 * (shape->radius + radius)) {
                p->side[r] = (signed char)now.side;
            }
        }
    }
    return new;
}

/* ------------------------------------------------------------------------------------------------- surfaces */

/* Whether segment i has its place, by its way along the route, where the patch lies: another part of the way may pass
 * beside it. Planes lie anywhere. */
static int patch_is_its(const Scene *scene, const Kinematics *kin, double travel, const SurfacePatch *patch, int i)
{
    if (isnan(patch->s0) || scene->rod->present) return 1;
    const double s = along_joint(scene, kin, travel, i);
    return s > patch->s0 - STRAY_ALONG && s < patch->s0 + patch->length + STRAY_ALONG;
}

/* One segment's centre against one patch: behind its face by more than the cable's radius, where it was before it. */
static int patch_look(Passing *p, const Scene *scene, const Workspace *ws, double travel, const SurfacePatch *patch,
                      int i, double t)
{
    const SurfaceProbe at = surface_probe(patch, v3_load(ws->kin.p, i));
    if (!at.owned || at.share < SHARE) return 0;
    const int face = SURFACE_FACES_MAX * patch->surface + patch->face;
    char *const seen = &p->seen[(size_t)face * (size_t)scene->total + (size_t)(scene->first + i)];
    if (at.distance > 0) *seen = 1;
    if (!(at.distance < -scene->chain.radius[i]) || !(*seen || isinf(patch->depth))) return 0;
    if (!patch_is_its(scene, &ws->kin, travel, patch, i)) return 0;
    return note(p, scene->contact.n_rollers + patch->surface, "surface", scene->def.surfaces[patch->surface].name, t);
}

static int surfaces_look(Passing *p, const Scene *scene, const Workspace *ws, double travel, double t)
{
    int new = 0;
    for (int part = 0; part < PARTS; ++part) {
        const SurfacePairs *const pairs = &ws->contact[part].surface;
        for (int k = 0; k < pairs->n_ranges; ++k) {
            const SurfaceRange *const range = &pairs->range[k];
            const int end = range->first + range->count;
            for (int i = range->first; i < end && i < scene->chain.n; ++i) {
                new |= patch_look(p, scene, ws, travel, &scene->surfaces.patch[range->patch], i, t);
            }
        }
    }
    return new;
}

/* ----------------------------------------------------------------------------------------------------------- */

int passing_look(Passing *p, const Scene *scene, const Workspace *ws, double travel, double t)
{
    const int rollers = rollers_look(p, scene, ws, t);
    return rollers | surfaces_look(p, scene, ws, travel, t);
}

int passing_record(Passing *p, const Scene *scene, const Workspace *ws, double travel, double t)
{
    if (t < p->due && t < scene->def.duration) return 0;
    p->due = t + scene->def.duration / LOOKS;
    return passing_look(p, scene, ws, travel, t);
}
