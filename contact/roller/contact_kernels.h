/* What contact_lanes.c and contact_blocks_lanes.c offer to contact.c, once for every instruction set. */
#ifndef HAWSER_CONTACT_ROLLER_CONTACT_KERNELS_H
#define HAWSER_CONTACT_ROLLER_CONTACT_KERNELS_H

#include "contact/law/contact_law.h"
#include "contact/shape/shape.h"
#include "core/base/isa.h"
#include "core/base/lanes.h"
#include "core/block_chain.h"
#include "core/chain.h"

/* Up to LANES hits, gathered; the last hit is repeated in unused lanes. Vectors are [component][lane], bodies
 * [0, 1] are an element's two segments; a missing one is all zeros. */
typedef struct ContactBatch {
    _Alignas(64) double arc[LANES]; /* weights, as in Element */
    double alpha[LANES], beta[2][2][LANES];
    double x[2][3][LANES];                   /* centre, m */
    double r[2][3][LANES];                   /* from the centre to the front end, m */
    double v[2][3][LANES];                   /* m/s */
    double w[2][3][LANES];                   /* rad/s */
    double radius[2][LANES];                 /* contact radius, m */
    double centre[3][LANES], axis[3][LANES]; /* of the shape, m and unit */
    double shape_radius[LANES], shape_half_width[LANES];
    double roller_v[3][LANES], roller_w[3][LANES]; /* of the roller, m/s and rad/s; set where rollers move */
    double form[SHAPE_FORM][LANES];                /* of kinds beside the cylinder: shape_form */
    ShapeKind kind;                                /* of all lanes */
    FrictionKind rubs;                             /* likewise; FRICTION_NONE too where friction_scale is 0 */
    double kept[3][LANES];                         /* where it sticks: s0 of each contact, m */
    double elapsed;                                /* s since then */
    const FrictionLaw *friction[LANES];
    const ImpactLaw *impact;
    double friction_scale;
    int presumes;           /* whether the law is a line about: */
    double presumed[LANES]; /* N, of each contact (PS11); set where it is */
    int count;
    int body[2][LANES];
    int roller[LANES], face[LANES], element[LANES];
} ContactBatch;

/* A vector of lane l. */
static inline Vec3 batch_at(const double a[3][LANES], int l) { return v3(a[0][l], a[1][l], a[2][l]); }
static inline void batch_put(double a[3][LANES], int l, Vec3 v)
{
    a[0][l] = v.x;
    a[1][l] = v.y;
    a[2][l] = v.z;
}

/* What a batch does to its segments. */
typedef struct ContactPush {
    _Alignas(64) double force[2][3][LANES]; /* N, on the two bodies */
    double moment[2][3][LANES];             /* N m, about their centres */
    double total[3][LANES];                 /* N, on the cable */
    double normal[LANES];                   /* N */
    double friction[LANES], damping[LANES]; /* W, what they take (BA5) */
    double energy[LANES];                   /* J, in the spring (BA6) */
    double u[LANES], gap[LANES];
    double point[3][LANES];         /* m, on the line */
    double roller_moment[3][LANES]; /* N m, on the roller about its centre; set where rollers move */
    double kept[3][LANES];          /* where it sticks: s, m, should the step end here */
} ContactPush;

/* Derivatives of the bodies' [force moment] with respect to their [x phi] or [v w]: [rows * column + row][lane], with
 * CONTACT_ROWS rows and columns for the two segments, MOVING_ROWS where a roller that moves is the third body. */
enum { CONTACT_ROWS = 12, MOVING_ROWS = 18 };
typedef struct ContactMatrix {
    _Alignas(64) double entry[MOVING_ROWS * MOVING_ROWS][LANES];
} ContactMatrix;

/* block [36] += rows of body a by columns of body b of lane l. */
static inline void matrix_part_add(const ContactMatrix *m, int rows, int l, int a, int b, double *block)
{
    for (int col = 0; col < 6; ++col) {
        const double(*const column)[LANES] = m->entry + rows * (6 * b + col) + 6 * a;
        for (int row = 0; row < 6; ++row) block[6 * col + row] += column[row][l];
    }
}

/* Adds lane l to the up to four blocks of its segments j and k = j + 1; below zero or beyond the chain: none. */
static inline void matrix_add(const ContactMatrix *m, int rows, int l, int j, int k, BlockChain *out)
{
    const int before = j >= 0, after = k >= 0 && k < out->n;
    if (before) matrix_part_add(m, rows, l, 0, 0, out->diag + 36 * j);
    if (after) matrix_part_add(m, rows, l, 1, 1, out->diag + 36 * k);
    if (!before || !after) return;
    matrix_part_add(m, rows, l, 0, 1, out->upper + 36 * j);
    matrix_part_add(m, rows, l, 1, 0, out->lower + 36 * k);
}

/* Every kernel exists for several kinds of batches, so that a batch pays for nothing that it does not have. */
typedef enum ContactVariant {
    VARIANT_PLAIN,       /* cylinders that do not move, friction of speed */
    VARIANT_SMOOTH,      /* cylinders that do not move, no friction */
    VARIANT_GENERAL,     /* any shape, does not move, friction of speed or none */
    VARIANT_STICK,       /* any shape, does not move, any friction */
    VARIANT_MOVING,      /* any shape, moving, friction of speed or none */
    VARIANT_MOVING_STICK /* all of it */
} ContactVariant;
enum { CONTACT_VARIANTS = 6 };

typedef void ContactPushKernel(const ContactBatch *batch, ContactPush *out);
/* returns 0, and writes nothing, if no hit of the batch carries force; 2, and leaves d, if no force depends on a
 * velocity; else 1. normal[lane] is each hit's force, N */
typedef int ContactColumnsKernel(const ContactBatch *batch, ContactMatrix *k, ContactMatrix *d, double normal[LANES]);

typedef struct ContactKernels {
    /* node[i] = a positive factor times (normal at the centre of segment i . axis of segment i), for i =
     * from..to-1 (and up to LANES - 1 more): only the sign counts */
    void (*slopes)(const Shape *shape, int face, const Kinematics *kin, int from, int to, double *node);
    /* node[i] = distance of the centre of segment i from the face, m; same range */
    void (*distances)(const Shape *shape, int face, const Kinematics *kin, int from, int to, double *node);
    ContactPushKernel *push[CONTACT_VARIANTS];
    ContactColumnsKernel *columns[CONTACT_VARIANTS];
} ContactKernels;

ISA_KERNELS(ContactKernels, contact_kernels)

#endif
