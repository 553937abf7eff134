#include "sim/equipment/reel.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "def/winding.h"
#include "sim/dynamics.h"
#include "sim/equipment/rollers.h"
#include "sim/equipment/rooms.h"
#include "sim/joints.h"

static const double HOLD = 1e7; /* N s/m: 1 kN moves the cable's end by 0.1 mm/s */

static const double HOLD_ARM = 0.1; /* m: lever that relates the resistance to turning to that to moving */

/* A flange: a smooth square plane, since a line that touches a disc has no unique nearest point. side: 1 left, -1. */
static void flange_add(SceneDef *def, const char *name, Vec3 centre, Vec3 axis, Vec3 direction, int side)
{
    const DrumDef *const d = &def->drum;
    SurfaceDef *const f = &def->surfaces[def->n_surfaces++];
    double radius = 0;
    for (int c = 0; c < def->n_cables; ++c) radius = fmax(radius, def->cables[c].diameter / 2);
    *f = (SurfaceDef){.shape = {.kind = SURFACE_PLANE,
                                .fade = radius,
                                .cable_radius = radius,
                                .point = v3_axpy(centre, side * d->width / 2, axis),
                                .normal = v3_scale(-side, axis),
                                .along = direction,
                                .width = d->flange,
                                .length = d->flange},
                      .friction = def->friction};
    f->friction.mu_s = f->friction.mu_d = 0;
    snprintf(f->name, sizeof f->name, "%s", name);
}

/* The barrel, which spins against its brake, and the two flanges. */
static hawser_status shapes_add(SceneDef *def, Vec3 centre, Vec3 axis, Vec3 direction, Drum *drum, hawser_error *err)
{
    const DrumDef *const d = &def->drum;
    RollerDef *const rollers = realloc(def->rollers, ((size_t)def->n_rollers + 1) * sizeof *rollers);
    if (rollers) def->rollers = rollers;
    SurfaceDef *const surfaces = realloc(def->surfaces, ((size_t)def->n_surfaces + 2) * sizeof *surfaces);
    if (surfaces) def->surfaces = surfaces;
    if (!rollers || !surfaces) return error_memory(err);
    drum->roller = def->n_rollers++;
    RollerDef *const barrel = &rollers[drum->roller];
    *barrel = (RollerDef){.name = "drum",
                          .centre = centre,
                          .axis = axis,
                          .radius = d->barrel / 2,
                          .width = d->width,
                          .s = NAN,
                          .friction = def->friction};
    barrel->spin = (SpinDef){.inertia = d->inertia, .torque = d->torque, .speed = 2 * def->friction.v_s / d->barrel};
    flange_add(def, "flange left", centre, axis, direction, 1);
    flange_add(def, "flange right", centre, axis, direction, -1);
    return HAWSER_OK;
}

static hawser_status drum_lay(SceneDef *def, const Chain *chain, const double *joint_s, Vec3 origin, Vec3 direction,
                              Vec3 left, Drum *drum, hawser_error *err)
{
    Wound wound;
    hawser_status status = wound_lay(def, chain->n, chain->half, joint_s, &wound, err);
    const Lay *const lay = &wound.lay;
    const int free_joint = wound.joints;
    drum->joint = calloc((size_t)free_joint + 1, sizeof *drum->joint);
    if (!status && !drum->joint) status = error_memory(err);
    const Vec3 up = v3_cross(direction, left);
    drum->tangent = v3_axpy(origin, joint_s[free_joint] - wound.half, direction);
    const Vec3 centre = v3_axpy(v3_axpy(drum->tangent, -wound.radius, up), -wound.across, left);
    for (int j = 0; !status && j < free_joint; ++j) { /* turned so that the cable leaves at the top */
        const Vec3 p = lay_joint(lay, wound.angle[j], 2 * chain->half[j]);
        const double out = sqrt(p.y * p.y + p.z * p.z), turned = wound.angle[j] - wound.last;
        drum->joint[j] =
            v3_axpy(v3_axpy(v3_axpy(centre, p.x, left), out * cos(turned), up), out * sin(turned), direction);
    }
    drum->joints = free_joint;
    drum->turns = wound.last / (2 * M_PI);
    drum->hold = HOLD;
    drum->present = 1;
    free(wound.angle);
    /* the lowest layer ends at the left flange, where the cable must climb; the free width is at its beginning */
    const double aside = (def->drum.width - lay->diameter - lay->turns * lay->pitch) / 2;
    return status ? status : shapes_add(def, v3_axpy(centre, -aside, left), left, direction, drum, err);
}

