/* Routes from files, printed by `hawser route`, places along them, and files of them. */
#include "hawser/hawser.h"

#include <jansson.h>
#include <locale.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "core/error.h"
#include "io/api/api_handles.h"
#include "io/case/alignment.h"
#include "io/case/units.h"
#include "io/report/route_page.h"
#include "io/results/results_file.h"
#include "survey/write.h"

/* A file with more lines than these is a whole drawing, of which not every line is meant as a route, and a line of more
 * pieces takes minutes to fit: these are prepared only on request. Each line of JSON repeats the file's ignored parts,
 * but not a million times. */
enum { PLACES_LEAST = 400, PLACES_MOST = 20000, LEFT_MOST = 200000 }; /* of a page: points of a line, in grey */
enum { USED_AT_ONCE = 32, IGNORED_WITH_EACH = 1000, PIECES_AT_ONCE = LINE_PIECES_MOST, DIGITS = 13 };

static const double DEGREES = 180 / 3.14159265358979323846;

/* A line prepared as a route. */
typedef struct RouteUse {
    UsedLine line;        /* empty if there is a problem */
    hawser_error problem; /* reason why it cannot be one; figures.problem is its text */
    LineWay way;          /* its direction */
    int built;            /* route is filled */
    Route route;
} RouteUse;

/* A line of the file. A drawing may have a million, of which few are ever used. */
typedef struct RouteRow {
    hawser_route_figures figures;
    RouteUse *use; /* NULL: not tried yet */
} RouteRow;

struct hawser_routes {
    char *path, *name, *layer, *profile, *sheet, *ignore;
    LineOptions options;
    Survey survey;
    RouteRow *row; /* [survey.n] */
};

hawser_route_options hawser_route_defaults(void)
{
    const LineOptions usual = line_options();
    return (hawser_route_options){
        .from_m = NAN, .to_m = NAN, .tolerance_m = usual.tolerance, .radius_m = NAN, .join_m = usual.line.join};
}

/* ------------------------------------------------------------------------------------------------------- reading */

/* Returns a copy of a text; *fine becomes 0 without memory. */
static char *keep(const char *text, int *fine)
{
    char *const copy = text ? strdup(text) : NULL;
    if (text && !copy) *fine = 0;
    return copy;
}

static hawser_status options_take(const char *path, const hawser_route_options *from, hawser_routes *r,
                                  hawser_error *err)
{
    int fine = 1;
    LineOptions *const o = &r->options;
    *o = line_options();
    r->path = keep(path, &fine);
    r->name = keep(from->name, &fine);
    r->layer = keep(from->layer, &fine);
    r->profile = keep(from->profile, &fine);
    r->sheet = keep(from->sheet, &fine);
    r->ignore = keep(from->ignore, &fine);
    for (char *c = r->ignore; c && *c; ++c) *c = *c == ',' ? '\n' : *c;
    if (!fine) return error_memory(err);
    o->line = (LinePick){.path = r->path, .name = r->name, .layer = r->layer, .unit = NAN, .join = from->join_m};
    o->profile.join = from->join_m;
    o->profile.path = r->profile;
    o->reverse = from->reverse;
    o->from = from->from_m;
    o->to = from->to_m;
    o->tolerance = from->tolerance_m;
    o->corner = from->radius_m;
    o->line.sheet = r->sheet;
    o->line.ignore = r->ignore;
    if (!(o->tolerance > 0 && o->tolerance <= 1000))
        return error_set(err, HAWSER_ERR_INPUT, "a tolerance of %g m: must be above 0 m, at most 1000 m", o->tolerance);
    if (!(from->join_m > 0 && from->join_m <= 10))
        return error_set(err, HAWSER_ERR_INPUT, "ends that meet within %g m: must be above 0 m, at most 10 m",
                         from->join_m);
    if (o->corner <= 0) return error_set(err, HAWSER_ERR_INPUT, "a radius of %g m: must be above 0 m", o->corner);
    hawser_status status = from->units ? line_unit(from->units, &o->line.unit, err) : HAWSER_OK;
    return status;
}

