/* Whether a run is worth judging: named conditions, each with its figure and what is allowed. docs/limits.md, "Trust".
 * A run of which one fails is never called safe. */
#ifndef HAWSER_SIM_WATCH_TRUST_H
#define HAWSER_SIM_WATCH_TRUST_H

#include "hawser/hawser.h"
#include "sim/dynamics.h"
#include "sim/watch/steady.h"

/* How far the cable has been from its route. */
typedef struct Stray {
    double farthest, at; /* m; m along the route, where that was */
    double due;          /* s, when to look next */
} Stray;

/* Looks, if it is time: a few times a run and at its end. travel: of the head, m. */
void stray_record(Stray *stray, const Scene *scene, const Kinematics *kin, double travel, double t);

/* What the conditions are asked of. */
typedef struct TrustFacts {
    const Scene *scene;
    double t, end; /* s, reached and asked for */
    const hawser_relaxation *relaxation;
    const hawser_balance *balance; /* NULL: nothing has moved yet */
    int turned;                    /* sim/watch/events.h */
    Stray stray;
    const Steadiness *steadiness;
} TrustFacts;

/* The conditions that apply, into out [HAWSER_CONDITIONS_MAX]; returns how many. */
int trust_judge(const TrustFacts *facts, hawser_condition *out);

#endif
