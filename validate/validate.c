#include "validate/validate.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"

static const ValidationGroup *const groups[] = {
    &paper_group, &row_group,      &duct_group, &roller_group, &wave_group,      &motion_group,    &flight_group,
    &slip_group,  &buckling_group, &rod_group,  &frame_group,  &stability_group, &frequency_group, &convergence_group};
enum { GROUPS = sizeof groups / sizeof *groups };

/* Room for one more row. No memory for it is remembered. What a NAN was found for is not ok. */
static void row_add(ValidationLog *log, const char *quantity, ValidationRow row)
{
    if (log->n == log->room) {
        const int room = 2 * log->room + 64;
        ValidationRow *const grown = realloc(log->row, (size_t)room * sizeof *grown);
        log->no_memory = log->no_memory || !grown;
        if (!grown) return;
        log->row = grown;
        log->room = room;
    }
    row.of = log->now;
    row.ok = fabs(row.error) <= row.tolerance;
    snprintf(row.quantity, sizeof row.quantity, "%s", quantity);
    log->row[log->n++] = row;
}

void log_share(ValidationLog *log, const char *quantity, const char *unit, double expected, double found,
               double percent)
{
    const double error = 100 * (found / expected - 1);
    row_add(log, quantity, (ValidationRow){NULL, "", unit, WITHIN_SHARE, expected, found, percent, error, 0});
}

void log_near(ValidationLog *log, const char *quantity, const char *unit, double expected, double found,
              double tolerance)
{
    row_add(log, quantity, (ValidationRow){NULL, "", unit, WITHIN, expected, found, tolerance, found - expected, 0});
}

void log_limit(ValidationLog *log, const char *quantity, const char *unit, double found, double limit)
{
    row_add(log, quantity, (ValidationRow){NULL, "", unit, AT_MOST, 0, found, limit, found, 0});
}

/* (VA2) */
double order_of(int n, const double *x, const double *y)
{
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (int i = 0; i < n; ++i) {
        const double a = log(x[i]), b = log(fabs(y[i]));
        sx += a;
        sy += b;
        sxx += a * a;
        sxy += a * b;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

void order_log(ValidationLog *log, int n, const double *x, const double *error, const char *of, double expected,
               double tolerance)
{
    char quantity[VALIDATION_QUANTITY_MAX];
    for (int i = 0; i < n; ++i) {
        snprintf(quantity, sizeof quantity, "error at %s %.3g", of, x[i]);
        log_limit(log, quantity, "%", 100 * fabs(error[i]), INFINITY);
    }
    snprintf(quantity, sizeof quantity, "order in %s", of);
    log_near(log, quantity, "1", expected, order_of(n, x, error), tolerance);
}

/* A case that cannot be run is a quantity of its own, and the suite goes on: but not without memory, of which a
 * quantity says nothing. */
static void case_run(const ValidationCase *c, ValidationLog *log)
{
    hawser_error err = {HAWSER_OK, ""};
    log->now = c;
    const hawser_status status = c->run(c->setup, log, &err);
    log->no_memory |= status == HAWSER_ERR_MEMORY;
    if (!status || log->no_memory) return;
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
    for (int i = 0; (c = validation_case(i)) && !log->no_memory; ++i) {
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
