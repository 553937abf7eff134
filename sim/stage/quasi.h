/* A stage that is moved by positions in steady motion in place of the equations of motion, and back: what changes hands
 * then. Who chooses between them is sim/run/quasi_run.h. docs/model/45-quasi-static.md. */
#ifndef HAWSER_SIM_STAGE_QUASI_H
#define HAWSER_SIM_STAGE_QUASI_H

#include "sim/equipment/winch.h"
#include "sim/stage/positions.h"

typedef struct Quasi {
    const char *why;        /* why positions cannot move this scene; NULL: they can */
    int on;                 /* they do now */
    double *damping;        /* [6][joints of the whole chain] as built, owned; NULL: not asked for */
    IntegratorStats so_far; /* of the integrator, while there is none */
} Quasi;

/* What the scene's motion may be: resolves `auto`, and what `quasi-static` asks for, which it takes to space. Errors:
 * INPUT (it cannot be, and says why), MEMORY. quasi_free may follow. */
hawser_status quasi_new(Quasi *q, Positions *p, const Stage *stage, hawser_error *err);
void quasi_free(Quasi *q);

/* Until when the winch keeps the speed that it has at t, s; at most `end`. t itself: it has none, or loses it now. */
double quasi_steady_until(const Scene *scene, double t, double end);

/* What an attempt can be taken back to: the stage as it was. */
typedef struct Moving {
    int first, n, reel;
    double t, *y; /* owned */
    Vec3 origin;  /* of the winch */
    Quat attitude;
    TakeIn take_in;
} Moving;

/* The integrator ends, its counts stay; springs lose their damping (PS3), and the last shape is where the first
 * position begins. Errors: MEMORY, RUN; moving_free follows either way. */
hawser_status quasi_enter(Quasi *q, Positions *p, Stage *stage, Moving *from, hawser_error *err);
/* Equations of motion again, from the state of now, which is one in motion. Errors: MEMORY. */
hawser_status quasi_leave(Quasi *q, Stage *stage, hawser_error *err);
/* The same from where they were left. Errors: MEMORY, RUN. */
hawser_status quasi_undo(Quasi *q, Stage *stage, const Moving *to, hawser_error *err);
/* Errors: MEMORY; RUN. moving_free follows either way. */
hawser_status moving_keep(Moving *m, const Stage *st, hawser_error *err);
hawser_status moving_restore(Stage *stage, const Moving *to, hawser_error *err);
void moving_free(Moving *from);

/* Springs with their damping, or without. */
void quasi_damping(const Quasi *q, Stage *stage, int present);

#endif
