/* The order in which an instance may be asked, by both versions of the standard: what comes out of turn is an error,
 * after which it can be reset or freed; values that cannot be are refused and change nothing. */
#include "tests/fmi/fixture.h"

enum { OK = 0, DISCARD = 2, ERROR = 3 };

/* Both versions of the same pull. */
typedef struct Both {
    Fmu fmu[2];
} Both;

static int both_open(void **state)
{
    Both *const both = calloc(1, sizeof *both);
    for (int v = 0; v < 2; ++v) fmu_of(&both->fmu[v], data_text("cli-pull"), 2 + v);
    *state = both;
    return 0;
}

static int both_close(void **state)
{
    Both *const both = *state;
    for (int v = 0; v < 2; ++v) fmu_close(&both->fmu[v]);
    free(both);
    return 0;
}

/* An instance that has done nothing yet. */
static FmuInstance *fresh(const Fmu *fmu)
{
    FmuInstance *const i = calloc(1, sizeof *i);
    instance_new(i, fmu, fmu->token, fmu->resources);
    if (!i->c) fail_msg("%s", i->said);
    return i;
}

TEST(test_instantiation)
{
    const Both *const both = *state;
    for (int v = 0; v < 2; ++v) {
        const Fmu *const fmu = &both->fmu[v];
        FmuInstance i;
        instance_new(&i, fmu, "another", fmu->resources);
        assert_null(i.c);
        check_has(i.said, fmu->token);
        instance_new(&i, fmu, NULL, fmu->resources);
        assert_null(i.c);
        instance_new(&i, fmu, fmu->token, NULL);
        assert_null(i.c);
        instance_new(&i, fmu, fmu->token, "http://example.org/resources");
        assert_null(i.c);
        instance_new(&i, fmu, fmu->token, "file:///nowhere%2");
        assert_null(i.c);
        instance_new(&i, fmu, fmu->token, "/nowhere/at/all");
        assert_null(i.c);
        check_has(i.said, "/nowhere/at/all");
    }
    const fmi2CallbackFunctions none = {NULL};
    const Fmu *const two = &both->fmu[0], *const three = &both->fmu[1];
    assert_null(FMU_CALL(two, fmi2Instantiate)("x", fmi2ModelExchange, two->token, two->resources, &none, 0, 0));
    assert_null(FMU_CALL(two, fmi2Instantiate)("", fmi2CoSimulation, two->token, two->resources, &none, 0, 0));
    assert_null(FMU_CALL(three, fmi3InstantiateModelExchange)("x", three->token, three->resources, 0, 0, NULL, NULL));
    assert_null(FMU_CALL(three, fmi3InstantiateCoSimulation)("x", three->token, three->resources, 0, 0, true, false,
                                                             NULL, 0, NULL, NULL, NULL));
    assert_string_equal(FMU_CALL(two, fmi2GetVersion)(), "2.0");
    assert_string_equal(FMU_CALL(two, fmi2GetTypesPlatform)(), "default");
    assert_string_equal(FMU_CALL(three, fmi3GetVersion)(), "3.0");
    FMU_CALL(two, fmi2FreeInstance)(NULL);
    FMU_CALL(three, fmi3FreeInstance)(NULL);
}

/* What may not be done yet, or no longer. Each on an instance of its own, since an error ends it. */
typedef enum Deed { SETTLE, STEP, END, READ, BEGIN, SET_PARAMETER, SET_INPUT, SET_OUTPUT, SET_TIME, DEEDS } Deed;

static int deed_do(FmuInstance *i, Deed deed)
{
    double value;
    switch (deed) {
    case SETTLE:
        return instance_settle(i);
    case STEP:
        return instance_step(i, instance_value(i, "time"), 0.1);
    case END:
        return instance_end(i);
    case READ:
        return instance_real(i, "winch.force", &value);
    case BEGIN:
        return instance_begin(i, 0);
    case SET_PARAMETER:
        return instance_set(i, "case.friction.mu", 0.3);
    case SET_INPUT:
        return instance_set(i, "winch.speed", 0.11);
    case SET_OUTPUT:
        return instance_set(i, "winch.force", 1);
    case SET_TIME:
        return instance_set(i, "time", 1);
    default:
        return OK;
    }
}

