#include "sim/run/tangent.h"

#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "sim/equipment/reel.h"
#include "sim/equipment/winch.h"
#include "sim/run/modes.h"

/* The scene with one parameter smaller and larger. */
typedef struct Pair {
    Stage less, more;
    double half;           /* half the difference of the parameter */
    double *now, *before;  /* [size] dy/dp at the last two steps */
    double *slope, *rates; /* [figures] at the last step; [size] scratch */
} Pair;

/* s, at most: the step that acts as infinity in the matrix of an equilibrium (RD8), (RD23). */
static const double LONG = 1e5;

struct Tangent {
    Stage base;
    int n, size, begun;
    Pair *pair; /* [n] */
    double t, h, from;
    double *rates, *shifted, *look[2]; /* [size], [size], [figures] scratch */
    double *value;                     /* [figures] at the last step */
    TangentFigures figures;
};

/* Part of the scene that keeps data from step to step beside (t, y), or changes the state's length: its name, or
 * NULL. */
static const char *tangent_unknown(const Stage *st)
{
    const Scene *const s = &st->scene;
    if (s->def.analysis.kind == ANALYSIS_POSITIONS) return "positions";
    if (s->def.rod.present) return "a rod";
    if (s->reel->present || s->winch->take_in.present) return "a reel or a winch that takes in";
    if (s->winch->mode != WINCH_SPEED) return "a winch of set tension";
    if (s->def.winch.trip.force > 0 || s->def.winch.trip.factor > 0) return "a winch that trips";
    if (s->def.n_jams > 0) return "jams";
    if (s->def.n_script > 0) return "a script";
    if (s->chain.sliders.count > 0) return "bending with hysteresis";
    if (s->self.present) return "cable on cable";
    for (int k = 0; k < PARTS; ++k) {
        if (st->ws.contact[k].sticks) return "friction that sticks";
    }
    return NULL;
}

/* ---------------------------------------------------------------------------------------------------------- figures */

/* Zeroed figures for a stage's scene; 0 without memory: free it either way. */
static int tangent_figures_make(const Stage *st, int parameters, TangentFigures *f)
{
    *f = (TangentFigures){.stations = st->scene.def.n_stations, .rollers = st->scene.def.n_rollers};
    f->n = 1 + f->stations + f->rollers;
    f->value = calloc((size_t)f->n, sizeof(double));
    f->slope = calloc((size_t)f->n * (size_t)parameters + 1, sizeof(double));
    f->at_station = calloc((size_t)f->stations + 1, sizeof(int));
    return f->value && f->slope && f->at_station;
}

static void tangent_figures_free(TangentFigures *f)
{
    free(f->value);
    free(f->slope);
    free(f->at_station);
}

void tangent_figures_look(const TangentFigures *f, Stage *st, double t, const double *y, double *figure)
{
    const MotionOps *const ops = st->motion->ops;
    ops->look(st->motion, t, y, 1);
    for (int i = 0; i < f->stations; ++i) figure[1 + i] = st->ws.law[0][f->at_station[i]];
    for (int i = 0; i < f->rollers; ++i) figure[1 + f->stations + i] = v3_norm(st->ws.on_roller[i]);
    figure[0] = ops->winch_pull(st->motion, t, y);
}

/* The segment whose centre is nearest to a point. */
static int tangent_nearest(const Stage *st, const double *y, Vec3 at)
{
    int nearest = 0;
    double least = INFINITY;
    for (int k = 0; k < st->scene.chain.n; ++k) {
        const double away = v3_norm(v3_sub(st->motion->ops->place(st->motion, y, k), at));
        if (away >= least) continue;
        least = away;
        nearest = k;
    }
    return nearest;
}

/* Finds the segments that pass the stations in y; the figures [f->n] of (t, y). */
static void tangent_stations_find(const Stage *st, const double *y, TangentFigures *f)
{
    for (int i = 0; i < f->stations; ++i)
        f->at_station[i] = tangent_nearest(st, y, route_at(&st->scene.route, st->scene.def.stations[i].s).position);
}

/* ------------------------------------------------------------------------------------------------------------- life */

