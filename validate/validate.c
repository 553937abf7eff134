#include "validate/validate.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "validate/cases.h"

static const ValidationGroup *const groups[] = {&paper_group,  &row_group,       &duct_group,
                                                &roller_group, &wave_group,      &motion_group,
                                                &rod_group,    &frequency_group, &convergence_group};
enum { GROUPS = sizeof groups / sizeof *groups };

/* Room for one more row; NULL if there is no memory, which is remembered. */
static ValidationRow *row_new(ValidationLog *log)
{
    if (log->n == log->room) {
        const int room = 2 * log->room + 64;
        ValidationRow *const grown = realloc(log->row, (size_t)room * sizeof *grown);
        if (!grown) {
            log->no_memory = 1;
            return NULL;
        }
        log->row = grown;
        log->room = room;
    }
    return &log->row[log->n++];
}

/* What a NAN was found for is not ok. */
static void row_add(ValidationLog *log, const char *quantity, ValidationRow row)
{
    ValidationRow *const at = row_new(log);
    if (!at) return;
    row.of = log->now;
    row.ok = fabs(row.error) <= row.tolerance;
    snprintf(row.quantity, sizeof row.quantity, "%s", quantity);
    *at = row;
}

void log_share(ValidationLog *log, const char *quantity, const char *unit, double expected, double found,
               double percent)
{
    row_add(log, quantity,
            (ValidationRow){.unit = unit,
                            .kind = WITHIN_SHARE,
                            .expected = expected,
                            .found = found,
                            .tolerance = percent,
                            .error = 100 * (found / expected - 1)});
}

void log_near(ValidationLog *log, const char *quantity, const char *unit, double expected, double found,
              double tolerance)
{
    row_add(log, quantity,
            (ValidationRow){.unit = unit,
                            .kind = WITHIN,
                            .expected = expected,
                            .found = found,
                            .tolerance = tolerance,
                            .error = found - expected});
}

void log_limit(ValidationLog *log, const char *quantity, const char *unit, double found, double limit)
{
    row_add(log, quantity,
            (ValidationRow){.unit = unit, .kind = AT_MOST, .found = found, .tolerance = limit, .error = found});
}

/* A case that cannot be run is a quantity of its own, and the suite goes on. */
static void case_run(const ValidationCase *c, ValidationLog *log)
{
    hawser_error err = {HAWSER_OK, ""};
    log->now = c;
    if (!c->run(c->setup, log, &err)) return;
    snprintf(log->failure, sizeof log->failure, "%s: %s", c->name, err.message);
    log_limit(log, "could not be run", "", NAN, 0);
}

const ValidationCase *validation_case(int i)
{
    for (int g = 0; g < GROUPS; i -= groups[g++]->n) {
        if (i < groups[g]->n) return &groups[g]->cases[i];
    }
    return NULL;
}

hawser_status validation_run(const char *filter, int fast, ValidationLog *log, int *ran, hawser_error *err)
{
    memset(log, 0, sizeof *log);
    *ran = 0;
    const ValidationCase *c;
    for (int i = 0; (c = validation_case(i)); ++i) {
        if ((filter && !strstr(c->name, filter)) || (fast && !c->fast)) continue;
        case_run(c, log);
        ++*ran;
    }
    if (!log->no_memory) return HAWSER_OK;
    validation_clear(log);
    return error_memory(err);
}

void validation_clear(ValidationLog *log)
{
    free(log->row);
    memset(log, 0, sizeof *log);
}

int validation_outside(const ValidationLog *log)
{
    int outside = 0;
    for (int i = 0; i < log->n; ++i) outside += !log->row[i].ok;
    return outside;
}
