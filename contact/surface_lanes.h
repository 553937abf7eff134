/* LANES points against one patch: their place along its way, distance, normal and weight. Derivation and equation
 * numbers: docs/theory.md, "Surfaces"; letters as there. */
#ifndef HAWSER_CONTACT_SURFACE_LANES_H
#define HAWSER_CONTACT_SURFACE_LANES_H

#include "contact/law_lanes.h"
#include "contact/line_lanes.h"
#include "contact/shape_lanes.h"
#include "contact/surface.h"

/* A point in a patch's own coordinates (DU3): s along the way, a to the side, b up, and the axes there. */
typedef struct SurfacePlace {
    LaneMask owned;
    Lane3 axis[3];     /* T, A, B at s */
    Lane s, a, b;      /* m; s is only set where something depends on it */
    Lane m, curvature; /* m = 1 - a/R; 1/(R - a), 0 on a straight */
    Lane cos, sin;     /* of the roll theta */
    Lane roll1, roll2; /* theta', theta'', 1/m and 1/m2 */
    Lane y, z;         /* m, of the section (DU5) */
} SurfacePlace;

/* The section's distance G and its derivatives (DU4): G'' = k t t^T with t = (-G_z, G_y). */
typedef struct SurfaceSection {
    Lane g, gy, gz, k;
} SurfaceSection;

/* A smooth weight and its slope along its coordinate. */
typedef struct SurfaceShare {
    Lane value;
    Lane3 slope; /* gradient, 1/m */
} SurfaceShare;

/* Angle of each lane about a bend's axis; the library's function, and only where something depends on it. */
LANE_INLINE Lane surface_angle(Lane sine, Lane cosine)
{
    double s[LANES], c[LANES];
    lane_store(s, sine);
    lane_store(c, cosine);
    for (int l = 0; l < LANES; ++l) s[l] = atan2(s[l], c[l]);
    return lane_load(s);
}

/* Straight: coordinates along three fixed axes. */
LANE_INLINE void place_straight(const SurfacePatch *patch, Lane3 p, SurfacePlace *at)
{
    const Lane3 off = l3_sub(p, l3_spread(patch->start));
    at->axis[0] = l3_spread(patch->tangent);
    at->axis[1] = l3_spread(patch->side);
    at->axis[2] = l3_spread(patch->up);
    at->s = l3_dot(off, at->axis[0]);
    at->a = l3_dot(off, at->axis[1]);
    at->b = l3_dot(off, at->axis[2]);
    at->m = lane_set(1);
    at->curvature = lane_set(0);
}

/* Bend: cylindrical coordinates about its axis. */
LANE_INLINE void place_bend(const SurfacePatch *patch, Lane3 p, SurfacePlace *at)
{
    const Lane3 off = l3_sub(p, l3_spread(patch->centre));
    const Lane3 tangent = l3_spread(patch->tangent), side = l3_spread(patch->side);
    const Lane x = -l3_dot(off, side), y = l3_dot(off, tangent);
    const Lane rho = lane_sqrt(lane_at_least(x * x + y * y, 1e-60)), inverse = 1 / rho;
    const Lane c = x * inverse, s = y * inverse;
    at->axis[0] = l3_axpy(l3_scale(c, tangent), s, side);
    at->axis[1] = l3_axpy(l3_scale(c, side), -s, tangent);
    at->axis[2] = l3_spread(patch->up);
    at->a = patch->bend - rho;
    at->b = l3_dot(off, at->axis[2]);
    at->m = rho * (1 / patch->bend);
    at->curvature = inverse;
    at->s = patch->twisted || patch->along.used ? patch->bend * surface_angle(y, x) : lane_set(0);
}

/* s for all points, for output. */
LANE_INLINE Lane surface_along(const SurfacePatch *patch, Lane3 p, const SurfacePlace *at)
{
    if (!(patch->bend > 0)) return at->s;
    const Lane3 off = l3_sub(p, l3_spread(patch->centre));
    return patch->bend * surface_angle(l3_dot(off, l3_spread(patch->tangent)), -l3_dot(off, l3_spread(patch->side)));
}

/* The roll of the section at s (DU6). */
LANE_INLINE void place_roll(const SurfacePatch *patch, SurfacePlace *at)
{
    at->cos = lane_set(patch->roll_cos);
    at->sin = lane_set(patch->roll_sin);
    at->roll1 = at->roll2 = lane_set(0);
    if (!patch->twisted) return;
    const double by = patch->roll[1] - patch->roll[0], per = 1 / patch->length;
    const Lane d = lane_ramp(at->s, lane_set(0), lane_set(per));
    const LaneStep turn = lane_step(at->s, lane_set(0), lane_set(patch->length));
    const Lane roll = patch->roll[0] + by * turn.value;
    for (int l = 0; l < LANES; ++l) {
        at->cos[l] = cos(roll[l]);
        at->sin[l] = sin(roll[l]);
    }
    at->roll1 = by * turn.slope;
    /* beyond the ends the roll stays */
    const LaneMask inside = (d > lane_set(0)) & (d < lane_set(1));
    at->roll2 = lane_select(inside, by * per * per * (6 - 12 * d), lane_set(0));
}

