/* One pass of a run, from the initial state to the case's end. The integrator takes its own steps; between them this
 * file looks whether a row, a state or a word to the caller is due. What is written is a state that the integrator
 * reached, not one between two: a row belongs to the first step that ends at its time or after, and no step is longer
 * than the time between rows. */
#include "core/base/clock.h"
#include "core/base/error.h"
#include "io/api/api_handles.h"
#include "io/results/results_file.h"
#include "sim/picture/geometry.h"
#include "sim/run/commands.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Wall time between two calls of the caller's progress function, s. */
static const double progress_interval = 0.25;

/* What holds a run up is asked every so often, s of wall time: if it would take an hour more at its present rate, or a
 * minute with steps that are a small share of those that it has made before. */
static const double slow_interval = 2, slow_hours = 3600, slow_minutes = 60, slow_share = 1.0 / 30;

/* Something that happens at 0, interval, 2 interval ... of simulated time; interval 0: never. */
typedef struct Beat {
    double interval; /* s */
    long count;      /* how often it happened */
} Beat;

typedef struct Run {
    hawser_sim *s;
    Results *results[STRANDS_MAX]; /* of each chain; the first NULL: nothing is written */
    const OutDir *dir;             /* where they go */
    hawser_progress progress;      /* may be NULL */
    void *user;
    double started, last_progress; /* clock_now() */
    Beat row, state;
    double last_row, last_state;        /* simulated time, s */
    double last_kept, kept_cost;        /* clock_now() of the last checkpoint, s; what it took, s */
    const hawser_sample *look;          /* the simulation's, brought up to date by each look */
    StallFrom slow_from;                /* where the present stretch of slow_interval began */
    double slow_wall;                   /* clock_now() then; 0: none has */
    char held_up[HAWSER_HOLD_MAX + 64]; /* "": nothing does */
} Run;

/* Counted, not summed: the thousandth beat is not late by rounding. */
static double beat_next(const Beat *b) { return b->interval > 0 ? b->interval * (double)b->count : INFINITY; }

/* Whether the beat is due at time t, up to rounding; counts it if so. */
static int beat_due(Beat *b, double t)
{
    const double next = beat_next(b);
    if (!(b->interval > 0) || t < next - 1e-9 * fmax(1, next)) return 0;
    b->count = (long)floor(t / b->interval + 1e-9) + 1;
    return 1;
}

/* Statistics with a row, and a state. */
static hawser_status write_now(Run *run, int row, int state, hawser_error *err)
{
    Sim *sim = run->s;
    if (row) run->last_row = hawser_sim_time(sim);
    if (state) run->last_state = hawser_sim_time(sim);
    if (row && state) hawser_sim_record(sim);
    if (row && !state) sim_record_row(sim);
    if (!run->results[0]) return HAWSER_OK;
    const double start = clock_now();
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < sim_chains(sim); ++k) {
        const hawser_sample *const look = &sim_chain(sim, k)->look.sample;
        if (!status && row) status = results_row(run->results[k], look, err);
        if (!status && state) status = results_state(run->results[k], look, err);
        if (!status) status = results_tick(run->results[k], err);
    }
    sim->output_s += clock_now() - start;
    return status;
}

/* What is due now. A state always has its row. */
static hawser_status write_due(Run *run, hawser_error *err)
{
    const double t = hawser_sim_time(run->s);
    const int placed = run->s->stage.scene.def.analysis.kind == ANALYSIS_POSITIONS; /* every position is a row */
    const int state = beat_due(&run->state, t), row = beat_due(&run->row, t) || state || placed;
    return row ? write_now(run, row, state, err) : HAWSER_OK;
}

/* Checkpoints are as far apart as the case says, and farther where that would be most of a run's time. */
static const double KEPT_SHARE = 0.25;

