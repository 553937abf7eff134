#include "sim/equipment/reel.h"

#include <math.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "sim/dynamics.h"
#include "sim/equipment/rooms.h"

static void reel_init(Reel *r, const SceneDef *def, Vec3 origin, Vec3 direction, Quat attitude)
{
    const ReelDef *const d = &def->reel;
    *r = (Reel){.present = 1,
                .drum = v3_axpy(origin, -d->distance, direction),
                .direction = direction,
                .attitude = attitude,
                .total = cable_length(def),
                .winding = reel_winding(def),
                .brake = reel_brake_of(def),
                .tension = def->tail.tension,
                .fixed = d->end_fixed,
                .braked = profile_level(1)};
    if (!def->lead_in.carries_weight) r->downhill = v3_scale(v3_dot(def->gravity, direction), direction);
}

void reel_hold(Reel *r, const Chain *whole, int first, const CableDef *cable)
{
    r->wound = 0;
    for (int i = 0; i < first; ++i) r->wound += 2 * whole->half[i];
    r->half = whole->half[first];
    r->last = first == 0;
    const double radius = winding_radius(&r->winding, r->wound, NULL);
    r->mass = winding_inertia(&r->winding, r->wound) / (radius * radius);
    const double rigidity[3] = {cable->gj, cable->ei_y, cable->ei_z};
    for (int c = 0; c < 3; ++c) {
        r->rigidity[c] = rigidity[c];
        r->damping[c] = cable->damping * cable->damping_factor[3 + c];
    }
    r->catch = cable->ea / (2 * r->half);
}

double reel_free_length(const Reel *r, const Kinematics *kin)
{
    return v3_dot(v3_sub(v3_load(kin->p, 0), r->drum), r->direction);
}

/* Share of the drum's hold on the cable: it lets a free end go over the last segment's length (RL14). */
static double grip(const Reel *r, double l, double *slope)
{
    *slope = 0;
    if (!r->last || r->fixed) return 1;
    return step_cubic(l, r->half, 1, 3 * r->half, 0, slope);
}

/* The fastened end of an empty drum holds, once the last segment has passed: a spring that sets in over 1 mm (RL15). */
static double catch_force(const Reel *r, double l, double v, double *by_l, double *by_v)
{
    static const double SOFT = 1e-3; /* m */
    const double u = l - 3 * r->half;
    *by_l = *by_v = 0;
    if (!r->last || !r->fixed || u <= 0) return 0;
    const double share = u / (u + SOFT), c = r->catch * r->damping[1], rate = SOFT / ((u + SOFT) * (u + SOFT));
    *by_l = r->catch * (share + u * rate) + c * v * rate;
    *by_v = c * share;
    return r->catch * u * share + c * share * v;
}

double reel_resistance(const Reel *r, double l, double v, double t, double friction, double *by_l, double *by_v)
{
    double bend, fade, by_radius, torque_by_v, catch_by_l, catch_by_v;
    const double radius = winding_radius(&r->winding, r->wound - (l - r->half), &bend);
    const double share = profile_value(&r->braked, t);
    const double torque = reel_brake_torque(&r->brake, share, radius, v, t, &by_radius, &torque_by_v);
    const double g = grip(r, l, &fade), drag = profile_value(&r->tension, t) + friction * torque / radius;
    const double caught = catch_force(r, l, v, &catch_by_l, &catch_by_v);
    /* the radius shrinks as the cable leaves: d(radius)/dl = -bend */
    const double drag_by_l = -friction * bend * (by_radius - torque / radius) / radius;
    if (by_l) *by_l = g * drag_by_l + fade * drag + catch_by_l;
    if (by_v) *by_v = g * friction * torque_by_v / radius + catch_by_v;
    return g * drag + caught;
}

/* The tail's attitude against the line, and the stretch of cable that turns with it (RL9). */
typedef struct Held {
    double s;           /* scalar part of the relative quaternion, >= 0 */
    Vec3 u;             /* its vector part, world */
    double share, by_l; /* grip over free length, 1/m, and its derivative by l */
} Held;

