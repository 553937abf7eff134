/* Operations on vectors that are deferred until a number is read: then all of them are done together, piece by piece,
 * while each piece is in the nearest cache. In long chains vectors come from main memory, and the integrator's work
 * between two evaluations uses the same few vectors again and again. docs/performance.md, "Scale". */
#ifndef HAWSER_SIM_SOLVE_VECTOR_QUEUE_H
#define HAWSER_SIM_SOLVE_VECTOR_QUEUE_H

#include "core/team.h"

enum {
    VECTOR_TERMS_MAX = 16, /* more than CVODE ever combines: its order is at most 12, plus 2 */
    VECTOR_TASKS_MAX = 12  /* more than CVODE does between two reads, with its usual orders */
};

/* Operation of a task on each entry; z may be x[0] (a sum's x[0] or x[1]). */
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

/* Tasks in the order of their requests, on vectors of one length. */
typedef struct VectorQueue {
    int tasks;
    VectorTask task[VECTOR_TASKS_MAX];
    Team *team; /* borrowed; NULL: one thread. Entries are independent of each other: the bits are the same. */
    /* Vectors begin with arrays of this many entries, one per segment: the threads share them like the segments, so
     * that each finds its own results in its caches. Borrowed; 0, or NULL: in halves. */
    const int *pitch;
} VectorQueue;

/* Does one task at once on vectors of `length`. */
void vector_task_run(const VectorTask *task, int length);
/* Place for the next task; waiting ones are done first if the queue is full. */
VectorTask *vector_queue_next(VectorQueue *queue, int length);
/* Removes the latest task if it fills z, whose numbers will not be read. */
void vector_queue_unfill(VectorQueue *queue, const double *z);
/* Carries out the waiting tasks. */
void vector_queue_flush(VectorQueue *queue, int length);

#endif
