/* Start of the chain: not inside itself, not inside what it is pulled over, and at rest. */
#include "sim/run/sim.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/body.h"
#include "core/error.h"
#include "core/lanes.h"
#include "core/machine.h"
#include "core/state.h"
#include "sim/equipment/forces.h"
#include "sim/equipment/reel.h"
#include "sim/equipment/rod.h"
#include "sim/equipment/winch.h"
#include "sim/run/commands.h"
#include "sim/run/look.h"
#include "sim/run/modes.h"
#include "sim/run/quasi.h"
#include "sim/run/sample.h"
#include "sim/run/statics.h"
#include "sim/run/trust.h"
#include "theory/conditions.h"

static const double GRADE_LOST = M_PI / 180; /* rad, largest loss of grade in one bend that is not reported */

/* No contact can find on which side of a triangle the line is that runs through it. */
static hawser_status start_clear(const Sim *s, hawser_error *err)
{
    const Scene *const scene = &s->stage.scene;
    Vec3 at;
    const int layer = passing_pierced(scene, &s->stage.ws.kin, &at);
    if (layer < 0) return HAWSER_OK;
    at = v3_add(at, scene->def.route_origin);
    return error_set(err, HAWSER_ERR_INPUT,
                     "environment: layer '%.80s' runs through the cable's axis at the start, near (%.3f, %.3f, %.3f) "
                     "m: move the model or the route, leave the part out ('leave'), or give it 'contact: no'",
                     scene->def.environment.mesh.layer_name[layer], at.x, at.y, at.z);
}

/* No contact can find on which side of each other crossing lines are. */
static hawser_status start_check(Sim *s, hawser_error *err)
{
    const Scene *const scene = &s->stage.scene;
    const hawser_status status = start_clear(s, err);
    if (status) return status;
    if (!scene->self.present) return HAWSER_OK;
    const SelfDetail deepest =
        self_deepest(&scene->self, SELF_ALONE(&scene->chain, &s->stage.ws.kin), &s->stage.ws.self);
    const double radius = scene->chain.radius[deepest.element < scene->chain.n ? deepest.element : scene->chain.n - 1];
    if (!(deepest.depth > radius / 4)) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT,
                     "contact.cable_on_cable: the cable begins %.1f mm inside itself near (%.3f, %.3f, %.3f) m, at "
                     "segments %d and %d: lead the route past itself with a cable's diameter between",
                     1e3 * deepest.depth, deepest.point.x, deepest.point.y, deepest.point.z, deepest.element,
                     deepest.foot);
}

/* Reports in an event the bend that loses the route's grade. Errors: MEMORY. */
static hawser_status start_grades(Sim *s, hawser_error *err)
{
    const Route *const route = &s->stage.scene.route;
    double before, after;
    const int bend = route_grade_lost(route, GRADE_LOST, &before, &after);
    if (bend < 0 || s->stage.scene.def.rod.present) return HAWSER_OK;
    snprintf(s->grade_says, sizeof s->grade_says,
             "bend '%s' turns to the side on a grade of %.1f deg and leaves it at %.1f deg: it lies in one plane",
             route->piece[bend].name, before * 180 / M_PI, after * 180 / M_PI);
    return sim_note(s, HAWSER_EVENT_NOTE, 0, s->grade_says, s->look.sample.winch_force, err);
}

/* Reports in an event the force that holds the tail before the start if the case gives none (BK11). */
static hawser_status start_held(Sim *s, hawser_error *err)
{
    const Scene *const scene = &s->stage.scene;
    if (isnan(scene->tail_held)) return HAWSER_OK;
    snprintf(
        s->held_says, sizeof s->held_says,
        "friction holds the cable where it hangs: before the start a brake holds its tail with %.4g kN, and is let "
        "go until %.3g s",
        scene->tail_held / 1e3, scene->tail.t1);
    return sim_note(s, HAWSER_EVENT_NOTE, 0, s->held_says, s->look.sample.winch_force, err);
}

/* Checks whether no contact force exceeds the sum of all loads, by a look at the present state. */
static int fits(void *user)
{
    Sim *const s = user;
    Stage *const st = &s->stage;
    const int active = st->motion->ops->look(st->motion, st->t, st->y, 0);
    passing_start(&s->passing, &st->scene, &st->ws.kin,
                  sample_take(&s->look, &st->scene, &st->ws, st->t, active, SAMPLE_ROW));
    return s->passing.start.force <= s->passing.start.allowed;
}

