/* What the points of the line remember between steps where friction on surfaces sticks: the lean of each point's
 * bristle against each face. docs/model.md, "Friction that sticks". The points are fixed on the cable, so a lean stays
 * with its point; arrays over elements, as the kernels want them. Part of a run's state, beside y, as StickStore is. */
#ifndef HAWSER_CONTACT_SURFACE_SURFACE_STICK_H
#define HAWSER_CONTACT_SURFACE_SURFACE_STICK_H

enum { SURFACE_POINTS = 2 }; /* Gauss points of an element (DU1) */
enum { SURFACE_FACES_MAX = 3 };

/* One face of a surface that sticks. */
typedef struct SurfaceBed {
    double *lean[SURFACE_POINTS][3]; /* chain arrays, m, world: at the last accepted step; zero where nothing touched */
    double *fresh[SURFACE_POINTS][3]; /* being collected for the next */
} SurfaceBed;

typedef struct SurfaceStick {
    double since, elapsed; /* s, as in StickStore */
    int n_beds;            /* SURFACE_FACES_MAX for each surface; 0: nothing sticks */
    SurfaceBed *bed;       /* [n_beds] those of surfaces that do not stick have no arrays */
} SurfaceStick;

/* Beds for a chain of n segments; sticks[n_surfaces] says which surfaces stick. Returns 0 without memory (what is there
 * stays for the free, which may be called on a zeroed struct). */
int surface_stick_alloc(SurfaceStick *stick, int n, int n_surfaces, const int *sticks);
void surface_stick_free(SurfaceStick *stick);

/* Nothing collected yet, for elements from .. to-1. */
void surface_stick_begin(SurfaceStick *stick, int from, int to);
/* A step to t has been accepted: what was collected is what is remembered. */
void surface_stick_accept(SurfaceStick *stick, double t);

#endif
