/* Edits of a case's text, so that comments and layout stay: today's words (keys by their own names and the number of
 * the format), and more items in a list. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

#include "core/base/error.h"
#include "io/case/case_parts.h"

/* What replaces bytes `from` to `to`. */
typedef struct Edit {
    size_t from, to;
    char *by; /* owned */
} Edit;

typedef struct Edits {
    const char *mark, *text, *name; /* borrowed; mark: of the byte order, or nothing, before the text */
    yaml_document_t document;
    Units *units;
    int n;
    Edit *edit;       /* [n] */
    const char *list; /* of the section `theory`, to get more items: */
    int n_rows;
    char *const *row; /* [n_rows] */
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
    e->edit[e->n] = (Edit){from, to, strdup(by)};
    return e->edit[e->n++].by ? HAWSER_OK : error_memory(e->err);
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

static const char *line_end(const Edits *e)
{
    const char *const newline = strchr(e->text, '\n');
    return newline && newline > e->text && newline[-1] == '\r' ? "\r\n" : "\n";
}

/* The format's number stands before all other keys. */
static hawser_status format_edit(Edits *e)
{
    const yaml_node_t *const root = yaml_document_get_root_node(&e->document), *const first = yaml_document_get_node(
                                                                                   &e->document,
                                                                                   root->data.mapping.pairs.start->key);
    char line[96];
    if (pair_of(e, root, "format")) return HAWSER_OK;
    const size_t at = byte_at(e->text, first->start_mark.index);
    if (root->data.mapping.style == YAML_FLOW_MAPPING_STYLE)
        snprintf(line, sizeof line, "format: %d, ", CASE_FORMAT);
    else
        snprintf(line, sizeof line, "format: %d%s%*s", CASE_FORMAT, line_end(e), (int)(first->start_mark.column % 40),
                 "");
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
    size_t from = 0, size = strlen(e->mark) + 1;
    for (int i = 0; i < e->n; ++i) size += strlen(e->edit[i].by);
    char *const out = malloc(size), *at = out ? out + mark : NULL;
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

static hawser_status upgrades_find(Edits *e)
{
    hawser_status status = HAWSER_OK;
    const Synonym *s;
    for (int i = 0; !status && (s = case_synonym(i)); ++i) status = synonym_edit(e, s);
    return status ? status : format_edit(e);
}

/* ------------------------------------------------------------------------------------------------- more items */

/* "before row between row behind". */
static char *rows_join(const Edits *e, const char *before, const char *first, const char *between, const char *behind)
{
    size_t size = strlen(before) + strlen(behind) + 1;
    for (int i = 0; i < e->n_rows; ++i) size += strlen(first) + strlen(between) + strlen(e->row[i]);
    char *const text = malloc(size), *at = text;
    if (!text) return NULL;
    at = stpcpy(at, before);
    for (int i = 0; i < e->n_rows; ++i) at = stpcpy(stpcpy(stpcpy(at, i ? between : ""), first), e->row[i]);
    strcpy(at, behind);
    return text;
}

static hawser_status rows_put(Edits *e, size_t at, const char *before, const char *first, const char *between,
                              const char *behind)
{
    char *const text = rows_join(e, before, first, between, behind);
    const hawser_status status = text ? edit_add(e, at, at, text) : error_memory(e->err);
    free(text);
    return status;
}

static int is_flow(const yaml_node_t *node)
{
    return node->type == YAML_MAPPING_NODE ? node->data.mapping.style == YAML_FLOW_MAPPING_STYLE
                                           : node->data.sequence.style == YAML_FLOW_SEQUENCE_STYLE;
}

/* A list that is there gets them before its first item, a map that has none a new one before its first key, a case
 * without the map both at its end. */
static hawser_status rows_find(Edits *e)
{
    const yaml_node_t *const root = yaml_document_get_root_node(&e->document), *const map = value_of(e, root, "theory"),
                             *const list = value_of(e, map, e->list);
    const char *const end = line_end(e);
    char before[96], behind[96];
    if (list && list->type == YAML_SEQUENCE_NODE) {
        const size_t at = byte_at(e->text, list->start_mark.index);
        const int items = list->data.sequence.items.top > list->data.sequence.items.start;
        if (is_flow(list)) return rows_put(e, at + 1, "", "", ", ", items ? ", " : "");
        snprintf(behind, sizeof behind, "%s%*s", end, (int)(list->start_mark.column % 40), "");
        return rows_put(e, at, "", "- ", behind, behind);
    }
    if (!list && map && map->type == YAML_MAPPING_NODE) {
        const int keys = map->data.mapping.pairs.top > map->data.mapping.pairs.start;
        snprintf(before, sizeof before, "%.40s: [", e->list);
        if (is_flow(map))
            return rows_put(e, byte_at(e->text, map->start_mark.index) + 1, before, "", ", ", keys ? "], " : "]");
        snprintf(behind, sizeof behind, "]%s%*s", end, (int)(map->start_mark.column % 40), "");
        return rows_put(e, byte_at(e->text, map->start_mark.index), before, "", ", ", behind);
    }
    if (!map && !pair_of(e, root, "theory") && !is_flow(root)) {
        const size_t size = strlen(e->text), column = root->start_mark.column % 40;
        char first[96];
        snprintf(before, sizeof before, "%s%s%*stheory:%s%*s%.40s:%s", size && e->text[size - 1] == '\n' ? "" : end,
                 end, (int)column, "", end, (int)column + 2, "", e->list, end);
        snprintf(first, sizeof first, "%*s- ", (int)column + 4, "");
        return rows_put(e, size, before, first, end, end);
    }
    if (!map && !pair_of(e, root, "theory")) {
        snprintf(before, sizeof before, "theory: {%.40s: [", e->list);
        return rows_put(e, byte_at(e->text, root->start_mark.index) + 1, before, "", ", ", "]}, ");
    }
    return error_set(e->err, HAWSER_ERR_INPUT, "%s: key 'theory': nothing can be written into it as it stands",
                     e->name);
}

/* Edits that are found in a case's text, made; the text is a case before and after. */
static hawser_status edits_make(Edits *e, hawser_status (*find)(Edits *e), char **out)
{
    CaseTree *tree = NULL;
    yaml_parser_t parser;
    *out = NULL;
    hawser_status status = e->units ? case_tree_parse(e->text, e->name, &tree, e->err) : error_memory(e->err);
    case_tree_free(tree);
    if (!status && !yaml_parser_initialize(&parser)) status = error_memory(e->err);
    if (!status) {
        yaml_parser_set_encoding(&parser, YAML_UTF8_ENCODING);
        if (strncmp(e->text, "\xef\xbb\xbf", 3) == 0) e->text += 3;
        yaml_parser_set_input_string(&parser, (const unsigned char *)e->text, strlen(e->text));
        if (yaml_parser_load(&parser, &e->document)) {
            status = find(e);
            if (e->n > 0) qsort(e->edit, (size_t)e->n, sizeof *e->edit, compare_edits);
            if (!status) *out = edited(e);
            if (!status && !*out) status = error_memory(e->err);
            if (!status) status = case_tree_parse(*out, e->name, &tree, e->err);
            if (!status) case_tree_free(tree);
            if (status) {
                free(*out);
                *out = NULL;
            }
            yaml_document_delete(&e->document);
        } else {
            status = error_memory(e->err);
        }
        yaml_parser_delete(&parser);
    }
    for (int i = 0; i < e->n; ++i) free(e->edit[i].by);
    free(e->edit);
    units_free(e->units);
    return status;
}

hawser_status case_upgrade(const char *text, const char *name, char **out, int *changes, hawser_error *err)
{
    Edits e = {.mark = text, .text = text, .name = name, .units = units_new(), .err = err};
    const hawser_status status = edits_make(&e, upgrades_find, out);
    *changes = e.n;
    return status;
}

hawser_status case_theory_insert(const char *text, const char *name, const char *list, int n, char *const row[],
                                 char **out, hawser_error *err)
{
    Edits e = {.mark = text,
               .text = text,
               .name = name,
               .units = units_new(),
               .list = list,
               .n_rows = n,
               .row = row,
               .err = err};
    return edits_make(&e, rows_find, out);
}
