/* Certificates: a run whose figures are right holds at once and cheaply; one whose figures are not is never certified,
 * and the certificate says why and with what settings they would be. */
#include "io/api/api_certify.h"
#include "tests/io/case_fixture.h"

/* A run to its end, and its certificate. */
typedef struct Certified {
    hawser_case *c;
    hawser_sim *sim;
    hawser_certificate *cert;
} Certified;

static Certified certify(const char *text, const char *const *settings, const hawser_certify_options *options)
{
    Certified z = {.c = case_with(text, settings)};
    hawser_error err = {0};
    if (hawser_sim_new(z.c, NULL, &z.sim, &err)) fail_msg("%s", err.message);
    if (hawser_sim_run(z.sim, NULL, NULL, NULL, &err)) fail_msg("%s", err.message);
    if (hawser_certify(z.c, z.sim, options, &z.cert, &err)) fail_msg("%s", err.message);
    print_message("%s\n", z.cert->verdict);
    return z;
}

static void certified_free(Certified *z)
{
    hawser_certificate_free(z->cert);
    hawser_sim_free(z->sim);
    hawser_case_free(z->c);
}

static const hawser_certified *figure(const hawser_certificate *cert, const char *name)
{
    for (int i = 0; i < cert->n_figures; i++)
        if (!strcmp(cert->figure[i].name, name)) return &cert->figure[i];
    fail_msg("there is no figure '%s'", name);
    return NULL;
}

/* What every certificate keeps. */
static void consistent(const hawser_certificate *cert)
{
    int all = 1;
    double work = 0;
    for (int i = 0; i < cert->n_figures; i++) {
        const hawser_certified *const f = &cert->figure[i];
        double sum = 0;
        for (int s = 0; s < HAWSER_SOURCES; s++) sum += f->error[s];
        if (!isnan(f->bar)) check_close(f->bar, sum, 1e-12 * sum);
        if (!isnan(f->bar)) check_close(f->run_bar, f->bar + fabs(f->value - f->best), 1e-12 * f->run_bar);
        check_close(f->allowed, cert->tolerance * fmax(fabs(f->best), f->floor), 1e-12 * f->allowed);
        assert_int_equal(f->holds, f->bar <= f->allowed);
        all &= f->run_holds;
    }
    for (int r = 1; r < cert->n_runs; r++) work += cert->run[r].work;
    check_share(cert->work, work, 1e-12);
    if (cert->certified) assert_true(all);
    assert_int_equal(cert->certified, strncmp(cert->verdict, "CERTIFIED: ", 11) == 0);
}

/* A level row of rollers: the pull is mu m g L of what has passed, known beforehand. */
TEST(a_good_run)
{
    Certified z = certify(data_text("certify"), NULL, NULL);
    consistent(z.cert);
    assert_int_equal(z.cert->certified, 1);
    assert_int_equal(z.cert->n_runs, 2 + HAWSER_SOURCES);
    check_at_most(z.cert->work, 6);
    const hawser_certified *const pull = figure(z.cert, "pull, mean");
    hawser_summary sum;
    hawser_sim_summary(z.sim, &sum);
    check_equal(pull->value, sum.pull_mean_N);
    check_equal(pull->best, pull->value);
    check_close(pull->floor, 0.2 * 20 * 9.81, 1e-9);
    certified_free(&z);
}

/* Coarse segments: what a run with segments an eighth as long, a hundredth of the accuracy and a fifth of v_s finds
 * lies within the bars, which are not much wider than they have to be. */
TEST(bars_hold_the_truth)
{
    const char *const coarse[] = {"chain.0.segment", "250 mm", "friction.v_s", "1 mm/s", "output.interval",
                                  "50 ms",           NULL};
    const char *const fine[] = {"chain.0.segment", "31.25 mm",        "friction.v_s",
                                "0.2 mm/s",        "solver.accuracy", "1e-5",
                                "output.interval", "12.5 ms",         NULL};
    const char *const names[] = {"pull, mean", "pull, peak", "tension at middle, mean"};
    const hawser_certify_options once = {.rounds = 1};
    Certified z = certify(data_text("certify"), coarse, &once), truth = certify(data_text("certify"), fine, &once);
    for (int k = 0; k < 3; k++) {
        const hawser_certified *const f = figure(z.cert, names[k]);
        const double error = fabs(f->value - figure(truth.cert, names[k])->value);
        check_at_most(error, f->run_bar);
        if (k < 2) check_at_most(f->run_bar, 5 * error);
    }
    certified_free(&z);
    certified_free(&truth);
}

