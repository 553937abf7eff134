#include "sim/run/sim.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/base/isa.h"
#include "core/base/lanes.h"
#include "core/body.h"
#include "core/state.h"
#include "sim/equipment/rod.h"
#include "sim/equipment/winch.h"
#include "sim/run/commands.h"
#include "sim/run/look.h"
#include "sim/run/quasi_run.h"
#include "sim/run/together.h"
#include "sim/stage/modes.h"
#include "sim/stage/statics.h"
#include "sim/watch/events.h"
#include "theory/cannot.h"

hawser_status sim_trip_set(Sim *s, hawser_error *err)
{
    Winch *const w = s->stage.scene.winch;
    if (!(w->trip.factor > 0) || w->trip_force > 0) return HAWSER_OK;
    w->trip_force = w->trip.factor * s->expected.reference_total;
    if (w->trip_force > 0) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT,
                     "key 'drive.winch.trip.factor': the reference theory expects a winch force of %g N, which is no "
                     "measure for a trip: give 'force'",
                     s->expected.reference_total);
}

static hawser_status parts_new(Sim *s, const SceneDef *def, hawser_error *err)
{
    const Scene *const scene = &s->stage.scene;
    if (s->threads > 1) s->team = team_new(s->threads);
    if (s->threads > 1 && !s->team) return error_memory(err);
    hawser_status status = stage_new(&s->stage, def, s->team, err);
    if (status) return status;
    if (scene->def.theory.simulated) status = cannot_be_pulled(&scene->setup, 1, err);
    if (status) return status;
    s->stage.motion->ops->lin_stats(s->stage.motion, &s->lin);
    s->condition = calloc(HAWSER_CONDITIONS_MAX, sizeof *s->condition);
    if (!s->condition || !sample_alloc(&s->look, scene)) return error_memory(err);
    status = positions_new(&s->positions, &s->stage, err);
    if (!status) status = mesh_find(&scene->setup.supports, &s->mesh, err);
    if (!status) status = passing_new(&s->passing, scene, err);
    if (!status) status = probes_new(&s->probes, scene, err);
    if (!status) status = stats_new(&s->stats, scene, err);
    if (!status) status = peaks_new(&s->peaks, scene, err);
    if (!status) status = bundle_terms_make(&scene->def, &s->bundle, err);
    if (!status && !scene->rod->present) {
        status = expected_fill(&scene->setup, s->stats.n_stations, s->stats.station_out, &s->expected, err);
    }
    if (!status && !scene->rod->present) status = by_position_new(&s->by_position, &scene->setup, err);
    if (!status) status = machines_new(&s->machines, scene, &s->expected, err);
    if (!status) status = quasi_run_new(s, err);
    if (!status && !scene->def.strand.present) status = sim_trip_set(s, err);
    if (!status) status = start_check(s, err);
    if (!status) status = start_grades(s, err);
    if (!status) status = start_held(s, err);
    return status ? status : start_fit(s, err);
}

/* What the integrator moves, and its state. */

/* The simulations of the chains beside this one, in the order of the case, and what moves them all. */
static hawser_status beside_new(Sim *s, const SceneDef *def, hawser_error *err)
{
    Sim **const sim = calloc((size_t)def->n_beside + 1, sizeof(Sim *));
    hawser_status status = sim ? HAWSER_OK : error_memory(err);
    int n = 0;
    if (sim) sim[n++] = s;
    for (int k = 0; !status && k < def->n_beside; ++k) {
        status = sim_new(&def->beside[k], 1, &sim[n], err);
        n += !status;
    }
    if (!status) {
        status = together_new(sim, n, err);
        if (!status) sim_motion(s)->ops->lin_stats(sim_motion(s), &s->lin);
        if (s->together) return status; /* it has taken them over */
    }
    for (int k = 1; k < n; ++k) sim_free(sim[k]);
    free(sim);
    return status;
}

hawser_status sim_new(const SceneDef *def, int threads, Sim **out, hawser_error *err)
{
    const double start = clock_now();
    Sim *s = calloc(1, sizeof *s);
    *out = NULL;
    if (!s) return error_memory(err);
    if (isa_complaint()) {
        free(s);
        return error_set(err, HAWSER_ERR_INPUT, "%s", isa_complaint());
    }
    SceneDef mine = *def; /* the scene makes its own deep copy */
    if (mine.strand.present) mine.solver.planar = PLANAR_OFF;
    if (threads > 0) mine.solver.threads = mine.solver.linear.threads = threads;
    s->threads = mine.solver.threads;
    hawser_status status = parts_new(s, &mine, err);
    if (!status && mine.n_beside > 0) status = beside_new(s, &mine, err);
    if (status) {
        sim_free(s);
        return status;
    }
    s->build_s = clock_now() - start;
    *out = s;
    return HAWSER_OK;
}

