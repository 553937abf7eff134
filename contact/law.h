/* Contact force laws with their derivatives: ADAMS' IMPACT and its two-speed friction, as functions of gap
 * and speed. docs/model.md, "Contact". */
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
 * beyond. With d_s > 0 it sticks: docs/model.md, "Friction that sticks". */
typedef struct FrictionLaw {
    double mu_s, mu_d;
    double v_s, v_d; /* m/s, 0 < v_s < v_d */
    double d_s;      /* m, the displacement that calls up all of mu_s; 0: none, friction is of speed alone */
} FrictionLaw;

/* What a law asks of the kernels. */
typedef enum FrictionKind { FRICTION_NONE, FRICTION_SPEED, FRICTION_STICK } FrictionKind;

enum { FRICTION_KINDS = 3 };

FrictionKind friction_kind(const FrictionLaw *law);
/* A coefficient that counts as friction and does nothing: candidates are sorted by the kind, which must not change. */
#define FRICTION_HARDLY_ANY 1e-12
/* So many times the friction (K6); a law without any stays without. */
FrictionLaw friction_scaled(FrictionLaw law, double factor);
/* Normal force N (>= 0) at `gap` (m, negative: penetration) and its rate (m/s). d_gap, d_rate get dN/dgap,
 * dN/drate. */
double impact_force(const ImpactLaw *law, double gap, double rate, double *d_gap, double *d_rate);
/* Friction coefficient at sliding speed v >= 0, divided by v: mu(v)/v (s/m), finite at 0. d_over_v gets
 * (d/dv (mu/v)) / v, finite at 0 too, so that vector friction F = -N phi(v) v_t needs no branch at rest. */
double friction_over_speed(const FrictionLaw *law, double v, double *d_over_v);
/* Forces that contacts are presumed to press with while Newton's method looks for an equilibrium: each contact's law is
 * a straight line about its own, so that a light rope neither flies off the rollers on which it lies nor is thrown back
 * by those that it sinks into. docs/model/44-positions.md (PS11)-(PS13). */
typedef enum PresumeFrom {
    PRESUME_GAPS, /* from the gaps alone, by the law itself */
    PRESUME_LAST, /* from what was pressed in an equilibrium nearby (PS13) */
    PRESUME_LINE  /* from what was presumed, and the gaps to which that has led (PS12) */
} PresumeFrom;

typedef struct Presume {
    PresumeFrom from;
    double gravity; /* m/s2: a contact that closes is presumed to press with its segment's weight at most */
    double keep;    /* share of its force that a contact which has pressed goes on with at least */
} Presume;

/* The force of the spring alone, N, that a contact is presumed to press with. `before`: N, in the equilibrium nearby,
 * or presumed until now (0: it did not press); gap: m, negative: penetration; mass: kg, of its segment. Of surfaces all
 * is for each metre of cable. */
double presume_force(const Presume *how, const ImpactLaw *law, double before, double gap, double mass);
/* What contacts of one kind do to the motion, summed over the contacts of one call; docs/model.md, "Balances". */
typedef struct ContactTally {
    double friction, damping; /* W, what they take out of the motion (BA5) */
    double edges;             /* W, what surfaces' fades do to the motion (BA10) */
    double energy;            /* J, in the springs (BA6) */
    double force[3];          /* N, on the cable */
} ContactTally;

/* What contacts that stick remember between steps: how far each one's bristle leans. docs/model.md, "Friction that
 * sticks".
 *
 * The record of a step is read by every evaluation until the next step is accepted, so forces stay pure functions of
 * (t, y) in between. It is part of a run's state, beside y. */

/* One contact that carried force when the last step was accepted. */
typedef struct StickRecord {
    int roller, face, element;
    int none;  /* 0: a checkpoint holds no bytes between numbers */
    Vec3 lean; /* s, m, world */
} StickRecord;

typedef struct StickStore {
    double since;   /* s, t of the last accepted step */
    double elapsed; /* s from there to the evaluation */
    int n, room;
    StickRecord *record; /* [n], those of a face one behind the other, by element */
    StickRecord *fresh;  /* [room] being collected */
    int n_faces;
    int *first; /* [n_faces] of each face of each roller: its first record, -1 if it has none */
} StickStore;

/* Makes room for `room` records of rollers with two faces each; keeps what is stored. 0 if there is no memory. The free
 * may be called on a zeroed struct. */
int stick_reserve(StickStore *store, int rollers, int room);
void stick_free(StickStore *store);
/* The lean that a contact of this face with this element starts from: that of the nearest element which touched the
 * face, so that a contact that moves on along the cable takes its lean along; zero for a new contact. */
Vec3 stick_kept(const StickStore *store, int roller, int face, int element);
/* The chain has been renumbered: element e is now e + joined. `now` (empty) takes over what `old` stores, which is left
 * empty. */
void stick_carry(StickStore *old, StickStore *now, int joined);
/* A step to t has been accepted: fresh[0 .. n-1] become the records. */
void stick_accept(StickStore *store, double t, int n);
/* All that is remembered; `rollers` and `room` as for stick_reserve. */
void stick_checkpoint(Checkpoint *c, StickStore *store, int rollers, int room);
/* Evaluations that follow are at t. */
void stick_clock(StickStore *store, double t);

#endif
