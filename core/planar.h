/* A chain that moves in one plane: three degrees of freedom per segment (two coordinates, one angle), and the functions
 * of core/body.h and core/bushing.h in that plane. docs/theory.md, "Planar chain".
 *
 * The state y of n segments is PLANAR_SIZE arrays of `stride`, n rounded up to whole lanes, one after the other: x z
 * phi vx vz omega; m, rad, m/s, rad/s, along the plane's own axes. The entries behind the n-th of each array are zero,
 * and so are their rates, so that no kernel needs a tail. */
#ifndef HAWSER_CORE_PLANAR_H
#define HAWSER_CORE_PLANAR_H

#include "core/chain.h"
#include "core/machine.h"

enum { PLANAR_P = 0, PLANAR_ANGLE = 2, PLANAR_V = 3, PLANAR_W = 5, PLANAR_SIZE = 6 };

/* Data that never change. Arrays as in Chain: valid from -1, padded beyond n. */
typedef struct PlanarChain {
    int n, stride;
    double share; /* weight of the segment after a joint in the angle of its frame (PL4): 1/2 symmetric, 1 adams */
    double *half, *radius;
    double *mass, *inertia;                         /* kg; about the plane's normal, kg m2; 0 beyond the chain */
    double *inverse_mass, *inverse_inertia;         /* 0 beyond the chain */
    double *stiffness[3], *damping[3], *preload[3]; /* per joint: axial, shear and bending in the plane */
} PlanarChain;

typedef struct PlanarKinematics {
    double *p[2];  /* centre, m */
    double *angle; /* rad */
    double *h[2];  /* cosine and sine of half the angle (PL3) */
    double *a[2];  /* axis, unit */
    double *v[2];  /* m/s */
    double *w;     /* rad/s */
} PlanarKinematics;

typedef struct PlanarLoads {
    double *f[2]; /* N, at the segments' centres */
    double *m;    /* N m, about them */
} PlanarLoads;

/* Per joint: force on the segment before it (minus that on the one after), moments about the centres of both. */
typedef struct PlanarJointLoads {
    double *force[2];
    double *torque_a, *torque_b;
} PlanarJointLoads;

/* Derivatives of force and moment by displacement and rotation, or by their rates: 3x3 blocks of a block tridiagonal
 * matrix, entry by entry: [3 column + row] is an array over the segments of the row. lower[e][i]: column i - 1. */
typedef struct PlanarBlocks {
    double *lower[9], *diag[9], *upper[9];
    double *front[9]; /* [joint] contribution of a joint to the diagonal of the segment before it; planar_blocks_join
                       * adds it */
} PlanarBlocks;

/* Allocates everything zeroed, with kinematics along the first axis; 0 if there is no memory (then nothing is
 * allocated). The other structs here are for chain_struct_alloc and chain_struct_free, which frees kinematics too. */
int planar_chain_alloc(PlanarChain *chain, int n);
void planar_chain_free(PlanarChain *chain);
int planar_kinematics_alloc(PlanarKinematics *kin, int n);

/* n rounded up to whole lanes. */
int planar_stride(int n);

/* Zeroes the couplings of the chain of n with its ghosts. */
void planar_blocks_trim(PlanarBlocks *blocks, int n);

/* ------------------------------------------------------------------------------------------------------ kernels */

/* The mechanics (planar_lanes.c), once for every instruction set: planar_kernels()->rates(...). `from` is a multiple of
 * LANES everywhere; entries up to the next multiple after `to` are overwritten. */
typedef struct PlanarKernels {
    /* Unpacks segments from..to-1 of y. Set the head's ghost afterwards. */
    void (*kinematics)(const PlanarChain *chain, const double *y, int from, int to, PlanarKinematics *kin);
    /* Wrenches of joints from..to-1, ghosts included (PL5)-(PL7). Returns the power of the joints' damping, W (BA4). */
    double (*joint_loads)(const PlanarChain *chain, const PlanarKinematics *kin, int from, int to,
                          PlanarJointLoads *loads);
    /* Axial force of joints from..to-1, N. */
    void (*tension)(const PlanarChain *chain, const PlanarKinematics *kin, int from, int to, double *tension);
    /* Rates of y, segments from..to-1 (PL2), from the joints' loads and two sets of other loads. `to` is a multiple of
     * LANES or n; in the latter case the padding gets zeros. Returns 0 if a rate is not finite. */
    int (*rates)(const PlanarChain *chain, const PlanarKinematics *kin, const PlanarJointLoads *joints,
                 const PlanarLoads loads[2], int from, int to, double *ydot);
    /* Writes the derivatives of the wrenches of joints from..to-1 to k and d (PL8)-(PL10): lower, upper and front, and
     * to diag the contributions to the segments after them. Blocks of the ghosts are written too where the arrays have
     * room for them. */
    void (*joint_blocks)(const PlanarChain *chain, const PlanarKinematics *kin, int from, int to, PlanarBlocks *k,
                         PlanarBlocks *d);
    /* Called when all joints are done: adds front to the diagonals of segments from..to-1. */
    void (*blocks_join)(PlanarBlocks *blocks, int from, int to);
} PlanarKernels;

ISA_KERNELS(PlanarKernels, planar_kernels)

#endif
