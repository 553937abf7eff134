/* Finer passes of a run: a second one is made where numbers alone are open, and a third where they still are. The last
 * one's figures take the place of the first's where the case leaves the settings open, and where it does not all
 * together say what the first is off by. */
#include <sys/stat.h>
#include <unistd.h>

#include "sim/run/sim.h"
#include "tests/io/case_fixture.h"

static const char *const once[] = {"solver.passes", "1", NULL}, *const twice[] = {"solver.passes", "2", NULL};

static hawser_summary summary_of(const hawser_sim *s)
{
    hawser_summary sum;
    hawser_sim_summary(s, &sum);
    return sum;
}

/* What a pass knows of one other one, which found that and says that it may be off by `bar`; bars of peaks fall from
 * pass to pass. */
static OtherPasses beside(int finer, double mean, double peak, double bar)
{
    OtherPasses o = {.n = 1, .finer = finer, .peak_alone = {1, 2, 3}};
    o.other[0] = (PassFigures){.n = 2, .value = calloc(4, sizeof(double)), .jolt = NAN};
    assert_non_null(o.other[0].value);
    o.other[0].bar = o.other[0].value + 2;
    o.other[0].value[0] = mean;
    o.other[0].value[1] = peak;
    o.other[0].bar[0] = o.other[0].bar[1] = bar;
    return o;
}

/* A slack rope is drawn tight: 2125 N with 42 segments, of which the bar says 13 %; 1951 N with 84, 1908 N with 168.
 * The handle speaks of the second pass, which is the run with these settings. */
TEST(it_replaces)
{
    hawser_sim *const first = run_of(data_text("trust-slack"), once), *const both =
                                                                          run_of(data_text("trust-slack"), NULL);
    const hawser_summary a = summary_of(first), b = summary_of(both);
    assert_null(a.passes);
    assert_non_null(b.passes);
    assert_string_equal(b.passes->outcome, "replaced");
    assert_int_equal(b.passes->n, 2);
    assert_int_equal(a.segments, 42);
    assert_int_equal(b.segments, 84);
    check_equal(b.passes->pass[0].pull_peak_N, a.pull_peak_N);
    check_equal(b.passes->pass[0].pull_peak_bar_N, a.pull_peak_error.total);
    check_equal(b.passes->pass[1].pull_peak_N, b.pull_peak_N);
    check_equal(b.passes->pass[1].accuracy, 2.5e-4);
    check_equal(b.passes->pass[1].friction, 0.5);
    check_close(a.pull_peak_N, 2125, 5);
    check_close(b.pull_peak_N, 1951, 5);
    check_at_most(b.pull_peak_N - 1908, b.pull_peak_error.total);
    check_has(b.passes->why, "the peak may be off by 13 %");
    check_has(b.passes->says, "all figures are those of the second pass");
    check_equal(hawser_sim_time(both), 8);
    assert_int_equal(hawser_sim_sample(both)->segments, 84);
    assert_int_equal(hawser_sim_sample(both)->pass, 2);
    hawser_sim_free(first);
    hawser_sim_free(both);
}

/* The window's halves differ by 6 % with 27 segments, by less than 5 % with 54: the mesh's, which a finer pass shows
 * and has to meet itself. Where its results may not replace the first's, it is not begun for that; and where the pull
 * does change (the winch is faster and less of the pull is steady) it is found out by the second, and there is no
 * third. */
TEST(an_unsteady_window)
{
    static const char *const given[] = {"chain.0.segment", "0.494 m", NULL}, *const faster[] = {"drive.winch.speed",
                                                                                                "0.219 m/s", NULL};
    hawser_sim *const first = run_of(data_text("trust-unsteady"), once), *const both =
                                                                             run_of(data_text("trust-unsteady"), NULL);
    hawser_sim *const own = run_of(data_text("trust-unsteady"), given), *const changes =
                                                                            run_of(data_text("trust-unsteady"), faster);
    const hawser_summary a = summary_of(first), b = summary_of(both), c = summary_of(own), d = summary_of(changes);
    assert_false(condition_of(&a, "steady")->holds);
    assert_non_null(b.passes);
    assert_string_equal(b.passes->outcome, "replaced");
    for (int i = 0; i < b.n_conditions; i++) assert_true(b.conditions[i].holds);
    check_at_most(fabs(b.pull_mean_N - a.pull_mean_N), a.pull_mean_error.total);
    assert_false(condition_of(&c, "steady")->holds);
    assert_null(c.passes);
    assert_int_equal(d.passes->n, 2);
    assert_false(condition_of(&d, "steady")->holds);
    hawser_sim_free(first);
    hawser_sim_free(both);
    hawser_sim_free(own);
    hawser_sim_free(changes);
}

/* The case gives the length of its segments: its own figures stay, to the last bit, and the bars become what both
 * passes say (EB20), 23 % of the peak before. */
