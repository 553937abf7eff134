/* Estimate of the memory, disk and time of a run, before anything is built. tests/inject/cost.py compares the memory
 * with measured values. */
#ifndef HAWSER_DEF_COST_H
#define HAWSER_DEF_COST_H

#include "def/scene_def.h"

/* What it depends on. */
typedef struct CostCounts {
    double segments, rollers;
    double beside;       /* further chains */
    double blocks;       /* that couple several chains beside each other: 6 x 6, off the three diagonals */
    double rows, states; /* of series.csv and of results.h5 */
    double duration;     /* s; NAN: not known */
    double step;         /* s, the longest that is allowed; 0: any */
    int planar;          /* solved in the plane */
    int turns;           /* what is wound on a drum is simulated too */
    LinKind solver;
} CostCounts;

typedef struct Cost {
    double memory, disk; /* bytes, at most at a time; bytes of results */
    double time;         /* s, of one thread; NAN: not known */
} Cost;

/* Of a definition that is complete. All of the chain, or of all chains, counts, as it does when all of it has come off
 * its reel. */
CostCounts cost_counts(const SceneDef *def, int planar);
Cost cost_of(const CostCounts *counts);
/* "needs 74 GB, 2.1 h": without the time where it is not known. */
void cost_say(const Cost *cost, int size, char *text);

/* Whether there is so much memory: what is built into the machine, or what the system lets the program have. The scene
 * counts as one in the plane where nobody has said that it is none. Errors: MEMORY, with the estimate. */
hawser_status cost_check(const SceneDef *def, hawser_error *err);

#endif
