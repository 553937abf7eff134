/* Version 2.0 of the interface: each call checks the standard's requirements and passes on to the unit. */
#include "fmi/fmi2.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fmi/unit.h"

/* Instance in an importer. */
typedef struct Instance2 {
    Unit *unit; /* first, as in every Instance */
    fmi2CallbackFunctions calls;
    char *name;
    fmi2Status last; /* status of the last step */
    int over;
} Instance2;

/* Passes text as an argument of a format: the importer's logger takes a format. */
static void say2(void *host, Outcome outcome, const char *category, const char *text)
{
    const Instance2 *const c = host;
    if (c->calls.logger)
        c->calls.logger(c->calls.componentEnvironment, c->name, (fmi2Status)outcome, category, "%s", text);
}

const char *fmi2GetTypesPlatform(void) { return "default"; }
const char *fmi2GetVersion(void) { return "2.0"; }

fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, size_t n, const fmi2String category[])
{
    Unit *const u = unit_in(c, PHASES_ALL, "fmi2SetDebugLogging");
    (void)n, (void)category;
    if (!u) return fmi2Error;
    u->logging = on != fmi2False;
    return fmi2OK;
}

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions *calls, fmi2Boolean visible, fmi2Boolean logging)
{
    (void)visible;
    Instance2 *const c = calloc(1, sizeof *c);
    if (!c) return NULL;
    if (calls) c->calls = *calls;
    c->name = strdup(name ? name : "");
    char *const folder = address_folder(resources);
    if (type != fmi2CoSimulation) say2(c, FAILED, "logStatusError", "only co-simulation is possible");
    if (!name || !*name) say2(c, FAILED, "logStatusError", "an instance needs a name");
    if (!folder) say2(c, FAILED, "logStatusError", "the address of the resources is not that of a folder: file:///...");
    if (type == fmi2CoSimulation && name && *name && c->name && folder)
        c->unit = unit_new(folder, guid, logging != fmi2False, say2, c);
    free(folder);
    if (c->unit) return c;
    free(c->name);
    free(c);
    return NULL;
}

void fmi2FreeInstance(fmi2Component component)
{
    Instance2 *const c = component;
    if (!c) return;
    unit_free(c->unit);
    free(c->name);
    free(c);
}

/* Ignores the importer's tolerance: the case's own accuracy is a parameter. */
fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean has_tolerance, fmi2Real tolerance, fmi2Real start,
                               fmi2Boolean has_stop, fmi2Real stop)
{
    Unit *const u = unit_in(c, PHASE_INSTANTIATED, "fmi2SetupExperiment");
    (void)has_tolerance, (void)tolerance;
    return u ? (fmi2Status)unit_set_times(u, start, has_stop != fmi2False, stop) : fmi2Error;
}

fmi2Status fmi2EnterInitializationMode(fmi2Component c)
{
    Unit *const u = unit_in(c, PHASE_INSTANTIATED, "fmi2EnterInitializationMode");
    return u ? (fmi2Status)unit_begin(u) : fmi2Error;
}

fmi2Status fmi2ExitInitializationMode(fmi2Component c)
{
    Unit *const u = unit_in(c, PHASE_INITIALIZING, "fmi2ExitInitializationMode");
    return u ? (fmi2Status)unit_settle(u) : fmi2Error;
}

fmi2Status fmi2Terminate(fmi2Component c)
{
    Unit *const u = unit_in(c, PHASE_STEPPING, "fmi2Terminate");
    return u ? (fmi2Status)unit_end(u) : fmi2Error;
}

fmi2Status fmi2Reset(fmi2Component c)
{
    Unit *const u = unit_in(c, PHASES_ALL, "fmi2Reset");
    if (!u) return fmi2Error;
    ((Instance2 *)c)->last = fmi2OK;
    ((Instance2 *)c)->over = 0;
    return (fmi2Status)unit_reset(u);
}

/* ------------------------------------------------------------------------------------------------------- values */