Sim *sim_free(Sim *s)
{
    if (!s) return NULL;
    for (int k = 1; k < sim_chains(s); ++k) sim_free(sim_chain(s, k));
    s->together = together_free(s->together);
    mesh_free(&s->mesh);
    stats_free(&s->stats);
    machines_free(&s->machines);
    peaks_free(&s->peaks);
    envelope_free(&s->envelope);
    closeup_free(&s->closeup);
    around_free(s->around);
    events_free(&s->events);
    passing_free(&s->passing);
    expected_free(&s->expected);
    bundle_terms_free(&s->bundle);
    by_position_free(&s->by_position);
    sample_free(&s->look);
    probes_free(&s->probes);
    modes_free(&s->modes);
    positions_free(&s->positions);
    quasi_run_free(&s->quasi);
    stage_free(&s->stage);
    team_free(s->team);
    free(s->condition);
    free(s->case_name);
    free(s->title);
    free(s->case_text);
    free(s->case_folder);
    text_pool_free(&s->texts);
    if (s->plan) scene_def_clear(s->plan);
    free(s->plan);
    other_passes_free(&s->others);
    free(s->passes);
    sim_free(s->finer);
    free(s);
    return NULL;
}

/* By the kinematics in the workspaces. */
static void overlap_watch(Sim *s)
{
    const Scene *const alone = &s->stage.scene;
    if (s->together) {
        together_overlap(s->together, &s->passing.overlap, s->stage.t);
    } else {
        overlap_record(&s->passing.overlap, SELF_ALONE(&alone->chain, &s->stage.ws.kin), &alone, s->stage.t);
    }
}

/* Positions in place of time steps: each is found by itself, whatever came before. */
static hawser_status advance_positions(Sim *s, double t, int one_step, hawser_error *err)
{
    const double start = clock_now();
    hawser_status status = HAWSER_OK;
    while (s->stage.t < t && !status) {
        hawser_relaxation found = {0};
        status = positions_advance(&s->positions, &s->stage, positions_next(&s->positions, s->stage.t, t), &found, err);
        if (!status || status == HAWSER_ERR_RUN) sim_relaxation_take(s, &found);
        if (!status) passing_look(&s->passing, &s->stage.scene, &s->stage.ws, 0, s->stage.t);
        if (!status) overlap_watch(s);
        if (!status) status = positions_record(&s->positions, &s->stage, sim_look(s, SAMPLE_ROW), &found, err);
        if (one_step) break;
    }
    s->relax_s += clock_now() - start;
    return status;
}

/* Where the integrator must stop next: where a room is not smooth, at a row of a script, or at `stop`. */
static double next_stop(Sim *s, double stop)
{
    for (int k = 0; k < sim_chains(s); ++k) {
        const Sim *const each = sim_chain(s, k);
        stop = fmin(scene_next_stop(&each->stage.scene, each->stage.t, stop), script_next(each));
    }
    return stop;
}

/* Where the cable's front is, m along the route; NAN if it is not simulated, or in the plane. Brings the kinematics of
 * its segment up to date and leaves the ghosts to who comes next. */
static double front_at(Stage *st)
{
    const Scene *const scene = &st->scene;
    const int eye = scene->eye - scene->first, last = eye > 0 ? eye - 1 : 0, n = scene->chain.n;
    if (st->motion != &st->spatial.motion || eye < 0 || eye > n) return NAN;
    const int from = last / LANES * LANES, to = from + LANES < n ? from + LANES : n;
    body_kernels()->kinematics(n, st->y, from, to, &st->ws.kin);
    return along_eye(scene, &st->ws.kin, winch_motion(scene->winch, &scene->chain, &st->ws.kin, st->t).travel);
}

