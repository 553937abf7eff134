/* Contact force laws with their derivatives: ADAMS' IMPACT and its two-speed friction, as functions of gap
 * and speed. docs/theory.md, "Contact". */
#ifndef HAWSER_CONTACT_LAW_H
#define HAWSER_CONTACT_LAW_H

#include "core/checkpoint.h"
#include "core/vec3.h"

/* IMPACT: k p^e - STEP(p, 0, 0, d, c) gap', never negative, for penetration p = -gap > 0. */
typedef struct ImpactLaw {
    double k; /* N/m^e */
    double e; /* >= 1 */
    double c; /* N s/m, full damping */
    double d; /* m, penetration at which the damping is full */
} ImpactLaw;

/* Friction coefficient over sliding speed: odd STEP from 0 to mu_s at v_s, STEP to mu_d at v_d, constant
 * beyond. With d_s > 0 it sticks: docs/theory.md, "Friction that sticks". */
typedef struct FrictionLaw {
    double mu_s, mu_d;
    double v_s, v_d; /* m/s, 0 < v_s < v_d */
    double d_s;      /* m, displacement at which all of mu_s acts; 0: no sticking, friction depends on speed alone */
} FrictionLaw;

/* Kinds of friction, by which kernels are chosen. */
typedef enum FrictionKind { FRICTION_NONE, FRICTION_SPEED, FRICTION_STICK } FrictionKind;

enum { FRICTION_KINDS = 3 };

FrictionKind friction_kind(const FrictionLaw *law);
/* A coefficient that counts as friction but has no effect: candidates are sorted by the kind, which must not change. */
#define FRICTION_HARDLY_ANY 1e-12
/* The law with its friction times `factor` (K6); a law without friction remains without. */
FrictionLaw friction_scaled(FrictionLaw law, double factor);
/* Normal force N (>= 0) at `gap` (m, negative: penetration) and its rate (m/s). d_gap, d_rate get dN/dgap,
 * dN/drate. */
double impact_force(const ImpactLaw *law, double gap, double rate, double *d_gap, double *d_rate);
/* Friction coefficient at sliding speed v >= 0, divided by v: mu(v)/v (s/m), finite at 0. d_over_v gets
 * (d/dv (mu/v)) / v, finite at 0 too, so that vector friction F = -N phi(v) v_t needs no branch at rest. */
double friction_over_speed(const FrictionLaw *law, double v, double *d_over_v);
/* Presumed contact forces during Newton's search for an equilibrium: each contact's law is a straight line about its
 * presumed force, so that a light rope neither leaves the rollers that bear it nor is thrown back by those that it
 * penetrates. docs/theory/44-positions.md (PS11)-(PS13). */
typedef enum PresumeFrom {
    PRESUME_GAPS, /* from the gaps alone, by the law itself */
    PRESUME_LAST, /* from the contact forces of an equilibrium nearby (PS13) */
    PRESUME_LINE  /* from the presumed forces and the gaps that resulted (PS12) */
} PresumeFrom;

typedef struct Presume {
    PresumeFrom from;
    double gravity; /* m/s2: the presumed force of a contact that closes is at most its segment's weight */
    double keep;    /* least share of its force that an existing contact keeps */
} Presume;

/* Presumed force of the spring alone, N. `before`: N, in the equilibrium nearby, or presumed until now (0: no contact);
 * gap: m, negative: penetration; mass: kg, of its segment. For surfaces everything is per metre of cable. */
double presume_force(const Presume *how, const ImpactLaw *law, double before, double gap, double mass);
/* Effect of contacts of one kind on the motion, summed over the contacts of one call; docs/theory.md, "Balances". */
typedef struct ContactTally {
    double friction, damping; /* W, taken out of the motion (BA5) */
    double edges;             /* W, work of the surfaces' fades on the motion (BA10) */
    double energy;            /* J, in the springs (BA6) */
    double force[3];          /* N, on the cable */
} ContactTally;

/* State of contacts that stick, kept between steps: the lean of each one's bristle. docs/theory.md, "Friction that
 * sticks".
 *
 * The record of a step is read by every evaluation until the next step is accepted, so forces stay pure functions of
 * (t, y) in between. It is part of a run's state, beside y. */

/* One contact that carried force when the last step was accepted. */
typedef struct StickRecord {
    int roller, face, element;
    int none;  /* always 0: a checkpoint holds no undefined padding bytes */
    Vec3 lean; /* s, m, world */
} StickRecord;

typedef struct StickStore {
    double since;   /* s, t of the last accepted step */
    double elapsed; /* s from there to the evaluation */
    int n, room;
    StickRecord *record; /* [n], those of a face one behind the other, by element */
    StickRecord *fresh;  /* [room] being collected */
    int n_faces;
    int *first; /* [n_faces] first record of each face of each roller, -1 if it has none */
} StickStore;

/* Makes room for `room` records of rollers with two faces each; keeps what is stored. 0 if there is no memory. The free
 * may be called on a zeroed struct. */
int stick_reserve(StickStore *store, int rollers, int room);
void stick_free(StickStore *store);
/* The lean from which a contact of this face with this element starts: that of the nearest element which touched the
 * face, so that a contact that moves on along the cable takes its lean along; zero for a new contact. */
Vec3 stick_kept(const StickStore *store, int roller, int face, int element);
/* Moves the records after the chain was renumbered: element e is now e + joined. `now` (empty) takes over those of
 * `old`, which is left empty. */
void stick_carry(StickStore *old, StickStore *now, int joined);
/* Accepts a step to t: fresh[0 .. n-1] become the records. */
void stick_accept(StickStore *store, double t, int n);
/* Saves or loads all records; `rollers` and `room` as for stick_reserve. */
void stick_checkpoint(Checkpoint *c, StickStore *store, int rollers, int room);
/* Sets the time t of the following evaluations. */
void stick_clock(StickStore *store, double t);

#endif
