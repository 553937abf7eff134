/* Makes alignments of rows: the columns present determine the kind of table. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/error.h"
#include "survey/map.h"
#include "survey/table.h"

#define TURN (2 * 3.14159265358979323846)

/* ----------------------------------------------------------------------------------------------------- stations */

/* Checks that stations which may be referred to equal the distance from the first row, m, in plan or in space, within a
 * hundredth. */
static hawser_status way_check(const SurveyInput *in, const Table *t, int i, double plan, double space)
{
    const double slack = 0.01, least = 1, on = t->row[i].value[COLUMN_STATION] - t->row[0].value[COLUMN_STATION];
    if (isnan(on) || (on >= plan * (1 - slack) - least && on <= space * (1 + slack) + least)) return HAWSER_OK;
    return input_error(in,
                       "station %.10g m is %.10g m from the first one, and the distance along the route is %.10g m: "
                       "expected equal ones, or no stations",
                       t->row[i].value[COLUMN_STATION], on, plan);
}

/* Reports stations measured along a slope, as opposed to those in plan, by which parts of a line are selected. */
static void slope_say(SurveyInput *in, const Table *t, double plan)
{
    const double on = t->row[t->n - 1].value[COLUMN_STATION] - t->row[0].value[COLUMN_STATION];
    if (on > 1.01 * plan + 1)
        survey_ignore(in->out, "stations along the slope: those of 'from' and 'to' count in plan");
}

/* ------------------------------------------------------------------------------------------- elements in plan */

/* Convention of a table's headings: against x or against north, their unit; and the side of a positive radius. */
typedef struct Convention {
    double unit; /* 0: they are unreliable or missing: the next row's point determines them */
    int bearing; /* clockwise from north */
    int side;    /* +1: positive is left */
} Convention;

/* Curvature of a row; a word for the side takes precedence over the radius' sign. */
static double curvature(double radius, const TableRow *row, int side)
{
    if (isnan(radius) || radius == 0 || row->straight) return 0;
    return row->turn == TURN_NONE ? side / radius : (row->turn == TURN_RIGHT ? -1 : 1) / fabs(radius);
}

/* Element of a row with the given heading. */
static PlanElement element_of(const TableRow *row, Convention c, double heading)
{
    const double *const v = row->value, one = v[COLUMN_RADIUS];
    const double from = isnan(one) ? v[COLUMN_RADIUS_START] : one, to = isnan(one) ? v[COLUMN_RADIUS_END] : one;
    return (PlanElement){.x = v[COLUMN_X],
                         .y = v[COLUMN_Y],
                         .heading = heading,
                         .length = v[COLUMN_LENGTH],
                         .k0 = curvature(from, row, c.side),
                         .k1 = curvature(to, row, c.side)};
}

/* Element of row i; before: the previous one, which determines the heading of a last one. */
static PlanElement element_by(const Table *t, int i, Convention c, const PlanElement *before)
{
    const double stated = c.unit * t->row[i].value[COLUMN_HEADING];
    if (c.unit > 0) return element_of(&t->row[i], c, c.bearing ? TURN / 4 - stated : stated);
    PlanElement e = element_of(&t->row[i], c, 0);
    const PlanElement tip = plan_at(&e, e.length);
    const double *const next = i + 1 < t->n ? t->row[i + 1].value : NULL;
    if (next)
        e.heading = atan2(next[COLUMN_Y] - e.y, next[COLUMN_X] - e.x) - atan2(tip.y - e.y, tip.x - e.x);
    else if (before)
        e.heading = plan_at(before, before->length).heading;
    return e;
}

/* Distances of elements' ends from the next ones' starts, m, plus the jumps in heading, rad. */
static double misfit(const Table *t, Convention c)
{
    double sum = 0;
    PlanElement e = element_by(t, 0, c, NULL);
    for (int i = 0; i + 1 < t->n; ++i) {
        const PlanElement end = plan_at(&e, e.length);
        e = element_by(t, i + 1, c, &e);
        sum += hypot(e.x - end.x, e.y - end.y) + fabs(remainder(e.heading - end.heading, TURN));
    }
    return sum;
}

/* Finds the convention with the smallest misfit; headings count as wrong if they are ten times worse than none. */
static Convention convention_find(SurveyInput *in, const Table *t)
{
    static const double unit[] = {0, 1, TURN / 360, TURN / 400};
    Convention best = {0};
    double least = INFINITY;
    for (int i = 0; i < 16; ++i) {
        const Convention c = {unit[i / 4], i % 2, i % 4 < 2 ? 1 : -1};
        if (c.unit > 0 && !t->has[COLUMN_HEADING]) continue;
        if (c.unit > 0 && t->angles && c.unit != 1) continue;
        if (c.unit > 0 && t->north && !c.bearing) continue;
        const double miss = misfit(t, c);
        const double counts = c.unit == 0 && t->has[COLUMN_HEADING] ? 10 * miss + 1e-2 * t->n : miss;
        if (counts < least * (1 - 1e-9)) {
            least = counts;
            best = c;
        }
    }
    if (t->has[COLUMN_HEADING] && best.unit == 0)
        survey_ignore(in->out, "headings: they do not lead to the next points");
    if (best.side < 0) survey_ignore(in->out, "radii: negative ones are taken as to the left, since elements meet so");
    return best;
}

