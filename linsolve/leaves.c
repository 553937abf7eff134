#include "linsolve/leaves.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "linsolve/backend.h"
#include "linsolve/small.h"

int leaves_init(Leaves *s, const NewtonMatrix *a)
{
    *s = (Leaves){.b = a->chain.b, .leaves = a->leaves};
    s->factor = calloc((size_t)a->leaves + 1, sizeof *s->factor);
    if (!s->factor) return 0;
    for (int l = 0; l < a->leaves; ++l) {
        const Leaf *const leaf = a->leaf + l;
        assert(leaf->size >= 1 && leaf->size <= LEAF_MAX);
        s->factor[l] = (LeafFactor){.size = leaf->size, .first = s->unknowns};
        s->unknowns += leaf->size;
    }
    return 1;
}

void leaves_release(Leaves *s)
{
    free(s->factor);
    *s = (Leaves){0};
}

/* c += s A B, column-major: A is rows x inner, B inner x cols. */
static void multiply_add(int rows, int inner, int cols, double s, const double *a, const double *b, double *c)
{
    for (int j = 0; j < cols; ++j) {
        for (int k = 0; k < inner; ++k) {
            const double t = s * b[j * inner + k];
            for (int i = 0; i < rows; ++i) c[j * rows + i] += t * a[k * rows + i];
        }
    }
}

static double largest(int count, const double *a)
{
    double most = 0;
    for (int k = 0; k < count; ++k) most = fmax(most, fabs(a[k]));
    return most;
}

/* E^-1, column by column; LIN_UNSTABLE if a pivot is rounding against the entries of E. */
static int leaf_invert(LeafFactor *f, const double *diag)
{
    int pivot[LEAF_MAX];
    double lu[LEAF_MAX * LEAF_MAX];
    const int d = f->size;
    memcpy(lu, diag, (size_t)(d * d) * sizeof(double));
    if (small_lu_factor(d, lu, pivot)) return LIN_UNSTABLE;
    memset(f->inverse, 0, sizeof f->inverse);
    for (int k = 0; k < d; ++k) {
        f->inverse[k * d + k] = 1;
        small_lu_solve(d, lu, pivot, f->inverse + k * d);
    }
    return 0;
}

static double *chain_block(const BlockChain *chain, int i, int j)
{
    double *const blocks = j < i ? chain->lower : j > i ? chain->upper : chain->diag;
    return blocks + (size_t)i * (size_t)(chain->b * chain->b);
}

static int leaf_condense(LeafFactor *f, const Leaf *leaf, BlockChain *chain, double growth_limit, double *growth)
{
    const int b = chain->b, d = f->size, bb = b * b;
    assert(leaf->size == d && leaf->touches >= 0 && leaf->touches <= 2);
    assert(leaf->touches == 0 || (leaf->at >= 0 && leaf->at + leaf->touches <= chain->n));
    f->at = leaf->at;
    f->touches = leaf->touches;
    if (leaf_invert(f, leaf->diag)) return LIN_UNSTABLE;
    for (int k = 0; k < f->touches; ++k) {
        memcpy(f->into[k], leaf->into[k], (size_t)(b * d) * sizeof(double));
        memset(f->back[k], 0, sizeof f->back[k]);
        multiply_add(d, d, b, 1, f->inverse, leaf->from[k], f->back[k]);
    }
    for (int k = 0; k < f->touches; ++k) {
        double *const diag = chain_block(chain, f->at + k, f->at + k);
        const double before = largest(bb, diag);
        for (int j = 0; j < f->touches; ++j) {
            multiply_add(b, d, b, -1, f->into[k], f->back[j], chain_block(chain, f->at + k, f->at + j));
        }
        const double ratio = largest(bb, diag) / before;
        if (!(ratio <= growth_limit)) return LIN_UNSTABLE;
        *growth = fmax(*growth, ratio);
    }
    return 0;
}

int leaves_condense(Leaves *s, const NewtonMatrix *a, BlockChain *chain, double growth_limit, double *growth)
{
    for (int l = 0; l < s->leaves; ++l) {
        const int status = leaf_condense(s->factor + l, a->leaf + l, chain, growth_limit, growth);
        if (status) return status;
    }
    return 0;
}

void leaves_forward(const Leaves *s, double *chain, double *leaf)
{
    for (int l = 0; l < s->leaves; ++l) {
        const LeafFactor *const f = s->factor + l;
        double solved[LEAF_MAX] = {0};
        multiply_add(f->size, f->size, 1, 1, f->inverse, leaf + f->first, solved);
        memcpy(leaf + f->first, solved, (size_t)f->size * sizeof(double));
        for (int k = 0; k < f->touches; ++k) {
            multiply_add(s->b, f->size, 1, -1, f->into[k], solved, chain + (f->at + k) * s->b);
        }
    }
}

void leaves_back(const Leaves *s, const double *chain, double *leaf)
{
    for (int l = 0; l < s->leaves; ++l) {
        const LeafFactor *const f = s->factor + l;
        for (int k = 0; k < f->touches; ++k) {
            multiply_add(f->size, s->b, 1, -1, f->back[k], chain + (f->at + k) * s->b, leaf + f->first);
        }
    }
}
