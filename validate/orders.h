/* Orders of convergence by regression. docs/model.md, "Validation" (VA2). */
#ifndef HAWSER_VALIDATE_ORDERS_H
#define HAWSER_VALIDATE_ORDERS_H

#include "validate/validate.h"

/* The slope of log y over log x, least squares over n points. */
double order_of(int n, const double *x, const double *y);
/* Adds the relative errors of n refinements, of which nothing is asked, and their order over x (`of`: what x is), which
 * should be near `expected`. */
void order_log(ValidationLog *log, int n, const double *x, const double *error, const char *of, double expected,
               double tolerance);

#endif
