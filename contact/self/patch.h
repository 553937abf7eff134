/* The contact of a piece of one cable's line with another stretch of line: the integral of an elastic bed over the
 * piece, damping, friction, and the derivatives of all that. docs/model.md, "Cable on cable"; letters as there. */
#ifndef HAWSER_CONTACT_SELF_PATCH_H
#define HAWSER_CONTACT_SELF_PATCH_H

#include "contact/law/contact_law.h"
#include "contact/shape/element.h"

/* A line that may touch others: a chain, and where it is now. Several lines have their blocks in one matrix, where the
 * first segment of this one has this row. */
typedef struct SelfLine {
    const Chain *chain;
    const Kinematics *kin;
    int row;
    int eye; /* from 1: lines of the same number have their heads held apart by one eye, and do not press there; 0: none
              */
} SelfLine;

/* One end of a piece, and its foot on the other line. */
typedef struct PatchEnd {
    LineSpot here, there;
    int foot; /* the element of the other line, and the parameter there */
    double v;
} PatchEnd;

/* The law of cable on cable. */
typedef struct PatchLaw {
    double bed;         /* N/m^1.5: the bed's modulus k_b is bed / sqrt(R) (CC5) */
    double dissipation; /* s/m: the damping chi (CC8) */
    FrictionLaw friction;
} PatchLaw;

enum { PATCH_SLOTS = 6 };

/* One segment's share in a patch: at both ends of the piece its weights and, where the foot moves (side 1), their
 * derivatives. */
typedef struct PatchSlot {
    int body;  /* segment of its side's line */
    int side;  /* 0: carries the piece, 1: carries the feet */
    Vec3 r, w; /* arm to the front end, m; angular velocity, rad/s */
    double alpha[2], beta[2], alpha1[2], beta1[2];
} PatchSlot;

/* All at both ends a of the piece, where [2]. */
typedef struct Patch {
    int slots;
    PatchSlot slot[PATCH_SLOTS];
    /* geometry */
    double length;       /* m, of the piece at rest */
    double radius;       /* R, m */
    double share[2];     /* rho: radii of the two sides over R */
    Vec3 w[2];           /* from the foot to the piece's end, m */
    Vec3 foot1[2];       /* Q', m */
    double curvature[2]; /* of half the squared distance along the feet's line, m2; 0: the foot is held at an end */
    double radius1[2];   /* of the feet's side, m */
    /* motion */
    Vec3 speed[2];    /* of the piece's end against the foot, at fixed parameters, m/s */
    Vec3 speed1[2];   /* its derivative by the foot's parameter, negative */
    Vec3 omega[2][2]; /* [side][a], rad/s */
    Vec3 omega1[2];   /* of the feet's side by their parameter */
    /* bed */
    double from, to; /* where the piece is pressed, in [0, 1] */
    double modulus;  /* k_b length / R, N/m2 */
    double m0, m1;   /* integrals of q and q xi, m */
    double energy;   /* J, in the bed (BA6) */
    double centre;   /* xi at the resultant */
    Vec3 g[2];       /* elastic forces on the piece's ends, N */
    double elastic;  /* |g_0 + g_1|, N */
    /* laws */
    Vec3 arm;        /* w at the centre, m */
    double distance; /* its length */
    Vec3 normal;
    Vec3 drift;           /* speed at the centre, m/s */
    double rate;          /* m/s, of the gap */
    double damped;        /* factor on the elastic forces */
    Vec3 spin;            /* sum of rho omega, rad/s */
    Vec3 slide;           /* tangential velocity of the surfaces, m/s */
    Vec3 slip;            /* with its normal part */
    double phi, phi_over; /* friction coefficient over speed, scale included, and its derivative over speed */
    /* result */
    double force;  /* N, normal */
    Vec3 friction; /* N, on the piece */
    Vec3 couple;   /* N m: of the friction about the two lines, before the shares */
    Vec3 on[2];    /* f_a (CC12), N, on the piece's ends */
} Patch;

/* One segment's wrench, about its centre. */
typedef struct PatchWrench {
    Vec3 force, moment; /* N, N m */
} PatchWrench;

/* The piece (length m at rest) of the line side[0] between two ends with their feet on side[1], which may be the same
 * line. Returns 0 if nothing is pressed: then only the geometry is filled in. */
int patch_at(const SelfLine *const side[2], const PatchLaw *law, double friction_scale, double length,
             const PatchEnd end[2], Patch *patch);

/* What the patch does to slot s (CC12). */
PatchWrench patch_wrench(const Patch *patch, int s);

/* Derivatives of all slots' wrenches by coordinate c of slot s: 0..2 shifts, 3..5 turns, 6..8 velocities, 9..11
 * angular velocities, world (CC13)-(CC17). */
void patch_column(const Patch *patch, const PatchLaw *law, int s, int c, PatchWrench out[PATCH_SLOTS]);

/* The largest depth on the piece, m; negative: the least distance between the surfaces. */
double patch_depth(const Patch *patch);

/* ------------------------------------------------------------------------- the bed under it, for patch*.c only */

/* Where the piece is pressed, and the forces on its ends (CC2)-(CC6); 0 if it is pressed nowhere. */
int bed_integrate(Patch *patch, const PatchLaw *law);

/* What a change of the two separations (m) and of R (m) does to the bed's forces (N) and moments m0, m1 (m) (CC15). */
void bed_vary(const Patch *patch, const Vec3 w_by[2], double radius_by, Vec3 g_by[2], double *m0_by, double *m1_by);

#endif