/* Ten thousandths are not reached by first order steps: not certified, and no figure is said to hold that does not. */
TEST(too_much_is_asked)
{
    const hawser_certify_options strict = {.tolerance = 1e-6, .rounds = 1, .threads = 1};
    Certified z = certify(data_text("certify"), NULL, &strict);
    consistent(z.cert);
    assert_int_equal(z.cert->certified, 0);
    assert_int_equal(z.cert->n_runs, 2 + HAWSER_SOURCES);
    check_has(z.cert->verdict, "NOT CERTIFIED: to 0.0001 % do not hold: ");
    check_has(z.cert->verdict, "tried in 4 runs down to solver.accuracy 2.5e-05");
    certified_free(&z);
}

/* However much is asked, the finer runs take no more than they may, and it is said what going on would take; where
 * finer segments would take too much the coarser ones speak for them, and the bar still holds what is finer. */
TEST(effort_is_kept)
{
    const hawser_certify_options usual = {.tolerance = 1e-6}, little = {.effort = 3};
    Certified z = certify(data_text("certify"), NULL, &usual), few = certify(data_text("certify"), NULL, &little);
    consistent(z.cert);
    check_at_most(z.cert->work, 6);
    check_has(z.cert->verdict, "; finer ones would take about ");
    check_has(z.cert->verdict, " times the run: --effort ");
    check_at_most(few.cert->work, 3.05); /* up to the end of a step */
    const hawser_certify_run *const last = &few.cert->run[few.cert->n_runs - 1];
    assert_int_equal(last->level[HAWSER_LENGTH], 1);
    check_has(last->message, "(see --effort)");
    const hawser_certified *const rough = figure(few.cert, "pull, mean"), *const whole = figure(z.cert, "pull, mean");
    check_nan(rough->refined[HAWSER_LENGTH]);
    check_at_most(whole->error[HAWSER_LENGTH], rough->error[HAWSER_LENGTH]);
    certified_free(&z);
    certified_free(&few);
}

/* A stiff grip at a loose accuracy pulls many times what it should: finer settings find it. */
TEST(a_stiff_grip)
{
    const char *const loose[] = {"conveyors", "[{from: 6, to: 8, clamp: 9 kN, mu: 0.5, v_s: 0.1 mm/s}]",
                                 "solver.accuracy", "1e-1", NULL};
    const hawser_certify_options two = {.rounds = 2, .effort = 60};
    Certified z = certify(data_text("certify"), loose, &two);
    consistent(z.cert);
    const hawser_certified *const pull = figure(z.cert, "pull, mean");
    print_message("pull %g N, finest %g N +- %g N, run +- %g N\n", pull->value, pull->best, pull->bar, pull->run_bar);
    assert_int_equal(z.cert->certified, 0);
    certified_free(&z);
}

/* Threads change nothing but the time. */
TEST(one_thread_or_two)
{
    const hawser_certify_options one = {.threads = 1, .rounds = 1}, two = {.threads = 2, .rounds = 1};
    Certified a = certify(data_text("certify"), NULL, &one), b = certify(data_text("certify"), NULL, &two);
    assert_int_equal(a.cert->n_figures, b.cert->n_figures);
    for (int i = 0; i < a.cert->n_figures; i++) {
        for (int s = 0; s < HAWSER_SOURCES; s++)
            check_equal(a.cert->figure[i].refined[s], b.cert->figure[i].refined[s]);
    }
    certified_free(&a);
    certified_free(&b);
}

