/* A part of an alignment. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "survey/alignment.h"

/* What is left of an element or straight is dropped below this, m: a rounded station is where the element ends. */
static const double LEAST = 1e-4;

static void plan_cut(Alignment *a, double from, double to)
{
    double s = 0;
    int n = 0;
    for (int i = 0; i < a->n_plan; ++i) {
        const PlanElement e = a->plan[i];
        const double begin = fmax(from - s, 0), end = fmin(to - s, e.length);
        s += e.length;
        if (end - begin < LEAST) continue;
        PlanElement *const part = &a->plan[n++];
        *part = plan_at(&e, begin);
        part->length = end - begin;
        part->k1 = plan_at(&e, end).k0;
    }
    a->n_plan = n;
}

/* Where the part begins behind an element's end, or lies before the first one, that element's grade goes on, as it does
 * on the whole line. */
static void profile_cut(Alignment *a, double from, double to)
{
    const AlignmentPlace at = alignment_at(a, from);
    int n = 0, last = 0, first = -1; /* the element whose grade is that of `from`, and the first one that is kept */
    while (last + 1 < a->n_profile && from >= a->profile[last + 1].station) ++last;
    for (int i = 0; i < a->n_profile; ++i) {
        const ProfileElement e = a->profile[i];
        const double begin = fmax(from - e.station, 0), end = fmin(to - e.station, e.length);
        if (end - begin < LEAST) continue;
        ProfileElement *const part = &a->profile[n++];
        *part = profile_at(&e, begin);
        part->station = e.station + begin - from;
        part->length = end - begin;
        if (first < 0) first = i;
    }
    const double lead = n ? a->profile[0].station : to - from;
    if (a->n_profile > 0 && first != last && lead >= LEAST) {
        memmove(a->profile + 1, a->profile, (size_t)n * sizeof *a->profile); /* there is room: `last` is not kept */
        a->profile[0] = (ProfileElement){.length = lead, .z = at.at.z, .grade = at.grade};
        ++n;
    }
    a->n_profile = n;
}

/* Corners between the ends, and both ends. */
static hawser_status points_cut(Alignment *a, double from, double to, hawser_error *err)
{
    Vec3 *const point = malloc((size_t)(a->n_points + 2) * sizeof *point);
    if (!point) return error_memory(err);
    int n = 0;
    double s = 0;
    for (int i = 0; i + 1 < a->n_points; ++i) {
        const Vec3 way = v3_sub(a->point[i + 1], a->point[i]);
        const double length = hypot(way.x, way.y), begin = fmax(from - s, 0), end = fmin(to - s, length);
        const int inside = s > from + LEAST && s < to - LEAST;
        if (n == 0 && end - begin >= LEAST)
            point[n++] = v3_axpy(a->point[i], begin / length, way);
        else if (inside)
            point[n++] = a->point[i];
        if (n > 0 && length > 0 && s < to - LEAST && s + length >= to - LEAST)
            point[n++] = v3_axpy(a->point[i], fmin((to - s) / length, 1), way);
        s += length;
    }
    for (int i = 0; i < n; ++i) a->point[i] = point[i]; /* never more than there were: the ends stand for corners */
    a->n_points = n;
    free(point);
    return HAWSER_OK;
}

hawser_status alignment_cut(Alignment *a, double from, double to, hawser_error *err)
{
    const double length = alignment_measure(a).plan_length;
    if (!(from >= -1e-6 && to <= length + 1e-6 && to - from > 1e-2)) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "'%.60s' reaches from station %.10g m to %.10g m: a part of it from %.10g m to %.10g m cannot "
                         "be cut out",
                         a->name, a->station, a->station + length, a->station + from, a->station + to);
    }
    profile_cut(a, from, to);
    plan_cut(a, from, to);
    const hawser_status status = a->n_points ? points_cut(a, from, to, err) : HAWSER_OK;
    a->station += from;
    a->stated_length = NAN;
    return status;
}