/* The run as it stands between two steps, whatever is written after it. */
static hawser_status keep_now(Run *run, hawser_error *err)
{
    Checkpoint c = {0};
    const double start = clock_now();
    RunKept kept = {
        .rows = run->row.count, .states = run->state.count, .last_row = run->last_row, .last_state = run->last_state};
    hawser_status status = HAWSER_OK;
    for (int k = 0; !status && k < sim_chains(run->s); ++k)
        status = results_position(run->results[k], &kept.files[k], err);
    if (!status) status = checkpoint_write(run->s, &kept, &c, err);
    if (!status) status = results_checkpoint(run->dir, c.bytes, c.size, err);
    checkpoint_free(&c);
    run->last_kept = clock_now();
    run->kept_cost = run->last_kept - start;
    run->s->output_s += run->kept_cost;
    return status;
}

hawser_status pass_keep(hawser_sim *s, const OutDir *dir, hawser_error *err)
{
    Checkpoint c = {0};
    RunKept kept = {.over = 1};
    hawser_status status = checkpoint_write(s, &kept, &c, err);
    if (!status) status = results_checkpoint(dir, c.bytes, c.size, err);
    checkpoint_free(&c);
    return status;
}

/* Nothing that is known so early is worth keeping: a run of which no step has been made begins again. */
static hawser_status keep_due(Run *run, hawser_error *err)
{
    const double interval = run->s->stage.scene.def.output.checkpoint;
    if (!run->results[0] || !(interval > 0)) return HAWSER_OK;
    return clock_now() - run->last_kept < fmax(interval, run->kept_cost / KEPT_SHARE) ? HAWSER_OK : keep_now(run, err);
}

/* A run that is stopped between two steps can be gone on with as one that is killed; where it cannot be kept, the stop
 * weighs more. */
static void keep_last(Run *run)
{
    hawser_error unused;
    if (run->results[0] && run->s->stage.scene.def.output.checkpoint > 0 && run->s->stage.t > 0) keep_now(run, &unused);
}

/* The state in which a run ends, so far as the beats have not just written it. */
static hawser_status write_last(Run *run, hawser_error *err)
{
    const double t = hawser_sim_time(run->s);
    if (run->s->stage.torn) return HAWSER_OK; /* there is nothing to be seen */
    const int row = t > run->last_row, state = run->state.interval > 0 && t > run->last_state;
    if (state && !row) hawser_sim_sample(run->s);
    return row || state ? write_now(run, row, state, err) : HAWSER_OK;
}

/* Asks what holds the run up, if anything does. */
static void slow_look(Run *run, double wall)
{
    Sim *const sim = run->s;
    hawser_hold hold;
    if (!sim->stage.integrator || (run->slow_wall > 0 && wall - run->slow_wall < slow_interval)) return;
    const double t = hawser_sim_time(sim), gone = t - run->slow_from.t, spent = wall - run->slow_wall;
    const double left = (hawser_sim_end_time(sim) - t) * spent / gone; /* s of wall time */
    const StallFrom from = run->slow_from, now = stall_from(sim->stage.integrator, t);
    const double step = gone / fmax(1, (double)(now.steps - from.steps));
    const int begun = run->slow_wall > 0 && now.steps > from.steps && gone >= 0;
    const int slow = left > slow_hours || (left > slow_minutes && step < slow_share * sim->stall.longest);
    run->slow_from = now;
    run->slow_wall = wall;
    *run->held_up = 0;
    if (!begun || !slow) return;
    sim_held_up(sim, &from, &hold);
    snprintf(run->held_up, sizeof run->held_up, "%s; at this rate it takes another %.3g h", hold.says, left / 3600);
}

