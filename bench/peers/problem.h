/* The problems on which hawser and other programs are compared, in numbers and closed forms: those of
 * cases/straight.yaml and a hanging chain. SI. For C and C++. bench/results/xeon-2core/peers.md describes them.
 *
 * straight  A cable of n rigid segments along x, tail at x = 2.5 m, on rollers across it every 2 m; a winch takes its
 * head to 0.1 m/s within 1 s. Judged by the winch force, mean over WINDOW: exactly mu m g n. hang      A chain of n
 * rigid links hinged at their ends, hung from two points, as much apart as leaves 2 % slack. It begins where it is at
 * rest and should stay: mean horizontal tension over the run, closed form below. swing     The same, begun with its
 * plane turned by SWING_ANGLE about the line through its ends, and let go. Judged by the path of its middle over
 * SWING_END, against hawser's with tight tolerances. */
#ifndef HAWSER_BENCH_PEERS_PROBLEM_H
#define HAWSER_BENCH_PEERS_PROBLEM_H

#include <math.h>
#include <string.h>

/* The cable: table 1 of the paper, as cases/straight.yaml has it. */
static const double PEER_GRAVITY = 9.81;             /* m/s2, along -z */
static const double PEER_LINK = 0.5;                 /* m, a segment */
static const double PEER_MASS = 11;                  /* kg, a segment */
static const double PEER_DIAMETER = 87.3e-3;         /* m */
static const double PEER_E = 115e9, PEER_G = 41.5e9; /* Pa */
static const double PEER_AREA = 5982.7e-6;           /* m2 */
static const double PEER_PI = 3.14159265358979323846;

/* Rollers, friction, contact. */
static const double ROLLER_RADIUS = 0.1, ROLLER_SPACING = 2, ROLLER_WIDTH = 0.4; /* m */
static const double PEER_MU = 0.2;
static const double PEER_SLIP_SPEED = 1e-3; /* m/s, below which a friction law may be smoothed */
static const double CONTACT_K = 3.4e8, CONTACT_EXPONENT = 1.5, CONTACT_C = 1e4; /* N/m^1.5, N s/m: hawser's law */

/* The pull. The window is one period: a segment's length at full speed, after which every joint is where the next was.
 */
static const double STRAIGHT_TAIL = 2.5;                     /* m */
static const double STRAIGHT_SPEED = 0.1, STRAIGHT_RAMP = 1; /* m/s, s */
static const double WINDOW_FROM = 2, WINDOW_TO = 7;          /* s */

/* The chain. */
static const double CHAIN_SLACK = 1.02;               /* length of the chain over the distance of its ends */
static const double SWING_ANGLE = 0.5235987755982988; /* rad: 30 degrees */
static const double HANG_END = 1, SWING_END = 2;      /* s */
static const double TRACE_EVERY = 0.02;               /* s between points of the path */
enum { TRACE_POINTS = 101 };

typedef enum PeerProblem { PEER_STRAIGHT, PEER_HANG, PEER_SWING } PeerProblem;

/* -1: there is no such problem. */
static inline int peer_problem(const char *name)
{
    if (strcmp(name, "straight") == 0) return PEER_STRAIGHT;
    if (strcmp(name, "hang") == 0) return PEER_HANG;
    return strcmp(name, "swing") == 0 ? PEER_SWING : -1;
}

static inline double peer_end(PeerProblem problem)
{
    return problem == PEER_STRAIGHT ? WINDOW_TO : problem == PEER_HANG ? HANG_END : SWING_END;
}

/* Second moment of the section's area, m4, and a segment's moments of inertia across and along its axis, kg m2. */
static inline double peer_second_moment(void) { return PEER_PI * pow(PEER_DIAMETER, 4) / 64; }
static inline double peer_inertia_across(void)
{
    return PEER_MASS * (PEER_LINK * PEER_LINK / 12 + PEER_DIAMETER * PEER_DIAMETER / 16);
}
static inline double peer_inertia_along(void) { return PEER_MASS * PEER_DIAMETER * PEER_DIAMETER / 8; }

