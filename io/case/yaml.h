/* A YAML file as a small tree of texts, maps and lists with the place where each of them was written, and messages with
 * these places. Nothing is interpreted here: io/case handles numbers, units and the meaning of keys. */
#ifndef HAWSER_IO_CASE_YAML_H
#define HAWSER_IO_CASE_YAML_H

#include <stddef.h>

#include "hawser/hawser.h"

/* ------------------------------------------------------------------------------------------------------------ nodes */

typedef enum NodeKind { NODE_TEXT, NODE_MAP, NODE_LIST } NodeKind;

/* One value. Children of a map have keys, those of a list have numbers. */
typedef struct CaseNode {
    NodeKind kind;
    const char *origin;               /* the file's name, or "--set KEY"; belongs to the tree */
    int line;                         /* line at which its key, or else itself, begins, from 1; 0: not from a file */
    char *key;                        /* in a map, else NULL */
    int index;                        /* place among its siblings, from 0 */
    char *text;                       /* of a NODE_TEXT, else NULL */
    int count;                        /* children */
    const struct LibraryEntry *entry; /* catalogue entry that it comes from (io/library); NULL: the case's own */
    struct CaseNode *parent, *first, *last, *next;
} CaseNode;

/* Returns the child of a map by key, of a list by number; NULL if there is none, or if `node` is NULL or of another
 * kind. */
const CaseNode *case_node_key(const CaseNode *node, const char *key);
const CaseNode *case_node_item(const CaseNode *node, int index);
/* Writes the path of a node, by keys and numbers: "surfaces.ducts.0.friction"; cut where it is too long. */
void case_node_path(const CaseNode *node, char *path, size_t size);
/* Returns a node without parent or children; NULL if there is no memory. */
CaseNode *node_new(NodeKind kind, const char *origin, int line);
/* Frees a node and all below it; NULL-safe; returns NULL. */
CaseNode *node_free(CaseNode *node);
/* Makes child the last of parent. */
void node_append(CaseNode *parent, CaseNode *child);
/* Returns a copy with all below it, without parent and key; `entry`: put into all of its nodes. NULL if there is no
 * memory. */
CaseNode *node_clone(const CaseNode *node, const struct LibraryEntry *entry);
/* Puts `by` in old's place under old's key, and frees old. */
void node_replace(CaseNode *old, CaseNode *by);
/* ------------------------------------------------------------------------------------------------------------ trees */

typedef struct CaseTree {
    CaseNode *root;             /* a map */
    struct CaseOrigin *origins; /* names of the origins that nodes point at */
    char *path;                 /* path of its file; NULL: it came as a text */
    char *folder;               /* folder of the files that it includes; NULL: it came as a text, there are none */
    int unlisted;               /* its inputs are not needed and not listed */
} CaseTree;

/* Reads all of a file or pipe, malloc'ed, with a NUL behind it. Errors: INPUT (not there, a device, larger than 32 MiB,
 * a pipe without a writer), MEMORY. */
hawser_status case_file_read(const char *path, char **text, size_t *size, hawser_error *err);
/* Reads a file. Errors: INPUT with file and line (not readable, not YAML, empty, not a map, several
 * documents, a key twice, too large, too deep); MEMORY. *out is NULL then. */
hawser_status case_tree_load(const char *path, CaseTree **out, hawser_error *err);
/* Reads the same from text; messages use `name` as the file's name. Its folder stays NULL. */
hawser_status case_tree_parse(const char *text, const char *name, CaseTree **out, hawser_error *err);
/* Gives the dotted key ("chain.0.segment") a new value, which is YAML itself ("250 mm", "[0, 0, -9.8]"). Missing maps
 * on the way are made; list items must exist and are found by number or by their `name`. Errors: INPUT that names the
 * setting; MEMORY. The tree is unchanged then. */