/* Tells the caller every quarter of a second (or now); STOPPED if he wants no more. */
static hawser_status tell_progress(Run *run, int now, hawser_error *err)
{
    const double wall = clock_now();
    if (!run->progress || (!now && wall - run->last_progress < progress_interval)) return HAWSER_OK;
    run->last_progress = wall;
    Sim *sim = run->s;
    slow_look(run, wall);
    hawser_sim_sample(sim);
    sim->look.sample.held_up = *run->held_up ? run->held_up : NULL;
    const int stop = run->progress(run->user, run->look, wall - run->started, hawser_sim_end_time(sim));
    sim->look.sample.held_up = NULL;
    return stop ? error_set(err, HAWSER_STOPPED, "stopped at t = %.6g s", hawser_sim_time(sim)) : HAWSER_OK;
}

/* The same while nothing has a time yet, between the iterations of a relaxation or of a load step: the caller sees what
 * he saw last. */
static int ask_progress(void *user)
{
    Run *const run = user;
    const double wall = clock_now();
    if (!run->progress || wall - run->last_progress < progress_interval) return 0;
    run->last_progress = wall;
    return run->progress(run->user, run->look, wall - run->started, hawser_sim_end_time(run->s));
}

/* Only once, and only before anything has moved; the case may forbid it. */
static hawser_status run_relaxation(Run *run, hawser_error *err)
{
    hawser_sim *s = run->s;
    if (!s->stage.scene.def.solver.relax || s->relaxed || hawser_sim_time(s) > 0) return HAWSER_OK;
    return hawser_sim_relax(s, NULL, err);
}

/* From a state that has its row to the end of the case. */
static hawser_status run_on(Run *run, hawser_error *err)
{
    Sim *sim = run->s;
    hawser_status status = tell_progress(run, 1, err);
    while (!status && hawser_sim_time(sim) < hawser_sim_end_time(sim)) { /* a trip may bring the end nearer */
        sim->inside = 1;
        status = sim_blame_law(sim, sim_advance(sim, hawser_sim_end_time(sim), 1, err), err);
        sim->inside = 0;
        if (!status) status = write_due(run, err);
        if (!status) status = place_check(sim, err);
        if (!status) status = keep_due(run, err);
        if (status) break; /* perhaps within a step: what is kept is from before it */
        status = tell_progress(run, 0, err);
        if (status == HAWSER_STOPPED) keep_last(run);
    }
    /* the caller sees the end; there is nothing left to stop */
    if (!status) tell_progress(run, 1, NULL);
    return status;
}

/* From the state of now. */
static hawser_status run_steps(Run *run, int resumed, hawser_error *err)
{
    Sim *sim = run->s;
    hawser_status status = HAWSER_OK;
    sim->stage.ws.stop = (StopCheck){.ask = ask_progress, .user = run};
    if (!resumed) status = run_relaxation(run, err);
    if (!status && !resumed) status = write_due(run, err);
    if (!status && !resumed) status = place_check(sim, err);
    if (!status) status = run_on(run, err);
    sim->stage.ws.stop = (StopCheck){0};
    return status;
}

/* Sizes, names and wishes for the results folder: `home`, or the folder `chain` within it. at: where the files of a run
 * that is resumed were; NULL: it is new. */
