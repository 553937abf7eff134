/* A drum with the cable wound on it, with contact at every turn: for short studies and to check the reel that only pays
 * out. The drum is a roller that spins, with a brake; the layers touch it and each other; the cable's end is held to
 * it. docs/theory.md, "Cable on cable", "A wound drum" (CC22)-(CC26). */
#ifndef HAWSER_SIM_EQUIPMENT_REEL_H
#define HAWSER_SIM_EQUIPMENT_REEL_H

#include "core/chain.h"
#include "core/vec3.h"
#include "def/drive_law.h"
#include "sim/scene.h"

typedef struct Drum {
    int present;
    int roller;   /* the barrel, among the scene's rollers; its two flanges are surfaces */
    int joints;   /* joints 0 .. joints-1 have the places below, the others are along the route */
    Vec3 *joint;  /* [joints], m */
    Vec3 tangent; /* place where the cable leaves the drum at the start, m */
    double hold;  /* N s/m: damping that holds the cable's end on the drum */
    double turns; /* number wound at the start */
} Drum;

/* The reel that pays the cable out. Its drum is not a separate body: the chain's tail segment represents the end of the
 * cable that is just leaving it, moves on the straight line from the drum to the route's start, and carries the drum's
 * inertia and the forces of brake, bearing and back tension. docs/theory.md, "Reel and take-in" (RL6)-(RL15).
 *
 * Segments join behind the tail between two steps (sim/run/stage.h); within a step everything here is a function of (t,
 * y). */

/* The line on which the cable leaves the drum, and what is wound on it behind the present tail segment. */
typedef struct Reel {
    int present; /* 0: there is none, or the cable has left it */
    /* from the case */
    Winding winding;
    Vec3 drum, direction; /* place where the cable leaves the drum, m; direction of the line toward the route */
    Quat attitude;        /* attitude of an untwisted segment on that line */
    Vec3 downhill;        /* m/s2, gravity along the line, as far as the lead-in does not bear it */
    double total;         /* m, the whole cable */
    ReelBrake brake;
    Profile tension; /* N, back tension */
    int fixed;       /* 1: the cable's end stays fastened to the drum */
    Profile braked;  /* share of the case's brake torque, 1 without a command (K5) */
    /* of the tail segment that is leaving the drum, by reel_hold */
    double wound;       /* m, wound behind the segment when its rear end leaves the drum */
    double half;        /* m, half length of the segment */
    double mass;        /* kg, the drum's inertia over the radius squared; part of chain.mass[0] (RL7) */
    int last;           /* 1: nothing is wound behind it */
    double rigidity[3]; /* N m2: torsion, bending about y and z */
    double damping[3];  /* s */
    double catch;       /* N/m, stiffness of the fastened end (RL15) */
} Reel;

/* Figures of a reel. */
typedef struct ReelLook {
    double speed;    /* rad/s */
    double paid_out; /* m */
    double wound;    /* m */
    double tension;  /* N, in the cable where it leaves the drum */
} ReelLook;

/* Sets segment `first` of the whole chain, which consists of this cable, as the tail. */
void reel_hold(Reel *r, const Chain *whole, int first, const CableDef *cable);
/* Force of the drum's brake, bearing and back tension against the pull, at free length l (m) and cable speed v (m/s),
 * N (RL8); friction scales brake and bearing. The derivatives by l and v may be NULL. */
double reel_resistance(const Reel *r, double l, double v, double t, double friction, double *by_l, double *by_v);
/* Computes the reel's figures from the kinematics and the load of joint 1. */
ReelLook reel_look(const Reel *r, const Chain *chain, const Kinematics *kin, const JointLoads *joints, double t);
/* The scene's setup, for theory, with the changes by commands since the scene was built; it borrows from the scene. */
Setup scene_setup(const Scene *scene);

#endif
