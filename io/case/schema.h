/* The keys of a case as tables, one row a key, and the reader that fills plain structs by them. A section's table is at
 * the head of the file that reads it (io/case); its rows point into the definition wherever nothing has to be computed.
 * The tables also drive the tests of bad input and docs/reference/case-keys.md. */
#ifndef HAWSER_IO_CASE_SCHEMA_H
#define HAWSER_IO_CASE_SCHEMA_H

#include <stddef.h>

#include "core/route.h"
#include "def/scene_def.h"
#include "io/case/units.h"
#include "io/case/yaml.h"

/* Kinds of values, and the type of the key's member. */
typedef enum KeyKind {
    KEY_NUMBER,  /* double, of a dimension; NAN: not given and without a default */
    KEY_INTEGER, /* int or long, by size */
    KEY_FLAG,    /* int: true 1, false 0 */
    KEY_CHOICE,  /* int or an enumeration: index of the choice */
    KEY_TEXT,    /* char[size] */
    KEY_POINT,   /* Vec3, of a dimension */
    KEY_SECTION, /* a map, read into the struct there: the same struct, or one inside it */
    KEY_MAP,     /* a map; no member: its reader finds it in the tree */
    KEY_LIST,    /* a list, likewise */
    KEY_ANY      /* several forms are allowed, likewise */
} KeyKind;

typedef struct CaseKey {
    const char *name;
    KeyKind kind;
    Dimension dimension;
    int required;
    const char *fallback;              /* meaning of an absent key, as it would be written; NULL: see `otherwise` */
    const char *otherwise;             /* the same as text, for the documentation */
    double min, max;                   /* numbers, integers: allowed range, SI */
    int above;                         /* min itself is not allowed */
    const char *const *choices;        /* NULL behind the last */
    const char *form;                  /* maps, lists, any: allowed forms, as text; NULL: the section */
    const struct CaseSection *section; /* of a map: its keys; of a list: those of each item */
    size_t offset, size;               /* place in the struct that is filled */
    const char *meaning;               /* as text; NULL: io/case/key_words.c has it */
} CaseKey;

/* path: dotted, NAME for a key that the user chooses, N for a list's numbers; "" the whole case. */
typedef struct CaseSection {
    const char *path;
    int n;
    const CaseKey *key;
} CaseSection;

/* Helpers for the rows. Ranges are wide: they exclude values that cannot be meant or computed, not unusual ones.
 * Lengths to 1000 km, forces to 1 GN, moduli to 1000 TPa. */
#define AT(type, member)            .offset = offsetof(type, member), .size = sizeof(((type *)NULL)->member)
#define FROM(lowest, highest)       .min = (lowest), .max = (highest)
#define ABOVE(lowest, highest)      .min = (lowest), .max = (highest), .above = 1
#define SECTION(name_, path_, rows) const CaseSection name_ = {path_, (int)(sizeof(rows) / sizeof *(rows)), rows}
#define LONG                        1e6
#define STRONG                      1e9
#define STIFF                       1e15
#define TURNS                       1e12 /* of bending: a solid bar of steel of 2 m has 2e11; with 1e15 a run did not advance */
#define LATE                        1e9
#define DEGREES(a)                  ((a)*3.14159265358979323846 / 180)
/* "none", "step", "step5": a ProfileKind each. */
extern const char *const case_ramps[];

/* Rows for a value that starts over time, into the Profile at an offset; case_profile_read completes it. */
#define IN_PROFILE(at, member) .offset = (at) + offsetof(Profile, member), .size = sizeof(((Profile *)NULL)->member)
#define RAMP_KEYS(at, usual)                                                                                           \
    {"ramp", KEY_CHOICE, .fallback = (usual), .choices = case_ramps, IN_PROFILE(at, kind)},                            \
        {"from", KEY_NUMBER, DIM_TIME, .fallback = "0 s", FROM(0, LATE), IN_PROFILE(at, t0)},                          \
    {                                                                                                                  \
        "to", KEY_NUMBER, DIM_TIME, .fallback = "1 s", FROM(0, LATE), IN_PROFILE(at, t1)                               \
    }
/* One case being read. */
typedef struct CaseReader {
    Units *units;
    SceneDef *def;
    Route route;          /* built once its section is read, for the parts along it */
    double route_station; /* m: station of the route's start in its file's numbers */
    int stations;         /* direction of these numbers along it: 1 rising, -1 falling, 0: it has none */
    const CaseNode *root;
    CaseNode *own;      /* copy of the tree that may be added to; NULL: none is needed */
    const char *folder; /* folder of the files that it names; NULL: none */
    hawser_error *err;
} CaseReader;

