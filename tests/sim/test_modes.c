/* Vibrations of rods against closed forms, exact ones of the discrete chain and those of the continuum. */
#include "sim/run/modes.h"
#include "tests/support/rig.h"

/* The modes of a rod about its equilibrium at t = 1 s; its ends: 0 free, 1 clamped, 2 pinned. */
static void find(RodFixture f, int tail, int head, int wanted, Stage *stage, Modes *modes)
{
    SceneDef def;
    hawser_error err = {0};
    if (tail) rod_hold(&f.rod.end[ROD_TAIL], tail == 2);
    if (head) rod_hold(&f.rod.end[ROD_HEAD], head == 2);
    if (f.steps == 0) f.steps = 1;
    rod_define(&def, &f);
    def.analysis.stability = STABILITY_REPORT; /* also about what is not stable */
    rod_stage(&def, stage);
    rod_solve(stage);
    if (modes_find(stage, wanted, 0, modes, &err)) fail_msg("%s", err.message);
    assert_int_equal(modes->n, wanted);
}

static void drop(Stage *stage, Modes *modes)
{
    modes_free(modes);
    stage_free(stage);
}

/* Slender: EI = 1 kN m2, 1 kg/m, 1 m; hardly stretches or shears. */
static RodFixture slender(int n) { return (RodFixture){.n = n, .length = 1, .ea = 1e8, .ga = 1e8}; }

/* beta^2/2 pi sqrt(EI/m)/L^2 of the slender rod, Hz. */
static double beam(double beta) { return beta * beta * sqrt(1e3) / (2 * M_PI); }

/* The first three bending modes, each twice, within 0.5 % at 50 segments. */
TEST(beams_bend)
{
    static const double beta[3][3] = {
        {1.875104, 4.694091, 7.854757}, {4.730041, 7.853205, 10.995608}, {M_PI, 2 * M_PI, 3 * M_PI}};
    static const int ends[3][2] = {{1, 0}, {1, 1}, {2, 2}};
    for (int k = 0; k < 3; ++k) {
        Stage stage;
        Modes modes;
        const int spin = k == 2; /* a pinned rod spins about its axis */
        find(slender(50), ends[k][0], ends[k][1], 6 + spin, &stage, &modes);
        for (int m = 0; m < 6; ++m) {
            const double expected = beam(beta[k][m / 2]);
            check_share(modes.out[m + spin].frequency_Hz, expected, 0.005);
            check_close(modes.out[m + spin].growth_per_s, 0, 0);
        }
        drop(&stage, &modes);
    }
}

static double first_of_cantilever(int n)
{
    Stage stage;
    Modes modes;
    find(slender(n), 1, 0, 2, &stage, &modes);
    const double f = modes.out[0].frequency_Hz;
    drop(&stage, &modes);
    return f;
}

/* Halving the segments quarters the difference. */
TEST(frequencies_are_of_second_order)
{
    const double f[4] = {first_of_cantilever(8), first_of_cantilever(16), first_of_cantilever(32),
                         first_of_cantilever(64)};
    for (int k = 0; k < 2; ++k) check_close((f[k] - f[k + 1]) / (f[k + 1] - f[k + 2]), 4, 0.2);
}

/* The lowest bending frequency of a cantilever with a body of its own mass at its tip; n segments, Hz. */
static double with_a_tip_mass(int n, int along)
{
    Stage stage;
    Modes modes;
    RodFixture f = slender(n);
    f.ga = 1e9;
    f.ea = along ? 1e3 : 1e9;
    if (along) f.ga = 1e6;
    f.rod.n_masses = 1;
    f.rod.masses = fixture_array(1, sizeof *f.rod.masses);
    f.rod.masses[0] = (RodMassDef){1, 1};
    find(f, 1, 0, 2, &stage, &modes);
    const double found = modes.out[0].frequency_Hz;
    drop(&stage, &modes);
    return found;
}

