/* What a case says of cables and ropes, and of the chain they make: a part of SceneDef (def/scene_def.h). */
#ifndef HAWSER_DEF_CABLE_DEF_H
#define HAWSER_DEF_CABLE_DEF_H

#include "def/cables/stiffness.h"

enum { NAME_MAX_LENGTH = 64 };

/* Moment by curvature at first bending, in straight pieces from the origin, concave; the last piece goes on. Unbending
 * and bending again follow the same curve doubled (HY3). */
enum { BENDING_ROWS_MAX = 8 };
typedef struct BendingTable {
    int rows;                           /* 0: none, bending is elastic; otherwise 2 at least */
    double curvature[BENDING_ROWS_MAX]; /* 1/m, rising, above 0 */
    double moment[BENDING_ROWS_MAX];    /* N m, above 0 and not falling */
} BendingTable;

enum { CABLE_ESTIMATED_EA = 1, CABLE_ESTIMATED_GA = 2, CABLE_ESTIMATED_GJ = 4, CABLE_ESTIMATED_EI = 8 };

/* A kind of cable or rope, per unit length. */
typedef struct CableDef {
    char name[NAME_MAX_LENGTH];
    double ea, ga;            /* N */
    double gj;                /* N m2 */
    double ei_y, ei_z;        /* N m2; with a table of bending, its first slope */
    double mass;              /* kg/m */
    double diameter;          /* m, outside: contact and rotary inertia */
    double gyration;          /* m, radius of gyration of the cross-section about a diameter; 0: a quarter diameter */
    double damping;           /* s: C = damping * factor * K */
    double damping_factor[6]; /* axial, shear y, shear z, torsion, bending y, bending z */
    double damping_ratio[6];  /* above 0: takes the place of damping * factor in this component (HY10), (HY12) */
    double damping_ratio_at;  /* Hz, where the ratios hold; 0: in each bushing's own mode */
    double preload[6];        /* N, N m: the wrench of an undeformed bushing, the same components (eq. 1) */
    BendingTable bending;
    double strength;       /* N, a rope's breaking force; 0: not known */
    double conductor_area; /* m2, of one conductor; 0: not known */
    int conductor_metal;   /* a ConductorMetal (def/codes.h) */
    int conductor_cores;
    unsigned estimated; /* CABLE_ESTIMATED_EA and so on: what nobody gave (CS1) */
} CableDef;

/* N m, in a bend of that curvature (1/m) at first bending, about the stiffer axis; straight on behind the table. */
double cable_def_moment(const CableDef *cable, double curvature);
/* N m for each metre of a cable with a table of bending that is bent so far and straightened again: what its loop
 * encloses (HY3); elastic: 0. */
double cable_def_loop(const CableDef *cable, double curvature);

/* What would be estimated of the rigidities of a cable that has a diameter and a mass (CS1) to (CS7). */
StiffnessEstimate cable_def_estimate(const CableDef *cable);

/* Whether a piece is rope. Where nobody says so: the last of several and those before it of the same kind, unless that
 * is all of them. */
typedef enum RopeChoice { ROPE_AUTO, ROPE_YES, ROPE_NO } RopeChoice;

/* A length of one cable, cut into equal segments. Pieces follow each other from the tail to the winch. */
typedef struct ChainPieceDef {
    int cable; /* index into cables */
    double length;
    int segments; /* >= 1 */
    int swivel;   /* the joint to the piece before is an eye with a swivel: it transmits no torsion */
    RopeChoice rope;
} ChainPieceDef;

#endif
