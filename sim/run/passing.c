#include "sim/run/passing.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "sim/equipment/rod.h"
#include "sim/equipment/winch.h"
#include "sim/run/stats.h"

enum { LOOKS = 16 };                 /* checks of the cable in a run, besides its start */
static const double ALONG = 0.1;     /* sin^2 between line and axis: below it the line runs along the roller */
static const double STRAY_ALONG = 1; /* m, largest distance of a segment from its place along the route for it still to
                                      * be in that duct */
static const double SHARE = 0.5;     /* of a surface's weight (DU8): above it the segment counts as at the surface */

void passing_free(Passing *p)
{
    free(p->side);
    free(p->gone);
    free(p->seen);
    free(p->last);
    memset(p, 0, sizeof *p);
}

/* ------------------------------------------------------------------------------------------------- rollers */

/* Segment whose centre is nearest to a place. Neighbouring centres are no farther apart than a segment's length, so
 * that segments that cannot be nearer are skipped. */
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

/* Place where a segment passes a roller's axis: its distance, and the side, seen from the tail. */
typedef struct Crossing {
    double away;   /* m; INFINITY: no crossing */
    double across; /* m from the roller's middle, along its axis */
    int side;
} Crossing;

/* Crossing of a straight piece of half length `half` about p, along the unit vector a, up to `reach` from the roller's
 * middle. */
static Crossing piece_crossing(Vec3 p, Vec3 a, double half, const Shape *roller, double reach)
{
    const Crossing none = {INFINITY, 0, 0};
    const Vec3 from = v3_sub(p, roller->centre);
    const Vec3 flat = v3_reject(from, roller->axis), run = v3_reject(a, roller->axis);
    const double square = v3_dot(run, run);
    if (square < ALONG) return none;
    const double u = -v3_dot(flat, run) / square;
    if (!(fabs(u) <= half)) return none;
    const double across = v3_dot(v3_axpy(from, u, a), roller->axis);
    if (fabs(across) > reach) return none;
    const Vec3 at = v3_axpy(flat, u, run);
    return (Crossing){v3_norm(at), across, v3_dot(at, v3_cross(roller->axis, run)) < 0 ? -1 : 1};
}

/* Nearest of the crossings of the nearest segment and its neighbours. */
static Crossing chain_crossing(const Chain *chain, const Kinematics *kin, double longest, const Shape *roller,
                               double reach)
{
    const int nearest = nearest_segment(chain, kin, longest, roller->centre);
    Crossing best = {INFINITY, 0, 0};
    for (int i = nearest > 0 ? nearest - 1 : 0; i <= nearest + 1 && i < chain->n; ++i) {
        const Crossing here = piece_crossing(v3_load(kin->p, i), v3_load(kin->a, i), chain->half[i], roller, reach);
        if (here.away < best.away) best = here;
    }
    return best;
}

/* Distance from its axis within which the line belongs to a roller, m. */
static double near_of(const Shape *roller, double cable) { return 2 * (roller->radius + cable); }

/* Nearest crossing of the route, in short pieces; distant ones are skipped. */
static Crossing route_crossing(const Route *route, const Shape *roller, double cable)
{
    const double near = near_of(roller, cable) + roller->half_width, piece = (roller->radius + cable) / 4;
    Crossing best = {INFINITY, 0, 0};
    for (double s = 0; s < route->length;) {
        const RoutePoint at = route_at(route, s);
        const double away = v3_norm(v3_sub(at.position, roller->centre));
        const Crossing here = piece_crossing(at.position, at.tangent, piece, roller, roller->half_width);
        if (here.away < best.away) best = here;
        s += fmax(piece, away - near);
    }
    return best;
}

static double longest_segment(const Chain *chain)
{
    double longest = 0;
    for (int i = 0; i < chain->n; ++i) longest = fmax(longest, 2 * chain->half[i]);
    return longest;
}

static int has_sides(const Shape *shape) { return shape->kind != SHAPE_BOX && shape->kind != SHAPE_BELL; }

static double thickest(const Chain *chain)
{
    double radius = 0;
    for (int i = 0; i < chain->n; ++i) radius = fmax(radius, chain->radius[i]);
    return radius;
}

