/* Lines, cells, numbers and clocks of a logger's file. */
#ifndef HAWSER_STUDY_LOG_LOG_CELLS_H
#define HAWSER_STUDY_LOG_LOG_CELLS_H

#include "io/yaml/units.h"
#include "study/log/log.h"

enum { CELLS_MAX = 256, WORD_MAX = 64 };

/* The next line, without its end; NULL: there are no more. *at moves behind it. */
char *line_next(char **at);
/* What separates a line's cells: of ';', tab, '|' and ',' outside quotes the first of which it has as many as the next
 * line of `rest`, else the first that it has at all; commas may be decimal, or stand in names. */
char separator_of(const char *line, const char *rest);
/* Cuts a line into cells where it stands; blanks around them go. Returns how many, up to CELLS_MAX. */
int line_cut(char *line, char separator, char *cell[CELLS_MAX]);
/* How many cells there are up to the last that is not empty. */
int cells_filled(int n, char *const *cell);

/* What the points [0] and commas [1] of a column's numbers are, counted in cells. */
typedef struct Marks {
    long decimal[2];    /* it can only be the decimal mark: 0.5, 1,234.5 */
    long thousands[2];  /* it can only stand between thousands: 1.234.567, 1,234.5 */
    long either[2];     /* both: 1.234 */
    long plain, digits; /* no mark; of these with four digits and more, where there would be one between thousands */
    const char *first[2];
    int line[2]; /* the first cell that can be both, and its line */
} Marks;

/* Counts a cell. Returns whether it is a number: a sign, digits with marks, an exponent. Blanks (also those that do not
 * break) and apostrophes stand between thousands. */
int marks_see(Marks *marks, const char *cell, int line);
/* A cell's number; thousands[2]: whether a mark that can be both stands between thousands. NAN: it is none. */
double cell_number(const Units *units, const char *cell, const int thousands[2]);

/* "10:31:07.5", "1:05 PM", also behind a date, in s; NAN: no clock. minutes: of two fields the first has minutes, not
 * hours, as it has where the second has a fraction, "05:07.5". */
double cell_clock(const char *cell, int minutes);
/* Days that log->time, which has clocks, and date[n] ("" where there is none, or what stands before the clock) tell:
 * times go on over midnights, by the dates if they change, else by falls of the clock. A stamp that the next one does
 * not go on from is left where it is. minutes: as above, then by hours. Errors: MEMORY. */
hawser_status clocks_go_on(PullLog *log, const char *const *date, int minutes, hawser_error *err);

#endif