TEST(it_compares)
{
    hawser_sim *const first = run_of(data_text("passing-guides"), once), *const both =
                                                                             run_of(data_text("passing-guides"), NULL);
    const hawser_summary a = summary_of(first), b = summary_of(both);
    assert_non_null(b.passes);
    assert_string_equal(b.passes->outcome, "compared");
    check_has(b.passes->says, "as the case gives chain.0.segment");
    assert_int_equal(b.segments, a.segments);
    check_equal(b.pull_mean_N, a.pull_mean_N);
    check_equal(b.pull_peak_N, a.pull_peak_N);
    const double apart = fabs(b.passes->pass[1].pull_peak_N - a.pull_peak_N), own = a.pull_peak_error.total;
    check_share(b.pull_peak_error.total, fmax(2 * apart, own / 4), 1e-9);
    assert_false(condition_of(&a, "numerical_peak")->holds);
    assert_true(condition_of(&b, "numerical_peak")->holds);
    hawser_sim_free(first);
    hawser_sim_free(both);
}

/* A run that is trusted, one that fails for a reason that its own settings do not leave to a finer pass, one of which
 * friction alone leaves too much open, and one that its caller steps have one pass. */
TEST(one_is_enough)
{
    const char *const snap[] = {"drive.tail", "{table: [[0, 1 kN], [2 s, 1 kN], [2.05 s, 5 kN], [2.1 s, 1 kN]]}",
                                "chain.0.segment", "0.5 m", NULL};
    hawser_sim *const good = run_of(data_text("trust"), NULL), *const spiked = run_of(data_text("trust"), snap),
                      *const loose = run_of(data_text("trust-breaks-loose"), NULL),
                      *const stepped = sim_of(data_text("trust-slack"), NULL);
    const hawser_summary spike = summary_of(spiked);
    assert_null(summary_of(good).passes);
    assert_false(condition_of(&spike, "peak")->holds);
    assert_false(condition_of(&spike, "numerical_peak")->holds);
    assert_null(spike.passes);
    assert_null(summary_of(loose).passes);
    assert_int_equal(hawser_sim_advance(stepped, 0.1, 0, NULL), HAWSER_OK);
    assert_int_equal(hawser_sim_run(stepped, NULL, NULL, NULL, NULL), HAWSER_OK);
    assert_null(summary_of(stepped).passes);
    assert_int_equal(summary_of(stepped).segments, 42);
    hawser_sim_free(good);
    hawser_sim_free(spiked);
    hawser_sim_free(loose);
    hawser_sim_free(stepped);
}

/* The start's jolt was 700 N in one pass and 1128 N in the other, and so may be 1556 N in finer ones: the peak of 1178
 * N that comes later may be off by the rest. 0.5 % was said, and finer runs jolt by 1403 to 2179 N. */
TEST(a_jolt_that_may_be_the_peak)
{
    const Stats none = {0};
    OtherPasses other = beside(0, 1143, 1172, 1000);
    other.other[0].jolt = 700;
    hawser_summary sum = {
        .pull_mean_N = 1140, .pull_peak_N = 1178, .pull_mean_error = {0, 3, 0, 3}, .pull_peak_error = {1, 13, 7, 21}};
    other_passes_bars(&other, &none, 1128, &sum);
    check_share(sum.pull_peak_error.mesh, 1128 + 428 - 1178, 1e-12);
    check_share(sum.pull_peak_error.total, sum.pull_peak_error.time + sum.pull_peak_error.mesh + 7, 1e-12);
    /* one that falls as the mesh is refined, or cannot be, says nothing */
    sum.pull_peak_error = (hawser_error_bar){1, 13, 7, 21};
    other_passes_bars(&other, &none, 650, &sum);
    check_at_most(sum.pull_peak_error.total, 21);
    other_passes_bars(&other, &none, NAN, &sum);
    check_at_most(sum.pull_peak_error.total, 21);
    other_passes_free(&other);

    hawser_sim *const thrown = run_of(data_text("trust-thrown"), twice);
    const hawser_summary run = summary_of(thrown);
    assert_non_null(run.passes);
    assert_true(condition_of(&run, "start_jolt")->holds); /* it is not the peak in this mesh */
    assert_false(condition_of(&run, "numerical_peak")->holds);
    check_at_most(1488 - run.pull_peak_N, run.pull_peak_error.total);
    hawser_sim_free(thrown);
}

/* A reel swings on its cable by 100 N, and steps of 16 to 48 ms took all but 10 N of it: 618 to 652 N, trusted at four
 * of these six accuracies, where 706 N is true. What they leave of it shortens them now (EB25). */
TEST(a_swing_that_steps_take)
{
    static const char *const accuracy[] = {"2e-3", "1.4e-3", "1e-3", "7e-4", "5e-4", "2.5e-4"};
    for (size_t k = 0; k < sizeof accuracy / sizeof *accuracy; k++) {
        const char *const given[] = {"solver.accuracy", accuracy[k], NULL};
        hawser_sim *const s = run_of(data_text("trust-swings"), given);
        const hawser_summary sum = summary_of(s);
        check_at_most(fabs(706 - sum.pull_peak_N), 0.06 * 706);
        check_at_most(706 - sum.pull_peak_N, sum.pull_peak_error.total);
        hawser_sim_free(s);
    }
}

/* Joints that hit a duct's bend in the steady window (EB26): 88.5 kN, 75.8 kN on halves, trusted with 6.2 %. A tip that
 * hung and met a roller: 548, 708 and 774 N with segments of a half and a quarter, while the grip turned with half of
 * the head's turn; 410, 393, 388 and 386 N along its line. */
