/* Motors of rollers that spin: set torque or set speed. docs/theory.md, "Rollers that spin and rollers on mounts",
 * "Motor". The torque acts where the bearing's does (sim/equipment/rollers.h); this file has its value over time, its
 * source of energy and its figures of a run. */
#include "sim/equipment/conveyor.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "core/state.h"
#include "sim/dynamics.h"
#include "sim/equipment/rollers.h"
#include "sim/equipment/rooms.h"
#include "sim/equipment/winch.h"

typedef struct Motor {
    const RollerDef *roller; /* of the scene's definition */
    int item;                /* index among the moving rollers */
    double way;              /* 1 or -1: sign of a turning about the roller's axis that goes with the pull */
} Motor;

typedef struct Motors {
    int n;
    Motor *motor; /* [n], by place along the route; rollers listed by coordinates come last */
} Motors;

/* ---------------------------------------------------------------------------------------------------- building */

/* Unit vector from the roller's centre to the cable on the route; the roller must have a place on the route. */
static Vec3 toward_cable(const Scene *scene, const RollerDef *roller)
{
    return v3_unit(v3_sub(route_at(&scene->route, roller->s).position, roller->centre));
}

/* Sign of the turning about the roller's axis that drives the cable along the pull; the axis of a roller listed by
 * coordinates defines it. */
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

/* Called after the rollers are built, since it refers to the moving rollers. */
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

/* End of a ramp; a motor that follows the winch has the winch's corners. */
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

/* The motors act on the rollers; the rollers' push on the cable is counted apart. */
static void motors_work(const Room *room, const Moment *m, BalanceRates *out)
{
    (void)room;
    out->work[BY_MOTORS] += m->ws->equipment->by_motors;
}

/* ------------------------------------------------------------------------------------------------------- figures */

static int motors_count(const Room *room) { return ((const Motors *)room->self)->n; }

static const char *motors_name(const Room *room, int i) { return ((const Motors *)room->self)->motor[i].roller->name; }

/* Torque and surface speed along the pull, power, and whether the motor is at its limit: a set speed that needs the
 * full torque, or a set torque that the speed limit reduces. */
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

static const MachineKind MOTORS = {
    .key = "motors",
    .count = motors_count,
    .name = motors_name,
    .n_now = 2,
    .n_kept = 4,
    .now = {
        /* motor of a roller: torque on the roller, positive with the pull */ "torque_N_m",
        /* motor: speed of the roller's surface */ "speed_m_per_s",
    },
    .keep = motors_keep,
    .n_figures = 8,
    .figure = {
        /* place along the route; null if listed by coordinates */ "at_m",
        /* set torque, or the largest torque of a set speed */ "limit_N_m",
        /* push by the reference theory, beside a fixed roller there */ "reference_N",
        /* mean torque of the steady window */ "steady_mean_N_m",
        /* largest torque */ "peak_N_m",
        /* mean speed of the surface */ "surface_m_per_s",
        /* mean power */ "power_W",
        /* share of the window at the limit of torque or speed */ "at_limit",
    },
    .figures = motors_figures};

const RoomKind MOTORS_ROOM = {.name = "motors",
                              .build = motors_build,
                              .clear = motors_clear,
                              .pose = motors_pose,
                              .next_stop = motors_next_stop,
                              .work = motors_work,
                              .machines = &MOTORS,
                              .in_space = "rollers have motors"};

/* Largest distance from a machine's line at which a cable still counts as passing through it, m. */
static const double ASIDE_MAX = 1;

/* Compliance of the belts over v_s (WI21), s: their lean at the full grip is v_s times this. */
static const double GIVE = 0.02;

/* A straight machine between two points of the route. Its hold across the line yields by 1 mm under the cable's weight,
 * half critically damped, as that of the lead-in (F1). */
