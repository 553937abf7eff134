/* The finite-difference twin of surface_blocks: kept to test it. */
#ifndef HAWSER_CONTACT_SURFACE_SURFACE_FD_H
#define HAWSER_CONTACT_SURFACE_SURFACE_FD_H

#include "contact/surface/surface.h"

/* Adds central differences of surface_forces to k and d, as surface_blocks adds derivatives; see forces_fd. */
double surface_blocks_fd(const SurfaceModel *model, const Chain *chain, Kinematics *kin, double friction_scale,
                         SurfacePairs *pairs, double step, double speed_step, BlockChain *k, BlockChain *d);

#endif
