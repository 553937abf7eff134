/* Loops over segments of the planar chain's motion, once for every instruction set. */
#ifndef HAWSER_SIM_PLANAR_PLANAR_KERNELS_H
#define HAWSER_SIM_PLANAR_PLANAR_KERNELS_H

#include "core/base/isa.h"
#include "sim/planar/planar_newton.h"
#include "sim/planar/planar_scene_data.h"

/* What the lead-in does to the motion: W, and N along the plane's axes. */
typedef struct PlanarPower {
    double power, force[2];
} PlanarPower;

typedef struct PlanarSimKernels {
    /* planar_weight */
    PlanarPower (*weight)(const PlanarWeight *weight, const PlanarChain *chain, const PlanarKinematics *kin, int from,
                          int to, PlanarLoads *loads);
    /* z = gamma b_x of segments from..to-1; from is a multiple of LANES, as below */
    void (*eliminate)(PlanarNewton *nw, const double *b, int from, int to);
    /* x = M b_u + K z, rows from..to-1 and what fills their last lane */
    void (*couple)(PlanarNewton *nw, const double *b, int from, int to);
    /* b from the velocities in x, segments from..to-1 */
    void (*expand)(const PlanarNewton *nw, double *b, int from, int to);
    /* Block rows from..to-1 of A. */
    void (*form)(PlanarNewton *nw, int from, int to);
    /* Largest over the windows of 16 segments in from..to-1 (from: a window's first) of the sum of (x w)^2 over the
     * window's six entries each, divided by 13 times the window's segments (PL18); w is one number an array, of which
     * the first is read. A NaN in x gives a NaN. */
    double (*window_square)(const PlanarChain *chain, int from, int to, const double *x, const double *w);
    /* Kinematics in space of all segments and the head's ghost (PL17). */
    void (*lift)(const Plane *plane, const PlanarChain *chain, const PlanarKinematics *from, Kinematics *to);
} PlanarSimKernels;

extern const PlanarSimKernels planar_sim_kernels_generic, planar_sim_kernels_avx2, planar_sim_kernels_avx512;

#endif
