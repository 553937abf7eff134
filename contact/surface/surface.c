/* The corridor of a call: for every range of candidates, strips of LANES consecutive elements go through a kernel that
 * adds to the loads itself; blocks are scattered here. Nothing allocates but surface_refresh. */
#include "contact/surface/surface.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "contact/surface/surface_kernels.h"
#include "core/base/error.h"

SurfaceProbe surface_probe(const SurfacePatch *patch, Vec3 p)
{
    SurfaceProbe out;
    surface_kernels()->probe(patch, p, &out);
    return out;
}

/* Two points of [0, 1] and what share of the length they stand for: Gauss, and Radau where one has to be the line's end
 * (DU16). */
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

/* A segment's value, 0 for a segment that is not there. */
static double segment_value(const double *array, int i, int n) { return i >= 0 && i < n ? array[i] : 0; }

/* (DU1), (DU2): the weights of element.h at a fixed u. A capsule hangs on the body that has its number. The line's ends
 * stand for more (DU17). */
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
    const SurfaceBed *const bed = stick->n_beds > 0 ? &stick->bed[face] : NULL;
    SurfaceStrip strip = {.patch = p,
                          .impact = &model->impact,
                          .friction = &model->friction[p->law],
                          .friction_scale = scale,
                          .points = model->points,
                          .chain = chain,
                          .kin = kin,
                          .bed = bed && bed->lean[0][0] ? bed : NULL,
                          .elapsed = stick->elapsed,
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

/* Element e is a candidate of this patch: it lengthens the last range or begins a new one. */
static int candidate_add(SurfacePairs *pairs, int patch, int e)
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

/* Whether a sphere comes within reach of the part of the way that a patch lies on (DU13). */
static int way_reaches(const SurfacePatch *patch, Sphere sphere, double reach)
{
    if (!(patch->length > 0)) return 1;
    const double margin = sphere.radius + reach;
    return v3_dot(v3_sub(sphere.centre, patch->start), patch->tangent) >= -margin &&
           v3_dot(v3_sub(sphere.centre, patch->end), patch->end_tangent) < margin;
}

enum { RUN = 32 }; /* elements under one sphere */

/* Candidates of all patches in one run of elements, whose sphere rules most patches out. */
static int run_refresh(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, int patch,
                       SurfacePairs *pairs, int from, int to)
{
    for (int first = from; first < to; first += LANES) {
        int near[LANES];
        const SurfaceStrip strip = strip_of(model, chain, kin, 0, pairs, patch, first, to - first);
        surface_kernels()->near(&strip, model->reach, near);
        for (int l = 0; l < strip.count; ++l) {
            if (near[l] && !candidate_add(pairs, patch, first + l)) return 0;
        }
    }
    return 1;
}

hawser_status surface_refresh(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, SurfacePairs *pairs,
                              hawser_error *err)
{
    pairs->n_ranges = pairs->candidates = 0;
    for (int patch = 0; patch < model->n_patches; ++patch) {
        for (int from = pairs->from; from < pairs->to; from += RUN) {
            const int to = from + RUN < pairs->to ? from + RUN : pairs->to;
            /* an element hangs on the segment before it and its own */
            const Sphere around = run_sphere(chain, kin, from > 0 ? from - 1 : 0, to < chain->n ? to : chain->n);
            if (!way_reaches(&model->patch[patch], around, model->reach)) continue;
            if (!run_refresh(model, chain, kin, patch, pairs, from, to)) return error_memory(err);
        }
    }
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
        /* the force is N n minus the friction, square to n */
        tally->friction += sqrt(fmax(0, v3_dot(force, force) - load * load));
        normal += load;
        moment += load * push->along[q][l];
        ++pairs->active;
    }
    tally->normal += normal;
    if (!(normal > tally->line_load * length)) return;
    tally->line_load = normal / length;
    tally->at = strip->patch->s0 + moment / normal;
}

void surface_forces(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, double friction_scale,
                    SurfacePairs *pairs, Loads *loads, SurfaceTally *tally)
{
    const SurfaceKernels *const kernel = surface_kernels();
    SurfacePush push;
    if (tally) pairs->active = 0;
    pairs->work = (ContactTally){0};
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

/* Point q of element e (DU2). */
static Vec3 point_place(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, int e, int q)
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
    for (int i = 0; i < pairs->n_ranges; ++i) {
        const SurfaceRange r = pairs->range[i];
        for (int done = 0; done < r.count; done += LANES) {
            const SurfaceStrip strip = strip_of(model, chain, kin, 1, pairs, r.patch, r.first + done, r.count - done);
            if (!kernel->push(&strip, loads, &push, &unused)) continue;
            for (int k = 0; k < strip.count * SURFACE_POINTS; ++k) {
                const int l = k / SURFACE_POINTS, q = k % SURFACE_POINTS, e = strip.first + l;
                if (!(push.normal[q][l] > 0)) continue;
                const Vec3 point = point_place(model, chain, kin, e, q);
                const SurfaceProbe probe = surface_probe(strip.patch, point);
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
    const int beds = SURFACE_FACES_MAX * model->n_surfaces;
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
    for (int i = 0; i < pairs->n_ranges; ++i) {
        const SurfaceRange r = pairs->range[i];
        double *const *const bed = presumed_bed(out, model, r.patch, chain->n);
        if (!bed) return 0;
        for (int done = 0; done < r.count; done += LANES) {
            const SurfaceStrip strip = strip_of(model, chain, kin, 1, pairs, r.patch, r.first + done, r.count - done);
            surface_kernels()->gaps(&strip, gap);
            for (int k = 0; k < strip.count * SURFACE_POINTS; ++k) {
                const int l = k / SURFACE_POINTS, q = k % SURFACE_POINTS, e = strip.first + l;
                if (!(gap[q][l] < INFINITY)) continue; /* another patch's */
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

/* The points that touch are looked at once more, for how far each leans. */
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
