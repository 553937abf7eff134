/* Pieces from plan and profile. */
#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "core/route_make.h"

/* Elements shorter than this are rounding, m; so are corners of less than this, rad. */
static const double LENGTH_MIN = 1e-6, CORNER_MAX = 1e-6;

/* ---------------------------------------------------------------------------------------------------- the profile */

/* Level lengths that the rounding of a corner takes before and behind it, between two slopes. */
static void corner_off(const RouteProfileCorner *c, double radius, const double slope[2], double off[2])
{
    const double round = c->radius > 0 ? c->radius : c->parabola > 0 ? 0 : radius;
    const double tangent = round * tan(fabs(slope[1] - slope[0]) / 2);
    for (int k = 0; k < 2; ++k) off[k] = round > 0 ? tangent * cos(slope[k]) : c->parabola / 2;
}

static double slope_between(const RouteProfileCorner *a)
{
    return atan2(a[1].height - a->height, a[1].station - a->station);
}

/* The grade behind corner i - 1 and the rounding of corner i; taken: of the grade by the corner before it. */
static hawser_status corner_add(int n, const RouteProfileCorner *c, int i, double radius, double *taken,
                                RouteProfile *out, hawser_error *err)
{
    const double run = c[i].station - c[i - 1].station;
    const int last = i == n - 1;
    const double slope[2] = {slope_between(&c[i - 1]), last ? 0 : slope_between(&c[i])};
    double off[2] = {0, 0};
    if (!last) corner_off(&c[i], radius, slope, off);
    const double grade = run - *taken - off[0];
    if (grade < -LENGTH_MIN) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "the profile between points %d and %d, %.4g m, is too short for the roundings at its ends, "
                         "which take %.4g m",
                         i, i + 1, run, *taken + off[0]);
    }
    RouteProfileElement *const e = out->element;
    if (grade > LENGTH_MIN) e[out->n++] = (RouteProfileElement){PROFILE_GRADE, grade, {slope[0], slope[0]}};
    if (off[0] + off[1] > LENGTH_MIN) {
        const RouteProfileKind kind = c[i].radius > 0 || !(c[i].parabola > 0) ? PROFILE_ARC : PROFILE_PARABOLA;
        e[out->n++] = (RouteProfileElement){kind, off[0] + off[1], {slope[0], slope[1]}};
    }
    *taken = off[1];
    return HAWSER_OK;
}

hawser_status route_profile_from_corners(int n, const RouteProfileCorner *corner, double radius, RouteProfile *out,
                                         hawser_error *err)
{
    assert(n >= 2 && radius > 0);
    *out = (RouteProfile){0};
    for (int i = 1; i < n; ++i) { /* before slopes between them mean anything */
        if (!(corner[i].station - corner[i - 1].station > LENGTH_MIN))
            return error_set(err, HAWSER_ERR_INPUT, "the stations of profile points %d and %d do not rise", i, i + 1);
    }
    *out = (RouteProfile){.station = corner[0].station, .height = corner[0].height};
    out->element = calloc((size_t)(2 * n), sizeof *out->element);
    hawser_status status = out->element ? HAWSER_OK : error_memory(err);
    double taken = 0;
    for (int i = 1; i < n && !status; ++i) status = corner_add(n, corner, i, radius, &taken, out, err);
    if (!status) return status;
    free(out->element);
    *out = (RouteProfile){0};
    return status;
}

/* Slope inside an element, at a level distance from its start: a parabola's tangent and an arc's sine are linear. */
static double slope_inside(const RouteProfileElement *e, double x)
{
    const double share = x / e->length;
    if (e->kind == PROFILE_GRADE) return e->slope[0];
    if (e->kind == PROFILE_PARABOLA) return atan((1 - share) * tan(e->slope[0]) + share * tan(e->slope[1]));
    return asin((1 - share) * sin(e->slope[0]) + share * sin(e->slope[1]));
}

/* Rise of an element up to there (RO12). */
static double rise_inside(const RouteProfileElement *e, double x)
{
    const double to = slope_inside(e, x);
    if (e->kind == PROFILE_ARC) return x * tan((e->slope[0] + to) / 2);
    return x * (tan(e->slope[0]) + tan(to)) / 2;
}

/* ---------------------------------------------------------------------------------------------- plan and profile */

/* How far both have been gone through. */
typedef struct Both {
    const RoutePlanElement *plan;
    const RouteProfile *profile;
    int i, k;        /* the elements */
    double at, rise; /* m, in them */
} Both;

