#include "sim/equipment/roller_motion.h"

#include <stdlib.h>
#include <string.h>

#include "core/bushing.h"
#include "core/profile.h"

enum { ROOM = 4 }; /* segments that a roller of the usual size can touch at a time: two contacts' */

static int body_of(int m) { return 2 * m + 1; }

/* ------------------------------------------------------------------------------------------------- life */

static void sum_free(RollerSum *s)
{
    free(s->block);
    for (int kind = 0; kind < 2; ++kind) {
        free(s->into[kind]);
        free(s->from[kind]);
    }
    *s = (RollerSum){0};
}

int equipment_room(EquipmentWork *w, int k, int room)
{
    RollerSum *const s = &w->sum[k];
    sum_free(s);
    s->block = calloc((size_t)room, sizeof *s->block);
    int ok = s->block != NULL;
    for (int kind = 0; kind < 2; ++kind) {
        s->into[kind] = calloc((size_t)room, sizeof *s->into[kind]);
        s->from[kind] = calloc((size_t)room, sizeof *s->from[kind]);
        ok = ok && s->into[kind] && s->from[kind];
    }
    s->room = ok ? room : 0;
    return ok;
}

/* What exists only where there are mounts. */
static int mounts_alloc(EquipmentWork *w)
{
    const int bodies = 2 * w->q->mounts;
    if (bodies == 0) return 1;
    int ok = kinematics_alloc(&w->kin, bodies) && chain_struct_alloc(&w->joints, bodies) &&
             block_chain_alloc(&w->k, bodies, 6) && block_chain_alloc(&w->d, bodies, 6);
    for (int i = 0; ok && i < bodies; ++i) {
        for (int c = 0; c < 3; ++c) {
            w->kin.p[c][i] = w->q->ground.p[c][i];
            w->kin.a[c][i] = w->q->ground.a[c][i];
        }
        for (int c = 0; c < 4; ++c) w->kin.q[c][i] = w->q->ground.q[c][i];
    }
    return ok;
}

int equipment_work_alloc(EquipmentWork *w, const Equipment *q, int n_rollers, const ContactRoller *roller)
{
    const size_t rollers = (size_t)n_rollers, n = (size_t)q->n;
    memset(w, 0, sizeof *w);
    w->q = q;
    if (q->n == 0) return 1;
    w->item_of = malloc(rollers * sizeof *w->item_of);
    w->roller = malloc(rollers * sizeof *w->roller);
    w->motion = calloc(rollers, sizeof *w->motion);
    w->load = calloc(rollers, sizeof *w->load);
    w->motor = calloc(n, sizeof *w->motor);
    w->sum = calloc(n, sizeof *w->sum);
    w->stood = calloc(2 * n, sizeof *w->stood);
    int ok = w->item_of && w->roller && w->motion && w->load && w->motor && w->sum && w->stood && mounts_alloc(w);
    for (int k = 0; ok && k < q->n; ++k) ok = equipment_room(w, k, ROOM);
    if (!ok) {
        equipment_work_free(w);
        return 0;
    }
    for (int r = 0; r < n_rollers; ++r) w->item_of[r] = -1;
    for (int k = 0; k < q->n; ++k) w->item_of[q->item[k].roller] = k;
    memcpy(w->roller, roller, rollers * sizeof *roller);
    return 1;
}

void equipment_work_free(EquipmentWork *w)
{
    for (int k = 0; w->sum && k < w->q->n; ++k) sum_free(&w->sum[k]);
    free(w->item_of);
    free(w->roller);
    free(w->motion);
    free(w->load);
    free(w->motor);
    free(w->sum);
    free(w->stood);
    kinematics_free(&w->kin);
    chain_struct_free(&w->joints);
    block_chain_free(&w->k);
    block_chain_free(&w->d);
    memset(w, 0, sizeof *w);
}

/* ------------------------------------------------------------------------------------------------- motion */

/* Mount m from e into the mounts' chain; its roller's shape follows. */
static void mount_pose(EquipmentWork *w, const double *e, int m, Shape *shape)
{
    const Equipment *const q = w->q;
    const int i = body_of(m);
    double turn[4], square = 0;
    for (int c = 0; c < 3; ++c) {
        w->kin.p[c][i] = e[equipment_at(q, STATE_P + c, m)];
        w->kin.v[c][i] = e[equipment_at(q, STATE_V + c, m)];
        w->kin.w[c][i] = e[equipment_at(q, STATE_W + c, m)];
    }
    for (int c = 0; c < 4; ++c) {
        turn[c] = e[equipment_at(q, STATE_Q + c, m)];
        square += turn[c] * turn[c];
    }
    for (int c = 0; c < 4; ++c) w->kin.q[c][i] = turn[c] / sqrt(square);
    const Quat unit = {w->kin.q[0][i], w->kin.q[1][i], w->kin.q[2][i], w->kin.q[3][i]};
    shape->centre = v3_load(w->kin.p, i);
    shape->axis = quat_rotate(unit, v3(1, 0, 0));
    v3_store(w->kin.a, i, shape->axis);
}

