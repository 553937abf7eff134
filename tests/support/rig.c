#include "tests/support/rig.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

Rig *rig_make(SceneDef *def, const LinOptions *options)
{
    Rig *const r = fixture_array(1, sizeof *r);
    hawser_error err = {0};
    fixture_build(def, &r->scene);
    assert_true(workspace_alloc(&r->ws, &r->scene, NULL));
    if (newton_new(&r->newton, &r->scene, options ? options : &r->scene.def.solver.linear, &err)) {
        fail_msg("%s", err.message);
    }
    r->n = r->scene.chain.n;
    r->size = scene_state_size(&r->scene);
    r->y = fixture_array(r->size, sizeof(double));
    r->rate = fixture_array(r->size, sizeof(double));
    scene_initial_state(&r->scene, r->y);
    return r;
}

Rig *rig_free(Rig *r)
{
    integrator_free(r->integrator);
    newton_free(&r->newton);
    workspace_free(&r->ws);
    scene_clear(&r->scene);
    free(r->y);
    free(r->rate);
    free(r);
    return NULL;
}

void rig_refresh(Rig *r) { assert_int_equal(dynamics_refresh(&r->scene, &r->ws, r->t, r->y, 1, NULL), HAWSER_OK); }

void rig_linearise(Rig *r)
{
    dynamics_rates(&r->scene, &r->ws, r->t, r->y, 1, r->rate);
    dynamics_blocks(&r->scene, &r->ws, r->t, r->y, r->rate, 1, &r->newton.k, &r->newton.d);
    newton_point(&r->newton, &r->scene, &r->ws.kin, r->y);
    if (r->ws.equipment) newton_point_equipment(&r->newton, r->ws.equipment, r->y, 1);
}

/* Position, quaternion, velocity, angular velocity of segments 0..3 and mounts 4..7; 8: a spin. */
static int kind_of(const Rig *r, int k)
{
    const int chain = STATE_SIZE * r->n, spins = r->scene.equipment ? r->scene.equipment->spins : 0;
    if (k >= chain && k < chain + spins) return 8;
    const int c = k < chain ? k / r->n : (k - chain - spins) / r->scene.equipment->mounts;
    return (k < chain ? 0 : 4) + (c < STATE_Q ? 0 : c < STATE_V ? 1 : c < STATE_W ? 2 : 3);
}

/* J x; scratch: [2 size]. */
static void jacobian_times(Rig *r, const double *x, double step, double *scratch, double *jx)
{
    static const double at[] = {2, 1, -1, -2}, share[] = {-1, 8, -8, 1};
    double size = 0, *const y = scratch, *const rate = scratch + r->size;
    for (int k = 0; k < r->size; ++k) size = larger_of(size, fabs(x[k]));
    const double e = step / size;
    memset(jx, 0, (size_t)r->size * sizeof *jx);
    for (int i = 0; i < 4; ++i) {
        for (int k = 0; k < r->size; ++k) y[k] = r->y[k] + at[i] * e * x[k];
        dynamics_rates(&r->scene, &r->ws, r->t, y, 1, rate);
        for (int k = 0; k < r->size; ++k) jx[k] += share[i] / (12 * e) * rate[k];
    }
}

double rig_solve_error(Rig *r, double gamma, double step)
{
    double error[9] = {0}, term[9] = {0}, worst = 0, *const room = fixture_array(7 * r->size, sizeof *room);
    double *const b = room, *const x = b + r->size, *const z = x + r->size, *const jx = z + r->size;
    double *const jz = jx + r->size, *const scratch = jz + r->size;
    for (int k = 0; k < r->size; ++k) x[k] = b[k] = fixture_random(&r->seed);
    assert_int_equal(newton_solve(&r->newton, x), 0);
    for (int k = 0; k < r->size; ++k) z[k] = fixture_random(&r->seed) > 0 ? x[k] : -x[k];
    jacobian_times(r, x, step, scratch, jx);
    jacobian_times(r, z, step, scratch, jz);
    for (int k = 0; k < r->size; ++k) {
        const int kind = kind_of(r, k);
        error[kind] = larger_of(error[kind], fabs(x[k] - gamma * jx[k] - b[k]));
        term[kind] = larger_of(term[kind], larger_of(fabs(x[k]), larger_of(fabs(gamma * jz[k]), fabs(b[k]))));
    }
    for (int kind = 0; kind < 9; ++kind) worst = larger_of(worst, term[kind] <= 0 ? 0 : error[kind] / term[kind]);
    free(room);
    return worst;
}

Motion *rig_motion(Rig *r) { return spatial_init(&r->spatial, &r->scene, &r->ws, &r->newton); }

