/* Friction that sticks, of LANES contacts at once: a bristle in each contact that leans, and slides at the full force.
 * docs/model.md, "Friction that sticks"; letters as there. Rollers and surfaces use the same functions. */
#ifndef HAWSER_CONTACT_LAW_STICK_LANES_H
#define HAWSER_CONTACT_LAW_STICK_LANES_H

#include "contact/law/contact_law.h"
#include "contact/shape/shape_lanes.h"

/* Contacts that stick: what they know, then what stick_evaluate makes of it. */
typedef struct LaneStick {
    Lane3 kept;   /* s0, m, world: the lean at the last accepted step */
    Lane ratio;   /* v_s/d_s, 1/s; 0: friction of speed alone */
    Lane elapsed; /* tau, s since that step */
    Lane kept_normal;
    Lane3 lean;             /* x (GR11), m/s */
    Lane phi;               /* mu/|x|, s/m */
    Lane by_lean, by_slide; /* dphi = by_lean x.dx + by_slide v_t.dv_t */
} LaneStick;

/* The coefficients of the law in every lane. */
typedef struct LaneFriction {
    Lane mu_s, mu_d, v_s, v_d;
} LaneFriction;

/* 0 to 1 as x goes from a to b, clamped. */
LANE_INLINE Lane stick_ramp(Lane x, Lane a, Lane b)
{
    const Lane d = (x - a) / (b - a), zero = lane_set(0), one = lane_set(1);
    return lane_select(d > zero, lane_select(d < one, d, one), zero);
}

/* The lean of the bristles against the normal n at the sliding velocity `slide`, and the law at it (GR11)-(GR13). */
LANE_INLINE void stick_evaluate(LaneStick *s, const LaneFriction *law, double scale, Lane3 n, Lane3 slide)
{
    s->kept_normal = l3_dot(n, s->kept);
    const Lane3 flat = l3_axpy(s->kept, -s->kept_normal, n);
    s->lean = l3_axpy(l3_scale(s->ratio, flat), 1 + s->ratio * s->elapsed, slide);

    /* how much of the coefficient the lean calls up, over the lean: odd STEP to 1 at v_s */
    const Lane x = shape_root(l3_dot(s->lean, s->lean));
    const LaneMask sticks = x < law->v_s;
    const Lane over = lane_select(sticks, law->v_s, x), per = 1 / law->v_s, share = x * per;
    const Lane called = lane_select(sticks, (3 - share * share) * per / 2, 1 / over);
    const Lane called_by = lane_select(sticks, -per * per * per, -1 / (over * over * over));

    /* the coefficient falls with the sliding speed: STEP from mu_s at v_s to mu_d at v_d */
    const Lane v = shape_root(l3_dot(slide, slide)), d = stick_ramp(v, law->v_s, law->v_d);
    const Lane mu = law->mu_s + (law->mu_d - law->mu_s) * d * d * (3 - 2 * d);
    const Lane mu_by = (law->mu_d - law->mu_s) * 6 * d * (1 - d) / (law->v_d - law->v_s);

    s->phi = scale * mu * called;
    s->by_lean = scale * mu * called_by;
    s->by_slide = scale * mu_by * called / shape_at_least(v, 1e-300);
}

/* dx for changes of the normal and of the sliding velocity (GR14). */
LANE_INLINE Lane3 stick_lean_by(const LaneStick *s, Lane3 n, Lane3 normal_by, Lane3 slide_by)
{
    const Lane turn = l3_dot(normal_by, s->kept);
    const Lane3 flat_by = l3_neg(l3_axpy(l3_scale(turn, n), s->kept_normal, normal_by));
    return l3_axpy(l3_scale(s->ratio, flat_by), 1 + s->ratio * s->elapsed, slide_by);
}

/* What a step that ends here leaves in the bristles: the lean of displacement alone, at most d_s (GR12). Zero where
 * there is no bristle. */
LANE_INLINE Lane3 stick_keep(const LaneStick *s, const LaneFriction *law, Lane3 n, Lane3 slide)
{
    const Lane zero = lane_set(0), one = lane_set(1);
    const LaneMask bristle = s->ratio > zero;
    const Lane3 flat = l3_axpy(s->kept, -s->kept_normal, n);
    const Lane3 now = l3_axpy(flat, s->elapsed, slide);
    const Lane length = shape_root(l3_dot(now, now)), most = law->v_s / lane_select(bristle, s->ratio, one);
    const Lane share = lane_select(length > most, most / shape_at_least(length, 1e-300), one);
    return l3_scale(lane_select(bristle, share, zero), now);
}

#endif
