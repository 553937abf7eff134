#include "sim/newton/newton_leaves.h"

#include <string.h>

/* What (SP11) and (SP12) need of one roller at the linearisation point. */
typedef struct RollerPoint {
    const MovingRoller *item;
    RollerLoad load;
    Vec3 b, w;           /* axis; angular velocity of the mount */
    double s;            /* of the spin, rad/s */
    double torque, d_om; /* bearing and motor: T + T_m and its derivative by the relative speed */
    Vec3 t;              /* and by the force on the roller */
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
 * feels the moment without it (SP12). */
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

/* What does not come from the contacts' derivatives: the axis turns under moments, bearing and gyroscope (SP12). */
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

/* The bushing's derivatives onto a mount's six rows and columns. */
static void bushing_add(const EquipmentWork *w, int mount, RollerLeaf *leaf)
{
    const double *const k = w->k.diag + 36 * (2 * mount + 1), *const d = w->d.diag + 36 * (2 * mount + 1);
    for (int i = 0; i < 36; ++i) {
        leaf->k_own[leaf->size * (i / 6) + i % 6] += k[i];
        leaf->d_own[leaf->size * (i / 6) + i % 6] += d[i];
    }
}

void roller_blocks(const EquipmentWork *w, int k, const double *e, double friction, RollerLeaf *leaf)
{
    if (w->held && leaf->positions) { /* couples with nothing, so that it stays where it is */
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
    /* K by positions = K + D turns, D by unknowns = D speeds; each times rows from the left where the roller's */
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
