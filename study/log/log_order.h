/* The readings of a log that are numbers and go on. */
#ifndef HAWSER_STUDY_LOG_LOG_ORDER_H
#define HAWSER_STUDY_LOG_LOG_ORDER_H

#include "study/log/log.h"

typedef struct Kept {
    long n, *at; /* [n] readings, in the order of time */
    long reach;  /* neighbours either way over which speeds are taken */
    double *x;   /* [n] scratch */
    double *v;   /* [n] speed, or what stands for it; NAN: not known */
} Kept;

/* Marks what is no reading: no force, a time (without times: a length) that does not go on, of which the fewest are
 * left out, a single length far off its neighbours (LO1a). Readings of equal time are spread up to the next one. Notes
 * say what is lost and set back. Errors: INPUT (forces, speeds below 0, lengths that run down), MEMORY. */
hawser_status kept_find(PullLog *log, Kept *k, hawser_error *err);
void kept_free(Kept *k);

#endif
