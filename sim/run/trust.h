/* Whether a run is worth judging: named conditions, each with its figure and what is allowed. docs/reference/limits.md,
 * "Trust". A run of which one fails is never called safe. */
#ifndef HAWSER_SIM_RUN_TRUST_H
#define HAWSER_SIM_RUN_TRUST_H

#include "hawser/hawser.h"
#include "sim/dynamics.h"
#include "sim/run/passing.h"
#include "theory/stiffness.h"

/* Of half a roller's width, that the cable may lie off its middle at rest. */
static const double TRUST_EDGE = 0.7;

/* How far the cable has been from its route. */
typedef struct Stray {
    double farthest, at; /* m; m along the route, where that was */
    double due;          /* s, when to look next */
} Stray;

/* Looks, if it is time: a few times a run and at its end. travel: of the head, m. */
void stray_record(Stray *stray, const Scene *scene, const Kinematics *kin, double travel, double t);
/* ---- whether the pull is what its figures say: even over the steady window, and largest when something was pulled */

/* What is summed over one half of the steady window. */
typedef struct HalfWindow {
    double pull, time;          /* N s, s */
    double theory, theory_time; /* the same of the reference theory with the front where it is, while it is known */
} HalfWindow;

typedef struct Steadiness {
    HalfWindow half[2];
    double first;         /* s: how long the first moments last; 0: not yet known */
    double jolt, jolt_at; /* N, s: the largest pull in them, and when */
    double later;         /* N: the largest after them */
    double speed;         /* m/s, of the winch at t = 0 */
    double row[2];        /* N: the pull of the last row but one and of the last; -INFINITY: there was none */
    double peak, beside;  /* N: the largest pull of a row that has one behind it, and the larger of the two beside it */
    double peak_at, last; /* s: when that was, and the last row */
    /* N, N, s: the same of the largest pull between two rows; the one behind it is still to come */
    double held, held_beside, held_at;
    int held_open;
} Steadiness;

/* Takes a sample in, dt (s) after the one before. */
void steadiness_record(Steadiness *s, const Scene *scene, const hawser_sample *sample, double dt);
/* A pull that was held between two samples, N, at t. */
void steadiness_held(Steadiness *s, double pull, double t);
/* By how much the pull of the window's second half differs from the first's, or from what theory has it change by as
 * the front goes on, whichever is less: a share of the mean pull, or of a tenth of the largest if that is more. 0 while
 * there is no second half. */
double steadiness_drift(const Steadiness *s);
/* By how much the largest pull stands out of the rows before and behind it, a share of itself; *at: when, s. `rests`:
 * the cable came to rest first, and what is between two rows is not asked. */
double steadiness_spike(const Steadiness *s, int rests, double *at);
/* The largest pull of the first moments, N, where it can be a jolt: NAN of a chain that begins at rest and is set in
 * motion gently. */
double steadiness_jolt(const Steadiness *s, int rests);
/* What the conditions on steadiness refuse, shares; 0 where they hold. Its use: (EB16), (EB17). */
typedef struct Unsettled {
    double drift; /* of the mean, between the window's halves */
    double
        stands_out; /* of the largest pull: a spike above the rows beside it, or the start's jolt above what follows */
} Unsettled;

Unsettled steadiness_refused(const Steadiness *s, int rests);
/* What the conditions are asked of. */
typedef struct TrustFacts {
    const Scene *scene;
    double t, end; /* s, reached and asked for */
    const Mesh *mesh;
    double mesh_most; /* share of the pull that it adds at most by what two passes show; INFINITY: not known */
    const hawser_relaxation *relaxation;
    const hawser_balance *balance; /* NULL: nothing has moved yet */
    const hawser_summary *figures; /* with their error bars */
    int n_limits;                  /* what the case allows, against these figures; 0: it does not say */
    const hawser_limit *limit;
    int turned;                       /* sim/run/sample.h */
    int unstable;                     /* motions that grow from an equilibrium of statics; -1: not counted */
    const hawser_quasi_static *still; /* what positions have moved; NULL: nothing could be */
    double push_share; /* of positions: the largest compression over the largest tension of the same one */
    Stray stray;
    const Steadiness *steadiness;
    const Passing *passing;
} TrustFacts;

/* The conditions that apply, into out [HAWSER_CONDITIONS_MAX]; returns how many. */
int trust_judge(const TrustFacts *facts, hawser_condition *out);
/* "energy" of HAWSER_CONDITION_ENERGY and so on, of a run's conditions. */
const char *trust_name(hawser_condition_kind kind);
/* ---------------------------------------------------------------------------- belts that share a pull: sharing.c */

/* By millimetres of cable: what moves from one to another says nothing of the pull. (WI23) */
typedef struct Sharing {
    double share;            /* of the pull, that 0.1 mm of cable moves from one to the other */
    const char *belt;        /* the conveyor, */
    const char *with, *name; /* what it shares with, in words, and its name; "": the winch has none */
} Sharing;

#endif
