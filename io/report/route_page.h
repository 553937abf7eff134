/* A page of a file's routes: plan and profile as they would be built, omitted lines in grey, bends with their radii,
 * start, end and direction, and the parts that were not read. */
#ifndef HAWSER_IO_REPORT_ROUTE_PAGE_H
#define HAWSER_IO_REPORT_ROUTE_PAGE_H

#include "hawser/hawser.h"
#include "io/report/text.h"

/* A line as it would be built. */
typedef struct RoutePageLine {
    const hawser_route_figures *figures;
    const char *way, *found; /* direction of the line; recognised features, or "" */
    const char *problem;     /* reason why it is not drawn; NULL: it is */
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
    long n_left, n_left_room; /* points of the file's own lines; NAN between lines */
    double *left_x, *left_y;  /* [n_left] m, owned */
    int n_marks, n_more;      /* points with names; lines beyond the number that is drawn */
    double *mark_x, *mark_y;  /* [n_marks] m, owned */
    int n_ignored;
    const char **ignored; /* [n_ignored], owned; their texts are not */
} RoutePage;

/* Writes the whole file. A lack of memory is out->failed. */
void route_page_write(const RoutePage *page, Text *out);
void route_page_clear(RoutePage *page);

#endif
