/* The corridor of a call: hits_next (feet of a range's pieces' ends, and which belong together) -> patch_at for each ->
 * the segments, in the order of the hits. Nothing here allocates. */
#include "contact/self/self_contact.h"

#include <assert.h>

/* At a right angle the bed gives 4/3 k_b sqrt(2 R) p^1.5 (CC5): the same force as the impact law, for every depth if
 * its exponent is 1.5, else at its depth d. The damping takes as much there as the impact law's c. */
PatchLaw self_law(const ImpactLaw *impact, const FrictionLaw *friction)
{
    const double d = impact->d, force = impact->k * pow(d, impact->e);
    return (PatchLaw){.bed = 0.75 * impact->k * pow(d, impact->e - 1.5) / sqrt(2),
                      .dissipation = impact->c / force,
                      .friction = *friction};
}

enum { FEET_MAX = 64 }; /* strands about one point that are looked at; two layers around a strand have 18 */

/* One point of the line against a range of elements: where that stretch comes nearest to it. */
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

/* Whether element f is surely farther than `far` from p: its arc lies in the triangle of its two centres and the joint
 * between them. */
static int element_far(const Chain *chain, const Kinematics *kin, int f, Vec3 p, double far)
{
    const int i = f > 0 ? f - 1 : 0, j = f < chain->n ? f : chain->n - 1;
    const Vec3 a = v3_load(kin->p, i), along = v3_sub(v3_load(kin->p, j), a), to = v3_sub(p, a);
    const double length = v3_dot(along, along), share = length > 0 ? v3_dot(to, along) / length : 0;
    const Vec3 off = v3_axpy(to, -fmin(1, fmax(0, share)), along);
    const Vec3 front = v3_load(kin->a, i);
    /* an end half sticks out of its centre by its own length */
    const double out = i == j ? chain->half[i] : v3_norm(v3_axpy(v3_scale(-0.5, along), chain->half[i], front));
    return v3_norm(off) > far + out;
}

/* All feet of p on a range that are not farther than `far` (CC1). Every change of the slope's sign from - to + belongs
 * to one element; the ends of a range are no ends of the line. */
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

/* The foot of `next` on the same strand as `foot`: less than `apart` elements away along the line, the nearest; NULL if
 * there is none. */
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

/* Whether |w| falls below `radius` somewhere between the two ends. */
static int may_press(Vec3 w0, Vec3 w1, double radius)
{
    const Vec3 along = v3_sub(w1, w0);
    const double a = v3_dot(along, along), b = v3_dot(w0, along);
    const double xi = b >= 0 || a <= 0 ? 0 : fmin(1, -b / a);
    return v3_norm(v3_axpy(w0, xi, along)) < radius;
}

/* Whether the spheres of element e and of some element of its range meet now. */
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

/* The pressed pieces of one element over one range. Returns how many. */
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
        /* an end that is farther belongs to no pressed piece: separations change no faster than the piece is long */
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

/* Which range of a half is looked at next. */
typedef struct SelfNext {
    int range, part;
} SelfNext;

static SelfNext hits_begin(const SelfLines *lines, int part, SelfPairs *pairs)
{
    self_clear_look(lines, part, pairs);
    return (SelfNext){part == 0 ? 0 : pairs->half, part};
}

/* The hits of the next range that has any, in pairs->hit[part]; returns how many, 0 at the end. */
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

/* What a patch does to the motion (BA5), (BA6); the feet run along the line square to the forces, at no cost. */
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

/* Where block (row, col) is: in a chain of blocks, or off its diagonals in `extra`; so are blocks between neighbours in
 * the matrix of which each is another line's. */
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
    for (int c = 0; c < 12; ++c) {
        PatchWrench out[PATCH_SLOTS];
        patch_column(patch, &model->law, s, c, out);
        for (int t = 0; t < patch->slots; ++t) {
            double *const at = block[c / 6][t] + 6 * (c % 6);
            const double rows[6] = {out[t].force.x,  out[t].force.y,  out[t].force.z,
                                    out[t].moment.x, out[t].moment.y, out[t].moment.z};
            for (int r = 0; r < 6; ++r) at[r] += rows[r];
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

/* A patch for the outside; what carries no force has a depth and a place only. */
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
