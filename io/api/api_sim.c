/* Calls of a simulation that check arguments or keep their outcome; the others are in sim/run/sim.c. */
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"
#include "core/file.h"
#include "core/machine.h"
#include "core/team.h"
#include "def/cost.h"
#include "io/api/api_handles.h"
#include "io/results/results_file.h"
#include "sim/equipment/forces.h"
#include "sim/equipment/rod.h"
#include "sim/run/commands.h"
#include "theory/closed_form.h"
#include "theory/plan.h"

/* Keeps the definition for a second pass, where there may be one: for a pull in time. Returns 0 without memory. */
static int plan_keep(hawser_sim *s, const SceneDef *def)
{
    const int pulled = def->winch.present && !def->rod.present && def->analysis.kind == ANALYSIS_DYNAMICS;
    if (!pulled || def->n_beside > 0 || def->solver.passes == PASSES_ONE) return 1;
    s->plan = calloc(1, sizeof *s->plan);
    if (s->plan && !scene_def_copy(def, s->plan, NULL)) return 1;
    free(s->plan);
    s->plan = NULL;
    return 0;
}

/* Sets the title of the results; for a chain among several it includes its own name. Returns 0 without memory. */
static int name_give(hawser_sim *s, const hawser_case *c)
{
    const StrandDef *const strand = &s->stage.scene.def.strand;
    const char *const title = c->def->title[0] ? c->def->title : c->name;
    const size_t room = strlen(title) + sizeof strand->name + 3;
    s->case_name = strdup(c->name);
    s->title = malloc(room);
    if (s->title) snprintf(s->title, room, strand->present ? "%s: %s" : "%s", title, strand->name);
    return s->case_name && s->title;
}

/* Checks the options like a case: they come from a program or a command line. */
hawser_status hawser_sim_new_sized(hawser_case *c, const hawser_options *options, size_t size, hawser_sim **out,
                                   hawser_error *err)
{
    if (!c || !out) return error_argument(err, c ? "out" : "c");
    *out = NULL;
    hawser_options mine = {0};
    if (options) memcpy(&mine, options, size < sizeof mine ? size : sizeof mine);
    const int threads = mine.threads;
    if (threads < 0 || threads > 2) {
        return error_set(err, HAWSER_ERR_INPUT, "%d threads: 1 or 2 can be used (0: the case's choice)", threads);
    }
    hawser_status status = case_ensure_read(c, err);
    if (status) return status;
    if (c->def->duration_open) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "%.200s: key 'run.duration': missing: required without a winch that sets a speed", c->name);
    }
    status = cost_check(c->def, err);
    if (!status) status = sim_new(c->def, threads, out, err);
    if (status) return case_name_error(c, status, err);
    hawser_sim *const s = *out; /* the case may be freed soon */
    if (s->team) team_pin(s->team, mine.pin);
    int named = 1;
    for (int k = 0; k < sim_chains(s); ++k) named &= name_give(sim_chain(s, k), c);
    s->case_folder = c->tree->folder ? realpath(c->tree->folder, NULL) : NULL;
    if (!s->case_folder && c->tree->folder) s->case_folder = strdup(c->tree->folder);
    status = named && plan_keep(s, c->def) ? case_node_text(c->tree->root, &s->case_text, err) : error_memory(err);
    if (status) *out = sim_free(s);
    return status;
}

void hawser_sim_free(hawser_sim *s)
{
    if (s && (is_inside(s) || s->running)) return;
    sim_free(s);
}

/* Keeps the outcome of a computing call, for the summary. */
static hawser_status keep_outcome(hawser_sim *s, hawser_status status, const hawser_error *err)
{
    s->outcome = status;
    if (status) memcpy(s->message, err->message, sizeof s->message);
    return status;
}

hawser_status error_inside(hawser_error *err)
{
    return error_set(err, HAWSER_ERR_INPUT,
                     "a call-back of the simulation may read it and give commands, but not advance it");
}

int is_inside(const hawser_sim *s) { return s->inside || (s->leader && s->leader->inside); }

hawser_status error_led(hawser_error *err)
{
    return error_set(err, HAWSER_ERR_INPUT,
                     "this is one of several chains, which move together: the simulation they belong to moves them");
}

int hawser_sim_chains(const hawser_sim *s)
{
    s = SHOWN(s);
    return s ? sim_chains(s) : 0;
}

hawser_sim *hawser_sim_chain(hawser_sim *s, int k)
{
    s = SHOWN(s);
    return s && k >= 0 && k < sim_chains(s) ? sim_chain(s, k) : NULL;
}

const char *hawser_sim_chain_name(const hawser_sim *s) { return s ? SHOWN(s)->stage.scene.def.strand.name : ""; }

