/* The pull by the place of the cable's front, simulated beside the reference theory: what a planner compares.
 * docs/model.md, "Reel and take-in" (RL18). */
#ifndef HAWSER_SIM_WATCH_POSITION_TABLE_H
#define HAWSER_SIM_WATCH_POSITION_TABLE_H

#include "theory/setup.h"

/* A stretch of the front's way: the time spent there, s, and the integrals over it. */
typedef struct PositionBin {
    double time, front, force, reference;
} PositionBin;

typedef struct ByPosition {
    double from, to; /* m along the route: where the front may be */
    int n_grid;      /* 0: it does not move along the route, there is nothing here */
    double back;     /* N, back tension for which theory was solved */
    double *theory;  /* [n_grid] N, reference at places evenly from..to */
    double *gain;    /* [n_grid] its slope by the back tension */
    double leaves;   /* m, where the end of the cable leaves its drum, and nothing holds it back any more; INFINITY */
    int left;        /* the first place of the grid at which that is so; -1: none */
    int n_bins;
    PositionBin *bin;     /* [n_bins] */
    double last_t;        /* s, of the last look */
    double mean[2];       /* of the reference over the steady window: its integral, N s, and the time, s */
    hawser_position *out; /* [n_bins] */
} ByPosition;

/* Solves the reference theory over the grid. Errors: MEMORY; places where theory has no answer get NAN. */
hawser_status by_position_new(ByPosition *b, const Setup *setup, hawser_error *err);
void by_position_free(ByPosition *b);
/* The reference for the front at s and a back tension (N), N; NAN outside. */
double by_position_reference(const ByPosition *b, double s, double back);
/* Takes in that the rope is pulled with `force` at time t with the front at s, where theory has `reference`; `steady`:
 * it runs at its speed. */
void by_position_record(ByPosition *b, double t, double s, double force, double reference, int steady);
/* The reference's mean over the window so far in which by_position_window was called, N; NAN if it was not. */
double by_position_mean(const ByPosition *b);
/* Takes `reference` (N) into that mean for the last `dt` s. */
void by_position_window(ByPosition *b, double reference, double dt);
/* The bins that have something in them, in order, into b->out; returns how many. */
int by_position_table(const ByPosition *b);

/* The pull with the front at s, m, by a law of theory, for a back tension (N); NAN if theory has none, or no memory,
 * which *no_memory keeps. */
double by_position_theory(const Setup *setup, PullLaw law, double s, double back, int *no_memory);

#endif
