/* An instance of an FMU: a simulation of the case in the archive, with its values by reference and the order in which
 * it may be asked. Both versions of the interface are views of it (fmi2.c, fmi3.c). */
#ifndef HAWSER_FMI_UNIT_UNIT_H
#define HAWSER_FMI_UNIT_UNIT_H

#include "fmi/model.h"

/* How a call went; the numbers are those of fmi2Status and fmi3Status. */
typedef enum Outcome { GOES_WELL, GOES_WITH_A_WORD, REFUSED, FAILED, BROKEN } Outcome;

/* Where an instance is in its life. After a failure it can be reset, given another state or freed. */
typedef enum Phase {
    PHASE_INSTANTIATED = 1,
    PHASE_INITIALIZING = 2,
    PHASE_STEPPING = 4,
    PHASE_OVER = 8,
    PHASE_FAILED = 16
} Phase;

/* Those in which a call makes sense. */
enum {
    PHASES_EARLY = PHASE_INSTANTIATED | PHASE_INITIALIZING,
    PHASES_LATE = PHASE_STEPPING | PHASE_OVER,
    PHASES_ALL = PHASES_EARLY | PHASES_LATE | PHASE_FAILED
};

/* What an instance has to say; `category` is one of those in the description. */
typedef void (*Say)(void *host, Outcome outcome, const char *category, const char *text);

/* What outputs are made of, brought up to date when somebody asks. */
typedef struct Look {
    int fresh, judged; /* sample; limits and verdict */
    const hawser_sample *sample;
    hawser_limit limit[HAWSER_LIMITS_MAX];
    int limits, broken;
    double mean, peak; /* N */
    char verdict[HAWSER_VERDICT_MAX];
} Look;

typedef struct Unit {
    Model model;
    Phase phase;
    double *value; /* [variables] owned; of parameters and inputs; the two others lie behind it */
    double *told;  /* [variables] of inputs: what the simulation was told last */
    double *built; /* [variables] of parameters: what the simulation was built with */
    hawser_sim *sim;
    int relaxed;
    double start, stop; /* s, of the importer's time; stop: INFINITY if none was named */
    double ends;        /* s from start, when the case ends unless the winch ends it before */
    long rows;          /* samples of the statistics so far */
    Look look;
    int logging; /* also what is no warning */
    Say say;
    void *host;
} Unit;

/* NULL with a word to `say` if the resources cannot be read or are not those of the token. */
Unit *unit_new(const char *folder, const char *token, int logging, Say say, void *host);
Unit *unit_free(Unit *u);
/* Says something in the category that goes with the outcome; returns the outcome. */
Outcome unit_say(Unit *u, Outcome outcome, const char *format, ...) __attribute__((format(printf, 3, 4)));
/* What an importer holds begins with its unit, in either version. */
typedef struct Instance {
    Unit *unit;
} Instance;

/* The unit of an importer's instance that is in one of the phases; NULL otherwise, after a failure that names the call,
 * and for no instance. */
Unit *unit_in(const void *instance, unsigned phases, const char *call);
/* Fails with a message that names a call which no unit provides; nothing is said without an instance. */
Outcome unit_denied(const void *instance, const char *call);
/* The worse of two. */
Outcome outcome_worse(Outcome a, Outcome b);
Outcome unit_set_times(Unit *u, double start, int has_stop, double stop);
Outcome unit_begin(Unit *u);  /* enters initialization */
Outcome unit_settle(Unit *u); /* leaves it: at equilibrium, at the start */
Outcome unit_end(Unit *u);
Outcome unit_reset(Unit *u);
/* s, of the importer's time. */
double unit_time(const Unit *u);
/* From `now`, which must be where it is, on by `step`. *over: the winch has ended the run before. */
Outcome unit_step(Unit *u, double now, double step, int *over);
/* One value by its reference, which must be of the type. Texts live until the next call. */
Outcome unit_get(Unit *u, size_t reference, VariableType type, double *value, const char **text);
Outcome unit_set(Unit *u, size_t reference, VariableType type, double value);
/* States, of which an importer knows the address alone: bytes, malloc'ed, which stand for themselves. One that a call
 * is given in *state is overwritten. Without an instance, or in another phase than the standard has: FAILED. */
Outcome state_get(const void *instance, void **state, const char *call);
Outcome state_set(const void *instance, const void *state, const char *call);
Outcome state_free(const void *instance, void **state);
Outcome state_size(const void *instance, const void *state, size_t *size);
Outcome state_bytes(const void *instance, const void *state, void *to, size_t size);
/* Of the bytes that another gave, perhaps of another process. */
Outcome state_of_bytes(const void *instance, const void *from, size_t size, void **state, const char *call);
/* The folder of an address of the resources, "file:///home/me/a%20pull/resources" or "file:/home/...", malloc'ed; a
 * path that is none is taken as it is, without slashes at its end. NULL: another scheme or host, a malformed escape,
 * nothing, no memory. */
char *address_folder(const char *address);

#endif
