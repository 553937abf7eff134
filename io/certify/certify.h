/* What the files of a certificate share: the figures of a simulation, and runs side by side. docs/model.md,
 * "Certificates". */
#ifndef HAWSER_IO_API_CERTIFY_H
#define HAWSER_IO_API_CERTIFY_H

#include "io/api/api_handles.h"

/* A figure as one run has it. */
typedef struct Figure {
    char name[96];
    const char *unit;
    double value; /* NAN: not known */
    double floor; /* below this size its error counts as that of one this large (CE6) */
} Figure;

typedef struct Figures {
    int n, room;
    Figure *figure; /* [n], owned */
} Figures;

/* The figures of a run that is over; two runs of a case have the same ones in the same order. Errors: MEMORY. */
hawser_status figures_take(hawser_sim *s, Figures *out, hawser_error *err);
/* Rotations of another run go on beyond half a turn where those of this one do. */
void figures_follow(const Figures *own, Figures *other);
void figures_free(Figures *f);

/* One run with finer settings. */
typedef struct Companion {
    hawser_certify_run about; /* levels and what became of it */
    Figures figures;          /* empty if it failed */
    double evaluations;       /* of the rates, times segments */
    double share;             /* of its way, while it runs; 1: over */
    double seconds;           /* it has taken */
    double most;              /* of evaluations: where it needs more it is given up */
    int given_up;             /* it did */
} Companion;

/* What a round of runs needs to know. */
typedef struct CertifyRound {
    const SceneDef *def;
    int threads;
    int runs, over;             /* of the whole round; those of it that had ended before these began */
    hawser_certify_state state; /* round is set by the caller */
    hawser_certify_progress progress;
    void *user;
} CertifyRound;

/* Runs them all, side by side on so many threads; a run that fails says so in its `about`. Errors: STOPPED (the
 * caller's wish), MEMORY. */
hawser_status companions_run(CertifyRound *round, int n, Companion *const *companion, hawser_error *err);
/* The counts of a run into its description. */
void companion_describe(const hawser_sim *s, Companion *out);

#endif
