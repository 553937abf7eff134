/* What the user sees while a run goes on, on standard error: one live line on a terminal, else a line every
 * tenth of the run. */
#ifndef HAWSER_CLI_PROGRESS_H
#define HAWSER_CLI_PROGRESS_H

#include "hawser/hawser.h"

typedef struct Progress {
    int quiet;                /* say nothing */
    int live;                 /* standard error is a terminal that can rewrite its line */
    int drawn;                /* a live line stands there */
    int tenths;               /* of the run said so far */
    double last_t, last_wall; /* s, of the last call */
    double speed;             /* smoothed simulated seconds a second; 0: not known yet */
} Progress;

void progress_start(Progress *p, int quiet);
/* Shows sample after wall_s seconds of a run that ends at end_s. */
void progress_show(Progress *p, const hawser_sample *sample, double wall_s, double end_s);
/* Clears the live line. */
void progress_end(Progress *p);

#endif