static Conveyor conveyor_of(const ConveyorDef *def, const Route *route, double g)
{
    const Vec3 in = route_at(route, def->from).position, out = route_at(route, def->to).position;
    Conveyor c = {.def = def,
                  .origin = in,
                  .direction = v3_unit(v3_sub(out, in)),
                  .length = v3_norm(v3_sub(out, in)),
                  .edge = def->edge,
                  .grip = conveyor_grip(def, def->clamp),
                  .law = {.mu_s = 1, .mu_d = def->ratio, .v_s = def->v_s, .v_d = def->v_d},
                  .sync = def->sync,
                  .factor = def->factor,
                  .speed = def->speed,
                  .clamp = profile_level(def->clamp)};
    if (def->hold) {
        c.hold = g / 1e-3;
        c.hold_damping = sqrt(c.hold);
    }
    return c;
}

/* Speed of the belt at time t, m/s. */
static double conveyor_belt(const Conveyor *c, const Winch *w, double t)
{
    return c->sync ? c->factor * winch_speed(w, t) : profile_value(&c->speed, t);
}

/* Speed of the belt; it stops if the conveyor jams (JA3), whatever drives it. */
static double belt_speed(const Conveyor *c, const Winch *w, const Seizure *seized, double t)
{
    const double belt = conveyor_belt(c, w, t);
    return seized ? belt * (1 - profile_value(&seized->share, t)) : belt;
}

/* (K4) */
static double grip_now(const Conveyor *c, double t)
{
    if (!c->told) return c->grip;
    return conveyor_grip(c->def, profile_value(&c->clamp, t));
}

Belt conveyor_runs(const Conveyor *c, const Winch *w, const Seizure *seized, double since, double t)
{
    Belt belt = {.speed = belt_speed(c, w, seized, t), .grip = grip_now(c, t), .elapsed = t > since ? t - since : 0};
    belt.mean = belt.speed;
    if (belt.elapsed > 0) {
        const double first = belt_speed(c, w, seized, since), middle = belt_speed(c, w, seized, (since + t) / 2);
        belt.mean = (first + 4 * middle + belt.speed) / 6;
    }
    return belt;
}

/* Integral of (WI13) from a machine's end to x <= length/2: a ramp by STEP, then level. *slope gets the integrand. */
static double half_area(double edge, double x, double *slope)
{
    if (x <= 0) {
        *slope = 0;
        return 0;
    }
    if (x >= edge) {
        *slope = 1;
        return x - edge / 2;
    }
    const double d = x / edge;
    *slope = step_cubic(x, 0, 0, edge, 1, NULL);
    return edge * d * d * d * (1 - d / 2);
}

double conveyor_share(const Conveyor *c, double x, double *slope)
{
    const double whole = c->length - c->edge;
    const int late = x > c->length / 2;
    const double area = half_area(c->edge, late ? c->length - x : x, slope);
    *slope /= whole;
    return late ? 1 - area / whole : area / whole;
}

/* ---------------------------------------------------------------------------------------- which segments are near */
/* Distance of a segment's extent from the machine's, along its line; if the segment is far to the side, that
 * distance. */
static double distance_of(const Conveyor *c, Vec3 p, double half)
{
    const Vec3 off = v3_sub(p, c->origin);
    const double x = v3_dot(off, c->direction), aside = v3_norm(v3_axpy(off, -x, c->direction));
    const double before = -x - half, behind = x - half - c->length;
    return fmax(fmax(before, behind), aside - ASIDE_MAX);
}

void conveyor_find(const Conveyor *c, const Chain *chain, const double *y, double reach, ConveyorRange *range)
{
    const int n = chain->n;
    double nearest = INFINITY;
    int last = -1;
    range->first = range->watched = 0;
    for (int i = 0; i < n; ++i) {
        const double distance = distance_of(c, state_vector(y, n, STATE_P, i), chain->half[i]);
        if (distance < nearest) {
            nearest = distance;
            range->watched = i;
        }
        if (distance > reach) continue;
        if (last < 0) range->first = i;
        last = i;
    }
    range->count = last < 0 ? 0 : last - range->first + 1;
    range->at = state_vector(y, n, STATE_P, range->watched);
    /* a quarter of the reach is reserved for the motion within a step; far away half of the distance suffices */
    range->free = fmax(0.75 * reach, 0.5 * nearest);
}

