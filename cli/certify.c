/* `hawser run --certify`: what the user sees while the case is computed again with finer settings, and its table. */
#include <math.h>
#include <stdio.h>

#include "cli/commands.h"

typedef struct Watch {
    Progress *progress;
    int (*stopped)(void);
} Watch;

static int show_certify(void *user, const hawser_certify_state *state)
{
    Watch *const watch = user;
    progress_certify(watch->progress, state);
    return watch->stopped();
}

int certify_run(const Arguments *args, hawser_case *c, hawser_sim *sim, const char *dir, int (*stopped)(void),
                hawser_error *err, hawser_status *status)
{
    Progress progress;
    Watch watch = {.progress = &progress, .stopped = stopped};
    const hawser_certify_options options = {.tolerance = args->tolerance,
                                            .effort = args->effort,
                                            .threads = args->threads,
                                            .progress = show_certify,
                                            .user = &watch};
    hawser_certificate *certificate = NULL;
    char *text = NULL;
    progress_start(&progress, args->quiet);
    *status = hawser_certify(c, sim, &options, &certificate, err);
    progress_end(&progress);
    if (!*status) *status = hawser_certificate_write(certificate, dir, err);
    if (!*status && !args->quiet) *status = hawser_certificate_text(certificate, args->format, &text, err);
    if (text) printf("\n%s\n%s\n", text, certificate->verdict);
    fflush(stdout);
    hawser_text_free(text);
    const int certified = certificate && certificate->certified;
    if (certificate && !certified && args->strict) complain("%s", certificate->verdict);
    hawser_certificate_free(certificate);
    return certified;
}
