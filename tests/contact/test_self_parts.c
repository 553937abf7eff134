/* The parts of cable on cable by closed forms: the law, how the cable is cut, who is a candidate, what need not be
 * looked at, what the details and the balance say. */
#include "tests/support/touch.h"

/* ------------------------------------------------------------------------------------------- law and lengths */

/* Square crossings press like the impact law, for every depth if its exponent is 1.5, else at its depth d; the damping
 * takes c there. */
TEST(test_law)
{
    const FrictionLaw friction = {.mu_s = 0.3, .mu_d = 0.2, .v_s = 5e-3, .v_d = 2e-2};
    for (int k = 0; k < 12; ++k) {
        const ImpactLaw impact = {.k = 1e6 * (1 + k), .e = 1 + 0.5 * (k % 4), .c = 300 + k, .d = 1e-3 * (1 + k)};
        const PatchLaw law = self_law(&impact, &friction);
        const double pressed = 4.0 / 3 * law.bed * sqrt(2) * pow(impact.d, 1.5),
                     asked = impact.k * pow(impact.d, impact.e);
        check_share(pressed, asked, 1e-13);
        check_share(law.dissipation * asked, impact.c, 1e-13);
        check_equal(law.friction.mu_d, 0.2);
    }
}

/* One segment of a chain is as short, one as thick as said, wherever they are; half a turn of the thickest keeps two
 * elements apart, and two more. */
TEST(test_skip)
{
    enum { MANY = 40, FEW = 3 };
    for (int i = 0; i < MANY; i += 13) {
        for (int j = 0; j < MANY; j += 13) {
            SelfScene s;
            self_new(&s, MANY, 0.25);
            s.chain.radius[i] = 0.3;
            s.chain.half[j] = 0.04;
            assert_int_equal(self_skip(&s.chain), 12 + 2); /* 0.942 m / 0.08 m = 11.8 */
            self_free(&s);
        }
    }
    SelfScene s;
    self_new(&s, FEW, 0.25);
    assert_int_equal(self_skip(&s.chain), 1 + 2);
    s.chain.radius[0] = 0.23; /* 2.9 segments */
    assert_int_equal(self_skip(&s.chain), 3 + 2);
    s.chain.radius[0] = 0.3; /* 3.8: more than there are */
    assert_int_equal(self_skip(&s.chain), FEW + 2);
    s.chain.radius[0] = 1e300; /* no overflow */
    assert_int_equal(self_skip(&s.chain), FEW + 2);
    self_free(&s);
}

/* Pieces no longer than the thinner side is thick, 1 to 8 of them; an end has half a segment. */
TEST(test_pieces)
{
    enum { N = 4 };
    SelfScene s;
    self_new(&s, N, 1);
    const double half[N] = {0.03, 0.4, 0.2, 0.1}, radius[N] = {0.02, 0.05, 0.04, 0.03};
    memcpy(s.chain.half, half, sizeof half);
    memcpy(s.chain.radius, radius, sizeof radius);
    const int pieces[N + 1] = {1, 8, 8, 5, 2}; /* 0.03/0.04, 0.43/0.04, 0.6/0.08, 0.3/0.06 + , 0.1/0.06 */
    const double length[N + 1] = {0.03, 0.43, 0.6, 0.3, 0.1};
    for (int e = 0; e <= N; ++e) {
        const double least = e == 0 ? radius[0] : e == N ? radius[N - 1] : fmin(radius[e - 1], radius[e]);
        const int most = (int)ceil(length[e] / (2 * least) - 1e-9);
        if (e != 3) assert_int_equal(pieces[e], most > 8 ? 8 : most);
        if (e != 3) assert_int_equal(self_pieces(&s.chain, e), pieces[e]);
        check_share(self_piece_length(&s.chain, e) * self_pieces(&s.chain, e), length[e], 1e-15);
    }
    s.chain.radius[2] = s.chain.radius[3] = 1; /* thicker than long */
    assert_int_equal(self_pieces(&s.chain, 3), 1);
    check_close(self_piece_length(&s.chain, 3), 0.3, 1e-16);
    check_equal(self_radius_most(&s.chain, -3, 9), 1);
    check_equal(self_radius_most(&s.chain, -1, 0), 0.02);
    check_equal(self_radius_most(&s.chain, 0, 1), 0.05);
    check_equal(self_radius_most(&s.chain, N, N + 2), 0);
    self_free(&s);
}

