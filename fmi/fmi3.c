/* Version 3.0 of the interface: each call checks the standard's requirements and passes on to the unit. */
#include "fmi/fmi3.h"

#include <stdlib.h>
#include <string.h>

#include "fmi/unit.h"

/* Instance in an importer. */
typedef struct Instance3 {
    Unit *unit; /* first, as in every Instance */
    fmi3LogMessageCallback log;
    fmi3InstanceEnvironment environment;
} Instance3;

static void say3(void *host, Outcome outcome, const char *category, const char *text)
{
    const Instance3 *const c = host;
    if (c->log) c->log(c->environment, (fmi3Status)outcome, category, text);
}

const char *fmi3GetVersion(void) { return "3.0"; }

fmi3Status fmi3SetDebugLogging(fmi3Instance c, fmi3Boolean on, size_t n, const fmi3String category[])
{
    Unit *const u = unit_in(c, PHASES_ALL, "fmi3SetDebugLogging");
    (void)n, (void)category;
    if (!u) return fmi3Error;
    u->logging = on;
    return fmi3OK;
}

/* Rejects events, early returns and intermediate values, which the description excludes. */
fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                         fmi3Boolean logging, fmi3Boolean event_mode, fmi3Boolean early_return,
                                         const fmi3ValueReference intermediate[], size_t n_intermediate,
                                         fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                                         fmi3IntermediateUpdateCallback update)
{
    (void)visible, (void)early_return, (void)intermediate, (void)update;
    Instance3 *const c = calloc(1, sizeof *c);
    if (!c) return NULL;
    c->log = log;
    c->environment = environment;
    char *const folder = address_folder(resources);
    const char *const wrong = !name || !*name      ? "an instance needs a name"
                              : !folder            ? "the path of the resources is not that of a folder"
                              : event_mode         ? "there is no event mode"
                              : n_intermediate > 0 ? "there are no intermediate values"
                                                   : NULL;
    if (wrong) say3(c, FAILED, "logStatusError", wrong);
    if (!wrong) c->unit = unit_new(folder, token, logging, say3, c);
    free(folder);
    if (c->unit) return c;
    free(c);
    return NULL;
}

fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                          fmi3Boolean logging, fmi3InstanceEnvironment environment,
                                          fmi3LogMessageCallback log)
{
    (void)name, (void)token, (void)resources, (void)visible, (void)logging;
    if (log) log(environment, fmi3Error, "logStatusError", "only co-simulation is possible");
    return NULL;
}

fmi3Instance fmi3InstantiateScheduledExecution(fmi3String name, fmi3String token, fmi3String resources,
                                               fmi3Boolean visible, fmi3Boolean logging,
                                               fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                                               fmi3ClockUpdateCallback clock, fmi3LockPreemptionCallback lock,
                                               fmi3UnlockPreemptionCallback unlock)
{
    (void)clock, (void)lock, (void)unlock;
    return fmi3InstantiateModelExchange(name, token, resources, visible, logging, environment, log);
}

void fmi3FreeInstance(fmi3Instance instance)
{
    Instance3 *const c = instance;
    if (!c) return;
    unit_free(c->unit);
    free(c);
}

/* Ignores the importer's tolerance: the case's own accuracy is a parameter. */
fmi3Status fmi3EnterInitializationMode(fmi3Instance c, fmi3Boolean has_tolerance, fmi3Float64 tolerance,
                                       fmi3Float64 start, fmi3Boolean has_stop, fmi3Float64 stop)
{
    Unit *const u = unit_in(c, PHASE_INSTANTIATED, "fmi3EnterInitializationMode");
    (void)has_tolerance, (void)tolerance;
    if (!u) return fmi3Error;
    const Outcome outcome = unit_set_times(u, start, has_stop, stop);
    return (fmi3Status)(outcome ? outcome : unit_begin(u));
}

fmi3Status fmi3ExitInitializationMode(fmi3Instance c)
{
    Unit *const u = unit_in(c, PHASE_INITIALIZING, "fmi3ExitInitializationMode");
    return u ? (fmi3Status)unit_settle(u) : fmi3Error;
}

fmi3Status fmi3Terminate(fmi3Instance c)
{
    Unit *const u = unit_in(c, PHASE_STEPPING, "fmi3Terminate");
    return u ? (fmi3Status)unit_end(u) : fmi3Error;
}

fmi3Status fmi3Reset(fmi3Instance c)
{
    Unit *const u = unit_in(c, PHASES_ALL, "fmi3Reset");
    return u ? (fmi3Status)unit_reset(u) : fmi3Error;
}

