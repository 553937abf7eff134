/* From a user's description to patches: each face of the cross-section is swept along each part of the way. */
#include "contact/surface.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/chain.h"
#include "core/error.h"
#include "core/route.h"

static SurfaceFade fade_between(double from, double to, double band)
{
    return (SurfaceFade){1, from - band / 2, from + band / 2, to - band / 2, to + band / 2};
}

/* The way fades in and out around the stretch's ends; parts in between need no weight. */
static void way_fade(const SurfaceShape *shape, SurfacePatch *way)
{
    const double half = shape->fade / 2;
    if (way->s0 >= shape->from + half && way->s0 + way->length <= shape->to - half) return;
    way->along = fade_between(shape->from - way->s0, shape->to - way->s0, shape->fade);
}

/* A plane face of a section: its distance is ny y + nz z + offset. */
static SurfacePatch face_flat(const SurfacePatch *way, double ny, double nz, double offset)
{
    SurfacePatch face = *way;
    face.section = SECTION_FLAT;
    face.ny = ny;
    face.nz = nz;
    face.offset = offset;
    return face;
}

static void face_across(SurfacePatch *face, double vy, double vz, SurfaceFade fade)
{
    face->vy = vy;
    face->vz = vz;
    face->across = fade;
}

/* A floor and, if it has sides, two upright walls. The weight of a wall begins below the floor, out of the cable's way,
 * and ends where the cable's centre is its radius above the wall's top. */
static int faces_flat(const SurfaceShape *d, const SurfacePatch *way, SurfacePatch *out)
{
    const double band = d->cable_radius, top = d->height - d->depth;
    const SurfaceFade upright = {1, -d->depth - 3 * band, -d->depth - 2 * band, top, top + band};
    out[0] = face_flat(way, 0, 1, d->depth);
    face_across(&out[0], 1, 0, fade_between(-d->width / 2, d->width / 2, band));
    if (!(d->height > 0)) return 1;
    for (int k = 0; k < 2; ++k) {
        out[1 + k] = face_flat(way, k == 0 ? -1 : 1, 0, d->width / 2);
        face_across(&out[1 + k], 0, 1, upright);
    }
    return 3;
}

/* Two planes that meet below the cable. */
static int faces_v(const SurfaceShape *d, const SurfacePatch *way, SurfacePatch *out)
{
    const double r = d->cable_radius, c = cos(d->angle / 2), s = sin(d->angle / 2);
    const double offset = r - s * (r - d->depth), apex = -offset / s;
    /* along the slope of a plane, from below the apex to its top */
    const double low = c * apex, high = low + (d->height - d->depth - apex) / c;
    for (int k = 0; k < 2; ++k) {
        const double outward = k == 0 ? 1 : -1;
        out[k] = face_flat(way, -outward * c, s, offset);
        face_across(&out[k], outward * s, c, (SurfaceFade){1, low - 2 * r, low - r, high, high + r});
    }
    return 2;
}

/* The lower half of a tube, open above, whose sides may extend upright. */
static int faces_u(const SurfaceShape *d, const SurfacePatch *way, SurfacePatch *out)
{
    const double top = d->height - d->depth;
    *out = *way;
    out->section = SECTION_TROUGH;
    out->inner = d->radius;
    out->lift = d->radius - d->depth;
    /* it has no lower end */
    face_across(out, 0, 1, (SurfaceFade){1, -1e9, -5e8, top, top + d->cable_radius});
    return 1;
}

static int faces(const SurfaceShape *d, const SurfacePatch *way, SurfacePatch *out)
{
    if (d->kind == SURFACE_FLAT) return faces_flat(d, way, out);
    if (d->kind == SURFACE_V) return faces_v(d, way, out);
    if (d->kind == SURFACE_U) return faces_u(d, way, out);
    *out = *way;
    out->section = SECTION_TUBE;
    out->inner = d->radius;
    out->lift = d->lift;
    return 1;
}

/* A plane by point and normal is a straight floor of its own, with the given length and width. */
static SurfacePatch plane_patch(const SurfaceShape *d)
{
    SurfacePatch p = {
        .s0 = NAN, .start = d->point, .tangent = d->along, .up = d->normal, .roll_cos = 1, .depth = SURFACE_DEPTH_MAX};
    p.side = v3_cross(p.up, p.tangent);
    if (d->length > 0) {
        p.length = d->length + d->fade;
        p.start = v3_axpy(d->point, -p.length / 2, d->along);
        p.along = fade_between(d->fade / 2, d->fade / 2 + d->length, d->fade);
    }
    p.end = v3_axpy(p.start, p.length, p.tangent);
    p.end_tangent = p.tangent;
    p = face_flat(&p, 0, 1, 0);
    if (d->width > 0) face_across(&p, 1, 0, fade_between(-d->width / 2, d->width / 2, d->fade));
    if (!(d->length > 0 || d->width > 0)) p.depth = INFINITY; /* half of space is behind it */
    return p;
}

