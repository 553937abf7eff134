/* What the writers share: a line cut where its plan or its profile begins something new, and its corners. */
#ifndef HAWSER_SURVEY_WRITE_PARTS_H
#define HAWSER_SURVEY_WRITE_PARTS_H

#include <stdio.h>

#include "survey/alignment.h"

/* A stretch with one element in plan and one of the profile, both from its start on. */
typedef struct Stretch {
    double station;
    PlanElement plan;
    ProfileElement profile;
} Stretch;

typedef struct Stretches {
    int n;
    Stretch *item; /* [n] */
} Stretches;

/* Cuts a line of elements, or of points with a profile. Free the items. Errors: MEMORY. */
hawser_status stretches_make(const Alignment *a, Stretches *out, hawser_error *err);

/* Its corners: its points, or places along its elements whose chords are 0.05 mm off at most. Free them. Errors:
 * MEMORY, INPUT (more than 20 million). */
hawser_status vertices_make(const Alignment *a, int *n, Vec3 **vertex, hawser_error *err);

hawser_status print_elements(const Alignment *a, FILE *to, hawser_error *err);
hawser_status print_pieces(const Alignment *a, FILE *to, hawser_error *err);
hawser_status print_dxf(const Alignment *a, FILE *to, hawser_error *err);
hawser_status print_geojson(const Alignment *a, const char *system, FILE *to, hawser_error *err);
hawser_status print_case(const Alignment *a, const char *system, FILE *to, hawser_error *err);

#endif
