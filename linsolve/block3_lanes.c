/* The kernels of block_factor.h for blocks of 3 x 3 (planar scenes): a column fits four doubles. */
#define BLOCK_B       3
#define BLOCK_W       4
#define BLOCK_NAME    block3_kernels
#define PART3_generic 2
#define PART3_avx2    4
#define PART3_avx512  4
#define BLOCK_PART    ISA_NAME(PART3)
#include "linsolve/block_lanes.h"
