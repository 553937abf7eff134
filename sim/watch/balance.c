#include "sim/watch/balance.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "sim/dynamics.h"

/* Rates are summed as one run of numbers. */
enum { RATES = sizeof(BalanceRates) / sizeof(double), POWERS = BALANCE_WORKS + BALANCE_LOSSES };
typedef union RateList {
    BalanceRates by;
    double value[RATES];
} RateList;

struct Balance {
    double t;
    RateList now;            /* at t */
    RateList sum;            /* J and N s since the beginning */
    double turnover[POWERS]; /* J: the sizes of the same */
    Vec3 weight;             /* N, of what is simulated now */
    BalanceStock first, here;
    double carried; /* J, by segments that joined, less that of those that left */
    Vec3 carried_momentum;
    double *rates; /* [size] scratch of an evaluation */
    int size;
    hawser_balance out;
};

/* Everything at (t, y). */
static void stock_at(Balance *b, Motion *motion, double t, const double *y, BalanceStock *out)
{
    motion->ops->rates(motion, t, y, b->rates);
    motion->ops->stock(motion, t, y, out);
}

/* Room for the rates of a motion; 0 if there is no memory. */
static int rates_renew(Balance *b, const Motion *motion)
{
    if (motion->size <= b->size) return 1;
    free(b->rates);
    b->rates = aligned_array_new(motion->size);
    b->size = b->rates ? motion->size : 0;
    return b->rates != NULL;
}

hawser_status balance_new(Motion *motion, double t, const double *y, Balance **out, hawser_error *err)
{
    Balance *const b = *out = calloc(1, sizeof *b);
    if (!b || !rates_renew(b, motion)) {
        *out = balance_free(b);
        return error_memory(err);
    }
    b->t = t;
    stock_at(b, motion, t, y, &b->first);
    b->weight = b->first.weight;
    motion->ops->work(motion, t, y, &b->now.by);
    b->now.by.push[PUSH_WEIGHT] = b->weight;
    return HAWSER_OK;
}

Balance *balance_free(Balance *b)
{
    if (b) free(b->rates);
    free(b);
    return NULL;
}

/* (BA9): the trapezoidal rule over the accepted steps. */
void balance_step(Balance *b, Motion *motion, double t, const double *y)
{
    RateList next;
    const double half = (t - b->t) / 2;
    motion->ops->work(motion, t, y, &next.by);
    next.by.push[PUSH_WEIGHT] = b->weight;
    for (int k = 0; k < RATES; ++k) b->sum.value[k] += half * (b->now.value[k] + next.value[k]);
    for (int k = 0; k < POWERS; ++k) b->turnover[k] += half * fabs(b->now.value[k] + next.value[k]);
    b->now = next;
    b->t = t;
}

void balance_leave(Balance *b, Motion *motion, double t, const double *y) { stock_at(b, motion, t, y, &b->here); }

static double energy_of(const BalanceStock *stock)
{
    double sum = 0;
    for (int k = 0; k < BALANCE_STORES; ++k) sum += stock->energy[k];
    return sum;
}

