/* All calls of FMI 3.0 besides those for co-simulation of numbers, booleans and texts with states: a unit does not
 * support them, but importers look them up. The including file defines NO_VARIABLE_IS(TYPE), for getting and setting,
 * and DENIED(CALL, arguments...), and gives each a body. No guard: it is a list. */
NO_VARIABLE_IS(Float32)
NO_VARIABLE_IS(Int8)
NO_VARIABLE_IS(UInt8)
NO_VARIABLE_IS(Int16)
NO_VARIABLE_IS(UInt16)
NO_VARIABLE_IS(UInt32)
NO_VARIABLE_IS(UInt64)
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
DENIED(EnterContinuousTimeMode)
DENIED(CompletedIntegratorStep, fmi3Boolean no_state_before, fmi3Boolean *enter_event, fmi3Boolean *terminate)
DENIED(SetTime, fmi3Float64 time)
DENIED(SetContinuousStates, const fmi3Float64 state[], size_t n)
DENIED(GetContinuousStateDerivatives, fmi3Float64 derivative[], size_t n)
DENIED(GetEventIndicators, fmi3Float64 indicator[], size_t n)
DENIED(GetContinuousStates, fmi3Float64 state[], size_t n)
DENIED(GetNominalsOfContinuousStates, fmi3Float64 nominal[], size_t n)
DENIED(GetNumberOfEventIndicators, size_t *n)
DENIED(GetNumberOfContinuousStates, size_t *n)
DENIED(ActivateModelPartition, fmi3ValueReference clock, fmi3Float64 time)
