/* Shapes that the cable can touch, as signed distance functions. docs/model.md, "Contact".
 *
 * A further kind (plane, trough, duct, drum) needs: its data in Shape, its distance in shape.c and its
 * function over lanes in shape_lanes.h. A batch of contacts holds one kind only, so kinds never mix inside a
 * kernel. */
#ifndef HAWSER_CONTACT_SHAPE_H
#define HAWSER_CONTACT_SHAPE_H

#include "core/vec3.h"

typedef enum ShapeKind { SHAPE_CYLINDER } ShapeKind;

/* A finite solid cylinder. */
typedef struct Shape {
    ShapeKind kind;
    Vec3 centre;       /* m */
    Vec3 axis;         /* unit */
    double radius;     /* m */
    double half_width; /* m, half the cylinder's length */
} Shape;

/* A point's relation to a shape. */
typedef struct ShapeProbe {
    double distance; /* m to the surface, negative inside */
    Vec3 normal;     /* its gradient: unit, away from the shape (zero on a cylinder's axis) */
    Mat3 hessian;    /* its second derivatives, 1/m; one-sided where they jump */
} ShapeProbe;

/* Signed distance of point p to the surface, m (C7). */
double shape_distance(const Shape *shape, Vec3 p);
/* The same with both derivatives (C7), (C8), from the kernels' own function: for tests and tools. */
ShapeProbe shape_probe(const Shape *shape, Vec3 p);

#endif
