#include "sim/equipment/rollers.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/bushing.h"
#include "core/error.h"
#include "core/profile.h"
#include "sim/dynamics.h"
#include "sim/equipment/rooms.h"

static void equipment_work_free(EquipmentWork *w);
static void equipment_clear(Equipment *q);

enum { ROOM = 4 }; /* segments that a roller of usual size can touch at a time: those of two contacts */

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

/* Allocates the arrays that exist with mounts only. */
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

/* Allocates for the rollers of a scene, n_rollers in all. 0 if there is no memory; nothing is allocated if nothing
 * moves. The free may be called on a zeroed struct. */
static int equipment_work_alloc(EquipmentWork *w, const Equipment *q, int n_rollers, const ContactRoller *roller)
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

static void equipment_work_free(EquipmentWork *w)
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

/* Writes mount m from e into the mounts' chain; its roller's shape follows. */
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

/* Poses and motions from e (SP1). */
static void equipment_pose(EquipmentWork *w, const double *e)
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

/* Moment of contact, bearing and motor about the axis of roller k, whose spin is s (SP8), N m. */
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

/* Rates of e (SP8), (SP10) from poses and loads; friction scales the torques of bearings and motors. */
static void equipment_rates(EquipmentWork *w, const double *e, double friction, double *rate)
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
        if (item->spin >= 0) { /* the roller keeps the moment about its own axis, and its spin resists tilting (SP10) */
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

/* Adds the contacts' derivatives one by one: coupling->roller counts from roller `first`. */
static void equipment_blocks_begin(EquipmentWork *w)
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

/* Index of segment i in the sum, a new one if needed; -1: the array is full. */
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

/* Derivatives of the bushings into w->k, w->d. */
static void equipment_bushing_blocks(EquipmentWork *w)
{
    if (w->q->mounts == 0) return;
    block_chain_zero(&w->k);
    block_chain_zero(&w->d);
    bushing_blocks(&w->q->bushings, &w->kin, 0, 2 * w->q->mounts, &w->k, &w->d);
}

/* ------------------------------------------------------------------------------------------------- candidates */

/* Stores the rollers' places; the second returns the largest motion since then, with the effect of tilting, m. */
static void equipment_stand(EquipmentWork *w)
{
    for (int k = 0; k < w->q->n; ++k) {
        const Shape *const shape = &w->roller[w->q->item[k].roller].shape;
        w->stood[2 * k] = shape->centre;
        w->stood[2 * k + 1] = shape->axis;
    }
}

static double equipment_moved(const EquipmentWork *w)
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

/* Energy of rollers that spin or stand on mounts, J (BA8), for the poses in w and the state e. */
static double equipment_energy(const EquipmentWork *work, const double *e)
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

/* Bodies of the mounts' chain: the ground under mount m, then the mount. */
static int ground_of(int m) { return 2 * m; }

static void counts_fill(const SceneDef *def, Equipment *q)
{
    for (int r = 0; r < def->n_rollers; ++r) {
        const RollerDef *const d = &def->rollers[r];
        q->spins += d->spin.inertia > 0;
        q->mounts += d->mount.present;
        q->n += d->spin.inertia > 0 || d->mount.present;
    }
}

static MovingRoller item_of(const RollerDef *d, int roller, int spin, int mount)
{
    const int spins = d->spin.inertia > 0, mounted = d->mount.present;
    return (MovingRoller){.roller = roller,
                          .spin = spins ? spin : -1,
                          .mount = mounted ? mount : -1,
                          .size = spins + 6 * mounted,
                          .inertia = d->spin.inertia,
                          .bearing = {d->spin.friction, d->spin.journal, d->spin.torque, d->spin.speed},
                          .mass = d->mount.mass,
                          .turning = d->mount.inertia};
}

/* The mount's frame: x along the roller's axis, z as far up as possible (along world x if the axis is vertical). */
static Quat attitude_of(Vec3 axis)
{
    const Vec3 x = v3_unit(axis), up = fabs(x.z) < 0.99 ? v3(0, 0, 1) : v3(1, 0, 0);
    const Vec3 z = v3_unit(v3_reject(up, x));
    return quat_from_axes(x, v3_cross(z, x), z);
}

/* Ground and mount m at the same place, with the bushing between them. */
static void bushing_fill(Equipment *q, const MountDef *d, const Shape *shape, int m)
{
    const Quat at = attitude_of(shape->axis);
    const double p[3] = {shape->centre.x, shape->centre.y, shape->centre.z};
    const double turn[4] = {at.w, at.x, at.y, at.z}, axis[3] = {shape->axis.x, shape->axis.y, shape->axis.z};
    for (int i = ground_of(m); i <= body_of(m); ++i) {
        for (int c = 0; c < 3; ++c) {
            q->ground.p[c][i] = p[c];
            q->ground.a[c][i] = axis[c];
        }
        for (int c = 0; c < 4; ++c) q->ground.q[c][i] = turn[c];
        q->bushings.half[i] = 0;
    }
    for (int c = 0; c < 6; ++c) {
        q->bushings.stiffness[c][body_of(m)] = d->stiffness[c];
        q->bushings.damping[c][body_of(m)] = d->damping * d->stiffness[c];
    }
}

/* Builds from the rollers of a definition, whose shapes are roller[n_rollers]. Errors: MEMORY. */
static hawser_status equipment_build(const SceneDef *def, const ContactRoller *roller, Equipment *q, hawser_error *err)
{
    memset(q, 0, sizeof *q);
    counts_fill(def, q);
    if (q->n == 0) return HAWSER_OK;
    q->item = calloc((size_t)q->n, sizeof *q->item);
    int ok = q->item != NULL;
    if (q->mounts) ok = ok && chain_alloc(&q->bushings, 2 * q->mounts) && kinematics_alloc(&q->ground, 2 * q->mounts);
    if (!ok) {
        equipment_clear(q);
        return error_memory(err);
    }
    q->bushings.frame = def->frame;
    for (int r = 0, k = 0, spin = 0, mount = 0; r < def->n_rollers; ++r) {
        const MovingRoller item = item_of(&def->rollers[r], r, spin, mount);
        if (item.size == 0) continue;
        if (item.mount >= 0) bushing_fill(q, &def->rollers[r].mount, &roller[r].shape, item.mount);
        spin += item.spin >= 0;
        mount += item.mount >= 0;
        q->item[k++] = item;
    }
    return HAWSER_OK;
}

static void equipment_clear(Equipment *q)
{
    free(q->item);
    if (q->mounts) {
        chain_free(&q->bushings);
        kinematics_free(&q->ground);
    }
    memset(q, 0, sizeof *q);
}

/* Number of entries of e, and of velocities among them. */
static int equipment_size(const Equipment *q) { return q->spins + STATE_SIZE * q->mounts; }

/* Writes e at rest at the places of the case. */
static void equipment_initial(const Equipment *q, double *e)
{
    memset(e, 0, (size_t)equipment_size(q) * sizeof *e);
    for (int m = 0; m < q->mounts; ++m) {
        for (int c = 0; c < 3; ++c) e[equipment_at(q, STATE_P + c, m)] = q->ground.p[c][ground_of(m)];
        for (int c = 0; c < 4; ++c) e[equipment_at(q, STATE_Q + c, m)] = q->ground.q[c][ground_of(m)];
    }
}

void equipment_weights(const Equipment *q, const ContactRoller *roller, const EquipmentTolerances *t, double *weight)
{
    for (int k = 0; k < q->n; ++k) {
        const MovingRoller *const item = &q->item[k];
        if (item->spin >= 0) weight[item->spin] = roller[item->roller].shape.radius / t->velocity;
        for (int c = 0; item->mount >= 0 && c < STATE_SIZE; ++c) {
            const double atol = c < STATE_Q   ? t->position
                                : c < STATE_V ? t->rotation / 2
                                : c < STATE_W ? t->velocity
                                              : t->omega;
            weight[equipment_at(q, c, item->mount)] = 1 / atol;
        }
    }
}

/* Three entries of e from component c of mount m on. */
static Vec3 mount_vector(const Equipment *q, const double *e, int c, int m)
{
    const double *const at = e + equipment_at(q, c, m);
    return v3(at[0], at[q->mounts], at[2 * q->mounts]);
}

double equipment_residual(const Equipment *q, const ContactRoller *roller, const double *rate)
{
    double largest = 0;
    for (int k = 0; k < q->n; ++k) {
        const MovingRoller *const item = &q->item[k];
        if (item->mount < 0) continue;
        const double force = item->mass * v3_norm(mount_vector(q, rate, STATE_V, item->mount));
        const double moment = item->turning * v3_norm(mount_vector(q, rate, STATE_W, item->mount));
        const double both = force + moment / roller[item->roller].shape.radius;
        if (both > largest || isnan(both)) largest = both;
    }
    return largest;
}

double equipment_move_share(const Equipment *q, const double *u, double dt, double move, double turn)
{
    double share = 1;
    for (int m = 0; m < q->mounts; ++m) {
        const double v = v3_norm(mount_vector(q, u, STATE_V, m)), w = v3_norm(mount_vector(q, u, STATE_W, m));
        share = fmin(share, fmin(move / (dt * v + 1e-300), turn / (dt * w + 1e-300)));
    }
    return share;
}

void equipment_move(const Equipment *q, double *e, const double *u, double dt)
{
    for (int m = 0; m < q->mounts; ++m) {
        double *const at = e + equipment_at(q, STATE_P, m), *const turned = e + equipment_at(q, STATE_Q, m);
        const int n = q->mounts;
        const Vec3 p = v3_axpy(mount_vector(q, e, STATE_P, m), dt, mount_vector(q, u, STATE_V, m));
        const Quat by = quat_exp(v3_scale(dt, mount_vector(q, u, STATE_W, m)));
        const Quat t = quat_unit(quat_mul(by, (Quat){turned[0], turned[n], turned[2 * n], turned[3 * n]}));
        const double position[3] = {p.x, p.y, p.z}, attitude[4] = {t.w, t.x, t.y, t.z};
        for (int c = 0; c < 3; ++c) at[c * n] = position[c];
        for (int c = 0; c < 4; ++c) turned[c * n] = attitude[c];
    }
}

void equipment_halt(const Equipment *q, double *e)
{
    const int still = STATE_V * q->mounts; /* positions and quaternions do not change */
    memset(e, 0, (size_t)q->spins * sizeof *e);
    memset(e + q->spins + still, 0, (size_t)((STATE_SIZE - STATE_V) * q->mounts) * sizeof *e);
}

int equipment_worst(const Equipment *q, const double *x, const double *w, double *largest)
{
    int worst = -1;
    *largest = -1;
    for (int k = 0; k < q->n; ++k) {
        const MovingRoller *const item = &q->item[k];
        double sum = 0;
        if (item->spin >= 0) sum = x[item->spin] * w[item->spin] * x[item->spin] * w[item->spin];
        for (int c = 0; item->mount >= 0 && c < STATE_SIZE; ++c) {
            const int i = equipment_at(q, c, item->mount);
            sum += x[i] * w[i] * x[i] * w[i];
        }
        if (sum > *largest || isnan(sum)) {
            *largest = sum;
            worst = k;
        }
    }
    return worst;
}

/* (BA11) for a spin, whose angle is not part of the state: the path is the mean speed times the step. past: [2] speed
 * and its rate. */
static MethodLoss spin_loss(double inertia, double speed, double rate, double scale, double past[2])
{
    const double gain = inertia * (speed * speed - past[0] * past[0]) / 2;
    const double work = inertia * (rate + past[1]) * (speed + past[0]) / (4 * scale);
    past[0] = speed;
    past[1] = rate;
    return (MethodLoss){work - gain, inertia * speed * speed / 2};
}

/* The same for a mount, whose inertia is equal about all axes. past: [BODY_PAST] p q v w, their rates' last six. */
static MethodLoss mount_loss(const Equipment *q, const MovingRoller *item, const double *e, const double *rates,
                             double scale, double *past)
{
    double now[BODY_PAST], work = 0, gain = 0, moving = 0;
    for (int c = 0; c < STATE_SIZE; ++c) now[c] = e[equipment_at(q, c, item->mount)];
    for (int c = 0; c < 6; ++c) now[STATE_SIZE + c] = scale * rates[equipment_at(q, STATE_V + c, item->mount)];
    const Quat here = {now[3], now[4], now[5], now[6]}, before = {past[3], past[4], past[5], past[6]};
    const Quat turn = quat_mul(here, quat_conj(before));
    const double way[6] = {now[0] - past[0], now[1] - past[1], now[2] - past[2], 2 * turn.x, 2 * turn.y, 2 * turn.z};
    for (int c = 0; c < 6; ++c) {
        const double m = c < 3 ? item->mass : item->turning, v = now[STATE_V + c], v0 = past[STATE_V + c];
        work += m * (now[STATE_SIZE + c] + past[STATE_SIZE + c]) * way[c] / 2;
        gain += m * (v + v0) * (v - v0) / 2;
        moving += m * v * v / 2;
    }
    memcpy(past, now, sizeof now);
    return (MethodLoss){work - gain, moving};
}

MethodLoss equipment_method_loss(const Equipment *q, const double *e, const double *rates, double scale, double *past)
{
    MethodLoss sum = {0, 0};
    for (int k = 0; k < q->n; ++k) {
        const MovingRoller *const item = &q->item[k];
        MethodLoss of[2] = {{0, 0}, {0, 0}};
        if (item->spin >= 0) {
            const int s = item->spin;
            of[0] = spin_loss(item->inertia, e[s], scale * rates[s], scale, past + 2 * s);
        }
        if (item->mount >= 0)
            of[1] = mount_loss(q, item, e, rates, scale, past + 2 * q->spins + BODY_PAST * item->mount);
        sum.lost += of[0].lost + of[1].lost;
        sum.moving += of[0].moving + of[1].moving;
    }
    return sum;
}

/* Rollers, fixed and moving: what the cable touches at single places. docs/theory.md, "Contact", "Rollers that spin and
 * rollers on mounts". sim/equipment/rollers.h has their motion. */

/* A roller that may be held fast or whose friction may change. */
typedef struct HeldRoller {
    int roller;
    const Seizure *by; /* NULL: its own seizure, by commands */
    Seizure told;
    double mu;        /* friction coefficient with which the cable drags over it at a standstill; NAN: its usual one */
    double torque;    /* N m, of the jammed bearing beside the part that follows the load */
    Profile friction; /* its coefficients relative to the case's (K6) */
} HeldRoller;

typedef struct Rollers {
    int n;
    ContactRoller *roller; /* [n], as given by the case */
    Equipment equipment;   /* the moving ones */
    int n_held;
    HeldRoller *held; /* [n_held], allocated for every roller; one for each that was ever held or changed */
} Rollers;

/* A workspace's own friction laws and bearings, which depend on time where rollers may be held. */
typedef struct HeldWork {
    ContactRoller *roller; /* [n] of the scene, if none moves */
    Equipment equipment;   /* the scene's, but with its own items */
} HeldWork;

/* ---------------------------------------------------------------------------------------------------- building */

/* Surfaces need it too: the chain's position at the last refresh is kept with the rollers' candidates. */
static hawser_status rollers_build(Room *room, Scene *scene, hawser_error *err)
{
    const SceneDef *const def = &scene->def;
    Rollers *const all = room->self = calloc(1, sizeof *all);
    if (!all) return error_memory(err);
    scene->equipment = &all->equipment;
    scene->rollers = all->roller = calloc((size_t)def->n_rollers + 1, sizeof *all->roller);
    all->n = def->n_rollers;
    all->held = calloc((size_t)def->n_rollers + 1, sizeof *all->held);
    if (!all->roller || !all->held) return error_memory(err);
    for (int r = 0; r < def->n_rollers; ++r) {
        const RollerDef *const d = &def->rollers[r];
        all->roller[r] = (ContactRoller){.shape = roller_def_shape(d), .friction = d->friction};
    }
    scene->contact = (ContactModel){.geometry = def->geometry,
                                    .impact = def->impact,
                                    .n_rollers = def->n_rollers,
                                    .roller = all->roller,
                                    .reach = def->contact_reach};
    room->present = def->n_rollers > 0 || def->n_surfaces > 0;
    const hawser_status status = equipment_build(def, all->roller, &all->equipment, err);
    room->states = equipment_size(&all->equipment);
    return status;
}

static void rollers_clear(Room *room)
{
    Rollers *const all = room->self;
    if (!all) return;
    equipment_clear(&all->equipment);
    free(all->roller);
    free(all->held);
}

/* Friction coefficient of cable jackets on a steel shell that does not turn. */
static const double STANDING_MU = 0.4;

/* Record of a roller that is held or changed; a new one is free and has its own friction. */
static HeldRoller *held_of(Rollers *all, int r)
{
    int h = 0;
    while (h < all->n_held && all->held[h].roller != r) ++h;
    if (h < all->n_held) return &all->held[h];
    all->held[all->n_held++] = (HeldRoller){.roller = r, .mu = NAN, .friction = profile_level(1)};
    return &all->held[h];
}

/* A roller that spins keeps its friction; that of one that does not contains its bearing and changes to that of
 * dragging. */
static void held_set(HeldRoller *held, const Scene *scene, const Seizure *by)
{
    const RollerDef *const def = &scene->def.rollers[held->roller];
    const double inertia = def->spin.inertia;
    held->mu = isnan(by->mu) && !(inertia > 0) ? STANDING_MU : by->mu;
    held->torque = inertia * scene->largest_speed / def->radius / by->ramp;
}

static int roller_called(const SceneDef *def, const char *name)
{
    for (int r = 0; r < def->n_rollers; ++r) {
        if (strcmp(def->rollers[r].name, name) == 0) return r;
    }
    return -1;
}

static const char *rollers_seize(Room *room, const Scene *scene, const char *name, const Seizure *by)
{
    const int r = roller_called(&scene->def, name);
    if (r < 0) return NULL;
    HeldRoller *const held = held_of(room->self, r);
    held->by = by;
    held_set(held, scene, by);
    return "roller";
}

static void rollers_start(const Room *room, double *own)
{
    const Rollers *const all = room->self;
    equipment_initial(&all->equipment, own);
}

/* ------------------------------------------------------------------------------------------ rollers that are held */

/* Limit of the jammed bearing over the largest moment by which the cable can turn the roller (JA5). */
static const double HOLD = 20;

/* (JA4) */
static FrictionLaw held_friction(const HeldRoller *held, FrictionLaw law, double share, double factor)
{
    law = friction_scaled(law, factor);
    if (isnan(held->mu)) return law;
    law.mu_s = fmax(law.mu_s + share * (held->mu - law.mu_s), FRICTION_HARDLY_ANY);
    law.mu_d = fmax(law.mu_d + share * (held->mu - law.mu_d), FRICTION_HARDLY_ANY);
    return law;
}

/* (JA5) */
static Bearing held_bearing(const HeldRoller *held, Bearing bearing, double most, double share)
{
    bearing.journal = bearing.friction * bearing.journal + share * HOLD * most;
    bearing.friction = 1;
    bearing.torque += share * held->torque;
    return bearing;
}

/* Writes the friction laws and bearings of time t into the workspace. */
static void rollers_hold(const Room *room, Workspace *ws, double t)
{
    const Rollers *const all = room->self;
    HeldWork *const own = ws->room[room->number];
    const int moving = all->equipment.n > 0;
    for (int h = 0; h < all->n_held; ++h) {
        const HeldRoller *const held = &all->held[h];
        const ContactRoller *const usual = &all->roller[held->roller];
        const Seizure *const by = held->by ? held->by : &held->told;
        const double share = profile_value(&by->share, t), factor = profile_value(&held->friction, t);
        ContactRoller *const now = (moving ? ws->equipment->roller : own->roller) + held->roller;
        now->friction = held_friction(held, usual->friction, share, factor);
        const int k = moving ? ws->equipment->item_of[held->roller] : -1;
        if (k < 0) continue;
        own->equipment.item[k].bearing =
            held_bearing(held, all->equipment.item[k].bearing, now->friction.mu_s * usual->shape.radius, share);
    }
}

static HeldWork *held_work_new(const Rollers *all, int n)
{
    HeldWork *const own = calloc(1, sizeof *own);
    const int moving = all->equipment.n;
    if (!own) return NULL;
    own->roller = calloc((size_t)n + 1, sizeof *own->roller);
    own->equipment = all->equipment;
    own->equipment.item = calloc((size_t)moving + 1, sizeof *own->equipment.item);
    if (own->roller) memcpy(own->roller, all->roller, (size_t)n * sizeof *own->roller);
    if (own->equipment.item && moving > 0)
        memcpy(own->equipment.item, all->equipment.item, (size_t)moving * sizeof *own->equipment.item);
    return own;
}

/* Splits the rollers in two halves by number, which is mostly their order along the route. */
static int rollers_work_alloc(const Room *room, const Scene *scene, Workspace *ws)
{
    const Rollers *const all = room->self;
    const int n = scene->contact.n_rollers, half = n / 2;
    EquipmentWork *const moving = ws->equipment = calloc(1, sizeof *moving);
    ws->on_roller = calloc((size_t)n + 1, sizeof *ws->on_roller);
    HeldWork *const own = held_work_new(all, n);
    ws->room[room->number] = own;
    int ok = moving && ws->on_roller && own && own->roller && own->equipment.item;
    ok = ok && equipment_work_alloc(moving, &own->equipment, n, all->roller);
    if (ok) rollers_hold(room, ws, 0);
    for (int p = 0; ok && p < PARTS; ++p) {
        ContactPart *const part = &ws->contact[p];
        part->model = scene->contact;
        part->model.roller = own->roller + (p == 0 ? 0 : half);
        part->model.n_rollers = p == 0 ? half : n - half;
        part->first = p == 0 ? 0 : half;
        part->sticks = contact_sticks(&part->model);
        if (all->equipment.n > 0) {
            part->model.roller = moving->roller + part->first;
            part->model.motion = moving->motion + part->first;
        }
        ok = contact_pairs_alloc(&part->pairs, scene->chain.n);
    }
    return ok;
}

static void rollers_work_free(const Room *room, Workspace *ws)
{
    HeldWork *const own = ws->room[room->number];
    for (int p = 0; p < PARTS; ++p) contact_pairs_free(&ws->contact[p].pairs);
    if (ws->equipment) equipment_work_free(ws->equipment);
    free(ws->equipment);
    free(ws->on_roller);
    if (!own) return;
    free(own->roller);
    free(own->equipment.item);
}

/* Copies the leans of friction that sticks: rollers keep their half. */
static void rollers_carry(const Room *room, Workspace *from, Workspace *to, int joined)
{
    (void)room;
    for (int p = 0; p < PARTS; ++p) {
        if (to->contact[p].sticks) stick_carry(&from->contact[p].pairs.stick, &to->contact[p].pairs.stick, joined);
        to->contact[p].seconds = from->contact[p].seconds;
    }
}

/* ------------------------------------------------------------------------------------------------------ in a step */

static void rollers_pose(const Room *room, const Moment *m, const double *own)
{
    if (room->states > 0) equipment_pose(m->ws->equipment, own);
    rollers_hold(room, m->ws, m->t);
}

/* The lean of friction that sticks grows by the slip since the last accepted step (GR11). */
static void rollers_begin(const Room *room, const Moment *m)
{
    (void)room;
    for (int p = 0; p < PARTS; ++p) {
        ContactPart *const part = &m->ws->contact[p];
        if (part->sticks) stick_clock(&part->pairs.stick, m->t);
    }
}

/* Contact forces of one half of the rollers; on_roller (NULL: not required) receives those on the rollers. */
static void part_forces(const Moment *m, int part, double friction, Vec3 *on_roller)
{
    Workspace *const ws = m->ws;
    ContactPart *const p = &ws->contact[part];
    RollerLoad *const load = p->model.motion ? ws->equipment->load + p->first : NULL;
    if (p->model.n_rollers == 0) return;
    contact_forces(&p->model, &m->scene->chain, &ws->kin, friction, &p->pairs, &ws->loads[part], on_roller, load);
}

static void rollers_loads(const Room *room, const Moment *m, int part)
{
    (void)room;
    part_forces(m, part, m->friction, m->ws->on_roller + m->ws->contact[part].first);
}

static void rollers_rates(const Room *room, const Moment *m, const double *own, double *rate)
{
    if (room->states > 0) equipment_rates(m->ws->equipment, own, m->friction, rate);
}

/* Receives the couplings of a part's contacts with its rollers. */
typedef struct Taker {
    EquipmentWork *work;
    int first;
} Taker;

static void coupling_take(void *user, const RollerCoupling *coupling)
{
    const Taker *const to = user;
    equipment_blocks_take(to->work, to->first, coupling);
}

/* Also adds loads and couplings of rollers that move. */
static void rollers_blocks(const Room *room, const Moment *m, BlockChain *k, BlockChain *d)
{
    Workspace *const ws = m->ws;
    const Chain *const chain = &m->scene->chain;
    if (room->states > 0) equipment_blocks_begin(ws->equipment);
    for (int half = 0; half < PARTS; ++half) {
        ContactPart *const p = &ws->contact[half];
        if (p->model.n_rollers == 0) continue;
        Taker taker = {ws->equipment, p->first};
        if (p->model.motion) part_forces(m, half, m->friction, NULL);
        contact_blocks(&p->model, chain, &ws->kin, m->friction, &p->pairs, k, d, p->model.motion ? coupling_take : NULL,
                       &taker);
    }
    if (room->states > 0) equipment_bushing_blocks(ws->equipment);
}

/* -------------------------------------------------------------------------------------------------- between steps */

/* Both parts were refreshed at the same positions; the motion of rollers uses up part of the reach (C20). */
static int rollers_stale(const Room *room, const Moment *m)
{
    const ContactPart *const part = &m->ws->contact[PARTS - 1];
    const Rollers *const all = room->self;
    ContactModel model = part->model;
    if (all->equipment.mounts > 0) model.reach -= equipment_moved(m->ws->equipment) / CONTACT_USABLE;
    return contact_moved_too_far(&model, &m->scene->chain, &m->ws->kin, &part->pairs);
}

static hawser_status rollers_refresh(const Room *room, const Moment *m, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int p = 0; p < PARTS && !status; ++p) {
        ContactPart *const part = &m->ws->contact[p];
        status = contact_refresh(&part->model, &m->scene->chain, &m->ws->kin, &part->pairs, err);
    }
    if (room->states > 0) equipment_stand(m->ws->equipment);
    return status;
}

