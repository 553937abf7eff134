#include "sim/loads.h"

static Vec3 body_position(const Kinematics *kin, int i) { return v3(kin->p[0][i], kin->p[1][i], kin->p[2][i]); }
static Vec3 body_axis(const Kinematics *kin, int i) { return v3(kin->a[0][i], kin->a[1][i], kin->a[2][i]); }
static Vec3 body_velocity(const Kinematics *kin, int i) { return v3(kin->v[0][i], kin->v[1][i], kin->v[2][i]); }

static void load_add(Loads *loads, int i, Vec3 f, Vec3 m)
{
    const double force[3] = {f.x, f.y, f.z}, moment[3] = {m.x, m.y, m.z};
    for (int c = 0; c < 3; ++c) {
        loads->f[c][i] += force[c];
        loads->m[c][i] += moment[c];
    }
}

/* Adds `value` to rows row..row+2 of a column of a 6x6 block. */
static void column_add(double *block, int column, int row, Vec3 value)
{
    double *const at = block + 6 * column + row;
    at[0] += value.x;
    at[1] += value.y;
    at[2] += value.z;
}

/* Share of the whole weight that a segment feels at p (F1): 0 behind the start, 1 ahead. */
static double weight_share(const Weight *w, Vec3 p, double *slope)
{
    const double x = v3_dot(v3_sub(p, w->origin), w->direction);
    return step_cubic(x, -w->blend / 2, 0, w->blend / 2, 1, slope);
}

/* What the lead-in does to a segment that has left its line, per mass, m/s2. */
static Vec3 lead_in_hold(const Weight *w, const Kinematics *kin, int i)
{
    const Vec3 off = v3_reject(v3_sub(body_position(kin, i), w->origin), w->direction);
    return v3_axpy(v3_scale(-w->hold, off), -w->hold_damping, v3_reject(body_velocity(kin, i), w->direction));
}

Push applied_weight(const Scene *scene, const Kinematics *kin, int from, int to, Loads *loads)
{
    const Weight *const w = &scene->weight;
    const double g[3] = {w->gravity.x, w->gravity.y, w->gravity.z};
    for (int c = 0; c < 3; ++c) {
        for (int i = from; i < to; ++i) {
            loads->f[c][i] = scene->chain.mass[i] * g[c];
            loads->m[c][i] = 0;
        }
    }
    if (scene->winch.drum_mass > 0 && to == scene->chain.n) { /* it moves with the last segment, but hangs elsewhere */
        load_add(loads, to - 1, v3_scale(-scene->winch.drum_mass, w->gravity), v3(0, 0, 0));
    }
    Push by = {0};
    for (int i = from; i < to && w->lead_in; ++i) {
        const double share = weight_share(w, body_position(kin, i), NULL);
        if (share >= 1) break; /* all segments ahead are past the start */
        const Vec3 behind = v3_add(v3_sub(w->behind, w->gravity), lead_in_hold(w, kin, i));
        const Vec3 force = v3_scale((1 - share) * scene->chain.mass[i], behind);
        load_add(loads, i, force, v3(0, 0, 0));
        by.power += v3_dot(force, body_velocity(kin, i));
        by.force = v3_add(by.force, force);
    }
    return by;
}

static void weight_blocks(const Scene *scene, const Kinematics *kin, BlockChain *k, BlockChain *d)
{
    const Weight *const w = &scene->weight;
    if (!w->lead_in) return;
    const Vec3 unit[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int i = 0; i < scene->chain.n; ++i) {
        double slope;
        const double share = weight_share(w, body_position(kin, i), &slope), m = scene->chain.mass[i];
        if (share >= 1) break;
        const Vec3 behind = v3_add(v3_sub(w->behind, w->gravity), lead_in_hold(w, kin, i));
        for (int c = 0; c < 3; ++c) {
            const Vec3 across = v3_reject(unit[c], w->direction);
            const Vec3 entering = v3_scale(-slope * v3_dot(unit[c], w->direction) * m, behind);
            column_add(k->diag + 36 * i, c, 0, v3_axpy(entering, -(1 - share) * m * w->hold, across));
            column_add(d->diag + 36 * i, c, 0, v3_scale(-(1 - share) * m * w->hold_damping, across));
        }
    }
}

