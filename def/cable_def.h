/* Rigidities of a cable of which only diameter and mass are known, perhaps its conductors too:
 * docs/model/66-cable-stiffness.md. An estimate, not a data sheet: how far it may be off goes with it. */
#ifndef HAWSER_DEF_CABLE_DEF_H
#define HAWSER_DEF_CABLE_DEF_H

/* What is known of a cable. A data sheet has the outside diameter, the mass and the conductors; rigidities it hardly
 * ever has, and nobody measures them for a pull. */
typedef struct CableMake {
    double diameter; /* m, outside */
    double mass;     /* kg/m */
    double area;     /* m2, of one conductor; 0: not known, the metal is guessed from the mass */
    int metal;       /* a ConductorMetal (def/limits.h) */
    int cores;       /* conductors, side by side; 1 if the area is not known */
} CableMake;

/* Rigidities, and what they may be off by either way: the true one lies between value / factor and value * factor. */
typedef struct StiffnessEstimate {
    double ea, ga;    /* N */
    double ei, gj;    /* N m2 */
    double ea_factor; /* 1.3; 2 without conductors */
    double ei_factor; /* at least 2; 3 without conductors (CS5) */
    double metal;     /* m2, of all conductors */
} StiffnessEstimate;

/* (CS1) to (CS7). Bending is what a pull feels of all this: EI lies between strands that slip, each bending by itself,
 * and strands that hold together as one bar; ei is the geometric mean of the two. EA only says how far a cable
 * stretches. Screens, sheaths and armour of metal are not counted where the conductors are known, and counted as copper
 * where they are not. Everything is above 0 for a diameter and a mass above 0 whose powers are. */
StiffnessEstimate stiffness_estimate(const CableMake *c);
/* What a case says of cables and ropes, and of the chain they make: a part of SceneDef (def/scene_def.h). */

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
    int conductor_metal;   /* a ConductorMetal (def/limits.h) */
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

/* What a case says of several chains that are pulled together: parts of SceneDef (def/scene_def.h), which is that
 * of one of them. docs/model.md, "Several chains". */

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
