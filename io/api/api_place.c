/* The list of equipment of a case for the people who set it up, written by `hawser theory --crew`. Loads are those of
 * theory with the cable at the route's end, docs/theory.md, "Placing". */
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "io/api/api_handles.h"
#include "io/case/case_parts.h"
#include "theory/calculator.h"
#include "theory/mend.h"
#include "theory/place.h"

static const Column crew_column[] = {
    {COLUMN("number", COUNT, Placed, number), .label = "no."},
    {COLUMN("kind", TEXT, Placed, kind), .label = "kind"},
    {COLUMN("name", CHARS, Placed, name), .label = "name"},
    {COLUMN("station_m", NUMBER, Placed, station), .label = "station, m", .decimals = 3},
    {COLUMN("x_m", NUMBER, Placed, at.x), .label = "x, m", .decimals = 3, .digits = 12},
    {COLUMN("y_m", NUMBER, Placed, at.y), .label = "y, m", .decimals = 3, .digits = 12},
    {COLUMN("z_m", NUMBER, Placed, at.z), .label = "z, m", .decimals = 3, .digits = 12},
    {COLUMN("tilt_deg", NUMBER, Placed, tilt), .label = "tilt, deg", .decimals = 1},
    {COLUMN("heading_deg", NUMBER, Placed, heading), .label = "heading, deg", .decimals = 1},
    {COLUMN("load_N", NUMBER, Placed, load), .label = "load, N", .decimals = 0},
    {COLUMN("rating_N", NUMBER, Placed, rating), .label = "rating, N", .decimals = 0},
    {COLUMN("margin_pct", NUMBER, Placed, margin), .label = "margin, %", .decimals = 1},
};

/* The list while it is made. */
typedef struct Crew {
    const Setup *setup;
    const Calculator *calculator;
    int way;
    int n;
    Placed *row;      /* [n] */
    Support *support; /* [rollers] in the order of their stations, as the rows */
} Crew;

/* rad; distance past its ends up to which the route is followed to rollers by coordinates, m. */
static const double DEGREE = 3.14159265358979323846 / 180, BEYOND = 10;

/* Returns a heading, deg; one that rounds to none is none. */
static double heading_of(double x, double y)
{
    const double angle = atan2(y, x) / DEGREE;
    return fabs(angle) < 1e-9 ? 0 : angle;
}

/* Adds the row of something that stands on the line itself. */
static Placed *line_row(Crew *c, const char *kind, const char *name, double s)
{
    const RoutePoint at = route_at(c->setup->route, s);
    Placed *const row = &c->row[c->n++];
    *row = (Placed){.kind = kind, .station = s, .tilt = NAN, .load = NAN, .rating = NAN, .margin = NAN};
    snprintf(row->name, sizeof row->name, "%.63s", name);
    row->at = v3_add(at.position, c->setup->def->route_origin);
    row->heading = heading_of(at.tangent.x, at.tangent.y);
    return row;
}

/* Returns the side of the line on which a roller stands: the frame's direction that is nearest to the direction from
 * its centre to the line at s. */
static PlaceSide side_of(const Route *route, const RollerDef *roller, double s)
{
    const RoutePoint at = route_at(route, s);
    const Vec3 left = route_left(route, s), up = v3_cross(at.tangent, left);
    const Vec3 away = v3_sub(at.position, roller->centre);
    const double rise = v3_dot(away, up), aside = v3_dot(away, left);
    if (fabs(rise) >= fabs(aside)) return rise >= 0 ? PLACE_BELOW : PLACE_ABOVE;
    return aside < 0 ? PLACE_LEFT : PLACE_RIGHT;
}

