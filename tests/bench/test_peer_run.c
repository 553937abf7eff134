/* bench/peers: the closed forms of the problems, and the means and errors that the programs' rows are made of. */

#include "bench/peers/run.h"
#include "tests/support/check.h"

/* A run as peer_start leaves it. */
static PeerRun a_run(PeerProblem problem)
{
    return (PeerRun){.program = "test", .problem = problem, .n = 12, .last_t = -1, .place_t = -1};
}

TEST(test_travel_is_the_integral_of_speed)
{
    double sum = 0;
    const int steps = 3000;
    for (int k = 0; k < steps; ++k) sum += straight_speed((k + 0.5) * 3 / steps) * 3 / steps;
    check_close(straight_travel(3), sum, 1e-8);
    check_close(straight_travel(3), 0.25, 1e-12); /* half the ramp's time at half the speed */
    check_close(straight_force(370), 7985.34, 1e-9);
}

/* Links are as long as they should be, the ends as far apart, and every link is in balance: about its centre the
 * vertical forces at its ends, which grow by its weight from link to link, turn it as much as the horizontal ones do.
 */
static void balanced(int n)
{
    double joint[3 * 121];
    const double tension = chain_tension(n), weight = PEER_MASS * PEER_GRAVITY;
    chain_joints(n, 0, joint);
    for (int i = 0; i < n; ++i) {
        const double *const a = joint + 3 * i, *const b = a + 3, dx = b[0] - a[0], dz = b[2] - a[2];
        check_close(hypot(dx, dz), PEER_LINK, 1e-12);
        const double rear = weight * (i - n / 2.),
                     front = weight * (i + 1 - n / 2.); /* half the weight on either side */
        check_close(dx * (rear + front) / 2, dz * tension, 1e-9 * tension);
    }
    check_close(joint[3 * n], chain_span(n), 1e-10);
    check_close(joint[3 * n + 2], 0, 1e-10);
}

TEST(test_chain_is_in_balance)
{
    balanced(2);
    balanced(37);
    balanced(120);
}

/* Many links are a catenary: horizontal tension w a, length 2 a sinh(span/2a). */
TEST(test_chain_tends_to_the_catenary)
{
    const int n = 4000;
    const double length = PEER_LINK * n, span = chain_span(n);
    double low = span / 10, high = 100 * span;
    for (int it = 0; it < 200; ++it) {
        const double a = (low + high) / 2;
        if (2 * a * sinh(span / (2 * a)) > length)
            low = a;
        else
            high = a;
    }
    check_share(chain_tension(n), PEER_MASS * PEER_GRAVITY / PEER_LINK * low, 1e-6);
}

TEST(test_turned_chain)
{
    double flat[3 * 13], turned[3 * 13];
    chain_joints(12, 0, flat);
    chain_joints(12, SWING_ANGLE, turned);
    for (int i = 0; i <= 12; ++i) {
        check_close(turned[3 * i], flat[3 * i], 1e-15);
        check_close(turned[3 * i + 1], -flat[3 * i + 2] * 0.5, 1e-12);
        check_close(turned[3 * i + 2], flat[3 * i + 2] * sqrt(0.75), 1e-12);
    }
}

/* A force that grows linearly, looked at on a grid that misses the window's ends: mean and mean square are exact. */
TEST(test_mean_over_the_window)
{
    PeerRun run = a_run(PEER_STRAIGHT);
    for (double t = 0; t < 9; t += 0.7) peer_force(&run, t, 10 * t);
    const double mean = run.sum / run.mean_time;
    check_close(run.mean_time, 5, 1e-12);
    check_close(mean, 45, 1e-10);
    check_close(run.square / run.mean_time - mean * mean, 2500. / 12, 1e-8);
}

/* The path is linear between calls, and its first point is the first call's. */
TEST(test_path)
{
    PeerRun run = a_run(PEER_SWING);
    for (int k = 0; k <= 70; ++k) peer_place(&run, 0.03 * k, 1 + 0.03 * k, -0.06 * k);
    assert_int_equal(run.points, TRACE_POINTS);
    for (int k = 0; k < TRACE_POINTS; ++k) {
        check_close(run.path[k][0] - 1, TRACE_EVERY * k, 1e-12);
        check_close(run.path[k][1], -2 * TRACE_EVERY * k, 1e-12);
    }
}

/* A path against itself, against one that is 1 mm aside at one point, and against one that is too short. */
TEST(test_path_error)
{
    char file[] = "test_peer_run_path.txt";
    PeerRun run = a_run(PEER_SWING);
    run.trace_file = run.reference_file = file;
    for (int k = 0; k <= 100; ++k) peer_place(&run, TRACE_EVERY * k, 3 * sin(TRACE_EVERY * k), 0);
    peer_trace_write(&run);
    double size;
    check_below(peer_trace_error(&run, &size), 1e-11);
    check_close(size, 3 * sin(1.58), 1e-11); /* the point next to a quarter turn */
    run.path[40][1] += 1e-3;
    check_close(peer_trace_error(&run, &size), 1e-3, 1e-11);
    run.points = 50;
    check_nan(peer_trace_error(&run, &size));
    remove(file);
}

TEST(test_settings)
{
    char program[] = "p", problem[] = "swing", n[] = "12", dt[] = "dt=2e-3", cone[] = "cone=elliptic",
         limit[] = "--limit", s[] = "7";
    char *argv[] = {program, problem, n, dt, limit, s, cone};
    PeerRun run;
    peer_start(&run, "test", 7, argv);
    assert_int_equal(run.problem, PEER_SWING);
    assert_int_equal(run.n, 12);
    check_equal(run.limit, 7);
    check_equal(run.until, SWING_END);
    check_equal(peer_number(&run, "dt", 1), 2e-3);
    check_equal(peer_number(&run, "d", 1), 1);
    assert_string_equal(peer_word(&run, "cone", "x"), "elliptic");
    assert_int_equal(run.used, 3);
}