/* Checks that heights are continuous: element `before` ends where the next one begins, z, m. */
static hawser_status rise_check(const SurveyInput *in, const ProfileElement *before, double z)
{
    const double jump = 0.1, end = profile_at(before, before->length).z;
    if (fabs(z - end) <= jump) return HAWSER_OK;
    return input_error(
        in, "the element before ends at a height of %.3f m by its gradients, and this one begins at %.3f m", end, z);
}

/* Adds the profile over row i, which begins `station` m from the first one: z with the gradients at both ends. */
static hawser_status rise_add(SurveyInput *in, const TableRow *row, double station, Alignment *a)
{
    const double *const v = row->value, from = v[COLUMN_GRADE], radius = v[COLUMN_VERTICAL_RADIUS];
    const double to = isnan(v[COLUMN_GRADE_END]) ? from : v[COLUMN_GRADE_END];
    const int arc = isfinite(radius) && radius != 0;
    if (isnan(v[COLUMN_Z]) || isnan(from)) return input_error(in, "an element with a height needs its gradient too");
    if (arc && (to - from) * radius < 0)
        return input_error(in,
                           "a vertical radius of %g m, and gradients from %g to %g: it is positive in a sag, negative "
                           "on a crest",
                           radius, from, to);
    const hawser_status status = a->n_profile ? rise_check(in, &a->profile[a->n_profile - 1], v[COLUMN_Z]) : HAWSER_OK;
    if (status) return status;
    ProfileElement *const e = alignment_add_profile(a);
    if (!e) return error_memory(in->err);
    *e = (ProfileElement){.kind = arc ? PROFILE_ARC : PROFILE_PARABOLA,
                          .station = station,
                          .length = v[COLUMN_LENGTH],
                          .z = v[COLUMN_Z],
                          .grade = from,
                          .bend = arc ? 1 / radius : (to - from) / v[COLUMN_LENGTH]};
    return HAWSER_OK;
}

/* Refuses a row that is not an element: without place or length, with heights that do not match the gradients, or whose
 * length does not match the distance to the next one's place. */
static hawser_status element_check(SurveyInput *in, const Table *t, int i)
{
    const int heights = t->has[COLUMN_Z] && t->has[COLUMN_GRADE];
    const TableRow *const row = &t->row[i];
    const double *const v = row->value, *const next = i + 1 < t->n ? t->row[i + 1].value : v, length = v[COLUMN_LENGTH];
    in->line = row->line;
    if (!(length > 0) || isnan(v[COLUMN_X]) || isnan(v[COLUMN_Y]))
        return input_error(in, "an element needs x, y and a length above 0");
    if (row->turn == TURN_UP || row->turn == TURN_DOWN)
        return input_error(in, "an element in plan turns left or right: z and gradients say how it rises");
    if (fabs(v[COLUMN_SLOPE]) > 0 || (!heights && (fabs(v[COLUMN_Z]) > 0 || fabs(v[COLUMN_GRADE]) > 0)))
        return input_error(in, "an element in plan that rises needs the columns z and start gradient, both");
    const double way = hypot(next[COLUMN_X] - v[COLUMN_X], next[COLUMN_Y] - v[COLUMN_Y]);
    const PlanElement e = element_of(row, (Convention){.side = 1}, 0);
    const int straight = e.k0 == 0 && e.k1 == 0;
    if (i + 1 < t->n && (length < 0.9 * way - 1 || (straight && length > 1.1 * way + 1)))
        return input_error(
            in,
            "an element of %.10g m, and the next one begins %.10g m away: does its column count from the "
            "line's start? That is a station",
            length, way);
    return HAWSER_OK;
}

static hawser_status plan_make(SurveyInput *in, const Table *t, Alignment *a)
{
    hawser_status status = HAWSER_OK;
    in->line = 0;
    if (t->has[COLUMN_RADIUS_START] != t->has[COLUMN_RADIUS_END])
        return input_error(in, "a column of %s radii, and none of %s: elements need both, or one 'radius'",
                           t->has[COLUMN_RADIUS_START] ? "start" : "end", t->has[COLUMN_RADIUS_END] ? "start" : "end");
    for (int i = 0; i < t->n && !status; ++i) status = element_check(in, t, i);
    if (!status && t->n == 1 && isnan(t->row[0].value[COLUMN_HEADING]))
        return input_error(in, "a single element needs its direction: no next one determines it");
    if (status) return status;
    const Convention c = convention_find(in, t);
    for (int i = 0; i < t->n; ++i) {
        PlanElement *const e = alignment_add_plan(a);
        if (!e) return error_memory(in->err);
        *e = element_by(t, i, c, i ? &a->plan[i - 1] : NULL);
        e->name = t->row[i].name;
    }
    double station = 0;
    const int rises = t->has[COLUMN_Z] && t->has[COLUMN_GRADE];
    for (int i = 0; i < t->n && !status; ++i) {
        in->line = t->row[i].line;
        status = way_check(in, t, i, station, station);
        if (!status && rises) status = rise_add(in, &t->row[i], station, a);
        station += t->row[i].value[COLUMN_LENGTH];
    }
    return status;
}

