#include <string.h>

#include "fmi/archive/archive.h"

/* Letters of a text that needs no quotes, if the first is a letter or digit and the last no blank. */
static const char PLAIN[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 ._/+^-";

static void scalar_write(const char *text, Text *out)
{
    const size_t n = strlen(text);
    const int plain =
        n > 0 && strspn(text, PLAIN) == n && strspn(text, PLAIN) > 0 && !strchr(" ._/+^-", *text) && text[n - 1] != ' ';
    if (plain) text_add(out, text);
    if (plain) return;
    text_add(out, "\"");
    for (const char *c = text; *c; ++c) {
        if (*c == '"' || *c == '\\')
            text_print(out, "\\%c", *c);
        else if ((unsigned char)*c < ' ')
            text_print(out, "\\x%02x", (unsigned char)*c);
        else
            text_bytes(out, c, 1);
    }
    text_add(out, "\"");
}

/* What the case no longer needs: its catalogue and the files with catalogues of the user's. */
static int is_spent(const CaseNode *child)
{
    if (!child->key) return 0;
    if (strcmp(child->key, "include") == 0 && child->parent && !child->parent->parent) return 1;
    return strcmp(child->key, "type") == 0 && child->kind == NODE_TEXT;
}

void yaml_write(const CaseNode *node, int depth, Text *out)
{
    if (node->kind == NODE_TEXT || !node->first) {
        text_add(out, depth > 0 ? " " : "");
        if (node->kind == NODE_TEXT) scalar_write(node->text, out);
        text_add(out, node->kind == NODE_MAP ? "{}\n" : node->kind == NODE_LIST ? "[]\n" : "\n");
        return;
    }
    if (depth > 0) text_add(out, "\n");
    for (const CaseNode *child = node->first; child; child = child->next) {
        if (is_spent(child)) continue;
        text_print(out, "%*s", 2 * depth, "");
        if (child->key) scalar_write(child->key, out);
        text_add(out, child->key ? ":" : "-");
        yaml_write(child, depth + 1, out);
    }
}
