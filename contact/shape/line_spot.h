/* A point of the smooth contact line with everything that a contact between two cables needs of it, and the point of
 * the line that is nearest to a point in space. docs/model.md, "Contact line", "Cable on cable". */
#ifndef HAWSER_CONTACT_SHAPE_LINE_SPOT_H
#define HAWSER_CONTACT_SHAPE_LINE_SPOT_H

#include "contact/shape/element.h"

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
