/* The contact laws of LANES contacts at once: IMPACT, friction, friction that sticks. Rollers and surfaces, space and
 * plane, forces and derivatives use these functions; law_scalar.c offers one lane of them. docs/theory.md, "Contact"
 * and "Friction that sticks"; letters as there. */
#ifndef HAWSER_CONTACT_LAW_LANES_H
#define HAWSER_CONTACT_LAW_LANES_H

#include "contact/law.h"
#include "core/lanes.h"

/* The normal force (C12). All members are zero where there is no contact. */
typedef struct LaneImpact {
    LaneMask touches;      /* where there is a force */
    Lane force, gap, rate; /* N; its derivatives by the gap, N/m, and by the gap's rate, N s/m */
    Lane loss, energy;     /* W, lost in the damping (BA5); J, in the spring (BA6), cut off or not */
} LaneImpact;

/* p^(e-1); the exponents that cases mostly use cost no pow(). */
LANE_INLINE Lane power_less_one(Lane p, double e)
{
    if (e == 1) return lane_set(1);
    if (e == 1.5) return lane_sqrt(p);
    if (e == 2) return p;
    for (int l = 0; l < LANES; ++l) p[l] = p[l] > 0 ? pow(p[l], e - 1) : 0;
    return p;
}

/* (C12): references.md, IMPACT with x = gap (m), x1 = 0; rate in m/s. The damping rises with the penetration, so that
 * the force starts from zero at any speed; where damping would pull the bodies together the force is cut off at zero,
 * and the damping takes all of the spring's energy. A gap that is NaN is no contact: the caller detects it in the
 * state. */
LANE_INLINE LaneImpact impact_at(const ImpactLaw *law, Lane gap, Lane rate, LaneMask may)
{
    const Lane zero = lane_set(0), p = lane_select(may & (gap < zero), -gap, zero);
    rate = lane_select(p > zero, rate, zero);
    const LaneStep rise = lane_step(p, zero, lane_set(law->d > 0 ? law->d : 1e-300));
    const Lane c = law->c * rise.value, k = law->k * power_less_one(p, law->e), spring = k * p;
    const Lane force = spring - c * rate;
    LaneImpact out = {.touches = force > zero};
    out.force = lane_select(out.touches, force, zero);
    /* p = -gap turns the signs: dN/dgap = -(k e p^(e-1) - c' rate) */
    out.gap = lane_select(out.touches, law->c * rise.slope * rate - law->e * k, zero);
    out.rate = lane_select(out.touches, -c, zero);
    out.loss = lane_select(out.touches, c * rate, spring) * rate;
    out.energy = spring * p * (1 / (law->e + 1));
    return out;
}

/* (PS11): the same law as a straight line about the depth at which the spring alone has the force `presumed` (N): where
 * that is zero there is no contact, elsewhere the force may be below zero. No loss, no energy. */
LANE_INLINE LaneImpact impact_about(const ImpactLaw *law, Lane presumed, Lane gap, Lane rate)
{
    const Lane zero = lane_set(0), one = lane_set(1);
    LaneImpact out = {.touches = presumed > zero};
    Lane depth = one;
    for (int l = 0; l < LANES; ++l) depth[l] = presumed[l] > 0 ? pow(presumed[l] / law->k, 1 / law->e) : 1;
    const Lane beyond = -gap - depth, stiffness = law->e * presumed / depth;
    const LaneStep rise = lane_step(depth, zero, lane_set(law->d > 0 ? law->d : 1e-300));
    const Lane risen = rise.value + rise.slope * beyond;
    const LaneMask between = (risen > zero) & (risen < one);
    const Lane c = law->c * lane_select(between, risen, lane_select(risen > zero, one, zero));
    const Lane by_gap = law->c * lane_select(between, rise.slope, zero) * rate;
    out.force = lane_select(out.touches, presumed + stiffness * beyond - c * rate, zero);
    out.gap = lane_select(out.touches, by_gap - stiffness, zero);
    out.rate = lane_select(out.touches, -c, zero);
    return out;
}

