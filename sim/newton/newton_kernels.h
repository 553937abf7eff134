/* The loops of newton.c over segments, once for every instruction set. */
#ifndef HAWSER_SIM_NEWTON_NEWTON_KERNELS_H
#define HAWSER_SIM_NEWTON_NEWTON_KERNELS_H

#include "core/base/isa.h"
#include "sim/newton/newton_data.h"

typedef struct NewtonKernels {
    /* For segments from..to-1 of b [13 n]: z = gamma (b_x, phi_b) (N6) and x = M b_u, both [6n]. */
    void (*eliminate)(Newton *nw, const double *b, int from, int to);
    /* x += K z, rows from..to-1 (N7). */
    void (*couple)(Newton *nw, int from, int to);
    /* b from the velocities in x, segments from..to-1 (N8). */
    void (*expand)(const Newton *nw, double *b, int from, int to);
    /* Block columns from..to-1 of A (N5). */
    void (*form)(Newton *nw, int from, int to);
} NewtonKernels;

extern const NewtonKernels newton_kernels_generic, newton_kernels_avx2, newton_kernels_avx512;

#endif
