#define BLOCK_B       6
#define PART6_generic 2
#define PART6_avx2    4
#define PART6_avx512  8
#define BLOCK_PART    ISA_NAME(PART6)
#include "bench/peak.h"
#include "linsolve/block_vec.h"

/* Columns of 8, so that every load is aligned. */
enum { CELL = 48 };

static __attribute__((noinline)) void product(const double *a, const double *b, double *c)
{
    Vec s[B];
    UNROLL for (int j = 0; j < B; ++j) s[j] = vec_load(c + 8 * j);
    UNROLL for (int k = 0; k < B; ++k)
    {
        const Vec column = vec_load(a + 8 * k);
        UNROLL for (int j = 0; j < B; ++j) s[j] = vec_minus_number(s[j], column, b[8 * j + k]);
    }
    UNROLL for (int j = 0; j < B; ++j) vec_store(c + 8 * j, s[j]);
}

void ISA_NAME(peak)(long rounds, double *work)
{
    for (long k = 0; k < rounds; ++k) {
        product(work + CELL * (k % 4), work + CELL * (4 + k % 3), work + CELL * (8 + k % 8));
    }
}
