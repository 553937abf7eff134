/* Pieces from straights with slopes, and from points. */
#include "core/route_make.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/base/error.h"

/* Lengths and angles below these are rounding, m and rad. */
static const double LENGTH_MIN = 1e-9, ANGLE_MIN = 1e-10;

/* A line with room for so many pieces. Errors: MEMORY. */
static hawser_status line_new(RouteLine *out, int room, Vec3 start, double heading, double slope, hawser_error *err)
{
    *out = (RouteLine){.start = start, .heading = heading, .slope = slope};
    out->piece = calloc((size_t)room, sizeof *out->piece);
    return out->piece ? HAWSER_OK : error_memory(err);
}

static hawser_status line_drop(RouteLine *line, hawser_status status)
{
    if (!status) return status;
    free(line->piece);
    *line = (RouteLine){0};
    return status;
}

/* ------------------------------------------------------------------------------------------- changes of slope */

/* What the corners take off each straight, and the slopes at its start. */
typedef struct Corner {
    double change;        /* rad, of slope where the piece begins */
    double ahead, behind; /* m off this piece at its start; off the one before at its end */
} Corner;

/* The corners of the line as it is, by building it. Errors: MEMORY. */
static hawser_status corners_find(int n, const RoutePieceDef *def, const RouteLine *line, double radius, Corner *corner,
                                  hawser_error *err)
{
    Route route;
    const hawser_status status = route_build(&route, n, def, V3_ZERO, line->heading, line->slope, err);
    if (status) return status;
    for (int i = 1; i < n; ++i) {
        if (!def[i].sloped || def[i].kind != ROUTE_STRAIGHT) continue;
        const Vec3 before = route_on_piece(&route, i - 1, route.length).tangent;
        corner[i].change = def[i].slope - atan2(before.z, hypot(before.x, before.y));
        if (fabs(corner[i].change) < ANGLE_MIN) continue;
        const double off = radius * tan(fabs(corner[i].change) / 2);
        const int shared = def[i - 1].kind == ROUTE_STRAIGHT;
        corner[i].ahead = shared ? off : 2 * off;
        corner[i].behind = shared ? off : 0;
    }
    route_clear(&route);
    return HAWSER_OK;
}

hawser_status route_round_slopes(int n, const RoutePieceDef *def, double heading, double slope, double radius,
                                 RouteLine *out, hawser_error *err)
{
    assert(n >= 1 && radius > 0);
    hawser_status status = line_new(out, 2 * n, V3_ZERO, heading, def[0].sloped ? def[0].slope : slope, err);
    Corner *const corner = calloc((size_t)n + 1, sizeof *corner);
    if (!status && !corner) status = error_memory(err);
    if (!status) status = corners_find(n, def, out, radius, corner, err);
    for (int i = 0; i < n && !status; ++i) {
        if (fabs(corner[i].change) >= ANGLE_MIN) {
            out->piece[out->n++] = (RoutePieceDef){.kind = ROUTE_BEND,
                                                   .name = "change of slope",
                                                   .radius = radius,
                                                   .angle = fabs(corner[i].change),
                                                   .plane = corner[i].change > 0 ? M_PI / 2 : 3 * M_PI / 2};
        }
        RoutePieceDef piece = def[i];
        const double off = corner[i].ahead + corner[i + 1].behind;
        if (piece.kind == ROUTE_STRAIGHT) piece.length -= off;
        if (piece.kind == ROUTE_STRAIGHT && piece.length < -LENGTH_MIN) {
            status = error_set(err, HAWSER_ERR_INPUT,
                               "piece %d ('%s'), %g m long, is too short for the changes of slope at its ends: with a "
                               "transition radius of %g m they take %.4g m",
                               i, piece.name, def[i].length, radius, off);
        }
        if (piece.kind != ROUTE_STRAIGHT || piece.length > LENGTH_MIN) out->piece[out->n++] = piece;
    }
    free(corner);
    return line_drop(out, status);
}

/* ------------------------------------------------------------------------------------------------------ polylines */

/* Where a polyline has got to. */
typedef struct Walk {
    Vec3 tangent, left;
    double taken; /* m of the leg ahead that the last corner took */
} Walk;

/* The level left behind a turn from w->tangent to `ahead`, as route_left finds it (R3). */
static Vec3 left_behind(const Walk *w, Vec3 ahead, Vec3 centre, double turn)
{
    Vec3 left = route_level_left(ahead);
    if (v3_norm(left) > 0.5) return left;
    left = route_level_left(v3_axpy(v3_scale(-cos(turn), centre), sin(turn), w->tangent));
    return v3_norm(left) > 0.5 ? left : w->left;
}

