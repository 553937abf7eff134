#include "io/library/library.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"

const char *const library_kinds[] = {"cables", "ropes", "rollers", "ducts", "friction", "reels", NULL};

/* What may stand beside the kinds at the top of a file. */
static const char *const top_keys[] = {"cables",   "ropes", "rollers", "ducts",
                                       "friction", "reels", "sources", "include"};
static const char *const about_keys[] = {"source", "range", "mark", "note", NULL};
static const char *const marks[] = {"typical", "estimated", NULL};

Library *library_new(void) { return calloc(1, sizeof(Library)); }

Library *library_free(Library *library)
{
    if (!library) return NULL;
    for (int i = 0; i < library->n_files; i++) case_tree_free(library->file[i]);
    free(library->entry);
    free(library);
    return NULL;
}

static int place_of(const char *word, const char *const *words)
{
    for (int i = 0; words[i]; i++) {
        if (strcmp(word, words[i]) == 0) return i;
    }
    return -1;
}

int library_about(const char *key) { return place_of(key, about_keys) >= 0; }

/* Cables and ropes are looked for together, so that no name may be both. */
static unsigned space_of(LibraryKind kind)
{
    const unsigned lines = 1u << LIBRARY_CABLES | 1u << LIBRARY_ROPES, own = 1u << kind;
    return own & lines ? lines : own;
}

/* Linear: a library has some hundred entries, a case some dozen types. */
static const LibraryEntry *find_from(const Library *library, unsigned kinds, const char *name, int shipped)
{
    for (int i = 0; i < library->n_entries; i++) {
        const LibraryEntry *const e = &library->entry[i];
        if (e->shipped == shipped && kinds >> e->kind & 1 && strcmp(e->name, name) == 0) return e;
    }
    return NULL;
}

const LibraryEntry *library_find(const Library *library, unsigned kinds, const char *name)
{
    const LibraryEntry *const own = find_from(library, kinds, name, 0);
    return own ? own : find_from(library, kinds, name, 1);
}

/* The three nearest, the nearest first. */
void library_near(const Library *library, unsigned kinds, const char *name, size_t room, char *text)
{
    const char *near[3] = {NULL, NULL, NULL};
    int distance[3] = {0, 0, 0};
    for (int i = 0; i < library->n_entries; i++) {
        const LibraryEntry *const e = &library->entry[i];
        if (!(kinds >> e->kind & 1)) continue;
        const int d = case_distance(name, e->name);
        int at = 3;
        while (at > 0 && (!near[at - 1] || d < distance[at - 1])) at--;
        for (int k = 2; k > at; k--) near[k] = near[k - 1], distance[k] = distance[k - 1];
        if (at < 3) near[at] = e->name, distance[at] = d;
    }
    size_t used = 0;
    *text = 0;
    for (int k = 0; k < 3 && near[k] && used < room; k++) {
        const char *const before = k == 0 ? "" : k == 2 || !near[k + 1] ? " or " : ", ";
        used += (size_t)snprintf(text + used, room - used, "%s'%s'", before, near[k]);
    }
}

/* A text of an entry, or NULL; anything else is an error. */
static hawser_status text_of(const CaseNode *entry, const char *key, const char **text, hawser_error *err)
{
    const CaseNode *const node = case_node_key(entry, key);
    *text = NULL;
    if (!node) return HAWSER_OK;
    if (node->kind != NODE_TEXT || !*node->text) return case_value_error(err, node, ": expected a text");
    *text = node->text;
    return HAWSER_OK;
}

/* A range is "5 %", either way, or [from, to]. */
static hawser_status range_check(const CaseNode *range, hawser_error *err)
{
    if (!range) return HAWSER_OK;
    if (range->kind != NODE_MAP) return case_value_error(err, range, ": expected a map of keys and their ranges");
    for (const CaseNode *r = range->first; r; r = r->next) {
        const int pair =
            r->kind == NODE_LIST && r->count == 2 && r->first->kind == NODE_TEXT && r->last->kind == NODE_TEXT;
        if (!pair && r->kind != NODE_TEXT)
            return case_value_error(err, r, ": expected [from, to] or a share such as 5 %%");
    }
    return HAWSER_OK;
}

