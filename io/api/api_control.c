/* Commands and call-backs: what is checked here is what only a program can get wrong. */
#include "core/base/error.h"
#include "io/api/api_handles.h"
#include "sim/control/forces.h"
#include "sim/run/commands.h"

#include <stdio.h>
#include <string.h>

/* A ramp of 0 is the usual one. */
static double ramp_of(double ramp_s) { return ramp_s >= 0 && ramp_s <= 0 ? COMMAND_RAMP_USUAL : ramp_s; }

hawser_status hawser_sim_control(hawser_sim *s, hawser_control what_to_do, const char *what, double value,
                                 double ramp_s, hawser_error *err)
{
    const CommandKind *const kind = command_kind((int)what_to_do);
    s = SHOWN(s);
    if (!s) return error_argument(err, "s");
    if (sim_in_law(s)) return error_inside(err);
    if (!kind || kind->kind == COMMAND_FORCE)
        return error_set(err, HAWSER_ERR_INPUT, "%d is no command", (int)what_to_do);
    Command command = {.kind = kind->kind, .value = kind->unit ? value : 0, .ramp = ramp_of(ramp_s)};
    if (kind->named == 1 && !what) return error_argument(err, "what");
    if (kind->named && what) {
        if (strlen(what) >= sizeof command.what)
            return error_set(err, HAWSER_ERR_INPUT, "%s: no name is as long as '%.32s...'", kind->says, what);
        snprintf(command.what, sizeof command.what, "%s", what);
    }
    s->led = 1;
    return sim_command(s, &command, err);
}

hawser_status hawser_sim_force(hawser_sim *s, int segment, const hawser_force *force, double ramp_s, hawser_error *err)
{
    s = SHOWN(s);
    if (!s) return error_argument(err, "s");
    if (sim_in_law(s)) return error_inside(err);
    Command command = {.kind = COMMAND_FORCE, .segment = segment, .ramp = ramp_of(ramp_s)};
    if (force) {
        command.follows = force->follows != 0;
        command.force = v3(force->force_N[0], force->force_N[1], force->force_N[2]);
        command.moment = v3(force->moment_N_m[0], force->moment_N_m[1], force->moment_N_m[2]);
        command.arm = v3(force->arm_m[0], force->arm_m[1], force->arm_m[2]);
    }
    s->led = 1;
    return sim_command(s, &command, err);
}

hawser_status hawser_sim_set_law(hawser_sim *s, int from, int to, hawser_law law, int has_derivatives, void *user,
                                 hawser_error *err)
{
    s = SHOWN(s);
    if (!s) return error_argument(err, "s");
    if (sim_in_law(s)) return error_inside(err);
    const OutsideLaw outside = {.call = law, .user = user, .from = from, .to = to, .has_derivatives = has_derivatives};
    Stage *const st = &s->stage;
    hawser_status status = outside_law_set(&st->scene, &outside, err);
    if (!status && law) status = stage_to_space(st, "a law of force acts on segments", err);
    if (status) return status;
    s->led = 1;
    s->calls.law = law != NULL;
    return sim_note(s, HAWSER_EVENT_LAW, st->t, law ? "a law of force is set" : "the law of force is taken away",
                    s->look.sample.winch_force, err);
}

void hawser_sim_on_step(hawser_sim *s, hawser_step_function function, void *user)
{
    s = SHOWN(s);
    if (!s) return;
    s->led |= function != NULL;
    s->calls.step = function;
    s->calls.step_user = user;
}

void hawser_sim_on_event(hawser_sim *s, hawser_event_function function, void *user)
{
    s = SHOWN(s);
    if (!s) return;
    s->led |= function != NULL;
    s->calls.event = function;
    s->calls.event_user = user;
}

void hawser_sim_on_log(hawser_sim *s, hawser_log_level level, hawser_log_function function, void *user)
{
    s = SHOWN(s);
    if (!s) return;
    s->calls.log = function;
    s->calls.log_user = user;
    s->calls.log_level = level;
}