/* Tip mass equal to the beam's: beta L = 1.247917 of cos b cosh b + 1 = b (sin b cosh b - cos b sinh b); to the bar's:
 * b tan b = 1, b = 0.860334. The error was 3/4 h/L, and falls to a quarter at least with half the
 * segments' length. */
TEST(tip_masses_are_of_second_order)
{
    static const double allowed[3] = {0.001, 0.0003, 0.0001};
    const double bar = 0.860334 * sqrt(1e3) / (2 * M_PI);
    for (int along = 0; along < 2; ++along) {
        const double exact = along ? bar : beam(1.247917);
        double error[3];
        for (int k = 0; k < 3; ++k) {
            error[k] = with_a_tip_mass(10 << k, along) / exact - 1;
            print_message("%s, %d segments: %+.4f %%\n", along ? "along" : "across", 10 << k, 100 * error[k]);
            check_at_most(fabs(error[k]), allowed[k]);
        }
        for (int k = 0; k < 2; ++k) check_at_least(fabs(error[k] / error[k + 1]), 3.5);
    }
}

/* Six rigid motions, then the free beam's 4.730041. */
TEST(a_free_rod_has_six_rigid_motions)
{
    Stage stage;
    Modes modes;
    find(slender(30), 0, 0, 8, &stage, &modes);
    for (int m = 0; m < 6; ++m) check_close(modes.out[m].frequency_Hz, 0, 1e-2);
    for (int m = 6; m < 8; ++m) check_share(modes.out[m].frequency_Hz, beam(4.730041), 0.005);
    drop(&stage, &modes);
}

static double nearest(const Modes *modes, double frequency)
{
    double found = INFINITY;
    for (int m = 0; m < modes->n; ++m) {
        if (fabs(modes->out[m].frequency_Hz - frequency) < fabs(found - frequency)) found = modes->out[m].frequency_Hz;
    }
    return found;
}

/* All modes of a short bar: along and about its axis the chain's are 1/pi sqrt(k/m) sin((2 i - 1) pi/4N), up to close
 * under 1/pi sqrt(k/m). */
TEST(bars_ring_as_chains_do)
{
    enum { N = 4 };
    Stage stage;
    Modes modes;
    RodFixture f = {.n = N, .length = 1, .ea = 3e6, .ga = 1e6, .gj = 700};
    find(f, 1, 0, 6 * N, &stage, &modes);
    const Chain *const c = &stage.scene.chain;
    for (int i = 1; i <= N; ++i) {
        const double wave = sin((2 * i - 1) * M_PI / (4 * N)) / M_PI;
        const double along = wave * sqrt(c->stiffness[0][1] / c->mass[0]);
        const double about = wave * sqrt(c->stiffness[3][1] / c->inertia[0][0]);
        check_share(nearest(&modes, along), along, 1e-11);
        check_share(nearest(&modes, about), about, 1e-11);
    }
    drop(&stage, &modes);
}

/* Rigid segments on a string of tension P: a wave of phase a from joint to joint moves centres by cos(a/2) and turns
 * them by 2 sin(a/2)/h, so omega^2 = 4 P/(m h) sin^2(a/2)/(cos^2(a/2) + 4 I/(m h^2) sin^2(a/2)), a = i pi/N. */
