/* Contact between the cable's line and surfaces that it lies on along a length: ducts, trays, floors, walls.
 * docs/model.md, "Surfaces".
 *
 * Unlike a roller, which the line touches where it comes nearest, a surface acts at fixed points of every element of
 * the line, each standing for a length of cable (DU1): its stiffness does not depend on how the cable is cut.
 *
 * A surface is made of patches: one for each piece of the way along which it runs (a straight, or at most a quarter of
 * a bend) and each face of its cross-section. Life as in contact/roller/contact.h: alloc -> refresh -> forces and
 * blocks, any number of times, until contact_moved_too_far. Nothing is searched between two refreshes. */
#ifndef HAWSER_CONTACT_SURFACE_SURFACE_H
#define HAWSER_CONTACT_SURFACE_SURFACE_H

#include "contact/surface/surface_data.h"

/* Points of a chain (lengths and radii, and points->tip, must be set). Returns 0 without memory (nothing is left
 * allocated). */
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

/* One point of the line that is pressed on a surface, for tools and reports. */
typedef struct SurfaceDetail {
    int surface, element, point_number;
    double normal, gap; /* N; m, below 0 */
    Vec3 point, toward; /* m, on the line; unit, toward the cable */
    Vec3 force;         /* N, on the cable */
} SurfaceDetail;
/* Writes all that carry force, SURFACE_POINTS for each candidate at most; returns how many. loads are scratch. */
int surface_details(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, const SurfacePairs *pairs,
                    Loads *loads, SurfaceDetail *out);

/* Writes into `out`, zeroed at first, what the candidates' points are presumed to press with; `patch` [n_patches], N/m:
 * what presume_force has for `before` with PRESUME_LAST; with PRESUME_LINE that is what `out` holds. Returns 0 without
 * memory; the free may follow either way. */
int surface_presume(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, const SurfacePairs *pairs,
                    const Presume *how, const double *patch, SurfacePresumed *out);
void surface_presumed_free(SurfacePresumed *presumed);
/* Raises patch [n_patches], N/m, to the mean of the springs' forces over those points of each that press. */
void surface_pressed(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, const SurfacePairs *pairs,
                     double *patch);

/* The chain has been renumbered: element e is now e + joined. Adds what `old` remembers of elements that are `now`'s;
 * to be called for all pairs of old and new halves. */
void surface_carry(const SurfacePairs *old, SurfacePairs *now, int joined);
/* Evaluations that follow are at t; and: a step to (t, kin) has been accepted, points that stick remember their lean.
 * Both are needed only where surface_sticks. */
void surface_clock(SurfacePairs *pairs, double t);
void surface_accept(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, double t,
                    SurfacePairs *pairs);

/* The candidates, and what sticks; n: segments. */
void surface_pairs_checkpoint(Checkpoint *c, SurfacePairs *pairs, int patches, int n);

/* Adds the derivatives of these forces to k and d, as contact_blocks does (DU11), (DU12), of elements from .. to-1
 * only. */
void surface_blocks(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, double friction_scale,
                    const SurfacePairs *pairs, int from, int to, BlockChain *k, BlockChain *d);

#endif
