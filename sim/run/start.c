/* Where the chain begins: outside itself, outside of what it is pulled over, and at rest. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/state.h"
#include "sim/equipment/rod.h"
#include "sim/judge/trust.h"
#include "sim/run/commands.h"
#include "sim/run/sim.h"
#include "sim/run/together.h"
#include "sim/stage/statics.h"

static const double GRADE_LOST = M_PI / 180; /* rad, in one bend, that nobody should be surprised by */

/* Where lines meet no contact can tell on which side of each other they are. */
hawser_status start_check(Sim *s, hawser_error *err)
{
    const Scene *const scene = &s->stage.scene;
    if (!scene->self.present) return HAWSER_OK;
    const SelfDetail deepest =
        self_deepest(&scene->self, SELF_ALONE(&scene->chain, &s->stage.ws.kin), &s->stage.ws.self);
    const double radius = scene->chain.radius[deepest.element < scene->chain.n ? deepest.element : scene->chain.n - 1];
    if (!(deepest.depth > radius / 4)) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT,
                     "contact.cable_on_cable: the cable begins %.1f mm inside itself near (%.3f, %.3f, %.3f) m, at "
                     "segments %d and %d: lead the route past itself with a cable's diameter between",
                     1e3 * deepest.depth, deepest.point.x, deepest.point.y, deepest.point.z, deepest.element,
                     deepest.foot);
}

hawser_status start_grades(Sim *s, hawser_error *err)
{
    const Route *const route = &s->stage.scene.route;
    double before, after;
    const int bend = route_grade_lost(route, GRADE_LOST, &before, &after);
    if (bend < 0 || s->stage.scene.def.rod.present) return HAWSER_OK;
    snprintf(s->grade_says, sizeof s->grade_says,
             "bend '%s' turns to the side on a grade of %.1f deg and leaves it at %.1f deg: it lies in one plane",
             route->piece[bend].name, before * 180 / M_PI, after * 180 / M_PI);
    return sim_note(s, HAWSER_EVENT_NOTE, 0, s->grade_says, s->look.sample.winch_force, err);
}

hawser_status start_held(Sim *s, hawser_error *err)
{
    const Scene *const scene = &s->stage.scene;
    if (isnan(scene->tail_held)) return HAWSER_OK;
    snprintf(
        s->held_says, sizeof s->held_says,
        "friction holds the cable where it hangs: before the start a brake holds its tail with %.4g kN, and is let "
        "go until %.3g s",
        scene->tail_held / 1e3, scene->tail.t1);
    return sim_note(s, HAWSER_EVENT_NOTE, 0, s->held_says, s->look.sample.winch_force, err);
}

/* Whether nothing is pressed by more than all loads together could ask for, by a look at the state of now. */
static int fits(void *user)
{
    Sim *const s = user;
    Stage *const st = &s->stage;
    const int active = st->motion->ops->look(st->motion, st->t, st->y, 0);
    passing_start(&s->passing, &st->scene, &st->ws.kin,
                  sample_take(&s->look, &st->scene, &st->ws, st->t, active, SAMPLE_ROW));
    return s->passing.start.force <= s->passing.start.allowed;
}

/* Relaxation (E7): of a chain in space without its weight, so that what is to fall does not fall yet, and no farther
 * than until it fits. What does not come to fit begins where it was. */
static hawser_status move_out(Sim *s, const double *laid, hawser_error *err)
{
    Stage *const st = &s->stage;
    hawser_relaxation moved;
    hawser_error ended;
    const Weight weight = st->scene.weight;
    st->scene.weight.gravity = st->scene.weight.behind = V3_ZERO;
    st->ws.stop = (StopCheck){.ask = fits, .user = s, .firm = 1};
    const hawser_status status = st->motion->ops->relax(st->motion, st->t, st->y, &moved, &ended);
    st->ws.stop = (StopCheck){0};
    st->scene.weight = weight;
    if (status && status != HAWSER_STOPPED) {
        *err = ended;
        return status;
    }
    if (fits(s)) return sim_note(s, HAWSER_EVENT_NOTE, st->t, START_MOVED_SAYS, s->look.sample.winch_force, err);
    memcpy(st->y, laid, (size_t)st->motion->size * sizeof *laid);
    return st->motion->ops->renew(st->motion, st->t, st->y, err);
}

