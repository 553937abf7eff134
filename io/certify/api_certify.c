/* Certificates: rounds of runs with finer settings, from which each figure's error is estimated source by source.
 * docs/model.md, "Certificates". */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/base/error.h"
#include "core/base/refinement.h"
#include "core/base/worst.h"
#include "io/certify/certify.h"

enum { RUNS_MAX = 32, ROUND_MAX = HAWSER_SOURCES + 2, SAID_MAX = 3 };
static const double TOLERANCE = 0.01, EFFORT = 6;
static const int ROUNDS = 4;
/* Orders that are taken for granted before there are three values (CE3): of the error in accuracy and in segments. */
static const double ASSUMED[HAWSER_SOURCES] = {[HAWSER_TIME] = 0.5, [HAWSER_LENGTH] = 1};
static const char *const source_name[HAWSER_SOURCES] = {"time", "length"};

typedef struct Certifier {
    hawser_certify_options options; /* filled in */
    const SceneDef *def; /* of the run whose figures are judged: of a second pass, if that replaced the first */
    double slower;       /* its v_s over the case's */
    double asks;         /* work with which another round would have begun; 0: none was wanting */
    int n_runs;
    Companion run[RUNS_MAX]; /* the case's own comes first */
    hawser_certificate *out;
} Certifier;

/* ------------------------------------------------------------------------------------------------------ runs */

/* The run at the base's levels, moved by `by` along one source; NULL: there is none. */
static Companion *run_at(Certifier *z, const int base[HAWSER_SOURCES], int source, int by)
{
    for (int r = 0; r < z->n_runs; ++r) {
        int same = 1;
        for (int s = 0; s < HAWSER_SOURCES; ++s) same &= z->run[r].about.level[s] == base[s] + (s == source ? by : 0);
        if (same) return &z->run[r];
    }
    return NULL;
}

/* A figure there; NAN where that run does not exist or failed. */
static double figure_at(Certifier *z, const int base[HAWSER_SOURCES], int source, int by, int figure)
{
    const Companion *const c = run_at(z, base, source, by);
    return c && figure < c->figures.n ? c->figures.figure[figure].value : NAN;
}

/* Of the finer runs so far, in runs of the case. */
static double work_of_all(const Certifier *z)
{
    double work = 0;
    for (int r = 1; r < z->n_runs; ++r) work += z->run[r].evaluations / z->run[0].evaluations;
    return work;
}

/* What a run at these levels will cost, in runs of the case: each level as many times more as the first one did (or
 * will do: then 1). */
static double cost_of(Certifier *z, const int level[HAWSER_SOURCES])
{
    static const int own[HAWSER_SOURCES] = {0};
    double cost = 1;
    for (int s = 0; s < HAWSER_SOURCES; ++s) {
        const Companion *const first = run_at(z, own, s, 1);
        const double growth = first ? first->evaluations / z->run[0].evaluations : 1;
        cost *= pow(growth, level[s]);
    }
    return cost;
}

/* The runs of a round that are not there yet: the base itself, one level further in time, one back in length, which
 * costs little and shows two values that agree by luck, and, behind them, one further in length. Each may take a share
 * of what is left of the effort, that one the rest. Returns what they will cost; adds nothing, and returns INFINITY,
 * where there is no room for them. */
static double plan_round(Certifier *z, const int base[HAWSER_SOURCES], int *n, Companion **wanted)
{
    static const struct {
        int source, by;
        double share;
    } steps[ROUND_MAX] = {{-1, 0, 0.2}, {HAWSER_TIME, 1, 0.55}, {HAWSER_LENGTH, -1, 0.25}, {HAWSER_LENGTH, 1, 0}};
    const double left = z->options.effort - work_of_all(z);
    double cost = 0;
    *n = 0;
    if (z->n_runs + ROUND_MAX > RUNS_MAX) return INFINITY;
    for (int k = 0; k < ROUND_MAX; ++k) {
        const int s = steps[k].source, by = steps[k].by;
        if (run_at(z, base, s, by)) continue;
        Companion *const c = &z->run[z->n_runs++];
        *c = (Companion){0};
        memcpy(c->about.level, base, sizeof c->about.level);
        if (s >= 0) c->about.level[s] += by;
        c->most = steps[k].share * left * z->run[0].evaluations;
        cost += cost_of(z, c->about.level);
        wanted[(*n)++] = c;
    }
    return cost;
}

