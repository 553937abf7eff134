#include "survey/alignment.h"

#include "core/base/error.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---------------------------------------------------------------------------------------------- lists that grow */

void *survey_one_more(void *array, int *n, size_t size)
{
    void **const list = array;
    if (*n >= SURVEY_MOST) return NULL;
    if ((*n & (*n - 1)) == 0) { /* full: 0, 1, 2, 4, ... are in use */
        const size_t room = *n ? 2 * (size_t)*n : 1;
        void *const wider = realloc(*list, room * size);
        if (!wider) return NULL;
        *list = wider;
    }
    char *const item = (char *)*list + (size_t)*n * size;
    memset(item, 0, size);
    ++*n;
    return item;
}

static void name_set(char name[SURVEY_NAME_MAX], const char *text)
{
    snprintf(name, SURVEY_NAME_MAX, "%s", text ? text : "");
    text_make_printable(name);
}

Alignment *survey_add(Survey *s, const char *name)
{
    Alignment *const a = survey_one_more(&s->alignment, &s->n, sizeof *a);
    if (!a) return NULL;
    name_set(a->name, name);
    a->stated_length = NAN;
    return a;
}

PlanElement *alignment_add_plan(Alignment *a) { return survey_one_more(&a->plan, &a->n_plan, sizeof *a->plan); }
ProfileElement *alignment_add_profile(Alignment *a)
{
    return survey_one_more(&a->profile, &a->n_profile, sizeof *a->profile);
}
Vec3 *alignment_add_point(Alignment *a) { return survey_one_more(&a->point, &a->n_points, sizeof *a->point); }

SurveyMark *survey_add_mark(Survey *s, const char *name, const char *layer)
{
    SurveyMark *const mark = survey_one_more(&s->mark, &s->n_marks, sizeof *mark);
    if (!mark) return NULL;
    name_set(mark->name, name);
    name_set(mark->layer, layer);
    mark->station = mark->heading = NAN;
    return mark;
}

void survey_ignore(Survey *s, const char *what)
{
    enum { KINDS = 200 };
    const char *const kind = s->n_ignored < KINDS ? what : "others";
    for (int i = 0; i < s->n_ignored; ++i) {
        if (strncmp(s->ignored[i].what, what, SURVEY_NAME_MAX - 1) && strcmp(s->ignored[i].what, kind)) continue;
        s->ignored[i].times++;
        return;
    }
    SurveyIgnored *const item = survey_one_more(&s->ignored, &s->n_ignored, sizeof *item);
    if (!item) return;
    name_set(item->what, kind);
    item->times = 1;
}

int piece_names_add(PieceNames *names, const char *text)
{
    enum { LETTERS_MOST = 1 << 26 };
    char name[ROUTE_NAME_MAX];
    snprintf(name, sizeof name, "%s", text);
    text_make_printable(name);
    const int size = (int)strlen(name) + 1;
    if (size == 1 || names->used > LETTERS_MOST) return 0;
    if (names->used + size >= names->room) {
        const int room = 2 * (names->room + ROUTE_NAME_MAX);
        char *const wider = realloc(names->text, (size_t)room);
        if (!wider) return 0;
        names->text = wider;
        names->room = room;
    }
    if (names->used == 0) names->text[names->used++] = 0; /* number 0 is the empty one */
    const int number = names->used;
    memcpy(names->text + number, name, (size_t)size);
    names->used += size;
    return number;
}

const char *piece_names_get(const PieceNames *names, int number)
{
    return number > 0 && number < names->used ? names->text + number : "";
}

void alignment_clear(Alignment *a)
{
    free(a->names.text);
    free(a->plan);
    free(a->profile);
    free(a->point);
    *a = (Alignment){.stated_length = NAN};
}

void survey_clear(Survey *s)
{
    for (int i = 0; i < s->n; ++i) alignment_clear(&s->alignment[i]);
    free(s->alignment);
    free(s->mark);
    free(s->ignored);
    *s = (Survey){0};
}

/* n items of `size` bytes, in as much room as one_more counts on. */
static int list_copy(const void *from, int n, size_t size, void *to)
{
    size_t room = 1;
    while (room < (size_t)n) room *= 2;
    void *const list = n ? malloc(room * size) : NULL;
    *(void **)to = list;
    if (n == 0) return 1;
    if (list) memcpy(list, from, (size_t)n * size);
    return list != NULL;
}