static hawser_status stage_make(const SceneDef *def, Stage *st, int size, hawser_error *err)
{
    const hawser_status status = stage_new(st, def, NULL, err);
    if (status || size == 0 || st->motion->size == size) return status;
    return error_set(err, HAWSER_ERR_INPUT, "a parameter that changes the number of segments has no derivative");
}

static hawser_status arrays_make(Tangent *g, hawser_error *err)
{
    TangentFigures *const f = &g->figures;
    const int made = tangent_figures_make(&g->base, g->n, f);
    const size_t m = (size_t)f->n;
    g->value = calloc(m, sizeof(double));
    g->look[0] = calloc(m, sizeof(double));
    g->look[1] = calloc(m, sizeof(double));
    g->rates = aligned_array_new(g->size);
    g->shifted = aligned_array_new(g->size);
    int fine = made && g->value && g->look[0] && g->look[1] && g->rates && g->shifted;
    for (int k = 0; k < g->n; ++k) {
        Pair *const p = &g->pair[k];
        p->now = aligned_array_new(g->size);
        p->before = aligned_array_new(g->size);
        p->rates = aligned_array_new(g->size);
        p->slope = calloc(m, sizeof(double));
        fine = fine && p->now && p->before && p->rates && p->slope;
    }
    return fine ? HAWSER_OK : error_memory(err);
}

hawser_status tangent_new(const SceneDef *base, int n, const SceneDef *less, const SceneDef *more, const double *half,
                          double from, Tangent **out, hawser_error *err)
{
    Tangent *const g = calloc(1, sizeof *g);
    *out = NULL;
    if (!g) return error_memory(err);
    g->from = from;
    g->pair = calloc((size_t)n + 1, sizeof *g->pair);
    hawser_status status = g->pair ? stage_make(base, &g->base, 0, err) : error_memory(err);
    const char *const unknown = status ? NULL : tangent_unknown(&g->base);
    if (unknown) status = error_set(err, HAWSER_ERR_INPUT, "sensitivities of a run with %s are not known", unknown);
    g->size = status ? 0 : g->base.motion->size;
    for (; g->n < n && !status; ++g->n) {
        g->pair[g->n].half = half[g->n];
        status = stage_make(&less[g->n], &g->pair[g->n].less, g->size, err);
        if (!status) status = stage_make(&more[g->n], &g->pair[g->n].more, g->size, err);
    }
    if (!status) status = arrays_make(g, err);
    if (status) tangent_free(g);
    if (!status) *out = g;
    return status;
}

Tangent *tangent_free(Tangent *g)
{
    if (!g) return NULL;
    stage_free(&g->base);
    for (int k = 0; k < g->n; ++k) {
        stage_free(&g->pair[k].less);
        stage_free(&g->pair[k].more);
        free(g->pair[k].now);
        free(g->pair[k].before);
        free(g->pair[k].rates);
        free(g->pair[k].slope);
    }
    free(g->pair);
    free(g->rates);
    free(g->shifted);
    free(g->look[0]);
    free(g->look[1]);
    free(g->value);
    tangent_figures_free(&g->figures);
    free(g);
    return NULL;
}

/* ------------------------------------------------------------------------------------------------------- the start */

/* Rates and blocks without friction, as in the search for equilibrium (E1). 0, or nonzero if not finite. */
static int rest_rates(Stage *st, double t, const double *y, double *rates)
{
    if (st->motion == &st->planar.motion) return planar_evaluate(&st->planar, t, y, 0, rates);
    dynamics_rates(&st->scene, &st->ws, t, y, 0, rates);
    return 0;
}

static void rest_linearise(Stage *st, double t, const double *y, const double *rates)
{
    if (st->motion == &st->planar.motion) {
        planar_blocks(&st->planar, t, y, 0);
        return;
    }
    dynamics_blocks(&st->scene, &st->ws, t, y, rates, 0, &st->newton.k, &st->newton.d);
    newton_point(&st->newton, &st->scene, &st->ws.kin, y);
    newton_point_equipment(&st->newton, st->ws.equipment, y, 0);
}

/* Number of entries of y that are places and attitudes of the chain: they come first, its speeds behind them. *speeds:
 * number of those. */