/* Adds the row of a roller with its load. The pull crosses level axes at a right angle, guides along the route. */
static void roller_row(Crew *c, const RollerDef *roller, const Support *support)
{
    static const char *const kinds[] = {"roller", "hold-down", "guide", "guide"};
    Placed *const row = line_row(c, kinds[support->side], roller->name, support->s);
    const RoutePoint at = route_at(c->setup->route, support->s);
    row->at = v3_add(roller->centre, c->setup->def->route_origin);
    row->tilt = asin(fmin(1, fabs(roller->axis.z))) / DEGREE;
    if (support->side == PLACE_BELOW || support->side == PLACE_ABOVE) {
        const double sign = roller->axis.y * at.tangent.x - roller->axis.x * at.tangent.y < 0 ? -1 : 1;
        row->heading = heading_of(sign * roller->axis.y, -sign * roller->axis.x);
    }
    row->load = support->load;
    if (!(roller->rating > 0)) return;
    row->rating = roller->rating;
    row->margin = 100 * (1 - row->load / roller->rating);
}

/* Finds the station of each roller; of those by coordinates the nearest place. Returns how many there are. */
static int rollers_find(const Crew *c, const RouteGrid *grid)
{
    const SceneDef *const def = c->setup->def;
    const Stretches *const stretches = &c->calculator->stretches;
    int n = 0;
    for (int i = 0; i < def->n_rollers; ++i) {
        const RollerDef *const roller = &def->rollers[i];
        if (roller->profile >= SHAPE_BOX) continue;
        const double s = isnan(roller->s) ? route_nearest(grid, roller->centre, 1).s : roller->s;
        const PlaceSide side = side_of(c->setup->route, roller, s);
        const int shared = stretch_at(stretches->n, stretches->stretch, s)->separate;
        c->support[n++] = (Support){.s = s, .side = side, .item = i, .whole = side == PLACE_BELOW && !shared};
    }
    return n;
}

static hawser_status rollers_list(Crew *c, hawser_error *err)
{
    const SceneDef *const def = c->setup->def;
    const PlaceLine line = {.route = c->setup->route,
                            .pull = &c->calculator->plan.way[c->way].pull,
                            .weight = c->setup->cable_weight,
                            .to = c->setup->route->length};
    RouteGrid grid = {0};
    const hawser_status status = route_grid_build(line.route, BEYOND, &grid, err);
    const int n = status ? 0 : rollers_find(c, &grid);
    support_loads(&line, n, c->support);
    for (int i = 0; i < n; ++i) roller_row(c, &def->rollers[c->support[i].item], &c->support[i]);
    route_grid_clear(&grid);
    return status;
}

/* Lists the other equipment: machines at their middles, winch and reel at the ends. */
static void others_list(Crew *c)
{
    const SceneDef *const def = c->setup->def;
    const PlanWay *const way = &c->calculator->plan.way[c->way];
    const double end = isnan(def->winch.at) ? c->setup->route->length : def->winch.at;
    if (def->reel.model != REEL_NONE) line_row(c, "reel", "reel", -def->reel.distance)->load = way->start;
    if (def->drum.present) line_row(c, "reel", "drum", -def->drum.distance)->load = way->start;
    for (int i = 0; i < def->n_conveyors; ++i) {
        const ConveyorDef *const m = &def->conveyors[i];
        Placed *const row = line_row(c, "conveyor", m->name, (m->from + m->to) / 2);
        row->load = 2 * m->mu * m->clamp;
        if (m->limit > 0) row->load = fmin(row->load, row->rating = m->limit);
    }
    for (int i = 0; i < def->theory.n_machines; ++i) {
        const TheoryPlaceDef *const m = &def->theory.machines[i];
        line_row(c, "machine", m->name, m->at)->load = m->force;
    }
    for (int i = 0; i < def->theory.n_pits; ++i) line_row(c, "pit", def->theory.pits[i].name, def->theory.pits[i].at);
    if (!def->winch.present) return;
    Placed *const row = line_row(c, "winch", "winch", end);
    row->load = way->force;
    if (!(def->limits.own[HAWSER_LIMIT_WINCH] > 0)) return;
    row->rating = def->limits.own[HAWSER_LIMIT_WINCH];
    row->margin = 100 * (1 - row->load / row->rating);
}

