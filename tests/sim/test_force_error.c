/* What errors of velocities are in forces, (N21)-(N24). */
#include "sim/step/force_error.h"

#include "sim/step/scales.h"
#include "tests/support/check.h"
#include "tests/support/scene.h"

enum { N = 4, PITCH = 6 };

/* A chain of 2, 2, 2 and 1 kg along x and then along y: momenta along it add up, those across it do not, and what turns
 * counts for a segment alone. */
static void test_surge(void **state)
{
    (void)state;
    Chain chain;
    assert_true(chain_alloc(&chain, N));
    double ax[N] = {1, 1, 0, 0}, ay[N] = {0, 0, 1, 1}, *const axis[2] = {ax, ay};
    double v[2 * PITCH] = {0}, w[PITCH] = {0};
    for (int i = 0; i < N; ++i) {
        chain.mass[i] = i < 3 ? 2 : 1;
        chain.half[i] = 0.3;
    }
    v[0] = v[1] = 1e-3;  /* along */
    v[PITCH + 2] = 2e-3; /* along */
    v[3] = 7e-3;         /* across */
    Surge surge = surge_of(&chain, 2, axis, PITCH, v, 1, w);
    check_close(surge.chain, 8e-3, 1e-17);
    check_close(surge.segment, 7e-3, 1e-17);
    v[PITCH + 2] = -2e-3; /* the same between two inner joints as from an end */
    surge = surge_of(&chain, 2, axis, PITCH, v, 1, w);
    check_close(surge.chain, 4e-3, 1e-17);
    w[3] = 0.24; /* 0.24 x 0.1 m beside 7 mm/s */
    check_close(surge_of(&chain, 2, axis, PITCH, v, 1, w).segment, 25e-3, 1e-16);
    chain_free(&chain);
}

/* At an accuracy of 10^-3 two thousandths, and a hundredth of that at 10^-6, of the largest of what there is, a share
 * of what was and of what is expected, and a metre of cable (N21), (N22). */
static void test_scale(void **state)
{
    (void)state;
    SceneDef def;
    Scene scene;
    fixture_pull(&def, &(FixtureChoice){0});
    fixture_build(&def, &scene);
    scene.def.solver.accuracy = 1e-3;
    scene.expected_pull = 0;
    double metre = 0;
    for (int i = 0; i + 1 < scene.chain.n; ++i) metre = fmax(metre, scene.chain.mass[i] / (2 * scene.chain.half[i]));
    check_share(force_scale(&scene, 0, 0, 0).tension, 2e-3 * 9.81 * metre, 1e-12);
    check_share(force_scale(&scene, 1e5, 2e5, 0).tension, 200, 1e-12);
    check_share(force_scale(&scene, 1e5, 1e6, 0).tension, 600, 1e-12);
    scene.expected_pull = 1e7;
    check_share(force_scale(&scene, 1e5, 1e6, 0).tension, 6e3, 1e-12);
    check_share(force_scale(&scene, 1e5, 1e6, 0).load, 1.8e3, 1e-12); /* the cable is light against it */
    scene.expected_pull = 0;
    const double heavy = 20 * 9.81 * scales_heaviest(&scene);
    check_share(force_scale(&scene, 2 * heavy, 0, 0).load, 2e-3 * heavy, 1e-12);
    check_share(force_scale(&scene, heavy / 2, 0, 0).load, 1e-3 * heavy, 1e-12);
    scene.def.solver.accuracy = 1e-6;
    check_share(force_scale(&scene, 1e5, 2e5, 0).tension, 2, 1e-12);
    scene_clear(&scene);
}

/* What is over sooner than a segment swings on its joint counts as if it took as long (N23), and so does what is over
 * before the chain, with what the iteration leaves in all its velocities, changes its tension by a twentieth of what
 * is allowed (N24). */
static void test_quick(void **state)
{
    (void)state;
    const ForceScale scale = {.tension = 5, .load = 0.4, .quick = 1e-3};
    const double gamma = 0.02;
    check_share(force_error(&(Surge){5 * gamma, 0}, &scale, gamma), 1, 1e-12);
    check_share(force_error(&(Surge){5 * gamma, 0.8 * gamma}, &scale, gamma), 2, 1e-12);
    check_share(force_error(&(Surge){5e-3, 0}, &scale, 1e-6), 1, 1e-12);
    check_close(force_error(&(Surge){1, 1}, &(ForceScale){0}, gamma), 0, 0);
    SceneDef def;
    Scene scene;
    fixture_pull(&def, &(FixtureChoice){0});
    fixture_build(&def, &scene);
    double mass = -scene.weight.weightless;
    for (int i = 0; i < scene.chain.n; ++i) mass += scene.chain.mass[i];
    const ForceScale noisy = force_scale(&scene, 1e4, 0, 1e-3);
    check_share(force_error(&(Surge){mass * 1e-3, 0}, &noisy, 1e-9), 0.05, 1e-12);
    scene_clear(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_surge), cmocka_unit_test(test_scale),
                                       cmocka_unit_test(test_quick)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
