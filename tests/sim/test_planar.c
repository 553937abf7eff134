/* The planar equations: the same rates, derivative blocks and samples as those in space for every state in the plane;
 * derivatives against finite differences; the Newton solution against the definition. */
#include "sim/equipment/rooms.h"
#include "sim/solve/newton.h"
#include "sim/solve/planar.h"
#include "sim/solve/scales.h"
#include "tests/support/scene.h"

enum { N = FIXTURE_SEGMENTS, STRIDE = (N + 7) / 8 * 8, SIZE = PLANAR_SIZE * STRIDE };

static const double T = 0.7; /* s */

typedef struct Rig {
    Scene scene;
    Workspace ws, planar_ws;
    Plane plane;
    Planar planar;
    double y[SIZE], rate[SIZE];                             /* in the plane */
    double full[STATE_SIZE * N], full_rate[STATE_SIZE * N]; /* in space */
    uint64_t seed;
} Rig;

/* The scene at a heading of 37 deg, bent and stretched in its plane, moving at up to `speed` (m/s), `ahead` m further
 * along the route. */
static Rig *rig_ahead(ContactGeometry geometry, BushingFrame frame, int soft, double speed, uint64_t seed, double ahead)
{
    Rig *const r = fixture_array(1, sizeof *r);
    SceneDef def;
    char why[PLANE_WHY_MAX];
    hawser_error err = {0};
    fixture_planar(&def, &(FixtureChoice){.geometry = geometry,
                                          .frame = frame,
                                          .soft = soft,
                                          .heading = 37 * M_PI / 180,
                                          .start = {3, -2, 1},
                                          .ahead = ahead});
    def.solver.linear.kind = LIN_BLOCK;
    def.winch.axial_only = seed / 2 % 2; /* (WI1a) */
    fixture_build(&def, &r->scene);
    r->seed = seed;
    assert_true(workspace_alloc(&r->ws, &r->scene, NULL) && workspace_alloc(&r->planar_ws, &r->scene, NULL));
    if (!plane_find(&r->scene, &r->plane, why)) fail_msg("%s", why);
    if (planar_new(&r->planar, &r->scene, &r->plane, &r->planar_ws, &r->scene.def.solver.linear, &err))
        fail_msg("%s", err.message);
    assert_int_equal(r->planar.motion.size, SIZE);
    scene_initial_state(&r->scene, r->full);
    r->planar.motion.ops->pack(&r->planar.motion, r->full, r->y);
    planar_shake(r->y, N, 3e-3, 0.02, speed, speed, &r->seed);
    plane_lift(&r->plane, N, r->y, r->full);
    assert_int_equal(planar_refresh(&r->planar, T, r->y, 1, NULL), HAWSER_OK);
    assert_int_equal(dynamics_refresh(&r->scene, &r->ws, T, r->full, 1, NULL), HAWSER_OK);
    assert_int_equal(planar_evaluate(&r->planar, T, r->y, 1, r->rate), 0);
    dynamics_rates(&r->scene, &r->ws, T, r->full, 1, r->full_rate);
    return r;
}

static Rig *rig_new(ContactGeometry geometry, BushingFrame frame, int soft, double speed, uint64_t seed)
{
    return rig_ahead(geometry, frame, soft, speed, seed, 0);
}

static void rig_free(Rig *r)
{
    planar_free(&r->planar);
    workspace_free(&r->ws);
    workspace_free(&r->planar_ws);
    scene_clear(&r->scene);
    free(r);
}

/* Pieces of a vector in space along the plane's two axes and its normal. */
static Vec3 in_plane(const Plane *p, Vec3 v) { return v3(v3_dot(v, p->e1), v3_dot(v, p->e2), v3_dot(v, p->normal)); }