/* Corner i: the straight before it and its bend. */
static hawser_status corner_take(const RouteCorner *corner, int i, Walk *w, RouteLine *out, hawser_error *err)
{
    const Vec3 back = v3_sub(corner[i].point, corner[i - 1].point), on = v3_sub(corner[i + 1].point, corner[i].point);
    const Vec3 ahead = v3_unit(on), centre = v3_unit(v3_reject(ahead, w->tangent));
    const double sine = v3_norm(v3_cross(w->tangent, ahead)), turn = atan2(sine, v3_dot(w->tangent, ahead));
    if (turn > M_PI - 1e-3)
        return error_set(err, HAWSER_ERR_INPUT, "the points %d to %d turn back on themselves", i, i + 2);
    const double off = turn > ANGLE_MIN ? corner[i].radius * tan(turn / 2) : 0;
    const double straight = v3_norm(back) - w->taken - off;
    if (straight < -LENGTH_MIN || off > v3_norm(on) + LENGTH_MIN) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "the points beside point %d are too near for a radius of %g m, which takes %.4g m on either "
                         "side: the legs are %.4g m (%.4g m of it taken) and %.4g m long",
                         i + 1, corner[i].radius, off, v3_norm(back), w->taken, v3_norm(on));
    }
    RoutePieceDef *const at = out->piece;
    if (straight > LENGTH_MIN) at[out->n++] = (RoutePieceDef){.kind = ROUTE_STRAIGHT, .length = straight};
    w->taken = off;
    if (!(off > 0)) return HAWSER_OK;
    const Vec3 up = v3_cross(w->tangent, w->left);
    at[out->n] = (RoutePieceDef){.kind = ROUTE_BEND,
                                 .radius = corner[i].radius,
                                 .angle = turn,
                                 .plane = atan2(v3_dot(centre, up), v3_dot(centre, w->left))};
    snprintf(at[out->n++].name, ROUTE_NAME_MAX, "point %d", i + 1);
    w->left = left_behind(w, ahead, centre, turn);
    w->tangent = ahead;
    return HAWSER_OK;
}

static hawser_status points_check(int n, const Vec3 *point, size_t stride, hawser_error *err)
{
    for (int i = 1; i < n; ++i) {
        const Vec3 a = *(const Vec3 *)((const char *)point + (size_t)(i - 1) * stride);
        const Vec3 b = *(const Vec3 *)((const char *)point + (size_t)i * stride);
        if (!(v3_norm(v3_sub(b, a)) > 1e-6))
            return error_set(err, HAWSER_ERR_INPUT, "the points %d and %d are the same", i, i + 1);
    }
    return HAWSER_OK;
}

hawser_status route_from_corners(int n, const RouteCorner *corner, RouteLine *out, hawser_error *err)
{
    assert(n >= 2);
    *out = (RouteLine){0};
    hawser_status status = points_check(n, &corner->point, sizeof *corner, err);
    if (status) return status;
    const Vec3 first = v3_unit(v3_sub(corner[1].point, corner[0].point));
    const double heading = hypot(first.x, first.y) > 1e-9 ? atan2(first.y, first.x) : 0;
    status = line_new(out, 2 * n, corner[0].point, heading, atan2(first.z, hypot(first.x, first.y)), err);
    Walk w = {.tangent = first, .left = v3(-sin(heading), cos(heading), 0)};
    for (int i = 1; i + 1 < n && !status; ++i) status = corner_take(corner, i, &w, out, err);
    if (status) return line_drop(out, status);
    const double last = v3_norm(v3_sub(corner[n - 1].point, corner[n - 2].point)) - w.taken;
    if (last > LENGTH_MIN) out->piece[out->n++] = (RoutePieceDef){.kind = ROUTE_STRAIGHT, .length = last};
    return HAWSER_OK;
}

/* --------------------------------------------------------------------------------------------------------- splines */

/* Second derivatives by chord length at the points, natural ends: the tridiagonal system of (RO15) by elimination;
 * share[n] is scratch. */
static void spline_bend(int n, const Vec3 *point, double *share, Vec3 *bend)
{
    bend[0] = bend[n - 1] = V3_ZERO;
    share[0] = 0;
    for (int i = 1; i + 1 < n; ++i) {
        const Vec3 back = v3_sub(point[i], point[i - 1]), on = v3_sub(point[i + 1], point[i]);
        const double h0 = v3_norm(back), h1 = v3_norm(on), pivot = 2 * (h0 + h1) - h0 * share[i - 1];
        const Vec3 right = v3_scale(6, v3_sub(v3_scale(1 / h1, on), v3_scale(1 / h0, back)));
        bend[i] = v3_scale(1 / pivot, v3_axpy(right, -h0, bend[i - 1]));
        share[i] = h1 / pivot;
    }
    for (int i = n - 2; i > 0; --i) bend[i] = v3_axpy(bend[i], -share[i], bend[i + 1]);
}

hawser_status route_from_spline(int n, const Vec3 *point, RouteLine *out, hawser_error *err)
{
    assert(n >= 2);
    *out = (RouteLine){0};
    hawser_status status = points_check(n, point, sizeof *point, err);
    if (status) return status;
    Vec3 *const bend = malloc((size_t)n * sizeof *bend);
    double *const share = malloc((size_t)n * sizeof *share);
    status = line_new(out, n, point[0], 0, 0, err);
    if (!status && !(bend && share)) status = error_memory(err);
    if (!status) spline_bend(n, point, share, bend);
    for (int i = 0; i + 1 < n && !status; ++i) {
        const Vec3 way = v3_sub(point[i + 1], point[i]);
        const double h2 = v3_dot(way, way);
        RoutePieceDef *const p = &out->piece[out->n++];
        p->kind = ROUTE_CUBIC;
        p->cubic[0] = v3_axpy(way, -h2 / 6, v3_add(v3_scale(2, bend[i]), bend[i + 1]));
        p->cubic[1] = v3_scale(h2 / 2, bend[i]);
        p->cubic[2] = v3_scale(h2 / 6, v3_sub(bend[i + 1], bend[i]));
        snprintf(p->name, sizeof p->name, "points %d to %d", i + 1, i + 2);
    }
    if (!status) {
        const Vec3 first = out->piece[0].cubic[0];
        out->heading = atan2(first.y, first.x);
        out->slope = atan2(first.z, hypot(first.x, first.y));
    }
    free(bend);
    free(share);
    return line_drop(out, status);
}