/* Slower than friction needs: its figures may hold, but there is nothing to certify. */
TEST(not_trusted)
{
    const char *const few[] = {"friction.v_s", "200 mm/s", "friction.v_d", "400 mm/s", NULL};
    const hawser_certify_options once = {.rounds = 1};
    Certified z = certify(data_text("certify"), few, &once);
    consistent(z.cert);
    assert_int_equal(z.cert->certified, 0);
    check_has(z.cert->verdict, "NOT CERTIFIED: the run is not to be trusted (friction_speed");
    certified_free(&z);
}

/* A cantilever of ten segments under a load at its tip: the tip's figures converge with the segments' number squared.
 */
TEST(a_rod)
{
    const hawser_certify_options options = {.tolerance = 1e-3, .rounds = 3, .effort = 60};
    Certified z = certify(data_text("certify-rod"), NULL, &options);
    consistent(z.cert);
    const hawser_certified *const tip = figure(z.cert, "displacement of tip, z");
    assert_int_equal(z.cert->n_runs > 4, 1);
    check_close(tip->order[HAWSER_LENGTH], 2, 0.1);
    /* the bar holds the truth, P L^3/3EI with shear P L/GA, and is not much wider */
    const double truth = -(0.1 / 3 / 100 + 0.1 / 1e6);
    check_at_most(fabs(tip->best - truth), tip->bar);
    check_at_most(tip->bar, 5 * fabs(tip->best - truth));
    certified_free(&z);
}

/* Half a turn is said as r or -r, as rounding has it: both are the same place (CE8). A strip that is rolled up to a
 * circle has its middle there on every mesh. */
TEST(half_a_turn)
{
    Figure own[] = {{.unit = "N", .value = 1}, {.unit = "rad"}, {.unit = "rad", .value = -3.1}, {.unit = "rad"}};
    Figure other[] = {{.unit = "N", .value = -1}, {.unit = "rad"}, {.unit = "rad", .value = 3.1}, {.unit = "rad"}};
    figures_follow(&(Figures){.n = 4, .figure = own}, &(Figures){.n = 4, .figure = other});
    check_equal(other[0].value, -1); /* no rotation */
    check_close(other[2].value, 3.1 - 2 * M_PI, 1e-12);
    figures_follow(&(Figures){.n = 4, .figure = own}, &(Figures){.n = 4, .figure = other});
    check_close(other[2].value, 3.1 - 2 * M_PI, 1e-12); /* it is as near as it comes */

    const char *const circle[] = {"rod.loads",
                                  "[{name: roll, at: 1 m, direction: [0, -1, 0], moment: 628.3185307 N m}]",
                                  "output.probes",
                                  "[{name: middle, at: 0.5 m}]",
                                  "run.stability",
                                  "ignore",
                                  "run.load_steps",
                                  "20",
                                  NULL};
    const hawser_certify_options once = {.rounds = 1};
    Certified z = certify(data_text("certify-rod"), circle, &once);
    check_share(fabs(figure(z.cert, "rotation of middle, y")->value), M_PI, 1e-6);
    check_at_most(figure(z.cert, "rotation of middle, y")->bar, 1e-3);
    certified_free(&z);
}

/* The texts hold what the struct holds. */
TEST(texts)
{
    const hawser_certify_options once = {.rounds = 1};
    const hawser_format formats[] = {HAWSER_JSON, HAWSER_CSV, HAWSER_TABLE};
    const char *const holds[][2] = {{"\"verdict\": \"CERTIFIED: all", "\"error.time\""},
                                    {"name,unit,value,bar,allowed,holds", "\"pull, mean\",N,"},
                                    {"Errors by source", "pull, mean"}};
    Certified z = certify(data_text("certify"), NULL, &once);
    for (int k = 0; k < 3; k++) {
        char *text = NULL;
        assert_int_equal(hawser_certificate_text(z.cert, formats[k], &text, NULL), HAWSER_OK);
        for (int i = 0; i < 2; i++) check_has(text, holds[k][i]);
        hawser_text_free(text);
    }
    certified_free(&z);
}

static int stop_at_once(void *user, const hawser_certify_state *state)
{
    *(int *)user += state->runs > 0;
    return 1;
}

