/* A run with the derivatives of its figures: `hawser run --sensitivities`. The case is read three times a parameter, as
 * it is and with a little less and more of it; sim/run/tangent.h does the rest. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "hawser/sweep.h"
#include "io/api/api_handles.h"
#include "io/results/column.h"
#include "io/yaml/units.h"
#include "sim/run/tangent.h"
#include "study/plan/study.h"

/* Half of the difference that stands for a derivative of the equations' right-hand side by a parameter, as a share of
 * it: the state's part is exact, and so is every figure to the second order of this. */
static const double SHARE = 1e-5;

/* Parameters of a run: as the case has them, and the definitions with less and more. */
typedef struct Varied {
    size_t n;
    const char *const *key; /* [n] */
    double *value, *half;   /* [n] in `unit` */
    char (*unit)[UNIT_MAX]; /* [n] */
    hawser_case **less, **more;
    SceneDef *less_def, *more_def; /* [n] borrowed of them */
} Varied;

/* A figure and what a parameter makes of it. */
typedef struct SlopeRow {
    char figure[96];
    const char *key, *unit;
    double value, slope, share; /* N, N by one more unit, % by 1 % more */
} SlopeRow;

static const Column slope_column[] = {
    {COLUMN("figure", CHARS, SlopeRow, figure), .label = "what"},
    {COLUMN("value_N", NUMBER, SlopeRow, value), .label = "N", .decimals = 2},
    {COLUMN("key", TEXT, SlopeRow, key), .label = "by"},
    {COLUMN("slope_N_per_unit", NUMBER, SlopeRow, slope), .label = "for one more, N", .decimals = 4},
    {COLUMN("unit", TEXT, SlopeRow, unit), .label = "unit"},
    {COLUMN("share", NUMBER, SlopeRow, share), .label = "% for 1 % more", .decimals = 4},
};

/* The value at a dotted key; items of lists go by number or by name. NULL: nowhere. */
static const CaseNode *node_at(const CaseNode *node, const char *key)
{
    while (node && *key) {
        char word[128], *end;
        const size_t n = strcspn(key, ".");
        snprintf(word, sizeof word, "%.*s", (int)n, key);
        const long item = strtol(word, &end, 10);
        const CaseNode *next = node->kind == NODE_MAP ? case_node_key(node, word) : NULL;
        if (node->kind == NODE_LIST && *word && !*end) next = case_node_item(node, (int)item);
        for (const CaseNode *i = node->first; node->kind == NODE_LIST && !next && i; i = i->next) {
            const CaseNode *const name = case_node_key(i, "name");
            if (name && name->text && strcmp(name->text, word) == 0) next = i;
        }
        node = next;
        key += key[n] ? n + 1 : n;
    }
    return node;
}

/* The case with a key at another value, read. */
static hawser_status case_with(const hawser_case *c, const char *key, double value, const char *unit, hawser_case **out,
                               SceneDef *def, hawser_error *err)
{
    char text[128];
    snprintf(text, sizeof text, "%.17g %s", value, unit);
    hawser_status status = case_copy(c, out, err);
    if (!status) status = hawser_case_set(*out, key, text, err);
    if (!status) status = case_ensure_read(*out, err);
    if (!status) *def = (*out)->def;
    return status;
}

static hawser_status varied_make(const hawser_case *c, Varied *v, hawser_error *err)
{
    const size_t n = v->n + 1;
    v->value = calloc(n, sizeof *v->value);
    v->half = calloc(n, sizeof *v->half);
    v->unit = calloc(n, sizeof *v->unit);
    v->less = calloc(n, sizeof(hawser_case *));
    v->more = calloc(n, sizeof(hawser_case *));
    v->less_def = calloc(n, sizeof *v->less_def);
    v->more_def = calloc(n, sizeof *v->more_def);
    Units *const units = units_new();
    const int fine = v->value && v->half && v->unit && v->less && v->more && v->less_def && v->more_def && units;
    hawser_status status = fine ? HAWSER_OK : error_memory(err);
    for (size_t k = 0; k < v->n && !status; k++) {
        const char *const key = v->key[k];
        const CaseNode *const node = node_at(c->tree->root, key);
        if (!node || node->kind != NODE_TEXT || !value_split(units, node->text, &v->value[k], v->unit[k]) ||
            v->value[k] == 0) {
            status = error_set(err, HAWSER_ERR_INPUT,
                               "--sensitivities %.200s: the case gives no number other than 0 there: --set does", key);
            break;
        }
        v->half[k] = SHARE * fabs(v->value[k]);
        status = case_with(c, key, v->value[k] - v->half[k], v->unit[k], &v->less[k], &v->less_def[k], err);
        if (!status)
            status = case_with(c, key, v->value[k] + v->half[k], v->unit[k], &v->more[k], &v->more_def[k], err);
    }
    units_free(units);
    return status;
}

