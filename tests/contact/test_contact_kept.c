/* What contacts leave for a run that goes on: candidates and what sticks, written and read, give the same forces bit
 * for bit; what cannot be is refused before it is used, and what just can be is not. */
#include "tests/support/touch.h"

#include <limits.h>

enum { N = 12, TURNS = 32 };

static const FrictionLaw sticky = {.mu_s = 0.3, .mu_d = 0.2, .v_s = 5e-3, .v_d = 2e-2, .d_s = 1e-3};

/* ----------------------------------------------------------------------------------------- whatever is kept */

/* What is kept, as one call of its checkpoint. */
typedef void Keep(Checkpoint *c, void *of);

static Checkpoint written(Keep *keep, void *of)
{
    Checkpoint c = checkpoint_new(0);
    keep(&c, of);
    c = checkpoint_new(c.size);
    keep(&c, of);
    return c;
}

static void read_back(Keep *keep, void *from, void *to)
{
    Checkpoint c = written(keep, from), back = checkpoint_over(c.bytes, c.size, NULL);
    assert_int_equal(c.status, HAWSER_OK);
    keep(&back, to);
    checkpoint_end(&back);
    if (back.status) fail_msg("%s", back.fault);
    checkpoint_free(&c);
}

/* *at becomes `value`: refused with `words`, in writing as in reading; then it is as before. NULL: nothing is wrong. */
static void tried(Keep *keep, void *of, int *at, int value, const char *words)
{
    const int was = *at;
    *at = value;
    Checkpoint c = written(keep, of);
    if (!words && c.status) fail_msg("%d for %d: %s", value, was, c.fault);
    if (words && !c.status) fail_msg("%d for %d is taken", value, was);
    if (words) check_has(c.fault, words);
    checkpoint_free(&c);
    *at = was;
}

static void same_loads(const Loads *a, const Loads *b, int n)
{
    double most = 0;
    for (int c = 0; c < 3; ++c) {
        assert_memory_equal(a->f[c], b->f[c], (size_t)n * sizeof(double));
        assert_memory_equal(a->m[c], b->m[c], (size_t)n * sizeof(double));
        for (int i = 0; i < n; ++i) most = larger_of(most, fabs(a->f[c][i]));
    }
    check_above(most, 100); /* something presses */
}

/* ------------------------------------------------------------------------------------------------ on rollers */

static void keep_rollers(Checkpoint *c, void *of)
{
    TestScene *const s = of;
    contact_pairs_checkpoint(c, &s->model, &s->pairs);
}

/* A chain that moves over a cylinder and a V; the cylinder sticks, if asked to. */
static void rollers_new(TestScene *s, int sticks)
{
    scene_new(s, GEOMETRY_SMOOTH, N, 0.5);
    const double radius = s->chain.radius[0];
    ContactRoller *const flat = scene_roller(s, v3(1.1, 0, -0.1 - radius + 1e-3), v3(0, 1, 0), 0.1, 0.2);
    if (sticks) flat->friction = sticky;
    ContactRoller *const v = scene_roller(s, v3(4.1, 0, -0.08 - (radius - 1e-3) / sin(0.8)), v3(0, 1, 0), 0.08, 0.25);
    v->shape.kind = SHAPE_V_GROOVE;
    v->shape.groove = groove_v(0.8, 0.1);
    for (int i = 0; i < N; ++i) vec_store(s->kin.v, i, v3(0.003, 1e-3, 0));
    s->model.reach = 0.2;
    scene_refresh(s);
    if (sticks) contact_accept(&s->model, &s->chain, &s->kin, 0.1, &s->pairs);
    contact_widen(&s->pairs);
    stick_clock(&s->pairs.stick, 0.2);
    scene_forces(s, 1);
}

