/* Columns: the contents of a table's rows. A column is one row of a table here, from which CSV, JSON and tables for
 * readers are written alike. */
#ifndef HAWSER_IO_RESULTS_COLUMN_H
#define HAWSER_IO_RESULTS_COLUMN_H

#include <stddef.h>
#include <stdio.h>

#include "def/scene_def.h"
#include "hawser/hawser.h"

/* Format of summary.json and of theory's JSON: increases whenever a key goes or changes its meaning. 2: verdicts have a
 * fifth word. */
enum { RESULTS_FORMAT = 2 };

/* Type of the value at a column's place in a row. */
typedef enum ColumnKind {
    COLUMN_NUMBER, /* double; not finite: not known */
    COLUMN_COUNT,  /* int */
    COLUMN_LONG,   /* long */
    COLUMN_TEXT,   /* const char *; NULL: none */
    COLUMN_CHARS,  /* char[] */
    /* in JSON only: */
    COLUMN_FLAG,   /* int: true or false; from a getter NAN: not known */
    COLUMN_VECTOR, /* double[3] */
    COLUMN_LIST,   /* pointer to rows of their own */
    COLUMN_MAP,    /* array of rows, whose first column is the key and whose second is the value */
    COLUMN_ROW,    /* one row of its own */
    COLUMN_OBJECT  /* pointer to one row of its own; NULL: the key is left out */
} ColumnKind;

typedef struct Column {
    const char *key; /* in CSV and JSON, with its unit: "s_m"; "a.b" is b within the object a */
    ColumnKind kind;
    size_t offset;                     /* in the row */
    double (*number)(const void *row); /* computes the value instead of reading it there */
    const char *(*text)(const void *row);
    const char *label;   /* heading of the column in a table for readers; the key's unit may follow behind a comma */
    int decimals;        /* in such a table; < 0: as many as needed */
    int group;           /* in such a table: where a table that is too wide for a page is best cut */
    const char *unit_by; /* key of the column with each row's unit; NULL: the unit is the key's end */
    int digits;          /* in CSV files; 0: nine */
    const struct Columns *of;     /* LIST, MAP, OBJECT: their columns */
    size_t count;                 /* LIST, MAP: place in the row of the int with their number */
    int (*keep)(const void *row); /* selects rows of a LIST or MAP; a LIST without any is left out */
} Column;

typedef struct Columns {
    const Column *column; /* [n] */
    int n;
    size_t size; /* bytes of a row */
} Columns;

#define COLUMN(key_, kind_, type, member) .key = (key_), .kind = COLUMN_##kind_, .offset = offsetof(type, member)
#define COLUMNS(type, columns)                                                                                         \
    {                                                                                                                  \
        (columns), (int)(sizeof(columns) / sizeof *(columns)), sizeof(type)                                            \
    }
#define LIST(key_, type, rows, n, columns) COLUMN(key_, LIST, type, rows), .count = offsetof(type, n), .of = &(columns)

/* A number, or a text if that is not NULL. A number that is not finite is not known: "-", null or an empty
 * cell. */
typedef struct Cell {
    const char *text;
    double value;
} Cell;

static inline Cell cell_number(double value) { return (Cell){0, value}; }
static inline Cell cell_text(const char *text) { return (Cell){text, 0}; }
/* Returns the value of a column in a row: NUMBER to CHARS, or that of its getter. */
Cell column_cell(const Column *column, const void *row);
/* Writes a cell of CSV: text in quotes where needed, a number in so many digits (0: nine), nothing if it is not finite.
 */
void csv_cell(FILE *f, Cell cell, int digits);

/* ------------------------------------------------------------------------------- units: everything is in SI until it
 * is shown */

/* A value times `factor` is in `unit`. */
typedef struct Scale {
    double factor;
    const char *unit; /* lives for ever, or is the caller's unit */
} Scale;

