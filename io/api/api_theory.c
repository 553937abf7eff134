/* The closed-form calculation of a case, printed by `hawser theory`. The formulas are in theory/. */
#include "core/error.h"
#include "io/api/api_handles.h"
#include "theory/closed_form.h"
#include "theory/conditions.h"
#include "theory/expected.h"
#include "theory/mend.h"
#include "theory/plan.h"

#include "io/report/calculation.h"
#include <assert.h>
#include <jansson.h>
#include <locale.h>
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

/* Reference of a run of the case: the stretch of cable in the middle of its steady window. */
typedef struct RunRow {
    double from, to, start, paper, reference; /* m, m, N, N, N */
} RunRow;

static const Column run_column[] = {
    {COLUMN("from_m", NUMBER, RunRow, from), .label = "counted from, m", .decimals = 3},
    {COLUMN("to_m", NUMBER, RunRow, to), .label = "to, m", .decimals = 3},
    {COLUMN("start_tension_N", NUMBER, RunRow, start), .label = "start, N", .decimals = 2},
    {COLUMN("paper_total_N", NUMBER, RunRow, paper), .label = "winch, paper, N", .decimals = 2},
    {COLUMN("reference_total_N", NUMBER, RunRow, reference), .label = "winch, reference, N", .decimals = 2},
};

typedef struct Theory {
    SceneDef def;           /* for one of several chains: its own, which borrows from the case's, */
    TheoryPlaceDef *places; /* its machines and pits, owned, */
    double *rollers;        /* and the loads of others on rollers, owned */
    Setup setup;
    Expected expected;
    double paper_total; /* N, for the whole route */
    Pull paper;         /* without capstan effect */
    int n;              /* places */
    Place *place;       /* [n] */
    Calculator calculator;
    Inverse inverse;
    TheoryTables tables;
    TheoryVerdict verdict[PLAN_WAYS];
    char answer[HAWSER_ANSWER_MAX];
    Term *term; /* [n_paper] */
} Theory;

/* Compares by place; places that coincide have no particular order. */
static int compare_places(const void *a, const void *b)
{
    const double x = ((const Place *)a)->s, y = ((const Place *)b)->s;
    return (x > y) - (x < y);
}

