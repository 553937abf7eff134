/* The keys of a case as tables, one row a key, and the reader that fills plain structs by them. A section's table
 * stands at the head of the file that reads it (io/case); its rows point straight into the definition wherever no
 * meaning has to be computed. The tables also drive the tests of bad input and the check that docs/case-format.md says
 * the same. */
#ifndef HAWSER_IO_CASE_SCHEMA_H
#define HAWSER_IO_CASE_SCHEMA_H

#include <stddef.h>

#include "core/route.h"
#include "def/scene_def.h"
#include "io/case/units.h"
#include "io/case/yaml.h"

/* What a value is, and what the key's place holds. */
typedef enum KeyKind {
    KEY_NUMBER,  /* double, of a dimension; NAN: not given and without a default */
    KEY_INTEGER, /* int or long, by size */
    KEY_FLAG,    /* int: true 1, false 0 */
    KEY_CHOICE,  /* int or an enumeration: which of the choices */
    KEY_TEXT,    /* char[size] */
    KEY_POINT,   /* Vec3, of a dimension */
    KEY_SECTION, /* a map, read into the struct there: this one again, or one inside it */
    KEY_MAP,     /* a map; no place: its reader finds it in the tree */
    KEY_LIST,    /* a list, likewise */
    KEY_ANY      /* several forms are allowed, likewise */
} KeyKind;

typedef struct CaseKey {
    const char *name;
    KeyKind kind;
    Dimension dimension;
    int required;
    const char *fallback;              /* what an absent key means, as it would be written; NULL: see `otherwise` */
    const char *otherwise;             /* the same in words, for the documentation */
    double min, max;                   /* numbers, integers: allowed range, SI */
    int above;                         /* min itself is not allowed */
    const char *const *choices;        /* NULL behind the last */
    const char *form;                  /* maps, lists, any: what is allowed, in words; NULL: the section */
    const struct CaseSection *section; /* of a map its keys, of a list those of each item */
    size_t offset, size;               /* in the struct that is filled */
} CaseKey;

/* path: dotted, NAME for a key that the user chooses, N for a list's numbers; "" the whole case. */
typedef struct CaseSection {
    const char *path;
    int n;
    const CaseKey *key;
} CaseSection;

/* How rows are written. Ranges are wide: they keep out what cannot be meant or computed, not what is unusual. Lengths
 * to 1000 km, forces to 1 GN, moduli to 1000 TPa. */
#define AT(type, member)            .offset = offsetof(type, member), .size = sizeof(((type *)NULL)->member)
#define FROM(lowest, highest)       .min = (lowest), .max = (highest)
#define ABOVE(lowest, highest)      .min = (lowest), .max = (highest), .above = 1
#define SECTION(name_, path_, rows) const CaseSection name_ = {path_, (int)(sizeof(rows) / sizeof *(rows)), rows}
#define LONG                        1e6
#define STRONG                      1e9
#define STIFF                       1e15
#define TURNS                       1e12 /* of bending: a solid bar of steel of 2 m has 2e11; with 1e15 a run stood still for ever */
#define LATE                        1e9
#define DEGREES(a)                  ((a)*3.14159265358979323846 / 180)
/* "none", "step", "step5": a ProfileKind each. */
extern const char *const case_ramps[];

/* How a value comes in over time, into the Profile at an offset; case_profile_read takes it from there. */
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
    Route route;          /* built once its section is read, for what lies along it */
    double route_station; /* m: the number of the route's file for where the route begins */
    int stations;         /* how these numbers go along it: 1 rising, -1 falling, 0: it has none */
    const CaseNode *root;
    CaseNode *own;      /* the same where it may be added to: a copy; NULL: nobody adds to it */
    const char *folder; /* where files are looked for that it names; NULL: nowhere */
    hawser_error *err;
} CaseReader;

