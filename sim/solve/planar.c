#include "sim/solve/planar.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "core/lanes.h"
#include "core/machine.h"
#include "core/team.h"
#include "sim/dynamics.h"
#include "sim/equipment/ends.h"
#include "sim/equipment/winch.h"
#include "sim/solve/relax.h"
#include "sim/solve/scales.h"

static void planar_scene_free(PlanarScene *ps);
static void planar_newton_free(PlanarNewton *nw);

/* Largest distance from the plane that counts as zero: of unit vectors, and in metres. */
static const double CLOSE = 1e-9;

static int refuse(char why[PLANE_WHY_MAX], const char *reason)
{
    snprintf(why, PLANE_WHY_MAX, "%s", reason);
    return 0;
}

/* ------------------------------------------------------------------------------------------------- the plane */

/* A normal by the route's first bend; else by its first straight and gravity; else the first roller's axis; else
 * horizontal, to the right. Everything else is checked against it afterwards. */
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

/* Axes: the second as far up as possible in the plane, the first forward. */
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

/* Orientation of the cross-sections to the plane: that of the first segment, whose frame the others continue without
 * twist. */
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

/* ----------------------------------------------------------------------------------------------- checks */

/* Checks a curve at more places than a cubic off the plane has zeros. */
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

/* Checks for cylinders that cross the plane at a right angle, with the plane between their two faces. */
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

/* Checks whether a principal axis of the cross-section is along the normal. */
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

/* Checks for preloads without components out of the plane and without twist. */
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

/* Features of the scene that the planar equations do not have, wherever they are; 0 if there is none. */
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

/* ------------------------------------------------------------------------------------------- conversion */

static Vec3 entry(const double *y, int n, int at, int i)
{
    return v3(y[at * n + i], y[(at + 1) * n + i], y[(at + 2) * n + i]);
}

/* Angle of axis a that is nearest to `before`. */
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

/* ------------------------------------------------------------------------------------------------- building */

static void pair_set(const Plane *plane, Vec3 v, double out[2])
{
    out[0] = plane_1(plane, v);
    out[1] = plane_2(plane, v);
}

static void segments_set(PlanarScene *ps)
{
    const Chain *const from = &ps->scene->chain;
    const Plane *const p = &ps->plane;
    PlanarChain *const to = &ps->chain;
    for (int i = 0; i < from->n; ++i) {
        const double j = from->inertia[1][i] * p->turn_y * p->turn_y + from->inertia[2][i] * p->turn_z * p->turn_z;
        to->half[i] = from->half[i];
        to->radius[i] = from->radius[i];
        to->mass[i] = from->mass[i];
        to->inertia[i] = j;
        to->inverse_mass[i] = 1 / from->mass[i];
        to->inverse_inertia[i] = 1 / j;
    }
}

/* Sets the components of the law that act in the plane: one of the shears and one of the bendings, or their common
 * value where they are equal (PL16). */
static void joints_set(PlanarScene *ps)
{
    const Chain *const from = &ps->scene->chain;
    const Plane *const p = &ps->plane;
    PlanarChain *const to = &ps->chain;
    const double yy = p->in_y * p->in_y, zz = p->in_z * p->in_z, ty = p->turn_y * p->turn_y, tz = p->turn_z * p->turn_z;
    to->share = from->frame == FRAME_SYMMETRIC ? 0.5 : 1;
    for (int j = 0; j <= from->n; ++j) {
        double *const *const k = from->stiffness, *const *const c = from->damping, *const *const f = from->preload;
        to->stiffness[0][j] = k[0][j];
        to->stiffness[1][j] = yy * k[1][j] + zz * k[2][j];
        to->stiffness[2][j] = ty * k[4][j] + tz * k[5][j];
        to->damping[0][j] = c[0][j];
        to->damping[1][j] = yy * c[1][j] + zz * c[2][j];
        to->damping[2][j] = ty * c[4][j] + tz * c[5][j];
        to->preload[0][j] = f[0][j];
        to->preload[1][j] = p->in_y * f[1][j] + p->in_z * f[2][j];
        to->preload[2][j] = p->turn_y * f[4][j] + p->turn_z * f[5][j];
    }
}

static void weight_set(PlanarScene *ps)
{
    const Weight *const from = &ps->scene->weight;
    PlanarWeight *const to = &ps->weight;
    *to = (PlanarWeight){
        .lead_in = from->lead_in, .blend = from->blend, .hold = from->hold, .hold_damping = from->hold_damping};
    pair_set(&ps->plane, from->gravity, to->gravity);
    pair_set(&ps->plane, v3_sub(from->behind, from->gravity), to->lost);
    pair_set(&ps->plane, v3_sub(from->origin, ps->plane.origin), to->origin);
    pair_set(&ps->plane, from->direction, to->direction);
}

static void winch_set(PlanarScene *ps)
{
    const Winch *const w = ps->scene->winch;
    pair_set(&ps->plane, v3_sub(w->origin, ps->plane.origin), ps->winch_origin);
    pair_set(&ps->plane, w->direction, ps->winch_direction);
    ps->winch_angle = atan2(ps->winch_direction[1], ps->winch_direction[0]);
    Vec3 axis[2];
    ps->winch_slides = w->present && winch_free_axes(w, &ps->scene->def.winch, axis) > 0;
}

static void rollers_set(PlanarScene *ps)
{
    for (int r = 0; r < ps->scene->contact.n_rollers; ++r) {
        const ContactRoller *const from = &ps->scene->contact.roller[r];
        PlanarRoller *const to = &ps->roller[r];
        *to = (PlanarRoller){.radius = from->shape.radius, .friction = from->friction};
        pair_set(&ps->plane, v3_sub(from->shape.centre, ps->plane.origin), to->centre);
    }
}

/* Returns 0 if there is no memory (then nothing is allocated). */
static int planar_scene_new(PlanarScene *ps, const Scene *scene, const Plane *plane)
{
    *ps = (PlanarScene){.scene = scene, .plane = *plane};
    ps->roller = calloc((size_t)scene->contact.n_rollers + 1, sizeof *ps->roller);
    if (!ps->roller || !planar_chain_alloc(&ps->chain, scene->chain.n)) {
        planar_scene_free(ps);
        return 0;
    }
    segments_set(ps);
    joints_set(ps);
    weight_set(ps);
    winch_set(ps);
    rollers_set(ps);
    return 1;
}

