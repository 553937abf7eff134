/* Column by column, as in contact_fd.c: one coordinate both ways, all forces, divide. Dense, so that what couples
 * segments that the pattern does not hold would show. */
#include "contact/self/self_contact_fd.h"

enum { SHIFT, TURN, SPEED, SPIN };

/* All forces with coordinate `axis` of kind `kind` of segment i moved by `by`; kin is as before afterwards. */
static void forces_moved(const SelfModel *model, const Chain *chain, Kinematics *kin, double scale, SelfPairs *pairs,
                         int i, int kind, int axis, double by, Loads *loads)
{
    double **const vector[4] = {kin->p, kin->a, kin->v, kin->w};
    double **const at = vector[kind];
    const Vec3 old = v3_load(at, i), unit = v3_axis(axis);
    const Vec3 now = kind == TURN ? quat_rotate(quat_exp(v3_scale(by, unit)), old) : v3_axpy(old, by, unit);
    const double value[3] = {now.x, now.y, now.z}, before[3] = {old.x, old.y, old.z};
    for (int c = 0; c < 3; ++c) at[c][i] = value[c];
    loads_zero(loads, chain->n);
    for (int part = 0; part < SELF_PARTS; ++part) self_forces(model, chain, kin, scale, part, pairs, loads);
    for (int c = 0; c < 3; ++c) at[c][i] = before[c];
}

int self_blocks_fd(const SelfModel *model, const Chain *chain, Kinematics *kin, double friction_scale, SelfPairs *pairs,
                   double step, double speed_step, double *k, double *d)
{
    const int n = chain->n;
    Loads plus = {0}, minus = {0};
    const int ok = loads_alloc(&plus, n) && loads_alloc(&minus, n);
    for (int column = 0; ok && column < 12 * n; ++column) {
        const int i = column / 12, kind = column % 12 / 3, axis = column % 3;
        const double by = kind < SPEED ? step : speed_step;
        forces_moved(model, chain, kin, friction_scale, pairs, i, kind, axis, by, &plus);
        forces_moved(model, chain, kin, friction_scale, pairs, i, kind, axis, -by, &minus);
        double *const out = (kind < SPEED ? k : d) + (size_t)(6 * i + column % 6) * (size_t)(6 * n);
        for (int row = 0; row < 6 * n; ++row) {
            double *const *const p = row % 6 < 3 ? plus.f : plus.m;
            double *const *const m = row % 6 < 3 ? minus.f : minus.m;
            out[row] = (p[row % 3][row / 6] - m[row % 3][row / 6]) / (2 * by);
        }
    }
    loads_free(&plus);
    loads_free(&minus);
    return ok;
}