static int faces_of(const SurfaceShape *shape)
{
    if (shape->kind == SURFACE_FLAT) return shape->height > 0 ? 3 : 1;
    return shape->kind == SURFACE_V ? 2 : 1;
}

int surface_patch_count(const SurfaceShape *shape, const Route *route)
{
    if (shape->kind == SURFACE_PLANE) return 1;
    const double last = shape->to + shape->fade / 2;
    int parts = 0;
    double s = shape->from - shape->fade / 2;
    SurfacePatch way[SURFACE_WAY_MAX];
    while (s < last) parts += surface_way(route, &s, last, 0, way);
    return parts * faces_of(shape);
}

void surface_patches(const SurfaceShape *shape, const Route *route, int surface, SurfacePatch *patch)
{
    SurfacePatch *out = patch;
    if (shape->kind == SURFACE_PLANE) {
        *out++ = plane_patch(shape);
    } else {
        /* only a tube about the route is the same at every roll */
        const int rolls = shape->kind != SURFACE_DUCT || shape->lift != 0;
        const double last = shape->to + shape->fade / 2;
        double s = shape->from - shape->fade / 2;
        while (s < last) {
            SurfacePatch way[SURFACE_WAY_MAX];
            const int parts = surface_way(route, &s, last, rolls, way);
            for (int k = 0; k < parts; ++k) {
                way_fade(shape, &way[k]);
                out += faces(shape, &way[k], out);
            }
        }
    }
    for (SurfacePatch *p = patch; p < out; ++p) {
        p->surface = p->law = surface;
        p->face = (int)(p - patch) % faces_of(shape);
    }
}

void surface_mesh_patches(int surface, int law, SurfacePatch *patch)
{
    for (int k = 0; k < SURFACE_FACES_MAX; ++k) {
        patch[k] = (SurfacePatch){.surface = surface, .face = k, .law = law, .s0 = NAN, .section = SECTION_MESH};
    }
}

enum { ARRAYS = 3 * SURFACE_POINTS };

int surface_pairs_sticks(SurfacePairs *pairs, const SurfaceModel *model, int n)
{
    SurfaceStick *const stick = &pairs->stick;
    *stick = (SurfaceStick){.bed = calloc((size_t)(model->n_surfaces * SURFACE_FACES_MAX) + 1, sizeof *stick->bed)};
    if (!stick->bed) return 0;
    stick->n_beds = model->n_surfaces * SURFACE_FACES_MAX;
    for (int b = 0; b < stick->n_beds; ++b) {
        SurfaceBed *const bed = &stick->bed[b];
        if (friction_kind(&model->friction[b / SURFACE_FACES_MAX]) != FRICTION_STICK) continue;
        if (!chain_struct_alloc(bed, n)) return 0;
    }
    return 1;
}

void surface_stick_free(SurfaceStick *stick)
{
    for (int b = 0; b < stick->n_beds; ++b) chain_struct_free(&stick->bed[b]);
    free(stick->bed);
    memset(stick, 0, sizeof *stick);
}

/* Prepares elements from .. to-1, with no leans collected yet. */
static void surface_stick_begin(SurfaceStick *stick, int from, int to)
{
    for (int b = 0; b < stick->n_beds; ++b) {
        double *const *const array = &stick->bed[b].fresh[0][0];
        for (int k = 0; k < ARRAYS && array[0]; ++k) memset(array[k] + from, 0, (size_t)(to - from) * sizeof(double));
    }
}

/* Accepts a step to t: the collected leans become the stored ones. */
static void surface_stick_accept(SurfaceStick *stick, double t)
{
    for (int b = 0; b < stick->n_beds; ++b) {
        SurfaceBed *const bed = &stick->bed[b];
        double *old[SURFACE_POINTS][3];
        memcpy(old, bed->lean, sizeof old);
        memcpy(bed->lean, bed->fresh, sizeof old);
        memcpy(bed->fresh, old, sizeof old);
    }
    stick->since = t;
    stick->elapsed = 0;
}

