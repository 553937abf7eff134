/* The segments as rigid bodies: unpacking the state, the rates against a plain evaluation of their formulas, and the
 * inertia's derivatives against finite differences; chains that do and do not fill the last vector. */
#include <stdlib.h>
#include <string.h>

#include "core/body.h"
#include "core/lanes.h"
#include "tests/support/chain.h"
#include "tests/support/check.h"

static const int SIZES[] = {1, 2, 7, 8, 9, 370};
enum { N_SIZES = sizeof SIZES / sizeof *SIZES };

typedef struct Rig {
    int n;
    Chain chain;
    Kinematics kin;
    JointLoads joints;
    Loads loads[2];
    double *y, *ydot; /* [13 n] */
    uint64_t seed;
} Rig;

/* Random bodies, loads and state; quaternions of length 1 +- 0.2. */
static Rig rig_new(int n)
{
    Rig r = {.n = n, .seed = 17 + (uint64_t)n};
    assert_true(chain_alloc(&r.chain, n) && kinematics_alloc(&r.kin, n));
    assert_true(chain_struct_alloc(&r.joints, n) && chain_struct_alloc(&r.loads[0], n) &&
                chain_struct_alloc(&r.loads[1], n));
    r.y = malloc((size_t)(STATE_SIZE * n) * sizeof(double));
    r.ydot = malloc((size_t)(STATE_SIZE * n) * sizeof(double));
    assert_true(r.y && r.ydot);
    fixture_chain(&r.chain, &r.seed);
    for (int i = 0; i < STATE_SIZE * n; ++i) r.y[i] = fixture_random(&r.seed);
    for (int i = 0; i < n; ++i) {
        double *const q = r.y + STATE_Q * n + i;
        const Quat unit = quat_unit((Quat){q[0], q[n], q[2 * n], q[3 * n]});
        const double length = 1 + 0.2 * fixture_random(&r.seed);
        const double value[4] = {unit.w, unit.x, unit.y, unit.z};
        for (int c = 0; c < 4; ++c) q[c * n] = length * value[c];
        for (int k = 0; k < 2; ++k) {
            vec_store(r.loads[k].f, i, fixture_vector(&r.seed, 1));
            vec_store(r.loads[k].m, i, fixture_vector(&r.seed, 1));
        }
    }
    for (int j = 0; j <= n; ++j) {
        vec_store(r.joints.force, j, fixture_vector(&r.seed, 1));
        vec_store(r.joints.torque_a, j, fixture_vector(&r.seed, 1));
        vec_store(r.joints.torque_b, j, fixture_vector(&r.seed, 1));
    }
    return r;
}

static void rig_free(Rig *r)
{
    chain_free(&r->chain);
    kinematics_free(&r->kin);
    chain_struct_free(&r->joints);
    for (int k = 0; k < 2; ++k) chain_struct_free(&r->loads[k]);
    free(r->y);
    free(r->ydot);
}

static Vec3 part(const double *y, int n, int at, int i)
{
    return v3(y[at * n + i], y[(at + 1) * n + i], y[(at + 2) * n + i]);
}
static Quat turn_of(const double *y, int n, int i)
{
    return (Quat){y[3 * n + i], y[4 * n + i], y[5 * n + i], y[6 * n + i]};
}

static double apart(Vec3 a, Vec3 b) { return v3_norm(v3_sub(a, b)); }
static double quat_apart(Quat a, Quat b)
{
    return fabs(a.w - b.w) + fabs(a.x - b.x) + fabs(a.y - b.y) + fabs(a.z - b.z);
}

/* Everything is unpacked; quaternions have unit length and the axis is R e_x; the ghost at the tail stays as it is. */
TEST(test_kinematics)
{
    for (int k = 0; k < N_SIZES; ++k) {
        Rig r = rig_new(SIZES[k]);
        vec_store(r.kin.p, -1, v3(5, 6, 7));
        body_kernels()->kinematics(r.n, r.y, 0, r.n, &r.kin);
        for (int i = 0; i < r.n; ++i) {
            const Quat q = quat_unit(turn_of(r.y, r.n, i));
            check_below(quat_apart(kinematics_quat(&r.kin, i), q), 1e-15);
            check_below(apart(vec_load(r.kin.a, i), quat_rotate(q, v3(1, 0, 0))), 1e-14);
            check_at_most(apart(vec_load(r.kin.p, i), part(r.y, r.n, STATE_P, i)), 0);
            check_at_most(apart(vec_load(r.kin.v, i), part(r.y, r.n, STATE_V, i)), 0);
            check_at_most(apart(vec_load(r.kin.w, i), part(r.y, r.n, STATE_W, i)), 0);
        }
        check_at_most(apart(vec_load(r.kin.p, -1), v3(5, 6, 7)), 0);
        rig_free(&r);
    }
}