/* Relaxes a chain in space without its weight, so that nothing falls yet, and only until it fits (E7). A chain that
 * does not fit then starts where it was. */
static hawser_status move_out(Sim *s, const double *laid, hawser_error *err)
{
    Stage *const st = &s->stage;
    hawser_relaxation moved;
    hawser_error ended;
    const Weight weight = st->scene.weight;
    st->scene.weight.gravity = st->scene.weight.behind = V3_ZERO;
    st->ws.stop = (StopCheck){.ask = fits, .user = s, .firm = 1};
    const hawser_status status = st->motion->ops->relax(st->motion, st->t, st->y, &moved, &ended);
    st->ws.stop = (StopCheck){0};
    st->scene.weight = weight;
    if (status && status != HAWSER_STOPPED) {
        *err = ended;
        return status;
    }
    if (fits(s)) return sim_note(s, HAWSER_EVENT_NOTE, st->t, START_MOVED_SAYS, s->look.sample.winch_force, err);
    memcpy(st->y, laid, (size_t)st->motion->size * sizeof *laid);
    return st->motion->ops->renew(st->motion, st->t, st->y, err);
}

/* Moves a chain that is not to be relaxed, but whose chords are inside what the line would only touch, out of it: by
 * the relaxation, which ends as soon as no contact force exceeds the sum of all loads (E7). Errors: MEMORY. */
static hawser_status start_fit(Sim *s, hawser_error *err)
{
    Stage *const st = &s->stage;
    const SceneDef *const def = &st->scene.def;
    if (def->solver.relax || def->rod.present || fits(s)) return HAWSER_OK;
    const size_t bytes = (size_t)st->motion->size * sizeof(double);
    double *const laid = malloc(bytes);
    if (!laid) return error_memory(err);
    memcpy(laid, st->y, bytes);
    const hawser_status status = move_out(s, laid, err);
    free(laid);
    return status;
}

/* The relaxation starts at rest; initial speeds of the case are set after it. */
static void chain_stop(Stage *st)
{
    const size_t n = (size_t)st->scene.chain.n;
    if (st->scene.def.launch.present) memset(st->y + STATE_V * n, 0, (STATE_SIZE - STATE_V) * n * sizeof *st->y);
}

hawser_status sim_relax(Sim *s, hawser_relaxation *out, hawser_error *err)
{
    const double start = clock_now();
    const Scene *const scene = &s->stage.scene;
    hawser_status status;
    if (s->stage.torn) return error_memory(err);
    for (int k = 0; k < sim_chains(s); ++k) {
        Sim *const each = sim_chain(s, k);
        Stage *const st = &each->stage;
        chain_stop(st);
        st->motion->ops->look(st->motion, st->t, st->y, 0);
        passing_look(&each->passing, &st->scene, &st->ws, 0, st->t); /* the state that is kept */
    }
    if (s->together) {
        status = together_relax(s->together, &s->relaxation, err);
    } else if (scene->rod->present) {
        const double share = scene->def.analysis.kind == ANALYSIS_DYNAMICS ? scene->def.solver.relax_tolerance
                                                                           : scene->def.analysis.tolerance;
        s->relaxation = (hawser_relaxation){0};
        status = statics_settle(&s->stage, share, &s->relaxation, err);
    } else if (scene->def.analysis.kind == ANALYSIS_POSITIONS) {
        status = s->positions.done > 0 ? HAWSER_OK : sim_advance(s, s->positions.time[0], 1, err);
    } else {
        status = s->stage.motion->ops->relax(s->stage.motion, s->stage.t, s->stage.y, &s->relaxation, err);
    }
    for (int k = 0; k < sim_chains(s); ++k) {
        Sim *const each = sim_chain(s, k);
        each->relaxation = s->relaxation;
        if (!status && each->stage.t <= 0) scene_launch(&each->stage.scene, each->stage.y);
    }
    s->relax_s += clock_now() - start;
    if (out) *out = s->relaxation;
    return status;
}

/* Half a roller's width over the allowed distance of the cable from its middle. */
static const double WIDER = 1 / TRUST_EDGE;

