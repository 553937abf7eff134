/* The head of a logger's file: which column is what, and in which unit. */
#ifndef HAWSER_STUDY_LOG_LOG_HEAD_H
#define HAWSER_STUDY_LOG_LOG_HEAD_H

#include "study/log/log_cells.h"

enum { UNIT_TEXT_MAX = 32 };

/* What a column may be, in the order in which it is asked: "pull_t" is a force. */
typedef enum LogColumn { OF_FORCE, OF_SPEED, OF_LENGTH, OF_TIME, OF_DATE, LOG_COLUMNS } LogColumn;

/* Names and units as they stand. */
typedef struct LogHead {
    int line, names, units; /* cells of the row of names, of that of units; 0: not there */
    char *name[CELLS_MAX], *unit[CELLS_MAX];
    int column[LOG_COLUMNS]; /* -1: there is none */
    double scale[LOG_COLUMNS];
} LogHead;

/* Which column is what: by words such as "force", "pull", "Zugkraft" and the unit beside them; of several one that is
 * no setpoint or extreme, of forces that of the winch. Returns whether there is a force and something that it is over.
 */
int head_columns(const Units *units, int n, char *const *name, int column[LOG_COLUMNS]);
/* The scale of a column from its name, or the row of units; clock: a time's unit is not needed. `place` is the head's
 * "file:line". Errors: INPUT (a force or speed without a unit, a unit that is not known). */
hawser_status head_unit(const Units *units, LogHead *h, LogColumn kind, int clock, const char *place, PullLog *log,
                        hawser_error *err);
/* Whether the head or the row of units says that times are "mm:ss". */
int head_has_minutes(const LogHead *h);

#endif
