/* The external interface of an FMU by version 2.0 of the Functional Mock-up Interface, as far as co-simulation needs
 * it: types, values and prototypes of the standard (FMI 2.0.4, chapters 2 and 4). */
#ifndef HAWSER_FMI_STANDARD_FMI2_H
#define HAWSER_FMI_STANDARD_FMI2_H

#include <stddef.h>

typedef void *fmi2Component;
typedef void *fmi2ComponentEnvironment;
typedef void *fmi2FMUstate;
typedef unsigned int fmi2ValueReference;
typedef double fmi2Real;
typedef int fmi2Integer;
typedef int fmi2Boolean;
typedef char fmi2Char;
typedef const fmi2Char *fmi2String;
typedef char fmi2Byte;

enum { fmi2False = 0, fmi2True = 1 };

typedef enum fmi2Status { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending } fmi2Status;
typedef enum fmi2Type { fmi2ModelExchange, fmi2CoSimulation } fmi2Type;
typedef enum fmi2StatusKind {
    fmi2DoStepStatus,
    fmi2PendingStatus,
    fmi2LastSuccessfulTime,
    fmi2Terminated
} fmi2StatusKind;

/* `message` is a format of printf, followed by its arguments. */
typedef void (*fmi2CallbackLogger)(fmi2ComponentEnvironment, fmi2String instanceName, fmi2Status, fmi2String category,
                                   fmi2String message, ...);
typedef struct fmi2CallbackFunctions {
    fmi2CallbackLogger logger;
    void *(*allocateMemory)(size_t count, size_t size);
    void (*freeMemory)(void *);
    void (*stepFinished)(fmi2ComponentEnvironment, fmi2Status);
    fmi2ComponentEnvironment componentEnvironment;
} fmi2CallbackFunctions;

/* An FMU's library exports these and nothing else. */
#define FMI2_FUNCTION __attribute__((visibility("default")))

FMI2_FUNCTION const char *fmi2GetTypesPlatform(void);
FMI2_FUNCTION const char *fmi2GetVersion(void);
FMI2_FUNCTION fmi2Status fmi2SetDebugLogging(fmi2Component, fmi2Boolean on, size_t n, const fmi2String category[]);

FMI2_FUNCTION fmi2Component fmi2Instantiate(fmi2String name, fmi2Type, fmi2String guid, fmi2String resources,
                                            const fmi2CallbackFunctions *, fmi2Boolean visible, fmi2Boolean logging);
FMI2_FUNCTION void fmi2FreeInstance(fmi2Component);
FMI2_FUNCTION fmi2Status fmi2SetupExperiment(fmi2Component, fmi2Boolean has_tolerance, fmi2Real tolerance,
                                             fmi2Real start, fmi2Boolean has_stop, fmi2Real stop);
FMI2_FUNCTION fmi2Status fmi2EnterInitializationMode(fmi2Component);
FMI2_FUNCTION fmi2Status fmi2ExitInitializationMode(fmi2Component);
FMI2_FUNCTION fmi2Status fmi2Terminate(fmi2Component);
FMI2_FUNCTION fmi2Status fmi2Reset(fmi2Component);

FMI2_FUNCTION fmi2Status fmi2GetReal(fmi2Component, const fmi2ValueReference[], size_t n, fmi2Real value[]);
FMI2_FUNCTION fmi2Status fmi2GetInteger(fmi2Component, const fmi2ValueReference[], size_t n, fmi2Integer value[]);
FMI2_FUNCTION fmi2Status fmi2GetBoolean(fmi2Component, const fmi2ValueReference[], size_t n, fmi2Boolean value[]);
FMI2_FUNCTION fmi2Status fmi2GetString(fmi2Component, const fmi2ValueReference[], size_t n, fmi2String value[]);
FMI2_FUNCTION fmi2Status fmi2SetReal(fmi2Component, const fmi2ValueReference[], size_t n, const fmi2Real value[]);
FMI2_FUNCTION fmi2Status fmi2SetInteger(fmi2Component, const fmi2ValueReference[], size_t n, const fmi2Integer value[]);
FMI2_FUNCTION fmi2Status fmi2SetBoolean(fmi2Component, const fmi2ValueReference[], size_t n, const fmi2Boolean value[]);
FMI2_FUNCTION fmi2Status fmi2SetString(fmi2Component, const fmi2ValueReference[], size_t n, const fmi2String value[]);

