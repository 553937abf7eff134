#include "sim/solve/newton.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "core/chain.h"
#include "core/error.h"
#include "core/lanes.h"
#include "core/vec3.h"
#include "linsolve/inertia.h"

static NewtonFull *newton_full_free(NewtonFull *f);

enum { POINT_ARRAYS = 17 }; /* from Newton.mass to w */

/* Allocates blocks and arrays for nw->n segments, masses 1; 0 if there is no memory (what exists stays for the free,
 * which may be called on a zeroed struct). `extra` doubles are added to x for unknowns behind the chain's. */
static int newton_parts_new(Newton *nw, int extra)
{
    const int n = nw->n;
    const int ok = chain_struct_new(&nw->mass, POINT_ARRAYS, n) & block_chain_alloc(&nw->k, n, 6) &
                   block_chain_alloc(&nw->d, n, 6) & block_chain_alloc(&nw->a, n, 6);
    nw->z = calloc((size_t)(6 * n) + LANES, sizeof(double));
    nw->x = calloc((size_t)(6 * n + extra) + LANES, sizeof(double));
    if (!ok || !nw->z || !nw->x) return 0;
    chain_array_fill(nw->mass, n, 1);
    chain_array_fill(nw->q[0], n, 1);
    return 1;
}

static void newton_parts_free(Newton *nw)
{
    block_chain_free(&nw->k);
    block_chain_free(&nw->d);
    block_chain_free(&nw->a);
    chain_arrays_free(&nw->mass, POINT_ARRAYS);
    free(nw->z);
    free(nw->x);
}

enum { BLOCK = 36 };

hawser_status newton_extra_attach(Newton *nw, const BlockExtras *from, const LinOptions *options, hawser_error *err)
{
    const LinKind kind = options->kind;
    if (kind != LIN_AUTO && kind != LIN_BLOCK_SPARSE && kind != LIN_KLU && kind != LIN_DENSE) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "solver.linear_solver '%s' cannot hold contact.cable_on_cable: take 'auto' or 'klu'",
                         linsolver_kind_name(kind));
    }
    NewtonExtra *const extra = calloc(1, sizeof *extra);
    if (!extra) return error_memory(err);
    extra->from = from;
    extra->options = *options;
    extra->version = -1;
    nw->extra = extra;
    return HAWSER_OK;
}

static NewtonExtra *newton_extra_free(NewtonExtra *extra)
{
    if (!extra) return NULL;
    free(extra->a);
    free(extra->filled);
    free(extra->block);
    free(extra);
    return NULL;
}

/* Allocates for the present pattern and fills in its places; 0 if there is no memory. */
static int pattern_follow(NewtonExtra *extra)
{
    const BlockExtras *const from = extra->from;
    free(extra->a);
    double *const a = extra->a = calloc((size_t)from->count * BLOCK + 8, sizeof *a);
    unsigned char *const filled = realloc(extra->filled, (size_t)from->count + 1);
    if (filled) extra->filled = filled;
    ExtraBlock *const block = realloc(extra->block, ((size_t)from->count + 1) * sizeof *block);
    if (block) extra->block = block;
    if (!a || !block || !filled) return 0;
    memset(filled, 0, (size_t)from->count + 1);
    for (int e = 0; e < from->count; ++e) {
        block[e] = (ExtraBlock){.row = from->row[e], .col = from->col[e], .block = a + BLOCK * e};
    }
    extra->count = from->count;
    extra->version = from->version;
    extra->stale = 1;
    return 1;
}

void newton_extra_form(Newton *nw)
{
    NewtonExtra *const extra = nw->extra;
    const BlockExtras *const from = extra->from;
    if (from->version != extra->version || from->count != extra->count) extra->failed = !pattern_follow(extra);
    if (extra->failed) return;
    for (int e = 0; e < from->count; ++e) {
        if (!from->live[e] && extra->filled[e]) memset(extra->a + BLOCK * e, 0, BLOCK * sizeof(double));
        extra->filled[e] = from->live[e];
        if (!from->live[e]) continue;
        double s[9];
        newton_turn(nw->gamma, v3_load(nw->w, from->col[e]), s);
        newton_kernels()->block(6, 6, 6, from->k + BLOCK * e, from->d + BLOCK * e, s, nw->gamma, extra->a + BLOCK * e);
    }
}

/* The ordering that the first solver chose by measuring is used for later patterns too: they are much alike. */
static void ordering_keep(NewtonExtra *extra, const LinStats *stats)
{
    if (extra->options.ordering != ORDER_AUTO || !stats->ordering || strcmp(stats->name, "klu") != 0) return;
    if (strcmp(stats->ordering, "amd") == 0) extra->options.ordering = ORDER_AMD;
    if (strcmp(stats->ordering, "colamd") == 0) extra->options.ordering = ORDER_COLAMD;
    if (strcmp(stats->ordering, "metis") == 0) extra->options.ordering = ORDER_METIS;
}

static void counts_add(LinStats *sum, const LinStats *more)
{
    sum->analyses += more->analyses;
    sum->factors += more->factors;
    sum->refactors += more->refactors;
    sum->fallbacks += more->fallbacks;
    sum->solves += more->solves;
}

/* Replaces the solver by one for the pattern of m. */
static int solver_renew(Newton *nw, const NewtonMatrix *m)
{
    NewtonExtra *const extra = nw->extra;
    LinStats before;
    linsolver_stats(nw->solver, &before);
    ordering_keep(extra, &before);
    LinSolver *const next = linsolver_new_newton(m, &extra->options, NULL);
    if (!next) return 0;
    counts_add(&extra->retired, &before);
    linsolver_free(nw->solver);
    nw->solver = next;
    extra->stale = 0;
    return 1;
}

/* The chain's matrix with the blocks of equipment and extra blocks. */
static NewtonMatrix matrix_of(const Newton *nw)
{
    NewtonMatrix m = nw->matrix;
    m.extras = nw->extra->count;
    m.extra = nw->extra->block;
    m.live = nw->extra->filled;
    return m;
}

