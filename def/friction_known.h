/* Where a coefficient of friction comes from: what is judged by it depends on that. */
#ifndef HAWSER_DEF_FRICTION_KNOWN_H
#define HAWSER_DEF_FRICTION_KNOWN_H

/* The case gives it; it is typical of what is named (an entry of the catalogue, rollers); nothing is known of it. */
typedef enum FrictionSource { FRICTION_GIVEN, FRICTION_TYPICAL, FRICTION_UNKNOWN } FrictionSource;

/* All zeros: given. */
typedef struct FrictionKnown {
    FrictionSource source;
    double low, high; /* FRICTION_TYPICAL: between which the coefficient in motion usually lies */
    char of[64];      /* FRICTION_TYPICAL: of what */
    int rest_assumed; /* one coefficient stands for motion and rest */
    char key[40];     /* of the section that gives it, or would: "surfaces.ducts.0.friction"; empty: "friction" */
} FrictionKnown;

#endif
