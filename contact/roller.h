/* The kernels of contact/roller_lanes.c, once for every instruction set. */
#ifndef HAWSER_CONTACT_ROLLER_H
#define HAWSER_CONTACT_ROLLER_H

#include "contact/law.h"
#include "contact/shape.h"
#include "core/block_chain.h"
#include "core/chain.h"
#include "core/lanes.h"
#include "core/machine.h"
#include "hawser/hawser.h"

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
    double form[SHAPE_FORM][LANES];                /* of shapes other than cylinders: shape_form */
    ShapeKind kind;                                /* of all lanes */
    FrictionKind rubs;                             /* likewise; FRICTION_NONE too where friction_scale is 0 */
    double kept[3][LANES];                         /* where it sticks: s0 of each contact, m */
    double elapsed;                                /* s since then */
    const FrictionLaw *friction[LANES];
    const ImpactLaw *impact;
    double friction_scale;
    int presumes;           /* 1: the law is a line about: */
    double presumed[LANES]; /* N, of each contact (PS11); set with `presumes` */
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

/* Loads of a batch on its segments. */
typedef struct ContactPush {
    _Alignas(64) double force[2][3][LANES]; /* N, on the two bodies */
    double moment[2][3][LANES];             /* N m, about their centres */
    double total[3][LANES];                 /* N, on the cable */
    double normal[LANES];                   /* N */
    double friction[LANES], damping[LANES]; /* W, loss (BA5) */
    double energy[LANES];                   /* J, in the spring (BA6) */
    double u[LANES], gap[LANES];
    double point[3][LANES];         /* m, on the line */
    double roller_moment[3][LANES]; /* N m, on the roller about its centre; set where rollers move */
    double kept[3][LANES];          /* where it sticks: s, m, if the step ends here */
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

/* Every kernel exists for several kinds of batches, so that a batch does no work that it does not need. */
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

/* returns 0, and writes nothing, if no hit of the batch carries force; 2, without writing d, if no force depends on a
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

/* Contact between the cable's line and rollers, fixed or moving: pairs that can touch, their forces, and the
 * derivatives of these. docs/theory.md, "Contact".
 *
 * Life: contact_pairs_alloc -> contact_refresh -> forces and blocks, any number of times -> refresh again as soon as
 * contact_moved_too_far returns 1 (between steps) -> contact_pairs_free. Forces are pure functions of chain and
 * kinematics as long as nothing has moved by `reach` since the refresh; the sums are taken in a fixed order. */

typedef struct ContactRoller {
    Shape shape;
    FrictionLaw friction;
} ContactRoller;

/* Motion of a roller: velocity of its centre, m/s, and angular velocity, rad/s, world. */
typedef struct RollerMotion {
    Vec3 v, w;
} RollerMotion;

/* Load of the cable on a roller: force, N, and moment about its centre, N m. */
typedef struct RollerLoad {
    Vec3 force, moment;
} RollerLoad;

/* Data that never change during a run, except for the poses and motions of rollers that move. */
typedef struct ContactModel {
    ContactGeometry geometry;
    ImpactLaw impact;
    double reach; /* m: pairs closer than this at a refresh are candidates */
    int n_rollers;
    const ContactRoller *roller; /* [n_rollers], borrowed */
    const RollerMotion *motion;  /* [n_rollers], borrowed; NULL: no roller moves, and nothing is computed for it */
} ContactModel;

/* Key of a roller for the kernels: its kinds of shape and of friction. */
static inline int contact_kind(ShapeKind shape, FrictionKind friction)
{
    return FRICTION_KINDS * (int)shape + (int)friction;
}

/* Candidates of one face of a roller: elements first .. first + count - 1. */
typedef struct ContactRange {
    int kind; /* contact_kind of the roller */
    int roller, face, first, count;
} ContactRange;

/* A place where the line is nearest to a roller, to be evaluated. */
typedef struct ContactHit {
    int kind, roller, face, element;
} ContactHit;

typedef struct ContactPairs {
    int n; /* segments */
    /* by contact_refresh */
    int n_ranges, ranges_allocated;
    ContactRange *range; /* [n_ranges], by kinds of shape and of friction, roller, face, element */
    int candidates;      /* pairs in all ranges */
    /* all ranges after contact_refresh; their near parts after planar_contact_narrow */
    int n_near;
    ContactRange *near; /* [n_near], room for ranges_allocated */
    double *at_p[3];    /* chain arrays: centres, m, and axes at the refresh */
    double *at_a[3];
    SphereTree tree; /* spheres around runs of elements (C19) */
    /* by contact_forces and contact_blocks */
    int hits_allocated;
    int n_hits;
    ContactHit *hit;        /* [n_hits] */
    double *node;           /* chain array: a quantity of the segments against one roller */
    int active;             /* hits that carried force in the last call of contact_forces */
    ContactTally tally;     /* of the last call of contact_forces */
    const double *presumed; /* [2 n_rollers] N, by roller and face: the law is a line about it (PS11); borrowed; NULL:
                             * the law itself applies */
    StickStore stick;       /* by contact_accept; not allocated if nothing sticks */
} ContactPairs;

/* Allocates for chains of n segments; candidates are empty until the first refresh. Returns 0 without memory
 * (nothing is left allocated). The free may be called on a zeroed struct. */
int contact_pairs_alloc(ContactPairs *pairs, int n);
void contact_pairs_free(ContactPairs *pairs);
/* Finds the candidates: all elements whose sphere comes within reach of a roller's surface. O(n + (rollers +
 * candidates) log n). Errors: HAWSER_ERR_MEMORY. The only call that may allocate. */
hawser_status contact_refresh(const ContactModel *model, const Chain *chain, const Kinematics *kin, ContactPairs *pairs,
                              hawser_error *err);
/* Makes all ranges near. */
void contact_widen(ContactPairs *pairs);
/* Share of the reach that may be used up before candidates are renewed; the rest is for the motion within a step. */
#define CONTACT_USABLE 0.75
/* Checks whether a point of the line may have moved by more than that since the refresh (C20). */
int contact_moved_too_far(const ContactModel *model, const Chain *chain, const Kinematics *kin,
                          const ContactPairs *pairs);
/* Adds forces (N) and moments (N m) on the segments to loads. friction_scale multiplies every friction coefficient (0:
 * smooth rollers). force[n_rollers] and load[n_rollers] (NULL: not required) are overwritten by the cable's loads on
 * each roller: force, N; where rollers move (model->motion), force and moment. */
void contact_forces(const ContactModel *model, const Chain *chain, const Kinematics *kin, double friction_scale,
                    ContactPairs *pairs, Loads *loads, Vec3 *force, RollerLoad *load);
/* Coupling of one contact with a roller: derivatives with respect to configuration (first index 0) and velocities (1),
 * column-major 6x6, rows [force; moment], columns [x; phi] or [v; w], about the roller's centre (SP4)-(SP6). */
typedef struct RollerCoupling {
    int roller, body[2];   /* segments; -1: none */
    double into[2][2][36]; /* [kind][body]: rows of the body, columns of the roller */
    double from[2][2][36]; /* [kind][body]: rows of the roller, columns of the body */
    double own[2][36];     /* [kind]: rows and columns of the roller */
} RollerCoupling;

typedef void CouplingTake(void *user, const RollerCoupling *coupling);

/* Adds the derivatives of the generalized forces [force; moment] with respect to [dx; dphi] to k, and to [dv; dw] to d
 * (6x6 blocks, world) (C15)-(C17). Where rollers move, the parts that involve a roller are passed to `take` (else
 * NULL), one contact after the other in the order of summation. */
void contact_blocks(const ContactModel *model, const Chain *chain, const Kinematics *kin, double friction_scale,
                    ContactPairs *pairs, BlockChain *k, BlockChain *d, CouplingTake *take, void *user);
/* force[2 n_rollers], N by roller and face: presumed forces of the contacts; `before` (the same; NULL: zeros) as in
 * presume_force. Of several contacts on one face the largest force counts. */
void contact_presume(const ContactModel *model, const Chain *chain, const Kinematics *kin, ContactPairs *pairs,
                     const Presume *how, const double *before, double *force);
/* Accepts a step to (t, kin): stores the leans of contacts that stick. Must be called after every step if any roller's
 * friction sticks (contact_sticks), before the next contact_refresh. */
int contact_sticks(const ContactModel *model);
void contact_accept(const ContactModel *model, const Chain *chain, const Kinematics *kin, double t,
                    ContactPairs *pairs);
/* Saves or loads the candidates and the leans. */
void contact_pairs_checkpoint(Checkpoint *c, const ContactModel *model, ContactPairs *pairs);
/* One contact in detail, for tests, tools and reports. */
typedef struct ContactDetail {
    int roller, face, element;
    double u;      /* parameter of the element */
    double gap;    /* m */
    double normal; /* N */
    Vec3 point;    /* m, on the line */
    Vec3 force;    /* N, on the cable */
} ContactDetail;

/* Writes up to `room` hits, touching or not, in the order of summation; returns how many there are. */
int contact_details(const ContactModel *model, const Chain *chain, const Kinematics *kin, double friction_scale,
                    ContactPairs *pairs, int room, ContactDetail *out);

#endif
