/* What the figures of a run may be off by: of the steps in time, of the mesh, of friction that vanishes at rest. From
 * what a run sees of itself, without a second one. docs/model.md, "Error bars". */
#ifndef HAWSER_SIM_RUN_STATS_H
#define HAWSER_SIM_RUN_STATS_H

#include "hawser/hawser.h"
#include "sim/run/balance.h"
#include "sim/scene.h"
#include "sim/solve/scales.h"
#include "sim/time_mean.h"
#include "theory/stiffness.h"

/* What all figures of a run share: parts of a force, and of its wavering, 1. */
typedef struct ErrorShares {
    double time;   /* of a mean: what the books of the window leave open or have lost (EB2) */
    double step;   /* of a peak: the tolerance of a step (EB4) */
    double waver;  /* what of a figure's wavering is the mesh's (EB1) */
    double passed; /* of a segment, while nothing has been wavering for a whole one */
    double still;  /* N: what a tension may waver by besides, then (EB9) */
    double placed; /* N: what the places of joints over rollers made of the peak (EB11) */
    double rough;  /* what of second differences is the error of a peak (EB12) */
    double slack,
        at_rest; /* of a peak's height above the mean and above the pull at rest, N, that what hung slack made (EB15) */
    double faded;  /* N: what steps have taken from a swing before the peak (EB23) */
    double blow;   /* N: what the peak owes to segments that a wave must run through, or a clamp holds (EB26), (EB31) */
    double missed; /* N: what rows do not see of a mean (EB33) */
    double drift;  /* of a mean, between the halves of its window, if that is refused (EB17) */
    double start;  /* N: with which a chain that did not come to rest begins inside a body (EB18) */
    double stands_out; /* of a peak: a spike or jolt that is refused (EB16) */
    double mesh;       /* what the places of the route and the head ask of segments (EB3), (EB6) */
    double friction;   /* not yet there at the speed of the pull (EB5) */
    /* by which friction falls once the cable slides, of what is left; m/s, the speed where it has; the share again, if
     * a peak is of a cable that breaks loose (EB10) */
    double falls, falls_until, breaks_loose;
} ErrorShares;

/* books: NULL where nothing has moved; pull: mean of the steady window, N. */
ErrorShares error_shares(const Scene *scene, const Mesh *mesh, const BalanceWindow *books, double pull);
/* What a run is judged by: time-weighted means over the steady window, peaks, and the tension at stations of the route.
 * Memory does not grow with the run. */

/* What is averaged of a roller: its load, N; spin and shift where it moves, rad/s and m. */
typedef struct RollerMeans {
    TimeMean load, spin, shift;
} RollerMeans;

typedef struct SurfaceMeans {
    TimeMean normal, friction; /* N */
} SurfaceMeans;

typedef struct Stats {
    double last_t;      /* s, of the last sample; < 0: none */
    double steady_from; /* s */
    /* of the last sample: whether it was a new one; s since the one before; whether that counts for the means */
    int fresh, steady;
    int block; /* a block of the means has ended with it (EB1) */
    double dt;
    TimeMean pull;    /* N, on the rope's end */
    TimeMean stepped; /* N, the same by steps instead of samples (EB33) */
    double step_t;    /* s, of the last step */
    TimeMean largest; /* N, tension anywhere: its peak alone is asked for */
    TimeMean speed;   /* m/s, axial speed of the cable's first segment that is simulated */
    double passed_at; /* m, travel of the winch at which a block of the means began (EB1) */
    int passing;      /* samples since */
    double passed;    /* of a segment, since; while no block has ended */
    double still;     /* N, of the pull: what segments may make that stand still over rollers (EB9) */
    double placed;    /* N, of the pull when it was largest: what the places of joints over rollers made of it (EB11) */
    double peak_travel, at_rest; /* m, of the winch up to then; N, of the pull at first */
    double peak_speed;           /* m/s, of the slowest segment when the pull was largest */
    Swings swings;               /* of the pull */
    /* up to the largest pull: N, the most that the method takes of a swing (EB23); N and N/s, the rise to it, N where
     * that began, and whether something was met in a steady pull (EB26) */
    double faded, rise, steepest, risen_from;
    int met;
    double clamped; /* N, of the largest pull: what rollers under the segment that the clamp holds made of it (EB31) */
    double settled_at; /* s, last time the speed was more than 2 % off the final speed of the head */
    int n_stations, n_rollers, n_surfaces;
    TimeMean *station; /* [n_stations], N */
    RollerMeans *roller;
    SurfaceMeans *surface;
    hawser_station *station_out;
    hawser_roller *roller_out;
    hawser_surface *surface_out;
    /* peaks between two samples (EB14), [WATCHED + stations + rollers]: what was found after the last step but one, and
     * after the last; and where the stations were at the last sample: behind which joint (-1: there is no cable), and
     * what share of the segment */
    double *before, *now;
    int *station_joint;
    double *station_share;
} Stats;

hawser_status stats_new(Stats *stats, const Scene *scene, hawser_error *err);
void stats_free(Stats *stats);
/* Takes a sample in, of which it reads no positions and attitudes: those are
 * kin's. The tables station_out, roller_out and surface_out are up to date afterwards. */
void stats_record(Stats *stats, const Scene *scene, const Kinematics *kin, const hawser_sample *sample);
/* A step has ended at t with this pull, N; tension [joints simulated] and on_roller [rollers] are about those of its
 * end. Whether one of these has been held for two steps, falls now and is a peak that no sample has seen (EB14): then
 * stats_peak is to be told what a look at the step's end finds, and returns the pull that both steps held, N. */
int stats_step(Stats *stats, const Scene *scene, double t, double pull, const double *tension, const Vec3 *on_roller);
double stats_peak(Stats *stats, const Scene *scene, const Kinematics *kin, const hawser_sample *sample);
/* Loads of rollers between two samples, which count for their peaks alone. */
void stats_raise(Stats *stats, const hawser_sample *sample);
/* Route coordinate of the simulated joint j (0..chain.n), m; travel: of the head, m. */
double along_joint(const Scene *scene, const Kinematics *kin, double travel, int j);
/* Where along the route the pulling eye is now, the cable's front, m; travel: of the head, m. NAN if that is not
 * simulated: it has been taken in. */
double along_eye(const Scene *scene, const Kinematics *kin, double travel);
/* Tension of the cable where it passes route coordinate s, linear between the joints around it. NAN if no cable is
 * there. */
double stats_tension_at(const Scene *scene, const Kinematics *kin, const hawser_sample *sample, double s);
/* Fills what the statistics know into the summary; paper_N and reference_N must be in station_out. */
void stats_summary(const Stats *stats, hawser_summary *out);
/* Brings the error bars of summary and tables up to date. */
void stats_errors(const Stats *stats, const Scene *scene, ErrorShares *shares, hawser_summary *out);

#endif
