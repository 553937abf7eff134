/* What codes, practices and makers allow: one table of rules, each with its clause and how well it is known. The
 * limits' sources, docs/limits.md and the page are made from it. */
#ifndef HAWSER_DEF_CODES_H
#define HAWSER_DEF_CODES_H

#include <stddef.h>

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

#endif