static Held held_of(const Reel *r, const Kinematics *kin, double l)
{
    const Quat q = {kin->q[0][0], kin->q[1][0], kin->q[2][0], kin->q[3][0]};
    const Quat rel = quat_mul(q, quat_conj(r->attitude));
    const double sign = rel.w < 0 ? -1 : 1, length = fmax(l, r->half / 2);
    double fade;
    const double g = grip(r, l, &fade);
    return (Held){.s = sign * rel.w,
                  .u = v3_scale(sign, v3(rel.x, rel.y, rel.z)),
                  .share = g / length,
                  .by_l = fade / length - (l > r->half / 2 ? g / (length * length) : 0)};
}

/* The drum's rigidities, times `factor` each, on a world vector: R diag R^T a. */
static Vec3 rigid_times(const Reel *r, const double factor[3], Vec3 a)
{
    const Vec3 b = quat_rotate(quat_conj(r->attitude), a);
    return quat_rotate(r->attitude, v3(r->rigidity[0] * factor[0] * b.x, r->rigidity[1] * factor[1] * b.y,
                                       r->rigidity[2] * factor[2] * b.z));
}

static const double PLAIN[3] = {1, 1, 1};

/* Moment on the tail for a share of 1/m (RL9). */
static Vec3 held_moment(const Reel *r, const Held *h, Vec3 spin)
{
    return v3_scale(-1, v3_add(rigid_times(r, PLAIN, v3_scale(2, h->u)), rigid_times(r, r->damping, spin)));
}

/* Force and moment on segment 0; the drum rests on its stand. */
static void tail_wrench(const Reel *r, const Kinematics *kin, double t, double friction, Vec3 *f, Vec3 *m)
{
    const double l = reel_free_length(r, kin), v = v3_dot(v3_load(kin->v, 0), r->direction);
    const Held h = held_of(r, kin, l);
    const double resistance = reel_resistance(r, l, v, t, friction, NULL, NULL);
    *f = v3_axpy(v3_scale(-resistance, r->direction), -r->mass, r->downhill);
    *m = v3_scale(h.share, held_moment(r, &h, v3_load(kin->w, 0)));
}

static void reel_loads(const Room *room, const Moment *m, int part)
{
    const Reel *const r = room->self;
    if (!r->present || part != 0) return;
    Vec3 force, moment;
    tail_wrench(r, &m->ws->kin, m->t, m->friction, &force, &moment);
    loads_add(&m->ws->loads[0], 0, force, moment);
}

static void reel_blocks(const Room *room, const Moment *m, BlockChain *k, BlockChain *d)
{
    const Reel *const r = room->self;
    const Kinematics *const kin = &m->ws->kin;
    if (!r->present) return;
    const double l = reel_free_length(r, kin), v = v3_dot(v3_load(kin->v, 0), r->direction);
    const Held h = held_of(r, kin, l);
    const Vec3 moment = held_moment(r, &h, v3_load(kin->w, 0));
    double by_l, by_v;
    reel_resistance(r, l, v, m->t, m->friction, &by_l, &by_v);
    for (int c = 0; c < 3; ++c) {
        const Vec3 e = v3_axis(c),
                   turned = v3_axpy(v3_cross(e, h.u), h.s, e); /* theta = 2 u turns by s phi + phi x u */
        const double along = v3_dot(e, r->direction);
        block6_add(k->diag, c, v3_scale(-by_l * along, r->direction), v3_scale(h.by_l * along, moment));
        block6_add(d->diag, c, v3_scale(-by_v * along, r->direction), V3_ZERO);
        block6_add(k->diag, 3 + c, V3_ZERO, v3_scale(-h.share, rigid_times(r, PLAIN, turned)));
        block6_add(d->diag, 3 + c, V3_ZERO, v3_scale(-h.share, rigid_times(r, r->damping, e)));
    }
}

