/* Several chains: what links and contact do to them is the derivative of nothing else, momentum and angular momentum
 * stay among them, and chains that do nothing to each other are computed as if each were alone. */
#include "tests/support/touch.h"

#include <stdlib.h>
#include <string.h>

#include "sim/solve/chains.h"
#include "tests/support/check.h"

enum { LINES = 3, EACH = 7, ROWS = LINES * EACH };

/* Three chains in space, with the blocks of all. */
typedef struct Threefold {
    Chain chain[LINES];
    Kinematics kin[LINES];
    SelfLine line[LINES];
    Loads load[LINES], *loads[LINES];
    SelfModel model;
    SelfPairs pairs;
    Link link[3];
    BlockPair linked[3];
    BlockChain k, d;
} Threefold;

static void place(Threefold *t, int l, int i, Vec3 p, Quat q, Vec3 v, Vec3 w)
{
    Kinematics *const kin = &t->kin[l];
    const double attitude[4] = {q.w, q.x, q.y, q.z};
    v3_store(kin->p, i, p);
    v3_store(kin->v, i, v);
    v3_store(kin->w, i, w);
    v3_store(kin->a, i, quat_rotate(q, v3(1, 0, 0)));
    for (int c = 0; c < 4; ++c) kin->q[c][i] = attitude[c];
}

/* A triangle of lines along x that press on each other by some millimetres, shaken. Line 1 has other lengths. */
static void threefold_new(Threefold *t, uint64_t *seed)
{
    const int segments[LINES] = {EACH, EACH, EACH};
    const double across[LINES][2] = {{-0.0205, 0}, {0.0195, 0.001}, {0.0005, 0.0345}};
    memset(t, 0, sizeof *t);
    for (int l = 0; l < LINES; ++l) {
        assert_true(chain_alloc(&t->chain[l], EACH) && kinematics_alloc(&t->kin[l], EACH));
        assert_true(chain_struct_alloc(&t->load[l], EACH));
        t->loads[l] = &t->load[l];
        t->line[l] = (SelfLine){&t->chain[l], &t->kin[l], EACH * l};
        double from = 0.05 * l;
        for (int i = 0; i < EACH; ++i) {
            const double h = l == 1 ? 0.17 : 0.2;
            t->chain[l].half[i] = h / 2;
            t->chain[l].radius[i] = 0.021;
            const Vec3 p = v3(from + h / 2, across[l][0], across[l][1]);
            place(t, l, i, v3_axpy(p, 5e-4, fixture_vector(seed, 1)), quat_exp(v3_scale(5e-3, fixture_vector(seed, 1))),
                  v3_scale(0.02, fixture_vector(seed, 1)), v3_scale(0.05, fixture_vector(seed, 1)));
            from += h;
        }
    }
    const ImpactLaw impact = {.k = 1e7, .e = 1.5, .c = 2e3, .d = 1e-3};
    const FrictionLaw friction = {.mu_s = 0.3, .mu_d = 0.2, .v_s = 5e-3, .v_d = 2e-2};
    t->model = (SelfModel){.present = 1, .law = self_law(&impact, &friction), .reach = 0.02};
    t->link[0] = (Link){{0, 2}, {6, 0}, {v3(0.1, 0.01, 0), v3(-0.12, -0.02, 0.03)}, 2e4, 30, 1};
    t->link[1] = (Link){{1, 0}, {3, 3}, {v3(0.02, 0.02, 0), v3(0.01, -0.02, 0.001)}, 1e4, 10, 0};
    t->link[2] = (Link){{1, 2}, {0, 6}, {v3(0, 0, 0.02), v3(0.05, 0, 0)}, 500, 2, 0};
    for (int i = 0; i < 3; ++i) {
        const int a = EACH * t->link[i].line[0] + t->link[i].segment[0];
        const int b = EACH * t->link[i].line[1] + t->link[i].segment[1];
        t->linked[i] = a < b ? (BlockPair){a, b} : (BlockPair){b, a};
    }
    assert_true(self_pairs_alloc(&t->pairs, LINES, segments));
    t->pairs.n_beside = 3;
    t->pairs.beside = t->linked;
    assert_true(block_chain_alloc(&t->k, ROWS, 6) && block_chain_alloc(&t->d, ROWS, 6));
}