static hawser_status off_roller(const Edge *e, hawser_error *err)
{
    char at[32] = "";
    if (!isnan(e->at)) snprintf(at, sizeof at, " at %.4g m", e->at);
    return error_set(
        err, HAWSER_ERR_RUN,
        "at rest the cable lies %.0f mm beside the middle of roller '%s'%s, which is %.0f mm wide: it is off it "
        "before anything moves. Rollers of about %.0f mm or wider would hold it there, or guides beside it "
        "('guide: both'); 'run.keep_going: true' goes on all the same",
        1e3 * e->across, e->name, at, 2e3 * e->half, 10 * ceil(1e2 * 2 * e->across * WIDER));
}

hawser_status place_check(Sim *s, hawser_error *err)
{
    for (int k = 0; k < sim_chains(s); ++k) {
        const Sim *const each = sim_chain(s, k);
        const SceneDef *const def = &each->stage.scene.def;
        const Stray *const stray = &each->stray;
        const int pulled = def->winch.present || def->n_conveyors > 0;
        if (def->keep_going || def->rod.present || !pulled || def->analysis.kind != ANALYSIS_DYNAMICS) continue;
        if (def->solver.relax && each->passing.edge.share > 1 && !(each->stage.t > 0))
            return off_roller(&each->passing.edge, err);
        if (!(stray->farthest > SUPPORT_OFF_ROUTE)) continue;
        char when[48] = "before anything moves";
        if (each->stage.t > 0) snprintf(when, sizeof when, "at %.4g s", each->stage.t);
        return error_set(
            err, HAWSER_ERR_RUN,
            "%s the cable is %.3g m off its route near %.4g m: it has come off what carries it, or nothing "
            "guides it there: put guides or wider rollers there and ahead of it; 'run.keep_going: true' goes "
            "on all the same",
            when, stray->farthest, stray->at);
    }
    return HAWSER_OK;
}

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

/* Creates the simulations of the chains beside this one, in the order of the case, and what moves them all. */
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
        if (s->together) return status; /* they belong to it now */
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
    segment_mesh_free(&s->mesh);
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

/* Updates the overlap by the kinematics in the workspaces. */
static void overlap_watch(Sim *s)
{
    const Scene *const alone = &s->stage.scene;
    if (s->together) {
        together_overlap(s->together, &s->passing.overlap, s->stage.t);
    } else {
        overlap_record(&s->passing.overlap, SELF_ALONE(&alone->chain, &s->stage.ws.kin), &alone, s->stage.t);
    }
}

/* Positions in place of time steps: each is found independently of those before. */
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

/* Next time at which the integrator must stop: where an equipment kind is not smooth, at a row of a script, or at
 * `stop`. */
static double next_stop(Sim *s, double stop)
{
    for (int k = 0; k < sim_chains(s); ++k) {
        const Sim *const each = sim_chain(s, k);
        stop = fmin(scene_next_stop(&each->stage.scene, each->stage.t, stop), script_next(each));
    }
    return stop;
}

/* Place of the cable's front, m along the route; NAN if it is not simulated, or in the plane. Updates the kinematics of
 * its segment but not the ghosts. */
static double front_at(Stage *st)
{
    const Scene *const scene = &st->scene;
    const int eye = scene->eye - scene->first, last = eye > 0 ? eye - 1 : 0, n = scene->chain.n;
    if (st->motion != &st->spatial.motion || eye < 0 || eye > n) return NAN;
    const int from = last / LANES * LANES, to = from + LANES < n ? from + LANES : n;
    body_kernels()->kinematics(n, st->y, from, to, &st->ws.kin);
    return along_eye(scene, &st->ws.kin, winch_motion(scene->winch, &scene->chain, &st->ws.kin, st->t).travel);
}

/* Handles the events of a step, with the winch's pull at that time. */
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

/* Between two rows a joint may make a full turn: rods are checked after every step. */
static void rod_watch(Sim *s)
{
    Stage *const st = &s->stage;
    dynamics_kinematics(&st->scene, &st->ws, st->t, st->y);
    st->stability.turned |= turned(&st->scene, 0, &st->ws.kin) & TURNED_JOINT;
}

/* Chains share the first one's integrator: the fastest oscillation bounds its steps (EB25). */
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

/* Peaks between two rows are peaks of the run too (EB14). */
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
    peaks_record(&s->peaks, &st->scene, &st->ws, &held);
}

/* The chain with the fastest point. */
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

/* The chain that has this scene. */
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

/* Keeps the window with the shortest steps. */
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

