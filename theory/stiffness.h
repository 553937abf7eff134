/* Rigidities of a cable of which only diameter and mass are known, perhaps its conductors too:
 * docs/model/64-cable-stiffness.md. An estimate, not a data sheet: how far it may be off goes with it. */
#ifndef HAWSER_THEORY_STIFFNESS_H
#define HAWSER_THEORY_STIFFNESS_H

/* What is known of a cable. */
typedef struct CableMake {
    double diameter; /* m, outside */
    double mass;     /* kg/m */
    double area;     /* m2, of one conductor; 0: not known, the metal is guessed from the mass */
    int metal;       /* a ConductorMetal (theory/limits.h) */
    int cores;       /* conductors, side by side; 1 if the area is not known */
} CableMake;

/* Rigidities, and what they may be off by either way: the true one lies between value / factor and value * factor. */
typedef struct StiffnessEstimate {
    double ea, ga; /* N */
    double ei, gj; /* N m2 */
    double ea_factor, ei_factor;
    double metal; /* m2, of all conductors */
} StiffnessEstimate;

/* (CS1) to (CS7). Everything is above 0 for a diameter and a mass above 0. */
StiffnessEstimate stiffness_estimate(const CableMake *make);

#endif
