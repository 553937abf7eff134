/* Which stretches of the cable may touch each other before the next refresh, and which blocks of Newton's matrix that
 * takes. The tree of spheres is asked for every element what comes near it farther along. */
#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "contact/self/self_contact.h"
#include "contact/self/self_overlap.h"
#include "core/base/error.h"

enum { PIECES_MAX = 8 };

int self_skip(const Chain *chain)
{
    /* bodies of the two elements must not be neighbours: three at least */
    double radius = 0, shortest = INFINITY;
    for (int i = 0; i < chain->n; ++i) {
        radius = fmax(radius, chain->radius[i]);
        shortest = fmin(shortest, 2 * chain->half[i]);
    }
    const double around = 3.14159265358979323846 * radius / shortest;
    return around < chain->n ? (int)ceil(around) + 2 : chain->n + 2;
}

int self_pieces(const Chain *chain, int e)
{
    double length = 0, radius = INFINITY;
    for (int i = e - 1; i <= e; ++i) {
        if (i < 0 || i >= chain->n) continue;
        length += chain->half[i];
        radius = fmin(radius, chain->radius[i]);
    }
    const double pieces = ceil(length / (2 * radius));
    return pieces > PIECES_MAX ? PIECES_MAX : pieces < 1 ? 1 : (int)pieces;
}

int self_pairs_alloc(SelfPairs *pairs, int lines, const int *segments)
{
    memset(pairs, 0, sizeof *pairs);
    pairs->tree = calloc((size_t)lines, sizeof *pairs->tree);
    int ok = pairs->tree != NULL;
    for (int l = 0; ok && l < lines; ++l) {
        pairs->n += segments[l];
        ok = sphere_tree_alloc(&pairs->tree[pairs->n_trees++], segments[l]);
    }
    ok &= block_extras_alloc(&pairs->extras, pairs->n);
    ok &= chain_arrays_new(pairs->at_p, 3, pairs->n, 0) & chain_arrays_new(pairs->at_a, 3, pairs->n, 0);
    if (!ok) self_pairs_free(pairs);
    return ok;
}

void self_pairs_free(SelfPairs *pairs)
{
    for (int l = 0; l < pairs->n_trees; ++l) sphere_tree_free(&pairs->tree[l]);
    free(pairs->tree);
    block_extras_free(&pairs->extras);
    chain_arrays_free(pairs->at_p, 3);
    chain_arrays_free(pairs->at_a, 3);
    free(pairs->range);
    for (int p = 0; p < SELF_PARTS; ++p) {
        free(pairs->hit[p]);
        free(pairs->clear[p].gap);
        free(pairs->clear[p].at);
    }
    memset(pairs, 0, sizeof *pairs);
}

/* Where a line's part of what was taken down begins: three centres, three axes. */
static void places_of(const SelfPairs *pairs, const SelfLine *line, double *at[6])
{
    for (int c = 0; c < 3; ++c) {
        at[c] = pairs->at_p[c] + line->row;
        at[3 + c] = pairs->at_a[c] + line->row;
    }
}

double self_radius_most(const Chain *chain, int from, int to)
{
    double radius = 0;
    for (int i = from < 0 ? 0 : from; i <= to && i < chain->n; ++i) radius = fmax(radius, chain->radius[i]);
    return radius;
}

/* Length of an element at rest, m. */
static double element_length(const Chain *chain, int e)
{
    return (e > 0 ? chain->half[e - 1] : 0) + (e < chain->n ? chain->half[e] : 0);
}

double self_piece_length(const Chain *chain, int e) { return element_length(chain, e) / self_pieces(chain, e); }

double self_feet_apart(const SelfLine *mine, const SelfLine *other, const SelfRange *range)
{
    /* half as much again as the piece is long: less than the half turn that brings another strand, for pieces are no
     * longer than the line is thick, and an element but for those that are shorter than that */
    static const double most = 1.5;
    double shortest = INFINITY;
    for (int f = range->first; f < range->first + range->count; ++f)
        shortest = fmin(shortest, element_length(other->chain, f));
    return fmax(1, most * self_piece_length(mine->chain, range->element) / shortest);
}

/* Element f of line `other` is a candidate of element e: it lengthens the last range or begins a new one. A hole of one
 * element is filled, so that the feet of neighbouring ends find each other. 0 if there is no memory. */
