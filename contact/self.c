/* From two lines to forces: geometry and motion of the piece's ends, the bed's integral, the laws, the shares of the
 * segments. The derivatives of the same steps follow below. */
#include "contact/self.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"

/* The slot of a segment on a side; a new one if it has none yet. */
static PatchSlot *slot_of(Patch *patch, const SelfLine *line, int body, int side)
{
    for (int s = 0; s < patch->slots; ++s) {
        if (patch->slot[s].body == body && patch->slot[s].side == side) return &patch->slot[s];
    }
    PatchSlot *const slot = &patch->slot[patch->slots++];
    *slot = (PatchSlot){.body = body, .side = side};
    slot->r = v3_scale(line->chain->half[body], v3_load(line->kin->a, body));
    slot->w = v3_load(line->kin->w, body);
    return slot;
}

/* Assigns one spot's segments to slots; returns its velocity, with the derivative by the parameter, and its angular
 * velocity. */
static void spot_take(Patch *patch, const SelfLine *line, const LineSpot *spot, int side, int a)
{
    const double sign = side ? -1 : 1;
    for (int b = 0; b < 2; ++b) {
        const int i = spot->body[b];
        if (i < 0 || i >= line->chain->n) continue;
        PatchSlot *const slot = slot_of(patch, line, i, side);
        slot->alpha[a] = spot->weight.alpha[b];
        slot->beta[a] = spot->weight.beta[b];
        const Vec3 v = v3_load(line->kin->v, i), turned = v3_cross(slot->w, slot->r);
        patch->speed[a] = v3_axpy(v3_axpy(patch->speed[a], sign * slot->alpha[a], v), sign * slot->beta[a], turned);
        patch->omega[side][a] = v3_axpy(patch->omega[side][a], slot->alpha[a], slot->w);
        if (side == 0) continue;
        slot->alpha1[a] = spot->weight1.alpha[b];
        slot->beta1[a] = spot->weight1.beta[b];
        patch->speed1[a] = v3_axpy(v3_axpy(patch->speed1[a], -slot->alpha1[a], v), -slot->beta1[a], turned);
        patch->omega1[a] = v3_axpy(patch->omega1[a], slot->alpha1[a], slot->w);
    }
}

/* Relative motion of the surfaces at the centre of the pressed part (CC9), (CC10). */
static void slip_find(Patch *p)
{
    const double xi = p->centre;
    p->spin = v3(0, 0, 0);
    for (int side = 0; side < 2; ++side) {
        p->spin = v3_axpy(p->spin, p->share[side] * (1 - xi), p->omega[side][0]);
        p->spin = v3_axpy(p->spin, p->share[side] * xi, p->omega[side][1]);
    }
    p->slip = v3_sub(p->drift, v3_cross(p->spin, p->arm));
    p->slide = v3_reject(p->slip, p->normal);
}

/* Damping and friction on top of the bed's elastic forces (CC7)-(CC11). */
static void laws_apply(Patch *p, const PatchLaw *law, double friction_scale)
{
    const double xi = p->centre;
    p->arm = v3_axpy(v3_scale(1 - xi, p->w[0]), xi, p->w[1]);
    p->distance = v3_norm(p->arm);
    p->normal = v3_unit(p->arm);
    p->drift = v3_axpy(v3_scale(1 - xi, p->speed[0]), xi, p->speed[1]);
    p->rate = v3_dot(p->normal, p->drift);
    const double damped = 1 - law->dissipation * p->rate;
    p->damped = damped > 0 ? damped : 0;
    p->force = p->damped * p->elastic;
    slip_find(p);
    p->phi = friction_scale * friction_over_speed(&law->friction, v3_norm(p->slide), &p->phi_over);
    p->phi_over *= friction_scale;
    p->friction = v3_scale(-p->force * p->phi, p->slide);
    p->couple = v3_cross(p->friction, p->arm);
    p->on[0] = v3_axpy(v3_scale(p->damped, p->g[0]), 1 - xi, p->friction);
    p->on[1] = v3_axpy(v3_scale(p->damped, p->g[1]), xi, p->friction);
}

/* The piece (length m at rest) of the line side[0] between two ends with their feet on side[1], which may be the same
 * line. Returns 0 without contact: then only the geometry is filled in. */