/* Relaxes before statistics and integrator start; later they own the state. */
hawser_status hawser_sim_relax(hawser_sim *s, hawser_relaxation *out, hawser_error *err)
{
    hawser_error local;
    hawser_error *e = err ? err : &local;
    s = SHOWN(s);
    if (!s) return error_argument(err, "s");
    if (is_inside(s)) return error_inside(err);
    if (s->leader) return error_led(err);
    if (hawser_sim_time(s) > 0) {
        return error_set(e, HAWSER_ERR_INPUT, "only a simulation that has not moved on from t = 0 can be relaxed");
    }
    s->relaxed = s->inside = 1;
    team_settle(s->team);
    const hawser_status status = sim_blame_law(s, sim_relax(s, out, e), e);
    s->inside = 0;
    return keep_outcome(s, status, e);
}

static const double TIME_MOST = 1e9; /* s */

/* Never steps over the corners of the drive, whatever t is. */
hawser_status hawser_sim_advance(hawser_sim *s, double t, int one_step, hawser_error *err)
{
    hawser_error local;
    hawser_error *e = err ? err : &local;
    s = SHOWN(s);
    if (!s) return error_argument(err, "s");
    if (is_inside(s) || s->running) return error_inside(err);
    if (s->leader) return error_led(err);
    if (!(t < INFINITY) || t > TIME_MOST)
        return error_set(e, HAWSER_ERR_INPUT, "advance to t = %g s: a time of at most %g s is expected", t, TIME_MOST);
    s->inside = 1;
    team_settle(s->team);
    const hawser_status status = sim_blame_law(s, sim_advance(s, t, one_step, e), e);
    s->inside = 0;
    if (status && status != HAWSER_STOPPED) sim_log(s, HAWSER_LOG_ERROR, e->message);
    return keep_outcome(s, status, e);
}

/* Returns one word for the summary. */
static const char *outcome_name(const hawser_sim *s)
{
    if (s->running) return "running";
    if (s->outcome == HAWSER_STOPPED) return "stopped";
    if (s->outcome) return "failed";
    if (hawser_sim_time(s) < hawser_sim_end_time(s)) return "unfinished";
    return hawser_sim_end_time(s) < s->stage.scene.def.duration ? "tripped" : "finished";
}

int hawser_sim_assumptions(const hawser_sim *s, const hawser_assumption **out)
{
    s = SHOWN(s);
    if (!s || !out) return 0;
    *out = s->stage.scene.def.assumptions;
    return s->stage.scene.def.n_assumptions;
}

/* Finds remedies for the broken limits, each sentence once. Returns how many. */
static int remedies_find(const hawser_sim *s, int n, const hawser_limit *limit, Remedy remedy[])
{
    const Setup *const setup = &s->stage.scene.setup;
    Mend mend;
    const int together = mend_run(s, n, limit, &mend);
    int found = together ? mend_parts(setup, &mend, remedy) : 0;
    for (int i = 0; i < found; i++) remedy_say(&remedy[i], HAWSER_SI, remedy[i].text);
    for (int i = 0; i < n; i++) {
        Remedy *const r = &remedy[found];
        if (!limit[i].judged || limit[i].ok || (together && !(mend.beside & 1U << limit[i].kind))) continue;
        if (!remedy_find(setup, &limit[i], r)) continue;
        remedy_say(r, HAWSER_SI, r->text);
        int fresh = 1;
        for (int k = 0; k < found; k++) fresh &= strcmp(remedy[k].text, r->text) != 0;
        found += fresh;
    }
    return found;
}

hawser_status sim_summary_text(const hawser_sim *s, const OutDir *dir, char **text, hawser_error *err)
{
    FileSum file[FILE_SUMS_MAX];
    char run[SUM_SIZE];
    int n_files = 0;
    *text = NULL;
    const hawser_status summed = dir ? out_own(folder_sums(dir, &n_files, file, err), err) : HAWSER_OK;
    if (summed) return summed;
    run_identity(s, run);
    const Scene *const scene = &s->stage.scene;
    const LimitsDef *const limits = &scene->def.limits;
    hawser_summary summary;
    hawser_limit limit[HAWSER_LIMITS_MAX];
    Overload *overload;
    hawser_sim_summary(s, &summary);
    PeaksTheory theory;
    hawser_status status = peaks_theory(&s->peaks, &s->stats, scene, &s->expected, &theory, err);
    if (status) return status;
    SummaryLabels labels = {
        .title = s->title,
        .case_name = s->case_name,
        .run = run,
        .n_files = n_files,
        .file = file,
        .outcome = outcome_name(s),
        .message = s->outcome ? s->message : "",
        .n_surfaces = s->stats.n_surfaces,
        .surface = s->stats.surface_out,
        .n_rollers = s->stats.n_rollers,
        .roller = s->stats.roller_out,
        .n_assumptions = scene->def.n_assumptions,
        .assumption = scene->def.assumptions,
        .n_limits = sim_limits(s, &summary, 1, limit),
        .limit = limit,
        .n_overloads = peaks_overload(&s->peaks, scene, &theory, &overload),
        .trip_N = limits->present ? limits_trip(limits, bundle_pulled(&scene->def), theory.needed, theory.beyond).force
                                  : NAN};
    peaks_theory_free(&theory);
    if (labels.n_overloads < 0) return error_memory(err);
    Remedy remedy[MEND_PARTS_MAX + HAWSER_LIMITS_MAX];
    Assumed assumed[ASSUMED_KINDS];
    labels.overload = overload;
    labels.n_remedies = remedies_find(s, labels.n_limits, limit, remedy);
    labels.remedy = remedy;
    labels.n_assumed = labels.n_limits > 0 ? assumed_list(&scene->setup, assumed) : 0;
    labels.assumed = assumed;
    Calculator calculator = {0};
    PieceLine *piece = NULL;
    if (dir) status = run_pieces(s, &calculator, &piece, &labels.n_pieces, err);
    labels.piece = piece;
    if (!status) status = summary_json(&summary, &labels, text, err);
    calculator_free(&calculator);
    free(piece);
    free(overload);
    return status;
}