/* ----------------------------------------------------------------------------------------------- candidates */

enum { STRAND = 6, BOTH = 2 * STRAND };

/* Two strands side by side, the upper one running back; the joint between them is far from both, so its element is
 * left out of account. */
static void strands(SelfScene *s, double apart)
{
    self_strand(s, 0, STRAND, v3(0, 0, 0), v3(1, 0, 0));
    self_strand(s, STRAND, STRAND, v3(0.3 * STRAND, 0, apart), v3(-1, 0, 0));
}

static int candidates_at(SelfScene *s, double apart)
{
    strands(s, apart);
    self_fresh(s);
    return s->pairs.candidates;
}

/* Straight strands are candidates from where their surfaces are within the reach and what a piece is longer. */
TEST(test_reach)
{
    for (int thick = -1; thick < BOTH; ++thick) {
        SelfScene s;
        self_new(&s, BOTH, 0.3);
        if (thick >= 0) s.chain.radius[thick] = 0.07;
        s.model.reach = 0.1;
        double longest = 0;
        for (int e = 0; e <= BOTH; ++e) {
            const double piece = self_piece_length(&s.chain, e);
            /* whose own radius is that of the thick one, or which finds the thick one above it */
            const int meets = thick < 0 || thick >= STRAND || e == thick || e == thick + 1;
            if (meets && e != STRAND && e < STRAND) longest = larger_of(longest, piece);
        }
        const double radii = SELF_RADIUS + (thick < 0 ? SELF_RADIUS : 0.07),
                     limit = s.model.reach + 1.25 * longest + radii;
        check_above(candidates_at(&s, limit - 1e-3), 0);
        if (thick < 0) {
            candidates_at(&s, limit + 1e-3);
            for (int r = 0; r < s.pairs.n_ranges; ++r) { /* the joint between the strands may reach its neighbours */
                const SelfRange *const range = &s.pairs.range[r];
                assert_true(range->element >= STRAND || range->first + range->count <= STRAND + 2);
            }
        }
        self_free(&s);
    }
}

/* The candidates of every element are what a search of all finds, and the halves share them. */
TEST(test_halves)
{
    SelfScene s;
    self_new(&s, BOTH, 0.3);
    check_above(candidates_at(&s, 2 * SELF_RADIUS), STRAND);
    int seen = 0, half = 0;
    for (int r = 0; r < s.pairs.n_ranges; ++r) {
        if (r == s.pairs.half) half = seen;
        if (r > 0) assert_true(s.pairs.range[r - 1].element <= s.pairs.range[r].element);
        seen += s.pairs.range[r].count;
    }
    assert_int_equal(seen, s.pairs.candidates);
    check_at_least(2 * half, seen); /* the first half is the first to have as much */
    check_below(2 * (half - s.pairs.range[s.pairs.half - 1].count), seen);
    self_free(&s);
}

/* -------------------------------------------------------------------------------- what need not be looked at */

/* Ranges that are apart, of both halves. */
static int apart_count(const SelfScene *s)
{
    const SelfLines *const lines = SELF_ALONE(&s->chain, &s->kin);
    int count = 0;
    for (int r = 0; r < s->pairs.n_ranges; ++r) count += self_clear_apart(lines, r >= s->pairs.half, &s->pairs, r);
    return count;
}

static void look(SelfScene *s)
{
    for (int part = 0; part < SELF_PARTS; ++part) {
        s->pairs.clear[part].known = 0;
        self_clear_look(SELF_ALONE(&s->chain, &s->kin), part, &s->pairs);
    }
}

