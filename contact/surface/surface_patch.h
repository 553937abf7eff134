/* The shape of ducts, trays, floors and walls: patches, each one face of a cross-section that is swept along a straight
 * or an arc. docs/model.md, "Surfaces". */
#ifndef HAWSER_CONTACT_SURFACE_SURFACE_PATCH_H
#define HAWSER_CONTACT_SURFACE_SURFACE_PATCH_H

#include "core/base/vec3.h"
#include "core/route.h"

typedef enum SurfaceKind { SURFACE_DUCT, SURFACE_FLAT, SURFACE_V, SURFACE_U, SURFACE_PLANE } SurfaceKind;

/* A surface as a user describes it. Cross-sections are seen along the route: y level to the left, z up, both square to
 * the route, whose line is at the origin. */
typedef struct SurfaceShape {
    SurfaceKind kind;
    double from, to;           /* m along the route; not of planes */
    double fade;               /* m over which it begins and ends, half of them outside from .. to; > 0 */
    double cable_radius;       /* m, the largest: bands in which sides end */
    double radius;             /* duct, U: inside, m */
    double lift;               /* duct: its centre above the route, m */
    double depth;              /* flat, V, U: the bottom (of V: of a cable of cable_radius in it) below the route, m */
    double width;              /* flat: m; plane: across `along`, 0: without end */
    double height;             /* flat, V, U: top of the sides over the bottom, m; flat: 0 is no sides */
    double angle;              /* V: between its planes, rad */
    Vec3 point, normal, along; /* plane: m; unit, toward the cable; unit, square to the normal */
    double length;             /* plane: along `along`, m; 0: without end */
} SurfaceShape;

typedef enum SectionKind { SECTION_TUBE, SECTION_TROUGH, SECTION_FLAT } SectionKind;

/* A weight over one coordinate: 0 up to in0, STEP to 1 at in1; 1 up to out0, STEP to 0 at out1 (DU8). */
typedef struct SurfaceFade {
    int used; /* 0: the weight is 1 */
    double in0, in1, out0, out1;
} SurfaceFade;

typedef struct SurfacePatch {
    int surface, face; /* of its cross-section, below SURFACE_FACES_MAX (surface_data.h) */
    int law;           /* which of the model's friction laws: by surface_patches the surface's number */
    /* the way: s runs along it from its start */
    double s0, length;   /* m along the route at the start (NAN: none); m, 0: without end */
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
    double depth; /* m: what is farther behind it is on its other side and does not touch it; INFINITY: it has none */
} SurfacePatch;

/* How many patches a surface has, and the patches themselves, all for surface number `surface`. The route is not used
 * for planes. The shape must have been checked. */
int surface_patch_count(const SurfaceShape *shape, const Route *route);
void surface_patches(const SurfaceShape *shape, const Route *route, int surface, SurfacePatch *patch);

/* A point's relation to a patch. */
typedef struct SurfaceProbe {
    double distance; /* m, from the surface (DU4); negative behind it */
    Vec3 normal;     /* unit, toward the free side (DU7) */
    double share;    /* 0..1: the weight of (DU8) */
    int owned;       /* the point belongs to this patch of its surface (DU3) */
} SurfaceProbe;
/* From the kernels' own function: for checks of cases, tests and tools. */
SurfaceProbe surface_probe(const SurfacePatch *patch, Vec3 p);

/* SurfacePatch.depth of what has another side, m. A plane without ends has none. */
#define SURFACE_DEPTH_MAX 0.2

/* m: how far the arcs of a duct or tray may lie beside a curve of the route. */
#define SURFACE_WAY_OFF 5e-5

enum { SURFACE_WAY_MAX = 2 };

/* The part of the way that begins at *s and ends at `last` or before: patches without a section, each of whose ends is,
 * to the last bit, where the next one starts. Moves *s to the part's end. rolls: the section has a top, and needs the
 * roll that keeps it level. Returns how many patches: two arcs for a part of a curve, else one. */
int surface_way(const Route *route, double *s, double last, int rolls, SurfacePatch way[SURFACE_WAY_MAX]);

#endif
