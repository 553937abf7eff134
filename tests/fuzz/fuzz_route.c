/* Files of routes: any bytes as a file, read by whichever reader takes them. */
#define _GNU_SOURCE /* memfd_create */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

#include "survey/read/read.h"
#include "tests/fuzz/fuzz.h"

/* What was read can be measured and asked for places; numbers may be huge, but not none. */
static void look_at(const Alignment *a)
{
    const AlignmentMeasure m = alignment_measure(a);
    for (int i = 0; i < a->n_plan; ++i) FUZZ_MUST(a->plan[i].length > 0);
    for (int i = 0; i < a->n_profile; ++i) FUZZ_MUST(a->profile[i].length > 0);
    FUZZ_MUST(!isnan(m.plan_length) && m.pieces >= 0);
    alignment_at(a, 0.3 * m.plan_length);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const SurveyOptions options = {.unit = NAN};
    char path[64];
    Survey survey;
    hawser_error err;
    const int fd = memfd_create("route", 0);
    FUZZ_MUST(fd >= 0 && write(fd, data, size) == (ssize_t)size);
    snprintf(path, sizeof path, "/proc/self/fd/%d", fd);
    const hawser_status status = survey_read(path, &options, &survey, &err);
    if (status) FUZZ_MUST(fuzz_error_is_good(status, err.message));
    for (int i = 0; !status && i < survey.n; ++i) look_at(&survey.alignment[i]);
    if (!status) survey_clear(&survey);
    close(fd);
    return 0;
}
