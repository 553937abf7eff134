/* The kernels of planar.h for one instruction set. */
#include <math.h>

#include "core/plane_lanes.h"
#include "core/state.h"
#include "sim/solve/form_lanes.h"
#include "sim/solve/planar.h"
#include "sim/solve/scales.h"

/* Effect of the lead-in on LANES segments, per mass held: the gravity that it removes, and its hold across its line;
 * and the share of the mass that it holds (F1). */
typedef struct LeadIn {
    Lane2 pull; /* m/s2 */
    Lane held;
} LeadIn;

LANE_INLINE LeadIn lead_in_at(const PlanarWeight *w, const PlanarKinematics *kin, int i)
{
    const Lane2 along = {lane_set(w->direction[0]), lane_set(w->direction[1])}, across = l2_turn(along);
    const Lane2 off = l2_sub(l2_load(kin->p, i), (Lane2){lane_set(w->origin[0]), lane_set(w->origin[1])});
    const Lane share = lane_step(l2_dot(off, along) / w->blend, lane_set(-0.5), lane_set(0.5)).value;
    const Lane hold = -w->hold * l2_dot(off, across) - w->hold_damping * l2_dot(l2_load(kin->v, i), across);
    const Lane2 lost = {lane_set(w->lost[0]), lane_set(w->lost[1])};
    return (LeadIn){l2_axpy(lost, hold, across), 1 - share};
}

static PlanarPower kernel_weight(const PlanarWeight *w, const PlanarChain *chain, const PlanarKinematics *kin, int from,
                                 int to, int behind, PlanarLoads *loads)
{
    const Lane2 gravity = {lane_set(w->gravity[0]), lane_set(w->gravity[1])};
    Lane power = lane_set(0); /* of the lead-in; the padding of the chain's mass is zero, so that other lanes add
                               * nothing */
    Lane2 sum = {power, power};
    for (int i = from; i < to; i += LANES) {
        const Lane mass = lane_load(chain->mass + i);
        Lane2 f = l2_scale(mass, gravity);
        if (i < behind) { /* the rest of the last lane is past the start too */
            const LeadIn by = lead_in_at(w, kin, i);
            f = l2_add(f, l2_scale(by.held * mass, by.pull));
            /* multiplied in another order than the force, whose product is fused with its sum */
            power += by.held * l2_dot(by.pull, l2_load(kin->v, i)) * mass;
            sum = l2_add(sum, l2_scale(mass, l2_scale(by.held, by.pull)));
        }
        l2_store(loads->f, i, f);
        lane_store(loads->m + i, lane_set(0));
    }
    return (PlanarPower){lane_sum(power), {lane_sum(sum.x), lane_sum(sum.z)}};
}

/* ---------------------------------------------------------------------------------------------- Newton's matrix */

static void kernel_eliminate(PlanarNewton *nw, const double *b, int from, int to)
{
    const int stride = nw->chain->stride;
    for (int i = from; i < to; i += LANES) {
        for (int c = 0; c < 3; ++c) lane_store(nw->z[c] + i, nw->gamma * lane_load(b + c * stride + i));
    }
}

/* sum + block z, LANES rows from i, the z of their column's segments from j */
LANE_INLINE void block_times(double *const block[9], int i, double *const z[3], int j, Lane sum[3])
{
    for (int c = 0; c < 3; ++c) {
        const Lane zc = lane_load(z[c] + j);
        for (int r = 0; r < 3; ++r) sum[r] += lane_load(block[3 * c + r] + i) * zc;
    }
}