hawser_status start_fit(Sim *s, hawser_error *err)
{
    Stage *const st = &s->stage;
    const SceneDef *const def = &st->scene.def;
    if (def->solver.relax || def->rod.present || fits(s)) return HAWSER_OK;
    const size_t bytes = (size_t)st->motion->size * sizeof(double);
    double *const laid = malloc(bytes);
    if (!laid) return error_memory(err);
    memcpy(laid, st->y, bytes);
    const hawser_status status = move_out(s, laid, err);
    free(laid);
    return status;
}

/* Relaxation begins at rest; the motion that the case begins with comes after it. */
static void chain_stop(Stage *st)
{
    const size_t n = (size_t)st->scene.chain.n;
    if (st->scene.def.launch.present) memset(st->y + STATE_V * n, 0, (STATE_SIZE - STATE_V) * n * sizeof *st->y);
}

hawser_status sim_relax(Sim *s, hawser_relaxation *out, hawser_error *err)
{
    const double start = clock_now();
    const Scene *const scene = &s->stage.scene;
    hawser_status status;
    if (s->stage.torn) return error_memory(err);
    for (int k = 0; k < sim_chains(s); ++k) {
        Sim *const each = sim_chain(s, k);
        Stage *const st = &each->stage;
        chain_stop(st);
        st->motion->ops->look(st->motion, st->t, st->y, 0);
        passing_look(&each->passing, &st->scene, &st->ws, 0, st->t); /* what is there to be kept */
    }
    if (s->together) {
        status = together_relax(s->together, &s->relaxation, err);
    } else if (scene->rod->present) {
        const double share = scene->def.analysis.kind == ANALYSIS_DYNAMICS ? scene->def.solver.relax_tolerance
                                                                           : scene->def.analysis.tolerance;
        s->relaxation = (hawser_relaxation){0};
        status = statics_settle(&s->stage, share, &s->relaxation, err);
    } else if (scene->def.analysis.kind == ANALYSIS_POSITIONS) {
        status = s->positions.done > 0 ? HAWSER_OK : sim_advance(s, s->positions.time[0], 1, err);
    } else {
        status = s->stage.motion->ops->relax(s->stage.motion, s->stage.t, s->stage.y, &s->relaxation, err);
    }
    for (int k = 0; k < sim_chains(s); ++k) {
        Sim *const each = sim_chain(s, k);
        each->relaxation = s->relaxation;
        if (!status && each->stage.t <= 0) scene_launch(&each->stage.scene, each->stage.y);
    }
    s->relax_s += clock_now() - start;
    if (out) *out = s->relaxation;
    return status;
}

/* Half a roller's width over what the cable may lie off its middle. */
static const double WIDER = 1 / TRUST_EDGE;

static hawser_status off_roller(const Edge *e, hawser_error *err)
{
    char at[32] = "";
    if (!isnan(e->at)) snprintf(at, sizeof at, " at %.4g m", e->at);
    return error_set(
        err, HAWSER_ERR_RUN,
        "at rest the cable lies %.0f mm beside the middle of roller '%s'%s, which is %.0f mm wide: it is off it "
        "before anything moves. Rollers of about %.0f mm or wider would hold it there, or guides beside it "
        "('guide: both'); 'run.keep_going: true' goes on all the same",
        1e3 * e->across, e->name, at, 2e3 * e->half, 10 * ceil(1e2 * 2 * e->across * WIDER));
}

hawser_status place_check(Sim *s, hawser_error *err)
{
    for (int k = 0; k < sim_chains(s); ++k) {
        const Sim *const each = sim_chain(s, k);
        const SceneDef *const def = &each->stage.scene.def;
        const Stray *const stray = &each->stray;
        const int pulled = def->winch.present || def->n_conveyors > 0;
        if (def->keep_going || def->rod.present || !pulled || def->analysis.kind != ANALYSIS_DYNAMICS) continue;
        if (def->solver.relax && each->passing.edge.share > 1 && !(each->stage.t > 0))
            return off_roller(&each->passing.edge, err);
        if (!(stray->farthest > SUPPORT_OFF_ROUTE)) continue;
        char when[48] = "before anything moves";
        if (each->stage.t > 0) snprintf(when, sizeof when, "at %.4g s", each->stage.t);
        return error_set(
            err, HAWSER_ERR_RUN,
            "%s the cable is %.3g m off its route near %.4g m: it has come off what carries it, or nothing "
            "guides it there: put guides or wider rollers there and ahead of it; 'run.keep_going: true' goes "
            "on all the same",
            when, stray->farthest, stray->at);
    }
    return HAWSER_OK;
}
