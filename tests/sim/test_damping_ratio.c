/* Damping ratios against the logarithmic decrement of one mode: two free segments that swing against each other in one
 * component of the joint between them. */
#include "tests/support/rig.h"

enum { N = 2, SIZE = STATE_SIZE * N, SWINGS = 4 };

/* Two segments of 0.5 m, weightless; ratio in component c (0 axial, 1, 2 shear, 3 torsion, 4, 5 bending), at a
 * frequency or (0) in the joint's own mode. */
static Rig *rig_new(int c, double ratio, double at)
{
    SceneDef def;
    fixture_free_chain(&def, N);
    def.cables[0].damping_ratio[c] = ratio;
    def.cables[0].damping_ratio_at = at;
    def.solver.accuracy = 1e-7;
    def.solver.max_order = 5;
    return rig_make(&def, NULL);
}

/* Sets the two segments moving against each other in component c, by a little. In shear both turn the same way, as the
 * shear force turns them. */
static void push(Rig *r, int c)
{
    const double speed = 1e-2, half = r->scene.chain.half[0];
    for (int i = 0; i < N; ++i) {
        const double sign = i == 0 ? -1 : 1;
        if (c < 3) r->y[(STATE_V + c) * N + i] = sign * speed;
        if (c >= 3) r->y[(STATE_W + c - 3) * N + i] = sign * speed;
    }
    const double turn = speed * half * r->scene.chain.mass[0];
    if (c == 1) r->y[(STATE_W + 2) * N] = r->y[(STATE_W + 2) * N + 1] = -turn / r->scene.chain.inertia[2][0];
    if (c == 2) r->y[(STATE_W + 1) * N] = r->y[(STATE_W + 1) * N + 1] = turn / r->scene.chain.inertia[1][0];
}

/* Rate of the deformation's own component, of the second segment. */
static double rate_of(const Rig *r, int c) { return r->y[(c < 3 ? STATE_V + c : STATE_W + c - 3) * N + 1]; }

/* Angular frequency of the undamped mode from stiffness and mobility, rad/s, by hand: equal segments (HY11). */
static double omega_of(const Rig *r, int c)
{
    const Chain *const chain = &r->scene.chain;
    const CableDef *const cable = &r->scene.def.cables[0];
    const double rigidity[6] = {cable->ea, cable->ga, cable->ga, cable->gj, cable->ei_y, cable->ei_z};
    const double m = chain->mass[0], arm = 0.25 * 0.25;
    const double mobility[6] = {1 / m,
                                1 / m + arm / chain->inertia[2][0],
                                1 / m + arm / chain->inertia[1][0],
                                1 / chain->inertia[0][0],
                                1 / chain->inertia[1][0],
                                1 / chain->inertia[2][0]};
    return sqrt(rigidity[c] / 0.5 * 2 * mobility[c]);
}

/* The ratio to critical damping that a decrement from one half swing to the next stands for. */
static double ratio_of(double decrement) { return decrement / sqrt(M_PI * M_PI + decrement * decrement); }

/* What the motion shows: the rate's extremes become smaller by the same factor every half swing. */
static double ratio_seen(Rig *r, int c)
{
    hawser_error err = {0};
    Integrator *in = NULL;
    double t = 0, before, peak[2 * SWINGS + 1] = {0};
    r->scene.def.solver.max_step = 2 * M_PI / omega_of(r, c) / 400;
    push(r, c);
    before = rate_of(r, c);
    if (integrator_new(rig_motion(r), 0, r->y, &in, &err)) {
        fail_msg("%s", err.message);
    }
    for (int n = 0; n <= 2 * SWINGS;) {
        if (integrator_step(in, 1e3, &t, &err)) fail_msg("%s", err.message);
        const double rate = rate_of(r, c);
        peak[n] = larger_of(peak[n], fabs(rate));
        n += before > 0 ? rate <= 0 : rate > 0;
        before = rate;
    }
    integrator_free(in);
    return ratio_of(log(peak[1] / peak[2 * SWINGS]) / (2 * SWINGS - 1));
}

/* In every component, lightly and strongly damped, in the joint's own mode (HY12). */
TEST(test_own_mode)
{
    const double ratio[] = {0.02, 0.2};
    for (int c = 0; c < 6; ++c) {
        for (int k = 0; k < 2; ++k) {
            Rig *const r = rig_new(c, ratio[k], 0);
            const double seen = ratio_seen(r, c);
            check_share(seen, ratio[k], 5e-4);
            rig_free(r);
        }
    }
}

/* At twice the mode's frequency the mode has half the ratio (HY10). */
TEST(test_at_frequency)
{
    for (int c = 0; c < 6; ++c) {
        Rig *r = rig_new(c, 0.1, 1);
        const double frequency = omega_of(r, c) / (2 * M_PI);
        rig_free(r);
        r = rig_new(c, 0.1, 2 * frequency);
        const double seen = ratio_seen(r, c);
        check_close(seen, 0.05, 5e-5);
        rig_free(r);
    }
}

/* A component without a ratio keeps its damping time: C = time * factor * K; of two cables each keeps its own way. */
TEST(test_beside_time)
{
    SceneDef def;
    Scene scene;
    fixture_pull(&def, &(FixtureChoice){0});
    def.cables[0].damping_ratio[0] = 0.03;
    def.cables[0].damping_ratio_at = 10;
    fixture_build(&def, &scene);
    const Chain *const c = &scene.chain;
    const int eye = FIXTURE_CABLE;
    const double ka = 5e7 / 0.25, kb = 2.5e6 / 0.25, k = ka * kb / (ka + kb), beta = 0.03 / (M_PI * 10);
    check_share(c->damping[0][3] / (ka / 2), beta, 1e-12);
    check_close(c->damping[1][3] / c->stiffness[1][3], 2e-3, 1e-14);
    check_close(c->damping[0][eye + 2] / c->stiffness[0][eye + 2], 2e-3, 1e-14);
    check_share(c->damping[0][eye], k * k * (beta / ka + 2e-3 / kb), 1e-12);
    scene_clear(&scene);
}
