#include "sim/newton/relax_static.h"

#include "core/base/error.h"
#include "core/body.h"
#include "core/state.h"
#include "linsolve/inertia.h"
#include "sim/equipment/rod.h"
#include "sim/newton/relax_space.h"

/* Newton's method on the way of the loads (RD8): the largest turn in one iteration. */
static const double TURN_NEWTON = 0.5; /* rad */
/* The way down (RD20): the largest turn in one iteration; steps grow and shrink by these. */
static const double TURN_DOWN = 0.2, GROWTH = 4, SHRINKING = 0.5;
enum { NEWTON_ITERATIONS = 60, CUT_ITERATIONS = 3000, DOWN_ITERATIONS = 3000, PATIENCE = 500, CALMING = 6 };

/* The largest force in the scene: weights, loads, and what the joints carry, N. */
static double largest_force(const Relaxation *r)
{
    const Chain *const chain = &r->scene->chain;
    const JointLoads *const joints = &r->ws->joints;
    double largest = rod_load_size(r->scene->rod, chain, r->t);
    for (int i = 0; i < chain->n; ++i) largest = fmax(largest, chain->mass[i] * v3_norm(r->scene->weight.gravity));
    for (int j = 0; j <= chain->n; ++j) {
        largest = fmax(largest, v3_norm(v3_load(joints->force, j)));
    }
    return largest;
}

/* Residual and what is allowed of it (RD8); `reached` is set. */
static void look(Relaxation *r, const StaticAim *aim, hawser_relaxation *out)
{
    out->residual_N = space_residual(r, &out->segment);
    out->tolerance_N = fmax(aim->share * largest_force(r), aim->floor);
    out->reached = out->residual_N <= out->tolerance_N;
}

/* The largest turn in the velocities found, times dt, rad. */
static double turn_of(const Relaxation *r, double dt)
{
    const int n = r->scene->chain.n;
    double largest = 0;
    for (int i = 0; i < n; ++i) largest = fmax(largest, dt * v3_norm(state_vector(r->rate, n, STATE_W, i)));
    return largest;
}

/* The same of shifts, m. */
static double shift_of(const Relaxation *r, double dt)
{
    const int n = r->scene->chain.n;
    double largest = 0;
    for (int i = 0; i < n; ++i) largest = fmax(largest, dt * v3_norm(state_vector(r->rate, n, STATE_V, i)));
    return largest;
}

/* What share of a move by dt times the velocities found may be made: no segment turns by more than `turn` (rad), nor
 * goes farther than half the way through anything (E2). */
static double share_of(const Relaxation *r, double dt, double turn)
{
    const Scene *const scene = r->scene;
    const double turns = turn_of(r, dt);
    double half = 0;
    for (int i = 0; i < scene->chain.n; ++i) half = fmax(half, scene->chain.half[i]);
    const double through = scene_way(scene) / 2 / (shift_of(r, dt) + half * turns + 1e-300);
    return fmin(1, fmin(turn / (turns + 1e-300), through));
}

/* Newton's method (RD8). Residuals grow on the way, since turning a stiff segment stretches its neighbours: only the
 * number of iterations and what is not a number end it early. Moves that are cut short, so that they pass nothing, do
 * not count among the iterations. */
static hawser_status newton_iterate(Relaxation *r, StaticAim *aim, hawser_relaxation *out, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    aim->turn = aim->shift = 0;
    int cut = 0;
    for (int it = 0; !status && it - cut <= NEWTON_ITERATIONS; ++it) {
        look(r, aim, out);
        if (out->reached || !isfinite(out->residual_N) || it - cut == NEWTON_ITERATIONS) break;
        status = relax_stopped(&r->ws->stop, 0, err);
        const int bad = status ? 0 : space_step(r, aim->dt);
        if (bad < 0) return error_memory(err);
        if (status || bad) break;
        if (it == 0) {
            aim->turn = turn_of(r, aim->dt);
            aim->shift = shift_of(r, aim->dt);
        }
        const double share = share_of(r, aim->dt, TURN_NEWTON);
        cut += cut < CUT_ITERATIONS && share < fmin(1, TURN_NEWTON / (turn_of(r, aim->dt) + 1e-300));
        space_move(r, share * aim->dt);
        ++out->iterations;
        status = space_refresh(r, 0, err);
    }
    return status;
}

/* K without damping, which holds nothing, and swollen inertias; the accelerations in `rate` become those that go with
 * them. */