static int compare_rows(const void *a, const void *b)
{
    const Placed *const x = a, *const y = b;
    if (x->station != y->station) return x->station > y->station ? 1 : -1;
    return strcmp(x->name, y->name);
}

hawser_status equipment_find(const Setup *setup, const Calculator *calculator, int way, int *n, Placed **row,
                             hawser_error *err)
{
    const SceneDef *const def = setup->def;
    const size_t most = (size_t)(def->n_rollers + def->n_conveyors + def->theory.n_machines + def->theory.n_pits) + 3;
    Crew c = {.setup = setup, .calculator = calculator, .way = way};
    *row = c.row = calloc(most, sizeof *c.row);
    c.support = calloc((size_t)def->n_rollers + 1, sizeof *c.support);
    hawser_status status = c.row && c.support ? HAWSER_OK : error_memory(err);
    if (!status) status = rollers_list(&c, err);
    if (!status) others_list(&c);
    if (c.row) qsort(c.row, (size_t)c.n, sizeof *c.row, compare_rows);
    for (int i = 0; i < c.n; ++i) c.row[i].number = i + 1;
    *n = c.n;
    free(c.support);
    return status;
}

/* Makes the list from a setup that was built. */
static hawser_status list_make(const Setup *setup, const char *title, hawser_format format, char **text,
                               hawser_error *err)
{
    Expected expected = {0};
    Calculator calculator = {0};
    Placed *row = NULL;
    int n = 0;
    hawser_status status = expected_fill(setup, 0, NULL, &expected, err);
    if (!status) status = calculator_build(setup, &expected, 0, &calculator, err);
    if (!status) status = equipment_find(setup, &calculator, PLAN_FORWARD, &n, &row, err);
    const Table table = {"equipment", "Equipment along the route, loads by the pulling theory, pulled forward",
                         COLUMNS(Placed, crew_column), n, row};
    const Document doc = {.title = title, .n_tables = 1, .table = &table, .csv = &table};
    if (!status) status = document_write(&doc, format, text, err);
    calculator_free(&calculator);
    expected_free(&expected);
    free(row);
    return status;
}

hawser_status hawser_case_equipment(hawser_case *c, hawser_format format, char **text, hawser_error *err)
{
    if (!c || !text) return error_argument(err, c ? "text" : "c");
    *text = NULL;
    hawser_status status = case_ensure_read(c, err);
    if (!status) status = case_alone(c, "the crew's list", err);
    if (status) return status;
    if (c->def->rod.present)
        return error_set(err, HAWSER_ERR_INPUT, "%.200s: key 'rod': equipment stands along a route", c->name);
    Setup setup;
    status = setup_make(c->def, &setup, err);
    if (!status) status = list_make(&setup, c->def->title[0] ? c->def->title : c->name, format, text, err);
    setup_free(&setup);
    return case_name_error(c, status, err);
}

/* Places for machines or pits with which all limits hold, printed and written by `hawser place`.
 * docs/guide/equipment.md. */

/* (PN14) l/(m mm): lubricant for a metre of duct and a millimetre of its inside diameter, a film of 0.2 mm (American
 * Polywater, Technical Talk, volume XVII). */
static const double LUBRICANT = 0.00073;

/* The pull with one friction and one kind of help, by theory of the whole case. */
typedef struct PlaceRow {
    const char *friction;               /* "as given", "dry", "lubricated" */
    double mu;                          /* coefficient of the ducts; NAN: the case's */
    const char *help;                   /* "nothing", "machines", "pits" */
    double count;                       /* NAN: no number of them keeps the limits */
    char at[12 * INVERSE_MACHINES_MAX]; /* their places */
    double force;                       /* N, largest force of the winch; NAN: nothing is proposed */
    hawser_word word;
    const char *code; /* code of the word; "-": nothing is proposed */
    char verdict[HAWSER_VERDICT_MAX];
    int n;
    char *row[INVERSE_MACHINES_MAX]; /* [n] items of its list; owned */
} PlaceRow;