/* The next piece: to the end of the nearer element. */
static RoutePieceDef piece_next(const Both *b, double *length)
{
    const RoutePlanElement *const plan = &b->plan[b->i];
    const RouteProfileElement level = {PROFILE_GRADE, INFINITY, {0, 0}};
    const RouteProfileElement *const e = b->profile ? &b->profile->element[b->k] : &level;
    double run = fmin(plan->length - b->at, e->length - b->rise);
    if (plan->length - b->at - run < LENGTH_MIN) run = plan->length - b->at;
    *length = run;
    const double by = (plan->curvature[1] - plan->curvature[0]) / plan->length;
    const double up = slope_inside(e, b->rise), to = slope_inside(e, fmin(b->rise + run, e->length));
    RoutePieceDef p = {.kind = ROUTE_CURVE, .length = run, .sloped = 1, .slope = up, .upright = 1};
    memcpy(p.name, plan->name, sizeof p.name);
    p.curvature[0] = plan->curvature[0] + by * b->at;
    p.curvature[1] = plan->curvature[0] + by * (b->at + run);
    p.profile = fabs(to - up) > 0 ? e->kind : PROFILE_GRADE;
    p.slope_end = to;
    return p;
}

/* As a straight or as a bend in a plane where it is one: those have closed forms. */
static RoutePieceDef piece_plain(RoutePieceDef p)
{
    const int straight = !(fabs(p.curvature[0]) + fabs(p.curvature[1]) > 0);
    const int circle = fabs(p.curvature[1] - p.curvature[0]) <= 1e-14 * fabs(p.curvature[0]);
    if (straight && p.profile == PROFILE_GRADE) {
        p.kind = ROUTE_STRAIGHT;
        p.length /= cos(p.slope);
    } else if (straight && p.profile == PROFILE_ARC) {
        p.kind = ROUTE_BEND;
        p.angle = fabs(p.slope_end - p.slope);
        p.radius = p.length / fabs(sin(p.slope_end) - sin(p.slope));
        p.plane = p.slope_end > p.slope ? M_PI / 2 : 3 * M_PI / 2;
    } else if (circle && p.profile == PROFILE_GRADE && !(fabs(p.slope) > 0)) {
        p.kind = ROUTE_BEND;
        p.radius = 1 / fabs(p.curvature[0]);
        p.angle = p.length / p.radius;
        p.plane = p.curvature[0] > 0 ? 0 : M_PI;
    }
    return p;
}

/* Where the plan begins in the profile, and that it reaches along the plan and has no corners. */
static hawser_status profile_enter(Both *b, double station, double length, double *height, hawser_error *err)
{
    const RouteProfile *const p = b->profile;
    double from = p->station, whole = p->station;
    *height = p->height;
    for (int k = 0; k < p->n; ++k) {
        const RouteProfileElement *const e = &p->element[k];
        if (k > 0 && fabs(e->slope[0] - e[-1].slope[1]) > CORNER_MAX)
            return error_set(err, HAWSER_ERR_INPUT, "the profile has a corner at station %.10g m: round it", whole);
        whole += e->length;
        if (k > b->k || station < from) continue;
        b->rise = fmin(station - from, e->length);
        if (station - from < e->length - LENGTH_MIN || k == p->n - 1) {
            *height += rise_inside(e, b->rise);
            continue;
        }
        *height += rise_inside(e, e->length);
        from += e->length;
        b->k = k + 1;
        b->rise = 0;
    }
    if (station >= p->station - LENGTH_MIN && whole >= station + length - 1e-3) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT,
                     "the profile reaches from station %.10g m to %.10g m, the plan from %.10g m to %.10g m",
                     p->station, whole, station, station + length);
}

hawser_status route_from_plan_and_profile(int n, const RoutePlanElement *plan, const RouteProfile *profile,
                                          double station, Vec3 start, double heading, RouteLine *out, hawser_error *err)
{
    assert(n >= 1);
    *out = (RouteLine){.start = start, .heading = heading};
    Both b = {.plan = plan, .profile = profile};
    double length = 0;
    for (int i = 0; i < n; ++i) length += plan[i].length;
    const hawser_status status = profile ? profile_enter(&b, station, length, &out->start.z, err) : HAWSER_OK;
    if (status) return status;
    out->piece = calloc((size_t)(n + (profile ? profile->n : 0) + 1), sizeof *out->piece);
    if (!out->piece) return error_memory(err);
    while (b.i < n) {
        double run;
        const RoutePieceDef piece = piece_next(&b, &run);
        if (run > LENGTH_MIN) out->piece[out->n++] = piece_plain(piece);
        b.at += run;
        b.rise += run;
        if (b.plan[b.i].length - b.at < LENGTH_MIN) {
            b.i++;
            b.at = 0;
        }
        /* the last grade may end a rounding before the plan does */
        if (profile && b.k + 1 < profile->n && profile->element[b.k].length - b.rise < LENGTH_MIN) {
            b.k++;
            b.rise = 0;
        } else if (profile && b.k + 1 == profile->n && profile->element[b.k].length - b.rise < LENGTH_MIN) {
            break;
        }
    }
    out->slope = out->n > 0 ? out->piece[0].slope : 0;
    return HAWSER_OK;
}
