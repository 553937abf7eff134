/* What is put before the limits beside tension and pressure: rope, winch, machines, brake, trip. Theory and a run find
 * them alike. docs/model/62-limits.md. */
#ifndef HAWSER_THEORY_FINDINGS_H
#define HAWSER_THEORY_FINDINGS_H

#include "theory/calculator.h"

/* m/s, of the fastest belt with a speed of its own, as the case or its script has it; 0: there is none. */
double belts_largest_speed(const SceneDef *def);
/* What the scene itself says: belts, the winch's largest speed; marks absent what the scene does not have. */
void findings_of_scene(const Setup *setup, Finding finding[LIMIT_KINDS]);
/* The trip that the case sets, of a winch that needs `steady` N by itself (force of the winch by theory: `force`), of
 * which `beyond` are the rope's. Absent without a winch that has a speed. */
void findings_trip(const Setup *setup, double force, double steady, double beyond, Finding *finding);
/* A pull as theory has it, with so much more tension where it begins. Errors: as pull_solve. */
typedef struct Braked Braked;

struct Braked {
    hawser_status (*solve)(const Braked *b, double more, Pull *out);
    const Route *route;
    double beyond; /* N, of the winch beyond the pull's end */
    int n_steps;
    const PullStep *step; /* [n_steps]: machines, which push (below 0) the cable ahead of them */
    const void *of;       /* what `solve` knows */
};

/* The limit `buckling` of a cable that nothing pushes enough. It is there wherever something may push, either way and
 * in every variation and moment: rows are compared one by one, and the last ones were lost without it. */
Finding findings_no_push(const Setup *setup);
/* The same for a run of which theory is known: run-away alone. Errors: MEMORY. */
hawser_status findings_of_run(const Setup *setup, const Expected *e, Finding finding[LIMIT_KINDS], hawser_error *err);

#endif