int conveyor_stale(const ConveyorRange *range, const Chain *chain, const double *y)
{
    const Vec3 moved = v3_sub(state_vector(y, chain->n, STATE_P, range->watched), range->at);
    return !(v3_dot(moved, moved) <= range->free * range->free);
}

/* ----------------------------------------------------------------------------------------------------------- forces */

/* Distance by which segment i at x is ahead of its place on the belt, m (WI21). */
static double lean_at(const ConveyorRange *range, const Belt *belt, int i, double x)
{
    return range->lean[i] + (belt->elapsed > 0 ? x - range->x[i] - belt->elapsed * belt->mean : 0);
}

/* A segment that slips takes its place on the belt along. */
void conveyor_keep(const Conveyor *c, const Belt *belt, const Chain *chain, const double *y, double t,
                   ConveyorRange *range)
{
    const double most = c->law.v_s * GIVE;
    for (int i = 0; i < chain->n; ++i) {
        const double x = v3_dot(v3_sub(state_vector(y, chain->n, STATE_P, i), c->origin), c->direction);
        const double slip = v3_dot(state_vector(y, chain->n, STATE_V, i), c->direction) - belt->speed;
        const int inside = x + chain->half[i] > 0 && x - chain->half[i] < c->length;
        const double lean = inside ? lean_at(range, belt, i, x) : 0;
        const int holds = fabs(slip + lean / GIVE) < c->law.v_s;
        range->lean[i] = holds ? lean : fmin(fmax(lean, -most), most);
        range->x[i] = x;
    }
    range->since = t;
}

/* One segment in a machine. */
typedef struct Held {
    double grips;           /* 1, or 0 where belts are open */
    double share, d_share;  /* share of the grip (WI14), 1; d/dx, 1/m */
    double cover, d_cover;  /* share of its length that is in the grip, d/dx */
    double slip;            /* m/s */
    double pull, pull_by_x; /* m/s: slip and lean combined (WI21); d/dx, 1/s */
    Vec3 off, v_off;        /* m, m/s: across the machine's line */
} Held;

/* Returns 0 if the segment is outside. */
static int held_at(const Conveyor *c, const ConveyorRange *range, const Belt *belt, const Chain *chain,
                   const Kinematics *kin, int i, Held *out)
{
    const double h = chain->half[i];
    const Vec3 off = v3_sub(v3_load(kin->p, i), c->origin);
    const Vec3 v = v3_load(kin->v, i);
    const double x = v3_dot(off, c->direction), along = v3_dot(v, c->direction);
    double ahead, behind;
    out->grips = i < chain->n - range->open;
    if (x + h <= 0 || x - h >= c->length) return 0;
    out->share = conveyor_share(c, x + h, &ahead) - conveyor_share(c, x - h, &behind);
    out->d_share = ahead - behind;
    const double held = (c->length - c->edge) / (2 * h);
    out->cover = out->share * held;
    out->d_cover = out->d_share * held;
    out->slip = along - belt->speed;
    out->pull = out->slip + (range->x ? lean_at(range, belt, i, x) / GIVE : 0);
    out->pull_by_x = range->x && belt->elapsed > 0 ? 1 / GIVE : 0;
    out->off = v3_axpy(off, -x, c->direction);
    out->v_off = v3_axpy(v, -along, c->direction);
    return 1;
}

/* Force of the whole grip against the slip (or against slip and lean combined), and its slope (WI15). */
static double grip_force(const Conveyor *c, const Belt *belt, double slip, double *slope)
{
    double curve;
    const double over = friction_over_speed(&c->law, fabs(slip), &curve);
    *slope = -belt->grip * (over + curve * slip * slip);
    return -belt->grip * over * slip;
}

/* Force per mass across the line on a segment that is wholly in the grip, m/s2 (WI16). */
static Vec3 hold_force(const Conveyor *c, const Held *held)
{
    return v3_axpy(v3_scale(-c->hold, held->off), -c->hold_damping, held->v_off);
}

