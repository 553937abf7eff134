/* The validation suite as a document: what `hawser validate` prints. */
#include "core/base/error.h"
#include "io/results/column.h"
#include "validate/validate.h"

#include <math.h>

static const char *case_name(const void *row) { return ((const ValidationRow *)row)->of->name; }
static const char *case_source(const void *row) { return ((const ValidationRow *)row)->of->source; }

static double expected(const void *row)
{
    const ValidationRow *const r = row;
    return r->kind == AT_MOST ? 0 : r->expected;
}

/* Errors and tolerances are in per cent, or in the quantity's unit. */
static const char *error_unit(const void *row)
{
    const ValidationRow *const r = row;
    return r->kind == WITHIN_SHARE ? "%" : r->unit;
}

/* Nothing is asked of the errors that a regression is made from. */
static const char *verdict(const void *row)
{
    const ValidationRow *const r = row;
    if (isinf(r->tolerance)) return "-";
    return r->ok ? "ok" : "OUTSIDE";
}

static const Column quantity_column[] = {
    {.key = "case", .text = case_name, .label = "case"},
    {COLUMN("quantity", CHARS, ValidationRow, quantity), .label = "quantity"},
    {COLUMN("unit", TEXT, ValidationRow, unit), .label = "unit"},
    {.key = "expected", .number = expected, .label = "expected", .decimals = -1, .unit_by = "unit"},
    {COLUMN("found", NUMBER, ValidationRow, found), .label = "found", .decimals = -1, .unit_by = "unit"},
    {COLUMN("error", NUMBER, ValidationRow, error), .label = "error", .decimals = 4, .unit_by = "in"},
    {COLUMN("tolerance", NUMBER, ValidationRow, tolerance), .label = "tolerance", .decimals = -1, .unit_by = "in"},
    {.key = "in", .text = error_unit, .label = "in"},
    {.key = "verdict", .text = verdict, .label = "verdict"},
    {.key = "source", .text = case_source, .label = "source"},
};

/* The table of the quantities is the one that CSV holds. */
static hawser_status write_log(const ValidationLog *log, int ran, int outside, hawser_format format, char **text,
                               hawser_error *err)
{
    const Fact facts[] = {
        {"cases", "cases", "", cell_number(ran)},
        {"count", "quantities", "", cell_number(log->n)},
        {"outside", "outside their tolerance", "", cell_number(outside)},
        {"failure", "last case that could not be run", "", cell_text(log->failure[0] ? log->failure : "-")},
    };
    const Table table = {"quantities", "What was expected and what was found", COLUMNS(ValidationRow, quantity_column),
                         log->n, log->row};
    const Document doc = {.title = "Validation",
                          .n_facts = sizeof facts / sizeof *facts,
                          .n_tables = 1,
                          .fact = facts,
                          .table = &table,
                          .csv = &table};
    return document_write(&doc, format, text, err);
}

/* A filter that fits nothing is a mistake of whoever gave it. */
hawser_status hawser_validate(const hawser_validation *choice, hawser_format format, char **text, int *outside,
                              hawser_error *err)
{
    static const hawser_validation all = {0};
    ValidationLog log;
    int ran;
    if (!text || !outside) return error_argument(err, text ? "outside" : "text");
    if (!choice) choice = &all;
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
