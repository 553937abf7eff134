/* The same steps as in contact/roller.c: hits_find (cheap, over all candidates) -> batch_fill -> a kernel -> scatter,
 * in the order of the hits. Nothing here allocates. */
#include "contact/planar.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "contact/law_lanes.h"

/* The refresh has made room: a candidate is a hit at most once. */
static void hit_add(ContactPairs *pairs, int roller, int element)
{
    assert(pairs->n_hits < pairs->hits_allocated);
    pairs->hit[pairs->n_hits++] = (ContactHit){.roller = roller, .element = element};
}

/* Smooth line: the owners by (C11); beyond the line's ends the slope counts as -1 and +1. */
static void hits_smooth(const PlanarContactKernels *kernel, const PlanarContactModel *model,
                        const PlanarKinematics *kin, ContactRange range, ContactPairs *pairs)
{
    enum { SOME = 64 };
    int owner[SOME];
    const int end = range.first + range.count;
    for (int first = range.first; first < end; first += SOME) {
        const int most = first + SOME < end ? first + SOME : end;
        const int count = kernel->owners(&model->roller[range.roller], kin, pairs->n, first, most, owner);
        for (int k = 0; k < count; ++k) hit_add(pairs, range.roller, owner[k]);
    }
}

/* Capsules: each near enough has its own minimum. */
static void hits_cylinder(const PlanarContactModel *model, const PlanarChain *chain, const PlanarKinematics *kin,
                          ContactRange range, ContactPairs *pairs)
{
    const PlanarRoller *const roller = &model->roller[range.roller];
    for (int e = range.first; e < range.first + range.count; ++e) {
        const double x = kin->p[0][e] - roller->centre[0], z = kin->p[1][e] - roller->centre[1];
        const double near = roller->radius + chain->half[e] + chain->radius[e];
        if (x * x + z * z < near * near) hit_add(pairs, range.roller, e);
    }
}

static void hits_find(const PlanarContactModel *model, const PlanarChain *chain, const PlanarKinematics *kin,
                      ContactPairs *pairs)
{
    const PlanarContactKernels *const kernel = planar_contact_kernels();
    pairs->n_hits = 0;
    for (int i = 0; i < pairs->n_near; ++i) {
        if (model->geometry == GEOMETRY_SMOOTH) {
            hits_smooth(kernel, model, kin, pairs->near[i], pairs);
        } else {
            hits_cylinder(model, chain, kin, pairs->near[i], pairs);
        }
    }
}

/* Distance of the roller from the sphere around an element of the smooth line (C18); at the line's ends, around half of
 * the segment. m, negative if the sphere reaches it. */
static double element_gap(const PlanarRoller *roller, const PlanarChain *chain, const PlanarKinematics *kin, int e)
{
    const int j = e > 0 ? e - 1 : 0, k = e < chain->n ? e : chain->n - 1;
    const double x = kin->p[0][k] - kin->p[0][j], z = kin->p[1][k] - kin->p[1][j];
    const double bulge = j == k ? chain->half[j] : 8. / 27 * (chain->half[j] + chain->half[k]);
    const double thick = fmax(chain->radius[j], chain->radius[k]);
    const double across = kin->p[0][j] + x / 2 - roller->centre[0], up = kin->p[1][j] + z / 2 - roller->centre[1];
    return sqrt(across * across + up * up) - roller->radius - sqrt(x * x + z * z) / 2 - bulge - thick;
}

void planar_contact_narrow(const PlanarContactModel *model, const PlanarChain *chain, const PlanarKinematics *kin,
                           double reach, ContactPairs *pairs)
{
    contact_widen(pairs);
    if (model->geometry != GEOMETRY_SMOOTH) return;
    pairs->n_near = 0;
    for (int i = 0; i < pairs->n_ranges; ++i) {
        ContactRange range = pairs->range[i];
        const PlanarRoller *const roller = &model->roller[range.roller];
        int last = range.first + range.count - 1;
        /* !(... > reach): a NaN counts as near */
        while (last >= range.first && element_gap(roller, chain, kin, range.first) > reach) ++range.first;
        while (last >= range.first && element_gap(roller, chain, kin, last) > reach) --last;
        range.count = last - range.first + 1;
        if (range.count > 0) pairs->near[pairs->n_near++] = range;
    }
}

/* Segment i as body b of lane l; all zeros if there is no such segment. */
static void batch_body(PlanarBatch *batch, const PlanarChain *chain, const PlanarKinematics *kin, int b, int l, int i)
{
    const int present = i >= 0 && i < chain->n;
    batch->body[b][l] = present ? i : -1;
    batch->radius[b][l] = present ? chain->radius[i] : 0;
    batch->w[b][l] = present ? kin->w[i] : 0;
    for (int c = 0; c < 2; ++c) {
        batch->x[b][c][l] = present ? kin->p[c][i] : 0;
        batch->r[b][c][l] = present ? chain->half[i] * kin->a[c][i] : 0;
        batch->v[b][c][l] = present ? kin->v[c][i] : 0;
    }
}

