/* Contact between the cable's line and surfaces that it lies on along a length: ducts, trays, floors, walls.
 * docs/model.md, "Surfaces".
 *
 * Unlike a roller, which the line touches where it comes nearest, a surface acts at fixed points of every element of
 * the line, each standing for a length of cable (DU1): its stiffness does not depend on how the cable is cut.
 *
 * A surface is made of patches: one for each piece of the way along which it runs (a straight, or at most a quarter of
 * a bend) and each face of its cross-section. Life as in contact/contact.h: alloc -> refresh -> forces and blocks, any
 * number of times, until contact_moved_too_far. Nothing is searched between two refreshes. */
#ifndef HAWSER_CONTACT_SURFACE_H
#define HAWSER_CONTACT_SURFACE_H

#include "contact/contact_law.h"
#include "contact/element.h"
#include "contact/surface_patch.h"
#include "contact/surface_stick.h"
#include "core/block_chain.h"
#include "hawser/hawser.h"

/* The points of a chain's line, by element e (chain arrays; bodies e-1 and e, a missing one has no weight) (DU2). */
typedef struct SurfacePoints {
    int elements;
    double *alpha[SURFACE_POINTS];   /* of body e; that of body e-1 is 1 - alpha */
    double *beta[SURFACE_POINTS][2]; /* of the arms of e-1 and e */
    double *length[SURFACE_POINTS];  /* m of cable that the point stands for */
    double *radius[SURFACE_POINTS];  /* contact radius there, m */
} SurfacePoints;

/* What never changes during a run. */
typedef struct SurfaceModel {
    ImpactLaw impact; /* for each metre of cable: k in N/m^e per m, c in N s/m per m */
    double reach;     /* m: as in ContactModel */
    int n_surfaces, n_patches;
    const FrictionLaw *friction; /* [n_surfaces], borrowed */
    const SurfacePatch *patch;   /* [n_patches], by surface, then along the way, borrowed */
    const SurfacePoints *points; /* borrowed */
} SurfaceModel;

/* Candidates of one patch: elements first .. first + count - 1. */
typedef struct SurfaceRange {
    int patch, first, count;
} SurfaceRange;

/* The candidates among elements from .. to-1; by surface_refresh. */
typedef struct SurfacePairs {
    int from, to;
    int n_ranges, ranges_allocated;
    SurfaceRange *range; /* [n_ranges], by patch, then by element */
    int candidates;      /* pairs of element and patch */
    int active;          /* points that carried force in the last call of surface_forces with a tally */
    SurfaceStick stick;  /* by surface_accept; beds by surface_pairs_sticks, none without friction that sticks */
} SurfacePairs;

/* What the cable does to one surface. */
typedef struct SurfaceTally {
    Vec3 force;       /* N, on the surface */
    double normal;    /* N, sum of the normal forces' sizes */
    double friction;  /* N, sum of the friction forces' sizes */
    double line_load; /* N/m, the largest normal force of an element on a face over the element's length */
    double at; /* m along the route, where that is; NAN: nothing touches, or the surface is not along the route */
} SurfaceTally;

/* Points of a chain (lengths and radii must be set). Returns 0 without memory (nothing is left allocated). */
int surface_points_alloc(SurfacePoints *points, ContactGeometry geometry, const Chain *chain);
void surface_points_free(SurfacePoints *points);

/* Elements from .. to-1, no candidates yet: allocates nothing. The free may be called on a zeroed struct. */
void surface_pairs_init(SurfacePairs *pairs, int from, int to);
void surface_pairs_free(SurfacePairs *pairs);
/* Beds for the surfaces whose friction sticks, of a chain of n segments; whether there are any is surface_sticks.
 * Returns 0 without memory. */
int surface_sticks(const SurfaceModel *model);
int surface_pairs_sticks(SurfacePairs *pairs, const SurfaceModel *model, int n);

/* Finds the candidates: all elements with a point within reach of a patch (DU13), in O(n + patches n / 32 + candidates)
 * operations. Errors: HAWSER_ERR_MEMORY. The only call that may allocate. */
hawser_status surface_refresh(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, SurfacePairs *pairs,
                              hawser_error *err);

/* Adds forces (N) and moments (N m) on the segments to loads (its ghosts are overwritten) (DU9), (DU10). friction_scale
 * multiplies every friction coefficient. tally[n_surfaces] (NULL: not wanted) is added to: set it by surface_tally_new
 * first. */
void surface_forces(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, double friction_scale,
                    SurfacePairs *pairs, Loads *loads, SurfaceTally *tally);
SurfaceTally surface_tally_new(void);

/* The chain has been renumbered: element e is now e + joined. Adds what `old` remembers of elements that are `now`'s;
 * to be called for all pairs of old and new halves. */
void surface_carry(const SurfacePairs *old, SurfacePairs *now, int joined);
/* Evaluations that follow are at t; and: a step to (t, kin) has been accepted, points that stick remember their lean.
 * Both are needed only where surface_sticks. */
void surface_clock(SurfacePairs *pairs, double t);
void surface_accept(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, double t,
                    SurfacePairs *pairs);

/* Adds the derivatives of these forces to k and d, as contact_blocks does (DU11), (DU12), of elements from .. to-1
 * only. */
void surface_blocks(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, double friction_scale,
                    const SurfacePairs *pairs, int from, int to, BlockChain *k, BlockChain *d);

#endif
