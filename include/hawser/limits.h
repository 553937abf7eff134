/* Limits and verdict of a pull: part of hawser/hawser.h, which includes it. docs/reference/limits.md explains each
 * limit and the sources of its values. */
#ifndef HAWSER_LIMITS_H
#define HAWSER_LIMITS_H

#include <stddef.h>

#include "hawser/shown.h"
#include "hawser/status.h"
#include "hawser/tables.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { HAWSER_LIMITS_MAX = 24, HAWSER_VERDICT_MAX = 2048 };

/* Kinds of limits. Numbers stay; new kinds come behind. */
typedef enum hawser_limit_kind {
    HAWSER_LIMIT_PULL,                 /* N, largest tension of the cable, borne by conductor or sheath */
    HAWSER_LIMIT_RESTART,              /* N, the same from rest */
    HAWSER_LIMIT_ATTACHMENT,           /* N, at the eye or net, borne by that device */
    HAWSER_LIMIT_SIDEWALL,             /* N/m, largest tension over radius in a bend */
    HAWSER_LIMIT_CONTACT_PRESSURE,     /* N/m, largest force per length on ducts, trays, floors and walls */
    HAWSER_LIMIT_BEND_RADIUS,          /* m, smallest radius of the cable */
    HAWSER_LIMIT_ROPE_BEND,            /* 1, smallest bending diameter of the rope over its own */
    HAWSER_LIMIT_ROLLER_STEADY,        /* N, largest load of a roller at steady speed */
    HAWSER_LIMIT_ROLLER_PEAK,          /* N, largest load of a roller at any time */
    HAWSER_LIMIT_ROPE,                 /* N, largest tension of the rope */
    HAWSER_LIMIT_WINCH,                /* N, largest force of the winch */
    HAWSER_LIMIT_PUSH,                 /* N, largest push of a machine */
    HAWSER_LIMIT_BUCKLING,             /* N, compression where it is nearest to the critical load there */
    HAWSER_LIMIT_SQUEEZE,              /* N/m, of belts on the cable */
    HAWSER_LIMIT_RUN_AWAY,             /* N, brake that is missing where the pull begins */
    HAWSER_LIMIT_ALPHA,                /* 1, largest force of the winch over that of theory */
    HAWSER_LIMIT_TRIP,                 /* N, at which the winch stops */
    HAWSER_LIMIT_SPEED,                /* m/s, of the winch or the fastest belt */
    HAWSER_LIMIT_JAM_RATIO,            /* 1, diameters of duct and cable, of three cables in a duct */
    HAWSER_LIMIT_CLEARANCE,            /* m, over the uppermost cable in a duct */
    HAWSER_LIMIT_FILL,                 /* 1, share of a duct that is filled */
    HAWSER_LIMIT_WEIGHT_CORRECTION,    /* 1, weight correction of several cables in a duct */
    HAWSER_LIMIT_CLEARANCE_ENVIRONMENT /* m, least between cable or rope and the environment */
} hawser_limit_kind;

/* One limit of a pull. */
typedef struct hawser_limit {
    const char *name; /* name of the kind: "pull" of HAWSER_LIMIT_PULL, "bend_radius" of HAWSER_LIMIT_BEND_RADIUS; lives
                       * for ever */
    const char *unit; /* "N", "N/m", "m", "m/s", "1" */
    double value;     /* worst value found, in `unit` */
    double limit;     /* largest allowed value; for bend_radius, rope_bend and clearance the smallest; for jam_ratio the
                       * nearer end of the band in which cables jam; for trip the nearer end of its allowed band */
    double margin; /* 1 - value/limit; where `limit` is the smallest allowed value 1 - limit/value: below 0 the limit is
                    * broken */
    int judged;    /* 0: value or limit is not known, and `source` gives the reason */
    int ok;        /* the limit holds; 0 if it was not judged */
    char where[80];   /* the place of `value`, "" if there is none */
    char source[160]; /* source of `limit`; if it was not judged the reason, and the case's key that is missing */
    double error;     /* numerical error of `value`, in its unit; 0: exact, or not known */
    double worst;     /* `value` at the unfavourable end of the usual range of one value that the case does not give */
    const char *assumed; /* that value: "friction", "friction at rest", "back tension", "radius at changes of slope";
                          * NULL: none changes it, and the following members have no meaning */
    /* Largest and smallest friction (1), largest friction at rest (1) and back tension (N) up to which all limits of a
     * pull hold that this value breaks; NAN: this limit holds throughout its usual range. */
    double friction_most, friction_least, rest_most, back_most;
    double slope_radius_least; /* m, smallest radius of changes of slope with which it holds, where the case gives none
                                * and the assumed one broke it: `value` is with this radius, `worst` with the assumed
                                * one; NAN: not applicable */
    hawser_limit_kind kind;
    int at_speed; /* it holds at speed, but a start from rest that was not simulated may break it: it is not judged, and
                   * the verdict cannot be SAFE (positions) */
} hawser_limit;