void surface_pairs_checkpoint(Checkpoint *c, const SurfaceModel *model, SurfacePairs *pairs, int n)
{
    SurfaceStick *const stick = &pairs->stick;
    checkpoint_list(c, "pairs->range", (void **)&pairs->range, &pairs->n_ranges, &pairs->ranges_allocated,
                    sizeof *pairs->range);
    for (int i = 0; !c->status && i < pairs->n_ranges; ++i) {
        const SurfaceRange *const r = &pairs->range[i];
        const int ok = r->patch >= 0 && r->patch < model->n_patches && r->first >= pairs->from && r->count >= 0 &&
                       r->first <= pairs->to - r->count;
        checkpoint_check(c, ok, "candidates for contact with surfaces are impossible");
    }
    surface_near_checkpoint(c, model, pairs, n);
    CHECKPOINT(c, pairs->candidates);
    CHECKPOINT(c, pairs->active);
    CHECKPOINT(c, pairs->work);
    CHECKPOINT_UP_TO(c, stick, SurfaceStick, n_beds);
    for (int b = 0; b < stick->n_beds; ++b) {
        double *const *const array = &stick->bed[b].lean[0][0];
        if (array[0]) chain_arrays_checkpoint(c, "bed->lean", array, ARRAYS, n);
    }
}

/* The steps of a call: for every range of candidates, strips of LANES consecutive elements go through a kernel that
 * adds to the loads itself; blocks are scattered here. Only surface_refresh allocates. */

SurfaceProbe surface_probe(const SurfacePatch *patch, Vec3 p)
{
    SurfaceProbe out;
    surface_kernels()->probe(patch, p, &out);
    return out;
}

/* Two points of [0, 1] and their shares of the length: Gauss, and Radau where one has to be the line's end (DU16). */
typedef struct Rule {
    double u[SURFACE_POINTS], share[SURFACE_POINTS];
} Rule;

static const Rule gauss = {{0.21132486540518712, 0.78867513459481288}, {0.5, 0.5}},
                  from_tip = {{0, 2.0 / 3}, {0.25, 0.75}}, to_tip = {{1.0 / 3, 1}, {0.75, 0.25}},
                  both_tips = {{0, 1}, {0.5, 0.5}};

/* The rule of element e. */
static const Rule *rule_of(int elements, int e)
{
    if (elements == 1) return &both_tips;
    return e == 0 ? &from_tip : e == elements - 1 ? &to_tip : &gauss;
}

/* A segment's value, 0 for a segment that does not exist. */
static double segment_value(const double *array, int i, int n) { return i >= 0 && i < n ? array[i] : 0; }

/* (DU1), (DU2): the weights of contact/shape.h at a fixed u. A capsule belongs to the body that has its number. The
 * line's ends have a larger share (DU17). */
static void point_set(SurfacePoints *points, ContactGeometry geometry, const Chain *chain, int e, int q)
{
    const Element element = element_at(geometry, chain->n, e);
    const Rule *const rule = rule_of(points->elements, e);
    const double u = rule->u[q];
    const LineWeights w = element_weights(&element, u);
    const int capsule = geometry == GEOMETRY_CYLINDER, n = chain->n;
    points->alpha[q][e] = capsule ? 1 : w.alpha[1];
    points->beta[q][0][e] = capsule ? 0 : w.beta[0];
    points->beta[q][1][e] = w.beta[!capsule];
    points->radius[q][e] = element_radius(&element, chain, u);
    const double length =
        capsule ? 2 * chain->half[e] : segment_value(chain->half, e - 1, n) + segment_value(chain->half, e, n);
    const int is_tip = (e == 0 && u == 0) || (e == points->elements - 1 && u == 1);
    points->length[q][e] = rule->share[q] * length + (is_tip ? points->tip : 0);
}

enum { POINTS_ARRAYS = 5 * SURFACE_POINTS }; /* from SurfacePoints.alpha on */

int surface_points_alloc(SurfacePoints *points, ContactGeometry geometry, const Chain *chain)
{
    points->elements = element_count(geometry, chain->n);
    if (!chain_struct_new(points->alpha, POINTS_ARRAYS, chain->n)) return 0;
    for (int e = 0; e < points->elements; ++e) {
        for (int q = 0; q < SURFACE_POINTS; ++q) point_set(points, geometry, chain, e, q);
    }
    return 1;
}

void surface_points_free(SurfacePoints *points) { chain_arrays_free(points->alpha, POINTS_ARRAYS); }

void surface_pairs_init(SurfacePairs *pairs, int from, int to)
{
    memset(pairs, 0, sizeof *pairs);
    pairs->from = from;
    pairs->to = to;
}

void surface_pairs_free(SurfacePairs *pairs)
{
    free(pairs->range);
    surface_stick_free(&pairs->stick);
    surface_near_free(pairs->near);
    memset(pairs, 0, sizeof *pairs);
}

int surface_sticks(const SurfaceModel *model)
{
    int any = 0;
    for (int i = 0; i < model->n_surfaces; ++i) any |= friction_kind(&model->friction[i]) == FRICTION_STICK;
    return any;
}

