/* A tree as a document again, JSON with nothing but texts, which is YAML, too: the same values under the same keys,
 * without the places where they were written. */
#include "io/yaml/yaml_tree.h"

#include "core/base/error.h"

#include <stdio.h>
#include <stdlib.h>

static void text_put(FILE *out, const char *text)
{
    fputc('"', out);
    for (const unsigned char *c = (const unsigned char *)text; *c; c++) {
        if (*c == '"' || *c == '\\') {
            fprintf(out, "\\%c", *c);
        } else if (*c < ' ') {
            fprintf(out, "\\u%04x", *c);
        } else {
            fputc(*c, out);
        }
    }
    fputc('"', out);
}

/* Recursion is as deep as the tree. */
static void node_put(FILE *out, const CaseNode *node)
{
    if (node->kind == NODE_TEXT) {
        text_put(out, node->text ? node->text : "");
        return;
    }
    fputs(node->kind == NODE_MAP ? "{" : "[", out);
    for (const CaseNode *child = node->first; child; child = child->next) {
        if (node->kind == NODE_MAP) text_put(out, child->key);
        if (node->kind == NODE_MAP) fputs(": ", out);
        node_put(out, child);
        if (child->next) fputs(",\n", out);
    }
    fputs(node->kind == NODE_MAP ? "}" : "]", out);
}

hawser_status case_node_text(const CaseNode *node, char **text, hawser_error *err)
{
    size_t size;
    *text = NULL;
    FILE *const out = open_memstream(text, &size);
    if (!out) return error_memory(err);
    node_put(out, node);
    fputc('\n', out);
    if (!fclose(out) && *text) return HAWSER_OK;
    free(*text);
    *text = NULL;
    return error_memory(err);
}