void equipment_pose(EquipmentWork *w, const double *e)
{
    for (int k = 0; k < w->q->n; ++k) {
        const MovingRoller *const item = &w->q->item[k];
        Shape *const shape = &w->roller[item->roller].shape;
        RollerMotion motion = {v3(0, 0, 0), v3(0, 0, 0)};
        if (item->mount >= 0) {
            mount_pose(w, e, item->mount, shape);
            motion.v = v3_load(w->kin.v, body_of(item->mount));
            motion.w = v3_load(w->kin.w, body_of(item->mount));
        }
        if (item->spin >= 0) { /* (SP1) */
            const Vec3 b = shape->axis;
            motion.w = v3_axpy(motion.w, e[item->spin] - v3_dot(motion.w, b), b);
        }
        w->motion[item->roller] = motion;
    }
}

double equipment_shift(const EquipmentWork *w, const MovingRoller *item)
{
    const Vec3 stands = v3_load(w->q->ground.p, body_of(item->mount));
    return v3_norm(v3_sub(w->roller[item->roller].shape.centre, stands));
}

double equipment_turning(const EquipmentWork *w, int k)
{
    const MovingRoller *const item = &w->q->item[k];
    const Vec3 mount = item->mount >= 0 ? v3_load(w->kin.w, body_of(item->mount)) : v3(0, 0, 0);
    return v3_dot(v3_sub(w->motion[item->roller].w, mount), w->roller[item->roller].shape.axis);
}

/* Moment of contact, bearing and motor about the axis of roller k, which spins at s (SP8), N m. */
static double axis_moment(EquipmentWork *w, int k, double s, double friction)
{
    const MovingRoller *const item = &w->q->item[k];
    const RollerLoad *const load = &w->load[item->roller];
    const Vec3 b = w->roller[item->roller].shape.axis;
    const Vec3 turning = item->mount >= 0 ? v3_load(w->kin.w, body_of(item->mount)) : v3(0, 0, 0);
    double d_om, d_load;
    const double om = s - v3_dot(turning, b);
    const double held = friction * bearing_torque(&item->bearing, v3_norm(load->force), om, &d_om, &d_load);
    const double driven = friction * motor_torque(&w->motor[k], om, &d_om);
    w->lost_bearings -= held * om;
    w->by_motors += driven * om;
    return v3_dot(b, load->moment) + held + driven;
}

/* Rates of mount m from the force and moment on it. */
static void mount_rates(const EquipmentWork *w, const MovingRoller *item, const double *e, RollerLoad on, double *rate)
{
    const Equipment *const q = w->q;
    const int m = item->mount, i = body_of(m);
    const Quat turn = {e[equipment_at(q, STATE_Q, m)], e[equipment_at(q, STATE_Q + 1, m)],
                       e[equipment_at(q, STATE_Q + 2, m)], e[equipment_at(q, STATE_Q + 3, m)]};
    const Vec3 v = v3_load(w->kin.v, i), half = v3_scale(0.5, v3_load(w->kin.w, i));
    const Quat turning = quat_mul((Quat){0, half.x, half.y, half.z}, turn);
    const Vec3 a = v3_scale(1 / item->mass, on.force), spin = v3_scale(1 / item->turning, on.moment);
    const double out[STATE_SIZE] = {v.x, v.y, v.z, turning.w, turning.x, turning.y, turning.z,
                                    a.x, a.y, a.z, spin.x,    spin.y,    spin.z};
    for (int c = 0; c < STATE_SIZE; ++c) rate[equipment_at(q, c, m)] = out[c];
}