/* The winch: STEP from 0 to the speed, and its integral: D = t/ramp, v D^2 (3 - 2 D) and v ramp (D^3 - D^4/2). */
static inline double straight_speed(double t)
{
    const double d = t < STRAIGHT_RAMP ? t / STRAIGHT_RAMP : 1;
    return STRAIGHT_SPEED * d * d * (3 - 2 * d);
}
static inline double straight_travel(double t)
{
    const double d = t < STRAIGHT_RAMP ? t / STRAIGHT_RAMP : 1;
    return STRAIGHT_SPEED * (STRAIGHT_RAMP * d * d * d * (1 - d / 2) + (t > STRAIGHT_RAMP ? t - STRAIGHT_RAMP : 0));
}
static inline double straight_force(int n) { return PEER_MU * PEER_MASS * PEER_GRAVITY * n; }

/* Rollers stand from x = 0 to 6.5 m ahead of the head; roller k's centre is at (x, 0, straight_roller_z()), its axis
 * along y. The cable's axis is z = 0: its lower side touches them all. */
static inline int straight_rollers(int n) { return (int)floor((PEER_LINK * n + 9) / ROLLER_SPACING + 1e-9) + 1; }
static inline double straight_roller_x(int k) { return ROLLER_SPACING * k; }
static inline double straight_roller_z(void) { return -ROLLER_RADIUS - PEER_DIAMETER / 2; }
/* Joint i of 0 .. n at t = 0. */
static inline double straight_joint_x(int i) { return STRAIGHT_TAIL + PEER_LINK * i; }

static inline double chain_span(int n) { return PEER_LINK * n / CHAIN_SLACK; }

/* A rigid link of mass m at rest between vertical forces V - m g/2 and V + m g/2 and the horizontal one H lies
 * along the mean of its end forces: tan(slope_i) = (i - (n - 1)/2) m g/H, i = 0 .. n-1. Sum of h cos(slope_i) = span
 * gives m g/H, by bisection. Returns H, N. */
static inline double chain_tension(int n)
{
    const double span = chain_span(n), middle = (n - 1) / 2.;
    double low = 0, high = 100;
    for (int it = 0; it < 200; ++it) {
        const double a = (low + high) / 2;
        double sum = 0;
        for (int i = 0; i < n; ++i) sum += PEER_LINK / sqrt(1 + (i - middle) * (i - middle) * a * a);
        if (sum > span)
            low = a;
        else
            high = a;
    }
    return 2 * PEER_MASS * PEER_GRAVITY / (low + high);
}

/* The joints at rest, 3 (n + 1) numbers, from the origin along x, turned by `angle` (rad) about the line through the
 * ends; toward +y. */
static inline void chain_joints(int n, double angle, double *joint)
{
    const double a = PEER_MASS * PEER_GRAVITY / chain_tension(n), middle = (n - 1) / 2.;
    double x = 0, down = 0;
    for (int i = 0; i <= n; ++i) {
        joint[3 * i] = x;
        joint[3 * i + 1] = down * sin(angle);
        joint[3 * i + 2] = -down * cos(angle);
        const double slope = (i - middle) * a, along = PEER_LINK / sqrt(1 + slope * slope);
        x += along;
        down -= slope * along;
    }
}

static inline double chain_angle(PeerProblem problem) { return problem == PEER_SWING ? SWING_ANGLE : 0; }

/* The middle of the chain is a joint (n even: the segment behind it, at its front end) or a segment's centre (n odd).
 */
static inline int chain_middle_segment(int n) { return (n - 1) / 2; }
static inline double chain_middle_arm(int n)
{
    return n % 2 ? 0 : PEER_LINK / 2;
} /* m ahead of that segment's centre */

#endif
