#include "core/chain.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/lanes.h"

/* Entries before index 0, so that index 0 is aligned and index -1 exists. */
enum { FRONT = LANES, ALIGNMENT = 64 };
/* Arrays of a struct that are allocated together: from Chain.half to preload, from Kinematics.p to a. */
enum { CHAIN_ARRAYS = 24, KINEMATICS_ARRAYS = 16 };

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
    const size_t bytes = ((size_t)count * sizeof(double) / ALIGNMENT + 2) * ALIGNMENT;
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

int chain_struct_new(double **array, int count, int n)
{
    const int ok = chain_arrays_new(array, count, n, 0);
    if (!ok) chain_arrays_free(array, count);
    return ok;
}

void chain_arrays_checkpoint(Checkpoint *c, const char *name, double *const *array, int count, int n)
{
    for (int k = 0; k < count; ++k) checkpoint_put(c, name, array[k] - 1, (size_t)(n + 2) * sizeof(double));
}

void chain_array_fill(double *array, int n, double fill)
{
    const int length = chain_stride(n);
    for (int i = 0; i < length; ++i) array[i - FRONT] = fill;
}

int chain_alloc(Chain *chain, int n)
{
    *chain = (Chain){.n = n, .stride = chain_stride(n)};
    if (!chain_struct_new(&chain->half, CHAIN_ARRAYS, n)) return 0;
    chain_array_fill(chain->mass, n, 1);
    for (int c = 0; c < 3; ++c) chain_array_fill(chain->inertia[c], n, 1);
    return 1;
}

void chain_free(Chain *chain)
{
    chain_arrays_free(&chain->half, CHAIN_ARRAYS);
    chain_arrays_free(chain->sliders.stiffness, SLIDERS_MAX);
    chain_arrays_free(chain->sliders.limit, SLIDERS_MAX);
    chain->sliders.count = 0;
}

/* Checks whether six arrays over joints are all zero. */
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
    *kin = (Kinematics){0};
    if (!chain_struct_new(kin->p, KINEMATICS_ARRAYS, n)) return 0;
    chain_array_fill(kin->q[0], n, 1);
    chain_array_fill(kin->a[0], n, 1);
    return 1;
}

int kinematics_alloc_slips(Kinematics *kin, const Chain *chain)
{
    return chain_arrays_new(kin->slip, 2 * chain->sliders.count, chain->n, 0);
}

void kinematics_free(Kinematics *kin) { chain_struct_free(kin); }

void loads_zero(Loads *loads, int n)
{
    for (int c = 0; c < 3; ++c) {
        memset(loads->f[c], 0, (size_t)n * sizeof(double));
        memset(loads->m[c], 0, (size_t)n * sizeof(double));
    }
}
