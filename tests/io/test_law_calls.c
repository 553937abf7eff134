/* What a law of force may not do while it is called, what it gives that is no number, and simulations in processes that
 * are forked. */
#include <math.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "hawser/hawser.h"
#include "tests/support/check.h"

static const char text[] = "cables: {c: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 10 kN m2, d: 90 mm, mass: 20 kg/m}}\n"
                           "chain: [{cable: c, length: 4 m, segment: 1 m}]\n"
                           "route: {head_at: 4 m, pieces: [{straight: 6 m}]}\n"
                           "rollers: {along: {from: 0 m, to: 6 m, spacing: 1 m}}\n"
                           "drive: {winch: {speed: 0.5 m/s, to: 100 ms}, tail: {tension: 1 kN, ramp: none}}\n"
                           "run: {duration: 300 ms, steady_from: 200 ms}\n"
                           "solver: {passes: 1}\n";

static hawser_sim *sim_make(int threads)
{
    hawser_error err = {0};
    hawser_case *c = NULL;
    hawser_sim *s = NULL;
    if (hawser_case_parse(text, "small.yaml", &c, &err) ||
        hawser_sim_new(c, &(hawser_options){.threads = threads}, &s, &err))
        fail_msg("%s", err.message);
    hawser_case_free(c);
    return s;
}

typedef struct Meddler {
    hawser_sim *s;
    int calls, allowed; /* what was not refused */
} Meddler;

static int meddle(void *user, const hawser_segment_now *at, double wrench[6], double by_place[36], double by_motion[36])
{
    Meddler *const m = user;
    hawser_error err = {0};
    void *bytes = NULL;
    size_t size;
    (void)at, (void)wrench, (void)by_place, (void)by_motion;
    if (m->calls++) return 0;
    hawser_sim_free(m->s); /* was a SIGSEGV */
    const hawser_status done[] = {hawser_sim_set_law(m->s, 0, 0, NULL, 0, NULL, &err),
                                  hawser_sim_force(m->s, 0, NULL, 0, &err),
                                  hawser_sim_control(m->s, HAWSER_WINCH_BRAKE, NULL, 0, 0, &err),
                                  hawser_sim_relax(m->s, NULL, &err),
                                  hawser_sim_save_memory(m->s, &bytes, &size, &err),
                                  hawser_sim_save(m->s, "/nowhere/state", &err),
                                  hawser_sim_advance(m->s, 1, 0, &err),
                                  hawser_sim_run(m->s, NULL, NULL, NULL, &err)};
    for (size_t k = 0; k < sizeof done / sizeof *done; k++) {
        m->allowed += done[k] != HAWSER_ERR_INPUT;
        if (done[k] && !strstr(err.message, "call-back")) m->allowed += 100;
    }
    hawser_bytes_free(bytes);
    return 0;
}

/* Taking the law away within it was a SIGSEGV; relax and save were allowed while it relaxed, and refused elsewhere. */
TEST(test_refused)
{
    hawser_error err = {0};
    for (int relaxes = 0; relaxes < 2; relaxes++) {
        Meddler m = {.s = sim_make(1)};
        assert_int_equal(hawser_sim_set_law(m.s, 0, 4, meddle, 0, &m, &err), HAWSER_OK);
        const hawser_status status =
            relaxes ? hawser_sim_relax(m.s, NULL, &err) : hawser_sim_advance(m.s, 0.01, 0, &err);
        if (status) fail_msg("%s", err.message);
        assert_true(m.calls > 0);
        assert_int_equal(m.allowed, 0);
        assert_int_equal(hawser_sim_set_law(m.s, 0, 0, NULL, 0, NULL, &err), HAWSER_OK); /* outside */
        hawser_sim_free(m.s);
    }
}

static int no_number(void *user, const hawser_segment_now *at, double wrench[6], double by_place[36],
                     double by_motion[36])
{
    (void)user, (void)by_place, (void)by_motion;
    wrench[0] = at->segment == 2 ? NAN : 0;
    return 0;
}

/* This was "the steps have become too small to move on: try a softer contact.k". */
TEST(test_no_number)
{
    hawser_error err = {0};
    for (int relaxes = 0; relaxes < 2; relaxes++) {
        hawser_sim *const s = sim_make(1);
        assert_int_equal(hawser_sim_set_law(s, 0, 4, no_number, 0, NULL, &err), HAWSER_OK);
        const hawser_status status = relaxes ? hawser_sim_relax(s, NULL, &err) : hawser_sim_advance(s, 0.1, 0, &err);
        assert_int_equal(status, HAWSER_ERR_RUN);
        check_has(err.message, "law of force");
        check_has(err.message, "segment 2");
        if (strstr(err.message, "contact.k")) fail_msg("%s", err.message);
        hawser_sim_free(s);
    }
}

/* A forked process has no second thread: giving the simulation back waited for it for ever, 10 times of 11. */
TEST(test_forked)
{
    for (int works = 0; works < 2; works++) {
        int how = -1;
        hawser_error err = {0};
        hawser_sim *const s = sim_make(2);
        assert_int_equal(hawser_sim_advance(s, 0.05, 0, &err), HAWSER_OK);
        const pid_t child = fork();
        if (!child) {
            alarm(60);
            if (works && hawser_sim_advance(s, 0.1, 0, &err)) _exit(3);
            hawser_sim_free(s);
            _exit(0);
        }
        assert_int_equal(waitpid(child, &how, 0), child);
        assert_true(WIFEXITED(how));
        assert_int_equal(WEXITSTATUS(how), 0);
        assert_int_equal(hawser_sim_advance(s, 0.1, 0, &err), HAWSER_OK);
        hawser_sim_free(s);
    }
}
