/* Points of a LandXML file: those with names, to which lines refer, and the four of an element. */
#ifndef HAWSER_SURVEY_LANDXML_POINTS_H
#define HAWSER_SURVEY_LANDXML_POINTS_H

#include "core/base/vec3.h"

typedef struct PointOf {
    Vec3 at; /* m */
    int known;
} PointOf;

/* Start, End, Center and PI of a line, curve or spiral. */
enum { POINT_START, POINT_END, POINT_CENTER, POINT_PI, GEOMETRY_POINTS };
/* Which of them an element's name means; -1: none. */
int land_point_kind(const char *name);

/* A name with its place. */
typedef struct LandPoint LandPoint;

typedef struct LandPoints {
    LandPoint *point; /* [n] */
    int *slot;        /* [slots] by a hash of the name: the point's number + 1, 0: empty */
    int n, slots;
} LandPoints;

/* A name that is there already gets the new place. 0: no memory. */
int land_points_add(LandPoints *points, const char *name, PointOf at);
/* NULL: none of that name. */
const PointOf *land_points_find(const LandPoints *points, const char *name);
void land_points_free(LandPoints *points);

#endif
