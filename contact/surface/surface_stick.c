#include "contact/surface/surface_stick.h"

#include <stdlib.h>
#include <string.h>

#include "core/chain.h"

enum { ARRAYS = 3 * SURFACE_POINTS };

int surface_stick_alloc(SurfaceStick *stick, int n, int n_surfaces, const int *sticks)
{
    memset(stick, 0, sizeof *stick);
    stick->bed = calloc((size_t)(n_surfaces * SURFACE_FACES_MAX) + 1, sizeof *stick->bed);
    if (!stick->bed) return 0;
    stick->n_beds = n_surfaces * SURFACE_FACES_MAX;
    for (int b = 0; b < stick->n_beds; ++b) {
        SurfaceBed *const bed = &stick->bed[b];
        if (!sticks[b / SURFACE_FACES_MAX]) continue;
        if (!chain_arrays_new(&bed->lean[0][0], ARRAYS, n, 0) || !chain_arrays_new(&bed->fresh[0][0], ARRAYS, n, 0)) {
            return 0;
        }
    }
    return 1;
}

void surface_stick_free(SurfaceStick *stick)
{
    for (int b = 0; b < stick->n_beds; ++b) {
        chain_arrays_free(&stick->bed[b].lean[0][0], ARRAYS);
        chain_arrays_free(&stick->bed[b].fresh[0][0], ARRAYS);
    }
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