TEST(a_string_swings_as_its_segments_do)
{
    enum { N = 12 };
    RodFixture f = {.n = N, .length = 3, .ea = 1e9, .ga = 1e9, .ei_y = 1e-7, .ei_z = 1e-7, .gj = 1e-3};
    Stage stage;
    Modes modes;
    const double pull = 50;
    f.rod.loads = fixture_array(1, sizeof *f.rod.loads);
    rod_load(&f.rod, 3, 0, 0, v3(1, 0, 0), pull);
    rod_hold(&f.rod.end[ROD_HEAD], 0);
    f.rod.end[ROD_HEAD].held[0] = f.rod.end[ROD_HEAD].held[4] = f.rod.end[ROD_HEAD].held[5] = 0;
    find(f, 2, 0, 8, &stage, &modes);
    const Chain *const c = &stage.scene.chain;
    for (int i = 1; i <= 3; ++i) {
        const double s = sin(i * M_PI / (2 * N)), h = 2 * c->half[0],
                     inertia = 4 * c->inertia[1][0] / (c->mass[0] * h * h);
        const double w2 = 4 * pull / (c->mass[0] * h) * s * s / (1 - s * s + inertia * s * s),
                     expected = sqrt(w2) / (2 * M_PI);
        check_share(nearest(&modes, expected), expected, 1e-6);
    }
    drop(&stage, &modes);
}

/* A shift along the first mode's shape brings forces M omega^2 times the shape. */
TEST(shapes_swing_at_their_frequency)
{
    Stage stage;
    Modes modes;
    find((RodFixture){.n = 10, .length = 2, .ei_z = 3e3}, 1, 0, 3, &stage, &modes);
    double *const rate = fixture_array(130, sizeof *rate);
    for (int m = 0; m < 3; ++m) {
        const double e = 1e-6 / 2, w2 = modes.out[m].omega_squared;
        double found[2][60], largest = 0;
        for (int side = 0; side < 2; ++side) {
            double *const y = fixture_array(130, sizeof *y);
            memcpy(y, stage.y, 130 * sizeof *y);
            for (int i = 0; i < 10; ++i) {
                for (int c = 0; c < 6; ++c) state_nudge(y, 10, i, c, (side ? e : -e) * modes.out[m].shape[6 * i + c]);
            }
            dynamics_rates(&stage.scene, &stage.ws, 1, y, 0, rate);
            for (int i = 0; i < 60; ++i) found[side][i] = rate[70 + i];
            free(y);
        }
        for (int i = 0; i < 60; ++i) {
            const double expected = -w2 * modes.out[m].shape[6 * (i % 10) + i / 10];
            check_close((found[1][i] - found[0][i]) / (2 * e), expected, 1e-6 * w2);
            largest = larger_of(largest, fabs(modes.out[m].shape[6 * (i % 10) + i / 10]));
        }
        check_at_least(largest, 1 - 1e-12);
    }
    free(rate);
    drop(&stage, &modes);
}

/* The lowest mode of a column under an end force P L^2/EI. */
static hawser_mode column(double force, int follower)
{
    RodFixture f = slender(24);
    Stage stage;
    Modes modes;
    f.ei_z = 4e3; /* only one plane can give way */
    f.steps = 4;
    f.rod.loads = fixture_array(1, sizeof *f.rod.loads);
    rod_load(&f.rod, 1, 0, follower, v3(-1, 0, 0), 1e3 * force);
    find(f, 1, 0, 3, &stage, &modes);
    hawser_mode out = modes.out[0];
    for (int m = 1; m < 3; ++m) {
        if (modes.out[m].growth_per_s > out.growth_per_s) out = modes.out[m];
    }
    drop(&stage, &modes);
    return out;
}

/* Euler: pi^2/4 for a dead force. Beck: 20.05 for a follower, which makes the column swing up. */
TEST(columns_lose_stability)
{
    const hawser_mode below = column(0.98 * M_PI * M_PI / 4, 0), above = column(1.02 * M_PI * M_PI / 4, 0);
    check_above(below.omega_squared, 0);
    check_at_most(below.growth_per_s, 0);
    check_below(above.omega_squared, 0);
    check_above(above.growth_per_s, 0);
    check_at_most(above.frequency_Hz, 0);
    const hawser_mode calm = column(19.5, 1), flutter = column(20.6, 1);
    check_close(calm.growth_per_s, 0, 1e-3);
    check_above(flutter.growth_per_s, 1);
    check_above(flutter.frequency_Hz, 10);
}