/* What a step may have brought about, with the winch's pull as it was then. */
static hawser_status events_watch(Sim *s, hawser_error *err)
{
    Stage *const st = &s->stage;
    Scene *const scene = &st->scene;
    Occasion now = {.t = st->t, .front = NAN, .travel = NAN};
    int watched = 0;
    for (int r = 0; r < scene->n_rooms; ++r) {
        const Room *const room = &scene->room[r];
        if (room->present && room->kind->watches) watched |= room->kind->watches(room);
    }
    if (!watched) return HAWSER_OK;
    if (watched & WATCH_FRONT) now.front = front_at(st);
    now.pull = st->motion->ops->winch_pull(st->motion, st->t, st->y);
    if (watched & WATCH_TRAVEL) now.travel = winch_motion(scene->winch, &scene->chain, &st->ws.kin, st->t).travel;
    hawser_status status = HAWSER_OK;
    for (int r = 0; r < scene->n_rooms; ++r) {
        Room *const room = &scene->room[r];
        if (!room->present || !room->kind->watches || !room->kind->watches(room)) continue;
        for (Occurrence h; !status && (h = room->kind->happen(room, &now)).what;)
            status = sim_note(s, h.code, st->t, h.what, now.pull, err);
    }
    return status;
}

/* Between two rows a joint may have turned right round: rods are looked at after every step. */
static void rod_watch(Sim *s)
{
    Stage *const st = &s->stage;
    dynamics_kinematics(&st->scene, &st->ws, st->t, st->y);
    st->stability.turned |= turned(&st->scene, 0, &st->ws.kin) & TURNED_JOINT;
}

/* Chains have one integrator, the first's: who swings fastest bounds its steps (EB25). */
static void swings_bound(Sim *first)
{
    double least = 0;
    if (!first->stage.integrator) return;
    for (int k = 0; k < sim_chains(first); ++k) {
        const double bound = sim_chain(first, k)->stats.swings.bound;
        if (bound > 0 && !(least > 0 && least < bound)) least = bound;
    }
    integrator_bound(first->stage.integrator, least);
}

/* Peaks between two rows are peaks of the run as well (EB14). */
static void peak_watch(Sim *s)
{
    Stage *const st = &s->stage;
    const int drawn = st->scene.winch->present;
    if (!drawn && st->scene.def.strand.joined < 0) return;
    const double start = clock_now(), pull = drawn ? st->motion->ops->winch_pull(st->motion, st->t, st->y)
                                                   : together_pull(together_of(s), s);
    st->motion->ops->glance(st->motion);
    const int due = stats_step(&s->stats, &st->scene, st->t, pull, st->ws.law[0], st->ws.on_roller);
    if (drawn) swings_bound(s->leader ? s->leader : s);
    s->record_s += clock_now() - start;
    if (!due) return;
    const hawser_sample *const look = sim_look(s, SAMPLE_ROW);
    hawser_sample held = *look;
    held.winch_force = stats_peak(&s->stats, &st->scene, &st->ws.kin, look);
    steadiness_held(&s->steadiness, held.winch_force, held.t);
    peaks_record(&s->peaks, &st->scene, &st->ws.kin, &held);
}

/* Of several chains the one with the fastest point. */
static Sim *fastest_chain(Sim *s)
{
    Sim *fastest = s;
    double most = -1;
    for (int k = 0; k < sim_chains(s); ++k) {
        Sim *const each = sim_chain(s, k);
        const double speed = each->stage.motion->ops->speed(each->stage.motion, each->stage.y);
        if (speed > most) fastest = each;
        most = fmax(most, speed);
    }
    return fastest;
}

/* The one whose scene that is. */
static Sim *chain_with(Sim *s, const Scene *scene)
{
    int k = 0;
    while (k + 1 < sim_chains(s) && &sim_chain(s, k)->stage.scene != scene) ++k;
    return sim_chain(s, k);
}

void sim_held_up(Sim *s, const StallFrom *from, hawser_hold *out)
{
    const SceneDef *const def = &s->stage.scene.def;
    const Motion *const m = sim_motion(s);
    Integrator *const in = s->stage.integrator;
    const double longest = def->solver.max_step > 0 ? def->solver.max_step : def->output.interval;
    stall_cause(from, in, s->stage.t, longest, out);
    int segment = stall_by_speed(out) ? 0 : integrator_worst(in);
    Sim *const each = stall_by_speed(out) ? fastest_chain(s) : chain_with(s, m->ops->whose(m, &segment));
    stall_place(&each->stage.scene, segment, sim_look(each, SAMPLE_ALL), each->stats.roller_out,
                each->stats.surface_out, out);
}

/* The window whose steps were shortest stays in mind. */
static hawser_status stall_watch(Sim *s, hawser_error *err)
{
    const double t = s->stage.t;
    if (stall_step(&s->stall, s->stage.integrator, t, hawser_sim_end_time(s))) {
        sim_held_up(s, &s->stall.from, &s->stall.slowest);
        stall_begin(&s->stall, s->stage.integrator, t);
    }
    if (s->stall.crawls < STALL_CRAWLS) return HAWSER_OK;
    return error_set(
        err, HAWSER_ERR_RUN,
        "the run crawls, with steps below a thousandth of its usual ones and more than 1e8 of them to the end, and is "
        "stopped: %s; something has caught there, or is stiffer than it can be",
        s->stall.slowest.says);
}

