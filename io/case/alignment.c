/* Turns elements in plan and of the profile, or corners, into pieces of a route. */
#include "io/case/alignment.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "core/error.h"
#include "core/vec3.h"
#include "io/case/units.h"
#include "survey/fit.h"
#include "survey/join.h"
#include "survey/read.h"

/* m: a shorter length is rounding. 1/m: a smaller curvature is straight. rad: a larger kink between elements of the
 * profile is a corner. m: largest cut at a corner without a radius. */
static const double SHORT = 1e-6, STRAIGHT = 1e-9, BENT = 5e-3, CUT = 1e-3;

/* ---------------------------------------------------------------------------------------------------- the profile */

typedef struct Slopes {
    int n;
    RouteProfileElement *e; /* [n] over the length in plan, end to end */
    double z;               /* m, height at their beginning */
} Slopes;

static void grade_add(Slopes *p, double length, double slope)
{
    if (length > SHORT) p->e[p->n++] = (RouteProfileElement){PROFILE_GRADE, length, {slope, slope}};
}

/* Extends the profile over [0, plan]: its first and last grade go on to the ends, gaps become grades. */
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

/* Removes the rounding between a curve and its neighbour: the curve takes the neighbour's slope. Returns 0 if a corner
 * is left between element i and the next, of which one is a curve. */
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

/* Computes the tangent length of the arc at a corner between two grades: of the least radius, or of one that cuts the
 * corner by a millimetre if that is larger and fits. */
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

/* Returns the i-th element, from 0 on, under its name in the file, or else under its kind and number. */
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

/* Builds the route of points whose corners have a radius. */
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

/* Lines of a file: joining and choice. */

LineOptions line_options(void)
{
    const double join = join_options().tolerance;
    return (LineOptions){.line = {.unit = NAN, .join = join},
                         .profile = {.unit = NAN, .join = join},
                         .from = NAN,
                         .to = NAN,
                         .tolerance = 0.05,
                         .corner = NAN,
                         .rounding = 2,
                         .height = NAN};
}

hawser_status line_unit(const char *name, double *metres, hawser_error *err)
{
    char text[64], why[UNITS_WHY_MAX];
    Units *const units = units_new();
    if (!units) return error_memory(err);
    snprintf(text, sizeof text, "1 %.50s", name);
    const int read = units_read(units, text, DIM_LENGTH, metres, why);
    units_free(units);
    if (read) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT, "'%.50s' is no unit of length: expected one such as mm, m or ft", name);
}

static int is_picked(const LinePick *pick, const Alignment *a)
{
    return (!pick->name || !strcasecmp(pick->name, a->name)) && (!pick->layer || !strcasecmp(pick->layer, a->layer));
}

/* Layers found so far: the first line of each. */
enum { LAYERS_MOST = 4096 };

typedef struct Layers {
    int n, first[LAYERS_MOST];
} Layers;

/* Checks whether a line's layer is new, and adds it to the layers found. */
static int layer_is_new(const Survey *s, int i, Layers *met)
{
    for (int k = 0; k < met->n && k < LAYERS_MOST; ++k) {
        if (!strcasecmp(s->alignment[met->first[k]].layer, s->alignment[i].layer)) return 0;
    }
    if (met->n < LAYERS_MOST) met->first[met->n] = i;
    met->n++;
    return 1;
}

static const char *const fork_word = "fork of ", *const gap_word = "gap of ";

/* Notes where the lines of a layer, or the parts of a feature (`what`, its name), end at a fork or gap: with places if
 * there are few, else their number. */
