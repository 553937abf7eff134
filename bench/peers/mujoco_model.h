/* The problems of problem.h as MuJoCo models: what is written into the XML, and what the time loop must know of it. */
#ifndef HAWSER_BENCH_PEERS_MUJOCO_MODEL_H
#define HAWSER_BENCH_PEERS_MUJOCO_MODEL_H

#include <mujoco/mujoco.h>

#include "bench/peers/run.h"

/* How the segments are held together. */
typedef enum Formulation {
    AS_PIECES, /* joints of trees of some segments each; constraints join the trees */
    AS_SPRINGS /* bodies of their own, held together by springs: forces that a call-back adds */
} Formulation;

/* What the settings say; peer_mujoco.c explains them. */
typedef struct Settings {
    Formulation as;
    double dt; /* s */
    const char *integrator, *solver, *cone, *jacobian;
    int iterations;
    double tolerance, impratio;
    double contact_time, link_time, impedance; /* s, s: solref of contacts and of constraints; solimp of both */
    int piece, ball;       /* segments of a tree, 1 .. n; ball joints of the chain and not universal ones */
    double stiff, damping; /* AS_SPRINGS: share of table 1's stiffness; s: C = damping K */
} Settings;

/* The XML, freed by the caller; NULL without memory. Bodies are s0 .. s(n-1); the constraint `winch` holds the head's
 * place along x at its polynomial's constant, and `close` is the last that joins the chain. */
char *model_xml(PeerProblem problem, int n, const Settings *s);

#endif