/* Force and moment on the segments must be those in space, and nothing may point out of the plane. */
static double rates_error(const Rig *r)
{
    double error[2] = {0}, size[2] = {0};
    for (int i = 0; i < N; ++i) {
        const double m = r->scene.chain.mass[i], j = r->planar.ps.chain.inertia[i];
        const Vec3 a = in_plane(&r->plane, state_vec(r->full_rate, N, STATE_V, i));
        const Vec3 b = in_plane(&r->plane, state_vec(r->full_rate, N, STATE_W, i));
        const double *const mine = r->rate + PLANAR_V * STRIDE + i;
        const double off[2] = {m * (fabs(a.x - mine[0]) + fabs(a.y - mine[STRIDE]) + fabs(a.z)),
                               j * (fabs(b.z - mine[2 * STRIDE]) + fabs(b.x) + fabs(b.y))};
        const double most[2] = {m * (fabs(a.x) + fabs(a.y)), j * fabs(b.z)};
        for (int k = 0; k < 2; ++k) {
            error[k] = larger_of(error[k], off[k]);
            size[k] = larger_of(size[k], most[k]);
        }
    }
    return larger_of(error[0] / size[0], error[1] / size[1]);
}

TEST(test_rates)
{
    double worst = 0;
    int active = 0;
    for (uint64_t k = 0; k < 24; ++k) {
        const double speed[] = {5e-4, 8e-3, 0.2};
        Rig *const r = rig_new(k % 2 ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH, k % 4 / 2 ? FRAME_ADAMS : FRAME_SYMMETRIC,
                               1, speed[k % 3], 7 + k);
        worst = larger_of(worst, rates_error(r));
        active += r->planar_ws.contact[0].pairs.active + r->planar_ws.contact[1].pairs.active;
        assert_int_equal(r->planar_ws.contact[0].pairs.n_hits, r->ws.contact[0].pairs.n_hits);
        for (int i = 0; i < SIZE; ++i) {
            if (i % STRIDE >= N) check_equal(r->rate[i], 0);
        }
        rig_free(r);
    }
    print_message("rates against those in space: %.2g relative, %d contacts\n", worst, active);
    check_above(active, 60);
    check_below(worst, 1e-12);
}

/* A chain that has passed the start and comes back above it: in both it bears its weight there. */
TEST(test_turned_back)
{
    Rig *const r = rig_new(GEOMETRY_SMOOTH, FRAME_SYMMETRIC, 1, 0.2, 7);
    const PlanarWeight *const w = &r->planar.ps.weight;
    enum { TURN = 12 };
    const double up[2] = {-w->direction[1], w->direction[0]};
    for (int i = 0; i < N; ++i) {
        const double along = 0.5 * (i < TURN ? i - 4 : 2 * TURN - 6 - i) - 0.1, off = i < TURN ? 0 : 3;
        for (int c = 0; c < 2; ++c) r->y[c * STRIDE + i] = w->origin[c] + along * w->direction[c] + off * up[c];
    }
    plane_lift(&r->plane, N, r->y, r->full);
    assert_int_equal(planar_weight_behind(&r->planar.ps, r->y), 5);
    assert_int_equal(planar_evaluate(&r->planar, T, r->y, 1, r->rate), 0);
    dynamics_rates(&r->scene, &r->ws, T, r->full, 1, r->full_rate);
    for (int i = TURN; i < N - 1; ++i) {
        const Vec3 f = in_plane(&r->plane, v3_load(r->ws.loads[0].f, i));
        const double m = r->scene.chain.mass[i];
        for (int c = 0; c < 2 && i != r->scene.drag.segment; ++c) {
            check_close(r->planar.loads[0].f[c][i], m * w->gravity[c], 1e-12);
            check_close(c ? f.y : f.x, m * w->gravity[c], 1e-12);
        }
    }
    rig_free(r);
}

/* Entry (row, column) of a 6x6 block seen from the plane: coordinate 0, 1: its axes; 2: its normal. */
static double entry_in_plane(const Plane *p, const double *block, int row, int column)
{
    const Vec3 axis[3] = {p->e1, p->e2, p->normal};
    const double *const r = &axis[row].x, *const c = &axis[column].x;
    double sum = 0;
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i) sum += r[i] * c[j] * block[6 * (3 * (column == 2) + j) + 3 * (row == 2) + i];
    }
    return sum;
}