static void doubts_say(const char *what, const char *name, const Joined *j, Survey *notes)
{
    enum { FEW = 4 };
    char text[2 * SURVEY_NAME_MAX]; /* space for a layer's name, a rise and places far away */
    const int few = j->n_forks + j->n_gaps <= FEW;
    for (int i = 0; few && i < j->n_doubts; ++i) {
        const JoinDoubt *const d = &j->doubt[i];
        char rise[40] = "";
        if (d->rise > 0) snprintf(rise, sizeof rise, ", and %.4g m in height,", d->rise);
        if (d->kind == JOIN_FORK)
            snprintf(text, sizeof text, "%s%d ends at %.3f, %.3f, %s '%.40s': lines end there", fork_word, d->ends,
                     d->at.x, d->at.y, what, name);
        else
            snprintf(text, sizeof text, "%s%.4g m%s at %.3f, %.3f, %s '%.40s': not joined", gap_word, d->away, rise,
                     d->at.x, d->at.y, what, name);
        survey_ignore(notes, text);
    }
    snprintf(text, sizeof text, "forks, at which lines end, %s '%.60s'", what, name);
    for (int i = 0; !few && i < j->n_forks; ++i) survey_ignore(notes, text);
    snprintf(text, sizeof text, "gaps, which are not joined, %s '%.60s'", what, name);
    for (int i = 0; !few && i < j->n_gaps; ++i) survey_ignore(notes, text);
    snprintf(text, sizeof text, "pieces drawn twice, %s '%.60s'", what, name);
    for (int i = 0; i < j->doubles; ++i) survey_ignore(notes, text);
    snprintf(text, sizeof text, "pieces straight up or down, %s '%.60s'", what, name);
    for (int i = 0; i < j->upright; ++i) survey_ignore(notes, text);
    snprintf(text, sizeof text, "heights of a line of which some pieces have none, %s '%.60s'", what, name);
    for (int i = 0; i < j->lost_heights; ++i) survey_ignore(notes, text);
}

/* Joins touching parts of one feature of a map, from line i on, into one line; *next: the line behind them. */
static hawser_status parts_join(const LinePick *pick, Survey *pieces, int i, int *next, Survey *out, hawser_error *err)
{
    const Alignment *const a = &pieces->alignment[i];
    JoinOptions options = join_options();
    Joined joined;
    Survey parts = {.alignment = &pieces->alignment[i]}; /* borrowed: nothing in it is freed */
    while (i + parts.n < pieces->n && a[parts.n].whole == a->whole) ++parts.n;
    options.tolerance = pick->join;
    *next = i + parts.n;
    const hawser_status status = join_lines(&parts, &options, out, &joined, err);
    if (!status) doubts_say("in", a->name, &joined, pieces);
    return status;
}

/* Joins the pieces of each layer of a drawing; without a layer, the parts of each feature. */
static hawser_status pieces_join(const LinePick *pick, Survey *pieces, Survey *out, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    Layers met = {.n = 0};
    for (int i = 0, next; i < pieces->n && !status; i = next) {
        const Alignment *const a = &pieces->alignment[i];
        next = i + 1;
        if (met.n > LAYERS_MOST)
            return error_set(err, HAWSER_ERR_INPUT, "%.200s: lines on more than %d layers: choose one by 'layer'",
                             pick->path, LAYERS_MOST);
        if (!is_picked(pick, a)) continue;
        if (!*a->layer && a->whole) {
            status = parts_join(pick, pieces, i, &next, out, err);
        } else if (!*a->layer) {
            Alignment *const copy = survey_add(out, a->name);
            if (!copy || !alignment_copy(a, copy)) status = error_memory(err);
        } else if (layer_is_new(pieces, i, &met)) {
            JoinOptions options = join_options();
            Joined joined;
            options.tolerance = pick->join;
            options.layer = a->layer;
            options.name = pick->name;
            status = join_lines(pieces, &options, out, &joined, err);
            if (!status) doubts_say("layer", a->layer, &joined, pieces);
        }
    }
    return status;
}

/* Lists the first names and layers, for a message. */
static void names_say(const Survey *s, size_t room, char *text)
{
    enum { SHOWN = 8 };
    const Alignment *said[SHOWN];
    size_t used = 0;
    *text = 0;
    for (int i = 0, shown = 0; i < s->n && shown < SHOWN && used < room; ++i) {
        const Alignment *const a = &s->alignment[i];
        int met = 0;
        for (int k = 0; k < shown; ++k) met |= !strcmp(said[k]->name, a->name) && !strcmp(said[k]->layer, a->layer);
        if (met) continue;
        said[shown] = a;
        const int layer = *a->layer && strcmp(a->layer, a->name) != 0;
        used += (size_t)snprintf(text + used, room - used, "%s'%.40s'%s%.40s%s", shown ? ", " : "", a->name,
                                 layer ? " (layer '" : "", layer ? a->layer : "", layer ? "')" : "");
        ++shown;
    }
}

