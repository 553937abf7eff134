/* What several chains press rollers with together: the force on each is the sum of what they do to it, and its rating
 * is for that. docs/model.md, "Several chains" (SC18). Memory does not grow with the run. */
#ifndef HAWSER_SIM_WATCH_BORNE_H
#define HAWSER_SIM_WATCH_BORNE_H

#include "core/base/checkpoint.h"
#include "core/base/vec3.h"
#include "sim/time_mean.h"

typedef struct Borne {
    int n;                /* rollers */
    TimeMean *load;       /* [n] N */
    double *before, *now; /* [n] N, after the last step but one, and after the last; NAN: none */
    double *steady_error,
        *peak_error; /* [n] N, error bars: the sums of the chains' own, which whoever judges puts in */
} Borne;

/* Nothing has been seen yet. Errors: MEMORY; borne_free follows either way. */
hawser_status borne_new(Borne *borne, int rollers, hawser_error *err);
void borne_free(Borne *borne);

/* A row dt (s) after the last one: on_roller [chains][n], N, as of now. It counts for the means if `steady`; with it a
 * segment has gone by if `block` (EB1). */
void borne_row(Borne *borne, int chains, const Vec3 *const on_roller[], double dt, int steady, int block);

/* A step has ended: whether a load has been held for two steps, falls now and is a peak that no row has seen (EB14),
 * with on_roller about as it is then. If so all are to be looked at, and borne_peak to be told. */
int borne_step(Borne *borne, int chains, const Vec3 *const on_roller[]);
void borne_peak(Borne *borne, int chains, const Vec3 *const on_roller[]);

/* All of it but the bars, both ways. */
void borne_checkpoint(Checkpoint *c, Borne *borne);

#endif
