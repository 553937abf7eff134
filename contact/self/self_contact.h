/* Contact of the cable with itself: layers, crossings, loops. docs/model.md, "Cable on cable".
 *
 * Life as in contact.h: alloc -> refresh -> forces and blocks -> refresh again as soon as self_moved_too_far says so,
 * between steps -> free. The contact line is always the smooth one. Forces come in two halves (part 0 and 1) that two
 * threads may take; the sums do not depend on the number of threads. */
#ifndef HAWSER_CONTACT_SELF_SELF_CONTACT_H
#define HAWSER_CONTACT_SELF_SELF_CONTACT_H

#include "contact/law/contact_law.h"
#include "contact/self/patch.h"
#include "contact/shape/element.h"
#include "core/block_chain.h"
#include "hawser/hawser.h"

enum { SELF_PARTS = 2 };

/* What never changes during a run. */
typedef struct SelfModel {
    int present; /* 0: no cable on cable; nothing of this is allocated or called */
    PatchLaw law;
    double reach; /* m: elements whose spheres come closer than this are candidates */
} SelfModel;

/* The law that presses like `impact` where two cables cross at a right angle (CC5), (CC8). */
PatchLaw self_law(const ImpactLaw *impact, const FrictionLaw *friction);

/* Candidates of one element: elements first .. first + count - 1 farther along the chain. */
typedef struct SelfRange {
    int element, first, count;
} SelfRange;

/* A piece that may be pressed: piece `piece` of an element over two feet. */
typedef struct SelfHit {
    int element, piece, foot[2];
    double v[2];
} SelfHit;

typedef struct SelfPairs {
    int n; /* segments */
    /* by self_refresh */
    int n_ranges, ranges_allocated;
    SelfRange *range; /* [n_ranges], by element, then by first */
    int half;         /* ranges before it are part 0 */
    int candidates;   /* pairs of elements in all ranges */
    double *at_p[3];  /* chain arrays: centres, m, and axes at the refresh */
    double *at_a[3];
    SphereTree tree;
    int hits_allocated;
    SelfHit *hit[SELF_PARTS];      /* [hits_allocated] each, by self_forces and self_blocks */
    int active[SELF_PARTS];        /* pieces that carried force in the last call of self_forces */
    ContactTally work[SELF_PARTS]; /* of the last call of self_forces; no force: the cable's own */
    BlockExtras extras; /* blocks of K and D off the diagonals; pattern by self_refresh, values by self_blocks */
} SelfPairs;

/* Elements this far apart along the chain, or farther, may touch (CC18). */
int self_skip(const Chain *chain);
/* Into how many pieces element e is cut (CC2). */
int self_pieces(const Chain *chain, int e);
/* Length of each of them at rest, m. */
double self_piece_length(const Chain *chain, int e);

/* Allocates for chains of n segments. 0 if there is no memory. The free may be called on a zeroed struct. */
int self_pairs_alloc(SelfPairs *pairs, int n);
void self_pairs_free(SelfPairs *pairs);

/* Finds the candidates and the pattern of the blocks, O((n + candidates) log n). Errors: MEMORY. The only call that
 * may allocate. */
hawser_status self_refresh(const SelfModel *model, const Chain *chain, const Kinematics *kin, SelfPairs *pairs,
                           hawser_error *err);
/* Whether two points may have come closer by more than 3/4 of the reach since the refresh (CC20). */
int self_moved_too_far(const SelfModel *model, const Chain *chain, const Kinematics *kin, const SelfPairs *pairs);

/* Adds the forces (N) and moments (N m) of one half of the candidates to loads. friction_scale: as in contact.h. */
void self_forces(const SelfModel *model, const Chain *chain, const Kinematics *kin, double friction_scale, int part,
                 SelfPairs *pairs, Loads *loads);

/* Adds the derivatives to k, d and, off their diagonals, to pairs->extras, which is not zeroed here (CC13)-(CC17). */
void self_blocks(const SelfModel *model, const Chain *chain, const Kinematics *kin, double friction_scale,
                 SelfPairs *pairs, BlockChain *k, BlockChain *d);

/* The candidates and the blocks off the diagonals. */
void self_pairs_checkpoint(Checkpoint *c, const Chain *chain, SelfPairs *pairs);

/* One pressed or nearly pressed piece, for tests and reports. */
typedef struct SelfDetail {
    int element, foot; /* elements of the line */
    double depth;      /* m */
    double normal;     /* N */
    Vec3 friction;     /* N, on the piece */
    Vec3 direction;    /* unit, of the normal force on the piece */
    Vec3 point;        /* m, on the piece's line at the resultant */
} SelfDetail;

/* Writes up to `room` of them, in the order of summation; returns how many there are. */
int self_details(const SelfModel *model, const Chain *chain, const Kinematics *kin, double friction_scale,
                 SelfPairs *pairs, int room, SelfDetail *out);

/* The deepest contact now; its depth is -INFINITY if nothing touches. For the check of a scene's start. */
SelfDetail self_deepest(const SelfModel *model, const Chain *chain, const Kinematics *kin, SelfPairs *pairs);

#endif
