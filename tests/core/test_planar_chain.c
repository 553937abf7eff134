/* The planar chain by itself: sines and cosines of lanes, the wrenches against those in space, what they conserve and
 * derive from, and their derivatives against finite differences. */

#include "core/bushing.h"
#include "core/planar.h"
#include "core/plane_lanes.h"
#include "tests/support/chain.h"
#include "tests/support/check.h"

enum { N = 13, STRIDE = 16 };

typedef struct Rig {
    Chain space;
    Kinematics kin3;
    JointLoads loads3;
    PlanarChain chain;
    PlanarKinematics kin;
    PlanarJointLoads loads;
    double y[PLANAR_SIZE * STRIDE];
    uint64_t seed;
} Rig;

/* The planar chain that space is when it moves in x and z: normal -y, a segment's z across it. */
static void chain_copy(Rig *r)
{
    const Chain *const c = &r->space;
    PlanarChain *const p = &r->chain;
    p->share = c->frame == FRAME_SYMMETRIC ? 0.5 : 1;
    for (int i = 0; i < N; ++i) {
        p->half[i] = c->half[i];
        p->mass[i] = c->mass[i];
        p->inertia[i] = c->inertia[1][i];
        p->inverse_mass[i] = 1 / p->mass[i];
        p->inverse_inertia[i] = 1 / p->inertia[i];
    }
    for (int j = 0; j <= N; ++j) {
        const int from[3] = {0, 2, 4};
        for (int k = 0; k < 3; ++k) {
            p->stiffness[k][j] = c->stiffness[from[k]][j];
            p->damping[k][j] = c->damping[from[k]][j];
            p->preload[k][j] = (k == 2 ? -1 : 1) * c->preload[from[k]][j];
        }
        c->preload[1][j] = c->preload[3][j] = c->preload[5][j] = 0;
    }
}

/* Kinematics of y in both; the ghosts stand at the origin, at rest. */
static void place(Rig *r)
{
    planar_kernels()->kinematics(&r->chain, r->y, 0, N, &r->kin);
    double *const ghost[] = {r->kin.p[0], r->kin.p[1], r->kin.angle, r->kin.v[0], r->kin.v[1], r->kin.w};
    for (int c = 0; c < 6; ++c) ghost[c][N] = 0;
    r->kin.h[0][N] = r->kin.a[0][N] = 1;
    r->kin.h[1][N] = r->kin.a[1][N] = 0;
    for (int i = 0; i < N; ++i) {
        const double *const at = r->y + i;
        vec_store(r->kin3.p, i, v3(at[0], 0, at[STRIDE]));
        vec_store(r->kin3.v, i, v3(at[3 * STRIDE], 0, at[4 * STRIDE]));
        vec_store(r->kin3.w, i, v3(0, -at[5 * STRIDE], 0));
        kinematics_turn_to(&r->kin3, i, quat_exp(v3(0, -at[2 * STRIDE], 0)));
    }
}

/* A chain bent by up to `bend` (rad) a joint, with open joints and every velocity; `turn` is the first segment's angle.
 */
static Rig rig_new(BushingFrame frame, double bend, double turn, uint64_t seed)
{
    Rig r = {.seed = seed};
    assert_true(chain_alloc(&r.space, N) && kinematics_alloc(&r.kin3, N) && chain_struct_alloc(&r.loads3, N));
    assert_true(planar_chain_alloc(&r.chain, N) && planar_kinematics_alloc(&r.kin, N));
    assert_true(chain_struct_alloc(&r.loads, N));
    assert_int_equal(r.chain.stride, STRIDE);
    r.space.frame = frame;
    fixture_chain(&r.space, &r.seed);
    chain_copy(&r);
    double end[2] = {1, 2}, angle = turn;
    for (int i = 0; i < N; ++i) {
        angle += bend * fixture_random(&r.seed);
        const double half = r.chain.half[i], along[2] = {half * cos(angle), half * sin(angle)};
        for (int c = 0; c < 2; ++c) {
            r.y[c * STRIDE + i] = end[c] + along[c] + 0.05 * fixture_random(&r.seed);
            end[c] += 2 * along[c];
            r.y[(3 + c) * STRIDE + i] = fixture_random(&r.seed);
        }
        r.y[2 * STRIDE + i] = angle;
        r.y[5 * STRIDE + i] = fixture_random(&r.seed);
    }
    place(&r);
    return r;
}

