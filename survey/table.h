/* Tables of a route: text or a sheet with names above the columns. docs/formats.md lists the names. */
#ifndef HAWSER_SURVEY_TABLE_H
#define HAWSER_SURVEY_TABLE_H

#include "survey/input.h"

/* Meaning of a column. */
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
    COLUMN_HEADING, /* of an element in plan, or of a leg */
    COLUMN_STATION,
    COLUMN_GRADE,
    COLUMN_GRADE_END,
    COLUMN_CURVE_LENGTH,
    COLUMN_VERTICAL_RADIUS, /* of a profile; the last of an element that has both */
    COLUMN_LONGITUDE,
    COLUMN_LATITUDE, /* degrees */
    COLUMN_TYPE,
    COLUMN_TURN,
    COLUMN_NAME,
    COLUMN_LAYER, /* texts */
    COLUMN_CANT,  /* across the line: not part of a route */
    COLUMN_FALL,  /* a slope whose sign convention is unknown */
    TABLE_COLUMNS
} TableColumn;

typedef enum TableTurn { TURN_NONE, TURN_LEFT, TURN_RIGHT, TURN_UP, TURN_DOWN } TableTurn;

/* A row; NAN: the cell is empty or there is no such column. SI; angles in rad, but headings without a unit as written.
 */
typedef struct TableRow {
    double value[COLUMN_TYPE];
    TableTurn turn;
    int straight; /* by the type's word */
    int name;     /* index into the table's names; 0: none */
    long line;
} TableRow;

typedef struct Table {
    int has[TABLE_COLUMNS];
    int plan;            /* lengths are in plan, by their head */
    int north;           /* headings are clockwise from north, by their head or as N 45 E */
    int angles;          /* headings are in rad: their head or cells have a unit */
    int degrees, metres; /* x and y are, by their head (metres: any unit of length) */
    int n;
    TableRow *row;
    PieceNames names;
    double total;    /* m, of a row of totals; NAN: none */
    long total_line; /* line of that row */
} Table;

/* Reads the rows. Titles above the heads, blank lines, lines that begin with # and rows without numbers do not count;
 * unused columns are reported. Rows and names must be freed in any case. Errors: INPUT with line and column, MEMORY. */
hawser_status table_rows(SurveyInput *in, Table *table);
/* Makes alignments of the rows, by the columns present; they take over the names. Errors: INPUT with the reason,
 * MEMORY. */
hawser_status table_alignment(SurveyInput *in, Table *table);
/* ---- words of heads and cells */

enum { TABLE_HEAD_MOST = 120 };

typedef enum TableUnitKind { UNIT_LENGTH, UNIT_ANGLE, UNIT_RATIO, UNIT_INVERSE } TableUnitKind;

typedef struct TableUnit {
    const char *name;
    double factor; /* to m, rad, 1 */
    TableUnitKind kind;
} TableUnit;

/* Finds the unit with that name of `size` bytes; NULL: none. */
const TableUnit *unit_find(const char *text, size_t size);
typedef struct TableHead {
    TableColumn meaning;   /* TABLE_COLUMNS: none */
    const TableUnit *unit; /* NULL: none */
    int strange;           /* it has an unknown unit */
    int plan, north;       /* of lengths: in plan; of headings: clockwise from north */
    int unrelated;         /* without a meaning, known to be unrelated to the route */
} TableHead;

/* Interprets the head of a column, UTF-8. */
TableHead head_read(const char *text);
/* The side that a word means. */
TableTurn head_turn(const char *text);

#endif
