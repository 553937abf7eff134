/* The order of elimination along the chains, and the blocks that it fills. */
#include <stdlib.h>
#include <string.h>

#include "linsolve/block/block_sparse.h"

/* Neighbours of every row: near[start[i]] .. near[start[i+1]-1]. */
typedef struct Graph {
    int n;
    int *start, *near;
} Graph;

static int graph_make(Graph *g, int n, int count, const BlockPair *coupled)
{
    *g = (Graph){n, calloc((size_t)n + 2, sizeof(int)), malloc((2 * (size_t)count + 1) * sizeof(int))};
    if (!g->start || !g->near) return 0;
    int *const next = g->start + 1;
    for (int c = 0; c < count; ++c) {
        ++next[coupled[c].low + 1];
        ++next[coupled[c].high + 1];
    }
    for (int i = 0; i < n; ++i) next[i + 1] += next[i];
    for (int c = 0; c < count; ++c) {
        g->near[next[coupled[c].low]++] = coupled[c].high;
        g->near[next[coupled[c].high]++] = coupled[c].low;
    }
    return 1;
}

static void graph_free(Graph *g)
{
    free(g->start);
    free(g->near);
}

void block_pattern_free(BlockPattern *p)
{
    free(p->row);
    free(p->place);
    free(p->start);
    free(p->below);
    free(p->update);
    free(p->updates);
    memset(p, 0, sizeof *p);
}

static int pattern_room(BlockPattern *p, int n)
{
    if (p->row) return 1;
    const size_t rows = (size_t)n + 1;
    p->n = n;
    p->row = calloc(rows, sizeof(int));
    p->place = malloc(rows * sizeof(int));
    p->start = calloc(rows, sizeof(int));
    p->updates = calloc(rows, sizeof(int));
    if (p->row && p->place && p->start && p->updates) return 1;
    block_pattern_free(p); /* nothing half made is left for the next try */
    return 0;
}

/* list has room for `count`; 0 if there is no memory. */
static int list_room(int **list, int *allocated, int count)
{
    if (count <= *allocated) return 1;
    const int more = 2 * count + 64;
    int *const grown = realloc(*list, (size_t)more * sizeof *grown);
    if (!grown) return 0;
    *list = grown;
    *allocated = more;
    return 1;
}

static int int_compare(const void *a, const void *b) { return *(const int *)a - *(const int *)b; }

/* What elimination in the order p->row fills: column k has what its row couples with later, and what those columns have
 * whose first block is in row k. */
static int fill(BlockPattern *p, const Graph *g)
{
    const int n = p->n;
    int *const mark = malloc(3 * (size_t)n * sizeof *mark + 1), *const child = mark + n, *const sibling = child + n;
    int count = 0, ok = mark != NULL;
    for (int k = 0; ok && k < n; ++k) mark[k] = child[k] = -1;
    for (int k = 0; ok && k < n; ++k) {
        p->start[k] = count;
        ok = list_room(&p->below, &p->allocated, count + n - k);
        mark[k] = k;
        const int row = p->row[k];
        for (int e = g->start[row]; ok && e < g->start[row + 1]; ++e) {
            const int i = p->place[g->near[e]];
            if (i > k && mark[i] != k) p->below[count++] = i, mark[i] = k;
        }
        for (int c = ok ? child[k] : -1; c >= 0; c = sibling[c]) {
            for (int e = p->start[c]; e < p->start[c + 1]; ++e) {
                const int i = p->below[e];
                if (mark[i] != k) p->below[count++] = i, mark[i] = k;
            }
        }
        p->start[k + 1] = count;
        const int own = count - p->start[k];
        if (own > 1) qsort(p->below + p->start[k], (size_t)own, sizeof(int), int_compare);
        if (!own) continue;
        const int parent = p->below[p->start[k]];
        sibling[k] = child[parent];
        child[parent] = k;
    }
    free(mark);
    return ok;
}

/* The number of the block at (i, j) of the rows in their order. */
static int block_of(const BlockPattern *p, int i, int j)
{
    if (i == j) return i;
    const int column = i > j ? j : i, row = i > j ? i : j;
    int low = p->start[column], high = p->start[column + 1];
    while (low + 1 < high) {
        const int middle = (low + high) / 2;
        if (p->below[middle] <= row) low = middle;
        if (p->below[middle] > row) high = middle;
    }
    return p->n + low + (i > j ? 0 : p->start[p->n]);
}

int block_pattern_find(const BlockPattern *p, int row, int col) { return block_of(p, p->place[row], p->place[col]); }

/* Where the products of each column's blocks go. */
static int updates_set(BlockPattern *p)
{
    int count = 0;
    for (int k = 0; k < p->n; ++k) {
        const int own = p->start[k + 1] - p->start[k];
        p->updates[k] = count;
        if (!list_room(&p->update, &p->updates_allocated, count + own * own)) return 0;
        for (int a = p->start[k]; a < p->start[k + 1]; ++a) {
            for (int b = p->start[k]; b < p->start[k + 1]; ++b)
                p->update[count++] = block_of(p, p->below[a], p->below[b]);
        }
    }
    p->updates[p->n] = count;
    return 1;
}

static int degree(const Graph *g, int i) { return g->start[i + 1] - g->start[i]; }

/* Takes the rows that row number k of the order couples with and that have no place yet, those with fewer neighbours
 * first, to the order's end; returns its new length. */
static int neighbours_take(BlockPattern *p, const Graph *g, int k, int count)
{
    const int from = count, row = p->row[k];
    for (int e = g->start[row]; e < g->start[row + 1]; ++e) {
        const int j = g->near[e];
        if (p->place[j] >= 0) continue;
        p->place[j] = 0;
        int at = count++;
        for (; at > from && degree(g, p->row[at - 1]) > degree(g, j); --at) p->row[at] = p->row[at - 1];
        p->row[at] = j;
    }
    return count;
}

/* Cuthill and McKee's order, reversed (L15): rows by their distance from an end of what is coupled, so that chains
 * beside each other go side by side, and the band is as wide as there are chains. */
static void along(BlockPattern *p, const Graph *g)
{
    enum { PASSES = 3 }; /* from anywhere to an end, to the other end, and back through all */
    int count = 0;
    for (int i = 0; i < p->n; ++i) p->place[i] = -1;
    for (int i = 0; i < p->n; ++i) {
        if (p->place[i] >= 0) continue;
        const int first = count;
        int root = i;
        for (int pass = 0; pass < PASSES; ++pass) {
            for (int k = first; k < count; ++k) p->place[p->row[k]] = -1;
            count = first + 1;
            p->row[first] = root;
            p->place[root] = 0;
            for (int k = first; k < count; ++k) count = neighbours_take(p, g, k, count);
            root = p->row[count - 1];
        }
    }
    for (int k = 0; k < p->n / 2; ++k) {
        const int row = p->row[k];
        p->row[k] = p->row[p->n - 1 - k];
        p->row[p->n - 1 - k] = row;
    }
    for (int k = 0; k < p->n; ++k) p->place[p->row[k]] = k;
}

int block_pattern_set(BlockPattern *p, int n, int count, const BlockPair *coupled)
{
    Graph g;
    int ok = graph_make(&g, n, count, coupled) && pattern_room(p, n);
    if (ok) along(p, &g);
    ok = ok && fill(p, &g) && updates_set(p);
    graph_free(&g);
    return ok;
}
