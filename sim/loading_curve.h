/* First-loading curves of bending: moment by rotation, concave, in straight pieces, for half a segment or for a joint
 * of two, and the sliders that such a curve is made of. docs/model.md, "Bending with hysteresis". */
#ifndef HAWSER_SIM_LOADING_CURVE_H
#define HAWSER_SIM_LOADING_CURVE_H

#include "core/chain.h"
#include "sim/def/scene_def.h"

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
