#include "sim/equipment/drum.h"

#include <float.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "def/wound.h"
#include "sim/dynamics.h"
#include "sim/equipment/roller_motion.h"
#include "sim/equipment/rooms.h"
#include "sim/joints.h"

static const double HOLD = 1e7;     /* N s/m: 1 kN drags the cable's end along by 0.1 mm/s */
static const double HOLD_ARM = 0.1; /* m: lever at which turning is held as moving is */
/* A flange: a smooth square plane, since a line that lies against a disc has no one nearest point. side: 1 left, -1. */
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

/* The barrel, which spins against its brake, and the flanges. */
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
    for (int j = 0; !status && j < free_joint; ++j) { /* turned so that it leaves at the top */
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
    /* the lowest layer ends at the left flange, where it must climb; all room left is at its beginning */
    const double aside = (def->drum.width - lay->diameter - lay->turns * lay->pitch) / 2;
    return status ? status : shapes_add(def, v3_axpy(centre, -aside, left), left, direction, drum, err);
}

/* ------------------------------------------------------------------------------------------------------- the room */

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

/* The cable behind the route lies on the drum, which carries its weight: nothing holds it across the route's line. */
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

/* The wound cable has taken the drum's shape: its joints rest as they lie (CC25). */
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

/* What holds segment 0 to the drum (CC26): the end's motion against the drum at its place, resisted. */
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

/* Onto the segment and onto the barrel; notes what that takes out of the motion of both. */
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

/* One coordinate's share: df, dm on the segment, the opposite about the drum's centre, where the arm may change too. */
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
        /* the segment moves, or the drum's centre the other way; velocities; angular velocities of both */
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
