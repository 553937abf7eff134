/* The forces of LANES contacts at once: what the force and the derivative kernels share. Derivation and
 * equation numbers: docs/model.md, "Contact"; letters as there. */
#ifndef HAWSER_CONTACT_ROLLER_CONTACT_LANES_H
#define HAWSER_CONTACT_ROLLER_CONTACT_LANES_H

#include "contact/law/stick_lanes.h"
#include "contact/roller/line_lanes.h"

/* What a kernel is compiled for: all members are constants, and what is not asked for is not evaluated. */
typedef struct Variant {
    int grooved; /* shapes of any kind; 0: cylinders */
    int moving;  /* rollers move */
    FrictionKind rubs;
} Variant;
/* Of a ContactVariant. */
LANE_INLINE Variant variant_of(ContactVariant which)
{
    const int moving = which >= VARIANT_MOVING, sticks = which == VARIANT_STICK || which == VARIANT_MOVING_STICK;
    return (Variant){which >= VARIANT_GENERAL, moving,
                     sticks                    ? FRICTION_STICK
                     : which == VARIANT_SMOOTH ? FRICTION_NONE
                                               : FRICTION_SPEED};
}

/* A contact with its force. */
typedef struct Contact {
    Lane u;
    LaneMask interior; /* the minimum is inside the element: it moves along it */
    LinePoint at;
    Lane3 pdot;                           /* velocity of the line's material at P, m/s, against the roller's (SP2) */
    Lane3 omega;                          /* angular velocity there, rad/s, likewise */
    Lane3 lever, roller_w;                /* where the roller moves: P - C, m, and its angular velocity, rad/s */
    Lane3 slip;                           /* surface velocity v_s, m/s */
    Lane slip_normal;                     /* its part along the normal */
    Lane3 slide;                          /* its tangential part v_t */
    Lane gap, rate;                       /* m, m/s */
    Lane normal, normal_gap, normal_rate; /* N and its derivatives (C12) */
    Lane loss, energy;                    /* W, what the normal damping takes; J, in the spring (BA5), (BA6) */
    Lane phi, phi_over;                   /* mu/v and its derivative over v, friction scale included (C14) */
    LaneStick stick;                      /* in place of phi where it sticks */
    Lane3 force;                          /* F (C13), N */
    Lane3 arm[2];                         /* beta_i r_i - alpha_i rc n: lever of F about the centres (C15), m */
} Contact;

/* Normal force of every lane (C12), and the friction of speed (C14): the scalar laws, since few lanes differ in cost.
 */
LANE_INLINE void contact_laws(Contact *c, const ContactBatch *batch, Variant is)
{
    /* value: N, dN/dgap, dN/drate, phi, (dphi/dv)/v, a spring that is cut off */
    double speed[LANES], value[6][LANES];
    if (is.rubs == FRICTION_SPEED) lane_store(speed, shape_root(l3_dot(c->slide, c->slide)));
    for (int l = 0; l < LANES; ++l) {
        for (int v = 0; v < 6; ++v) value[v][l] = 0;
        /* a gap that is not a number touches nothing: the caller sees it in the state */
        if (!(c->gap[l] < 0)) continue;
        value[0][l] = impact_force(batch->impact, c->gap[l], c->rate[l], &value[1][l], &value[2][l]);
        if (!(value[0][l] > 0)) value[5][l] = impact_spring(batch->impact, c->gap[l]);
        if (is.rubs == FRICTION_SPEED) value[3][l] = friction_over_speed(batch->friction[l], speed[l], &value[4][l]);
    }
    const Lane scale = lane_set(batch->friction_scale);
    c->normal = lane_load(value[0]);
    c->normal_gap = lane_load(value[1]);
    c->normal_rate = lane_load(value[2]);
    const Lane cut = lane_load(value[5]), spring = c->normal - c->normal_rate * c->rate + cut;
    c->loss = (cut - c->normal_rate * c->rate) * c->rate;
    c->energy = spring * -c->gap / (batch->impact->e + 1); /* no force, no spring: 0 */
    if (is.rubs != FRICTION_SPEED) return;
    c->phi = scale * lane_load(value[3]);
    c->phi_over = scale * lane_load(value[4]);
}

/* The law of every lane. */
LANE_INLINE LaneFriction friction_gather(const ContactBatch *batch)
{
    LaneFriction f;
    for (int l = 0; l < LANES; ++l) {
        const FrictionLaw *const law = batch->friction[l];
        f.mu_s[l] = law->mu_s;
        f.mu_d[l] = law->mu_d;
        f.v_s[l] = law->v_s;
        f.v_d[l] = law->v_d;
    }
    return f;
}

