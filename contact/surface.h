/* The shape of ducts, trays, floors and walls: patches, each one face of a cross-section that is swept along a straight
 * or an arc. docs/theory.md, "Surfaces". */
#ifndef HAWSER_CONTACT_SURFACE_H
#define HAWSER_CONTACT_SURFACE_H

#include "contact/facets.h"
#include "contact/law.h"
#include "contact/roller.h"
#include "contact/shape.h"
#include "core/block_chain.h"
#include "core/route.h"
#include "core/vec3.h"
#include "hawser/hawser.h"

typedef enum SurfaceKind { SURFACE_DUCT, SURFACE_FLAT, SURFACE_V, SURFACE_U, SURFACE_PLANE } SurfaceKind;

/* A surface as a user describes it. Cross-sections are seen along the route: y level to the left, z up, both normal to
 * the route, whose line is at the origin. */
typedef struct SurfaceShape {
    SurfaceKind kind;
    double from, to;           /* m along the route; not of planes */
    double fade;               /* m over which it begins and ends, half of it outside from .. to; > 0 */
    double cable_radius;       /* m, the largest: width of the bands in which sides end */
    double radius;             /* duct, U: inside, m */
    double lift;               /* duct: its centre above the route, m */
    double depth;              /* flat, V, U: the bottom (of V: of a cable of cable_radius in it) below the route, m */
    double width;              /* flat: m; plane: across `along`, 0: infinite */
    double height;             /* flat, V, U: top of the sides over the bottom, m; flat: 0 means no sides */
    double angle;              /* V: between its planes, rad */
    Vec3 point, normal, along; /* plane: m; unit, toward the cable; unit, normal to `normal` */
    double length;             /* plane: along `along`, m; 0: infinite */
} SurfaceShape;

/* SECTION_MESH has no section: its face k is the k-th nearest foot of a point on the facets of one law. */
typedef enum SectionKind { SECTION_TUBE, SECTION_TROUGH, SECTION_FLAT, SECTION_MESH } SectionKind;

/* A weight over one coordinate: 0 up to in0, STEP to 1 at in1; 1 up to out0, STEP to 0 at out1 (DU8). */
typedef struct SurfaceFade {
    int used; /* 0: the weight is 1 */
    double in0, in1, out0, out1;
} SurfaceFade;

typedef struct SurfacePatch {
    int surface, face; /* of its cross-section, below SURFACE_FACES_MAX */
    int law;           /* index of the model's friction law: as set by surface_patches the surface's number */
    /* the way: s runs along it from its start */
    double s0, length;   /* m along the route at the start (NAN: none); m, 0: infinite */
    Vec3 start, tangent; /* m; unit, at the start */
    Vec3 side, up;       /* unit; tangent, side, up are right-handed; a bend's centre lies to the side */
    double bend;         /* m, radius; 0: straight */
    Vec3 centre;         /* m, of the bend */
    Vec3 end, end_tangent;
    /* the roll of the section's y axis from the side: cubic from one end to the other (DU6) */
    int twisted;
    double roll[2];            /* rad */
    double roll_cos, roll_sin; /* if it does not change */
    /* the section */
    SectionKind section;
    double inner, lift;    /* tube, trough: m; the centre is at z = lift */
    double ny, nz, offset; /* flat: the distance is ny y + nz z + offset */
    SurfaceFade along;     /* over s */
    SurfaceFade across;    /* over vy y + vz z */
    double vy, vz;
    double depth; /* m: a point farther behind it is on its other side, without contact; INFINITY: it has no other
                   * side */
} SurfacePatch;

/* Number of patches of a surface, and the patches themselves, all for surface number `surface`. The route is not used
 * for planes. The shape must have been checked. */
int surface_patch_count(const SurfaceShape *shape, const Route *route);
void surface_patches(const SurfaceShape *shape, const Route *route, int surface, SurfacePatch *patch);
/* The SURFACE_FACES_MAX patches of one law of a mesh. */
void surface_mesh_patches(int surface, int law, SurfacePatch *patch);
/* A point's relation to a patch. */
typedef struct SurfaceProbe {
    double distance; /* m, from the surface (DU4); negative behind it */
    Vec3 normal;     /* unit, toward the free side (DU7) */
    double share;    /* 0..1: the weight of (DU8) */
    int owned;       /* the point belongs to this patch of its surface (DU3) */
} SurfaceProbe;

/* From the kernels' own function: for checks of cases, tests and tools. */
SurfaceProbe surface_probe(const SurfacePatch *patch, Vec3 p);
/* SurfacePatch.depth of a face that has another side, m. An infinite plane has none. */
#define SURFACE_DEPTH_MAX 0.2
/* m: largest distance of the arcs of a duct or tray from a curve of the route. */
#define SURFACE_WAY_OFF 5e-5
enum { SURFACE_WAY_MAX = 2 };

