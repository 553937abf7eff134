/* Studies on clusters and their pages, and derivatives of theory and runs: a part of hawser/hawser.h.
 * docs/guide/studies-and-measured-pulls.md, "On a cluster"; docs/model/92-sensitivities.md. */
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

/* Processes that compute a study together, on as many machines as there are (docs/guide/studies-and-measured-pulls.md):
 * how they talk. Each calls hawser_study_run_on with its own; they have the folder in common. */
enum { HAWSER_RANK_WORDS = 6 };
/* Rank 0's data to all; all call it. */
typedef void (*hawser_ranks_share)(void *user, void *data, size_t size);
/* HAWSER_RANK_WORDS words; what is sent to one rank arrives in order; does not wait. */
typedef void (*hawser_ranks_send)(void *user, int to, const int64_t *message);
/* 0: there is none yet. */
typedef int (*hawser_ranks_receive)(void *user, int *from, int64_t *message);
typedef void (*hawser_ranks_end)(void *user);
typedef struct hawser_ranks {
    int rank, count; /* this one, 0 .. count-1 */
    void *user;
    hawser_ranks_share share;
    hawser_ranks_send send;
    hawser_ranks_receive receive;
    hawser_ranks_end end; /* all call it; NULL: nothing to do */
} hawser_ranks;

/* The ranks that mpirun has started, by what was built with its MPI: the program itself needs none. Once in a process;
 * close it at its end. Errors: INPUT (hawser was built without MPI, or it cannot be loaded). */
hawser_status hawser_ranks_open(hawser_ranks *ranks, hawser_error *err);
void hawser_ranks_close(hawser_ranks *ranks);

/* Where else than on this machine a study is computed. */
typedef struct hawser_study_cluster {
    const hawser_ranks *ranks; /* NULL: no ranks; else options->jobs is of each, 0: one */
    const char *slurm;         /* the program that a Slurm array starts as `hawser`; NULL: no array. options->jobs is of
                                  each task, 0: one */
    int tasks;                 /* of the array; 0: by the number of samples */
} hawser_study_cluster;

/* hawser_study_run on a cluster; cluster NULL: on this machine. Errors: also INPUT (no Slurm, or it does not take the
 * array).
 */
hawser_status hawser_study_run_on(hawser_study *s, const char *dir, const hawser_study_options *options,
                                  const hawser_study_cluster *cluster, hawser_error *err);
/* One task of the array that hawser_study_run_on has submitted: computes its samples and makes no tables. Errors: as
 * there. */
hawser_status hawser_study_task(hawser_study *s, const char *dir, int task, const hawser_study_options *options,
                                hawser_error *err);
/* The page of the study whose samples are in a folder, as far as they go, also while others compute. Errors: INPUT (the
 * folder has none, or the study or its case has changed since), OUTPUT, MEMORY. */
hawser_status hawser_study_report(const char *dir, const char *page, hawser_error *err);
/* ----------------------------------------------------------------------------------------------------- derivatives */

/* What the winch force of hawser_case_theory, tensions and support forces change by with friction, weight, tension at
 * the start and pushes: exact derivatives. *text as above. Errors: as hawser_case_theory. */
hawser_status hawser_case_sensitivities(hawser_case *c, hawser_format format, char **text, hawser_error *err);
/* The same of a run, which this computes: means over the steady window and their derivatives by each of n dotted keys
 * of the case, by the linearised equations of motion. `stop` may be NULL; other than 0 ends it. *text as above; *json
 * (NULL: none) the same for programs. Errors: INPUT (a key that has no number; a scene with what this does not know),
 * RUN, STOPPED, MEMORY. */
hawser_status hawser_case_run_sensitivities(hawser_case *c, size_t n, const char *const *keys, hawser_format format,
                                            int (*stop)(void *user), void *user, char **text, char **json,
                                            hawser_error *err);
/* The figures of one position, that which the run ends at, by each of n dotted keys of the case, or with n = 0 by every
 * number in it that can be a little less or more: one solution for each figure, however many keys there are
 * (docs/model/92-sensitivities.md, "Changes of a position"). All else as above. Errors: as above. */
hawser_status hawser_case_position_sensitivities(hawser_case *c, size_t n, const char *const *keys,
                                                 hawser_format format, int (*stop)(void *user), void *user, char **text,
                                                 char **json, hawser_error *err);

/* The JSON of either as sensitivities.json of a folder. Errors: OUTPUT (also: the folder has another run's summary),
 * MEMORY. */
hawser_status hawser_sensitivities_write(const char *json, const char *dir, hawser_error *err);

#ifdef __cplusplus
}
#endif

#endif
