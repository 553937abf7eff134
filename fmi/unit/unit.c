#include "fmi/unit/unit.h"

#include <assert.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sim/run/sim.h"

Outcome unit_say(Unit *u, Outcome outcome, const char *format, ...)
{
    static const char *const categories[] = {"logEvents", "logStatusWarning", "logStatusWarning", "logStatusError",
                                             "logStatusError"};
    char text[HAWSER_MESSAGE_MAX + 128];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    if (outcome == FAILED) u->phase = PHASE_FAILED;
    if (u->say && (outcome != GOES_WELL || u->logging)) u->say(u->host, outcome, categories[outcome], text);
    return outcome;
}

Unit *unit_in(const void *instance, unsigned phases, const char *call)
{
    Unit *const u = instance ? ((const Instance *)instance)->unit : NULL;
    if (!u || u->phase & phases) return u;
    const char *const now = u->phase == PHASE_INSTANTIATED   ? "not initialized yet"
                            : u->phase == PHASE_INITIALIZING ? "being initialized"
                            : u->phase == PHASE_STEPPING     ? "being stepped"
                            : u->phase == PHASE_OVER         ? "terminated"
                                                             : "at an error: reset or free it";
    unit_say(u, FAILED, "%s cannot be called now: the instance is %s", call, now);
    return NULL;
}

Outcome unit_denied(const void *instance, const char *call)
{
    Unit *const u = instance ? ((const Instance *)instance)->unit : NULL;
    return u ? unit_say(u, FAILED, "%s is not provided: the unit is for co-simulation without events and clocks", call)
             : FAILED;
}

Outcome outcome_worse(Outcome a, Outcome b) { return b > a ? b : a; }

/* ---------------------------------------------------------------------------------------------------- beginning */

/* Values as the description has them. */
static void values_begin(Unit *u)
{
    for (int i = 0; i < u->model.variables.n; ++i)
        u->value[i] = u->told[i] = u->built[i] = u->model.variables.row[i].start;
}

static void sim_drop(Unit *u)
{
    hawser_sim_free(u->sim);
    u->sim = NULL;
    u->relaxed = 0;
    u->rows = 0;
    u->look = (Look){0};
}

Unit *unit_new(const char *folder, const char *token, int logging, Say say, void *host)
{
    hawser_error err = {HAWSER_OK, ""};
    Unit *const u = calloc(1, sizeof *u);
    if (!u) return NULL;
    u->logging = logging;
    u->say = say;
    u->host = host;
    if (model_load(folder, &u->model, &u->sim, &err)) {
        unit_say(u, FAILED, "%s", err.message);
        return unit_free(u);
    }
    if (!token || strcmp(token, u->model.token) != 0) {
        unit_say(u, FAILED, "the token is not that of the archive's case: %s was given, %s is", token ? token : "none",
                 u->model.token);
        return unit_free(u);
    }
    const size_t n = (size_t)u->model.variables.n;
    u->value = calloc(3 * n, sizeof *u->value);
    if (!u->value) {
        unit_say(u, FAILED, "out of memory");
        return unit_free(u);
    }
    u->told = u->value + n;
    u->built = u->told + n;
    values_begin(u);
    u->phase = PHASE_INSTANTIATED;
    u->stop = INFINITY;
    u->ends = u->model.duration;
    return u;
}

Unit *unit_free(Unit *u)
{
    if (!u) return NULL;
    hawser_sim_free(u->sim);
    model_clear(&u->model);
    free(u->value);
    free(u);
    return NULL;
}

/* Whether a parameter has another value than the simulation was built with. */
static int is_stale(const Unit *u)
{
    for (int i = 0; i < u->model.variables.n; ++i) {
        const int differs = u->value[i] < u->built[i] || u->value[i] > u->built[i];
        if (u->model.variables.row[i].role == ROLE_PARAMETER && differs) return 1;
    }
    return 0;
}

/* The simulation that is there serves as long as it has the parameters, and stands at the start if it is to be fresh.
 */
