/* What all contacts of a scene are presumed to press with while Newton's method looks for an equilibrium, and what they
 * press with in one. docs/model/44-positions.md (PS11)-(PS13). */
#ifndef HAWSER_SIM_NEWTON_PRESUMPTION_H
#define HAWSER_SIM_NEWTON_PRESUMPTION_H

#include "sim/dynamics.h"

/* What pressed in an equilibrium, by the equipment. */
typedef struct Pressed {
    double *face;  /* [2 rollers] N, by roller and face */
    double *patch; /* [patches] N/m, the mean of those points that press */
} Pressed;

/* Of the kinematics and candidates in the workspace; arrays as above. */
void pressed_find(const Scene *scene, Workspace *ws, const Pressed *out);

typedef struct Presumption {
    double *face, *next; /* [2 rollers] N */
    SurfacePresumed surface[PARTS];
} Presumption;

/* For the kinematics in the workspace: from `last`, an equilibrium nearby (NULL: from the gaps). presumption_free may
 * follow either way. Errors: MEMORY. */
hawser_status presumption_begin(Presumption *p, const Scene *scene, Workspace *ws, const Pressed *last,
                                hawser_error *err);
/* An iteration has led to the kinematics in the workspace. keep: as in Presume. Errors: MEMORY. */
hawser_status presumption_go_on(Presumption *p, const Scene *scene, Workspace *ws, double keep, hawser_error *err);
/* Whether all contacts of the workspace are lines about what is presumed, or their own laws again. Before the free, and
 * before anything but forces and blocks: their own. */
void presumption_use(const Presumption *p, Workspace *ws, int on);
void presumption_free(Presumption *p);

#endif
