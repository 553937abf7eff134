/* Several cables that touch each other: forces by closed forms and in balance, derivatives against differences, ends
 * whose feet are held, heads that an eye holds apart, and that candidates are those of the lines that were asked for.
 */
#include "tests/support/touch.h"

enum { LINES = 2, N = 6, ALL = LINES * N, SIZE = 6 * ALL };

typedef struct Beside {
    Chain chain[LINES];
    Kinematics kin[LINES];
    Loads loads[LINES];
    SelfLine line[LINES];
    SelfLines lines;
    SelfPairs pairs;
    SelfModel model;
} Beside;

static void beside_new(Beside *s)
{
    const int segments[LINES] = {N, N};
    const ImpactLaw impact = {.k = 1e7, .e = 1.5, .c = 2e3, .d = 1e-3};
    const FrictionLaw friction = {.mu_s = 0.3, .mu_d = 0.2, .v_s = 5e-3, .v_d = 2e-2};
    memset(s, 0, sizeof *s);
    for (int l = 0; l < LINES; ++l) {
        assert_true(chain_alloc(&s->chain[l], N) && kinematics_alloc(&s->kin[l], N));
        assert_true(chain_struct_alloc(&s->loads[l], N));
        for (int i = 0; i < N; ++i) {
            s->chain[l].half[i] = 0.15;
            s->chain[l].radius[i] = SELF_RADIUS;
        }
        s->line[l] = (SelfLine){&s->chain[l], &s->kin[l], l * N, 0};
    }
    assert_true(self_pairs_alloc(&s->pairs, LINES, segments));
    s->lines = (SelfLines){LINES, s->line, 0};
    s->model = (SelfModel){.present = 1, .law = self_law(&impact, &friction), .reach = 0.2};
}

static void beside_free(Beside *s)
{
    for (int l = 0; l < LINES; ++l) {
        chain_free(&s->chain[l]);
        kinematics_free(&s->kin[l]);
        chain_struct_free(&s->loads[l]);
    }
    self_pairs_free(&s->pairs);
}

/* Line l straight from `start`. */
static void lay(Beside *s, int l, Vec3 start, Vec3 direction)
{
    const Vec3 along = v3_unit(direction);
    for (int i = 0; i < N; ++i) {
        vec_store(s->kin[l].p, i, v3_axpy(start, 0.15 + 0.3 * i, along));
        vec_store(s->kin[l].a, i, along);
    }
}

static void shake(Beside *s, double shift, double speed, uint64_t *seed)
{
    for (int l = 0; l < LINES; ++l) {
        for (int i = 0; i < N; ++i) {
            Kinematics *const k = &s->kin[l];
            vec_store(k->p, i, v3_axpy(vec_load(k->p, i), shift, fixture_vector(seed, 1)));
            vec_store(k->a, i, v3_unit(v3_axpy(vec_load(k->a, i), shift / 0.15, fixture_vector(seed, 1))));
            vec_store(k->v, i, v3_scale(speed, fixture_vector(seed, 1)));
            vec_store(k->w, i, v3_scale(10 * speed, fixture_vector(seed, 1)));
        }
    }
}

static void refresh(Beside *s) { assert_int_equal(self_refresh(&s->model, &s->lines, &s->pairs, NULL), HAWSER_OK); }

/* Loads on all lines; returns how many pieces press. */
static int load(Beside *s, double friction)
{
    Loads *const loads[LINES] = {&s->loads[0], &s->loads[1]};
    for (int l = 0; l < LINES; ++l) loads_zero(loads[l], N);
    for (int part = 0; part < SELF_PARTS; ++part) self_forces(&s->model, &s->lines, friction, part, &s->pairs, loads);
    return s->pairs.active[0] + s->pairs.active[1];
}

static Vec3 force_on(const Beside *s, int l)
{
    Vec3 sum = V3_ZERO;
    for (int i = 0; i < N; ++i) sum = v3_add(sum, vec_load(s->loads[l].f, i));
    return sum;
}

