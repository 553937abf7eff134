/* A case in today's words: keys by their own names and the number of the format, as edits of the text, so that comments
 * and layout stay. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

#include "core/base/error.h"
#include "io/case/case_parts.h"

/* What replaces bytes `from` to `to`. */
typedef struct Edit {
    size_t from, to;
    char by[96];
} Edit;

typedef struct Edits {
    const char *mark, *text, *name; /* borrowed; mark: of the byte order, or nothing, before the text */
    yaml_document_t document;
    Units *units;
    int n;
    Edit *edit; /* [n] */
    hawser_error *err;
} Edits;

/* The byte at which a mark stands: libyaml counts characters. */
static size_t byte_at(const char *text, size_t character)
{
    const char *at = text;
    for (; *at && (character > 0 || (*at & 0xC0) == 0x80); ++at) character -= (*at & 0xC0) != 0x80;
    return (size_t)(at - text);
}

static hawser_status edit_add(Edits *e, size_t from, size_t to, const char *by)
{
    Edit *const more = realloc(e->edit, ((size_t)e->n + 1) * sizeof *more);
    if (!more) return error_memory(e->err);
    e->edit = more;
    e->edit[e->n] = (Edit){.from = from, .to = to};
    snprintf(e->edit[e->n++].by, sizeof e->edit->by, "%s", by);
    return HAWSER_OK;
}

/* The pair of a map by its key; NULL: there is none, or it is no map. */
static const yaml_node_pair_t *pair_of(Edits *e, const yaml_node_t *map, const char *key)
{
    if (!map || map->type != YAML_MAPPING_NODE) return NULL;
    for (const yaml_node_pair_t *p = map->data.mapping.pairs.start; p < map->data.mapping.pairs.top; ++p) {
        const yaml_node_t *const node = yaml_document_get_node(&e->document, p->key);
        if (node->type == YAML_SCALAR_NODE && !strcmp((const char *)node->data.scalar.value, key)) return p;
    }
    return NULL;
}

static const yaml_node_t *value_of(Edits *e, const yaml_node_t *map, const char *key)
{
    const yaml_node_pair_t *const pair = pair_of(e, map, key);
    return pair ? yaml_document_get_node(&e->document, pair->value) : NULL;
}

/* A scalar that stands in one line, in the quotes that it has. 0: it does not, or only another name of it does. */
static int scalar_edit(Edits *e, const yaml_node_t *node, const char *by, hawser_status *status)
{
    const char *const quote = node->data.scalar.style == YAML_DOUBLE_QUOTED_SCALAR_STYLE   ? "\""
                              : node->data.scalar.style == YAML_SINGLE_QUOTED_SCALAR_STYLE ? "'"
                                                                                           : "";
    char quoted[96];
    if (node->type != YAML_SCALAR_NODE || node->start_mark.line != node->end_mark.line) return 0;
    snprintf(quoted, sizeof quoted, "%s%s%s", quote, by, quote);
    *status = edit_add(e, byte_at(e->text, node->start_mark.index), byte_at(e->text, node->end_mark.index), quoted);
    return 1;
}

/* One key of one item. */
static hawser_status item_edit(Edits *e, const Synonym *s, const yaml_node_pair_t *pair)
{
    const yaml_node_t *const key = yaml_document_get_node(&e->document, pair->key), *const value =
                                                                                        yaml_document_get_node(
                                                                                            &e->document, pair->value);
    char half[64];
    hawser_status status = HAWSER_OK;
    int fits = scalar_edit(e, key, s->key, &status);
    if (!status && fits && s->half)
        fits = value->type == YAML_SCALAR_NODE && value->start_mark.index >= key->end_mark.index &&
               units_half(e->units, (const char *)value->data.scalar.value, half, sizeof half) &&
               scalar_edit(e, value, half, &status);
    if (!status && !fits)
        status = error_set(e->err, HAWSER_ERR_INPUT, "%s:%d: '%s' cannot be rewritten: expected a %s that stands there",
                           e->name, (int)key->start_mark.line + 1, s->other, s->half ? "length" : "value");
    return status;
}