int alignment_copy(const Alignment *from, Alignment *to)
{
    *to = *from;
    const int plan = list_copy(from->plan, from->n_plan, sizeof *from->plan, &to->plan);
    const int profile = list_copy(from->profile, from->n_profile, sizeof *from->profile, &to->profile);
    const int points = list_copy(from->point, from->n_points, sizeof *from->point, &to->point);
    const int names = list_copy(from->names.text, from->names.used, 1, &to->names.text);
    to->names.room = to->names.used;
    if (plan && profile && points && names) return 1;
    alignment_clear(to);
    return 0;
}

/* --------------------------------------------------------------------------------------------------- where it is */

/* The last of n things that begin at or before s; start: where each begins, `stride` bytes apart. */
static double plan_length(const Alignment *a)
{
    double sum = 0;
    for (int i = 0; i < a->n_plan; ++i) sum += a->plan[i].length;
    for (int i = 1; i < a->n_points; ++i) {
        sum += hypot(a->point[i].x - a->point[i - 1].x, a->point[i].y - a->point[i - 1].y);
    }
    return sum;
}

/* Beyond an element's ends it goes on straight. */
static PlanElement plan_beyond(const PlanElement *e, double s)
{
    PlanElement at = plan_at(e, fmin(fmax(s, 0), e->length));
    const double more = s - fmin(fmax(s, 0), e->length);
    if (more == 0) return at;
    at.x += more * cos(at.heading);
    at.y += more * sin(at.heading);
    at.k0 = 0;
    return at;
}

static ProfileElement profile_beyond(const ProfileElement *e, double s)
{
    ProfileElement at = profile_at(e, fmin(fmax(s, 0), e->length));
    at.z += at.grade * (s - fmin(fmax(s, 0), e->length));
    return at;
}

/* Between two corners, s metres in plan from the first; points above each other stand one behind the other. */
static AlignmentPlace between(const Vec3 *a, double s)
{
    const Vec3 way = v3_sub(a[1], a[0]);
    const double plan = hypot(way.x, way.y), part = plan > 0 ? s / plan : 0;
    return (AlignmentPlace){
        .at = v3_axpy(a[0], part, way), .heading = atan2(way.y, way.x), .grade = plan > 0 ? way.z / plan : 0};
}

static AlignmentPlace points_at(const Alignment *a, double s)
{
    int i = 0;
    for (; i + 2 < a->n_points; ++i) {
        const double step = hypot(a->point[i + 1].x - a->point[i].x, a->point[i + 1].y - a->point[i].y);
        if (s < step) break;
        s -= step;
    }
    return a->n_points > 1 ? between(&a->point[i], s) : (AlignmentPlace){.at = a->n_points ? a->point[0] : V3_ZERO};
}

static AlignmentPlace elements_at(const Alignment *a, double s)
{
    int i = 0;
    for (; i + 1 < a->n_plan && s >= a->plan[i].length; ++i) s -= a->plan[i].length;
    const PlanElement e = plan_beyond(&a->plan[i], s);
    return (AlignmentPlace){.at = {e.x, e.y, 0}, .heading = e.heading, .curvature = e.k0};
}

AlignmentPlace alignment_at(const Alignment *a, double s)
{
    AlignmentPlace place = a->n_plan ? elements_at(a, s) : points_at(a, s);
    int i = 0;
    while (i + 1 < a->n_profile && s >= a->profile[i + 1].station) ++i;
    if (a->n_profile == 0) return place;
    const ProfileElement e = profile_beyond(&a->profile[i], s - a->profile[i].station);
    place.at.z = e.z;
    place.grade = e.grade;
    return place;
}

/* ------------------------------------------------------------------------------------------------------ measures */

/* Length in space of a profile's element from s = 0 to `to` in plan: (AL7). */
static double element_length(const ProfileElement *e, double to)
{
    const double from = e->grade, at = profile_at(e, to).grade;
    if (e->bend == 0) return to * sqrt(1 + from * from);
    if (e->kind == PROFILE_ARC) return (atan(at) - atan(from)) / e->bend;
    const double change = at - from;
    if (fabs(change) < 1e-6) return to * sqrt(1 + 0.25 * (from + at) * (from + at)); /* error below 1e-13 */
    return (0.5 * (at * sqrt(1 + at * at) - from * sqrt(1 + from * from)) + 0.5 * (asinh(at) - asinh(from))) / e->bend;
}

