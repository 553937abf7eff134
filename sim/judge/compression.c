#include "sim/judge/compression.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "sim/watch/sample.h"

enum { BLOCK_LEAST = 4 };        /* samples, for a mean to be one */
static const double PART = 0.25; /* of a segment, that passes while it is pushed, */
static const double LASTS = 1;   /* s, and for how long: what is shorter is a stop's or a jolt's */

hawser_status compression_new(Compression *c, const Scene *scene, hawser_error *err)
{
    *c = (Compression){.joints = scene->total + 1, .last = -1};
    c->n_pushers = scene_pushers(scene, &c->pusher);
    c->sum = calloc((size_t)c->joints, sizeof *c->sum);
    c->time = calloc((size_t)c->joints, sizeof *c->time);
    c->force = calloc((size_t)(c->n_pushers > 0 ? c->n_pushers : 0) + 1, sizeof *c->force);
    return c->n_pushers < 0 || !c->sum || !c->time || !c->force ? error_memory(err) : HAWSER_OK;
}

void compression_free(Compression *c)
{
    free(c->sum);
    free(c->time);
    free(c->force);
    free(c->pusher);
    *c = (Compression){0};
}

static void pushes_take(Compression *c, const hawser_sample *sample)
{
    for (int k = 0; k < c->n_pushers; ++k) {
        const char *const kind = c->pusher[k].room->kind->machines->key;
        for (int i = 0; i < sample->machines; ++i) {
            const hawser_machine *const machine = &sample->machine[i];
            if (strcmp(machine->kind, kind) || strcmp(machine->name, c->pusher[k].name)) continue;
            const double force = hawser_machine_figure(machine, "force_N"); /* of a motor's torque: what is reckoned */
            c->force[k] = fmax(c->force[k], isnan(force) ? hawser_machine_figure(machine, "reference_N") : force);
        }
    }
}

/* N, with which machines have pushed what is ahead of them at s. */
static double pushed_at(const Compression *c, double s)
{
    double most = 0;
    for (int k = 0; k < c->n_pushers && c->pusher[k].from <= s; ++k) most = fmax(most, c->force[k]);
    return most;
}

/* The joints that were there all through the block. */
static void block_end(Compression *c, const Scene *scene, const hawser_sample *sample)
{
    const double whole = sample->t - c->began, middle = (c->travel + sample->winch_travel) / 2;
    for (int j = 0; j <= scene->eye && j < c->joints; ++j) {
        const double s = scene->joint_s[j] + middle, least = scene->weight.lead_in ? 0 : -INFINITY;
        if (!(c->time[j] > 0.99 * whole) || s < least || s > scene->route.length) continue;
        const double tension = c->sum[j] / c->time[j], pushed = -tension - pushed_at(c, s);
        c->pulled = fmax(c->pulled, tension);
        if (!(pushed > c->most.value)) continue;
        c->most = (Peak){pushed, s};
        c->when = c->began + whole / 2;
    }
}

static void block_begin(Compression *c, const hawser_sample *sample)
{
    memset(c->sum, 0, (size_t)c->joints * sizeof *c->sum);
    memset(c->time, 0, (size_t)c->joints * sizeof *c->time);
    c->rows = 0;
    c->began = sample->t;
    c->travel = sample->winch_travel;
}

void compression_record(Compression *c, const Scene *scene, const hawser_sample *sample)
{
    const double dt = c->last >= 0 ? sample->t - c->last : 0, length = PART * 2 * scene->chain.half[0];
    if (c->last < 0) block_begin(c, sample);
    c->last = sample->t;
    if (!(dt > 0)) return;
    pushes_take(c, sample);
    const double *const tension = sample->tension;
    for (int j = scene->first; j <= scene->first + scene->chain.n; ++j) {
        c->sum[j] += tension[j] * dt;
        c->time[j] += dt;
    }
    const double way = fabs(sample->winch_travel - c->travel), time = sample->t - c->began;
    if (++c->rows < BLOCK_LEAST || time < LASTS || (way < length && time * scene->largest_speed < 2 * length)) return;
    block_end(c, scene, sample);
    block_begin(c, sample);
}
