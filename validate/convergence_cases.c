/* How errors fall with the segments and with the integrator's accuracy: the slope of log error over log of what was
 * refined, by regression over four refinements or more. */
#include <math.h>

#include "validate/build.h"
#include "validate/motion.h"
#include "validate/validate.h"

/* The free end of a cantilever 1 m long, clamped at its head, under its own weight: how far it sinks, m. */
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

/* The same bent far: against the value to which the finest two tend. */
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

/* Where the tail's segment of a chain swinging from its head is after 1 s, m. */
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

/* A method of order p whose local errors are held to the tolerance has errors like its power p/(p + 1) (VA3). */
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

static const ValidationCase cases[] = {
    {"convergence-segments", "a cantilever's own weight, small deflections", "second order; w L^4/8 EI", 1, NULL,
     linear_run},
    {"convergence-bent", "the same, bent far", "second order", 1, NULL, bent_run},
    {"convergence-accuracy", "a swinging chain in time, order 2", "Hairer and Wanner: tol^(p/(p+1))", 0, &order_2,
     accuracy_run},
};
const ValidationGroup convergence_group = VALIDATION_GROUP(cases);
