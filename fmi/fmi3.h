/* The external interface of an FMU by version 3.0 of the Functional Mock-up Interface: types, values and prototypes of
 * the standard (FMI 3.0.1, chapters 2 to 5). Importers look up every function when they load a library, so those of
 * kinds that the description excludes exist too. */
#ifndef HAWSER_FMI_STANDARD_FMI3_H
#define HAWSER_FMI_STANDARD_FMI3_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef void *fmi3Instance;
typedef void *fmi3InstanceEnvironment;
typedef void *fmi3FMUState;
typedef uint32_t fmi3ValueReference;
typedef float fmi3Float32;
typedef double fmi3Float64;
typedef int8_t fmi3Int8;
typedef uint8_t fmi3UInt8;
typedef int16_t fmi3Int16;
typedef uint16_t fmi3UInt16;
typedef int32_t fmi3Int32;
typedef uint32_t fmi3UInt32;
typedef int64_t fmi3Int64;
typedef uint64_t fmi3UInt64;
typedef bool fmi3Boolean;
typedef char fmi3Char;
typedef const fmi3Char *fmi3String;
typedef uint8_t fmi3Byte;
typedef const fmi3Byte *fmi3Binary;
typedef bool fmi3Clock;

typedef enum fmi3Status { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error, fmi3Fatal } fmi3Status;
typedef enum fmi3DependencyKind {
    fmi3Independent,
    fmi3Constant,
    fmi3Fixed,
    fmi3Tunable,
    fmi3Discrete,
    fmi3Dependent
} fmi3DependencyKind;
typedef enum fmi3IntervalQualifier {
    fmi3IntervalNotYetKnown,
    fmi3IntervalUnchanged,
    fmi3IntervalChanged
} fmi3IntervalQualifier;

typedef void (*fmi3LogMessageCallback)(fmi3InstanceEnvironment, fmi3Status, fmi3String category, fmi3String message);
typedef void (*fmi3IntermediateUpdateCallback)(fmi3InstanceEnvironment, fmi3Float64 time, fmi3Boolean set_requested,
                                               fmi3Boolean get_allowed, fmi3Boolean step_finished,
                                               fmi3Boolean can_return, fmi3Boolean *return_requested,
                                               fmi3Float64 *return_time);
typedef void (*fmi3ClockUpdateCallback)(fmi3InstanceEnvironment);
typedef void (*fmi3LockPreemptionCallback)(void);
typedef void (*fmi3UnlockPreemptionCallback)(void);

/* An FMU's library exports these and nothing else. */
#define FMI3_FUNCTION __attribute__((visibility("default")))

FMI3_FUNCTION const char *fmi3GetVersion(void);
FMI3_FUNCTION fmi3Status fmi3SetDebugLogging(fmi3Instance, fmi3Boolean on, size_t n, const fmi3String category[]);

FMI3_FUNCTION fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources,
                                                        fmi3Boolean visible, fmi3Boolean logging,
                                                        fmi3InstanceEnvironment, fmi3LogMessageCallback);
FMI3_FUNCTION fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources,
                                                       fmi3Boolean visible, fmi3Boolean logging, fmi3Boolean event_mode,
                                                       fmi3Boolean early_return,
                                                       const fmi3ValueReference intermediate[], size_t n_intermediate,
                                                       fmi3InstanceEnvironment, fmi3LogMessageCallback,
                                                       fmi3IntermediateUpdateCallback);
FMI3_FUNCTION fmi3Instance fmi3InstantiateScheduledExecution(fmi3String name, fmi3String token, fmi3String resources,
                                                             fmi3Boolean visible, fmi3Boolean logging,
                                                             fmi3InstanceEnvironment, fmi3LogMessageCallback,
                                                             fmi3ClockUpdateCallback, fmi3LockPreemptionCallback,
                                                             fmi3UnlockPreemptionCallback);
FMI3_FUNCTION void fmi3FreeInstance(fmi3Instance);
FMI3_FUNCTION fmi3Status fmi3EnterInitializationMode(fmi3Instance, fmi3Boolean has_tolerance, fmi3Float64 tolerance,
                                                     fmi3Float64 start, fmi3Boolean has_stop, fmi3Float64 stop);