hawser_status hawser_sim_summary_json(const hawser_sim *s, char **text, hawser_error *err)
{
    s = SHOWN(s);
    if (!s || !text) return error_argument(err, s ? "text" : "s");
    return sim_summary_text(s, NULL, text, err);
}

/* Theory along the route, for route.csv: the reference of the pull at every place. The route full of cable is pulled
 * both ways, as `hawser theory` does; the run's own reference is only known where its cable is. */

enum { ROWS_LEAST = 50, ROWS_MOST = 1000 };

/* Distance of two rows where the number allows it, m. */
static const double row_step = 0.25;

/* The pulls that the rows are read from; zeroed ones are missing. */
typedef struct Along {
    Calculator calculator;
    Pull paper, run;
    int solved, with_paper, with_run;
} Along;

/* Leaves the columns of a failed theory empty: the run reports problems in its own way. Errors: MEMORY. */
static hawser_status along_solve(const hawser_sim *s, Along *a, hawser_error *err)
{
    const Setup *const setup = &s->stage.scene.setup;
    const PlanPullDef whole = {.way = PLAN_FORWARD, .whole = 1};
    hawser_error quiet = {HAWSER_OK, ""};
    hawser_status status = calculator_build(setup, &s->expected, 0, &a->calculator, &quiet);
    a->solved = !status;
    if (!status) {
        PlanDef plan = a->calculator.def;
        plan.law = PULL_NO_CAPSTAN;
        status = plan_pull(&plan, &whole, &a->paper, &quiet);
        a->with_paper = !status;
    }
    if (status != HAWSER_ERR_MEMORY) {
        status = expected_pull(setup, &s->expected, PULL_REFERENCE, &a->run, &quiet);
        a->with_run = !status;
    }
    return status == HAWSER_ERR_MEMORY ? error_memory(err) : HAWSER_OK;
}

static void along_clear(Along *a)
{
    if (a->with_paper) pull_clear(&a->paper);
    if (a->with_run) pull_clear(&a->run);
    calculator_free(&a->calculator);
}

/* Returns the paper's tension: by its own formulas if the case lists them. */
static double paper_at(const Scene *scene, const Along *a, double s)
{
    const SceneDef *const def = &scene->def;
    const double g = v3_norm(def->gravity), mass = g > 0 ? scene->setup.cable_weight / g : 0;
    if (def->n_paper > 0) return paper_tension(def->n_paper, def->paper, mass, def->friction.mu_d, g, s);
    return a->with_paper ? pull_at(&a->paper, s).tension : NAN;
}

static AlongRow row_at(const hawser_sim *sim, const Along *a, double s)
{
    const Scene *const scene = &sim->stage.scene;
    const Expected *const e = &sim->expected;
    const RoutePoint at = route_at(&scene->route, s);
    AlongRow row = {.s = s,
                    .place = {at.position.x, at.position.y, at.position.z},
                    .curvature = v3_norm(at.curvature),
                    .forward = NAN,
                    .backward = NAN,
                    .paper = paper_at(scene, a, s),
                    .run = NAN,
                    .sidewall = NAN,
                    .sidewall_back = NAN};
    if (a->solved) {
        const PullPoint there = pull_at(&a->calculator.plan.way[PLAN_FORWARD].pull, s);
        const PullPoint back = pull_at(&a->calculator.plan.way[PLAN_BACKWARD].pull, s);
        row.forward = there.tension;
        row.backward = back.tension;
        row.sidewall = there.sidewall;
        row.sidewall_back = back.sidewall;
    }
    if (a->with_run && s >= e->from && s <= e->to) row.run = pull_at(&a->run, s).tension;
    return row;
}

/* Fills even steps, and both sides of every joint of two pieces: tension has a corner there, and sidewall pressure a
 * jump. */
static void rows_fill(const hawser_sim *sim, const Along *a, int steps, AlongRow *rows, int *n)
{
    const Route *const route = &sim->stage.scene.route;
    const double step = route->length / steps, beside = 1e-6 * route->length;
    int piece = 1;
    for (int i = 0; i <= steps; i++) {
        for (; piece < route->n && route->piece[piece].s0 < step * i; piece++) {
            rows[(*n)++] = row_at(sim, a, route->piece[piece].s0 - beside);
            rows[(*n)++] = row_at(sim, a, route->piece[piece].s0 + beside);
        }
        rows[(*n)++] = row_at(sim, a, step * i);
    }
}

