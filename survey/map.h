/* Longitude and latitude on the ground: a transverse Mercator projection about a route's first point, (MP1)-(MP4) of
 * docs/model/16-alignments.md. WGS 84. */
#ifndef HAWSER_SURVEY_MAP_H
#define HAWSER_SURVEY_MAP_H

#include "survey/input.h"

/* What x and y count from. */
typedef struct MapOrigin {
    double longitude, latitude; /* degrees */
} MapOrigin;

/* East and north of the origin, m, and back, degrees. True to scale on the origin's meridian; x away from it lengths
 * are too long by x2/2R2 of themselves: 0.01 mm in 1 km, 12 mm in 10 km. Good to 1e-9 of the distance within 30 degrees
 * of the meridian. */
void map_to_ground(MapOrigin origin, double longitude, double latitude, double *x, double *y);
void map_from_ground(MapOrigin origin, double x, double y, double *longitude, double *latitude);
/* The system's name in a Survey, and what it counts from by its name; 0: it is none of ours. */
void map_system_write(MapOrigin origin, char system[SURVEY_NAME_MAX]);
int map_system_read(const char *system, MapOrigin *origin);
/* Places of a file as they come: the first one is the origin. */
typedef struct MapPlaces {
    SurveyInput *in;
    int begun, plain; /* plain: the numbers are metres already */
    MapOrigin origin;
} MapPlaces;

/* Says of which unit they are: metres, of which degrees are made by projection. Errors: INPUT (another unit is asked
 * for of places in degrees). */
hawser_status map_unit(MapPlaces *p);
/* Errors: INPUT (no longitude or latitude, or farther than 300 km from the first one). height: NAN, none. */
hawser_status map_place(MapPlaces *p, double longitude, double latitude, double height, Vec3 *at);

#endif