/* Elements first .. first + count - 1 against a patch. */
static SurfaceStrip strip_of(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, double scale,
                             const SurfacePairs *pairs, int patch, int first, int count)
{
    const SurfaceStick *const stick = &pairs->stick;
    const SurfacePresumed *const presumed = pairs->presumed;
    const SurfacePatch *const p = &model->patch[patch];
    const int face = SURFACE_FACES_MAX * p->surface + p->face;
    const int mesh = p->section == SECTION_MESH; /* does not stick */
    const SurfaceBed *const bed = stick->n_beds > 0 && !mesh ? &stick->bed[face] : NULL;
    SurfaceStrip strip = {.patch = p,
                          .impact = &model->impact,
                          .friction = &model->friction[p->law],
                          .friction_scale = scale,
                          .points = model->points,
                          .chain = chain,
                          .kin = kin,
                          .bed = bed && bed->lean[0][0] ? bed : NULL,
                          .elapsed = stick->elapsed,
                          .foot = mesh ? &pairs->near->foot[p->face] : NULL,
                          .first = first,
                          .count = count < LANES ? count : LANES};
    for (int q = 0; presumed && q < SURFACE_POINTS; ++q) strip.presumed[q] = presumed->bed[face][q];
    return strip;
}

/* One more range; 0 if there is no memory. */
static int range_add(SurfacePairs *pairs, SurfaceRange range)
{
    if (pairs->n_ranges == pairs->ranges_allocated) {
        const int more = 2 * pairs->ranges_allocated + 16;
        SurfaceRange *const grown = realloc(pairs->range, (size_t)more * sizeof *grown);
        if (!grown) return 0;
        pairs->range = grown;
        pairs->ranges_allocated = more;
    }
    assert(pairs->range);
    pairs->range[pairs->n_ranges++] = range;
    return 1;
}

/* Adds element e as a candidate of this patch: it extends the last range or begins a new one. */
int surface_candidate_add(SurfacePairs *pairs, int patch, int e)
{
    SurfaceRange *const last = pairs->n_ranges ? &pairs->range[pairs->n_ranges - 1] : NULL;
    ++pairs->candidates;
    if (!last || last->patch != patch || last->first + last->count != e) {
        return range_add(pairs, (SurfaceRange){patch, e, 1});
    }
    ++last->count;
    return 1;
}

/* A sphere around segments from .. to-1, with their contact radii. */
static Sphere run_sphere(const Chain *chain, const Kinematics *kin, int from, int to)
{
    Vec3 low = v3(INFINITY, INFINITY, INFINITY), high = v3(-INFINITY, -INFINITY, -INFINITY);
    double most = 0;
    for (int i = from; i < to; ++i) {
        low = v3(fmin(low.x, kin->p[0][i]), fmin(low.y, kin->p[1][i]), fmin(low.z, kin->p[2][i]));
        high = v3(fmax(high.x, kin->p[0][i]), fmax(high.y, kin->p[1][i]), fmax(high.z, kin->p[2][i]));
        most = fmax(most, 2 * chain->half[i] + chain->radius[i]);
    }
    return (Sphere){v3_scale(0.5, v3_add(low, high)), v3_norm(v3_sub(high, low)) / 2 + most};
}

/* Checks whether a sphere comes within reach of the part of the way on which a patch is (DU13). */
static int way_reaches(const SurfacePatch *patch, Sphere sphere, double reach)
{
    if (!(patch->length > 0)) return 1;
    const double margin = sphere.radius + reach;
    return v3_dot(v3_sub(sphere.centre, patch->start), patch->tangent) >= -margin &&
           v3_dot(v3_sub(sphere.centre, patch->end), patch->end_tangent) < margin;
}

enum { RUN = 32 }; /* elements under one sphere */

/* Candidates of all patches in one run of elements, whose sphere excludes most patches. */
static int run_refresh(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, int patch,
                       SurfacePairs *pairs, int from, int to)
{
    for (int first = from; first < to; first += LANES) {
        int near[LANES];
        const SurfaceStrip strip = strip_of(model, chain, kin, 0, pairs, patch, first, to - first);
        surface_kernels()->near(&strip, model->reach, near);
        for (int l = 0; l < strip.count; ++l) {
            if (near[l] && !surface_candidate_add(pairs, patch, first + l)) return 0;
        }
    }
    return 1;
}

hawser_status surface_refresh(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, SurfacePairs *pairs,
                              hawser_error *err)
{
    pairs->n_ranges = pairs->candidates = 0;
    const int swept = model->n_patches - SURFACE_FACES_MAX * model->n_laws;
    for (int patch = 0; patch < swept; ++patch) {
        for (int from = pairs->from; from < pairs->to; from += RUN) {
            const int to = from + RUN < pairs->to ? from + RUN : pairs->to;
            /* an element depends on the segment before it and its own */
            const Sphere around = run_sphere(chain, kin, from > 0 ? from - 1 : 0, to < chain->n ? to : chain->n);
            if (!way_reaches(&model->patch[patch], around, model->reach)) continue;
            if (!run_refresh(model, chain, kin, patch, pairs, from, to)) return error_memory(err);
        }
    }
    if (model->facets && !surface_near_refresh(model, chain, kin, pairs)) return error_memory(err);
    return HAWSER_OK;
}

