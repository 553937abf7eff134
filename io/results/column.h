/* Columns: what a table says of each of its rows. A column is one row of a table here, from which CSV, JSON and tables
 * for people are written alike. */
#ifndef HAWSER_IO_RESULTS_COLUMN_H
#define HAWSER_IO_RESULTS_COLUMN_H

#include <stddef.h>
#include <stdio.h>

#include "def/scene_def.h"
#include "hawser/hawser.h"

/* Of summary.json and of what theory prints as JSON: one more whenever a key goes or changes its meaning. 2: verdicts
 * have a fifth word. */
enum { RESULTS_FORMAT = 2 };

/* What lies at a column's place in a row. */
typedef enum ColumnKind {
    COLUMN_NUMBER, /* double; not finite: not known */
    COLUMN_COUNT,  /* int */
    COLUMN_LONG,   /* long */
    COLUMN_TEXT,   /* const char *; NULL: none */
    COLUMN_CHARS,  /* char[] */
    /* these in JSON only: */
    COLUMN_FLAG,   /* int: true or false; of a getter NAN: not known */
    COLUMN_VECTOR, /* double[3] */
    COLUMN_LIST,   /* pointer to rows of their own */
    COLUMN_MAP,    /* array of rows, whose first column is the key and whose second is the value */
    COLUMN_ROW,    /* one row of its own */
    COLUMN_OBJECT  /* pointer to one row of its own; NULL: the key is left out */
} ColumnKind;

typedef struct Column {
    const char *key; /* of CSV and JSON, with its unit: "s_m"; "a.b" is b within the object a */
    ColumnKind kind;
    size_t offset;                     /* in the row */
    double (*number)(const void *row); /* in place of what lies there */
    const char *(*text)(const void *row);
    const char *label;            /* over the column of a table for people; the key's unit may follow behind a comma */
    int decimals;                 /* there; < 0: as many as it takes */
    int group;                    /* there: where a table that is too wide for a page is better cut than elsewhere */
    const char *unit_by;          /* key of the column with each row's unit; NULL: the unit is the key's end */
    int digits;                   /* of CSV files; 0: nine */
    const struct Columns *of;     /* LIST, MAP, OBJECT: their columns */
    size_t count;                 /* LIST, MAP: where in the row the int is that says how many */
    int (*keep)(const void *row); /* of a LIST or MAP's rows only these; a LIST without any is left out */
} Column;

typedef struct Columns {
    const Column *column; /* [n] */
    int n;
    size_t size; /* of a row, bytes */
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
/* What a column says of a row: NUMBER to CHARS, or what its getter says. */
Cell column_cell(const Column *column, const void *row);
/* A cell of CSV: text in quotes where it needs them, a number in so many digits (0: nine), nothing if it is not finite.
 */
void csv_cell(FILE *f, Cell cell, int digits);

/* ------------------------------------------------------------------- units: everything is in SI until it is shown */

/* A value times `factor` is so many `unit`. */
typedef struct Scale {
    double factor;
    const char *unit; /* lives for ever, or is the unit that was asked about */
} Scale;

/* How values of a unit are shown of which the largest is `size` (in that unit; NAN: the plain unit). A unit that is not
 * in the table ("s", "deg") stays as it is. */
Scale scale_of(const char *unit, double size, hawser_units units);

/* The unit with which a key ends, as in "forward_end_N" and "max_sidewall_N_per_m"; "" if it has none. */
const char *unit_of_key(const char *key);
/* The length of a key without its unit. */
size_t key_length(const char *key);

/* A number in so many significant digits, never with a power of ten where it can be read without. `text` has
 * HAWSER_SHOWN_MAX bytes. */
const char *say_digits(double value, int digits, char *text);

/* The pairs of units one by one, for tests: NULL behind the last. *factor: how many of `*shown` one `*si` is. */
const char *shown_pair(int i, const char **shown, double *factor);

/* ------------------------------------------------------------------------------------------------- documents */

/* What `check`, `theory` and `validate` print: facts and tables, as text for people, JSON or CSV. */
typedef struct Table {
    const char *key;     /* of JSON */
    const char *heading; /* above the table for people */
    Columns columns;
    int n;            /* rows */
    const void *rows; /* [n] */
} Table;

typedef struct Fact {
    const char *key;   /* of JSON and CSV, with the unit: "cable_mass_kg" */
    const char *label; /* for people; NULL: they have read it in the answer */
    const char *unit;
    Cell cell;
} Fact;

typedef struct Document {
    const char *title;
    int n_facts, n_tables;
    const Fact *fact;   /* [n_facts] */
    const Table *table; /* [n_tables] */
    const Table *csv;   /* the one table that CSV can hold; NULL: the facts */
    Language language;  /* of a page */
    const char *answer; /* for people, below the title and above all figures: whole lines; NULL: none */
} Document;

/* A text that grows piece by piece, its room by half each time. What there was no memory for is remembered:
 * open_memstream and json_dumps leave it out without a word. Begins as {0}. */
typedef struct Growing {
    char *text; /* malloc'ed, with a NUL behind it; NULL: nothing yet */
    size_t size, room;
    int bad; /* a piece is missing */
} Growing;
/* n bytes more. */
void growing_add(Growing *g, const char *more, size_t n);
/* The text, malloc'ed, if it is whole; NULL otherwise, or if nothing was added. */
char *growing_end(Growing *g);

/* JSON as text, malloc'ed; NULL without memory. */
struct json_t;
char *json_text(const struct json_t *o);
/* The same with jansson's flags: json_dumps itself leaves out what it has no memory for. */
char *json_dumped(const struct json_t *o, size_t flags);
/* The document as one JSON object, of its tables only those that `wanted` (NULL-ended; NULL: all) names; NULL without
 * memory. */
struct json_t *document_json(const Document *doc, const char *const *wanted);
/* A document as text for people. */
void document_print(FILE *f, const Document *doc, hawser_units units);
/* Its facts and tables as parts of a page, each table below a heading of the second order. Returns whether it could be
 * written. */
int document_print_html(FILE *f, const Document *doc, int units);
/* The same as a text, malloc'ed. Errors: MEMORY. */
hawser_status document_html(const Document *doc, hawser_units units, char **text, hawser_error *err);
/* The text in a format; malloc'ed. Errors: MEMORY. */
hawser_status document_write(const Document *doc, hawser_format format, char **text, hawser_error *err);

/* In a text that hawser_show_text is to have: what stands between these two is a name of the user's, which stays as it
 * is; they go. */
enum { NAME_BEGINS = '\x02', NAME_ENDS = '\x03' };
/* A place as a limit has it ("17.3 m (out)", "3.0 m on floor", "R12"), its name between them; a place with a name in
 * brackets needs none. Returns `text`. */
const char *place_mark(const char *place, char *text, size_t size);

#endif