static void rig_free(Rig *r)
{
    chain_free(&r->space);
    kinematics_free(&r->kin3);
    chain_struct_free(&r->loads3);
    planar_chain_free(&r->chain);
    chain_struct_free(&r->kin);
    chain_struct_free(&r->loads);
}

/* To the last bit or two, in every quarter of the circle and many turns away. */
TEST(test_direction)
{
    uint64_t seed = 1;
    double worst = 0;
    for (int k = 0; k < 20000; ++k) {
        const double x = (k % 3 == 0 ? 1 : k % 3 == 1 ? 10 : 1e4) * fixture_random(&seed);
        const Lane2 d = lane_direction(lane_set(x));
        for (int l = 0; l < LANES; l += 7) {
            worst = larger_of(worst, larger_of(fabs(d.x[l] - cos(x)), fabs(d.z[l] - sin(x))));
        }
    }
    print_message("sines and cosines: %.2g\n", worst);
    check_below(worst, 3e-16);
    check_nan(lane_direction(lane_set(NAN)).x[3]);
    for (int k = -8; k <= 8; ++k) {
        const Lane2 d = lane_direction(lane_set(k * M_PI / 2));
        check_close(d.x[0], cos(k * M_PI / 2), 1e-16);
        check_close(d.z[0], sin(k * M_PI / 2), 1e-16);
    }
}

/* Joints between segments as in space, turned by any angle; the moments about -y change their sign. */
TEST(test_space)
{
    double worst = 0;
    for (uint64_t k = 0; k < 20; ++k) {
        Rig r = rig_new(k % 2 ? FRAME_ADAMS : FRAME_SYMMETRIC, 0.1 * (double)(k % 10), 3.0 * (double)k - 20, k);
        planar_kernels()->joint_loads(&r.chain, &r.kin, 0, N + 1, &r.loads);
        bushing_kernels()->loads(&r.space, &r.kin3, 0, N + 1, &r.loads3);
        for (int j = 1; j < N; ++j) {
            worst = larger_of(worst, fabs(r.loads.force[0][j] - r.loads3.force[0][j]));
            worst = larger_of(worst, fabs(r.loads.force[1][j] - r.loads3.force[2][j]));
            worst = larger_of(worst, fabs(r.loads.torque_a[j] + r.loads3.torque_a[1][j]));
            worst = larger_of(worst, fabs(r.loads.torque_b[j] + r.loads3.torque_b[1][j]));
        }
        rig_free(&r);
    }
    print_message("wrenches against those in space: %.2g of order 1\n", worst);
    check_below(worst, 1e-12);
}

/* What a joint does to its two segments adds up to nothing about any point, and depends on no direction. */
TEST(test_action_and_reaction)
{
    for (int frame = 0; frame < 2; ++frame) {
        Rig r = rig_new(frame ? FRAME_ADAMS : FRAME_SYMMETRIC, 0.8, 0.3, 5);
        Rig turned = rig_new(frame ? FRAME_ADAMS : FRAME_SYMMETRIC, 0.8, 0.3, 5);
        const double by = 1.234, c = cos(by), s = sin(by);
        for (int i = 0; i < N; ++i) {
            double *const at = turned.y + i;
            for (int part = 0; part < 4; part += 3) {
                const double x = at[part * STRIDE], z = at[(part + 1) * STRIDE];
                at[part * STRIDE] = c * x - s * z;
                at[(part + 1) * STRIDE] = s * x + c * z;
            }
            at[2 * STRIDE] += by;
        }
        place(&turned);
        planar_kernels()->joint_loads(&r.chain, &r.kin, 0, N + 1, &r.loads);
        planar_kernels()->joint_loads(&turned.chain, &turned.kin, 0, N + 1, &turned.loads);
        for (int j = 1; j < N; ++j) {
            const double fx = r.loads.force[0][j], fz = r.loads.force[1][j];
            const double dx = r.y[j - 1] - r.y[j], dz = r.y[STRIDE + j - 1] - r.y[STRIDE + j];
            check_close(dx * fz - dz * fx + r.loads.torque_a[j] + r.loads.torque_b[j], 0, 1e-13);
            check_close(turned.loads.force[0][j], c * fx - s * fz, 1e-13);
            check_close(turned.loads.force[1][j], s * fx + c * fz, 1e-13);
            check_close(turned.loads.torque_a[j], r.loads.torque_a[j], 1e-13);
            check_close(turned.loads.torque_b[j], r.loads.torque_b[j], 1e-13);
        }
        rig_free(&r);
        rig_free(&turned);
    }
}