static hawser_status results_of(hawser_sim *s, Results **out, const OutDir *home, const char *chain,
                                const ResultsPosition *at, hawser_error *err)
{
    const hawser_sample *const look = &s->look.sample;
    const OutputDef *output = &s->stage.scene.def.output;
    char identity[SUM_SIZE];
    run_identity(s, identity);
    ResultsDef def = {.title = s->title,
                      .run = identity,
                      .origin = {s->stage.scene.def.route_origin.x, s->stage.scene.def.route_origin.y,
                                 s->stage.scene.def.route_origin.z},
                      .segments = look->segments,
                      .reel = !isnan(look->paid_out),
                      .front = !isnan(look->head_at),
                      .n_watched = output->n_speed_segments,
                      .watched = output->speed_segments,
                      .n_loads = output->n_load_rollers,
                      .loads = output->load_rollers,
                      .states = output->state_interval > 0 ? hawser_sim_end_time(s) / output->state_interval + 1 : 0};
    def.probes = look->probes;
    def.probe = look->probe;
    def.rollers = hawser_sim_rollers(s, &def.roller);
    def.figures = look->figures;
    def.machine = look->machine;
    def.n_inputs = s->stage.scene.def.n_inputs;
    def.inputs = s->stage.scene.def.inputs;
    Geometry geometry = {0};
    AlongRow *route;
    char *summary = NULL;
    hawser_status status = along_rows(s, &route, &def.n_route, err);
    if (!status) status = sim_summary_text(s, NULL, &summary, err);
    if (!status && def.states > 0) status = geometry_make(&s->stage.scene, &geometry, err);
    if (def.states > 0) def.geometry = &geometry;
    def.route = route;
    if (!at) envelope_free(&s->envelope); /* of a run before */
    if (!status && !at && def.states > 0) status = envelope_new(&s->envelope, &s->stage.scene, err);
    if (!status) {
        status = at ? results_resume(out, home, chain, &def, at, summary, err)
                    : results_open(out, home, chain, &def, summary, err);
    }
    geometry_free(&geometry);
    hawser_text_free(summary);
    free(route);
    return status;
}

/* The first chain's in the folder itself, those of the others in folders of their names within. at [chains]: as
 * results_of. */
static hawser_status open_results(Run *run, const OutDir *dir, const ResultsPosition *at, hawser_error *err)
{
    run->dir = dir;
    hawser_status status = HAWSER_OK;
    for (int k = 0; !status && k < sim_chains(run->s); ++k) {
        hawser_sim *const each = sim_chain(run->s, k);
        const char *const name = k > 0 ? each->stage.scene.def.strand.name : NULL;
        if (k > 0) hawser_sim_sample(each);
        status = results_of(each, &run->results[k], dir, name, at ? &at[k] : NULL, err);
    }
    return status;
}

static ResultsTables tables_of(hawser_sim *s)
{
    hawser_summary errors;
    hawser_sim_summary(s, &errors); /* brings the tables' error bars up to date */
    ResultsTables tables = {.segments = s->stage.scene.total, .envelope = s->envelope.present ? &s->envelope : NULL};
    tables.n_stations = hawser_sim_stations(s, &tables.station);
    tables.n_rollers = hawser_sim_rollers(s, &tables.roller);
    tables.n_modes = hawser_sim_modes(s, &tables.mode);
    tables.n_places = hawser_sim_places(s, &tables.place);
    tables.place_station = s->positions.station;
    return tables;
}

/* The tables, whatever the outcome. */
static hawser_status finish_tables(Run *run, hawser_error *err)
{
    hawser_status first = HAWSER_OK;
    for (int k = 0; k < sim_chains(run->s); ++k) {
        const ResultsTables tables = tables_of(sim_chain(run->s, k));
        const hawser_status status = results_finish(run->results[k], &tables, first ? NULL : err);
        if (!first) first = status;
    }
    return first;
}

hawser_status pass_tell(hawser_sim *s, const OutDir *dir, hawser_error *err)
{
    const ResultsTables tables = tables_of(s);
    char *summary;
    hawser_status status = results_again(dir, &tables, err);
    if (!status) status = sim_summary_text(s, dir, &summary, err);
    if (status) return status;
    status = out_whole_in(dir, "summary.json", summary, err);
    hawser_text_free(summary);
    return status;
}

/* After the tables: it says how they went, too. */
static hawser_status finish_summary(Run *run, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int k = 0; !status && k < sim_chains(run->s); ++k) {
        char *summary = NULL;
        status = sim_summary_text(sim_chain(run->s, k), results_dir(run->results[k]), &summary, err);
        if (!status) status = results_summary(run->results[k], summary, run->s->outcome == HAWSER_OK, err);
        hawser_text_free(summary);
    }
    return status;
}

