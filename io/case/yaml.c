#include "io/case/yaml.h"

#include <assert.h>
#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>
#include <yaml.h>

#include "core/error.h"

/* Cuts a file's name, which may be of any length, so that the line is still shown. */
const char *case_place(const char *origin, int line, char *place)
{
    if (line > 0) {
        snprintf(place, CASE_PLACE_MAX, "%.*s:%d", CASE_PLACE_MAX - 16, origin, line);
    } else {
        snprintf(place, CASE_PLACE_MAX, "%s", origin);
    }
    return place;
}

/* Replaces control characters by blanks, so that a message stays one line whatever the user wrote. */
const char *case_shown(const char *text, char *shown)
{
    const size_t room = CASE_SHOWN_MAX - 8;
    size_t n = 0;
    shown[n++] = '\'';
    for (; *text && n < room; text++) shown[n++] = (unsigned char)*text < 0x20 || *text == 0x7f ? ' ' : *text;
    if (*text) {
        /* not in the middle of a character of several bytes */
        while (n > 1 && ((unsigned char)shown[n - 1] & 0x80)) n--;
        n += (size_t)snprintf(shown + n, 4, "...");
    }
    shown[n++] = '\'';
    shown[n] = 0;
    return shown;
}

/* Writes from the root down: the parents' path first, then the node's own key or number, then the child's. */
const char *case_path(const CaseNode *node, const char *key, char *path)
{
    char before[CASE_PATH_MAX] = "", own[CASE_SHOWN_MAX] = "";
    path[0] = 0;
    if (node && node->parent) case_path(node->parent, NULL, before);
    if (node && node->key) snprintf(own, sizeof own, "%s", node->key);
    if (node && node->parent && !node->key) snprintf(own, sizeof own, "%d", node->index);
    const char *const part[3] = {before, own, key ? key : ""};
    size_t n = 0;
    for (int k = 0; k < 3; k++) {
        if (!*part[k] || n >= CASE_PATH_MAX) continue;
        n += (size_t)snprintf(path + n, CASE_PATH_MAX - n, "%s%s", n ? "." : "", part[k]);
    }
    return path;
}

hawser_status case_text_error(hawser_error *err, const char *origin, int line, const char *what, const char *detail)
{
    char place[CASE_PLACE_MAX], shown[CASE_SHOWN_MAX];
    error_set(err, HAWSER_ERR_INPUT, "%s: %s%s", case_place(origin, line, place), what,
              detail ? case_shown(detail, shown) : "");
    error_place(err, origin, line);
    return HAWSER_ERR_INPUT;
}

/* Writes "PLACE: key 'PATH': ABOUT VALUE WHAT", the common part of all messages about a key. The line is the node's,
 * also where the child is missing. */
static hawser_status key_error(hawser_error *err, const CaseNode *node, const char *key, const char *about,
                               const char *value, const char *what, va_list args)
{
    char place[CASE_PLACE_MAX], path[CASE_PATH_MAX], text[HAWSER_MESSAGE_MAX / 2];
    vsnprintf(text, sizeof text, what, args);
    error_set(err, HAWSER_ERR_INPUT, "%s: key '%s': %s%s%s", case_place(node->origin, node->line, place),
              case_path(node, key, path), about, value, text);
    error_place(err, node->origin, node->line);
    return HAWSER_ERR_INPUT;
}

/* Names a map or list instead of showing it: it may be long. */
hawser_status case_value_error(hawser_error *err, const CaseNode *node, const char *what, ...)
{
    char shown[CASE_SHOWN_MAX];
    const int text = node->kind == NODE_TEXT;
    const char *const value = text ? case_shown(node->text, shown) : node->kind == NODE_MAP ? "map" : "list";
    va_list args;
    va_start(args, what);
    const hawser_status status = key_error(err, node, NULL, text ? "value " : "the value is a ", value, what, args);
    va_end(args);
    return status;
}

