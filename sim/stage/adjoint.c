/* Derivatives of a steady position's figures by any number of parameters, with the transposed matrix of the forces.
 * docs/model/92-sensitivities.md, "Changes of a position". */
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "sim/stage/modes.h"
#include "sim/stage/tangent.h"

/* s, at most: the step that stands for infinity in the matrix of an equilibrium (RD8), (RD23). */
static const double LONG = 1e5;
/* How far a segment is moved (m) and turned (rad) to see what a figure makes of it: tensions are all but linear and of
 * a stiff cable, loads of rollers curved. */
static const double FOR_TENSION[2] = {1e-4, 1e-4}, FOR_LOAD[2] = {4e-7, 1e-6};
/* Every so many-th segment is moved at once: what a figure makes of it comes from the one that is nearest to it. */
enum { APART = 64 };

struct Position {
    Stage st; /* in space */
    double t;
    TangentFigures figures;
    int *at;                       /* [figures] the segment nearest to each */
    double *look[4];               /* [figures] scratch */
    double *rates, *other, *moved; /* [size] scratch */
    double *weight;                /* [figures][6 n]: N for a newton, or a newton metre, on each segment (SN16) */
    double *right;                 /* [figures][6 n] scratch */
};

/* A stage in space that stands at (t, y). */
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

/* y with every APART-th segment from `first` on moved, or turned, by `by` along coordinate c of 0 .. 5. */
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

/* Where each figure is: the winch's end, its station, its roller. */
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

/* r += K^T w: what a solution with the whole matrix leaves of (SN16). */
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

/* p->weight from dg/dx to what a force makes of each figure: one solution each, and one of what damping has left in it
 * (SN16). */
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

/* What its matrix is not a block chain for, or what tangents do not know; NULL: nothing. */
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

/* The scene with a little less or more of the parameter: its rates and figures at the same place. */
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
