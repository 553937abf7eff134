/* From corners to straights and arcs: (AL13) of docs/model/16-alignments.md. */
#include <math.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "survey/alignment.h"

static const double STRAIGHT = 1e-6; /* rad: what turns less is no corner */

/* A corner between two legs. */
typedef struct Leg {
    double length, heading; /* m, rad */
} Leg;

static double turn_at(const Leg *in, const Leg *out) { return remainder(out->heading - in->heading, 2 * acos(-1)); }

static hawser_status legs_make(int n, const PlanCorner *corner, Leg *leg, int *wrong, hawser_error *err)
{
    for (int i = 0; i + 1 < n; ++i) {
        const double x = corner[i + 1].at.x - corner[i].at.x, y = corner[i + 1].at.y - corner[i].at.y;
        leg[i] = (Leg){hypot(x, y), atan2(y, x)};
        *wrong = i + 1;
        if (!(leg[i].length > 1e-6))
            return error_set(err, HAWSER_ERR_INPUT, "corners %d and %d are at one place in plan", i + 1, i + 2);
    }
    return HAWSER_OK;
}

/* m, that the arc at corner i takes of either leg; NAN with the reason: it has no radius. */
static double tangent_at(const PlanCorner *corner, const Leg *leg, int i, hawser_error *err)
{
    const double turn = fabs(turn_at(&leg[i - 1], &leg[i])), half = tan(turn / 2);
    if (turn < STRAIGHT) return 0;
    const double room = 0.5 * fmin(leg[i - 1].length, leg[i].length) / half;
    if (!(corner[i].radius > 0)) {
        error_set(err, HAWSER_ERR_INPUT,
                  "the corner at %.3f, %.3f turns by %.1f deg and has no radius: give it one, or one 'radius' for all, "
                  "such as %.3g m",
                  corner[i].at.x, corner[i].at.y, turn * 180 / acos(-1), fmin(room, 5));
        return NAN;
    }
    return corner[i].radius * half;
}

static hawser_status arcs_add(Alignment *a, int n, const PlanCorner *corner, const Leg *leg, const double *tangent)
{
    for (int i = 0; i + 1 < n; ++i) {
        const double before = i ? tangent[i] : 0, behind = i + 2 < n ? tangent[i + 1] : 0;
        const double c = cos(leg[i].heading), s = sin(leg[i].heading), straight = leg[i].length - before - behind;
        if (straight > 1e-6) {
            PlanElement *const e = alignment_add_plan(a);
            if (!e) return HAWSER_ERR_MEMORY;
            *e = (PlanElement){.x = corner[i].at.x + c * before,
                               .y = corner[i].at.y + s * before,
                               .heading = leg[i].heading,
                               .length = straight};
        }
        const double turn = i + 2 < n ? turn_at(&leg[i], &leg[i + 1]) : 0;
        if (fabs(turn) < STRAIGHT) continue;
        PlanElement *const e = alignment_add_plan(a);
        const double k = copysign(1 / corner[i + 1].radius, turn);
        if (!e) return HAWSER_ERR_MEMORY;
        *e = (PlanElement){.x = corner[i + 1].at.x - c * behind,
                           .y = corner[i + 1].at.y - s * behind,
                           .heading = leg[i].heading,
                           .length = turn / k,
                           .k0 = k,
                           .k1 = k};
    }
    return HAWSER_OK;
}

/* Heights of corners count at the middle of their arcs. */
static hawser_status grades_add(Alignment *a, int n, const PlanCorner *corner, const Leg *leg, const double *tangent,
                                hawser_error *err)
{
    ProfileCorner *const rise = calloc((size_t)n, sizeof *rise);
    if (!rise) return error_memory(err);
    double station = 0;
    rise[0] = (ProfileCorner){.z = corner[0].at.z};
    for (int i = 0; i + 1 < n; ++i) {
        const double half[2] = {
            i && tangent[i] > 0 ? corner[i].radius * fabs(turn_at(&leg[i - 1], &leg[i])) / 2 : 0,
            i + 2 < n && tangent[i + 1] > 0 ? corner[i + 1].radius * fabs(turn_at(&leg[i], &leg[i + 1])) / 2 : 0};
        station += half[0] + leg[i].length - (i ? tangent[i] : 0) - (i + 2 < n ? tangent[i + 1] : 0) + half[1];
        rise[i + 1] = (ProfileCorner){.station = station, .z = corner[i + 1].at.z};
    }
    const hawser_status status = profile_from_corners(a, n, rise, err);
    free(rise);
    return status;
}

hawser_status plan_from_corners(Alignment *a, int n, const PlanCorner *corner, int heights, int *wrong,
                                hawser_error *err)
{
    Leg *const leg = calloc((size_t)n, sizeof *leg);
    double *const tangent = calloc((size_t)n, sizeof *tangent);
    hawser_status status = leg && tangent ? HAWSER_OK : error_memory(err);
    *wrong = 0;
    if (!status) status = legs_make(n, corner, leg, wrong, err);
    for (int i = 1; i + 1 < n && !status; ++i) {
        tangent[i] = tangent_at(corner, leg, i, err);
        *wrong = i;
        if (isnan(tangent[i])) status = HAWSER_ERR_INPUT;
    }
    for (int i = 0; i + 1 < n && !status; ++i) {
        if (tangent[i] + tangent[i + 1] <= leg[i].length + 1e-6) continue;
        *wrong = tangent[i + 1] > tangent[i] ? i + 1 : i;
        status = error_set(err, HAWSER_ERR_INPUT,
                           "the corner at %.3f, %.3f has no room for a radius of %.4g m: the leg of %.4g m is %.4g m "
                           "too short",
                           corner[*wrong].at.x, corner[*wrong].at.y, corner[*wrong].radius, leg[i].length,
                           tangent[i] + tangent[i + 1] - leg[i].length);
    }
    if (!status && arcs_add(a, n, corner, leg, tangent)) status = error_memory(err);
    if (!status && heights) status = grades_add(a, n, corner, leg, tangent, err);
    free(leg);
    free(tangent);
    return status;
}

double corners_radius(int n, const Vec3 *point, double least, int *corners, double *most)
{
    static const double usual[] = {10, 5, 3, 2, 1, 0.5, 0.2, 0.1};
    *corners = 0;
    *most = INFINITY;
    double before = 0; /* half tangent of the last corner */
    for (int i = 0; i + 1 < n; ++i) {
        const Vec3 in = v3_sub(point[i + 1], point[i]);
        const Vec3 out = i + 2 < n ? v3_sub(point[i + 2], point[i + 1]) : in;
        const double turn = fabs(remainder(atan2(out.y, out.x) - atan2(in.y, in.x), 2 * acos(-1)));
        const double half = tan(fmin(turn, 3.14) / 2), length = hypot(in.x, in.y);
        *corners += turn > least;
        if (before + half > 0) *most = fmin(*most, length / (before + half));
        before = half;
    }
    for (size_t i = 0; i < sizeof usual / sizeof *usual && *corners; ++i) {
        if (usual[i] <= *most) return usual[i];
    }
    return 0;
}