hawser_status case_key_error(hawser_error *err, const CaseNode *node, const char *key, const char *what, ...)
{
    va_list args;
    va_start(args, what);
    const hawser_status status = key_error(err, node, key, "", "", what, args);
    va_end(args);
    return status;
}

hawser_status case_key_cause(hawser_error *err, const CaseNode *node, const char *key, const char *before,
                             const hawser_error *why)
{
    if (why->status == HAWSER_ERR_MEMORY) return error_memory(err);
    return case_key_error(err, node, key, "%s%s%s", before, *before ? ": " : "", why->message);
}

static int least(int a, int b) { return a < b ? a : b; }

/* Computes the optimal string alignment distance; words of up to 63 letters. */
int case_distance(const char *a, const char *b)
{
    enum { LETTERS = 63 };
    int d[LETTERS + 1][LETTERS + 1];
    const int n = (int)strlen(a), m = (int)strlen(b);
    if (n > LETTERS || m > LETTERS) return LETTERS;
    for (int i = 0; i <= n; i++) {
        for (int j = 0; j <= m; j++) {
            d[i][j] = i + j;
            if (!i || !j) continue;
            d[i][j] = least(d[i - 1][j], d[i][j - 1]) + 1;
            d[i][j] = least(d[i][j], d[i - 1][j - 1] + (a[i - 1] != b[j - 1]));
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                d[i][j] = least(d[i][j], d[i - 2][j - 2] + 1);
            }
        }
    }
    return d[n][m];
}

const char *hawser_nearest(const char *word, const char *const *name, int n)
{
    const char *best = NULL;
    int best_distance = word ? least(3, 1 + (int)strlen(word) / 3) : 0;
    for (int k = 0; word && name && k < n; k++) {
        if (strcasecmp(word, name[k]) == 0) return name[k];
        const int distance = case_distance(word, name[k]);
        if (distance >= best_distance) continue;
        best = name[k];
        best_distance = distance;
    }
    return best;
}

const char *case_hint(const char *word, const char *list, char hint[HINT_MAX])
{
    enum { LISTED = 48, LIST_MAX = 1024 };
    char all[LIST_MAX];
    const char *name[LISTED];
    int n = 0;
    snprintf(all, sizeof all, "%s", list);
    for (char *rest = all, *at; n < LISTED && (at = strtok_r(rest, ", ", &rest));) name[n++] = at;
    const char *const near = hawser_nearest(word, name, n);
    snprintf(hint, HINT_MAX, "; did you mean '%.64s'?", near ? near : "");
    if (!near) *hint = 0;
    return hint;
}

enum { KEY_MAX = 200, STEPS_MAX = 16 };

/* A source of text: kept as long as a tree whose nodes point at the name. Copies of a tree share the list that existed
 * when they were made, each with its own first element. */
typedef struct CaseOrigin {
    char *name;
    struct CaseOrigin *next;
    atomic_int users; /* trees and elements that point here */
} CaseOrigin;

/* Stores a name in the tree and returns the tree's copy; NULL if there is no memory. */
static const char *tree_origin(CaseTree *tree, const char *name)
{
    for (const CaseOrigin *o = tree->origins; o; o = o->next) {
        if (strcmp(o->name, name) == 0) return o->name;
    }
    CaseOrigin *origin = calloc(1, sizeof *origin);
    if (!origin) return NULL;
    origin->name = strdup(name);
    if (!origin->name) {
        free(origin);
        return NULL;
    }
    origin->next = tree->origins; /* the tree's reference passes on */
    atomic_init(&origin->users, 1);
    tree->origins = origin;
    return origin->name;
}

CaseTree *case_tree_free(CaseTree *tree)
{
    if (!tree) return NULL;
    node_free(tree->root);
    for (CaseOrigin *origin = tree->origins; origin && atomic_fetch_sub(&origin->users, 1) == 1;) {
        CaseOrigin *next = origin->next;
        free(origin->name);
        free(origin);
        origin = next;
    }
    free(tree->path);
    free(tree->folder);
    free(tree);
    return NULL;
}