static const Column place_column[] = {
    {COLUMN("friction", TEXT, PlaceRow, friction), .label = "friction"},
    {COLUMN("mu", NUMBER, PlaceRow, mu), .label = "of ducts", .decimals = 2},
    {COLUMN("with", TEXT, PlaceRow, help), .label = "with"},
    {COLUMN("count", NUMBER, PlaceRow, count), .label = "number", .decimals = 0},
    {COLUMN("force_N", NUMBER, PlaceRow, force), .label = "winch, N", .decimals = 0},
    {COLUMN("verdict_code", TEXT, PlaceRow, code), .label = "verdict"},
    {COLUMN("at", CHARS, PlaceRow, at), .label = "at"},
};

enum { VARIANTS = 3, HELPS = 3, ROWS_MAX = VARIANTS * HELPS };

static const char *const help_names[HELPS] = {"nothing", "machines", "pits"};

typedef struct Placing {
    const hawser_place_options *options;
    hawser_case *variant[VARIANTS]; /* as given; dry and lubricated, or NULL */
    int n;
    PlaceRow row[ROWS_MAX];
    const PlaceRow *best;
    char title[256], answer[HAWSER_ANSWER_MAX];
    double lubricant; /* m3 */
    hawser_error *err;
} Placing;

/* ------------------------------------------------------------------------------------------- dry and lubricated */

static int is_duct(const SurfaceDef *s) { return s->shape.kind == SURFACE_DUCT; }

/* Returns the length of a duct that lies along the route, m. */
static double length_along(const SurfaceDef *duct, double route)
{
    return fmax(0, fmin(duct->shape.to, route) - fmax(duct->shape.from, 0));
}

/* Returns the volume by (PN14), m3. */
static double lubricant_of(const Setup *setup)
{
    double litres = 0;
    for (int i = 0; i < setup->def->n_surfaces; ++i) {
        const SurfaceDef *const s = &setup->def->surfaces[i];
        const double bore = s->bore > 0 ? s->bore : s->shape.radius;
        if (is_duct(s)) litres += LUBRICANT * length_along(s, setup->route->length) * 2 * bore * 1000;
    }
    return litres / 1000;
}

/* Makes the case with the catalogue's friction of that name and state in all ducts. */
static hawser_status variant_make(Placing *p, const hawser_case *c, const char *state, hawser_case **out)
{
    char key[64], value[160];
    hawser_status status = hawser_case_copy(c, out, p->err);
    snprintf(value, sizeof value, "{type: %.100s/%s}", p->options->lubricant, state);
    for (int i = 0, duct = 0; i < c->def->n_surfaces && !status; ++i) {
        if (!is_duct(&c->def->surfaces[i])) continue;
        snprintf(key, sizeof key, "surfaces.ducts.%d.friction", duct++);
        status = hawser_case_set(*out, key, value, p->err);
    }
    return status ? status : case_ensure_read(*out, p->err);
}

static hawser_status variants_make(Placing *p, const hawser_case *c)
{
    int ducts = 0;
    hawser_status status = hawser_case_copy(c, &p->variant[0], p->err);
    if (status || !p->options->lubricant) return status;
    for (int i = 0; i < c->def->n_surfaces; ++i) ducts += is_duct(&c->def->surfaces[i]);
    if (ducts == 0) return error_set(p->err, HAWSER_ERR_INPUT, "dry and lubricated are of ducts: the case has none");
    if (c->def->theory.n_friction > 0)
        return error_set(p->err, HAWSER_ERR_INPUT,
                         "key 'theory.stretches' gives the friction already: dry and lubricated need a case "
                         "without it");
    status = variant_make(p, c, "dry", &p->variant[1]);
    return status ? status : variant_make(p, c, "lubricated", &p->variant[2]);
}

