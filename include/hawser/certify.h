/* Certificates: whether the figures of a run hold when it is computed again with finer settings; part of
 * hawser/hawser.h, which includes it. What is refined and what the numbers mean is in docs/reference/limits.md,
 * "Certify". */
#ifndef HAWSER_CERTIFY_H
#define HAWSER_CERTIFY_H

#include "hawser/limits.h"
#include "hawser/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What is refined, each on its own: all that goes with time, which is the integrator's accuracy, the time between
 * samples and the speed below which friction fades (of statics the load steps); the segments. */
typedef enum hawser_source { HAWSER_TIME, HAWSER_LENGTH } hawser_source;
enum { HAWSER_SOURCES = 2 };

/* A figure of a run, and what refinement says of it. */
typedef struct hawser_certified {
    char name[96];    /* "pull, mean" */
    const char *unit; /* "N", "N/m", "m", "rad", "N m", "Hz"; lives for ever */
    double value;     /* of the run itself */
    double best;      /* of the finest settings whose error was estimated; the run's if those are its own */
    double refined[HAWSER_SOURCES]; /* with one source refined once more; NAN: it was not, or that run failed */
    double error[HAWSER_SOURCES];   /* of `best`, estimated by source; NAN: not known */
    double order[HAWSER_SOURCES];   /* observed; NAN: fewer than three values, or no order to be seen */
    int diverges[HAWSER_SOURCES];   /* refining did not bring three values nearer to each other */
    double bar;                     /* of `best`: sum of the errors */
    double run_bar;                 /* of `value`: that and its distance from `best` */
    double allowed;                 /* tolerance times the figure's size, or times `floor` where that is larger */
    double floor;                   /* below this size a figure's error counts as that of one this large */
    int holds;                      /* bar <= allowed */
    int run_holds;                  /* run_bar <= allowed */
} hawser_certified;

/* One run of the case. */
typedef struct hawser_certify_run {
    int level[HAWSER_SOURCES];   /* how often each source is refined; 0, 0: the case as it is */
    double accuracy, interval_s; /* solver.accuracy (a share), output.interval */
    int segments;                /* of the whole chain */
    double friction;             /* v_s over the case's */
    hawser_status status;        /* how it ended */
    char message[256];           /* "" or why it failed */
    long steps;
    double work; /* evaluations of the rates times segments, over those of the case as it is */
} hawser_certify_run;

typedef struct hawser_certificate {
    double tolerance;                 /* share */
    int certified;                    /* the run's own figures hold */
    char verdict[HAWSER_VERDICT_MAX]; /* "CERTIFIED: ..." or "NOT CERTIFIED: ..." */
    double work;                      /* of the finer runs, over that of the case as it is */
    int n_figures, n_runs;
    hawser_certified *figure; /* [n_figures] */
    hawser_certify_run *run;  /* [n_runs], in the order in which they were made */
    int base[HAWSER_SOURCES]; /* the settings of `best` */
    char run_id[20];          /* identity of the run that is judged, as in its summary.json; "": none */
} hawser_certificate;

/* What is going on; good during the call of the progress function only. */
typedef struct hawser_certify_state {
    int round, runs, over; /* from 1; runs of this round, and how many of them have ended */
    const char *what;      /* what is being computed, in words */
    double done;           /* share of the round's work */
    double left_s;         /* s until the end of the round; NAN: not known yet */
} hawser_certify_state;
/* Other than 0: stop. Called a few times a second in the caller's thread. */
typedef int (*hawser_certify_progress)(void *user, const hawser_certify_state *state);

typedef struct hawser_certify_options {
    double tolerance; /* share, above 0 and below 1; 0: 0.01 */
    int rounds;       /* at most so many; 0: 4 */
    double effort; /* a number of runs of the case, which the finer runs take no more than: no round begins, and no run
                    * goes on, that would; 0: 6 */
    int threads;   /* runs side by side, 1 or 2; 0: 2 where there are two processors */
    hawser_certify_progress progress; /* may be NULL */
    void *user;
} hawser_certify_options;

/* Computes the case again with finer settings until its figures hold to the tolerance, or until there is no more to be
 * tried; nothing is written. `run` is a simulation of the same case that has been run to its end: its figures are those
 * that are judged. options may be NULL. A run that fails is no error, it is in the certificate. Errors: INPUT, MEMORY,
 * STOPPED. */
hawser_status hawser_certify(hawser_case *c, hawser_sim *run, const hawser_certify_options *options,
                             hawser_certificate **out, hawser_error *err);
void hawser_certificate_free(hawser_certificate *certificate);
/* All of it as HAWSER_JSON, its figures as HAWSER_CSV, or what a reader wants to see of it as HAWSER_TABLE; *text is
 * malloc'ed: hawser_text_free. Errors: MEMORY. */
hawser_status hawser_certificate_text(const hawser_certificate *certificate, hawser_format format, char **text,
                                      hawser_error *err);
/* The same JSON as the file certificate.json of a folder, which is made if need be. Errors: OUTPUT (also: the folder
 * has another run's summary), MEMORY. */
hawser_status hawser_certificate_write(const hawser_certificate *certificate, const char *dir, hawser_error *err);

#ifdef __cplusplus
}
#endif

#endif
