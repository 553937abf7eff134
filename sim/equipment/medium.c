/* Air or water around the chain: drag quadratic in the speed, a current, buoyancy. docs/theory/82-medium.md
 * (MD1)-(MD6). Added mass is not modelled. */
#include <math.h>
#include <stdlib.h>

#include "core/error.h"
#include "core/state.h"
#include "sim/dynamics.h"
#include "sim/equipment/rooms.h"
#include "sim/scene.h"

/* Drag of half a segment over the square of its speed through the fluid, N s2/m2. */
typedef struct Resistance {
    double across, along;
} Resistance;

/* (MD1), of a half segment: l = half[i] */
static Resistance resistance_of(const MediumDef *fluid, const Chain *chain, int i)
{
    const double skin = fluid->density * chain->radius[i] * chain->half[i];
    return (Resistance){.across = skin * fluid->normal, .along = M_PI * skin * fluid->tangential};
}

/* Force on a half segment with axis a that moves through the fluid with u (MD1). */
static Vec3 drag_force(Resistance c, Vec3 a, Vec3 u)
{
    const double along = v3_dot(u, a);
    const Vec3 across = v3_axpy(u, -along, a);
    return v3_axpy(v3_scale(-c.across * v3_norm(across), across), -c.along * fabs(along) * along, a);
}

/* Its change with u and a (MD4). */
static Vec3 drag_change(Resistance c, Vec3 a, Vec3 u, Vec3 da, Vec3 du)
{
    const double along = v3_dot(u, a), d_along = v3_dot(du, a) + v3_dot(u, da);
    const Vec3 across = v3_axpy(u, -along, a);
    const Vec3 d_across = v3_sub(v3_axpy(du, -d_along, a), v3_scale(along, da));
    const double speed = v3_norm(across), d_speed = speed > 0 ? v3_dot(across, d_across) / speed : 0;
    const Vec3 by_across = v3_axpy(v3_scale(speed, d_across), d_speed, across);
    const Vec3 by_along = v3_axpy(v3_scale(2 * fabs(along) * d_along, a), fabs(along) * along, da);
    return v3_axpy(v3_scale(-c.across, by_across), -c.along, by_along);
}

/* A segment's two points (MD2): place, and velocity through the fluid. */
typedef struct Station {
    Vec3 arm, through; /* m from the centre, m/s */
} Station;

static Station station_of(const Moment *m, int i, int side)
{
    const Kinematics *const kin = &m->ws->kin;
    const Vec3 arm = v3_scale((side ? 1 : -1) * m->scene->chain.half[i] / sqrt(3), v3_load(kin->a, i));
    const Vec3 v = v3_add(v3_load(kin->v, i), v3_cross(v3_load(kin->w, i), arm));
    return (Station){arm, v3_sub(v, m->scene->def.medium.velocity)};
}

/* (MD3) */
static Vec3 lift_of(const Scene *scene, int i)
{
    const double r = scene->chain.radius[i], volume = 2 * M_PI * r * r * scene->chain.half[i];
    return v3_scale(-scene->def.medium.buoyancy * scene->def.medium.density * volume, scene->def.gravity);
}

/* -------------------------------------------------------------------------------------------- the equipment kind */

static hawser_status medium_build(Room *room, Scene *scene, hawser_error *err)
{
    (void)err;
    room->present = scene->def.medium.density > 0;
    return HAWSER_OK;
}

static void medium_loads(const Room *room, const Moment *m, int part)
{
    (void)room;
    const Scene *const scene = m->scene;
    const int n = scene->chain.n, from = part == 0 ? 0 : m->ws->middle, to = part == 0 ? m->ws->middle : n;
    for (int i = from; i < to; ++i) {
        const Resistance c = resistance_of(&scene->def.medium, &scene->chain, i);
        Vec3 force = lift_of(scene, i), moment = V3_ZERO;
        for (int side = 0; side < 2; ++side) {
            const Station at = station_of(m, i, side);
            const Vec3 f = drag_force(c, v3_load(m->ws->kin.a, i), at.through);
            force = v3_add(force, f);
            moment = v3_add(moment, v3_cross(at.arm, f));
        }
        loads_add(&m->ws->loads[part], i, force, moment);
    }
}

/* One point's share of a segment's blocks (MD5), (MD6). */
static void station_blocks(const Moment *m, int i, int side, double *k, double *d)
{
    const Resistance c = resistance_of(&m->scene->def.medium, &m->scene->chain, i);
    const Vec3 a = v3_load(m->ws->kin.a, i), w = v3_load(m->ws->kin.w, i);
    const Station at = station_of(m, i, side);
    const Vec3 force = drag_force(c, a, at.through);
    for (int column = 0; column < 3; ++column) {
        const Vec3 e = v3_axis(column), d_arm = v3_cross(e, at.arm);
        const Vec3 shifted = drag_change(c, a, at.through, V3_ZERO, e);
        const Vec3 spun = drag_change(c, a, at.through, V3_ZERO, v3_cross(e, at.arm));
        const Vec3 turned = drag_change(c, a, at.through, v3_cross(e, a), v3_cross(w, d_arm));
        block6_add(d, column, shifted, v3_cross(at.arm, shifted));
        block6_add(d, 3 + column, spun, v3_cross(at.arm, spun));
        block6_add(k, 3 + column, turned, v3_add(v3_cross(d_arm, force), v3_cross(at.arm, turned)));
    }
}