static double ducts_mu(const SceneDef *def)
{
    double mu = NAN;
    for (int i = 0; i < def->n_surfaces; ++i)
        if (is_duct(&def->surfaces[i])) mu = fmax(mu, def->surfaces[i].friction.mu_d);
    return mu;
}

/* ------------------------------------------------------------------------------------------------- the proposals */

/* Makes an item of the list `theory.machines` or `theory.pits`. */
static char *item_of(int pits, double at, double force)
{
    char text[96];
    snprintf(text, sizeof text, "{at: %.10g m, %s: %.6g N}", at, pits ? "back" : "push", force);
    return strdup(text);
}

/* Sets the list to the case's own items, as JSON without its brackets, and those of the row. */
static hawser_status list_set(Placing *p, hawser_case *c, const char *key, const PlaceRow *row)
{
    char *old = NULL;
    size_t size = 8;
    hawser_error none;
    if (hawser_case_get(c, key, &old, &none)) old = NULL;
    size += old ? strlen(old) : 0;
    for (int i = 0; i < row->n; ++i) size += strlen(row->row[i]) + 2;
    char *const text = malloc(size), *at = text;
    if (!text) {
        hawser_text_free(old);
        return error_memory(p->err);
    }
    *at++ = '[';
    const char *const close = old ? strrchr(old, ']') : NULL;
    const size_t inside = close ? (size_t)(close - old) - 1 : 0;
    if (inside) memcpy(at, old + 1, inside);
    at += inside;
    for (int i = 0; i < row->n; ++i) at += sprintf(at, "%s%s", i || inside ? ", " : "", row->row[i]);
    strcpy(at, "]");
    const hawser_status status = hawser_case_set(c, key, text, p->err);
    free(text);
    hawser_text_free(old);
    return status;
}

/* Judges a row by the theory of the whole case. */
static hawser_status row_judge(Placing *p, hawser_case *c, PlaceRow *row)
{
    static const char *const tables[] = {"limits", NULL};
    const TheoryWish wish = {.table = tables};
    json_t *found = NULL;
    const hawser_status status = case_theory_values(c, &wish, &found, p->err);
    if (status) return status;
    row->force = fmax(json_number_value(json_object_get(found, "largest_force_N")),
                      json_number_value(json_object_get(found, "largest_restart_N")));
    const char *const said = json_string_value(json_object_get(found, "verdict_forward"));
    snprintf(row->verdict, sizeof row->verdict, "%s", said ? said : "");
    row->word = hawser_word_of(row->verdict);
    row->code = hawser_word_code(row->word);
    json_decref(found);
    return HAWSER_OK;
}

static hawser_status row_place(Placing *p, const hawser_case *variant, const Solved *solved, int help, PlaceRow *row)
{
    const int pits = help == 2;
    const double force = pits ? solved->c.plan.way[PLAN_FORWARD].start : variant->def->theory.machine_push;
    InverseMachines found;
    hawser_case *c = NULL;
    hawser_status status = inverse_place(&solved->setup, &solved->c, PLAN_FORWARD, pits, force, &found, p->err);
    row->count = found.n < 0 ? NAN : (double)found.n;
    if (status || found.n <= 0) return status;
    size_t used = 0;
    for (int i = 0; i < found.n && !status; ++i) {
        const double at = pits ? found.at[i] : round(found.at[i] * 1e3) / 1e3;
        row->row[row->n++] = item_of(pits, at, force);
        if (!row->row[i]) status = error_memory(p->err);
        if (used < sizeof row->at)
            used += (size_t)snprintf(row->at + used, sizeof row->at - used, "%s%.1f m", i ? ", " : "", at);
    }
    if (!status) status = hawser_case_copy(variant, &c, p->err);
    if (!status) status = list_set(p, c, pits ? "theory.pits" : "theory.machines", row);
    if (!status) status = row_judge(p, c, row);
    hawser_case_free(c);
    return status;
}

