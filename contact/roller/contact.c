/* The corridor of a call: hits_find (cheap, over all candidates) -> batch_fill (gathers LANES hits) -> a
 * kernel (nearest point, laws, derivatives) -> scatter, in the order of the hits. Nothing here allocates. */
#include "contact/roller/contact.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "contact/law/tally_lanes.h"
#include "contact/roller/contact_kernels.h"

/* Room was made by the refresh: a candidate is a hit at most once. */
static void hit_add(ContactPairs *pairs, ContactRange range, int element)
{
    assert(pairs->n_hits < pairs->hits_allocated);
    pairs->hit[pairs->n_hits++] = (ContactHit){range.kind, range.roller, range.face, element};
}

/* Smooth line (C11): element e owns a minimum if the slope of the gap is negative at its first node and not
 * at its second. Beyond the line's ends the slope counts as -1 and +1: the ends are minima where the gap
 * grows inward. */
static void hits_smooth(const ContactKernels *kernel, const Shape *shape, const Kinematics *kin, ContactRange range,
                        ContactPairs *pairs)
{
    double *const slope = pairs->node;
    const int n = pairs->n, end = range.first + range.count;
    const int from = range.first > 0 ? range.first - 1 : 0;
    /* nodes first - 1 .. first + count - 1, as far as they exist */
    kernel->slopes(shape, range.face, kin, from, end < n ? end : n, slope);
    /* after the kernel, which may write past the last node */
    slope[-1] = -1;
    slope[n] = 1;
    for (int e = range.first; e < end; ++e) {
        if (slope[e - 1] < 0 && slope[e] >= 0) hit_add(pairs, range, e);
    }
}

/* Capsules: every one has its own minimum, if it is near enough. */
static void hits_cylinder(const ContactKernels *kernel, const Shape *shape, const Chain *chain, const Kinematics *kin,
                          ContactRange range, ContactPairs *pairs)
{
    const int end = range.first + range.count;
    /* a capsule reaches no farther from its centre than half its length and its radius */
    kernel->distances(shape, range.face, kin, range.first, end, pairs->node);
    for (int e = range.first; e < end; ++e) {
        if (pairs->node[e] < chain->half[e] + chain->radius[e]) hit_add(pairs, range, e);
    }
}

/* All places worth a closer look, in the order of the candidates. */
static void hits_find(const ContactModel *model, const Chain *chain, const Kinematics *kin, ContactPairs *pairs)
{
    const ContactKernels *const kernel = contact_kernels();
    pairs->n_hits = 0;
    for (int i = 0; i < pairs->n_ranges; ++i) {
        const ContactRange range = pairs->range[i];
        const Shape *const shape = &model->roller[range.roller].shape;
        if (model->geometry == GEOMETRY_SMOOTH) {
            hits_smooth(kernel, shape, kin, range, pairs);
        } else {
            hits_cylinder(kernel, shape, chain, kin, range, pairs);
        }
    }
}

/* Segment i as body b of lane l; all zeros if there is no such segment. */
static void batch_body(ContactBatch *batch, const Chain *chain, const Kinematics *kin, int b, int l, int i)
{
    const int present = i >= 0 && i < chain->n;
    batch->body[b][l] = present ? i : -1;
    batch->radius[b][l] = present ? chain->radius[i] : 0;
    for (int c = 0; c < 3; ++c) {
        batch->x[b][c][l] = present ? kin->p[c][i] : 0;
        batch->r[b][c][l] = present ? chain->half[i] * kin->a[c][i] : 0;
        batch->v[b][c][l] = present ? kin->v[c][i] : 0;
        batch->w[b][c][l] = present ? kin->w[c][i] : 0;
    }
}

/* What lane l's kind of shape has beside a cylinder's numbers. */
static void batch_form(ContactBatch *batch, const Shape *shape, int l)
{
    double value[SHAPE_FORM];
    shape_form(shape, batch->face[l], value);
    for (int i = 0; i < SHAPE_FORM; ++i) batch->form[i][l] = value[i];
}

/* The roller of lane l: shape and friction law. */
static void batch_roller(ContactBatch *batch, const ContactRoller *roller, int l)
{
    const Shape *const shape = &roller->shape;
    batch_put(batch->centre, l, shape->centre);
    batch_put(batch->axis, l, shape->axis);
    batch->shape_radius[l] = shape->radius;
    batch->shape_half_width[l] = shape->half_width;
    batch->friction[l] = &roller->friction;
    if (shape->kind != SHAPE_CYLINDER) batch_form(batch, shape, l);
}

/* One hit into lane l: the weights of its element, its segments, its roller. */
static void batch_hit(ContactBatch *batch, const ContactModel *model, const Chain *chain, const Kinematics *kin,
                      ContactHit hit, int l)
{
    const Element element = element_at(model->geometry, chain->n, hit.element);
    batch->roller[l] = hit.roller;
    batch->face[l] = hit.face;
    batch->element[l] = hit.element;
    batch->arc[l] = element.arc;
    batch->alpha[l] = element.alpha;
    for (int b = 0; b < 2; ++b) {
        batch->beta[b][0][l] = element.beta[b][0];
        batch->beta[b][1][l] = element.beta[b][1];
        batch_body(batch, chain, kin, b, l, element.body[b]);
    }
    batch_roller(batch, &model->roller[hit.roller], l);
    if (!model->motion) return;
    batch_put(batch->roller_v, l, model->motion[hit.roller].v);
    batch_put(batch->roller_w, l, model->motion[hit.roller].w);
}

