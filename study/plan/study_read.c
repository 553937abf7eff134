/* From the study's file to a Study. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "io/api/api_handles.h"
#include "study/plan/study_keys.h"

/* The ways to go about it; a sensitivity says which. */
static const struct {
    const char *name;
    StudyKind kind;
} ways[] = {{"grid", STUDY_GRID},          {"list", STUDY_LIST},         {"monte-carlo", STUDY_MONTE_CARLO},
            {"sensitivity", STUDY_MORRIS}, {"optimise", STUDY_OPTIMISE}, {"calibrate", STUDY_CALIBRATE}};
enum { WAYS = sizeof ways / sizeof *ways };

/* Which one the file has: one. */
static hawser_status kind_find(const CaseReader *r, Study *s, const CaseNode **way)
{
    int n = 0;
    for (int k = 0; k < WAYS; k++) {
        const CaseNode *const found = case_node_key(r->root, ways[k].name);
        if (!found) continue;
        *way = found;
        s->kind = ways[k].kind;
        n++;
    }
    if (n == 1) return HAWSER_OK;
    return case_key_error(r->err, n ? *way : r->root, NULL,
                          "%s: give one of grid, list, monte-carlo, sensitivity, optimise, calibrate",
                          n ? "there is another way to go about it beside it" : "nothing says how to vary");
}

/* What is named so is read. */
char *path_beside(Study *s, const char *path)
{
    char *const full = malloc(strlen(s->tree->folder) + strlen(path) + 2);
    if (full && *path == '/') strcpy(full, path);
    if (full && *path != '/') sprintf(full, "%s/%s", s->tree->folder, path);
    if (!full || !file_marks_add(&s->files, full, NULL)) return full;
    free(full);
    return NULL;
}

/* The base case, with what the study sets. Its own messages name it. */
static hawser_status base_load(const CaseReader *r, const char *name, Study *s)
{
    char *const path = path_beside(s, name);
    hawser_status status = path ? hawser_case_load(path, &s->base, r->err) : error_memory(r->err);
    free(path);
    const CaseNode *const set = case_node_key(r->root, "set");
    for (const CaseNode *node = set ? set->first : NULL; node && !status; node = node->next) {
        if (node->kind != NODE_TEXT) return case_value_error(r->err, node, ": expected a value in one line, in quotes");
        hawser_error found = {HAWSER_OK, ""};
        status = hawser_case_set(s->base, node->key, node->text, &found);
        if (status) status = case_key_cause(r->err, node, NULL, "", &found);
    }
    return status;
}

/* Each under its name, in the order of the file; of a grid in that of its list. */
static hawser_status parameters_read(const CaseReader *r, Study *s)
{
    const CaseNode *const map = case_node_key(r->root, "parameters");
    const int n = map ? map->count : 0;
    if (n == 0 && s->kind != STUDY_LIST)
        return case_key_error(r->err, map ? map : r->root, map ? NULL : "parameters", "missing: say what is varied");
    if (n > PARAMETERS_MAX) return case_key_error(r->err, map, NULL, "more than %d parameters", PARAMETERS_MAX);
    s->parameter = calloc((size_t)n + 1, sizeof *s->parameter);
    if (!s->parameter) return error_memory(r->err);
    hawser_status status = HAWSER_OK;
    for (const CaseNode *node = map ? map->first : NULL; node && !status; node = node->next) {
        status = parameter_read(r, node, s->kind, &s->parameter[s->n_parameters++]);
    }
    return status;
}

/* The names in a grid's list are those of the parameters, each once: they give the order. */
static hawser_status grid_read(const CaseReader *r, const CaseNode *list, Study *s)
{
    int at = 0;
    s->samples = 1;
    for (const CaseNode *node = list->first; node; node = node->next, at++) {
        int found = -1;
        for (int j = at; j < s->n_parameters && node->kind == NODE_TEXT; j++) {
            if (strcmp(s->parameter[j].name, node->text) == 0) found = j;
        }
        if (found < 0) return case_value_error(r->err, node, ": no parameter has this name, or it stands here twice");
        const Parameter p = s->parameter[found];
        s->parameter[found] = s->parameter[at];
        s->parameter[at] = p;
        s->samples *= p.n_choices;
        if (s->samples > 100000000) return case_value_error(r->err, list, ": more than 1e8 samples");
    }
    if (at < s->n_parameters) return case_key_error(r->err, list, NULL, "'%s' is not in it", s->parameter[at].name);
    s->blocks = s->samples;
    return HAWSER_OK;
}