/* (DU3), (DU5). */
LANE_INLINE SurfacePlace surface_place(const SurfacePatch *patch, Lane3 p)
{
    SurfacePlace at;
    if (patch->bend > 0) {
        place_bend(patch, p, &at);
    } else {
        place_straight(patch, p, &at);
    }
    place_roll(patch, &at);
    at.y = at.a * at.cos + at.b * at.sin;
    at.z = at.b * at.cos - at.a * at.sin;
    /* half open, by the same numbers as the neighbouring part: every point belongs to exactly one */
    at.owned = ~(LaneMask){0};
    if (patch->length > 0) {
        const Lane after = l3_dot(l3_sub(p, l3_spread(patch->start)), l3_spread(patch->tangent));
        const Lane before = l3_dot(l3_sub(p, l3_spread(patch->end)), l3_spread(patch->end_tangent));
        const Lane zero = lane_set(0);
        at.owned = (after >= zero) & (before < zero);
    }
    return at;
}

/* (DU4). */
LANE_INLINE SurfaceSection surface_section(const SurfacePatch *patch, const SurfacePlace *at)
{
    const Lane zero = lane_set(0), one = lane_set(1);
    if (patch->section == SECTION_FLAT) {
        return (SurfaceSection){patch->ny * at->y + patch->nz * at->z + patch->offset, lane_set(patch->ny),
                                lane_set(patch->nz), zero};
    }
    const Lane z = at->z - patch->lift;
    const Lane r = lane_sqrt(lane_at_least(at->y * at->y + z * z, 1e-60)), inverse = 1 / r;
    const SurfaceSection tube = {patch->inner - r, -at->y * inverse, -z * inverse, -inverse};
    if (patch->section == SECTION_TUBE) return tube;
    /* above its centre a trough has upright sides */
    const LaneMask above = z > zero, left = at->y > zero;
    return (SurfaceSection){lane_select(above, patch->inner - lane_select(left, at->y, -at->y), tube.g),
                            lane_select(above, lane_select(left, -one, one), tube.gy),
                            lane_select(above, zero, tube.gz), lane_select(above, zero, tube.k)};
}

/* Gradient of the distance (DU7): along T, A, B. */
LANE_INLINE void surface_gradient(const SurfacePlace *at, const SurfaceSection *g, Lane out[3])
{
    out[0] = at->roll1 * (g->gy * at->z - g->gz * at->y) / at->m;
    out[1] = g->gy * at->cos - g->gz * at->sin;
    out[2] = g->gy * at->sin + g->gz * at->cos;
}

LANE_INLINE Lane3 surface_vector(const SurfacePlace *at, const Lane c[3])
{
    return l3_axpy(l3_axpy(l3_scale(c[0], at->axis[0]), c[1], at->axis[1]), c[2], at->axis[2]);
}

/* One fade and its slope. */
LANE_INLINE Lane surface_fade(const SurfaceFade *fade, Lane x, Lane *slope)
{
    const LaneStep in = lane_step(x, lane_set(fade->in0), lane_set(fade->in1));
    const LaneStep out = lane_step(x, lane_set(fade->out0), lane_set(fade->out1));
    *slope = in.slope * (1 - out.value) - in.value * out.slope;
    return in.value * (1 - out.value);
}

/* The weight of (DU8) with its gradient. */
LANE_INLINE SurfaceShare surface_share(const SurfacePatch *patch, const SurfacePlace *at)
{
    Lane along = lane_set(1), across = lane_set(1), along1 = lane_set(0), across1 = lane_set(0);
    if (patch->along.used) along = surface_fade(&patch->along, at->s, &along1);
    const double vy = patch->vy, vz = patch->vz;
    if (patch->across.used) across = surface_fade(&patch->across, vy * at->y + vz * at->z, &across1);
    const Lane by_v = along * across1;
    const Lane slope[3] = {(along1 * across + by_v * at->roll1 * (vy * at->z - vz * at->y)) / at->m,
                           by_v * (vy * at->cos - vz * at->sin), by_v * (vy * at->sin + vz * at->cos)};
    return (SurfaceShare){along * across, surface_vector(at, slope)};
}

/* LANES points of the cable's line against one patch: shared by the force and the derivative kernels. Derivation and
 * equation numbers: docs/theory.md, "Surfaces"; letters as there. */

/* A strip's bodies, and the lanes that hold elements. */
typedef struct StripBodies {
    LaneBody body[2];
    LaneMask live;
} StripBodies;

