/* The Newton matrix's blocks from those of stiffness and damping, for the chain, the equipment, and the plane.
 * docs/theory.md, "Newton matrix", (N4), (N5). */
#ifndef HAWSER_SIM_SOLVE_FORM_LANES_H
#define HAWSER_SIM_SOLVE_FORM_LANES_H

#include "core/lanes.h"

/* -gamma D - gamma^2 K S, LANES entries at once; ks: those of K S. */
LANE_INLINE Lane newton_entry(double gamma, Lane d, Lane ks) { return -gamma * d - gamma * gamma * ks; }

/* One block, see NewtonKernels.block. A column is read as a lane whose last entries belong to the following memory and
 * are never stored. */
LANE_INLINE void block_form(int rows, int positions, int cols, const double *k, const double *d, const double s[9],
                            double gamma, double *out)
{
    const size_t bytes = (size_t)rows * sizeof(double);
    for (int c = 0; c < 3 && positions; ++c) { /* columns of displacements, then of rotations */
        const Lane shift = newton_entry(gamma, lane_load(d + rows * c), lane_load(k + rows * c));
        memcpy(out + rows * c, &shift, bytes);
    }
    for (int c = 0; c < 3 && positions; ++c) {
        const Lane turned = lane_load(k + 3 * rows) * lane_set(s[c]) + lane_load(k + 4 * rows) * lane_set(s[3 + c]) +
                            lane_load(k + 5 * rows) * lane_set(s[6 + c]);
        const Lane turn = newton_entry(gamma, lane_load(d + rows * (3 + c)), turned);
        memcpy(out + rows * (3 + c), &turn, bytes);
    }
    for (int c = positions; c < cols; ++c) { /* a spin has no position */
        const Lane spin = -gamma * lane_load(d + rows * c);
        memcpy(out + rows * c, &spin, bytes);
    }
}

#endif
