/* The calls of a simulation in which the interface checks something, or remembers how it went; the others are in
 * sim/run/sim.c. */
#include "core/base/error.h"
#include "core/base/team.h"
#include "def/cost.h"
#include "io/api/api_handles.h"
#include "io/results/results_file.h"
#include "sim/run/commands.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What a second pass would be built from, where there may be one: of a pull in time. Returns 0 without memory. */
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

/* What the results are called: of a chain among several its own name, too. Returns 0 without memory. */
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

/* Options come from a program or a command line, so they are checked like a case. */
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
                         "%.200s: key 'run.duration': missing: without a winch that sets a speed nothing says how long",
                         c->name);
    }
    status = cost_check(c->def, err);
    if (!status) status = sim_new(c->def, threads, out, err);
    if (status) return case_name_error(c, status, err);
    hawser_sim *const s = *out; /* the case may be gone soon */
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

/* Keeps the outcome of a call that computes, for the summary. */
static hawser_status keep_outcome(hawser_sim *s, hawser_status status, const hawser_error *err)
{
    s->outcome = status;
    if (status) memcpy(s->message, err->message, sizeof s->message);
    return status;
}

hawser_status error_inside(hawser_error *err)
{
    return error_set(err, HAWSER_ERR_INPUT, "a call-back of the simulation may look and tell, but not make it move");
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

/* The statistics and the integrator start from here; later the state is theirs. */
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

/* The corners of the drive are never stepped over, whatever t is. */
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

/* One word for the summary. */
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

/* What would make the broken limits hold, each sentence once. Returns how many. */
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