TEST(test_rollers)
{
    for (int sticks = 0; sticks < 2; ++sticks) {
        TestScene s;
        rollers_new(&s, sticks);
        ContactPairs fresh, was = s.pairs;
        Loads before = s.loads;
        assert_true(contact_pairs_alloc(&fresh, N) && chain_struct_alloc(&s.loads, N));
        s.pairs.n_near = s.pairs.n_ranges - 1; /* as in a plane */
        TestScene to = s;
        to.pairs = fresh;
        read_back(keep_rollers, &s, &to);
        fresh = to.pairs;
        s.pairs = fresh;
        s.kin.p[0][3] += 1e-3; /* what moves after the refresh is no matter */
        assert_false(contact_moved_too_far(&s.model, &s.chain, &s.kin, &s.pairs));
        s.kin.p[0][3] -= 1e-3;
        assert_int_equal(fresh.n_near, was.n_ranges - 1);
        assert_int_equal(fresh.n_ranges, was.n_ranges);
        assert_int_equal(fresh.candidates, was.candidates);
        assert_int_equal(fresh.active, was.active);
        check_equal(fresh.tally.friction, was.tally.friction);
        assert_int_equal(fresh.stick.n, was.stick.n);
        check_above(fresh.stick.n, sticks - 1);
        check_equal(fresh.stick.since, sticks ? 0.1 : 0);
        scene_forces(&s, 1);
        same_loads(&s.loads, &before, N);
        for (int k = 0; sticks && k < 3; ++k) { /* and so on, step by step */
            stick_clock(&was.stick, 0.3 + k);
            stick_clock(&s.pairs.stick, 0.3 + k);
            check_equal(s.pairs.stick.elapsed, was.stick.elapsed);
            contact_accept(&s.model, &s.chain, &s.kin, 0.3 + k, &s.pairs);
            contact_accept(&s.model, &s.chain, &s.kin, 0.3 + k, &was);
            for (int i = 0; i < was.stick.n; ++i) {
                check_vec(s.pairs.stick.record[i].lean, was.stick.record[i].lean, 0);
            }
        }
        contact_pairs_free(&was);
        chain_struct_free(&before);
        scene_free(&s);
    }
}

TEST(test_rollers_impossible)
{
    static const char words[] = "candidates for contact are impossible";
    TestScene s;
    rollers_new(&s, 1);
    int last = 0, flanks = 0; /* of the flat roller and of the V's second face */
    for (int i = 0; i < s.pairs.n_ranges; ++i) {
        if (s.pairs.range[i].face == 1) flanks = i;
        if (s.pairs.range[i].roller == 0) last = i;
    }
    ContactRange *const lists[] = {s.pairs.range, s.pairs.near};
    for (int k = 0; k < 2; ++k) {
        ContactRange *const flat = &lists[k][last], *const v = &lists[k][flanks];
        assert_int_equal(flat->roller, 0);
        assert_int_equal(v->roller, 1);
        const int wrong[][2] = {{0, -1}, {0, 2}, {0, INT_MAX}};
        for (size_t w = 0; w < sizeof wrong / sizeof *wrong; ++w) {
            tried(keep_rollers, &s, &flat->roller, wrong[w][1], words);
            tried(keep_rollers, &s, &v->face, wrong[w][1], words);
        }
        tried(keep_rollers, &s, &flat->face, 1, words); /* a cylinder has one */
        tried(keep_rollers, &s, &v->face, 0, NULL);     /* a V two */
        tried(keep_rollers, &s, &flat->kind, v->kind, words);
        tried(keep_rollers, &s, &flat->kind, contact_kind(SHAPE_CYLINDER, FRICTION_SPEED), words);
        tried(keep_rollers, &s, &flat->first, -1, words);
        tried(keep_rollers, &s, &flat->first, 0, NULL);
        tried(keep_rollers, &s, &flat->first, N + 1 - flat->count, NULL); /* elements 0 .. N */
        tried(keep_rollers, &s, &flat->first, N + 2 - flat->count, words);
        tried(keep_rollers, &s, &flat->first, INT_MAX, words);
        tried(keep_rollers, &s, &flat->count, -1, words);
        tried(keep_rollers, &s, &flat->count, INT_MAX, words);
        tried(keep_rollers, &s, &flat->count, flat->count + 1, words); /* more than all candidates */
    }
    tried(keep_rollers, &s, &s.pairs.near[last].count, 0, NULL); /* fewer are near */
    tried(keep_rollers, &s, &s.pairs.candidates, s.pairs.candidates + 1, words);
    tried(keep_rollers, &s, &s.pairs.candidates, s.pairs.candidates - 1, words);
    tried(keep_rollers, &s, &s.pairs.n_ranges, s.pairs.n_ranges - 1, "more candidates are near than there are");
    scene_free(&s);
}

