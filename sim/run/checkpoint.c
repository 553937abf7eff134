/* Everything that a simulation keeps, in one list. What belongs to what is watched stands here, so that it can be read
 * in one go; what the steps keep is with those who keep it (stage_checkpoint). */
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "sim/control/forces.h"
#include "sim/equipment/reel.h"
#include "sim/run/commands.h"
#include "sim/run/quasi_run.h"
#include "sim/run/sim.h"
#include "sim/run/together.h"

/* Of a table's row, what is neither a name nor known from the case. */
#define ROW(c, row, type, member) CHECKPOINT_FROM(c, row, type, member)

static void stats_checkpoint(Checkpoint *c, Stats *s)
{
    const size_t watched = (size_t)(2 + s->n_stations + s->n_rollers), stations = (size_t)s->n_stations;
    CHECKPOINT_UP_TO(c, s, Stats, n_stations);
    checkpoint_counts(c, 3, (const int[]){s->passing, s->swings.steps, s->swings.downward});
    checkpoint_put(c, "s->station", s->station, stations * sizeof *s->station);
    checkpoint_put(c, "s->roller", s->roller, (size_t)s->n_rollers * sizeof *s->roller);
    checkpoint_put(c, "s->surface", s->surface, (size_t)s->n_surfaces * sizeof *s->surface);
    for (int i = 0; i < s->n_stations; ++i) ROW(c, &s->station_out[i], hawser_station, s);
    for (int i = 0; i < s->n_rollers; ++i) ROW(c, &s->roller_out[i], hawser_roller, s);
    for (int i = 0; i < s->n_surfaces; ++i) ROW(c, &s->surface_out[i], hawser_surface, from_m);
    checkpoint_put(c, "s->before", s->before, watched * sizeof *s->before);
    checkpoint_put(c, "s->now", s->now, watched * sizeof *s->now);
    checkpoint_put(c, "s->station_joint", s->station_joint, stations * sizeof *s->station_joint);
    checkpoint_put(c, "s->station_share", s->station_share, stations * sizeof *s->station_share);
}

static void machines_checkpoint(Checkpoint *c, Machines *m)
{
    for (int i = 0; i < m->n; ++i) {
        CHECKPOINT(c, m->record[i].value);
        CHECKPOINT(c, m->record[i].kept);
        for (int k = 0; k < m->out[i].n_figures; ++k) CHECKPOINT(c, m->record[i].figure[k].value);
    }
    for (int k = 0; k < m->n_now; ++k) CHECKPOINT(c, m->now[k].value);
}

static void peaks_checkpoint(Checkpoint *c, Peaks *p)
{
    if (!p->present) return;
    CHECKPOINT_UP_TO(c, p, Peaks, pusher);
    checkpoint_text(c, "p->pusher", &p->pusher);
    checkpoint_put(c, "p->roller", p->roller, (size_t)p->n_rollers * sizeof *p->roller);
    checkpoint_put(c, "p->when", p->when, (size_t)p->n_rollers * sizeof *p->when);
    Compression *const pushed = &p->pushed;
    CHECKPOINT_UP_TO(c, pushed, Compression, joints);
    checkpoint_counts(c, 2, (const int[]){p->recorded, pushed->rows});
    checkpoint_put(c, "pushed->sum", pushed->sum, (size_t)pushed->joints * sizeof *pushed->sum);
    checkpoint_put(c, "pushed->time", pushed->time, (size_t)pushed->joints * sizeof *pushed->time);
    checkpoint_put(c, "pushed->force", pushed->force, (size_t)pushed->n_pushers * sizeof *pushed->force);
}

static void passing_checkpoint(Checkpoint *c, Passing *p, const Scene *scene)
{
    const size_t rollers = (size_t)scene->contact.n_rollers, surfaces = (size_t)scene->surfaces.model.n_surfaces;
    checkpoint_put(c, "p->side", p->side, rollers * sizeof *p->side);
    checkpoint_put(c, "p->gone", p->gone, (rollers + surfaces) * sizeof *p->gone);
    checkpoint_put(c, "p->seen", p->seen, surfaces * SURFACE_FACES_MAX * (size_t)scene->total * sizeof *p->seen);
    CHECKPOINT(c, p->through);
    CHECKPOINT(c, p->due);
    CHECKPOINT(c, p->says);
    CHECKPOINT_UP_TO(c, &p->start, Misfit, name);
    checkpoint_text(c, "p->start.name", &p->start.name);
    CHECKPOINT_UP_TO(c, &p->edge, Edge, name);
    checkpoint_text(c, "p->edge.name", &p->edge.name);
    CHECKPOINT(c, p->overlap);
    checkpoint_counts(c, 2, (const int[]){p->through, p->overlap.looks});
    p->says[PASSING_SAYS_MAX - 1] = p->overlap.says[OVERLAP_SAYS_MAX - 1] = 0;
}