/* Fills `record` from a map: unknown keys, missing ones, types, units and ranges are errors (INPUT). node
 * NULL: the section is not there; optional keys get their defaults, required ones zeros. */
hawser_status case_section_read(const CaseReader *r, const CaseNode *node, const CaseSection *section, void *record);
/* Reads one item of a list into its place, which is zero. */
typedef hawser_status (*CaseItemRead)(const CaseReader *r, const CaseNode *node, void *item);

/* A list's items one by one into an array of structs of `size` bytes. `array`: address of the pointer to it, which gets
 * memory of its own even if there is an error; *n grows as items are begun. list NULL: nothing. Errors: the items',
 * MEMORY. */
hawser_status case_list_read(const CaseReader *r, const CaseNode *list, size_t size, CaseItemRead read, void *array,
                             int *n);
/* One number of the key's dimension and range, SI. Errors: INPUT. */
hawser_status case_number_read(const CaseReader *r, const CaseNode *node, const CaseKey *key, double *value);
/* A list of n numbers, each of its key. Errors: INPUT. */
hawser_status case_numbers_read(const CaseReader *r, const CaseNode *node, int n, const CaseKey *const key[],
                                double value[]);
/* One whole number. Errors: INPUT. */
hawser_status case_integer_read(const CaseReader *r, const CaseNode *node, const CaseKey *key, long *value);
/* A key that says nothing where all those beside it are given: what it stands for they say. */
typedef struct KeyIdle {
    const char *key, *beside[3];
} KeyIdle;

/* Whoever changes such a key would change nothing and not know: that is an error. Errors: INPUT. */
hawser_status case_idle_check(const CaseReader *r, const CaseNode *node, int n, const KeyIdle *rule);
/* Whether a number that was read lies in the key's range. Errors: INPUT. */
hawser_status case_range_check(const CaseReader *r, const CaseNode *node, const CaseKey *key, double value);
/* The place of a text among words, NULL behind the last; -1 if it is none of them, or no text. */
int case_word_place(const CaseNode *node, const char *const *word);
/* The row of a key that the section is known to have. */
const CaseKey *case_key_of(const CaseSection *section, const char *name);
/* Meaning of a key, from io/case/key_words.c; "": there is none. */
const char *case_key_meaning(const CaseSection *section, const CaseKey *key);
/* Text on a section as a whole, from the same file; "": there is none. */
const char *case_section_note(const CaseSection *section);
/* Adds to r->def->assumptions what of a file that node names is not in the route. Errors: MEMORY. */
hawser_status case_unread_add(const CaseReader *r, const CaseNode *node, const char *what, long times);
/* The same of what was found in the file, or estimated from it, and decides something. */
hawser_status case_found_add(const CaseReader *r, const CaseNode *node, const char *value, int estimated,
                             const char *source);
/* Fills r->def->assumptions with what the catalogue and estimates have put in, once all else has been read. node: the
 * section of cables. Errors: MEMORY. */
hawser_status case_assumptions_read(CaseReader *r, const CaseNode *node);
/* Fills r->def->inputs once all else has been read: every key of the case with its value and where that comes from.
 * top: the table of the whole case. Errors: MEMORY. */
hawser_status case_inputs_read(CaseReader *r, const CaseSection *top);
enum { CASE_SECTIONS_MAX = 100, CASE_RANGE_MAX = 96, CASE_FORM_MAX = 128 };

/* Adds a section and all below it to all[CASE_SECTIONS_MAX], which has n; returns how many it has then. */
int case_sections(const CaseSection *section, const CaseSection *all[], int n);
/* "above 0 m, at most 1e6 m": what a number may be, in the dimension's SI unit, angles in degrees. `text` has
 * CASE_RANGE_MAX bytes. */
const char *case_range_text(const CaseKey *key, char *text);
/* What a map, list or any may be, in words. `text` has CASE_FORM_MAX bytes. */
const char *case_form_text(const CaseKey *key, char *text);

#endif
