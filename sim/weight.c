#include "sim/weight.h"

/* Share of the whole weight that a segment feels at p (F1): 0 behind the start, 1 ahead. */
static double weight_share(const Weight *w, Vec3 p, double *slope)
{
    const double x = v3_dot(v3_sub(p, w->origin), w->direction);
    return step_cubic(x, -w->blend / 2, 0, w->blend / 2, 1, slope);
}

/* What the lead-in does to a segment that has left its line, per mass, m/s2. */
static Vec3 lead_in_hold(const Weight *w, const Kinematics *kin, int i)
{
    const Vec3 off = v3_reject(v3_sub(v3_load(kin->p, i), w->origin), w->direction);
    return v3_axpy(v3_scale(-w->hold, off), -w->hold_damping, v3_reject(v3_load(kin->v, i), w->direction));
}

/* m from the lead-in's line, which would hold what is there with a thousand times its weight: the tail has been past
 * the start. */
static const double ELSEWHERE = 1;

int weight_first_past(int n, int dims, const double *const p[], const double *origin, const double *direction, int held,
                      double past)
{
    for (int i = 0; i < n; ++i) {
        double along = 0, square = 0;
        for (int c = 0; c < dims; ++c) {
            const double off = p[c][i] - origin[c];
            along += off * direction[c];
            square += off * off;
        }
        if (!(along < past) || (i == 0 && held && square - along * along > ELSEWHERE * ELSEWHERE)) return i;
    }
    return n;
}

int weight_behind(const Scene *scene, const double *const p[3], double past)
{
    const Weight *const w = &scene->weight;
    const double origin[3] = {w->origin.x, w->origin.y, w->origin.z};
    const double direction[3] = {w->direction.x, w->direction.y, w->direction.z};
    return w->lead_in ? weight_first_past(scene->chain.n, 3, p, origin, direction, w->hold > 0, past) : 0;
}

Push weight_loads(const Scene *scene, const Kinematics *kin, int from, int to, int behind, Loads *loads)
{
    const Weight *const w = &scene->weight;
    const double g[3] = {w->gravity.x, w->gravity.y, w->gravity.z};
    for (int c = 0; c < 3; ++c) {
        for (int i = from; i < to; ++i) {
            loads->f[c][i] = scene->chain.mass[i] * g[c];
            loads->m[c][i] = 0;
        }
    }
    if (w->weightless > 0 && to == scene->chain.n) { /* it moves with the last segment, but hangs elsewhere */
        v3_gather(loads->f, to - 1, v3_scale(-w->weightless, w->gravity));
    }
    Push by = {0};
    for (int i = from; i < to && i < behind; ++i) {
        const double share = weight_share(w, v3_load(kin->p, i), NULL);
        const Vec3 pull = v3_add(v3_sub(w->behind, w->gravity), lead_in_hold(w, kin, i));
        const Vec3 force = v3_scale((1 - share) * scene->chain.mass[i], pull);
        v3_gather(loads->f, i, force);
        by.power += v3_dot(force, v3_load(kin->v, i));
        by.force = v3_add(by.force, force);
    }
    return by;
}

void weight_blocks(const Scene *scene, const Kinematics *kin, BlockChain *k, BlockChain *d)
{
    const Weight *const w = &scene->weight;
    const double *const p[3] = {kin->p[0], kin->p[1], kin->p[2]};
    const int behind = weight_behind(scene, p, w->blend / 2);
    for (int i = 0; i < behind; ++i) {
        double slope;
        const double share = weight_share(w, v3_load(kin->p, i), &slope), m = scene->chain.mass[i];
        const Vec3 pull = v3_add(v3_sub(w->behind, w->gravity), lead_in_hold(w, kin, i));
        for (int c = 0; c < 3; ++c) {
            const Vec3 across = v3_reject(v3_axis(c), w->direction);
            const Vec3 entering = v3_scale(-slope * v3_dot(v3_axis(c), w->direction) * m, pull);
            block6_add(k->diag + 36 * i, c, v3_axpy(entering, -(1 - share) * m * w->hold, across), V3_ZERO);
            block6_add(d->diag + 36 * i, c, v3_scale(-(1 - share) * m * w->hold_damping, across), V3_ZERO);
        }
    }
}