static size_t places(const Stage *st, size_t *speeds)
{
    const int planar = st->motion == &st->planar.motion;
    const size_t pitch = (size_t)(planar ? planar_stride(st->scene.chain.n) : st->scene.chain.n);
    const size_t from = planar ? PLANAR_V : STATE_V, to = planar ? PLANAR_SIZE : STATE_SIZE;
    *speeds = (to - from) * pitch;
    return from * pitch;
}

/* gamma f_p at equilibrium, of any size: both scenes without friction, with the contacts found there. */
static hawser_status rest_pushes(Tangent *g, Pair *p, double t, const double *rest, double gamma, double *b,
                                 hawser_error *err)
{
    hawser_status status = p->less.motion->ops->renew(p->less.motion, t, rest, err);
    if (!status) status = p->more.motion->ops->renew(p->more.motion, t, rest, err);
    if (status) return status;
    if (rest_rates(&p->less, t, rest, g->shifted) || rest_rates(&p->more, t, rest, p->rates))
        return error_set(err, HAWSER_ERR_RUN, "the run's start has no finite rates");
    for (int i = 0; i < g->size; ++i) b[i] = gamma * (p->rates[i] - g->shifted[i]) / (2 * p->half);
    return HAWSER_OK;
}

/* Converts the result of linsolver_factor for a step's matrix to an error. */
static hawser_status solver_failed(int bad, double t, hawser_error *err)
{
    if (bad < 0) return error_memory(err);
    return error_set(err, HAWSER_ERR_RUN, "the matrix of the sensitivities is singular at %g s", t);
}

/* dy/dp of the equilibrium from which the run begins (SN13): one solution with the statics' matrix for each parameter.
 * Only places depend on it. */
static hawser_status relaxed_slopes(Tangent *g, double t, const double *y, hawser_error *err)
{
    Motion *const m = g->base.motion;
    const double infinite = fmin(LONG, 1 / sqrt(modes_rounding(&g->base.scene.chain, 0)));
    double *const rest = aligned_array_new(g->size);
    size_t speeds;
    const size_t where = places(&g->base, &speeds);
    if (!rest) return error_memory(err);
    memcpy(rest, y, (size_t)g->size * sizeof *rest);
    memset(rest + where, 0, speeds * sizeof *rest);
    hawser_status status = m->ops->renew(m, t, rest, err);
    int singular = !status && rest_rates(&g->base, t, rest, g->rates);
    if (!status && !singular) {
        rest_linearise(&g->base, t, rest, g->rates);
        m->ops->form(m, infinite);
        singular = m->ops->factor(m);
    }
    for (int k = 0; k < g->n && !status && !singular; ++k) {
        Pair *const p = &g->pair[k];
        status = rest_pushes(g, p, t, rest, infinite, p->before, err);
        if (!status) singular = m->ops->solve(m, p->before);
        if (!status && !singular) memcpy(p->now, p->before, where * sizeof *rest);
    }
    free(rest);
    if (!status && singular) status = solver_failed(singular, t, err);
    return status ? status : m->ops->renew(m, t, y, err);
}

/* dy/dp at the run's beginning: of the initial shape and speeds, and of the equilibrium. */
static hawser_status start_slopes(Tangent *g, double t, const double *y, hawser_error *err)
{
    for (int k = 0; k < g->n; ++k) {
        Pair *const p = &g->pair[k];
        for (int i = 0; i < g->size; ++i) p->now[i] = (p->more.y[i] - p->less.y[i]) / (2 * p->half);
    }
    return g->base.scene.def.solver.relax ? relaxed_slopes(g, t, y, err) : HAWSER_OK;
}

/* -------------------------------------------------------------------------------------------------------- the steps */

/* Rates at (t, y), with the contact candidates found there. */
static hawser_status rates_at(Stage *st, double t, const double *y, double *rates, hawser_error *err)
{
    const MotionOps *const ops = st->motion->ops;
    if (ops->rates(st->motion, t, y, rates))
        return error_set(err, HAWSER_ERR_RUN, "the equations of motion have no finite rates at %g s", t);
    const hawser_status status = ops->accept(st->motion, t, y, err);
    if (!status) ops->rates(st->motion, t, y, rates);
    return status;
}