/* Friction that sticks (GR11)-(GR13). */
LANE_INLINE void contact_stick(Contact *c, const ContactBatch *batch)
{
    const LaneFriction law = friction_gather(batch);
    c->stick.kept = batch_vector(batch->kept);
    c->stick.elapsed = lane_set(batch->elapsed);
    for (int l = 0; l < LANES; ++l) {
        const FrictionLaw *const f = batch->friction[l];
        c->stick.ratio[l] = f->d_s > 0 ? f->v_s / f->d_s : 0;
    }
    stick_evaluate(&c->stick, &law, batch->friction_scale, c->at.probe.normal, c->slide);
}

/* F / N: the normal, less what friction takes (C13), (GR13). */
LANE_INLINE Lane3 contact_direction(const Contact *c, Variant is)
{
    const Lane3 n = c->at.probe.normal;
    if (is.rubs == FRICTION_NONE) return n;
    if (is.rubs == FRICTION_STICK) return l3_axpy(n, -c->stick.phi, c->stick.lean);
    return l3_axpy(n, -c->phi, c->slide);
}

/* What friction takes, W: its force along the sliding (BA5). */
LANE_INLINE Lane contact_friction_loss(const Contact *c, Variant is)
{
    if (is.rubs == FRICTION_NONE) return lane_set(0);
    if (is.rubs == FRICTION_STICK) return c->normal * c->stick.phi * l3_dot(c->stick.lean, c->slide);
    return c->normal * c->phi * l3_dot(c->slide, c->slide);
}

/* What the roller's own motion takes off the line's (SP2): from here on both are seen from the roller. */
LANE_INLINE void contact_motion_seen(Contact *c, const ContactBatch *batch)
{
    c->lever = l3_sub(c->at.p, batch_vector(batch->centre));
    c->roller_w = batch_vector(batch->roller_w);
    c->pdot = l3_sub(c->pdot, l3_add(batch_vector(batch->roller_v), l3_cross(c->roller_w, c->lever)));
    c->omega = l3_sub(c->omega, c->roller_w);
}

/* Velocities at the contact (C12), (C13). `moving` is a constant: fixed rollers compile to what they were. */
LANE_INLINE void contact_motion(Contact *c, const Line *line, const ContactBatch *batch, int moving)
{
    const LaneBody *j = &line->body[0], *k = &line->body[1];
    const LaneWeights *w = &c->at.weight;
    const Lane3 n = c->at.probe.normal;
    c->pdot = weighted(w, j->v, l3_cross(j->w, j->r), k->v, l3_cross(k->w, k->r));
    c->omega = l3_axpy(l3_scale(w->alpha[0], j->w), w->alpha[1], k->w);
    if (moving) contact_motion_seen(c, batch);
    c->slip = l3_axpy(c->pdot, -c->at.radius, l3_cross(c->omega, n));
    c->slip_normal = l3_dot(n, c->slip);
    c->slide = l3_axpy(c->slip, -c->slip_normal, n);
    c->gap = c->at.probe.distance - c->at.radius;
    c->rate = l3_dot(n, c->pdot);
}

/* The nearest point of a shape of any kind (C11): one function for all kernels that may meet one. */
static __attribute__((noinline, unused)) void contact_place(const Line *line, Contact *c)
{
    c->u = line_nearest(line, 1, &c->interior);
    c->at = line_at(line, 1, c->u);
}

/* A contact from its batch: nearest point, velocities, laws, force (C9)-(C15). The variant is a constant. */
LANE_INLINE Contact contact_at(const ContactBatch *batch, const Line *line, Variant is)
{
    Contact c;
    if (is.grooved) {
        contact_place(line, &c);
    } else {
        c.u = line_nearest(line, 0, &c.interior);
        c.at = line_at(line, 0, c.u);
    }
    contact_motion(&c, line, batch, is.moving);
    contact_laws(&c, batch, is);
    if (is.rubs == FRICTION_STICK) contact_stick(&c, batch);
    const Lane3 n = c.at.probe.normal;
    c.force = l3_scale(c.normal, contact_direction(&c, is));
    for (int b = 0; b < 2; ++b) {
        c.arm[b] = l3_axpy(l3_scale(c.at.weight.beta[b], line->body[b].r), -c.at.weight.alpha[b] * c.at.radius, n);
    }
    return c;
}

/* Lever of the force about the roller's centre, from the surface point P - rc n (SP3), m. */
LANE_INLINE Lane3 contact_roller_arm(const Contact *c) { return l3_axpy(c->lever, -c->at.radius, c->at.probe.normal); }

/* In contact_blocks_lanes.c; see ContactKernels. */
#define COLUMNS(name)                                                                                                  \
    int ISA_NAME(name)(const ContactBatch *batch, ContactMatrix *k, ContactMatrix *d, double normal[LANES])
COLUMNS(contact_columns_plain);
COLUMNS(contact_columns_smooth);
COLUMNS(contact_columns_general);
COLUMNS(contact_columns_stick);
COLUMNS(contact_columns_moving);
COLUMNS(contact_columns_moving_stick);

#endif
