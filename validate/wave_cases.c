/* Waves along a straight chain: their speed, and their reflection where the cable changes. A pulse that runs only
 * toward the head is set up, v = f(x - c t) with strain -v/c, and measured where it has come to. */
#include <math.h>

#include "validate/validate.h"

static const double SEGMENT = 0.25, SIGMA = 5; /* m: the pulse is f = exp(-(x - x0)^2 / 2 sigma^2) */

/* Kinds of pulse: displacement along the chain, or rotation about its axis. */
typedef enum WaveKind { AXIAL_WAVE, TORSION_WAVE } WaveKind;

/* A chain of one or two cables, free at both ends, without weight and damping. */
static hawser_status chain_start(CableDef first, double length, CableDef second, double rest, Stage *stage,
                                 hawser_error *err)
{
    SceneDef def;
    const hawser_status status = build_start(&def, err);
    if (status) return status;
    build_chain(&def, first, length, (int)lround(length / SEGMENT));
    if (rest > 0) {
        def.n_cables = def.n_pieces = 2;
        def.cables[1] = second;
        def.pieces[1] = (ChainPieceDef){.cable = 1, .length = rest, .segments = (int)lround(rest / SEGMENT)};
    }
    for (int c = 0; c < def.n_cables; ++c) def.cables[c].damping = 0;
    build_straight(&def, length + rest);
    def.head_at = length; /* of the eye, if there is one */
    def.gravity = v3(0, 0, 0);
    /* 1e-6 of a pulse of 1 m/s or rad/s */
    def.solver.atol_velocity = def.solver.atol_omega = 1e-6;
    def.solver.atol_position = def.solver.atol_rotation = 1e-8;
    def.solver.accuracy = 1e-6;
    def.duration = 1;
    return motion_start(&def, stage, err);
}

/* Displacement by the pulse's speeds: -integral of f / c from the far side, as position or rotation about the axis. */
static double pulse_shift(double x, double c) { return SIGMA * sqrt(M_PI / 2) / c * (1 - erf(x / (SIGMA * M_SQRT2))); }

/* Adds the pulse around x0 (m from the start) to the segments before `to`. */
static void pulse_set(Stage *stage, WaveKind kind, double x0, double c, double to)
{
    for (int i = 0; i < stage->scene.chain.n; ++i) {
        const Vec3 p = motion_get(stage, STATE_P, i);
        const double x = p.x - x0, f = p.x < to ? exp(-x * x / (2 * SIGMA * SIGMA)) : 0, shift = pulse_shift(x, c);
        if (kind == AXIAL_WAVE) {
            motion_set(stage, STATE_V, i, v3(f, 0, 0));
            motion_set(stage, STATE_P, i, v3(p.x + shift, 0, 0));
        } else {
            motion_set(stage, STATE_W, i, v3(f, 0, 0));
            motion_turn(stage, i, quat_exp(v3(shift, 0, 0)));
        }
    }
}

static double speed_of(const Stage *stage, WaveKind kind, int i)
{
    return motion_get(stage, kind == AXIAL_WAVE ? STATE_V : STATE_W, i).x;
}

/* Place of the pulse: the mean place of its kinetic energy, m. */
static double pulse_place(const Stage *stage, WaveKind kind)
{
    double sum = 0, moment = 0;
    for (int i = 0; i < stage->scene.chain.n; ++i) {
        const double v = speed_of(stage, kind, i);
        sum += v * v;
        moment += v * v * (i + 0.5) * SEGMENT;
    }
    return moment / sum;
}

static const WaveKind axial = AXIAL_WAVE, torsion = TORSION_WAVE;

