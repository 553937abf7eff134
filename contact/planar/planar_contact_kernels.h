/* What planar_contact_lanes.c offers to planar_contact.c, once for every instruction set. */
#ifndef HAWSER_CONTACT_PLANAR_PLANAR_CONTACT_KERNELS_H
#define HAWSER_CONTACT_PLANAR_PLANAR_CONTACT_KERNELS_H

#include "contact/planar/planar_contact.h"
#include "core/base/isa.h"
#include "core/base/lanes.h"

/* Up to LANES hits, gathered; the last one is repeated in unused lanes. Bodies [0, 1] are an element's two segments; a
 * missing one is all zeros. Vectors are [component][lane]. */
typedef struct PlanarBatch {
    _Alignas(64) double arc[LANES]; /* weights, as in Element */
    double alpha[LANES], beta[2][2][LANES];
    double x[2][2][LANES];                  /* centre, m */
    double r[2][2][LANES];                  /* from the centre to the front end, m */
    double v[2][2][LANES];                  /* m/s */
    double w[2][LANES];                     /* rad/s */
    double radius[2][LANES];                /* contact radius, m */
    double centre[2][LANES], circle[LANES]; /* of the roller, m */
    const FrictionLaw *friction[LANES];
    const ImpactLaw *impact;
    double friction_scale;
    int count;
    int body[2][LANES];
    int roller[LANES];
} PlanarBatch;

/* What a batch does to its segments. */
typedef struct PlanarPush {
    _Alignas(64) double force[2][2][LANES]; /* N, on the two bodies */
    double moment[2][LANES];                /* N m, about their centres */
    double total[2][LANES];                 /* N, on the cable */
    double normal[LANES];                   /* N */
    double friction[LANES], damping[LANES]; /* W, what they take (BA5) */
    double energy[LANES];                   /* J, in the spring (BA6) */
} PlanarPush;

/* Derivatives of [force moment] of both bodies with respect to [x phi] or [v w] of both: [column][row][lane]. */
typedef struct PlanarContactMatrix {
    _Alignas(64) double entry[6][6][LANES];
} PlanarContactMatrix;

typedef struct PlanarContactKernels {
    /* Elements first..end-1 of a chain of n that own a contact with the roller (C11): into element[], in order; returns
     * how many. */
    int (*owners)(const PlanarRoller *roller, const PlanarKinematics *kin, int n, int first, int end, int *element);
    void (*push)(const PlanarBatch *batch, PlanarPush *out);
    /* returns 0, and writes nothing, if no hit carries force */
    int (*columns)(const PlanarBatch *batch, PlanarContactMatrix *k, PlanarContactMatrix *d, double normal[LANES]);
    double (*moved)(const PlanarChain *chain, const PlanarKinematics *kin, double *const at_p[2],
                    double *const at_a[2]);
} PlanarContactKernels;

extern const PlanarContactKernels planar_contact_kernels_generic, planar_contact_kernels_avx2,
    planar_contact_kernels_avx512;

#endif
