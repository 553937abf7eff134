/* A chain that moves freely: its state is set and read by the suite. In space always, 13 numbers a segment. */
#ifndef HAWSER_VALIDATE_MOTION_H
#define HAWSER_VALIDATE_MOTION_H

#include "core/base/vec3.h"
#include "core/state.h"
#include "sim/stage/stage.h"

/* Builds the stage of t = 0 in space; the definition is taken apart. stage_free must follow if it returns OK. */
hawser_status motion_start(SceneDef *def, Stage *stage, hawser_error *err);
/* Integrates to t (s). */
hawser_status motion_advance(Stage *stage, double t, hawser_error *err);

/* Three entries of the state of segment i: at is STATE_P, STATE_V or STATE_W. */
Vec3 motion_get(const Stage *stage, int at, int i);
void motion_set(Stage *stage, int at, int i, Vec3 value);
Quat motion_attitude(const Stage *stage, int i);
void motion_turn(Stage *stage, int i, Quat attitude);

/* What undamped motion conserves, or gravity alone changes. */
typedef struct Balance {
    double mass;    /* kg */
    Vec3 centre;    /* m, of mass */
    Vec3 momentum;  /* kg m/s */
    Vec3 spin;      /* kg m2/s, about the centre of mass */
    double kinetic; /* J */
    double elastic; /* J, of all bushings */
    double height;  /* J, potential of gravity */
} Balance;
Balance motion_balance(Stage *stage);
/* The bushings' wrenches now, law[0..5][joint] (core/bushing.h). */
double *const *motion_law(Stage *stage);

#endif
