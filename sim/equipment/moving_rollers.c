#include "sim/equipment/moving_rollers.h"

#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
/* Bodies of the mounts' chain: the ground under mount m, and the mount. */
static int ground_of(int m) { return 2 * m; }
static int body_of(int m) { return 2 * m + 1; }

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

/* The mount's frame: x along the roller's axis, z as far up as that allows (along x where the axis is upright). */
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

hawser_status equipment_build(const SceneDef *def, const ContactRoller *roller, Equipment *q, hawser_error *err)
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

void equipment_clear(Equipment *q)
{
    free(q->item);
    if (q->mounts) {
        chain_free(&q->bushings);
        kinematics_free(&q->ground);
    }
    memset(q, 0, sizeof *q);
}

int equipment_size(const Equipment *q) { return q->spins + STATE_SIZE * q->mounts; }

void equipment_initial(const Equipment *q, double *e)
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
    const int still = STATE_V * q->mounts; /* positions and quaternions stay */
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

/* (BA11) of a spin, whose angle is no part of the state: the way is the mean speed times the step. past: [2] speed and
 * its rate. */
static MethodLoss spin_loss(double inertia, double speed, double rate, double scale, double past[2])
{
    const double gain = inertia * (speed * speed - past[0] * past[0]) / 2;
    const double work = inertia * (rate + past[1]) * (speed + past[0]) / (4 * scale);
    past[0] = speed;
    past[1] = rate;
    return (MethodLoss){work - gain, inertia * speed * speed / 2};
}

/* The same of a mount, round in all directions. past: [BODY_PAST] p q v w, their rates' last six. */
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
