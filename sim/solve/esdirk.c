#include "sim/solve/esdirk.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/chain.h"
#include "core/machine.h"
#include "sim/solve/vector_queue.h"

/* Length of the next step by the errors of this one and the one before (OS9): safety, exponents times the order,
 * limits. Within STAYS the step keeps its length, and its matrix. */
static const double SAFETY = 0.9, PROPORTIONAL = 0.4, INTEGRAL = 0.7, SHRINK_MOST = 0.2, GROW_MOST = 5;
static const double STAYS_FROM = 0.9, STAYS_TO = 1.2;
/* Share to which a step is cut if its stages could not be solved. */
static const double RETRY = 0.25;
/* The first step: the rates may move the state by this many tolerances. */
static const double FIRST = 0.1;
/* Largest change of gamma without a new matrix, as in sim/solve/integrator.c. */
static const double GAMMA_CHANGE = 0.005;
/* A matrix whose correction leaves more than this of the error is made anew. */
static const double SLOW = 0.2;
static const double RATE_KEPT = 0.3; /* of the old estimate of the convergence */
enum { ITERATIONS_MOST = 20, HALVINGS_MOST = 5, ATTEMPTS_MOST = 30, MATRIX_STEPS = 50 };

/* Treatment of the matrix: kept; formed for another gamma; or with new blocks too. */
typedef enum Matrix { MATRIX_STAYS, MATRIX_FORMED, MATRIX_ANEW } Matrix;

struct Esdirk {
    Motion *motion;
    double *y;
    const double *weight;
    IntegratorStats *stats;
    double share, longest; /* of the error's tolerance; s, 0: unlimited */
    VectorQueue queue;
    int size;
    double *room;                      /* the vectors below, in one block */
    double *rate[2][ESDIRK_STAGES];    /* of the stages: of this step, [now], and of the one before */
    double *base, *stage, *correction; /* (OS5): known part of a stage, the stage, its correction */
    double *error;
    int now;
    int begun;           /* 1: rate[now][0] is that of y */
    int past;            /* 1: the other rates are those of a step of length `last` */
    double next, last;   /* s */
    double error_before; /* norm of the last accepted step's error */
    double gamma;        /* s, of the matrix; 0: none */
    double convergence;  /* of Newton's iteration, with this matrix */
    long matrix_step;    /* step at which its blocks were made */
};

/* ESDIRK3(2)5L[2]SA of C. A. Kennedy and M. H. Carpenter, Diagonally implicit Runge-Kutta methods for stiff ODEs,
 * Applied Numerical Mathematics 146 (2019), to the 17 digits of a double. */
static const EsdirkTableau tableau = {
    .gamma = 0.225,
    .c = {0, 0.45, 0.76819805153394638, 0.6, 1},
    .a = {{0},
          {0.225, 0.225},
          {0.2715990257669732, 0.2715990257669732, 0.225},
          {0.22374368670764586, 0.22374368670764586, -0.072487373415291628, 0.225},
          {0.17554550212940523, 0.17554550212940523, -0.34685820002600626, 0.77076719576719577, 0.225}},
    .embedded = {0.18435122201605925, 0.18435122201605925, -0.27820818405098702, 0.69686201254332369,
                 0.21264372747554489},
    .node = {{0}, {0, ESDIRK_BEFORE(3), ESDIRK_BEFORE(0)}, {0, 1, ESDIRK_BEFORE(3)}, {0, 1, 2}, {0, 1, 2}},
};

const EsdirkTableau *esdirk_tableau(void) { return &tableau; }

/* ------------------------------------------------------------------------------------------------- life */

enum { VECTORS = 2 * ESDIRK_STAGES + 4 };

/* Allocates vectors of the motion's size; 0 if there is no memory. */
static int vectors_new(Esdirk *e)
{
    const int size = e->motion->size, stride = (size + LANES - 1) / LANES * LANES;
    double *const room = aligned_array_new(VECTORS * stride);
    if (!room) return 0;
    free(e->room);
    e->room = room;
    e->size = size;
    double *at = room;
    double **const single[] = {&e->base, &e->stage, &e->correction, &e->error};
    for (int k = 0; k < 2 * ESDIRK_STAGES; ++k, at += stride) e->rate[k / ESDIRK_STAGES][k % ESDIRK_STAGES] = at;
    for (int k = 0; k < 4; ++k, at += stride) *single[k] = at;
    return 1;
}

