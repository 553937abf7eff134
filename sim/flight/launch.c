/* The chain moves when the run begins. docs/model/82-medium.md (MD7), (MD8). */
#include "core/state.h"
#include "sim/equipment/rooms.h"
#include "sim/scene.h"

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

/* What joint j, `at` m from the tail, has beside the rigid body's motion: its tangent is that of both neighbours. */
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

/* Segments follow their ends: the mean of both, and the turn that their difference is (MD8). */
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