/* The part of the way that begins at *s and ends at `last` or before: patches without a section, each of whose ends is,
 * to the last bit, where the next one starts. Moves *s to the part's end. rolls: the section has a top, and needs the
 * roll that keeps it level. Returns the number of patches: two arcs for a part of a curve, else one. */
int surface_way(const Route *route, double *s, double last, int rolls, SurfacePatch way[SURFACE_WAY_MAX]);
/* The data of contact with surfaces, shared by surface.c and its kernels. docs/theory.md, "Surfaces". */

enum { SURFACE_POINTS = 2 }; /* Gauss points of an element (DU1) */

enum { SURFACE_FACES_MAX = FEET_MAX };

/* The points of a chain's line, by element e (chain arrays; bodies e-1 and e, a missing one has zero weight) (DU2). */
typedef struct SurfacePoints {
    double tip; /* m of cable in addition to its share at an end of the line (DU17) */
    int elements;
    double *alpha[SURFACE_POINTS];   /* of body e; that of body e-1 is 1 - alpha */
    double *beta[SURFACE_POINTS][2]; /* of the arms of e-1 and e */
    double *length[SURFACE_POINTS];  /* m of cable in the point's share */
    double *radius[SURFACE_POINTS];  /* contact radius there, m */
} SurfacePoints;

/* Data that never change during a run. */
typedef struct SurfaceModel {
    ImpactLaw impact; /* per metre of cable: k in N/m^e per m, c in N s/m per m */
    double reach;     /* m: as in ContactModel */
    int n_surfaces, n_patches;
    const Facets *facets; /* the environment that can be touched, borrowed; NULL: none */
    int n_laws;           /* of the facets, each a surface behind n_surfaces with SURFACE_FACES_MAX patches, the last */
    double skin;          /* m: lists of near triangles hold for this much motion (EN26) */
    const FrictionLaw *friction; /* by SurfacePatch.law, the surfaces' own first; borrowed */
    const SurfacePatch *patch;   /* [n_patches], by surface, then along the way, borrowed */
    const SurfacePoints *points; /* borrowed */
} SurfaceModel;

/* Candidates of one patch: elements first .. first + count - 1. */
typedef struct SurfaceRange {
    int patch, first, count;
} SurfaceRange;

/* State of friction that sticks on surfaces, kept between steps: the lean of each point's bristle against each face.
 * docs/theory.md, "Friction that sticks". The points are fixed on the cable, so a lean stays with its point; arrays
 * over elements, as the kernels need them. Part of a run's state, beside y, as StickStore is. */

/* One face of a surface that sticks. */
typedef struct SurfaceBed {
    double *lean[SURFACE_POINTS][3];  /* chain arrays, m, world: at the last accepted step; zero without contact */
    double *fresh[SURFACE_POINTS][3]; /* being collected for the next */
} SurfaceBed;

/* Presumed contact forces of the points, N per metre of cable (PS11): chain arrays by face, as SurfaceBed, for those
 * faces that have had a candidate. */
typedef struct SurfacePresumed {
    int n_beds;                     /* SURFACE_FACES_MAX for each surface */
    double *(*bed)[SURFACE_POINTS]; /* [n_beds] NULL where there is none */
} SurfacePresumed;

typedef struct SurfaceStick {
    double since, elapsed; /* s, as in StickStore */
    int n_beds;            /* SURFACE_FACES_MAX for each surface; 0: nothing sticks */
    SurfaceBed *bed;       /* [n_beds] those of surfaces that do not stick have no arrays */
} SurfaceStick;

/* The k-th nearest feet of the points of a chain's line, by element (chain arrays): by surface_feet. */
typedef struct SurfaceFoot {
    double *distance[SURFACE_POINTS]; /* m; INFINITY: there is none */
    double *law[SURFACE_POINTS];
    double *normal[SURFACE_POINTS][3], *gradient[SURFACE_POINTS][3];
    double *turn[SURFACE_POINTS][9]; /* 1/m, as Mat3 */
} SurfaceFoot;

/* Where the lists of near triangles were made: chain arrays. */
typedef struct SurfaceStand {
    double *point[SURFACE_POINTS][3];
    double *p[3], *a[3]; /* the segments, as in ContactPairs */
} SurfaceStand;

/* The triangles near each point (EN26), and the feet on them. */
typedef struct SurfaceNear {
    double usable;         /* m: the lists hold for so much motion */
    SurfaceStand stand;    /* from here on */
    int n, list_allocated; /* triangles in all lists */
    TriangleNear *list;    /* [n] by point */
    int *start;            /* point q of element e has list[start[k]] .. list[start[k+1]-1], k = 2 (e - from) + q */
    int starts_allocated;
    FacetNear *work; /* [work_allocated] */
    int work_allocated;
    SurfaceFoot foot[FEET_MAX];
} SurfaceNear;

