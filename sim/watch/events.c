#include "sim/watch/events.h"

#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"

hawser_status events_add(EventLog *log, double t, const char *what, double pull, hawser_error *err)
{
    if (log->n == EVENTS_MAX) {
        ++log->missed;
        return HAWSER_OK;
    }
    if (log->n == log->room) {
        const int room = 2 * log->room + 8;
        hawser_event *const grown = realloc(log->event, (size_t)room * sizeof *grown);
        if (!grown) return error_memory(err);
        log->event = grown;
        log->room = room;
    }
    log->event[log->n++] = (hawser_event){t, what, pull};
    return HAWSER_OK;
}

void events_free(EventLog *log)
{
    free(log->event);
    memset(log, 0, sizeof *log);
}
