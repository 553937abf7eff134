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
/* The axial spring in all three directions: its force is K d whatever the bushing's frame. */
void joint_even(Bushing *b);
/* An end of `segment` that slides in the n directions of axis, which belong to the ground: ghost i goes along with it,
 * so that an even joint between them has no force there, whatever way the end has turned (RD21). */
void slide_ghost(const Chain *chain, Kinematics *kin, int i, int segment, int n, const Vec3 *axis);
/* What that takes back of the blocks that the joint would have if the ghost stood still (RD22). */
void slide_blocks(const Chain *chain, const Kinematics *kin, int i, int segment, int n, const Vec3 *axis, BlockChain *k,
                  BlockChain *d);
/* The joints between the scene's segments: two half-springs in series (B15). */
void joints_springs(Scene *scene);
/* Where a joint has sliders, its elastic bending springs keep only what the curve's last piece has (HY4). Errors:
 * MEMORY. */
hawser_status joints_sliders(Scene *scene, hawser_error *err);
/* The joints before `end` rest as they lie at the start: preloads -K theta of torsion and bending. Errors: MEMORY. */
hawser_status joints_rest(Scene *scene, int end, hawser_error *err);
/* Joints rest bent to the side, by `curvature` (1/m) times two waves along the cable, the longer one of `wave_number`
 * (1/m): the imperfection of a cable that is pushed, docs/model/60-theory.md (BK10). Errors: MEMORY. */
hawser_status joints_bow(Scene *scene, double curvature, double wave_number, hawser_error *err);
/* ---- First-loading curves of bending (sim/joints.c): moment by rotation, concave, in straight pieces, for half
 * a segment or for a joint of two, and the sliders that such a curve is made of. docs/model.md, "Bending with
 * hysteresis". */

/* Piece i has the compliance [i] up to moment[i]; the last piece goes on for ever. */
typedef struct LoadingCurve {
    int corners;                        /* pieces - 1 */
    double moment[SLIDERS_MAX];         /* N m, rising */
    double compliance[SLIDERS_MAX + 1]; /* rad/(N m), rising; INFINITY: the moment stays where it is */
} LoadingCurve;

/* The curve of a length `half` (m) of a cable: its table, or a straight line (HY1). */
LoadingCurve loading_curve_of(const CableDef *cable, double half);
/* Two in series: the moment is the same in both, the rotations add up (HY2). */
LoadingCurve loading_curve_series(const LoadingCurve *a, const LoadingCurve *b);
/* Sliders whose first loading is the curve: stiffness [corners] N m/rad and limit [corners] rad; returns the stiffness
 * of the elastic spring beside them, N m/rad (HY4). */
double loading_curve_sliders(const LoadingCurve *curve, double *stiffness, double *limit);

#endif
