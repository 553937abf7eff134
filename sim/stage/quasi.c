#include "sim/stage/quasi.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "core/base/lanes.h"
#include "sim/equipment/reel.h"
#include "sim/equipment/winch.h"

static const double SAME_SPEED = 1e-6; /* share of the largest by which a constant speed may differ from itself */

static const Chain *all_joints(const Stage *st) { return st->whole.n > 0 ? &st->whole : &st->scene.chain; }

/* In words, or NULL. */
static const char *obstacle(const Stage *st)
{
    const SceneDef *const def = &st->scene.def;
    if (def->n_beside > 0 || def->strand.present) return "several chains are moved together";
    if (def->analysis.kind != ANALYSIS_DYNAMICS) return "there is no motion";
    if (st->motion != &st->spatial.motion) return "in a plane steps cost less than positions in space";
    if (winch_travel(st->scene.winch, def->duration) >= positions_held_from(&st->scene))
        return "the cable's end is fastened to the reel and holds it before the run ends: 'reel.end: free', or a "
               "shorter 'run.duration'";
    return positions_unknown(st);
}

hawser_status quasi_new(Quasi *q, Positions *p, const Stage *st, hawser_error *err)
{
    const Scene *const scene = &st->scene;
    const MotionChoice wanted = scene->def.solver.motion;
    *q = (Quasi){.why = "solver.motion is dynamic"};
    if (wanted == MOTION_DYNAMIC) return HAWSER_OK;
    q->why = obstacle(st);
    if (q->why && wanted == MOTION_QUASI_STATIC)
        return error_set(err, HAWSER_ERR_INPUT, "key 'solver.motion': quasi-static: %s", q->why);
    if (q->why) return HAWSER_OK;
    const Chain *const chain = all_joints(st);
    const size_t joints = (size_t)chain->n + 1;
    q->damping = malloc(6 * joints * sizeof *q->damping);
    if (!q->damping) return error_memory(err);
    for (size_t c = 0; c < 6; ++c) memcpy(q->damping + c * joints, chain->damping[c], joints * sizeof *q->damping);
    positions_of(p, st);
    return HAWSER_OK;
}

void quasi_free(Quasi *q)
{
    free(q->damping);
    q->damping = NULL;
}

double quasi_steady_until(const Scene *scene, double t, double end)
{
    const WinchPhase *const now = &scene->winch->phase;
    const double speed = winch_speed(scene->winch, t), most = SAME_SPEED * scene->largest_speed;
    if (!(speed > 0) || isfinite(now->until)) return t;
    for (double from = t; from < end;) {
        const double next = fmin(end, now->since + profile_corner_before(&now->speed, from - now->since, INFINITY));
        const double inside[2] = {from + (next - from) / 3, from + (next - from) / 2};
        for (int k = 0; k < 2; ++k)
            if (!(fabs(winch_speed(scene->winch, inside[k]) - speed) <= most)) return from;
        if (!(next > from)) return from;
        from = next;
    }
    return end;
}

void quasi_damping(const Quasi *q, Stage *st, int present)
{
    const size_t joints = (size_t)all_joints(st)->n + 1;
    Scene *const scene = &st->scene;
    for (size_t c = 0; c < 6; ++c) {
        const double *const built = q->damping + c * joints;
        const int first = st->whole.n > 0 ? scene->first : 0;
        for (int j = 0; j <= scene->chain.n; ++j) {
            const int cut = first > 0 && j == 0; /* as window_chain has it */
            scene->chain.damping[c][j] = present && !cut ? built[first + j] : 0;
        }
        for (int j = 0; j <= st->whole.n && st->whole.n > 0; ++j) st->whole.damping[c][j] = present ? built[j] : 0;
    }
}

hawser_status moving_keep(Moving *m, const Stage *st, hawser_error *err)
{
    const size_t bytes = (size_t)st->motion->size * sizeof *m->y;
    const Winch *const w = st->scene.winch;
    *m = (Moving){.first = st->scene.first,
                  .n = st->scene.chain.n,
                  .reel = st->scene.reel->present,
                  .t = st->t,
                  .y = malloc(bytes),
                  .origin = w->origin,
                  .attitude = w->attitude,
                  .take_in = w->take_in};
    if (!m->y) return error_memory(err);
    memcpy(m->y, st->y, bytes);
    return HAWSER_OK;
}

void moving_free(Moving *m)
{
    free(m->y);
    m->y = NULL;
}

hawser_status quasi_enter(Quasi *q, Positions *p, Stage *st, Moving *from, hawser_error *err)
{
    hawser_status status = moving_keep(from, st, err);
    if (!status) status = positions_begin(p, st, err);
    if (status) return status;
    if (st->integrator) integrator_stats(st->integrator, &q->so_far);
    if (st->balance) balance_leave(st->balance, st->motion, st->t, st->y);
    st->integrator = integrator_free(st->integrator);
    q->on = 1;
    quasi_damping(q, st, 0);
    return HAWSER_OK;
}

hawser_status quasi_leave(Quasi *q, Stage *st, hawser_error *err)
{
    q->on = 0;
    quasi_damping(q, st, 1);
    hawser_status status = st->motion->ops->renew(st->motion, st->t, st->y, err);
    if (!status) status = integrator_new(st->motion, st->t, st->y, &st->integrator, err);
    if (status) return status;
    integrator_go_on(st->integrator, &q->so_far);
    return st->balance ? balance_enter(st->balance, st->motion, st->t, st->y, err) : HAWSER_OK;
}

hawser_status moving_restore(Stage *st, const Moving *to, hawser_error *err)
{
    Scene *const scene = &st->scene;
    hawser_status status = HAWSER_OK;
    scene->reel->present = to->reel;
    if (to->first != scene->first || to->n != scene->chain.n) status = stage_window(st, to->first, to->n, err);
    if (status) return status;
    memcpy(st->y, to->y, (size_t)st->motion->size * sizeof *st->y);
    st->t = to->t;
    scene->winch->origin = to->origin;
    scene->winch->attitude = to->attitude;
    scene->winch->take_in = to->take_in;
    return st->motion->ops->renew(st->motion, st->t, st->y, err);
}

hawser_status quasi_undo(Quasi *q, Stage *st, const Moving *to, hawser_error *err)
{
    const hawser_status status = moving_restore(st, to, err);
    return status ? status : quasi_leave(q, st, err);
}
