#include "def/cable_def.h"

#include <math.h>

/* At a curvature: the moment of a table's first bending, and the work that it has taken. */
typedef struct Bent {
    double moment, work; /* N m; N m for each metre */
} Bent;

static Bent bent_to(const BendingTable *t, double curvature)
{
    double before = 0;
    Bent b = {0, 0};
    for (int k = 0; k < t->rows && before < curvature; ++k) {
        const int last = k == t->rows - 1;
        const double slope = (t->moment[k] - b.moment) / (t->curvature[k] - before);
        const double by = (last ? curvature : fmin(curvature, t->curvature[k])) - before;
        b.work += by * (b.moment + by * slope / 2);
        b.moment += by * slope;
        before += by;
    }
    return b;
}

double cable_def_moment(const CableDef *cable, double curvature)
{
    if (cable->bending.rows == 0) return fmax(cable->ei_y, cable->ei_z) * curvature;
    return bent_to(&cable->bending, curvature).moment;
}

/* Unbent it gives back all of k M less the doubled curve under it: W(k) - (k M(k) - 4 W(k/2)). */
double cable_def_loop(const CableDef *cable, double curvature)
{
    if (cable->bending.rows == 0) return 0;
    const Bent all = bent_to(&cable->bending, curvature), half = bent_to(&cable->bending, curvature / 2);
    return fmax(0, all.work - (curvature * all.moment - 4 * half.work));
}