/* Square crossings press by the law, opposite on both; the details name the lines. */
TEST(test_crossing)
{
    Beside s;
    beside_new(&s);
    const double depth = 4e-4, sum = 2 * SELF_RADIUS, q = depth - depth * depth / (2 * sum);
    const double expected = 1e7 * pow(q, 1.5) * (1 - depth / sum);
    for (int k = 0; k < 8; ++k) {
        lay(&s, 0, v3(-0.95 + 0.03 * k, 0, 0), v3(1, 0, 0));
        lay(&s, 1, v3(0, -0.85, k % 2 ? sum - depth : depth - sum), v3(0, 1, 0));
        refresh(&s);
        check_above(load(&s, 1), 0);
        const Vec3 on[LINES] = {force_on(&s, 0), force_on(&s, 1)};
        check_share(on[1].z, k % 2 ? expected : -expected, 1e-12);
        check_vec(on[0], v3_scale(-1, on[1]), 1e-12 * expected);
        SelfDetail detail[64];
        const int count = self_details(&s.model, &s.lines, 1, &s.pairs, 64, detail);
        check_between(count, 0, 64);
        for (int d = 0; d < count; ++d) {
            assert_int_equal(detail[d].line, 0);
            assert_int_equal(detail[d].other, 1);
        }
        check_close(self_deepest(&s.model, &s.lines, &s.pairs).depth, depth, 1e-12);
        for (int r = 0; r < s.pairs.n_ranges; ++r)
            assert_true(s.pairs.range[r].line == 0 && s.pairs.range[r].other == 1);
        /* each may use up half of the reach, less a quarter */
        double *const z = &s.kin[k % 2].p[2][k % N], was = *z;
        *z = was + 0.74 * s.model.reach / 2;
        assert_false(self_moved_too_far(&s.model, &s.lines, &s.pairs));
        *z = was + 0.76 * s.model.reach / 2;
        assert_true(self_moved_too_far(&s.model, &s.lines, &s.pairs));
        *z = was;
    }
    beside_free(&s);
}

/* A line that may touch itself too, and one that may not. */
TEST(test_within)
{
    Beside s;
    beside_new(&s);
    for (int i = 0; i < N; ++i) { /* line 0 runs up and down again; line 1 is far away */
        const double side = i < N / 2 ? 0 : 2 * SELF_RADIUS - 1e-3, x = 0.3 * (i < N / 2 ? i : N - 1 - i);
        vec_store(s.kin[0].p, i, v3(x, 0, side));
        vec_store(s.kin[0].a, i, v3(i < N / 2 ? 1 : -1, 0, 0));
    }
    lay(&s, 1, v3(0, 50, 0), v3(1, 0, 0));
    refresh(&s);
    assert_int_equal(load(&s, 1), 0);
    s.lines.within = 1;
    refresh(&s);
    check_above(load(&s, 1), 0);
    s.model.present = 0;
    refresh(&s);
    assert_int_equal(s.pairs.candidates, 0);
    assert_int_equal(load(&s, 1), 0);
    beside_free(&s);
}

/* ------------------------------------------------------------------------------------------------- derivatives */

/* What matrices the blocks make of the whole, column-major. */
static double entry(const Beside *s, const BlockChain *chain, const double *extra, int row, int col)
{
    const int i = row / 6, j = col / 6, at = 6 * (col % 6) + row % 6;
    const int e = block_extras_find(&s->pairs.extras, i, j);
    double sum = e < 0 ? 0 : extra[36 * e + at];
    if (i == j) sum += chain->diag[36 * i + at];
    if (i == j + 1) sum += chain->lower[36 * i + at];
    if (i == j - 1) sum += chain->upper[36 * i + at];
    return sum;
}

/* Coordinate c of a segment of a line moved by `by`: shifts, turns, velocities, angular velocities. */
static void nudge(Kinematics *kin, int i, int c, double by)
{
    double **const vector[4] = {kin->p, kin->a, kin->v, kin->w};
    const Vec3 axis = v3_axis(c % 3), old = vec_load(vector[c / 3], i);
    vec_store(vector[c / 3], i, c / 3 == 1 ? quat_rotate(quat_exp(v3_scale(by, axis)), old) : v3_axpy(old, by, axis));
}

static double generalized(const Beside *s, int row)
{
    const Loads *const on = &s->loads[row / 6 / N];
    return row % 6 < 3 ? on->f[row % 6][row / 6 % N] : on->m[row % 6 - 3][row / 6 % N];
}

