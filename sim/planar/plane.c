#include "sim/planar/plane.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* How far from the plane counts as in it: unit vectors, and metres. */
static const double CLOSE = 1e-9;

static int refuse(char why[PLANE_WHY_MAX], const char *reason)
{
    snprintf(why, PLANE_WHY_MAX, "%s", reason);
    return 0;
}

/* ------------------------------------------------------------------------------------------------- the plane */

/* A normal that fits the route's first bend; else its first straight and gravity; else the first roller's axis; else
 * level, to the right. Whether everything else fits is asked afterwards. */
static Vec3 likely_normal(const Scene *scene)
{
    const Route *const route = &scene->route;
    const Vec3 tangent = route->piece[0].tangent;
    for (int k = 0; k < route->n; ++k) {
        const RoutePiece *const piece = &route->piece[k];
        if (piece->kind == ROUTE_BEND) return v3_unit(v3_cross(piece->tangent, piece->centre));
        if (piece->kind == ROUTE_STRAIGHT) continue;
        const RoutePoint at = route_at(route, piece->s0 + piece->length / 2);
        const Vec3 normal = v3_cross(at.tangent, at.curvature);
        if (v3_norm(normal) > CLOSE) return v3_unit(normal);
    }
    const Vec3 across = v3_cross(tangent, scene->weight.gravity);
    if (v3_norm(across) > CLOSE * v3_norm(scene->weight.gravity)) return v3_unit(across);
    if (scene->contact.n_rollers > 0) return scene->contact.roller[0].shape.axis;
    return v3_scale(-1, route_left(route, 0));
}

/* Axes: the second as far up as the plane allows, the first forward. */
static void plane_axes(const Scene *scene, Plane *plane)
{
    const Vec3 tangent = scene->route.piece[0].tangent, up = v3(0, 0, 1);
    Vec3 normal = likely_normal(scene);
    Vec3 second = v3_reject(up, normal);
    if (v3_norm(second) < CLOSE) second = v3_cross(normal, tangent);
    second = v3_unit(second);
    if (v3_dot(v3_cross(second, normal), tangent) < 0) normal = v3_scale(-1, normal);
    *plane = (Plane){
        .origin = scene->route.piece[0].start, .e1 = v3_unit(v3_cross(second, normal)), .e2 = second, .normal = normal};
}

/* How a segment lies across the plane: from the first segment, whose frame the others carry on without twist. */
static int plane_attitude(const Scene *scene, Plane *plane)
{
    const int n = scene->chain.n;
    double *const y = malloc((size_t)scene_state_size(scene) * sizeof *y);
    if (!y) return 0;
    scene_initial_state(scene, y);
    const Quat q = {y[STATE_Q * n], y[(STATE_Q + 1) * n], y[(STATE_Q + 2) * n], y[(STATE_Q + 3) * n]};
    free(y);
    const Vec3 a = quat_rotate(q, v3(1, 0, 0));
    const double angle = atan2(plane_2(plane, a), plane_1(plane, a));
    plane->flat = quat_unit(quat_mul(quat_exp(v3_scale(-angle, plane->normal)), q));
    const Vec3 ey = quat_rotate(plane->flat, v3(0, 1, 0)), ez = quat_rotate(plane->flat, v3(0, 0, 1));
    plane->in_y = v3_dot(ey, plane->e2);
    plane->in_z = v3_dot(ez, plane->e2);
    plane->turn_y = v3_dot(ey, plane->normal);
    plane->turn_z = v3_dot(ez, plane->normal);
    return 1;
}

/* ----------------------------------------------------------------------------------------------- what must fit */