TEST(blows_that_the_mesh_makes)
{
    hawser_sim *const tip = run_of(data_text("trust-tip"), twice), *const mouth =
                                                                       run_of(data_text("trust-mouth"), once);
    const hawser_summary a = summary_of(tip), b = summary_of(mouth);
    check_share(a.pull_peak_N, 386, 0.045); /* 401.8 N: its bar of 15.3 N misses 386 N by half a newton */
    assert_false(condition_of(&b, "numerical_peak")->holds);
    check_at_most(b.pull_peak_N - 75.8e3, b.pull_peak_error.total);
    hawser_sim_free(tip);
    hawser_sim_free(mouth);
}

/* The same, before the steady window but long after the winch has its speed: a clamped head over a roller, 238 N, 198 N
 * on segments of an eighth, trusted with 8.7 %; a rope that whips in a tray's bend, 2149 N for 1419 N, trusted with
 * 7.1 %, and another at the end of the winch's ramp, 3941 N for 3242 N, with 3.2 %. The first is right with three
 * passes. */
TEST(blows_after_the_start)
{
    hawser_sim *const roller = run_of(data_text("trust-over-roller"), once),
                      *const both = run_of(data_text("trust-over-roller"), NULL),
                      *const whips = run_of(data_text("trust-whips"), once),
                      *const early = run_of(data_text("trust-whips-early"), once);
    const hawser_summary a = summary_of(roller), b = summary_of(both), c = summary_of(whips), d = summary_of(early);
    assert_false(condition_of(&a, "numerical_peak")->holds);
    check_at_most(a.pull_peak_N - 198.3, a.pull_peak_error.total);
    assert_int_equal(b.passes->n, 3);
    check_at_most(b.pull_peak_N - 198.3, b.pull_peak_error.total);
    check_at_most(b.pull_peak_N, 1.1 * 198.3);
    assert_false(condition_of(&c, "numerical_peak")->holds);
    check_at_most(c.pull_peak_N - 1419, c.pull_peak_error.total);
    assert_false(condition_of(&d, "numerical_peak")->holds);
    check_at_most(d.pull_peak_N - 3242, d.pull_peak_error.total);
    hawser_sim_free(roller);
    hawser_sim_free(both);
    hawser_sim_free(whips);
    hawser_sim_free(early);
}

/* A jolt that falls more slowly than errors of first order: two passes came within 94 N of each other and were trusted
 * with that, 120 N from 1066 N (EB32). The third is right. */
TEST(a_peak_of_half_an_order)
{
    hawser_sim *const both = run_of(data_text("trust-half-order"), twice), *const three = run_of(
                                                                               data_text("trust-half-order"), NULL);
    const hawser_summary a = summary_of(both), b = summary_of(three);
    assert_false(condition_of(&a, "numerical_peak")->holds);
    check_at_most(a.pull_peak_N - 1066, a.pull_peak_error.total);
    assert_int_equal(b.passes->n, 3);
    assert_true(condition_of(&b, "numerical_peak")->holds);
    check_at_most(b.pull_peak_N - 1066, b.pull_peak_error.total);
    check_at_most(b.pull_peak_N, 1.05 * 1066);
    hawser_sim_free(both);
    hawser_sim_free(three);
}

/* A clamped head over a roller in the winch's ramp, 1848 N for 1690 N: what the last segment's rollers hold is a matter
 * of the mesh (EB31); the bar was 74 N. With an axial grip the head turns, and no such bar is asked. */
TEST(what_a_clamp_holds)
{
    static const char *const turns[] = {"drive.winch.grip", "axial", "solver.passes", "1", NULL};
    hawser_sim *const first = run_of(data_text("trust-clamp"), once),
                      *const both = run_of(data_text("trust-clamp"), NULL),
                      *const axial = run_of(data_text("trust-clamp"), turns);
    const hawser_summary a = summary_of(first), b = summary_of(both), c = summary_of(axial);
    assert_false(condition_of(&a, "numerical_peak")->holds);
    check_at_most(a.pull_peak_N - 1690, a.pull_peak_error.total);
    assert_int_equal(b.passes->n, 2);
    assert_true(condition_of(&b, "numerical_peak")->holds);
    check_at_most(b.pull_peak_N - 1690, b.pull_peak_error.total);
    check_close(first->stats.clamped, 240, 10);
    check_equal(axial->stats.clamped, 0);
    check_at_most(c.pull_peak_error.mesh, 0.5 * a.pull_peak_error.mesh);
    hawser_sim_free(first);
    hawser_sim_free(both);
    hawser_sim_free(axial);
}

/* What steps take of swings falls slowly: two passes that are near each other say less of it (EB23). */
TEST(swings_fall_slowly)
{
    static const struct {
        int finer;
        double faded, apart, expected;
    } row[] = {{0, 0, 20, 20 * (1 + M_SQRT2)}, {0, 50, 20, 50}, {0, 80, 20, 60},
               {1, 0, 20, 20 * (2 + M_SQRT2)}, {1, 70, 20, 70}, {1, 90, 20, 80}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        const Stats swings = {.faded = row[k].faded};
        OtherPasses other = beside(row[k].finer, 1000, 1000 - row[k].apart, 1000);
        hawser_summary sum = {.pull_mean_N = 1000, .pull_peak_N = 1000, .pull_peak_error = {70, 30, 0, 100}};
        other_passes_bars(&other, &swings, NAN, &sum);
        check_share(sum.pull_peak_error.total, row[k].expected, 1e-12);
        other_passes_free(&other);
    }
}

