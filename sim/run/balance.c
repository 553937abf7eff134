#include "sim/run/balance.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/body.h"
#include "core/bushing.h"
#include "core/error.h"
#include "core/lanes.h"
#include "sim/dynamics.h"
#include "sim/solve/scales.h"

void balance_gather(const Workspace *ws, BalanceRates *out)
{
    for (int p = 0; p < PARTS; ++p) {
        out->loss[LOST_JOINTS] += ws->joint_power[p].damping;
        out->loss[LOST_BENDING] += ws->joint_power[p].sliding;
        balance_work(out, BY_LEAD_IN, ws->lead_in[p]);
    }
}

/* Updates the kinematics and the joints at the chain's ends. */
static void ends_look(const Moment *m, const double *y)
{
    const Scene *const scene = m->scene;
    Workspace *const ws = m->ws;
    const int n = scene->chain.n, last = (n - 1) / LANES * LANES;
    body_kernels()->kinematics(n, y, 0, LANES < n ? LANES : n, &ws->kin);
    body_kernels()->kinematics(n, y, last, n, &ws->kin);
    scene_ghosts(scene, m->t, &ws->kin);
    bushing_kernels()->loads(&scene->chain, &ws->kin, n / LANES * LANES, n + 1, &ws->joints);
}

void balance_spatial(const Scene *scene, Workspace *ws, double t, const double *y, BalanceRates *out)
{
    const Moment m = {scene, ws, t, 1};
    memset(out, 0, sizeof *out);
    balance_gather(ws, out);
    ends_look(&m, y);
    for (int r = 0; r < scene->n_rooms; ++r) {
        const Room *const room = &scene->room[r];
        if (room->present && room->kind->work) room->kind->work(room, &m, out);
    }
}

/* The chain as bodies (BA7). */
static void bodies_stock(const Scene *scene, const Kinematics *kin, BalanceStock *out)
{
    const Chain *const chain = &scene->chain;
    const Vec3 g = scene->weight.gravity;
    for (int i = 0; i < chain->n; ++i) {
        const double m = chain->mass[i], heavy = i + 1 < chain->n ? m : m - scene->weight.weightless;
        const Vec3 v = v3_load(kin->v, i), w = v3_load(kin->w, i);
        out->energy[IN_MOTION] += (m * v3_dot(v, v) + v3_dot(w, body_inertia_times(chain, kin, i, w))) / 2;
        out->energy[IN_HEIGHT] -= heavy * v3_dot(g, v3_load(kin->p, i));
        out->momentum = v3_axpy(out->momentum, m, v);
        out->weight = v3_axpy(out->weight, heavy, g);
    }
}

void balance_stock(const Scene *scene, Workspace *ws, const double *own, BalanceStock *out)
{
    const Moment m = {.scene = scene, .ws = ws, .friction = 1};
    memset(out, 0, sizeof *out);
    bodies_stock(scene, &ws->kin, out);
    const JointEnergy joints = bushing_kernels()->energy(&scene->chain, &ws->kin, 0, scene->chain.n + 1);
    out->energy[IN_JOINTS] = joints.elastic;
    out->energy[IN_BENDING] = joints.sliding;
    for (int r = 0; r < scene->n_rooms; ++r) {
        const Room *const room = &scene->room[r];
        if (room->present && room->kind->stock) room->kind->stock(room, &m, own, out);
        if (own) own += room->states;
    }
}

/* Rates are summed as one array of numbers. */
static const double ROUNDING = 1e-10; /* of the stored energy: differences below it are rounding */

enum { RATES = sizeof(BalanceRates) / sizeof(double), POWERS = BALANCE_WORKS + BALANCE_LOSSES };

typedef union RateList {
    BalanceRates by;
    double value[RATES];
} RateList;

/* State of the balances: sums since the beginning. */
typedef struct Entries {
    RateList sum;     /* J and N s */
    double numerical; /* J, taken out of the motion by the method (BA11) */
    double carried;   /* J, of segments that joined, less that of those that left */
} Entries;