Esdirk *esdirk_new(Motion *motion, double *y, const double *weight, double share, double longest,
                   IntegratorStats *stats)
{
    Esdirk *const e = calloc(1, sizeof *e);
    if (!e) return NULL;
    *e = (Esdirk){.motion = motion,
                  .y = y,
                  .weight = weight,
                  .stats = stats,
                  .share = share,
                  .longest = longest,
                  .convergence = 1};
    e->queue = (VectorQueue){.team = motion->team, .pitch = &motion->pitch};
    return vectors_new(e) ? e : esdirk_free(e);
}

Esdirk *esdirk_free(Esdirk *e)
{
    if (e) free(e->room);
    free(e);
    return NULL;
}

/* ------------------------------------------------------------------------------------------------- vectors */

/* z = sum of a[k] x[k] over the `terms` */
static void combine(Esdirk *e, int terms, const double *a, double *const *x, double *z)
{
    VectorTask *const task = vector_queue_next(&e->queue, e->size);
    task->kind = VECTOR_COMBINATION;
    task->terms = terms;
    memcpy(task->a, a, (size_t)terms * sizeof *a);
    memcpy(task->x, x, (size_t)terms * sizeof *x);
    task->z = z;
    vector_queue_flush(&e->queue, e->size);
}

static double norm_of(const Esdirk *e, const double *x) { return e->motion->ops->norm(e->motion, x, e->weight); }

static int rates_at(Esdirk *e, double t, const double *y, double *rates)
{
    const double start = clock_now();
    const int bad = e->motion->ops->rates(e->motion, t, y, rates);
    ++e->stats->rhs_evals;
    e->stats->rhs += clock_now() - start;
    return bad;
}

/* ------------------------------------------------------------------------------------------------- Newton */

/* The matrix for gamma; if it is due anew, with blocks of the last evaluation of the rates. */
static int matrix_make(Esdirk *e, double gamma, Matrix due, double t, const double *rates)
{
    const double start = clock_now();
    if (due == MATRIX_ANEW) {
        e->motion->ops->linearise(e->motion, t, e->stage, rates);
        ++e->stats->jac_evals;
        e->matrix_step = e->stats->steps;
    }
    e->motion->ops->form(e->motion, gamma);
    const double formed = clock_now();
    const int bad = e->motion->ops->factor(e->motion);
    e->stats->jacobian += formed - start;
    e->stats->factor += clock_now() - formed;
    ++e->stats->lin_setups;
    e->gamma = bad ? 0 : gamma;
    e->convergence = 1;
    return bad;
}

static Matrix matrix_due(const Esdirk *e, double gamma)
{
    if (!(e->gamma > 0) || e->stats->steps - e->matrix_step >= MATRIX_STEPS) return MATRIX_ANEW;
    return fabs(gamma / e->gamma - 1) > GAMMA_CHANGE ? MATRIX_FORMED : MATRIX_STAYS;
}

/* Residual at e->stage, whose rates were evaluated last (OS5), solved for the correction. */
static int correct(Esdirk *e, double gamma, double *rates)
{
    combine(e, 3, (double[]){1, gamma, -1}, (double *[]){e->base, rates, e->stage}, e->correction);
    const double start = clock_now();
    const int bad = e->motion->ops->solve(e->motion, e->correction);
    e->stats->solve += clock_now() - start;
    ++e->stats->newton_iters;
    return bad;
}

/* A correction that is larger than the one before it, both by new matrices, diverges: goes back by half of the previous
 * one, which e->error holds. */
static void go_back(Esdirk *e)
{
    combine(e, 2, (double[]){1, -0.5}, (double *[]){e->stage, e->error}, e->stage);
    combine(e, 1, (double[]){0.5}, (double *[]){e->error}, e->error);
}

/* Makes the correction, and keeps it in e->error for go_back. */
static void go_on(Esdirk *e)
{
    double *const made = e->correction;
    combine(e, 2, (double[]){1, 1}, (double *[]){e->stage, made}, e->stage);
    e->correction = e->error;
    e->error = made;
}

