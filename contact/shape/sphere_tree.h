/* A binary tree of spheres over the elements of the contact line, in their order: the chain's own order is the spatial
 * order, so nothing is sorted. Children of node i are 2i and 2i + 1. docs/model.md, "Which pairs are looked at". */
#ifndef HAWSER_CONTACT_SHAPE_SPHERE_TREE_H
#define HAWSER_CONTACT_SHAPE_SPHERE_TREE_H

#include "contact/shape/element.h"

typedef struct SphereTree {
    int leaves;   /* power of two >= elements */
    Sphere *node; /* [2 leaves]; node[leaves + e] is element e's (C18); a negative radius: nothing there */
} SphereTree;

/* Room for the elements of chains of n segments; 0 if there is no memory. */
int sphere_tree_alloc(SphereTree *tree, int n);
void sphere_tree_free(SphereTree *tree);
/* Spheres around the elements where they are now, and around runs of them (C19). */
void sphere_tree_build(SphereTree *tree, ContactGeometry geometry, const Chain *chain, const Kinematics *kin);

#endif