/* Between three lanes and rows of three in memory. */
LANE_INLINE void rows_store(const Lane in[3], double *rows)
{
    const Lane xz = __builtin_shufflevector(in[0], in[1], 0, 8, 0, 1, 9, 0, 2, 10);
    const Lane low = __builtin_shufflevector(xz, in[2], 0, 1, 8, 3, 4, 9, 6, 7);
    const Lane xz2 = __builtin_shufflevector(in[0], in[1], 0, 3, 11, 0, 4, 12, 0, 5);
    const Lane middle = __builtin_shufflevector(xz2, in[2], 10, 1, 2, 11, 4, 5, 12, 7);
    const Lane xz3 = __builtin_shufflevector(in[0], in[1], 13, 0, 6, 14, 0, 7, 15, 0);
    const Lane high = __builtin_shufflevector(xz3, in[2], 0, 13, 2, 3, 14, 5, 6, 15);
    lane_store(rows, low);
    lane_store(rows + LANES, middle);
    lane_store(rows + 2 * LANES, high);
}
LANE_INLINE void rows_load(const double *rows, Lane out[3])
{
    const Lane a = lane_load(rows), b = lane_load(rows + LANES), c = lane_load(rows + 2 * LANES);
    const Lane x = __builtin_shufflevector(a, b, 0, 3, 6, 9, 12, 15, 0, 0);
    const Lane y = __builtin_shufflevector(a, b, 1, 4, 7, 10, 13, 0, 0, 0);
    const Lane z = __builtin_shufflevector(a, b, 2, 5, 8, 11, 14, 0, 0, 0);
    out[0] = __builtin_shufflevector(x, c, 0, 1, 2, 3, 4, 5, 10, 13);
    out[1] = __builtin_shufflevector(y, c, 0, 1, 2, 3, 4, 8, 11, 14);
    out[2] = __builtin_shufflevector(z, c, 0, 1, 2, 3, 4, 9, 12, 15);
}

static void kernel_couple(PlanarNewton *nw, const double *b, int from, int to)
{
    const PlanarBlocks *const k = &nw->k;
    const PlanarChain *const chain = nw->chain;
    const int stride = chain->stride;
    for (int i = from; i < to; i += LANES) {
        const Lane mass = lane_load(chain->mass + i);
        const double *const bu = b + PLANAR_V * stride + i;
        Lane sum[3] = {mass * lane_load(bu), mass * lane_load(bu + stride),
                       lane_load(chain->inertia + i) * lane_load(bu + 2 * stride)};
        block_times(k->diag, i, nw->z, i, sum);
        block_times(k->lower, i, nw->z, i - 1, sum);
        block_times(k->upper, i, nw->z, i + 1, sum);
        rows_store(sum, nw->x + 3 * i);
    }
}

static void kernel_expand(const PlanarNewton *nw, double *b, int from, int to)
{
    const int stride = nw->chain->stride;
    for (int i = from; i < to; i += LANES) {
        Lane u[3];
        rows_load(nw->x + 3 * i, u);
        for (int c = 0; c < 3; ++c) {
            double *const at = b + c * stride + i;
            lane_store(at, lane_load(at) + nw->gamma * u[c]);
            lane_store(at + PLANAR_V * stride, u[c]);
        }
    }
}

/* Writes entry e of -gamma D - gamma^2 K of LANES rows into row-by-row blocks, of which `count` exist. */
LANE_INLINE void entry_form(double *const k[9], double *const d[9], int e, int i, int count, double gamma, double *out)
{
    const Lane value = newton_entry(gamma, lane_load(d[e] + i), lane_load(k[e] + i));
    for (int l = 0; l < count; ++l) out[9 * (i + l) + e] = value[l];
}

static void kernel_form(PlanarNewton *nw, int from, int to)
{
    const PlanarChain *const chain = nw->chain;
    for (int i = from; i < to; i += LANES) {
        const int count = to - i < LANES ? to - i : LANES;
        for (int e = 0; e < 9; ++e) {
            entry_form(nw->k.lower, nw->d.lower, e, i, count, nw->gamma, nw->a.lower);
            entry_form(nw->k.diag, nw->d.diag, e, i, count, nw->gamma, nw->a.diag);
            entry_form(nw->k.upper, nw->d.upper, e, i, count, nw->gamma, nw->a.upper);
        }
        for (int l = i; l < i + count; ++l) {
            nw->a.diag[9 * l] += chain->mass[l];
            nw->a.diag[9 * l + 4] += chain->mass[l];
            nw->a.diag[9 * l + 8] += chain->inertia[l];
        }
    }
}

/* --------------------------------------------------------------------------------------- norm, and into space */

/* The lanes from i on, if the chain is that long; its padding is zero. */
LANE_INLINE Lane lane_square(int stride, const double *x, const Lane w[PLANAR_SIZE], int i)
{
    Lane sum = lane_set(0);
    for (int c = 0; c < PLANAR_SIZE && i < stride; ++c) {
        const Lane a = lane_load(x + c * stride + i) * w[c];
        sum += a * a;
    }
    return sum;
}