/* A part of the segments may be asked for; it comes out bitwise as the whole, and no other segment is touched. */
TEST(test_parts)
{
    enum { N = 30, MID = 2 * LANES };
    Rig r = rig_new(N);
    double whole[STATE_SIZE * N];
    body_kernels()->kinematics(N, r.y, 0, N, &r.kin);
    body_kernels()->rates(&r.chain, &r.kin, &r.joints, r.loads, r.y, 0, N, whole);
    memset(r.ydot, 0, sizeof whole);
    body_kernels()->rates(&r.chain, &r.kin, &r.joints, r.loads, r.y, MID, N, r.ydot);
    for (int c = 0; c < STATE_SIZE; ++c) {
        for (int i = 0; i < MID; ++i) check_equal(r.ydot[c * N + i], 0);
    }
    body_kernels()->rates(&r.chain, &r.kin, &r.joints, r.loads, r.y, 0, MID, r.ydot);
    assert_memory_equal(r.ydot, whole, sizeof whole);
    vec_store(r.kin.p, 3, v3(1, 2, 3));
    body_kernels()->kinematics(N, r.y, MID, N, &r.kin);
    check_at_most(apart(vec_load(r.kin.p, 3), v3(1, 2, 3)), 0);
    rig_free(&r);
}

/* (S1)-(S3), one segment at a time, in the world: I = R diag(J) R^T by its columns, solved by R diag(1/J) R^T. */
static void check_segment(const Rig *r, int i)
{
    const int n = r->n;
    const Quat raw = turn_of(r->y, n, i), q = quat_unit(raw);
    const Vec3 w = part(r->y, n, STATE_W, i);
    const Vec3 pull = v3_sub(vec_load(r->joints.force, i + 1), vec_load(r->joints.force, i));
    const Vec3 turn = v3_add(vec_load(r->joints.torque_a, i + 1), vec_load(r->joints.torque_b, i));
    const Vec3 force = v3_add(pull, v3_add(vec_load(r->loads[0].f, i), vec_load(r->loads[1].f, i)));
    const Vec3 torque = v3_add(turn, v3_add(vec_load(r->loads[0].m, i), vec_load(r->loads[1].m, i)));
    const Vec3 axis[3] = {quat_rotate(q, v3(1, 0, 0)), quat_rotate(q, v3(0, 1, 0)), quat_rotate(q, v3(0, 0, 1))};
    Vec3 momentum = v3(0, 0, 0), spin = v3(0, 0, 0);
    for (int c = 0; c < 3; ++c) momentum = v3_axpy(momentum, r->chain.inertia[c][i] * v3_dot(axis[c], w), axis[c]);
    const Vec3 free_torque = v3_sub(torque, v3_cross(w, momentum));
    for (int c = 0; c < 3; ++c) spin = v3_axpy(spin, v3_dot(axis[c], free_torque) / r->chain.inertia[c][i], axis[c]);

    const Quat rate = quat_mul((Quat){0, w.x / 2, w.y / 2, w.z / 2}, raw);
    check_at_most(apart(part(r->ydot, n, STATE_P, i), part(r->y, n, STATE_V, i)), 0);
    check_below(quat_apart(turn_of(r->ydot, n, i), rate), 1e-15);
    check_below(apart(part(r->ydot, n, STATE_V, i), v3_scale(1 / r->chain.mass[i], force)), 1e-14);
    check_below(apart(part(r->ydot, n, STATE_W, i), spin), 1e-13 * (1 + v3_norm(spin)));
}

TEST(test_rates)
{
    for (int k = 0; k < N_SIZES; ++k) {
        Rig r = rig_new(SIZES[k]);
        body_kernels()->kinematics(r.n, r.y, 0, r.n, &r.kin);
        body_kernels()->rates(&r.chain, &r.kin, &r.joints, r.loads, r.y, 0, r.n, r.ydot);
        for (int i = 0; i < r.n; ++i) check_segment(&r, i);
        rig_free(&r);
    }
}

