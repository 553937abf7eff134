#include "sim/equipment/drum.h"

#include <float.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"

static const double HOLD = 1e7;     /* N s/m: 1 kN drags the cable's end along by 0.1 mm/s */
static const double HOLD_ARM = 0.1; /* m: lever at which turning is held as moving is */
/* Diameters from turn to turn and from layer to layer: the cable leaves square, the turn before it does not. */
static const double LAY = 1.03;

/* How the cable lies: radii and places across as functions of the angle from its inner end (CC22), (CC23). */
typedef struct Lay {
    double first;    /* m, radius of the lowest layer's axis */
    double diameter; /* m, of the cable */
    double pitch;    /* m, from turn to turn and from layer to layer */
    double turns;    /* regular ones in the lowest layer */
} Lay;

/* The lay for a drum and a cable of this diameter. */
static Lay lay_of(const DrumDef *d, double diameter)
{
    Lay lay = {.first = (d->barrel + diameter) / 2, .diameter = diameter};
    lay.pitch = d->lay > 0 ? d->lay : LAY * diameter;
    lay.turns = floor((d->width - 2 * diameter) / lay.pitch * (1 + 1e-9));
    return lay;
}

/* Turns that the lay holds: two layers, and of the third what does not come near the second's first turns, which stand
 * out where they cross the turn below. */
static double lay_capacity(const Lay *lay) { return 2 * lay->turns + 3 + fmax(0, lay->turns - 5); }

/* Radius and place across after so many turns. Above the lowest layer each begins with a turn that climbs round the one
 * before it and one that comes back over that; then it goes on beside itself to the other flange (CC23). */
static void lay_at(const Lay *lay, double turn, double *radius, double *across)
{
    const double edge = lay->turns * lay->pitch / 2, past = fmax(turn - lay->turns, 0);
    const double layer = floor(past / (lay->turns + 1)), in = past - layer * (lay->turns + 1);
    const double side = fmod(layer, 2) > 0.5 ? -1 : 1;
    double up = layer, over = -1; /* pitches above the lowest layer, and beyond the edge */
    if (turn < lay->turns) {
        /* the end stands out straight, where layers above would meet it: it begins a diameter aside */
        *radius = lay->first;
        *across = lay->pitch * turn - edge - lay->diameter * fmax(1 - 2 * turn, 0);
        return;
    }
    if (in < 1) {
        up += sin(M_PI / 2 * in);
        over += in + cos(M_PI / 2 * in);
    } else if (in < 2) {
        const double a = M_PI / 2 * (in - 1);
        up += sin(a) + cos(a);
        over += in - 1 + cos(a) - sin(a);
    } else {
        up += 1;
        over -= in - 2;
    }
    *radius = lay->first + lay->pitch * up;
    *across = side * (edge + lay->pitch * over);
}

/* Where a joint between segments of length h lies for the segments' middles to lie on the lay: in the drum's frame, x
 * across, y and z round. */
static Vec3 joint_at(const Lay *lay, double angle, double h)
{
    double radius, across;
    lay_at(lay, angle / (2 * M_PI), &radius, &across);
    const double out = sqrt(radius * radius + h * h / 4);
    return v3(across, out * sin(angle), out * cos(angle));
}