/* Beats that go on from time t (0 unless the caller has advanced before). */
static void start_beats(Run *run, double t)
{
    const OutputDef *output = &run->s->stage.scene.def.output;
    run->row.interval = output->interval;
    run->state.interval = output->state_interval;
    Beat *beats[] = {&run->row, &run->state};
    for (int i = 0; i < 2; i++) {
        if (beats[i]->interval > 0) beats[i]->count = (long)ceil(t / beats[i]->interval - 1e-9);
    }
}

/* Why it ended, for the summary and the caller. A result that could not be written weighs more than a stop.
 */
hawser_status pass_settle(hawser_sim *s, hawser_status status, hawser_error *err)
{
    for (int k = 0; k < sim_chains(s); ++k) {
        hawser_sim *const each = sim_chain(s, k);
        each->running = 0;
        each->outcome = status;
        if (status) memcpy(each->message, err->message, sizeof each->message);
    }
    return status;
}

/* What could not be written weighs more than a stop, which was the caller's wish, and less than what ended the run. */
static hawser_status weigh(hawser_sim *s, hawser_status status, hawser_status written, const hawser_error *late,
                           hawser_error *err)
{
    if (!written || (status && status != HAWSER_STOPPED)) return status;
    *err = *late;
    return pass_settle(s, written, err);
}

/* Steps and tables: the tables are written whatever ended the steps. The first error counts. */
static hawser_status run_all(Run *run, int resumed, hawser_error *err)
{
    hawser_sim *const s = run->s;
    hawser_error late = {HAWSER_OK, ""};
    hawser_status status = run_steps(run, resumed, err);
    hawser_status written = write_last(run, &late);
    pass_settle(s, status, err);
    if (run->results[0]) {
        const hawser_status finished = finish_tables(run, written ? NULL : &late);
        if (!written) written = finished;
    }
    status = weigh(s, status, written, &late, err);
    if (run->results[0]) {
        status = weigh(s, status, finish_summary(run, &late), &late, err);
        for (int k = 0; k < sim_chains(s); ++k) results_free(run->results[k]);
    }
    return status;
}

static Run run_new(hawser_sim *s, hawser_progress progress, void *user)
{
    const double now = clock_now();
    return (Run){.s = s,
                 .progress = progress,
                 .user = user,
                 .started = now,
                 .last_progress = now,
                 .last_kept = now,
                 .last_row = -1,
                 .look = hawser_sim_sample(s)};
}

/* Its beats begin at the state of now. */
static void run_begin(Run *run)
{
    for (int k = 0; k < sim_chains(run->s); ++k) {
        sim_chain(run->s, k)->running = 1;
        sim_chain(run->s, k)->outcome = HAWSER_OK;
    }
    start_beats(run, hawser_sim_time(run->s));
}

hawser_status pass_run(hawser_sim *s, const OutDir *dir, hawser_progress progress, void *user, hawser_error *err)
{
    Run run = run_new(s, progress, user);
    run_begin(&run);
    const hawser_status status = dir ? open_results(&run, dir, NULL, err) : HAWSER_OK;
    if (!status) return run_all(&run, 0, err);
    for (int k = 0; k < sim_chains(s); ++k) results_free(run.results[k]);
    return pass_settle(s, status, err);
}

/* The simulation first: nothing is touched in the folder of a run that cannot be gone on with. */
hawser_status pass_resume(hawser_sim *s, const OutDir *dir, hawser_progress progress, void *user, int *over,
                          hawser_error *err)
{
    RunKept kept = {.over = 0};
    hawser_status status = checkpoint_read_dir(s, dir, &kept, err);
    *over = kept.over != 0;
    if (status || kept.over) return pass_settle(s, status, err);
    Run run = run_new(s, progress, user);
    run_begin(&run);
    run.row.count = kept.rows;
    run.state.count = kept.states;
    run.last_row = kept.last_row;
    run.last_state = kept.last_state;
    status = open_results(&run, dir, kept.files, err);
    return status ? pass_settle(s, status, err) : run_all(&run, 1, err);
}
