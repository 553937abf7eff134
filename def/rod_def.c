#include "def/rod_def.h"

/* Computes the unit vectors of a heading and a slope; `left` is level, whatever the slope. */
static void axes_of(double heading, double slope, RodLine *line)
{
    line->forward = v3(cos(heading) * cos(slope), sin(heading) * cos(slope), sin(slope));
    line->left = v3(-sin(heading), cos(heading), 0);
    line->up = v3_cross(line->forward, line->left);
}

RodLine rod_line(const RodDef *def, Vec3 start, double heading, double slope)
{
    RodLine line = {.def = def, .start = start};
    if (def->shape == ROD_POLYLINE) {
        const Vec3 side = v3_sub(def->points[1], def->points[0]);
        const double level = hypot(side.x, side.y);
        heading = level > 1e-12 * v3_norm(side) ? atan2(side.y, side.x) : 0;
        slope = atan2(side.z, level);
        line.start = def->points[0];
    }
    axes_of(heading, slope, &line);
    return line;
}

/* Direction from the start toward the centre of an arc, or the axis of a helix, by the plane of the bend (R2). */
static Vec3 inward(const RodLine *line)
{
    return v3_axpy(v3_scale(cos(line->def->plane), line->left), sin(line->def->plane), line->up);
}

static RodPlace arc_at(const RodLine *line, double s)
{
    const double radius = line->def->radius, a = s / radius, half = sin(a / 2);
    const Vec3 in = inward(line), t = line->forward;
    const Vec3 ahead = v3_axpy(line->start, radius * sin(a), t);
    return (RodPlace){v3_axpy(ahead, 2 * radius * half * half, in), v3_axpy(v3_scale(cos(a), t), sin(a), in)};
}

/* (RD1): about an axis along `forward`, at the radius from the start; right-handed where the pitch is positive. */
static RodPlace helix_at(const RodLine *line, double s)
{
    const double radius = line->def->radius, rise = line->def->pitch / (2 * M_PI), turn = 1 / hypot(radius, rise);
    const double a = s * turn, half = sin(a / 2);
    const Vec3 out = v3_scale(-1, inward(line)), around = v3_cross(line->forward, out);
    const Vec3 across = v3_axpy(v3_scale(-2 * radius * half * half, out), radius * sin(a), around);
    const Vec3 t = v3_axpy(v3_scale(-radius * sin(a), out), radius * cos(a), around);
    return (RodPlace){v3_add(line->start, v3_axpy(across, rise * a, line->forward)),
                      v3_scale(turn, v3_axpy(t, rise, line->forward))};
}

static RodPlace points_at(const RodDef *def, double s)
{
    int k = 0;
    Vec3 side = v3_sub(def->points[1], def->points[0]);
    while (s > v3_norm(side) && k + 2 < def->n_points) {
        s -= v3_norm(side);
        ++k;
        side = v3_sub(def->points[k + 1], def->points[k]);
    }
    const Vec3 t = v3_unit(side);
    return (RodPlace){v3_axpy(def->points[k], s, t), t};
}

RodPlace rod_line_at(const RodLine *line, double s)
{
    switch (line->def->shape) {
    case ROD_ARC:
        return arc_at(line, s);
    case ROD_HELIX:
        return helix_at(line, s);
    case ROD_POLYLINE:
        return points_at(line->def, s);
    case ROD_STRAIGHT:
        break;
    }
    return (RodPlace){v3_axpy(line->start, s, line->forward), line->forward};
}

double rod_points_length(int n, const Vec3 *point)
{
    double length = 0;
    for (int k = 0; k + 1 < n; ++k) length += v3_norm(v3_sub(point[k + 1], point[k]));
    return length;
}

/* Finds the end of a chord. It is never longer than its arc: the search goes outward until the line is farther away
 * than the chord, then bisects. If the line turns back within a chord (a segment longer than the arc's diameter), the
 * search ends at the farthest place. */
double rod_line_chord(const RodLine *line, double from, double chord)
{
    const Vec3 origin = rod_line_at(line, from).position;
    double low = from + chord, high = low, width = 1e-3 * chord;
    if (line->def->shape == ROD_STRAIGHT) return low;
    while (v3_norm(v3_sub(rod_line_at(line, high).position, origin)) < chord && width < 4 * chord) {
        low = high;
        high += width;
        width *= 2;
    }
    for (int it = 0; it < 100 && high - low > 0; ++it) {
        const double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high) break;
        if (v3_norm(v3_sub(rod_line_at(line, middle).position, origin)) < chord) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return high;
}
