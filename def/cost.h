/* Estimated cost of a run before anything is allocated: memory, disk and time. docs/reliability.md compares it with
 * measurements. */
#ifndef HAWSER_DEF_COST_H
#define HAWSER_DEF_COST_H

#include "def/scene_def.h"

/* Quantities that determine the cost. */
typedef struct CostCounts {
    double segments, rollers;
    double beside;       /* further chains */
    double blocks;       /* coupling several parallel chains: 6 x 6, off the three diagonals */
    double rows, states; /* of series.csv and of results.h5 */
    double duration;     /* s; NAN: not known */
    double step;         /* s, longest allowed step; 0: no limit */
    int planar;          /* solved in the plane */
    int turns;           /* the cable wound on a drum is simulated too */
    LinKind solver;
} CostCounts;

typedef struct Cost {
    double memory, disk; /* bytes, maximum at any time; bytes of results */
    double time;         /* s, of one thread; NAN: not known */
} Cost;

/* Computes the counts of a complete definition. The whole chain, or all chains, count, as after they have left the
 * reel. */
CostCounts cost_counts(const SceneDef *def, int planar);
Cost cost_of(const CostCounts *counts);
/* Writes "needs 74 GB, 2.1 h", without the time if it is unknown. */
void cost_say(const Cost *cost, int size, char *text);

/* Checks that the memory suffices: that of the machine, or the system's limit for the program. Unless the case excludes
 * it, the scene counts as planar. Errors: MEMORY, with the estimate. */
hawser_status cost_check(const SceneDef *def, hawser_error *err);

#endif
