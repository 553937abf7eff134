/* The kernels of block_factor.h for blocks of 6 x 6, in the widest vectors of each instruction set. */
#define BLOCK_B       6
#define BLOCK_W       8
#define BLOCK_NAME    block6_kernels
#define PART6_generic 2
#define PART6_avx2    4
#define PART6_avx512  8
#define BLOCK_PART    ISA_NAME(PART6)
#include "linsolve/block_lanes.h"
