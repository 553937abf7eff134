/* A results folder, written while the run goes on: series.csv, results.h5 and results.xdmf grow;
 * stations.csv, rollers.csv and summary.json are filled at the end (until then summary.json says "running").
 * Memory stays constant. docs/results.md describes every file. */
#ifndef HAWSER_IO_RESULTS_RESULTS_H
#define HAWSER_IO_RESULTS_RESULTS_H

#include "hawser/hawser.h"
#include "sim/watch/overload.h"

/* What a folder is made for: sizes, names and what is wanted in it. Strings and arrays are borrowed until the folder is
 * open. */
typedef struct ResultsDef {
    const char *title; /* the case's */
    int segments;
    int rollers;
    const hawser_roller *roller; /* [rollers]: names and places */
    int conveyors;
    const hawser_conveyor *conveyor; /* [conveyors]: names */
    int n_watched;
    const int *watched; /* [n_watched]: segments whose speed and tension are columns of series.csv */
    int probes;
    const hawser_probe *probe; /* [probes]: names */
    double states;             /* expected number of states; 0: no results.h5 and no results.xdmf */
    int reel;                  /* the reel pays out: series.csv has its columns */
    int front;                 /* the cable's front moves along the route: likewise */
    int n_loads;
    const int *loads; /* [n_loads]: rollers whose loads are columns of series.csv */
} ResultsDef;

typedef struct Results Results;

/* What is known at the end; borrowed. */
typedef struct ResultsTables {
    int n_stations;
    const hawser_station *station; /* [n_stations] */
    int n_rollers;
    const hawser_roller *roller; /* [n_rollers] */
    int n_modes, segments;
    const hawser_mode *mode; /* [n_modes], of `segments` segments; none: no modes.csv */
    const char *summary;     /* the text of summary.json */
} ResultsTables;

/* Makes the folder and opens all its files, so that what cannot be written shows before anything is computed.
 * `summary`: summary.json until the end. Errors: OUTPUT, MEMORY. */
hawser_status results_open(Results **out, const char *dir, const ResultsDef *def, const char *summary,
                           hawser_error *err);
/* A row of series.csv. Errors: OUTPUT. */
hawser_status results_row(Results *r, const hawser_sample *sample, hawser_error *err);
/* A state of results.h5; nothing if no states are wanted. Errors: OUTPUT. */
hawser_status results_state(Results *r, const hawser_sample *sample, hawser_error *err);
/* Brings the files up to date for their readers if the last time was a while ago (half a second). Errors:
 * OUTPUT. */
hawser_status results_tick(Results *r, hawser_error *err);
/* Writes the tables and closes everything; what can still be written is, and the first error is returned.
 * Only results_free may follow. Errors: OUTPUT. */
hawser_status results_finish(Results *r, const ResultsTables *tables, hawser_error *err);
Results *results_free(Results *r);

/* What the summary says beside the figures. */
typedef struct SummaryLabels {
    const char *title, *case_name;
    const char *outcome; /* "running", "finished", "tripped", "stopped", "failed" */
    const char *message; /* why it did not finish; "" otherwise */
    int n_surfaces;
    const hawser_surface *surface; /* [n_surfaces] */
    int n_rollers;
    const hawser_roller *roller; /* [n_rollers] */
    int n_limits;
    const hawser_limit *limit; /* [n_limits] */
    int n_overloads;
    const Overload *overload; /* [n_overloads], by roller */
    double trip_N;            /* that follows from the largest overload factor allowed; NAN without limits */
} SummaryLabels;

/* The text of summary.json, malloc'ed; what is not known (NAN) becomes null. Errors: MEMORY. */
hawser_status summary_json(const hawser_summary *summary, const SummaryLabels *labels, char **text, hawser_error *err);

#endif
