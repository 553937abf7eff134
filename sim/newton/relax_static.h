/* Equilibria under loads that change: Newton's method, and the way down from an equilibrium that is not stable.
 * docs/model.md, "Rods" (RD8), (RD20). */
#ifndef HAWSER_SIM_NEWTON_RELAX_STATIC_H
#define HAWSER_SIM_NEWTON_RELAX_STATIC_H

#include "sim/newton/newton.h"

/* What is looked for, and how. */
typedef struct StaticAim {
    double share;       /* the largest unbalanced force as a share of the largest force, though not below rounding */
    double floor;       /* N, what rounding allows: set by the functions below, from where y is at first */
    double dt;          /* s, the step that stands for infinity */
    double radius;      /* m, of inertia on the way down (newton_swell) */
    double turn, shift; /* rad, m: Newton's first step in full, set by relax_static */
} StaticAim;

/* Newton's method alone, for loads that have grown a little since y was an equilibrium (RD8). Adds to out->iterations
 * and sets the rest; y is of no use if it is not reached. Errors: MEMORY. */
hawser_status relax_static(const Scene *scene, Workspace *ws, Newton *newton, double t, StaticAim *aim, double *y,
                           hawser_relaxation *out, hawser_error *err);
/* From anywhere to an equilibrium that is stable, in steps along which the potential falls (RD20): not the nearest
 * equilibrium but the one that lies below. For a matrix that newton_negative can judge. As relax_static. */
hawser_status relax_downhill(const Scene *scene, Workspace *ws, Newton *newton, double t, StaticAim *aim, double *y,
                             hawser_relaxation *out, hawser_error *err);

#endif
