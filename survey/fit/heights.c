/* The heights of a line, by the length in plan: its own, those of points beside it, of another alignment, or drawn. */
#include <stdlib.h>

#include "core/base/error.h"
#include "survey/fit/fit.h"
#include "survey/fit/line.h"

static const double PI = 3.14159265358979323846;

/* Points that stand beside the plan, from its start on; one at either end of the plan is put around them, to which the
 * feet of a first and a last node are tied. node, foot: [n_points + 2]. */
static hawser_status feet_of_points(const Alignment *plan, const Alignment *from, Node *node, Foot *foot,
                                    hawser_error *err)
{
    const Vec3 start = alignment_at(plan, 0).at, end = alignment_measure(plan).end;
    const int n = from->n_points;
    Piece *const piece = malloc((size_t)plan->n_plan * sizeof *piece);
    if (!piece) return error_memory(err);
    for (int q = 0; q < plan->n_plan; ++q) {
        piece[q] = (Piece){.e = plan->plan[q]};
        piece[q].e.x -= start.x;
        piece[q].e.y -= start.y;
    }
    for (int i = 0; i < n; ++i)
        node[i + 1] = (Node){.x = from->point[i].x - start.x, .y = from->point[i].y - start.y, .weight = 1};
    node[0] = (Node){.weight = 1};
    node[n + 1] = (Node){.x = end.x - start.x, .y = end.y - start.y, .weight = 1};
    const hawser_status status = chain_refine(plan->n_plan, piece, n + 2, node, 0, INFINITY, foot, err);
    for (int i = 0; i < n + 2 && !status; ++i) { /* square to it where the line has ended, else as far as it is */
        const PlanElement *const e = &piece[foot[i].piece].e, at = plan_at(e, fmin(fmax(foot[i].s, 0), e->length));
        const double x = node[i].x - at.x, y = node[i].y - at.y;
        const int on = foot[i].s >= 0 && foot[i].s <= e->length;
        foot[i].away = on ? hypot(x, y) : fabs(y * cos(at.heading) - x * sin(at.heading));
    }
    free(piece);
    return status;
}

static hawser_status point_refuse(const Alignment *from, const Vec3 *p, const char *why, double metres,
                                  hawser_error *err)
{
    return error_set(err, HAWSER_ERR_INPUT, "'%.60s': the point at %.3f, %.3f, %.3f is %.3g m %s", from->name, p->x,
                     p->y, p->z, metres, why);
}

/* Stations and heights of the points by their feet: [n_points + 2]. What lies back along the line is left out where its
 * height says nothing new. */
static hawser_status heights_at_feet(const Alignment *plan, const Alignment *from, const FitOptions *o,
                                     const Foot *foot, Line *l, hawser_error *err)
{
    const double far_off = 10;
    double start = 0, z = 0;
    hawser_status status = HAWSER_OK;
    for (int i = 0, q = 0; i < from->n_points && !status; ++i) {
        const Vec3 *const p = &from->point[i];
        const Foot *const f = &foot[i + 1];
        for (; q < f->piece; ++q) start += plan->plan[q].length;
        const double s = start + f->s, rise = fabs(p->z - z);
        const int back = l->n && s < l->node[l->n - 1].x + 1e-6;
        if (f->away > far_off + o->deviation)
            return point_refuse(from, p, "beside the line whose heights it is to give", f->away, err);
        if (back && rise > o->deviation)
            return point_refuse(from, p,
                                "above or below a point that lies no farther along the line: no profile can say that, "
                                "a 'radius' for the corners of a line of straights can",
                                rise, err);
        if (!back) z = p->z;
        if (!back && !node_add(l, s, z, from->drawn)) status = error_memory(err);
    }
    return status;
}

/* Stations and heights of points beside the plan, from its start to its end or the other way. */
static hawser_status heights_of_points(const Alignment *plan, const Alignment *from, const FitOptions *o, Line *l,
                                       hawser_error *err)
{
    const Vec3 start = alignment_at(plan, 0).at, end = alignment_measure(plan).end;
    const int n = from->n_points;
    const Vec3 *const first = &from->point[0], *const last = &from->point[n - 1];
    Alignment points;
    Node *const node = malloc((size_t)(n + 2) * sizeof *node);
    Foot *const foot = malloc((size_t)(n + 2) * sizeof *foot);
    hawser_status status = alignment_copy(from, &points) && node && foot ? HAWSER_OK : error_memory(err);
    if (!status && hypot(first->x - end.x, first->y - end.y) + hypot(last->x - start.x, last->y - start.y) <
                       hypot(first->x - start.x, first->y - start.y) + hypot(last->x - end.x, last->y - end.y))
        alignment_reverse(&points);
    if (!status) status = feet_of_points(plan, &points, node, foot, err);
    if (!status) status = heights_at_feet(plan, &points, o, foot, l, err);
    alignment_clear(&points);
    free(node);
    free(foot);
    return status;
}

/* The corners of a profile's elements, with points along its curves, `shift` m on. */
static int heights_of_profile(const Alignment *from, double shift, Line *l)
{
    int fine = 1;
    for (int i = 0; i < from->n_profile && fine; ++i) {
        const ProfileElement *const e = &from->profile[i];
        const int parts = e->bend != 0 ? CURVE_PARTS : 1;
        for (int k = 0; k <= parts && fine; ++k) {
            const ProfileElement at = profile_at(e, e->length * k / parts);
            if (!l->n || at.station + shift > l->node[l->n - 1].x + 1e-9)
                fine = node_add(l, at.station + shift, at.z, parts == 1);
        }
    }
    return fine;
}