/* Makes a new solver because the rest of the matrix has another pattern; 0 if there is no memory. */
static int newton_extra_renew(Newton *nw)
{
    const NewtonMatrix m = matrix_of(nw);
    return nw->extra->failed ? 0 : solver_renew(nw, &m);
}

/* Factors A with the blocks, with a new solver if their pattern has changed; returns as linsolver_factor. */
static int newton_extra_factor(Newton *nw)
{
    NewtonExtra *const extra = nw->extra;
    if (extra->failed) return -1;
    const NewtonMatrix m = matrix_of(nw);
    if (extra->stale && !solver_renew(nw, &m)) return -1;
    return linsolver_factor_newton(nw->solver, &m);
}

void newton_extra_couple(Newton *nw) { block_extras_gemv(nw->extra->from, 1, nw->z, nw->x); }

/* Adds the counts of replaced solvers. */
static void newton_extra_stats(const NewtonExtra *extra, LinStats *stats) { counts_add(stats, &extra->retired); }

/* Makes room for the places and blocks that were saved; 0 if there is no memory. */
static int pattern_room(NewtonExtra *extra, int count)
{
    free(extra->a);
    free(extra->filled);
    free(extra->block);
    extra->a = calloc((size_t)count * BLOCK + 8, sizeof *extra->a);
    extra->filled = calloc((size_t)count + 1, sizeof *extra->filled);
    extra->block = calloc((size_t)count + 1, sizeof *extra->block);
    for (int e = 0; extra->a && extra->block && e < count; ++e) extra->block[e].block = extra->a + BLOCK * e;
    extra->count = count;
    return extra->a && extra->filled && extra->block;
}

/* Saves or loads the blocks of the matrix as it is factored, and its solver. */
static void newton_extra_checkpoint(Checkpoint *c, Newton *nw)
{
    NewtonExtra *const extra = nw->extra;
    int count = extra->count;
    CHECKPOINT(c, extra->version);
    CHECKPOINT(c, extra->stale);
    CHECKPOINT(c, extra->options.ordering);
    lin_stats_checkpoint(c, &extra->retired);
    CHECKPOINT(c, count);
    const char *const fault = "a number of blocks is impossible";
    checkpoint_check(c, count == 0 || extra->version >= 0, fault);
    if (!checkpoint_number(c, count, BLOCK * sizeof *extra->a, fault)) return;
    if (c->reading && !pattern_room(extra, count)) checkpoint_lack(c);
    for (int e = 0; !c->status && e < count; ++e) {
        CHECKPOINT(c, extra->block[e].row);
        CHECKPOINT(c, extra->block[e].col);
        checkpoint_check(c,
                         extra->block[e].row >= 0 && extra->block[e].row < nw->n && extra->block[e].col >= 0 &&
                             extra->block[e].col < nw->n,
                         "a block is outside of the matrix");
    }
    if (count > 0) checkpoint_put(c, "extra->a", extra->a, (size_t)count * BLOCK * sizeof *extra->a);
    if (count > 0) checkpoint_put(c, "extra->filled", extra->filled, (size_t)count);
    if (c->status) return;
    const NewtonMatrix m = matrix_of(nw);
    if (c->reading && !extra->stale && extra->version >= 0) {
        LinSolver *const next = linsolver_new_newton(&m, &extra->options, NULL);
        if (!next) checkpoint_lack(c);
        if (next) linsolver_free(nw->solver);
        if (next) nw->solver = next;
    }
    if (!extra->stale) linsolver_checkpoint(c, nw->solver, &m, NULL);
}

enum { P = STATE_P, Q = STATE_Q, U = STATE_V, SIZE = STATE_SIZE };

struct NewtonFull {
    SparseMatrix a;
    LinSolver *solver;
    double *x; /* [13n] in the matrix's order */
};

/* Checks whether the block of row segment i and column segment k has an entry at (r, c): the kinematic rows stay within
 * their own segment. */
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

/* Creates pattern and solver for the chain of nw. Errors: MEMORY. */
static hawser_status newton_full_new(const Newton *nw, const LinOptions *options, NewtonFull **out, hawser_error *err)
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

static NewtonFull *newton_full_free(NewtonFull *f)
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

/* Column of a product of quaternions for the unit quaternion e_c on the left (left = 1) or right of the other. */
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

/* Fills the values from nw's blocks for nw->gamma. */
static void newton_full_form(NewtonFull *f, const Newton *nw)
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

/* Factor and solve like newton_factor, newton_solve. */
static int newton_full_factor(NewtonFull *f) { return linsolver_factor_sparse(f->solver, &f->a); }

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

static int newton_full_solve(NewtonFull *f, const Newton *nw, double *b)
{
    gather(f, nw, b);
    const int status = linsolver_solve(f->solver, f->x);
    for (int i = 0; !status && i < nw->n; ++i) {
        for (int c = 0; c < SIZE; ++c) b[c * nw->n + i] = f->x[SIZE * i + c];
    }
    return status;
}

static const LinSolver *newton_full_solver(const NewtonFull *f) { return f->solver; }

static void newton_full_checkpoint(Checkpoint *c, NewtonFull *f) { linsolver_checkpoint(c, f->solver, NULL, &f->a); }

/* Data of one roller at the linearisation point for (SP11) and (SP12). */
typedef struct RollerPoint {
    const MovingRoller *item;
    RollerLoad load;
    Vec3 b, w;           /* axis; angular velocity of the mount */
    double s;            /* of the spin, rad/s */
    double torque, d_om; /* bearing and motor: T + T_m and its derivative by the relative speed */
    Vec3 t;              /* the same with the force on the roller */
} RollerPoint;

static int spins(const RollerPoint *r) { return r->item->spin >= 0; }

static int mounted(const RollerPoint *r) { return r->item->mount >= 0; }