/* Returns the scale for values of a unit, of which the largest is `size` (in that unit; NAN: the plain unit). A unit
 * that is not in the table ("s", "deg") stays as it is. */
Scale scale_of(const char *unit, double size, hawser_units units);

/* Returns the unit at the end of a key, as in "forward_end_N" and "max_sidewall_N_per_m"; "" if it has none. */
const char *unit_of_key(const char *key);
/* Returns the length of a key without its unit. */
size_t key_length(const char *key);

/* Writes a number in so many significant digits, without a power of ten where it is readable without. `text` has
 * HAWSER_SHOWN_MAX bytes. */
const char *say_digits(double value, int digits, char *text);

/* Returns the pairs of units one by one, for tests: NULL behind the last. *factor: number of `*shown` in one `*si`. */
const char *shown_pair(int i, const char **shown, double *factor);

/* ------------------------------------------------------------------------------------------------- documents */

/* Content of `check`, `theory` and `validate`: facts and tables, as text for readers, JSON or CSV. */
typedef struct Table {
    const char *key;     /* in JSON */
    const char *heading; /* above the table for readers */
    Columns columns;
    int n;            /* number of rows */
    const void *rows; /* [n] */
} Table;

typedef struct Fact {
    const char *key;   /* in JSON and CSV, with the unit: "cable_mass_kg" */
    const char *label; /* for readers; NULL: the answer has it already */
    const char *unit;
    Cell cell;
} Fact;

typedef struct Document {
    const char *title;
    int n_facts, n_tables;
    const Fact *fact;   /* [n_facts] */
    const Table *table; /* [n_tables] */
    const Table *csv;   /* the table for CSV, which can hold one; NULL: the facts */
    Language language;  /* language of a page */
    const char *answer; /* for readers, below the title and above all figures: whole lines; NULL: none */
} Document;

/* A text that grows piece by piece, its memory by half each time. It remembers a lack of memory, which open_memstream
 * and json_dumps do not report. Begins as {0}. */
typedef struct Growing {
    char *text; /* malloc'ed, with a NUL behind it; NULL: nothing yet */
    size_t size, room;
    int bad; /* a piece is missing */
} Growing;
/* Adds n bytes. */
void growing_add(Growing *g, const char *more, size_t n);
/* Returns the text, malloc'ed, if it is complete; NULL otherwise, or if nothing was added. */
char *growing_end(Growing *g);

/* Returns JSON as text, malloc'ed; NULL without memory. */
struct json_t;
char *json_text(const struct json_t *o);
/* Does the same with jansson's flags: json_dumps itself omits parts for which there is no memory. */
char *json_dumped(const struct json_t *o, size_t flags);
/* Returns the document as one JSON object, with only those tables that `wanted` (NULL-ended; NULL: all) names; NULL
 * without memory. */
struct json_t *document_json(const Document *doc, const char *const *wanted);
/* Prints a document as text for readers. */
void document_print(FILE *f, const Document *doc, hawser_units units);
/* Prints its facts and tables as parts of a page, each table below a heading of the second order. Returns 0 if it
 * fails. */
int document_print_html(FILE *f, const Document *doc, int units);
/* Returns the same as a text, malloc'ed. Errors: MEMORY. */
hawser_status document_html(const Document *doc, hawser_units units, char **text, hawser_error *err);
/* Writes the text in a format; malloc'ed. Errors: MEMORY. */
hawser_status document_write(const Document *doc, hawser_format format, char **text, hawser_error *err);

/* Marks around a name of the user's in a text for hawser_show_text, which keeps the name unchanged and removes the
 * marks. */
enum { NAME_BEGINS = '\x02', NAME_ENDS = '\x03' };
/* Writes a limit's place ("17.3 m (out)", "3.0 m on floor", "R12") with its name between these marks; a place with a
 * name in brackets needs none. Returns `text`. */
const char *place_mark(const char *place, char *text, size_t size);

#endif