static void planar_scene_free(PlanarScene *ps)
{
    planar_chain_free(&ps->chain);
    free(ps->roller);
    memset(ps, 0, sizeof *ps);
}

/* Changes the winch's angle by full turns to the one nearest to the last segment's, rad. */
static void planar_scene_unwind(PlanarScene *ps, double last_angle)
{
    ps->winch_angle += 2 * M_PI * nearbyint((last_angle - ps->winch_angle) / (2 * M_PI));
}

/* The ghost moves with the head's end across the pull (WI1a). */
static void head_slides(const PlanarScene *ps, PlanarKinematics *kin)
{
    const int n = ps->chain.n, i = n - 1;
    const double across[2] = {-ps->winch_direction[1], ps->winch_direction[0]}, half = ps->chain.half[i];
    double away = 0, speed = 0;
    for (int c = 0; c < 2; ++c) {
        const double turned = c == 0 ? -kin->a[1][i] : kin->a[0][i];
        away += across[c] * (kin->p[c][i] + half * kin->a[c][i] - kin->p[c][n]);
        speed += across[c] * (kin->v[c][i] + half * kin->w[i] * turned - kin->v[c][n]);
    }
    for (int c = 0; c < 2; ++c) {
        kin->p[c][n] += away * across[c];
        kin->v[c][n] += speed * across[c];
    }
}

/* Sets the head's ghost to the winch's motion at time t. */
static void planar_scene_ghosts(const PlanarScene *ps, double t, PlanarKinematics *kin)
{
    const Winch *const w = ps->scene->winch;
    if (!w->present) return;
    const int n = ps->chain.n;
    const double travel = winch_travel(w, t), speed = winch_speed(w, t);
    for (int c = 0; c < 2; ++c) {
        kin->p[c][n] = ps->winch_origin[c] + travel * ps->winch_direction[c];
        kin->v[c][n] = speed * ps->winch_direction[c];
        kin->a[c][n] = ps->winch_direction[c];
    }
    kin->angle[n] = ps->winch_angle;
    kin->h[0][n] = cos(ps->winch_angle / 2);
    kin->h[1][n] = sin(ps->winch_angle / 2);
    kin->w[n] = 0;
    if (ps->winch_slides) head_slides(ps, kin);
}

/* --------------------------------------------------------------------------------------------------- loads */

int planar_weight_behind(const PlanarScene *ps, const double *y)
{
    const PlanarWeight *const w = &ps->weight;
    const double *const p[2] = {y, y + ps->chain.stride};
    return w->lead_in ? weight_first_past(ps->chain.n, 2, p, w->origin, w->direction, w->hold > 0, w->blend / 2) : 0;
}

static Push planar_weight(const PlanarScene *ps, const PlanarKinematics *kin, int from, int to, int behind,
                          PlanarLoads *loads)
{
    const PlanarPower by = planar_sim_kernels()->weight(&ps->weight, &ps->chain, kin, from, to, behind, loads);
    return (Push){by.power, plane_vector(&ps->plane, by.force[0], by.force[1])};
}

static double cross(const double a[2], const double b[2]) { return a[0] * b[1] - a[1] * b[0]; }

static double dot(const double a[2], const double b[2]) { return a[0] * b[0] + a[1] * b[1]; }

/* The point in space, m. */
static Vec3 point(const PlanarScene *ps, double x, double z)
{
    return v3_add(ps->plane.origin, plane_vector(&ps->plane, x, z));
}

/* The tail's force (F2) and its lever, and its change as the tail's end moves along the route. */
typedef struct PlanarTail {
    double force[2], arm[2], along[2], turned[2]; /* N; m; unit; N/m */
} PlanarTail;

static PlanarTail tail_of(const PlanarScene *ps, const PlanarKinematics *kin, double t, double tail_at)
{
    PlanarTail out;
    for (int c = 0; c < 2; ++c) out.arm[c] = -ps->chain.half[0] * kin->a[c][0];
    const TailPull pull =
        tail_pull(ps->scene, t, point(ps, kin->p[0][0] + out.arm[0], kin->p[1][0] + out.arm[1]), tail_at);
    pair_set(&ps->plane, pull.force, out.force);
    pair_set(&ps->plane, pull.along, out.along);
    pair_set(&ps->plane, pull.turned, out.turned);
    return out;
}

/* Place of the tail in the state y. */
static double planar_tail_place(const PlanarScene *ps, const double *y, double t, double tail_at, int anew)
{
    const int stride = ps->chain.stride;
    const double angle = y[PLANAR_ANGLE * stride], half = ps->chain.half[0];
    return tail_place(ps->scene, t, point(ps, y[0] - half * cos(angle), y[stride] - half * sin(angle)), tail_at, anew);
}

/* The rope's drag (F3), and its slope over the axial speed. */
static double drag_of(const PlanarScene *ps, const PlanarKinematics *kin, double *slope)
{
    const int i = ps->scene->drag.segment;
    return drag_size(&ps->scene->drag, kin->v[0][i] * kin->a[0][i] + kin->v[1][i] * kin->a[1][i], slope);
}

Push planar_tail(const PlanarScene *ps, const PlanarKinematics *kin, double t, double tail_at)
{
    const PlanarTail tail = tail_of(ps, kin, t, tail_at);
    const double v[2] = {kin->v[0][0] - kin->w[0] * tail.arm[1], kin->v[1][0] + kin->w[0] * tail.arm[0]};
    return (Push){dot(tail.force, v), plane_vector(&ps->plane, tail.force[0], tail.force[1])};
}

static Push planar_drag(const PlanarScene *ps, const PlanarKinematics *kin)
{
    const int i = ps->scene->drag.segment;
    if (i < 0) return (Push){0};
    double slope;
    const double a[2] = {kin->a[0][i], kin->a[1][i]}, size = drag_of(ps, kin, &slope);
    return (Push){size * (kin->v[0][i] * a[0] + kin->v[1][i] * a[1]),
                  plane_vector(&ps->plane, size * a[0], size * a[1])};
}