TEST(test_order)
{
    const Both *const both = *state;
    /* rows: instantiated, initializing, stepping, terminated; columns: as the deeds */
    static const int allowed[4][DEEDS] = {{0, 0, 0, 0, 1, 1, 1, 0, 0},
                                          {1, 0, 0, 1, 0, 1, 1, 0, 0},
                                          {0, 1, 1, 1, 0, 0, 1, 0, 0},
                                          {0, 0, 0, 1, 0, 0, 0, 0, 0}};
    for (int v = 0; v < 2; ++v) {
        for (int phase = 0; phase < 4; ++phase) {
            for (Deed deed = 0; deed < DEEDS; ++deed) {
                FmuInstance *const i = fresh(&both->fmu[v]);
                if (phase >= 1) assert_int_equal(instance_begin(i, 0), OK);
                if (phase >= 2) assert_int_equal(instance_settle(i), OK);
                if (phase >= 3) assert_int_equal(instance_end(i), OK);
                const int found = deed_do(i, deed);
                if (found != (allowed[phase][deed] ? OK : ERROR))
                    fail_msg("FMI %d, phase %d, deed %d: status %d: %s", v + 2, phase, (int)deed, found, i->said);
                if (found) { /* nothing goes on, until it is reset */
                    assert_int_equal(instance_step(i, 0, 0.1), ERROR);
                    check_has(i->said, "reset");
                    assert_int_equal(instance_reset(i), OK);
                    assert_int_equal(instance_begin(i, 0), OK);
                    assert_int_equal(instance_settle(i), OK);
                    assert_int_equal(instance_step(i, 0, 0.1), OK);
                }
                instance_drop(i);
            }
        }
    }
}

/* NaN and what is out of range: refused, and the value before stays. */
TEST(test_values)
{
    const Both *const both = *state;
    for (int v = 0; v < 2; ++v) {
        FmuInstance *const i = fresh(&both->fmu[v]);
        assert_int_equal(instance_set(i, "case.friction.mu", NAN), DISCARD);
        assert_int_equal(instance_set(i, "case.friction.mu", -1), DISCARD);
        check_equal(instance_value(i, "case.friction.mu"), 0.2);
        assert_int_equal(instance_begin(i, 0), OK);
        assert_int_equal(instance_settle(i), OK);
        assert_int_equal(instance_set(i, "winch.speed", NAN), DISCARD);
        check_has(i->said, "winch.speed");
        assert_int_equal(instance_set(i, "winch.speed", INFINITY), DISCARD);
        assert_int_equal(instance_set(i, "inputs.ramp", -1), DISCARD);
        check_equal(instance_value(i, "winch.speed"), 0.1);
        assert_int_equal(instance_step(i, 0, 0.5), OK);
        check_finite(instance_value(i, "winch.force"));
        assert_int_equal(instance_count(i, "events.count"), 0); /* an input that has not changed is no command */
        instance_drop(i);
    }
}

TEST(test_steps)
{
    const Both *const both = *state;
    static const double wrong[][2] = {{0.1, 0.1}, {0, 0}, {0, -1}, {0, NAN}, {NAN, 0.1}, {0, INFINITY}};
    for (int v = 0; v < 2; ++v) {
        for (size_t k = 0; k < sizeof wrong / sizeof *wrong; ++k) {
            FmuInstance *const i = instance_of(&both->fmu[v]);
            assert_int_equal(instance_step(i, wrong[k][0], wrong[k][1]), ERROR);
            instance_drop(i);
        }
        FmuInstance *const i = instance_of(&both->fmu[v]);
        assert_int_equal(instance_step(i, 0, 0.25), OK);
        assert_int_equal(instance_step(i, 0.25, 0.5), OK); /* of any length */
        check_equal(instance_value(i, "time"), 0.75);
        assert_int_equal(instance_step(i, 0.25, 0.5), ERROR); /* it has been there */
        instance_drop(i);
    }
}

/* References and types that are not there, and a stop that was named. */
TEST(test_references)
{
    const Both *const both = *state;
    const Fmu *const two = &both->fmu[0], *const three = &both->fmu[1];
    const unsigned no = 100000, force = fmu_find(two, "winch.force");
    double value;
    int count;
    FmuInstance *i = instance_of(two);
    assert_int_equal(FMU_CALL(two, fmi2GetReal)(i->c, &no, 1, &value), fmi2Error);
    instance_drop(i);
    i = instance_of(two);
    assert_int_equal(FMU_CALL(two, fmi2GetInteger)(i->c, &force, 1, &count), fmi2Error);
    instance_drop(i);
    i = instance_of(two);
    assert_int_equal(FMU_CALL(two, fmi2GetReal)(i->c, NULL, 1, NULL), fmi2Error);
    assert_int_equal(FMU_CALL(two, fmi2GetReal)(NULL, &force, 1, &value), fmi2Error);
    assert_int_equal(FMU_CALL(two, fmi2DoStep)(NULL, 0, 1, 0), fmi2Error);
    instance_drop(i);
    i = instance_of(three);
    assert_int_equal(FMU_CALL(three, fmi3GetFloat64)(i->c, &force, 1, &value, 2), fmi3Error);
    instance_drop(i);
    i = fresh(three);
    assert_int_equal(FMU_CALL(three, fmi3EnterInitializationMode)(i->c, false, 0, 0, true, 1), fmi3OK);
    assert_int_equal(instance_settle(i), OK);
    assert_int_equal(instance_step(i, 0, 1), OK);
    assert_int_equal(instance_step(i, 1, 0.5), ERROR);
    check_has(i->said, "stop");
    instance_drop(i);
}

TEST_GROUP(both_open, both_close)
