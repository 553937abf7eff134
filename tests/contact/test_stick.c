/* Friction that sticks: its derivatives, what it remembers, that it slides with the full force, that a step's end
 * changes no force, and that it never gives more work than it took. */
#include "tests/support/touch.h"

#include <math.h>

#include "tests/support/contact_fd.h"

enum { N = 6 };

static const FrictionLaw sticky = {.mu_s = 0.3, .mu_d = 0.2, .v_s = 5e-3, .v_d = 2e-2, .d_s = 1e-3};

/* A level chain pressed 1 mm onto one flat and one grooved roller. */
static void level_scene(TestScene *s, FrictionLaw law)
{
    scene_new(s, GEOMETRY_SMOOTH, N, 0.5);
    const double radius = s->chain.radius[0];
    scene_roller(s, v3(1.1, 0, -0.1 - radius + 1e-3), v3(0, 1, 0), 0.1, 0.2)->friction = law;
    ContactRoller *const v = scene_roller(s, v3(2.1, 0, -0.08 - (radius - 1e-3) / sin(0.8)), v3(0, 1, 0), 0.08, 0.25);
    v->friction = law;
    v->shape.kind = SHAPE_V_GROOVE;
    v->shape.groove = groove_v(0.8, 0.1);
    scene_refresh(s);
}

/* All segments at one velocity. */
static void speed_set(TestScene *s, Vec3 v)
{
    for (int i = 0; i < N; ++i) vec_store(s->kin.v, i, v);
}

/* A step of length h at velocity v, moved and accepted; t counts on. */
static void step_take(TestScene *s, Vec3 v, double h, double *t)
{
    speed_set(s, v);
    for (int i = 0; i < N; ++i) vec_store(s->kin.p, i, v3_axpy(vec_load(s->kin.p, i), h, v));
    *t += h;
    contact_accept(&s->model, &s->chain, &s->kin, *t, &s->pairs);
}

/* The friction along the chain that the rollers do, N, at the present velocity. */
static double friction_along(TestScene *s)
{
    scene_forces(s, 1);
    return -s->on_roller[0].x - s->on_roller[1].x;
}

TEST(test_grips_like_a_spring)
{
    TestScene s;
    level_scene(&s, sticky);
    double t = 0;
    scene_forces(&s, 1);
    const double N_flat = -s.on_roller[0].z;
    check_equal(s.pairs.active, 3);
    check_close(friction_along(&s), 0, 1e-12 * N_flat);
    /* 0.1 mm in ten steps, then at rest: the odd STEP of displacement over d_s, however long it lasts */
    for (int i = 0; i < 10; ++i) step_take(&s, v3(1e-3, 0, 0), 0.01, &t);
    speed_set(&s, v3(0, 0, 0));
    for (int i = 0; i < 3; ++i) {
        scene_forces(&s, 1);
        const double x = 0.1, called = (3 * x - x * x * x) / 2;
        check_share(s.on_roller[0].x, sticky.mu_s * called * N_flat, 1e-12);
        step_take(&s, v3(0, 0, 0), 3600, &t);
    }
    scene_free(&s);
}

/* Sliding on, over several elements: the coefficient of ADAMS' law at every speed, and back the same. */
TEST(test_slides_like_adams)
{
    FrictionLaw adams = sticky;
    adams.d_s = 0;
    const double speeds[] = {6e-3, 1.2e-2, 0.1, -0.1, -8e-3};
    TestScene s, r;
    level_scene(&s, sticky);
    level_scene(&r, adams);
    double t = 0;
    for (int k = 0; k < 5; ++k) {
        const Vec3 v = v3(speeds[k], 0.2 * speeds[k], 0);
        for (int i = 0; i < 40; ++i) step_take(&s, v, 0.05, &t);
        for (int i = 0; i < N; ++i) {
            vec_store(r.kin.p, i, vec_load(s.kin.p, i));
            vec_store(r.kin.v, i, v);
        }
        scene_forces(&r, 1);
        scene_forces(&s, 1);
        for (int m = 0; m < 2; ++m) {
            check_vec(s.on_roller[m], r.on_roller[m], 1e-12 * v3_norm(r.on_roller[m]));
        }
    }
    scene_free(&s);
    scene_free(&r);
}

