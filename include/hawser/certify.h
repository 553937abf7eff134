/* Certificates: show whether the figures of a run hold when it is computed again with finer settings; part of
 * hawser/hawser.h, which includes it. docs/guide/simulate.md, "Certify", explains what is refined and what the
 * numbers mean. */
#ifndef HAWSER_CERTIFY_H
#define HAWSER_CERTIFY_H

#include "hawser/limits.h"
#include "hawser/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The two sources of error, each refined on its own. Time: the integrator's accuracy, the time between samples and the
 * speed below which friction fades (in statics the load steps). Length: the segments. */
typedef enum hawser_source { HAWSER_TIME, HAWSER_LENGTH } hawser_source;
enum { HAWSER_SOURCES = 2 };

/* A figure of a run, and what refinement shows about it. */
typedef struct hawser_certified {
    char name[96];    /* "pull, mean" */
    const char *unit; /* "N", "N/m", "m", "rad", "N m", "Hz"; lives for ever */
    double value;     /* found by the run itself */
    double best;      /* found with the finest settings whose error was estimated; the run's value if those are its own
                       * settings */
    double refined[HAWSER_SOURCES]; /* with one source refined once more; NAN: it was not, or that run failed */
    double error[HAWSER_SOURCES];   /* error of `best`, estimated by source; NAN: not known */
    double order[HAWSER_SOURCES];   /* observed; NAN: fewer than three values, or no visible order */
    int diverges[HAWSER_SOURCES];   /* refining did not bring three values nearer to each other */
    double bar;                     /* error of `best`: sum of the errors */
    double run_bar;                 /* error of `value`: `bar` plus its distance from `best` */
    double allowed;                 /* tolerance times the size of the figure, or times `floor` where that is larger */
    double floor;                   /* a figure smaller than this is judged as if it had this size */
    int holds;                      /* bar <= allowed */
    int run_holds;                  /* run_bar <= allowed */
} hawser_certified;

/* One run of the case. */
typedef struct hawser_certify_run {
    int level[HAWSER_SOURCES];   /* how often each source is refined; 0, 0: the case as it is */
    double accuracy, interval_s; /* solver.accuracy (a share), output.interval */
    int segments;                /* number in the whole chain */
    double friction;             /* v_s over the case's */
    hawser_status status;        /* outcome of the run */
    char message[256];           /* "", or the reason why it failed */
    long steps;
    double work; /* evaluations of the rates times segments, over those of the case as it is */
} hawser_certify_run;

typedef struct hawser_certificate {
    double tolerance;                 /* share */
    int certified;                    /* the figures of the run itself hold */
    char verdict[HAWSER_VERDICT_MAX]; /* "CERTIFIED: ..." or "NOT CERTIFIED: ..." */
    double work;                      /* work of the finer runs, over that of the case as it is */
    int n_figures, n_runs;
    hawser_certified *figure; /* [n_figures] */
    hawser_certify_run *run;  /* [n_runs], in the order in which they were computed */
    int base[HAWSER_SOURCES]; /* level of each source in the settings of `best` */
    char run_id[20];          /* identity of the judged run, as in its summary.json; "": none */
} hawser_certificate;

/* Progress of a certification; valid only during the call of the progress function. */
typedef struct hawser_certify_state {
    int round, runs, over; /* counted from 1; runs of this round; how many of them have ended */
    const char *what;      /* what is being computed, as text */
    double done;           /* share of the round's work that is done */
    double left_s;         /* s until the end of the round; NAN: not known yet */
} hawser_certify_state;
/* Returns 0 to go on, anything else to stop. Called a few times a second in the caller's thread. */
typedef int (*hawser_certify_progress)(void *user, const hawser_certify_state *state);

typedef struct hawser_certify_options {
    double tolerance; /* share, above 0 and below 1; 0: 0.01 */
    int rounds;       /* at most this many; 0: 4 */
    double effort; /* most work of the finer runs, as a number of runs of the case: no round begins and no run continues
                    * beyond it; 0: 6 */
    int threads;   /* runs at the same time, 1 or 2; 0: 2 where there are two processors */
    hawser_certify_progress progress; /* may be NULL */
    void *user;
} hawser_certify_options;

/* Computes the case again with finer settings until its figures hold to the tolerance, or until nothing is left to try;
 * writes nothing. `run` is a simulation of the same case that has been run to its end: its figures are judged. options
 * may be NULL. A failed run is no error; the certificate records it. Errors: INPUT, MEMORY, STOPPED. */
hawser_status hawser_certify(hawser_case *c, hawser_sim *run, const hawser_certify_options *options,
                             hawser_certificate **out, hawser_error *err);
void hawser_certificate_free(hawser_certificate *certificate);
/* Returns the whole certificate as HAWSER_JSON, its figures as HAWSER_CSV, or a summary for readers as HAWSER_TABLE;
 * *text is malloc'ed: free it with hawser_text_free. Errors: MEMORY. */
hawser_status hawser_certificate_text(const hawser_certificate *certificate, hawser_format format, char **text,
                                      hawser_error *err);
/* Writes the same JSON as certificate.json into a folder, which is made if it does not exist. Errors: OUTPUT (also: the
 * folder has another run's summary), MEMORY. */
hawser_status hawser_certificate_write(const hawser_certificate *certificate, const char *dir, hawser_error *err);

#ifdef __cplusplus
}
#endif

#endif