hawser_status along_rows(hawser_sim *s, AlongRow **rows, int *n, hawser_error *err)
{
    const Route *const route = &s->stage.scene.route;
    const double wanted = ceil(route->length / row_step);
    const int steps = (int)fmin(ROWS_MOST, fmax(ROWS_LEAST, wanted));
    Along a = {0};
    *rows = NULL;
    *n = 0;
    if (s->stage.scene.def.rod.present || !(route->length > 0)) return HAWSER_OK;
    AlongRow *const all = malloc(sizeof *all * (size_t)(steps + 1 + 2 * route->n));
    hawser_status status = all ? along_solve(s, &a, err) : error_memory(err);
    if (!status) rows_fill(s, &a, steps, all, n);
    along_clear(&a);
    if (status) free(all);
    if (!status) *rows = all;
    return status;
}

enum { PIECES_MOST = 2000 };

hawser_status run_pieces(const hawser_sim *s, Calculator *c, PieceLine **rows, int *n, hawser_error *err)
{
    const Setup *const setup = &s->stage.scene.setup;
    hawser_error quiet = {HAWSER_OK, ""};
    *c = (Calculator){0};
    *rows = NULL;
    *n = 0;
    if (s->stage.scene.def.rod.present || s->stage.scene.route.n > PIECES_MOST) return HAWSER_OK;
    hawser_status status = calculator_build(setup, &s->expected, 0, c, &quiet);
    if (!status) status = piece_lines(c, rows, n, &quiet);
    return status == HAWSER_ERR_MEMORY ? error_memory(err) : HAWSER_OK;
}

/* Detailed tables of a simulation, on request. */

hawser_status hawser_sim_contacts(hawser_sim *s, const hawser_contact **out, int *n, hawser_error *err)
{
    s = SHOWN(s);
    if (!s || !out || !n) return error_argument(err, !s ? "s" : !out ? "out" : "n");
    const hawser_sample *const look = hawser_sim_sample(s);
    const hawser_status status = closeup_contacts(&s->closeup, &s->stage.scene, &s->stage.ws, look->t, err);
    *out = s->closeup.contact;
    *n = status ? 0 : s->closeup.n_contacts;
    return status;
}

hawser_status hawser_sim_cable(hawser_sim *s, const hawser_cable_point **out, int *n, int *first, hawser_error *err)
{
    s = SHOWN(s);
    if (!s || !out || !n) return error_argument(err, !s ? "s" : !out ? "out" : "n");
    const hawser_sample *const look = hawser_sim_sample(s);
    const hawser_status status = closeup_cable(&s->closeup, &s->stage.scene, &s->stage.ws, look, err);
    *out = s->closeup.joint;
    *n = status ? 0 : s->stage.scene.chain.n + 1;
    if (first) *first = s->stage.scene.first;
    return status;
}

hawser_status hawser_sim_watch_envelope(hawser_sim *s, hawser_error *err)
{
    s = SHOWN(s);
    if (!s) return error_argument(err, "s");
    envelope_free(&s->envelope);
    return envelope_new(&s->envelope, &s->stage.scene, err);
}

static hawser_extremes extremes_of(const Extremes *from)
{
    return (hawser_extremes){from->least, from->mean, from->largest};
}

hawser_status hawser_sim_envelope(const hawser_sim *s, int along_route, hawser_envelope *out, hawser_error *err)
{
    s = SHOWN(s);
    if (!s || !out) return error_argument(err, s ? "out" : "s");
    if (!s->envelope.present)
        return error_set(err, HAWSER_ERR_INPUT, "no envelope is kept: hawser_sim_watch_envelope begins one");
    const EnvelopeLine *const line = along_route ? &s->envelope.place : &s->envelope.arc;
    *out = (hawser_envelope){.n = line->n,
                             .at_m = line->s,
                             .time_s = line->time,
                             .tension_N = extremes_of(&line->tension),
                             .curvature_per_m = extremes_of(&line->curvature),
                             .sidewall_N_per_m = extremes_of(&line->sidewall)};
    return HAWSER_OK;
}

hawser_status hawser_sim_geometry(hawser_sim *s, const hawser_geometry **out, hawser_error *err)
{
    s = SHOWN(s);
    if (!s || !out) return error_argument(err, s ? "out" : "s");
    if (!s->around) s->around = around_new(&s->stage.scene, err);
    *out = s->around ? &s->around->shown : NULL;
    return s->around ? HAWSER_OK : HAWSER_ERR_MEMORY;
}

/* Checks that there is a route. Errors: INPUT. */
static hawser_status route_there(const hawser_sim *s, const void *out, hawser_error *err)
{
    if (!s || !out) return error_argument(err, s ? "out" : "s");
    return s->stage.scene.rod->present ? error_set(err, HAWSER_ERR_INPUT, "a rod has no route") : HAWSER_OK;
}

hawser_status hawser_sim_route_length(const hawser_sim *s, double *length_m, hawser_error *err)
{
    s = SHOWN(s);
    const hawser_status status = route_there(s, length_m, err);
    if (!status) *length_m = s->stage.scene.route.length;
    return status;
}