/* c = sqrt(EA/m); of torsion sqrt(GJ / J rho), with J rho = m d^2/8 of a solid bar. */
static hawser_status speed_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    static const double LENGTH = 100, FROM = 30, WAY = 40;
    const WaveKind kind = *(const WaveKind *)setup;
    CableDef cable = build_cable(20, 0.08, 5e7, 12e3);
    const double c = kind == AXIAL_WAVE ? sqrt(cable.ea / cable.mass)
                                        : sqrt(cable.gj * 8 / (cable.mass * cable.diameter * cable.diameter));
    Stage stage;
    hawser_status status = chain_start(cable, LENGTH, cable, 0, &stage, err);
    if (status) return status;
    pulse_set(&stage, kind, FROM, c, INFINITY);
    const double start = pulse_place(&stage, kind);
    status = motion_advance(&stage, WAY / c, err);
    if (!status) log_share(log, "wave speed", "m/s", c, (pulse_place(&stage, kind) - start) * c / WAY, 0.2);
    stage_free(&stage);
    return status;
}

/* Momentum per mass on one side, m2/s: the integral of v. */
static double pulse_area(const Stage *stage, int from, int to)
{
    double area = 0;
    for (int i = from; i < to; ++i) area += SEGMENT * speed_of(stage, AXIAL_WAVE, i);
    return area;
}

/* From a cable of impedance Z1 = sqrt(EA m) into a rope of Z2: velocities (Z1 - Z2)/(Z1 + Z2) are reflected and 2
 * Z1/(Z1 + Z2) transmitted, longer by the ratio of the wave speeds. */
static hawser_status jump_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    static const double CABLE = 80, ROPE = 160, FROM = 50;
    const CableDef cable = build_cable(20, 0.08, 5e7, 12e3), rope = build_cable(1, 0.02, 1.5e7, 30);
    const double z1 = sqrt(cable.ea * cable.mass), z2 = sqrt(rope.ea * rope.mass);
    const double c1 = sqrt(cable.ea / cable.mass), c2 = sqrt(rope.ea / rope.mass);
    Stage stage;
    hawser_status status = chain_start(cable, CABLE, rope, ROPE, &stage, err);
    if (status) return status;
    const int jump = (int)lround(CABLE / SEGMENT), n = stage.scene.chain.n;
    pulse_set(&stage, AXIAL_WAVE, FROM, c1, CABLE);
    const double sent = pulse_area(&stage, 0, n);
    status = motion_advance(&stage, 2 * (CABLE - FROM) / c1, err);
    if (!status) {
        log_share(log, "reflected over sent", "1", (z1 - z2) / (z1 + z2), pulse_area(&stage, 0, jump) / sent, 0.5);
        log_share(log, "transmitted over sent", "1", 2 * z1 / (z1 + z2), pulse_area(&stage, jump, n) / sent * c1 / c2,
                  0.5);
    }
    stage_free(&stage);
    return status;
}

static const ValidationCase wave_cases[] = {
    {"wave-axial", "speed of a tension wave", "sqrt(EA/m)", 1, &axial, speed_run},
    {"wave-torsion", "speed of a wave of twist", "sqrt(GJ/(J rho))", 1, &torsion, speed_run},
    {"wave-impedance-jump", "cable meets rope: what is reflected and what goes on",
     "d'Alembert: (Z1 - Z2)/(Z1 + Z2), 2 Z1/(Z1 + Z2)", 1, NULL, jump_run},
};

const ValidationGroup wave_group = VALIDATION_GROUP(wave_cases);

/* Fall of errors with the segments and with the integrator's accuracy: the slope of log error over log of the refined
 * quantity, by regression over four refinements or more. */

/* Sinking, m, of the free end of a cantilever 1 m long, clamped at its head, under its own weight. */
static hawser_status cantilever_sinks(int n, double mass, double EI, double GA, double *out, hawser_error *err)
{
    SceneDef def;
    Sim *sim;
    CableDef cable = build_cable(mass, 0.02, 1e6, EI);
    cable.ga = GA;
    hawser_status status = build_line(&def, cable, 1, n, err);
    if (status) return status;
    build_pull(&def, 0, 1, 0);
    def.solver.relax_tolerance = 1e-12;
    status = pull_start(&def, &sim, err);
    if (status) return status;
    const hawser_sample *const look = hawser_sim_sample(sim);
    const double *const q = look->quaternion;
    const Vec3 axis = quat_rotate((Quat){q[0], q[1], q[2], q[3]}, v3(1, 0, 0));
    *out = -(look->position[2] - axis.z / (2 * n));
    sim_free(sim);
    return HAWSER_OK;
}