static int rollers_candidates(const Room *room, const Workspace *ws)
{
    (void)room;
    return ws->contact[0].pairs.candidates + ws->contact[1].pairs.candidates;
}

static int rollers_remember(const Room *room, const Workspace *ws)
{
    (void)room;
    return ws->contact[0].sticks | ws->contact[1].sticks;
}

static void rollers_accept(const Room *room, const Moment *m)
{
    (void)room;
    for (int p = 0; p < PARTS; ++p) {
        ContactPart *const part = &m->ws->contact[p];
        if (part->sticks) contact_accept(&part->model, &m->scene->chain, &m->ws->kin, m->t, &part->pairs);
    }
}

static void rollers_checkpoint(Checkpoint *c, const Room *room, const Scene *scene, Workspace *ws)
{
    (void)scene;
    const Rollers *const all = room->self;
    for (int p = 0; p < PARTS; ++p) {
        contact_pairs_checkpoint(c, &ws->contact[p].model, &ws->contact[p].pairs);
        CHECKPOINT(c, ws->contact[p].seconds);
    }
    if (all->equipment.n > 0)
        checkpoint_put(c, "equipment->stood", ws->equipment->stood,
                       2 * (size_t)all->equipment.n * sizeof *ws->equipment->stood);
}

/* The ends of ramps set by commands. */
static double rollers_next_stop(const Room *room, const Scene *scene, double t)
{
    (void)scene;
    const Rollers *const all = room->self;
    double next = INFINITY;
    for (int h = 0; h < all->n_held; ++h) {
        next = profile_corner_before(&all->held[h].told.share, t, next);
        next = profile_corner_before(&all->held[h].friction, t, next);
    }
    return next;
}

