#include "validate/motion.h"

#include <string.h>

#include "core/bushing.h"

/* The planar equations have another state: they are switched off. */
hawser_status motion_start(SceneDef *def, Stage *stage, hawser_error *err)
{
    memset(stage, 0, sizeof *stage);
    def->solver.planar = PLANAR_OFF;
    const hawser_status status = stage_new(stage, def, NULL, err);
    scene_def_clear(def);
    if (status) stage_free(stage);
    return status;
}

hawser_status motion_advance(Stage *stage, double t, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    while (!status && stage->t < t) status = stage_step(stage, t, err);
    return status;
}

Vec3 motion_get(const Stage *stage, int at, int i)
{
    const int n = stage->scene.chain.n;
    const double *const y = stage->y + at * n + i;
    return v3(y[0], y[n], y[2 * n]);
}

void motion_set(Stage *stage, int at, int i, Vec3 value)
{
    const int n = stage->scene.chain.n;
    double *const y = stage->y + at * n + i;
    y[0] = value.x;
    y[n] = value.y;
    y[2 * n] = value.z;
}

Quat motion_attitude(const Stage *stage, int i)
{
    const int n = stage->scene.chain.n;
    const double *const q = stage->y + STATE_Q * n + i;
    return (Quat){q[0], q[n], q[2 * n], q[3 * n]};
}

void motion_turn(Stage *stage, int i, Quat attitude)
{
    const int n = stage->scene.chain.n;
    double *const q = stage->y + STATE_Q * n + i;
    q[0] = attitude.w;
    q[n] = attitude.x;
    q[2 * n] = attitude.y;
    q[3 * n] = attitude.z;
}

/* Joints n and 0 too: the ground's ends are set with the kinematics. */
double *const *motion_law(Stage *stage)
{
    dynamics_kinematics(&stage->scene, &stage->ws, stage->t, stage->y);
    bushing_kernels()->law(&stage->scene.chain, &stage->ws.kin, 0, stage->scene.chain.n + 1, stage->ws.law);
    return stage->ws.law;
}

/* Springs hold law^2 / 2k each; a joint without stiffness holds nothing. */
static double elastic_energy(Stage *stage)
{
    const Chain *const c = &stage->scene.chain;
    double *const *const law = motion_law(stage);
    double energy = 0;
    for (int j = 0; j <= c->n; ++j) {
        for (int k = 0; k < 6; ++k) {
            if (c->stiffness[k][j] > 0) energy += law[k][j] * law[k][j] / (2 * c->stiffness[k][j]);
        }
    }
    return energy;
}

/* Two passes: the spin is about the centre of mass, which the first one finds. */
Balance motion_balance(Stage *stage)
{
    const Chain *const c = &stage->scene.chain;
    Balance b = {.elastic = elastic_energy(stage)};
    for (int i = 0; i < c->n; ++i) {
        b.mass += c->mass[i];
        b.centre = v3_axpy(b.centre, c->mass[i], motion_get(stage, STATE_P, i));
        b.momentum = v3_axpy(b.momentum, c->mass[i], motion_get(stage, STATE_V, i));
    }
    b.height = -v3_dot(stage->scene.weight.gravity, b.centre);
    b.centre = v3_scale(1 / b.mass, b.centre);
    for (int i = 0; i < c->n; ++i) {
        const Vec3 v = motion_get(stage, STATE_V, i), w = motion_get(stage, STATE_W, i);
        const Vec3 own = body_inertia_times(c, &stage->ws.kin, i, w), push = v3_scale(c->mass[i], v);
        const Vec3 arm = v3_sub(motion_get(stage, STATE_P, i), b.centre);
        b.kinetic += (v3_dot(v, push) + v3_dot(w, own)) / 2;
        b.spin = v3_add(b.spin, v3_add(own, v3_cross(arm, push)));
    }
    return b;
}
