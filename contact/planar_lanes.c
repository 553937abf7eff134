/* The kernels of contact/planar.h for one instruction set. */
#include "contact/planar_lanes.h"

/* The sign of the gap's slope at the centres of LANES segments from i: that of (x - c) . a. */
LANE_INLINE Lane slopes_at(const PlanarKinematics *kin, Lane2 centre, int i)
{
    return l2_dot(l2_sub(l2_load(kin->p, i), centre), l2_load(kin->a, i));
}

/* Eight elements at a time. The slopes at their first nodes are computed again instead of being kept from the elements
 * before: that is cheaper than waiting for what was just stored. */
static int kernel_owners(const PlanarRoller *roller, const PlanarKinematics *kin, int n, int first, int end,
                         int *element)
{
    const Lane2 centre = {lane_set(roller->centre[0]), lane_set(roller->centre[1])};
    const Lane zero = lane_set(0);
    int count = 0;
    for (int e = first; e < end; e += LANES) {
        Lane before = slopes_at(kin, centre, e - 1), after = slopes_at(kin, centre, e);
        if (e == 0) before[0] = -1; /* beyond the line's ends */
        if (n - e < LANES) after[n - e] = 1;
        unsigned owns = lane_bits((before < zero) & (after >= zero));
        if (end - e < LANES) owns &= (1u << (end - e)) - 1;
        for (; owns; owns &= owns - 1) element[count++] = e + __builtin_ctz(owns);
    }
    return count;
}

/* Generalized forces by virtual work (C15). */
static void kernel_push(const PlanarBatch *batch, PlanarPush *out)
{
    const PlanarLine line = planar_line_load(batch);
    const PlanarContact c = planar_contact_at(batch, &line);
    for (int b = 0; b < 2; ++b) {
        pair_store(out->force[b], l2_scale(c.at.weight.alpha[b], c.force));
        lane_store(out->moment[b], l2_cross(c.arm[b], c.force));
    }
    pair_store(out->total, c.force);
    lane_store(out->normal, c.push.force);
    lane_store(out->friction, c.drag * c.slide);
    lane_store(out->damping, c.push.loss);
    lane_store(out->energy, c.push.energy);
}

/* dF (PL13) for given variations: of the normal's angle, the gap, its rate and the sliding speed. */
LANE_INLINE Lane2 vary_force(const PlanarContact *c, Lane angle, Lane gap, Lane rate, Lane slide)
{
    const LaneImpact *const push = &c->push;
    const Lane normal = push->gap * gap + push->rate * rate, phi = c->rub.phi;
    const Lane drag = normal * phi * c->slide + push->force * (phi + c->rub.by_lean * c->slide * c->slide) * slide;
    return l2_axpy(l2_scale(normal + c->drag * angle, c->at.normal), push->force * angle - drag, c->tangent);
}

/* A variation of one body's configuration, and its effect at fixed u: on P, P', its arm and the velocity at P. */
typedef struct PlanarShift {
    int body;
    Lane2 p, p1, r, pdot;
} PlanarShift;

LANE_INLINE void rows_store(double rows[6][LANES], int body, Lane2 force, Lane moment)
{
    pair_store(rows + 3 * body, force);
    lane_store(rows[3 * body + 2], moment);
}

/* A configuration column: the nearest point moves along the line by du (PL13). */
LANE_INLINE void column_shift(const PlanarContact *c, const PlanarLine *line, const PlanarShift *s,
                              double rows[6][LANES])
{
    const Lane zero = lane_set(0);
    const PlanarPoint *at = &c->at;
    const Lane2 n = at->normal, t = c->tangent;
    const PlanarBody *j = &line->body[0], *k = &line->body[1];
    const Lane bent = 1 / at->rho;
    const Lane push = bent * l2_dot(t, s->p) * l2_dot(t, at->p1) + l2_dot(n, s->p1);
    const Lane du = lane_select(c->interior & (at->curvature > zero), -push / at->curvature, zero);
    const Lane angle = bent * l2_dot(t, l2_axpy(s->p, du, at->p1)); /* of the normal */
    const Lane2 pdot1 =
        planar_weighted(&at->weight1, j->v, l2_scale(j->w, l2_turn(j->r)), k->v, l2_scale(k->w, l2_turn(k->r)));
    const Lane2 pdot = l2_axpy(s->pdot, du, pdot1);
    const Lane omega = du * at->weight1.alpha[1] * (k->w - j->w), radius = at->radius1 * du;
    const Lane rate = angle * l2_dot(t, c->pdot) + l2_dot(n, pdot);
    const Lane slide = l2_dot(t, pdot) - angle * c->rate - radius * c->omega - at->radius * omega;
    const Lane2 force = vary_force(c, angle, l2_dot(n, s->p), rate, slide);
    for (int b = 0; b < 2; ++b) {
        const Lane alpha = at->weight.alpha[b], alpha_by = at->weight1.alpha[b] * du;
        /* d(beta_i r_i - alpha_i rc n), with everything that du moves */
        Lane2 arm = l2_scale(at->weight1.beta[b] * du, line->body[b].r);
        arm = l2_axpy(l2_axpy(arm, -(alpha_by * at->radius + alpha * radius), n), -alpha * at->radius * angle, t);
        if (b == s->body) arm = l2_axpy(arm, at->weight.beta[b], s->r);
        rows_store(rows, b, l2_axpy(l2_scale(alpha, force), alpha_by, c->force),
                   l2_cross(arm, c->force) + l2_cross(c->arm[b], force));
    }
}