SurfaceTally surface_tally_new(void) { return (SurfaceTally){.at = NAN}; }

/* One element's forces on one face. */
static void tally_element(const SurfaceStrip *strip, const SurfacePush *push, int l, SurfacePairs *pairs,
                          SurfaceTally *tally)
{
    double normal = 0, length = 0, moment = 0;
    for (int q = 0; q < SURFACE_POINTS; ++q) {
        const double load = push->normal[q][l];
        length += strip->points->length[q][strip->first + l];
        if (!(load > 0)) continue;
        const Vec3 force = batch_at(push->force[q], l);
        tally->force = v3_sub(tally->force, force);
        /* the force is N n minus the friction, which is normal to n */
        tally->friction += sqrt(fmax(0, v3_dot(force, force) - load * load));
        normal += load;
        moment += load * push->along[q][l];
        ++pairs->active;
    }
    tally->normal += normal;
    if (!(normal > tally->line_load * length)) return;
    tally->line_load = normal / length;
    tally->at = strip->patch->s0 + moment / normal;
    tally->element = strip->first + l;
}

void surface_forces(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, double friction_scale,
                    SurfacePairs *pairs, Loads *loads, SurfaceTally *tally)
{
    const SurfaceKernels *const kernel = surface_kernels();
    SurfacePush push;
    if (tally) pairs->active = 0;
    pairs->work = (ContactTally){0};
    surface_feet(model, chain, kin, pairs, pairs->from, pairs->to, 0);
    for (int i = 0; i < pairs->n_ranges; ++i) {
        const SurfaceRange r = pairs->range[i];
        for (int done = 0; done < r.count; done += LANES) {
            const SurfaceStrip strip =
                strip_of(model, chain, kin, friction_scale, pairs, r.patch, r.first + done, r.count - done);
            const int any = kernel->push(&strip, loads, tally ? &push : NULL, &pairs->work);
            if (!any || !tally) continue;
            for (int l = 0; l < strip.count; ++l) {
                tally_element(&strip, &push, l, pairs, &tally[strip.patch->surface]);
            }
        }
    }
}

Vec3 surface_point(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, int e, int q)
{
    const SurfacePoints *const points = model->points;
    const double alpha[2] = {1 - points->alpha[q][e], points->alpha[q][e]};
    Vec3 p = V3_ZERO;
    for (int b = 0; b < 2; ++b) {
        const int i = e - 1 + b;
        if (i < 0 || i >= chain->n || (b == 0 && !(alpha[0] > 0))) continue;
        p = v3_axpy(v3_axpy(p, alpha[b], v3_load(kin->p, i)), points->beta[q][b][e] * chain->half[i],
                    v3_load(kin->a, i));
    }
    return p;
}

int surface_details(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, const SurfacePairs *pairs,
                    Loads *loads, SurfaceDetail *out)
{
    const SurfaceKernels *const kernel = surface_kernels();
    SurfacePush push;
    ContactTally unused = {0};
    int n = 0;
    surface_feet(model, chain, kin, pairs, pairs->from, pairs->to, 0);
    for (int i = 0; i < pairs->n_ranges; ++i) {
        const SurfaceRange r = pairs->range[i];
        for (int done = 0; done < r.count; done += LANES) {
            const SurfaceStrip strip = strip_of(model, chain, kin, 1, pairs, r.patch, r.first + done, r.count - done);
            if (!kernel->push(&strip, loads, &push, &unused)) continue;
            for (int k = 0; k < strip.count * SURFACE_POINTS; ++k) {
                const int l = k / SURFACE_POINTS, q = k % SURFACE_POINTS, e = strip.first + l;
                if (!(push.normal[q][l] > 0)) continue;
                const Vec3 point = surface_point(model, chain, kin, e, q);
                SurfaceProbe probe;
                if (strip.foot) {
                    probe.distance = strip.foot->distance[q][e];
                    probe.normal = v3_load(strip.foot->normal[q], e);
                } else {
                    probe = surface_probe(strip.patch, point);
                }
                out[n++] = (SurfaceDetail){.surface = strip.patch->surface,
                                           .element = e,
                                           .point_number = q,
                                           .normal = push.normal[q][l],
                                           .gap = probe.distance - model->points->radius[q][e],
                                           .point = point,
                                           .toward = probe.normal,
                                           .force = batch_at(push.force[q], l)};
            }
        }
    }
    return n;
}