static void planar_ends(const PlanarScene *ps, const PlanarKinematics *kin, double t, double friction, double tail_at,
                        PlanarLoads *loads)
{
    const int i = ps->scene->drag.segment;
    const PlanarTail tail = tail_of(ps, kin, t, tail_at);
    double slope;
    loads->f[0][0] += tail.force[0];
    loads->f[1][0] += tail.force[1];
    loads->m[0] += cross(tail.arm, tail.force);
    if (i < 0) return;
    const double size = friction * drag_of(ps, kin, &slope);
    loads->f[0][i] += size * kin->a[0][i];
    loads->f[1][i] += size * kin->a[1][i];
}

/* Weight share and the lead-in's hold (F1): derivatives, segment by segment from the tail to the start. */
static void lead_in_blocks(const PlanarScene *ps, const PlanarKinematics *kin, PlanarBlocks *k, PlanarBlocks *d)
{
    const PlanarWeight *const w = &ps->weight;
    if (!w->lead_in) return;
    const double *const along = w->direction, across[2] = {-along[1], along[0]};
    const double *const p[2] = {kin->p[0], kin->p[1]};
    const int behind = weight_first_past(ps->chain.n, 2, p, w->origin, along, w->hold > 0, w->blend / 2);
    for (int i = 0; i < behind; ++i) {
        const double off[2] = {kin->p[0][i] - w->origin[0], kin->p[1][i] - w->origin[1]};
        double slope;
        const double share =
            step_cubic(off[0] * along[0] + off[1] * along[1], -w->blend / 2, 0, w->blend / 2, 1, &slope);
        const double m = ps->chain.mass[i], beside = off[0] * across[0] + off[1] * across[1];
        const double rate = kin->v[0][i] * across[0] + kin->v[1][i] * across[1];
        const double hold = -w->hold * beside - w->hold_damping * rate;
        for (int column = 0; column < 2; ++column) {
            for (int row = 0; row < 2; ++row) {
                const double entering = -slope * along[column] * m * (w->lost[row] + hold * across[row]);
                const double held = (1 - share) * m * across[row] * across[column];
                k->diag[3 * column + row][i] += entering - held * w->hold;
                d->diag[3 * column + row][i] -= held * w->hold_damping;
            }
        }
    }
}

static void drag_blocks(const PlanarScene *ps, const PlanarKinematics *kin, double friction, PlanarBlocks *k,
                        PlanarBlocks *d)
{
    const int i = ps->scene->drag.segment;
    if (i < 0) return;
    double slope;
    const double size = drag_of(ps, kin, &slope);
    const double a[2] = {kin->a[0][i], kin->a[1][i]}, turned[2] = {-a[1], a[0]};
    const double swing = kin->v[0][i] * turned[0] + kin->v[1][i] * turned[1];
    for (int row = 0; row < 2; ++row) {
        for (int column = 0; column < 2; ++column)
            d->diag[3 * column + row][i] += friction * slope * a[column] * a[row];
        k->diag[6 + row][i] += friction * (size * turned[row] + slope * swing * a[row]);
    }
}

/* The tail's end moves, and its arm turns by J arm. */
static void tail_blocks(const PlanarTail *tail, PlanarBlocks *k)
{
    const double swing[2] = {-tail->arm[1], tail->arm[0]};
    const double goes[3] = {tail->along[0], tail->along[1], dot(tail->along, swing)};
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 2; ++row) k->diag[3 * column + row][0] += goes[column] * tail->turned[row];
        k->diag[3 * column + 2][0] += goes[column] * cross(tail->arm, tail->turned);
    }
    k->diag[8][0] += cross(swing, tail->force);
}

/* (RD22) in the plane: removes the part of x, z and the angle for the motion of the end across the pull. */
static void head_blocks(const PlanarScene *ps, const PlanarKinematics *kin, PlanarBlocks *k, PlanarBlocks *d)
{
    const int n = ps->chain.n, i = n - 1;
    const double *const u = ps->winch_direction, across[2] = {-u[1], u[0]};
    const double stiffness = ps->chain.stiffness[0][n], damping = ps->chain.damping[0][n], share = 1 - ps->chain.share;
    const double spin = kin->w[i], frame = share * spin, half = ps->chain.half[i];
    const double arm[2] = {half * kin->a[0][i], half * kin->a[1][i]};
    if (!ps->winch_slides) return;
    double gap[2], rate[2];
    for (int c = 0; c < 2; ++c) gap[c] = kin->p[c][n] - kin->p[c][i] - arm[c];
    for (int c = 0; c < 2; ++c) { /* (PL5) */
        const double turned = c == 0 ? -(spin * arm[1] + frame * gap[1]) : spin * arm[0] + frame * gap[0];
        rate[c] = kin->v[c][n] - kin->v[c][i] - turned;
    }
    for (int column = 0; column < 3; ++column) {
        const double way = column < 2 ? across[column] : cross(arm, across); /* (J r) . e = r x e */
        const double swing = column < 2 ? 0 : -spin * dot(arm, across);
        double spring[2], damped[2], damper[2], free_way[2];
        for (int c = 0; c < 2; ++c) {
            const double turned = c == 0 ? -way * across[1] : way * across[0];
            free_way[c] = way * across[c];
            damped[c] = damping * (swing * across[c] - frame * turned);
            spring[c] = stiffness * free_way[c] + damped[c];
            damper[c] = damping * free_way[c];
        }
        const double couple = cross(gap, damped) + damping * cross(free_way, rate);
        for (int row = 0; row < 2; ++row) {
            k->diag[3 * column + row][i] += spring[row];
            d->diag[3 * column + row][i] += damper[row];
        }
        k->diag[3 * column + 2][i] += cross(arm, spring) + share * couple;
        d->diag[3 * column + 2][i] += cross(arm, damper) + share * cross(gap, damper);
    }
}

static void planar_applied_blocks(const PlanarScene *ps, const PlanarKinematics *kin, double t, double friction,
                                  double tail_at, PlanarBlocks *k, PlanarBlocks *d)
{
    const PlanarTail tail = tail_of(ps, kin, t, tail_at);
    lead_in_blocks(ps, kin, k, d);
    tail_blocks(&tail, k);
    drag_blocks(ps, kin, friction, k, d);
    head_blocks(ps, kin, k, d);
}