static hawser_status synonym_edit(Edits *e, const Synonym *s)
{
    const yaml_node_t *const list =
        value_of(e, value_of(e, yaml_document_get_root_node(&e->document), s->section), s->list);
    hawser_status status = HAWSER_OK;
    if (!list || list->type != YAML_SEQUENCE_NODE) return status;
    for (const yaml_node_item_t *i = list->data.sequence.items.start; i < list->data.sequence.items.top && !status;
         ++i) {
        const yaml_node_pair_t *const pair = pair_of(e, yaml_document_get_node(&e->document, *i), s->other);
        if (pair) status = item_edit(e, s, pair);
    }
    return status;
}

/* The format's number stands before all other keys. */
static hawser_status format_edit(Edits *e)
{
    const yaml_node_t *const root = yaml_document_get_root_node(&e->document), *const first = yaml_document_get_node(
                                                                                   &e->document,
                                                                                   root->data.mapping.pairs.start->key);
    const char *const newline = strchr(e->text, '\n'), *const end = newline && newline > e->text && newline[-1] == '\r'
                                                                        ? "\r\n"
                                                                        : "\n";
    char line[96];
    if (pair_of(e, root, "format")) return HAWSER_OK;
    const size_t at = byte_at(e->text, first->start_mark.index);
    if (root->data.mapping.style == YAML_FLOW_MAPPING_STYLE)
        snprintf(line, sizeof line, "format: %d, ", CASE_FORMAT);
    else
        snprintf(line, sizeof line, "format: %d%s%*s", CASE_FORMAT, end, (int)(first->start_mark.column % 40), "");
    return edit_add(e, at, at, line);
}

static int compare_edits(const void *a, const void *b)
{
    const size_t x = ((const Edit *)a)->from, y = ((const Edit *)b)->from;
    return (x > y) - (x < y);
}

static char *edited(const Edits *e)
{
    const size_t mark = (size_t)(e->text - e->mark);
    char *const out = malloc(strlen(e->mark) + (size_t)e->n * sizeof e->edit->by + 1), *at = out ? out + mark : NULL;
    size_t from = 0;
    if (out) memcpy(out, e->mark, mark);
    for (int i = 0; out && i < e->n; ++i) {
        if (e->edit[i].from < from) continue; /* an item that stands for several is found several times */
        memcpy(at, e->text + from, e->edit[i].from - from);
        at = stpcpy(at + (e->edit[i].from - from), e->edit[i].by);
        from = e->edit[i].to;
    }
    if (out) strcpy(at, e->text + from);
    return out;
}

static hawser_status edits_find(Edits *e)
{
    hawser_status status = HAWSER_OK;
    const Synonym *s;
    for (int i = 0; !status && (s = case_synonym(i)); ++i) status = synonym_edit(e, s);
    if (!status) status = format_edit(e);
    if (e->n > 0) qsort(e->edit, (size_t)e->n, sizeof *e->edit, compare_edits);
    return status;
}

hawser_status case_upgrade(const char *text, const char *name, char **out, int *changes, hawser_error *err)
{
    CaseTree *tree = NULL;
    yaml_parser_t parser;
    Edits e = {.mark = text, .text = text, .name = name, .units = units_new(), .err = err};
    *out = NULL;
    hawser_status status = e.units ? case_tree_parse(text, name, &tree, err) : error_memory(err); /* it is sound */
    case_tree_free(tree);
    if (!status && !yaml_parser_initialize(&parser)) status = error_memory(err);
    if (!status) {
        yaml_parser_set_encoding(&parser, YAML_UTF8_ENCODING);
        if (strncmp(text, "\xef\xbb\xbf", 3) == 0) e.text += 3;
        yaml_parser_set_input_string(&parser, (const unsigned char *)e.text, strlen(e.text));
        if (yaml_parser_load(&parser, &e.document)) {
            status = edits_find(&e);
            if (!status) *out = edited(&e);
            if (!status && !*out) status = error_memory(err);
            if (!status) status = case_tree_parse(*out, name, &tree, err); /* it still is a case */
            if (!status) case_tree_free(tree);
            if (status) {
                free(*out);
                *out = NULL;
            }
            yaml_document_delete(&e.document);
        } else {
            status = error_memory(err);
        }
        yaml_parser_delete(&parser);
    }
    *changes = e.n;
    free(e.edit);
    units_free(e.units);
    return status;
}
