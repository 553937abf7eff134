/* The closed-form calculation of a case: what `hawser theory` prints. The formulas are in theory/. */
#include "core/base/error.h"
#include "io/api/api_handles.h"
#include "sim/expected/expected.h"
#include "theory/paper.h"
#include "theory/pulling.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A place of the table: a station of the case or an end of a piece of the route. NAN: there is no cable. */
typedef struct Place {
    char name[96];
    double s, slope;                           /* m, deg */
    double paper, reference, normal, sidewall; /* N, N, N/m, N/m */
} Place;

static const Column place_column[] = {
    {COLUMN("name", CHARS, Place, name), .label = "place"},
    {COLUMN("s_m", NUMBER, Place, s), .label = "s, m", .decimals = 3},
    {COLUMN("slope_deg", NUMBER, Place, slope), .label = "slope, deg", .decimals = 2},
    {COLUMN("paper_N", NUMBER, Place, paper), .label = "paper, N", .decimals = 2},
    {COLUMN("reference_N", NUMBER, Place, reference), .label = "reference, N", .decimals = 2},
    {COLUMN("normal_N_per_m", NUMBER, Place, normal), .label = "support, N/m", .decimals = 1},
    {COLUMN("sidewall_N_per_m", NUMBER, Place, sidewall), .label = "sidewall, N/m", .decimals = 1},
};

/* A term of the paper's sum. */
typedef struct Term {
    const char *name;
    double force; /* N */
} Term;

static const Column term_column[] = {
    {COLUMN("name", TEXT, Term, name), .label = "term"},
    {COLUMN("force_N", NUMBER, Term, force), .label = "N", .decimals = 2},
};

typedef struct Theory {
    Scene scene;
    int built; /* the scene is */
    Expected expected;
    Pull pull;             /* the reference theory's */
    int n;                 /* places */
    Place *place;          /* [n] */
    hawser_station *value; /* [n] */
    Calculator calculator;
    TheoryTables tables;
    char verdict[PLAN_WAYS][HAWSER_VERDICT_MAX];
    char answer[HAWSER_ANSWER_MAX];
    Term *term; /* [n_paper] */
} Theory;

/* By place; places that coincide keep no particular order. */
static int compare_places(const void *a, const void *b)
{
    const double x = ((const Place *)a)->s, y = ((const Place *)b)->s;
    return (x > y) - (x < y);
}

/* The stations and the piece ends in order; an end where a station lies is left out. */
static void collect_places(Theory *t)
{
    const SceneDef *def = &t->scene.def;
    const Route *route = &t->scene.route;
    for (int i = 0; i < def->n_stations; i++, t->n++) {
        snprintf(t->place[t->n].name, sizeof t->place->name, "%s", def->stations[i].name);
        t->place[t->n].s = def->stations[i].s;
    }
    for (int p = 0; p <= route->n; p++) {
        const double s = p < route->n ? route->piece[p].s0 : route->length;
        int there = 0;
        for (int i = 0; i < def->n_stations; i++) there |= fabs(def->stations[i].s - s) < 1e-6;
        if (there) continue;
        snprintf(t->place[t->n].name, sizeof t->place->name, "%s of %s", p < route->n ? "start" : "end",
                 route->piece[p < route->n ? p : p - 1].name);
        t->place[t->n++].s = s;
    }
    qsort(t->place, (size_t)t->n, sizeof *t->place, compare_places);
}

/* Sized for all stations and all piece ends. */
static hawser_status make_arrays(Theory *t, hawser_error *err)
{
    const size_t places = (size_t)(t->scene.def.n_stations + t->scene.route.n + 1);
    t->place = calloc(places, sizeof *t->place);
    t->value = calloc(places, sizeof *t->value);
    t->term = calloc((size_t)t->scene.def.n_paper + 1, sizeof *t->term);
    return t->place && t->value && t->term ? HAWSER_OK : error_memory(err);
}

/* Both theories at every place. */
static hawser_status solve(Theory *t, hawser_error *err)
{
    hawser_status status = make_arrays(t, err);
    if (status) return status;
    collect_places(t);
    for (int i = 0; i < t->n; i++) {
        t->value[i].name = t->place[i].name;
        t->value[i].s = t->place[i].s;
    }
    status = expected_fill(&t->scene, t->n, t->value, &t->expected, err);
    /* the pull that the reference totals come from, for the sidewall pressure */
    if (!status) status = expected_pull(&t->scene, &t->expected, PULL_REFERENCE, &t->pull, err);
    if (!status) status = calculator_build(&t->scene, t->expected.start_tension, &t->calculator, err);
    return status ? status : theory_tables_make(&t->scene, &t->calculator, &t->tables, err);
}

