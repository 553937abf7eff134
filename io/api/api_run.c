/* One pass of a run, from the initial state to the case's end. The integrator takes its own steps; between them this
 * file checks whether a row, a state or a progress report is due. Each written state was reached by the integrator, not
 * interpolated: a row belongs to the first step that ends at its time or after, and no step is longer than the time
 * between rows. */
#include <assert.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/error.h"
#include "core/machine.h"
#include "core/team.h"
#include "io/api/api_handles.h"
#include "io/results/results_file.h"
#include "sim/run/commands.h"
#include "sim/run/geometry.h"

/* Wall time between two calls of the caller's progress function, s. */
static const double progress_interval = 0.25;

/* The cause of short steps is searched at this interval, s of wall time, if the run would take an hour more at its
 * present rate, or a minute with steps that are a small share of earlier ones. */
static const double slow_interval = 2, slow_hours = 3600, slow_minutes = 60, slow_share = 1.0 / 30;

/* An action at 0, interval, 2 interval ... of simulated time; interval 0: never. */
typedef struct Beat {
    double interval; /* s */
    long count;      /* how often it took place */
} Beat;

typedef struct Run {
    hawser_sim *s;
    Results *results[STRANDS_MAX]; /* one for each chain; the first NULL: nothing is written */
    const OutDir *dir;             /* their folder */
    hawser_progress progress;      /* may be NULL */
    void *user;
    double started, last_progress; /* clock_now() */
    Beat row, state;
    double last_row, last_state;        /* simulated time, s */
    double last_kept, kept_cost;        /* clock_now() of the last checkpoint, s; time that it took, s */
    const hawser_sample *look;          /* the simulation's, updated by each sample */
    StallFrom slow_from;                /* beginning of the present stretch of slow_interval */
    double slow_wall;                   /* clock_now() then; 0: none has begun */
    char held_up[HAWSER_HOLD_MAX + 64]; /* "": the run is not slow */
} Run;

/* Multiplies instead of summing, so that the thousandth beat is not late by rounding. */
static double beat_next(const Beat *b) { return b->interval > 0 ? b->interval * (double)b->count : INFINITY; }

/* Checks whether the beat is due at time t, up to rounding; counts it if so. */
static int beat_due(Beat *b, double t)
{
    const double next = beat_next(b);
    if (!(b->interval > 0) || t < next - 1e-9 * fmax(1, next)) return 0;
    b->count = (long)floor(t / b->interval + 1e-9) + 1;
    return 1;
}

/* Writes a row with its statistics, and a state. */
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

/* Writes rows and states that are due. A state always has its row. */
static hawser_status write_due(Run *run, hawser_error *err)
{
    const double t = hawser_sim_time(run->s);
    const int placed = run->s->stage.scene.def.analysis.kind == ANALYSIS_POSITIONS; /* every position is a row */
    const int state = beat_due(&run->state, t), row = beat_due(&run->row, t) || state || placed;
    return row ? write_now(run, row, state, err) : HAWSER_OK;
}

/* Checkpoints are as far apart as the case requires, and farther where they would take more than this share of a run's
 * time. */
static const double KEPT_SHARE = 0.25;

/* Saves the run between two steps, whatever is written after it. */
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

/* Saves if due, but not before the first step: such a run begins again. */
static hawser_status keep_due(Run *run, hawser_error *err)
{
    const double interval = run->s->stage.scene.def.output.checkpoint;
    if (!run->results[0] || !(interval > 0)) return HAWSER_OK;
    return clock_now() - run->last_kept < fmax(interval, run->kept_cost / KEPT_SHARE) ? HAWSER_OK : keep_now(run, err);
}

/* Saves a run that is stopped between two steps, so that it can be resumed as after a kill; if that fails, the stop is
 * reported. */
static void keep_last(Run *run)
{
    hawser_error unused;
    if (run->results[0] && run->s->stage.scene.def.output.checkpoint > 0 && run->s->stage.t > 0) keep_now(run, &unused);
}

/* Writes the last state of a run, unless the beats have just written it. */
static hawser_status write_last(Run *run, hawser_error *err)
{
    const double t = hawser_sim_time(run->s);
    if (run->s->stage.torn) return HAWSER_OK; /* there is no valid state */
    const int row = t > run->last_row, state = run->state.interval > 0 && t > run->last_state;
    if (state && !row) hawser_sim_sample(run->s);
    return row || state ? write_now(run, row, state, err) : HAWSER_OK;
}

