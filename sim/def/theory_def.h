/* What a case says for the pulling theory: its own terms, what it allows, and the rope's allowance, which the dynamics
 * knows too. See sim/def/scene_def.h. */
#ifndef HAWSER_SIM_DEF_THEORY_DEF_H
#define HAWSER_SIM_DEF_THEORY_DEF_H

#include "theory/limits.h"
#include "theory/paper.h"

/* A drag on the rope just ahead of the pulling eye (the paper's rope allowance, eq. 9): force times the friction law's
 * velocity function, against the motion along the segment's axis. */
typedef struct RopeDragDef {
    double force;           /* N; 0: none */
    double v_s, v_d, ratio; /* velocity function: v_s, v_d m/s; ratio = mu_d / mu_s */
} RopeDragDef;

/* What the pulling calculation adds to the scene. */
typedef struct TheoryDef {
    int cables;        /* pulled together, all alike */
    int layout;        /* a DuctLayout: how they lie in ducts */
    double reel, rope; /* m of cable whose weight is added to the tail's tension, and to the drag on the rope */
} TheoryDef;

#endif
