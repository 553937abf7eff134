/* How several cables that are not one lie beside each other when they are laid out. docs/model.md, "Several chains"
 * (SC2), (SC3). */
#ifndef HAWSER_THEORY_LAY_H
#define HAWSER_THEORY_LAY_H

typedef enum LayPattern {
    LAY_FLAT,       /* a row */
    LAY_CRADLED,    /* a row along the bottom of a duct */
    LAY_TRIANGULAR, /* two side by side and one on them */
    LAY_RANDOM,     /* anywhere in the duct, none in another */
    LAY_TRIPLEXED   /* round a middle, turning about it */
} LayPattern;

typedef struct LayDef {
    LayPattern pattern;
    double spacing; /* m, from axis to axis of neighbours */
    double radius;  /* m, of the circle in which the axes can be: what a duct leaves; 0: there is none */
    long seed;      /* of LAY_RANDOM */
} LayDef;

/* Places of n axes, m to the left and up of the route: place[n]. 0 if they do not fit. */
int lay_places(const LayDef *lay, int n, double place[][2]);

#endif
