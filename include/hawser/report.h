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

/* Writes one HTML page about the results in n folders (1 to HAWSER_REPORT_RUNS_MAX) that hawser_sim_run has written; it
 * needs no other file and no network. A file at `path` is replaced only by a complete page. Errors: INPUT (a folder
 * that does not exist or holds no results), OUTPUT, MEMORY. */
hawser_status hawser_report_write(const char *const *folders, size_t n, const char *path, hawser_error *err);

/* Draws main figures of the results in a folder as SVG files NAME.svg in the folder `dir`, which is made if it does not
 * exist. names [n]: "tension", "series", "rollers", "plan"; n 0: all for which there are results. Errors: INPUT (no
 * results; an unknown figure, or one without results), OUTPUT, MEMORY. *drawn (may be NULL): how many. */
hawser_status hawser_plot_write(const char *folder, const char *dir, size_t n, const char *const *names,
                                hawser_units units, int *drawn, hawser_error *err);

/* Checks that the files in a results folder are those that one run has written, by their list in summary.json. Errors:
 * INPUT (no results; which file is not the run's), MEMORY. */
hawser_status hawser_results_check(const char *folder, hawser_error *err);

/* Checks that a file may be written without harm to the case. Runs and everything else that the library writes check
 * this themselves. Errors: INPUT (`path` leads to a file that the case is read from: itself, what it includes, its
 * route, its drawing), MEMORY. */
hawser_status hawser_case_spares(hawser_case *c, const char *path, hawser_error *err);

/* Writes the calculation of one chain as a page (HTML) that can be handed on and printed: answer, plan, profile,
 * tension and T/R along the route, ducts, tables, one straight and one bend worked out; head and foot come from the
 * case's section `job`. word: as above, or NULL. Errors: as hawser_case_theory, OUTPUT. */
hawser_status hawser_case_calculation(struct hawser_case *c, hawser_units units, const char *path, hawser_word *word,
                                      hawser_error *err);
/* Writes the crew's sheet in the same way, for the pull forward, on one side: the winch's force by the place of the
 * cable's front, its set trip force, speeds, rope, where somebody must stand, the rollers with the largest loads.
 * Errors: as above. */
hawser_status hawser_case_crew_sheet(struct hawser_case *c, hawser_units units, const char *path, hawser_word *word,
                                     hawser_error *err);

/* Kinds of help that may be proposed. */
typedef enum hawser_place_kind { HAWSER_PLACE_ANY, HAWSER_PLACE_MACHINES, HAWSER_PLACE_PITS } hawser_place_kind;
/* May grow at its end; a member that is 0 has its default. */
typedef struct hawser_place_options {
    hawser_place_kind only;
    const char *lubricant; /* jacket and duct of the catalogue's friction, "pe-jacket/pe-duct": also calculates all
                            * ducts dry and lubricated */
    const char *to; /* file to which the case is written with the proposal, its text and comments kept; it may be the
                     * case's own */
} hawser_place_options;
/* Finds the fewest machines (with the push of the key theory.machine_push) and the fewest pits with which all limits
 * hold, their places, and the theory of the case with them; also the quantity of lubricant. *text as above. word (may
 * be NULL): of the proposal, NOT_SAFE without one. Errors: as hawser_case_theory; INPUT (no limits, no entry of that
 * name; with `to`: no proposal, or a case that is no file); OUTPUT. */
hawser_status hawser_case_place(struct hawser_case *c, const hawser_place_options *options, hawser_format format,
                                char **text, hawser_word *word, hawser_error *err);

/* How a model is converted; zeroed: the file's own unit and axis, the usual limits. */
typedef struct hawser_convert_options {
    const char *unit; /* m, cm, mm, in or ft, where the file does not say; NULL: not given */
    const char *up;   /* the file's axis that points up, y or z, where the file does not say; NULL: not given */
    double memory;    /* resident memory of the converter, bytes; 0: 4096e6 */
    double seconds;   /* its time; 0: 300 */
} hawser_convert_options;
/* Converts a model (IFC, OBJ, PLY, COLLADA, FBX, 3DS, 3MF or a cloud of points as XYZ) to GLB, by node in a child
 * process. *text: what was taken and what left out, a line each; the caller frees it. Errors: INPUT (the model cannot
 * be read, is larger than the limits or lacks a unit or axis; no node), OUTPUT, MEMORY. */
hawser_status hawser_model_convert(const char *model, const char *path, const hawser_convert_options *options,
                                   char **text, hawser_error *err);

/* Writes the desk (docs/guide/first-pull.md) to `path`, one HTML file for any browser that contains the text of a case
 * file and the files that it names; NULL: an example. Errors: INPUT (the case is no YAML; a file that it names cannot
 * be read; `path` leads to one of them; the desk is not beside the program), OUTPUT, MEMORY. */
hawser_status hawser_desk_write(const char *case_path, const char *path, hawser_error *err);

#ifdef __cplusplus
}
#endif

#endif
