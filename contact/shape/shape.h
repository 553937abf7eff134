/* Shapes that the cable can touch, as signed distance functions. docs/model.md, "Contact", "Grooved rollers", "Boxes,
 * edges and bell-mouths".
 *
 * A further kind needs: its data in Shape, its distance and its form in shape_probe.c, and its function over lanes,
 * which kinds_lanes.h calls. Candidates are sorted by kind and a batch of contacts holds one kind only, so kinds never
 * mix inside a kernel. */
#ifndef HAWSER_CONTACT_SHAPE_SHAPE_H
#define HAWSER_CONTACT_SHAPE_SHAPE_H

#include "core/base/vec3.h"

typedef enum ShapeKind { SHAPE_CYLINDER, SHAPE_V_GROOVE, SHAPE_U_GROOVE, SHAPE_BOX, SHAPE_BELL } ShapeKind;
enum { SHAPE_KINDS = 5 };

/* The groove around the middle of a roller; beyond its lips the roller is a cylinder of radius + depth (GR1). */
typedef struct Groove {
    double depth;        /* m, from the lips down to the bottom */
    double lip;          /* m, half the groove's width between the lips */
    double cosine, sine; /* V: of half the groove's angle. U: of the angle of the arc from bottom to lip */
    double radius;       /* m, U: of the arc */
} Groove;

/* A box's section across its axis; its edges and corners are rounded. An edge radius of half its thickness makes a
 * round bar of it. */
typedef struct BoxSection {
    Vec3 side;      /* unit, square to the axis */
    double half[2]; /* m, half sizes along `side` and along axis x side */
    double edge;    /* m, > 0, at most the smallest half size */
} BoxSection;

/* A bell-mouth's ring: from the axis to the middle of its round section; the flare begins at ring - radius (OB4). */
typedef struct BellRing {
    double ring; /* m */
} BellRing;

/* A finite solid: a cylinder, grooved or not, a box or a bell-mouth. */
typedef struct Shape {
    ShapeKind kind;
    Vec3 centre;       /* m */
    Vec3 axis;         /* unit */
    double radius;     /* m; grooved: at the groove's bottom; box: its smallest half size; bell-mouth: of its section */
    double half_width; /* m, half the length along the axis */
    union {
        Groove groove; /* of the grooved kinds */
        BoxSection box;
        BellRing bell;
    };
} Shape;

/* Grooves by what a drawing says: a V by half its angle (rad, between 0 and pi/2), a U by the radius of its section
 * (m), which is at least its depth (m). */
Groove groove_v(double half_angle, double depth);
Groove groove_u(double radius, double depth);
/* How much force to the side a groove bears for each newton down into it, without friction: the tangent of its
 * steepest flank, INFINITY of one that stands upright; 0: that kind has no groove. */
double groove_flank(ShapeKind kind, const Groove *groove);

/* What the kernels know of a kind beside centre, axis, radius and half width: the members of its form in the order of
 * its lanes (kinds_lanes.h), for one face. */
enum { SHAPE_FORM = 6 };
void shape_form(const Shape *shape, int face, double form[SHAPE_FORM]);

/* A point's relation to a shape. */
typedef struct ShapeProbe {
    double distance; /* m to the surface, negative inside */
    Vec3 normal;     /* its gradient: unit, away from the shape (zero on a cylinder's axis) */
    Mat3 hessian;    /* its second derivatives, 1/m; one-sided where they jump */
} ShapeProbe;

/* How many faces a shape has that the cable touches one by one: the flanks of a V are two. Face 0 is the one toward
 * +axis, or the only one. */
int shape_faces(ShapeKind kind);
/* Signed distance of point p to one face with all that is behind it, m (C7), (GR2)-(GR4). */
double shape_face_distance(const Shape *shape, int face, Vec3 p);
/* The same to the whole shape: to its nearest face. */
double shape_distance(const Shape *shape, Vec3 p);
/* Distance of a face with both derivatives (C7), (C8), (GR5), from the kernels' own function: for tests and tools. */
ShapeProbe shape_probe(const Shape *shape, int face, Vec3 p);

/* Distance from the axis at which a straight cable of this radius (m) lies across the middle of the shape, m (GR6). */
double shape_seat(const Shape *shape, double cable_radius);

#endif