/* Solves stage i, which ends at t, for its rates; on entry they hold a guess (OS5)-(OS7). */
static EsdirkEnd stage_solve(Esdirk *e, int i, double t, double gamma)
{
    double *const rates = e->rate[e->now][i];
    double before = INFINITY;
    int halvings = 0;
    Matrix due = matrix_due(e, gamma), was = MATRIX_STAYS;
    combine(e, 2, (double[]){1, gamma}, (double *[]){e->base, rates}, e->stage);
    for (int k = 0; k < ITERATIONS_MOST; ++k) {
        if (rates_at(e, t, e->stage, rates)) return ESDIRK_NO_RATES;
        int bad = due != MATRIX_STAYS ? matrix_make(e, gamma, due, t, rates) : 0;
        if (!bad) bad = correct(e, gamma, rates);
        if (bad) return bad < 0 ? ESDIRK_NO_MEMORY : ESDIRK_NO_FACTORS;
        const double size = norm_of(e, e->correction), ratio = size / before;
        if (!(size < INFINITY)) return ESDIRK_NO_NEWTON;
        if (ratio > 1 && due == MATRIX_ANEW && was == MATRIX_ANEW) {
            if (++halvings > HALVINGS_MOST) return ESDIRK_NO_NEWTON;
            go_back(e);
            continue;
        }
        if (k > 0) e->convergence = fmax(RATE_KEPT * e->convergence, ratio);
        go_on(e);
        if (size * fmin(1, e->convergence) <= e->share) {
            combine(e, 2, (double[]){1 / gamma, -1 / gamma}, (double *[]){e->stage, e->base}, rates);
            return ESDIRK_DONE;
        }
        was = due;
        due = ratio > SLOW ? MATRIX_ANEW : MATRIX_STAYS;
        before = size;
    }
    return ESDIRK_NO_NEWTON;
}

/* ------------------------------------------------------------------------------------------------- a step */

/* Place of a node, in steps of length h from the beginning of this one. */
static double node_at(const Esdirk *e, int node, double h)
{
    return node >= 0 ? tableau.c[node] : (tableau.c[ESDIRK_BEFORE(node)] - 1) * e->last / h;
}

/* Rates of stage i from those of its nodes by the polynomial through them (OS8). */
static void guess(Esdirk *e, int i, double h)
{
    int n = 0;
    double at[ESDIRK_NODES], share[ESDIRK_NODES], *x[ESDIRK_NODES];
    for (int k = 0; k < ESDIRK_NODES; ++k) {
        const int node = tableau.node[i][k];
        if (node < 0 && !e->past) continue;
        at[n] = node_at(e, node, h);
        x[n++] = node >= 0 ? e->rate[e->now][node] : e->rate[!e->now][ESDIRK_BEFORE(node)];
    }
    for (int k = 0; k < n; ++k) {
        share[k] = 1;
        for (int j = 0; j < n; ++j) {
            if (j != k) share[k] *= (tableau.c[i] - at[j]) / (at[k] - at[j]);
        }
    }
    combine(e, n, share, x, e->rate[e->now][i]);
}

/* Solves all stages of a step of length h, none beyond `stop`; e->stage is its end, e->error its error (OS2), (OS3). */
static EsdirkEnd stages_solve(Esdirk *e, double t, double h, double stop)
{
    double *x[ESDIRK_STAGES + 1] = {e->y}, share[ESDIRK_STAGES + 1] = {1};
    double *const *const rate = e->rate[e->now];
    for (int i = 1; i < ESDIRK_STAGES; ++i) {
        for (int j = 0; j < i; ++j) {
            share[j + 1] = h * tableau.a[i][j];
            x[j + 1] = rate[j];
        }
        combine(e, i + 1, share, x, e->base);
        guess(e, i, h);
        const EsdirkEnd end = stage_solve(e, i, fmin(t + tableau.c[i] * h, stop), h * tableau.gamma);
        if (end) return end;
    }
    const double *const b = tableau.a[ESDIRK_STAGES - 1];
    for (int j = 0; j < ESDIRK_STAGES; ++j) share[j] = h * (b[j] - tableau.embedded[j]);
    combine(e, ESDIRK_STAGES, share, rate, e->error);
    return ESDIRK_DONE;
}

/* The factor for the next step's length from this one's error (OS9). */
static double step_factor(const Esdirk *e, double error)
{
    const double now = fmax(error, 1e-10), before = e->past ? fmax(e->error_before, 1e-10) : now;
    const double factor = SAFETY * pow(now, -INTEGRAL / ESDIRK_ORDER) * pow(before, PROPORTIONAL / ESDIRK_ORDER);
    return fmin(fmax(factor, SHRINK_MOST), GROW_MOST);
}

/* Begins at y, whose rates are not known yet: a first step limited by the rates, or a share of the allowed one if they
 * are zero. */
static EsdirkEnd begin(Esdirk *e, double t, double most)
{
    double *const rates = e->rate[e->now][0];
    if (e->begun) return ESDIRK_DONE;
    if (rates_at(e, t, e->y, rates)) return ESDIRK_NO_RATES;
    e->begun = 1;
    const double first = e->motion->scene->def.solver.first_step, speed = norm_of(e, rates);
    if (!(e->next > 0)) e->next = first > 0 ? first : fmin(FIRST / speed, most / 100);
    return ESDIRK_DONE;
}