hawser_status hawser_sim_route_at(const hawser_sim *s, double s_m, hawser_route_place *out, hawser_error *err)
{
    s = SHOWN(s);
    const hawser_status status = route_there(s, out, err);
    if (status) return status;
    if (!isfinite(s_m)) return error_set(err, HAWSER_ERR_INPUT, "a place of %g m along the route", s_m);
    const RoutePoint at = route_at(&s->stage.scene.route, s_m);
    v3_put(out->position_m, at.position);
    v3_put(out->tangent, at.tangent);
    v3_put(out->curvature_per_m, at.curvature);
    return HAWSER_OK;
}

/* Commands and call-backs, with checks for errors that only a program can make. */

/* Returns the usual ramp for 0. */
static double ramp_of(double ramp_s) { return ramp_s >= 0 && ramp_s <= 0 ? COMMAND_RAMP_USUAL : ramp_s; }

hawser_status hawser_sim_control(hawser_sim *s, hawser_control what_to_do, const char *what, double value,
                                 double ramp_s, hawser_error *err)
{
    const CommandKind *const kind = command_kind((int)what_to_do);
    s = SHOWN(s);
    if (!s) return error_argument(err, "s");
    if (sim_in_law(s)) return error_inside(err);
    if (!kind || kind->kind == COMMAND_FORCE)
        return error_set(err, HAWSER_ERR_INPUT, "%d is no command", (int)what_to_do);
    Command command = {.kind = kind->kind, .value = kind->unit ? value : 0, .ramp = ramp_of(ramp_s)};
    if (kind->named == 1 && !what) return error_argument(err, "what");
    if (kind->named && what) {
        if (strlen(what) >= sizeof command.what)
            return error_set(err, HAWSER_ERR_INPUT, "%s: no name is as long as '%.32s...'", kind->says, what);
        snprintf(command.what, sizeof command.what, "%s", what);
    }
    s->led = 1;
    return sim_command(s, &command, err);
}

hawser_status hawser_sim_force(hawser_sim *s, int segment, const hawser_force *force, double ramp_s, hawser_error *err)
{
    s = SHOWN(s);
    if (!s) return error_argument(err, "s");
    if (sim_in_law(s)) return error_inside(err);
    Command command = {.kind = COMMAND_FORCE, .segment = segment, .ramp = ramp_of(ramp_s)};
    if (force) {
        command.follows = force->follows != 0;
        command.force = v3(force->force_N[0], force->force_N[1], force->force_N[2]);
        command.moment = v3(force->moment_N_m[0], force->moment_N_m[1], force->moment_N_m[2]);
        command.arm = v3(force->arm_m[0], force->arm_m[1], force->arm_m[2]);
    }
    s->led = 1;
    return sim_command(s, &command, err);
}

hawser_status hawser_sim_set_law(hawser_sim *s, int from, int to, hawser_law law, int has_derivatives, void *user,
                                 hawser_error *err)
{
    s = SHOWN(s);
    if (!s) return error_argument(err, "s");
    if (sim_in_law(s)) return error_inside(err);
    const OutsideLaw outside = {.call = law, .user = user, .from = from, .to = to, .has_derivatives = has_derivatives};
    Stage *const st = &s->stage;
    hawser_status status = outside_law_set(&st->scene, &outside, err);
    if (!status && law) status = stage_to_space(st, "a law of force acts on segments", err);
    if (status) return status;
    s->led = 1;
    s->calls.law = law != NULL;
    return sim_note(s, HAWSER_EVENT_LAW, st->t, law ? "a law of force is set" : "the law of force is taken away",
                    s->look.sample.winch_force, err);
}

void hawser_sim_on_step(hawser_sim *s, hawser_step_function function, void *user)
{
    s = SHOWN(s);
    if (!s) return;
    s->led |= function != NULL;
    s->calls.step = function;
    s->calls.step_user = user;
}

void hawser_sim_on_event(hawser_sim *s, hawser_event_function function, void *user)
{
    s = SHOWN(s);
    if (!s) return;
    s->led |= function != NULL;
    s->calls.event = function;
    s->calls.event_user = user;
}

void hawser_sim_on_log(hawser_sim *s, hawser_log_level level, hawser_log_function function, void *user)
{
    s = SHOWN(s);
    if (!s) return;
    s->calls.log = function;
    s->calls.log_user = user;
    s->calls.log_level = level;
}

/* Checkpoints as files and as memory: the state of a simulation with the data that identify it. A file has a head of
 * fixed size (format, length, hash) and a row of pieces: the program's version and kernels, the case, and values
 * derived from it, all of which are compared before anything is read; then, for a run with results, their progress;
 * then the simulation. */

enum { FORMAT = 10 };

typedef struct FileHead {
    char magic[16];
    uint64_t format, size, hash; /* size, hash: of the bytes behind the head */
} FileHead;

static const char magic[16] = "hawser restart\n";

/* ------------------------------------------------------------------------------------------------- identity */

/* Computes the identity of the case, key by key, as it is read: values and units. The interval of checkpoints is left
 * out. */
