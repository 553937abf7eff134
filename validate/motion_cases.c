/* Chains that nothing holds, or that hang from one end: what their motion must conserve, and rotation without bending.
 */
#include <math.h>
#include <stdint.h>

#include "core/base/worst.h"
#include "core/chain.h"
#include "validate/build.h"
#include "validate/motion.h"
#include "validate/validate.h"

enum { SEGMENTS = 20 };
static const double LENGTH = 10; /* m */

/* Straight, free at both ends, undamped. */
static hawser_status chain_build(SceneDef *def, double ea, double ei, double accuracy, hawser_error *err)
{
    CableDef cable = build_cable(8, 0.06, ea, ei);
    cable.damping = 0;
    const hawser_status status = build_line(def, cable, LENGTH, SEGMENTS, err);
    if (status) return status;
    def->solver.accuracy = accuracy;
    def->duration = 10;
    return HAWSER_OK;
}

/* Repeatable numbers in -1 .. 1. */
static double random_next(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) / 4503599627370496.0 - 1;
}

/* Thrown into the air with random velocities: the centre of mass flies on its parabola, the angular momentum about it
 * stays, and so does the energy. */
static hawser_status flight_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    static const double TIME = 1;
    uint64_t seed = 5;
    SceneDef def;
    Stage stage;
    hawser_status status = chain_build(&def, 1e5, 100, 1e-6, err);
    if (!status) status = motion_start(&def, &stage, err);
    if (status) return status;
    for (int i = 0; i < SEGMENTS; ++i) {
        const double x = random_next(&seed), y = random_next(&seed), z = random_next(&seed);
        motion_set(&stage, STATE_V, i, v3(2 + 0.5 * x, 1 + 0.5 * y, 5 + 0.5 * z));
        motion_set(&stage, STATE_W, i, v3(0.5 * y, 0.5 * z, 0.5 * x));
    }
    const Balance a = motion_balance(&stage);
    status = motion_advance(&stage, TIME, err);
    const Balance b = motion_balance(&stage);
    const Vec3 g = stage.scene.weight.gravity;
    const Vec3 v = v3_scale(1 / a.mass, a.momentum);
    const Vec3 place = v3_add(v3_axpy(a.centre, TIME, v), v3_scale(TIME * TIME / 2, g));
    stage_free(&stage);
    if (status) return status;
    const Vec3 push = v3_sub(b.momentum, v3_axpy(a.momentum, TIME * a.mass, g));
    log_limit(log, "momentum off, of its size", "%", 100 * v3_norm(push) / v3_norm(a.momentum), 1e-6);
    log_limit(log, "centre of mass off its parabola", "m", v3_norm(v3_sub(b.centre, place)), 1e-4);
    log_limit(log, "angular momentum off, of its size", "%", 100 * v3_norm(v3_sub(b.spin, a.spin)) / v3_norm(a.spin),
              0.01);
    log_share(log, "energy", "J", a.kinetic + a.height, b.kinetic + b.height + b.elastic, 0.1);
    return HAWSER_OK;
}

/* A chain hung from its head and let go 60 degrees off the vertical. The energy is reckoned from the straight hanging
 * chain. */
static hawser_status pendulum_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    static const double SLOPE = M_PI / 6, TIME = 4;
    SceneDef def;
    Stage stage;
    hawser_status status = chain_build(&def, 1e6, 0.1, 1e-6, err);
    if (status) return status;
    def.route_slope = SLOPE;
    build_pull(&def, 0, 1, 0);
    status = motion_start(&def, &stage, err);
    if (status) return status;
    const Balance a = motion_balance(&stage);
    const double swing = a.mass * 9.81 * LENGTH / 2 * (1 - sin(SLOPE));
    double lowest = 0, drift = 0;
    for (int k = 1; k <= 40 && !status; ++k) {
        status = motion_advance(&stage, TIME * k / 40, err);
        const Balance b = motion_balance(&stage);
        drift = larger_of(drift, fabs(b.kinetic + b.height + b.elastic - a.height));
        lowest = smaller_of(lowest, b.height - a.height);
    }
    stage_free(&stage);
    if (status) return status;
    log_limit(log, "energy drift over the energy of the swing", "%", 100 * drift / swing, 0.1);
    log_share(log, "energy turned into motion", "J", swing, -lowest, 10);
    return HAWSER_OK;
}