void surface_blocks(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, double friction_scale,
                    const SurfacePairs *pairs, int from, int to, BlockChain *k, BlockChain *d)
{
    assert(k->b == 6 && d->b == 6 && k->n == chain->n && d->n == chain->n);
    const SurfaceKernels *const kernel = surface_kernels();
    ContactMatrix by_shift, by_speed;
    surface_feet(model, chain, kin, pairs, from, to, 0);
    for (int i = 0; i < pairs->n_ranges; ++i) {
        const SurfaceRange r = pairs->range[i];
        const int first = r.first > from ? r.first : from;
        const int end = r.first + r.count < to ? r.first + r.count : to;
        for (int e = first; e < end; e += LANES) {
            const SurfaceStrip strip = strip_of(model, chain, kin, friction_scale, pairs, r.patch, e, end - e);
            if (!kernel->columns(&strip, &by_shift, &by_speed)) continue;
            for (int l = 0; l < strip.count; ++l) {
                matrix_add(&by_shift, CONTACT_ROWS, l, e + l - 1, e + l, k);
                matrix_add(&by_speed, CONTACT_ROWS, l, e + l - 1, e + l, d);
            }
        }
    }
}

/* The arrays of a face. */
static double **presumed_bed(SurfacePresumed *out, const SurfaceModel *model, int patch, int n)
{
    const int beds = SURFACE_FACES_MAX * (model->n_surfaces + model->n_laws);
    if (!out->bed) {
        out->bed = calloc((size_t)beds, sizeof *out->bed);
        if (!out->bed) return NULL;
        out->n_beds = beds;
    }
    const SurfacePatch *const p = &model->patch[patch];
    double **const bed = out->bed[SURFACE_FACES_MAX * p->surface + p->face];
    return bed[0] || chain_struct_new(bed, SURFACE_POINTS, n) ? bed : NULL;
}

void surface_presumed_free(SurfacePresumed *presumed)
{
    for (int b = 0; b < presumed->n_beds; ++b) {
        if (presumed->bed[b][0]) chain_arrays_free(presumed->bed[b], SURFACE_POINTS);
    }
    free(presumed->bed);
    *presumed = (SurfacePresumed){0};
}

int surface_presume(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, const SurfacePairs *pairs,
                    const Presume *how, const double *patch, SurfacePresumed *out)
{
    double gap[SURFACE_POINTS][LANES];
    surface_feet(model, chain, kin, pairs, pairs->from, pairs->to, model->skin);
    for (int i = 0; i < pairs->n_ranges; ++i) {
        const SurfaceRange r = pairs->range[i];
        double *const *const bed = presumed_bed(out, model, r.patch, chain->n);
        if (!bed) return 0;
        for (int done = 0; done < r.count; done += LANES) {
            const SurfaceStrip strip = strip_of(model, chain, kin, 1, pairs, r.patch, r.first + done, r.count - done);
            surface_kernels()->gaps(&strip, gap);
            for (int k = 0; k < strip.count * SURFACE_POINTS; ++k) {
                const int l = k / SURFACE_POINTS, q = k % SURFACE_POINTS, e = strip.first + l;
                if (!(gap[q][l] < INFINITY)) continue; /* it belongs to another patch */
                const int j = e < chain->n ? e : chain->n - 1;
                const double before = how->from == PRESUME_LAST ? patch[r.patch] : bed[q][e];
                bed[q][e] =
                    presume_force(how, &model->impact, before, gap[q][l], chain->mass[j] / (2 * chain->half[j]));
            }
        }
    }
    return 1;
}

void surface_pressed(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, const SurfacePairs *pairs,
                     double *patch)
{
    static const Presume how = {.from = PRESUME_GAPS};
    double gap[SURFACE_POINTS][LANES], sum = 0;
    surface_feet(model, chain, kin, pairs, pairs->from, pairs->to, 0);
    for (int i = 0, n = 0; i < pairs->n_ranges; ++i) {
        const SurfaceRange r = pairs->range[i];
        if (i == 0 || pairs->range[i - 1].patch != r.patch) {
            n = 0;
            sum = 0;
        }
        for (int done = 0; done < r.count; done += LANES) {
            const SurfaceStrip strip = strip_of(model, chain, kin, 1, pairs, r.patch, r.first + done, r.count - done);
            surface_kernels()->gaps(&strip, gap);
            for (int k = 0; k < strip.count * SURFACE_POINTS; ++k) {
                const double at = gap[k % SURFACE_POINTS][k / SURFACE_POINTS];
                if (!(at < 0)) continue;
                sum += presume_force(&how, &model->impact, 0, at, 0);
                ++n;
            }
        }
        const int last = i + 1 == pairs->n_ranges || pairs->range[i + 1].patch != r.patch;
        if (last && n > 0) patch[r.patch] = fmax(patch[r.patch], sum / n);
    }
}

void surface_clock(SurfacePairs *pairs, double t)
{
    SurfaceStick *const stick = &pairs->stick;
    stick->elapsed = t > stick->since ? t - stick->since : 0;
}