/* Prepares the line as it will be built; a problem stays in its row. Errors: MEMORY. */
static hawser_status row_use(const hawser_routes *r, int i, hawser_error *err)
{
    RouteRow *const row = &r->row[i];
    if (row->use) return HAWSER_OK;
    RouteUse *const use = row->use = calloc(1, sizeof *use);
    if (!use) return error_memory(err);
    const UsedLine *const line = &use->line;
    hawser_route_figures *const f = &row->figures;
    const Alignment *const own = &r->survey.alignment[i];
    use->way = line_way(own, r->options.reverse);
    hawser_status used = line_unit_check(&r->survey, own, &use->problem);
    if (!used) used = line_use(own, &r->options, &use->line, &use->problem);
    if (used == HAWSER_ERR_MEMORY) { /* not the line's fault: it may be tried again */
        free(use);
        row->use = NULL;
        return error_memory(err);
    }
    if (used) {
        f->problem = use->problem.message;
        return HAWSER_OK;
    }
    const AlignmentMeasure m = alignment_measure(&line->line);
    f->length_m = line->file_length;
    f->horizontal_length_m = line->file_plan;
    f->station_m = fabs(line->line.station) < 1e-9 ? 0 : line->line.station;
    f->pieces = m.pieces;
    f->fitted = line->fitted;
    f->least_radius_m = m.least_radius;
    f->deviation_max_m = line->deviation;
    f->rms_m = line->rms;
    v3_put(f->start_m, line->file_start);
    v3_put(f->end_m, line->file_end);
    return HAWSER_OK;
}

/* Fills in the file's own line before it is prepared. */
static void row_begin(const hawser_routes *r, int i)
{
    const Alignment *const a = &r->survey.alignment[i];
    const AlignmentMeasure m = alignment_measure(a);
    hawser_route_figures *const f = &r->row[i].figures;
    *f = (hawser_route_figures){.name = a->name,
                                .layer = a->layer,
                                .length_m = m.length,
                                .horizontal_length_m = m.plan_length,
                                .station_m = fabs(a->station) < 1e-9 ? 0 : a->station,
                                .pieces = m.pieces,
                                .least_radius_m = m.least_radius};
    v3_put(f->start_m, m.start);
    v3_put(f->end_m, m.end);
}

hawser_status hawser_routes_read(const char *path, const hawser_route_options *options, hawser_routes **out,
                                 hawser_error *err)
{
    const hawser_route_options usual = hawser_route_defaults();
    if (!path || !out) return error_argument(err, path ? "out" : "path");
    hawser_routes *r = calloc(1, sizeof *r);
    *out = NULL;
    if (!r) return error_memory(err);
    hawser_status status = options_take(path, options ? options : &usual, r, err);
    if (!status) status = lines_read(&r->options.line, &r->survey, err);
    if (!status) {
        r->row = calloc((size_t)r->survey.n + 1, sizeof *r->row);
        if (!r->row) status = error_memory(err);
    }
    for (int i = 0; i < r->survey.n && !status; ++i) row_begin(r, i);
    for (int i = 0; i < r->survey.n && r->survey.n <= USED_AT_ONCE && !status; ++i) {
        const Alignment *const a = &r->survey.alignment[i];
        if (a->n_plan + a->n_points <= PIECES_AT_ONCE) status = row_use(r, i, err);
        const RouteUse *const use = r->row[i].use;
        if (use && *use->line.sharp) survey_ignore(&r->survey, use->line.sharp);
    }
    const LineOptions *const o = &r->options;
    const int asked = o->profile.path || !isnan(o->from) || !isnan(o->to);
    if (!status && r->survey.n == 1 && asked && r->row[0].figures.problem)
        status = error_set(err, r->row[0].use->problem.status, "%.300s: %.700s", path, r->row[0].figures.problem);
    if (status)
        hawser_routes_free(r);
    else
        *out = r;
    return status;
}

void hawser_routes_free(hawser_routes *r)
{
    if (!r) return;
    for (int i = 0; r->row && i < r->survey.n; ++i) {
        RouteUse *const use = r->row[i].use;
        if (!use) continue;
        line_clear(&use->line);
        if (use->built) route_clear(&use->route);
        free(use);
    }
    free(r->row);
    survey_clear(&r->survey);
    free(r->path);
    free(r->name);
    free(r->layer);
    free(r->profile);
    free(r->sheet);
    free(r->ignore);
    free(r);
}

int hawser_routes_count(const hawser_routes *r) { return r ? r->survey.n : 0; }

/* --------------------------------------------------------------------------------------------------------- bends */

/* Describes an element as a bend; 0: it is no arc. */
static int bend_of(const PlanElement *e, double station, hawser_route_bend *bend)
{
    if (e->k0 != e->k1 || e->k0 == 0) return 0;
    const double radius = 1 / fabs(e->k0), part = e->k_sd > 0 ? (double)e->k_sd * radius : NAN;
    *bend = (hawser_route_bend){station, e->length, e->length * e->k0, radius, part * radius};
    return 1;
}

