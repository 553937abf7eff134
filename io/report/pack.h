/* States in few bytes: docs/report.md, "States". A value becomes a whole number of steps; of these the differences along
 * the chain, and of those the differences to the frame before; their bytes by place, deflated, as base64. */
#ifndef HAWSER_IO_REPORT_PACK_H
#define HAWSER_IO_REPORT_PACK_H

#include "hawser/hawser.h"
#include "io/report/text.h"

#include <stdint.h>

/* value[frames][items][components] into q of the same shape: the nearest multiple of `step`, within +-(2^31 - 1). What is
 * not finite is 0. */
void pack_quantize(int frames, int items, int components, double step, const float *value, int32_t *q);
/* The bytes that are deflated: 4 for each value, all lowest bytes first. Differences wrap around at 32 bits. */
void pack_planes(int frames, int items, int components, const int32_t *q, unsigned char *planes);
/* All of it: a zlib stream (RFC 1950) as base64 without quotes behind `out`. Errors: MEMORY. */
hawser_status pack_field(int frames, int items, int components, double step, const float *value, Text *out,
                         hawser_error *err);

#endif
