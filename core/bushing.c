#include "core/bushing.h"

#include <stddef.h>
#include <string.h>

void bushing_slip(const Chain *chain, Kinematics *kin, int from, int to)
{
    if (chain->sliders.count > 0) bushing_kernels()->slip(chain, kin, from, to);
}

/* block += sign * the 3x3 part of m at (row part r, column part c), placed at (3 * into_r, 3 * into_c). */
static void part_add(double *block, const JointMatrix *m, int lane, int r, int c, int into_r, int into_c, double sign)
{
    for (int col = 0; col < 3; ++col) {
        for (int row = 0; row < 3; ++row) {
            block[6 * (3 * into_c + col) + 3 * into_r + row] += sign * m->entry[3 * c + col][3 * r + row][lane];
        }
    }
}

enum { FORCE, TORQUE_A, TORQUE_B }; /* row parts of a JointMatrix */
enum { SHIFT, TURN_A, TURN_B };     /* column parts */

/* The four 6x6 blocks of one joint: A gets +force and torque_a, B gets -force and torque_b; a displacement of A shifts
 * B backwards relative to it. Ghost rows and columns are dropped. */
static void joint_blocks_add(BlockChain *out, const JointMatrix *m, int lane, int joint)
{
    const int a = joint - 1, b = joint;
    const int has_a = a >= 0, has_b = b < out->n;
    double *const aa = has_a ? out->diag + 36 * a : NULL;
    double *const bb = has_b ? out->diag + 36 * b : NULL;
    if (has_a) {
        part_add(aa, m, lane, FORCE, SHIFT, 0, 0, -1);
        part_add(aa, m, lane, FORCE, TURN_A, 0, 1, 1);
        part_add(aa, m, lane, TORQUE_A, SHIFT, 1, 0, -1);
        part_add(aa, m, lane, TORQUE_A, TURN_A, 1, 1, 1);
    }
    if (has_b) {
        part_add(bb, m, lane, FORCE, SHIFT, 0, 0, -1);
        part_add(bb, m, lane, FORCE, TURN_B, 0, 1, -1);
        part_add(bb, m, lane, TORQUE_B, SHIFT, 1, 0, 1);
        part_add(bb, m, lane, TORQUE_B, TURN_B, 1, 1, 1);
    }
    if (has_a && has_b) {
        double *const ab = out->upper + 36 * a, *const ba = out->lower + 36 * b;
        part_add(ab, m, lane, FORCE, SHIFT, 0, 0, 1);
        part_add(ab, m, lane, FORCE, TURN_B, 0, 1, 1);
        part_add(ab, m, lane, TORQUE_A, SHIFT, 1, 0, 1);
        part_add(ab, m, lane, TORQUE_A, TURN_B, 1, 1, 1);
        part_add(ba, m, lane, FORCE, SHIFT, 0, 0, 1);
        part_add(ba, m, lane, FORCE, TURN_A, 0, 1, -1);
        part_add(ba, m, lane, TORQUE_B, SHIFT, 1, 0, -1);
        part_add(ba, m, lane, TORQUE_B, TURN_A, 1, 1, 1);
    }
}

void bushing_blocks(const Chain *chain, const Kinematics *kin, int from, int to, BlockChain *k, BlockChain *d)
{
    const BushingKernels *const kernel = bushing_kernels();
    JointMatrix mk, md;
    for (int jj = from; jj < to; jj += LANES) {
        kernel->columns(chain, kin, jj, &mk, &md);
        for (int lane = 0; lane < LANES && jj + lane < to; ++lane) {
            joint_blocks_add(k, &mk, lane, jj + lane);
            if (!(chain->lacks & CHAIN_NO_DAMPING)) joint_blocks_add(d, &md, lane, jj + lane);
        }
    }
}
