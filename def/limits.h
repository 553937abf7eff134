/* Allowed values of codes, practices and makers: one table of rules, each with its clause and reliability. The limits'
 * sources, docs/reference/limits.md and the page are made from it. */
#ifndef HAWSER_DEF_LIMITS_H
#define HAWSER_DEF_LIMITS_H

#include <stddef.h>

#include "def/duct.h"
#include "hawser/hawser.h"

/* Source of the rules: the paper's table 4; CIGRE TB 889; American practice (ICEA, AEIC and IEEE 1185 are two names of
 * one set); cables to IEC and VDE as European makers quote them; TES-P-104.05; GB 50217. Then the sources used only by
 * a practice (LimitPractice), and usual values for the rest. */
typedef enum LimitCode {
    CODE_PAPER,
    CODE_TB889,
    CODE_AEIC,
    CODE_IEEE1185,
    CODE_IEC,
    CODE_TES,
    CODE_GB50217,
    CODES,
    CODE_FUJIKURA = CODES,
    CODE_ROLLERS,
    CODE_USUAL,
    CODE_BOOKS
} LimitCode;

typedef enum Attachment { ATTACH_EYE, ATTACH_NET } Attachment;

/* Cable types that practices distinguish; UNKNOWN takes the strictest. SEPARATE: three cores, each with its own sheath.
 */
typedef enum CableType {
    TYPE_UNKNOWN,
    TYPE_CONTROL,
    TYPE_POWER,
    TYPE_SHIELDED,
    TYPE_ARMOURED,
    TYPE_SEPARATE
} CableType;

typedef enum ConductorMetal { METAL_COPPER, METAL_ALUMINIUM } ConductorMetal;

typedef enum SheathKind { SHEATH_PE, SHEATH_XLPE, SHEATH_LEAD, SHEATH_COPPER, SHEATH_ALUMINIUM } SheathKind;

typedef enum RopeKind { ROPE_STEEL, ROPE_FIBRE } RopeKind;

/* Quantity of a rule; a and b of code_rule in brackets, -1 for a rule that holds for all. */
typedef enum Rule {
    RULE_CONDUCTOR,  /* Pa, of a conductor under an eye (ConductorMetal, 1 of several cores or cables together) */
    RULE_SHEATH,     /* Pa, of a sheath under a net (SheathKind) */
    RULE_UNDER_NET,  /* Pa, of the conductors, if a net is limited by their strength (ConductorMetal) */
    RULE_ATTACHMENT, /* N, of one eye or net, independent of the cable (Attachment, SheathKind) */
    RULE_TOGETHER,   /* 1, share of n cables' sum that a rope may pull with (conductors, cables; 4 and more are 4) */
    RULE_SIDEWALL,   /* N/m (CableType, 1 of several cores) */
    RULE_BEND,       /* 1, radius over the cable's diameter (CableType) */
    RULE_OVAL,       /* 1, factor on D/d for the jam ratio: widening of ducts in bends */
    RULE_JAM_FROM,   /* 1, least jam ratio at which three cables may jam ... */
    RULE_JAM_TO,     /* 1, ... and the largest (1 of a triangle) */
    RULE_CLEARANCE,  /* m, over the uppermost cable, least */
    RULE_FILL,       /* 1, filled share of a duct, largest (cables) */
    RULE_ROPE_BEND,  /* 1 (RopeKind) */
    RULE_SPEED,      /* m/s */
    RULES
} Rule;

/* Reliability of a rule: read in a public text of its source; quoted elsewhere; known, but found in no public text. */
typedef enum Known { KNOWN_READ, KNOWN_QUOTED, KNOWN_NOT_VERIFIED } Known;

/* A row of the table, in SI. */
typedef struct CodeRule {
    Rule rule;
    int code, a, b; /* -1: any */
    double value;
    const char *source; /* clause and value as in the source */
    Known known;
} CodeRule;

/* An allowed value and its source. */
typedef struct Allowed {
    double value; /* NAN: no source gives one */
    const char *source;
    int without; /* the code without a rule, if the value is a usual one; -1: the value is the code's or a key's */
    Known known;
} Allowed;