static void threefold_free(Threefold *t)
{
    for (int l = 0; l < LINES; ++l) {
        chain_free(&t->chain[l]);
        kinematics_free(&t->kin[l]);
        chain_struct_free(&t->load[l]);
    }
    self_pairs_free(&t->pairs);
    block_chain_free(&t->k);
    block_chain_free(&t->d);
}

static SelfLines lines_of(const Threefold *t) { return (SelfLines){LINES, t->line, 0}; }

/* All forces of contact and links, or of one of the two. */
static void interact(Threefold *t, int contact, int links)
{
    const SelfLines lines = lines_of(t);
    for (int l = 0; l < LINES; ++l) loads_zero(&t->load[l], EACH);
    for (int part = 0; contact && part < SELF_PARTS; ++part)
        self_forces(&t->model, &lines, 1, part, &t->pairs, t->loads);
    for (int i = 0; i < links; ++i) {
        const LinkNow now = link_now(&t->link[i], t->line);
        link_load(&t->link[i], &now, t->loads);
    }
}

/* Row r of all loads. */
static double load_at(const Threefold *t, int r)
{
    const Loads *const load = &t->load[r / 6 / EACH];
    return (r % 6 < 3 ? load->f : load->m)[r % 3][r / 6 % EACH];
}

/* Moves a coordinate of a segment: 0..2 a shift, 3..5 a turn, 6..8 a velocity, 9..11 an angular velocity. */
static void move(Threefold *t, int row, int c, double by)
{
    Kinematics *const kin = &t->kin[row / EACH];
    const int i = row % EACH;
    const Vec3 axis = v3_axis(c % 3);
    if (c < 3) v3_store(kin->p, i, v3_axpy(v3_load(kin->p, i), by, axis));
    if (c >= 6) {
        double *const *const of = c < 9 ? kin->v : kin->w;
        v3_store(of, i, v3_axpy(v3_load(of, i), by, axis));
    }
    if (c < 3 || c >= 6) return;
    const Quat q =
        quat_mul(quat_exp(v3_scale(by, axis)), (Quat){kin->q[0][i], kin->q[1][i], kin->q[2][i], kin->q[3][i]});
    place(t, row / EACH, i, v3_load(kin->p, i), q, v3_load(kin->v, i), v3_load(kin->w, i));
}

static double entry(const Threefold *t, int speeds, int row, int col)
{
    const BlockChain *const chain = speeds ? &t->d : &t->k;
    const int i = row / 6, j = col / 6, at = 6 * (col % 6) + row % 6;
    double value = 0;
    if (i == j) value += chain->diag[36 * i + at];
    if (i == j + 1) value += chain->lower[36 * i + at];
    if (i == j - 1) value += chain->upper[36 * i + at];
    const int e = block_extras_find(&t->pairs.extras, i, j);
    return value + (e < 0 ? 0 : (speeds ? t->pairs.extras.d : t->pairs.extras.k)[36 * e + at]);
}

/* Largest difference of K and D from central differences over the largest entry of the same kind: force or moment by
 * place, turn, velocity, angular velocity. */
static double twin_differs(Threefold *t, int contact, int links)
{
    double most[8] = {0}, apart[8] = {0}, worst = 0, plus[6 * ROWS];
    const double step = contact ? 1e-7 : 1e-5; /* a bed that is pressed in part ends within a few steps */
    for (int row = 0; row < ROWS; ++row) {
        for (int c = 0; c < 12; ++c) {
            move(t, row, c, step);
            interact(t, contact, links);
            for (int r = 0; r < 6 * ROWS; ++r) plus[r] = load_at(t, r);
            move(t, row, c, -2 * step);
            interact(t, contact, links);
            move(t, row, c, step);
            for (int r = 0; r < 6 * ROWS; ++r) {
                const int kind = 2 * (c / 3) + r % 6 / 3;
                const double slope = (plus[r] - load_at(t, r)) / (2 * step);
                most[kind] = fmax(most[kind], fabs(slope));
                apart[kind] = fmax(apart[kind], fabs(slope - entry(t, c >= 6, r, 6 * row + c % 6)));
            }
        }
    }
    for (int k = 0; k < 8; ++k) worst = fmax(worst, most[k] > 0 ? apart[k] / most[k] : 1);
    return worst;
}

