/* Steady motion by place of the front: exact pulls, the same pull in time, other lengths of segments; what has no
 * steady motion is refused by name. */
#include "tests/io/case_fixture.h"

#include "core/vec3.h"

static hawser_sim *positions_of(const char *text, const char *key, const char *value, const char *places)
{
    return run_of(text, (const char *const[]){"run.analysis", "positions", "run.positions", places, key, value, NULL});
}

/* A level row, exactly mu m g, at places as listed; the last is the worst or as good. */
TEST(test_straight)
{
    const hawser_place *place;
    hawser_summary sum;
    /* a winch that carries none of the weight */
    hawser_sim *const sim = positions_of(data_with("short-pull", "duration: 2 s", "duration: 20 s"), "drive.winch.grip",
                                         "axial", "[13 m, 12.5 m, 13.7 m]");
    const int n = hawser_sim_places(sim, &place);
    hawser_sim_summary(sim, &sum);
    assert_int_equal(n, 3);
    assert_int_equal(sum.n_places, 3);
    assert_string_equal(sum.analysis, "positions");
    const double at[3] = {12.5, 13, 13.7};
    double most = 0;
    for (int k = 0; k < n; ++k) {
        check_close(place[k].head_m, at[k], 1e-9);
        check_close(place[k].time_s, (at[k] - 12.05) / 0.1 + 1, 1e-6); /* STEP to 0.1 m/s within 1 s */
        check_share(place[k].pull_N, 0.2 * 200 * 9.80665, 1e-3);
        check_at_most(place[k].residual_N, place[k].tolerance_N);
        most = larger_of(most, place[k].pull_N);
    }
    check_share(sum.worst_place->pull_N, most, 1e-15);
    hawser_sim_free(sim);
}

/* Euler's formula: what comes out of the bend over what goes in, but for the wall's being nearer to the bend's middle
 * than the cable. Segments hardly matter; what they do falls with their length. The same cable in time pulls the same.
 */
TEST(test_bend)
{
    const char *const segment[3] = {"400 mm", "200 mm", "100 mm"};
    double pull[3];
    for (int k = 0; k < 3; ++k) {
        const hawser_place *place;
        hawser_sim *const sim =
            positions_of(data_text("positions-bend"), "chain.0.segment", segment[k], "{step: 350 mm}");
        const int n = hawser_sim_places(sim, &place);
        check_at_least(n, 3);
        double mean = 0;
        for (int i = 0; i < n; ++i) mean += place[i].pull_N / n;
        pull[k] = mean;
        print_message("segments of %s: %.3f N, %+.4f %% of Euler's\n", segment[k], mean,
                      100 * (mean / (5000 * exp(0.3 * M_PI / 2)) - 1));
        hawser_sim_free(sim);
    }
    check_share(pull[2], 5000 * exp(0.3 * M_PI / 2), 6e-3);
    check_below(fabs(pull[2] - pull[1]), 0.5 * fabs(pull[1] - pull[0])); /* they converge, and faster than that */
    hawser_summary sum;
    hawser_sim *const sim = run_of(data_with("positions-bend", ", positions: {step: 350 mm}", ", steady_from: 5 s"),
                                   (const char *const[]){"run.analysis", "dynamics", NULL});
    hawser_sim_summary(sim, &sum);
    check_share(sum.pull_mean_N, pull[1], 3e-4);
    hawser_sim_free(sim);
}

/* Mean pull of a run in time within `within` (m) of a place of the front. */
static double mean_near(int n, const double (*row)[2], double head, double within)
{
    double sum = 0;
    int count = 0;
    for (int i = 0; i < n; ++i) {
        if (fabs(row[i][0] - head) > within) continue;
        sum += row[i][1];
        ++count;
    }
    return sum / count;
}

/* A pull from its reel, through a bend, its rope taken in: positions against the run in time there, with a rope like
 * `rope` (its diameter). */
