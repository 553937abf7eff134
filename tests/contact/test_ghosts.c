/* What stands before the first and behind the last segment is nobody's: whatever is there, NaN too, forces, derivatives
 * and candidates have the same bits. And the first and the last segment count like all others. */
#include "tests/support/touch.h"

#include "tests/support/contact_fd.h"

enum { N = 9 };

/* One number, or NaN, where there is no segment. */
static void spoil_with(Chain *chain, Kinematics *kin, double with)
{
    for (int i = -1; i <= chain->n; i += chain->n + 1) {
        const Vec3 none = v3(with, with, with);
        vec_store(kin->p, i, none);
        vec_store(kin->a, i, none);
        vec_store(kin->v, i, none);
        vec_store(kin->w, i, none);
        chain->half[i] = chain->radius[i] = with;
    }
}

static void spoil(Chain *chain, Kinematics *kin) { spoil_with(chain, kin, NAN); }

/* Forces and blocks of one call. */
typedef struct Taken {
    double f[6][N];
    BlockChain k, d;
    int candidates;
} Taken;

static Taken taken_new(void)
{
    Taken t = {.candidates = 0};
    assert_true(block_chain_alloc(&t.k, N, 6) && block_chain_alloc(&t.d, N, 6));
    return t;
}

static void taken_loads(Taken *t, const Loads *loads)
{
    for (int c = 0; c < 3; ++c) {
        memcpy(t->f[c], loads->f[c], sizeof t->f[c]);
        memcpy(t->f[3 + c], loads->m[c], sizeof t->f[c]);
    }
}

static void same(Taken *a, Taken *b)
{
    double most = 0;
    assert_memory_equal(a->f, b->f, sizeof a->f);
    for (int i = 0; i < N; ++i) most = larger_of(most, fabs(a->f[2][i]));
    check_above(most, 1);
    assert_int_equal(a->candidates, b->candidates);
    const size_t size = (size_t)N * 36 * sizeof(double);
    const BlockChain *const pair[2][2] = {{&a->k, &b->k}, {&a->d, &b->d}};
    for (int m = 0; m < 2; ++m) {
        assert_memory_equal(pair[m][0]->diag, pair[m][1]->diag, size);
        assert_memory_equal(pair[m][0]->lower, pair[m][1]->lower, size);
        assert_memory_equal(pair[m][0]->upper, pair[m][1]->upper, size);
        block_chain_free(m ? &a->d : &a->k);
        block_chain_free(m ? &b->d : &b->k);
    }
}

/* A chain whose ends lie on rollers, and its middle. */
static void rollers_new(TestScene *s, ContactGeometry geometry)
{
    uint64_t seed = 3;
    scene_new(s, geometry, N, 0.5);
    const double at[] = {0.06, 2.1, N * 0.5 - 0.07};
    for (int k = 0; k < 3; ++k) {
        scene_roller(s, v3(at[k], 0, -0.1 - 0.04365 + 1e-3), v3(0, 1, 0), 0.1, 0.3);
    }
    for (int i = 0; i < N; ++i) {
        vec_store(s->kin.v, i, v3_scale(0.01, fixture_vector(&seed, 1)));
        vec_store(s->kin.w, i, v3_scale(0.01, fixture_vector(&seed, 1)));
    }
    s->model.reach = 0.05;
}

static Taken rollers_taken(TestScene *s)
{
    Taken t = taken_new();
    scene_refresh(s);
    scene_forces(s, 1);
    taken_loads(&t, &s->loads);
    t.candidates = s->pairs.candidates;
    contact_blocks(&s->model, &s->chain, &s->kin, 1, &s->pairs, &t.k, &t.d, NULL, NULL);
    return t;
}

TEST(test_rollers)
{
    for (int geometry = 0; geometry < 2; ++geometry) {
        TestScene s;
        rollers_new(&s, geometry ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH);
        Taken before = rollers_taken(&s);
        assert_int_equal(s.pairs.active, 3);
        spoil(&s.chain, &s.kin);
        Taken after = rollers_taken(&s);
        same(&before, &after);
        scene_free(&s);
    }
}

/* Candidates are renewed for whichever segment has moved or turned. */
TEST(test_every_segment_moves)
{
    TestScene s;
    rollers_new(&s, GEOMETRY_SMOOTH);
    scene_refresh(&s);
    spoil(&s.chain, &s.kin);
    assert_false(contact_moved_too_far(&s.model, &s.chain, &s.kin, &s.pairs));
    for (int i = 0; i < N; ++i) {
        for (int c = 0; c < 3; ++c) {
            const double was[] = {s.kin.p[c][i], s.kin.a[c][i]};
            s.kin.p[c][i] += 1.01 * CONTACT_USABLE * s.model.reach;
            assert_true(contact_moved_too_far(&s.model, &s.chain, &s.kin, &s.pairs));
            s.kin.p[c][i] = was[0];
            s.kin.a[c][i] += 1.01 * CONTACT_USABLE * s.model.reach / s.chain.half[i];
            assert_true(contact_moved_too_far(&s.model, &s.chain, &s.kin, &s.pairs));
            s.kin.a[c][i] = was[1];
        }
    }
    /* aslant: within the limit, though the components' sum is not */
    for (int c = 0; c < 3; ++c) s.kin.p[c][N - 1] += 0.57 * CONTACT_USABLE * s.model.reach;
    assert_false(contact_moved_too_far(&s.model, &s.chain, &s.kin, &s.pairs));
    scene_free(&s);
}

