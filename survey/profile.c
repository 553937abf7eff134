/* Elements of a profile: (AL3)-(AL5) of docs/model/16-alignments.md. */
#include "survey/alignment.h"

#include <math.h>

#include "core/base/error.h"

/* Sine of the slope where dz/ds is the grade. */
static double sine(double grade) { return grade / sqrt(1 + grade * grade); }

ProfileElement profile_at(const ProfileElement *e, double s)
{
    ProfileElement at = *e;
    at.station = e->station + s;
    if (e->kind == PROFILE_PARABOLA || e->bend == 0) { /* (AL3) */
        at.z = e->z + s * (e->grade + 0.5 * s * e->bend);
        at.grade = e->grade + s * e->bend;
        return at;
    }
    const double from = sine(e->grade), to = fmin(fmax(from + s * e->bend, -0.999999), 0.999999);
    const double cosine = sqrt(1 - to * to);
    at.grade = to / cosine; /* (AL4); the difference of the cosines without cancellation */
    at.z = e->z + (to - from) * (to + from) / (cosine + sqrt(1 - from * from)) / e->bend;
    return at;
}

/* How far in plan the curve at corner i reaches on its side: -1 before it, 1 behind it. */
static double reach(const ProfileCorner *c, double in, double out, int side)
{
    if (c->radius <= 0) return side < 0 ? c->before : c->after;
    const double turn = fabs(atan(out) - atan(in)), tangent = c->radius * tan(turn / 2); /* (AL5) */
    return tangent * cos(atan(side < 0 ? in : out));
}

static int element_add(Alignment *a, RouteProfileKind kind, double station, double length, double z, double grade,
                       double bend)
{
    if (length < 1e-9) return 1;
    ProfileElement *const e = alignment_add_profile(a);
    if (e) *e = (ProfileElement){kind, station, length, z, grade, bend};
    return e != NULL;
}

/* The curve at a corner: one arc, or a parabola on either side that meets the other at the corner's station. */
static int curve_add(Alignment *a, const ProfileCorner *c, double in, double out)
{
    const double before = reach(c, in, out, -1), after = reach(c, in, out, 1), all = before + after;
    if (all < 1e-9) return 1;
    const double z = c->z - in * before, start = c->station - before;
    if (c->radius > 0) return element_add(a, PROFILE_ARC, start, all, z, in, (out > in ? 1 : -1) / c->radius);
    if (fabs(before - after) < 1e-9 * all || before <= 0 || after <= 0) {
        return element_add(a, PROFILE_PARABOLA, start, all, z, in, (out - in) / all);
    }
    const double joint = (before * in + after * out) / all; /* the halves' common grade, (AL6) */
    return element_add(a, PROFILE_PARABOLA, start, before, z, in, (joint - in) / before) &&
           element_add(a, PROFILE_PARABOLA, c->station, after, z + before * (in + joint) / 2, joint,
                       (out - joint) / after);
}

hawser_status profile_from_corners(Alignment *a, int n, const ProfileCorner *corner, hawser_error *err)
{
    double end = -INFINITY; /* of the curve before */
    double in = NAN;        /* grade */
    for (int i = 0; i < n; ++i) {
        const ProfileCorner *const c = &corner[i];
        const double away = i + 1 < n ? c[1].station - c->station : NAN;
        const double out = i + 1 < n ? (c[1].z - c->z) / away : in;
        if (away <= 0) {
            return error_set(err, HAWSER_ERR_INPUT, "the profile's stations do not rise: %.4f m comes after %.4f m",
                             c[1].station, c->station);
        }
        if (i == 0) {
            in = out;
            end = c->station;
        }
        const double before = i > 0 && i + 1 < n ? reach(c, in, out, -1) : 0;
        const double after = i > 0 && i + 1 < n ? reach(c, in, out, 1) : 0;
        const double straight = c->station - before - end;
        if (straight < -1e-3) {
            return error_set(err, HAWSER_ERR_INPUT, "the profile's curve at %.4f m overlaps the one before by %.4f m",
                             c->station, -straight);
        }
        const int fine =
            i == 0 || (element_add(a, PROFILE_PARABOLA, end, straight, c->z - in * (before + straight), in, 0) &&
                       (before + after == 0 || curve_add(a, c, in, out)));
        if (!fine) return error_memory(err);
        end = c->station + after;
        in = out;
    }
    return HAWSER_OK;
}
