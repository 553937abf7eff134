#include "bench/methods/coloured.h"

#include <stdlib.h>
#include <string.h>
#include <sunmatrix/sunmatrix_sparse.h>

#include "core/chain.h"

/* What a column is moved by: m, rad, m/s or rad/s. 1e-4 of the depth of a contact that carries a segment, 1e-5 of the
 * speed at which friction turns over; rounding of the stiffest bushing's force is 1e-5 of what it makes. */
static const double MOVE = 1e-8;

/* Whether component r of the rates of a segment depends on component c of the state of its own or of a neighbour. */
static int is_entry(int per, int own, int r, int c)
{
    const int velocity = per == PLANAR_SIZE ? PLANAR_V : STATE_V;
    if (r >= velocity) return 1;
    if (!own) return 0;
    if (r == c || (r < 3 && c == r + velocity)) return 1;
    return per == STATE_SIZE && r >= STATE_Q && ((c >= STATE_Q && c < velocity) || c >= STATE_W);
}

/* Rows in rising order; with row NULL only counts. What pads the arrays has its diagonal. */
static sunindextype pattern_fill(const Problem *p, sunindextype *column, sunindextype *row)
{
    const int s = p->stride;
    sunindextype count = 0;
    for (int c = 0; c < p->per; ++c) {
        for (int k = 0; k < s; ++k) {
            column[c * s + k] = count;
            for (int r = 0; r < p->per; ++r) {
                for (int i = k > 0 ? k - 1 : 0; i <= k + 1 && i < s; ++i) {
                    const int inside = i < p->n && k < p->n;
                    if (!(inside ? is_entry(p->per, i == k, r, c) : r == c && i == k)) continue;
                    if (row) row[count] = r * s + i;
                    ++count;
                }
            }
        }
    }
    column[p->per * s] = count;
    return count;
}

int coloured_new(Coloured *c, const Problem *p)
{
    const int size = p->motion->size;
    *c = (Coloured){.p = p, .y = aligned_array_new(size), .f = aligned_array_new(size)};
    c->column = calloc((size_t)size + 1, sizeof *c->column);
    if (!c->column || !c->y || !c->f) return 0;
    c->row = calloc((size_t)pattern_fill(p, c->column, NULL), sizeof *c->row);
    if (!c->row) return 0;
    pattern_fill(p, c->column, c->row);
    return 1;
}

void coloured_free(Coloured *c)
{
    free(c->column);
    free(c->row);
    free(c->y);
    free(c->f);
    memset(c, 0, sizeof *c);
}

sunindextype coloured_entries(const Coloured *c) { return c->column[c->p->motion->size]; }

int coloured_jacobian(Coloured *c, double t, const double *y, const double *fy, SUNMatrix a)
{
    const Problem *const p = c->p;
    const int size = p->motion->size, s = p->stride;
    double *const value = SUNSparseMatrix_Data(a);
    memcpy(SUNSparseMatrix_IndexPointers(a), c->column, ((size_t)size + 1) * sizeof *c->column);
    memcpy(SUNSparseMatrix_IndexValues(a), c->row, (size_t)coloured_entries(c) * sizeof *c->row);
    memset(value, 0, (size_t)coloured_entries(c) * sizeof *value);
    memcpy(c->y, y, (size_t)size * sizeof *y);
    for (int colour = 0; colour < 3 * p->per; ++colour) {
        const int from = colour / 3 * s + colour % 3, to = colour / 3 * s + p->n;
        for (int k = from; k < to; k += 3) c->y[k] = y[k] + MOVE;
        const int bad = p->motion->ops->rates(p->motion, t, c->y, c->f);
        ++c->rhs;
        if (bad) return bad;
        for (int k = from; k < to; k += 3) {
            const double moved = c->y[k] - y[k]; /* as rounded */
            for (sunindextype e = c->column[k]; e < c->column[k + 1]; ++e)
                value[e] = (c->f[c->row[e]] - fy[c->row[e]]) / moved;
            c->y[k] = y[k];
        }
    }
    return 0;
}
