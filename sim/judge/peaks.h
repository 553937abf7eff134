/* The worst of a run that limits ask for and statistics do not keep: tension, sidewall pressure and bend radius of the
 * cable, pull of the rope, tension over each roller. Empty unless the case has limits: then nothing is computed. */
#ifndef HAWSER_SIM_JUDGE_PEAKS_H
#define HAWSER_SIM_JUDGE_PEAKS_H

#include "sim/judge/compression.h"
#include "sim/watch/borne.h"
#include "sim/watch/stats.h"
#include "theory/expected.h"

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
