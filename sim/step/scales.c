#include "sim/step/scales.h"

#include <string.h>

#include "core/base/team.h"
#include "core/base/worst.h"
#include "sim/step/vector_kernels.h"

static const double LENGTH = 0.01, TURN = 0.1; /* m, rad: physical scales of the errors */

/* Tolerances are accuracy times these (N10); a case may give its own instead. */
static double chosen(double given, double otherwise) { return given > 0 ? given : otherwise; }

Tolerances scales_tolerances(const Scene *scene)
{
    const SolverDef *const s = &scene->def.solver;
    const double speed = scene->largest_speed;
    return (Tolerances){.position = chosen(s->atol_position, s->accuracy * LENGTH),
                        .rotation = chosen(s->atol_rotation, s->accuracy * TURN),
                        .velocity = chosen(s->atol_velocity, s->accuracy * speed),
                        .omega = chosen(s->atol_omega, s->accuracy * speed * TURN / LENGTH)};
}

void scales_weights(const Scene *scene, double *weight)
{
    const Tolerances tol = scales_tolerances(scene);
    const int n = scene->chain.n;
    for (int c = 0; c < STATE_SIZE; ++c) {
        const double atol = c < STATE_Q   ? tol.position
                            : c < STATE_V ? tol.rotation / 2
                            : c < STATE_W ? tol.velocity
                                          : tol.omega;
        for (int i = 0; i < n; ++i) weight[c * n + i] = 1 / atol;
    }
    const EquipmentTolerances equipment = {tol.position, tol.rotation, tol.velocity, tol.omega};
    equipment_weights(scene->equipment, scene->rollers, &equipment, weight + STATE_SIZE * n);
}

double scales_norm(int n, const double *x, const double *weight)
{
    return sqrt(vector_kernels()->window_square(n, 0, n, x, weight));
}

/* The windows of half of a chain. */
typedef struct NormHalf {
    int n, middle;
    WindowSquare *square;
    const void *owner;
    const double *x, *weight;
    double largest[2];
} NormHalf;

static void norm_half(void *arg, int rank)
{
    NormHalf *const h = arg;
    h->largest[rank] = h->square(h->owner, rank ? h->middle : 0, rank ? h->n : h->middle, h->x, h->weight);
}

double scales_chain_norm(Team *team, int n, WindowSquare *square, const void *owner, const double *x,
                         const double *weight)
{
    NormHalf h = {n, n / 2 / SCALES_WINDOW * SCALES_WINDOW, square, owner, x, weight, {0}};
    if (n < HALVES_LONG) return sqrt(square(owner, 0, n, x, weight));
    halves_run(team, 1, norm_half, &h);
    return sqrt(larger_of(h.largest[0], h.largest[1]));
}

double scales_equipment_norm(const Equipment *q, const double *x, const double *weight)
{
    double largest = q->mounts > 0 ? scales_norm(q->mounts, x + q->spins, weight + q->spins) : 0;
    for (int from = 0; from < q->spins; from += SCALES_WINDOW) {
        const int to = from + SCALES_WINDOW < q->spins ? from + SCALES_WINDOW : q->spins;
        double sum = 0;
        for (int i = from; i < to; ++i) sum += x[i] * weight[i] * x[i] * weight[i];
        largest = larger_of(largest, sqrt(sum / (to - from)));
    }
    return largest;
}

void scales_equipment_project(const Equipment *q, const double *e, double *correction, double *error)
{
    memset(correction, 0, (size_t)q->spins * sizeof *correction);
    vector_kernels()->project(q->mounts, 0, q->mounts, e + q->spins, correction + q->spins,
                              error ? error + q->spins : NULL);
}

int scales_worst_segment(int n, int pitch, int components, const double *x, const double *weight)
{
    int worst = 0;
    double largest = -1;
    for (int i = 0; i < n; ++i) {
        double sum = 0;
        for (int k = i; k < components * pitch; k += pitch) sum += x[k] * weight[k] * x[k] * weight[k];
        if (isnan(sum)) return i;
        if (sum > largest) {
            largest = sum;
            worst = i;
        }
    }
    return worst;
}

/* What Newton's iteration may leave is noise in the tensions, because the axial stiffness multiplies it; docs/model.md,
 * "Integration", has the figures. It is a share of the error test's tolerance, of at least NEWTON_SHARE, that grows as
 * the tolerance falls, so that NEWTON_LEFT of the scales of (N10) are left at any accuracy, up to CVODE's default. */
static const double NEWTON_SHARE = 1e-3, NEWTON_SHARE_MOST = 0.1, NEWTON_LEFT = 3e-7;
/* The same in a conveyor's force, times the accuracy, as a share of its grip (N16). */
static const double GRIP_LEFT = 0.01;

double scales_newton_share(const Scene *scene)
{
    const double share = fmax(NEWTON_SHARE, fmin(NEWTON_LEFT / scene->def.solver.accuracy, NEWTON_SHARE_MOST));
    return fmin(share, GRIP_LEFT * scene->grip_speed / (1.5 * scene->largest_speed));
}

double stride_most(const Scene *scene)
{
    const int touches = scene->contact.n_rollers > 0 || scene->surfaces.model.n_patches > 0 || scene->self.present;
    const double unseen = (1 - CONTACT_USABLE) * scene->def.contact_reach; /* what candidates may be late by */
    return touches ? fmin(scene_way(scene), unseen) : INFINITY;
}

double stride_speed(const Chain *chain, int pitch, int dims, const double *v, int turns, const double *w)
{
    return sqrt(vector_kernels()->largest_square(chain->n, pitch, dims, v, turns, w, chain->half));
}

double stride_longest(double way, double speed, double growth)
{
    const double both = speed + sqrt(speed * speed + 2 * growth * way);
    return both > 0 ? 2 * way / both : INFINITY;
}