/* -------------------------------------------------------------------------------------------- the equipment kind */

/* Lays the cable on the drum, whose barrel and flanges become rollers and surfaces of the scene. */
static hawser_status drum_prepare(Room *room, Scene *scene, hawser_error *err)
{
    Drum *const drum = room->self = scene->drum = calloc(1, sizeof *drum);
    if (!drum) return error_memory(err);
    if (!scene->def.drum.present) return HAWSER_OK;
    const RoutePoint start = route_at(&scene->route, 0);
    return drum_lay(&scene->def, &scene->chain, scene->joint_s, start.position, start.tangent,
                    route_left(&scene->route, 0), drum, err);
}

/* The cable behind the route is on the drum, which bears its weight: nothing holds it across the route's line. */
static hawser_status drum_build(Room *room, Scene *scene, hawser_error *err)
{
    (void)err;
    const Drum *const drum = room->self;
    room->present = drum->present;
    if (!drum->present) return HAWSER_OK;
    scene->weight.lead_in = 1;
    scene->weight.behind = V3_ZERO;
    scene->weight.hold = scene->weight.hold_damping = 0;
    scene->joint_start = drum->joint;
    scene->joints_off = drum->joints;
    return HAWSER_OK;
}

/* The wound cable has taken the drum's shape: that is its joints' resting shape (CC25). */
static hawser_status drum_finish(Room *room, Scene *scene, hawser_error *err)
{
    return joints_rest(scene, ((const Drum *)room->self)->joints, err);
}

static void drum_clear(Room *room)
{
    Drum *const drum = room->self;
    if (drum) free(drum->joint);
}

static int drum_work_alloc(const Room *room, const Scene *scene, Workspace *ws)
{
    (void)scene;
    return (ws->room[room->number] = calloc(1, sizeof(Push))) != NULL;
}

/* Hold of segment 0 on the drum (CC26): damping of the end's motion relative to the drum at its place. */
typedef struct Hold {
    double c, turning;  /* N s/m, N m s */
    Vec3 arm, spin;     /* m, from the drum's centre; rad/s, of the drum */
    Vec3 force, moment; /* N, N m, on the segment */
} Hold;

static Hold hold_of(const Drum *drum, const Moment *m)
{
    const Kinematics *const kin = &m->ws->kin;
    const EquipmentWork *const work = m->ws->equipment;
    Hold h = {.c = m->friction * drum->hold, .spin = work->motion[drum->roller].w};
    h.turning = h.c * HOLD_ARM * HOLD_ARM;
    h.arm = v3_sub(v3_load(kin->p, 0), work->roller[drum->roller].shape.centre);
    h.force = v3_scale(-h.c, v3_sub(v3_load(kin->v, 0), v3_cross(h.spin, h.arm)));
    h.moment = v3_scale(-h.turning, v3_sub(v3_load(kin->w, 0), h.spin));
    return h;
}

/* Adds the hold to the segment and to the barrel, and the energy that it takes from both. */
static void drum_hold(const Room *room, const Moment *m)
{
    const Drum *const drum = room->self;
    const Hold h = hold_of(drum, m);
    loads_add(&m->ws->loads[0], 0, h.force, h.moment);
    RollerLoad *const on = &m->ws->equipment->load[drum->roller];
    on->force = v3_sub(on->force, h.force);
    on->moment = v3_sub(v3_sub(on->moment, v3_cross(h.arm, h.force)), h.moment);
    const double lost =
        (v3_dot(h.force, h.force) + v3_dot(h.moment, h.moment) / (HOLD_ARM * HOLD_ARM)) / fmax(h.c, DBL_MIN);
    *(Push *)m->ws->room[room->number] = (Push){-lost, h.force};
}

/* Derivatives by one coordinate: df, dm on the segment, the opposite about the drum's centre, whose arm may change
 * too. */
typedef struct HoldColumn {
    Vec3 force, moment, drum;
} HoldColumn;

static HoldColumn hold_column(Vec3 arm, Vec3 force, Vec3 df, Vec3 dm, Vec3 darm)
{
    return (HoldColumn){df, dm, v3_scale(-1, v3_add(v3_add(v3_cross(arm, df), v3_cross(darm, force)), dm))};
}