/* Lists the arcs of corners in space that are built with one radius, by stations along the line. */
static int corners_list(const Alignment *a, double station, hawser_route_bend *bend)
{
    int n = 0;
    for (int i = 1; i + 1 < a->n_points; ++i) {
        const Vec3 in = v3_sub(a->point[i], a->point[i - 1]), out = v3_sub(a->point[i + 1], a->point[i]);
        const double angle = atan2(v3_norm(v3_cross(in, out)), v3_dot(in, out)), half = a->corner * tan(angle / 2);
        station += v3_norm(in) - half;
        const double side = in.x * out.y - in.y * out.x < 0 ? -1 : 1;
        if (bend) bend[n] = (hawser_route_bend){station, a->corner * angle, side * angle, a->corner, NAN};
        station += a->corner * angle - half;
        n += angle > 1e-6;
    }
    return n;
}

/* Counts the arcs of a prepared line, and lists them if `bend` is not NULL. */
static int bends_list(const RouteRow *row, hawser_route_bend *bend)
{
    const Alignment *const a = row->use ? &row->use->line.line : NULL;
    double station = row->figures.station_m;
    int n = a && a->n_plan == 0 && a->corner > 0 ? corners_list(a, station, bend) : 0;
    for (int i = 0; a && i < a->n_plan; station += a->plan[i].length, ++i) {
        hawser_route_bend one;
        if (!bend_of(&a->plan[i], station, &one)) continue;
        if (bend) bend[n] = one;
        ++n;
    }
    return n;
}

/* --------------------------------------------------------------------------------------------------------- texts */

static json_t *json_number(double value) { return isfinite(value) ? json_real(value) : json_null(); }

static json_t *json_place(const double at[3]) { return json_pack("[fff]", at[0], at[1], at[2]); }

/* Returns the finished value; NULL, which fails wherever it is put, if there was no memory for a part of it. */
static json_t *json_whole(json_t *value, int bad)
{
    if (!bad) return value;
    json_decref(value);
    return NULL;
}

static json_t *json_or_null(const char *text) { return text ? json_string(text) : json_null(); }

/* Returns entries such as "cant, 12 times" for the whole file. */
static json_t *json_ignored(const Survey *s)
{
    json_t *const list = json_array();
    char text[SURVEY_NAME_MAX + 40];
    int bad = !list;
    for (int i = 0; i < s->n_ignored && !bad; ++i) {
        snprintf(text, sizeof text, "%s, %ld times", s->ignored[i].what, s->ignored[i].times);
        bad = json_array_append_new(list, json_string(s->ignored[i].times > 1 ? text : s->ignored[i].what));
    }
    return json_whole(list, bad);
}

static json_t *json_bends(const RouteRow *row)
{
    json_t *const list = json_array();
    hawser_route_bend *const bend = calloc((size_t)bends_list(row, NULL) + 1, sizeof *bend);
    int bad = !list || !bend;
    for (int i = 0, n = bad ? 0 : bends_list(row, bend); i < n && !bad; ++i) {
        json_t *const o = json_object();
        bad = json_object_set_new(o, "station_m", json_number(bend[i].station_m)) ||
              json_object_set_new(o, "length_m", json_number(bend[i].length_m)) ||
              json_object_set_new(o, "turn_deg", json_number(bend[i].turn * DEGREES)) ||
              json_object_set_new(o, "radius_m", json_number(bend[i].radius_m)) ||
              json_object_set_new(o, "radius_sd_m", json_number(bend[i].radius_sd_m));
        bad |= json_array_append_new(list, o);
    }
    free(bend);
    return json_whole(list, bad);
}

