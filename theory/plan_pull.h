/* One pull of a plan: the cable up to a place on the route and the rope ahead of it, one way, at speed or from rest.
 * docs/model.md, "The planner's calculation", (PN1)-(PN5). */
#ifndef HAWSER_THEORY_PLAN_PULL_H
#define HAWSER_THEORY_PLAN_PULL_H

#include "theory/plan_def.h"

/* Where the pull begins and ends, m along the route. */
double plan_first(const PlanDef *def, int way);
double plan_last(const PlanDef *def, int way);

/* What every winch pulls beside cable and rope on the route (T25), N. */
double plan_allowance(const PlanDef *def, int way);

/* A part of the route that is pulled on its own: from the start or a pit to the next pit or the end. */
typedef struct PlanSection {
    double from, to; /* m along the route, in the pull's order */
    double start;    /* N, the tension at `from` */
    int begins;      /* the step that it begins at, a pit; -1: where the pull begins */
    int ends;        /* likewise; -1: where it ends */
} PlanSection;
/* How many sections there are: one more than pits between start and end. */
int plan_sections(const PlanDef *def, int way);
/* The i-th of them, in the pull's order. */
PlanSection plan_section(const PlanDef *def, int way, int i);
/* The one in which the head is at `head`, m along the route: at a pit the one that ends there. */
PlanSection plan_section_at(const PlanDef *def, int way, double head);

/* What the friction of a stretch is multiplied by at s, with the cable's head at `head`: wear (PN4). */
double plan_friction_factor(const PlanDef *def, int way, double head, double s);

/* The same when it is held back least (the place at which it slackens or runs away first), and whether that is less. */
PlanDef plan_slack(const PlanDef *def);
int plan_slackens(const PlanDef *def);

/* What plan_pull is asked for. */
typedef struct PlanPullDef {
    int way, restart;
    double head;      /* m along the route: cable up to there, rope from there to the end of the section */
    int whole;        /* the whole route, sections and all, with the cable's head at its end; `head` does not count */
    int forces_only;  /* as a PullDef's */
    const Pull *like; /* likewise */
} PlanPullDef;

/* Solves it. Errors: as pull_solve. */
hawser_status plan_pull(const PlanDef *def, const PlanPullDef *what, Pull *out, hawser_error *err);

#endif
