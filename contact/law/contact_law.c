/* The two scalar laws, one contact at a time: the kernels call them lane by lane, since only touching lanes
 * need them and a power costs more than the call. */
#include "contact/law/contact_law.h"

#include <assert.h>
#include <math.h>

#include "core/profile.h"

FrictionKind friction_kind(const FrictionLaw *law)
{
    if (!(law->mu_s > 0)) return FRICTION_NONE; /* mu_d is not above it */
    return law->d_s > 0 ? FRICTION_STICK : FRICTION_SPEED;
}

/* p^(e-1) for p > 0; the exponents that cases mostly use cost no pow(). */
static double power_less_one(double p, double e)
{
    if (e == 1) return 1;
    if (e == 1.5) return sqrt(p);
    if (e == 2) return p;
    return pow(p, e - 1);
}

/* (C12): references.md, IMPACT with x = gap, x1 = 0. The damping rises with the penetration, so that the
 * force starts from zero however fast the bodies meet; where damping would pull them together the force is
 * cut off at zero. */
double impact_force(const ImpactLaw *law, double gap, double rate, double *d_gap, double *d_rate)
{
    assert(law->e >= 1 && law->d >= 0);
    *d_gap = *d_rate = 0;
    const double p = -gap;
    if (!(p > 0)) return 0;

    /* damping over penetration, full from d on */
    double c = law->c, c_slope = 0;
    if (p < law->d) c = step_cubic(p, 0, 0, law->d, law->c, &c_slope);
    const double spring = law->k * power_less_one(p, law->e);
    const double force = spring * p - c * rate;
    if (force <= 0) return 0;

    /* p = -gap turns the signs: dN/dgap = -(k e p^(e-1) - c' rate) */
    *d_gap = c_slope * rate - law->e * spring;
    *d_rate = -c;
    return force;
}

double impact_spring(const ImpactLaw *law, double gap)
{
    const double p = -gap;
    return p > 0 ? law->k * power_less_one(p, law->e) * p : 0;
}

/* (C14): the odd STEP from -mu_s to mu_s is mu_s (3 x - x^3)/2 in x = v/v_s, so mu/v is even in v and smooth
 * at rest; there the law is viscous with the coefficient 1.5 mu_s/v_s. */
double friction_over_speed(const FrictionLaw *law, double v, double *d_over_v)
{
    assert(v >= 0 && law->v_s > 0 && law->v_s < law->v_d);
    if (v < law->v_s) {
        /* below v_s: d(mu/v)/dv = -mu_s v/v_s^3 */
        const double x = v / law->v_s;
        *d_over_v = -law->mu_s / (law->v_s * law->v_s * law->v_s);
        return law->mu_s * (3 - x * x) / (2 * law->v_s);
    }
    /* above v_s: the falling STEP, which is constant from v_d on */
    double slope = 0;
    const double mu = step_cubic(v, law->v_s, law->mu_s, law->v_d, law->mu_d, &slope);
    *d_over_v = (slope - mu / v) / (v * v);
    return mu / v;
}