FMI2_FUNCTION fmi2Status fmi2GetFMUstate(fmi2Component, fmi2FMUstate *);
FMI2_FUNCTION fmi2Status fmi2SetFMUstate(fmi2Component, fmi2FMUstate);
FMI2_FUNCTION fmi2Status fmi2FreeFMUstate(fmi2Component, fmi2FMUstate *);
FMI2_FUNCTION fmi2Status fmi2SerializedFMUstateSize(fmi2Component, fmi2FMUstate, size_t *size);
FMI2_FUNCTION fmi2Status fmi2SerializeFMUstate(fmi2Component, fmi2FMUstate, fmi2Byte to[], size_t size);
FMI2_FUNCTION fmi2Status fmi2DeSerializeFMUstate(fmi2Component, const fmi2Byte from[], size_t size, fmi2FMUstate *);
FMI2_FUNCTION fmi2Status fmi2GetDirectionalDerivative(fmi2Component, const fmi2ValueReference unknown[],
                                                      size_t n_unknown, const fmi2ValueReference known[],
                                                      size_t n_known, const fmi2Real known_by[], fmi2Real unknown_by[]);

FMI2_FUNCTION fmi2Status fmi2SetRealInputDerivatives(fmi2Component, const fmi2ValueReference[], size_t n,
                                                     const fmi2Integer order[], const fmi2Real value[]);
FMI2_FUNCTION fmi2Status fmi2GetRealOutputDerivatives(fmi2Component, const fmi2ValueReference[], size_t n,
                                                      const fmi2Integer order[], fmi2Real value[]);
FMI2_FUNCTION fmi2Status fmi2DoStep(fmi2Component, fmi2Real now, fmi2Real step, fmi2Boolean no_state_before);
FMI2_FUNCTION fmi2Status fmi2CancelStep(fmi2Component);
FMI2_FUNCTION fmi2Status fmi2GetStatus(fmi2Component, fmi2StatusKind, fmi2Status *);
FMI2_FUNCTION fmi2Status fmi2GetRealStatus(fmi2Component, fmi2StatusKind, fmi2Real *);
FMI2_FUNCTION fmi2Status fmi2GetIntegerStatus(fmi2Component, fmi2StatusKind, fmi2Integer *);
FMI2_FUNCTION fmi2Status fmi2GetBooleanStatus(fmi2Component, fmi2StatusKind, fmi2Boolean *);
FMI2_FUNCTION fmi2Status fmi2GetStringStatus(fmi2Component, fmi2StatusKind, fmi2String *);

/* Model exchange. */
typedef struct fmi2EventInfo {
    fmi2Boolean newDiscreteStatesNeeded;
    fmi2Boolean terminateSimulation;
    fmi2Boolean nominalsOfContinuousStatesChanged;
    fmi2Boolean valuesOfContinuousStatesChanged;
    fmi2Boolean nextEventTimeDefined;
    fmi2Real nextEventTime;
} fmi2EventInfo;
FMI2_FUNCTION fmi2Status fmi2EnterEventMode(fmi2Component);
FMI2_FUNCTION fmi2Status fmi2NewDiscreteStates(fmi2Component, fmi2EventInfo *);
FMI2_FUNCTION fmi2Status fmi2EnterContinuousTimeMode(fmi2Component);
FMI2_FUNCTION fmi2Status fmi2CompletedIntegratorStep(fmi2Component, fmi2Boolean no_state_before,
                                                     fmi2Boolean *enter_event, fmi2Boolean *terminate);
FMI2_FUNCTION fmi2Status fmi2SetTime(fmi2Component, fmi2Real time);
FMI2_FUNCTION fmi2Status fmi2SetContinuousStates(fmi2Component, const fmi2Real state[], size_t n);
FMI2_FUNCTION fmi2Status fmi2GetDerivatives(fmi2Component, fmi2Real derivative[], size_t n);
FMI2_FUNCTION fmi2Status fmi2GetEventIndicators(fmi2Component, fmi2Real indicator[], size_t n);
FMI2_FUNCTION fmi2Status fmi2GetContinuousStates(fmi2Component, fmi2Real state[], size_t n);
FMI2_FUNCTION fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component, fmi2Real nominal[], size_t n);

#endif
