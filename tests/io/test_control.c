/* A simulation that is told what to do: every command against what it must bring about, its event, and the same from a
 * case's script; what cannot be done is refused and changes nothing. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "tests/support/check.h"
#include "tests/support/data.h"

#include "sim/run/commands.h"

static hawser_sim *sim_of(const char *text)
{
    hawser_case *c = NULL;
    hawser_sim *s = NULL;
    hawser_error err = {0};
    if (hawser_case_parse(text, "control", &c, &err) || hawser_sim_new(c, NULL, &s, &err) ||
        hawser_sim_relax(s, NULL, &err))
        fail_msg("%s", err.message);
    hawser_case_free(c);
    return s;
}

static void advance(hawser_sim *s, double t)
{
    hawser_error err = {0};
    if (hawser_sim_advance(s, t, 0, &err)) fail_msg("%s", err.message);
}

static void tell(hawser_sim *s, hawser_control what_to_do, const char *what, double value, double ramp)
{
    hawser_error err = {0};
    if (hawser_sim_control(s, what_to_do, what, value, ramp, &err)) fail_msg("%s", err.message);
}

static const hawser_event *last_event(hawser_sim *s)
{
    const hawser_event *event;
    const int n = hawser_sim_events(s, &event);
    assert_true(n > 0);
    return &event[n - 1];
}

/* Mean of the winch's force over a second, by rows 10 ms apart. */
static double mean_pull(hawser_sim *s)
{
    double sum = 0;
    const double t = hawser_sim_time(s);
    for (int k = 1; k <= 100; ++k) {
        advance(s, t + 0.01 * k);
        sum += hawser_sim_sample(s)->winch_force;
    }
    return sum / 100;
}

/* The rope hauls in the integral of the speed that was set; (K2). */
static void test_winch_speed(void **state)
{
    (void)state;
    hawser_sim *const s = sim_of(data_text("short-pull"));
    advance(s, 2);
    tell(s, HAWSER_WINCH_SPEED, NULL, 0.2, 0.5);
    const hawser_event *const event = last_event(s);
    assert_int_equal(event->code, HAWSER_EVENT_COMMAND + HAWSER_WINCH_SPEED);
    check_equal(event->t, 2);
    assert_string_equal(event->what, "command: winch_speed 0.2 m/s, over 0.5 s");
    const double before = hawser_sim_sample(s)->winch_travel;
    advance(s, 2.25);
    check_close(hawser_sim_sample(s)->winch_speed, 0.15, 1e-12);
    advance(s, 3);
    check_close(hawser_sim_sample(s)->winch_travel - before, 0.5 * 0.15 + 0.5 * 0.2, 1e-12);
    hawser_sim_free(s);
}

/* A pause, and the profile that goes on where it was left; a brake of a winch whose speed was set. */
static void test_winch_pause(void **state)
{
    (void)state;
    hawser_sim *const s = sim_of(data_text("short-pull"));
    advance(s, 0.5); /* half-way up the ramp, 0.05 m/s */
    tell(s, HAWSER_WINCH_PAUSE, NULL, 0, 0.1);
    advance(s, 1);
    assert_int_equal(last_event(s)->code, HAWSER_EVENT_WINCH_STOPPED);
    check_close(last_event(s)->t, 0.6, 1e-9);
    check_close(hawser_sim_sample(s)->winch_speed, 0, 1e-15);
    tell(s, HAWSER_WINCH_RESTART, NULL, 0, 0.1);
    advance(s, 1.1);
    assert_int_equal(last_event(s)->code, HAWSER_EVENT_WINCH_RUNS);
    check_close(hawser_sim_sample(s)->winch_speed, 0.05, 1e-9);
    advance(s, 1.7); /* the other half of the case's ramp is done */
    check_close(hawser_sim_sample(s)->winch_speed, 0.1, 1e-9);
    tell(s, HAWSER_WINCH_SPEED, NULL, 0.15, 0.1);
    advance(s, 1.9);
    tell(s, HAWSER_WINCH_BRAKE, NULL, 0, 0.2);
    advance(s, 2.2);
    tell(s, HAWSER_WINCH_RESTART, NULL, 0, 0.2);
    advance(s, 2.5);
    check_close(hawser_sim_sample(s)->winch_speed, 0.15, 1e-12);
    hawser_sim_free(s);
}

/* Two simulations of the same pull, of which one is told something: what its mean pull is over the next second, against
 * that of the other, which is left alone. */
typedef struct Pair {
    hawser_sim *told, *alone;
} Pair;

static Pair pair_new(void)
{
    const Pair p = {sim_of(data_text("short-pull")), sim_of(data_text("short-pull"))};
    advance(p.told, 2);
    advance(p.alone, 2);
    return p;
}

/* At t, and over the second from there on; *alone gets the other's. */
static double told_pull(Pair *p, double t, double *alone)
{
    advance(p->told, t);
    advance(p->alone, t);
    *alone = mean_pull(p->alone);
    return mean_pull(p->told);
}

