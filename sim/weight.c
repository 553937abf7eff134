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

Push weight_loads(const Scene *scene, const Kinematics *kin, int from, int to, Loads *loads)
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
    for (int i = from; i < to && w->lead_in; ++i) {
        const double share = weight_share(w, v3_load(kin->p, i), NULL);
        if (share >= 1) break; /* all segments ahead are past the start */
        const Vec3 behind = v3_add(v3_sub(w->behind, w->gravity), lead_in_hold(w, kin, i));
        const Vec3 force = v3_scale((1 - share) * scene->chain.mass[i], behind);
        v3_gather(loads->f, i, force);
        by.power += v3_dot(force, v3_load(kin->v, i));
        by.force = v3_add(by.force, force);
    }
    return by;
}

void weight_blocks(const Scene *scene, const Kinematics *kin, BlockChain *k, BlockChain *d)
{
    const Weight *const w = &scene->weight;
    if (!w->lead_in) return;
    for (int i = 0; i < scene->chain.n; ++i) {
        double slope;
        const double share = weight_share(w, v3_load(kin->p, i), &slope), m = scene->chain.mass[i];
        if (share >= 1) break;
        const Vec3 behind = v3_add(v3_sub(w->behind, w->gravity), lead_in_hold(w, kin, i));
        for (int c = 0; c < 3; ++c) {
            const Vec3 across = v3_reject(v3_axis(c), w->direction);
            const Vec3 entering = v3_scale(-slope * v3_dot(v3_axis(c), w->direction) * m, behind);
            block6_add(k->diag + 36 * i, c, v3_axpy(entering, -(1 - share) * m * w->hold, across), V3_ZERO);
            block6_add(d->diag + 36 * i, c, v3_scale(-(1 - share) * m * w->hold_damping, across), V3_ZERO);
        }
    }
}