static fmi2Status get2(fmi2Component c, const fmi2ValueReference vr[], size_t n, VariableType type, void *values,
                       const char *call)
{
    Unit *const u = unit_in(c, PHASES_EARLY | PHASES_LATE, call);
    Outcome status = u && (n == 0 || (vr && values)) ? GOES_WELL : FAILED;
    for (size_t i = 0; i < n && status < FAILED; ++i) {
        double value = 0;
        const char *text = "";
        /* choices are integers here */
        const int choice = type == VARIABLE_INTEGER && vr[i] < (size_t)u->model.variables.n &&
                           u->model.variables.row[vr[i]].type == VARIABLE_VERDICT;
        status = outcome_worse(status, unit_get(u, vr[i], choice ? VARIABLE_VERDICT : type, &value, &text));
        if (type == VARIABLE_REAL) ((fmi2Real *)values)[i] = value;
        if (type == VARIABLE_INTEGER) ((fmi2Integer *)values)[i] = (fmi2Integer)value;
        if (type == VARIABLE_BOOLEAN) ((fmi2Boolean *)values)[i] = value > 0.5;
        if (type == VARIABLE_TEXT) ((fmi2String *)values)[i] = text;
    }
    return (fmi2Status)status;
}

static fmi2Status set2(fmi2Component c, const fmi2ValueReference vr[], size_t n, VariableType type, const void *values,
                       const char *call)
{
    Unit *const u = unit_in(c, PHASES_EARLY | PHASE_STEPPING, call);
    Outcome status = u && (n == 0 || (vr && values)) ? GOES_WELL : FAILED;
    for (size_t i = 0; i < n && status < FAILED; ++i) {
        const double value = type == VARIABLE_REAL      ? ((const fmi2Real *)values)[i]
                             : type == VARIABLE_INTEGER ? ((const fmi2Integer *)values)[i]
                                                        : ((const fmi2Boolean *)values)[i] != fmi2False;
        status = outcome_worse(status, unit_set(u, vr[i], type, value));
    }
    return (fmi2Status)status;
}

fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2Real value[])
{
    return get2(c, vr, n, VARIABLE_REAL, value, "fmi2GetReal");
}
fmi2Status fmi2GetInteger(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2Integer value[])
{
    return get2(c, vr, n, VARIABLE_INTEGER, value, "fmi2GetInteger");
}
fmi2Status fmi2GetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2Boolean value[])
{
    return get2(c, vr, n, VARIABLE_BOOLEAN, value, "fmi2GetBoolean");
}
fmi2Status fmi2GetString(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2String value[])
{
    return get2(c, vr, n, VARIABLE_TEXT, (void *)value, "fmi2GetString");
}
fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2Real value[])
{
    return set2(c, vr, n, VARIABLE_REAL, value, "fmi2SetReal");
}
fmi2Status fmi2SetInteger(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2Integer value[])
{
    return set2(c, vr, n, VARIABLE_INTEGER, value, "fmi2SetInteger");
}
fmi2Status fmi2SetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2Boolean value[])
{
    return set2(c, vr, n, VARIABLE_BOOLEAN, value, "fmi2SetBoolean");
}

/* Rejects all texts: they are outputs. */
fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2String value[])
{
    Unit *const u = unit_in(c, PHASES_EARLY | PHASE_STEPPING, "fmi2SetString");
    (void)vr, (void)value;
    if (u && n > 0) unit_say(u, FAILED, "no text can be set");
    return u && n == 0 ? fmi2OK : fmi2Error;
}

/* -------------------------------------------------------------------------------------------------------- steps */

fmi2Status fmi2DoStep(fmi2Component component, fmi2Real now, fmi2Real step, fmi2Boolean no_state_before)
{
    Instance2 *const c = component;
    Unit *const u = unit_in(component, PHASE_STEPPING, "fmi2DoStep");
    (void)no_state_before;
    if (!u) return fmi2Error;
    c->last = (fmi2Status)unit_step(u, now, step, &c->over);
    if (c->over && c->last < fmi2Error) c->last = fmi2Discard;
    return c->last;
}