/* Brake, bearing, back tension, and the cable that bends as it comes off. */
static void reel_work(const Room *room, const Moment *m, BalanceRates *out)
{
    const Reel *const r = room->self;
    const Kinematics *const kin = &m->ws->kin;
    if (!r->present) return;
    Vec3 force, moment;
    tail_wrench(r, kin, m->t, 1, &force, &moment);
    balance_work(out, BY_REEL, (Push){v3_dot(force, v3_load(kin->v, 0)) + v3_dot(moment, v3_load(kin->w, 0)), force});
}

ReelLook reel_look(const Reel *r, const Chain *chain, const Kinematics *kin, const JointLoads *joints, double t)
{
    const double l = reel_free_length(r, kin), v = v3_dot(v3_load(kin->v, 0), r->direction);
    const double resistance = reel_resistance(r, l, v, t, 1, NULL, NULL), mass = chain->mass[0];
    const double wound = fmax(r->wound - (l - r->half), 0), radius = winding_radius(&r->winding, wound, NULL);
    const Vec3 ahead = v3(joints->force[0][1], joints->force[1][1], joints->force[2][1]);
    const double pull = v3_dot(v3_axpy(ahead, mass - r->mass, r->downhill), r->direction);
    return (ReelLook){.speed = v / radius,
                      .paid_out = r->total - wound,
                      .wound = wound,
                      .tension = resistance + r->mass / mass * (pull - resistance)}; /* (RL11) */
}

Setup scene_setup(const Scene *scene)
{
    Setup now = scene->setup;
    now.largest_speed = scene->largest_speed;
    if (scene->reel->winding.turns > 0) now.braked = scene->reel->braked;
    return now;
}

static double reel_next_stop(const Room *room, const Scene *scene, double t)
{
    (void)scene;
    const Reel *const r = room->self;
    if (!r->present) return INFINITY;
    const double next = profile_corner_before(&r->braked, t, profile_corner_before(&r->tension, t, INFINITY));
    return profile_corner_before(&r->brake.speed, t, next);
}

/* (K5). A proportional brake gives the torque at the speed that the case names. */
static int reel_command(Room *room, const Scene *scene, const Command *c, double t, hawser_error *err)
{
    (void)scene;
    Reel *const r = room->self;
    if (c->kind != HAWSER_REEL_BRAKE) return 0;
    if (!(r->brake.torque > 0)) {
        error_set(err, HAWSER_ERR_INPUT, "the reel of this case has no brake that could be set");
        return -1;
    }
    r->braked = command_ramp(&r->braked, t, c->value / r->brake.torque, c->ramp);
    return 1;
}

static void reel_controls(Room *room, ControlsVisit *visit)
{
    Reel *const r = room->self;
    const Profile level = profile_level(0);
    controls_count(visit, &r->present, r->winding.pitch > 0); /* where there is none, none comes */
    controls_profile(visit, &r->braked, &level);
}

/* It stands behind the route's start, on the lead-in's line, and brings the back tension. */
static hawser_status reel_build(Room *room, Scene *scene, hawser_error *err)
{
    Reel *const r = room->self = scene->reel = calloc(1, sizeof *r);
    if (!r) return error_memory(err);
    if (scene->def.reel.model != REEL_PAYOUT) return HAWSER_OK;
    const Weight *const w = &scene->weight;
    const Vec3 left = v3_unit(v3_reject(route_left(&scene->route, -scene->def.reel.distance), w->direction));
    const Quat attitude = quat_from_axes(w->direction, left, v3_cross(w->direction, left));
    reel_init(r, &scene->def, w->origin, w->direction, attitude);
    scene->tail = (Profile){.kind = PROFILE_CONSTANT};
    room->present = 1;
    return HAWSER_OK;
}

const RoomKind REEL_ROOM = {.name = "reel",
                            .build = reel_build,
                            .loads = reel_loads,
                            .blocks = reel_blocks,
                            .next_stop = reel_next_stop,
                            .command = reel_command,
                            .controls = reel_controls,
                            .work = reel_work,
                            .in_space = "segments join and leave the chain"};