static uint64_t inputs_identity(const SceneDef *def)
{
    uint64_t all = 0;
    const char *text = def->inputs;
    for (int i = 0; i < def->n_inputs; i++) {
        int counts = 1;
        for (int k = 0; k < INPUT_TEXTS; k++, text += strlen(text) + 1) {
            if (k == INPUT_KEY) counts = strcmp(text, "run.checkpoint") != 0;
            if (!counts || (k != INPUT_KEY && k != INPUT_VALUE && k != INPUT_UNIT)) continue;
            const uint64_t both[2] = {all, checkpoint_hash(text, strlen(text))};
            all = checkpoint_hash(both, sizeof both);
        }
    }
    return all;
}

/* The first pieces. */
typedef struct Preface {
    const char *version, *kernels; /* of the program, of the machine */
    uint64_t inputs, scene;        /* hashes of the case as read, and of the scene built from it */
    const char *name, *folder;     /* name and folder of the case; NULL: it has no folder */
    const char *text;              /* the case */
} Preface;

static Preface preface_of(const hawser_sim *s)
{
    return (Preface){.version = hawser_version(),
                     .kernels = isa_name(isa_best()),
                     .inputs = inputs_identity(&s->stage.scene.def),
                     .scene = sim_identity(s),
                     .name = s->case_name,
                     .folder = s->case_folder,
                     .text = s->case_text};
}

void run_identity(const hawser_sim *s, char run[SUM_SIZE])
{
    const Preface p = preface_of(s);
    const uint64_t all[] = {p.inputs, p.scene, checkpoint_hash(p.version, strlen(p.version)),
                            checkpoint_hash(p.kernels, strlen(p.kernels))};
    sum_text(run, checkpoint_hash(all, sizeof all));
}

static void preface_checkpoint(Checkpoint *c, Preface *p)
{
    checkpoint_text(c, "version", &p->version);
    checkpoint_text(c, "kernels", &p->kernels);
    CHECKPOINT(c, p->inputs);
    CHECKPOINT(c, p->scene);
    checkpoint_text(c, "name", &p->name);
    checkpoint_text(c, "folder", &p->folder);
    checkpoint_text(c, "text", &p->text);
}

static int differ(const char *a, const char *b) { return strcmp(a ? a : "", b ? b : "") != 0; }

/* Compares the file's with that of the simulation that is to continue from it. */
static hawser_status preface_compare(const Preface *file, const Preface *mine, const char *path, hawser_error *err)
{
    if (differ(file->version, mine->version)) {
        return error_set(err, HAWSER_ERR_INPUT, "'%.500s' is a checkpoint of hawser %.40s; this is %.40s", path,
                         file->version ? file->version : "?", mine->version);
    }
    if (differ(file->kernels, mine->kernels)) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "'%.500s' was computed with the instruction set %.20s, this machine uses %.20s: the run would "
                         "not continue bit for bit; set HAWSER_ISA=%.20s where the machine has it",
                         path, file->kernels ? file->kernels : "?", mine->kernels, file->kernels ? file->kernels : "?");
    }
    if (file->inputs != mine->inputs || file->scene != mine->scene) {
        return error_set(
            err, HAWSER_ERR_INPUT,
            "'%.500s' is a checkpoint of another case, or of '%.200s' with other settings or files than now", path,
            file->name ? file->name : "?");
    }
    return HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------------------ bytes */

static hawser_status fault(const Checkpoint *c, const char *path, hawser_error *err)
{
    if (c->status == HAWSER_ERR_MEMORY) return error_memory(err);
    return error_set(err, HAWSER_ERR_INPUT, "'%.500s' cannot be read as a checkpoint: %s", path, c->fault);
}

/* Writes all pieces, behind the head. */
static hawser_status pieces_write(hawser_sim *s, RunKept *run, Checkpoint *c, hawser_error *err)
{
    FileHead head = {.format = FORMAT};
    Preface preface = preface_of(s);
    int kept = run != NULL;
    memcpy(head.magic, magic, sizeof magic);
    checkpoint_put(c, "head", &head, sizeof head);
    preface_checkpoint(c, &preface);
    CHECKPOINT(c, kept);
    if (kept) CHECKPOINT(c, *run);
    const hawser_status status = sim_checkpoint(c, s, err);
    if (!status && c->status) return c->status == HAWSER_ERR_MEMORY ? error_memory(err) : fault(c, "it", err);
    return status;
}

/* Counts first, so that memory is allocated once. */
hawser_status checkpoint_write(hawser_sim *s, RunKept *run, Checkpoint *c, hawser_error *err)
{
    FileHead head;
    const size_t head_end = 2 * sizeof(uint64_t) + sizeof head; /* a piece has a head of its own */
    if (s->positions.n > 0)
        return error_set(err, HAWSER_ERR_RUN, "positions are not kept: each is found anew in a fraction of a second");
    *c = checkpoint_new(0);
    hawser_status status = pieces_write(s, run, c, err);
    if (status) return status;
    *c = checkpoint_new(c->size);
    status = pieces_write(s, run, c, err);
    if (status) return status;
    memcpy(&head, c->bytes + head_end - sizeof head, sizeof head);
    head.size = c->size - head_end;
    head.hash = checkpoint_hash(c->bytes + head_end, head.size);
    memcpy(c->bytes + head_end - sizeof head, &head, sizeof head);
    return HAWSER_OK;
}

