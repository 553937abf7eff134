/* Whether a pull is safe: part of hawser/hawser.h, which includes it. What each limit means, and where its values come
 * from, is in docs/reference/limits.md. */
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

/* Which limit it is. Numbers stay; new kinds come behind. */
typedef enum hawser_limit_kind {
    HAWSER_LIMIT_PULL,             /* N, largest tension of the cable, borne by conductor or sheath */
    HAWSER_LIMIT_RESTART,          /* N, the same from rest */
    HAWSER_LIMIT_ATTACHMENT,       /* N, at the eye or net, borne by that device */
    HAWSER_LIMIT_SIDEWALL,         /* N/m, largest tension over radius in a bend */
    HAWSER_LIMIT_CONTACT_PRESSURE, /* N/m, largest force per length on ducts, trays, floors and walls */
    HAWSER_LIMIT_BEND_RADIUS,      /* m, smallest radius of the cable */
    HAWSER_LIMIT_ROPE_BEND,        /* 1, smallest bending diameter of the rope over its own */
    HAWSER_LIMIT_ROLLER_STEADY,    /* N, largest load of a roller at steady speed */
    HAWSER_LIMIT_ROLLER_PEAK,      /* N, largest load of a roller at any time */
    HAWSER_LIMIT_ROPE,             /* N, largest tension of the rope */
    HAWSER_LIMIT_WINCH,            /* N, largest force of the winch */
    HAWSER_LIMIT_PUSH,             /* N, largest push of a machine */
    HAWSER_LIMIT_BUCKLING,         /* N, compression where it is nearest to the critical load there */
    HAWSER_LIMIT_SQUEEZE,          /* N/m, of belts on the cable */
    HAWSER_LIMIT_RUN_AWAY,         /* N, brake that is missing where the pull begins */
    HAWSER_LIMIT_ALPHA,            /* 1, largest force of the winch over that of theory */
    HAWSER_LIMIT_TRIP,             /* N, at which the winch stops */
    HAWSER_LIMIT_SPEED,            /* m/s, of the winch or the fastest belt */
    HAWSER_LIMIT_JAM_RATIO,        /* 1, diameters of duct and cable, of three cables in a duct */
    HAWSER_LIMIT_CLEARANCE,        /* m, over the uppermost cable in a duct */
    HAWSER_LIMIT_FILL,             /* 1, share of a duct that is filled */
    HAWSER_LIMIT_WEIGHT_CORRECTION /* 1, weight correction of several cables in a duct */
} hawser_limit_kind;

/* One limit of a pull. */
typedef struct hawser_limit {
    const char *name; /* of its kind: "pull" of HAWSER_LIMIT_PULL, "bend_radius" of HAWSER_LIMIT_BEND_RADIUS; lives for
                       * ever */
    const char *unit; /* "N", "N/m", "m", "m/s", "1" */
    double value;     /* what was found, in `unit`: the worst */
    double limit;     /* what is allowed: at most, of bend_radius, rope_bend and clearance at least; of jam_ratio the
                       * nearer end of the band in which cables jam; of trip that of the band in which it may be */
    double margin;    /* 1 - value/limit, where it is the least that is allowed 1 - limit/value: below 0 the limit is
                       * broken */
    int judged;       /* 0: value or limit is not known, and `source` says why */
    int ok;           /* the limit holds; 0 if it was not judged */
    char where[80];   /* the place of `value`, "" if there is none */
    char source[160]; /* where `limit` comes from; if it was not judged why, and the case's key that is missing */
    double error; /* of `value`, in its unit: what it may be off by through the numbers of a run; 0: exact, or nobody
                   * knows */
    double worst; /* `value` at the unfavourable end of the usual range of one value that the case does not give */
    const char *assumed; /* which: "friction", "friction at rest", "back tension", "radius at changes of slope"; NULL:
                          * none changes it, and what follows says nothing */
    /* Up to which friction (1), down to which, up to which friction at rest (1) and back tension (N) the limits of a
     * pull hold that this value breaks, all of them at once; NAN: this limit holds throughout its usual range. */
    double friction_most, friction_least, rest_most, back_most;
    double slope_radius_least; /* m, from which radius of changes of slope on it holds, where the case gives none and
                                * the one taken broke it: `value` is with this radius, `worst` with that one; NAN: no
                                * matter */
    hawser_limit_kind kind;
    int at_speed; /* it holds at speed, but a start from rest that was not followed may break it: it is not judged, and
                   * nothing is called safe beside it (positions) */
} hawser_limit;

struct hawser_sim;

/* The word that a verdict begins with. Only SAFE is safe. */
typedef enum hawser_word {
    HAWSER_SAFE,         /* all limits hold, whatever is assumed */
    HAWSER_NOT_SAFE,     /* a limit is broken */
    HAWSER_NOT_JUDGED,   /* tension or sidewall pressure could not be judged */
    HAWSER_NOT_TRUSTED,  /* the figures are not good enough to judge by */
    HAWSER_SAFE_ONLY_IF, /* a limit breaks within the usual range of a value that the case does not give */
    HAWSER_WORDS
} hawser_word;
/* Of what hawser_verdict returned. */
hawser_word hawser_verdict_word(int found);
/* The word as it is printed ("SAFE ONLY IF"). */
const char *hawser_word_text(hawser_word word);
/* Its code in files ("safe_if"). */
const char *hawser_word_code(hawser_word word);
/* The word that a verdict begins with; HAWSER_WORDS: none. */
hawser_word hawser_word_of(const char *verdict);

/* Judges what the simulation has seen so far by the case's section `limits`. Fills out[HAWSER_LIMITS_MAX] and returns
 * how many limits there are: 0 if the case has no such section. */
int hawser_sim_limits(struct hawser_sim *s, hawser_limit *out);
/* One line that says whether the pull is safe: "SAFE: ...", "SAFE ONLY IF friction <= 0.27 ...: ...", "NOT SAFE: ..."
 * or "NOT JUDGED: ..."; at most `size` bytes (HAWSER_VERDICT_MAX is enough). A pull is not safe before its tension and
 * sidewall pressure could be judged. Returns how many limits are broken; -1 if none is and none, or one of those two
 * not, could be judged; -3 if a limit breaks within the usual range of a value that the case does not give. */
int hawser_limits_verdict(int n, const hawser_limit *limit, char *text, size_t size);

/* The same for a run of which the conditions are known: "NOT TRUSTED: ...", with the first that fails and how many more
 * do, and -2 if one of them fails, whatever the limits say; otherwise as above. */
int hawser_verdict(int n_conditions, const hawser_condition *condition, int n, const hawser_limit *limit, char *text,
                   size_t size);

struct hawser_case;

/* What is shown of a pulling calculation: tables by name with commas between ("limits,heads"; "facts": the figures of
 * the whole; "all"; NULL: for people the answer alone, with the sections of a pull that has pits, for programs all);
 * the width of a line for people, 0: 118. */
typedef struct hawser_theory_options {
    const char *tables;
    int width;
} hawser_theory_options;
/* hawser_case_theory, and the word of the verdict of a pull forward (of several chains the first that is not SAFE).
 * Errors: as above, and INPUT for a table that there is not, with the names of those that there are. */
hawser_status hawser_case_theory_shown(struct hawser_case *c, hawser_format format,
                                       const hawser_theory_options *options, char **text, hawser_word *word,
                                       hawser_error *err);

#ifdef __cplusplus
}
#endif

#endif
