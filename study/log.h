/* A measured pull: the winch's force over time or length, as a logger wrote it, and which readings are reliable.
 * docs/guide/studies-and-measured-pulls.md; docs/theory/96-measured-pulls.md. */
#ifndef HAWSER_STUDY_LOG_H
#define HAWSER_STUDY_LOG_H

#include "hawser/hawser.h"
#include "io/case/units.h"

/* Use of a reading. */
typedef enum LogUse {
    LOG_MOVING,  /* steady pull */
    LOG_RESTART, /* the largest force of a start: the break-away force */
    LOG_AT_REST, /* the winch stands, or only starts to move */
    LOG_LOST,    /* not a number, or a time that does not rise */
    LOG_DROPPED, /* a drop-out: no force in the middle of a pull */
    LOG_SPIKE,   /* far off its neighbours */
    LOG_USES
} LogUse;

enum { LOG_NOTES = 10, LOG_NOTE_MAX = 240, LOG_NOTES_MAX = LOG_NOTES * (LOG_NOTE_MAX + 2) };

typedef struct PullLog {
    long n;
    int has_time, has_length, has_speed;   /* columns that the file has */
    double *time, *length, *speed, *force; /* [n] s, m, m/s, N; NAN: unknown */
    int *line;                             /* [n] of the file */
    unsigned char *use;                    /* [n] a LogUse */
    long count[LOG_USES];
    long starts; /* after a rest */
    long begin;  /* the last reading at rest before the first motion, else the first that counts; -1: there is none */
    int from_rest, n_notes;             /* it is at rest there */
    char note[LOG_NOTES][LOG_NOTE_MAX]; /* sentences: columns used, assumptions */
} PullLog;

/* Reads a CSV file: the first row in which a force and a time or length are recognised, and no row below it before the
 * readings, names the columns. Readings are not judged yet. Errors: INPUT with file and line (no such row, a force
 * without a unit, rows with more cells than the head, marks that may be decimal or not, no readings), MEMORY. */
hawser_status log_read(const char *path, PullLog *log, hawser_error *err);
void log_free(PullLog *log);
/* Classifies each reading, (LO1)-(LO3), and fills lengths that the file does not have: from speed and time, or from
 * `speed` (m/s; NAN: unknown) and the time in motion. raw: spikes and drop-outs are kept. Errors: INPUT (nothing moves,
 * lengths that run down, forces below 0), MEMORY. */
hawser_status log_judge(PullLog *log, double speed, int raw, hawser_error *err);
/* Adds a note at the end, or at the beginning for the most important one. */
void log_say(PullLog *log, const char *format, ...) __attribute__((format(printf, 2, 3)));
void log_say_first(PullLog *log, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* Joins all notes to one text, for programs. */
void log_notes(int n, const char note[][LOG_NOTE_MAX], char text[LOG_NOTES_MAX]);
/* Means of readings in motion over equal parts of an axis, and single starts. */
typedef struct LogPoint {
    double at, force; /* place on the axis; N */
    int restart;      /* a start; else a mean of `readings` */
    long readings;
} LogPoint;

/* Computes the points between from and to, at most `bins` and the starts, by rising place. axis[n]: place of each
 * reading, NAN: none. Returns their number, -1 without memory; the caller frees *point. */
int log_points(const PullLog *log, const double *axis, double from, double to, int bins, LogPoint **point);
/* ------------------------------------------- the readings that are numbers with a rising time */

typedef struct LogKept {
    long n, *at; /* [n] readings, in the order of time */
    long reach;  /* neighbours on each side for speeds */
    double *x;   /* [n] scratch */
    double *v;   /* [n] speed, or its substitute; NAN: unknown */
} LogKept;

/* Marks invalid readings: no force; a time (without times: a length) that does not rise, with as few removed as
 * possible; a single length far off its neighbours (LO1a). Spreads readings of equal time up to the next one. Notes
 * report lost readings and resets. Errors: INPUT (forces, speeds below 0, lengths that run down), MEMORY. */
hawser_status log_kept_find(PullLog *log, LogKept *k, hawser_error *err);
void log_kept_free(LogKept *k);
/* Lines, cells, numbers and clocks of a logger's file. */

enum { CELLS_MAX = 256, WORD_MAX = 64 };

/* Cuts a line into cells in place, without surrounding blanks. Returns their number, up to CELLS_MAX. */
int line_cut(char *line, char separator, char *cell[CELLS_MAX]);
/* Roles of the points [0] and commas [1] in a column's numbers, as counts of cells. */
typedef struct Marks {
    long decimal[2];    /* unambiguous decimal mark: 0.5, 1,234.5 */
    long thousands[2];  /* unambiguous thousands mark: 1.234.567, 1,234.5 */
    long either[2];     /* ambiguous: 1.234 */
    long plain, digits; /* no mark; of these with four or more digits, where a thousands mark would be expected */
    const char *first[2];
    int line[2]; /* the first ambiguous cell, and its line */
} Marks;

/* The head of a logger's file: kinds of columns, and their units. */

enum { UNIT_TEXT_MAX = 32 };

/* Kinds of columns, in the order of recognition: "pull_t" is a force. */
typedef enum LogColumn { OF_FORCE, OF_SPEED, OF_LENGTH, OF_TIME, OF_DATE, LOG_COLUMNS } LogColumn;

/* Names and units as written. */
typedef struct LogHead {
    int line, names,
        units; /* line of the row of names; numbers of cells of that row and of the row of units; 0: none */
    char *name[CELLS_MAX], *unit[CELLS_MAX];
    int column[LOG_COLUMNS]; /* -1: there is none */
    double scale[LOG_COLUMNS];
} LogHead;

/* Finds the kinds of columns: by words such as "force", "pull", "Zugkraft" and the unit beside them; of several the one
 * that is not a setpoint or extreme, of forces that of the winch. Returns whether there is a force and an axis. */
int head_columns(const Units *units, int n, char *const *name, int column[LOG_COLUMNS]);

#endif