/* A failed step: what had held up the ones before it goes with the message. */
static void failure_explain(Sim *s, hawser_error *err)
{
    hawser_hold hold;
    if (!err || !s->stage.integrator || s->stall.left == 0) return;
    sim_held_up(s, &s->stall.from, &hold);
    const size_t used = strlen(err->message);
    snprintf(err->message + used, sizeof err->message - used, "; before it %s", hold.says);
}

/* The modes about the equilibrium of the end. */
static hawser_status modes_at_end(Sim *s, hawser_error *err)
{
    hawser_error why = {0};
    modes_free(&s->modes);
    const hawser_status status = modes_find(&s->stage, s->stage.scene.def.analysis.modes, 0, &s->modes, &why);
    if (status == HAWSER_ERR_RUN)
        return error_set(err, status, "at t = %.6g s %s; fewer run.modes may help", s->stage.t, why.message);
    if (status) *err = why;
    return status;
}

/* Load steps in place of time steps. */
static hawser_status advance_static(Sim *s, double t, int one_step, hawser_error *err)
{
    const SceneDef *const def = &s->stage.scene.def;
    const double step = def->duration / def->analysis.load_steps, start = clock_now();
    hawser_status status = HAWSER_OK;
    while (s->stage.t < t && !status) {
        const double next = step * (floor(s->stage.t / step + 1e-6) + 1);
        status = statics_advance(&s->stage, next > t - 1e-6 * step ? t : next, &s->relaxation, err);
        if (one_step) break;
    }
    if (!status && def->analysis.kind == ANALYSIS_MODES && s->stage.t >= def->duration) status = modes_at_end(s, err);
    s->relax_s += clock_now() - start;
    return status;
}

/* What is due after a step, or before the first. */
static hawser_status step_watch(Sim *s, hawser_error *err)
{
    hawser_status status = events_watch(s, err);
    if (!status) peak_watch(s);
    if (!status && s->stage.scene.rod->present) rod_watch(s);
    return status ? status : script_due(s, err);
}

/* Peaks of what all press rollers with. */
static void chains_watch(struct Together *all)
{
    if (!together_stepped(all)) return;
    for (int k = all->n - 1; k >= 0; --k) sim_look(all->sim[k], SAMPLE_ROW);
    together_peak(all);
}

/* One step of the equations of motion. */
static hawser_status advance_moving(Sim *s, double t, hawser_error *err)
{
    const double stop = next_stop(s, t);
    hawser_status status = s->together ? together_step(s->together, stop, err) : stage_step(&s->stage, stop, err);
    if (status == HAWSER_ERR_RUN) failure_explain(s, err);
    if (!status) status = stall_watch(s, err);
    for (int k = 0; !status && k < sim_chains(s); ++k) status = step_watch(sim_chain(s, k), err);
    if (!status && s->together) chains_watch(s->together);
    return status ? status : quasi_begin(s, err);
}

/* On by positions in steady motion; each of them counts, whatever rows there are. Who goes step by step is shown a step
 * of rows: positions may be farther apart. */
static hawser_status advance_still(Sim *s, double t, int one_step, hawser_error *err)
{
    const double interval = s->stage.scene.def.output.interval;
    int arrived;
    if (one_step && interval > 0) t = fmin(t, s->stage.t + interval);
    hawser_status status = quasi_move(s, t, &arrived, err);
    if (status || !arrived) return status;
    s->stats.step_t = s->stage.t; /* what steps say begins again behind it */
    sim_record_row(s);
    return events_watch(s, err);
}

/* Without memory parts may be half renewed: from then on nothing of them is looked at. */
static hawser_status torn_or(Sim *s, hawser_status status)
{
    for (int k = 0; k < sim_chains(s) && status == HAWSER_ERR_MEMORY; ++k) sim_chain(s, k)->stage.torn = 1;
    return status;
}