static void places_checkpoint(Checkpoint *c, ByPosition *b)
{
    checkpoint_put(c, "b->bin", b->bin, (size_t)b->n_bins * sizeof *b->bin);
    CHECKPOINT(c, b->last_t);
    CHECKPOINT(c, b->mean);
}

/* It is there if somebody has asked for it. */
static hawser_status envelope_checkpoint(Checkpoint *c, Envelope *e, const Scene *scene, hawser_error *err)
{
    int present = e->present;
    CHECKPOINT(c, present);
    if (c->reading && !c->status) {
        envelope_free(e);
        const hawser_status status = present ? envelope_new(e, scene, err) : HAWSER_OK;
        if (status) return status;
    }
    if (c->status || !present) return HAWSER_OK;
    CHECKPOINT(c, e->last);
    EnvelopeLine *const lines[] = {&e->arc, &e->place};
    for (int k = 0; k < 2; ++k) {
        const size_t bytes = (size_t)lines[k]->n * sizeof(double);
        Extremes *const of[] = {&lines[k]->tension, &lines[k]->curvature, &lines[k]->sidewall};
        checkpoint_put(c, "line->time", lines[k]->time, bytes);
        for (int q = 0; q < 3; ++q) {
            checkpoint_put(c, "least", of[q]->least, bytes);
            checkpoint_put(c, "mean", of[q]->mean, bytes);
            checkpoint_put(c, "largest", of[q]->largest, bytes);
        }
    }
    return HAWSER_OK;
}

static void events_checkpoint(Checkpoint *c, EventLog *log)
{
    int n = log->n;
    CHECKPOINT(c, n);
    CHECKPOINT(c, log->missed);
    checkpoint_longs(c, 1, (const long[]){log->missed});
    checkpoint_check(c, n <= EVENTS_MAX, "a number of events is impossible");
    if (!checkpoint_number(c, n, sizeof log->event->t, "a number of events is impossible")) return;
    hawser_error lack = {HAWSER_OK, ""};
    if (c->reading) log->n = 0;
    while (c->reading && log->n < n && !lack.status) events_add(log, (hawser_event){0}, &lack);
    if (lack.status) checkpoint_lack(c);
    for (int i = 0; !c->status && i < n; ++i) {
        CHECKPOINT(c, log->event[i].t);
        CHECKPOINT(c, log->event[i].pull_N);
        CHECKPOINT(c, log->event[i].code);
        checkpoint_text(c, "event", &log->event[i].what);
    }
}

/* Of an analysis that has come to its end. */
static void modes_checkpoint(Checkpoint *c, Modes *m, int segments)
{
    const size_t each = 6 * (size_t)segments;
    int n = m->n;
    CHECKPOINT(c, n);
    if (!checkpoint_number(c, n, sizeof *m->shape * each, "a number of modes is impossible")) return;
    if (c->reading) {
        modes_free(m);
        m->out = calloc((size_t)n + 1, sizeof *m->out);
        m->shape = calloc((size_t)n * each + 1, sizeof *m->shape);
        if (!m->out || !m->shape) checkpoint_lack(c);
        if (c->status) return;
        m->n = n;
        m->segments = segments;
    }
    CHECKPOINT(c, m->iterations);
    checkpoint_counts(c, 1, &m->iterations);
    if (n > 0) checkpoint_put(c, "m->shape", m->shape, (size_t)n * each * sizeof *m->shape);
    for (int k = 0; k < n; ++k) {
        CHECKPOINT_UP_TO(c, &m->out[k], hawser_mode, shape);
        if (c->reading) m->out[k].shape = m->shape + (size_t)k * each;
    }
}

/* What the run was told, and what winch, jams and conveyors have come to: in bytes of its own (sim/run/commands.h). */
static hawser_status controls_checkpoint(Checkpoint *c, Sim *s, hawser_error *err)
{
    const int reel = s->stage.scene.reel->present; /* which the stage asks for itself */
    hawser_status status = HAWSER_OK;
    int size = (int)controls_size(s), room = 0;
    if (c->status) return status;
    void *bytes = c->reading ? NULL : malloc((size_t)size + 1);
    if (bytes) controls_save(s, bytes);
    if (!c->reading && !bytes) checkpoint_lack(c);
    checkpoint_list(c, "controls", &bytes, &size, &room, 1);
    if (c->reading && !c->status) status = controls_load(s, bytes, (size_t)size, err);
    free(bytes);
    s->stage.scene.reel->present = reel;
    return status;
}

/* Whom the caller has set acts on what was read, also if it is from before that. */
static hawser_status calls_go_on(Sim *s, hawser_error *err)
{
    s->led |= s->calls.step || s->calls.event || s->calls.law;
    if (!s->calls.law) return HAWSER_OK;
    outside_attend(&s->stage.scene, 1);
    return stage_to_space(&s->stage, "a law of force acts on segments", err);
}

static void stall_checkpoint(Checkpoint *c, Stall *stall)
{
    const StallFrom *const from = &stall->from;
    CHECKPOINT(c, *stall);
    checkpoint_counts(c, 1, &stall->left);
    checkpoint_longs(c, 4, (const long[]){from->steps, from->error_fails, from->newton_fails, from->strides});
}

