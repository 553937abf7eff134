/* A chain of straights, arcs and clothoids through points: each piece begins where the one before ends, with its
 * heading, and for a clothoid with its curvature too. Shared by join, cuts and moves. Equations:
 * docs/theory/16-alignments.md, "Fitting". m, rad, 1/m. */
#ifndef HAWSER_SURVEY_CHAIN_H
#define HAWSER_SURVEY_CHAIN_H

#include "survey/alignment.h"

typedef enum PieceKind { PIECE_STRAIGHT, PIECE_ARC, PIECE_CLOTHOID } PieceKind;

typedef struct Piece {
    PieceKind kind;
    int kept;      /* its curvature is fixed: the file's, or that of a corner's bend */
    int loose;     /* it begins with its own curvature even if it or the piece before is a clothoid */
    int settled;   /* no move about it helped since something near it changed */
    int from;      /* the node at which cuts_find started it */
    PlanElement e; /* during fitting it may not begin exactly where the one before ends */
} Piece;

/* A point to be fitted; several close together are replaced by their mean. */
typedef struct Node {
    double x, y;
    double weight; /* number of points it represents */
    int corner;    /* the line has a corner there: no piece crosses it */
    int drawn;     /* the line to the next one is known to be straight */
    int chord;     /* it is drawn straight, but represents an arc */
} Node;

/* Foot of a node on the chain. */
typedef struct Foot {
    int piece;
    double s;    /* m from the piece's start */
    double away; /* m, the node's distance, to the left positive */
} Foot;

/* Moves n >= 1 pieces through m >= 2 nodes, in their order, by Gauss-Newton on the sum of weighted squares of their
 * distances (FT1)-(FT4), in at most `steps` steps. Stops if ten more steps like the last one would not lower the sum to
 * `enough`, m2 (INFINITY: never). The first and last node also attract the chain's ends. foot: [m]. Errors: MEMORY. */
hawser_status chain_refine(int n, Piece *piece, int m, const Node *node, int steps, double enough, Foot *foot,
                           hawser_error *err);
/* Computes the standard deviation of the curvature of arc q, 1/m, if points scatter by sigma, m: (FT10). The chain must
 * be fitted. NAN: the points do not determine it. Errors: MEMORY. */
hawser_status chain_curvature_sd(int n, const Piece *piece, int q, int m, const Node *node, double sigma, double *sd,
                                 hawser_error *err);
/* Cost of a chain with these feet: (FT6). */
double chain_cost(int n, const Piece *piece, int m, const Node *node, double sigma, const Foot *foot);
/* Moves every piece exactly to the end of the one before. */
void chain_close(int n, Piece *piece);
/* Gain in squares over sigma2 that an additional piece needs (FT6). */
extern const double piece_worth;

/* Cuts the line of m >= 2 nodes into pieces, each the best through its nodes alone, as few as their squares over sigma2
 * allow: the start for chain_refine (FT5), (FT6). *piece is allocated. Errors: MEMORY. */
hawser_status cuts_find(int m, const Node *node, double sigma, int clothoids, Piece **piece, int *n, hawser_error *err);
/* Puts a small arc between pieces with different headings; *piece is reallocated. Errors: MEMORY. */
hawser_status corners_round(Piece **piece, int *n, double deviation, hawser_error *err);
/* Refines the chain, tries fewer, other and more pieces around those that are not settled, and keeps improvements.
 * foot: [m]. Errors: MEMORY. */
hawser_status chain_improve(Piece **piece, int *n, int m, const Node *node, double sigma, int clothoids, Foot *foot,
                            hawser_error *err);
/* Finds the chain through m >= 2 nodes: cut, rounded and improved in blocks, then across their seams. A block with
 * nodes beyond the deviation is tried from other cuts. *piece is allocated. foot: [m]. Errors: INPUT (more pieces than
 * can be fitted in a minute or two), MEMORY. */
hawser_status chain_search(int m, const Node *node, double sigma, double deviation, int clothoids, Piece **piece,
                           int *n, Foot *foot, hawser_error *err);

#endif
