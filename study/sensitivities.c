/* A run with the derivatives of its figures, `hawser run --sensitivities`, and the derivatives at its final position by
 * every number of the case. The case is read three times per parameter: as it is, and with slightly less and more of
 * it; sim/run/tangent.h does the rest. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "hawser/hawser.h"
#include "io/api/api_handles.h"
#include "io/case/units.h"
#include "io/results/column.h"
#include "io/results/results_file.h"
#include "sim/run/tangent.h"
#include "study/plan.h"

/* Half of the difference that approximates a derivative of the equations' right-hand side by a parameter, as a share of
 * it: the state's part is exact, and every figure is exact to the second order of this. */
static const double SHARE = 1e-5;

static const char RUN_TITLE[] = "What a run's figures change by",
                  POSITION_TITLE[] = "What the figures of a position change by";

/* Parameters of a run: values of the case, and the definitions with less and more. */
typedef struct Varied {
    size_t n;
    const char *const *key; /* [n] */
    double *value, *half;   /* [n] in `unit` */
    char (*unit)[UNIT_MAX]; /* [n] */
    hawser_case **less, **more;
    SceneDef *less_def, *more_def; /* [n] borrowed of them */
} Varied;

/* A figure and its derivative by a parameter. */
typedef struct SlopeRow {
    char figure[96];
    const char *key, *unit;
    double value, slope, share; /* N, N per unit, % per 1 % */
} SlopeRow;

static const Column slope_column[] = {
    /* pull, tension at a station, or load of a roller */
    {COLUMN("figure", CHARS, SlopeRow, figure), .label = "what"},
    /* its value */
    {COLUMN("value_N", NUMBER, SlopeRow, value), .label = "N", .decimals = 2},
    /* key of the case */
    {COLUMN("key", TEXT, SlopeRow, key), .label = "by"},
    /* change of the figure in N for one more of the key's unit */
    {COLUMN("slope_N_per_unit", NUMBER, SlopeRow, slope), .label = "for one more, N", .decimals = 4},
    /* unit of the key */
    {COLUMN("unit", TEXT, SlopeRow, unit), .label = "unit"},
    /* change of the figure in per cent for 1 % more of the key */
    {COLUMN("share", NUMBER, SlopeRow, share), .label = "% for 1 % more", .decimals = 4},
};

/* The value at a dotted key; items of lists by number or by name. NULL: none. */
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

