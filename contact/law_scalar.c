/* One lane of the laws, for a single contact. */
#include "contact/law_lanes.h"
#include <assert.h>

FrictionKind friction_kind(const FrictionLaw *law)
{
    if (!(law->mu_s > 0)) return FRICTION_NONE; /* mu_d is not above it */
    return law->d_s > 0 ? FRICTION_STICK : FRICTION_SPEED;
}

double impact_force(const ImpactLaw *law, double gap, double rate, double *d_gap, double *d_rate)
{
    assert(law->e >= 1 && law->d >= 0);
    const LaneImpact at = impact_at(law, lane_set(gap), lane_set(rate), ~(LaneMask){0});
    *d_gap = at.gap[0];
    *d_rate = at.rate[0];
    return at.force[0];
}

double friction_over_speed(const FrictionLaw *law, double v, double *d_over_v)
{
    assert(!(v < 0) && law->v_s > 0 && law->v_s < law->v_d);
    const LaneFriction spread = friction_spread(law);
    LaneRub rub;
    friction_at(&spread, 1, lane_set(v), lane_set(v), &rub);
    *d_over_v = rub.by_lean[0] + rub.by_slide[0];
    return rub.phi[0];
}

FrictionLaw friction_scaled(FrictionLaw law, double factor)
{
    if (law.mu_s > 0) law.mu_s = fmax(factor * law.mu_s, FRICTION_HARDLY_ANY);
    if (law.mu_d > 0) law.mu_d = fmax(factor * law.mu_d, FRICTION_HARDLY_ANY);
    return law;
}
