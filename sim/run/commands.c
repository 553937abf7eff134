#include "sim/run/commands.h"

#include <math.h>
#include <stdio.h>

#include "core/error.h"
#include "sim/equipment/forces.h"
#include "sim/equipment/winch.h"
#include "sim/run/quasi.h"

/* ------------------------------------------------------------------------------------------------------- events */

void sim_log(const Sim *s, hawser_log_level level, const char *text)
{
    if (s->calls.log && level <= s->calls.log_level) s->calls.log(s->calls.log_user, level, text);
}

hawser_status sim_note(Sim *s, hawser_event_code code, double t, const char *what, double pull, hawser_error *err)
{
    const hawser_event event = {.t = t, .what = what, .pull_N = pull, .code = code};
    char line[512];
    const hawser_status status = events_say(&s->events, event, err);
    if (status) return status;
    const Sim *const first = s->leader ? s->leader : s;
    /* outside a run there is nothing to stop */
    if (s->calls.event && s->calls.event(s->calls.event_user, s, &event) && (first->inside || first->running))
        s->calls.stop = "by an event's call-back";
    if (!s->calls.log) return HAWSER_OK;
    snprintf(line, sizeof line, "t = %.6g s: %s", t, what);
    sim_log(s, code < HAWSER_EVENT_COMMAND ? HAWSER_LOG_WARNING : HAWSER_LOG_INFO, line);
    return HAWSER_OK;
}

hawser_status sim_call(Sim *s, hawser_error *err)
{
    Stage *const st = &s->stage;
    if (s->calls.step && s->calls.step(s->calls.step_user, s, st->t)) s->calls.stop = "by a step's call-back";
    if (s->calls.law && outside_of(&st->scene)->stopped) s->calls.stop = "by a law of force";
    outside_of(&st->scene)->bad = 0;
    if (!s->calls.stop) return HAWSER_OK;
    const char *const by = s->calls.stop;
    s->calls.stop = NULL;
    outside_of(&st->scene)->stopped = 0;
    return error_set(err, HAWSER_STOPPED, "stopped at t = %.6g s %s", st->t, by);
}

/* Number of chains, and all that move together with a chain. */
static int chains_of(Sim *s, Sim **first)
{
    *first = s->leader ? s->leader : s;
    return sim_chains(*first);
}

int sim_in_law(Sim *s)
{
    Sim *first;
    int calls = 0;
    for (int k = chains_of(s, &first); k-- > 0;) calls += outside_of(&sim_chain(first, k)->stage.scene)->calls;
    return calls > 0;
}

hawser_status sim_blame_law(Sim *s, hawser_status status, hawser_error *err)
{
    Sim *first;
    for (int k = chains_of(s, &first); k-- > 0 && (!status || status == HAWSER_ERR_RUN);) {
        Outside *const all = outside_of(&sim_chain(first, k)->stage.scene);
        if (!all->bad) continue;
        all->bad = 0;
        status = HAWSER_ERR_RUN;
        error_set(err, status,
                  "the law of force of hawser_sim_set_law gave what is no number for segment %d at t = %.6g s",
                  all->segment, all->t);
        error_moment(err, all->t, all->segment);
        break;
    }
    return status;
}

/* ----------------------------------------------------------------------------------------------------- commands */

/* "winch_speed 0.2 m/s, over 1 s" */
static void command_text(const Command *c, char *text, size_t size)
{
    const CommandKind *const kind = command_kind(c->kind);
    char of[NAME_MAX_LENGTH + 8] = "", value[48] = "";
    if (*c->what) snprintf(of, sizeof of, " of %s", c->what);
    if (c->kind == COMMAND_FORCE) snprintf(of, sizeof of, " on segment %d", c->segment);
    if (kind->unit) snprintf(value, sizeof value, " %.6g%s%s", c->value, *kind->unit ? " " : "", kind->unit);
    if (c->kind == COMMAND_FORCE) snprintf(value, sizeof value, " %.6g N", v3_norm(c->force));
    snprintf(text, size, "command: %s%s%s, over %g s", kind->says, of, value, c->ramp);
}

/* Checks whether the numbers are valid for the command. Errors: INPUT. */
static hawser_status command_check(const Sim *s, const Command *c, hawser_error *err)
{
    const CommandKind *const kind = command_kind(c->kind);
    const double all = v3_norm(c->force) + v3_norm(c->moment) + v3_norm(c->arm);
    if (!kind) return error_set(err, HAWSER_ERR_INPUT, "%d is not a command", c->kind);
    if (s->stage.scene.def.analysis.kind != ANALYSIS_DYNAMICS)
        return error_set(err, HAWSER_ERR_INPUT, "commands are for runs with 'analysis: dynamics'");
    if (!(c->ramp >= COMMAND_RAMP_LEAST && c->ramp <= COMMAND_RAMP_MOST))
        return error_set(err, HAWSER_ERR_INPUT, "a ramp of %g s: expected %g s to %g s", c->ramp, COMMAND_RAMP_LEAST,
                         COMMAND_RAMP_MOST);
    if (kind->unit && !(c->value >= kind->least && c->value <= kind->most))
        return error_set(err, HAWSER_ERR_INPUT, "%s: %g%s%s is out of range: expected %g to %g", kind->says, c->value,
                         *kind->unit ? " " : "", kind->unit, kind->least, kind->most);
    if (c->kind == COMMAND_FORCE && !(all <= 1e12))
        return error_set(err, HAWSER_ERR_INPUT, "a force, moment or arm is not finite, or too large");
    return HAWSER_OK;
}

