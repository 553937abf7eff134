/* What becomes of entities: straights and arcs in plan where they lie level, points in space where they do not. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "survey/dxf/dxf.h"

static const double PI = 3.14159265358979323846;

double dxf_number(const DxfEntity *e, int code, double otherwise)
{
    for (int i = 0; i < e->n; ++i) {
        if (e->number[i].code == code) return e->number[i].value;
    }
    return otherwise;
}

int dxf_flags(const DxfEntity *e)
{
    const double value = dxf_number(e, 70, 0);
    return value >= 0 && value < 65536 ? (int)value : 0;
}

/* The axes of an entity's own system: AutoCAD's rule of the arbitrary axis. */
DxfSystem dxf_system(const SurveyInput *in, const DxfEntity *e)
{
    const Vec3 given = v3(dxf_number(e, 210, 0), dxf_number(e, 220, 0), dxf_number(e, 230, 1));
    const Vec3 axis = v3_norm(given) > 0 ? v3_unit(given) : v3(0, 0, 1);
    const int upright = fabs(axis.x) < 1.0 / 64 && fabs(axis.y) < 1.0 / 64;
    const Vec3 x = v3_unit(v3_cross(upright ? v3(0, 1, 0) : v3(0, 0, 1), axis));
    return (DxfSystem){x, v3_cross(axis, x), axis, in->unit};
}

Vec3 dxf_world(const DxfSystem *s, Vec3 p)
{
    return v3_scale(s->unit, v3_add(v3_add(v3_scale(p.x, s->x), v3_scale(p.y, s->y)), v3_scale(p.z, s->axis)));
}

static Alignment *alignment_of(const SurveyInput *in, const DxfEntity *e)
{
    Alignment *const a = survey_add(in->out, e->layer);
    if (a) memcpy(a->layer, e->layer, sizeof a->layer);
    return a;
}

/* ---------------------------------------------------------------------------------------------------- level shapes */

/* An arc from a to b, in plan; a straight without a bulge. */
static int element_add(Alignment *to, Vec3 a, Vec3 b, double bulge)
{
    const double chord = hypot(b.x - a.x, b.y - a.y), turn = 4 * atan(bulge);
    if (!(chord > 1e-9)) return 1;
    PlanElement *const e = alignment_add_plan(to);
    if (!e) return 0;
    const double k = 2 * sin(turn / 2) / chord;
    *e = (PlanElement){.x = a.x,
                       .y = a.y,
                       .heading = atan2(b.y - a.y, b.x - a.x) - turn / 2,
                       .length = fabs(turn) > 1e-9 ? turn / k : chord,
                       .k0 = fabs(turn) > 1e-9 ? k : 0,
                       .k1 = fabs(turn) > 1e-9 ? k : 0};
    return 1;
}

/* All of a level line is at one height. */
static int height_add(Alignment *a, double z)
{
    double length = 0;
    for (int i = 0; i < a->n_plan; ++i) length += a->plan[i].length;
    a->flat = z == 0;
    if (z == 0 || a->n_plan == 0) return 1;
    ProfileElement *const e = alignment_add_profile(a);
    if (e) *e = (ProfileElement){.length = length, .z = z};
    return e != NULL;
}

static int point_add(Alignment *a, Vec3 at)
{
    Vec3 *const p = alignment_add_point(a);
    if (p) *p = at;
    return p != NULL;
}

/* ------------------------------------------------------------------------------------------------------ tilted arcs */

