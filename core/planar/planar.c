#include "core/planar/planar.h"

#include "core/base/lanes.h"

ISA_KERNELS(PlanarKernels, planar_kernels)

int planar_stride(int n) { return (n + LANES - 1) / LANES * LANES; }

/* ---------------------------------------------------------------------------------------------------- memory */

int planar_chain_alloc(PlanarChain *chain, int n)
{
    *chain = (PlanarChain){.n = n, .stride = planar_stride(n), .share = 0.5};
    int ok = chain_arrays_new(&chain->half, 1, n, 0) & chain_arrays_new(&chain->radius, 1, n, 0);
    ok &= chain_arrays_new(&chain->mass, 1, n, 0) & chain_arrays_new(&chain->inertia, 1, n, 0);
    ok &= chain_arrays_new(&chain->inverse_mass, 1, n, 0) & chain_arrays_new(&chain->inverse_inertia, 1, n, 0);
    ok &= chain_arrays_new(chain->stiffness, 3, n, 0) & chain_arrays_new(chain->damping, 3, n, 0);
    ok &= chain_arrays_new(chain->preload, 3, n, 0);
    if (!ok) planar_chain_free(chain);
    return ok;
}

void planar_chain_free(PlanarChain *chain)
{
    double **const single[] = {&chain->half,    &chain->radius,       &chain->mass,
                               &chain->inertia, &chain->inverse_mass, &chain->inverse_inertia};
    for (size_t k = 0; k < sizeof single / sizeof *single; ++k) chain_arrays_free(single[k], 1);
    chain_arrays_free(chain->stiffness, 3);
    chain_arrays_free(chain->damping, 3);
    chain_arrays_free(chain->preload, 3);
}

int planar_kinematics_alloc(PlanarKinematics *kin, int n)
{
    int ok = chain_arrays_new(kin->p, 2, n, 0) & chain_arrays_new(&kin->angle, 1, n, 0);
    ok &= chain_arrays_new(&kin->h[0], 1, n, 1) & chain_arrays_new(&kin->h[1], 1, n, 0);
    ok &= chain_arrays_new(&kin->a[0], 1, n, 1) & chain_arrays_new(&kin->a[1], 1, n, 0);
    ok &= chain_arrays_new(kin->v, 2, n, 0) & chain_arrays_new(&kin->w, 1, n, 0);
    if (!ok) planar_kinematics_free(kin);
    return ok;
}

void planar_kinematics_free(PlanarKinematics *kin)
{
    chain_arrays_free(kin->p, 2);
    chain_arrays_free(&kin->angle, 1);
    chain_arrays_free(kin->h, 2);
    chain_arrays_free(kin->a, 2);
    chain_arrays_free(kin->v, 2);
    chain_arrays_free(&kin->w, 1);
}

int planar_loads_alloc(PlanarLoads *loads, int n)
{
    const int ok = chain_arrays_new(loads->f, 2, n, 0) & chain_arrays_new(&loads->m, 1, n, 0);
    if (!ok) planar_loads_free(loads);
    return ok;
}

void planar_loads_free(PlanarLoads *loads)
{
    chain_arrays_free(loads->f, 2);
    chain_arrays_free(&loads->m, 1);
}

int planar_joint_loads_alloc(PlanarJointLoads *loads, int n)
{
    const int ok = chain_arrays_new(loads->force, 2, n, 0) & chain_arrays_new(&loads->torque_a, 1, n, 0) &
                   chain_arrays_new(&loads->torque_b, 1, n, 0);
    if (!ok) planar_joint_loads_free(loads);
    return ok;
}

void planar_joint_loads_free(PlanarJointLoads *loads)
{
    chain_arrays_free(loads->force, 2);
    chain_arrays_free(&loads->torque_a, 1);
    chain_arrays_free(&loads->torque_b, 1);
}

int planar_blocks_alloc(PlanarBlocks *blocks, int n)
{
    const int ok = chain_arrays_new(blocks->lower, 9, n, 0) & chain_arrays_new(blocks->diag, 9, n, 0) &
                   chain_arrays_new(blocks->upper, 9, n, 0) & chain_arrays_new(blocks->front, 9, n, 0);
    if (!ok) planar_blocks_free(blocks);
    return ok;
}

void planar_blocks_free(PlanarBlocks *blocks)
{
    chain_arrays_free(blocks->lower, 9);
    chain_arrays_free(blocks->diag, 9);
    chain_arrays_free(blocks->upper, 9);
    chain_arrays_free(blocks->front, 9);
}

/* ------------------------------------------------------------------------------------------------- mechanics */

void planar_kinematics(const PlanarChain *chain, const double *y, int from, int to, PlanarKinematics *kin)
{
    kernels()->kinematics(chain, y, from, to, kin);
}

double planar_joint_loads(const PlanarChain *chain, const PlanarKinematics *kin, int from, int to,
                          PlanarJointLoads *loads)
{
    return kernels()->joint_loads(chain, kin, from, to, loads);
}

void planar_tension(const PlanarChain *chain, const PlanarKinematics *kin, int from, int to, double *tension)
{
    kernels()->tension(chain, kin, from, to, tension);
}

int planar_rates(const PlanarChain *chain, const PlanarKinematics *kin, const PlanarJointLoads *joints,
                 const PlanarLoads loads[2], int from, int to, double *ydot)
{
    return kernels()->rates(chain, kin, joints, loads, from, to, ydot);
}

void planar_joint_blocks(const PlanarChain *chain, const PlanarKinematics *kin, int from, int to, PlanarBlocks *k,
                         PlanarBlocks *d)
{
    kernels()->joint_blocks(chain, kin, from, to, k, d);
}

void planar_blocks_join(PlanarBlocks *blocks, int from, int to) { kernels()->blocks_join(blocks, from, to); }

void planar_blocks_trim(PlanarBlocks *blocks, int n)
{
    for (int e = 0; e < 9; ++e) {
        blocks->lower[e][0] = blocks->lower[e][n] = 0;
        blocks->upper[e][-1] = blocks->upper[e][n - 1] = 0;
    }
}
