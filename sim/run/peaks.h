/* What several chains press rollers with together: the force on each is the sum of what they do to it, and its rating
 * is for that. docs/model.md, "Several chains" (SC18). Memory does not grow with the run. */
#ifndef HAWSER_SIM_RUN_PEAKS_H
#define HAWSER_SIM_RUN_PEAKS_H

#include "core/checkpoint.h"
#include "core/vec3.h"
#include "sim/run/stats.h"
#include "sim/scene.h"
#include "sim/time_mean.h"
#include "theory/expected.h"

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
/* Where a run pushes the cable, and with what: the least tension that a joint has for a second of drawing, and while a
 * quarter of a segment passes or for two. What it has for a moment only, of waves, a stop or its place over a roller,
 * is none; nor is what friction, which creeps while nothing is drawn, makes of a cable at rest.
 * docs/model/62-limits.md, (LI12a). */

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
/* The worst of a run that limits ask for and statistics do not keep: tension, sidewall pressure and bend radius of the
 * cable, pull of the rope, tension over each roller. Empty unless the case has limits: then nothing is computed. */

/* m along the route, where the cable's front was at a time, s. */
typedef struct PeakMoment {
    double front, t;
} PeakMoment;

typedef struct Peaks {
    int present;
    int recorded;      /* a sample, or more */
    Peak tension;      /* N, of the cable, eye included */
    Peak sidewall;     /* N/m, T/R of the route's bends, on the worst cable */
    Peak curvature;    /* 1/m, of the cable between neighbouring segments */
    double stands_out; /* 1/m, by which that is more than beside it: what shorter segments may find more of (LI15) */
    Peak rope;         /* N, of the rope, or on its end */
    Peak front;        /* N, at the cable's eye or net */
    double reached;    /* m along the route: how far that has come */
    double speed;      /* m/s, of the winch */
    double push;       /* N, of a machine on the cable, and which: its name is the simulation's */
    const char *pusher;
    Compression pushed; /* where nothing pulls any more */
    int n_rollers;
    double *roller;     /* [n_rollers] N, tension of the cable where it passes the roller; NAN: none yet */
    PeakMoment *when;   /* [n_rollers] when that was so large */
    const Borne *borne; /* of the first of several chains: what all press rollers with; NULL */
} Peaks;

/* The overload factor of eq. 12 at one roller. */
typedef struct Overload {
    const char *name;       /* the scene's */
    double s;               /* m along the route */
    double peak, reference; /* N; reference: at speed, by the reference theory */
    double alpha;           /* peak / reference; NAN where there is no measure */
} Overload;

/* Errors: MEMORY. */
hawser_status peaks_new(Peaks *peaks, const Scene *scene, hawser_error *err);
void peaks_free(Peaks *peaks);
/* Takes a sample in; as stats_record. */
void peaks_record(Peaks *peaks, const Scene *scene, const Kinematics *kin, const hawser_sample *sample);
/* The run so far against the case's limits, (LI5); as hawser_sim_limits. share: the error bar of the largest pull over
 * that. */
int peaks_judge(const Peaks *peaks, const Stats *stats, const Scene *scene, const Expected *expected, double share,
                hawser_limit *out);
/* ------------------------------------------------------------------------------- by theory: peaks_theory.c */

/* Theory with the front where it has come to. Beside a lead-in that of the summary stays with the front where it began.
 */
typedef struct PeaksTheory {
    const Expected *at; /* `own`, or the run's */
    Expected own;       /* its stretch, steps and reference_total alone */
    double needed;      /* N, of the winch: where the front began or came to, whichever is more */
    double beyond;      /* N, by what it pulls more than the cable's front at least (LI11), (LI11a) */
} PeaksTheory;

/* Errors: MEMORY. Give it back with peaks_theory_free. */
hawser_status peaks_theory(const Peaks *peaks, const Stats *stats, const Scene *scene, const Expected *of,
                           PeaksTheory *out, hawser_error *err);
void peaks_theory_free(PeaksTheory *theory);
/* The rollers over which cable has passed and theory has a tension, by the case's order: *out is malloc'ed. Returns how
 * many, -1 without memory. */
int peaks_overload(const Peaks *peaks, const Scene *scene, const PeaksTheory *theory, Overload **out);

#endif
