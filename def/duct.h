/* Several cables in one duct: how they lie, what that does to friction and sidewall pressure, whether they may jam.
 * docs/model.md, "Several cables in a duct", (T19)-(T23), and "Bundles". */
#ifndef HAWSER_DEF_DUCT_H
#define HAWSER_DEF_DUCT_H

#include "hawser/hawser.h"

/* How the cables lie. AUTO: one alone, two side by side, three in a triangle below D/d = 2.5 and cradled from
 * there on, four as a diamond; one that is pulled in beside others that lie there. */
typedef enum DuctLayout {
    DUCT_AUTO,
    DUCT_SINGLE,
    DUCT_PAIR,
    DUCT_TRIANGLE,
    DUCT_CRADLE,
    DUCT_DIAMOND,
    DUCT_BESIDE
} DuctLayout;

/* Cables that lie in a duct already, in a row along its bottom. */
typedef struct DuctLying {
    int cables;      /* 0: it is empty; at most 3 */
    double diameter; /* m, of each */
    double friction; /* of the pulled cable on them over that on the duct */
} DuctLying;

typedef enum JamRisk { JAM_NONE, JAM_VERY_SMALL, JAM_SMALL, JAM_MODERATE, JAM_SIGNIFICANT } JamRisk;

typedef struct DuctDef {
    double duct_diameter;  /* m, inside: D */
    double cable_diameter; /* m, outside: d; of a set of unequal cables the thickest's */
    int cables;            /* 1..4, as thick as that, pulled together */
    DuctLayout layout;
    /* of sets that are not equal cables side by side; zeros: nothing of it */
    int twisted;           /* they are laid up with each other, and neither spread nor jam */
    int thinner;           /* cables beside them that are thinner */
    double thinner_square; /* m2, the sum of the squares of their diameters */
    double jam_diameter;   /* m, mean of the three thickest; 0: d */
    double weight_factor;  /* in place of the layout's; 0: none */
    double oval;           /* how many times as wide bends make the duct, for jamming; 0: 1.05 */
    DuctLying lying;
} DuctDef;

typedef struct DuctLoad {
    DuctLayout layout;
    double weight_factor;   /* w_c >= 1: multiplies mu (or the weight's friction); total weight stays n times
                               one cable's */
    double sidewall_factor; /* of the worst loaded cable: its pressure is this times T/R, T the tension of all
                               together */
    double jam_ratio;       /* `oval` D/d */
    JamRisk jam_risk;       /* three cables in a row; JAM_NONE where there are no three, or they are twisted */
    double clearance;       /* m, from the uppermost cable straight up to the duct */
    double fill;            /* share of the duct's cross-section */
    double room;            /* m, from the duct's centre to the middle of the cables: how far this can move (BU8) */
    double at[2];           /* DUCT_BESIDE: m, from the duct's centre to the pulled cable's, to the right and up */
} DuctLoad;

/* Diameter of the circle round n equal cables, 1..4, over one's: 1, 2, 1 + 2/sqrt 3, 1 + sqrt 2. */
double duct_circle(int cables);

/* Errors: INPUT, with the reason: sizes that are not positive, cables that do not fit, a layout that does not
 * belong to the number of cables or cannot rest in this duct. */
hawser_status duct_load(const DuctDef *def, DuctLoad *out, hawser_error *err);
/* rad, from straight down to the i-th of the lying cables, seen from the centre of a duct of diameter D (m). */
double duct_lying_angle(const DuctLying *lying, double D, int i);
const char *duct_layout_name(DuctLayout layout);
/* How many cables a layout is of; 0: of any number. */
int duct_layout_cables(DuctLayout layout);
const char *jam_risk_name(JamRisk risk);

/* ---- How several cables that are not one lie beside each other when they are laid out (lay.c). docs/model.md,
 * "Several chains" (SC2), (SC3). */

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
