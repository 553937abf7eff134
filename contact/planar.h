/* Contact of a chain that moves in a plane with fixed rollers whose axes are normal to it: circles. The same line,
 * ownership of contacts and laws as in contact/roller.h, so that the forces are those in space. docs/theory.md, "Planar
 * chain".
 *
 * The candidates are those that contact_refresh found in space. */
#ifndef HAWSER_CONTACT_PLANAR_H
#define HAWSER_CONTACT_PLANAR_H

#include "contact/roller.h"
#include "core/lanes.h"
#include "core/machine.h"
#include "core/planar.h"

typedef struct PlanarRoller {
    double centre[2]; /* m, in the plane */
    double radius;    /* m */
    FrictionLaw friction;
} PlanarRoller;

/* Data that never change during a run. */
typedef struct PlanarContactModel {
    ContactGeometry geometry;
    ImpactLaw impact;
    int n_rollers;
    const PlanarRoller *roller; /* [n_rollers], borrowed */
} PlanarContactModel;

/* Adds forces (N) and moments (N m) on the segments to loads; pairs holds the candidates. friction_scale multiplies
 * every friction coefficient. on_roller[n_rollers] (NULL: not required) is overwritten by the force on each roller,
 * N. */
void planar_contact_forces(const PlanarContactModel *model, const PlanarChain *chain, const PlanarKinematics *kin,
                           double friction_scale, ContactPairs *pairs, PlanarLoads *loads, double (*on_roller)[2]);

/* Keeps those candidates that are within `reach` (m) of their roller as `near`, which the forces use: (C19) with the
 * spheres (C18). Of a roller's ranges the part between its first and its last near element. Capsules are all kept. */
void planar_contact_narrow(const PlanarContactModel *model, const PlanarChain *chain, const PlanarKinematics *kin,
                           double reach, ContactPairs *pairs);

/* Adds the derivatives of [force; moment] by [dx; dphi] to k and by [dv; dw] to d (PL13). */
void planar_contact_blocks(const PlanarContactModel *model, const PlanarChain *chain, const PlanarKinematics *kin,
                           double friction_scale, ContactPairs *pairs, PlanarBlocks *k, PlanarBlocks *d);

/* ------------------------------------------------------------------------------------------------------ kernels */

/* The kernels of contact/planar_lanes.c, once for every instruction set. */
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

/* Loads of a batch on its segments. */
typedef struct PlanarPush {
    _Alignas(64) double force[2][2][LANES]; /* N, on the two bodies */
    double moment[2][LANES];                /* N m, about their centres */
    double total[2][LANES];                 /* N, on the cable */
    double normal[LANES];                   /* N */
    double friction[LANES], damping[LANES]; /* W, loss (BA5) */
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
    /* The largest |dx| + half |da| of a segment between (p, a) and (at_p, at_a), m: no point of the line has moved
     * farther (C20). NaN counts as infinite. */
    double (*moved)(const PlanarChain *chain, const PlanarKinematics *kin, double *const at_p[2],
                    double *const at_a[2]);
} PlanarContactKernels;

ISA_KERNELS(PlanarContactKernels, planar_contact_kernels)

#endif