Outcome unit_rebuild(Unit *u, int fresh)
{
    hawser_error err = {HAWSER_OK, ""};
    if (u->sim && !is_stale(u) && !(fresh && u->relaxed)) return GOES_WELL;
    sim_drop(u);
    if (model_build(&u->model, u->value, &u->sim, &err)) return unit_say(u, FAILED, "%s", err.message);
    memcpy(u->built, u->value, (size_t)u->model.variables.n * sizeof *u->built);
    u->ends = hawser_sim_end_time(u->sim);
    return GOES_WELL;
}

/* The same at equilibrium, if the case wants that, and in the statistics. */
static Outcome sim_ready(Unit *u)
{
    hawser_error err = {HAWSER_OK, ""};
    const Outcome outcome = unit_rebuild(u, 0);
    if (outcome || u->relaxed) return outcome;
    assert(u->sim);
    if (u->sim->stage.scene.def.solver.relax && hawser_sim_relax(u->sim, NULL, &err))
        return unit_say(u, FAILED, "%s", err.message);
    u->relaxed = 1;
    sim_record_row(u->sim);
    u->rows = 1;
    u->look.fresh = u->look.judged = 0;
    return GOES_WELL;
}

/* ------------------------------------------------------------------------------------------------------- phases */

double unit_time(const Unit *u) { return u->start + (u->sim ? hawser_sim_time(u->sim) : 0); }

Outcome unit_set_times(Unit *u, double start, int has_stop, double stop)
{
    if (!isfinite(start) || (has_stop && !(stop > start)))
        return unit_say(u, FAILED, "times from %g s to %g s: a finite start is needed, and a later stop", start, stop);
    u->start = start;
    u->stop = has_stop ? stop : INFINITY;
    return GOES_WELL;
}

Outcome unit_begin(Unit *u)
{
    u->phase = PHASE_INITIALIZING;
    return GOES_WELL;
}

Outcome unit_settle(Unit *u)
{
    const Outcome outcome = sim_ready(u);
    if (!outcome) u->phase = PHASE_STEPPING;
    return outcome;
}

Outcome unit_end(Unit *u)
{
    u->phase = PHASE_OVER;
    return GOES_WELL;
}

Outcome unit_reset(Unit *u)
{
    sim_drop(u);
    values_begin(u);
    u->phase = PHASE_INSTANTIATED;
    u->start = 0;
    u->stop = INFINITY;
    return GOES_WELL;
}

/* -------------------------------------------------------------------------------------------------------- steps */

/* One input that has another value than the simulation was told last. What cannot be done is said; the step goes on. */
static Outcome input_tell(Unit *u, int i, double ramp)
{
    const Variable *const row = &u->model.variables.row[i];
    const int on = u->value[i] > 0.5;
    hawser_control command = row->command;
    hawser_error err = {HAWSER_OK, ""};
    if (row->to == TO_BRAKE) command = on ? HAWSER_WINCH_BRAKE : HAWSER_WINCH_RESTART;
    if (row->to == TO_PAUSE) command = on ? HAWSER_WINCH_PAUSE : HAWSER_WINCH_RESTART;
    if (row->to == TO_JAM) command = on ? HAWSER_JAM : HAWSER_RELEASE;
    u->told[i] = u->value[i];
    u->look.fresh = u->look.judged = 0;
    if (!hawser_sim_control(u->sim, command, row->what, u->value[i], ramp, &err)) return GOES_WELL;
    return unit_say(u, GOES_WITH_A_WORD, "%s: %s", row->name, err.message);
}

static Outcome inputs_tell(Unit *u)
{
    const Variables *const v = &u->model.variables;
    double ramp = COMMAND_RAMP_USUAL;
    Outcome worst = GOES_WELL;
    for (int i = 0; i < v->n; ++i) {
        if (v->row[i].role == ROLE_TUNABLE) ramp = u->value[i];
    }
    for (int i = 0; i < v->n; ++i) {
        const int differs = u->value[i] < u->told[i] || u->value[i] > u->told[i];
        if (v->row[i].role == ROLE_INPUT && differs && input_tell(u, i, ramp)) worst = GOES_WITH_A_WORD;
    }
    return worst;
}

/* Samples of the statistics are due at whole multiples of the case's interval, and belong to the first step that ends
 * there or later, as in hawser_sim_run. */
