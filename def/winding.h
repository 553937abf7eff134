/* How cable lies on a drum, and how it leaves it: layers of equal turns between
 * two flanges. Everything is a function of the length wound, counted from the drum's barrel, and continuous in it.
 * docs/model.md, "Reel and take-in" (RL1)-(RL5). */
#ifndef HAWSER_DEF_WINDING_H
#define HAWSER_DEF_WINDING_H

typedef struct Winding {
    double barrel;    /* m, radius of the bare drum */
    double pitch;     /* m, from turn to turn and from layer to layer: the cable's diameter */
    double turns;     /* in a layer, a whole number >= 1 */
    double line_mass; /* kg/m of the cable */
    double inertia;   /* kg m2 of the empty drum about its axis */
} Winding;

/* Where a point of wound cable is, seen along the drum's axis. */
typedef struct WindingPoint {
    double radius; /* m */
    double angle;  /* rad, about the axis from the cable's inner end on */
    double across; /* m, along the axis from the drum's middle */
} WindingPoint;

/* Turns of a cable of this diameter between flanges `width` apart: 0 if it does not fit. */
double winding_turns(double width, double diameter);
/* Length of cable that fits below flanges of this radius, whole layers only, m (RL4). */
double winding_capacity(const Winding *w, double flange);

/* Radius of the cable's axis where it leaves a drum with `length` m wound on it (RL3); *slope (may be NULL) gets
 * d/d(length). */
double winding_radius(const Winding *w, double length, double *slope);
/* Moment of inertia of the drum with `length` m wound on it, kg m2 (RL5). */
double winding_inertia(const Winding *w, double length);
/* The point of the cable at `length` m from its inner end. */
WindingPoint winding_point(const Winding *w, double length);

#endif