/* Collects the stations and the piece ends in order; an end at a station is omitted. */
static void collect_places(Theory *t)
{
    const SceneDef *def = t->setup.def;
    const Route *route = t->setup.route;
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

/* Allocates for all stations and all piece ends. */
static hawser_status make_arrays(Theory *t, hawser_error *err)
{
    const size_t places = (size_t)(t->setup.def->n_stations + t->setup.route->n + 1);
    t->place = calloc(places, sizeof *t->place);
    t->term = calloc((size_t)t->setup.def->n_paper + 1, sizeof *t->term);
    return t->place && t->term ? HAWSER_OK : error_memory(err);
}

/* Solves the paper's theory of the whole route: its own formulas if the case lists them, otherwise the law without
 * capstan effect along the route. */
static hawser_status solve_paper(Theory *t, hawser_error *err)
{
    const SceneDef *def = t->setup.def;
    const PlanPullDef whole = {.way = PLAN_FORWARD, .whole = 1};
    PlanDef plan = t->calculator.def;
    plan.law = PULL_NO_CAPSTAN;
    const hawser_status status = plan_pull(&plan, &whole, &t->paper, err);
    if (status) return status;
    t->paper_total = t->paper.end_tension + t->calculator.plan.way[PLAN_FORWARD].rope;
    const double g = v3_norm(def->gravity);
    if (def->n_paper > 0) {
        t->paper_total = paper_total(def->n_paper, def->paper, t->setup.cable_weight / g, def->friction.mu_d, g);
    }
    return HAWSER_OK;
}

/* Solves for the run's stretch and for the whole route, full of cable and pulled forward. */
static hawser_status solve(Theory *t, const TheoryWish *wish, hawser_error *err)
{
    hawser_status status = make_arrays(t, err);
    if (status) return status;
    collect_places(t);
    status = expected_fill(&t->setup, 0, NULL, &t->expected, err);
    if (!status) {
        status = calculator_build(&t->setup, &t->expected, wish->forward_only, &t->calculator, err);
    }
    if (!status) status = solve_paper(t, err);
    if (!status && !wish->no_inverse) status = inverse_find(&t->setup, &t->calculator, &t->inverse, err);
    hawser_limit *const limit[PLAN_WAYS] = {t->calculator.limit[PLAN_FORWARD], t->calculator.limit[PLAN_BACKWARD]};
    if (!status)
        status = assumed_judge(&t->setup, &t->calculator, wish->forward_only ? 1 : PLAN_WAYS, !wish->no_inverse,
                               t->calculator.n_limits, limit, err);
    if (status) return status;
    if (wish->forward_only) return theory_limits_add(&t->calculator, 1, &t->tables) ? HAWSER_OK : error_memory(err);
    return theory_tables_make(&t->setup, &t->calculator, &t->inverse, &t->tables, err);
}

/* Fills the places of the whole route full of cable, pulled forward. */
static void fill_places(Theory *t)
{
    const SceneDef *def = t->setup.def;
    const double g = v3_norm(def->gravity), W = g > 0 ? t->setup.cable_weight / g : 0;
    for (int i = 0; i < t->n; i++) {
        Place *const row = &t->place[i];
        const PullPoint at = pull_at(&t->calculator.plan.way[PLAN_FORWARD].pull, row->s);
        row->slope = route_slope(t->setup.route, row->s) * 180 / M_PI;
        row->reference = at.tension;
        row->normal = at.normal;
        row->sidewall = at.sidewall;
        row->paper = def->n_paper > 0 ? paper_tension(def->n_paper, def->paper, W, def->friction.mu_d, g, row->s)
                                      : pull_at(&t->paper, row->s).tension;
    }
}

/* Thins out a long list of places for readers: those without a name keep every n-th only. */
static void few_places(Theory *t)
{
    enum { MANY = 40 };
    const int every = 1 + t->n / MANY;
    int kept = 0;
    for (int i = 0, plain = 0; i < t->n; i++) {
        char metres[32];
        snprintf(metres, sizeof metres, "%g m", t->place[i].s);
        const int named = strcmp(metres, t->place[i].name) != 0;
        if (named || plain++ % every == 0) t->place[kept++] = t->place[i];
    }
    t->n = kept;
}

/* Fills the terms of eq. 10 one by one, with the case's names. */
static void fill_terms(Theory *t)
{
    const SceneDef *def = t->setup.def;
    const double g = v3_norm(def->gravity), W = g > 0 ? t->setup.cable_weight / g : 0;
    for (int i = 0; i < def->n_paper; i++) {
        t->term[i] = (Term){def->paper[i].name, paper_term_force(&def->paper[i], W, def->friction.mu_d, g)};
    }
}

enum { FACTS_MAX = 32 };

/* Lists the main facts of the whole route full of cable, in the order of importance. Returns how many. */
static int list_facts(const Theory *t, Fact fact[FACTS_MAX])
{
    const Calculator *c = &t->calculator;
    const PlanWay *there = &c->plan.way[PLAN_FORWARD], *back = &c->plan.way[PLAN_BACKWARD];
    const HeadSeries *const heads = &c->heads[PLAN_FORWARD], *const turned = &c->heads[PLAN_BACKWARD];
    const char *const best = theory_ways[c->best];
    int n = 0;
    /* number of the format ([formats](results.md#formats)) */
    fact[n++] = (Fact){"format", NULL, "", cell_number(RESULTS_FORMAT)};
    fact[n++] = (Fact){"weight_N_per_m", "weight of the cable", "N/m", cell_number(t->setup.cable_weight)};
    /* coefficient of friction, the largest on the route */
    fact[n++] = (Fact){"friction", "friction coefficient", "", cell_number(c->mu_largest)};
    if (c->mu_largest > c->mu_least) {
        fact[n - 1].label = "friction coefficient, largest";
        /* its least value, if that differs */
        fact[n++] = (Fact){"friction_least", "least", "", cell_number(c->mu_least)};
    }
    fact[n++] = (Fact){"length_m", "length of the route", "m", cell_number(t->setup.route->length)};
    fact[n++] = (Fact){"start_tension_N", "tension at the start", "N", cell_number(there->start)};
    fact[n++] = (Fact){"rope_drag_N", "drag on the rope", "N", cell_number(t->setup.def->drag.force)};
    /* winch force at the end, the route full of cable, by the piece formulas; with pits that of the last section */
    fact[n++] = (Fact){"paper_total_N", "winch force, piece formulas", "N", cell_number(t->paper_total)};
    /* the same by the reference theory */
    fact[n++] = (Fact){"reference_total_N", "winch force at end, forward", "N", cell_number(there->force)};
    /* the same, pulled backward */
    fact[n++] = (Fact){"backward_total_N", "winch force at end, backward", "N", cell_number(back->force)};
    /* largest force of any winch, over all sections and places of the head */
    fact[n++] = (Fact){"largest_force_N", "largest winch force, forward", "N", cell_number(heads->peak.force)};
    /* place of the head there */
    fact[n++] = (Fact){"largest_force_head_m", "with the head at", "m", cell_number(heads->peak.head)};
    /* largest force from rest */
    fact[n++] =
        (Fact){"largest_restart_N", "largest from rest, forward", "N", cell_number(heads->restart_peak.restart)};
    /* place of the head there */
    fact[n++] = (Fact){"largest_restart_head_m", "with the head at", "m", cell_number(heads->restart_peak.head)};
    /* largest force of any winch, pulled backward */
    fact[n++] =
        (Fact){"backward_largest_force_N", "largest winch force, backward", "N", cell_number(turned->peak.force)};
    /* place of the head there */
    fact[n++] = (Fact){"backward_largest_force_head_m", "with the head at", "m", cell_number(turned->peak.head)};
    /* largest force from rest, pulled backward */
    fact[n++] = (Fact){"backward_largest_restart_N", "largest from rest, backward", "N",
                       cell_number(turned->restart_peak.restart)};
    /* place of the head there */
    fact[n++] =
        (Fact){"backward_largest_restart_head_m", "with the head at", "m", cell_number(turned->restart_peak.head)};
    /* largest tension over radius, T/R */
    fact[n++] =
        (Fact){"max_sidewall_N_per_m", "largest sidewall pressure", "N/m", cell_number(there->pull.max_sidewall)};
    /* additional force of bending stiffness, which no other figure has */
    fact[n++] = (Fact){"stiffness_N", "bending stiffness, left out", "N", cell_number(c->limp[PLAN_FORWARD].value)};
    fact[n++] = (Fact){"cables", "cables pulled together", "", cell_number(c->cables)};
    /* direction with less force */
    fact[n++] = (Fact){"better_direction", "less force when pulled", "", cell_text(theory_ways[c->plan.better])};
    /* direction that is better by the limits */
    fact[n++] = (Fact){"best_direction", "better by its limits", "", cell_text(best)};
    /* verdict as text */
    fact[n++] = (Fact){"verdict_forward", NULL, "", cell_text(t->verdict[PLAN_FORWARD].whole)};
    /* its word: `safe`, `safe_if`, `not_safe`, `not_judged`, `not_trusted` */
    fact[n++] = (Fact){"verdict_code", NULL, "", cell_text(hawser_word_code(t->verdict[PLAN_FORWARD].word))};
    /* the same, pulled backward */
    fact[n++] = (Fact){"verdict_backward", NULL, "", cell_text(t->verdict[PLAN_BACKWARD].whole)};
    fact[n++] = (Fact){"verdict_code_backward", NULL, "", cell_text(hawser_word_code(t->verdict[PLAN_BACKWARD].word))};
    return n;
}

/* Drops, for a calculation of one direction, the facts of the other and those that compare them. */
static int drop_backward(int n, Fact fact[FACTS_MAX])
{
    static const char *const keys[] = {"backward_total_N",
                                       "backward_largest_force_N",
                                       "backward_largest_force_head_m",
                                       "backward_largest_restart_N",
                                       "backward_largest_restart_head_m",
                                       "better_direction",
                                       "best_direction",
                                       "verdict_backward",
                                       "verdict_code_backward"};
    int kept = 0;
    for (int i = 0; i < n; i++) {
        int drop = 0;
        for (size_t k = 0; k < sizeof keys / sizeof *keys; k++) drop |= strcmp(fact[i].key, keys[k]) == 0;
        if (!drop) fact[kept++] = fact[i];
    }
    return kept;
}

/* The document with its data, which must stay while it is used. */
typedef struct Page {
    Document doc;
    Fact fact[FACTS_MAX];
    Table table[4 + THEORY_TABLES_MAX];
    RunRow run;
} Page;

static void verdicts_say(Theory *t, int ways)
{
    const Calculator *const c = &t->calculator;
    for (int k = 0; k < ways; k++) {
        hawser_condition held[THEORY_CONDITIONS];
        theory_conditions(c, k, held);
        TheoryVerdict *const v = &t->verdict[k];
        v->word = hawser_verdict_word(
            verdict_say(THEORY_CONDITIONS, held, c->n_limits, c->limit[k], 1, v->whole, sizeof v->whole));
        verdict_say(THEORY_CONDITIONS, held, c->n_limits, c->limit[k], 0, v->shown, sizeof v->shown);
    }
}

/* Makes the page: facts first, the tension along the route, then the paper's own terms if the case lists them. Fills
 * the theory's `place` if it is shown. */
static void page_make(Theory *t, const char *title, int forward_only, Page *page)
{
    const SceneDef *def = t->setup.def;
    const Expected *e = &t->expected;
    Table *const table = page->table;
    int n = 0;
    page->run = (RunRow){e->from, e->to, e->start_tension, e->paper_total, e->reference_total};
    fill_terms(t);
    verdicts_say(t, forward_only ? 1 : PLAN_WAYS);
    for (int i = 0; i < t->tables.n; i++) table[n++] = t->tables.table[i];
    table[n++] = (Table){"stations", "Tension along the route, full of cable, pulled forward",
                         COLUMNS(Place, place_column), t->n, t->place};
    if (def->n_paper > 0)
        table[n++] = (Table){"terms", "Piece formulas (eq. 3-10), term by term", COLUMNS(Term, term_column),
                             def->n_paper, t->term};
    if (!def->duration_open)
        table[n++] =
            (Table){"run", "What a run of this case is compared with", COLUMNS(RunRow, run_column), 1, &page->run};
    page->doc = (Document){
        .title = title, .n_facts = list_facts(t, page->fact), .n_tables = n, .fact = page->fact, .table = table};
    if (forward_only) page->doc.n_facts = drop_backward(page->doc.n_facts, page->fact);
}

/* Returns the name behind the next comma; NULL: there is none. */
static const char *name_next(const char *at)
{
    const char *const comma = strchr(at, ',');
    return comma ? comma + 1 + strspn(comma + 1, " ") : NULL;
}

/* Checks whether a list of names with commas between has one. */
static int is_named(const char *list, const char *name)
{
    const size_t n = strlen(name);
    for (const char *at = list; at; at = name_next(at))
        if (strcspn(at, ",") == n && !strncmp(at, name, n)) return 1;
    return 0;
}

/* Names of all tables and of the other choices; a table without rows in this case is left out. */
static const char table_names[] = "all, facts, pieces, directions, ducts, environment, heads, sections, answers, "
                                  "machines, brakes, pushes, compression, assumed, "
                                  "remedies, notes, limits, trust, refused, stations, terms, run";

/* Rejects the first name of the list that is no table. */
static hawser_status names_check(const char *list, hawser_error *err)
{
    for (const char *at = list; at; at = name_next(at)) {
        char name[64], hint[HINT_MAX];
        snprintf(name, sizeof name, "%.*s", (int)strcspn(at, ","), at);
        if (!is_named(table_names, name))
            return error_set(err, HAWSER_ERR_INPUT, "no table '%s': there are %s%s", name, table_names,
                             case_hint(name, table_names, hint));
    }
    return HAWSER_OK;
}

/* Keeps the requested tables of the page. */
static hawser_status page_choose(Page *page, const char *list, int people, hawser_error *err)
{
    const char *const wanted = list ? list : people ? "sections" : "all";
    const hawser_status status = list ? names_check(list, err) : HAWSER_OK;
    int n = 0;
    page->doc.csv = &page->table[THEORY_PIECES];
    if (status || is_named(wanted, "all")) return status;
    if (!is_named(wanted, "facts")) page->doc.n_facts = 0;
    for (int k = 0; k < page->doc.n_tables; k++) {
        assert(is_named(table_names, page->table[k].key));
        if (is_named(wanted, page->table[k].key)) page->table[n++] = page->table[k];
    }
    page->doc.n_tables = n;
    page->doc.csv = n > 0 ? page->table : NULL;
    return HAWSER_OK;
}

/* Writes the text for readers or programs. */
static hawser_status write_theory(Theory *t, const char *title, hawser_format format,
                                  const hawser_theory_options *options, char **text, hawser_error *err)
{
    Page page;
    const int people = format == HAWSER_TABLE || format == HAWSER_TABLE_US;
    fill_places(t);
    if (people) few_places(t);
    page_make(t, title, 0, &page);
    Answer answer = {t->answer, sizeof t->answer, 0, format == HAWSER_TABLE_US ? HAWSER_US : HAWSER_SI, options->width,
                     0};
    answer_theory(&answer, &t->setup, &t->calculator, &t->inverse, t->verdict);
    page.doc.answer = t->answer;
    const hawser_status status = page_choose(&page, options->tables, people, err);
    return status ? status : document_write(&page.doc, format, text, err);
}

/* Writes the requested tables as an object. */
static hawser_status list_theory(Theory *t, const char *title, const TheoryWish *wish, json_t **out, hawser_error *err)
{
    Page page;
    int places = !wish->table;
    for (int i = 0; wish->table && wish->table[i]; i++) places |= strcmp(wish->table[i], "stations") == 0;
    if (places) fill_places(t);
    page_make(t, title, wish->forward_only, &page);
    *out = document_json(&page.doc, wish->table);
    return *out ? HAWSER_OK : error_memory(err);
}

/* Builds and solves everything from a definition that stays, together with other chains (NULL: none); the caller frees
 * the theory's memory. */
static hawser_status build_and_solve(Theory *t, const SceneDef *def, const Company *company, const TheoryWish *wish,
                                     hawser_error *err)
{
    hawser_status status = setup_make(def, &t->setup, err);
    if (!status && def->theory.simulated) status = cannot_be_pulled(&t->setup, 0, err);
    if (status) return status;
    if (company) t->setup.company = *company;
    return solve(t, wish, err);
}

/* Also frees an unfinished theory. */
static void theory_free(Theory *t)
{
    if (!t) return;
    pull_clear(&t->paper);
    theory_tables_free(&t->tables);
    calculator_free(&t->calculator);
    expected_free(&t->expected);
    setup_free(&t->setup);
    free(t->places);
    free(t->rollers);
    free(t->place);
    free(t->term);
    free(t);
}

/* Reads the case and solves it; *out is to be freed in any case. Builds no simulation: this takes milliseconds even for
 * a long route. */
static hawser_status theory_new(hawser_case *c, const TheoryWish *wish, Theory **out, hawser_error *err)
{
    *out = NULL;
    const hawser_status status = case_ensure_read(c, err);
    if (status) return status;
    if (c->def->rod.present) {
        return error_set(err, HAWSER_ERR_INPUT, "%.200s: key 'rod': the pulling theory needs a route", c->name);
    }
    const hawser_status alone = case_alone(c, "this pulling calculation", err);
    if (alone) return alone;
    *out = calloc(1, sizeof **out);
    return *out ? case_name_error(c, build_and_solve(*out, c->def, NULL, wish, err), err) : error_memory(err);
}

static const char *title_of(const hawser_case *c) { return c->def->title[0] ? c->def->title : c->name; }

/* ------------------------------------------------------------------------------------------------ several chains */

/* Theory of one of several chains, pulled forward. */
typedef struct ChainRow {
    const char *name, *pulled;  /* pulled: name of the puller */
    double factor, pull, share; /* 1, N, 1: for all except ropes */
} ChainRow;

static const Column chain_column[] = {
    {COLUMN("name", TEXT, ChainRow, name), .label = "chain"},
    {COLUMN("pulled_by", TEXT, ChainRow, pulled), .label = "pulled by"},
    {COLUMN("weight_factor", NUMBER, ChainRow, factor), .label = "weight factor", .decimals = 4},
    {COLUMN("pull_N", NUMBER, ChainRow, pull), .label = "pull, N", .decimals = 2},
    {COLUMN("share", NUMBER, ChainRow, share), .label = "share", .decimals = 4},
};

static const SceneDef *chain_def(const SceneDef *def, int k) { return k > 0 ? &def->beside[k - 1] : def; }

static void chain_rows(const SceneDef *def, Theory *const t[], ChainRow row[])
{
    double sum = 0;
    for (int k = 0; k <= def->n_beside; ++k) {
        const SceneDef *const own = chain_def(def, k);
        const int rope = own->strand.joined;
        row[k].name = own->strand.name;
        row[k].pulled = rope >= 0 ? chain_def(def, rope)->strand.name : own->winch.present ? "its winch" : "nothing";
        row[k].factor = 1;
        for (int s = 0; s < own->n_surfaces; ++s) row[k].factor = fmax(row[k].factor, own->surfaces[s].weight_factor);
        row[k].pull = rope >= 0 || own->winch.present ? t[k]->calculator.plan.way[PLAN_FORWARD].force : 0;
        if (!own->strand.rope) sum += row[k].pull;
    }
    for (int k = 0; k <= def->n_beside; ++k)
        row[k].share = chain_def(def, k)->strand.rope || !(sum > 0) ? NAN : row[k].pull / sum;
}

/* Writes the common table as an object, with each chain's own under its name in `theory`. */
static hawser_status chains_json(const Document *all, int n, const ChainRow row[], char *const own[], char **text,
                                 hawser_error *err)
{
    json_t *const doc = document_json(all, NULL), *const theory = json_object();
    int ok = doc && theory;
    for (int k = 0; ok && k < n; ++k) ok = !json_object_set_new(theory, row[k].name, json_loads(own[k], 0, NULL));
    ok = ok && !json_object_set(doc, "theory", theory);
    *text = ok ? json_dumped(doc, JSON_INDENT(2)) : NULL;
    json_decref(theory);
    json_decref(doc);
    return *text ? HAWSER_OK : error_memory(err);
}

/* Writes, for readers, the common table and each chain's own behind it; equal ones once. */
static hawser_status chains_print(char *table, int n, const ChainRow row[], char *const own[], char **text,
                                  hawser_error *err)
{
    size_t size = strlen(table) + 1;
    const char *body[STRANDS_MAX]; /* the text behind the name */
    for (int k = 0; k < n; ++k) {
        size += strlen(own[k]) + 4;
        body[k] = own[k] + strlen(row[k].name);
    }
    char *const all = malloc(size), *at = all;
    if (!all) return error_memory(err);
    at = stpcpy(at, table);
    for (int k = 0; k < n; ++k) {
        int first = 0;
        while (strcmp(body[first], body[k]) != 0) ++first;
        if (first < k) continue;
        at = stpcpy(stpcpy(at, "\n"), row[k].name);
        for (int j = k + 1; j < n; ++j)
            if (!strcmp(body[j], body[k])) at = stpcpy(stpcpy(at, ", "), row[j].name);
        at = stpcpy(at, body[k]);
    }
    *text = all;
    return HAWSER_OK;
}

/* Writes all solved chains: the common table, alone as CSV, otherwise with each chain's own. */
static hawser_status chains_write(const hawser_case *c, Theory *const t[], hawser_format format,
                                  const hawser_theory_options *options, char **text, hawser_error *err)
{
    const SceneDef *const def = c->def;
    const int n = def->n_beside + 1;
    ChainRow row[STRANDS_MAX] = {{.name = NULL}};
    char *own[STRANDS_MAX] = {NULL}, *table = NULL;
    chain_rows(def, t, row);
    const Table rows = {"chains", "What the chains pull by theory", COLUMNS(ChainRow, chain_column), n, row};
    const Document all = {.title = title_of(c), .n_tables = 1, .table = &rows, .csv = &rows};
    if (format == HAWSER_CSV) return document_write(&all, format, text, err);
    hawser_status status = HAWSER_OK;
    for (int k = 0; !status && k < n; ++k) status = write_theory(t[k], row[k].name, format, options, &own[k], err);
    if (!status && format == HAWSER_JSON) {
        status = chains_json(&all, n, row, own, text, err);
    } else if (!status) {
        status = document_write(&all, format, &table, err);
        if (!status) status = chains_print(table, n, row, own, text, err);
    }
    free(table);
    for (int k = 0; k < n; ++k) free(own[k]);
    return status;
}

/* Shares machines, feed and allowances: a machine and the feed push each cable with an equal part, and no rope; the
 * allowances of reel, rope and pits apply to the cables only. */
static hawser_status shared_set(const SceneDef *def, int rope, TheoryDef *out, TheoryPlaceDef **own, hawser_error *err)
{
    int cables = 0;
    for (int k = 0; k <= def->n_beside; ++k) cables += !chain_def(def, k)->strand.rope;
    const double part = rope || cables == 0 ? 0 : 1.0 / cables;
    TheoryPlaceDef *const place = *own = malloc((size_t)(out->n_machines + out->n_pits + 1) * sizeof *place);
    if (!place) return error_memory(err);
    for (int i = 0; i < out->n_machines + out->n_pits; ++i) {
        const int pit = i >= out->n_machines;
        place[i] = pit ? out->pits[i - out->n_machines] : out->machines[i];
        place[i].force *= pit ? !rope : part;
    }
    out->machines = place;
    out->pits = place + out->n_machines;
    out->feed *= part;
    if (rope) out->reel = out->rope = 0;
    return HAWSER_OK;
}

/* Returns the smallest force, N, over all places of the head. */
static double heads_least(const HeadSeries *heads)
{
    double least = INFINITY;
    for (int i = 0; i < heads->n; ++i) least = fmin(least, heads->row[i].tension);
    return heads->n > 0 ? least : 0;
}

/* Adds to a rope's own pull that of its cables (SC15): the sum, with friction of rope and cables separate, is at least
 * that of all together. */
static void drawn_set(const SceneDef *def, Theory *const t[], int rope, Company *out)
{
    for (int k = 0; k <= def->n_beside; ++k) {
        if (chain_def(def, k)->strand.joined != rope || !t[k]) continue;
        const Calculator *const c = &t[k]->calculator;
        for (int way = 0; way < PLAN_WAYS; ++way) {
            out->drawn[way] += c->plan.way[way].force;
            out->drawn_least[way] += heads_least(&c->heads[way]);
            out->drawn_more[way] += calculator_peak(&t[k]->setup, c, way) - c->plan.way[way].force;
        }
    }
}

/* Returns the loads of other chains on rollers, N, for one chain each way: of those that it pulls, and of all others;
 * [n_rollers] each, pairs in one piece of memory. */
static double *rollers_of(const SceneDef *def, double *all, int way, int others)
{
    return all + (size_t)(2 * way + others) * (size_t)def->n_rollers;
}

/* Adds the roller loads of one solved chain, beside this one or pulled by it: rollers carry all chains. A rope includes
 * the loads of the cables that it pulls. */
static hawser_status rollers_add(const SceneDef *def, const Theory *t, int others, double *all, hawser_error *err)
{
    double *const load = malloc(((size_t)def->n_rollers + 1) * sizeof *load);
    if (!load) return error_memory(err);
    for (int way = 0; way < PLAN_WAYS; ++way) {
        double *const sum = rollers_of(def, all, way, others);
        calculator_rollers(&t->setup, &t->calculator, way, load);
        for (int r = 0; r < def->n_rollers; ++r) sum[r] += load[r];
    }
    free(load);
    return HAWSER_OK;
}

/* Returns the chain that is solved last, with which rollers are judged: the last rope, or if there is none the last
 * cable. */
static int last_chain(const SceneDef *def)
{
    int last = def->n_beside;
    while (last > 0 && !chain_def(def, last)->strand.rope) --last;
    return chain_def(def, last)->strand.rope ? last : def->n_beside;
}

static hawser_status rollers_set(const SceneDef *def, Theory *const t[], int of, double **memory, Company *out,
                                 hawser_error *err)
{
    const int last = of == last_chain(def);
    double *const all = *memory = calloc(2 * PLAN_WAYS * (size_t)def->n_rollers + 1, sizeof *all);
    hawser_status status = HAWSER_OK;
    if (!all) return error_memory(err);
    for (int k = 0; !status && k <= def->n_beside; ++k) {
        const int rope = chain_def(def, k)->strand.joined;
        if (t[k] && (rope == of || (last && rope < 0))) status = rollers_add(def, t[k], rope != of, all, err);
    }
    for (int way = 0; way < PLAN_WAYS; ++way) {
        out->rollers_drawn[way] = rollers_of(def, all, way, 0);
        out->rollers_others[way] = rollers_of(def, all, way, 1);
    }
    out->rollers_elsewhere = !last;
    return status;
}

/* Solves one chain, after those that it pulls. */
static hawser_status chain_theory(const hawser_case *c, Theory *t[], int k, hawser_error *err)
{
    const TheoryWish wish = {0};
    const int rope = chain_def(c->def, k)->strand.rope > 0;
    Company company = {.rollers_elsewhere = 0};
    Theory *const own = calloc(1, sizeof *own);
    if (!own) return error_memory(err);
    own->def = *chain_def(c->def, k);
    if (rope) drawn_set(c->def, t, k, &company);
    hawser_status status = rollers_set(c->def, t, k, &own->rollers, &company, err);
    if (!status) status = shared_set(c->def, rope, &own->def.theory, &own->places, err);
    t[k] = own;
    return status ? status : case_name_error(c, build_and_solve(own, &own->def, &company, &wish, err), err);
}

static hawser_status chains_theory(const hawser_case *c, hawser_format format, const hawser_theory_options *options,
                                   char **text, hawser_word *word, hawser_error *err)
{
    Theory *t[STRANDS_MAX] = {NULL};
    hawser_status status = HAWSER_OK;
    for (int ropes = 0; ropes < 2; ++ropes) { /* ropes come after the cables that they pull */
        for (int k = 0; !status && k <= c->def->n_beside; ++k)
            if ((chain_def(c->def, k)->strand.rope > 0) == ropes) status = chain_theory(c, t, k, err);
    }
    if (!status) status = chains_write(c, t, format, options, text, err);
    for (int k = c->def->n_beside; !status && k >= 0; --k)
        if (t[k]->verdict[PLAN_FORWARD].word != HAWSER_SAFE) *word = t[k]->verdict[PLAN_FORWARD].word;
    for (int k = 0; k <= c->def->n_beside; ++k) theory_free(t[k]);
    return status;
}

hawser_status hawser_case_theory_shown(hawser_case *c, hawser_format format, const hawser_theory_options *options,
                                       char **text, hawser_word *word, hawser_error *err)
{
    const TheoryWish all = {0};
    const hawser_theory_options plain = {0}, *const shown = options ? options : &plain;
    hawser_word own = HAWSER_SAFE;
    Theory *t;
    if (!c || !text) return error_argument(err, c ? "text" : "c");
    *text = NULL;
    hawser_status status = case_ensure_read(c, err);
    if (status) return status;
    if (c->def->n_beside > 0) {
        status = chains_theory(c, format, shown, text, &own, err);
    } else {
        status = theory_new(c, &all, &t, err);
        if (!status) status = write_theory(t, title_of(c), format, shown, text, err);
        if (!status) own = t->verdict[PLAN_FORWARD].word;
        theory_free(t);
    }
    if (word) *word = own;
    return status;
}

hawser_status hawser_case_theory(hawser_case *c, hawser_format format, char **text, hawser_error *err)
{
    return hawser_case_theory_shown(c, format, &(hawser_theory_options){.tables = "all"}, text, NULL, err);
}

/* Tables of the page, in their order; the others are under "all values". */
static const char *const page_tables[] = {"lines",    "sections", "limits",  "remedies", "answers",
                                          "machines", "brakes",   "assumed", "notes"};

static int is_on_page(const char *key)
{
    int found = 0;
    for (size_t k = 0; k < sizeof page_tables / sizeof *page_tables; k++) found |= !strcmp(key, page_tables[k]);
    return found;
}

/* Writes the document's tables as parts of a page: the shown ones, or the others behind the facts. */
static hawser_status page_part(const Page *page, int shown, hawser_units units, char **text, hawser_error *err)
{
    Document part = page->doc;
    Table table[sizeof page->table / sizeof *page->table];
    int n = 0;
    for (size_t i = 0; shown && i < sizeof page_tables / sizeof *page_tables; i++)
        for (int k = 0; k < page->doc.n_tables; k++)
            if (!strcmp(page->table[k].key, page_tables[i])) table[n++] = page->table[k];
    for (int k = 0; !shown && k < page->doc.n_tables; k++)
        if (!is_on_page(page->table[k].key)) table[n++] = page->table[k];
    part.n_tables = n;
    part.table = table;
    if (shown) part.n_facts = 0;
    return document_html(&part, units, text, err);
}

static hawser_status body_write(Theory *t, const hawser_case *c, int way, hawser_units units, Text *out,
                                hawser_error *err)
{
    Page page;
    char *tables = NULL, *more = NULL;
    fill_places(t);
    few_places(t);
    page_make(t, title_of(c), 0, &page);
    page.doc.language = c->def->job.language;
    const Language language = c->def->job.language;
    Answer answer = {.text = t->answer, .size = sizeof t->answer, .units = units, .page = 1, .language = language};
    answer_theory(&answer, &t->setup, &t->calculator, &t->inverse, t->verdict);
    PieceLine *line;
    int pieces;
    hawser_status status = piece_lines(&t->calculator, &line, &pieces, err);
    page.table[page.doc.n_tables++] =
        (Table){"lines", "The route piece by piece, full of cable (friction with the weight correction of ducts)",
                piece_line_columns, pieces, line};
    if (!status) status = page_part(&page, 1, units, &tables, err);
    if (!status) status = page_part(&page, 0, units, &more, err);
    const Calculation sheet = {.title = title_of(c),
                               .file = c->name,
                               .code = hawser_word_code(t->verdict[way].word),
                               .verdict = t->verdict[way].shown,
                               .answer = t->answer,
                               .tables = tables,
                               .more = more,
                               .setup = &t->setup,
                               .c = &t->calculator,
                               .units = units,
                               .language = language};
    if (!status) calculation_body(&sheet, out);
    free(line);
    free(tables);
    free(more);
    return status;
}

static hawser_status crew_write(Theory *t, const hawser_case *c, int way, hawser_units units, Text *out,
                                hawser_error *err)
{
    Placed *row = NULL;
    int n = 0;
    (void)c;
    hawser_status status = equipment_find(&t->setup, &t->calculator, way, &n, &row, err);
    verdicts_say(t, PLAN_WAYS);
    const Calculation sheet = {.code = hawser_word_code(t->verdict[way].word),
                               .verdict = t->verdict[way].shown,
                               .setup = &t->setup,
                               .c = &t->calculator,
                               .units = units};
    if (!status) status = crew_body(&sheet, way, n, row, out, err);
    free(row);
    return status;
}

typedef hawser_status (*BodyWrite)(Theory *t, const hawser_case *c, int way, hawser_units units, Text *out,
                                   hawser_error *err);

/* Writes one chain's theory as a part of a page, with decimal points in any locale. */
static hawser_status body_of(hawser_case *c, BodyWrite write, int way, hawser_units units, Text *out, hawser_word *word,
                             hawser_error *err)
{
    const TheoryWish all = {0};
    Theory *t;
    const locale_t plain = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (!plain) return error_memory(err);
    hawser_status status = theory_new(c, &all, &t, err);
    const locale_t before = uselocale(plain);
    if (!status) status = write(t, c, way, units, out, err);
    uselocale(before);
    freelocale(plain);
    if (!status && word) *word = t->verdict[way].word;
    theory_free(t);
    return status;
}

hawser_status case_calculation_body(hawser_case *c, int way, hawser_units units, Text *out, hawser_word *word,
                                    hawser_error *err)
{
    return body_of(c, body_write, way, units, out, word, err);
}

hawser_status case_crew_body(hawser_case *c, int way, hawser_units units, Text *out, hawser_word *word,
                             hawser_error *err)
{
    return body_of(c, crew_write, way, units, out, word, err);
}

static hawser_status page_file(hawser_case *c, const char *kind, BodyWrite write, hawser_units units, const char *path,
                               hawser_word *word, hawser_error *err)
{
    Text out = {0};
    if (!c || !path) return error_argument(err, c ? "path" : "c");
    hawser_status status = hawser_case_spares(c, path, err);
    if (!status) status = case_ensure_read(c, err);
    const Language language = !status && write == body_write ? c->def->job.language : LANGUAGE_ENGLISH;
    if (!status) calculation_head(&c->def->job, language, kind, title_of(c), c->name, &out);
    if (!status) status = body_of(c, write, PLAN_FORWARD, units, &out, word, err);
    calculation_end(&out);
    if (!status && out.failed) status = error_memory(err);
    if (!status) status = out_file(path, out.at, out.size, err);
    text_clear(&out);
    return status;
}

hawser_status hawser_case_calculation(hawser_case *c, hawser_units units, const char *path, hawser_word *word,
                                      hawser_error *err)
{
    return page_file(c, "Pulling calculation", body_write, units, path, word, err);
}

hawser_status hawser_case_crew_sheet(hawser_case *c, hawser_units units, const char *path, hawser_word *word,
                                     hawser_error *err)
{
    return page_file(c, "Crew's sheet", crew_write, units, path, word, err);
}

hawser_status case_theory_values(hawser_case *c, const TheoryWish *wish, json_t **out, hawser_error *err)
{
    Theory *t;
    *out = NULL;
    hawser_status status = theory_new(c, wish, &t, err);
    if (!status) status = list_theory(t, title_of(c), wish, out, err);
    theory_free(t);
    return status;
}

hawser_status case_heads_new(hawser_case *c, CaseHeads *out, hawser_error *err)
{
    static const char *const none[] = {NULL};
    const TheoryWish wish = {.table = none, .no_inverse = 1};
    *out = (CaseHeads){NULL, 0, 0, NAN, NAN};
    const hawser_status status = theory_new(c, &wish, &out->theory, err);
    if (status) return status;
    const Calculator *const calculator = &out->theory->calculator;
    out->ends = calculator->route->length;
    out->begins = c->def->head_at < out->ends - 1e-6 ? c->def->head_at : 0;
    out->friction = calculator->mu_largest;
    out->friction_least = calculator->mu_least;
    return HAWSER_OK;
}

void case_heads_free(CaseHeads *h)
{
    theory_free(h->theory);
    h->theory = NULL;
}

hawser_status case_heads_force(const CaseHeads *h, double share, int n, const double *head, double *force,
                               hawser_error *err)
{
    const Calculator *const c = &h->theory->calculator;
    PullStretch *const stretch = malloc(((size_t)c->def.n_stretches + 1) * sizeof *stretch);
    hawser_status status = stretch ? HAWSER_OK : error_memory(err);
    PlanDef def = c->def;
    for (int i = 0; i < def.n_stretches && stretch; ++i) {
        stretch[i] = def.stretch[i];
        stretch[i].mu *= share;
        stretch[i].mu_static *= share;
        stretch[i].mu_rope *= share;
        stretch[i].mu_rope_static *= share;
    }
    def.stretch = stretch;
    for (int i = 0; i < n && !status; ++i) {
        HeadForce at;
        status = plan_head(&def, PLAN_FORWARD, head[i], &at, err);
        if (!status) force[i] = at.force;
    }
    free(stretch);
    return status;
}
