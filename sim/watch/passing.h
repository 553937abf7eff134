/* Whether the cable has got through something: on which side of each roller it was, and that it is on the free side of
 * each surface. docs/limits.md, "Trust". */
#ifndef HAWSER_SIM_WATCH_PASSING_H
#define HAWSER_SIM_WATCH_PASSING_H

#include "sim/dynamics.h"

enum { PASSING_SAYS_MAX = 160 };

typedef struct Passing {
    signed char *side; /* [rollers] of the line seen along it: where it was when it was last near; 0: it never was */
    char *gone;        /* [rollers + surfaces] has been passed, and was said */
    char *seen;        /* [surfaces][SURFACE_FACES_MAX][segments of the whole chain] was on the face's free side */
    int through;       /* rollers and surfaces that have been passed */
    double due;        /* s, when to look next */
    char says[PASSING_SAYS_MAX]; /* of the first of them; "": none */
} Passing;

/* Errors: MEMORY. passing_free may follow either way. */
hawser_status passing_new(Passing *passing, const Scene *scene, hawser_error *err);
void passing_free(Passing *passing);

/* Looks at the kinematics and the candidates in the workspace, which are of the state at t (s); travel: of the head, m.
 * 1 if something has been passed for the first time, which `says` tells then. */
int passing_look(Passing *passing, const Scene *scene, const Workspace *ws, double travel, double t);
/* The same if it is time: a few times a run and at its end. */
int passing_record(Passing *passing, const Scene *scene, const Workspace *ws, double travel, double t);

#endif
