/* LANES points of the cable's line against one patch: what the force and the derivative kernels share. Derivation and
 * equation numbers: docs/model.md, "Surfaces"; letters as there. */
#ifndef HAWSER_CONTACT_SURFACE_SURFACE_LANES_H
#define HAWSER_CONTACT_SURFACE_SURFACE_LANES_H

#include "contact/law/law_lanes.h"
#include "contact/roller/line_lanes.h"
#include "contact/surface/surface_kernels.h"
#include "contact/surface/surface_patch_lanes.h"

/* A strip's bodies, and the lanes that hold elements. */
typedef struct StripBodies {
    LaneBody body[2];
    LaneMask live;
} StripBodies;

/* A body that is missing at an end of the chain: its ghost may hold anything. */
LANE_INLINE void body_keep(LaneMask mask, LaneBody *b)
{
    Lane3 *const vector[4] = {&b->x, &b->r, &b->v, &b->w};
    for (int k = 0; k < 4; ++k) *vector[k] = l3_select(mask, *vector[k], l3_zero());
}

/* Consecutive elements: unit stride, nothing is gathered. */
LANE_INLINE StripBodies strip_load(const SurfaceStrip *strip)
{
    const Kinematics *const kin = strip->kin;
    const Lane lane = lane_index();
    StripBodies s = {.live = lane < lane_set(strip->count)};
    for (int b = 0; b < 2; ++b) {
        const int i = strip->first - 1 + b;
        s.body[b] = (LaneBody){l3_load(kin->p, i), l3_scale(lane_load(strip->chain->half + i), l3_load(kin->a, i)),
                               l3_load(kin->v, i), l3_load(kin->w, i), lane_set(0)};
    }
    const int n = strip->chain->n;
    if (strip->first == 0) body_keep(lane >= lane_set(1), &s.body[0]);
    if (strip->first + LANES > n) {
        body_keep(lane < lane_set(n - strip->first + 1), &s.body[0]);
        body_keep(lane < lane_set(n - strip->first), &s.body[1]);
    }
    return s;
}

/* A point of the line with its force. */
typedef struct SurfaceContact {
    LaneWeights weight;
    Lane radius, length;
    Lane3 p, pdot, omega;
    SurfacePlace place;
    SurfaceSection section;
    Lane3 normal; /* n */
    Lane steep;   /* |grad g| */
    SurfaceShare share;
    LaneImpact push;   /* of each metre, before the weight of (DU8) */
    Lane3 slip, slide; /* v_s, v_t (C13) */
    Lane slip_normal;
    Lane load; /* N */
    LaneRub rub;
    Lane3 force; /* F, N; zero where nothing touches */
} SurfaceContact;

/* Where point q of every element is, and how it moves (DU2). */
LANE_INLINE void contact_point(const SurfaceStrip *strip, const StripBodies *s, int q, SurfaceContact *c)
{
    const SurfacePoints *const points = strip->points;
    const LaneBody *j = &s->body[0], *k = &s->body[1];
    c->weight.alpha[1] = lane_load(points->alpha[q] + strip->first);
    c->weight.alpha[0] = 1 - c->weight.alpha[1];
    c->weight.beta[0] = lane_load(points->beta[q][0] + strip->first);
    c->weight.beta[1] = lane_load(points->beta[q][1] + strip->first);
    c->length = lane_load(points->length[q] + strip->first);
    c->radius = lane_load(points->radius[q] + strip->first);
    c->p = weighted(&c->weight, j->x, j->r, k->x, k->r);
}

/* Where the point is against the patch; whether it is the patch's. */
LANE_INLINE LaneMask contact_here(const SurfaceStrip *strip, const StripBodies *s, SurfaceContact *c)
{
    c->place = surface_place(strip->patch, c->p);
    c->section = surface_section(strip->patch, &c->place);
    return s->live & c->place.owned & (c->section.g > lane_set(-strip->patch->depth));
}

/* Whether any lane is near enough to touch, or presumed to: everything further is only done if so. */
LANE_INLINE LaneMask contact_gap(const SurfaceStrip *strip, const StripBodies *s, int q, SurfaceContact *c)
{
    const LaneMask here = contact_here(strip, s, c);
    if (strip->presumed[q]) return here & (lane_load(strip->presumed[q] + strip->first) > lane_set(0));
    return here & (c->section.g < c->radius);
}

/* The normal force of each metre. */
LANE_INLINE LaneImpact contact_push(const SurfaceStrip *strip, const SurfaceContact *c, int q, LaneMask near)
{
    const Lane gap = c->section.g - c->radius, rate = c->steep * l3_dot(c->normal, c->pdot), zero = lane_set(0);
    if (!strip->presumed[q]) return impact_at(strip->impact, gap, rate, near);
    const Lane presumed = lane_load(strip->presumed[q] + strip->first);
    return impact_about(strip->impact, lane_select(near, presumed, zero), gap, rate);
}

/* Velocities, laws, force (DU7)-(DU9); near: what contact_gap said. sticks is a constant, and what is not asked for is
 * not evaluated. */
LANE_INLINE void contact_force(const SurfaceStrip *strip, const StripBodies *s, int q, LaneMask near, int sticks,
                               SurfaceContact *c)
{
    const LaneBody *j = &s->body[0], *k = &s->body[1];
    c->pdot = weighted(&c->weight, j->v, l3_cross(j->w, j->r), k->v, l3_cross(k->w, k->r));
    c->omega = l3_axpy(l3_scale(c->weight.alpha[0], j->w), c->weight.alpha[1], k->w);
    Lane gradient[3];
    surface_gradient(&c->place, &c->section, gradient);
    c->steep = lane_set(1);
    if (strip->patch->twisted) c->steep = lane_sqrt(1 + gradient[0] * gradient[0]);
    c->normal = l3_scale(1 / c->steep, surface_vector(&c->place, gradient));
    c->share = surface_share(strip->patch, &c->place);

    const Lane3 n = c->normal;
    c->push = contact_push(strip, c, q, near);
    c->load = c->share.value * c->length * c->push.force;
    c->slip = l3_axpy(c->pdot, -c->radius, l3_cross(c->omega, n));
    c->slip_normal = l3_dot(n, c->slip);
    c->slide = l3_axpy(c->slip, -c->slip_normal, n);
    if (sticks) { /* from what point q of every element remembers */
        c->rub.kept = l3_load(strip->bed->lean[q], strip->first);
        c->rub.elapsed = lane_set(strip->elapsed);
        c->rub.ratio = lane_set(strip->friction->v_s / strip->friction->d_s);
    }
    const LaneFriction law = friction_spread(strip->friction);
    rub_find(&c->rub, &law, strip->friction_scale, n, c->slide, sticks);
    c->force = l3_scale(c->load, rub_direction(&c->rub, n));
}

/* l_i of (C15). */
LANE_INLINE Lane3 contact_arm(const StripBodies *s, const SurfaceContact *c, int b)
{
    return l3_axpy(l3_scale(c->weight.beta[b], s->body[b].r), -c->weight.alpha[b] * c->radius, c->normal);
}

/* Zero where nothing touches, whatever the numbers are there. */
LANE_INLINE Lane3 lanes_keep(LaneMask mask, Lane3 v) { return l3_select(mask, v, l3_zero()); }

/* In surface_blocks_lanes.c; see SurfaceKernels. */
int ISA_NAME(surface_columns)(const SurfaceStrip *strip, ContactMatrix *k, ContactMatrix *d);

#endif