/* Blocks against central differences: the largest error over the largest entry, worst of forces and moments by shifts
 * and turns. */
static void compare(Beside *s, const char *what)
{
    static double found[2][SIZE][SIZE]; /* [kind][column][row] */
    BlockChain k, d;
    const double step = 1e-7;
    refresh(s);
    check_above(load(s, 1), 0);
    assert_true(block_chain_alloc(&k, ALL, 6) && block_chain_alloc(&d, ALL, 6));
    block_extras_zero(&s->pairs.extras);
    self_blocks(&s->model, &s->lines, 1, &s->pairs, &k, &d);
    for (int col = 0; col < 2 * SIZE; ++col) {
        Kinematics *const kin = &s->kin[col % SIZE / 6 / N];
        const int i = col / 6 % N, c = col % 6 + (col < SIZE ? 0 : 6);
        double *const column = found[col / SIZE][col % SIZE];
        Vec3 old[4];
        double **const vector[4] = {kin->p, kin->a, kin->v, kin->w};
        for (int v = 0; v < 4; ++v) old[v] = vec_load(vector[v], i);
        for (int side = 1; side >= -1; side -= 2) {
            nudge(kin, i, c, side * step);
            load(s, 1);
            for (int row = 0; row < SIZE; ++row)
                column[row] = side > 0 ? generalized(s, row) : (column[row] - generalized(s, row)) / (2 * step);
            for (int v = 0; v < 4; ++v) vec_store(vector[v], i, old[v]);
        }
    }
    for (int kind = 0; kind < 2; ++kind) {
        double most[4] = {0}, apart[4] = {0}, worst = 0;
        for (int col = 0; col < SIZE; ++col) {
            for (int row = 0; row < SIZE; ++row) {
                const int part = 2 * (row % 6 / 3) + col % 6 / 3;
                const double value = found[kind][col][row];
                const double block = entry(s, kind ? &d : &k, kind ? s->pairs.extras.d : s->pairs.extras.k, row, col);
                most[part] = larger_of(most[part], fabs(value));
                apart[part] = larger_of(apart[part], fabs(value - block));
            }
        }
        for (int part = 0; part < 4; ++part) worst = larger_of(worst, apart[part] / most[part]);
        print_message("%s, %s: %.1g\n", what, kind ? "D" : "K", worst);
        check_below(worst, 3e-7);
    }
    block_chain_free(&k);
    block_chain_free(&d);
}

TEST(test_blocks)
{
    uint64_t seed = 3;
    const double sum = 2 * SELF_RADIUS;
    for (int k = 0; k < 4; ++k) {
        Beside s;
        beside_new(&s);
        for (int i = 0; i < N; ++i) s.chain[1].radius[i] = SELF_RADIUS * (1 - 0.02 * i);
        lay(&s, 0, v3(-0.95, 0, 0), v3(1, 0, 0));
        lay(&s, 1, v3(0.1, -0.85, 0.95 * sum), v3(0.3 * k, 1, 0));
        shake(&s, 1e-3, 0.02, &seed);
        compare(&s, "crossing");
        beside_free(&s);
    }
    for (int k = 0; k < 2;
         ++k) { /* the last row of the one line and the first of the other are neighbours in the matrix */
        Beside s;
        beside_new(&s);
        lay(&s, 0, v3(-1.7, 0, 0), v3(1, 0, 0));
        lay(&s, 1, v3(-0.1, -0.1, sum - 5e-3), v3(0.1, 1, 0));
        shake(&s, 5e-4, 0.02, &seed);
        compare(&s, "ends across");
        beside_free(&s);
    }
}