/* Returns the folder of a path, malloc'ed; NULL if there is no memory. */
static char *folder_of(const char *path)
{
    const char *const slash = strrchr(path, '/');
    if (!slash || !strcmp(path, "/dev/stdin")) return strdup("."); /* a text from a pipe is about files that are here */
    return strndup(path, slash == path ? 1 : (size_t)(slash - path));
}

/* Parses a tree from `size` bytes of text, which editors may begin with a byte order mark. */
static hawser_status tree_new(const char *text, size_t size, const char *name, CaseTree **out, hawser_error *err)
{
    static const char mark[] = "\xef\xbb\xbf";
    const size_t skip = strncmp(text, mark, 3) == 0 ? 3 : 0;
    CaseTree *tree = calloc(1, sizeof *tree);
    const char *origin = tree ? tree_origin(tree, name) : NULL;
    *out = NULL;
    if (!origin) {
        case_tree_free(tree);
        return error_memory(err);
    }
    hawser_status status = yaml_read(text + skip, size - skip, origin, 1, &tree->root, err);
    if (!status && tree->root && tree->root->kind != NODE_MAP)
        status = case_text_error(err, origin, tree->root->line, "a case is a map: lines of 'key: value'", NULL);
    *out = status ? case_tree_free(tree) : tree;
    return status;
}

/* The text ends at its NUL. */
hawser_status case_tree_parse(const char *text, const char *name, CaseTree **out, hawser_error *err)
{
    return tree_new(text, strlen(text), name, out, err);
}

hawser_status case_tree_load(const char *path, CaseTree **out, hawser_error *err)
{
    *out = NULL;
    char *text;
    size_t size;
    hawser_status status = case_file_read(path, &text, &size, err);
    if (status) return status;
    status = tree_new(text, size, path, out, err);
    free(text);
    if (!status) (*out)->folder = folder_of(path);
    if (!status) (*out)->path = strdup(path);
    if (!status && (!(*out)->folder || !(*out)->path)) {
        *out = case_tree_free(*out);
        status = error_memory(err);
    }
    return status;
}

CaseTree *case_tree_copy(const CaseTree *tree)
{
    CaseTree *const copy = calloc(1, sizeof *copy);
    if (!copy) return NULL;
    copy->root = node_clone(tree->root, NULL);
    copy->folder = tree->folder ? strdup(tree->folder) : NULL;
    copy->path = tree->path ? strdup(tree->path) : NULL;
    copy->origins = tree->origins;
    if (copy->origins) atomic_fetch_add(&copy->origins->users, 1);
    return copy->root && (copy->folder || !tree->folder) && (copy->path || !tree->path) ? copy : case_tree_free(copy);
}

/* A key on its way into a tree: its origin and its parts. */
typedef struct Setting {
    const CaseTree *tree;
    const char *origin; /* "--set KEY"; for reading alone, the key */
    char key[KEY_MAX];  /* with NULs for dots */
    const char *step[STEPS_MAX];
    int n;
    hawser_error *err;
} Setting;

/* Splits the key in place: dots become NULs. */
static hawser_status key_cut(Setting *s, const char *key)
{
    snprintf(s->key, sizeof s->key, "%s", key);
    for (char *p = s->key; p; s->n++) {
        if (s->n == STEPS_MAX) return case_text_error(s->err, s->origin, 0, "the key has too many parts", NULL);
        s->step[s->n] = p;
        p = strchr(p, '.');
        if (p) *p++ = 0;
        if (!*s->step[s->n]) return case_text_error(s->err, s->origin, 0, "a part of the key is empty", NULL);
    }
    return HAWSER_OK;
}

/* Counts the items of a list with this `name`, and returns the last of them. */
static int items_named(const CaseNode *list, const char *name, CaseNode **out)
{
    int n = 0;
    for (CaseNode *item = list->first; item; item = item->next) {
        const CaseNode *const own = case_node_key(item, "name");
        if (!own || own->kind != NODE_TEXT || strcmp(own->text, name) != 0) continue;
        *out = item;
        n++;
    }
    return n;
}