FMI3_FUNCTION fmi3Status fmi3ExitInitializationMode(fmi3Instance);
FMI3_FUNCTION fmi3Status fmi3EnterEventMode(fmi3Instance);
FMI3_FUNCTION fmi3Status fmi3Terminate(fmi3Instance);
FMI3_FUNCTION fmi3Status fmi3Reset(fmi3Instance);

/* Getting and setting have the same form for all types but two. */
#define FMI3_GET_AND_SET(NAME)                                                                                         \
    FMI3_FUNCTION fmi3Status fmi3Get##NAME(fmi3Instance, const fmi3ValueReference[], size_t n, fmi3##NAME value[],     \
                                           size_t n_values);                                                           \
    FMI3_FUNCTION fmi3Status fmi3Set##NAME(fmi3Instance, const fmi3ValueReference[], size_t n,                         \
                                           const fmi3##NAME value[], size_t n_values)
FMI3_GET_AND_SET(Float32);
FMI3_GET_AND_SET(Float64);
FMI3_GET_AND_SET(Int8);
FMI3_GET_AND_SET(UInt8);
FMI3_GET_AND_SET(Int16);
FMI3_GET_AND_SET(UInt16);
FMI3_GET_AND_SET(Int32);
FMI3_GET_AND_SET(UInt32);
FMI3_GET_AND_SET(Int64);
FMI3_GET_AND_SET(UInt64);
FMI3_GET_AND_SET(Boolean);
FMI3_GET_AND_SET(String);
FMI3_FUNCTION fmi3Status fmi3GetBinary(fmi3Instance, const fmi3ValueReference[], size_t n, size_t size[],
                                       fmi3Binary value[], size_t n_values);
FMI3_FUNCTION fmi3Status fmi3SetBinary(fmi3Instance, const fmi3ValueReference[], size_t n, const size_t size[],
                                       const fmi3Binary value[], size_t n_values);
FMI3_FUNCTION fmi3Status fmi3GetClock(fmi3Instance, const fmi3ValueReference[], size_t n, fmi3Clock value[]);
FMI3_FUNCTION fmi3Status fmi3SetClock(fmi3Instance, const fmi3ValueReference[], size_t n, const fmi3Clock value[]);

FMI3_FUNCTION fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance, fmi3ValueReference, size_t *n);
FMI3_FUNCTION fmi3Status fmi3GetVariableDependencies(fmi3Instance, fmi3ValueReference dependent, size_t of_dependent[],
                                                     fmi3ValueReference independent[], size_t of_independent[],
                                                     fmi3DependencyKind[], size_t n);
FMI3_FUNCTION fmi3Status fmi3GetFMUState(fmi3Instance, fmi3FMUState *);
FMI3_FUNCTION fmi3Status fmi3SetFMUState(fmi3Instance, fmi3FMUState);
FMI3_FUNCTION fmi3Status fmi3FreeFMUState(fmi3Instance, fmi3FMUState *);
FMI3_FUNCTION fmi3Status fmi3SerializedFMUStateSize(fmi3Instance, fmi3FMUState, size_t *size);
FMI3_FUNCTION fmi3Status fmi3SerializeFMUState(fmi3Instance, fmi3FMUState, fmi3Byte to[], size_t size);
FMI3_FUNCTION fmi3Status fmi3DeserializeFMUState(fmi3Instance, const fmi3Byte from[], size_t size, fmi3FMUState *);
FMI3_FUNCTION fmi3Status fmi3GetDirectionalDerivative(fmi3Instance, const fmi3ValueReference unknown[],
                                                      size_t n_unknown, const fmi3ValueReference known[],
                                                      size_t n_known, const fmi3Float64 seed[], size_t n_seed,
                                                      fmi3Float64 sensitivity[], size_t n_sensitivity);
FMI3_FUNCTION fmi3Status fmi3GetAdjointDerivative(fmi3Instance, const fmi3ValueReference unknown[], size_t n_unknown,
                                                  const fmi3ValueReference known[], size_t n_known,
                                                  const fmi3Float64 seed[], size_t n_seed, fmi3Float64 sensitivity[],
                                                  size_t n_sensitivity);

