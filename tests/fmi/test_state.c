/* States of an instance: what follows one is what followed it before, bit for bit, also in another instance, from
 * bytes, and with other parameters; bytes that are none are refused. Where the library cannot save, the description
 * says so. */
#include <math.h>
#include <string.h>

#include "tests/fmi/fixture.h"

enum { LOOKS = 10 };

/* The version of a call that fits the archive. */
#define STATE_CALL(i, TWO, THREE, ...)                                                                                 \
    ((i)->fmu->version == 2 ? (int)FMU_CALL((i)->fmu, fmi2##TWO)((i)->c, __VA_ARGS__)                                  \
                            : (int)FMU_CALL((i)->fmu, fmi3##THREE)((i)->c, __VA_ARGS__))
#define state_get(i, state)  STATE_CALL(i, GetFMUstate, GetFMUState, state)
#define state_set(i, state)  STATE_CALL(i, SetFMUstate, SetFMUState, state)
#define state_free(i, state) STATE_CALL(i, FreeFMUstate, FreeFMUState, state)

/* Steps of 0.1 s with a speed that is told now and then; force and margin after each. */
static void go_on(FmuInstance *i, double seen[2 * LOOKS])
{
    for (int k = 0; k < LOOKS; ++k) {
        if (k % 3 == 0) assert_int_equal(instance_set(i, "winch.speed", 0.1 + 0.01 * k), 0);
        step_to(i, instance_value(i, "time") + 0.1);
        seen[2 * k] = instance_value(i, "winch.force");
        seen[2 * k + 1] = instance_value(i, "pull.peak");
    }
}

static void check_same(const double *a, const double *b)
{
    for (int k = 0; k < 2 * LOOKS; ++k) check_equal(a[k], b[k]);
}

/* The first number of that value among the bytes becomes another. */
static void number_change(unsigned char *bytes, size_t size, double from, double to)
{
    size_t at = 0;
    while (at + sizeof from <= size && memcmp(bytes + at, &from, sizeof from) != 0) at += sizeof from;
    assert_true(at + sizeof from <= size);
    memcpy(bytes + at, &to, sizeof to);
}

/* 1 if the archive says that it cannot, and it does not. */
static int cannot(FmuInstance *i)
{
    void *state = NULL;
    if (strcmp(i->fmu->save, "true") == 0) return 0;
    assert_int_equal(state_get(i, &state), 2);
    assert_null(state);
    return 1;
}

TEST(test_there_and_back)
{
    for (int version = 2; version <= 3; ++version) {
        Fmu fmu;
        double first[2 * LOOKS], again[2 * LOOKS];
        void *begin = NULL, *middle = NULL;
        fmu_of(&fmu, data_text("short-pull"), version);
        FmuInstance *const i = instance_of(&fmu);
        if (!cannot(i)) {
            assert_int_equal(state_get(i, &begin), 0);
            step_to(i, 0.7);
            assert_int_equal(instance_switch(i, "winch.brake", 1), 0);
            step_to(i, 0.75); /* in the middle of the brake's ramp */
            assert_int_equal(instance_switch(i, "winch.brake", 0), 0);
            assert_int_equal(state_get(i, &middle), 0);
            go_on(i, first);
            assert_int_equal(state_set(i, middle), 0);
            check_equal(instance_value(i, "time"), 0.75);
            go_on(i, again);
            check_same(first, again);
            assert_int_equal(instance_end(i), 0);
            assert_int_equal(state_set(i, begin), 0); /* from before all that */
            check_equal(instance_value(i, "time"), 0);
            go_on(i, first);
            assert_int_equal(instance_reset(i), 0);
            assert_int_equal(instance_begin(i, 0), 0);
            assert_int_equal(instance_settle(i), 0);
            go_on(i, again);
            check_same(first, again);
            assert_int_equal(state_free(i, &begin), 0);
            assert_int_equal(state_free(i, &middle), 0);
            assert_null(begin);
        }
        instance_drop(i);
        fmu_close(&fmu);
    }
}

/* A state of before the start begins at the start, wherever the instance has come to with the same parameters. */
TEST(test_before_the_start)
{
    for (int version = 2; version <= 3; ++version) {
        Fmu fmu;
        FmuInstance i;
        double first[2 * LOOKS], again[2 * LOOKS];
        void *early = NULL;
        fmu_of(&fmu, data_text("short-pull"), version);
        instance_new(&i, &fmu, fmu.token, fmu.resources);
        if (!cannot(&i)) {
            assert_int_equal(state_get(&i, &early), 0);
            for (int k = 0; k < 2; ++k) {
                if (k > 0) assert_int_equal(state_set(&i, early), 0);
                assert_int_equal(instance_begin(&i, 0), 0);
                assert_int_equal(instance_settle(&i), 0);
                go_on(&i, k ? again : first);
            }
            check_same(first, again);
            assert_int_equal(state_free(&i, &early), 0);
        }
        instance_free(&i);
        fmu_close(&fmu);
    }
}

/* Into another instance that was built with other parameters. */
TEST(test_bytes)
{
    for (int version = 2; version <= 3; ++version) {
        Fmu fmu;
        FmuInstance i;
        double first[2 * LOOKS], again[2 * LOOKS];
        void *taken = NULL, *given = NULL;
        size_t size = 0;
        fmu_of(&fmu, data_text("short-pull"), version);
        FmuInstance *const other = instance_of(&fmu);
        instance_new(&i, &fmu, fmu.token, fmu.resources);
        assert_int_equal(instance_set(&i, "case.friction.mu", 0.25), 0);
        assert_int_equal(instance_begin(&i, 0), 0);
        assert_int_equal(instance_settle(&i), 0);
        if (!cannot(&i)) {
            step_to(&i, 0.5);
            assert_int_equal(state_get(&i, &taken), 0);
            assert_int_equal(STATE_CALL(&i, SerializedFMUstateSize, SerializedFMUStateSize, taken, &size), 0);
            unsigned char *const bytes = malloc(size);
            assert_non_null(bytes);
            assert_int_equal(STATE_CALL(&i, SerializeFMUstate, SerializeFMUState, taken, (void *)bytes, size), 0);
            assert_int_equal(STATE_CALL(&i, SerializeFMUstate, SerializeFMUState, taken, (void *)bytes, size - 1), 3);
            go_on(&i, first);
            assert_int_equal(STATE_CALL(other, DeSerializeFMUstate, DeserializeFMUState, (void *)bytes, size, &given),
                             0);
            assert_int_equal(state_set(other, given), 0);
            check_equal(instance_value(other, "case.friction.mu"), 0.25);
            go_on(other, again);
            check_same(first, again);
            assert_int_equal(state_free(other, &given), 0);
            for (size_t cut = 0; cut < size; cut += size / 7 + 1)
                assert_int_equal(
                    STATE_CALL(other, DeSerializeFMUstate, DeserializeFMUState, (void *)bytes, cut, &given), 2);
            number_change(bytes, size, 0.25, NAN); /* of friction.mu: what no call sets no state has */
            assert_int_equal(STATE_CALL(other, DeSerializeFMUstate, DeserializeFMUState, (void *)bytes, size, &given),
                             2);
            number_change(bytes, size, NAN, 0.25);
            bytes[0] ^= 1;
            assert_int_equal(STATE_CALL(other, DeSerializeFMUstate, DeserializeFMUState, (void *)bytes, size, &given),
                             2);
            free(bytes);
            assert_int_equal(state_free(&i, &taken), 0);
        }
        instance_free(&i);
        instance_drop(other);
        fmu_close(&fmu);
    }
}