/* Evaluates the points in contact once more to find their leans. */
void surface_accept(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, double t, SurfacePairs *pairs)
{
    surface_clock(pairs, t);
    surface_stick_begin(&pairs->stick, pairs->from, pairs->to);
    for (int i = 0; i < pairs->n_ranges; ++i) {
        const SurfaceRange r = pairs->range[i];
        for (int done = 0; done < r.count; done += LANES) {
            const SurfaceStrip strip = strip_of(model, chain, kin, 1, pairs, r.patch, r.first + done, r.count - done);
            if (strip.bed) surface_kernels()->keep(&strip);
        }
    }
    surface_stick_accept(&pairs->stick, t);
}

void surface_carry(const SurfacePairs *old, SurfacePairs *now, int joined)
{
    const int first = old->from + joined > now->from ? old->from + joined : now->from;
    const int end = old->to + joined < now->to ? old->to + joined : now->to;
    now->stick.since = old->stick.since;
    now->stick.elapsed = old->stick.elapsed;
    for (int b = 0; b < old->stick.n_beds && first < end; ++b) {
        double *const *const from = &old->stick.bed[b].lean[0][0], *const *const to = &now->stick.bed[b].lean[0][0];
        for (int k = 0; k < 3 * SURFACE_POINTS && from[0]; ++k) {
            memcpy(to[k] + first, from[k] + first - joined, (size_t)(end - first) * sizeof(double));
        }
    }
}

/* The way in parts: straights and arcs, cut at the route's corners and every quarter of a bend; curves are replaced by
 * pairs of arcs. */

static const double PI = 3.14159265358979323846;

/* Changes of roll below this are rounding, rad. */
static const double TWIST_MIN = 1e-9;

/* 1/m: an arc with less curvature is made straight. */
static const double STRAIGHT_MAX = 1e-7;

/* The longest part, m: a quarter of a bend; of a curve, a pair of arcs that stays within SURFACE_WAY_OFF of it
 * (RO18). */
static double part_length(const RoutePiece *p)
{
    const double quarter = p->radius * PI / 2;
    return p->kind == ROUTE_BEND ? quarter : fmin(quarter, cbrt(100 * SURFACE_WAY_OFF / fmax(p->curve.jerk, 1e-12)));
}

/* End of the part of the way that begins at s: a corner of the route, at most a quarter of a bend, or `last`. The route
 * continues straight at both ends. */
static double way_end(const Route *route, double s, double last)
{
    if (s < 0) return fmin(0, last);
    if (s >= route->length) return last;
    const int i = route_at(route, s).piece;
    const RoutePiece *const p = &route->piece[i];
    const double corner = i + 1 < route->n ? route->piece[i + 1].s0 : route->length;
    double end = corner;
    if (p->kind != ROUTE_STRAIGHT) {
        const double parts = ceil((corner - s) / part_length(p) - 1e-9);
        if (parts > 1) end = s + (corner - s) / parts;
    }
    return fmin(end, last);
}

/* Angle of the level left at s about the tangent, from `side` toward tangent x side, within half a turn of `near`. */
static double roll_at(const Route *route, double s, Vec3 side, double near)
{
    const Vec3 left = route_left(route, s), up = v3_cross(route_at(route, s).tangent, side);
    const double roll = atan2(v3_dot(left, up), v3_dot(left, side));
    return roll + 2 * PI * round((near - roll) / (2 * PI));
}

/* The roll at both ends of an arc (DU6), followed along it so that no full turn is lost. */
static void way_roll(const Route *route, double from, double to, SurfacePatch *way)
{
    enum { STEPS = 16 };
    double roll = roll_at(route, from, way->side, 0);
    way->roll[0] = roll;
    for (int k = 1; k <= STEPS; ++k) {
        /* the side turns with the arc and stays in its plane; the end belongs to this arc, not to the next piece */
        const double turn = (to - from) / way->bend * k / STEPS;
        const Vec3 side = v3_axpy(v3_scale(cos(turn), way->side), -sin(turn), way->tangent);
        roll = roll_at(route, k < STEPS ? from + (to - from) * k / STEPS : to, side, roll);
    }
    way->roll[1] = roll;
    way->twisted = fabs(way->roll[1] - way->roll[0]) > TWIST_MIN;
    way->roll_cos = cos(way->roll[0]);
    way->roll_sin = sin(way->roll[0]);
}

/* The part of the way between two places, without a section. Its end is equal, to the last bit, to the start of the
 * next one. */
