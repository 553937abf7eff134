/* Parameters: every number that the case writes, under "case." by its own key; items of lists by their names, as those
 * of inputs and outputs, or by their place from 1 where they have none. What a case leaves to a default becomes a
 * parameter by being written. What is written of results is not among them, nor are long lists, of rollers or marks
 * say. */
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

/* How much of a text to show: the sentences that end within 200 bytes, the first in any case. */
static int sentences_length(const char *text)
{
    const size_t all = strlen(text);
    size_t n = 0;
    for (const char *end = text; (end = strstr(end, ". ")) && (n == 0 || end - text <= 200); ++end)
        n = (size_t)(end - text);
    if (n == 0 || all <= 200) n = all;
    if (n > 1000) n = 1000;
    return (int)(n > 0 && text[n - 1] == '.' ? n - 1 : n);
}

/* A number as the case has it: its value in SI is where the parameter begins. One that cannot be read by its dimension
 * alone (a stiffness per power of a length) is none. */
static hawser_status number_add(const Walk *w, const CaseNode *node, const CaseSection *section, const CaseKey *key,
                                const char *name)
{
    const char *const unit = dimension_unit(key->dimension), *const meaning = case_key_meaning(section, key);
    char description[1400], example[112] = "", path[CASE_PATH_MAX];
    double value;
    if (key->dimension == DIM_STIFFNESS || case_number_read(w->r, node, key, &value)) return HAWSER_OK;
    if (strlen(node->text) < 80) snprintf(example, sizeof example, ", %.80s", node->text);
    snprintf(description, sizeof description, "%.*s (%s%s)", sentences_length(meaning), meaning,
             case_path(node, NULL, path), example);
    const Variable row = {.type = VARIABLE_REAL,
                          .role = ROLE_PARAMETER,
                          .key = path,
                          .unit = unit_name(unit),
                          .written = key->dimension == DIM_NONE ? "" : unit,
                          .start = value,
                          .least = key->min,
                          .most = key->max};
    return variable_add(w->v, &row, description, w->err, "%s", name);
}

/* The name of a variable, up to a step. */
typedef struct Place {
    char name[512];
} Place;
static hawser_status map_walk(const Walk *w, const CaseNode *map, const CaseSection *section, const Place *place);

/* Whether a map's keys are names that the user chooses, each with the section's keys below it. */
static int is_named(const CaseSection *section)
{
    const char *const last = strrchr(section->path, '.');
    return last && strcmp(last, ".NAME") == 0;
}

/* A step that `--set` can take: a name with a dot in it would be taken apart. */
static int step_add(Place *to, const Place *from, const char *step)
{
    char quoted[VARIABLE_STEP_MAX];
    const int size = (int)sizeof to->name;
    return !strchr(step, '.') &&
           snprintf(to->name, sizeof to->name, "%s.%s", from->name, variable_step(step, quoted)) < size;
}

/* Whether no other item of the list has the name. */
static int is_sole(const CaseNode *list, const char *name)
{
    int n = 0;
    for (const CaseNode *item = list->first; item; item = item->next) {
        const CaseNode *const own = item->kind == NODE_MAP ? case_node_key(item, "name") : NULL;
        n += own && own->kind == NODE_TEXT && !strcmp(own->text, name);
    }
    return n <= 1;
}

/* An item of a list: by its name if it has one of its own, otherwise by its place. */
static int item_add(Place *to, const Place *from, const CaseNode *list, const CaseNode *item)
{
    char quoted[VARIABLE_STEP_MAX];
    const CaseNode *const own = case_node_key(item, "name");
    const int size = (int)sizeof to->name;
    if (own && own->kind == NODE_TEXT && *own->text && is_sole(list, own->text))
        return snprintf(to->name, sizeof to->name, "%s.%s", from->name, variable_step(own->text, quoted)) < size;
    return snprintf(to->name, sizeof to->name, "%s[%d]", from->name, item->index + 1) < size;
}

static hawser_status items_walk(const Walk *w, const CaseNode *node, const CaseSection *section, const Place *place)
{
    Place inner;
    hawser_status status = HAWSER_OK;
    if (node->count > LIST_MAX) return status;
    for (const CaseNode *item = node->first; item && !status; item = item->next) {
        if (item->kind != NODE_MAP) continue;
        if (item->key ? step_add(&inner, place, item->key) : item_add(&inner, place, node, item))
            status = map_walk(w, item, section, &inner);
    }
    return status;
}

static hawser_status map_walk(const Walk *w, const CaseNode *map, const CaseSection *section, const Place *place)
{
    Place inner;
    hawser_status status = HAWSER_OK;
    for (const CaseNode *child = map->first; child && !status; child = child->next) {
        const CaseKey *const key = case_key_of(section, child->key);
        if (!key || key->section == &case_output || !step_add(&inner, place, child->key)) continue;
        if (key->kind == KEY_NUMBER && child->kind == NODE_TEXT)
            status = number_add(w, child, section, key, inner.name);
        if (!key->section || child->kind == NODE_TEXT) continue;
        const int items = child->kind == NODE_LIST || is_named(key->section);
        status = items ? items_walk(w, child, key->section, &inner) : map_walk(w, child, key->section, &inner);
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
    hawser_status status = variable_add(v, &ramp, "time over which a changed input comes in", err, "inputs.ramp");
    if (!status) status = map_walk(&w, r.root, &case_top, &(Place){"case"});
    units_free(r.units);
    return status;
}
