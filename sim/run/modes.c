#include "sim/run/modes.h"

#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "linsolve/small.h"

/* Directions beyond those requested; largest number of iterations; frequencies have converged when they change by
 * less. */
enum { GUARD = 8, ITERATIONS_MAX = 200, SETTLING = 4 };
static const double CLOSE = 1e-9;
/* Distance of the shift below the lowest frequency; a matrix that is less symmetric counts as that of a follower
 * load. */
static const double SHIFT_BELOW = 0.3, SYMMETRIC = 1e-7;

/* A subspace of `q` directions of the 6n velocities, column by column: v of all segments x, y, z, then w. */
typedef struct Subspace {
    Stage *st;
    Newton *newton;
    int n, size, q;                  /* segments, 6 n, directions */
    double *x, *y;                   /* [q][size] directions; A^-1 M times them */
    double *m;                       /* [q][size] M times a set of directions */
    double *s, *t;                   /* [q q] reduced matrices */
    double *z;                       /* [q q] their eigenvectors */
    double *mu, *imaginary, *before; /* [q] */
    int *order;                      /* [q] columns of z by rising size of mu */
    double *b;                       /* [state size] of one solution */
    double rounding;                 /* 1/s2: rounding error of omega^2 (RD13) */
    double radius;                   /* m, of inertia for newton_swell; 0: the segments' own */
    double gamma;                    /* s, of A = M + gamma^2 K (RD11) */
} Subspace;

static int space_alloc(Subspace *sp)
{
    const size_t q = (size_t)sp->q, vectors = q * (size_t)sp->size;
    sp->x = calloc(vectors, sizeof(double));
    sp->y = calloc(vectors, sizeof(double));
    sp->m = calloc(vectors, sizeof(double));
    sp->s = calloc(q * q, sizeof(double));
    sp->t = calloc(q * q, sizeof(double));
    sp->z = calloc(q * q, sizeof(double));
    sp->mu = calloc(q, sizeof(double));
    sp->imaginary = calloc(q, sizeof(double));
    sp->before = calloc(q, sizeof(double));
    sp->order = calloc(q, sizeof(int));
    sp->b = calloc((size_t)sp->st->motion->size, sizeof(double));
    return sp->x && sp->y && sp->m && sp->s && sp->t && sp->z && sp->mu && sp->imaginary && sp->before && sp->order &&
           sp->b;
}

static void space_free(Subspace *sp)
{
    double *const all[] = {sp->x, sp->y, sp->m, sp->s, sp->t, sp->z, sp->mu, sp->imaginary, sp->before, sp->b};
    for (size_t k = 0; k < sizeof all / sizeof *all; ++k) free(all[k]);
    free(sp->order);
}

/* K at the present state, without damping, and the point at which the matrix is taken (RD10). */
static void space_point(Subspace *sp)
{
    Stage *const st = sp->st;
    memset(sp->b, 0, (size_t)st->motion->size * sizeof(double)); /* at rest, no accelerations */
    dynamics_blocks(&st->scene, &st->ws, st->t, st->y, sp->b, 0.0, &sp->newton->k, &sp->newton->d);
    block_chain_zero(&sp->newton->d);
    newton_point(sp->newton, &st->scene, &st->ws.kin, st->y);
    if (sp->radius > 0) newton_swell(sp->newton, sp->radius);
}

double modes_rounding(const Chain *c, double radius)
{
    double largest = 0;
    for (int i = 0; i < c->n; ++i) {
        for (int j = i; j <= i + 1; ++j) {
            const double swollen = c->mass[i] * radius * radius, arm2 = c->half[i] * c->half[i];
            const double turn = radius > 0 ? swollen : fmin(c->inertia[1][i], c->inertia[2][i]);
            const double twist = radius > 0 ? swollen : c->inertia[0][i];
            const double push = fmax(c->stiffness[0][j], fmax(c->stiffness[1][j], c->stiffness[2][j]));
            const double bend = fmax(c->stiffness[4][j], c->stiffness[5][j]) / turn;
            largest = fmax(largest, 4 * push * (1 / c->mass[i] + arm2 / turn));
            largest = fmax(largest, 4 * fmax(bend, c->stiffness[3][j] / twist));
        }
    }
    return 1e-14 * largest; /* relative to the largest omega^2 that any joint gives its segment */
}