/* Wrong options, a run that is not over, and a caller who has seen enough. */
TEST(refused)
{
    hawser_error err = {0};
    hawser_sim *sim = NULL;
    hawser_certificate *cert = NULL;
    int calls = 0;
    const hawser_certify_options wrong = {.tolerance = 1.5}, stop = {.progress = stop_at_once, .user = &calls};
    hawser_case *const c = case_with(data_text("certify"), NULL);
    assert_int_equal(hawser_sim_new(c, NULL, &sim, NULL), HAWSER_OK);
    assert_int_equal(hawser_certify(c, sim, NULL, &cert, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "a run that ended at 0 s of 4 s cannot be certified");
    assert_null(cert);
    assert_int_equal(hawser_sim_run(sim, NULL, NULL, NULL, NULL), HAWSER_OK);
    assert_int_equal(hawser_certify(c, sim, &wrong, &cert, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "a certificate's tolerance is a share below 1");
    assert_int_equal(hawser_certify(c, sim, &stop, &cert, &err), HAWSER_STOPPED);
    assert_null(cert);
    assert_true(calls > 0);
    hawser_sim_free(sim);
    hawser_case_free(c);
}

/* Levels change settings and nothing else: level 0 is the case as it is. */
TEST(levels)
{
    SceneDef def;
    const int none[HAWSER_SOURCES] = {0}, some[HAWSER_SOURCES] = {1, 2};
    expect_good(data_text("certify"), NULL, NULL, &def);
    const int segments = def.pieces[0].segments;
    const double accuracy = def.solver.accuracy, v_s = def.surfaces[0].friction.v_s, v_d = def.surfaces[0].friction.v_d;
    scene_def_refine(&def, none);
    assert_int_equal(def.pieces[0].segments, segments);
    check_equal(def.solver.accuracy, accuracy);
    check_equal(def.surfaces[0].friction.v_s, v_s);
    scene_def_refine(&def, some);
    assert_int_equal(def.pieces[0].segments, 4 * segments);
    check_share(def.solver.accuracy, accuracy / 4, 1e-12);
    check_share(def.surfaces[0].friction.v_s, v_s / 2, 1e-12);
    check_equal(def.surfaces[0].friction.v_d, v_d);
    check_equal(refinement_slower(&def, 3), 1.0 / 8);
    scene_def_clear(&def);
}

/* A run whose figures are those of its second pass: these are certified, refined from its settings, and by what the
 * case says of v_s, not by what the pass made of it. */
TEST(a_second_pass)
{
    const hawser_certify_options once = {.rounds = 1};
    Certified z = certify(data_text("trust-slack"), NULL, &once);
    hawser_summary sum;
    hawser_sim_summary(z.sim, &sum);
    consistent(z.cert);
    assert_string_equal(sum.passes->outcome, "replaced");
    assert_int_equal(z.cert->n_runs, 2 + HAWSER_SOURCES);
    check_equal(figure(z.cert, "pull, peak")->value, sum.pull_peak_N);
    check_equal(z.cert->run[0].accuracy, 2.5e-4);
    check_equal(z.cert->run[0].friction, 0.5);
    assert_int_equal(z.cert->run[0].segments, 84);
    for (int r = 0; r < z.cert->n_runs; r++) {
        const hawser_certify_run *const run = &z.cert->run[r];
        assert_int_equal(run->status, HAWSER_OK); /* a second pass's bound on steps is not theirs */
        check_share(run->accuracy, 2.5e-4 * pow(4, -run->level[HAWSER_TIME]), 1e-12);
        check_share(run->friction, 0.5 * pow(2, -run->level[HAWSER_TIME]), 1e-12);
        assert_int_equal(run->segments, (int)(84 * pow(2, run->level[HAWSER_LENGTH])));
    }
    /* 1908 N on segments a quarter as long as the first pass's, 2125 N by that */
    const hawser_certified *const peak = figure(z.cert, "pull, peak");
    check_at_most(fabs(peak->value - 1908), peak->run_bar);
    certified_free(&z);
}