/* What is watched of one chain. */
static hawser_status watched_checkpoint(Checkpoint *c, Sim *s, hawser_error *err)
{
    const Scene *const scene = &s->stage.scene;
    stats_checkpoint(c, &s->stats);
    machines_checkpoint(c, &s->machines);
    peaks_checkpoint(c, &s->peaks);
    passing_checkpoint(c, &s->passing, scene);
    places_checkpoint(c, &s->by_position);
    const hawser_status status = envelope_checkpoint(c, &s->envelope, scene, err);
    if (status) return status;
    events_checkpoint(c, &s->events);
    modes_checkpoint(c, &s->modes, scene->chain.n);
    CHECKPOINT(c, s->stray);
    CHECKPOINT(c, s->steadiness);
    stall_checkpoint(c, &s->stall);
    CHECKPOINT(c, s->relaxation);
    checkpoint_counts(c, 1, &s->relaxation.iterations);
    CHECKPOINT(c, s->active_max);
    CHECKPOINT(c, s->overturned);
    CHECKPOINT(c, s->relaxed);
    CHECKPOINT(c, s->led);
    CHECKPOINT(c, s->relax_s);
    CHECKPOINT(c, s->output_s);
    CHECKPOINT(c, s->record_s);
    return HAWSER_OK;
}

hawser_status sim_checkpoint(Checkpoint *c, Sim *s, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    if (s->stage.torn) return error_memory(err);
    if (s->leader)
        return error_set(err, HAWSER_ERR_INPUT,
                         "this is one of several chains: a checkpoint is of the simulation that moves them all");
    for (int k = 0; !status && k < sim_chains(s); ++k) status = controls_checkpoint(c, sim_chain(s, k), err);
    if (!status) quasi_checkpoint_before(c, s);
    if (!status && c->status) return HAWSER_OK;
    if (!status) status = s->together ? together_checkpoint(c, s->together, err) : stage_checkpoint(c, &s->stage, err);
    if (c->status) return status;
    if (!status) status = quasi_checkpoint(c, s, err);
    for (int k = 0; !status && k < sim_chains(s); ++k) status = watched_checkpoint(c, sim_chain(s, k), err);
    if (status || !c->reading || c->status) return status;
    s->stage.motion->ops->lin_stats(s->stage.motion, &s->lin); /* what solves now is not what the beginning asked for */
    return calls_go_on(s, err);
}

/* The chain as the case makes it, and the state that a run begins with: what is simulated is as much the case's files,
 * the catalogue and this program's defaults as its own text. */
static uint64_t chain_identity(const Sim *s)
{
    const Scene *const scene = &s->stage.scene;
    const Chain *const chain = s->stage.whole.n > 0 ? &s->stage.whole : &scene->chain;
    const size_t joints = (size_t)scene->total + 1;
    uint64_t sum[40] = {0};
    int n = 0;
    sum[n++] = (uint64_t)scene->total;
    sum[n++] = (uint64_t)scene->def.solver.planar;
    sum[n++] = checkpoint_hash(scene->joint_s, joints * sizeof *scene->joint_s);
    sum[n++] = checkpoint_hash(chain->half, (joints - 1) * sizeof(double));
    sum[n++] = checkpoint_hash(chain->radius, (joints - 1) * sizeof(double));
    for (int k = 0; k < 6; ++k) sum[n++] = checkpoint_hash(chain->stiffness[k], joints * sizeof(double));
    for (int k = 0; k < 6; ++k) { /* which springs do without while positions move the run */
        const double *const built = s->quasi.stage.damping ? s->quasi.stage.damping + (size_t)k * joints : NULL;
        sum[n++] = checkpoint_hash(built ? built : chain->damping[k], joints * sizeof(double));
    }
    for (int k = 0; k < 6; ++k) sum[n++] = checkpoint_hash(chain->preload[k], joints * sizeof(double));
    for (int r = 0; r < scene->contact.n_rollers; ++r) {
        const Vec3 place[2] = {scene->rollers[r].shape.centre, scene->rollers[r].shape.axis};
        const uint64_t both[2] = {sum[n], checkpoint_hash(place, sizeof place)};
        sum[n] = checkpoint_hash(both, sizeof both);
    }
    return checkpoint_hash(sum, sizeof sum);
}

/* Of several chains also how they lie and what joins them, which is in their states and in the case's text. */
uint64_t sim_identity(const Sim *s)
{
    if (!s->together) return chain_identity(s);
    const char *const text = s->case_text ? s->case_text : "";
    uint64_t both[2] = {checkpoint_hash(text, strlen(text)), 0};
    for (int k = 0; k < sim_chains(s); ++k) {
        both[1] = chain_identity(s->together->sim[k]);
        both[0] = checkpoint_hash(both, sizeof both);
    }
    return both[0];
}