struct hawser_sim;

/* The first word of a verdict. Only SAFE is safe. */
typedef enum hawser_word {
    HAWSER_SAFE,         /* all limits hold, for all usual values of the assumptions */
    HAWSER_NOT_SAFE,     /* a limit is broken */
    HAWSER_NOT_JUDGED,   /* tension or sidewall pressure could not be judged */
    HAWSER_NOT_TRUSTED,  /* the figures are not reliable enough for a verdict */
    HAWSER_SAFE_ONLY_IF, /* a limit breaks within the usual range of a value that the case does not give */
    HAWSER_WORDS
} hawser_word;
/* Returns the word that belongs to a return value of hawser_verdict. */
hawser_word hawser_verdict_word(int found);
/* Returns the word as it is printed ("SAFE ONLY IF"). */
const char *hawser_word_text(hawser_word word);
/* Returns its code in files ("safe_if"). */
const char *hawser_word_code(hawser_word word);
/* Returns the word that a verdict begins with; HAWSER_WORDS: none. */
hawser_word hawser_word_of(const char *verdict);

/* Judges the figures of the simulation so far by the case's section `limits`. Fills out[HAWSER_LIMITS_MAX] and returns
 * how many limits there are: 0 if the case has no such section. */
int hawser_sim_limits(struct hawser_sim *s, hawser_limit *out);
/* Writes one line with the verdict: "SAFE: ...", "SAFE ONLY IF friction <= 0.27 ...: ...", "NOT SAFE: ..." or "NOT
 * JUDGED: ..."; at most `size` bytes (HAWSER_VERDICT_MAX is enough). A pull is not SAFE unless its tension and sidewall
 * pressure could be judged. Returns how many limits are broken; -1 if none is broken and either no limit or not both of
 * these two could be judged; -3 if a limit breaks within the usual range of a value that the case does not give. */
int hawser_limits_verdict(int n, const hawser_limit *limit, char *text, size_t size);

/* Does the same for a run with known conditions of trust: writes "NOT TRUSTED: ...", with the first that fails and the
 * number of further ones, and returns -2 if one of them fails, whatever the limits are; otherwise as above. */
int hawser_verdict(int n_conditions, const hawser_condition *condition, int n, const hawser_limit *limit, char *text,
                   size_t size);

struct hawser_case;

/* Options of a pulling calculation's text. Tables by name with commas between ("limits,heads"; "facts": the figures of
 * the whole; "all"; NULL: for readers the answer alone, with the sections of a pull that has pits, for programs all);
 * the width of a line for readers, 0: 118. */
typedef struct hawser_theory_options {
    const char *tables;
    int width;
} hawser_theory_options;
/* Does the same as hawser_case_theory, and returns the word of the verdict of a pull forward (of several chains the
 * first that is not SAFE). Errors: as above, and INPUT for a table that does not exist, with the names of the existing
 * ones. */
hawser_status hawser_case_theory_shown(struct hawser_case *c, hawser_format format,
                                       const hawser_theory_options *options, char **text, hawser_word *word,
                                       hawser_error *err);

#ifdef __cplusplus
}
#endif

#endif