/* Derivatives by speeds where friction alone has any: no damping, fixed rollers; and where nothing has. */
TEST(test_undamped)
{
    for (int rubs = 0; rubs < 2; ++rubs) {
        TestScene s;
        BlockChain m[4];
        double most = 0, apart = 0;
        rollers_new(&s, GEOMETRY_SMOOTH);
        s.model.impact.c = 0;
        scene_refresh(&s);
        for (int k = 0; k < 4; ++k) assert_true(block_chain_alloc(&m[k], N, 6));
        contact_blocks(&s.model, &s.chain, &s.kin, rubs, &s.pairs, &m[0], &m[1], NULL, NULL);
        check_equal(contact_blocks_fd(&s.model, &s.chain, &s.kin, rubs, &s.pairs, 1e-7, 1e-6, &m[2], &m[3]), 0);
        for (int i = 0; i < 36 * N; ++i) {
            most = larger_of(most, fabs(m[3].diag[i]));
            apart = larger_of(apart, fabs(m[1].diag[i] - m[3].diag[i]));
        }
        if (rubs) check_above(most, 100);
        check_at_most(apart, 1e-6 * most);
        for (int k = 0; k < 4; ++k) block_chain_free(&m[k]);
        scene_free(&s);
    }
}

/* Both halves of a hairpin on each other, ends included. */
static void self_hairpin(SelfScene *s)
{
    uint64_t seed = 5;
    self_new(s, N, 0.3);
    self_strand(s, 0, 4, v3(0, 0, 0), v3(1, 0, 0));
    self_place(s, 4, v3(1.2, 0, 0), v3(1.2, 0, 0.3));
    self_strand(s, 5, 4, v3(1.2, 0, 2 * SELF_RADIUS - 2e-3), v3(-1, 0, 0));
    self_shake(s, 1e-4, 0.01, &seed);
}

static Taken self_taken(SelfScene *s)
{
    Taken t = taken_new();
    self_fresh(s);
    self_load(s, 1);
    taken_loads(&t, &s->loads);
    t.candidates = s->pairs.candidates;
    block_extras_zero(&s->pairs.extras);
    self_blocks(&s->model, SELF_ALONE(&s->chain, &s->kin), 1, &s->pairs, &t.k, &t.d);
    return t;
}

TEST(test_self)
{
    static const double with[] = {NAN, 1e3, -1e3};
    for (int k = 0; k < 3; ++k) {
        SelfScene s;
        self_hairpin(&s);
        const int skip = self_skip(&s.chain);
        Taken before = self_taken(&s);
        check_above(s.pairs.active[0] + s.pairs.active[1], 2);
        int pieces[N + 1];
        for (int e = 0; e <= N; ++e) pieces[e] = self_pieces(&s.chain, e);
        spoil_with(&s.chain, &s.kin, with[k]);
        assert_int_equal(self_skip(&s.chain), skip);
        for (int e = 0; e <= N; ++e) {
            assert_int_equal(self_pieces(&s.chain, e), pieces[e]);
            check_finite(self_piece_length(&s.chain, e));
        }
        Taken after = self_taken(&s);
        same(&before, &after);
        self_free(&s);
    }
}

/* On a plane, all along; in one piece and in two halves. */
static void floor_new(SurfaceScene *s, ContactGeometry geometry)
{
    uint64_t seed = 8;
    surfaces_new(s, N, 0.5);
    surfaces_points(s, geometry);
    SurfaceShape shape = surfaces_shape(SURFACE_PLANE, 0, 0);
    shape.point = v3(0, 0, -CABLE_RADIUS);
    shape.length = shape.width = 0;
    surfaces_add(s, &shape);
    for (int i = 0; i < N; ++i) {
        s->kin.p[2][i] -= 1e-4;
        vec_store(s->kin.v, i, v3_scale(0.01, fixture_vector(&seed, 1)));
    }
}

static Taken surface_taken(SurfaceScene *s)
{
    Taken t = taken_new();
    surfaces_refresh(s);
    surfaces_forces(s, 1);
    taken_loads(&t, &s->loads);
    t.candidates = s->pairs.candidates;
    surface_blocks(&s->model, &s->chain, &s->kin, 1, &s->pairs, 0, s->points.elements, &t.k, &t.d);
    return t;
}

TEST(test_surfaces)
{
    for (int geometry = 0; geometry < 2; ++geometry) {
        SurfaceScene s;
        floor_new(&s, geometry ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH);
        Taken before = surface_taken(&s);
        assert_int_equal(s.pairs.active, 2 * s.points.elements);
        spoil(&s.chain, &s.kin);
        Taken after = surface_taken(&s);
        same(&before, &after);
        surfaces_free(&s);
    }
}