static double told_more(Pair *p, double t)
{
    double alone;
    const double told = told_pull(p, t, &alone);
    return told - alone;
}

/* The books close whatever was told. */
static void pair_close(Pair *p)
{
    hawser_summary sum;
    hawser_sim_summary(p->told, &sum);
    check_below(sum.balance->residual_share, 1e-3);
    hawser_sim_free(p->told);
    hawser_sim_free(p->alone);
}

/* Twice the friction is twice the pull, and back; what was solved in the plane goes on in space (K6). */
static void test_friction(void **state)
{
    (void)state;
    Pair p = pair_new();
    hawser_summary sum;
    double alone;
    hawser_sim_summary(p.told, &sum);
    assert_true(sum.planar);
    tell(p.told, HAWSER_FRICTION, NULL, 2, 0.3);
    hawser_sim_summary(p.told, &sum);
    assert_false(sum.planar);
    check_has(sum.planar_why, "friction");
    const double twice = told_pull(&p, 3, &alone);
    check_share(twice, 2 * alone, 2e-3);
    tell(p.told, HAWSER_FRICTION, NULL, 1, 0.3);
    check_close(told_more(&p, 6), 0, 0.2);
    pair_close(&p);
}

/* A roller that stands drags with 0.4 what lies on it, as one of the case's jams. */
static void test_jam(void **state)
{
    (void)state;
    Pair p = pair_new();
    hawser_error err = {0};
    const hawser_roller *roller;
    assert_true(hawser_sim_rollers(p.told, &roller) > 8);
    assert_int_equal(hawser_sim_control(p.told, HAWSER_RELEASE, roller[8].name, 0, 0, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "not jammed");
    tell(p.told, HAWSER_JAM, roller[8].name, 0, 0.1);
    assert_int_equal(hawser_sim_control(p.told, HAWSER_JAM, roller[8].name, 0, 0, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "jammed already");
    const double more = told_more(&p, 3);
    check_share(more, (0.4 - 0.2) * hawser_sim_sample(p.told)->roller_load[8] / hypot(1, 0.4), 0.02);
    tell(p.told, HAWSER_RELEASE, roller[8].name, 0, 0.1);
    check_close(told_more(&p, 6), 0, 0.2);
    pair_close(&p);
}

/* A force back along the cable is that much more pull, wherever it acts. */
static void test_force(void **state)
{
    (void)state;
    Pair p = pair_new();
    hawser_error err = {0};
    const hawser_force back = {.force_N = {-100, 0, 0}, .arm_m = {0.1, 0, 0}};
    const hawser_force follows = {.force_N = {-50, 0, 0}, .follows = 1};
    assert_int_equal(hawser_sim_force(p.told, 20, &back, 0, &err), HAWSER_ERR_INPUT);
    assert_int_equal(hawser_sim_force(p.told, 5, &back, 0.2, &err), HAWSER_OK);
    assert_int_equal(last_event(p.told)->code, HAWSER_EVENT_FORCE);
    check_close(told_more(&p, 3), 100, 0.2);
    assert_int_equal(hawser_sim_force(p.told, 5, &follows, 0.2, &err), HAWSER_OK);
    check_close(told_more(&p, 5), 50, 0.2);
    assert_int_equal(hawser_sim_force(p.told, 5, NULL, 0.2, &err), HAWSER_OK);
    check_close(told_more(&p, 7), 0, 0.2);
    pair_close(&p);
}

/* A drag of c v on every segment, with and without its derivatives: the same motion, and n c v more pull (K10). */
static const double DRAG = 40; /* N s/m */
static int drag_law(void *user, const hawser_segment_now *at, double wrench[6], double by_place[36],
                    double by_motion[36])
{
    ++*(long *)user;
    for (int c = 0; c < 3; ++c) wrench[c] = -DRAG * at->velocity_m_per_s[c];
    for (int c = 0; by_place && c < 3; ++c) by_motion[7 * c] = -DRAG;
    return 0;
}

static void test_law(void **state)
{
    (void)state;
    double more[2];
    long calls[2] = {0, 0};
    for (int known = 0; known < 2; ++known) {
        Pair p = pair_new();
        hawser_error err = {0};
        assert_int_equal(hawser_sim_set_law(p.told, 0, 21, drag_law, known, calls, &err), HAWSER_ERR_INPUT);
        assert_int_equal(hawser_sim_set_law(p.told, 0, 20, drag_law, known, &calls[known], &err), HAWSER_OK);
        more[known] = told_more(&p, 3);
        check_close(more[known], 20 * DRAG * 0.1, 0.2);
        assert_int_equal(hawser_sim_set_law(p.told, 0, 0, NULL, 0, NULL, &err), HAWSER_OK);
        pair_close(&p);
    }
    check_close(more[0], more[1], 1e-3);
    check_above(calls[0], calls[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_winch_speed), cmocka_unit_test(test_winch_pause), cmocka_unit_test(test_friction),
        cmocka_unit_test(test_jam),         cmocka_unit_test(test_force),       cmocka_unit_test(test_law),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