/* (SN10): b = c0 s + c1 s' + gamma f_p, then the matrix of the step. gamma, c0 and c1 by (SN11). */
static hawser_status pair_step(Tangent *g, Pair *p, double t, const double *y, double gamma, double c0, double c1,
                               hawser_error *err)
{
    hawser_status status = rates_at(&p->more, t, y, p->rates, err);
    if (!status) status = rates_at(&p->less, t, y, g->shifted, err);
    if (status) return status;
    double *const b = p->before;
    for (int i = 0; i < g->size; ++i) {
        const double by_parameter = (p->rates[i] - g->shifted[i]) / (2 * p->half);
        b[i] = c0 * p->now[i] + c1 * b[i] + gamma * by_parameter;
    }
    const int bad = g->base.motion->ops->solve(g->base.motion, b);
    if (bad) return solver_failed(bad, t, err);
    p->before = p->now;
    p->now = b;
    return HAWSER_OK;
}

/* (SN12) */
static void pair_look(Tangent *g, Pair *p, double t, const double *y)
{
    for (int side = 0; side < 2; ++side) {
        const double by = side ? p->half : -p->half;
        for (int i = 0; i < g->size; ++i) g->shifted[i] = y[i] + by * p->now[i];
        tangent_figures_look(&g->figures, side ? &p->more : &p->less, t, g->shifted, g->look[side]);
    }
    for (int i = 0; i < g->figures.n; ++i) p->slope[i] = (g->look[1][i] - g->look[0][i]) / (2 * p->half);
}

/* Adds to the means over time: each step's figures, weighted by its length. */
static void figures_take(Tangent *g, double t, const double *y)
{
    TangentFigures *const f = &g->figures;
    const double h = fmin(g->h, t - g->from);
    if (!(h > 0)) return;
    const double share = h / (f->seconds + h);
    tangent_stations_find(&g->base, y, f);
    tangent_figures_look(f, &g->base, t, y, g->value);
    for (int i = 0; i < f->n; ++i) f->value[i] += share * (g->value[i] - f->value[i]);
    for (int k = 0; k < g->n; ++k) {
        double *const slope = f->slope + (size_t)k * (size_t)f->n;
        pair_look(g, &g->pair[k], t, y);
        for (int i = 0; i < f->n; ++i) slope[i] += share * (g->pair[k].slope[i] - slope[i]);
    }
    f->seconds += h;
}

hawser_status tangent_step(Tangent *g, double t, const double *y, hawser_error *err)
{
    Motion *const m = g->base.motion;
    hawser_status status = rates_at(&g->base, t, y, g->rates, err);
    const double h = t - g->t, before = g->h;
    if (status || !g->begun || !(h > 0)) {
        if (!status && !g->begun) status = start_slopes(g, t, y, err);
        g->begun = 1;
        g->t = t;
        return status;
    }
    const double w = before > 0 ? h / before : 0, over = 1 + 2 * w; /* the first step: w = 0, implicit Euler */
    const double gamma = h * (1 + w) / over, c0 = (1 + w) * (1 + w) / over, c1 = -w * w / over;
    m->ops->linearise(m, t, y, g->rates);
    m->ops->form(m, gamma);
    const int bad = m->ops->factor(m);
    if (bad) return solver_failed(bad, t, err);
    for (int k = 0; k < g->n && !status; ++k) status = pair_step(g, &g->pair[k], t, y, gamma, c0, c1, err);
    g->t = t;
    g->h = h;
    if (!status) figures_take(g, t, y);
    return status;
}

const TangentFigures *tangent_figures(const Tangent *g) { return &g->figures; }

const double *tangent_slope(const Tangent *g, int k) { return g->pair[k].now; }

/* Derivatives of a steady position's figures by any number of parameters, with the transposed matrix of the forces.
 * docs/theory/92-sensitivities.md, "Changes of a position". */

/* Size by which a segment is moved (m) and rotated (rad) for the derivatives of figures: tensions are almost linear,
 * also with a stiff cable, loads of rollers are curved. */
static const double FOR_TENSION[2] = {1e-4, 1e-4}, FOR_LOAD[2] = {4e-7, 1e-6};