static void run_compare(const char *rope, double mean_most, double each_most)
{
    enum { ROWS = 2000 };
    static double row[ROWS][2];
    int rows = 0;
    hawser_error err;
    hawser_sim *dynamic = NULL;
    const hawser_place *place;
    hawser_case *const c = case_with(data_text("positions"), (const char *const[]){"cables.rope.d", rope, NULL});
    if (hawser_sim_new(c, NULL, &dynamic, &err) || hawser_sim_relax(dynamic, NULL, &err)) fail_msg("%s", err.message);
    for (double t = 0.1; t < 75 && rows < ROWS; t += 0.1) {
        if (hawser_sim_advance(dynamic, t, 0, &err)) fail_msg("%s", err.message);
        const hawser_sample *const look = hawser_sim_sample(dynamic);
        row[rows][0] = look->head_at;
        row[rows++][1] = look->winch_force;
    }
    hawser_sim *const sim =
        positions_of(data_text("positions"), "cables.rope.d", rope, "{from: 6 m, to: 18 m, step: 1 m}");
    const int n = hawser_sim_places(sim, &place);
    assert_int_equal(n, 13);
    double mean = 0, most = 0;
    for (int k = 0; k < n; ++k) {
        const double off = place[k].pull_N / mean_near(rows, row, place[k].head_m, 0.5) - 1;
        print_message("front at %5.2f m: %9.3f N, %+.3f %% of the run\n", place[k].head_m, place[k].pull_N, 100 * off);
        mean += off / n;
        most = larger_of(most, fabs(off));
    }
    check_close(mean, 0, mean_most);
    check_at_most(most, each_most);
    hawser_sim_free(sim);
    hawser_sim_free(dynamic);
    hawser_case_free(c);
}

/* A thin rope lies nearer to the wall of the bend than the cable that follows it, so that the line does not stand still
 * as the front goes on. */
TEST(test_run)
{
    run_compare("88 mm", 1e-3, 1.5e-3);
    run_compare("14 mm", 3e-3, 5e-3);
}

/* The same place whichever way led there. */
TEST(test_way)
{
    const hawser_place *alone, *after;
    hawser_sim *const one = positions_of(data_text("positions"), "solver.threads", "1", "[17.25 m]");
    hawser_sim *const two = positions_of(data_text("positions"), "solver.threads", "1", "[9 m, 11.6 m, 17.25 m]");
    assert_int_equal(hawser_sim_places(one, &alone), 1);
    assert_int_equal(hawser_sim_places(two, &after), 3);
    check_share(after[2].pull_N, alone[0].pull_N, 1e-4);
    check_share(after[2].front_N, alone[0].front_N, 1e-4);
    hawser_sim_free(one);
    hawser_sim_free(two);
}

/* A back tension that rises and falls between two places that are evenly apart: what is pulled with at its corners is
 * known, too. */
TEST(test_corners)
{
    const hawser_place *place;
    hawser_summary sum;
    hawser_sim *const sim =
        run_of(data_with("positions-bend", "{tension: 5 kN, ramp: none}",
                         "{table: [[0 s, 5 kN], [6 s, 5 kN], [6.1 s, 20 kN], [6.2 s, 5 kN], [99 s, 5 kN]]}"),
               (const char *const[]){"run.positions", "{step: 350 mm}", NULL});
    const int n = hawser_sim_places(sim, &place);
    hawser_sim_summary(sim, &sum);
    check_close(sum.worst_place->time_s, 6.1, 1e-9);
    check_share(sum.worst_place->pull_N, 20e3 * exp(0.3 * M_PI / 2), 0.02);
    for (int k = 1; k < n; ++k) check_below(place[k - 1].time_s, place[k].time_s);
    assert_int_equal(n, 5 + 3);
    hawser_sim_free(sim);
}