static RollerPoint point_of(const EquipmentWork *w, int k, const double *e, double friction)
{
    RollerPoint r = {.item = &w->q->item[k], .w = v3(0, 0, 0), .t = v3(0, 0, 0)};
    r.load = w->load[r.item->roller];
    r.b = w->roller[r.item->roller].shape.axis;
    if (mounted(&r)) {
        const int i = 2 * r.item->mount + 1;
        r.w = v3_load(w->kin.w, i);
    }
    if (!spins(&r)) return r;
    const double force = v3_norm(r.load.force);
    double d_load, driven;
    r.s = e[r.item->spin];
    const double om = r.s - v3_dot(r.w, r.b);
    r.torque = bearing_torque(&r.item->bearing, force, om, &r.d_om, &d_load);
    r.torque = friction * (r.torque + motor_torque(&w->motor[k], om, &driven));
    r.d_om = friction * (r.d_om + driven);
    if (force > 0) r.t = v3_scale(friction * d_load / force, r.load.force);
    return r;
}

/* c += a b, column-major: a rows x inner, b inner x cols. */
static void multiply_add(int rows, int inner, int cols, const double *a, const double *b, double *c)
{
    for (int j = 0; j < cols; ++j) {
        for (int k = 0; k < inner; ++k) {
            for (int i = 0; i < rows; ++i) c[j * rows + i] += b[j * inner + k] * a[k * rows + i];
        }
    }
}

/* rows [6][size]: the roller's own rows from those of [force; moment]: the spin's is (t, b), and a mount under a spin
 * receives the moment without that component (SP12). */
static void rows_map(const RollerPoint *r, double *rows)
{
    const int size = r->item->size, spin = size - 1;
    memset(rows, 0, (size_t)(6 * size) * sizeof *rows);
    for (int c = 0; c < 3; ++c) {
        const double t = v3_dot(v3_axis(c), r->t), b = v3_dot(v3_axis(c), r->b);
        double *const by_force = rows + size * c, *const by_moment = rows + size * (3 + c);
        if (mounted(r)) by_force[c] = by_moment[3 + c] = 1;
        if (!spins(r)) continue;
        by_force[spin] = t;
        by_moment[spin] = b;
        for (int i = 0; mounted(r) && i < 3; ++i) {
            const double along = v3_dot(v3_axis(i), r->b);
            by_force[3 + i] -= along * t;
            by_moment[3 + i] -= along * b;
        }
    }
}

/* speeds [size][6]: (dV, dW) by the unknowns; turns [6][6]: dW by (dC, phi) of the mount (SP11). */
static void columns_map(const RollerPoint *r, double *speeds, double *turns)
{
    const int size = r->item->size;
    memset(speeds, 0, (size_t)(6 * size) * sizeof *speeds);
    memset(turns, 0, 36 * sizeof *turns);
    if (spins(r)) v3_put(speeds + 6 * (size - 1) + 3, r->b);
    for (int c = 0; mounted(r) && c < 3; ++c) {
        const Vec3 across = spins(r) ? v3_reject(v3_axis(c), r->b) : v3_axis(c), db = v3_cross(v3_axis(c), r->b);
        speeds[6 * c + c] = 1;
        v3_put(speeds + 6 * (3 + c) + 3, across);
        if (!spins(r)) continue;
        const Vec3 turned = v3_scale(r->s - v3_dot(r->w, r->b), db);
        v3_put(turns + 6 * (3 + c) + 3, v3_axpy(turned, -v3_dot(r->w, db), r->b));
    }
}

/* Adds what does not come from the contacts' derivatives: the axis turns under moments, bearing and gyroscope
 * (SP12). */
static void own_add(const RollerPoint *r, RollerLeaf *leaf)
{
    const int size = leaf->size, spin = size - 1;
    if (!spins(r)) return;
    leaf->d_own[size * spin + spin] += r->d_om;
    if (!mounted(r)) return;
    const double inertia = r->item->inertia, about = v3_dot(r->b, r->load.moment) + r->torque;
    const Vec3 gyro = v3_scale(-inertia, v3_cross(r->w, r->b)), by_spin = v3_axpy(gyro, -r->d_om, r->b);
    for (int i = 0; i < 3; ++i) leaf->d_own[size * spin + 3 + i] += v3_dot(v3_axis(i), by_spin);
    for (int c = 0; c < 3; ++c) {
        const Vec3 db = v3_cross(v3_axis(c), r->b);
        const double row_k = v3_dot(db, r->load.moment) - r->d_om * v3_dot(r->w, db);
        const double row_d = -r->d_om * v3_dot(v3_axis(c), r->b);
        Vec3 moment_k = v3_axpy(v3_scale(-row_k, r->b), -about, db);
        moment_k = v3_axpy(moment_k, -inertia * r->s, v3_cross(r->w, db));
        const Vec3 moment_d = v3_axpy(v3_scale(-row_d, r->b), -inertia * r->s, db);
        double *const k = leaf->k_own + size * (3 + c), *const d = leaf->d_own + size * (3 + c);
        k[spin] += row_k;
        d[spin] += row_d;
        for (int i = 0; i < 3; ++i) {
            k[3 + i] += v3_dot(v3_axis(i), moment_k);
            d[3 + i] += v3_dot(v3_axis(i), moment_d);
        }
    }
}

/* Adds the bushing's derivatives to a mount's six rows and columns. */
static void bushing_add(const EquipmentWork *w, int mount, RollerLeaf *leaf)
{
    const double *const k = w->k.diag + 36 * (2 * mount + 1), *const d = w->d.diag + 36 * (2 * mount + 1);
    for (int i = 0; i < 36; ++i) {
        leaf->k_own[leaf->size * (i / 6) + i % 6] += k[i];
        leaf->d_own[leaf->size * (i / 6) + i % 6] += d[i];
    }
}

/* Writes K and D of moving roller k into leaf: own, and into and from all segments that it touches; friction scales the
 * bearing. */