/* Finds the cause of short steps, if there is one. */
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

/* Reports progress every quarter of a second (or now); STOPPED if the caller requests it. */
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

/* Does the same during a relaxation or a load step, when the time does not advance: the caller gets the last sample
 * again. */
static int ask_progress(void *user)
{
    Run *const run = user;
    const double wall = clock_now();
    if (!run->progress || wall - run->last_progress < progress_interval) return 0;
    run->last_progress = wall;
    return run->progress(run->user, run->look, wall - run->started, hawser_sim_end_time(run->s));
}

/* Relaxes only once, and only before anything has moved; the case may forbid it. */
static hawser_status run_relaxation(Run *run, hawser_error *err)
{
    hawser_sim *s = run->s;
    if (!s->stage.scene.def.solver.relax || s->relaxed || hawser_sim_time(s) > 0) return HAWSER_OK;
    return hawser_sim_relax(s, NULL, err);
}

/* Runs from a state that has its row to the end of the case. */
static hawser_status run_on(Run *run, hawser_error *err)
{
    Sim *sim = run->s;
    hawser_status status = tell_progress(run, 1, err);
    while (!status && hawser_sim_time(sim) < hawser_sim_end_time(sim)) { /* a trip may end the run earlier */
        sim->inside = 1;
        status = sim_blame_law(sim, sim_advance(sim, hawser_sim_end_time(sim), 1, err), err);
        sim->inside = 0;
        if (!status) status = write_due(run, err);
        if (!status) status = place_check(sim, err);
        if (!status) status = keep_due(run, err);
        if (status) break; /* perhaps within a step: the checkpoint is from before it */
        status = tell_progress(run, 0, err);
        if (status == HAWSER_STOPPED) keep_last(run);
    }
    /* reports the end; nothing is left to stop */
    if (!status) tell_progress(run, 1, NULL);
    return status;
}

/* Runs from the present state. */
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

/* Fills sizes, names and options of the results folder: `home`, or the folder `chain` within it. at: position of the
 * files of a run that is resumed; NULL: it is new. */
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
    if (!status && def.states > 0) status = geometry_see(&geometry, &s->stage.scene.def.environment, err);
    if (def.states > 0) def.geometry = &geometry;
    def.route = route;
    if (!at) envelope_free(&s->envelope); /* from an earlier run */
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

/* Opens the first chain's in the folder itself, those of the others in folders of their names within. at [chains]: as
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
    hawser_sim_summary(s, &errors); /* updates the error bounds of the tables */
    ResultsTables tables = {.segments = s->stage.scene.total, .envelope = s->envelope.present ? &s->envelope : NULL};
    tables.n_stations = hawser_sim_stations(s, &tables.station);
    tables.n_rollers = hawser_sim_rollers(s, &tables.roller);
    tables.n_modes = hawser_sim_modes(s, &tables.mode);
    tables.n_places = hawser_sim_places(s, &tables.place);
    tables.place_station = s->positions.station;
    return tables;
}

/* Writes the tables, whatever the outcome. */
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

/* Writes the summary after the tables, whose outcome it includes. */
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

/* Starts beats that continue from time t (0 unless the caller has advanced before). */
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

/* Stores the reason for the end, for the summary and the caller. A write error takes precedence over a stop. */
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

/* Combines the outcomes: a write error takes precedence over a stop, which the caller requested, but not over the error
 * that ended the run. */
static hawser_status weigh(hawser_sim *s, hawser_status status, hawser_status written, const hawser_error *late,
                           hawser_error *err)
{
    if (!written || (status && status != HAWSER_STOPPED)) return status;
    *err = *late;
    return pass_settle(s, written, err);
}

/* Runs steps and tables: the tables are written whatever ended the steps. Returns the first error. */
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

/* Begins its beats at the present state. */
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

/* Loads the simulation first, so that the folder of a run that cannot be resumed is not touched. */
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

/* A whole run: one pass, and up to two more with finer settings where only numerical errors leave the verdict open.
 * docs/theory.md, "Error bars" (EB19), (EB20), (EB27) to (EB30); docs/guide/simulate.md has what users need. */

/* Growth of evaluations times segments from one pass to the next (median of 341 random pulls; 4.2 in 95 % of them). */
static const double GROWS = 3.1;