hawser_status passing_new(Passing *p, const Scene *scene, hawser_error *err)
{
    const size_t rollers = (size_t)scene->contact.n_rollers, surfaces = (size_t)scene->surfaces.model.n_surfaces;
    p->side = calloc(rollers + 1, sizeof *p->side);
    p->gone = calloc(rollers + surfaces + 1, sizeof *p->gone);
    p->seen = calloc(surfaces * SURFACE_FACES_MAX * (size_t)scene->total + 1, sizeof *p->seen);
    if (scene->surfaces.facets) p->last = malloc((size_t)scene->total * sizeof *p->last);
    if (!p->side || !p->gone || !p->seen || (scene->surfaces.facets && !p->last)) return error_memory(err);
    for (int i = 0; p->last && i < scene->total; ++i) v3_put(p->last[i], v3(NAN, NAN, NAN));
    snprintf(p->says, sizeof p->says, "the cable has passed through a support");
    snprintf(p->overlap.says, sizeof p->overlap.says, "cables lie inside each other");
    const double cable = thickest(&scene->chain);
    for (int r = 0; r < scene->contact.n_rollers && !scene->rod->present; ++r) {
        const Shape *const shape = &scene->contact.roller[r].shape;
        if (!has_sides(shape)) continue;
        const Crossing route = route_crossing(&scene->route, shape, cable);
        if (route.away < near_of(shape, cable)) p->side[r] = (signed char)route.side;
    }
    return HAWSER_OK;
}

static int note(Passing *p, int body, const char *what, const char *name, double t)
{
    if (p->gone[body]) return 0;
    p->gone[body] = 1;
    if (++p->through > 1) return 0;
    snprintf(p->says, sizeof p->says, "the cable has passed through %s '%.60s'%s", what, name,
             t > 0 ? "" : " before t = 0");
    return 1;
}

/* The side of a roller is the one on which the route passes it, or on which the cable was when it first came near. */
static int rollers_look(Passing *p, const Scene *scene, const Workspace *ws, double t)
{
    const Chain *const chain = &scene->chain;
    const double cable = thickest(chain), longest = longest_segment(chain);
    int new = 0;
    for (int part = 0; part < PARTS; ++part) {
        const ContactPart *const half = &ws->contact[part];
        for (int k = 0; k < half->model.n_rollers; ++k) {
            const Shape *const shape = &half->model.roller[k].shape;
            if (!has_sides(shape)) continue;
            const int r = half->first + k;
            const Crossing now = chain_crossing(chain, &ws->kin, longest, shape, shape->half_width);
            if (!p->side[r] && now.away < near_of(shape, cable)) p->side[r] = (signed char)now.side;
            if (p->side[r] && now.side && now.side != p->side[r])
                new |= note(p, r, "roller", scene->def.rollers[r].name, t);
        }
    }
    return new;
}

/* ------------------------------------------------------------------------------------------------- surfaces */

/* Checks whether segment i, by its place along the route, is where the patch is: another part of the route may pass
 * beside it. Planes are everywhere. */
static int patch_is_its(const Scene *scene, const Kinematics *kin, double travel, const SurfacePatch *patch, int i)
{
    if (isnan(patch->s0) || scene->rod->present) return 1;
    const double s = along_joint(scene, kin, travel, i);
    return s > patch->s0 - STRAY_ALONG && s < patch->s0 + patch->length + STRAY_ALONG;
}

/* Checks one segment's centre against one patch: behind its face by more than the cable's radius, after it was before
 * the face. */
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

/* Updates, for a rod and a plane at any distance, which segments have been before the plane. Returns 1 if the rod runs
 * through it: of two neighbours that were before it one is behind by more than the cable's radius, and the line between
 * them meets it. */
static int plane_pierced(Passing *p, const Scene *scene, const Kinematics *kin, const SurfacePatch *patch)
{
    const int face = SURFACE_FACES_MAX * patch->surface + patch->face;
    char *const seen = &p->seen[(size_t)face * (size_t)scene->total + (size_t)scene->first];
    double before = 0;
    int pierced = 0;
    for (int i = 0; i < scene->chain.n; ++i) {
        const Vec3 here = v3_load(kin->p, i);
        const double distance = surface_probe(patch, here).distance, low = fmin(before, distance);
        if (distance > 0) seen[i] = 1;
        if (i > 0 && before * distance < 0 && low < -scene->chain.radius[i] && seen[i - 1] && seen[i]) {
            const Vec3 last = v3_load(kin->p, i - 1);
            const Vec3 meets = v3_axpy(last, before / (before - distance), v3_sub(here, last));
            const SurfaceProbe at = surface_probe(patch, meets);
            pierced |= at.owned && at.share >= SHARE;
        }
        before = distance;
    }
    return pierced;
}