/* What bars are known to see too little of is looked at twice, though all conditions hold. */
TEST(what_bars_do_not_see)
{
    const char *const falls[] = {"solver.relax", "false", NULL};
    hawser_sim *const rests = run_of(data_text("trust"), NULL), *const thrown = run_of(data_text("trust"), falls);
    assert_null(summary_of(rests).passes);
    const hawser_summary sum = summary_of(thrown);
    assert_non_null(sum.passes);
    check_has(sum.passes->why, "did not come to rest first");
    hawser_sim_free(rests);
    hawser_sim_free(thrown);
}

static int verdict_of(hawser_sim *s)
{
    hawser_limit limit[HAWSER_LIMITS_MAX];
    char text[HAWSER_VERDICT_MAX];
    const hawser_summary sum = summary_of(s);
    return hawser_verdict(sum.n_conditions, sum.conditions, hawser_sim_limits(s, limit), limit, text, sizeof text);
}

/* A pull of 1834 N +- 69 N where 1880 N are allowed may be too much: it is not called safe, but computed again, 1826 N
 * +- 8 N, and that is. Where 1800 N are allowed there is nothing to be decided. */
TEST(close_to_a_limit)
{
    const char *const near[] = {"limits.pull", "1880 N", "limits.sidewall", "9 kN/m", "solver.passes", "1", NULL},
                      *const again[] = {"limits.pull", "1880 N", "limits.sidewall", "9 kN/m", NULL},
                      *const over[] = {"limits.pull", "1800 N", "limits.sidewall", "9 kN/m", NULL};
    hawser_sim *const once_only = run_of(data_text("trust"), near), *const both = run_of(data_text("trust"), again),
                      *const broken = run_of(data_text("trust"), over);
    const hawser_summary a = summary_of(once_only), b = summary_of(both), c = summary_of(broken);
    hawser_limit limit[HAWSER_LIMITS_MAX];
    assert_true(hawser_sim_limits(once_only, limit) > 0);
    check_share(limit[0].error / limit[0].value, a.pull_peak_error.total / a.pull_peak_N, 1e-12);
    assert_int_equal(verdict_of(once_only), -2);
    assert_false(condition_of(&a, "decided")->holds);
    check_share(condition_of(&a, "decided")->value, (limit[0].value + limit[0].error) / 1880, 1e-12);
    check_has(condition_of(&a, "decided")->remedy, "limit 'pull' holds by less than its figure may be off");
    assert_int_equal(verdict_of(both), 0);
    assert_string_equal(b.passes->outcome, "replaced");
    assert_true(condition_of(&b, "decided")->holds);
    assert_int_equal(verdict_of(broken), 1);
    assert_null(condition_of(&c, "decided"));
    assert_null(c.passes);
    hawser_sim_free(once_only);
    hawser_sim_free(both);
    hawser_sim_free(broken);
}

static int stop_second(void *user, const hawser_sample *sample, double wall_s, double end_s)
{
    (void)user, (void)wall_s, (void)end_s;
    return sample->pass == 2;
}

static int is_there(const char *dir, const char *name)
{
    char path[256];
    struct stat info;
    snprintf(path, sizeof path, "%s/%s", dir, name);
    return stat(path, &info) == 0;
}

/* Lines of a file of the folder. */
static int lines_in(const char *dir, const char *name)
{
    char path[256];
    int n = 0;
    snprintf(path, sizeof path, "%s/%s", dir, name);
    FILE *const f = fopen(path, "r");
    assert_non_null(f);
    for (int c; (c = getc(f)) != EOF;) n += c == '\n';
    fclose(f);
    return n;
}

static void folder_remove(const char *dir)
{
    static const char *const names[] = {"summary.json", "series.csv", "stations.csv", "rollers.csv",
                                        "inputs.csv",   "route.csv",  "results.h5",   "results.xdmf"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        char path[256];
        snprintf(path, sizeof path, "%s/%s", dir, names[k]);
        unlink(path);
    }
    assert_int_equal(rmdir(dir), 0); /* nothing else is left there */
}

/* The results folder has the second pass's files, once; its summary says so. */
TEST(the_folder_is_the_seconds)
{
    char dir[] = "/tmp/hawser-passes-XXXXXX", *summary;
    assert_non_null(mkdtemp(dir));
    hawser_sim *const s = sim_of(data_text("trust-slack"), NULL);
    assert_int_equal(hawser_sim_run(s, dir, NULL, NULL, NULL), HAWSER_OK);
    assert_int_equal(hawser_sim_summary_json(s, &summary, NULL), HAWSER_OK);
    check_has(summary, "\"outcome\": \"replaced\"");
    check_has(summary, "\"segments\": 84");
    hawser_text_free(summary);
    assert_true(is_there(dir, "summary.json") && is_there(dir, "series.csv") && is_there(dir, "stations.csv"));
    assert_false(is_there(dir, "second-pass"));
    assert_int_equal(lines_in(dir, "series.csv"), 1 + 161); /* a head, and rows every 50 ms of 8 s */
    hawser_sim_free(s);
    folder_remove(dir);
}

