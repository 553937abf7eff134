#include "sim/equipment/rod.h"

#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "core/state.h"
#include "sim/equipment/rod_shape.h"

/* ------------------------------------------------------------------------------------------ shape at t = 0 */

/* The smallest rotation that takes unit vector a to b, applied after q: the frame is carried without twist. */
static Quat carried(Quat q, Vec3 a, Vec3 b)
{
    const Vec3 axis = v3_cross(a, b);
    const double c = v3_dot(a, b);
    if (c < -0.999999) return q;
    return quat_unit(quat_mul((Quat){1 + c, axis.x, axis.y, axis.z}, q));
}

/* The frame that is carried along, turned about its own axis by the roll of place s (RD2). */
static Quat rolled(const RodDef *def, Quat q, double s)
{
    return quat_mul(q, quat_exp(v3(def->roll + def->roll_rate * s, 0, 0)));
}

static void state_put(double *y, int n, int i, Vec3 p, Quat q)
{
    const double value[7] = {p.x, p.y, p.z, q.w, q.x, q.y, q.z};
    for (int c = 0; c < 7; ++c) y[c * n + i] = value[c];
}

/* Segments are chords of the line, end to end; the ground bodies have the line's own tangent at the rod's ends (RD2).
 */
static void shape_lay(const RodDef *def, const RodLine *line, const Chain *chain, Rod *rod)
{
    const int n = chain->n;
    const RodPlace first = rod_line_at(line, 0);
    Quat q = quat_from_axes(line->forward, line->left, line->up);
    Vec3 axis = first.tangent, joint = first.position;
    double on_line = 0, s = 0;
    q = carried(q, line->forward, axis);
    rod->end[ROD_TAIL] = (RodEnd){&def->end[ROD_TAIL], joint, rolled(def, q, 0)};
    for (int i = 0; i < n; ++i) {
        const double half = chain->half[i], next = rod_line_chord(line, on_line, 2 * half);
        const Vec3 from = rod_line_at(line, on_line).position, to = rod_line_at(line, next).position;
        const Vec3 before = axis;
        axis = v3_unit(v3_sub(to, from));
        q = carried(q, before, axis);
        state_put(rod->start, n, i, v3_axpy(joint, half, axis), rolled(def, q, s + half));
        joint = v3_axpy(joint, 2 * half, axis);
        on_line = next;
        s += 2 * half;
    }
    const Quat last = carried(q, axis, rod_line_at(line, on_line).tangent);
    rod->end[ROD_HEAD] = (RodEnd){&def->end[ROD_HEAD], joint, rolled(def, last, s)};
}

Quat rod_attitude(const Rod *rod, int n, int i)
{
    const double *const q = rod->start + STATE_Q * n + i;
    if (i < 0) return rod->end[ROD_TAIL].attitude;
    if (i >= n) return rod->end[ROD_HEAD].attitude;
    return (Quat){q[0], q[n], q[2 * n], q[3 * n]};
}

int rod_segment_at(const Chain *chain, double at, double *arm)
{
    double from = 0;
    int i = 0;
    while (i + 1 < chain->n && from + 2 * chain->half[i] < at - 1e-9 * chain->half[i]) from += 2 * chain->half[i++];
    *arm = fmin(at - from - chain->half[i], chain->half[i]);
    return i;
}

/* A mass between two centres is shared by the lever rule, which keeps its place; beyond the outer ones it sits on
 * the nearest (RD4). */
static void mass_add(Chain *chain, const RodMassDef *mass)
{
    double arm;
    const int i = rod_segment_at(chain, mass->at, &arm), j = arm > 0 ? i + 1 : i - 1;
    const double span = j < 0 || j >= chain->n ? 0 : chain->half[i] + chain->half[j];
    const double share = span > 0 ? fabs(arm) / span : 0;
    chain->mass[i] += (1 - share) * mass->mass;
    if (span > 0) chain->mass[j] += share * mass->mass;
}

static void load_place(const Chain *chain, const RodLoadDef *def, const Rod *rod, RodLoad *load)
{
    *load = (RodLoad){.def = def, .direction = def->by.direction};
    load->segment = rod_segment_at(chain, def->at, &load->arm);
    if (!def->follower) return;
    load->direction = quat_rotate(quat_conj(rod_attitude(rod, chain->n, load->segment)), def->by.direction);
}

