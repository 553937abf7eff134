/* The relaxation to equilibrium (sim/newton/relax.h) of the planar chain. */
#ifndef HAWSER_SIM_PLANAR_PLANAR_RELAX_H
#define HAWSER_SIM_PLANAR_PLANAR_RELAX_H

#include "sim/planar/planar_dynamics.h"

/* As relax_to_equilibrium, for y [6 stride]. Errors: MEMORY. */
hawser_status planar_relax(Planar *p, double t, double *y, hawser_relaxation *out, hawser_error *err);

#endif
