/* The pulling calculation as one page for the screen and for paper: answer, figures along the route, cross-sections of
 * ducts, all tables, and pieces of the route worked out by hand. docs/guide/plan-a-duct.md, "Hand it on". */
#ifndef HAWSER_IO_REPORT_CALCULATION_H
#define HAWSER_IO_REPORT_CALCULATION_H

#include "io/report/text.h"
#include "io/results/column.h"
#include "theory/calculator.h"

typedef struct Calculation {
    const char *title, *file;
    const char *code, *verdict; /* for the pull forward: "safe", and as text */
    const char *answer;         /* in the page's language: lines of a word, a tab and a sentence */
    const char *tables, *more;  /* HTML: shown tables, and tables under "all values" */
    const Setup *setup;
    const Calculator *c;
    hawser_units units;
    Language language;
} Calculation;

/* Writes a page's head with its style, up to the first part below title and job; `kind` is its kind: "Pulling
 * calculation", in a language. A lack of memory is out->failed, here and below. */
void calculation_head(const JobDef *job, Language language, const char *kind, const char *title, const char *file,
                      Text *out);
/* Writes the part of one calculation below the head. */
void calculation_body(const Calculation *page, Text *out);
void calculation_end(Text *out);

#endif
