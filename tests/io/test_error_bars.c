/* Error bars contain the error where it is known: from friction's own law, from runs with finer steps, from runs with
 * shorter segments; and they are not so wide that they say nothing. */
#include "tests/io/case_fixture.h"

#include "sim/run/stats.h"

static hawser_summary pulled(const char *data, const char *const *settings)
{
    hawser_summary sum;
    hawser_sim *const s = run_of(data_text(data), settings);
    hawser_sim_summary(s, &sum);
    hawser_sim_free(s); /* the numbers stay */
    return sum;
}

/* The bar of a mean contains what a better run finds, and is at most `widest` times as wide. */
static void expect_within(const hawser_summary *run, double truth, double widest)
{
    const double error = fabs(run->pull_mean_N - truth);
    const hawser_error_bar *const bar = &run->pull_mean_error;
    print_message("pull %.3f N, truth %.3f N: off by %.3g N, bar %.3g N (time %.2g, mesh %.2g, friction %.2g)\n",
                  run->pull_mean_N, truth, error, bar->total, bar->time, bar->mesh, bar->friction);
    check_at_most(error, bar->total);
    check_at_most(bar->total, widest * error);
    check_close(bar->total, bar->time + bar->mesh + bar->friction, 1e-12 * run->pull_mean_N);
}

/* Half of v_s: the law gives 1.5 x - x^3/2 = 0.6875 of the friction at x = 0.5, and lacks 0.45 of that. */
TEST(friction_not_there)
{
    const char *const slow[] = {"friction.v_s", "200 mm/s", "friction.v_d", "400 mm/s", NULL};
    const hawser_summary full = pulled("trust", NULL), lacking = pulled("trust", slow);
    check_share(lacking.pull_mean_error.friction / lacking.pull_mean_N, 1 / 0.6875 - 1, 1e-3);
    check_equal(full.pull_mean_error.friction, 0);
    expect_within(&lacking, full.pull_mean_N, 5);
}

/* Segments of half a metre in a duct's bend. */
TEST(coarse_segments)
{
    const char *const fine[] = {"chain.0.segment", "125 mm", NULL};
    const hawser_summary coarse = pulled("trust-duct", NULL), finer = pulled("trust-duct", fine);
    expect_within(&coarse, finer.pull_mean_N, 20);
    check_below(finer.pull_mean_error.mesh, coarse.pull_mean_error.mesh);
    check_at_least(coarse.pull_peak_error.mesh, coarse.pull_mean_error.mesh);
}

/* Accuracy: the error falls, and the bar's part of it with it. */
TEST(loose_steps)
{
    const char *const loose[] = {"solver.accuracy", "0.1", NULL}, *const tight[] = {"solver.accuracy", "1e-7", NULL};
    const hawser_summary rough = pulled("trust", loose), fine = pulled("trust", tight);
    expect_within(&rough, fine.pull_mean_N, 1e4); /* the mesh's part is the same in both */
    check_below(fine.pull_mean_error.time, rough.pull_mean_error.time / 10);
}

/* Less than a segment passes: the pull was 2676 N and its bar 20 N, and 2564 N at a speed that passes many (EB9). */
TEST(a_slow_winch)
{
    const hawser_summary slow = pulled("error-slow-winch", NULL);
    print_message("pull %.1f N +- %.1f N\n", slow.pull_mean_N, slow.pull_mean_error.total);
    check_above(slow.pull_mean_error.total, fabs(slow.pull_mean_N - 2564));
    check_above(slow.pull_mean_error.total, 0.02 * slow.pull_mean_N); /* not trusted */
}

/* The clamp carries a segment of cable, not the winch's drum that moves with it: 5 t of drum were 100 % of the pull
 * (EB3). */
TEST(a_drum_weighs_nothing)
{
    hawser_summary sum;
    hawser_sim *const s = run_of(
        data_with("trust-duct", "winch: {speed: 0.1 m/s, to: 1 s}",
                  "winch: {tension: {force: 4 kN, to: 1 s, speed_limit: 0.1 m/s, drum_mass: 5000 kg, band: 0.1}}"),
        NULL);
    hawser_sim_summary(s, &sum);
    hawser_sim_free(s);
    check_above(sum.pull_mean_N, 500);
    check_at_most(sum.pull_mean_error.mesh, 0.1 * sum.pull_mean_N);
}

/* Loads have two and three times the parts of a tension (EB7): half of v_s, where friction lacks 1/0.6875 - 1. A
 * station's tension has what the pull has. */
