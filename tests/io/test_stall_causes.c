/* What holds a run up, cause by cause: the counts of a window are made up, the scene and its state are real. */
#include "hawser/hawser.h"
#include "io/api/api_handles.h"
#include "sim/run/stall.h"
#include "tests/io/case_fixture.h"
#include "tests/support/check.h"
#include "tests/support/data.h"

#include <math.h>
#include <string.h>

enum { STEPS = 60 };

static hawser_sim *sim_after_steps(void)
{
    hawser_error err = {HAWSER_OK, ""};
    hawser_sim *const s = sim_of(data_text("short-pull"), NULL);
    assert_int_equal(hawser_sim_relax(s, NULL, &err), HAWSER_OK);
    for (int k = 0; k < STEPS; ++k) assert_int_equal(hawser_sim_advance(s, hawser_sim_end_time(s), 1, &err), HAWSER_OK);
    return s;
}

/* What is said of a window of 500 steps with so many of each fault, that were so short, s. */
static hawser_hold hold_of(hawser_sim *s, long newton, long error, long strides, double step)
{
    const hawser_sample *const now = hawser_sim_sample(s);
    const hawser_roller *roller;
    const hawser_surface *surface;
    hawser_hold hold;
    hawser_sim_rollers(s, &roller);
    hawser_sim_surfaces(s, &surface);
    Integrator *const in = s->stage.integrator;
    StallFrom from = stall_from(in, now->t - STALL_STEPS * step);
    from.steps -= STALL_STEPS;
    from.newton_fails -= newton;
    from.error_fails -= error;
    from.strides -= strides;
    stall_cause(&from, in, now->t, 1, &hold);
    assert_int_equal(stall_by_speed(&hold), strcmp(hold.cause, "stride") == 0);
    stall_place(&s->stage.scene, 0, now, roller, surface, &hold);
    assert_int_equal(hold.steps, STALL_STEPS);
    assert_int_equal(hold.newton_fails, newton);
    assert_int_equal(hold.error_fails, error);
    assert_int_equal(hold.strides, strides);
    check_close(hold.step_s, step, 1e-9 * step + 1e-15);
    return hold;
}

TEST(each_cause)
{
    hawser_sim *const s = sim_after_steps();
    hawser_hold hold = hold_of(s, 400, 300, 0, 1e-6);
    assert_string_equal(hold.cause, "newton");
    check_has(hold.says, "Newton's iteration did not converge in 400 of 500");
    check_has(hold.says, "; worst at segment ");
    hold = hold_of(s, 300, 400, 500, 1e-6); /* what fails more often is the cause, and failures before strides */
    assert_string_equal(hold.cause, "error test");
    check_has(hold.says, "the error test was failed 400 times in 500");
    hold = hold_of(s, 0, 0, 500, 1e-6);
    assert_string_equal(hold.cause, "stride");
    check_has(hold.says, "a point of the chain may not move farther in one (N14): 500 of 500");
    check_has(hold.says, "; fastest at segment ");
    hold = hold_of(s, 0, 0, 0, 1e-6);
    assert_string_equal(hold.cause, "accuracy");
    hawser_sim_free(s);
}

/* Strides are cut for the segment that moves fastest. */
TEST(fastest)
{
    hawser_sim *const s = sim_after_steps();
    const hawser_hold hold = hold_of(s, 0, 0, 500, 1e-6);
    const hawser_sample *const now = hawser_sim_sample(s);
    double most = 0, there = 0;
    for (int i = 0; i < now->segments; ++i) {
        const double *const v = now->velocity + 3 * i, speed = hypot(hypot(v[0], v[1]), v[2]);
        most = fmax(most, speed);
        if (i == hold.segment) there = speed;
    }
    check_above(most, 0);
    check_close(there, most, 1e-12 * most);
    hawser_sim_free(s);
}
