/* Alignments as files: CSV tables, DXF drawings, GeoJSON and a case's route. What is read back is the same line within
 * 0.1 mm. */
#ifndef HAWSER_SURVEY_WRITE_H
#define HAWSER_SURVEY_WRITE_H

#include <stdio.h>

#include "survey/alignment.h"

typedef enum WriteFormat {
    WRITE_ELEMENTS, /* .csv: a row each, with its start: plan and profile cut at the same stations; points as x, y, z */
    WRITE_PIECES,   /* the planner's table: length, angle, radius, turn, slope; straights and bends alone */
    WRITE_DXF,      /* R12: a polyline with bulges where it is level, else one in space with chords 0.05 mm off */
    WRITE_GEOJSON,  /* longitude and latitude if the system is survey/map's, else metres, and says so */
    WRITE_CASE      /* .yaml: section `route` of a case, as plan and profile */
} WriteFormat;

/* Figures are given to 1 um and 1e-14 rad; what is lost is what the format cannot say: names in CSV, arcs and clothoids
 * in GeoJSON and in a DXF line that rises, which become chords. */

/* By a file's ending (.csv, .dxf, .geojson or .json, .yaml or .yml); -1: none of them. */
int write_format(const char *path);
/* Writes one alignment. system: what the Survey says of its coordinates. Errors: INPUT where the format has no way to
 * say it (points as pieces or as a case, clothoids as pieces, corners in space with a radius but as a case), OUTPUT,
 * MEMORY. */
hawser_status alignment_print(const Alignment *a, const char *system, WriteFormat format, FILE *to, hawser_error *err);
/* The same to a file, which is not left behind when that fails. */
hawser_status alignment_write(const Alignment *a, const char *system, WriteFormat format, const char *path,
                              hawser_error *err);
/* What the writers share: a line cut where its plan or its profile begins something new, and its corners. */

/* A stretch with one element in plan and one of the profile, both from its start on. */
typedef struct Stretch {
    double station;
    PlanElement plan;
    ProfileElement profile;
} Stretch;

typedef struct WrittenStretches {
    int n;
    Stretch *item; /* [n] */
} WrittenStretches;

hawser_status print_case(const Alignment *a, const char *system, FILE *to, hawser_error *err);

#endif
