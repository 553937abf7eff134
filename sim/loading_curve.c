#include "sim/joints.h"

#include <assert.h>
#include <math.h>

/* The rigidity of the table's piece that ends in row i, N m2; the first begins in the origin. */
static double piece_rigidity(const BendingTable *t, int i)
{
    const double moment = i > 0 ? t->moment[i - 1] : 0, curvature = i > 0 ? t->curvature[i - 1] : 0;
    return (t->moment[i] - moment) / (t->curvature[i] - curvature);
}

/* A cable without a table is straight; unlike rigidities about y and z count with their geometric mean, because the
 * sliders are the same in all directions. */
LoadingCurve loading_curve_of(const CableDef *cable, double half)
{
    const BendingTable *const t = &cable->bending;
    LoadingCurve curve = {.compliance = {half / sqrt(cable->ei_y * cable->ei_z)}};
    assert(t->rows <= BENDING_ROWS_MAX);
    for (int i = 0; i < t->rows; ++i) {
        curve.compliance[i] = half / piece_rigidity(t, i); /* infinite for a level piece */
        if (i + 1 < t->rows) curve.moment[curve.corners++] = t->moment[i];
    }
    return curve;
}

/* Moment of corner i, or infinite behind the last. */
static double corner_at(const LoadingCurve *curve, int i) { return i < curve->corners ? curve->moment[i] : INFINITY; }

/* Walks up both curves by the moment; where one is level the joint is, and nothing comes behind. */
LoadingCurve loading_curve_series(const LoadingCurve *a, const LoadingCurve *b)
{
    LoadingCurve sum = {.compliance = {a->compliance[0] + b->compliance[0]}};
    int i = 0, k = 0;
    while (isfinite(sum.compliance[sum.corners])) {
        const double corner_a = corner_at(a, i), corner_b = corner_at(b, k), next = fmin(corner_a, corner_b);
        if (isinf(next)) break;
        assert(sum.corners < SLIDERS_MAX);
        i += corner_a <= next;
        k += corner_b <= next;
        sum.moment[sum.corners++] = next;
        sum.compliance[sum.corners] = a->compliance[i] + b->compliance[k];
    }
    return sum;
}

/* Each corner is where one slider gives way: it takes the difference of the stiffnesses before and after. */
double loading_curve_sliders(const LoadingCurve *curve, double *stiffness, double *limit)
{
    double rotation = 0, moment = 0;
    for (int i = 0; i < curve->corners; ++i) {
        rotation += curve->compliance[i] * (curve->moment[i] - moment);
        moment = curve->moment[i];
        stiffness[i] = 1 / curve->compliance[i] - 1 / curve->compliance[i + 1];
        limit[i] = rotation;
    }
    return 1 / curve->compliance[curve->corners];
}
