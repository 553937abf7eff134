/* Rigidities of a cable with known diameter and mass, perhaps also conductors: docs/theory/66-cable-stiffness.md. An
 * estimate, not a data sheet: it comes with its uncertainty. */
#ifndef HAWSER_DEF_CABLE_DEF_H
#define HAWSER_DEF_CABLE_DEF_H

/* Known data of a cable. A data sheet has the outside diameter, the mass and the conductors, hardly ever rigidities,
 * which are rarely measured for a pull. */
typedef struct CableMake {
    double diameter; /* m, outside */
    double mass;     /* kg/m */
    double area;     /* m2, of one conductor; 0: unknown, the metal is estimated from the mass */
    int metal;       /* a ConductorMetal (def/limits.h) */
    int cores;       /* conductors, side by side; 1 if the area is not known */
} CableMake;

/* Rigidities with uncertainty factors: the true value lies between value / factor and value * factor. */
typedef struct StiffnessEstimate {
    double ea, ga;    /* N */
    double ei, gj;    /* N m2 */
    double ea_factor; /* 1.3; 2 without conductors */
    double ei_factor; /* at least 2; 3 without conductors (CS5) */
    double metal;     /* m2, of all conductors */
} StiffnessEstimate;

/* Estimates rigidities, (CS1) to (CS7). A pull depends mainly on bending: EI lies between strands that slip, each
 * bending by itself, and strands that stick together as one bar; ei is the geometric mean of the two. EA only
 * determines how far a cable stretches. Metal screens, sheaths and armour are not included if the conductors are known,
 * and counted as copper if they are not. All results are above 0 for a diameter and a mass above 0 whose powers are. */
StiffnessEstimate stiffness_estimate(const CableMake *c);
/* Cables and ropes of a case, and the chain they make: a part of SceneDef (def/scene_def.h). */

enum { NAME_MAX_LENGTH = 64 };

/* Moment over curvature at first bending, piecewise linear from the origin, concave; the last piece is extrapolated.
 * Unbending and bending again follow the same curve doubled (HY3). */
enum { BENDING_ROWS_MAX = 8 };

typedef struct BendingTable {
    int rows;                           /* 0: none, bending is elastic; otherwise at least 2 */
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
    double damping_ratio[6];  /* above 0: replaces damping * factor in this component (HY10), (HY12) */
    double damping_ratio_at;  /* Hz, frequency of the ratios; 0: each bushing's own mode */
    double preload[6];        /* N, N m: the wrench of an undeformed bushing, the same components (eq. 1) */
    BendingTable bending;
    double strength;       /* N, a rope's breaking force; 0: not known */
    double conductor_area; /* m2, of one conductor; 0: not known */
    int conductor_metal;   /* a ConductorMetal (def/limits.h) */
    int conductor_cores;
    unsigned estimated; /* CABLE_ESTIMATED_EA and so on: estimated values (CS1) */
} CableDef;

/* Bending moment at first bending to that curvature (1/m) about the stiffer axis, N m; extrapolated beyond the table.
 */
double cable_def_moment(const CableDef *cable, double curvature);
/* Energy lost when a cable with a table of bending is bent to this curvature and straightened again, the area of its
 * loop (HY3), N m per metre; elastic: 0. */
double cable_def_loop(const CableDef *cable, double curvature);
/* Estimated rigidities of a cable with a diameter and a mass, (CS1) to (CS7). */
StiffnessEstimate cable_def_estimate(const CableDef *cable);
/* Choice of rope for a piece. AUTO: the last of several pieces and those of the same kind just before it are rope,
 * unless that is all of them. */
typedef enum RopeChoice { ROPE_AUTO, ROPE_YES, ROPE_NO } RopeChoice;

/* A length of one cable, cut into equal segments. Pieces are listed from the tail to the winch. */
typedef struct ChainPieceDef {
    int cable; /* index into cables */
    double length;
    int segments; /* >= 1 */
    int swivel;   /* the joint to the piece before is an eye with a swivel: it transmits no torsion */
    RopeChoice rope;
} ChainPieceDef;

/* Several chains that are pulled together: parts of SceneDef (def/scene_def.h), which describes one of them.
 * docs/theory.md, "Several chains". */

enum { STRANDS_MAX = 24 };

/* Name for the figures of all chains together: no chain has it. */
#define CHAINS_ALL "all"
/* Connection of a head to the rope that pulls it. */
typedef enum HeadHold {
    HELD_EYE,   /* pinned: it may rotate in any direction */
    HELD_BASKET /* clamped: it keeps the rope's direction */
} HeadHold;

/* A chain among several. */
typedef struct StrandDef {
    int present; /* 0: the chain is alone, and lies on the route */
    char name[NAME_MAX_LENGTH];
    double place[2]; /* m from the route, to the left and up; with a lay, at the route's start */
    double lay;      /* m of the route per turn about it, clockwise in the direction of the route; 0: parallel */
    int joined;      /* the chain to whose tail its head is joined; -1: none */
    HeadHold held;
    int rope;   /* number of chains joined to it: */
    int strong; /* of these the number of thickest ones, which are pulled together (BU6) */
    int leads;  /* it is as heavy as one of them: a cable that pulls others, not a rope */
    double eye; /* m, from the heads of these to its tail */
    int swivel; /* of a rope: its first joint transmits no torsion */
} StrandDef;

/* Checks for a pure rope: others are joined to it, and it is not a cable itself. */
static inline int strand_is_rope(const StrandDef *strand) { return strand->rope > 0 && !strand->leads; }

/* Ties between parallel chains. */
typedef struct TiesDef {
    double spacing;   /* m along the route; 0: none */
    double stiffness; /* N/m */
} TiesDef;

#endif