/* -------------------------------------------------------------------------------------------------- judgement */

/* One figure at the base's settings (CE5), (CE6). */
static void judge_figure(Certifier *z, const int base[HAWSER_SOURCES], int i)
{
    const Figure *const figure = &z->run[0].figures.figure[i];
    hawser_certified *const f = &z->out->figure[i];
    *f = (hawser_certified){.unit = figure->unit, .value = figure->value, .floor = figure->floor};
    snprintf(f->name, sizeof f->name, "%s", figure->name);
    f->best = figure_at(z, base, -1, 0, i);
    for (int s = 0; s < HAWSER_SOURCES; ++s) {
        f->refined[s] = figure_at(z, base, s, 1, i);
        const Companion *const finer = run_at(z, base, s, 1);
        const double coarser = figure_at(z, base, s, -1, i), ratio = refinement_ratio((hawser_source)s);
        const Refinement r = finer && finer->given_up && !isnan(coarser)
                                 ? refinement_from_coarser(coarser, f->best, ratio, ASSUMED[s])
                                 : refinement_of(coarser, f->best, f->refined[s], ratio, ASSUMED[s]);
        f->error[s] = r.error;
        f->order[s] = r.order;
        f->diverges[s] = r.diverges;
        f->bar += r.error;
    }
    f->run_bar = f->bar + fabs(f->value - f->best);
    f->allowed = z->out->tolerance * fmax(fabs(f->best), f->floor);
    f->holds = f->bar <= f->allowed;
    f->run_holds = f->holds && f->run_bar <= f->allowed;
}

/* All of them; 1 if all hold. */
static int judge(Certifier *z, const int base[HAWSER_SOURCES])
{
    int all = 1;
    for (int i = 0; i < z->out->n_figures; ++i) {
        judge_figure(z, base, i);
        all &= z->out->figure[i].holds;
    }
    return all;
}

/* The settings of the next round: finer by a level in each source of which the error of some figure that does not hold
 * is more than its part of what is allowed. Returns 0 if an error is not known, so that there is no way on. */
static int go_on(const Certifier *z, const int base[HAWSER_SOURCES], int next[HAWSER_SOURCES])
{
    memcpy(next, base, HAWSER_SOURCES * sizeof *next);
    for (int i = 0; i < z->out->n_figures; ++i) {
        const hawser_certified *const f = &z->out->figure[i];
        for (int s = 0; s < HAWSER_SOURCES && !f->holds; ++s) {
            if (isnan(f->error[s])) return 0;
            if (f->error[s] > f->allowed / HAWSER_SOURCES) next[s] = base[s] + 1;
        }
    }
    return 1;
}

/* Whether a round could say something of every figure that the round before could speak of. */
static int is_known(const Certifier *z)
{
    for (int i = 0; i < z->out->n_figures; ++i)
        if (isnan(z->out->figure[i].bar)) return 0;
    return 1;
}

/* ------------------------------------------------------------------------------------------------------- words */

typedef struct Words {
    char *text;
    size_t used, size;
} Words;