/* Line 0 runs down onto an end of line 1 and beyond: feet are held at its tail, or at its head. */
TEST(test_held)
{
    uint64_t seed = 9;
    for (int head = 0; head < 2; ++head) {
        Beside s;
        beside_new(&s);
        lay(&s, 0, v3(-0.02, -0.91, 0), v3(0, 1, 0));
        lay(&s, 1, head ? v3(-1.87, 0, 0) : v3(0.05, 0, 0), v3(1, 0, 0));
        if (head) lay(&s, 0, v3(0, -0.91, 0), v3(0, 1, 0));
        shake(&s, 5e-4, 0.02, &seed);
        refresh(&s);
        load(&s, 1);
        SelfDetail detail[64];
        const int count = self_details(&s.model, &s.lines, 1, &s.pairs, 64, detail);
        int held = 0;
        for (int d = 0; d < count; ++d) held += detail[d].normal > 0 && detail[d].foot == (head ? N : 0);
        check_above(held, 0);
        compare(&s, head ? "held at the head" : "held at the tail");
        beside_free(&s);
    }
}

/* Heads that one eye holds lie in each other and do not press; those of two eyes, or of none, do. */
TEST(test_eyes)
{
    static const int eyes[][LINES] = {{0, 0}, {1, 2}, {2, 1}, {1, 0}, {1, 1}, {3, 3}};
    for (int k = 0; k < 6; ++k) {
        Beside s;
        beside_new(&s);
        lay(&s, 0, v3(-1.8, 0, 0), v3(1, 0, 0));
        lay(&s, 1, v3(0, 1.8, 0.05), v3(0, -1, 0)); /* the last half segments touch, and nothing else does */
        for (int l = 0; l < LINES; ++l) s.line[l].eye = eyes[k][l];
        refresh(&s);
        int heads = 0;
        for (int r = 0; r < s.pairs.n_ranges; ++r) {
            const SelfRange *const range = &s.pairs.range[r];
            heads += range->element == N && range->first + range->count == N + 1;
        }
        assert_int_equal(heads, k < 4);
        const int pressed = load(&s, 1);
        if (k < 4) check_above(pressed, 0);
        beside_free(&s);
    }
}

/* What else couples rows stands in the pattern beside what the candidates need. */
TEST(test_beside)
{
    const BlockPair more[] = {{0, 3}, {1, 11}};
    Beside s;
    beside_new(&s);
    lay(&s, 0, v3(0, 0, 0), v3(1, 0, 0));
    lay(&s, 1, v3(0, 60, 0), v3(1, 0, 0));
    s.pairs.n_beside = 2;
    s.pairs.beside = more;
    refresh(&s);
    assert_int_equal(s.pairs.extras.count, 4);
    for (int k = 0; k < 2; ++k) {
        check_at_least(block_extras_find(&s.pairs.extras, more[k].low, more[k].high), 0);
        check_at_least(block_extras_find(&s.pairs.extras, more[k].high, more[k].low), 0);
    }
    s.pairs.n_beside = 0;
    beside_free(&s);
}

/* Line l along x from `start`, of segments of `half` length. */
static void lay_fine(Beside *s, int l, Vec3 start, double half)
{
    for (int i = 0; i < N; ++i) {
        s->chain[l].half[i] = half;
        vec_store(s->kin[l].p, i, v3_axpy(start, half * (1 + 2 * i), v3(1, 0, 0)));
        vec_store(s->kin[l].a, i, v3(1, 0, 0));
    }
}

/* Side by side cables press evenly however finely either is cut, shorter than it is thick too: (CC5) at one depth, as
 * long as the shorter lies on the other. */
TEST(test_fine_segments)
{
    static const double halves[] = {0.02, 0.03, 0.04, 0.06, 0.08, 0.11};
    const double sum = 2 * SELF_RADIUS, apart = sum - 1e-3, q = (sum * sum - apart * apart) / (2 * sum);
    int shorter = 0;
    for (int a = 0; a < 6; ++a) {
        for (int b = 0; b < 6; ++b) {
            const double whole = 2 * N * halves[b];
            for (int n = 1; n <= N; ++n) {
                const double length = 2 * n * halves[a];
                if (length > 0.9 * whole) continue;
                Beside s;
                beside_new(&s);
                lay_fine(&s, 0, v3((whole - length) / 2 + 0.0037, 0, 0), halves[a]);
                lay_fine(&s, 1, v3(0, 0, apart), halves[b]);
                s.chain[0].n = n; /* the rest is not there */
                refresh(&s);
                check_above(load(&s, 0), 0);
                const double expected = s.model.law.bed / (sum * sqrt(sum)) * q * apart * length;
                check_share(force_on(&s, 1).z, expected, 1e-9);
                shorter += halves[b] < SELF_RADIUS;
                beside_free(&s);
            }
        }
    }
    check_above(shorter, 10);
}

