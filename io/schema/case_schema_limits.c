/* The keys of the sections that the dynamics knows nothing of: what theory adds, and what is allowed. */
#include "io/schema/case_limits.h"
#include "io/schema/case_rows.h"
#include "io/schema/case_schema.h"

/* In the order of the enumerations that they stand for. */
static const char *const layouts[] = {"auto", "single", "pair", "triangle", "cradle", "diamond", NULL};
static const char *const codes[] = {"paper", "tb889", NULL};
static const char *const practices[] = {"chinese", "fujikura", "aeic", "rollers", NULL};
static const char *const attachments[] = {"eye", "net", NULL};
static const char *const metals[] = {"copper", "aluminium", NULL};
static const char *const sheaths[] = {"pe", "xlpe", NULL};

/* Straight into TheoryDef. */
static const CaseKey theory_keys[] = {
    {"cables", KEY_INTEGER, .fallback = "1", FROM(1, 4), AT(TheoryDef, cables)},
    {"layout", KEY_CHOICE, .fallback = "auto", .choices = layouts, AT(TheoryDef, layout)},
    {"reel", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, LONG), AT(TheoryDef, reel)},
    {"rope", KEY_NUMBER, DIM_LENGTH, .fallback = "0 m", FROM(0, LONG), AT(TheoryDef, rope)},
};
SECTION(case_theory, "theory", theory_keys);

static const CaseKey conductor_keys[] = {
    {"material", KEY_CHOICE, .required = 1, .choices = metals, AT(LimitsDef, metal)},
    {"area", KEY_NUMBER, DIM_AREA, .required = 1, ABOVE(0, 1), AT(LimitsDef, area)},
    {"cores", KEY_INTEGER, .fallback = "1", FROM(1, 4), AT(LimitsDef, cores)},
};
SECTION(case_conductor, "limits.conductor", conductor_keys);

static const CaseKey sheath_keys[] = {
    {"material", KEY_CHOICE, .required = 1, .choices = sheaths, AT(LimitsDef, sheath)},
    {"area", KEY_NUMBER, DIM_AREA, .required = 1, ABOVE(0, 1), AT(LimitsDef, sheath_area)},
};
SECTION(case_sheath, "limits.sheath", sheath_keys);

/* Straight into LimitsDef, the two sections included. Which values exclude each other is checked in case_limits.c. */
static const CaseKey limits_keys[] = {
    {"code", KEY_CHOICE, .fallback = "paper", .choices = codes, AT(LimitsDef, code)},
    {"attachment", KEY_CHOICE, .fallback = "eye", .choices = attachments, AT(LimitsDef, attachment)},
    {"conductor", KEY_MAP, .otherwise = "not known", .form = "section `limits.conductor`", AT(LimitsRecord, conductor)},
    {"sheath", KEY_MAP, .otherwise = "not known", .form = "section `limits.sheath`", AT(LimitsRecord, sheath)},
    {"K", KEY_NUMBER, .fallback = "1", ABOVE(0, 1), AT(LimitsDef, K)},
    {"stress", KEY_NUMBER, DIM_PRESSURE, .otherwise = "by `code`", ABOVE(0, STIFF), AT(LimitsDef, stress)},
    {"pull", KEY_NUMBER, DIM_FORCE, .otherwise = "by eq. 11", ABOVE(0, STRONG), AT(LimitsDef, pull)},
    {"practice", KEY_CHOICE, .fallback = "chinese", .choices = practices, AT(LimitsDef, practice)},
    {"sidewall", KEY_NUMBER, DIM_SPRING, .otherwise = "by `practice`", ABOVE(0, STRONG), AT(LimitsDef, sidewall)},
    {"bend_factor", KEY_NUMBER, .otherwise = "by `practice`", ABOVE(0, 1000), AT(LimitsDef, bend_factor)},
    {"bend_radius", KEY_NUMBER, DIM_LENGTH, .otherwise = "`bend_factor` times the cable's diameter", ABOVE(0, LONG),
     AT(LimitsDef, bend_radius)},
    {"roller_factor", KEY_NUMBER, .fallback = "1.6", FROM(1, 100), AT(LimitsDef, roller_factor)},
    {"rope_strength", KEY_NUMBER, DIM_FORCE, .otherwise = "not known", ABOVE(0, STRONG), AT(LimitsDef, rope_strength)},
    {"rope_factor", KEY_NUMBER, .fallback = "5", FROM(1, 100), AT(LimitsDef, rope_factor)},
    {"alpha", KEY_NUMBER, .fallback = "1.5", FROM(1, 100), AT(LimitsDef, alpha)},
};
SECTION(case_limits, "limits", limits_keys);
