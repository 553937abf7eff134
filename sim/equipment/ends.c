#include "sim/equipment/ends.h"

#include <math.h>

#include "sim/dynamics.h"
#include "sim/equipment/rooms.h"

/* ------------------------------------------------------------------------------------------ the tail's tension (F2) */

/* A dead force at the tail's end face: -T along the route's first tangent, and its arm. */
typedef struct TailForce {
    Vec3 force, arm; /* N; m */
} TailForce;

static TailForce tail_force(const Moment *m)
{
    const Scene *const scene = m->scene;
    return (TailForce){v3_scale(-profile_value(&scene->tail, m->t), scene->weight.direction),
                       v3_scale(-scene->chain.half[0], v3_load(m->ws->kin.a, 0))};
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

/* ------------------------------------------------------------------------------------------------------- the room */

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

static void ends_loads(const Room *room, const Moment *m, int part)
{
    (void)room;
    if (part != 0) return;
    const Kinematics *const kin = &m->ws->kin;
    Loads *const loads = &m->ws->loads[0];
    const TailForce tail = tail_force(m);
    loads_add(loads, 0, tail.force, v3_cross(tail.arm, tail.force));
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
    for (int c = 0; c < 3; ++c) /* the arm turns */
        block6_add(k->diag, 3 + c, V3_ZERO, v3_cross(v3_cross(v3_axis(c), tail.arm), tail.force));
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
    balance_work(out, BY_TAIL, (Push){v3_dot(tail.force, end), tail.force});
    const int i = m->scene->drag.segment;
    if (i < 0) return;
    double slope;
    const Vec3 a = v3_load(kin->a, i);
    const double speed = v3_dot(v3_load(kin->v, i), a), size = drag_size(&m->scene->drag, speed, &slope);
    out->loss[LOST_DRAG] = -size * speed;
    out->push[PUSH_DRAG] = v3_scale(size, a);
}

/* The plane has these loads too (sim/planar/planar_scene.c). */
static const char *ends_not_planar(const Room *room, const Scene *scene)
{
    (void)room;
    (void)scene;
    return NULL;
}

const RoomKind ENDS_ROOM = {.name = "back tension and rope drag",
                            .build = ends_build,
                            .loads = ends_loads,
                            .blocks = ends_blocks,
                            .next_stop = ends_next_stop,
                            .work = ends_work,
                            .not_planar = ends_not_planar};