/* Largest number of evaluations times segments of a pass that is begun without a request: some ten minutes. */
static const double WORK_MOST = 1.5e9;

/* Steps of a pass over those of the one before: 1.7 in the median, 3.3 in 99 % of them; beyond that most passes fail.
 */
enum { STEPS_MOST = 4 };

/* ------------------------------------------------------------------------------------------ conditions for a pass */

/* Checks for a condition that finer settings can meet. Balances and damping need other settings than one level would
 * bring. */
static int is_numerical(const hawser_condition *c)
{
    return c->kind == HAWSER_CONDITION_NUMERICAL_ERROR || c->kind == HAWSER_CONDITION_NUMERICAL_PEAK ||
           c->kind == HAWSER_CONDITION_MESH || c->kind == HAWSER_CONDITION_DECIDED;
}

/* Checks for a condition on a result that the mesh may have caused: a segment that passes a support. A finer pass has
 * to meet it itself, so that its results must be the shown ones (docs/theory.md, "Error bars"). */
static int is_shown(const hawser_condition *c)
{
    return c->kind == HAWSER_CONDITION_STEADY || c->kind == HAWSER_CONDITION_PEAK ||
           c->kind == HAWSER_CONDITION_START_JOLT;
}

/* Checks whether this part of the error bound alone, N, exceeds what the condition allows. */
static int is_too_much(const hawser_condition *c, const hawser_error_bar *bar, double part)
{
    return c->value * part > c->allowed * bar->total;
}

/* Checks whether the part of friction at rest alone, which passes do not reduce, exceeds an allowed bound, or whether
 * the difference of this pass from a finer one does. */
static int is_beyond(const hawser_sim *s, const hawser_condition *c, const hawser_summary *sum)
{
    const int mean = c->kind == HAWSER_CONDITION_NUMERICAL_ERROR, peak = c->kind == HAWSER_CONDITION_NUMERICAL_PEAK;
    const hawser_error_bar *const bar = peak ? &sum->pull_peak_error : &sum->pull_mean_error;
    if (!mean && !peak) return 0;
    return is_too_much(c, bar, bar->friction) ||
           (s->others.finer && is_too_much(c, bar, other_passes_apart(&s->others, peak, sum)));
}

/* Checks whether a bend has a single pair of rollers on both sides of the cable, which (ME12) does not cover. */
static int has_single_pair(const Scene *scene)
{
    const SceneDef *const def = &scene->def;
    int found = 0;
    for (int p = 0; p < scene->route.n; ++p) {
        const RoutePiece *const leg = &scene->route.piece[p];
        int pairs = 0;
        for (int r = 1; r < def->n_rollers && leg->kind != ROUTE_STRAIGHT; ++r) {
            const double s = def->rollers[r].s;
            pairs += s >= leg->s0 && s <= leg->s0 + leg->length && fabs(s - def->rollers[r - 1].s) < 1e-6;
        }
        found |= pairs == 1;
    }
    return found;
}

/* Returns a cause for which error bounds are known to be too small, as text; NULL: there is none. */
static const char *unseen(const Scene *scene)
{
    const SceneDef *const def = &scene->def;
    if (!def->solver.relax) return "the cable did not come to rest first, for which error bounds are too small";
    for (int k = 0; k < def->n_pieces; ++k)
        if (def->cables[def->pieces[k].cable].bending.rows > 0)
            return "the cable's bending stiffness falls as it bends, for which error bounds are too small";
    return has_single_pair(scene) ? "a bend has one pair of rollers, for which error bounds are too small" : NULL;
}

/* Checks for a setting of the case itself that a second pass would refine: its results would be those of another case.
 */
static int is_setting(const char *key, const char *value)
{
    if (!strcmp(value, "auto")) return 0;
    const size_t n = strlen(key);
    const int segment = !strncmp(key, "chain", 5) && n > 8 && !strcmp(key + n - 8, ".segment");
    return segment || !strcmp(key, "solver.accuracy") || !strcmp(key, "solver.max_step") ||
           !strncmp(key, "solver.tolerances.", 18);
}

static int is_v_s(const char *key, const char *value)
{
    const size_t n = strlen(key);
    (void)value;
    return n > 4 && !strcmp(key + n - 4, ".v_s");
}

