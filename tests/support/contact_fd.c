/* Column by column: move one coordinate of one segment both ways, take all forces, divide. */
#include "tests/support/contact_fd.h"

/* The 12 coordinates of a segment: shifts, turns, velocities, angular velocities, three each. */
enum { SHIFT, TURN, SPEED, SPIN };

/* A call of one kind of forces: they are added to loads, which are zero. */
typedef struct Call {
    void (*forces)(const struct Call *call, const Kinematics *kin, Loads *loads);
    const void *model;
    const Chain *chain;
    double friction_scale;
    void *pairs;
    double step, speed_step;
    /* where the derivatives go: blocks, or dense columns */
    BlockChain *blocks[2];
    double *dense[2];
    double stray; /* the largest entry that has no block */
} Call;

/* The generalized forces with coordinate `axis` of kind `kind` of segment i moved by `by`. */
static void forces_moved(const Call *call, Kinematics *kin, int i, int kind, int axis, double by, Loads *loads)
{
    double **const vector[4] = {kin->p, kin->a, kin->v, kin->w};
    const Vec3 old = v3_load(vector[kind], i), unit = v3_axis(axis);
    v3_store(vector[kind], i, kind == TURN ? quat_rotate(quat_exp(v3_scale(by, unit)), old) : v3_axpy(old, by, unit));
    loads_zero(loads, call->chain->n);
    call->forces(call, kin, loads);
    v3_store(vector[kind], i, old);
}

/* The block of row `row` and column `col`, NULL off the three diagonals. */
static double *block_at(BlockChain *a, int row, int col)
{
    if (row == col) return a->diag + 36 * row;
    if (row == col + 1) return a->lower + 36 * row;
    if (row == col - 1) return a->upper + 36 * row;
    return NULL;
}

/* Puts the difference of two loads over 2 by where column c of the kind's matrix is kept. */
static void column_put(Call *call, const Loads *plus, const Loads *minus, double by, int speeds, int c)
{
    const int n = call->chain->n;
    for (int row = 0; row < 6 * n; ++row) {
        double *const *const p = row % 6 < 3 ? plus->f : plus->m, *const *const m = row % 6 < 3 ? minus->f : minus->m;
        const double slope = (p[row % 3][row / 6] - m[row % 3][row / 6]) / (2 * by);
        double *const block = call->dense[0] ? NULL : block_at(call->blocks[speeds], row / 6, c / 6);
        if (call->dense[0]) {
            call->dense[speeds][(size_t)c * (size_t)(6 * n) + (size_t)row] = slope;
        } else if (block) {
            block[6 * (c % 6) + row % 6] += slope;
        } else {
            call->stray = fmax(call->stray, fabs(slope));
        }
    }
}

/* All columns; 0 if there is no memory. */
static int differences(Call *call, Kinematics *kin)
{
    const int n = call->chain->n;
    Loads plus = {0}, minus = {0};
    const int ok = chain_struct_alloc(&plus, n) && chain_struct_alloc(&minus, n);
    for (int column = 0; ok && column < 12 * n; ++column) {
        const int i = column / 12, kind = column % 12 / 3, axis = column % 3;
        const double by = kind < SPEED ? call->step : call->speed_step;
        forces_moved(call, kin, i, kind, axis, by, &plus);
        forces_moved(call, kin, i, kind, axis, -by, &minus);
        column_put(call, &plus, &minus, by, kind >= SPEED, 6 * i + column % 6);
    }
    chain_struct_free(&plus);
    chain_struct_free(&minus);
    return ok;
}

static void roller_forces(const Call *call, const Kinematics *kin, Loads *loads)
{
    contact_forces(call->model, call->chain, kin, call->friction_scale, call->pairs, loads, NULL, NULL);
}

double contact_blocks_fd(const ContactModel *model, const Chain *chain, Kinematics *kin, double friction_scale,
                         ContactPairs *pairs, double step, double speed_step, BlockChain *k, BlockChain *d)
{
    Call call = {roller_forces, model, chain, friction_scale, pairs, step, speed_step, .blocks = {k, d}};
    return differences(&call, kin) ? call.stray : -1;
}

static void surfaces_forces(const Call *call, const Kinematics *kin, Loads *loads)
{
    surface_forces(call->model, call->chain, kin, call->friction_scale, call->pairs, loads, NULL);
}

double surface_blocks_fd(const SurfaceModel *model, const Chain *chain, Kinematics *kin, double friction_scale,
                         SurfacePairs *pairs, double step, double speed_step, BlockChain *k, BlockChain *d)
{
    Call call = {surfaces_forces, model, chain, friction_scale, pairs, step, speed_step, .blocks = {k, d}};
    return differences(&call, kin) ? call.stray : -1;
}

static void own_forces(const Call *call, const Kinematics *kin, Loads *loads)
{
    for (int part = 0; part < SELF_PARTS; ++part) {
        self_forces(call->model, SELF_ALONE(call->chain, kin), call->friction_scale, part, call->pairs, &loads);
    }
}

int self_blocks_fd(const SelfModel *model, const Chain *chain, Kinematics *kin, double friction_scale, SelfPairs *pairs,
                   double step, double speed_step, double *k, double *d)
{
    Call call = {own_forces, model, chain, friction_scale, pairs, step, speed_step, .dense = {k, d}};
    return differences(&call, kin);
}
