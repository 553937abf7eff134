#include "linsolve/newton_matrix.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* A run of consecutive rows in one column: one column of one piece. */
typedef struct Run {
    int row, rows;
    int slot; /* of SparseAssembly.offset */
} Run;

/* All runs, sorted into columns: column c holds run[start[c]]..run[start[c+1]-1]. */
typedef struct RunTable {
    int *start; /* [n+2] */
    Run *run;
} RunTable;

static int run_table_alloc(RunTable *t, int n, int runs)
{
    t->start = calloc((size_t)n + 2, sizeof *t->start);
    t->run = malloc(((size_t)runs + 1) * sizeof *t->run);
    return t->start && t->run;
}

static void run_table_free(RunTable *t)
{
    free(t->start);
    free(t->run);
}

/* Insertion sort by row; the pieces come nearly in order. */
static void runs_sort(Run *first, const Run *end)
{
    for (Run *r = first; r < end; ++r) {
        const Run run = *r;
        Run *to = r;
        for (; to > first && to[-1].row > run.row; --to) *to = to[-1];
        *to = run;
    }
}

/* Sorts the columns of all pieces into t: counts, appends, then orders each column. */
static void run_table_fill(RunTable *t, const NewtonMatrix *m)
{
    const int n = newton_size(m), pieces = newton_pieces(m);
    int *const next = t->start + 1; /* grows from the beginning of column c to its end */
    for (int k = 0; k < pieces; ++k) {
        const Piece p = newton_piece(m, k);
        for (int c = 0; c < p.cols; ++c) ++t->start[p.col + c + 2];
    }
    for (int c = 0; c < n; ++c) t->start[c + 2] += t->start[c + 1];
    for (int k = 0, slot = 0; k < pieces; ++k) {
        const Piece p = newton_piece(m, k);
        for (int c = 0; c < p.cols; ++c, ++slot) t->run[next[p.col + c]++] = (Run){p.row, p.rows, slot};
    }
    for (int c = 0; c < n; ++c) runs_sort(t->run + t->start[c], t->run + t->start[c + 1]);
}

/* Entries of column c, runs at the same rows counted once. */
static int column_length(const RunTable *t, int c)
{
    int length = 0;
    for (int k = t->start[c]; k < t->start[c + 1]; ++k) {
        if (k > t->start[c] && t->run[k].row == t->run[k - 1].row) continue;
        length += t->run[k].rows;
    }
    return length;
}

/* Writes the rows of column c and the offset of each of its runs. */
static void column_fill(const RunTable *t, int c, SparseAssembly *s)
{
    int at = s->a.p[c], begin = at;
    for (int k = t->start[c]; k < t->start[c + 1]; ++k) {
        const Run run = t->run[k];
        const int again = k > t->start[c] && run.row == t->run[k - 1].row;
        assert(!again || run.rows == t->run[k - 1].rows);
        if (!again) {
            begin = at;
            for (int r = 0; r < run.rows; ++r) s->a.i[at++] = run.row + r;
        }
        s->offset[run.slot] = begin;
    }
}

static int assembly_fill(const RunTable *t, SparseAssembly *s)
{
    for (int c = 0; c < s->a.n; ++c) s->a.p[c + 1] = s->a.p[c] + column_length(t, c);
    const size_t entries = (size_t)s->a.p[s->a.n] + 1;
    s->a.i = malloc(entries * sizeof *s->a.i);
    s->a.x = calloc(entries, sizeof *s->a.x);
    if (!s->a.i || !s->a.x) return 0;
    for (int c = 0; c < s->a.n; ++c) column_fill(t, c, s);
    return 1;
}

int sparse_assembly_new(const NewtonMatrix *m, SparseAssembly *out)
{
    int runs = 0;
    RunTable t = {0};
    *out = (SparseAssembly){.a.n = newton_size(m), .pieces = newton_pieces(m)};
    for (int k = 0; k < out->pieces; ++k) runs += newton_piece(m, k).cols;
    out->offset = malloc(((size_t)runs + 1) * sizeof *out->offset);
    out->a.p = calloc((size_t)out->a.n + 1, sizeof *out->a.p);
    int ok = out->offset && out->a.p && run_table_alloc(&t, out->a.n, runs);
    if (ok) {
        run_table_fill(&t, m);
        ok = assembly_fill(&t, out);
    }
    run_table_free(&t);
    if (!ok) sparse_assembly_free(out);
    return ok;
}

void sparse_assembly_free(SparseAssembly *s)
{
    free(s->a.p);
    free(s->a.i);
    free(s->a.x);
    free(s->offset);
    *s = (SparseAssembly){0};
}

void sparse_assembly_refresh(SparseAssembly *s, const NewtonMatrix *m)
{
    assert(newton_size(m) == s->a.n && newton_pieces(m) == s->pieces);
    memset(s->a.x, 0, (size_t)s->a.p[s->a.n] * sizeof *s->a.x);
    const int *offset = s->offset;
    for (int k = 0; k < s->pieces; ++k) {
        const Piece p = newton_piece(m, k);
        for (int c = 0; c < p.cols; ++c) {
            double *const to = s->a.x + *offset++;
            const double *const from = p.value + (size_t)c * (size_t)p.rows;
            for (int r = 0; r < p.rows; ++r) to[r] += from[r];
        }
    }
}
