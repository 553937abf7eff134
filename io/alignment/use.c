/* A line of a file as it will be built: with its heights, fitted, cut, turned around, chained. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "core/base/worst.h"
#include "io/alignment/line.h"
#include "survey/fit/fit.h"

/* The line from which heights come; *s is to be cleared. NULL in *profile: the line's own. */
static hawser_status profile_find(const LineOptions *options, Survey *s, const Alignment **profile, hawser_error *err)
{
    *profile = NULL;
    *s = (Survey){0};
    if (!options->profile.path) return HAWSER_OK;
    hawser_status status = lines_read(&options->profile, s, err);
    if (!status) status = line_choose(&options->profile, s, profile, err);
    if (!status) line_notes_say(s, *profile);
    return status;
}

/* By how much the chain of elements misses the places where the file has them, (AL8). */
static double chain_off(const Alignment *own, const Alignment *chained)
{
    double worst = 0;
    for (int i = 0; i < own->n_plan; ++i) {
        for (int k = 0; k < 2; ++k) {
            const PlanElement a = plan_at(&own->plan[i], k * own->plan[i].length);
            const PlanElement b = plan_at(&chained->plan[i], k * chained->plan[i].length);
            worst = larger_of(worst, hypot(a.x - b.x, a.y - b.y));
        }
    }
    return worst;
}

/* Lets the elements begin where those before them end, and says what that moves. */
static hawser_status chain(const LineOptions *options, UsedLine *used, hawser_error *err)
{
    Alignment own;
    if (!alignment_copy(&used->line, &own)) return error_memory(err);
    alignment_chain(&used->line);
    used->deviation += chain_off(&own, &used->line);
    alignment_clear(&own);
    if (used->deviation <= options->tolerance) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT,
                     "'%.60s': a smooth route is up to %.3g m off the file's line, and %.3g m are allowed: a larger "
                     "tolerance, or a better file",
                     used->line.name, used->deviation, options->tolerance);
}

/* Whether the heights of a line are drawn: its plan has stations and heights. */
static int is_drawn(const Alignment *profile)
{
    return profile->n_profile == 0 && (profile->n_plan > 0 || profile->flat);
}

/* Joined elements are taken as they are; what the fit changes it reports. It holds the deviation where it cuts a line,
 * and may pass it a little where pieces are then joined: a smaller one is asked for until the whole line is within,
 * unless it is far off. */
static hawser_status fit(const Alignment *from, const Alignment *profile, const LineOptions *options, UsedLine *used,
                         hawser_error *err)
{
    enum { TRIES = 4, FAR_OFF = 3 };
    FitOptions how = fit_options();
    FitReport report;
    hawser_status status = HAWSER_OK;
    how.profile_drawn = profile && is_drawn(profile);
    for (int k = 0; k < TRIES && !status; ++k) {
        how.deviation = options->tolerance / (1 << k);
        alignment_clear(&used->line);
        status = fit_alignment(from, profile, &how, &used->line, &report, err);
        const double off = larger_of(report.largest, report.largest_height);
        if (off <= options->tolerance || off > FAR_OFF * options->tolerance) break;
    }
    if (report.chords)
        snprintf(used->bends, sizeof used->bends,
                 "%d straights are taken for the chords of %d bend%s, up to %.3g m beside them", report.chords,
                 report.chord_bends, report.chord_bends > 1 ? "s" : "", report.chord_off);
    used->fitted = report.fitted;
    used->deviation = larger_of(report.largest, report.largest_height);
    used->rms = larger_of(report.rms, report.rms_height);
    return status;
}

/* What is asked for and this line has no use for: nothing that is asked for is passed over in silence. */
static hawser_status asked_check(const Alignment *from, const Alignment *profile, const LineOptions *options,
                                 hawser_error *err)
{
    const int heights = from->n_profile > 0 || (from->n_points > 0 && !from->flat);
    int bent = from->bent;
    for (int i = 0; i < from->n_plan; ++i) bent |= from->plan[i].k0 != 0 || from->plan[i].k1 != 0;
    if (!isnan(options->height) && heights && !profile)
        return error_set(err, HAWSER_ERR_INPUT,
                         "'%.60s' has heights of its own: a 'height' is for a line without, leave it out", from->name);
    if (from->partly && from->n_profile == 0 && !profile && isnan(options->height))
        return error_set(
            err, HAWSER_ERR_INPUT,
            "'%.60s': the file has heights of a part of it, or beside its plan, which cannot be kept: give "
            "it one 'height', or a 'profile'",
            from->name);
    if (!isnan(options->corner) && (bent || profile || from->n_profile > 0))
        return error_set(err, HAWSER_ERR_INPUT,
                         "'%.60s' has %s: a 'radius' rounds the corners of a line of straights without, leave it out",
                         from->name, bent ? "bends of its own" : "a profile");
    return HAWSER_OK;
}