/* Without moments Euler's equation keeps energy and angular momentum: w . I w' = 0 and I w' + w x I w = 0. */
TEST(test_gyroscopic)
{
    Rig r = rig_new(9);
    for (int j = 0; j <= r.n; ++j) {
        vec_store(r.joints.torque_a, j, v3(0, 0, 0));
        vec_store(r.joints.torque_b, j, v3(0, 0, 0));
    }
    for (int i = 0; i < r.n; ++i) vec_store(r.loads[0].m, i, v3(0, 0, 0));
    for (int i = 0; i < r.n; ++i) vec_store(r.loads[1].m, i, v3(0, 0, 0));
    body_kernels()->kinematics(r.n, r.y, 0, r.n, &r.kin);
    body_kernels()->rates(&r.chain, &r.kin, &r.joints, r.loads, r.y, 0, r.n, r.ydot);
    for (int i = 0; i < r.n; ++i) {
        const Vec3 w = part(r.y, r.n, STATE_W, i);
        const Vec3 change = body_inertia_times(&r.chain, &r.kin, i, part(r.ydot, r.n, STATE_W, i));
        const Vec3 momentum = body_inertia_times(&r.chain, &r.kin, i, w);
        check_close(v3_dot(w, change), 0, 1e-15);
        check_below(v3_norm(v3_add(change, v3_cross(w, momentum))), 1e-15);
    }
    rig_free(&r);
}

/* What (S4) differentiates: -(w x I w) - I w' with w' = spin held fast, at segment i turned and sped up a little. */
static Vec3 inertial_moment(const Rig *r, int i, Vec3 turn, Vec3 faster, Vec3 spin)
{
    Kinematics kin;
    assert_true(kinematics_alloc(&kin, r->n));
    kinematics_turn_to(&kin, i, quat_mul(quat_exp(turn), kinematics_quat(&r->kin, i)));
    const Vec3 w = v3_add(vec_load(r->kin.w, i), faster);
    const Vec3 gyro = v3_cross(w, body_inertia_times(&r->chain, &kin, i, w));
    const Vec3 moment = v3_scale(-1, v3_add(gyro, body_inertia_times(&r->chain, &kin, i, spin)));
    kinematics_free(&kin);
    return moment;
}

/* Largest difference between column 3 + c of a segment's block and the central difference. */
static double column_error(const Rig *r, const BlockChain *a, int i, int c, int of_spin)
{
    const double e = 1e-4;
    const Vec3 nothing = v3(0, 0, 0), by = v3(c == 0 ? e : 0, c == 1 ? e : 0, c == 2 ? e : 0);
    const Vec3 back = v3_scale(-1, by), spin = part(r->ydot, r->n, STATE_W, i);
    const Vec3 plus = inertial_moment(r, i, of_spin ? nothing : by, of_spin ? by : nothing, spin);
    const Vec3 minus = inertial_moment(r, i, of_spin ? nothing : back, of_spin ? back : nothing, spin);
    const double *const block = a->diag + 36 * i + 6 * (3 + c);
    return apart(v3_scale(1 / (2 * e), v3_sub(plus, minus)), v3(block[3], block[4], block[5]));
}

TEST(test_blocks)
{
    Rig r = rig_new(9);
    BlockChain k, d;
    assert_true(block_chain_alloc(&k, r.n, 6) && block_chain_alloc(&d, r.n, 6));
    body_kernels()->kinematics(r.n, r.y, 0, r.n, &r.kin);
    body_kernels()->rates(&r.chain, &r.kin, &r.joints, r.loads, r.y, 0, r.n, r.ydot);
    body_blocks(&r.chain, &r.kin, r.ydot, 0, r.n, &k, &d);
    for (int i = 0; i < r.n; ++i) {
        for (int c = 0; c < 3; ++c) {
            check_below(column_error(&r, &k, i, c, 0), 3e-8);
            check_below(column_error(&r, &d, i, c, 1), 1e-10);
        }
        /* forces and positions have no part in it */
        for (int e = 0; e < 36; ++e) {
            if (e < 18 || e % 6 < 3) check_at_most(fabs(k.diag[36 * i + e]) + fabs(d.diag[36 * i + e]), 0);
        }
    }
    block_chain_free(&k);
    block_chain_free(&d);
    rig_free(&r);
}

/* (BA11), one segment at a time: half the work of both ends' inertial forces along the way and the turn, less the gain
 * of motion. Two steps, so that the second finds what the first has left. */