/* The derivatives of that: feet that are several elements apart. */
TEST(test_fine_blocks)
{
    uint64_t seed = 13;
    static const double halves[][LINES] = {{0.08, 0.02}, {0.05, 0.03}, {0.03, 0.03}, {0.11, 0.035}};
    for (int k = 0; k < 4; ++k) {
        Beside s;
        beside_new(&s);
        lay_fine(&s, 0, v3(-0.7 * halves[k][0], 0, 0), halves[k][0]);
        lay_fine(&s, 1, v3(0.003, 0, 2 * SELF_RADIUS - 4e-3), halves[k][1]);
        shake(&s, 1e-4, 0.02, &seed);
        compare(&s, "fine");
        beside_free(&s);
    }
}

/* Square to each other, element against element: where only two come within reach of each other they alone are
 * candidates, and the blocks of their segments stand in the pattern, both ways; by no more than that. */
TEST(test_pattern)
{
    Beside s;
    beside_new(&s);
    s.model.reach = 0.005; /* and 5/4 of a piece of 75 mm */
    for (int e = 1; e < N; ++e) {
        for (int f = 1; f < N; ++f) { /* the elements' middles are joints */
            lay(&s, 0, v3(-0.3 * e, 0, 0), v3(1, 0, 0));
            lay(&s, 1, v3(0, -0.3 * f, 2 * SELF_RADIUS + 0.05), v3(0, 1, 0));
            refresh(&s);
            assert_int_equal(s.pairs.n_ranges, 1);
            const SelfRange *const range = &s.pairs.range[0];
            assert_true(range->element == e && range->first == f && range->count == 1);
            for (int i = 0; i < N; ++i) {
                for (int j = 0; j < N; ++j) {
                    const int there = (i == e - 1 || i == e) && (j == f - 1 || j == f);
                    assert_int_equal(block_extras_find(&s.pairs.extras, i, N + j) >= 0, there);
                    assert_int_equal(block_extras_find(&s.pairs.extras, N + j, i) >= 0, there);
                }
            }
        }
    }
    beside_free(&s);
}

/* A line that another one passes beyond its end is a candidate as far as the reach goes from that end, not farther;
 * nor is the first element, however thick others are elsewhere. */
TEST(test_beyond_ends)
{
    Beside s;
    beside_new(&s);
    s.model.reach = 0.05;
    const double length = 0.3 * N, far = 2 * SELF_RADIUS + s.model.reach + 1.25 * 0.075; /* and 5/4 of a piece */
    for (int k = 0; k < 24; ++k) {
        const double beyond = far * (0.05 + 0.11 * k);
        for (int way = 0; way < 4; ++way) { /* tail or head; which of the two lines it is */
            const int which = way / 2;
            lay(&s, which, v3(way % 2 ? beyond : -length - beyond, 0, 0), v3(1, 0, 0));
            lay(&s, 1 - which, v3(0, -length / 2, 0), v3(0, 1, 0));
            refresh(&s);
            assert_int_equal(s.pairs.n_ranges > 0, beyond <= far);
        }
    }
    beside_free(&s);
}

/* The thicker of an element's two segments counts, the first's and the last's too: a line beside it is a candidate as
 * far as that one's skin is within reach. */
TEST(test_thick_segments)
{
    for (int thick = 0; thick < N; ++thick) {
        Beside s;
        beside_new(&s);
        s.chain[0].radius[thick] = 0.12;
        s.model.reach = 0.05;
        const double joint[] = {0.3 * thick, 0.3 * thick + 0.3}; /* of its elements, where its two neighbours are */
        for (int side = 0; side < 2; ++side) {
            for (int k = 0; k < 2; ++k) {
                const double apart = 0.12 + SELF_RADIUS + (k ? 0.29 : 0.1); /* reach and 5/4 of a piece: from 0.14 on */
                lay(&s, 0, v3(-joint[side], 0, 0), v3(1, 0, 0));
                lay(&s, 1, v3(0, -0.75, apart), v3(0, 1, 0));
                refresh(&s);
                int there = 0;
                for (int r = 0; r < s.pairs.n_ranges; ++r) there += s.pairs.range[r].element == thick + side;
                assert_int_equal(there, !k);
            }
        }
        beside_free(&s);
    }
}