static int candidate_add(SelfPairs *pairs, int line, int e, int other, int f)
{
    SelfRange *const last = pairs->n_ranges ? &pairs->range[pairs->n_ranges - 1] : NULL;
    const int same = last && last->line == line && last->element == e && last->other == other;
    if (same && f <= last->first + last->count + 1) {
        last->count = f - last->first + 1;
        return 1;
    }
    if (pairs->n_ranges == pairs->ranges_allocated) {
        const int more = 2 * pairs->ranges_allocated + 16;
        SelfRange *const grown = realloc(pairs->range, (size_t)more * sizeof *grown);
        if (!grown) return 0;
        pairs->range = grown;
        pairs->ranges_allocated = more;
    }
    pairs->range[pairs->n_ranges++] = (SelfRange){line, e, other, f, 1};
    return 1;
}

/* The chord of an element and how far its arc bulges from it. */
typedef struct Bow {
    Chord chord;
    double bulge; /* m */
} Bow;

static Bow bow_of(const Chain *chain, const Kinematics *kin, int e)
{
    const Vec3 a = line_spot(chain, kin, e, 0).p, b = line_spot(chain, kin, e, 1).p;
    const Vec3 middle = line_spot(chain, kin, e, 0.5).p;
    /* the arc is a parabola while its joint is closed; a tenth more for joints that are not */
    return (Bow){{a, v3_sub(b, a)}, 1.1 * v3_norm(v3_sub(middle, v3_scale(0.5, v3_add(a, b))))};
}

/* What one walk through a line's tree asks for: its elements from `from` on near an element of a line. */
typedef struct Walk {
    SelfPairs *pairs;
    const SelfLine *onto; /* whose tree it is */
    int line, element, other, from;
    int eye, last; /* of the element's line: its eye, its last element */
    double reach;
    Bow bow;       /* of the element */
    double radius; /* m, its contact radius, the larger */
} Walk;

/* The largest contact radius of an element. */
static double element_radius_most(const Chain *chain, int e)
{
    return fmax(e > 0 ? chain->radius[e - 1] : 0, e < chain->n ? chain->radius[e] : 0);
}

/* Whether the surfaces of the walk's element and of f may be nearer than the reach. */
static int element_near(const Walk *w, int f)
{
    const Bow other = bow_of(w->onto->chain, w->onto->kin, f);
    const double bulges = w->bow.bulge + other.bulge, radii = w->radius + element_radius_most(w->onto->chain, f);
    return chords_apart(&w->bow.chord, &other.chord) - bulges - radii <= w->reach;
}

/* Whether the walk's element and f are the heads' ends that one eye holds (SC9). */
static int held_apart(const Walk *w, int f)
{
    return w->onto->eye > 0 && w->eye == w->onto->eye && w->element == w->last && f == w->onto->chain->n;
}

/* Visits the tree below `node`, which holds `width` leaves from `first` on; 0 if there is no memory. */
static int walk(const Walk *w, int node, int first, int width)
{
    const SphereTree *const tree = &w->pairs->tree[w->other], *const own = &w->pairs->tree[w->line];
    const Sphere *const sphere = &tree->node[node], *const mine = &own->node[own->leaves + w->element];
    if (first + width <= w->from || sphere->radius < 0) return 1;
    const double apart = v3_norm(v3_sub(sphere->centre, mine->centre)) - sphere->radius - mine->radius;
    if (apart > w->reach) return 1;
    if (width == 1 && held_apart(w, first)) return 1;
    if (width == 1) return !element_near(w, first) || candidate_add(w->pairs, w->line, w->element, w->other, first);
    return walk(w, 2 * node, first, width / 2) && walk(w, 2 * node + 1, first + width / 2, width / 2);
}

/* Room for what is known of gaps, of which nothing is known of new ranges. */
static int clear_reserve(SelfPairs *pairs)
{
    for (int p = 0; p < SELF_PARTS; ++p) {
        SelfClear *const clear = &pairs->clear[p];
        clear->known = clear->vain = 0;
        if (!clear->at) clear->at = malloc(6 * (size_t)pairs->n * sizeof *clear->at);
        if (!clear->at) return 0;
        if (pairs->n_ranges <= clear->allocated) continue;
        double *const grown = realloc(clear->gap, (size_t)pairs->n_ranges * sizeof *grown);
        if (!grown) return 0;
        clear->gap = grown;
        clear->allocated = pairs->n_ranges;
    }
    return 1;
}

