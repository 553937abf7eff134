/* How a position's chain lies beside its route, from which the next one's begins. docs/model/44-positions.md (PS8),
 * (PS10), (PS13). */
#ifndef HAWSER_SIM_RUN_POSITIONS_H
#define HAWSER_SIM_RUN_POSITIONS_H

#include "sim/run/stage.h"
#include "sim/solve/relax.h"
#include "theory/setup.h"

typedef struct Lie {
    int n;              /* segments; 0: nothing is known yet */
    int faces, patches; /* of the scene's equipment */
    int first, eye;     /* number of segment 0 in the whole chain; joint of the pulling eye, from there */
    double travel;      /* m, of the winch then */
    double *memory;     /* of what follows */
    double *s;          /* [n] m along the route, of segments' centres as they would be laid, rising */
    Vec3 *shift, *turn; /* [n] m, rad: from there */
    Quat *frame;        /* [n] attitudes as they would be laid */
    double *tension;    /* [n] N, mean of a segment's joints */
    Pressed pressed;
} Lie;

void lie_checkpoint(Checkpoint *c, Lie *lie, const Scene *scene);
/* Steady motion of a pull at positions of the cable's front, without the motion that leads there: at each the chain is
 * laid along the route and brought to equilibrium with friction fully developed. docs/model/44-positions.md. */

/* How the winch holds the rope by the segment that has passed it last (QS12), (QS15). */
typedef struct Hanging {
    int segment;     /* of which it is known; -1: all do as they would be laid */
    double ahead;    /* m, along the pull: rope that passes is stretched, and falls behind what the winch hauls (< 0) */
    Vec3 held, turn; /* m, rad: from where it would be laid so far ahead */
    Vec3 going, turning; /* by so much more than the one before; across the pull */
    double lasts;        /* and so much of that the next one more; 0: nobody knows */
} Hanging;

typedef struct Positions {
    int n, done;       /* wanted; found so far, by the sim's calls */
    double *time;      /* [n] s, when the winch has hauled the front there, rising */
    hawser_place *out; /* [room] by time */
    double *station;   /* [room][n_stations] N; NAN where there is no cable */
    int room, n_stations;
    int worst;         /* place with the largest pull; -1: none yet */
    double push_share; /* the largest compression over the largest tension of the same place */
    Lie lie;
    int soft;    /* so many of the next begin from soft contacts: the last one had to */
    double back; /* m, by which its tail was behind where it was laid */
    Vec3 origin; /* of the winch as it was built */
    Quat attitude;
    Hanging hanging;
} Positions;

/* Which positions there are, and whether each can be in steady motion; sets the scene's duration and steady window to
 * theirs. Nothing of another analysis. Errors: INPUT with the key to change, MEMORY. positions_free may follow. */
hawser_status positions_new(Positions *p, Stage *stage, hawser_error *err);
void positions_free(Positions *p);
/* The first position's time after t, or `end` if that comes first. */
double positions_next(const Positions *p, double t, double end);
/* What steady motion knows nothing of in a stage's scene, in words; NULL: there is nothing of it. */
const char *positions_unknown(const Stage *stage);
/* m of the winch's travel from which on the end that is fastened to an empty drum holds the chain; INFINITY: never. */
double positions_held_from(const Scene *scene);
/* For positions that nobody has listed: where the winch is as it was built. */
void positions_of(Positions *p, const Stage *stage);
/* The next position begins from the shape of now, which moves. Errors: MEMORY. */
hawser_status positions_begin(Positions *p, Stage *stage, hawser_error *err);
/* Lays the chain as it lies at time t and finds its steady motion; the stage is then at t. Errors: MEMORY, STOPPED;
 * RUN: there is no steady motion there, or it was not found. */
hawser_status positions_advance(Positions *p, Stage *stage, double t, hawser_relaxation *out, hawser_error *err);
/* Where the next position begins, while others are looked at. Errors: MEMORY; positions_back_to frees it either way,
 * and begins there again if it was kept. */
typedef struct PositionsKept {
    Lie lie;
    double back;
} PositionsKept;

hawser_status positions_keep(const Positions *p, PositionsKept *out, hawser_error *err);
void positions_back_to(Positions *p, PositionsKept *kept);
/* The next segment to pass the winch of which it is not known yet how it hangs then; *t: when it will have passed, if
 * all goes on as now, s; INFINITY: none will. */
int positions_passing(const Positions *p, const Stage *stage, double *t);
/* The position at t, just before `segment` has passed: how it hangs is known then (QS12). *off: m across the pull, from
 * where it was thought to. Errors as of positions_advance. */
hawser_status positions_pass(Positions *p, Stage *stage, int segment, double t, hawser_relaxation *out, double *off,
                             hawser_error *err);
/* Takes in what was found, with the sample of it. Errors: MEMORY. */
hawser_status positions_record(Positions *p, const Stage *stage, const hawser_sample *look,
                               const hawser_relaxation *found, hawser_error *err);
/* The pull by the place of the cable's front, simulated beside the reference theory: what a planner compares.
 * docs/model.md, "Reel and take-in" (RL18). */

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
