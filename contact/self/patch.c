/* From two lines to forces: geometry and motion of the piece's ends, the bed's integral, the laws, the shares of the
 * segments. The derivatives of the same steps are in patch_columns.c. */
#include "contact/self/patch.h"

/* The slot of a segment on a side, a new one if it has none yet. */
static PatchSlot *slot_of(Patch *patch, const SelfLine *line, int body, int side)
{
    for (int s = 0; s < patch->slots; ++s) {
        if (patch->slot[s].body == body && patch->slot[s].side == side) return &patch->slot[s];
    }
    PatchSlot *const slot = &patch->slot[patch->slots++];
    *slot = (PatchSlot){.body = body, .side = side};
    slot->r = v3_scale(line->chain->half[body], v3_load(line->kin->a, body));
    slot->w = v3_load(line->kin->w, body);
    return slot;
}

/* One spot's segments become slots; its velocity, with that of the parameter, and its angular velocity come out. */
static void spot_take(Patch *patch, const SelfLine *line, const LineSpot *spot, int side, int a)
{
    const double sign = side ? -1 : 1;
    for (int b = 0; b < 2; ++b) {
        const int i = spot->body[b];
        if (i < 0 || i >= line->chain->n) continue;
        PatchSlot *const slot = slot_of(patch, line, i, side);
        slot->alpha[a] = spot->weight.alpha[b];
        slot->beta[a] = spot->weight.beta[b];
        const Vec3 v = v3_load(line->kin->v, i), turned = v3_cross(slot->w, slot->r);
        patch->speed[a] = v3_axpy(v3_axpy(patch->speed[a], sign * slot->alpha[a], v), sign * slot->beta[a], turned);
        patch->omega[side][a] = v3_axpy(patch->omega[side][a], slot->alpha[a], slot->w);
        if (side == 0) continue;
        slot->alpha1[a] = spot->weight1.alpha[b];
        slot->beta1[a] = spot->weight1.beta[b];
        patch->speed1[a] = v3_axpy(v3_axpy(patch->speed1[a], -slot->alpha1[a], v), -slot->beta1[a], turned);
        patch->omega1[a] = v3_axpy(patch->omega1[a], slot->alpha1[a], slot->w);
    }
}

/* Surfaces against each other at the centre of the pressed part (CC9), (CC10). */
static void slip_find(Patch *p)
{
    const double xi = p->centre;
    p->spin = v3(0, 0, 0);
    for (int side = 0; side < 2; ++side) {
        p->spin = v3_axpy(p->spin, p->share[side] * (1 - xi), p->omega[side][0]);
        p->spin = v3_axpy(p->spin, p->share[side] * xi, p->omega[side][1]);
    }
    p->slip = v3_sub(p->drift, v3_cross(p->spin, p->arm));
    p->slide = v3_reject(p->slip, p->normal);
}

/* Damping and friction on top of the bed's elastic forces (CC7)-(CC11). */
static void laws_apply(Patch *p, const PatchLaw *law, double friction_scale)
{
    const double xi = p->centre;
    p->arm = v3_axpy(v3_scale(1 - xi, p->w[0]), xi, p->w[1]);
    p->distance = v3_norm(p->arm);
    p->normal = v3_unit(p->arm);
    p->drift = v3_axpy(v3_scale(1 - xi, p->speed[0]), xi, p->speed[1]);
    p->rate = v3_dot(p->normal, p->drift);
    const double damped = 1 - law->dissipation * p->rate;
    p->damped = damped > 0 ? damped : 0;
    p->force = p->damped * p->elastic;
    slip_find(p);
    p->phi = friction_scale * friction_over_speed(&law->friction, v3_norm(p->slide), &p->phi_over);
    p->phi_over *= friction_scale;
    p->friction = v3_scale(-p->force * p->phi, p->slide);
    p->couple = v3_cross(p->friction, p->arm);
    p->on[0] = v3_axpy(v3_scale(p->damped, p->g[0]), 1 - xi, p->friction);
    p->on[1] = v3_axpy(v3_scale(p->damped, p->g[1]), xi, p->friction);
}

int patch_at(const SelfLine *const side[2], const PatchLaw *law, double friction_scale, double length,
             const PatchEnd end[2], Patch *patch)
{
    const SelfLine *const other = side[1];
    *patch = (Patch){.length = length};
    double radius[2] = {0, 0};
    for (int a = 0; a < 2; ++a) {
        const LineSpot *const here = &end[a].here, *const there = &end[a].there;
        const int held = end[a].v <= 0 && end[a].foot == 0;
        const int held_head = end[a].v >= 1 && end[a].foot == other->chain->n;
        spot_take(patch, side[0], here, 0, a);
        spot_take(patch, other, there, 1, a);
        patch->w[a] = v3_sub(here->p, there->p);
        patch->foot1[a] = there->p1;
        patch->curvature[a] = held || held_head ? 0 : v3_dot(there->p1, there->p1) - v3_dot(patch->w[a], there->p2);
        patch->radius1[a] = there->radius1;
        radius[0] += here->radius / 2;
        radius[1] += there->radius / 2;
    }
    patch->radius = radius[0] + radius[1];
    for (int s = 0; s < 2; ++s) patch->share[s] = radius[s] / patch->radius;
    if (!bed_integrate(patch, law)) return 0;
    laws_apply(patch, law, friction_scale);
    return patch->force > 0;
}

/* (CC12): forces at the two ends by the weights, the friction's couple with the rotation's weights. */
PatchWrench patch_wrench(const Patch *p, int s)
{
    const PatchSlot *const slot = &p->slot[s];
    const double sign = slot->side ? -1 : 1, part[2] = {1 - p->centre, p->centre};
    PatchWrench out = {{0, 0, 0}, {0, 0, 0}};
    for (int a = 0; a < 2; ++a) {
        out.force = v3_axpy(out.force, sign * slot->alpha[a], p->on[a]);
        out.moment = v3_axpy(out.moment, sign * slot->beta[a], v3_cross(slot->r, p->on[a]));
        out.moment = v3_axpy(out.moment, slot->alpha[a] * part[a] * p->share[slot->side], p->couple);
    }
    return out;
}

/* |w| is least at an end of the piece or where its slope vanishes. */
double patch_depth(const Patch *p)
{
    const Vec3 along = v3_sub(p->w[1], p->w[0]);
    const double b = v3_dot(p->w[0], along), a = v3_dot(along, along);
    const double xi = b >= 0 || a <= 0 ? 0 : fmin(1, -b / a);
    return p->radius - v3_norm(v3_axpy(p->w[0], xi, along));
}
