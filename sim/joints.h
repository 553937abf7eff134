/* Springs and dampers of the joints from the data of the cables. docs/theory.md, "Bushing" (B15), "Bending with
 * hysteresis" (HY1)-(HY12). */
#ifndef HAWSER_SIM_JOINTS_H
#define HAWSER_SIM_JOINTS_H

#include "sim/scene.h"

enum { AXIAL, SHEAR_Y, SHEAR_Z, TORSION, BENDING_Y, BENDING_Z, COMPONENTS };

/* Stiffness, damping and preload of a bushing: N/m and N m/rad, N s/m and N m s/rad, N and N m. */
typedef struct Bushing {
    double stiffness[COMPONENTS], damping[COMPONENTS], preload[COMPONENTS];
} Bushing;

/* Bushing of a clamp at an end: the half-spring of the segment there alone. */
Bushing joints_clamp(const Scene *scene, int segment);
/* Sets components from..to-1 of joint j. */
void joint_set(Chain *chain, int j, const Bushing *b, int from, int to);
/* Sets the axial spring in all three directions: the force is K d whatever the bushing's frame. */
void joint_even(Bushing *b);
/* Lets an end of `segment` slide in the n directions of axis, which are fixed to the ground: ghost i moves along with
 * it, so that an even joint between them has no force there, whatever the rotation of the end (RD21). */
void slide_ghost(const Chain *chain, Kinematics *kin, int i, int segment, int n, const Vec3 *axis);
/* Removes from k and d the part of the joint's blocks that holds only for a ghost that stands still (RD22). */
void slide_blocks(const Chain *chain, const Kinematics *kin, int i, int segment, int n, const Vec3 *axis, BlockChain *k,
                  BlockChain *d);
/* Sets the joints between the scene's segments: two half-springs in series (B15). */
void joints_springs(Scene *scene);
/* Adds the sliders. The elastic bending springs of a joint that has some keep only the stiffness of the curve's last
 * piece (HY4). Errors: MEMORY. */
hawser_status joints_sliders(Scene *scene, hawser_error *err);
/* Makes the initial shape the resting shape of the joints before `end`: preloads -K theta of torsion and bending.
 * Errors: MEMORY. */
hawser_status joints_rest(Scene *scene, int end, hawser_error *err);
/* Bends the resting shape to the side, by `curvature` (1/m) times two waves along the cable, the longer one of
 * `wave_number` (1/m): the imperfection of a cable in compression, docs/theory/60-theory.md (BK10). Errors: MEMORY. */
hawser_status joints_bow(Scene *scene, double curvature, double wave_number, hawser_error *err);
/* ---- First-loading curves of bending (sim/joints.c): moment over rotation, concave and piecewise linear, for half a
 * segment or for a joint of two, and the sliders that reproduce such a curve. docs/theory.md, "Bending with
 * hysteresis". */

/* Piece i has compliance[i] up to moment[i]; the last piece has no end. */
typedef struct LoadingCurve {
    int corners;                        /* pieces - 1 */
    double moment[SLIDERS_MAX];         /* N m, rising */
    double compliance[SLIDERS_MAX + 1]; /* rad/(N m), rising; INFINITY: the moment stays constant */
} LoadingCurve;

/* Curve of a length `half` (m) of a cable: its table, or a straight line (HY1). */
LoadingCurve loading_curve_of(const CableDef *cable, double half);
/* Curve of two in series: the moment is the same in both, the rotations add up (HY2). */
LoadingCurve loading_curve_series(const LoadingCurve *a, const LoadingCurve *b);
/* Computes the sliders whose first loading is the curve: stiffness [corners] N m/rad and limit [corners] rad; returns
 * the stiffness of the elastic spring beside them, N m/rad (HY4). */
double loading_curve_sliders(const LoadingCurve *curve, double *stiffness, double *limit);

#endif