struct Balance {
    double t;
    RateList now;            /* at t */
    Entries entries;         /* since the beginning */
    double turnover[POWERS]; /* J: the sizes of the sums of works and losses */
    double moving_most;      /* J, largest energy of motion */
    double tolerated;        /* J, of a motion with the tolerance's speed (N10): less counts as zero */
    double *past;            /* [motion_past] data of the last step for (BA11) */
    int opened;              /* 1: the steady window has begun */
    Entries at_window;       /* values at that time, with the stored energy, J */
    double stored_at_window;
    Vec3 weight; /* N, of the present simulated part */
    BalanceStock first, here;
    Vec3 carried_momentum;
    double *rates; /* [size] scratch of an evaluation */
    int size;
    hawser_balance out;
};

/* Stored energy and momentum at (t, y). */
static void stock_at(Balance *b, Motion *motion, double t, const double *y, BalanceStock *out)
{
    motion->ops->rates(motion, t, y, b->rates);
    motion->ops->stock(motion, t, y, out);
}

/* Makes room for the rates of a motion and for the data of its steps; 0 if there is no memory. */
static int room_renew(Balance *b, const Motion *motion)
{
    if (motion->size <= b->size) return 1;
    free(b->rates);
    free(b->past);
    b->rates = aligned_array_new(motion->size);
    b->past = aligned_array_new(motion_past(motion));
    b->size = b->rates && b->past ? motion->size : 0;
    return b->size > 0;
}

/* Begins the steps of (BA11), or begins them again: y, whose rates were evaluated last. */
static void past_begin(Balance *b, const Motion *motion, const double *y)
{
    const Chain *const chain = &motion->scene->chain;
    const double speed = scales_tolerances(motion->scene).velocity;
    double mass = 0;
    memset(b->past, 0, (size_t)motion_past(motion) * sizeof *b->past);
    b->moving_most = fmax(b->moving_most, motion->ops->method_loss(motion, y, b->rates, 1, b->past).moving);
    for (int i = 0; i < chain->n; ++i) mass += chain->mass[i];
    b->tolerated = fmax(b->tolerated, mass * speed * speed / 2);
}

/* Balances without entries; NULL if there is no memory. */
static Balance *balance_empty(const Motion *motion)
{
    Balance *const b = calloc(1, sizeof *b);
    return b && room_renew(b, motion) ? b : balance_free(b);
}

hawser_status balance_new(Motion *motion, double t, const double *y, Balance **out, hawser_error *err)
{
    Balance *const b = *out = balance_empty(motion);
    if (!b) return error_memory(err);
    b->t = t;
    stock_at(b, motion, t, y, &b->first);
    b->weight = b->first.weight;
    past_begin(b, motion, y);
    motion->ops->work(motion, t, y, &b->now.by);
    b->now.by.push[PUSH_WEIGHT] = b->weight;
    return HAWSER_OK;
}

Balance *balance_free(Balance *b)
{
    if (b) {
        free(b->rates);
        free(b->past);
    }
    free(b);
    return NULL;
}

static double energy_of(const BalanceStock *stock)
{
    double sum = 0;
    for (int k = 0; k < BALANCE_STORES; ++k) sum += stock->energy[k];
    return sum;
}

/* Begins the steady window at (t, y). */
static void window_open(Balance *b, Motion *motion, double t, const double *y)
{
    if (b->opened || t < motion->scene->def.output.steady_from) return;
    b->opened = 1;
    stock_at(b, motion, t, y, &b->here);
    b->at_window = b->entries;
    b->stored_at_window = energy_of(&b->here) - b->here.energy[IN_BENDING];
}

/* (BA9): the trapezoidal rule over the accepted steps; and the loss by the method in this one (BA11). */
void balance_step(Balance *b, Motion *motion, double t, const double *y, const double *rates, double h)
{
    RateList next;
    const double half = (t - b->t) / 2;
    motion->ops->work(motion, t, y, &next.by);
    next.by.push[PUSH_WEIGHT] = b->weight;
    for (int k = 0; k < RATES; ++k) b->entries.sum.value[k] += half * (b->now.value[k] + next.value[k]);
    for (int k = 0; k < POWERS; ++k) b->turnover[k] += half * fabs(b->now.value[k] + next.value[k]);
    b->now = next;
    b->t = t;
    if (h > 0) {
        const MethodLoss loss = motion->ops->method_loss(motion, y, rates, 1 / h, b->past);
        b->entries.numerical += loss.lost;
        b->moving_most = fmax(b->moving_most, loss.moving);
    }
    window_open(b, motion, t, y);
}