/* Stations of a part are on the file's line, but for their rounding. */
static hawser_status stations_check(const Alignment *a, const LineOptions *options, hawser_error *err)
{
    const double rounding = 0.01, end = a->station + alignment_measure(a).plan_length;
    const double from = isnan(options->from) ? a->station : options->from, to = isnan(options->to) ? end : options->to;
    if (from >= a->station - rounding && to <= end + rounding) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT,
                     "'%.60s' reaches from station %.10g m to %.10g m: it cannot be used from %.10g m to %.10g m",
                     a->name, a->station, end, from, to);
}

/* The part that is used, m from where the line begins. */
typedef struct Used {
    double from, to;
} Used;

/* What a file leaves out between two elements of it is not made up. `within`, m: what is bridged. */
static hawser_status gaps_check(const Alignment *a, Used part, double within, hawser_error *err)
{
    double s = 0;
    for (int i = 0; i + 1 < a->n_plan; ++i) {
        const PlanElement end = plan_at(&a->plan[i], a->plan[i].length), *const next = &a->plan[i + 1];
        const double gap = hypot(next->x - end.x, next->y - end.y);
        s += a->plan[i].length;
        if (gap <= within || s <= part.from || s >= part.to) continue;
        return error_set(err, HAWSER_ERR_INPUT,
                         "'%.60s': gap of %.4g m at %.3f, %.3f, where element %d ends: the next one begins at %.3f, "
                         "%.3f, and at most %.3g m are bridged (the tolerance)",
                         a->name, gap, end.x, end.y, i + 1, next->x, next->y, within);
    }
    return HAWSER_OK;
}

/* The same of a profile: over a gap the grade goes on, so that only its height can miss the next element's. */
static hawser_status jumps_check(const Alignment *a, Used part, double within, hawser_error *err)
{
    for (int i = 0; i + 1 < a->n_profile; ++i) {
        const ProfileElement *const e = &a->profile[i], *const next = e + 1;
        const double way = next->station - e->station;
        const ProfileElement end = profile_at(e, fmin(way, e->length));
        const double z = end.z + end.grade * fmax(way - e->length, 0);
        if (fabs(next->z - z) <= within || next->station <= part.from || next->station >= part.to) continue;
        return error_set(err, HAWSER_ERR_INPUT,
                         "'%.60s': the profile jumps by %.4g m at station %.10g m, from %.4f m to %.4f m, and at most "
                         "%.3g m are bridged (the tolerance)",
                         a->name, next->z - z, a->station + next->station, z, next->z, within);
    }
    return HAWSER_OK;
}

/* Neither what is used of the line nor the one that its heights come from has a hole. */
static hawser_status whole_check(const Alignment *from, const Alignment *profile, const LineOptions *options,
                                 hawser_error *err)
{
    const double within = options->tolerance;
    const Used all = {-INFINITY, INFINITY};
    const Used part = {isnan(options->from) ? -INFINITY : options->from - from->station,
                       isnan(options->to) ? INFINITY : options->to - from->station};
    hawser_status status = gaps_check(from, part, larger_of(within, options->line.join), err);
    if (!status) status = profile ? jumps_check(profile, all, within, err) : jumps_check(from, part, within, err);
    if (!status && profile && is_drawn(profile))
        status = gaps_check(profile, all, larger_of(within, options->profile.join), err);
    return status;
}

/* Corners that get a radius need no fit; straights that were joined are a line of points then. */
static hawser_status keep(const Alignment *from, UsedLine *used, hawser_error *err)
{
    Alignment *const a = &used->line;
    if (!alignment_copy(from, a)) return error_memory(err);
    a->n_plan = 0;
    for (int i = 0; i < from->n_plan; ++i) {
        const PlanElement end = plan_at(&from->plan[i], from->plan[i].length);
        Vec3 *const first = i ? NULL : alignment_add_point(a);
        if (first) *first = v3(from->plan[0].x, from->plan[0].y, 0);
        Vec3 *const next = alignment_add_point(a);
        if (!next || (i == 0 && !first)) return error_memory(err);
        *next = v3(end.x, end.y, 0);
        a->flat = a->drawn = 1;
    }
    return HAWSER_OK;
}

/* m, by which arcs of radius R cut the corners of a line of points, each that turns by an angle a: R (1/cos(a/2) - 1).
 */
static double corners_cut(const Alignment *a, double radius)
{
    double most = 0;
    for (int i = 1; i + 1 < a->n_points; ++i) {
        const Vec3 in = v3_sub(a->point[i], a->point[i - 1]), out = v3_sub(a->point[i + 1], a->point[i]);
        const double angle = atan2(v3_norm(v3_cross(in, out)), v3_dot(in, out));
        most = larger_of(most, radius * (1 / cos(angle / 2) - 1));
    }
    return most;
}

/* rad: what turns by more between two legs is a corner to whoever drew it. m: bends below are none that were meant. */
static const double CORNER = 0.35, SHARP = 1.5;