/* Largest difference over the largest entry, each kind of entry by itself. */
static double blocks_error(const Plane *p, double *const mine[9], const double *full, int from, int to)
{
    double error[2][2] = {{0}}, size[2][2] = {{0}}, worst = 0;
    for (int i = from; i < to; ++i) {
        for (int e = 0; e < 9; ++e) {
            const int row = e % 3, column = e / 3, a = row == 2, b = column == 2;
            const double other = entry_in_plane(p, full + 36 * i, row, column);
            error[a][b] = larger_of(error[a][b], fabs(other - mine[e][i]));
            size[a][b] = larger_of(size[a][b], fabs(other));
        }
    }
    for (int k = 0; k < 4; ++k) worst = larger_of(worst, error[k / 2][k % 2] / size[k / 2][k % 2]);
    return worst;
}

static double all_blocks_error(const Rig *r, const PlanarBlocks *mine, const BlockChain *full)
{
    const double lower = blocks_error(&r->plane, mine->lower, full->lower, 1, N);
    const double diag = blocks_error(&r->plane, mine->diag, full->diag, 0, N);
    return larger_of(larger_of(lower, diag), blocks_error(&r->plane, mine->upper, full->upper, 0, N - 1));
}

TEST(test_blocks)
{
    double worst = 0;
    BlockChain k, d;
    assert_true(block_chain_alloc(&k, N, 6) && block_chain_alloc(&d, N, 6));
    for (uint64_t c = 0; c < 12; ++c) {
        const double speed[] = {5e-4, 8e-3, 0.2};
        Rig *const r = rig_new(c % 2 ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH, c % 4 / 2 ? FRAME_ADAMS : FRAME_SYMMETRIC,
                               1, speed[c % 3], 40 + c);
        dynamics_blocks(&r->scene, &r->ws, T, r->full, r->full_rate, 1, &k, &d);
        planar_blocks(&r->planar, T, r->y, 1);
        worst = larger_of(worst, all_blocks_error(r, &r->planar.newton.k, &k));
        worst = larger_of(worst, all_blocks_error(r, &r->planar.newton.d, &d));
        for (int e = 0; e < 9; ++e) { /* nothing couples the chain with its ghosts */
            check_equal(r->planar.newton.k.lower[e][0], 0);
            check_equal(r->planar.newton.k.upper[e][N - 1], 0);
            check_equal(r->planar.newton.k.lower[e][N], 0);
            check_equal(r->planar.newton.d.lower[e][N], 0);
        }
        rig_free(r);
    }
    block_chain_free(&k);
    block_chain_free(&d);
    print_message("blocks against those in space: %.2g relative\n", worst);
    check_below(worst, 1e-11);
}

/* Largest error of K and D against central differences of the balance, by kind. */
static double differences_error(Rig *r)
{
    const double e = 5e-7;
    double error[2][2] = {{0}}, size[2][2] = {{0}}, worst = 0;
    planar_blocks(&r->planar, T, r->y, 1);
    const PlanarBlocks *const block[2] = {&r->planar.newton.k, &r->planar.newton.d};
    for (int column = 0; column < 6 * N; ++column) {
        const int segment = column / 6, c = column % 6;
        double y[SIZE], plus[SIZE], minus[SIZE];
        memcpy(y, r->y, sizeof y);
        y[c * STRIDE + segment] += e;
        planar_evaluate(&r->planar, T, y, 1, plus);
        y[c * STRIDE + segment] = r->y[c * STRIDE + segment] - e;
        planar_evaluate(&r->planar, T, y, 1, minus);
        for (int i = 0; i < N; ++i) {
            for (int row = 0; row < 3; ++row) {
                const int at = (PLANAR_V + row) * STRIDE + i;
                const double inertia = row == 2 ? r->planar.ps.chain.inertia[i] : r->planar.ps.chain.mass[i];
                const double fd = inertia * (plus[at] - minus[at]) / (2 * e);
                const PlanarBlocks *const b = block[c / 3];
                double *const *const part = i == segment       ? b->diag
                                            : i + 1 == segment ? b->upper
                                            : i - 1 == segment ? b->lower
                                                               : NULL;
                const double mine = part ? part[3 * (c % 3) + row][i] : 0;
                error[c / 3][row == 2] = larger_of(error[c / 3][row == 2], fabs(fd - mine));
                size[c / 3][row == 2] = larger_of(size[c / 3][row == 2], fabs(fd));
            }
        }
    }
    for (int k = 0; k < 4; ++k) worst = larger_of(worst, error[k / 2][k % 2] / size[k / 2][k % 2]);
    return worst;
}

