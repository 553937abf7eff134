/* Finds the shipped files; no path is compiled in, so that a tree may be moved after it was installed. */
#define _GNU_SOURCE /* dladdr */
#include "io/case/library.h"

#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"

const char *const library_kinds[] = {"cables", "ropes", "rollers", "ducts", "friction", "reels", NULL};

/* Other sections at the top of a file, besides the kinds. */
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

/* Cables and ropes share one set of names. */
static unsigned space_of(LibraryKind kind)
{
    const unsigned lines = 1u << LIBRARY_CABLES | 1u << LIBRARY_ROPES, own = 1u << kind;
    return own & lines ? lines : own;
}

/* Searches linearly: a library has some hundred entries, a case some dozen types. */
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

/* Lists the three nearest names, the nearest first. */
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

/* Reads a text of an entry, or NULL; anything else is an error. */
static hawser_status text_of(const CaseNode *entry, const char *key, const char **text, hawser_error *err)
{
    const CaseNode *const node = case_node_key(entry, key);
    *text = NULL;
    if (!node) return HAWSER_OK;
    if (node->kind != NODE_TEXT || !*node->text) return case_value_error(err, node, ": expected a text");
    *text = node->text;
    return HAWSER_OK;
}

/* Checks a range: "5 %", either way, or [from, to]. */
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

/* Reads an entry's keys about itself. A source is a name of the file's `sources`, or plain text. */
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

/* Allocates one more entry; entries must not move once nodes point at them. */
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

/* Reads one section of a file: a kind, or another one. */
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
    if (strcmp(node->key, "include") == 0) return HAWSER_OK; /* read by the caller */
    if (strcmp(node->key, "sources") == 0) {
        return node->kind == NODE_MAP ? HAWSER_OK : case_value_error(err, node, ": expected a map of names and texts");
    }
    const char *const nearest = hawser_nearest(node->key, top_keys, n);
    if (nearest) return case_key_error(err, node, NULL, "unknown key: did you mean '%s'?", nearest);
    return case_key_error(
        err, node, NULL,
        "unknown key: a file of the catalogue has cables, ropes, rollers, ducts, friction, reels, sources, include");
}

