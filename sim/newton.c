#include "sim/newton.h"

#include <stdlib.h>
#include <string.h>

#include "core/error.h"

hawser_status newton_new(Newton *nw, const Scene *scene, const LinOptions *options, hawser_error *err)
{
    const int n = scene->chain.n;
    memset(nw, 0, sizeof *nw);
    nw->n = n;
    nw->team = options->team;
    nw->mass = calloc((size_t)n, sizeof(double));
    nw->inertia = calloc((size_t)(9 * n), sizeof(double));
    nw->q = calloc((size_t)(4 * n), sizeof(double));
    nw->w = calloc((size_t)(3 * n), sizeof(double));
    nw->turn = calloc((size_t)(3 * n), sizeof(double));
    nw->x = calloc((size_t)(6 * n), sizeof(double));
    const int ok = block_chain_alloc(&nw->k, n, 6) & block_chain_alloc(&nw->d, n, 6) & block_chain_alloc(&nw->a, n, 6);
    if (!ok || !nw->mass || !nw->inertia || !nw->q || !nw->w || !nw->turn || !nw->x) {
        newton_free(nw);
        return error_memory(err);
    }
    for (int i = 0; i < n; ++i) nw->mass[i] = scene->chain.mass[i];
    nw->solver = linsolver_new(&nw->a, options, err);
    if (nw->solver) return HAWSER_OK;
    newton_free(nw);
    return err ? err->status : HAWSER_ERR_MEMORY;
}

void newton_free(Newton *nw)
{
    block_chain_free(&nw->k);
    block_chain_free(&nw->d);
    block_chain_free(&nw->a);
    free(nw->mass);
    free(nw->inertia);
    free(nw->q);
    free(nw->w);
    free(nw->turn);
    free(nw->x);
    nw->solver = linsolver_free(nw->solver);
    memset(nw, 0, sizeof *nw);
}

void newton_point(Newton *nw, const Scene *scene, const Kinematics *kin, const double *y)
{
    const int n = nw->n;
    const Vec3 unit[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int i = 0; i < n; ++i) {
        for (int c = 0; c < 4; ++c) nw->q[4 * i + c] = y[(STATE_Q + c) * n + i];
        for (int c = 0; c < 3; ++c) nw->w[3 * i + c] = y[(STATE_W + c) * n + i];
        for (int c = 0; c < 3; ++c) {
            const Vec3 column = body_inertia_times(&scene->chain, kin, i, unit[c]);
            nw->inertia[9 * i + c] = column.x;
            nw->inertia[9 * i + 3 + c] = column.y;
            nw->inertia[9 * i + 6 + c] = column.z;
        }
    }
}

/* S = (1 + gamma/2 [w]x) / (1 + gamma^2 w^2 / 4), row-major (N4). */
static void turn_matrix(const double w[3], double gamma, double s[9])
{
    const double g = gamma / 2, scale = 1 / (1 + g * g * (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]));
    const double m[9] = {1, -g * w[2], g * w[1], g * w[2], 1, -g * w[0], -g * w[1], g * w[0], 1};
    for (int c = 0; c < 9; ++c) s[c] = scale * m[c];
}

/* out = -gamma D - gamma^2 K S of one block; the block's column belongs to the segment whose S is given. */
static void block_form(const double *k, const double *d, const double s[9], double gamma, double *out)
{
    const double g2 = gamma * gamma;
    for (int e = 0; e < 18; ++e) out[e] = -gamma * d[e] - g2 * k[e];
    for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 6; ++r) {
            const double ks = k[18 + r] * s[c] + k[24 + r] * s[3 + c] + k[30 + r] * s[6 + c];
            out[18 + 6 * c + r] = -gamma * d[18 + 6 * c + r] - g2 * ks;
        }
    }
}

/* What one of two threads does: segments from..to-1 of a loop over them. */
typedef struct Split {
    Newton *nw;
    double *b;
} Split;

static int split_from(const Newton *nw, int rank) { return rank == 0 ? 0 : nw->n / 2; }
static int split_to(const Newton *nw, int rank) { return rank == 0 ? nw->n / 2 : nw->n; }

/* Block columns from..to-1 of A: in rows i-1, i, i+1 (N5). */
static void form_columns(Newton *nw, int from, int to)
{
    const double gamma = nw->gamma;
    for (int i = from; i < to; ++i) {
        double s[9];
        turn_matrix(nw->w + 3 * i, gamma, s);
        double *const diag = nw->a.diag + 36 * i;
        block_form(nw->k.diag + 36 * i, nw->d.diag + 36 * i, s, gamma, diag);
        if (i > 0) block_form(nw->k.upper + 36 * (i - 1), nw->d.upper + 36 * (i - 1), s, gamma, nw->a.upper + 36 * (i - 1));
        if (i + 1 < nw->n) block_form(nw->k.lower + 36 * (i + 1), nw->d.lower + 36 * (i + 1), s, gamma, nw->a.lower + 36 * (i + 1));
        for (int c = 0; c < 3; ++c) {
            diag[7 * c] += nw->mass[i];
            for (int r = 0; r < 3; ++r) diag[6 * (3 + c) + 3 + r] += nw->inertia[9 * i + 3 * r + c];
        }
    }
}

static void form_job(void *arg, int rank)
{
    Newton *const nw = ((Split *)arg)->nw;
    form_columns(nw, split_from(nw, rank), split_to(nw, rank));
}

void newton_form(Newton *nw, double gamma)
{
    Split split = {.nw = nw};
    nw->gamma = gamma;
    if (team_size(nw->team) == 2) {
        team_run(nw->team, form_job, &split);
    } else {
        form_columns(nw, 0, nw->n);
    }
}

