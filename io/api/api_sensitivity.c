/* Changes of the pulling calculation by small changes of its input: `hawser theory --sensitivities`. docs/theory.md,
 * "Changes of a pull". */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/error.h"
#include "hawser/hawser.h"
#include "io/api/api_handles.h"
#include "theory/plan.h"

/* A cause of change, in the unit of the case. */
typedef struct CauseRow {
    char name[96];
    const char *unit;
    double now;
    struct {
        double slope, share; /* N per unit; % of the force per 1 % of it */
    } way[PLAN_WAYS];
} CauseRow;

static const Column cause_column[] = {
    {COLUMN("name", CHARS, CauseRow, name), .label = "what"},
    {COLUMN("now", NUMBER, CauseRow, now), .label = "now", .decimals = -1, .unit_by = "unit"},
    {COLUMN("unit", TEXT, CauseRow, unit), .label = "unit"},
    {COLUMN("forward_N_per_unit", NUMBER, CauseRow, way[PLAN_FORWARD].slope), .label = "forward: N by an SI unit",
     .decimals = 2},
    {COLUMN("forward_share", NUMBER, CauseRow, way[PLAN_FORWARD].share), .label = "% for 1 % more", .decimals = 3},
    {COLUMN("backward_N_per_unit", NUMBER, CauseRow, way[PLAN_BACKWARD].slope), .label = "back: N by an SI unit",
     .decimals = 2},
    {COLUMN("backward_share", NUMBER, CauseRow, way[PLAN_BACKWARD].share), .label = "% for 1 % more", .decimals = 3},
};

/* A place along the route, pulled forward: changes of the tension, and of the support force. */
typedef struct PlaceRow {
    char name[96];
    double s, tension, reach;
    double tension_by[CHANGE_OTHERS], support_by[CHANGE_OTHERS];
} PlaceRow;

static const Column place_column[] = {
    {COLUMN("name", CHARS, PlaceRow, name), .label = "place"},
    {COLUMN("s_m", NUMBER, PlaceRow, s), .label = "s, m", .decimals = 2},
    {COLUMN("tension_N", NUMBER, PlaceRow, tension), .label = "tension, N", .decimals = 1},
    {COLUMN("winch_by_tension", NUMBER, PlaceRow, reach), .label = "winch by a newton here", .decimals = 4},
    {COLUMN("tension_by_start", NUMBER, PlaceRow, tension_by[CHANGE_START]), .label = "tension by start",
     .decimals = 4},
    {COLUMN("tension_by_friction_N", NUMBER, PlaceRow, tension_by[CHANGE_FRICTION]), .label = "by friction, N"},
    {COLUMN("tension_by_weight_m", NUMBER, PlaceRow, tension_by[CHANGE_WEIGHT]), .label = "by weight, m",
     .decimals = 3},
    {COLUMN("support_by_start_per_m", NUMBER, PlaceRow, support_by[CHANGE_START]), .label = "support by start, 1/m",
     .decimals = 5, .group = 1},
    {COLUMN("support_by_friction_N_per_m", NUMBER, PlaceRow, support_by[CHANGE_FRICTION]), .label = "by friction, N/m",
     .decimals = 1},
    {COLUMN("support_by_weight", NUMBER, PlaceRow, support_by[CHANGE_WEIGHT]), .label = "by weight", .decimals = 4},
};

typedef struct Changes {
    Setup setup;
    Expected expected;
    Calculator calculator;
    PlanChange way[PLAN_WAYS];
    int n, places;
    CauseRow *row;   /* [n] */
    PlaceRow *place; /* [places] */
} Changes;

static hawser_status changes_solve(const hawser_case *c, Changes *x, hawser_error *err)
{
    hawser_status status = setup_make(c->def, &x->setup, err);
    if (!status) status = expected_fill(&x->setup, 0, NULL, &x->expected, err);
    if (!status) status = calculator_build(&x->setup, &x->expected, 0, &x->calculator, err);
    const Calculator *const k = &x->calculator;
    for (int w = 0; w < PLAN_WAYS && !status; w++) status = plan_change(&k->def, &k->plan, w, &x->way[w], err);
    return status;
}

static void changes_free(Changes *x)
{
    for (int w = 0; w < PLAN_WAYS; w++) plan_change_free(&x->way[w]);
    calculator_free(&x->calculator);
    expected_free(&x->expected);
    setup_free(&x->setup);
    free(x->row);
    free(x->place);
}

/* Fills in name and value of cause k; 0: it does not deserve a row. */
static int cause_name(const Changes *x, int k, CauseRow *row)
{
    const Calculator *const c = &x->calculator;
    const int stretch = k - CHANGE_OTHERS, push = stretch - c->def.n_stretches;
    const int differ = c->mu_largest > c->mu_least;
    row->unit = k == CHANGE_WEIGHT ? "N/m" : k == CHANGE_START || push >= 0 ? "N" : "1";
    if (k == CHANGE_START) {
        snprintf(row->name, sizeof row->name, "tension at the start");
        row->now = c->plan.way[PLAN_FORWARD].start;
    } else if (k == CHANGE_FRICTION) {
        snprintf(row->name, sizeof row->name, "friction%s", differ ? ", all by the same" : "");
        row->now = differ ? NAN : c->mu_largest;
    } else if (k == CHANGE_WEIGHT) {
        snprintf(row->name, sizeof row->name, "weight along the route");
        row->now = x->setup.cable_weight;
    } else if (push < 0) {
        snprintf(row->name, sizeof row->name, "friction from %.4g m", fmax(0, c->def.stretch[stretch].from));
        row->now = c->def.stretch[stretch].mu;
        return differ;
    } else {
        snprintf(row->name, sizeof row->name, "push of %.80s", x->setup.pusher[push].name);
        row->now = c->push[PLAN_FORWARD][push].force;
    }
    return 1;
}

