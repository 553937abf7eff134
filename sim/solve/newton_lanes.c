/* The kernels of newton.h for one instruction set. Blocks are 6x6, column-major; a column is read as a lane whose last
 * two entries belong to the following memory (every array of blocks is padded) and are never stored. */
#include "sim/solve/form_lanes.h"
#include "sim/solve/newton.h"

typedef struct LaneQuat {
    Lane w;
    Lane3 u;
} LaneQuat;

LANE_INLINE LaneQuat lane_quat_mul(LaneQuat a, LaneQuat b)
{
    return (LaneQuat){a.w * b.w - l3_dot(a.u, b.u), l3_add(l3_axpy(l3_scale(a.w, b.u), b.w, a.u), l3_cross(a.u, b.u))};
}

LANE_INLINE LaneQuat lane_quat_load(double *const q[4], int i)
{
    return (LaneQuat){lane_load(q[0] + i), l3_load(q + 1, i)};
}

/* (1 - gamma/2 Omega)^-1 p (N3). */
LANE_INLINE LaneQuat lane_quat_eliminate(Lane3 w, double gamma, LaneQuat p)
{
    const Lane g = lane_set(gamma / 2), scale = 1 / (1 + g * g * l3_dot(w, w));
    const LaneQuat turned = lane_quat_mul((LaneQuat){lane_set(0), l3_scale(g, w)}, p);
    return (LaneQuat){scale * (p.w + turned.w), l3_scale(scale, l3_add(p.u, turned.u))};
}

/* Components first..first+width-1 of the 13n vector at LANES segments from i, of which `count` exist; the others are
 * 0. */
LANE_INLINE void vector_load(int n, const double *b, int first, int width, int i, int count, Lane *out)
{
    for (int c = 0; c < width; ++c) {
        const double *const from = b + (first + c) * n + i;
        out[c] = lane_set(0);
        if (count == LANES) {
            out[c] = lane_load(from);
        } else {
            memcpy(&out[c], from, (size_t)count * sizeof(double));
        }
    }
}

LANE_INLINE void vector_store(int n, double *b, int first, int width, int i, int count, const Lane *in)
{
    for (int c = 0; c < width; ++c) {
        double *const to = b + (first + c) * n + i;
        if (count == LANES) {
            lane_store(to, in[c]);
        } else {
            memcpy(to, &in[c], (size_t)count * sizeof(double));
        }
    }
}

/* Six lanes to rows of six, and back. */
LANE_INLINE void rows_store(const Lane in[6], int count, double *rows)
{
    for (int k = 0; k < count; ++k) {
        for (int c = 0; c < 6; ++c) rows[6 * k + c] = in[c][k];
    }
}
LANE_INLINE void rows_load(const double *rows, int count, Lane out[6])
{
    for (int c = 0; c < 6; ++c) out[c] = lane_set(0);
    for (int k = 0; k < count; ++k) {
        for (int c = 0; c < 6; ++c) out[c][k] = rows[6 * k + c];
    }
}

static void kernel_eliminate(Newton *nw, const double *b, int from, int to)
{
    const Lane gamma = lane_set(nw->gamma);
    for (int i = from; i < to; i += LANES) {
        const int count = to - i < LANES ? to - i : LANES;
        Lane in[STATE_SIZE], z[6], x[6];
        vector_load(nw->n, b, 0, STATE_SIZE, i, count, in);
        const LaneQuat q = lane_quat_load(nw->q, i);
        const LaneQuat residual = {in[STATE_Q], {in[STATE_Q + 1], in[STATE_Q + 2], in[STATE_Q + 3]}};
        const LaneQuat e = lane_quat_eliminate(l3_load(nw->w, i), nw->gamma, residual);
        const LaneQuat r = lane_quat_mul(e, (LaneQuat){q.w, l3_neg(q.u)});
        const Lane3 turn = l3_scale(2 * gamma / (q.w * q.w + l3_dot(q.u, q.u)), r.u);
        for (int c = 0; c < 3; ++c) z[c] = gamma * in[c];
        z[3] = turn.x;
        z[4] = turn.y;
        z[5] = turn.z;
        const Lane mass = lane_load(nw->mass + i);
        const Lane *const spin = in + STATE_W;
        for (int c = 0; c < 3; ++c) {
            x[c] = mass * in[STATE_V + c];
            x[3 + c] = lane_load(nw->inertia[3 * c] + i) * spin[0] + lane_load(nw->inertia[3 * c + 1] + i) * spin[1] +
                       lane_load(nw->inertia[3 * c + 2] + i) * spin[2];
        }
        rows_store(z, count, nw->z + 6 * i);
        rows_store(x, count, nw->x + 6 * i);
    }
}

