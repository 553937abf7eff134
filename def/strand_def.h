/* What a case says of several chains that are pulled together: parts of SceneDef (def/scene_def.h), which is that
 * of one of them. docs/model.md, "Several chains". */
#ifndef HAWSER_DEF_STRAND_DEF_H
#define HAWSER_DEF_STRAND_DEF_H

#include "def/cable_def.h"

enum { STRANDS_MAX = 24 };
/* The name under which figures of all of them stand: no chain has it. */
#define CHAINS_ALL "all"

/* How a head holds on to the rope that pulls it. */
typedef enum HeadHold {
    HELD_EYE,   /* pinned at its place: it may swing in any direction */
    HELD_BASKET /* clamped: it keeps the rope's direction */
} HeadHold;

/* A chain among several. */
typedef struct StrandDef {
    int present; /* 0: the chain is alone, and lies on the route */
    char name[NAME_MAX_LENGTH];
    double place[2]; /* m from the route, to the left and up: at the route's start if it has a lay */
    double lay;      /* m of the route for a whole turn about it, to the right as it goes on; 0: it lies straight */
    int joined;      /* the chain to whose tail its head is joined; -1: none */
    HeadHold held;
    int rope;   /* so many others are joined to it: */
    int strong; /* of these the thickest, which are pulled together (BU6) */
    int leads;  /* it weighs as much as one of them: it is no rope, but a cable that draws others */
    double eye; /* m, from the heads of these to its tail */
    int swivel; /* of a rope: its first joint transmits no torsion */
} StrandDef;

/* Whether it is a rope alone: others are joined to it, and it is no cable itself. */
static inline int strand_is_rope(const StrandDef *strand) { return strand->rope > 0 && !strand->leads; }

/* What ties chains to each other where they lie side by side. */
typedef struct TiesDef {
    double spacing;   /* m along the route; 0: none */
    double stiffness; /* N/m */
} TiesDef;

#endif
