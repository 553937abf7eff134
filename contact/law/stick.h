/* What contacts that stick remember between steps: how far each one's bristle leans. docs/model.md, "Friction that
 * sticks".
 *
 * The record of a step is read by every evaluation until the next step is accepted, so forces stay pure functions of
 * (t, y) in between. It is part of a run's state, beside y. */
#ifndef HAWSER_CONTACT_LAW_STICK_H
#define HAWSER_CONTACT_LAW_STICK_H

#include "core/base/checkpoint.h"
#include "core/base/vec3.h"

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