hawser_status library_kind_error(const char *kind, hawser_error *err)
{
    char hint[HINT_MAX];
    return error_set(err, HAWSER_ERR_INPUT,
                     "'%.80s' is no kind of the catalogue: expected cables, ropes, rollers, ducts, friction or reels%s",
                     kind, case_hint(kind, "cables, ropes, rollers, ducts, friction, reels", hint));
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

/* Adds a file's entries. Errors: INPUT with file and line (not readable, no YAML, unknown keys, an entry that is no
 * map, a name that another file of the same origin has too, too many), MEMORY. */
static hawser_status library_read(Library *library, const char *path, int shipped, CaseTree **out, hawser_error *err)
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

/* `include`: the user's own files, each relative to the file that names it. */

enum { PATH_ROOM = 4096 };

/* A file that was read, by its identity and not its name. */
typedef struct Met {
    dev_t device;
    ino_t inode;
    int open; /* its own includes are being read: including it again is a circle */
} Met;

typedef struct Including {
    Library *library;
    Met met[LIBRARY_FILES_MAX];
    int n;
    hawser_error *err;
} Including;

static hawser_status files_read(Including *in, const CaseTree *from, int depth);

/* Checks a path before it is opened; only plain files are opened. */
static hawser_status path_check(const Including *in, const CaseNode *node, const char *path, struct stat *is)
{
    if (stat(path, is) != 0) return case_value_error(in->err, node, ": '%s' cannot be read: %s", path, strerror(errno));
    if (!S_ISREG(is->st_mode)) return case_value_error(in->err, node, ": '%s' is not a file", path);
    if (is->st_size > LIBRARY_FILE_BYTES) {
        return case_value_error(in->err, node, ": '%s' is too large: at most %d MiB", path, LIBRARY_FILE_BYTES >> 20);
    }
    return HAWSER_OK;
}

/* Reads one file and its includes, unless it was read already. */
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

/* Reads a name, or a list of names. */
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

/* Adds the files that a case's `include` names, and their own includes, each once. Errors: as above, and INPUT with the
 * file and line of the include: no text, a file that is not there or no file, in a circle, too deep, too large; a case
 * without a folder. */
static hawser_status library_include(Library *library, const CaseTree *tree, hawser_error *err)
{
    Including in = {.library = library, .err = err};
    return files_read(&in, tree, 1);
}

/* `type` in a case: brings the keys of the entry that it names, where the case does not give them. */

enum { NEAR_MAX = 300 };

enum {
    LINES = 1u << LIBRARY_CABLES | 1u << LIBRARY_ROPES,
    ROLLERS = 1u << LIBRARY_ROLLERS,
    DUCTS = 1u << LIBRARY_DUCTS,
    FRICTION = 1u << LIBRARY_FRICTION,
    REELS = 1u << LIBRARY_REELS
};

/* Keys of an entry that a key given in the case displaces, besides itself, because it has the same meaning. NULL behind
 * the last. */
static const struct {
    unsigned kinds;
    const char *given, *displaced[4];
} displacements[] = {
    {LINES, "E", {"EA", "EI", "EI_y", "EI_z"}},
    {LINES, "G", {"GA", "GJ"}},
    {LINES, "A", {"EA", "GA"}},
    {LINES, "density", {"mass"}},
    {LINES, "EI", {"EI_y", "EI_z"}},
    {LINES, "bending", {"EI", "EI_y", "EI_z"}},
    {FRICTION, "mu", {"mu_s", "mu_d"}},
};

enum { DISPLACEMENTS = sizeof displacements / sizeof *displacements };

/* Checks whether a node is the child `key` of the root, or of the root's child `above`. */
static int is_under(const CaseNode *node, const char *above, const char *key)
{
    if (!node || !node->key || strcmp(node->key, key) != 0) return 0;
    if (!above) return node->parent && !node->parent->parent;
    return is_under(node->parent, NULL, above);
}

/* Returns the kinds of which a map's `type` may be; 0: it may have none. */
static unsigned kinds_of(const CaseNode *map)
{
    const CaseNode *const p = map->parent;
    if (map->kind != NODE_MAP || !p) return 0;
    if (map->key && (strcmp(map->key, "friction") == 0 || strcmp(map->key, "cable_friction") == 0)) return FRICTION;
    if (is_under(map, NULL, "reel")) return REELS;
    if (is_under(p, NULL, "cables")) return LINES;
    if (map->key && strcmp(map->key, "rollers") == 0 && is_under(p->parent, "drawing", "layers")) return ROLLERS;
    if (is_under(map, "rollers", "along") || is_under(p, "rollers", "along") || is_under(p, "rollers", "list"))
        return ROLLERS;
    return is_under(p, "surfaces", "ducts") ? DUCTS : 0;
}

static const CaseNode *type_of(const CaseNode *map) { return kinds_of(map) ? case_node_key(map, "type") : NULL; }

static int has_type(const CaseNode *node)
{
    if (type_of(node)) return 1;
    for (const CaseNode *child = node->first; child; child = child->next) {
        if (has_type(child)) return 1;
    }
    return 0;
}

/* Checks whether the case gives this key of an entry, directly or in other words. */
static int is_given(const CaseNode *map, unsigned kinds, const char *key)
{
    if (case_node_key(map, key)) return 1;
    for (int i = 0; i < DISPLACEMENTS; i++) {
        if (!(displacements[i].kinds & kinds) || !case_node_key(map, displacements[i].given)) continue;
        for (int k = 0; k < 4 && displacements[i].displaced[k]; k++) {
            if (strcmp(key, displacements[i].displaced[k]) == 0) return 1;
        }
    }
    return 0;
}

static hawser_status type_unknown(const Library *library, const CaseNode *type, unsigned kinds, hawser_error *err)
{
    char near[NEAR_MAX];
    int kind = 0;
    while (!(kinds >> kind & 1)) kind++;
    library_near(library, kinds, type->text, sizeof near, near);
    if (!*near)
        return case_value_error(err, type, " is not in the catalogue, which has none of %s", library_kinds[kind]);
    return case_value_error(err, type, " is not in the catalogue: did you mean %s? (hawser library %s)", near,
                            library_kinds[kind]);
}

/* Finds the given keys before anything is added, so that an entry does not displace its own keys. */
static hawser_status type_merge(const Library *library, CaseNode *map, const CaseNode *type, hawser_error *err)
{
    const unsigned kinds = kinds_of(map);
    if (type->kind != NODE_TEXT || !*type->text)
        return case_value_error(err, type, ": expected a name of the catalogue");
    const LibraryEntry *const entry = library_find(library, kinds, type->text);
    if (!entry) return type_unknown(library, type, kinds, err);
    CaseNode *const added = node_new(NODE_MAP, entry->node->origin, entry->node->line);
    int bad = !added;
    for (const CaseNode *child = entry->node->first; child && !bad; child = child->next) {
        if (library_about(child->key) || is_given(map, kinds, child->key)) continue;
        CaseNode *const copy = node_clone(child, entry);
        if (copy) copy->key = strdup(child->key);
        bad = !copy || !copy->key;
        if (bad) node_free(copy);
        if (!bad) node_append(added, copy);
    }
    for (CaseNode *child = bad ? NULL : added->first, *next; child; child = next) {
        next = child->next;
        child->parent = child->next = NULL;
        node_append(map, child);
    }
    if (!bad) added->first = added->last = NULL;
    node_free(added);
    return bad ? error_memory(err) : HAWSER_OK;
}

/* Works from the outside in: a friction in an entry of a roller may have a type of its own. */
static hawser_status types_merge(const Library *library, CaseNode *node, hawser_error *err)
{
    const CaseNode *const type = type_of(node);
    hawser_status status = type ? type_merge(library, node, type, err) : HAWSER_OK;
    for (CaseNode *child = node->first; child && !status; child = child->next)
        status = types_merge(library, child, err);
    return status;
}

/* Reads includes even if nothing refers to them, to find their errors; shipped files are read only for a type. */
hawser_status library_expand(const CaseTree *tree, CaseNode **root, Library **library, hawser_error *err)
{
    const int typed = has_type(tree->root);
    *root = NULL;
    *library = NULL;
    if (!typed && !case_node_key(tree->root, "include")) return HAWSER_OK;
    Library *const own = library_new();
    if (!own) return error_memory(err);
    hawser_status status = library_include(own, tree, err);
    if (!status && typed) status = library_ship(own, err);
    if (!status && typed && !(*root = node_clone(tree->root, NULL))) status = error_memory(err);
    if (!status && typed) status = types_merge(own, *root, err);
    if (status) {
        *root = node_free(*root);
        library_free(own);
    } else {
        *library = own; /* also for a case without a type: its files belong to the case */
    }
    return status;
}

static const char PLACE[] = "share/hawser/library";

/* Returns 0 with errno if it is no folder. */
static int is_folder(const char *path)
{
    struct stat is;
    if (stat(path, &is)) return 0;
    errno = ENOTDIR;
    return S_ISDIR(is.st_mode);
}

/* Finds a place beside the folder of a program or library, or up to two above it: bin, lib, lib/x86_64-linux-gnu; in a
 * build cli and tests/fuzz. Malloc'ed; NULL: not there. */
static char *beside(const char *module, const char *place)
{
    char path[2 * PATH_MAX], *real = realpath(module, NULL);
    char *slash = real ? strrchr(real, '/') : NULL, *found = NULL;
    for (int up = 0; up < 3 && slash && !found; up++) {
        *slash = 0;
        if (snprintf(path, sizeof path, "%s/%s", real, place) < (int)sizeof path) found = realpath(path, NULL);
        slash = strrchr(real, '/');
    }
    free(real);
    return found;
}

char *shipped_find(const char *place)
{
    Dl_info module = {0};
    char *const found =
        dladdr((const void *)library_kinds, &module) && module.dli_fname ? beside(module.dli_fname, place) : NULL;
    return found ? found : beside("/proc/self/exe", place);
}

/* Returns the folder of the shipped files, malloc'ed; NULL if there is none. `looked` (1000 bytes): the places that
 * were tried. */
static char *library_folder(char *looked, size_t room)
{
    const char *const named = getenv("HAWSER_LIBRARY");
    if (named && *named) {
        snprintf(looked, room, "the environment's HAWSER_LIBRARY, '%.800s', is not a folder", named);
        return is_folder(named) ? strdup(named) : NULL;
    }
    char program[PATH_MAX] = "";
    const ssize_t length = readlink("/proc/self/exe", program, sizeof program - 1);
    program[length > 0 ? length : 0] = 0;
    char *found = shipped_find(PLACE);
    if (found && !is_folder(found)) {
        snprintf(looked, room, "%.800s: %s", found, strerror(errno));
        free(found);
        return NULL;
    }
    snprintf(looked, room, "there is no %s beside %.700s: name its folder in the environment's HAWSER_LIBRARY", PLACE,
             *program ? program : "the program");
    return found;
}

static int is_yaml(const struct dirent *file)
{
    const size_t n = strlen(file->d_name);
    return n > 5 && strcmp(file->d_name + n - 5, ".yaml") == 0;
}

/* Reads the files in the order of their names, so that the catalogue's lists always have the same order. */
hawser_status library_ship(Library *library, hawser_error *err)
{
    char looked[1000], path[PATH_MAX + 300];
    char *const folder = library_folder(looked, sizeof looked);
    struct dirent **file = NULL;
    if (!folder) return error_set(err, HAWSER_ERR_INPUT, "the catalogue was not found: %s", looked);
    const int n = scandir(folder, &file, is_yaml, alphasort);
    hawser_status status = HAWSER_OK;
    if (n < 0 && errno == ENOMEM)
        status = error_memory(err);
    else if (n < 0)
        status = error_set(err, HAWSER_ERR_INPUT, "%s: cannot be read: %s", folder, strerror(errno));
    else if (n == 0)
        status = error_set(err, HAWSER_ERR_INPUT, "%s: no files of a catalogue (*.yaml)", folder);
    for (int i = 0; i < n; i++) {
        snprintf(path, sizeof path, "%s/%s", folder, file[i]->d_name);
        if (!status) status = library_read(library, path, 1, NULL, err);
        free(file[i]);
    }
    free(file);
    free(folder);
    return status;
}
