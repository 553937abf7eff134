#include "sim/equipment/take_in.h"

#include "core/profile.h"

static const double FADE = 0.2; /* s, over which a taken segment's own motion dies out */

void take_in_begin(TakeIn *w, double t, Vec3 drift, Vec3 spin)
{
    w->since = t;
    w->drift = drift;
    w->spin = spin;
}

void take_in_ghost(const TakeIn *w, double t, int n, Kinematics *kin)
{
    const Profile left = {.kind = PROFILE_STEP, .v0 = 1, .t1 = FADE};
    const double x = fmax(t - w->since, 0), rate = profile_value(&left, x), gone = profile_integral(&left, x);
    const Quat turn = quat_exp(v3_scale(gone, w->spin));
    const Quat q = quat_mul(turn, (Quat){kin->q[0][n], kin->q[1][n], kin->q[2][n], kin->q[3][n]});
    const Vec3 axis = quat_rotate(q, v3(1, 0, 0));
    const double drift[3] = {w->drift.x, w->drift.y, w->drift.z}, spin[3] = {w->spin.x, w->spin.y, w->spin.z};
    const double along[3] = {axis.x, axis.y, axis.z}, attitude[4] = {q.w, q.x, q.y, q.z};
    for (int c = 0; c < 3; ++c) {
        kin->p[c][n] += gone * drift[c];
        kin->v[c][n] += rate * drift[c];
        kin->w[c][n] += rate * spin[c];
        kin->a[c][n] = along[c];
    }
    for (int c = 0; c < 4; ++c) kin->q[c][n] = attitude[c];
}
