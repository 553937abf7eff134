/* Named places of the chain whose motion and forces are wanted. docs/model.md, "Rods" (RD9). */
#ifndef HAWSER_SIM_WATCH_PROBES_H
#define HAWSER_SIM_WATCH_PROBES_H

#include "sim/dynamics.h"

/* One probe: where it sits, and how it lay at t = 0. */
typedef struct ProbePlace {
    int segment, joint; /* of the whole chain; the joint is the nearest */
    double arm;         /* m from the segment's centre along its axis */
    /* What its half of the segment has of the strain that springs hold (RD15); components as in core/chain.h. */
    double share[6];      /* of the motion of the bushing on its side, at the place itself */
    double compliance[6]; /* m/N and rad/(N m) of a metre of cable, 1/EA and so on */
    Vec3 position;        /* m, at t = 0 */
    Quat attitude;
} ProbePlace;

typedef struct Probes {
    int n;
    ProbePlace *place; /* [n] */
    hawser_probe *out; /* [n] */
} Probes;

/* Places the probes of the scene's definition. Errors: MEMORY. */
hawser_status probes_new(Probes *probes, const Scene *scene, hawser_error *err);
void probes_free(Probes *probes);
/* Brings out[] up to date for the kinematics in the workspace at time t (s), whose joint loads it overwrites. */
void probes_look(Probes *probes, const Scene *scene, Workspace *ws, double t);

#endif
