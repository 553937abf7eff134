/* Sums over the contacts of one call, kept lane by lane so that none waits for the one before it; in space and in the
 * plane. docs/model.md, "Balances". */
#ifndef HAWSER_CONTACT_LAW_TALLY_LANES_H
#define HAWSER_CONTACT_LAW_TALLY_LANES_H

#include "contact/law/contact_law.h"
#include "core/base/lanes.h"

typedef struct TallyLanes {
    double friction[LANES], damping[LANES], energy[LANES], force[3][LANES]; /* in the plane force[2] stays zero */
} TallyLanes;

/* Adds lane l of what a push takes out of the motion (friction, damping), holds (energy) and does to the cable (total,
 * of `dims` components). */
static inline void tally_add(TallyLanes *sum, const double *friction, const double *damping, const double *energy,
                             const double total[][LANES], int dims, int l)
{
    sum->friction[l] += friction[l];
    sum->damping[l] += damping[l];
    sum->energy[l] += energy[l];
    for (int c = 0; c < dims; ++c) sum->force[c][l] += total[c][l];
}

static inline ContactTally tally_total(const TallyLanes *sum)
{
    ContactTally total = {0};
    for (int l = 0; l < LANES; ++l) {
        total.friction += sum->friction[l];
        total.damping += sum->damping[l];
        total.energy += sum->energy[l];
        for (int c = 0; c < 3; ++c) total.force[c] += sum->force[c][l];
    }
    return total;
}

#endif