hawser_status balance_enter(Balance *b, Motion *motion, double t, const double *y, hawser_error *err)
{
    BalanceStock after;
    if (!rates_renew(b, motion)) return error_memory(err);
    stock_at(b, motion, t, y, &after);
    b->carried += energy_of(&after) - energy_of(&b->here);
    b->carried_momentum = v3_add(b->carried_momentum, v3_sub(after.momentum, b->here.momentum));
    b->weight = after.weight;
    motion->ops->work(motion, t, y, &b->now.by);
    b->now.by.push[PUSH_WEIGHT] = b->weight;
    return HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------------- the account */

static const char *const WORKS[BALANCE_WORKS] = {"winch", "tail",  "lead_in", "reel",   "conveyors",
                                                 "ends",  "loads", "motors",  "medium", "surface_edges"};
static const char *const LOSSES[BALANCE_LOSSES] = {
    "joint_damping",  "bending_hysteresis", "rope_drag",       "conveyor_slip",  "roller_friction",
    "roller_damping", "surface_friction",   "surface_damping", "cable_friction", "cable_damping",
    "bearings",       "mount_damping",      "medium_drag"};
static const char *const STORES[BALANCE_STORES] = {"motion",  "height",   "joints",         "bending",
                                                   "rollers", "surfaces", "cable_on_cable", "equipment"};
static const char *const PUSHES[BALANCE_PUSHES] = {"winch", "tail",    "lead_in",  "reel",   "conveyors",
                                                   "ends",  "loads",   "",         "medium", "",
                                                   "drag",  "rollers", "surfaces", "weight"};

/* Adds a term that is there; the largest turnover is what the residual is measured by. */
static void term_add(hawser_balance *out, hawser_balance_kind kind, const char *name, double energy, double turnover)
{
    if (turnover > out->turnover_J) {
        out->turnover_J = turnover;
        out->turnover_of = name;
    }
    if (!(turnover > 0)) return;
    out->term[out->n_terms++] = (hawser_balance_term){.kind = kind, .name = name, .J = energy};
}

static void vector_out(Vec3 v, double out[3])
{
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
}

/* (BA1) */
static void energy_close(Balance *b, hawser_balance *out)
{
    const double slid = b->here.energy[IN_BENDING] - b->first.energy[IN_BENDING];
    for (int k = 0; k < BALANCE_WORKS; ++k) {
        out->work_J += b->sum.by.work[k];
        term_add(out, HAWSER_BALANCE_WORK, WORKS[k], b->sum.by.work[k], b->turnover[k]);
    }
    for (int k = 0; k < BALANCE_LOSSES; ++k) {
        const double lost = b->sum.by.loss[k] - (k == LOST_BENDING ? slid : 0);
        out->lost_J += lost;
        term_add(out, HAWSER_BALANCE_LOSS, LOSSES[k], lost, b->turnover[BALANCE_WORKS + k]);
    }
    for (int k = 0; k < BALANCE_STORES; ++k) {
        const double change = b->here.energy[k] - b->first.energy[k];
        out->stored_J += change;
        /* what is carried in and out is no turnover */
        const int any = fabs(b->here.energy[k]) > 0 || fabs(change) > 0;
        if (any) out->term[out->n_terms++] = (hawser_balance_term){HAWSER_BALANCE_STORED, STORES[k], change, {0, 0, 0}};
        /* at rest nothing goes through: what is held measures then; heights count from anywhere */
        const double held = k == IN_HEIGHT ? 0 : fabs(b->here.energy[k]), moved = b->carried == 0 ? fabs(change) : 0;
        const double size = fmax(held, moved);
        if (size > out->turnover_J) {
            out->turnover_J = size;
            out->turnover_of = STORES[k];
        }
    }
    out->carried_J = b->carried;
    out->residual_J = out->stored_J - b->carried - (out->work_J - out->lost_J);
    out->residual_share = out->turnover_J > 0 ? fabs(out->residual_J) / out->turnover_J : 0;
}

/* (BA2) */
static void momentum_close(Balance *b, hawser_balance *out)
{
    Vec3 sum = {0, 0, 0};
    double largest = 0;
    for (int k = 0; k < BALANCE_PUSHES; ++k) {
        const Vec3 impulse = b->sum.by.push[k];
        const double size = v3_norm(impulse);
        sum = v3_add(sum, impulse);
        largest = fmax(largest, size);
        if (!(size > 0)) continue;
        hawser_balance_term *const term = &out->term[out->n_terms++];
        *term = (hawser_balance_term){.kind = HAWSER_BALANCE_IMPULSE, .name = PUSHES[k], .J = NAN};
        vector_out(impulse, term->N_s);
    }
    const Vec3 change = v3_sub(b->here.momentum, b->first.momentum), carried = b->carried_momentum;
    const Vec3 residual = v3_sub(v3_sub(change, carried), sum);
    vector_out(sum, out->impulse_N_s);
    vector_out(change, out->momentum_N_s);
    vector_out(carried, out->carried_N_s);
    vector_out(residual, out->residual_N_s);
    out->impulse_residual_share = largest > 0 ? v3_norm(residual) / largest : 0;
}

const hawser_balance *balance_close(Balance *b, Motion *motion, double t, const double *y)
{
    stock_at(b, motion, t, y, &b->here);
    b->out = (hawser_balance){.turnover_of = ""};
    energy_close(b, &b->out);
    momentum_close(b, &b->out);
    return &b->out;
}