/* The tail in a bend, along which its tension goes (F2): force, power, blocks and place are those in space. */
TEST(test_tail_in_a_bend)
{
    const double ahead[] = {7.5, 9.2}; /* m: the tail in the bend downward, in the one upward */
    BlockChain k, d;
    assert_true(block_chain_alloc(&k, N, 6) && block_chain_alloc(&d, N, 6));
    for (int i = 0; i < 2; ++i) {
        Rig *const r = rig_ahead(GEOMETRY_SMOOTH, FRAME_SYMMETRIC, 1, 0.2, 51, ahead[i]);
        check_close(r->planar_ws.tail_at, r->ws.tail_at, 1e-9);
        check_close(r->ws.tail_at, r->scene.joint_s[0], 0.02);
        check_below(rates_error(r), 1e-12);
        const Push tail = planar_tail(&r->planar.ps, &r->planar.kin, T, r->planar_ws.tail_at);
        BalanceRates by = {0};
        ENDS_ROOM.work(room_of(&r->scene, &ENDS_ROOM), &(Moment){&r->scene, &r->ws, T, 1}, &by);
        check_above(v3_norm(v3_cross(tail.force, r->scene.weight.direction)), 10); /* N */
        check_close(v3_norm(v3_sub(tail.force, by.push[BY_TAIL])), 0, 1e-9);
        check_close(tail.power, by.work[BY_TAIL], 1e-9);
        dynamics_blocks(&r->scene, &r->ws, T, r->full, r->full_rate, 1, &k, &d);
        planar_blocks(&r->planar, T, r->y, 1);
        check_below(all_blocks_error(r, &r->planar.newton.k, &k), 1e-11);
        check_below(differences_error(r), 3e-7);
        rig_free(r);
    }
    block_chain_free(&k);
    block_chain_free(&d);
}

TEST(test_differences)
{
    double worst = 0;
    for (uint64_t c = 0; c < 6; ++c) {
        const double speed[] = {5e-4, 8e-3, 0.2};
        Rig *const r = rig_new(c % 2 ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH, c % 4 / 2 ? FRAME_ADAMS : FRAME_SYMMETRIC,
                               1, speed[c % 3], 70 + c);
        worst = larger_of(worst, differences_error(r));
        rig_free(r);
    }
    print_message("blocks against finite differences: %.2g relative\n", worst);
    check_below(worst, 3e-7);
}

/* x - gamma J x = b, with J x by central differences of the rates; speeds small enough for them to see every term. */
TEST(test_newton)
{
    Rig *const r = rig_new(GEOMETRY_SMOOTH, FRAME_SYMMETRIC, 1, 8e-3, 3);
    Motion *const m = &r->planar.motion;
    const double gamma = 4e-3, e = 1e-6;
    double b[SIZE] = {0}, x[SIZE], y[SIZE], plus[SIZE], minus[SIZE], size = 0, error = 0;
    for (int k = 0; k < SIZE; ++k) {
        if (k % STRIDE < N) b[k] = (k < PLANAR_V * STRIDE ? 1e-3 : 1) * fixture_random(&r->seed);
    }
    memcpy(x, b, sizeof x);
    m->ops->linearise(m, T, r->y, r->rate);
    m->ops->form(m, gamma);
    assert_int_equal(m->ops->factor(m), 0);
    assert_int_equal(m->ops->solve(m, x), 0);
    for (int k = 0; k < SIZE; ++k) y[k] = r->y[k] + e * x[k];
    m->ops->rates(m, T, y, plus);
    for (int k = 0; k < SIZE; ++k) y[k] = r->y[k] - e * x[k];
    m->ops->rates(m, T, y, minus);
    for (int k = 0; k < SIZE; ++k) {
        size = larger_of(size, fabs(b[k]));
        error = larger_of(error, fabs(x[k] - gamma * (plus[k] - minus[k]) / (2 * e) - b[k]));
        if (k % STRIDE >= N) check_equal(x[k], 0);
    }
    print_message("Newton's system: residual %.2g\n", error / size);
    check_below(error, 1e-6 * size);
    rig_free(r);
}

