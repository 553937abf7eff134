/* Loops over segments of the planar chain's motion, once for every instruction set. */
#ifndef HAWSER_SIM_PLANAR_PLANAR_KERNELS_H
#define HAWSER_SIM_PLANAR_PLANAR_KERNELS_H

#include "core/base/isa.h"
#include "core/planar/planar.h"
#include "linsolve/linsolve.h"
#include "sim/planar/planar_scene_data.h"

/* The planar chain's Newton matrix (PL15). */
typedef struct PlanarNewton {
    const PlanarChain *chain; /* borrowed */
    int middle;               /* segments before it are the first half; a multiple of LANES */
    PlanarBlocks k, d;        /* at the linearisation point */
    BlockChain a;             /* M - gamma D - gamma^2 K */
    double *z[3];             /* gamma times the positions' residuals; chain arrays */
    double *x;                /* [3 stride] reduced right-hand side and solution, row by row */
    double gamma;             /* s, of a */
    LinSolver *solver;
    Team *team; /* borrowed; NULL: one thread */
} PlanarNewton;

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
