#include "sim/stage/stability.h"

#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "core/body.h"
#include "sim/equipment/rod.h"
#include "sim/stage/modes.h"

/* A motion that grows so slowly beside its swing that a damping ratio of as much would hold it does not count: round
 * sections under a dead torque flutter at any load if nothing damps them. */
static const double HELD = 0.01;
enum { LOOKED_AT = 6 }; /* modes, where only they can tell */

/* ------------------------------------------------------------------------------------------------- counting */

double stability_radius(const Chain *chain)
{
    double length = 0;
    for (int i = 0; i < chain->n; ++i) length += 2 * chain->half[i];
    return length / 10;
}

/* Enough above rounding for the modes to tell it from a rigid motion. */
double stability_least(const Chain *chain) { return 4 * modes_rounding(chain, stability_radius(chain)); }

/* K of the stage's state without damping, in M - dt^2 K for the shift below which rounding decides (RD16). */
static hawser_status matrix_form(Stage *st, double *rate, hawser_error *err)
{
    memset(rate, 0, (size_t)st->motion->size * sizeof *rate);
    dynamics_blocks(&st->scene, &st->ws, st->t, st->y, rate, 0.0, &st->newton.k, &st->newton.d);
    block_chain_zero(&st->newton.d);
    newton_point(&st->newton, &st->scene, &st->ws.kin, st->y);
    newton_swell(&st->newton, stability_radius(&st->scene.chain));
    newton_point_equipment(&st->newton, st->ws.equipment, st->y, 0.0);
    newton_form(&st->newton, 1 / sqrt(stability_least(&st->scene.chain)));
    return newton_renew(&st->newton, st->ws.equipment, err);
}

/* By the lowest modes: loads without a potential make motions that swing and grow (RD17). */
static hawser_status count_modes(Stage *st, int *unstable, int *swings, hawser_error *err)
{
    Modes modes = {0};
    hawser_error why = {0};
    const hawser_status status = modes_find(st, LOOKED_AT, 0, &modes, &why);
    *unstable = status ? -1 : 0;
    *swings = 0;
    for (int m = 0; !status && m < modes.n; ++m) {
        const hawser_mode *const mode = &modes.out[m];
        const double swing = 2 * M_PI * mode->frequency_Hz;
        if (!(mode->growth_per_s > HELD * swing)) continue;
        *swings += swing > HELD * mode->growth_per_s;
        ++*unstable;
    }
    *swings = *unstable > 0 && *swings == *unstable;
    modes_free(&modes);
    return status == HAWSER_ERR_MEMORY ? error_memory(err) : HAWSER_OK;
}