/* The halves, and rooms for the hits of a range: a node of a piece has at most one foot on an element. */
static int hits_reserve(const SelfLines *lines, SelfPairs *pairs)
{
    int needed = 0, seen = 0;
    pairs->candidates = 0;
    for (int r = 0; r < pairs->n_ranges; ++r) pairs->candidates += pairs->range[r].count;
    pairs->half = 0;
    for (int r = 0; r < pairs->n_ranges; ++r) {
        const SelfRange *const range = &pairs->range[r];
        const int most = range->count * self_pieces(lines->line[range->line].chain, range->element);
        if (2 * seen < pairs->candidates) pairs->half = r + 1;
        needed = most > needed ? most : needed;
        seen += range->count;
    }
    if (!clear_reserve(pairs)) return 0;
    if (needed <= pairs->hits_allocated) return 1;
    assert(needed > 0);
    for (int p = 0; p < SELF_PARTS; ++p) {
        SelfHit *const grown = realloc(pairs->hit[p], (size_t)needed * sizeof *grown);
        if (!grown) return 0;
        pairs->hit[p] = grown;
    }
    pairs->hits_allocated = needed;
    return 1;
}

/* One coupling of segment i of a line with segment j of the same or a later one, if both exist and are no neighbours in
 * it; returns the new count. */
static int pair_add(BlockPair *pair, int count, const SelfLine *line, int i, const SelfLine *other, int j)
{
    const int neighbours = line == other && j - i < 2;
    if (i < 0 || i >= line->chain->n || j < 0 || j >= other->chain->n || neighbours) return count;
    pair[count] = (BlockPair){line->row + i, other->row + j};
    return count + 1;
}

/* The largest number of segments from one to another on which the two feet of a piece bear. */
static int feet_span(const SelfLines *lines, const SelfRange *range)
{
    const double apart = self_feet_apart(&lines->line[range->line], &lines->line[range->other], range);
    return apart < range->count ? (int)ceil(apart) + 1 : range->count;
}

/* All blocks that the candidates may fill: piece against feet, and one end's foot against the other's (CC19); NULL
 * without memory. */
static BlockPair *pattern_list(const SelfLines *lines, const SelfPairs *pairs, int *n)
{
    size_t most = (size_t)pairs->n_beside + 1;
    for (int r = 0; r < pairs->n_ranges; ++r)
        most += (size_t)pairs->range[r].count * (size_t)(3 + feet_span(lines, &pairs->range[r]));
    BlockPair *const pair = malloc(most * sizeof *pair);
    int count = pairs->n_beside;
    if (pair && count > 0) memcpy(pair, pairs->beside, (size_t)count * sizeof *pair);
    for (int r = 0; pair && r < pairs->n_ranges; ++r) {
        const SelfRange *const range = &pairs->range[r];
        const SelfLine *const mine = &lines->line[range->line], *const other = &lines->line[range->other];
        const int span = feet_span(lines, range);
        for (int f = range->first; f < range->first + range->count; ++f) {
            for (int b = 0; b < 4; ++b)
                count = pair_add(pair, count, mine, range->element - 1 + b % 2, other, f - 1 + b / 2);
            for (int by = 2; by <= span && f - by >= range->first - 1; ++by)
                count = pair_add(pair, count, other, f - by, other, f);
        }
    }
    *n = count;
    return pair;
}

static int pattern_set(const SelfLines *lines, SelfPairs *pairs)
{
    int n;
    BlockPair *const pair = pattern_list(lines, pairs, &n);
    const int ok = pair && block_extras_set(&pairs->extras, n, pair);
    free(pair);
    return ok;
}

/* A pattern that was read must have a place for each of them. */
static void pattern_check(Checkpoint *c, const SelfLines *lines, const SelfPairs *pairs)
{
    int n, holds = 1;
    BlockPair *const pair = pattern_list(lines, pairs, &n);
    if (!pair) checkpoint_lack(c);
    for (int i = 0; pair && holds && i < n; ++i)
        holds = block_extras_find(&pairs->extras, pair[i].low, pair[i].high) >= 0 &&
                block_extras_find(&pairs->extras, pair[i].high, pair[i].low) >= 0;
    free(pair);
    if (!c->status) checkpoint_check(c, holds, "candidates of cable on cable have no place in the matrix");
}