/* Places (m) of the segments along a chain that turns by omega (rad/s) about its middle, each joint stretched by what
 * it carries: x_i = x_(i-1) + h + T_i/k, where T_i is omega^2 times the sum of m x outside. Each pass reckons the
 * tensions from the places of the one before; a few do, since the strain is small. */
static void spinning_places(const Chain *c, double omega, double *place)
{
    const double h = LENGTH / SEGMENTS;
    for (int i = 0; i < SEGMENTS; ++i) place[i] = (i + 0.5) * h - LENGTH / 2;
    for (int pass = 0; pass < 8; ++pass) {
        double carried = 0, at[SEGMENTS], middle = 0;
        for (int i = SEGMENTS - 1; i > 0; --i) at[i] = (carried += c->mass[i] * omega * omega * place[i]);
        place[0] = 0;
        for (int i = 1; i < SEGMENTS; ++i) place[i] = place[i - 1] + h + at[i] / c->stiffness[0][i];
        for (int i = 0; i < SEGMENTS; ++i) middle += place[i] / SEGMENTS;
        for (int i = 0; i < SEGMENTS; ++i) place[i] -= middle;
    }
}

/* Lays the chain along the unit vector `along` through the origin and sets it turning about `axis`, square to that. */
static void spinning_set(Stage *stage, const double *place, Vec3 along, Vec3 axis, double omega)
{
    const Vec3 across = v3_cross(axis, along);
    for (int i = 0; i < SEGMENTS; ++i) {
        motion_set(stage, STATE_P, i, v3_scale(place[i], along));
        motion_turn(stage, i, quat_from_axes(along, across, axis));
        motion_set(stage, STATE_W, i, v3_scale(omega, axis));
        motion_set(stage, STATE_V, i, v3_scale(omega * place[i], across));
    }
}

/* The largest twist or bend of any joint, rad. */
static double largest_bend(Stage *stage)
{
    double *const *const law = motion_law(stage);
    double bent = 0;
    for (int j = 1; j < SEGMENTS; ++j) {
        for (int k = 3; k < 6; ++k) bent = larger_of(bent, fabs(law[k][j] / stage->scene.chain.stiffness[k][j]));
    }
    return bent;
}

/* The straight chain turns about an axis through its middle that is in no plane of coordinates, three times around.
 * Its joints are stretched from the start by what they carry, in the middle m omega^2 L^2/8: nothing then vibrates,
 * nothing bends, and after three turns all lies where it was. */
static hawser_status rotation_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    static const double OMEGA = 2 * M_PI; /* rad/s: a turn a second */
    const Vec3 axis = v3_unit(v3(1, 2, 3)), along = v3_unit(v3_cross(axis, v3(0, 0, 1)));
    double place[SEGMENTS];
    SceneDef def;
    Stage stage;
    hawser_status status = chain_build(&def, 5e6, 1e3, 1e-7, err);
    if (status) return status;
    def.gravity = v3(0, 0, 0);
    status = motion_start(&def, &stage, err);
    if (status) return status;
    const double mass = stage.scene.chain.mass[0] / (LENGTH / SEGMENTS);
    spinning_places(&stage.scene.chain, OMEGA, place);
    spinning_set(&stage, place, along, axis, OMEGA);
    status = motion_advance(&stage, 3, err);
    const double bent = largest_bend(&stage), carried = motion_law(&stage)[0][SEGMENTS / 2];
    const Vec3 tip = motion_get(&stage, STATE_P, SEGMENTS - 1);
    stage_free(&stage);
    if (status) return status;
    log_share(log, "tension in the middle", "N", mass * OMEGA * OMEGA * LENGTH * LENGTH / 8, carried, 0.2);
    log_limit(log, "rotation in any joint", "rad", bent, 1e-6);
    log_limit(log, "tip off its place after three turns", "m",
              v3_norm(v3_sub(tip, v3_scale(place[SEGMENTS - 1], along))), 0.01);
    return HAWSER_OK;
}

static const ValidationCase cases[] = {
    {"free-flight", "momentum, angular momentum and energy of a chain thrown into the air", "Newton's laws", 1, NULL,
     flight_run},
    {"pendulum-chain", "energy of a swinging chain without damping", "energy is conserved", 1, NULL, pendulum_run},
    {"rotation", "a straight chain turns in space three times and does not bend",
     "m omega^2 L^2/8; bushings do not feel rigid rotations", 1, NULL, rotation_run},
};
const ValidationGroup motion_group = VALIDATION_GROUP(cases);