/* A drawn profile: its points or elements' ends, x the station; the line begins at `station`. One that is drawn from
 * right to left is turned around, with what is known of the way from each place to the next. */
static int heights_drawn(const Alignment *from, double station, Line *l)
{
    if (!plan_line(from, v3(station, 0, 0), l)) return 0;
    const int leftward = l->n > 1 && l->node[0].x > l->node[l->n - 1].x;
    for (int i = l->n - 1; leftward && i > 0; --i) l->node[i].drawn = l->node[i - 1].drawn;
    for (int i = 0, j = l->n - 1; leftward && i < j; ++i, --j) {
        const Node kept = l->node[i];
        l->node[i] = l->node[j];
        l->node[j] = kept;
    }
    return 1;
}

static hawser_status profile_take(const Piece *p, Alignment *out, hawser_error *err)
{
    const PlanElement end = plan_at(&p->e, p->e.length);
    if (fmax(fabs(p->e.heading), fabs(end.heading)) > 80 * PI / 180) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "'%.60s' is steeper than 80 deg %.1f m from its start: no profile can say that", out->name,
                         p->e.x);
    }
    ProfileElement *const e = alignment_add_profile(out);
    if (!e) return error_memory(err);
    *e = (ProfileElement){.kind = p->kind == PIECE_ARC ? PROFILE_ARC : PROFILE_PARABOLA,
                          .station = p->e.x,
                          .length = end.x - p->e.x,
                          .z = p->e.y,
                          .grade = tan(p->e.heading),
                          .bend = p->kind == PIECE_ARC ? p->e.k0 : 0};
    return HAWSER_OK;
}

static hawser_status heights_fit(Line *l, const FitOptions *o, Alignment *out, FitReport *report, hawser_error *err)
{
    Fitted f = {0};
    if (l->n < 2)
        return error_set(err, HAWSER_ERR_INPUT, "the profile of '%.60s' has fewer than two points", out->name);
    const double z0 = l->node[0].y;
    for (int i = 0; i < l->n; ++i) l->node[i].y -= z0;
    hawser_status status = line_fit(l, o, 0, &f, err);
    for (int i = 0; i < f.n && !status; ++i) {
        f.piece[i].e.y += z0;
        status = profile_take(&f.piece[i], out, err);
    }
    if (!status) fitted_deviations(&f, &report->largest_height, &report->rms_height);
    fitted_clear(&f);
    return status;
}

static int is_smooth_profile(const Alignment *a)
{
    for (int i = 1; i < a->n_profile; ++i) {
        const ProfileElement end = profile_at(&a->profile[i - 1], a->profile[i].station - a->profile[i - 1].station);
        if (fabs(end.z - a->profile[i].z) > 1e-3 || fabs(end.grade - a->profile[i].grade) > 1e-3) return 0;
    }
    return 1;
}

/* The profile of an alignment as it is; `shift`, m, from its stations to those of the line. */
static hawser_status profile_copy(const Alignment *from, double shift, Alignment *out, hawser_error *err)
{
    for (int i = 0; i < from->n_profile; ++i) {
        ProfileElement *const e = alignment_add_profile(out);
        if (!e) return error_memory(err);
        *e = from->profile[i];
        e->station += shift;
    }
    return HAWSER_OK;
}

/* Heights of another file must reach along all of the line: within a metre, over which the last grades go on. */
static hawser_status reach_check(const Alignment *from, const Alignment *out, hawser_error *err)
{
    const double slack = 1, length = alignment_measure(out).plan_length;
    if (out->n_profile == 0) return HAWSER_OK;
    const ProfileElement *const last = &out->profile[out->n_profile - 1];
    const double begin = out->profile[0].station, end = last->station + last->length;
    if (begin <= slack && end >= length - slack) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT,
                     "the heights of '%.60s' reach from station %.3f to %.3f m, and the line '%.60s' is from %.3f to "
                     "%.3f m: they must reach along all of it, by the same stations",
                     from->name, out->station + begin, out->station + end, out->name, out->station,
                     out->station + length);
}

hawser_status profile_fit(const Alignment *line, const Alignment *profile, const FitOptions *o, Alignment *out,
                          FitReport *report, hawser_error *err)
{
    const Alignment *const from = profile ? profile : line;
    const double shift = from->station - line->station;
    Line l = {0, NULL};
    hawser_status status = HAWSER_OK;
    if (o->profile_drawn && from->n_profile == 0)
        status = heights_drawn(from, line->station, &l) ? HAWSER_OK : error_memory(err);
    else if (from->n_profile == 0 && (from->flat || from->n_points == 0))
        return HAWSER_OK; /* level at 0 */
    else if (from->n_profile && is_smooth_profile(from))
        status = profile_copy(from, shift, out, err);
    else if (from->n_profile)
        status = heights_of_profile(from, shift, &l) ? HAWSER_OK : error_memory(err);
    else
        status = heights_of_points(out, from, o, &l, err);
    if (!status && out->n_profile == 0) status = heights_fit(&l, o, out, report, err);
    if (!status && profile) status = reach_check(from, out, err);
    free(l.node);
    return status;
}
