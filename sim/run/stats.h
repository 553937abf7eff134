/* Error bounds of the figures of a run: by the steps in time, by the mesh, by friction that vanishes at rest. From the
 * data of the run itself, without a second one. docs/theory.md, "Error bars". */
#ifndef HAWSER_SIM_RUN_STATS_H
#define HAWSER_SIM_RUN_STATS_H

#include "hawser/hawser.h"
#include "sim/run/balance.h"
#include "sim/scene.h"
#include "sim/solve/scales.h"
#include "sim/time_mean.h"
#include "theory/stiffness.h"

/* Parts common to all figures of a run: shares of a force, and of its variation, 1. */
typedef struct ErrorShares {
    double time;   /* of a mean: residual of the balances in the window, or their loss (EB2) */
    double step;   /* of a peak: the tolerance of a step (EB4) */
    double waver;  /* part of a figure's variation that is due to the mesh (EB1) */
    double passed; /* of a segment, while no variation over a whole one is known */
    double still;  /* N: further variation of a tension in that case (EB9) */
    double placed; /* N: effect of the places of joints over rollers on the peak (EB11) */
    double rough;  /* part of second differences that is the error of a peak (EB12) */
    double slack,
        at_rest;   /* of a peak's height above the mean and above the pull at rest, N: part due to slack (EB15) */
    double faded;  /* N: loss of an oscillation before the peak to the steps (EB23) */
    double blow;   /* N: part of the peak due to segments through which a wave must run, or that a clamp holds (EB26),
                    * (EB31) */
    double missed; /* N: part of a mean that rows miss (EB33) */
    double drift;  /* of a mean, between the halves of its window, if that condition fails (EB17) */
    double start;  /* N: force by which a chain that did not come to rest begins inside a body (EB18) */
    double stands_out; /* of a peak: a spike or jolt whose condition fails (EB16) */
    double mesh;       /* part due to segment lengths on the route and at the head (EB3), (EB6) */
    double friction;   /* not yet developed at the speed of the pull (EB5) */
    /* relative fall of friction once the cable slides; m/s, the speed at its end; the share again, if a peak belongs to
     * a cable that breaks loose (EB10) */
    double falls, falls_until, breaks_loose;
} ErrorShares;

/* books: NULL if nothing has moved; pull: mean of the steady window, N. */
ErrorShares error_shares(const Scene *scene, const SegmentMesh *mesh, const BalanceWindow *books, double pull);
/* Figures by which a run is judged: time-weighted means over the steady window, peaks, and the tension at stations of
 * the route. Memory does not grow with the run. */

/* Means of a roller: its load, N; spin and shift if it moves, rad/s and m. */
typedef struct RollerMeans {
    TimeMean load, spin, shift;
} RollerMeans;

typedef struct SurfaceMeans {
    TimeMean normal, friction; /* N */
} SurfaceMeans;

typedef struct Stats {
    double last_t;      /* s, of the last sample; < 0: none */
    double steady_from; /* s */
    /* of the last sample: whether it was new; s since the one before; whether that counts for the means */
    int fresh, steady;
    int block; /* 1: a block of the means has ended with it (EB1) */
    double dt;
    TimeMean pull;               /* N, on the rope's end */
    TimeMean stepped;            /* N, the same by steps instead of samples (EB33) */
    double step_t;               /* s, of the last step */
    TimeMean largest;            /* N, tension anywhere: only its peak is used */
    TimeMean speed;              /* m/s, axial speed of the cable's first segment that is simulated */
    double passed_at;            /* m, travel of the winch at which a block of the means began (EB1) */
    int passing;                 /* number of samples since */
    double passed;               /* of a segment, since; while no block has ended */
    double still;                /* N, part of the pull due to segments that stand still over rollers (EB9) */
    double placed;               /* N, part of the largest pull due to the places of joints over rollers (EB11) */
    double peak_travel, at_rest; /* m, of the winch up to the largest pull; N, the pull at first */
    double peak_speed;           /* m/s, of the slowest segment at the largest pull */
    Swings swings;               /* of the pull */
    /* up to the largest pull: N, largest loss of an oscillation to the method (EB23); N and N/s, the rise to it, N at
     * its beginning, and whether something was met in a steady pull (EB26) */
    double faded, rise, steepest, risen_from;
    int met;
    double clamped;    /* N, part of the largest pull due to rollers under the segment that the clamp holds (EB31) */
    double settled_at; /* s, last time the speed was more than 2 % off the final speed of the head */
    int n_stations, n_rollers, n_surfaces;
    TimeMean *station; /* [n_stations], N */
    RollerMeans *roller;
    SurfaceMeans *surface;
    hawser_station *station_out;
    hawser_roller *roller_out;
    hawser_surface *surface_out;
    /* peaks between two samples (EB14), [WATCHED + stations + rollers]: values after the last step but one, and after
     * the last; and the places of the stations at the last sample: the joint before it (-1: there is no cable), and the
     * share of the segment */
    double *before, *now;
    int *station_joint;
    double *station_share;
} Stats;

hawser_status stats_new(Stats *stats, const Scene *scene, hawser_error *err);
void stats_free(Stats *stats);
/* Adds a sample, without its positions and attitudes, which are taken from kin. The tables station_out, roller_out and
 * surface_out are up to date afterwards. */
void stats_record(Stats *stats, const Scene *scene, const Kinematics *kin, const hawser_sample *sample);
/* Called when a step has ended at t with this pull, N; tension [joints simulated] and on_roller [rollers] are
 * approximately those of its end. Checks for a value that lasted two steps, falls now and is a peak that no sample has
 * recorded (EB14): if so, stats_peak is to be called with a look at the step's end; it returns the pull that lasted
 * both steps, N. */
int stats_step(Stats *stats, const Scene *scene, double t, double pull, const double *tension, const Vec3 *on_roller);
double stats_peak(Stats *stats, const Scene *scene, const Kinematics *kin, const hawser_sample *sample);
/* Adds loads of rollers between two samples, which count for their peaks alone. */
void stats_raise(Stats *stats, const hawser_sample *sample);
/* Route coordinate of the simulated joint j (0..chain.n), m; travel: of the head, m. */
double along_joint(const Scene *scene, const Kinematics *kin, double travel, int j);
/* Place along the route of the pulling eye, the cable's front, m; travel: of the head, m. NAN if it is not simulated:
 * it has been taken in. */
double along_eye(const Scene *scene, const Kinematics *kin, double travel);
/* Tension of the cable where it passes route coordinate s, linear between the joints around it. NAN if no cable is
 * there. */
double stats_tension_at(const Scene *scene, const Kinematics *kin, const hawser_sample *sample, double s);
/* Fills the figures of the statistics into the summary; paper_N and reference_N must be in station_out. */
void stats_summary(const Stats *stats, hawser_summary *out);
/* Updates the error bounds of summary and tables. */
void stats_errors(const Stats *stats, const Scene *scene, ErrorShares *shares, hawser_summary *out);

#endif
