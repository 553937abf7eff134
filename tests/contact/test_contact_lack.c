/* Every allocation of contact fails once: it is said, nothing else is harmed, and the next try gives the same bits as
 * if nothing had been. */
#include "tests/support/lack.h"

#include "tests/support/touch.h"

enum { N = 12, MOST = 500 };

static const FrictionLaw sticky = {.mu_s = 0.3, .mu_d = 0.2, .v_s = 5e-3, .v_d = 2e-2, .d_s = 1e-3};

/* What may lack memory: 0, or MEMORY. `again`: once more with memory; the forces of it all. */
typedef struct Trial {
    hawser_status (*attempt)(void *of);
    void (*loads)(void *of, double sums[7]); /* of what has been made, by an attempt that may have been the second */
    void *of;
} Trial;

static void every_allocation(const Trial *t, int least)
{
    double whole[7], sums[7];
    lack_after(MOST);
    assert_int_equal(t->attempt(t->of), HAWSER_OK);
    assert_false(lack_end());
    t->loads(t->of, whole);
    check_above(fabs(whole[2]), 1);
    int met = 1, lacked = 0;
    for (int k = 0; met; ++k) {
        lack_after(k);
        const hawser_status status = t->attempt(t->of);
        met = lack_end();
        if (status) { /* qsort() goes without, which is no matter */
            assert_true(met);
            assert_int_equal(status, HAWSER_ERR_MEMORY);
            assert_int_equal(t->attempt(t->of), HAWSER_OK);
            ++lacked;
        }
        t->loads(t->of, sums);
        assert_memory_equal(sums, whole, sizeof sums);
    }
    check_between(lacked, least, MOST);
}

/* Forces and moments, weighed by the segments' numbers, and how many candidates they come of. */
static void sum_up(const Loads *loads, int n, int candidates, double sums[7])
{
    memset(sums, 0, 7 * sizeof *sums);
    sums[6] = candidates;
    for (int i = 0; i < n; ++i) {
        for (int c = 0; c < 3; ++c) {
            sums[c] += (i + 1) * loads->f[c][i];
            sums[3 + c] += (i + 1) * loads->m[c][i];
        }
    }
}

/* What one wrote is read by the other, which need not have room for it. */
static hawser_status read_over(void (*keep)(Checkpoint *c, void *of), void *from, void *to)
{
    const long left = lack_left();
    lack_after(-1); /* writing is not what is tried */
    Checkpoint c = checkpoint_new(1 << 20);
    keep(&c, from);
    assert_int_equal(c.status, HAWSER_OK);
    Checkpoint back = checkpoint_over(c.bytes, c.size, NULL);
    lack_after(left);
    keep(&back, to);
    checkpoint_free(&c);
    return back.status;
}

/* ------------------------------------------------------------------------------------------------ on rollers */

typedef struct Rollers {
    TestScene s;
    ContactPairs other;
} Rollers;

static void keep_rollers(Checkpoint *c, void *of)
{
    Rollers *const r = of;
    contact_pairs_checkpoint(c, &r->s.model, c->reading ? &r->other : &r->s.pairs);
}

/* Pairs, their candidates and what sticks anew, then written and read into others. */
static hawser_status rollers_attempt(void *of)
{
    Rollers *const r = of;
    contact_pairs_free(&r->s.pairs);
    contact_pairs_free(&r->other);
    if (!contact_pairs_alloc(&r->s.pairs, N)) return HAWSER_ERR_MEMORY;
    hawser_error err = {0};
    const hawser_status status = contact_refresh(&r->s.model, &r->s.chain, &r->s.kin, &r->s.pairs, &err);
    assert_int_equal(status, err.status);
    if (status) return status;
    contact_accept(&r->s.model, &r->s.chain, &r->s.kin, 0.1, &r->s.pairs);
    if (!contact_pairs_alloc(&r->other, N)) return HAWSER_ERR_MEMORY;
    return read_over(keep_rollers, r, r);
}

static void rollers_loads(void *of, double sums[7])
{
    Rollers *const r = of;
    const ContactPairs kept = r->s.pairs;
    double same[7];
    scene_forces(&r->s, 1);
    sum_up(&r->s.loads, N, kept.candidates, sums);
    r->s.pairs = r->other;
    scene_forces(&r->s, 1);
    r->other = r->s.pairs;
    r->s.pairs = kept;
    sum_up(&r->s.loads, N, r->other.candidates, same);
    assert_memory_equal(same, sums, sizeof same);
}

TEST(test_rollers)
{
    if (!lack_works()) skip();
    Rollers r = {.other = {0}};
    scene_new(&r.s, GEOMETRY_SMOOTH, N, 0.5);
    scene_roller(&r.s, v3(1.1, 0, -0.1 - 0.04365 + 1e-3), v3(0, 1, 0), 0.1, 0.2)->friction = sticky;
    scene_roller(&r.s, v3(4.1, 0, -0.1 - 0.04365 + 1e-3), v3(0, 1, 0), 0.1, 0.2);
    r.s.model.reach = 0.2;
    every_allocation(&(Trial){rollers_attempt, rollers_loads, &r}, 15);
    contact_pairs_free(&r.other);
    scene_free(&r.s);
}

