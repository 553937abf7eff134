#include "sim/equipment/ends.h"

#include <math.h>

#include "core/state.h"
#include "sim/dynamics.h"
#include "sim/equipment/rod.h"
#include "sim/equipment/rooms.h"
#include "sim/equipment/winch.h"
#include "theory/buckling.h"

/* ------------------------------------------------------------------------------------------ the tail's tension (F2) */

TailPull tail_pull(const Scene *scene, double t, Vec3 end, double near)
{
    const double tension = profile_value(&scene->tail, t);
    if (tension == 0) return (TailPull){.along = scene->weight.direction};
    if (scene->rod->present) return (TailPull){v3_scale(-tension, scene->weight.direction), scene->weight.direction};
    RoutePoint at;
    route_foot(&scene->route, end, near, &at);
    const double way = route_way(&at, end);
    return (TailPull){v3_scale(-tension, at.tangent), at.tangent, v3_scale(-tension / way, at.curvature)};
}

/* m, jump of the tail's place, or distance off the route there, from which the tail counts as laid elsewhere */
static const double LAID = 1;

double tail_place(const Scene *scene, double t, Vec3 end, double near, int anew)
{
    if (scene->rod->present) return near;
    RoutePoint at, other;
    const double place = route_foot(&scene->route, end, near, &at);
    if (!anew || (fabs(place - near) < LAID && v3_norm(v3_sub(end, at.position)) < LAID)) return place;
    const double hauled = scene->joint_s[scene->first] + winch_travel(scene->winch, t);
    const double elsewhere = route_foot(&scene->route, end, hauled, &other);
    return v3_norm(v3_sub(end, other.position)) < v3_norm(v3_sub(end, at.position)) ? elsewhere : place;
}

/* Force on the tail with its arm to the tail's end face. */
typedef struct TailForce {
    TailPull pull;
    Vec3 arm; /* m */
} TailForce;

static TailForce tail_force(const Moment *m)
{
    const Kinematics *const kin = &m->ws->kin;
    const Vec3 arm = v3_scale(-m->scene->chain.half[0], v3_load(kin->a, 0));
    return (TailForce){tail_pull(m->scene, m->t, v3_add(v3_load(kin->p, 0), arm), m->ws->tail_at), arm};
}

/* The end of segment 0 in the state y. */
static Vec3 tail_end(const Chain *chain, const double *y)
{
    const Vec3 axis = quat_rotate(state_attitude(y, chain->n, 0), v3(1, 0, 0));
    return v3_axpy(state_vector(y, chain->n, STATE_P, 0), -chain->half[0], axis);
}

/* --------------------------------------------------------------------------------------------- the rope's drag (F3) */

void drag_place(Scene *scene)
{
    const int segment = (scene->eye < scene->total ? scene->eye : scene->total - 1) - scene->first;
    scene->drag.segment = scene->drag.force > 0 && segment >= 0 && segment < scene->chain.n ? segment : -1;
}

double drag_size(const Drag *drag, double speed, double *slope)
{
    double curve;
    const double over_speed = friction_over_speed(&drag->law, fabs(speed), &curve);
    *slope = -drag->force * (over_speed + curve * speed * speed);
    return -drag->force * over_speed * speed;
}

/* -------------------------------------------------------------------------------------------- the equipment kind */

static hawser_status ends_build(Room *room, Scene *scene, hawser_error *err)
{
    (void)err;
    const RopeDragDef *const d = &scene->def.drag;
    scene->tail = scene->def.tail.tension;
    scene->drag = (Drag){.force = d->force, .law = {.mu_s = 1, .mu_d = d->ratio, .v_s = d->v_s, .v_d = d->v_d}};
    drag_place(scene);
    room->present = 1;
    return HAWSER_OK;
}

/* A cable that friction holds back while it is pulled is held by a brake before the start; the brake is released before
 * the winch has moved so far that friction and brake both hold the cable (BK11). */
static hawser_status ends_finish(Room *room, Scene *scene, hawser_error *err)
{
    (void)room;
    const Profile *const speed = &scene->def.winch.speed;
    const double starts = speed->kind == PROFILE_STEP || speed->kind == PROFILE_STEP5 ? speed->t1 : 1;
    const hawser_status status = buckling_held_at_rest(&scene->setup, &scene->tail_held, err);
    if (scene->tail.kind == PROFILE_TABLE) scene->tail_held = NAN; /* a table gives the tension at every time */
    if (status || isnan(scene->tail_held)) return status;
    scene->tail = (Profile){.kind = PROFILE_STEP, .v0 = scene->tail_held, .t1 = starts / 4, .v1 = scene->tail.v1};
    return HAWSER_OK;
}