/* Corners that the fit made bends of which are only as wide as the tolerance allows: `radius` is what is missing. */
static void sharp_say(const Alignment *from, UsedLine *used)
{
    Vec3 *const point = calloc((size_t)from->n_plan + (size_t)from->n_points + 2, sizeof *point);
    int n = 0, corners;
    double most;
    for (int i = 0; point && i < from->n_points; ++i) point[n++] = from->point[i];
    for (int i = 0; point && i < from->n_plan; ++i) {
        const PlanElement end = plan_at(&from->plan[i], from->plan[i].length);
        if (from->plan[i].k0 != 0 || from->plan[i].k1 != 0) n = -from->n_plan; /* it has bends of its own */
        if (n == 0) point[n++] = v3(from->plan[i].x, from->plan[i].y, 0);
        if (n > 0) point[n++] = v3(end.x, end.y, 0);
    }
    const double radius = n > 2 ? corners_radius(n, point, CORNER, &corners, &most) : 0;
    const double least = alignment_measure(&used->line).least_radius;
    free(point);
    if (radius == 0 || !(least < SHARP) || !(radius > 2 * least)) return;
    used->sharpest = least;
    snprintf(used->sharp, sizeof used->sharp,
             "%d corner%s without a radius, a bend of %.2g m by the tolerance: give 'radius', such as %g m (room for "
             "%.3g m)",
             corners, corners > 1 ? "s" : "", least, radius, most);
}

/* A level line of corners as the straights and arcs that are built, so that they are shown and written. */
static hawser_status corners_build(const LineOptions *options, UsedLine *used, hawser_error *err)
{
    Alignment *const a = &used->line;
    PlanCorner *const corner = calloc((size_t)a->n_points, sizeof *corner);
    int wrong;
    used->rounded = 1;
    used->deviation = corners_cut(a, options->corner);
    a->corner = options->corner;
    if (!corner) return error_memory(err);
    for (int i = 0; i < a->n_points; ++i) corner[i] = (PlanCorner){.at = a->point[i], .radius = options->corner};
    const hawser_status status =
        a->flat ? plan_from_corners(a, a->n_points, corner, 0, &wrong, err) : HAWSER_OK; /* else arcs in space */
    if (!status && a->flat) a->n_points = 0;
    free(corner);
    return status;
}

static hawser_status part_take(const LineOptions *options, Alignment *a, hawser_error *err)
{
    const double length = alignment_measure(a).plan_length;
    const double from = isnan(options->from) ? 0 : options->from - a->station;
    const double to = isnan(options->to) ? length : options->to - a->station;
    const int whole = isnan(options->from) && isnan(options->to);
    const hawser_status status = whole ? HAWSER_OK : alignment_cut(a, fmax(from, -1e-6), fmin(to, length + 1e-6), err);
    if (!status && options->reverse) alignment_reverse(a);
    return status;
}

/* What the file itself says of the part that is used. Heights of another file are those of the line that is built. */
static hawser_status measure(const Alignment *from, int own_heights, const LineOptions *options, UsedLine *used,
                             hawser_error *err)
{
    Alignment file;
    const AlignmentMeasure built = alignment_measure(&used->line);
    if (!alignment_copy(from, &file)) return error_memory(err);
    const hawser_status status = part_take(options, &file, err);
    const AlignmentMeasure m = status ? built : alignment_measure(&file);
    used->file_plan = m.plan_length;
    used->file_length = own_heights ? m.length : built.length;
    used->file_start = v3(m.start.x, m.start.y, own_heights ? m.start.z : built.start.z);
    used->file_end = v3(m.end.x, m.end.y, own_heights ? m.end.z : built.end.z);
    alignment_clear(&file);
    return status;
}

void line_clear(UsedLine *used)
{
    alignment_clear(&used->line);
    free(used->unread);
    used->unread = NULL;
    used->n_unread = 0;
}

hawser_status line_use(const Alignment *from, const LineOptions *options, UsedLine *used, hawser_error *err)
{
    Survey s;
    const Alignment *profile;
    *used = (UsedLine){.fitted = 0};
    if (from->n_plan == 0 && from->n_points < 2)
        return error_set(err, HAWSER_ERR_INPUT, "'%.60s' is a profile without a plan: no route", from->name);
    hawser_status status = profile_find(options, &s, &profile, err);
    if (!status) status = asked_check(from, profile, options, err);
    if (!status) status = whole_check(from, profile, options, err);
    if (!status) status = stations_check(from, options, err);
    if (!status) status = !isnan(options->corner) ? keep(from, used, err) : fit(from, profile, options, used, err);
    if (!status) status = part_take(options, &used->line, err);
    if (!status) status = measure(from, !profile, options, used, err);
    if (!status) status = chain(options, used, err);
    if (!status && !isnan(options->corner)) status = corners_build(options, used, err);
    if (!status && isnan(options->corner)) sharp_say(from, used);
    used->unread = s.ignored; /* handed over */
    used->n_unread = s.n_ignored;
    s.ignored = NULL;
    s.n_ignored = 0;
    survey_clear(&s);
    if (status) line_clear(used);
    return status;
}