/* Ranges between the strands, whose other side lies across the middle of its element: the gap is the strands' own. */
static int faces(const SelfScene *s, const SelfRange *r)
{
    const int e = r->element;
    if (e >= STRAND || r->first <= STRAND) return 0; /* the joint between the strands */
    const double *const x = s->kin.p[0], half = s->chain.half[0];
    const double middle = e == 0 ? x[0] - half / 2 : (x[e - 1] + x[e]) / 2;
    const int last = r->first + r->count - 1 < BOTH ? r->first + r->count - 1 : BOTH - 1;
    return middle <= x[r->first - 1] && middle >= x[last];
}

/* The ranges that segment i of strands bears on. */
static int bears_on(const SelfRange *r, int i)
{
    return i == r->element - 1 || i == r->element || (i >= r->first - 1 && i < r->first + r->count);
}

/* Parallel strands with a gap between their surfaces: a segment that comes nearer by less than the gap leaves its
 * ranges apart, by more does not; others are not touched. What moves as a whole stays apart however far. */
TEST(test_clear)
{
    const double gap = 0.02;
    SelfScene s;
    self_new(&s, BOTH, 0.3);
    candidates_at(&s, 2 * SELF_RADIUS + gap);
    look(&s);
    int clear = 0;
    for (int r = 0; r < s.pairs.n_ranges; ++r) {
        const SelfRange *const range = &s.pairs.range[r];
        const double found = s.pairs.clear[r >= s.pairs.half].gap[r - (r >= s.pairs.half ? s.pairs.half : 0)];
        if (!faces(&s, range)) continue;
        check_close(found, gap, 1e-12);
        ++clear;
    }
    check_above(clear, 2);
    const int all = apart_count(&s);
    check_at_least(all, clear);
    for (int i = 0; i < BOTH; ++i) {
        static const double share[] = {0.98, 1.02, -0.98, -1.02};
        for (int k = 0; k < 4; ++k) {
            for (int axis = 0; axis < 3; ++axis) {
                const double was = s.kin.p[axis][i];
                s.kin.p[axis][i] += share[k] * gap;
                for (int r = 0; r < s.pairs.n_ranges; ++r) {
                    const SelfRange *const range = &s.pairs.range[r];
                    if (!faces(&s, range)) continue;
                    const int first = range->element > 0 ? range->element - 1 : 0;
                    if (i == first) continue; /* moves what the rest is held against */
                    const int apart = self_clear_apart(SELF_ALONE(&s.chain, &s.kin), r >= s.pairs.half, &s.pairs, r);
                    assert_int_equal(apart, !bears_on(range, i) || k % 2 == 0);
                }
                s.kin.p[axis][i] = was;
            }
        }
        for (int axis = 1; axis < 3; ++axis) { /* turned: the front end moves by half a length times the angle */
            for (int k = 0; k < 2; ++k) {
                const double was = s.kin.a[axis][i];
                s.kin.a[axis][i] += share[k] * gap / s.chain.half[i];
                for (int r = 0; r < s.pairs.n_ranges; ++r) {
                    const SelfRange *const range = &s.pairs.range[r];
                    if (!faces(&s, range)) continue;
                    const int apart = self_clear_apart(SELF_ALONE(&s.chain, &s.kin), r >= s.pairs.half, &s.pairs, r);
                    assert_int_equal(apart, !bears_on(range, i) || k == 0);
                }
                s.kin.a[axis][i] = was;
            }
        }
    }
    for (int i = 0; i < BOTH; ++i) vec_store(s.kin.p, i, v3_add(vec_load(s.kin.p, i), v3(3, -5, 7)));
    assert_int_equal(apart_count(&s), all);
    s.kin.p[2][3] = NAN;
    check_below(apart_count(&s), all);
    self_free(&s);
}

