/* The winch's force for every place of the cable's head: rope ahead, cable behind, bends passed one after the other.
 * docs/model.md, "The planner's calculation", (PN5)-(PN7). */
#ifndef HAWSER_THEORY_PLAN_HEAD_H
#define HAWSER_THEORY_PLAN_HEAD_H

#include "theory/plan_pull.h"

/* The pull with the head at one place. */
typedef struct HeadForce {
    double head;    /* m along the route */
    double tension; /* N, of the cable there, at speed */
    double force;   /* N, of the winch at the section's end, the rope's allowance included */
    double restart; /* N, the same from rest */
} HeadForce;

typedef struct HeadSeries {
    int n;
    HeadForce *row; /* [n] in the pull's order: corners of route and equipment, and evenly between; NULL if n is 0 */
    HeadForce peak; /* the largest force at speed, wherever the head is then; between rows too */
    HeadForce restart_peak; /* likewise from rest */
} HeadSeries;

/* One place. Errors: as pull_solve. */
hawser_status plan_head(const PlanDef *def, int way, double head, HeadForce *out, hawser_error *err);
/* All of them; between corners no farther apart than `apart` m (INFINITY: corners only); of more than a thousand
 * corners only some have a row. plan_heads_free gives them back. Errors: as pull_solve, MEMORY; nothing is left
 * allocated then. */
hawser_status plan_heads(const PlanDef *def, int way, double apart, HeadSeries *out, hawser_error *err);
/* The peaks alone, in a time that is linear in the number of corners (but where friction goes by the length that has
 * passed a place): rows are none then. Give it back likewise. */
hawser_status plan_peaks(const PlanDef *def, int way, HeadSeries *out, hawser_error *err);
void plan_heads_free(HeadSeries *s);

/* The most that rope ahead is drawn with at a place, wherever the head is behind it (PN6a). */
typedef struct RopeSeries {
    int way, restart; /* of which pull */
    int n;
    double *s;       /* [n] m along the route, in the pull's order */
    double *tension; /* [n] N */
} RopeSeries;
/* from: m along the route, where the head begins; `apart` as plan_heads'; friction that goes by the length that has
 * passed a place is that of the section's end. Errors: as pull_solve, MEMORY; nothing is left allocated then.
 * plan_rope_free gives it back. */
hawser_status plan_rope(const PlanDef *def, int way, int restart, double from, double apart, RopeSeries *out,
                        hawser_error *err);
void plan_rope_free(RopeSeries *rope);
/* The same with the head at `head` and no farther: writes tension [n] at the places from there to `until`, or to the
 * section's end, all m along the route; the others are left as they are. */
void plan_rope_ahead(const PlanDef *def, const RopeSeries *rope, double head, double until, double *tension);

/* What is drawn over the route: the cable with its pull, or rope ahead of it. */
typedef struct Drawn {
    const Pull *pull;
    const RopeSeries *rope; /* NULL: the cable */
} Drawn;
/* N at s (m along the route); rope that has no tension there, since the head begins behind it: 0. */
double drawn_at(const Drawn *drawn, double s);

/* N, by which the rope ahead pulls at the cable's head by its own weight, so that the winch has less than the head: the
 * most of all places of the head (LI11a). 0: nowhere. Errors: as pull_solve, MEMORY. */
hawser_status plan_relief(const PlanDef *def, int way, double *relief, hawser_error *err);

/* The smallest brake where the pull begins with which the cable is nowhere pushed, and the pull with it (PN8). */
typedef struct Brake {
    double brake;       /* N, on top of what holds back already; 0: none is needed */
    double where;       /* m along the route: there it would be pushed most without */
    int piece;          /* of the route, there */
    double force;       /* N, of the winch with the brake, the head at the end */
    double peak;        /* N, the largest of all places of the head, if the brake is on from the start */
    double max_tension; /* N, of the cable then */
} Brake;
/* Errors: as pull_solve, MEMORY. */
hawser_status plan_brake(const PlanDef *def, int way, Brake *out, hawser_error *err);

#endif
