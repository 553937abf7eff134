/* Resting shape of a position's chain relative to its route, with which the next position begins.
 * docs/theory/44-positions.md (PS8), (PS10), (PS13). */
#ifndef HAWSER_SIM_RUN_POSITIONS_H
#define HAWSER_SIM_RUN_POSITIONS_H

#include "sim/run/stage.h"
#include "sim/solve/relax.h"
#include "theory/setup.h"

typedef struct Lie {
    int n;              /* number of segments; 0: nothing stored yet */
    int faces, patches; /* numbers in the scene's equipment */
    int first, eye;     /* number of segment 0 in the whole chain; joint of the pulling eye, from there */
    double travel;      /* m, of the winch at that time */
    double *memory;     /* for the arrays below */
    double *s;          /* [n] m along the route, rising: places of the segments' centres if laid on the route */
    Vec3 *shift, *turn; /* [n] m, rad: offsets from there */
    Quat *frame;        /* [n] attitudes if laid on the route */
    double *tension;    /* [n] N, mean of a segment's joints */
    Pressed pressed;
} Lie;

void lie_checkpoint(Checkpoint *c, Lie *lie, const Scene *scene);
/* Steady motion of a pull for a row of places of the cable's front, without the motion between them: at each the chain
 * is laid along the route and brought to equilibrium with friction fully developed. docs/theory/44-positions.md. */

/* Offset of the segment that has passed the winch last, by which the winch holds the rope (QS12), (QS15). */
typedef struct Hanging {
    int segment;         /* segment with a known offset; -1: none, all are as laid */
    double ahead;        /* m, along the pull: rope that passes is stretched, and is behind the winch's travel (< 0) */
    Vec3 held, turn;     /* m, rad: offset from the laid place after that shift */
    Vec3 going, turning; /* change of the offset since the segment before; across the pull */
    double lasts;        /* ratio of the next change to this one; 0: unknown */
} Hanging;

typedef struct Positions {
    int n, done;       /* number requested; number found so far, by the simulation's calls */
    double *time;      /* [n] s, times at which the winch has hauled the front there, rising */
    hawser_place *out; /* [room] ordered by time */
    double *station;   /* [room][n_stations] N; NAN where there is no cable */
    int room, n_stations;
    int worst;         /* index of the place with the largest pull; -1: none yet */
    double push_share; /* largest ratio of compression to the largest tension of the same place */
    Lie lie;
    int soft;    /* number of following positions that start from soft contacts, because the last one needed them */
    double back; /* m, distance of its tail behind the laid place */
    Vec3 origin; /* of the winch, as built */
    Quat attitude;
    Hanging hanging;
} Positions;

/* Lists the positions and checks whether each can be in steady motion; sets the scene's duration and steady window to
 * theirs. Does nothing in another analysis. Errors: INPUT with the key to change, MEMORY. positions_free may follow. */
hawser_status positions_new(Positions *p, Stage *stage, hawser_error *err);
void positions_free(Positions *p);
/* Time of the first position after t, or `end` if that comes first. */
double positions_next(const Positions *p, double t, double end);
/* Text that names what the scene has and steady motion does not cover; NULL: nothing. */
const char *positions_unknown(const Stage *stage);
/* m, travel of the winch from which on the end that is fastened to an empty drum holds the chain; INFINITY: never. */
double positions_held_from(const Scene *scene);
/* Initialises for positions without a list; the winch is at its place as built. */
void positions_of(Positions *p, const Stage *stage);
/* Lets the next position begin from the present shape, which moves. Errors: MEMORY. */
hawser_status positions_begin(Positions *p, Stage *stage, hawser_error *err);
/* Lays the chain for time t and finds its steady motion; the stage is then at t. Errors: MEMORY, STOPPED; RUN: there is
 * no steady motion there, or it was not found. */
hawser_status positions_advance(Positions *p, Stage *stage, double t, hawser_relaxation *out, hawser_error *err);
/* Copy of the shape with which the next position begins, while other positions are computed. Errors: MEMORY;
 * positions_back_to frees it either way, and restores it if it was kept. */
typedef struct PositionsKept {
    Lie lie;
    double back;
} PositionsKept;

hawser_status positions_keep(const Positions *p, PositionsKept *out, hawser_error *err);
void positions_back_to(Positions *p, PositionsKept *kept);
/* Next segment to pass the winch whose offset is not known yet; *t: time when it will have passed at the present speed,
 * s; INFINITY: none will. */
int positions_passing(const Positions *p, const Stage *stage, double *t);
/* Finds the position at t, just before `segment` has passed, which gives its offset (QS12). *off: m across the pull,
 * from the extrapolated place. Errors as of positions_advance. */
hawser_status positions_pass(Positions *p, Stage *stage, int segment, double t, hawser_relaxation *out, double *off,
                             hawser_error *err);
/* Records a position found, with its sample. Errors: MEMORY. */
hawser_status positions_record(Positions *p, const Stage *stage, const hawser_sample *look,
                               const hawser_relaxation *found, hawser_error *err);
/* Pull over the place of the cable's front, simulated beside the reference theory, for planning. docs/theory.md, "Reel
 * and take-in" (RL18). */

/* A stretch of the front's way: the time spent there, s, and the integrals over that time. */
typedef struct PositionBin {
    double time, front, force, reference;
} PositionBin;

typedef struct ByPosition {
    double from, to; /* m along the route: range of the front */
    int n_grid;      /* 0: the front does not move along the route; the table is empty */
    double back;     /* N, back tension for which theory was solved */
    double *theory;  /* [n_grid] N, reference at places evenly from..to */
    double *gain;    /* [n_grid] its slope by the back tension */
    double leaves;   /* m, place of the front at which the end of the cable leaves its drum and the back tension ends;
                      * INFINITY: never */
    int left;        /* index of the first place of the grid beyond it; -1: none */
    int n_bins;
    PositionBin *bin;     /* [n_bins] */
    double last_t;        /* s, of the last look */
    double mean[2];       /* reference over the steady window: its integral, N s, and the time, s */
    hawser_position *out; /* [n_bins] */
} ByPosition;

/* Solves the reference theory over the grid. Errors: MEMORY; places without a solution of theory get NAN. */
hawser_status by_position_new(ByPosition *b, const Setup *setup, hawser_error *err);
void by_position_free(ByPosition *b);
/* Reference for the front at s and a back tension (N), N; NAN outside. */
double by_position_reference(const ByPosition *b, double s, double back);
/* Adds a pull `force` at time t with the front at s, where theory has `reference`; `steady`: the winch runs at its
 * speed. */
void by_position_record(ByPosition *b, double t, double s, double force, double reference, int steady);
/* Mean of the reference over the times for which by_position_window was called, N; NAN if never. */
double by_position_mean(const ByPosition *b);
/* Adds `reference` (N) to that mean for the last `dt` s. */
void by_position_window(ByPosition *b, double reference, double dt);
/* Writes the bins that are not empty, in order, into b->out; returns their number. */
int by_position_table(const ByPosition *b);
/* Pull with the front at s, m, by a law of theory, for a back tension (N); NAN if theory has no solution or there is no
 * memory, which *no_memory keeps. */
double by_position_theory(const Setup *setup, PullLaw law, double s, double back, int *no_memory);

#endif
