#include "sim/judge/compression.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "sim/equipment/reel.h"
#include "sim/watch/sample.h"

enum { BLOCK_LEAST = 4 };        /* samples, for a mean to be one */
static const double PART = 0.25; /* of a segment, that passes while it is pushed, */
static const double LASTS = 1;   /* s, and for how long: what is shorter is a stop's or a jolt's; */
static const double LONG = 2;    /* s: however little passes */
static const double MOVES =
    0.1; /* of the pull's speed, or all of it that friction needs: below that the winch stands */

hawser_status compression_new(Compression *c, const Scene *scene, hawser_error *err)
{
    *c = (Compression){.joints = scene->total + 1, .last = -1};
    c->n_pushers = scene->setup.n_pushers;
    c->sum = calloc((size_t)c->joints, sizeof *c->sum);
    c->time = calloc((size_t)c->joints, sizeof *c->time);
    c->force = calloc((size_t)c->n_pushers + 1, sizeof *c->force);
    return c->sum && c->time && c->force ? HAWSER_OK : error_memory(err);
}

void compression_free(Compression *c)
{
    free(c->sum);
    free(c->time);
    free(c->force);
    *c = (Compression){0};
}

/* The machine of a pusher; NULL: it has none. */
static const hawser_machine *machine_of(const Pusher *by, const hawser_sample *sample)
{
    const char *const kind = by->kind == PUSH_BELT ? "conveyors" : "motors";
    for (int i = 0; i < sample->machines; ++i) {
        const hawser_machine *const machine = &sample->machine[i];
        if (!strcmp(machine->kind, kind) && !strcmp(machine->name, by->name)) return machine;
    }
    return NULL;
}

static void pushes_take(Compression *c, const Scene *scene, const hawser_sample *sample, double dt)
{
    for (int k = 0; k < c->n_pushers; ++k) {
        const hawser_machine *const machine = machine_of(&scene->setup.pusher[k], sample);
        const double force = machine ? hawser_machine_figure(machine, "force_N") : NAN;
        c->force[k] += isnan(force) ? NAN : fmax(0, force) * dt;
    }
}

/* N, with which a pusher has pushed in the block; of one that has a torque only, what is reckoned with the tension that
 * arrives there. */
static double pushed_with(const Compression *c, const Scene *scene, int k, double middle, double whole)
{
    const Setup setup = scene_setup(scene);
    const Pusher *const by = &setup.pusher[k];
    const double front = scene->joint_s[scene->eye] + middle;
    int near = 0;
    if (!isnan(c->force[k])) return c->force[k] / whole;
    for (int j = 1; j < c->joints; ++j)
        if (c->time[j] > 0 && fabs(scene->joint_s[j] + middle - by->at) < fabs(scene->joint_s[near] + middle - by->at))
            near = j;
    const double arriving = c->time[near] > 0 ? c->sum[near] / c->time[near] : 0;
    return fmax(0, setup_push(&setup, k, arriving, front));
}

/* The joints that were there all through the block. P: of the strongest machine behind a joint. */
static void block_end(Compression *c, const Scene *scene, const hawser_sample *sample)
{
    const double whole = c->drawn, middle = (c->travel + sample->winch_travel) / 2;
    const double least = scene->weight.lead_in ? 0 : -INFINITY;
    for (int k = 0; k < c->n_pushers; ++k) c->force[k] = pushed_with(c, scene, k, middle, whole);
    for (int j = 0; j <= scene->eye && j < c->joints; ++j) {
        const double s = scene->joint_s[j] + middle;
        if (!(c->time[j] > 0.99 * whole) || s < least || s > scene->route.length) continue;
        const double tension = c->sum[j] / c->time[j];
        double pushed = -tension;
        c->pulled = fmax(c->pulled, tension);
        if (!(pushed > c->most.value)) continue;
        for (int k = 0; k < c->n_pushers; ++k)
            if (scene->setup.pusher[k].from <= s) pushed = fmin(pushed, -tension - c->force[k]);
        if (!(pushed > c->most.value)) continue;
        c->most = (Peak){pushed, s};
        c->when = (c->began + sample->t) / 2;
    }
}

static void block_begin(Compression *c, const hawser_sample *sample)
{
    memset(c->sum, 0, (size_t)c->joints * sizeof *c->sum);
    memset(c->time, 0, (size_t)c->joints * sizeof *c->time);
    memset(c->force, 0, (size_t)c->n_pushers * sizeof *c->force);
    c->rows = 0;
    c->drawn = 0;
    c->began = sample->t;
    c->travel = sample->winch_travel;
}

void compression_record(Compression *c, const Scene *scene, const hawser_sample *sample)
{
    const double dt = c->last >= 0 ? sample->t - c->last : 0, length = PART * 2 * scene->chain.half[0];
    const double moves = fmin(MOVES * scene->largest_speed, scene->def.friction.v_d);
    const int stands = !(fabs(sample->winch_speed) >= moves);
    if (c->last < 0 || (stands && c->rows == 0)) block_begin(c, sample);
    c->last = sample->t;
    if (!(dt > 0) || stands) return;
    pushes_take(c, scene, sample, dt);
    const double *const tension = sample->tension;
    for (int j = scene->first; j <= scene->first + scene->chain.n; ++j) {
        c->sum[j] += tension[j] * dt;
        c->time[j] += dt;
    }
    c->drawn += dt;
    const double way = fabs(sample->winch_travel - c->travel);
    if (++c->rows < BLOCK_LEAST || c->drawn < LASTS || (way < length && c->drawn < LONG)) return;
    block_end(c, scene, sample);
    block_begin(c, sample);
}
