/* A measured pull: the winch's force over time or length, as a logger wrote it, and what of it can be relied on.
 * docs/guide/studies-and-measured-pulls.md; docs/model/96-measured-pulls.md. */
#ifndef HAWSER_STUDY_LOG_H
#define HAWSER_STUDY_LOG_H

#include "hawser/hawser.h"
#include "io/case/units.h"

/* What a reading is good for. */
typedef enum LogUse {
    LOG_MOVING,  /* a pull at speed */
    LOG_RESTART, /* the largest force of a start: what it takes to break away */
    LOG_AT_REST, /* the winch stands, or is only just moving */
    LOG_LOST,    /* no number, or time that does not go on */
    LOG_DROPPED, /* a drop-out: no force in the midst of a pull */
    LOG_SPIKE,   /* far off its neighbours */
    LOG_USES
} LogUse;

enum { LOG_NOTES = 10, LOG_NOTE_MAX = 240, LOG_NOTES_MAX = LOG_NOTES * (LOG_NOTE_MAX + 2) };

typedef struct PullLog {
    long n;
    int has_time, has_length, has_speed;   /* columns that the file has */
    double *time, *length, *speed, *force; /* [n] s, m, m/s, N; NAN: not known */
    int *line;                             /* [n] of the file */
    unsigned char *use;                    /* [n] a LogUse */
    long count[LOG_USES];
    long starts; /* behind a rest */
    long begin;  /* the last reading at rest before the first motion, else the first that counts; -1: there is none */
    int from_rest, n_notes;             /* whether it is at rest there */
    char note[LOG_NOTES][LOG_NOTE_MAX]; /* sentences: which columns were taken, what was assumed */
} PullLog;

/* Reads a CSV file: the first row in which a force and a time or length are recognised, and no row below it before the
 * readings, names the columns. Nothing is judged yet. Errors: INPUT with file and line (no such row, a force without a
 * unit, rows with more cells than the head, marks that may be decimal or not, no readings), MEMORY. */
hawser_status log_read(const char *path, PullLog *log, hawser_error *err);
void log_free(PullLog *log);
/* Says what each reading is good for, (LO1)-(LO3), and fills lengths that the file does not have: from speed and time,
 * or from `speed` (m/s; NAN: not known) and the time that it moved. raw: spikes and drop-outs are taken as they are.
 * Errors: INPUT (nothing moves, lengths that run down, forces below 0), MEMORY. */
hawser_status log_judge(PullLog *log, double speed, int raw, hawser_error *err);
/* A note behind the others, or before them: what weighs most. */
void log_say(PullLog *log, const char *format, ...) __attribute__((format(printf, 2, 3)));
void log_say_first(PullLog *log, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* All notes in one text, as programs read them. */
void log_notes(int n, const char note[][LOG_NOTE_MAX], char text[LOG_NOTES_MAX]);
/* Means of readings at speed over equal parts of an axis, and starts one by one. */
typedef struct LogPoint {
    double at, force; /* where, by the axis; N */
    int restart;      /* a start; else a mean of `readings` */
    long readings;
} LogPoint;

/* axis[n]: where each reading is, NAN: nowhere. Points between from and to, at most `bins` and the starts; by rising
 * place. Returns how many, -1 without memory; *point is the caller's. */
int log_points(const PullLog *log, const double *axis, double from, double to, int bins, LogPoint **point);
/* ------------------------------------------- what log_judge.c asks of log_order.c: the readings that are numbers and
 * go on */

typedef struct LogKept {
    long n, *at; /* [n] readings, in the order of time */
    long reach;  /* neighbours either way over which speeds are taken */
    double *x;   /* [n] scratch */
    double *v;   /* [n] speed, or what stands for it; NAN: not known */
} LogKept;

/* Marks what is no reading: no force, a time (without times: a length) that does not go on, of which the fewest are
 * left out, a single length far off its neighbours (LO1a). Readings of equal time are spread up to the next one. Notes
 * say what is lost and set back. Errors: INPUT (forces, speeds below 0, lengths that run down), MEMORY. */
hawser_status log_kept_find(PullLog *log, LogKept *k, hawser_error *err);
void log_kept_free(LogKept *k);
/* Lines, cells, numbers and clocks of a logger's file. */

enum { CELLS_MAX = 256, WORD_MAX = 64 };

/* Cuts a line into cells where it stands; blanks around them go. Returns how many, up to CELLS_MAX. */
int line_cut(char *line, char separator, char *cell[CELLS_MAX]);
/* What the points [0] and commas [1] of a column's numbers are, counted in cells. */
typedef struct Marks {
    long decimal[2];    /* it can only be the decimal mark: 0.5, 1,234.5 */
    long thousands[2];  /* it can only stand between thousands: 1.234.567, 1,234.5 */
    long either[2];     /* both: 1.234 */
    long plain, digits; /* no mark; of these with four digits and more, where there would be one between thousands */
    const char *first[2];
    int line[2]; /* the first cell that can be both, and its line */
} Marks;

/* The head of a logger's file: which column is what, and in which unit. */

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

#endif