void balance_leave(Balance *b, Motion *motion, double t, const double *y) { stock_at(b, motion, t, y, &b->here); }

hawser_status balance_enter(Balance *b, Motion *motion, double t, const double *y, hawser_error *err)
{
    BalanceStock after;
    if (!room_renew(b, motion)) return error_memory(err);
    stock_at(b, motion, t, y, &after);
    b->t = t; /* between leaving and entering nothing is added */
    b->entries.carried += energy_of(&after) - energy_of(&b->here);
    b->carried_momentum = v3_add(b->carried_momentum, v3_sub(after.momentum, b->here.momentum));
    b->weight = after.weight;
    past_begin(b, motion, y);
    motion->ops->work(motion, t, y, &b->now.by);
    b->now.by.push[PUSH_WEIGHT] = b->weight;
    return HAWSER_OK;
}

/* (QS13); the forces of a position add up to zero, so that momentum is carried as a whole. */
hawser_status balance_position(Balance *b, Motion *motion, double t, const double *y, hawser_error *err)
{
    RateList next;
    BalanceStock after;
    const double half = (t - b->t) / 2;
    if (!room_renew(b, motion)) return error_memory(err);
    stock_at(b, motion, t, y, &after);
    motion->ops->work(motion, t, y, &next.by);
    next.by.push[PUSH_WEIGHT] = b->weight = after.weight;
    for (int k = 0; k < POWERS; ++k) {
        b->entries.sum.value[k] += half * (b->now.value[k] + next.value[k]);
        b->turnover[k] += half * fabs(b->now.value[k] + next.value[k]);
    }
    b->carried_momentum = v3_add(b->carried_momentum, v3_sub(after.momentum, b->here.momentum));
    b->here = after;
    b->now = next;
    b->t = t;
    window_open(b, motion, t, y);
    return HAWSER_OK;
}

void balance_carry(Balance *b, double energy) { b->entries.carried += energy; }

/* ------------------------------------------------------------------------------------------------- the account */

static const char *const WORKS[BALANCE_WORKS] = {"winch", "tail",   "lead_in", "reel",          "conveyors", "ends",
                                                 "loads", "motors", "medium",  "surface_edges", "outside"};

static const char *const LOSSES[BALANCE_LOSSES] = {
    "joint_damping",  "bending_hysteresis", "rope_drag",       "conveyor_slip",  "roller_friction",
    "roller_damping", "surface_friction",   "surface_damping", "cable_friction", "cable_damping",
    "bearings",       "mount_damping",      "medium_drag"};

static const char *const STORES[BALANCE_STORES] = {"motion",  "height",   "joints",         "bending",
                                                   "rollers", "surfaces", "cable_on_cable", "equipment"};

static const char *const PUSHES[BALANCE_PUSHES] = {"winch",   "tail",  "lead_in", "reel",     "conveyors",
                                                   "ends",    "loads", "",        "medium",   "",
                                                   "outside", "drag",  "rollers", "surfaces", "weight"};

/* Adds a term if it is present; the residual is measured by the largest turnover, or by the motion. */
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

/* Works less losses. */
static double entries_gain(const Entries *e)
{
    double gain = 0;
    for (int k = 0; k < BALANCE_WORKS; ++k) gain += e->sum.by.work[k];
    for (int k = 0; k < BALANCE_LOSSES; ++k) gain -= e->sum.by.loss[k];
    return gain - e->numerical;
}

