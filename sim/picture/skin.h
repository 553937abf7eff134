/* A surface of triangles that grows piece by piece: rows of points that are joined to nets, and boxes. */
#ifndef HAWSER_SIM_PICTURE_SKIN_H
#define HAWSER_SIM_PICTURE_SKIN_H

#include "core/base/vec3.h"

/* What a triangle is of. */
typedef enum SkinPart { SKIN_ROLLER, SKIN_SURFACE, SKIN_CONVEYOR, SKIN_REEL } SkinPart;

typedef struct Skin {
    int n_points, n_triangles;
    double *points; /* [3 n_points] m */
    int *triangle;  /* [3 n_triangles] points, counter-clockwise seen from outside */
    int *part;      /* [n_triangles] a SkinPart */
    int *item;      /* [n_triangles] which roller, surface, ... */
    int room_points, room_triangles;
    int failed; /* no memory: nothing more is added */
    SkinPart now_part;
    int now_item;
} Skin;

/* A cross-section (y, z) of m points, closed or not, carried along n places with their own axes y and z. */
typedef struct SkinPlace {
    Vec3 middle, y, z;
    double scale; /* of the section here */
} SkinPlace;

void skin_begin(Skin *m, SkinPart part, int item);
void skin_sweep(Skin *m, int n, const SkinPlace *place, int count, const double (*section)[2], int closed);
/* A solid of revolution: n points of (m along the axis from the centre, m from it). */
void skin_turn(Skin *m, Vec3 centre, Vec3 axis, int n, const double (*profile)[2]);
/* A box with three half sizes, m, along three unit vectors. */
void skin_box(Skin *m, Vec3 centre, const Vec3 axis[3], const double half[3]);
void skin_free(Skin *m);

#endif