/* A contact that goes on to the next element takes its lean along; one that lifts off forgets it. */
TEST(test_lean_goes_along)
{
    TestScene s;
    level_scene(&s, sticky);
    double t = 0;
    int before = -1, changes = 0;
    for (int i = 0; i < 60; ++i) {
        step_take(&s, v3(0.7, 0, 0), 0.1, &t);
        const int element = s.pairs.stick.record[0].element;
        changes += before >= 0 && element != before;
        before = element;
        if (i == 14) break;
    }
    check_at_least(changes, 2);
    /* all records lean by d_s against nothing but the motion */
    for (int i = 0; i < s.pairs.stick.n; ++i) {
        check_share(v3_norm(s.pairs.stick.record[i].lean), sticky.d_s, 1e-9);
        check_above(s.pairs.stick.record[i].lean.x, 0.99 * sticky.d_s);
    }
    step_take(&s, v3(0, 0, 0.1), 0.1, &t);
    assert_int_equal(s.pairs.stick.n, 0);
    step_take(&s, v3(0, 0, -0.1), 0.1, &t);
    check_equal(s.pairs.stick.n, 3);
    check_below(v3_norm(s.pairs.stick.record[0].lean), 1e-9);
    scene_free(&s);
}

/* Segments join the chain behind its tail: what the contacts know goes on with the new numbers. */
TEST(test_renumbered)
{
    TestScene s;
    level_scene(&s, sticky);
    double t = 0;
    step_take(&s, v3(1e-2, 0, 0), 0.05, &t);
    const StickRecord before = s.pairs.stick.record[1];
    StickStore now;
    stick_carry(&s.pairs.stick, &now, 1);
    assert_int_equal(s.pairs.stick.n, 0);
    const Vec3 kept = stick_kept(&now, before.roller, before.face, before.element + 1);
    check_vec(kept, before.lean, 0);
    check_above(v3_norm(kept), 1e-4);
    check_equal(now.record[1].element, before.element + 1);
    check_equal(now.since, t);
    stick_free(&now);
    scene_free(&s);
}

/* What was freed is as good as new: empty, freed once more, and of another size. */
TEST(test_freed)
{
    StickStore store = {0};
    for (int rollers = 1; rollers < 4; ++rollers) {
        assert_true(stick_reserve(&store, rollers, 5));
        store.fresh[0] = (StickRecord){rollers - 1, 1, 3, 0, {0, 0, 1}};
        stick_accept(&store, 2, 1);
        check_vec(stick_kept(&store, rollers - 1, 1, 4), v3(0, 0, 1), 0);
        check_vec(stick_kept(&store, rollers - 1, 0, 4), V3_ZERO, 0);
        for (int k = 0; k < 2; ++k) {
            stick_free(&store);
            assert_true(!store.record && !store.fresh && !store.first);
            assert_true(store.n == 0 && store.room == 0 && store.n_faces == 0);
            check_equal(store.since, 0);
        }
    }
}

/* The moment at which a step is accepted changes nothing: held, called up in part, and sliding. */
TEST(test_no_jump_at_a_step)
{
    const double speeds[] = {0, 1e-4, 2e-3, 0.03, 0.3};
    for (int k = 0; k < 5; ++k) {
        TestScene s;
        level_scene(&s, sticky);
        double t = 0;
        for (int i = 0; i < 7; ++i) {
            const Vec3 v = v3(speeds[k], 0, 0);
            speed_set(&s, v);
            for (int j = 0; j < N; ++j) vec_store(s.kin.p, j, v3_axpy(vec_load(s.kin.p, j), 0.02, v));
            t += 0.02;
            stick_clock(&s.pairs.stick, t);
            const double before = friction_along(&s);
            contact_accept(&s.model, &s.chain, &s.kin, t, &s.pairs);
            const double after = friction_along(&s);
            check_close(after, before, 1e-14 * s.on_roller[0].z * -1);
        }
        scene_free(&s);
    }
}

/* Dragged to and fro by less and by more than d_s, round and round: from the start on, friction has never given back
 * more than it took. */