/* ---------------------------------------------------------------------------------------------------- profiles */

/* Gradient with which the row after row i begins; NAN: not given. */
static double next_grade(const Table *t, int i)
{
    const double *const v = i + 1 < t->n ? t->row[i + 1].value : NULL;
    return v ? v[t->has[COLUMN_GRADE] ? COLUMN_GRADE : COLUMN_SLOPE] : NAN;
}

/* Fills values that a row leaves out: the first one begins at 0, a slope is a gradient, a grade leads to the next
 * height; one with a radius ends with the gradient of the next. */
static void profile_fill(const Table *t, int i, double v[COLUMN_TYPE])
{
    const double *const next = i + 1 < t->n ? t->row[i + 1].value : NULL;
    for (int c = 0; c < COLUMN_TYPE; ++c) v[c] = t->row[i].value[c];
    if (!t->has[COLUMN_GRADE]) v[COLUMN_GRADE] = v[COLUMN_SLOPE];
    if (i == 0 && isnan(v[COLUMN_STATION])) v[COLUMN_STATION] = 0;
    if (next && isnan(v[COLUMN_GRADE])) {
        v[COLUMN_GRADE] = (next[COLUMN_Z] - v[COLUMN_Z]) / (next[COLUMN_STATION] - v[COLUMN_STATION]);
    }
    if (isnan(v[COLUMN_GRADE_END]) && fabs(v[COLUMN_RADIUS]) > 0) v[COLUMN_GRADE_END] = next_grade(t, i);
    if (isnan(v[COLUMN_GRADE_END])) v[COLUMN_GRADE_END] = v[COLUMN_GRADE];
}

/* Makes a profile row by row. A length may be missing or wrong in a table: the next station determines it. */
static hawser_status profile_make(SurveyInput *in, const Table *t, Alignment *a)
{
    double v[COLUMN_TYPE], first = 0;
    for (int i = 0; i < t->n; ++i) {
        profile_fill(t, i, v);
        if (i == 0) first = v[COLUMN_STATION];
        const double stated = v[COLUMN_LENGTH];
        const double length = i + 1 < t->n ? t->row[i + 1].value[COLUMN_STATION] - v[COLUMN_STATION] : stated;
        in->line = t->row[i].line;
        if (isnan(v[COLUMN_Z]) || isnan(v[COLUMN_GRADE]) || !(length > 0)) {
            return input_error(in, "an element of a profile needs station, height, gradient, and a length above 0 or a "
                                   "next station behind its own");
        }
        if (fabs(stated - length) > 1e-3 + 1e-5 * length) {
            survey_ignore(in->out, "lengths that differ from the way to the next station");
        }
        const hawser_status status = i ? rise_check(in, &a->profile[i - 1], v[COLUMN_Z]) : HAWSER_OK;
        if (status) return status;
        const double radius = fabs(v[COLUMN_RADIUS]), change = v[COLUMN_GRADE_END] - v[COLUMN_GRADE];
        const int arc = change != 0 && radius > 0;
        if (radius > 0 && !arc)
            return input_error(in,
                               "a radius of %g m, and no gradient at its end that differs from %g: expected 'end "
                               "gradient', or a next row's",
                               radius, v[COLUMN_GRADE]);
        ProfileElement *const e = alignment_add_profile(a);
        if (!e) return error_memory(in->err);
        *e = (ProfileElement){.kind = arc ? PROFILE_ARC : PROFILE_PARABOLA,
                              .station = v[COLUMN_STATION] - first,
                              .length = length,
                              .z = v[COLUMN_Z],
                              .grade = v[COLUMN_GRADE],
                              .bend = arc ? copysign(1 / radius, change) : change / length};
    }
    return HAWSER_OK;
}

/* Makes a profile from its corners, with or without curves. */
static hawser_status corners_make(SurveyInput *in, const Table *t, Alignment *a)
{
    ProfileCorner *const corner = calloc((size_t)t->n, sizeof *corner);
    if (!corner) return error_memory(in->err);
    hawser_status status = HAWSER_OK;
    for (int i = 0; i < t->n && !status; ++i) {
        const double *const v = t->row[i].value;
        const double half = v[COLUMN_CURVE_LENGTH] / 2, radius = fabs(v[COLUMN_RADIUS]);
        in->line = t->row[i].line;
        if (isnan(v[COLUMN_STATION]) || isnan(v[COLUMN_Z]))
            status = input_error(in, "a corner needs station and height");
        if (half > 0 && radius > 0)
            status = input_error(in, "a corner has a curve length or a radius, not both: one follows from the other");
        corner[i] = (ProfileCorner){.station = v[COLUMN_STATION] - t->row[0].value[COLUMN_STATION],
                                    .z = v[COLUMN_Z],
                                    .before = half > 0 ? half : 0,
                                    .after = half > 0 ? half : 0,
                                    .radius = radius > 0 ? radius : 0};
    }
    in->line = 0;
    hawser_error why = {.message = ""};
    if (!status && t->n < 2) status = input_error(in, "a profile needs two rows at least");
    if (!status) status = profile_from_corners(a, t->n, corner, &why);
    if (*why.message) input_error(in, "%s", why.message);
    free(corner);
    return status;
}