static json_t *json_line(const hawser_routes *r, int i)
{
    const hawser_route_figures *const f = &r->row[i].figures;
    json_t *const o = json_object();
    int bad = json_object_set_new(o, "name", json_or_null(f->name)) ||
              json_object_set_new(o, "layer", json_or_null(f->layer)) ||
              json_object_set_new(o, "length_m", json_number(f->length_m)) ||
              json_object_set_new(o, "horizontal_length_m", json_number(f->horizontal_length_m)) ||
              json_object_set_new(o, "station_m", json_number(f->station_m)) ||
              json_object_set_new(o, "start", json_place(f->start_m)) ||
              json_object_set_new(o, "end", json_place(f->end_m)) ||
              json_object_set_new(o, "pieces", json_integer(f->pieces)) ||
              json_object_set_new(o, "fitted", json_boolean(f->fitted)) ||
              json_object_set_new(o, "least_radius_m", json_number(f->least_radius_m)) ||
              json_object_set_new(o, "deviation_max_m", json_number(f->deviation_max_m)) ||
              json_object_set_new(o, "deviation_rms_m", json_number(f->rms_m)) ||
              json_object_set_new(o, "bends", json_bends(&r->row[i]));
    const RouteUse *const use = r->row[i].use;
    if (use) bad = bad || json_object_set_new(o, "direction", json_or_null(use->way.text));
    if (use && *use->line.bends) bad = bad || json_object_set_new(o, "recognised", json_or_null(use->line.bends));
    if (f->problem) bad = bad || json_object_set_new(o, "problem", json_or_null(f->problem));
    if (r->survey.n <= IGNORED_WITH_EACH) bad = bad || json_object_set_new(o, "ignored", json_ignored(&r->survey));
    return json_whole(o, bad);
}

/* Adds nothing if there was no memory for the text. */
static void grow(Growing *g, const char *more)
{
    if (more) growing_add(g, more, strlen(more));
    g->bad |= !more;
}

/* Adds the value, which is freed, on one line. */
static void grow_json(Growing *g, const char *before, json_t *value)
{
    char *const text = value ? json_dumped(value, JSON_ENCODE_ANY | JSON_REAL_PRECISION(DIGITS)) : NULL;
    grow(g, before);
    grow(g, text);
    free(text);
    json_decref(value);
}

/* Writes a line of text for each of the file's lines, one by one: a tree of a million of them would take gigabytes. */
static hawser_status json_write(const hawser_routes *r, char **text, hawser_error *err)
{
    const Survey *const s = &r->survey;
    Growing g = {0};
    grow_json(&g, "{\n  \"source\": ", json_or_null(r->path));
    grow_json(&g, ",\n  \"system\": ", json_or_null(*s->system ? s->system : NULL));
    grow_json(&g, ",\n  \"unit\": ", json_or_null(s->unit));
    grow_json(&g, ",\n  \"ignored\": ", json_ignored(s));
    grow(&g, ",\n  \"alignments\": [");
    for (int i = 0; i < s->n && !g.bad; ++i) grow_json(&g, i ? ",\n    " : "\n    ", json_line(r, i));
    grow(&g, "\n  ]\n}\n");
    *text = growing_end(&g);
    return *text ? HAWSER_OK : error_memory(err);
}

static double figure_at(const void *row, int end, int axis)
{
    const hawser_route_figures *const f = &((const RouteRow *)row)->figures;
    return end ? f->end_m[axis] : f->start_m[axis];
}
static double start_x(const void *row) { return figure_at(row, 0, 0); }
static double start_y(const void *row) { return figure_at(row, 0, 1); }
static double start_z(const void *row) { return figure_at(row, 0, 2); }
static double end_x(const void *row) { return figure_at(row, 1, 0); }
static double end_y(const void *row) { return figure_at(row, 1, 1); }
static double end_z(const void *row) { return figure_at(row, 1, 2); }

static const Column line_column[] = {
    {COLUMN("name", TEXT, RouteRow, figures.name), .label = "name"},
    {COLUMN("layer", TEXT, RouteRow, figures.layer), .label = "layer"},
    {COLUMN("station_m", NUMBER, RouteRow, figures.station_m), .label = "from station, m", .decimals = 3},
    {COLUMN("length_m", NUMBER, RouteRow, figures.length_m), .label = "length, m", .decimals = 3},
    {COLUMN("horizontal_length_m", NUMBER, RouteRow, figures.horizontal_length_m), .label = "in plan, m",
     .decimals = 3},
    {COLUMN("pieces", COUNT, RouteRow, figures.pieces), .label = "pieces"},
    {COLUMN("least_radius_m", NUMBER, RouteRow, figures.least_radius_m), .label = "least radius, m", .decimals = 2},
    {COLUMN("deviation_max_m", NUMBER, RouteRow, figures.deviation_max_m), .label = "deviation, m", .decimals = 4},
    {.key = "start_x_m", .number = start_x, .label = "start x, m", .decimals = 3, .group = 1, .digits = DIGITS},
    {.key = "start_y_m", .number = start_y, .label = "start y, m", .decimals = 3, .group = 1, .digits = DIGITS},
    {.key = "start_z_m", .number = start_z, .label = "start z, m", .decimals = 3, .group = 1, .digits = DIGITS},
    {.key = "end_x_m", .number = end_x, .label = "end x, m", .decimals = 3, .group = 1, .digits = DIGITS},
    {.key = "end_y_m", .number = end_y, .label = "end y, m", .decimals = 3, .group = 1, .digits = DIGITS},
    {.key = "end_z_m", .number = end_z, .label = "end z, m", .decimals = 3, .group = 1, .digits = DIGITS},
};
/* An arc of a fitted line, with the line's name. */
typedef struct BendRow {
    const char *name;
    hawser_route_bend bend;
    double turn_deg;
} BendRow;

