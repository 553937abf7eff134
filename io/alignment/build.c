/* From elements in plan and of the profile, or from corners, to pieces of a route. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "io/alignment/line.h"

/* m: what is shorter is rounding. 1/m: what is straighter is straight. rad: a corner that an element of the profile may
 * lose to its neighbour. m: by how much a corner that is none may be cut. */
static const double SHORT = 1e-6, STRAIGHT = 1e-9, BENT = 5e-3, CUT = 1e-3;

/* ---------------------------------------------------------------------------------------------------- the profile */

typedef struct Slopes {
    int n;
    RouteProfileElement *e; /* [n] over the length in plan, end to end */
    double z;               /* m, where they begin */
} Slopes;

static void grade_add(Slopes *p, double length, double slope)
{
    if (length > SHORT) p->e[p->n++] = (RouteProfileElement){PROFILE_GRADE, length, {slope, slope}};
}

/* The profile over [0, plan]: its first and last grade go on to the ends, gaps are grades. */
static void slopes_fill(const Alignment *a, double plan, Slopes *p)
{
    double at = 0;
    p->z = alignment_at(a, 0).at.z;
    for (int i = 0; i < a->n_profile; ++i) {
        const ProfileElement *const e = &a->profile[i];
        const double begin = fmax(e->station, at), end = fmin(e->station + e->length, plan);
        const double over = alignment_at(a, 0.5 * (at + begin)).grade;
        grade_add(p, begin - at, atan(over));
        if (begin > at) at = begin;
        if (end - begin < SHORT) continue;
        const double from = profile_at(e, begin - e->station).grade, to = profile_at(e, end - e->station).grade;
        if (e->bend == 0) {
            grade_add(p, end - begin, atan(from));
        } else {
            p->e[p->n++] = (RouteProfileElement){e->kind, end - begin, {atan(from), atan(to)}};
        }
        at = end;
    }
    grade_add(p, plan - at, atan(alignment_at(a, plan).grade));
}

/* Figures are rounded: a curve's slopes are those of the grades it lies between, if that is all there is to it. 0: a
 * corner is left beside a curve, of element i and the next. */
static int curve_settle(Slopes *p, int i)
{
    RouteProfileElement *const a = &p->e[i], *const b = a + 1;
    const int bent = a->kind != PROFILE_GRADE || b->kind != PROFILE_GRADE;
    if (!bent) return 1;
    if (fabs(b->slope[0] - a->slope[1]) > BENT) return 0;
    if (b->kind != PROFILE_GRADE)
        b->slope[0] = a->slope[1];
    else
        a->slope[1] = b->slope[0];
    return 1;
}

/* Radius and tangent length of the arc at a corner between two grades: the least radius, or one that cuts the corner by
 * a millimetre if that is larger and there is room. */
static double corner_tangent(const RouteProfileElement *a, const RouteProfileElement *b, double rounding)
{
    const double half = 0.5 * fabs(b->slope[0] - a->slope[1]);
    const double room = 0.45 * fmin(a->length / cos(a->slope[0]), b->length / cos(b->slope[0]));
    return fmax(rounding * tan(half), fmin(room, 2 * CUT / half));
}

/* Puts an arc between every two grades that differ, (AL5). */
static hawser_status corners_round(const Alignment *a, double rounding, Slopes *p, hawser_error *err)
{
    RouteProfileElement *const out = calloc((size_t)(2 * p->n + 1), sizeof *out);
    int n = 0;
    double station = a->station;
    if (!out) return error_memory(err);
    for (int i = 0; i < p->n; ++i) {
        RouteProfileElement *const e = &p->e[i], *const next = e + 1;
        station += e->length;
        out[n++] = *e;
        if (i + 1 == p->n || fabs(next->slope[0] - e->slope[1]) < 1e-9) continue;
        const double tangent = corner_tangent(e, next, rounding);
        const double before = tangent * cos(e->slope[0]), behind = tangent * cos(next->slope[0]);
        if (before > out[n - 1].length - SHORT || behind > next->length - SHORT) {
            free(out);
            return error_set(err, HAWSER_ERR_INPUT,
                             "'%.60s': the profile's corner at station %.10g m cannot be rounded with a radius of "
                             "%.4g m: the grades beside it are too short",
                             a->name, station, rounding);
        }
        out[n - 1].length -= before;
        next->length -= behind;
        out[n++] = (RouteProfileElement){PROFILE_ARC, before + behind, {e->slope[1], next->slope[0]}};
    }
    free(p->e);
    p->e = out;
    p->n = n;
    return HAWSER_OK;
}

