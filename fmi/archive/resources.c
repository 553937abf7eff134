/* The case with everything that it refers to: the catalogue's entries take their places in it, files lie beside it. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "fmi/archive/archive.h"
#include "io/library/library.h"

/* Where a case names files to read: docs/case-format.md. */
static const char *const file_keys[RESOURCE_FILES_MAX][3] = {
    {"route", "file", NULL}, {"route", "profile", "file"}, {"drawing", "file", NULL}};

/* The file of a node goes along under a name of its own, and the node names that. */
static hawser_status file_take(const CaseTree *tree, CaseNode *node, Resources *out, hawser_error *err)
{
    const char *const slash = strrchr(node->text, '/'), *const base = slash ? slash + 1 : node->text;
    const int absolute = *node->text == '/';
    ResourceFile *const file = &out->file[out->n];
    const size_t size = strlen(node->text) + strlen(tree->folder ? tree->folder : "") + 16;
    file->path = malloc(size);
    file->name = malloc(size);
    ++out->n;
    if (!file->path || !file->name) return error_memory(err);
    snprintf(file->path, size, "%s%s%s", absolute || !tree->folder ? "" : tree->folder,
             absolute || !tree->folder ? "" : "/", node->text);
    snprintf(file->name, size, "%d-%s", out->n, base);
    char *const name = strdup(file->name);
    if (!name) return error_memory(err);
    free(node->text);
    node->text = name;
    return HAWSER_OK;
}

static hawser_status files_take(const CaseTree *tree, const CaseNode *root, Resources *out, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int i = 0; i < RESOURCE_FILES_MAX && !status; ++i) {
        const CaseNode *node = root;
        for (int k = 0; k < 3 && file_keys[i][k]; ++k) node = case_node_key(node, file_keys[i][k]);
        if (node && node->kind == NODE_TEXT) status = file_take(tree, (CaseNode *)(size_t)node, out, err);
    }
    return status;
}

hawser_status resources_make(const CaseTree *tree, Resources *out, hawser_error *err)
{
    CaseNode *root = NULL;
    Library *library = NULL;
    *out = (Resources){.n = 0};
    hawser_status status = library_expand(tree, &root, &library, err);
    if (!status && !root && !(root = node_clone(tree->root, NULL))) status = error_memory(err);
    if (!status) status = files_take(tree, root, out, err);
    if (!status) yaml_write(root, 0, &out->text);
    if (!status && out->text.failed) status = error_memory(err);
    node_free(root);
    library_free(library);
    return status;
}

void resources_clear(Resources *r)
{
    for (int i = 0; i < r->n; ++i) {
        free(r->file[i].path);
        free(r->file[i].name);
    }
    text_clear(&r->text);
    *r = (Resources){.n = 0};
}