static int parts_new(PlanarNewton *nw)
{
    const int n = nw->chain->n;
    const int ok = chain_struct_alloc(&nw->k, n) & chain_struct_alloc(&nw->d, n) & block_chain_alloc(&nw->a, n, 3) &
                   chain_arrays_new(nw->z, 3, n, 0);
    nw->x = calloc((size_t)(3 * nw->chain->stride) + LANES, sizeof *nw->x);
    return ok && nw->x;
}

static hawser_status planar_newton_new(PlanarNewton *nw, const PlanarChain *chain, const LinOptions *options,
                                       hawser_error *err)
{
    *nw = (PlanarNewton){.chain = chain, .middle = halves_middle(chain->n), .team = options->team};
    hawser_error mine = {0};
    if (parts_new(nw)) nw->solver = linsolver_new(&nw->a, options, &mine);
    if (nw->solver) return HAWSER_OK;
    planar_newton_free(nw);
    if (!mine.status) return error_memory(err);
    return error_set(err, mine.status, "%s", mine.message);
}

static void planar_newton_free(PlanarNewton *nw)
{
    chain_struct_free(&nw->k);
    chain_struct_free(&nw->d);
    block_chain_free(&nw->a);
    chain_arrays_free(nw->z, 3);
    free(nw->x);
    nw->solver = linsolver_free(nw->solver);
    memset(nw, 0, sizeof *nw);
}

/* A loop over segments, of which each of two threads does half. */
typedef struct Share {
    PlanarNewton *nw;
    double *b;
} Share;

static int form_from(const PlanarNewton *nw, int rank) { return rank == 0 ? 0 : nw->middle; }

static int form_to(const PlanarNewton *nw, int rank) { return rank == 0 ? nw->middle : nw->chain->n; }

static void form_job(void *arg, int rank)
{
    PlanarNewton *const nw = ((Share *)arg)->nw;
    planar_sim_kernels()->form(nw, form_from(nw, rank), form_to(nw, rank));
}

/* Eliminates and couples rows, which needs the z of their neighbours: elimination is a lane ahead of coupling, and the
 * rows at the middle wait for the other half. */
static void rows_reduce(void *arg, LinSide side, int from, int to)
{
    const Share *const s = arg;
    PlanarNewton *const nw = s->nw;
    const int n = nw->chain->n;
    if (side == LIN_TOP) {
        planar_sim_kernels()->eliminate(nw, s->b, from > 0 ? from + LANES : 0, to + LANES);
    } else if (side == LIN_BOTTOM) {
        planar_sim_kernels()->eliminate(nw, s->b, from - LANES, to < n ? to - LANES : to);
    } else { /* if no side has rows of its own */
        if (from == 0) planar_sim_kernels()->eliminate(nw, s->b, 0, nw->middle);
        if (to == n) planar_sim_kernels()->eliminate(nw, s->b, nw->middle, to);
    }
    planar_sim_kernels()->couple(nw, s->b, from, to);
}

static void rows_expand(void *arg, int from, int to)
{
    const Share *const s = arg;
    planar_sim_kernels()->expand(s->nw, s->b, from, to);
}

static void form_both(TeamJob job, Share *share)
{
    const PlanarNewton *const nw = share->nw;
    halves_run(nw->team, nw->chain->n >= HALVES_LONG, job, share);
}

/* Forms a for gamma (s) from k and d. */
static void planar_newton_form(PlanarNewton *nw, double gamma)
{
    Share share = {.nw = nw};
    nw->gamma = gamma;
    form_both(form_job, &share);
}

/* b [6 stride] becomes the solution of (1 - gamma J) x = b, once solver has factored a; returns as linsolver_solve. */
static int planar_newton_solve(PlanarNewton *nw, double *b)
{
    Share share = {.nw = nw, .b = b};
    return linsolver_stream(nw->solver, &(LinStream){&share, rows_reduce, rows_expand}, nw->x);
}

/* Saves or loads the linearisation point and its factors. */
static void planar_newton_checkpoint(Checkpoint *c, PlanarNewton *nw)
{
    const int n = nw->chain->n;
    chain_struct_checkpoint(c, "nw->k", &nw->k, n);
    chain_struct_checkpoint(c, "nw->d", &nw->d, n);
    CHECKPOINT(c, nw->gamma);
    if (c->reading && !c->status) planar_newton_form(nw, nw->gamma);
    const NewtonMatrix m = {.chain = nw->a};
    linsolver_checkpoint(c, nw->solver, &m);
}

static int segments(const Planar *p) { return p->ps.chain.n; }

/* One evaluation, shared by both threads. */
typedef struct Evaluation {
    Planar *p;
    double t, friction;
    const double *y;
    double *ydot;
    int behind; /* segments behind the route's start */
    int finite[PARTS];
} Evaluation;

static int share_from(const Planar *p, int rank) { return rank == 0 ? 0 : p->middle; }

static int share_to(const Planar *p, int rank, int end) { return rank == 0 ? p->middle : end; }

/* Kinematics and weight of one half; clears the second set of loads. */
static void kinematics_job(void *arg, int rank)
{
    const Evaluation *const e = arg;
    Planar *const p = e->p;
    const int from = share_from(p, rank), to = share_to(p, rank, segments(p));
    planar_kernels()->kinematics(&p->ps.chain, e->y, from, to, &p->kin);
    p->ws->lead_in[rank] = planar_weight(&p->ps, &p->kin, from, to, e->behind, &p->loads[0]);
    double *const second[3] = {p->loads[1].f[0], p->loads[1].f[1], p->loads[1].m};
    for (int c = 0; c < 3; ++c) memset(second[c] + from, 0, (size_t)(to - from) * sizeof(double));
}

/* Joint forces of half of the joints, contacts of half of the rollers; the first half includes the loads at the
 * ends. */
