/* A bunch as the integrator sees it. A bunch that is not coupled leaves everything to its chains' own equations; the
 * norm is the largest of theirs, so that each is computed as well as if it were alone. */
#include <string.h>

#include "core/base/worst.h"
#include "sim/bunch/bunch.h"
#include "sim/dynamics.h"
#include "sim/newton/newton_extra.h"
#include "sim/step/vector_kernels.h"

static Bunch *bunch_of(const Motion *m) { return (Bunch *)(uintptr_t)m; }

/* Chain c of the bunch of m, one after the other. */
#define EACH_CHAIN(c, b) for (const BunchChain *c = (b)->chain; c < (b)->chain + (b)->n; ++c)

/* -------------------------------------------------------------------------------------------------------- rates */

void bunch_rates(Bunch *b, double t, const double *y, double friction, double *ydot)
{
    memset(ydot, 0, (size_t)b->motion.size * sizeof *ydot); /* what lies between the chains' states stays zero */
    EACH_CHAIN(c, b) dynamics_pose(c->scene, c->ws, t, y + c->at, friction);
    EACH_CHAIN(c, b) dynamics_loads(c->scene, c->ws, t, friction);
    bunch_interact(b, friction);
    EACH_CHAIN(c, b) dynamics_motion(c->scene, c->ws, t, y + c->at, friction, ydot + c->at);
}

static int rates(Motion *m, double t, const double *y, double *ydot)
{
    Bunch *const b = bunch_of(m);
    if (b->coupled) {
        bunch_rates(b, t, y, 1, ydot);
        return !vector_kernels()->all_finite(m->size, ydot);
    }
    int bad = 0;
    memset(ydot, 0, (size_t)m->size * sizeof *ydot);
    EACH_CHAIN(c, b) bad |= c->motion->ops->rates(c->motion, t, y + c->at, ydot + c->at);
    return bad;
}

/* -------------------------------------------------------------------------------------------------------- matrix */

void bunch_linearise(Bunch *b, double t, const double *y, const double *ydot, double friction)
{
    EACH_CHAIN(c, b)
    {
        Newton *const part = &b->part[c - b->chain];
        dynamics_blocks(c->scene, c->ws, t, y + c->at, ydot + c->at, friction, &part->k, &part->d);
        newton_point(part, c->scene, &c->ws->kin, y + c->at);
    }
    bunch_blocks(b, friction);
}

void bunch_form(Bunch *b, double gamma)
{
    for (int k = 0; k < b->n; ++k) newton_form(&b->part[k], gamma);
    b->whole.gamma = gamma;
    newton_extra_form(&b->whole);
}

int bunch_factor(Bunch *b) { return newton_factor(&b->whole); }

int bunch_solve(Bunch *b, double *rhs)
{
    EACH_CHAIN(c, b) newton_reduce(&b->part[c - b->chain], rhs + c->at);
    newton_extra_couple(&b->whole);
    const int status = linsolver_solve(b->whole.solver, b->whole.x);
    if (status) return status;
    EACH_CHAIN(c, b) newton_expand(&b->part[c - b->chain], rhs + c->at);
    return 0;
}

static void linearise(Motion *m, double t, const double *y, const double *ydot)
{
    Bunch *const b = bunch_of(m);
    if (b->coupled) {
        bunch_linearise(b, t, y, ydot, 1);
        return;
    }
    EACH_CHAIN(c, b) c->motion->ops->linearise(c->motion, t, y + c->at, ydot + c->at);
}

static void form(Motion *m, double gamma)
{
    Bunch *const b = bunch_of(m);
    if (b->coupled) {
        bunch_form(b, gamma);
        return;
    }
    EACH_CHAIN(c, b) c->motion->ops->form(c->motion, gamma);
}

static int factor(Motion *m)
{
    Bunch *const b = bunch_of(m);
    if (b->coupled) return bunch_factor(b);
    int status = 0;
    EACH_CHAIN(c, b) status = status ? status : c->motion->ops->factor(c->motion);
    return status;
}

static int solve(Motion *m, double *rhs)
{
    Bunch *const b = bunch_of(m);
    if (b->coupled) return bunch_solve(b, rhs);
    int status = 0;
    EACH_CHAIN(c, b) status = status ? status : c->motion->ops->solve(c->motion, rhs + c->at);
    return status;
}

/* ------------------------------------------------------------------------------------------------ what is measured */

static void weights(const Motion *m, double *weight)
{
    const Bunch *const b = bunch_of(m);
    for (int i = 0; i < m->size; ++i) weight[i] = 1;
    EACH_CHAIN(c, b) c->motion->ops->weights(c->motion, weight + c->at);
}

