#include "tests/fuzz/patches.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <string.h>

uint32_t draws_take(Draws *d, int bytes)
{
    uint32_t value = 0;
    for (int k = 0; k < bytes && d->left > 0; ++k, ++d->at, --d->left) value |= (uint32_t)*d->at << 8 * k;
    return value;
}

static void patch_real(Draws *d, unsigned char *at)
{
    static const double edges[] = {0,        -0.0,     1,         -1,  1e-300, 1e9, -1e9, 1e300,
                                   -DBL_MAX, INFINITY, -INFINITY, NAN, 1e-9,   0.5, 2,    1e5};
    const uint32_t what = draws_take(d, 1);
    double x;
    memcpy(&x, at, sizeof x);
    if (what < 64)
        x = edges[what % 16];
    else if (what < 128)
        x *= edges[what % 16];
    else if (what < 192)
        x += (what % 2 ? -1 : 1) * pow(10, -(double)(what % 16));
    else
        x = (double)(int32_t)draws_take(d, 4);
    memcpy(at, &x, sizeof x);
}

static void patch_whole(Draws *d, unsigned char *at)
{
    static const int edges[] = {0, 1, -1, 2, 7, 13, 100, -100, 65536, INT_MAX, INT_MIN, INT_MAX - 1, 3, 4, 5, 6};
    const uint32_t what = draws_take(d, 1);
    int32_t x;
    memcpy(&x, at, sizeof x);
    if (what < 64)
        x = edges[what % 16];
    else if (what < 128)
        x = (int32_t)((uint32_t)x + (what % 2 ? 1u : UINT32_MAX) * (1 + what % 16 / 2));
    else if (what < 192)
        x = (int32_t)((uint32_t)x ^ 1u << what % 32);
    else
        x = (int32_t)draws_take(d, 4);
    memcpy(at, &x, sizeof x);
}

void patch_number(Draws *d, unsigned char *bytes, size_t size, size_t at)
{
    const int real = draws_take(d, 1) & 1;
    const size_t width = real ? sizeof(double) : sizeof(int32_t);
    at -= at % width;
    if (at + width > size) return;
    if (real) patch_real(d, bytes + at);
    if (!real) patch_whole(d, bytes + at);
}
