/* The catalogue: cables, ropes, rollers, ducts, friction and reels that a case refers to by name
 * (docs/guide/equipment.md). Entries are maps of the case's own keys, in files of YAML: those that are shipped and
 * those that a case includes. What is said of an entry itself stands beside its keys: `source`, `range`, `mark`,
 * `note`. */
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

/* The names of the kinds, as sections of the files; NULL behind the last. */
extern const char *const library_kinds[];

/* INPUT: what is none of them. */
hawser_status library_kind_error(const char *kind, hawser_error *err);
typedef struct LibraryEntry {
    LibraryKind kind;
    int shipped; /* 0: from a file that the case includes */
    const char *name;
    const CaseNode *node; /* its map */
    const char *source;   /* in words; of a user's entry perhaps its file's name alone */
    const char *mark;     /* "typical", "estimated" */
    const char *note;     /* NULL: none */
} LibraryEntry;

enum { LIBRARY_FILES_MAX = 128, LIBRARY_ENTRIES_MAX = 20000, LIBRARY_DEPTH_MAX = 8, LIBRARY_FILE_BYTES = 4 << 20 };

typedef struct Library {
    CaseTree *file[LIBRARY_FILES_MAX]; /* [n_files] owned; names and texts of the entries are theirs */
    int n_files, n_entries, room;
    LibraryEntry *entry; /* [n_entries] owned; nodes that were merged point at them: it no longer grows then */
} Library;

/* Empty; NULL if there is no memory. */
Library *library_new(void);
Library *library_free(Library *library);
/* The same of a tree that has been read, which is the library's from then on. */
hawser_status library_take(Library *library, CaseTree *file, int shipped, hawser_error *err);
/* Adds the shipped files: of the folder HAWSER_LIBRARY if the environment names one, else of share/hawser/library
 * beside the program or the library that this function is in. Errors: INPUT that says where it was looked for. */
hawser_status library_ship(Library *library, hawser_error *err);
/* What is shipped in a place ("share/hawser/library") beside the program or the library that this function is in, or up
 * to two folders above; malloc'ed; NULL: it is not there. */
char *shipped_find(const char *place);
/* The entry of a name among kinds (a bit each, 1 << kind); what the case includes comes first. NULL: none. */
const LibraryEntry *library_find(const Library *library, unsigned kinds, const char *name);
/* "'a', 'b' or 'c'": names among kinds that are nearest to `name`; empty if there are none. */
void library_near(const Library *library, unsigned kinds, const char *name, size_t room, char *text);
/* Whether a key of an entry is about the entry, not of the case. */
int library_about(const char *key);
/* A copy of the case's tree in which each `type` has brought the keys of its entry that are not given beside it; NULL
 * if the case has no `type`, and then the library is not opened either. *library: whose entries the copy points at;
 * NULL likewise. The caller frees both. Errors: INPUT, MEMORY. */
hawser_status library_expand(const CaseTree *tree, CaseNode **root, Library **library, hawser_error *err);

#endif
