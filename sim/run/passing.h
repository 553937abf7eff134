/* Whether the cable has got through something: on which side of each roller it was, and that it is on the free side of
 * each surface. docs/reference/limits.md, "Trust". */
#ifndef HAWSER_SIM_RUN_PASSING_H
#define HAWSER_SIM_RUN_PASSING_H

#include "contact/self.h"
#include "sim/dynamics.h"

enum { PASSING_SAYS_MAX = 160, OVERLAP_SAYS_MAX = 160 };

/* How far cables have been inside each other, or one inside itself: the worst of all looks. */
typedef struct Overlap {
    double share; /* (CC29): 1 where centre lines cross */
    double due;   /* s, when to look next */
    int looks;    /* 0: it is not known */
    char says[OVERLAP_SAYS_MAX];
} Overlap;

/* How hard the chain is pressed into something at t = 0. A segment's arc is as high as the square of its length, so
 * that a chain of chords begins inside what the line would only touch; what is in equilibrium is not. */
typedef struct Misfit {
    double force, allowed; /* N: the largest on a roller or surface; the sum of all loads */
    double exponent;       /* of its law (C12) */
    double longest;        /* m, of segments */
    const char *name;      /* of the roller or surface */
} Misfit;

/* A flat roller near whose edge the chain lies at t = 0. */
typedef struct Edge {
    double share;  /* of the half of its width; 0: there is none */
    double across; /* m from its middle */
    double half;   /* m, of its width */
    double at;     /* m along the route; NAN: it was placed otherwise */
    const char *name;
} Edge;

typedef struct Passing {
    signed char
        *side;   /* [rollers] of the line, seen along it: the route's, or the cable's when it came near; 0: neither */
    char *gone;  /* [rollers + surfaces] has been passed, and was said */
    char *seen;  /* [surfaces][SURFACE_FACES_MAX][segments of the whole chain] was on the face's free side */
    int through; /* rollers and surfaces that have been passed */
    double due;  /* s, when to look next */
    char says[PASSING_SAYS_MAX]; /* of the first of them */
    Misfit start;
    Edge edge;
    Overlap overlap; /* of several chains the first has that of all */
} Passing;

/* Errors: MEMORY. passing_free may follow either way. */
hawser_status passing_new(Passing *passing, const Scene *scene, hawser_error *err);
void passing_free(Passing *passing);

/* Looks at the kinematics and the candidates in the workspace, which are of the state at t (s); travel: of the head, m.
 * 1 if something has been passed for the first time, which `says` tells then. */
int passing_look(Passing *passing, const Scene *scene, const Workspace *ws, double travel, double t);
/* The same if it is time: a few times a run and at its end. */
int passing_record(Passing *passing, const Scene *scene, const Workspace *ws, double travel, double t);
/* Looks at how far lines lie inside each other, `lines` those of scene[lines->n] at t (s): at every row where there is
 * cable on cable, else a few times a run, and at its end. */
void overlap_record(Overlap *overlap, const SelfLines *lines, const Scene *const scene[], double t);
/* Keeps the sample of t = 0, and where on its rollers the chain lies then. */
void passing_start(Passing *passing, const Scene *scene, const Kinematics *kin, const hawser_sample *look);
/* The length of segments, m, with which the chain would not be pressed by more than is allowed (E8): theirs, or less.
 */
double misfit_segment(const Misfit *start);

#endif
