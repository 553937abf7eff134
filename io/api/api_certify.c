/* The figures that are certified. */
#include "io/api/api_certify.h"

#include <math.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "core/error.h"
#include "core/machine.h"
#include "core/vec3.h"
#include "io/api/api_handles.h"
#include "io/results/results_file.h"

/* Smallest coefficient for a floor: cables without friction have a weight too. */
static const double LEAST_MU = 0.01;

static const double LEAST_SHARE = 1e-3; /* share of the largest figure of a kind (CE6) */

static const char ROTATION[] = "rad"; /* unit of rotation vectors alone: x, y and z follow each other */

static void figures_free(Figures *f)
{
    free(f->figure);
    *f = (Figures){0};
}

/* Adds a figure; the list grows as needed; a failure shows at the end, by room < 0. */
static void add(Figures *f, const char *unit, double value, double floor, const char *format, ...)
    __attribute__((format(printf, 5, 6)));

static void add(Figures *f, const char *unit, double value, double floor, const char *format, ...)
{
    if (f->room < 0) return;
    if (f->n == f->room) {
        const int room = f->room ? 2 * f->room : 16;
        Figure *const more = realloc(f->figure, (size_t)room * sizeof *more);
        f->room = more ? room : -1;
        if (!more) return;
        f->figure = more;
    }
    Figure *const figure = &f->figure[f->n++];
    va_list args;
    *figure = (Figure){.unit = unit, .value = value, .floor = floor};
    va_start(args, format);
    vsnprintf(figure->name, sizeof figure->name, format, args);
    va_end(args);
}

/* Weight of a metre of the heaviest cable, N/m, and friction force of a metre, N (CE6). */
typedef struct Floors {
    double weight, drag;
} Floors;

static Floors floors_of(const SceneDef *def)
{
    double mass = 0, mu = LEAST_MU;
    for (int k = 0; k < def->n_pieces; ++k) mass = fmax(mass, def->cables[def->pieces[k].cable].mass);
    for (int r = 0; r < def->n_rollers; ++r) mu = fmax(mu, def->rollers[r].friction.mu_d);
    for (int k = 0; k < def->n_surfaces; ++k) mu = fmax(mu, def->surfaces[k].friction.mu_d);
    const double weight = mass * v3_norm(def->gravity);
    return (Floors){weight, mu * weight};
}

static void add_pull(hawser_sim *s, const hawser_summary *sum, Floors floor, Figures *f)
{
    const SceneDef *const def = &s->stage.scene.def;
    if (def->winch.present) {
        add(f, "N", sum->pull_mean_N, floor.drag, "pull, mean");
        add(f, "N", sum->pull_peak_N, floor.drag, "pull, peak");
    }
    const hawser_station *station;
    const int n = hawser_sim_stations(s, &station);
    for (int i = 0; i < n; ++i) {
        if (isnan(station[i].mean_N)) continue; /* no cable was there */
        add(f, "N", station[i].mean_N, floor.drag, "tension at %.40s, mean", station[i].name);
        add(f, "N", station[i].peak_N, floor.drag, "tension at %.40s, peak", station[i].name);
    }
}

/* Adds the most heavily loaded roller and surface, which are judged. Finer settings may change which ones these are. */
static void add_loads(hawser_sim *s, Floors floor, Figures *f)
{
    hawser_limit limit[HAWSER_LIMITS_MAX];
    const hawser_roller *roller;
    const hawser_surface *surface;
    const int rollers = hawser_sim_rollers(s, &roller), surfaces = hawser_sim_surfaces(s, &surface);
    double peak = -INFINITY, steady = -INFINITY, line = -INFINITY;
    for (int i = 0; i < rollers; ++i) {
        peak = fmax(peak, roller[i].peak_N);
        steady = fmax(steady, roller[i].steady_N);
    }
    for (int i = 0; i < surfaces; ++i) line = fmax(line, surface[i].line_load_N_per_m);
    if (peak > -INFINITY) add(f, "N", peak, floor.weight, "roller load, peak");
    if (steady > -INFINITY) add(f, "N", steady, floor.weight, "roller load, steady");
    if (line > -INFINITY) add(f, "N/m", line, floor.weight, "load on surfaces, peak");
    const int n = hawser_sim_limits(s, limit);
    for (int i = 0; i < n; ++i) {
        if (!isfinite(limit[i].value)) continue;
        if (limit[i].kind == HAWSER_LIMIT_SIDEWALL)
            add(f, "N/m", limit[i].value, floor.weight, "sidewall pressure, peak");
        if (limit[i].kind == HAWSER_LIMIT_PULL) add(f, "N", limit[i].value, floor.drag, "tension, largest");
    }
}

