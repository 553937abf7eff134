/* Motors of rollers that spin: set torque or set speed. docs/model.md, "Rollers that spin and rollers on mounts",
 * "Motor". The torque acts where the bearing's does (sim/equipment/roller_motion.h); what it is set to at a time, who
 * pays for it and what a run says of it is here. */
#include <math.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "sim/dynamics.h"
#include "sim/equipment/roller_motion.h"
#include "sim/equipment/rooms.h"
#include "sim/equipment/winch.h"

typedef struct Motor {
    const RollerDef *roller; /* of the scene's definition */
    int item;                /* which of the moving rollers */
    double way;              /* 1 or -1: times its turning about the roller's axis goes with the pull */
} Motor;

typedef struct Motors {
    int n;
    Motor *motor; /* [n], by place; those that are listed by coordinates behind the others */
} Motors;

/* ---------------------------------------------------------------------------------------------------- building */

/* From the roller's centre to the cable on the route, unit. It has a place there. */
static Vec3 toward_cable(const Scene *scene, const RollerDef *roller)
{
    return v3_unit(v3_sub(route_at(&scene->route, roller->s).position, roller->centre));
}

/* Which turning about its axis drives the cable along the pull; one that is listed says so by its axis. */
static double way_of(const Scene *scene, const RollerDef *roller)
{
    if (isnan(roller->s)) return 1;
    const Vec3 rim = v3_cross(roller->axis, toward_cable(scene, roller));
    return v3_dot(rim, route_at(&scene->route, roller->s).tangent) < 0 ? -1 : 1;
}

static int by_place(const void *a, const void *b)
{
    const double first = ((const Motor *)a)->roller->s, second = ((const Motor *)b)->roller->s;
    if (isnan(first) || isnan(second)) return isnan(first) - isnan(second);
    return (first > second) - (first < second);
}

/* After the rollers' room, of whose moving rollers they are. */
static hawser_status motors_build(Room *room, Scene *scene, hawser_error *err)
{
    const Equipment *const q = scene->equipment;
    Motors *const all = room->self = calloc(1, sizeof *all);
    if (!all) return error_memory(err);
    all->motor = calloc((size_t)q->n + 1, sizeof *all->motor);
    if (!all->motor) return error_memory(err);
    for (int k = 0; k < q->n; ++k) {
        const RollerDef *const d = &scene->def.rollers[q->item[k].roller];
        const MotorDef *const motor = &d->spin.motor;
        if (motor->kind == MOTOR_NONE) continue;
        if (motor->factor > 0 && !(scene->winch->present && scene->winch->mode == WINCH_SPEED)) {
            return error_set(err, HAWSER_ERR_INPUT,
                             "key 'rollers.along.spin.motor.factor': roller '%s' runs with the winch, and there is no "
                             "winch with a set speed",
                             d->name);
        }
        all->motor[all->n++] = (Motor){.roller = d, .item = k, .way = way_of(scene, d)};
    }
    qsort(all->motor, (size_t)all->n, sizeof *all->motor, by_place);
    room->present = all->n;
    return HAWSER_OK;
}

static void motors_clear(Room *room)
{
    Motors *const all = room->self;
    if (all) free(all->motor);
}

/* ------------------------------------------------------------------------------------------------------ in a step */

/* (SP16) about the roller's axis. */
static MotorNow motor_now(const Motor *motor, const Winch *w, double t)
{
    const MotorNow along = motor_along(motor->roller, winch_speed(w, t), t);
    if (motor->way > 0) return along;
    return (MotorNow){-along.to, -along.from, -along.above, -along.below};
}

static void motors_pose(const Room *room, const Moment *m, const double *own)
{
    (void)own;
    const Motors *const all = room->self;
    for (int i = 0; i < all->n; ++i) {
        m->ws->equipment->motor[all->motor[i].item] = motor_now(&all->motor[i], m->scene->winch, m->t);
    }
}

/* Where a ramp ends; what runs with the winch has the winch's corners. */
static double motors_next_stop(const Room *room, const Scene *scene, double t)
{
    (void)scene;
    const Motors *const all = room->self;
    double next = INFINITY;
    for (int i = 0; i < all->n; ++i) {
        const MotorDef *const d = &all->motor[i].roller->spin.motor;
        if (!(d->factor > 0)) next = profile_corner_before(&d->set, t, next);
    }
    return next;
}

/* On the rollers, whose push on the cable is told apart. */
static void motors_work(const Room *room, const Moment *m, BalanceRates *out)
{
    (void)room;
    out->work[BY_MOTORS] += m->ws->equipment->by_motors;
}

/* ------------------------------------------------------------------------------------------------------- figures */

static int motors_count(const Room *room) { return ((const Motors *)room->self)->n; }

static const char *motors_name(const Room *room, int i) { return ((const Motors *)room->self)->motor[i].roller->name; }

/* Torque and surface speed with the pull, power, and whether the motor is at its limit: a set speed that takes all the
 * torque, a set torque that the speed limit cuts. */
static void motors_keep(const Room *room, const Moment *m, int i, double value[MACHINE_KEPT_MAX])
{
    const Motor *const motor = &((const Motors *)room->self)->motor[i];
    const MotorNow along = motor_along(motor->roller, winch_speed(m->scene->winch, m->t), m->t);
    const double om = motor->way * equipment_turning(m->ws->equipment, motor->item);
    double slope;
    value[0] = motor_torque(&along, om, &slope);
    value[1] = om * motor->roller->radius;
    value[2] = value[0] * om;
    value[3] = motor->roller->spin.motor.kind == MOTOR_SPEED ? fabs(value[0]) > 0.999 * along.below
                                                             : value[0] < 0.999 * along.below;
}

static void motors_figures(const Room *room, int i, const TimeMean *kept, double expected,
                           double value[MACHINE_FIGURES_MAX])
{
    const RollerDef *const roller = ((const Motors *)room->self)->motor[i].roller;
    const MotorDef *const d = &roller->spin.motor;
    const double figure[] = {roller->s,         d->kind == MOTOR_SPEED ? d->limit : d->set.v1,
                             expected,          mean_of(&kept[0]),
                             kept[0].peak,      mean_of(&kept[1]),
                             mean_of(&kept[2]), mean_of(&kept[3])};
    for (size_t k = 0; k < sizeof figure / sizeof *figure; ++k) value[k] = figure[k];
}

static const MachineKind MOTORS = {.key = "motors",
                                   .count = motors_count,
                                   .name = motors_name,
                                   .n_now = 2,
                                   .n_kept = 4,
                                   .now = {"torque_N_m", "speed_m_per_s"},
                                   .keep = motors_keep,
                                   .n_figures = 8,
                                   .figure = {"at_m", "limit_N_m", "reference_N", "steady_mean_N_m", "peak_N_m",
                                              "surface_m_per_s", "power_W", "at_limit"},
                                   .figures = motors_figures};

const RoomKind MOTORS_ROOM = {.name = "motors",
                              .build = motors_build,
                              .clear = motors_clear,
                              .pose = motors_pose,
                              .next_stop = motors_next_stop,
                              .work = motors_work,
                              .machines = &MOTORS,
                              .in_space = "rollers have motors"};
