/* The data of contact with surfaces, shared by surface.c and its kernels. docs/model.md, "Surfaces". */
#ifndef HAWSER_CONTACT_SURFACE_SURFACE_DATA_H
#define HAWSER_CONTACT_SURFACE_SURFACE_DATA_H

#include "contact/law/contact_law.h"
#include "contact/shape/element.h"
#include "contact/surface/surface_patch.h"
#include "core/block_chain.h"
#include "hawser/hawser.h"

enum { SURFACE_POINTS = 2 }; /* Gauss points of an element (DU1) */
enum { SURFACE_FACES_MAX = 3 };

/* The points of a chain's line, by element e (chain arrays; bodies e-1 and e, a missing one has no weight) (DU2). */
typedef struct SurfacePoints {
    double tip; /* m of cable that an end of the line stands for besides its share (DU17) */
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
    const FrictionLaw *friction; /* by SurfacePatch.law, the surfaces' own first; borrowed */
    const SurfacePatch *patch;   /* [n_patches], by surface, then along the way, borrowed */
    const SurfacePoints *points; /* borrowed */
} SurfaceModel;

/* Candidates of one patch: elements first .. first + count - 1. */
typedef struct SurfaceRange {
    int patch, first, count;
} SurfaceRange;

/* What the points of the line remember between steps where friction on surfaces sticks: the lean of each point's
 * bristle against each face. docs/model.md, "Friction that sticks". The points are fixed on the cable, so a lean stays
 * with its point; arrays over elements, as the kernels want them. Part of a run's state, beside y, as StickStore is. */

/* One face of a surface that sticks. */
typedef struct SurfaceBed {
    double *lean[SURFACE_POINTS][3]; /* chain arrays, m, world: at the last accepted step; zero where nothing touched */
    double *fresh[SURFACE_POINTS][3]; /* being collected for the next */
} SurfaceBed;

/* What the points are presumed to press with, N for each metre of cable (PS11): chain arrays by face, as SurfaceBed, of
 * those faces that have had a candidate. */
typedef struct SurfacePresumed {
    int n_beds;                     /* SURFACE_FACES_MAX for each surface */
    double *(*bed)[SURFACE_POINTS]; /* [n_beds] NULL where there is none */
} SurfacePresumed;

typedef struct SurfaceStick {
    double since, elapsed; /* s, as in StickStore */
    int n_beds;            /* SURFACE_FACES_MAX for each surface; 0: nothing sticks */
    SurfaceBed *bed;       /* [n_beds] those of surfaces that do not stick have no arrays */
} SurfaceStick;

/* The candidates among elements from .. to-1; by surface_refresh. */
typedef struct SurfacePairs {
    int from, to;
    int n_ranges, ranges_allocated;
    SurfaceRange *range;             /* [n_ranges], by patch, then by element */
    int candidates;                  /* pairs of element and patch */
    int active;                      /* points that carried force in the last call of surface_forces with a tally */
    ContactTally work;               /* of the last call of surface_forces */
    const SurfacePresumed *presumed; /* the law is a line about it; borrowed; NULL: it is the law itself */
    SurfaceStick stick; /* by surface_accept; beds by surface_pairs_sticks, none without friction that sticks */
} SurfacePairs;

/* What the cable does to one surface. */
typedef struct SurfaceTally {
    Vec3 force;       /* N, on the surface */
    double normal;    /* N, sum of the normal forces' sizes */
    double friction;  /* N, sum of the friction forces' sizes */
    double line_load; /* N/m, the largest normal force of an element on a face over the element's length */
    double at; /* m along the route, where that is; NAN: nothing touches, or the surface is not along the route */
} SurfaceTally;

/* ------------------------------------------------------------------- surface_stick.c, for surface.c */

void surface_stick_free(SurfaceStick *stick);
/* Nothing collected yet, for elements from .. to-1. */
void surface_stick_begin(SurfaceStick *stick, int from, int to);
/* A step to t has been accepted: what was collected is what is remembered. */
void surface_stick_accept(SurfaceStick *stick, double t);

#endif
