/* Text to tree, and the tree walked through. */
#include <stdlib.h>
#include <string.h>

#include "io/case/yaml.h"
#include "tests/fuzz/fuzz.h"

/* Nodes below and at this one; every link checked on the way. */
static long walk(const CaseNode *node)
{
    long n = 1;
    int children = 0;
    char path[CASE_PATH_MAX];
    case_path(node, NULL, path);
    FUZZ_MUST(strlen(path) < sizeof path);
    FUZZ_MUST((node->kind == NODE_TEXT) == (node->text != NULL));
    for (const CaseNode *child = node->first; child; child = child->next, ++children) {
        FUZZ_MUST(child->parent == node && child->index == children);
        FUZZ_MUST((node->kind == NODE_MAP) == (child->key != NULL));
        FUZZ_MUST(child->next || child == node->last);
        n += walk(child);
    }
    FUZZ_MUST(children == node->count);
    return n;
}

FUZZ_TARGET(yaml)
{
    char *const text = fuzz_text(data, size);
    CaseTree *tree = NULL;
    hawser_error err = {0};
    const hawser_status status = case_tree_parse(text, "fuzz.yaml", &tree, &err);
    if (status) {
        FUZZ_MUST(!tree && fuzz_error_is_good((int)status, err.message));
    } else {
        FUZZ_MUST(tree->root->kind == NODE_MAP && walk(tree->root) >= 1);
    }
    case_tree_free(tree);
    free(text);
    return 0;
}
