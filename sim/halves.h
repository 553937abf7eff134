/* Loops over a chain in two halves, which are the same for one thread and for two. */
#ifndef HAWSER_SIM_HALVES_H
#define HAWSER_SIM_HALVES_H

#include "core/base/lanes.h"
#include "core/base/team.h"

enum { HALVES_LONG = 1000 }; /* segments from which loops of a few nanoseconds a segment pay on two threads */

/* Segments before it are the first half's. */
static inline int halves_middle(int n) { return n / 2 / LANES * LANES; }

/* Both shares of a job, on two threads if the team has two and it is worth it, or in a row. */
static inline void halves_run(Team *team, int worth, TeamJob job, void *arg)
{
    if (worth && team_size(team) == 2) {
        team_run(team, job, arg);
    } else {
        job(arg, 0);
        job(arg, 1);
    }
}

#endif