FMI3_FUNCTION fmi3Status fmi3EnterConfigurationMode(fmi3Instance);
FMI3_FUNCTION fmi3Status fmi3ExitConfigurationMode(fmi3Instance);
FMI3_FUNCTION fmi3Status fmi3GetIntervalDecimal(fmi3Instance, const fmi3ValueReference[], size_t n,
                                                fmi3Float64 interval[], fmi3IntervalQualifier[]);
FMI3_FUNCTION fmi3Status fmi3GetIntervalFraction(fmi3Instance, const fmi3ValueReference[], size_t n,
                                                 fmi3UInt64 counter[], fmi3UInt64 resolution[],
                                                 fmi3IntervalQualifier[]);
FMI3_FUNCTION fmi3Status fmi3GetShiftDecimal(fmi3Instance, const fmi3ValueReference[], size_t n, fmi3Float64 shift[]);
FMI3_FUNCTION fmi3Status fmi3GetShiftFraction(fmi3Instance, const fmi3ValueReference[], size_t n, fmi3UInt64 counter[],
                                              fmi3UInt64 resolution[]);
FMI3_FUNCTION fmi3Status fmi3SetIntervalDecimal(fmi3Instance, const fmi3ValueReference[], size_t n,
                                                const fmi3Float64 interval[]);
FMI3_FUNCTION fmi3Status fmi3SetIntervalFraction(fmi3Instance, const fmi3ValueReference[], size_t n,
                                                 const fmi3UInt64 counter[], const fmi3UInt64 resolution[]);
FMI3_FUNCTION fmi3Status fmi3SetShiftDecimal(fmi3Instance, const fmi3ValueReference[], size_t n,
                                             const fmi3Float64 shift[]);
FMI3_FUNCTION fmi3Status fmi3SetShiftFraction(fmi3Instance, const fmi3ValueReference[], size_t n,
                                              const fmi3UInt64 counter[], const fmi3UInt64 resolution[]);
FMI3_FUNCTION fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance);
FMI3_FUNCTION fmi3Status fmi3UpdateDiscreteStates(fmi3Instance, fmi3Boolean *again, fmi3Boolean *terminate,
                                                  fmi3Boolean *nominals_changed, fmi3Boolean *states_changed,
                                                  fmi3Boolean *has_next, fmi3Float64 *next);

FMI3_FUNCTION fmi3Status fmi3EnterStepMode(fmi3Instance);
FMI3_FUNCTION fmi3Status fmi3GetOutputDerivatives(fmi3Instance, const fmi3ValueReference[], size_t n,
                                                  const fmi3Int32 order[], fmi3Float64 value[], size_t n_values);
FMI3_FUNCTION fmi3Status fmi3DoStep(fmi3Instance, fmi3Float64 now, fmi3Float64 step, fmi3Boolean no_state_before,
                                    fmi3Boolean *event_needed, fmi3Boolean *terminate, fmi3Boolean *early_return,
                                    fmi3Float64 *reached);

/* Model exchange. */
FMI3_FUNCTION fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance);
FMI3_FUNCTION fmi3Status fmi3CompletedIntegratorStep(fmi3Instance, fmi3Boolean no_state_before,
                                                     fmi3Boolean *enter_event, fmi3Boolean *terminate);
FMI3_FUNCTION fmi3Status fmi3SetTime(fmi3Instance, fmi3Float64 time);
FMI3_FUNCTION fmi3Status fmi3SetContinuousStates(fmi3Instance, const fmi3Float64 state[], size_t n);
FMI3_FUNCTION fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance, fmi3Float64 derivative[], size_t n);
FMI3_FUNCTION fmi3Status fmi3GetEventIndicators(fmi3Instance, fmi3Float64 indicator[], size_t n);
FMI3_FUNCTION fmi3Status fmi3GetContinuousStates(fmi3Instance, fmi3Float64 state[], size_t n);
FMI3_FUNCTION fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance, fmi3Float64 nominal[], size_t n);
FMI3_FUNCTION fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance, size_t *n);
FMI3_FUNCTION fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance, size_t *n);

/* Scheduled execution. */
FMI3_FUNCTION fmi3Status fmi3ActivateModelPartition(fmi3Instance, fmi3ValueReference clock, fmi3Float64 time);

#endif