/* ------------------------------------------------------------------------------------------------------ pieces */

/* Checks that stations of points rise by about their distance: a jump, such as stations that restart, would make them
 * ambiguous. */
static hawser_status station_check(const SurveyInput *in, const Table *t, int i)
{
    const double *const v = t->row[i].value, *const was = t->row[i > 0 ? i - 1 : 0].value;
    const double way = hypot(v[COLUMN_X] - was[COLUMN_X], v[COLUMN_Y] - was[COLUMN_Y]);
    const double on = v[COLUMN_STATION] - was[COLUMN_STATION];
    if (i == 0 || isnan(on) || (on >= 0 && on > 0.5 * way - 1 && on < 2 * way + 1)) return HAWSER_OK;
    return input_error(in, "station %.10g m is %.10g m on from the one before, and the points are %.10g m apart",
                       v[COLUMN_STATION], on, way);
}

static hawser_status points_make(SurveyInput *in, const Table *t, Alignment *a)
{
    double plan = 0, space = 0;
    for (int i = 0; i < t->n; ++i) {
        const double *const v = t->row[i].value, z = v[COLUMN_Z];
        in->line = t->row[i].line;
        if (isnan(v[COLUMN_X]) || isnan(v[COLUMN_Y])) return input_error(in, "a point needs x and y");
        const hawser_status status = station_check(in, t, i);
        if (status) return status;
        Vec3 *const p = alignment_add_point(a);
        if (!p) return error_memory(in->err);
        *p = v3(v[COLUMN_X], v[COLUMN_Y], isnan(z) ? 0 : z);
        if (isnan(z) != isnan(t->row[0].value[COLUMN_Z]))
            return input_error(in, "a height in some rows and none in others: give all, or leave the column out");
        a->flat = isnan(z);
        const Vec3 step = v3_sub(*p, a->point[i > 0 ? i - 1 : 0]);
        plan += hypot(step.x, step.y);
        space += v3_norm(step);
        if (way_check(in, t, i, plan, space)) return HAWSER_ERR_INPUT;
    }
    slope_say(in, t, plan);
    return HAWSER_OK;
}

/* State after the pieces so far. */
typedef struct Laying {
    double plan, z, slope;   /* m in plan, height, angle */
    double space;            /* m in space */
    double station, then[2]; /* m: the last station of a row, and the length up to there, in plan and in space */
} Laying;

static int lay_profile(Alignment *a, Laying *at, double plan, double bend)
{
    ProfileElement *const e = alignment_add_profile(a);
    if (!e) return 0;
    *e = (ProfileElement){bend != 0 ? PROFILE_ARC : PROFILE_PARABOLA, at->plan, plan, at->z, tan(at->slope), bend};
    const ProfileElement end = profile_at(e, plan);
    at->plan += plan;
    at->z = end.z;
    at->slope = atan(end.grade);
    return 1;
}

static int lay_plan(Alignment *a, double plan, double k, int name)
{
    PlanElement *const e = alignment_add_plan(a);
    if (e) *e = (PlanElement){.length = plan, .k0 = k, .k1 = k, .name = name};
    return e != NULL;
}

/* Checks that a row's station differs from the last one by the length of the pieces between, in plan or in space: this
 * reveals a missing row. */
static hawser_status piece_station(const SurveyInput *in, double station, Laying *at)
{
    if (isnan(station)) return HAWSER_OK;
    const double on = fabs(station - at->station), plan = at->plan - at->then[0], space = at->space - at->then[1];
    const double slack = 0.1 + 0.01 * space;
    if (on < plan - slack || on > space + slack)
        return input_error(
            in, "station %.10g m is %.10g m from the one before, and the pieces between them are %.10g m long", station,
            on, space);
    at->station = station;
    at->then[0] = at->plan;
    at->then[1] = at->space;
    return HAWSER_OK;
}

/* Adds a piece. A straight has a length; a bend an angle, a radius and a side, in plan at the present slope, or up or
 * down. */
