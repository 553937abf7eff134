/* The figures of machines that rooms keep (sim/room.h, MachineKind): now, and means and peaks of the run. */
#ifndef HAWSER_SIM_WATCH_MACHINES_H
#define HAWSER_SIM_WATCH_MACHINES_H

#include "hawser/hawser.h"
#include "sim/dynamics.h"

/* What is kept of one machine. */
typedef struct MachineRecord {
    const Room *room;
    int item;
    double expected; /* N, NAN: theory knows nothing of it */
    double value[MACHINE_KEPT_MAX];
    TimeMean kept[MACHINE_KEPT_MAX];
    hawser_figure figure[MACHINE_FIGURES_MAX];
} MachineRecord;

struct Expected; /* theory/expected.h */

typedef struct Machines {
    int n;
    MachineRecord *record; /* [n] owned */
    hawser_machine *out;   /* [n] owned: what others see of them */
    int n_now;
    hawser_figure *now; /* [n_now] owned: theirs one after the other */
} Machines;

/* All machines of a scene, kind by kind; expected: theory's pushes. Errors: MEMORY. */
hawser_status machines_new(Machines *m, const Scene *scene, const struct Expected *expected, hawser_error *err);
void machines_free(Machines *m);
/* Their figures of now, for the kinematics in the workspace. */
void machines_look(Machines *m, const Scene *scene, Workspace *ws, double t);
/* Takes these in, dt (s) after the last ones; they count for the means if `steady`. */
void machines_record(Machines *m, double dt, int steady);

#endif