/* Start vectors that are normal to no mode: the same on every machine. */
static void space_start(Subspace *sp)
{
    unsigned long long seed = 88172645463325252ULL;
    for (size_t k = 0; k < (size_t)sp->q * (size_t)sp->size; ++k) {
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        sp->x[k] = (double)(seed >> 11) / 9007199254740992.0 - 0.5;
    }
}

static hawser_status shift_set(Subspace *sp, double gamma, hawser_error *err)
{
    sp->gamma = gamma;
    newton_form(sp->newton, gamma);
    const int bad = newton_factor(sp->newton);
    if (bad == 0) return HAWSER_OK;
    if (bad < 0) return error_memory(err);
    return error_set(err, HAWSER_ERR_RUN, "modes: the stiffness matrix could not be factored: is the state finite?");
}

/* M x for one direction. */
static void mass_times(const Subspace *sp, const double *x, double *out)
{
    const Newton *const nw = sp->newton;
    const int n = sp->n;
    for (int i = 0; i < n; ++i) {
        for (int r = 0; r < 3; ++r) {
            out[r * n + i] = nw->mass[i] * x[r * n + i];
            double sum = 0;
            for (int c = 0; c < 3; ++c) sum += nw->inertia[3 * r + c][i] * x[(3 + c) * n + i];
            out[(3 + r) * n + i] = sum;
        }
    }
}

/* y = A^-1 M x, by solving Newton's system with only velocities on the right-hand side (N7), (RD11). */
static hawser_status space_solve(Subspace *sp, hawser_error *err)
{
    const size_t bytes = (size_t)sp->size * sizeof(double);
    for (int k = 0; k < sp->q; ++k) {
        double *const velocities = sp->b + STATE_V * sp->n;
        memset(sp->b, 0, (size_t)sp->st->motion->size * sizeof(double));
        memcpy(velocities, sp->x + (size_t)k * (size_t)sp->size, bytes);
        const int bad = newton_solve(sp->newton, sp->b);
        if (bad < 0) return error_memory(err);
        if (bad) return error_set(err, HAWSER_ERR_RUN, "modes: the linear solver failed");
        memcpy(sp->y + (size_t)k * (size_t)sp->size, velocities, bytes);
    }
    return HAWSER_OK;
}

static double dot(int size, const double *a, const double *b)
{
    double sum = 0;
    for (int i = 0; i < size; ++i) sum += a[i] * b[i];
    return sum;
}

static void axpy(int size, double s, const double *a, double *b)
{
    for (int i = 0; i < size; ++i) b[i] += s * a[i];
}

static void scale_by(int size, double s, double *a)
{
    for (int i = 0; i < size; ++i) a[i] *= s;
}

/* Makes the columns of y M-orthonormal, in two passes, and applies the same operations to x, so that A y = M x still
 * holds: after a solution all columns are close to the lowest mode. */
static void space_orthonormalise(Subspace *sp)
{
    const size_t size = (size_t)sp->size;
    for (int k = 0; k < sp->q; ++k) {
        double *const y = sp->y + (size_t)k * size, *const x = sp->x + (size_t)k * size;
        for (int pass = 0; pass < 2; ++pass) {
            for (int r = 0; r < k; ++r) { /* m holds M times the columns before */
                const double share = -dot(sp->size, sp->m + (size_t)r * size, y);
                axpy(sp->size, share, sp->y + (size_t)r * size, y);
                axpy(sp->size, share, sp->x + (size_t)r * size, x);
            }
        }
        mass_times(sp, y, sp->m + (size_t)k * size);
        const double length = sqrt(dot(sp->size, y, sp->m + (size_t)k * size)), scale = 1 / (length + 1e-300);
        scale_by(sp->size, scale, y);
        scale_by(sp->size, scale, x);
        scale_by(sp->size, scale, sp->m + (size_t)k * size);
    }
}

/* out[r + q c] = y_r . (M of_c) */
static void project(Subspace *sp, const double *of, double *out)
{
    const size_t size = (size_t)sp->size;
    for (int c = 0; c < sp->q; ++c) mass_times(sp, of + (size_t)c * size, sp->m + (size_t)c * size);
    for (int c = 0; c < sp->q; ++c) {
        for (int r = 0; r < sp->q; ++r) {
            out[r + sp->q * c] = dot(sp->size, sp->y + (size_t)r * size, sp->m + (size_t)c * size);
        }
    }
}