/* A refresh that lacks memory for more candidates than ever: the next one has them. */
TEST(test_more_candidates)
{
    if (!lack_works()) skip();
    enum { LONG = 200 };
    for (int k = 0; k < 3; ++k) {
        TestScene s, all;
        scene_new(&s, GEOMETRY_SMOOTH, LONG, 0.1);
        scene_new(&all, GEOMETRY_SMOOTH, LONG, 0.1);
        for (int r = 0; r < 4; ++r) {
            scene_roller(&s, v3(4.0 * r + 1, 0, -0.1 - 0.04365 + 1e-3), v3(0, 1, 0), 0.1, 0.2);
            scene_roller(&all, v3(4.0 * r + 1, 0, -0.1 - 0.04365 + 1e-3), v3(0, 1, 0), 0.1, 0.2);
        }
        s.model.reach = 1e-3;
        scene_refresh(&s);
        s.model.reach = all.model.reach = 2;
        hawser_error err = {0};
        lack_after(k);
        const hawser_status status = contact_refresh(&s.model, &s.chain, &s.kin, &s.pairs, &err);
        const int met = lack_end();
        if (status != (met ? HAWSER_ERR_MEMORY : HAWSER_OK)) fail_msg("allocation %d: status %d", k, status);
        if (k == 0) assert_true(met);
        scene_refresh(&s);
        scene_refresh(&all);
        assert_int_equal(s.pairs.candidates, all.pairs.candidates);
        assert_int_equal(s.pairs.n_ranges, all.pairs.n_ranges);
        assert_memory_equal(s.pairs.range, all.pairs.range, (size_t)all.pairs.n_ranges * sizeof *all.pairs.range);
        scene_free(&s);
        scene_free(&all);
    }
}

/* ---------------------------------------------------------------------------------------------- cable on cable */

typedef struct Turns {
    SelfScene s;
    SelfPairs other;
} Turns;

static void keep_turns(Checkpoint *c, void *of)
{
    Turns *const t = of;
    self_pairs_checkpoint(c, SELF_ALONE(&t->s.chain, &t->s.kin), c->reading ? &t->other : &t->s.pairs);
}

static hawser_status turns_attempt(void *of)
{
    Turns *const t = of;
    const int n = t->s.chain.n;
    self_pairs_free(&t->s.pairs);
    self_pairs_free(&t->other);
    if (!self_pairs_alloc(&t->s.pairs, 1, &n)) return HAWSER_ERR_MEMORY;
    hawser_error err = {0};
    const hawser_status status = self_refresh(&t->s.model, SELF_ALONE(&t->s.chain, &t->s.kin), &t->s.pairs, &err);
    assert_int_equal(status, err.status);
    if (status) return status;
    if (!self_pairs_alloc(&t->other, 1, &n)) return HAWSER_ERR_MEMORY;
    return read_over(keep_turns, t, t);
}

static void turns_loads(void *of, double sums[7])
{
    Turns *const t = of;
    const SelfPairs kept = t->s.pairs;
    double same[7];
    self_load(&t->s, 1);
    sum_up(&t->s.loads, t->s.chain.n, kept.candidates, sums);
    t->s.pairs = t->other;
    self_load(&t->s, 1);
    t->other = t->s.pairs;
    t->s.pairs = kept;
    sum_up(&t->s.loads, t->s.chain.n, t->other.candidates, same);
    assert_memory_equal(same, sums, sizeof same);
}

TEST(test_self)
{
    if (!lack_works()) skip();
    Turns t = {.other = {0}};
    uint64_t seed = 4;
    self_new(&t.s, 32, 0.25);
    self_helix(&t.s, 0.5, 2 * SELF_RADIUS - 2e-3);
    self_shake(&t.s, 5e-4, 0.01, &seed);
    every_allocation(&(Trial){turns_attempt, turns_loads, &t}, 20);
    self_pairs_free(&t.other);
    self_free(&t.s);
}

/* ------------------------------------------------------------------------------------------------ on surfaces */

static hawser_status floor_attempt(void *of)
{
    SurfaceScene *const s = of;
    surface_points_free(&s->points);
    surface_pairs_free(&s->pairs);
    if (!surface_points_alloc(&s->points, GEOMETRY_SMOOTH, &s->chain)) return HAWSER_ERR_MEMORY;
    surface_pairs_init(&s->pairs, 0, s->points.elements);
    if (!surface_pairs_sticks(&s->pairs, &s->model, N)) return HAWSER_ERR_MEMORY;
    hawser_error err = {0};
    const hawser_status status = surface_refresh(&s->model, &s->chain, &s->kin, &s->pairs, &err);
    assert_int_equal(status, err.status);
    if (!status) surface_accept(&s->model, &s->chain, &s->kin, 0.1, &s->pairs);
    return status;
}

static void floor_loads(void *of, double sums[7])
{
    SurfaceScene *const s = of;
    surfaces_forces(s, 1);
    sum_up(&s->loads, N, s->pairs.candidates, sums);
}

TEST(test_surfaces)
{
    if (!lack_works()) skip();
    SurfaceScene s;
    surfaces_new(&s, N, 0.5);
    for (int k = 0; k < 2; ++k) {
        SurfaceShape shape = surfaces_shape(SURFACE_PLANE, 0, 0);
        shape.point = v3(0, 0, -CABLE_RADIUS);
        shape.length = shape.width = 0;
        surfaces_add(&s, &shape);
        s.friction[k] = sticky;
    }
    for (int i = 0; i < N; ++i) s.kin.p[2][i] -= 1e-4;
    for (int i = 0; i < N; ++i) s.kin.v[0][i] = 1e-3;
    every_allocation(&(Trial){floor_attempt, floor_loads, &s}, 4);
    surfaces_free(&s);
}