static void ends_loads(const Room *room, const Moment *m, int part)
{
    (void)room;
    if (part != 0) return;
    const Kinematics *const kin = &m->ws->kin;
    Loads *const loads = &m->ws->loads[0];
    const TailForce tail = tail_force(m);
    loads_add(loads, 0, tail.pull.force, v3_cross(tail.arm, tail.pull.force));
    const int i = m->scene->drag.segment;
    if (i < 0) return;
    const Vec3 a = v3_load(kin->a, i);
    double slope;
    const double size = drag_size(&m->scene->drag, v3_dot(v3_load(kin->v, i), a), &slope);
    v3_gather(loads->f, i, v3_scale(m->friction * size, a));
}

static void ends_blocks(const Room *room, const Moment *m, BlockChain *k, BlockChain *d)
{
    (void)room;
    const Kinematics *const kin = &m->ws->kin;
    const TailForce tail = tail_force(m);
    for (int c = 0; c < 3; ++c) { /* derivatives: the end moves, and the arm turns */
        const Vec3 e = v3_axis(c), swing = v3_cross(e, tail.arm);
        const Vec3 moved = v3_scale(v3_dot(tail.pull.along, e), tail.pull.turned);
        const Vec3 swung = v3_scale(v3_dot(tail.pull.along, swing), tail.pull.turned);
        block6_add(k->diag, c, moved, v3_cross(tail.arm, moved));
        block6_add(k->diag, 3 + c, swung, v3_add(v3_cross(swing, tail.pull.force), v3_cross(tail.arm, swung)));
    }
    const int i = m->scene->drag.segment;
    if (i < 0) return;
    const Vec3 a = v3_load(kin->a, i), v = v3_load(kin->v, i);
    double slope;
    const double size = drag_size(&m->scene->drag, v3_dot(v, a), &slope);
    for (int c = 0; c < 3; ++c) {
        const Vec3 e = v3_axis(c), da = v3_cross(e, a);
        block6_add(d->diag + 36 * i, c, v3_scale(m->friction * slope * v3_dot(e, a), a), V3_ZERO);
        block6_add(k->diag + 36 * i, 3 + c,
                   v3_scale(m->friction, v3_axpy(v3_scale(size, da), slope * v3_dot(v, da), a)), V3_ZERO);
    }
}

/* The tail begins at its place in the initial shape. */
static int ends_work_alloc(const Room *room, const Scene *scene, Workspace *ws)
{
    (void)room;
    ws->tail_at = scene->joint_s[scene->first];
    return 1;
}

static void ends_carry(const Room *room, Workspace *from, Workspace *to, int joined)
{
    (void)room;
    if (joined == 0) to->tail_at = from->tail_at;
}

static void ends_follow(const Room *room, const Moment *m, const double *y, int always)
{
    (void)room;
    m->ws->tail_at = tail_place(m->scene, m->t, tail_end(&m->scene->chain, y), m->ws->tail_at, always);
}

static void ends_checkpoint(Checkpoint *c, const Room *room, const Scene *scene, Workspace *ws)
{
    (void)room;
    (void)scene;
    CHECKPOINT(c, ws->tail_at);
    checkpoint_check(c, isfinite(ws->tail_at), "the tail's place is not a number");
}

static double ends_next_stop(const Room *room, const Scene *scene, double t)
{
    (void)room;
    return profile_corner_before(&scene->tail, t, INFINITY);
}

static void ends_work(const Room *room, const Moment *m, BalanceRates *out)
{
    (void)room;
    const Kinematics *const kin = &m->ws->kin;
    const TailForce tail = tail_force(m);
    const Vec3 end = v3_add(v3_load(kin->v, 0), v3_cross(v3_load(kin->w, 0), tail.arm));
    balance_work(out, BY_TAIL, (Push){v3_dot(tail.pull.force, end), tail.pull.force});
    const int i = m->scene->drag.segment;
    if (i < 0) return;
    double slope;
    const Vec3 a = v3_load(kin->a, i);
    const double speed = v3_dot(v3_load(kin->v, i), a), size = drag_size(&m->scene->drag, speed, &slope);
    out->loss[LOST_DRAG] = -size * speed;
    out->push[PUSH_DRAG] = v3_scale(size, a);
}

/* The planar equations have these loads too (sim/solve/planar.c). */
static const char *ends_not_planar(const Room *room, const Scene *scene)
{
    (void)room;
    (void)scene;
    return NULL;
}

const RoomKind ENDS_ROOM = {.name = "back tension and rope drag",
                            .build = ends_build,
                            .finish = ends_finish,
                            .work_alloc = ends_work_alloc,
                            .carry = ends_carry,
                            .loads = ends_loads,
                            .blocks = ends_blocks,
                            .follow = ends_follow,
                            .next_stop = ends_next_stop,
                            .checkpoint = ends_checkpoint,
                            .work = ends_work,
                            .not_planar = ends_not_planar};