static hawser_status advance(Sim *s, double t, int one_step, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    if (s->stage.scene.def.analysis.kind == ANALYSIS_POSITIONS) return advance_positions(s, t, one_step, err);
    if (s->stage.scene.def.analysis.kind != ANALYSIS_DYNAMICS) return advance_static(s, t, one_step, err);
    for (int k = 0; !status && k < sim_chains(s); ++k) {
        Sim *const each = sim_chain(s, k);
        WinchPhase *const winch = &each->stage.scene.winch->phase;
        if (winch->held == HELD_FIRST) winch->held = 0; /* the brake that held a winch of set tension is let off */
        status = script_due(each, err);                 /* what is due at the very beginning */
    }
    while (s->stage.t < t && !status) {
        status = s->quasi.stage.on ? advance_still(s, t, one_step, err) : advance_moving(s, t, err);
        if (!status && (s->calls.step || s->calls.law || s->calls.stop)) status = sim_call(s, err);
        if (one_step) break;
    }
    return status;
}

hawser_status sim_advance(Sim *s, double t, int one_step, hawser_error *err)
{
    return s->stage.torn ? error_memory(err) : torn_or(s, advance(s, t, one_step, err));
}

double hawser_sim_time(const Sim *s) { return s ? SHOWN(s)->stage.t : NAN; }
double hawser_sim_end_time(const Sim *s)
{
    s = SHOWN(s);
    return s ? fmin(s->stage.scene.def.duration, s->stage.scene.winch->phase.ended) : NAN;
}
const char *hawser_sim_title(const Sim *s) { return s ? SHOWN(s)->title : ""; }

const hawser_sample *hawser_sim_sample(Sim *s) { return s ? sim_look(SHOWN(s), SAMPLE_ALL) : NULL; }

/* Says once that the run has left what its model can do. */
static void turned_watch(Sim *s, const hawser_sample *look)
{
    Stage *const st = &s->stage;
    const int now = turned(&st->scene, st->motion == &st->planar.motion, &st->ws.kin) & ~s->overturned;
    hawser_error only_a_note;
    if (now & TURNED_JOINT) sim_note(s, HAWSER_EVENT_TURNED, st->t, TURNED_JOINT_SAYS, look->winch_force, &only_a_note);
    if (now & TURNED_HEAD) sim_note(s, HAWSER_EVENT_TURNED, st->t, TURNED_HEAD_SAYS, look->winch_force, &only_a_note);
    s->overturned |= now;
}

static void record_one(Sim *s, SampleParts parts)
{
    const hawser_sample *const look = sim_look(s, s->envelope.present && parts < SAMPLE_FIELDS ? SAMPLE_FIELDS : parts);
    const double start = clock_now();
    if (look->active_contacts > s->active_max) s->active_max = look->active_contacts;
    turned_watch(s, look);
    stray_record(&s->stray, &s->stage.scene, &s->stage.ws.kin, look->winch_travel, look->t);
    hawser_error only_a_note;
    if (!(look->t > 0)) passing_start(&s->passing, &s->stage.scene, &s->stage.ws.kin, look);
    if (passing_record(&s->passing, &s->stage.scene, &s->stage.ws, look->winch_travel, look->t))
        sim_note(s, HAWSER_EVENT_PASSED, look->t, s->passing.says, look->winch_force, &only_a_note);
    stats_record(&s->stats, &s->stage.scene, &s->stage.ws.kin, look);
    if (s->stats.fresh) steadiness_record(&s->steadiness, &s->stage.scene, look, s->stats.dt);
    if (s->stats.fresh) machines_record(&s->machines, s->stats.dt, s->stats.steady);
    const int steady = look->winch_speed > 0.98 * s->stage.scene.largest_speed;
    const double dt = s->by_position.last_t >= 0 ? look->t - s->by_position.last_t : 0;
    if (look->t - dt >= s->stats.steady_from - 1e-9) by_position_window(&s->by_position, look->reference, dt);
    by_position_record(&s->by_position, look->t, look->head_at, look->winch_force, look->reference, steady);
    peaks_record(&s->peaks, &s->stage.scene, &s->stage.ws.kin, look);
    if (s->envelope.present) envelope_record(&s->envelope, &s->stage.scene, &s->stage.ws.kin, look);
    s->record_s += clock_now() - start;
}

/* The first last, whose look is at all of them. */
static void record_now(Sim *s, SampleParts parts)
{
    if (s->stage.torn) return;
    for (int k = sim_chains(s) - 1; k >= 0; --k) record_one(sim_chain(s, k), parts);
    if (s->together) together_row(s->together);
    overlap_watch(s);
}

void hawser_sim_record(Sim *s)
{
    if (s) record_now(SHOWN(s), SAMPLE_ALL);
}
void sim_record_row(Sim *s) { record_now(s, SAMPLE_ROW); }
