#include "sim/step/force_error.h"

#include <math.h>

#include "sim/step/scales.h"

/* Of the largest tension so far, and of the pull that theory expects: what is less than that is not judged by itself.
 */
static const double SHARE = 0.3;
static const double GRAVITY = 9.81;    /* m/s2, of a metre of cable, which is the least that is judged */
static const double LOAD_WEIGHTS = 20; /* of the heaviest segment: what a load is large against */
/* The share of the scale that the accuracy 10^-3 allows is twice 10^-3. */
static const double ALLOWED = 0.2, POWER = 2.0 / 3;
/* How many times smaller noise is than what is judged. */
static const double NOISE_UNDER = 20;

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

/* The time in which a segment swings on its joint, over 2 pi: the least of the chain's, s. */
static double quickest(const Chain *chain)
{
    double least = INFINITY;
    for (int j = 1; j < chain->n; ++j) {
        if (chain->stiffness[0][j] > 0) least = fmin(least, chain->mass[j] / chain->stiffness[0][j]);
    }
    return least < INFINITY ? sqrt(least) : 0;
}

ForceScale force_scale(const Scene *scene, double now, double most, double left)
{
    const double heaviest = scales_heaviest(scene);
    double metre = 0, mass = -scene->weight.weightless; /* kg */
    for (int i = 0; i < scene->chain.n; ++i) mass += scene->chain.mass[i];
    for (int i = 0; i + 1 < scene->chain.n; ++i) metre = fmax(metre, scene->chain.mass[i] / (2 * scene->chain.half[i]));
    const double tension = fmax(fmax(now, GRAVITY * metre), SHARE * fmax(most, scene->expected_pull));
    if (!(tension > 0)) return (ForceScale){0};
    const double load = fmax(SHARE * tension, fmin(tension, LOAD_WEIGHTS * GRAVITY * heaviest));
    const double share = ALLOWED * pow(scene->def.solver.accuracy, POWER);
    const Surge noise = {mass * left, sqrt(STATE_SIZE * SCALES_WINDOW) * heaviest * left};
    return (ForceScale){
        .tension = share * tension, .load = share * load, .quick = quickest(&scene->chain), .noise = noise};
}

double force_error(const Surge *surge, const ForceScale *scale, double gamma)
{
    if (!(scale->tension > 0)) return 0;
    const double time = fmax(gamma, scale->quick);
    return fmax(surge->chain / fmax(time * scale->tension, NOISE_UNDER * scale->noise.chain),
                surge->segment / fmax(time * scale->load, NOISE_UNDER * scale->noise.segment));
}
