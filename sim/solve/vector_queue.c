#include "sim/solve/vector_queue.h"

#include <string.h>

#include "core/team.h"
#include "sim/solve/vector_kernels.h"

/* Entries of a piece: eight vectors of it fit in a core's first cache, and it is whole lanes, so that every entry is
 * computed by the same instructions as without pieces. */
enum { PIECE = 512 };
/* Entries from which the second thread pays: some 1000 segments in space. */
enum { LONG_VECTOR = 12000 };

static void fill(int count, double a, double *z)
{
    if (!(a < 0 || a > 0)) {
        memset(z, 0, (size_t)count * sizeof *z); /* the case that CVODE uses */
        return;
    }
    for (int i = 0; i < count; ++i) z[i] = a;
}

/* Carries out a task on entries from..from+count-1. */
static void task_piece(const VectorTask *t, int from, int count)
{
    double *x[VECTOR_TERMS_MAX];
    switch (t->kind) {
    case VECTOR_FILL:
        fill(count, t->a[0], t->z + from);
        break;
    case VECTOR_SCALE:
        vector_kernels()->scale(count, t->a[0], t->x[0] + from, t->z + from);
        break;
    case VECTOR_SUM:
        vector_kernels()->linear_sum(count, t->a[0], t->x[0] + from, t->a[1], t->x[1] + from, t->z + from);
        break;
    case VECTOR_COMBINATION:
        for (int k = 0; k < t->terms; ++k) x[k] = t->x[k] + from;
        vector_kernels()->combination(count, t->terms, t->a, x, t->z + from);
        break;
    }
}

void vector_task_run(const VectorTask *task, int length) { task_piece(task, 0, length); }

VectorTask *vector_queue_next(VectorQueue *queue, int length)
{
    if (queue->tasks == VECTOR_TASKS_MAX) vector_queue_flush(queue, length);
    return &queue->task[queue->tasks++];
}

void vector_queue_unfill(VectorQueue *queue, const double *z)
{
    if (queue->tasks == 0) return;
    const VectorTask *const latest = &queue->task[queue->tasks - 1];
    if (latest->kind == VECTOR_FILL && latest->z == z) --queue->tasks;
}

typedef struct Waiting {
    const VectorQueue *queue;
    int length;
} Waiting;

/* Carries out the waiting tasks on entries from..to-1, piece by piece. */
static void stretch_run(const VectorQueue *queue, int from, int to)
{
    for (int at = from; at < to; at += PIECE) {
        const int count = at + PIECE < to ? PIECE : to - at;
        for (int k = 0; k < queue->tasks; ++k) task_piece(&queue->task[k], at, count);
    }
}

/* First entry of the lane that contains entry i: no lane is cut, so that every entry is computed as without
 * stretches. */
static int lane_begin(int i) { return i / LANES * LANES; }

/* Carries out the waiting tasks on one thread's part of every array. */
static void half_run(void *arg, int rank)
{
    const Waiting *const w = arg;
    const VectorQueue *const queue = w->queue;
    const int given = queue->pitch ? *queue->pitch : 0, pitch = given > 0 && given < w->length ? given : w->length;
    const int middle = halves_middle(pitch), arrays = w->length / pitch;
    for (int c = 0; c < arrays; ++c) {
        const int split = lane_begin(c * pitch + middle);
        const int end = c + 1 < arrays ? lane_begin((c + 1) * pitch) : w->length;
        stretch_run(queue, rank ? split : lane_begin(c * pitch), rank ? end : split);
    }
}

void vector_queue_flush(VectorQueue *queue, int length)
{
    if (queue->tasks == 0) return;
    Waiting waiting = {queue, length};
    if (length >= LONG_VECTOR && team_ready(queue->team)) {
        team_run(queue->team, half_run, &waiting);
    } else {
        stretch_run(queue, 0, length);
    }
    queue->tasks = 0;
}
