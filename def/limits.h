/* What a cable, its rope and its rollers may bear, and whether a pull keeps to it. docs/model.md, "Limits". */
#ifndef HAWSER_DEF_LIMITS_H
#define HAWSER_DEF_LIMITS_H

#include "def/cables/duct.h"
#include "def/codes.h"
#include "hawser/hawser.h"

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
int limits_at_least(const LimitsDef *def, hawser_limit_kind kind, const Finding *f);

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