ConveyorNow conveyor_loads(const Conveyor *c, const ConveyorRange *range, const Belt *belt, const Chain *chain,
                           const Kinematics *kin, double friction, Loads *loads)
{
    ConveyorNow now = {.belt = belt->speed};
    for (int i = range->first; i < range->first + range->count; ++i) {
        Held held;
        double slope;
        if (!held_at(c, range, belt, chain, kin, i, &held)) continue;
        const double closed = held.grips * held.share,
                     push = friction * closed * grip_force(c, belt, held.pull, &slope);
        now.force += push;
        now.slip += closed * held.slip;
        now.cover += closed;
        const Vec3 hold = v3_scale(held.cover * chain->mass[i], hold_force(c, &held));
        const Vec3 force = v3_axpy(hold, push, c->direction), v = v3_load(kin->v, i);
        now.push = push_sum(now.push, (Push){v3_dot(force, v), force});
        now.lost -= push * held.slip;
        if (loads) v3_gather(loads->f, i, force);
    }
    if (now.cover > 0) now.slip /= now.cover;
    return now;
}

/* (WI18) into k, (WI19) into d, both 6x6 blocks of one segment. */
static void held_blocks(const Conveyor *c, const Belt *belt, const Held *held, double mass, double friction, double *k,
                        double *d)
{
    double slope;
    friction *= held->grips;
    const double push = friction * held->d_share * grip_force(c, belt, held->pull, &slope);
    const double drag = friction * held->share * slope, m = held->cover * mass;
    const Vec3 by_x =
        v3_axpy(v3_scale(held->d_cover * mass, hold_force(c, held)), push + drag * held->pull_by_x, c->direction);
    for (int column = 0; column < 3; ++column) {
        const Vec3 e = v3_axis(column);
        const double x = v3_dot(e, c->direction);
        const Vec3 across = v3_axpy(e, -x, c->direction);
        block6_add(k, column, v3_axpy(v3_scale(x, by_x), -m * c->hold, across), V3_ZERO);
        block6_add(d, column, v3_axpy(v3_scale(x * drag, c->direction), -m * c->hold_damping, across), V3_ZERO);
    }
}

void conveyor_blocks(const Conveyor *c, const ConveyorRange *range, const Belt *belt, const Chain *chain,
                     const Kinematics *kin, double friction, BlockChain *k, BlockChain *d)
{
    for (int i = range->first; i < range->first + range->count; ++i) {
        Held held;
        if (!held_at(c, range, belt, chain, kin, i, &held)) continue;
        held_blocks(c, belt, &held, chain->mass[i], friction, k->diag + 36 * (size_t)i, d->diag + 36 * (size_t)i);
    }
}

/* -------------------------------------------------------------------------------------------- the equipment kind */

/* Cable in a machine's belts, as of the last accepted step. */
typedef struct Filled {
    double cover; /* share of the grip that has cable */
    int grips;    /* -1: not known yet */
    char says[2][NAME_MAX_LENGTH + 32];
} Filled;

/* The conveyors of a scene. */
typedef struct Conveyors {
    int n;
    Conveyor *item;         /* [n], in the case's order */
    const Seizure **seized; /* [n] seizure that stops it; NULL: none */
    Seizure *told;          /* [n] seizure by commands */
    Filled *filled;         /* [n] */
} Conveyors;

static hawser_status conveyors_build(Room *room, Scene *scene, hawser_error *err)
{
    const SceneDef *const def = &scene->def;
    Conveyors *const all = room->self = calloc(1, sizeof *all);
    if (!all) return error_memory(err);
    all->n = room->present = def->n_conveyors;
    all->item = calloc((size_t)def->n_conveyors + 1, sizeof *all->item);
    all->seized = calloc((size_t)def->n_conveyors + 1, sizeof *all->seized);
    all->told = calloc((size_t)def->n_conveyors + 1, sizeof *all->told);
    all->filled = calloc((size_t)def->n_conveyors + 1, sizeof *all->filled);
    if (!all->item || !all->seized || !all->told || !all->filled) return error_memory(err);
    for (int i = 0; i < def->n_conveyors; ++i) {
        all->item[i] = conveyor_of(&def->conveyors[i], &scene->route, v3_norm(def->gravity));
        all->filled[i].grips = -1;
        snprintf(all->filled[i].says[0], sizeof all->filled[i].says[0], "conveyor %s lets go", def->conveyors[i].name);
        snprintf(all->filled[i].says[1], sizeof all->filled[i].says[1], "conveyor %s grips", def->conveyors[i].name);
        if (all->item[i].grip > 0) scene->grip_speed = fmin(scene->grip_speed, all->item[i].law.v_s);
    }
    return HAWSER_OK;
}

