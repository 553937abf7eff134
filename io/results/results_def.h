/* Input of a results folder, and of its summary. */
#ifndef HAWSER_IO_RESULTS_RESULTS_DEF_H
#define HAWSER_IO_RESULTS_RESULTS_DEF_H

#include "core/file.h"
#include "hawser/hawser.h"
#include "sim/run/envelope.h"
#include "sim/run/geometry.h"
#include "sim/run/peaks.h"

/* A place of the route, with theory there. Values that are not known or do not exist are NAN. */
typedef struct AlongRow {
    double s, place[3], curvature; /* m, m, 1/m */
    double forward, backward,
        paper;                      /* N, tension with the whole route full of cable, pulled either way; by the paper */
    double run;                     /* N, by the reference theory, for the cable that the run is compared with */
    double sidewall, sidewall_back; /* N/m, T/R, full of cable, pulled forward and back */
} AlongRow;

/* Sizes, names and requested files. Strings and arrays are borrowed until the folder is open. */
typedef struct ResultsDef {
    const char *title; /* the case's */
    const char *run;   /* the run's identity; NULL: none */
    double origin[3];  /* m, origin of all coordinates; zero: none given */
    int segments;
    int rollers;
    const hawser_roller *roller;   /* [rollers]: names and places */
    int figures;                   /* number of figures of all machines */
    const hawser_machine *machine; /* names */
    int n_watched;
    const int *watched; /* [n_watched]: segments whose speed and tension are columns of series.csv */
    int probes;
    const hawser_probe *probe; /* [probes]: names */
    const Geometry *geometry;  /* equipment around the cable; NULL: not written */
    double states;             /* expected number of states; 0: no results.h5 and no results.xdmf */
    int reel;                  /* the reel pays out: series.csv has its columns */
    int front;                 /* the cable's front moves along the route: likewise */
    int n_loads;
    const int *loads; /* [n_loads]: rollers whose loads are columns of series.csv */
    int n_inputs;
    const char *inputs; /* n_inputs times INPUT_TEXTS texts, each with a NUL, as SceneDef has them */
    int n_route;
    const AlongRow *route; /* [n_route] rows of route.csv; 0: a scene without a route, no such file */
} ResultsDef;

enum { REMEDY_MAX = 256 };

/* A remedy for a broken limit. Its code selects the sentence (io/api/api_answer.c), which contains the values; NAN, "":
 * it has none. */
typedef struct Remedy {
    const char *code, *limit; /* limit: its name */
    const char *unit;         /* unit of the next three */
    double least, most, now;
    double share;          /* 1, share of the present value */
    char where[64];        /* a bend or duct by its name */
    char key[48];          /* key of the case */
    char also[48];         /* a key that may be changed instead */
    char text[REMEDY_MAX]; /* the sentence, in SI units */
} Remedy;

/* A file in a folder: its size in bytes (< 0: it does not exist) and a hash of the bytes, as 16 hexadecimal digits. */
enum { SUM_SIZE = 17, FILE_SUMS_MAX = 8 };
typedef struct FileSum {
    char file[16];
    long bytes;
    char sum[SUM_SIZE];
} FileSum;

/* A piece of the route on the calculation's page and in a run: tension at both ends with the route full of cable,
 * pulled forward and back. */
typedef struct PieceLine {
    const char *name, *turns;
    double from, to, radius, angle, slope, mu, mu_rest; /* m, m, m, degrees, degrees, 1, 1 */
    struct {
        double in, out, rest, sidewall;
    } way[2]; /* N, N, N, N/m */
} PieceLine;

/* Labels of the summary, beside the figures. */
typedef struct SummaryLabels {
    const char *title, *case_name;
    const char *run;     /* the run's identity */
    int n_files;         /* 0: the files are not complete yet, or there are none */
    const FileSum *file; /* [n_files] */
    const char *outcome; /* "running", "finished", "tripped", "stopped", "failed" */
    const char *message; /* reason why it did not finish; "" otherwise */
    int n_surfaces;
    const hawser_surface *surface; /* [n_surfaces] */
    int n_rollers;
    const hawser_roller *roller; /* [n_rollers] */
    int n_assumptions;
    const hawser_assumption *assumption; /* [n_assumptions] */
    int n_limits;
    const hawser_limit *limit; /* [n_limits] */
    int n_remedies;
    const Remedy *remedy; /* [n_remedies] */
    int n_assumed;
    const struct Assumed *assumed; /* [n_assumed] assumptions that limits depend on */
    int n_overloads;
    const Overload *overload; /* [n_overloads], by roller */
    double trip_N;            /* from the largest allowed overload factor; NAN without limits */
    int n_pieces;
    const PieceLine *piece; /* [n_pieces] */
} SummaryLabels;

/* Returns the text of summary.json, malloc'ed; values that are not known (NAN) become null. Errors: MEMORY. */
hawser_status summary_json(const hawser_summary *summary, const SummaryLabels *labels, char **text, hawser_error *err);

#endif