/* Fills `record` from a map: unknown keys, missing ones, types, units and ranges are errors (INPUT). node
 * NULL: the section is not there; optional keys get their defaults, required ones zeros. */
hawser_status case_section_read(const CaseReader *r, const CaseNode *node, const CaseSection *section, void *record);
/* Reads one item of a list into its place, which is zero. */
typedef hawser_status (*CaseItemRead)(const CaseReader *r, const CaseNode *node, void *item);

/* Reads a list's items one by one into an array of structs of `size` bytes. `array`: address of the pointer to it,
 * which gets memory of its own even if there is an error; *n grows as items are begun. list NULL: nothing. Errors: the
 * items', MEMORY. */
hawser_status case_list_read(const CaseReader *r, const CaseNode *list, size_t size, CaseItemRead read, void *array,
                             int *n);
/* Reads one number of the key's dimension and range, SI. Errors: INPUT. */
hawser_status case_number_read(const CaseReader *r, const CaseNode *node, const CaseKey *key, double *value);
/* Reads a list of n numbers, each of its key. Errors: INPUT. */
hawser_status case_numbers_read(const CaseReader *r, const CaseNode *node, int n, const CaseKey *const key[],
                                double value[]);
/* Reads one whole number. Errors: INPUT. */
hawser_status case_integer_read(const CaseReader *r, const CaseNode *node, const CaseKey *key, long *value);
/* A key without effect where all keys of `beside` are given, since these replace it. */
typedef struct KeyIdle {
    const char *key, *beside[3];
} KeyIdle;

/* Rejects such a key: a change of it would have no effect. Errors: INPUT. */
hawser_status case_idle_check(const CaseReader *r, const CaseNode *node, int n, const KeyIdle *rule);
/* Checks that a number that was read lies in the key's range. Errors: INPUT. */
hawser_status case_range_check(const CaseReader *r, const CaseNode *node, const CaseKey *key, double value);
/* Returns the index of a text among words, NULL behind the last; -1 if it is none of them, or no text. */
int case_word_place(const CaseNode *node, const char *const *word);
/* Returns the row of a key; the section must have it. */
const CaseKey *case_key_of(const CaseSection *section, const char *name);
/* Meaning of a key in a language, from io/case/key_words.c, or its own, which is English alone; "": there is none. */
const char *case_key_meaning(const CaseSection *section, const CaseKey *key, Language language);
/* Text on a section as a whole, from the same file; "": there is none. */
const char *case_section_note(const CaseSection *section);
/* Finds the path of the file that a section's key `file` names, relative to the case's folder; malloc'ed, the caller's.
 * Errors: INPUT (a case that is a text has no folder), MEMORY. */
hawser_status case_file_path(const CaseReader *r, const CaseNode *section, const char *file, char **path);
/* Adds to r->def->assumptions what of a file that node names is not in the route. Errors: MEMORY. */
hawser_status case_unread_add(const CaseReader *r, const CaseNode *node, const char *what, long times);
/* Does the same for a value that was found in the file, or estimated from it, and decides something. */
hawser_status case_found_add(const CaseReader *r, const CaseNode *node, const char *value, int estimated,
                             const char *source);
/* Fills r->def->assumptions with values of the catalogue and estimates, once all else has been read. node: the section
 * of cables. Errors: MEMORY. */
hawser_status case_assumptions_read(CaseReader *r, const CaseNode *node);
/* Fills r->def->inputs once all else has been read: every key of the case with its value and source. top: the table of
 * the whole case. Errors: MEMORY. */
hawser_status case_inputs_read(CaseReader *r, const CaseSection *top);
enum { CASE_SECTIONS_MAX = 100, CASE_RANGE_MAX = 96, CASE_FORM_MAX = 128 };

/* Adds a section and all below it to all[CASE_SECTIONS_MAX], which has n; returns how many it has then. */
int case_sections(const CaseSection *section, const CaseSection *all[], int n);
/* Writes the range of a number, "above 0 m, at most 1e6 m", in the dimension's SI unit, angles in degrees. `text` has
 * CASE_RANGE_MAX bytes. */
const char *case_range_text(const CaseKey *key, char *text);
/* Writes the allowed forms of a map, list or any. `text` has CASE_FORM_MAX bytes. */
const char *case_form_text(const CaseKey *key, char *text);

#endif