/* A segment of the other line that only turns uses up what is between the surfaces, as one of its own does. */
TEST(test_turned)
{
    const double gap = 0.03;
    Beside s;
    beside_new(&s);
    lay(&s, 0, v3(-0.9, 0, 0), v3(1, 0, 0));
    lay(&s, 1, v3(0, -0.9, 2 * SELF_RADIUS + gap), v3(0, 1, 0));
    refresh(&s);
    for (int part = 0; part < SELF_PARTS; ++part) self_clear_look(&s.lines, part, &s.pairs);
    int looked = 0, both = 0;
    for (int r = 0; r < s.pairs.n_ranges; ++r) {
        const SelfRange *const range = &s.pairs.range[r];
        const int part = r >= s.pairs.half, at = r - (part ? s.pairs.half : 0);
        if (!self_clear_apart(&s.lines, part, &s.pairs, r)) continue;
        const double found = s.pairs.clear[part].gap[at];
        ++looked;
        for (int k = 0; k < 2; ++k) {
            const double by = (k ? 1.02 : 0.98) * found;
            for (int l = 0; l < LINES; ++l) {
                const int i = l ? range->first : range->element, on = i < N ? i : N - 1;
                const double was = s.kin[l].a[2][on];
                s.kin[l].a[2][on] += by / s.chain[l].half[on];
                assert_int_equal(self_clear_apart(&s.lines, part, &s.pairs, r), !k);
                s.kin[l].a[2][on] = was;
            }
            if (range->element == 0 || range->element == N) continue;
            /* half from a shift of its own, half from a turn of the other's: they add up */
            const int other = range->first < N ? range->first : N - 1;
            double *const z = &s.kin[0].p[2][range->element], *const a = &s.kin[1].a[2][other];
            const double was[2] = {*z, *a};
            *z += by / 2;
            *a += by / 2 / s.chain[1].half[other];
            assert_int_equal(self_clear_apart(&s.lines, part, &s.pairs, r), !k);
            *z = was[0];
            *a = was[1];
            /* six tenths from either side, by shifts or by turns: neither alone uses up the gap, both do */
            for (int how = 0; how < 4; ++how) {
                const int own = range->element;
                double *const mine = how & 1 ? &s.kin[0].a[2][own] : &s.kin[0].p[2][own];
                double *const its = how & 2 ? &s.kin[1].a[2][other] : &s.kin[1].p[2][other];
                const double old[2] = {*mine, *its}, each = 0.6 * found;
                *mine += each / (how & 1 ? s.chain[0].half[own] : 1);
                assert_true(self_clear_apart(&s.lines, part, &s.pairs, r));
                *its += each / (how & 2 ? s.chain[1].half[other] : 1);
                assert_false(self_clear_apart(&s.lines, part, &s.pairs, r));
                *mine = old[0];
                assert_true(self_clear_apart(&s.lines, part, &s.pairs, r));
                *its = old[1];
            }
            ++both;
        }
    }
    check_above(looked, 0);
    check_above(both, 0);
    beside_free(&s);
}

/* Line 0 bends over line 1, which lies just where the middle of the bend's two centres is, and by so much beside it. */
static Vec3 bent_over(double beside)
{
    const double half = 0.25, lean = 0.55;
    Beside s;
    beside_new(&s);
    for (int i = 0; i < N; ++i) {
        const int before = i < N / 2;
        const double out = half * (before ? 2 * (N / 2 - i) - 1 : 2 * (i - N / 2) + 1); /* m along, from the joint */
        s.chain[0].half[i] = s.chain[1].half[i] = half;
        vec_store(s.kin[0].a, i, v3(cos(lean), 0, before ? sin(lean) : -sin(lean)));
        vec_store(s.kin[0].p, i, v3((before ? -out : out) * cos(lean), 0, half * sin(lean) - out * sin(lean)));
        vec_store(s.kin[1].a, i, v3(0, 1, 0));
        vec_store(s.kin[1].p, i, v3(0, half * (2 * i - (N - 1)), beside));
    }
    refresh(&s);
    check_above(load(&s, 0), 0);
    const Vec3 force = force_on(&s, 0);
    beside_free(&s);
    return force;
}

