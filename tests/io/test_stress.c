/* Cases far from the usual that once went wrong without a word: each runs well now, or says what is the matter. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "hawser/hawser.h"
#include "tests/support/check.h"

#define CABLE "cables: {a: {d: 87.3 mm, EA: 688 MN, GA: 248 MN, GJ: 23.7 kN m2, EI: 16.4 kN m2, mass: 22 kg/m}}\n"
#define ROW   "route: {head_at: 21.25 m, pieces: [{straight: 25 m}]}\n"

/* Builds a text with settings ("key", "value", ..., NULL), or NULL. */
static hawser_sim *sim_of(const char *text, const char *const *settings)
{
    hawser_error err = {0};
    hawser_case *c = NULL;
    hawser_sim *sim = NULL;
    if (hawser_case_parse(text, "stress.yaml", &c, &err)) fail_msg("%s", err.message);
    for (int i = 0; settings && settings[i]; i += 2) {
        if (hawser_case_set(c, settings[i], settings[i + 1], &err)) fail_msg("%s", err.message);
    }
    if (hawser_sim_new(c, NULL, &sim, &err)) fail_msg("%s", err.message);
    hawser_case_free(c);
    return sim;
}

static hawser_sim *run(const char *text, const char *const *settings)
{
    hawser_error err = {0};
    hawser_sim *const sim = sim_of(text, settings);
    if (hawser_sim_run(sim, NULL, NULL, NULL, &err)) fail_msg("%s", err.message);
    return sim;
}

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
static void test_falls_on_rollers(void **state)
{
    (void)state;
    static const char *const planar[] = {"auto", "off"};
    for (int k = 0; k < 2; ++k) {
        const char *const settings[] = {"solver.planar", planar[k], NULL};
        hawser_sim *const sim =
            run(CABLE ROW "chain: [{cable: a, length: 20 m}]\n"
                          "rollers: {list: [{centre: [2, 0, -3.15], axis: [0, 1, 0]}, {centre: [8, 0, -3.15], "
                          "axis: [0, 1, 0]}, {centre: [14, 0, -3.15], axis: [0, 1, 0]}, {centre: [20, 0, "
                          "-3.15], axis: [0, 1, 0]}]}\n"
                          "solver: {relax: false}\nrun: {duration: 1 s}\n"
                          "output: {probes: [{name: middle, at: 10 m}]}\n",
                settings);
        hawser_summary s;
        hawser_sim_summary(sim, &s);
        print_message("middle at z = %.3f m after %ld steps\n", s.probes[0].position[2], s.steps);
        check_above(s.probes[0].position[2], -4.5); /* past the rollers it would be at -4.9 m */
        check_above(s.contact_active_max, 0);
        hawser_sim_free(sim);
    }
}

/* A rod of 20 segments turned at its head: past half a turn a joint its torque is wrong, and the run says so. */
static void test_joint_turned(void **state)
{
    (void)state;
    static const char rod[] =
        "gravity: 0\n"
        "cables: {a: {d: 30 mm, EA: 10 MN, GA: 4 MN, GJ: 40 N m2, EI: 1 kN m2, mass: 5 kg/m}}\n"
        "chain: [{cable: a, length: 10 m, segment: 500 mm}]\n"
        "rod: {tail: {fixing: clamped}, head: {fixing: held, hold: [torsion, shear_y, shear_z, bending_y, bending_z], "
        "motion: [{direction: [1, 0, 0], turn: 1 deg, ramp: step, from: 0, to: 1 s}]}, "
        "loads: [{direction: [1, 0, 0], force: 50 kN}]}\n"
        "run: {duration: 1 s}\n";
    for (int many = 0; many < 2; ++many) {
        const char *const settings[] = {"rod.head.motion.0.turn", many ? "4000 deg" : "2000 deg", NULL};
        hawser_sim *const sim = run(rod, settings);
        assert_int_equal(says(sim, "a joint is turned"), many);
        hawser_sim_free(sim);
    }
}

/* A limp cable's head droops on an axial grip, and the pull with it. */
static void test_head_turned(void **state)
{
    (void)state;
    static const char text[] = CABLE ROW "chain: [{cable: a, length: 20 m}]\n"
                                         "rollers: {along: {from: 0, to: 25 m, spacing: 2 m}}\n"
                                         "drive: {winch: {speed: 0.1 m/s, grip: axial}, tail: {tension: 5 kN, ramp: "
                                         "none}}\n"
                                         "run: {duration: 2 s}\n";
    for (int limp = 0; limp < 2; ++limp) {
        const char *const settings[] = {"cables.a.EI", limp ? "500 N m2" : "16.4 kN m2", NULL};
        hawser_sim *const sim = run(text, settings);
        assert_int_equal(says(sim, "the head is turned"), limp);
        hawser_sim_free(sim);
    }
}

/* Stiff in bending, in short segments: rounding of its rotations is what is left of the forces (E6). */
static void test_short_stiff_rod(void **state)
{
    (void)state;
    hawser_sim *const sim =
        run("gravity: 9.81 m/s2\n"
            "cables: {a: {d: 22.9 mm, EA: 60.6 kN, GA: 10 kN, GJ: 9.6 kN m2, EI: 401 kN m2, mass: "
            "7.95 kg/m}}\n"
            "chain: [{cable: a, length: 516 mm, segment: 9.56 mm}]\n"
            "rod: {heading: 68 deg, slope: 28 deg, tail: {fixing: pinned}, head: {fixing: clamped}}\n"
            "solver: {planar: off}\n"
            "run: {analysis: static}\n",
            NULL);
    hawser_summary s;
    hawser_sim_summary(sim, &s);
    assert_true(s.relaxation.reached);
    check_below(s.relaxation.tolerance_N, 1e-3); /* of 40 N */
    hawser_sim_free(sim);
}

/* The smooth line has no nearest point on a drum that it is wrapped around (C6): the failure says what does. */
static void test_wrapped_smooth(void **state)
{
    (void)state;
    hawser_error err = {0};
    hawser_sim *const sim =
        sim_of("gravity: 0\n"
               "cables: {a: {d: 30 mm, EA: 5 MN, GA: 2 MN, GJ: 5 N m2, EI: 5 N m2, mass: 2 kg/m}}\n"
               "chain: [{cable: a, length: 4.8 m, segment: 125 mm}]\n"
               "route: {head_at: 5.3 m, pieces: [{straight: 2.5 m}, {bend: 90 deg, radius: 515 mm, plane: right}, "
               "{straight: 3.5 m}]}\n"
               "rollers: {list: [{centre: [2.5, -0.515, 0], axis: [0, 0, 1], radius: 500 mm, width: 1 m}]}\n"
               "drive: {winch: {speed: 0.1 m/s}, tail: {tension: 500 N, ramp: none}}\n"
               "solver: {max_steps: 2000}\nrun: {duration: 3 s}\n",
               NULL);
    assert_int_equal(hawser_sim_run(sim, NULL, NULL, NULL, &err), HAWSER_ERR_RUN);
    assert_non_null(strstr(err.message, "needs contact.geometry: cylinder"));
    hawser_sim_free(sim);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_falls_on_rollers), cmocka_unit_test(test_joint_turned),
        cmocka_unit_test(test_head_turned),      cmocka_unit_test(test_short_stiff_rod),
        cmocka_unit_test(test_wrapped_smooth),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
