/* Pages and figures of results: part of hawser/hawser.h, which includes it. docs/formats.md. */
#ifndef HAWSER_REPORT_H
#define HAWSER_REPORT_H

#include <stddef.h>

#include "hawser/limits.h"
#include "hawser/shown.h"
#include "hawser/status.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { HAWSER_REPORT_RUNS_MAX = 6 };

/* Writes one HTML page about the results in n folders (1 to HAWSER_REPORT_RUNS_MAX), which hawser_sim_run has written:
 * it needs no other file and no network. What stood at `path` is replaced only by a whole page. Errors: INPUT (a folder
 * that is none or holds no results), OUTPUT, MEMORY. */
hawser_status hawser_report_write(const char *const *folders, size_t n, const char *path, hawser_error *err);

/* Draws main figures of the results in a folder as SVG files NAME.svg in the folder `dir`, which is made if need be.
 * names [n]: "tension", "series", "rollers", "plan"; n 0: all of them for which the results hold something. Errors:
 * INPUT (no results; a figure that there is not, or for which they hold nothing), OUTPUT, MEMORY. *drawn (may be NULL):
 * how many. */
hawser_status hawser_plot_write(const char *folder, const char *dir, size_t n, const char *const *names,
                                hawser_units units, int *drawn, hawser_error *err);

/* Whether the files in a results folder are of one run and as it has written them; summary.json says what these are.
 * Errors: INPUT (no results; which file is not the run's), MEMORY. */
hawser_status hawser_results_check(const char *folder, hawser_error *err);

/* Whether a file may be written without harm to the case. Runs and whatever else the library writes look themselves.
 * Errors: INPUT (`path` leads to a file that the case is read from: itself, what it includes, its route, its drawing),
 * MEMORY. */
hawser_status hawser_case_spares(hawser_case *c, const char *path, hawser_error *err);

/* Writes the calculation of one chain as a page (HTML) that can be handed on and printed: answer, plan, profile,
 * tension and T/R along the route, ducts, tables, one straight and one bend worked out; head and foot from the case's
 * section `job`. word: as above, or NULL. Errors: as hawser_case_theory, OUTPUT. */
hawser_status hawser_case_calculation(struct hawser_case *c, hawser_units units, const char *path, hawser_word *word,
                                      hawser_error *err);
/* Writes the crew's sheet in the same way, for the pull forward: one side with the winch's force by the place of the
 * cable's front, where it is set to stop, speeds, rope, where somebody has to stand, rollers that bear most.
 * Errors: as above. */
hawser_status hawser_case_crew_sheet(struct hawser_case *c, hawser_units units, const char *path, hawser_word *word,
                                     hawser_error *err);

/* Which help is looked for. */
typedef enum hawser_place_kind { HAWSER_PLACE_ANY, HAWSER_PLACE_MACHINES, HAWSER_PLACE_PITS } hawser_place_kind;
/* May grow at its end; what is 0 is as if it were not there. */
typedef struct hawser_place_options {
    hawser_place_kind only;
    const char *lubricant; /* jacket and duct of the catalogue's friction, "pe-jacket/pe-duct": all ducts dry and
                            * lubricated as well */
    const char *to;        /* file that the case goes to with the proposal, its text and comments kept; it may be the
                            * case's own */
} hawser_place_options;
/* The fewest machines (of the push that the key theory.machine_push gives) and the fewest pits with which all limits
 * hold, where they stand, and what theory says of the case with them; quantity of lubricant. *text as above. word (may
 * be NULL): of the proposal, NOT_SAFE without one. Errors: as hawser_case_theory; INPUT (no limits, no entry of that
 * name; with `to`: no proposal, or a case that is no file); OUTPUT. */
hawser_status hawser_case_place(struct hawser_case *c, const hawser_place_options *options, hawser_format format,
                                char **text, hawser_word *word, hawser_error *err);

/* Writes the desk (docs/guide) to `path`, one HTML file for any browser, with the text of a case file in it; NULL:
 * with an example. Errors: INPUT (the case cannot be read as text; `path` leads to it; the desk is not beside the
 * program), OUTPUT, MEMORY. */
hawser_status hawser_desk_write(const char *case_path, const char *path, hawser_error *err);

#ifdef __cplusplus
}
#endif

#endif