/* Largest value of a kind over the probes, and its equivalent of the related kind over the rod's length: a moment M
 * stands for forces M/L, a rotation for displacements of L times it. A component is not required to better than a
 * thousandth of it. */
typedef struct RodScales {
    double displacement, rotation, force, moment;
} RodScales;

static double length_of(const double v[3]) { return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

static RodScales rod_scales(const hawser_summary *sum, double length)
{
    double d = 0, r = 0, f = 0, m = 0;
    for (int i = 0; i < sum->n_probes; ++i) {
        const hawser_probe *const p = &sum->probes[i];
        d = fmax(d, length_of(p->displacement));
        r = fmax(r, length_of(p->rotation));
        f = fmax(f, length_of(p->force));
        m = fmax(m, length_of(p->moment));
    }
    return (RodScales){fmax(d, r * length), fmax(r, d / length), fmax(f, m / length), fmax(m, f * length)};
}

static void add_vector(const double v[3], const char *unit, double scale, const char *what, const char *of, Figures *f)
{
    for (int c = 0; c < 3; ++c) add(f, unit, v[c], scale, "%s of %.40s, %c", what, of, "xyz"[c]);
}

/* Chooses between r and (1 - 2 pi/|r|) r, the same rotation as two vectors, the one nearer to `own`'s three numbers
 * (CE8); at half a turn rounding decides which of them a run returns. */
static void turn_nearer(const Figure own[3], Figure other[3])
{
    const double r[3] = {other[0].value, other[1].value, other[2].value}, size = length_of(r);
    double here[3], there[3];
    if (!(size > 0)) return;
    for (int c = 0; c < 3; ++c) {
        here[c] = r[c] - own[c].value;
        there[c] = here[c] - 2 * M_PI / size * r[c];
    }
    if (!(length_of(there) < length_of(here))) return;
    for (int c = 0; c < 3; ++c) other[c].value = own[c].value + there[c];
}

void figures_follow(const Figures *own, Figures *other)
{
    for (int i = 0; i + 2 < own->n && i + 2 < other->n; ++i) {
        if (strcmp(own->figure[i].unit, ROTATION)) continue;
        turn_nearer(own->figure + i, other->figure + i);
        i += 2;
    }
}

/* Adds a rod's places at the end, and its modes; the lowest frequency other than of rigid motions is the floor of all.
 */
static void add_rod(const hawser_summary *sum, double length, Figures *f)
{
    const RodScales scale = rod_scales(sum, length);
    double highest = 0, lowest = INFINITY;
    for (int i = 0; i < sum->n_probes; ++i) {
        const hawser_probe *const p = &sum->probes[i];
        add_vector(p->displacement, "m", scale.displacement, "displacement", p->name, f);
        add_vector(p->rotation, ROTATION, scale.rotation, "rotation", p->name, f);
        add_vector(p->force, "N", scale.force, "force", p->name, f);
        add_vector(p->moment, "N m", scale.moment, "moment", p->name, f);
    }
    for (int i = 0; i < sum->n_modes; ++i) highest = fmax(highest, sum->modes[i].frequency_Hz);
    for (int i = 0; i < sum->n_modes; ++i) {
        const double hz = sum->modes[i].frequency_Hz;
        if (hz > 1e-6 * highest) lowest = fmin(lowest, hz);
    }
    for (int i = 0; i < sum->n_modes; ++i) add(f, "Hz", sum->modes[i].frequency_Hz, lowest, "frequency %d", i + 1);
}

/* Raises each floor to a thousandth of the largest figure with this unit. */
static void raise_floors(Figures *f, const char *unit)
{
    double largest = 0;
    for (int i = 0; i < f->n; ++i)
        if (!strcmp(f->figure[i].unit, unit)) largest = fmax(largest, fabs(f->figure[i].value));
    for (int i = 0; i < f->n; ++i) {
        if (!strcmp(f->figure[i].unit, unit)) f->figure[i].floor = fmax(f->figure[i].floor, LEAST_SHARE * largest);
    }
}

hawser_status figures_take(hawser_sim *s, Figures *out, hawser_error *err)
{
    hawser_summary sum;
    *out = (Figures){0};
    hawser_sim_summary(s, &sum);
    if (sum.rod) {
        const SceneDef *const def = &s->stage.scene.def;
        double length = 0;
        for (int k = 0; k < def->n_pieces; ++k) length += def->pieces[k].length;
        add_rod(&sum, length, out);
    } else {
        const Floors floor = floors_of(&s->stage.scene.def);
        add_pull(s, &sum, floor, out);
        add_loads(s, floor, out);
        raise_floors(out, "N");
        raise_floors(out, "N/m");
    }
    if (out->room >= 0) return HAWSER_OK;
    figures_free(out);
    return error_memory(err);
}

/* Runs of one case with finer settings at the same time: each on a thread of its own with a simulation of its own,
 * without shared data. The caller's thread waits and reports their progress. */

enum { THREADS_MAX = 2 };

static const double TELL = 0.2; /* s between two reports to the caller */

static const double SHARE_KNOWN = 0.02; /* share of a run after which its speed predicts its end */

typedef struct Pool {
    const SceneDef *def;
    int n, next, over; /* number of runs; next to be started; ended ones */
    Companion *const *companion;
    int stop;             /* the caller has requested a stop */
    hawser_status status; /* MEMORY belongs to the round; all else to the single run */
    pthread_mutex_t lock; /* protects changing data: the above, `share` and `seconds` of the companions */
    pthread_cond_t ended;
} Pool;

/* Copies the counts of a run into its description. */
static void companion_describe(const hawser_sim *s, Companion *out)
{
    const SceneDef *const def = &s->stage.scene.def;
    hawser_summary sum;
    hawser_sim_summary(s, &sum);
    hawser_certify_run *const about = &out->about;
    about->accuracy = def->solver.accuracy;
    about->interval_s = def->output.interval;
    about->segments = sum.segments;
    about->friction = refinement_slower(def, about->level[HAWSER_TIME]);
    about->steps = sum.steps;
    /* statics have no rates: counts a Newton step for each load step and segment */
    out->evaluations = (sum.rhs_evals > 0 ? (double)sum.rhs_evals : def->analysis.load_steps) * sum.segments;
}

/* Progress function of a run: notes its progress, and whether it may go on. */
typedef struct Note {
    Pool *pool;
    Companion *companion;
    double started; /* clock_now() */
    int too_much;   /* it was stopped because of its cost */
} Note;

/* Checks after each step whether the run has exceeded its work, so that it stops at the same step on any machine. Finer
 * settings can make a scene endless. */
static int too_much(void *user, hawser_sim *sim, double t)
{
    Note *const note = user;
    IntegratorStats now = {0};
    (void)t;
    integrator_stats(sim->stage.integrator, &now);
    note->too_much = (double)now.rhs_evals * sim->stage.scene.total > note->companion->most;
    return note->too_much;
}

static int note_progress(void *user, const hawser_sample *sample, double wall_s, double end_s)
{
    const Note *const note = user;
    (void)wall_s;
    pthread_mutex_lock(&note->pool->lock);
    note->companion->share = end_s > 0 ? fmin(sample->t / end_s, 1) : 0;
    note->companion->seconds = clock_now() - note->started;
    const int stop = note->pool->stop;
    pthread_mutex_unlock(&note->pool->lock);
    return stop;
}

/* Runs from the definition to the figures. */
static hawser_status run_one(const SceneDef *def, Companion *c, Note *note, hawser_error *err)
{
    SceneDef finer;
    hawser_sim *sim = NULL;
    hawser_status status = scene_def_copy(def, &finer, err);
    if (status) return status;
    scene_def_refine(&finer, c->about.level);
    status = sim_new(&finer, 1, &sim, err);
    scene_def_clear(&finer);
    if (!status) hawser_sim_on_step(sim, too_much, note);
    if (!status) status = hawser_sim_run(sim, NULL, note_progress, note, err);
    c->given_up = note->too_much && status == HAWSER_STOPPED;
    if (c->given_up)
        status = error_set(err, HAWSER_ERR_RUN, "given up at t = %.4g s: it was taking too long (see --effort)",
                           hawser_sim_time(sim));
    if (sim) companion_describe(sim, c);
    if (!status) status = figures_take(sim, &c->figures, err);
    sim_free(sim);
    return status;
}

/* Takes runs until there are none; a thread. */
static void *work(void *arg)
{
    Pool *const pool = arg;
    pthread_mutex_lock(&pool->lock);
    while (pool->next < pool->n && !pool->stop && !pool->status) {
        Companion *const c = pool->companion[pool->next++];
        pthread_mutex_unlock(&pool->lock);
        Note note = {.pool = pool, .companion = c, .started = clock_now()};
        hawser_error err = {HAWSER_OK, ""};
        const hawser_status status = run_one(pool->def, c, &note, &err);
        pthread_mutex_lock(&pool->lock);
        c->about.status = status;
        if (status) snprintf(c->about.message, sizeof c->about.message, "%.255s", err.message);
        if (status == HAWSER_ERR_MEMORY) pool->status = status;
        c->share = 1;
        c->seconds = clock_now() - note.started;
        pool->over++;
        pthread_cond_signal(&pool->ended);
    }
    pthread_mutex_unlock(&pool->lock);
    return NULL;
}

/* Fills in what is being computed, and when the round will end: runs that have not begun are assumed to take the
 * others' average time. The lock is held. */
static void state_fill(const Pool *pool, int threads, CertifyRound *round, char *what, size_t size)
{
    hawser_certify_state *const state = &round->state;
    double whole = 0, left = 0, known = 0, share = 0;
    what[0] = 0;
    for (int i = 0; i < pool->n; ++i) {
        const Companion *const c = pool->companion[i];
        const int *const level = c->about.level;
        const size_t used = strlen(what);
        share += c->share;
        if (i < pool->next && c->share < 1) {
            snprintf(what + used, size - used, "%stime %d, length %d", used ? "; " : "", level[HAWSER_TIME],
                     level[HAWSER_LENGTH]);
        }
        if (c->share < SHARE_KNOWN) continue;
        whole += c->seconds / c->share;
        left += c->seconds / c->share - c->seconds;
        known++;
    }
    left += (round->runs - round->over - known) * whole / fmax(known, 1);
    state->what = what;
    state->runs = round->runs;
    state->over = round->over + pool->over;
    state->done = (round->over + share) / round->runs;
    state->left_s = known > 0 ? left / threads : NAN;
}

/* Waits until all have ended; reports to the caller a few times a second, without the lock. */
static void wait_for_all(Pool *pool, CertifyRound *round, int threads)
{
    char what[160];
    pthread_mutex_lock(&pool->lock);
    while (pool->over < pool->n && !(pool->over == pool->next && (pool->stop || pool->status))) {
        struct timespec until;
        clock_gettime(CLOCK_REALTIME, &until);
        const long ns = until.tv_nsec + (long)(1e9 * TELL);
        until.tv_sec += ns / 1000000000L;
        until.tv_nsec = ns % 1000000000L;
        pthread_cond_timedwait(&pool->ended, &pool->lock, &until);
        state_fill(pool, threads, round, what, sizeof what);
        if (!round->progress) continue;
        pthread_mutex_unlock(&pool->lock);
        const int stop = round->progress(round->user, &round->state);
        pthread_mutex_lock(&pool->lock);
        pool->stop |= stop != 0;
    }
    pthread_mutex_unlock(&pool->lock);
}

/* Runs all companions at the same time on this many threads; a failed run has its message in its `about`. Errors:
 * STOPPED (by the caller), MEMORY. */
static hawser_status companions_run(CertifyRound *round, int n, Companion *const *companion, hawser_error *err)
{
    Pool pool = {.def = round->def,
                 .n = n,
                 .companion = companion,
                 .lock = PTHREAD_MUTEX_INITIALIZER,
                 .ended = PTHREAD_COND_INITIALIZER};
    pthread_t thread[THREADS_MAX];
    int threads = 0;
#ifdef HAWSER_THREADS
    while (threads < round->threads && threads < THREADS_MAX && threads < n &&
           !pthread_create(&thread[threads], NULL, work, &pool))
        ++threads;
#endif
    if (threads > 0) wait_for_all(&pool, round, threads);
    if (threads == 0) work(&pool); /* no thread could be started: computes in this one */
    for (int k = 0; k < threads; ++k) pthread_join(thread[k], NULL);
    pthread_mutex_destroy(&pool.lock);
    pthread_cond_destroy(&pool.ended);
    if (pool.status) return error_memory(err);
    return pool.stop ? error_set(err, HAWSER_STOPPED, "stopped while the figures were being certified") : HAWSER_OK;
}

/* A certificate for readers and for programs: rows of columns, as everywhere. */

enum { SHOWN_MAX = 24 };

static const Column figure_column[] = {
    /* the figure, as in "pull, mean" */
    {COLUMN("name", CHARS, hawser_certified, name)},
    /* its unit */
    {COLUMN("unit", TEXT, hawser_certified, unit)},
    /* found by the run itself */
    {COLUMN("value", NUMBER, hawser_certified, value)},
    /* error bound of the value */
    {COLUMN("bar", NUMBER, hawser_certified, run_bar)},
    /* tolerance times the figure's size, or times `floor` where that is larger */
    {COLUMN("allowed", NUMBER, hawser_certified, allowed)},
    /* 1: the value's bound is at most the allowed one */
    {COLUMN("holds", COUNT, hawser_certified, run_holds)},
    /* found with the finest settings whose error was estimated */
    {COLUMN("best", NUMBER, hawser_certified, best)},
    /* error bound of `best` */
    {COLUMN("best_bar", NUMBER, hawser_certified, bar)},
    /* 1: this bound is at most the allowed one */
    {COLUMN("best_holds", COUNT, hawser_certified, holds)},
    /* a smaller figure is judged as if it had this size */
    {COLUMN("floor", NUMBER, hawser_certified, floor)},
    /* found with time steps, or lengths of segments, refined once more; null: they were not, or that run failed */
    {COLUMN("refined.time", NUMBER, hawser_certified, refined[HAWSER_TIME])},
    {COLUMN("refined.length", NUMBER, hawser_certified, refined[HAWSER_LENGTH])},
    /* error of `best` by this source; null: not known */
    {COLUMN("error.time", NUMBER, hawser_certified, error[HAWSER_TIME])},
    {COLUMN("error.length", NUMBER, hawser_certified, error[HAWSER_LENGTH])},
    /* observed order of convergence; null: fewer than three values, or no visible order */
    {COLUMN("order.time", NUMBER, hawser_certified, order[HAWSER_TIME])},
    {COLUMN("order.length", NUMBER, hawser_certified, order[HAWSER_LENGTH])},
};

static const Columns figure_columns = COLUMNS(hawser_certified, figure_column);

static const Column run_column[] = {
    /* how often this source is refined; 0 and 0 is the case itself */
    {COLUMN("level.time", COUNT, hawser_certify_run, level[HAWSER_TIME])},
    {COLUMN("level.length", COUNT, hawser_certify_run, level[HAWSER_LENGTH])},
    /* `solver.accuracy` */
    {COLUMN("accuracy", NUMBER, hawser_certify_run, accuracy)},
    /* `output.interval` */
    {COLUMN("interval_s", NUMBER, hawser_certify_run, interval_s)},
    /* number in the whole chain */
    {COLUMN("segments", COUNT, hawser_certify_run, segments)},
    /* `v_s` of the friction over that of the case */
    {COLUMN("friction_v_s", NUMBER, hawser_certify_run, friction)},
    /* outcome of the run; 0 is good */
    {COLUMN("status", COUNT, hawser_certify_run, status)},
    /* empty, or the reason why it failed */
    {COLUMN("message", CHARS, hawser_certify_run, message)},
    /* time steps */
    {COLUMN("steps", LONG, hawser_certify_run, steps)},
    /* evaluations times segments, over those of the case itself */
    {COLUMN("work", NUMBER, hawser_certify_run, work)},
};

static const Columns run_columns = COLUMNS(hawser_certify_run, run_column);

/* ------------------------------------------------------------------------------------------------- for readers */

/* A figure as the report shows it: errors in per cent of its size, or of its floor. */
typedef struct Shown {
    const char *name, *unit, *word;
    double value, best, by[HAWSER_SOURCES], bar;
} Shown;

static const Column shown_column[] = {
    {COLUMN("name", TEXT, Shown, name), .label = "figure"},
    {COLUMN("value", NUMBER, Shown, value), .label = "this run", .decimals = -1, .unit_by = "unit"},
    {COLUMN("best", NUMBER, Shown, best), .label = "finest", .decimals = -1, .unit_by = "unit"},
    {COLUMN("unit", TEXT, Shown, unit), .label = ""},
    {COLUMN("time", NUMBER, Shown, by[HAWSER_TIME]), .label = "time %", .decimals = 3},
    {COLUMN("length", NUMBER, Shown, by[HAWSER_LENGTH]), .label = "length %", .decimals = 3},
    {COLUMN("bar", NUMBER, Shown, bar), .label = "+- %", .decimals = 3},
    {COLUMN("holds", TEXT, Shown, word), .label = ""},
};

static const Columns shown_columns = COLUMNS(Shown, shown_column);

static Shown show(const hawser_certified *f)
{
    const double size = fmax(fmax(fabs(f->best), f->floor), 1e-300);
    Shown out = {.name = f->name, .unit = f->unit, .value = f->value, .best = f->best, .bar = 100 * f->run_bar / size};
    for (int s = 0; s < HAWSER_SOURCES; ++s) out.by[s] = 100 * f->error[s] / size;
    out.word = f->run_holds ? "holds" : f->holds ? "holds at the finest" : "does not hold";
    return out;
}

static int of_station(const hawser_certified *f) { return !strncmp(f->name, "tension at", 10); }

/* Returns how much worse a figure is than allowed; an unknown one is worst. */
static double badness(const hawser_certified *f)
{
    if (f->run_bar <= 0) return 0;
    return isnan(f->run_bar) ? INFINITY : f->run_bar / f->allowed;
}

/* Chooses everything but the stations, and the worst few of these. Returns how many. */
static int choose(const hawser_certificate *c, Shown *out)
{
    enum { STATIONS_MAX = 4 };
    const hawser_certified *worst[STATIONS_MAX] = {NULL};
    int n = 0;
    for (int i = 0; i < c->n_figures; ++i) {
        const hawser_certified *f = &c->figure[i];
        if (!of_station(f)) {
            if (n < SHOWN_MAX - STATIONS_MAX) out[n++] = show(f);
            continue;
        }
        for (int k = 0; k < STATIONS_MAX && f; ++k) { /* keeps the list sorted; a displaced entry moves on */
            if (worst[k] && badness(f) <= badness(worst[k])) continue;
            const hawser_certified *const next = worst[k];
            worst[k] = f;
            f = next;
        }
    }
    for (int k = 0; k < STATIONS_MAX && worst[k]; ++k) out[n++] = show(worst[k]);
    return n;
}

hawser_status hawser_certificate_text(const hawser_certificate *certificate, hawser_format format, char **text,
                                      hawser_error *err)
{
    const hawser_certificate *const c = certificate;
    Shown shown[SHOWN_MAX];
    if (!c || !text) return error_argument(err, c ? "text" : "certificate");
    const int n = choose(c, shown);
    const Table all = {"figures", "Figures", figure_columns, c->n_figures, c->figure};
    const Table tables[] = {all, {"runs", "Runs", run_columns, c->n_runs, c->run}};
    const Table few = {"figures", "Errors by source, the worst stations only", shown_columns, n, shown};
    const Fact facts[] = {{"tolerance", "tolerance", "", cell_number(c->tolerance)},
                          {"runs_made", "runs", "", cell_number(c->n_runs)},
                          {"work", "work of the finer runs, in runs of the case", "", cell_number(c->work)},
                          /* 1: all figures hold to the tolerance */
                          {"certified", "certified", "", cell_number(c->certified)},
                          /* the result as text */
                          {"verdict", "", "", cell_text(c->verdict)},
                          /* identity of the run, as in `summary.json` */
                          {"run", "", "", cell_text(c->run_id)}};
    Document doc = {.title = "Certificate", .n_facts = 6, .fact = facts, .n_tables = 2, .table = tables, .csv = &all};
    if (format == HAWSER_TABLE || format == HAWSER_TABLE_US) {
        doc.n_facts = 3;
        doc.n_tables = 1;
        doc.table = &few;
    }
    return document_write(&doc, format, text, err);
}

hawser_status hawser_certificate_write(const hawser_certificate *certificate, const char *dir, hawser_error *err)
{
    char *text;
    if (!certificate || !dir) return error_argument(err, certificate ? "dir" : "certificate");
    hawser_status status = hawser_certificate_text(certificate, HAWSER_JSON, &text, err);
    if (status) return status;
    status = companion_write(dir, "certificate.json", text, err);
    hawser_text_free(text);
    return status;
}

/* Certificates: rounds of runs with finer settings, from which each figure's error is estimated source by source.
 * docs/theory.md, "Certificates". */

enum { RUNS_MAX = 32, ROUND_MAX = HAWSER_SOURCES + 2, SAID_MAX = 3 };

static const double TOLERANCE = 0.01, EFFORT = 6;

static const int ROUNDS = 4;

/* Assumed orders of the error in accuracy and in segments, until there are three values (CE3). */
static const double ASSUMED[HAWSER_SOURCES] = {[HAWSER_TIME] = 0.5, [HAWSER_LENGTH] = 1};

static const char *const source_name[HAWSER_SOURCES] = {"time", "length"};

typedef struct Certifier {
    hawser_certify_options options; /* with defaults filled in */
    const SceneDef *def;            /* the run whose figures are judged: a second pass, if that replaced the first */
    double slower;                  /* its v_s over the case's */
    double asks;                    /* work of a further round that was not begun; 0: none was needed */
    int n_runs;
    Companion run[RUNS_MAX]; /* the case's own run comes first */
    hawser_certificate *out;
} Certifier;

/* ------------------------------------------------------------------------------------------------------ runs */

/* Returns the run at the base's levels, shifted by `by` along one source; NULL: there is none. */
static Companion *run_at(Certifier *z, const int base[HAWSER_SOURCES], int source, int by)
{
    for (int r = 0; r < z->n_runs; ++r) {
        int same = 1;
        for (int s = 0; s < HAWSER_SOURCES; ++s) same &= z->run[r].about.level[s] == base[s] + (s == source ? by : 0);
        if (same) return &z->run[r];
    }
    return NULL;
}

/* Returns a figure of that run; NAN where that run does not exist or failed. */
static double figure_at(Certifier *z, const int base[HAWSER_SOURCES], int source, int by, int figure)
{
    const Companion *const c = run_at(z, base, source, by);
    return c && figure < c->figures.n ? c->figures.figure[figure].value : NAN;
}

/* Returns the work of the finer runs so far, in runs of the case. */
static double work_of_all(const Certifier *z)
{
    double work = 0;
    for (int r = 1; r < z->n_runs; ++r) work += z->run[r].evaluations / z->run[0].evaluations;
    return work;
}

/* Returns the expected cost of a run at these levels, in runs of the case: each level costs as many times more as the
 * first one did (or will: 1). */
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

/* Adds the missing runs of a round: the base itself, one level further in time, one back in length, which costs little
 * and reveals two values that agree by chance, and finally one further in length. Each may take a share of the
 * remaining effort, the last one the rest. Returns their expected cost; adds nothing, and returns INFINITY, where there
 * is no space for them. */
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

/* Judges one figure at the base's settings (CE5), (CE6). */
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

/* Judges all figures; returns 1 if all hold. */
static int judge(Certifier *z, const int base[HAWSER_SOURCES])
{
    int all = 1;
    for (int i = 0; i < z->out->n_figures; ++i) {
        judge_figure(z, base, i);
        all &= z->out->figure[i].holds;
    }
    return all;
}

/* Chooses the settings of the next round: one level finer in each source whose error is more than its part of the
 * allowed error for some figure that does not hold. Returns 0 if an error is not known, so that no choice is possible.
 */
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

/* Checks whether the round gives an error for every figure. */
static int is_known(const Certifier *z)
{
    for (int i = 0; i < z->out->n_figures; ++i)
        if (isnan(z->out->figure[i].bar)) return 0;
    return 1;
}

/* ------------------------------------------------------------------------------------------------------- sentences */

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

/* Returns the ratio of an error bound to its allowed value; an unknown bound is the worst. */
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

/* Returns an error as a share of the figure, or of its floor, in per cent. */
static double percent(const hawser_certified *f, double error) { return 100 * error / fmax(fabs(f->best), f->floor); }

/* Writes the settings of some levels, as keys to set; a run has been made at that level of time. */
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

/* Writes the finest level of each source that was tried. */
static void say_tried(Words *w, const Certifier *z)
{
    int deepest[HAWSER_SOURCES] = {0};
    for (int r = 0; r < z->n_runs; ++r)
        for (int s = 0; s < HAWSER_SOURCES; ++s)
            if (z->run[r].about.level[s] > deepest[s]) deepest[s] = z->run[r].about.level[s];
    say(w, "; tried in %d runs down to ", z->n_runs);
    say_settings(w, z, deepest);
}

/* Lists the figures that do not hold: the first few by name, with the source of the largest error. */
static void say_failing(Words *w, const Certifier *z)
{
    const hawser_certificate *const c = z->out;
    int said = 0, more = 0, diverges = 0;
    for (int i = 0; i < c->n_figures; ++i) {
        const hawser_certified *const f = &c->figure[i];
        if (f->holds) continue;
        int blame = 0; /* an unknown error is the largest of all */
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

/* Lists the conditions of the run that fail (docs/reference/limits.md, "Trust"); returns how many. */
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

/* Finds a failed run; a coarser run that fails does not count. */
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

/* Runs one round; the finest in length comes last and takes the rest of the effort. */
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

/* Runs rounds until all figures hold, a run fails, or the cost is too large. */
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
        if (k > 0 && !is_known(z)) { /* a run failed: the result of the round before is better */
            judge(z, base);
            break;
        }
        memcpy(base, next, sizeof base);
        if (all || !go_on(z, base, next)) break;
    }
    memcpy(z->out->base, base, sizeof base);
    return HAWSER_OK;
}

/* Copies the runs' descriptions into the certificate. */
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

/* Enters the case's own run, and allocates its figures. */
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
