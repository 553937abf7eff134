/* The joints' springs and dampers from what cables are made of. docs/model.md, "Bushing" (B15), "Bending with
 * hysteresis" (HY1)-(HY12). */
#ifndef HAWSER_SIM_JOINTS_H
#define HAWSER_SIM_JOINTS_H

#include "sim/scene.h"

enum { AXIAL, SHEAR_Y, SHEAR_Z, TORSION, BENDING_Y, BENDING_Z, COMPONENTS };

/* What a bushing is made of: N/m and N m/rad, N s/m and N m s/rad, N and N m. */
typedef struct Bushing {
    double stiffness[COMPONENTS], damping[COMPONENTS], preload[COMPONENTS];
} Bushing;

/* A clamp at an end: the half-spring of the segment there alone. */
Bushing joints_clamp(const Scene *scene, int segment);
/* Components from..to-1 of joint j. */
void joint_set(Chain *chain, int j, const Bushing *b, int from, int to);

/* The joints between the scene's segments: two half-springs in series (B15). */
void joints_springs(Scene *scene);
/* Where a joint has sliders, its elastic bending springs keep only what the curve's last piece has (HY4). Errors:
 * MEMORY. */
hawser_status joints_sliders(Scene *scene, hawser_error *err);

#endif
