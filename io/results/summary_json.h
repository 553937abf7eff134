/* summary.json: the figures of a run for programs. docs/results.md lists the keys. */
#ifndef HAWSER_IO_RESULTS_SUMMARY_JSON_H
#define HAWSER_IO_RESULTS_SUMMARY_JSON_H

#include "hawser/hawser.h"
#include "sim/watch/overload.h"

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
