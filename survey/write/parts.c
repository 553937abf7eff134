#include "survey/write/parts.h"

#include <math.h>
#include <stdlib.h>

#include "core/base/error.h"

static const double chord_off = 5e-5; /* m */

static int stretch_add(Stretches *out, Stretch item)
{
    Stretch *const added = survey_one_more(&out->item, &out->n, sizeof *added);
    if (added) *added = item;
    return added != NULL;
}

/* The profile from s on, beyond its ends on its first and last grade. */
static ProfileElement profile_from(const Alignment *a, int j, double s)
{
    if (a->n_profile == 0) return (ProfileElement){.station = s};
    const ProfileElement *const e = &a->profile[j];
    const double at = fmin(fmax(s - e->station, 0), e->length);
    ProfileElement from = profile_at(e, at);
    from.z += from.grade * (s - e->station - at);
    if (s < e->station || s >= e->station + e->length) from.bend = 0;
    from.station = s;
    return from;
}

/* Where the profile changes next behind s; j: its element there. */
static double profile_next(const Alignment *a, int *j, double s)
{
    const double near = 1e-9;
    while (*j + 1 < a->n_profile && a->profile[*j + 1].station <= s + near) ++*j;
    if (a->n_profile == 0) return INFINITY;
    const ProfileElement *const e = &a->profile[*j];
    if (e->station > s + near) return e->station;
    if (e->station + e->length > s + near)
        return *j + 1 < a->n_profile ? fmin(e->station + e->length, e[1].station) : e->station + e->length;
    return *j + 1 < a->n_profile ? e[1].station : INFINITY;
}

/* Element i in plan; of a line of points the straight to the next one. */
static PlanElement plan_element(const Alignment *a, int i)
{
    if (a->n_plan) return a->plan[i];
    const Vec3 *const p = &a->point[i];
    return (PlanElement){.x = p->x,
                         .y = p->y,
                         .heading = atan2(p[1].y - p->y, p[1].x - p->x),
                         .length = hypot(p[1].x - p->x, p[1].y - p->y)};
}

hawser_status stretches_make(const Alignment *a, Stretches *out, hawser_error *err)
{
    const int n = a->n_plan ? a->n_plan : a->n_points - 1;
    double station = 0;
    int j = 0;
    *out = (Stretches){0, NULL};
    for (int i = 0; i < n; ++i) {
        const PlanElement e = plan_element(a, i);
        const double end = station + e.length;
        for (double s = station; s < end - 1e-9;) {
            const double next = fmin(profile_next(a, &j, s), end);
            PlanElement from = s > station ? plan_at(&e, s - station) : e;
            from.k1 = plan_at(&e, next - station).k0;
            from.length = next - s;
            ProfileElement profile = profile_from(a, j, s);
            profile.length = next - s;
            if (!stretch_add(out, (Stretch){s, from, profile})) return error_memory(err);
            s = next;
        }
        station = end;
    }
    return HAWSER_OK;
}

/* Into how many parts, of which chords are not off by more than chord_off. */
static int parts_of(const Stretch *s)
{
    const double steep = fmin(fabs(s->profile.grade), 10), k = fmax(fabs(s->plan.k0), fabs(s->plan.k1));
    const double bend = fabs(s->profile.bend) * (s->profile.kind == PROFILE_ARC ? pow(1 + steep * steep, 1.5) : 1);
    return (int)fmin(1 + s->plan.length * sqrt((k + bend) / (8 * chord_off)), 1e7);
}

hawser_status vertices_make(const Alignment *a, int *n, Vec3 **vertex, hawser_error *err)
{
    Stretches s = {0, NULL};
    const int points = a->n_plan == 0 && a->n_profile == 0;
    hawser_status status = points ? HAWSER_OK : stretches_make(a, &s, err);
    double all = points ? a->n_points : 1;
    for (int i = 0; i < s.n; ++i) all += parts_of(&s.item[i]);
    *n = 0;
    *vertex = NULL;
    if (!status && all > SURVEY_MOST)
        status = error_set(err, HAWSER_ERR_INPUT, "'%.60s' has too many corners", a->name);
    if (!status && !(*vertex = malloc((size_t)(all + 1) * sizeof **vertex))) status = error_memory(err);
    for (int i = 0; points && i < a->n_points && !status; ++i) (*vertex)[(*n)++] = a->point[i];
    for (int i = 0; i < s.n && !status; ++i) {
        const int parts = parts_of(&s.item[i]), last = i + 1 == s.n;
        for (int k = 0; k < parts + last; ++k) {
            const double along = s.item[i].plan.length * k / parts;
            const PlanElement p = plan_at(&s.item[i].plan, along);
            (*vertex)[(*n)++] = v3(p.x, p.y, profile_at(&s.item[i].profile, along).z);
        }
    }
    free(s.item);
    if (status) free(*vertex), *vertex = NULL;
    return status;
}
