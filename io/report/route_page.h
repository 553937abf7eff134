/* A page of a file's routes: plan and profile of what would be built, in grey what is left out, bends with their radii,
 * start, end and direction, and what was not read. */
#ifndef HAWSER_IO_REPORT_ROUTE_PAGE_H
#define HAWSER_IO_REPORT_ROUTE_PAGE_H

#include "hawser/hawser.h"
#include "io/report/text.h"

/* A line as it would be built. */
typedef struct RoutePageLine {
    const hawser_route_figures *figures;
    const char *way, *found; /* which way it runs; what was recognised, or "" */
    const char *problem;     /* why it is not drawn; NULL: it is */
    int n;
    double *x, *y, *z, *station; /* [n] m, places along it; the station is that in plan. In one block, owned by x */
    int n_bends;
    hawser_route_bend *bend; /* [n_bends], owned */
    double *bend_x, *bend_y; /* [n_bends] m, the middle of each; in one block, owned by bend_x */
} RoutePageLine;

typedef struct RoutePage {
    const char *path, *unit, *system;
    int n;
    RoutePageLine *line;      /* [n], owned */
    long n_left, n_left_room; /* of what is in the file; NAN between lines */
    double *left_x, *left_y;  /* [n_left] m, owned */
    int n_marks, n_more;      /* points with names; lines that are too many to be drawn */
    double *mark_x, *mark_y;  /* [n_marks] m, owned */
    int n_ignored;
    const char **ignored; /* [n_ignored], owned; their texts are not */
} RoutePage;

/* The whole file. No memory is out->failed. */
void route_page_write(const RoutePage *page, Text *out);
void route_page_clear(RoutePage *page);

#endif
