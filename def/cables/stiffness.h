/* Rigidities of a cable of which only diameter and mass are known, perhaps its conductors too:
 * docs/model/66-cable-stiffness.md. An estimate, not a data sheet: how far it may be off goes with it. */
#ifndef HAWSER_THEORY_STIFFNESS_H
#define HAWSER_THEORY_STIFFNESS_H

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

#endif
