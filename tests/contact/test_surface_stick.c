/* Friction that sticks on trays and planes: derivatives, what the points remember, no jump at a step's end, and that
 * only surfaces that stick remember anything. */
#include "tests/support/touch.h"

#include <math.h>

#include "tests/support/contact_fd.h"

enum { N = 6 };

static const FrictionLaw sticky = {.mu_s = 0.3, .mu_d = 0.2, .v_s = 5e-3, .v_d = 2e-2, .d_s = 1e-3};

/* Some surface sticks if one does, whichever it is, and that one alone remembers. */
TEST(test_which_stick)
{
    for (int which = 0; which < 8; ++which) {
        SurfaceScene s;
        surfaces_new(&s, N, 0.5);
        for (int k = 0; k < 3; ++k) {
            const SurfaceShape plane = surfaces_shape(SURFACE_PLANE, 0, 0);
            surfaces_add(&s, &plane);
            if (which >> k & 1) s.friction[k] = sticky;
        }
        assert_int_equal(surface_sticks(&s.model), which != 0);
        assert_true(surface_pairs_sticks(&s.pairs, &s.model, N));
        assert_int_equal(s.pairs.stick.n_beds, 3 * SURFACE_FACES_MAX);
        for (int b = 0; b < 3 * SURFACE_FACES_MAX; ++b)
            assert_int_equal(s.pairs.stick.bed[b].lean[0][0] != NULL, which >> b / SURFACE_FACES_MAX & 1);
        for (int k = 0; k < 2; ++k) { /* twice does no harm */
            surface_stick_free(&s.pairs.stick);
            assert_true(s.pairs.stick.n_beds == 0 && !s.pairs.stick.bed);
        }
        surfaces_free(&s);
    }
}

/* A crooked chain that moves, a little inside a surface of this kind. */
static void scene_make(SurfaceScene *s, SurfaceKind kind, double speed, uint64_t *seed)
{
    const RoutePieceDef straight = {.kind = ROUTE_STRAIGHT, .length = 20};
    surfaces_new(s, N, 0.5);
    surfaces_points(s, GEOMETRY_SMOOTH);
    surfaces_route(s, 1, &straight, 0);
    SurfaceShape shape = surfaces_shape(kind, 2, 18);
    if (kind == SURFACE_PLANE) shape.point = v3(0, 0, -CABLE_RADIUS);
    surfaces_add(s, &shape);
    surfaces_lay(s, 6, 0, -5e-4);
    for (int i = 0; i < N; ++i) {
        vec_store(s->kin.p, i, v3_axpy(vec_load(s->kin.p, i), 2e-4, fixture_vector(seed, 1)));
        vec_store(s->kin.a, i, v3_unit(v3_axpy(vec_load(s->kin.a, i), 5e-4, fixture_vector(seed, 1))));
        vec_store(s->kin.v, i, v3_scale(speed, fixture_vector(seed, 1)));
        vec_store(s->kin.w, i, v3_scale(2 * speed, fixture_vector(seed, 1)));
    }
    s->friction[0] = sticky;
    assert_true(surface_sticks(&s->model));
    assert_true(surface_pairs_sticks(&s->pairs, &s->model, N));
    surfaces_refresh(s);
}

static double largest(const BlockChain *a, const BlockChain *b)
{
    double most = 0;
    const double *const pa[3] = {a->lower, a->diag, a->upper};
    const double *const pb[3] = {b ? b->lower : NULL, b ? b->diag : NULL, b ? b->upper : NULL};
    for (int i = 0; i < 3 * 36 * N; ++i) {
        const int part = i / (36 * N), at = i % (36 * N);
        most = larger_of(most, fabs(pa[part][at] - (b ? pb[part][at] : 0)));
    }
    return most;
}

static double blocks_error(SurfaceScene *s, double step)
{
    BlockChain m[4];
    for (int i = 0; i < 4; ++i) {
        assert_true(block_chain_alloc(&m[i], N, 6));
        block_chain_zero(&m[i]);
    }
    surface_blocks(&s->model, &s->chain, &s->kin, 0.9, &s->pairs, 0, s->points.elements, &m[0], &m[1]);
    check_equal(surface_blocks_fd(&s->model, &s->chain, &s->kin, 0.9, &s->pairs, step, 1e-7, &m[2], &m[3]), 0);
    double error = 0;
    for (int i = 0; i < 2; ++i) error = larger_of(error, largest(&m[i], &m[i + 2]) / largest(&m[i + 2], NULL));
    for (int i = 0; i < 4; ++i) block_chain_free(&m[i]);
    return error;
}