/* Passes the command to every equipment kind that it concerns. Errors: INPUT. */
static hawser_status rooms_tell(Scene *scene, const Command *c, double t, hawser_error *err)
{
    int taken = 0;
    for (int r = 0; r < scene->n_rooms; ++r) {
        Room *const room = &scene->room[r];
        if (!room->kind->command || !(room->present || c->kind == COMMAND_FORCE)) continue;
        const int answer = room->kind->command(room, scene, c, t, err);
        if (answer < 0) return HAWSER_ERR_INPUT;
        taken |= answer;
    }
    if (taken) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT, "%s: the case has no %s%s%s", command_kind(c->kind)->says,
                     *c->what ? "such thing as '" : command_kind(c->kind)->thing, c->what, *c->what ? "'" : "");
}

/* The planar equations accept commands to a winch's speed only; others take the motion to space. */
static hawser_status motion_follow(Stage *st, const Command *c, hawser_error *err)
{
    char why[PLANE_WHY_MAX];
    const int planar = st->motion == &st->planar.motion;
    if (c->kind <= HAWSER_WINCH_RESTART) return HAWSER_OK;
    if (!planar) return st->motion->ops->renew(st->motion, st->t, st->y, err);
    snprintf(why, sizeof why, "in space from t = %.6g s on, for a command: %s", st->t, command_kind(c->kind)->says);
    return stage_to_space(st, why, err);
}

hawser_status sim_command(Sim *s, const Command *c, hawser_error *err)
{
    Stage *const st = &s->stage;
    char text[256];
    hawser_status status = command_check(s, c, err);
    if (!status) status = quasi_end(s, err);
    s->quasi.told |= !status && c->kind > HAWSER_WINCH_RESTART;
    if (!status) status = rooms_tell(&st->scene, c, st->t, err);
    if (!status) status = motion_follow(st, c, err);
    if (status) return status;
    command_text(c, text, sizeof text);
    const double pull = st->scene.winch->present ? st->motion->ops->winch_pull(st->motion, st->t, st->y) : 0;
    return sim_note(s, (hawser_event_code)(HAWSER_EVENT_COMMAND + c->kind), st->t, text, pull, err);
}

/* ------------------------------------------------------------------------------------------------------- script */

static const double ON_TIME = 1e-9; /* s: the integrator stops at a row's time up to rounding */

double script_next(const Sim *s)
{
    const SceneDef *const def = &s->stage.scene.def;
    return s->script_done < def->n_script ? def->script[s->script_done].at : INFINITY;
}

/* Segment at a place of the unstretched chain. */
static int segment_at(const Scene *scene, double place)
{
    const SceneDef *const def = &scene->def;
    double from = 0;
    int first = 0;
    for (int p = 0; p < def->n_pieces; from += def->pieces[p].length, first += def->pieces[p++].segments) {
        const double share = (place - from) / def->pieces[p].length;
        if (share < 1) return first + (int)(fmax(0, share) * def->pieces[p].segments);
    }
    return scene->total - 1;
}

hawser_status script_due(Sim *s, hawser_error *err)
{
    const Scene *const scene = &s->stage.scene;
    hawser_status status = HAWSER_OK;
    while (!status && script_next(s) <= s->stage.t + ON_TIME) {
        const ScriptDef *const row = &scene->def.script[s->script_done];
        Command command = row->command;
        hawser_error cause = {0};
        if (command.kind == COMMAND_FORCE) command.segment = segment_at(scene, row->place);
        status = sim_command(s, &command, &cause);
        if (status)
            error_set(err, status == HAWSER_ERR_INPUT ? HAWSER_ERR_RUN : status,
                      "key 'drive.script.%d': at t = %.6g s: %.800s", s->script_done, s->stage.t, cause.message);
        ++s->script_done;
    }
    return status == HAWSER_ERR_INPUT ? HAWSER_ERR_RUN : status;
}

/* --------------------------------------------------------------------------------------------------------- saved */

/* in_space: whether the motion was, or is to be, in space. */
static size_t controls_go(Sim *s, ControlsVisit *visit, int *in_space)
{
    Scene *const scene = &s->stage.scene;
    controls_count(visit, &s->script_done, scene->def.n_script);
    controls_count(visit, in_space, 1);
    for (int r = 0; r < scene->n_rooms; ++r) {
        Room *const room = &scene->room[r];
        if (room->kind->controls && room->self) room->kind->controls(room, visit);
    }
    return visit->size;
}

size_t controls_size(Sim *s)
{
    ControlsVisit visit = {0};
    int in_space = 0;
    return controls_go(s, &visit, &in_space);
}

void controls_save(Sim *s, void *to)
{
    ControlsVisit visit = {.at = to};
    int in_space = s->stage.motion != &s->stage.planar.motion;
    controls_go(s, &visit, &in_space);
}

hawser_status controls_load(Sim *s, const void *from, size_t size, hawser_error *err)
{
    ControlsVisit visit = {.at = (unsigned char *)(uintptr_t)from, .load = 1, .room = size};
    int in_space = 0;
    const size_t read = controls_go(s, &visit, &in_space);
    if (visit.wrong) return error_set(err, HAWSER_ERR_INPUT, "the state of commands is impossible");
    if (read != size)
        return error_set(err, HAWSER_ERR_INPUT, "%zu bytes of controls where the case has %zu", size, read);
    outside_attend(&s->stage.scene, in_space); /* a planar motion is loaded as such, whatever loads act on it now */
    return in_space ? stage_to_space(&s->stage, "in space since a command required it", err) : HAWSER_OK;
}