static const Column bend_column[] = {
    {COLUMN("name", TEXT, BendRow, name), .label = "name"},
    {COLUMN("station_m", NUMBER, BendRow, bend.station_m), .label = "from station, m", .decimals = 2},
    {COLUMN("length_m", NUMBER, BendRow, bend.length_m), .label = "length, m", .decimals = 2},
    {COLUMN("turn_deg", NUMBER, BendRow, turn_deg), .label = "turn, deg", .decimals = 1},
    {COLUMN("radius_m", NUMBER, BendRow, bend.radius_m), .label = "radius, m", .decimals = 2},
    {COLUMN("radius_sd_m", NUMBER, BendRow, bend.radius_sd_m), .label = "+-, m", .decimals = 2},
};

/* Returns the arcs of all fitted lines, *n of them. NULL: no memory. */
static BendRow *bend_rows(const hawser_routes *r, int *n)
{
    int all = 0;
    *n = 0;
    for (int i = 0; i < r->survey.n; ++i) all += bends_list(&r->row[i], NULL);
    BendRow *const rows = calloc((size_t)all + 1, sizeof *rows);
    hawser_route_bend *const bend = calloc((size_t)all + 1, sizeof *bend);
    for (int i = 0; rows && bend && i < r->survey.n; ++i) {
        const int shown = r->row[i].figures.fitted || (r->row[i].use && r->row[i].use->line.rounded);
        const int found = shown ? bends_list(&r->row[i], bend) : 0;
        for (int k = 0; k < found; ++k)
            rows[(*n)++] = (BendRow){r->row[i].figures.name, bend[k], bend[k].turn * DEGREES};
    }
    const int memory = rows && bend;
    free(bend);
    if (memory) return rows;
    free(rows);
    return NULL;
}

/* Direction of a line, or features that were recognised in it. */
typedef struct FoundRow {
    const char *name;
    char text[LINE_WORDS_MAX + 40];
} FoundRow;

static const Column found_column[] = {
    {COLUMN("name", TEXT, FoundRow, name), .label = "name"},
    {COLUMN("what", CHARS, FoundRow, text), .label = "which way, and what was recognised"},
};

/* Returns the rows of lines that are used, *n of them. NULL: no memory. */
static FoundRow *found_rows(const hawser_routes *r, int *n)
{
    int used = 0;
    for (int i = 0; i < r->survey.n; ++i) used += r->row[i].use != NULL;
    FoundRow *const rows = calloc(2 * (size_t)used + 1, sizeof *rows);
    *n = 0;
    for (int i = 0; rows && i < r->survey.n; ++i) {
        const RouteUse *const use = r->row[i].use;
        const char *const name = r->row[i].figures.name;
        if (!use) continue;
        FoundRow *const row = &rows[(*n)++];
        row->name = name;
        snprintf(row->text, sizeof row->text, "%s; --reverse turns it", use->way.text);
        if (!*use->line.bends) continue;
        rows[*n].name = name;
        snprintf(rows[(*n)++].text, sizeof row->text, "%s", use->line.bends);
    }
    return rows;
}

static const Column problem_column[] = {
    {COLUMN("name", TEXT, RouteRow, figures.name), .label = "name"},
    {COLUMN("problem", TEXT, RouteRow, figures.problem), .label = "why"},
};
static const Column ignored_column[] = {
    {COLUMN("what", CHARS, SurveyIgnored, what), .label = "what"},
    {COLUMN("times", LONG, SurveyIgnored, times), .label = "times"},
};