static void varied_free(Varied *v)
{
    for (size_t k = 0; k < v->n && v->less && v->more; k++) {
        hawser_case_free(v->less[k]);
        hawser_case_free(v->more[k]);
    }
    free(v->value);
    free(v->half);
    free(v->unit);
    free(v->less);
    free(v->more);
    free(v->less_def);
    free(v->more_def);
}

/* The run, step by step, and its tangents behind it. */
static hawser_status run_along(hawser_sim *sim, Tangent *g, int (*stop)(void *), void *user, hawser_error *err)
{
    const SceneDef *const def = &sim->stage.scene.def;
    hawser_status status = def->solver.relax ? sim_relax(sim, NULL, err) : HAWSER_OK;
    if (!status) status = tangent_step(g, sim->stage.t, sim->stage.y, err);
    while (!status && sim->stage.t < def->duration) {
        status = sim_advance(sim, def->duration, 1, err);
        if (!status) status = tangent_step(g, sim->stage.t, sim->stage.y, err);
        if (!status && stop && stop(user)) status = error_set(err, HAWSER_STOPPED, "stopped at %g s", sim->stage.t);
    }
    return status;
}

static void figure_name(const Scene *scene, const TangentFigures *f, int i, char name[96])
{
    if (i == 0) snprintf(name, 96, "pull");
    if (i > 0 && i <= f->stations) snprintf(name, 96, "tension at %.70s", scene->def.stations[i - 1].name);
    if (i > f->stations) snprintf(name, 96, "load of roller %d", i - 1 - f->stations);
}

/* For people: the pull, the stations, the roller that bears most. */
static int is_shown(const TangentFigures *f, int i)
{
    int most = 1 + f->stations;
    for (int k = most; k < f->n; k++) {
        if (f->value[k] > f->value[most]) most = k;
    }
    return i <= f->stations || i == most;
}

static hawser_status slopes_write(const hawser_case *c, const Scene *scene, const Varied *v, const TangentFigures *f,
                                  hawser_format format, char **text, hawser_error *err)
{
    SlopeRow *const row = calloc(v->n * (size_t)f->n + 1, sizeof *row);
    int n = 0;
    if (!row) return error_memory(err);
    for (int i = 0; i < f->n; i++) {
        if ((format == HAWSER_TABLE || format == HAWSER_TABLE_US) && !is_shown(f, i)) continue;
        for (size_t k = 0; k < v->n; k++) {
            const double slope = f->slope[k * (size_t)f->n + (size_t)i];
            row[n] = (SlopeRow){.key = v->key[k], .unit = v->unit[k], .value = f->value[i], .slope = slope};
            row[n].share = slope * v->value[k] / f->value[i];
            figure_name(scene, f, i, row[n++].figure);
        }
    }
    const Fact fact[] = {{"mean_over_s", "means over the last", "s", cell_number(f->seconds)}};
    const Table table[] = {
        {"sensitivities", "What a run's figures change by", COLUMNS(SlopeRow, slope_column), n, row}};
    const Document doc = {.title = c->def.title[0] ? c->def.title : c->name,
                          .n_facts = 1,
                          .n_tables = 1,
                          .fact = fact,
                          .table = table,
                          .csv = table};
    const hawser_status status = document_write(&doc, format, text, err);
    free(row);
    return status;
}

hawser_status hawser_case_run_sensitivities(hawser_case *c, size_t n, const char *const *keys, hawser_format format,
                                            int (*stop)(void *user), void *user, char **text, char **json,
                                            hawser_error *err)
{
    if (!c || !keys || !text) return error_argument(err, !c ? "c" : !keys ? "keys" : "text");
    const hawser_options one = {.threads = 1};
    Varied v = {.n = n, .key = keys};
    Tangent *g = NULL;
    hawser_sim *sim = NULL;
    *text = NULL;
    if (json) *json = NULL;
    hawser_status status = case_ensure_read(c, err);
    if (!status) status = case_alone(c, "sensitivities", err);
    if (!status) status = varied_make(c, &v, err);
    if (!status) {
        status = tangent_new(&c->def, (int)n, v.less_def, v.more_def, v.half, c->def.output.steady_from, &g, err);
        status = case_name_error(c, status, err);
    }
    if (!status) status = hawser_sim_new(c, &one, &sim, err);
    if (!status) status = run_along(sim, g, stop, user, err);
    if (!status) status = slopes_write(c, &sim->stage.scene, &v, tangent_figures(g), format, text, err);
    if (!status && json) status = slopes_write(c, &sim->stage.scene, &v, tangent_figures(g), HAWSER_JSON, json, err);
    hawser_sim_free(sim);
    tangent_free(g);
    varied_free(&v);
    return status;
}