TEST(test_work_is_only_taken)
{
    uint64_t seed = 9;
    for (int run = 0; run < 20; ++run) {
        TestScene s;
        FrictionLaw law = sticky;
        if (run % 2) law.mu_d = law.mu_s;
        level_scene(&s, law);
        double t = 0, work = 0, most = 0;
        const double size = 0.02 * pow(10, fixture_random(&seed)), h = 0.01;
        for (int i = 0; i < 400; ++i) {
            const Vec3 v = v3(size * sin(0.05 * i + run), size * cos(0.031 * i) * (run % 3), 0);
            speed_set(&s, v);
            for (int j = 0; j < N; ++j) vec_store(s.kin.p, j, v3_axpy(vec_load(s.kin.p, j), h, v));
            t += h;
            stick_clock(&s.pairs.stick, t);
            scene_forces(&s, 1);
            for (int r = 0; r < 2; ++r) work -= h * v3_dot(s.on_roller[r], v);
            contact_accept(&s.model, &s.chain, &s.kin, t, &s.pairs);
            check_below(work, 1e-9);
            most = smaller_of(most, work);
        }
        check_below(most, 0);
        scene_free(&s);
    }
}

/* Largest difference of two block chains over the largest entry of one. */
static double difference(const BlockChain *a, const BlockChain *b)
{
    double most = 0, size = 0;
    const double *const pa[3] = {a->lower, a->diag, a->upper}, *const pb[3] = {b->lower, b->diag, b->upper};
    for (int i = 0; i < 3 * 36 * N; ++i) {
        const double x = pa[i / (36 * N)][i % (36 * N)], y = pb[i / (36 * N)][i % (36 * N)];
        size = larger_of(size, fabs(y));
        most = larger_of(most, fabs(x - y));
    }
    return size > 0 ? most / size : most;
}

static double largest(const BlockChain *a)
{
    double size = 0;
    const double *const part[3] = {a->lower, a->diag, a->upper};
    for (int i = 0; i < 3 * 36 * N; ++i) size = larger_of(size, fabs(part[i / (36 * N)][i % (36 * N)]));
    return size;
}

/* A crooked, moving chain that has slid a little since the last step. */
static void random_scene(TestScene *s, double speed, int with_v, uint64_t *seed)
{
    scene_new(s, GEOMETRY_SMOOTH, N, 0.5);
    for (int i = 0; i < N; ++i) {
        vec_store(s->kin.a, i, v3_unit(v3_axpy(v3(1, 0, 0), 0.03, fixture_vector(seed, 1))));
        vec_store(s->kin.v, i, v3_scale(speed, fixture_vector(seed, 1)));
        vec_store(s->kin.w, i, v3_scale(2 * speed, fixture_vector(seed, 1)));
    }
    scene_join(s, v3(0, 0, 0));
    const Element element = element_at(GEOMETRY_SMOOTH, N, 3);
    const Vec3 p = element_point(&element, &s->chain, &s->kin, 0.4);
    const double radius = s->chain.radius[0];
    Shape shape = {.kind = with_v ? SHAPE_V_GROOVE : SHAPE_CYLINDER, .axis = {0, 1, 0}, .radius = 0.1};
    shape.half_width = 0.3;
    if (with_v) shape.groove = groove_v(0.8, 0.12);
    shape.centre = v3_axpy(p, -(shape_seat(&shape, radius) - 8e-4), v3(0, 0, 1));
    ContactRoller *const roller = scene_roller(s, shape.centre, shape.axis, 0.1, 0.3);
    *roller = (ContactRoller){.shape = shape, .friction = sticky};
    scene_refresh(s);
    contact_accept(&s->model, &s->chain, &s->kin, 0, &s->pairs);
    for (int i = 0; i < s->pairs.stick.n; ++i) {
        s->pairs.stick.record[i].lean = v3_scale(0.8 * sticky.d_s, fixture_vector(seed, 1));
    }
    stick_clock(&s->pairs.stick, 0.02 + 0.019 * fixture_random(seed));
}

