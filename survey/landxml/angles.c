#include "survey/landxml/angles.h"

#include <math.h>
#include <string.h>
#include <strings.h>

static const double PI = 3.14159265358979323846;

LandAngle land_angle_of(const char *name)
{
    static const struct {
        const char *name;
        LandAngle unit;
    } units[] = {{"radians", ANGLE_RADIANS},
                 {"decimal degrees", ANGLE_DEGREES},
                 {"grads", ANGLE_GRADS},
                 {"decimal dd.mm.ss", ANGLE_SEXAGESIMAL}};
    for (size_t i = 0; name && i < sizeof units / sizeof *units; ++i) {
        if (!strcasecmp(name, units[i].name)) return units[i].unit;
    }
    return ANGLE_UNSAID;
}

/* rad; of degrees, minutes and seconds as 12.3045 is 12 deg 30' 45". */
static double radians(double angle, LandAngle unit)
{
    const double whole = floor(angle + 1e-9), minutes = floor(100 * (angle - whole) + 1e-7);
    switch (unit) {
    case ANGLE_DEGREES:
        return angle * PI / 180;
    case ANGLE_GRADS:
        return angle * PI / 200;
    case ANGLE_SEXAGESIMAL:
        return (whole + minutes / 60 + (100 * (angle - whole) - minutes) / 36) * PI / 180;
    default:
        return angle;
    }
}

int land_long_way(double delta, LandAngle unit, double chord)
{
    const double near = 0.005; /* diameters */
    const LandAngle order[] = {unit, ANGLE_DEGREES, ANGLE_RADIANS, ANGLE_GRADS, ANGLE_SEXAGESIMAL};
    for (size_t i = unit == ANGLE_UNSAID; i < sizeof order / sizeof *order; ++i) {
        const double angle = radians(fabs(delta), order[i]);
        if (angle < 2 * PI + near && fabs(sin(angle / 2) - chord) < near) return angle > PI;
    }
    return -1;
}
