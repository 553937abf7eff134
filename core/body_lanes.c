/* The kernels of core/body.h for one instruction set. The last, incomplete lane goes through a padded copy of its
 * columns of the state, so that nothing is read or written beyond it. */
#include "core/body.h"
#include "core/joint_lanes.h"
#include "core/state.h"

/* Copies `count` entries from index i of each of the 13 arrays between the state and a padded buffer. */
LANE_INLINE void columns_in(int n, const double *y, int i, int count, double buffer[STATE_SIZE][LANES])
{
    for (int c = 0; c < STATE_SIZE; ++c) memcpy(buffer[c], y + c * n + i, (size_t)count * sizeof(double));
}
LANE_INLINE void columns_out(int n, double *y, int i, int count, double buffer[STATE_SIZE][LANES])
{
    for (int c = 0; c < STATE_SIZE; ++c) memcpy(y + c * n + i, buffer[c], (size_t)count * sizeof(double));
}

/* src[c] points at the first of LANES entries of array c. */
LANE_INLINE void kinematics_of(const double *const src[STATE_SIZE], int i, Kinematics *kin)
{
    for (int c = 0; c < 3; ++c) {
        lane_store(kin->p[c] + i, lane_load(src[STATE_P + c]));
        lane_store(kin->v[c] + i, lane_load(src[STATE_V + c]));
        lane_store(kin->w[c] + i, lane_load(src[STATE_W + c]));
    }
    Lane w = lane_load(src[STATE_Q]);
    Lane3 u = {lane_load(src[STATE_Q + 1]), lane_load(src[STATE_Q + 2]), lane_load(src[STATE_Q + 3])};
    const Lane scale = 1 / lane_sqrt(w * w + l3_dot(u, u));
    w *= scale;
    u = l3_scale(scale, u);
    lane_store(kin->q[0] + i, w);
    l3_store(kin->q + 1, i, u);
    l3_store(kin->a, i, frame_of_quaternion(w, u).x);
}

static void kernel_kinematics(int n, const double *y, int from, int to, Kinematics *kin)
{
    const double *src[STATE_SIZE];
    int i = from;
    for (; i + LANES <= to; i += LANES) {
        for (int c = 0; c < STATE_SIZE; ++c) src[c] = y + c * n + i;
        kinematics_of(src, i, kin);
    }
    if (i == to) return;
    double buffer[STATE_SIZE][LANES] = {{0}};
    for (int k = 0; k < LANES; ++k) buffer[STATE_Q][k] = 1;
    columns_in(n, y, i, to - i, buffer);
    for (int c = 0; c < STATE_SIZE; ++c) src[c] = buffer[c];
    kinematics_of(src, i, kin);
}

/* Rates of LANES segments from i; q: their quaternions as in the state. dst like src above. */
LANE_INLINE void rates_of(const Chain *chain, const Kinematics *kin, const JointLoads *joints, const Loads loads[2],
                          int i, Lane qw, Lane3 qu, double *const dst[STATE_SIZE])
{
    const Lane3 v = l3_load(kin->v, i), w = l3_load(kin->w, i);
    const Lane half = lane_set(0.5);
    l3_store(dst + STATE_P, 0, v);
    lane_store(dst[STATE_Q], -half * l3_dot(w, qu));
    l3_store(dst + STATE_Q + 1, 0, l3_scale(half, l3_add(l3_scale(qw, w), l3_cross(w, qu))));

    const Lane3 from_joints = l3_sub(l3_load(joints->force, i + 1), l3_load(joints->force, i));
    const Lane3 applied = l3_add(l3_load(loads[0].f, i), l3_load(loads[1].f, i));
    const Lane3 force = l3_add(from_joints, applied);
    l3_store(dst + STATE_V, 0, l3_scale(1 / lane_load(chain->mass + i), force));

    const Lane3 turning = l3_add(l3_load(joints->torque_a, i + 1), l3_load(joints->torque_b, i));
    const LaneFrame frame = frame_of_quaternion(lane_load(kin->q[0] + i), l3_load(kin->q + 1, i));
    const Lane3 inertia = l3_load(chain->inertia, i);
    const Lane3 wb = frame_in(&frame, w);
    const Lane3 moment =
        l3_sub(frame_in(&frame, l3_add(turning, l3_add(l3_load(loads[0].m, i), l3_load(loads[1].m, i)))),
               l3_cross(wb, l3_times(inertia, wb)));
    const Lane3 spin = {moment.x / inertia.x, moment.y / inertia.y, moment.z / inertia.z};
    l3_store(dst + STATE_W, 0, frame_out(&frame, spin));
}