static void batch_hit(PlanarBatch *batch, const PlanarContactModel *model, const PlanarChain *chain,
                      const PlanarKinematics *kin, ContactHit hit, int l)
{
    const Element element = element_at(model->geometry, chain->n, hit.element);
    const PlanarRoller *const roller = &model->roller[hit.roller];
    batch->roller[l] = hit.roller;
    batch->arc[l] = element.arc;
    batch->alpha[l] = element.alpha;
    for (int b = 0; b < 2; ++b) {
        batch->beta[b][0][l] = element.beta[b][0];
        batch->beta[b][1][l] = element.beta[b][1];
        batch_body(batch, chain, kin, b, l, element.body[b]);
        batch->centre[b][l] = roller->centre[b];
    }
    batch->circle[l] = roller->radius;
    batch->friction[l] = &roller->friction;
}

/* Gathers hits from `first` on; returns the first that does not fit. Unused lanes repeat the last hit, so that the
 * kernels get valid numbers; they are not scattered. */
static int batch_fill(PlanarBatch *batch, const PlanarContactModel *model, const PlanarChain *chain,
                      const PlanarKinematics *kin, const ContactPairs *pairs, int first)
{
    batch->count = pairs->n_hits - first < LANES ? pairs->n_hits - first : LANES;
    for (int l = 0; l < LANES; ++l) {
        const int h = l < batch->count ? first + l : first + batch->count - 1;
        batch_hit(batch, model, chain, kin, pairs->hit[h], l);
    }
    return first + batch->count;
}

/* Adds one lane's wrench to its segments. */
static void push_add(const PlanarBatch *batch, const PlanarPush *push, int l, PlanarLoads *loads)
{
    for (int b = 0; b < 2; ++b) {
        const int i = batch->body[b][l];
        if (i < 0) continue;
        loads->f[0][i] += push->force[b][0][l];
        loads->f[1][i] += push->force[b][1][l];
        loads->m[i] += push->moment[b][l];
    }
}

void planar_contact_forces(const PlanarContactModel *model, const PlanarChain *chain, const PlanarKinematics *kin,
                           double friction_scale, ContactPairs *pairs, PlanarLoads *loads, double (*on_roller)[2])
{
    const PlanarContactKernels *const kernel = planar_contact_kernels();
    PlanarBatch batch = {.impact = &model->impact, .friction_scale = friction_scale};
    PlanarPush push;
    hits_find(model, chain, kin, pairs);
    pairs->active = 0;
    TallyLanes tally = {0};
    if (on_roller) memset(on_roller, 0, (size_t)model->n_rollers * sizeof *on_roller);
    for (int next = 0; next < pairs->n_hits;) {
        next = batch_fill(&batch, model, chain, kin, pairs, next);
        kernel->push(&batch, &push);
        for (int l = 0; l < batch.count; ++l) {
            tally_add(&tally, push.friction, push.damping, push.energy, push.total, 2,
                      l); /* also those without force: damping may take all of the spring's energy */
            if (!(push.normal[l] > 0)) continue;
            ++pairs->active;
            push_add(&batch, &push, l, loads);
            if (!on_roller) continue;
            on_roller[batch.roller[l]][0] -= push.total[0][l];
            on_roller[batch.roller[l]][1] -= push.total[1][l];
        }
    }
    pairs->tally = tally_total(&tally);
}

/* block (entry by entry), row i += rows of body a by columns of body b of one lane. */
static void part_add(double *const block[9], const PlanarContactMatrix *m, int l, int a, int b, int i)
{
    for (int col = 0; col < 3; ++col) {
        for (int row = 0; row < 3; ++row) block[3 * col + row][i] += m->entry[3 * b + col][3 * a + row][l];
    }
}

/* Adds one lane's derivatives to the up to four blocks of its segments. */
static void planar_matrix_add(const PlanarBatch *batch, const PlanarContactMatrix *m, int l, PlanarBlocks *out)
{
    const int j = batch->body[0][l], k = batch->body[1][l];
    if (j >= 0) part_add(out->diag, m, l, 0, 0, j);
    if (k >= 0) part_add(out->diag, m, l, 1, 1, k);
    if (j < 0 || k < 0) return;
    part_add(out->upper, m, l, 0, 1, j);
    part_add(out->lower, m, l, 1, 0, k);
}

void planar_contact_blocks(const PlanarContactModel *model, const PlanarChain *chain, const PlanarKinematics *kin,
                           double friction_scale, ContactPairs *pairs, PlanarBlocks *k, PlanarBlocks *d)
{
    const PlanarContactKernels *const kernel = planar_contact_kernels();
    PlanarBatch batch = {.impact = &model->impact, .friction_scale = friction_scale};
    PlanarContactMatrix by_shift, by_speed;
    double normal[LANES];
    hits_find(model, chain, kin, pairs);
    for (int next = 0; next < pairs->n_hits;) {
        next = batch_fill(&batch, model, chain, kin, pairs, next);
        if (!kernel->columns(&batch, &by_shift, &by_speed, normal)) continue;
        for (int l = 0; l < batch.count; ++l) {
            if (!(normal[l] > 0)) continue;
            planar_matrix_add(&batch, &by_shift, l, k);
            planar_matrix_add(&batch, &by_speed, l, d);
        }
    }
}
