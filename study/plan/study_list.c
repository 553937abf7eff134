/* Variants out of a table: CSV as RFC 4180 has it, names over the columns, a variant a row, an empty cell where the
 * base case's own value stays. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "study/plan/study.h"

/* A table being read; its text is cut into cells where it stands. */
typedef struct Csv {
    const char *path;
    char *at; /* what comes next; NULL: nothing */
    int line; /* of what comes next */
    int last; /* the cell that was read ends its row */
    hawser_error *err;
} Csv;

static hawser_status csv_error(const Csv *c, int line, const char *what, const char *detail)
{
    case_text_error(c->err, c->path, line, what, detail);
    return HAWSER_ERR_INPUT;
}

/* In quotes; `""` is one. *end: behind the closing quote. */
static hawser_status quoted_cell(Csv *c, char **cell, char **end)
{
    char *from = c->at + 1, *to = from;
    const int line = c->line;
    *cell = from;
    while (*from && !(from[0] == '"' && from[1] != '"')) {
        if (*from == '"') from++;
        c->line += *from == '\n';
        *to++ = *from++;
    }
    if (!*from) return csv_error(c, line, "a quote that does not end", NULL);
    *to = 0;
    *end = from + 1;
    if (**end && !strchr(",\r\n", **end)) return csv_error(c, c->line, "something stands behind a quote: ", *end);
    return HAWSER_OK;
}

/* The next cell of the row, without blanks around it. */
static hawser_status cell_next(Csv *c, char **cell)
{
    char *end = NULL;
    while (*c->at == ' ' || *c->at == '\t') c->at++;
    const int quoted = *c->at == '"';
    if (quoted) {
        const hawser_status status = quoted_cell(c, cell, &end);
        if (status) return status;
    } else {
        *cell = c->at;
        end = c->at + strcspn(c->at, ",\r\n");
    }
    const char stop = *end;
    char *next = end + (stop != 0);
    if (stop == '\r' && *next == '\n') next++;
    c->last = stop != ',';
    c->line += stop == '\r' || stop == '\n';
    c->at = *next || !c->last ? next : NULL;
    if (stop) *end = 0;
    while (!quoted && end > *cell && (end[-1] == ' ' || end[-1] == '\t')) *--end = 0;
    return HAWSER_OK;
}

/* Lines with nothing in them do not count. */
static void blanks_skip(Csv *c)
{
    while (c->at && (*c->at == '\n' || *c->at == '\r')) {
        c->line += *c->at == '\n';
        c->at = c->at[1] ? c->at + 1 : NULL;
    }
}

/* A column's parameter: the study's of that name, or a new one whose key the name is. */
static hawser_status column_begin(Study *s, Csv *c, const char *name, int column)
{
    Parameter *const own = s->parameter;
    if (column >= PARAMETERS_MAX) return csv_error(c, c->line, "too many columns", NULL);
    if (!*name) return csv_error(c, 1, "a column has no name", NULL);
    for (int j = 0; j < column; j++) {
        if (strcmp(own[j].name, name) == 0) return csv_error(c, 1, "two columns have the name ", name);
    }
    for (int j = column; j < s->n_parameters; j++) {
        if (strcmp(own[j].name, name) != 0) continue;
        const Parameter found = own[j];
        own[j] = own[column];
        own[column] = found;
        return HAWSER_OK;
    }
    Parameter *const more = realloc(s->parameter, (size_t)(s->n_parameters + 1) * sizeof *more);
    if (!more) return error_memory(c->err);
    s->parameter = more;
    more[s->n_parameters++] = more[column];
    more[column] = (Parameter){.name = strdup(name), .chosen = 1, .n_keys = 1, .key = malloc(sizeof *more->key)};
    if (more[column].key) more[column].key[0] = more[column].name;
    return more[column].name && more[column].key ? HAWSER_OK : error_memory(c->err);
}

/* The first row. Room for `rows` values each; every parameter of the study must have a column. */
static hawser_status head_read(Study *s, Csv *c, int rows, int *columns)
{
    hawser_status status = HAWSER_OK;
    c->last = 0;
    /* the array has one place more than parameters, for column_begin's swap */
    for (*columns = 0; !c->last && !status; ++*columns) {
        char *name;
        status = c->at ? cell_next(c, &name) : csv_error(c, 1, "nothing is in it", NULL);
        if (!status) status = column_begin(s, c, name, *columns);
    }
    if (!status && s->n_parameters > *columns) {
        status = case_key_error(c->err, s->parameter[*columns].node, NULL, "no column of the list has this name");
    }
    for (int j = 0; j < *columns && !status; j++) {
        Parameter *const p = &s->parameter[j];
        p->chosen = 1;
        p->choice = calloc((size_t)rows + 1, sizeof *p->choice);
        p->number = calloc((size_t)rows + 1, sizeof *p->number);
        if (!p->choice || !p->number) status = error_memory(c->err);
    }
    return status;
}

/* A cell becomes a choice. */
static hawser_status cell_take(const Units *units, Csv *c, const char *cell, Parameter *p)
{
    double *const number = &p->number[p->n_choices];
    p->choice[p->n_choices++] = *cell ? strdup(cell) : NULL;
    *number = NAN;
    if (!*cell) return HAWSER_OK;
    if (!p->choice[p->n_choices - 1]) return error_memory(c->err);
    *number = choice_number(units, cell, p);
    return HAWSER_OK;
}

/* A variant. */
static hawser_status row_read(Study *s, const Units *units, Csv *c, int columns)
{
    const int line = c->line;
    hawser_status status = HAWSER_OK;
    int n = 0;
    for (c->last = 0; !c->last && !status; n++) {
        char *cell = NULL;
        static char nothing[] = "";
        if (c->at) {
            status = cell_next(c, &cell);
        } else {
            cell = nothing;
            c->last = 1;
        }
        if (!status && n < columns) status = cell_take(units, c, cell, &s->parameter[n]);
    }
    if (status || n == columns) return status;
    char place[CASE_PLACE_MAX];
    return error_set(c->err, HAWSER_ERR_INPUT, "%s: the row has %d cells, the first row has %d",
                     case_place(c->path, line, place), n, columns);
}

/* Any number of rows is at most the number of line ends, and one. */
static int lines_of(const char *text)
{
    int n = 1;
    for (; *text; text++) n += *text == '\n' || *text == '\r';
    return n;
}

hawser_status list_read(Study *s, const CaseNode *file, const char *path, hawser_error *err)
{
    char *text;
    size_t size;
    int columns = 0;
    Units *const units = units_new();
    hawser_status status = units ? case_file_read(path, &text, &size, err) : error_memory(err);
    if (status) {
        units_free(units);
        return status;
    }
    Csv c = {.path = path, .at = *text ? text : NULL, .line = 1, .err = err};
    if (strlen(text) != size) status = csv_error(&c, 0, "a NUL character in it", NULL);
    if (c.at && strncmp(text, "\xef\xbb\xbf", 3) == 0) c.at += 3;
    blanks_skip(&c);
    if (!status) status = head_read(s, &c, lines_of(text), &columns);
    for (blanks_skip(&c); c.at && !status; blanks_skip(&c)) {
        status = row_read(s, units, &c, columns);
        s->samples += !status;
    }
    if (!status && s->samples == 0) status = case_value_error(err, file, ": the list has no rows");
    free(text);
    units_free(units);
    return status;
}
