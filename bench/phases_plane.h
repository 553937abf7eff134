/* The phases of a step of the planar chain, for bench_phases: the straight row of rollers in its plane. */
#ifndef HAWSER_BENCH_PHASES_PLANE_H
#define HAWSER_BENCH_PHASES_PLANE_H

#include <sundials/sundials_nvector.h>

#include "sim/run/sample.h"
#include "sim/solve/planar.h"

typedef struct PlaneBench {
    Workspace ws;
    Planar planar;
    SampleBuffers look;
    N_Vector vector[4];     /* state, rates, weights, work */
    double *y, *ydot, *rhs; /* data of the first two; a right-hand side of Newton's system; [6 stride] */
    double t;               /* s */
} PlaneBench;

/* Takes the state in space, y [13 n] at time t, into the plane in which the scene lies. Scene and context are borrowed.
 * Ends the program with a message if there is no memory or no plane. */
void flat_new(PlaneBench *b, const Scene *scene, double t, const double *y, SUNContext context);
void flat_free(PlaneBench *b);

/* One call of each phase, as its namesake in space; blocks, form and factor come before what reads them. */
void flat_kinematics(PlaneBench *b);
void flat_rates(PlaneBench *b);
void flat_contacts(PlaneBench *b);
void flat_refresh(PlaneBench *b);
void flat_blocks(PlaneBench *b);
void flat_form(PlaneBench *b, double gamma);
void flat_factor(PlaneBench *b);
void flat_solve(PlaneBench *b);
void flat_vector(PlaneBench *b, double gamma);
/* About what CVODE does with vectors (state, rates, weights, work) in a step of order 2 that takes one iteration, but
 * for the projection. Ends the program if the norm is not finite. */
void vectors_step(N_Vector vector[4], double gamma);
/* The look at the state that a row of output takes, and what else a state does (SAMPLE_ALL). */
void flat_sample(PlaneBench *b, SampleParts parts);

#endif
