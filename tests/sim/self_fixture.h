/* Scenes in which the cable touches itself, made in code: a helix of a few turns, and two strands across each other
 * whose link is cut. */
#ifndef HAWSER_TESTS_SIM_SELF_FIXTURE_H
#define HAWSER_TESTS_SIM_SELF_FIXTURE_H

#include "sim/dynamics.h"
#include "sim/newton/newton.h"
#include "sim/newton/newton_extra.h"
#include "sim/step/spatial.h"
#include "tests/sim/scene_fixture.h"

static const double SELF_DIAMETER = 0.08; /* m */

typedef struct SelfRig {
    Scene scene;
    Workspace ws;
    Newton newton;
    Spatial spatial;
    double *y, *rate;
    int n, size;
} SelfRig;

/* n segments of h, free at both ends, with gravity g (m/s2, downward); soft: laws for finite differences. `more` (NULL:
 * nothing) has the last word on the definition. */
static inline void self_rig_new(SelfRig *r, int n, double h, double g, int soft, Team *team, LinKind kind,
                                void (*more)(SceneDef *))
{
    SceneDef def;
    hawser_error err = {0};
    memset(r, 0, sizeof *r);
    fixture_free_chain(&def, n);
    def.pieces[0].length = def.head_at = h * n;
    def.route[0].length = h * n + 1;
    def.gravity = v3(0, 0, -g);
    def.cables[0] = fixture_cable(soft ? 1e-3 : 0.05, 8, SELF_DIAMETER);
    if (soft) fixture_soften(&def);
    if (!soft) def.impact = (ImpactLaw){.k = 1e7, .e = 1.5, .c = 1e3, .d = 1e-3};
    def.cable_on_cable = 1;
    def.cable_friction = (FrictionLaw){.mu_s = 0.3, .mu_d = 0.2, .v_s = 5e-3, .v_d = 2e-2};
    def.solver.max_step = 0.01;
    if (more) more(&def);
    fixture_build(&def, &r->scene);
    r->n = n;
    r->size = STATE_SIZE * n;
    assert_true(workspace_alloc(&r->ws, &r->scene, team));
    const LinOptions options = {.kind = kind, .threads = 1};
    if (newton_new(&r->newton, &r->scene, &options, &err)) fail_msg("%s", err.message);
    if (newton_extra_attach(&r->newton, &r->ws.self.extras, &options, &err)) fail_msg("%s", err.message);
    r->y = fixture_array(r->size, sizeof(double));
    r->rate = fixture_array(r->size, sizeof(double));
    scene_initial_state(&r->scene, r->y);
}

static inline void self_rig_free(SelfRig *r)
{
    newton_free(&r->newton);
    workspace_free(&r->ws);
    scene_clear(&r->scene);
    free(r->y);
    free(r->rate);
}

/* Segment i from a to b, at rest. */
static inline void self_rig_place(SelfRig *r, int i, Vec3 a, Vec3 b)
{
    const Vec3 ex = v3_unit(v3_sub(b, a)), side = fabs(ex.z) < 0.9 ? v3(0, 0, 1) : v3(1, 0, 0);
    const Vec3 ey = v3_unit(v3_cross(side, ex)), ez = v3_cross(ex, ey);
    state_set_vec(r->y, r->n, STATE_P, i, v3_scale(0.5, v3_add(a, b)));
    state_set_quat(r->y, r->n, i, quat_from_axes(ex, ey, ez));
}

/* Segments first .. first + count - 1 straight on from `start`. */
static inline void self_rig_strand(SelfRig *r, int first, int count, Vec3 start, Vec3 direction)
{
    const double h = 2 * r->scene.chain.half[first];
    const Vec3 step = v3_scale(h, v3_unit(direction));
    for (int k = 0; k < count; ++k) {
        self_rig_place(r, first + k, v3_axpy(start, k, step), v3_axpy(start, k + 1, step));
    }
}

/* All on a helix about z. */
static inline void self_rig_helix(SelfRig *r, double radius, double pitch)
{
    Vec3 from = v3(radius, 0, 0);
    const double turn = 2 * asin(r->scene.chain.half[0] / radius);
    for (int i = 0; i < r->n; ++i) {
        const double angle = turn * (i + 1);
        const Vec3 to = v3(radius * cos(angle), radius * sin(angle), pitch * angle / (2 * M_PI));
        self_rig_place(r, i, from, to);
        from = to;
    }
}

/* No joint between segments j-1 and j any more. */
static inline void self_rig_cut(SelfRig *r, int j)
{
    for (int c = 0; c < 6; ++c) r->scene.chain.stiffness[c][j] = r->scene.chain.damping[c][j] = 0;
}

static inline void self_rig_refresh(SelfRig *r)
{
    assert_int_equal(dynamics_refresh(&r->scene, &r->ws, 0, r->y, 1, NULL), HAWSER_OK);
}

/* Kinetic energy, J. */
static inline double self_rig_kinetic(SelfRig *r)
{
    const Chain *const c = &r->scene.chain;
    double sum = 0;
    for (int i = 0; i < r->n; ++i) {
        const Vec3 v = state_vec(r->y, r->n, STATE_V, i), w = state_vec(r->y, r->n, STATE_W, i);
        const Vec3 body = quat_rotate(quat_conj(state_quat(r->y, r->n, i)), w);
        sum += 0.5 * c->mass[i] * v3_dot(v, v) + 0.5 * c->inertia[0][i] * body.x * body.x +
               0.5 * c->inertia[1][i] * body.y * body.y + 0.5 * c->inertia[2][i] * body.z * body.z;
    }
    return sum;
}

#endif
