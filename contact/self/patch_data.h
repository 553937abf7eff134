/* The data of a patch, shared by patch.c and the bed over it. docs/model.md, "Cable on cable"; letters as there. */
#ifndef HAWSER_CONTACT_SELF_PATCH_DATA_H
#define HAWSER_CONTACT_SELF_PATCH_DATA_H

#include "contact/law/contact_law.h"
#include "contact/shape/line_spot.h"

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
    int body;
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
} Patch;

/* One segment's wrench, about its centre. */
typedef struct PatchWrench {
    Vec3 force, moment; /* N, N m */
} PatchWrench;

#endif