/* Returns the first key of that kind which the case or its catalogue gives; NULL: there is none. */
static const char *given(const SceneDef *def, int (*is_kind)(const char *key, const char *value))
{
    const char *text = def->inputs;
    for (int i = 0; i < def->n_inputs; ++i) {
        const char *input[INPUT_TEXTS];
        for (int k = 0; k < INPUT_TEXTS; ++k, text += strlen(text) + 1) input[k] = text;
        const int own = !strcmp(input[INPUT_ORIGIN], "given") || !strcmp(input[INPUT_ORIGIN], "catalogue");
        if (own && is_kind(input[INPUT_KEY], input[INPUT_VALUE])) return input[INPUT_KEY];
    }
    return NULL;
}

/* Returns the worst failing condition, if a finer pass may settle all that fail; NULL: none fails, or a pass would not
 * help: then *hopeless is 1. */
static const hawser_condition *worst_open(const hawser_sim *s, const hawser_summary *sum, int *hopeless)
{
    const hawser_condition *worst = NULL;
    const int replaced = !given(s->plan, is_setting);
    *hopeless = 0;
    for (int i = 0; i < sum->n_conditions; ++i) {
        const hawser_condition *const c = &sum->conditions[i];
        if (c->holds) continue;
        *hopeless |= !(is_numerical(c) || (replaced && is_shown(c))) || is_beyond(s, c, sum);
        if (!worst || c->value / c->allowed > worst->value / worst->allowed) worst = c;
    }
    return *hopeless ? NULL : worst;
}

/* Checks whether a second pass is needed: such a condition is open, or error bounds are too small; writes the reason,
 * without its remedy, into `why`. */
static int is_open(const hawser_sim *s, const hawser_summary *sum, size_t size, char *why)
{
    int hopeless;
    const hawser_condition *const worst = worst_open(s, sum, &hopeless);
    const char *const blind = unseen(&s->stage.scene);
    if (hopeless || (!worst && !blind)) return 0;
    if (!worst) {
        snprintf(why, size, "%s", blind);
        return 1;
    }
    const char *const remedy = strstr(worst->remedy, ": use "), *const other = strstr(worst->remedy, ": set ");
    const char *const end = remedy ? remedy : other ? other : worst->remedy + strlen(worst->remedy);
    snprintf(why, size, "%.*s", (int)(end - worst->remedy), worst->remedy);
    return 1;
}

/* Checks that the pass has met the conditions that a level of its settings does not change. */
static int is_sound(const hawser_summary *sum)
{
    int sound = 1;
    for (int i = 0; i < sum->n_conditions; ++i) sound &= sum->conditions[i].holds || is_numerical(&sum->conditions[i]);
    return sound;
}

/* ---------------------------------------------------------------------------------------------- reports of passes */

/* Describes a pass's own results, before another one is known. */
static void pass_describe(PassesSaid *said, const hawser_sim *s, const hawser_summary *sum, double friction)
{
    said->peak_alone[s->pass] = sum->pull_peak_error.time + sum->pull_peak_error.mesh;
    said->pass[s->pass] = (hawser_pass){.accuracy = s->stage.scene.def.solver.accuracy,
                                        .segments = sum->segments,
                                        .friction = friction,
                                        .pull_mean_N = sum->pull_mean_N,
                                        .pull_peak_N = sum->pull_peak_N,
                                        .pull_mean_bar_N = sum->pull_mean_error.total,
                                        .pull_peak_bar_N = sum->pull_peak_error.total,
                                        .steps = sum->steps,
                                        .wall_time_s = sum->wall_time_s};
}

static void say_time(double seconds, size_t size, char *text)
{
    if (seconds < 120) snprintf(text, size, "%.2g s", seconds);
    if (seconds >= 120) snprintf(text, size, "%.0f min", seconds / 60);
    if (seconds >= 7200) snprintf(text, size, "%.2g hours", seconds / 3600);
}

/* Writes "a, b and c" for a figure of every pass, at the offset `at` of hawser_pass: an int if `whole`. */
static void say_list(FILE *out, const hawser_passes *p, size_t at, int whole, const char *unit)
{
    for (int k = 0; k < p->n; ++k) {
        const char *const field = (const char *)&p->pass[k] + at, *const join = k == 0         ? ""
                                                                                : k + 1 < p->n ? ", "
                                                                                               : " and ";
        if (whole) fprintf(out, "%s%d%s", join, *(const int *)field, unit);
        if (!whole) fprintf(out, "%s%.*g%s", join, *unit ? 6 : 3, *(const double *)field, unit);
    }
}

