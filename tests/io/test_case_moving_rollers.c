/* Rollers that spin or stand on mounts as cases describe them: what is read and refused, and the example cases against
 * closed forms through the public interface; with them the capstan on a drum that is fixed or turns. */
#include "tests/io/case_fixture.h"
#include "tests/io/example_fixture.h"

TEST(what_is_read)
{
    SceneDef def;
    expect_good(data_text("smallest"), "rollers",
                "{along: {count: 2, spin: {inertia: 50 g m2, bearing: {friction: 0.2, torque: 30 mN m}}}, "
                "list: [{centre: [5, 0, -3], axis: [0, 1, 0], mount: {stiffness: [1 kN/m, 2 kN/m, 3, 4 N m/rad, "
                "5, 60 N m/deg], mass: 7 kg, inertia: 0.2}}]}",
                &def);
    assert_int_equal(def.n_rollers, 3);
    const SpinDef *const spin = &def.rollers[1].spin;
    check_share(spin->inertia, 0.05, 1e-12);
    check_share(spin->friction, 0.2, 0);
    check_share(spin->journal, 0.01, 1e-12);
    check_share(spin->torque, 0.03, 1e-12);
    check_share(spin->speed, 0.01, 1e-12);
    assert_false(def.rollers[1].mount.present || def.rollers[2].spin.inertia > 0);
    const MountDef *const mount = &def.rollers[2].mount;
    const double stiffness[6] = {1e3, 2e3, 3, 4, 5, 60 * 180 / 3.14159265358979323846};
    for (int c = 0; c < 6; ++c) check_share(mount->stiffness[c], stiffness[c], 1e-12);
    assert_true(mount->present);
    check_share(mount->damping, 1e-3, 1e-12);
    check_share(mount->mass, 7, 0);
    check_share(mount->inertia, 0.2, 0);
    scene_def_clear(&def);
}

TEST(what_is_refused)
{
    static const char *const bad[][2] = {
        {"{count: 3, spin: {}}", "key 'rollers.along.spin.inertia': missing"},
        {"{count: 3, spin: {inertia: 0}}", "key 'rollers.along.spin.inertia': value '0' is out of range"},
        {"{count: 3, spin: {inertia: 1 kg}}", "has the unit 'kg', which is not that of a moment of inertia"},
        {"{count: 3, spin: {inertia: 1, bearing: {journal: 100 mm}}}",
         "key 'rollers.along.spin.bearing.journal': out of range: must be below the roller's radius, 0.1 m"},
        {"{count: 3, spin: {inertia: 1, bearing: {friction: -0.1}}}",
         "key 'rollers.along.spin.bearing.friction': value '-0.1'"},
        {"{count: 3, radius: 5 mm, spin: {inertia: 1}}", "key 'rollers.along.spin.bearing"},
        {"{count: 3, mount: {mass: 1, inertia: 1}}", "key 'rollers.along.mount.stiffness': missing"},
        {"{count: 3, mount: {stiffness: [1, 2, 3], mass: 1, inertia: 1}}", "key 'rollers.along.mount.stiffness"},
        {"{count: 3, mount: {stiffness: [1, 2, 0, 4, 5, 6], mass: 1, inertia: 1}}",
         "key 'rollers.along.mount.stiffness.2': value '0' is out of range"},
        {"{count: 3, mount: {stiffness: [1, 2, 3, 4 N/m, 5, 6], mass: 1, inertia: 1}}",
         "which is not that of a stiffness in turning"},
        {"{count: 3, mount: {stiffness: [1, 2, 3, 4, 5, 6], mass: 0, inertia: 1}}", "key 'rollers.along.mount.mass'"},
    };
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++)
        expect_bad(data_text("smallest"), "rollers.along", bad[k][0], bad[k][1]);
}

/* Runs an example case from equilibrium and says how it went. */
static Outcome run(const char *name, const char *const *settings)
{
    const Outcome out = example_run(name, settings);
    print_message("%s: pull %.2f N, %ld steps, %s\n", name, out.summary.pull_mean_N, out.summary.steps,
                  out.summary.linear_solver_why);
    assert_true(out.summary.relaxation.reached);
    return out;
}

/* A roller that turns with the cable costs mu r_j/R, whatever the friction between it and the cable. */
TEST(bearing_friction)
{
    const double weight = 30 * 22 * 9.81, share = 0.12 * 12 / 100;
    const char *const grippy[] = {"friction.mu", "0.8", NULL};
    const char *const *const settings[] = {NULL, grippy};
    for (int k = 0; k < 2; ++k) {
        const hawser_roller *roller;
        Outcome o = run("rollers-spinning", settings[k]);
        check_share(o.summary.pull_mean_N, share * weight, 0.01);
        const int n = hawser_sim_rollers(o.sim, &roller);
        for (int r = 2; r < n - 3; ++r) {
            check_share(roller[r].spin_rad_per_s, 1, 0.005); /* 0.1 m/s over 100 mm */
            check_nan(roller[r].shift_m);
        }
        hawser_sim_free(o.sim);
    }
}

/* Mounts give way by load over stiffness; the pull is that of fixed rollers. */
TEST(mounts_give_way)
{
    const hawser_roller *roller;
    Outcome o = run("rollers-mounted", NULL);
    check_share(o.summary.pull_mean_N, 0.2 * 20 * 22 * 9.81, 0.005);
    const int n = hawser_sim_rollers(o.sim, &roller);
    for (int r = 0; r < n; ++r) {
        const double up = roller[r].steady_N / sqrt(1 + 0.04) / 200e3, along = 0.2 * up * 2;
        check_share(roller[r].shift_m, sqrt(up * up + along * along), 0.01);
        check_nan(roller[r].spin_rad_per_s);
    }
    hawser_sim_free(o.sim);
}

/* T2 = T1 exp(mu theta) on a fixed drum, in the plane and in space; half a turn and a quarter of one. */
TEST(capstan)
{
    const char *const half[] = {"solver.planar", "off", NULL};
    const char *const quarter[] = {"route.pieces.1.bend",
                                   "90 deg",
                                   "chain.0.length",
                                   "2.85 m",
                                   "route.head_at",
                                   "3.35 m",
                                   "output.stations.list.1.at",
                                   "1.5 m",
                                   "output.stations.list.2.at",
                                   "2 m",
                                   NULL};
    const char *const *const settings[] = {NULL, half, quarter};
    for (int k = 0; k < 3; ++k) {
        Outcome o = run("capstan", settings[k]);
        check_share(o.summary.pull_mean_N, 1000 * exp(0.2 * 3.14159265358979323846 / (k < 2 ? 1 : 2)), 0.005);
        hawser_sim_free(o.sim);
    }
}

/* The same drum turning: its bearing alone is left, T2 - T1 = mu r_j |f|/(R + r) with |f| = T1 + T2. The rope
 * touches more than two segments' worth of it, so that it ends in the border. */
TEST(turning_drum)
{
    const char *const spins[] = {"rollers.list.0.spin.inertia", "5 kg m2", "rollers.list.0.spin.bearing.journal",
                                 "50 mm", NULL};
    const double a = 0.1 * 0.05; /* R + r = 1 m */
    Outcome o = run("capstan", spins);
    check_share(o.summary.pull_mean_N, 1000 * (1 + a) / (1 - a), 2e-4);
    check_has(o.summary.linear_solver_why, "border of 1");
    hawser_sim_free(o.sim);
}