/* Makes the rows of one friction: without help, and with the machines or pits that are needed. */
static hawser_status variant_place(Placing *p, int k)
{
    static const char *const names[VARIANTS] = {"as given", "dry", "lubricated"};
    hawser_case *const c = p->variant[k];
    static const Company alone;
    SceneDef own;
    Solved solved = {0};
    hawser_status status = case_ensure_read(c, p->err);
    if (!status) status = scene_def_copy(c->def, &own, p->err);
    if (!status) status = solved_make(&own, &alone, 0, &solved, p->err);
    if (!status && solved.c.n_limits == 0)
        status =
            error_set(p->err, HAWSER_ERR_INPUT, "key 'limits': it is missing, and without limits nothing is needed");
    if (!status && k == 0) p->lubricant = lubricant_of(&solved.setup);
    for (int help = 0; help < HELPS && !status; ++help) {
        if (help == 1 && (isnan(c->def->theory.machine_push) || p->options->only == HAWSER_PLACE_PITS)) continue;
        if (help == 2 && p->options->only == HAWSER_PLACE_MACHINES) continue;
        PlaceRow *const row = &p->row[p->n++];
        *row = (PlaceRow){
            .friction = names[k], .mu = ducts_mu(c->def), .help = help_names[help], .force = NAN, .code = "-"};
        row->count = help ? NAN : 0;
        status = help ? row_place(p, c, &solved, help, row) : row_judge(p, c, row);
        if (help && !status && row->count == 0) --p->n; /* nothing is needed */
    }
    solved_free(&solved);
    return status;
}

/* ------------------------------------------------------------------------------------------------------ answer */

/* Chooses the best row of the friction as given: SAFE before SAFE ONLY IF, then the fewest. */
static void best_choose(Placing *p)
{
    for (int i = 0; i < p->n && p->row[i].friction == p->row->friction; ++i) {
        const PlaceRow *const row = &p->row[i], *const best = p->best;
        const int safe = row->word == HAWSER_SAFE, was = best && best->word == HAWSER_SAFE;
        if (isnan(row->force) || (!safe && row->word != HAWSER_SAFE_ONLY_IF)) continue;
        if (!best || safe > was || (safe == was && row->count < best->count)) p->best = row;
    }
}

static void answer_make(Placing *p, hawser_units units)
{
    Answer a = {p->answer, sizeof p->answer, 0, units, TERMINAL_WIDTH, 0};
    const PlaceRow *const best = p->best;
    char litres[HAWSER_SHOWN_MAX];
    if (!best) answer_line(&a, "proposal", "none: nothing that was tried keeps all limits (hawser theory says which)");
    if (best == p->row) answer_line(&a, "proposal", "nothing is needed");
    if (best && best != p->row)
        answer_line(&a, "proposal", "%.0f %.*s at %s", best->count, (int)strlen(best->help) - (best->count == 1),
                    best->help, best->at);
    answer_line(&a, "then", "%s", best ? best->verdict : p->row->verdict);
    if (p->lubricant > 0)
        answer_line(&a, "lubricant",
                    "%s l for the ducts: a film of 0.2 mm (American Polywater, Technical Talk XVII); more for bends",
                    say_digits(p->lubricant * 1000, 2, litres));
}

