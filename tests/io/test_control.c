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
TEST(test_winch_speed)
{
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
TEST(test_winch_pause)
{
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
TEST(test_friction)
{
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
TEST(test_jam)
{
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
TEST(test_force)
{
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

TEST(test_law)
{
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

/* A winch of set tension: what it is set to, a pause in which the rope goes slack, a brake that holds what is
 * stretched, and back (K3). Against friction of 392 N. */
TEST(test_tension)
{
    hawser_case *c = NULL;
    hawser_error err = {0};
    hawser_sim *s = NULL;
    assert_int_equal(hawser_case_parse(data_text("short-pull"), "control", &c, &err), HAWSER_OK);
    assert_int_equal(
        hawser_case_set(c, "drive.winch", "{tension: {force: 500 N, to: 500 ms, speed_limit: 0.1 m/s}}", &err),
        HAWSER_OK);
    assert_int_equal(hawser_case_set(c, "run.steady_from", "1 s", &err), HAWSER_OK);
    if (hawser_sim_new(c, NULL, &s, &err) || hawser_sim_relax(s, NULL, &err)) fail_msg("%s", err.message);
    hawser_case_free(c);
    advance(s, 3);
    assert_int_equal(hawser_sim_control(s, HAWSER_WINCH_SPEED, NULL, 0.1, 0, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "set tension");
    check_between(hawser_sim_sample(s)->winch_speed, 0.05, 0.1);
    tell(s, HAWSER_WINCH_TENSION, NULL, 300, 0.5); /* less than friction: it comes to rest, and holds */
    advance(s, 4);
    check_close(hawser_sim_sample(s)->winch_force, 300, 1e-9);
    check_close(hawser_sim_sample(s)->winch_speed, 0, 2e-3);
    tell(s, HAWSER_WINCH_TENSION, NULL, 500, 0.5);
    advance(s, 6);
    check_between(hawser_sim_sample(s)->winch_speed, 0.05, 0.1);
    tell(s, HAWSER_WINCH_BRAKE, NULL, 0, 0.3);
    advance(s, 6.3);
    assert_int_equal(last_event(s)->code, HAWSER_EVENT_WINCH_STOPPED);
    const double held = hawser_sim_sample(s)->winch_travel;
    advance(s, 9);
    check_close(hawser_sim_sample(s)->winch_travel, held, 1e-4);
    tell(s, HAWSER_WINCH_RESTART, NULL, 0, 0.5);
    advance(s, 11);
    check_between(hawser_sim_sample(s)->winch_speed, 0.05, 0.1);
    tell(s, HAWSER_WINCH_PAUSE, NULL, 0, 0.5);
    advance(s, 12);
    check_close(hawser_sim_sample(s)->winch_force, 0, 1e-9);
    tell(s, HAWSER_WINCH_RESTART, NULL, 0, 0.5);
    advance(s, 14);
    check_between(hawser_sim_sample(s)->winch_speed, 0.05, 0.1);
    hawser_summary sum;
    hawser_sim_summary(s, &sum);
    check_below(sum.balance->residual_share, 2e-3);
    hawser_sim_free(s);
}

/* A belt that slips pushes with 2 mu times its clamp: the winch has that much less to do (K4). */
TEST(test_conveyor)
{
    hawser_case *c = NULL;
    hawser_error err = {0};
    hawser_sim *s = NULL;
    const hawser_machine *machine;
    assert_int_equal(hawser_case_parse(data_text("short-pull"), "control", &c, &err), HAWSER_OK);
    assert_int_equal(hawser_case_set(c, "conveyors",
                                     "[{name: pusher, from: 4 m, to: 6 m, clamp: 200 N, mu: 0.25, hold: false, belt: "
                                     "{speed: 0.15 m/s}}]",
                                     &err),
                     HAWSER_OK);
    if (hawser_sim_new(c, NULL, &s, &err) || hawser_sim_relax(s, NULL, &err)) fail_msg("%s", err.message);
    hawser_case_free(c);
    advance(s, 2);
    assert_int_equal(hawser_sim_control(s, HAWSER_CONVEYOR_CLAMP, "pushes", 100, 0, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "'pushes'");
    const double first = hawser_sim_sample(s)->machine[0].now[0].value;
    check_share(first, 100, 1e-5);
    tell(s, HAWSER_CONVEYOR_CLAMP, "pusher", 600, 0.3);
    advance(s, 2.5);
    check_share(hawser_sim_sample(s)->machine[0].now[0].value, 300, 1e-5);
    tell(s, HAWSER_CONVEYOR_SPEED, "pusher", 0.05, 0.3); /* slower than the winch: it brakes */
    advance(s, 3);
    hawser_sim_sample(s);
    assert_int_equal(hawser_sim_machines(s, &machine), 1);
    check_share(machine[0].now[0].value, -300, 1e-5);
    check_close(machine[0].now[1].value, 0.05, 2e-3);
    tell(s, HAWSER_JAM, "pusher", 0, 0.2);
    advance(s, 3.5);
    check_close(hawser_sim_sample(s)->machine[0].now[1].value, 0.1, 2e-3);
    hawser_sim_free(s);
}

/* The brake's torque over the drum's radius is tension at the tail (K5). */
TEST(test_reel)
{
    hawser_case *c = NULL;
    hawser_error err = {0};
    hawser_sim *s = NULL;
    assert_int_equal(hawser_case_parse(data_text("reel-payout"), "control", &c, &err), HAWSER_OK);
    assert_int_equal(hawser_case_set(c, "reel.brake", "{law: constant, torque: 500 N m}", &err), HAWSER_OK);
    assert_int_equal(hawser_case_set(c, "rollers", "{along: {spacing: 1 m}}", &err), HAWSER_OK);
    assert_int_equal(hawser_case_set(c, "run.duration", "20 s", &err), HAWSER_OK);
    if (hawser_sim_new(c, NULL, &s, &err) || hawser_sim_relax(s, NULL, &err)) fail_msg("%s", err.message);
    hawser_case_free(c);
    double tail[2] = {0, 0}, turned = 0;
    advance(s, 3);
    for (int k = 0; k < 800; ++k) { /* two seconds, then it is told, two to settle, two more */
        advance(s, 3 + 0.01 * (k < 200 ? k : k + 200));
        if (k == 199) tell(s, HAWSER_REEL_BRAKE, NULL, 1500, 0.5);
        const hawser_sample *const look = hawser_sim_sample(s);
        if (k < 200) tail[0] += look->tail_tension / 200;
        if (k >= 400) tail[1] += look->tail_tension / 400;
        if (k >= 400) turned += look->reel_speed / 400;
    }
    check_share(tail[1] - tail[0], 1000 * turned / 0.1, 0.03);
    hawser_sim_free(s);
}

/* The same commands from the case's script, to the last bit, and met exactly. */
TEST(test_script)
{
    static const char script[] = "[{at: 0 s, do: winch_speed, speed: 0.12 m/s, ramp: 500 ms},"
                                 " {at: 1.25 s, do: friction, factor: 1.5, ramp: 300 ms},"
                                 " {at: 1.25 s, do: force, place: 3 m, force: [-50 N, 0 N, 0 N]},"
                                 " {at: 1.6 s, do: winch_pause, ramp: 200 ms}]";
    hawser_case *c = NULL;
    hawser_error err = {0};
    hawser_sim *s = NULL;
    assert_int_equal(hawser_case_parse(data_text("short-pull"), "control", &c, &err), HAWSER_OK);
    assert_int_equal(hawser_case_set(c, "drive.script", script, &err), HAWSER_OK);
    if (hawser_sim_new(c, NULL, &s, &err) || hawser_sim_relax(s, NULL, &err)) fail_msg("%s", err.message);
    hawser_case_free(c);
    hawser_sim *const told = sim_of(data_text("short-pull"));
    const hawser_force force = {.force_N = {-50, 0, 0}};
    tell(told, HAWSER_WINCH_SPEED, NULL, 0.12, 0.5);
    advance(told, 1.25);
    advance(s, 1.25);
    tell(told, HAWSER_FRICTION, NULL, 1.5, 0.3);
    assert_int_equal(hawser_sim_force(told, 6, &force, 0.2, &err), HAWSER_OK);
    advance(told, 1.6);
    advance(s, 1.6);
    tell(told, HAWSER_WINCH_PAUSE, NULL, 0, 0.2);
    advance(told, 2);
    advance(s, 2);
    check_equal(hawser_sim_sample(s)->winch_force, hawser_sim_sample(told)->winch_force);
    const hawser_event *one, *other;
    const int n = hawser_sim_events(s, &one);
    assert_int_equal(n, hawser_sim_events(told, &other));
    for (int i = 0; i < n; ++i) {
        check_equal(one[i].t, other[i].t);
        assert_int_equal(one[i].code, other[i].code);
        assert_string_equal(one[i].what, other[i].what);
    }
    hawser_sim_free(told);
    hawser_sim_free(s);
}

/* What a script says of things that are not there is found before anything runs. */
TEST(test_script_errors)
{
    static const char *const wrong[][2] = {
        {"[{at: 1 s, do: winch_tension, tension: 1 kN}]", "set speed"},
        {"[{at: 1 s, do: winch_speed}]", "needs it"},
        {"[{at: 1 s, do: winch_brake, speed: 1 m/s}]", "not allowed beside"},
        {"[{at: 1 s, do: conveyor_clamp, of: x, clamp: 1 kN}]", "no such conveyor"},
        {"[{at: 1 s, do: jam}]", "needs the name"},
        {"[{at: 1 s, do: jam, of: nobody}]", "no such"},
        {"[{at: 1 s, do: reel_brake, torque: 1 N m}]", "no such reel"},
        {"[{at: 1 s, do: force, place: 30 m, force: [1 N, 0 N, 0 N]}]", "beyond the chain"},
        {"[{at: 2 s, do: winch_pause}, {at: 1 s, do: winch_restart}]", "must not be before"},
    };
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; ++k) {
        hawser_case *c = NULL;
        hawser_error err = {0};
        assert_int_equal(hawser_case_parse(data_text("short-pull"), "control", &c, &err), HAWSER_OK);
        assert_int_equal(hawser_case_set(c, "drive.script", wrong[k][0], &err), HAWSER_OK);
        assert_int_equal(hawser_case_check(c, &err), HAWSER_ERR_INPUT);
        check_has(err.message, wrong[k][1]);
        hawser_case_free(c);
    }
}