/* Checks that the bytes are undamaged; c is then behind the head. */
static hawser_status head_check(Checkpoint *c, const char *path, hawser_error *err)
{
    FileHead head = {0};
    checkpoint_put(c, "head", &head, sizeof head);
    if (c->status || memcmp(head.magic, magic, sizeof magic) != 0)
        return error_set(err, HAWSER_ERR_INPUT, "'%.500s' is not a checkpoint of hawser", path);
    if (head.format != FORMAT) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "'%.500s' is a checkpoint of another version of hawser: format %llu, here %d", path,
                         (unsigned long long)head.format, FORMAT);
    }
    if (head.size != c->size - c->at || head.hash != checkpoint_hash(c->bytes + c->at, c->size - c->at))
        return error_set(err, HAWSER_ERR_INPUT, "the checkpoint '%.500s' is damaged or cut off", path);
    return HAWSER_OK;
}

/* Reads up to the simulation. */
static hawser_status preface_read(Checkpoint *c, const char *path, Preface *preface, int *kept, RunKept *run,
                                  hawser_error *err)
{
    const hawser_status status = head_check(c, path, err);
    if (status) return status;
    preface_checkpoint(c, preface);
    checkpoint_put(c, "kept", kept, sizeof *kept);
    if (*kept && !c->status) checkpoint_put(c, "*run", run, sizeof *run);
    return c->status ? fault(c, path, err) : HAWSER_OK;
}