/* Always fails: a step is over when its call returns. */
fmi2Status fmi2CancelStep(fmi2Component c)
{
    Unit *const u = c ? ((Instance2 *)c)->unit : NULL;
    if (u) unit_say(u, FAILED, "fmi2CancelStep cannot be called: no step goes on in the background");
    return fmi2Error;
}

fmi2Status fmi2GetStatus(fmi2Component c, fmi2StatusKind kind, fmi2Status *value)
{
    if (!c || !value || kind != fmi2DoStepStatus) return fmi2Discard;
    *value = ((Instance2 *)c)->last;
    return fmi2OK;
}
fmi2Status fmi2GetRealStatus(fmi2Component c, fmi2StatusKind kind, fmi2Real *value)
{
    if (!c || !value || kind != fmi2LastSuccessfulTime) return fmi2Discard;
    *value = unit_time(((Instance2 *)c)->unit);
    return fmi2OK;
}
fmi2Status fmi2GetBooleanStatus(fmi2Component c, fmi2StatusKind kind, fmi2Boolean *value)
{
    if (!c || !value || kind != fmi2Terminated) return fmi2Discard;
    *value = ((Instance2 *)c)->over ? fmi2True : fmi2False;
    return fmi2OK;
}
fmi2Status fmi2GetIntegerStatus(fmi2Component c, fmi2StatusKind kind, fmi2Integer *value)
{
    (void)c, (void)kind, (void)value;
    return fmi2Discard;
}
fmi2Status fmi2GetStringStatus(fmi2Component c, fmi2StatusKind kind, fmi2String *value)
{
    (void)c, (void)kind, (void)value;
    return fmi2Discard;
}

/* ------------------------------------------------------------------------------------------------------- states */

fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *state)
{
    return (fmi2Status)state_get(c, state, "fmi2GetFMUstate");
}
fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state)
{
    const Outcome outcome = state_set(c, state, "fmi2SetFMUstate");
    if (!outcome) ((Instance2 *)c)->over = 0;
    return (fmi2Status)outcome;
}
fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *state) { return (fmi2Status)state_free(c, state); }
fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate state, size_t *size)
{
    return (fmi2Status)state_size(c, state, size);
}
fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate state, fmi2Byte to[], size_t size)
{
    return (fmi2Status)state_bytes(c, state, to, size);
}
fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte from[], size_t size, fmi2FMUstate *state)
{
    return (fmi2Status)state_of_bytes(c, from, size, state, "fmi2DeSerializeFMUstate");
}

/* ---------------------------------------------------------------------------------- excluded by the description */

#pragma GCC diagnostic ignored "-Wunused-parameter"

#define DENIED(NAME, ...)                                                                                              \
    fmi2Status fmi2##NAME(fmi2Component c __VA_OPT__(, ) __VA_ARGS__)                                                  \
    {                                                                                                                  \
        return (fmi2Status)unit_denied(c, "fmi2" #NAME);                                                               \
    }
DENIED(GetDirectionalDerivative, const fmi2ValueReference unknown[], size_t n_unknown, const fmi2ValueReference known[],
       size_t n_known, const fmi2Real known_by[], fmi2Real unknown_by[])
DENIED(SetRealInputDerivatives, const fmi2ValueReference vr[], size_t n, const fmi2Integer order[],
       const fmi2Real value[])
DENIED(GetRealOutputDerivatives, const fmi2ValueReference vr[], size_t n, const fmi2Integer order[], fmi2Real value[])
DENIED(EnterEventMode)
DENIED(NewDiscreteStates, fmi2EventInfo *info)
DENIED(EnterContinuousTimeMode)
DENIED(CompletedIntegratorStep, fmi2Boolean no_state_before, fmi2Boolean *enter_event, fmi2Boolean *terminate)
DENIED(SetTime, fmi2Real time)
DENIED(SetContinuousStates, const fmi2Real state[], size_t n)
DENIED(GetDerivatives, fmi2Real derivative[], size_t n)
DENIED(GetEventIndicators, fmi2Real indicator[], size_t n)
DENIED(GetContinuousStates, fmi2Real state[], size_t n)
DENIED(GetNominalsOfContinuousStates, fmi2Real nominal[], size_t n)