int newton_factor(Newton *nw) { return linsolver_factor(nw->solver, &nw->a); }

/* (1 - gamma/2 Omega)^-1 p, where Omega q = (0, w) q as quaternions (N3). */
static Quat quaternion_eliminate(const double *w, double gamma, Quat p)
{
    const double g = gamma / 2, scale = 1 / (1 + g * g * (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]));
    const Quat turned = quat_mul((Quat){0, g * w[0], g * w[1], g * w[2]}, p);
    return (Quat){scale * (p.w + turned.w), scale * (p.x + turned.x), scale * (p.y + turned.y), scale * (p.z + turned.z)};
}

static Quat quaternion_at(const double *q) { return (Quat){q[0], q[1], q[2], q[3]}; }

/* Quaternion entries of the 13n vector b at segment i. */
static Quat vector_quaternion(const double *b, int n, int i)
{
    return (Quat){b[3 * n + i], b[4 * n + i], b[5 * n + i], b[6 * n + i]};
}

/* turn[i]: the rotation that the quaternion residual stands for (N6). */
static void turn_residual(Newton *nw, const double *b, int from, int to)
{
    for (int i = from; i < to; ++i) {
        const Quat q = quaternion_at(nw->q + 4 * i);
        const Quat e = quaternion_eliminate(nw->w + 3 * i, nw->gamma, vector_quaternion(b, nw->n, i));
        const Quat r = quat_mul(e, quat_conj(q));
        const double scale = 2 / (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
        nw->turn[3 * i] = scale * r.x;
        nw->turn[3 * i + 1] = scale * r.y;
        nw->turn[3 * i + 2] = scale * r.z;
    }
}

/* y += s * block * (position part of b at segment j; turn of j) */
static void stiffness_times(const Newton *nw, const double *block, double s, const double *b, int j, double y[6])
{
    const int n = nw->n;
    const double *const turn = nw->turn + 3 * j;
    const double x[6] = {s * b[j], s * b[n + j], s * b[2 * n + j], s * turn[0], s * turn[1], s * turn[2]};
    for (int c = 0; c < 6; ++c) {
        for (int r = 0; r < 6; ++r) y[r] += block[6 * c + r] * x[c];
    }
}

/* x = M b_u + gamma K (b_p; turn) (N7), rows from..to-1. */
static void reduce(Newton *nw, const double *b, int from, int to)
{
    const int n = nw->n;
    for (int i = from; i < to; ++i) {
        double r[6];
        const double *const in = nw->inertia + 9 * i;
        const double w[3] = {b[10 * n + i], b[11 * n + i], b[12 * n + i]};
        for (int c = 0; c < 3; ++c) {
            r[c] = nw->mass[i] * b[(STATE_V + c) * n + i];
            r[3 + c] = in[3 * c] * w[0] + in[3 * c + 1] * w[1] + in[3 * c + 2] * w[2];
        }
        stiffness_times(nw, nw->k.diag + 36 * i, nw->gamma, b, i, r);
        if (i > 0) stiffness_times(nw, nw->k.lower + 36 * i, nw->gamma, b, i - 1, r);
        if (i + 1 < n) stiffness_times(nw, nw->k.upper + 36 * i, nw->gamma, b, i + 1, r);
        memcpy(nw->x + 6 * i, r, sizeof r);
    }
}

/* The eliminated unknowns from the velocities (N8), segments from..to-1. */
static void expand(const Newton *nw, double *b, int from, int to)
{
    const int n = nw->n;
    const double gamma = nw->gamma, g = gamma / 2;
    for (int i = from; i < to; ++i) {
        const double *const u = nw->x + 6 * i;
        const Quat spin = quat_mul((Quat){0, g * u[3], g * u[4], g * u[5]}, quaternion_at(nw->q + 4 * i));
        Quat p = vector_quaternion(b, n, i);
        p = (Quat){p.w + spin.w, p.x + spin.x, p.y + spin.y, p.z + spin.z};
        p = quaternion_eliminate(nw->w + 3 * i, gamma, p);
        const double q[4] = {p.w, p.x, p.y, p.z};
        for (int c = 0; c < 4; ++c) b[(STATE_Q + c) * n + i] = q[c];
        for (int c = 0; c < 3; ++c) {
            b[c * n + i] += gamma * u[c];
            b[(STATE_V + c) * n + i] = u[c];
            b[(STATE_W + c) * n + i] = u[3 + c];
        }
    }
}

static void turn_job(void *arg, int rank)
{
    const Split *const s = arg;
    turn_residual(s->nw, s->b, split_from(s->nw, rank), split_to(s->nw, rank));
}

static void reduce_job(void *arg, int rank)
{
    const Split *const s = arg;
    reduce(s->nw, s->b, split_from(s->nw, rank), split_to(s->nw, rank));
}

static void expand_job(void *arg, int rank)
{
    const Split *const s = arg;
    expand(s->nw, s->b, split_from(s->nw, rank), split_to(s->nw, rank));
}

int newton_solve(Newton *nw, double *b)
{
    Split split = {.nw = nw, .b = b};
    const int two = team_size(nw->team) == 2;
    if (two) {
        team_run(nw->team, turn_job, &split);
        team_run(nw->team, reduce_job, &split);
    } else {
        turn_residual(nw, b, 0, nw->n);
        reduce(nw, b, 0, nw->n);
    }
    const int status = linsolver_solve(nw->solver, nw->x);
    if (status) return status;
    if (two) {
        team_run(nw->team, expand_job, &split);
    } else {
        expand(nw, b, 0, nw->n);
    }
    return 0;
}