hawser_status rod_build(const RodDef *def, Vec3 start, double heading, double slope, Chain *chain, Rod *rod,
                        hawser_error *err)
{
    const RodLine line = rod_line(def, start, heading, slope);
    *rod = (Rod){.present = 1, .n_loads = def->n_loads};
    rod->start = calloc((size_t)(STATE_SIZE * chain->n), sizeof *rod->start);
    rod->load = calloc((size_t)def->n_loads + 1, sizeof *rod->load);
    if (!rod->start || !rod->load) {
        rod_clear(rod);
        return error_memory(err);
    }
    shape_lay(def, &line, chain, rod);
    for (int i = 0; i < def->n_masses; ++i) mass_add(chain, &def->masses[i]);
    for (int i = 0; i < def->n_loads; ++i) load_place(chain, &def->loads[i], rod, &rod->load[i]);
    return HAWSER_OK;
}

void rod_clear(Rod *rod)
{
    free(rod->start);
    free(rod->load);
    *rod = (Rod){0};
}

/* ---------------------------------------------------------------------------------------- what leads the ends */

/* Sums of an end's motions at time t: displacement, rotation vector, and their rates. */
typedef struct Lead {
    Vec3 move, turn, velocity, turn_rate; /* m, rad, m/s, rad/s */
} Lead;

static Lead lead_at(const RodEndDef *def, double t)
{
    Lead lead = {.move = {0, 0, 0}};
    for (int i = 0; i < def->n_motions; ++i) {
        const RodMotionDef *const m = &def->motions[i];
        const double value = profile_value(&m->by.size, t), rate = profile_rate(&m->by.size, t);
        Vec3 *const sum = m->turns ? &lead.turn : &lead.move, *const rates =
                                                                  m->turns ? &lead.turn_rate : &lead.velocity;
        *sum = v3_axpy(*sum, value, m->by.direction);
        *rates = v3_axpy(*rates, rate, m->by.direction);
    }
    return lead;
}

/* The angular velocity of exp(r) with rotation vector r and rate r' (RD3). */
static Vec3 spin_of(Vec3 r, Vec3 rate)
{
    const double a = v3_norm(r), a2 = a * a;
    const double s = a > 1e-3 ? sin(a) / a : 1 - a2 / 6, c = a > 1e-3 ? (1 - cos(a)) / a2 : 0.5 - a2 / 24;
    const double d = a > 1e-3 ? (1 - s) / a2 : 1.0 / 6 - a2 / 120;
    return v3_axpy(v3_axpy(v3_scale(s, rate), c, v3_cross(r, rate)), d * v3_dot(r, rate), r);
}

/* One ground body into index i of kin. */
static void ghost_set(const RodEnd *end, double t, int i, Kinematics *kin)
{
    const Lead lead = lead_at(end->def, t);
    const Vec3 p = v3_add(end->place, lead.move), w = spin_of(lead.turn, lead.turn_rate);
    const Quat q = quat_unit(quat_mul(quat_exp(lead.turn), end->attitude));
    const Vec3 a = quat_rotate(q, v3(1, 0, 0));
    const double vectors[4][3] = {
        {p.x, p.y, p.z}, {lead.velocity.x, lead.velocity.y, lead.velocity.z}, {w.x, w.y, w.z}, {a.x, a.y, a.z}};
    const double turn[4] = {q.w, q.x, q.y, q.z};
    for (int c = 0; c < 3; ++c) {
        kin->p[c][i] = vectors[0][c];
        kin->v[c][i] = vectors[1][c];
        kin->w[c][i] = vectors[2][c];
        kin->a[c][i] = vectors[3][c];
    }
    for (int c = 0; c < 4; ++c) kin->q[c][i] = turn[c];
}

void rod_ghosts(const Rod *rod, double t, int n, Kinematics *kin)
{
    ghost_set(&rod->end[ROD_TAIL], t, -1, kin);
    ghost_set(&rod->end[ROD_HEAD], t, n, kin);
}

/* --------------------------------------------------------------------------------------------------- loads */

/* Force and moment about the segment's centre at time t (RD5). */
typedef struct Wrench {
    Vec3 arm, force, moment; /* m, N, N m, world */
} Wrench;