static double norm(const Motion *m, const double *x, const double *w)
{
    const Bunch *const b = bunch_of(m);
    double largest = 0;
    EACH_CHAIN(c, b) largest = larger_of(largest, c->motion->ops->norm(c->motion, x + c->at, w + c->at));
    return largest;
}

static double speed(const Motion *m, const double *y)
{
    const Bunch *const b = bunch_of(m);
    double largest = 0;
    EACH_CHAIN(c, b) largest = larger_of(largest, c->motion->ops->speed(c->motion, y + c->at));
    return largest;
}

static void project(const Motion *m, const double *y, double *correction, double *error)
{
    const Bunch *const b = bunch_of(m);
    memset(correction, 0, (size_t)m->size * sizeof *correction);
    EACH_CHAIN(c, b)
    c->motion->ops->project(c->motion, y + c->at, correction + c->at, error ? error + c->at : NULL);
}

/* The worst segment of the chain whose norm is largest, as its row. */
static int worst(const Motion *m, const double *error, const double *weight)
{
    const Bunch *const b = bunch_of(m);
    double largest = -1;
    int row = 0;
    EACH_CHAIN(c, b)
    {
        const double own = c->motion->ops->norm(c->motion, error + c->at, weight + c->at);
        if (!(own > largest) && !isnan(own)) continue;
        largest = own;
        row = c->row + c->motion->ops->worst(c->motion, error + c->at, weight + c->at);
        if (isnan(own)) break;
    }
    return row;
}

static const Scene *whose(const Motion *m, int *segment)
{
    const Bunch *const b = bunch_of(m);
    return b->chain[bunch_chain_of(b, *segment, segment)].scene;
}

static Vec3 place(const Motion *m, const double *y, int row)
{
    const Bunch *const b = bunch_of(m);
    int segment;
    const BunchChain *const c = &b->chain[bunch_chain_of(b, row, &segment)];
    return c->motion->ops->place(c->motion, y + c->at, segment);
}

/* ----------------------------------------------------------------------------------------------- between steps */

static hawser_status accept(Motion *m, double t, const double *y, hawser_error *err)
{
    Bunch *const b = bunch_of(m);
    hawser_status status = HAWSER_OK;
    EACH_CHAIN(c, b) status = status ? status : c->motion->ops->accept(c->motion, t, y + c->at, err);
    return status || !b->coupled ? status : bunch_candidates(b, 0, err);
}

static hawser_status renew(Motion *m, double t, const double *y, hawser_error *err)
{
    Bunch *const b = bunch_of(m);
    hawser_status status = HAWSER_OK;
    EACH_CHAIN(c, b) status = status ? status : c->motion->ops->renew(c->motion, t, y + c->at, err);
    return status || !b->coupled ? status : bunch_candidates(b, 1, err);
}

static int look(Motion *m, double t, const double *y, int on_chain)
{
    Bunch *const b = bunch_of(m);
    int active = 0;
    EACH_CHAIN(c, b) active += c->motion->ops->look(c->motion, t, y + c->at, on_chain);
    return active;
}

static void glance(Motion *m)
{
    const Bunch *const b = bunch_of(m);
    EACH_CHAIN(c, b) c->motion->ops->glance(c->motion);
}

static double winch_pull(Motion *m, double t, const double *y)
{
    const Bunch *const b = bunch_of(m);
    double sum = 0;
    EACH_CHAIN(c, b) sum += c->motion->ops->winch_pull(c->motion, t, y + c->at);
    return sum;
}

/* --------------------------------------------------------------------------------------------------- the books */

static void add(double *sum, const double *more, int n)
{
    for (int i = 0; i < n; ++i) sum[i] += more[i];
}

/* *out, a run of numbers of the type Type, becomes the sum of what the chains' own operation op says. */
#define CHAINS_ADDED(b, op, t, y, Type, out)                                                                           \
    do {                                                                                                               \
        memset(out, 0, sizeof *(out));                                                                                 \
        EACH_CHAIN(c, b)                                                                                               \
        {                                                                                                              \
            Type own;                                                                                                  \
            c->motion->ops->op(c->motion, t, (y) + c->at, &own);                                                       \
            add((double *)(out), (const double *)&own, (int)(sizeof own / sizeof(double)));                            \
        }                                                                                                              \
    } while (0)

