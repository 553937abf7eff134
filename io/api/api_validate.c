/* The validation suite as a document: what `hawser validate` prints. */
#include "core/base/error.h"
#include "io/results/json_document.h"
#include "validate/validate.h"

#include <math.h>
#include <stdlib.h>

enum { COLUMNS = 10 };

/* Errors and tolerances are in per cent, or in the quantity's unit. */
static const char *error_unit(const ValidationRow *row) { return row->kind == WITHIN_SHARE ? "%" : row->unit; }

/* Nothing is asked of the errors that a regression is made from. */
static const char *verdict(const ValidationRow *row)
{
    if (isinf(row->tolerance)) return "-";
    return row->ok ? "ok" : "OUTSIDE";
}

static void fill_row(const ValidationRow *row, Cell *cell)
{
    cell[0] = cell_text(row->of->name);
    cell[1] = cell_text(row->quantity);
    cell[2] = cell_text(row->unit);
    cell[3] = cell_number(row->kind == AT_MOST ? 0 : row->expected);
    cell[4] = cell_number(row->found);
    cell[5] = cell_number(row->error);
    cell[6] = cell_number(row->tolerance);
    cell[7] = cell_text(error_unit(row));
    cell[8] = cell_text(verdict(row));
    cell[9] = cell_text(row->of->source);
}

/* The table of the quantities is the one that CSV holds; cells of the cases follow those of the quantities. */
static hawser_status write_log(const ValidationLog *log, int ran, int outside, hawser_format format, char **text,
                               hawser_error *err)
{
    Cell *const cell = calloc((size_t)(log->n + 1) * COLUMNS, sizeof *cell);
    if (!cell) return error_memory(err);
    for (int i = 0; i < log->n; ++i) fill_row(&log->row[i], &cell[i * COLUMNS]);
    const Fact facts[] = {
        {"cases", "cases", "", cell_number(ran)},
        {"count", "quantities", "", cell_number(log->n)},
        {"outside", "outside their tolerance", "", cell_number(outside)},
        {"failure", "last case that could not be run", "", cell_text(log->failure[0] ? log->failure : "-")},
    };
    const Table table = {"quantities",
                         "What was expected and what was found",
                         COLUMNS,
                         log->n,
                         {{"case", "case", 0},
                          {"quantity", "quantity", 0},
                          {"unit", "unit", 0},
                          {"expected", "expected", -1},
                          {"found", "found", -1},
                          {"error", "error", 4},
                          {"tolerance", "tolerance", -1},
                          {"in", "in", 0},
                          {"verdict", "verdict", 0},
                          {"source", "source", 0}},
                         cell};
    const Document doc = {"Validation", sizeof facts / sizeof *facts, 1, facts, &table, &table};
    const hawser_status status = document_write(&doc, format, text, err);
    free(cell);
    return status;
}

/* A filter that fits nothing is a mistake of whoever gave it. */
hawser_status hawser_validate(const hawser_validation *choice, hawser_format format, char **text, int *outside,
                              hawser_error *err)
{
    ValidationLog log;
    int ran;
    *text = NULL;
    *outside = 0;
    hawser_status status = validation_run(choice->filter, choice->fast, &log, &ran, err);
    if (status) return status;
    if (ran == 0) {
        status = error_set(err, HAWSER_ERR_INPUT, "no %svalidation case has '%s' in its name",
                           choice->fast ? "fast " : "", choice->filter ? choice->filter : "");
    } else {
        *outside = validation_outside(&log);
        status = write_log(&log, ran, *outside, format, text, err);
    }
    validation_clear(&log);
    return status;
}