/* Explains that all lines are shorter than the joining distance and were left out. Returns 0 if they are not. */
static int short_say(const LinePick *pick, const Survey *pieces, size_t room, char *text)
{
    double longest = 0;
    for (int i = 0; i < pieces->n; ++i)
        if (is_picked(pick, &pieces->alignment[i]))
            longest = fmax(longest, alignment_measure(&pieces->alignment[i]).plan_length);
    if (!(longest > 0 && longest <= 2 * pick->join)) return 0;
    snprintf(text, room,
             "; the longest is %.4g m, with lengths in %.60s, and ends within %.4g m of each other are one place: give "
             "another unit ('units', --units), or a smaller 'join' (--join)",
             longest, pieces->unit, pick->join);
    return 1;
}

/* Lists what a file without a line contains instead; the line may be in there. */
static void ignored_say(const Survey *s, size_t room, char *text)
{
    enum { SHOWN = 5 };
    size_t used = 0;
    *text = 0;
    for (int i = 0; i < s->n_ignored && i < SHOWN && used < room; ++i) {
        used += (size_t)snprintf(text + used, room - used, "%s%.80s", i ? ", " : "; not read: ", s->ignored[i].what);
    }
}

hawser_status lines_read(const LinePick *pick, Survey *out, hawser_error *err)
{
    const SurveyOptions options = {.unit = pick->unit, .sheet = pick->sheet, .ignore = pick->ignore};
    Survey pieces;
    char names[500], ignored[500] = "";
    hawser_status status = survey_read(pick->path, &options, &pieces, err);
    *out = (Survey){0};
    if (status) return status;
    status = pieces_join(pick, &pieces, out, err);
    if (!status && out->n == 0) {
        names_say(&pieces, sizeof names, names);
        if (!short_say(pick, &pieces, sizeof ignored, ignored) && pieces.n == 0)
            ignored_say(&pieces, sizeof ignored, ignored);
        status =
            error_set(err, HAWSER_ERR_INPUT, "%.200s: no line%s%.60s%s%.60s%s; there %s%s%s", pick->path,
                      pick->name ? " of the name '" : "", pick->name ? pick->name : "",
                      pick->layer ? (pick->name ? "' on layer '" : " on layer '") : "", pick->layer ? pick->layer : "",
                      pick->name || pick->layer ? "'" : "", pieces.n ? "are " : "is none", names, ignored);
    }
    out->mark = pieces.mark; /* ownership passes on */
    out->n_marks = pieces.n_marks;
    out->ignored = pieces.ignored;
    out->n_ignored = pieces.n_ignored;
    pieces.mark = NULL;
    pieces.ignored = NULL;
    memcpy(out->system, pieces.system, sizeof out->system);
    out->mapped = pieces.mapped;
    memcpy(out->unit, pieces.unit, sizeof out->unit);
    out->drawn_unit = pieces.drawn_unit;
    survey_clear(&pieces);
    if (status) survey_clear(out);
    return status;
}

hawser_status line_choose(const LinePick *pick, const Survey *s, const Alignment **out, hawser_error *err)
{
    const double least = 0.1; /* share of the longest line's length: a shorter line is taken for a mark */
    const ChooseOptions any = {.name = NULL};
    char names[500];
    const char *open = NULL; /* a fork or gap that may have split a line */
    const int best = choose_line(s, &any);
    *out = best < 0 ? NULL : &s->alignment[best];
    if (best < 0) return error_set(err, HAWSER_ERR_INPUT, "%.200s: no line", pick->path);
    const double longest = alignment_measure(*out).plan_length;
    int rivals = 0;
    for (int i = 0; i < s->n; ++i)
        rivals += i != best && alignment_measure(&s->alignment[i]).plan_length > least * longest;
    if (rivals == 0) return HAWSER_OK;
    names_say(s, sizeof names, names);
    for (int i = 0; i < s->n_ignored && !open; ++i) {
        const char *const what = s->ignored[i].what;
        if (!strncmp(what, fork_word, strlen(fork_word)) || !strncmp(what, gap_word, strlen(gap_word))) open = what;
    }
    return error_set(err, HAWSER_ERR_INPUT,
                     "%.200s: %d lines could be meant, such as %s: choose one by 'name' or 'layer'%s%s%s", pick->path,
                     rivals + 1, names, open ? ", or join them (" : "", open ? open : "", open ? ")" : "");
}

