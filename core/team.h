/* A team of one or two threads that do the same function side by side. The second thread is started once; between jobs it
 * spins briefly, then sleeps. A team of one calls the function and nothing else. */
#ifndef HAWSER_CORE_TEAM_H
#define HAWSER_CORE_TEAM_H

typedef struct Team Team;

/* Called with rank 0 on the caller's thread and with rank 1 on the other one. */
typedef void (*TeamJob)(void *arg, int rank);

/* A team of `threads` (1 or 2); of one where the process may use a single core, so that it never waits for its own core.
 * NULL if there is no memory or no thread to be had. */
Team *team_new(int threads);
Team *team_free(Team *t);
/* 1 or 2; NULL is a team of one. */
int team_size(const Team *t);
/* Runs job(arg, rank) on every member and returns when all are done: what they wrote is visible. Not re-entrant. */
void team_run(Team *t, TeamJob job, void *arg);
/* Inside a job: no member passes before all have come; what they wrote before is visible after. */
void team_barrier(Team *t, int rank);

#endif