static hawser_status piece_lay(SurveyInput *in, const TableRow *row, int in_plan, Alignment *a, Laying *at)
{
    const double *const v = row->value;
    const double angle = v[COLUMN_ANGLE], radius = v[COLUMN_RADIUS];
    const int bend = fabs(angle) > 0, upright = row->turn == TURN_UP || row->turn == TURN_DOWN;
    if (!isnan(v[COLUMN_SLOPE])) at->slope = atan(v[COLUMN_SLOPE]);
    if (bend && !(radius > 0)) return input_error(in, "a bend needs a radius above 0");
    if (!bend && radius > 0) return input_error(in, "a piece with a radius is a bend, and needs its angle and turn");
    const double arc = radius * fabs(angle), off = fabs(v[COLUMN_LENGTH] - arc);
    if (bend && off > 0.05 + 0.01 * arc)
        return input_error(in,
                           "a bend of %.4g m by its radius and angle, and its length is %.4g m: a straight before it "
                           "has a row of its own",
                           arc, v[COLUMN_LENGTH]);
    if (bend && off > 1e-3 + 1e-3 * arc)
        survey_ignore(in->out, "lengths of bends that are not their radius times their angle");
    if (bend && angle < 0 && (row->turn == TURN_LEFT || row->turn == TURN_UP))
        return input_error(in, "a negative angle is to the right or down, and its turn says left or up");
    if (bend && row->turn == TURN_NONE && angle > 0)
        return input_error(in, "a bend needs a turn: left, right, up or down");
    if (!bend && !(v[COLUMN_LENGTH] > 0))
        return input_error(in, "a straight needs a length above 0, a bend an angle and a radius");
    const double level = in_plan ? 1 : cos(at->slope);
    double plan = bend ? radius * fabs(angle) : v[COLUMN_LENGTH] * level, k = 0, rise = 0;
    if (bend && upright) {
        const double to = at->slope + (row->turn == TURN_UP ? 1 : -1) * fabs(angle);
        if (fabs(to) > 1.5) return input_error(in, "the route would be steeper than 86 deg: a table has no shafts");
        rise = (row->turn == TURN_UP ? 1 : -1) / radius;
        plan = (sin(to) - sin(at->slope)) / rise;
    } else if (bend) {
        k = (row->turn == TURN_RIGHT || angle < 0 ? -1 : 1) / radius;
    }
    at->space += bend && upright ? radius * fabs(angle) : plan / cos(at->slope);
    return lay_plan(a, plan, k, row->name) && lay_profile(a, at, plan, rise) ? HAWSER_OK : error_memory(in->err);
}

/* Refuses a last row whose length is the sum of all above it and that is not marked as a total, unless it has its own
 * name. */
static hawser_status sum_check(const SurveyInput *in, const Table *t, const Laying *at)
{
    const TableRow *const last = &t->row[t->n - 1];
    double lengths = 0;
    int straights = 0;
    for (int i = 0; i + 1 < t->n; ++i) {
        if (!(t->row[i].value[COLUMN_LENGTH] > 0)) continue;
        lengths += t->row[i].value[COLUMN_LENGTH];
        ++straights;
    }
    const double length = last->value[COLUMN_LENGTH], above = at->space - length, slack = 0.051;
    if (t->n < 3 || last->name || fabs(last->value[COLUMN_ANGLE]) > 0 || t->has[COLUMN_STATION] ||
        (fabs(length - above) > slack && (straights < 2 || fabs(length - lengths) > slack)))
        return HAWSER_OK;
    return input_error(in,
                       "the last row is as long as all above it together, %.10g m: a sum is no piece: leave it out, or "
                       "write 'total' in it; a piece gets a name",
                       length);
}

/* Checks the row of totals, in plan or in space, with or without the bends. */
static hawser_status total_check(SurveyInput *in, const Table *t, const Laying *at)
{
    double lengths = 0;
    for (int i = 0; i < t->n; ++i)
        lengths += isnan(t->row[i].value[COLUMN_LENGTH]) ? 0 : t->row[i].value[COLUMN_LENGTH];
    const double slack = 0.5 + 0.01 * at->space;
    if (isnan(t->total) || fabs(t->total - at->space) <= slack || fabs(t->total - at->plan) <= slack ||
        fabs(t->total - lengths) <= slack)
        return HAWSER_OK;
    in->line = t->total_line;
    return input_error(in, "the total is %.10g m, and the pieces above are %.10g m long: is one missing?", t->total,
                       at->space);
}

static hawser_status pieces_make(SurveyInput *in, const Table *t, Alignment *a)
{
    Laying at = {.station = t->n > 0 ? t->row[0].value[COLUMN_STATION] : NAN};
    hawser_status status = HAWSER_OK;
    if (t->has[COLUMN_STATION] && !t->has[COLUMN_LENGTH])
        return input_error(in, "bends at stations, and no lengths of the straights between them: expected a column "
                               "'length'");
    for (int i = 0; i < t->n && !status; ++i) {
        in->line = t->row[i].line;
        status = piece_station(in, t->row[i].value[COLUMN_STATION], &at);
        if (!status) status = piece_lay(in, &t->row[i], t->plan, a, &at);
    }
    if (!status) status = sum_check(in, t, &at);
    if (!status) status = total_check(in, t, &at);
    if (!status) slope_say(in, t, at.then[0]);
    alignment_chain(a);
    return status;
}

/* ----------------------------------------------------------------------------------------------------- corners */

/* Makes a line of corners: elements if all corners are complete, or points whose radius is given elsewhere. */
static hawser_status corners_lay(SurveyInput *in, int n, const PlanCorner *corner, int heights, int radii, Alignment *a)
{
    hawser_error why = {.message = ""};
    int wrong = 0;
    for (int i = 0; i < n && !radii; ++i) {
        Vec3 *const p = alignment_add_point(a);
        if (!p) return error_memory(in->err);
        *p = corner[i].at;
    }
    a->flat = !radii && !heights;
    a->drawn = !radii;
    if (!radii) return HAWSER_OK;
    const hawser_status status = plan_from_corners(a, n, corner, heights, &wrong, &why);
    in->line = corner[wrong].line;
    if (status == HAWSER_ERR_MEMORY) return error_memory(in->err);
    return status ? input_error(in, "%s", why.message) : HAWSER_OK;
}

