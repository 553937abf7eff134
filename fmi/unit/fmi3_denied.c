/* Calls of version 3.0 that the description denies: types that no variable has, events, clocks, derivatives,
 * configuration. An importer that keeps to the description calls none of them; another gets an error, and nothing else
 * happens. */
#include "fmi/standard/fmi3.h"

#pragma GCC diagnostic ignored "-Wunused-parameter"

/* Nothing may be asked of no variables. */
#define NO_VARIABLE_IS(NAME)                                                                                           \
    fmi3Status fmi3Get##NAME(fmi3Instance c, const fmi3ValueReference vr[], size_t n, fmi3##NAME value[],              \
                             size_t n_values)                                                                          \
    {                                                                                                                  \
        return c && n == 0 && n_values == 0 ? fmi3OK : fmi3Error;                                                      \
    }                                                                                                                  \
    fmi3Status fmi3Set##NAME(fmi3Instance c, const fmi3ValueReference vr[], size_t n, const fmi3##NAME value[],        \
                             size_t n_values)                                                                          \
    {                                                                                                                  \
        return c && n == 0 && n_values == 0 ? fmi3OK : fmi3Error;                                                      \
    }
NO_VARIABLE_IS(Float32)
NO_VARIABLE_IS(Int8)
NO_VARIABLE_IS(UInt8)
NO_VARIABLE_IS(Int16)
NO_VARIABLE_IS(UInt16)
NO_VARIABLE_IS(UInt32)
NO_VARIABLE_IS(UInt64)

#define DENIED(NAME, ...)                                                                                              \
    fmi3Status fmi3##NAME(fmi3Instance c __VA_OPT__(, ) __VA_ARGS__) { return fmi3Error; }
DENIED(GetBinary, const fmi3ValueReference vr[], size_t n, size_t size[], fmi3Binary value[], size_t n_values)
DENIED(SetBinary, const fmi3ValueReference vr[], size_t n, const size_t size[], const fmi3Binary value[],
       size_t n_values)
DENIED(GetClock, const fmi3ValueReference vr[], size_t n, fmi3Clock value[])
DENIED(SetClock, const fmi3ValueReference vr[], size_t n, const fmi3Clock value[])
DENIED(GetNumberOfVariableDependencies, fmi3ValueReference vr, size_t *n)
DENIED(GetVariableDependencies, fmi3ValueReference dependent, size_t of_dependent[], fmi3ValueReference independent[],
       size_t of_independent[], fmi3DependencyKind kind[], size_t n)
DENIED(GetDirectionalDerivative, const fmi3ValueReference unknown[], size_t n_unknown, const fmi3ValueReference known[],
       size_t n_known, const fmi3Float64 seed[], size_t n_seed, fmi3Float64 sensitivity[], size_t n_sensitivity)
DENIED(GetAdjointDerivative, const fmi3ValueReference unknown[], size_t n_unknown, const fmi3ValueReference known[],
       size_t n_known, const fmi3Float64 seed[], size_t n_seed, fmi3Float64 sensitivity[], size_t n_sensitivity)
DENIED(EnterEventMode)
DENIED(EnterConfigurationMode)
DENIED(ExitConfigurationMode)
DENIED(EnterStepMode)
DENIED(EvaluateDiscreteStates)
DENIED(UpdateDiscreteStates, fmi3Boolean *again, fmi3Boolean *terminate, fmi3Boolean *nominals_changed,
       fmi3Boolean *states_changed, fmi3Boolean *has_next, fmi3Float64 *next)
DENIED(GetIntervalDecimal, const fmi3ValueReference vr[], size_t n, fmi3Float64 interval[],
       fmi3IntervalQualifier qualifier[])
DENIED(GetIntervalFraction, const fmi3ValueReference vr[], size_t n, fmi3UInt64 counter[], fmi3UInt64 resolution[],
       fmi3IntervalQualifier qualifier[])
DENIED(GetShiftDecimal, const fmi3ValueReference vr[], size_t n, fmi3Float64 shift[])
DENIED(GetShiftFraction, const fmi3ValueReference vr[], size_t n, fmi3UInt64 counter[], fmi3UInt64 resolution[])
DENIED(SetIntervalDecimal, const fmi3ValueReference vr[], size_t n, const fmi3Float64 interval[])
DENIED(SetIntervalFraction, const fmi3ValueReference vr[], size_t n, const fmi3UInt64 counter[],
       const fmi3UInt64 resolution[])
DENIED(SetShiftDecimal, const fmi3ValueReference vr[], size_t n, const fmi3Float64 shift[])
DENIED(SetShiftFraction, const fmi3ValueReference vr[], size_t n, const fmi3UInt64 counter[],
       const fmi3UInt64 resolution[])
DENIED(GetOutputDerivatives, const fmi3ValueReference vr[], size_t n, const fmi3Int32 order[], fmi3Float64 value[],
       size_t n_values)