static hawser_status slopes_make(const Alignment *a, double plan, double rounding, Slopes *p, hawser_error *err)
{
    *p = (Slopes){.e = calloc((size_t)(2 * a->n_profile + 2), sizeof *p->e)};
    if (!p->e) return error_memory(err);
    slopes_fill(a, plan, p);
    for (int i = 0; i + 1 < p->n; ++i) {
        if (curve_settle(p, i)) continue;
        return error_set(err, HAWSER_ERR_INPUT, "'%.60s': the profile has a corner of %.3g deg beside a curve", a->name,
                         fabs(p->e[i + 1].slope[0] - p->e[i].slope[1]) * 180 / acos(-1));
    }
    return corners_round(a, rounding, p, err);
}

/* ------------------------------------------------------------------------------------------------------- the line */

/* The i-th element, from 0 on, by the name that the file gives it, or else by its kind and number. */
static RoutePlanElement plan_element(const Alignment *a, int i)
{
    const PlanElement *const e = &a->plan[i];
    const char *const name = piece_names_get(&a->names, e->name);
    RoutePlanElement p = {.length = e->length, .curvature = {e->k0, e->k1}};
    const double most = fmax(fabs(e->k0), fabs(e->k1)), change = fabs(e->k1 - e->k0) * e->length;
    const char *const kind = most < STRAIGHT ? "straight" : change < 1e-12 ? "arc" : "clothoid";
    if (*name)
        snprintf(p.name, sizeof p.name, "%s", name);
    else
        snprintf(p.name, sizeof p.name, "%s %d", kind, i + 1);
    if (change < 1e-12) p.curvature[1] = p.curvature[0];
    if (fabs(p.curvature[0]) < STRAIGHT) p.curvature[0] = 0;
    if (fabs(p.curvature[1]) < STRAIGHT) p.curvature[1] = 0;
    return p;
}

static hawser_status elements_route(const Alignment *a, const LineOptions *options, Vec3 origin, RouteLine *out,
                                    hawser_error *err)
{
    const AlignmentMeasure m = alignment_measure(a);
    const double height = isnan(options->height) ? 0 : options->height;
    const Vec3 start = v3_sub(v3(a->plan[0].x, a->plan[0].y, a->n_profile ? 0 : height), origin);
    Slopes slopes = {.e = NULL};
    RoutePlanElement *const plan = calloc((size_t)a->n_plan, sizeof *plan);
    hawser_status status = plan ? HAWSER_OK : error_memory(err);
    for (int i = 0; i < a->n_plan && !status; ++i) plan[i] = plan_element(a, i);
    if (!status && a->n_profile) status = slopes_make(a, m.plan_length, options->rounding, &slopes, err);
    if (!status) {
        const RouteProfile profile = {.height = slopes.z - origin.z, .n = slopes.n, .element = slopes.e};
        status = route_from_plan_and_profile(a->n_plan, plan, a->n_profile ? &profile : NULL, 0, start,
                                             a->plan[0].heading, out, err);
    }
    free(slopes.e);
    free(plan);
    return status;
}

/* Points whose corners have a radius. */
static hawser_status corners_route(const Alignment *a, const LineOptions *options, Vec3 origin, RouteLine *out,
                                   hawser_error *err)
{
    RouteCorner *const corner = calloc((size_t)a->n_points, sizeof *corner);
    if (!corner) return error_memory(err);
    for (int i = 0; i < a->n_points; ++i) {
        corner[i] = (RouteCorner){a->point[i], options->corner};
        if (a->flat) corner[i].point.z = isnan(options->height) ? 0 : options->height;
        corner[i].point = v3_sub(corner[i].point, origin);
    }
    const hawser_status status = route_from_corners(a->n_points, corner, out, err);
    free(corner);
    return status;
}

hawser_status line_route(const UsedLine *used, const LineOptions *options, Vec3 origin, RouteLine *out,
                         hawser_error *err)
{
    *out = (RouteLine){.n = 0};
    const Alignment *const a = &used->line;
    return a->n_plan ? elements_route(a, options, origin, out, err) : corners_route(a, options, origin, out, err);
}