static hawser_status page_write(const Placing *p, hawser_format format, char **text)
{
    const PlaceRow *const best = p->best;
    const Fact fact[] = {{"format", NULL, "", cell_number(RESULTS_FORMAT)},
                         {"verdict_code", NULL, "", cell_text(p->row->code)},
                         {"proposed", NULL, "", cell_text(!best ? "" : best->help)},
                         {"proposed_count", NULL, "", cell_number(best ? best->count : NAN)},
                         {"proposed_verdict_code", NULL, "", cell_text(best ? best->code : "")},
                         {"lubricant_m3", NULL, "", cell_number(p->lubricant)}};
    const Table table = {"proposals", "With machines and pits, the fewest that keep all limits",
                         COLUMNS(PlaceRow, place_column), p->n, p->row};
    const Document doc = {.title = p->title,
                          .answer = p->answer,
                          .n_facts = sizeof fact / sizeof *fact,
                          .fact = fact,
                          .n_tables = 1,
                          .table = &table,
                          .csv = &table};
    return document_write(&doc, format, text, p->err);
}

static int steps_of(const hawser_case *c) { return c->def->theory.n_machines + c->def->theory.n_pits; }

/* Writes the case's text with the best proposal, after reading it again and checking its number of machines and pits.
 */
static hawser_status case_write(Placing *p, const hawser_case *c)
{
    char *old = NULL, *text = NULL;
    size_t size;
    hawser_case *again = NULL;
    const char *const list = p->best ? p->best->help : "";
    if (!p->best)
        return error_set(p->err, HAWSER_ERR_INPUT, "nothing that was tried keeps all limits: nothing is written");
    if (!c->tree->path) return error_set(p->err, HAWSER_ERR_INPUT, "it is no file");
    hawser_status status = case_file_read(c->tree->path, &old, &size, p->err);
    if (!status && p->best->n > 0)
        status = case_theory_insert(old, c->name, list, p->best->n, p->best->row, &text, p->err);
    if (!status && text) status = hawser_case_parse(text, c->name, &again, p->err);
    if (!status && text && c->tree->folder) status = hawser_case_folder(again, c->tree->folder, p->err);
    if (!status && text) status = case_ensure_read(again, p->err);
    if (!status && text && steps_of(again) != steps_of(c) + p->best->n)
        status = error_set(p->err, HAWSER_ERR_INPUT,
                           "key 'theory.%s': it is not the file's own list, nothing is written", list);
    if (!status) status = out_file(p->options->to, text ? text : old, strlen(text ? text : old), p->err);
    hawser_case_free(again);
    free(old);
    free(text);
    return status;
}

hawser_status hawser_case_place(hawser_case *c, const hawser_place_options *options, hawser_format format, char **text,
                                hawser_word *word, hawser_error *err)
{
    const hawser_place_options plain = {0};
    if (!c || !text) return error_argument(err, c ? "text" : "c");
    *text = NULL;
    hawser_status status = case_ensure_read(c, err);
    if (!status) status = case_alone(c, "where machines go", err);
    if (status) return status;
    if (c->def->rod.present)
        return error_set(err, HAWSER_ERR_INPUT, "%.200s: key 'rod': machines stand along a route", c->name);
    Placing *const p = calloc(1, sizeof *p);
    if (!p) return error_memory(err);
    p->options = options ? options : &plain;
    p->err = err;
    snprintf(p->title, sizeof p->title, "%s", c->def->title[0] ? c->def->title : c->name);
    status = variants_make(p, c);
    for (int k = 0; k < VARIANTS && p->variant[k] && !status; ++k) status = variant_place(p, k);
    if (!status) best_choose(p);
    if (!status) answer_make(p, format == HAWSER_TABLE_US ? HAWSER_US : HAWSER_SI);
    if (!status && p->options->to) status = case_write(p, c);
    if (!status) status = page_write(p, format, text);
    if (!status && word) *word = p->best ? p->best->word : HAWSER_NOT_SAFE;
    for (int k = 0; k < VARIANTS; ++k) hawser_case_free(p->variant[k]);
    for (int i = 0; i < ROWS_MAX; ++i)
        for (int k = 0; k < INVERSE_MACHINES_MAX; ++k) free(p->row[i].row[k]);
    free(p);
    return case_name_error(c, status, err);
}
