/* A long line is fitted in blocks of some pieces, and then across the seams between them: the search's time grows with
 * the length, and a place where it fails is tried again by itself. docs/model/16-alignments.md, "Long lines". */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "survey/fit/chain.h"

/* Pieces a block; within how many of them the longest one is where it ends; pieces on either side of a seam that are
 * gone over again. */
enum { BLOCK_PIECES = 24, BLOCK_SLACK = 8, SEAM_ASIDE = 4 };
/* How often a line's blocks are tried again, beside once for every second of them. */
enum { RETRIES = 10 };
/* Beyond these pieces it is not a line but a maze, on which the search would take minutes; so it is beyond fewer of
 * them where a piece has hardly more nodes than unknowns, as in a zigzag or where the scatter is larger than the
 * deviation. A survey has some 30 nodes a piece, the straight of a drawn line 12. */
enum { PIECES_MOST = 1500, MAZE_PIECES = 400, MAZE_NODES = 6 };

/* A chain of a part of the line. */
typedef struct Part {
    int n;
    Piece *piece; /* [n] */
    double cost;  /* (FT6) */
    double worst; /* m, how far the farthest node is off */
} Part;

/* Some nodes of the line, with what the whole search is about. */
typedef struct Stretch {
    const Node *node; /* [m] */
    int m, clothoids;
    double sigma, deviation;
    Foot *foot; /* [m] */
    hawser_error *err;
} Stretch;

/* The best chain from one start: cuts for points that scatter by `start`. */
static hawser_status part_from(const Stretch *s, double start, Part *p)
{
    *p = (Part){.worst = 0};
    hawser_status status = cuts_find(s->m, s->node, start, s->clothoids, &p->piece, &p->n, s->err);
    if (!status) status = corners_round(&p->piece, &p->n, s->deviation, s->err);
    if (!status) status = chain_improve(&p->piece, &p->n, s->m, s->node, s->sigma, s->clothoids, s->foot, s->err);
    p->cost = chain_cost(p->n, p->piece, s->m, s->node, s->sigma, s->foot);
    for (int i = 0; i < s->m && !status; ++i) p->worst = fmax(p->worst, fabs(s->foot[i].away));
    return status;
}

static int is_better(const Stretch *s, const Part *a, const Part *b)
{
    const int a_within = a->worst <= s->deviation, b_within = b->worst <= s->deviation;
    return a_within != b_within ? a_within : a->cost < b->cost;
}

/* The best chain of several starts, if the first one leaves nodes beyond the deviation: the search goes downhill only,
 * and from finer or coarser cuts it goes another way. *retries: how many are left. */
static hawser_status part_find(const Stretch *s, int *retries, Part *best)
{
    static const double other[] = {0.5, 2, 0.25, 0.7, 1.4};
    hawser_status status = part_from(s, s->sigma, best);
    for (size_t i = 0; i < sizeof other / sizeof *other && !status && best->worst > s->deviation && *retries > 0; ++i) {
        --*retries;
        Part next;
        status = part_from(s, other[i] * s->sigma, &next);
        if (!status && is_better(s, &next, best)) {
            Part kept = *best;
            *best = next;
            next = kept;
        }
        free(next.piece);
    }
    return status;
}

/* ---------------------------------------------------------------------------------------------------------- seams */

/* Straights that go on in one another are one piece; so are the halves of an arc or clothoid. `into` keeps its start.
 */
static void halves_merge(Piece *into, const Piece *behind)
{
    const double length = into->e.length + behind->e.length;
    const double turn =
        0.5 * into->e.length * (into->e.k0 + into->e.k1) + 0.5 * behind->e.length * (behind->e.k0 + behind->e.k1);
    into->e.length = length;
    if (into->kind == PIECE_ARC) into->e.k0 = into->e.k1 = turn / length;
    if (into->kind == PIECE_CLOTHOID) into->e.k1 = behind->e.k1;
}

/* A block's pieces behind the *n that are there, in room for all; the first of them goes on from the last one there if
 * both are of a kind. */
static void part_append(const Part *p, int goes_on, Piece *piece, int *n)
{
    const int merged = goes_on && piece[*n - 1].kind == p->piece[0].kind;
    if (merged) halves_merge(&piece[*n - 1], &p->piece[0]);
    memcpy(&piece[*n], &p->piece[merged], (size_t)(p->n - merged) * sizeof *piece);
    *n += p->n - merged;
}

/* The node in the middle of the longest piece about the one that is a block's length behind piece *q, which it becomes.
 * The last node if the line ends before. */
static int seam_find(int n, const Piece *piece, int *q, int m)
{
    int best = *q + BLOCK_PIECES;
    if (best + BLOCK_PIECES > n) return m - 1;
    for (int i = best - BLOCK_SLACK; i <= *q + BLOCK_PIECES + BLOCK_SLACK; ++i) {
        if (piece[i].e.length > piece[best].e.length) best = i;
    }
    *q = best;
    return (piece[best].from + piece[best + 1].from) / 2;
}

/* The line block by block, each for itself; the pieces about seams are not settled. *piece: allocated. */
static hawser_status blocks_fit(const Stretch *all, int n_cuts, const Piece *cut, Piece **piece, int *n)
{
    hawser_status status = HAWSER_OK;
    int retries = RETRIES + n_cuts / (2 * BLOCK_PIECES);
    for (int q = 0, at = 0, to = 0; at < all->m - 1 && !status; at = to) {
        to = seam_find(n_cuts, cut, &q, all->m);
        Stretch s = *all;
        Part p;
        s.node += at;
        s.m = to - at + 1;
        status = part_find(&s, &retries, &p);
        for (int i = 0; i < p.n; ++i) {
            p.piece[i].settled = (at == 0 || i >= SEAM_ASIDE) && (to == all->m - 1 || i < p.n - SEAM_ASIDE);
        }
        Piece *const wider = status ? NULL : realloc(*piece, (size_t)(*n + p.n) * sizeof *wider);
        if (!status && !wider) status = error_memory(all->err);
        if (wider) {
            *piece = wider;
            part_append(&p, at > 0, *piece, n);
        }
        free(p.piece);
    }
    return status;
}

static hawser_status maze_refuse(int m, int n_cuts, hawser_error *err)
{
    if (n_cuts > PIECES_MOST)
        return error_set(err, HAWSER_ERR_INPUT,
                         "a line that falls into %d straights and bends, of which at most %d can be fitted: give its "
                         "corners a radius instead, or split the file",
                         n_cuts, PIECES_MOST);
    if (n_cuts > MAZE_PIECES && m < MAZE_NODES * n_cuts)
        return error_set(err, HAWSER_ERR_INPUT,
                         "a line that turns at nearly every point: %d straights and bends over %d points, which no "
                         "fit can tell apart: a larger tolerance, a radius for its corners, or fewer points",
                         n_cuts, m);
    return HAWSER_OK;
}

hawser_status chain_search(int m, const Node *node, double sigma, double deviation, int clothoids, Piece **piece,
                           int *n, Foot *foot, hawser_error *err)
{
    const Stretch all = {node, m, clothoids, sigma, deviation, foot, err};
    Piece *cut = NULL;
    int n_cuts = 0;
    *piece = NULL;
    *n = 0;
    hawser_status status = cuts_find(m, node, sigma, clothoids, &cut, &n_cuts, err);
    if (!status) status = maze_refuse(m, n_cuts, err);
    if (!status) status = blocks_fit(&all, n_cuts, cut, piece, n);
    if (!status && n_cuts >= 2 * BLOCK_PIECES) status = chain_improve(piece, n, m, node, sigma, clothoids, foot, err);
    free(cut);
    return status;
}