/* The coefficients of the law in every lane. */
typedef struct LaneFriction {
    Lane mu_s, mu_d, v_s, v_d;
} LaneFriction;

LANE_INLINE LaneFriction friction_spread(const FrictionLaw *law)
{
    return (LaneFriction){lane_set(law->mu_s), lane_set(law->mu_d), lane_set(law->v_s), lane_set(law->v_d)};
}

/* One law per lane. */
LANE_INLINE LaneFriction friction_gather(const FrictionLaw *const law[LANES])
{
    LaneFriction f;
    for (int l = 0; l < LANES; ++l) {
        f.mu_s[l] = law[l]->mu_s;
        f.mu_d[l] = law[l]->mu_d;
        f.v_s[l] = law[l]->v_s;
        f.v_d[l] = law[l]->v_d;
    }
    return f;
}

/* Friction of LANES contacts, and the state of those that stick. */
typedef struct LaneRub {
    Lane3 lean;             /* x (GR11), m/s; friction of speed alone: v_t */
    Lane phi;               /* mu/|x|, s/m, friction scale included */
    Lane by_lean, by_slide; /* dphi = by_lean x.dx + by_slide v_t.dv_t; friction of speed alone: by_lean is all */
    Lane3 kept;             /* s0, m, world: the lean at the last accepted step */
    Lane kept_normal;
    Lane ratio;   /* v_s/d_s, 1/s; 0: friction of speed alone */
    Lane elapsed; /* tau, s since that step */
} LaneRub;

/* phi, by_lean, by_slide for a lean of length x at the sliding speed v, m/s; for friction of speed alone x is v (C14),
 * (GR12), (GR13). The coefficient follows the lean by the odd STEP from -1 at -v_s to 1 at v_s, which over x is even in
 * x and smooth at rest: there the law is viscous with 1.5 mu_s/v_s. Between v_s and v_d the coefficient falls by STEP
 * from mu_s to mu_d. */
LANE_INLINE void friction_at(const LaneFriction *law, double scale, Lane x, Lane v, LaneRub *rub)
{
    const Lane per = 1 / law->v_s, share = x * per;
    const LaneMask sticks = x < law->v_s;
    const Lane over = 1 / lane_select(sticks, law->v_s, x);
    const Lane called = lane_select(sticks, (3 - share * share) * (per / 2), over);
    const Lane called_by = lane_select(sticks, -per * per * per, -over * over * over);
    const LaneStep fall = lane_step(v, law->v_s, law->v_d);
    const Lane mu = scale * (law->mu_s + (law->mu_d - law->mu_s) * fall.value);
    const Lane mu_by = scale * (law->mu_d - law->mu_s) * fall.slope;
    rub->phi = mu * called;
    rub->by_lean = mu * called_by;
    rub->by_slide = mu_by * called / lane_at_least(v, 1e-300);
}

/* Friction against the normal n at the sliding velocity `slide`; where it sticks, that of bristles with kept leans
 * (GR11)-(GR13). sticks is a constant: code that it excludes is not compiled. */
LANE_INLINE void rub_find(LaneRub *rub, const LaneFriction *law, double scale, Lane3 n, Lane3 slide, int sticks)
{
    rub->lean = slide;
    if (!sticks) {
        const Lane v = lane_sqrt(l3_dot(slide, slide));
        friction_at(law, scale, v, v, rub);
        rub->by_lean += rub->by_slide;
        return;
    }
    rub->kept_normal = l3_dot(n, rub->kept);
    const Lane3 flat = l3_axpy(rub->kept, -rub->kept_normal, n);
    rub->lean = l3_axpy(l3_scale(rub->ratio, flat), 1 + rub->ratio * rub->elapsed, slide);
    friction_at(law, scale, lane_sqrt(l3_dot(rub->lean, rub->lean)), lane_sqrt(l3_dot(slide, slide)), rub);
}

