/* The crew's sheet: one printed side with the data that the crew needs. docs/guide/jobs-and-sheets.md. */
#ifndef HAWSER_IO_REPORT_CREW_H
#define HAWSER_IO_REPORT_CREW_H

#include "def/cable_def.h"
#include "io/report/calculation.h"

/* One piece of equipment along the route; NAN: not known, or it has none. */
typedef struct Placed {
    int number; /* number from 1, by station */
    const char *kind;
    char name[NAME_MAX_LENGTH];
    double station; /* m along the route */
    Vec3 at;        /* m, in the case's own coordinates: a roller's centre, otherwise the place on the line */
    double tilt;    /* deg, angle of a roller's axis above the level */
    double heading; /* deg from x toward y, direction of the pull across it */
    double load;    /* N */
    double rating;  /* N */
    double margin;  /* margin to the rating, %: below 0 the load is too large */
} Placed;

/* Writes the part below the head; equipment [n] by rising station, with the loads of that way. Errors: as plan_head,
 * MEMORY. */
hawser_status crew_body(const Calculation *page, int way, int n, const Placed *equipment, Text *out, hawser_error *err);

#endif
