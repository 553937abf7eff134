/* Cases far from the usual that once went wrong without a word: each runs well now, or says what is the matter. */
#include "tests/io/case_fixture.h"

/* Whether an event of the run says so; at most once. */
static int says(const hawser_sim *sim, const char *part)
{
    const hawser_event *event;
    const int n = hawser_sim_events(sim, &event);
    int count = 0;
    for (int i = 0; i < n; ++i) count += strstr(event[i].what, part) != NULL;
    check_at_most(count, 1);
    return count;
}

/* In free fall steps are as long as they may be; they may not be longer than a roller is thick (N14). Row and cable are
 * in one plane, or solved in space. */
TEST(test_falls_on_rollers)
{
    static const char *const planar[] = {"auto", "off"};
    for (int k = 0; k < 2; ++k) {
        const char *const settings[] = {"solver.planar", planar[k], NULL};
        hawser_sim *const sim = run_of(data_text("stress-fall"), settings);
        hawser_summary s;
        hawser_sim_summary(sim, &s);
        print_message("middle at z = %.3f m after %ld steps\n", s.probes[0].position[2], s.steps);
        check_above(s.probes[0].position[2], -4.5); /* past the rollers it would be at -4.9 m */
        check_above(s.contact_active_max, 0);
        hawser_sim_free(sim);
    }
}

/* A rod of 20 segments turned at its head: past half a turn a joint its torque is wrong, and the run says so. */
TEST(test_joint_turned)
{
    for (int many = 0; many < 2; ++many) {
        const char *const settings[] = {"rod.head.motion.0.turn", many ? "4000 deg" : "2000 deg", NULL};
        hawser_sim *const sim = run_of(data_text("stress-turned-rod"), settings);
        assert_int_equal(says(sim, "a joint is turned"), many);
        hawser_sim_free(sim);
    }
}

/* An axial grip pulls along its line: a limp cable's head drooped there by more than 30 degrees, and the pull with it.
 */
TEST(test_head_turned)
{
    for (int limp = 0; limp < 2; ++limp) {
        const char *const settings[] = {"cables.a.EI", limp ? "500 N m2" : "16.4 kN m2", NULL};
        hawser_sim *const sim = run_of(data_text("stress-limp-head"), settings);
        assert_int_equal(says(sim, "the head is turned"), 0);
        hawser_sim_free(sim);
    }
}

/* Stiff in bending, in short segments: rounding of its rotations is what is left of the forces (E6). */
TEST(test_short_stiff_rod)
{
    hawser_sim *const sim = run_of(data_text("stress-stiff-rod"), NULL);
    hawser_summary s;
    hawser_sim_summary(sim, &s);
    assert_true(s.relaxation.reached);
    check_below(s.relaxation.tolerance_N, 1e-3); /* of 40 N */
    hawser_sim_free(sim);
}

/* The smooth line has no nearest point on a drum that it is wrapped around (C6): the failure says what does. */
TEST(test_wrapped_smooth)
{
    hawser_error err = {0};
    hawser_sim *const sim = sim_of(data_text("stress-wrapped"), NULL);
    assert_int_equal(hawser_sim_run(sim, NULL, NULL, NULL, &err), HAWSER_ERR_RUN);
    check_has(err.message, "needs contact.geometry: cylinder");
    hawser_sim_free(sim);
}

/* An end that is led 169 parts of a way, from the 11th of which on none has an equilibrium: the relaxation ends there.
 */
TEST(test_led_too_far)
{
    hawser_error err = {0};
    hawser_relaxation found;
    hawser_sim *const sim = sim_of(data_text("stress-led-far"), NULL);
    if (hawser_sim_relax(sim, &found, &err)) fail_msg("%s", err.message);
    print_message("%d iterations\n", found.iterations);
    assert_false(found.reached);
    check_at_most(found.iterations, 10000); /* 90 578 with all parts */
    check_close(found.moved_m, 0, 1e-12);
    hawser_sim_free(sim);
}

/* A bar whose ways to buckle lie so close together that its modes do not settle: the run says where, and what may help.
 */
TEST(test_modes_too_close)
{
    hawser_error err = {0};
    hawser_sim *const sim = sim_of(data_text("stress-modes"), NULL);
    assert_int_equal(hawser_sim_run(sim, NULL, NULL, NULL, &err), HAWSER_ERR_RUN);
    check_has(err.message, "at t = 0 s the rod stops being stable");
    check_has(err.message, "run.load_steps may help");
    hawser_sim_free(sim);
}