/* The points of an arc with a bulge in a tilted plane, but for its first one: chords 0.2 mm off at most. */
static int chords_add(Alignment *to, const DxfSystem *s, Vec3 a, Vec3 b, double bulge)
{
    const double chord = hypot(b.x - a.x, b.y - a.y), turn = 4 * atan(bulge);
    const double radius = fabs(turn) > 1e-9 ? chord / (2 * fabs(sin(turn / 2))) : INFINITY;
    const double step = 2 * acos(fmax(0, 1 - 2e-4 / fmax(radius * s->unit, 2e-4)));
    const int n = isfinite(radius) ? (int)fmin(10000, 1 + fabs(turn) / fmax(step, 1e-3)) : 1;
    const Vec3 along = v3_scale(1 / fmax(chord, 1e-300), v3_sub(b, a)), left = v3(-along.y, along.x, 0);
    int fine = 1;
    to->bent |= n > 1;
    for (int i = 1; i <= n && fine; ++i) { /* seen from the chord's middle, the arc from -turn/2 to turn/2 */
        const double angle = turn * (i - 0.5 * n) / n, half = turn / 2;
        const double x = n > 1 ? 0.5 * chord * (1 + sin(angle) / sin(half)) : chord;
        const double y = n > 1 ? -0.5 * chord * (cos(angle) - cos(half)) / sin(half) : 0;
        const Vec3 at = v3_axpy(v3_axpy(a, x, along), y, left);
        fine = point_add(to, dxf_world(s, v3(at.x, at.y, a.z)));
    }
    return fine;
}

/* --------------------------------------------------------------------------------------------------------- entities */

hawser_status dxf_add_corners(const SurveyInput *in, const DxfEntity *e, int n, const DxfCorner *corner, int closed,
                              int space)
{
    DxfSystem s = dxf_system(in, e);
    if (space) s = (DxfSystem){v3(1, 0, 0), v3(0, 1, 0), v3(0, 0, 1), in->unit};
    const int level = !space && fabs(s.axis.z) > 1 - 1e-12, last = closed ? n : n - 1;
    Alignment *const a = n > 1 ? alignment_of(in, e) : NULL;
    if (n < 2) return HAWSER_OK;
    if (a) a->drawn = 1;
    int fine = a != NULL && (level || point_add(a, dxf_world(&s, corner[0].at)));
    for (int i = 0; i < last && fine; ++i) {
        const DxfCorner *const from = &corner[i], *const to = &corner[(i + 1) % n];
        const Vec3 start = dxf_world(&s, from->at), end = dxf_world(&s, to->at);
        if (level)
            fine = element_add(a, start, end, s.axis.z > 0 ? from->bulge : -from->bulge);
        else if (space)
            fine = point_add(a, end);
        else
            fine = chords_add(a, &s, from->at, to->at, from->bulge);
    }
    if (fine && level) fine = height_add(a, dxf_world(&s, corner[0].at).z);
    return fine ? HAWSER_OK : error_memory(in->err);
}

/* Both ends in the world's coordinates; one that rises is two points in space. */
hawser_status dxf_add_line(const SurveyInput *in, const DxfEntity *e)
{
    const DxfCorner corner[2] = {{.at = {dxf_number(e, 10, NAN), dxf_number(e, 20, NAN), dxf_number(e, 30, 0)}},
                                 {.at = {dxf_number(e, 11, NAN), dxf_number(e, 21, NAN), dxf_number(e, 31, 0)}}};
    if (!isfinite(corner[0].at.x + corner[0].at.y + corner[1].at.x + corner[1].at.y)) {
        return input_error(in, "a LINE without both of its ends (groups 10, 20, 11, 21)");
    }
    if (corner[0].at.z != corner[1].at.z) return dxf_add_corners(in, e, 2, corner, 0, 1);
    Alignment *const a = alignment_of(in, e);
    const int fine = a && element_add(a, v3_scale(in->unit, corner[0].at), v3_scale(in->unit, corner[1].at), 0) &&
                     height_add(a, in->unit * corner[0].at.z);
    return fine ? HAWSER_OK : error_memory(in->err);
}