/* The angle of the next joint: one chord of length h on. */
static double angle_next(const Lay *lay, double angle, double h)
{
    const Vec3 from = joint_at(lay, angle, h);
    double radius, across, low = angle;
    lay_at(lay, angle / (2 * M_PI), &radius, &across);
    double high = angle + 2 * atan(h / radius);
    for (int it = 0; it < 60; ++it) {
        const double middle = (low + high) / 2;
        if (v3_norm(v3_sub(joint_at(lay, middle, h), from)) < h) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return (low + high) / 2;
}

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

/* Whether turns, layers and the way to the route fit; turns: wound. */
static hawser_status fit_check(const SceneDef *def, const Lay *lay, double turns, int wound, hawser_error *err)
{
    const DrumDef *const d = &def->drum;
    double radius = 0, across;
    lay_at(lay, turns, &radius, &across);
    if (wound < 2) {
        return error_set(
            err, HAWSER_ERR_INPUT,
            "reel: no cable is left for the drum: the chain ends %.4g m behind the route's start or nearer",
            d->distance);
    }
    if (lay->turns < 2) {
        return error_set(
            err, HAWSER_ERR_INPUT,
            "reel.width: %.4g m is too narrow: a layer has two turns at least, with room for two beside, %.4g m",
            d->width, 2 * lay->pitch + 2 * lay->diameter);
    }
    if (turns > lay_capacity(lay)) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "reel.width: more cable than fits: %.4g turns of %.4g m cable, the contact model holds %.4g",
                         turns, lay->diameter, lay_capacity(lay));
    }
    if (2 * radius + lay->diameter > d->flange) {
        return error_set(
            err, HAWSER_ERR_INPUT,
            "reel.flange: more cable than fits: the top layer reaches a diameter of %.4g m, the flange %.4g m",
            2 * radius + lay->diameter, d->flange);
    }
    if (d->distance > d->flange / 2) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT,
                     "reel.distance: %.4g m is out of range: must be above the flange's radius, %.4g m", d->distance,
                     d->flange / 2);
}

hawser_status drum_lay(SceneDef *def, const Chain *chain, const double *joint_s, Vec3 origin, Vec3 direction, Vec3 left,
                       Drum *drum, hawser_error *err)
{
    const Lay lay = lay_of(&def->drum, 2 * chain->radius[0]);
    int free_joint = 0; /* the last one on or behind the place where the cable leaves */
    while (free_joint < chain->n && joint_s[free_joint + 1] <= -def->drum.distance) ++free_joint;
    double *const angle = calloc((size_t)free_joint + 1, sizeof *angle);
    drum->joint = calloc((size_t)free_joint + 1, sizeof *drum->joint);
    if (!angle || !drum->joint) {
        free(angle);
        return error_memory(err);
    }
    for (int j = 1; lay.turns >= 2 && j < free_joint; ++j)
        angle[j] = angle_next(&lay, angle[j - 1], 2 * chain->half[j - 1]);

    /* the segment before the free joint is half on the drum and half off it: its middle is where the cable leaves */
    const double half = free_joint > 0 ? chain->half[free_joint - 1] : 0;
    double radius = lay.first, across = 0, last = free_joint > 0 ? angle[free_joint - 1] : 0;
    if (lay.turns >= 2) lay_at(&lay, last / (2 * M_PI), &radius, &across);
    last += atan(half / radius);
    hawser_status status = fit_check(def, &lay, last / (2 * M_PI), free_joint, err);
    const Vec3 up = v3_cross(direction, left);
    drum->tangent = v3_axpy(origin, joint_s[free_joint] - half, direction);
    const Vec3 centre = v3_axpy(v3_axpy(drum->tangent, -radius, up), -across, left);
    for (int j = 0; !status && j < free_joint; ++j) { /* turned so that it leaves at the top */
        const Vec3 p = joint_at(&lay, angle[j], 2 * chain->half[j]);
        const double out = sqrt(p.y * p.y + p.z * p.z), turned = angle[j] - last;
        drum->joint[j] =
            v3_axpy(v3_axpy(v3_axpy(centre, p.x, left), out * cos(turned), up), out * sin(turned), direction);
    }
    drum->joints = free_joint;
    drum->turns = last / (2 * M_PI);
    drum->hold = HOLD;
    drum->present = 1;
    free(angle);
    /* the lowest layer ends at the left flange, where it must climb; all room left is at its beginning */
    const double aside = (def->drum.width - lay.diameter - lay.turns * lay.pitch) / 2;
    return status ? status : shapes_add(def, v3_axpy(centre, -aside, left), left, direction, drum, err);
}

void drum_clear(Drum *drum)
{
    free(drum->joint);
    memset(drum, 0, sizeof *drum);
}

static Vec3 vector_at(double *const a[3], int i) { return v3(a[0][i], a[1][i], a[2][i]); }

