/* The part of a chain that is simulated: segments first..first+n-1 of the whole, in arrays of their own. docs/model.md,
 * "Reel and take-in". */
#ifndef HAWSER_SIM_STAGE_WINDOW_H
#define HAWSER_SIM_STAGE_WINDOW_H

#include "core/chain.h"
#include "core/state.h"

/* Copies segments first..first+n-1 with their joints. What lies beyond the head keeps its length and its joint, as the
 * last segment that was taken in does (RL16); the tail's joint is free unless it is the whole chain's. Returns 0 if
 * there is no memory. */
int window_chain(const Chain *whole, int first, int n, Chain *out);

/* Ends the window's chain as the whole one ends: with its last joint, and nothing beyond. */
void window_end(const Chain *whole, Chain *out);

/* How the state changes when one segment comes or goes: rows of 13 numbers, a row a segment. */
typedef struct WindowMove {
    int from, to;                                 /* segments before and after */
    int joined;                                   /* 1: one more behind the tail */
    int left;                                     /* 1: the head's segment is gone */
    double scale[STATE_SIZE], offset[STATE_SIZE]; /* of the joined segment's row: scale * the old tail's + offset */
} WindowMove;

/* A move that copies what stays. */
WindowMove window_move(int n, int joined, int left);
/* Maps a vector of 13 arrays of `from`, and whatever else may follow them, to 13 arrays of `to`; the offset counts in
 * the state only, not in its derivatives and differences. `extra` is the number of entries that follow. */
void window_map(const WindowMove *move, int extra, int is_state, const double *from, double *to);

#endif