/* What sticks, by itself: two rollers, three records. */
typedef struct Sticks {
    StickStore store;
    int rollers, room;
} Sticks;
static void keep_sticks(Checkpoint *c, void *of)
{
    Sticks *const s = of;
    stick_checkpoint(c, &s->store, s->rollers, s->room);
}

TEST(test_sticks)
{
    static const char words[] = "the state of friction that sticks is impossible";
    Sticks s = {.rollers = 2, .room = 3}, to = {.rollers = 2, .room = 1};
    assert_true(stick_reserve(&s.store, 2, 3));
    for (int k = 0; k < 3; ++k) s.store.fresh[k] = (StickRecord){k / 2, k % 2, 4 + 7 * k, 0, {k, -k, 0.5}};
    stick_accept(&s.store, 1.5, 3);
    stick_clock(&s.store, 1.75);
    read_back(keep_sticks, &s, &to);
    check_equal(to.store.since, 1.5);
    check_equal(to.store.elapsed, 0.25);
    assert_int_equal(to.store.n, 3);
    check_at_least(to.store.room, 3); /* more than was asked for */
    for (int f = 0; f < 4; ++f) assert_int_equal(to.store.first[f], f < 3 ? f : -1);
    for (int k = 0; k < 3; ++k) {
        check_vec(stick_kept(&to.store, k / 2, k % 2, 100), v3(k, -k, 0.5), 0);
        StickRecord *const r = &s.store.record[k];
        tried(keep_sticks, &s, &r->roller, -1, words);
        tried(keep_sticks, &s, &r->roller, 2, words);
        tried(keep_sticks, &s, &r->roller, 1, NULL);
        tried(keep_sticks, &s, &r->face, -1, words);
        tried(keep_sticks, &s, &r->face, 2, words);
        tried(keep_sticks, &s, &r->element, -1, words);
        tried(keep_sticks, &s, &r->element, 0, NULL);
    }
    for (int f = 0; f < 4; ++f) {
        tried(keep_sticks, &s, &s.store.first[f], 3, words);
        tried(keep_sticks, &s, &s.store.first[f], -2, words);
        tried(keep_sticks, &s, &s.store.first[f], -1, NULL);
        tried(keep_sticks, &s, &s.store.first[f], 2, NULL);
    }
    check_vec(stick_kept(&to.store, 1, 1, 0), v3(0, 0, 0), 0); /* nothing touches it */
    tried(keep_sticks, &s, &s.store.n, -1, "a number of contacts is impossible");
    int n = INT_MAX;
    Checkpoint c = checkpoint_new(64);
    checkpoint_put(&c, "n", &n, sizeof n);
    Checkpoint back = checkpoint_over(c.bytes, c.size, NULL);
    keep_sticks(&back, &to);
    check_has(back.fault, "a number of contacts is impossible");
    checkpoint_free(&c);
    stick_free(&s.store);
    stick_free(&to.store);
}

/* A contact takes over from the nearest element of its own face, whichever of several that is. */
TEST(test_nearest_sticks)
{
    static const int element[] = {4, 5, 20, 7, 30};
    StickStore s = {.n = 0};
    assert_true(stick_reserve(&s, 2, 5));
    for (int k = 0; k < 5; ++k) s.fresh[k] = (StickRecord){k / 3, 0, element[k], 0, {element[k], 0, 0}};
    stick_accept(&s, 0, 5);
    for (int e = 0; e < 40; ++e) {
        check_equal(stick_kept(&s, 0, 0, e).x, e < 5 ? 4 + (e > 4) : e < 13 ? 5 : 20);
        if (e != 18) check_equal(stick_kept(&s, 1, 0, e).x, e < 19 ? 7 : 30);
        check_equal(stick_kept(&s, 0, 1, e).x, 0);
    }
    s.fresh[0] = (StickRecord){1, 1, 3, 0, {9, 0, 0}};
    stick_accept(&s, 1, 1); /* the others are forgotten */
    for (int f = 0; f < 4; ++f) check_equal(stick_kept(&s, f / 2, f % 2, 4).x, f == 3 ? 9 : 0);
    stick_accept(&s, 2, 0);
    check_equal(stick_kept(&s, 1, 1, 3).x, 0);
    stick_free(&s);
}

