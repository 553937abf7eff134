/* What codes, practices and makers allow: one table of rules, each with its clause and how well it is known. The
 * limits' sources, docs/reference/limits.md and the page are made from it. */
#ifndef HAWSER_DEF_LIMITS_H
#define HAWSER_DEF_LIMITS_H

#include <stddef.h>

#include "def/duct.h"
#include "hawser/hawser.h"

/* Whose rules count: the paper's table 4; CIGRE TB 889; American practice (ICEA, AEIC and IEEE 1185 are two names of
 * one set); cables to IEC and VDE as European makers quote them; TES-P-104.05; GB 50217. Behind these what only a
 * practice says (LimitPractice), and what is usual where nobody does. */
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

/* What practices tell cables apart by; UNKNOWN takes the strictest. SEPARATE: three cores, each with a sheath of its
 * own. */
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

/* What a rule says; a and b of code_rule in brackets, -1 where a rule holds for all. */
typedef enum Rule {
    RULE_CONDUCTOR,  /* Pa, of a conductor under an eye (ConductorMetal, 1 of several cores or cables together) */
    RULE_SHEATH,     /* Pa, of a sheath under a net (SheathKind) */
    RULE_UNDER_NET,  /* Pa, of the conductors where a net may not pull more than they bear (ConductorMetal) */
    RULE_ATTACHMENT, /* N, of one eye or net, whatever the cable bears (Attachment, SheathKind) */
    RULE_TOGETHER,   /* 1, share of n cables' sum that a rope may pull at (conductors, cables; 4 and more are 4) */
    RULE_SIDEWALL,   /* N/m (CableType, 1 of several cores) */
    RULE_BEND,       /* 1, radius over the cable's diameter (CableType) */
    RULE_OVAL,       /* 1, times D/d is the jam ratio: how much wider than round bends are taken for */
    RULE_JAM_FROM,   /* 1, three cables may jam from this jam ratio on ... */
    RULE_JAM_TO,     /* 1, ... to this (1 of a triangle) */
    RULE_CLEARANCE,  /* m, over the uppermost cable, at least */
    RULE_FILL,       /* 1, share of a duct that is filled, at most (cables) */
    RULE_ROPE_BEND,  /* 1 (RopeKind) */
    RULE_SPEED,      /* m/s */
    RULES
} Rule;

/* How well a rule is known: read in a public text of its source; quoted there by somebody else; recalled, and found in
 * no public text. */
typedef enum Known { KNOWN_READ, KNOWN_QUOTED, KNOWN_NOT_VERIFIED } Known;

/* A row of the table, in SI. */
typedef struct CodeRule {
    Rule rule;
    int code, a, b; /* -1: any */
    double value;
    const char *source; /* clause and value, as the source has it */
    Known known;
} CodeRule;

/* What is allowed, and by whom. */
typedef struct Allowed {
    double value; /* NAN: nobody says so */
    const char *source;
    int without; /* the code that has none where the value is a usual one; -1: it is the code's, or a key's */
    Known known;
} Allowed;

/* The first rule that fits; of a code without one what is usual. */
Allowed code_rule(Rule rule, int code, int a, int b);
/* The source in words: "tb889 has none; usual: ..." where the code says nothing, "(not verified)" behind what is
 * recalled. */
void allowed_say(Allowed allowed, char *text, size_t size);
/* "tb889". */
const char *code_name(int code);
/* Row i in SI; 0: there is none. For those who print the table. */
int code_row(size_t i, CodeRule *out);
/* What a cable, its rope and its rollers may bear, and whether a pull keeps to it. docs/model.md, "Limits". */

/* Whose sidewall pressure and bend radius count. AUTO: the code's. CHINESE: GB 50217. */
typedef enum LimitPractice {
    PRACTICE_AUTO,
    PRACTICE_CHINESE,
    PRACTICE_FUJIKURA,
    PRACTICE_AEIC,
    PRACTICE_ROLLERS
} LimitPractice;

/* What joins the rope to the cable, in words: the first three pull at the conductors, as an ATTACH_EYE, the others at
 * the sheath, as an ATTACH_NET. */
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

/* What is true of some kinds. */
enum {
    LIMIT_ESSENTIAL = 1, /* a pull is not called safe where this is not judged */
    LIMIT_AT_LEAST = 2,  /* the bound is the least that is allowed */
    LIMIT_PULLS = 4,     /* a force at the cable's head or the winch, which more pull adds to */
    LIMIT_TENSION = 8,   /* a tension, or one over something exact: a run's is as uncertain as the largest pull */
    LIMIT_STARTS = 16,   /* no tension, but a start from rest makes more of it, too */
    LIMIT_MENDED = 32,   /* a wider bend, another duct or less friction may make it hold */
    LIMIT_OF_DUCT = 64,  /* how the cables lie in a duct */
    LIMIT_OPTIONAL = 128 /* no code has a bound: it is judged where the case gives one */
};