static double kernel_window_square(const PlanarChain *chain, int first, int last, const double *x, const double *weight)
{
    _Static_assert((int)SCALES_WINDOW == 2 * (int)LANES, "a window is two lanes");
    double largest = 0;
    Lane w[PLANAR_SIZE];
    for (int c = 0; c < PLANAR_SIZE; ++c) w[c] = lane_set(weight[c * chain->stride]);
    for (int from = first; from < last; from += SCALES_WINDOW) {
        const int count = from + SCALES_WINDOW < last ? SCALES_WINDOW : last - from;
        const Lane sum = lane_square(chain->stride, x, w, from) + lane_square(chain->stride, x, w, from + LANES);
        double total = 0;
        for (int k = 0; k < LANES; ++k) total += sum[k];
        const double mean = total / (STATE_SIZE * count);
        if (mean > largest || isnan(mean)) largest = mean; /* a NaN is kept: no comparison with it is true */
    }
    return largest;
}

/* x e1 + z e2 */
LANE_INLINE Lane3 lifted(const Plane *p, Lane2 v)
{
    return (Lane3){p->e1.x * v.x + p->e2.x * v.z, p->e1.y * v.x + p->e2.y * v.z, p->e1.z * v.x + p->e2.z * v.z};
}

static void kernel_lift(const Plane *p, const PlanarChain *chain, const PlanarKinematics *from, Kinematics *to)
{
    const Vec3 m = p->normal;
    const Quat q = p->flat;
    /* (0, m) q */
    const Quat mq = {-m.x * q.x - m.y * q.y - m.z * q.z, m.x * q.w + m.y * q.z - m.z * q.y,
                     m.y * q.w + m.z * q.x - m.x * q.z, m.z * q.w + m.x * q.y - m.y * q.x};
    for (int i = 0; i <= chain->n; i += LANES) {
        const Lane3 o = {lane_set(p->origin.x), lane_set(p->origin.y), lane_set(p->origin.z)};
        const Lane2 h = l2_load(from->h, i);
        const Lane w = lane_load(from->w + i);
        l3_store(to->p, i, l3_add(o, lifted(p, l2_load(from->p, i))));
        l3_store(to->a, i, lifted(p, l2_load(from->a, i)));
        l3_store(to->v, i, lifted(p, l2_load(from->v, i)));
        l3_store(to->w, i, (Lane3){m.x * w, m.y * w, m.z * w});
        lane_store(to->q[0] + i, h.x * q.w + h.z * mq.w);
        l3_store(to->q + 1, i, (Lane3){h.x * q.x + h.z * mq.x, h.x * q.y + h.z * mq.y, h.x * q.z + h.z * mq.z});
    }
}

/* (BA11); the padding of the lanes behind the chain has no mass. */
static MethodLoss kernel_method_loss(const PlanarChain *chain, const double *y, const double *rates, double scale,
                                     double *past)
{
    const int stride = chain->stride;
    const Lane half = lane_set(0.5);
    Lane lost = lane_set(0), moving = lost;
    for (int c = 0; c < 3; ++c) {
        const double *const inertia = c == PLANAR_ANGLE ? chain->inertia : chain->mass;
        double *const kept = past + 3 * c * stride;
        for (int i = 0; i < chain->n; i += LANES) {
            const Lane m = lane_load(inertia + i), x = lane_load(y + c * stride + i);
            const Lane v = lane_load(y + (PLANAR_V + c) * stride + i);
            const Lane force = m * scale * lane_load(rates + (PLANAR_V + c) * stride + i);
            const Lane v0 = lane_load(kept + stride + i);
            lost += half *
                    ((force + lane_load(kept + 2 * stride + i)) * (x - lane_load(kept + i)) - m * (v + v0) * (v - v0));
            moving += half * m * v * v;
            lane_store(kept + i, x);
            lane_store(kept + stride + i, v);
            lane_store(kept + 2 * stride + i, force);
        }
    }
    return (MethodLoss){lane_sum(lost), lane_sum(moving)};
}

const PlanarSimKernels ISA_NAME(planar_sim_kernels) = {kernel_weight, kernel_eliminate,  kernel_couple,
                                                       kernel_expand, kernel_form,       kernel_window_square,
                                                       kernel_lift,   kernel_method_loss};
