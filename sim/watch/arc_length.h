/* Where along the route the chain is now. */
#ifndef HAWSER_SIM_WATCH_ARC_LENGTH_H
#define HAWSER_SIM_WATCH_ARC_LENGTH_H

#include "sim/scene.h"

/* Route coordinate of the simulated joint j (0..chain.n), m; travel: of the winch, m. */
double along_joint(const Scene *scene, const Kinematics *kin, double travel, int j);
/* The same of the pulling eye, the cable's front; NAN if that is not simulated: it is past the winch. */
double along_eye(const Scene *scene, const Kinematics *kin, double travel);

#endif