hawser_status checkpoint_read(hawser_sim *s, const char *path, const void *bytes, size_t size, RunKept *run,
                              hawser_error *err)
{
    TextPool pool = {0};
    Checkpoint c = checkpoint_over(bytes, size, &pool);
    Preface theirs = {0};
    const Preface mine = preface_of(s);
    RunKept unused;
    int kept = 0;
    hawser_status status = preface_read(&c, path, &theirs, &kept, run ? run : &unused, err);
    if (!status) status = preface_compare(&theirs, &mine, path, err);
    if (!status && run && !kept)
        status = error_set(err, HAWSER_ERR_INPUT, "'%.500s' is a checkpoint of a simulation without results", path);
    text_pool_free(&pool);
    if (status) return status;
    c.texts = &pool;
    status = sim_checkpoint(&c, s, err);
    checkpoint_end(&c);
    text_pool_free(&s->texts); /* from an earlier checkpoint */
    s->texts = pool;
    if (status) return status;
    return c.status ? fault(&c, path, err) : HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------------------- files */

/* Reads all of an open file, malloc'ed; fd < 0: errno has the reason. */
static hawser_status file_read(int fd, const char *path, void **bytes, size_t *size, hawser_error *err)
{
    struct stat info;
    int number = fd < 0 ? errno : 0;
    const int ok = fd >= 0 && !fstat(fd, &info);
    *bytes = ok ? checkpoint_memory((size_t)info.st_size) : NULL;
    *size = 0;
    errno = 0;
    const ssize_t n = *bytes ? whole_read(fd, *bytes, (size_t)info.st_size) : -1;
    if (!number) number = errno;
    if (fd >= 0) close(fd);
    if (ok && !*bytes) return error_memory(err);
    if (ok && n == info.st_size) {
        *size = (size_t)n;
        return HAWSER_OK;
    }
    free(*bytes);
    *bytes = NULL;
    return error_set(err, HAWSER_ERR_INPUT, "cannot read the checkpoint '%.700s': %s", path,
                     number ? file_reason(number) : "it has become shorter meanwhile");
}

/* Reads the checkpoint of a folder. */
static hawser_status kept_read(OutSpot *spot, const OutDir *dir, void **bytes, size_t *size, hawser_error *err)
{
    const hawser_status status = out_spot(spot, dir, CHECKPOINT_FILE, err);
    return status ? status : file_read(file_open_in(dir->at, CHECKPOINT_FILE, O_RDONLY), spot->path, bytes, size, err);
}

hawser_status checkpoint_read_dir(hawser_sim *s, const OutDir *dir, RunKept *run, hawser_error *err)
{
    OutSpot spot;
    void *bytes;
    size_t size;
    hawser_status status = kept_read(&spot, dir, &bytes, &size, err);
    if (status) return status;
    status = checkpoint_read(s, spot.path, bytes, size, run, err);
    free(bytes);
    return status;
}

/* Loads a state into a handle: a handle with a finer pass continues from states of that pass; a state of an earlier
 * pass restores that pass, and removes the comparison with others. */
static hawser_status state_read(hawser_sim *handle, const char *path, const void *bytes, size_t size, hawser_error *err)
{
    hawser_sim *s = SHOWN(handle);
    hawser_error first = {.status = HAWSER_OK};
    hawser_status status = checkpoint_read(s, path, bytes, size, NULL, err);
    if (status == HAWSER_ERR_INPUT && s != handle && !checkpoint_read(handle, path, bytes, size, NULL, &first)) {
        handle->finer = sim_free(handle->finer);
        s = handle;
        status = HAWSER_OK;
    }
    if (status || !(hawser_sim_time(s) < hawser_sim_end_time(s))) return status;
    other_passes_free(&s->others);
    free(s->passes);
    s->passes = NULL;
    return HAWSER_OK;
}

hawser_status hawser_sim_save_memory(hawser_sim *s, void **bytes, size_t *size, hawser_error *err)
{
    Checkpoint c;
    s = SHOWN(s);
    if (!s || !bytes || !size) return error_argument(err, !s ? "s" : bytes ? "size" : "bytes");
    if (is_inside(s)) return error_inside(err);
    *bytes = NULL;
    *size = 0;
    const hawser_status status = checkpoint_write(s, NULL, &c, err);
    if (status) {
        checkpoint_free(&c);
        return status;
    }
    *bytes = c.bytes; /* the caller's from now on */
    *size = c.size;
    return HAWSER_OK;
}

hawser_status hawser_sim_load_memory(hawser_sim *s, const void *bytes, size_t size, hawser_error *err)
{
    if (!s || !bytes) return error_argument(err, s ? "bytes" : "s");
    if (is_inside(SHOWN(s)) || SHOWN(s)->running) return error_inside(err);
    team_settle(SHOWN(s)->team);
    return state_read(s, "memory", bytes, size, err);
}

void hawser_bytes_free(void *bytes) { free(bytes); }

/* Writes beside its name, in the same folder. */
hawser_status hawser_sim_save(hawser_sim *s, const char *path, hawser_error *err)
{
    Checkpoint c;
    OutDir dir;
    s = SHOWN(s);
    if (!s || !path) return error_argument(err, s ? "path" : "s");
    if (is_inside(s)) return error_inside(err);
    char *const folder = strdup(path), *const slash = folder ? strrchr(folder, '/') : NULL;
    if (!folder) return error_memory(err);
    if (slash) slash[slash == folder] = 0;
    hawser_status status = file_marks_spare(&s->stage.scene.def.files, path, err);
    if (!status) status = out_enter(&dir, slash ? folder : ".", err);
    free(folder);
    if (status) return status;
    status = checkpoint_write(s, NULL, &c, err);
    if (!status) status = out_bytes_in(&dir, slash ? strrchr(path, '/') + 1 : path, c.bytes, c.size, err);
    checkpoint_free(&c);
    out_leave(&dir);
    return status;
}

hawser_status hawser_sim_load(hawser_sim *s, const char *path, hawser_error *err)
{
    void *bytes;
    size_t size;
    if (!s || !path) return error_argument(err, s ? "path" : "s");
    if (is_inside(SHOWN(s)) || SHOWN(s)->running) return error_inside(err);
    team_settle(SHOWN(s)->team);
    hawser_status status = file_read(file_open_named(path), path, &bytes, &size, err);
    if (status) return status;
    status = state_read(s, path, bytes, size, err);
    free(bytes);
    return status;
}

/* Keeps the path of the case's file, which is there unless it was moved. */
static hawser_status path_keep(CaseTree *tree, const char *name, hawser_error *err)
{
    const char *const slash = strrchr(name, '/');
    const size_t size = strlen(tree->folder) + strlen(name) + 2;
    tree->path = malloc(size);
    if (!tree->path) return error_memory(err);
    snprintf(tree->path, size, "%s/%s", tree->folder, slash ? slash + 1 : name);
    return HAWSER_OK;
}

/* Reads the case in the first pieces. */
hawser_status hawser_case_resume(const char *dir, hawser_case **out, hawser_error *err)
{
    OutDir folder = {.at = -1};
    OutSpot spot = {0};
    TextPool pool = {0};
    Preface preface = {0};
    RunKept run;
    void *bytes = NULL;
    size_t size = 0;
    int kept;
    if (!dir || !out) return error_argument(err, dir ? "out" : "dir");
    *out = NULL;
    hawser_status status = HAWSER_OK;
    if (out_enter(&folder, dir, NULL))
        status = error_set(err, HAWSER_ERR_INPUT, "cannot read the checkpoint '%.700s/" CHECKPOINT_FILE "': %s", dir,
                           strerror(errno));
    if (!status) status = kept_read(&spot, &folder, &bytes, &size, err);
    out_leave(&folder);
    Checkpoint c = checkpoint_over(bytes, size, &pool);
    if (!status) status = preface_read(&c, spot.path, &preface, &kept, &run, err);
    if (!status && (!preface.text || !preface.name))
        status = error_set(err, HAWSER_ERR_INPUT, "the checkpoint '%.500s' has no case in it", spot.path);
    if (!status) status = hawser_case_parse(preface.text, preface.name, out, err);
    if (!status) case_tree_unline((*out)->tree);
    if (!status && preface.folder) status = hawser_case_folder(*out, preface.folder, err);
    if (!status && preface.folder) status = path_keep((*out)->tree, preface.name, err);
    if (status && *out) {
        hawser_case_free(*out);
        *out = NULL;
    }
    text_pool_free(&pool);
    free(bytes);
    return status;
}