static void conveyors_clear(Room *room)
{
    Conveyors *const all = room->self;
    if (!all) return;
    free(all->item);
    free(all->seized);
    free(all->told);
    free(all->filled);
}

static const char *conveyors_seize(Room *room, const Scene *scene, const char *name, const Seizure *by)
{
    (void)scene;
    const Conveyors *const all = room->self;
    for (int i = 0; i < all->n; ++i) {
        if (strcmp(all->item[i].def->name, name) != 0) continue;
        all->seized[i] = by;
        return "conveyor";
    }
    return NULL;
}

/* Allocates the ranges [n] and behind them, in the same block, what they keep of all segments. */
static int conveyors_work_alloc(const Room *room, const Scene *scene, Workspace *ws)
{
    const size_t n = (size_t)((const Conveyors *)room->self)->n, segments = (size_t)scene->chain.n;
    ConveyorRange *const range = calloc(1, (n + 1) * sizeof *range + 2 * n * segments * sizeof(double));
    if (!range) return 0;
    double *kept = (double *)(range + n + 1);
    for (size_t i = 0; i < n; ++i, kept += 2 * segments) {
        range[i].n = scene->chain.n;
        range[i].x = kept;
        range[i].lean = kept + segments;
    }
    ws->room[room->number] = range;
    return 1;
}

/* Kept figures move with their segments. */
static void conveyors_carry(const Room *room, Workspace *from, Workspace *to, int joined)
{
    const Conveyors *const all = room->self;
    const ConveyorRange *const old = from->room[room->number];
    ConveyorRange *const now = to->room[room->number];
    for (int i = 0; i < all->n; ++i) {
        now[i].since = old[i].since;
        for (int k = joined; k < now[i].n && k - joined < old[i].n; ++k) now[i].lean[k] = old[i].lean[k - joined];
    }
}

/* Motion of conveyor i's belt. */
static Belt belt_of(const Room *room, const Moment *m, int i)
{
    const Conveyors *const all = room->self;
    const ConveyorRange *const range = m->ws->room[room->number];
    return conveyor_runs(&all->item[i], m->scene->winch, all->seized[i], range[i].since, m->t);
}

/* There are few segments, and their loads are added in the order of the machines: one thread does it all. */
static void conveyors_loads(const Room *room, const Moment *m, int part)
{
    const Conveyors *const all = room->self;
    const ConveyorRange *const range = m->ws->room[room->number];
    for (int i = 0; part == 0 && i < all->n; ++i) {
        const Belt belt = belt_of(room, m, i);
        conveyor_loads(&all->item[i], &range[i], &belt, &m->scene->chain, &m->ws->kin, m->friction, &m->ws->loads[0]);
    }
}

static void conveyors_blocks(const Room *room, const Moment *m, BlockChain *k, BlockChain *d)
{
    const Conveyors *const all = room->self;
    const ConveyorRange *const range = m->ws->room[room->number];
    for (int i = 0; i < all->n; ++i) {
        const Belt belt = belt_of(room, m, i);
        conveyor_blocks(&all->item[i], &range[i], &belt, &m->scene->chain, &m->ws->kin, m->friction, k, d);
    }
}

/* Share of machine i's grip that has cable in it, by the positions of segments along its line. */
static double cover_of(const Conveyor *c, const Chain *chain, const ConveyorRange *range)
{
    double cover = 0, slope;
    for (int k = range->first; k < range->first + range->count && k < chain->n - range->open; ++k) {
        const double x = range->x[k], h = chain->half[k];
        cover += conveyor_share(c, fmin(x + h, c->length), &slope) - conveyor_share(c, fmax(x - h, 0), &slope);
    }
    return cover;
}

