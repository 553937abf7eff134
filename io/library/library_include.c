/* `include`: files of the user's own, each relative to the file that names it. */
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "io/library/library.h"

enum { PATH_ROOM = 4096 };

/* A file that has been met, by what it is, not by how it is called. */
typedef struct Met {
    dev_t device;
    ino_t inode;
    int open; /* its own includes are being read: to meet it again is a circle */
} Met;

typedef struct Including {
    Library *library;
    Met met[LIBRARY_FILES_MAX];
    int n;
    hawser_error *err;
} Including;

static hawser_status files_read(Including *in, const CaseTree *from, int depth);

/* What is wrong with a path before it is opened; nothing that is no plain file is ever opened. */
static hawser_status path_check(const Including *in, const CaseNode *node, const char *path, struct stat *is)
{
    if (stat(path, is) != 0) return case_value_error(in->err, node, ": '%s' cannot be read: %s", path, strerror(errno));
    if (!S_ISREG(is->st_mode)) return case_value_error(in->err, node, ": '%s' is not a file", path);
    if (is->st_size > LIBRARY_FILE_BYTES) {
        return case_value_error(in->err, node, ": '%s' is too large: at most %d MiB", path, LIBRARY_FILE_BYTES >> 20);
    }
    return HAWSER_OK;
}

/* One file and what it includes in turn; one that has been read already is not read again. */
static hawser_status file_read(Including *in, const CaseTree *from, const CaseNode *node, int depth)
{
    char path[PATH_ROOM];
    struct stat is;
    if (node->kind != NODE_TEXT || !*node->text)
        return case_value_error(in->err, node, ": expected the name of a file");
    if (!from->folder) {
        return case_value_error(in->err, node, ": a case that is a text has no folder to look in: load it from a file");
    }
    const int absolute = node->text[0] == '/';
    const int length =
        snprintf(path, sizeof path, "%s%s%s", absolute ? "" : from->folder, absolute ? "" : "/", node->text);
    if (length >= PATH_ROOM) return case_value_error(in->err, node, " is too long a path");
    if (depth > LIBRARY_DEPTH_MAX)
        return case_value_error(in->err, node, ": too deep: at most %d files in each other", LIBRARY_DEPTH_MAX);
    hawser_status status = path_check(in, node, path, &is);
    for (int i = 0; i < in->n && !status; i++) {
        if (in->met[i].device != is.st_dev || in->met[i].inode != is.st_ino) continue;
        return in->met[i].open ? case_value_error(in->err, node, ": a circle: '%s' includes itself", path) : HAWSER_OK;
    }
    if (!status && in->n == LIBRARY_FILES_MAX)
        status = case_value_error(in->err, node, ": too many files: at most %d", LIBRARY_FILES_MAX);
    if (status) return status;
    Met *const met = &in->met[in->n++];
    CaseTree *file = NULL;
    *met = (Met){is.st_dev, is.st_ino, 1};
    status = library_read(in->library, path, 0, &file, in->err);
    if (!status) status = files_read(in, file, depth + 1);
    met->open = 0;
    return status;
}

/* A name, or a list of them. */
static hawser_status files_read(Including *in, const CaseTree *from, int depth)
{
    const CaseNode *const node = case_node_key(from->root, "include");
    if (!node) return HAWSER_OK;
    if (node->kind == NODE_MAP)
        return case_value_error(in->err, node, ": expected a list of files, as in [my-cables.yaml]");
    if (node->kind == NODE_TEXT) return file_read(in, from, node, depth);
    hawser_status status = HAWSER_OK;
    for (const CaseNode *item = node->first; item && !status; item = item->next)
        status = file_read(in, from, item, depth);
    return status;
}

hawser_status library_include(Library *library, const CaseTree *tree, hawser_error *err)
{
    Including in = {.library = library, .err = err};
    return files_read(&in, tree, 1);
}