/* Where the middle between two centres is on the other line to the last bit, there is no direction from the one to the
 * other: the bend presses as it does just above and just below. */
TEST(test_through_the_middle)
{
    const double step = 1e-6;
    const Vec3 on = bent_over(0), above = bent_over(step), below = bent_over(-step);
    check_above(on.z, 0);
    /* what is left is the second difference: step squared, over the depth of some mm squared */
    check_vec(on, v3_scale(0.5, v3_add(above, below)), 1e-6 * on.z);
}

/* Of the ranges that are looked at, none is known to be apart. */
TEST(test_apart_is_not_looked_at)
{
    Beside s;
    beside_new(&s);
    lay(&s, 0, v3(-0.93, 0, 0), v3(1, 0, 0));
    lay(&s, 1, v3(0, -0.86, 2 * SELF_RADIUS + 0.03), v3(0, 1, 0)); /* the spheres around the elements meet */
    refresh(&s);
    assert_int_equal(load(&s, 1), 0);
    int apart = 0;
    for (int part = 0; part < SELF_PARTS; ++part) {
        const int from = part ? s.pairs.half : 0, to = part ? s.pairs.n_ranges : s.pairs.half;
        int may = 0;
        for (int r = from; r < to; ++r) may += !self_clear_apart(&s.lines, part, &s.pairs, r);
        check_at_most(s.pairs.clear[part].vain, may);
        apart += to - from - may;
    }
    print_message("%d of %d ranges apart\n", apart, s.pairs.n_ranges);
    check_above(apart, 0);
    beside_free(&s);
}

/* Damping takes from the force in proportion to the speed at which the cables part, until nothing is left: then no
 * piece presses, and what the bed has goes into the damping. */
TEST(test_parting)
{
    static const double share[] = {0, 0.25, 0.75, 1, 1.5, 40};
    double still = 0;
    for (int k = 0; k < 6; ++k) {
        Beside s;
        beside_new(&s);
        lay(&s, 0, v3(-0.93, 0, 0), v3(1, 0, 0));
        lay(&s, 1, v3(0, -0.86, 2 * SELF_RADIUS - 4e-3), v3(0, 1, 0));
        for (int i = 0; i < N; ++i) vec_store(s.kin[1].v, i, v3(0, 0, share[k] / s.model.law.dissipation));
        refresh(&s);
        const int pressed = load(&s, 0);
        if (k == 0) still = force_on(&s, 1).z;
        if (share[k] < 1) {
            check_above(pressed, 0);
            check_share(force_on(&s, 1).z, (1 - share[k]) * still, 1e-12);
        } else {
            assert_int_equal(pressed, 0);
            check_vec(force_on(&s, 1), V3_ZERO, 0);
        }
        const double damping = s.pairs.work[0].damping + s.pairs.work[1].damping,
                     rate = share[k] / s.model.law.dissipation;
        check_close(damping, fmin(share[k], 1) * still * rate, 1e-12 * still * rate);
        beside_free(&s);
    }
}

/* Cables that have gone apart since the candidates were found do not press, at their ends either. */
TEST(test_gone)
{
    for (int end = 0; end < 3; ++end) { /* line 0 lies across line 1's tail, its middle, its head */
        Beside s;
        beside_new(&s);
        lay(&s, 0, v3(-0.93, 0, 0), v3(1, 0, 0));
        lay(&s, 1, v3(0, -0.05 - 0.85 * end, 2 * SELF_RADIUS - 1e-3), v3(0, 1, 0));
        refresh(&s);
        check_above(load(&s, 1), 0);
        for (int i = 0; i < N; ++i) s.kin[1].p[2][i] += 0.5;
        assert_int_equal(load(&s, 1), 0);
        check_vec(force_on(&s, 0), V3_ZERO, 0);
        check_equal(self_deepest(&s.model, &s.lines, &s.pairs).depth, -INFINITY);
        beside_free(&s);
    }
}