hawser_status line_unit_check(const Survey *s, const Alignment *a, hawser_error *err)
{
    const double least = 1, most = 1e5; /* m, lengths of a cable's route */
    /* Figures of a map's grid in metres: coordinates are far from the origin, and the line is no longer than 10 km. */
    const double grid_from = 1e5, grid_to = 1e7, grid_length = 1e4, small = 0.0254;
    const double unit = s->drawn_unit;
    if (!(unit > 0)) return HAWSER_OK;
    const AlignmentMeasure m = alignment_measure(a);
    const double far = fmax(fabs(m.start.x), fabs(m.start.y)) / unit, figures = m.length / unit;
    const int grid = unit <= small && far >= grid_from && far <= grid_to && figures < grid_length;
    if (m.length >= least && m.length <= most && !grid) return HAWSER_OK;
    return error_set(
        err, HAWSER_ERR_INPUT,
        "'%.60s' is %.6g m long in the drawing's unit (%.60s), %.6g in its own figures%s: is that the unit? "
        "Give 'units' (--units), mm, m, ft or what it is",
        a->name, m.length, s->unit, figures, grid ? ", which are like those of a grid of metres" : "");
}

/* Removes the sign of a value that rounds to 0. */
static double shown(double x) { return fabs(x) < 5e-4 ? 0 : x; }

LineWay line_way(const Alignment *a, int reversed)
{
    const AlignmentMeasure m = alignment_measure(a);
    const Vec3 from = reversed ? m.end : m.start, to = reversed ? m.start : m.end;
    const double dx = to.x - from.x, dy = to.y - from.y, against = a->against / fmax(m.plan_length, 1e-300);
    const int ring = hypot(dx, dy) < 1e-3 * m.plan_length, across = fabs(dx) >= fabs(dy);
    LineWay way = {.side = ring               ? "back to its start"
                           : across && dx > 0 ? "left to right"
                           : across           ? "right to left"
                           : dy > 0           ? "bottom to top"
                                              : "top to bottom"};
    char drawn[80];
    if (a->against > 0)
        snprintf(drawn, sizeof drawn, "as %.0f %% of its length %s drawn", 100 * (1 - against),
                 against > 0.5 - 1e-9 ? "and its first piece are" : "is");
    else
        snprintf(drawn, sizeof drawn, "as it is drawn");
    snprintf(way.text, sizeof way.text, "from (%.3f, %.3f) to (%.3f, %.3f), %s, %s%s", shown(from.x), shown(from.y),
             shown(to.x), shown(to.y), way.side, reversed ? "against the way " : "", reversed ? drawn + 3 : drawn);
    return way;
}

/* Counts the lines beside the chosen one, and an undeclared unit, among the parts that are not read. */
static void line_notes_say(Survey *s, const Alignment *chosen)
{
    double sum = 0;
    char what[SURVEY_NAME_MAX];
    if (strstr(s->unit, "does not say") && strncmp(s->unit, "as asked", 8))
        survey_ignore(s, "unit of length: not given in the file, metres are assumed");
    for (int i = 0; i < s->n; ++i) sum += alignment_measure(&s->alignment[i]).plan_length;
    sum -= alignment_measure(chosen).plan_length;
    const int others = s->n - 1;
    snprintf(what, sizeof what, "%d other line%s, %s%.4g m, %s not in the route", others, others > 1 ? "s" : "",
             others > 1 ? "together " : "", sum, others > 1 ? "are" : "is");
    if (others > 0) survey_ignore(s, what);
}

enum { IGNORE_MOST = 2000 };

/* Reads names of columns, each onto a line of its own. */
static hawser_status ignore_read(const CaseReader *r, const CaseNode *section, char names[IGNORE_MOST])
{
    const CaseNode *const given = case_node_key(section, "ignore");
    const CaseNode *item = given && given->kind == NODE_LIST ? given->first : given;
    *names = 0;
    for (size_t n = 0; item; item = item == given ? NULL : item->next) {
        if (item->kind != NODE_TEXT || !*item->text || n + strlen(item->text) + 2 > IGNORE_MOST)
            return case_value_error(r->err, item, ": expected names of columns, at most %d characters", IGNORE_MOST);
        n += (size_t)sprintf(names + n, "%s\n", item->text);
    }
    return HAWSER_OK;
}