static const char *const PASS[PASSES_MAX] = {"first", "second", "third"};

/* Describes the figures of all passes, and which of them are the run's. Returns 0 without memory. */
static int say_all(hawser_passes *p, const char *own)
{
    FILE *const out = fmemopen(p->says, sizeof p->says, "w");
    if (!out) return 0;
    fprintf(out, "computed %s, with ", p->n == 2 ? "twice" : "three times");
    say_list(out, p, offsetof(hawser_pass, segments), 1, "");
    fprintf(out, " segments and accuracies of ");
    say_list(out, p, offsetof(hawser_pass, accuracy), 0, "");
    fprintf(out, ": mean ");
    say_list(out, p, offsetof(hawser_pass, pull_mean_N), 0, " N");
    fprintf(out, ", peak ");
    say_list(out, p, offsetof(hawser_pass, pull_peak_N), 0, " N");
    if (own) {
        fprintf(out, "; as the case gives %.60s, they are those of the first pass, with bars from %s", own,
                p->n == 2 ? "both" : "all");
    } else {
        fprintf(out, "; all figures are those of the %s pass", PASS[p->n - 1]);
    }
    return !fclose(out);
}

/* Appends a sentence to the report. */
static void say_more(hawser_passes *p, const char *format, ...)
{
    va_list values;
    const size_t used = strlen(p->says);
    va_start(values, format);
    vsnprintf(p->says + used, sizeof p->says - used, format, values);
    va_end(values);
}

/* -------------------------------------------------------------------------------------------------- finer passes */

/* The passes of a run, each built from the one before. */
typedef struct Passes {
    int n; /* passes that have ended */
    hawser_sim *sim[PASSES_MAX];
    const char *own;    /* a setting that the case gives; NULL: none */
    int slower;         /* v_s is refined too */
    const OutDir *home; /* folder of the first; NULL: nothing is written */
    int resumed;        /* a pass that was begun is continued */
    PassesSaid *says;   /* the first pass's */
    hawser_progress progress;
    void *user;
} Passes;

/* Checks whether a run that is stopped here can be resumed. */
static int is_kept(const Passes *z) { return z->home && z->sim[0]->plan->output.checkpoint > 0; }

/* Folders of the other passes within the first one's. */
static const char *const FOLDER[PASSES_MAX] = {NULL, "second-pass", "third-pass"};

static void folders_remove(const Passes *z)
{
    for (int k = 1; k < PASSES_MAX && z->home; ++k) results_remove(z->home, FOLDER[k]);
}

/* Builds the next pass from the definition of the last with finer settings. Errors: MEMORY, INPUT, RUN. */
static hawser_status pass_build(Passes *z, hawser_error *err)
{
    const hawser_sim *const last = z->sim[z->n - 1];
    hawser_sim **const next = &z->sim[z->n];
    hawser_summary sum;
    SceneDef *const finer = calloc(1, sizeof *finer);
    if (!finer) return error_memory(err);
    hawser_status status = scene_def_copy(last->plan, finer, err);
    if (status) {
        free(finer);
        return status;
    }
    hawser_sim_summary(last, &sum);
    scene_def_finer_pass(finer, z->slower);
    finer->solver.max_steps = STEPS_MOST * sum.steps;
    status = sim_new(finer, last->threads, next, err);
    if (status) {
        scene_def_clear(finer);
        free(finer);
        return status;
    }
    (*next)->plan = finer;
    (*next)->pass = z->n;
    (*next)->work_most = last->work_most;
    (*next)->case_name = strdup(last->case_name);
    (*next)->title = strdup(last->title);
    if (!(*next)->case_name || !(*next)->title) return error_memory(err);
    return last->envelope.present ? envelope_new(&(*next)->envelope, &(*next)->stage.scene, err) : HAWSER_OK;
}

/* Runs a pass from its checkpoint, if the resumed run had come so far, or from its beginning; keeps what is needed to
 * take it over. Errors: as hawser_sim_run. */
static hawser_status pass_go(Passes *z, hawser_error *err)
{
    hawser_sim *const s = z->sim[z->n];
    OutDir folder;
    int over = 0;
    const OutDir *const dir = z->home ? &folder : NULL;
    hawser_status status = dir ? out_take(&folder, z->home, FOLDER[z->n], 1, err) : HAWSER_OK;
    if (status) return status;
    status = z->resumed ? pass_resume(s, dir, z->progress, z->user, &over, err) : HAWSER_ERR_INPUT;
    if (status == HAWSER_ERR_INPUT) status = pass_run(s, dir, z->progress, z->user, err); /* there is no checkpoint */
    if (!status && !over && is_kept(z)) status = pass_keep(s, dir, err);
    if (dir) out_leave(&folder);
    return status;
}