TEST(test_derivatives)
{
    const SurfaceKind kinds[] = {SURFACE_PLANE, SURFACE_V, SURFACE_U, SURFACE_FLAT};
    const double speeds[] = {1e-4, 8e-3, 0.05};
    uint64_t seed = 3;
    double worst = 0;
    for (int i = 0; i < 24; ++i) {
        SurfaceScene s;
        scene_make(&s, kinds[i % 4], speeds[i % 3], &seed);
        surface_accept(&s.model, &s.chain, &s.kin, 0, &s.pairs);
        for (int f = 0; f < SURFACE_FACES_MAX; ++f) {
            for (int e = 0; e <= N; ++e) {
                for (int q = 0; q < SURFACE_POINTS; ++q) {
                    vec_store(s.pairs.stick.bed[f].lean[q], e, v3_scale(0.8 * sticky.d_s, fixture_vector(&seed, 1)));
                }
            }
        }
        surface_clock(&s.pairs, 0.02);
        surfaces_forces(&s, 1);
        check_above(s.pairs.active, 0);
        worst = larger_of(worst, smaller_of(blocks_error(&s, 1e-7), blocks_error(&s, 2e-8)));
        surfaces_free(&s);
    }
    print_message("worst %.2e\n", worst);
    check_below(worst, 1e-8);
}

/* Slid to and fro as a whole: nothing changes when a step is accepted, work is only taken, and after 1 mm and more the
 * friction is the full one. */
TEST(test_steps)
{
    uint64_t seed = 8;
    SurfaceScene s;
    scene_make(&s, SURFACE_V, 0, &seed);
    double t = 0, work = 0;
    for (int i = 0; i < 200; ++i) {
        const Vec3 v = v3(i < 60 ? 2e-4 * i : 0.05 * sin(0.1 * i), 0, 0);
        const double h = 0.01;
        for (int k = 0; k < N; ++k) {
            vec_store(s.kin.v, k, v);
            vec_store(s.kin.w, k, v3(0, 0, 0));
            vec_store(s.kin.p, k, v3_axpy(vec_load(s.kin.p, k), h, v));
        }
        t += h;
        surface_clock(&s.pairs, t);
        surfaces_forces(&s, 1);
        const double before = s.tally[0].force.x, normal = s.tally[0].normal;
        work -= h * before * v.x;
        surface_accept(&s.model, &s.chain, &s.kin, t, &s.pairs);
        surfaces_forces(&s, 1);
        check_close(s.tally[0].force.x, before, 1e-14 * normal);
        check_below(work, 1e-9);
        if (i == 59) check_between(before, sticky.mu_d * normal, 1.0001 * sticky.mu_s * normal);
    }
    surfaces_free(&s);
}

/* At rest it grips by what it has leaned, however long. */
TEST(test_holds)
{
    uint64_t seed = 8;
    SurfaceScene s;
    scene_make(&s, SURFACE_PLANE, 0, &seed);
    for (int k = 0; k < N; ++k) vec_store(s.kin.v, k, v3(1e-2, 0, 0));
    surface_accept(&s.model, &s.chain, &s.kin, 0.02, &s.pairs); /* 0.2 mm */
    for (int k = 0; k < N; ++k) vec_store(s.kin.v, k, v3(0, 0, 0));
    for (int i = 1; i < 4; ++i) {
        surface_clock(&s.pairs, 3600 * i);
        surfaces_forces(&s, 1);
        const double x = 0.2, called = (3 * x - x * x * x) / 2;
        check_share(s.tally[0].force.x, sticky.mu_s * called * s.tally[0].normal, 1e-12);
        surface_accept(&s.model, &s.chain, &s.kin, 3600 * i, &s.pairs);
    }
    surfaces_free(&s);
}

/* A chain of one more segment, cut into two halves, takes over what the shorter one knew. */
TEST(test_renumbered)
{
    uint64_t seed = 8;
    SurfaceScene s;
    SurfacePairs half[2];
    scene_make(&s, SURFACE_PLANE, 0.01, &seed);
    surface_accept(&s.model, &s.chain, &s.kin, 0.02, &s.pairs);
    surface_pairs_init(&half[0], 0, 3);
    surface_pairs_init(&half[1], 3, N + 2);
    for (int p = 0; p < 2; ++p) {
        assert_true(surface_pairs_sticks(&half[p], &s.model, N + 1));
        surface_carry(&s.pairs, &half[p], 1);
        check_equal(half[p].stick.since, 0.02);
    }
    for (int e = 0; e <= N + 1; ++e) {
        const double found = half[e < 3 ? 0 : 1].stick.bed[0].lean[1][0][e];
        const double expected = e > 0 ? s.pairs.stick.bed[0].lean[1][0][e - 1] : 0;
        check_equal(found, expected);
        check_equal(half[e < 3 ? 1 : 0].stick.bed[0].lean[1][0][e], 0);
    }
    /* and back into one of a segment less, from both */
    SurfacePairs whole;
    surface_pairs_init(&whole, 0, N + 1);
    assert_true(surface_pairs_sticks(&whole, &s.model, N));
    for (int p = 0; p < 2; ++p) surface_carry(&half[p], &whole, -1);
    for (int q = 0; q < SURFACE_POINTS; ++q) {
        for (int c = 0; c < 3; ++c) {
            assert_memory_equal(whole.stick.bed[0].lean[q][c], s.pairs.stick.bed[0].lean[q][c],
                                (N + 1) * sizeof(double));
        }
    }
    surface_pairs_free(&whole);
    surface_pairs_init(&whole, 0, N + 4); /* three more joined before all */
    assert_true(surface_pairs_sticks(&whole, &s.model, N + 3));
    surface_carry(&s.pairs, &whole, 3);
    for (int e = 0; e < N + 4; ++e) {
        check_equal(whole.stick.bed[0].lean[0][1][e], e < 3 ? 0 : s.pairs.stick.bed[0].lean[0][1][e - 3]);
    }
    surface_pairs_free(&whole);
    surface_pairs_init(&whole, 0, N + 1); /* one more, one less at the end: nothing is behind it */
    assert_true(surface_pairs_sticks(&whole, &s.model, N));
    surface_carry(&s.pairs, &whole, 1);
    check_equal(whole.stick.bed[0].lean[0][1][N], s.pairs.stick.bed[0].lean[0][1][N - 1]);
    check_equal(whole.stick.bed[0].lean[0][1][N + 1], 0);
    surface_pairs_free(&whole);
    surface_pairs_free(&half[0]);
    surface_pairs_free(&half[1]);
    surfaces_free(&s);
}