hawser_status case_tree_set(CaseTree *tree, const char *key, const char *value, hawser_error *err);
/* Finds the value under a dotted key, as case_tree_set follows it; "": the whole tree. Errors: INPUT (there is none).
 */
hawser_status case_tree_find(const CaseTree *tree, const char *key, const CaseNode **node, hawser_error *err);
/* Removes the lines of all nodes: the text that was read is not the file that the user knows. */
void case_tree_unline(CaseTree *tree);
CaseTree *case_tree_free(CaseTree *tree);
/* Returns an independent copy. Several threads may copy one tree. NULL if there is no memory. */
CaseTree *case_tree_copy(const CaseTree *tree);
/* Writes the node with all below it as a JSON document of texts, from which the same nodes are read; malloc'ed. Errors:
 * MEMORY. */
hawser_status case_node_text(const CaseNode *node, char **text, hawser_error *err);
/* Write the tree with its name, folder and file as such a document, and read it back: nodes have no lines then, and
 * `name` as their origin. *name: malloc'ed. Errors: MEMORY; when reading INPUT, too. */
hawser_status case_tree_pack(const CaseTree *tree, const char *name, char **text, hawser_error *err);
hawser_status case_tree_unpack(const char *text, CaseTree **out, char **name, hawser_error *err);
/* Reads one YAML document of `size` bytes, with a NUL behind them. `origin` is shown as its source and must outlive the
 * nodes; lines 0: it is a setting's value, and line numbers have no meaning. Errors: INPUT with the place (not YAML,
 * empty, several documents, a key twice, too large, too deep), MEMORY; *out is NULL then. */
hawser_status yaml_read(const char *text, size_t size, const char *origin, int lines, CaseNode **out,
                        hawser_error *err);
/* --------------------------------------------------------------------------------------------------------- messages */

enum { CASE_PLACE_MAX = 300, CASE_SHOWN_MAX = 80, CASE_PATH_MAX = 256 };

/* Writes "FILE:LINE", or the origin alone for line 0. Returns `place`, which has CASE_PLACE_MAX bytes. */
const char *case_place(const char *origin, int line, char *place);
/* Writes the user's text in quotes, on one line and cut short. `shown` has CASE_SHOWN_MAX bytes. */
const char *case_shown(const char *text, char *shown);
/* Writes the dotted key of a node, or of its child `key` (NULL: itself). `path` has CASE_PATH_MAX bytes. */
const char *case_path(const CaseNode *node, const char *key, char *path);
/* Reports "PLACE: WHAT'DETAIL'" about a text as a whole; detail NULL: nothing is shown. All of these return
 * HAWSER_ERR_INPUT. */
hawser_status case_text_error(hawser_error *err, const char *origin, int line, const char *what, const char *detail);
/* Reports "PLACE: key 'PATH': value 'TEXT'WHAT", or "the value is a mapWHAT": WHAT includes its own blank or colon. */
hawser_status case_value_error(hawser_error *err, const CaseNode *node, const char *what, ...)
    __attribute__((format(printf, 3, 4)));
/* Reports "PLACE: key 'PATH': WHAT" about the node, or about its child `key` that may be absent. */
hawser_status case_key_error(hawser_error *err, const CaseNode *node, const char *key, const char *what, ...)
    __attribute__((format(printf, 4, 5)));
/* Does the same for an error found below, with `before` ahead of it; a lack of memory stays one. */
hawser_status case_key_cause(hawser_error *err, const CaseNode *node, const char *key, const char *before,
                             const hawser_error *why);
/* Returns how many letters must be changed, added, dropped or swapped with their neighbour to make b of a. */
int case_distance(const char *a, const char *b);
/* Writes "; did you mean 'NAME'?" with the name of a list ("a, b, c") that is nearest to the word; "" if none is near.
 * Returns `hint`. */
enum { HINT_MAX = 96 };
const char *case_hint(const char *word, const char *list, char hint[HINT_MAX]);

#endif
