/* Values that the limits judge beside tension and pressure: rope, winch, machines, brake, trip; the same for theory and
 * runs. docs/theory/62-limits.md. */
#ifndef HAWSER_THEORY_FINDINGS_H
#define HAWSER_THEORY_FINDINGS_H

#include "theory/calculator.h"

/* Speed of the fastest belt with its own speed in the case or its script, m/s; 0: there is none. */
double belts_largest_speed(const SceneDef *def);
/* Sets the findings that follow from the scene itself: belts, the winch's largest speed; marks as absent what the scene
 * does not have. */
void findings_of_scene(const Setup *setup, Finding finding[LIMIT_KINDS]);
/* Finds the trip of the case for a winch that needs `steady` N by itself (theory's winch force: `force`), of which
 * `beyond` belong to the rope. Absent without a winch that has a speed. */
void findings_trip(const Setup *setup, double force, double steady, double beyond, Finding *finding);
/* Solves theory's pull with more tension where it begins. Errors: as pull_solve. */
typedef struct Braked Braked;

struct Braked {
    hawser_status (*solve)(const Braked *b, double more, Pull *out);
    const Route *route;
    double beyond; /* N, force of the winch beyond the pull's end */
    int n_steps;
    const PullStep *step; /* [n_steps]: machines, which push (below 0) the cable ahead of them */
    const void *of;       /* context of `solve` */
};

/* The limit `buckling` without a sufficient push. It exists wherever something may push, in each direction, variation
 * and moment, because rows are compared by index. */
Finding findings_no_push(const Setup *setup);
/* The same for a run with known theory: run-away only. Errors: MEMORY. */
hawser_status findings_of_run(const Setup *setup, const Expected *e, Finding finding[LIMIT_KINDS], hawser_error *err);

#endif