/* Makes corners from x, y and radius. */
static hawser_status corner_list_make(SurveyInput *in, const Table *t, Alignment *a)
{
    PlanCorner *const corner = calloc((size_t)t->n, sizeof *corner);
    hawser_status status = corner ? HAWSER_OK : error_memory(in->err);
    const int heights = !isnan(t->row[0].value[COLUMN_Z]);
    for (int i = 0; i < t->n && !status; ++i) {
        const double *const v = t->row[i].value, z = v[COLUMN_Z];
        in->line = t->row[i].line;
        if (isnan(v[COLUMN_X]) || isnan(v[COLUMN_Y])) status = input_error(in, "a corner needs x and y");
        if (!status && isnan(z) == heights)
            status = input_error(in, "a height in some rows and none in others: give all, or leave the column out");
        if (!status) status = station_check(in, t, i);
        corner[i] = (PlanCorner){v3(v[COLUMN_X], v[COLUMN_Y], isnan(z) ? 0 : z), fabs(v[COLUMN_RADIUS]), in->line};
    }
    if (!status && t->n < 2) status = input_error(in, "a line needs two corners at least");
    if (!status) status = corners_lay(in, t->n, corner, heights, 1, a);
    free(corner);
    return status;
}

/* Finds the corner that a traverse's radius belongs to: 0 at its leg's end, -1 at its start; an error if that is
 * ambiguous. Equal radii: either. */
static hawser_status radii_side(SurveyInput *in, const Table *t, int *side)
{
    const double *const first = t->row[0].value, *const last = t->row[t->n - 1].value;
    int differ = 0;
    for (int i = 1; i < t->n; ++i) differ |= !(t->row[i].value[COLUMN_RADIUS] == first[COLUMN_RADIUS]);
    *side = !(last[COLUMN_RADIUS] > 0) ? 0 : !(first[COLUMN_RADIUS] > 0) ? -1 : 0;
    if (differ && first[COLUMN_RADIUS] > 0 && last[COLUMN_RADIUS] > 0)
        return input_error(in, "radii at the start or at the end of legs: leave out that of the last leg if they are "
                               "at the ends, of the first if at the starts");
    return HAWSER_OK;
}

/* Makes a traverse of legs with length and bearing, beginning at 0, 0. */
static hawser_status traverse_make(SurveyInput *in, const Table *t, Alignment *a)
{
    PlanCorner *const corner = calloc((size_t)t->n + 1, sizeof *corner);
    hawser_status status = corner ? HAWSER_OK : error_memory(in->err);
    const int heights = t->has[COLUMN_SLOPE];
    int radii = 0, side = 0;
    double slope = 0;
    for (int i = 0; i < t->n; ++i) radii |= t->row[i].value[COLUMN_RADIUS] > 0;
    in->line = t->row[0].line;
    if (!t->north)
        status = input_error(in, "legs by their direction: a column 'bearing' counts clockwise from north; which way "
                                 "'direction' does is not known");
    if (!status && radii) status = radii_side(in, t, &side);
    for (int i = 0; i < t->n && !status; ++i) {
        const double *const v = t->row[i].value, way = v[COLUMN_LENGTH];
        const double bearing = v[COLUMN_HEADING] * (t->angles ? 1 : TURN / 360);
        in->line = t->row[i].line;
        if (!(way > 0) || isnan(bearing)) status = input_error(in, "a leg needs a distance above 0 and a bearing");
        if (!status && fabs(bearing) > TURN * (1 + 1e-9))
            status = input_error(in, "a bearing of %.10g deg: expected degrees, or their unit behind the head",
                                 bearing * 360 / TURN);
        if (!isnan(v[COLUMN_SLOPE])) slope = v[COLUMN_SLOPE];
        const double plan = t->plan ? way : way / hypot(1, slope);
        corner[i + 1].at = v3(corner[i].at.x + plan * sin(bearing), corner[i].at.y + plan * cos(bearing),
                              corner[i].at.z + plan * slope);
        corner[i + 1].radius = side == 0 ? v[COLUMN_RADIUS] : i + 1 < t->n ? t->row[i + 1].value[COLUMN_RADIUS] : NAN;
        corner[i + 1].line = in->line;
    }
    if (!status && isfinite(t->total)) {
        double sum = 0;
        for (int i = 0; i < t->n; ++i) sum += t->row[i].value[COLUMN_LENGTH];
        in->line = t->total_line;
        if (fabs(sum - t->total) > 0.5 + 0.01 * sum)
            status = input_error(in, "the total is %.10g m, and the legs above are %.10g m long", t->total, sum);
    }
    if (!status) status = corners_lay(in, t->n + 1, corner, heights, radii, a);
    free(corner);
    return status;
}

/* -------------------------------------------------------------------------------------------------------- kinds */

