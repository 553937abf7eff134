/* Checks whether the cable has passed through something: the side on which it was of each roller, the free side of each
 * surface, and the triangles of the environment. docs/reference/limits.md, "Trust". */
#ifndef HAWSER_SIM_RUN_PASSING_H
#define HAWSER_SIM_RUN_PASSING_H

#include "contact/self.h"
#include "sim/dynamics.h"

enum { PASSING_SAYS_MAX = 160, OVERLAP_SAYS_MAX = 160 };

/* Largest overlap of cables, or of one with itself, in all checks. */
typedef struct Overlap {
    double share; /* (CC29): 1 where centre lines cross */
    double due;   /* s, time of the next check */
    int looks;    /* 0: not known */
    char says[OVERLAP_SAYS_MAX];
} Overlap;

/* Force by which the chain is pressed into something at t = 0. The height of a segment's arc is proportional to the
 * square of its length, so that a chain of chords begins inside what the line would only touch; a chain in equilibrium
 * does not. */
typedef struct Misfit {
    double force, allowed; /* N: the largest on a roller or surface; the sum of all loads */
    double exponent;       /* of its law (C12) */
    double longest;        /* m, of segments */
    const char *name;      /* of the roller or surface */
} Misfit;

/* A flat roller with the chain near its edge at t = 0. */
typedef struct Edge {
    double share;  /* of half its width; 0: there is none */
    double across; /* m from its middle */
    double half;   /* m, half its width */
    double at;     /* m along the route; NAN: not placed by chainage */
    const char *name;
} Edge;

typedef struct Passing {
    signed char *side; /* [rollers] side of the line, seen along it: the route's, or the cable's when it came near; 0:
                        * unknown */
    char *gone;        /* [rollers + surfaces + 1] 1: passed, and reported; the last one is the environment */
    char *seen;        /* [surfaces][SURFACE_FACES_MAX][segments of the whole chain] 1: was on the face's free side */
    double (*last)[3]; /* [segments of the whole chain] m, centres at the last check, NAN: not yet known; NULL: nothing
                        * of the environment can be touched */
    int through;       /* number of rollers, surfaces and environments that have been passed */
    double due;        /* s, time of the next check */
    char says[PASSING_SAYS_MAX]; /* text on the first of them */
    Misfit start;
    Edge edge;
    Overlap overlap; /* in the first of several chains: that of all */
} Passing;

/* Errors: MEMORY. passing_free may follow either way. */
hawser_status passing_new(Passing *passing, const Scene *scene, hawser_error *err);
void passing_free(Passing *passing);

/* Checks the kinematics and the candidates in the workspace, which belong to the state at t (s); travel: of the head,
 * m. Returns 1 if something has been passed for the first time; `says` has the text then. */
int passing_look(Passing *passing, const Scene *scene, const Workspace *ws, double travel, double t);
/* The same when it is due: a few times a run and at its end; the environment at each call. */
int passing_record(Passing *passing, const Scene *scene, const Workspace *ws, double travel, double t);
/* Finds the overlap of lines, `lines` those of scene[lines->n] at t (s): at every row if there is contact of cable on
 * cable, else a few times a run, and at its end. */
void overlap_record(Overlap *overlap, const SelfLines *lines, const Scene *const scene[], double t);
/* Keeps the sample of t = 0, and the chain's place on its rollers. */
void passing_start(Passing *passing, const Scene *scene, const Kinematics *kin, const hawser_sample *look);
/* Layer of the environment that can be touched and whose triangles the line runs through (EN28), and the place; -1:
 * none. */
int passing_pierced(const Scene *scene, const Kinematics *kin, Vec3 *at);
/* Length of segments, m, with which the contact forces of the chain would not exceed the allowed one (E8): theirs, or
 * less. */
double misfit_segment(const Misfit *start);

#endif