/* Adds the cause of short steps before a failed one to its message. */
static void failure_explain(Sim *s, hawser_error *err)
{
    hawser_hold hold;
    if (!err || !s->stage.integrator || s->stall.left == 0) return;
    sim_held_up(s, &s->stall.from, &hold);
    const size_t used = strlen(err->message);
    snprintf(err->message + used, sizeof err->message - used, "; before it %s", hold.says);
}

/* Finds the modes about the final equilibrium. */
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

/* Records and events after a step, or before the first. */
static hawser_status step_watch(Sim *s, hawser_error *err)
{
    hawser_status status = events_watch(s, err);
    if (!status) peak_watch(s);
    if (!status && s->stage.scene.rod->present) rod_watch(s);
    return status ? status : script_due(s, err);
}

/* Peaks of the loads of rollers by all chains. The chains' own are raised at the same moments: what all bear at a peak
 * is otherwise more than the sum of the recorded peaks, by as much as each may grow before another look is made. */
static void chains_watch(struct Together *all)
{
    if (!together_stepped(all)) return;
    for (int k = all->n - 1; k >= 0; --k) stats_hold(&all->sim[k]->stats, sim_look(all->sim[k], SAMPLE_ROW));
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

/* Moves on by positions in steady motion; each of them counts for the records. A caller that goes step by step gets a
 * step of rows, because positions may be farther apart. */
static hawser_status advance_still(Sim *s, double t, int one_step, hawser_error *err)
{
    const double interval = s->stage.scene.def.output.interval;
    int arrived;
    if (one_step && interval > 0) t = fmin(t, s->stage.t + interval);
    hawser_status status = quasi_move(s, t, &arrived, err);
    if (status || !arrived) return status;
    s->stats.step_t = s->stage.t; /* records by steps begin again from here */
    sim_record_row(s);
    return events_watch(s, err);
}

/* Without memory parts may be half renewed: nothing of them is read from then on. */
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
        if (winch->held == HELD_FIRST) winch->held = 0; /* releases the brake that held a winch of set tension */
        status = script_due(each, err);                 /* rows of the script at the very beginning */
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

/* Reports once that the run has left the range of its model. */
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
    peaks_record(&s->peaks, &s->stage.scene, &s->stage.ws, look);
    if (s->envelope.present) envelope_record(&s->envelope, &s->stage.scene, &s->stage.ws.kin, look);
    s->record_s += clock_now() - start;
}

/* Records the first chain last, because its look covers all of them. */
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

/* Everything that a simulation saves, in one list. Records are listed here, so that they can be read in one go; the
 * data of the steps is saved by its owners (stage_checkpoint). */

/* The part of a table's row that is neither a name nor known from the case. */
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
    const size_t layers = p->clear.near ? (size_t)p->clear.of->mesh.n_layers : 0;
    CHECKPOINT(c, p->clear.bound);
    checkpoint_put(c, "p->clear.near", p->clear.near, layers * sizeof *p->clear.near);
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
    checkpoint_put(c, "p->gone", p->gone, (rollers + surfaces + 1) * sizeof *p->gone);
    checkpoint_put(c, "p->seen", p->seen, surfaces * SURFACE_FACES_MAX * (size_t)scene->total * sizeof *p->seen);
    if (p->last) checkpoint_put(c, "p->last", p->last, (size_t)scene->total * sizeof *p->last);
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

/* It exists if it was requested. */
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

/* Results of a finished analysis. */
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

/* Changes by commands, and the states of winch, jams and conveyors: in bytes of their own (sim/run/commands.h). */
static hawser_status controls_checkpoint(Checkpoint *c, Sim *s, hawser_error *err)
{
    const int reel = s->stage.scene.reel->present; /* the stage checks it itself */
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

/* Call-backs set by the caller act on the state that was read, even if it is older than them. */
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

/* Records of one chain. */
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
    s->stage.motion->ops->lin_stats(s->stage.motion, &s->lin); /* the present solver is not the one chosen at the
                                                                * beginning */
    return calls_go_on(s, err);
}

/* Hash of the chain as the case makes it, and of the initial state: the case's files, the catalogue and this program's
 * defaults determine the simulation as much as the case's text. */
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
    for (int k = 0; k < 6; ++k) { /* springs have no damping while positions move the run */
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

/* For several chains, also their places and joints, which are in their states and in the case's text. */
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
