/* The whole scene's derivative blocks against finite differences of its forces, and the rates as a pure function. */
#include "sim/dynamics.h"
#include "sim/equipment/ends.h"
#include "tests/support/scene.h"

enum { N = FIXTURE_SEGMENTS };

typedef struct Rig {
    Scene scene;
    Workspace ws;
    double y[STATE_SIZE * N], rate[STATE_SIZE * N];
    uint64_t seed;
} Rig;

/* The soft scene, bent, stretched and twisted, moving at up to `speed` (m/s), `ahead` m further along the route. */
static Rig *rig_ahead(ContactGeometry geometry, BushingFrame frame, double speed, uint64_t seed, double ahead)
{
    Rig *const r = fixture_array(1, sizeof *r);
    SceneDef def;
    fixture_pull(&def,
                 &(FixtureChoice){.geometry = geometry, .frame = frame, .soft = 1, .heading = 0.4, .ahead = ahead});
    fixture_build(&def, &r->scene);
    r->seed = seed;
    assert_true(workspace_alloc(&r->ws, &r->scene, NULL));
    scene_initial_state(&r->scene, r->y);
    state_shake(r->y, N, 3e-3, 0.02, speed, speed, &r->seed);
    assert_int_equal(dynamics_refresh(&r->scene, &r->ws, 0.7, r->y, 1, NULL), HAWSER_OK);
    dynamics_rates(&r->scene, &r->ws, 0.7, r->y, 1, r->rate);
    return r;
}

static Rig *rig_new(ContactGeometry geometry, BushingFrame frame, double speed, uint64_t seed)
{
    return rig_ahead(geometry, frame, speed, seed, 0);
}

static void rig_free(Rig *r)
{
    workspace_free(&r->ws);
    scene_clear(&r->scene);
    free(r);
}

/* The balance that the blocks differentiate, M (u' - u'0), by segment: force, moment. */
static void balance(Rig *r, const double *y, double out[6 * N])
{
    double rate[STATE_SIZE * N];
    dynamics_rates(&r->scene, &r->ws, 0.7, y, 1, rate);
    for (int i = 0; i < N; ++i) {
        const Vec3 a = v3_sub(state_vec(rate, N, STATE_V, i), state_vec(r->rate, N, STATE_V, i));
        const Vec3 spin = v3_sub(state_vec(rate, N, STATE_W, i), state_vec(r->rate, N, STATE_W, i));
        const Vec3 f = v3_scale(r->scene.chain.mass[i], a);
        const Vec3 m = body_inertia_times(&r->scene.chain, &r->ws.kin, i, spin);
        const double both[6] = {f.x, f.y, f.z, m.x, m.y, m.z};
        memcpy(out + 6 * i, both, sizeof both);
    }
}

/* Entry of block row i, block column k; 0 where there is no block. */
static double entry(const BlockChain *a, int i, int k, int row, int col)
{
    const double *const block = k == i ? a->diag : k == i + 1 ? a->upper : k == i - 1 ? a->lower : NULL;
    return block ? block[36 * i + 6 * col + row] : 0;
}

/* Largest error and largest entry of one kind: force or moment, by shift, turn, velocity or spin. */
typedef struct Kind {
    double error, size;
} Kind;

static void column_compare(Rig *r, const BlockChain *a, int k, int c, Kind kind[2][4])
{
    const double e = 5e-7; /* m, rad, m/s, rad/s */
    double plus[6 * N], minus[6 * N], y[STATE_SIZE * N];
    memcpy(y, r->y, sizeof y);
    state_nudge(y, N, k, c, e);
    balance(r, y, plus);
    memcpy(y, r->y, sizeof y);
    state_nudge(y, N, k, c, -e);
    balance(r, y, minus);
    for (int row = 0; row < 6 * N; ++row) {
        const double fd = (plus[row] - minus[row]) / (2 * e);
        Kind *const at = &kind[row % 6 / 3][c / 3];
        at->error = larger_of(at->error, fabs(fd - entry(a, row / 6, k, row % 6, c % 6)));
        at->size = larger_of(at->size, fabs(fd));
    }
}

/* Every column of both matrices; entries outside the three diagonals must be zero. */
static double blocks_error(Rig *r)
{
    Kind kind[2][4] = {{{0}}};
    BlockChain k, d;
    assert_true(block_chain_alloc(&k, N, 6) && block_chain_alloc(&d, N, 6));
    dynamics_blocks(&r->scene, &r->ws, 0.7, r->y, r->rate, 1, &k, &d);
    for (int i = 0; i < N; ++i) {
        for (int c = 0; c < 12; ++c) column_compare(r, c < 6 ? &k : &d, i, c, kind);
    }
    block_chain_free(&k);
    block_chain_free(&d);
    double worst = 0;
    for (int m = 0; m < 8; ++m) worst = larger_of(worst, kind[m / 4][m % 4].error / kind[m / 4][m % 4].size);
    return worst;
}

