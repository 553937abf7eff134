#include "sim/equipment/winch.h"

#include <assert.h>
#include <math.h>

void winch_init(Winch *w, const WinchDef *def)
{
    w->present = def->present;
    w->mode = def->mode;
    w->speed = def->speed;
    w->tension = def->tension;
    w->speed_limit = def->speed_limit > 0 ? def->speed_limit : INFINITY;
    w->band = def->band;
    w->drum_mass = def->mode == WINCH_TENSION ? def->drum_mass : 0;
    w->trip = def->trip;
    w->trip_force = def->mode == WINCH_SPEED ? def->trip.force : 0;
    w->phase = (WinchPhase){.doing = WINCH_FOLLOWS,
                            .speed = def->speed,
                            .until = INFINITY,
                            .over = INFINITY,
                            .held = def->mode == WINCH_TENSION,
                            .ended = INFINITY};
}

/* ------------------------------------------------------------------------------------ a winch with a speed (WI1) */

double winch_speed(const Winch *w, double t) { return profile_value(&w->phase.speed, t - w->phase.since); }

double winch_travel(const Winch *w, double t)
{
    return w->phase.offset + profile_integral(&w->phase.speed, t - w->phase.since);
}

double winch_largest_speed(const Winch *w)
{
    const Profile *const p = &w->speed;
    double v = fmax(fabs(p->v0), fabs(p->v1));
    if (w->mode == WINCH_TENSION) return isfinite(w->speed_limit) ? w->speed_limit : 0;
    if (p->kind == PROFILE_TABLE) {
        v = 0;
        for (int i = 0; i < p->n; ++i) v = fmax(v, fabs(p->value[i]));
    }
    return v;
}

void winch_ghost(const Winch *w, double t, int n, Kinematics *kin)
{
    const int moves = w->mode == WINCH_SPEED;
    const double speed = moves ? winch_speed(w, t) : 0;
    const Vec3 p = moves ? v3_axpy(w->origin, winch_travel(w, t), w->direction) : w->origin;
    const double position[3] = {p.x, p.y, p.z}, along[3] = {w->direction.x, w->direction.y, w->direction.z};
    for (int c = 0; c < 3; ++c) {
        kin->p[c][n] = position[c];
        kin->v[c][n] = speed * along[c];
        kin->w[c][n] = 0;
        kin->a[c][n] = along[c];
    }
    const double q[4] = {w->attitude.w, w->attitude.x, w->attitude.y, w->attitude.z};
    for (int c = 0; c < 4; ++c) kin->q[c][n] = q[c];
}

/* The profile's next corner, or `next` if that comes first. */
static double corner_before(const Profile *p, double since, double t, double next)
{
    double corner;
    return profile_next_corner(p, t - since, &corner) && since + corner < next ? since + corner : next;
}

double winch_next_stop(const Winch *w, double t)
{
    const WinchPhase *const now = &w->phase;
    double next = now->until > t ? now->until : INFINITY;
    if (!w->present) return INFINITY;
    if (w->mode == WINCH_TENSION) return corner_before(&w->tension, 0, t, next);
    if (now->over + w->trip.hold > t) next = fmin(next, now->over + w->trip.hold);
    return corner_before(&now->speed, now->since, t, next);
}

/* --------------------------------------------------------------------------------- a winch with a tension (WI2) */

double winch_tension(const Winch *w, double t, double speed, double *slope)
{
    double share = 1, fall = 0;
    if (isfinite(w->speed_limit)) {
        share = step_cubic(speed, (1 - w->band) * w->speed_limit, 1, w->speed_limit, 0, &fall);
    }
    const double full = fmax(0, profile_value(&w->tension, t));
    if (slope) *slope = full * fall;
    return full * share;
}

/* The head's end: its arm from the last segment's centre, its place and velocity. */
typedef struct HeadEnd {
    Vec3 arm, spin, off, velocity; /* m; rad/s; m, from the winch's origin; m/s */
} HeadEnd;

static HeadEnd head_end(const Winch *w, const Chain *chain, const Kinematics *kin)
{
    const int i = chain->n - 1;
    HeadEnd e = {.arm = v3_scale(chain->half[i], v3(kin->a[0][i], kin->a[1][i], kin->a[2][i])),
                 .spin = v3(kin->w[0][i], kin->w[1][i], kin->w[2][i])};
    const Vec3 p = v3(kin->p[0][i], kin->p[1][i], kin->p[2][i]), v = v3(kin->v[0][i], kin->v[1][i], kin->v[2][i]);
    e.off = v3_sub(v3_add(p, e.arm), w->origin);
    e.velocity = v3_add(v, v3_cross(e.spin, e.arm));
    return e;
}