static void work(Motion *m, double t, const double *y, BalanceRates *out)
{
    Bunch *const b = bunch_of(m);
    CHAINS_ADDED(b, work, t, y, BalanceRates, out);
    out->loss[LOST_JOINTS] += b->links_lost;
    for (int p = 0; p < SELF_PARTS && b->contact.present; ++p) {
        out->loss[LOST_CABLE] += b->pairs.work[p].friction;
        out->loss[LOST_CABLE_DAMPING] += b->pairs.work[p].damping;
    }
}

static void stock(Motion *m, double t, const double *y, BalanceStock *out)
{
    Bunch *const b = bunch_of(m);
    CHAINS_ADDED(b, stock, t, y, BalanceStock, out);
    for (int p = 0; p < SELF_PARTS && b->contact.present; ++p) out->energy[IN_CABLE] += b->pairs.work[p].energy;
    for (int i = 0; i < b->n_links; ++i) {
        const LinkNow now = link_now(&b->link[i], b->line);
        out->energy[IN_JOINTS] += link_energy(&b->link[i], &now);
    }
}

static MethodLoss method_loss(const Motion *m, const double *y, const double *ydot, double scale, double *past)
{
    const Bunch *const b = bunch_of(m);
    MethodLoss sum = {0};
    EACH_CHAIN(c, b)
    {
        const MethodLoss own = c->motion->ops->method_loss(c->motion, y + c->at, ydot + c->at, scale, past + 2 * c->at);
        sum.lost += own.lost;
        sum.moving += own.moving;
    }
    return sum;
}

/* ------------------------------------------------------------------------------------------------------ the rest */

/* Chains that do nothing to each other come to rest one by one. */
static hawser_status relax(Motion *m, double t, double *y, hawser_relaxation *out, hawser_error *err)
{
    Bunch *const b = bunch_of(m);
    if (b->coupled) return bunch_relax(b, t, y, out, err);
    hawser_status status = HAWSER_OK;
    *out = (hawser_relaxation){.reached = 1};
    EACH_CHAIN(c, b)
    {
        hawser_relaxation own = {0};
        if (!status) status = c->motion->ops->relax(c->motion, t, y + c->at, &own, err);
        out->iterations += own.iterations;
        out->reached &= own.reached;
        out->tolerance_N = fmax(out->tolerance_N, own.tolerance_N);
        out->moved_m = fmax(out->moved_m, own.moved_m);
        if (own.residual_N >= out->residual_N) out->segment = own.segment;
        out->residual_N = fmax(out->residual_N, own.residual_N);
    }
    return status;
}

static void copy(const Motion *m, const double *from, double *to) { memcpy(to, from, (size_t)m->size * sizeof *to); }
static void pack(Motion *m, const double *full, double *y) { copy(m, full, y); }
static void unpack(const Motion *m, const double *y, double *full) { copy(m, y, full); }

static void lin_stats(const Motion *m, LinStats *stats)
{
    const Bunch *const b = bunch_of(m);
    if (b->coupled) {
        newton_stats(&b->whole, stats);
    } else {
        b->chain[0].motion->ops->lin_stats(b->chain[0].motion, stats);
    }
}

/* Of a coupled bunch what is between the chains, and the matrix of all; else each chain's own. */
static void checkpoint(Checkpoint *c, Motion *m)
{
    Bunch *const b = bunch_of(m);
    if (!b->coupled) {
        EACH_CHAIN(each, b) each->motion->ops->checkpoint(c, each->motion);
        return;
    }
    const SelfLines lines = bunch_lines(b);
    self_pairs_checkpoint(c, &lines, &b->pairs);
    CHECKPOINT(c, b->refreshes);
    checkpoint_longs(c, 1, &b->refreshes);
    newton_checkpoint(c, &b->whole, NULL);
    for (int k = 0; k < b->n; ++k) b->part[k].gamma = b->whole.gamma;
}

const MotionOps *bunch_ops(void)
{
    static const MotionOps ops = {.rates = rates,
                                  .linearise = linearise,
                                  .form = form,
                                  .factor = factor,
                                  .solve = solve,
                                  .weights = weights,
                                  .norm = norm,
                                  .speed = speed,
                                  .project = project,
                                  .accept = accept,
                                  .renew = renew,
                                  .worst = worst,
                                  .whose = whose,
                                  .place = place,
                                  .look = look,
                                  .glance = glance,
                                  .winch_pull = winch_pull,
                                  .work = work,
                                  .method_loss = method_loss,
                                  .stock = stock,
                                  .relax = relax,
                                  .pack = pack,
                                  .unpack = unpack,
                                  .checkpoint = checkpoint,
                                  .lin_stats = lin_stats};
    return &ops;
}