/* (SC8), and (CC13)-(CC17) between lines: the analytic blocks are the derivatives of the forces. */
TEST(test_twins)
{
    uint64_t seed = 11;
    for (int contact = 0; contact < 2; ++contact) {
        Threefold t;
        threefold_new(&t, &seed);
        const SelfLines lines = lines_of(&t);
        assert_int_equal(self_refresh(&t.model, &lines, &t.pairs, NULL), HAWSER_OK);
        interact(&t, contact, contact ? 0 : 3);
        if (contact) check_at_least(t.pairs.active[0] + t.pairs.active[1], 30);
        block_extras_zero(&t.pairs.extras);
        if (contact) self_blocks(&t.model, &lines, 1, &t.pairs, &t.k, &t.d);
        for (int i = 0; !contact && i < 3; ++i) link_blocks(&t.link[i], t.line, &t.k, &t.d, &t.pairs.extras);
        const double differs = twin_differs(&t, contact, contact ? 0 : 3);
        print_message("%s: %.1g\n", contact ? "contact" : "links", differs);
        check_below(differs, contact ? 1e-6 : 1e-7);
        threefold_free(&t);
    }
}

/* Forces and moments about the origin of all chains vanish together. */
TEST(test_momentum)
{
    uint64_t seed = 12;
    Threefold t;
    threefold_new(&t, &seed);
    const SelfLines lines = lines_of(&t);
    assert_int_equal(self_refresh(&t.model, &lines, &t.pairs, NULL), HAWSER_OK);
    interact(&t, 1, 3);
    Vec3 force = V3_ZERO, moment = V3_ZERO;
    double size = 0;
    for (int row = 0; row < ROWS; ++row) {
        const int l = row / EACH, i = row % EACH;
        const Vec3 f = v3_load(t.load[l].f, i), m = v3_load(t.load[l].m, i);
        force = v3_add(force, f);
        moment = v3_add(moment, v3_add(m, v3_cross(v3_load(t.kin[l].p, i), f)));
        size += v3_norm(f) + v3_norm(m);
    }
    check_below(v3_norm(force) / size, 1e-13);
    check_below(v3_norm(moment) / size, 1e-12);
    threefold_free(&t);
}

/* What a link's forces do to the motion is what its damper takes and its spring stores: -dE/dt - loss. */
TEST(test_link_power)
{
    uint64_t seed = 13;
    Threefold t;
    threefold_new(&t, &seed);
    for (int k = 0; k < 3; ++k) {
        const Link *const link = &t.link[k];
        const double dt = 1e-6;
        double energy[2];
        for (int l = 0; l < LINES; ++l) loads_zero(&t.load[l], EACH);
        const LinkNow now = link_now(link, t.line);
        link_load(link, &now, t.loads);
        double power = 0;
        for (int row = 0; row < ROWS; ++row) {
            const int l = row / EACH, i = row % EACH;
            power += v3_dot(v3_load(t.load[l].f, i), v3_load(t.kin[l].v, i)) +
                     v3_dot(v3_load(t.load[l].m, i), v3_load(t.kin[l].w, i));
        }
        for (int way = 0; way < 2; ++way) { /* all segments go on as they move, and back */
            for (int row = 0; row < ROWS; ++row) {
                const double by = way ? -2 * dt : dt;
                const Vec3 v = v3_load(t.kin[row / EACH].v, row % EACH), w = v3_load(t.kin[row / EACH].w, row % EACH);
                const double rate[6] = {v.x, v.y, v.z, w.x, w.y, w.z};
                for (int c = 0; c < 6; ++c) move(&t, row, c, by * rate[c]);
            }
            const LinkNow then = link_now(link, t.line);
            energy[way] = link_energy(link, &then);
        }
        const double stored = (energy[0] - energy[1]) / (2 * dt), lost = link_lost(link, &now);
        check_below(fabs(power + stored + lost), 1e-6 * (fabs(stored) + lost));
        for (int row = 0; row < ROWS; ++row) { /* back where it was */
            const Vec3 v = v3_load(t.kin[row / EACH].v, row % EACH), w = v3_load(t.kin[row / EACH].w, row % EACH);
            const double rate[6] = {v.x, v.y, v.z, w.x, w.y, w.z};
            for (int c = 0; c < 6; ++c) move(&t, row, c, dt * rate[c]);
        }
    }
    threefold_free(&t);
}