/* (CC26): the end's motion against the drum at its place, resisted. */
Push drum_hold(const Drum *drum, const Kinematics *kin, EquipmentWork *work, double friction, Loads *loads)
{
    const double c = friction * drum->hold, turning = c * HOLD_ARM * HOLD_ARM;
    const Vec3 w = work->motion[drum->roller].w;
    const Vec3 arm = v3_sub(vector_at(kin->p, 0), work->roller[drum->roller].shape.centre);
    const Vec3 force = v3_scale(-c, v3_sub(vector_at(kin->v, 0), v3_cross(w, arm)));
    const Vec3 moment = v3_scale(-turning, v3_sub(vector_at(kin->w, 0), w));
    const double f[3] = {force.x, force.y, force.z}, m[3] = {moment.x, moment.y, moment.z};
    for (int k = 0; k < 3; ++k) {
        loads->f[k][0] += f[k];
        loads->m[k][0] += m[k];
    }
    RollerLoad *const on = &work->load[drum->roller];
    on->force = v3_sub(on->force, force);
    on->moment = v3_sub(v3_sub(on->moment, v3_cross(arm, force)), moment);
    const double lost = (v3_dot(force, force) + v3_dot(moment, moment) / (HOLD_ARM * HOLD_ARM)) / fmax(c, DBL_MIN);
    return (Push){-lost, force};
}

/* Adds a column [force; moment] to a 6x6 block. */
static void column_add(double *block, int column, Vec3 force, Vec3 moment)
{
    const double rows[6] = {force.x, force.y, force.z, moment.x, moment.y, moment.z};
    for (int r = 0; r < 6; ++r) block[6 * column + r] += rows[r];
}

/* One coordinate's share: df, dm on the segment, the opposite about the drum's centre, where the arm may change too. */
typedef struct HoldColumn {
    Vec3 force, moment, drum;
} HoldColumn;

static HoldColumn hold_column(Vec3 arm, Vec3 force, Vec3 df, Vec3 dm, Vec3 darm)
{
    return (HoldColumn){df, dm, v3_scale(-1, v3_add(v3_add(v3_cross(arm, df), v3_cross(darm, force)), dm))};
}

void drum_hold_blocks(const Drum *drum, const Kinematics *kin, EquipmentWork *work, double friction, BlockChain *k,
                      BlockChain *d)
{
    const double c = friction * drum->hold, turning = c * HOLD_ARM * HOLD_ARM;
    const Vec3 w = work->motion[drum->roller].w, none = v3(0, 0, 0);
    const Vec3 arm = v3_sub(vector_at(kin->p, 0), work->roller[drum->roller].shape.centre);
    const Vec3 force = v3_scale(-c, v3_sub(vector_at(kin->v, 0), v3_cross(w, arm)));
    RollerCoupling coupling = {.roller = drum->roller, .body = {0, -1}};
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 e = v3(axis == 0, axis == 1, axis == 2);
        /* the segment moves, or the drum's centre the other way; velocities; angular velocities of both */
        const HoldColumn shift = hold_column(arm, force, v3_scale(c, v3_cross(w, e)), none, e);
        const HoldColumn speed = hold_column(arm, force, v3_scale(-c, e), none, none);
        const HoldColumn spin = hold_column(arm, force, none, v3_scale(-turning, e), none);
        const HoldColumn run = hold_column(arm, force, v3_scale(c, v3_cross(e, arm)), v3_scale(turning, e), none);
        column_add(k->diag, axis, shift.force, shift.moment);
        column_add(d->diag, axis, speed.force, speed.moment);
        column_add(d->diag, 3 + axis, spin.force, spin.moment);
        column_add(coupling.into[1][0], 3 + axis, run.force, run.moment);
        column_add(coupling.from[0][0], axis, v3_scale(-1, shift.force), shift.drum);
        column_add(coupling.from[1][0], axis, v3_scale(-1, speed.force), speed.drum);
        column_add(coupling.from[1][0], 3 + axis, v3_scale(-1, spin.force), spin.drum);
        column_add(coupling.own[1], 3 + axis, v3_scale(-1, run.force), run.drum);
    }
    equipment_blocks_take(work, 0, &coupling);
}