/* Sobol points have an end. */
static hawser_status dimensions_check(const CaseReader *r, const CaseNode *way, const Study *s)
{
    const int most = s->kind == STUDY_SOBOL                                      ? SOBOL_DIMENSIONS / 2
                     : s->kind == STUDY_MONTE_CARLO && s->points == POINTS_SOBOL ? SOBOL_DIMENSIONS
                                                                                 : PARAMETERS_MAX;
    if (s->n_parameters <= most) return HAWSER_OK;
    return case_key_error(r->err, way, NULL,
                          "%d parameters, and Sobol points go to %d: take `points: latin`, or morris", s->n_parameters,
                          most);
}

/* How the parameters are varied. */
static hawser_status way_read(const CaseReader *r, const CaseNode *way, Study *s)
{
    StudyRecord record = {.samples = 0};
    hawser_status status = HAWSER_OK;
    if (s->kind == STUDY_GRID) return grid_read(r, way, s);
    if (study_searches(s)) return HAWSER_OK; /* which ask for quantities too: aim_read, measured_read */
    if (s->kind == STUDY_LIST) {
        status = case_section_read(r, way, &study_list_section, &record);
        char *const path = status ? NULL : path_beside(s, record.list);
        if (!status) status = path ? list_read(s, case_node_key(way, "file"), path, r->err) : error_memory(r->err);
        free(path);
        s->blocks = s->samples;
        return status;
    }
    const int indices = s->kind == STUDY_MORRIS;
    status = case_section_read(r, way, indices ? &study_sensitivity : &study_monte_carlo, &record);
    if (status) return status;
    if (indices) s->kind = record.method ? STUDY_SOBOL : STUDY_MORRIS;
    s->points = (PointKind)record.points;
    s->seed = (uint64_t)record.seed;
    s->blocks = record.samples;
    s->samples = record.samples * (indices ? s->n_parameters + 1 + record.method : 1);
    status = dimensions_check(r, way, s);
    return status || indices ? status : correlations_read(r, case_node_key(way, "correlated"), s);
}

/* Paths into one answer. */
static hawser_status paths_read(const CaseReader *r, const CaseNode *list, Fidelity of, Study *s)
{
    if (list->kind != NODE_LIST) return case_value_error(r->err, list, ": expected a list of paths into the answer");
    for (const CaseNode *node = list->first; node; node = node->next) {
        if (node->kind != NODE_TEXT || !*node->text)
            return case_value_error(r->err, node, ": expected a path, such as reference_total_N");
        for (int q = 0; q < s->n_quantities; q++) {
            if (s->quantity[q].of == of && strcmp(s->quantity[q].path, node->text) == 0)
                return case_value_error(r->err, node, " stands here twice");
        }
        s->quantity[s->n_quantities++] = (Quantity){node, node->text, of};
    }
    return HAWSER_OK;
}

/* What is looked at without being asked for. */
static void usual_quantities(Study *s)
{
    if (s->fidelity != BY_RUN) {
        s->quantity[s->n_quantities++] = (Quantity){NULL, "reference_total_N", BY_THEORY};
        s->quantity[s->n_quantities++] = (Quantity){NULL, "max_sidewall_N_per_m", BY_THEORY};
    }
    if (s->fidelity != BY_THEORY) {
        s->quantity[s->n_quantities++] = (Quantity){NULL, "pull_force.steady_mean_N", BY_RUN};
        s->quantity[s->n_quantities++] = (Quantity){NULL, "pull_force.peak_N", BY_RUN};
    }
}

/* A list is of the one answer that there is; with both a map says which. */
static hawser_status quantities_read(const CaseReader *r, Study *s)
{
    static const char *const answers[] = {"theory", "run", NULL};
    const CaseNode *const node = case_node_key(r->root, "quantities");
    int n = 4; /* what nobody asks for */
    const CaseNode *const search = case_node_key(r->root, "optimise");
    for (const CaseNode *part = search ? search->first : NULL; part; part = part->next)
        n += 1 + part->count; /* what a search adds */
    for (const CaseNode *part = node ? node->first : NULL; part; part = part->next) n += 1 + part->count;
    s->quantity = calloc((size_t)n, sizeof *s->quantity);
    if (!s->quantity) return error_memory(r->err);
    if (!node) {
        usual_quantities(s);
        return HAWSER_OK;
    }
    if (node->kind == NODE_LIST && s->fidelity != BY_BOTH) return paths_read(r, node, s->fidelity, s);
    if (node->kind != NODE_MAP) {
        return case_value_error(r->err, node, ": expected %s",
                                s->fidelity == BY_BOTH ? "lists under 'theory' and 'run'" : "a list of paths");
    }
    hawser_status status = HAWSER_OK;
    for (const CaseNode *part = node->first; part && !status; part = part->next) {
        const int of = strcmp(part->key, answers[0]) == 0 ? BY_THEORY : BY_RUN;
        if (of == BY_RUN && strcmp(part->key, answers[1]) != 0)
            return case_key_error(r->err, part, NULL, "unknown key: allowed are theory, run");
        if (s->fidelity != BY_BOTH && (int)s->fidelity != of)
            return case_key_error(r->err, part, NULL, "'fidelity' is '%s'", answers[s->fidelity]);
        status = paths_read(r, part, (Fidelity)of, s);
    }
    return status;
}

