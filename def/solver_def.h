/* How a case is computed: tolerances, order, relaxation, linear solver. See def/scene_def.h. */
#ifndef HAWSER_DEF_SOLVER_DEF_H
#define HAWSER_DEF_SOLVER_DEF_H

#include "linsolve/linsolve.h"

/* Whether a scene that lies in one plane is solved there (sim/planar/plane.h): where it can be; or else it is an error;
 * never.
 */
typedef enum PlanarChoice { PLANAR_AUTO, PLANAR_ON, PLANAR_OFF } PlanarChoice;

/* Whether a whole run may be computed a second time with finer settings: where only numerical errors are left open and
 * it does not take too long; never; however long it takes. */
typedef enum PassesChoice { PASSES_AUTO, PASSES_ONE, PASSES_TWO, PASSES_THREE } PassesChoice;

/* The method of integration in time: backward differences, or Runge-Kutta steps (sim/step/esdirk.h). */
typedef enum MethodChoice { METHOD_AUTO, METHOD_BDF, METHOD_ESDIRK } MethodChoice;

/* What moves the chain: the equations of motion; positions in steady motion wherever that may be (sim/stage/quasi.h);
 * the same, and a scene that cannot be is an error. */
typedef enum MotionChoice { MOTION_DYNAMIC, MOTION_AUTO, MOTION_QUASI_STATIC } MotionChoice;

typedef struct SolverDef {
    double accuracy;                                                /* one number for all tolerances */
    double atol_position, atol_rotation, atol_velocity, atol_omega; /* 0: from accuracy and the scales */
    int max_order;                                                  /* BDF, 1..5 */
    double max_step;                                                /* s, 0: none */
    double first_step;                                              /* s, 0: CVODE's choice */
    long max_steps;                                                 /* 0: none */
    double imperfection;    /* of a cable that is pushed: its bow as a share of a half wave; 0: none */
    int relax;              /* bring to equilibrium before t = 0 */
    double relax_tolerance; /* fraction of the largest segment weight or load */
    int relax_iterations;
    LinOptions linear;
    PlanarChoice planar;
    PassesChoice passes;
    MethodChoice method;
    MotionChoice motion;
    int threads;
} SolverDef;

#endif
