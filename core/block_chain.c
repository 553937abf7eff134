#include "core/block_chain.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "core/chain.h"

int block_chain_alloc(BlockChain *a, int n, int b)
{
    const int count = n * b * b;
    *a = (BlockChain){.n = n,
                      .b = b,
                      .lower = aligned_array_new(count),
                      .diag = aligned_array_new(count),
                      .upper = aligned_array_new(count)};
    if (a->lower && a->diag && a->upper) return 1;
    block_chain_free(a);
    return 0;
}

void block_chain_free(BlockChain *a)
{
    free(a->lower);
    free(a->diag);
    free(a->upper);
    *a = (BlockChain){0};
}

void block_chain_zero(BlockChain *a)
{
    const size_t bytes = (size_t)a->n * (size_t)(a->b * a->b) * sizeof(double);
    memset(a->lower, 0, bytes);
    memset(a->diag, 0, bytes);
    memset(a->upper, 0, bytes);
}

void block_chain_copy(BlockChain *to, const BlockChain *from)
{
    assert(to->n == from->n && to->b == from->b);
    const size_t bytes = (size_t)to->n * (size_t)(to->b * to->b) * sizeof(double);
    memcpy(to->lower, from->lower, bytes);
    memcpy(to->diag, from->diag, bytes);
    memcpy(to->upper, from->upper, bytes);
}

void block_chain_checkpoint(Checkpoint *c, const char *name, BlockChain *a)
{
    const size_t bytes = (size_t)a->n * (size_t)(a->b * a->b) * sizeof(double);
    checkpoint_put(c, name, a->lower, bytes);
    checkpoint_put(c, name, a->diag, bytes);
    checkpoint_put(c, name, a->upper, bytes);
}

enum { BLOCK = 36 };

int block_extras_alloc(BlockExtras *x, int n)
{
    memset(x, 0, sizeof *x);
    x->n = n;
    x->start = calloc((size_t)n + 1, sizeof *x->start);
    return x->start != NULL;
}

void block_extras_free(BlockExtras *x)
{
    free(x->start);
    free(x->row);
    free(x->col);
    free(x->k);
    free(x->d);
    free(x->live);
    memset(x, 0, sizeof *x);
}

static int pair_compare(const void *a, const void *b)
{
    const BlockPair *const p = a, *const q = b;
    return p->low != q->low ? (p->low > q->low) - (p->low < q->low) : (p->high > q->high) - (p->high < q->high);
}

/* Sorts the pairs and removes repetitions; returns how many are left. */
static int pairs_unique(int count, BlockPair *pair)
{
    if (count > 0) qsort(pair, (size_t)count, sizeof *pair, pair_compare);
    int kept = 0;
    for (int p = 0; p < count; ++p) {
        if (kept == 0 || pair_compare(&pair[kept - 1], &pair[p]) != 0) pair[kept++] = pair[p];
    }
    return kept;
}

/* Checks whether the pattern is exactly that of the sorted pairs: each is in it, and the number is right. */
static int pattern_is(const BlockExtras *x, int count, const BlockPair *pair)
{
    if (x->count != 2 * count) return 0;
    for (int p = 0; p < count; ++p) {
        if (block_extras_find(x, pair[p].low, pair[p].high) < 0) return 0;
    }
    return 1;
}

/* Allocates everything but n of an empty set with room for `count` blocks. */
static int room_new(BlockExtras *x, int n, int count)
{
    memset(x, 0, sizeof *x);
    x->n = n;
    x->count = x->allocated = count;
    x->start = calloc((size_t)n + 1, sizeof *x->start);
    x->row = malloc(((size_t)count + 1) * sizeof *x->row);
    x->col = malloc(((size_t)count + 1) * sizeof *x->col);
    /* a vector of eight may be loaded from the last column of the last block */
    x->k = calloc((size_t)count * BLOCK + 8, sizeof *x->k);
    x->d = calloc((size_t)count * BLOCK + 8, sizeof *x->d);
    x->live = calloc((size_t)count + 1, sizeof *x->live);
    if (x->start && x->row && x->col && x->k && x->d && x->live) return 1;
    block_extras_free(x);
    return 0;
}

/* Fills in both places of every pair, row by row. Pairs are sorted by (low, high): in this order the columns below the
 * diagonal come first and rise, then those above. */
static void pattern_fill(BlockExtras *x, int count, const BlockPair *pair)
{
    for (int p = 0; p < count; ++p) {
        ++x->start[pair[p].low + 1];
        ++x->start[pair[p].high + 1];
    }
    for (int i = 0; i < x->n; ++i) x->start[i + 1] += x->start[i];
    for (int below = 1; below >= 0; --below) {
        for (int p = 0; p < count; ++p) {
            const int row = below ? pair[p].high : pair[p].low, at = x->start[row]++;
            x->row[at] = row;
            x->col[at] = below ? pair[p].low : pair[p].high;
        }
    }
    /* every start has moved to that of the next row */
    for (int i = x->n; i > 0; --i) x->start[i] = x->start[i - 1];
    x->start[0] = 0;
}