static void loads_job(void *arg, int rank)
{
    const Evaluation *const e = arg;
    Planar *const p = e->p;
    p->ws->joint_power[rank].damping = planar_kernels()->joint_loads(&p->ps.chain, &p->kin, share_from(p, rank),
                                                                     share_to(p, rank, segments(p) + 1), &p->joints);
    if (rank == 0) planar_ends(&p->ps, &p->kin, e->t, e->friction, p->ws->tail_at, &p->loads[0]);
    if (p->model[rank].n_rollers == 0) return;
    ContactPart *const part = &p->ws->contact[rank];
    const double start = clock_now();
    planar_contact_forces(&p->model[rank], &p->ps.chain, &p->kin, e->friction, &part->pairs, &p->loads[rank],
                          p->on_roller + part->first);
    part->seconds += clock_now() - start;
}

static void motion_job(void *arg, int rank)
{
    Evaluation *const e = arg;
    Planar *const p = e->p;
    e->finite[rank] = planar_kernels()->rates(&p->ps.chain, &p->kin, &p->joints, p->loads, share_from(p, rank),
                                              share_to(p, rank, segments(p)), e->ydot);
}

static void halves_both(Planar *p, TeamJob job, Evaluation *e)
{
    halves_run(p->ws->team, segments(p) >= HALVES_LONG, job, e);
}

void planar_place(Planar *p, double t, const double *y)
{
    planar_kernels()->kinematics(&p->ps.chain, y, 0, segments(p), &p->kin);
    planar_scene_ghosts(&p->ps, t, &p->kin);
}

/* NOLINTNEXTLINE(readability-non-const-parameter): the jobs write it */
int planar_evaluate(Planar *p, double t, const double *y, double friction, double *ydot)
{
    Evaluation e = {
        .p = p, .t = t, .friction = friction, .y = y, .ydot = ydot, .behind = planar_weight_behind(&p->ps, y)};
    halves_both(p, kinematics_job, &e);
    planar_scene_ghosts(&p->ps, t, &p->kin); /* after the kinematics, whose last lane reaches beyond the chain */
    for (int c = 0; c < 2 && friction <= 0; ++c)
        p->kin.v[c][segments(p)] = 0; /* during the search for equilibrium:
                                       * (E1) */
    halves_both(p, loads_job, &e);
    halves_both(p, motion_job, &e);
    ++p->ws->rhs_evals;
    return !(e.finite[0] && e.finite[1]);
}

static void joint_blocks_job(void *arg, int rank)
{
    Planar *const p = ((Evaluation *)arg)->p;
    planar_kernels()->joint_blocks(&p->ps.chain, &p->kin, share_from(p, rank), share_to(p, rank, segments(p) + 1),
                                   &p->newton.k, &p->newton.d);
}

static void join_job(void *arg, int rank)
{
    Planar *const p = ((Evaluation *)arg)->p;
    const int from = share_from(p, rank), to = share_to(p, rank, segments(p));
    planar_kernels()->blocks_join(&p->newton.k, from, to);
    planar_kernels()->blocks_join(&p->newton.d, from, to);
}

void planar_blocks(Planar *p, double t, const double *y, double friction)
{
    const PlanarChain *const chain = &p->ps.chain;
    PlanarBlocks *const k = &p->newton.k, *const d = &p->newton.d;
    const int n = chain->n;
    Evaluation e = {.p = p};
    planar_place(p, t, y);
    halves_both(p, joint_blocks_job, &e);
    halves_both(p, join_job, &e);
    planar_blocks_trim(k, n);
    planar_blocks_trim(d, n);
    planar_applied_blocks(&p->ps, &p->kin, t, friction, p->ws->tail_at, k, d);
    for (int half = 0; half < PARTS; ++half) {
        if (p->model[half].n_rollers == 0) continue;
        planar_contact_blocks(&p->model[half], chain, &p->kin, friction, &p->ws->contact[half].pairs, k, d);
    }
}

/* --------------------------------------------------------------------------------------- candidates, looks */

/* Shares of the reach: distance within which candidates are near; motion per step for which they suffice. */
static const double NEAR = 1. / 4, NEAR_STEP = 1. / 128;

static double moved_since(const Planar *p, const PlanarStand *then)
{
    return planar_contact_kernels()->moved(&p->ps.chain, &p->kin, then->p, then->a);
}

static void stand(const Planar *p, PlanarStand *now)
{
    const size_t bytes = (size_t)segments(p) * sizeof(double);
    for (int c = 0; c < 2; ++c) {
        memcpy(now->p[c], p->kin.p[c], bytes);
        memcpy(now->a[c], p->kin.a[c], bytes);
    }
}

/* Chooses the candidates near the present kinematics, among those whose search points have moved by `spent`, m. */
static void near_choose(Planar *p, double spent, int wide)
{
    const double reach = p->motion.scene->contact.reach, left = CONTACT_USABLE * reach - spent;
    for (int half = 0; half < PARTS; ++half) {
        ContactPairs *const pairs = &p->ws->contact[half].pairs;
        if (wide) {
            contact_widen(pairs);
        } else {
            planar_contact_narrow(&p->model[half], &p->ps.chain, &p->kin, NEAR * reach, pairs);
        }
    }
    stand(p, &p->near);
    p->near_usable = wide ? left : fmin(left, CONTACT_USABLE * NEAR * reach);
    p->near_moved = 0;
    p->wide = wide;
}

/* Treats all candidates as near until the next planar_refresh and planar_narrow; or those near (t, y). */
static void planar_widen(Planar *p)
{
    if (p->motion.scene->contact.n_rollers > 0) near_choose(p, moved_since(p, &p->at), 1);
}

static void planar_narrow(Planar *p, double t, const double *y)
{
    if (p->motion.scene->contact.n_rollers == 0) return;
    planar_place(p, t, y);
    near_choose(p, moved_since(p, &p->at), 0);
}

/* (PL19), with the last evaluation for y as below. */
static hawser_status planar_accept(Motion *m, double t, const double *y, hawser_error *err)
{
    Planar *const p = (Planar *)m;
    const Scene *const scene = m->scene;
    const double reach = scene->contact.reach;
    p->ws->tail_at = planar_tail_place(&p->ps, y, t, p->ws->tail_at, 0);
    if (scene->contact.n_rollers == 0) return HAWSER_OK;
    const double moved = moved_since(p, &p->near), step = fabs(moved - p->near_moved);
    const int fast = !(step <= NEAR_STEP * reach);
    p->near_moved = moved;
    if (moved <= p->near_usable && (p->wide || !fast)) return HAWSER_OK;
    const double spent = moved_since(p, &p->at);
    if (spent <= CONTACT_USABLE * reach) {
        near_choose(p, spent, fast);
        return HAWSER_OK;
    }
    const hawser_status status = planar_refresh(p, t, y, 1, err);
    if (!status) near_choose(p, 0, fast);
    return status;
}