/* Gathers hits from `first` on, of one kind of shape and of friction; returns the first that does not fit. Lanes are
 * independent of each other, so how hits fall into batches changes nothing. */
static int batch_fill(ContactBatch *batch, const ContactModel *model, const Chain *chain, const Kinematics *kin,
                      double friction_scale, const ContactPairs *pairs, int first)
{
    batch->impact = &model->impact;
    batch->friction_scale = friction_scale;
    const int kind = pairs->hit[first].kind;
    batch->kind = (ShapeKind)(kind / FRICTION_KINDS);
    batch->rubs = friction_scale > 0 ? (FrictionKind)(kind % FRICTION_KINDS) : FRICTION_NONE;
    batch->elapsed = pairs->stick.elapsed;
    batch->presumes = pairs->presumed != NULL;
    batch->count = 1;
    while (batch->count < LANES && first + batch->count < pairs->n_hits &&
           pairs->hit[first + batch->count].kind == kind)
        ++batch->count;
    /* unused lanes repeat the last hit, so that the kernels see valid numbers; they are not scattered */
    for (int l = 0; l < LANES; ++l) {
        const int h = l < batch->count ? first + l : first + batch->count - 1;
        const ContactHit hit = pairs->hit[h];
        batch_hit(batch, model, chain, kin, hit, l);
        if (pairs->presumed) batch->presumed[l] = pairs->presumed[2 * hit.roller + hit.face];
        if (batch->rubs != FRICTION_STICK) continue;
        batch_put(batch->kept, l, stick_kept(&pairs->stick, hit.roller, hit.face, hit.element));
    }
    return first + batch->count;
}

/* The kernels that do for the batch no more than it needs. */
static ContactVariant batch_variant(const ContactModel *model, const ContactBatch *batch)
{
    const int sticks = batch->rubs == FRICTION_STICK;
    if (model->motion) return sticks ? VARIANT_MOVING_STICK : VARIANT_MOVING;
    if (sticks) return VARIANT_STICK;
    if (batch->kind != SHAPE_CYLINDER) return VARIANT_GENERAL;
    return batch->rubs == FRICTION_NONE ? VARIANT_SMOOTH : VARIANT_PLAIN;
}
static void batch_push(const ContactModel *model, const ContactBatch *batch, ContactPush *push)
{
    contact_kernels()->push[batch_variant(model, batch)](batch, push);
}

/* Whether lane l, with that normal force, takes part: a line about a presumed force may also pull (PS11). */
static int batch_counts(const ContactBatch *batch, const double normal[LANES], int l)
{
    return normal[l] > 0 || (batch->presumes && batch->presumed[l] > 0);
}

/* Adds one lane's wrench to its segments. */
static void push_add(const ContactBatch *batch, const ContactPush *push, int l, Loads *loads)
{
    for (int b = 0; b < 2; ++b) {
        if (batch->body[b][l] < 0) continue;
        loads_add(loads, batch->body[b][l], batch_at(push->force[b], l), batch_at(push->moment[b], l));
    }
}

void contact_forces(const ContactModel *model, const Chain *chain, const Kinematics *kin, double friction_scale,
                    ContactPairs *pairs, Loads *loads, Vec3 *force, RollerLoad *load)
{
    assert(!load || model->motion);
    ContactBatch batch;
    ContactPush push;
    hits_find(model, chain, kin, pairs);
    pairs->active = 0;
    TallyLanes tally = {0};
    if (force) memset(force, 0, (size_t)model->n_rollers * sizeof *force);
    if (load) memset(load, 0, (size_t)model->n_rollers * sizeof *load);
    for (int next = 0; next < pairs->n_hits;) {
        next = batch_fill(&batch, model, chain, kin, friction_scale, pairs, next);
        batch_push(model, &batch, &push);
        for (int l = 0; l < batch.count; ++l) {
            /* also what carries no force: damping may take all that the spring has */
            tally_add(&tally, push.friction, push.damping, push.energy, push.total, 3, l);
            if (!batch_counts(&batch, push.normal, l)) continue;
            /* only what carries force is added: the others' lanes are zeros */
            ++pairs->active;
            push_add(&batch, &push, l, loads);
            const int r = batch.roller[l];
            if (force) force[r] = v3_sub(force[r], batch_at(push.total, l));
            if (!load) continue;
            load[r].force = v3_sub(load[r].force, batch_at(push.total, l));
            load[r].moment = v3_add(load[r].moment, batch_at(push.roller_moment, l));
        }
    }
    pairs->tally = tally_total(&tally);
}

