#include "sim/step/force_error.h"

#include <math.h>

#include "core/base/vec3.h"
#include "sim/step/scales.h"

/* Of the largest tension so far, and of the pull that theory expects: what is less than that is not judged by itself.
 */
static const double SHARE = 0.3;
static const double LEAST = 1;         /* m of cable, by its weight */
static const double LOAD_WEIGHTS = 20; /* of the heaviest segment: what a load is large against */
/* The share of the scale that the accuracy 10^-3 allows is 10^-3 itself. */
static const double ALLOWED = 0.1, POWER = 2.0 / 3;

Surge surge_of(const Chain *chain, int dims, double *const *axis, int pitch, const double *v, int turns,
               const double *w)
{
    double along = 0, least = 0, most = 0, largest = 0;
    for (int i = 0; i < chain->n; ++i) {
        const double mass = chain->mass[i], arm = chain->half[i] / 3;
        double axial = 0, square = 0, turn = 0;
        for (int c = 0; c < dims; ++c) {
            const double vc = v[c * pitch + i];
            axial += axis[c][i] * vc;
            square += vc * vc;
        }
        for (int c = 0; c < turns; ++c) turn += w[c * pitch + i] * w[c * pitch + i];
        along += mass * axial;
        least = fmin(least, along);
        most = fmax(most, along);
        largest = fmax(largest, mass * mass * (square + arm * arm * turn));
    }
    return (Surge){most - least, sqrt(largest)};
}

ForceScale force_scale(const Scene *scene, double now, double most)
{
    const double tension = fmax(fmax(now, LEAST * scene->cable_weight), SHARE * fmax(most, scene->expected_pull));
    const double weight = v3_norm(scene->weight.gravity) * scales_heaviest(scene);
    return (ForceScale){tension, fmax(SHARE * tension, fmin(tension, LOAD_WEIGHTS * weight))};
}

double force_error(const Surge *surge, const ForceScale *scale, double gamma, double accuracy)
{
    if (!(scale->tension > 0)) return 0; /* nothing weighs, nothing pulls */
    const double allowed = ALLOWED * pow(accuracy, POWER) * gamma;
    return fmax(surge->chain / (allowed * scale->tension), surge->segment / (allowed * scale->load));
}
