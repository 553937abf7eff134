/* Every function of the standard's lists (fmi2Functions.h of 2.0.4, fmi3Functions.h of 3.0.1) is there: importers look
 * all of them up when they load a library. A unit that lacked those of model exchange and scheduled execution, 10 of
 * version 2.0 and 11 of 3.0, was refused by FMPy and by the importer of the Reference-FMUs. */
#include <dlfcn.h>
#include <string.h>

#include "tests/fmi/fixture.h"

static const char *const functions2[] = {
    "fmi2CancelStep",
    "fmi2CompletedIntegratorStep",
    "fmi2DeSerializeFMUstate",
    "fmi2DoStep",
    "fmi2EnterContinuousTimeMode",
    "fmi2EnterEventMode",
    "fmi2EnterInitializationMode",
    "fmi2ExitInitializationMode",
    "fmi2FreeFMUstate",
    "fmi2FreeInstance",
    "fmi2GetBoolean",
    "fmi2GetBooleanStatus",
    "fmi2GetContinuousStates",
    "fmi2GetDerivatives",
    "fmi2GetDirectionalDerivative",
    "fmi2GetEventIndicators",
    "fmi2GetFMUstate",
    "fmi2GetInteger",
    "fmi2GetIntegerStatus",
    "fmi2GetNominalsOfContinuousStates",
    "fmi2GetReal",
    "fmi2GetRealOutputDerivatives",
    "fmi2GetRealStatus",
    "fmi2GetStatus",
    "fmi2GetString",
    "fmi2GetStringStatus",
    "fmi2GetTypesPlatform",
    "fmi2GetVersion",
    "fmi2Instantiate",
    "fmi2NewDiscreteStates",
    "fmi2Reset",
    "fmi2SerializeFMUstate",
    "fmi2SerializedFMUstateSize",
    "fmi2SetBoolean",
    "fmi2SetContinuousStates",
    "fmi2SetDebugLogging",
    "fmi2SetFMUstate",
    "fmi2SetInteger",
    "fmi2SetReal",
    "fmi2SetRealInputDerivatives",
    "fmi2SetString",
    "fmi2SetTime",
    "fmi2SetupExperiment",
    "fmi2Terminate",
};
static const char *const functions3[] = {
    "fmi3ActivateModelPartition",
    "fmi3CompletedIntegratorStep",
    "fmi3DeserializeFMUState",
    "fmi3DoStep",
    "fmi3EnterConfigurationMode",
    "fmi3EnterContinuousTimeMode",
    "fmi3EnterEventMode",
    "fmi3EnterInitializationMode",
    "fmi3EnterStepMode",
    "fmi3EvaluateDiscreteStates",
    "fmi3ExitConfigurationMode",
    "fmi3ExitInitializationMode",
    "fmi3FreeFMUState",
    "fmi3FreeInstance",
    "fmi3GetAdjointDerivative",
    "fmi3GetBinary",
    "fmi3GetBoolean",
    "fmi3GetClock",
    "fmi3GetContinuousStateDerivatives",
    "fmi3GetContinuousStates",
    "fmi3GetDirectionalDerivative",
    "fmi3GetEventIndicators",
    "fmi3GetFMUState",
    "fmi3GetFloat32",
    "fmi3GetFloat64",
    "fmi3GetInt16",
    "fmi3GetInt32",
    "fmi3GetInt64",
    "fmi3GetInt8",
    "fmi3GetIntervalDecimal",
    "fmi3GetIntervalFraction",
    "fmi3GetNominalsOfContinuousStates",
    "fmi3GetNumberOfContinuousStates",
    "fmi3GetNumberOfEventIndicators",
    "fmi3GetNumberOfVariableDependencies",
    "fmi3GetOutputDerivatives",
    "fmi3GetShiftDecimal",
    "fmi3GetShiftFraction",
    "fmi3GetString",
    "fmi3GetUInt16",
    "fmi3GetUInt32",
    "fmi3GetUInt64",
    "fmi3GetUInt8",
    "fmi3GetVariableDependencies",
    "fmi3GetVersion",
    "fmi3InstantiateCoSimulation",
    "fmi3InstantiateModelExchange",
    "fmi3InstantiateScheduledExecution",
    "fmi3Reset",
    "fmi3SerializeFMUState",
    "fmi3SerializedFMUStateSize",
    "fmi3SetBinary",
    "fmi3SetBoolean",
    "fmi3SetClock",
    "fmi3SetContinuousStates",
    "fmi3SetDebugLogging",
    "fmi3SetFMUState",
    "fmi3SetFloat32",
    "fmi3SetFloat64",
    "fmi3SetInt16",
    "fmi3SetInt32",
    "fmi3SetInt64",
    "fmi3SetInt8",
    "fmi3SetIntervalDecimal",
    "fmi3SetIntervalFraction",
    "fmi3SetShiftDecimal",
    "fmi3SetShiftFraction",
    "fmi3SetString",
    "fmi3SetTime",
    "fmi3SetUInt16",
    "fmi3SetUInt32",
    "fmi3SetUInt64",
    "fmi3SetUInt8",
    "fmi3Terminate",
    "fmi3UpdateDiscreteStates",
};

