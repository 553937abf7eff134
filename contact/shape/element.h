/* The cable's contact line, cut into elements of at most two segments. docs/model.md, "Contact line".
 *
 * smooth:   n+1 elements, numbered like the joints: element j is the arc from the centre of segment j-1 to
 * that of segment j; element 0 is the tail's half segment, element n the head's. cylinder: n elements:
 * element i is the axis of segment i, from end to end. */
#ifndef HAWSER_CONTACT_SHAPE_ELEMENT_H
#define HAWSER_CONTACT_SHAPE_ELEMENT_H

#include "core/base/vec3.h"
#include "core/chain.h"

typedef enum ContactGeometry { GEOMETRY_SMOOTH, GEOMETRY_CYLINDER } ContactGeometry;

/* Which segments carry an element, and its weights (C2), (C3) as functions of its parameter u in [0, 1]:
 *   alpha_1 = arc u^2 (3 - 2u) + alpha,             alpha_0 = 1 - alpha_1
 *   beta_0  = arc 2 u (1-u)^2  + beta[0][0] + beta[0][1] u
 *   beta_1  = -arc 2 u^2 (1-u) + beta[1][0] + beta[1][1] u */
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

/* Takes down where the centres and axes are (chain arrays); and whether a point of the line may since have moved
 * farther than `limit`, m (C20). */
void line_stand(const Kinematics *kin, int n, double *const at_p[3], double *const at_a[3]);
int line_moved(const Chain *chain, const Kinematics *kin, double *const at_p[3], double *const at_a[3], double limit);

/* A binary tree of spheres over the elements, in their order: the chain's own order is the spatial order, so nothing is
 * sorted. Children of node i are 2i and 2i + 1. docs/model.md, "Which pairs are looked at". */
typedef struct SphereTree {
    int leaves;   /* power of two >= elements */
    Sphere *node; /* [2 leaves]; node[leaves + e] is element e's (C18); a negative radius: nothing there */
} SphereTree;

/* Room for the elements of chains of n segments; 0 if there is no memory. */
int sphere_tree_alloc(SphereTree *tree, int n);
void sphere_tree_free(SphereTree *tree);
/* Spheres around the elements where they are now, and around runs of them (C19). */
void sphere_tree_build(SphereTree *tree, ContactGeometry geometry, const Chain *chain, const Kinematics *kin);

/* ------------------------------------------------------------------- the smooth line at one place (line_spot.c) */

/* A point of the line with everything that a contact between two cables needs of it. */
typedef struct LineSpot {
    int body[2];                 /* segments; outside 0..n-1: none, with no weight */
    LineWeights weight, weight1; /* and their first derivatives */
    Vec3 p, p1, p2;              /* the line and its derivatives by the parameter, m */
    double radius, radius1;      /* contact radius and its derivative, m */
} LineSpot;

/* Element e of the smooth line at parameter u in [0, 1]. */
LineSpot line_spot(const Chain *chain, const Kinematics *kin, int e, double u);

/* Half the slope of the squared distance from p at segment i's centre: positive where the line runs away from p. i = -1
 * and i = n stand for what is beyond the line's ends, where it always recedes. */
double line_slope(const Chain *chain, const Kinematics *kin, int i, Vec3 p);

/* The parameter of element e that is nearest to p, where line_slope is negative before the element and not behind it
 * (CC1). *inside: 0 if it is held at the line's end. */
double line_foot(const Chain *chain, const Kinematics *kin, int e, Vec3 p, int *inside);

#endif
