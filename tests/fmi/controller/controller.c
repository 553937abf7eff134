/* An example of a unit that is not hawser's: a winch's controller, for co-simulation by FMI 3.0 (docs/guide/fmi.md,
 * "Two units"). In each step it sets the speed to belt + gain (target - force), between standstill and twice the
 * belt's. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fmi/fmi3.h"

#pragma GCC diagnostic ignored "-Wunused-parameter"

/* By reference, in SI units; modelDescription.xml has the same. */
enum { TIME, FORCE, SPEED, TARGET, GAIN, BELT, VARIABLES };
static const char TOKEN[] = "winch-controller-1";

typedef struct Controller {
    double value[VARIABLES];
} Controller;

static const double starts[VARIABLES] = {[TARGET] = 800, [GAIN] = 1e-5, [BELT] = 0.1};

const char *fmi3GetVersion(void) { return "3.0"; }

fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                         fmi3Boolean logging, fmi3Boolean event_mode, fmi3Boolean early_return,
                                         const fmi3ValueReference intermediate[], size_t n_intermediate,
                                         fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                                         fmi3IntermediateUpdateCallback update)
{
    Controller *const c = token && !strcmp(token, TOKEN) ? malloc(sizeof *c) : NULL;
    if (c) memcpy(c->value, starts, sizeof starts);
    return c;
}

fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                          fmi3Boolean logging, fmi3InstanceEnvironment environment,
                                          fmi3LogMessageCallback log)
{
    return NULL;
}

fmi3Instance fmi3InstantiateScheduledExecution(fmi3String name, fmi3String token, fmi3String resources,
                                               fmi3Boolean visible, fmi3Boolean logging,
                                               fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                                               fmi3ClockUpdateCallback clock, fmi3LockPreemptionCallback lock,
                                               fmi3UnlockPreemptionCallback unlock)
{
    return NULL;
}

void fmi3FreeInstance(fmi3Instance c) { free(c); }

fmi3Status fmi3EnterInitializationMode(fmi3Instance c, fmi3Boolean has_tolerance, fmi3Float64 tolerance,
                                       fmi3Float64 start, fmi3Boolean has_stop, fmi3Float64 stop)
{
    ((Controller *)c)->value[TIME] = start;
    return fmi3OK;
}

fmi3Status fmi3ExitInitializationMode(fmi3Instance c)
{
    ((Controller *)c)->value[SPEED] = ((Controller *)c)->value[BELT];
    return fmi3OK;
}

fmi3Status fmi3Terminate(fmi3Instance c) { return fmi3OK; }

fmi3Status fmi3Reset(fmi3Instance c)
{
    memcpy(((Controller *)c)->value, starts, sizeof starts);
    return fmi3OK;
}

fmi3Status fmi3SetDebugLogging(fmi3Instance c, fmi3Boolean on, size_t n, const fmi3String category[]) { return fmi3OK; }

fmi3Status fmi3GetFloat64(fmi3Instance c, const fmi3ValueReference vr[], size_t n, fmi3Float64 value[], size_t n_values)
{
    for (size_t k = 0; k < n; ++k) {
        if (n_values != n || vr[k] >= VARIABLES) return fmi3Error;
        value[k] = ((const Controller *)c)->value[vr[k]];
    }
    return fmi3OK;
}

fmi3Status fmi3SetFloat64(fmi3Instance c, const fmi3ValueReference vr[], size_t n, const fmi3Float64 value[],
                          size_t n_values)
{
    for (size_t k = 0; k < n; ++k) {
        if (n_values != n || vr[k] >= VARIABLES || vr[k] == TIME || vr[k] == SPEED) return fmi3Error;
        ((Controller *)c)->value[vr[k]] = value[k];
    }
    return fmi3OK;
}

fmi3Status fmi3DoStep(fmi3Instance instance, fmi3Float64 now, fmi3Float64 step, fmi3Boolean no_state_before,
                      fmi3Boolean *event_needed, fmi3Boolean *terminate, fmi3Boolean *early_return,
                      fmi3Float64 *reached)
{
    double *const v = ((Controller *)instance)->value;
    v[SPEED] = fmin(fmax(v[BELT] + v[GAIN] * (v[TARGET] - v[FORCE]), 0), 2 * v[BELT]);
    v[TIME] = now + step;
    *event_needed = *terminate = *early_return = false;
    *reached = v[TIME];
    return fmi3OK;
}

/* All else is there, since importers look it up, and fails. */
#define DENIED(NAME, ...)                                                                                              \
    fmi3Status fmi3##NAME(fmi3Instance c __VA_OPT__(, ) __VA_ARGS__) { return fmi3Error; }
#define NO_VARIABLE_IS(NAME)                                                                                           \
    DENIED(Get##NAME, const fmi3ValueReference vr[], size_t n, fmi3##NAME value[], size_t n_values)                    \
    DENIED(Set##NAME, const fmi3ValueReference vr[], size_t n, const fmi3##NAME value[], size_t n_values)
#include "fmi/fmi3_denied.h"
NO_VARIABLE_IS(Int32)
NO_VARIABLE_IS(Int64)
NO_VARIABLE_IS(Boolean)
NO_VARIABLE_IS(String)
DENIED(GetFMUState, fmi3FMUState *state)
DENIED(SetFMUState, fmi3FMUState state)
DENIED(FreeFMUState, fmi3FMUState *state)
DENIED(SerializedFMUStateSize, fmi3FMUState state, size_t *size)
DENIED(SerializeFMUState, fmi3FMUState state, fmi3Byte to[], size_t size)
DENIED(DeserializeFMUState, const fmi3Byte from[], size_t size, fmi3FMUState *state)
