/* Keys by the other names that people type, in the tree before it is read: a duct's diameter for its radius, a bend's
 * angle, a straight's length. */
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "io/case/case_parts.h"

static const Synonym synonyms[] = {
    {"surfaces", "ducts", "diameter", "radius", 1},        {"surfaces", "ducts", "inner diameter", "radius", 1},
    {"surfaces", "ducts", "inner_diameter", "radius", 1},  {"surfaces", "ducts", "inside diameter", "radius", 1},
    {"surfaces", "ducts", "inside_diameter", "radius", 1}, {"route", "pieces", "angle", "bend", 0},
    {"route", "pieces", "length", "straight", 0},          {"route", "pieces", "turn", "plane", 0},
};
enum { SYNONYMS = sizeof synonyms / sizeof *synonyms };

const Synonym *case_synonym(int i) { return i < SYNONYMS ? &synonyms[i] : NULL; }

/* Gives a node of the tree its key's own name. */
static hawser_status rename_node(const Units *units, const Synonym *s, CaseNode *node, hawser_error *err)
{
    char half[64];
    if (case_node_key(node->parent, s->key))
        return case_key_error(err, node, NULL, "'%s' says the same: give one of the two", s->key);
    if (s->half) {
        if (node->kind != NODE_TEXT || !units_half(units, node->text, half, sizeof half))
            return case_value_error(err, node, ": expected a length, such as 100 mm");
        char *const text = strdup(half);
        if (!text) return error_memory(err);
        free(node->text);
        node->text = text;
    }
    char *const key = strdup(s->key);
    if (!key) return error_memory(err);
    free(node->key);
    node->key = key;
    return HAWSER_OK;
}

/* One synonym in all items of its list; *met counts them. */
static hawser_status synonym_apply(const Units *units, const Synonym *s, const CaseNode *root, int change, int *met,
                                   hawser_error *err)
{
    const CaseNode *const list = case_node_key(case_node_key(root, s->section), s->list);
    hawser_status status = HAWSER_OK;
    for (const CaseNode *item = list ? list->first : NULL; item && !status; item = item->next) {
        CaseNode *const node = (CaseNode *)(size_t)case_node_key(item, s->other);
        if (!node) continue;
        ++*met;
        if (change) status = rename_node(units, s, node, err);
    }
    return status;
}

hawser_status case_synonyms(const CaseTree *tree, CaseTree **plain, hawser_error *err)
{
    int met = 0;
    hawser_status status = HAWSER_OK;
    *plain = NULL;
    for (int i = 0; i < SYNONYMS; ++i) synonym_apply(NULL, &synonyms[i], tree->root, 0, &met, err);
    if (!met) return HAWSER_OK;
    Units *const units = units_new();
    *plain = case_tree_copy(tree);
    if (!units || !*plain) status = error_memory(err);
    if (!status) (*plain)->unlisted = tree->unlisted;
    for (int i = 0; i < SYNONYMS && !status; ++i)
        status = synonym_apply(units, &synonyms[i], (*plain)->root, 1, &met, err);
    units_free(units);
    if (status) *plain = case_tree_free(*plain);
    return status;
}
