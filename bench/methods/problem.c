#include "bench/methods/problem.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "bench/straight_scene.h"
#include "io/case/case_read.h"
#include "sim/equipment/reel.h"
#include "sim/equipment/winch.h"

double cpu_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int failed(const hawser_error *err)
{
    fprintf(stderr, "bench_methods: %s\n", err->message);
    return 0;
}

/* ------------------------------------------------------------------------------------------------- the scene */

static hawser_status settings_apply(CaseTree *tree, const char *const *settings, int n, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int k = 0; !status && k < n; ++k) {
        char key[200] = "";
        const char *const value = strchr(settings[k], '=');
        snprintf(key, sizeof key, "%.*s", value ? (int)(value - settings[k]) : 0, settings[k]);
        status = case_tree_set(tree, key, value ? value + 1 : "", err);
    }
    return status;
}

static hawser_status def_load(Problem *p, const char *path, const char *const *settings, int n, hawser_error *err)
{
    CaseTree *tree;
    hawser_status status = case_tree_load(path, &tree, err);
    if (!status) status = settings_apply(tree, settings, n, err);
    if (!status) status = case_read(tree, &p->def, err);
    case_tree_free(tree);
    return status;
}

static void layout_find(Problem *p)
{
    const Scene *const scene = &p->stage.scene;
    const int planar = p->motion == &p->stage.planar.motion;
    p->n = scene->chain.n;
    p->per = planar ? PLANAR_SIZE : STATE_SIZE;
    p->stride = p->motion->size / p->per;
}

int problem_new(Problem *p, const char *path, int segments, const char *const *settings, int n_settings)
{
    hawser_error err = {0};
    hawser_relaxation relaxation;
    memset(p, 0, sizeof *p);
    hawser_status status = HAWSER_OK;
    if (segments > 0) {
        if (!straight_scene(&p->def, segments)) return 0;
    } else {
        status = def_load(p, path, settings, n_settings, &err);
    }
    if (!status) status = stage_new(&p->stage, &p->def, NULL, &err);
    p->motion = p->stage.motion;
    if (!status) status = p->motion->ops->relax(p->motion, 0, p->stage.y, &relaxation, &err);
    if (status) return failed(&err);
    if (p->stage.scene.equipment->n > 0 || p->stage.scene.reel->present || p->stage.scene.winch->take_in.present) {
        fprintf(stderr, "bench_methods: only chains over rollers that do not move, of a length that does not change\n");
        return 0;
    }
    layout_find(p);
    return 1;
}

void problem_free(Problem *p)
{
    stage_free(&p->stage);
    scene_def_clear(&p->def);
    free(p->reference.t);
    free(p->reference.pull);
    memset(p, 0, sizeof *p);
}

double problem_stop(const Problem *p, double t)
{
    const Scene *const scene = &p->stage.scene;
    double stop = p->to;
    for (int r = 0; r < scene->n_rooms; ++r) {
        const Room *const room = &scene->room[r];
        if (room->present && room->kind->next_stop) stop = fmin(stop, room->kind->next_stop(room, scene, t + 1e-9));
    }
    return stop;
}

/* -------------------------------------------------------------------------------------- state and reference */

/* One number of the file. */
static int number_pass(FILE *file, int write, double *x, size_t count)
{
    return (write ? fwrite(x, sizeof *x, count, file) : fread(x, sizeof *x, count, file)) == count;
}

/* The file: rows, from, to, the state in space [13 n], times, forces. */
static int reference_pass(Problem *p, const char *name, int write)
{
    FILE *const file = fopen(name, write ? "wb" : "rb");
    const size_t size = (size_t)(STATE_SIZE * p->n);
    double *const full = calloc(size, sizeof *full), head[3] = {p->reference.rows, p->from, p->to};
    int ok = file && full;
    if (ok && write) p->motion->ops->unpack(p->motion, p->stage.y, full);
    ok = ok && number_pass(file, write, head, 3) && number_pass(file, write, full, size);
    Reference *const ref = &p->reference;
    if (ok && !write) {
        ref->rows = (int)head[0];
        p->from = head[1];
        p->to = head[2];
        ref->t = calloc((size_t)ref->rows, sizeof *ref->t);
        ref->pull = calloc((size_t)ref->rows, sizeof *ref->pull);
        ok = ref->t && ref->pull;
    }
    ok = ok && number_pass(file, write, ref->t, (size_t)ref->rows);
    ok = ok && number_pass(file, write, ref->pull, (size_t)ref->rows);
    if (ok && !write) p->motion->ops->pack(p->motion, full, p->stage.y);
    free(full);
    if (file) ok = fclose(file) == 0 && ok;
    if (!ok) fprintf(stderr, "bench_methods: %s cannot be %s\n", name, write ? "written" : "read");
    return ok;
}