/* Rejects a name that is the number of another item: either could be meant. */
static hawser_status item_ambiguous(const Setting *s, const CaseNode *list, long index, const CaseNode *named)
{
    int place = 0;
    for (const CaseNode *item = list->first; item && item != named; item = item->next) place++;
    const CaseNode *const own = case_node_key(case_node_item(list, (int)index), "name");
    char shown[CASE_SHOWN_MAX];
    return error_set(s->err, HAWSER_ERR_INPUT,
                     "%s: %ld is the number of the item %s and the name of the item with the number %d: give that one "
                     "a name that is no number",
                     s->origin, index, own && own->kind == NODE_TEXT ? case_shown(own->text, shown) : "without a name",
                     place);
}

/* Finds the item of a list by number or name. */
static hawser_status item_find(const Setting *s, const CaseNode *list, const char *step, CaseNode **out)
{
    char *end, shown[CASE_SHOWN_MAX];
    const long index = isdigit((unsigned char)*step) ? strtol(step, &end, 10) : LONG_MAX;
    const int whole = index != LONG_MAX && !*end;
    CaseNode *by_name = NULL;
    const int named = items_named(list, step, &by_name);
    *out = by_name;
    if (whole && index < list->count) {
        *out = (CaseNode *)(size_t)case_node_item(list, (int)index);
        if (named == 0 || (named == 1 && by_name == *out)) return HAWSER_OK;
        return item_ambiguous(s, list, index, by_name);
    }
    if (named == 1) return HAWSER_OK;
    if (named > 1) {
        return error_set(s->err, HAWSER_ERR_INPUT, "%s: %d items have the name %s: give the number, from 0", s->origin,
                         named, case_shown(step, shown));
    }
    return error_set(s->err, HAWSER_ERR_INPUT, "%s: no item %s: the list has %d, numbered from 0", s->origin,
                     case_shown(step, shown), list->count);
}

/* Follows the key as far as the tree has it: *node is the last existing node, *depth the number of steps to it. */
static hawser_status path_follow(const Setting *s, CaseNode **node, int *depth)
{
    *node = s->tree->root;
    for (*depth = 0; *depth < s->n; ++*depth) {
        const char *step = s->step[*depth];
        CaseNode *next = NULL;
        if ((*node)->kind == NODE_TEXT)
            return case_text_error(s->err, s->origin, 0, "a value, not a map, comes before ", step);
        if ((*node)->kind == NODE_LIST) {
            const hawser_status status = item_find(s, *node, step, &next);
            if (status) return status;
        } else {
            next = (CaseNode *)(size_t)case_node_key(*node, step);
        }
        if (!next) break;
        *node = next;
    }
    return HAWSER_OK;
}

/* Wraps `value` in maps for the steps from `depth` on; frees it without memory. */
static CaseNode *branch_new(const Setting *s, int depth, CaseNode *value)
{
    for (int k = s->n - 1; value && k >= depth; k--) {
        value->key = strdup(s->step[k]);
        if (k == depth && value->key) return value;
        CaseNode *map = value->key ? node_new(NODE_MAP, s->origin, 0) : NULL;
        if (map) {
            node_append(map, value);
        } else {
            node_free(value);
        }
        value = map;
    }
    return value;
}

/* Replaces the existing value, or adds the missing nodes. The value is placed or freed. */
static hawser_status value_place(const Setting *s, CaseNode *value)
{
    CaseNode *node;
    int depth;
    const hawser_status status = path_follow(s, &node, &depth);
    if (status) {
        node_free(value);
        return status;
    }
    if (depth == s->n) {
        node_replace(node, value);
        return HAWSER_OK;
    }
    value = branch_new(s, depth, value);
    if (!value) return error_memory(s->err);
    node_append(node, value);
    return HAWSER_OK;
}