/* Of the whole, which is `plan` metres long in plan: the profile's first and last grade go on; what it has beyond the
 * line's ends does not count. */
static double space_length(const Alignment *a, double plan)
{
    double sum = 0;
    if (a->n_profile == 0) {
        for (int i = 1; i < a->n_points; ++i) sum += v3_norm(v3_sub(a->point[i], a->point[i - 1]));
        return a->n_points ? sum : plan;
    }
    const ProfileElement *const tail = &a->profile[a->n_profile - 1];
    if (a->n_plan + a->n_points == 0) plan = tail->station + tail->length; /* a profile alone has its own */
    for (int i = 0; i < a->n_profile; ++i) {
        const ProfileElement *const e = &a->profile[i];
        const double from = i ? fmin(fmax(e->station, 0), plan) : 0;
        const double to = i + 1 < a->n_profile ? fmin(fmax(e[1].station, 0), plan) : plan;
        const double end = fmin(e->station + e->length, to), start = fmax(from, e->station);
        const double before = sqrt(1 + e->grade * e->grade);
        const double last = profile_at(e, e->length).grade;
        sum += fmax(0, fmin(start, to) - from) * before;
        if (end > start) sum += element_length(e, end - e->station) - element_length(e, start - e->station);
        sum += fmax(0, to - fmax(end, from)) * sqrt(1 + last * last);
    }
    return sum;
}

/* The jump from one element's end to the next one's start. */
static void joint_measure(const PlanElement *e, AlignmentMeasure *m)
{
    const PlanElement end = plan_at(e, e->length);
    m->gap = fmax(m->gap, hypot(e[1].x - end.x, e[1].y - end.y));
    m->turn = fmax(m->turn, fabs(remainder(e[1].heading - end.heading, 2 * acos(-1))));
}

AlignmentMeasure alignment_measure(const Alignment *a)
{
    AlignmentMeasure m = {.plan_length = plan_length(a), .least_radius = a->n_plan ? INFINITY : NAN};
    m.length = space_length(a, m.plan_length);
    m.start = alignment_at(a, 0).at;
    m.end = alignment_at(a, m.plan_length).at;
    m.pieces = a->n_plan ? a->n_plan : a->n_points > 1 ? a->n_points - 1 : 0;
    for (int i = 0; i < a->n_plan; ++i) {
        const double k = fmax(fabs(a->plan[i].k0), fabs(a->plan[i].k1));
        if (k > 0) m.least_radius = fmin(m.least_radius, 1 / k);
        if (i + 1 < a->n_plan) joint_measure(&a->plan[i], &m);
    }
    return m;
}

/* ------------------------------------------------------------------------------------------------------- reversal */

static PlanElement plan_reversed(const PlanElement *e)
{
    const PlanElement end = plan_at(e, e->length);
    return (PlanElement){end.x, end.y, end.heading + acos(-1), e->length, -e->k1, -e->k0, e->name, e->k_sd};
}

static ProfileElement profile_reversed(const ProfileElement *e, double plan)
{
    const ProfileElement end = profile_at(e, e->length);
    return (ProfileElement){e->kind, plan - e->station - e->length, e->length, end.z, -end.grade, e->bend};
}

void alignment_reverse(Alignment *a)
{
    const double plan = plan_length(a);
    for (int i = 0; i < a->n_plan; ++i) a->plan[i] = plan_reversed(&a->plan[i]);
    for (int i = 0; i < a->n_profile; ++i) a->profile[i] = profile_reversed(&a->profile[i], plan);
#define TURN_AROUND(type, list, n)                                                                                     \
    for (int i = 0, j = (n)-1; i < j; ++i, --j) {                                                                      \
        const type kept = (list)[i];                                                                                   \
        (list)[i] = (list)[j];                                                                                         \
        (list)[j] = kept;                                                                                              \
    }
    TURN_AROUND(PlanElement, a->plan, a->n_plan)
    TURN_AROUND(ProfileElement, a->profile, a->n_profile)
    TURN_AROUND(Vec3, a->point, a->n_points)
#undef TURN_AROUND
    a->station += plan;
}