/* Number of segments of rope at the chain's head, for which belts that grip cable alone stay open. */
static int open_for(const Conveyor *c, const Scene *scene)
{
    const int rope = scene->first + scene->chain.n - scene->eye;
    return c->def->grips_rope || rope < 0 ? 0 : rope < scene->chain.n ? rope : scene->chain.n;
}

/* Records the cable's position, and finds the segments again in those machines where it has moved on too far. */
static void conveyors_follow(const Room *room, const Moment *m, const double *y, int always)
{
    const Conveyors *const all = room->self;
    ConveyorRange *const range = m->ws->room[room->number];
    const Chain *const chain = &m->scene->chain;
    for (int i = 0; i < all->n; ++i) {
        Belt belt = belt_of(room, m, i);
        if (always) belt.elapsed = 0;
        conveyor_keep(&all->item[i], &belt, chain, y, m->t, &range[i]);
        range[i].open = open_for(&all->item[i], m->scene);
        if (always || conveyor_stale(&range[i], chain, y))
            conveyor_find(&all->item[i], chain, y, m->scene->contact.reach, &range[i]);
        all->filled[i].cover = cover_of(&all->item[i], chain, &range[i]);
    }
}

static int conveyors_watch(const Room *room)
{
    (void)room;
    return WATCH_PULL;
}

/* The belts close when half of their length has cable, with some hysteresis. */
static Occurrence conveyors_happen(Room *room, const Occasion *now)
{
    (void)now;
    const Conveyors *const all = room->self;
    for (int i = 0; i < all->n; ++i) {
        Filled *const f = &all->filled[i];
        const int first = f->grips<0, grips = f->cover>(f->grips > 0 ? 0.45 : 0.55);
        const int changed = !first && grips != f->grips;
        f->grips = grips;
        if (changed)
            return (Occurrence){grips ? HAWSER_EVENT_CONVEYOR_GRIPS : HAWSER_EVENT_CONVEYOR_LETS_GO, f->says[grips]};
    }
    return (Occurrence){0};
}

static double conveyors_next_stop(const Room *room, const Scene *scene, double t)
{
    (void)scene;
    const Conveyors *const all = room->self;
    double next = INFINITY;
    for (int i = 0; i < all->n; ++i) {
        if (!all->item[i].sync) next = profile_corner_before(&all->item[i].speed, t, next);
        next = profile_corner_before(&all->item[i].clamp, t, next);
        next = profile_corner_before(&all->told[i].share, t, next);
    }
    return next;
}

/* (K4) */
static int conveyors_command(Room *room, const Scene *scene, const Command *c, double t, hawser_error *err)
{
    const Conveyors *const all = room->self;
    int i = 0;
    if (c->kind == HAWSER_FRICTION || !*c->what) return 0;
    while (i < all->n && strcmp(all->item[i].def->name, c->what) != 0) ++i;
    if (i == all->n) return 0;
    Conveyor *const belt = &all->item[i];
    if (c->kind == HAWSER_CONVEYOR_SPEED) {
        const Profile now = profile_level(conveyor_belt(belt, scene->winch, t));
        belt->speed = command_ramp(&now, t, c->value, c->ramp);
        belt->sync = 0;
        return 1;
    }
    if (c->kind == HAWSER_CONVEYOR_CLAMP) {
        belt->clamp = command_ramp(&belt->clamp, t, c->value, c->ramp);
        return belt->told = 1;
    }
    const int taken = seizure_command(&all->told[i], all->seized[i], c, t, err);
    if (taken > 0) all->seized[i] = &all->told[i];
    return taken;
}

static void conveyors_controls(Room *room, ControlsVisit *visit)
{
    const Profile level = profile_level(0);
    const Conveyors *const all = room->self;
    for (int i = 0; i < all->n; ++i) {
        Conveyor *const c = &all->item[i];
        int told = all->seized[i] == &all->told[i];
        controls_bytes(visit, &c->sync, sizeof c->sync);
        controls_profile(visit, &c->speed, &c->def->speed);
        controls_profile(visit, &c->clamp, &level);
        controls_bytes(visit, &c->told, sizeof c->told);
        controls_seizure(visit, &all->told[i]);
        controls_count(visit, &told, 1);
        controls_bytes(visit, &all->filled[i], offsetof(Filled, says));
        if (told) all->seized[i] = &all->told[i];
    }
}