static hawser_status key_long(const char *before, const char *key, hawser_error *err)
{
    char shown[CASE_SHOWN_MAX];
    return error_set(err, HAWSER_ERR_INPUT, "%s%s: the key is too long", before, case_shown(key, shown));
}

hawser_status case_tree_find(const CaseTree *tree, const char *key, const CaseNode **node, hawser_error *err)
{
    Setting s = {.tree = tree, .origin = key, .err = err};
    CaseNode *found = tree->root;
    int depth = 0;
    if (strlen(key) >= KEY_MAX) return key_long("", key, err);
    hawser_status status = *key ? key_cut(&s, key) : HAWSER_OK;
    if (!status) status = path_follow(&s, &found, &depth);
    if (!status && depth < s.n) status = error_set(err, HAWSER_ERR_INPUT, "%s: the case does not give this key", key);
    *node = status ? NULL : found;
    return status;
}

/* Reads the value before the tree is changed, so that an error leaves the tree as it was. */
hawser_status case_tree_set(CaseTree *tree, const char *key, const char *value, hawser_error *err)
{
    char origin[KEY_MAX + 16];
    if (strlen(key) >= KEY_MAX) return key_long("--set ", key, err);
    snprintf(origin, sizeof origin, "--set %s", key);
    Setting s = {.tree = tree, .origin = tree_origin(tree, origin), .err = err};
    if (!s.origin) return error_memory(err);
    hawser_status status = key_cut(&s, key);
    CaseNode *node = NULL;
    /* an empty value is an empty text, which the reader rejects where a value is required */
    if (!status) status = yaml_read(*value ? value : "''", strlen(*value ? value : "''"), s.origin, 0, &node, err);
    if (!status) status = value_place(&s, node);
    return status;
}

/* Adds a text to a map, unless it is NULL; *fine becomes 0 without memory. */
static void text_add(CaseNode *map, const char *key, const char *text, int *fine)
{
    CaseNode *const node = text ? node_new(NODE_TEXT, "", 0) : NULL;
    if (!text) return;
    if (node) {
        node->key = strdup(key);
        node->text = strdup(text);
        node_append(map, node);
    }
    *fine &= node && node->key && node->text;
}

/* Adds the absolute path if it exists: the text may be read elsewhere. */
static void path_add(CaseNode *map, const char *key, const char *path, int *fine)
{
    char *const whole = path ? realpath(path, NULL) : NULL;
    text_add(map, key, whole ? whole : path, fine);
    free(whole);
}

hawser_status case_tree_pack(const CaseTree *tree, const char *name, char **text, hawser_error *err)
{
    CaseNode *const map = node_new(NODE_MAP, "", 0), *const root = node_clone(tree->root, NULL);
    int fine = map && root;
    if (fine) {
        text_add(map, "name", name, &fine);
        path_add(map, "folder", tree->folder, &fine);
        path_add(map, "path", tree->path, &fine);
        root->key = strdup("case");
        node_append(map, root);
        fine &= root->key != NULL;
    } else {
        node_free(root);
    }
    *text = NULL;
    const hawser_status status = fine ? case_node_text(map, text, err) : error_memory(err);
    node_free(map);
    return status;
}

/* Removes the lines of all nodes and sets their origin (NULL: leaves it). */
static void nodes_place(CaseNode *node, const char *origin)
{
    if (origin) node->origin = origin;
    node->line = 0;
    for (CaseNode *child = node->first; child; child = child->next) nodes_place(child, origin);
}

void case_tree_unline(CaseTree *tree) { nodes_place(tree->root, NULL); }

/* Returns a copy of a text of the map, NULL where there is none; *fine becomes 0 without memory. */
static char *text_take(const CaseNode *map, const char *key, int *fine)
{
    const CaseNode *const node = case_node_key(map, key);
    char *const text = node && node->text ? strdup(node->text) : NULL;
    *fine &= text || !node || !node->text;
    return text;
}