static int patch_at(const SelfLine *const side[2], const PatchLaw *law, double friction_scale, double length,
                    const PatchEnd end[2], Patch *patch)
{
    const SelfLine *const other = side[1];
    *patch = (Patch){.length = length};
    double radius[2] = {0, 0};
    for (int a = 0; a < 2; ++a) {
        const LineSpot *const here = &end[a].here, *const there = &end[a].there;
        const int held = end[a].v <= 0 && end[a].foot == 0;
        const int held_head = end[a].v >= 1 && end[a].foot == other->chain->n;
        spot_take(patch, side[0], here, 0, a);
        spot_take(patch, other, there, 1, a);
        patch->w[a] = v3_sub(here->p, there->p);
        patch->foot1[a] = there->p1;
        patch->curvature[a] = held || held_head ? 0 : v3_dot(there->p1, there->p1) - v3_dot(patch->w[a], there->p2);
        patch->radius1[a] = there->radius1;
        radius[0] += here->radius / 2;
        radius[1] += there->radius / 2;
    }
    patch->radius = radius[0] + radius[1];
    for (int s = 0; s < 2; ++s) patch->share[s] = radius[s] / patch->radius;
    if (!bed_integrate(patch, law)) return 0;
    laws_apply(patch, law, friction_scale);
    return patch->force > 0;
}

/* (CC12): forces at the two ends by the weights, the friction's couple with the rotation's weights. */
static PatchWrench patch_wrench(const Patch *p, int s)
{
    const PatchSlot *const slot = &p->slot[s];
    const double sign = slot->side ? -1 : 1, part[2] = {1 - p->centre, p->centre};
    PatchWrench out = {{0, 0, 0}, {0, 0, 0}};
    for (int a = 0; a < 2; ++a) {
        out.force = v3_axpy(out.force, sign * slot->alpha[a], p->on[a]);
        out.moment = v3_axpy(out.moment, sign * slot->beta[a], v3_cross(slot->r, p->on[a]));
        out.moment = v3_axpy(out.moment, slot->alpha[a] * part[a] * p->share[slot->side], p->couple);
    }
    return out;
}

/* |w| is least at an end of the piece or where its slope vanishes. */
static double patch_depth(const Patch *p)
{
    const Vec3 along = v3_sub(p->w[1], p->w[0]);
    const double b = v3_dot(p->w[0], along), a = v3_dot(along, along);
    const double xi = b >= 0 || a <= 0 ? 0 : fmin(1, -b / a);
    return p->radius - v3_norm(v3_axpy(p->w[0], xi, along));
}

/* Half a turn about the line's own surface, in radii: a cable that is bent that sharply touches itself. */
static const double HALF_TURN = 3.14159265358979323846;

/* Search for the segments of one line near segment i of another one, or of the same. */
typedef struct Search {
    const SelfLine *mine, *other;
    int i, first;    /* on the other line, the segments from `first` on */
    double longest;  /* m: of the other's half segments */
    double stride;   /* m: the largest distance of two neighbours' centres there */
    double thickest; /* m: its largest radius */
} Search;

static Chord segment_chord(const SelfLine *line, int i)
{
    const double half = line->chain->half[i];
    const Vec3 axis = v3_load(line->kin->a, i);
    return (Chord){v3_axpy(v3_load(line->kin->p, i), -half, axis), v3_scale(2 * half, axis)};
}

/* Follows the other line and skips stretches that cannot be near. */
static void search(const Search *s, SelfOverlap *deepest)
{
    const Chain *const mine = s->mine->chain, *const other = s->other->chain;
    const Chord chord = segment_chord(s->mine, s->i);
    const Vec3 here = v3_load(s->mine->kin->p, s->i);
    const double reach = mine->half[s->i] + s->longest + mine->radius[s->i] + s->thickest;
    for (int j = s->first; j < other->n;) {
        const double free = v3_norm(v3_sub(v3_load(s->other->kin->p, j), here)) - reach;
        if (free > 0) {
            const double skip = free / s->stride;
            j += skip > 1 && skip < other->n ? (int)skip : 1;
            continue;
        }
        const Chord there = segment_chord(s->other, j);
        const double share = 1 - chords_apart(&chord, &there) / (mine->radius[s->i] + other->radius[j]);
        if (share > deepest->share) {
            deepest->share = share;
            deepest->segment = s->i;
            deepest->opposite = j;
            deepest->at = here;
        }
        ++j;
    }
}

/* First segment behind i of the same line that may touch it: there is half a turn between their ends. */
static int first_behind(const Chain *chain, int i)
{
    double between = 0;
    int j = i + 2;
    for (; j < chain->n; ++j) {
        between += 2 * chain->half[j - 1];
        if (between >= HALF_TURN * fmax(chain->radius[i], chain->radius[j])) break;
    }
    return j;
}

/* Checks whether the last segments of both lines are held by one eye: they meet there. */
static int share_eye(const SelfLine *a, const SelfLine *b) { return a->eye > 0 && a->eye == b->eye; }

