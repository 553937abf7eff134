#include "core/chain.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/lanes.h"

/* Entries before index 0, so that index 0 is aligned and index -1 exists. */
enum { FRONT = LANES, ALIGNMENT = 64 };

int chain_stride(int n) { return FRONT + (n + 1 + LANES - 1) / LANES * LANES + LANES; }

double *chain_array_new(int n, double fill)
{
    const size_t length = (size_t)chain_stride(n);
    double *block = aligned_alloc(ALIGNMENT, length * sizeof *block);
    if (!block) return NULL;
    for (size_t i = 0; i < length; ++i) block[i] = fill;
    return block + FRONT;
}

double *aligned_array_new(int count)
{
    const size_t bytes = ((size_t)count * sizeof(double) / ALIGNMENT + 1) * ALIGNMENT;
    double *const array = aligned_alloc(ALIGNMENT, bytes);
    if (array) memset(array, 0, bytes);
    return array;
}

double *chain_array_free(double *array)
{
    if (array) free(array - FRONT);
    return NULL;
}

int chain_arrays_new(double **array, int count, int n, double fill)
{
    int ok = 1;
    for (int c = 0; c < count; ++c) {
        array[c] = chain_array_new(n, fill);
        ok = ok && array[c];
    }
    return ok;
}

void chain_arrays_free(double **array, int count)
{
    for (int c = 0; c < count; ++c) array[c] = chain_array_free(array[c]);
}

int chain_alloc(Chain *chain, int n)
{
    memset(chain, 0, sizeof *chain);
    chain->n = n;
    chain->stride = chain_stride(n);
    int ok = chain_arrays_new(&chain->half, 1, n, 0);
    ok &= chain_arrays_new(&chain->mass, 1, n, 1);
    ok &= chain_arrays_new(chain->inertia, 3, n, 1);
    ok &= chain_arrays_new(&chain->radius, 1, n, 0);
    ok &= chain_arrays_new(chain->stiffness, 6, n, 0);
    ok &= chain_arrays_new(chain->damping, 6, n, 0);
    ok &= chain_arrays_new(chain->preload, 6, n, 0);
    if (!ok) chain_free(chain);
    return ok;
}

void chain_free(Chain *chain)
{
    chain_arrays_free(&chain->half, 1);
    chain_arrays_free(&chain->mass, 1);
    chain_arrays_free(chain->inertia, 3);
    chain_arrays_free(&chain->radius, 1);
    chain_arrays_free(chain->stiffness, 6);
    chain_arrays_free(chain->damping, 6);
    chain_arrays_free(chain->preload, 6);
    chain_arrays_free(chain->sliders.stiffness, SLIDERS_MAX);
    chain_arrays_free(chain->sliders.limit, SLIDERS_MAX);
    chain->sliders.count = 0;
}

/* Whether six arrays over joints hold nothing but zeros. */
static int all_zero(double *const array[6], int n)
{
    for (int c = 0; c < 6; ++c) {
        for (int j = 0; j <= n; ++j) {
            if (fabs(array[c][j]) > 0) return 0;
        }
    }
    return 1;
}

void chain_find_lacks(Chain *chain)
{
    chain->lacks = (all_zero(chain->damping, chain->n) ? CHAIN_NO_DAMPING : 0) |
                   (all_zero(chain->preload, chain->n) ? CHAIN_NO_PRELOAD : 0);
}

int chain_alloc_sliders(Chain *chain, int count)
{
    Sliders *const s = &chain->sliders;
    assert(s->count == 0 && count >= 0 && count <= SLIDERS_MAX);
    s->count = count;
    return chain_arrays_new(s->stiffness, count, chain->n, 0) & chain_arrays_new(s->limit, count, chain->n, 1);
}

int kinematics_alloc(Kinematics *kin, int n)
{
    memset(kin, 0, sizeof *kin);
    int ok = chain_arrays_new(kin->p, 3, n, 0);
    ok &= chain_arrays_new(kin->q, 1, n, 1);
    ok &= chain_arrays_new(kin->q + 1, 3, n, 0);
    ok &= chain_arrays_new(kin->v, 3, n, 0);
    ok &= chain_arrays_new(kin->w, 3, n, 0);
    ok &= chain_arrays_new(kin->a, 1, n, 1);
    ok &= chain_arrays_new(kin->a + 1, 2, n, 0);
    if (!ok) kinematics_free(kin);
    return ok;
}

int kinematics_alloc_slips(Kinematics *kin, const Chain *chain)
{
    return chain_arrays_new(kin->slip, 2 * chain->sliders.count, chain->n, 0);
}

void kinematics_free(Kinematics *kin)
{
    chain_arrays_free(kin->p, 3);
    chain_arrays_free(kin->q, 4);
    chain_arrays_free(kin->v, 3);
    chain_arrays_free(kin->w, 3);
    chain_arrays_free(kin->a, 3);
    chain_arrays_free(kin->slip, 2 * SLIDERS_MAX);
}

int loads_alloc(Loads *loads, int n)
{
    memset(loads, 0, sizeof *loads);
    int ok = chain_arrays_new(loads->f, 3, n, 0);
    ok &= chain_arrays_new(loads->m, 3, n, 0);
    if (!ok) loads_free(loads);
    return ok;
}

void loads_free(Loads *loads)
{
    chain_arrays_free(loads->f, 3);
    chain_arrays_free(loads->m, 3);
}

void loads_zero(Loads *loads, int n)
{
    for (int c = 0; c < 3; ++c) {
        memset(loads->f[c], 0, (size_t)n * sizeof(double));
        memset(loads->m[c], 0, (size_t)n * sizeof(double));
    }
}

int joint_loads_alloc(JointLoads *loads, int n)
{
    memset(loads, 0, sizeof *loads);
    const int ok = chain_arrays_new(loads->force, 3, n, 0) & chain_arrays_new(loads->torque_a, 3, n, 0) &
                   chain_arrays_new(loads->torque_b, 3, n, 0);
    if (!ok) joint_loads_free(loads);
    return ok;
}

void joint_loads_free(JointLoads *loads)
{
    chain_arrays_free(loads->force, 3);
    chain_arrays_free(loads->torque_a, 3);
    chain_arrays_free(loads->torque_b, 3);
}