/* Stopped in the second pass: the first one's results stand, and where no checkpoints are wanted that is all. */
TEST(stopped_in_the_second)
{
    static const char *const unkept[] = {"run.checkpoint", "0", NULL};
    char dir[] = "/tmp/hawser-passes-XXXXXX";
    hawser_error err = {0};
    assert_non_null(mkdtemp(dir));
    hawser_sim *const s = sim_of(data_text("trust-slack"), unkept);
    assert_int_equal(hawser_sim_run(s, dir, stop_second, NULL, &err), HAWSER_STOPPED);
    check_has(err.message, "the results are those of the first");
    const hawser_summary sum = summary_of(s);
    assert_string_equal(sum.passes->outcome, "failed");
    assert_int_equal(sum.passes->n, 1);
    assert_int_equal(sum.segments, 42);
    check_close(sum.pull_peak_N, 2125, 5);
    check_equal(hawser_sim_time(s), 8);
    assert_false(is_there(dir, "second-pass") || is_there(dir, "checkpoint.hawser"));
    assert_int_equal(lines_in(dir, "series.csv"), 1 + 161);
    hawser_sim_free(s);
    folder_remove(dir);
}

/* A simulation of the case whose run was stopped in dir, gone on with. */
static hawser_sim *resumed(const char *dir, hawser_progress progress, hawser_status expected)
{
    hawser_error err = {0};
    hawser_case *c = NULL;
    hawser_sim *s = NULL;
    if (hawser_case_resume(dir, &c, &err) || hawser_sim_new(c, NULL, &s, &err)) fail_msg("%s", err.message);
    hawser_case_free(c);
    assert_int_equal(hawser_sim_resume(s, dir, progress, NULL, &err), expected);
    return s;
}

/* Stopped twice in the second pass, and resumed: the first is not computed again, and what both come to is what they
 * come to in one go, to the last bit. */
TEST(the_second_is_resumed)
{
    char dir[] = "/tmp/hawser-passes-XXXXXX";
    hawser_error err = {0};
    assert_non_null(mkdtemp(dir));
    hawser_sim *const whole = run_of(data_text("trust-slack"), NULL), *const s = sim_of(data_text("trust-slack"), NULL);
    assert_int_equal(hawser_sim_run(s, dir, stop_second, NULL, &err), HAWSER_STOPPED);
    check_has(err.message, "until it is resumed");
    assert_true(is_there(dir, "checkpoint.hawser") && is_there(dir, "second-pass"));
    hawser_sim_free(s);
    hawser_sim_free(resumed(dir, stop_second, HAWSER_STOPPED));
    hawser_sim *const again = resumed(dir, NULL, HAWSER_OK);
    const hawser_summary a = summary_of(whole), b = summary_of(again);
    assert_string_equal(b.passes->outcome, "replaced");
    check_equal(b.pull_peak_N, a.pull_peak_N);
    check_equal(b.pull_mean_N, a.pull_mean_N);
    check_equal(b.pull_mean_error.total, a.pull_mean_error.total);
    check_equal(b.pull_peak_error.total, a.pull_peak_error.total);
    check_equal(b.passes->pass[0].pull_peak_bar_N, a.passes->pass[0].pull_peak_bar_N);
    assert_int_equal(b.steps, a.steps);
    assert_false(is_there(dir, "second-pass") || is_there(dir, "checkpoint.hawser"));
    assert_int_equal(lines_in(dir, "series.csv"), 1 + 161);
    hawser_sim_free(whole);
    hawser_sim_free(again);
    folder_remove(dir);
}

/* A state of before the run brings all of it back, whatever the handle speaks of now; one of after it does, too. */
TEST(back_to_the_first)
{
    hawser_sim *const s = sim_of(data_text("trust-slack"), NULL);
    void *before, *after;
    size_t size, later;
    hawser_error err = {0};
    assert_int_equal(hawser_sim_save_memory(s, &before, &size, &err), HAWSER_OK);
    assert_int_equal(hawser_sim_run(s, NULL, NULL, NULL, &err), HAWSER_OK);
    const double peak = summary_of(s).pull_peak_N;
    assert_int_equal(hawser_sim_sample(s)->segments, 84);
    assert_int_equal(hawser_sim_save_memory(s, &after, &later, &err), HAWSER_OK);
    assert_int_equal(hawser_sim_load_memory(s, after, later, &err), HAWSER_OK);
    assert_int_equal(hawser_sim_sample(s)->segments, 84);
    check_equal(summary_of(s).pull_peak_N, peak);
    assert_non_null(summary_of(s).passes);
    if (hawser_sim_load_memory(s, before, size, &err)) fail_msg("%s", err.message);
    check_equal(hawser_sim_time(s), 0);
    assert_int_equal(hawser_sim_sample(s)->segments, 42);
    assert_null(summary_of(s).passes);
    assert_int_equal(hawser_sim_load_memory(s, after, later, &err), HAWSER_ERR_INPUT); /* that pass is gone */
    assert_int_equal(hawser_sim_run(s, NULL, NULL, NULL, &err), HAWSER_OK);
    check_equal(summary_of(s).pull_peak_N, peak);
    hawser_bytes_free(before);
    hawser_bytes_free(after);
    hawser_sim_free(s);
}

/* A second pass that would take too long is not begun: it is said how long it would take, and how to ask for it. Asked
 * for, it is made. */