/* The tail's dead force (F2): -T along the route's first tangent, at the tail's end face. */
static Vec3 tail_force(const Scene *scene, double t)
{
    return v3_scale(-profile_value(&scene->tail, t), scene->weight.direction);
}

static void tail_loads(const Scene *scene, const Kinematics *kin, double t, Loads *loads)
{
    const Vec3 f = tail_force(scene, t), arm = v3_scale(-scene->chain.half[0], body_axis(kin, 0));
    load_add(loads, 0, f, v3_cross(arm, f));
}

static void tail_blocks(const Scene *scene, const Kinematics *kin, double t, BlockChain *k)
{
    const Vec3 unit[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const Vec3 f = tail_force(scene, t), arm = v3_scale(-scene->chain.half[0], body_axis(kin, 0));
    for (int c = 0; c < 3; ++c) column_add(k->diag, 3 + c, 3, v3_cross(v3_cross(unit[c], arm), f));
}

/* The drag's size over the axial speed, signed against the motion, and its slope (F3). */
static double drag_size(const Drag *drag, double speed, double *slope)
{
    double curve;
    const double over_speed = friction_over_speed(&drag->law, fabs(speed), &curve);
    *slope = -drag->force * (over_speed + curve * speed * speed);
    return -drag->force * over_speed * speed;
}

static void drag_loads(const Scene *scene, const Kinematics *kin, double friction, Loads *loads)
{
    const int i = scene->drag.segment;
    if (i < 0) return;
    const Vec3 a = body_axis(kin, i);
    double slope;
    const double size = drag_size(&scene->drag, v3_dot(body_velocity(kin, i), a), &slope);
    load_add(loads, i, v3_scale(friction * size, a), v3(0, 0, 0));
}

static void drag_blocks(const Scene *scene, const Kinematics *kin, double friction, BlockChain *k, BlockChain *d)
{
    const int i = scene->drag.segment;
    if (i < 0) return;
    const Vec3 unit[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const Vec3 a = body_axis(kin, i), v = body_velocity(kin, i);
    double slope;
    const double size = drag_size(&scene->drag, v3_dot(v, a), &slope);
    for (int c = 0; c < 3; ++c) {
        const Vec3 da = v3_cross(unit[c], a);
        column_add(d->diag + 36 * i, c, 0, v3_scale(friction * slope * v3_dot(unit[c], a), a));
        column_add(k->diag + 36 * i, 3 + c, 0,
                   v3_scale(friction, v3_axpy(v3_scale(size, da), slope * v3_dot(v, da), a)));
    }
}

Push applied_tail(const Scene *scene, const Kinematics *kin, double t)
{
    const Vec3 f = tail_force(scene, t), arm = v3_scale(-scene->chain.half[0], body_axis(kin, 0));
    const Vec3 spin = v3(kin->w[0][0], kin->w[1][0], kin->w[2][0]);
    return (Push){v3_dot(f, v3_add(body_velocity(kin, 0), v3_cross(spin, arm))), f};
}

Push applied_drag(const Scene *scene, const Kinematics *kin)
{
    const int i = scene->drag.segment;
    if (i < 0) return (Push){0};
    double slope;
    const Vec3 a = body_axis(kin, i);
    const double speed = v3_dot(body_velocity(kin, i), a), size = drag_size(&scene->drag, speed, &slope);
    return (Push){size * speed, v3_scale(size, a)};
}

void applied_ends(const Scene *scene, const Kinematics *kin, double t, double friction, Loads *loads)
{
    tail_loads(scene, kin, t, loads);
    drag_loads(scene, kin, friction, loads);
    winch_loads(&scene->winch, &scene->chain, kin, t, loads);
    if (scene->rod.n_loads > 0) rod_loads(&scene->rod, kin, t, loads);
    if (scene->reel.present) reel_loads(&scene->reel, kin, t, friction, loads);
}

void applied_blocks(const Scene *scene, const Kinematics *kin, double t, double friction, BlockChain *k, BlockChain *d)
{
    weight_blocks(scene, kin, k, d);
    tail_blocks(scene, kin, t, k);
    drag_blocks(scene, kin, friction, k, d);
    winch_blocks(&scene->winch, &scene->chain, kin, t, k, d);
    if (scene->rod.n_loads > 0) rod_blocks(&scene->rod, kin, t, k);
    if (scene->reel.present) reel_blocks(&scene->reel, kin, t, friction, k, d);
}
