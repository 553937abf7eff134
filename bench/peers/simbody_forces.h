/* Force elements of our own, as one writes them for Simbody: all rollers in one, all joints in one, the winch. */
#ifndef HAWSER_BENCH_PEERS_SIMBODY_FORCES_H
#define HAWSER_BENCH_PEERS_SIMBODY_FORCES_H

#include "bench/peers/simbody_chain.h"

/* New elements for SimTK::Force::Custom, which owns them. */
SimTK::Force::Custom::Implementation *new_rollers(const Chain &chain);
SimTK::Force::Custom::Implementation *new_winch(const Chain &chain);
/* stiffness: axial, shear (N/m), bending (N m/rad). */
SimTK::Force::Custom::Implementation *new_plane_joints(const Chain &chain, const SimTK::Vec3 &stiffness);

#endif