hawser_status planar_refresh(Planar *p, double t, const double *y, int always, hawser_error *err)
{
    const Scene *const scene = p->motion.scene;
    if (always) p->ws->tail_at = planar_tail_place(&p->ps, y, t, p->ws->tail_at, 1);
    if (scene->contact.n_rollers == 0) return HAWSER_OK;
    /* (C20), with the last evaluation for y, which is closer to it than the reserve of the reach */
    const double moved = always ? 0 : moved_since(p, &p->at);
    if (!always && moved <= CONTACT_USABLE * scene->contact.reach) return HAWSER_OK;
    planar_place(p, t, y);
    planar_sim_kernels()->lift(&p->ps.plane, &p->ps.chain, &p->kin, &p->ws->kin);
    stand(p, &p->at);
    return dynamics_find_candidates(scene, p->ws, err);
}

typedef struct PlanarRelaxation {
    Planar *p;
    double t;
    double *y;
    double *rate;  /* [6 stride] */
    double *start; /* [2 stride] positions before */
} PlanarRelaxation;

static double residual(void *self, int *where)
{
    PlanarRelaxation *const r = self;
    const PlanarChain *const chain = &r->p->ps.chain;
    const int stride = chain->stride;
    double largest = 0;
    planar_evaluate(r->p, r->t, r->y, 0, r->rate);
    for (int i = 0; i < chain->n; ++i) {
        const double *const a = r->rate + PLANAR_V * stride + i;
        const double force = chain->mass[i] * sqrt(a[0] * a[0] + a[stride] * a[stride]);
        const double both = force + chain->inertia[i] * fabs(a[2 * stride]) / chain->half[i];
        if (both > largest || isnan(both)) {
            largest = both;
            *where = i;
        }
    }
    return largest;
}

static int implicit_step(void *self, double dt)
{
    PlanarRelaxation *const r = self;
    const int stride = r->p->ps.chain.stride;
    planar_blocks(r->p, r->t, r->y, 0);
    planar_newton_form(&r->p->newton, dt);
    const int status = linsolver_factor(r->p->newton.solver, &r->p->newton.a);
    if (status) return status;
    memset(r->rate, 0, (size_t)(PLANAR_V * stride) * sizeof(double));
    for (int k = PLANAR_V * stride; k < PLANAR_SIZE * stride; ++k) r->rate[k] *= dt;
    return planar_newton_solve(&r->p->newton, r->rate);
}

static double move_scale(void *self, double dt)
{
    const PlanarRelaxation *const r = self;
    const int n = r->p->ps.chain.n, stride = r->p->ps.chain.stride;
    const RelaxStride most = relax_stride(r->p->motion.scene);
    double scale = 1;
    for (int i = 0; i < n; ++i) {
        const double *const u = r->rate + PLANAR_V * stride + i;
        const double move = dt * sqrt(u[0] * u[0] + u[stride] * u[stride]), turn = dt * fabs(u[2 * stride]);
        scale = relax_shorten(&most, scale, move, turn, r->p->ps.chain.half[i]);
    }
    return scale;
}

static void move(void *self, double dt)
{
    PlanarRelaxation *const r = self;
    const int count = PLANAR_V * r->p->ps.chain.stride;
    for (int k = 0; k < count; ++k) r->y[k] += dt * r->rate[count + k];
}

/* Candidates are checked by the present positions. */
static hawser_status refresh(void *self, int always, hawser_error *err)
{
    PlanarRelaxation *const r = self;
    if (!always) planar_place(r->p, r->t, r->y);
    return planar_refresh(r->p, r->t, r->y, always, err);
}

static void soften(void *self, double share)
{
    Planar *const p = ((PlanarRelaxation *)self)->p;
    for (int half = 0; half < PARTS; ++half) p->model[half].impact.k = share * p->motion.scene->contact.impact.k;
}

/* Relaxes like relax_to_equilibrium, for y [6 stride]. Errors: MEMORY. */
static hawser_status planar_relax(Motion *m, double t, double *y, hawser_relaxation *out, hawser_error *err)
{
    static const RelaxOps ops = {residual, implicit_step, move_scale, move, refresh, soften};
    Planar *const p = (Planar *)m;
    const Scene *const scene = m->scene;
    const PlanarChain *const chain = &p->ps.chain;
    const size_t stride = (size_t)chain->stride;
    PlanarRelaxation r = {.p = p, .t = t, .y = y};
    r.rate = malloc(PLANAR_SIZE * stride * sizeof(double));
    r.start = malloc(2 * stride * sizeof(double));
    *out = (hawser_relaxation){0};
    hawser_status status = HAWSER_OK;
    if (r.rate && r.start) {
        memcpy(r.start, y, 2 * stride * sizeof(double));
        memset(y + PLANAR_V * stride, 0, (PLANAR_SIZE - PLANAR_V) * stride * sizeof(double));
        out->tolerance_N = relax_tolerance(scene, t, relax_farthest(chain->n, chain->stride, 2, y, NULL));
        planar_widen(p); /* the relaxation makes larger moves than steps do */
        status = relax_run(scene, &p->ws->stop, &ops, &r, p->motion.size, y, out, err);
        if (!status) planar_narrow(p, t, y);
        out->moved_m = relax_farthest(chain->n, chain->stride, 2, y, r.start);
    } else {
        status = error_memory(err);
    }
    free(r.rate);
    free(r.start);
    return status;
}

static Planar *planar_of(Motion *m) { return (Planar *)m; }

static const Planar *planar_in(const Motion *m) { return (const Planar *)m; }

/* Converts the forces on the rollers to space. */
static void on_rollers_lift(Planar *p)
{
    for (int r = 0; r < p->motion.scene->contact.n_rollers; ++r)
        p->ws->on_roller[r] = plane_vector(&p->ps.plane, p->on_roller[r][0], p->on_roller[r][1]);
}