static void row_record(Unit *u)
{
    const double t = hawser_sim_time(u->sim), interval = u->model.interval, next = interval * (double)u->rows;
    if (!(interval > 0) || t < next - 1e-9 * fmax(1, next)) return;
    u->rows = (long)floor(t / interval + 1e-9) + 1;
    sim_record_row(u->sim);
}

Outcome unit_step(Unit *u, double now, double step, int *over)
{
    const double at = unit_time(u), next = now + step, slack = 1e-9 * fmax(1, fabs(next));
    hawser_error err = {HAWSER_OK, ""};
    hawser_status status = HAWSER_OK;
    *over = 0;
    if (!(step > 0) || !isfinite(next)) return unit_say(u, FAILED, "a step of %g s", step);
    if (!(fabs(now - at) <= slack))
        return unit_say(u, FAILED, "a step from t = %.17g s, but the instance is at t = %.17g s", now, at);
    if (next > u->stop + slack)
        return unit_say(u, FAILED, "a step to t = %.17g s, beyond the stop at %.17g s", next, u->stop);
    const Outcome outcome = inputs_tell(u);
    u->look.fresh = u->look.judged = 0;
    while (!status && hawser_sim_time(u->sim) < next - u->start) {
        const double end = hawser_sim_end_time(u->sim); /* before the case's own: the winch has ended the run */
        if (end < u->ends && hawser_sim_time(u->sim) >= end) break;
        status = hawser_sim_advance(u->sim, next - u->start, 1, &err);
        if (!status) row_record(u);
    }
    if (status) return unit_say(u, FAILED, "%s", err.message);
    *over = hawser_sim_time(u->sim) < next - u->start;
    return outcome;
}

/* ------------------------------------------------------------------------------------------------------- values */

static const Variable *variable_of(Unit *u, size_t reference, VariableType type)
{
    if (reference >= (size_t)u->model.variables.n) {
        unit_say(u, FAILED, "there is no variable with the reference %zu", reference);
        return NULL;
    }
    const Variable *const row = &u->model.variables.row[reference];
    if (row->type == type) return row;
    unit_say(u, FAILED, "'%s' is of another type than was asked for", row->name);
    return NULL;
}

Outcome unit_get(Unit *u, size_t reference, VariableType type, double *value, const char **text)
{
    const Variable *const row = variable_of(u, reference, type);
    if (!row) return FAILED;
    if (row->role == ROLE_TIME) *value = unit_time(u);
    if (row->role == ROLE_TIME) return GOES_WELL;
    if (row->role != ROLE_OUTPUT) *value = u->value[reference];
    if (row->role != ROLE_OUTPUT) return GOES_WELL;
    const Outcome outcome = u->phase == PHASE_INSTANTIATED
                                ? unit_say(u, FAILED, "'%s' has no value before the initialization", row->name)
                                : sim_ready(u);
    if (outcome) return outcome;
    if (type == VARIABLE_TEXT) {
        *text = output_text(u, row);
    } else {
        *value = output_number(u, row);
    }
    return GOES_WELL;
}

int unit_can_be(const Variable *row, double value)
{
    if (!(value < row->start || value > row->start)) return isfinite(value);
    return isfinite(value) && !(value < row->least || value > row->most);
}

/* A value that cannot be is refused, and what was set before stays. */
Outcome unit_set(Unit *u, size_t reference, VariableType type, double value)
{
    const Variable *const row = variable_of(u, reference, type);
    if (!row) return FAILED;
    const int early = u->phase == PHASE_INSTANTIATED || u->phase == PHASE_INITIALIZING;
    if (row->role == ROLE_TIME || row->role == ROLE_OUTPUT) return unit_say(u, FAILED, "'%s' cannot be set", row->name);
    if (row->role == ROLE_PARAMETER && !early)
        return unit_say(u, FAILED, "'%s' is fixed after the initialization", row->name);
    if (!unit_can_be(row, value))
        return unit_say(u, REFUSED, "'%s' cannot be %g: expected %g to %g", row->name, value, row->least, row->most);
    u->value[reference] = value;
    return GOES_WELL;
}