/* ---------------------------------------------------------------------------------------------- cable on cable */

static void keep_self(Checkpoint *c, void *of)
{
    SelfScene *const s = of;
    self_pairs_checkpoint(c, SELF_ALONE(&s->chain, &s->kin), &s->pairs);
}

static void turns_new(SelfScene *s)
{
    uint64_t seed = 4;
    self_new(s, TURNS, 0.25);
    self_helix(s, 0.5, 2 * SELF_RADIUS - 2e-3);
    self_shake(s, 5e-4, 0.01, &seed);
    self_fresh(s);
    self_load(s, 1);
}

TEST(test_self)
{
    const int n = TURNS;
    SelfScene s, to;
    BlockChain k[2], d[2];
    turns_new(&s);
    to = s;
    assert_true(self_pairs_alloc(&to.pairs, 1, &n) && chain_struct_alloc(&to.loads, n));
    for (int b = 0; b < 2; ++b) assert_true(block_chain_alloc(&k[b], n, 6) && block_chain_alloc(&d[b], n, 6));
    read_back(keep_self, &s, &to);
    assert_int_equal(to.pairs.half, s.pairs.half);
    assert_int_equal(to.pairs.candidates, s.pairs.candidates);
    assert_memory_equal(to.pairs.active, s.pairs.active, sizeof s.pairs.active);
    assert_memory_equal(to.pairs.work, s.pairs.work, sizeof s.pairs.work);
    assert_false(self_moved_too_far(&s.model, SELF_ALONE(&s.chain, &s.kin), &to.pairs));
    self_load(&to, 1);
    same_loads(&to.loads, &s.loads, n);
    SelfScene *const each[] = {&s, &to};
    for (int b = 0; b < 2; ++b) {
        block_extras_zero(&each[b]->pairs.extras);
        self_blocks(&s.model, SELF_ALONE(&s.chain, &s.kin), 1, &each[b]->pairs, &k[b], &d[b]);
    }
    assert_memory_equal(k[0].diag, k[1].diag, (size_t)n * 36 * sizeof(double));
    assert_memory_equal(s.pairs.extras.k, to.pairs.extras.k, (size_t)s.pairs.extras.count * 36 * sizeof(double));
    for (int b = 0; b < 2; ++b) {
        block_chain_free(&k[b]);
        block_chain_free(&d[b]);
    }
    self_pairs_free(&to.pairs);
    chain_struct_free(&to.loads);
    self_free(&s);
}

TEST(test_self_impossible)
{
    static const char words[] = "candidates of cable on cable are impossible";
    SelfScene s;
    turns_new(&s);
    check_above(s.pairs.n_ranges, 4);
    for (int i = 0; i < s.pairs.n_ranges; i += s.pairs.n_ranges - 1) {
        SelfRange *const r = &s.pairs.range[i];
        int *const lines[] = {&r->line, &r->other};
        for (int k = 0; k < 2; ++k) {
            tried(keep_self, &s, lines[k], -1, words);
            tried(keep_self, &s, lines[k], 1, words);
        }
        tried(keep_self, &s, &r->element, -1, words);
        tried(keep_self, &s, &r->element, 0, NULL);
        tried(keep_self, &s, &r->element, TURNS, NULL); /* elements 0 .. TURNS */
        tried(keep_self, &s, &r->element, TURNS + 1, words);
        tried(keep_self, &s, &r->first, -1, words);
        tried(keep_self, &s, &r->first, 0, NULL);
        tried(keep_self, &s, &r->first, TURNS + 1 - r->count, NULL);
        tried(keep_self, &s, &r->first, TURNS + 2 - r->count, words);
        tried(keep_self, &s, &r->count, -1, words);
        tried(keep_self, &s, &r->count, INT_MAX, words);
    }
    self_free(&s);
}

