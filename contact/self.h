/* The contact of a piece of one cable's line with another stretch of line: the integral of an elastic bed over the
 * piece, damping, friction, and the derivatives of all that. docs/theory.md, "Cable on cable"; letters as there. */
#ifndef HAWSER_CONTACT_SELF_H
#define HAWSER_CONTACT_SELF_H

#include "contact/law.h"
#include "contact/shape.h"
#include "core/block_chain.h"
#include "core/lanes.h"
#include "core/machine.h"
#include "hawser/hawser.h"

/* A line that may touch others: a chain with its present kinematics. Several lines have their blocks in one matrix, in
 * which the first segment of this one has this row. */
typedef struct SelfLine {
    const Chain *chain;
    const Kinematics *kin;
    int row;
    int eye; /* from 1: lines of the same number have their heads held apart by one eye, without contact there; 0:
              * none */
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
    int side;  /* 0: belongs to the piece, 1: to the feet */
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
    double from, to; /* limits of the pressed part, in [0, 1] */
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

/* ------------------------------------------------------------------------- the bed, for contact/self.c only */

/* Finds the pressed part of the piece, and the forces on its ends (CC2)-(CC6); 0 if it is not pressed anywhere. */
int bed_integrate(Patch *patch, const PatchLaw *law);

/* The integrals run over the pressed part of the piece, where the integrand is a polynomial of degree 4 at most: three
 * Gauss points give them exactly, without the cancellation of closed forms in the limits. Points and weights on [0, 1].
 */
enum { BED_POINTS = 3 };

static const double BED_AT[BED_POINTS] = {0.11270166537925831, 0.5, 0.88729833462074169};
static const double BED_WEIGHT[BED_POINTS] = {5.0 / 18, 8.0 / 18, 5.0 / 18};

/* Derivatives of the wrenches on a patch's slots: rows are force and moment, N and N m, columns the coordinates of one
 * slot: displacements (m) and rotations (rad), or velocities and angular velocities, along the world's axes. */
typedef struct PatchColumns {
    double row[PATCH_SLOTS][6][LANES]; /* [slot][row][column]; columns 0..5 */
} PatchColumns;

typedef struct SelfKernels {
    /* Columns of slot s (CC13)-(CC17). */
    void (*columns)(const Patch *patch, const PatchLaw *law, int s, PatchColumns *by_place, PatchColumns *by_motion);
} SelfKernels;

ISA_KERNELS(SelfKernels, self_kernels)

/* Contact of the cable with itself: layers, crossings, loops; and of several cables with each other. docs/theory.md,
 * "Cable on cable", "Several chains".
 *
 * Life as in contact/roller.h: alloc -> refresh -> forces and blocks -> refresh again as soon as self_moved_too_far
 * returns 1, between steps -> free. The contact line is always the smooth one. Forces come in two halves (part 0 and 1)
 * that two threads may take; the sums do not depend on the number of threads. */

enum { SELF_PARTS = 2 };

/* Data that never change during a run. */
typedef struct SelfModel {
    int present; /* 0: no contact of cable on cable; nothing of this is allocated or called */
    PatchLaw law;
    double reach; /* m: elements whose spheres come closer than this are candidates */
} SelfModel;

/* The law with the force of `impact` where two cables cross at a right angle (CC5), (CC8). */
PatchLaw self_law(const ImpactLaw *impact, const FrictionLaw *friction);
/* The lines that may touch each other: a chain alone, or several beside each other. */
typedef struct SelfLines {
    int n;
    const SelfLine *line;
    int within; /* 1: a line may touch itself too */
} SelfLines;

/* A chain alone; for an argument. */
#define SELF_ALONE(chain, kin)                                                                                         \
    &(SelfLines) { 1, &(SelfLine){chain, kin, 0}, 1 }
/* Candidates of one element: elements first .. first + count - 1 of a line, its own (farther along it) or one that
 * comes later. */
typedef struct SelfRange {
    int line, element, other, first, count;
} SelfRange;

/* A piece of an element that may be pressed. */
typedef struct SelfHit {
    int line, element, other;
    PatchEnd end[2];
} SelfHit;

/* Gaps between the two sides of every range of a half at some moment, and the positions of all segments. A range that
 * has not closed its gap since cannot have contact and is skipped: the results are the same. */
typedef struct SelfClear {
    int known;     /* 0: no gaps, since the ranges are new */
    int allocated; /* number of ranges allocated */
    double *gap;   /* [ranges of the half] m, lower bound; at most 0: there may be contact */
    double *at;    /* [n][6] centres and arms to the front ends, m */
    int vain;      /* ranges that were evaluated without a hit since */
} SelfClear;

typedef struct SelfPairs {
    int n; /* segments of all lines */
    /* by self_refresh */
    int n_ranges, ranges_allocated;
    SelfRange *range; /* [n_ranges], by line and element, then by other and first */
    int half;         /* ranges before it are part 0 */
    int candidates;   /* pairs of elements in all ranges */
    double *at_p[3];  /* chain arrays by row: centres, m, and axes at the refresh */
    double *at_a[3];
    int n_trees;
    SphereTree *tree; /* [n_trees] of each line */
    int hits_allocated;
    SelfHit *hit[SELF_PARTS];      /* [hits_allocated] each, of one range at a time */
    int active[SELF_PARTS];        /* pieces that carried force in the last call of self_forces */
    ContactTally work[SELF_PARTS]; /* of the last call of self_forces; no force: the cable's own */
    SelfClear clear[SELF_PARTS];
    int n_beside;            /* other couplings of rows; borrowed */
    const BlockPair *beside; /* [n_beside] */
    BlockExtras extras;      /* blocks of K and D off the diagonals; pattern by self_refresh, values by self_blocks */
} SelfPairs;

/* Elements this far apart along the chain, or farther, may touch (CC18). */
int self_skip(const Chain *chain);
/* Number of pieces into which element e is cut (CC2). */
int self_pieces(const Chain *chain, int e);
/* Length of each of them at rest, m. */
double self_piece_length(const Chain *chain, int e);
/* The largest contact radius of segments from..to, as far as they exist, m. */
double self_radius_most(const Chain *chain, int from, int to);
/* Allocates for `lines` chains of segments[] each, one after the other. 0 if there is no memory. The free may be called
 * on a zeroed struct. */
int self_pairs_alloc(SelfPairs *pairs, int lines, const int *segments);
void self_pairs_free(SelfPairs *pairs);
/* Finds the candidates and the pattern of the blocks, O((n + candidates) log n). Errors: MEMORY. The only call that
 * may allocate. */
hawser_status self_refresh(const SelfModel *model, const SelfLines *lines, SelfPairs *pairs, hawser_error *err);
/* Checks whether two points may have approached each other by more than 3/4 of the reach since the refresh (CC20). */
int self_moved_too_far(const SelfModel *model, const SelfLines *lines, const SelfPairs *pairs);
/* Updates the gaps of one half if worthwhile; the second returns whether range r may have contact now, by its gap. */
void self_clear_look(const SelfLines *lines, int part, SelfPairs *pairs);
int self_clear_apart(const SelfLines *lines, int part, const SelfPairs *pairs, int r);
/* Adds the forces (N) and moments (N m) of one half of the candidates to loads[line]. friction_scale: as in
 * contact/roller.h. */
void self_forces(const SelfModel *model, const SelfLines *lines, double friction_scale, int part, SelfPairs *pairs,
                 Loads *const loads[]);
/* Adds the derivatives to k, d (of all rows) and, off their diagonals and between lines, to pairs->extras, which is not
 * zeroed here (CC13)-(CC17). */
void self_blocks(const SelfModel *model, const SelfLines *lines, double friction_scale, SelfPairs *pairs, BlockChain *k,
                 BlockChain *d);
/* Saves or loads the candidates and the blocks off the diagonals. */
void self_pairs_checkpoint(Checkpoint *c, const SelfLines *lines, SelfPairs *pairs);
/* One pressed or nearly pressed piece, for tests and reports. */
typedef struct SelfDetail {
    int line, element, other, foot; /* indices of the two lines and of their elements */
    double depth;                   /* m */
    double normal;                  /* N */
    Vec3 friction;                  /* N, on the piece */
    Vec3 direction;                 /* unit, of the normal force on the piece */
    Vec3 point;                     /* m, on the piece's line at the resultant */
    double arm;                     /* m, between the two lines there */
    double length;                  /* m, of the piece at rest */
} SelfDetail;

/* Writes up to `room` of them, in the order of summation; returns how many there are. */
int self_details(const SelfModel *model, const SelfLines *lines, double friction_scale, SelfPairs *pairs, int room,
                 SelfDetail *out);
/* The largest normal force on a piece over its length at rest, N/m, of each line: most[lines]. Allocates nothing. */
void self_line_loads(const SelfModel *model, const SelfLines *lines, SelfPairs *pairs, double *most);
/* The deepest contact now; its depth is -INFINITY without contact. For the check of a scene's start. */
SelfDetail self_deepest(const SelfModel *model, const SelfLines *lines, SelfPairs *pairs);
/* Overlap of cables, from the positions of their segments alone: it shows what no contact law has prevented, whether
 * there is none, has lost its force or was too weak. */

/* A straight stretch between two points. */
typedef struct Chord {
    Vec3 from, along; /* m: its beginning, and the vector to its end */
} Chord;

static inline double chord_share(double x) { return fmin(1, fmax(0, x)); }

/* m, least distance of two chords: at their common perpendicular, or at an end of one of them. */
static inline double chords_apart(const Chord *p, const Chord *q)
{
    const Vec3 between = v3_sub(p->from, q->from);
    const double a = v3_dot(p->along, p->along), b = v3_dot(p->along, q->along), c = v3_dot(q->along, q->along);
    const double d = v3_dot(p->along, between), e = v3_dot(q->along, between), area = a * c - b * b;
    double s = area > 1e-12 * a * c ? chord_share((b * e - c * d) / area) : 0;
    const double t = chord_share((b * s + e) / c);
    s = chord_share((b * t - d) / a);
    const Vec3 apart = v3_sub(v3_axpy(between, s, p->along), v3_scale(t, q->along));
    return v3_norm(apart);
}

typedef struct SelfOverlap {
    double share;        /* (CC29): 1 where centre lines cross; negative: apart */
    int line, segment;   /* the first line and its segment, */
    int other, opposite; /* the other's; line -1: nothing is near */
    Vec3 at;             /* m, the middle of the first */
} SelfOverlap;

/* The deepest overlap of two segments, as chords, of the given lines or (lines->within) of one line. Left out: segments
 * of one line with so little cable between them that it could not return to itself there, and heads that one eye holds
 * (SC9). O(n log n) for straight lines, O(n^2) for coils. */
SelfOverlap self_overlap(const SelfLines *lines);

#endif
