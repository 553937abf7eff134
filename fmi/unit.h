/* An instance of an FMU: a simulation of the case in the archive, with its values by reference and the allowed order of
 * calls. Both versions of the interface are views of it (fmi2.c, fmi3.c). */
#ifndef HAWSER_FMI_UNIT_UNIT_H
#define HAWSER_FMI_UNIT_UNIT_H

#include "fmi/model.h"

/* Outcome of a call; the numbers are those of fmi2Status and fmi3Status. */
typedef enum Outcome { GOES_WELL, GOES_WITH_A_WORD, REFUSED, FAILED, BROKEN } Outcome;

/* Phase of an instance. After a failure it can be reset, given another state or freed. */
typedef enum Phase {
    PHASE_INSTANTIATED = 1,
    PHASE_INITIALIZING = 2,
    PHASE_STEPPING = 4,
    PHASE_OVER = 8,
    PHASE_FAILED = 16
} Phase;

/* Phases in which a call is allowed. */
enum {
    PHASES_EARLY = PHASE_INSTANTIATED | PHASE_INITIALIZING,
    PHASES_LATE = PHASE_STEPPING | PHASE_OVER,
    PHASES_ALL = PHASES_EARLY | PHASES_LATE | PHASE_FAILED
};

/* Receives messages of an instance; `category` is one of those in the description. */
typedef void (*Say)(void *host, Outcome outcome, const char *category, const char *text);

/* Data of the outputs, updated on request. */
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
    double *value; /* [variables] owned; values of parameters and inputs; the two others lie behind it */
    double *told;  /* [variables] for inputs: the last command's value */
    double *built; /* [variables] for parameters: the value that the simulation was built with */
    hawser_sim *sim;
    int relaxed;
    double start, stop; /* s, in the importer's time; stop: INFINITY if none was given */
    double ends;        /* s from start, end of the case unless the winch ends it before */
    long rows;          /* samples of the statistics so far */
    Look look;
    int logging; /* also messages that are no warnings */
    Say say;
    void *host;
} Unit;

/* Returns NULL with a message to `say` if the resources cannot be read or are not those of the token. */
Unit *unit_new(const char *folder, const char *token, int logging, Say say, void *host);
Unit *unit_free(Unit *u);
/* Reports a message in the category of the outcome; returns the outcome. */
Outcome unit_say(Unit *u, Outcome outcome, const char *format, ...) __attribute__((format(printf, 3, 4)));
/* An importer's instance begins with its unit, in either version. */
typedef struct Instance {
    Unit *unit;
} Instance;

/* Returns the unit of an importer's instance that is in one of the phases; NULL otherwise, after a failure that names
 * the call, and for no instance. */
Unit *unit_in(const void *instance, unsigned phases, const char *call);
/* Fails with a message that names a call which no unit supports; nothing is reported without an instance. */
Outcome unit_denied(const void *instance, const char *call);
/* Returns the worse of two. */
Outcome outcome_worse(Outcome a, Outcome b);
Outcome unit_set_times(Unit *u, double start, int has_stop, double stop);
Outcome unit_begin(Unit *u);  /* enters initialization */
Outcome unit_settle(Unit *u); /* leaves it: at equilibrium, at the start */
Outcome unit_end(Unit *u);
Outcome unit_reset(Unit *u);
/* Returns the time, s, in the importer's time. */
double unit_time(const Unit *u);
/* Advances from `now`, which must be its time, by `step`. *over: the winch has ended the run before. */
Outcome unit_step(Unit *u, double now, double step, int *over);
/* Returns one value by its reference, which must be of the type. Texts live until the next call. */
Outcome unit_get(Unit *u, size_t reference, VariableType type, double *value, const char **text);
Outcome unit_set(Unit *u, size_t reference, VariableType type, double value);
/* States, of which an importer has the address alone: bytes, malloc'ed, complete in themselves. A call overwrites the
 * one given in *state. Without an instance, or in a phase that the standard does not allow: FAILED. */
Outcome state_get(const void *instance, void **state, const char *call);
Outcome state_set(const void *instance, const void *state, const char *call);
Outcome state_free(const void *instance, void **state);
Outcome state_size(const void *instance, const void *state, size_t *size);
Outcome state_bytes(const void *instance, const void *state, void *to, size_t size);
/* Makes a state from the bytes of another, perhaps from another process. */
Outcome state_of_bytes(const void *instance, const void *from, size_t size, void **state, const char *call);
/* Returns the folder of an address of the resources, "file:///home/me/a%20pull/resources" or "file:/home/...",
 * malloc'ed; a plain path is used as it is, without slashes at its end. NULL: another scheme or host, a malformed
 * escape, nothing, no memory. */
char *address_folder(const char *address);

#endif