/* Every APART-th segment is moved at once: a change of a figure is due to the one nearest to it. */
enum { APART = 64 };

struct Position {
    Stage st; /* in space */
    double t;
    TangentFigures figures;
    int *at;                       /* [figures] the segment nearest to each */
    double *look[4];               /* [figures] scratch */
    double *rates, *other, *moved; /* [size] scratch */
    double *weight;                /* [figures][6 n]: N per newton, or newton metre, on each segment (SN16) */
    double *right;                 /* [figures][6 n] scratch */
};

/* Creates a stage in space at (t, y). */
static hawser_status stage_at(const SceneDef *def, double t, const double *y, Stage *st, hawser_error *err)
{
    SceneDef plain = *def;
    plain.solver.linear.kind = LIN_AUTO;
    hawser_status status = stage_new(st, &plain, NULL, err);
    if (!status) status = stage_to_space(st, "a position's derivatives", err);
    if (status) return status;
    st->t = t;
    memcpy(st->y, y, (size_t)st->motion->size * sizeof *y);
    return st->motion->ops->renew(st->motion, t, st->y, err);
}

/* -K - D/g + M/g^2 of the linearisation point, transposed (SN15). */
static void matrix_turned(const Newton *nw, double g, BlockChain *a)
{
    for (int i = 0; i < nw->n; ++i) {
        for (int c = 0; c < 6; ++c) {
            for (int r = 0; r < 6; ++r) {
                const int from = 36 * i + 6 * c + r, to = 36 * i + 6 * r + c;
                a->diag[to] = -nw->k.diag[from] - nw->d.diag[from] / g;
                if (i > 0) a->upper[to - 36] = -nw->k.lower[from] - nw->d.lower[from] / g;
                if (i + 1 < nw->n) a->lower[to + 36] = -nw->k.upper[from] - nw->d.upper[from] / g;
            }
        }
        for (int c = 0; c < 3; ++c) {
            a->diag[36 * i + 7 * c] += nw->mass[i] / (g * g);
            for (int r = 0; r < 3; ++r) a->diag[36 * i + 6 * (3 + r) + 3 + c] += nw->inertia[3 * r + c][i] / (g * g);
        }
    }
}

/* y with every APART-th segment from `first` on moved or rotated by `by` along coordinate c of 0 .. 5. */
static void move(const Position *p, int first, int c, double by, double *y)
{
    const int n = p->st.scene.chain.n;
    const Vec3 along = {c % 3 == 0 ? by : 0, c % 3 == 1 ? by : 0, c % 3 == 2 ? by : 0};
    memcpy(y, p->st.y, (size_t)p->st.motion->size * sizeof *y);
    for (int i = first; i < n; i += APART) {
        if (c < 3) {
            y[(STATE_P + c) * n + i] += by;
            continue;
        }
        const Quat q = quat_mul(quat_exp(along), state_attitude(y, n, i));
        const double part[4] = {q.w, q.x, q.y, q.z};
        for (int k = 0; k < 4; ++k) y[(STATE_Q + k) * n + i] = part[k];
    }
}

/* The segment of every APART-th from `first` on that is nearest to segment `at`. */
static int nearest_of(int n, int first, int at)
{
    const int behind = at - first + APART / 2, most = (n - 1 - first) / APART;
    const int k = behind < 0 ? 0 : behind / APART;
    return first + APART * (k > most ? most : k);
}

/* dg/dx of the figures from .. to-1 into p->weight, by central differences of fourth order. */
static void figures_slopes(Position *p, int from, int to, const double by[2])
{
    static const double at[4] = {-2, -1, 1, 2};
    const int n = p->st.scene.chain.n;
    double *const *const g = p->look;
    for (int first = 0; first < APART && first < n; ++first) {
        for (int c = 0; c < 6; ++c) {
            const double h = by[c / 3];
            for (int k = 0; k < 4; ++k) {
                move(p, first, c, at[k] * h, p->moved);
                tangent_figures_look(&p->figures, &p->st, p->t, p->moved, g[k]);
            }
            for (int f = from; f < to; ++f) {
                double *const of = p->weight + (size_t)f * 6 * (size_t)n;
                of[6 * nearest_of(n, first, p->at[f]) + c] = (8 * (g[2][f] - g[1][f]) - (g[3][f] - g[0][f])) / (12 * h);
            }
        }
    }
}

