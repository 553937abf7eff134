/* The team of a build without threads: the caller alone. */
#include <assert.h>
#include <stdlib.h>

#include "core/team.h"

struct Team {
    char unused;
};

Team *team_new(int threads)
{
    assert(threads == 1 || threads == 2);
    (void)threads;
    return calloc(1, sizeof(Team));
}

Team *team_free(Team *t)
{
    free(t);
    return NULL;
}

void team_settle(Team *t) { (void)t; }

void team_pin(Team *t, int pin) { (void)t, (void)pin; }

int team_size(const Team *t)
{
    (void)t;
    return 1;
}

int team_ready(Team *t)
{
    (void)t;
    return 0;
}

void team_run(Team *t, TeamJob job, void *arg)
{
    (void)t;
    job(arg, 0);
    job(arg, 1);
}