/* The candidates among elements from .. to-1; by surface_refresh. */
typedef struct SurfacePairs {
    int from, to;
    int n_ranges, ranges_allocated;
    SurfaceRange *range; /* [n_ranges], by patch, then by element */
    int candidates;      /* pairs of element and patch */
    int active;          /* points that carried force in the last call of surface_forces with a tally */
    ContactTally work;   /* of the last call of surface_forces */
    SurfaceNear *near;   /* owned; NULL: nothing of a mesh can be touched, or surface_refresh is still to come */
    const SurfacePresumed *presumed; /* the law is a line about it; borrowed; NULL: the law itself applies */
    SurfaceStick stick; /* by surface_accept; beds by surface_pairs_sticks, none without friction that sticks */
} SurfacePairs;

/* Load of the cable on one surface. */
typedef struct SurfaceTally {
    Vec3 force;       /* N, on the surface */
    double normal;    /* N, sum of the normal forces' sizes */
    double friction;  /* N, sum of the friction forces' sizes */
    double line_load; /* N/m, the largest normal force of an element on a face over the element's length */
    double at;        /* m along the route, its place; NAN: no contact, or the surface is not along the route */
    int element;      /* that element */
} SurfaceTally;

/* ------------------------------------------------------------------- friction that sticks, for contact/surface.c */

void surface_stick_free(SurfaceStick *stick);
/* The kernels of contact/surface_lanes.c, once for every instruction set. */

/* Up to LANES consecutive elements against one patch. */
typedef struct SurfaceStrip {
    const SurfacePatch *patch;
    const ImpactLaw *impact;
    const FrictionLaw *friction;
    double friction_scale;
    const SurfacePoints *points;
    const Chain *chain;
    const Kinematics *kin;
    const SurfaceBed *bed;                  /* NULL: friction does not stick */
    double elapsed;                         /* s, with a bed */
    const SurfaceFoot *foot;                /* of a mesh's patch; NULL: a swept one */
    const double *presumed[SURFACE_POINTS]; /* N/m, by element (PS11); NULL: the law itself */
    int first, count;                       /* elements first .. first + count - 1 */
} SurfaceStrip;

/* The forces of a strip, point by point; zeros without contact. */
typedef struct SurfacePush {
    _Alignas(64) double force[SURFACE_POINTS][3][LANES]; /* N, on the cable */
    double normal[SURFACE_POINTS][LANES];                /* N */
    double along[SURFACE_POINTS][LANES];                 /* m, s of the point from the patch's start */
} SurfacePush;

typedef struct SurfaceKernels {
    /* Adds a strip's forces and moments to loads, and their work to `work`; returns whether any point is in contact.
     * out: NULL, or written if so. */
    int (*push)(const SurfaceStrip *strip, Loads *loads, SurfacePush *out, ContactTally *work);
    /* The derivatives of a strip's forces; returns 0, and writes nothing, without contact. Bodies 0 and 1 of lane l are
     * the segments before and after element first + l. */
    int (*columns)(const SurfaceStrip *strip, ContactMatrix *k, ContactMatrix *d);
    /* near[l]: 1 if a point of the element is within reach (m) of the patch (DU13). */
    void (*near)(const SurfaceStrip *strip, double reach, int near[LANES]);
    /* m, by point; INFINITY where it does not belong to this patch. */
    void (*gaps)(const SurfaceStrip *strip, double gap[SURFACE_POINTS][LANES]);
    /* Adds the leans of the bristles to the bed's fresh arrays, for the case that the step ends here. */
    void (*keep)(const SurfaceStrip *strip);
    void (*probe)(const SurfacePatch *patch, Vec3 p, SurfaceProbe *out);
} SurfaceKernels;

ISA_KERNELS(SurfaceKernels, surface_kernels)

/* Contact between the cable's line and surfaces that bear it along a length: ducts, trays, floors, walls.
 * docs/theory.md, "Surfaces".
 *
 * Unlike a roller, which the line touches where it comes nearest, a surface acts at fixed points of every element of
 * the line, each with a share of the cable's length (DU1): its stiffness does not depend on how the cable is cut.
 *
 * A surface is made of patches: one for each piece of the way along which it runs (a straight, or at most a quarter of
 * a bend) and each face of its cross-section. Life as in contact/roller.h: alloc -> refresh -> forces and blocks, any
 * number of times, until contact_moved_too_far. Nothing is searched between two refreshes. */

/* Creates the points of a chain (lengths and radii, and points->tip, must be set). Returns 0 without memory (nothing is
 * left allocated). */