TEST(too_long_is_declined)
{
    char dir[] = "/tmp/hawser-passes-XXXXXX", *summary;
    const char *const asked[] = {"solver.passes", "2", NULL};
    assert_non_null(mkdtemp(dir));
    hawser_sim *const s = sim_of(data_text("trust-slack"), NULL), *const wanted =
                                                                      sim_of(data_text("trust-slack"), asked);
    s->work_most = wanted->work_most = 1;
    assert_int_equal(hawser_sim_run(s, dir, NULL, NULL, NULL), HAWSER_OK);
    const hawser_summary sum = summary_of(s);
    assert_string_equal(sum.passes->outcome, "declined");
    assert_int_equal(sum.passes->n, 1);
    assert_int_equal(sum.segments, 42);
    assert_false(condition_of(&sum, "numerical_peak")->holds);
    check_has(sum.passes->why, "the peak may be off by 13 %");
    check_has(sum.passes->says, "set solver.passes to 2");
    double about; /* 3.1 times the first's, in two digits */
    assert_int_equal(sscanf(strstr(sum.passes->says, "in about "), "in about %lf s:", &about), 1);
    check_share(about, 3.1 * sum.passes->pass[0].wall_time_s, 0.06);
    assert_int_equal(hawser_sim_summary_json(s, &summary, NULL), HAWSER_OK);
    check_has(summary, "\"outcome\": \"declined\"");
    hawser_text_free(summary);
    assert_false(is_there(dir, "second-pass"));
    assert_int_equal(hawser_sim_run(wanted, NULL, NULL, NULL, NULL), HAWSER_OK);
    assert_string_equal(summary_of(wanted).passes->outcome, "replaced");
    hawser_sim_free(s);
    hawser_sim_free(wanted);
    folder_remove(dir);
}

/* Of a figure whose own bar is b and that is d from the other pass's (EB19), (EB20): where both agree the bar falls to
 * a quarter, where they differ it lies between what errors of second and of first order would be; of a peak, between
 * those of second order and of the order of a half (EB32). */
TEST(bars_by_two_passes)
{
    static const struct {
        int finer;
        double bar, apart, mean, peak;
    } row[] = {{0, 40, 1, 10, 10},
               {0, 40, 20, 20, 40},
               {0, 40, 12, 12, 12 * (1 + M_SQRT2)},
               {0, 10, 6, 6, 10},
               {0, 4, 6, 4, 4},
               {0, 1, 6, 2, 2},
               {1, 40, 1, 10, 10},
               {1, 40, 8, 16, 8 * (2 + M_SQRT2)},
               {1, 10, 8, 16, 16},
               {1, 40, 30, 60, 60},
               {1, 1, 0, 0.25, 0.25}};
    const Stats none = {0};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        OtherPasses other = beside(row[k].finer, 1000 + row[k].apart, 1000 - row[k].apart, 1000);
        hawser_summary sum = {.pull_mean_N = 1000,
                              .pull_peak_N = 1000,
                              .pull_mean_error = {0, row[k].bar, 0, row[k].bar},
                              .pull_peak_error = {row[k].bar / 2, row[k].bar / 2, 100, row[k].bar + 100}};
        other_passes_bars(&other, &none, NAN, &sum);
        check_share(sum.pull_mean_error.total, row[k].mean, 1e-12);
        check_share(sum.pull_peak_error.mesh, row[k].peak / 2, 1e-12);
        check_equal(sum.pull_peak_error.friction, 100); /* of which passes say nothing */
        check_share(sum.pull_peak_error.total, row[k].peak + 100, 1e-12);
        other_passes_free(&other);
    }
    /* a second pass that is not sound itself makes nothing narrower */
    OtherPasses unsound = beside(1, 1010, 1001, 0);
    unsound.unsound = 1;
    hawser_summary sum = {
        .pull_mean_N = 1000, .pull_peak_N = 1000, .pull_mean_error = {0, 8, 0, 8}, .pull_peak_error = {0, 8, 0, 8}};
    other_passes_bars(&unsound, &none, NAN, &sum);
    check_share(sum.pull_mean_error.total, 20, 1e-12);
    check_share(sum.pull_peak_error.total, 8, 1e-12);
    other_passes_free(&unsound);
}

/* A value that lies outside the bar of the pass before takes from such bars what they say of errors of second order
 * (EB29). */
TEST(a_bar_that_did_not_hold)
{
    static const struct {
        double coarser, bar, apart, expected;
    } row[] = {{20, 4, 21, 21}, {22, 4, 21, 7}, {20, 30, 21, 21}, {0, 4, 0, 1}};
    const Stats none = {0};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        OtherPasses other = beside(0, 1000 - row[k].apart, 1000, row[k].coarser);
        hawser_summary sum = {.pull_mean_N = 1000, .pull_mean_error = {0, row[k].bar, 0, row[k].bar}};
        other_passes_bars(&other, &none, NAN, &sum);
        check_share(sum.pull_mean_error.total, row[k].expected, 1e-12);
        other_passes_free(&other);
    }
}

/* A peak's bar that does not fall from pass to pass is as wide as before where they agree; the mean's is not asked
 * (EB30). */