/* ------------------------------------------------------------------------------------------------ on surfaces */

static void keep_surface(Checkpoint *c, void *of)
{
    SurfaceScene *const s = of;
    surface_pairs_checkpoint(c, &s->model, &s->pairs, N);
}

/* On two planes, the second of which sticks. */
static void floor_new(SurfaceScene *s)
{
    uint64_t seed = 8;
    const RoutePieceDef straight = {.kind = ROUTE_STRAIGHT, .length = 20};
    surfaces_new(s, N, 0.5);
    surfaces_points(s, GEOMETRY_SMOOTH);
    surfaces_route(s, 1, &straight, 0);
    for (int k = 0; k < 2; ++k) {
        SurfaceShape shape = surfaces_shape(SURFACE_PLANE, 2, 18);
        shape.point = v3(0, 0, -CABLE_RADIUS);
        surfaces_add(s, &shape);
    }
    surfaces_lay(s, 6, 0, -5e-4);
    for (int i = 0; i < N; ++i) vec_store(s->kin.v, i, v3_scale(0.01, fixture_vector(&seed, 1)));
    s->friction[1] = sticky;
    assert_true(surface_pairs_sticks(&s->pairs, &s->model, N));
    surfaces_refresh(s);
    surface_accept(&s->model, &s->chain, &s->kin, 0.5, &s->pairs);
    surface_clock(&s->pairs, 0.75);
    surfaces_forces(s, 1);
}

TEST(test_surfaces)
{
    SurfaceScene s, to;
    floor_new(&s);
    to = s;
    surface_pairs_init(&to.pairs, s.pairs.from, s.pairs.to);
    assert_true(surface_pairs_sticks(&to.pairs, &s.model, N) && chain_struct_alloc(&to.loads, N));
    read_back(keep_surface, &s, &to);
    assert_int_equal(to.pairs.candidates, s.pairs.candidates);
    assert_int_equal(to.pairs.active, s.pairs.active);
    check_above(s.pairs.active, N);
    assert_memory_equal(&to.pairs.work, &s.pairs.work, sizeof s.pairs.work);
    check_equal(to.pairs.stick.since, 0.5);
    check_equal(to.pairs.stick.elapsed, 0.25);
    to.model.patch = to.patch;
    surfaces_forces(&to, 1);
    same_loads(&to.loads, &s.loads, N);
    surface_pairs_free(&to.pairs);
    chain_struct_free(&to.loads);
    surfaces_free(&s);
}

TEST(test_surfaces_impossible)
{
    static const char words[] = "candidates for contact with surfaces are impossible";
    SurfaceScene s;
    floor_new(&s);
    for (int from = 0; from < 2; ++from) { /* a half may begin later */
        s.pairs.from = from;
        for (int i = 0; i < s.pairs.n_ranges; ++i) s.pairs.range[i].first = from;
        for (int i = 0; i < s.pairs.n_ranges; ++i) s.pairs.range[i].count = N - 2;
        for (int i = 0; i < s.pairs.n_ranges; ++i) {
            SurfaceRange *const r = &s.pairs.range[i];
            tried(keep_surface, &s, &r->patch, -1, words);
            tried(keep_surface, &s, &r->patch, s.model.n_patches, words);
            tried(keep_surface, &s, &r->patch, 0, NULL);
            tried(keep_surface, &s, &r->patch, s.model.n_patches - 1, NULL);
            tried(keep_surface, &s, &r->first, from - 1, words);
            tried(keep_surface, &s, &r->first, N + 1 - r->count, NULL);
            tried(keep_surface, &s, &r->first, N + 2 - r->count, words);
            tried(keep_surface, &s, &r->count, 0, NULL);
            tried(keep_surface, &s, &r->count, -1, words);
            tried(keep_surface, &s, &r->count, INT_MAX, words);
        }
    }
    surfaces_free(&s);
}