/* Along a motion the forces are to the last bit those of a look at everything. */
TEST(test_clear_changes_nothing)
{
    uint64_t seed = 21;
    SelfScene s, all;
    self_new(&s, 32, 0.25);
    self_helix(&s, 0.5, 2 * SELF_RADIUS + 1e-3);
    self_fresh(&s);
    all = s;
    const int n = 32;
    assert_true(self_pairs_alloc(&all.pairs, 1, &n) && chain_struct_alloc(&all.loads, n));
    self_fresh(&all);
    int skipped = 0, pressed = 0;
    for (int k = 0; k < 60; ++k) {
        self_shake(&s, 3e-4, 0.01, &seed);
        for (int i = 0; i < n; ++i) s.kin.p[0][i] += 1e-3; /* everything goes along */
        self_load(&s, 1);
        skipped += apart_count(&s);
        for (int part = 0; part < SELF_PARTS; ++part) all.pairs.clear[part].known = 0;
        self_load(&all, 1);
        pressed += all.pairs.active[0] + all.pairs.active[1];
        assert_memory_equal(s.pairs.active, all.pairs.active, sizeof s.pairs.active);
        for (int c = 0; c < 3; ++c) {
            assert_memory_equal(s.loads.f[c], all.loads.f[c], (size_t)n * sizeof(double));
            assert_memory_equal(s.loads.m[c], all.loads.m[c], (size_t)n * sizeof(double));
        }
    }
    check_above(skipped, 60);
    check_above(pressed, 60);
    self_pairs_free(&all.pairs);
    chain_struct_free(&all.loads);
    self_free(&s);
}

/* --------------------------------------------------------------------------------------- details and balance */

/* The pieces' forces are the strand's, their depths and places those of the crossing; the deepest is the deepest. */
TEST(test_details)
{
    enum { ROOM = 64 };
    SelfScene s;
    SelfDetail detail[ROOM];
    const double depth = 3e-4;
    self_new(&s, BOTH, 0.3);
    self_strand(&s, 0, STRAND, v3(-0.95, 0, 0), v3(1, 0, 0));
    self_strand(&s, STRAND, STRAND, v3(0.1, 0.85, 2 * SELF_RADIUS - depth), v3(0, -1, 0));
    for (int i = STRAND; i < BOTH; ++i) vec_store(s.kin.v, i, v3(0.1, 0, 0));
    self_fresh(&s);
    self_load(&s, 1);
    const SelfLines *const lines = SELF_ALONE(&s.chain, &s.kin);
    const int count = self_details(&s.model, lines, 1, &s.pairs, ROOM, detail);
    check_between(count, 1, ROOM);
    Vec3 sum = V3_ZERO;
    double deepest = -INFINITY, length = 0;
    for (int k = 0; k < count; ++k) {
        const SelfDetail *const d = &detail[k];
        const Vec3 push = v3_scale(d->normal, d->direction);
        sum = v3_add(sum, v3_add(push, d->friction));
        deepest = larger_of(deepest, d->depth);
        if (!(d->normal > 0)) continue;
        length = larger_of(length, d->length);
        assert_int_equal(d->line, 0);
        assert_int_equal(d->other, 0);
        assert_true(d->element < STRAND && d->foot > STRAND);
        check_close(d->point.x, 0.1, 0.05);
        check_close(v3_norm(v3(0, d->point.y, d->point.z)), 0, 1e-12);
        check_close(d->arm, 2 * SELF_RADIUS - depth, 2e-4);
        check_share(d->length, self_piece_length(&s.chain, d->element), 1e-15);
        check_share(v3_norm(d->friction), 0.2 * d->normal, 1e-6); /* beyond v_d */
        check_above(d->friction.x, 0);                            /* goes along with the upper one */
    }
    check_above(length, 0);
    check_vec(sum, self_force_on(&s, 0, STRAND), 1e-9);
    check_close(deepest, depth, 1e-12);
    const SelfDetail most = self_deepest(&s.model, lines, &s.pairs);
    check_equal(most.depth, deepest);
    check_equal(v3_norm(most.friction), 0); /* it is asked without */
    detail[0].normal = -7;
    assert_int_equal(self_details(&s.model, lines, 1, &s.pairs, 0, detail), count); /* no room */
    check_equal(detail[0].normal, -7);
    strands(&s, 1);
    self_fresh(&s);
    assert_int_equal(self_details(&s.model, lines, 1, &s.pairs, ROOM, detail), 0);
    check_equal(self_deepest(&s.model, lines, &s.pairs).depth, -INFINITY);
    self_free(&s);
}

