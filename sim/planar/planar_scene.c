#include "sim/planar/planar_scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sim/equipment/ends.h"
#include "sim/equipment/winch.h"
#include "sim/weight.h"

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

/* The components of the law that act in the plane: one of the shears and one of the bendings, or what both give
 * together where they are equal (PL16). */
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

int planar_scene_new(PlanarScene *ps, const Scene *scene, const Plane *plane)
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

void planar_scene_free(PlanarScene *ps)
{
    planar_chain_free(&ps->chain);
    free(ps->roller);
    memset(ps, 0, sizeof *ps);
}

void planar_scene_unwind(PlanarScene *ps, double last_angle)
{
    ps->winch_angle += 2 * M_PI * nearbyint((last_angle - ps->winch_angle) / (2 * M_PI));
}

/* The ghost goes along with the head's end across the pull (WI1a). */
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

void planar_scene_ghosts(const PlanarScene *ps, double t, PlanarKinematics *kin)
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

Push planar_weight(const PlanarScene *ps, const PlanarKinematics *kin, int from, int to, int behind, PlanarLoads *loads)
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

/* The tail's force (F2) and its lever, and what it changes by as the tail's end moves along the route. */
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

double planar_tail_place(const PlanarScene *ps, const double *y, double t, double tail_at, int anew)
{
    const int stride = ps->chain.stride;
    const double angle = y[PLANAR_ANGLE * stride], half = ps->chain.half[0];
    return tail_place(ps->scene, t, point(ps, y[0] - half * cos(angle), y[stride] - half * sin(angle)), tail_at, anew);
}

/* The rope's drag (F3): its size, and the slope of that over the axial speed. */
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

Push planar_drag(const PlanarScene *ps, const PlanarKinematics *kin)
{
    const int i = ps->scene->drag.segment;
    if (i < 0) return (Push){0};
    double slope;
    const double a[2] = {kin->a[0][i], kin->a[1][i]}, size = drag_of(ps, kin, &slope);
    return (Push){size * (kin->v[0][i] * a[0] + kin->v[1][i] * a[1]),
                  plane_vector(&ps->plane, size * a[0], size * a[1])};
}

void planar_ends(const PlanarScene *ps, const PlanarKinematics *kin, double t, double friction, double tail_at,
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

/* Share of the weight, and the lead-in's hold (F1): derivatives, segment by segment from the tail to the start. */
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

/* (RD22) in the plane: what the end's ways by x, z and the angle across the pull are too much. */
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

void planar_applied_blocks(const PlanarScene *ps, const PlanarKinematics *kin, double t, double friction,
                           double tail_at, PlanarBlocks *k, PlanarBlocks *d)
{
    const PlanarTail tail = tail_of(ps, kin, t, tail_at);
    lead_in_blocks(ps, kin, k, d);
    tail_blocks(&tail, k);
    drag_blocks(ps, kin, friction, k, d);
    head_blocks(ps, kin, k, d);
}
