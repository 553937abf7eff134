#include "sim/step/stride.h"

#include <math.h>

#include "sim/step/vector_kernels.h"

static double thinnest_cable(const SceneDef *def)
{
    double least = INFINITY;
    for (int i = 0; i < def->n_cables; ++i) least = fmin(least, def->cables[i].diameter / 2);
    return least;
}

/* Half of what the thinnest cable takes to pass the thinnest roller, or to pass itself: there and back again is still
 * seen (N14). Ducts, trays and planes have no other side. */
double stride_most(const Scene *scene)
{
    double thinnest = INFINITY;
    const double cable = thinnest_cable(&scene->def);
    for (int r = 0; r < scene->contact.n_rollers; ++r) thinnest = fmin(thinnest, scene->contact.roller[r].shape.radius);
    if (scene->self.present) thinnest = fmin(thinnest, 0);
    return thinnest + cable;
}

static const VectorKernels *kernels(void)
{
    static const VectorKernels *const table[] = ISA_TABLE(vector_kernels);
    return table[isa_best()];
}

double stride_speed(const Chain *chain, int pitch, int dims, const double *v, int turns, const double *w)
{
    return sqrt(kernels()->largest_square(chain->n, pitch, dims, v, turns, w, chain->half));
}