/* Makes the tried step the state: its last rates are the first of the next step. */
static void accept(Esdirk *e, double h, double error)
{
    memcpy(e->y, e->stage, (size_t)e->size * sizeof *e->y);
    if (e->motion->ops->project) {
        e->motion->ops->project(e->motion, e->y, e->correction, NULL);
        combine(e, 2, (double[]){1, 1}, (double *[]){e->y, e->correction}, e->y);
    }
    e->now = !e->now;
    memcpy(e->rate[e->now][0], e->rate[!e->now][ESDIRK_STAGES - 1], (size_t)e->size * sizeof *e->y);
    e->past = 1;
    e->last = h;
    e->error_before = error;
    e->stats->last_step = h;
    ++e->stats->steps;
}

/* Decides whether a step of length h with solved stages is accepted. One that was cut short is no argument against
 * longer ones. */
static int judge(Esdirk *e, double h)
{
    const double error = norm_of(e, e->error), factor = step_factor(e, error);
    if (!(error <= 1)) {
        ++e->stats->error_fails;
        e->next = h * (error < INFINITY ? fmin(factor, STAYS_FROM) : SHRINK_MOST);
        return 0;
    }
    const double next = factor > STAYS_FROM && factor < STAYS_TO ? h : h * factor;
    if (!(h < e->next) || next > e->next || factor < 1) e->next = next;
    accept(e, h, error);
    return 1;
}

/* Length of the step to try, `left` before the stop: if it would leave almost nothing it is extended to the stop, and a
 * rest of less than two steps is halved. Rates come from differences over a step (OS6), and in one as short as a
 * rounding error they would be lost. */
static double length_of(const Esdirk *e, double left)
{
    const double next = e->longest > 0 ? fmin(e->next, e->longest) : e->next;
    if (next >= (1 - 1e-6) * left) return left;
    return 2 * next > left ? left / 2 : next;
}

EsdirkEnd esdirk_step(Esdirk *e, double stop, double *t)
{
    const double left = stop - *t;
    EsdirkEnd end = begin(e, *t, e->longest > 0 ? fmin(e->longest, left) : left);
    for (int attempt = 0; !end && attempt < ATTEMPTS_MOST; ++attempt) {
        const double h = length_of(e, left), reached = h < left ? *t + h : stop;
        if (!(reached > *t)) return ESDIRK_STUCK;
        const EsdirkEnd found = stages_solve(e, *t, h, stop);
        if (!found && judge(e, h)) {
            *t = reached;
            return ESDIRK_DONE;
        }
        if (!found) continue;
        ++e->stats->newton_fails;
        e->gamma = 0;
        e->next = h * RETRY;
        if (attempt == ATTEMPTS_MOST - 1 || found == ESDIRK_NO_MEMORY) end = found;
    }
    return end ? end : ESDIRK_INEXACT;
}

double esdirk_next(const Esdirk *e) { return e->next; }
const double *esdirk_error(const Esdirk *e) { return e->error; }
const double *esdirk_rates(const Esdirk *e) { return e->rate[e->now][0]; }

/* ------------------------------------------------------------------------------------------------- changes */

int esdirk_reshape(Esdirk *e, const Reshape *reshape, const double *weight)
{
    double *const old = e->room;
    const double *const rates = e->rate[e->now][0];
    e->room = NULL;
    const int ok = vectors_new(e);
    if (ok && e->begun && !reshape->forget) reshape->map(reshape->user, 0, rates, e->rate[e->now][0]);
    free(old);
    e->begun = e->begun && !reshape->forget;
    e->past = 0;
    e->gamma = 0;
    e->y = reshape->y;
    e->weight = weight;
    return ok;
}

void esdirk_checkpoint(Checkpoint *c, Esdirk *e)
{
    const size_t bytes = (size_t)e->size * sizeof *e->y;
    CHECKPOINT(c, e->now);
    if (!checkpoint_check(c, e->now == 0 || e->now == 1, "its stages are impossible")) return;
    CHECKPOINT_FROM(c, e, Esdirk, begun);
    checkpoint_longs(c, 1, &e->matrix_step);
    for (int i = 0; i < 2 * ESDIRK_STAGES; ++i)
        checkpoint_put(c, "rates of a stage", e->rate[i / ESDIRK_STAGES][i % ESDIRK_STAGES], bytes);
}