/* Takes the figures of pass `s`, for comparison with others. Errors: MEMORY. */
static hawser_status figures_of(const hawser_sim *s, PassFigures *out, hawser_error *err)
{
    hawser_summary sum;
    hawser_sim_summary(s, &sum);
    return pass_figures_take(out, &s->stats, &sum, sim_jolt(s), err);
}

/* Gives pass `s` the figures of n others, the finest first; said: reports of all of them. Errors: MEMORY. */
static hawser_status others_take(hawser_sim *s, int n, hawser_sim *const other[], const PassesSaid *said,
                                 hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    OtherPasses others = {.n = n, .finer = other[0]->pass > s->pass};
    hawser_summary sum;
    assert(n < PASSES_MAX);
    hawser_sim_summary(other[0], &sum);
    others.unsound = others.finer && !is_sound(&sum);
    for (int k = 0; k < n && !status; ++k) status = figures_of(other[k], &others.other[k], err);
    for (int k = 0; k <= n; ++k) others.peak_alone[k] = said->peak_alone[n - k];
    if (status) {
        other_passes_free(&others);
        return status;
    }
    other_passes_free(&s->others);
    s->others = others;
    return HAWSER_OK;
}

/* Takes the figures of the pass that has just ended, and exchanges them among the passes. It counts only if that
 * succeeds. Errors: MEMORY. */
static hawser_status passes_take(Passes *z, hawser_error *err)
{
    hawser_sim *const first = z->sim[0], *const last = z->sim[z->n];
    hawser_sim *const coarser[] = {z->sim[z->n - 1], first}, *const finer[] = {last, z->sim[1]};
    const double slower = z->slower ? refinement_slower(first->plan, last->pass) : 1;
    hawser_passes *const said = &z->says->said;
    hawser_summary sum;
    hawser_sim_summary(last, &sum);
    pass_describe(z->says, last, &sum, slower);
    hawser_status status = others_take(last, z->n, coarser, z->says, err);
    if (!status && z->own) status = others_take(first, z->n, finer, z->says, err);
    if (status) return status;
    said->n = z->n + 1;
    if (!say_all(said, z->own)) {
        said->n = z->n;
        return error_memory(err);
    }
    said->outcome = z->own ? "compared" : "replaced";
    ++z->n;
    return HAWSER_OK;
}

/* Returns the pass whose results are shown. */
static hawser_sim *shown_of(const Passes *z) { return z->sim[z->own ? 0 : z->n - 1]; }

/* Checks whether a pass after `last` would take too long to begin without a request, and writes its cost as text. It
 * counts evaluations, not time: a run's report is the same on any machine. */
static int is_too_long(const hawser_sim *last, PassesChoice asked, size_t size, char *about)
{
    const hawser_sim *const s = last;
    hawser_summary sum;
    hawser_sim_summary(s, &sum);
    const double work = GROWS * (double)sum.rhs_evals * sum.segments;
    say_time(GROWS * sum.wall_time_s, size, about);
    return s->plan->solver.passes < asked && work > (s->work_most > 0 ? s->work_most : WORK_MOST);
}

/* Checks whether two passes have left something open that a third may settle. */
static int third_is_wanted(Passes *z)
{
    hawser_sim *const shown = shown_of(z);
    hawser_summary sum, finest;
    char about[32];
    int hopeless;
    hawser_sim_summary(z->sim[z->n - 1], &finest);
    hawser_sim_summary(shown, &sum);
    if (z->n >= PASSES_MAX || shown->plan->solver.passes == PASSES_TWO || !is_sound(&finest)) return 0;
    if (!worst_open(shown, &sum, &hopeless)) return 0;
    if (!is_too_long(z->sim[z->n - 1], PASSES_THREE, sizeof about, about)) return 1;
    say_more(&z->says->said, "; a third one would settle what is open in about %s: set solver.passes to 3", about);
    return 0;
}

/* Makes the results of the last pass those of the handle and of the folder. Its checkpoint is removed last. Errors:
 * OUTPUT, MEMORY. */