void equipment_rates(EquipmentWork *w, const double *e, double friction, double *rate)
{
    const Equipment *const q = w->q;
    w->lost_bearings = w->lost_mounts = w->by_motors = 0;
    if (q->mounts)
        w->lost_mounts = bushing_kernels()->loads(&q->bushings, &w->kin, 0, 2 * q->mounts, &w->joints).damping;
    for (int k = 0; k < q->n; ++k) {
        const MovingRoller *const item = &q->item[k];
        RollerLoad on = w->load[item->roller];
        double about = 0;
        if (item->spin >= 0) {
            about = axis_moment(w, k, e[item->spin], friction);
            rate[item->spin] = about / item->inertia;
        }
        if (item->mount < 0) continue;
        const int i = body_of(item->mount);
        const Vec3 b = w->roller[item->roller].shape.axis;
        if (item->spin >= 0) { /* the roller keeps what acts about its axis, and its spin resists turning (SP10) */
            const Vec3 gyro = v3_cross(v3_load(w->kin.w, i), b);
            on.moment = v3_axpy(v3_axpy(on.moment, -about, b), -item->inertia * e[item->spin], gyro);
        }
        on.force = v3_sub(on.force, v3_load(w->joints.force, i));
        on.moment = v3_add(on.moment, v3_load(w->joints.torque_b, i));
        if (w->held) on = (RollerLoad){v3(0, 0, 0), v3(0, 0, 0)};
        mount_rates(w, item, e, on, rate);
    }
}

/* ------------------------------------------------------------------------------------------------- derivatives */

void equipment_blocks_begin(EquipmentWork *w)
{
    for (int k = 0; k < w->q->n; ++k) {
        RollerSum *const s = &w->sum[k];
        s->touched = s->missed = 0;
        memset(s->own, 0, sizeof s->own);
    }
}

static void block_add(double to[36], const double from[36])
{
    for (int k = 0; k < 36; ++k) to[k] += from[k];
}

/* Where segment i is in the sum, a new place if need be; -1: there is no room left. */
static int place_of(RollerSum *s, int i)
{
    for (int k = 0; k < s->touched; ++k) {
        if (s->block[k] == i) return k;
    }
    if (s->touched == s->room) {
        ++s->missed;
        return -1;
    }
    const int k = s->touched++;
    s->block[k] = i;
    for (int kind = 0; kind < 2; ++kind) {
        memset(s->into[kind][k], 0, sizeof s->into[kind][k]);
        memset(s->from[kind][k], 0, sizeof s->from[kind][k]);
    }
    return k;
}

void equipment_blocks_take(EquipmentWork *w, int first, const RollerCoupling *coupling)
{
    const int item = w->item_of[first + coupling->roller];
    if (item < 0) return;
    RollerSum *const s = &w->sum[item];
    for (int kind = 0; kind < 2; ++kind) block_add(s->own[kind], coupling->own[kind]);
    for (int b = 0; b < 2; ++b) {
        const int place = coupling->body[b] < 0 ? -1 : place_of(s, coupling->body[b]);
        for (int kind = 0; kind < 2 && place >= 0; ++kind) {
            block_add(s->into[kind][place], coupling->into[kind][b]);
            block_add(s->from[kind][place], coupling->from[kind][b]);
        }
    }
}

void equipment_bushing_blocks(EquipmentWork *w)
{
    if (w->q->mounts == 0) return;
    block_chain_zero(&w->k);
    block_chain_zero(&w->d);
    bushing_blocks(&w->q->bushings, &w->kin, 0, 2 * w->q->mounts, &w->k, &w->d);
}

/* ------------------------------------------------------------------------------------------------- candidates */

void equipment_stand(EquipmentWork *w)
{
    for (int k = 0; k < w->q->n; ++k) {
        const Shape *const shape = &w->roller[w->q->item[k].roller].shape;
        w->stood[2 * k] = shape->centre;
        w->stood[2 * k + 1] = shape->axis;
    }
}

double equipment_moved(const EquipmentWork *w)
{
    double farthest = 0;
    for (int k = 0; w->q && k < w->q->n; ++k) {
        const Shape *const shape = &w->roller[w->q->item[k].roller].shape;
        const double arm = shape->radius + shape->half_width;
        const double moved =
            v3_norm(v3_sub(shape->centre, w->stood[2 * k])) + arm * v3_norm(v3_sub(shape->axis, w->stood[2 * k + 1]));
        farthest = fmax(farthest, moved);
    }
    return farthest;
}

/* ------------------------------------------------------------------------------------------------- balances */

double equipment_energy(const EquipmentWork *work, const double *e)
{
    const Equipment *const q = work->q;
    double sum = 0;
    for (int k = 0; k < q->n; ++k) {
        const MovingRoller *const item = &q->item[k];
        if (item->spin >= 0) sum += item->inertia * e[item->spin] * e[item->spin] / 2;
        for (int c = 0; c < 3 && item->mount >= 0; ++c) {
            const double v = e[equipment_at(q, STATE_V + c, item->mount)];
            const double w = e[equipment_at(q, STATE_W + c, item->mount)];
            sum += (item->mass * v * v + item->turning * w * w) / 2;
        }
    }
    return q->mounts ? sum + bushing_kernels()->energy(&q->bushings, &work->kin, 0, 2 * q->mounts).elastic : sum;
}
