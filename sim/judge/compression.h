/* Where a run pushes the cable, and with what: the least tension that a joint has for a second of drawing, and while a
 * quarter of a segment passes or for two. What it has for a moment only, of waves, a stop or its place over a roller,
 * is none; nor is what friction, which creeps while nothing is drawn, makes of a cable at rest.
 * docs/model/62-limits.md, (LI12a). */
#ifndef HAWSER_SIM_JUDGE_COMPRESSION_H
#define HAWSER_SIM_JUDGE_COMPRESSION_H

#include "sim/scene.h"

/* A largest value and where it was, m along the route. */
typedef struct Peak {
    double value, at;
} Peak;

/* What the cable may be pushed with along its way, over its largest tension: less is the mesh's, not the pull's. */
static const double PUSHED_ALONG = 0.01;

typedef struct Compression {
    Peak most;          /* N that push beyond what machines behind push with, and where; 0: none */
    double when;        /* s, of that: the middle of its block */
    double pulled;      /* N, the largest mean of a block */
    double began, last; /* s: the block that is being summed began, and the last sample */
    double drawn;       /* s of it, while the winch drew */
    double travel;      /* m, of the winch when it began */
    int rows;           /* samples in it */
    int joints, n_pushers;
    double *sum, *time; /* [joints] N s, s: of the block */
    double *force;      /* [n_pushers] N s: with which each that says so has pushed in it */
} Compression;

/* Errors: MEMORY. */
hawser_status compression_new(Compression *c, const Scene *scene, hawser_error *err);
void compression_free(Compression *c);
/* Takes a sample in. Only cable on the route counts, up to its eye. */
void compression_record(Compression *c, const Scene *scene, const hawser_sample *sample);

#endif