/* Finds the first rule that fits; for a code without one the usual value. */
Allowed code_rule(Rule rule, int code, int a, int b);
/* Writes the source: "tb889 has none; usual: ..." for a code without a rule, "(not verified)" for rules found in no
 * public text. */
void allowed_say(Allowed allowed, char *text, size_t size);
/* Returns the code's name, e.g. "tb889". */
const char *code_name(int code);
/* Copies row i in SI, for printing the table; returns 0 if there is none. */
int code_row(size_t i, CodeRule *out);
/* Strength of a cable, its rope and its rollers, and whether a pull respects it. docs/theory.md, "Limits". */

/* Source of sidewall pressure and bend radius. AUTO: the code's. CHINESE: GB 50217. */
typedef enum LimitPractice {
    PRACTICE_AUTO,
    PRACTICE_CHINESE,
    PRACTICE_FUJIKURA,
    PRACTICE_AEIC,
    PRACTICE_ROLLERS
} LimitPractice;

/* Device between rope and cable: the first three pull at the conductors, as an ATTACH_EYE, the others at the sheath, as
 * an ATTACH_NET. */
typedef enum AttachmentDevice {
    DEVICE_EYE,
    DEVICE_HEAD,
    DEVICE_COMPRESSION,
    DEVICE_NET,
    DEVICE_STOCKING,
    DEVICE_BASKET
} AttachmentDevice;

/* The limits are listed in the order of their kinds; def/limit_kinds.h has a row for each. */
enum {
    LIMIT_KINDS = 0
#define LIMIT(...) +1
#include "def/limit_kinds.h"
};

/* Traits of kinds. */
enum {
    LIMIT_ESSENTIAL = 1, /* a pull is never SAFE if this is not judged */
    LIMIT_AT_LEAST = 2,  /* the bound is a minimum */
    LIMIT_PULLS = 4,     /* a force at the cable's head or the winch, which grows with the pull */
    LIMIT_TENSION = 8,   /* a tension, or a tension over an exact quantity: the relative error of a run's figure is that
                            of its largest pull */
    LIMIT_STARTS = 16,   /* no tension, but also increased by a start from rest */
    LIMIT_MENDED = 32,   /* a wider bend, another duct or less friction may keep it */
    LIMIT_OF_DUCT = 64,  /* depends on the layout of the cables in a duct */
    LIMIT_OPTIONAL = 128 /* no code has a bound: it is judged only if the case gives one */
};

/* The section `limits` of a case. NAN: not given, the code or practice applies. */
typedef struct LimitsDef {
    int present;
    int code, practice, attachment;    /* a LimitCode, LimitPractice, Attachment */
    int cable_type;                    /* a CableType */
    int metal, cores;                  /* a ConductorMetal; conductors in one cable */
    double area;                       /* m2, of one conductor; 0: not known */
    int sheath;                        /* a SheathKind */
    double sheath_area;                /* m2, of its cross-section; 0: not known */
    double K;                          /* correction factor of eq. 11: 1 power cables, 0.6 control cables */
    int grips;                         /* eyes or nets that share the pull */
    double attachment_rating;          /* N, of each */
    int device;                        /* an AttachmentDevice */
    double swivel_rating;              /* N, of the swivel between rope and cable */
    double own[LIMIT_KINDS];           /* bound given by the case, in the kind's unit; that of `pull` is per cable */
    double stress;                     /* Pa */
    double bend_factor;                /* of the cable's diameter */
    double roller_factor;              /* rating over load at steady speed */
    double rope_strength, rope_factor; /* N, breaking; strength over pull */
    int rope_kind;                     /* a RopeKind */
    double rope_diameter;              /* m */
    double sheave;                     /* m, diameter of the smallest sheave or drum in the rope's path */
    double jam_from, jam_to;           /* forbidden range of the jam ratio of three cables in a duct */
} LimitsDef;

