/* Column by column: move one coordinate of one segment both ways, take all forces, divide. Everything that
 * the analytic derivatives could have forgotten is in here by construction. */
#include "contact/law/forces_fd.h"

/* The 12 coordinates of a segment: shifts, turns, velocities, angular velocities, three each. */
enum { SHIFT, TURN, SPEED, SPIN };

/* Turns the axis of segment i about a world axis by `angle`, exactly. */
static void axis_turn(Kinematics *kin, int i, int axis, double angle)
{
    const Vec3 about = v3(axis == 0, axis == 1, axis == 2);
    const Vec3 a = v3_load(kin->a, i);
    const Vec3 turned = quat_rotate(quat_exp(v3_scale(angle, about)), a);
    kin->a[0][i] = turned.x;
    kin->a[1][i] = turned.y;
    kin->a[2][i] = turned.z;
}

/* The generalized forces with coordinate `axis` of kind `kind` of segment i moved by `by`. */
static void forces_moved(ForcesOf forces, void *arg, const Chain *chain, Kinematics *kin, int i, int kind, int axis,
                         double by, Loads *loads)
{
    double **const vector[4] = {kin->p, kin->a, kin->v, kin->w};
    const double old[3] = {vector[kind][0][i], vector[kind][1][i], vector[kind][2][i]};
    if (kind == TURN) {
        axis_turn(kin, i, axis, by);
    } else {
        vector[kind][axis][i] += by;
    }
    loads_zero(loads, chain->n);
    forces(arg, kin, loads);
    for (int c = 0; c < 3; ++c) vector[kind][c][i] = old[c];
}

/* The block of row `row` and column `col`, NULL off the three diagonals. */
static double *block_at(BlockChain *a, int row, int col)
{
    if (row == col) return a->diag + 36 * row;
    if (row == col + 1) return a->lower + 36 * row;
    if (row == col - 1) return a->upper + 36 * row;
    return 0;
}

/* Adds the difference of two loads over 2 * by as one column; returns the largest entry that has no block. */
static double column_add(const Loads *plus, const Loads *minus, int n, double by, int segment, int column,
                         BlockChain *out)
{
    double stray = 0;
    for (int row = 0; row < n; ++row) {
        double *const block = block_at(out, row, segment);
        for (int c = 0; c < 6; ++c) {
            double *const *const p = c < 3 ? plus->f : plus->m;
            double *const *const m = c < 3 ? minus->f : minus->m;
            const double slope = (p[c % 3][row] - m[c % 3][row]) / (2 * by);
            if (block) {
                block[6 * column + c] += slope;
            } else {
                stray = fmax(stray, fabs(slope));
            }
        }
    }
    return stray;
}

double forces_fd(ForcesOf forces, void *arg, const Chain *chain, Kinematics *kin, double step, double speed_step,
                 BlockChain *k, BlockChain *d)
{
    Loads plus, minus;
    if (!loads_alloc(&plus, chain->n)) return -1;
    if (!loads_alloc(&minus, chain->n)) {
        loads_free(&plus);
        return -1;
    }
    double stray = 0;
    for (int column = 0; column < 12 * chain->n; ++column) {
        const int i = column / 12, kind = column % 12 / 3, axis = column % 3;
        const double by = kind < SPEED ? step : speed_step;
        forces_moved(forces, arg, chain, kin, i, kind, axis, by, &plus);
        forces_moved(forces, arg, chain, kin, i, kind, axis, -by, &minus);
        BlockChain *const out = kind < SPEED ? k : d;
        stray = fmax(stray, column_add(&plus, &minus, chain->n, by, i, column % 6, out));
    }
    loads_free(&plus);
    loads_free(&minus);
    return stray;
}