static void roller_blocks(const EquipmentWork *w, int k, const double *e, double friction, RollerLeaf *leaf)
{
    if (w->held && leaf->positions) { /* couples with nothing, so that it does not move */
        leaf->touched = 0;
        leaf->turning = v3(0, 0, 0);
        memset(leaf->k_own, 0, sizeof leaf->k_own);
        memset(leaf->d_own, 0, sizeof leaf->d_own);
        return;
    }
    const RollerPoint r = point_of(w, k, e, friction);
    const RollerSum *const sum = &w->sum[k];
    const int size = leaf->size, positions = leaf->positions;
    double rows[6 * ROLLER_UNKNOWNS], speeds[6 * ROLLER_UNKNOWNS], turns[36];
    rows_map(&r, rows);
    columns_map(&r, speeds, turns);
    leaf->turning = r.w;
    /* K by positions = K + D turns, D by unknowns = D speeds; each multiplied by rows from the left for the roller's
     * own rows */
    double by_pose[36], own[6 * ROLLER_UNKNOWNS] = {0};
    memcpy(by_pose, sum->own[0], sizeof by_pose);
    multiply_add(6, 6, 6, sum->own[1], turns, by_pose);
    multiply_add(6, 6, size, sum->own[1], speeds, own);
    memset(leaf->k_own, 0, sizeof leaf->k_own);
    memset(leaf->d_own, 0, sizeof leaf->d_own);
    multiply_add(size, 6, positions, rows, by_pose, leaf->k_own);
    multiply_add(size, 6, size, rows, own, leaf->d_own);
    own_add(&r, leaf);
    if (positions) bushing_add(w, r.item->mount, leaf);
    leaf->touched = sum->touched < leaf->room ? sum->touched : leaf->room;
    for (int t = 0; t < leaf->touched; ++t) {
        LeafTouch *const at = &leaf->touch[t];
        *at = (LeafTouch){.block = sum->block[t]};
        memcpy(at->k_into, sum->into[0][t], sizeof at->k_into);
        multiply_add(6, 6, 6, sum->into[1][t], turns, at->k_into);
        multiply_add(6, 6, size, sum->into[1][t], speeds, at->d_into);
        multiply_add(size, 6, 6, rows, sum->from[0][t], at->k_from);
        multiply_add(size, 6, 6, rows, sum->from[1][t], at->d_from);
    }
}

enum {
    ROOM = 4,        /* capacity of a leaf in segments, as in rollers.c */
    ROOM_WIDE = 128, /* the same for a roller in the border */
    WIDE_MOST = 3    /* linearisations in a row at which a roller may touch too many segments before it moves to the
                      * border */
};

/* ------------------------------------------------------------------------------------------------- life */

/* Makes room for that many segments, none touched yet; 0 if there is no memory. */
static int item_room(RollerLeaf *item, int room)
{
    free(item->touch);
    item->touch = calloc((size_t)room, sizeof *item->touch);
    item->touched = 0;
    item->room = item->touch ? room : 0;
    return item->touch != NULL;
}

/* Size and mass of a roller's unknowns. */
static void item_fill(RollerLeaf *item, const MovingRoller *roller)
{
    item->size = roller->size;
    item->positions = roller->mount >= 0 ? 6 : 0;
    item->border = -1;
    for (int c = 0; c < item->positions; ++c) item->mass[c] = c < 3 ? roller->mass : roller->turning;
    if (roller->spin >= 0) item->mass[item->size - 1] = roller->inertia;
}

/* Orders leaves first, then the border; sets pointers into the blocks, which the form fills. Returns the border's
 * width. */
static int order_fill(NewtonLeaves *l, int n)
{
    int first = 6 * n, leaves = 0, border = 0;
    for (int k = 0; k < l->q->n; ++k) {
        RollerLeaf *const item = &l->item[k];
        if (item->border >= 0) continue;
        item->first = first;
        first += item->size;
        l->leaf[leaves++] = (Leaf){.size = item->size, .diag = item->diag};
    }
    for (int k = 0; k < l->q->n; ++k) {
        RollerLeaf *const item = &l->item[k];
        if (item->border < 0) continue;
        item->border = border;
        item->first = first + border;
        border += item->size;
    }
    l->matrix->leaves = leaves;
    l->matrix->leaf = l->leaf;
    l->matrix->border = border;
    return border;
}

/* Allocates the border's columns, rows and corner for the present order; 0 if there is no memory. */
static int border_alloc(NewtonLeaves *l)
{
    free(l->right);
    free(l->bottom);
    free(l->corner);
    l->right = l->bottom = l->corner = NULL;
    const size_t w = (size_t)l->matrix->border, m = (size_t)newton_inner(l->matrix);
    if (w > 0) {
        l->right = calloc(m * w, sizeof(double));
        l->bottom = calloc(m * w, sizeof(double));
        l->corner = calloc(w * w, sizeof(double));
    }
    l->matrix->right = l->right;
    l->matrix->bottom = l->bottom;
    l->matrix->corner = l->corner;
    return w == 0 || (l->right && l->bottom && l->corner);
}

/* Builds around nw->a, into nw->matrix. Errors: MEMORY. */
static hawser_status newton_leaves_new(Newton *nw, const Equipment *q, hawser_error *err)
{
    NewtonLeaves *const l = calloc(1, sizeof *l);
    if (!l) return error_memory(err);
    nw->leaves = l;
    l->q = q;
    l->matrix = &nw->matrix;
    l->item = calloc((size_t)q->n, sizeof *l->item);
    l->leaf = calloc((size_t)q->n, sizeof *l->leaf);
    l->mounts.n = q->mounts;
    int ok = l->item && l->leaf && (q->mounts == 0 || newton_parts_new(&l->mounts, 0));
    for (int k = 0; ok && k < q->n; ++k) {
        item_fill(&l->item[k], &q->item[k]);
        ok = item_room(&l->item[k], ROOM);
        const int m = q->item[k].mount;
        if (m < 0) continue;
        assert(m < q->mounts && l->mounts.mass);
        l->mounts.mass[m] = q->item[k].mass;
        for (int c = 0; c < 3; ++c) l->mounts.inertia[4 * c][m] = q->item[k].turning;
    }
    if (ok) order_fill(l, nw->n);
    return ok ? HAWSER_OK : error_memory(err);
}