TEST(loads_have_wider_bars)
{
    const char *const slow[] = {"friction.v_s",
                                "200 mm/s",
                                "friction.v_d",
                                "400 mm/s",
                                "output.stations",
                                "{list: [{name: A, at: 10 m}]}",
                                NULL};
    const double lacks = 1 / 0.6875 - 1;
    const hawser_roller *row;
    const hawser_station *station;
    hawser_sim *const s = run_of(data_text("trust"), slow);
    hawser_summary sum;
    hawser_sim_summary(s, &sum); /* bars are as of the last one */
    const int n = hawser_sim_rollers(s, &row);
    check_at_least(n, 5);
    for (int r = 0; r < n; r++) {
        if (!(row[r].steady_N > 1)) continue;
        check_at_least(row[r].steady_error_N, 3 * (lacks - 1e-3) * row[r].steady_N);
        check_at_least(row[r].peak_error_N, 2 * (lacks - 1e-3) * row[r].peak_N);
    }
    assert_int_equal(hawser_sim_stations(s, &station), 1);
    check_between(station->mean_error_N / station->mean_N, lacks - 1e-3, 2 * lacks);
    check_between(station->peak_error_N / station->peak_N, lacks - 1e-3, 2 * lacks);
    hawser_sim_free(s);
}

/* Sidewall pressure is one of the mesh: as much again, and the peak pull's share (EB8). */
TEST(pressure_is_the_meshs)
{
    hawser_summary sum;
    hawser_sim *const s = run_of(data_text("trust-duct"), NULL);
    const hawser_surface *duct;
    hawser_sim_summary(s, &sum);
    assert_int_equal(hawser_sim_surfaces(s, &duct), 1);
    check_above(duct->line_load_N_per_m, 0);
    check_share(duct->line_load_error, duct->line_load_N_per_m * (1 + sum.pull_peak_error.total / sum.pull_peak_N),
                1e-9);
    hawser_sim_free(s);
}

/* Values that jump up and down by 1: second differences of 4 before the peak, whatever comes behind it (EB12). */
TEST(how_rough_a_peak_is)
{
    TimeMean m = {0};
    for (int k = 0; k < 400; k++) mean_add(&m, k < 200 ? k % 2 * 2.0 - 1 + (k == 199) : 0, k ? 1 : 0, 0);
    check_between(sqrt(m.rough_at_peak), 4, 4.3);
    check_below(m.rough, 1e-9);
}

/* A mean of 10 with a ripple of amplitude 2 and period 1 s on a slow rise: blocks of 2 s see the ripple and not the
 * rise; the peak's second difference is that of the ripple's crest. */
TEST(what_a_signal_shows)
{
    const double dt = 0.01, omega = 2 * 3.14159265358979323846;
    TimeMean m = {0};
    for (int k = 0; k <= 2000; k++) {
        const double t = k * dt;
        mean_add(&m, 10 + t / 100 + 2 * sin(omega * t), k ? dt : 0, 1);
        if (k % 200 == 0) mean_block(&m);
    }
    check_share(mean_waver(&m), sqrt(2), 5e-3);
    check_share(m.sharpness, 2 * omega * omega * dt * dt, 5e-3);
    check_share(mean_of(&m), 10.1, 1e-4);
}

/* The tail is held back for a tenth of a second: rows of 200 ms say 1837 N +- 51 N, those of 2 ms 6190 N. What steps
 * between rows have held is a peak as well. (EB14) */
TEST(a_peak_between_rows)
{
    const char *const tail = "{table: [[0, 1 kN], [2 s, 1 kN], [2.05 s, 5 kN], [2.1 s, 1 kN]]}";
    const char *const dense[] = {"drive.tail", tail, "output.interval", "2 ms", "solver.max_step", "50 ms", NULL};
    const char *const sparse[] = {"drive.tail", tail, "output.interval", "200 ms", "solver.max_step", "50 ms", NULL};
    const hawser_summary all = pulled("trust", dense), few = pulled("trust", sparse);
    check_above(all.pull_peak_N, 6000);
    check_at_most(fabs(few.pull_peak_N - all.pull_peak_N), few.pull_peak_error.total);
    check_share(few.pull_peak_error.total, all.pull_peak_error.total, 0.05);
    check_at_most(few.pull_peak_error.total, 0.05 * few.pull_peak_N);
}

/* Rows in step with the joints see each in one place, and hardly a ripple: 994 N +- 5.5 N where rows of 20 ms have
 * 990 N. The steps between them say what they miss. (EB33) */