TEST(test_method_loss)
{
    enum { PAST = BODY_PAST };
    const double scale = 3.7;
    for (int k = 0; k < N_SIZES; ++k) {
        Rig r = rig_new(SIZES[k]), before = rig_new(SIZES[k]);
        const int n = r.n, stride = (n + LANES - 1) / LANES * LANES;
        double *const past = calloc((size_t)(PAST * stride), sizeof *past), lost = 0, moving = 0;
        double *const rate[2] = {before.ydot, r.ydot};
        for (int i = 0; i < STATE_SIZE * n; ++i) {
            before.y[i] += 0.1 * fixture_random(&r.seed);
            rate[0][i] = fixture_random(&r.seed) / scale;
            rate[1][i] = fixture_random(&r.seed) / scale;
        }
        double *const y[2] = {before.y, r.y};
        for (int i = 0; i < n; ++i) { /* as the integrator has them: of length 1 */
            for (int e = 0; e < 2; ++e) {
                const Quat unit = quat_unit(turn_of(y[e], n, i));
                const double q[4] = {unit.w, unit.x, unit.y, unit.z};
                for (int c = 0; c < 4; ++c) y[e][(STATE_Q + c) * n + i] = q[c];
            }
        }
        for (int i = 0; i < n; ++i) {
            const Vec3 J = v3(r.chain.inertia[0][i], r.chain.inertia[1][i], r.chain.inertia[2][i]);
            Vec3 force[2], moment[2], w[2], v[2];
            double energy[2];
            for (int e = 0; e < 2; ++e) {
                const Quat back = quat_conj(turn_of(y[e], n, i));
                w[e] = quat_rotate(back, part(y[e], n, STATE_W, i));
                v[e] = part(y[e], n, STATE_V, i);
                const Vec3 spin = v3(J.x * w[e].x, J.y * w[e].y, J.z * w[e].z);
                const Vec3 dw = v3_scale(scale, quat_rotate(back, part(rate[e], n, STATE_W, i)));
                force[e] = v3_scale(r.chain.mass[i] * scale, part(rate[e], n, STATE_V, i));
                moment[e] = v3_add(v3_cross(w[e], spin), v3(J.x * dw.x, J.y * dw.y, J.z * dw.z));
                energy[e] = (r.chain.mass[i] * v3_dot(v[e], v[e]) + v3_dot(w[e], spin)) / 2;
            }
            const Vec3 way = v3_sub(part(y[1], n, STATE_P, i), part(y[0], n, STATE_P, i));
            const Quat turned = quat_mul(quat_conj(turn_of(y[0], n, i)), turn_of(y[1], n, i));
            const Vec3 turn = v3_scale(2, v3(turned.x, turned.y, turned.z));
            lost += (v3_dot(v3_add(force[0], force[1]), way) + v3_dot(v3_add(moment[0], moment[1]), turn)) / 2;
            lost -= energy[1] - energy[0];
            moving += energy[1];
        }
        body_kernels()->method_loss(&r.chain, y[0], rate[0], scale, 0, n, past);
        double *const again = malloc((size_t)(PAST * stride) * sizeof *again);
        memcpy(again, past, (size_t)(PAST * stride) * sizeof *again);
        const MethodLoss all = body_kernels()->method_loss(&r.chain, y[1], rate[1], scale, 0, n, past);
        check_close(all.lost, lost, 1e-12 * n);
        check_close(all.moving, moving, 1e-12 * n);
        if (n > LANES) { /* in two parts, and the same is left behind */
            MethodLoss sum = body_kernels()->method_loss(&r.chain, y[1], rate[1], scale, 0, LANES, again);
            const MethodLoss rest = body_kernels()->method_loss(&r.chain, y[1], rate[1], scale, LANES, n, again);
            check_close(sum.lost + rest.lost, lost, 1e-12 * n);
            check_close(sum.moving + rest.moving, moving, 1e-12 * n);
            for (int c = 0; c < PAST; ++c) assert_memory_equal(again + c * stride, past + c * stride, (size_t)n * 8);
        }
        /* nothing has moved since */
        check_close(body_kernels()->method_loss(&r.chain, y[1], rate[1], scale, 0, n, past).lost, 0, 1e-13 * n);
        free(again);
        free(past);
        rig_free(&before);
        rig_free(&r);
    }
}