/* Place of each figure: the winch's end, its station, its roller. */
static void places_find(Position *p)
{
    TangentFigures *const f = &p->figures;
    const Stage *const st = &p->st;
    tangent_stations_find(st, st->y, f);
    p->at[0] = st->scene.chain.n - 1;
    for (int i = 0; i < f->stations; ++i) p->at[1 + i] = f->at_station[i];
    for (int i = 0; i < f->rollers; ++i)
        p->at[1 + f->stations + i] = tangent_nearest(st, st->y, st->scene.rollers[i].shape.centre);
}

/* r += K^T w: residual of a solution with the whole matrix (SN16). */
static void stiffness_add(const BlockChain *k, const double *w, double *r)
{
    for (int i = 0; i < k->n; ++i) {
        for (int c = 0; c < 36; ++c) {
            const int row = c % 6, column = c / 6, at = 36 * i + c;
            const double force = w[6 * i + row];
            r[6 * i + column] += k->diag[at] * force;
            if (i > 0) r[6 * (i - 1) + column] += k->lower[at] * force;
            if (i + 1 < k->n) r[6 * (i + 1) + column] += k->upper[at] * force;
        }
    }
}

/* Turns p->weight from dg/dx into the response of each figure to forces: one solution each, and one for the residual
 * due to damping (SN16). */
static hawser_status weights_solve(Position *p, hawser_error *err)
{
    Stage *const st = &p->st;
    const LinOptions one = {.kind = LIN_AUTO, .threads = 1};
    const double g = fmin(LONG, 1 / sqrt(modes_rounding(&st->scene.chain, 0)));
    BlockChain a;
    LinSolver *solver = NULL;
    if (!block_chain_alloc(&a, st->scene.chain.n, 6)) return error_memory(err);
    st->motion->ops->rates(st->motion, p->t, st->y, p->rates);
    st->motion->ops->linearise(st->motion, p->t, st->y, p->rates);
    matrix_turned(&st->newton, g, &a);
    figures_slopes(p, 0, 1 + p->figures.stations, FOR_TENSION);
    figures_slopes(p, 1 + p->figures.stations, p->figures.n, FOR_LOAD);
    solver = linsolver_new(&a, &one, err);
    hawser_status status = solver ? HAWSER_OK : err->status;
    const int m = p->figures.n, n = 6 * st->scene.chain.n;
    memcpy(p->right, p->weight, (size_t)m * (size_t)n * sizeof *p->right);
    int singular = status ? 0 : linsolver_factor(solver, &a);
    if (!status && !singular) singular = linsolver_solve_many(solver, m, p->weight);
    if (!status && !singular) {
        for (int f = 0; f < m; ++f)
            stiffness_add(&st->newton.k, p->weight + (size_t)f * (size_t)n, p->right + (size_t)f * (size_t)n);
        singular = linsolver_solve_many(solver, m, p->right);
        for (size_t i = 0; i < (size_t)m * (size_t)n; ++i) p->weight[i] += p->right[i];
    }
    if (singular < 0) status = error_memory(err);
    if (singular > 0) status = error_set(err, HAWSER_ERR_RUN, "the matrix of the position is singular");
    linsolver_free(solver);
    block_chain_free(&a);
    return status;
}

/* Part of the scene for which the matrix is not a block chain, or which tangents do not cover; NULL: none. */
static const char *unknown_part(const Stage *st)
{
    const char *const unknown = tangent_unknown(st);
    if (unknown) return unknown;
    if (st->scene.equipment->n > 0) return "rollers that spin or stand on mounts";
    return st->newton.extra || st->newton.leaves ? "segments that touch each other" : NULL;
}