static void lines_search(const SelfLines *lines, int l, int m, SelfOverlap *deepest)
{
    const SelfLine *const mine = &lines->line[l], *const other = &lines->line[m];
    SelfOverlap of = *deepest;
    Search s = {.mine = mine, .other = other};
    for (int j = 0; j < other->chain->n; ++j) {
        const Vec3 here = v3_load(other->kin->p, j);
        if (j > 0) s.stride = fmax(s.stride, v3_norm(v3_sub(here, v3_load(other->kin->p, j - 1))));
        s.longest = fmax(s.longest, other->chain->half[j]);
        s.thickest = fmax(s.thickest, other->chain->radius[j]);
    }
    const int last = mine->chain->n - (l != m && share_eye(mine, other));
    for (s.i = 0; s.i < last; ++s.i) {
        s.first = l == m ? first_behind(mine->chain, s.i) : 0;
        search(&s, &of);
    }
    if (!(of.share > deepest->share)) return;
    *deepest = of;
    deepest->line = l;
    deepest->other = m;
}

SelfOverlap self_overlap(const SelfLines *lines)
{
    SelfOverlap deepest = {.share = -INFINITY, .line = -1, .other = -1};
    for (int l = 0; l < lines->n; ++l) {
        for (int m = lines->within ? l : l + 1; m < lines->n; ++m) lines_search(lines, l, m, &deepest);
    }
    return deepest;
}

/* The part of [0, 1] where |w| < R (CC4): between the roots of a xi^2 + 2 b xi + c. Returns 0 if there is none. */
static int pressed_part(Patch *p)
{
    const Vec3 along = v3_sub(p->w[1], p->w[0]);
    const double a = v3_dot(along, along), b = v3_dot(p->w[0], along);
    const double c = v3_dot(p->w[0], p->w[0]) - p->radius * p->radius;
    p->from = 0;
    p->to = 1;
    /* parallel to rounding: pressed everywhere or nowhere */
    if (a <= 1e-24 * p->radius * p->radius) return c < 0;
    const double root = b * b - a * c;
    if (!(root > 0)) return 0;
    /* the root that adds up first, the other from their product */
    const double sum = b >= 0 ? -b - sqrt(root) : -b + sqrt(root);
    const double one = sum / a, other = sum != 0 ? c / sum : 0;
    p->from = fmax(0, fmin(one, other));
    p->to = fmin(1, fmax(one, other));
    return p->from < p->to;
}

/* Separation at xi. */
static Vec3 separation(const Vec3 w[2], double xi) { return v3_axpy(v3_scale(1 - xi, w[0]), xi, w[1]); }

int bed_integrate(Patch *p, const PatchLaw *law)
{
    if (!pressed_part(p)) return 0;
    p->modulus = law->bed * p->length / (p->radius * sqrt(p->radius));
    for (int k = 0; k < BED_POINTS; ++k) {
        const double xi = p->from + (p->to - p->from) * BED_AT[k];
        const Vec3 w = separation(p->w, xi);
        const double q = (p->radius * p->radius - v3_dot(w, w)) / (2 * p->radius);
        const double share = BED_WEIGHT[k] * (p->to - p->from) * q;
        p->m0 += share;
        p->m1 += share * xi;
        p->energy += p->modulus * p->radius / 2 * share * q;
        p->g[0] = v3_axpy(p->g[0], p->modulus * share * (1 - xi), w);
        p->g[1] = v3_axpy(p->g[1], p->modulus * share * xi, w);
    }
    if (!(p->m0 > 1e-30)) return 0;
    p->centre = p->m1 / p->m0;
    p->elastic = v3_norm(v3_add(p->g[0], p->g[1]));
    return p->elastic > 0;
}

/* Finds stretches of the cable that may touch each other before the next refresh, and the blocks of Newton's matrix for
 * them. The tree of spheres is searched for what comes near each element farther along. */

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

/* Beginning of a line's part of the stored places: three centres, three axes. */
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

/* Largest distance, in elements of a range and at least one, between the feet of a piece's two ends. */
static double self_feet_apart(const SelfLine *mine, const SelfLine *other, const SelfRange *range)
{
    /* one and a half times the length of the piece, at least one element: less than the half turn to another strand,
     * since pieces are no longer than the line is thick */
    static const double most = 1.5;
    double shortest = INFINITY;
    for (int f = range->first; f < range->first + range->count; ++f)
        shortest = fmin(shortest, element_length(other->chain, f));
    return fmax(1, most * self_piece_length(mine->chain, range->element) / shortest);
}

/* Adds element f of line `other` as a candidate of element e: it extends the last range or begins a new one. A gap of
 * one element is filled, so that the feet of neighbouring ends find each other. 0 if there is no memory. */
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

/* The chord of an element and the largest distance of its arc from it. */
typedef struct Bow {
    Chord chord;
    double bulge; /* m */
} Bow;