int block_extras_set(BlockExtras *x, int count, BlockPair *pair)
{
    const int kept = pairs_unique(count, pair);
    if (pattern_is(x, kept, pair)) return 1;
    BlockExtras next;
    if (!room_new(&next, x->n, 2 * kept)) return 0;
    pattern_fill(&next, kept, pair);
    next.version = x->version + 1;
    for (int e = 0; e < next.count; ++e) {
        const int old = block_extras_find(x, next.row[e], next.col[e]);
        if (old < 0) continue;
        memcpy(next.k + BLOCK * e, x->k + BLOCK * old, BLOCK * sizeof(double));
        memcpy(next.d + BLOCK * e, x->d + BLOCK * old, BLOCK * sizeof(double));
        next.live[e] = x->live[old];
    }
    block_extras_free(x);
    *x = next;
    return 1;
}

void block_extras_zero(BlockExtras *x)
{
    for (int e = 0; e < x->count; ++e) {
        if (!x->live[e]) continue;
        memset(x->k + BLOCK * e, 0, BLOCK * sizeof(double));
        memset(x->d + BLOCK * e, 0, BLOCK * sizeof(double));
        x->live[e] = 0;
    }
}

int block_extras_find(const BlockExtras *x, int row, int col)
{
    assert(row >= 0 && row < x->n);
    int low = x->start[row], high = x->start[row + 1];
    while (low < high) {
        const int middle = (low + high) / 2;
        if (x->col[middle] < col) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low < x->start[row + 1] && x->col[low] == col ? low : -1;
}

int block_extras_touch(BlockExtras *x, int row, int col)
{
    const int e = block_extras_find(x, row, col);
    assert(e >= 0);
    x->live[e] = 1;
    return e;
}

void block_extras_gemv(const BlockExtras *x, double s, const double *z, double *y)
{
    for (int e = 0; e < x->count; ++e) {
        if (!x->live[e]) continue;
        const double *const block = x->k + BLOCK * e, *const from = z + 6 * x->col[e];
        double *const to = y + 6 * x->row[e];
        for (int c = 0; c < 6; ++c) {
            for (int r = 0; r < 6; ++r) to[r] += s * block[6 * c + r] * from[c];
        }
    }
}

/* Checks whether rows and columns rise within the matrix, row by row by `start`, and every pair is there twice. */
static int pattern_fits(const BlockExtras *x)
{
    if (x->start[0] != 0 || x->start[x->n] != x->count) return 0;
    for (int i = 0; i < x->n; ++i) {
        if (x->start[i + 1] < x->start[i] || x->start[i + 1] > x->count) return 0;
        for (int e = x->start[i]; e < x->start[i + 1]; ++e) {
            if (x->row[e] != i || x->col[e] < 0 || x->col[e] >= x->n) return 0;
            if (e > x->start[i] && x->col[e] <= x->col[e - 1]) return 0;
        }
    }
    for (int e = 0; e < x->count; ++e) {
        if (block_extras_find(x, x->col[e], x->row[e]) < 0) return 0;
    }
    return 1;
}

void block_extras_checkpoint(Checkpoint *c, BlockExtras *x)
{
    int count = x->count;
    CHECKPOINT(c, count);
    checkpoint_check(c, count % 2 == 0, "a number of blocks is impossible");
    if (!checkpoint_number(c, count, 2 * BLOCK * sizeof *x->k, "a number of blocks is impossible")) return;
    if (c->reading && count > 0) {
        const int n = x->n;
        block_extras_free(x);
        if (!room_new(x, n, count)) checkpoint_lack(c);
    }
    if (c->status) return;
    x->count = count;
    CHECKPOINT(c, x->version);
    checkpoint_longs(c, 1, &x->version);
    checkpoint_put(c, "x->start", x->start, ((size_t)x->n + 1) * sizeof *x->start);
    if (count == 0) { /* without blocks the rows are not needed */
        if (c->reading && !c->status) memset(x->start, 0, ((size_t)x->n + 1) * sizeof *x->start);
        return;
    }
    checkpoint_put(c, "x->row", x->row, (size_t)count * sizeof *x->row);
    checkpoint_put(c, "x->col", x->col, (size_t)count * sizeof *x->col);
    if (!c->status && !checkpoint_check(c, pattern_fits(x), "blocks off the diagonals are impossible")) return;
    checkpoint_put(c, "x->k", x->k, (size_t)count * BLOCK * sizeof *x->k);
    checkpoint_put(c, "x->d", x->d, (size_t)count * BLOCK * sizeof *x->d);
    checkpoint_put(c, "x->live", x->live, (size_t)count * sizeof *x->live);
}
