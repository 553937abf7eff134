/* The pulling calculation as one page for the screen and for paper: answer, figures along the route, cross-sections of
 * ducts, all tables, and one straight and one bend worked out by hand. docs/report.md, "The calculation". */
#ifndef HAWSER_IO_REPORT_CALCULATION_H
#define HAWSER_IO_REPORT_CALCULATION_H

#include "io/report/text.h"
#include "io/results/column.h"
#include "theory/calculator.h"

typedef struct Calculation {
    const char *title, *file;
    const char *code, *verdict; /* of the pull forward: "safe", and in words */
    const char *answer;         /* whole lines */
    const char *tables, *more;  /* HTML: what is shown, and what stands behind "all values" */
    const Setup *setup;
    const Calculator *c;
    hawser_units units;
} Calculation;

/* The whole file. No memory is out->failed. */
void calculation_write(const Calculation *page, Text *out);

#endif