hawser_status position_new(const SceneDef *base, double t, const double *y, Position **out, hawser_error *err)
{
    Position *const p = calloc(1, sizeof *p);
    *out = NULL;
    if (!p) return error_memory(err);
    p->t = t;
    hawser_status status = stage_at(base, t, y, &p->st, err);
    const char *const unknown = status ? NULL : unknown_part(&p->st);
    if (unknown)
        status = error_set(err, HAWSER_ERR_INPUT, "sensitivities of a position with %s are not known", unknown);
    if (!status) {
        const int size = p->st.motion->size, made = tangent_figures_make(&p->st, 0, &p->figures);
        const size_t m = (size_t)p->figures.n;
        p->at = calloc(m, sizeof *p->at);
        int looks = 0;
        while (looks < 4 && (p->look[looks] = calloc(m, sizeof(double)))) ++looks;
        p->rates = aligned_array_new(size);
        p->other = aligned_array_new(size);
        p->moved = aligned_array_new(size);
        p->weight = calloc(m * 6 * (size_t)p->st.scene.chain.n, sizeof(double));
        p->right = calloc(m * 6 * (size_t)p->st.scene.chain.n, sizeof(double));
        if (!p->right || !made || !p->at || looks < 4 || !p->rates || !p->other || !p->moved || !p->weight)
            status = error_memory(err);
    }
    if (!status) {
        places_find(p);
        tangent_figures_look(&p->figures, &p->st, t, p->st.y, p->figures.value);
        status = weights_solve(p, err);
    }
    if (status) position_free(p);
    if (!status) *out = p;
    return status;
}

Position *position_free(Position *p)
{
    if (!p) return NULL;
    stage_free(&p->st);
    tangent_figures_free(&p->figures);
    free(p->at);
    for (int k = 0; k < 4; ++k) free(p->look[k]);
    free(p->rates);
    free(p->other);
    free(p->moved);
    free(p->weight);
    free(p->right);
    free(p);
    return NULL;
}

const TangentFigures *position_figures(const Position *p) { return &p->figures; }

/* Rates and figures at the same place of the scene with a slightly smaller or larger parameter. */
static hawser_status side_look(const Position *p, const SceneDef *def, double *rates, double *look, hawser_error *err)
{
    Stage st = {0};
    hawser_status status = stage_new(&st, def, NULL, err);
    const int same = !status && st.scene.chain.n == p->st.scene.chain.n &&
                     st.scene.def.n_rollers == p->figures.rollers && st.scene.def.n_stations == p->figures.stations;
    stage_free(&st);
    st = (Stage){0};
    if (!status && !same)
        status = error_set(err, HAWSER_ERR_INPUT, "a parameter that changes the number of segments has no derivative");
    if (!status) status = stage_at(def, p->t, p->st.y, &st, err);
    if (!status && st.motion->ops->rates(st.motion, p->t, st.y, rates))
        status = error_set(err, HAWSER_ERR_RUN, "the position has no finite rates");
    if (!status) tangent_figures_look(&p->figures, &st, p->t, st.y, look);
    stage_free(&st);
    return status;
}

hawser_status position_by(Position *p, const SceneDef *less, const SceneDef *more, double half, double *slope,
                          hawser_error *err)
{
    const Newton *const nw = &p->st.newton;
    const int n = nw->n;
    hawser_status status = side_look(p, less, p->rates, p->look[0], err);
    if (!status) status = side_look(p, more, p->other, p->look[1], err);
    if (status) return status;
    double *const force = p->moved; /* [6 n] (SN14): M da/dp */
    for (int i = 0; i < n; ++i) {
        double by[6];
        for (int c = 0; c < 6; ++c) {
            const int at = (STATE_V + c) * n + i;
            by[c] = (p->other[at] - p->rates[at]) / (2 * half);
        }
        for (int c = 0; c < 3; ++c) {
            force[6 * i + c] = nw->mass[i] * by[c];
            force[6 * i + 3 + c] =
                nw->inertia[3 * c][i] * by[3] + nw->inertia[3 * c + 1][i] * by[4] + nw->inertia[3 * c + 2][i] * by[5];
        }
    }
    for (int f = 0; f < p->figures.n; ++f) {
        const double *const w = p->weight + (size_t)f * 6 * (size_t)n;
        slope[f] = (p->look[1][f] - p->look[0][f]) / (2 * half);
        for (int i = 0; i < 6 * n; ++i) slope[f] += w[i] * force[i];
    }
    return HAWSER_OK;
}
