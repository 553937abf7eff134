#include "io/yaml/yaml_tree.h"

#include <stdlib.h>
#include <string.h>
#include <yaml.h>

#include "core/base/error.h"

/* Far more than any case needs; what lies beyond is an accident or an attack. Aliases are expanded, so that
 * the number of nodes may be large however small the file is. */
enum { NODES_MAX = 500000, KEYS_MAX = 500, DEPTH_MAX = 24, ANCHORS_MAX = 1000, TAGS_MAX = 16 };

static const char TOO_DEEP[] = "nested too deeply, or an alias inside itself";

/* One document on its way into nodes. */
typedef struct Reading {
    yaml_document_t document;
    const char *origin;
    int lines; /* 0: line numbers mean nothing */
    int nodes;
    hawser_error *err;
} Reading;

/* libyaml counts from 0. */
static int line_of(const Reading *r, yaml_mark_t mark) { return r->lines ? (int)mark.line + 1 : 0; }

static hawser_status node_convert(Reading *r, int id, int depth, CaseNode **out);

/* Characters that would command a terminal when a name or title is printed; the ends of lines and tabs do not. */
static int has_control(const char *text)
{
    for (const char *c = text; *c; c++) {
        if (*c != '\n' && *c != '\t' && text_control_at(c)) return 1;
    }
    return 0;
}

/* The text of a map's key, malloc'ed into *key. */
static hawser_status key_convert(Reading *r, int id, const CaseNode *map, char **key, int *line)
{
    const yaml_node_t *node = yaml_document_get_node(&r->document, id);
    *line = line_of(r, node->start_mark);
    if (node->type != YAML_SCALAR_NODE)
        return case_text_error(r->err, r->origin, *line, "a key must be a plain word", NULL);
    const char *text = (const char *)node->data.scalar.value;
    if (!*text) return case_text_error(r->err, r->origin, *line, "a key is empty", NULL);
    if (has_control(text))
        return case_text_error(r->err, r->origin, *line,
                               "a control character, or one that turns or hides text, in a key", NULL);
    if (case_node_key(map, text))
        return case_text_error(r->err, r->origin, *line, "this key stands here twice: ", text);
    if (map->count >= KEYS_MAX) return case_text_error(r->err, r->origin, *line, "too many keys in one map", NULL);
    *key = strdup(text);
    return *key ? HAWSER_OK : error_memory(r->err);
}

/* The key's line counts for its value too: that is where people look. */
static hawser_status map_convert(Reading *r, const yaml_node_t *from, int depth, CaseNode *map)
{
    const yaml_node_pair_t *pair = from->data.mapping.pairs.start;
    for (; pair < from->data.mapping.pairs.top; pair++) {
        char *key = NULL;
        int line = 0;
        CaseNode *child = NULL;
        hawser_status status = key_convert(r, pair->key, map, &key, &line);
        if (!status) status = node_convert(r, pair->value, depth, &child);
        if (!child) {
            free(key);
            return status;
        }
        child->key = key;
        child->line = line;
        node_append(map, child);
    }
    return HAWSER_OK;
}

/* Items have the line at which they begin. */
static hawser_status list_convert(Reading *r, const yaml_node_t *from, int depth, CaseNode *list)
{
    const yaml_node_item_t *item = from->data.sequence.items.start;
    for (; item < from->data.sequence.items.top; item++) {
        CaseNode *child = NULL;
        const hawser_status status = node_convert(r, *item, depth, &child);
        if (status) return status;
        node_append(list, child);
    }
    return HAWSER_OK;
}

/* A text ends at its length, so that a NUL inside, which YAML's "\0" allows, must not pass for its end. */
static hawser_status text_convert(Reading *r, const yaml_node_t *from, CaseNode *text)
{
    const char *value = (const char *)from->data.scalar.value;
    if (strlen(value) != from->data.scalar.length)
        return case_text_error(r->err, r->origin, text->line, "a NUL character in a text", NULL);
    if (has_control(value))
        return case_text_error(r->err, r->origin, text->line,
                               "a control character, or one that turns or hides text, in a text", NULL);
    text->text = strdup(value);
    return text->text ? HAWSER_OK : error_memory(r->err);
}

/* Node `id` of the document with all below it. Aliases repeat what they stand for; the limits stop circles
 * and explosions. */
static hawser_status node_convert(Reading *r, int id, int depth, CaseNode **out)
{
    static const NodeKind kinds[] = {
        [YAML_SCALAR_NODE] = NODE_TEXT, [YAML_MAPPING_NODE] = NODE_MAP, [YAML_SEQUENCE_NODE] = NODE_LIST};
    const yaml_node_t *from = yaml_document_get_node(&r->document, id);
    const int line = line_of(r, from->start_mark);
    if (depth > DEPTH_MAX) return case_text_error(r->err, r->origin, line, TOO_DEEP, NULL);
    if (++r->nodes > NODES_MAX)
        return case_text_error(r->err, r->origin, line, "too many values, with aliases written out", NULL);
    CaseNode *node = node_new(kinds[from->type], r->origin, line);
    if (!node) return error_memory(r->err);
    hawser_status status = HAWSER_OK;
    if (node->kind == NODE_TEXT) status = text_convert(r, from, node);
    if (node->kind == NODE_MAP) status = map_convert(r, from, depth + 1, node);
    if (node->kind == NODE_LIST) status = list_convert(r, from, depth + 1, node);
    if (status) node = node_free(node);
    *out = node;
    return status;
}

/* The line, from 1, that holds byte `offset` of the text. */
static int line_at(const char *text, size_t offset)
{
    int line = 1;
    for (const char *p = text; *p && p < text + offset; p++) line += *p == '\n';
    return line;
}

