/* Alignments as files: CSV tables, DXF drawings, GeoJSON and a case's route. Reading them again gives the same line
 * within 0.1 mm. */
#ifndef HAWSER_SURVEY_WRITE_H
#define HAWSER_SURVEY_WRITE_H

#include <stdio.h>

#include "survey/alignment.h"

typedef enum WriteFormat {
    WRITE_ELEMENTS, /* .csv: a row per element, with its start: plan and profile cut at the same stations; points as x,
                       y, z */
    WRITE_PIECES,   /* the planner's table: length, angle, radius, turn, slope; only straights and bends */
    WRITE_DXF,      /* R12: a polyline with bulges where it is level, else one in space with chords 0.05 mm off */
    WRITE_GEOJSON,  /* longitude and latitude if the system is survey/map's, else metres, as stated in the file */
    WRITE_CASE      /* .yaml: section `route` of a case, as plan and profile */
} WriteFormat;

/* Numbers are written to 1 um and 1e-14 rad; only what the format cannot express is lost: names in CSV, arcs and
 * clothoids in GeoJSON and in a rising DXF line, which become chords. */

/* By a file's ending (.csv, .dxf, .geojson or .json, .yaml or .yml); -1: none of them. */
int write_format(const char *path);
/* Writes one alignment. system: name of the Survey's coordinates. Errors: INPUT if the format cannot express it (points
 * as pieces or as a case, clothoids as pieces, corners in space with a radius except as a case), OUTPUT, MEMORY. */
hawser_status alignment_print(const Alignment *a, const char *system, WriteFormat format, FILE *to, hawser_error *err);
/* Writes to a file, which is removed on failure. */
hawser_status alignment_write(const Alignment *a, const char *system, WriteFormat format, const char *path,
                              hawser_error *err);
/* Shared by the writers: a line cut where its plan or its profile changes, and its corners. */

/* A stretch with one element in plan and one of the profile, both from the stretch's start on. */
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
