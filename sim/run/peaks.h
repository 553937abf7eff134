/* Loads of rollers by several chains together: the force on each is the sum of the chains' forces, and its rating
 * applies to the sum. docs/theory.md, "Several chains" (SC18). Memory does not grow with the run. */
#ifndef HAWSER_SIM_RUN_PEAKS_H
#define HAWSER_SIM_RUN_PEAKS_H

#include "core/checkpoint.h"
#include "core/vec3.h"
#include "sim/dynamics.h"
#include "sim/run/stats.h"
#include "sim/scene.h"
#include "sim/time_mean.h"
#include "theory/environment.h"
#include "theory/expected.h"

typedef struct Borne {
    int n;                /* number of rollers */
    TimeMean *load;       /* [n] N */
    double *before, *now; /* [n] N, after the last step but one and after the last; NAN: none */
    double *steady_error,
        *peak_error; /* [n] N, error bounds: sums of the chains' own, written by the caller before judging */
} Borne;

/* Initialises without data. Errors: MEMORY; borne_free follows either way. */
hawser_status borne_new(Borne *borne, int rollers, hawser_error *err);
void borne_free(Borne *borne);
/* Adds a row dt (s) after the last one: on_roller [chains][n], N, at this time. It counts for the means if `steady`;
 * `block`: a segment has passed since the last block (EB1). */
void borne_row(Borne *borne, int chains, const Vec3 *const on_roller[], double dt, int steady, int block);
/* Checks, after a step, for a load that lasted two steps, falls now, and is a peak that no row has recorded (EB14);
 * on_roller is approximate. If so, all chains are to be looked at and borne_peak called. */
int borne_step(Borne *borne, int chains, const Vec3 *const on_roller[]);
void borne_peak(Borne *borne, int chains, const Vec3 *const on_roller[]);
/* Saves or loads everything but the error bounds. */
void borne_checkpoint(Checkpoint *c, Borne *borne);
/* Places and forces of compression in a run: the least tension of a joint that lasts for a second of pulling, and while
 * a quarter of a segment passes or for two seconds. Compression for a moment only, by waves, a stop or a place over a
 * roller, does not count; nor does that by friction, which creeps while nothing is pulled, in a cable at rest.
 * docs/theory/62-limits.md, (LI12a). */

/* A largest value and where it was, m along the route. */
typedef struct Peak {
    double value, at;
} Peak;

/* Least compression that counts, over the largest tension: smaller values come from the mesh. */
static const double PUSHED_ALONG = 0.01;

typedef struct Compression {
    Peak most;          /* N, largest compression beyond the push of machines behind, and its place; 0: none */
    double when;        /* s, its time: the middle of its block */
    double pulled;      /* N, the largest mean of a block */
    double began, last; /* s: beginning of the present block, and time of the last sample */
    double drawn;       /* s of the block during which the winch pulled */
    double travel;      /* m, of the winch at the block's beginning */
    int rows;           /* samples in it */
    int joints, n_pushers;
    double *sum, *time; /* [joints] N s, s: over the block */
    double *force;      /* [n_pushers] N s: push in the block of each that reports a force */
} Compression;

/* Errors: MEMORY. */
hawser_status compression_new(Compression *c, const Scene *scene, hawser_error *err);
void compression_free(Compression *c);
/* Adds a sample. Only cable on the route counts, up to its eye. */
void compression_record(Compression *c, const Scene *scene, const hawser_sample *sample);
/* Largest values of a run that limits need and the statistics do not keep: tension, sidewall pressure and bend radius
 * of the cable, pull of the rope, tension over each roller. Not computed unless the case has limits. */

/* m along the route, place of the cable's front, at a time, s. */
typedef struct PeakMoment {
    double front, t;
} PeakMoment;

typedef struct Peaks {
    int present;
    int recorded;      /* 1: there is at least one sample */
    Peak tension;      /* N, of the cable, eye included */
    Peak sidewall;     /* N/m, T/R of the route's bends, on the worst cable */
    Peak curvature;    /* 1/m, of the cable between neighbouring segments */
    Peak environment;  /* N/m, force per length on models of the environment */
    double stands_out; /* 1/m, excess of that over its neighbours: the part that shorter segments may increase (LI15) */
    Peak rope;         /* N, of the rope, or on its end */
    Peak front;        /* N, at the cable's eye or net */
    double reached;    /* m along the route: farthest place of the front */
    double speed;      /* m/s, of the winch */
    double push;       /* N, largest push of a machine on the cable, and its name, which the simulation owns */
    const char *pusher;
    Compression pushed; /* compression where nothing pulls */
    int n_rollers;
    double *roller;     /* [n_rollers] N, tension of the cable where it passes the roller; NAN: none yet */
    PeakMoment *when;   /* [n_rollers] time of that */
    Clearances clear;   /* distances to the environment */
    const Borne *borne; /* in the first of several chains: loads of rollers by all; else NULL */
} Peaks;

/* The overload factor of eq. 12 at one roller. */
typedef struct Overload {
    const char *name;       /* from the scene */
    double s;               /* m along the route */
    double peak, reference; /* N; reference: at speed, by the reference theory */
    double alpha;           /* peak / reference; NAN where the reference is too small */
} Overload;

/* Errors: MEMORY. */
hawser_status peaks_new(Peaks *peaks, const Scene *scene, hawser_error *err);
void peaks_free(Peaks *peaks);
/* Takes a sample in; as stats_record. */
void peaks_record(Peaks *peaks, const Scene *scene, const Workspace *ws, const hawser_sample *sample);
/* Judges the run so far by the case's limits (LI5), as hawser_sim_limits. share: relative error bound of the largest
 * pull. */
int peaks_judge(const Peaks *peaks, const Stats *stats, const Scene *scene, const Expected *expected, double share,
                hawser_limit *out);
/* ----------------------------------------------------------------------------------------- by theory */

/* Theory with the front at the place that it has reached. With a lead-in, the summary's theory keeps the front at its
 * first place. */
typedef struct PeaksTheory {
    const Expected *at; /* `own`, or the run's */
    Expected own;       /* only its stretch, steps and reference_total */
    double needed;      /* N, of the winch: at the front's first or last place, whichever is more */
    double beyond;      /* N, least excess of its pull over that at the cable's front (LI11), (LI11a) */
} PeaksTheory;

/* Errors: MEMORY. Give it back with peaks_theory_free. */
hawser_status peaks_theory(const Peaks *peaks, const Stats *stats, const Scene *scene, const Expected *of,
                           PeaksTheory *out, hawser_error *err);
void peaks_theory_free(PeaksTheory *theory);
/* Overload factors of the rollers over which cable has passed and for which theory has a tension, in the case's order:
 * *out is malloc'ed. Returns their number, -1 without memory. */
int peaks_overload(const Peaks *peaks, const Scene *scene, const PeaksTheory *theory, Overload **out);

#endif