static NewtonLeaves *newton_leaves_free(NewtonLeaves *l)
{
    if (!l) return NULL;
    for (int k = 0; l->item && k < l->q->n; ++k) free(l->item[k].touch);
    newton_parts_free(&l->mounts);
    free(l->item);
    free(l->leaf);
    free(l->right);
    free(l->bottom);
    free(l->corner);
    free(l);
    return NULL;
}

/* ------------------------------------------------------------------------------------------------- linearisation */

/* Checks whether a roller touches two neighbouring segments at most. */
static int fits_leaf(const RollerLeaf *item)
{
    if (item->touched < 2) return 1;
    return item->touched == 2 && abs(item->touch[0].block - item->touch[1].block) == 1;
}

/* Sets the linearisation point from what dynamics_blocks left in the workspace; friction as there. */
static void newton_leaves_point(NewtonLeaves *l, const EquipmentWork *w, const double *e, double friction)
{
    const double *const mounts = e + l->q->spins;
    const int m = l->q->mounts;
    for (int c = 0; m && c < 4; ++c) memcpy(l->mounts.q[c], mounts + (STATE_Q + c) * m, (size_t)m * sizeof(double));
    for (int c = 0; m && c < 3; ++c) memcpy(l->mounts.w[c], mounts + (STATE_W + c) * m, (size_t)m * sizeof(double));
    for (int k = 0; k < l->q->n; ++k) {
        RollerLeaf *const item = &l->item[k];
        roller_blocks(w, k, e, friction, item);
        item->wide = fits_leaf(item) ? 0 : item->wide + 1;
    }
}

/* ------------------------------------------------------------------------------------------------- matrix */

static void item_form(const Newton *nw, RollerLeaf *item)
{
    const NewtonKernels *const kernels = newton_kernels();
    const int size = item->size, positions = item->positions;
    double own[9], beside[9];
    newton_turn(nw->gamma, item->turning, own);
    kernels->block(size, positions, size, item->k_own, item->d_own, own, nw->gamma, item->diag);
    for (int c = 0; c < size; ++c) item->diag[c * (size + 1)] += item->mass[c];
    for (int t = 0; t < item->touched; ++t) {
        LeafTouch *const at = &item->touch[t];
        newton_turn(nw->gamma, v3_load(nw->w, at->block), beside);
        kernels->block(6, positions, size, at->k_into, at->d_into, own, nw->gamma, at->into);
        kernels->block(size, 6, 6, at->k_from, at->d_from, beside, nw->gamma, at->from);
    }
}

static double strength(const RollerLeaf *item, int t)
{
    double sum = 0;
    for (int i = 0; i < 6 * item->size; ++i) sum += fabs(item->touch[t].into[i]) + fabs(item->touch[t].from[i]);
    return sum;
}

/* Place of the leaf: where the coupling is strongest, and the stronger of the two beside it. */
static void leaf_place(const RollerLeaf *item, Leaf *leaf)
{
    int best = -1, second = -1;
    for (int t = 0; t < item->touched; ++t) {
        if (best < 0 || strength(item, t) > strength(item, best)) best = t;
    }
    for (int t = 0; t < item->touched; ++t) {
        if (abs(item->touch[t].block - item->touch[best].block) != 1) continue;
        if (second < 0 || strength(item, t) > strength(item, second)) second = t;
    }
    leaf->touches = (best >= 0) + (second >= 0);
    if (leaf->touches == 0) return;
    const int swapped = second >= 0 && item->touch[second].block < item->touch[best].block;
    const int order[2] = {swapped ? second : best, swapped ? best : second};
    leaf->at = item->touch[order[0]].block;
    for (int k = 0; k < leaf->touches; ++k) {
        leaf->into[k] = item->touch[order[k]].into;
        leaf->from[k] = item->touch[order[k]].from;
    }
}

/* A roller of the border: its blocks into the dense columns and rows. */
static void border_put(NewtonLeaves *l, const RollerLeaf *item)
{
    const int w = l->matrix->border, m = newton_inner(l->matrix), size = item->size;
    for (int t = 0; t < item->touched; ++t) {
        const int row = 6 * item->touch[t].block;
        for (int c = 0; c < size; ++c) {
            memcpy(l->right + (size_t)(item->border + c) * (size_t)m + row, item->touch[t].into + 6 * c,
                   6 * sizeof(double));
        }
        for (int c = 0; c < 6; ++c) {
            memcpy(l->bottom + (size_t)(row + c) * (size_t)w + item->border, item->touch[t].from + size * c,
                   (size_t)size * sizeof(double));
        }
    }
    for (int c = 0; c < size; ++c) {
        memcpy(l->corner + (item->border + c) * w + item->border, item->diag + size * c, (size_t)size * sizeof(double));
    }
}

/* Called after the chain's: leaves and border for nw->gamma. */
static void newton_leaves_form(Newton *nw)
{
    NewtonLeaves *const l = nw->leaves;
    const size_t w = (size_t)l->matrix->border, m = w ? (size_t)newton_inner(l->matrix) : 0;
    if (w) {
        memset(l->right, 0, m * w * sizeof(double));
        memset(l->bottom, 0, m * w * sizeof(double));
        memset(l->corner, 0, w * w * sizeof(double));
    }
    for (int k = 0, leaf = 0; k < l->q->n; ++k) {
        RollerLeaf *const item = &l->item[k];
        item_form(nw, item);
        if (item->border >= 0) {
            border_put(l, item);
        } else {
            leaf_place(item, &l->leaf[leaf++]);
        }
    }
}