/* Converts the forces of the rollers on the chain, its only contacts, to space. */
static void on_chain_lift(Planar *p)
{
    for (int half = 0; half < PARTS; ++half) {
        double *const *const f = p->loads[half].f;
        for (int i = 0; i < segments(p); ++i)
            v3_store(p->ws->loads[half].f, i, plane_vector(&p->ps.plane, f[0][i], f[1][i]));
    }
}

static int roller_forces(Planar *p, int on_chain)
{
    int active = 0, first = 0;
    const int n = segments(p);
    for (int half = 0; half < PARTS; ++half) {
        for (int c = 0; c < 2 && on_chain; ++c) memset(p->loads[half].f[c], 0, (size_t)n * sizeof(double));
        ContactPairs *const pairs = &p->ws->contact[half].pairs;
        if (p->model[half].n_rollers == 0) continue;
        planar_contact_forces(&p->model[half], &p->ps.chain, &p->kin, 1, pairs, &p->loads[half], p->on_roller + first);
        active += pairs->active;
        first += p->model[half].n_rollers;
    }
    on_rollers_lift(p);
    if (on_chain) on_chain_lift(p);
    return active;
}

/* Pull of the winch for the present kinematics: the last lane of joints has the head's. */
static double head_pull(Planar *p)
{
    const int n = segments(p);
    if (!p->motion.scene->winch->present) return 0;
    planar_kernels()->joint_loads(&p->ps.chain, &p->kin, n / LANES * LANES, n + 1, &p->joints);
    return p->joints.force[0][n] * p->ps.winch_direction[0] + p->joints.force[1][n] * p->ps.winch_direction[1];
}

/* Power and force of the winch at the head's joint: its force along the velocity of the ghost, which does not rotate
 * (BA2). */
static Push winch_push_now(Planar *p, double t, const double *y)
{
    const int n = segments(p);
    if (!p->motion.scene->winch->present) return (Push){0};
    planar_kernels()->kinematics(&p->ps.chain, y, (n - 1) / LANES * LANES, n, &p->kin);
    planar_scene_ghosts(&p->ps, t, &p->kin);
    planar_kernels()->joint_loads(&p->ps.chain, &p->kin, n / LANES * LANES, n + 1, &p->joints);
    const double f[2] = {p->joints.force[0][n], p->joints.force[1][n]};
    return (Push){f[0] * p->kin.v[0][n] + f[1] * p->kin.v[1][n], plane_vector(&p->ps.plane, f[0], f[1])};
}

static void planar_work(Motion *m, double t, const double *y, BalanceRates *out)
{
    Planar *const p = planar_of(m);
    const int n = segments(p);
    memset(out, 0, sizeof *out);
    balance_gather(p->ws, out);
    for (int half = 0; half < PARTS; ++half)
        balance_contact(out, LOST_ROLLERS, PUSH_ROLLERS, &p->ws->contact[half].pairs.tally);
    const Vec3 flat = out->push[PUSH_ROLLERS];
    out->push[PUSH_ROLLERS] = plane_vector(&p->ps.plane, flat.x, flat.y);
    planar_kernels()->kinematics(&p->ps.chain, y, 0, LANES < n ? LANES : n, &p->kin);
    const Push winch = winch_push_now(p, t, y), tail = planar_tail(&p->ps, &p->kin, t, p->ws->tail_at);
    const Push drag = planar_drag(&p->ps, &p->kin);
    out->work[BY_WINCH] = winch.power;
    out->push[BY_WINCH] = winch.force;
    out->work[BY_TAIL] = tail.power;
    out->push[BY_TAIL] = tail.force;
    out->loss[LOST_DRAG] = -drag.power;
    out->push[PUSH_DRAG] = drag.force;
}

static MethodLoss planar_method_loss(const Motion *m, const double *y, const double *rates, double scale, double *past)
{
    return planar_sim_kernels()->method_loss(&planar_in(m)->ps.chain, y, rates, scale, past);
}

static void planar_stock(Motion *m, double t, const double *y, BalanceStock *out)
{
    Planar *const p = planar_of(m);
    planar_place(p, t, y);
    planar_sim_kernels()->lift(&p->ps.plane, &p->ps.chain, &p->kin, &p->ws->kin);
    balance_stock(m->scene, p->ws, NULL, out);
}

static double motion_winch_pull(Motion *m, double t, const double *y)
{
    Planar *const p = planar_of(m);
    const int n = segments(p);
    planar_kernels()->kinematics(&p->ps.chain, y, (n - 1) / LANES * LANES, n, &p->kin);
    planar_scene_ghosts(&p->ps, t, &p->kin);
    return head_pull(p);
}

/* Writes everything that a sample reads from the workspace, and no more. */
static int planar_look(Motion *m, double t, const double *y, int on_chain)
{
    Planar *const p = planar_of(m);
    const int n = segments(p);
    planar_place(p, t, y);
    planar_sim_kernels()->lift(&p->ps.plane, &p->ps.chain, &p->kin, &p->ws->kin);
    planar_kernels()->tension(&p->ps.chain, &p->kin, 0, n + 1, p->ws->law[0]);
    p->ws->head_pull = head_pull(p);
    return roller_forces(p, on_chain);
}

static void planar_glance(Motion *m)
{
    Planar *const p = planar_of(m);
    planar_kernels()->tension(&p->ps.chain, &p->kin, 0, segments(p) + 1, p->ws->law[0]);
    on_rollers_lift(p);
}

/* -------------------------------------------------------------------------------------- operations of the motion */

static int motion_rates(Motion *m, double t, const double *y, double *ydot)
{
    return planar_evaluate(planar_of(m), t, y, 1, ydot);
}

static void motion_linearise(Motion *m, double t, const double *y, const double *ydot)
{
    (void)ydot; /* the inertia about one axis is constant */
    planar_blocks(planar_of(m), t, y, 1);
}

static void motion_form(Motion *m, double gamma) { planar_newton_form(&planar_of(m)->newton, gamma); }

static int motion_factor(Motion *m)
{
    PlanarNewton *const nw = &planar_of(m)->newton;
    linsolver_rough(nw->solver, m->rough);
    return linsolver_factor(nw->solver, &nw->a);
}

