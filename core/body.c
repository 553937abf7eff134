#include "core/body.h"

Vec3 body_inertia_times(const Chain *chain, const Kinematics *kin, int i, Vec3 a)
{
    const Quat q = {kin->q[0][i], kin->q[1][i], kin->q[2][i], kin->q[3][i]};
    const Vec3 b = quat_rotate(quat_conj(q), a);
    return quat_rotate(q, v3(chain->inertia[0][i] * b.x, chain->inertia[1][i] * b.y, chain->inertia[2][i] * b.z));
}

/* The world inertia of segment i. */
static Mat3 inertia_matrix(const Chain *chain, const Kinematics *kin, int i)
{
    const Vec3 x = body_inertia_times(chain, kin, i, v3(1, 0, 0)), y = body_inertia_times(chain, kin, i, v3(0, 1, 0));
    const Vec3 z = body_inertia_times(chain, kin, i, v3(0, 0, 1));
    return (Mat3){{x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z}};
}

/* Change of I a when the segment rotates by phi: phi x (I a) - I (phi x a). */
static Vec3 inertia_turned(const Mat3 *inertia, Vec3 phi, Vec3 a)
{
    return v3_sub(v3_cross(phi, m3_mul(inertia, a)), m3_mul(inertia, v3_cross(phi, a)));
}

void body_blocks(const Chain *chain, const Kinematics *kin, const double *ydot, int from, int to, BlockChain *k,
                 BlockChain *d)
{
    const Vec3 unit[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const int n = chain->n;
    for (int i = from; i < to; ++i) {
        const double *const rate = ydot + STATE_W * n + i;
        const Vec3 w = v3_load(kin->w, i);
        const Vec3 spin = v3(rate[0], rate[n], rate[2 * n]);
        const Mat3 inertia = inertia_matrix(chain, kin, i);
        const Vec3 momentum = m3_mul(&inertia, w);
        for (int c = 0; c < 3; ++c) { /* (S4) */
            const Vec3 turned = v3_cross(w, inertia_turned(&inertia, unit[c], w));
            block_column_add(k->diag + 36 * i, 3 + c, 3,
                             v3_scale(-1, v3_add(inertia_turned(&inertia, unit[c], spin), turned)));
            const Vec3 gyro = v3_add(v3_cross(unit[c], momentum), v3_cross(w, m3_mul(&inertia, unit[c])));
            block_column_add(d->diag + 36 * i, 3 + c, 3, v3_scale(-1, gyro));
        }
    }
}
