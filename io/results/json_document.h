/* What `check` and `theory` print: facts and tables, as text for people, JSON or CSV. */
#ifndef HAWSER_IO_RESULTS_JSON_DOCUMENT_H
#define HAWSER_IO_RESULTS_JSON_DOCUMENT_H

#include "hawser/hawser.h"

enum { TABLE_COLUMNS_MAX = 16 };

/* A number, or a text if that is not NULL. A number that is not finite is not known: "-", null or an empty
 * cell. */
typedef struct Cell {
    const char *text;
    double value;
} Cell;

typedef struct Column {
    const char *key;   /* of JSON and CSV, with the unit: "s_m" */
    const char *label; /* over the column of a table for people */
    int decimals;      /* there; < 0: as many as it takes */
} Column;

typedef struct Table {
    const char *key;     /* of JSON */
    const char *heading; /* above the table for people */
    int n_columns, n_rows;
    Column column[TABLE_COLUMNS_MAX];
    const Cell *cell; /* [n_rows * n_columns] */
} Table;

typedef struct Fact {
    const char *key;   /* of JSON and CSV, with the unit: "cable_mass_kg" */
    const char *label; /* for people */
    const char *unit;
    Cell cell;
} Fact;

typedef struct Document {
    const char *title;
    int n_facts, n_tables;
    const Fact *fact;   /* [n_facts] */
    const Table *table; /* [n_tables] */
    const Table *csv;   /* the one table that CSV can hold; NULL: the facts */
} Document;

/* The text in a format; malloc'ed. Errors: MEMORY. */
hawser_status document_write(const Document *doc, hawser_format format, char **text, hawser_error *err);

static inline Cell cell_number(double value) { return (Cell){0, value}; }
static inline Cell cell_text(const char *text) { return (Cell){text, 0}; }

#endif
