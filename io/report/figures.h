/* The main figures of a run as SVG. */
#ifndef HAWSER_IO_REPORT_FIGURES_H
#define HAWSER_IO_REPORT_FIGURES_H

#include "io/report/folder.h"

enum { FIGURES = 4 };

typedef struct Figure {
    const char *name;  /* of the file */
    const char *needs; /* what the results must hold, in words */
    /* The figure's text behind `out`; 0: the results hold nothing to draw. Errors: MEMORY is out->failed, or -1. */
    int (*draw)(const Folder *folder, hawser_units units, Text *out);
} Figure;

extern const Figure figures[FIGURES];

#endif
