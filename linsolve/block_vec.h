/* One column of a small block as a vector: BLOCK_PARTS parts of BLOCK_PART doubles, the machine's own width, padded
 * with zeros behind BLOCK_B. For block_lanes.h only. */
#ifndef HAWSER_LINSOLVE_BLOCK_VEC_H
#define HAWSER_LINSOLVE_BLOCK_VEC_H

#include <stdint.h>
#include <string.h>

#include "core/machine.h"

enum { B = BLOCK_B, PART = BLOCK_PART, PARTS = (B + PART - 1) / PART };

typedef double Part __attribute__((vector_size(BLOCK_PART * sizeof(double))));
typedef int64_t PartMask __attribute__((vector_size(BLOCK_PART * sizeof(double))));
typedef float SinglePart __attribute__((vector_size(BLOCK_PART * sizeof(float))));

typedef struct Vec {
    Part p[PARTS];
} Vec;

#define VEC_INLINE static inline __attribute__((always_inline, unused))
/* Put before a loop of fixed length: unrolls all of it, so that arrays of Vec are kept in registers. */
#define UNROLL _Pragma("GCC unroll 8")

/* All places of a part get its place k. */
#define SPLAT_2(v, k) __builtin_shufflevector(v, v, k, k)
#define SPLAT_4(v, k) __builtin_shufflevector(v, v, k, k, k, k)
#define SPLAT_8(v, k) __builtin_shufflevector(v, v, k, k, k, k, k, k, k, k)
#define PART_SPLAT    ISA_JOIN(SPLAT, BLOCK_PART)
/* The last places of a part moved to its front. */
#define FRONT_2(v, by) __builtin_shufflevector(v, v, by, 1)
#define FRONT_4(v, by) __builtin_shufflevector(v, v, by, by + 1, by + 2, 3)
#define FRONT_8(v, by) __builtin_shufflevector(v, v, by, by + 1, by + 2, by + 3, by + 4, by + 5, 6, 7)
#define PART_FRONT     ISA_JOIN(FRONT, BLOCK_PART)

VEC_INLINE Vec vec_load(const double *p)
{
    Vec v;
    UNROLL for (int i = 0; i < PARTS; ++i) memcpy(&v.p[i], p + i * PART, sizeof(Part));
    return v;
}

VEC_INLINE void vec_store(double *p, Vec v)
{
    UNROLL for (int i = 0; i < PARTS; ++i) memcpy(p + i * PART, &v.p[i], sizeof(Part));
}

/* Loads numbers in single precision; they are processed in double. */
VEC_INLINE Vec vec_load_single(const float *p)
{
    Vec v;
    UNROLL for (int i = 0; i < PARTS; ++i)
    {
        SinglePart part;
        memcpy(&part, p + i * PART, sizeof part);
        v.p[i] = __builtin_convertvector(part, Part);
    }
    return v;
}

/* The first B places only, zeros behind them. */
VEC_INLINE Vec vec_load_short(const double *p)
{
    Vec v = {{{0}}};
    UNROLL for (int i = 0; i < PARTS; ++i)
    {
        const int left = B - i * PART;
        memcpy(&v.p[i], p + i * PART, (size_t)(left < PART ? left : PART) * sizeof(double));
    }
    return v;
}

/* The same, without reading behind the first B places; it reads before them instead. */
VEC_INLINE Vec vec_load_ending(const double *p)
{
    enum { SHORT = PARTS * PART - B };
    Vec v;
    UNROLL for (int i = 0; i + 1 < PARTS; ++i) memcpy(&v.p[i], p + i * PART, sizeof(Part));
    Part last;
    memcpy(&last, p + B - PART, sizeof last);
    v.p[PARTS - 1] = PART_FRONT(last, SHORT);
    return v;
}

VEC_INLINE Vec vec_zero(void) { return (Vec){{{0}}}; }

VEC_INLINE Vec vec_and(Vec a, Vec mask)
{
    UNROLL for (int i = 0; i < PARTS; ++i) a.p[i] = (Part)((PartMask)a.p[i] & (PartMask)mask.p[i]);
    return a;
}

VEC_INLINE Vec vec_or(Vec a, Vec b)
{
    UNROLL for (int i = 0; i < PARTS; ++i) a.p[i] = (Part)((PartMask)a.p[i] | (PartMask)b.p[i]);
    return a;
}

