/* What each of several chains does to the others, as it is looked at: filled by sim/bunch, read by the room of their
 * figures (sim/equipment/chains.c). docs/model.md, "Several chains" (SC11)-(SC14). */
#ifndef HAWSER_SIM_CHAINS_LOOK_H
#define HAWSER_SIM_CHAINS_LOOK_H

#include "sim/def/strand_def.h"

typedef struct ChainLook {
    double pull;      /* N, at its head: of its winch, or what joins it to its rope */
    double share;     /* of the pull of all that are no ropes */
    double between;   /* N/m, the most with which another chain presses on it */
    double walls;     /* N, normal forces of rollers and surfaces on it, their sizes summed */
    double weight;    /* N, of what the route bears of it: behind the start the lead-in does */
    double crossings; /* how often others pass from one side of it to the other along its length */
    double reference; /* N, what theory says of the pull now, with the weight correction of ducts */
    double factor;    /* w_c of the duct in which that is largest; 1 without ducts */
    double twist;     /* rad, by which the others turn about it from tail to head, their mean */
} ChainLook;

typedef struct ChainsLook {
    int n; /* 0: nothing has been looked at */
    ChainLook chain[STRANDS_MAX], all; /* all: sums, the largest, the mean of twists; ropes count with what bears them */
} ChainsLook;

#endif
