/* A table that is read from a CSV file of a results folder: texts by column. */
#ifndef HAWSER_IO_REPORT_FOLDER_H
#define HAWSER_IO_REPORT_FOLDER_H

#include "core/file.h"
#include "hawser/hawser.h"
#include "io/report/text.h"
#include "io/results/results_file.h"

typedef struct Sheet {
    int columns, rows;
    const char **name; /* [columns] */
    const char **cell; /* [rows][columns] */
    char *text;        /* owned: contains all of these; NULL: there is no such table */
} Sheet;

/* Cuts a text, which is taken over also after an error. Shorter rows are filled with empty cells; surplus cells are
 * dropped. Errors: INPUT (a quote that is not closed, too large), MEMORY. */
hawser_status sheet_parse(char *text, const char *name, Sheet *sheet, hawser_error *err);
void sheet_clear(Sheet *sheet);
/* Returns the number of a column, -1 if there is none. */
int sheet_column(const Sheet *sheet, const char *name);
static inline const char *sheet_cell(const Sheet *sheet, int row, int column)
{
    return sheet->cell[(size_t)row * (size_t)sheet->columns + (size_t)column];
}

/* Returns a cell as a number; NAN if it is empty or none. */
double sheet_number(const Sheet *sheet, int row, int column);
/* Checks whether a text is a number as JSON writes it, so that it can be copied unchanged. */
int is_json_number(const char *text);
/* Writes `{"name":[...],...}`: the columns as JSON, numbers as in the file, empty cells as null. `row` [n]: the rows,
 * in that order; NULL: all. */
void sheet_json(const Sheet *sheet, int n, const int *row, Text *out);
/* Chooses rows of a long series that keep its shape: of every bucket the first row, and those in which the column is
 * least and largest; the last row. `row` has space for `most` + 3; returns how many. A series of at most `most` rows is
 * kept. */
int sheet_thin(const Sheet *sheet, int column, int most, int *row);
/* A results folder that is read back: docs/reference/results.md describes each file. Only summary.json is required. */

struct json_t;

enum { FOLDER_NOTES_MAX = 8, FOLDER_NOTE_MAX = 400 };

/* Note about a folder of an unfinished run. */
#define FOLDER_UNFINISHED                                                                                              \
    "This run has not ended: it is under way, or it was cut off before it could write its outcome. The page shows "    \
    "what it had written by then."
typedef struct Folder {
    const char *dir; /* path as named by the user; borrowed */
    OutDir home;     /* the same, open while `opened` */
    int opened;
    struct json_t *summary;                         /* an object */
    char *summary_text;                             /* text of summary.json */
    Sheet stations, rollers, series, inputs, route; /* without columns: missing */
    int n_notes;
    char note[FOLDER_NOTES_MAX][FOLDER_NOTE_MAX]; /* sentences: files that are missing or cannot be read */
} Folder;

/* Reads a folder. Errors: INPUT (no such folder, no summary.json or a wrong one, files of another run), MEMORY. Another
 * file that is missing or cannot be read is a note. Clear it with folder_clear, also after an error. */
hawser_status folder_read(const char *dir, Folder *folder, hawser_error *err);
/* Reads a folder within one in the same way; *there 0: there is none of that name, or it is a link. dir: its path. */
hawser_status folder_read_within(const Folder *outer, const char *name, const char *dir, Folder *folder, int *there,
                                 hawser_error *err);
void folder_clear(Folder *folder);
/* Reads the summary alone, and checks that the files beside it belong to it. Arguments and errors as folder_read. */
hawser_status folder_open(const char *dir, Folder *folder, hawser_error *err);
/* Adds the folder's files that pages and figures are made from, which must not be overwritten. Errors: MEMORY. */
hawser_status folder_files(const Folder *folder, FileMarks *files, hawser_error *err);
void folder_say(Folder *folder, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* Returns dir/name, malloc'ed; NULL without memory. */
char *folder_path(const Folder *folder, const char *name);
/* Returns a figure of the summary by its path, "pull_force.peak_N"; NAN: not known. */
double folder_figure(const Folder *folder, const char *path);
/* Returns a text of the summary by its key; "" if there is none. */
const char *folder_text(const Folder *folder, const char *key);
/* Returns the name of a run: its title, or its folder. */
const char *folder_title(const Folder *folder);

#endif
