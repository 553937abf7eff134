/* What a cable, its rope and its rollers may bear, and whether a pull keeps to it. docs/model.md, "Limits". */
#ifndef HAWSER_THEORY_LIMITS_H
#define HAWSER_THEORY_LIMITS_H

#include "hawser/hawser.h"
#include "theory/duct.h"

/* Whose allowable stresses count: the paper's table 4, or CIGRE TB 889. */
typedef enum LimitCode { CODE_PAPER, CODE_TB889 } LimitCode;
/* Whose sidewall pressure and bend radius count. */
typedef enum LimitPractice { PRACTICE_CHINESE, PRACTICE_FUJIKURA, PRACTICE_AEIC, PRACTICE_ROLLERS } LimitPractice;
typedef enum Attachment { ATTACH_EYE, ATTACH_NET } Attachment;
typedef enum ConductorMetal { METAL_COPPER, METAL_ALUMINIUM } ConductorMetal;
typedef enum SheathKind { SHEATH_PE, SHEATH_XLPE } SheathKind;

/* The section `limits` of a case. NAN: not given, the code or practice says it. */
typedef struct LimitsDef {
    int present;
    int code, practice, attachment;    /* a LimitCode, LimitPractice, Attachment */
    int metal, cores;                  /* a ConductorMetal; conductors in one cable */
    double area;                       /* m2, of one conductor; 0: not known */
    int sheath;                        /* a SheathKind */
    double sheath_area;                /* m2, of its cross-section; 0: not known */
    double K;                          /* correction factor of eq. 11: 1 power cables, 0.6 control cables */
    double stress, pull;               /* Pa; N */
    double sidewall;                   /* N/m */
    double bend_factor, bend_radius;   /* of the cable's diameter; m */
    double roller_factor;              /* rating over load at steady speed */
    double rope_strength, rope_factor; /* N, breaking; strength over pull */
    double alpha;                      /* largest overload factor of eq. 12 */
    double jam_from, jam_to;           /* 1.05 D/d of three cables in a duct: not between these */
    double clearance, fill; /* m, over the uppermost cable in a duct, at least; share of it that is filled, at most */
} LimitsDef;

/* The order in which limits are listed. */
typedef enum LimitKind {
    LIMIT_PULL,
    LIMIT_RESTART,
    LIMIT_SIDEWALL,
    LIMIT_BEND,
    LIMIT_ROLLER_STEADY,
    LIMIT_ROLLER_PEAK,
    LIMIT_ROPE,
    LIMIT_ALPHA,
    LIMIT_JAM,
    LIMIT_CLEARANCE,
    LIMIT_FILL,
    LIMIT_KINDS
} LimitKind;

/* What a calculation or a simulation found. */
typedef struct Finding {
    int absent;     /* it says nothing about this limit, which is then not listed */
    double value;   /* in the limit's unit; NAN: not known */
    double rating;  /* N, of the roller found */
    int cables;     /* in the duct found */
    char where[80]; /* its place */
    char why[100];  /* why it is not known */
} Finding;

/* The paper's values where nothing else is said. */
void limits_defaults(LimitsDef *def);
/* Allowable pulling force at the head of `cables` equal cables, N, by eq. 11 (LI3); NAN with the reason in `source` if
 * it cannot be told. source: 160 bytes. */
double limits_pull(const LimitsDef *def, int cables, char *source);
/* Allowable sidewall pressure, N/m, and smallest radius of a cable of diameter d, m; likewise. */
double limits_sidewall(const LimitsDef *def, char *source);
double limits_radius(const LimitsDef *def, double d, char *source);
/* How a number of cables lies in ducts, against the worst of them: their findings of LIMIT_JAM, LIMIT_CLEARANCE and
 * LIMIT_FILL into finding[LIMIT_KINDS]; begin with no duct (name NULL). (LI8) */
void limits_duct(const LimitsDef *def, int cables, const char *name, const DuctLoad *load,
                 Finding finding[LIMIT_KINDS]);
/* Sets the findings against the limits, (LI4): out[HAWSER_LIMITS_MAX]. Returns how many; 0 if def is not present. */
int limits_judge(const LimitsDef *def, double diameter, int cables, const Finding finding[LIMIT_KINDS],
                 hawser_limit *out);

#endif
