/* Shapes that the cable can touch, as signed distance functions. docs/theory.md, "Contact", "Grooved rollers", "Boxes,
 * edges and bell-mouths".
 *
 * A further kind needs: its data in Shape, its distance and its form in shape_probe.c, and its function over lanes,
 * called in shape_lanes.h. Candidates are sorted by kind and a batch of contacts holds one kind only, so kinds never
 * mix inside a kernel. */
#ifndef HAWSER_CONTACT_SHAPE_H
#define HAWSER_CONTACT_SHAPE_H

#include "core/chain.h"
#include "core/vec3.h"

typedef enum ShapeKind { SHAPE_CYLINDER, SHAPE_V_GROOVE, SHAPE_U_GROOVE, SHAPE_BOX, SHAPE_BELL } ShapeKind;

enum { SHAPE_KINDS = 5 };

/* The groove around the middle of a roller; beyond its lips the roller is a cylinder of radius + depth (GR1). */
typedef struct Groove {
    double depth;        /* m, from the lips down to the bottom */
    double lip;          /* m, half the groove's width between the lips */
    double cosine, sine; /* V: of half the groove's angle. U: of the angle of the arc from bottom to lip */
    double radius;       /* m, U: of the arc */
} Groove;

/* A box's section across its axis; its edges and corners are rounded. An edge radius of half its thickness makes it a
 * round bar. */
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

/* Grooves by the dimensions on a drawing: a V by half its angle (rad, between 0 and pi/2), a U by the radius of its
 * section (m), which is at least its depth (m). */
Groove groove_v(double half_angle, double depth);
Groove groove_u(double radius, double depth);
/* Lateral force that a groove bears per newton down into it, without friction: the tangent of its steepest flank,
 * INFINITY for an upright one; 0: that kind has no groove. */
double groove_flank(ShapeKind kind, const Groove *groove);
/* The kernels' data of a kind beside centre, axis, radius and half width: the members of its form in the order of its
 * lanes (shape_lanes.h), for one face. */
enum { SHAPE_FORM = 6 };

void shape_form(const Shape *shape, int face, double form[SHAPE_FORM]);
/* A point's relation to a shape. */
typedef struct ShapeProbe {
    double distance; /* m to the surface, negative inside */
    Vec3 normal;     /* its gradient: unit, away from the shape (zero on a cylinder's axis) */
    Mat3 hessian;    /* its second derivatives, 1/m; one-sided where they jump */
} ShapeProbe;

/* Number of faces of a shape that the cable touches one by one: the flanks of a V are two. Face 0 is the one toward
 * +axis, or the only one. */
int shape_faces(ShapeKind kind);
/* Signed distance of point p to one face with the body behind it, m (C7), (GR2)-(GR4). */
double shape_face_distance(const Shape *shape, int face, Vec3 p);
/* The same to the whole shape: to its nearest face. */
double shape_distance(const Shape *shape, Vec3 p);
/* Distance of a face with both derivatives (C7), (C8), (GR5), from the kernels' own function: for tests and tools. */
ShapeProbe shape_probe(const Shape *shape, int face, Vec3 p);
/* Distance from the axis at which a straight cable of this radius (m) rests across the middle of the shape, m (GR6). */
double shape_seat(const Shape *shape, double cable_radius);
/* The cable's contact line, cut into elements of at most two segments. docs/theory.md, "Contact line".
 *
 * smooth:   n+1 elements, numbered like the joints: element j is the arc from the centre of segment j-1 to
 * that of segment j; element 0 is the tail's half segment, element n the head's. cylinder: n elements:
 * element i is the axis of segment i, from end to end. */

typedef enum ContactGeometry { GEOMETRY_SMOOTH, GEOMETRY_CYLINDER } ContactGeometry;

/* The segments of an element, and their weights (C2), (C3) as functions of its parameter u in [0, 1]:
 *    alpha_1 = arc u^2 (3 - 2u) + alpha, alpha_0 = 1 - alpha_1
 *    beta_0 = arc 2 u (1-u)^2 + beta[0][0] + beta[0][1] u
 *    beta_1 = -arc 2 u^2 (1-u) + beta[1][0] + beta[1][1] u */
typedef struct Element {
    int body[2]; /* segments; an index outside 0..n-1 means none (its weights are zero) */
    double arc, alpha;
    double beta[2][2];
} Element;

int element_count(ContactGeometry geometry, int n);
/* Element e of a chain of n segments, 0 <= e < element_count. */
Element element_at(ContactGeometry geometry, int n, int e);
/* The weights of an element's two segments, or their derivatives by u. */
typedef struct LineWeights {
    double alpha[2], beta[2];
} LineWeights;

/* (C2), (C3) at u. */
LineWeights element_weights(const Element *element, double u);
/* Contact radius there, m (C4). */
double element_radius(const Element *element, const Chain *chain, double u);
/* A sphere that holds the element with its contact radius (C18): centre and radius, m. */
typedef struct Sphere {
    Vec3 centre;
    double radius;
} Sphere;

Sphere element_sphere(const Element *element, const Chain *chain, const Kinematics *kin);
/* Stores the centres and axes (chain arrays); the second checks whether a point of the line may since have moved
 * farther than `limit`, m (C20). */
void line_stand(const Kinematics *kin, int n, double *const at_p[3], double *const at_a[3]);
int line_moved(const Chain *chain, const Kinematics *kin, double *const at_p[3], double *const at_a[3], double limit);
/* A binary tree of spheres over the elements, in their order: the chain's own order is the spatial order, so nothing is
 * sorted. Children of node i are 2i and 2i + 1. docs/theory.md, "Candidates". */
typedef struct SphereTree {
    int leaves;   /* power of two >= elements */
    Sphere *node; /* [2 leaves]; node[leaves + e] is element e's (C18); a negative radius: nothing there */
} SphereTree;

/* Makes room for the elements of chains of n segments; 0 if there is no memory. */
int sphere_tree_alloc(SphereTree *tree, int n);
void sphere_tree_free(SphereTree *tree);
/* Builds spheres around the elements at their present places, and around runs of them (C19). */
void sphere_tree_build(SphereTree *tree, ContactGeometry geometry, const Chain *chain, const Kinematics *kin);
/* ------------------------------------------------------------------- the smooth line at one place */

/* A point of the line with everything that a contact between two cables needs. */
typedef struct LineSpot {
    int body[2];                 /* segments; outside 0..n-1: none, with zero weight */
    LineWeights weight, weight1; /* and their first derivatives */
    Vec3 p, p1, p2;              /* the line and its derivatives by the parameter, m */
    double radius, radius1;      /* contact radius and its derivative, m */
} LineSpot;

/* Element e of the smooth line at parameter u in [0, 1]. */
LineSpot line_spot(const Chain *chain, const Kinematics *kin, int e, double u);
/* Half the slope of the squared distance from p at segment i's centre: positive where the line moves away from p. i =
 * -1 and i = n are beyond the line's ends, where the distance always grows. */
double line_slope(const Chain *chain, const Kinematics *kin, int i, Vec3 p);
/* The parameter of element e that is nearest to p, where line_slope is negative before the element and not behind it
 * (CC1). *inside: 0 if it is clamped at the line's end. */
double line_foot(const Chain *chain, const Kinematics *kin, int e, Vec3 p, int *inside);

#endif
