/* Pages of studies: one HTML file with tables and figures in SVG, without scripts and without network access. */
#ifndef HAWSER_STUDY_PAGE_H
#define HAWSER_STUDY_PAGE_H

#include "io/report/svg.h"
#include "io/results/column.h"

/* Writes the beginning with its title, and the end. */
void page_begin(Text *page, const char *title);
void page_end(Text *page);
/* Writes preformatted lines, or a paragraph. */
void page_lines(Text *page, const char *lines);
void page_table(Text *page, const Table *table);
/* A curve of a figure: a line, marks, or both. */
typedef struct Curve {
    const char *words; /* NULL: none in the legend */
    int n;
    const double *x, *y; /* [n] */
    SvgStyle style;
    int line, marks;
} Curve;

/* A figure of curves over two axes. A level is a line at a value of y. */
typedef struct Chart {
    const char *title, *x, *y; /* title, y and x with their units */
    int n;
    const Curve *curve; /* [n] */
    double width, height;
    double level; /* NAN: none */
    const char *level_words;
} Chart;

void page_chart(Text *page, const Chart *chart);
/* Horizontal bars, one below the other, each from `from` to `to` with a label. */
typedef struct Bar {
    const char *words;
    double from, to;  /* NAN: none */
    double low, high; /* an interval about its end; NAN: none */
    SvgStyle style;
} Bar;

#endif