static hawser_status passes_settle(Passes *z, hawser_error *err)
{
    hawser_sim *const first = z->sim[0];
    hawser_status status = HAWSER_OK;
    if (!z->own) {
        hawser_sim *const last = z->sim[z->n - 1];
        last->passes = first->passes;
        first->passes = NULL;
        first->finer = last;
        z->sim[z->n - 1] = NULL;
        if (z->home) status = results_replace(z->home, FOLDER[z->n - 1], err);
    }
    if (!status && z->home) status = pass_tell(SHOWN(first), z->home, err);
    if (!status) folders_remove(z);
    return status;
}

/* Gives up a pass: the results of those before remain. A stop, and a lack of memory or disk, are reported to the
 * caller: with more of either, or resumed, the run would have another answer. */
static hawser_status passes_give_up(Passes *z, hawser_status status, const hawser_error *why, hawser_error *err)
{
    hawser_passes *const said = &z->says->said;
    const int waits = status == HAWSER_STOPPED && is_kept(z), third = z->n > 1;
    const char *const pass = PASS[z->n], *const stands = third && !waits && !z->own ? "second" : "first";
    if (status == HAWSER_STOPPED)
        error_set(err, status, "stopped in the %s pass; the results are those of the %s%s", pass, stands,
                  waits ? " until it is resumed" : "");
    if (status == HAWSER_ERR_MEMORY) error_memory(err);
    if (status == HAWSER_ERR_OUTPUT)
        error_set(err, status, "%.700s; the results are those of the %s pass", why->message, stands);
    const int own = status == HAWSER_STOPPED || status == HAWSER_ERR_MEMORY || status == HAWSER_ERR_OUTPUT;
    if (third && !waits) { /* two passes are compared all the same */
        say_more(said, status == HAWSER_STOPPED ? "; a third one was stopped" : "; a third one failed: %.150s",
                 why->message);
        const hawser_status told = passes_settle(z, own ? NULL : err);
        return own ? status : told;
    }
    other_passes_free(&z->sim[0]->others);
    said->outcome = "failed";
    said->n = 1;
    *said->says = 0;
    say_more(said,
             status == HAWSER_STOPPED ? "a %s pass was stopped; these are the figures of the first"
                                      : "a %s pass failed: %.400s",
             pass, why->message);
    if (!waits) folders_remove(z);
    if (status == HAWSER_ERR_MEMORY) return status;
    const hawser_status told = z->home ? pass_tell(z->sim[0], z->home, own ? NULL : err) : HAWSER_OK;
    return own ? status : told;
}

/* Decides whether a second pass is to be made, and the report if the verdict is open. Errors: MEMORY. */
static hawser_status second_ask(hawser_sim *s, int *wanted, hawser_error *err)
{
    char why[sizeof s->passes->said.why], about[32];
    hawser_summary sum;
    *wanted = 0;
    hawser_sim_summary(s, &sum);
    if (!is_open(s, &sum, sizeof why, why)) return HAWSER_OK;
    s->passes = calloc(1, sizeof *s->passes);
    if (!s->passes) return error_memory(err);
    hawser_passes *const said = &s->passes->said;
    memcpy(said->why, why, sizeof why);
    said->n = 1;
    said->pass = s->passes->pass;
    pass_describe(s->passes, s, &sum, 1);
    *wanted = !is_too_long(s, PASSES_TWO, sizeof about, about);
    if (*wanted) return HAWSER_OK;
    said->outcome = "declined";
    say_more(said, "a second pass with finer settings would settle that in about %s: set solver.passes to 2", about);
    return HAWSER_OK;
}

/* Runs finer passes after a first. resumed: that had ended when the run was stopped, and is restored. Errors: OUTPUT,
 * MEMORY, STOPPED. */
static hawser_status finer_passes(hawser_sim *s, const OutDir *dir, int resumed, hawser_progress progress, void *user,
                                  hawser_error *err)
{
    hawser_error late = {.status = HAWSER_OK};
    Passes z = {.n = 1, .sim = {s}, .home = dir, .resumed = resumed, .progress = progress, .user = user};
    int wanted;
    hawser_status status = second_ask(s, &wanted, err);
    if (status) return status;
    if (!wanted) return dir && s->passes ? pass_tell(s, dir, err) : HAWSER_OK;
    z.says = s->passes;
    z.own = given(s->plan, is_setting);
    z.slower = z.own || !given(s->plan, is_v_s); /* a pass that is only compared may have another friction law */
    if (!resumed) folders_remove(&z);            /* left by an earlier run */
    if (is_kept(&z) && !resumed) status = pass_keep(s, dir, err);
    if (!status) {
        do {
            status = pass_build(&z, &late);
            if (!status) status = pass_go(&z, &late);
            if (!status) status = passes_take(&z, &late);
        } while (!status && third_is_wanted(&z));
        status = status ? passes_give_up(&z, status, &late, err) : passes_settle(&z, err);
    }
    for (int k = 1; k < PASSES_MAX; ++k) sim_free(z.sim[k]);
    return status;
}