/* Checks whether s is symmetric up to rounding; if so makes it exactly symmetric, as t always is. */
static int space_symmetric(Subspace *sp)
{
    double off = 0, largest = 0;
    const int q = sp->q;
    for (int c = 0; c < q; ++c) {
        for (int r = 0; r < q; ++r) {
            const double scale = sqrt(fabs(sp->s[r + q * r] * sp->s[c + q * c])) + 1e-300;
            off = fmax(off, fabs(sp->s[r + q * c] - sp->s[c + q * r]) / scale);
            largest = fmax(largest, fabs(sp->s[r + q * c]) / scale);
        }
    }
    const int symmetric = off <= SYMMETRIC * largest;
    for (int c = 0; c < q; ++c) {
        for (int r = 0; r < c; ++r) {
            const double t = (sp->t[r + q * c] + sp->t[c + q * r]) / 2, s = (sp->s[r + q * c] + sp->s[c + q * r]) / 2;
            sp->t[r + q * c] = sp->t[c + q * r] = t;
            if (symmetric) sp->s[r + q * c] = sp->s[c + q * r] = s;
        }
    }
    return symmetric;
}

/* Sorts columns by rising |mu|, the order in which the iteration converges. */
static void space_sort(Subspace *sp)
{
    for (int k = 0; k < sp->q; ++k) {
        const double size = hypot(sp->mu[k], sp->imaginary[k]);
        int at = k;
        for (; at > 0 && hypot(sp->mu[sp->order[at - 1]], sp->imaginary[sp->order[at - 1]]) > size; --at) {
            sp->order[at] = sp->order[at - 1];
        }
        sp->order[at] = k;
    }
}

/* x = y z, each direction scaled to M-length 1. */
static void space_combine(Subspace *sp)
{
    const size_t size = (size_t)sp->size;
    memset(sp->x, 0, (size_t)sp->q * size * sizeof(double));
    for (int k = 0; k < sp->q; ++k) {
        double *const x = sp->x + (size_t)k * size;
        for (int r = 0; r < sp->q; ++r) {
            const double share = sp->z[r + sp->q * sp->order[k]];
            const double *const y = sp->y + (size_t)r * size;
            axpy(sp->size, share, y, x);
        }
        mass_times(sp, x, sp->m);
        const double length = sqrt(dot(sp->size, x, sp->m));
        scale_by(sp->size, length > 0 ? 1 / length : 1, x);
    }
}

/* One iteration (RD12): solve, reduce, rotate. */
static hawser_status space_iterate(Subspace *sp, hawser_error *err)
{
    hawser_status status = space_solve(sp, err);
    if (status) return status;
    space_orthonormalise(sp);
    project(sp, sp->x, sp->s);
    project(sp, sp->y, sp->t);
    status = small_eigen(sp->q, space_symmetric(sp), sp->s, sp->t, sp->mu, sp->imaginary, sp->z, err);
    if (status) return status;
    space_sort(sp);
    space_combine(sp);
    return HAWSER_OK;
}

/* omega^2 of the k-th direction, real part, 1/s2 (RD13). */
static double omega2(const Subspace *sp, int k) { return (sp->mu[sp->order[k]] - 1) / (sp->gamma * sp->gamma); }

/* Largest change of the requested omega^2, relative to their own size or the shift's. */
static double space_change(Subspace *sp, int wanted)
{
    double largest = 0;
    for (int k = 0; k < wanted; ++k) {
        const double now = omega2(sp, k), size = fabs(now) + 1 / (sp->gamma * sp->gamma);
        largest = fmax(largest, fabs(now - sp->before[k]) / size);
        sp->before[k] = now;
    }
    return largest;
}

/* Finds a shift close below the lowest modes: from the stiffest first guess downward in a few steps (RD13). */
static hawser_status space_settle(Subspace *sp, hawser_error *err)
{
    double gamma = 1;
    hawser_status status = HAWSER_OK;
    for (int k = 0; !status && k < SETTLING; ++k) {
        status = shift_set(sp, gamma, err);
        for (int it = 0; !status && it < 3; ++it) status = space_iterate(sp, err);
        double lowest = INFINITY;
        for (int i = 0; !status && i < sp->q; ++i) {
            const double w2 = fabs(omega2(sp, i));
            if (w2 > sp->rounding) lowest = fmin(lowest, w2);
        }
        if (isfinite(lowest)) gamma = 1 / (SHIFT_BELOW * sqrt(lowest));
    }
    return status ? status : shift_set(sp, gamma, err);
}

/* ------------------------------------------------------------------------------------------------- results */