hawser_status stability_count(Stage *st, int *unstable, int *swings, hawser_error *err)
{
    *swings = 0;
    if (rod_circulates(st->scene.rod, st->t)) return count_modes(st, unstable, swings, err);
    double *const rate = malloc((size_t)st->motion->size * sizeof *rate);
    hawser_status status = rate ? matrix_form(st, rate, err) : error_memory(err);
    free(rate);
    if (status) return status;
    *unstable = newton_negative(&st->newton);
    return *unstable < 0 ? count_modes(st, unstable, swings, err) : HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------------ the motion */

/* The mass-weighted product of two motions [6 n] (M of the last matrix). */
static double product(const Newton *nw, const double *a, const double *b)
{
    double sum = 0;
    for (int i = 0; i < nw->n; ++i) {
        const double *const u = a + 6 * i, *const v = b + 6 * i;
        for (int r = 0; r < 3; ++r) {
            sum += nw->mass[i] * u[r] * v[r];
            for (int c = 0; c < 3; ++c) sum += u[3 + r] * nw->inertia[3 * r + c][i] * v[3 + c];
        }
    }
    return sum;
}

static void scale_by(int size, double scale, double *x)
{
    for (int k = 0; k < size; ++k) x[k] *= scale;
}

/* The largest turn 1 rad, but no shift beyond the rod's length. */
static void shape_scale(const Chain *chain, double *shape)
{
    double turn = 0, move = 0, length = 0;
    for (int i = 0; i < chain->n; ++i) {
        move = fmax(move, v3_norm(v3_get(shape + 6 * i)));
        turn = fmax(turn, v3_norm(v3_get(shape + 6 * i + 3)));
        length += 2 * chain->half[i];
    }
    scale_by(6 * chain->n, 1 / (fmax(turn, move / length) + 1e-300), shape);
}

/* The way of the positions from `from` to the state's, as a motion without turns. */
static void way_of(const Stage *st, const double *from, double *way)
{
    const int n = st->scene.chain.n;
    memset(way, 0, 6 * (size_t)n * sizeof *way);
    for (int i = 0; i < n; ++i) {
        for (int c = 0; c < 3; ++c) way[6 * i + c] = st->y[c * n + i] - from[c * n + i];
    }
}

/* shape = the sum of the first `count` modes that are no rigid motion, each by what the way has of it; the first alone
 * if it has nothing. */
static void shapes_add(const Stage *st, const Modes *modes, int count, const double *way, double *shape)
{
    const int size = 6 * st->scene.chain.n;
    const double length = sqrt(product(&st->newton, way, way));
    double largest = 0;
    memset(shape, 0, (size_t)size * sizeof *shape);
    const double *first = NULL;
    for (int m = 0, found = 0; m < modes->n && found < count; ++m) {
        const double *const z = modes->out[m].shape;
        if (modes->out[m].omega_squared == 0) continue; /* a rigid motion */
        if (found++ == 0) first = z;
        const double norm = sqrt(product(&st->newton, z, z)), share = product(&st->newton, z, way) / norm;
        largest = fmax(largest, fabs(share));
        for (int k = 0; k < size; ++k) shape[k] += share / norm * z[k];
    }
    if (first && !(largest > 1e-9 * length)) memcpy(shape, first, (size_t)size * sizeof *shape);
}

/* The mode that grows fastest. */
static void fastest_take(const Modes *modes, int size, double *shape)
{
    int best = 0;
    for (int m = 1; m < modes->n; ++m) {
        if (modes->out[m].growth_per_s > modes->out[best].growth_per_s) best = m;
    }
    memcpy(shape, modes->out[best].shape, (size_t)size * sizeof *shape);
}

hawser_status stability_shape(Stage *st, int count, const double *from, double *shape, hawser_error *err)
{
    Modes modes = {0};
    double *const way = malloc(6 * (size_t)st->scene.chain.n * sizeof *way);
    const double radius = count > 0 ? stability_radius(&st->scene.chain) : 0;
    hawser_status status = way ? modes_find(st, LOOKED_AT, radius, &modes, err) : error_memory(err);
    if (!status && count == 0) fastest_take(&modes, 6 * st->scene.chain.n, shape);
    if (!status && count > 0) {
        way_of(st, from, way);
        shapes_add(st, &modes, count, way, shape);
    }
    if (!status) {
        shape_scale(&st->scene.chain, shape);
    }
    modes_free(&modes);
    free(way);
    return status;
}

hawser_status stability_push(Stage *st, double t, const double *shape, double *share, hawser_error *err)
{
    const int n = st->scene.chain.n;
    double *const rate = malloc((size_t)st->motion->size * sizeof *rate);
    double *const push = calloc(6 * (size_t)n, sizeof *push); /* M^-1 of the forces: accelerations */
    if (rate && push) {
        dynamics_rates(&st->scene, &st->ws, t, st->y, 0.0, rate);
        for (int i = 0; i < n; ++i) {
            const Vec3 spin = state_vector(rate, n, STATE_W, i);
            const Vec3 moment = body_inertia_times(&st->scene.chain, &st->ws.kin, i, spin);
            v3_put(push + 6 * i, state_vector(rate, n, STATE_V, i));
            v3_put(push + 6 * i + 3,
                   v3_scale(1 / st->newton.inertia[0][i], moment)); /* swollen, the same in all axes */
        }
        const double both = product(&st->newton, push, push) * product(&st->newton, shape, shape);
        *share = both > 0 ? fabs(product(&st->newton, shape, push)) / sqrt(both) : 0;
    }
    const int there = rate && push;
    free(rate);
    free(push);
    return there ? HAWSER_OK : error_memory(err);
}

void stability_nudge(Stage *st, double size, const double *shape)
{
    const int n = st->scene.chain.n;
    for (int i = 0; i < n; ++i) {
        const Quat turned =
            quat_unit(quat_mul(quat_exp(v3_scale(size, v3_get(shape + 6 * i + 3))), state_attitude(st->y, n, i)));
        const double q[4] = {turned.w, turned.x, turned.y, turned.z};
        for (int c = 0; c < 3; ++c) st->y[c * n + i] += size * shape[6 * i + c];
        for (int c = 0; c < 4; ++c) st->y[(STATE_Q + c) * n + i] = q[c];
    }
}

/* ---------------------------------------------------------------------------------------------- what was found */

/* Where along the rod the motion is largest, and whereto it goes there. */
static void largest_find(const Chain *chain, const double *shape, hawser_critical *out)
{
    double from = 0, largest = 0;
    for (int i = 0; shape && i < chain->n; ++i) {
        const Vec3 move = v3_get(shape + 6 * i);
        if (v3_norm(move) > largest) {
            largest = v3_norm(move);
            out->at = from + chain->half[i];
            v3_put(out->direction, v3_unit(move));
        }
        from += 2 * chain->half[i];
    }
}

hawser_status stability_add(Stage *st, hawser_critical found, double *shape, hawser_error *err)
{
    Stability *const s = &st->stability;
    if (s->n == s->room) {
        const int room = 2 * s->room + 4;
        hawser_critical *const grown = realloc(s->critical, (size_t)room * sizeof *grown);
        if (!grown) {
            free(shape);
            return error_memory(err);
        }
        s->critical = grown;
        s->room = room;
    }
    found.share = found.t / st->scene.def.duration;
    found.shape = shape;
    largest_find(&st->scene.chain, shape, &found);
    s->critical[s->n++] = found;
    return HAWSER_OK;
}

void stability_take_back(Stage *st)
{
    hawser_critical *const last = &st->stability.critical[--st->stability.n];
    free((double *)(uintptr_t)last->shape);
    last->shape = NULL;
}
