/* A whole run: one pass, and a second with finer settings where the first leaves nothing open but its numerical errors.
 * docs/model.md, "Error bars" (EB19), (EB20); what a user needs to know of it is in docs/limits.md. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/base/error.h"
#include "io/api/api_handles.h"
#include "io/results/results_file.h"

/* Evaluations times segments, of which a second pass takes about so many times as many as the first (the median of 341
 * random pulls; 4.2 in 95 % of them). */
static const double GROWS = 3.1;
/* Evaluations times segments of a second pass that is begun unasked: some ten minutes. */
static const double WORK_MOST = 1.5e9;
/* Steps of a second pass over those of the first: 1.7 in the median, 3.3 in 99 % of them; what takes more mostly fails.
 */
enum { STEPS_MOST = 4 };

/* ------------------------------------------------------------------------------------------ whether it is wanted */

/* Conditions that finer settings can meet. Those of books and damping need other settings than one level would bring.
 */
static int is_numerical(const hawser_condition *c)
{
    static const char *const names[] = {"numerical_error", "numerical_peak", "mesh", "decided"};
    int found = 0;
    for (int k = 0; k < 4; ++k) found |= !strcmp(c->name, names[k]);
    return found;
}

/* Whether the part of friction at rest alone, of which two passes say nothing, is more than a bar may be. */
static int is_of_friction(const hawser_condition *c, const hawser_summary *sum)
{
    const hawser_error_bar *bar = NULL;
    if (!strcmp(c->name, "numerical_error")) bar = &sum->pull_mean_error;
    if (!strcmp(c->name, "numerical_peak")) bar = &sum->pull_peak_error;
    return bar && c->value * bar->friction > c->allowed * bar->total;
}

/* Whether a bend has a single pair of rollers on both sides of the cable, of which (ME12) says nothing. */
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

/* What error bars are known to say too little of, in words; NULL: nothing of it is there. */
static const char *unseen(const Scene *scene)
{
    const SceneDef *const def = &scene->def;
    if (!def->solver.relax) return "the cable did not come to rest first, of which error bars see too little";
    for (int k = 0; k < def->n_pieces; ++k)
        if (def->cables[def->pieces[k].cable].bending.rows > 0)
            return "the cable's bending stiffness falls as it bends, of which error bars see too little";
    return has_single_pair(scene) ? "a bend has one pair of rollers, of which error bars see too little" : NULL;
}

/* Whether nothing but numerical conditions fails that a second pass may settle, and some of them do, or there is what
 * bars do not see; the worst, without its remedy, into `why`. */
static int is_open(const Scene *scene, const hawser_summary *sum, size_t size, char *why)
{
    const char *const blind = unseen(scene);
    const hawser_condition *worst = NULL;
    for (int i = 0; i < sum->n_conditions; ++i) {
        const hawser_condition *const c = &sum->conditions[i];
        if (c->holds) continue;
        if (!is_numerical(c) || is_of_friction(c, sum)) return 0;
        if (!worst || c->value / c->allowed > worst->value / worst->allowed) worst = c;
    }
    if (!worst && blind) snprintf(why, size, "%s", blind);
    if (!worst) return blind != NULL;
    const char *const remedy = strstr(worst->remedy, ": use "), *const other = strstr(worst->remedy, ": set ");
    const char *const end = remedy ? remedy : other ? other : worst->remedy + strlen(worst->remedy);
    snprintf(why, size, "%.*s", (int)(end - worst->remedy), worst->remedy);
    return 1;
}

/* Whether the pass has met the conditions that a level of its settings does not change. */
static int is_sound(const hawser_summary *sum)
{
    int sound = 1;
    for (int i = 0; i < sum->n_conditions; ++i) sound &= sum->conditions[i].holds || is_numerical(&sum->conditions[i]);
    return sound;
}

/* The settings that a second pass makes finer, where the case itself gives them: with them its results would be those
 * of another case. */
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

/* The first key of that kind which the case or its catalogue gives; NULL: there is none. */
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