/* (BA1), (BA12) */
static void energy_close(Balance *b, hawser_balance *out)
{
    const Entries *const e = &b->entries;
    const double slid = b->here.energy[IN_BENDING] - b->first.energy[IN_BENDING];
    double held = 0;
    for (int k = 0; k < BALANCE_WORKS; ++k) {
        out->work_J += e->sum.by.work[k];
        term_add(out, HAWSER_BALANCE_WORK, WORKS[k], e->sum.by.work[k], b->turnover[k]);
    }
    for (int k = 0; k < BALANCE_LOSSES; ++k) {
        const double lost = e->sum.by.loss[k] - (k == LOST_BENDING ? slid : 0);
        out->lost_J += lost;
        term_add(out, HAWSER_BALANCE_LOSS, LOSSES[k], lost, b->turnover[BALANCE_WORKS + k]);
    }
    for (int k = 0; k < BALANCE_STORES; ++k) {
        const double change = b->here.energy[k] - b->first.energy[k];
        out->stored_J += change;
        held = fmax(held, fabs(b->here.energy[k]));
        const int any = fabs(b->here.energy[k]) > 0 || fabs(change) > 0;
        if (any) out->term[out->n_terms++] = (hawser_balance_term){HAWSER_BALANCE_STORED, STORES[k], change, {0, 0, 0}};
        if (!(e->carried > 0) && !(e->carried < 0) && fabs(change) > out->turnover_J) { /* carried energy: nothing moved
                                                                                         * it */
            out->turnover_J = fabs(change);
            out->turnover_of = STORES[k];
        }
    }
    const double least = fmax(b->tolerated, ROUNDING * held); /* below it nothing moves */
    if (fmax(b->moving_most, least) > out->turnover_J) {
        out->turnover_J = fmax(b->moving_most, least);
        out->turnover_of = b->moving_most > least ? STORES[IN_MOTION] : "tolerance";
    }
    out->carried_J = e->carried;
    out->residual_J = out->stored_J - e->carried - (out->work_J - out->lost_J);
    if (fabs(out->residual_J + e->numerical) < fabs(out->residual_J)) { /* (BA14) */
        out->numerical_J = e->numerical;
        out->residual_J += e->numerical;
    }
    out->residual_share = out->turnover_J > 0 ? fabs(out->residual_J) / out->turnover_J : 0;
    out->numerical_share = out->turnover_J > 0 ? fabs(out->numerical_J) / out->turnover_J : 0;
}

BalanceWindow balance_window(const Balance *b)
{
    const Entries *const from = &b->at_window, *const to = &b->entries;
    if (!b->opened) return (BalanceWindow){0};
    /* the energy of sliders is among the losses here */
    const double stored = energy_of(&b->here) - b->here.energy[IN_BENDING] - b->stored_at_window;
    return (BalanceWindow){.winch = to->sum.by.work[BY_WINCH] - from->sum.by.work[BY_WINCH],
                           .numerical = to->numerical - from->numerical,
                           .residual =
                               stored - (to->carried - from->carried) - (entries_gain(to) - entries_gain(from))};
}

/* (BA2) */
static void momentum_close(Balance *b, hawser_balance *out)
{
    Vec3 sum = {0, 0, 0};
    double largest = 0;
    for (int k = 0; k < BALANCE_PUSHES; ++k) {
        const Vec3 impulse = b->entries.sum.by.push[k];
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
    return balance_left(b);
}

const hawser_balance *balance_left(Balance *b)
{
    b->out = (hawser_balance){.turnover_of = ""};
    energy_close(b, &b->out);
    momentum_close(b, &b->out);
    return &b->out;
}

void balance_checkpoint(Checkpoint *c, Balance **books, const Motion *motion)
{
    if (c->reading && !*books) *books = balance_empty(motion);
    Balance *const b = *books;
    if (!b || !room_renew(b, motion)) {
        checkpoint_lack(c);
        return;
    }
    CHECKPOINT_UP_TO(c, b, Balance, past);
    checkpoint_put(c, "b->past", b->past, (size_t)motion_past(motion) * sizeof *b->past);
    CHECKPOINT(c, b->opened);
    CHECKPOINT(c, b->at_window);
    CHECKPOINT(c, b->stored_at_window);
    CHECKPOINT(c, b->weight);
    CHECKPOINT(c, b->first);
    CHECKPOINT(c, b->here);
    CHECKPOINT(c, b->carried_momentum);
}