/* What comes near the elements of a line: farther along itself, and of the lines after it; 0 if there is no memory. */
static int line_walk(const SelfModel *model, const SelfLines *lines, int line, SelfPairs *pairs)
{
    const SelfLine *const mine = &lines->line[line];
    const Chain *const chain = mine->chain;
    const int elements = element_count(GEOMETRY_SMOOTH, chain->n);
    const int skip = lines->within ? self_skip(chain) : elements;
    for (int e = 0; e < elements; ++e) {
        if (e + skip >= elements && line + 1 == lines->n) break;
        /* the far end of a pressed piece has its foot within the piece's length of it */
        Walk w = {.pairs = pairs, .line = line, .element = e, .eye = mine->eye, .last = chain->n};
        w.radius = element_radius_most(chain, e);
        w.reach = model->reach + 1.25 * self_piece_length(chain, e);
        w.bow = bow_of(chain, mine->kin, e);
        for (w.other = line; w.other < lines->n; ++w.other) {
            w.onto = &lines->line[w.other];
            w.from = w.other == line ? e + skip : 0;
            if (w.other == line && w.from >= elements) continue;
            if (!walk(&w, 1, 0, pairs->tree[w.other].leaves)) return 0;
        }
    }
    return 1;
}

hawser_status self_refresh(const SelfModel *model, const SelfLines *lines, SelfPairs *pairs, hawser_error *err)
{
    int ok = 1;
    assert(lines->n == pairs->n_trees);
    for (int l = 0; l < lines->n; ++l)
        sphere_tree_build(&pairs->tree[l], GEOMETRY_SMOOTH, lines->line[l].chain, lines->line[l].kin);
    pairs->n_ranges = 0;
    for (int l = 0; model->present && ok && l < lines->n; ++l) ok = line_walk(model, lines, l, pairs);
    if (!ok || !hits_reserve(lines, pairs) || !pattern_set(lines, pairs)) return error_memory(err);
    for (int l = 0; l < lines->n; ++l) {
        double *at[6];
        places_of(pairs, &lines->line[l], at);
        line_stand(lines->line[l].kin, lines->line[l].chain->n, at, at + 3);
    }
    return HAWSER_OK;
}

/* Both lines may have moved, so each has half of the reach; a quarter is kept in hand for the motion within a step. */
int self_moved_too_far(const SelfModel *model, const SelfLines *lines, const SelfPairs *pairs)
{
    int far = 0;
    for (int l = 0; l < lines->n; ++l) {
        double *at[6];
        places_of(pairs, &lines->line[l], at);
        far |= line_moved(lines->line[l].chain, lines->line[l].kin, at, at + 3, 0.75 * model->reach / 2);
    }
    return far;
}

static int range_is(const SelfLines *lines, const SelfRange *r)
{
    if (r->line < 0 || r->line >= lines->n || r->other < 0 || r->other >= lines->n) return 0;
    const int n = element_count(GEOMETRY_SMOOTH, lines->line[r->line].chain->n),
              m = element_count(GEOMETRY_SMOOTH, lines->line[r->other].chain->n);
    return r->element >= 0 && r->element < n && r->first >= 0 && r->count >= 0 && r->first <= m - r->count;
}

void self_pairs_checkpoint(Checkpoint *c, const SelfLines *lines, SelfPairs *pairs)
{
    checkpoint_list(c, "pairs->range", (void **)&pairs->range, &pairs->n_ranges, &pairs->ranges_allocated,
                    sizeof *pairs->range);
    for (int i = 0; !c->status && i < pairs->n_ranges; ++i)
        checkpoint_check(c, range_is(lines, &pairs->range[i]), "candidates of cable on cable are impossible");
    CHECKPOINT(c, pairs->active);
    CHECKPOINT(c, pairs->work);
    chain_arrays_checkpoint(c, "pairs->at_p", pairs->at_p, 3, pairs->n);
    chain_arrays_checkpoint(c, "pairs->at_a", pairs->at_a, 3, pairs->n);
    block_extras_checkpoint(c, &pairs->extras);
    if (c->reading && !c->status) pattern_check(c, lines, pairs);
    if (c->reading && !c->status && !hits_reserve(lines, pairs)) checkpoint_lack(c); /* and the halves */
}