static Wrench wrench_of(const RodLoad *load, const Kinematics *kin, double t)
{
    const int i = load->segment;
    const double size = profile_value(&load->def->by.size, t);
    Vec3 along = load->direction;
    if (load->def->follower) {
        along = quat_rotate((Quat){kin->q[0][i], kin->q[1][i], kin->q[2][i], kin->q[3][i]}, along);
    }
    Wrench w = {.arm = v3_scale(load->arm, v3(kin->a[0][i], kin->a[1][i], kin->a[2][i]))};
    if (load->def->moment) {
        w.moment = v3_scale(size, along);
    } else {
        w.force = v3_scale(size, along);
        w.moment = v3_cross(w.arm, w.force);
    }
    return w;
}

Push rod_push(const Rod *rod, const Kinematics *kin, double t)
{
    Push sum = {0};
    for (int l = 0; l < rod->n_loads; ++l) {
        const int i = rod->load[l].segment;
        const Wrench w = wrench_of(&rod->load[l], kin, t);
        const Vec3 v = v3(kin->v[0][i], kin->v[1][i], kin->v[2][i]),
                   spin = v3(kin->w[0][i], kin->w[1][i], kin->w[2][i]);
        sum = push_sum(sum, (Push){v3_dot(w.force, v) + v3_dot(w.moment, spin), w.force});
    }
    return sum;
}

void rod_loads(const Rod *rod, const Kinematics *kin, double t, Loads *loads)
{
    for (int l = 0; l < rod->n_loads; ++l) {
        const int i = rod->load[l].segment;
        const Wrench w = wrench_of(&rod->load[l], kin, t);
        const double force[3] = {w.force.x, w.force.y, w.force.z}, moment[3] = {w.moment.x, w.moment.y, w.moment.z};
        for (int c = 0; c < 3; ++c) {
            loads->f[c][i] += force[c];
            loads->m[c][i] += moment[c];
        }
    }
}

/* Adds a column of [force; moment] to a 6x6 block. */
static void column_add(double *block, int column, Vec3 f, Vec3 m)
{
    const double value[6] = {f.x, f.y, f.z, m.x, m.y, m.z};
    for (int row = 0; row < 6; ++row) block[6 * column + row] += value[row];
}

/* Only rotations matter: a dead force keeps its direction while its arm turns, a follower turns as a whole (RD6). */
void rod_blocks(const Rod *rod, const Kinematics *kin, double t, BlockChain *k)
{
    const Vec3 unit[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int l = 0; l < rod->n_loads; ++l) {
        const RodLoad *const load = &rod->load[l];
        const Wrench w = wrench_of(load, kin, t);
        for (int c = 0; c < 3; ++c) {
            const Vec3 zero = {0, 0, 0}, turned = v3_cross(v3_cross(unit[c], w.arm), w.force);
            const int follows = load->def->follower;
            column_add(k->diag + 36 * (size_t)load->segment, 3 + c, follows ? v3_cross(unit[c], w.force) : zero,
                       follows ? v3_cross(unit[c], w.moment) : turned);
        }
    }
}

double rod_load_size(const Rod *rod, const Chain *chain, double t)
{
    double largest = 0;
    for (int l = 0; l < rod->n_loads; ++l) {
        const RodLoadDef *const def = rod->load[l].def;
        const double size = fabs(profile_value(&def->by.size, t));
        largest = fmax(largest, def->moment ? size / chain->half[rod->load[l].segment] : size);
    }
    return largest;
}

int rod_ends_held(const Rod *rod)
{
    int ends = 0;
    for (int e = 0; rod->present && e < 2; ++e) {
        int any = 0;
        for (int c = 0; c < 6; ++c) any |= rod->end[e].def->held[c];
        ends += any;
    }
    return ends;
}

static double corner_before(const Profile *p, double t, double next)
{
    double corner;
    return profile_next_corner(p, t, &corner) && corner < next ? corner : next;
}

double rod_next_corner(const Rod *rod, double t, double next)
{
    for (int l = 0; l < rod->n_loads; ++l) next = corner_before(&rod->load[l].def->by.size, t, next);
    for (int e = 0; e < 2; ++e) {
        const RodEndDef *const end = rod->end[e].def;
        for (int m = 0; rod->present && m < end->n_motions; ++m) {
            next = corner_before(&end->motions[m].by.size, t, next);
        }
    }
    return next;
}
