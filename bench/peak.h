/* The dense peak that the block LU is held against: C -= A B on 6 x 6 blocks in registers and first-level cache. */
#ifndef HAWSER_BENCH_PEAK_H
#define HAWSER_BENCH_PEAK_H

/* `rounds` products over a handful of blocks, 432 floating-point operations each; work is [PEAK_DOUBLES], 64-byte
 * aligned. */
enum { PEAK_DOUBLES = 16 * 48 + 8 };
void peak_generic(long rounds, double *work);
void peak_avx2(long rounds, double *work);
void peak_avx512(long rounds, double *work);

#endif