static void kernel_rates(const Chain *chain, const Kinematics *kin, const JointLoads *joints, const Loads loads[2],
                         const double *y, int from, int to, double *ydot)
{
    const int n = chain->n;
    double *dst[STATE_SIZE];
    int i = from;
    for (; i + LANES <= to; i += LANES) {
        for (int c = 0; c < STATE_SIZE; ++c) dst[c] = ydot + c * n + i;
        const double *const q = y + STATE_Q * n + i;
        const Lane3 qu = {lane_load(q + n), lane_load(q + 2 * n), lane_load(q + 3 * n)};
        rates_of(chain, kin, joints, loads, i, lane_load(q), qu, dst);
    }
    if (i == to) return;
    double in[STATE_SIZE][LANES] = {{0}}, out[STATE_SIZE][LANES] = {{0}};
    columns_in(n, y, i, to - i, in);
    for (int c = 0; c < STATE_SIZE; ++c) dst[c] = out[c];
    const Lane3 qu = {lane_load(in[STATE_Q + 1]), lane_load(in[STATE_Q + 2]), lane_load(in[STATE_Q + 3])};
    rates_of(chain, kin, joints, loads, i, lane_load(in[STATE_Q]), qu, dst);
    columns_out(n, ydot, i, to - i, out);
}

/* (BA11) of LANES segments from i: sums to *lost and *moving. src and rate point at the first of LANES entries of each
 * array. Moments are in the body's axes, in which the rotation from the pose before has the same components in both
 * poses. */
LANE_INLINE void method_loss_of(const Chain *chain, const double *const src[STATE_SIZE],
                                const double *const rate[STATE_SIZE], double scale, int i,
                                double *const past[BODY_PAST], Lane *lost, Lane *moving)
{
    const Lane half = lane_set(0.5), mass = lane_load(chain->mass + i);
    const Lane3 inertia = l3_load(chain->inertia, i);
    const Lane3 p = {lane_load(src[0]), lane_load(src[1]), lane_load(src[2])};
    const Lane qw = lane_load(src[STATE_Q]);
    const Lane3 qu = {lane_load(src[STATE_Q + 1]), lane_load(src[STATE_Q + 2]), lane_load(src[STATE_Q + 3])};
    const Lane3 v = {lane_load(src[STATE_V]), lane_load(src[STATE_V + 1]), lane_load(src[STATE_V + 2])};
    const LaneFrame frame = frame_of_quaternion(qw, qu);
    const Lane3 w =
        frame_in(&frame, (Lane3){lane_load(src[STATE_W]), lane_load(src[STATE_W + 1]), lane_load(src[STATE_W + 2])});
    const Lane3 dv = {lane_load(rate[STATE_V]), lane_load(rate[STATE_V + 1]), lane_load(rate[STATE_V + 2])};
    const Lane3 dw =
        frame_in(&frame, (Lane3){lane_load(rate[STATE_W]), lane_load(rate[STATE_W + 1]), lane_load(rate[STATE_W + 2])});
    const Lane3 spin = l3_times(inertia, w);
    const Lane3 force = l3_scale(mass * scale, dv);
    const Lane3 moment = l3_axpy(l3_cross(w, spin), lane_set(scale), l3_times(inertia, dw));

    const Lane3 p0 = l3_load(past, 0), u0 = l3_load(past + 4, 0), v0 = l3_load(past + 7, 0), w0 = l3_load(past + 10, 0);
    const Lane q0 = lane_load(past[3]);
    const Lane3 way = l3_sub(p, p0); /* and the rotation: twice the vector of conj(q0) q */
    const Lane3 turn = l3_scale(lane_set(2), l3_sub(l3_sub(l3_scale(q0, qu), l3_scale(qw, u0)), l3_cross(u0, qu)));
    const Lane work =
        l3_dot(l3_add(force, l3_load(past + 13, 0)), way) + l3_dot(l3_add(moment, l3_load(past + 16, 0)), turn);
    const Lane gain =
        mass * l3_dot(l3_add(v, v0), l3_sub(v, v0)) + l3_dot(l3_times(inertia, l3_add(w, w0)), l3_sub(w, w0));
    *lost += half * (work - gain);
    *moving += half * (mass * l3_dot(v, v) + l3_dot(w, spin));

    l3_store(past, 0, p);
    lane_store(past[3], qw);
    l3_store(past + 4, 0, qu);
    l3_store(past + 7, 0, v);
    l3_store(past + 10, 0, w);
    l3_store(past + 13, 0, force);
    l3_store(past + 16, 0, moment);
}

static MethodLoss kernel_method_loss(const Chain *chain, const double *y, const double *rates, double scale, int from,
                                     int to, double *past)
{
    const int n = chain->n, stride = (n + LANES - 1) / LANES * LANES;
    const double *src[STATE_SIZE], *rate[STATE_SIZE];
    double *kept[BODY_PAST];
    Lane lost = lane_set(0), moving = lane_set(0);
    for (int i = from; i < to; i += LANES) {
        double in[STATE_SIZE][LANES] = {{0}}, by[STATE_SIZE][LANES] = {{0}};
        const int tail = i + LANES > to;
        if (tail) {
            columns_in(n, y, i, to - i, in);
            columns_in(n, rates, i, to - i, by);
        }
        for (int c = 0; c < STATE_SIZE; ++c) {
            src[c] = tail ? in[c] : y + c * n + i;
            rate[c] = tail ? by[c] : rates + c * n + i;
        }
        for (int c = 0; c < BODY_PAST; ++c) kept[c] = past + c * stride + i;
        method_loss_of(chain, src, rate, scale, i, kept, &lost, &moving);
    }
    return (MethodLoss){lane_sum(lost), lane_sum(moving)};
}

const BodyKernels ISA_NAME(body_kernels) = {kernel_method_loss, kernel_kinematics, kernel_rates};
