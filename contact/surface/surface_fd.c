/* As contact_fd.c, for surfaces. */
#include "contact/surface/surface_fd.h"

#include "contact/law/forces_fd.h"

/* One call of surface_forces. */
typedef struct SurfaceCall {
    const SurfaceModel *model;
    const Chain *chain;
    double friction_scale;
    SurfacePairs *pairs;
} SurfaceCall;

static void forces_of(void *arg, const Kinematics *kin, Loads *loads)
{
    const SurfaceCall *const call = arg;
    surface_forces(call->model, call->chain, kin, call->friction_scale, call->pairs, loads, NULL);
}

double surface_blocks_fd(const SurfaceModel *model, const Chain *chain, Kinematics *kin, double friction_scale,
                         SurfacePairs *pairs, double step, double speed_step, BlockChain *k, BlockChain *d)
{
    SurfaceCall call = {model, chain, friction_scale, pairs};
    return forces_fd(forces_of, &call, chain, kin, step, speed_step, k, d);
}