/* Columns that a kind of table uses, as bits. */
#define USES(c) (1u << COLUMN_##c)
static const unsigned of_points = USES(X) | USES(Y) | USES(Z) | USES(STATION);
static const unsigned of_corners = USES(X) | USES(Y) | USES(Z) | USES(STATION) | USES(RADIUS);
static const unsigned of_legs = USES(LENGTH) | USES(HEADING) | USES(SLOPE) | USES(RADIUS);
static const unsigned of_pieces = USES(LENGTH) | USES(ANGLE) | USES(RADIUS) | USES(SLOPE) | USES(STATION);
static const unsigned of_elements = USES(X) | USES(Y) | USES(Z) | USES(LENGTH) | USES(RADIUS) | USES(SLOPE) |
                                    USES(RADIUS_START) | USES(RADIUS_END) | USES(HEADING) | USES(STATION) |
                                    USES(GRADE) | USES(GRADE_END) | USES(VERTICAL_RADIUS);
static const unsigned of_rises =
    USES(Z) | USES(LENGTH) | USES(RADIUS) | USES(SLOPE) | USES(STATION) | USES(GRADE) | USES(GRADE_END);
static const unsigned of_summits = USES(Z) | USES(RADIUS) | USES(STATION) | USES(CURVE_LENGTH);

/* Refuses columns of numbers that this kind of table does not use, except empty ones and those of zeros. */
static hawser_status unused_check(SurveyInput *in, const Table *t, const char *kind, unsigned used)
{
    static const char *const names[] = {"x",
                                        "y",
                                        "z",
                                        "length",
                                        "angle",
                                        "radius",
                                        "slope",
                                        "start radius",
                                        "end radius",
                                        "direction",
                                        "station",
                                        "gradient",
                                        "end gradient",
                                        "curve length",
                                        "vertical radius",
                                        "longitude",
                                        "latitude"};
    for (int c = 0; c < COLUMN_TYPE; ++c) {
        char what[SURVEY_NAME_MAX];
        if (!t->has[c] || (used >> c & 1)) continue;
        for (int i = 0; i < t->n; ++i) {
            if (!(fabs(t->row[i].value[c]) > 0)) continue;
            in->line = t->row[i].line;
            return input_error(
                in, "a column '%s' in a table of %s, which does not use it: remove the column, or name it in 'ignore'",
                names[c], kind);
        }
        snprintf(what, sizeof what, "column '%s' of a table of %s", names[c], kind);
        survey_ignore(in->out, what);
    }
    return HAWSER_OK;
}

/* Checks for a number other than 0 in a column. */
static int has_any(const Table *t, TableColumn c)
{
    for (int i = 0; t->has[c] && i < t->n; ++i) {
        if (fabs(t->row[i].value[c]) > 0) return 1;
    }
    return 0;
}

/* Converts longitude and latitude, by the heads, to metres east and north of the first row. */
static hawser_status places_project(SurveyInput *in, Table *t)
{
    MapPlaces places = {.in = in};
    const int heads = t->has[COLUMN_LONGITUDE] && t->has[COLUMN_LATITUDE];
    if (t->has[COLUMN_LONGITUDE] != t->has[COLUMN_LATITUDE])
        return input_error(in, "a column of %s without one of %s", heads ? "latitude" : "longitude or latitude",
                           "the other");
    if (!heads && !t->degrees) return HAWSER_OK;
    if (heads && (t->has[COLUMN_X] || t->has[COLUMN_Y]))
        return input_error(in, "columns of longitude and latitude, and of x and y: name one pair in 'ignore'");
    const TableColumn east = heads ? COLUMN_LONGITUDE : COLUMN_X, north = heads ? COLUMN_LATITUDE : COLUMN_Y;
    hawser_status status = HAWSER_OK;
    for (int i = 0; i < t->n && !status; ++i) {
        double *const v = t->row[i].value;
        Vec3 at;
        in->line = t->row[i].line;
        if (isnan(v[east]) || isnan(v[north])) return input_error(in, "a point needs longitude and latitude");
        status = map_place(&places, v[east], v[north], NAN, &at);
        v[COLUMN_X] = at.x;
        v[COLUMN_Y] = at.y;
    }
    t->has[COLUMN_LONGITUDE] = t->has[COLUMN_LATITUDE] = 0;
    t->has[COLUMN_X] = t->has[COLUMN_Y] = 1;
    return status;
}

/* Refuses x and y that can hardly be metres: a line of less than two of them, with numbers in the range of degrees. */
static hawser_status degrees_check(SurveyInput *in, const Table *t)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    if (!isnan(in->options.unit) || t->metres || *in->out->system) return HAWSER_OK;
    for (int i = 0; i < t->n; ++i) {
        for (int k = 0; k < 2; ++k) {
            low[k] = fmin(low[k], t->row[i].value[k ? COLUMN_Y : COLUMN_X]);
            high[k] = fmax(high[k], t->row[i].value[k ? COLUMN_Y : COLUMN_X]);
        }
    }
    const double most = fmax(fmax(fabs(low[0]), fabs(high[0])), fmax(fabs(low[1]), fabs(high[1])));
    const double extent = fmax(high[0] - low[0], high[1] - low[1]);
    if (t->n < 2 || most > 180 || extent > 2 || most < 3 * extent) return HAWSER_OK;
    in->line = 0;
    return input_error(in,
                       "x and y lie within %.3g of each other: degrees? Then name the columns 'longitude' and "
                       "'latitude' (WGS 84); for metres give the unit, 'x (m)'",
                       extent);
}