/* Candidates do not show what was passed in a single step of statics: a rod is checked against every plane. */
static int planes_look(Passing *p, const Scene *scene, const Workspace *ws, double t)
{
    int new = 0;
    for (int k = 0; scene->rod->present && k < scene->surfaces.model.n_patches; ++k) {
        const SurfacePatch *const patch = &scene->surfaces.patch[k];
        if (isnan(patch->s0) && plane_pierced(p, scene, &ws->kin, patch))
            new |= note(p, scene->contact.n_rollers + patch->surface, "surface",
                        scene->def.surfaces[patch->surface].name, t);
    }
    return new;
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

/* ------------------------------------------------------------------------------------------------- environment */

/* Layer of a triangle that the way from a to b meets, and the place; -1: none. */
static int layer_between(const Facets *facets, Vec3 a, Vec3 b, Vec3 *at)
{
    static const double MEETS = 1e-9; /* m */
    double from[3], to[3], foot[3];
    int triangle;
    v3_put(from, a);
    v3_put(to, b);
    triangle_tree_distance(facets->tree, from, to, MEETS, &triangle, foot);
    if (triangle < 0) return -1;
    *at = v3_get(foot);
    return facets->mesh.layer[triangle];
}

/* (EN28): between neighbouring points at which the line is in contact. */
int passing_pierced(const Scene *scene, const Kinematics *kin, Vec3 *at)
{
    const SurfaceModel *const model = &scene->surfaces.model;
    const int points = scene->surfaces.facets ? SURFACE_POINTS * model->points->elements : 0;
    Vec3 last = V3_ZERO;
    for (int k = 0; k < points; ++k) {
        const Vec3 here = surface_point(model, &scene->chain, kin, k / SURFACE_POINTS, k % SURFACE_POINTS);
        const int layer = k > 0 ? layer_between(scene->surfaces.facets, last, here, at) : -1;
        if (layer >= 0) return layer;
        last = here;
    }
    return -1;
}

/* (EN28), second part: the ways of the segments' centres. A longer way may cut a corner that the segment has gone
 * round. */
static int layer_crossed(Passing *p, const Scene *scene, const Kinematics *kin)
{
    int layer = -1;
    Vec3 at;
    for (int i = 0; i < scene->chain.n; ++i) {
        double *const last = p->last[scene->first + i];
        const Vec3 before = v3_get(last), now = v3_load(kin->p, i);
        if (layer < 0 && v3_norm(v3_sub(now, before)) < scene->chain.half[i])
            layer = layer_between(scene->surfaces.facets, before, now, &at);
        v3_put(last, now);
    }
    return layer;
}

static int environment_look(Passing *p, const Scene *scene, const Kinematics *kin, double t)
{
    Vec3 at;
    if (!p->last) return 0;
    const int crossed = layer_crossed(p, scene, kin), layer = crossed < 0 ? passing_pierced(scene, kin, &at) : crossed;
    return layer >= 0 && note(p, scene->contact.n_rollers + scene->surfaces.model.n_surfaces, "the environment's layer",
                              scene->def.environment.mesh.layer_name[layer], t);
}

/* ----------------------------------------------------------------------------------------------------------- */

int passing_look(Passing *p, const Scene *scene, const Workspace *ws, double travel, double t)
{
    const int rollers = rollers_look(p, scene, ws, t);
    const int planes = planes_look(p, scene, ws, t) | environment_look(p, scene, &ws->kin, t);
    return rollers | planes | surfaces_look(p, scene, ws, travel, t);
}

int passing_record(Passing *p, const Scene *scene, const Workspace *ws, double travel, double t)
{
    if (t < p->due && t < scene->def.duration) return environment_look(p, scene, &ws->kin, t);
    p->due = t + scene->def.duration / LOOKS;
    return passing_look(p, scene, ws, travel, t);
}

/* ------------------------------------------------------------------------------------------- cable in cable */

static int touches(const Scene *scene) { return scene->self.present || scene->def.strand.present; }

static void overlap_say(Overlap *o, const SelfOverlap *now, const Scene *const scene[], double t)
{
    const char *const own = scene[now->line]->def.strand.name, *const other = scene[now->other]->def.strand.name;
    char who[96] = "the cable lies inside itself";
    if (now->line != now->other)
        snprintf(who, sizeof who, "chains '%.24s' and '%.24s' lie inside each other", own, other);
    else if (*own)
        snprintf(who, sizeof who, "chain '%.24s' lies inside itself", own);
    snprintf(o->says, sizeof o->says, "%s near (%.4g, %.4g, %.4g) m at %.4g s", who, now->at.x, now->at.y, now->at.z,
             t);
}

void overlap_record(Overlap *o, const SelfLines *lines, const Scene *const scene[], double t)
{
    const double duration = scene[0]->def.duration;
    if (t < o->due && t < duration && !touches(scene[0])) return;
    o->due = t + duration / LOOKS;
    const SelfOverlap now = self_overlap(lines);
    if (now.line >= 0 && now.share > o->share) {
        o->share = now.share;
        overlap_say(o, &now, scene, t);
    }
    ++o->looks;
}

/* ------------------------------------------------------------------------------------------------- the start */

/* Largest contact force that equilibrium can require, N: the sum of all weights and pulls at the start. */
static double all_loads(const Scene *scene)
{
    const Chain *const chain = &scene->chain;
    double sum = fabs(profile_value(&scene->tail, 0)) + rod_load_size(scene->rod, chain, 0);
    if (scene->winch->mode == WINCH_TENSION) sum += fabs(profile_value(&scene->def.winch.tension, 0));
    for (int i = 0; i < chain->n; ++i) sum += chain->mass[i] * v3_norm(scene->def.gravity);
    return sum;
}

static void start_worst(Misfit *start, double force, double exponent, const char *name)
{
    if (!(force > start->force)) return;
    *start = (Misfit){.force = force, .allowed = start->allowed, .exponent = exponent, .name = name};
}

/* Checks whether a roller bears the cable without holding it sideways: flat, and level. */
static int is_open(const Shape *roller, Vec3 gravity)
{
    const double level = 0.5; /* cosine between axis and plumb line */
    return roller->kind == SHAPE_CYLINDER && fabs(v3_dot(roller->axis, gravity)) < level * v3_norm(gravity);
}

/* Finds the flat roller on which the chain is nearest to the edge, including rollers that it is beside. */
static Edge edge_look(const Scene *scene, const Kinematics *kin)
{
    const Chain *const chain = &scene->chain;
    const double longest = longest_segment(chain), cable = thickest(chain);
    Edge worst = {.share = 0};
    for (int r = 0; r < scene->contact.n_rollers && !scene->rod->present; ++r) {
        const Shape *const shape = &scene->contact.roller[r].shape;
        if (!is_open(shape, scene->def.gravity)) continue;
        const Crossing here = chain_crossing(chain, kin, longest, shape, 2 * shape->half_width);
        const double share = fabs(here.across) / shape->half_width;
        if (here.away > near_of(shape, cable) || !(share > worst.share)) continue;
        worst = (Edge){.share = share,
                       .across = fabs(here.across),
                       .half = shape->half_width,
                       .at = scene->def.rollers[r].s,
                       .name = scene->def.rollers[r].name};
    }
    return worst;
}

void passing_start(Passing *p, const Scene *scene, const Kinematics *kin, const hawser_sample *look)
{
    const SceneDef *const def = &scene->def;
    p->start = (Misfit){.allowed = all_loads(scene)};
    for (int r = 0; r < look->rollers; ++r)
        start_worst(&p->start, look->roller_load[r], def->impact.e, def->rollers[r].name);
    for (int k = 0; k < look->surfaces; ++k)
        start_worst(&p->start, look->surface_normal[k], def->line_impact.e, def->surfaces[k].name);
    p->start.longest = longest_segment(&scene->chain);
    p->edge = edge_look(scene, kin);
}

double misfit_segment(const Misfit *start)
{
    return start->longest * fmin(1, pow(start->allowed / start->force, 1 / (2 * start->exponent)));
}