/* ------------------------------------------------------------------------------------------------- solution */

/* y += A x: A rows x 6. */
static void times_add(int rows, const double *a, const double *x, double *y)
{
    for (int c = 0; c < 6; ++c) {
        for (int i = 0; i < rows; ++i) y[i] += x[c] * a[rows * c + i];
    }
}

/* Called after the chain's elimination: the equipment's rows of nw->x, and the effect of its positions on the chain's
 * rows; b: the equipment's part of the right-hand side. */
static void newton_leaves_reduce(Newton *nw, const double *b)
{
    NewtonLeaves *const l = nw->leaves;
    l->mounts.gamma = nw->gamma;
    if (l->q->mounts) newton_kernels()->eliminate(&l->mounts, b + l->q->spins, 0, l->q->mounts);
    for (int k = 0; k < l->q->n; ++k) {
        const RollerLeaf *const item = &l->item[k];
        const MovingRoller *const roller = &l->q->item[k];
        double *const x = nw->x + item->first;
        const double *const z = item->positions ? l->mounts.z + 6 * roller->mount : NULL;
        if (item->positions) memcpy(x, l->mounts.x + 6 * roller->mount, 6 * sizeof(double));
        if (roller->spin >= 0) x[item->size - 1] = roller->inertia * b[roller->spin];
        if (item->positions) times_add(item->size, item->k_own, z, x);
        for (int t = 0; t < item->touched; ++t) {
            const int i = item->touch[t].block;
            times_add(item->size, item->touch[t].k_from, nw->z + 6 * i, x);
            if (item->positions) times_add(6, item->touch[t].k_into, z, nw->x + 6 * i);
        }
    }
}

/* Called before or after the chain's: b from nw->x. */
static void newton_leaves_expand(Newton *nw, double *b)
{
    NewtonLeaves *const l = nw->leaves;
    for (int k = 0; k < l->q->n; ++k) {
        const RollerLeaf *const item = &l->item[k];
        const MovingRoller *const roller = &l->q->item[k];
        const double *const x = nw->x + item->first;
        if (item->positions) memcpy(l->mounts.x + 6 * roller->mount, x, 6 * sizeof(double));
        if (roller->spin >= 0) b[roller->spin] = x[item->size - 1];
    }
    if (l->q->mounts) newton_kernels()->expand(&l->mounts, b + l->q->spins, 0, l->q->mounts);
}

/* ------------------------------------------------------------------------------------------------- border */

/* Moves rollers that keep touching too many segments into the border; 1 if the pattern has changed, for which the
 * caller makes a new solver, 0 if not, -1 without memory. */
static int newton_leaves_widen(Newton *nw, EquipmentWork *w)
{
    NewtonLeaves *const l = nw->leaves;
    int changed = 0;
    for (int k = 0; k < l->q->n; ++k) {
        RollerLeaf *const item = &l->item[k];
        const int fits = l->matrix->border + item->size <= BORDER_MOST;
        if (item->border >= 0 || item->wide < WIDE_MOST || !fits) continue;
        if (!item_room(item, ROOM_WIDE) || !equipment_room(w, k, ROOM_WIDE)) return -1;
        item->border = 0; /* set by the order */
        order_fill(l, nw->n);
        changed = 1;
    }
    if (changed && !border_alloc(l)) return -1;
    return changed;
}

/* Saves or loads one roller's place and blocks; the solver's order follows from the rollers in the border. */
static void item_checkpoint(Checkpoint *c, RollerLeaf *item, EquipmentWork *w, int k, int segments)
{
    int room = item->room;
    CHECKPOINT(c, room);
    CHECKPOINT(c, item->border);
    CHECKPOINT(c, item->wide);
    if (!checkpoint_check(c, room == ROOM || room == ROOM_WIDE, "a roller's capacity is impossible")) return;
    if (c->reading && room != item->room && !(item_room(item, room) && equipment_room(w, k, room))) checkpoint_lack(c);
    CHECKPOINT(c, item->turning);
    CHECKPOINT(c, item->k_own);
    CHECKPOINT(c, item->d_own);
    CHECKPOINT(c, item->touched);
    if (!checkpoint_check(c, item->touched >= 0 && item->touched <= item->room, "a roller touches too much")) return;
    checkpoint_put(c, "item->touch", item->touch, (size_t)item->touched * sizeof *item->touch);
    for (int t = 0; !c->status && t < item->touched; ++t) {
        const int at = item->touch[t].block;
        checkpoint_check(c, at >= 0 && at < segments, "a roller touches a segment that does not exist");
    }
}

/* Saves or loads the rollers' data at the linearisation point, and which of them are in the border. */
static void newton_leaves_checkpoint(Checkpoint *c, Newton *nw, EquipmentWork *w)
{
    NewtonLeaves *const l = nw->leaves;
    const int m = l->q->mounts, before = l->matrix->border;
    if (m) chain_arrays_checkpoint(c, "mounts.q", l->mounts.q, 4, m);
    if (m) chain_arrays_checkpoint(c, "mounts.w", l->mounts.w, 3, m);
    for (int k = 0; !c->status && k < l->q->n; ++k) item_checkpoint(c, &l->item[k], w, k, nw->n);
    if (c->status || !c->reading) return;
    order_fill(l, nw->n);
    if (l->matrix->border == before) return;
    if (!border_alloc(l)) {
        checkpoint_lack(c);
        return;
    }
    if (nw->extra || nw->full) return;
    hawser_error unused;
    nw->solver = linsolver_free(nw->solver);
    nw->solver = linsolver_new_newton(&nw->matrix, &nw->options, &unused);
    if (!nw->solver) checkpoint_lack(c);
}

