/* The line in which a rod lies at t = 0: straight, arc, helix or polyline. docs/model.md, "Rods" (RD1), (RD2). */
#ifndef HAWSER_SIM_DEF_ROD_SHAPE_H
#define HAWSER_SIM_DEF_ROD_SHAPE_H

#include "core/base/vec3.h"
#include "sim/def/rod_def.h"

/* The line, ready to be evaluated; borrows the definition. */
typedef struct RodLine {
    const RodDef *def;
    Vec3 start, forward, left, up; /* m; unit axes at the start: the heading's direction, level to its left, up */
} RodLine;

typedef struct RodPlace {
    Vec3 position, tangent; /* m, unit */
} RodPlace;

/* heading and slope in rad as for routes; a polyline has its own. */
RodLine rod_line(const RodDef *def, Vec3 start, double heading, double slope);
/* The line at arc length s (m); before a polyline's first point and past its last it goes on straight. */
RodPlace rod_line_at(const RodLine *line, double s);
/* Length of a polyline, m. */
double rod_points_length(int n, const Vec3 *point);
/* The first s beyond `from` whose straight distance from the line at `from` is `chord` (m > 0). */
double rod_line_chord(const RodLine *line, double from, double chord);

#endif
