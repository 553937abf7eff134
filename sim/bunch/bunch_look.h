/* What the chains of a bunch do to each other, in figures. */
#ifndef HAWSER_SIM_BUNCH_BUNCH_LOOK_H
#define HAWSER_SIM_BUNCH_BUNCH_LOOK_H

#include "sim/bunch/bunch.h"

/* For the kinematics in the workspaces, which have been looked at: forces of rollers and surfaces are there. Leaves what
 * the last evaluation has counted alone. O(segments + contacts). */
void bunch_look(Bunch *b, ChainsLook *out);
/* look->all from its chains, of which all else is known. */
void bunch_sum(ChainsLook *look);
/* What pulls at the head of chain k, N (SC11). */
double bunch_pull(const Bunch *b, int k);

#endif