/* sum + block x */
LANE_INLINE Lane block_times(const double *block, const double *x, Lane sum)
{
    for (int c = 0; c < 6; ++c) sum += lane_load(block + 6 * c) * lane_set(x[c]);
    return sum;
}

static void kernel_couple(Newton *nw, int from, int to)
{
    const BlockChain *const k = &nw->k;
    for (int i = from; i < to; ++i) {
        Lane beside = lane_set(0);
        Lane sum = lane_load(nw->x + 6 * i); /* includes two numbers of the next row, or of the padding */
        sum = block_times(k->diag + 36 * i, nw->z + 6 * i, sum);
        if (i > 0) beside = block_times(k->lower + 36 * i, nw->z + 6 * (i - 1), beside);
        if (i + 1 < nw->n) beside = block_times(k->upper + 36 * i, nw->z + 6 * (i + 1), beside);
        sum += beside;
        memcpy(nw->x + 6 * i, &sum, 6 * sizeof(double));
    }
}

static void kernel_expand(const Newton *nw, double *b, int from, int to)
{
    const Lane gamma = lane_set(nw->gamma);
    for (int i = from; i < to; i += LANES) {
        const int count = to - i < LANES ? to - i : LANES;
        Lane u[6], in[STATE_V];
        rows_load(nw->x + 6 * i, count, u);
        vector_load(nw->n, b, 0, STATE_V, i, count, in);
        const LaneQuat half_spin = {lane_set(0), l3_scale(0.5 * gamma, (Lane3){u[3], u[4], u[5]})};
        const LaneQuat moved = lane_quat_mul(half_spin, lane_quat_load(nw->q, i));
        const LaneQuat p = {in[STATE_Q] + moved.w,
                            l3_add((Lane3){in[STATE_Q + 1], in[STATE_Q + 2], in[STATE_Q + 3]}, moved.u)};
        const LaneQuat e = lane_quat_eliminate(l3_load(nw->w, i), nw->gamma, p);
        const Lane out[STATE_V] = {
            in[0] + gamma * u[0], in[1] + gamma * u[1], in[2] + gamma * u[2], e.w, e.u.x, e.u.y, e.u.z};
        vector_store(nw->n, b, 0, STATE_V, i, count, out);
        vector_store(nw->n, b, STATE_V, 6, i, count, u);
    }
}

static void kernel_form(Newton *nw, int from, int to)
{
    const BlockChain *const k = &nw->k, *const d = &nw->d, *const a = &nw->a;
    const double gamma = nw->gamma;
    for (int i = from; i < to; ++i) { /* column i: in rows i-1, i, i+1 */
        const int before = 36 * (i - 1), at = 36 * i, after = 36 * (i + 1);
        double s[9];
        newton_turn(gamma, v3_load(nw->w, i), s);
        block_form(6, 6, 6, k->diag + at, d->diag + at, s, gamma, a->diag + at);
        if (i > 0) block_form(6, 6, 6, k->upper + before, d->upper + before, s, gamma, a->upper + before);
        if (i + 1 < nw->n) block_form(6, 6, 6, k->lower + after, d->lower + after, s, gamma, a->lower + after);
        double *const diag = a->diag + at;
        for (int c = 0; c < 3; ++c) {
            diag[7 * c] += nw->mass[i];
            for (int r = 0; r < 3; ++r) diag[6 * (3 + c) + 3 + r] += nw->inertia[3 * r + c][i];
        }
    }
}

static void kernel_block(int rows, int positions, int cols, const double *k, const double *d, const double s[9],
                         double gamma, double *out)
{
    block_form(rows, positions, cols, k, d, s, gamma, out);
}

const NewtonKernels ISA_NAME(newton_kernels) = {kernel_eliminate, kernel_couple, kernel_expand, kernel_form,
                                                kernel_block};