hawser_status case_tree_unpack(const char *text, CaseTree **out, char **name, hawser_error *err)
{
    static const char packed[] = "packed case";
    CaseNode *map = NULL;
    *out = NULL;
    *name = NULL;
    hawser_status status = yaml_read(text, strlen(text), packed, 0, &map, err);
    if (status) return status;
    const CaseNode *const root = case_node_key(map, "case"), *const called = case_node_key(map, "name");
    if (!root || root->kind != NODE_MAP || !called || !called->text) {
        node_free(map);
        return case_text_error(err, packed, 0, "no case, or one without a name", NULL);
    }
    int fine = 1;
    CaseTree *const tree = calloc(1, sizeof *tree);
    const char *const origin = tree ? tree_origin(tree, called->text) : NULL;
    if (origin) {
        tree->root = node_clone(root, NULL);
        tree->folder = text_take(map, "folder", &fine);
        tree->path = text_take(map, "path", &fine);
        *name = text_take(map, "name", &fine);
    }
    node_free(map);
    if (!origin || !tree->root || !fine) {
        case_tree_free(tree);
        free(*name);
        *name = NULL;
        return error_memory(err);
    }
    nodes_place(tree->root, origin);
    *out = tree;
    return HAWSER_OK;
}

/* The text of a case from any kind of path, read within bounded time and size. */

/* Bytes; ms that a pipe may be silent. */
enum { FILE_MAX = 32 << 20, SILENCE_MAX = 5000 };

/* Opens a path without waiting for the writer of a FIFO. Accepts a file, or a pipe as in a shell's <(...); a device has
 * no end. Returns 0, or what is wrong with it. */
static const char *text_open(const char *path, int *fd)
{
    struct stat state;
    *fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (*fd < 0 || fstat(*fd, &state)) return strerror(errno);
    if (S_ISDIR(state.st_mode)) return strerror(EISDIR);
    if (!S_ISREG(state.st_mode) && !S_ISFIFO(state.st_mode)) return "not a file";
    return S_ISREG(state.st_mode) && state.st_size > FILE_MAX ? strerror(EFBIG) : NULL;
}

/* Works as read(2), but waits for a pipe's writer; a writer that stays silent is ETIMEDOUT. */
static ssize_t text_read(int fd, char *to, size_t room)
{
    struct pollfd ready = {.fd = fd, .events = POLLIN};
    for (;;) {
        const int n = poll(&ready, 1, SILENCE_MAX);
        if (n == 0) errno = ETIMEDOUT;
        const ssize_t got = n > 0 ? read(fd, to, room) : -1;
        if (got >= 0 || (errno != EINTR && errno != EAGAIN)) return got;
    }
}

/* Reads everything, malloc'ed, with a NUL behind it; NULL with errno, EFBIG if it is larger than a case can be. */
static char *bytes_take(int fd, size_t *size)
{
    size_t room = 1 << 16;
    char *text = malloc(room + 1);
    *size = 0;
    while (text) {
        const ssize_t n = text_read(fd, text + *size, room - *size);
        if (n < 0) break;
        if (n == 0) {
            text[*size] = 0;
            return text;
        }
        *size += (size_t)n;
        if (*size < room) continue;
        room *= 2;
        errno = EFBIG;
        char *const more = room <= FILE_MAX ? realloc(text, room + 1) : NULL;
        if (!more) break;
        text = more;
    }
    const int reason = text ? errno : ENOMEM;
    free(text);
    errno = reason;
    return NULL;
}