/* w L^4/8 EI + w L^2/2 GA for small deflections. */
static hawser_status linear_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    enum { COUNT = 5 };
    static const double MASS = 0.001, EI = 1, GA = 1e6, G = 9.81;
    const double exact = MASS * G * (1 / (8 * EI) + 1 / (2 * GA));
    double h[COUNT], error[COUNT];
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < COUNT && !status; ++k) {
        double sinks = NAN;
        const int n = 4 << k;
        status = cantilever_sinks(n, MASS, EI, GA, &sinks, err);
        h[k] = 1.0 / n;
        error[k] = sinks / exact - 1;
    }
    if (!status) order_log(log, COUNT, h, error, "segment length", 2, 0.1);
    return status;
}

/* The same with large deflection: relative to the limit of the finest two. */
static hawser_status bent_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    (void)setup;
    enum { COUNT = 4 };
    double h[COUNT], error[COUNT], sinks[COUNT + 2];
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < COUNT + 2 && !status; ++k) status = cantilever_sinks(4 << k, 0.5, 1, 1e6, &sinks[k], err);
    if (status) return status;
    const double limit = sinks[COUNT + 1] + (sinks[COUNT + 1] - sinks[COUNT]) / 3;
    for (int k = 0; k < COUNT; ++k) {
        h[k] = 1.0 / (4 << k);
        error[k] = sinks[k] / limit - 1;
    }
    order_log(log, COUNT, h, error, "segment length", 2, 0.1);
    return HAWSER_OK;
}

/* Place of the tail's segment of a chain swinging from its head after 1 s, m. */
static hawser_status swing_end(double accuracy, int max_order, Vec3 *out, hawser_error *err)
{
    SceneDef def;
    Stage stage;
    hawser_status status = build_line(&def, build_cable(8, 0.06, 1e6, 20), 5, 10, err);
    if (status) return status;
    def.route_slope = 0.5;
    build_pull(&def, 0, 1, 0);
    def.solver.accuracy = accuracy;
    def.solver.max_order = max_order;
    def.duration = 2;
    status = motion_start(&def, &stage, err);
    if (status) return status;
    status = motion_advance(&stage, 1, err);
    *out = motion_get(&stage, STATE_P, 0);
    stage_free(&stage);
    return status;
}

/* A method of order p whose local errors are kept at the tolerance has errors proportional to its power p/(p + 1)
 * (VA3). */
static hawser_status accuracy_run(const void *setup, ValidationLog *log, hawser_error *err)
{
    enum { COUNT = 5 };
    const int max_order = *(const int *)setup;
    double accuracy[COUNT], error[COUNT];
    Vec3 exact = {0};
    hawser_status status = swing_end(1e-10, 5, &exact, err);
    for (int k = 0; k < COUNT && !status; ++k) {
        Vec3 end = {0};
        accuracy[k] = pow(10, -3 - k);
        status = swing_end(accuracy[k], max_order, &end, err);
        error[k] = v3_norm(v3_sub(end, exact)) / 5;
    }
    if (!status) order_log(log, COUNT, accuracy, error, "accuracy", max_order / (max_order + 1.0), 0.15);
    return status;
}

static const int order_2 = 2;

static const ValidationCase convergence_cases[] = {
    {"convergence-segments", "a cantilever's own weight, small deflections", "second order; w L^4/8 EI", 1, NULL,
     linear_run},
    {"convergence-bent", "the same, bent far", "second order", 1, NULL, bent_run},
    {"convergence-accuracy", "a swinging chain in time, order 2", "Hairer and Wanner: tol^(p/(p+1))", 0, &order_2,
     accuracy_run},
};

const ValidationGroup convergence_group = VALIDATION_GROUP(convergence_cases);
