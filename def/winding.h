/* Winding of cable on a drum: layers of equal turns between two flanges. Everything is a continuous function of the
 * length wound, counted from the drum's barrel. docs/theory.md, "Reel and take-in" (RL1)-(RL5). */
#ifndef HAWSER_DEF_WINDING_H
#define HAWSER_DEF_WINDING_H

#include "def/scene_def.h"

typedef struct Winding {
    double barrel;    /* m, radius of the bare drum */
    double pitch;     /* m, from turn to turn and from layer to layer: the cable's diameter */
    double turns;     /* in a layer, a whole number >= 1 */
    double line_mass; /* kg/m of the cable */
    double inertia;   /* kg m2 of the empty drum about its axis */
} Winding;

/* A point of the wound cable, seen along the drum's axis. */
typedef struct WindingPoint {
    double radius; /* m */
    double angle;  /* rad, about the axis from the cable's inner end */
    double across; /* m, along the axis from the drum's middle */
} WindingPoint;

/* Number of turns of a cable of this diameter between flanges `width` apart: 0 if it does not fit. */
double winding_turns(double width, double diameter);
/* Length of cable below flanges of this radius, whole layers only, m (RL4). */
double winding_capacity(const Winding *w, double flange);
/* Radius of the cable's axis where it leaves a drum with `length` m wound on it (RL3); *slope (may be NULL) gets
 * d/d(length). */
double winding_radius(const Winding *w, double length, double *slope);
/* Moment of inertia of the drum with `length` m wound on it, kg m2 (RL5). */
double winding_inertia(const Winding *w, double length);
/* Point of the cable at `length` m from its inner end. */
WindingPoint winding_point(const Winding *w, double length);
/* Lay of a cable on a drum with contact at every turn, and whether it fits. docs/theory.md, "A wound drum" (CC22),
 * (CC23). */

/* The lay: radii and lateral places as functions of the angle from its inner end (CC22), (CC23). */
typedef struct Lay {
    double first;    /* m, radius of the lowest layer's axis */
    double diameter; /* m, of the cable */
    double pitch;    /* m, from turn to turn and from layer to layer */
    double turns;    /* regular ones in the lowest layer */
} Lay;

/* A chain's joints on the drum, and the place where the cable leaves it: the middle of the last segment. */
typedef struct Wound {
    Lay lay;
    int joints;                  /* 0 .. joints-1 lie on the drum */
    double *angle;               /* [joints], rad from the cable's inner end on; owned */
    double half;                 /* m, of the segment in the middle of which the cable leaves */
    double radius, across, last; /* at that place: m, m, rad */
} Wound;

/* Winds the chain's joints behind the place where the cable leaves: half and joint_s (n segments, n + 1 joints) as in
 * the chain. out->angle must be freed, also after an error. Errors: INPUT (it does not fit), MEMORY. */
hawser_status wound_lay(const SceneDef *def, int n, const double *half, const double *joint_s, Wound *out,
                        hawser_error *err);
/* Place of a joint between segments of length h whose middles lie on the lay: in the drum's frame, x across, y and z
 * round. */
Vec3 lay_joint(const Lay *lay, double angle, double h);

#endif
