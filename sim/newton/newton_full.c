#include "sim/newton/newton_data.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "core/base/vec3.h"

enum { P = STATE_P, Q = STATE_Q, U = STATE_V, SIZE = STATE_SIZE };

struct NewtonFull {
    SparseMatrix a;
    LinSolver *solver;
    double *x; /* [13n] in the matrix's order */
};

/* Whether the block of row segment i and column segment k has an entry at (r, c): the kinematic rows stay within their
 * own segment. */
static int is_entry(int own, int r, int c)
{
    if (r >= U) return 1;
    if (!own) return 0;
    if (r < Q) return c == r || c == r + U;
    return (c >= Q && c < U) || c >= STATE_W;
}

/* Column pointers and rows; with rows NULL only counts. Returns the number of entries. */
static int pattern_fill(int n, int *p, int *rows)
{
    int count = 0;
    for (int k = 0; k < n; ++k) {
        for (int c = 0; c < SIZE; ++c) {
            if (p) p[SIZE * k + c] = count;
            for (int i = k > 0 ? k - 1 : 0; i <= k + 1 && i < n; ++i) {
                for (int r = 0; r < SIZE; ++r) {
                    if (!is_entry(i == k, r, c)) continue;
                    if (rows) rows[count] = SIZE * i + r;
                    ++count;
                }
            }
        }
    }
    if (p) p[SIZE * n] = count;
    return count;
}

hawser_status newton_full_new(const Newton *nw, const LinOptions *options, NewtonFull **out, hawser_error *err)
{
    const int n = nw->n, count = pattern_fill(n, NULL, NULL);
    assert(count > 0);
    NewtonFull *f = calloc(1, sizeof *f);
    *out = f;
    if (!f) return error_memory(err);
    f->a = (SparseMatrix){.n = SIZE * n,
                          .p = malloc(((size_t)(SIZE * n) + 1) * sizeof(int)),
                          .i = malloc((size_t)count * sizeof(int)),
                          .x = calloc((size_t)count, sizeof(double))};
    f->x = calloc((size_t)(SIZE * n), sizeof(double));
    if (f->a.p && f->a.i && f->a.x && f->x) {
        pattern_fill(n, f->a.p, f->a.i);
        f->solver = linsolver_new_sparse(&f->a, options, err);
    }
    if (f->solver) return HAWSER_OK;
    *out = newton_full_free(f);
    return error_memory(err);
}

NewtonFull *newton_full_free(NewtonFull *f)
{
    if (!f) return NULL;
    linsolver_free(f->solver);
    free(f->a.p);
    free(f->a.i);
    free(f->a.x);
    free(f->x);
    free(f);
    return NULL;
}

static Quat quat_at(const Newton *nw, int i) { return (Quat){nw->q[0][i], nw->q[1][i], nw->q[2][i], nw->q[3][i]}; }

/* The column of a product of quaternions for the unit quaternion e_c on the left (left = 1) or right of the other. */
static Quat product_column(Quat q, int c, int left)
{
    const Quat unit = {c == 0, c == 1, c == 2, c == 3};
    return left ? quat_mul(unit, q) : quat_mul(q, unit);
}

static double quat_part(Quat q, int r) { return r == 0 ? q.w : r == 1 ? q.x : r == 2 ? q.y : q.z; }

/* Entry (r, c) of a kinematic row, r < U, of segment i (N1), (N2). */
static double kinematic_entry(const Newton *nw, int i, int r, int c)
{
    const double gamma = nw->gamma;
    if (r < Q) return c == r ? 1 : -gamma;
    if (c < U) {
        const Quat w = {0, nw->w[0][i], nw->w[1][i], nw->w[2][i]};
        return (r == c) - gamma / 2 * quat_part(product_column(w, c - Q, 0), r - Q);
    }
    return -gamma / 2 * quat_part(product_column(quat_at(nw, i), 1 + c - STATE_W, 1), r - Q);
}

/* phi = turn . dq (rotation by a change of the quaternion): row-major 3x4, 2 vec(e_c q*) / q^2. */
static void turn_of_quaternion(const Newton *nw, int i, double turn[12])
{
    const Quat q = quat_at(nw, i);
    const double scale = 2 / (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    for (int c = 0; c < 4; ++c) {
        const Quat column = product_column(quat_conj(q), c, 1);
        turn[c] = scale * column.x;
        turn[4 + c] = scale * column.y;
        turn[8 + c] = scale * column.z;
    }
}

/* Entry (row r of the velocities, column c) of block row i, block column k. */
static double motion_entry(const Newton *nw, const double turn[12], int i, int k, int r, int c)
{
    const int at = k == i ? 0 : k < i ? -1 : 1;
    const double *const kb = (at == 0 ? nw->k.diag : at < 0 ? nw->k.lower : nw->k.upper) + 36 * i;
    const double *const db = (at == 0 ? nw->d.diag : at < 0 ? nw->d.lower : nw->d.upper) + 36 * i;
    if (c < Q) return -nw->gamma * kb[6 * c + r];
    if (c < U) {
        double sum = 0;
        for (int e = 0; e < 3; ++e) sum += kb[6 * (3 + e) + r] * turn[4 * e + c - Q];
        return -nw->gamma * sum;
    }
    double value = -nw->gamma * db[6 * (c - U) + r];
    if (at == 0 && r < 3 && c - U == r) value += nw->mass[i];
    if (at == 0 && r >= 3 && c >= STATE_W) value += nw->inertia[3 * (r - 3) + c - STATE_W][i];
    return value;
}

void newton_full_form(NewtonFull *f, const Newton *nw)
{
    int e = 0;
    for (int k = 0; k < nw->n; ++k) {
        double turn[12];
        turn_of_quaternion(nw, k, turn);
        for (int c = 0; c < SIZE; ++c) {
            for (; e < f->a.p[SIZE * k + c + 1]; ++e) {
                const int i = f->a.i[e] / SIZE, r = f->a.i[e] % SIZE;
                f->a.x[e] = r < U ? kinematic_entry(nw, i, r, c) : motion_entry(nw, turn, i, k, r - U, c);
            }
        }
    }
}

int newton_full_factor(NewtonFull *f) { return linsolver_factor_sparse(f->solver, &f->a); }

/* The right-hand side in the matrix's order, velocity rows times the mass matrix. */
static void gather(const NewtonFull *f, const Newton *nw, const double *b)
{
    const int n = nw->n;
    for (int i = 0; i < n; ++i) {
        double *const x = f->x + SIZE * i;
        for (int c = 0; c < U + 3; ++c) x[c] = c < U ? b[c * n + i] : nw->mass[i] * b[c * n + i];
        for (int c = 0; c < 3; ++c) {
            x[STATE_W + c] = 0;
            for (int e = 0; e < 3; ++e) x[STATE_W + c] += nw->inertia[3 * c + e][i] * b[(STATE_W + e) * n + i];
        }
    }
}

int newton_full_solve(NewtonFull *f, const Newton *nw, double *b)
{
    gather(f, nw, b);
    const int status = linsolver_solve(f->solver, f->x);
    for (int i = 0; !status && i < nw->n; ++i) {
        for (int c = 0; c < SIZE; ++c) b[c * nw->n + i] = f->x[SIZE * i + c];
    }
    return status;
}

const LinSolver *newton_full_solver(const NewtonFull *f) { return f->solver; }

void newton_full_checkpoint(Checkpoint *c, NewtonFull *f) { linsolver_checkpoint(c, f->solver, NULL, &f->a); }