hawser_status hawser_routes_describe(const hawser_routes *r, hawser_format format, char **text, hawser_error *err)
{
    if (!r || !text) return error_argument(err, r ? "text" : "r");
    const Survey *const s = &r->survey;
    *text = NULL;
    if (format == HAWSER_JSON) return json_write(r, text, err);
    int n_bad = 0, n = 1, n_bends = 0, n_found = 0;
    RouteRow *const bad = calloc((size_t)s->n + 1, sizeof *bad);
    BendRow *const bends = bend_rows(r, &n_bends);
    FoundRow *const found = found_rows(r, &n_found);
    if (!bad || !bends || !found) {
        free(found);
        free(bad);
        free(bends);
        return error_memory(err);
    }
    for (int i = 0; i < s->n; ++i) {
        if (r->row[i].figures.problem) bad[n_bad++] = r->row[i];
    }
    Table tables[5] = {{"alignments", "Lines", COLUMNS(RouteRow, line_column), s->n, r->row}};
    if (n_found) tables[n++] = (Table){"found", "Direction", COLUMNS(FoundRow, found_column), n_found, found};
    if (n_bends)
        tables[n++] =
            (Table){"bends", "Fitted bends, +- one standard deviation", COLUMNS(BendRow, bend_column), n_bends, bends};
    if (n_bad) tables[n++] = (Table){"problems", "No routes", COLUMNS(RouteRow, problem_column), n_bad, bad};
    if (s->n_ignored)
        tables[n++] = (Table){"ignored", "Not read", COLUMNS(SurveyIgnored, ignored_column), s->n_ignored, s->ignored};
    const Fact facts[] = {
        {"source", "file", "", cell_text(r->path)},
        {"unit", "unit of length", "", cell_text(*s->unit ? s->unit : "m")},
        {"system", "coordinates", "", cell_text(*s->system ? s->system : "not said")},
        {"marks", "points with names", "", cell_number(s->n_marks)},
    };
    const Document doc = {.title = "Routes of a file",
                          .n_facts = (int)(sizeof facts / sizeof *facts),
                          .n_tables = n,
                          .fact = facts,
                          .table = tables,
                          .csv = tables};
    const hawser_status status = document_write(&doc, format, text, err);
    free(bad);
    free(bends);
    free(found);
    return status;
}

/* -------------------------------------------------------------------------------------------------- one of them */

/* Returns the row of line i, prepared. */
static hawser_status row_find(const hawser_routes *r, int i, RouteRow **row, hawser_error *err)
{
    if (i < 0 || i >= r->survey.n) return error_set(err, HAWSER_ERR_INPUT, "no line %d: there are %d", i, r->survey.n);
    *row = &r->row[i];
    return row_use(r, i, err);
}

/* Does the same for one that can be a route. */
static hawser_status row_good(const hawser_routes *r, int i, RouteRow **row, hawser_error *err)
{
    const hawser_status status = row_find(r, i, row, err);
    if (status || !(*row)->figures.problem) return status;
    return error_set(err, (*row)->use->problem.status, "%.300s: %.700s", r->path, (*row)->figures.problem);
}

hawser_status hawser_routes_figures(const hawser_routes *r, int i, hawser_route_figures *out, hawser_error *err)
{
    RouteRow *row = NULL;
    if (!r || !out) return error_argument(err, r ? "out" : "r");
    const hawser_status status = row_find(r, i, &row, err);
    if (!status) *out = row->figures;
    return status;
}

hawser_status hawser_routes_bends(const hawser_routes *r, int i, int *n, hawser_route_bend **bends, hawser_error *err)
{
    RouteRow *row = NULL;
    if (!r || !n || !bends) return error_argument(err, !r ? "r" : !n ? "n" : "bends");
    *n = 0;
    *bends = NULL;
    const hawser_status status = row_good(r, i, &row, err);
    if (status) return status;
    *bends = calloc((size_t)bends_list(row, NULL) + 1, sizeof **bends);
    if (!*bends) return error_memory(err);
    *n = bends_list(row, *bends);
    return HAWSER_OK;
}

void hawser_route_bends_free(hawser_route_bend *bends) { free(bends); }

/* Builds the route in the line's own coordinates, however large: resolution 1e-9 m. */
static hawser_status row_build(const hawser_routes *r, int i, RouteRow **row, hawser_error *err)
{
    RouteLine line;
    hawser_status status = row_good(r, i, row, err);
    RouteUse *const use = status ? NULL : (*row)->use;
    if (status || use->built) return status;
    status = line_route(&use->line, &r->options, V3_ZERO, &line, err);
    if (!status) {
        status = route_build(&use->route, line.n, line.piece, line.start, line.heading, line.slope, err);
        use->built = !status;
    }
    free(line.piece);
    return status;
}