WinchMotion winch_motion(const Winch *w, const Chain *chain, const Kinematics *kin, double t)
{
    if (w->mode == WINCH_SPEED) return (WinchMotion){winch_travel(w, t), winch_speed(w, t)};
    const HeadEnd e = head_end(w, chain, kin);
    return (WinchMotion){v3_dot(e.off, w->direction), v3_dot(e.velocity, w->direction)};
}

/* How the force on the head's end changes with its place and its velocity: along the pull and across it, N/m, N s/m. */
typedef struct HeadLaw {
    double along, k_along, c_along, k_across, c_across; /* N; N/m, N s/m */
} HeadLaw;

/* (WI2) or, while the brake is on, (WI5); across the line (WI3). */
static HeadLaw head_law(const Winch *w, const HeadEnd *e, double t)
{
    const double x = v3_dot(e->off, w->direction), v = v3_dot(e->velocity, w->direction);
    HeadLaw law = {.k_across = w->guide[0], .c_across = w->guide[1]};
    if (w->phase.held) {
        law.k_along = w->brake[0];
        law.c_along = w->brake[1];
        law.along = -law.k_along * x - law.c_along * v;
    } else {
        double slope;
        law.along = winch_tension(w, t, v, &slope);
        law.c_along = -slope;
    }
    return law;
}

double winch_pull(const Winch *w, const Chain *chain, const Kinematics *kin, double t)
{
    const HeadEnd e = head_end(w, chain, kin);
    return head_law(w, &e, t).along;
}

/* Stiffness times a change of the end's place, damping times one of its velocity. */
static Vec3 head_change(const Winch *w, double along, double across, Vec3 d)
{
    const double x = v3_dot(d, w->direction);
    return v3_axpy(v3_scale(-along * x, w->direction), -across, v3_axpy(d, -x, w->direction));
}

/* The whole force on the head's end (WI4). */
static Vec3 head_force(const Winch *w, const HeadLaw *law, const HeadEnd *e)
{
    const Vec3 across = v3_add(head_change(w, 0, law->k_across, e->off), head_change(w, 0, law->c_across, e->velocity));
    return v3_axpy(across, law->along, w->direction);
}

void winch_loads(const Winch *w, const Chain *chain, const Kinematics *kin, double t, Loads *loads)
{
    if (!w->present || w->mode != WINCH_TENSION) return;
    const int i = chain->n - 1;
    const HeadEnd e = head_end(w, chain, kin);
    const HeadLaw law = head_law(w, &e, t);
    const Vec3 f = head_force(w, &law, &e), m = v3_cross(e.arm, f);
    const double force[3] = {f.x, f.y, f.z}, moment[3] = {m.x, m.y, m.z};
    for (int c = 0; c < 3; ++c) {
        loads->f[c][i] += force[c];
        loads->m[c][i] += moment[c];
    }
}

Push winch_push(const Winch *w, const Chain *chain, const Kinematics *kin, double t)
{
    if (!w->present || w->mode != WINCH_TENSION) return (Push){0};
    const HeadEnd e = head_end(w, chain, kin);
    const HeadLaw law = head_law(w, &e, t);
    const Vec3 f = head_force(w, &law, &e);
    return (Push){v3_dot(f, e.velocity), f};
}

/* Adds a column of [force; moment] to a 6x6 block. */
static void column_add(double *block, int column, Vec3 f, Vec3 m)
{
    const double value[6] = {f.x, f.y, f.z, m.x, m.y, m.z};
    for (int row = 0; row < 6; ++row) block[6 * column + row] += value[row];
}

void winch_blocks(const Winch *w, const Chain *chain, const Kinematics *kin, double t, BlockChain *k, BlockChain *d)
{
    if (!w->present || w->mode != WINCH_TENSION) return;
    const size_t last = 36 * (size_t)(chain->n - 1);
    const HeadEnd e = head_end(w, chain, kin);
    const HeadLaw law = head_law(w, &e, t);
    const Vec3 f = head_force(w, &law, &e);
    const Vec3 unit[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int c = 0; c < 3; ++c) {
        const Vec3 turned = v3_cross(unit[c], e.arm); /* the arm's change by dphi, the end's velocity by dw */
        const Vec3 by_x = head_change(w, law.k_along, law.k_across, unit[c]);
        const Vec3 by_v = head_change(w, law.c_along, law.c_across, unit[c]);
        const Vec3 by_w = head_change(w, law.c_along, law.c_across, turned);
        const Vec3 by_phi = v3_add(head_change(w, law.k_along, law.k_across, turned),
                                   head_change(w, law.c_along, law.c_across, v3_cross(e.spin, turned)));
        column_add(k->diag + last, c, by_x, v3_cross(e.arm, by_x));
        column_add(k->diag + last, 3 + c, by_phi, v3_add(v3_cross(turned, f), v3_cross(e.arm, by_phi)));
        column_add(d->diag + last, c, by_v, v3_cross(e.arm, by_v));
        column_add(d->diag + last, 3 + c, by_w, v3_cross(e.arm, by_w));
    }
}