/* A curve by looks along it, more than a cubic out of the plane has zeros. */
static int curve_fits(const Route *route, int k, const Plane *plane)
{
    enum { LOOKS = 8 };
    for (int i = 0; i <= LOOKS && route->piece[k].kind >= ROUTE_CURVE; ++i) {
        const RoutePoint at = route_on_piece(route, k, route->piece[k].s0 + route->piece[k].length * i / LOOKS);
        const Vec3 off = v3_sub(at.position, plane->origin);
        if (fabs(v3_dot(at.tangent, plane->normal)) > CLOSE) return 0;
        if (fabs(v3_dot(off, plane->normal)) > CLOSE * (1 + v3_norm(off))) return 0;
    }
    return 1;
}

static int route_fits(const Scene *scene, const Plane *plane)
{
    for (int k = 0; k < scene->route.n; ++k) {
        const RoutePiece *const piece = &scene->route.piece[k];
        const Vec3 off = v3_sub(piece->start, plane->origin);
        if (fabs(v3_dot(piece->tangent, plane->normal)) > CLOSE) return 0;
        if (fabs(v3_dot(off, plane->normal)) > CLOSE * (1 + v3_norm(off))) return 0;
        if (piece->kind == ROUTE_BEND && fabs(v3_dot(piece->centre, plane->normal)) > CLOSE) return 0;
        if (!curve_fits(&scene->route, k, plane)) return 0;
    }
    return 1;
}

static int gravity_fits(const Scene *scene, const Plane *plane)
{
    return fabs(v3_dot(scene->weight.gravity, plane->normal)) <= CLOSE * v3_norm(scene->weight.gravity);
}

/* Cylinders that cross the plane at a right angle, the plane between their two faces. */
static int rollers_fit(const Scene *scene, const Plane *plane)
{
    for (int r = 0; r < scene->contact.n_rollers; ++r) {
        const Shape *const shape = &scene->contact.roller[r].shape;
        const double off = v3_dot(v3_sub(shape->centre, plane->origin), plane->normal);
        if (shape->kind != SHAPE_CYLINDER) return 0;
        if (v3_norm(v3_cross(shape->axis, plane->normal)) > CLOSE) return 0;
        if (!(fabs(off) < shape->half_width)) return 0;
    }
    return 1;
}

/* A principal axis of the cross-section lies along the normal. */
static int axes_fit(const Plane *plane) { return fabs(plane->turn_y) < CLOSE || fabs(plane->turn_z) < CLOSE; }

static int joints_round(const Chain *chain)
{
    for (int j = 0; j <= chain->n; ++j) {
        for (int c = 1; c < 6; c += 3) { /* shears, then bendings */
            if (fabs(chain->stiffness[c][j] - chain->stiffness[c + 1][j]) > 0) return 0;
            if (fabs(chain->damping[c][j] - chain->damping[c + 1][j]) > 0) return 0;
        }
    }
    return 1;
}

/* Preloads that push or bend out of the plane, or twist. */
static int preloads_fit(const Scene *scene, const Plane *plane)
{
    double *const *const load = scene->chain.preload;
    for (int j = 0; j <= scene->chain.n; ++j) {
        const double push = plane->turn_y * load[1][j] + plane->turn_z * load[2][j];
        const double bend = plane->in_y * load[4][j] + plane->in_z * load[5][j];
        const double largest = fabs(load[1][j]) + fabs(load[2][j]) + fabs(load[4][j]) + fabs(load[5][j]);
        if (fabs(load[3][j]) > 0 || fabs(push) + fabs(bend) > CLOSE * largest) return 0;
    }
    return 1;
}

/* What the planar equations do not have, wherever it lies; 0 if the scene asks for nothing of that kind. */
static int unknown_feature(const Scene *scene, char why[PLANE_WHY_MAX])
{
    for (int r = 0; r < scene->n_rooms; ++r) {
        const Room *const room = &scene->room[r];
        if (!room->present) continue;
        const char *const reason = room->kind->not_planar ? room->kind->not_planar(room, scene) : room->kind->in_space;
        if (reason) return !refuse(why, reason);
    }
    if (scene->def.output.n_probes > 0) return !refuse(why, "probes look at the chain in space");
    if (scene->chain.sliders.count > 0) return !refuse(why, "the cable bends with hysteresis");
    if (scene->def.solver.linear.kind == LIN_KLU_FULL)
        return !refuse(why, "solver.linear_solver klu-full takes the unreduced system in space");
    return 0;
}