static void drum_blocks(const Room *room, const Moment *m, BlockChain *k, BlockChain *d)
{
    const Drum *const drum = room->self;
    const Hold h = hold_of(drum, m);
    RollerCoupling coupling = {.roller = drum->roller, .body = {0, -1}};
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 e = v3_axis(axis);
        /* the segment moves, or the drum's centre the opposite way; velocities; angular velocities of both */
        const HoldColumn shift = hold_column(h.arm, h.force, v3_scale(h.c, v3_cross(h.spin, e)), V3_ZERO, e);
        const HoldColumn speed = hold_column(h.arm, h.force, v3_scale(-h.c, e), V3_ZERO, V3_ZERO);
        const HoldColumn spin = hold_column(h.arm, h.force, V3_ZERO, v3_scale(-h.turning, e), V3_ZERO);
        const HoldColumn run =
            hold_column(h.arm, h.force, v3_scale(h.c, v3_cross(e, h.arm)), v3_scale(h.turning, e), V3_ZERO);
        block6_add(k->diag, axis, shift.force, shift.moment);
        block6_add(d->diag, axis, speed.force, speed.moment);
        block6_add(d->diag, 3 + axis, spin.force, spin.moment);
        block6_add(coupling.into[1][0], 3 + axis, run.force, run.moment);
        block6_add(coupling.from[0][0], axis, v3_scale(-1, shift.force), shift.drum);
        block6_add(coupling.from[1][0], axis, v3_scale(-1, speed.force), speed.drum);
        block6_add(coupling.from[1][0], 3 + axis, v3_scale(-1, spin.force), spin.drum);
        block6_add(coupling.own[1], 3 + axis, v3_scale(-1, run.force), run.drum);
    }
    equipment_blocks_take(m->ws->equipment, 0, &coupling);
}

static void drum_work(const Room *room, const Moment *m, BalanceRates *out)
{
    const Push *const hold = m->ws->room[room->number];
    out->loss[LOST_ROLLERS] -= hold->power;
    out->push[PUSH_ROLLERS] = v3_add(out->push[PUSH_ROLLERS], hold->force);
}

const RoomKind DRUM_ROOM = {.name = "drum",
                            .prepare = drum_prepare,
                            .build = drum_build,
                            .finish = drum_finish,
                            .clear = drum_clear,
                            .work_alloc = drum_work_alloc,
                            .after_loads = drum_hold,
                            .blocks = drum_blocks,
                            .work = drum_work,
                            .in_space = "the cable is wound on a drum"};

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

/* Length of cable from the drum to the centre of segment 0, m (RL6). */
static double reel_free_length(const Reel *r, const Kinematics *kin)
{
    return v3_dot(v3_sub(v3_load(kin->p, 0), r->drum), r->direction);
}

/* Share of the drum's hold on the cable: it releases a free end over the length of the last segment (RL14). */
static double grip(const Reel *r, double l, double *slope)
{
    *slope = 0;
    if (!r->last || r->fixed) return 1;
    return step_cubic(l, r->half, 1, 3 * r->half, 0, slope);
}

/* Force of the fastened end of an empty drum once the last segment has passed: a spring that sets in over 1 mm
 * (RL15). */
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

/* Rotation of the tail against the line, and the length of cable that is bent by it (RL9). */
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

/* The drum's rigidities, each times its `factor`, applied to a world vector: R diag R^T a. */
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

/* Force and moment on segment 0; the stand bears the drum. */
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
                   turned = v3_axpy(v3_cross(e, h.u), h.s, e); /* theta = 2 u changes by s phi + phi x u */
        const double along = v3_dot(e, r->direction);
        block6_add(k->diag, c, v3_scale(-by_l * along, r->direction), v3_scale(h.by_l * along, moment));
        block6_add(d->diag, c, v3_scale(-by_v * along, r->direction), V3_ZERO);
        block6_add(k->diag, 3 + c, V3_ZERO, v3_scale(-h.share, rigid_times(r, PLAIN, turned)));
        block6_add(d->diag, 3 + c, V3_ZERO, v3_scale(-h.share, rigid_times(r, r->damping, e)));
    }
}

/* Work of brake, bearing, back tension, and of the bending of the cable that leaves the reel. */
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

/* (K5). A proportional brake is set by its torque at the speed that the case gives. */
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
    controls_count(visit, &r->present, r->winding.pitch > 0); /* a loaded state cannot add a reel to a case without
                                                               * one */
    controls_profile(visit, &r->braked, &level);
}

/* The reel is behind the route's start, on the lead-in's line, and provides the back tension. */
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