/* Reads the choice of a file's line; the texts stay the record's. */
static hawser_status pick_read(const CaseReader *r, const CaseNode *section, const LineRecord *in,
                               char ignore[IGNORE_MOST], LinePick *out, char **path)
{
    hawser_error why = {.message = ""};
    const hawser_status names = ignore_read(r, section, ignore);
    if (names) return names;
    out->sheet = *in->sheet ? in->sheet : NULL;
    out->ignore = *ignore ? ignore : NULL;
    out->name = *in->name ? in->name : NULL;
    out->layer = *in->layer ? in->layer : NULL;
    const CaseNode *const file = case_node_key(section, "file");
    if (file && !r->folder)
        return case_value_error(r->err, file, ": a case that is a text has no folder to look in: load it from a file");
    hawser_status status = case_file_path(r, section, in->file, path);
    out->path = *path;
    if (status || !*in->units) return status;
    status = line_unit(in->units, &out->unit, &why);
    return status ? case_key_cause(r->err, section, "units", "", &why) : HAWSER_OK;
}

/* Adds the parts of a file that are not in the route to the assumptions: `hawser check` and summaries list them. */
static hawser_status unread_say(const CaseReader *r, const CaseNode *section, int n, const SurveyIgnored *left)
{
    hawser_status status = HAWSER_OK;
    for (int i = 0; i < n && !status; ++i) status = case_unread_add(r, section, left[i].what, left[i].times);
    return status;
}

/* Adds findings in a drawing that decide the pull: the line's direction, and bends for which its chords stand. */
static hawser_status found_say(const CaseReader *r, const CaseNode *section, const Alignment *line,
                               const LineOptions *options, const UsedLine *used)
{
    if (!*line->layer) return HAWSER_OK;
    const LineWay way = line_way(line, options->reverse);
    char text[LINE_WORDS_MAX + 60];
    snprintf(text, sizeof text, "%s; 'reverse' turns it", way.text);
    hawser_status status = case_found_add(r, section, way.side, 0, text);
    if (!status && *used->bends) status = case_found_add(r, section, "bends", 1, used->bends);
    return status;
}

/* m: a sharper corner is not possible for a cable. */
static const double LEAST_BEND = 0.3;

/* Reads, chooses and uses the line of `node`'s file; *own: the file of this line was read, so that a later failure is
 * the profile's. */
static hawser_status line_find(const CaseReader *r, const CaseNode *node, const LineOptions *options, UsedLine *used,
                               int *own, hawser_error *err)
{
    Survey s;
    const Alignment *line;
    hawser_status status = lines_read(&options->line, &s, err);
    *own = !status;
    if (status) return status;
    status = line_choose(&options->line, &s, &line, err);
    if (!status) line_notes_say(&s, line);
    if (!status) status = line_unit_check(&s, line, err);
    if (!status) status = line_use(line, options, used, err);
    if (!status) used->mapped = s.mapped;
    if (!status) status = found_say(r, node, line, options, used);
    if (!status && *used->sharp && used->sharpest < LEAST_BEND) {
        status = error_set(err, HAWSER_ERR_INPUT, "%s", used->sharp);
        line_clear(used);
    }
    if (!status && *used->sharp) status = case_unread_add(r, node, used->sharp, 1);
    if (!status) status = unread_say(r, node, s.n_ignored, s.ignored);
    survey_clear(&s);
    const int pieces = used->line.n_plan + used->line.n_points;
    if (!status && pieces > LINE_PIECES_MOST) {
        status =
            error_set(err, HAWSER_ERR_INPUT,
                      "'%.60s' has %d pieces, and a case's route at most %d: take a part of it with 'from' and 'to'",
                      used->line.name, pieces, LINE_PIECES_MOST);
        line_clear(used);
    }
    return status;
}

/* Returns the key that an error of the file concerns, where it is not the file itself. */
static const CaseNode *blamed(const CaseNode *section, const char *message)
{
    const int columns = strstr(message, ": 'ignore' ") != NULL;
    const int sheet = strstr(message, ": no sheet '") || strstr(message, ": 'sheet' ");
    return columns ? case_node_key(section, "ignore") : sheet ? case_node_key(section, "sheet") : NULL;
}

