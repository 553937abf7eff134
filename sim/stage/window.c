#include "sim/stage/window.h"

#include <string.h>

/* Entries -1..n of an array over segments. */
static void segments_copy(const double *from, int first, int n, double *to)
{
    memcpy(to - 1, from + first - 1, (size_t)(n + 2) * sizeof *to);
}

/* Entries 0..n of an array over joints. */
static void joints_copy(const double *from, int first, int n, double *to)
{
    memcpy(to, from + first, (size_t)(n + 1) * sizeof *to);
    if (first > 0) to[0] = 0;
}

int window_chain(const Chain *whole, int first, int n, Chain *out)
{
    if (!chain_alloc(out, n)) return 0;
    out->frame = whole->frame;
    segments_copy(whole->half, first, n, out->half);
    segments_copy(whole->mass, first, n, out->mass);
    segments_copy(whole->radius, first, n, out->radius);
    for (int c = 0; c < 3; ++c) segments_copy(whole->inertia[c], first, n, out->inertia[c]);
    if (!chain_alloc_sliders(out, whole->sliders.count)) {
        chain_free(out);
        return 0;
    }
    for (int k = 0; k < whole->sliders.count; ++k) {
        joints_copy(whole->sliders.stiffness[k], first, n, out->sliders.stiffness[k]);
        memcpy(out->sliders.limit[k], whole->sliders.limit[k] + first, (size_t)(n + 1) * sizeof(double));
    }
    for (int c = 0; c < 6; ++c) {
        joints_copy(whole->stiffness[c], first, n, out->stiffness[c]);
        joints_copy(whole->damping[c], first, n, out->damping[c]);
        joints_copy(whole->preload[c], first, n, out->preload[c]);
    }
    return 1;
}

void window_end(const Chain *whole, Chain *out)
{
    out->half[out->n] = 0;
    for (int c = 0; c < 6; ++c) {
        out->stiffness[c][out->n] = whole->stiffness[c][whole->n];
        out->damping[c][out->n] = whole->damping[c][whole->n];
        out->preload[c][out->n] = whole->preload[c][whole->n];
    }
}

WindowMove window_move(int n, int joined, int left)
{
    WindowMove m = {.from = n, .to = n + joined - left, .joined = joined, .left = left};
    for (int c = 0; c < STATE_SIZE; ++c) m.scale[c] = 1;
    return m;
}

void window_map(const WindowMove *move, int extra, int is_state, const double *from, double *to)
{
    const size_t kept = (size_t)(move->from - move->left);
    for (int c = 0; c < STATE_SIZE; ++c) {
        const double *const old = from + c * move->from;
        double *const row = to + c * move->to;
        memcpy(row + move->joined, old, kept * sizeof *row);
        if (move->joined) row[0] = move->scale[c] * old[0] + (is_state ? move->offset[c] : 0);
    }
    memcpy(to + STATE_SIZE * move->to, from + STATE_SIZE * move->from, (size_t)extra * sizeof *to);
}