/* Turns distances from the start with heights into a profile over stations. */
static hawser_status distances_as_stations(SurveyInput *in, Table *t)
{
    for (int i = 0; i < t->n; ++i) {
        double *const v = t->row[i].value;
        in->line = t->row[i].line;
        if (i > 0 && !(v[COLUMN_LENGTH] > t->row[i - 1].value[COLUMN_STATION]))
            return input_error(in, "lengths and heights: pieces rise by a 'slope', and a profile has rising stations");
        v[COLUMN_STATION] = v[COLUMN_LENGTH];
        v[COLUMN_LENGTH] = NAN;
    }
    t->has[COLUMN_LENGTH] = 0;
    t->has[COLUMN_STATION] = 1;
    survey_ignore(in->out, "distances with heights are taken for stations of a profile");
    return HAWSER_OK;
}

/* Merges columns with the same meaning in this kind of table. */
static hawser_status columns_settle(SurveyInput *in, Table *t)
{
    int *const has = t->has;
    hawser_status status = places_project(in, t);
    const int plan = has[COLUMN_X] && has[COLUMN_Y];
    if (!status && has[COLUMN_FALL])
        return input_error(in, "a column of Gef\xC3\xA4lle or fall: positive down or up? Head it slope or Steigung, "
                               "which rise, or name it in 'ignore'");
    if (!status && !plan && has[COLUMN_LENGTH] && has[COLUMN_Z] && !has[COLUMN_ANGLE] && !has[COLUMN_HEADING] &&
        !has[COLUMN_STATION] && !has[COLUMN_TURN])
        status = distances_as_stations(in, t);
    const int profile = has[COLUMN_STATION] && has[COLUMN_Z];
    if (!plan && !profile && has[COLUMN_GRADE] && !has[COLUMN_SLOPE] &&
        !has[COLUMN_GRADE_END]) { /* a table of pieces */
        for (int i = 0; i < t->n; ++i) t->row[i].value[COLUMN_SLOPE] = t->row[i].value[COLUMN_GRADE];
        has[COLUMN_SLOPE] = 1;
        has[COLUMN_GRADE] = 0;
    }
    return status;
}

hawser_status table_alignment(SurveyInput *in, Table *t)
{
    typedef hawser_status (*Make)(SurveyInput * in, const Table *t, Alignment *a);
    const int *const has = t->has;
    hawser_status status = columns_settle(in, t);
    Alignment *const a = status ? NULL : survey_add(in->out, "");
    if (!a) return status ? status : error_memory(in->err);
    a->names = t->names;
    t->names = (PieceNames){.text = NULL};
    const int plan = has[COLUMN_X] && has[COLUMN_Y];
    const double station = has[COLUMN_STATION] ? t->row[0].value[COLUMN_STATION] : NAN;
    a->station = isnan(station) ? 0 : station;
    in->line = 0;
    if (plan) status = degrees_check(in, t);
    if (status) return status;
    Make make = NULL;
    const char *kind = "";
    unsigned used = 0;
    if (plan && has[COLUMN_LENGTH])
        make = plan_make, kind = "elements", used = of_elements;
    else if (plan && has_any(t, COLUMN_RADIUS))
        make = corner_list_make, kind = "corners", used = of_corners;
    else if (plan)
        make = points_make, kind = "points", used = of_points;
    else if (has[COLUMN_STATION] && has[COLUMN_Z] && (has[COLUMN_GRADE] || has[COLUMN_SLOPE]))
        make = profile_make, kind = "a profile's elements", used = of_rises;
    else if (has[COLUMN_STATION] && has[COLUMN_Z])
        make = corners_make, kind = "a profile's corners", used = of_summits;
    else if (has[COLUMN_LENGTH] && has[COLUMN_HEADING] && !has[COLUMN_ANGLE])
        make = traverse_make, kind = "legs with bearings", used = of_legs;
    else if ((has[COLUMN_LENGTH] || has[COLUMN_ANGLE]) && !(has[COLUMN_CANT] && !has[COLUMN_ANGLE]))
        make = pieces_make, kind = "pieces", used = of_pieces;
    if (!make)
        return input_error(
            in,
            "the columns are none of these: length, angle, radius, turn, slope; x, y, z; x, y, radius; "
            "x, y, direction, length, radius; distance, bearing, radius; station, height and gradient or "
            "curve length%s",
            has[COLUMN_CANT] ? ": cant does not define a line" : "");
    status = unused_check(in, t, kind, used);
    return status ? status : make(in, t, a);
}

hawser_status table_read(SurveyInput *in)
{
    Table table = {0};
    hawser_status status = table_rows(in, &table);
    if (!status && !in->options.marks) status = table_alignment(in, &table);
    free(table.row);
    free(table.names.text);
    return status;
}
