/* A text as a case that is run for a few steps: no crash, no endless step, no verdict of what was never reached. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/small_case.h"

static const char steps[] = "40";

/* 1 once the run has used more than its share of looks: the fuzzer's own limit of time is for what hangs in one. */
static int few_looks(void *user, const hawser_sample *sample, double wall_s, double end_s)
{
    (void)wall_s;
    (void)end_s;
    FUZZ_MUST(!isnan(sample->t));
    return ++*(int *)user > 100;
}

FUZZ_TARGET(run)
{
    hawser_case *c = small_case_parse(data, size);
    if (!c) return 0;
    hawser_error err = {0};
    hawser_sim *sim = NULL;
    hawser_status status = hawser_case_set(c, "solver.max_steps", steps, &err);
    if (!status) status = hawser_case_set(c, "solver.relax_iterations", "30", &err);
    if (!status) status = hawser_sim_new(c, &(hawser_options){.threads = 1}, &sim, &err);
    hawser_case_free(c);
    if (status) {
        FUZZ_MUST(!sim && fuzz_error_is_good((int)status, err.message));
        return 0;
    }
    int looks = 0;
    status = hawser_sim_run(sim, NULL, few_looks, &looks, &err);
    FUZZ_MUST(status == HAWSER_OK || status == HAWSER_STOPPED || fuzz_error_is_good((int)status, err.message));

    hawser_summary summary;
    hawser_limit limit[HAWSER_LIMITS_MAX];
    char verdict[HAWSER_MESSAGE_MAX], *json = NULL;
    hawser_sim_summary(sim, &summary);
    const int limits = hawser_sim_limits(sim, limit);
    hawser_verdict(summary.n_conditions, summary.conditions, limits, limit, verdict, sizeof verdict);
    FUZZ_MUST(status == HAWSER_OK || strncmp(verdict, "SAFE", 4) != 0);
    FUZZ_MUST(hawser_sim_summary_json(sim, &json, &err) == HAWSER_OK && json && *json);
    hawser_text_free(json);
    hawser_sim_free(sim);
    return 0;
}