TEST(rows_in_step_with_joints)
{
    static const char text[] =
        "cables: {power: {d: 80 mm, mass: 14 kg/m, EA: 60 MN, GA: 25 MN, GJ: 10 kN m2, EI: 2 kN m2, damping: 2 ms}}\n"
        "chain: [{cable: power, length: 30 m, segment: 500 mm}]\n"
        "route: {head_at: 22 m, pieces: [{straight: 34 m}]}\nlead_in: {}\nfriction: {mu: 0.3}\n"
        "rollers: {along: [{spacing: 1500 mm, radius: 60 mm, width: 400 mm, to: 19 m}]}\n"
        "surfaces: {ducts: [{name: d, radius: 50 mm, from: 20 m, friction: {mu: 0.001}, place: resting}]}\n"
        "drive: {winch: {speed: 1 m/s, ramp: step, to: 1 s}, tail: {tension: 200 N}}\n"
        "run: {duration: 9 s, steady_from: 3 s}\n";
    static const char *const interval[] = {"500 ms", "20 ms"};
    hawser_summary sum[2];
    for (int k = 0; k < 2; k++) {
        hawser_sim *const sim = run_of(text, (const char *const[]){"output.interval", interval[k], NULL});
        hawser_sim_summary(sim, &sum[k]);
        hawser_sim_free(sim);
    }
    const double off = fabs(sum[0].pull_mean_N - sum[1].pull_mean_N);
    check_above(off, 2e-3 * sum[1].pull_mean_N);
    check_below(sum[0].pull_ripple_N, sum[1].pull_ripple_N / 4);
    check_at_least(sum[0].pull_mean_error.time, 0.8 * off);
    check_at_most(sum[0].pull_mean_error.total, 1e-2 * sum[0].pull_mean_N);
}

/* A force of one step alone is none: 5 counts when the next step still holds it, and what does then is what both held.
 * A figure that was never seen has no peak to raise. (EB14) */
TEST(a_step_alone_is_no_peak)
{
    const double pull[] = {1, 2, 9, 2, 5, 4.5, 4};
    const int held[] = {0, 0, 0, 0, 0, 1, 0};
    double before[2] = {0}, now[2] = {0};
    Stats stats = {.pull = {.peak = 2, .started = 1}, .before = before, .now = now};
    const Scene scene = {0};
    TimeMean none = {0};
    for (int k = 0; k < 7; k++) {
        assert_int_equal(stats_step(&stats, &scene, k, pull[k], &(double){0}, NULL), held[k]);
        if (!held[k]) continue;
        const hawser_sample look = {.winch_force = pull[k]};
        stats_peak(&stats, &scene, NULL, &look);
    }
    check_equal(stats.pull.peak, 4.5);
    check_close(stats.pull.sharpness, 16 * 0.5, 1e-12);
    mean_raise(&none, 3, 0);
    check_equal(none.peak, 0);
}

/* A spike by which it stands out, and a mean in a ramp by half of what its window's halves differ by: more than a
 * fifth, and more than a fortieth (EB16), (EB17). */
TEST(what_is_not_steady)
{
    const char *const snap[] = {"drive.tail", "{table: [[0, 1 kN], [2 s, 1 kN], [2.05 s, 5 kN], [2.1 s, 1 kN]]}",
                                "solver.passes", "1", NULL};
    const char *const early[] = {
        "run.steady_from", "500 ms", "drive.winch.to", "4 s", "friction.v_s", "80 mm/s", "solver.passes", "1", NULL};
    const hawser_summary spike = pulled("trust", snap), ramp = pulled("trust", early);
    check_at_most(0.2 * spike.pull_peak_N, spike.pull_peak_error.mesh);
    check_at_most(spike.pull_mean_error.total, 0.02 * spike.pull_mean_N);
    check_at_most(0.025 * ramp.pull_mean_N, ramp.pull_mean_error.time);
}

/* Pressed into the wall of a duct's bend with 1111 N at first, and 951 N at most at the winch (EB18). */
TEST(a_start_in_a_wall)
{
    const char *const pressed[] = {"solver.relax", "false", "chain.0.segment", "250 mm", "solver.passes", "1", NULL};
    const hawser_summary run = pulled("trust-duct", pressed);
    check_at_most(1110 - run.pull_peak_N, run.pull_peak_error.mesh);
    check_at_most(run.pull_peak_error.mesh, 1.2 * (1111 - run.pull_peak_N));
}
