/* How a cable lies on a drum that every turn touches, and whether it fits. docs/model.md, "A wound drum" (CC22),
 * (CC23).
 */
#ifndef HAWSER_DEF_WOUND_H
#define HAWSER_DEF_WOUND_H

#include "def/scene_def.h"

/* How the cable lies: radii and places across as functions of the angle from its inner end (CC22), (CC23). */
typedef struct Lay {
    double first;    /* m, radius of the lowest layer's axis */
    double diameter; /* m, of the cable */
    double pitch;    /* m, from turn to turn and from layer to layer */
    double turns;    /* regular ones in the lowest layer */
} Lay;

/* A chain's joints on the drum, and where the cable leaves it: at the middle of the last segment, half on and half off.
 */
typedef struct Wound {
    Lay lay;
    int joints;                  /* 0 .. joints-1 lie on the drum */
    double *angle;               /* [joints], rad from the cable's inner end on; owned */
    double half;                 /* m, of the segment in the middle of which the cable leaves */
    double radius, across, last; /* there: m, m, rad */
} Wound;

/* Winds the chain's joints behind the place where the cable leaves: half and joint_s (n segments, n + 1 joints) as in
 * the chain. Errors: INPUT (it does not fit), MEMORY. Give it back with free(out->angle), also after an error. */
hawser_status wound_lay(const SceneDef *def, int n, const double *half, const double *joint_s, Wound *out,
                        hawser_error *err);
/* Where a joint between segments of length h lies for the segments' middles to lie on the lay: in the drum's frame, x
 * across, y and z round. */
Vec3 lay_joint(const Lay *lay, double angle, double h);

#endif