/* Creates the solver chosen by the options, for the present pattern. */
static hawser_status solver_new(Newton *nw, hawser_error *err)
{
    hawser_error mine = {0};
    if (nw->options.kind == LIN_KLU_FULL) {
        newton_full_new(nw, &nw->options, &nw->full, &mine);
    } else {
        nw->solver = linsolver_new_newton(&nw->matrix, &nw->options, &mine);
    }
    if (nw->solver || nw->full) return HAWSER_OK;
    return error_set(err, mine.status ? mine.status : HAWSER_ERR_MEMORY, "%s", mine.message);
}

static hawser_status equipment_new(Newton *nw, const Scene *scene, hawser_error *err)
{
    if (nw->options.kind != LIN_KLU_FULL) return newton_leaves_new(nw, scene->equipment, err);
    return error_set(
        err, HAWSER_ERR_INPUT,
        "key 'solver.linear_solver': 'klu-full' cannot hold rollers that spin or stand on mounts: expected "
        "auto, bordered or klu");
}

hawser_status newton_new(Newton *nw, const Scene *scene, const LinOptions *options, hawser_error *err)
{
    memset(nw, 0, sizeof *nw);
    nw->n = scene->chain.n;
    nw->team = options->team;
    nw->middle = halves_middle(nw->n);
    if (!newton_parts_new(nw, scene->equipment->spins + 6 * scene->equipment->mounts)) {
        newton_free(nw);
        return error_memory(err);
    }
    for (int i = 0; i < nw->n; ++i) nw->mass[i] = scene->chain.mass[i];
    nw->matrix.chain = nw->a;
    nw->options = *options;
    hawser_status status = HAWSER_OK;
    if (scene->equipment->n > 0) status = equipment_new(nw, scene, err);
    if (!status) status = solver_new(nw, err);
    if (status) newton_free(nw);
    return status;
}

hawser_status newton_rows_new(Newton *nw, int rows, const LinOptions *options, hawser_error *err)
{
    memset(nw, 0, sizeof *nw);
    nw->n = rows;
    nw->team = options->team;
    nw->middle = halves_middle(rows);
    nw->options = *options;
    hawser_status status = newton_parts_new(nw, 0) ? HAWSER_OK : error_memory(err);
    nw->matrix.chain = nw->a;
    if (!status) status = solver_new(nw, err);
    if (status) newton_free(nw);
    return status;
}

/* The blocks of the rows from `row` on. */
static BlockChain rows_of(const BlockChain *whole, int row, int n)
{
    const size_t at = 36 * (size_t)row;
    return (BlockChain){n, 6, whole->lower + at, whole->diag + at, whole->upper + at};
}

void newton_part(const Newton *whole, int row, const Chain *chain, Newton *part)
{
    const int n = chain->n;
    *part = (Newton){.n = n,
                     .middle = halves_middle(n),
                     .k = rows_of(&whole->k, row, n),
                     .d = rows_of(&whole->d, row, n),
                     .a = rows_of(&whole->a, row, n),
                     .mass = whole->mass + row,
                     .z = whole->z + 6 * (size_t)row,
                     .x = whole->x + 6 * (size_t)row,
                     .team = whole->team};
    for (int c = 0; c < 9; ++c) part->inertia[c] = whole->inertia[c] + row;
    for (int c = 0; c < 4; ++c) part->q[c] = whole->q[c] + row;
    for (int c = 0; c < 3; ++c) part->w[c] = whole->w[c] + row;
    for (int i = 0; i < n; ++i) part->mass[i] = chain->mass[i];
}

void newton_free(Newton *nw)
{
    newton_parts_free(nw);
    nw->leaves = newton_leaves_free(nw->leaves);
    nw->solver = linsolver_free(nw->solver);
    nw->full = newton_full_free(nw->full);
    nw->extra = newton_extra_free(nw->extra);
    memset(nw, 0, sizeof *nw);
}

void newton_point(Newton *nw, const Scene *scene, const Kinematics *kin, const double *y)
{
    const int n = nw->n;
    const Vec3 unit[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int c = 0; c < 4; ++c) memcpy(nw->q[c], y + (STATE_Q + c) * n, (size_t)n * sizeof(double));
    for (int c = 0; c < 3; ++c) memcpy(nw->w[c], y + (STATE_W + c) * n, (size_t)n * sizeof(double));
    for (int i = 0; i < n; ++i) {
        for (int c = 0; c < 3; ++c) {
            const Vec3 column = body_inertia_times(&scene->chain, kin, i, unit[c]);
            nw->inertia[c][i] = column.x;
            nw->inertia[3 + c][i] = column.y;
            nw->inertia[6 + c][i] = column.z;
        }
    }
}

void newton_swell(Newton *nw, double radius)
{
    for (int i = 0; i < nw->n; ++i) {
        for (int c = 0; c < 9; ++c) nw->inertia[c][i] = c % 4 == 0 ? nw->mass[i] * radius * radius : 0;
    }
}

/* A loop over segments, of which each of two threads does half. */
typedef struct Split {
    Newton *nw;
    double *b; /* read only during elimination */
} Split;

static int split_from(const Newton *nw, int rank) { return rank == 0 ? 0 : nw->middle; }

static int split_to(const Newton *nw, int rank) { return rank == 0 ? nw->middle : nw->n; }

static void form_job(void *arg, int rank)
{
    Newton *const nw = ((Split *)arg)->nw;
    newton_kernels()->form(nw, split_from(nw, rank), split_to(nw, rank));
}

/* Eliminates and couples rows, which needs the z of their neighbours: elimination is a lane ahead of coupling, and the
 * rows at the middle wait for the other half. */
static void rows_reduce(void *arg, LinSide side, int from, int to)
{
    const Split *const s = arg;
    Newton *const nw = s->nw;
    if (side == LIN_TOP) {
        newton_kernels()->eliminate(nw, s->b, from > 0 ? from + LANES : 0, to + LANES);
    } else if (side == LIN_BOTTOM) {
        newton_kernels()->eliminate(nw, s->b, from - LANES, to < nw->n ? to - LANES : to);
    } else { /* if no side has rows of its own */
        if (from == 0) newton_kernels()->eliminate(nw, s->b, 0, nw->middle);
        if (to == nw->n) newton_kernels()->eliminate(nw, s->b, nw->middle, to);
    }
    newton_kernels()->couple(nw, from, to);
}

