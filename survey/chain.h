/* A chain of straights, arcs and clothoids that is laid through points: each piece begins where the one before ends,
 * with its heading, and a clothoid with its curvature too. What join, cuts and moves share. Equations:
 * docs/model/16-alignments.md, "Fitting". m, rad, 1/m. */
#ifndef HAWSER_SURVEY_CHAIN_H
#define HAWSER_SURVEY_CHAIN_H

#include "survey/alignment.h"

typedef enum PieceKind { PIECE_STRAIGHT, PIECE_ARC, PIECE_CLOTHOID } PieceKind;

typedef struct Piece {
    PieceKind kind;
    int kept;      /* its curvature is the file's, or that of a corner's bend, and stays */
    int loose;     /* it begins with a curvature of its own even where it or the piece before is a clothoid */
    int settled;   /* no move about it has helped since something near it changed */
    int from;      /* the node at which cuts_find began it */
    PlanElement e; /* while it is fitted not quite where the one before ends */
} Piece;

/* A point to be met; several that lie close together are one with their mean. */
typedef struct Node {
    double x, y;
    double weight; /* how many points it stands for */
    int corner;    /* the line has a corner there: no piece goes over it */
    int drawn;     /* the way to the next one is known to be straight */
    int chord;     /* it is drawn straight, but for an arc */
} Node;

/* Where a node is beside the chain. */
typedef struct Foot {
    int piece;
    double s;    /* m from the piece's start */
    double away; /* m, the node's distance, to the left positive */
} Foot;

/* Moves n >= 1 pieces through m >= 2 nodes, in their order, by Gauss-Newton on the sum of weighted squares of their
 * distances (FT1)-(FT4), at most `steps` times; given up where ten more steps like the last one would not bring the sum
 * down to `enough`, m2 (INFINITY: never). The first and last node pull at the chain's ends. foot: [m]. Errors: MEMORY.
 */
hawser_status chain_refine(int n, Piece *piece, int m, const Node *node, int steps, double enough, Foot *foot,
                           hawser_error *err);
/* The standard deviation of the curvature of arc q, 1/m, if points scatter by sigma, m: (FT10). The chain is where it
 * fits best. NAN: the points do not tell. Errors: MEMORY. */
hawser_status chain_curvature_sd(int n, const Piece *piece, int q, int m, const Node *node, double sigma, double *sd,
                                 hawser_error *err);
/* What a chain costs that is as foot says beside its nodes: (FT6). */
double chain_cost(int n, const Piece *piece, int m, const Node *node, double sigma, const Foot *foot);
/* Lets every piece begin where the one before ends, exactly. */
void chain_close(int n, Piece *piece);
/* What one piece more must gain in squares over sigma2, so that it is worth having (FT6). */
extern const double piece_worth;

/* Cuts the line of m >= 2 nodes into pieces, each for itself the best through its nodes, as few as their squares over
 * sigma2 allow: the start for chain_refine (FT5), (FT6). *piece is allocated. Errors: MEMORY. */
hawser_status cuts_find(int m, const Node *node, double sigma, int clothoids, Piece **piece, int *n, hawser_error *err);
/* Puts a small arc where one piece's heading is not the next one's; *piece is reallocated. Errors: MEMORY. */
hawser_status corners_round(Piece **piece, int *n, double deviation, hawser_error *err);
/* Refines the chain, tries to do without pieces, with others and with more about those that are not settled, and keeps
 * what is better. foot: [m]. Errors: MEMORY. */
hawser_status chain_improve(Piece **piece, int *n, int m, const Node *node, double sigma, int clothoids, Foot *foot,
                            hawser_error *err);
/* The chain through m >= 2 nodes, from nothing: cut, rounded and improved in blocks, then across their seams. A block
 * that leaves nodes beyond the deviation is tried from other cuts. *piece is allocated. foot: [m]. Errors: INPUT (more
 * pieces than can be fitted in a minute or two), MEMORY. */
hawser_status chain_search(int m, const Node *node, double sigma, double deviation, int clothoids, Piece **piece,
                           int *n, Foot *foot, hawser_error *err);

#endif
