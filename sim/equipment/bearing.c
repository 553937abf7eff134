#include "sim/equipment/bearing.h"

#include <math.h>

double bearing_torque(const Bearing *bearing, double load, double om, double *d_om, double *d_load)
{
    const double x = om / bearing->speed, most = bearing->torque + bearing->friction * bearing->journal * load;
    double f = x > 0 ? 1 : -1, slope = 0;
    if (fabs(x) < 1) {
        f = (3 * x - x * x * x) / 2;
        slope = 1.5 * (1 - x * x) / bearing->speed;
    }
    *d_om = -most * slope;
    *d_load = -bearing->friction * bearing->journal * f;
    return -most * f;
}
