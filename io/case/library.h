/* The catalogue: cables, ropes, rollers, ducts, friction and reels that a case refers to by name
 * (docs/guide/equipment.md). Entries are maps of the case's own keys, in YAML files: the shipped ones and those that a
 * case includes. Keys about an entry itself stand beside these: `source`, `range`, `mark`, `note`. */
#ifndef HAWSER_IO_CASE_LIBRARY_H
#define HAWSER_IO_CASE_LIBRARY_H

#include "io/case/yaml.h"

typedef enum LibraryKind {
    LIBRARY_CABLES,
    LIBRARY_ROPES,
    LIBRARY_ROLLERS,
    LIBRARY_DUCTS,
    LIBRARY_FRICTION,
    LIBRARY_REELS,
    LIBRARY_KINDS
} LibraryKind;

/* Names of the kinds, as sections of the files; NULL behind the last. */
extern const char *const library_kinds[];

/* Returns INPUT for a name that is no kind. */
hawser_status library_kind_error(const char *kind, hawser_error *err);
typedef struct LibraryEntry {
    LibraryKind kind;
    int shipped; /* 0: from a file that the case includes */
    const char *name;
    const CaseNode *node; /* its map */
    const char *source;   /* as text; for a user's entry perhaps only its file's name */
    const char *mark;     /* "typical", "estimated" */
    const char *note;     /* NULL: none */
} LibraryEntry;

enum { LIBRARY_FILES_MAX = 128, LIBRARY_ENTRIES_MAX = 20000, LIBRARY_DEPTH_MAX = 8, LIBRARY_FILE_BYTES = 4 << 20 };

typedef struct Library {
    CaseTree *file[LIBRARY_FILES_MAX]; /* [n_files] owned; names and texts of the entries are theirs */
    int n_files, n_entries, room;
    LibraryEntry *entry; /* [n_entries] owned; merged nodes point at them, after which it no longer grows */
} Library;

/* Returns an empty library; NULL if there is no memory. */
Library *library_new(void);
Library *library_free(Library *library);
/* Does the same for a tree that has been read, which the library owns from then on. */
hawser_status library_take(Library *library, CaseTree *file, int shipped, hawser_error *err);
/* Adds the shipped files: from the folder in the environment's HAWSER_LIBRARY, else from share/hawser/library beside
 * the program or the library that contains this function. Errors: INPUT with the places that were tried. */
hawser_status library_ship(Library *library, hawser_error *err);
/* Returns the path of shipped files ("share/hawser/library") beside the program or the library that contains this
 * function, or up to two folders above; malloc'ed; NULL: it is not there. */
char *shipped_find(const char *place);
/* Returns the entry of a name among kinds (a bit each, 1 << kind); the case's own includes come first. NULL: none. */
const LibraryEntry *library_find(const Library *library, unsigned kinds, const char *name);
/* Returns "'a', 'b' or 'c'": the names among kinds that are nearest to `name`; empty if there are none. */
void library_near(const Library *library, unsigned kinds, const char *name, size_t room, char *text);
/* Checks whether a key of an entry is about the entry, not a key of a case. */
int library_about(const char *key);
/* Returns a copy of the case's tree in which each `type` has added the keys of its entry that are not given beside it;
 * NULL if the case has no `type`, and then the library is not opened either. *library: owner of the entries that the
 * copy points at; NULL likewise. The caller frees both. Errors: INPUT, MEMORY. */
hawser_status library_expand(const CaseTree *tree, CaseNode **root, Library **library, hawser_error *err);

#endif
