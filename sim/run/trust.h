/* Conditions of trust of a run: each has a name, a figure and an allowed value. docs/reference/limits.md, "Trust". A
 * run with a failed condition is never called safe. */
#ifndef HAWSER_SIM_RUN_TRUST_H
#define HAWSER_SIM_RUN_TRUST_H

#include "hawser/hawser.h"
#include "sim/dynamics.h"
#include "sim/run/passing.h"
#include "theory/stiffness.h"

/* Share of half a roller's width by which the cable may be off its middle at rest. */
static const double TRUST_EDGE = 0.7;

/* Largest distance of the cable from its route. */
typedef struct Stray {
    double farthest, at; /* m; m along the route, its place */
    double due;          /* s, time of the next check */
} Stray;

/* Checks the distance when it is due: a few times a run and at its end. travel: of the head, m. */
void stray_record(Stray *stray, const Scene *scene, const Kinematics *kin, double travel, double t);
/* ---- whether the figures of the pull are valid: even over the steady window, and largest while something is pulled */

/* Sums over one half of the steady window. */
typedef struct HalfWindow {
    double pull, time;          /* N s, s */
    double theory, theory_time; /* the same of the reference theory with the front at its present place, while that is
                                 * known */
} HalfWindow;

typedef struct Steadiness {
    HalfWindow half[2];
    double first;         /* s: duration of the first moments; 0: not yet known */
    double jolt, jolt_at; /* N, s: the largest pull in them, and its time */
    double later;         /* N: the largest pull after them */
    double speed;         /* m/s, of the winch at t = 0 */
    double row[2];        /* N: the pull of the last row but one and of the last; -INFINITY: none */
    double peak, beside;  /* N: the largest pull of a row that is followed by another, and the larger of its two
                           * neighbours */
    double peak_at, last; /* s: its time, and that of the last row */
    /* N, N, s: the same of the largest pull between two rows; the row behind it is still to come */
    double held, held_beside, held_at;
    int held_open;
} Steadiness;

/* Adds a sample, dt (s) after the one before. */
void steadiness_record(Steadiness *s, const Scene *scene, const hawser_sample *sample, double dt);
/* Adds a pull between two samples, N, at t. */
void steadiness_held(Steadiness *s, double pull, double t);
/* Difference of the pull between the window's halves, or its difference from the change that theory has as the front
 * moves on, whichever is less: a share of the mean pull, or of a tenth of the largest if that is more. 0 while there is
 * no second half. */
double steadiness_drift(const Steadiness *s);
/* Excess of the largest pull over the rows before and behind it, a share of itself; *at: its time, s. `rests`: the
 * cable came to rest first, and pulls between two rows are left out. */
double steadiness_spike(const Steadiness *s, int rests, double *at);
/* Largest pull of the first moments, N, where it can be a jolt: NAN for a chain that begins at rest and is set in
 * motion gently. */
double steadiness_jolt(const Steadiness *s, int rests);
/* Excess by which the conditions on steadiness fail, shares; 0 where they hold. Used in (EB16), (EB17). */
typedef struct Unsettled {
    double drift;      /* of the mean, between the window's halves */
    double stands_out; /* of the largest pull: a spike above the rows beside it, or the start's jolt above the later
                        * pull */
} Unsettled;

Unsettled steadiness_refused(const Steadiness *s, int rests);
/* Data for the conditions. */
typedef struct TrustFacts {
    const Scene *scene;
    double t, end; /* s, reached and requested */
    const SegmentMesh *mesh;
    double mesh_most; /* largest share of the pull that the mesh adds, by two passes; INFINITY: not known */
    const hawser_relaxation *relaxation;
    const hawser_balance *balance; /* NULL: nothing has moved yet */
    const hawser_summary *figures; /* including their error bounds */
    int n_limits;                  /* the case's limits with these figures; 0: the case has none */
    const hawser_limit *limit;
    int turned;                       /* sim/run/sample.h */
    int unstable;                     /* number of growing motions from an equilibrium of statics; -1: not counted */
    const hawser_quasi_static *still; /* record of the positions that moved the run; NULL: not possible */
    double push_share; /* of positions: largest ratio of compression to the largest tension of the same one */
    Stray stray;
    const Steadiness *steadiness;
    const Passing *passing;
} TrustFacts;

/* Writes the conditions that apply into out [HAWSER_CONDITIONS_MAX]; returns their number. */
int trust_judge(const TrustFacts *facts, hawser_condition *out);
/* HAWSER_CONDITION_ENERGY of "energy" and so on, of a run's conditions; -1: of none. */
int trust_kind(const char *name);
/* ----------------------------------------------------------------------------- belts that share a pull */

/* Sharing by millimetres of cable: its uncertainty is no property of the pull. (WI23) */
typedef struct Sharing {
    double share;            /* of the pull: the part that 0.1 mm of cable moves from one to the other */
    const char *belt;        /* the conveyor, */
    const char *with, *name; /* what it shares with, as text, and its name; "": the winch has none */
} Sharing;

#endif
