/* Looks at a simulation: what others are shown of its state of now. */
#ifndef HAWSER_SIM_RUN_LOOK_H
#define HAWSER_SIM_RUN_LOOK_H

#include "sim/run/parts.h"

/* A look at the state of now. */
const hawser_sample *sim_look(Sim *s, SampleParts parts);
/* The worst equilibrium so far is the run's. */
void sim_relaxation_take(Sim *s, const hawser_relaxation *found);

#endif