/* (K6), (JA2). A law without friction remains without. */
static int rollers_command(Room *room, const Scene *scene, const Command *c, double t, hawser_error *err)
{
    Rollers *const all = room->self;
    const SceneDef *const def = &scene->def;
    const int r = *c->what ? roller_called(def, c->what) : -1;
    if (c->kind == HAWSER_FRICTION && !*c->what) {
        for (int i = 0; i < def->n_rollers; ++i) {
            HeldRoller *const held = held_of(all, i);
            held->friction = command_ramp(&held->friction, t, c->value, c->ramp);
        }
        return def->n_rollers > 0;
    }
    if (r < 0 || (c->kind != HAWSER_FRICTION && c->kind != HAWSER_JAM && c->kind != HAWSER_RELEASE)) return 0;
    HeldRoller *const held = held_of(all, r);
    if (c->kind == HAWSER_FRICTION) {
        held->friction = command_ramp(&held->friction, t, c->value, c->ramp);
        return 1;
    }
    const int taken = seizure_command(&held->told, held->by ? held->by : &held->told, c, t, err);
    const Seizure now = {.ramp = c->ramp, .mu = NAN};
    if (taken > 0 && c->kind == HAWSER_JAM) held_set(held, scene, &now);
    return taken;
}

/* The holder given by the case is set when the scene is built and is not saved. */
static void rollers_controls(Room *room, ControlsVisit *visit)
{
    Rollers *const all = room->self;
    const Profile level = profile_level(1);
    controls_count(visit, &all->n_held, all->n);
    for (int h = 0; h < all->n_held; ++h) {
        HeldRoller *const held = &all->held[h];
        const Seizure *const by = held->by;
        controls_bytes(visit, held, sizeof *held);
        controls_profile_mend(visit, &held->told.share, &level);
        controls_profile_mend(visit, &held->friction, &level);
        if (visit->load && (held->roller < 0 || held->roller >= all->n)) visit->wrong = 1;
        if (visit->wrong) held->roller = 0;
        held->by = by;
    }
}