hawser_status rig_run(Rig *r, double to, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    if (!r->integrator) status = integrator_new(rig_motion(r), r->t, r->y, &r->integrator, err);
    while (!status && r->t < to) status = integrator_step(r->integrator, to, &r->t, err);
    return status;
}

void rig_advance(Rig *r, double to)
{
    hawser_error err = {0};
    if (rig_run(r, to, &err)) fail_msg("%s", err.message);
}

void self_rig_new(Rig *r, int n, double h, double g, int soft, Team *team, LinKind kind, void (*more)(SceneDef *))
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

void self_rig_free(Rig *r)
{
    newton_free(&r->newton);
    workspace_free(&r->ws);
    scene_clear(&r->scene);
    free(r->y);
    free(r->rate);
}

void self_rig_place(Rig *r, int i, Vec3 a, Vec3 b)
{
    const Vec3 ex = v3_unit(v3_sub(b, a)), side = fabs(ex.z) < 0.9 ? v3(0, 0, 1) : v3(1, 0, 0);
    const Vec3 ey = v3_unit(v3_cross(side, ex)), ez = v3_cross(ex, ey);
    state_set_vec(r->y, r->n, STATE_P, i, v3_scale(0.5, v3_add(a, b)));
    state_set_quat(r->y, r->n, i, quat_from_axes(ex, ey, ez));
}

void self_rig_strand(Rig *r, int first, int count, Vec3 start, Vec3 direction)
{
    const double h = 2 * r->scene.chain.half[first];
    const Vec3 step = v3_scale(h, v3_unit(direction));
    for (int k = 0; k < count; ++k) {
        self_rig_place(r, first + k, v3_axpy(start, k, step), v3_axpy(start, k + 1, step));
    }
}

void self_rig_helix(Rig *r, double radius, double pitch)
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

void self_rig_cut(Rig *r, int j)
{
    for (int c = 0; c < 6; ++c) r->scene.chain.stiffness[c][j] = r->scene.chain.damping[c][j] = 0;
}

void self_rig_refresh(Rig *r) { assert_int_equal(dynamics_refresh(&r->scene, &r->ws, 0, r->y, 1, NULL), HAWSER_OK); }

double self_rig_kinetic(Rig *r)
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

void rod_stage(SceneDef *def, Stage *stage)
{
    hawser_error err = {0};
    if (stage_new(stage, def, NULL, &err)) fail_msg("%s", err.message);
    scene_def_clear(def);
}

void rod_solve(Stage *stage)
{
    hawser_error err = {0};
    hawser_relaxation out = {0};
    const int steps = stage->scene.def.analysis.load_steps;
    if (statics_settle(stage, 1e-10, &out, &err)) fail_msg("%s", err.message);
    for (int k = 1; k <= steps; ++k) {
        if (statics_advance(stage, (double)k / steps, &out, &err)) fail_msg("%s", err.message);
        assert_true(out.reached);
    }
}

Vec3 rod_front(const Stage *stage, int i)
{
    const int n = stage->scene.chain.n;
    const Vec3 axis = quat_rotate(quat_unit(state_quat(stage->y, n, i)), v3(1, 0, 0));
    return v3_axpy(state_vec(stage->y, n, STATE_P, i), stage->scene.chain.half[i], axis);
}

double payout_pull(int n, int turns, double from, double until)
{
    SceneDef def;
    hawser_error err = {0};
    double mean = 0;
    int count = 0;
    wound_case(&def, n, turns, 0.2);
    Sim *const sim = sim_made(&def, 1);
    for (double t = 0.02; t < until; t += 0.02) {
        if (sim_advance(sim, t, 0, &err)) fail_msg("%s", err.message);
        if (t <= from) continue;
        mean += hawser_sim_sample(sim)->winch_force;
        ++count;
    }
    sim_free(sim);
    return mean / count;
}

void pull_record(SceneDef *def, double duration, hawser_summary *out)
{
    hawser_relaxation relaxation;
    hawser_error err = {0};
    def->duration = duration;
    Sim *const s = sim_made(def, 1);
    assert_int_equal(sim_relax(s, &relaxation, &err), HAWSER_OK);
    assert_true(relaxation.reached);
    hawser_sim_record(s);
    for (int k = 1; k * 0.05 <= duration + 1e-9; ++k) {
        if (sim_advance(s, k * 0.05, 0, &err)) fail_msg("%s", err.message);
        hawser_sim_record(s);
    }
    hawser_sim_summary(s, out);
    out->linear_solver = out->linear_solver_why = out->ordering = out->planar_why = NULL; /* the simulation's */
    sim_free(s);
}