/* libyaml's own message speaks of tokens here. */
static int indented_with_tab(const char *text, int line)
{
    for (; text && line > 1; line--) {
        text = strchr(text, '\n');
        if (text) text++;
    }
    return text && text[strspn(text, " ")] == '\t';
}

/* What libyaml has against the text. */
static hawser_status parser_complain(const Reading *r, const yaml_parser_t *parser, const char *text)
{
    /* libyaml does not always say that it has no memory: then there is no error at all */
    if (parser->error == YAML_MEMORY_ERROR || parser->error == YAML_NO_ERROR) return error_memory(r->err);
    int line = (int)parser->problem_mark.line + 1;
    if (parser->error == YAML_READER_ERROR) line = line_at(text, parser->problem_offset);
    if (indented_with_tab(text, line))
        return case_text_error(r->err, r->origin, line, "indented with a tab: YAML wants spaces", NULL);
    char place[CASE_PLACE_MAX];
    if (!r->lines) line = 0;
    error_set(r->err, HAWSER_ERR_INPUT, "%s: not YAML: %s%s%s%s", case_place(r->origin, line, place),
              parser->problem ? parser->problem : "cannot be read", parser->context ? " (" : "",
              parser->context ? parser->context : "", parser->context ? ")" : "");
    error_place(r->err, r->origin, line);
    return HAWSER_ERR_INPUT;
}

/* The document that must follow now: none. */
static hawser_status end_expect(Reading *r, yaml_parser_t *parser, const char *text)
{
    yaml_document_t second;
    if (!yaml_parser_load(parser, &second)) return parser_complain(r, parser, text);
    const yaml_node_t *root = yaml_document_get_root_node(&second);
    const hawser_status status = root ? case_text_error(r->err, r->origin, line_of(r, second.start_mark),
                                                        "a second document begins here: one is allowed", NULL)
                                      : HAWSER_OK;
    yaml_document_delete(&second);
    return status;
}

/* The encoding is fixed, so that junk cannot pass for UTF-16. 0 without memory. */
static int parser_start(yaml_parser_t *parser, const char *text, size_t size)
{
    if (!yaml_parser_initialize(parser)) return 0;
    yaml_parser_set_encoding(parser, YAML_UTF8_ENCODING);
    yaml_parser_set_input_string(parser, (const unsigned char *)text, size);
    return 1;
}

/* Anchors may stand at any value. */
static int event_has_anchor(const yaml_event_t *event)
{
    if (event->type == YAML_SCALAR_EVENT) return event->data.scalar.anchor != NULL;
    if (event->type == YAML_MAPPING_START_EVENT) return event->data.mapping_start.anchor != NULL;
    return event->type == YAML_SEQUENCE_START_EVENT && event->data.sequence_start.anchor != NULL;
}

/* %TAG lines; libyaml compares each with all before it. */
static int tags_count(const char *text)
{
    int n = 0;
    for (const char *p = strstr(text, "%TAG"); p && n <= TAGS_MAX; p = strstr(p + 1, "%TAG")) {
        n += p == text || p[-1] == '\n';
    }
    return n;
}

/* Refuses what libyaml would load in a time that grows with the square of its size: deep nesting, many anchors, many
 * tags. Other mistakes are left to the loading. */
static hawser_status size_check(const Reading *r, const char *text, size_t size)
{
    yaml_parser_t parser;
    yaml_event_t event;
    hawser_status status = HAWSER_OK;
    int depth = 0, anchors = 0, end = 0;
    if (tags_count(text) > TAGS_MAX) return case_text_error(r->err, r->origin, r->lines, "too many tags", NULL);
    if (!parser_start(&parser, text, size)) return error_memory(r->err);
    while (!status && !end && yaml_parser_parse(&parser, &event)) {
        const int opens = event.type == YAML_SEQUENCE_START_EVENT || event.type == YAML_MAPPING_START_EVENT;
        const int closes = event.type == YAML_SEQUENCE_END_EVENT || event.type == YAML_MAPPING_END_EVENT;
        const int line = line_of(r, event.start_mark);
        depth += opens - closes;
        anchors += event_has_anchor(&event);
        end = event.type == YAML_STREAM_END_EVENT || event.type == YAML_NO_EVENT;
        if (depth > DEPTH_MAX) status = case_text_error(r->err, r->origin, line, TOO_DEEP, NULL);
        if (anchors > ANCHORS_MAX) status = case_text_error(r->err, r->origin, line, "too many anchors", NULL);
        yaml_event_delete(&event);
    }
    yaml_parser_delete(&parser);
    return status;
}

/* The root is libyaml's node 1. */
hawser_status yaml_read(const char *text, size_t size, const char *origin, int lines, CaseNode **out, hawser_error *err)
{
    Reading r = {.origin = origin, .lines = lines, .err = err};
    yaml_parser_t parser;
    *out = NULL;
    hawser_status status = size_check(&r, text, size);
    if (status) return status;
    if (!parser_start(&parser, text, size)) return error_memory(err);
    if (!yaml_parser_load(&parser, &r.document)) {
        status = parser_complain(&r, &parser, text);
    } else {
        const int empty = !yaml_document_get_root_node(&r.document);
        if (empty) status = case_text_error(err, origin, lines, "nothing is in it", NULL);
        if (!status) status = node_convert(&r, 1, 0, out);
        if (!status) status = end_expect(&r, &parser, text);
        yaml_document_delete(&r.document);
    }
    yaml_parser_delete(&parser);
    if (status) *out = node_free(*out);
    return status;
}
