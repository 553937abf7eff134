/* The steps of a call: hits_find (cheap, over all candidates) -> batch_fill (gathers LANES hits) -> a kernel (nearest
 * point, laws, derivatives) -> scatter, in the order of the hits. Nothing here allocates. */
#include "contact/roller.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "contact/law_lanes.h"
#include "core/error.h"
#include "core/lanes.h"

/* The refresh has made room: a candidate is a hit at most once. */
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

/* Capsules: each near enough has its own minimum. */
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

/* Finds all places that need evaluation, in the order of the candidates. */
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

/* Data of lane l's shape beside those of a cylinder. */
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
    /* unused lanes repeat the last hit, so that the kernels get valid numbers; they are not scattered */
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

/* The kernels with the least work that the batch needs. */
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

/* Checks whether lane l, with that normal force, counts: a line about a presumed force may also pull (PS11). */
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
            /* also those without force: damping may take all of the spring's energy */
            tally_add(&tally, push.friction, push.damping, push.energy, push.total, 3, l);
            if (!batch_counts(&batch, push.normal, l)) continue;
            /* only contacts with force are added: the others' lanes are zeros */
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

/* Derivatives of lane l that involve the roller, the third body. */
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

/* One lane in the public form. */
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
    pairs->presumed = NULL; /* only gaps are required */
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

/* Evaluates the contacts that carry force once more to find their leans. */
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

/* Finds the elements that can touch each roller: a tree of spheres over the chain, searched once per refresh. The
 * chain's own order is the spatial order, so the tree needs no sorting; of shapes it uses only the distance. */

int contact_pairs_alloc(ContactPairs *pairs, int n)
{
    memset(pairs, 0, sizeof *pairs);
    pairs->n = n;
    int ok = sphere_tree_alloc(&pairs->tree, n) & chain_arrays_new(&pairs->node, 1, n, 0);
    ok &= chain_arrays_new(pairs->at_p, 3, n, 0) & chain_arrays_new(pairs->at_a, 3, n, 0);
    if (!ok) contact_pairs_free(pairs);
    return ok;
}

void contact_pairs_free(ContactPairs *pairs)
{
    sphere_tree_free(&pairs->tree);
    free(pairs->range);
    free(pairs->near);
    free(pairs->hit);
    stick_free(&pairs->stick);
    chain_arrays_free(&pairs->node, 1);
    chain_arrays_free(pairs->at_p, 3);
    chain_arrays_free(pairs->at_a, 3);
    memset(pairs, 0, sizeof *pairs);
}

/* One more range; 0 if there is no memory. */
static int range_add(ContactPairs *pairs, ContactRange range)
{
    if (pairs->n_ranges == pairs->ranges_allocated) {
        const int more = 2 * pairs->ranges_allocated + 16;
        ContactRange *const grown = realloc(pairs->range, (size_t)more * sizeof *grown);
        if (grown) pairs->range = grown;
        ContactRange *const near = realloc(pairs->near, (size_t)more * sizeof *near);
        if (near) pairs->near = near;
        if (!grown || !near) return 0;
        pairs->ranges_allocated = more;
    }
    assert(pairs->range);
    pairs->range[pairs->n_ranges++] = range;
    return 1;
}

/* Adds element e as a candidate of this face of a roller: it extends the last range or begins a new one. */
static int candidate_add(ContactPairs *pairs, int kind, int roller, int face, int e)
{
    ContactRange *last = pairs->n_ranges ? &pairs->range[pairs->n_ranges - 1] : NULL;
    ++pairs->candidates;
    if (last && last->roller == roller && last->face == face && last->first + last->count == e) {
        ++last->count;
        return 1;
    }
    return range_add(pairs, (ContactRange){kind, roller, face, e, 1});
}

/* Visits the tree below `node` from left to right, so that candidates come in order; 0 if there is no memory. Distances
 * change at most as fast as points move, so a sphere that is too far excludes everything inside. */
static int tree_visit(const ContactModel *model, ContactPairs *pairs, int roller, int face, int node)
{
    const Sphere *sphere = &pairs->tree.node[node];
    if (sphere->radius < 0) return 1;
    const ContactRoller *const r = &model->roller[roller];
    const double distance = shape_face_distance(&r->shape, face, sphere->centre);
    if (distance - sphere->radius > model->reach) return 1;
    if (node >= pairs->tree.leaves) {
        const int kind = contact_kind(r->shape.kind, friction_kind(&r->friction));
        return candidate_add(pairs, kind, roller, face, node - pairs->tree.leaves);
    }
    return tree_visit(model, pairs, roller, face, 2 * node) && tree_visit(model, pairs, roller, face, 2 * node + 1);
}

/* The candidates of all rollers of one kind of shape and of friction, so that each batch of the kernels finds one kind
 * only. */
static int kind_visit(const ContactModel *model, ContactPairs *pairs, ShapeKind kind, FrictionKind friction)
{
    int ok = 1;
    for (int r = 0; r < model->n_rollers && ok; ++r) {
        const ContactRoller *const roller = &model->roller[r];
        if (roller->shape.kind != kind || friction_kind(&roller->friction) != friction) continue;
        for (int face = 0; face < shape_faces(kind) && ok; ++face) ok = tree_visit(model, pairs, r, face, 1);
    }
    return ok;
}

