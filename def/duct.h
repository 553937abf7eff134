/* Several cables in one duct: their layout, its effect on friction and sidewall pressure, and the risk of jamming.
 * docs/theory.md, "Several cables in a duct", (T19)-(T23), and "Bundles". */
#ifndef HAWSER_DEF_DUCT_H
#define HAWSER_DEF_DUCT_H

#include "hawser/hawser.h"

/* Layout of the cables. AUTO: one alone, two side by side, three in a triangle below D/d = 2.5 and cradled from
 * there on, four as a diamond; BESIDE: one pulled in beside others that lie there. */
typedef enum DuctLayout {
    DUCT_AUTO,
    DUCT_SINGLE,
    DUCT_PAIR,
    DUCT_TRIANGLE,
    DUCT_CRADLE,
    DUCT_DIAMOND,
    DUCT_BESIDE
} DuctLayout;

/* Cables that already lie in a duct, in a row along its bottom. */
typedef struct DuctLying {
    int cables;      /* 0: it is empty; at most 3 */
    double diameter; /* m, of each */
    double friction; /* friction of the pulled cable on them over that on the duct */
} DuctLying;

typedef enum JamRisk { JAM_NONE, JAM_VERY_SMALL, JAM_SMALL, JAM_MODERATE, JAM_SIGNIFICANT } JamRisk;

typedef struct DuctDef {
    double duct_diameter;  /* m, inside: D */
    double cable_diameter; /* m, outside: d; of a set of unequal cables the thickest's */
    int cables;            /* 1..4, of that diameter, pulled together */
    DuctLayout layout;
    /* for sets other than equal cables side by side; zeros: none */
    int twisted;           /* they are laid up with each other, and neither spread nor jam */
    int thinner;           /* number of thinner cables beside them */
    double thinner_square; /* m2, the sum of the squares of their diameters */
    double jam_diameter;   /* m, mean of the three thickest; 0: d */
    double weight_factor;  /* replaces the layout's; 0: none */
    double oval;           /* widening of the duct in bends, for jamming; 0: 1.05 */
    DuctLying lying;
} DuctDef;

typedef struct DuctLoad {
    DuctLayout layout;
    double weight_factor;   /* w_c >= 1: multiplies mu (or the weight's friction); total weight stays n times
                             * one cable's */
    double sidewall_factor; /* of the worst loaded cable: its pressure is this times T/R with the total
                             * tension T */
    double jam_ratio;       /* `oval` D/d */
    JamRisk jam_risk;       /* three cables in a row; JAM_NONE if there are not three, or they are twisted */
    double clearance;       /* m, from the uppermost cable straight up to the duct */
    double fill;            /* share of the duct's cross-section */
    double room;            /* m, from the duct's centre to the cables' middle: the distance that it can move (BU8) */
    double at[2];           /* DUCT_BESIDE: m, from the duct's centre to the pulled cable's, to the right and up */
} DuctLoad;

/* Diameter of the circle round n equal cables, 1..4, over one's: 1, 2, 1 + 2/sqrt 3, 1 + sqrt 2. */
double duct_circle(int cables);

/* Computes the load of a duct. Errors: INPUT, with the reason: sizes that are not positive, cables that do not fit, a
 * layout that does not belong to the number of cables or cannot rest in this duct. */
hawser_status duct_load(const DuctDef *def, DuctLoad *out, hawser_error *err);
/* Angle from straight down to the i-th of the lying cables, seen from the centre of a duct of diameter D (m), rad. */
double duct_lying_angle(const DuctLying *lying, double D, int i);
const char *duct_layout_name(DuctLayout layout);
/* Number of cables of a layout; 0: any. */
int duct_layout_cables(DuctLayout layout);
const char *jam_risk_name(JamRisk risk);

/* ---- Layout of several separate cables beside each other. docs/theory.md, "Several chains" (SC2), (SC3). */

typedef enum LayPattern {
    LAY_FLAT,       /* a row */
    LAY_CRADLED,    /* a row along the bottom of a duct */
    LAY_TRIANGULAR, /* two side by side and one on them */
    LAY_RANDOM,     /* anywhere in the duct, without overlap */
    LAY_TRIPLEXED   /* round a middle, twisted about it */
} LayPattern;

typedef struct LayDef {
    LayPattern pattern;
    double spacing; /* m, from axis to axis of neighbours */
    double radius;  /* m, of the circle in which the axes can be, by the duct; 0: no duct */
    long seed;      /* of LAY_RANDOM */
} LayDef;

/* Computes the places of n axes, m to the left and up of the route: place[n]. Returns 0 if they do not fit. */
int lay_places(const LayDef *lay, int n, double place[][2]);

#endif