static void medium_blocks(const Room *room, const Moment *m, BlockChain *k, BlockChain *d)
{
    (void)room;
    for (int i = 0; i < m->scene->chain.n; ++i) {
        for (int side = 0; side < 2; ++side) station_blocks(m, i, side, k->diag + 36 * i, d->diag + 36 * i);
    }
}

/* The drag on the motion through the fluid is a loss; a current and buoyancy do work. */
static void medium_work(const Room *room, const Moment *m, BalanceRates *out)
{
    (void)room;
    const Scene *const scene = m->scene;
    Push by = {0};
    for (int i = 0; i < scene->chain.n; ++i) {
        const Resistance c = resistance_of(&scene->def.medium, &scene->chain, i);
        const Vec3 lift = lift_of(scene, i);
        by = push_sum(by, (Push){v3_dot(lift, v3_load(m->ws->kin.v, i)), lift});
        for (int side = 0; side < 2; ++side) {
            const Station at = station_of(m, i, side);
            const Vec3 f = drag_force(c, v3_load(m->ws->kin.a, i), at.through);
            by = push_sum(by, (Push){v3_dot(f, scene->def.medium.velocity), f});
            out->loss[LOST_MEDIUM] -= v3_dot(f, at.through);
        }
    }
    balance_work(out, BY_MEDIUM, by);
}

const RoomKind MEDIUM_ROOM = {.name = "medium",
                              .build = medium_build,
                              .loads = medium_loads,
                              .blocks = medium_blocks,
                              .work = medium_work,
                              .in_space = "the chain moves through a medium"};

/* Initial speeds of the chain. docs/theory/82-medium.md (MD7), (MD8). */

static hawser_status launch_build(Room *room, Scene *scene, hawser_error *err)
{
    (void)err;
    room->present = scene->def.launch.present;
    return HAWSER_OK;
}

/* The table at a place, m from the tail: linear between its rows. */
static LaunchRow row_at(const LaunchDef *def, double at)
{
    const LaunchRow *const row = def->row;
    int k = 0;
    if (def->n_rows == 0) return (LaunchRow){0};
    while (k < def->n_rows && row[k].at <= at) ++k;
    if (k == 0 || k == def->n_rows) return row[k ? k - 1 : 0];
    const double x = (at - row[k - 1].at) / (row[k].at - row[k - 1].at);
    const Vec3 step = v3_sub(row[k].velocity, row[k - 1].velocity);
    return (LaunchRow){at, row[k - 1].along + x * (row[k].along - row[k - 1].along),
                       v3_axpy(row[k - 1].velocity, x, step)};
}

static Vec3 axis_of(const double *y, int n, int i) { return quat_rotate(state_attitude(y, n, i), v3(1, 0, 0)); }

/* Velocity of joint j, `at` m from the tail, beside the rigid body's motion: its tangent is the mean of both
 * neighbours'. */
static Vec3 joint_velocity(const LaunchDef *def, const double *y, int n, int j, double at)
{
    const Vec3 before = axis_of(y, n, j > 0 ? j - 1 : 0), after = axis_of(y, n, j < n ? j : n - 1);
    const Vec3 both = v3_add(before, after);
    const LaunchRow row = row_at(def, at);
    return v3_axpy(row.velocity, def->along + row.along, v3_norm(both) > 0 ? v3_unit(both) : after);
}

static Vec3 centre_of_mass(const Scene *scene, const double *y)
{
    const Chain *const chain = &scene->chain;
    Vec3 sum = V3_ZERO;
    double mass = 0;
    for (int i = 0; i < chain->n; ++i) {
        sum = v3_axpy(sum, chain->mass[i], state_vector(y, chain->n, STATE_P, i));
        mass += chain->mass[i];
    }
    return v3_scale(1 / mass, sum);
}

static void state_put(double *y, int n, int at, int i, Vec3 value)
{
    y[at * n + i] = value.x;
    y[(at + 1) * n + i] = value.y;
    y[(at + 2) * n + i] = value.z;
}

/* Segments follow their ends: the mean velocity of both, and the rotation by their difference (MD8). */
static void launch_set(const Room *room, const Scene *scene, double *y)
{
    (void)room;
    const LaunchDef *const def = &scene->def.launch;
    const Chain *const chain = &scene->chain;
    const Vec3 about = def->about_given ? def->about : centre_of_mass(scene, y);
    const int n = chain->n;
    double at = 0;
    Vec3 rear = joint_velocity(def, y, n, 0, 0);
    for (int i = 0; i < n; ++i) {
        at += 2 * chain->half[i];
        const Vec3 front = joint_velocity(def, y, n, i + 1, at), arm = v3_sub(state_vector(y, n, STATE_P, i), about);
        const Vec3 rigid = v3_add(def->velocity, v3_cross(def->spin, arm));
        const Vec3 turn = v3_scale(0.5 / chain->half[i], v3_cross(axis_of(y, n, i), v3_sub(front, rear)));
        state_put(y, n, STATE_V, i, v3_axpy(rigid, 0.5, v3_add(rear, front)));
        state_put(y, n, STATE_W, i, v3_add(def->spin, turn));
        rear = front;
    }
}

const RoomKind LAUNCH_ROOM = {
    .name = "launch", .build = launch_build, .launch = launch_set, .in_space = "the chain moves at the start"};