/* A velocity column: places stay, only velocities change. */
LANE_INLINE void column_speed(const PlanarContact *c, Lane2 pdot, Lane omega, double rows[6][LANES])
{
    const Lane slide = l2_dot(c->tangent, pdot) - c->at.radius * omega;
    const Lane2 force = vary_force(c, lane_set(0), lane_set(0), l2_dot(c->at.normal, pdot), slide);
    for (int b = 0; b < 2; ++b) {
        rows_store(rows, b, l2_scale(c->at.weight.alpha[b], force), l2_cross(c->arm[b], force));
    }
}

/* The columns of body b: two displacements, a rotation; two velocities, an angular velocity. */
LANE_INLINE void body_columns(const PlanarContact *c, const PlanarLine *line, int b, PlanarContactMatrix *k,
                              PlanarContactMatrix *d)
{
    const Lane zero = lane_set(0), one = lane_set(1);
    const Lane2 unit[2] = {{one, zero}, {zero, one}}, none = {zero, zero};
    const PlanarBody *body = &line->body[b];
    const Lane alpha = c->at.weight.alpha[b], beta = c->at.weight.beta[b];
    const Lane alpha1 = c->at.weight1.alpha[b], beta1 = c->at.weight1.beta[b];
    for (int axis = 0; axis < 2; ++axis) {
        const Lane2 e = unit[axis];
        const PlanarShift shift = {b, l2_scale(alpha, e), l2_scale(alpha1, e), none, none};
        column_shift(c, line, &shift, k->entry[3 * b + axis]);
        column_speed(c, l2_scale(alpha, e), zero, d->entry[3 * b + axis]);
    }
    const Lane2 turned = l2_turn(body->r);
    const PlanarShift turn = {b, l2_scale(beta, turned), l2_scale(beta1, turned), turned,
                              l2_scale(-beta * body->w, body->r)};
    column_shift(c, line, &turn, k->entry[3 * b + 2]);
    column_speed(c, l2_scale(beta, turned), alpha, d->entry[3 * b + 2]);
}

static int kernel_columns(const PlanarBatch *batch, PlanarContactMatrix *k, PlanarContactMatrix *d,
                          double normal[LANES])
{
    const PlanarLine line = planar_line_load(batch);
    const PlanarContact c = planar_contact_at(batch, &line);
    lane_store(normal, c.push.force);
    if (!lane_bits(c.push.touches)) return 0;
    for (int b = 0; b < 2; ++b) body_columns(&c, &line, b, k, d);
    return 1;
}

static double kernel_moved(const PlanarChain *chain, const PlanarKinematics *kin, double *const at_p[2],
                           double *const at_a[2])
{
    Lane most = lane_set(0);
    LaneMask strange = {0};
    for (int i = 0; i < chain->n; i += LANES) {
        const Lane2 dp = l2_sub(l2_load(kin->p, i), l2_load(at_p, i));
        const Lane2 da = l2_sub(l2_load(kin->a, i), l2_load(at_a, i));
        const Lane moved = lane_sqrt(l2_dot(dp, dp)) + lane_load(chain->half + i) * lane_sqrt(l2_dot(da, da));
        /* the padding of the arrays is arbitrary; it includes the head's ghost */
        const LaneMask there = lane_load(chain->inverse_mass + i) > lane_set(0);
        strange |= there & ~(moved >= 0);
        most = lane_select(there & (moved > most), moved, most);
    }
    double largest = lane_bits(strange) ? INFINITY : 0;
    for (int k = 0; k < LANES; ++k) largest = most[k] > largest ? most[k] : largest;
    return largest;
}

const PlanarContactKernels ISA_NAME(planar_contact_kernels) = {kernel_owners, kernel_push, kernel_columns,
                                                               kernel_moved};
