/* A team of one or two threads that do the same function side by side. The second thread is started once; between jobs
 * it spins briefly, then sleeps. A team of one calls the function and nothing else. */
#ifndef HAWSER_CORE_TEAM_H
#define HAWSER_CORE_TEAM_H

#include "core/lanes.h"

typedef struct Team Team;

/* A share of a job: rank 0 or 1. The shares must not wait for each other: if the second thread does not come in time (a
 * busy machine), the caller does both, one after the other. */
typedef void (*TeamJob)(void *arg, int rank);

/* A team of `threads` (1 or 2); of one if the process may use a single core. NULL if there is no memory or no thread
 * can be created. */
Team *team_new(int threads);
Team *team_free(Team *t);
/* Must be called before a team works again: in a process that was forked after team_new, and has no second thread, it
 * becomes a team of one. */
void team_settle(Team *t);
/* Keeps the second thread off the caller's core, permanently once it has moved; with pin 0 the system decides. */
void team_pin(Team *t, int pin);
/* 1 or 2; NULL is a team of one. */
int team_size(const Team *t);
/* 1 if there is a second thread and it has come in time lately. Otherwise a caller that has a better way than both
 * shares in a row may use that instead of team_run; to be called before every job. */
int team_ready(Team *t);
/* Runs both shares of a job and returns when they are done: their results are visible. Not re-entrant. */
void team_run(Team *t, TeamJob job, void *arg);

enum {
    HALVES_LONG = 1000
}; /* number of segments from which loops of a few nanoseconds per segment pay on two
    * threads */

/* Loops over a chain are split in two halves, the same for one thread and for two: the first half has the segments
 * before it. */
static inline int halves_middle(int n) { return n / 2 / LANES * LANES; }

/* Runs both shares of a job, on two threads if the team has two and it is worth it, or in a row. */
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
