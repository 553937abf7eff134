#include "contact/surface/surface.h"

#include <stdlib.h>
#include <string.h>

#include "core/chain.h"

enum { ARRAYS = 3 * SURFACE_POINTS };

int surface_pairs_sticks(SurfacePairs *pairs, const SurfaceModel *model, int n)
{
    SurfaceStick *const stick = &pairs->stick;
    *stick = (SurfaceStick){.bed = calloc((size_t)(model->n_surfaces * SURFACE_FACES_MAX) + 1, sizeof *stick->bed)};
    if (!stick->bed) return 0;
    stick->n_beds = model->n_surfaces * SURFACE_FACES_MAX;
    for (int b = 0; b < stick->n_beds; ++b) {
        SurfaceBed *const bed = &stick->bed[b];
        if (friction_kind(&model->friction[b / SURFACE_FACES_MAX]) != FRICTION_STICK) continue;
        if (!chain_struct_alloc(bed, n)) return 0;
    }
    return 1;
}

void surface_stick_free(SurfaceStick *stick)
{
    for (int b = 0; b < stick->n_beds; ++b) chain_struct_free(&stick->bed[b]);
    free(stick->bed);
    memset(stick, 0, sizeof *stick);
}

void surface_stick_begin(SurfaceStick *stick, int from, int to)
{
    for (int b = 0; b < stick->n_beds; ++b) {
        double *const *const array = &stick->bed[b].fresh[0][0];
        for (int k = 0; k < ARRAYS && array[0]; ++k) memset(array[k] + from, 0, (size_t)(to - from) * sizeof(double));
    }
}

void surface_stick_accept(SurfaceStick *stick, double t)
{
    for (int b = 0; b < stick->n_beds; ++b) {
        SurfaceBed *const bed = &stick->bed[b];
        double *old[SURFACE_POINTS][3];
        memcpy(old, bed->lean, sizeof old);
        memcpy(bed->lean, bed->fresh, sizeof old);
        memcpy(bed->fresh, old, sizeof old);
    }
    stick->since = t;
    stick->elapsed = 0;
}

void surface_pairs_checkpoint(Checkpoint *c, SurfacePairs *pairs, int patches, int n)
{
    SurfaceStick *const stick = &pairs->stick;
    checkpoint_list(c, "pairs->range", (void **)&pairs->range, &pairs->n_ranges, &pairs->ranges_allocated,
                    sizeof *pairs->range);
    for (int i = 0; !c->status && i < pairs->n_ranges; ++i) {
        const SurfaceRange *const r = &pairs->range[i];
        const int ok = r->patch >= 0 && r->patch < patches && r->first >= pairs->from && r->count >= 0 &&
                       r->first <= pairs->to - r->count;
        checkpoint_check(c, ok, "candidates for contact with surfaces are impossible");
    }
    CHECKPOINT(c, pairs->candidates);
    CHECKPOINT(c, pairs->active);
    CHECKPOINT(c, pairs->work);
    CHECKPOINT_UP_TO(c, stick, SurfaceStick, n_beds);
    for (int b = 0; b < stick->n_beds; ++b) {
        double *const *const array = &stick->bed[b].lean[0][0];
        if (array[0]) chain_arrays_checkpoint(c, "bed->lean", array, ARRAYS, n);
    }
}