/* A value found by a calculation or a simulation. */
typedef struct Finding {
    int absent;     /* there is no such value: the limit is not listed */
    double value;   /* in the limit's unit; NAN: not known */
    double error;   /* of value: error bound of a run's figure; 0: none */
    double start;   /* factor on the value for a start from rest that was not simulated; 0: it was */
    double rating;  /* N, of the roller found; the critical load; for run-away the largest tension, to which its margin
                     * is relative */
    int cables;     /* in the duct found */
    int triangle;   /* and whether they are a triangle there */
    double steady;  /* N, of a trip: largest force that the winch needs by itself; NAN: the cable runs away */
    double beyond;  /* N, of a trip: computed excess of the winch force over the tension at the cable's front */
    char where[80]; /* its place */
    char why[160];  /* why it is unknown; for run-away what is missing or pushes; for buckling what holds the cable */
} Finding;

/* Name of a kind, e.g. "pull" of HAWSER_LIMIT_PULL. */
const char *limits_name(hawser_limit_kind kind);
/* The kind with that name; LIMIT_KINDS: none. */
hawser_limit_kind limits_kind(const char *name);
/* Writes "SAFE", or "SAFE ONLY IF friction at rest <= 0.2 (restart)", for limits that all hold. Returns the number of
 * conditions. */
int limits_only_if(int n, const hawser_limit *limit, char *text, size_t size);
/* Checks whether the kind has one of these traits. */
int limits_is(hawser_limit_kind kind, int traits);
/* Range of jam ratios at which three cables may jam, in a triangle or not. */
typedef struct JamBand {
    double from, to;
    Allowed by; /* the code's rule; `value` NAN if the case gives both ends */
} JamBand;

JamBand limits_jam_band(const LimitsDef *def, int triangle);
/* Checks whether three cables may jam at the jam ratio of that load, by the case or its code. */
int limits_jams(const LimitsDef *def, const DuctLoad *load);
/* ------------------------------------------------------------------------------- allowed values */

/* Force at which a winch should stop, and what bounds it. */
typedef struct TripSetting {
    double force; /* N; NAN: not known */
    const char *by;
} TripSetting;

/* Recommended trip: alpha times theory's force, or the strength of cable, eye, rope and winch if that is less (LI11).
 * beyond: as in a Finding. */
TripSetting limits_trip(const LimitsDef *def, int cables, double force, double beyond);
/* Bound of a kind for a finding, for `cables` equal cables of that diameter (m), in its unit, (LI3)-(LI12); NAN if
 * unknown, with the reason and the missing key in `source` (160 bytes). The second function checks whether the bound is
 * a minimum. */
double limits_allowed(const LimitsDef *def, hawser_limit_kind kind, double diameter, int cables, const Finding *f,
                      char *source);
/* ------------------------------------------------------------------------------------------------ judging */

/* Sets the paper's values as defaults. */
void limits_defaults(LimitsDef *def);
/* Compares the load of a number of cables in a duct with the worst so far: their findings of HAWSER_LIMIT_JAM_RATIO,
 * HAWSER_LIMIT_CLEARANCE, HAWSER_LIMIT_FILL and HAWSER_LIMIT_WEIGHT_CORRECTION in finding[LIMIT_KINDS]; a call without
 * a duct (name NULL) comes first. (LI8) */
void limits_duct(const LimitsDef *def, int cables, const char *name, const DuctLoad *load,
                 Finding finding[LIMIT_KINDS]);
/* Same as hawser_verdict; open: lists the limits that are not judged. */
int verdict_say(int n_conditions, const hawser_condition *condition, int n, const hawser_limit *limit, int open,
                char *text, size_t size);
/* Beginning of the source of `trip` if the required force exceeds the allowed one. */
#define LIMITS_NO_TRIP "no trip is possible"
/* Compares the findings with the limits, (LI4): out[HAWSER_LIMITS_MAX]. Returns their number; 0 if def is not present.
 */
int limits_judge(const LimitsDef *def, double diameter, int cables, const Finding finding[LIMIT_KINDS],
                 hawser_limit *out);
/* Share of the allowed value that a figure uses, error bound included, 1. */
double limits_reach(const hawser_limit *l);
/* The limit that the error bound of its figure exceeds most; NULL: none, or a limit is broken whatever its error. */
const hawser_limit *limits_undecided(int n, const hawser_limit *limit);

#endif