TEST(a_bar_that_does_not_fall)
{
    static const struct {
        double alone[PASSES_MAX], expected;
    } row[] = {{{64, 70, 80}, 4}, {{64, 60, 80}, 16}, {{64, 70, 60}, 16}, {{64, 60, 50}, 64}, {{64, 64, 64}, 64}};
    const Stats none = {0};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        OtherPasses others = beside(0, 1001, 1001, 1000), before = beside(0, 1002, 1002, 1000);
        others.other[others.n++] = before.other[0];
        for (int i = 0; i < PASSES_MAX; i++) others.peak_alone[i] = row[k].alone[i];
        hawser_summary sum = {.pull_mean_N = 1000,
                              .pull_peak_N = 1000,
                              .pull_mean_error = {0, 64, 0, 64},
                              .pull_peak_error = {0, 64, 0, 64}};
        other_passes_bars(&others, &none, NAN, &sum);
        check_share(sum.pull_mean_error.total, 4, 1e-12);
        check_share(sum.pull_peak_error.total, row[k].expected, 1e-12);
        other_passes_free(&others);
    }
}

/* A mean of 1271, 1305, 1332 and 1345 N, of which the second said +- 11 N. */
TEST(passes_that_are_not_there_yet)
{
    hawser_sim *const slow = run_of(data_text("trust-slowly"), twice), *const third =
                                                                           run_of(data_text("trust-slowly"), NULL);
    const hawser_summary b = summary_of(slow), c = summary_of(third);
    assert_false(condition_of(&b, "numerical_error")->holds);
    check_at_most(0.8 * (1345 - b.pull_mean_N), b.pull_mean_error.total); /* errors fall by less than a half */
    assert_int_equal(c.passes->n, 3);
    check_at_most(fabs(1345 - c.pull_mean_N), 0.01 * 1345);
    hawser_sim_free(slow);
    hawser_sim_free(third);
}

/* The last of three falls to a sixteenth of its own bar where all agree, and no lower than a third of what the two
 * before differ by (EB27); the first is off by what it differs by from the last, and what that one may be off by
 * (EB28). */
TEST(bars_by_three_passes)
{
    static const struct {
        double bar, apart, before, expected;
    } row[] = {{64, 1, 2, 4}, {64, 20, 30, 20}, {64, 1, 60, 20}, {6, 9, 12, 6}, {2, 9, 12, 3}};
    const Stats none = {0};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        OtherPasses others = beside(0, 1000 + row[k].apart, 1000, 1000);
        OtherPasses before = beside(0, 1000 + row[k].apart + row[k].before, 1000, 0);
        others.other[others.n++] = before.other[0];
        hawser_summary sum = {
            .pull_mean_N = 1000, .pull_peak_N = 1000, .pull_mean_error = {row[k].bar, 0, 0, row[k].bar}};
        other_passes_bars(&others, &none, NAN, &sum);
        check_share(sum.pull_mean_error.total, row[k].expected, 1e-12);
        check_share(other_passes_share(&others, &sum), fmax(row[k].apart, row[k].before / 3) / 1000, 1e-12);
        other_passes_free(&others);
    }
    OtherPasses finer = beside(1, 1012, 985, 5);
    finer.n = 2;
    hawser_summary sum = {
        .pull_mean_N = 1000, .pull_peak_N = 1000, .pull_mean_error = {0, 8, 0, 8}, .pull_peak_error = {30, 60, 7, 97}};
    other_passes_bars(&finer, &none, NAN, &sum);
    check_share(sum.pull_mean_error.total, 12 + 5, 1e-12);
    check_share(sum.pull_peak_error.total, 15 + 5 + 7, 1e-12);
    check_share(other_passes_apart(&finer, 1, &sum), 15, 1e-12);
    /* a last one that is not sound itself makes bars wider only */
    finer.unsound = 1;
    sum.pull_mean_error = (hawser_error_bar){0, 50, 0, 50};
    other_passes_bars(&finer, &none, NAN, &sum);
    check_share(sum.pull_mean_error.total, 50, 1e-12);
    other_passes_free(&finer);
}

/* Six segments from roller to roller, all in step: 793 N, 741 N and 679 N, of which the finest says that it may be off
 * by 3.3 %; 674 N with eight times the segments. */
TEST(a_third_settles_it)
{
    hawser_sim *const both = run_of(data_text("trust-in-step"), twice), *const all =
                                                                            run_of(data_text("trust-in-step"), NULL);
    const hawser_summary a = summary_of(both), b = summary_of(all);
    assert_int_equal(a.passes->n, 2);
    assert_false(condition_of(&a, "numerical_peak")->holds);
    assert_int_equal(b.passes->n, 3);
    assert_string_equal(b.passes->outcome, "replaced");
    check_has(b.passes->says, "computed three times, with 86, 172 and 344 segments");
    check_has(b.passes->says, "all figures are those of the third pass");
    check_equal(b.passes->pass[1].pull_peak_N, a.pull_peak_N);
    check_equal(b.passes->pass[2].pull_peak_N, b.pull_peak_N);
    check_equal(b.passes->pass[2].friction, 0.25);
    check_equal(b.passes->pass[2].accuracy, 1e-3 / 16);
    assert_int_equal(b.segments, 344);
    assert_int_equal(hawser_sim_sample(all)->pass, 3);
    assert_true(condition_of(&b, "numerical_peak")->holds);
    check_at_most(fabs(b.pull_peak_N - 674), b.pull_peak_error.total);
    hawser_sim_free(both);
    hawser_sim_free(all);
}