static int missing(const Fmu *fmu, const char *const name[], size_t n)
{
    int lacking = 0;
    for (size_t k = 0; k < n; ++k) lacking += !dlsym(fmu->library, name[k]);
    return lacking;
}

TEST(test_functions)
{
    enum { FUNCTIONS_2 = sizeof functions2 / sizeof *functions2, FUNCTIONS_3 = sizeof functions3 / sizeof *functions3 };
    Fmu fmu;
    fmu_of(&fmu, data_text("cli-pull"), 3);
    assert_int_equal(FUNCTIONS_2, 44);
    assert_int_equal(FUNCTIONS_3, 75);
    assert_int_equal(missing(&fmu, functions2, FUNCTIONS_2), 0); /* 10 were */
    assert_int_equal(missing(&fmu, functions3, FUNCTIONS_3), 0); /* 11 were */
    fmu_close(&fmu);
}

/* What the description does not offer fails with a message that names the call: the calls of version 3.0 that were
 * there failed without a word. After it the instance can be reset. */
TEST(test_denied)
{
    size_t n = 7;
    unsigned reference = 0;
    double value = 0;
    fmi2EventInfo info;
    for (int version = 2; version <= 3; ++version) {
        Fmu fmu;
        fmu_of(&fmu, data_text("cli-pull"), version);
        FmuInstance *const i = instance_of(&fmu);
        if (version == 2) {
            assert_int_equal(FMU_CALL(&fmu, fmi2NewDiscreteStates)(i->c, &info), fmi2Error);
            check_has(i->said, "fmi2NewDiscreteStates is not provided");
        } else {
            assert_int_equal(FMU_CALL(&fmu, fmi3GetNumberOfContinuousStates)(i->c, &n), fmi3Error);
            check_has(i->said, "fmi3GetNumberOfContinuousStates is not provided");
            assert_int_equal(FMU_CALL(&fmu, fmi3ActivateModelPartition)(NULL, 0, 0), fmi3Error);
            assert_int_equal(instance_reset(i), 0);
            assert_int_equal(
                FMU_CALL(&fmu, fmi3GetDirectionalDerivative)(i->c, &reference, 1, &reference, 1, &value, 1, &value, 1),
                fmi3Error);
            check_has(i->said, "fmi3GetDirectionalDerivative is not provided");
        }
        assert_int_equal(instance_reset(i), 0);
        assert_int_equal(instance_begin(i, 0), 0);
        instance_drop(i);
        fmu_close(&fmu);
    }
}

/* Outputs depend on no input of the same time, as the description says: to the last bit. */
TEST(test_no_feedthrough)
{
    Fmu fmu;
    fmu_of(&fmu, data_text("limits-conveyor"), 3);
    FmuInstance *const i = instance_of(&fmu);
    step_to(i, 0.1);
    double *const before = calloc((size_t)fmu.n, sizeof *before);
    int inputs = 0, outputs = 0;
    for (int k = 0; k < fmu.n; ++k)
        if (!strcmp(fmu.variable[k].causality, "output") && !strcmp(fmu.variable[k].type, "Float64"))
            before[k] = instance_value(i, fmu.variable[k].name);
    for (int k = 0; k < fmu.n; ++k) {
        const FmuVariable *const v = &fmu.variable[k];
        if (strcmp(v->causality, "input") != 0 || strcmp(v->type, "Float64") != 0) continue;
        assert_int_equal(instance_set(i, v->name, 0.9 * instance_value(i, v->name)), 0);
        ++inputs;
    }
    for (int k = 0; k < fmu.n; ++k) {
        if (strcmp(fmu.variable[k].causality, "output") != 0 || strcmp(fmu.variable[k].type, "Float64") != 0) continue;
        const double now = instance_value(i, fmu.variable[k].name);
        if (memcmp(&now, &before[k], sizeof now) != 0) fail_msg("%s follows an input at once", fmu.variable[k].name);
        ++outputs;
    }
    assert_true(inputs >= 2 && outputs >= 5);
    free(before);
    instance_drop(i);
    fmu_close(&fmu);
}