/* (BA5), (BA6): the forces' power is what friction and damping take, and what goes into the bed; with the bed's energy
 * by differences along the motion. Straight strands: of bent ones the feet's own motion takes a little. */
TEST(test_balance)
{
    uint64_t seed = 31;
    for (int k = 0; k < 12; ++k) {
        SelfScene s;
        const double angle = 0.4 + 0.1 * k, c = cos(angle), e = sin(angle), step = 1e-6;
        double power = 0, energy[2], taken = 0;
        self_new(&s, BOTH, 0.3);
        self_strand(&s, 0, STRAND, v3(-0.95, 0, 0), v3(1, 0, 0));
        self_strand(&s, STRAND, STRAND, v3(0.1 + 0.85 * c, 0.85 * e, 2 * SELF_RADIUS - 2e-3), v3(-c, -e, 0));
        self_shake(&s, 0, k % 2 ? 0.02 : 1e-3, &seed);
        self_fresh(&s);
        self_load(&s, 1);
        for (int part = 0; part < SELF_PARTS; ++part) taken += s.pairs.work[part].friction + s.pairs.work[part].damping;
        for (int i = 0; i < BOTH; ++i) {
            power += v3_dot(vec_load(s.loads.f, i), vec_load(s.kin.v, i));
            power += v3_dot(vec_load(s.loads.m, i), vec_load(s.kin.w, i));
        }
        for (int side = 0; side < 2; ++side) {
            for (int i = 0; i < BOTH; ++i) {
                const double h = side ? 2 * step : -step;
                vec_store(s.kin.p, i, v3_axpy(vec_load(s.kin.p, i), h, vec_load(s.kin.v, i)));
                vec_store(s.kin.a, i, quat_rotate(quat_exp(v3_scale(h, vec_load(s.kin.w, i))), vec_load(s.kin.a, i)));
            }
            self_load(&s, 1);
            energy[side] = s.pairs.work[0].energy + s.pairs.work[1].energy;
        }
        const double rate = (energy[1] - energy[0]) / (2 * step);
        check_above(energy[0], 0);
        check_above(taken, 0);
        check_close(power, -taken - rate, 1e-6 * (taken + fabs(rate)));
        self_free(&s);
    }
}

/* (CC5) of ends at the same separation: the bed's force is that of its depth all along, nothing where they are as far
 * apart as their surfaces or farther; then nothing is held either. */
TEST(test_parallel_bed)
{
    const PatchLaw law = {.bed = 1e6};
    const double radius = 0.08, modulus = 1e6 * 0.3 / (radius * sqrt(radius));
    for (int k = 0; k <= 40; ++k) {
        const double apart = radius * (0.9 + 0.01 * k), q = (radius * radius - apart * apart) / (2 * radius);
        Patch p = {.length = 0.3, .radius = radius, .w = {{0, apart, 0}, {0, apart, 0}}};
        const int presses = bed_integrate(&p, &law);
        if (k == 10) continue; /* they touch to rounding */
        assert_int_equal(presses, k < 10);
        check_close(p.energy, k < 10 ? modulus * radius / 2 * q * q : 0, 1e-12);
        check_close(p.m0, k < 10 ? q : 0, 1e-16);
        for (int end = 0; end < 2; ++end) check_close(p.g[end].y, k < 10 ? modulus * q * apart / 2 : 0, 1e-8);
        if (k < 10) check_close(p.centre, 0.5, 1e-14);
    }
}
