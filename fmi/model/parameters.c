/* Parameters: every number that the case writes, by its own key. What a case leaves to a default becomes a parameter by
 * being written. What is written of results is not among them, nor are long lists, of rollers or marks say. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/error.h"
#include "fmi/model/variables.h"
#include "io/api/api_handles.h"
#include "io/case/case_parts.h"

enum { LIST_MAX = 40 };

typedef struct Walk {
    Variables *v;
    const CaseReader *r;
    hawser_error *err;
} Walk;

/* A number as the case has it: its value in SI is where the parameter begins. One that cannot be read by its dimension
 * alone (a stiffness per power of a length) is none. */
static hawser_status number_add(const Walk *w, const CaseNode *node, const CaseKey *key, const char *path)
{
    const char *const unit = dimension_unit(key->dimension);
    char description[200], example[112] = "";
    double value;
    if (key->dimension == DIM_STIFFNESS || case_number_read(w->r, node, key, &value)) return HAWSER_OK;
    if (strlen(node->text) < 80) snprintf(example, sizeof example, ", %.80s in the case", node->text);
    snprintf(description, sizeof description, "%s of the case%s", dimension_name(key->dimension), example);
    const Variable row = {.type = VARIABLE_REAL,
                          .role = ROLE_PARAMETER,
                          .unit = unit_name(unit),
                          .written = key->dimension == DIM_NONE ? "" : unit,
                          .start = value,
                          .least = key->min,
                          .most = key->max};
    return variable_add(w->v, &row, description, w->err, "%s", path);
}

static hawser_status map_walk(const Walk *w, const CaseNode *map, const CaseSection *section, const char *path);

/* Whether a map's keys are names that the user chooses, each with the section's keys below it. */
static int is_named(const CaseSection *section)
{
    const char *const last = strrchr(section->path, '.');
    return last && strcmp(last, ".NAME") == 0;
}

/* A dotted key that can be set: a name with a dot in it would be taken apart. */
static int path_add(char to[CASE_PATH_MAX], const char *path, const char *step)
{
    return !strchr(step, '.') && snprintf(to, CASE_PATH_MAX, "%s%s%s", path, *path ? "." : "", step) < CASE_PATH_MAX;
}

static hawser_status items_walk(const Walk *w, const CaseNode *node, const CaseSection *section, const char *path)
{
    char inner[CASE_PATH_MAX], number[16];
    hawser_status status = HAWSER_OK;
    if (node->count > LIST_MAX) return status;
    for (const CaseNode *item = node->first; item && !status; item = item->next) {
        snprintf(number, sizeof number, "%d", item->index);
        if (item->kind == NODE_MAP && path_add(inner, path, item->key ? item->key : number))
            status = map_walk(w, item, section, inner);
    }
    return status;
}

static hawser_status map_walk(const Walk *w, const CaseNode *map, const CaseSection *section, const char *path)
{
    char inner[CASE_PATH_MAX];
    hawser_status status = HAWSER_OK;
    for (const CaseNode *child = map->first; child && !status; child = child->next) {
        const CaseKey *const key = case_key_of(section, child->key);
        if (!key || key->section == &case_output || !path_add(inner, path, child->key)) continue;
        if (key->kind == KEY_NUMBER && child->kind == NODE_TEXT) status = number_add(w, child, key, inner);
        if (!key->section || child->kind == NODE_TEXT) continue;
        const int items = child->kind == NODE_LIST || is_named(key->section);
        status = items ? items_walk(w, child, key->section, inner) : map_walk(w, child, key->section, inner);
    }
    return status;
}

hawser_status variables_add_parameters(Variables *v, hawser_case *c, hawser_error *err)
{
    hawser_error unread; /* what cannot be read as a number is no parameter */
    const CaseReader r = {.units = units_new(), .def = c->def, .root = c->tree->root, .err = &unread};
    const Walk w = {v, &r, err};
    if (!r.units) return error_memory(err);
    const Variable ramp = {.type = VARIABLE_REAL,
                           .role = ROLE_TUNABLE,
                           .unit = "s",
                           .start = COMMAND_RAMP_USUAL,
                           .least = COMMAND_RAMP_LEAST,
                           .most = COMMAND_RAMP_MOST};
    hawser_status status = variable_add(v, &ramp, "over which what an input says comes in", err, "inputs.ramp");
    if (!status) status = map_walk(&w, r.root, &case_top, "");
    units_free(r.units);
    return status;
}
