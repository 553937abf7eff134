/* The bushing: potential, momentum, objectivity, and every block of its derivative against finite differences. */
#include <string.h>

#include "core/bushing.h"
#include "tests/support/chain.h"
#include "tests/support/check.h"

enum { N = 11 };

typedef struct Rig {
    Chain chain;
    Kinematics kin;
    JointLoads loads;
    uint64_t seed;
} Rig;

static Rig rig_new(BushingFrame frame, double bend, uint64_t seed)
{
    Rig r = {.seed = seed};
    assert_true(chain_alloc(&r.chain, N));
    assert_true(kinematics_alloc(&r.kin, N));
    assert_true(chain_struct_alloc(&r.loads, N));
    r.chain.frame = frame;
    fixture_chain(&r.chain, &r.seed);
    fixture_state(&r.chain, &r.kin, bend, 0.05, &r.seed);
    return r;
}

/* The same with three sliders a joint that have slipped before; at the given bend some hold and some slip. */
static Rig sliding_rig(BushingFrame frame, double bend, uint64_t seed)
{
    Rig r = rig_new(frame, bend, seed);
    assert_true(chain_alloc_sliders(&r.chain, 3) && kinematics_alloc_slips(&r.kin, &r.chain));
    for (int j = 0; j <= N; ++j) {
        for (int s = 0; s < 3; ++s) {
            r.chain.sliders.stiffness[s][j] = 3 + 2 * fixture_random(&r.seed);
            r.chain.sliders.limit[s][j] = bend * (0.8 + 0.6 * fixture_random(&r.seed));
            r.kin.slip[2 * s][j] = 0.3 * bend * fixture_random(&r.seed);
            r.kin.slip[2 * s + 1][j] = 0.3 * bend * fixture_random(&r.seed);
        }
    }
    return r;
}

static void rig_free(Rig *r)
{
    chain_free(&r->chain);
    kinematics_free(&r->kin);
    chain_struct_free(&r->loads);
}

/* Force and moment of the bushings on every segment. */
static void segment_loads(Rig *r, double out[6 * N])
{
    bushing_kernels()->loads(&r->chain, &r->kin, 0, N + 1, &r->loads);
    for (int i = 0; i < N; ++i) {
        for (int c = 0; c < 3; ++c) {
            out[6 * i + c] = r->loads.force[c][i + 1] - r->loads.force[c][i];
            out[6 * i + 3 + c] = r->loads.torque_a[c][i + 1] + r->loads.torque_b[c][i];
        }
    }
}

/* Moves component c (0..2 translation, 3..5 rotation) of segment i by e, or its velocity. */
static void nudge(Kinematics *kin, int i, int c, double e, int velocity)
{
    Vec3 turn = v3(c == 3 ? e : 0, c == 4 ? e : 0, c == 5 ? e : 0);
    if (velocity) {
        (c < 3 ? kin->v[c] : kin->w[c - 3])[i] += e;
    } else if (c < 3) {
        kin->p[c][i] += e;
    } else {
        kinematics_turn_to(kin, i, quat_mul(quat_exp(turn), kinematics_quat(kin, i)));
    }
}

static double block_entry(const BlockChain *a, int i, int k, int row, int col)
{
    const double *const block = k == i ? a->diag : k == i + 1 ? a->upper : a->lower;
    return block[36 * i + 6 * col + row];
}

/* Largest difference between block column (segment k, component c) and the central difference, over the largest entry.
 */
static double column_error(Rig *r, const BlockChain *a, int k, int c, int velocity)
{
    const double e = 1e-5;
    double plus[6 * N], minus[6 * N], worst = 0, scale = 0;
    nudge(&r->kin, k, c, e, velocity);
    segment_loads(r, plus);
    nudge(&r->kin, k, c, -2 * e, velocity);
    segment_loads(r, minus);
    nudge(&r->kin, k, c, e, velocity);
    for (int i = k > 0 ? k - 1 : 0; i <= k + 1 && i < N; ++i) {
        for (int row = 0; row < 6; ++row) {
            const double fd = (plus[6 * i + row] - minus[6 * i + row]) / (2 * e);
            const double error = fabs(fd - block_entry(a, i, k, row, c));
            worst = error > worst ? error : worst;
            scale = fabs(fd) > scale ? fabs(fd) : scale;
        }
    }
    return worst / scale;
}