int plane_find(const Scene *scene, Plane *plane, char why[PLANE_WHY_MAX])
{
    if (unknown_feature(scene, why)) return 0;
    plane_axes(scene, plane);
    if (!route_fits(scene, plane)) return refuse(why, "the route does not lie in one plane");
    if (!gravity_fits(scene, plane)) return refuse(why, "gravity is not in the route's plane");
    if (!rollers_fit(scene, plane))
        return refuse(why, "a roller's axis is not normal to the route's plane, or the roller is beside it");
    if (!plane_attitude(scene, plane)) return -1;
    if (!axes_fit(plane) && !joints_round(&scene->chain))
        return refuse(why, "the cable bends differently about its two axes, and neither is normal to the plane");
    if (!preloads_fit(scene, plane)) return refuse(why, "a preload twists the cable or pushes it out of the plane");
    snprintf(why, PLANE_WHY_MAX, "route, gravity and rollers lie in one plane");
    return 1;
}

/* ------------------------------------------------------------------------------------------- there and back */

static Vec3 entry(const double *y, int n, int at, int i)
{
    return v3(y[at * n + i], y[(at + 1) * n + i], y[(at + 2) * n + i]);
}

/* The angle next to `before` that belongs to axis a. */
static double angle_near(const Plane *plane, Vec3 a, double before)
{
    const double angle = atan2(plane_2(plane, a), plane_1(plane, a));
    return angle + 2 * M_PI * nearbyint((before - angle) / (2 * M_PI));
}

double plane_press(const Plane *plane, int n, const double *y, double *out)
{
    const int stride = planar_stride(n);
    double lost = 0, before = 0;
    memset(out, 0, (size_t)(PLANAR_SIZE * stride) * sizeof *out);
    for (int i = 0; i < n; ++i) {
        const Vec3 p = v3_sub(entry(y, n, STATE_P, i), plane->origin), v = entry(y, n, STATE_V, i);
        const Vec3 w = entry(y, n, STATE_W, i), u = entry(y, n, STATE_Q + 1, i);
        const Vec3 a = quat_rotate(quat_unit((Quat){y[STATE_Q * n + i], u.x, u.y, u.z}), v3(1, 0, 0));
        before = angle_near(plane, a, before);
        const double value[PLANAR_SIZE] = {plane_1(plane, p), plane_2(plane, p), before,
                                           plane_1(plane, v), plane_2(plane, v), v3_dot(w, plane->normal)};
        for (int c = 0; c < PLANAR_SIZE; ++c) out[c * stride + i] = value[c];
        const double off[4] = {v3_dot(p, plane->normal), v3_dot(v, plane->normal), v3_dot(a, plane->normal),
                               v3_norm(v3_reject(w, plane->normal))};
        for (int c = 0; c < 4; ++c) lost = fmax(lost, fabs(off[c]));
    }
    return lost;
}

void plane_lift(const Plane *plane, int n, const double *planar, double *y)
{
    const int stride = planar_stride(n);
    for (int i = 0; i < n; ++i) {
        const double *const at = planar + i;
        const Vec3 p = v3_add(plane->origin, plane_vector(plane, at[0], at[stride]));
        const Vec3 v = plane_vector(plane, at[PLANAR_V * stride], at[(PLANAR_V + 1) * stride]);
        const Vec3 w = v3_scale(at[PLANAR_W * stride], plane->normal);
        const Quat q = quat_mul(quat_exp(v3_scale(at[PLANAR_ANGLE * stride], plane->normal)), plane->flat);
        const double value[STATE_SIZE] = {p.x, p.y, p.z, q.w, q.x, q.y, q.z, v.x, v.y, v.z, w.x, w.y, w.z};
        for (int c = 0; c < STATE_SIZE; ++c) y[c * n + i] = value[c];
    }
}