/* Clears a body that does not exist at an end of the chain: its ghost may hold anything. */
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
    Lane3 normal;   /* n */
    Lane3 gradient; /* grad g */
    Lane steep;     /* |grad g|; 1 on a mesh, where n is not along grad g */
    SurfaceShare share;
    LaneImpact push;   /* per metre, before the weight of (DU8) */
    Lane3 slip, slide; /* v_s, v_t (C13) */
    Lane slip_normal;
    Lane load; /* N */
    LaneRub rub;
    Lane3 force; /* F, N; zero without contact */
} SurfaceContact;

/* Place and motion of point q of every element (DU2). */
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

/* Place of the point relative to the patch; returns whether it belongs to the patch. */
LANE_INLINE LaneMask contact_here(const SurfaceStrip *strip, const StripBodies *s, int q, SurfaceContact *c)
{
    if (strip->foot) {
        c->place = (SurfacePlace){0};
        c->section = (SurfaceSection){.g = lane_load(strip->foot->distance[q] + strip->first)};
        return s->live & (lane_load(strip->foot->law[q] + strip->first) == lane_set(strip->patch->law)) &
               (c->section.g < lane_set(INFINITY));
    }
    c->place = surface_place(strip->patch, c->p);
    c->section = surface_section(strip->patch, &c->place);
    return s->live & c->place.owned & (c->section.g > lane_set(-strip->patch->depth));
}

/* Checks whether any lane is near enough for contact, or presumed to be: everything else is computed only if so. */
LANE_INLINE LaneMask contact_gap(const SurfaceStrip *strip, const StripBodies *s, int q, SurfaceContact *c)
{
    const LaneMask here = contact_here(strip, s, q, c);
    if (strip->presumed[q]) return here & (lane_load(strip->presumed[q] + strip->first) > lane_set(0));
    return here & (c->section.g < c->radius);
}

/* The normal force per metre. */
LANE_INLINE LaneImpact contact_push(const SurfaceStrip *strip, const SurfaceContact *c, int q, LaneMask near)
{
    const Lane gap = c->section.g - c->radius, rate = l3_dot(c->gradient, c->pdot), zero = lane_set(0);
    if (!strip->presumed[q]) return impact_at(strip->impact, gap, rate, near);
    const Lane presumed = lane_load(strip->presumed[q] + strip->first);
    return impact_about(strip->impact, lane_select(near, presumed, zero), gap, rate);
}

/* Normal, gradient of the distance, weight: (DU7), (DU8); of a mesh (EN24). */
LANE_INLINE void contact_normal(const SurfaceStrip *strip, int q, SurfaceContact *c)
{
    c->steep = lane_set(1);
    if (strip->foot) {
        c->normal = l3_load(strip->foot->normal[q], strip->first);
        c->gradient = l3_load(strip->foot->gradient[q], strip->first);
        c->share = (SurfaceShare){lane_set(1), l3_zero()};
        return;
    }
    Lane gradient[3];
    surface_gradient(&c->place, &c->section, gradient);
    if (strip->patch->twisted) c->steep = lane_sqrt(1 + gradient[0] * gradient[0]);
    c->gradient = surface_vector(&c->place, gradient);
    c->normal = l3_scale(1 / c->steep, c->gradient);
    c->share = surface_share(strip->patch, &c->place);
}

/* Velocities, laws, force (DU7)-(DU9); near: result of contact_gap. sticks is a constant: code that it excludes is not
 * compiled. */
LANE_INLINE void contact_force(const SurfaceStrip *strip, const StripBodies *s, int q, LaneMask near, int sticks,
                               SurfaceContact *c)
{
    const LaneBody *j = &s->body[0], *k = &s->body[1];
    c->pdot = weighted(&c->weight, j->v, l3_cross(j->w, j->r), k->v, l3_cross(k->w, k->r));
    c->omega = l3_axpy(l3_scale(c->weight.alpha[0], j->w), c->weight.alpha[1], k->w);
    contact_normal(strip, q, c);
    const Lane3 n = c->normal;
    c->push = contact_push(strip, c, q, near);
    c->load = c->share.value * c->length * c->push.force;
    c->slip = l3_axpy(c->pdot, -c->radius, l3_cross(c->omega, n));
    c->slip_normal = l3_dot(n, c->slip);
    c->slide = l3_axpy(c->slip, -c->slip_normal, n);
    if (sticks) { /* from the stored lean of point q of every element */
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

/* Zero without contact, whatever the numbers are there. */
LANE_INLINE Lane3 lanes_keep(LaneMask mask, Lane3 v) { return l3_select(mask, v, l3_zero()); }

/* Further down in contact/surface_lanes.c; see SurfaceKernels. */
int ISA_NAME(surface_columns)(const SurfaceStrip *strip, ContactMatrix *k, ContactMatrix *d);

#endif
