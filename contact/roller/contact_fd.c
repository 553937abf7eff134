/* Everything that the analytic derivatives could have forgotten is in the forces by construction. */
#include "contact/roller/contact_fd.h"

#include "contact/law/forces_fd.h"

/* One call of contact_forces. */
typedef struct ContactCall {
    const ContactModel *model;
    const Chain *chain;
    double friction_scale;
    ContactPairs *pairs;
} ContactCall;

static void forces_of(void *arg, const Kinematics *kin, Loads *loads)
{
    const ContactCall *const call = arg;
    contact_forces(call->model, call->chain, kin, call->friction_scale, call->pairs, loads, NULL, NULL);
}

double contact_blocks_fd(const ContactModel *model, const Chain *chain, Kinematics *kin, double friction_scale,
                         ContactPairs *pairs, double step, double speed_step, BlockChain *k, BlockChain *d)
{
    ContactCall call = {model, chain, friction_scale, pairs};
    return forces_fd(forces_of, &call, chain, kin, step, speed_step, k, d);
}