/* What an entry says of itself. A source is a name of the file's `sources`, or words. */
static hawser_status about_read(const CaseTree *file, LibraryEntry *e, hawser_error *err)
{
    const char *source = NULL;
    hawser_status status = text_of(e->node, "source", &source, err);
    if (!status) status = text_of(e->node, "mark", &e->mark, err);
    if (!status) status = text_of(e->node, "note", &e->note, err);
    if (!status) status = range_check(case_node_key(e->node, "range"), err);
    if (status) return status;
    const CaseNode *const known = source ? case_node_key(case_node_key(file->root, "sources"), source) : NULL;
    e->source = known && known->kind == NODE_TEXT ? known->text : source ? source : e->node->origin;
    if (!e->mark) e->mark = marks[0];
    if (place_of(e->mark, marks) >= 0) return HAWSER_OK;
    return case_value_error(err, case_node_key(e->node, "mark"), ": expected typical or estimated");
}

/* Room for one more; entries do not move once nodes point at them. */
static hawser_status reserve(Library *library, const CaseNode *node, hawser_error *err)
{
    if (library->n_entries == LIBRARY_ENTRIES_MAX) {
        return case_key_error(err, node, NULL, "too many entries: at most %d", LIBRARY_ENTRIES_MAX);
    }
    if (library->n_entries < library->room) return HAWSER_OK;
    const int room = library->room ? 2 * library->room : 64;
    LibraryEntry *const all = realloc(library->entry, (size_t)room * sizeof *all);
    if (!all) return error_memory(err);
    library->entry = all;
    library->room = room;
    return HAWSER_OK;
}

static hawser_status entry_read(Library *library, const CaseTree *file, const CaseNode *node, LibraryKind kind,
                                int shipped, hawser_error *err)
{
    if (node->kind != NODE_MAP) return case_value_error(err, node, ": expected a map of keys and values");
    const LibraryEntry *const same = find_from(library, space_of(kind), node->key, shipped);
    if (same) {
        char place[CASE_PLACE_MAX];
        return case_key_error(err, node, NULL, "this name is taken: %s",
                              case_place(same->node->origin, same->node->line, place));
    }
    LibraryEntry e = {.kind = kind, .shipped = shipped, .name = node->key, .node = node};
    hawser_status status = about_read(file, &e, err);
    if (!status) status = reserve(library, node, err);
    if (!status) library->entry[library->n_entries++] = e;
    return status;
}

/* One section of a file: a kind, or what stands beside the kinds. */
static hawser_status section_read(Library *library, const CaseTree *file, const CaseNode *node, int shipped,
                                  hawser_error *err)
{
    const int n = (int)(sizeof top_keys / sizeof *top_keys), kind = place_of(node->key, library_kinds);
    if (kind >= 0) {
        if (node->kind != NODE_MAP) return case_value_error(err, node, ": expected a map of names and entries");
        hawser_status status = HAWSER_OK;
        for (const CaseNode *e = node->first; e && !status; e = e->next) {
            status = entry_read(library, file, e, (LibraryKind)kind, shipped, err);
        }
        return status;
    }
    if (strcmp(node->key, "include") == 0) return HAWSER_OK; /* the includer's business */
    if (strcmp(node->key, "sources") == 0) {
        return node->kind == NODE_MAP ? HAWSER_OK : case_value_error(err, node, ": expected a map of names and texts");
    }
    const char *const nearest = case_nearest(node->key, top_keys, n);
    if (nearest) return case_key_error(err, node, NULL, "unknown key: did you mean '%s'?", nearest);
    return case_key_error(
        err, node, NULL,
        "unknown key: a file of the catalogue has cables, ropes, rollers, ducts, friction, reels, sources, include");
}

hawser_status library_kind_error(const char *kind, hawser_error *err)
{
    return error_set(err, HAWSER_ERR_INPUT,
                     "'%.80s' is no kind of the catalogue: expected cables, ropes, rollers, ducts, friction or reels",
                     kind);
}

hawser_status library_take(Library *library, CaseTree *file, int shipped, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    library->file[library->n_files++] = file;
    for (const CaseNode *node = file->root->first; node && !status; node = node->next) {
        status = section_read(library, file, node, shipped, err);
    }
    return status;
}

hawser_status library_read(Library *library, const char *path, int shipped, CaseTree **out, hawser_error *err)
{
    CaseTree *file = NULL;
    if (library->n_files == LIBRARY_FILES_MAX) {
        return error_set(err, HAWSER_ERR_INPUT, "%s: too many files: at most %d", path, LIBRARY_FILES_MAX);
    }
    hawser_status status = case_tree_load(path, &file, err);
    if (!status) status = library_take(library, file, shipped, err);
    if (!status && out) *out = file;
    return status;
}