hawser_status hawser_routes_length(hawser_routes *r, int i, double *length_m, hawser_error *err)
{
    RouteRow *row = NULL;
    if (!r || !length_m) return error_argument(err, r ? "length_m" : "r");
    const hawser_status status = row_build(r, i, &row, err);
    if (!status) *length_m = row->use->route.length;
    return status;
}

hawser_status hawser_routes_at(hawser_routes *r, int i, double s_m, hawser_route_place *out, hawser_error *err)
{
    RouteRow *row = NULL;
    if (!r || !out) return error_argument(err, r ? "out" : "r");
    if (!isfinite(s_m))
        return error_set(err, HAWSER_ERR_INPUT, "the place along the route, %g m, is not a finite number", s_m);
    const hawser_status status = row_build(r, i, &row, err);
    if (status) return status;
    const RoutePoint p = route_at(&row->use->route, s_m);
    v3_put(out->position_m, p.position);
    v3_put(out->tangent, p.tangent);
    v3_put(out->curvature_per_m, p.curvature);
    return HAWSER_OK;
}

/* --------------------------------------------------------------------------------------------------------- a page */

/* Fills places along a line as it would be built, and the middles of its bends. Errors: MEMORY. */
static hawser_status page_line(const hawser_routes *r, int i, RoutePageLine *out, hawser_error *err)
{
    RouteRow *row = &r->row[i];
    hawser_error why;
    *out = (RoutePageLine){.figures = &row->figures, .problem = row->figures.problem};
    if (!row->use) out->problem = "not tried: choose it by its name or layer";
    if (out->problem) return HAWSER_OK;
    out->way = row->use->way.text;
    out->found = row->use->line.bends;
    const hawser_status status = row_build(r, i, &row, &why);
    if (status == HAWSER_ERR_MEMORY) return error_memory(err);
    if (status) {
        if (!row->figures.problem) row->use->problem = why;
        out->problem = row->use->problem.message;
        return HAWSER_OK;
    }
    const Alignment *const a = &row->use->line.line;
    const Route *const route = &row->use->route;
    const int n = (int)fmin(PLACES_MOST, PLACES_LEAST + 20.0 * row->figures.pieces);
    out->n_bends = bends_list(row, NULL);
    out->x = calloc(4 * (size_t)n, sizeof *out->x);
    out->bend = calloc((size_t)out->n_bends + 1, sizeof *out->bend);
    out->bend_x = calloc(2 * (size_t)out->n_bends + 1, sizeof *out->bend_x);
    if (!out->x || !out->bend || !out->bend_x) return error_memory(err);
    out->n = n;
    out->y = out->x + n;
    out->z = out->y + n;
    out->station = out->z + n;
    for (int k = 0; k < n; ++k) {
        const Vec3 at = route_at(route, route->length * k / (n - 1)).position;
        out->x[k] = at.x;
        out->y[k] = at.y;
        out->z[k] = at.z;
        out->station[k] = k ? out->station[k - 1] + hypot(at.x - out->x[k - 1], at.y - out->y[k - 1]) : a->station;
    }
    bends_list(row, out->bend);
    out->bend_y = out->bend_x + out->n_bends;
    for (int k = 0; k < out->n_bends; ++k) {
        const double s = out->bend[k].station_m + out->bend[k].length_m / 2 - row->figures.station_m;
        const Vec3 at = a->n_plan ? alignment_at(a, s).at : route_at(route, s).position;
        out->bend_x[k] = at.x;
        out->bend_y[k] = at.y;
    }
    return HAWSER_OK;
}

static void left_add(RoutePage *page, double x, double y)
{
    page->left_x[page->n_left] = x;
    page->left_y[page->n_left++] = y;
}

