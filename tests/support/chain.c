#include "tests/support/chain.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

double fixture_random(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(int64_t)*seed / 9223372036854775808.0;
}

Vec3 fixture_vector(uint64_t *seed, double size)
{
    const double x = fixture_random(seed), y = fixture_random(seed), z = fixture_random(seed);
    return v3(size * x, size * y, size * z);
}

Quat kinematics_quat(const Kinematics *kin, int i)
{
    return (Quat){kin->q[0][i], kin->q[1][i], kin->q[2][i], kin->q[3][i]};
}

void vec_store(double *const array[3], int i, Vec3 v)
{
    array[0][i] = v.x;
    array[1][i] = v.y;
    array[2][i] = v.z;
}

Vec3 vec_load(double *const array[3], int i) { return v3(array[0][i], array[1][i], array[2][i]); }

void kinematics_turn_to(Kinematics *kin, int i, Quat q)
{
    q = quat_unit(q);
    kin->q[0][i] = q.w;
    kin->q[1][i] = q.x;
    kin->q[2][i] = q.y;
    kin->q[3][i] = q.z;
    vec_store(kin->a, i, quat_rotate(q, v3(1, 0, 0)));
}

void fixture_chain(Chain *chain, uint64_t *seed)
{
    for (int i = 0; i < chain->n; ++i) {
        chain->half[i] = 0.25 + 0.1 * fixture_random(seed);
        chain->mass[i] = 2 + fixture_random(seed);
        for (int c = 0; c < 3; ++c) chain->inertia[c][i] = 0.6 + 0.3 * fixture_random(seed);
        chain->radius[i] = 0.05;
    }
    for (int j = 0; j <= chain->n; ++j) {
        for (int c = 0; c < 6; ++c) {
            chain->stiffness[c][j] = 3 + 2 * fixture_random(seed);
            chain->damping[c][j] = 0.5 + 0.3 * fixture_random(seed);
            chain->preload[c][j] = fixture_random(seed);
        }
    }
}

void fixture_state(const Chain *chain, Kinematics *kin, double bend, double gap, uint64_t *seed)
{
    Quat q = quat_unit((Quat){fixture_random(seed), fixture_random(seed), fixture_random(seed), fixture_random(seed)});
    Vec3 end = fixture_vector(seed, 1);
    for (int i = -1; i <= chain->n; ++i) {
        q = quat_mul(q, quat_exp(fixture_vector(seed, bend)));
        kinematics_turn_to(kin, i, q);
        const Vec3 r = v3_scale(chain->half[i], vec_load(kin->a, i));
        const Vec3 p = v3_add(v3_add(end, r), fixture_vector(seed, gap));
        vec_store(kin->p, i, p);
        end = v3_add(p, r);
        vec_store(kin->v, i, fixture_vector(seed, 1));
        vec_store(kin->w, i, fixture_vector(seed, 1));
    }
}
