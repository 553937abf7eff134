/* Lines of a file: joined, and the one that is meant. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "core/base/error.h"
#include "io/alignment/line.h"
#include "io/yaml/units.h"
#include "survey/fit/join.h"
#include "survey/read/read.h"

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

/* Layers that have been met: the first line of each. */
enum { LAYERS_MOST = 4096 };
typedef struct Layers {
    int n, first[LAYERS_MOST];
} Layers;

/* Whether a line's layer is new; then it is among those that were met. */
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

/* Says where the lines of a layer, or the parts of a feature (`what`, its name), end although something goes on: with
 * places if there are few, else how many. */
static void doubts_say(const char *what, const char *name, const Joined *j, Survey *notes)
{
    enum { FEW = 4 };
    char text[2 * SURVEY_NAME_MAX]; /* with room for a layer's name, a rise and places far away */
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

/* Parts of one feature of a map, from line i on, that touch become one line; *next: the line behind them. */
static hawser_status parts_join(const LinePick *pick, Survey *pieces, int i, int *next, Survey *out, hawser_error *err)
{
    const Alignment *const a = &pieces->alignment[i];
    JoinOptions options = join_options();
    Joined joined;
    Survey parts = {.alignment = &pieces->alignment[i]}; /* a view: nothing of it is freed */
    while (i + parts.n < pieces->n && a[parts.n].whole == a->whole) ++parts.n;
    options.tolerance = pick->join;
    *next = i + parts.n;
    const hawser_status status = join_lines(&parts, &options, out, &joined, err);
    if (!status) doubts_say("in", a->name, &joined, pieces);
    return status;
}

/* Lines of drawings come in pieces, and pieces of one layer belong together; without a layer the parts of a feature do.
 */
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

/* What there is, for a message: the first names and layers. */
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

/* Of a file whose lines are all left out: they are shorter than what meets. 0: they are not. */
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

/* Of a file without a line: what is in it instead, which may be where the line is. */
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
    out->mark = pieces.mark; /* handed over */
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
    const double least = 0.1; /* of the longest one's length: what is shorter is taken for a mark */
    const ChooseOptions any = {.name = NULL};
    char names[500];
    const char *open = NULL; /* where a line may be torn */
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
    const double least = 1, most = 1e5; /* m, of a cable's route */
    /* Figures of a grid of metres: they lie far from the origin, and what they enclose is no longer than 10 km. */
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

/* Without the sign of what rounds to 0. */
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

void line_notes_say(Survey *s, const Alignment *chosen)
{
    double sum = 0;
    char what[SURVEY_NAME_MAX];
    if (strstr(s->unit, "does not say") && strncmp(s->unit, "as asked", 8))
        survey_ignore(s, "unit of length: the file does not say it, metres are taken");
    for (int i = 0; i < s->n; ++i) sum += alignment_measure(&s->alignment[i]).plan_length;
    sum -= alignment_measure(chosen).plan_length;
    const int others = s->n - 1;
    snprintf(what, sizeof what, "%d other line%s, %s%.4g m, %s not in the route", others, others > 1 ? "s" : "",
             others > 1 ? "together " : "", sum, others > 1 ? "are" : "is");
    if (others > 0) survey_ignore(s, what);
}