/* Of a rig, which is freed. */
static void derivative_check(Rig r)
{
    BlockChain k, d;
    assert_true(block_chain_alloc(&k, N, 6));
    assert_true(block_chain_alloc(&d, N, 6));
    bushing_blocks(&r.chain, &r.kin, 0, N + 1, &k, &d);
    for (int i = 0; i < N; ++i) {
        for (int c = 0; c < 6; ++c) {
            check_below(column_error(&r, &k, i, c, 0), 1e-8);
            check_below(column_error(&r, &d, i, c, 1), 1e-8);
        }
    }
    block_chain_free(&k);
    block_chain_free(&d);
    rig_free(&r);
}

/* Small, moderate and large relative rotations: the series, its edge and the closed forms. */
TEST(test_derivatives_symmetric)
{
    for (uint64_t seed = 1; seed < 6; ++seed) {
        derivative_check(rig_new(FRAME_SYMMETRIC, 1e-3, seed));
        derivative_check(rig_new(FRAME_SYMMETRIC, 0.3, seed));
        derivative_check(rig_new(FRAME_SYMMETRIC, 1.2, seed));
    }
}

TEST(test_derivatives_adams)
{
    for (uint64_t seed = 1; seed < 6; ++seed) {
        derivative_check(rig_new(FRAME_ADAMS, 1e-3, seed));
        derivative_check(rig_new(FRAME_ADAMS, 0.3, seed));
        derivative_check(rig_new(FRAME_ADAMS, 1.2, seed));
    }
}

/* Sliders that hold and that slip, in both frames. */
TEST(test_derivatives_sliding)
{
    for (uint64_t seed = 1; seed < 6; ++seed) {
        for (int frame = 0; frame < 2; ++frame) {
            derivative_check(sliding_rig(frame ? FRAME_ADAMS : FRAME_SYMMETRIC, 0.3, seed));
            derivative_check(sliding_rig(frame ? FRAME_ADAMS : FRAME_SYMMETRIC, 1.2, seed));
        }
    }
}

/* The wrench pair gives no net force and no net moment about the origin, whatever the state. */
TEST(test_momentum)
{
    for (int kind = 0; kind < 4; ++kind) {
        const BushingFrame frame = kind % 2 ? FRAME_ADAMS : FRAME_SYMMETRIC;
        Rig r = kind < 2 ? rig_new(frame, 0.8, 7) : sliding_rig(frame, 0.8, 7);
        bushing_kernels()->loads(&r.chain, &r.kin, 0, N + 1, &r.loads);
        for (int j = 1; j < N; ++j) {
            const Vec3 f = vec_load(r.loads.force, j);
            const Vec3 arm = v3_sub(vec_load(r.kin.p, j - 1), vec_load(r.kin.p, j));
            const Vec3 moment =
                v3_add(v3_add(vec_load(r.loads.torque_a, j), vec_load(r.loads.torque_b, j)), v3_cross(arm, f));
            check_below(v3_norm(moment), 1e-13 * (1 + v3_norm(f)));
        }
        rig_free(&r);
    }
}

/* Potential of the undamped, unloaded law at every joint. */
static double potential(Rig *r)
{
    double *law[6], sum = 0;
    for (int c = 0; c < 6; ++c) law[c] = chain_array_new(N, 0);
    bushing_kernels()->law(&r->chain, &r->kin, 0, N + 1, law);
    for (int j = 0; j <= N; ++j) {
        for (int c = 0; c < 6; ++c) sum += law[c][j] * law[c][j] / (2 * r->chain.stiffness[c][j]);
    }
    for (int c = 0; c < 6; ++c) law[c] = chain_array_free(law[c]);
    return sum;
}