/* Returns the relative growth of the force with a cause; different frictions grow in proportion. */
static double share_of(const Changes *x, int way, int k, double now)
{
    const Calculator *const c = &x->calculator;
    const PlanChange *const d = &x->way[way];
    double sum = d->force[k] * now;
    if (k == CHANGE_FRICTION) {
        sum = 0;
        for (int j = 0; j < c->def.n_stretches; j++) sum += d->force[CHANGE_OTHERS + j] * c->def.stretch[j].mu;
    }
    return sum / c->plan.way[way].force;
}

static void causes_fill(Changes *x)
{
    for (int k = 0; k < x->way[PLAN_FORWARD].n; k++) {
        CauseRow *const row = &x->row[x->n];
        if (!cause_name(x, k, row)) continue;
        for (int w = 0; w < PLAN_WAYS; w++) {
            row->way[w].slope = x->way[w].force[k];
            row->way[w].share = share_of(x, w, k, row->now);
        }
        x->n++;
    }
}

static void place_fill(const Changes *x, const char *name, double s, double *tension, double *support, PlaceRow *row)
{
    snprintf(row->name, sizeof row->name, "%s", name);
    row->s = s;
    row->tension = pull_at(&x->calculator.plan.way[PLAN_FORWARD].pull, s).tension;
    plan_change_at(&x->way[PLAN_FORWARD], s, tension, support, &row->reach);
    for (int k = 0; k < CHANGE_OTHERS; k++) {
        row->tension_by[k] = tension[k];
        row->support_by[k] = support[k];
    }
}

/* Fills the case's stations, then the ends of the route's pieces. */
static hawser_status rows_fill(Changes *x, hawser_error *err)
{
    const SceneDef *const def = x->setup.def;
    const Route *const route = x->setup.route;
    const size_t n = (size_t)x->way[PLAN_FORWARD].n;
    double *const scratch = malloc(2 * n * sizeof *scratch);
    x->row = calloc(n, sizeof *x->row);
    x->place = calloc((size_t)(def->n_stations + route->n), sizeof *x->place);
    const hawser_status status = scratch && x->row && x->place ? HAWSER_OK : error_memory(err);
    for (int i = 0; i < def->n_stations && !status; i++)
        place_fill(x, def->stations[i].name, def->stations[i].s, scratch, scratch + n, &x->place[x->places++]);
    for (int p = 0; p < route->n && !status; p++) {
        char name[96];
        snprintf(name, sizeof name, "end of %.80s", route->piece[p].name);
        place_fill(x, name, route->piece[p].s0 + route->piece[p].length, scratch, scratch + n, &x->place[x->places++]);
    }
    if (!status) causes_fill(x);
    free(scratch);
    return status;
}

static hawser_status changes_write(const Changes *x, const char *title, hawser_format format, char **text,
                                   hawser_error *err)
{
    const PlanWay *const way = x->calculator.plan.way;
    const int one_sided = x->way[PLAN_FORWARD].one_sided || x->way[PLAN_BACKWARD].one_sided;
    char values[160];
    snprintf(values, sizeof values, "%s%s",
             one_sided ? "one-sided, where a machine takes just what arrives: for less tension there" : "two-sided",
             x->setup.n_pushers > 0 ? "; pushes are held as they are, also where they go by friction or tension" : "");
    const Fact fact[] = {
        {"forward_total_N", "winch force at the end, forward", "N", cell_number(way[PLAN_FORWARD].force)},
        {"backward_total_N", "winch force at the end, backward", "N", cell_number(way[PLAN_BACKWARD].force)},
        {"values", "values", "", cell_text(values)},
    };
    const Table table[] = {
        {"sensitivities", "What the winch's force changes by, the route full of cable, at speed",
         COLUMNS(CauseRow, cause_column), x->n, x->row},
        {"along", "What tension and the force on what carries the cable change by, pulled forward",
         COLUMNS(PlaceRow, place_column), x->places, x->place},
    };
    const Document doc = {.title = title,
                          .n_facts = sizeof fact / sizeof *fact,
                          .n_tables = sizeof table / sizeof *table,
                          .fact = fact,
                          .table = table,
                          .csv = &table[0]};
    return document_write(&doc, format, text, err);
}

hawser_status hawser_case_sensitivities(hawser_case *c, hawser_format format, char **text, hawser_error *err)
{
    if (!c || !text) return error_argument(err, c ? "text" : "c");
    *text = NULL;
    hawser_status status = case_ensure_read(c, err);
    if (!status) status = case_alone(c, "sensitivities", err);
    if (status) return status;
    if (c->def->rod.present)
        return error_set(err, HAWSER_ERR_INPUT, "%.200s: key 'rod': the pulling theory needs a route", c->name);
    Changes *const x = calloc(1, sizeof *x);
    status = x ? case_name_error(c, changes_solve(c, x, err), err) : error_memory(err);
    if (!status) status = rows_fill(x, err);
    if (!status) status = changes_write(x, c->def->title[0] ? c->def->title : c->name, format, text, err);
    if (x) changes_free(x);
    free(x);
    return status;
}
