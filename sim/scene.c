#include "sim/scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Attitude without twist on the route at s (m). */
static Quat first_attitude(const Scene *scene, Vec3 axis, double s)
{
    const Vec3 left = v3_unit(v3_reject(route_left(&scene->route, s), axis));
    return quat_from_axes(axis, left, v3_cross(axis, left));
}

Vec3 scene_line_at(const Scene *scene, double s) { return setup_line_at(&scene->def, &scene->route, s); }

/* Place of joint j when the chain has moved on by `travel`. */
static Vec3 joint_place(const Scene *scene, int j, double travel)
{
    return j < scene->joints_off ? scene->joint_start[j] : scene_line_at(scene, scene->joint_s[j] + travel);
}

void scene_lay(const Scene *scene, double travel, int first, int n, double *y)
{
    memset(y, 0, (size_t)(STATE_SIZE * n) * sizeof *y);
    Quat q = {1, 0, 0, 0};
    Vec3 before = v3(0, 0, 0);
    for (int i = 0; i < n; ++i) {
        const Vec3 a = joint_place(scene, first + i, travel), b = joint_place(scene, first + i + 1, travel);
        const Vec3 axis = v3_unit(v3_sub(b, a)), centre = v3_scale(0.5, v3_add(a, b));
        q = i == 0 ? first_attitude(scene, axis, scene->joint_s[first] + travel) : quat_carry(q, before, axis);
        before = axis;
        const double value[7] = {centre.x, centre.y, centre.z, q.w, q.x, q.y, q.z};
        for (int c = 0; c < 7; ++c) y[c * n + i] = value[c];
    }
}

void scene_initial_chain(const Scene *scene, double *y)
{
    const int n = scene->total;
    if (scene->start) {
        memcpy(y, scene->start, (size_t)(STATE_SIZE * n) * sizeof *y);
    } else {
        scene_lay(scene, 0, 0, n, y);
    }
}

double scene_way(const Scene *scene)
{
    const int n_patches = scene->surfaces.model.n_patches, n_rollers = scene->contact.n_rollers;
    double cable = INFINITY, way = INFINITY;
    for (int p = 0; p < scene->def.n_pieces; ++p)
        cable = fmin(cable, scene->def.cables[scene->def.pieces[p].cable].diameter / 2);
    for (int r = 0; r < n_rollers; ++r) {
        const Shape *const shape = &scene->contact.roller[r].shape;
        way = fmin(way, fmin(shape->radius, shape->half_width) + cable);
    }
    for (int p = 0; p < n_patches; ++p) way = fmin(way, (scene->surfaces.patch[p].depth + cable) / 2);
    return fmin(scene->beside_way, scene->self.present ? fmin(way, cable) : way);
}

int scene_state_size(const Scene *scene)
{
    int size = STATE_SIZE * scene->chain.n;
    for (int r = 0; r < scene->n_rooms; ++r) size += scene->room[r].states;
    return size;
}

void scene_initial_state(const Scene *scene, double *y)
{
    scene_initial_chain(scene, y);
    double *own = y + STATE_SIZE * scene->total;
    for (int r = 0; r < scene->n_rooms; own += scene->room[r++].states) {
        const Room *const room = &scene->room[r];
        if (room->states > 0) room->kind->start(room, own);
    }
    scene_launch(scene, y);
}

void scene_launch(const Scene *scene, double *y)
{
    for (int r = 0; r < scene->n_rooms; ++r) {
        const Room *const room = &scene->room[r];
        if (room->present && room->kind->launch) room->kind->launch(room, scene, y);
    }
}

void scene_ghosts(const Scene *scene, double t, Kinematics *kin)
{
    for (int r = 0; r < scene->n_rooms; ++r) {
        const Room *const room = &scene->room[r];
        if (room->present && room->kind->ghosts) room->kind->ghosts(room, scene, t, kin);
    }
}

/* ------------------------------------------------------------------------------------------------- rooms */

Room *room_of(Scene *scene, const RoomKind *kind)
{
    for (int r = 0; r < scene->n_rooms; ++r) {
        if (scene->room[r].kind == kind) return &scene->room[r];
    }
    return NULL;
}

double scene_next_stop(const Scene *scene, double t, double stop)
{
    const double behind = t + 1e-9; /* a stop at t itself does not count */
    for (int r = 0; r < scene->n_rooms; ++r) {
        const Room *const room = &scene->room[r];
        if (room->present && room->kind->next_stop) stop = fmin(stop, room->kind->next_stop(room, scene, behind));
    }
    return stop;
}
