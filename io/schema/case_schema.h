/* The keys of a case file as tables: one row a key. They drive the reader (io/schema/case_fields.h), the tests of
 * bad input and the check that docs/case-format.md says the same. */
#ifndef HAWSER_IO_SCHEMA_CASE_SCHEMA_H
#define HAWSER_IO_SCHEMA_CASE_SCHEMA_H

#include <stddef.h>

#include "io/yaml/units.h"

/* What a value is, and what the key's place in the record holds. */
typedef enum KeyKind {
    KEY_NUMBER,  /* double, of a dimension */
    KEY_INTEGER, /* int or long, by size */
    KEY_FLAG,    /* int: true 1, false 0 */
    KEY_CHOICE,  /* int: which of the choices */
    KEY_TEXT,    /* char[size] */
    KEY_POINT,   /* Vec3, of a dimension */
    KEY_SECTION, /* a map, read into a record inside this one */
    KEY_MAP,     /* const CaseNode *: a map, read by code of its own */
    KEY_LIST,    /* const CaseNode *: a list, likewise */
    KEY_ANY      /* const CaseNode *: several forms are allowed */
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
    const char *form;                  /* maps, lists, any: what is allowed, in words */
    const struct CaseSection *section; /* KEY_SECTION: its keys */
    size_t offset, size;               /* in the record */
} CaseKey;

/* path: dotted, NAME for a key that the user chooses, N for a list's numbers; "" the whole case. */
typedef struct CaseSection {
    const char *path;
    int n;
    const CaseKey *key;
} CaseSection;

extern const CaseSection case_top, case_cable, case_damping_factor, case_damping_ratio, case_preload, case_bending,
    case_chain_piece, case_route, case_route_piece, case_lead_in, case_rollers, case_roller_row, case_groove, case_spin,
    case_bearing, case_mount, case_roller, case_surfaces, case_line_contact, case_duct, case_tray, case_plane,
    case_contact, case_friction, case_drive, case_winch, case_winch_tension, case_trip, case_tail, case_rope_drag,
    case_conveyor, case_belt, case_reel, case_brake, case_back_tension, case_run, case_solver, case_tolerances,
    case_output, case_stations, case_station, case_paper, case_paper_term, case_theory, case_limits, case_conductor,
    case_sheath, case_rod, case_rod_tail, case_rod_head, case_rod_motion, case_rod_load, case_rod_mass, case_probe;

/* All of them in the order of the documentation, NULL behind the last. */
const CaseSection *const *case_sections(void);

#endif