int contact_sticks(const ContactModel *model)
{
    for (int r = 0; r < model->n_rollers; ++r) {
        if (friction_kind(&model->roller[r].friction) == FRICTION_STICK) return 1;
    }
    return 0;
}

/* Room for the largest number of hits that the candidates can give. */
static int hits_reserve(ContactPairs *pairs)
{
    if (pairs->candidates <= pairs->hits_allocated) return 1;
    assert(pairs->candidates > 0);
    ContactHit *grown = realloc(pairs->hit, (size_t)pairs->candidates * sizeof *grown);
    if (!grown) return 0;
    pairs->hit = grown;
    pairs->hits_allocated = pairs->candidates;
    return 1;
}

void contact_widen(ContactPairs *pairs)
{
    pairs->n_near = pairs->n_ranges;
    if (pairs->n_ranges > 0) memcpy(pairs->near, pairs->range, (size_t)pairs->n_ranges * sizeof *pairs->near);
}

hawser_status contact_refresh(const ContactModel *model, const Chain *chain, const Kinematics *kin, ContactPairs *pairs,
                              hawser_error *err)
{
    assert(chain->n == pairs->n);
    /* candidates, kind by kind and roller by roller */
    pairs->n_ranges = pairs->candidates = 0;
    sphere_tree_build(&pairs->tree, model->geometry, chain, kin);
    for (int kind = 0; kind < SHAPE_KINDS * FRICTION_KINDS; ++kind) {
        const ShapeKind shape = (ShapeKind)(kind / FRICTION_KINDS);
        if (!kind_visit(model, pairs, shape, (FrictionKind)(kind % FRICTION_KINDS))) return error_memory(err);
    }
    contact_widen(pairs);
    if (!hits_reserve(pairs)) return error_memory(err);
    if (contact_sticks(model) && !stick_reserve(&pairs->stick, model->n_rollers, pairs->hits_allocated)) {
        return error_memory(err);
    }
    /* positions for contact_moved_too_far */
    line_stand(kin, pairs->n, pairs->at_p, pairs->at_a);
    return HAWSER_OK;
}

int contact_moved_too_far(const ContactModel *model, const Chain *chain, const Kinematics *kin,
                          const ContactPairs *pairs)
{
    return line_moved(chain, kin, pairs->at_p, pairs->at_a, CONTACT_USABLE * model->reach);
}

/* Checks whether all of a list are ranges of the model's rollers over the chain; *pairs counts their elements. */
static int ranges_are(const ContactModel *model, const ContactRange *range, int n, int segments, long *pairs)
{
    const int elements = element_count(model->geometry, segments);
    *pairs = 0;
    for (int i = 0; i < n; ++i) {
        const ContactRange *const r = &range[i];
        if (r->roller < 0 || r->roller >= model->n_rollers) return 0;
        const ContactRoller *const roller = &model->roller[r->roller];
        if (r->face < 0 || r->face >= shape_faces(roller->shape.kind)) return 0;
        if (r->kind != contact_kind(roller->shape.kind, friction_kind(&roller->friction))) return 0;
        if (r->first < 0 || r->count < 0 || r->first > elements - r->count) return 0;
        *pairs += r->count;
    }
    return 1;
}

/* Both lists of ranges have room for as many. */
static void ranges_checkpoint(Checkpoint *c, ContactPairs *pairs)
{
    int room = pairs->ranges_allocated, near = pairs->ranges_allocated;
    checkpoint_list(c, "pairs->range", (void **)&pairs->range, &pairs->n_ranges, &room, sizeof *pairs->range);
    if (room > near) {
        ContactRange *const grown = realloc(pairs->near, (size_t)room * sizeof *grown);
        if (grown) pairs->near = grown;
        if (!grown) checkpoint_lack(c);
        near = room;
    }
    checkpoint_list(c, "pairs->near", (void **)&pairs->near, &pairs->n_near, &near, sizeof *pairs->near);
    pairs->ranges_allocated = room;
    checkpoint_check(c, pairs->n_near <= pairs->n_ranges, "more candidates are near than there are");
}

void contact_pairs_checkpoint(Checkpoint *c, const ContactModel *model, ContactPairs *pairs)
{
    ranges_checkpoint(c, pairs);
    CHECKPOINT(c, pairs->candidates);
    CHECKPOINT(c, pairs->active);
    CHECKPOINT(c, pairs->tally);
    chain_arrays_checkpoint(c, "pairs->at_p", pairs->at_p, 3, pairs->n);
    chain_arrays_checkpoint(c, "pairs->at_a", pairs->at_a, 3, pairs->n);
    if (c->status) return;
    long pairs_all, pairs_near;
    const int ok = ranges_are(model, pairs->range, pairs->n_ranges, pairs->n, &pairs_all) &&
                   ranges_are(model, pairs->near, pairs->n_near, pairs->n, &pairs_near) && pairs_near <= pairs_all &&
                   pairs->candidates == pairs_all;
    if (!checkpoint_check(c, ok, "candidates for contact are impossible")) return;
    if (c->reading && !hits_reserve(pairs)) checkpoint_lack(c);
    if (contact_sticks(model)) stick_checkpoint(c, &pairs->stick, model->n_rollers, pairs->hits_allocated);
}
