/* Which elements can touch which roller: a tree of spheres over the chain, asked once a refresh. The chain's
 * own order is the spatial order, so the tree needs no sorting, and it knows nothing about shapes but their
 * distance. */
#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "contact/roller/contact.h"
#include "core/base/error.h"
#include "core/base/lanes.h"

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

/* Element e is a candidate of this face of a roller: it lengthens the last range or begins a new one. */
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

/* Visits the tree below `node` from left to right, so that candidates come in order; 0 if there is no memory.
 * Distances change at most as fast as points move, so a sphere that is too far rules out all that it holds.
 */
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
    /* where everything was, for contact_moved_too_far */
    line_stand(kin, pairs->n, pairs->at_p, pairs->at_a);
    return HAWSER_OK;
}

int contact_moved_too_far(const ContactModel *model, const Chain *chain, const Kinematics *kin,
                          const ContactPairs *pairs)
{
    return line_moved(chain, kin, pairs->at_p, pairs->at_a, CONTACT_USABLE * model->reach);
}

/* Whether all of a list are ranges of the model's rollers over the chain; *pairs counts their elements. */
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