static void blocks_swollen(Relaxation *r, double radius)
{
    const Chain *const chain = &r->scene->chain;
    const int n = chain->n;
    space_blocks(r);
    block_chain_zero(&r->newton->d);
    newton_swell(r->newton, radius);
    for (int i = 0; i < n; ++i) {
        const Vec3 moment = body_inertia_times(chain, &r->ws->kin, i, state_vector(r->rate, n, STATE_W, i));
        const Vec3 spin = v3_scale(1 / (chain->mass[i] * radius * radius), moment);
        const double part[3] = {spin.x, spin.y, spin.z};
        for (int c = 0; c < 3; ++c) r->rate[(STATE_W + c) * n + i] = part[c];
    }
}

/* The longest step, at most `dt`, at which no direction of M - dt^2 K is negative; the matrix is formed for it (RD20).
 */
static double step_downhill(Relaxation *r, double dt)
{
    newton_form(r->newton, dt);
    while (newton_negative(r->newton) > 0 && dt > 1e-9) {
        dt *= SHRINKING;
        newton_form(r->newton, dt);
    }
    return dt;
}

/* A step turns segments, and that stretches their neighbours to second order: forces that make the next step's matrix
 * another than the equilibrium's. Short steps take them away and leave what gives way slowly where it is (RD20). */
static hawser_status calm(Relaxation *r, double dt, double radius, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    int where;
    double before = INFINITY;
    for (int it = 0; !status && it < CALMING; ++it) {
        const double now = space_residual(r, &where);
        if (!(now < before / 2)) break;
        before = now;
        blocks_swollen(r, radius);
        const double step = step_downhill(r, dt);
        const int bad = space_solve(r, step);
        if (bad < 0) return error_memory(err);
        if (bad) break;
        space_move(r, share_of(r, step, TURN_DOWN) * step);
        status = space_refresh(r, 0, err);
    }
    return status;
}

/* Steps along which the energy falls, until nothing is left of forces and of directions in which it could go on. Where
 * whole steps go round in circles shorter ones are taken. */
static hawser_status descend(Relaxation *r, StaticAim *aim, hawser_relaxation *out, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    double dt = aim->dt, cap = aim->dt;
    for (int it = 0; !status && it < DOWN_ITERATIONS; ++it) {
        look(r, aim, out);
        if (!isfinite(out->residual_N)) break;
        status = relax_stopped(&r->ws->stop, 0, err);
        if (status) return status;
        blocks_swollen(r, aim->radius);
        newton_form(r->newton, aim->dt);
        if (out->reached && newton_negative(r->newton) == 0) return status;
        if (it > 0 && it % PATIENCE == 0) cap = fmin(cap, fmin(dt, 10)) / 10;
        dt = step_downhill(r, fmin(cap, GROWTH * dt));
        const int bad = space_solve(r, dt);
        if (bad < 0) return error_memory(err);
        if (bad) break;
        space_move(r, share_of(r, dt, TURN_DOWN) * dt);
        ++out->iterations;
        status = space_refresh(r, 0, err);
        if (!status) status = calm(r, dt / 10, aim->radius, err);
    }
    out->reached = 0;
    return status;
}

typedef hawser_status (*Way)(Relaxation *r, StaticAim *aim, hawser_relaxation *out, hawser_error *err);

static hawser_status go(Relaxation r, Way way, StaticAim *aim, hawser_relaxation *out, hawser_error *err)
{
    hawser_status status = space_begin(&r) ? HAWSER_OK : error_memory(err);
    if (!status) {
        aim->floor = relax_rounding(r.scene, space_farthest(&r, NULL));
        status = way(&r, aim, out, err);
        out->moved_m = fmax(out->moved_m, space_farthest(&r, r.start));
    }
    space_end(&r);
    return status;
}

hawser_status relax_static(const Scene *scene, Workspace *ws, Newton *newton, double t, StaticAim *aim, double *y,
                           hawser_relaxation *out, hawser_error *err)
{
    return go((Relaxation){.scene = scene, .ws = ws, .newton = newton, .t = t, .y = y}, newton_iterate, aim, out, err);
}

hawser_status relax_downhill(const Scene *scene, Workspace *ws, Newton *newton, double t, StaticAim *aim, double *y,
                             hawser_relaxation *out, hawser_error *err)
{
    return go((Relaxation){.scene = scene, .ws = ws, .newton = newton, .t = t, .y = y}, descend, aim, out, err);
}