/* Force and moment on every segment. */
static void segment_loads(Rig *r, double out[3 * N])
{
    place(r);
    planar_kernels()->joint_loads(&r->chain, &r->kin, 0, N + 1, &r->loads);
    for (int i = 0; i < N; ++i) {
        out[3 * i] = r->loads.force[0][i + 1] - r->loads.force[0][i];
        out[3 * i + 1] = r->loads.force[1][i + 1] - r->loads.force[1][i];
        out[3 * i + 2] = r->loads.torque_a[i + 1] + r->loads.torque_b[i];
    }
}

TEST(test_differences)
{
    const double e = 1e-5;
    double worst = 0;
    for (int frame = 0; frame < 2; ++frame) {
        Rig r = rig_new(frame ? FRAME_ADAMS : FRAME_SYMMETRIC, 0.9, -2, 9);
        PlanarBlocks k, d;
        assert_true(chain_struct_alloc(&k, N) && chain_struct_alloc(&d, N));
        planar_kernels()->joint_blocks(&r.chain, &r.kin, 0, N + 1, &k, &d);
        planar_kernels()->blocks_join(&k, 0, N);
        planar_kernels()->blocks_join(&d, 0, N);
        planar_blocks_trim(&k, N);
        planar_blocks_trim(&d, N);
        for (int column = 0; column < 6 * N; ++column) {
            const int segment = column / 6, c = column % 6;
            const PlanarBlocks *const b = c < 3 ? &k : &d;
            double *const at = &r.y[c * STRIDE + segment], before = *at;
            double plus[3 * N], minus[3 * N];
            *at = before + e;
            segment_loads(&r, plus);
            *at = before - e;
            segment_loads(&r, minus);
            *at = before;
            for (int row = 0; row < 3 * N; ++row) {
                const int i = row / 3, entry = 3 * (c % 3) + row % 3;
                const double mine = i == segment       ? b->diag[entry][i]
                                    : i + 1 == segment ? b->upper[entry][i]
                                    : i - 1 == segment ? b->lower[entry][i]
                                                       : 0;
                worst = larger_of(worst, fabs((plus[row] - minus[row]) / (2 * e) - mine));
            }
        }
        chain_struct_free(&k);
        chain_struct_free(&d);
        rig_free(&r);
    }
    print_message("derivatives of order 10: %.2g from finite differences\n", worst);
    check_below(worst, 1e-8);
}

/* What fills the arrays up does not move, wherever the ghost is that stands there. */
TEST(test_padding)
{
    Rig r = rig_new(FRAME_SYMMETRIC, 0.5, 0, 3);
    PlanarLoads loads[2];
    double rate[PLANAR_SIZE * STRIDE];
    for (int k = 0; k < 2; ++k) assert_true(chain_struct_alloc(&loads[k], N));
    r.kin.v[0][N] = r.kin.w[N] = 7;
    planar_kernels()->joint_loads(&r.chain, &r.kin, 0, N + 1, &r.loads);
    assert_true(planar_kernels()->rates(&r.chain, &r.kin, &r.loads, loads, 0, N, rate));
    for (int k = 0; k < PLANAR_SIZE * STRIDE; ++k) {
        if (k % STRIDE >= N) check_equal(rate[k], 0);
    }
    loads[1].m[4] = INFINITY;
    assert_false(planar_kernels()->rates(&r.chain, &r.kin, &r.loads, loads, 0, N, rate));
    for (int k = 0; k < 2; ++k) chain_struct_free(&loads[k]);
    rig_free(&r);
}

