/* Whether a scene can be solved in a plane, and in which one; points and attitudes to and from it. docs/model.md,
 * "Planar chain" (PL1), (PL16), (PL17). */
#ifndef HAWSER_SIM_PLANAR_PLANE_H
#define HAWSER_SIM_PLANAR_PLANE_H

#include "core/planar/planar.h"
#include "sim/scene.h"

enum { PLANE_WHY_MAX = 160 };

typedef struct Plane {
    Vec3 origin;           /* a point of it, m */
    Vec3 e1, e2, normal;   /* its axes, e1 x e2 = normal */
    Quat flat;             /* attitude of a segment whose axis is e1 */
    double in_y, in_z;     /* components of the segments' y and z axes along J a, the direction across a segment */
    double turn_y, turn_z; /* and along the normal */
} Plane;

/* 1: all that the scene holds lies in *plane and is known to the planar equations. 0: not, and `why` says what is in
 * the way. -1: there is no memory. Decided by what is known to fit: whatever is not asked about here is refused. */
int plane_find(const Scene *scene, Plane *plane, char why[PLANE_WHY_MAX]);

/* Components of a vector in the plane; of a point relative to its origin. */
static inline double plane_1(const Plane *p, Vec3 v) { return v3_dot(v, p->e1); }
static inline double plane_2(const Plane *p, Vec3 v) { return v3_dot(v, p->e2); }
/* The vector x e1 + z e2. */
static inline Vec3 plane_vector(const Plane *p, double x, double z) { return v3_axpy(v3_scale(x, p->e1), z, p->e2); }

/* The state in space, y [13 n] (core/state.h), pressed into the plane: out [PLANAR_SIZE * stride]. Angles follow each
 * other without jumps of more than half a turn. Returns what is lost: the largest component off the plane of a position
 * (m), a velocity (m/s), an axis or an angular velocity (rad/s). */
double plane_press(const Plane *plane, int n, const double *y, double *out);
/* And back (PL17): exact but for rounding. */
void plane_lift(const Plane *plane, int n, const double *planar, double *y);

#endif