static void say(Words *w, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void say(Words *w, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    const int n = vsnprintf(w->text + w->used, w->size - w->used, format, args);
    va_end(args);
    if (n > 0) w->used += (size_t)n < w->size - w->used ? (size_t)n : w->size - w->used - 1;
}

/* How far a bar is from what is allowed; one that is not known counts as the worst. */
static double excess(const hawser_certified *f)
{
    if (f->run_bar <= 0) return 0;
    return isnan(f->run_bar) ? INFINITY : f->run_bar / f->allowed;
}

static const hawser_certified *worst_of(const hawser_certificate *c)
{
    const hawser_certified *worst = &c->figure[0];
    for (int i = 1; i < c->n_figures; ++i)
        if (excess(&c->figure[i]) > excess(worst)) worst = &c->figure[i];
    return worst;
}

/* A share of the figure, or of its floor. */
static double percent(const hawser_certified *f, double error) { return 100 * error / fmax(fabs(f->best), f->floor); }

/* Settings at some levels, as keys to set; a run has been made at that level of time. */
static void say_settings(Words *w, const Certifier *z, const int level[HAWSER_SOURCES])
{
    const int t = level[HAWSER_TIME], l = level[HAWSER_LENGTH];
    int r = 0;
    while (z->run[r].about.level[HAWSER_TIME] != t) ++r;
    const hawser_certify_run *const about = &z->run[r].about;
    if (t > 0) say(w, "solver.accuracy %.3g and output.interval %.3g s", about->accuracy, about->interval_s);
    if (about->friction < 1) say(w, ", v_s 1/%g as high", 1 / about->friction);
    if (l > 0) say(w, "%ssegments 1/%g as long", t > 0 ? ", " : "", pow(refinement_ratio(HAWSER_LENGTH), l));
}

/* The deepest that each source was refined. */
static void say_tried(Words *w, const Certifier *z)
{
    int deepest[HAWSER_SOURCES] = {0};
    for (int r = 0; r < z->n_runs; ++r)
        for (int s = 0; s < HAWSER_SOURCES; ++s)
            if (z->run[r].about.level[s] > deepest[s]) deepest[s] = z->run[r].about.level[s];
    say(w, "; tried in %d runs down to ", z->n_runs);
    say_settings(w, z, deepest);
}

/* Figures that do not hold: the first few by name, with the source that is most to blame. */
static void say_failing(Words *w, const Certifier *z)
{
    const hawser_certificate *const c = z->out;
    int said = 0, more = 0, diverges = 0;
    for (int i = 0; i < c->n_figures; ++i) {
        const hawser_certified *const f = &c->figure[i];
        if (f->holds) continue;
        int blame = 0; /* one that is not known is to blame before all others */
        for (int s = 1; s < HAWSER_SOURCES && !isnan(f->error[blame]); ++s)
            if (!(f->error[s] <= f->error[blame])) blame = s;
        diverges |= f->diverges[blame];
        if (said++ >= SAID_MAX) {
            more++;
            continue;
        }
        say(w, "%s%s", said > 1 ? "; " : "", f->name);
        if (isnan(f->bar)) say(w, " is not known (%s)", source_name[blame]);
        if (!isnan(f->bar)) say(w, " +- %.2g %% (%s)", percent(f, f->bar), source_name[blame]);
    }
    if (more) say(w, "; and %d more", more);
    if (diverges) {
        say(w, "; some came no nearer with finer settings, as where a cable slips in jerks, swings or jumps");
    }
}

/* The conditions of the run that fail (docs/limits.md, "Trust"); returns how many. */
static int say_conditions(Words *w, const hawser_summary *sum)
{
    int n = 0;
    for (int i = 0; i < sum->n_conditions; ++i) {
        if (sum->conditions[i].holds) continue;
        say(w, "%s%s", n++ ? ", " : "NOT CERTIFIED: the run is not to be trusted (", sum->conditions[i].name);
    }
    if (n) say(w, ")");
    return n;
}

/* That a coarser run fails says nothing. */
static const Companion *failed_run(const Certifier *z)
{
    for (int r = 0; r < z->n_runs; ++r)
        if (z->run[r].about.status && z->run[r].about.level[HAWSER_LENGTH] >= 0) return &z->run[r];
    return NULL;
}

static void verdict(Certifier *z, const hawser_summary *sum)
{
    hawser_certificate *const c = z->out;
    Words w = {c->verdict, 0, sizeof c->verdict};
    const hawser_certified *const worst = worst_of(c);
    const Companion *const failed = failed_run(z);
    int holds = 1, run_holds = 1;
    for (int i = 0; i < c->n_figures; ++i) {
        holds &= c->figure[i].holds;
        run_holds &= c->figure[i].run_holds;
    }
    if (say_conditions(&w, sum)) {
        if (holds && !run_holds) {
            say(&w, "; its figures hold with ");
            say_settings(&w, z, c->base);
        }
        return;
    }
    if (run_holds) {
        c->certified = 1;
        say(&w, "CERTIFIED: all %d figures hold to %g %%, the worst is %s: %.5g %s +- %.2g %%", c->n_figures,
            100 * c->tolerance, worst->name, worst->value, worst->unit, percent(worst, worst->run_bar));
    } else if (holds) {
        say(&w, "NOT CERTIFIED: the figures hold to %g %% with ", 100 * c->tolerance);
        say_settings(&w, z, c->base);
        say(&w, ", but not those of this run: %s is %.5g %s +- %.2g %%, not %.5g %s", worst->name, worst->best,
            worst->unit, percent(worst, worst->bar), worst->value, worst->unit);
    } else {
        say(&w, "NOT CERTIFIED: to %g %% do not hold: ", 100 * c->tolerance);
        say_failing(&w, z);
        if (failed) say(&w, "; a run with finer settings failed: %s", failed->about.message);
        say_tried(&w, z);
        if (z->asks > 0 && z->asks < INFINITY)
            say(&w, "; finer ones would take about %.3g times the run: --effort %.0f", z->asks, ceil(1.1 * z->asks));
    }
}

/* ------------------------------------------------------------------------------------------------------ rounds */

/* One round; what is finest in length comes last and takes what the others leave. */
static hawser_status round_run(Certifier *z, CertifyRound *round, int n, Companion *const *wanted, hawser_error *err)
{
    round->runs = n;
    round->over = 0;
    const hawser_status status = n > 1 ? companions_run(round, n - 1, wanted, err) : HAWSER_OK;
    if (status || n == 0) return status;
    wanted[n - 1]->most = (z->options.effort - work_of_all(z)) * z->run[0].evaluations;
    round->over = n - 1;
    return companions_run(round, 1, wanted + n - 1, err);
}

/* Rounds until all figures hold, a run fails, or it would cost too much. */
static hawser_status rounds(Certifier *z, hawser_error *err)
{
    CertifyRound round = {
        .def = z->def, .threads = z->options.threads, .progress = z->options.progress, .user = z->options.user};
    int base[HAWSER_SOURCES] = {0}, next[HAWSER_SOURCES] = {0}, n;
    Companion *wanted[ROUND_MAX];
    for (int k = 0; k < z->options.rounds; ++k) {
        const int before = z->n_runs;
        const double spent = work_of_all(z), cost = plan_round(z, next, &n, wanted);
        if (k > 0 && spent + cost > z->options.effort) {
            z->n_runs = before;
            z->asks = spent + cost;
            break;
        }
        round.state = (hawser_certify_state){.round = k + 1};
        const hawser_status status = round_run(z, &round, n, wanted, err);
        if (status) return status;
        for (int r = 0; r < n; ++r) figures_follow(&z->run[0].figures, &wanted[r]->figures);
        const int all = judge(z, next);
        if (k > 0 && !is_known(z)) { /* a run failed: what the round before knew is better */
            judge(z, base);
            break;
        }
        memcpy(base, next, sizeof base);
        if (all || !go_on(z, base, next)) break;
    }
    memcpy(z->out->base, base, sizeof base);
    return HAWSER_OK;
}

/* The runs' descriptions into the certificate. */
static hawser_status describe_runs(Certifier *z, hawser_error *err)
{
    hawser_certificate *const c = z->out;
    c->run = calloc((size_t)z->n_runs, sizeof *c->run);
    if (!c->run) return error_memory(err);
    c->n_runs = z->n_runs;
    for (int r = 0; r < z->n_runs; ++r) {
        c->run[r] = z->run[r].about;
        c->run[r].friction *= z->slower;
        c->run[r].work = z->run[r].evaluations / z->run[0].evaluations;
    }
    c->work = work_of_all(z);
    return HAWSER_OK;
}

/* The case's own run, and room for its figures. */
static hawser_status begin(Certifier *z, hawser_sim *run, hawser_error *err)
{
    const double end = hawser_sim_end_time(run);
    if (hawser_sim_time(run) < end * (1 - 1e-9)) {
        return error_set(err, HAWSER_ERR_INPUT, "a run that ended at %.4g s of %.4g s cannot be certified",
                         hawser_sim_time(run), end);
    }
    companion_describe(run, &z->run[0]);
    z->n_runs = 1;
    const hawser_status status = figures_take(run, &z->run[0].figures, err);
    if (status) return status;
    z->out->n_figures = z->run[0].figures.n;
    if (z->out->n_figures == 0) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "there is nothing to certify: the case has no winch, stations, rollers, surfaces or modes; "
                         "give output.probes");
    }
    z->out->figure = calloc((size_t)z->out->n_figures, sizeof *z->out->figure);
    return z->out->figure ? HAWSER_OK : error_memory(err);
}