/* The same with a length of segments that the case gives: the first one's figures, to the last bit, and the bars that
 * all three come to. One that differs by more than is allowed from the second already asks for no third. */
TEST(a_third_is_compared)
{
    static const char *const one[] = {"chain.0.segment", "0.2 m", "solver.passes", "1", NULL},
                             *const given[] = {"chain.0.segment", "0.2 m", NULL},
                             *const coarse[] = {"chain.0.segment", "0.5 m", NULL};
    hawser_sim *const first = run_of(data_text("trust-in-step"), one),
                      *const all = run_of(data_text("trust-in-step"), given),
                      *const off = run_of(data_text("trust-in-step"), coarse);
    const hawser_summary a = summary_of(first), b = summary_of(all), c = summary_of(off);
    assert_int_equal(b.passes->n, 3);
    assert_string_equal(b.passes->outcome, "compared");
    check_has(b.passes->says, "they are those of the first pass, with bars from all");
    check_equal(b.pull_mean_N, a.pull_mean_N);
    check_equal(b.pull_peak_N, a.pull_peak_N);
    const double apart = fabs(b.passes->pass[2].pull_peak_N - a.pull_peak_N);
    check_at_most(apart, b.pull_peak_error.total);
    check_at_most(b.pull_peak_error.total, (1 + 1e-12) * (apart + b.passes->pass[2].pull_peak_bar_N));
    check_at_most(fabs(a.pull_peak_N - 674), b.pull_peak_error.total);
    assert_int_equal(c.passes->n, 2);
    assert_false(condition_of(&c, "numerical_peak")->holds);
    hawser_sim_free(first);
    hawser_sim_free(all);
    hawser_sim_free(off);
}

static int stop_third(void *user, const hawser_sample *sample, double wall_s, double end_s)
{
    (void)user, (void)wall_s, (void)end_s;
    return sample->pass == 3;
}

/* Stopped in the third pass, with nothing kept: what two passes have come to stands. One that would take too long is
 * not begun. */
TEST(without_a_third)
{
    static const char *const unkept[] = {"run.checkpoint", "0", NULL};
    char dir[] = "/tmp/hawser-passes-XXXXXX";
    hawser_error err = {0};
    assert_non_null(mkdtemp(dir));
    hawser_sim *const first = run_of(data_text("trust-in-step"), once);
    hawser_sim *const both = run_of(data_text("trust-in-step"), twice);
    hawser_sim *const stopped = sim_of(data_text("trust-in-step"), unkept);
    hawser_sim *const declined = sim_of(data_text("trust-in-step"), NULL);
    const hawser_summary one = summary_of(first), two = summary_of(both);
    assert_int_equal(hawser_sim_run(stopped, dir, stop_third, NULL, &err), HAWSER_STOPPED);
    check_has(err.message, "the results are those of the second");
    const hawser_summary a = summary_of(stopped);
    check_has(a.passes->says, "a third one was stopped");
    check_equal(a.pull_peak_N, two.pull_peak_N);
    check_equal(a.pull_peak_error.total, two.pull_peak_error.total);
    assert_false(is_there(dir, "second-pass") || is_there(dir, "third-pass") || is_there(dir, "checkpoint.hawser"));

    declined->work_most = 3.2 * (double)one.rhs_evals * one.segments; /* enough for a second one */
    assert_int_equal(hawser_sim_run(declined, NULL, NULL, NULL, &err), HAWSER_OK);
    const hawser_summary b = summary_of(declined);
    assert_int_equal(b.passes->n, 2);
    check_has(b.passes->says, "set solver.passes to 3");
    check_equal(b.pull_peak_N, two.pull_peak_N);
    hawser_sim_free(first);
    hawser_sim_free(both);
    hawser_sim_free(stopped);
    hawser_sim_free(declined);
    folder_remove(dir);
}

/* Stopped in the third pass and gone on with: as in one go, to the last bit. */
TEST(the_third_is_resumed)
{
    char dir[] = "/tmp/hawser-passes-XXXXXX";
    hawser_error err = {0};
    assert_non_null(mkdtemp(dir));
    hawser_sim *const whole = run_of(data_text("trust-in-step"), NULL);
    hawser_sim *const s = sim_of(data_text("trust-in-step"), NULL);
    assert_int_equal(hawser_sim_run(s, dir, stop_third, NULL, &err), HAWSER_STOPPED);
    check_has(err.message, "until it is resumed");
    assert_true(is_there(dir, "second-pass") && is_there(dir, "third-pass") && is_there(dir, "checkpoint.hawser"));
    hawser_sim *const again = resumed(dir, NULL, HAWSER_OK);
    const hawser_summary a = summary_of(whole), b = summary_of(again);
    assert_int_equal(b.passes->n, 3);
    check_equal(b.pull_peak_N, a.pull_peak_N);
    check_equal(b.pull_mean_error.total, a.pull_mean_error.total);
    check_equal(b.pull_peak_error.total, a.pull_peak_error.total);
    assert_int_equal(b.steps, a.steps);
    assert_false(is_there(dir, "second-pass") || is_there(dir, "third-pass") || is_there(dir, "checkpoint.hawser"));
    hawser_sim_free(whole);
    hawser_sim_free(s);
    hawser_sim_free(again);
    folder_remove(dir);
}