/* Heads that one eye holds do not press on each other at their ends (SC9); everything else presses as before. */
TEST(test_heads)
{
    uint64_t seed = 14;
    Threefold t;
    threefold_new(&t, &seed);
    for (int i = 0; i < EACH; ++i) { /* one as long as the other, so that the ends lie side by side */
        Vec3 p = v3_load(t.kin[1].p, i);
        t.chain[1].half[i] = 0.1;
        p.x = 0.1 + 0.2 * i;
        v3_store(t.kin[1].p, i, p);
        p = v3_load(t.kin[0].p, i);
        p.x = 0.1 + 0.2 * i;
        v3_store(t.kin[0].p, i, p);
    }
    const SelfLines lines = lines_of(&t);
    double ends[3] = {0}, others[3] = {0};
    const int eye[3][2] = {{0, 0}, {1, 2}, {1, 1}};
    for (int k = 0; k < 3; ++k) {
        SelfDetail detail[400];
        for (int l = 0; l < 2; ++l) t.line[l].eye = eye[k][l];
        assert_int_equal(self_refresh(&t.model, &lines, &t.pairs, NULL), HAWSER_OK);
        const int n = self_details(&t.model, &lines, 1, &t.pairs, 400, detail);
        assert_in_range(n, 1, 400);
        for (int i = 0; i < n; ++i) {
            const SelfDetail *const d = &detail[i];
            const int pair = d->line == 0 && d->other == 1, end = pair && d->element == EACH && d->foot == EACH;
            /* a piece whose feet are on either side of where the ends begin belongs to neither */
            if (end) ends[k] += d->normal;
            if (!pair || d->element < EACH - 1) others[k] += d->normal;
        }
    }
    check_above(ends[0], 1);
    check_equal(ends[1], ends[0]);
    check_equal(ends[2], 0);
    check_equal(others[1], others[0]);
    check_equal(others[2], others[0]);
    threefold_free(&t);
}

/* What is known to be apart is left out, and no force with it: cables that are drawn along and come nearer by and by,
 * with what was known and with gaps that are taken anew, bit for bit. */
TEST(test_apart)
{
    enum { STEPS = 60 };
    Threefold t;
    uint64_t seed = 21;
    double known[6 * ROWS];
    int left_out = 0, pressed = 0;
    threefold_new(&t, &seed);
    const SelfLines lines = lines_of(&t);
    hawser_error err = {0};
    for (int i = 0; i < EACH; ++i) move(&t, 2 * EACH + i, 2, 0.012);
    assert_int_equal(self_refresh(&t.model, &lines, &t.pairs, &err), HAWSER_OK);
    for (int step = 0; step < STEPS; ++step) {
        for (int row = 0; row < ROWS; ++row) {
            move(&t, row, 0, 0.05);
            move(&t, row, 3 + (int)(seed % 3), 1e-3 * fixture_vector(&seed, 1).x);
            if (row >= 2 * EACH) move(&t, row, 2, -2.5e-4);
        }
        interact(&t, 1, 0);
        for (int part = 0; part < SELF_PARTS; ++part) {
            const int from = part ? t.pairs.half : 0, to = part ? t.pairs.n_ranges : t.pairs.half;
            for (int r = from; r < to; ++r) left_out += self_clear_apart(&lines, part, &t.pairs, r);
            pressed += t.pairs.active[part];
        }
        for (int r = 0; r < 6 * ROWS; ++r) known[r] = load_at(&t, r);
        for (int part = 0; part < SELF_PARTS; ++part)
            memset(t.pairs.clear[part].gap, 0, sizeof(double) * (size_t)t.pairs.n_ranges);
        interact(&t, 1, 0); /* looks at all */
        for (int r = 0; r < 6 * ROWS; ++r) check_equal(load_at(&t, r), known[r]);
        if (step % 10 == 9)
            for (int part = 0; part < SELF_PARTS; ++part) t.pairs.clear[part].known = 0;
    }
    check_above(left_out, 100);
    check_above(pressed, 100);
    threefold_free(&t);
}
