#include "sim/newton/relax_space.h"

#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"

double space_residual(void *self, int *where)
{
    Relaxation *const r = self;
    dynamics_rates(r->scene, r->ws, r->t, r->y, r->friction, r->rate);
    return space_unbalanced(r, where);
}

double space_unbalanced(const Relaxation *r, int *where)
{
    const Chain *const chain = &r->scene->chain;
    const int n = chain->n;
    double largest = 0;
    for (int i = 0; i < n; ++i) {
        const Vec3 a = v3(r->rate[7 * n + i], r->rate[8 * n + i], r->rate[9 * n + i]);
        const Vec3 spin = v3(r->rate[10 * n + i], r->rate[11 * n + i], r->rate[12 * n + i]);
        const double force = chain->mass[i] * v3_norm(a);
        const double moment = v3_norm(body_inertia_times(chain, &r->ws->kin, i, spin)) / chain->half[i];
        const double both = force + moment;
        if (both > largest || isnan(both)) {
            largest = both;
            *where = i;
        }
    }
    const double mounts = equipment_residual(r->scene->equipment, r->scene->rollers, r->rate + STATE_SIZE * n);
    return mounts > largest || isnan(mounts) ? mounts : largest;
}

void space_blocks(Relaxation *r)
{
    dynamics_blocks(r->scene, r->ws, r->t, r->y, r->rate, r->friction, &r->newton->k, &r->newton->d);
    newton_point(r->newton, r->scene, &r->ws->kin, r->y);
    newton_point_equipment(r->newton, r->ws->equipment, r->y, r->friction);
}

void space_from_rest(Relaxation *r, double dt)
{
    const int n = r->scene->chain.n;
    memset(r->rate, 0, (size_t)(STATE_V * n) * sizeof(double));
    for (int k = STATE_V * n; k < r->size; ++k) r->rate[k] *= dt;
    /* the mounts' positions and quaternions have no residual either */
    const int mounts = STATE_SIZE * n + r->scene->equipment->spins;
    memset(r->rate + mounts, 0, (size_t)(STATE_V * r->scene->equipment->mounts) * sizeof(double));
}

int space_solve(Relaxation *r, double dt)
{
    const int status = newton_factor(r->newton);
    if (status) return status;
    space_from_rest(r, dt);
    return newton_solve(r->newton, r->rate);
}

int space_step(void *self, double dt)
{
    Relaxation *const r = self;
    space_blocks(r);
    newton_form(r->newton, dt);
    return space_solve(r, dt);
}

double space_move_scale(void *self, double dt)
{
    const Relaxation *const r = self;
    const int n = r->scene->chain.n;
    const RelaxStride most = relax_stride(r->scene);
    double scale = 1;
    for (int i = 0; i < n; ++i) {
        const Vec3 u = v3(r->rate[7 * n + i], r->rate[8 * n + i], r->rate[9 * n + i]);
        const Vec3 w = v3(r->rate[10 * n + i], r->rate[11 * n + i], r->rate[12 * n + i]);
        scale = relax_shorten(&most, scale, dt * v3_norm(u), dt * v3_norm(w), r->scene->chain.half[i]);
    }
    const double *const beside = r->rate + STATE_SIZE * n;
    return fmin(scale, equipment_move_share(r->scene->equipment, beside, dt, most.move, most.turn));
}

void space_move(void *self, double dt)
{
    Relaxation *const r = self;
    const int n = r->scene->chain.n;
    equipment_move(r->scene->equipment, r->y + STATE_SIZE * n, r->rate + STATE_SIZE * n, dt);
    for (int i = 0; i < n; ++i) {
        double *const y = r->y + i;
        for (int c = 0; c < 3; ++c) y[c * n] += dt * r->rate[(STATE_V + c) * n + i];
        const Vec3 turn = v3(r->rate[10 * n + i], r->rate[11 * n + i], r->rate[12 * n + i]);
        const Quat q =
            quat_unit(quat_mul(quat_exp(v3_scale(dt, turn)), (Quat){y[3 * n], y[4 * n], y[5 * n], y[6 * n]}));
        y[3 * n] = q.w;
        y[4 * n] = q.x;
        y[5 * n] = q.y;
        y[6 * n] = q.z;
    }
}

double space_farthest(const Relaxation *r, const double *from)
{
    const int n = r->scene->chain.n;
    return relax_farthest(n, n, 3, r->y, from);
}

hawser_status space_refresh(void *self, int always, hawser_error *err)
{
    Relaxation *const r = self;
    if (!always) dynamics_kinematics(r->scene, r->ws, r->t, r->y);
    const hawser_status status = always ? HAWSER_OK : newton_renew(r->newton, r->ws->equipment, err);
    return status ? status : dynamics_refresh(r->scene, r->ws, r->t, r->y, always, err);
}

void space_soften(void *self, double share)
{
    Relaxation *const r = self;
    dynamics_soften(r->scene, r->ws, share);
}

/* Mounts are held until the chain has come to rest on them, and are let go then: what they give way by changes little,
 * but light bodies on springs under a chain that falls make for many more iterations (SP15). */
static hawser_status stages(Relaxation *r, const RelaxOps *ops, hawser_relaxation *out, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    if (r->scene->equipment->mounts > 0) {
        r->ws->equipment->held = 1;
        status = relax_run(r->scene, &r->ws->stop, ops, r, r->size, r->y, out, err);
        r->ws->equipment->held = 0;
    }
    return status ? status : relax_run(r->scene, &r->ws->stop, ops, r, r->size, r->y, out, err);
}

int space_begin(Relaxation *r)
{
    const size_t n = (size_t)r->scene->chain.n;
    r->size = scene_state_size(r->scene);
    if (!r->rate) r->rate = malloc((size_t)r->size * sizeof(double)); /* unless somebody lends it */
    r->start = malloc(3 * n * sizeof(double));
    if (!r->rate || !r->start) return 0;
    memcpy(r->start, r->y, 3 * n * sizeof(double));
    memset(r->y + STATE_V * n, 0, (STATE_SIZE - STATE_V) * n * sizeof(double));
    equipment_halt(r->scene->equipment, r->y + STATE_SIZE * n);
    return 1;
}

void space_end(Relaxation *r)
{
    free(r->rate);
    free(r->start);
}

hawser_status relax_to_equilibrium(const Scene *scene, Workspace *ws, Newton *newton, double t, double *y,
                                   hawser_relaxation *out, hawser_error *err)
{
    static const RelaxOps ops = {space_residual, space_step, space_move_scale, space_move, space_refresh, space_soften};
    Relaxation r = {.scene = scene, .ws = ws, .newton = newton, .t = t, .y = y};
    *out = (hawser_relaxation){0};
    hawser_status status = space_begin(&r) ? HAWSER_OK : error_memory(err);
    if (!status) {
        out->tolerance_N = relax_tolerance(scene, t, space_farthest(&r, NULL));
        status = stages(&r, &ops, out, err);
        out->moved_m = space_farthest(&r, r.start);
    }
    space_end(&r);
    return status;
}