/* Largest difference of count numbers, over the largest of them. */
static double difference(int count, const double *a, const double *b)
{
    double error = 0, size = 0;
    for (int k = 0; k < count; ++k) {
        error = larger_of(error, fabs(a[k] - b[k]));
        size = larger_of(size, fabs(b[k]));
    }
    return error / size;
}

/* What a sample reads is what the motion in space would have put there; and a state comes back as it went. */
TEST(test_look)
{
    Rig *const r = rig_new(GEOMETRY_SMOOTH, FRAME_SYMMETRIC, 1, 0.1, 19);
    Spatial spatial;
    Motion *const flat = &r->planar.motion, *const full = spatial_init(&spatial, &r->scene, &r->ws, NULL);
    double again[SIZE], lifted[STATE_SIZE * N];
    assert_int_equal(flat->ops->look(flat, T, r->y, 1), full->ops->look(full, T, r->full, 1));
    check_below(difference(N + 1, r->planar_ws.law[0], r->ws.law[0]), 1e-11);
    double *const *const mine[] = {r->planar_ws.kin.p, r->planar_ws.kin.q, r->planar_ws.kin.v, r->planar_ws.kin.w};
    double *const *const theirs[] = {r->ws.kin.p, r->ws.kin.q, r->ws.kin.v, r->ws.kin.w};
    for (int k = 0; k < 4; ++k) {
        for (int c = 0; c < (k == 1 ? 4 : 3); ++c) {
            for (int i = 0; i < N; ++i) check_close(mine[k][c][i], theirs[k][c][i], 1e-13);
        }
    }
    for (int roller = 0; roller < r->scene.contact.n_rollers; ++roller) {
        const Vec3 a = r->planar_ws.on_roller[roller], b = r->ws.on_roller[roller];
        check_vec(a, b, 1e-11 * (1 + v3_norm(b)));
    }
    for (int i = 0; i < N; ++i) {
        const Loads *const of = r->planar_ws.loads, *const in = r->ws.loads;
        const Vec3 a = v3_add(v3_load(of[0].f, i), v3_load(of[1].f, i)),
                   b = v3_add(v3_load(in[0].f, i), v3_load(in[1].f, i));
        check_vec(a, b, 1e-11 * (1 + v3_norm(b)));
    }
    check_share(r->planar_ws.head_pull, r->ws.head_pull, 1e-11);
    check_share(flat->ops->winch_pull(flat, T, r->y), r->ws.head_pull, 1e-11);
    flat->ops->unpack(flat, r->y, lifted);
    check_below(plane_press(&r->plane, N, lifted, again), 1e-13);
    check_below(difference(SIZE, again, r->y), 1e-14);
    rig_free(r);
}

/* Errors are judged alike: a planar error has the norm that the same error has in space. */
TEST(test_norm)
{
    Rig *const r = rig_new(GEOMETRY_SMOOTH, FRAME_SYMMETRIC, 1, 0.1, 23);
    Spatial spatial;
    Motion *const flat = &r->planar.motion, *const full = spatial_init(&spatial, &r->scene, &r->ws, NULL);
    const double e = 1e-7;
    double w[SIZE], fw[STATE_SIZE * N], x[SIZE], y[SIZE], fx[STATE_SIZE * N];
    flat->ops->weights(flat, w);
    full->ops->weights(full, fw);
    memset(x, 0, sizeof x);
    planar_shake(x, N, e, e, e, e, &r->seed);
    for (int k = 0; k < SIZE; ++k) y[k] = r->y[k] + x[k];
    plane_lift(&r->plane, N, y, fx);
    for (int k = 0; k < STATE_SIZE * N; ++k) fx[k] -= r->full[k];
    const double a = flat->ops->norm(flat, x, w), b = full->ops->norm(full, fx, fw);
    check_share(a, b, 1e-6);
    assert_int_equal(flat->ops->worst(flat, x, w), full->ops->worst(full, fx, fw));
    x[3 * STRIDE + 5] = NAN;
    check_nan(flat->ops->norm(flat, x, w));
    assert_int_equal(flat->ops->worst(flat, x, w), 5);
    rig_free(r);
}