static SurfacePatch way_part(const Route *route, double from, double to, int rolls)
{
    const RoutePoint a = route_at(route, from), b = route_at(route, to);
    SurfacePatch way = {.s0 = from, .length = to - from, .start = a.position, .tangent = a.tangent};
    way.depth = SURFACE_DEPTH_MAX;
    way.end = b.position;
    way.end_tangent = b.tangent;
    way.roll_cos = 1;
    const int inside = from >= 0 && from < route->length;
    if (inside && route->piece[a.piece].kind == ROUTE_BEND) {
        way.bend = route->piece[a.piece].radius;
        way.side = v3_unit(a.curvature);
        way.centre = v3_axpy(a.position, way.bend, way.side);
        if (rolls) way_roll(route, from, to, &way);
    } else {
        way.side = route_left(route, (from + to) / 2);
    }
    way.up = v3_cross(way.tangent, way.side);
    return way;
}

/* The level unit vector to the left of a tangent (R2); for an upright tangent any that is normal to it. */
static Vec3 level_left(Vec3 t)
{
    const Vec3 left = v3(-t.y, t.x, 0);
    return v3_norm(left) > 1e-9 ? v3_unit(left) : v3_unit(v3_reject(v3(0, 1, 0), t));
}

/* The roll at both ends of an arc whose tangents are its own (DU6), followed along it. */
static void arc_roll(SurfacePatch *way)
{
    enum { STEPS = 16 };
    double roll = 0;
    for (int k = 0; k <= STEPS; ++k) {
        const double turn = way->length / way->bend * k / STEPS;
        const Vec3 side = v3_axpy(v3_scale(cos(turn), way->side), -sin(turn), way->tangent);
        const Vec3 tangent = v3_axpy(v3_scale(cos(turn), way->tangent), sin(turn), way->side);
        const Vec3 left = level_left(tangent);
        const double angle = atan2(v3_dot(left, v3_cross(tangent, side)), v3_dot(left, side));
        roll = angle + 2 * PI * round((roll - angle) / (2 * PI));
        if (k == 0) way->roll[0] = roll;
    }
    way->roll[1] = roll;
    way->twisted = fabs(way->roll[1] - way->roll[0]) > TWIST_MIN;
    way->roll_cos = cos(way->roll[0]);
    way->roll_sin = sin(way->roll[0]);
}

/* One arc of a pair, which leaves `a` along its tangent and reaches b; `on` is a's place along the route. */
static SurfacePatch way_arc(const RoutePoint *a, const RoutePoint *b, double on, int rolls)
{
    SurfacePatch way = {.s0 = on, .start = a->position, .tangent = a->tangent};
    const Vec3 chord = v3_sub(b->position, a->position), toward = v3_reject(b->tangent, a->tangent);
    const double half = atan2(v3_norm(toward), v3_dot(a->tangent, b->tangent)) / 2;
    way.depth = SURFACE_DEPTH_MAX;
    way.end = b->position;
    way.end_tangent = b->tangent;
    way.roll_cos = 1;
    way.length = v3_norm(chord);
    const Vec3 left = level_left(a->tangent);
    way.side = left;
    if (half > STRAIGHT_MAX * way.length) {
        way.bend = way.length / (2 * sin(half));
        way.length = 2 * half * way.bend;
        way.side = v3_unit(toward);
        way.centre = v3_axpy(a->position, way.bend, way.side);
        if (rolls) arc_roll(&way);
    }
    way.up = v3_cross(way.tangent, way.side);
    return way;
}

/* Two arcs that have the places and tangents of the curve at both ends and a common tangent where they meet (RO17). */
static int way_pair(const Route *route, double from, double to, int rolls, SurfacePatch *way)
{
    const RoutePoint a = route_at(route, from), b = route_at(route, to);
    const Vec3 v = v3_sub(b.position, a.position), both = v3_add(a.tangent, b.tangent);
    const Vec3 turn = v3_sub(b.tangent, a.tangent);
    const double v2 = v3_dot(v, v), on = v3_dot(v, both), d = v2 / (on + sqrt(on * on + v3_dot(turn, turn) * v2));
    const Vec3 p = v3_axpy(a.position, d, a.tangent), q = v3_axpy(b.position, -d, b.tangent);
    const RoutePoint middle = {.position = v3_scale(0.5, v3_add(p, q)), .tangent = v3_unit(v3_sub(q, p))};
    way[0] = way_arc(&a, &middle, from, rolls);
    way[1] = way_arc(&middle, &b, from + way[0].length, rolls);
    return 2;
}

int surface_way(const Route *route, double *s, double last, int rolls, SurfacePatch way[SURFACE_WAY_MAX])
{
    const double from = *s, to = way_end(route, from, last);
    *s = to;
    const int inside = from >= 0 && from < route->length;
    if (inside && route->piece[route_at(route, from).piece].kind >= ROUTE_CURVE)
        return way_pair(route, from, to, rolls, way);
    way[0] = way_part(route, from, to, rolls);
    return 1;
}