fmi3Status fmi3DoStep(fmi3Instance c, fmi3Float64 now, fmi3Float64 step, fmi3Boolean no_state_before,
                      fmi3Boolean *event_needed, fmi3Boolean *terminate, fmi3Boolean *early_return,
                      fmi3Float64 *reached)
{
    Unit *const u = unit_in(c, PHASE_STEPPING, "fmi3DoStep");
    int over = 0;
    (void)no_state_before;
    const fmi3Status status = u ? (fmi3Status)unit_step(u, now, step, &over) : fmi3Error;
    if (event_needed) *event_needed = false;
    if (terminate) *terminate = over != 0;
    if (early_return) *early_return = false;
    if (reached) *reached = u ? unit_time(u) : now;
    return status;
}

/* ------------------------------------------------------------------------------------------------------- values */

/* Checks that there are as many values as references: all variables are scalars. */
static Unit *unit_for_values(fmi3Instance c, const fmi3ValueReference vr[], size_t n, const void *value,
                             size_t n_values, unsigned phases, const char *call)
{
    Unit *const u = unit_in(c, phases, call);
    if (!u || (n == n_values && (n == 0 || (vr && value)))) return u;
    unit_say(u, FAILED, "%s: %zu values for %zu variables", call, n_values, n);
    return NULL;
}

/* The types of the variables, with the conversions between C's values and the unit's. */
#define GET_AND_SET(NAME, TYPE, OF_VALUE, TO_VALUE)                                                                    \
    fmi3Status fmi3Get##NAME(fmi3Instance c, const fmi3ValueReference vr[], size_t n, fmi3##NAME value[],              \
                             size_t n_values)                                                                          \
    {                                                                                                                  \
        Unit *const u =                                                                                                \
            unit_for_values(c, vr, n, (const void *)value, n_values, PHASES_EARLY | PHASES_LATE, "fmi3Get" #NAME);     \
        Outcome status = u ? GOES_WELL : FAILED;                                                                       \
        for (size_t i = 0; i < n && status < FAILED; ++i) {                                                            \
            double number = 0;                                                                                         \
            const char *text = "";                                                                                     \
            status = outcome_worse(status, unit_get(u, vr[i], TYPE, &number, &text));                                  \
            value[i] = OF_VALUE;                                                                                       \
            (void)number, (void)text;                                                                                  \
        }                                                                                                              \
        return (fmi3Status)status;                                                                                     \
    }                                                                                                                  \
    fmi3Status fmi3Set##NAME(fmi3Instance c, const fmi3ValueReference vr[], size_t n, const fmi3##NAME value[],        \
                             size_t n_values)                                                                          \
    {                                                                                                                  \
        Unit *const u =                                                                                                \
            unit_for_values(c, vr, n, (const void *)value, n_values, PHASES_EARLY | PHASE_STEPPING, "fmi3Set" #NAME);  \
        Outcome status = u ? GOES_WELL : FAILED;                                                                       \
        for (size_t i = 0; i < n && status < FAILED; ++i)                                                              \
            status = outcome_worse(status, unit_set(u, vr[i], TYPE, TO_VALUE));                                        \
        return (fmi3Status)status;                                                                                     \
    }
GET_AND_SET(Float64, VARIABLE_REAL, number, value[i])
GET_AND_SET(Int32, VARIABLE_INTEGER, (fmi3Int32)number, (double)value[i])
GET_AND_SET(Int64, VARIABLE_VERDICT, (fmi3Int64)number, (double)value[i])
GET_AND_SET(Boolean, VARIABLE_BOOLEAN, number > 0.5, value[i] ? 1 : 0)
GET_AND_SET(String, VARIABLE_TEXT, text, 0)

/* ------------------------------------------------------------------------------------------------------- states */

fmi3Status fmi3GetFMUState(fmi3Instance c, fmi3FMUState *state)
{
    return (fmi3Status)state_get(c, state, "fmi3GetFMUState");
}
fmi3Status fmi3SetFMUState(fmi3Instance c, fmi3FMUState state)
{
    return (fmi3Status)state_set(c, state, "fmi3SetFMUState");
}
fmi3Status fmi3FreeFMUState(fmi3Instance c, fmi3FMUState *state) { return (fmi3Status)state_free(c, state); }
fmi3Status fmi3SerializedFMUStateSize(fmi3Instance c, fmi3FMUState state, size_t *size)
{
    return (fmi3Status)state_size(c, state, size);
}
fmi3Status fmi3SerializeFMUState(fmi3Instance c, fmi3FMUState state, fmi3Byte to[], size_t size)
{
    return (fmi3Status)state_bytes(c, state, to, size);
}
fmi3Status fmi3DeserializeFMUState(fmi3Instance c, const fmi3Byte from[], size_t size, fmi3FMUState *state)
{
    return (fmi3Status)state_of_bytes(c, from, size, state, "fmi3DeserializeFMUState");
}