VEC_INLINE Vec vec_abs(Vec a)
{
    UNROLL for (int i = 0; i < PARTS; ++i) a.p[i] = (Part)((PartMask)a.p[i] & INT64_MAX);
    return a;
}

VEC_INLINE Vec vec_add(Vec a, Vec b)
{
    UNROLL for (int i = 0; i < PARTS; ++i) a.p[i] += b.p[i];
    return a;
}

VEC_INLINE Vec vec_sub(Vec a, Vec b)
{
    UNROLL for (int i = 0; i < PARTS; ++i) a.p[i] -= b.p[i];
    return a;
}

VEC_INLINE Vec vec_mul(Vec a, Vec b)
{
    UNROLL for (int i = 0; i < PARTS; ++i) a.p[i] *= b.p[i];
    return a;
}

VEC_INLINE Vec vec_div(Vec a, Vec b)
{
    UNROLL for (int i = 0; i < PARTS; ++i) a.p[i] /= b.p[i];
    return a;
}

/* a times one number in all places; added to t, or subtracted. */
VEC_INLINE Vec vec_scale(Vec a, Part s)
{
    UNROLL for (int i = 0; i < PARTS; ++i) a.p[i] *= s;
    return a;
}

VEC_INLINE Vec vec_plus(Vec t, Vec a, Part s)
{
    UNROLL for (int i = 0; i < PARTS; ++i) t.p[i] += a.p[i] * s;
    return t;
}

VEC_INLINE Vec vec_minus(Vec t, Vec a, Part s)
{
    UNROLL for (int i = 0; i < PARTS; ++i) t.p[i] -= a.p[i] * s;
    return t;
}

/* s in all places. */
VEC_INLINE Vec vec_fill(Part s)
{
    Vec v;
    UNROLL for (int i = 0; i < PARTS; ++i) v.p[i] = s;
    return v;
}

VEC_INLINE Vec vec_set(double s) { return vec_fill(s - (Part){0}); }

/* t - a s with a number from memory. */
VEC_INLINE Vec vec_minus_number(Vec t, Vec a, double s)
{
    UNROLL for (int i = 0; i < PARTS; ++i) t.p[i] -= a.p[i] * s;
    return t;
}

/* All places get v's place k, which is a constant after unrolling. */
VEC_INLINE Part vec_splat(Vec v, int k)
{
    const Part part = v.p[k / PART];
    switch (k % PART) {
    case 0:
        return PART_SPLAT(part, 0);
    case 1:
        return PART_SPLAT(part, 1 % BLOCK_PART);
    case 2:
        return PART_SPLAT(part, 2 % BLOCK_PART);
    case 3:
        return PART_SPLAT(part, 3 % BLOCK_PART);
    case 4:
        return PART_SPLAT(part, 4 % BLOCK_PART);
    default:
        return PART_SPLAT(part, 5 % BLOCK_PART);
    }
}

/* All bits set in the places from <= place < to. */
VEC_INLINE Vec vec_places(int from, int to)
{
    Vec v;
    UNROLL for (int i = 0; i < PARTS; ++i)
    {
        PartMask m;
        UNROLL for (int k = 0; k < PART; ++k) m[k] = -(i * PART + k >= from && i * PART + k < to);
        v.p[i] = (Part)m;
    }
    return v;
}

/* The first B places only. */
VEC_INLINE void vec_store_short(double *p, Vec v)
{
    UNROLL for (int i = 0; i < PARTS; ++i)
    {
        const int left = B - i * PART;
        memcpy(p + i * PART, &v.p[i], (size_t)(left < PART ? left : PART) * sizeof(double));
    }
}

/* The sum of the first B places. */
VEC_INLINE double vec_sum(Vec v)
{
    double sum = v.p[0][0];
    UNROLL for (int k = 1; k < B; ++k) sum += v.p[k / PART][k % PART];
    return sum;
}

/* The largest of the first B places; NaNs are ignored. */
VEC_INLINE double vec_max(Vec v)
{
    double most = v.p[0][0];
    UNROLL for (int k = 1; k < B; ++k) most = v.p[k / PART][k % PART] > most ? v.p[k / PART][k % PART] : most;
    return most;
}

#endif
