#include "sim/equipment/rod.h"

#include <stdlib.h>
#include <string.h>

#include "core/bushing.h"
#include "core/error.h"
#include "core/state.h"
#include "def/rod_def.h"
#include "sim/dynamics.h"
#include "sim/equipment/rooms.h"
#include "sim/joints.h"

/* Largest rotation of a led end in a step, rad (RD19). */
static const double LED_AT_ONCE = 1;

/* ------------------------------------------------------------------------------------------ shape at t = 0 */

/* The parallel-transported frame, rotated about its own axis by the roll at place s (RD2). */
static Quat rolled(const RodDef *def, Quat q, double s)
{
    return quat_mul(q, quat_exp(v3(def->roll + def->roll_rate * s, 0, 0)));
}

static void state_put(double *y, int n, int i, Vec3 p, Quat q)
{
    const double value[7] = {p.x, p.y, p.z, q.w, q.x, q.y, q.z};
    for (int c = 0; c < 7; ++c) y[c * n + i] = value[c];
}

/* Segments are chords of the line, end to end; the ground bodies take the line's own tangent at the rod's ends
 * (RD2). */
static void shape_lay(const RodDef *def, const RodLine *line, const Chain *chain, Rod *rod)
{
    const int n = chain->n;
    const RodPlace first = rod_line_at(line, 0);
    Quat q = quat_from_axes(line->forward, line->left, line->up);
    Vec3 axis = first.tangent, joint = first.position;
    double on_line = 0, s = 0;
    q = quat_carry(q, line->forward, axis);
    rod->end[ROD_TAIL] = (RodEnd){&def->end[ROD_TAIL], joint, rolled(def, q, 0)};
    for (int i = 0; i < n; ++i) {
        const double half = chain->half[i], next = rod_line_chord(line, on_line, 2 * half);
        const Vec3 from = rod_line_at(line, on_line).position, to = rod_line_at(line, next).position;
        const Vec3 before = axis;
        axis = v3_unit(v3_sub(to, from));
        q = quat_carry(q, before, axis);
        state_put(rod->start, n, i, v3_axpy(joint, half, axis), rolled(def, q, s + half));
        joint = v3_axpy(joint, 2 * half, axis);
        on_line = next;
        s += 2 * half;
    }
    const Quat last = quat_carry(q, axis, rod_line_at(line, on_line).tangent);
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

/* A mass between two centres is distributed by the lever rule, which keeps its centre of gravity; a mass beyond the
 * outer centres is placed on the nearest one, whose segment is made short for it (RD4). */
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

static hawser_status rod_build(Room *room, Scene *scene, hawser_error *err)
{
    const RodDef *const def = &scene->def.rod;
    Chain *const chain = &scene->chain;
    Rod *const rod = room->self = scene->rod = calloc(1, sizeof *rod);
    if (!rod) return error_memory(err);
    if (!def->present) return HAWSER_OK;
    const RodLine line = rod_line(def, scene->def.route_start, scene->def.route_heading, scene->def.route_slope);
    room->present = rod->present = 1;
    rod->n_loads = def->n_loads;
    rod->start = calloc((size_t)(STATE_SIZE * chain->n), sizeof *rod->start);
    rod->load = calloc((size_t)def->n_loads + 1, sizeof *rod->load);
    if (!rod->start || !rod->load) return error_memory(err);
    shape_lay(def, &line, chain, rod);
    for (int i = 0; i < def->n_masses; ++i) mass_add(chain, &def->masses[i]);
    for (int i = 0; i < def->n_loads; ++i) load_place(chain, &def->loads[i], rod, &rod->load[i]);
    scene->start = rod->start;
    return HAWSER_OK;
}

static void rod_clear(Room *room)
{
    Rod *const rod = room->self;
    if (!rod) return;
    free(rod->start);
    free(rod->load);
}

/* Checks whether an end is held in some directions, free in the others, and free to turn: it then slides along axes of
 * the ground (RD21). */
static int slides(const RodEndDef *end)
{
    const int places = end->held[AXIAL] + end->held[SHEAR_Y] + end->held[SHEAR_Z];
    return places > 0 && places < 3 && !end->held[TORSION] && !end->held[BENDING_Y] && !end->held[BENDING_Z];
}

/* Joins an end: the half-spring of its segment in the components that are held. The three of a pivot, and of an end
 * that slides along the ground's axes, are equal to the axial one. */
static void end_join(Scene *scene, int j, int segment, const RodEndDef *end)
{
    Bushing held = joints_clamp(scene, segment);
    const int alike = end->pivot || slides(end);
    if (slides(end)) held.preload[AXIAL] = 0; /* there may be no direction that is held */
    if (alike) joint_even(&held);
    for (int c = 0; c < COMPONENTS; ++c) {
        if (end->held[c] || (alike && c <= SHEAR_Z)) joint_set(&scene->chain, j, &held, c, c + 1);
    }
}

/* Relative rotation of the segments at joint j at t = 0 (B2), as a vector. */
static Vec3 rest_rotation(const Rod *rod, int n, int j)
{
    Quat q = quat_mul(quat_conj(rod_attitude(rod, n, j - 1)), rod_attitude(rod, n, j));
    if (q.w < 0) q = (Quat){-q.w, -q.x, -q.y, -q.z};
    const Vec3 u = v3(q.x, q.y, q.z);
    const double size = v3_norm(u);
    return v3_scale(size > 0 ? 2 * atan2(size, q.w) / size : 2, u);
}

/* A rod with its initial shape as resting shape has preloads that cancel its rotations (RD7). */
static void rod_join(Room *room, Scene *scene)
{
    Chain *const c = &scene->chain;
    const Rod *const rod = room->self;
    end_join(scene, 0, 0, rod->end[ROD_TAIL].def);
    end_join(scene, c->n, c->n - 1, rod->end[ROD_HEAD].def);
    for (int j = 0; scene->def.rod.stress_free && j <= c->n; ++j) {
        const Vec3 rest = rest_rotation(rod, c->n, j);
        const double theta[3] = {rest.x, rest.y, rest.z};
        for (int k = 0; k < 3; ++k) c->preload[TORSION + k][j] -= c->stiffness[TORSION + k][j] * theta[k];
    }
}

/* ------------------------------------------------------------------------------------- prescribed motion of ends */

/* Sums of an end's prescribed motions at time t: displacement, rotation vector, and their rates. */
typedef struct Lead {
    Vec3 move, turn, velocity, turn_rate; /* m, rad, m/s, rad/s */
} Lead;

static Lead lead_at(const RodEndDef *def, double share, double t, int still)
{
    Lead lead = {.move = {0, 0, 0}};
    for (int i = 0; i < def->n_motions; ++i) {
        const RodMotionDef *const m = &def->motions[i];
        const double value = share * (m->rates ? profile_integral : profile_value)(&m->by.size, t);
        const double rate = still ? 0 : (m->rates ? profile_value : profile_rate)(&m->by.size, t);
        Vec3 *const sum = m->turns ? &lead.turn : &lead.move, *const rates =
                                                                  m->turns ? &lead.turn_rate : &lead.velocity;
        *sum = v3_axpy(*sum, value, m->by.direction);
        *rates = v3_axpy(*rates, rate, m->by.direction);
    }
    return lead;
}

/* Angular velocity of exp(r) with rotation vector r and rate r' (RD3). */
static Vec3 spin_of(Vec3 r, Vec3 rate)
{
    const double a = v3_norm(r), a2 = a * a;
    const double s = a > 1e-3 ? sin(a) / a : 1 - a2 / 6, c = a > 1e-3 ? (1 - cos(a)) / a2 : 0.5 - a2 / 24;
    const double d = a > 1e-3 ? (1 - s) / a2 : 1.0 / 6 - a2 / 120;
    return v3_axpy(v3_axpy(v3_scale(s, rate), c, v3_cross(r, rate)), d * v3_dot(r, rate), r);
}

/* Writes the axes of ground body i along which its end slides into axis[3]; returns their number. */
static int free_axes(const RodEndDef *def, const Kinematics *kin, int i, Vec3 *axis)
{
    int n = 0;
    for (int c = AXIAL; slides(def) && c <= SHEAR_Z; ++c) {
        const Quat q = {kin->q[0][i], kin->q[1][i], kin->q[2][i], kin->q[3][i]};
        if (!def->held[c]) axis[n++] = quat_rotate(q, v3_axis(c));
    }
    return n;
}

/* The ground body of an end that slides moves along with it (RD21). */
static void ghost_follow(const Scene *scene, const RodEndDef *def, int i, int segment, Kinematics *kin)
{
    Vec3 axis[3];
    const int n = free_axes(def, kin, i, axis);
    if (n > 0) slide_ghost(&scene->chain, kin, i, segment, n, axis);
}

/* Writes one ground body into index i of kin. */
static void ghost_set(const Rod *rod, int which, double t, int i, Kinematics *kin)
{
    const RodEnd *const end = &rod->end[which];
    const Lead lead = lead_at(end->def, 1 - rod->lag, t, rod->still);
    const Quat q = quat_unit(quat_mul(quat_exp(lead.turn), end->attitude));
    const double turn[4] = {q.w, q.x, q.y, q.z};
    v3_store(kin->p, i, v3_add(end->place, lead.move));
    v3_store(kin->v, i, lead.velocity);
    v3_store(kin->w, i, spin_of(lead.turn, lead.turn_rate));
    v3_store(kin->a, i, quat_rotate(q, v3(1, 0, 0)));
    for (int c = 0; c < 4; ++c) kin->q[c][i] = turn[c];
}

/* Sets the prescribed motion of the ends at time t (RD3). */
static void rod_ghosts(const Room *room, const Scene *scene, double t, Kinematics *kin)
{
    const Rod *const rod = room->self;
    ghost_set(rod, ROD_TAIL, t, -1, kin);
    ghost_set(rod, ROD_HEAD, t, scene->chain.n, kin);
    ghost_follow(scene, rod->end[ROD_TAIL].def, -1, 0, kin);
    ghost_follow(scene, rod->end[ROD_HEAD].def, scene->chain.n, scene->chain.n - 1, kin);
}

/* --------------------------------------------------------------------------------------------------- loads */

RodWrench rod_wrench(const RodLoad *load, const Kinematics *kin, double t)
{
    const int i = load->segment;
    const double size = profile_value(&load->def->by.size, t);
    Vec3 along = load->direction;
    if (load->def->follower) {
        along = quat_rotate((Quat){kin->q[0][i], kin->q[1][i], kin->q[2][i], kin->q[3][i]}, along);
    }
    RodWrench w = {.arm = v3_scale(load->arm, v3_load(kin->a, i))};
    if (load->def->moment) {
        w.moment = v3_scale(size, along);
    } else {
        w.force = v3_scale(size, along);
        w.moment = v3_cross(w.arm, w.force);
    }
    return w;
}

static void rod_loads(const Room *room, const Moment *m, int part)
{
    const Rod *const rod = room->self;
    for (int l = 0; part == 0 && l < rod->n_loads; ++l) {
        const RodWrench w = rod_wrench(&rod->load[l], &m->ws->kin, m->t);
        loads_add(&m->ws->loads[0], rod->load[l].segment, w.force, w.moment);
    }
}

/* (RD22) */
static void end_blocks(const Scene *scene, const RodEndDef *def, const Kinematics *kin, int i, int segment,
                       BlockChain *k, BlockChain *d)
{
    Vec3 axis[3];
    slide_blocks(&scene->chain, kin, i, segment, free_axes(def, kin, i, axis), axis, k, d);
}

/* Only rotations matter: a dead force keeps its direction while its arm turns; a follower turns as a whole (RD6). */
static void rod_blocks(const Room *room, const Moment *m, BlockChain *k, BlockChain *d)
{
    const Rod *const rod = room->self;
    const Kinematics *const kin = &m->ws->kin;
    end_blocks(m->scene, rod->end[ROD_TAIL].def, kin, -1, 0, k, d);
    end_blocks(m->scene, rod->end[ROD_HEAD].def, kin, m->scene->chain.n, m->scene->chain.n - 1, k, d);
    for (int l = 0; l < rod->n_loads; ++l) {
        const RodLoad *const load = &rod->load[l];
        const RodWrench w = rod_wrench(load, kin, m->t);
        for (int c = 0; c < 3; ++c) {
            const Vec3 e = v3_axis(c), turned = v3_cross(v3_cross(e, w.arm), w.force);
            const int follows = load->def->follower;
            block6_add(k->diag + 36 * (size_t)load->segment, 3 + c, follows ? v3_cross(e, w.force) : V3_ZERO,
                       follows ? v3_cross(e, w.moment) : turned);
        }
    }
}

/* Work of the ground at both ends, and of the loads. */
static void rod_work(const Room *room, const Moment *m, BalanceRates *out)
{
    const Rod *const rod = room->self;
    const Kinematics *const kin = &m->ws->kin;
    bushing_kernels()->loads(&m->scene->chain, kin, 0, 1, &m->ws->joints);
    balance_work(out, BY_ENDS, dynamics_ghost_push(m, 0));
    balance_work(out, BY_ENDS, dynamics_ghost_push(m, m->scene->chain.n));
    Push sum = {0};
    for (int l = 0; l < rod->n_loads; ++l) {
        const int i = rod->load[l].segment;
        const RodWrench w = rod_wrench(&rod->load[l], kin, m->t);
        const double power = v3_dot(w.force, v3_load(kin->v, i)) + v3_dot(w.moment, v3_load(kin->w, i));
        sum = push_sum(sum, (Push){power, w.force});
    }
    balance_work(out, BY_LOADS, sum);
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

int rod_circulates(const Rod *rod, double t)
{
    int any = 0;
    for (int l = 0; l < rod->n_loads; ++l) {
        const RodLoadDef *const def = rod->load[l].def;
        any |= (def->follower || def->moment) && fabs(profile_value(&def->by.size, t)) > 0;
    }
    return any;
}

/* Rotation by which the ends are led from their state at `from` (s; NAN: the initial state), rad. */
static double led_from(const Rod *rod, double from, double t)
{
    double largest = 0;
    for (int e = 0; rod->present && e < 2; ++e) {
        const Vec3 was = isnan(from) ? V3_ZERO : lead_at(rod->end[e].def, 1, from, 1).turn;
        largest = fmax(largest, v3_norm(v3_sub(lead_at(rod->end[e].def, 1, t, 1).turn, was)));
    }
    return largest;
}

int rod_led_parts(const Rod *rod, double t) { return (int)ceil(led_from(rod, NAN, t) / LED_AT_ONCE); }

double rod_led_until(const Rod *rod, double t, double next)
{
    if (!isfinite(next) || led_from(rod, t, next) <= LED_AT_ONCE) return next;
    double low = t, high = next; /* low: within the limit; high: beyond it */
    for (int k = 0; k < 40; ++k) {
        const double middle = low + (high - low) / 2;
        if (led_from(rod, t, middle) <= LED_AT_ONCE) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

int rod_is_loose(const Scene *scene)
{
    const int touches = scene->contact.n_rollers > 0 || scene->surfaces.model.n_patches > 0;
    return scene->rod->present && !touches && rod_ends_held(scene->rod) == 0;
}

static double rod_next_stop(const Room *room, const Scene *scene, double t)
{
    (void)scene;
    const Rod *const rod = room->self;
    double next = INFINITY;
    for (int l = 0; l < rod->n_loads; ++l) next = profile_corner_before(&rod->load[l].def->by.size, t, next);
    for (int e = 0; e < 2; ++e) {
        const RodEndDef *const end = rod->end[e].def;
        for (int i = 0; i < end->n_motions; ++i) next = profile_corner_before(&end->motions[i].by.size, t, next);
    }
    return rod_led_until(rod, t, next);
}

const RoomKind ROD_ROOM = {.name = "rod",
                           .build = rod_build,
                           .join = rod_join,
                           .clear = rod_clear,
                           .ghosts = rod_ghosts,
                           .loads = rod_loads,
                           .blocks = rod_blocks,
                           .next_stop = rod_next_stop,
                           .work = rod_work,
                           .in_space = "the case describes a rod"};
