/* The scenes of bench/scale_steps.c, of any length: a straight pull in the middle of its way, and a chain that swings.
 */
#ifndef HAWSER_BENCH_SCALE_SCENES_H
#define HAWSER_BENCH_SCALE_SCENES_H

#include "bench/straight_scene.h"
#include "sim/run/stage.h"

/* A chain pinned at two points of the same height, 2 % longer than their distance, released from a circular arc below
 * them: N segments of half a metre of the straight pull's cable. Returns 0 without memory (then *def is cleared). */
static inline int hanging_scene(SceneDef *def, int segments)
{
    const double length = 0.5 * segments, half_angle = 0.3439; /* a / sin a = 1.02 */
    scene_def_defaults(def);
    def->cables = malloc(sizeof *def->cables);
    def->pieces = malloc(sizeof *def->pieces);
    def->route = calloc(1, sizeof *def->route);
    if (!def->cables || !def->pieces || !def->route) {
        scene_def_clear(def);
        return 0;
    }
    def->n_cables = def->n_pieces = def->n_route = 1;
    def->cables[0] = straight_cable();
    def->pieces[0] = (ChainPieceDef){.length = length, .segments = segments};
    def->route[0] = (RoutePieceDef){.kind = ROUTE_STRAIGHT, .length = length};
    def->route_slope = -half_angle;
    def->head_at = length;
    def->rod = (RodDef){
        .present = 1, .shape = ROD_ARC, .radius = length / (2 * half_angle), .plane = M_PI / 2, .stress_free = 0};
    for (int end = 0; end < 2; ++end) {
        for (int c = 0; c < 3; ++c) def->rod.end[end].held[c] = 1;
        def->rod.end[end].pivot = 1;
    }
    def->duration = 1e6;
    return 1;
}

/* How much longer the straight pull's cable becomes when all of it slides (m): the tension grows evenly from the tail.
 */
static inline double pull_stretch(int segments)
{
    const CableDef cable = straight_cable();
    const double length = 0.5 * segments;
    return 0.2 * 9.81 * cable.mass * length * length / (2 * cable.ea);
}

/* The straight pull with room for that behind the tail; rollers < 0: every 2 m; 0: none, and a cable without weight. */
static inline int pull_scene(SceneDef *def, int segments, int rollers)
{
    const double tail = 2.5 + 2 * ceil(pull_stretch(segments) / 2), row = 0.5 * segments + tail + 6.5;
    const int count = rollers < 0 ? (int)floor(row / 2 + 1e-9) + 1 : rollers > 0 ? rollers : 1;
    if (!straight_row(def, segments, count, rollers < 0 || count == 1 ? 2 : row / (count - 1), tail)) return 0;
    def->winch.axial_only = 0; /* as a rope that runs on in the air holds it */
    if (rollers == 0) {
        def->gravity = v3(0, 0, 0);
        def->n_rollers = 0;
    }
    return 1;
}

/* Puts the straight pull where it will be at time t (s) of constant speed, all of it sliding: every joint carries the
 * friction of what is behind it, and is stretched by that. The heights are those of equilibrium at rest. */
static inline int pull_begin(Stage *stage, double t)
{
    const Scene *const scene = &stage->scene;
    const Chain *const chain = &scene->chain;
    const int n = chain->n;
    const Profile *const speed = &scene->def.winch.speed;
    double *const y = malloc((size_t)scene_state_size(scene) * sizeof *y);
    if (!y) return 0;
    stage->motion->ops->unpack(stage->motion, stage->y, y);
    double moved = profile_integral(speed, t), tension = 0;
    for (int i = 0; i < n; ++i) tension += scene->def.friction.mu_d * chain->mass[i] * v3_norm(scene->def.gravity);
    for (int i = n - 1; i >= 0; --i) { /* the winch's joint is n */
        moved -= tension / chain->stiffness[0][i + 1];
        y[i] += moved;
        y[STATE_V * n + i] = profile_value(speed, t);
        tension -= scene->def.friction.mu_d * chain->mass[i] * v3_norm(scene->def.gravity);
    }
    stage->motion->ops->pack(stage->motion, y, stage->y);
    stage->t = t;
    free(y);
    return 1;
}

#endif
