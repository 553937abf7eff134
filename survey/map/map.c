#define _GNU_SOURCE /* locale_t */
#include "survey/map/map.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double PI = 3.14159265358979323846;
/* WGS 84: semi-major axis, m, and flattening. */
static const double AXIS = 6378137, FLAT = 1 / 298.257223563;
static const double farthest = 300e3;

static const char system_text[] = "transverse Mercator (WGS 84) about longitude %.12f, latitude %.12f";

/* The series of Krueger, to the fourth order of the third flattening: (MP2), (MP4). */
typedef struct Series {
    double e, radius, forth[4], back[4];
} Series;

static Series series_make(void)
{
    const double n = FLAT / (2 - FLAT), n2 = n * n, n3 = n * n2, n4 = n2 * n2;
    return (Series){.e = sqrt(FLAT * (2 - FLAT)),
                    .radius = AXIS / (1 + n) * (1 + n2 / 4 + n4 / 64),
                    .forth = {n / 2 - 2 * n2 / 3 + 5 * n3 / 16 + 41 * n4 / 180,
                              13 * n2 / 48 - 3 * n3 / 5 + 557 * n4 / 1440, 61 * n3 / 240 - 103 * n4 / 140,
                              49561 * n4 / 161280},
                    .back = {n / 2 - 2 * n2 / 3 + 37 * n3 / 96 - n4 / 360, n2 / 48 + n3 / 15 - 437 * n4 / 1440,
                             17 * n3 / 480 - 37 * n4 / 840, 4397 * n4 / 161280}};
}

/* Tangent of the conformal latitude from that of the latitude: (MP1). */
static double conformal(double e, double t)
{
    const double root = sqrt(1 + t * t), sigma = sinh(e * atanh(e * t / root));
    return t * sqrt(1 + sigma * sigma) - sigma * root;
}

static double northing(const Series *s, double t, double longitude, double *east)
{
    const double xi = atan2(t, cos(longitude)), eta = asinh(sin(longitude) / hypot(t, cos(longitude)));
    double x = eta, y = xi;
    for (int j = 0; j < 4; ++j) {
        x += s->forth[j] * cos(2 * (j + 1) * xi) * sinh(2 * (j + 1) * eta);
        y += s->forth[j] * sin(2 * (j + 1) * xi) * cosh(2 * (j + 1) * eta);
    }
    *east = s->radius * x;
    return s->radius * y;
}

void map_to_ground(MapOrigin origin, double longitude, double latitude, double *x, double *y)
{
    const Series s = series_make();
    double none;
    const double from = northing(&s, conformal(s.e, tan(origin.latitude * PI / 180)), 0, &none);
    const double away = remainder(longitude - origin.longitude, 360) * PI / 180;
    *y = northing(&s, conformal(s.e, tan(latitude * PI / 180)), away, x) - from;
}

void map_from_ground(MapOrigin origin, double x, double y, double *longitude, double *latitude)
{
    const Series s = series_make();
    double none;
    const double from = northing(&s, conformal(s.e, tan(origin.latitude * PI / 180)), 0, &none);
    const double xi0 = (y + from) / s.radius, eta0 = x / s.radius;
    double xi = xi0, eta = eta0;
    for (int j = 0; j < 4; ++j) {
        xi -= s.back[j] * sin(2 * (j + 1) * xi0) * cosh(2 * (j + 1) * eta0);
        eta -= s.back[j] * cos(2 * (j + 1) * xi0) * sinh(2 * (j + 1) * eta0);
    }
    const double goal = sin(xi) / hypot(sinh(eta), cos(xi)), square = 1 - s.e * s.e;
    double t = goal / square;
    for (int i = 0; i < 6; ++i) { /* Newton on (MP1) */
        const double is = conformal(s.e, t);
        t += (goal - is) / sqrt(1 + is * is) * (1 + square * t * t) / (square * sqrt(1 + t * t));
    }
    *latitude = atan(t) * 180 / PI;
    *longitude = remainder(origin.longitude + atan2(sinh(eta), cos(xi)) * 180 / PI, 360);
}

void map_system_write(MapOrigin origin, char system[SURVEY_NAME_MAX])
{
    snprintf(system, SURVEY_NAME_MAX, system_text, origin.longitude, origin.latitude);
}

int map_system_read(const char *system, MapOrigin *origin)
{
    return sscanf(system, "transverse Mercator (WGS 84) about longitude %lf, latitude %lf", &origin->longitude,
                  &origin->latitude) == 2;
}

hawser_status map_unit(MapPlaces *p)
{
    if (!p->plain && !isnan(p->in->options.unit))
        return input_error(p->in, "its places are degrees and its heights metres: no unit of length can be chosen");
    input_unit(p->in, 1, p->plain ? "" : "projected");
    return HAWSER_OK;
}

hawser_status map_place(MapPlaces *p, double longitude, double latitude, double height, Vec3 *at)
{
    p->in->out->mapped = !p->plain || *p->in->out->system;
    *at = v3(longitude, latitude, isnan(height) ? 0 : height);
    if (!isfinite(longitude + latitude) || isinf(height)) return input_error(p->in, "a place without two numbers");
    if (p->plain) {
        *at = v3_scale(p->in->unit, *at);
        return HAWSER_OK;
    }
    if (fabs(longitude) > 180 || fabs(latitude) >= 89) {
        return input_error(p->in, "longitude %g, latitude %g: expected degrees, within 180 and 89", longitude,
                           latitude);
    }
    if (!p->begun) {
        char system[SURVEY_NAME_MAX];
        map_system_write((MapOrigin){longitude, latitude}, system);
        map_system_read(system, &p->origin); /* as it is written */
        memcpy(p->in->out->system, system, sizeof system);
    }
    p->begun = 1;
    map_to_ground(p->origin, longitude, latitude, &at->x, &at->y);
    if (hypot(at->x, at->y) <= farthest) return HAWSER_OK;
    return input_error(p->in, "longitude %g, latitude %g is farther than 300 km from the file's first place", longitude,
                       latitude);
}