/* What a checkpoint keeps of the points that stick: of every face. */
TEST(test_kept)
{
    uint64_t seed = 8;
    SurfaceScene s;
    SurfacePairs read;
    scene_make(&s, SURFACE_V, 0.01, &seed);
    surface_accept(&s.model, &s.chain, &s.kin, 0.02, &s.pairs);
    for (int b = 0; b < s.pairs.stick.n_beds; ++b) {
        for (int q = 0; q < SURFACE_POINTS; ++q) {
            for (int e = 0; e <= N; ++e) vec_store(s.pairs.stick.bed[b].lean[q], e, fixture_vector(&seed, 1));
        }
    }
    Checkpoint c = checkpoint_new(0);
    surface_pairs_checkpoint(&c, &s.model, &s.pairs, N);
    c = checkpoint_new(c.size);
    surface_pairs_checkpoint(&c, &s.model, &s.pairs, N);
    surface_pairs_init(&read, 0, N + 1);
    assert_true(surface_pairs_sticks(&read, &s.model, N));
    Checkpoint back = checkpoint_over(c.bytes, c.size, NULL);
    surface_pairs_checkpoint(&back, &s.model, &read, N);
    assert_int_equal(back.status, HAWSER_OK);
    check_equal(read.stick.since, s.pairs.stick.since);
    for (int b = 0; b < s.pairs.stick.n_beds; ++b) {
        for (int q = 0; q < SURFACE_POINTS; ++q) {
            for (int k = 0; k < 3; ++k) {
                assert_memory_equal(read.stick.bed[b].lean[q][k], s.pairs.stick.bed[b].lean[q][k], N * sizeof(double));
            }
        }
    }
    checkpoint_free(&c);
    surface_pairs_free(&read);
    surfaces_free(&s);
}

/* (GR12): what is remembered lies in the surface and is no longer than d_s: a lean out of the plane is laid into it. */
TEST(test_lean_is_laid_flat)
{
    uint64_t seed = 8;
    SurfaceScene s;
    scene_make(&s, SURFACE_PLANE, 0, &seed);
    surface_accept(&s.model, &s.chain, &s.kin, 1, &s.pairs);
    for (int k = 0; k < 2; ++k) {
        Vec3 was[SURFACE_POINTS][N + 1];
        for (int q = 0; q < SURFACE_POINTS; ++q) {
            for (int e = 0; e <= N; ++e) {
                was[q][e] = v3_scale((k ? 3 : 0.5) * sticky.d_s, fixture_vector(&seed, 1));
                vec_store(s.pairs.stick.bed[0].lean[q], e, was[q][e]);
            }
        }
        for (int i = 0; i < N; ++i) vec_store(s.kin.v, i, v3(0, 2e-3, 0));
        for (int i = 0; i < N; ++i) vec_store(s.kin.w, i, v3(0, 0, 0));
        surface_accept(&s.model, &s.chain, &s.kin, 1.1 + 0.1 * k, &s.pairs);
        int longer = 0;
        for (int q = 0; q < SURFACE_POINTS; ++q) {
            for (int e = 0; e <= N; ++e) {
                const Vec3 now = v3(was[q][e].x, was[q][e].y + 2e-4, 0);
                const double length = v3_norm(now), most = sticky.d_s;
                longer += length > most;
                check_vec(vec_load(s.pairs.stick.bed[0].lean[q], e), v3_scale(fmin(1, most / length), now), 1e-12);
            }
        }
        if (k) check_above(longer, 3);
    }
    surfaces_free(&s);
}