hawser_status case_file_read(const char *path, char **text, size_t *size, hawser_error *err)
{
    int fd;
    const char *const wrong = text_open(path, &fd);
    *text = NULL;
    if (wrong) {
        if (fd >= 0) close(fd);
        error_set(err, HAWSER_ERR_INPUT, "%s: cannot be %s: %s", path, fd < 0 ? "opened" : "read", wrong);
        error_place(err, path, 0);
        return HAWSER_ERR_INPUT;
    }
    *text = bytes_take(fd, size);
    const int reason = errno;
    close(fd);
    if (*text) return HAWSER_OK;
    if (reason == ENOMEM) return error_memory(err);
    return error_set(err, HAWSER_ERR_INPUT, "%s: cannot be read: %s", path,
                     reason == ETIMEDOUT ? "nothing was written into it for 5 s" : strerror(reason));
}

/* A tree as a document, JSON with nothing but texts, which is YAML, too: the same values under the same keys,
 * without the places where they were written. */

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

CaseNode *node_new(NodeKind kind, const char *origin, int line)
{
    CaseNode *node = calloc(1, sizeof *node);
    if (!node) return NULL;
    node->kind = kind;
    node->origin = origin;
    node->line = line;
    return node;
}

/* Recursion is as deep as the tree, which yaml_read and case_tree_set limit. */
CaseNode *node_free(CaseNode *node)
{
    if (!node) return NULL;
    for (CaseNode *child = node->first; child;) {
        CaseNode *next = child->next;
        node_free(child);
        child = next;
    }
    free(node->key);
    free(node->text);
    free(node);
    return NULL;
}

/* Copies a single node without its children. */
static CaseNode *node_copy(const CaseNode *node, const struct LibraryEntry *entry)
{
    CaseNode *const copy = node_new(node->kind, node->origin, node->line);
    if (!copy) return NULL;
    copy->entry = entry ? entry : node->entry;
    copy->text = node->text ? strdup(node->text) : NULL;
    return node->text && !copy->text ? node_free(copy) : copy;
}

/* Recursion is as deep as the tree. */
CaseNode *node_clone(const CaseNode *node, const struct LibraryEntry *entry)
{
    CaseNode *copy = node_copy(node, entry);
    for (const CaseNode *child = node->first; child && copy; child = child->next) {
        CaseNode *const below = node_clone(child, entry);
        char *const key = child->key ? strdup(child->key) : NULL;
        if (!below || (child->key && !key)) {
            free(key);
            node_free(below);
            return node_free(copy);
        }
        below->key = key;
        node_append(copy, below);
    }
    return copy;
}

/* Takes constant time, by the pointer to the last child. */
void node_append(CaseNode *parent, CaseNode *child)
{
    assert(parent->kind != NODE_TEXT && !child->parent && !child->next);
    child->parent = parent;
    child->index = parent->count++;
    if (parent->last) {
        parent->last->next = child;
    } else {
        parent->first = child;
    }
    parent->last = child;
}

/* Passes key and number on to the new node, which takes the old one's place in the tree. */
void node_replace(CaseNode *old, CaseNode *by)
{
    CaseNode *parent = old->parent;
    CaseNode **link = &parent->first;
    while (*link != old) link = &(*link)->next;
    *link = by;
    if (parent->last == old) parent->last = by;
    by->parent = parent;
    by->next = old->next;
    by->index = old->index;
    by->key = old->key;
    old->key = NULL;
    node_free(old);
}

/* Searches linearly: maps have 500 keys at most. */
const CaseNode *case_node_key(const CaseNode *node, const char *key)
{
    if (!node || node->kind != NODE_MAP) return NULL;
    const CaseNode *child = node->first;
    while (child && strcmp(child->key, key) != 0) child = child->next;
    return child;
}

void case_node_path(const CaseNode *node, char *path, size_t size)
{
    *path = 0;
    if (!node || !node->parent) return;
    case_node_path(node->parent, path, size);
    const size_t n = strlen(path);
    if (node->key)
        snprintf(path + n, size - n, "%s%s", n ? "." : "", node->key);
    else
        snprintf(path + n, size - n, "%s%d", n ? "." : "", node->index);
}

/* Starts at the first; readers of all items follow `next` instead. */
const CaseNode *case_node_item(const CaseNode *node, int index)
{
    if (!node || node->kind != NODE_LIST) return NULL;
    const CaseNode *child = node->first;
    while (child && child->index != index) child = child->next;
    return child;
}

