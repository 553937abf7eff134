/* What surface_lanes.c and surface_blocks_lanes.c offer to surface.c, once for every instruction set. */
#ifndef HAWSER_CONTACT_SURFACE_SURFACE_KERNELS_H
#define HAWSER_CONTACT_SURFACE_SURFACE_KERNELS_H

#include "contact/roller/contact_kernels.h"
#include "contact/surface/surface_data.h"

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
    const double *presumed[SURFACE_POINTS]; /* N/m, by element (PS11); NULL: the law itself */
    int first, count;                       /* elements first .. first + count - 1 */
} SurfaceStrip;

/* The forces of a strip, point by point; zeros where nothing touches. */
typedef struct SurfacePush {
    _Alignas(64) double force[SURFACE_POINTS][3][LANES]; /* N, on the cable */
    double normal[SURFACE_POINTS][LANES];                /* N */
    double along[SURFACE_POINTS][LANES];                 /* m, s of the point from the patch's start */
} SurfacePush;

typedef struct SurfaceKernels {
    /* Adds a strip's forces and moments to loads, and what they do to work; returns whether any point touches. out:
     * NULL, or written if so. */
    int (*push)(const SurfaceStrip *strip, Loads *loads, SurfacePush *out, ContactTally *work);
    /* The derivatives of a strip's forces; returns 0, and writes nothing, if no point touches. Bodies 0 and 1 of lane l
     * are the segments before and after element first + l. */
    int (*columns)(const SurfaceStrip *strip, ContactMatrix *k, ContactMatrix *d);
    /* near[l]: whether a point of the element comes within reach (m) of the patch (DU13). */
    void (*near)(const SurfaceStrip *strip, double reach, int near[LANES]);
    /* m, by point; INFINITY where it is not this patch's. */
    void (*gaps)(const SurfaceStrip *strip, double gap[SURFACE_POINTS][LANES]);
    /* Adds to the bed's fresh arrays how far the bristles lean, should the step end here. */
    void (*keep)(const SurfaceStrip *strip);
    void (*probe)(const SurfacePatch *patch, Vec3 p, SurfaceProbe *out);
} SurfaceKernels;

ISA_KERNELS(SurfaceKernels, surface_kernels)

#endif