/* Off the counted stretch there is no cable, so no force: those cells stay empty. */
static void fill_places(Theory *t)
{
    for (int i = 0; i < t->n; i++) {
        const hawser_station *v = &t->value[i];
        const int on = isfinite(v->reference_N);
        const PullPoint at = pull_at(&t->pull, v->s);
        Place *const row = &t->place[i];
        row->slope = route_slope(&t->scene.route, v->s) * 180 / M_PI;
        row->paper = v->paper_N;
        row->reference = v->reference_N;
        row->normal = on ? at.normal : NAN;
        row->sidewall = on ? at.sidewall : NAN;
    }
}

/* The terms of eq. 10 one by one, as the case names them. */
static void fill_terms(Theory *t)
{
    const SceneDef *def = &t->scene.def;
    const double g = v3_norm(def->gravity), W = g > 0 ? t->scene.cable_weight / g : 0;
    for (int i = 0; i < def->n_paper; i++) {
        t->term[i] = (Term){def->paper[i].name, paper_term_force(&def->paper[i], W, def->friction.mu_d, g)};
    }
}

/* Facts first, the tension along the route, then the paper's own terms if the case lists them. */
static hawser_status write_theory(Theory *t, const char *title, hawser_format format, char **text, hawser_error *err)
{
    const SceneDef *def = &t->scene.def;
    const Expected *e = &t->expected;
    const Calculator *c = &t->calculator;
    fill_places(t);
    fill_terms(t);
    for (int k = 0; k < PLAN_WAYS; k++) {
        hawser_verdict(1, &c->pulled[k], c->n_limits, c->limit[k], t->verdict[k], sizeof t->verdict[k]);
    }
    Answer answer = {t->answer, sizeof t->answer, 0, format == HAWSER_TABLE_US ? HAWSER_US : HAWSER_SI};
    answer_theory(&answer, &t->scene, c, t->verdict);
    const Fact facts[] = {
        {"weight_N_per_m", "weight of the cable", "N/m", cell_number(t->scene.cable_weight)},
        {"friction", "friction coefficient", "", cell_number(def->friction.mu_d)},
        {"from_m", "counted from", "m along the route", cell_number(e->from)},
        {"to_m", "to", "m along the route", cell_number(e->to)},
        {"start_tension_N", "tension there at the start", "N", cell_number(e->start_tension)},
        {"rope_drag_N", "drag on the rope", "N", cell_number(def->drag.force)},
        {"paper_total_N", "winch force, paper's formulas", "N", cell_number(e->paper_total)},
        {"reference_total_N", "winch force, reference", "N", cell_number(e->reference_total)},
        {"max_sidewall_N_per_m", "largest sidewall pressure", "N/m", cell_number(t->pull.max_sidewall)},
        {"cables", "cables pulled together", "", cell_number(c->cables)},
        {"better_direction", "less force when pulled", "", cell_text(c->plan.better ? "backward" : "forward")},
        {"verdict_forward", NULL, "", cell_text(t->verdict[PLAN_FORWARD])},
        {"verdict_backward", NULL, "", cell_text(t->verdict[PLAN_BACKWARD])},
    };
    Table tables[2 + THEORY_TABLES_MAX] = {
        {"stations", "Tension along the route", COLUMNS(Place, place_column), t->n, t->place},
        {"terms", "Terms of the paper's sum", COLUMNS(Term, term_column), def->n_paper, t->term},
    };
    const int own = def->n_paper ? 2 : 1;
    for (int i = 0; i < t->tables.n; i++) tables[own + i] = t->tables.table[i];
    const Document doc = {.title = title,
                          .n_facts = sizeof facts / sizeof *facts,
                          .n_tables = own + t->tables.n,
                          .fact = facts,
                          .table = tables,
                          .csv = &tables[own + THEORY_PIECES],
                          .answer = t->answer};
    return document_write(&doc, format, text, err);
}

/* Everything from a definition that was read; the theory's memory is the caller's to free. */
static hawser_status build_and_solve(Theory *t, const hawser_case *c, hawser_error *err)
{
    hawser_status status = scene_build(&c->def, &t->scene, err);
    if (status) return status;
    t->built = 1;
    return solve(t, err);
}

/* Also for a theory that was never finished. */
static void theory_free(Theory *t)
{
    pull_clear(&t->pull);
    theory_tables_free(&t->tables);
    calculator_free(&t->calculator);
    expected_free(&t->expected);
    if (t->built) scene_clear(&t->scene);
    free(t->place);
    free(t->value);
    free(t->term);
    free(t);
}

/* No simulation is built: this takes milliseconds even for a long route. */
hawser_status hawser_case_theory(hawser_case *c, hawser_format format, char **text, hawser_error *err)
{
    *text = NULL;
    hawser_status status = case_ensure_read(c, err);
    if (status) return status;
    if (c->def.rod.present) {
        return error_set(err, HAWSER_ERR_INPUT, "%.200s: key 'rod': the pulling theory needs a route", c->name);
    }
    Theory *t = calloc(1, sizeof *t);
    if (!t) return error_memory(err);
    status = case_name_error(c, build_and_solve(t, c, err), err);
    if (!status) status = write_theory(t, c->def.title[0] ? c->def.title : c->name, format, text, err);
    theory_free(t);
    return status;
}