/* Undamped and without preload, the symmetric frame's loads are minus the potential's gradient; marker J's are not. */
TEST(test_potential)
{
    const double e = 1e-5;
    double worst[2] = {0, 0};
    for (int frame = 0; frame < 2; ++frame) {
        Rig r = rig_new(frame ? FRAME_ADAMS : FRAME_SYMMETRIC, 0.7, 3);
        for (int c = 0; c < 6; ++c) {
            memset(r.chain.damping[c], 0, (N + 1) * sizeof(double));
            memset(r.chain.preload[c], 0, (N + 1) * sizeof(double));
        }
        double loads[6 * N];
        segment_loads(&r, loads);
        for (int i = 0; i < N; ++i) {
            for (int c = 0; c < 6; ++c) {
                nudge(&r.kin, i, c, e, 0);
                const double plus = potential(&r);
                nudge(&r.kin, i, c, -2 * e, 0);
                const double minus = potential(&r);
                nudge(&r.kin, i, c, e, 0);
                const double error = fabs(loads[6 * i + c] + (plus - minus) / (2 * e));
                worst[frame] = error > worst[frame] ? error : worst[frame];
            }
        }
        rig_free(&r);
    }
    check_below(worst[0], 1e-8);
    check_above(worst[1], 1e-3);
}

/* A rigid motion of the whole scene leaves the law's components as they are. */
static void objectivity_check(Rig r)
{
    double *before[6], *after[6];
    for (int c = 0; c < 6; ++c) {
        before[c] = chain_array_new(N, 0);
        after[c] = chain_array_new(N, 0);
    }
    bushing_kernels()->law(&r.chain, &r.kin, 0, N + 1, before);
    const Quat turn = quat_exp(v3(0.7, -1.9, 0.4));
    const Vec3 spin = v3(0.3, 2.0, -1.1), drift = v3(5, -3, 2);
    for (int i = -1; i <= N; ++i) {
        const Vec3 p = quat_rotate(turn, vec_load(r.kin.p, i));
        kinematics_turn_to(&r.kin, i, quat_mul(turn, kinematics_quat(&r.kin, i)));
        vec_store(r.kin.v, i, v3_add(quat_rotate(turn, vec_load(r.kin.v, i)), v3_add(drift, v3_cross(spin, p))));
        vec_store(r.kin.w, i, v3_add(quat_rotate(turn, vec_load(r.kin.w, i)), spin));
        vec_store(r.kin.p, i, v3_add(p, drift));
    }
    bushing_kernels()->law(&r.chain, &r.kin, 0, N + 1, after);
    for (int c = 0; c < 6; ++c) {
        for (int j = 0; j <= N; ++j) check_close(after[c][j], before[c][j], 1e-12);
        before[c] = chain_array_free(before[c]);
        after[c] = chain_array_free(after[c]);
    }
    rig_free(&r);
}

TEST(test_objectivity)
{
    objectivity_check(rig_new(FRAME_SYMMETRIC, 0.9, 5));
    objectivity_check(sliding_rig(FRAME_SYMMETRIC, 0.9, 5));
}

/* Pure stretch, twist and bend by hand: the axial, torsional and bending springs of eq. 1 and 2. */
TEST(test_by_hand)
{
    Rig r = rig_new(FRAME_SYMMETRIC, 0, 1);
    double *law[6];
    for (int c = 0; c < 6; ++c) {
        law[c] = chain_array_new(N, 0);
        for (int j = 0; j <= N; ++j) r.chain.preload[c][j] = r.chain.damping[c][j] = 0;
    }
    for (int i = -1; i <= N; ++i) {
        kinematics_turn_to(&r.kin, i, quat_exp(v3(0.2 * i, 0, 0)));
        r.chain.half[i] = 0.25;
        vec_store(r.kin.p, i, v3(0.51 * i, 0, 0));
    }
    r.chain.half[-1] = r.chain.half[N] = 0;
    bushing_kernels()->law(&r.chain, &r.kin, 0, N + 1, law);
    for (int j = 1; j < N; ++j) {
        check_close(law[0][j], 0.01 * r.chain.stiffness[0][j], 1e-14);
        check_close(law[3][j], 0.2 * r.chain.stiffness[3][j], 1e-14);
        for (int c = 1; c < 6; ++c) {
            if (c != 3) check_close(law[c][j], 0, 1e-14);
        }
    }
    kinematics_turn_to(&r.kin, 5, quat_mul(kinematics_quat(&r.kin, 4), quat_exp(v3(0, 2.5, 0))));
    bushing_kernels()->law(&r.chain, &r.kin, 0, N + 1, law);
    check_close(law[4][5], 2.5 * r.chain.stiffness[4][5], 1e-12);
    for (int c = 0; c < 6; ++c) law[c] = chain_array_free(law[c]);
    rig_free(&r);
}