/* The section `limits` of a case. NAN: not given, the code or practice says it. */
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
    double own[LIMIT_KINDS];           /* the bound that the case gives, in the kind's unit; of `pull` of one cable */
    double stress;                     /* Pa */
    double bend_factor;                /* of the cable's diameter */
    double roller_factor;              /* rating over load at steady speed */
    double rope_strength, rope_factor; /* N, breaking; strength over pull */
    int rope_kind;                     /* a RopeKind */
    double rope_diameter;              /* m */
    double sheave;                     /* m, diameter of the smallest sheave or drum that it runs round */
    double jam_from, jam_to;           /* jam ratio of three cables in a duct: not between these */
} LimitsDef;

/* What a calculation or a simulation found. */
typedef struct Finding {
    int absent;    /* it says nothing about this limit, which is then not listed */
    double value;  /* in the limit's unit; NAN: not known */
    double error;  /* of value: the error bar of a run's figure; 0: it has none */
    double start;  /* of value, to so many times of which a start from rest may come that was not followed; 0: it was */
    double rating; /* N, of the roller found; the critical load; of the run-away the largest tension, which its margin
                      is measured by */
    int cables;    /* in the duct found */
    int triangle;  /* and whether they are a triangle there */
    double steady; /* N, of a trip: the largest force that the winch needs by itself; NAN: the cable runs away */
    double beyond; /* N, of a trip: by what the winch pulls more than the cable's front, reckoned */
    char where[80]; /* its place */
    char why[160];  /* why it is not known; of the run-away what is missing or pushes; of buckling what holds */
} Finding;

/* "pull" of HAWSER_LIMIT_PULL and so on. */
const char *limits_name(hawser_limit_kind kind);
/* The kind of that name; LIMIT_KINDS: none. */
hawser_limit_kind limits_kind(const char *name);
/* "SAFE", or "SAFE ONLY IF friction at rest <= 0.2 (restart)", of limits that all hold. Returns how many conditions it
 * has. */
int limits_only_if(int n, const hawser_limit *limit, char *text, size_t size);
/* Whether one of these is true of the kind. */
int limits_is(hawser_limit_kind kind, int traits);
/* The jam ratios at which three cables may jam, in a triangle or not. */
typedef struct JamBand {
    double from, to;
    Allowed by; /* the code's rule; `value` NAN where the case gives both ends */
} JamBand;

JamBand limits_jam_band(const LimitsDef *def, int triangle);
/* Whether the jam ratio of that load is one at which three cables may jam, by the case or its code. */
int limits_jams(const LimitsDef *def, const DuctLoad *load);
/* ------------------------------------------------------------------------------- what is allowed: limits_allowed.c */

/* At which force a winch should stop, and why not at more. */
typedef struct TripSetting {
    double force; /* N; NAN: not known */
    const char *by;
} TripSetting;

/* What the winch should be set to trip at: alpha times the force that theory gives it, or what cable, eye, rope and
 * winch bear if that is less (LI11). beyond: as in a Finding. */
TripSetting limits_trip(const LimitsDef *def, int cables, double force, double beyond);
/* The bound of any kind for what was found, of `cables` equal cables of that diameter (m), in its unit, (LI3)-(LI12);
 * NAN with the reason and the key that is missing in `source` if it cannot be told. source: 160 bytes. And whether it
 * is the least that is allowed, not the most. */
double limits_allowed(const LimitsDef *def, hawser_limit_kind kind, double diameter, int cables, const Finding *f,
                      char *source);
/* ------------------------------------------------------------------------------------------------ to judge: limits.c
 */

/* The paper's values where nothing else is said. */
void limits_defaults(LimitsDef *def);
/* How a number of cables lies in ducts, against the worst of them: their findings of HAWSER_LIMIT_JAM_RATIO,
 * HAWSER_LIMIT_CLEARANCE, HAWSER_LIMIT_FILL and HAWSER_LIMIT_WEIGHT_CORRECTION into finding[LIMIT_KINDS]; begin with no
 * duct (name NULL). (LI8) */
void limits_duct(const LimitsDef *def, int cables, const char *name, const DuctLoad *load,
                 Finding finding[LIMIT_KINDS]);
/* As hawser_verdict; open: with the names of the limits that are not judged. */
int verdict_say(int n_conditions, const hawser_condition *condition, int n, const hawser_limit *limit, int open,
                char *text, size_t size);
/* How the source of `trip` begins where more is needed than is allowed. */
#define LIMITS_NO_TRIP "no trip does"
/* Sets the findings against the limits, (LI4): out[HAWSER_LIMITS_MAX]. Returns how many; 0 if def is not present. */
int limits_judge(const LimitsDef *def, double diameter, int cables, const Finding finding[LIMIT_KINDS],
                 hawser_limit *out);
/* How much of what is allowed a figure uses with its error bar, 1. */
double limits_reach(const hawser_limit *l);
/* The limit that the error bar of its figure reaches farthest beyond; NULL: there is none, or a limit is broken
 * whatever its error. */
const hawser_limit *limits_undecided(int n, const hawser_limit *limit);

#endif