/* What involves the roller, the third body, of lane l. */
static RollerCoupling coupling_of(const ContactBatch *batch, const ContactMatrix *const m[2], int l)
{
    RollerCoupling c = {.roller = batch->roller[l], .body = {batch->body[0][l], batch->body[1][l]}};
    for (int kind = 0; kind < 2; ++kind) {
        for (int b = 0; b < 2; ++b) {
            matrix_part_add(m[kind], MOVING_ROWS, l, b, 2, c.into[kind][b]);
            matrix_part_add(m[kind], MOVING_ROWS, l, 2, b, c.from[kind][b]);
        }
        matrix_part_add(m[kind], MOVING_ROWS, l, 2, 2, c.own[kind]);
    }
    return c;
}

void contact_blocks(const ContactModel *model, const Chain *chain, const Kinematics *kin, double friction_scale,
                    ContactPairs *pairs, BlockChain *k, BlockChain *d, CouplingTake *take, void *user)
{
    assert(k->b == 6 && d->b == 6 && k->n == chain->n && d->n == chain->n && (!take || model->motion));
    const int rows = model->motion ? MOVING_ROWS : CONTACT_ROWS;
    ContactBatch batch;
    ContactMatrix by_shift, by_speed;
    const ContactMatrix *const both[2] = {&by_shift, &by_speed};
    double normal[LANES];
    hits_find(model, chain, kin, pairs);
    for (int next = 0; next < pairs->n_hits;) {
        next = batch_fill(&batch, model, chain, kin, friction_scale, pairs, next);
        const int done = contact_kernels()->columns[batch_variant(model, &batch)](&batch, &by_shift, &by_speed, normal);
        if (!done) continue;
        for (int l = 0; l < batch.count; ++l) {
            if (!batch_counts(&batch, normal, l)) continue;
            matrix_add(&by_shift, rows, l, batch.body[0][l], batch.body[1][l], k);
            if (done == 1) matrix_add(&by_speed, rows, l, batch.body[0][l], batch.body[1][l], d);
            if (!take) continue;
            const RollerCoupling coupling = coupling_of(&batch, both, l);
            take(user, &coupling);
        }
    }
}

/* One lane for the outside. */
static ContactDetail detail_of(const ContactBatch *batch, const ContactPush *push, int l)
{
    return (ContactDetail){.roller = batch->roller[l],
                           .face = batch->face[l],
                           .element = batch->element[l],
                           .u = push->u[l],
                           .gap = push->gap[l],
                           .normal = push->normal[l],
                           .point = batch_at(push->point, l),
                           .force = batch_at(push->total, l)};
}

int contact_details(const ContactModel *model, const Chain *chain, const Kinematics *kin, double friction_scale,
                    ContactPairs *pairs, int room, ContactDetail *out)
{
    ContactBatch batch;
    ContactPush push;
    hits_find(model, chain, kin, pairs);
    for (int next = 0, at = 0; next < pairs->n_hits;) {
        next = batch_fill(&batch, model, chain, kin, friction_scale, pairs, next);
        batch_push(model, &batch, &push);
        for (int l = 0; l < batch.count; ++l, ++at) {
            if (at < room) out[at] = detail_of(&batch, &push, l);
        }
    }
    return pairs->n_hits;
}

void contact_presume(const ContactModel *model, const Chain *chain, const Kinematics *kin, ContactPairs *pairs,
                     const Presume *how, const double *before, double *force)
{
    ContactBatch batch;
    ContactPush push;
    const double *const given = pairs->presumed;
    pairs->presumed = NULL; /* gaps alone are asked for */
    memset(force, 0, 2 * (size_t)model->n_rollers * sizeof *force);
    hits_find(model, chain, kin, pairs);
    for (int next = 0; next < pairs->n_hits;) {
        next = batch_fill(&batch, model, chain, kin, 1, pairs, next);
        batch_push(model, &batch, &push);
        for (int l = 0; l < batch.count; ++l) {
            const int face = 2 * batch.roller[l] + batch.face[l];
            const int i = batch.body[1][l] >= 0 ? batch.body[1][l] : batch.body[0][l];
            const double now =
                presume_force(how, &model->impact, before ? before[face] : 0, push.gap[l], chain->mass[i]);
            force[face] = fmax(force[face], now);
        }
    }
    pairs->presumed = given;
}

/* The contacts that carry force are looked at once more, for how far each leans. */
void contact_accept(const ContactModel *model, const Chain *chain, const Kinematics *kin, double t, ContactPairs *pairs)
{
    StickStore *const store = &pairs->stick;
    ContactBatch batch;
    ContactPush push;
    int n = 0;
    stick_clock(store, t);
    hits_find(model, chain, kin, pairs);
    for (int next = 0; next < pairs->n_hits;) {
        next = batch_fill(&batch, model, chain, kin, 1, pairs, next);
        if (batch.rubs != FRICTION_STICK) continue;
        batch_push(model, &batch, &push);
        for (int l = 0; l < batch.count; ++l) {
            if (!(push.normal[l] > 0)) continue;
            store->fresh[n++] =
                (StickRecord){batch.roller[l], batch.face[l], batch.element[l], 0, batch_at(push.kept, l)};
        }
    }
    stick_accept(store, t, n);
}