/* Largest difference between two answers over the largest entry. */
static double difference(const double *a, const double *b, int n)
{
    double worst = 0, scale = 0;
    for (int k = 0; k < n; ++k) {
        worst = larger_of(worst, fabs(a[k] - b[k]));
        scale = larger_of(scale, fabs(a[k]));
    }
    return worst / scale;
}

/* Joints without preload, and without damping: what is left out changes nothing but the last digits. */
TEST(test_lacks)
{
    for (int lacks = CHAIN_NO_PRELOAD; lacks < 4; ++lacks) {
        Rig r = rig_new(FRAME_SYMMETRIC, 0.7, 11);
        BlockChain k[2], d[2];
        double loads[2][6 * N];
        for (int c = 0; c < 6; ++c) {
            memset(r.chain.preload[c], 0, (N + 1) * sizeof(double));
            if (lacks & CHAIN_NO_DAMPING) memset(r.chain.damping[c], 0, (N + 1) * sizeof(double));
        }
        for (int way = 0; way < 2; ++way) {
            assert_true(block_chain_alloc(&k[way], N, 6) && block_chain_alloc(&d[way], N, 6));
            segment_loads(&r, loads[way]);
            bushing_blocks(&r.chain, &r.kin, 0, N + 1, &k[way], &d[way]);
            chain_find_lacks(&r.chain);
        }
        assert_int_equal(r.chain.lacks, lacks);
        check_below(difference(loads[0], loads[1], 6 * N), 1e-15);
        check_below(difference(k[0].diag, k[1].diag, 36 * N), 1e-15);
        check_below(difference(k[0].lower, k[1].lower, 36 * N), 1e-15);
        check_below(difference(k[0].upper, k[1].upper, 36 * N), 1e-15);
        for (int e = 0; e < 36 * N; ++e) check_equal(d[0].diag[e], d[1].diag[e]);
        for (int way = 0; way < 2; ++way) {
            block_chain_free(&k[way]);
            block_chain_free(&d[way]);
        }
        rig_free(&r);
    }
}

/* Sliders without stiffness hold nothing and change nothing, in either frame: forces, the law, what joints hold. And
 * without sliders nothing slips. */
TEST(test_idle_sliders)
{
    for (int frame = FRAME_SYMMETRIC; frame <= FRAME_ADAMS; ++frame) {
        Rig plain = rig_new((BushingFrame)frame, 0.7, 23), idle = sliding_rig((BushingFrame)frame, 0.7, 23);
        double loads[2][6 * N], *law[2][6];
        for (int s = 0; s < 3; ++s) chain_array_fill(idle.chain.sliders.stiffness[s], N, 0);
        Rig *const both[] = {&plain, &idle};
        for (int k = 0; k < 2; ++k) {
            assert_true(chain_arrays_new(law[k], 6, N, 0));
            segment_loads(both[k], loads[k]);
            bushing_kernels()->law(&both[k]->chain, &both[k]->kin, 0, N + 1, law[k]);
        }
        check_below(difference(loads[0], loads[1], 6 * N), 1e-14);
        for (int c = 0; c < 6; ++c) check_below(difference(law[0][c], law[1][c], N + 1), 1e-14);
        const JointEnergy without = bushing_kernels()->energy(&plain.chain, &plain.kin, 0, N + 1);
        const JointEnergy with = bushing_kernels()->energy(&idle.chain, &idle.kin, 0, N + 1);
        check_share(with.elastic, without.elastic, 1e-14);
        check_equal(with.sliding, 0);
        check_equal(without.sliding, 0);
        bushing_slip(&plain.chain, &plain.kin, 0, N + 1);
        assert_null(plain.kin.slip[0]);
        for (int k = 0; k < 2; ++k) {
            chain_arrays_free(law[k], 6);
            rig_free(both[k]);
        }
    }
}