/* Builds and reads the case with a key at another value. */
static hawser_status case_with(const hawser_case *c, const char *key, double value, const char *unit, hawser_case **out,
                               SceneDef *def, hawser_error *err)
{
    char text[128];
    snprintf(text, sizeof text, "%.17g %s", value, unit);
    hawser_status status = hawser_case_copy(c, out, err);
    if (!status) status = hawser_case_set(*out, key, text, err);
    if (!status) status = case_ensure_read(*out, err);
    if (!status) *def = *(*out)->def;
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
        if (!strncmp(key, "route.", 6)) {
            /* a change that moves all supports by a share of a length passes contacts, which are a tenth of a mm deep
             */
            status =
                error_set(err, HAWSER_ERR_INPUT,
                          "--sensitivities %.200s: the route's shape opens and closes contacts, and has no slope by "
                          "them: 'hawser theory', or a study of runs, says what it changes",
                          key);
            break;
        }
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

/* Computes the run step by step, followed by its tangents. */
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

/* Checks whether a figure is in the readable table: the pull, the stations, the roller with the largest load. */
static int is_shown(const TangentFigures *f, int i)
{
    int most = 1 + f->stations;
    for (int k = most; k < f->n; k++) {
        if (f->value[k] > f->value[most]) most = k;
    }
    return i <= f->stations || i == most;
}

/* Writes slope[v->n][f->n]; for programs with the identity of the run. */
static hawser_status slopes_write(const hawser_case *c, const hawser_sim *sim, const Varied *v, const TangentFigures *f,
                                  const double *slopes, Fact fact, const char *title, hawser_format format, char **text,
                                  hawser_error *err)
{
    SlopeRow *const row = calloc(v->n * (size_t)f->n + 1, sizeof *row);
    char run[SUM_SIZE];
    int n = 0;
    if (!row) return error_memory(err);
    for (int i = 0; i < f->n; i++) {
        if ((format == HAWSER_TABLE || format == HAWSER_TABLE_US) && !is_shown(f, i)) continue;
        for (size_t k = 0; k < v->n; k++) {
            const double slope = slopes[k * (size_t)f->n + (size_t)i];
            row[n] = (SlopeRow){.key = v->key[k], .unit = v->unit[k], .value = f->value[i], .slope = slope};
            row[n].share = slope * v->value[k] / f->value[i];
            figure_name(&sim->stage.scene, f, i, row[n++].figure);
        }
    }
    const Table table[] = {{"sensitivities", title, COLUMNS(SlopeRow, slope_column), n, row}};
    run_identity(sim, run);
    const Fact facts[] = {fact, {"run", "", "", cell_text(run)}};
    const Document doc = {.title = c->def->title[0] ? c->def->title : c->name,
                          .n_facts = format == HAWSER_JSON ? 2 : 1,
                          .n_tables = 1,
                          .fact = facts,
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
    hawser_error local;
    if (!err) err = &local;
    Varied v = {.n = n, .key = keys};
    Tangent *g = NULL;
    hawser_sim *sim = NULL;
    *text = NULL;
    if (json) *json = NULL;
    hawser_status status = case_ensure_read(c, err);
    if (!status) status = case_alone(c, "sensitivities", err);
    if (!status) status = varied_make(c, &v, err);
    if (!status) {
        status = tangent_new(c->def, (int)n, v.less_def, v.more_def, v.half, c->def->output.steady_from, &g, err);
        status = case_name_error(c, status, err);
    }
    if (!status) status = hawser_sim_new(c, &one, &sim, err);
    if (!status) status = run_along(sim, g, stop, user, err);
    if (!status) {
        const TangentFigures *const f = tangent_figures(g);
        const Fact mean = {"mean_over_s", "means over the last", "s", cell_number(f->seconds)};
        status = slopes_write(c, sim, &v, f, f->slope, mean, RUN_TITLE, format, text, err);
        if (!status && json) status = slopes_write(c, sim, &v, f, f->slope, mean, RUN_TITLE, HAWSER_JSON, json, err);
    }
    hawser_sim_free(sim);
    tangent_free(g);
    varied_free(&v);
    return status;
}

/* ------------------------------------------------------------------------------------------------- at one position */

/* Keys of the case, owned. */
typedef struct Keys {
    size_t n, room;
    char **key;
} Keys;

/* Checks whether a section affects the pull: those that compute, record or judge it do not. */
static int is_mechanics(const char *section)
{
    static const char *const other[] = {"title",  "include", "run",      "solver", "output",
                                        "limits", "theory",  "analysis", "view"};
    for (size_t k = 0; k < sizeof other / sizeof *other; k++) {
        if (strcmp(section, other[k]) == 0) return 0;
    }
    return 1;
}

/* Collects every number other than 0 below a node whose path is `path`. Returns 0 without memory. */
static int numbers_find(const CaseNode *node, const Units *units, const char *path, Keys *keys)
{
    char here[512], unit[UNIT_MAX];
    double value;
    int item = 0;
    if (node->kind == NODE_TEXT && value_split(units, node->text, &value, unit) && value != 0) {
        if (keys->n == keys->room) {
            char **const more = realloc(keys->key, (2 * keys->room + 16) * sizeof *more);
            if (!more) return 0;
            keys->key = more;
            keys->room = 2 * keys->room + 16;
        }
        keys->key[keys->n] = strdup(path);
        return keys->key[keys->n++] != NULL;
    }
    for (const CaseNode *part = node->first; part; part = part->next, item++) {
        char number[16];
        snprintf(number, sizeof number, "%d", item);
        const char *const name = node->kind == NODE_LIST ? number : part->key;
        if (!*path && !is_mechanics(name)) continue;
        if (snprintf(here, sizeof here, "%s%s%s", path, *path ? "." : "", name) >= (int)sizeof here) continue;
        if (!numbers_find(part, units, here, keys)) return 0;
    }
    return 1;
}

static void keys_free(Keys *keys)
{
    for (size_t k = 0; k < keys->n; k++) free(keys->key[k]);
    free(keys->key);
}

/* Computes one parameter's slopes [figures]. A change that the case or the position cannot take is an error. */
static hawser_status position_slope(const hawser_case *c, Position *at, const char *const *key, Varied *to, size_t k,
                                    double *slope, hawser_error *err)
{
    Varied one = {.n = 1, .key = key};
    hawser_status status = varied_make(c, &one, err);
    if (!status) status = position_by(at, &one.less_def[0], &one.more_def[0], one.half[0], slope, err);
    if (!status) {
        to->value[k] = one.value[0];
        memcpy(to->unit[k], one.unit[0], UNIT_MAX);
    }
    varied_free(&one);
    return status;
}

/* Computes the slopes by all keys, or by every number of the case; of the latter, those that cannot be varied slightly,
 * such as counts, are left out. v->key[n] becomes the remaining ones. */
static hawser_status position_slopes(const hawser_case *c, Position *at, int every, const char **key, Varied *v,
                                     double *slope, int (*stop)(void *), void *user, hawser_error *err)
{
    const size_t figures = (size_t)position_figures(at)->n, n = v->n;
    hawser_status status = HAWSER_OK;
    v->n = 0;
    for (size_t k = 0; k < n && !status; k++) {
        status = position_slope(c, at, &key[k], v, v->n, slope + v->n * figures, err);
        if (status == HAWSER_ERR_INPUT && every) {
            status = HAWSER_OK;
            continue;
        }
        key[v->n++] = key[k];
        if (!status && stop && stop(user)) status = error_set(err, HAWSER_STOPPED, "stopped at %s", key[k]);
    }
    return status;
}

/* Computes the run to its end, and that position. */
static hawser_status position_find(hawser_case *c, int (*stop)(void *), void *user, hawser_sim **sim, Position **at,
                                   hawser_error *err)
{
    const hawser_options one = {.threads = 1};
    hawser_status status = hawser_sim_new(c, &one, sim, err);
    if (!status && c->def->solver.relax) status = sim_relax(*sim, NULL, err);
    while (!status && (*sim)->stage.t < c->def->duration) {
        status = sim_advance(*sim, c->def->duration, 1, err);
        if (!status && stop && stop(user)) status = error_set(err, HAWSER_STOPPED, "stopped at %g s", (*sim)->stage.t);
    }
    if (status) return status;
    const Stage *const st = &(*sim)->stage;
    double *const full = aligned_array_new(scene_state_size(&st->scene));
    if (!full) return error_memory(err);
    st->motion->ops->unpack(st->motion, st->y, full);
    status = case_name_error(c, position_new(c->def, st->t, full, at, err), err);
    free(full);
    return status;
}

hawser_status hawser_case_position_sensitivities(hawser_case *c, size_t n, const char *const *keys,
                                                 hawser_format format, int (*stop)(void *user), void *user, char **text,
                                                 char **json, hawser_error *err)
{
    if (!c || (!keys && n > 0) || !text) return error_argument(err, !c ? "c" : !text ? "text" : "keys");
    hawser_error local;
    if (!err) err = &local;
    hawser_sim *sim = NULL;
    Position *at = NULL;
    Keys every = {0};
    Units *const units = units_new();
    *text = NULL;
    if (json) *json = NULL;
    hawser_status status = units ? case_ensure_read(c, err) : error_memory(err);
    if (!status && n == 0 && !numbers_find(c->tree->root, units, "", &every)) status = error_memory(err);
    Varied v = {.n = n > 0 ? n : every.n};
    const size_t room = v.n + 1;
    const char **const key = calloc(room, sizeof *key);
    v.value = calloc(room, sizeof *v.value);
    v.unit = calloc(room, sizeof *v.unit);
    v.key = key;
    if (!status && (!key || !v.value || !v.unit)) status = error_memory(err);
    for (size_t k = 0; k < v.n && key; k++) key[k] = n > 0 ? keys[k] : every.key[k];
    if (!status) status = position_find(c, stop, user, &sim, &at, err);
    const TangentFigures *const f = status ? NULL : position_figures(at);
    double *const slope = f ? calloc(room * (size_t)f->n, sizeof *slope) : NULL;
    if (!status && !slope) status = error_memory(err);
    if (!status) status = position_slopes(c, at, n == 0, key, &v, slope, stop, user, err);
    if (!status) {
        const Fact when = {"at_s", "the position of", "s", cell_number(sim->stage.t)};
        status = slopes_write(c, sim, &v, f, slope, when, POSITION_TITLE, format, text, err);
        if (!status && json) status = slopes_write(c, sim, &v, f, slope, when, POSITION_TITLE, HAWSER_JSON, json, err);
    }
    free(slope);
    free(key);
    varied_free(&v);
    position_free(at);
    hawser_sim_free(sim);
    keys_free(&every);
    units_free(units);
    return status;
}

hawser_status hawser_sensitivities_write(const char *json, const char *dir, hawser_error *err)
{
    if (!json || !dir) return error_argument(err, json ? "dir" : "json");
    return companion_write(dir, "sensitivities.json", json, err);
}
