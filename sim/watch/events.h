/* What happened in a run besides that time went by: a short list with times, kept as it grows. */
#ifndef HAWSER_SIM_WATCH_EVENTS_H
#define HAWSER_SIM_WATCH_EVENTS_H

#include "hawser/hawser.h"

enum { EVENTS_MAX = 10000 }; /* kept; later ones are only counted */

typedef struct EventLog {
    int n, room;
    long missed;
    hawser_event *event; /* [n] */
} EventLog;

/* Adds an event: t (s), what (a text that outlives the log), pull (N). Errors: MEMORY. */
hawser_status events_add(EventLog *log, double t, const char *what, double pull, hawser_error *err);
void events_free(EventLog *log);

#endif