static Bow bow_of(const Chain *chain, const Kinematics *kin, int e)
{
    const Vec3 a = line_spot(chain, kin, e, 0).p, b = line_spot(chain, kin, e, 1).p;
    const Vec3 middle = line_spot(chain, kin, e, 0.5).p;
    /* the arc is a parabola while its joint is closed; ten per cent are added for joints that are not */
    return (Bow){{a, v3_sub(b, a)}, 1.1 * v3_norm(v3_sub(middle, v3_scale(0.5, v3_add(a, b))))};
}

/* Parameters of one walk through a line's tree: finds its elements from `from` on near an element of a line. */
typedef struct Walk {
    SelfPairs *pairs;
    const SelfLine *onto; /* line of the tree */
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

/* Checks whether the surfaces of the walk's element and of f may be nearer than the reach. */
static int element_near(const Walk *w, int f)
{
    const Bow other = bow_of(w->onto->chain, w->onto->kin, f);
    const double bulges = w->bow.bulge + other.bulge, radii = w->radius + element_radius_most(w->onto->chain, f);
    return chords_apart(&w->bow.chord, &other.chord) - bulges - radii <= w->reach;
}

/* Checks whether the walk's element and f are ends of heads that one eye holds (SC9). */
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

/* Makes room for the gaps; those of new ranges are not known. */
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

/* Sets the halves, and makes room for the hits of a range: a node of a piece has at most one foot on an element. */
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

/* Adds a coupling of segment i of a line with segment j of the same or a later one, if both exist and are not
 * neighbours in it; returns the new count. */
static int pair_add(BlockPair *pair, int count, const SelfLine *line, int i, const SelfLine *other, int j)
{
    const int neighbours = line == other && j - i < 2;
    if (i < 0 || i >= line->chain->n || j < 0 || j >= other->chain->n || neighbours) return count;
    pair[count] = (BlockPair){line->row + i, other->row + j};
    return count + 1;
}

/* Largest number of segments between the bearing segments of a piece's two feet. */
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

/* Checks that a pattern that was read has a place for each of them. */
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

/* Finds what is near the elements of a line: farther along itself, and on the lines after it; 0 if there is no
 * memory. */
static int line_walk(const SelfModel *model, const SelfLines *lines, int line, SelfPairs *pairs)
{
    const SelfLine *const mine = &lines->line[line];
    const Chain *const chain = mine->chain;
    const int elements = element_count(GEOMETRY_SMOOTH, chain->n);
    const int skip = lines->within ? self_skip(chain) : elements;
    for (int e = 0; e < elements; ++e) {
        if (e + skip >= elements && line + 1 == lines->n) break;
        /* the foot of the far end of a pressed piece is within the piece's length of the other */
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

/* Both lines may have moved, so each has half of the reach; a quarter is reserved for the motion within a step. */
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
    if (c->reading && !c->status && !hits_reserve(lines, pairs)) checkpoint_lack(c); /* including the halves */
}

/* The steps of a call: hits_next (feet of the ends of a range's pieces, and their pairs) -> patch_at for each -> the
 * segments, in the order of the hits. Nothing here allocates. */

/* At a right angle the bed gives 4/3 k_b sqrt(2 R) p^1.5 (CC5): the force of the impact law, at every depth if its
 * exponent is 1.5, else at its depth d. The damping there equals the impact law's c. */
PatchLaw self_law(const ImpactLaw *impact, const FrictionLaw *friction)
{
    const double d = impact->d, force = impact->k * pow(d, impact->e);
    return (PatchLaw){.bed = 0.75 * impact->k * pow(d, impact->e - 1.5) / sqrt(2),
                      .dissipation = impact->c / force,
                      .friction = *friction};
}

enum { FEET_MAX = 64 }; /* strands about one point that are evaluated; two layers around a strand have 18 */

/* Foot of one point of the line on a range of elements: where that stretch comes nearest to it. */
typedef struct Foot {
    int element;
    double v;
    LineSpot spot;
    Vec3 w; /* from the foot to the point, m */
} Foot;

typedef struct Feet {
    int count;
    Foot foot[FEET_MAX];
} Feet;

/* Checks whether element f is surely farther than `far` from p: its arc is in the triangle of its two centres and the
 * joint between them. */
static int element_far(const Chain *chain, const Kinematics *kin, int f, Vec3 p, double far)
{
    const int i = f > 0 ? f - 1 : 0, j = f < chain->n ? f : chain->n - 1;
    const Vec3 a = v3_load(kin->p, i), along = v3_sub(v3_load(kin->p, j), a), to = v3_sub(p, a);
    const double length = v3_dot(along, along), share = length > 0 ? v3_dot(to, along) / length : 0;
    const Vec3 off = v3_axpy(to, -fmin(1, fmax(0, share)), along);
    const Vec3 front = v3_load(kin->a, i);
    /* an end half extends from its centre by its own length */
    const double out = i == j ? chain->half[i] : v3_norm(v3_axpy(v3_scale(-0.5, along), chain->half[i], front));
    return v3_norm(off) > far + out;
}

/* All feet of p on a range that are no farther than `far` (CC1). Every change of the slope's sign from - to + belongs
 * to one element; the ends of a range are not ends of the line. */
static void feet_find(const Chain *chain, const Kinematics *kin, const SelfRange *range, Vec3 p, double far, Feet *out)
{
    out->count = 0;
    double before = line_slope(chain, kin, range->first - 1, p);
    for (int f = range->first; f < range->first + range->count; ++f) {
        const double slope = line_slope(chain, kin, f, p);
        const int owner = before < 0 && slope >= 0;
        before = slope;
        if (!owner || element_far(chain, kin, f, p, far) || out->count == FEET_MAX) continue;
        int inside;
        const double v = line_foot(chain, kin, f, p, &inside);
        const LineSpot spot = line_spot(chain, kin, f, v);
        const Vec3 w = v3_sub(p, spot.p);
        if (v3_norm(w) <= far) out->foot[out->count++] = (Foot){f, v, spot, w};
    }
}

/* Foot of `next` on the same strand as `foot`: the nearest that is less than `apart` elements away along the line; NULL
 * if there is none. */
static const Foot *foot_beside(const Feet *next, const Foot *foot, double apart)
{
    const Foot *best = NULL;
    double nearest = apart;
    for (int k = 0; k < next->count; ++k) {
        const double away = fabs(next->foot[k].element + next->foot[k].v - foot->element - foot->v);
        if (away >= nearest) continue;
        nearest = away;
        best = &next->foot[k];
    }
    return best;
}

/* Checks whether |w| falls below `radius` somewhere between the two ends. */
static int may_press(Vec3 w0, Vec3 w1, double radius)
{
    const Vec3 along = v3_sub(w1, w0);
    const double a = v3_dot(along, along), b = v3_dot(w0, along);
    const double xi = b >= 0 || a <= 0 ? 0 : fmin(1, -b / a);
    return v3_norm(v3_axpy(w0, xi, along)) < radius;
}

/* Checks whether the spheres of element e and of some element of its range intersect. */
static int range_near(const SelfLine *mine, const SelfLine *other, const SelfRange *range)
{
    const Element here = element_at(GEOMETRY_SMOOTH, mine->chain->n, range->element);
    const Sphere a = element_sphere(&here, mine->chain, mine->kin);
    for (int f = range->first; f < range->first + range->count; ++f) {
        const Element there = element_at(GEOMETRY_SMOOTH, other->chain->n, f);
        const Sphere b = element_sphere(&there, other->chain, other->kin);
        if (v3_norm(v3_sub(a.centre, b.centre)) < a.radius + b.radius) return 1;
    }
    return 0;
}

/* The pressed pieces of one element over one range. Returns their number. */
static int range_hits(const SelfLine *mine, const SelfLine *other, const SelfRange *range, SelfHit *hit)
{
    const int e = range->element, pieces = self_pieces(mine->chain, e), end = range->first + range->count;
    const double length = self_piece_length(mine->chain, e);
    const double radius =
        self_radius_most(mine->chain, e - 1, e) + self_radius_most(other->chain, range->first - 1, end);
    const double apart = self_feet_apart(mine, other, range);
    int count = 0;
    Feet feet[2];
    LineSpot here[2];
    for (int m = 0; m <= pieces; ++m) {
        Feet *const now = &feet[m % 2], *const before = &feet[(m + 1) % 2];
        /* an end that is farther belongs to no pressed piece: separations change no faster than along the piece */
        here[m % 2] = line_spot(mine->chain, mine->kin, e, (double)m / pieces);
        feet_find(other->chain, other->kin, range, here[m % 2].p, radius + 1.25 * length, now);
        for (int k = 0; m > 0 && k < before->count; ++k) {
            const Foot *const a = &before->foot[k], *const b = foot_beside(now, a, apart);
            if (!b || !may_press(a->w, b->w, radius)) continue;
            hit[count++] = (SelfHit){
                .line = range->line,
                .element = e,
                .other = range->other,
                .end = {{here[(m + 1) % 2], a->spot, a->element, a->v}, {here[m % 2], b->spot, b->element, b->v}}};
        }
    }
    return count;
}

/* Position in the ranges of a half. */
typedef struct SelfNext {
    int range, part;
} SelfNext;

static SelfNext hits_begin(const SelfLines *lines, int part, SelfPairs *pairs)
{
    self_clear_look(lines, part, pairs);
    return (SelfNext){part == 0 ? 0 : pairs->half, part};
}

/* The hits of the next range that has any, in pairs->hit[part]; returns their number, 0 at the end. */
static int hits_next(const SelfLines *lines, SelfNext *next, SelfPairs *pairs)
{
    const int part = next->part, to = part == 0 ? pairs->half : pairs->n_ranges;
    while (next->range < to) {
        const int r = next->range++;
        const SelfRange *const range = &pairs->range[r];
        const SelfLine *const mine = &lines->line[range->line], *const other = &lines->line[range->other];
        if (self_clear_apart(lines, part, pairs, r) || !range_near(mine, other, range)) continue;
        const int count = range_hits(mine, other, range, pairs->hit[part]);
        assert(count <= pairs->hits_allocated);
        if (count > 0) return count;
        ++pairs->clear[part].vain;
    }
    return 0;
}

/* The patch of one hit; 0 if it carries no force. */
static int patch_of(const SelfModel *model, const SelfLines *lines, double friction_scale, const SelfHit *hit,
                    Patch *patch)
{
    const SelfLine *const side[2] = {&lines->line[hit->line], &lines->line[hit->other]};
    const double length = self_piece_length(side[0]->chain, hit->element);
    return patch_at(side, &model->law, friction_scale, length, hit->end, patch);
}

/* Effect of a patch on the motion (BA5), (BA6); the feet move along the line normal to the forces, without work. */
static void work_add(const Patch *patch, ContactTally *work)
{
    const double elastic = v3_dot(patch->g[0], patch->speed[0]) + v3_dot(patch->g[1], patch->speed[1]);
    work->friction -= v3_dot(patch->friction, patch->slide);
    work->damping += (1 - patch->damped) * elastic;
    work->energy += patch->energy;
}

void self_forces(const SelfModel *model, const SelfLines *lines, double friction_scale, int part, SelfPairs *pairs,
                 Loads *const loads[])
{
    SelfNext next = hits_begin(lines, part, pairs);
    pairs->active[part] = 0;
    pairs->work[part] = (ContactTally){0};
    for (int hits; (hits = hits_next(lines, &next, pairs)) > 0;) {
        for (int h = 0; h < hits; ++h) {
            Patch patch;
            const SelfHit *const hit = &pairs->hit[part][h];
            const int presses = patch_of(model, lines, friction_scale, hit, &patch);
            work_add(&patch, &pairs->work[part]);
            if (!presses) continue;
            ++pairs->active[part];
            for (int s = 0; s < patch.slots; ++s) {
                const PatchWrench wrench = patch_wrench(&patch, s);
                Loads *const on = loads[patch.slot[s].side ? hit->other : hit->line];
                loads_add(on, patch.slot[s].body, wrench.force, wrench.moment);
            }
        }
    }
}

/* Place of block (row, col): in a chain of blocks, or off its diagonals in `extra`, as are blocks between neighbours in
 * the matrix that belong to different lines. */
static double *block_at(SelfPairs *pairs, BlockChain *chain, double *extra, int one_line, int row, int col)
{
    if (row == col) return chain->diag + 36 * row;
    if (one_line && row == col + 1) return chain->lower + 36 * row;
    if (one_line && row == col - 1) return chain->upper + 36 * row;
    return extra + 36 * block_extras_touch(&pairs->extras, row, col);
}

/* All twelve columns of one slot. */
static void slot_blocks(const SelfModel *model, const Patch *patch, const int first[2], int s, SelfPairs *pairs,
                        BlockChain *k, BlockChain *d)
{
    double *block[2][PATCH_SLOTS];
    const int side = patch->slot[s].side, col = first[side] + patch->slot[s].body;
    for (int t = 0; t < patch->slots; ++t) {
        const int beside = patch->slot[t].side, row = first[beside] + patch->slot[t].body;
        const int one_line = first[beside] == first[side];
        block[0][t] = block_at(pairs, k, pairs->extras.k, one_line, row, col);
        block[1][t] = block_at(pairs, d, pairs->extras.d, one_line, row, col);
    }
    PatchColumns by_place, by_motion;
    self_kernels()->columns(patch, &model->law, s, &by_place, &by_motion);
    for (int t = 0; t < patch->slots; ++t) {
        for (int c = 0; c < 6; ++c) {
            for (int r = 0; r < 6; ++r) {
                block[0][t][6 * c + r] += by_place.row[t][r][c];
                block[1][t][6 * c + r] += by_motion.row[t][r][c];
            }
        }
    }
}

void self_blocks(const SelfModel *model, const SelfLines *lines, double friction_scale, SelfPairs *pairs, BlockChain *k,
                 BlockChain *d)
{
    for (int part = 0; part < SELF_PARTS; ++part) {
        SelfNext next = hits_begin(lines, part, pairs);
        for (int hits; (hits = hits_next(lines, &next, pairs)) > 0;) {
            for (int h = 0; h < hits; ++h) {
                Patch patch;
                const SelfHit *const hit = &pairs->hit[part][h];
                if (!patch_of(model, lines, friction_scale, hit, &patch)) continue;
                const int first[2] = {lines->line[hit->line].row, lines->line[hit->other].row};
                for (int s = 0; s < patch.slots; ++s) slot_blocks(model, &patch, first, s, pairs, k, d);
            }
        }
    }
}

/* A patch in the public form; one without force has a depth and a place only. */
static SelfDetail detail_of(const SelfHit *hit, const Patch *patch)
{
    const Vec3 p0 = hit->end[0].here.p, p1 = hit->end[1].here.p;
    return (SelfDetail){.line = hit->line,
                        .element = hit->element,
                        .other = hit->other,
                        .arm = patch->distance,
                        .length = patch->length,
                        .foot = hit->end[0].foot,
                        .depth = patch_depth(patch),
                        .normal = patch->force,
                        .friction = patch->friction,
                        .direction = patch->normal,
                        .point = v3_axpy(v3_scale(1 - patch->centre, p0), patch->centre, p1)};
}

int self_details(const SelfModel *model, const SelfLines *lines, double friction_scale, SelfPairs *pairs, int room,
                 SelfDetail *out)
{
    int count = 0;
    for (int part = 0; part < SELF_PARTS; ++part) {
        SelfNext next = hits_begin(lines, part, pairs);
        for (int hits; (hits = hits_next(lines, &next, pairs)) > 0;) {
            for (int h = 0; h < hits; ++h, ++count) {
                Patch patch;
                patch_of(model, lines, friction_scale, &pairs->hit[part][h], &patch);
                if (count < room) out[count] = detail_of(&pairs->hit[part][h], &patch);
            }
        }
    }
    return count;
}

void self_line_loads(const SelfModel *model, const SelfLines *lines, SelfPairs *pairs, double *most)
{
    for (int part = 0; part < SELF_PARTS; ++part) {
        SelfNext next = hits_begin(lines, part, pairs);
        for (int hits; (hits = hits_next(lines, &next, pairs)) > 0;) {
            for (int h = 0; h < hits; ++h) {
                Patch patch;
                const SelfHit *const hit = &pairs->hit[part][h];
                patch_of(model, lines, 1, hit, &patch);
                const double load = patch.force / patch.length;
                most[hit->line] = fmax(most[hit->line], load);
                most[hit->other] = fmax(most[hit->other], load);
            }
        }
    }
}

SelfDetail self_deepest(const SelfModel *model, const SelfLines *lines, SelfPairs *pairs)
{
    SelfDetail deepest = {.depth = -INFINITY};
    for (int part = 0; part < SELF_PARTS; ++part) {
        SelfNext next = hits_begin(lines, part, pairs);
        for (int hits; (hits = hits_next(lines, &next, pairs)) > 0;) {
            for (int h = 0; h < hits; ++h) {
                Patch patch;
                patch_of(model, lines, 0, &pairs->hit[part][h], &patch);
                const SelfDetail now = detail_of(&pairs->hit[part][h], &patch);
                if (now.depth > deepest.depth) deepest = now;
            }
        }
    }
    return deepest;
}

/* Skips ranges: stretches of two lines that had a gap and have not approached each other by as much. docs/theory.md,
 * "Cable on cable", (CC27), (CC28). */

enum { CONTROLS = 4 };

static int ranges_from(const SelfPairs *pairs, int part) { return part == 0 ? 0 : pairs->half; }

static int ranges_to(const SelfPairs *pairs, int part) { return part == 0 ? pairs->half : pairs->n_ranges; }

/* Corners of a hull around element e: those of its cubic's Bezier form, or the ends of an end half. */
static int controls_of(const SelfLine *line, int e, Vec3 at[CONTROLS])
{
    const Chain *const chain = line->chain;
    int count = 0;
    const double share = e > 0 && e < chain->n ? 2.0 / 3 : 1;
    for (int b = 0; b < 2; ++b) {
        const int i = e - 1 + b;
        if (i < 0 || i >= chain->n) continue;
        const Vec3 centre = v3_load(line->kin->p, i);
        at[count++] = centre;
        at[count++] = v3_axpy(centre, (b ? -share : share) * chain->half[i], v3_load(line->kin->a, i));
    }
    return count;
}

/* Distance of the elements of a range beyond the plane normal to n through the range's own element, m. */
static double apart_along(const SelfLine *mine, const SelfLine *other, const SelfRange *range, Vec3 n)
{
    Vec3 at[CONTROLS];
    double front = -INFINITY, back = INFINITY;
    for (int c = controls_of(mine, range->element, at) - 1; c >= 0; --c) front = fmax(front, v3_dot(n, at[c]));
    for (int f = range->first; f < range->first + range->count; ++f)
        for (int c = controls_of(other, f, at) - 1; c >= 0; --c) back = fmin(back, v3_dot(n, at[c]));
    return back - front;
}

/* Lower bound of the gap between the surfaces of a range's two sides (CC27): along the line from the middle of its own
 * element to the nearest point on the other side's centres. */
static double gap_of(const SelfLine *mine, const SelfLine *other, const SelfRange *range)
{
    Vec3 at[CONTROLS];
    const int count = controls_of(mine, range->element, at);
    const Vec3 middle = v3_scale(0.5, v3_add(at[0], at[count / 2]));
    Vec3 to = V3_ZERO;
    double nearest = INFINITY;
    for (int f = range->first; f < range->first + range->count; ++f) {
        const int corners = controls_of(other, f, at);
        const Vec3 along = v3_sub(at[corners / 2], at[0]), from = v3_sub(middle, at[0]);
        const double share = fmin(1, fmax(0, v3_dot(from, along) / v3_dot(along, along)));
        const Vec3 off = v3_sub(v3_scale(share, along), from);
        if (!(v3_dot(off, off) < nearest)) continue;
        nearest = v3_dot(off, off);
        to = off;
    }
    if (!(nearest > 0)) return 0;
    const double radii = self_radius_most(mine->chain, range->element - 1, range->element) +
                         self_radius_most(other->chain, range->first - 1, range->first + range->count);
    return apart_along(mine, other, range, v3_scale(1 / sqrt(nearest), to)) - radii;
}

/* The largest |x - x_0 - base|^2 and |r - r_0|^2 of segments from..to of a line, as far as they exist. */
static void moves_of(const SelfLine *line, const double *at, int from, int to, const double base[3], double *shift,
                     double *turn)
{
    const Kinematics *const kin = line->kin;
    for (int i = from < 0 ? 0 : from; i <= to && i < line->chain->n; ++i) {
        const double *const was = at + 6 * (line->row + i), half = line->chain->half[i];
        const double x = kin->p[0][i] - was[0] - base[0], y = kin->p[1][i] - was[1] - base[1];
        const double z = kin->p[2][i] - was[2] - base[2], a = half * kin->a[0][i] - was[3];
        const double b = half * kin->a[1][i] - was[4], c = half * kin->a[2][i] - was[5];
        const double moved = x * x + y * y + z * z, turned = a * a + b * b + c * c;
        *shift = *shift > moved ? *shift : moved;
        *turn = *turn > turned ? *turn : turned;
    }
}

int self_clear_apart(const SelfLines *lines, int part, const SelfPairs *pairs, int r)
{
    const SelfClear *const clear = &pairs->clear[part];
    const double gap = clear->gap[r - ranges_from(pairs, part)];
    if (!(gap > 0)) return 0;
    const SelfRange *const range = &pairs->range[r];
    const SelfLine *const mine = &lines->line[range->line], *const other = &lines->line[range->other];
    const int first = range->element > 0 ? range->element - 1 : 0;
    const double *const was = clear->at + 6 * (mine->row + first);
    double base[3], shift[2] = {0, 0}, turn[2] = {0, 0};
    for (int c = 0; c < 3; ++c) base[c] = mine->kin->p[c][first] - was[c];
    moves_of(mine, clear->at, range->element - 1, range->element, base, &shift[0], &turn[0]);
    moves_of(other, clear->at, range->first - 1, range->first + range->count - 1, base, &shift[1], &turn[1]);
    return gap > sqrt(shift[0]) + sqrt(shift[1]) + sqrt(turn[0]) + sqrt(turn[1]); /* (CC28); not for a NaN */
}

void self_clear_look(const SelfLines *lines, int part, SelfPairs *pairs)
{
    SelfClear *const clear = &pairs->clear[part];
    const int from = ranges_from(pairs, part), to = ranges_to(pairs, part);
    if (clear->known && clear->vain <= to - from) return;
    for (int l = 0; l < lines->n; ++l) {
        const SelfLine *const line = &lines->line[l];
        for (int i = 0; i < line->chain->n; ++i) {
            double *const at = clear->at + 6 * (line->row + i);
            v3_put(at, v3_load(line->kin->p, i));
            v3_put(at + 3, v3_scale(line->chain->half[i], v3_load(line->kin->a, i)));
        }
    }
    for (int r = from; r < to; ++r) {
        const SelfRange *const range = &pairs->range[r];
        clear->gap[r - from] = gap_of(&lines->line[range->line], &lines->line[range->other], range);
    }
    clear->known = 1;
    clear->vain = 0;
}