/* What a steady state does not know is refused, and says so. */
TEST(test_refused)
{
    const struct {
        const char *key, *value, *says;
    } bad[] = {{"run.positions", "[4.05 m]", "not at its speed"},
               {"run.positions", "{from: 8 m, to: 6 m}", "nothing lies between"},
               {"run.positions", "[8 m, 300 m]", "never reached"},
               {"friction.law", "stick", "sticks"},
               {"solver.relax", "false", "solver.relax"},
               {"medium", "{density: 1.2, buoyancy: false}", "air or water"},
               {"run.positions", "[]", "empty list"}};
    for (size_t k = 0; k < sizeof bad / sizeof *bad; ++k) {
        hawser_error err = {0};
        hawser_case *c = NULL;
        hawser_sim *sim = NULL;
        hawser_status status = hawser_case_parse(data_text("positions"), "positions", &c, &err);
        if (!status) status = hawser_case_set(c, "run.analysis", "positions", &err);
        if (!status) status = hawser_case_set(c, bad[k].key, bad[k].value, &err);
        if (!status) status = hawser_sim_new(c, NULL, &sim, &err);
        print_message("%s: %s\n", bad[k].key, err.message);
        assert_int_equal(status, HAWSER_ERR_INPUT);
        check_has(err.message, bad[k].says);
        hawser_sim_free(sim);
        hawser_case_free(c);
    }
}

/* Positions that are no whole segments apart meet rope that lies elsewhere on its rollers: Newton's method finds all of
 * it again, since what pressed is presumed to press (PS11)-(PS13). */
TEST(test_between_segments)
{
    const hawser_place *place;
    hawser_sim *const sim =
        run_of(data_text("positions"), (const char *const[]){"run.analysis", "positions", "run.positions",
                                                             "{from: 6 m, to: 18 m, step: 130 mm}", NULL});
    const int n = hawser_sim_places(sim, &place);
    int many = 0, all = 0;
    for (int k = 0; k < n; ++k) {
        many += place[k].iterations > 12;
        all += place[k].iterations;
    }
    print_message("%d places, %d with more than 12 iterations, %.1f in the mean\n", n, many, (double)all / n);
    check_at_least(n, 90);
    check_at_most(many, 9); /* 17 by tangents at the gaps */
    hawser_sim_free(sim);
}

/* A pull that is allowed at speed, 3.40 kN of 3.45 kN, and that its start breaks by 6.7 % (3.68 kN): positions said
 * SAFE. With what (LI16) bounds the start by they say it, and of less they say that they do not know. */
TEST(test_start)
{
    const struct {
        const char *analysis, *limits, *verdict;
    } kind[] = {{"positions", "{pull: 3.45 kN, sidewall: 1 MN/m, clearance: 1 mm, fill: 0.9}",
                 "NOT JUDGED: pull: holds at speed"},
                {"dynamics", "{pull: 3.45 kN, sidewall: 1 MN/m, clearance: 1 mm, fill: 0.9}", "NOT SAFE: 1 of "},
                {"positions", "{pull: 3.95 kN, sidewall: 1 MN/m, clearance: 1 mm, fill: 0.9}", "SAFE"},
                {"dynamics", "{pull: 3.95 kN, sidewall: 1 MN/m, clearance: 1 mm, fill: 0.9}", "SAFE"}};
    for (int k = 0; k < 4; ++k) {
        char verdict[HAWSER_VERDICT_MAX];
        hawser_limit limit[HAWSER_LIMITS_MAX];
        hawser_summary sum;
        hawser_sim *const sim = run_of(data_text("trap-tight-duct"),
                                       (const char *const[]){"run.analysis", kind[k].analysis, "limits", kind[k].limits,
                                                             "drive.winch.speed", "0.25 m/s", "drive.winch.to", "0.1 s",
                                                             "run.duration", "4 s", "run.steady_from", "1 s", NULL});
        hawser_sim_summary(sim, &sum);
        const int n = hawser_sim_limits(sim, limit);
        hawser_verdict(sum.n_conditions, sum.conditions, n, limit, verdict, sizeof verdict);
        print_message("%s: peak %.0f N: %s\n", kind[k].analysis, sum.pull_peak_N, verdict);
        assert_ptr_equal(strstr(verdict, kind[k].verdict), verdict);
        check_share(sum.pull_peak_N, k % 2 ? 3682 : 3402, 0.02);
        hawser_sim_free(sim);
    }
}