/* Checks that all of the run is still to come: a simulation that the caller has advanced is not computed again. */
static int is_whole(const hawser_sim *s)
{
    return s->plan && !s->pass && !s->passes && !s->relaxed && !(hawser_sim_time(s) > 0);
}

/* Continues after a pass that has ended, and removes the checkpoint of a finished run. */
static hawser_status go_on(hawser_sim *s, const OutDir *dir, int whole, int over, hawser_status status,
                           hawser_progress progress, void *user, hawser_error *err)
{
    if (!status && whole && !s->led) status = finer_passes(s, dir, over, progress, user, err);
    if (dir && (!status || status == HAWSER_ERR_RUN)) results_no_checkpoint(dir);
    if (dir && !status) status = out_stays(dir, err); /* the folder may have been exchanged meanwhile */
    return status;
}

/* Checks that a run into `dir` overwrites none of the files that the case was read from: in the folder, and in those of
 * its passes and its chains within. Errors: INPUT. */
static hawser_status inputs_spare(hawser_sim *s, const char *dir, hawser_error *err)
{
    const FileMarks *const files = &s->stage.scene.def.files;
    char path[OUT_PATH_MAX];
    hawser_status status = results_spare(dir, files, err);
    for (int k = 1; k < PASSES_MAX + sim_chains(s) && !status; ++k) {
        const int pass = k < PASSES_MAX;
        status = out_join(path, dir, pass ? FOLDER[k] : sim_chain(s, k - PASSES_MAX)->stage.scene.def.strand.name, err);
        if (!status) status = results_spare(path, files, err);
    }
    return status;
}

/* Checks that it may be advanced: INPUT if not. */
static hawser_status can_run(const hawser_sim *s, hawser_error *err)
{
    team_settle(s->team);
    if (s->inside || s->running) return error_inside(err);
    return s->leader ? error_led(err) : HAWSER_OK;
}

/* Keeps the folder for one run from its beginning to its end. */
hawser_status hawser_sim_run(hawser_sim *s, const char *dir, hawser_progress progress, void *user, hawser_error *err)
{
    hawser_error local = {.status = HAWSER_OK};
    hawser_error *const e = err ? err : &local;
    OutDir folder, *const home = dir ? &folder : NULL;
    s = SHOWN(s);
    if (!s) return error_argument(e, "s");
    hawser_status status = can_run(s, e);
    if (status) return status;
    const int whole = is_whole(s);
    if (home) status = inputs_spare(s, dir, e);
    if (home && !status) status = out_take(home, NULL, dir, 1, e);
    if (status) return pass_settle(s, status, e);
    status = go_on(s, home, whole, 0, pass_run(s, home, progress, user, e), progress, user, e);
    if (home) out_leave(home);
    return status;
}

hawser_status hawser_sim_resume(hawser_sim *s, const char *dir, hawser_progress progress, void *user, hawser_error *err)
{
    hawser_error local = {.status = HAWSER_OK};
    hawser_error *const e = err ? err : &local;
    OutDir folder;
    s = SHOWN(s);
    if (!s || !dir) return error_argument(e, s ? "dir" : "s");
    hawser_status status = can_run(s, e);
    if (status) return status;
    const int whole = is_whole(s);
    int over = 0;
    if (access(dir, F_OK))
        return error_set(e, HAWSER_ERR_INPUT, "no run to go on with in '%.700s': %s", dir, strerror(errno));
    status = inputs_spare(s, dir, e);
    if (!status) status = out_take(&folder, NULL, dir, 0, e);
    if (status) return pass_settle(s, status, e);
    status = pass_resume(s, &folder, progress, user, &over, e);
    status = go_on(s, &folder, whole, over, status, progress, user, e);
    out_leave(&folder);
    return status;
}