/* ----------------------------------------------------------------------------------------------------- to look at */

static void rollers_work(const Room *room, const Moment *m, BalanceRates *out)
{
    (void)room;
    for (int p = 0; p < PARTS; ++p) balance_contact(out, LOST_ROLLERS, PUSH_ROLLERS, &m->ws->contact[p].pairs.tally);
    out->loss[LOST_BEARINGS] += m->ws->equipment->lost_bearings;
    out->loss[LOST_MOUNTS] += m->ws->equipment->lost_mounts;
}

static void rollers_stock(const Room *room, const Moment *m, const double *own, BalanceStock *out)
{
    for (int p = 0; p < PARTS; ++p) out->energy[IN_ROLLERS] += m->ws->contact[p].pairs.tally.energy;
    if (room->states > 0) out->energy[IN_EQUIPMENT] = equipment_energy(m->ws->equipment, own);
}

static int rollers_look(const Room *room, const Moment *m)
{
    (void)room;
    int active = 0;
    for (int p = 0; p < PARTS; ++p) {
        ContactPart *const part = &m->ws->contact[p];
        if (part->model.n_rollers == 0) continue;
        part_forces(m, p, 1.0, m->ws->on_roller + part->first);
        active += part->pairs.active;
    }
    return active;
}

/* The geometry check for the plane tests whether rollers cross it at a right angle (sim/solve/planar.c). */
static const char *rollers_not_planar(const Room *room, const Scene *scene)
{
    if (contact_sticks(&scene->contact)) return "friction sticks";
    return room->states > 0 ? "rollers spin or stand on mounts" : NULL;
}

const RoomKind ROLLERS_ROOM = {.name = "rollers",
                               .build = rollers_build,
                               .seize = rollers_seize,
                               .clear = rollers_clear,
                               .start = rollers_start,
                               .work_alloc = rollers_work_alloc,
                               .work_free = rollers_work_free,
                               .carry = rollers_carry,
                               .pose = rollers_pose,
                               .begin = rollers_begin,
                               .loads = rollers_loads,
                               .rates = rollers_rates,
                               .blocks = rollers_blocks,
                               .touches = 1,
                               .stale = rollers_stale,
                               .refresh = rollers_refresh,
                               .candidates = rollers_candidates,
                               .remembers = rollers_remember,
                               .accept = rollers_accept,
                               .checkpoint = rollers_checkpoint,
                               .next_stop = rollers_next_stop,
                               .command = rollers_command,
                               .controls = rollers_controls,
                               .work = rollers_work,
                               .stock = rollers_stock,
                               .look = rollers_look,
                               .not_planar = rollers_not_planar};