/* Force, slip and belt of conveyor i, for the kinematics in the workspace. */
static ConveyorNow now_of(const Room *room, const Moment *m, int i)
{
    const Conveyors *const all = room->self;
    const ConveyorRange *const range = m->ws->room[room->number];
    const Belt belt = belt_of(room, m, i);
    return conveyor_loads(&all->item[i], &range[i], &belt, &m->scene->chain, &m->ws->kin, 1, NULL);
}

static void conveyors_work(const Room *room, const Moment *m, BalanceRates *out)
{
    const Conveyors *const all = room->self;
    for (int i = 0; i < all->n; ++i) {
        const ConveyorNow now = now_of(room, m, i);
        balance_work(out, BY_CONVEYORS, (Push){now.push.power + now.lost, now.push.force});
        out->loss[LOST_BELTS] += now.lost;
    }
}

/* ------------------------------------------------------------------------------------------------------- figures */

static int conveyors_count(const Room *room) { return ((const Conveyors *)room->self)->n; }

static const char *conveyors_name(const Room *room, int i)
{
    return ((const Conveyors *)room->self)->item[i].def->name;
}

/* Force, slip, speed of the belt; whether it slips by its law, and whether more than half of its grip has cable. */
static void conveyors_keep(const Room *room, const Moment *m, int i, double value[MACHINE_KEPT_MAX])
{
    const Conveyor *const c = &((const Conveyors *)room->self)->item[i];
    const ConveyorNow now = now_of(room, m, i);
    value[0] = now.force;
    value[1] = now.slip;
    value[2] = now.belt;
    value[3] = fabs(now.slip) > c->law.v_s;
    value[4] = now.cover > 0.5;
}

static void conveyors_figures(const Room *room, int i, const TimeMean *kept, double expected,
                              double value[MACHINE_FIGURES_MAX])
{
    const Conveyor *const c = &((const Conveyors *)room->self)->item[i];
    const double figure[] = {c->def->from, c->def->to,        c->grip,           expected,          mean_of(&kept[0]),
                             kept[0].peak, mean_of(&kept[2]), mean_of(&kept[1]), mean_of(&kept[3]), mean_of(&kept[4])};
    for (size_t k = 0; k < sizeof figure / sizeof *figure; ++k) value[k] = figure[k];
}

static const MachineKind CONVEYORS = {
    .key = "conveyors",
    .count = conveyors_count,
    .name = conveyors_name,
    .n_now = 2,
    .n_kept = 5,
    .now = {
        /* conveyor: force on the cable along the pull */ "force_N",
        /* conveyor: speed of the cable less that of the belt; 0 without cable */ "slip_m_per_s",
    },
    .keep = conveyors_keep,
    .n_figures = 10,
    .figure = {
        /* place along the route */ "from_m",
        /* end of the belts */ "to_m",
        /* largest force that it can give */ "grip_N",
        /* force by the reference theory */ "reference_N",
        /* mean force of the steady window */ "steady_mean_N",
        /* largest force */ "peak_N",
        /* mean speed of the belt */ "belt_m_per_s",
        /* mean slip, cable less belt */ "slip_m_per_s",
        /* share of the window with more slip than `v_s` */ "slipping",
        /* share of the window with cable in more than half of the belts */ "gripping",
    },
    .figures = conveyors_figures};

const RoomKind CONVEYOR_ROOM = {.name = "conveyors",
                                .build = conveyors_build,
                                .seize = conveyors_seize,
                                .clear = conveyors_clear,
                                .work_alloc = conveyors_work_alloc,
                                .carry = conveyors_carry,
                                .loads = conveyors_loads,
                                .blocks = conveyors_blocks,
                                .follow = conveyors_follow,
                                .watches = conveyors_watch,
                                .happen = conveyors_happen,
                                .next_stop = conveyors_next_stop,
                                .checkpoint = conveyors_checkpoint,
                                .command = conveyors_command,
                                .controls = conveyors_controls,
                                .work = conveyors_work,
                                .machines = &CONVEYORS,
                                .in_space = "conveyors hold the cable"};
