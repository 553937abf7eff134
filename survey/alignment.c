#include "survey/alignment.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"

/* ---------------------------------------------------------------------------------------------- growing lists */

void *survey_one_more(void *array, int *n, size_t size)
{
    void **const list = array;
    if (*n >= SURVEY_MOST) return NULL;
    if ((*n & (*n - 1)) == 0) { /* full: the number in use is 0, 1, 2, 4, ... */
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
    mesh_build_end(&s->faces);
    mesh_free(&s->faces.mesh);
    *s = (Survey){0};
}

/* Copies n items of `size` bytes, with as much space as survey_one_more assumes. */
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

/* --------------------------------------------------------------------------------------------------- places */

/* The last of n items that begin at or before s; start: the first item's start, `stride` bytes apart. */
static double plan_length(const Alignment *a)
{
    double sum = 0;
    for (int i = 0; i < a->n_plan; ++i) sum += a->plan[i].length;
    for (int i = 1; i < a->n_points; ++i) {
        sum += hypot(a->point[i].x - a->point[i - 1].x, a->point[i].y - a->point[i - 1].y);
    }
    return sum;
}

/* Place on an element; it continues straight beyond its ends. */
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

/* Place between two corners, s metres in plan from the first; for points above each other it is the first one's. */
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

/* Length in space of the whole line, which is `plan` metres long in plan: the profile's first and last grade continue;
 * its parts beyond the line's ends do not count. */
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

/* Measures the jump from one element's end to the next one's start. */
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

/* Elements in plan: (AL1), (AL2) of docs/theory/16-alignments.md. */

/* Nodes and weights of Gauss-Legendre, eight points on [-1, 1]: exact for polynomials up to degree 15. */
static const double node[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};

static const double weight[] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};

static const double TURN = 6.28318530717958647692;

enum { PARTS_MOST = 4000 }; /* for 300 turns; files with more than 100 are refused (survey/read) */

/* Heading s metres from the start, (AL1). */
static double heading_at(const PlanElement *e, double s)
{
    return e->heading + s * (e->k0 + 0.5 * s * (e->k1 - e->k0) / e->length);
}

/* Adds the displacement from s to s + h, over which the heading changes by less than half a radian: error below 1e-15
 * h. */
static void way_add(const PlanElement *e, double s, double h, double *x, double *y)
{
    for (int i = 0; i < 8; ++i) {
        const double u = i % 2 ? node[i / 2] : -node[i / 2];
        const double angle = heading_at(e, s + 0.5 * h * (1 + u));
        *x += 0.5 * h * weight[i / 2] * cos(angle);
        *y += 0.5 * h * weight[i / 2] * sin(angle);
    }
}

PlanElement plan_at(const PlanElement *e, double s)
{
    PlanElement at = *e;
    const double rate = (e->k1 - e->k0) / e->length;
    const double rounds = trunc(s * e->k0 / TURN);
    const double way =
        rate == 0 && rounds != 0 ? s - rounds * TURN / e->k0 : s; /* a full circle leads back to the same place */
    const double turn = fabs(way) * fmax(fabs(e->k0), fabs(e->k0 + way * rate));
    const int parts = (int)fmin(PARTS_MOST, 1 + 2 * turn);
    for (int i = 0; i < parts; ++i) way_add(e, i * way / parts, way / parts, &at.x, &at.y);
    at.heading = heading_at(e, s);
    at.k0 = e->k0 + s * rate;
    return at;
}

void alignment_chain(Alignment *a)
{
    for (int i = 1; i < a->n_plan; ++i) {
        const PlanElement end = plan_at(&a->plan[i - 1], a->plan[i - 1].length);
        a->plan[i].x = end.x;
        a->plan[i].y = end.y;
        a->plan[i].heading = end.heading;
    }
}

/* Elements of a profile: (AL3)-(AL5) of docs/theory/16-alignments.md. */

/* Sine of the slope for the grade dz/ds. */
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

/* Length in plan of the curve at a corner on one side: -1 before it, 1 after it. */
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

/* Adds the curve at a corner: one arc, or two parabolas that meet at the corner's station. */
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
    double end = -INFINITY; /* end of the last curve */
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

/* From corners to straights and arcs: (AL13) of docs/theory/16-alignments.md. */

static const double STRAIGHT = 1e-6; /* rad: smaller turns are no corners */

/* A leg between two corners. */
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

/* Length that the arc at corner i takes of either leg, m; NAN with the reason if it has no radius. */
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

/* Adds a profile; heights of corners apply at the middle of their arcs. */
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

/* A part of an alignment. */

/* Shortest remainder of an element or straight that is kept, m: a rounded station is the element's end. */
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

/* Cuts the profile. If the part begins after an element's end, or before the first one, that element's grade continues,
 * as on the whole line. */
static void profile_cut(Alignment *a, double from, double to)
{
    const AlignmentPlace at = alignment_at(a, from);
    int n = 0, last = 0, first = -1; /* the element that gives the grade at `from`, and the first one that is kept */
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
        memmove(a->profile + 1, a->profile, (size_t)n * sizeof *a->profile); /* there is space: `last` is not kept */
        a->profile[0] = (ProfileElement){.length = lead, .z = at.at.z, .grade = at.grade};
        ++n;
    }
    a->n_profile = n;
}

/* Cuts a line of points: the corners between the ends, and both ends. */
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
    for (int i = 0; i < n; ++i) a->point[i] = point[i]; /* never more than before: the ends replace corners */
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
