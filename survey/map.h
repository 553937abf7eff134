/* Longitude and latitude to plane coordinates: a transverse Mercator projection about a route's first point,
 * (MP1)-(MP4) of docs/theory/16-alignments.md. WGS 84. */
#ifndef HAWSER_SURVEY_MAP_H
#define HAWSER_SURVEY_MAP_H

#include "survey/input.h"

/* Origin of x and y. */
typedef struct MapOrigin {
    double longitude, latitude; /* degrees */
} MapOrigin;

/* Converts to metres east and north of the origin, and back to degrees. True to scale on the origin's meridian; at
 * distance x from it lengths are too long by a share x2/2R2: 0.01 mm in 1 km, 12 mm in 10 km. Accurate to 1e-9 of the
 * distance within 30 degrees of the meridian. */
void map_to_ground(MapOrigin origin, double longitude, double latitude, double *x, double *y);
void map_from_ground(MapOrigin origin, double x, double y, double *longitude, double *latitude);
/* Writes the system's name for a Survey, and reads its origin from the name; 0: another system. */
void map_system_write(MapOrigin origin, char system[SURVEY_NAME_MAX]);
int map_system_read(const char *system, MapOrigin *origin);
/* Places of a file in order: the first one is the origin. */
typedef struct MapPlaces {
    SurveyInput *in;
    int begun, plain; /* plain: the numbers are metres already */
    MapOrigin origin;
} MapPlaces;

/* Sets and reports the unit: metres, to which degrees are projected. Errors: INPUT (another unit is requested for
 * places in degrees). */
hawser_status map_unit(MapPlaces *p);
/* Projects a place. height: NAN for none. Errors: INPUT (no longitude or latitude, or farther than 300 km from the
 * first one). */
hawser_status map_place(MapPlaces *p, double longitude, double latitude, double height, Vec3 *at);

#endif