static hawser_status options_fill(const hawser_certify_options *given, hawser_certify_options *out, hawser_error *err)
{
    *out = given ? *given : (hawser_certify_options){0};
    if (out->tolerance < 0 || out->tolerance >= 1 || out->rounds < 0 || out->effort < 0 || out->threads < 0 ||
        out->threads > 2) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "a certificate's tolerance is a share below 1, its rounds and effort are not negative, and it "
                         "uses 1 or 2 threads");
    }
    if (!(out->tolerance > 0)) out->tolerance = TOLERANCE;
    if (!out->rounds) out->rounds = ROUNDS;
    if (!(out->effort > 0)) out->effort = EFFORT;
    if (!out->threads) out->threads = sysconf(_SC_NPROCESSORS_ONLN) > 1 ? 2 : 1;
    return HAWSER_OK;
}

hawser_status hawser_certify(hawser_case *c, hawser_sim *run, const hawser_certify_options *options,
                             hawser_certificate **out, hawser_error *err)
{
    hawser_summary sum;
    if (!c || !run || !out) return error_argument(err, !c ? "c" : !run ? "run" : "out");
    *out = NULL;
    const hawser_sim *const finer = run->finer;
    char identity[SUM_SIZE];
    run_identity(run, identity);
    run = SHOWN(run);
    Certifier *const z = calloc(1, sizeof *z);
    hawser_certificate *const certificate = calloc(1, sizeof *certificate);
    hawser_status status = z && certificate ? case_ensure_read(c, err) : error_memory(err);
    if (!status) status = case_alone(c, "a certificate", err);
    if (!status) status = options_fill(options, &z->options, err);
    if (!status) {
        z->def = finer ? finer->plan : c->def;
        z->slower = finer ? finer->passes->pass[finer->pass].friction : 1;
        z->out = certificate;
        certificate->tolerance = z->options.tolerance;
        status = begin(z, run, err);
    }
    if (!status) status = rounds(z, err);
    if (!status) status = describe_runs(z, err);
    if (!status) snprintf(certificate->run_id, sizeof certificate->run_id, "%s", identity);
    if (!status) {
        hawser_sim_summary(run, &sum);
        verdict(z, &sum);
    }
    for (int r = 0; z && r < z->n_runs; ++r) figures_free(&z->run[r].figures);
    free(z);
    if (status) hawser_certificate_free(certificate);
    if (!status) *out = certificate;
    return status;
}

void hawser_certificate_free(hawser_certificate *certificate)
{
    if (!certificate) return;
    free(certificate->figure);
    free(certificate->run);
    free(certificate);
}
