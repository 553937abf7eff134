/* Contact of the cable with itself: layers, crossings, loops; and of several cables with each other. docs/model.md,
 * "Cable on cable", "Several chains".
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

/* The lines that may touch each other: a chain alone, or several beside each other. */
typedef struct SelfLines {
    int n;
    const SelfLine *line;
    int within; /* a line may touch itself too */
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

/* How far apart the two sides of every range of a half were at some moment, and where all segments were. What has not
 * come nearer since cannot press, and is not looked at: results are the same without. */
typedef struct SelfClear {
    int known;     /* 0: nothing, since the ranges are new */
    int allocated; /* ranges that there is room for */
    double *gap;   /* [ranges of the half] m, at least; at most 0: it may press */
    double *at;    /* [n][6] centres and arms to the front ends, m */
    int vain;      /* ranges that were looked at for nothing since */
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
    int n_beside;            /* what else couples rows; borrowed */
    const BlockPair *beside; /* [n_beside] */
    BlockExtras extras;      /* blocks of K and D off the diagonals; pattern by self_refresh, values by self_blocks */
} SelfPairs;

/* Elements this far apart along the chain, or farther, may touch (CC18). */
int self_skip(const Chain *chain);
/* Into how many pieces element e is cut (CC2). */
int self_pieces(const Chain *chain, int e);
/* Length of each of them at rest, m. */
double self_piece_length(const Chain *chain, int e);

/* Within how many elements of a range, at least one, the foot of a piece's end has that of its other end. */
double self_feet_apart(const SelfLine *mine, const SelfLine *other, const SelfRange *range);

/* The largest contact radius of segments from..to, as far as they exist, m. */
double self_radius_most(const Chain *chain, int from, int to);

/* Allocates for `lines` chains of segments[] each, one after the other. 0 if there is no memory. The free may be called
 * on a zeroed struct. */
int self_pairs_alloc(SelfPairs *pairs, int lines, const int *segments);
void self_pairs_free(SelfPairs *pairs);

/* Finds the candidates and the pattern of the blocks, O((n + candidates) log n). Errors: MEMORY. The only call that
 * may allocate. */
hawser_status self_refresh(const SelfModel *model, const SelfLines *lines, SelfPairs *pairs, hawser_error *err);
/* Whether two points may have come closer by more than 3/4 of the reach since the refresh (CC20). */
int self_moved_too_far(const SelfModel *model, const SelfLines *lines, const SelfPairs *pairs);

/* The ranges of one half that may press now, by what is known of it: whether range r is one of them. May look anew. */
void self_clear_look(const SelfLines *lines, int part, SelfPairs *pairs);
int self_clear_apart(const SelfLines *lines, int part, const SelfPairs *pairs, int r);

/* Adds the forces (N) and moments (N m) of one half of the candidates to loads[line]. friction_scale: as in contact.h.
 */
void self_forces(const SelfModel *model, const SelfLines *lines, double friction_scale, int part, SelfPairs *pairs,
                 Loads *const loads[]);

/* Adds the derivatives to k, d (of all rows) and, off their diagonals and between lines, to pairs->extras, which is not
 * zeroed here (CC13)-(CC17). */
void self_blocks(const SelfModel *model, const SelfLines *lines, double friction_scale, SelfPairs *pairs, BlockChain *k,
                 BlockChain *d);

/* The candidates and the blocks off the diagonals. */
void self_pairs_checkpoint(Checkpoint *c, const SelfLines *lines, SelfPairs *pairs);

/* One pressed or nearly pressed piece, for tests and reports. */
typedef struct SelfDetail {
    int line, element, other, foot; /* of the two lines, elements of them */
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

/* The deepest contact now; its depth is -INFINITY if nothing touches. For the check of a scene's start. */
SelfDetail self_deepest(const SelfModel *model, const SelfLines *lines, SelfPairs *pairs);

#endif