static int reference_add(Reference *ref, double t, double pull)
{
    if ((ref->rows & (ref->rows - 1)) == 0) { /* room doubles at the powers of two */
        const size_t room = ref->rows ? 2 * (size_t)ref->rows : 1;
        double *const times = realloc(ref->t, room * sizeof *times);
        if (times) ref->t = times;
        double *const pulls = realloc(ref->pull, room * sizeof *pulls);
        if (pulls) ref->pull = pulls;
        if (!times || !pulls) return 0;
    }
    ref->t[ref->rows] = t;
    ref->pull[ref->rows++] = pull;
    return 1;
}

/* Integrates to p->to; keeps every step's force if wanted. */
static int reference_walk(Problem *p, int keep)
{
    hawser_error err = {0};
    Stage *const st = &p->stage;
    int ok = 1;
    while (ok && st->t < p->to) {
        if (stage_step(st, problem_stop(p, st->t), &err)) return failed(&err);
        if (keep) ok = reference_add(&p->reference, st->t, p->motion->ops->winch_pull(p->motion, st->t, st->y));
    }
    return ok;
}

int problem_converge(Problem *p, double accuracy, double from, double to, const char *file)
{
    const size_t bytes = (size_t)p->motion->size * sizeof(double);
    Stage *const st = &p->stage;
    SolverDef *const solver = &st->scene.def.solver;
    solver->accuracy = accuracy;
    solver->max_step = 1e-3;
    solver->max_order = 5;
    st->scene.winch->phase.held = 0;
    p->to = p->from = from;
    if (!reference_walk(p, 0)) return 0;
    double *const start = malloc(bytes);
    if (!start) return 0;
    memcpy(start, st->y, bytes);
    p->to = to;
    int ok = reference_add(&p->reference, from, p->motion->ops->winch_pull(p->motion, from, st->y));
    ok = ok && reference_walk(p, 1);
    memcpy(st->y, start, bytes);
    free(start);
    return ok && reference_pass(p, file, 1);
}

int problem_load(Problem *p, const char *file)
{
    hawser_error err = {0};
    if (!reference_pass(p, file, 0)) return 0;
    Reference *const ref = &p->reference;
    for (int k = 0; k < ref->rows; ++k) ref->largest = fmax(ref->largest, fabs(ref->pull[k]));
    p->stage.t = p->from;
    p->stage.scene.winch->phase.held = 0;
    if (p->motion->ops->renew(p->motion, p->from, p->stage.y, &err)) return failed(&err);
    return 1;
}

static double reference_at(const Reference *ref, double t)
{
    int low = 0, high = ref->rows - 1;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        *(ref->t[middle] <= t ? &low : &high) = middle;
    }
    const double share = (t - ref->t[low]) / (ref->t[high] - ref->t[low]);
    return ref->pull[low] + share * (ref->pull[high] - ref->pull[low]);
}

/* ------------------------------------------------------------------------------------------------- a run */

void walk_begin(Walk *w, Problem *p, double limit)
{
    *w = (Walk){.problem = p, .limit = limit, .t = p->from};
    w->last_error = p->motion->ops->winch_pull(p->motion, p->from, p->stage.y) - p->reference.pull[0];
    w->begun = cpu_now();
}

void walk_end(Walk *w) { w->cpu = cpu_now() - w->begun; }

int walk_step(Walk *w, double t, const double *y)
{
    Problem *const p = w->problem;
    hawser_error err = {0};
    if (p->motion->ops->accept(p->motion, t, y, &err)) return snprintf(w->why, sizeof w->why, "%.150s", err.message), 1;
    const double pull = p->motion->ops->winch_pull(p->motion, t, y);
    const double error = pull - reference_at(&p->reference, t);
    w->square += (t - w->t) / 2 * (error * error + w->last_error * w->last_error);
    if (!(fabs(error) <= w->worst)) w->worst = fabs(error);
    w->last_error = error;
    w->t = t;
    if (!isfinite(pull)) return snprintf(w->why, sizeof w->why, "the force is not finite"), 1;
    if (cpu_now() - w->begun < w->limit) return 0;
    return snprintf(w->why, sizeof w->why, "out of time"), 1;
}

double walk_rms(const Walk *w)
{
    const double covered = w->t - w->problem->from;
    return covered > 0 ? sqrt(w->square / covered) / w->problem->reference.largest : NAN;
}

double walk_worst(const Walk *w) { return w->worst / w->problem->reference.largest; }