static void rows_expand(void *arg, int from, int to)
{
    const Split *const s = arg;
    newton_kernels()->expand(s->nw, s->b, from, to);
}

/* Processes one side in tiles: coupling finds what elimination wrote in the nearest cache. */
enum { TILE = 128 };

static void reduce_job(void *arg, int rank)
{
    const Newton *const nw = ((Split *)arg)->nw;
    const LinSeam seam = lin_seam(nw->n);
    for (int i = 0; rank == 0 && i < seam.from; i += TILE) {
        rows_reduce(arg, LIN_TOP, i, i + TILE < seam.from ? i + TILE : seam.from);
    }
    for (int to = nw->n, from; rank == 1 && to > seam.to; to = from) {
        from = (to - 1) / TILE * TILE;
        if (from < seam.to) from = seam.to;
        rows_reduce(arg, LIN_BOTTOM, from, to);
    }
}

static void expand_job(void *arg, int rank)
{
    const Split *const s = arg;
    rows_expand(arg, split_from(s->nw, rank), split_to(s->nw, rank));
}

static void both(TeamJob job, Split *split) { halves_run(split->nw->team, split->nw->n >= HALVES_LONG, job, split); }

void newton_form(Newton *nw, double gamma)
{
    Split split = {.nw = nw};
    nw->gamma = gamma;
    if (nw->full) {
        newton_full_form(nw->full, nw);
    } else {
        both(form_job, &split);
        if (nw->leaves) newton_leaves_form(nw);
    }
    if (nw->extra) newton_extra_form(nw);
}

int newton_negative(const Newton *nw)
{
    if (nw->full || nw->extra || nw->leaves || nw->matrix.extras || nw->matrix.border) return -1;
    return block_chain_negative(&nw->a);
}

int newton_factor(Newton *nw)
{
    if (nw->extra) return newton_extra_factor(nw);
    return nw->full ? newton_full_factor(nw->full) : linsolver_factor_newton(nw->solver, &nw->matrix);
}

void newton_stats(const Newton *nw, LinStats *stats)
{
    linsolver_stats(nw->full ? newton_full_solver(nw->full) : nw->solver, stats);
    if (nw->extra) newton_extra_stats(nw->extra, stats);
}

void newton_reduce(Newton *nw, const double *b)
{
    Split split = {.nw = nw, .b = (double *)(uintptr_t)b};
    const LinSeam seam = lin_seam(nw->n);
    both(reduce_job, &split);
    rows_reduce(&split, LIN_SEAM, seam.from, seam.to);
}

void newton_expand(Newton *nw, double *b)
{
    Split split = {.nw = nw, .b = b};
    both(expand_job, &split);
}

/* Solves including the parts of equipment and other chains between reduction and solution. */
static int solve_beside(Newton *nw, double *b)
{
    newton_reduce(nw, b);
    if (nw->extra) newton_extra_couple(nw);
    double *const equipment = b + STATE_SIZE * nw->n;
    if (nw->leaves) newton_leaves_reduce(nw, equipment);
    const int status = linsolver_solve(nw->solver, nw->x);
    if (!status) newton_expand(nw, b);
    if (!status && nw->leaves) newton_leaves_expand(nw, equipment);
    return status;
}

int newton_solve(Newton *nw, double *b)
{
    if (nw->full) return newton_full_solve(nw->full, nw, b);
    if (nw->extra || nw->leaves) return solve_beside(nw, b);
    Split split = {.nw = nw, .b = b};
    return linsolver_stream(nw->solver, &(LinStream){&split, rows_reduce, rows_expand}, nw->x);
}

void newton_rough(Newton *nw, int rough)
{
    if (!nw->full) linsolver_rough(nw->solver, rough);
}

void newton_point_equipment(Newton *nw, const EquipmentWork *w, const double *y, double friction)
{
    if (nw->leaves) newton_leaves_point(nw->leaves, w, y + STATE_SIZE * nw->n, friction);
}

hawser_status newton_renew(Newton *nw, EquipmentWork *w, hawser_error *err)
{
    const int changed = nw->leaves ? newton_leaves_widen(nw, w) : 0;
    if (changed < 0) return error_memory(err);
    if (changed == 0) return HAWSER_OK;
    if (nw->extra) return newton_extra_renew(nw) ? HAWSER_OK : error_memory(err);
    nw->solver = linsolver_free(nw->solver);
    return solver_new(nw, err);
}

/* Forms the matrix from the blocks and gamma again, except for the extra blocks, which are saved: their pattern may
 * have changed since it was formed. */
static void matrix_again(Newton *nw)
{
    Split split = {.nw = nw};
    if (nw->full) {
        newton_full_form(nw->full, nw);
        return;
    }
    both(form_job, &split);
    if (nw->leaves) newton_leaves_form(nw);
}

void newton_checkpoint(Checkpoint *c, Newton *nw, EquipmentWork *w)
{
    block_chain_checkpoint(c, "nw->k", &nw->k);
    block_chain_checkpoint(c, "nw->d", &nw->d);
    chain_arrays_checkpoint(c, "nw->inertia", nw->inertia, 9, nw->n);
    chain_arrays_checkpoint(c, "nw->q", nw->q, 4, nw->n);
    chain_arrays_checkpoint(c, "nw->w", nw->w, 3, nw->n);
    CHECKPOINT(c, nw->gamma);
    if (nw->leaves) newton_leaves_checkpoint(c, nw, w);
    if (c->reading && !c->status) matrix_again(nw);
    if (nw->extra) {
        newton_extra_checkpoint(c, nw);
    } else if (nw->full) {
        newton_full_checkpoint(c, nw->full);
    } else {
        linsolver_checkpoint(c, nw->solver, &nw->matrix, NULL);
    }
}