int surface_points_alloc(SurfacePoints *points, ContactGeometry geometry, const Chain *chain);
void surface_points_free(SurfacePoints *points);
/* Initialises elements from .. to-1, without candidates: allocates nothing. The free may be called on a zeroed
 * struct. */
void surface_pairs_init(SurfacePairs *pairs, int from, int to);
void surface_pairs_free(SurfacePairs *pairs);
/* Creates beds for the surfaces whose friction sticks, for a chain of n segments; surface_sticks checks whether there
 * are any. Returns 0 without memory. */
int surface_sticks(const SurfaceModel *model);
int surface_pairs_sticks(SurfacePairs *pairs, const SurfaceModel *model, int n);
/* Finds the candidates: all elements with a point within reach of a patch (DU13), in O(n + patches n / 32 + candidates)
 * operations. Errors: HAWSER_ERR_MEMORY. The only call that may allocate. */
hawser_status surface_refresh(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, SurfacePairs *pairs,
                              hawser_error *err);
/* Adds forces (N) and moments (N m) on the segments to loads (its ghosts are overwritten) (DU9), (DU10). friction_scale
 * multiplies every friction coefficient. tally[n_surfaces] (NULL: not required) is added to: set it by
 * surface_tally_new first. */
void surface_forces(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, double friction_scale,
                    SurfacePairs *pairs, Loads *loads, SurfaceTally *tally);
SurfaceTally surface_tally_new(void);
/* Point q of element e of the line, m (DU2). */
Vec3 surface_point(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, int e, int q);
/* Adds element e as a candidate of a patch. 0 without memory. */
int surface_candidate_add(SurfacePairs *pairs, int patch, int e);
/* Lists of near triangles for the kinematics (EN26), with candidates for the patches of the mesh; part of
 * surface_refresh. 0 without memory. */
int surface_near_refresh(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, SurfacePairs *pairs);
/* Checks whether a point may have moved farther than the lists allow. */
int surface_near_stale(const Chain *chain, const Kinematics *kin, const SurfacePairs *pairs);
/* Finds the feet of the points of elements from .. to-1 up to `beyond` (m) farther than their radius. */
void surface_feet(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, const SurfacePairs *pairs,
                  int from, int to, double beyond);
/* Creates empty lists for elements of a chain of n segments; NULL without memory. The free accepts NULL. */
SurfaceNear *surface_near_new(int n);
SurfaceNear *surface_near_free(SurfaceNear *near);
void surface_near_checkpoint(Checkpoint *c, const SurfaceModel *model, SurfacePairs *pairs, int n);
/* One point of the line in contact with a surface, for tools and reports. */
typedef struct SurfaceDetail {
    int surface, element, point_number;
    double normal, gap; /* N; m, below 0 */
    Vec3 point, toward; /* m, on the line; unit, toward the cable */
    Vec3 force;         /* N, on the cable */
} SurfaceDetail;

/* Writes all that carry force, at most SURFACE_POINTS for each candidate; returns their number. loads are scratch. */
int surface_details(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, const SurfacePairs *pairs,
                    Loads *loads, SurfaceDetail *out);
/* Writes the presumed forces of the candidates' points into `out`, zeroed at first; `patch` [n_patches], N/m: `before`
 * in presume_force with PRESUME_LAST; with PRESUME_LINE that is the content of `out`. Returns 0 without memory; the
 * free may follow either way. */
int surface_presume(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, const SurfacePairs *pairs,
                    const Presume *how, const double *patch, SurfacePresumed *out);
void surface_presumed_free(SurfacePresumed *presumed);
/* Raises patch [n_patches], N/m, to the mean of the springs' forces over its points in contact. */
void surface_pressed(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, const SurfacePairs *pairs,
                     double *patch);
/* Moves leans after the chain was renumbered: element e is now e + joined. Adds those of `old` for elements that belong
 * to `now`; must be called for all pairs of old and new halves. */
void surface_carry(const SurfacePairs *old, SurfacePairs *now, int joined);
/* Sets the time t of the following evaluations; accepts a step to (t, kin) and stores the leans of points that stick.
 * Both are needed only if surface_sticks. */
void surface_clock(SurfacePairs *pairs, double t);
void surface_accept(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, double t,
                    SurfacePairs *pairs);
/* Saves or loads the candidates and the leans; n: segments. */
void surface_pairs_checkpoint(Checkpoint *c, const SurfaceModel *model, SurfacePairs *pairs, int n);
/* Adds the derivatives of these forces to k and d, as contact_blocks does (DU11), (DU12), of elements from .. to-1
 * only. */
void surface_blocks(const SurfaceModel *model, const Chain *chain, const Kinematics *kin, double friction_scale,
                    const SurfacePairs *pairs, int from, int to, BlockChain *k, BlockChain *d);

#endif
