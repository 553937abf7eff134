#include "io/report/report.h"

#include "core/base/error.h"

#include <math.h>
#include <stdlib.h>
#include <zlib.h>

void pack_quantize(int frames, int items, int components, double step, const float *value, int32_t *q)
{
    const size_t n = (size_t)frames * (size_t)items * (size_t)components;
    for (size_t k = 0; k < n; k++) {
        const double steps = round((double)value[k] / step);
        q[k] = !isfinite(steps) ? 0 : steps > INT32_MAX ? INT32_MAX : steps < -INT32_MAX ? -INT32_MAX : (int32_t)steps;
    }
}

/* Small numbers of either sign become small numbers: 0, -1, 1, -2 ... are 0, 1, 2, 3 ... */
static uint32_t zigzag(uint32_t d) { return d << 1 ^ (0U - (d >> 31)); }

void pack_planes(int frames, int items, int components, const int32_t *q, unsigned char *planes)
{
    const size_t row = (size_t)items * (size_t)components, n = (size_t)frames * row, c = (size_t)components;
    for (size_t k = 0; k < n; k++) {
        const size_t in_row = k % row;
        const uint32_t behind = in_row < c ? 0 : (uint32_t)q[k - c];
        const uint32_t before = k < row ? 0 : (uint32_t)q[k - row];
        const uint32_t behind_before = in_row < c || k < row ? 0 : (uint32_t)q[k - row - c];
        const uint32_t z = zigzag(((uint32_t)q[k] - behind) - (before - behind_before));
        for (size_t b = 0; b < 4; b++) planes[b * n + k] = (unsigned char)(z >> (8 * b));
    }
}

enum { LEVEL = 6 }; /* of zlib: 9 takes three times as long for 0.2 % */

hawser_status pack_field(int frames, int items, int components, double step, const float *value, Text *out,
                         hawser_error *err)
{
    const size_t n = (size_t)frames * (size_t)items * (size_t)components;
    uLongf size = compressBound((uLong)(4 * n));
    int32_t *const q = calloc(n + 1, sizeof *q);
    unsigned char *const planes = malloc(4 * n + 1), *const stream = malloc(size);
    int ok = q && planes && stream;
    if (ok) {
        pack_quantize(frames, items, components, step, value, q);
        pack_planes(frames, items, components, q, planes);
        ok = compress2(stream, &size, planes, (uLong)(4 * n), LEVEL) == Z_OK;
    }
    if (ok) text_base64(out, stream, size);
    free(q);
    free(planes);
    free(stream);
    return ok && !out->failed ? HAWSER_OK : error_memory(err);
}