/* Fills the file's own lines, up to LEFT_MOST points, and its points. Errors: MEMORY. */
static hawser_status page_left(const Survey *s, RoutePage *page, hawser_error *err)
{
    enum { CHORDS = 40 }; /* for an element that is not straight */
    const size_t marks = (size_t)(s->n_marks < LEFT_MOST ? s->n_marks : LEFT_MOST);
    page->left_x = malloc((size_t)LEFT_MOST * sizeof(double));
    page->left_y = malloc((size_t)LEFT_MOST * sizeof(double));
    page->mark_x = malloc((marks + 1) * sizeof(double));
    page->mark_y = malloc((marks + 1) * sizeof(double));
    if (!page->left_x || !page->left_y || !page->mark_x || !page->mark_y) return error_memory(err);
    for (int i = 0; i < s->n; ++i) {
        const Alignment *const a = &s->alignment[i];
        if (page->n_left + a->n_points + (CHORDS + 2L) * a->n_plan + 2 > LEFT_MOST) {
            page->n_more++;
            continue;
        }
        for (int k = 0; k < a->n_points; ++k) left_add(page, a->point[k].x, a->point[k].y);
        for (int k = 0; k < a->n_plan; ++k) {
            const PlanElement *const e = &a->plan[k];
            const int chords = e->k0 == 0 && e->k1 == 0 ? 1 : CHORDS;
            for (int c = 0; c <= chords; ++c) {
                const PlanElement at = plan_at(e, e->length * c / chords);
                left_add(page, at.x, at.y);
            }
        }
        left_add(page, NAN, NAN);
    }
    for (size_t i = 0; i < marks; ++i) {
        page->mark_x[page->n_marks] = s->mark[i].at.x;
        page->mark_y[page->n_marks++] = s->mark[i].at.y;
    }
    return HAWSER_OK;
}

/* Errors: MEMORY. */
static hawser_status page_fill(const hawser_routes *r, int only, RoutePage *page, hawser_error *err)
{
    LinePick all = r->options.line;
    Survey whole = {0};
    hawser_status status = HAWSER_OK;
    const int most = only >= 0 ? 1 : r->survey.n < USED_AT_ONCE ? r->survey.n : USED_AT_ONCE;
    page->line = calloc((size_t)most + 1, sizeof *page->line);
    page->ignored = calloc((size_t)r->survey.n_ignored + 1, sizeof *page->ignored);
    if (!page->line || !page->ignored) return error_memory(err);
    for (; page->n < most && !status; page->n++)
        status = page_line(r, only >= 0 ? only : page->n, &page->line[page->n], err);
    for (; page->n_ignored < r->survey.n_ignored; page->n_ignored++)
        page->ignored[page->n_ignored] = r->survey.ignored[page->n_ignored].what;
    all.name = all.layer = NULL;
    const int chosen = r->options.line.name || r->options.line.layer;
    if (!status && chosen) status = lines_read(&all, &whole, err);
    if (!status) status = page_left(chosen ? &whole : &r->survey, page, err);
    survey_clear(&whole);
    return status;
}

static hawser_status page_save(const hawser_routes *r, int only, const char *path, hawser_error *err)
{
    RoutePage page = {.path = r->path, .unit = *r->survey.unit ? r->survey.unit : "m", .system = r->survey.system};
    Text text = {0};
    const locale_t plain = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (!plain) return error_memory(err);
    const locale_t before = uselocale(plain);
    hawser_status status = page_fill(r, only, &page, err);
    if (!status) route_page_write(&page, &text);
    if (!status && text.failed) status = error_memory(err);
    if (!status) status = out_file(path, text.at, text.size, err);
    uselocale(before);
    freelocale(plain);
    text_clear(&text);
    route_page_clear(&page);
    return status;
}

hawser_status hawser_routes_write(const hawser_routes *r, int i, const char *path, hawser_error *err)
{
    if (!r || !path) return error_argument(err, r ? "path" : "r");
    const int format = write_format(path);
    const Alignment *meant = NULL;
    RouteRow *row = NULL;
    const size_t size = strlen(path);
    const int page = size > 5 && !strcasecmp(path + size - 5, ".html");
    if (format < 0 && !page) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "%.300s: the ending says what is written: .csv, .dxf, .geojson, .yaml or .html", path);
    }
    FileMarks files = {0};
    hawser_status status = file_marks_add(&files, r->path, err);
    if (!status && r->profile) status = file_marks_add(&files, r->profile, err);
    if (!status) status = file_marks_spare(&files, path, err);
    file_marks_free(&files);
    if (status) return status;
    if (page && i < 0) return page_save(r, -1, path, err);
    status = i < 0 ? line_choose(&r->options.line, &r->survey, &meant, err) : HAWSER_OK;
    if (!status) status = row_good(r, i < 0 ? (int)(meant - r->survey.alignment) : i, &row, err);
    if (!status && page) return page_save(r, i, path, err);
    if (!status) status = alignment_write(&row->use->line.line, r->survey.system, (WriteFormat)format, path, err);
    return status;
}
