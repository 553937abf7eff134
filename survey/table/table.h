/* Tables of a route: CSV and TSV files with names over the columns. docs/routes.md has the names. */
#ifndef HAWSER_SURVEY_TABLE_TABLE_H
#define HAWSER_SURVEY_TABLE_TABLE_H

#include "survey/input.h"

/* What a column means. */
typedef enum TableColumn {
    COLUMN_X,
    COLUMN_Y,
    COLUMN_Z, /* m east, north, up */
    COLUMN_LENGTH,
    COLUMN_ANGLE,
    COLUMN_RADIUS,
    COLUMN_SLOPE, /* of a piece; slope: dz/ds in plan */
    COLUMN_RADIUS_START,
    COLUMN_RADIUS_END,
    COLUMN_HEADING, /* of an element in plan */
    COLUMN_STATION,
    COLUMN_GRADE,
    COLUMN_GRADE_END,
    COLUMN_CURVE_LENGTH,
    COLUMN_VERTICAL_RADIUS, /* of a profile; the last of an element that has both */
    COLUMN_TYPE,
    COLUMN_TURN,
    COLUMN_NAME,
    COLUMN_LAYER, /* words */
    TABLE_COLUMNS
} TableColumn;

typedef enum TableTurn { TURN_NONE, TURN_LEFT, TURN_RIGHT, TURN_UP, TURN_DOWN } TableTurn;

/* A row; NAN: the cell is empty or there is no such column. SI; angles in rad, but headings as they stand. */
typedef struct TableRow {
    double value[COLUMN_TYPE];
    TableTurn turn;
    int straight; /* the type's word says so */
    int name;     /* of the table's names; 0: none */
    long line;
} TableRow;

typedef struct Table {
    int has[TABLE_COLUMNS];
    int n;
    TableRow *row;
    PieceNames names;
} Table;

/* Reads the rows. Blank lines and those that begin with # do not count; columns of other names are ignored, and said
 * so. Errors: INPUT with line and column, MEMORY. Free rows and names in any case. */
hawser_status table_rows(SurveyInput *in, Table *table);
/* Makes alignments of them, by what columns there are; they take the names. Errors: INPUT with the reason, MEMORY. */
hawser_status table_alignment(SurveyInput *in, Table *table);

#endif