/* How many contacts push, and how many of these slide at full speed or stick. */
static void contacts_count(Rig *r, int *sliding, int *sticking)
{
    enum { ROOM = 128 };
    ContactDetail hit[ROOM];
    dynamics_kinematics(&r->scene, &r->ws, 0.7, r->y);
    for (int part = 0; part < PARTS; ++part) {
        ContactPart *const p = &r->ws.contact[part];
        const int hits = contact_details(&p->model, &r->scene.chain, &r->ws.kin, 1, &p->pairs, ROOM, hit);
        check_at_most(hits, ROOM);
        for (int i = 0; i < hits; ++i) {
            if (!(hit[i].normal > 0)) continue;
            const double square = v3_dot(hit[i].force, hit[i].force) / (hit[i].normal * hit[i].normal) - 1;
            const int full = fabs(sqrt(fmax(square, 0)) - r->scene.def.friction.mu_d) < 1e-9;
            *(full ? sliding : sticking) += 1;
        }
    }
}

/* Both geometries, both frames, from creeping to sliding; the lead-in, its blend and the drag are part of it. */
static void check_blocks(BushingFrame frame)
{
    int sliding = 0, sticking = 0;
    double worst = 0;
    for (int geometry = 0; geometry < 2; ++geometry) {
        const double speed[] = {5e-4, 8e-3, 0.2};
        for (int k = 0; k < 3; ++k) {
            Rig *const r = rig_new(geometry ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH, frame, speed[k], 11 + (uint64_t)k);
            contacts_count(r, &sliding, &sticking);
            worst = larger_of(worst, blocks_error(r));
            rig_free(r);
        }
    }
    print_message("worst relative error %.2g; %d sliding and %d sticking contacts\n", worst, sliding, sticking);
    check_at_least(sliding, 10);
    check_at_least(sticking, 10);
    check_below(worst, 3e-7);
}

TEST(test_blocks_symmetric) { check_blocks(FRAME_SYMMETRIC); }

TEST(test_blocks_adams) { check_blocks(FRAME_ADAMS); }

/* The tail in a bend: its tension follows the route (F2), and so do the blocks. */
TEST(test_tail_in_a_bend)
{
    const double ahead[] = {7.5, 9.2}; /* m: the tail in the bend downward, in the one to the left */
    for (int i = 0; i < 2; ++i) {
        Rig *const r = rig_ahead(GEOMETRY_SMOOTH, FRAME_SYMMETRIC, 0.1, 21, ahead[i]);
        const Vec3 arm = v3_scale(-r->scene.chain.half[0], v3_load(r->ws.kin.a, 0));
        const Vec3 end = v3_add(v3_load(r->ws.kin.p, 0), arm);
        const TailPull pull = tail_pull(&r->scene, 0.7, end, r->ws.tail_at);
        check_close(r->ws.tail_at, r->scene.joint_s[0], 0.02);
        check_close(v3_norm(pull.force), profile_value(&r->scene.tail, 0.7), 1e-9);
        check_above(v3_norm(v3_cross(pull.along, r->scene.weight.direction)), 0.05);
        check_close(v3_norm(v3_sub(route_at(&r->scene.route, r->ws.tail_at).tangent, pull.along)), 0, 1e-9);
        check_above(v3_norm(pull.turned), 20); /* N/m: 500 N over 20 m and 10 m */
        check_below(blocks_error(r), 3e-7);
        rig_free(r);
    }
}

/* Where nothing is known but how far the winch has hauled, and where it is known where the tail was: on the leg of the
 * route that it lies on, though the other one is as near. */
TEST(test_tail_place)
{
    Rig *const r = rig_new(GEOMETRY_SMOOTH, FRAME_SYMMETRIC, 0.1, 22);
    for (double s = -2; s < 14; s += 0.7) {
        const Vec3 end = v3_add(route_at(&r->scene.route, s).position, v3(0, 0, 0.03));
        check_close(tail_place(&r->scene, 0.7, end, s - 0.2, 0), s, 0.01);
        check_close(tail_place(&r->scene, 0.7, end, s + 0.4, 1), s, 0.01);
    }
    rig_free(r);
}

