/* Operations on vectors that are put off until somebody looks at a number: then all of them are done together, piece by
 * piece, each piece while it is in the nearest cache. In long chains a vector comes from memory, and what the
 * integrator does between two evaluations touches the same few vectors again and again. docs/performance.md, "Scale".
 */
#ifndef HAWSER_SIM_SOLVE_VECTOR_QUEUE_H
#define HAWSER_SIM_SOLVE_VECTOR_QUEUE_H

#include "core/team.h"

enum {
    VECTOR_TERMS_MAX = 16, /* more than CVODE ever combines: its order is at most 12, plus 2 */
    VECTOR_TASKS_MAX = 12  /* more than CVODE does between two looks, with its usual orders */
};

/* What a task does entry by entry; z may be x[0] (a sum's x[0] or x[1]). */
typedef enum VectorTaskKind {
    VECTOR_FILL,       /* z = a[0] */
    VECTOR_SCALE,      /* z = a[0] x[0] */
    VECTOR_SUM,        /* z = a[0] x[0] + a[1] x[1] */
    VECTOR_COMBINATION /* z = sum of a[k] x[k], k < terms */
} VectorTaskKind;

typedef struct VectorTask {
    VectorTaskKind kind;
    int terms;
    double a[VECTOR_TERMS_MAX], *x[VECTOR_TERMS_MAX];
    double *z;
} VectorTask;

/* Tasks in the order in which they were asked for, on vectors of one length. */
typedef struct VectorQueue {
    int tasks;
    VectorTask task[VECTOR_TASKS_MAX];
    Team *team; /* borrowed; NULL: one thread. Entries do not know of each other: the bits are the same. */
    /* Vectors are arrays of so many entries, one a segment, and some entries behind them: the threads share them as
     * they do the segments, so that each finds what it wrote itself in its caches. Borrowed; 0, or NULL: in halves. */
    const int *pitch;
} VectorQueue;

/* Does one task at once on vectors of `length`. */
void vector_task_run(const VectorTask *task, int length);
/* Where to write the next task; what waits is done first if there is no more room. */
VectorTask *vector_queue_next(VectorQueue *queue, int length);
/* Forgets the latest task if it is to fill z, whose numbers nobody will read. */
void vector_queue_unfill(VectorQueue *queue, const double *z);
/* Does what waits. */
void vector_queue_flush(VectorQueue *queue, int length);

#endif
