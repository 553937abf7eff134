/* A table that is read from a CSV file of a results folder: texts by column. */
#ifndef HAWSER_IO_REPORT_SHEET_H
#define HAWSER_IO_REPORT_SHEET_H

#include "hawser/hawser.h"
#include "io/report/text.h"

typedef struct Sheet {
    int columns, rows;
    const char **name; /* [columns] */
    const char **cell; /* [rows][columns] */
    char *text;        /* owned: all of these lie in it; NULL: there is no such table */
} Sheet;

/* Cuts a text, which is taken over also after an error. Rows that are shorter than the head are filled with empty
 * cells; what is too long in one is left out. Errors: INPUT (a quote that is not closed, too large), MEMORY. */
hawser_status sheet_parse(char *text, const char *name, Sheet *sheet, hawser_error *err);
void sheet_clear(Sheet *sheet);

/* The number of a column, -1 if there is none. */
int sheet_column(const Sheet *sheet, const char *name);
static inline const char *sheet_cell(const Sheet *sheet, int row, int column)
{
    return sheet->cell[(size_t)row * (size_t)sheet->columns + (size_t)column];
}
/* A cell as a number; NAN if it is empty or none. */
double sheet_number(const Sheet *sheet, int row, int column);
/* Whether all cells of a column are numbers or empty. */
int sheet_is_numeric(const Sheet *sheet, int column);
/* Whether a text is a number as JSON writes it, so that it may stand there letter by letter. */
int is_json_number(const char *text);

/* `{"name":[...],...}`: the columns as JSON, numbers as they stand in the file, empty cells as null. `row` [n]: which
 * rows, in that order; NULL: all. */
void sheet_json(const Sheet *sheet, int n, const int *row, Text *out);
/* Rows of a long series that keep its shape: of every bucket of as many rows the first, and those in which the column
 * is least and largest; the last row. `row` has room for `most` + 3; returns how many. A series of at most `most` rows
 * is kept. */
int sheet_thin(const Sheet *sheet, int column, int most, int *row);

#endif