hawser_status case_line_use(const CaseReader *r, const CaseNode *node, const LineRecord *line, const CaseNode *heights,
                            const LineRecord *profile, LineOptions *options, UsedLine *used)
{
    hawser_error why = {.message = ""};
    char *path = NULL, *profile_path = NULL, ignore[IGNORE_MOST], profile_ignore[IGNORE_MOST];
    *used = (UsedLine){.fitted = 0};
    hawser_status status = pick_read(r, node, line, ignore, &options->line, &path);
    if (!status && heights) status = pick_read(r, heights, profile, profile_ignore, &options->profile, &profile_path);
    if (!status) {
        assert(path);
        int own = 0;
        status = line_find(r, node, options, used, &own, &why);
        if (!status && heights) status = unread_say(r, heights, used->n_unread, used->unread);
        if (status == HAWSER_ERR_INPUT) {
            const int named = strncmp(why.message, path, strlen(path)) == 0 ||
                              (profile_path && strncmp(why.message, profile_path, strlen(profile_path)) == 0);
            const CaseNode *const key = blamed(own && heights ? heights : node, why.message);
            status = case_key_error(r->err, key ? key : node, key ? NULL : "file", "%s%s%s", named ? "" : path,
                                    named ? "" : ": ", why.message);
        } else if (status) {
            status = error_memory(r->err);
        }
    }
    if (!status) status = file_marks_add(&r->def->files, path, r->err);
    if (!status && profile_path) status = file_marks_add(&r->def->files, profile_path, r->err);
    if (status) line_clear(used);
    free(path);
    free(profile_path);
    return status;
}

/* A line of a file as it will be built: with its heights, fitted, cut, turned around, chained. */

/* Finds the line with the heights; *s is to be cleared. NULL in *profile: the line's own heights. */
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

/* Returns the largest distance between the chained elements and their places in the file, (AL8). */
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

/* Moves each element's beginning to the end of the one before, and reports the shift. */
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

/* Checks whether the heights of a line are drawn: its plan has stations and heights. */
static int is_drawn(const Alignment *profile)
{
    return profile->n_profile == 0 && (profile->n_plan > 0 || profile->flat);
}

/* Fits the line; joined elements stay as they are. Joining may exceed the deviation that the fit's cuts keep, so the
 * fit is repeated with a smaller one until the whole line is within the tolerance, unless it is far off. */
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

/* Checks for options that this line cannot use: none is ignored silently. */
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

/* Checks that the stations of a part are on the file's line, but for rounding. */
static hawser_status stations_check(const Alignment *a, const LineOptions *options, hawser_error *err)
{
    const double rounding = 0.01, end = a->station + alignment_measure(a).plan_length;
    const double from = isnan(options->from) ? a->station : options->from, to = isnan(options->to) ? end : options->to;
    if (from >= a->station - rounding && to <= end + rounding) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT,
                     "'%.60s' reaches from station %.10g m to %.10g m: it cannot be used from %.10g m to %.10g m",
                     a->name, a->station, end, from, to);
}

/* The used part, m from the line's beginning. */
typedef struct Used {
    double from, to;
} Used;

/* Checks that no used part lies in a gap between two elements. `within`, m: a smaller gap is bridged. */
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

/* Does the same for a profile: the grade goes on over a gap, so that only its height can differ from the next
 * element's. */
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

/* Checks that neither the used part of the line nor the line of its heights has a gap. */
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

/* Keeps the corners that get a radius without a fit; joined straights become a line of points. */
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

/* Returns the distance, m, by which arcs of radius R cut the corners of a line of points, each with an angle a: R
 * (1/cos(a/2) - 1). */
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

/* rad: a larger angle between two legs is meant as a corner. m: a smaller bend radius was not intended. */
static const double CORNER = 0.35, SHARP = 1.5;

/* Reports corners that became bends only as wide as the tolerance allows: the key `radius` is missing. */
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

/* Builds a level line of corners as straights and arcs, so that these are shown and written. */
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
        a->flat ? plan_from_corners(a, a->n_points, corner, 0, &wrong, err) : HAWSER_OK; /* otherwise arcs in space */
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

/* Measures the file's own line over the used part. Heights of another file are those of the line that is built. */
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
    used->unread = s.ignored; /* ownership passes on */
    used->n_unread = s.n_ignored;
    s.ignored = NULL;
    s.n_ignored = 0;
    survey_clear(&s);
    if (status) line_clear(used);
    return status;
}
