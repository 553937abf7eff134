/* The balances of every case that comes with the program close: any force that is not the derivative of what is called
 * its energy, any worker that is forgotten, shows here. */
#include "tests/io/case_fixture.h"

#include <glob.h>

#include "hawser/hawser.h"

/* At the default accuracy, over the first seconds of the pull: start and run, with all their transients. */
static const double ENERGY_MOST = 1e-3, MOMENTUM_MOST = 4e-4;
/* Segments that leave a drum with a jerk: between 2e-4 and 2.6e-3 as the accuracy goes from 0.9 to 1.1 of the default.
 */
static const double JERKS_MOST = 3e-3;
/* Where less than 100 J go over rollers that spin, tilt, guide, or hold the cable in a groove. */
static const double SMALL_MOST = 5e-3;
/* Where friction sticks, bristles move between steps and the rates within one are of first order in its length. */
static const double STICKS_MOST = 2e-2;

/* With 41 steps or 44 in two seconds, as accuracy or rounding will: 2e-4 or 1.5e-3; at half of that 2.5e-4 with either.
 */
static const char *accuracy_of(const char *name) { return strstr(name, "huangjiahu") ? "5e-4" : NULL; }

/* How long to run a case: those that take long per second run shorter. */
static const char *duration_of(const char *name)
{
    static const struct {
        const char *name, *duration;
    } shorter[] = {{"crossing", "0.6 s"},     {"limits", "0.6 s"},   {"guide-rollers", "0.6 s"},
                   {"drum-contact", "0.6 s"}, {"tunnel-879", "4 s"}, {"rollers-v-groove", "1.2 s"}};
    for (size_t k = 0; k < sizeof shorter / sizeof *shorter; ++k) {
        if (strstr(name, shorter[k].name)) return shorter[k].duration;
    }
    return "2 s";
}

static void set(hawser_case *c, const char *key, const char *value)
{
    hawser_error err;
    if (hawser_case_set(c, key, value, &err)) fail_msg("%s", err.message);
}

/* Runs one case; returns whether it has a balance. */
static int case_closes(const char *file)
{
    hawser_case *c;
    hawser_sim *s;
    hawser_error err;
    hawser_summary sum;
    if (hawser_case_load(file, &c, &err)) fail_msg("%s", err.message);
    const int rod = strstr(file, "/rod-") != NULL;
    const int moves = !rod && strstr(file, "/positions") == NULL; /* in time: a whole pull takes too long */
    if (moves) {
        set(c, "run.duration", duration_of(strrchr(file, '/')));
        set(c, "run.steady_from", "0.5 s");
        if (accuracy_of(file)) set(c, "solver.accuracy", accuracy_of(file));
    }
    if (hawser_sim_new(c, NULL, &s, &err) || hawser_sim_run(s, NULL, NULL, NULL, &err))
        fail_msg("%s: %s", file, err.message);
    hawser_sim_summary(s, &sum);
    const hawser_balance *const b = sum.balance;
    if (b) {
        print_message("%-24s energy %.1e of %10.4g J (%s), momentum %.1e\n", strrchr(file, '/') + 1, b->residual_share,
                      b->turnover_J, b->turnover_of, b->impulse_residual_share);
        const char *const name = strrchr(file, '/');
        const double most = strstr(name, "stick")                               ? STICKS_MOST
                            : strstr(name, "rollers") || strstr(name, "limits") ? SMALL_MOST
                                                                                : ENERGY_MOST;
        if (!(b->residual_share < most)) fail_msg("%s: energy %g J is not accounted for", file, b->residual_J);
        check_below(b->impulse_residual_share, strstr(file, "drum-contact") ? JERKS_MOST : MOMENTUM_MOST);
        check_above(b->n_terms, 3);
        check_above(b->turnover_J, 0);
    }
    const int any = b != NULL;
    hawser_sim_free(s);
    hawser_case_free(c);
    return any;
}

TEST(every_case_closes)
{
    glob_t files;
    int closed = 0;
    assert_int_equal(glob(HAWSER_SOURCE_DIR "/cases/*.yaml", 0, NULL, &files), 0);
    for (size_t k = 0; k < files.gl_pathc; k++) closed += case_closes(files.gl_pathv[k]);
    check_at_least(closed, 18);
    globfree(&files);
}

/* Segments that leave the reel and pass the winch bring and take energy and momentum, and the books know: a short reel
 * and a winch close by, so that some of each do. */
TEST(comers_and_goers)
{
    hawser_case *c;
    hawser_sim *s;
    hawser_error err;
    hawser_summary sum;
    if (hawser_case_load(HAWSER_SOURCE_DIR "/cases/take-in.yaml", &c, &err)) fail_msg("%s", err.message);
    set(c, "run.duration", "25 s");
    set(c, "run.steady_from", "5 s");
    set(c, "solver.accuracy", "1e-5");
    if (hawser_sim_new(c, NULL, &s, &err) || hawser_sim_relax(s, NULL, &err)) fail_msg("%s", err.message);
    const int before = hawser_sim_sample(s)->first;
    if (hawser_sim_advance(s, 25, 0, &err)) fail_msg("%s", err.message);
    const int joined = before - hawser_sim_sample(s)->first;
    hawser_sim_summary(s, &sum);
    const hawser_balance *const b = sum.balance;
    print_message("%d joined: carried %.4g J, residual %.3g J of %.4g J\n", joined, b->carried_J, b->residual_J,
                  b->turnover_J);
    check_above(joined, 3);
    check_above(fabs(b->carried_J), 10 * fabs(b->residual_J));
    check_below(b->residual_share, 1e-5);
    check_below(b->impulse_residual_share, 1e-5);
    hawser_sim_free(s);
    hawser_case_free(c);
}
