#include "sim/watch/borne.h"

#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"

static const double NEW = 1e-2; /* share of the largest load so far, above which another look is worth it */

hawser_status borne_new(Borne *borne, int rollers, hawser_error *err)
{
    const size_t n = (size_t)rollers;
    *borne = (Borne){.n = rollers,
                     .load = calloc(n + 1, sizeof *borne->load),
                     .before = malloc((n + 1) * sizeof *borne->before),
                     .now = malloc((n + 1) * sizeof *borne->now),
                     .steady_error = calloc(n + 1, sizeof *borne->steady_error),
                     .peak_error = calloc(n + 1, sizeof *borne->peak_error)};
    if (!borne->load || !borne->before || !borne->now || !borne->steady_error || !borne->peak_error)
        return error_memory(err);
    for (size_t r = 0; r < n; ++r) borne->before[r] = borne->now[r] = NAN;
    return HAWSER_OK;
}

void borne_free(Borne *borne)
{
    free(borne->load);
    free(borne->before);
    free(borne->now);
    free(borne->steady_error);
    free(borne->peak_error);
    *borne = (Borne){0};
}

/* N, (SC18). */
static double borne_now(int chains, const Vec3 *const on_roller[], int r)
{
    Vec3 sum = V3_ZERO;
    for (int k = 0; k < chains; ++k) sum = v3_add(sum, on_roller[k][r]);
    return v3_norm(sum);
}

void borne_row(Borne *borne, int chains, const Vec3 *const on_roller[], double dt, int steady, int block)
{
    for (int r = 0; r < borne->n; ++r) {
        TimeMean *const load = &borne->load[r];
        mean_add(load, borne_now(chains, on_roller, r), dt, steady);
        if (block) mean_block(load);
    }
}

int borne_step(Borne *borne, int chains, const Vec3 *const on_roller[])
{
    double *const before = borne->now;
    int due = 0;
    borne->now = borne->before;
    borne->before = before;
    for (int r = 0; r < borne->n; ++r) {
        const TimeMean *const load = &borne->load[r];
        borne->now[r] = borne_now(chains, on_roller, r);
        due |= load->started && borne->now[r] <= before[r] && borne->now[r] > (1 + NEW) * load->peak;
    }
    return due;
}

void borne_peak(Borne *borne, int chains, const Vec3 *const on_roller[])
{
    for (int r = 0; r < borne->n; ++r) {
        borne->now[r] = borne_now(chains, on_roller, r);
        if (!isnan(borne->before[r])) mean_held(&borne->load[r], borne->before[r], borne->now[r]);
    }
}

void borne_checkpoint(Checkpoint *c, Borne *borne)
{
    const size_t n = (size_t)borne->n;
    checkpoint_put(c, "borne->load", borne->load, n * sizeof *borne->load);
    checkpoint_put(c, "borne->before", borne->before, n * sizeof *borne->before);
    checkpoint_put(c, "borne->now", borne->now, n * sizeof *borne->now);
}
