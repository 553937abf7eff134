/* What contact_lanes.c and contact_blocks_lanes.c offer to contact.c, once for every instruction set. */
#ifndef HAWSER_CONTACT_ROLLER_CONTACT_KERNELS_H
#define HAWSER_CONTACT_ROLLER_CONTACT_KERNELS_H

#include "contact/law/contact_law.h"
#include "contact/shape/shape.h"
#include "core/base/isa.h"
#include "core/base/lanes.h"
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
    double groove[6][LANES]; /* of grooved kinds: depth, lip, cosine, sine, radius, side (LaneGroove) */
    ShapeKind kind;          /* of all lanes */
    FrictionKind rubs;       /* likewise; FRICTION_NONE too where friction_scale is 0 */
    double kept[3][LANES];   /* where it sticks: s0 of each contact, m */
    double elapsed;          /* s since then */
    const FrictionLaw *friction[LANES];
    const ImpactLaw *impact;
    double friction_scale;
    int count;
    int body[2][LANES];
    int roller[LANES], face[LANES], element[LANES];
} ContactBatch;

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

/* Derivatives of [force_0 moment_0 force_1 moment_1] with respect to [x_0 phi_0 x_1 phi_1] or [v_0 w_0 v_1
 * w_1]. */
typedef struct ContactMatrix {
    _Alignas(64) double entry[12][12][LANES]; /* [column][row][lane] */
} ContactMatrix;

/* The same with the roller as a third body, in rows and in columns. */
typedef struct ContactMovingMatrix {
    _Alignas(64) double entry[18][18][LANES]; /* [column][row][lane] */
} ContactMovingMatrix;

/* Every kernel exists for several kinds of batches, so that a batch pays for nothing that it does not have. */
typedef enum ContactVariant {
    VARIANT_PLAIN,       /* cylinders that do not move, friction of speed */
    VARIANT_SMOOTH,      /* cylinders that do not move, no friction */
    VARIANT_GENERAL,     /* any shape, does not move, friction of speed or none */
    VARIANT_STICK,       /* any shape, does not move, any friction */
    VARIANT_MOVING,      /* any shape, moving, friction of speed or none */
    VARIANT_MOVING_STICK /* all of it */
} ContactVariant;
enum { CONTACT_VARIANTS = 6, CONTACT_FIXED_VARIANTS = 4 };

typedef void ContactPushKernel(const ContactBatch *batch, ContactPush *out);
/* returns 0, and writes nothing, if no hit of the batch carries force; 2, and leaves d, if no force depends on a
 * velocity; else 1. normal[lane] is each hit's force, N */
typedef int ContactColumnsKernel(const ContactBatch *batch, ContactMatrix *k, ContactMatrix *d, double normal[LANES]);
typedef int ContactMovingKernel(const ContactBatch *batch, ContactMovingMatrix *k, ContactMovingMatrix *d,
                                double normal[LANES]);

typedef struct ContactKernels {
    /* node[i] = a positive factor times (normal at the centre of segment i . axis of segment i), for i =
     * from..to-1 (and up to LANES - 1 more): only the sign counts */
    void (*slopes)(const Shape *shape, int face, const Kinematics *kin, int from, int to, double *node);
    /* node[i] = distance of the centre of segment i from the face, m; same range */
    void (*distances)(const Shape *shape, int face, const Kinematics *kin, int from, int to, double *node);
    ContactPushKernel *push[CONTACT_VARIANTS];
    ContactColumnsKernel *columns[CONTACT_FIXED_VARIANTS];
    ContactMovingKernel *moving[CONTACT_VARIANTS - CONTACT_FIXED_VARIANTS]; /* the same where rollers move */
} ContactKernels;

extern const ContactKernels contact_kernels_generic, contact_kernels_avx2, contact_kernels_avx512;

#endif
