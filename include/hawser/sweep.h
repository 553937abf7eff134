/* Studies on clusters and their pages, and derivatives of theory and runs: a part of hawser/hawser.h.
 * docs/guide/studies-and-measured-pulls.md, "On a cluster"; docs/theory/92-sensitivities.md. */
#ifndef HAWSER_SWEEP_H
#define HAWSER_SWEEP_H

#include <stddef.h>
#include <stdint.h>

#include "hawser/shown.h"
#include "hawser/status.h"
#include "hawser/study.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------------------------------------------- clusters */

/* Communication of the processes that compute a study together, on any number of machines
 * (docs/guide/studies-and-measured-pulls.md). Each calls hawser_study_run_on with its own; they share the folder. */
enum { HAWSER_RANK_WORDS = 6 };
/* Sends rank 0's data to all; all call it. */
typedef void (*hawser_ranks_share)(void *user, void *data, size_t size);
/* Sends HAWSER_RANK_WORDS words without waiting; messages to one rank arrive in order. */
typedef void (*hawser_ranks_send)(void *user, int to, const int64_t *message);
/* Returns 0 if no message has arrived yet. */
typedef int (*hawser_ranks_receive)(void *user, int *from, int64_t *message);
typedef void (*hawser_ranks_end)(void *user);
typedef struct hawser_ranks {
    int rank, count; /* number of this rank, 0 .. count-1 */
    void *user;
    hawser_ranks_share share;
    hawser_ranks_send send;
    hawser_ranks_receive receive;
    hawser_ranks_end end; /* all call it at the end; NULL: nothing to do */
} hawser_ranks;

/* Opens the ranks that mpirun has started, through a module that was built with its MPI: the program itself needs none.
 * Once in a process; close it at its end. Errors: INPUT (hawser was built without MPI, or it cannot be loaded). */
hawser_status hawser_ranks_open(hawser_ranks *ranks, hawser_error *err);
void hawser_ranks_close(hawser_ranks *ranks);

/* Other machines on which a study is computed. */
typedef struct hawser_study_cluster {
    const hawser_ranks *ranks; /* NULL: no ranks; otherwise options->jobs counts per rank, 0: one */
    const char *slurm; /* the program that a Slurm array starts as `hawser`; NULL: no array. options->jobs counts per
                        * task, 0: one */
    int tasks;         /* number of the array's tasks; 0: by the number of samples */
} hawser_study_cluster;

/* Runs hawser_study_run on a cluster; cluster NULL: on this machine. Errors: also INPUT (no Slurm, or it rejects the
 * array). */
hawser_status hawser_study_run_on(hawser_study *s, const char *dir, const hawser_study_options *options,
                                  const hawser_study_cluster *cluster, hawser_error *err);
/* Computes one task of the array that hawser_study_run_on has submitted: its samples, without tables. Errors: as there.
 */
hawser_status hawser_study_task(hawser_study *s, const char *dir, int task, const hawser_study_options *options,
                                hawser_error *err);
/* Writes the page of the study whose samples are in a folder, with the samples so far, also while others are computed.
 * Errors: INPUT (the folder has none, or the study or its case has changed since), OUTPUT, MEMORY. */
hawser_status hawser_study_report(const char *dir, const char *page, hawser_error *err);
/* ----------------------------------------------------------------------------------------------------- derivatives */

/* Returns exact derivatives of the winch force of hawser_case_theory, of tensions and of support forces by friction,
 * weight, tension at the start and pushes. *text as above. Errors: as hawser_case_theory. */
hawser_status hawser_case_sensitivities(hawser_case *c, hawser_format format, char **text, hawser_error *err);
/* Returns the same for a run, which this function computes: means over the steady window and their derivatives by each
 * of n dotted keys of the case, from the linearised equations of motion. `stop` may be NULL; a result other than 0 ends
 * it. *text as above; *json (NULL: none) the same for programs. Errors: INPUT (a key without a number; a scene with
 * parts that have no derivatives here), RUN, STOPPED, MEMORY. */
hawser_status hawser_case_run_sensitivities(hawser_case *c, size_t n, const char *const *keys, hawser_format format,
                                            int (*stop)(void *user), void *user, char **text, char **json,
                                            hawser_error *err);
/* Returns the same for one position, the one in which the run ends, by each of n dotted keys of the case, or with n = 0
 * by every number in it that can be varied a little: one solution for each figure, however many keys there are
 * (docs/theory/92-sensitivities.md, "Changes of a position"). All else as above. Errors: as above. */
hawser_status hawser_case_position_sensitivities(hawser_case *c, size_t n, const char *const *keys,
                                                 hawser_format format, int (*stop)(void *user), void *user, char **text,
                                                 char **json, hawser_error *err);

/* Writes the JSON of either as sensitivities.json into a folder. Errors: OUTPUT (also: the folder has another run's
 * summary), MEMORY. */
hawser_status hawser_sensitivities_write(const char *json, const char *dir, hawser_error *err);

#ifdef __cplusplus
}
#endif

#endif