/* Moves every body, ghosts too, by dt at its velocities. */
static void drift(Rig *r, double dt)
{
    for (int i = -1; i <= N; ++i) {
        for (int c = 0; c < 3; ++c) r->kin.p[c][i] += dt * r->kin.v[c][i];
        const Quat turn = quat_exp(v3_scale(dt, vec_load(r->kin.w, i)));
        kinematics_turn_to(&r->kin, i, quat_mul(turn, kinematics_quat(&r->kin, i)));
    }
}

/* What the wrenches of joints 0..N do to all bodies, ghosts too, W. */
static double wrench_power(const Rig *r)
{
    double power = 0;
    for (int j = 0; j <= N; ++j) {
        const Vec3 f = vec_load(r->loads.force, j);
        power += v3_dot(f, v3_sub(vec_load(r->kin.v, j - 1), vec_load(r->kin.v, j)));
        power += v3_dot(vec_load(r->loads.torque_a, j), vec_load(r->kin.w, j - 1));
        power += v3_dot(vec_load(r->loads.torque_b, j), vec_load(r->kin.w, j));
    }
    return power;
}

/* What the wrenches take from the bodies is in the springs, or what the damping and the sliders are said to take
 * (BA4), (BA7); sum of both by a quotient over a short way. */
static void power_check(Rig *r)
{
    const double dt = 1e-5;
    const JointPower power = bushing_kernels()->loads(&r->chain, &r->kin, 0, N + 1, &r->loads);
    const double given = wrench_power(r);
    drift(r, dt);
    const double after = bushing_kernels()->energy(&r->chain, &r->kin, 0, N + 1).elastic;
    drift(r, -2 * dt);
    const double before = bushing_kernels()->energy(&r->chain, &r->kin, 0, N + 1).elastic;
    const double taken = (after - before) / (2 * dt) + power.damping + power.sliding;
    print_message("given %.9g, taken %.9g W, damping %.3g, sliding %.3g\n", given, -taken, power.damping,
                  power.sliding);
    check_above(power.damping, 0.1);
    check_close(given, -taken, 1e-9 * (fabs(given) + power.damping));
}

TEST(power_closes)
{
    for (uint64_t seed = 1; seed <= 5; ++seed) {
        Rig plain = rig_new(FRAME_SYMMETRIC, 0.5, seed), sliding = sliding_rig(FRAME_SYMMETRIC, 0.5, seed);
        power_check(&plain);
        power_check(&sliding);
        rig_free(&plain);
        rig_free(&sliding);
    }
}

/* Sliders that all hold are springs: their energy is that of the same stiffness in the joint. */
TEST(sliders_that_hold)
{
    Rig r = rig_new(FRAME_SYMMETRIC, 0.5, 7);
    const double bare = bushing_kernels()->energy(&r.chain, &r.kin, 0, N + 1).elastic;
    assert_true(chain_alloc_sliders(&r.chain, 1) && kinematics_alloc_slips(&r.kin, &r.chain));
    for (int j = 0; j <= N; ++j) {
        r.chain.sliders.stiffness[0][j] = 2.5;
        r.chain.sliders.limit[0][j] = 100;
    }
    const JointEnergy with = bushing_kernels()->energy(&r.chain, &r.kin, 0, N + 1);
    for (int j = 0; j <= N; ++j) {
        r.chain.stiffness[4][j] += 2.5;
        r.chain.stiffness[5][j] += 2.5;
    }
    r.chain.sliders.count = 0;
    const double stiffer = bushing_kernels()->energy(&r.chain, &r.kin, 0, N + 1).elastic;
    check_share(with.elastic, bare, 1e-12);
    check_above(with.sliding, 1e-3);
    check_share(with.elastic + with.sliding, stiffer, 1e-12);
    r.chain.sliders.count = 1;
    rig_free(&r);
}