/* The lead-in at work: segments in the middle of the blend and pushed off its line feel all of (F1). */
TEST(test_lead_in)
{
    Rig *const r = rig_new(GEOMETRY_SMOOTH, FRAME_SYMMETRIC, 0.1, 5);
    const Weight *const w = &r->scene.weight;
    int inside = 0, behind = 0, ahead = 0;
    for (int i = 0; i < N; ++i) {
        const double x = v3_dot(v3_sub(state_vec(r->y, N, STATE_P, i), w->origin), w->direction);
        inside += fabs(x) < w->blend / 2;
        behind += x < -w->blend / 2;
        ahead += x > w->blend / 2;
    }
    check_at_least(inside, 1);
    check_at_least(behind, 4);
    check_at_least(ahead, 20);
    rig_free(r);
}

/* What has passed the start and comes back behind it, to the side, is past it: it bears its weight, in whichever part
 * of the work, and nothing holds it on the lead-in's line. */
TEST(test_lead_in_of_a_turn)
{
    Rig *const r = rig_new(GEOMETRY_SMOOTH, FRAME_SYMMETRIC, 0.1, 5);
    const Weight *const w = &r->scene.weight;
    const Vec3 aside = v3_unit(v3_cross(v3(0, 0, 1), w->direction));
    enum { TURN = 12 }; /* past it with segments 5 to 18, then behind it again */
    for (int i = 0; i < N; ++i) {
        const double along = 0.5 * (i < TURN ? i - 4 : 2 * TURN - 5 - i - 1) - 0.1, off = i < TURN ? 0 : 2;
        const Vec3 p = v3_axpy(v3_axpy(w->origin, along, w->direction), off, aside);
        for (int c = 0; c < 3; ++c) r->y[(STATE_P + c) * N + i] = v3_dot(p, v3_axis(c));
    }
    dynamics_pose(&r->scene, &r->ws, 0.7, r->y, 1);
    check_at_least(r->ws.middle, TURN);
    const double *const p[3] = {r->ws.kin.p[0], r->ws.kin.p[1], r->ws.kin.p[2]};
    assert_int_equal(weight_behind(&r->scene, p, w->blend / 2), 5);
    double held = 0;
    for (int i = 0; i < N; ++i) {
        const Vec3 f = v3_load(r->ws.loads[0].f, i), all = v3_scale(r->scene.chain.mass[i], w->gravity);
        if (i > 4) check_close(v3_norm(v3_sub(f, all)), 0, 1e-12);
        if (i < 4) held = fmax(held, v3_norm(v3_sub(f, all)));
    }
    check_above(held, 1);
    BlockChain k, d;
    assert_true(block_chain_alloc(&k, N, 6) && block_chain_alloc(&d, N, 6));
    weight_blocks(&r->scene, &r->ws.kin, &k, &d);
    for (int i = 0; i < N; ++i) {
        double most = 0;
        for (int c = 0; c < 36; ++c) most = fmax(most, fabs(k.diag[36 * i + c]));
        assert_int_equal(most > 0, i <= 4);
    }
    block_chain_free(&k);
    block_chain_free(&d);
    rig_free(r);
}

/* The rates depend on (t, y) alone: bitwise the same whatever was evaluated before. */
TEST(test_pure)
{
    Rig *const r = rig_new(GEOMETRY_SMOOTH, FRAME_SYMMETRIC, 0.1, 3);
    double other[STATE_SIZE * N], rate[STATE_SIZE * N];
    BlockChain k, d;
    assert_true(block_chain_alloc(&k, N, 6) && block_chain_alloc(&d, N, 6));
    memcpy(other, r->y, sizeof other);
    state_shake(other, N, 0.02, 0.1, 1, 1, &r->seed);
    dynamics_rates(&r->scene, &r->ws, 2.5, other, 0, rate);
    dynamics_blocks(&r->scene, &r->ws, 0.1, other, rate, 1, &k, &d);
    dynamics_rates(&r->scene, &r->ws, 0.7, r->y, 1, rate);
    assert_memory_equal(rate, r->rate, sizeof rate);
    /* candidates of another place, as long as they are fresh enough, make no difference either */
    assert_int_equal(dynamics_refresh(&r->scene, &r->ws, 0.7, other, 1, NULL), HAWSER_OK);
    dynamics_rates(&r->scene, &r->ws, 0.7, r->y, 1, rate);
    assert_memory_equal(rate, r->rate, sizeof rate);
    block_chain_free(&k);
    block_chain_free(&d);
    rig_free(r);
}
