#include "linsolve/newton_matrix.h"

#include <stddef.h>

/* Pieces of a leaf: its diagonal, and for each of two chain blocks the couplings in both directions. */
enum { LEAF_PIECES = 5, BORDER_PIECES = 3 };

int newton_inner(const NewtonMatrix *a)
{
    int m = a->chain.n * a->chain.b;
    for (int l = 0; l < a->leaves; ++l) m += a->leaf[l].size;
    return m;
}

int newton_size(const NewtonMatrix *a) { return newton_inner(a) + a->border; }

int newton_pieces(const NewtonMatrix *a)
{
    return 3 * a->chain.n + a->extras + LEAF_PIECES * a->leaves + (a->border ? BORDER_PIECES : 0);
}

/* Block (i, i - 1 + d) of the chain; empty where the first and last rows have no neighbour. */
static Piece chain_piece(const BlockChain *c, int i, int d)
{
    const double *const blocks[3] = {c->lower, c->diag, c->upper};
    const int b = c->b, col = i - 1 + d, there = col >= 0 && col < c->n;
    return (Piece){b * i, b * (there ? col : 0), b, there ? b : 0, blocks[d] ? blocks[d] + (size_t)(i * b * b) : NULL};
}

static Piece leaf_piece(const NewtonMatrix *a, int l, int k)
{
    const Leaf *const leaf = a->leaf + l;
    const int b = a->chain.b;
    int first = a->chain.n * b;
    for (int before = 0; before < l; ++before) first += a->leaf[before].size;
    if (k == 0) return (Piece){first, first, leaf->size, leaf->size, leaf->diag};
    const int side = (k - 1) / 2, there = side < leaf->touches, block = b * (there ? leaf->at + side : 0);
    if (k % 2) return (Piece){block, first, b, there ? leaf->size : 0, leaf->into[side]};
    return (Piece){first, block, leaf->size, there ? b : 0, leaf->from[side]};
}

static Piece border_piece(const NewtonMatrix *a, int k)
{
    const int m = newton_inner(a), w = a->border;
    if (k == 0) return (Piece){0, m, m, w, a->right};
    if (k == 1) return (Piece){m, 0, w, m, a->bottom};
    return (Piece){m, m, w, w, a->corner};
}

Piece newton_piece(const NewtonMatrix *a, int k)
{
    const int b = a->chain.b;
    if (k < 3 * a->chain.n) return chain_piece(&a->chain, k / 3, k % 3);
    k -= 3 * a->chain.n;
    if (k < a->extras) return (Piece){b * a->extra[k].row, b * a->extra[k].col, b, b, a->extra[k].block};
    k -= a->extras;
    if (k < LEAF_PIECES * a->leaves) return leaf_piece(a, k / LEAF_PIECES, k % LEAF_PIECES);
    return border_piece(a, k - LEAF_PIECES * a->leaves);
}

int newton_groups(const NewtonMatrix *a, int *at)
{
    const int groups = a->chain.n + a->leaves + (a->border > 0);
    if (!at) return groups;
    int first = 0, g = 0;
    for (; g < a->chain.n; ++g, first += a->chain.b) at[g] = first;
    for (int l = 0; l < a->leaves; first += a->leaf[l++].size) at[g++] = first;
    if (a->border > 0) at[g++] = first;
    at[g] = first + a->border;
    return groups;
}
