/* The forces of LANES contacts at once: shared by the force and the derivative kernels. Derivation and equation
 * numbers: docs/theory.md, "Contact"; letters as there. */
#ifndef HAWSER_CONTACT_ROLLER_LANES_H
#define HAWSER_CONTACT_ROLLER_LANES_H

#include "contact/law_lanes.h"
#include "contact/line_lanes.h"

/* Features for which a kernel is compiled: all members are constants, and code that they exclude is not compiled. */
typedef struct Variant {
    int grooved; /* 1: shapes of any kind; 0: cylinders */
    int moving;  /* 1: rollers move */
    FrictionKind rubs;
} Variant;

/* Features of a ContactVariant. */
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
    LaneMask interior; /* the minimum is inside the element: the contact moves along it */
    LinePoint at;
    Lane3 pdot;            /* velocity of the line's material at P, m/s, relative to the roller's (SP2) */
    Lane3 omega;           /* angular velocity there, rad/s, likewise */
    Lane3 lever, roller_w; /* where the roller moves: P - C, m, and its angular velocity, rad/s */
    Lane3 slip;            /* surface velocity v_s, m/s */
    Lane slip_normal;      /* its part along the normal */
    Lane3 slide;           /* its tangential part v_t */
    Lane gap, rate;        /* m, m/s */
    LaneImpact push;       /* normal force (C12) */
    LaneRub rub;           /* friction (C14), (GR13); not set without friction */
    Lane3 force;           /* F (C13), N */
    Lane3 arm[2];          /* beta_i r_i - alpha_i rc n: lever of F about the centres (C15), m */
} Contact;

/* The laws of every lane; the variant is a constant. */
LANE_INLINE void contact_laws(Contact *c, const ContactBatch *batch, Variant is)
{
    c->push = batch->presumes ? impact_about(batch->impact, lane_load(batch->presumed), c->gap, c->rate)
                              : impact_at(batch->impact, c->gap, c->rate, ~(LaneMask){0});
    if (is.rubs == FRICTION_NONE) return;
    const LaneFriction law = friction_gather(batch->friction);
    if (is.rubs == FRICTION_STICK) {
        c->rub.kept = batch_vector(batch->kept);
        c->rub.elapsed = lane_set(batch->elapsed);
        for (int l = 0; l < LANES; ++l) {
            const FrictionLaw *const f = batch->friction[l];
            c->rub.ratio[l] = f->d_s > 0 ? f->v_s / f->d_s : 0;
        }
    }
    rub_find(&c->rub, &law, batch->friction_scale, c->at.probe.normal, c->slide, is.rubs == FRICTION_STICK);
}

/* F / N (C13), (GR13). */
LANE_INLINE Lane3 contact_direction(const Contact *c, Variant is)
{
    return is.rubs == FRICTION_NONE ? c->at.probe.normal : rub_direction(&c->rub, c->at.probe.normal);
}

/* Subtracts the roller's own motion from the line's (SP2): from here on both are relative to the roller. */
LANE_INLINE void contact_motion_seen(Contact *c, const ContactBatch *batch)
{
    c->lever = l3_sub(c->at.p, batch_vector(batch->centre));
    c->roller_w = batch_vector(batch->roller_w);
    c->pdot = l3_sub(c->pdot, l3_add(batch_vector(batch->roller_v), l3_cross(c->roller_w, c->lever)));
    c->omega = l3_sub(c->omega, c->roller_w);
}

/* Velocities at the contact (C12), (C13). `moving` is a constant: for fixed rollers the compiled code has no part of
 * it. */
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

/* The nearest point of a shape of any kind (C11): one function for all kernels that need it. */
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
    const Lane3 n = c.at.probe.normal;
    c.force = l3_scale(c.push.force, contact_direction(&c, is));
    for (int b = 0; b < 2; ++b) {
        c.arm[b] = l3_axpy(l3_scale(c.at.weight.beta[b], line->body[b].r), -c.at.weight.alpha[b] * c.at.radius, n);
    }
    return c;
}

/* Lever of the force about the roller's centre, from the surface point P - rc n (SP3), m. */
LANE_INLINE Lane3 contact_roller_arm(const Contact *c) { return l3_axpy(c->lever, -c->at.radius, c->at.probe.normal); }

/* Further down in contact/roller_lanes.c; see ContactKernels. */
#define COLUMNS(name)                                                                                                  \
    int ISA_NAME(name)(const ContactBatch *batch, ContactMatrix *k, ContactMatrix *d, double normal[LANES])
COLUMNS(contact_columns_plain);

COLUMNS(contact_columns_smooth);

COLUMNS(contact_columns_general);

COLUMNS(contact_columns_stick);

COLUMNS(contact_columns_moving);

COLUMNS(contact_columns_moving_stick);

#endif
