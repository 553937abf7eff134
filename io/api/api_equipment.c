/* The list of equipment of a case for the people who set it up: what `hawser theory --crew` writes. Loads are those of
 * the pulling theory with the cable at the route's end, docs/model.md, "Placing". */
#include "core/base/error.h"
#include "io/api/api_handles.h"
#include "theory/calculator.h"
#include "theory/place.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
    Support *support; /* [rollers] in the order of their stations, as rows will be */
} Crew;

/* rad; how far past its ends the route is followed to rollers by coordinates, m. */
static const double DEGREE = 3.14159265358979323846 / 180, BEYOND = 10;

/* A heading, deg; what rounding leaves of none is none. */
static double heading_of(double x, double y)
{
    const double angle = atan2(y, x) / DEGREE;
    return fabs(angle) < 1e-9 ? 0 : angle;
}

/* The row of something that stands on the line itself. */
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

/* On which side of the line a roller stands: of the frame's four directions that which is nearest to the way from its
 * centre to the line at s. */
static PlaceSide side_of(const Route *route, const RollerDef *roller, double s)
{
    const RoutePoint at = route_at(route, s);
    const Vec3 left = route_left(route, s), up = v3_cross(at.tangent, left);
    const Vec3 away = v3_sub(at.position, roller->centre);
    const double rise = v3_dot(away, up), aside = v3_dot(away, left);
    if (fabs(rise) >= fabs(aside)) return rise >= 0 ? PLACE_BELOW : PLACE_ABOVE;
    return aside < 0 ? PLACE_LEFT : PLACE_RIGHT;
}

/* One of the rollers with what it bears. The pull crosses level axes square, guides along the route. */
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

/* Where each roller stands; those by coordinates at the nearest place. Returns how many there are. */
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

/* What is no roller: at the middle of machines, at the ends winch and reel. */
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

/* Everything from a setup that was built. */
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