/* Far more than any case needs; a larger document is an accident or an attack. Aliases are expanded, so that a small
 * file can have many nodes. */
enum { NODES_MAX = 500000, KEYS_MAX = 500, DEPTH_MAX = 24, ANCHORS_MAX = 1000, TAGS_MAX = 16 };

static const char TOO_DEEP[] = "nested too deeply, or an alias inside itself";

/* One document while it is converted into nodes. */
typedef struct Reading {
    yaml_document_t document;
    const char *origin;
    int lines; /* 0: line numbers have no meaning */
    int nodes;
    hawser_error *err;
} Reading;

/* libyaml counts from 0. */
static int line_of(const Reading *r, yaml_mark_t mark) { return r->lines ? (int)mark.line + 1 : 0; }

static hawser_status node_convert(Reading *r, int id, int depth, CaseNode **out);

/* Detects characters that would control a terminal when a name or title is printed; line ends and tabs do not. */
static int has_control(const char *text)
{
    for (const char *c = text; *c; c++) {
        if (*c != '\n' && *c != '\t' && text_control_at(c)) return 1;
    }
    return 0;
}

/* Converts the text of a map's key, malloc'ed into *key. */
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

/* Gives a value the line of its key, where people look for it. */
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

/* Gives items the line at which they begin. */
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

/* Rejects a NUL inside a text, which YAML's "\0" allows: it would be taken for the end. */
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

/* Converts node `id` of the document with all below it. Aliases repeat their anchor's value; the limits stop circles
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

/* Returns the line, from 1, that holds byte `offset` of the text. */
static int line_at(const char *text, size_t offset)
{
    int line = 1;
    for (const char *p = text; *p && p < text + offset; p++) line += *p == '\n';
    return line;
}

/* Detects a tab as indentation, for which libyaml's own message speaks of tokens. */
static int indented_with_tab(const char *text, int line)
{
    for (; text && line > 1; line--) {
        text = strchr(text, '\n');
        if (text) text++;
    }
    return text && text[strspn(text, " ")] == '\t';
}

/* Reports libyaml's error in the text. */
static hawser_status parser_complain(const Reading *r, const yaml_parser_t *parser, const char *text)
{
    /* libyaml does not always report a lack of memory: then there is no error at all */
    if (parser->error == YAML_MEMORY_ERROR || parser->error == YAML_NO_ERROR) return error_memory(r->err);
    int line = (int)parser->problem_mark.line + 1;
    if (parser->error == YAML_READER_ERROR) line = line_at(text, parser->problem_offset);
    if (indented_with_tab(text, line))
        return case_text_error(r->err, r->origin, line, "indented with a tab: YAML requires spaces", NULL);
    char place[CASE_PLACE_MAX];
    if (!r->lines) line = 0;
    error_set(r->err, HAWSER_ERR_INPUT, "%s: not YAML: %s%s%s%s", case_place(r->origin, line, place),
              parser->problem ? parser->problem : "cannot be read", parser->context ? " (" : "",
              parser->context ? parser->context : "", parser->context ? ")" : "");
    error_place(r->err, r->origin, line);
    return HAWSER_ERR_INPUT;
}

/* Checks that no further document follows. */
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

/* Fixes the encoding, so that junk is not taken for UTF-16. 0 without memory. */
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

/* Counts %TAG lines; libyaml compares each with all before it. */
static int tags_count(const char *text)
{
    int n = 0;
    for (const char *p = strstr(text, "%TAG"); p && n <= TAGS_MAX; p = strstr(p + 1, "%TAG")) {
        n += p == text || p[-1] == '\n';
    }
    return n;
}

/* Rejects documents for which libyaml takes a time that grows with the square of their size: deep nesting, many
 * anchors, many tags. Other errors are found when loading. */
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

/* libyaml's node 1 is the root. */
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