/* What planar arrays begin with, and what is cut off at the ends of the matrix: nothing couples to the ground. */
TEST(test_first_values)
{
    enum { M = 5 };
    PlanarChain chain;
    PlanarKinematics kin;
    PlanarBlocks blocks;
    assert_true(planar_chain_alloc(&chain, M) && planar_kinematics_alloc(&kin, M) && chain_struct_alloc(&blocks, M));
    assert_int_equal(chain.n, M);
    assert_int_equal(chain.stride, planar_stride(M));
    check_equal(chain.share, 0.5);
    for (int i = -1; i <= M; ++i) {
        check_equal(kin.h[0][i], 1);
        check_equal(kin.h[1][i], 0);
        check_equal(kin.a[0][i], 1);
        check_equal(kin.a[1][i], 0);
        check_equal(chain.mass[i] + chain.half[i] + chain.stiffness[2][i] + chain.preload[2][i], 0);
        for (int e = 0; e < 9; ++e) blocks.lower[e][i] = blocks.upper[e][i] = 1 + e;
    }
    planar_blocks_trim(&blocks, M);
    for (int e = 0; e < 9; ++e) {
        for (int i = 0; i < M; ++i) {
            check_equal(blocks.lower[e][i], i == 0 ? 0 : 1 + e);
            check_equal(blocks.upper[e][i], i == M - 1 ? 0 : 1 + e);
        }
        check_equal(blocks.lower[e][M], 0);
        check_equal(blocks.upper[e][-1], 0);
    }
    chain_struct_free(&blocks);
    chain_struct_free(&kin);
    planar_chain_free(&chain);
}

/* (PL2) one segment at a time, zeros behind the last, and a rate that is not finite is seen wherever it is; what
 * dampers alone take out, W (BA4), is what their wrenches do to the bodies. */
TEST(test_rates_and_damping)
{
    for (int frame = 0; frame < 2; ++frame) {
        Rig r = rig_new(frame ? FRAME_ADAMS : FRAME_SYMMETRIC, 0.3, 0.4, 23);
        PlanarLoads loads[2];
        double ydot[PLANAR_SIZE * STRIDE];
        for (int k = 0; k < 2; ++k) {
            assert_true(chain_struct_alloc(&loads[k], N));
            for (int i = 0; i < N; ++i) {
                loads[k].f[0][i] = fixture_random(&r.seed);
                loads[k].f[1][i] = fixture_random(&r.seed);
                loads[k].m[i] = fixture_random(&r.seed);
            }
        }
        planar_kernels()->joint_loads(&r.chain, &r.kin, 0, N + 1, &r.loads);
        assert_true(planar_kernels()->rates(&r.chain, &r.kin, &r.loads, loads, 0, N, ydot));
        for (int i = 0; i < STRIDE; ++i) {
            for (int c = 0; c < PLANAR_SIZE; ++c) {
                double expected = i < N && c < 3 ? r.y[(3 + c) * STRIDE + i] : 0;
                if (i < N && c >= 3 && c < 5) {
                    const int a = c - 3;
                    expected = (r.loads.force[a][i + 1] - r.loads.force[a][i] + loads[0].f[a][i] + loads[1].f[a][i]) /
                               r.chain.mass[i];
                } else if (i < N && c == 5) {
                    expected = (r.loads.torque_a[i + 1] + r.loads.torque_b[i] + loads[0].m[i] + loads[1].m[i]) /
                               r.chain.inertia[i];
                }
                check_close(ydot[c * STRIDE + i], expected, 1e-13 * (1 + fabs(expected)));
            }
        }
        for (int i = 0; i < N; ++i) {
            double *const at[] = {&loads[1].f[0][i], &loads[0].f[1][i], &loads[1].m[i], &r.kin.v[0][i]};
            for (int k = 0; k < 4; ++k) {
                const double was = *at[k];
                *at[k] = k % 2 ? INFINITY : NAN;
                assert_false(planar_kernels()->rates(&r.chain, &r.kin, &r.loads, loads, 0, N, ydot));
                *at[k] = was;
            }
        }
        for (int k = 0; k < 3; ++k) {
            for (int j = 0; j <= N; ++j) r.chain.stiffness[k][j] = r.chain.preload[k][j] = 0;
        }
        const double lost = planar_kernels()->joint_loads(&r.chain, &r.kin, 0, N + 1, &r.loads);
        double given = 0;
        for (int i = 0; i < N; ++i) {
            given += (r.loads.force[0][i + 1] - r.loads.force[0][i]) * r.y[3 * STRIDE + i] +
                     (r.loads.force[1][i + 1] - r.loads.force[1][i]) * r.y[4 * STRIDE + i] +
                     (r.loads.torque_a[i + 1] + r.loads.torque_b[i]) * r.y[5 * STRIDE + i];
        }
        check_above(lost, 0);
        check_share(lost, -given, 1e-12);
        for (int k = 0; k < 2; ++k) chain_struct_free(&loads[k]);
        rig_free(&r);
    }
}