static int motion_solve(Motion *m, double *b) { return planar_newton_solve(&planar_of(m)->newton, b); }

/* The same tolerances as in space: that of an angle corresponds to half of it in the quaternion (PL18). */
static void motion_weights(const Motion *m, double *weight)
{
    const Tolerances tol = scales_tolerances(m->scene);
    const double atol[PLANAR_SIZE] = {tol.position, tol.position, tol.rotation, tol.velocity, tol.velocity, tol.omega};
    const int stride = planar_in(m)->ps.chain.stride;
    for (int c = 0; c < PLANAR_SIZE; ++c) {
        for (int i = 0; i < stride; ++i) weight[c * stride + i] = 1 / atol[c];
    }
}

static double window_square(const void *owner, int from, int to, const double *x, const double *w)
{
    return planar_sim_kernels()->window_square(owner, from, to, x, w);
}

static double motion_norm(const Motion *m, const double *x, const double *w)
{
    const PlanarChain *const chain = &planar_in(m)->ps.chain;
    return scales_chain_norm(m->team, chain->n, window_square, chain, x, w);
}

static double motion_speed(const Motion *m, const double *y)
{
    const int stride = planar_in(m)->ps.chain.stride;
    return stride_speed(&m->scene->chain, stride, 2, y + 3 * stride, 1, y + 5 * stride);
}

static hawser_status motion_renew(Motion *m, double t, const double *y, hawser_error *err)
{
    const hawser_status status = planar_refresh(planar_of(m), t, y, 1, err);
    if (!status) planar_narrow(planar_of(m), t, y);
    return status;
}

static int motion_worst(const Motion *m, const double *error, const double *weight)
{
    const PlanarChain *const chain = &planar_in(m)->ps.chain;
    return scales_worst_segment(chain->n, chain->stride, PLANAR_SIZE, error, weight);
}

static Vec3 motion_place(const Motion *m, const double *y, int segment)
{
    const Planar *const p = planar_in(m);
    return v3_add(p->ps.plane.origin, plane_vector(&p->ps.plane, y[segment], y[p->ps.chain.stride + segment]));
}

static void motion_unpack(const Motion *m, const double *y, double *full)
{
    plane_lift(&planar_in(m)->ps.plane, m->scene->chain.n, y, full);
}

static void motion_pack(Motion *m, const double *full, double *y)
{
    Planar *const p = planar_of(m);
    const int n = segments(p);
    plane_press(&p->ps.plane, n, full, y);
    planar_scene_unwind(&p->ps, y[PLANAR_ANGLE * p->ps.chain.stride + n - 1]);
}

static void motion_checkpoint(Checkpoint *c, Motion *m)
{
    Planar *const p = planar_of(m);
    const int n = segments(p);
    CHECKPOINT(c, p->ps.winch_angle);
    chain_struct_checkpoint(c, "p->at", &p->at, n);
    chain_struct_checkpoint(c, "p->near", &p->near, n);
    CHECKPOINT_FROM(c, p, Planar, near_usable);
    planar_newton_checkpoint(c, &p->newton);
}

static void motion_lin_stats(const Motion *m, LinStats *stats) { linsolver_stats(planar_in(m)->newton.solver, stats); }

/* ------------------------------------------------------------------------------------------------------- life */

static int planar_parts_new(Planar *p)
{
    const int n = segments(p);
    int ok = planar_kinematics_alloc(&p->kin, n) & chain_struct_alloc(&p->joints, n);
    ok &= chain_struct_alloc(&p->at, n) & chain_struct_alloc(&p->near, n);
    for (int half = 0, first = 0; half < PARTS; first += p->model[half++].n_rollers) {
        const ContactModel *const model = &p->ws->contact[half].model;
        ok &= chain_struct_alloc(&p->loads[half], n);
        p->model[half] = (PlanarContactModel){.geometry = model->geometry,
                                              .impact = model->impact,
                                              .n_rollers = model->n_rollers,
                                              .roller = p->ps.roller + first};
    }
    p->on_roller = calloc((size_t)p->motion.scene->contact.n_rollers + 1, sizeof *p->on_roller);
    return ok && p->on_roller;
}

hawser_status planar_new(Planar *p, const Scene *scene, const Plane *plane, Workspace *ws, const LinOptions *options,
                         hawser_error *err)
{
    static const MotionOps ops = {.rates = motion_rates,
                                  .linearise = motion_linearise,
                                  .form = motion_form,
                                  .factor = motion_factor,
                                  .solve = motion_solve,
                                  .weights = motion_weights,
                                  .norm = motion_norm,
                                  .speed = motion_speed,
                                  .accept = planar_accept,
                                  .renew = motion_renew,
                                  .worst = motion_worst,
                                  .whose = motion_whose,
                                  .place = motion_place,
                                  .look = planar_look,
                                  .glance = planar_glance,
                                  .winch_pull = motion_winch_pull,
                                  .work = planar_work,
                                  .method_loss = planar_method_loss,
                                  .stock = planar_stock,
                                  .relax = planar_relax,
                                  .pack = motion_pack,
                                  .unpack = motion_unpack,
                                  .lin_stats = motion_lin_stats,
                                  .checkpoint = motion_checkpoint};
    const int n = scene->chain.n;
    *p = (Planar){.motion = {&ops, scene, PLANAR_SIZE * planar_stride(n), ws->team, .pitch = planar_stride(n)},
                  .ws = ws,
                  .middle = halves_middle(n)};
    hawser_status status = HAWSER_OK;
    if (!planar_scene_new(&p->ps, scene, plane) || !planar_parts_new(p)) status = error_memory(err);
    if (!status) status = planar_newton_new(&p->newton, &p->ps.chain, options, err);
    if (status) planar_free(p);
    return status;
}

void planar_free(Planar *p)
{
    if (!p->motion.ops) return;
    planar_newton_free(&p->newton);
    chain_struct_free(&p->kin);
    chain_struct_free(&p->joints);
    chain_struct_free(&p->at);
    chain_struct_free(&p->near);
    for (int half = 0; half < PARTS; ++half) chain_struct_free(&p->loads[half]);
    free(p->on_roller);
    planar_scene_free(&p->ps);
    memset(p, 0, sizeof *p);
}