/* F / N: the normal less the friction (C13), (GR13). */
LANE_INLINE Lane3 rub_direction(const LaneRub *rub, Lane3 n) { return l3_axpy(n, -rub->phi, rub->lean); }

/* Loss per N of normal force, m/s (BA5). */
LANE_INLINE Lane rub_loss(const LaneRub *rub, Lane3 slide) { return rub->phi * l3_dot(rub->lean, slide); }

/* d(F/N) for changes of the normal and of the surface velocity v_s = slide + slip_normal n (C16), (GR14). */
LANE_INLINE Lane3 rub_direction_by(const LaneRub *rub, Lane3 n, Lane3 slip, Lane slip_normal, Lane3 slide,
                                   Lane3 normal_by, Lane3 slip_by, int sticks)
{
    const Lane along = l3_dot(normal_by, slip) + l3_dot(n, slip_by);
    const Lane3 slide_by = l3_axpy(l3_axpy(slip_by, -along, n), -slip_normal, normal_by);
    Lane3 lean_by = slide_by;
    if (sticks) {
        const Lane turn = l3_dot(normal_by, rub->kept);
        const Lane3 flat_by = l3_neg(l3_axpy(l3_scale(turn, n), rub->kept_normal, normal_by));
        lean_by = l3_axpy(l3_scale(rub->ratio, flat_by), 1 + rub->ratio * rub->elapsed, slide_by);
    }
    Lane phi_by = rub->by_lean * l3_dot(rub->lean, lean_by);
    if (sticks) phi_by += rub->by_slide * l3_dot(slide, slide_by);
    return l3_sub(normal_by, l3_axpy(l3_scale(phi_by, rub->lean), rub->phi, lean_by));
}

/* Lean of the bristles if the step ends here: of displacement alone, at most d_s (GR12). Zero where there is no
 * bristle. */
LANE_INLINE Lane3 rub_keep(const LaneRub *rub, const LaneFriction *law, Lane3 n, Lane3 slide)
{
    const Lane zero = lane_set(0), one = lane_set(1);
    const LaneMask bristle = rub->ratio > zero;
    const Lane3 flat = l3_axpy(rub->kept, -rub->kept_normal, n);
    const Lane3 now = l3_axpy(flat, rub->elapsed, slide);
    const Lane length = lane_sqrt(l3_dot(now, now)), most = law->v_s / lane_select(bristle, rub->ratio, one);
    const Lane share = lane_select(length > most, most / lane_at_least(length, 1e-300), one);
    return l3_scale(lane_select(bristle, share, zero), now);
}

/* Sums over the contacts of one call, kept lane by lane so that no sum waits for the one before it; in space and in the
 * plane. docs/theory.md, "Balances". */

typedef struct TallyLanes {
    double friction[LANES], damping[LANES], energy[LANES], force[3][LANES]; /* in the plane force[2] stays zero */
} TallyLanes;

/* Adds lane l of a contact's losses (friction, damping), stored energy (energy) and force on the cable (total, of
 * `dims` components). */
static inline void tally_add(TallyLanes *sum, const double *friction, const double *damping, const double *energy,
                             const double total[][LANES], int dims, int l)
{
    sum->friction[l] += friction[l];
    sum->damping[l] += damping[l];
    sum->energy[l] += energy[l];
    for (int c = 0; c < dims; ++c) sum->force[c][l] += total[c][l];
}

static inline ContactTally tally_total(const TallyLanes *sum)
{
    ContactTally total = {0};
    for (int l = 0; l < LANES; ++l) {
        total.friction += sum->friction[l];
        total.damping += sum->damping[l];
        total.energy += sum->energy[l];
        for (int c = 0; c < 3; ++c) total.force[c] += sum->force[c][l];
    }
    return total;
}

#endif