/* Anticlockwise from one angle to the other, in its own system. */
hawser_status dxf_add_arc(const SurveyInput *in, const DxfEntity *e)
{
    const double radius = dxf_number(e, 40, NAN), from = PI / 180 * dxf_number(e, 50, NAN),
                 to = PI / 180 * dxf_number(e, 51, NAN);
    const Vec3 centre = v3(dxf_number(e, 10, NAN), dxf_number(e, 20, NAN), dxf_number(e, 30, 0));
    const double rest = to - from - 2 * PI * floor((to - from) / (2 * PI)),
                 turn = rest > 0 || to == from ? rest : 2 * PI;
    if (!(radius > 0) || !isfinite(from + to + centre.x + centre.y)) {
        return input_error(in, "an ARC without centre, radius above 0 and angles (groups 10, 20, 40, 50, 51)");
    }
    DxfCorner corner[3];
    for (int i = 0; i < 3; ++i) { /* in two halves: a bulge has no full turns */
        const double angle = from + 0.5 * i * turn;
        corner[i] =
            (DxfCorner){v3(centre.x + radius * cos(angle), centre.y + radius * sin(angle), centre.z), tan(turn / 8)};
    }
    return dxf_add_corners(in, e, 3, corner, 0, 0);
}

/* Corners as groups 10, 20, with 42 behind them; 38 is the height of all. */
hawser_status dxf_add_lwpolyline(const SurveyInput *in, const DxfEntity *e)
{
    const double z = dxf_number(e, 38, 0);
    DxfCorner *const corner = calloc((size_t)e->n + 1, sizeof *corner);
    int n = 0;
    if (!corner) return error_memory(in->err);
    for (int i = 0; i < e->n; ++i) {
        const DxfNumber *const v = &e->number[i];
        if (v->code == 10) corner[n++].at = v3(v->value, 0, z);
        if (n && v->code == 20) corner[n - 1].at.y = v->value;
        if (n && v->code == 42) corner[n - 1].bulge = v->value;
    }
    const hawser_status status = dxf_add_corners(in, e, n, corner, dxf_flags(e) & 1, 0);
    free(corner);
    return status;
}

/* Part of an ellipse, in the world's coordinates: a major axis, the ratio of the minor one to it, and two parameters.
 */
hawser_status dxf_add_ellipse(const SurveyInput *in, const DxfEntity *e)
{
    enum { CHORDS_MOST = 10000 };
    const double off = 2e-4, ratio = dxf_number(e, 40, NAN), from = dxf_number(e, 41, 0),
                 to = dxf_number(e, 42, 2 * PI);
    const Vec3 centre = v3(dxf_number(e, 10, NAN), dxf_number(e, 20, NAN), dxf_number(e, 30, 0));
    const Vec3 major = v3(dxf_number(e, 11, NAN), dxf_number(e, 21, NAN), dxf_number(e, 31, 0));
    const Vec3 minor = v3_scale(ratio, v3_cross(dxf_system(in, e).axis, major));
    const double turn = to - from - 2 * PI * floor((to - from) / (2 * PI));
    if (!(v3_norm(major) > 0) || !(ratio > 0) || !isfinite(from + to + centre.x + centre.y))
        return input_error(in, "an ELLIPSE without centre, axes and parameters (groups 10, 20, 11, 21, 40, 41, 42)");
    if (turn < 1e-9 || turn > 2 * PI - 1e-9) {
        survey_ignore(in->out, "ELLIPSE: whole ones");
        return HAWSER_OK;
    }
    const double largest = in->unit * v3_norm(major) * fmax(1, ratio);
    const int n = (int)fmin(CHORDS_MOST, 8 + turn / sqrt(8 * off / largest));
    DxfCorner *const corner = calloc((size_t)n + 1, sizeof *corner);
    if (!corner) return error_memory(in->err);
    for (int i = 0; i <= n; ++i) {
        const double u = from + turn * i / n;
        corner[i].at = v3_axpy(v3_axpy(centre, cos(u), major), sin(u), minor);
    }
    const int before = in->out->n;
    const hawser_status status = dxf_add_corners(in, e, n + 1, corner, 0, 1);
    if (!status && in->out->n > before) in->out->alignment[before].bent = 1;
    free(corner);
    return status;
}