static double blocks_error(TestScene *s, double step)
{
    BlockChain m[4];
    for (int i = 0; i < 4; ++i) {
        assert_true(block_chain_alloc(&m[i], N, 6));
        block_chain_zero(&m[i]);
    }
    contact_blocks(&s->model, &s->chain, &s->kin, 0.9, &s->pairs, &m[0], &m[1], NULL, NULL);
    check_equal(contact_blocks_fd(&s->model, &s->chain, &s->kin, 0.9, &s->pairs, step, 1e-7, &m[2], &m[3]), 0);
    const double error = larger_of(difference(&m[0], &m[2]), difference(&m[1], &m[3]));
    for (int i = 0; i < 4; ++i) block_chain_free(&m[i]);
    return error;
}

TEST(test_derivatives)
{
    uint64_t seed = 21;
    const double speeds[] = {1e-4, 8e-3, 0.05, 1};
    double worst = 0;
    int active = 0;
    for (int i = 0; i < 120; ++i) {
        TestScene s;
        random_scene(&s, speeds[i % 4], i / 4 % 2, &seed);
        scene_forces(&s, 1);
        active += s.pairs.active;
        worst = larger_of(worst, smaller_of(blocks_error(&s, 1e-7), blocks_error(&s, 2e-8)));
        scene_free(&s);
    }
    print_message("%d active, worst %.2e\n", active, worst);
    check_above(active, 120);
    check_below(worst, 1e-7);
}

/* With a bristle that nothing has bent yet, and no time to bend it, the law is ADAMS' to the last bits. */
TEST(test_without_memory_it_is_adams)
{
    uint64_t seed = 2;
    int touching = 0;
    for (int i = 0; i < 40; ++i) {
        TestScene s;
        random_scene(&s, i % 2 ? 1e-3 : 0.05, 0, &seed);
        contact_accept(&s.model, &s.chain, &s.kin, 0, &s.pairs);
        for (int k = 0; k < s.pairs.stick.n; ++k) s.pairs.stick.record[k].lean = v3(0, 0, 0);
        scene_forces(&s, 1);
        const Vec3 sticking = s.on_roller[0];
        s.roller[0].friction.d_s = 0;
        scene_refresh(&s);
        scene_forces(&s, 1);
        touching += s.pairs.active;
        check_vec(sticking, s.on_roller[0], 5e-14 * v3_norm(sticking)); /* 1.3e-14 by clang */
        scene_free(&s);
    }
    check_above(touching, 20);
}

/* Rollers without friction, in the same scene as others: only their normal force is there; the kernels of frictionless
 * rollers do what the others do at a scale of zero. */
TEST(test_frictionless_is_zero_friction)
{
    uint64_t seed = 4;
    int touching = 0;
    for (int i = 0; i < 20; ++i) {
        TestScene s;
        BlockChain m[4];
        random_scene(&s, 0.05, 0, &seed);
        const double c = s.model.impact.c;
        s.model.impact.c = i % 2 ? 0 : c;
        for (int k = 0; k < 4; ++k) {
            assert_true(block_chain_alloc(&m[k], N, 6));
            block_chain_zero(&m[k]);
        }
        s.roller[0].friction = (FrictionLaw){.v_s = 5e-3, .v_d = 2e-2};
        scene_refresh(&s);
        scene_forces(&s, 1);
        const Vec3 without = s.on_roller[0];
        contact_blocks(&s.model, &s.chain, &s.kin, 1, &s.pairs, &m[0], &m[1], NULL, NULL);
        /* the general kernels: a coefficient that is as good as none */
        s.roller[0].friction.mu_s = s.roller[0].friction.mu_d = 1e-300;
        scene_refresh(&s);
        scene_forces(&s, 1);
        contact_blocks(&s.model, &s.chain, &s.kin, 1, &s.pairs, &m[2], &m[3], NULL, NULL);
        touching += s.pairs.active;
        check_vec(without, s.on_roller[0], 1e-13 * v3_norm(without));
        check_below(difference(&m[0], &m[2]), 1e-13);
        if (s.model.impact.c > 0) check_below(difference(&m[1], &m[3]), 1e-13);
        if (s.model.impact.c <= 0) { /* nothing damps: no blocks */
            check_equal(largest(&m[1]), 0);
            check_below(largest(&m[3]), 1e-290);
        }
        for (int k = 0; k < 4; ++k) block_chain_free(&m[k]);
        scene_free(&s);
    }
    check_above(touching, 8);
}
