/* Inputs: what a simulation can be told while it runs (hawser/control.h), as values that hold. An input that is where
 * it began leaves the case's own drive alone. */
#include <math.h>
#include <stdio.h>

#include "fmi/model/variables.h"
#include "io/api/api_handles.h"

static hawser_status command_add(Variables *v, hawser_control command, const char *what, double start,
                                 const char *description, const char *name, hawser_error *err)
{
    const CommandKind *const kind = command_kind((int)command);
    const Variable row = {.type = VARIABLE_REAL,
                          .role = ROLE_INPUT,
                          .unit = unit_name(kind->unit),
                          .start = start,
                          .least = kind->least,
                          .most = kind->most,
                          .to = TO_COMMAND,
                          .command = command,
                          .what = (char *)(size_t)what};
    return variable_add(v, &row, description, err, "%s", name);
}

static hawser_status switch_add(Variables *v, InputTo to, const char *what, const char *description, const char *name,
                                hawser_error *err)
{
    const Variable row = {.type = VARIABLE_BOOLEAN,
                          .role = ROLE_INPUT,
                          .least = NAN,
                          .most = NAN,
                          .to = to,
                          .what = (char *)(size_t)what};
    return variable_add(v, &row, description, err, "%s", name);
}

/* What a drive comes to by itself. */
static double profile_end(const Profile *p) { return p->kind == PROFILE_TABLE ? p->value[p->n - 1] : p->v1; }

static hawser_status winch_add(Variables *v, const WinchDef *w, hawser_error *err)
{
    const int by_speed = w->mode == WINCH_SPEED;
    hawser_status status = by_speed ? command_add(v, HAWSER_WINCH_SPEED, NULL, profile_end(&w->speed),
                                                  "speed that the winch is set to", "winch.speed", err)
                                    : command_add(v, HAWSER_WINCH_TENSION, NULL, profile_end(&w->tension),
                                                  "tension that the winch is set to", "winch.tension", err);
    if (!status)
        status =
            switch_add(v, TO_BRAKE, NULL, "the winch is braked and held; false again: it goes on", "winch.brake", err);
    if (!status)
        status = switch_add(v, TO_PAUSE, NULL,
                            by_speed ? "the winch stands; false again: it goes on"
                                     : "the winch pulls with nothing; false again: it goes on",
                            "winch.pause", err);
    return status;
}

static hawser_status conveyor_add(Variables *v, const SceneDef *def, const ConveyorDef *c, hawser_error *err)
{
    char name[VARIABLE_STEP_MAX + 32], step[VARIABLE_STEP_MAX];
    const double alone = def->winch.present && def->winch.mode == WINCH_SPEED ? profile_end(&def->winch.speed) : 0;
    snprintf(name, sizeof name, "conveyors.%s.speed", variable_step(c->name, step));
    hawser_status status = command_add(
        v, HAWSER_CONVEYOR_SPEED, c->name, c->sync ? c->factor * alone : profile_end(&c->speed),
        c->sync ? "speed of the belt; where it begins it follows the winch" : "speed of the belt", name, err);
    snprintf(name, sizeof name, "conveyors.%s.clamp", step);
    if (!status)
        status = command_add(v, HAWSER_CONVEYOR_CLAMP, c->name, c->clamp,
                             "force by which each belt is pressed on the cable", name, err);
    snprintf(name, sizeof name, "conveyors.%s.jam", step);
    return status
               ? status
               : switch_add(v, TO_JAM, c->name, "true: the conveyor has stopped; false again: it goes on", name, err);
}

hawser_status variables_add_inputs(Variables *v, const hawser_case *c, hawser_error *err)
{
    const SceneDef *const def = c->def;
    hawser_status status = HAWSER_OK;
    if (def->analysis.kind != ANALYSIS_DYNAMICS) return HAWSER_OK; /* nothing can be told there */
    if (def->winch.present) status = winch_add(v, &def->winch, err);
    for (int i = 0; i < def->n_conveyors && !status; ++i) status = conveyor_add(v, def, &def->conveyors[i], err);
    if (!status && def->reel.model == REEL_PAYOUT && def->reel.torque > 0)
        status =
            command_add(v, HAWSER_REEL_BRAKE, NULL, def->reel.torque, "torque of the reel's brake", "reel.brake", err);
    if (!status && (def->n_rollers > 0 || def->n_surfaces > 0))
        status = command_add(v, HAWSER_FRICTION, NULL, 1, "all friction, as so many times the case's",
                             "friction.factor", err);
    return status;
}