/* omega = sqrt(omega^2), complex where the pair is: frequency and growth rate (RD14). */
static void mode_put(const Subspace *sp, int k, hawser_mode *out)
{
    const double im = sp->imaginary[sp->order[k]] / (sp->gamma * sp->gamma);
    const double re = omega2(sp, k), size = hypot(re, im);
    *out = (hawser_mode){0};
    if (size < sp->rounding) return; /* a rigid motion */
    *out = (hawser_mode){.omega_squared = re,
                         .frequency_Hz = sqrt(fmax(0, (size + re) / 2)) / (2 * M_PI),
                         .growth_per_s = sqrt(fmax(0, (size - re) / 2))};
}

/* Scales the largest displacement to 1 m; a mode of rotation alone to 1 rad. */
static void shape_put(const Subspace *sp, int k, double *out)
{
    const int n = sp->n;
    const double *const x = sp->x + (size_t)k * (size_t)sp->size;
    double move = 0, turn = 0;
    for (int i = 0; i < n; ++i) {
        move = fmax(move, v3_norm(v3(x[i], x[n + i], x[2 * n + i])));
        turn = fmax(turn, v3_norm(v3(x[3 * n + i], x[4 * n + i], x[5 * n + i])));
    }
    const double length = 2 * n * sp->st->scene.chain.half[0], scale = move > 1e-6 * turn * length ? move : turn;
    for (int i = 0; i < n; ++i) {
        for (int c = 0; c < 6; ++c) out[6 * i + c] = x[c * n + i] / scale;
    }
}

/* Sorts by rising omega^2: growing motions come first. */
static void results_put(const Subspace *sp, int wanted, int *rank, Modes *modes)
{
    for (int k = 0; k < wanted; ++k) {
        int at = k;
        for (; at > 0 && omega2(sp, rank[at - 1]) > omega2(sp, k); --at) rank[at] = rank[at - 1];
        rank[at] = k;
    }
    for (int k = 0; k < wanted; ++k) {
        double *const shape = modes->shape + (size_t)k * (size_t)sp->size;
        mode_put(sp, rank[k], &modes->out[k]);
        shape_put(sp, rank[k], shape);
        modes->out[k].shape = shape;
    }
    modes->n = wanted;
}

/* Iterates until the requested modes no longer change. */
static hawser_status space_run(Subspace *sp, int wanted, Modes *modes, hawser_error *err)
{
    sp->rounding = modes_rounding(&sp->st->scene.chain, sp->radius);
    space_point(sp);
    space_start(sp);
    hawser_status status = space_settle(sp, err);
    double change = INFINITY;
    while (!status && change > CLOSE && modes->iterations < ITERATIONS_MAX) {
        status = space_iterate(sp, err);
        change = status ? 0 : space_change(sp, wanted);
        ++modes->iterations;
    }
    if (status || change <= 1e-6) return status;
    return error_set(err, HAWSER_ERR_RUN,
                     "%d modes did not settle in %d iterations (their frequencies still change by %.2g)", wanted,
                     ITERATIONS_MAX, change);
}

hawser_status modes_find(Stage *stage, int wanted, double radius, Modes *modes, hawser_error *err)
{
    const int n = stage->scene.chain.n, size = 6 * n;
    *modes = (Modes){.segments = n};
    if (stage->scene.equipment->n > 0)
        return error_set(err, HAWSER_ERR_INPUT, "key 'run.analysis': modes need rollers that neither spin nor move");
    if (wanted > size) wanted = size;
    Subspace sp = {.st = stage, .newton = &stage->newton, .n = n, .size = size, .radius = radius};
    sp.q = wanted + (wanted > GUARD ? wanted : GUARD) < size ? wanted + (wanted > GUARD ? wanted : GUARD) : size;
    modes->out = calloc((size_t)wanted + 1, sizeof *modes->out);
    modes->shape = calloc((size_t)wanted * (size_t)size + 1, sizeof *modes->shape);
    int *const rank = calloc((size_t)wanted + 1, sizeof *rank);
    hawser_status status = space_alloc(&sp) && modes->out && modes->shape && rank ? HAWSER_OK : error_memory(err);
    if (!status) status = space_run(&sp, wanted, modes, err);
    if (!status) results_put(&sp, wanted, rank, modes);
    free(rank);
    space_free(&sp);
    return status;
}

void modes_free(Modes *modes)
{
    free(modes->out);
    free(modes->shape);
    *modes = (Modes){0};
}