/* Not finite: the integrator is told. */
TEST(test_not_finite)
{
    Rig *const r = rig_new(GEOMETRY_SMOOTH, FRAME_SYMMETRIC, 1, 0.1, 29);
    r->y[STRIDE + 3] = NAN;
    check_above(r->planar.motion.ops->rates(&r->planar.motion, T, r->y, r->rate), 0);
    rig_free(r);
}

/* Elements that the forces look at. */
static int near_count(const Rig *r)
{
    int count = 0;
    for (int half = 0; half < PARTS; ++half) {
        const ContactPairs *const pairs = &r->planar_ws.contact[half].pairs;
        for (int i = 0; i < pairs->n_near; ++i) count += pairs->near[i].count;
    }
    return count;
}

/* The rates with what is near, which must be those with all candidates, bit by bit. */
static void near_suffices(Rig *r)
{
    enum { MOST = 64 };
    static double all[SIZE];
    ContactRange kept[PARTS][MOST];
    int n_kept[PARTS];
    assert_int_equal(planar_evaluate(&r->planar, T, r->y, 1, r->rate), 0);
    for (int half = 0; half < PARTS; ++half) {
        ContactPairs *const pairs = &r->planar_ws.contact[half].pairs;
        check_below(pairs->n_ranges, MOST);
        n_kept[half] = pairs->n_near;
        memcpy(kept[half], pairs->near, (size_t)pairs->n_near * sizeof *pairs->near);
        contact_widen(pairs);
    }
    assert_int_equal(planar_evaluate(&r->planar, T, r->y, 1, all), 0);
    assert_memory_equal(r->rate, all, sizeof all);
    for (int half = 0; half < PARTS; ++half) {
        ContactPairs *const pairs = &r->planar_ws.contact[half].pairs;
        pairs->n_near = n_kept[half];
        memcpy(pairs->near, kept[half], (size_t)n_kept[half] * sizeof *pairs->near);
    }
}

static void step_along(Rig *r, double distance)
{
    for (int i = 0; i < N; ++i) r->y[i] += distance;
    near_suffices(r); /* before what is near is renewed */
    assert_int_equal(r->planar.motion.ops->accept(&r->planar.motion, T, r->y, NULL), HAWSER_OK);
    near_suffices(r);
}

/* What is near (PL19) is a part of the candidates that gives the same forces, goes along with the chain, and becomes
 * all of them when the chain leaps. */
TEST(test_near)
{
    Rig *const r = rig_new(GEOMETRY_SMOOTH, FRAME_SYMMETRIC, 1, 0.1, 31);
    const double reach = r->scene.contact.reach;
    assert_int_equal(r->planar.motion.ops->renew(&r->planar.motion, T, r->y, NULL), HAWSER_OK);
    const int candidates = dynamics_candidates(&r->planar_ws);
    const long refreshes = r->planar_ws.refreshes;
    check_between(near_count(r), 0, 2 * candidates / 3);
    int renewed = 0;
    for (int k = 0; k < 60; ++k) {
        const double before = r->planar.near_moved;
        step_along(r, reach / 140);
        renewed += r->planar.near_moved < before;
        assert_true(!r->planar.wide);
        check_below(near_count(r), candidates);
    }
    check_at_least(renewed, 2);
    check_equal(r->planar_ws.refreshes, refreshes);
    for (int k = 0; k < 60; ++k) step_along(r, reach / 140);
    check_equal(r->planar_ws.refreshes, refreshes + 1);
    assert_true(!r->planar.wide);
    step_along(r, reach / 30);
    assert_true(r->planar.wide);
    assert_int_equal(near_count(r), dynamics_candidates(&r->planar_ws));
    rig_free(r);
}
