/* Steady motion of a pull at positions of the cable's front, without the motion that leads there: at each the chain is
 * laid along the route and brought to equilibrium with friction fully developed. docs/model/44-positions.md. */
#ifndef HAWSER_SIM_STAGE_POSITIONS_H
#define HAWSER_SIM_STAGE_POSITIONS_H

#include "sim/stage/lie.h"

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

#endif
