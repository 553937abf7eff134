#include "validate/orders.h"

#include <math.h>
#include <stdio.h>

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
