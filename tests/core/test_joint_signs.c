/* Quaternions of either sign are one attitude: wrenches, law, energies, slips and derivatives of joints do not know
 * which of the two a segment has. A slider that is alone slips as one among others does. */
#include <string.h>

#include "core/bushing.h"
#include "tests/support/chain.h"
#include "tests/support/check.h"

enum { N = 19, SLIDERS = 2 };

typedef struct Rig {
    Chain chain;
    Kinematics kin;
    JointLoads loads;
    BlockChain k, d;
    double *law[6];
} Rig;

static Rig rig_new(BushingFrame frame, int sliders, double bend)
{
    Rig r = {0};
    uint64_t seed = 17;
    assert_true(chain_alloc(&r.chain, N) && kinematics_alloc(&r.kin, N) && chain_struct_alloc(&r.loads, N));
    assert_true(block_chain_alloc(&r.k, N, 6) && block_chain_alloc(&r.d, N, 6) && chain_arrays_new(r.law, 6, N, 0));
    r.chain.frame = frame;
    fixture_chain(&r.chain, &seed);
    fixture_state(&r.chain, &r.kin, bend, 0.05, &seed);
    if (sliders) assert_true(chain_alloc_sliders(&r.chain, sliders) && kinematics_alloc_slips(&r.kin, &r.chain));
    for (int s = 0; s < sliders; ++s) {
        for (int j = 0; j <= N; ++j) {
            r.chain.sliders.stiffness[s][j] = 2 + s + 0.1 * j;
            r.chain.sliders.limit[s][j] = bend * (0.3 + 0.05 * j + 0.4 * s);
        }
    }
    return r;
}

static void rig_free(Rig *r)
{
    chain_free(&r->chain);
    kinematics_free(&r->kin);
    chain_struct_free(&r->loads);
    block_chain_free(&r->k);
    block_chain_free(&r->d);
    chain_arrays_free(r->law, 6);
}

static JointPower evaluate(Rig *r)
{
    block_chain_zero(&r->k);
    block_chain_zero(&r->d);
    bushing_blocks(&r->chain, &r->kin, 0, N + 1, &r->k, &r->d);
    bushing_kernels()->law(&r->chain, &r->kin, 0, N + 1, r->law);
    return bushing_kernels()->loads(&r->chain, &r->kin, 0, N + 1, &r->loads);
}

/* The largest difference of two chains' joints, over all that is computed of them. */
static double difference(const Rig *a, const Rig *b)
{
    double most = 0;
    for (int j = 0; j <= N; ++j) {
        most = larger_of(most, v3_norm(v3_sub(v3_load(a->loads.force, j), v3_load(b->loads.force, j))));
        most = larger_of(most, v3_norm(v3_sub(v3_load(a->loads.torque_a, j), v3_load(b->loads.torque_a, j))));
        most = larger_of(most, v3_norm(v3_sub(v3_load(a->loads.torque_b, j), v3_load(b->loads.torque_b, j))));
        for (int c = 0; c < 6; ++c) most = larger_of(most, fabs(a->law[c][j] - b->law[c][j]));
        for (int c = 0; c < 2 * a->chain.sliders.count; ++c)
            most = larger_of(most, fabs(a->kin.slip[c][j] - b->kin.slip[c][j]));
    }
    for (int e = 0; e < 36 * N; ++e) {
        most = larger_of(most, fabs(a->k.diag[e] - b->k.diag[e]));
        most = larger_of(most, fabs(a->d.diag[e] - b->d.diag[e]));
    }
    return most;
}

TEST(signs_of_quaternions)
{
    for (int scene = 0; scene < 8; ++scene) {
        const BushingFrame frame = scene & 1 ? FRAME_SYMMETRIC : FRAME_ADAMS;
        const int sliders = scene & 2 ? SLIDERS : 0;
        const double bend = scene & 4 ? 0.9 : 0.05;
        Rig a = rig_new(frame, sliders, bend), b = rig_new(frame, sliders, bend);
        for (int i = -1; i <= N; ++i) {
            if ((i + 3) % 3 == 0) continue;
            for (int c = 0; c < 4; ++c) b.kin.q[c][i] *= -1;
        }
        const JointPower power = evaluate(&a), other = evaluate(&b);
        check_close(difference(&a, &b), 0, 1e-10);
        check_close(power.damping, other.damping, 1e-11 * fabs(power.damping));
        check_close(power.sliding, other.sliding, 1e-11 * fabs(power.damping));
        const JointEnergy energy = bushing_kernels()->energy(&a.chain, &a.kin, 0, N + 1),
                          same = bushing_kernels()->energy(&b.chain, &b.kin, 0, N + 1);
        check_close(energy.elastic, same.elastic, 1e-12 * fabs(energy.elastic));
        check_close(energy.sliding, same.sliding, 1e-12 * fabs(energy.elastic));
        bushing_slip(&a.chain, &a.kin, 0, N + 1);
        bushing_slip(&b.chain, &b.kin, 0, N + 1);
        check_close(difference(&a, &b), 0, 1e-10);
        rig_free(&a);
        rig_free(&b);
    }
}

/* One slider a joint: beyond its limit it follows, so that its spring is at its limit, in either frame. */
TEST(one_slider_alone)
{
    for (int k = 0; k < 2; ++k) {
        Rig r = rig_new(k ? FRAME_SYMMETRIC : FRAME_ADAMS, 1, 0.4);
        evaluate(&r);
        double bare[2][N + 1];
        for (int c = 0; c < 2; ++c) memcpy(bare[c], r.law[4 + c], sizeof bare[c]);
        for (int j = 0; j <= N; ++j) r.chain.sliders.stiffness[0][j] = 0;
        evaluate(&r);
        for (int j = 0; j <= N; ++j) { /* what the slider adds, before it has slipped */
            const double stiffness = 2 + 0.1 * j, y = bare[0][j] - r.law[4][j], z = bare[1][j] - r.law[5][j];
            check_at_most(hypot(y, z) / stiffness, r.chain.sliders.limit[0][j] * (1 + 1e-12));
        }
        bushing_slip(&r.chain, &r.kin, 0, N + 1);
        int slipped = 0;
        for (int j = 0; j <= N; ++j) {
            const double stiffness = 2 + 0.1 * j, limit = r.chain.sliders.limit[0][j];
            const double y = (bare[0][j] - r.law[4][j]) / stiffness, z = (bare[1][j] - r.law[5][j]) / stiffness;
            const double slip_y = r.kin.slip[0][j], slip_z = r.kin.slip[1][j], slip = hypot(slip_y, slip_z);
            if (hypot(y, z) < limit * (1 - 1e-9)) {
                check_equal(slip, 0);
                continue;
            }
            check_above(slip, 0);
            check_close(slip_y * z - slip_z * y, 0, 1e-12); /* where the spring points */
            check_above(slip_y * y + slip_z * z, 0);
            slipped++;
        }
        check_between(slipped, 3, N + 1);
        rig_free(&r);
    }
}