/* With every parameter in its middle the case must be one: a key that does not exist shows here, not in every sample.
 */
static hawser_status middle_check(const CaseReader *r, Study *s)
{
    double x[PARAMETERS_MAX];
    hawser_error found = {HAWSER_OK, ""};
    hawser_case *c = NULL;
    study_middle(s, x);
    hawser_status status = study_case(s, x, &c, &found);
    if (!status) c->tree->unlisted = 0;
    if (!status) status = hawser_case_check(c, &found);
    if (!status) status = file_marks_join(&s->files, &c->def->files, &found);
    hawser_case_free(c);
    if (status != HAWSER_ERR_INPUT) return status ? error_set(r->err, status, "%s", found.message) : HAWSER_OK;
    const CaseNode *blame = r->root;
    for (int j = 0; j < s->n_parameters; j++) { /* whose keys the message names */
        char set[SETTING_MAX + 8];
        snprintf(set, sizeof set, "--set %s:", s->parameter[j].key[0]);
        if (s->parameter[j].node && strncmp(found.message, set, strlen(set)) == 0) blame = s->parameter[j].node;
    }
    char place[CASE_PLACE_MAX];
    return error_set(r->err, HAWSER_ERR_INPUT, "%s: with every parameter %s the case is refused: %.800s",
                     case_place(blame->origin, blame->line, place),
                     s->kind == STUDY_GRID   ? "at its first value"
                     : s->kind == STUDY_LIST ? "as in the first row"
                                             : "in its middle",
                     found.message);
}

/* All of it, in the order in which each part finds what it needs. */
static hawser_status study_fill(const CaseReader *r, Study *s)
{
    StudyRecord record = {.samples = 0};
    const CaseNode *way = NULL;
    hawser_status status = case_section_read(r, r->root, &study_top, &record);
    if (status) return status;
    strcpy(s->title, record.title);
    s->fidelity = record.fidelity > BY_BOTH ? BY_BOTH : (Fidelity)record.fidelity;
    s->pilot = record.fidelity > BY_BOTH ? record.pilot : 0;
    for (int k = 0; k < LIMIT_KINDS; k++) s->close[k] = record.close;
    s->time_limit = record.time_limit;
    s->memory = record.memory;
    status = kind_find(r, s, &way);
    if (!status && s->pilot && study_searches(s)) {
        status = case_key_error(r->err, case_node_key(r->root, "fidelity"), NULL,
                                "a search has no pilots: give 'theory', 'run' or 'both'");
    }
    if (!status) status = base_load(r, record.base, s);
    if (!status) status = parameters_read(r, s);
    if (!status) status = way_read(r, way, s);
    if (!status) status = quantities_read(r, s);
    if (!status && s->kind == STUDY_OPTIMISE) status = aim_read(r, way, s);
    if (!status && s->kind == STUDY_CALIBRATE) status = measured_read(r, way, s);
    if (!status) status = middle_check(r, s);
    return status ? status : twice_check(r, s, way);
}

hawser_status study_read(const char *path, Study **out, hawser_error *err)
{
    *out = NULL;
    Study *const s = calloc(1, sizeof *s);
    Units *const units = units_new();
    hawser_status status = s && units ? HAWSER_OK : error_memory(err);
    if (!status) s->path = strdup(path);
    if (!status && !s->path) status = error_memory(err);
    if (!status) status = case_tree_load(path, &s->tree, err);
    if (!status) status = file_marks_add(&s->files, path, err);
    if (!status) {
        const CaseReader r = {.units = units, .root = s->tree->root, .folder = s->tree->folder, .err = err};
        status = study_fill(&r, s);
    }
    units_free(units);
    *out = status ? study_free(s) : s;
    return status;
}

Study *study_free(Study *s)
{
    if (!s) return NULL;
    for (int j = 0; j < s->n_parameters; j++) {
        Parameter *const p = &s->parameter[j];
        for (int k = 0; k < p->n_choices && p->choice; k++) free(p->choice[k]);
        if (!p->node) free((char *)(size_t)p->name);
        free(p->choice);
        free(p->number);
        free(p->weight);
        free(p->key);
    }
    free(s->parameter);
    free(s->factor);
    free(s->quantity);
    free(s->aim.constraint);
    free(s->aim.term);
    free(s->measured.point);
    free(s->measured.weight);
    free((char *)(size_t)s->aim.name);
    hawser_case_free(s->base);
    case_tree_free(s->tree);
    file_marks_free(&s->files);
    free(s->path);
    free(s);
    return NULL;
}