/* ---------------------------------------------------------------------------------------------- what is said of it */

/* What a pass found by itself: before it knows of another one. */
static hawser_pass pass_describe(const hawser_sim *s, const hawser_summary *sum, double friction)
{
    return (hawser_pass){.accuracy = s->stage.scene.def.solver.accuracy,
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

/* Of both passes' figures, and whose those of the run are. */
static void say_both(hawser_passes *p, const char *own)
{
    const hawser_pass *const a = &p->pass[0], *const b = &p->pass[1];
    const int n = snprintf(p->says, sizeof p->says,
                           "computed twice, with %d and %d segments and accuracies of %.3g and %.3g: mean %.6g N and "
                           "%.6g N, peak %.6g N and %.6g N; ",
                           a->segments, b->segments, a->accuracy, b->accuracy, a->pull_mean_N, b->pull_mean_N,
                           a->pull_peak_N, b->pull_peak_N);
    char *const rest = p->says + n;
    const size_t size = sizeof p->says - (size_t)n;
    if (!own) snprintf(rest, size, "all figures are those of the second pass");
    if (own)
        snprintf(rest, size, "as the case gives %.60s, they are those of the first pass, with bars from both", own);
}

/* ------------------------------------------------------------------------------------------------- the second pass */

/* What a second pass is made of. */
typedef struct Second {
    hawser_sim *first;
    hawser_sim *sim;  /* the pass itself; NULL: not built yet */
    const char *own;  /* a setting that is the case's; NULL: none */
    int slower;       /* v_s is refined too */
    const char *home; /* the first one's folder; NULL: nothing is written */
    char dir[4096];   /* its own within that */
    int lock;         /* of the first one's; -1: none */
    PassesSaid *says; /* the first's */
} Second;

/* Whether what stops the run here can be gone on with. */
static int is_kept(const Second *z) { return z->home && z->first->plan->output.checkpoint > 0; }

/* Its folder belongs to this run alone, and has nothing in it that an earlier one has left: but for what `resumed`
 * goes on with. Errors: OUTPUT. */
static hawser_status second_house(Second *z, int resumed, hawser_error *err)
{
    if (!z->home) return HAWSER_OK;
    if (snprintf(z->dir, sizeof z->dir, "%s/second-pass", z->home) >= (int)sizeof z->dir)
        return error_set(err, HAWSER_ERR_OUTPUT, "the results folder's name is too long");
    const hawser_status status = out_lock_dir(z->home, &z->lock, err);
    if (!status && !resumed) results_remove(z->dir);
    return status;
}

/* From its checkpoint, if the run that is gone on with has come so far, or from its beginning; what it needs to be
 * taken over is kept. Errors: as hawser_sim_run. */
static hawser_status second_run(Second *z, int resumed, hawser_progress progress, void *user, hawser_error *err)
{
    const char *const dir = z->home ? z->dir : NULL;
    int over = 0;
    hawser_status status = resumed ? pass_resume(z->sim, dir, progress, user, &over, err) : HAWSER_ERR_INPUT;
    if (status == HAWSER_ERR_INPUT) status = pass_run(z->sim, dir, progress, user, err); /* there is no checkpoint */
    if (!status && !over && is_kept(z)) status = pass_keep(z->sim, dir, err);
    return status;
}

/* Built from the case's definition with finer settings. Errors: MEMORY, INPUT, RUN. */
static hawser_status second_build(Second *z, hawser_error *err)
{
    hawser_sim *const first = z->first;
    hawser_summary sum;
    SceneDef *const finer = calloc(1, sizeof *finer);
    if (!finer) return error_memory(err);
    hawser_status status = scene_def_copy(first->plan, finer, err);
    if (status) {
        free(finer);
        return status;
    }
    hawser_sim_summary(first, &sum);
    scene_def_second_pass(finer, z->slower);
    finer->solver.max_steps = STEPS_MOST * sum.steps;
    status = sim_new(finer, first->threads, &z->sim, err);
    if (status) {
        scene_def_clear(finer);
        free(finer);
        return status;
    }
    z->sim->plan = finer;
    z->sim->pass = 1;
    z->sim->case_name = strdup(first->case_name);
    z->sim->title = strdup(first->title);
    if (!z->sim->case_name || !z->sim->title) return error_memory(err);
    return first->envelope.present ? envelope_new(&z->sim->envelope, &z->sim->stage.scene, err) : HAWSER_OK;
}

/* Its figures, and the passes' differences where they belong. Errors: MEMORY. */
static hawser_status second_take(Second *z, hawser_error *err)
{
    hawser_sim *const a = z->first, *const b = z->sim;
    hawser_summary first, second;
    hawser_sim_summary(a, &first);
    hawser_sim_summary(b, &second);
    const double friction = z->slower ? refinement_slower(a->plan, 1) : 1;
    hawser_passes *const said = &z->says->said;
    z->says->pass[1] = pass_describe(b, &second, friction);
    said->n = 2;
    said->outcome = z->own ? "compared" : "replaced";
    say_both(said, z->own);
    if (!z->own) {
        return other_pass_take(&b->other, &a->stats, &first, sim_jolt(a), 0, 0, err);
    }
    return other_pass_take(&a->other, &b->stats, &second, sim_jolt(b), 1, !is_sound(&second), err);
}

/* The results of the second pass become those of the handle; the folder's, too. Its checkpoint goes last. Errors:
 * OUTPUT, MEMORY. */
static hawser_status second_settle(Second *z, hawser_error *err)
{
    hawser_sim *const first = z->first;
    const int replaced = !z->own;
    if (replaced) {
        z->sim->passes = first->passes;
        first->passes = NULL;
        first->second = z->sim;
        z->sim = NULL;
    }
    if (!z->home) return HAWSER_OK;
    hawser_status status = replaced ? results_replace(z->home, z->dir, err) : HAWSER_OK;
    if (!status) status = pass_tell(SHOWN(first), z->home, err);
    if (!status) results_remove(z->dir);
    return status;
}

/* A second pass that was not to be: the first's results stand. What the caller stopped, and what no memory was there
 * for, is said to him. */
static hawser_status second_give_up(Second *z, hawser_status status, const hawser_error *why, hawser_error *err)
{
    hawser_passes *const said = &z->says->said;
    if (z->home && !(status == HAWSER_STOPPED && is_kept(z))) results_remove(z->dir);
    said->outcome = "failed";
    said->n = 1;
    if (status == HAWSER_STOPPED) {
        snprintf(said->says, sizeof said->says, "a second pass was stopped; these are the figures of the first");
        error_set(err, status, "stopped in the second pass; the results are those of the first%s",
                  is_kept(z) ? " until it is resumed" : "");
    } else {
        snprintf(said->says, sizeof said->says, "a second pass failed: %.400s", why->message);
        if (status == HAWSER_ERR_MEMORY) return error_memory(err);
    }
    hawser_status told = z->home ? pass_tell(z->first, z->home, status == HAWSER_STOPPED ? NULL : err) : HAWSER_OK;
    return status == HAWSER_STOPPED ? status : told;
}

/* Whether it would take too long to be begun unasked; says so, with the time it would take. By what was computed, not
 * by the clock: what a run says is the same on any machine. */
static int is_too_long(const hawser_sim *s, const hawser_summary *sum, hawser_passes *says)
{
    char about[32];
    const double work = GROWS * (double)sum->rhs_evals * sum->segments;
    if (s->plan->solver.passes == PASSES_TWO || work <= (s->work_most > 0 ? s->work_most : WORK_MOST)) return 0;
    says->outcome = "declined";
    say_time(GROWS * sum->wall_time_s, sizeof about, about);
    snprintf(says->says, sizeof says->says,
             "a second pass with finer settings would settle that in about %s: set solver.passes to 2", about);
    return 1;
}

/* Whether one is to be made, and what is said if one is open. Errors: MEMORY. */
static hawser_status second_ask(hawser_sim *s, int *wanted, hawser_error *err)
{
    char why[sizeof s->passes->said.why];
    hawser_summary sum;
    *wanted = 0;
    hawser_sim_summary(s, &sum);
    if (!is_open(&s->stage.scene, &sum, sizeof why, why)) return HAWSER_OK;
    s->passes = calloc(1, sizeof *s->passes);
    if (!s->passes) return error_memory(err);
    memcpy(s->passes->said.why, why, sizeof why);
    s->passes->said.n = 1;
    s->passes->said.pass = s->passes->pass;
    s->passes->pass[0] = pass_describe(s, &sum, 1);
    *wanted = !is_too_long(s, &sum, &s->passes->said);
    return HAWSER_OK;
}

/* After a first pass. resumed: that had ended when the run was stopped, and is as it was then. Errors: OUTPUT, MEMORY,
 * STOPPED. */
static hawser_status second_pass(hawser_sim *s, const char *dir, int resumed, hawser_progress progress, void *user,
                                 hawser_error *err)
{
    hawser_error late = {.status = HAWSER_OK};
    Second z = {.first = s, .home = dir, .lock = -1};
    int wanted;
    hawser_status status = second_ask(s, &wanted, err);
    if (status) return status;
    if (!wanted) return dir && s->passes ? pass_tell(s, dir, err) : HAWSER_OK;
    z.says = s->passes;
    z.own = given(s->plan, is_setting);
    z.slower = z.own || !given(s->plan, is_v_s); /* in a pass that is only compared no law is another one */
    status = second_house(&z, resumed, err);
    if (!status && is_kept(&z) && !resumed) status = pass_keep(s, dir, err);
    if (!status) {
        status = second_build(&z, &late);
        if (!status) status = second_run(&z, resumed, progress, user, &late);
        if (!status) status = second_take(&z, &late);
        status = status ? second_give_up(&z, status, &late, err) : second_settle(&z, err);
    }
    sim_free(z.sim);
    if (z.lock >= 0) close(z.lock);
    return status;
}

/* Whether all of the run is still to come: a simulation that its caller has moved is his, and not computed again. */
static int is_whole(const hawser_sim *s)
{
    return s->plan && !s->pass && !s->passes && !s->relaxed && !(hawser_sim_time(s) > 0);
}

/* What follows a pass that has ended, and the checkpoint of a run that there is nothing more to do for. */
static hawser_status go_on(hawser_sim *s, const char *dir, int whole, int over, hawser_status status,
                           hawser_progress progress, void *user, hawser_error *err)
{
    if (!status && whole && !s->led) status = second_pass(s, dir, over, progress, user, err);
    if (dir && (!status || status == HAWSER_ERR_RUN)) results_no_checkpoint(dir);
    return status;
}

hawser_status hawser_sim_run(hawser_sim *s, const char *dir, hawser_progress progress, void *user, hawser_error *err)
{
    hawser_error local = {.status = HAWSER_OK};
    hawser_error *const e = err ? err : &local;
    s = SHOWN(s);
    if (!s) return error_argument(e, "s");
    if (s->inside || s->running) return error_inside(e);
    if (s->leader) return error_led(e);
    const int whole = is_whole(s);
    return go_on(s, dir, whole, 0, pass_run(s, dir, progress, user, e), progress, user, e);
}

hawser_status hawser_sim_resume(hawser_sim *s, const char *dir, hawser_progress progress, void *user, hawser_error *err)
{
    hawser_error local = {.status = HAWSER_OK};
    hawser_error *const e = err ? err : &local;
    s = SHOWN(s);
    if (!s || !dir) return error_argument(e, s ? "dir" : "s");
    if (s->inside || s->running) return error_inside(e);
    if (s->leader) return error_led(e);
    const int whole = is_whole(s);
    int over = 0;
    const hawser_status status = pass_resume(s, dir, progress, user, &over, e);
    return go_on(s, dir, whole, over, status, progress, user, e);
}
