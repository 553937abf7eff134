/* The data of a planar chain, shared by planar.c and its kernels. docs/model.md, "Planar chain".
 *
 * The state y of n segments is PLANAR_SIZE arrays of `stride`, n filled up to whole lanes, one after the other:
 * x z phi vx vz omega; m, rad, m/s, rad/s, along the plane's own axes. The entries behind the n-th of each array are
 * zero, and so are their rates, so that no kernel needs a tail. */
#ifndef HAWSER_CORE_PLANAR_PLANAR_DATA_H
#define HAWSER_CORE_PLANAR_PLANAR_DATA_H

#include "core/chain.h"

enum { PLANAR_P = 0, PLANAR_ANGLE = 2, PLANAR_V = 3, PLANAR_W = 5, PLANAR_SIZE = 6 };

/* What never changes. Arrays as in Chain: valid from -1, padded beyond n. */
typedef struct PlanarChain {
    int n, stride;
    double share; /* of the segment after a joint in the angle of its frame (PL4): 1/2 symmetric, 1 adams */
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

/* Derivatives of force and moment by displacement and turn, or by their rates: 3x3 blocks of a block tridiagonal
 * matrix, entry by entry: [3 column + row] is an array over the segments of the row. lower[e][i]: column i - 1. */
typedef struct PlanarBlocks {
    double *lower[9], *diag[9], *upper[9];
    double
        *front[9]; /* [joint] what a joint gives to the diagonal of the segment before it; planar_blocks_join adds it */
} PlanarBlocks;

#endif
