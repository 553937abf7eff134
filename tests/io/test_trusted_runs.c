/* Runs that were called safe and are not: what the conditions of trust and the refusals did not look at. */
#include "tests/io/case_fixture.h"

/* ------------------------------------------------------------------------------------------------------- a reel */

/* 2 m of cable are wound, whose end is fastened; the winch pulls `duration` times 0.5 m/s off it. */
#define FASTENED(how, duration)                                                                                        \
    {                                                                                                                  \
        "chain", "[{cable: power, length: 16 m, segment: 1 m}, {cable: rope, length: 20 m, segment: 1 m}]",            \
            "rollers.along", "{spacing: 2 m}", "drive.winch", "{speed: 0.5 m/s, ramp: none}", "reel.end", how,         \
            "run.duration", duration, NULL, NULL                                                                       \
    }

/* A fastened end was let go by positions. */
static void positions_of_a_fastened_end(void **state)
{
    (void)state;
    static const char *const settings[][13] = {FASTENED("fixed", "8 s"), FASTENED("fixed", "3 s"),
                                               FASTENED("free", "8 s")};
    for (int k = 0; k < 3; k++) {
        hawser_error err = {0};
        hawser_sim *sim = NULL;
        hawser_case *const c = case_with(data_text("reel-payout"), settings[k]);
        assert_int_equal(hawser_case_set(c, "run.analysis", "positions", &err), HAWSER_OK);
        const hawser_status status = hawser_sim_new(c, NULL, &sim, &err);
        hawser_case_free(c);
        assert_int_equal(status, k == 0 ? HAWSER_ERR_INPUT : HAWSER_OK);
        if (k == 0) check_has(err.message, "the fastened end holds the cable from the front at 11 m on");
        hawser_sim_free(sim);
    }
}

/* So it was by positions that move a run: these leave such a pull to motion. */
static void motion_to_a_fastened_end(void **state)
{
    (void)state;
    static const char *const settings[][13] = {FASTENED("fixed", "8 s"), FASTENED("fixed", "3 s"),
                                               FASTENED("free", "8 s")};
    for (int k = 0; k < 3; k++) {
        hawser_error err = {0};
        hawser_sim *sim = NULL;
        hawser_summary sum;
        hawser_case *const c = case_with(data_text("reel-payout"), settings[k]);
        assert_int_equal(hawser_case_set(c, "solver.motion", "auto", &err), HAWSER_OK);
        assert_int_equal(hawser_case_set(c, "solver.planar", "off", &err), HAWSER_OK);
        if (hawser_sim_new(c, NULL, &sim, &err)) fail_msg("%s", err.message);
        hawser_case_free(c);
        hawser_sim_summary(sim, &sum);
        assert_non_null(sum.quasi_static);
        if (k == 0) check_has(sum.quasi_static->why, "fastened to the reel");
        if (k != 0) assert_null(sum.quasi_static->why);
        hawser_sim_free(sim);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(positions_of_a_fastened_end),
        cmocka_unit_test(motion_to_a_fastened_end),
    };
    return cmocka_run_group_tests_name("trusted runs", tests, NULL, NULL);
}
